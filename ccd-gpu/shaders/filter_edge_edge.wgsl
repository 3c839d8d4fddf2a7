struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_12 {
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

struct type_14 {
    member: type_12,
}

struct type_18 {
    member: array<type_6>,
}

struct type_22 {
    member: array<u32>,
}

struct type_24 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_27 {
    member: array<type_24>,
}

struct type_36 {
    member: u32,
    member_1: u32,
}

struct type_45 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_48 {
    member: array<type_45>,
}

struct type_53 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_71 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_79 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_14;
@group(0) @binding(1) 
var<storage> nodes: type_18;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_6, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(2) 
var<storage> leaves: type_27;
@group(0) @binding(3) 
var<storage> bodies: type_22;
@group(0) @binding(4) 
var<storage> keys: type_53;
@group(0) @binding(5) 
var<storage> paths: type_48;
@group(0) @binding(6) 
var<storage> input: type_22;
@group(0) @binding(7) 
var<storage, read_write> output: type_79;

fn function_() {
    var local: array<array<f32, 3>, 4>;
    var local_1: array<array<f32, 3>, 4>;
    var local_2: array<array<f32, 3>, 4>;
    var local_3: array<array<f32, 3>, 4>;
    var local_4: array<type_71, 2>;
    var local_5: array<array<f32, 3>, 4>;
    var local_6: array<array<f32, 3>, 4>;
    var local_7: type_71;
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
    var local_24: type_24;
    var local_25: type_24;
    var local_26: type_24;
    var local_27: type_24;
    var phi_233_: u32;
    var phi_271_: u32;
    var phi_272_: u32;
    var phi_279_: u32;
    var phi_295_: u32;
    var phi_316_: u32;
    var phi_317_: u32;
    var phi_320_: type_36;
    var phi_321_: type_36;
    var phi_344_: type_36;
    var phi_382_: u32;
    var phi_383_: u32;
    var phi_390_: u32;
    var phi_400_: u32;
    var phi_479_: array<u32, 2>;
    var phi_673_: bool;
    var phi_674_: bool;
    var phi_678_: type_6;
    var phi_691_: type_36;
    var phi_694_: u32;
    var phi_692_: type_36;
    var phi_717_: type_36;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_789_: bool;
    var phi_807_: u32;
    var phi_808_: u32;
    var phi_809_: u32;
    var phi_695_: u32;
    var phi_812_: type_36;
    var phi_815_: u32;
    var phi_813_: type_36;
    var phi_838_: type_36;
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
    var phi_1109_: type_36;
    var phi_1112_: bool;
    var phi_1110_: type_36;
    var phi_1135_: type_36;
    var phi_1192_: type_36;
    var phi_1195_: array<u32, 2>;
    var phi_1193_: type_36;
    var phi_1218_: type_36;
    var phi_1293_: bool;
    var phi_1294_: bool;
    var phi_1298_: array<u32, 2>;
    var phi_1196_: array<u32, 2>;
    var phi_1349_: type_36;
    var phi_1352_: array<u32, 2>;
    var phi_1350_: type_36;
    var phi_1375_: type_36;
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
    var phi_1524_: type_36;
    var phi_1527_: array<u32, 2>;
    var phi_1525_: type_36;
    var phi_1550_: type_36;
    var phi_1625_: bool;
    var phi_1626_: bool;
    var phi_1630_: array<u32, 2>;
    var phi_1528_: array<u32, 2>;
    var phi_1681_: type_36;
    var phi_1684_: array<u32, 2>;
    var phi_1682_: type_36;
    var phi_1707_: type_36;
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
    var phi_1843_: type_36;
    var phi_1888_: u32;
    var phi_1889_: bool;
    var phi_816_: u32;
    var phi_1890_: bool;
    var phi_1897_: u32;
    var phi_1900_: type_36;
    var phi_1901_: type_36;
    var phi_1924_: type_36;
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
    var phi_2203_: type_36;
    var phi_2206_: bool;
    var phi_2204_: type_36;
    var phi_2229_: type_36;
    var phi_2286_: type_36;
    var phi_2289_: array<u32, 2>;
    var phi_2287_: type_36;
    var phi_2312_: type_36;
    var phi_2387_: bool;
    var phi_2388_: bool;
    var phi_2392_: array<u32, 2>;
    var phi_2290_: array<u32, 2>;
    var phi_2443_: type_36;
    var phi_2446_: array<u32, 2>;
    var phi_2444_: type_36;
    var phi_2469_: type_36;
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
    var phi_2618_: type_36;
    var phi_2621_: array<u32, 2>;
    var phi_2619_: type_36;
    var phi_2644_: type_36;
    var phi_2719_: bool;
    var phi_2720_: bool;
    var phi_2724_: array<u32, 2>;
    var phi_2622_: array<u32, 2>;
    var phi_2775_: type_36;
    var phi_2778_: array<u32, 2>;
    var phi_2776_: type_36;
    var phi_2801_: type_36;
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
    var phi_2963_: type_24;
    var phi_2964_: type_24;
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
    var phi_4265_: type_36;
    var phi_4268_: f32;
    var phi_4270_: f32;
    var phi_4266_: type_36;
    var phi_4293_: type_36;
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
    var phi_4418_: type_36;
    var phi_4421_: f32;
    var phi_4423_: f32;
    var phi_4419_: type_36;
    var phi_4446_: type_36;
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
    var phi_6087_: type_36;
    var phi_6090_: f32;
    var phi_6092_: f32;
    var phi_6088_: type_36;
    var phi_6115_: type_36;
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
    var phi_6240_: type_36;
    var phi_6243_: f32;
    var phi_6245_: f32;
    var phi_6241_: type_36;
    var phi_6268_: type_36;
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
    var phi_7698_: type_36;
    var phi_7701_: f32;
    var phi_7703_: f32;
    var phi_7699_: type_36;
    var phi_7726_: type_36;
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
    var phi_7851_: type_36;
    var phi_7854_: f32;
    var phi_7856_: f32;
    var phi_7852_: type_36;
    var phi_7879_: type_36;
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
    var phi_8215_: type_36;
    var phi_8216_: type_36;
    var phi_8239_: type_36;
    var phi_8262_: u32;
    var phi_8316_: type_36;
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

    let _e108 = id_1;
    let _e109 = n_1;
    let _e110 = lane_1;
    let _e123 = ((_e108.y * _e109.x) + _e108.x);
    let _e126 = (_e109.x * _e109.y);
    let _e128 = params.member.member_15;
    let _e130 = input.member[0u];
    if (_e128 < _e130) {
        phi_233_ = _e128;
    } else {
        phi_233_ = _e130;
    }
    let _e133 = phi_233_;
    let _e134 = (_e110 / 32u);
    let _e135 = (_e110 % 32u);
    let _e137 = params.member.member_12;
    if (_e133 > _e137) {
        let _e140 = params.member.member_12;
        let _e141 = (_e133 - _e140);
        let _e143 = params.member.member_13;
        if (_e143 == 0u) {
            return;
        }
        let _e145 = (_e141 / _e143);
        if (_e143 == 0u) {
            return;
        }
        if ((_e141 % _e143) > 0u) {
            phi_271_ = (_e145 + 1u);
        } else {
            phi_271_ = _e145;
        }
        let _e151 = phi_271_;
        phi_272_ = _e151;
    } else {
        phi_272_ = 0u;
    }
    let _e153 = phi_272_;
    let _e155 = params.member.member_14;
    if (_e155 < _e153) {
        phi_279_ = _e155;
    } else {
        phi_279_ = _e153;
    }
    let _e158 = phi_279_;
    let _e159 = (_e158 / 4u);
    if ((_e158 % 4u) > 0u) {
        phi_295_ = (_e159 + 1u);
    } else {
        phi_295_ = _e159;
    }
    let _e164 = phi_295_;
    if (_e164 > _e123) {
        let _e166 = (_e164 - _e123);
        if (_e126 == 0u) {
            return;
        }
        let _e168 = (_e166 / _e126);
        if (_e126 == 0u) {
            return;
        }
        if ((_e166 % _e126) > 0u) {
            phi_316_ = (_e168 + 1u);
        } else {
            phi_316_ = _e168;
        }
        let _e174 = phi_316_;
        phi_317_ = _e174;
    } else {
        phi_317_ = 0u;
    }
    let _e176 = phi_317_;
    phi_320_ = type_36(0u, _e176);
    loop {
        let _e179 = phi_320_;
        if (_e179.member < _e179.member_1) {
            phi_321_ = type_36((_e179.member + 1u), _e179.member_1);
            phi_344_ = type_36(1u, _e179.member);
        } else {
            phi_321_ = _e179;
            phi_344_ = type_36(0u, type_36().member_1);
        }
        let _e193 = phi_321_;
        let _e195 = phi_344_;
        let _e199 = (bitcast<i32>(_e195.member) != 0i);
        if _e199 {
            let _e203 = (((_e123 + (_e195.member_1 * _e126)) * 4u) + _e134);
            let _e205 = params.member.member_12;
            if (_e133 > _e205) {
                let _e208 = params.member.member_12;
                let _e209 = (_e133 - _e208);
                let _e211 = params.member.member_13;
                if (_e211 == 0u) {
                    return;
                }
                let _e213 = (_e209 / _e211);
                if (_e211 == 0u) {
                    return;
                }
                if ((_e209 % _e211) > 0u) {
                    phi_382_ = (_e213 + 1u);
                } else {
                    phi_382_ = _e213;
                }
                let _e219 = phi_382_;
                phi_383_ = _e219;
            } else {
                phi_383_ = 0u;
            }
            let _e221 = phi_383_;
            let _e223 = params.member.member_14;
            if (_e223 < _e221) {
                phi_390_ = _e223;
            } else {
                phi_390_ = _e221;
            }
            let _e226 = phi_390_;
            let _e227 = (_e203 < _e226);
            let _e229 = params.member.member_12;
            if _e227 {
                let _e231 = params.member.member_13;
                phi_400_ = (_e203 * _e231);
            } else {
                phi_400_ = 0u;
            }
            let _e234 = phi_400_;
            let _e236 = (2u * (_e229 + _e234));
            let _e239 = input.member[(4u + _e236)];
            let _e242 = input.member[(_e236 + 5u)];
            if (_e110 < 8u) {
                atomicStore((&counters[_e110]), 0u);
            }
            workgroupBarrier();
            let _e249 = params.member.member_20[0u][1u];
            let _e250 = (_e249 + (_e239 * 32u));
            let _e255 = params.member.member_20[0u][1u];
            let _e256 = (_e255 + (_e242 * 32u));
            if (_e135 == 0u) {
                firsts[(2u * _e134)] = _e250;
                firsts[((2u * _e134) + 1u)] = _e256;
            }
            let _e264 = params.member.member_8;
            if (_e264 == 0u) {
                phi_479_ = array<u32, 2>(0u, 2u);
            } else {
                phi_479_ = array<u32, 2>(1u, 1u);
            }
            let _e267 = phi_479_;
            let _e270 = (_e110 / 32u);
            let _e271 = (_e110 % 32u);
            let _e273 = params.member.member_9;
            if (_e273 < 8u) {
            } else {
                return;
            }
            if (_e267[0] < 4u) {
            } else {
                return;
            }
            let _e279 = params.member.member_20[_e273][_e267[0]];
            let _e282 = nodes.member[(_e279 + _e239)];
            let _e284 = params.member.member_9;
            if (_e284 < 8u) {
            } else {
                return;
            }
            if (_e267[1] < 4u) {
            } else {
                return;
            }
            let _e290 = params.member.member_20[_e284][_e267[1]];
            let _e293 = nodes.member[(_e290 + _e242)];
            let _e295 = params.member.member_9;
            let _e296 = (_e295 - 1u);
            if (_e296 < 8u) {
            } else {
                return;
            }
            if (_e267[0] < 4u) {
            } else {
                return;
            }
            let _e304 = params.member.member_20[_e296][_e267[0]];
            let _e307 = nodes.member[(_e304 + ((_e239 * 32u) + _e271))];
            let _e309 = params.member.member_9;
            let _e310 = (_e309 - 1u);
            if (_e310 < 8u) {
            } else {
                return;
            }
            if (_e267[1] < 4u) {
            } else {
                return;
            }
            let _e318 = params.member.member_20[_e310][_e267[1]];
            let _e321 = nodes.member[(_e318 + ((_e242 * 32u) + _e271))];
            if _e227 {
                if ((((((_e321.member[0] <= _e282.member_1[0]) && (_e282.member[0] <= _e321.member_1[0])) && (_e321.member[1] <= _e282.member_1[1])) && (_e282.member[1] <= _e321.member_1[1])) && (_e321.member[2] <= _e282.member_1[2])) && (_e282.member[2] <= _e321.member_1[2])) {
                    let _e359 = atomicAdd((&counters[_e270]), 1u);
                    let _e360 = ((_e270 * 32u) + _e359);
                    columns[_e360] = type_6(array<f32, 3>(_e321.member[0], _e321.member[1], _e321.member[2]), array<f32, 3>(_e321.member_1[0], _e321.member_1[1], _e321.member_1[2]));
                    names[_e360] = _e271;
                }
            }
            workgroupBarrier();
            if _e227 {
                if ((((((_e307.member[0] <= _e293.member_1[0]) && (_e293.member[0] <= _e307.member_1[0])) && (_e307.member[1] <= _e293.member_1[1])) && (_e293.member[1] <= _e307.member_1[1])) && (_e307.member[2] <= _e293.member_1[2])) && (_e293.member[2] <= _e307.member_1[2])) {
                    phi_673_ = false;
                } else {
                    phi_673_ = true;
                }
                let _e410 = phi_673_;
                phi_674_ = _e410;
            } else {
                phi_674_ = true;
            }
            let _e412 = phi_674_;
            if _e412 {
                phi_678_ = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_678_ = _e307;
            }
            let _e414 = phi_678_;
            let _e416 = (_e110 / 32u);
            let _e417 = (_e110 % 32u);
            let _e419 = atomicLoad((&counters[_e416]));
            phi_691_ = type_36(0u, _e419);
            phi_694_ = 0u;
            loop {
                let _e422 = phi_691_;
                let _e424 = phi_694_;
                local_64 = _e424;
                if (_e422.member < _e422.member_1) {
                    phi_692_ = type_36((_e422.member + 1u), _e422.member_1);
                    phi_717_ = type_36(1u, _e422.member);
                } else {
                    phi_692_ = _e422;
                    phi_717_ = type_36(0u, type_36().member_1);
                }
                let _e438 = phi_692_;
                let _e440 = phi_717_;
                let _e444 = (bitcast<i32>(_e440.member) != 0i);
                if _e444 {
                    let _e448 = names[((_e416 * 32u) + _e440.member_1)];
                    let _e452 = columns[((_e416 * 32u) + _e440.member_1)];
                    if ((((((_e414.member[0] <= _e452.member_1[0]) && (_e452.member[0] <= _e414.member_1[0])) && (_e414.member[1] <= _e452.member_1[1])) && (_e452.member[1] <= _e414.member_1[1])) && (_e414.member[2] <= _e452.member_1[2])) && (_e452.member[2] <= _e414.member_1[2])) {
                        if (_e239 == _e242) {
                            let _e484 = (_e417 < _e448);
                            if _e484 {
                                phi_783_ = bool();
                            } else {
                                phi_783_ = false;
                            }
                            let _e486 = phi_783_;
                            phi_784_ = _e486;
                            phi_785_ = _e484;
                        } else {
                            phi_784_ = bool();
                            phi_785_ = true;
                        }
                        let _e488 = phi_784_;
                        let _e490 = phi_785_;
                        if _e490 {
                            phi_789_ = true;
                        } else {
                            phi_789_ = _e488;
                        }
                        let _e492 = phi_789_;
                        if _e492 {
                            let _e494 = atomicAdd((&counters[4u]), 1u);
                            if (_e494 < 2048u) {
                                hits[_e494] = (((_e416 << bitcast<u32>(10i)) | (_e417 << bitcast<u32>(5i))) | _e448);
                                phi_807_ = _e424;
                            } else {
                                phi_807_ = (_e424 | (1u << bitcast<u32>((_e440.member_1 & 31u))));
                            }
                            let _e508 = phi_807_;
                            phi_808_ = _e508;
                        } else {
                            phi_808_ = _e424;
                        }
                        let _e510 = phi_808_;
                        phi_809_ = _e510;
                    } else {
                        phi_809_ = _e424;
                    }
                    let _e512 = phi_809_;
                    phi_695_ = _e512;
                } else {
                    phi_695_ = u32();
                }
                let _e514 = phi_695_;
                continue;
                continuing {
                    phi_691_ = _e438;
                    phi_694_ = _e514;
                    break if !(_e444);
                }
            }
            phi_812_ = type_36(0u, 32u);
            let _e5263 = local_64;
            phi_815_ = _e5263;
            loop {
                let _e517 = phi_812_;
                let _e519 = phi_815_;
                if (_e517.member < _e517.member_1) {
                    phi_813_ = type_36((_e517.member + 1u), _e517.member_1);
                    phi_838_ = type_36(1u, _e517.member);
                } else {
                    phi_813_ = _e517;
                    phi_838_ = type_36(0u, type_36().member_1);
                }
                let _e533 = phi_813_;
                let _e535 = phi_838_;
                if (bitcast<i32>(_e535.member) != 0i) {
                    if (_e519 == 0u) {
                        phi_1888_ = u32();
                        phi_1889_ = false;
                    } else {
                        let _e546 = names[((_e134 * 32u) + select(firstTrailingBit(_e519), 32u, (_e519 == 0u)))];
                        let _e549 = (_e250 + _e135);
                        let _e550 = (_e256 + _e546);
                        let _e552 = leaves.member[_e549];
                        let _e554 = leaves.member[_e550];
                        local_24 = type_24(array<u32, 3>(_e552.member[0], _e552.member[1], _e552.member[2]), _e552.member_1);
                        local_25 = type_24(array<u32, 3>(_e554.member[0], _e554.member[1], _e554.member[2]), _e554.member_1);
                        let _e570 = nodes.member[_e549];
                        let _e572 = nodes.member[_e550];
                        let _e574 = params.member.member_1;
                        if ((_e574 & 1u) != 0u) {
                            let _e578 = params.member.member_8;
                            if (_e578 == 0u) {
                                let _e622 = local_24.member[0u];
                                let _e625 = local_25.member[0u];
                                if (_e622 == _e625) {
                                    phi_949_ = bool();
                                    phi_950_ = true;
                                } else {
                                    let _e629 = local_24.member[0u];
                                    let _e632 = local_25.member[1u];
                                    let _e633 = (_e629 == _e632);
                                    if _e633 {
                                        phi_948_ = bool();
                                    } else {
                                        let _e636 = local_24.member[0u];
                                        let _e639 = local_25.member[2u];
                                        phi_948_ = (_e636 == _e639);
                                    }
                                    let _e642 = phi_948_;
                                    phi_949_ = _e642;
                                    phi_950_ = _e633;
                                }
                                let _e644 = phi_949_;
                                let _e646 = phi_950_;
                                if _e646 {
                                    phi_954_ = true;
                                } else {
                                    phi_954_ = _e644;
                                }
                                let _e648 = phi_954_;
                                phi_993_ = _e648;
                            } else {
                                let _e582 = local_24.member[0u];
                                let _e585 = local_25.member[0u];
                                if (_e582 == _e585) {
                                    phi_987_ = bool();
                                    phi_988_ = true;
                                } else {
                                    let _e589 = local_24.member[0u];
                                    let _e592 = local_25.member[1u];
                                    if (_e589 == _e592) {
                                        phi_985_ = bool();
                                        phi_986_ = true;
                                    } else {
                                        let _e596 = local_24.member[1u];
                                        let _e599 = local_25.member[0u];
                                        let _e600 = (_e596 == _e599);
                                        if _e600 {
                                            phi_984_ = bool();
                                        } else {
                                            let _e603 = local_24.member[1u];
                                            let _e606 = local_25.member[1u];
                                            phi_984_ = (_e603 == _e606);
                                        }
                                        let _e609 = phi_984_;
                                        phi_985_ = _e609;
                                        phi_986_ = _e600;
                                    }
                                    let _e611 = phi_985_;
                                    let _e613 = phi_986_;
                                    phi_987_ = _e611;
                                    phi_988_ = _e613;
                                }
                                let _e615 = phi_987_;
                                let _e617 = phi_988_;
                                if _e617 {
                                    phi_992_ = true;
                                } else {
                                    phi_992_ = _e615;
                                }
                                let _e619 = phi_992_;
                                phi_993_ = _e619;
                            }
                            let _e650 = phi_993_;
                            if _e650 {
                                phi_997_ = false;
                            } else {
                                phi_997_ = true;
                            }
                            let _e652 = phi_997_;
                            phi_998_ = _e652;
                        } else {
                            phi_998_ = true;
                        }
                        let _e654 = phi_998_;
                        if _e654 {
                            let _e656 = params.member.member_1;
                            if ((_e656 & 2u) != 0u) {
                                let _e661 = local_24.member[0u];
                                let _e663 = bodies.member[_e661];
                                let _e666 = local_25.member[0u];
                                let _e668 = bodies.member[_e666];
                                if ((_e663 / 2u) == (_e668 / 2u)) {
                                    let _e673 = params.member.member_1;
                                    phi_1044_ = !(((_e673 & 4u) != 0u));
                                } else {
                                    phi_1044_ = false;
                                }
                                let _e678 = phi_1044_;
                                if _e678 {
                                    phi_1055_ = true;
                                } else {
                                    if (((_e663 & _e668) & 1u) == 0u) {
                                        phi_1054_ = false;
                                    } else {
                                        phi_1054_ = true;
                                    }
                                    let _e683 = phi_1054_;
                                    phi_1055_ = _e683;
                                }
                                let _e685 = phi_1055_;
                                if _e685 {
                                    phi_1059_ = false;
                                } else {
                                    phi_1059_ = true;
                                }
                                let _e687 = phi_1059_;
                                phi_1060_ = _e687;
                            } else {
                                phi_1060_ = true;
                            }
                            let _e689 = phi_1060_;
                            if _e689 {
                                let _e691 = params.member.member_1;
                                if ((_e691 & 32u) != 0u) {
                                    let _e695 = params.member.member_6;
                                    let _e736 = (((((((_e570.member_1[0] - _e572.member[0]) > _e695) && ((_e572.member_1[0] - _e570.member[0]) > _e695)) && ((_e570.member_1[1] - _e572.member[1]) > _e695)) && ((_e572.member_1[1] - _e570.member[1]) > _e695)) && ((_e570.member_1[2] - _e572.member[2]) > _e695)) && ((_e572.member_1[2] - _e570.member[2]) > _e695));
                                    if _e736 {
                                        phi_1809_ = bool();
                                    } else {
                                        phi_1109_ = type_36(0u, 3u);
                                        phi_1112_ = true;
                                        loop {
                                            let _e740 = phi_1109_;
                                            let _e742 = phi_1112_;
                                            local_65 = _e742;
                                            if (_e740.member < _e740.member_1) {
                                                phi_1110_ = type_36((_e740.member + 1u), _e740.member_1);
                                                phi_1135_ = type_36(1u, _e740.member);
                                            } else {
                                                phi_1110_ = _e740;
                                                phi_1135_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e756 = phi_1110_;
                                            let _e758 = phi_1135_;
                                            let _e762 = (bitcast<i32>(_e758.member) != 0i);
                                            if _e762 {
                                                let _e764 = local_24.member[0u];
                                                let _e766 = keys.member[_e764];
                                                local_22 = array<array<u32, 2>, 6>(array<u32, 2>(_e766[0][0], _e766[0][1]), array<u32, 2>(_e766[1][0], _e766[1][1]), array<u32, 2>(_e766[2][0], _e766[2][1]), array<u32, 2>(_e766[3][0], _e766[3][1]), array<u32, 2>(_e766[4][0], _e766[4][1]), array<u32, 2>(_e766[5][0], _e766[5][1]));
                                                if (_e758.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e794 = local_22[_e758.member_1];
                                                phi_1192_ = type_36(1u, 3u);
                                                phi_1195_ = array<u32, 2>(_e794[0], _e794[1]);
                                                loop {
                                                    let _e799 = phi_1192_;
                                                    let _e801 = phi_1195_;
                                                    local_28 = _e801;
                                                    local_30 = _e801;
                                                    local_32 = _e801;
                                                    if (_e799.member < _e799.member_1) {
                                                        phi_1193_ = type_36((_e799.member + 1u), _e799.member_1);
                                                        phi_1218_ = type_36(1u, _e799.member);
                                                    } else {
                                                        phi_1193_ = _e799;
                                                        phi_1218_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e815 = phi_1193_;
                                                    let _e817 = phi_1218_;
                                                    let _e821 = (bitcast<i32>(_e817.member) != 0i);
                                                    if _e821 {
                                                        if (_e817.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e824 = local_24.member[_e817.member_1];
                                                        let _e826 = keys.member[_e824];
                                                        local_23 = array<array<u32, 2>, 6>(array<u32, 2>(_e826[0][0], _e826[0][1]), array<u32, 2>(_e826[1][0], _e826[1][1]), array<u32, 2>(_e826[2][0], _e826[2][1]), array<u32, 2>(_e826[3][0], _e826[3][1]), array<u32, 2>(_e826[4][0], _e826[4][1]), array<u32, 2>(_e826[5][0], _e826[5][1]));
                                                        if (_e758.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e854 = local_23[_e758.member_1];
                                                        if (_e801[1] > _e854[1]) {
                                                            phi_1294_ = true;
                                                        } else {
                                                            if (_e801[1] == _e854[1]) {
                                                                phi_1293_ = (_e801[0] > _e854[0]);
                                                            } else {
                                                                phi_1293_ = false;
                                                            }
                                                            let _e865 = phi_1293_;
                                                            phi_1294_ = _e865;
                                                        }
                                                        let _e867 = phi_1294_;
                                                        if _e867 {
                                                            phi_1298_ = array<u32, 2>(_e854[0], _e854[1]);
                                                        } else {
                                                            phi_1298_ = _e801;
                                                        }
                                                        let _e869 = phi_1298_;
                                                        phi_1196_ = _e869;
                                                    } else {
                                                        phi_1196_ = array<u32, 2>();
                                                    }
                                                    let _e871 = phi_1196_;
                                                    continue;
                                                    continuing {
                                                        phi_1192_ = _e815;
                                                        phi_1195_ = _e871;
                                                        break if !(_e821);
                                                    }
                                                }
                                                let _e874 = local_25.member[0u];
                                                let _e876 = keys.member[_e874];
                                                local_20 = array<array<u32, 2>, 6>(array<u32, 2>(_e876[0][0], _e876[0][1]), array<u32, 2>(_e876[1][0], _e876[1][1]), array<u32, 2>(_e876[2][0], _e876[2][1]), array<u32, 2>(_e876[3][0], _e876[3][1]), array<u32, 2>(_e876[4][0], _e876[4][1]), array<u32, 2>(_e876[5][0], _e876[5][1]));
                                                let _e902 = (3u + _e758.member_1);
                                                if (_e902 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e905 = local_20[_e902];
                                                phi_1349_ = type_36(1u, 3u);
                                                phi_1352_ = array<u32, 2>(_e905[0], _e905[1]);
                                                loop {
                                                    let _e910 = phi_1349_;
                                                    let _e912 = phi_1352_;
                                                    local_29 = _e912;
                                                    local_31 = _e912;
                                                    local_33 = _e912;
                                                    if (_e910.member < _e910.member_1) {
                                                        phi_1350_ = type_36((_e910.member + 1u), _e910.member_1);
                                                        phi_1375_ = type_36(1u, _e910.member);
                                                    } else {
                                                        phi_1350_ = _e910;
                                                        phi_1375_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e926 = phi_1350_;
                                                    let _e928 = phi_1375_;
                                                    let _e932 = (bitcast<i32>(_e928.member) != 0i);
                                                    if _e932 {
                                                        if (_e928.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e935 = local_25.member[_e928.member_1];
                                                        let _e937 = keys.member[_e935];
                                                        local_21 = array<array<u32, 2>, 6>(array<u32, 2>(_e937[0][0], _e937[0][1]), array<u32, 2>(_e937[1][0], _e937[1][1]), array<u32, 2>(_e937[2][0], _e937[2][1]), array<u32, 2>(_e937[3][0], _e937[3][1]), array<u32, 2>(_e937[4][0], _e937[4][1]), array<u32, 2>(_e937[5][0], _e937[5][1]));
                                                        let _e963 = (3u + _e758.member_1);
                                                        if (_e963 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e966 = local_21[_e963];
                                                        if (_e966[1] > _e912[1]) {
                                                            phi_1452_ = true;
                                                        } else {
                                                            if (_e966[1] == _e912[1]) {
                                                                phi_1451_ = (_e966[0] > _e912[0]);
                                                            } else {
                                                                phi_1451_ = false;
                                                            }
                                                            let _e977 = phi_1451_;
                                                            phi_1452_ = _e977;
                                                        }
                                                        let _e979 = phi_1452_;
                                                        if _e979 {
                                                            phi_1456_ = array<u32, 2>(_e966[0], _e966[1]);
                                                        } else {
                                                            phi_1456_ = _e912;
                                                        }
                                                        let _e981 = phi_1456_;
                                                        phi_1353_ = _e981;
                                                    } else {
                                                        phi_1353_ = array<u32, 2>();
                                                    }
                                                    let _e983 = phi_1353_;
                                                    continue;
                                                    continuing {
                                                        phi_1349_ = _e926;
                                                        phi_1352_ = _e983;
                                                        break if !(_e932);
                                                    }
                                                }
                                                let _e986 = local_28;
                                                let _e989 = local_29;
                                                if (_e986[1] > _e989[1]) {
                                                    phi_1473_ = true;
                                                } else {
                                                    let _e993 = local_30;
                                                    let _e996 = local_31;
                                                    if (_e993[1] == _e996[1]) {
                                                        let _e1000 = local_32;
                                                        let _e1003 = local_33;
                                                        phi_1472_ = (_e1000[0] > _e1003[0]);
                                                    } else {
                                                        phi_1472_ = false;
                                                    }
                                                    let _e1007 = phi_1472_;
                                                    phi_1473_ = _e1007;
                                                }
                                                let _e1009 = phi_1473_;
                                                let _e1012 = local_25.member[0u];
                                                let _e1014 = keys.member[_e1012];
                                                local_18 = array<array<u32, 2>, 6>(array<u32, 2>(_e1014[0][0], _e1014[0][1]), array<u32, 2>(_e1014[1][0], _e1014[1][1]), array<u32, 2>(_e1014[2][0], _e1014[2][1]), array<u32, 2>(_e1014[3][0], _e1014[3][1]), array<u32, 2>(_e1014[4][0], _e1014[4][1]), array<u32, 2>(_e1014[5][0], _e1014[5][1]));
                                                if (_e758.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1042 = local_18[_e758.member_1];
                                                phi_1524_ = type_36(1u, 3u);
                                                phi_1527_ = array<u32, 2>(_e1042[0], _e1042[1]);
                                                loop {
                                                    let _e1047 = phi_1524_;
                                                    let _e1049 = phi_1527_;
                                                    local_34 = _e1049;
                                                    local_36 = _e1049;
                                                    local_38 = _e1049;
                                                    if (_e1047.member < _e1047.member_1) {
                                                        phi_1525_ = type_36((_e1047.member + 1u), _e1047.member_1);
                                                        phi_1550_ = type_36(1u, _e1047.member);
                                                    } else {
                                                        phi_1525_ = _e1047;
                                                        phi_1550_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1063 = phi_1525_;
                                                    let _e1065 = phi_1550_;
                                                    let _e1069 = (bitcast<i32>(_e1065.member) != 0i);
                                                    if _e1069 {
                                                        if (_e1065.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1072 = local_25.member[_e1065.member_1];
                                                        let _e1074 = keys.member[_e1072];
                                                        local_19 = array<array<u32, 2>, 6>(array<u32, 2>(_e1074[0][0], _e1074[0][1]), array<u32, 2>(_e1074[1][0], _e1074[1][1]), array<u32, 2>(_e1074[2][0], _e1074[2][1]), array<u32, 2>(_e1074[3][0], _e1074[3][1]), array<u32, 2>(_e1074[4][0], _e1074[4][1]), array<u32, 2>(_e1074[5][0], _e1074[5][1]));
                                                        if (_e758.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1102 = local_19[_e758.member_1];
                                                        if (_e1049[1] > _e1102[1]) {
                                                            phi_1626_ = true;
                                                        } else {
                                                            if (_e1049[1] == _e1102[1]) {
                                                                phi_1625_ = (_e1049[0] > _e1102[0]);
                                                            } else {
                                                                phi_1625_ = false;
                                                            }
                                                            let _e1113 = phi_1625_;
                                                            phi_1626_ = _e1113;
                                                        }
                                                        let _e1115 = phi_1626_;
                                                        if _e1115 {
                                                            phi_1630_ = array<u32, 2>(_e1102[0], _e1102[1]);
                                                        } else {
                                                            phi_1630_ = _e1049;
                                                        }
                                                        let _e1117 = phi_1630_;
                                                        phi_1528_ = _e1117;
                                                    } else {
                                                        phi_1528_ = array<u32, 2>();
                                                    }
                                                    let _e1119 = phi_1528_;
                                                    continue;
                                                    continuing {
                                                        phi_1524_ = _e1063;
                                                        phi_1527_ = _e1119;
                                                        break if !(_e1069);
                                                    }
                                                }
                                                let _e1122 = local_24.member[0u];
                                                let _e1124 = keys.member[_e1122];
                                                local_16 = array<array<u32, 2>, 6>(array<u32, 2>(_e1124[0][0], _e1124[0][1]), array<u32, 2>(_e1124[1][0], _e1124[1][1]), array<u32, 2>(_e1124[2][0], _e1124[2][1]), array<u32, 2>(_e1124[3][0], _e1124[3][1]), array<u32, 2>(_e1124[4][0], _e1124[4][1]), array<u32, 2>(_e1124[5][0], _e1124[5][1]));
                                                let _e1150 = (3u + _e758.member_1);
                                                if (_e1150 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1153 = local_16[_e1150];
                                                phi_1681_ = type_36(1u, 3u);
                                                phi_1684_ = array<u32, 2>(_e1153[0], _e1153[1]);
                                                loop {
                                                    let _e1158 = phi_1681_;
                                                    let _e1160 = phi_1684_;
                                                    local_35 = _e1160;
                                                    local_37 = _e1160;
                                                    local_39 = _e1160;
                                                    if (_e1158.member < _e1158.member_1) {
                                                        phi_1682_ = type_36((_e1158.member + 1u), _e1158.member_1);
                                                        phi_1707_ = type_36(1u, _e1158.member);
                                                    } else {
                                                        phi_1682_ = _e1158;
                                                        phi_1707_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1174 = phi_1682_;
                                                    let _e1176 = phi_1707_;
                                                    let _e1180 = (bitcast<i32>(_e1176.member) != 0i);
                                                    if _e1180 {
                                                        if (_e1176.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1183 = local_24.member[_e1176.member_1];
                                                        let _e1185 = keys.member[_e1183];
                                                        local_17 = array<array<u32, 2>, 6>(array<u32, 2>(_e1185[0][0], _e1185[0][1]), array<u32, 2>(_e1185[1][0], _e1185[1][1]), array<u32, 2>(_e1185[2][0], _e1185[2][1]), array<u32, 2>(_e1185[3][0], _e1185[3][1]), array<u32, 2>(_e1185[4][0], _e1185[4][1]), array<u32, 2>(_e1185[5][0], _e1185[5][1]));
                                                        let _e1211 = (3u + _e758.member_1);
                                                        if (_e1211 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1214 = local_17[_e1211];
                                                        if (_e1214[1] > _e1160[1]) {
                                                            phi_1784_ = true;
                                                        } else {
                                                            if (_e1214[1] == _e1160[1]) {
                                                                phi_1783_ = (_e1214[0] > _e1160[0]);
                                                            } else {
                                                                phi_1783_ = false;
                                                            }
                                                            let _e1225 = phi_1783_;
                                                            phi_1784_ = _e1225;
                                                        }
                                                        let _e1227 = phi_1784_;
                                                        if _e1227 {
                                                            phi_1788_ = array<u32, 2>(_e1214[0], _e1214[1]);
                                                        } else {
                                                            phi_1788_ = _e1160;
                                                        }
                                                        let _e1229 = phi_1788_;
                                                        phi_1685_ = _e1229;
                                                    } else {
                                                        phi_1685_ = array<u32, 2>();
                                                    }
                                                    let _e1231 = phi_1685_;
                                                    continue;
                                                    continuing {
                                                        phi_1681_ = _e1174;
                                                        phi_1684_ = _e1231;
                                                        break if !(_e1180);
                                                    }
                                                }
                                                let _e1234 = local_34;
                                                let _e1237 = local_35;
                                                if (_e1234[1] > _e1237[1]) {
                                                    phi_1805_ = true;
                                                } else {
                                                    let _e1241 = local_36;
                                                    let _e1244 = local_37;
                                                    if (_e1241[1] == _e1244[1]) {
                                                        let _e1248 = local_38;
                                                        let _e1251 = local_39;
                                                        phi_1804_ = (_e1248[0] > _e1251[0]);
                                                    } else {
                                                        phi_1804_ = false;
                                                    }
                                                    let _e1255 = phi_1804_;
                                                    phi_1805_ = _e1255;
                                                }
                                                let _e1257 = phi_1805_;
                                                phi_1113_ = (_e742 && (!(_e1009) && !(_e1257)));
                                            } else {
                                                phi_1113_ = bool();
                                            }
                                            let _e1262 = phi_1113_;
                                            continue;
                                            continuing {
                                                phi_1109_ = _e756;
                                                phi_1112_ = _e1262;
                                                break if !(_e762);
                                            }
                                        }
                                        let _e5339 = local_65;
                                        phi_1809_ = _e5339;
                                    }
                                    let _e1265 = phi_1809_;
                                    phi_1810_ = _e1265;
                                    phi_1811_ = _e736;
                                } else {
                                    phi_1810_ = bool();
                                    phi_1811_ = true;
                                }
                                let _e1267 = phi_1810_;
                                let _e1269 = phi_1811_;
                                if _e1269 {
                                    phi_1815_ = false;
                                } else {
                                    phi_1815_ = true;
                                }
                                let _e1271 = phi_1815_;
                                phi_1816_ = _e1267;
                                phi_1817_ = _e1271;
                            } else {
                                phi_1816_ = false;
                                phi_1817_ = true;
                            }
                            let _e1273 = phi_1816_;
                            let _e1275 = phi_1817_;
                            phi_1818_ = _e1273;
                            phi_1819_ = _e1275;
                        } else {
                            phi_1818_ = false;
                            phi_1819_ = true;
                        }
                        let _e1277 = phi_1818_;
                        let _e1279 = phi_1819_;
                        if _e1279 {
                            phi_1823_ = _e1277;
                        } else {
                            phi_1823_ = true;
                        }
                        let _e1281 = phi_1823_;
                        if _e1281 {
                            let _e1283 = params.member.member_16;
                            let _e1285 = local_24.member_1;
                            let _e1287 = local_25.member_1;
                            if (_e1285 < _e1287) {
                                phi_1843_ = type_36(_e1285, _e1287);
                            } else {
                                phi_1843_ = type_36(_e1287, _e1285);
                            }
                            let _e1292 = phi_1843_;
                            let _e1296 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e1296 + 1u) < _e1296) {
                                let _e1300 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e1296 < _e1283) {
                                atomicStore((&output.member[(4u + (2u * _e1296))]), _e1292.member);
                                atomicStore((&output.member[((2u * _e1296) + 5u)]), _e1292.member_1);
                            }
                            let _e1309 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e1309 + 1u) < _e1309) {
                                let _e1313 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1888_ = (_e519 & (_e519 - 1u));
                        phi_1889_ = true;
                    }
                    let _e1315 = phi_1888_;
                    let _e1317 = phi_1889_;
                    phi_816_ = _e1315;
                    phi_1890_ = _e1317;
                } else {
                    phi_816_ = u32();
                    phi_1890_ = false;
                }
                let _e1319 = phi_816_;
                let _e1321 = phi_1890_;
                continue;
                continuing {
                    phi_812_ = _e533;
                    phi_815_ = _e1319;
                    break if !(_e1321);
                }
            }
            workgroupBarrier();
            let _e1324 = atomicLoad((&counters[4u]));
            if (2048u < _e1324) {
                phi_1897_ = 2048u;
            } else {
                phi_1897_ = _e1324;
            }
            let _e1327 = phi_1897_;
            phi_1900_ = type_36(0u, 16u);
            loop {
                let _e1329 = phi_1900_;
                if (_e1329.member < _e1329.member_1) {
                    phi_1901_ = type_36((_e1329.member + 1u), _e1329.member_1);
                    phi_1924_ = type_36(1u, _e1329.member);
                } else {
                    phi_1901_ = _e1329;
                    phi_1924_ = type_36(0u, type_36().member_1);
                }
                let _e1343 = phi_1901_;
                let _e1345 = phi_1924_;
                if (bitcast<i32>(_e1345.member) != 0i) {
                    let _e1351 = (_e110 + (_e1345.member_1 * 128u));
                    if (_e1351 >= _e1327) {
                        phi_8164_ = false;
                    } else {
                        let _e1354 = hits[_e1351];
                        let _e1357 = ((_e1354 >> bitcast<u32>(10i)) & 3u);
                        let _e1364 = firsts[(2u * _e1357)];
                        let _e1365 = (_e1364 + ((_e1354 >> bitcast<u32>(5i)) & 31u));
                        let _e1369 = firsts[((2u * _e1357) + 1u)];
                        let _e1370 = (_e1369 + (_e1354 & 31u));
                        let _e1372 = leaves.member[_e1365];
                        let _e1374 = leaves.member[_e1370];
                        local_26 = type_24(array<u32, 3>(_e1372.member[0], _e1372.member[1], _e1372.member[2]), _e1372.member_1);
                        local_27 = type_24(array<u32, 3>(_e1374.member[0], _e1374.member[1], _e1374.member[2]), _e1374.member_1);
                        let _e1390 = nodes.member[_e1365];
                        let _e1392 = nodes.member[_e1370];
                        let _e1394 = params.member.member_1;
                        if ((_e1394 & 1u) != 0u) {
                            let _e1398 = params.member.member_8;
                            if (_e1398 == 0u) {
                                let _e1442 = local_26.member[0u];
                                let _e1445 = local_27.member[0u];
                                if (_e1442 == _e1445) {
                                    phi_2043_ = bool();
                                    phi_2044_ = true;
                                } else {
                                    let _e1449 = local_26.member[0u];
                                    let _e1452 = local_27.member[1u];
                                    let _e1453 = (_e1449 == _e1452);
                                    if _e1453 {
                                        phi_2042_ = bool();
                                    } else {
                                        let _e1456 = local_26.member[0u];
                                        let _e1459 = local_27.member[2u];
                                        phi_2042_ = (_e1456 == _e1459);
                                    }
                                    let _e1462 = phi_2042_;
                                    phi_2043_ = _e1462;
                                    phi_2044_ = _e1453;
                                }
                                let _e1464 = phi_2043_;
                                let _e1466 = phi_2044_;
                                if _e1466 {
                                    phi_2048_ = true;
                                } else {
                                    phi_2048_ = _e1464;
                                }
                                let _e1468 = phi_2048_;
                                phi_2087_ = _e1468;
                            } else {
                                let _e1402 = local_26.member[0u];
                                let _e1405 = local_27.member[0u];
                                if (_e1402 == _e1405) {
                                    phi_2081_ = bool();
                                    phi_2082_ = true;
                                } else {
                                    let _e1409 = local_26.member[0u];
                                    let _e1412 = local_27.member[1u];
                                    if (_e1409 == _e1412) {
                                        phi_2079_ = bool();
                                        phi_2080_ = true;
                                    } else {
                                        let _e1416 = local_26.member[1u];
                                        let _e1419 = local_27.member[0u];
                                        let _e1420 = (_e1416 == _e1419);
                                        if _e1420 {
                                            phi_2078_ = bool();
                                        } else {
                                            let _e1423 = local_26.member[1u];
                                            let _e1426 = local_27.member[1u];
                                            phi_2078_ = (_e1423 == _e1426);
                                        }
                                        let _e1429 = phi_2078_;
                                        phi_2079_ = _e1429;
                                        phi_2080_ = _e1420;
                                    }
                                    let _e1431 = phi_2079_;
                                    let _e1433 = phi_2080_;
                                    phi_2081_ = _e1431;
                                    phi_2082_ = _e1433;
                                }
                                let _e1435 = phi_2081_;
                                let _e1437 = phi_2082_;
                                if _e1437 {
                                    phi_2086_ = true;
                                } else {
                                    phi_2086_ = _e1435;
                                }
                                let _e1439 = phi_2086_;
                                phi_2087_ = _e1439;
                            }
                            let _e1470 = phi_2087_;
                            if _e1470 {
                                phi_2091_ = false;
                            } else {
                                phi_2091_ = true;
                            }
                            let _e1472 = phi_2091_;
                            phi_2092_ = _e1472;
                        } else {
                            phi_2092_ = true;
                        }
                        let _e1474 = phi_2092_;
                        if _e1474 {
                            let _e1476 = params.member.member_1;
                            if ((_e1476 & 2u) != 0u) {
                                let _e1481 = local_26.member[0u];
                                let _e1483 = bodies.member[_e1481];
                                let _e1486 = local_27.member[0u];
                                let _e1488 = bodies.member[_e1486];
                                if ((_e1483 / 2u) == (_e1488 / 2u)) {
                                    let _e1493 = params.member.member_1;
                                    phi_2138_ = !(((_e1493 & 4u) != 0u));
                                } else {
                                    phi_2138_ = false;
                                }
                                let _e1498 = phi_2138_;
                                if _e1498 {
                                    phi_2149_ = true;
                                } else {
                                    if (((_e1483 & _e1488) & 1u) == 0u) {
                                        phi_2148_ = false;
                                    } else {
                                        phi_2148_ = true;
                                    }
                                    let _e1503 = phi_2148_;
                                    phi_2149_ = _e1503;
                                }
                                let _e1505 = phi_2149_;
                                if _e1505 {
                                    phi_2153_ = false;
                                } else {
                                    phi_2153_ = true;
                                }
                                let _e1507 = phi_2153_;
                                phi_2154_ = _e1507;
                            } else {
                                phi_2154_ = true;
                            }
                            let _e1509 = phi_2154_;
                            if _e1509 {
                                let _e1511 = params.member.member_1;
                                if ((_e1511 & 32u) != 0u) {
                                    let _e1515 = params.member.member_6;
                                    let _e1556 = (((((((_e1390.member_1[0] - _e1392.member[0]) > _e1515) && ((_e1392.member_1[0] - _e1390.member[0]) > _e1515)) && ((_e1390.member_1[1] - _e1392.member[1]) > _e1515)) && ((_e1392.member_1[1] - _e1390.member[1]) > _e1515)) && ((_e1390.member_1[2] - _e1392.member[2]) > _e1515)) && ((_e1392.member_1[2] - _e1390.member[2]) > _e1515));
                                    if _e1556 {
                                        phi_2903_ = bool();
                                    } else {
                                        phi_2203_ = type_36(0u, 3u);
                                        phi_2206_ = true;
                                        loop {
                                            let _e1560 = phi_2203_;
                                            let _e1562 = phi_2206_;
                                            local_66 = _e1562;
                                            if (_e1560.member < _e1560.member_1) {
                                                phi_2204_ = type_36((_e1560.member + 1u), _e1560.member_1);
                                                phi_2229_ = type_36(1u, _e1560.member);
                                            } else {
                                                phi_2204_ = _e1560;
                                                phi_2229_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e1576 = phi_2204_;
                                            let _e1578 = phi_2229_;
                                            let _e1582 = (bitcast<i32>(_e1578.member) != 0i);
                                            if _e1582 {
                                                let _e1584 = local_26.member[0u];
                                                let _e1586 = keys.member[_e1584];
                                                local_14 = array<array<u32, 2>, 6>(array<u32, 2>(_e1586[0][0], _e1586[0][1]), array<u32, 2>(_e1586[1][0], _e1586[1][1]), array<u32, 2>(_e1586[2][0], _e1586[2][1]), array<u32, 2>(_e1586[3][0], _e1586[3][1]), array<u32, 2>(_e1586[4][0], _e1586[4][1]), array<u32, 2>(_e1586[5][0], _e1586[5][1]));
                                                if (_e1578.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1614 = local_14[_e1578.member_1];
                                                phi_2286_ = type_36(1u, 3u);
                                                phi_2289_ = array<u32, 2>(_e1614[0], _e1614[1]);
                                                loop {
                                                    let _e1619 = phi_2286_;
                                                    let _e1621 = phi_2289_;
                                                    local_40 = _e1621;
                                                    local_42 = _e1621;
                                                    local_44 = _e1621;
                                                    if (_e1619.member < _e1619.member_1) {
                                                        phi_2287_ = type_36((_e1619.member + 1u), _e1619.member_1);
                                                        phi_2312_ = type_36(1u, _e1619.member);
                                                    } else {
                                                        phi_2287_ = _e1619;
                                                        phi_2312_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1635 = phi_2287_;
                                                    let _e1637 = phi_2312_;
                                                    let _e1641 = (bitcast<i32>(_e1637.member) != 0i);
                                                    if _e1641 {
                                                        if (_e1637.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1644 = local_26.member[_e1637.member_1];
                                                        let _e1646 = keys.member[_e1644];
                                                        local_15 = array<array<u32, 2>, 6>(array<u32, 2>(_e1646[0][0], _e1646[0][1]), array<u32, 2>(_e1646[1][0], _e1646[1][1]), array<u32, 2>(_e1646[2][0], _e1646[2][1]), array<u32, 2>(_e1646[3][0], _e1646[3][1]), array<u32, 2>(_e1646[4][0], _e1646[4][1]), array<u32, 2>(_e1646[5][0], _e1646[5][1]));
                                                        if (_e1578.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1674 = local_15[_e1578.member_1];
                                                        if (_e1621[1] > _e1674[1]) {
                                                            phi_2388_ = true;
                                                        } else {
                                                            if (_e1621[1] == _e1674[1]) {
                                                                phi_2387_ = (_e1621[0] > _e1674[0]);
                                                            } else {
                                                                phi_2387_ = false;
                                                            }
                                                            let _e1685 = phi_2387_;
                                                            phi_2388_ = _e1685;
                                                        }
                                                        let _e1687 = phi_2388_;
                                                        if _e1687 {
                                                            phi_2392_ = array<u32, 2>(_e1674[0], _e1674[1]);
                                                        } else {
                                                            phi_2392_ = _e1621;
                                                        }
                                                        let _e1689 = phi_2392_;
                                                        phi_2290_ = _e1689;
                                                    } else {
                                                        phi_2290_ = array<u32, 2>();
                                                    }
                                                    let _e1691 = phi_2290_;
                                                    continue;
                                                    continuing {
                                                        phi_2286_ = _e1635;
                                                        phi_2289_ = _e1691;
                                                        break if !(_e1641);
                                                    }
                                                }
                                                let _e1694 = local_27.member[0u];
                                                let _e1696 = keys.member[_e1694];
                                                local_12 = array<array<u32, 2>, 6>(array<u32, 2>(_e1696[0][0], _e1696[0][1]), array<u32, 2>(_e1696[1][0], _e1696[1][1]), array<u32, 2>(_e1696[2][0], _e1696[2][1]), array<u32, 2>(_e1696[3][0], _e1696[3][1]), array<u32, 2>(_e1696[4][0], _e1696[4][1]), array<u32, 2>(_e1696[5][0], _e1696[5][1]));
                                                let _e1722 = (3u + _e1578.member_1);
                                                if (_e1722 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1725 = local_12[_e1722];
                                                phi_2443_ = type_36(1u, 3u);
                                                phi_2446_ = array<u32, 2>(_e1725[0], _e1725[1]);
                                                loop {
                                                    let _e1730 = phi_2443_;
                                                    let _e1732 = phi_2446_;
                                                    local_41 = _e1732;
                                                    local_43 = _e1732;
                                                    local_45 = _e1732;
                                                    if (_e1730.member < _e1730.member_1) {
                                                        phi_2444_ = type_36((_e1730.member + 1u), _e1730.member_1);
                                                        phi_2469_ = type_36(1u, _e1730.member);
                                                    } else {
                                                        phi_2444_ = _e1730;
                                                        phi_2469_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1746 = phi_2444_;
                                                    let _e1748 = phi_2469_;
                                                    let _e1752 = (bitcast<i32>(_e1748.member) != 0i);
                                                    if _e1752 {
                                                        if (_e1748.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1755 = local_27.member[_e1748.member_1];
                                                        let _e1757 = keys.member[_e1755];
                                                        local_13 = array<array<u32, 2>, 6>(array<u32, 2>(_e1757[0][0], _e1757[0][1]), array<u32, 2>(_e1757[1][0], _e1757[1][1]), array<u32, 2>(_e1757[2][0], _e1757[2][1]), array<u32, 2>(_e1757[3][0], _e1757[3][1]), array<u32, 2>(_e1757[4][0], _e1757[4][1]), array<u32, 2>(_e1757[5][0], _e1757[5][1]));
                                                        let _e1783 = (3u + _e1578.member_1);
                                                        if (_e1783 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1786 = local_13[_e1783];
                                                        if (_e1786[1] > _e1732[1]) {
                                                            phi_2546_ = true;
                                                        } else {
                                                            if (_e1786[1] == _e1732[1]) {
                                                                phi_2545_ = (_e1786[0] > _e1732[0]);
                                                            } else {
                                                                phi_2545_ = false;
                                                            }
                                                            let _e1797 = phi_2545_;
                                                            phi_2546_ = _e1797;
                                                        }
                                                        let _e1799 = phi_2546_;
                                                        if _e1799 {
                                                            phi_2550_ = array<u32, 2>(_e1786[0], _e1786[1]);
                                                        } else {
                                                            phi_2550_ = _e1732;
                                                        }
                                                        let _e1801 = phi_2550_;
                                                        phi_2447_ = _e1801;
                                                    } else {
                                                        phi_2447_ = array<u32, 2>();
                                                    }
                                                    let _e1803 = phi_2447_;
                                                    continue;
                                                    continuing {
                                                        phi_2443_ = _e1746;
                                                        phi_2446_ = _e1803;
                                                        break if !(_e1752);
                                                    }
                                                }
                                                let _e1806 = local_40;
                                                let _e1809 = local_41;
                                                if (_e1806[1] > _e1809[1]) {
                                                    phi_2567_ = true;
                                                } else {
                                                    let _e1813 = local_42;
                                                    let _e1816 = local_43;
                                                    if (_e1813[1] == _e1816[1]) {
                                                        let _e1820 = local_44;
                                                        let _e1823 = local_45;
                                                        phi_2566_ = (_e1820[0] > _e1823[0]);
                                                    } else {
                                                        phi_2566_ = false;
                                                    }
                                                    let _e1827 = phi_2566_;
                                                    phi_2567_ = _e1827;
                                                }
                                                let _e1829 = phi_2567_;
                                                let _e1832 = local_27.member[0u];
                                                let _e1834 = keys.member[_e1832];
                                                local_10 = array<array<u32, 2>, 6>(array<u32, 2>(_e1834[0][0], _e1834[0][1]), array<u32, 2>(_e1834[1][0], _e1834[1][1]), array<u32, 2>(_e1834[2][0], _e1834[2][1]), array<u32, 2>(_e1834[3][0], _e1834[3][1]), array<u32, 2>(_e1834[4][0], _e1834[4][1]), array<u32, 2>(_e1834[5][0], _e1834[5][1]));
                                                if (_e1578.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1862 = local_10[_e1578.member_1];
                                                phi_2618_ = type_36(1u, 3u);
                                                phi_2621_ = array<u32, 2>(_e1862[0], _e1862[1]);
                                                loop {
                                                    let _e1867 = phi_2618_;
                                                    let _e1869 = phi_2621_;
                                                    local_46 = _e1869;
                                                    local_48 = _e1869;
                                                    local_50 = _e1869;
                                                    if (_e1867.member < _e1867.member_1) {
                                                        phi_2619_ = type_36((_e1867.member + 1u), _e1867.member_1);
                                                        phi_2644_ = type_36(1u, _e1867.member);
                                                    } else {
                                                        phi_2619_ = _e1867;
                                                        phi_2644_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1883 = phi_2619_;
                                                    let _e1885 = phi_2644_;
                                                    let _e1889 = (bitcast<i32>(_e1885.member) != 0i);
                                                    if _e1889 {
                                                        if (_e1885.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1892 = local_27.member[_e1885.member_1];
                                                        let _e1894 = keys.member[_e1892];
                                                        local_11 = array<array<u32, 2>, 6>(array<u32, 2>(_e1894[0][0], _e1894[0][1]), array<u32, 2>(_e1894[1][0], _e1894[1][1]), array<u32, 2>(_e1894[2][0], _e1894[2][1]), array<u32, 2>(_e1894[3][0], _e1894[3][1]), array<u32, 2>(_e1894[4][0], _e1894[4][1]), array<u32, 2>(_e1894[5][0], _e1894[5][1]));
                                                        if (_e1578.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1922 = local_11[_e1578.member_1];
                                                        if (_e1869[1] > _e1922[1]) {
                                                            phi_2720_ = true;
                                                        } else {
                                                            if (_e1869[1] == _e1922[1]) {
                                                                phi_2719_ = (_e1869[0] > _e1922[0]);
                                                            } else {
                                                                phi_2719_ = false;
                                                            }
                                                            let _e1933 = phi_2719_;
                                                            phi_2720_ = _e1933;
                                                        }
                                                        let _e1935 = phi_2720_;
                                                        if _e1935 {
                                                            phi_2724_ = array<u32, 2>(_e1922[0], _e1922[1]);
                                                        } else {
                                                            phi_2724_ = _e1869;
                                                        }
                                                        let _e1937 = phi_2724_;
                                                        phi_2622_ = _e1937;
                                                    } else {
                                                        phi_2622_ = array<u32, 2>();
                                                    }
                                                    let _e1939 = phi_2622_;
                                                    continue;
                                                    continuing {
                                                        phi_2618_ = _e1883;
                                                        phi_2621_ = _e1939;
                                                        break if !(_e1889);
                                                    }
                                                }
                                                let _e1942 = local_26.member[0u];
                                                let _e1944 = keys.member[_e1942];
                                                local_8 = array<array<u32, 2>, 6>(array<u32, 2>(_e1944[0][0], _e1944[0][1]), array<u32, 2>(_e1944[1][0], _e1944[1][1]), array<u32, 2>(_e1944[2][0], _e1944[2][1]), array<u32, 2>(_e1944[3][0], _e1944[3][1]), array<u32, 2>(_e1944[4][0], _e1944[4][1]), array<u32, 2>(_e1944[5][0], _e1944[5][1]));
                                                let _e1970 = (3u + _e1578.member_1);
                                                if (_e1970 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1973 = local_8[_e1970];
                                                phi_2775_ = type_36(1u, 3u);
                                                phi_2778_ = array<u32, 2>(_e1973[0], _e1973[1]);
                                                loop {
                                                    let _e1978 = phi_2775_;
                                                    let _e1980 = phi_2778_;
                                                    local_47 = _e1980;
                                                    local_49 = _e1980;
                                                    local_51 = _e1980;
                                                    if (_e1978.member < _e1978.member_1) {
                                                        phi_2776_ = type_36((_e1978.member + 1u), _e1978.member_1);
                                                        phi_2801_ = type_36(1u, _e1978.member);
                                                    } else {
                                                        phi_2776_ = _e1978;
                                                        phi_2801_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1994 = phi_2776_;
                                                    let _e1996 = phi_2801_;
                                                    let _e2000 = (bitcast<i32>(_e1996.member) != 0i);
                                                    if _e2000 {
                                                        if (_e1996.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2003 = local_26.member[_e1996.member_1];
                                                        let _e2005 = keys.member[_e2003];
                                                        local_9 = array<array<u32, 2>, 6>(array<u32, 2>(_e2005[0][0], _e2005[0][1]), array<u32, 2>(_e2005[1][0], _e2005[1][1]), array<u32, 2>(_e2005[2][0], _e2005[2][1]), array<u32, 2>(_e2005[3][0], _e2005[3][1]), array<u32, 2>(_e2005[4][0], _e2005[4][1]), array<u32, 2>(_e2005[5][0], _e2005[5][1]));
                                                        let _e2031 = (3u + _e1578.member_1);
                                                        if (_e2031 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2034 = local_9[_e2031];
                                                        if (_e2034[1] > _e1980[1]) {
                                                            phi_2878_ = true;
                                                        } else {
                                                            if (_e2034[1] == _e1980[1]) {
                                                                phi_2877_ = (_e2034[0] > _e1980[0]);
                                                            } else {
                                                                phi_2877_ = false;
                                                            }
                                                            let _e2045 = phi_2877_;
                                                            phi_2878_ = _e2045;
                                                        }
                                                        let _e2047 = phi_2878_;
                                                        if _e2047 {
                                                            phi_2882_ = array<u32, 2>(_e2034[0], _e2034[1]);
                                                        } else {
                                                            phi_2882_ = _e1980;
                                                        }
                                                        let _e2049 = phi_2882_;
                                                        phi_2779_ = _e2049;
                                                    } else {
                                                        phi_2779_ = array<u32, 2>();
                                                    }
                                                    let _e2051 = phi_2779_;
                                                    continue;
                                                    continuing {
                                                        phi_2775_ = _e1994;
                                                        phi_2778_ = _e2051;
                                                        break if !(_e2000);
                                                    }
                                                }
                                                let _e2054 = local_46;
                                                let _e2057 = local_47;
                                                if (_e2054[1] > _e2057[1]) {
                                                    phi_2899_ = true;
                                                } else {
                                                    let _e2061 = local_48;
                                                    let _e2064 = local_49;
                                                    if (_e2061[1] == _e2064[1]) {
                                                        let _e2068 = local_50;
                                                        let _e2071 = local_51;
                                                        phi_2898_ = (_e2068[0] > _e2071[0]);
                                                    } else {
                                                        phi_2898_ = false;
                                                    }
                                                    let _e2075 = phi_2898_;
                                                    phi_2899_ = _e2075;
                                                }
                                                let _e2077 = phi_2899_;
                                                phi_2207_ = (_e1562 && (!(_e1829) && !(_e2077)));
                                            } else {
                                                phi_2207_ = bool();
                                            }
                                            let _e2082 = phi_2207_;
                                            continue;
                                            continuing {
                                                phi_2203_ = _e1576;
                                                phi_2206_ = _e2082;
                                                break if !(_e1582);
                                            }
                                        }
                                        let _e5430 = local_66;
                                        phi_2903_ = _e5430;
                                    }
                                    let _e2085 = phi_2903_;
                                    phi_2904_ = _e2085;
                                    phi_2905_ = _e1556;
                                } else {
                                    phi_2904_ = bool();
                                    phi_2905_ = true;
                                }
                                let _e2087 = phi_2904_;
                                let _e2089 = phi_2905_;
                                if _e2089 {
                                    phi_2909_ = false;
                                } else {
                                    phi_2909_ = true;
                                }
                                let _e2091 = phi_2909_;
                                phi_2910_ = _e2087;
                                phi_2911_ = _e2091;
                            } else {
                                phi_2910_ = false;
                                phi_2911_ = true;
                            }
                            let _e2093 = phi_2910_;
                            let _e2095 = phi_2911_;
                            phi_2912_ = _e2093;
                            phi_2913_ = _e2095;
                        } else {
                            phi_2912_ = false;
                            phi_2913_ = true;
                        }
                        let _e2097 = phi_2912_;
                        let _e2099 = phi_2913_;
                        if _e2099 {
                            phi_2917_ = _e2097;
                        } else {
                            phi_2917_ = true;
                        }
                        let _e2101 = phi_2917_;
                        if _e2101 {
                            let _e2103 = atomicAdd((&counters[7u]), 1u);
                            let _e2105 = local_26.member_1;
                            let _e2107 = local_27.member_1;
                            if (_e2105 < _e2107) {
                                phi_2963_ = _e1374;
                                phi_2964_ = _e1372;
                            } else {
                                phi_2963_ = _e1372;
                                phi_2964_ = _e1374;
                            }
                            let _e2110 = phi_2963_;
                            let _e2112 = phi_2964_;
                            let _e2114 = params.member.member_4;
                            let _e2116 = params.member.member_5;
                            let _e2126 = paths.member[_e2112.member[0]];
                            let _e2128 = paths.member[_e2112.member[1]];
                            let _e2134 = paths.member[_e2110.member[0]];
                            let _e2136 = paths.member[_e2110.member[1]];
                            local_7 = type_71(array<array<f32, 3>, 2>(array<f32, 3>((_e2134.member[0] - _e2126.member[0]), (_e2134.member[1] - _e2126.member[1]), (_e2134.member[2] - _e2126.member[2])), array<f32, 3>((_e2134.member_1[0] - _e2126.member_1[0]), (_e2134.member_1[1] - _e2126.member_1[1]), (_e2134.member_1[2] - _e2126.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e2128.member[0] - _e2126.member[0]), (_e2128.member[1] - _e2126.member[1]), (_e2128.member[2] - _e2126.member[2])), array<f32, 3>((_e2128.member_1[0] - _e2126.member_1[0]), (_e2128.member_1[1] - _e2126.member_1[1]), (_e2128.member_1[2] - _e2126.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e2134.member[0] - _e2136.member[0]), (_e2134.member[1] - _e2136.member[1]), (_e2134.member[2] - _e2136.member[2])), array<f32, 3>((_e2134.member_1[0] - _e2136.member_1[0]), (_e2134.member_1[1] - _e2136.member_1[1]), (_e2134.member_1[2] - _e2136.member_1[2]))), (_e2114 + _e2114));
                            let _e2196 = local_7.member_1[0u];
                            let _e2202 = local_7.member_2[0u];
                            let _e2208 = ((_e2196[1] * _e2202[2]) - (_e2196[2] * _e2202[1]));
                            let _e2211 = ((_e2196[2] * _e2202[0]) - (_e2196[0] * _e2202[2]));
                            let _e2214 = ((_e2196[0] * _e2202[1]) - (_e2196[1] * _e2202[0]));
                            let _e2217 = local_7.member_1[1u];
                            let _e2223 = local_7.member_2[1u];
                            let _e2229 = ((_e2217[1] * _e2223[2]) - (_e2217[2] * _e2223[1]));
                            let _e2232 = ((_e2217[2] * _e2223[0]) - (_e2217[0] * _e2223[2]));
                            let _e2235 = ((_e2217[0] * _e2223[1]) - (_e2217[1] * _e2223[0]));
                            let _e2238 = local_7.member_1[0u];
                            let _e2244 = local_7.member_2[1u];
                            let _e2259 = local_7.member_1[1u];
                            let _e2265 = local_7.member_2[0u];
                            let _e2278 = (((_e2238[1] * _e2244[2]) - (_e2238[2] * _e2244[1])) + ((_e2259[1] * _e2265[2]) - (_e2259[2] * _e2265[1])));
                            let _e2279 = (((_e2238[2] * _e2244[0]) - (_e2238[0] * _e2244[2])) + ((_e2259[2] * _e2265[0]) - (_e2259[0] * _e2265[2])));
                            let _e2280 = (((_e2238[0] * _e2244[1]) - (_e2238[1] * _e2244[0])) + ((_e2259[0] * _e2265[1]) - (_e2259[1] * _e2265[0])));
                            let _e2283 = local_7.member[0u];
                            let _e2294 = local_7.member[1u];
                            let _e2305 = local_7.member[0u];
                            let _e2314 = ((((_e2294[0] * _e2208) + (_e2294[1] * _e2211)) + (_e2294[2] * _e2214)) + (((_e2305[0] * _e2278) + (_e2305[1] * _e2279)) + (_e2305[2] * _e2280)));
                            let _e2317 = local_7.member[0u];
                            let _e2328 = local_7.member[1u];
                            let _e2337 = ((((_e2317[0] * _e2229) + (_e2317[1] * _e2232)) + (_e2317[2] * _e2235)) + (((_e2328[0] * _e2278) + (_e2328[1] * _e2279)) + (_e2328[2] * _e2280)));
                            let _e2340 = local_7.member[1u];
                            let _e2351 = local_7.member[0u];
                            if (_e2351[0] < 0f) {
                                phi_3353_ = -(_e2351[0]);
                            } else {
                                phi_3353_ = _e2351[0];
                            }
                            let _e2358 = phi_3353_;
                            if (_e2351[1] < 0f) {
                                phi_3360_ = -(_e2351[1]);
                            } else {
                                phi_3360_ = _e2351[1];
                            }
                            let _e2362 = phi_3360_;
                            if (_e2358 > _e2362) {
                                phi_3365_ = _e2358;
                            } else {
                                phi_3365_ = _e2362;
                            }
                            let _e2365 = phi_3365_;
                            if (_e2351[2] < 0f) {
                                phi_3372_ = -(_e2351[2]);
                            } else {
                                phi_3372_ = _e2351[2];
                            }
                            let _e2369 = phi_3372_;
                            if (_e2365 > _e2369) {
                                phi_3377_ = _e2365;
                            } else {
                                phi_3377_ = _e2369;
                            }
                            let _e2372 = phi_3377_;
                            let _e2375 = local_7.member[1u];
                            if (_e2375[0] < 0f) {
                                phi_3390_ = -(_e2375[0]);
                            } else {
                                phi_3390_ = _e2375[0];
                            }
                            let _e2382 = phi_3390_;
                            if (_e2375[1] < 0f) {
                                phi_3397_ = -(_e2375[1]);
                            } else {
                                phi_3397_ = _e2375[1];
                            }
                            let _e2386 = phi_3397_;
                            if (_e2382 > _e2386) {
                                phi_3402_ = _e2382;
                            } else {
                                phi_3402_ = _e2386;
                            }
                            let _e2389 = phi_3402_;
                            if (_e2375[2] < 0f) {
                                phi_3409_ = -(_e2375[2]);
                            } else {
                                phi_3409_ = _e2375[2];
                            }
                            let _e2393 = phi_3409_;
                            if (_e2389 > _e2393) {
                                phi_3414_ = _e2389;
                            } else {
                                phi_3414_ = _e2393;
                            }
                            let _e2396 = phi_3414_;
                            if (_e2372 > _e2396) {
                                phi_3419_ = _e2372;
                            } else {
                                phi_3419_ = _e2396;
                            }
                            let _e2399 = phi_3419_;
                            let _e2401 = local_7.member_3;
                            let _e2402 = (_e2399 + _e2401);
                            let _e2405 = local_7.member_1[0u];
                            if (_e2405[0] < 0f) {
                                phi_3436_ = -(_e2405[0]);
                            } else {
                                phi_3436_ = _e2405[0];
                            }
                            let _e2412 = phi_3436_;
                            if (_e2405[1] < 0f) {
                                phi_3443_ = -(_e2405[1]);
                            } else {
                                phi_3443_ = _e2405[1];
                            }
                            let _e2416 = phi_3443_;
                            if (_e2412 > _e2416) {
                                phi_3448_ = _e2412;
                            } else {
                                phi_3448_ = _e2416;
                            }
                            let _e2419 = phi_3448_;
                            if (_e2405[2] < 0f) {
                                phi_3455_ = -(_e2405[2]);
                            } else {
                                phi_3455_ = _e2405[2];
                            }
                            let _e2423 = phi_3455_;
                            if (_e2419 > _e2423) {
                                phi_3460_ = _e2419;
                            } else {
                                phi_3460_ = _e2423;
                            }
                            let _e2426 = phi_3460_;
                            let _e2429 = local_7.member_1[1u];
                            if (_e2429[0] < 0f) {
                                phi_3474_ = -(_e2429[0]);
                            } else {
                                phi_3474_ = _e2429[0];
                            }
                            let _e2436 = phi_3474_;
                            if (_e2429[1] < 0f) {
                                phi_3481_ = -(_e2429[1]);
                            } else {
                                phi_3481_ = _e2429[1];
                            }
                            let _e2440 = phi_3481_;
                            if (_e2436 > _e2440) {
                                phi_3486_ = _e2436;
                            } else {
                                phi_3486_ = _e2440;
                            }
                            let _e2443 = phi_3486_;
                            if (_e2429[2] < 0f) {
                                phi_3493_ = -(_e2429[2]);
                            } else {
                                phi_3493_ = _e2429[2];
                            }
                            let _e2447 = phi_3493_;
                            if (_e2443 > _e2447) {
                                phi_3498_ = _e2443;
                            } else {
                                phi_3498_ = _e2447;
                            }
                            let _e2450 = phi_3498_;
                            if (_e2426 > _e2450) {
                                phi_3503_ = _e2426;
                            } else {
                                phi_3503_ = _e2450;
                            }
                            let _e2453 = phi_3503_;
                            let _e2455 = local_7.member_3;
                            let _e2456 = (_e2453 + _e2455);
                            let _e2459 = local_7.member_2[0u];
                            if (_e2459[0] < 0f) {
                                phi_3520_ = -(_e2459[0]);
                            } else {
                                phi_3520_ = _e2459[0];
                            }
                            let _e2466 = phi_3520_;
                            if (_e2459[1] < 0f) {
                                phi_3527_ = -(_e2459[1]);
                            } else {
                                phi_3527_ = _e2459[1];
                            }
                            let _e2470 = phi_3527_;
                            if (_e2466 > _e2470) {
                                phi_3532_ = _e2466;
                            } else {
                                phi_3532_ = _e2470;
                            }
                            let _e2473 = phi_3532_;
                            if (_e2459[2] < 0f) {
                                phi_3539_ = -(_e2459[2]);
                            } else {
                                phi_3539_ = _e2459[2];
                            }
                            let _e2477 = phi_3539_;
                            if (_e2473 > _e2477) {
                                phi_3544_ = _e2473;
                            } else {
                                phi_3544_ = _e2477;
                            }
                            let _e2480 = phi_3544_;
                            let _e2483 = local_7.member_2[1u];
                            if (_e2483[0] < 0f) {
                                phi_3558_ = -(_e2483[0]);
                            } else {
                                phi_3558_ = _e2483[0];
                            }
                            let _e2490 = phi_3558_;
                            if (_e2483[1] < 0f) {
                                phi_3565_ = -(_e2483[1]);
                            } else {
                                phi_3565_ = _e2483[1];
                            }
                            let _e2494 = phi_3565_;
                            if (_e2490 > _e2494) {
                                phi_3570_ = _e2490;
                            } else {
                                phi_3570_ = _e2494;
                            }
                            let _e2497 = phi_3570_;
                            if (_e2483[2] < 0f) {
                                phi_3577_ = -(_e2483[2]);
                            } else {
                                phi_3577_ = _e2483[2];
                            }
                            let _e2501 = phi_3577_;
                            if (_e2497 > _e2501) {
                                phi_3582_ = _e2497;
                            } else {
                                phi_3582_ = _e2501;
                            }
                            let _e2504 = phi_3582_;
                            if (_e2480 > _e2504) {
                                phi_3587_ = _e2480;
                            } else {
                                phi_3587_ = _e2504;
                            }
                            let _e2507 = phi_3587_;
                            let _e2509 = local_7.member_3;
                            let _e2510 = (_e2507 + _e2509);
                            let _e2512 = ((_e2456 * 8f) * _e2510);
                            let _e2519 = local_7.member_3;
                            if (_e2208 < 0f) {
                                phi_3618_ = -(_e2208);
                            } else {
                                phi_3618_ = _e2208;
                            }
                            let _e2536 = phi_3618_;
                            if (_e2211 < 0f) {
                                phi_3624_ = -(_e2211);
                            } else {
                                phi_3624_ = _e2211;
                            }
                            let _e2540 = phi_3624_;
                            if (_e2214 < 0f) {
                                phi_3631_ = -(_e2214);
                            } else {
                                phi_3631_ = _e2214;
                            }
                            let _e2545 = phi_3631_;
                            let _e2546 = ((_e2536 + _e2540) + _e2545);
                            if (_e2229 < 0f) {
                                phi_3638_ = -(_e2229);
                            } else {
                                phi_3638_ = _e2229;
                            }
                            let _e2550 = phi_3638_;
                            if (_e2232 < 0f) {
                                phi_3644_ = -(_e2232);
                            } else {
                                phi_3644_ = _e2232;
                            }
                            let _e2554 = phi_3644_;
                            if (_e2235 < 0f) {
                                phi_3651_ = -(_e2235);
                            } else {
                                phi_3651_ = _e2235;
                            }
                            let _e2559 = phi_3651_;
                            let _e2560 = ((_e2550 + _e2554) + _e2559);
                            if (_e2546 > _e2560) {
                                phi_3657_ = _e2546;
                            } else {
                                phi_3657_ = _e2560;
                            }
                            let _e2563 = phi_3657_;
                            if (_e2278 < 0f) {
                                phi_3663_ = -(_e2278);
                            } else {
                                phi_3663_ = _e2278;
                            }
                            let _e2567 = phi_3663_;
                            if (_e2279 < 0f) {
                                phi_3669_ = -(_e2279);
                            } else {
                                phi_3669_ = _e2279;
                            }
                            let _e2571 = phi_3669_;
                            if (_e2280 < 0f) {
                                phi_3676_ = -(_e2280);
                            } else {
                                phi_3676_ = _e2280;
                            }
                            let _e2576 = phi_3676_;
                            let _e2578 = (((_e2567 + _e2571) + _e2576) * 0.5f);
                            if (_e2563 > _e2578) {
                                phi_3683_ = _e2563;
                            } else {
                                phi_3683_ = _e2578;
                            }
                            let _e2581 = phi_3683_;
                            let _e2586 = local_7.member_3;
                            let _e2599 = ((((_e2283[0] * _e2208) + (_e2283[1] * _e2211)) + (_e2283[2] * _e2214)) * 3f);
                            let _e2600 = ((((_e2340[0] * _e2229) + (_e2340[1] * _e2232)) + (_e2340[2] * _e2235)) * 3f);
                            if (_e2599 < _e2600) {
                                phi_3707_ = _e2599;
                            } else {
                                phi_3707_ = _e2600;
                            }
                            let _e2603 = phi_3707_;
                            if (_e2314 < _e2337) {
                                phi_3712_ = _e2314;
                            } else {
                                phi_3712_ = _e2337;
                            }
                            let _e2606 = phi_3712_;
                            if (_e2603 < _e2606) {
                                phi_3717_ = _e2603;
                            } else {
                                phi_3717_ = _e2606;
                            }
                            let _e2609 = phi_3717_;
                            if (_e2599 > _e2600) {
                                phi_3722_ = _e2599;
                            } else {
                                phi_3722_ = _e2600;
                            }
                            let _e2612 = phi_3722_;
                            if (_e2314 > _e2337) {
                                phi_3727_ = _e2314;
                            } else {
                                phi_3727_ = _e2337;
                            }
                            let _e2615 = phi_3727_;
                            if (_e2612 > _e2615) {
                                phi_3732_ = _e2612;
                            } else {
                                phi_3732_ = _e2615;
                            }
                            let _e2618 = phi_3732_;
                            let _e2623 = -(_e2618);
                            if (_e2609 > _e2623) {
                                phi_3742_ = _e2609;
                            } else {
                                phi_3742_ = _e2623;
                            }
                            let _e2626 = phi_3742_;
                            if ((_e2626 - ((((((_e2402 * 8f) * _e2512) * (0.000000059604645f * (490f / 64f))) + ((_e2519 * 19f) * ((_e2402 * (_e2456 + _e2510)) + (_e2456 * _e2510)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2402) * ((1f + _e2456) * (1f + _e2510))))) + ((_e2116 * (((_e2581 + (_e2512 * (0.000000059604645f * 4f))) + ((_e2586 * 6f) * (_e2456 + _e2510))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2456) * (1f + _e2510))))) * (3f * 1.0001f)))) > 0f) {
                                phi_4718_ = true;
                            } else {
                                let _e2631 = local_7.member_1[0u];
                                let _e2637 = local_7.member_1[1u];
                                let _e2641 = (_e2631[0] + _e2637[0]);
                                let _e2642 = (_e2631[1] + _e2637[1]);
                                let _e2643 = (_e2631[2] + _e2637[2]);
                                let _e2646 = local_7.member_2[0u];
                                let _e2652 = local_7.member_2[1u];
                                let _e2656 = (_e2646[0] + _e2652[0]);
                                let _e2657 = (_e2646[1] + _e2652[1]);
                                let _e2658 = (_e2646[2] + _e2652[2]);
                                let _e2661 = ((_e2642 * _e2658) - (_e2643 * _e2657));
                                let _e2664 = ((_e2643 * _e2656) - (_e2641 * _e2658));
                                let _e2667 = ((_e2641 * _e2657) - (_e2642 * _e2656));
                                let _e2670 = local_7.member[0u];
                                let _e2676 = local_7.member_1[0u];
                                let _e2682 = local_7.member_2[0u];
                                let _e2686 = (_e2670[0] - _e2676[0]);
                                let _e2687 = (_e2670[1] - _e2676[1]);
                                let _e2688 = (_e2670[2] - _e2676[2]);
                                let _e2697 = local_7.member[1u];
                                let _e2703 = local_7.member_1[1u];
                                let _e2709 = local_7.member_2[1u];
                                let _e2713 = (_e2697[0] - _e2703[0]);
                                let _e2714 = (_e2697[1] - _e2703[1]);
                                let _e2715 = (_e2697[2] - _e2703[2]);
                                local_5 = array<array<f32, 3>, 4>(_e2670, array<f32, 3>(_e2686, _e2687, _e2688), array<f32, 3>((_e2670[0] - _e2682[0]), (_e2670[1] - _e2682[1]), (_e2670[2] - _e2682[2])), array<f32, 3>((_e2686 - _e2682[0]), (_e2687 - _e2682[1]), (_e2688 - _e2682[2])));
                                local_6 = array<array<f32, 3>, 4>(_e2697, array<f32, 3>(_e2713, _e2714, _e2715), array<f32, 3>((_e2697[0] - _e2709[0]), (_e2697[1] - _e2709[1]), (_e2697[2] - _e2709[2])), array<f32, 3>((_e2713 - _e2709[0]), (_e2714 - _e2709[1]), (_e2715 - _e2709[2])));
                                let _e2732 = local_7.member[0u];
                                if (_e2732[0] < 0f) {
                                    phi_3993_ = -(_e2732[0]);
                                } else {
                                    phi_3993_ = _e2732[0];
                                }
                                let _e2739 = phi_3993_;
                                if (_e2732[1] < 0f) {
                                    phi_4000_ = -(_e2732[1]);
                                } else {
                                    phi_4000_ = _e2732[1];
                                }
                                let _e2743 = phi_4000_;
                                if (_e2739 > _e2743) {
                                    phi_4005_ = _e2739;
                                } else {
                                    phi_4005_ = _e2743;
                                }
                                let _e2746 = phi_4005_;
                                if (_e2732[2] < 0f) {
                                    phi_4012_ = -(_e2732[2]);
                                } else {
                                    phi_4012_ = _e2732[2];
                                }
                                let _e2750 = phi_4012_;
                                if (_e2746 > _e2750) {
                                    phi_4017_ = _e2746;
                                } else {
                                    phi_4017_ = _e2750;
                                }
                                let _e2753 = phi_4017_;
                                let _e2756 = local_7.member[1u];
                                if (_e2756[0] < 0f) {
                                    phi_4030_ = -(_e2756[0]);
                                } else {
                                    phi_4030_ = _e2756[0];
                                }
                                let _e2763 = phi_4030_;
                                if (_e2756[1] < 0f) {
                                    phi_4037_ = -(_e2756[1]);
                                } else {
                                    phi_4037_ = _e2756[1];
                                }
                                let _e2767 = phi_4037_;
                                if (_e2763 > _e2767) {
                                    phi_4042_ = _e2763;
                                } else {
                                    phi_4042_ = _e2767;
                                }
                                let _e2770 = phi_4042_;
                                if (_e2756[2] < 0f) {
                                    phi_4049_ = -(_e2756[2]);
                                } else {
                                    phi_4049_ = _e2756[2];
                                }
                                let _e2774 = phi_4049_;
                                if (_e2770 > _e2774) {
                                    phi_4054_ = _e2770;
                                } else {
                                    phi_4054_ = _e2774;
                                }
                                let _e2777 = phi_4054_;
                                if (_e2753 > _e2777) {
                                    phi_4059_ = _e2753;
                                } else {
                                    phi_4059_ = _e2777;
                                }
                                let _e2780 = phi_4059_;
                                let _e2782 = local_7.member_3;
                                let _e2786 = local_7.member_1[0u];
                                if (_e2786[0] < 0f) {
                                    phi_4076_ = -(_e2786[0]);
                                } else {
                                    phi_4076_ = _e2786[0];
                                }
                                let _e2793 = phi_4076_;
                                if (_e2786[1] < 0f) {
                                    phi_4083_ = -(_e2786[1]);
                                } else {
                                    phi_4083_ = _e2786[1];
                                }
                                let _e2797 = phi_4083_;
                                if (_e2793 > _e2797) {
                                    phi_4088_ = _e2793;
                                } else {
                                    phi_4088_ = _e2797;
                                }
                                let _e2800 = phi_4088_;
                                if (_e2786[2] < 0f) {
                                    phi_4095_ = -(_e2786[2]);
                                } else {
                                    phi_4095_ = _e2786[2];
                                }
                                let _e2804 = phi_4095_;
                                if (_e2800 > _e2804) {
                                    phi_4100_ = _e2800;
                                } else {
                                    phi_4100_ = _e2804;
                                }
                                let _e2807 = phi_4100_;
                                let _e2810 = local_7.member_1[1u];
                                if (_e2810[0] < 0f) {
                                    phi_4114_ = -(_e2810[0]);
                                } else {
                                    phi_4114_ = _e2810[0];
                                }
                                let _e2817 = phi_4114_;
                                if (_e2810[1] < 0f) {
                                    phi_4121_ = -(_e2810[1]);
                                } else {
                                    phi_4121_ = _e2810[1];
                                }
                                let _e2821 = phi_4121_;
                                if (_e2817 > _e2821) {
                                    phi_4126_ = _e2817;
                                } else {
                                    phi_4126_ = _e2821;
                                }
                                let _e2824 = phi_4126_;
                                if (_e2810[2] < 0f) {
                                    phi_4133_ = -(_e2810[2]);
                                } else {
                                    phi_4133_ = _e2810[2];
                                }
                                let _e2828 = phi_4133_;
                                if (_e2824 > _e2828) {
                                    phi_4138_ = _e2824;
                                } else {
                                    phi_4138_ = _e2828;
                                }
                                let _e2831 = phi_4138_;
                                if (_e2807 > _e2831) {
                                    phi_4143_ = _e2807;
                                } else {
                                    phi_4143_ = _e2831;
                                }
                                let _e2834 = phi_4143_;
                                let _e2836 = local_7.member_3;
                                let _e2840 = local_7.member_2[0u];
                                if (_e2840[0] < 0f) {
                                    phi_4160_ = -(_e2840[0]);
                                } else {
                                    phi_4160_ = _e2840[0];
                                }
                                let _e2847 = phi_4160_;
                                if (_e2840[1] < 0f) {
                                    phi_4167_ = -(_e2840[1]);
                                } else {
                                    phi_4167_ = _e2840[1];
                                }
                                let _e2851 = phi_4167_;
                                if (_e2847 > _e2851) {
                                    phi_4172_ = _e2847;
                                } else {
                                    phi_4172_ = _e2851;
                                }
                                let _e2854 = phi_4172_;
                                if (_e2840[2] < 0f) {
                                    phi_4179_ = -(_e2840[2]);
                                } else {
                                    phi_4179_ = _e2840[2];
                                }
                                let _e2858 = phi_4179_;
                                if (_e2854 > _e2858) {
                                    phi_4184_ = _e2854;
                                } else {
                                    phi_4184_ = _e2858;
                                }
                                let _e2861 = phi_4184_;
                                let _e2864 = local_7.member_2[1u];
                                if (_e2864[0] < 0f) {
                                    phi_4198_ = -(_e2864[0]);
                                } else {
                                    phi_4198_ = _e2864[0];
                                }
                                let _e2871 = phi_4198_;
                                if (_e2864[1] < 0f) {
                                    phi_4205_ = -(_e2864[1]);
                                } else {
                                    phi_4205_ = _e2864[1];
                                }
                                let _e2875 = phi_4205_;
                                if (_e2871 > _e2875) {
                                    phi_4210_ = _e2871;
                                } else {
                                    phi_4210_ = _e2875;
                                }
                                let _e2878 = phi_4210_;
                                if (_e2864[2] < 0f) {
                                    phi_4217_ = -(_e2864[2]);
                                } else {
                                    phi_4217_ = _e2864[2];
                                }
                                let _e2882 = phi_4217_;
                                if (_e2878 > _e2882) {
                                    phi_4222_ = _e2878;
                                } else {
                                    phi_4222_ = _e2882;
                                }
                                let _e2885 = phi_4222_;
                                if (_e2861 > _e2885) {
                                    phi_4227_ = _e2861;
                                } else {
                                    phi_4227_ = _e2885;
                                }
                                let _e2888 = phi_4227_;
                                let _e2890 = local_7.member_3;
                                let _e2893 = (((_e2780 + _e2782) + (_e2834 + _e2836)) + (_e2888 + _e2890));
                                let _e2896 = local_7.member_3;
                                let _e2900 = (((_e2116 * 1.0001f) + (_e2896 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2903 = ((_e2664 * _e2643) - (_e2667 * _e2642));
                                let _e2906 = ((_e2667 * _e2641) - (_e2661 * _e2643));
                                let _e2909 = ((_e2661 * _e2642) - (_e2664 * _e2641));
                                let _e2911 = local_5[0u];
                                let _e2919 = (((_e2903 * _e2911[0]) + (_e2906 * _e2911[1])) + (_e2909 * _e2911[2]));
                                phi_4265_ = type_36(0u, 4u);
                                phi_4268_ = _e2919;
                                phi_4270_ = _e2919;
                                loop {
                                    let _e2921 = phi_4265_;
                                    let _e2923 = phi_4268_;
                                    let _e2925 = phi_4270_;
                                    local_52 = _e2923;
                                    local_53 = _e2925;
                                    local_67 = _e2925;
                                    if (_e2921.member < _e2921.member_1) {
                                        phi_4266_ = type_36((_e2921.member + 1u), _e2921.member_1);
                                        phi_4293_ = type_36(1u, _e2921.member);
                                    } else {
                                        phi_4266_ = _e2921;
                                        phi_4293_ = type_36(0u, type_36().member_1);
                                    }
                                    let _e2939 = phi_4266_;
                                    let _e2941 = phi_4293_;
                                    let _e2945 = (bitcast<i32>(_e2941.member) != 0i);
                                    if _e2945 {
                                        if (_e2941.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2948 = local_5[_e2941.member_1];
                                        let _e2956 = (((_e2903 * _e2948[0]) + (_e2906 * _e2948[1])) + (_e2909 * _e2948[2]));
                                        if (_e2941.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2959 = local_6[_e2941.member_1];
                                        let _e2967 = (((_e2903 * _e2959[0]) + (_e2906 * _e2959[1])) + (_e2909 * _e2959[2]));
                                        if (_e2925 < _e2956) {
                                            phi_4343_ = _e2925;
                                        } else {
                                            phi_4343_ = _e2956;
                                        }
                                        let _e2970 = phi_4343_;
                                        if (_e2970 < _e2967) {
                                            phi_4348_ = _e2970;
                                        } else {
                                            phi_4348_ = _e2967;
                                        }
                                        let _e2973 = phi_4348_;
                                        if (_e2923 > _e2956) {
                                            phi_4353_ = _e2923;
                                        } else {
                                            phi_4353_ = _e2956;
                                        }
                                        let _e2976 = phi_4353_;
                                        if (_e2976 > _e2967) {
                                            phi_4358_ = _e2976;
                                        } else {
                                            phi_4358_ = _e2967;
                                        }
                                        let _e2979 = phi_4358_;
                                        phi_4269_ = _e2979;
                                        phi_4271_ = _e2973;
                                    } else {
                                        phi_4269_ = f32();
                                        phi_4271_ = f32();
                                    }
                                    let _e2981 = phi_4269_;
                                    let _e2983 = phi_4271_;
                                    continue;
                                    continuing {
                                        phi_4265_ = _e2939;
                                        phi_4268_ = _e2981;
                                        phi_4270_ = _e2983;
                                        break if !(_e2945);
                                    }
                                }
                                if (_e2903 < 0f) {
                                    phi_4364_ = -(_e2903);
                                } else {
                                    phi_4364_ = _e2903;
                                }
                                let _e2988 = phi_4364_;
                                if (_e2906 < 0f) {
                                    phi_4370_ = -(_e2906);
                                } else {
                                    phi_4370_ = _e2906;
                                }
                                let _e2992 = phi_4370_;
                                if (_e2909 < 0f) {
                                    phi_4377_ = -(_e2909);
                                } else {
                                    phi_4377_ = _e2909;
                                }
                                let _e2997 = phi_4377_;
                                let _e2998 = ((_e2988 + _e2992) + _e2997);
                                let _e3003 = local_52;
                                let _e3004 = -(_e3003);
                                let _e3006 = local_53;
                                if (_e3006 > _e3004) {
                                    let _e5543 = local_67;
                                    phi_4387_ = _e5543;
                                } else {
                                    phi_4387_ = _e3004;
                                }
                                let _e3009 = phi_4387_;
                                let _e3014 = (((_e3009 - ((_e2998 * _e2893) * (0.000000059604645f * 17f))) - (_e2998 * _e2900)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e3017 = ((_e2664 * _e2658) - (_e2667 * _e2657));
                                let _e3020 = ((_e2667 * _e2656) - (_e2661 * _e2658));
                                let _e3023 = ((_e2661 * _e2657) - (_e2664 * _e2656));
                                let _e3025 = local_5[0u];
                                let _e3033 = (((_e3017 * _e3025[0]) + (_e3020 * _e3025[1])) + (_e3023 * _e3025[2]));
                                phi_4418_ = type_36(0u, 4u);
                                phi_4421_ = _e3033;
                                phi_4423_ = _e3033;
                                loop {
                                    let _e3035 = phi_4418_;
                                    let _e3037 = phi_4421_;
                                    let _e3039 = phi_4423_;
                                    local_54 = _e3037;
                                    local_55 = _e3039;
                                    local_68 = _e3039;
                                    if (_e3035.member < _e3035.member_1) {
                                        phi_4419_ = type_36((_e3035.member + 1u), _e3035.member_1);
                                        phi_4446_ = type_36(1u, _e3035.member);
                                    } else {
                                        phi_4419_ = _e3035;
                                        phi_4446_ = type_36(0u, type_36().member_1);
                                    }
                                    let _e3053 = phi_4419_;
                                    let _e3055 = phi_4446_;
                                    let _e3059 = (bitcast<i32>(_e3055.member) != 0i);
                                    if _e3059 {
                                        if (_e3055.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e3062 = local_5[_e3055.member_1];
                                        let _e3070 = (((_e3017 * _e3062[0]) + (_e3020 * _e3062[1])) + (_e3023 * _e3062[2]));
                                        if (_e3055.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e3073 = local_6[_e3055.member_1];
                                        let _e3081 = (((_e3017 * _e3073[0]) + (_e3020 * _e3073[1])) + (_e3023 * _e3073[2]));
                                        if (_e3039 < _e3070) {
                                            phi_4496_ = _e3039;
                                        } else {
                                            phi_4496_ = _e3070;
                                        }
                                        let _e3084 = phi_4496_;
                                        if (_e3084 < _e3081) {
                                            phi_4501_ = _e3084;
                                        } else {
                                            phi_4501_ = _e3081;
                                        }
                                        let _e3087 = phi_4501_;
                                        if (_e3037 > _e3070) {
                                            phi_4506_ = _e3037;
                                        } else {
                                            phi_4506_ = _e3070;
                                        }
                                        let _e3090 = phi_4506_;
                                        if (_e3090 > _e3081) {
                                            phi_4511_ = _e3090;
                                        } else {
                                            phi_4511_ = _e3081;
                                        }
                                        let _e3093 = phi_4511_;
                                        phi_4422_ = _e3093;
                                        phi_4424_ = _e3087;
                                    } else {
                                        phi_4422_ = f32();
                                        phi_4424_ = f32();
                                    }
                                    let _e3095 = phi_4422_;
                                    let _e3097 = phi_4424_;
                                    continue;
                                    continuing {
                                        phi_4418_ = _e3053;
                                        phi_4421_ = _e3095;
                                        phi_4423_ = _e3097;
                                        break if !(_e3059);
                                    }
                                }
                                if (_e3017 < 0f) {
                                    phi_4517_ = -(_e3017);
                                } else {
                                    phi_4517_ = _e3017;
                                }
                                let _e3102 = phi_4517_;
                                if (_e3020 < 0f) {
                                    phi_4523_ = -(_e3020);
                                } else {
                                    phi_4523_ = _e3020;
                                }
                                let _e3106 = phi_4523_;
                                if (_e3023 < 0f) {
                                    phi_4530_ = -(_e3023);
                                } else {
                                    phi_4530_ = _e3023;
                                }
                                let _e3111 = phi_4530_;
                                let _e3112 = ((_e3102 + _e3106) + _e3111);
                                let _e3117 = local_54;
                                let _e3118 = -(_e3117);
                                let _e3120 = local_55;
                                if (_e3120 > _e3118) {
                                    let _e5562 = local_68;
                                    phi_4540_ = _e5562;
                                } else {
                                    phi_4540_ = _e3118;
                                }
                                let _e3123 = phi_4540_;
                                let _e3128 = (((_e3123 - ((_e3112 * _e2893) * (0.000000059604645f * 17f))) - (_e3112 * _e2900)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e3014 > _e3128) {
                                    phi_4550_ = _e3014;
                                } else {
                                    phi_4550_ = _e3128;
                                }
                                let _e3131 = phi_4550_;
                                phi_4718_ = (_e3131 > 0f);
                            }
                            let _e3134 = phi_4718_;
                            if _e3134 {
                                phi_8154_ = false;
                            } else {
                                let _e3137 = local_7.member[0u];
                                let _e3143 = local_7.member[1u];
                                let _e3150 = ((_e3137[0] + _e3143[0]) * 0.5f);
                                let _e3151 = ((_e3137[1] + _e3143[1]) * 0.5f);
                                let _e3152 = ((_e3137[2] + _e3143[2]) * 0.5f);
                                let _e3155 = local_7.member_1[0u];
                                let _e3161 = local_7.member_1[1u];
                                let _e3168 = ((_e3155[0] + _e3161[0]) * 0.5f);
                                let _e3169 = ((_e3155[1] + _e3161[1]) * 0.5f);
                                let _e3170 = ((_e3155[2] + _e3161[2]) * 0.5f);
                                let _e3173 = local_7.member_2[0u];
                                let _e3179 = local_7.member_2[1u];
                                let _e3186 = ((_e3173[0] + _e3179[0]) * 0.5f);
                                let _e3187 = ((_e3173[1] + _e3179[1]) * 0.5f);
                                let _e3188 = ((_e3173[2] + _e3179[2]) * 0.5f);
                                let _e3191 = local_7.member[0u];
                                let _e3194 = local_7.member_1[0u];
                                let _e3197 = local_7.member_2[0u];
                                let _e3199 = local_7.member_3;
                                let _e3202 = local_7.member[1u];
                                let _e3205 = local_7.member_1[1u];
                                let _e3208 = local_7.member_2[1u];
                                let _e3210 = local_7.member_3;
                                local_4 = array<type_71, 2>(type_71(array<array<f32, 3>, 2>(_e3191, array<f32, 3>(_e3150, _e3151, _e3152)), array<array<f32, 3>, 2>(_e3194, array<f32, 3>(_e3168, _e3169, _e3170)), array<array<f32, 3>, 2>(_e3197, array<f32, 3>(_e3186, _e3187, _e3188)), _e3199), type_71(array<array<f32, 3>, 2>(array<f32, 3>(_e3150, _e3151, _e3152), _e3202), array<array<f32, 3>, 2>(array<f32, 3>(_e3168, _e3169, _e3170), _e3205), array<array<f32, 3>, 2>(array<f32, 3>(_e3186, _e3187, _e3188), _e3208), _e3210));
                                let _e3229 = local_4[0u].member_1[0u];
                                let _e3235 = local_4[0u].member_2[0u];
                                let _e3241 = ((_e3229[1] * _e3235[2]) - (_e3229[2] * _e3235[1]));
                                let _e3244 = ((_e3229[2] * _e3235[0]) - (_e3229[0] * _e3235[2]));
                                let _e3247 = ((_e3229[0] * _e3235[1]) - (_e3229[1] * _e3235[0]));
                                let _e3250 = local_4[0u].member_1[1u];
                                let _e3256 = local_4[0u].member_2[1u];
                                let _e3262 = ((_e3250[1] * _e3256[2]) - (_e3250[2] * _e3256[1]));
                                let _e3265 = ((_e3250[2] * _e3256[0]) - (_e3250[0] * _e3256[2]));
                                let _e3268 = ((_e3250[0] * _e3256[1]) - (_e3250[1] * _e3256[0]));
                                let _e3271 = local_4[0u].member_1[0u];
                                let _e3277 = local_4[0u].member_2[1u];
                                let _e3292 = local_4[0u].member_1[1u];
                                let _e3298 = local_4[0u].member_2[0u];
                                let _e3311 = (((_e3271[1] * _e3277[2]) - (_e3271[2] * _e3277[1])) + ((_e3292[1] * _e3298[2]) - (_e3292[2] * _e3298[1])));
                                let _e3312 = (((_e3271[2] * _e3277[0]) - (_e3271[0] * _e3277[2])) + ((_e3292[2] * _e3298[0]) - (_e3292[0] * _e3298[2])));
                                let _e3313 = (((_e3271[0] * _e3277[1]) - (_e3271[1] * _e3277[0])) + ((_e3292[0] * _e3298[1]) - (_e3292[1] * _e3298[0])));
                                let _e3316 = local_4[0u].member[0u];
                                let _e3327 = local_4[0u].member[1u];
                                let _e3338 = local_4[0u].member[0u];
                                let _e3347 = ((((_e3327[0] * _e3241) + (_e3327[1] * _e3244)) + (_e3327[2] * _e3247)) + (((_e3338[0] * _e3311) + (_e3338[1] * _e3312)) + (_e3338[2] * _e3313)));
                                let _e3350 = local_4[0u].member[0u];
                                let _e3361 = local_4[0u].member[1u];
                                let _e3370 = ((((_e3350[0] * _e3262) + (_e3350[1] * _e3265)) + (_e3350[2] * _e3268)) + (((_e3361[0] * _e3311) + (_e3361[1] * _e3312)) + (_e3361[2] * _e3313)));
                                let _e3373 = local_4[0u].member[1u];
                                let _e3384 = local_4[0u].member[0u];
                                if (_e3384[0] < 0f) {
                                    phi_5175_ = -(_e3384[0]);
                                } else {
                                    phi_5175_ = _e3384[0];
                                }
                                let _e3391 = phi_5175_;
                                if (_e3384[1] < 0f) {
                                    phi_5182_ = -(_e3384[1]);
                                } else {
                                    phi_5182_ = _e3384[1];
                                }
                                let _e3395 = phi_5182_;
                                if (_e3391 > _e3395) {
                                    phi_5187_ = _e3391;
                                } else {
                                    phi_5187_ = _e3395;
                                }
                                let _e3398 = phi_5187_;
                                if (_e3384[2] < 0f) {
                                    phi_5194_ = -(_e3384[2]);
                                } else {
                                    phi_5194_ = _e3384[2];
                                }
                                let _e3402 = phi_5194_;
                                if (_e3398 > _e3402) {
                                    phi_5199_ = _e3398;
                                } else {
                                    phi_5199_ = _e3402;
                                }
                                let _e3405 = phi_5199_;
                                let _e3408 = local_4[0u].member[1u];
                                if (_e3408[0] < 0f) {
                                    phi_5212_ = -(_e3408[0]);
                                } else {
                                    phi_5212_ = _e3408[0];
                                }
                                let _e3415 = phi_5212_;
                                if (_e3408[1] < 0f) {
                                    phi_5219_ = -(_e3408[1]);
                                } else {
                                    phi_5219_ = _e3408[1];
                                }
                                let _e3419 = phi_5219_;
                                if (_e3415 > _e3419) {
                                    phi_5224_ = _e3415;
                                } else {
                                    phi_5224_ = _e3419;
                                }
                                let _e3422 = phi_5224_;
                                if (_e3408[2] < 0f) {
                                    phi_5231_ = -(_e3408[2]);
                                } else {
                                    phi_5231_ = _e3408[2];
                                }
                                let _e3426 = phi_5231_;
                                if (_e3422 > _e3426) {
                                    phi_5236_ = _e3422;
                                } else {
                                    phi_5236_ = _e3426;
                                }
                                let _e3429 = phi_5236_;
                                if (_e3405 > _e3429) {
                                    phi_5241_ = _e3405;
                                } else {
                                    phi_5241_ = _e3429;
                                }
                                let _e3432 = phi_5241_;
                                let _e3434 = local_4[0u].member_3;
                                let _e3435 = (_e3432 + _e3434);
                                let _e3438 = local_4[0u].member_1[0u];
                                if (_e3438[0] < 0f) {
                                    phi_5258_ = -(_e3438[0]);
                                } else {
                                    phi_5258_ = _e3438[0];
                                }
                                let _e3445 = phi_5258_;
                                if (_e3438[1] < 0f) {
                                    phi_5265_ = -(_e3438[1]);
                                } else {
                                    phi_5265_ = _e3438[1];
                                }
                                let _e3449 = phi_5265_;
                                if (_e3445 > _e3449) {
                                    phi_5270_ = _e3445;
                                } else {
                                    phi_5270_ = _e3449;
                                }
                                let _e3452 = phi_5270_;
                                if (_e3438[2] < 0f) {
                                    phi_5277_ = -(_e3438[2]);
                                } else {
                                    phi_5277_ = _e3438[2];
                                }
                                let _e3456 = phi_5277_;
                                if (_e3452 > _e3456) {
                                    phi_5282_ = _e3452;
                                } else {
                                    phi_5282_ = _e3456;
                                }
                                let _e3459 = phi_5282_;
                                let _e3462 = local_4[0u].member_1[1u];
                                if (_e3462[0] < 0f) {
                                    phi_5296_ = -(_e3462[0]);
                                } else {
                                    phi_5296_ = _e3462[0];
                                }
                                let _e3469 = phi_5296_;
                                if (_e3462[1] < 0f) {
                                    phi_5303_ = -(_e3462[1]);
                                } else {
                                    phi_5303_ = _e3462[1];
                                }
                                let _e3473 = phi_5303_;
                                if (_e3469 > _e3473) {
                                    phi_5308_ = _e3469;
                                } else {
                                    phi_5308_ = _e3473;
                                }
                                let _e3476 = phi_5308_;
                                if (_e3462[2] < 0f) {
                                    phi_5315_ = -(_e3462[2]);
                                } else {
                                    phi_5315_ = _e3462[2];
                                }
                                let _e3480 = phi_5315_;
                                if (_e3476 > _e3480) {
                                    phi_5320_ = _e3476;
                                } else {
                                    phi_5320_ = _e3480;
                                }
                                let _e3483 = phi_5320_;
                                if (_e3459 > _e3483) {
                                    phi_5325_ = _e3459;
                                } else {
                                    phi_5325_ = _e3483;
                                }
                                let _e3486 = phi_5325_;
                                let _e3488 = local_4[0u].member_3;
                                let _e3489 = (_e3486 + _e3488);
                                let _e3492 = local_4[0u].member_2[0u];
                                if (_e3492[0] < 0f) {
                                    phi_5342_ = -(_e3492[0]);
                                } else {
                                    phi_5342_ = _e3492[0];
                                }
                                let _e3499 = phi_5342_;
                                if (_e3492[1] < 0f) {
                                    phi_5349_ = -(_e3492[1]);
                                } else {
                                    phi_5349_ = _e3492[1];
                                }
                                let _e3503 = phi_5349_;
                                if (_e3499 > _e3503) {
                                    phi_5354_ = _e3499;
                                } else {
                                    phi_5354_ = _e3503;
                                }
                                let _e3506 = phi_5354_;
                                if (_e3492[2] < 0f) {
                                    phi_5361_ = -(_e3492[2]);
                                } else {
                                    phi_5361_ = _e3492[2];
                                }
                                let _e3510 = phi_5361_;
                                if (_e3506 > _e3510) {
                                    phi_5366_ = _e3506;
                                } else {
                                    phi_5366_ = _e3510;
                                }
                                let _e3513 = phi_5366_;
                                let _e3516 = local_4[0u].member_2[1u];
                                if (_e3516[0] < 0f) {
                                    phi_5380_ = -(_e3516[0]);
                                } else {
                                    phi_5380_ = _e3516[0];
                                }
                                let _e3523 = phi_5380_;
                                if (_e3516[1] < 0f) {
                                    phi_5387_ = -(_e3516[1]);
                                } else {
                                    phi_5387_ = _e3516[1];
                                }
                                let _e3527 = phi_5387_;
                                if (_e3523 > _e3527) {
                                    phi_5392_ = _e3523;
                                } else {
                                    phi_5392_ = _e3527;
                                }
                                let _e3530 = phi_5392_;
                                if (_e3516[2] < 0f) {
                                    phi_5399_ = -(_e3516[2]);
                                } else {
                                    phi_5399_ = _e3516[2];
                                }
                                let _e3534 = phi_5399_;
                                if (_e3530 > _e3534) {
                                    phi_5404_ = _e3530;
                                } else {
                                    phi_5404_ = _e3534;
                                }
                                let _e3537 = phi_5404_;
                                if (_e3513 > _e3537) {
                                    phi_5409_ = _e3513;
                                } else {
                                    phi_5409_ = _e3537;
                                }
                                let _e3540 = phi_5409_;
                                let _e3542 = local_4[0u].member_3;
                                let _e3543 = (_e3540 + _e3542);
                                let _e3545 = ((_e3489 * 8f) * _e3543);
                                let _e3552 = local_4[0u].member_3;
                                if (_e3241 < 0f) {
                                    phi_5440_ = -(_e3241);
                                } else {
                                    phi_5440_ = _e3241;
                                }
                                let _e3569 = phi_5440_;
                                if (_e3244 < 0f) {
                                    phi_5446_ = -(_e3244);
                                } else {
                                    phi_5446_ = _e3244;
                                }
                                let _e3573 = phi_5446_;
                                if (_e3247 < 0f) {
                                    phi_5453_ = -(_e3247);
                                } else {
                                    phi_5453_ = _e3247;
                                }
                                let _e3578 = phi_5453_;
                                let _e3579 = ((_e3569 + _e3573) + _e3578);
                                if (_e3262 < 0f) {
                                    phi_5460_ = -(_e3262);
                                } else {
                                    phi_5460_ = _e3262;
                                }
                                let _e3583 = phi_5460_;
                                if (_e3265 < 0f) {
                                    phi_5466_ = -(_e3265);
                                } else {
                                    phi_5466_ = _e3265;
                                }
                                let _e3587 = phi_5466_;
                                if (_e3268 < 0f) {
                                    phi_5473_ = -(_e3268);
                                } else {
                                    phi_5473_ = _e3268;
                                }
                                let _e3592 = phi_5473_;
                                let _e3593 = ((_e3583 + _e3587) + _e3592);
                                if (_e3579 > _e3593) {
                                    phi_5479_ = _e3579;
                                } else {
                                    phi_5479_ = _e3593;
                                }
                                let _e3596 = phi_5479_;
                                if (_e3311 < 0f) {
                                    phi_5485_ = -(_e3311);
                                } else {
                                    phi_5485_ = _e3311;
                                }
                                let _e3600 = phi_5485_;
                                if (_e3312 < 0f) {
                                    phi_5491_ = -(_e3312);
                                } else {
                                    phi_5491_ = _e3312;
                                }
                                let _e3604 = phi_5491_;
                                if (_e3313 < 0f) {
                                    phi_5498_ = -(_e3313);
                                } else {
                                    phi_5498_ = _e3313;
                                }
                                let _e3609 = phi_5498_;
                                let _e3611 = (((_e3600 + _e3604) + _e3609) * 0.5f);
                                if (_e3596 > _e3611) {
                                    phi_5505_ = _e3596;
                                } else {
                                    phi_5505_ = _e3611;
                                }
                                let _e3614 = phi_5505_;
                                let _e3619 = local_4[0u].member_3;
                                let _e3632 = ((((_e3316[0] * _e3241) + (_e3316[1] * _e3244)) + (_e3316[2] * _e3247)) * 3f);
                                let _e3633 = ((((_e3373[0] * _e3262) + (_e3373[1] * _e3265)) + (_e3373[2] * _e3268)) * 3f);
                                if (_e3632 < _e3633) {
                                    phi_5529_ = _e3632;
                                } else {
                                    phi_5529_ = _e3633;
                                }
                                let _e3636 = phi_5529_;
                                if (_e3347 < _e3370) {
                                    phi_5534_ = _e3347;
                                } else {
                                    phi_5534_ = _e3370;
                                }
                                let _e3639 = phi_5534_;
                                if (_e3636 < _e3639) {
                                    phi_5539_ = _e3636;
                                } else {
                                    phi_5539_ = _e3639;
                                }
                                let _e3642 = phi_5539_;
                                if (_e3632 > _e3633) {
                                    phi_5544_ = _e3632;
                                } else {
                                    phi_5544_ = _e3633;
                                }
                                let _e3645 = phi_5544_;
                                if (_e3347 > _e3370) {
                                    phi_5549_ = _e3347;
                                } else {
                                    phi_5549_ = _e3370;
                                }
                                let _e3648 = phi_5549_;
                                if (_e3645 > _e3648) {
                                    phi_5554_ = _e3645;
                                } else {
                                    phi_5554_ = _e3648;
                                }
                                let _e3651 = phi_5554_;
                                let _e3656 = -(_e3651);
                                if (_e3642 > _e3656) {
                                    phi_5564_ = _e3642;
                                } else {
                                    phi_5564_ = _e3656;
                                }
                                let _e3659 = phi_5564_;
                                if ((_e3659 - ((((((_e3435 * 8f) * _e3545) * (0.000000059604645f * (490f / 64f))) + ((_e3552 * 19f) * ((_e3435 * (_e3489 + _e3543)) + (_e3489 * _e3543)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3435) * ((1f + _e3489) * (1f + _e3543))))) + ((_e2116 * (((_e3614 + (_e3545 * (0.000000059604645f * 4f))) + ((_e3619 * 6f) * (_e3489 + _e3543))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3489) * (1f + _e3543))))) * (3f * 1.0001f)))) > 0f) {
                                    phi_6540_ = true;
                                } else {
                                    let _e3664 = local_4[0u].member_1[0u];
                                    let _e3670 = local_4[0u].member_1[1u];
                                    let _e3674 = (_e3664[0] + _e3670[0]);
                                    let _e3675 = (_e3664[1] + _e3670[1]);
                                    let _e3676 = (_e3664[2] + _e3670[2]);
                                    let _e3679 = local_4[0u].member_2[0u];
                                    let _e3685 = local_4[0u].member_2[1u];
                                    let _e3689 = (_e3679[0] + _e3685[0]);
                                    let _e3690 = (_e3679[1] + _e3685[1]);
                                    let _e3691 = (_e3679[2] + _e3685[2]);
                                    let _e3694 = ((_e3675 * _e3691) - (_e3676 * _e3690));
                                    let _e3697 = ((_e3676 * _e3689) - (_e3674 * _e3691));
                                    let _e3700 = ((_e3674 * _e3690) - (_e3675 * _e3689));
                                    let _e3703 = local_4[0u].member[0u];
                                    let _e3709 = local_4[0u].member_1[0u];
                                    let _e3715 = local_4[0u].member_2[0u];
                                    let _e3719 = (_e3703[0] - _e3709[0]);
                                    let _e3720 = (_e3703[1] - _e3709[1]);
                                    let _e3721 = (_e3703[2] - _e3709[2]);
                                    let _e3730 = local_4[0u].member[1u];
                                    let _e3736 = local_4[0u].member_1[1u];
                                    let _e3742 = local_4[0u].member_2[1u];
                                    let _e3746 = (_e3730[0] - _e3736[0]);
                                    let _e3747 = (_e3730[1] - _e3736[1]);
                                    let _e3748 = (_e3730[2] - _e3736[2]);
                                    local_2 = array<array<f32, 3>, 4>(_e3703, array<f32, 3>(_e3719, _e3720, _e3721), array<f32, 3>((_e3703[0] - _e3715[0]), (_e3703[1] - _e3715[1]), (_e3703[2] - _e3715[2])), array<f32, 3>((_e3719 - _e3715[0]), (_e3720 - _e3715[1]), (_e3721 - _e3715[2])));
                                    local_3 = array<array<f32, 3>, 4>(_e3730, array<f32, 3>(_e3746, _e3747, _e3748), array<f32, 3>((_e3730[0] - _e3742[0]), (_e3730[1] - _e3742[1]), (_e3730[2] - _e3742[2])), array<f32, 3>((_e3746 - _e3742[0]), (_e3747 - _e3742[1]), (_e3748 - _e3742[2])));
                                    let _e3765 = local_4[0u].member[0u];
                                    if (_e3765[0] < 0f) {
                                        phi_5815_ = -(_e3765[0]);
                                    } else {
                                        phi_5815_ = _e3765[0];
                                    }
                                    let _e3772 = phi_5815_;
                                    if (_e3765[1] < 0f) {
                                        phi_5822_ = -(_e3765[1]);
                                    } else {
                                        phi_5822_ = _e3765[1];
                                    }
                                    let _e3776 = phi_5822_;
                                    if (_e3772 > _e3776) {
                                        phi_5827_ = _e3772;
                                    } else {
                                        phi_5827_ = _e3776;
                                    }
                                    let _e3779 = phi_5827_;
                                    if (_e3765[2] < 0f) {
                                        phi_5834_ = -(_e3765[2]);
                                    } else {
                                        phi_5834_ = _e3765[2];
                                    }
                                    let _e3783 = phi_5834_;
                                    if (_e3779 > _e3783) {
                                        phi_5839_ = _e3779;
                                    } else {
                                        phi_5839_ = _e3783;
                                    }
                                    let _e3786 = phi_5839_;
                                    let _e3789 = local_4[0u].member[1u];
                                    if (_e3789[0] < 0f) {
                                        phi_5852_ = -(_e3789[0]);
                                    } else {
                                        phi_5852_ = _e3789[0];
                                    }
                                    let _e3796 = phi_5852_;
                                    if (_e3789[1] < 0f) {
                                        phi_5859_ = -(_e3789[1]);
                                    } else {
                                        phi_5859_ = _e3789[1];
                                    }
                                    let _e3800 = phi_5859_;
                                    if (_e3796 > _e3800) {
                                        phi_5864_ = _e3796;
                                    } else {
                                        phi_5864_ = _e3800;
                                    }
                                    let _e3803 = phi_5864_;
                                    if (_e3789[2] < 0f) {
                                        phi_5871_ = -(_e3789[2]);
                                    } else {
                                        phi_5871_ = _e3789[2];
                                    }
                                    let _e3807 = phi_5871_;
                                    if (_e3803 > _e3807) {
                                        phi_5876_ = _e3803;
                                    } else {
                                        phi_5876_ = _e3807;
                                    }
                                    let _e3810 = phi_5876_;
                                    if (_e3786 > _e3810) {
                                        phi_5881_ = _e3786;
                                    } else {
                                        phi_5881_ = _e3810;
                                    }
                                    let _e3813 = phi_5881_;
                                    let _e3815 = local_4[0u].member_3;
                                    let _e3819 = local_4[0u].member_1[0u];
                                    if (_e3819[0] < 0f) {
                                        phi_5898_ = -(_e3819[0]);
                                    } else {
                                        phi_5898_ = _e3819[0];
                                    }
                                    let _e3826 = phi_5898_;
                                    if (_e3819[1] < 0f) {
                                        phi_5905_ = -(_e3819[1]);
                                    } else {
                                        phi_5905_ = _e3819[1];
                                    }
                                    let _e3830 = phi_5905_;
                                    if (_e3826 > _e3830) {
                                        phi_5910_ = _e3826;
                                    } else {
                                        phi_5910_ = _e3830;
                                    }
                                    let _e3833 = phi_5910_;
                                    if (_e3819[2] < 0f) {
                                        phi_5917_ = -(_e3819[2]);
                                    } else {
                                        phi_5917_ = _e3819[2];
                                    }
                                    let _e3837 = phi_5917_;
                                    if (_e3833 > _e3837) {
                                        phi_5922_ = _e3833;
                                    } else {
                                        phi_5922_ = _e3837;
                                    }
                                    let _e3840 = phi_5922_;
                                    let _e3843 = local_4[0u].member_1[1u];
                                    if (_e3843[0] < 0f) {
                                        phi_5936_ = -(_e3843[0]);
                                    } else {
                                        phi_5936_ = _e3843[0];
                                    }
                                    let _e3850 = phi_5936_;
                                    if (_e3843[1] < 0f) {
                                        phi_5943_ = -(_e3843[1]);
                                    } else {
                                        phi_5943_ = _e3843[1];
                                    }
                                    let _e3854 = phi_5943_;
                                    if (_e3850 > _e3854) {
                                        phi_5948_ = _e3850;
                                    } else {
                                        phi_5948_ = _e3854;
                                    }
                                    let _e3857 = phi_5948_;
                                    if (_e3843[2] < 0f) {
                                        phi_5955_ = -(_e3843[2]);
                                    } else {
                                        phi_5955_ = _e3843[2];
                                    }
                                    let _e3861 = phi_5955_;
                                    if (_e3857 > _e3861) {
                                        phi_5960_ = _e3857;
                                    } else {
                                        phi_5960_ = _e3861;
                                    }
                                    let _e3864 = phi_5960_;
                                    if (_e3840 > _e3864) {
                                        phi_5965_ = _e3840;
                                    } else {
                                        phi_5965_ = _e3864;
                                    }
                                    let _e3867 = phi_5965_;
                                    let _e3869 = local_4[0u].member_3;
                                    let _e3873 = local_4[0u].member_2[0u];
                                    if (_e3873[0] < 0f) {
                                        phi_5982_ = -(_e3873[0]);
                                    } else {
                                        phi_5982_ = _e3873[0];
                                    }
                                    let _e3880 = phi_5982_;
                                    if (_e3873[1] < 0f) {
                                        phi_5989_ = -(_e3873[1]);
                                    } else {
                                        phi_5989_ = _e3873[1];
                                    }
                                    let _e3884 = phi_5989_;
                                    if (_e3880 > _e3884) {
                                        phi_5994_ = _e3880;
                                    } else {
                                        phi_5994_ = _e3884;
                                    }
                                    let _e3887 = phi_5994_;
                                    if (_e3873[2] < 0f) {
                                        phi_6001_ = -(_e3873[2]);
                                    } else {
                                        phi_6001_ = _e3873[2];
                                    }
                                    let _e3891 = phi_6001_;
                                    if (_e3887 > _e3891) {
                                        phi_6006_ = _e3887;
                                    } else {
                                        phi_6006_ = _e3891;
                                    }
                                    let _e3894 = phi_6006_;
                                    let _e3897 = local_4[0u].member_2[1u];
                                    if (_e3897[0] < 0f) {
                                        phi_6020_ = -(_e3897[0]);
                                    } else {
                                        phi_6020_ = _e3897[0];
                                    }
                                    let _e3904 = phi_6020_;
                                    if (_e3897[1] < 0f) {
                                        phi_6027_ = -(_e3897[1]);
                                    } else {
                                        phi_6027_ = _e3897[1];
                                    }
                                    let _e3908 = phi_6027_;
                                    if (_e3904 > _e3908) {
                                        phi_6032_ = _e3904;
                                    } else {
                                        phi_6032_ = _e3908;
                                    }
                                    let _e3911 = phi_6032_;
                                    if (_e3897[2] < 0f) {
                                        phi_6039_ = -(_e3897[2]);
                                    } else {
                                        phi_6039_ = _e3897[2];
                                    }
                                    let _e3915 = phi_6039_;
                                    if (_e3911 > _e3915) {
                                        phi_6044_ = _e3911;
                                    } else {
                                        phi_6044_ = _e3915;
                                    }
                                    let _e3918 = phi_6044_;
                                    if (_e3894 > _e3918) {
                                        phi_6049_ = _e3894;
                                    } else {
                                        phi_6049_ = _e3918;
                                    }
                                    let _e3921 = phi_6049_;
                                    let _e3923 = local_4[0u].member_3;
                                    let _e3926 = (((_e3813 + _e3815) + (_e3867 + _e3869)) + (_e3921 + _e3923));
                                    let _e3929 = local_4[0u].member_3;
                                    let _e3933 = (((_e2116 * 1.0001f) + (_e3929 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3936 = ((_e3697 * _e3676) - (_e3700 * _e3675));
                                    let _e3939 = ((_e3700 * _e3674) - (_e3694 * _e3676));
                                    let _e3942 = ((_e3694 * _e3675) - (_e3697 * _e3674));
                                    let _e3944 = local_2[0u];
                                    let _e3952 = (((_e3936 * _e3944[0]) + (_e3939 * _e3944[1])) + (_e3942 * _e3944[2]));
                                    phi_6087_ = type_36(0u, 4u);
                                    phi_6090_ = _e3952;
                                    phi_6092_ = _e3952;
                                    loop {
                                        let _e3954 = phi_6087_;
                                        let _e3956 = phi_6090_;
                                        let _e3958 = phi_6092_;
                                        local_56 = _e3956;
                                        local_57 = _e3958;
                                        local_69 = _e3958;
                                        if (_e3954.member < _e3954.member_1) {
                                            phi_6088_ = type_36((_e3954.member + 1u), _e3954.member_1);
                                            phi_6115_ = type_36(1u, _e3954.member);
                                        } else {
                                            phi_6088_ = _e3954;
                                            phi_6115_ = type_36(0u, type_36().member_1);
                                        }
                                        let _e3972 = phi_6088_;
                                        let _e3974 = phi_6115_;
                                        let _e3978 = (bitcast<i32>(_e3974.member) != 0i);
                                        if _e3978 {
                                            if (_e3974.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3981 = local_2[_e3974.member_1];
                                            let _e3989 = (((_e3936 * _e3981[0]) + (_e3939 * _e3981[1])) + (_e3942 * _e3981[2]));
                                            if (_e3974.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3992 = local_3[_e3974.member_1];
                                            let _e4000 = (((_e3936 * _e3992[0]) + (_e3939 * _e3992[1])) + (_e3942 * _e3992[2]));
                                            if (_e3958 < _e3989) {
                                                phi_6165_ = _e3958;
                                            } else {
                                                phi_6165_ = _e3989;
                                            }
                                            let _e4003 = phi_6165_;
                                            if (_e4003 < _e4000) {
                                                phi_6170_ = _e4003;
                                            } else {
                                                phi_6170_ = _e4000;
                                            }
                                            let _e4006 = phi_6170_;
                                            if (_e3956 > _e3989) {
                                                phi_6175_ = _e3956;
                                            } else {
                                                phi_6175_ = _e3989;
                                            }
                                            let _e4009 = phi_6175_;
                                            if (_e4009 > _e4000) {
                                                phi_6180_ = _e4009;
                                            } else {
                                                phi_6180_ = _e4000;
                                            }
                                            let _e4012 = phi_6180_;
                                            phi_6091_ = _e4012;
                                            phi_6093_ = _e4006;
                                        } else {
                                            phi_6091_ = f32();
                                            phi_6093_ = f32();
                                        }
                                        let _e4014 = phi_6091_;
                                        let _e4016 = phi_6093_;
                                        continue;
                                        continuing {
                                            phi_6087_ = _e3972;
                                            phi_6090_ = _e4014;
                                            phi_6092_ = _e4016;
                                            break if !(_e3978);
                                        }
                                    }
                                    if (_e3936 < 0f) {
                                        phi_6186_ = -(_e3936);
                                    } else {
                                        phi_6186_ = _e3936;
                                    }
                                    let _e4021 = phi_6186_;
                                    if (_e3939 < 0f) {
                                        phi_6192_ = -(_e3939);
                                    } else {
                                        phi_6192_ = _e3939;
                                    }
                                    let _e4025 = phi_6192_;
                                    if (_e3942 < 0f) {
                                        phi_6199_ = -(_e3942);
                                    } else {
                                        phi_6199_ = _e3942;
                                    }
                                    let _e4030 = phi_6199_;
                                    let _e4031 = ((_e4021 + _e4025) + _e4030);
                                    let _e4036 = local_56;
                                    let _e4037 = -(_e4036);
                                    let _e4039 = local_57;
                                    if (_e4039 > _e4037) {
                                        let _e5667 = local_69;
                                        phi_6209_ = _e5667;
                                    } else {
                                        phi_6209_ = _e4037;
                                    }
                                    let _e4042 = phi_6209_;
                                    let _e4047 = (((_e4042 - ((_e4031 * _e3926) * (0.000000059604645f * 17f))) - (_e4031 * _e3933)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e4050 = ((_e3697 * _e3691) - (_e3700 * _e3690));
                                    let _e4053 = ((_e3700 * _e3689) - (_e3694 * _e3691));
                                    let _e4056 = ((_e3694 * _e3690) - (_e3697 * _e3689));
                                    let _e4058 = local_2[0u];
                                    let _e4066 = (((_e4050 * _e4058[0]) + (_e4053 * _e4058[1])) + (_e4056 * _e4058[2]));
                                    phi_6240_ = type_36(0u, 4u);
                                    phi_6243_ = _e4066;
                                    phi_6245_ = _e4066;
                                    loop {
                                        let _e4068 = phi_6240_;
                                        let _e4070 = phi_6243_;
                                        let _e4072 = phi_6245_;
                                        local_58 = _e4070;
                                        local_59 = _e4072;
                                        local_70 = _e4072;
                                        if (_e4068.member < _e4068.member_1) {
                                            phi_6241_ = type_36((_e4068.member + 1u), _e4068.member_1);
                                            phi_6268_ = type_36(1u, _e4068.member);
                                        } else {
                                            phi_6241_ = _e4068;
                                            phi_6268_ = type_36(0u, type_36().member_1);
                                        }
                                        let _e4086 = phi_6241_;
                                        let _e4088 = phi_6268_;
                                        let _e4092 = (bitcast<i32>(_e4088.member) != 0i);
                                        if _e4092 {
                                            if (_e4088.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e4095 = local_2[_e4088.member_1];
                                            let _e4103 = (((_e4050 * _e4095[0]) + (_e4053 * _e4095[1])) + (_e4056 * _e4095[2]));
                                            if (_e4088.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e4106 = local_3[_e4088.member_1];
                                            let _e4114 = (((_e4050 * _e4106[0]) + (_e4053 * _e4106[1])) + (_e4056 * _e4106[2]));
                                            if (_e4072 < _e4103) {
                                                phi_6318_ = _e4072;
                                            } else {
                                                phi_6318_ = _e4103;
                                            }
                                            let _e4117 = phi_6318_;
                                            if (_e4117 < _e4114) {
                                                phi_6323_ = _e4117;
                                            } else {
                                                phi_6323_ = _e4114;
                                            }
                                            let _e4120 = phi_6323_;
                                            if (_e4070 > _e4103) {
                                                phi_6328_ = _e4070;
                                            } else {
                                                phi_6328_ = _e4103;
                                            }
                                            let _e4123 = phi_6328_;
                                            if (_e4123 > _e4114) {
                                                phi_6333_ = _e4123;
                                            } else {
                                                phi_6333_ = _e4114;
                                            }
                                            let _e4126 = phi_6333_;
                                            phi_6244_ = _e4126;
                                            phi_6246_ = _e4120;
                                        } else {
                                            phi_6244_ = f32();
                                            phi_6246_ = f32();
                                        }
                                        let _e4128 = phi_6244_;
                                        let _e4130 = phi_6246_;
                                        continue;
                                        continuing {
                                            phi_6240_ = _e4086;
                                            phi_6243_ = _e4128;
                                            phi_6245_ = _e4130;
                                            break if !(_e4092);
                                        }
                                    }
                                    if (_e4050 < 0f) {
                                        phi_6339_ = -(_e4050);
                                    } else {
                                        phi_6339_ = _e4050;
                                    }
                                    let _e4135 = phi_6339_;
                                    if (_e4053 < 0f) {
                                        phi_6345_ = -(_e4053);
                                    } else {
                                        phi_6345_ = _e4053;
                                    }
                                    let _e4139 = phi_6345_;
                                    if (_e4056 < 0f) {
                                        phi_6352_ = -(_e4056);
                                    } else {
                                        phi_6352_ = _e4056;
                                    }
                                    let _e4144 = phi_6352_;
                                    let _e4145 = ((_e4135 + _e4139) + _e4144);
                                    let _e4150 = local_58;
                                    let _e4151 = -(_e4150);
                                    let _e4153 = local_59;
                                    if (_e4153 > _e4151) {
                                        let _e5686 = local_70;
                                        phi_6362_ = _e5686;
                                    } else {
                                        phi_6362_ = _e4151;
                                    }
                                    let _e4156 = phi_6362_;
                                    let _e4161 = (((_e4156 - ((_e4145 * _e3926) * (0.000000059604645f * 17f))) - (_e4145 * _e3933)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e4047 > _e4161) {
                                        phi_6372_ = _e4047;
                                    } else {
                                        phi_6372_ = _e4161;
                                    }
                                    let _e4164 = phi_6372_;
                                    phi_6540_ = (_e4164 > 0f);
                                }
                                let _e4167 = phi_6540_;
                                if _e4167 {
                                    let _e4171 = local_4[1u].member_1[0u];
                                    let _e4177 = local_4[1u].member_2[0u];
                                    let _e4183 = ((_e4171[1] * _e4177[2]) - (_e4171[2] * _e4177[1]));
                                    let _e4186 = ((_e4171[2] * _e4177[0]) - (_e4171[0] * _e4177[2]));
                                    let _e4189 = ((_e4171[0] * _e4177[1]) - (_e4171[1] * _e4177[0]));
                                    let _e4192 = local_4[1u].member_1[1u];
                                    let _e4198 = local_4[1u].member_2[1u];
                                    let _e4204 = ((_e4192[1] * _e4198[2]) - (_e4192[2] * _e4198[1]));
                                    let _e4207 = ((_e4192[2] * _e4198[0]) - (_e4192[0] * _e4198[2]));
                                    let _e4210 = ((_e4192[0] * _e4198[1]) - (_e4192[1] * _e4198[0]));
                                    let _e4213 = local_4[1u].member_1[0u];
                                    let _e4219 = local_4[1u].member_2[1u];
                                    let _e4234 = local_4[1u].member_1[1u];
                                    let _e4240 = local_4[1u].member_2[0u];
                                    let _e4253 = (((_e4213[1] * _e4219[2]) - (_e4213[2] * _e4219[1])) + ((_e4234[1] * _e4240[2]) - (_e4234[2] * _e4240[1])));
                                    let _e4254 = (((_e4213[2] * _e4219[0]) - (_e4213[0] * _e4219[2])) + ((_e4234[2] * _e4240[0]) - (_e4234[0] * _e4240[2])));
                                    let _e4255 = (((_e4213[0] * _e4219[1]) - (_e4213[1] * _e4219[0])) + ((_e4234[0] * _e4240[1]) - (_e4234[1] * _e4240[0])));
                                    let _e4258 = local_4[1u].member[0u];
                                    let _e4269 = local_4[1u].member[1u];
                                    let _e4280 = local_4[1u].member[0u];
                                    let _e4289 = ((((_e4269[0] * _e4183) + (_e4269[1] * _e4186)) + (_e4269[2] * _e4189)) + (((_e4280[0] * _e4253) + (_e4280[1] * _e4254)) + (_e4280[2] * _e4255)));
                                    let _e4292 = local_4[1u].member[0u];
                                    let _e4303 = local_4[1u].member[1u];
                                    let _e4312 = ((((_e4292[0] * _e4204) + (_e4292[1] * _e4207)) + (_e4292[2] * _e4210)) + (((_e4303[0] * _e4253) + (_e4303[1] * _e4254)) + (_e4303[2] * _e4255)));
                                    let _e4315 = local_4[1u].member[1u];
                                    let _e4326 = local_4[1u].member[0u];
                                    if (_e4326[0] < 0f) {
                                        phi_6786_ = -(_e4326[0]);
                                    } else {
                                        phi_6786_ = _e4326[0];
                                    }
                                    let _e4333 = phi_6786_;
                                    if (_e4326[1] < 0f) {
                                        phi_6793_ = -(_e4326[1]);
                                    } else {
                                        phi_6793_ = _e4326[1];
                                    }
                                    let _e4337 = phi_6793_;
                                    if (_e4333 > _e4337) {
                                        phi_6798_ = _e4333;
                                    } else {
                                        phi_6798_ = _e4337;
                                    }
                                    let _e4340 = phi_6798_;
                                    if (_e4326[2] < 0f) {
                                        phi_6805_ = -(_e4326[2]);
                                    } else {
                                        phi_6805_ = _e4326[2];
                                    }
                                    let _e4344 = phi_6805_;
                                    if (_e4340 > _e4344) {
                                        phi_6810_ = _e4340;
                                    } else {
                                        phi_6810_ = _e4344;
                                    }
                                    let _e4347 = phi_6810_;
                                    let _e4350 = local_4[1u].member[1u];
                                    if (_e4350[0] < 0f) {
                                        phi_6823_ = -(_e4350[0]);
                                    } else {
                                        phi_6823_ = _e4350[0];
                                    }
                                    let _e4357 = phi_6823_;
                                    if (_e4350[1] < 0f) {
                                        phi_6830_ = -(_e4350[1]);
                                    } else {
                                        phi_6830_ = _e4350[1];
                                    }
                                    let _e4361 = phi_6830_;
                                    if (_e4357 > _e4361) {
                                        phi_6835_ = _e4357;
                                    } else {
                                        phi_6835_ = _e4361;
                                    }
                                    let _e4364 = phi_6835_;
                                    if (_e4350[2] < 0f) {
                                        phi_6842_ = -(_e4350[2]);
                                    } else {
                                        phi_6842_ = _e4350[2];
                                    }
                                    let _e4368 = phi_6842_;
                                    if (_e4364 > _e4368) {
                                        phi_6847_ = _e4364;
                                    } else {
                                        phi_6847_ = _e4368;
                                    }
                                    let _e4371 = phi_6847_;
                                    if (_e4347 > _e4371) {
                                        phi_6852_ = _e4347;
                                    } else {
                                        phi_6852_ = _e4371;
                                    }
                                    let _e4374 = phi_6852_;
                                    let _e4376 = local_4[1u].member_3;
                                    let _e4377 = (_e4374 + _e4376);
                                    let _e4380 = local_4[1u].member_1[0u];
                                    if (_e4380[0] < 0f) {
                                        phi_6869_ = -(_e4380[0]);
                                    } else {
                                        phi_6869_ = _e4380[0];
                                    }
                                    let _e4387 = phi_6869_;
                                    if (_e4380[1] < 0f) {
                                        phi_6876_ = -(_e4380[1]);
                                    } else {
                                        phi_6876_ = _e4380[1];
                                    }
                                    let _e4391 = phi_6876_;
                                    if (_e4387 > _e4391) {
                                        phi_6881_ = _e4387;
                                    } else {
                                        phi_6881_ = _e4391;
                                    }
                                    let _e4394 = phi_6881_;
                                    if (_e4380[2] < 0f) {
                                        phi_6888_ = -(_e4380[2]);
                                    } else {
                                        phi_6888_ = _e4380[2];
                                    }
                                    let _e4398 = phi_6888_;
                                    if (_e4394 > _e4398) {
                                        phi_6893_ = _e4394;
                                    } else {
                                        phi_6893_ = _e4398;
                                    }
                                    let _e4401 = phi_6893_;
                                    let _e4404 = local_4[1u].member_1[1u];
                                    if (_e4404[0] < 0f) {
                                        phi_6907_ = -(_e4404[0]);
                                    } else {
                                        phi_6907_ = _e4404[0];
                                    }
                                    let _e4411 = phi_6907_;
                                    if (_e4404[1] < 0f) {
                                        phi_6914_ = -(_e4404[1]);
                                    } else {
                                        phi_6914_ = _e4404[1];
                                    }
                                    let _e4415 = phi_6914_;
                                    if (_e4411 > _e4415) {
                                        phi_6919_ = _e4411;
                                    } else {
                                        phi_6919_ = _e4415;
                                    }
                                    let _e4418 = phi_6919_;
                                    if (_e4404[2] < 0f) {
                                        phi_6926_ = -(_e4404[2]);
                                    } else {
                                        phi_6926_ = _e4404[2];
                                    }
                                    let _e4422 = phi_6926_;
                                    if (_e4418 > _e4422) {
                                        phi_6931_ = _e4418;
                                    } else {
                                        phi_6931_ = _e4422;
                                    }
                                    let _e4425 = phi_6931_;
                                    if (_e4401 > _e4425) {
                                        phi_6936_ = _e4401;
                                    } else {
                                        phi_6936_ = _e4425;
                                    }
                                    let _e4428 = phi_6936_;
                                    let _e4430 = local_4[1u].member_3;
                                    let _e4431 = (_e4428 + _e4430);
                                    let _e4434 = local_4[1u].member_2[0u];
                                    if (_e4434[0] < 0f) {
                                        phi_6953_ = -(_e4434[0]);
                                    } else {
                                        phi_6953_ = _e4434[0];
                                    }
                                    let _e4441 = phi_6953_;
                                    if (_e4434[1] < 0f) {
                                        phi_6960_ = -(_e4434[1]);
                                    } else {
                                        phi_6960_ = _e4434[1];
                                    }
                                    let _e4445 = phi_6960_;
                                    if (_e4441 > _e4445) {
                                        phi_6965_ = _e4441;
                                    } else {
                                        phi_6965_ = _e4445;
                                    }
                                    let _e4448 = phi_6965_;
                                    if (_e4434[2] < 0f) {
                                        phi_6972_ = -(_e4434[2]);
                                    } else {
                                        phi_6972_ = _e4434[2];
                                    }
                                    let _e4452 = phi_6972_;
                                    if (_e4448 > _e4452) {
                                        phi_6977_ = _e4448;
                                    } else {
                                        phi_6977_ = _e4452;
                                    }
                                    let _e4455 = phi_6977_;
                                    let _e4458 = local_4[1u].member_2[1u];
                                    if (_e4458[0] < 0f) {
                                        phi_6991_ = -(_e4458[0]);
                                    } else {
                                        phi_6991_ = _e4458[0];
                                    }
                                    let _e4465 = phi_6991_;
                                    if (_e4458[1] < 0f) {
                                        phi_6998_ = -(_e4458[1]);
                                    } else {
                                        phi_6998_ = _e4458[1];
                                    }
                                    let _e4469 = phi_6998_;
                                    if (_e4465 > _e4469) {
                                        phi_7003_ = _e4465;
                                    } else {
                                        phi_7003_ = _e4469;
                                    }
                                    let _e4472 = phi_7003_;
                                    if (_e4458[2] < 0f) {
                                        phi_7010_ = -(_e4458[2]);
                                    } else {
                                        phi_7010_ = _e4458[2];
                                    }
                                    let _e4476 = phi_7010_;
                                    if (_e4472 > _e4476) {
                                        phi_7015_ = _e4472;
                                    } else {
                                        phi_7015_ = _e4476;
                                    }
                                    let _e4479 = phi_7015_;
                                    if (_e4455 > _e4479) {
                                        phi_7020_ = _e4455;
                                    } else {
                                        phi_7020_ = _e4479;
                                    }
                                    let _e4482 = phi_7020_;
                                    let _e4484 = local_4[1u].member_3;
                                    let _e4485 = (_e4482 + _e4484);
                                    let _e4487 = ((_e4431 * 8f) * _e4485);
                                    let _e4494 = local_4[1u].member_3;
                                    if (_e4183 < 0f) {
                                        phi_7051_ = -(_e4183);
                                    } else {
                                        phi_7051_ = _e4183;
                                    }
                                    let _e4511 = phi_7051_;
                                    if (_e4186 < 0f) {
                                        phi_7057_ = -(_e4186);
                                    } else {
                                        phi_7057_ = _e4186;
                                    }
                                    let _e4515 = phi_7057_;
                                    if (_e4189 < 0f) {
                                        phi_7064_ = -(_e4189);
                                    } else {
                                        phi_7064_ = _e4189;
                                    }
                                    let _e4520 = phi_7064_;
                                    let _e4521 = ((_e4511 + _e4515) + _e4520);
                                    if (_e4204 < 0f) {
                                        phi_7071_ = -(_e4204);
                                    } else {
                                        phi_7071_ = _e4204;
                                    }
                                    let _e4525 = phi_7071_;
                                    if (_e4207 < 0f) {
                                        phi_7077_ = -(_e4207);
                                    } else {
                                        phi_7077_ = _e4207;
                                    }
                                    let _e4529 = phi_7077_;
                                    if (_e4210 < 0f) {
                                        phi_7084_ = -(_e4210);
                                    } else {
                                        phi_7084_ = _e4210;
                                    }
                                    let _e4534 = phi_7084_;
                                    let _e4535 = ((_e4525 + _e4529) + _e4534);
                                    if (_e4521 > _e4535) {
                                        phi_7090_ = _e4521;
                                    } else {
                                        phi_7090_ = _e4535;
                                    }
                                    let _e4538 = phi_7090_;
                                    if (_e4253 < 0f) {
                                        phi_7096_ = -(_e4253);
                                    } else {
                                        phi_7096_ = _e4253;
                                    }
                                    let _e4542 = phi_7096_;
                                    if (_e4254 < 0f) {
                                        phi_7102_ = -(_e4254);
                                    } else {
                                        phi_7102_ = _e4254;
                                    }
                                    let _e4546 = phi_7102_;
                                    if (_e4255 < 0f) {
                                        phi_7109_ = -(_e4255);
                                    } else {
                                        phi_7109_ = _e4255;
                                    }
                                    let _e4551 = phi_7109_;
                                    let _e4553 = (((_e4542 + _e4546) + _e4551) * 0.5f);
                                    if (_e4538 > _e4553) {
                                        phi_7116_ = _e4538;
                                    } else {
                                        phi_7116_ = _e4553;
                                    }
                                    let _e4556 = phi_7116_;
                                    let _e4561 = local_4[1u].member_3;
                                    let _e4574 = ((((_e4258[0] * _e4183) + (_e4258[1] * _e4186)) + (_e4258[2] * _e4189)) * 3f);
                                    let _e4575 = ((((_e4315[0] * _e4204) + (_e4315[1] * _e4207)) + (_e4315[2] * _e4210)) * 3f);
                                    if (_e4574 < _e4575) {
                                        phi_7140_ = _e4574;
                                    } else {
                                        phi_7140_ = _e4575;
                                    }
                                    let _e4578 = phi_7140_;
                                    if (_e4289 < _e4312) {
                                        phi_7145_ = _e4289;
                                    } else {
                                        phi_7145_ = _e4312;
                                    }
                                    let _e4581 = phi_7145_;
                                    if (_e4578 < _e4581) {
                                        phi_7150_ = _e4578;
                                    } else {
                                        phi_7150_ = _e4581;
                                    }
                                    let _e4584 = phi_7150_;
                                    if (_e4574 > _e4575) {
                                        phi_7155_ = _e4574;
                                    } else {
                                        phi_7155_ = _e4575;
                                    }
                                    let _e4587 = phi_7155_;
                                    if (_e4289 > _e4312) {
                                        phi_7160_ = _e4289;
                                    } else {
                                        phi_7160_ = _e4312;
                                    }
                                    let _e4590 = phi_7160_;
                                    if (_e4587 > _e4590) {
                                        phi_7165_ = _e4587;
                                    } else {
                                        phi_7165_ = _e4590;
                                    }
                                    let _e4593 = phi_7165_;
                                    let _e4598 = -(_e4593);
                                    if (_e4584 > _e4598) {
                                        phi_7175_ = _e4584;
                                    } else {
                                        phi_7175_ = _e4598;
                                    }
                                    let _e4601 = phi_7175_;
                                    if ((_e4601 - ((((((_e4377 * 8f) * _e4487) * (0.000000059604645f * (490f / 64f))) + ((_e4494 * 19f) * ((_e4377 * (_e4431 + _e4485)) + (_e4431 * _e4485)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4377) * ((1f + _e4431) * (1f + _e4485))))) + ((_e2116 * (((_e4556 + (_e4487 * (0.000000059604645f * 4f))) + ((_e4561 * 6f) * (_e4431 + _e4485))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4431) * (1f + _e4485))))) * (3f * 1.0001f)))) > 0f) {
                                        phi_8151_ = true;
                                    } else {
                                        let _e4606 = local_4[1u].member_1[0u];
                                        let _e4612 = local_4[1u].member_1[1u];
                                        let _e4616 = (_e4606[0] + _e4612[0]);
                                        let _e4617 = (_e4606[1] + _e4612[1]);
                                        let _e4618 = (_e4606[2] + _e4612[2]);
                                        let _e4621 = local_4[1u].member_2[0u];
                                        let _e4627 = local_4[1u].member_2[1u];
                                        let _e4631 = (_e4621[0] + _e4627[0]);
                                        let _e4632 = (_e4621[1] + _e4627[1]);
                                        let _e4633 = (_e4621[2] + _e4627[2]);
                                        let _e4636 = ((_e4617 * _e4633) - (_e4618 * _e4632));
                                        let _e4639 = ((_e4618 * _e4631) - (_e4616 * _e4633));
                                        let _e4642 = ((_e4616 * _e4632) - (_e4617 * _e4631));
                                        let _e4645 = local_4[1u].member[0u];
                                        let _e4651 = local_4[1u].member_1[0u];
                                        let _e4657 = local_4[1u].member_2[0u];
                                        let _e4661 = (_e4645[0] - _e4651[0]);
                                        let _e4662 = (_e4645[1] - _e4651[1]);
                                        let _e4663 = (_e4645[2] - _e4651[2]);
                                        let _e4672 = local_4[1u].member[1u];
                                        let _e4678 = local_4[1u].member_1[1u];
                                        let _e4684 = local_4[1u].member_2[1u];
                                        let _e4688 = (_e4672[0] - _e4678[0]);
                                        let _e4689 = (_e4672[1] - _e4678[1]);
                                        let _e4690 = (_e4672[2] - _e4678[2]);
                                        local = array<array<f32, 3>, 4>(_e4645, array<f32, 3>(_e4661, _e4662, _e4663), array<f32, 3>((_e4645[0] - _e4657[0]), (_e4645[1] - _e4657[1]), (_e4645[2] - _e4657[2])), array<f32, 3>((_e4661 - _e4657[0]), (_e4662 - _e4657[1]), (_e4663 - _e4657[2])));
                                        local_1 = array<array<f32, 3>, 4>(_e4672, array<f32, 3>(_e4688, _e4689, _e4690), array<f32, 3>((_e4672[0] - _e4684[0]), (_e4672[1] - _e4684[1]), (_e4672[2] - _e4684[2])), array<f32, 3>((_e4688 - _e4684[0]), (_e4689 - _e4684[1]), (_e4690 - _e4684[2])));
                                        let _e4707 = local_4[1u].member[0u];
                                        if (_e4707[0] < 0f) {
                                            phi_7426_ = -(_e4707[0]);
                                        } else {
                                            phi_7426_ = _e4707[0];
                                        }
                                        let _e4714 = phi_7426_;
                                        if (_e4707[1] < 0f) {
                                            phi_7433_ = -(_e4707[1]);
                                        } else {
                                            phi_7433_ = _e4707[1];
                                        }
                                        let _e4718 = phi_7433_;
                                        if (_e4714 > _e4718) {
                                            phi_7438_ = _e4714;
                                        } else {
                                            phi_7438_ = _e4718;
                                        }
                                        let _e4721 = phi_7438_;
                                        if (_e4707[2] < 0f) {
                                            phi_7445_ = -(_e4707[2]);
                                        } else {
                                            phi_7445_ = _e4707[2];
                                        }
                                        let _e4725 = phi_7445_;
                                        if (_e4721 > _e4725) {
                                            phi_7450_ = _e4721;
                                        } else {
                                            phi_7450_ = _e4725;
                                        }
                                        let _e4728 = phi_7450_;
                                        let _e4731 = local_4[1u].member[1u];
                                        if (_e4731[0] < 0f) {
                                            phi_7463_ = -(_e4731[0]);
                                        } else {
                                            phi_7463_ = _e4731[0];
                                        }
                                        let _e4738 = phi_7463_;
                                        if (_e4731[1] < 0f) {
                                            phi_7470_ = -(_e4731[1]);
                                        } else {
                                            phi_7470_ = _e4731[1];
                                        }
                                        let _e4742 = phi_7470_;
                                        if (_e4738 > _e4742) {
                                            phi_7475_ = _e4738;
                                        } else {
                                            phi_7475_ = _e4742;
                                        }
                                        let _e4745 = phi_7475_;
                                        if (_e4731[2] < 0f) {
                                            phi_7482_ = -(_e4731[2]);
                                        } else {
                                            phi_7482_ = _e4731[2];
                                        }
                                        let _e4749 = phi_7482_;
                                        if (_e4745 > _e4749) {
                                            phi_7487_ = _e4745;
                                        } else {
                                            phi_7487_ = _e4749;
                                        }
                                        let _e4752 = phi_7487_;
                                        if (_e4728 > _e4752) {
                                            phi_7492_ = _e4728;
                                        } else {
                                            phi_7492_ = _e4752;
                                        }
                                        let _e4755 = phi_7492_;
                                        let _e4757 = local_4[1u].member_3;
                                        let _e4761 = local_4[1u].member_1[0u];
                                        if (_e4761[0] < 0f) {
                                            phi_7509_ = -(_e4761[0]);
                                        } else {
                                            phi_7509_ = _e4761[0];
                                        }
                                        let _e4768 = phi_7509_;
                                        if (_e4761[1] < 0f) {
                                            phi_7516_ = -(_e4761[1]);
                                        } else {
                                            phi_7516_ = _e4761[1];
                                        }
                                        let _e4772 = phi_7516_;
                                        if (_e4768 > _e4772) {
                                            phi_7521_ = _e4768;
                                        } else {
                                            phi_7521_ = _e4772;
                                        }
                                        let _e4775 = phi_7521_;
                                        if (_e4761[2] < 0f) {
                                            phi_7528_ = -(_e4761[2]);
                                        } else {
                                            phi_7528_ = _e4761[2];
                                        }
                                        let _e4779 = phi_7528_;
                                        if (_e4775 > _e4779) {
                                            phi_7533_ = _e4775;
                                        } else {
                                            phi_7533_ = _e4779;
                                        }
                                        let _e4782 = phi_7533_;
                                        let _e4785 = local_4[1u].member_1[1u];
                                        if (_e4785[0] < 0f) {
                                            phi_7547_ = -(_e4785[0]);
                                        } else {
                                            phi_7547_ = _e4785[0];
                                        }
                                        let _e4792 = phi_7547_;
                                        if (_e4785[1] < 0f) {
                                            phi_7554_ = -(_e4785[1]);
                                        } else {
                                            phi_7554_ = _e4785[1];
                                        }
                                        let _e4796 = phi_7554_;
                                        if (_e4792 > _e4796) {
                                            phi_7559_ = _e4792;
                                        } else {
                                            phi_7559_ = _e4796;
                                        }
                                        let _e4799 = phi_7559_;
                                        if (_e4785[2] < 0f) {
                                            phi_7566_ = -(_e4785[2]);
                                        } else {
                                            phi_7566_ = _e4785[2];
                                        }
                                        let _e4803 = phi_7566_;
                                        if (_e4799 > _e4803) {
                                            phi_7571_ = _e4799;
                                        } else {
                                            phi_7571_ = _e4803;
                                        }
                                        let _e4806 = phi_7571_;
                                        if (_e4782 > _e4806) {
                                            phi_7576_ = _e4782;
                                        } else {
                                            phi_7576_ = _e4806;
                                        }
                                        let _e4809 = phi_7576_;
                                        let _e4811 = local_4[1u].member_3;
                                        let _e4815 = local_4[1u].member_2[0u];
                                        if (_e4815[0] < 0f) {
                                            phi_7593_ = -(_e4815[0]);
                                        } else {
                                            phi_7593_ = _e4815[0];
                                        }
                                        let _e4822 = phi_7593_;
                                        if (_e4815[1] < 0f) {
                                            phi_7600_ = -(_e4815[1]);
                                        } else {
                                            phi_7600_ = _e4815[1];
                                        }
                                        let _e4826 = phi_7600_;
                                        if (_e4822 > _e4826) {
                                            phi_7605_ = _e4822;
                                        } else {
                                            phi_7605_ = _e4826;
                                        }
                                        let _e4829 = phi_7605_;
                                        if (_e4815[2] < 0f) {
                                            phi_7612_ = -(_e4815[2]);
                                        } else {
                                            phi_7612_ = _e4815[2];
                                        }
                                        let _e4833 = phi_7612_;
                                        if (_e4829 > _e4833) {
                                            phi_7617_ = _e4829;
                                        } else {
                                            phi_7617_ = _e4833;
                                        }
                                        let _e4836 = phi_7617_;
                                        let _e4839 = local_4[1u].member_2[1u];
                                        if (_e4839[0] < 0f) {
                                            phi_7631_ = -(_e4839[0]);
                                        } else {
                                            phi_7631_ = _e4839[0];
                                        }
                                        let _e4846 = phi_7631_;
                                        if (_e4839[1] < 0f) {
                                            phi_7638_ = -(_e4839[1]);
                                        } else {
                                            phi_7638_ = _e4839[1];
                                        }
                                        let _e4850 = phi_7638_;
                                        if (_e4846 > _e4850) {
                                            phi_7643_ = _e4846;
                                        } else {
                                            phi_7643_ = _e4850;
                                        }
                                        let _e4853 = phi_7643_;
                                        if (_e4839[2] < 0f) {
                                            phi_7650_ = -(_e4839[2]);
                                        } else {
                                            phi_7650_ = _e4839[2];
                                        }
                                        let _e4857 = phi_7650_;
                                        if (_e4853 > _e4857) {
                                            phi_7655_ = _e4853;
                                        } else {
                                            phi_7655_ = _e4857;
                                        }
                                        let _e4860 = phi_7655_;
                                        if (_e4836 > _e4860) {
                                            phi_7660_ = _e4836;
                                        } else {
                                            phi_7660_ = _e4860;
                                        }
                                        let _e4863 = phi_7660_;
                                        let _e4865 = local_4[1u].member_3;
                                        let _e4868 = (((_e4755 + _e4757) + (_e4809 + _e4811)) + (_e4863 + _e4865));
                                        let _e4871 = local_4[1u].member_3;
                                        let _e4875 = (((_e2116 * 1.0001f) + (_e4871 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4878 = ((_e4639 * _e4618) - (_e4642 * _e4617));
                                        let _e4881 = ((_e4642 * _e4616) - (_e4636 * _e4618));
                                        let _e4884 = ((_e4636 * _e4617) - (_e4639 * _e4616));
                                        let _e4886 = local[0u];
                                        let _e4894 = (((_e4878 * _e4886[0]) + (_e4881 * _e4886[1])) + (_e4884 * _e4886[2]));
                                        phi_7698_ = type_36(0u, 4u);
                                        phi_7701_ = _e4894;
                                        phi_7703_ = _e4894;
                                        loop {
                                            let _e4896 = phi_7698_;
                                            let _e4898 = phi_7701_;
                                            let _e4900 = phi_7703_;
                                            local_60 = _e4898;
                                            local_61 = _e4900;
                                            local_71 = _e4900;
                                            if (_e4896.member < _e4896.member_1) {
                                                phi_7699_ = type_36((_e4896.member + 1u), _e4896.member_1);
                                                phi_7726_ = type_36(1u, _e4896.member);
                                            } else {
                                                phi_7699_ = _e4896;
                                                phi_7726_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e4914 = phi_7699_;
                                            let _e4916 = phi_7726_;
                                            let _e4920 = (bitcast<i32>(_e4916.member) != 0i);
                                            if _e4920 {
                                                if (_e4916.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4923 = local[_e4916.member_1];
                                                let _e4931 = (((_e4878 * _e4923[0]) + (_e4881 * _e4923[1])) + (_e4884 * _e4923[2]));
                                                if (_e4916.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4934 = local_1[_e4916.member_1];
                                                let _e4942 = (((_e4878 * _e4934[0]) + (_e4881 * _e4934[1])) + (_e4884 * _e4934[2]));
                                                if (_e4900 < _e4931) {
                                                    phi_7776_ = _e4900;
                                                } else {
                                                    phi_7776_ = _e4931;
                                                }
                                                let _e4945 = phi_7776_;
                                                if (_e4945 < _e4942) {
                                                    phi_7781_ = _e4945;
                                                } else {
                                                    phi_7781_ = _e4942;
                                                }
                                                let _e4948 = phi_7781_;
                                                if (_e4898 > _e4931) {
                                                    phi_7786_ = _e4898;
                                                } else {
                                                    phi_7786_ = _e4931;
                                                }
                                                let _e4951 = phi_7786_;
                                                if (_e4951 > _e4942) {
                                                    phi_7791_ = _e4951;
                                                } else {
                                                    phi_7791_ = _e4942;
                                                }
                                                let _e4954 = phi_7791_;
                                                phi_7702_ = _e4954;
                                                phi_7704_ = _e4948;
                                            } else {
                                                phi_7702_ = f32();
                                                phi_7704_ = f32();
                                            }
                                            let _e4956 = phi_7702_;
                                            let _e4958 = phi_7704_;
                                            continue;
                                            continuing {
                                                phi_7698_ = _e4914;
                                                phi_7701_ = _e4956;
                                                phi_7703_ = _e4958;
                                                break if !(_e4920);
                                            }
                                        }
                                        if (_e4878 < 0f) {
                                            phi_7797_ = -(_e4878);
                                        } else {
                                            phi_7797_ = _e4878;
                                        }
                                        let _e4963 = phi_7797_;
                                        if (_e4881 < 0f) {
                                            phi_7803_ = -(_e4881);
                                        } else {
                                            phi_7803_ = _e4881;
                                        }
                                        let _e4967 = phi_7803_;
                                        if (_e4884 < 0f) {
                                            phi_7810_ = -(_e4884);
                                        } else {
                                            phi_7810_ = _e4884;
                                        }
                                        let _e4972 = phi_7810_;
                                        let _e4973 = ((_e4963 + _e4967) + _e4972);
                                        let _e4978 = local_60;
                                        let _e4979 = -(_e4978);
                                        let _e4981 = local_61;
                                        if (_e4981 > _e4979) {
                                            let _e5791 = local_71;
                                            phi_7820_ = _e5791;
                                        } else {
                                            phi_7820_ = _e4979;
                                        }
                                        let _e4984 = phi_7820_;
                                        let _e4989 = (((_e4984 - ((_e4973 * _e4868) * (0.000000059604645f * 17f))) - (_e4973 * _e4875)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4992 = ((_e4639 * _e4633) - (_e4642 * _e4632));
                                        let _e4995 = ((_e4642 * _e4631) - (_e4636 * _e4633));
                                        let _e4998 = ((_e4636 * _e4632) - (_e4639 * _e4631));
                                        let _e5000 = local[0u];
                                        let _e5008 = (((_e4992 * _e5000[0]) + (_e4995 * _e5000[1])) + (_e4998 * _e5000[2]));
                                        phi_7851_ = type_36(0u, 4u);
                                        phi_7854_ = _e5008;
                                        phi_7856_ = _e5008;
                                        loop {
                                            let _e5010 = phi_7851_;
                                            let _e5012 = phi_7854_;
                                            let _e5014 = phi_7856_;
                                            local_62 = _e5012;
                                            local_63 = _e5014;
                                            local_72 = _e5014;
                                            if (_e5010.member < _e5010.member_1) {
                                                phi_7852_ = type_36((_e5010.member + 1u), _e5010.member_1);
                                                phi_7879_ = type_36(1u, _e5010.member);
                                            } else {
                                                phi_7852_ = _e5010;
                                                phi_7879_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e5028 = phi_7852_;
                                            let _e5030 = phi_7879_;
                                            let _e5034 = (bitcast<i32>(_e5030.member) != 0i);
                                            if _e5034 {
                                                if (_e5030.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e5037 = local[_e5030.member_1];
                                                let _e5045 = (((_e4992 * _e5037[0]) + (_e4995 * _e5037[1])) + (_e4998 * _e5037[2]));
                                                if (_e5030.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e5048 = local_1[_e5030.member_1];
                                                let _e5056 = (((_e4992 * _e5048[0]) + (_e4995 * _e5048[1])) + (_e4998 * _e5048[2]));
                                                if (_e5014 < _e5045) {
                                                    phi_7929_ = _e5014;
                                                } else {
                                                    phi_7929_ = _e5045;
                                                }
                                                let _e5059 = phi_7929_;
                                                if (_e5059 < _e5056) {
                                                    phi_7934_ = _e5059;
                                                } else {
                                                    phi_7934_ = _e5056;
                                                }
                                                let _e5062 = phi_7934_;
                                                if (_e5012 > _e5045) {
                                                    phi_7939_ = _e5012;
                                                } else {
                                                    phi_7939_ = _e5045;
                                                }
                                                let _e5065 = phi_7939_;
                                                if (_e5065 > _e5056) {
                                                    phi_7944_ = _e5065;
                                                } else {
                                                    phi_7944_ = _e5056;
                                                }
                                                let _e5068 = phi_7944_;
                                                phi_7855_ = _e5068;
                                                phi_7857_ = _e5062;
                                            } else {
                                                phi_7855_ = f32();
                                                phi_7857_ = f32();
                                            }
                                            let _e5070 = phi_7855_;
                                            let _e5072 = phi_7857_;
                                            continue;
                                            continuing {
                                                phi_7851_ = _e5028;
                                                phi_7854_ = _e5070;
                                                phi_7856_ = _e5072;
                                                break if !(_e5034);
                                            }
                                        }
                                        if (_e4992 < 0f) {
                                            phi_7950_ = -(_e4992);
                                        } else {
                                            phi_7950_ = _e4992;
                                        }
                                        let _e5077 = phi_7950_;
                                        if (_e4995 < 0f) {
                                            phi_7956_ = -(_e4995);
                                        } else {
                                            phi_7956_ = _e4995;
                                        }
                                        let _e5081 = phi_7956_;
                                        if (_e4998 < 0f) {
                                            phi_7963_ = -(_e4998);
                                        } else {
                                            phi_7963_ = _e4998;
                                        }
                                        let _e5086 = phi_7963_;
                                        let _e5087 = ((_e5077 + _e5081) + _e5086);
                                        let _e5092 = local_62;
                                        let _e5093 = -(_e5092);
                                        let _e5095 = local_63;
                                        if (_e5095 > _e5093) {
                                            let _e5810 = local_72;
                                            phi_7973_ = _e5810;
                                        } else {
                                            phi_7973_ = _e5093;
                                        }
                                        let _e5098 = phi_7973_;
                                        let _e5103 = (((_e5098 - ((_e5087 * _e4868) * (0.000000059604645f * 17f))) - (_e5087 * _e4875)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4989 > _e5103) {
                                            phi_7983_ = _e4989;
                                        } else {
                                            phi_7983_ = _e5103;
                                        }
                                        let _e5106 = phi_7983_;
                                        phi_8151_ = (_e5106 > 0f);
                                    }
                                    let _e5109 = phi_8151_;
                                    phi_8152_ = _e5109;
                                } else {
                                    phi_8152_ = false;
                                }
                                let _e5111 = phi_8152_;
                                phi_8154_ = !(_e5111);
                            }
                            let _e5114 = phi_8154_;
                            if _e5114 {
                                let _e5116 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1351] = ((2147483648u | (_e5116 << bitcast<u32>(12i))) | _e1354);
                            }
                        }
                        phi_8164_ = true;
                    }
                    let _e5123 = phi_8164_;
                    phi_8165_ = _e5123;
                } else {
                    phi_8165_ = false;
                }
                let _e5125 = phi_8165_;
                continue;
                continuing {
                    phi_1900_ = _e1343;
                    break if !(_e5125);
                }
            }
            workgroupBarrier();
            if (_e110 == 0u) {
                let _e5129 = atomicLoad((&counters[5u]));
                if (_e5129 > 0u) {
                    let _e5132 = atomicAdd((&output.member[0u]), _e5129);
                    if ((_e5132 + _e5129) < _e5132) {
                        let _e5136 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e5132);
                }
            }
            workgroupBarrier();
            let _e5139 = atomicLoad((&counters[6u]));
            if (_e110 == 0u) {
                let _e5142 = atomicLoad((&counters[7u]));
                if (_e5142 > 0u) {
                    let _e5145 = atomicAdd((&output.member[1u]), _e5142);
                    if ((_e5145 + _e5142) < _e5145) {
                        let _e5149 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_8215_ = type_36(0u, 16u);
            loop {
                let _e5151 = phi_8215_;
                if (_e5151.member < _e5151.member_1) {
                    phi_8216_ = type_36((_e5151.member + 1u), _e5151.member_1);
                    phi_8239_ = type_36(1u, _e5151.member);
                } else {
                    phi_8216_ = _e5151;
                    phi_8239_ = type_36(0u, type_36().member_1);
                }
                let _e5165 = phi_8216_;
                let _e5167 = phi_8239_;
                if (bitcast<i32>(_e5167.member) != 0i) {
                    let _e5173 = (_e110 + (_e5167.member_1 * 128u));
                    if (_e5173 >= _e1327) {
                        phi_8337_ = false;
                    } else {
                        let _e5176 = hits[_e5173];
                        if ((_e5176 & 2147483648u) == 0u) {
                            phi_8262_ = 4294967295u;
                        } else {
                            phi_8262_ = ((_e5176 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e5183 = phi_8262_;
                        if (_e5183 != 4294967295u) {
                            let _e5187 = ((_e5176 >> bitcast<u32>(10i)) & 3u);
                            let _e5194 = firsts[(2u * _e5187)];
                            let _e5197 = leaves.member[(_e5194 + ((_e5176 >> bitcast<u32>(5i)) & 31u))];
                            let _e5201 = firsts[((2u * _e5187) + 1u)];
                            let _e5204 = leaves.member[(_e5201 + (_e5176 & 31u))];
                            let _e5208 = params.member.member_16;
                            let _e5209 = (_e5139 + _e5183);
                            if (_e5197.member_1 < _e5204.member_1) {
                                phi_8316_ = type_36(_e5197.member_1, _e5204.member_1);
                            } else {
                                phi_8316_ = type_36(_e5204.member_1, _e5197.member_1);
                            }
                            let _e5214 = phi_8316_;
                            if (_e5209 < _e5208) {
                                atomicStore((&output.member[(4u + (2u * _e5209))]), _e5214.member);
                                atomicStore((&output.member[((2u * _e5209) + 5u)]), _e5214.member_1);
                            }
                        }
                        phi_8337_ = true;
                    }
                    let _e5225 = phi_8337_;
                    phi_8338_ = _e5225;
                } else {
                    phi_8338_ = false;
                }
                let _e5227 = phi_8338_;
                continue;
                continuing {
                    phi_8215_ = _e5165;
                    break if !(_e5227);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_320_ = _e193;
            break if !(_e199);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
