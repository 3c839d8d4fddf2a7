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
    var phi_807_: u32;
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
    var phi_3315_: f32;
    var phi_3322_: f32;
    var phi_3327_: f32;
    var phi_3334_: f32;
    var phi_3339_: f32;
    var phi_3352_: f32;
    var phi_3359_: f32;
    var phi_3364_: f32;
    var phi_3371_: f32;
    var phi_3376_: f32;
    var phi_3381_: f32;
    var phi_3398_: f32;
    var phi_3405_: f32;
    var phi_3410_: f32;
    var phi_3417_: f32;
    var phi_3422_: f32;
    var phi_3436_: f32;
    var phi_3443_: f32;
    var phi_3448_: f32;
    var phi_3455_: f32;
    var phi_3460_: f32;
    var phi_3465_: f32;
    var phi_3482_: f32;
    var phi_3489_: f32;
    var phi_3494_: f32;
    var phi_3501_: f32;
    var phi_3506_: f32;
    var phi_3520_: f32;
    var phi_3527_: f32;
    var phi_3532_: f32;
    var phi_3539_: f32;
    var phi_3544_: f32;
    var phi_3549_: f32;
    var phi_3580_: f32;
    var phi_3586_: f32;
    var phi_3593_: f32;
    var phi_3600_: f32;
    var phi_3606_: f32;
    var phi_3613_: f32;
    var phi_3619_: f32;
    var phi_3625_: f32;
    var phi_3631_: f32;
    var phi_3638_: f32;
    var phi_3645_: f32;
    var phi_3669_: f32;
    var phi_3674_: f32;
    var phi_3679_: f32;
    var phi_3684_: f32;
    var phi_3689_: f32;
    var phi_3694_: f32;
    var phi_3704_: f32;
    var phi_3955_: f32;
    var phi_3962_: f32;
    var phi_3967_: f32;
    var phi_3974_: f32;
    var phi_3979_: f32;
    var phi_3992_: f32;
    var phi_3999_: f32;
    var phi_4004_: f32;
    var phi_4011_: f32;
    var phi_4016_: f32;
    var phi_4021_: f32;
    var phi_4038_: f32;
    var phi_4045_: f32;
    var phi_4050_: f32;
    var phi_4057_: f32;
    var phi_4062_: f32;
    var phi_4076_: f32;
    var phi_4083_: f32;
    var phi_4088_: f32;
    var phi_4095_: f32;
    var phi_4100_: f32;
    var phi_4105_: f32;
    var phi_4122_: f32;
    var phi_4129_: f32;
    var phi_4134_: f32;
    var phi_4141_: f32;
    var phi_4146_: f32;
    var phi_4160_: f32;
    var phi_4167_: f32;
    var phi_4172_: f32;
    var phi_4179_: f32;
    var phi_4184_: f32;
    var phi_4189_: f32;
    var phi_4227_: type_21;
    var phi_4230_: f32;
    var phi_4232_: f32;
    var phi_4228_: type_21;
    var phi_4255_: type_21;
    var phi_4305_: f32;
    var phi_4310_: f32;
    var phi_4315_: f32;
    var phi_4320_: f32;
    var phi_4231_: f32;
    var phi_4233_: f32;
    var phi_4326_: f32;
    var phi_4332_: f32;
    var phi_4339_: f32;
    var local_52: f32;
    var local_53: f32;
    var phi_4349_: f32;
    var phi_4380_: type_21;
    var phi_4383_: f32;
    var phi_4385_: f32;
    var phi_4381_: type_21;
    var phi_4408_: type_21;
    var phi_4458_: f32;
    var phi_4463_: f32;
    var phi_4468_: f32;
    var phi_4473_: f32;
    var phi_4384_: f32;
    var phi_4386_: f32;
    var phi_4479_: f32;
    var phi_4485_: f32;
    var phi_4492_: f32;
    var local_54: f32;
    var local_55: f32;
    var phi_4502_: f32;
    var phi_4512_: f32;
    var phi_4545_: type_21;
    var phi_4548_: f32;
    var phi_4550_: f32;
    var phi_4546_: type_21;
    var phi_4573_: type_21;
    var phi_4623_: f32;
    var phi_4628_: f32;
    var phi_4633_: f32;
    var phi_4638_: f32;
    var phi_4549_: f32;
    var phi_4551_: f32;
    var phi_4644_: f32;
    var phi_4650_: f32;
    var phi_4657_: f32;
    var local_56: f32;
    var local_57: f32;
    var phi_4667_: f32;
    var phi_4677_: f32;
    var phi_4680_: bool;
    var phi_5137_: f32;
    var phi_5144_: f32;
    var phi_5149_: f32;
    var phi_5156_: f32;
    var phi_5161_: f32;
    var phi_5174_: f32;
    var phi_5181_: f32;
    var phi_5186_: f32;
    var phi_5193_: f32;
    var phi_5198_: f32;
    var phi_5203_: f32;
    var phi_5220_: f32;
    var phi_5227_: f32;
    var phi_5232_: f32;
    var phi_5239_: f32;
    var phi_5244_: f32;
    var phi_5258_: f32;
    var phi_5265_: f32;
    var phi_5270_: f32;
    var phi_5277_: f32;
    var phi_5282_: f32;
    var phi_5287_: f32;
    var phi_5304_: f32;
    var phi_5311_: f32;
    var phi_5316_: f32;
    var phi_5323_: f32;
    var phi_5328_: f32;
    var phi_5342_: f32;
    var phi_5349_: f32;
    var phi_5354_: f32;
    var phi_5361_: f32;
    var phi_5366_: f32;
    var phi_5371_: f32;
    var phi_5402_: f32;
    var phi_5408_: f32;
    var phi_5415_: f32;
    var phi_5422_: f32;
    var phi_5428_: f32;
    var phi_5435_: f32;
    var phi_5441_: f32;
    var phi_5447_: f32;
    var phi_5453_: f32;
    var phi_5460_: f32;
    var phi_5467_: f32;
    var phi_5491_: f32;
    var phi_5496_: f32;
    var phi_5501_: f32;
    var phi_5506_: f32;
    var phi_5511_: f32;
    var phi_5516_: f32;
    var phi_5526_: f32;
    var phi_5777_: f32;
    var phi_5784_: f32;
    var phi_5789_: f32;
    var phi_5796_: f32;
    var phi_5801_: f32;
    var phi_5814_: f32;
    var phi_5821_: f32;
    var phi_5826_: f32;
    var phi_5833_: f32;
    var phi_5838_: f32;
    var phi_5843_: f32;
    var phi_5860_: f32;
    var phi_5867_: f32;
    var phi_5872_: f32;
    var phi_5879_: f32;
    var phi_5884_: f32;
    var phi_5898_: f32;
    var phi_5905_: f32;
    var phi_5910_: f32;
    var phi_5917_: f32;
    var phi_5922_: f32;
    var phi_5927_: f32;
    var phi_5944_: f32;
    var phi_5951_: f32;
    var phi_5956_: f32;
    var phi_5963_: f32;
    var phi_5968_: f32;
    var phi_5982_: f32;
    var phi_5989_: f32;
    var phi_5994_: f32;
    var phi_6001_: f32;
    var phi_6006_: f32;
    var phi_6011_: f32;
    var phi_6049_: type_21;
    var phi_6052_: f32;
    var phi_6054_: f32;
    var phi_6050_: type_21;
    var phi_6077_: type_21;
    var phi_6127_: f32;
    var phi_6132_: f32;
    var phi_6137_: f32;
    var phi_6142_: f32;
    var phi_6053_: f32;
    var phi_6055_: f32;
    var phi_6148_: f32;
    var phi_6154_: f32;
    var phi_6161_: f32;
    var local_58: f32;
    var local_59: f32;
    var phi_6171_: f32;
    var phi_6202_: type_21;
    var phi_6205_: f32;
    var phi_6207_: f32;
    var phi_6203_: type_21;
    var phi_6230_: type_21;
    var phi_6280_: f32;
    var phi_6285_: f32;
    var phi_6290_: f32;
    var phi_6295_: f32;
    var phi_6206_: f32;
    var phi_6208_: f32;
    var phi_6301_: f32;
    var phi_6307_: f32;
    var phi_6314_: f32;
    var local_60: f32;
    var local_61: f32;
    var phi_6324_: f32;
    var phi_6334_: f32;
    var phi_6367_: type_21;
    var phi_6370_: f32;
    var phi_6372_: f32;
    var phi_6368_: type_21;
    var phi_6395_: type_21;
    var phi_6445_: f32;
    var phi_6450_: f32;
    var phi_6455_: f32;
    var phi_6460_: f32;
    var phi_6371_: f32;
    var phi_6373_: f32;
    var phi_6466_: f32;
    var phi_6472_: f32;
    var phi_6479_: f32;
    var local_62: f32;
    var local_63: f32;
    var phi_6489_: f32;
    var phi_6499_: f32;
    var phi_6502_: bool;
    var phi_6748_: f32;
    var phi_6755_: f32;
    var phi_6760_: f32;
    var phi_6767_: f32;
    var phi_6772_: f32;
    var phi_6785_: f32;
    var phi_6792_: f32;
    var phi_6797_: f32;
    var phi_6804_: f32;
    var phi_6809_: f32;
    var phi_6814_: f32;
    var phi_6831_: f32;
    var phi_6838_: f32;
    var phi_6843_: f32;
    var phi_6850_: f32;
    var phi_6855_: f32;
    var phi_6869_: f32;
    var phi_6876_: f32;
    var phi_6881_: f32;
    var phi_6888_: f32;
    var phi_6893_: f32;
    var phi_6898_: f32;
    var phi_6915_: f32;
    var phi_6922_: f32;
    var phi_6927_: f32;
    var phi_6934_: f32;
    var phi_6939_: f32;
    var phi_6953_: f32;
    var phi_6960_: f32;
    var phi_6965_: f32;
    var phi_6972_: f32;
    var phi_6977_: f32;
    var phi_6982_: f32;
    var phi_7013_: f32;
    var phi_7019_: f32;
    var phi_7026_: f32;
    var phi_7033_: f32;
    var phi_7039_: f32;
    var phi_7046_: f32;
    var phi_7052_: f32;
    var phi_7058_: f32;
    var phi_7064_: f32;
    var phi_7071_: f32;
    var phi_7078_: f32;
    var phi_7102_: f32;
    var phi_7107_: f32;
    var phi_7112_: f32;
    var phi_7117_: f32;
    var phi_7122_: f32;
    var phi_7127_: f32;
    var phi_7137_: f32;
    var phi_7388_: f32;
    var phi_7395_: f32;
    var phi_7400_: f32;
    var phi_7407_: f32;
    var phi_7412_: f32;
    var phi_7425_: f32;
    var phi_7432_: f32;
    var phi_7437_: f32;
    var phi_7444_: f32;
    var phi_7449_: f32;
    var phi_7454_: f32;
    var phi_7471_: f32;
    var phi_7478_: f32;
    var phi_7483_: f32;
    var phi_7490_: f32;
    var phi_7495_: f32;
    var phi_7509_: f32;
    var phi_7516_: f32;
    var phi_7521_: f32;
    var phi_7528_: f32;
    var phi_7533_: f32;
    var phi_7538_: f32;
    var phi_7555_: f32;
    var phi_7562_: f32;
    var phi_7567_: f32;
    var phi_7574_: f32;
    var phi_7579_: f32;
    var phi_7593_: f32;
    var phi_7600_: f32;
    var phi_7605_: f32;
    var phi_7612_: f32;
    var phi_7617_: f32;
    var phi_7622_: f32;
    var phi_7660_: type_21;
    var phi_7663_: f32;
    var phi_7665_: f32;
    var phi_7661_: type_21;
    var phi_7688_: type_21;
    var phi_7738_: f32;
    var phi_7743_: f32;
    var phi_7748_: f32;
    var phi_7753_: f32;
    var phi_7664_: f32;
    var phi_7666_: f32;
    var phi_7759_: f32;
    var phi_7765_: f32;
    var phi_7772_: f32;
    var local_64: f32;
    var local_65: f32;
    var phi_7782_: f32;
    var phi_7813_: type_21;
    var phi_7816_: f32;
    var phi_7818_: f32;
    var phi_7814_: type_21;
    var phi_7841_: type_21;
    var phi_7891_: f32;
    var phi_7896_: f32;
    var phi_7901_: f32;
    var phi_7906_: f32;
    var phi_7817_: f32;
    var phi_7819_: f32;
    var phi_7912_: f32;
    var phi_7918_: f32;
    var phi_7925_: f32;
    var local_66: f32;
    var local_67: f32;
    var phi_7935_: f32;
    var phi_7945_: f32;
    var phi_7978_: type_21;
    var phi_7981_: f32;
    var phi_7983_: f32;
    var phi_7979_: type_21;
    var phi_8006_: type_21;
    var phi_8056_: f32;
    var phi_8061_: f32;
    var phi_8066_: f32;
    var phi_8071_: f32;
    var phi_7982_: f32;
    var phi_7984_: f32;
    var phi_8077_: f32;
    var phi_8083_: f32;
    var phi_8090_: f32;
    var local_68: f32;
    var local_69: f32;
    var phi_8100_: f32;
    var phi_8110_: f32;
    var phi_8113_: bool;
    var phi_8114_: bool;
    var phi_8116_: bool;
    var phi_8126_: bool;
    var phi_8127_: bool;
    var phi_8177_: type_21;
    var phi_8178_: type_21;
    var phi_8201_: type_21;
    var phi_8224_: u32;
    var phi_8299_: bool;
    var phi_8300_: bool;
    var local_70: u32;
    var local_71: bool;
    var local_72: bool;
    var local_73: f32;
    var local_74: f32;
    var local_75: f32;
    var local_76: f32;
    var local_77: f32;
    var local_78: f32;
    var local_79: f32;
    var local_80: f32;
    var local_81: f32;
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
            let _e234 = params.member.member_20[0u][0u];
            let _e235 = (_e234 + (_e224 * 32u));
            let _e240 = params.member.member_20[0u][2u];
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
            let _e392 = (_e97 / 32u);
            let _e395 = atomicLoad((&counters[_e392]));
            phi_691_ = type_21(0u, _e395);
            phi_694_ = 0u;
            loop {
                let _e398 = phi_691_;
                let _e400 = phi_694_;
                local_70 = _e400;
                if (_e398.member < _e398.member_1) {
                    phi_692_ = type_21((_e398.member + 1u), _e398.member_1);
                    phi_717_ = type_21(1u, _e398.member);
                } else {
                    phi_692_ = _e398;
                    phi_717_ = type_21(0u, type_21().member_1);
                }
                let _e412 = phi_692_;
                let _e414 = phi_717_;
                let _e418 = (bitcast<i32>(_e414.member) != 0i);
                if _e418 {
                    let _e422 = names[((_e392 * 32u) + _e414.member_1)];
                    let _e426 = columns[((_e392 * 32u) + _e414.member_1)];
                    if ((((((_e391.member[0] <= _e426.member_1[0]) && (_e426.member[0] <= _e391.member_1[0])) && (_e391.member[1] <= _e426.member_1[1])) && (_e426.member[1] <= _e391.member_1[1])) && (_e391.member[2] <= _e426.member_1[2])) && (_e426.member[2] <= _e391.member_1[2])) {
                        let _e459 = atomicAdd((&counters[4u]), 1u);
                        if (_e459 < 2048u) {
                            hits[_e459] = (((_e392 << bitcast<u32>(10i)) | ((_e97 % 32u) << bitcast<u32>(5i))) | _e422);
                            phi_807_ = _e400;
                        } else {
                            phi_807_ = (_e400 | (1u << bitcast<u32>((_e414.member_1 & 31u))));
                        }
                        let _e473 = phi_807_;
                        phi_809_ = _e473;
                    } else {
                        phi_809_ = _e400;
                    }
                    let _e475 = phi_809_;
                    phi_695_ = _e475;
                } else {
                    phi_695_ = u32();
                }
                let _e477 = phi_695_;
                continue;
                continuing {
                    phi_691_ = _e412;
                    phi_694_ = _e477;
                    break if !(_e418);
                }
            }
            phi_812_ = type_21(0u, 32u);
            let _e5452 = local_70;
            phi_815_ = _e5452;
            loop {
                let _e480 = phi_812_;
                let _e482 = phi_815_;
                if (_e480.member < _e480.member_1) {
                    phi_813_ = type_21((_e480.member + 1u), _e480.member_1);
                    phi_838_ = type_21(1u, _e480.member);
                } else {
                    phi_813_ = _e480;
                    phi_838_ = type_21(0u, type_21().member_1);
                }
                let _e494 = phi_813_;
                let _e496 = phi_838_;
                if (bitcast<i32>(_e496.member) != 0i) {
                    if (_e482 == 0u) {
                        phi_1888_ = u32();
                        phi_1889_ = false;
                    } else {
                        let _e507 = names[((_e121 * 32u) + select(firstTrailingBit(_e482), 32u, (_e482 == 0u)))];
                        let _e510 = (_e235 + _e122);
                        let _e511 = (_e241 + _e507);
                        let _e513 = leaves.member[_e510];
                        let _e515 = leaves.member[_e511];
                        local_24 = type_16(array<u32, 3>(_e513.member[0], _e513.member[1], _e513.member[2]), _e513.member_1);
                        local_25 = type_16(array<u32, 3>(_e515.member[0], _e515.member[1], _e515.member[2]), _e515.member_1);
                        let _e531 = nodes.member[_e510];
                        let _e533 = nodes.member[_e511];
                        let _e535 = params.member.member_1;
                        if ((_e535 & 1u) != 0u) {
                            let _e539 = params.member.member_8;
                            if (_e539 == 0u) {
                                let _e583 = local_24.member[0u];
                                let _e586 = local_25.member[0u];
                                if (_e583 == _e586) {
                                    phi_949_ = bool();
                                    phi_950_ = true;
                                } else {
                                    let _e590 = local_24.member[0u];
                                    let _e593 = local_25.member[1u];
                                    let _e594 = (_e590 == _e593);
                                    if _e594 {
                                        phi_948_ = bool();
                                    } else {
                                        let _e597 = local_24.member[0u];
                                        let _e600 = local_25.member[2u];
                                        phi_948_ = (_e597 == _e600);
                                    }
                                    let _e603 = phi_948_;
                                    phi_949_ = _e603;
                                    phi_950_ = _e594;
                                }
                                let _e605 = phi_949_;
                                let _e607 = phi_950_;
                                if _e607 {
                                    phi_954_ = true;
                                } else {
                                    phi_954_ = _e605;
                                }
                                let _e609 = phi_954_;
                                phi_993_ = _e609;
                            } else {
                                let _e543 = local_24.member[0u];
                                let _e546 = local_25.member[0u];
                                if (_e543 == _e546) {
                                    phi_987_ = bool();
                                    phi_988_ = true;
                                } else {
                                    let _e550 = local_24.member[0u];
                                    let _e553 = local_25.member[1u];
                                    if (_e550 == _e553) {
                                        phi_985_ = bool();
                                        phi_986_ = true;
                                    } else {
                                        let _e557 = local_24.member[1u];
                                        let _e560 = local_25.member[0u];
                                        let _e561 = (_e557 == _e560);
                                        if _e561 {
                                            phi_984_ = bool();
                                        } else {
                                            let _e564 = local_24.member[1u];
                                            let _e567 = local_25.member[1u];
                                            phi_984_ = (_e564 == _e567);
                                        }
                                        let _e570 = phi_984_;
                                        phi_985_ = _e570;
                                        phi_986_ = _e561;
                                    }
                                    let _e572 = phi_985_;
                                    let _e574 = phi_986_;
                                    phi_987_ = _e572;
                                    phi_988_ = _e574;
                                }
                                let _e576 = phi_987_;
                                let _e578 = phi_988_;
                                if _e578 {
                                    phi_992_ = true;
                                } else {
                                    phi_992_ = _e576;
                                }
                                let _e580 = phi_992_;
                                phi_993_ = _e580;
                            }
                            let _e611 = phi_993_;
                            if _e611 {
                                phi_997_ = false;
                            } else {
                                phi_997_ = true;
                            }
                            let _e613 = phi_997_;
                            phi_998_ = _e613;
                        } else {
                            phi_998_ = true;
                        }
                        let _e615 = phi_998_;
                        if _e615 {
                            let _e617 = params.member.member_1;
                            if ((_e617 & 2u) != 0u) {
                                let _e622 = local_24.member[0u];
                                let _e624 = bodies.member[_e622];
                                let _e627 = local_25.member[0u];
                                let _e629 = bodies.member[_e627];
                                if ((_e624 / 2u) == (_e629 / 2u)) {
                                    let _e634 = params.member.member_1;
                                    phi_1044_ = !(((_e634 & 4u) != 0u));
                                } else {
                                    phi_1044_ = false;
                                }
                                let _e639 = phi_1044_;
                                if _e639 {
                                    phi_1055_ = true;
                                } else {
                                    if (((_e624 & _e629) & 1u) == 0u) {
                                        phi_1054_ = false;
                                    } else {
                                        phi_1054_ = true;
                                    }
                                    let _e644 = phi_1054_;
                                    phi_1055_ = _e644;
                                }
                                let _e646 = phi_1055_;
                                if _e646 {
                                    phi_1059_ = false;
                                } else {
                                    phi_1059_ = true;
                                }
                                let _e648 = phi_1059_;
                                phi_1060_ = _e648;
                            } else {
                                phi_1060_ = true;
                            }
                            let _e650 = phi_1060_;
                            if _e650 {
                                let _e652 = params.member.member_1;
                                if ((_e652 & 32u) != 0u) {
                                    let _e656 = params.member.member_6;
                                    let _e697 = (((((((_e531.member_1[0] - _e533.member[0]) > _e656) && ((_e533.member_1[0] - _e531.member[0]) > _e656)) && ((_e531.member_1[1] - _e533.member[1]) > _e656)) && ((_e533.member_1[1] - _e531.member[1]) > _e656)) && ((_e531.member_1[2] - _e533.member[2]) > _e656)) && ((_e533.member_1[2] - _e531.member[2]) > _e656));
                                    if _e697 {
                                        phi_1809_ = bool();
                                    } else {
                                        phi_1109_ = type_21(0u, 3u);
                                        phi_1112_ = true;
                                        loop {
                                            let _e701 = phi_1109_;
                                            let _e703 = phi_1112_;
                                            local_71 = _e703;
                                            if (_e701.member < _e701.member_1) {
                                                phi_1110_ = type_21((_e701.member + 1u), _e701.member_1);
                                                phi_1135_ = type_21(1u, _e701.member);
                                            } else {
                                                phi_1110_ = _e701;
                                                phi_1135_ = type_21(0u, type_21().member_1);
                                            }
                                            let _e715 = phi_1110_;
                                            let _e717 = phi_1135_;
                                            let _e721 = (bitcast<i32>(_e717.member) != 0i);
                                            if _e721 {
                                                let _e723 = local_24.member[0u];
                                                let _e725 = keys.member[_e723];
                                                local_22 = array<array<u32, 2>, 6>(array<u32, 2>(_e725[0][0], _e725[0][1]), array<u32, 2>(_e725[1][0], _e725[1][1]), array<u32, 2>(_e725[2][0], _e725[2][1]), array<u32, 2>(_e725[3][0], _e725[3][1]), array<u32, 2>(_e725[4][0], _e725[4][1]), array<u32, 2>(_e725[5][0], _e725[5][1]));
                                                let _e752 = local_22[_e717.member_1];
                                                phi_1192_ = type_21(1u, 3u);
                                                phi_1195_ = array<u32, 2>(_e752[0], _e752[1]);
                                                loop {
                                                    let _e757 = phi_1192_;
                                                    let _e759 = phi_1195_;
                                                    local_28 = _e759;
                                                    local_30 = _e759;
                                                    local_32 = _e759;
                                                    if (_e757.member < _e757.member_1) {
                                                        phi_1193_ = type_21((_e757.member + 1u), _e757.member_1);
                                                        phi_1218_ = type_21(1u, _e757.member);
                                                    } else {
                                                        phi_1193_ = _e757;
                                                        phi_1218_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e771 = phi_1193_;
                                                    let _e773 = phi_1218_;
                                                    let _e777 = (bitcast<i32>(_e773.member) != 0i);
                                                    if _e777 {
                                                        let _e779 = local_24.member[_e773.member_1];
                                                        let _e781 = keys.member[_e779];
                                                        local_23 = array<array<u32, 2>, 6>(array<u32, 2>(_e781[0][0], _e781[0][1]), array<u32, 2>(_e781[1][0], _e781[1][1]), array<u32, 2>(_e781[2][0], _e781[2][1]), array<u32, 2>(_e781[3][0], _e781[3][1]), array<u32, 2>(_e781[4][0], _e781[4][1]), array<u32, 2>(_e781[5][0], _e781[5][1]));
                                                        let _e808 = local_23[_e717.member_1];
                                                        if (_e759[1] > _e808[1]) {
                                                            phi_1294_ = true;
                                                        } else {
                                                            if (_e759[1] == _e808[1]) {
                                                                phi_1293_ = (_e759[0] > _e808[0]);
                                                            } else {
                                                                phi_1293_ = false;
                                                            }
                                                            let _e819 = phi_1293_;
                                                            phi_1294_ = _e819;
                                                        }
                                                        let _e821 = phi_1294_;
                                                        if _e821 {
                                                            phi_1298_ = array<u32, 2>(_e808[0], _e808[1]);
                                                        } else {
                                                            phi_1298_ = _e759;
                                                        }
                                                        let _e823 = phi_1298_;
                                                        phi_1196_ = _e823;
                                                    } else {
                                                        phi_1196_ = array<u32, 2>();
                                                    }
                                                    let _e825 = phi_1196_;
                                                    continue;
                                                    continuing {
                                                        phi_1192_ = _e771;
                                                        phi_1195_ = _e825;
                                                        break if !(_e777);
                                                    }
                                                }
                                                let _e828 = local_25.member[0u];
                                                let _e830 = keys.member[_e828];
                                                local_20 = array<array<u32, 2>, 6>(array<u32, 2>(_e830[0][0], _e830[0][1]), array<u32, 2>(_e830[1][0], _e830[1][1]), array<u32, 2>(_e830[2][0], _e830[2][1]), array<u32, 2>(_e830[3][0], _e830[3][1]), array<u32, 2>(_e830[4][0], _e830[4][1]), array<u32, 2>(_e830[5][0], _e830[5][1]));
                                                let _e858 = local_20[(3u + _e717.member_1)];
                                                phi_1349_ = type_21(1u, 3u);
                                                phi_1352_ = array<u32, 2>(_e858[0], _e858[1]);
                                                loop {
                                                    let _e863 = phi_1349_;
                                                    let _e865 = phi_1352_;
                                                    local_29 = _e865;
                                                    local_31 = _e865;
                                                    local_33 = _e865;
                                                    if (_e863.member < _e863.member_1) {
                                                        phi_1350_ = type_21((_e863.member + 1u), _e863.member_1);
                                                        phi_1375_ = type_21(1u, _e863.member);
                                                    } else {
                                                        phi_1350_ = _e863;
                                                        phi_1375_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e877 = phi_1350_;
                                                    let _e879 = phi_1375_;
                                                    let _e883 = (bitcast<i32>(_e879.member) != 0i);
                                                    if _e883 {
                                                        let _e885 = local_25.member[_e879.member_1];
                                                        let _e887 = keys.member[_e885];
                                                        local_21 = array<array<u32, 2>, 6>(array<u32, 2>(_e887[0][0], _e887[0][1]), array<u32, 2>(_e887[1][0], _e887[1][1]), array<u32, 2>(_e887[2][0], _e887[2][1]), array<u32, 2>(_e887[3][0], _e887[3][1]), array<u32, 2>(_e887[4][0], _e887[4][1]), array<u32, 2>(_e887[5][0], _e887[5][1]));
                                                        let _e915 = local_21[(3u + _e717.member_1)];
                                                        if (_e915[1] > _e865[1]) {
                                                            phi_1452_ = true;
                                                        } else {
                                                            if (_e915[1] == _e865[1]) {
                                                                phi_1451_ = (_e915[0] > _e865[0]);
                                                            } else {
                                                                phi_1451_ = false;
                                                            }
                                                            let _e926 = phi_1451_;
                                                            phi_1452_ = _e926;
                                                        }
                                                        let _e928 = phi_1452_;
                                                        if _e928 {
                                                            phi_1456_ = array<u32, 2>(_e915[0], _e915[1]);
                                                        } else {
                                                            phi_1456_ = _e865;
                                                        }
                                                        let _e930 = phi_1456_;
                                                        phi_1353_ = _e930;
                                                    } else {
                                                        phi_1353_ = array<u32, 2>();
                                                    }
                                                    let _e932 = phi_1353_;
                                                    continue;
                                                    continuing {
                                                        phi_1349_ = _e877;
                                                        phi_1352_ = _e932;
                                                        break if !(_e883);
                                                    }
                                                }
                                                let _e935 = local_28;
                                                let _e938 = local_29;
                                                if (_e935[1] > _e938[1]) {
                                                    phi_1473_ = true;
                                                } else {
                                                    let _e942 = local_30;
                                                    let _e945 = local_31;
                                                    if (_e942[1] == _e945[1]) {
                                                        let _e949 = local_32;
                                                        let _e952 = local_33;
                                                        phi_1472_ = (_e949[0] > _e952[0]);
                                                    } else {
                                                        phi_1472_ = false;
                                                    }
                                                    let _e956 = phi_1472_;
                                                    phi_1473_ = _e956;
                                                }
                                                let _e958 = phi_1473_;
                                                let _e961 = local_25.member[0u];
                                                let _e963 = keys.member[_e961];
                                                local_18 = array<array<u32, 2>, 6>(array<u32, 2>(_e963[0][0], _e963[0][1]), array<u32, 2>(_e963[1][0], _e963[1][1]), array<u32, 2>(_e963[2][0], _e963[2][1]), array<u32, 2>(_e963[3][0], _e963[3][1]), array<u32, 2>(_e963[4][0], _e963[4][1]), array<u32, 2>(_e963[5][0], _e963[5][1]));
                                                let _e990 = local_18[_e717.member_1];
                                                phi_1524_ = type_21(1u, 3u);
                                                phi_1527_ = array<u32, 2>(_e990[0], _e990[1]);
                                                loop {
                                                    let _e995 = phi_1524_;
                                                    let _e997 = phi_1527_;
                                                    local_34 = _e997;
                                                    local_36 = _e997;
                                                    local_38 = _e997;
                                                    if (_e995.member < _e995.member_1) {
                                                        phi_1525_ = type_21((_e995.member + 1u), _e995.member_1);
                                                        phi_1550_ = type_21(1u, _e995.member);
                                                    } else {
                                                        phi_1525_ = _e995;
                                                        phi_1550_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1009 = phi_1525_;
                                                    let _e1011 = phi_1550_;
                                                    let _e1015 = (bitcast<i32>(_e1011.member) != 0i);
                                                    if _e1015 {
                                                        let _e1017 = local_25.member[_e1011.member_1];
                                                        let _e1019 = keys.member[_e1017];
                                                        local_19 = array<array<u32, 2>, 6>(array<u32, 2>(_e1019[0][0], _e1019[0][1]), array<u32, 2>(_e1019[1][0], _e1019[1][1]), array<u32, 2>(_e1019[2][0], _e1019[2][1]), array<u32, 2>(_e1019[3][0], _e1019[3][1]), array<u32, 2>(_e1019[4][0], _e1019[4][1]), array<u32, 2>(_e1019[5][0], _e1019[5][1]));
                                                        let _e1046 = local_19[_e717.member_1];
                                                        if (_e997[1] > _e1046[1]) {
                                                            phi_1626_ = true;
                                                        } else {
                                                            if (_e997[1] == _e1046[1]) {
                                                                phi_1625_ = (_e997[0] > _e1046[0]);
                                                            } else {
                                                                phi_1625_ = false;
                                                            }
                                                            let _e1057 = phi_1625_;
                                                            phi_1626_ = _e1057;
                                                        }
                                                        let _e1059 = phi_1626_;
                                                        if _e1059 {
                                                            phi_1630_ = array<u32, 2>(_e1046[0], _e1046[1]);
                                                        } else {
                                                            phi_1630_ = _e997;
                                                        }
                                                        let _e1061 = phi_1630_;
                                                        phi_1528_ = _e1061;
                                                    } else {
                                                        phi_1528_ = array<u32, 2>();
                                                    }
                                                    let _e1063 = phi_1528_;
                                                    continue;
                                                    continuing {
                                                        phi_1524_ = _e1009;
                                                        phi_1527_ = _e1063;
                                                        break if !(_e1015);
                                                    }
                                                }
                                                let _e1066 = local_24.member[0u];
                                                let _e1068 = keys.member[_e1066];
                                                local_16 = array<array<u32, 2>, 6>(array<u32, 2>(_e1068[0][0], _e1068[0][1]), array<u32, 2>(_e1068[1][0], _e1068[1][1]), array<u32, 2>(_e1068[2][0], _e1068[2][1]), array<u32, 2>(_e1068[3][0], _e1068[3][1]), array<u32, 2>(_e1068[4][0], _e1068[4][1]), array<u32, 2>(_e1068[5][0], _e1068[5][1]));
                                                let _e1096 = local_16[(3u + _e717.member_1)];
                                                phi_1681_ = type_21(1u, 3u);
                                                phi_1684_ = array<u32, 2>(_e1096[0], _e1096[1]);
                                                loop {
                                                    let _e1101 = phi_1681_;
                                                    let _e1103 = phi_1684_;
                                                    local_35 = _e1103;
                                                    local_37 = _e1103;
                                                    local_39 = _e1103;
                                                    if (_e1101.member < _e1101.member_1) {
                                                        phi_1682_ = type_21((_e1101.member + 1u), _e1101.member_1);
                                                        phi_1707_ = type_21(1u, _e1101.member);
                                                    } else {
                                                        phi_1682_ = _e1101;
                                                        phi_1707_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1115 = phi_1682_;
                                                    let _e1117 = phi_1707_;
                                                    let _e1121 = (bitcast<i32>(_e1117.member) != 0i);
                                                    if _e1121 {
                                                        let _e1123 = local_24.member[_e1117.member_1];
                                                        let _e1125 = keys.member[_e1123];
                                                        local_17 = array<array<u32, 2>, 6>(array<u32, 2>(_e1125[0][0], _e1125[0][1]), array<u32, 2>(_e1125[1][0], _e1125[1][1]), array<u32, 2>(_e1125[2][0], _e1125[2][1]), array<u32, 2>(_e1125[3][0], _e1125[3][1]), array<u32, 2>(_e1125[4][0], _e1125[4][1]), array<u32, 2>(_e1125[5][0], _e1125[5][1]));
                                                        let _e1153 = local_17[(3u + _e717.member_1)];
                                                        if (_e1153[1] > _e1103[1]) {
                                                            phi_1784_ = true;
                                                        } else {
                                                            if (_e1153[1] == _e1103[1]) {
                                                                phi_1783_ = (_e1153[0] > _e1103[0]);
                                                            } else {
                                                                phi_1783_ = false;
                                                            }
                                                            let _e1164 = phi_1783_;
                                                            phi_1784_ = _e1164;
                                                        }
                                                        let _e1166 = phi_1784_;
                                                        if _e1166 {
                                                            phi_1788_ = array<u32, 2>(_e1153[0], _e1153[1]);
                                                        } else {
                                                            phi_1788_ = _e1103;
                                                        }
                                                        let _e1168 = phi_1788_;
                                                        phi_1685_ = _e1168;
                                                    } else {
                                                        phi_1685_ = array<u32, 2>();
                                                    }
                                                    let _e1170 = phi_1685_;
                                                    continue;
                                                    continuing {
                                                        phi_1681_ = _e1115;
                                                        phi_1684_ = _e1170;
                                                        break if !(_e1121);
                                                    }
                                                }
                                                let _e1173 = local_34;
                                                let _e1176 = local_35;
                                                if (_e1173[1] > _e1176[1]) {
                                                    phi_1805_ = true;
                                                } else {
                                                    let _e1180 = local_36;
                                                    let _e1183 = local_37;
                                                    if (_e1180[1] == _e1183[1]) {
                                                        let _e1187 = local_38;
                                                        let _e1190 = local_39;
                                                        phi_1804_ = (_e1187[0] > _e1190[0]);
                                                    } else {
                                                        phi_1804_ = false;
                                                    }
                                                    let _e1194 = phi_1804_;
                                                    phi_1805_ = _e1194;
                                                }
                                                let _e1196 = phi_1805_;
                                                phi_1113_ = (_e703 && (!(_e958) && !(_e1196)));
                                            } else {
                                                phi_1113_ = bool();
                                            }
                                            let _e1201 = phi_1113_;
                                            continue;
                                            continuing {
                                                phi_1109_ = _e715;
                                                phi_1112_ = _e1201;
                                                break if !(_e721);
                                            }
                                        }
                                        let _e5528 = local_71;
                                        phi_1809_ = _e5528;
                                    }
                                    let _e1204 = phi_1809_;
                                    phi_1810_ = _e1204;
                                    phi_1811_ = _e697;
                                } else {
                                    phi_1810_ = bool();
                                    phi_1811_ = true;
                                }
                                let _e1206 = phi_1810_;
                                let _e1208 = phi_1811_;
                                if _e1208 {
                                    phi_1815_ = false;
                                } else {
                                    phi_1815_ = true;
                                }
                                let _e1210 = phi_1815_;
                                phi_1816_ = _e1206;
                                phi_1817_ = _e1210;
                            } else {
                                phi_1816_ = false;
                                phi_1817_ = true;
                            }
                            let _e1212 = phi_1816_;
                            let _e1214 = phi_1817_;
                            phi_1818_ = _e1212;
                            phi_1819_ = _e1214;
                        } else {
                            phi_1818_ = false;
                            phi_1819_ = true;
                        }
                        let _e1216 = phi_1818_;
                        let _e1218 = phi_1819_;
                        if _e1218 {
                            phi_1823_ = _e1216;
                        } else {
                            phi_1823_ = true;
                        }
                        let _e1220 = phi_1823_;
                        if _e1220 {
                            let _e1222 = params.member.member_16;
                            let _e1224 = local_24.member_1;
                            let _e1226 = local_25.member_1;
                            let _e1228 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e1228 + 1u) < _e1228) {
                                let _e1232 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e1228 < _e1222) {
                                atomicStore((&output.member[(4u + (2u * _e1228))]), _e1224);
                                atomicStore((&output.member[((2u * _e1228) + 5u)]), _e1226);
                            }
                            let _e1241 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e1241 + 1u) < _e1241) {
                                let _e1245 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1888_ = (_e482 & (_e482 - 1u));
                        phi_1889_ = true;
                    }
                    let _e1247 = phi_1888_;
                    let _e1249 = phi_1889_;
                    phi_816_ = _e1247;
                    phi_1890_ = _e1249;
                } else {
                    phi_816_ = u32();
                    phi_1890_ = false;
                }
                let _e1251 = phi_816_;
                let _e1253 = phi_1890_;
                continue;
                continuing {
                    phi_812_ = _e494;
                    phi_815_ = _e1251;
                    break if !(_e1253);
                }
            }
            workgroupBarrier();
            let _e1256 = atomicLoad((&counters[4u]));
            if (2048u < _e1256) {
                phi_1897_ = 2048u;
            } else {
                phi_1897_ = _e1256;
            }
            let _e1259 = phi_1897_;
            phi_1900_ = type_21(0u, 16u);
            loop {
                let _e1261 = phi_1900_;
                if (_e1261.member < _e1261.member_1) {
                    phi_1901_ = type_21((_e1261.member + 1u), _e1261.member_1);
                    phi_1924_ = type_21(1u, _e1261.member);
                } else {
                    phi_1901_ = _e1261;
                    phi_1924_ = type_21(0u, type_21().member_1);
                }
                let _e1273 = phi_1901_;
                let _e1275 = phi_1924_;
                if (bitcast<i32>(_e1275.member) != 0i) {
                    let _e1281 = (_e97 + (_e1275.member_1 * 128u));
                    if (_e1281 >= _e1259) {
                        phi_8126_ = false;
                    } else {
                        let _e1284 = hits[_e1281];
                        let _e1287 = ((_e1284 >> bitcast<u32>(10i)) & 3u);
                        let _e1294 = firsts[(2u * _e1287)];
                        let _e1295 = (_e1294 + ((_e1284 >> bitcast<u32>(5i)) & 31u));
                        let _e1299 = firsts[((2u * _e1287) + 1u)];
                        let _e1300 = (_e1299 + (_e1284 & 31u));
                        let _e1302 = leaves.member[_e1295];
                        let _e1304 = leaves.member[_e1300];
                        local_26 = type_16(array<u32, 3>(_e1302.member[0], _e1302.member[1], _e1302.member[2]), _e1302.member_1);
                        local_27 = type_16(array<u32, 3>(_e1304.member[0], _e1304.member[1], _e1304.member[2]), _e1304.member_1);
                        let _e1320 = nodes.member[_e1295];
                        let _e1322 = nodes.member[_e1300];
                        let _e1324 = params.member.member_1;
                        if ((_e1324 & 1u) != 0u) {
                            let _e1328 = params.member.member_8;
                            if (_e1328 == 0u) {
                                let _e1372 = local_26.member[0u];
                                let _e1375 = local_27.member[0u];
                                if (_e1372 == _e1375) {
                                    phi_2043_ = bool();
                                    phi_2044_ = true;
                                } else {
                                    let _e1379 = local_26.member[0u];
                                    let _e1382 = local_27.member[1u];
                                    let _e1383 = (_e1379 == _e1382);
                                    if _e1383 {
                                        phi_2042_ = bool();
                                    } else {
                                        let _e1386 = local_26.member[0u];
                                        let _e1389 = local_27.member[2u];
                                        phi_2042_ = (_e1386 == _e1389);
                                    }
                                    let _e1392 = phi_2042_;
                                    phi_2043_ = _e1392;
                                    phi_2044_ = _e1383;
                                }
                                let _e1394 = phi_2043_;
                                let _e1396 = phi_2044_;
                                if _e1396 {
                                    phi_2048_ = true;
                                } else {
                                    phi_2048_ = _e1394;
                                }
                                let _e1398 = phi_2048_;
                                phi_2087_ = _e1398;
                            } else {
                                let _e1332 = local_26.member[0u];
                                let _e1335 = local_27.member[0u];
                                if (_e1332 == _e1335) {
                                    phi_2081_ = bool();
                                    phi_2082_ = true;
                                } else {
                                    let _e1339 = local_26.member[0u];
                                    let _e1342 = local_27.member[1u];
                                    if (_e1339 == _e1342) {
                                        phi_2079_ = bool();
                                        phi_2080_ = true;
                                    } else {
                                        let _e1346 = local_26.member[1u];
                                        let _e1349 = local_27.member[0u];
                                        let _e1350 = (_e1346 == _e1349);
                                        if _e1350 {
                                            phi_2078_ = bool();
                                        } else {
                                            let _e1353 = local_26.member[1u];
                                            let _e1356 = local_27.member[1u];
                                            phi_2078_ = (_e1353 == _e1356);
                                        }
                                        let _e1359 = phi_2078_;
                                        phi_2079_ = _e1359;
                                        phi_2080_ = _e1350;
                                    }
                                    let _e1361 = phi_2079_;
                                    let _e1363 = phi_2080_;
                                    phi_2081_ = _e1361;
                                    phi_2082_ = _e1363;
                                }
                                let _e1365 = phi_2081_;
                                let _e1367 = phi_2082_;
                                if _e1367 {
                                    phi_2086_ = true;
                                } else {
                                    phi_2086_ = _e1365;
                                }
                                let _e1369 = phi_2086_;
                                phi_2087_ = _e1369;
                            }
                            let _e1400 = phi_2087_;
                            if _e1400 {
                                phi_2091_ = false;
                            } else {
                                phi_2091_ = true;
                            }
                            let _e1402 = phi_2091_;
                            phi_2092_ = _e1402;
                        } else {
                            phi_2092_ = true;
                        }
                        let _e1404 = phi_2092_;
                        if _e1404 {
                            let _e1406 = params.member.member_1;
                            if ((_e1406 & 2u) != 0u) {
                                let _e1411 = local_26.member[0u];
                                let _e1413 = bodies.member[_e1411];
                                let _e1416 = local_27.member[0u];
                                let _e1418 = bodies.member[_e1416];
                                if ((_e1413 / 2u) == (_e1418 / 2u)) {
                                    let _e1423 = params.member.member_1;
                                    phi_2138_ = !(((_e1423 & 4u) != 0u));
                                } else {
                                    phi_2138_ = false;
                                }
                                let _e1428 = phi_2138_;
                                if _e1428 {
                                    phi_2149_ = true;
                                } else {
                                    if (((_e1413 & _e1418) & 1u) == 0u) {
                                        phi_2148_ = false;
                                    } else {
                                        phi_2148_ = true;
                                    }
                                    let _e1433 = phi_2148_;
                                    phi_2149_ = _e1433;
                                }
                                let _e1435 = phi_2149_;
                                if _e1435 {
                                    phi_2153_ = false;
                                } else {
                                    phi_2153_ = true;
                                }
                                let _e1437 = phi_2153_;
                                phi_2154_ = _e1437;
                            } else {
                                phi_2154_ = true;
                            }
                            let _e1439 = phi_2154_;
                            if _e1439 {
                                let _e1441 = params.member.member_1;
                                if ((_e1441 & 32u) != 0u) {
                                    let _e1445 = params.member.member_6;
                                    let _e1486 = (((((((_e1320.member_1[0] - _e1322.member[0]) > _e1445) && ((_e1322.member_1[0] - _e1320.member[0]) > _e1445)) && ((_e1320.member_1[1] - _e1322.member[1]) > _e1445)) && ((_e1322.member_1[1] - _e1320.member[1]) > _e1445)) && ((_e1320.member_1[2] - _e1322.member[2]) > _e1445)) && ((_e1322.member_1[2] - _e1320.member[2]) > _e1445));
                                    if _e1486 {
                                        phi_2903_ = bool();
                                    } else {
                                        phi_2203_ = type_21(0u, 3u);
                                        phi_2206_ = true;
                                        loop {
                                            let _e1490 = phi_2203_;
                                            let _e1492 = phi_2206_;
                                            local_72 = _e1492;
                                            if (_e1490.member < _e1490.member_1) {
                                                phi_2204_ = type_21((_e1490.member + 1u), _e1490.member_1);
                                                phi_2229_ = type_21(1u, _e1490.member);
                                            } else {
                                                phi_2204_ = _e1490;
                                                phi_2229_ = type_21(0u, type_21().member_1);
                                            }
                                            let _e1504 = phi_2204_;
                                            let _e1506 = phi_2229_;
                                            let _e1510 = (bitcast<i32>(_e1506.member) != 0i);
                                            if _e1510 {
                                                let _e1512 = local_26.member[0u];
                                                let _e1514 = keys.member[_e1512];
                                                local_14 = array<array<u32, 2>, 6>(array<u32, 2>(_e1514[0][0], _e1514[0][1]), array<u32, 2>(_e1514[1][0], _e1514[1][1]), array<u32, 2>(_e1514[2][0], _e1514[2][1]), array<u32, 2>(_e1514[3][0], _e1514[3][1]), array<u32, 2>(_e1514[4][0], _e1514[4][1]), array<u32, 2>(_e1514[5][0], _e1514[5][1]));
                                                let _e1541 = local_14[_e1506.member_1];
                                                phi_2286_ = type_21(1u, 3u);
                                                phi_2289_ = array<u32, 2>(_e1541[0], _e1541[1]);
                                                loop {
                                                    let _e1546 = phi_2286_;
                                                    let _e1548 = phi_2289_;
                                                    local_40 = _e1548;
                                                    local_42 = _e1548;
                                                    local_44 = _e1548;
                                                    if (_e1546.member < _e1546.member_1) {
                                                        phi_2287_ = type_21((_e1546.member + 1u), _e1546.member_1);
                                                        phi_2312_ = type_21(1u, _e1546.member);
                                                    } else {
                                                        phi_2287_ = _e1546;
                                                        phi_2312_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1560 = phi_2287_;
                                                    let _e1562 = phi_2312_;
                                                    let _e1566 = (bitcast<i32>(_e1562.member) != 0i);
                                                    if _e1566 {
                                                        let _e1568 = local_26.member[_e1562.member_1];
                                                        let _e1570 = keys.member[_e1568];
                                                        local_15 = array<array<u32, 2>, 6>(array<u32, 2>(_e1570[0][0], _e1570[0][1]), array<u32, 2>(_e1570[1][0], _e1570[1][1]), array<u32, 2>(_e1570[2][0], _e1570[2][1]), array<u32, 2>(_e1570[3][0], _e1570[3][1]), array<u32, 2>(_e1570[4][0], _e1570[4][1]), array<u32, 2>(_e1570[5][0], _e1570[5][1]));
                                                        let _e1597 = local_15[_e1506.member_1];
                                                        if (_e1548[1] > _e1597[1]) {
                                                            phi_2388_ = true;
                                                        } else {
                                                            if (_e1548[1] == _e1597[1]) {
                                                                phi_2387_ = (_e1548[0] > _e1597[0]);
                                                            } else {
                                                                phi_2387_ = false;
                                                            }
                                                            let _e1608 = phi_2387_;
                                                            phi_2388_ = _e1608;
                                                        }
                                                        let _e1610 = phi_2388_;
                                                        if _e1610 {
                                                            phi_2392_ = array<u32, 2>(_e1597[0], _e1597[1]);
                                                        } else {
                                                            phi_2392_ = _e1548;
                                                        }
                                                        let _e1612 = phi_2392_;
                                                        phi_2290_ = _e1612;
                                                    } else {
                                                        phi_2290_ = array<u32, 2>();
                                                    }
                                                    let _e1614 = phi_2290_;
                                                    continue;
                                                    continuing {
                                                        phi_2286_ = _e1560;
                                                        phi_2289_ = _e1614;
                                                        break if !(_e1566);
                                                    }
                                                }
                                                let _e1617 = local_27.member[0u];
                                                let _e1619 = keys.member[_e1617];
                                                local_12 = array<array<u32, 2>, 6>(array<u32, 2>(_e1619[0][0], _e1619[0][1]), array<u32, 2>(_e1619[1][0], _e1619[1][1]), array<u32, 2>(_e1619[2][0], _e1619[2][1]), array<u32, 2>(_e1619[3][0], _e1619[3][1]), array<u32, 2>(_e1619[4][0], _e1619[4][1]), array<u32, 2>(_e1619[5][0], _e1619[5][1]));
                                                let _e1647 = local_12[(3u + _e1506.member_1)];
                                                phi_2443_ = type_21(1u, 3u);
                                                phi_2446_ = array<u32, 2>(_e1647[0], _e1647[1]);
                                                loop {
                                                    let _e1652 = phi_2443_;
                                                    let _e1654 = phi_2446_;
                                                    local_41 = _e1654;
                                                    local_43 = _e1654;
                                                    local_45 = _e1654;
                                                    if (_e1652.member < _e1652.member_1) {
                                                        phi_2444_ = type_21((_e1652.member + 1u), _e1652.member_1);
                                                        phi_2469_ = type_21(1u, _e1652.member);
                                                    } else {
                                                        phi_2444_ = _e1652;
                                                        phi_2469_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1666 = phi_2444_;
                                                    let _e1668 = phi_2469_;
                                                    let _e1672 = (bitcast<i32>(_e1668.member) != 0i);
                                                    if _e1672 {
                                                        let _e1674 = local_27.member[_e1668.member_1];
                                                        let _e1676 = keys.member[_e1674];
                                                        local_13 = array<array<u32, 2>, 6>(array<u32, 2>(_e1676[0][0], _e1676[0][1]), array<u32, 2>(_e1676[1][0], _e1676[1][1]), array<u32, 2>(_e1676[2][0], _e1676[2][1]), array<u32, 2>(_e1676[3][0], _e1676[3][1]), array<u32, 2>(_e1676[4][0], _e1676[4][1]), array<u32, 2>(_e1676[5][0], _e1676[5][1]));
                                                        let _e1704 = local_13[(3u + _e1506.member_1)];
                                                        if (_e1704[1] > _e1654[1]) {
                                                            phi_2546_ = true;
                                                        } else {
                                                            if (_e1704[1] == _e1654[1]) {
                                                                phi_2545_ = (_e1704[0] > _e1654[0]);
                                                            } else {
                                                                phi_2545_ = false;
                                                            }
                                                            let _e1715 = phi_2545_;
                                                            phi_2546_ = _e1715;
                                                        }
                                                        let _e1717 = phi_2546_;
                                                        if _e1717 {
                                                            phi_2550_ = array<u32, 2>(_e1704[0], _e1704[1]);
                                                        } else {
                                                            phi_2550_ = _e1654;
                                                        }
                                                        let _e1719 = phi_2550_;
                                                        phi_2447_ = _e1719;
                                                    } else {
                                                        phi_2447_ = array<u32, 2>();
                                                    }
                                                    let _e1721 = phi_2447_;
                                                    continue;
                                                    continuing {
                                                        phi_2443_ = _e1666;
                                                        phi_2446_ = _e1721;
                                                        break if !(_e1672);
                                                    }
                                                }
                                                let _e1724 = local_40;
                                                let _e1727 = local_41;
                                                if (_e1724[1] > _e1727[1]) {
                                                    phi_2567_ = true;
                                                } else {
                                                    let _e1731 = local_42;
                                                    let _e1734 = local_43;
                                                    if (_e1731[1] == _e1734[1]) {
                                                        let _e1738 = local_44;
                                                        let _e1741 = local_45;
                                                        phi_2566_ = (_e1738[0] > _e1741[0]);
                                                    } else {
                                                        phi_2566_ = false;
                                                    }
                                                    let _e1745 = phi_2566_;
                                                    phi_2567_ = _e1745;
                                                }
                                                let _e1747 = phi_2567_;
                                                let _e1750 = local_27.member[0u];
                                                let _e1752 = keys.member[_e1750];
                                                local_10 = array<array<u32, 2>, 6>(array<u32, 2>(_e1752[0][0], _e1752[0][1]), array<u32, 2>(_e1752[1][0], _e1752[1][1]), array<u32, 2>(_e1752[2][0], _e1752[2][1]), array<u32, 2>(_e1752[3][0], _e1752[3][1]), array<u32, 2>(_e1752[4][0], _e1752[4][1]), array<u32, 2>(_e1752[5][0], _e1752[5][1]));
                                                let _e1779 = local_10[_e1506.member_1];
                                                phi_2618_ = type_21(1u, 3u);
                                                phi_2621_ = array<u32, 2>(_e1779[0], _e1779[1]);
                                                loop {
                                                    let _e1784 = phi_2618_;
                                                    let _e1786 = phi_2621_;
                                                    local_46 = _e1786;
                                                    local_48 = _e1786;
                                                    local_50 = _e1786;
                                                    if (_e1784.member < _e1784.member_1) {
                                                        phi_2619_ = type_21((_e1784.member + 1u), _e1784.member_1);
                                                        phi_2644_ = type_21(1u, _e1784.member);
                                                    } else {
                                                        phi_2619_ = _e1784;
                                                        phi_2644_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1798 = phi_2619_;
                                                    let _e1800 = phi_2644_;
                                                    let _e1804 = (bitcast<i32>(_e1800.member) != 0i);
                                                    if _e1804 {
                                                        let _e1806 = local_27.member[_e1800.member_1];
                                                        let _e1808 = keys.member[_e1806];
                                                        local_11 = array<array<u32, 2>, 6>(array<u32, 2>(_e1808[0][0], _e1808[0][1]), array<u32, 2>(_e1808[1][0], _e1808[1][1]), array<u32, 2>(_e1808[2][0], _e1808[2][1]), array<u32, 2>(_e1808[3][0], _e1808[3][1]), array<u32, 2>(_e1808[4][0], _e1808[4][1]), array<u32, 2>(_e1808[5][0], _e1808[5][1]));
                                                        let _e1835 = local_11[_e1506.member_1];
                                                        if (_e1786[1] > _e1835[1]) {
                                                            phi_2720_ = true;
                                                        } else {
                                                            if (_e1786[1] == _e1835[1]) {
                                                                phi_2719_ = (_e1786[0] > _e1835[0]);
                                                            } else {
                                                                phi_2719_ = false;
                                                            }
                                                            let _e1846 = phi_2719_;
                                                            phi_2720_ = _e1846;
                                                        }
                                                        let _e1848 = phi_2720_;
                                                        if _e1848 {
                                                            phi_2724_ = array<u32, 2>(_e1835[0], _e1835[1]);
                                                        } else {
                                                            phi_2724_ = _e1786;
                                                        }
                                                        let _e1850 = phi_2724_;
                                                        phi_2622_ = _e1850;
                                                    } else {
                                                        phi_2622_ = array<u32, 2>();
                                                    }
                                                    let _e1852 = phi_2622_;
                                                    continue;
                                                    continuing {
                                                        phi_2618_ = _e1798;
                                                        phi_2621_ = _e1852;
                                                        break if !(_e1804);
                                                    }
                                                }
                                                let _e1855 = local_26.member[0u];
                                                let _e1857 = keys.member[_e1855];
                                                local_8 = array<array<u32, 2>, 6>(array<u32, 2>(_e1857[0][0], _e1857[0][1]), array<u32, 2>(_e1857[1][0], _e1857[1][1]), array<u32, 2>(_e1857[2][0], _e1857[2][1]), array<u32, 2>(_e1857[3][0], _e1857[3][1]), array<u32, 2>(_e1857[4][0], _e1857[4][1]), array<u32, 2>(_e1857[5][0], _e1857[5][1]));
                                                let _e1885 = local_8[(3u + _e1506.member_1)];
                                                phi_2775_ = type_21(1u, 3u);
                                                phi_2778_ = array<u32, 2>(_e1885[0], _e1885[1]);
                                                loop {
                                                    let _e1890 = phi_2775_;
                                                    let _e1892 = phi_2778_;
                                                    local_47 = _e1892;
                                                    local_49 = _e1892;
                                                    local_51 = _e1892;
                                                    if (_e1890.member < _e1890.member_1) {
                                                        phi_2776_ = type_21((_e1890.member + 1u), _e1890.member_1);
                                                        phi_2801_ = type_21(1u, _e1890.member);
                                                    } else {
                                                        phi_2776_ = _e1890;
                                                        phi_2801_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1904 = phi_2776_;
                                                    let _e1906 = phi_2801_;
                                                    let _e1910 = (bitcast<i32>(_e1906.member) != 0i);
                                                    if _e1910 {
                                                        let _e1912 = local_26.member[_e1906.member_1];
                                                        let _e1914 = keys.member[_e1912];
                                                        local_9 = array<array<u32, 2>, 6>(array<u32, 2>(_e1914[0][0], _e1914[0][1]), array<u32, 2>(_e1914[1][0], _e1914[1][1]), array<u32, 2>(_e1914[2][0], _e1914[2][1]), array<u32, 2>(_e1914[3][0], _e1914[3][1]), array<u32, 2>(_e1914[4][0], _e1914[4][1]), array<u32, 2>(_e1914[5][0], _e1914[5][1]));
                                                        let _e1942 = local_9[(3u + _e1506.member_1)];
                                                        if (_e1942[1] > _e1892[1]) {
                                                            phi_2878_ = true;
                                                        } else {
                                                            if (_e1942[1] == _e1892[1]) {
                                                                phi_2877_ = (_e1942[0] > _e1892[0]);
                                                            } else {
                                                                phi_2877_ = false;
                                                            }
                                                            let _e1953 = phi_2877_;
                                                            phi_2878_ = _e1953;
                                                        }
                                                        let _e1955 = phi_2878_;
                                                        if _e1955 {
                                                            phi_2882_ = array<u32, 2>(_e1942[0], _e1942[1]);
                                                        } else {
                                                            phi_2882_ = _e1892;
                                                        }
                                                        let _e1957 = phi_2882_;
                                                        phi_2779_ = _e1957;
                                                    } else {
                                                        phi_2779_ = array<u32, 2>();
                                                    }
                                                    let _e1959 = phi_2779_;
                                                    continue;
                                                    continuing {
                                                        phi_2775_ = _e1904;
                                                        phi_2778_ = _e1959;
                                                        break if !(_e1910);
                                                    }
                                                }
                                                let _e1962 = local_46;
                                                let _e1965 = local_47;
                                                if (_e1962[1] > _e1965[1]) {
                                                    phi_2899_ = true;
                                                } else {
                                                    let _e1969 = local_48;
                                                    let _e1972 = local_49;
                                                    if (_e1969[1] == _e1972[1]) {
                                                        let _e1976 = local_50;
                                                        let _e1979 = local_51;
                                                        phi_2898_ = (_e1976[0] > _e1979[0]);
                                                    } else {
                                                        phi_2898_ = false;
                                                    }
                                                    let _e1983 = phi_2898_;
                                                    phi_2899_ = _e1983;
                                                }
                                                let _e1985 = phi_2899_;
                                                phi_2207_ = (_e1492 && (!(_e1747) && !(_e1985)));
                                            } else {
                                                phi_2207_ = bool();
                                            }
                                            let _e1990 = phi_2207_;
                                            continue;
                                            continuing {
                                                phi_2203_ = _e1504;
                                                phi_2206_ = _e1990;
                                                break if !(_e1510);
                                            }
                                        }
                                        let _e5618 = local_72;
                                        phi_2903_ = _e5618;
                                    }
                                    let _e1993 = phi_2903_;
                                    phi_2904_ = _e1993;
                                    phi_2905_ = _e1486;
                                } else {
                                    phi_2904_ = bool();
                                    phi_2905_ = true;
                                }
                                let _e1995 = phi_2904_;
                                let _e1997 = phi_2905_;
                                if _e1997 {
                                    phi_2909_ = false;
                                } else {
                                    phi_2909_ = true;
                                }
                                let _e1999 = phi_2909_;
                                phi_2910_ = _e1995;
                                phi_2911_ = _e1999;
                            } else {
                                phi_2910_ = false;
                                phi_2911_ = true;
                            }
                            let _e2001 = phi_2910_;
                            let _e2003 = phi_2911_;
                            phi_2912_ = _e2001;
                            phi_2913_ = _e2003;
                        } else {
                            phi_2912_ = false;
                            phi_2913_ = true;
                        }
                        let _e2005 = phi_2912_;
                        let _e2007 = phi_2913_;
                        if _e2007 {
                            phi_2917_ = _e2005;
                        } else {
                            phi_2917_ = true;
                        }
                        let _e2009 = phi_2917_;
                        if _e2009 {
                            let _e2011 = atomicAdd((&counters[7u]), 1u);
                            let _e2013 = params.member.member_4;
                            let _e2015 = params.member.member_5;
                            let _e2018 = local_26.member[0u];
                            let _e2021 = local_27.member[0u];
                            let _e2024 = local_27.member[1u];
                            let _e2027 = local_27.member[2u];
                            let _e2029 = paths.member[_e2018];
                            let _e2031 = paths.member[_e2021];
                            let _e2037 = paths.member[_e2024];
                            let _e2039 = paths.member[_e2027];
                            local_7 = type_35(array<array<f32, 3>, 2>(array<f32, 3>((_e2029.member[0] - _e2031.member[0]), (_e2029.member[1] - _e2031.member[1]), (_e2029.member[2] - _e2031.member[2])), array<f32, 3>((_e2029.member_1[0] - _e2031.member_1[0]), (_e2029.member_1[1] - _e2031.member_1[1]), (_e2029.member_1[2] - _e2031.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e2037.member[0] - _e2031.member[0]), (_e2037.member[1] - _e2031.member[1]), (_e2037.member[2] - _e2031.member[2])), array<f32, 3>((_e2037.member_1[0] - _e2031.member_1[0]), (_e2037.member_1[1] - _e2031.member_1[1]), (_e2037.member_1[2] - _e2031.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e2039.member[0] - _e2031.member[0]), (_e2039.member[1] - _e2031.member[1]), (_e2039.member[2] - _e2031.member[2])), array<f32, 3>((_e2039.member_1[0] - _e2031.member_1[0]), (_e2039.member_1[1] - _e2031.member_1[1]), (_e2039.member_1[2] - _e2031.member_1[2]))), (_e2013 + _e2013));
                            let _e2099 = local_7.member_1[0u];
                            let _e2105 = local_7.member_2[0u];
                            let _e2111 = ((_e2099[1] * _e2105[2]) - (_e2099[2] * _e2105[1]));
                            let _e2114 = ((_e2099[2] * _e2105[0]) - (_e2099[0] * _e2105[2]));
                            let _e2117 = ((_e2099[0] * _e2105[1]) - (_e2099[1] * _e2105[0]));
                            let _e2120 = local_7.member_1[1u];
                            let _e2126 = local_7.member_2[1u];
                            let _e2132 = ((_e2120[1] * _e2126[2]) - (_e2120[2] * _e2126[1]));
                            let _e2135 = ((_e2120[2] * _e2126[0]) - (_e2120[0] * _e2126[2]));
                            let _e2138 = ((_e2120[0] * _e2126[1]) - (_e2120[1] * _e2126[0]));
                            let _e2141 = local_7.member_1[0u];
                            let _e2147 = local_7.member_2[1u];
                            let _e2162 = local_7.member_1[1u];
                            let _e2168 = local_7.member_2[0u];
                            let _e2181 = (((_e2141[1] * _e2147[2]) - (_e2141[2] * _e2147[1])) + ((_e2162[1] * _e2168[2]) - (_e2162[2] * _e2168[1])));
                            let _e2182 = (((_e2141[2] * _e2147[0]) - (_e2141[0] * _e2147[2])) + ((_e2162[2] * _e2168[0]) - (_e2162[0] * _e2168[2])));
                            let _e2183 = (((_e2141[0] * _e2147[1]) - (_e2141[1] * _e2147[0])) + ((_e2162[0] * _e2168[1]) - (_e2162[1] * _e2168[0])));
                            let _e2186 = local_7.member[0u];
                            let _e2197 = local_7.member[1u];
                            let _e2208 = local_7.member[0u];
                            let _e2217 = ((((_e2197[0] * _e2111) + (_e2197[1] * _e2114)) + (_e2197[2] * _e2117)) + (((_e2208[0] * _e2181) + (_e2208[1] * _e2182)) + (_e2208[2] * _e2183)));
                            let _e2220 = local_7.member[0u];
                            let _e2231 = local_7.member[1u];
                            let _e2240 = ((((_e2220[0] * _e2132) + (_e2220[1] * _e2135)) + (_e2220[2] * _e2138)) + (((_e2231[0] * _e2181) + (_e2231[1] * _e2182)) + (_e2231[2] * _e2183)));
                            let _e2243 = local_7.member[1u];
                            let _e2254 = local_7.member[0u];
                            if (_e2254[0] < 0f) {
                                phi_3315_ = -(_e2254[0]);
                            } else {
                                phi_3315_ = _e2254[0];
                            }
                            let _e2261 = phi_3315_;
                            if (_e2254[1] < 0f) {
                                phi_3322_ = -(_e2254[1]);
                            } else {
                                phi_3322_ = _e2254[1];
                            }
                            let _e2265 = phi_3322_;
                            if (_e2261 > _e2265) {
                                phi_3327_ = _e2261;
                            } else {
                                phi_3327_ = _e2265;
                            }
                            let _e2268 = phi_3327_;
                            if (_e2254[2] < 0f) {
                                phi_3334_ = -(_e2254[2]);
                            } else {
                                phi_3334_ = _e2254[2];
                            }
                            let _e2272 = phi_3334_;
                            if (_e2268 > _e2272) {
                                phi_3339_ = _e2268;
                            } else {
                                phi_3339_ = _e2272;
                            }
                            let _e2275 = phi_3339_;
                            let _e2278 = local_7.member[1u];
                            if (_e2278[0] < 0f) {
                                phi_3352_ = -(_e2278[0]);
                            } else {
                                phi_3352_ = _e2278[0];
                            }
                            let _e2285 = phi_3352_;
                            if (_e2278[1] < 0f) {
                                phi_3359_ = -(_e2278[1]);
                            } else {
                                phi_3359_ = _e2278[1];
                            }
                            let _e2289 = phi_3359_;
                            if (_e2285 > _e2289) {
                                phi_3364_ = _e2285;
                            } else {
                                phi_3364_ = _e2289;
                            }
                            let _e2292 = phi_3364_;
                            if (_e2278[2] < 0f) {
                                phi_3371_ = -(_e2278[2]);
                            } else {
                                phi_3371_ = _e2278[2];
                            }
                            let _e2296 = phi_3371_;
                            if (_e2292 > _e2296) {
                                phi_3376_ = _e2292;
                            } else {
                                phi_3376_ = _e2296;
                            }
                            let _e2299 = phi_3376_;
                            if (_e2275 > _e2299) {
                                phi_3381_ = _e2275;
                            } else {
                                phi_3381_ = _e2299;
                            }
                            let _e2302 = phi_3381_;
                            let _e2304 = local_7.member_3;
                            let _e2305 = (_e2302 + _e2304);
                            let _e2308 = local_7.member_1[0u];
                            if (_e2308[0] < 0f) {
                                phi_3398_ = -(_e2308[0]);
                            } else {
                                phi_3398_ = _e2308[0];
                            }
                            let _e2315 = phi_3398_;
                            if (_e2308[1] < 0f) {
                                phi_3405_ = -(_e2308[1]);
                            } else {
                                phi_3405_ = _e2308[1];
                            }
                            let _e2319 = phi_3405_;
                            if (_e2315 > _e2319) {
                                phi_3410_ = _e2315;
                            } else {
                                phi_3410_ = _e2319;
                            }
                            let _e2322 = phi_3410_;
                            if (_e2308[2] < 0f) {
                                phi_3417_ = -(_e2308[2]);
                            } else {
                                phi_3417_ = _e2308[2];
                            }
                            let _e2326 = phi_3417_;
                            if (_e2322 > _e2326) {
                                phi_3422_ = _e2322;
                            } else {
                                phi_3422_ = _e2326;
                            }
                            let _e2329 = phi_3422_;
                            let _e2332 = local_7.member_1[1u];
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
                            if (_e2329 > _e2353) {
                                phi_3465_ = _e2329;
                            } else {
                                phi_3465_ = _e2353;
                            }
                            let _e2356 = phi_3465_;
                            let _e2358 = local_7.member_3;
                            let _e2359 = (_e2356 + _e2358);
                            let _e2362 = local_7.member_2[0u];
                            if (_e2362[0] < 0f) {
                                phi_3482_ = -(_e2362[0]);
                            } else {
                                phi_3482_ = _e2362[0];
                            }
                            let _e2369 = phi_3482_;
                            if (_e2362[1] < 0f) {
                                phi_3489_ = -(_e2362[1]);
                            } else {
                                phi_3489_ = _e2362[1];
                            }
                            let _e2373 = phi_3489_;
                            if (_e2369 > _e2373) {
                                phi_3494_ = _e2369;
                            } else {
                                phi_3494_ = _e2373;
                            }
                            let _e2376 = phi_3494_;
                            if (_e2362[2] < 0f) {
                                phi_3501_ = -(_e2362[2]);
                            } else {
                                phi_3501_ = _e2362[2];
                            }
                            let _e2380 = phi_3501_;
                            if (_e2376 > _e2380) {
                                phi_3506_ = _e2376;
                            } else {
                                phi_3506_ = _e2380;
                            }
                            let _e2383 = phi_3506_;
                            let _e2386 = local_7.member_2[1u];
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
                            if (_e2383 > _e2407) {
                                phi_3549_ = _e2383;
                            } else {
                                phi_3549_ = _e2407;
                            }
                            let _e2410 = phi_3549_;
                            let _e2412 = local_7.member_3;
                            let _e2413 = (_e2410 + _e2412);
                            let _e2415 = ((_e2359 * 8f) * _e2413);
                            let _e2422 = local_7.member_3;
                            if (_e2111 < 0f) {
                                phi_3580_ = -(_e2111);
                            } else {
                                phi_3580_ = _e2111;
                            }
                            let _e2439 = phi_3580_;
                            if (_e2114 < 0f) {
                                phi_3586_ = -(_e2114);
                            } else {
                                phi_3586_ = _e2114;
                            }
                            let _e2443 = phi_3586_;
                            if (_e2117 < 0f) {
                                phi_3593_ = -(_e2117);
                            } else {
                                phi_3593_ = _e2117;
                            }
                            let _e2448 = phi_3593_;
                            let _e2449 = ((_e2439 + _e2443) + _e2448);
                            if (_e2132 < 0f) {
                                phi_3600_ = -(_e2132);
                            } else {
                                phi_3600_ = _e2132;
                            }
                            let _e2453 = phi_3600_;
                            if (_e2135 < 0f) {
                                phi_3606_ = -(_e2135);
                            } else {
                                phi_3606_ = _e2135;
                            }
                            let _e2457 = phi_3606_;
                            if (_e2138 < 0f) {
                                phi_3613_ = -(_e2138);
                            } else {
                                phi_3613_ = _e2138;
                            }
                            let _e2462 = phi_3613_;
                            let _e2463 = ((_e2453 + _e2457) + _e2462);
                            if (_e2449 > _e2463) {
                                phi_3619_ = _e2449;
                            } else {
                                phi_3619_ = _e2463;
                            }
                            let _e2466 = phi_3619_;
                            if (_e2181 < 0f) {
                                phi_3625_ = -(_e2181);
                            } else {
                                phi_3625_ = _e2181;
                            }
                            let _e2470 = phi_3625_;
                            if (_e2182 < 0f) {
                                phi_3631_ = -(_e2182);
                            } else {
                                phi_3631_ = _e2182;
                            }
                            let _e2474 = phi_3631_;
                            if (_e2183 < 0f) {
                                phi_3638_ = -(_e2183);
                            } else {
                                phi_3638_ = _e2183;
                            }
                            let _e2479 = phi_3638_;
                            let _e2481 = (((_e2470 + _e2474) + _e2479) * 0.5f);
                            if (_e2466 > _e2481) {
                                phi_3645_ = _e2466;
                            } else {
                                phi_3645_ = _e2481;
                            }
                            let _e2484 = phi_3645_;
                            let _e2489 = local_7.member_3;
                            let _e2502 = ((((_e2186[0] * _e2111) + (_e2186[1] * _e2114)) + (_e2186[2] * _e2117)) * 3f);
                            let _e2503 = ((((_e2243[0] * _e2132) + (_e2243[1] * _e2135)) + (_e2243[2] * _e2138)) * 3f);
                            if (_e2502 < _e2503) {
                                phi_3669_ = _e2502;
                            } else {
                                phi_3669_ = _e2503;
                            }
                            let _e2506 = phi_3669_;
                            if (_e2217 < _e2240) {
                                phi_3674_ = _e2217;
                            } else {
                                phi_3674_ = _e2240;
                            }
                            let _e2509 = phi_3674_;
                            if (_e2506 < _e2509) {
                                phi_3679_ = _e2506;
                            } else {
                                phi_3679_ = _e2509;
                            }
                            let _e2512 = phi_3679_;
                            if (_e2502 > _e2503) {
                                phi_3684_ = _e2502;
                            } else {
                                phi_3684_ = _e2503;
                            }
                            let _e2515 = phi_3684_;
                            if (_e2217 > _e2240) {
                                phi_3689_ = _e2217;
                            } else {
                                phi_3689_ = _e2240;
                            }
                            let _e2518 = phi_3689_;
                            if (_e2515 > _e2518) {
                                phi_3694_ = _e2515;
                            } else {
                                phi_3694_ = _e2518;
                            }
                            let _e2521 = phi_3694_;
                            let _e2526 = -(_e2521);
                            if (_e2512 > _e2526) {
                                phi_3704_ = _e2512;
                            } else {
                                phi_3704_ = _e2526;
                            }
                            let _e2529 = phi_3704_;
                            if ((_e2529 - ((((((_e2305 * 8f) * _e2415) * (0.000000059604645f * (490f / 64f))) + ((_e2422 * 19f) * ((_e2305 * (_e2359 + _e2413)) + (_e2359 * _e2413)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2305) * ((1f + _e2359) * (1f + _e2413))))) + ((_e2015 * (((_e2484 + (_e2415 * (0.000000059604645f * 4f))) + ((_e2489 * 6f) * (_e2359 + _e2413))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2359) * (1f + _e2413))))) * (3f * 1.0001f)))) > 0f) {
                                phi_4680_ = true;
                            } else {
                                let _e2534 = local_7.member_1[0u];
                                let _e2540 = local_7.member_1[1u];
                                let _e2544 = (_e2534[0] + _e2540[0]);
                                let _e2545 = (_e2534[1] + _e2540[1]);
                                let _e2546 = (_e2534[2] + _e2540[2]);
                                let _e2549 = local_7.member_2[0u];
                                let _e2555 = local_7.member_2[1u];
                                let _e2559 = (_e2549[0] + _e2555[0]);
                                let _e2560 = (_e2549[1] + _e2555[1]);
                                let _e2561 = (_e2549[2] + _e2555[2]);
                                let _e2564 = ((_e2545 * _e2561) - (_e2546 * _e2560));
                                let _e2567 = ((_e2546 * _e2559) - (_e2544 * _e2561));
                                let _e2570 = ((_e2544 * _e2560) - (_e2545 * _e2559));
                                let _e2573 = local_7.member[0u];
                                let _e2579 = local_7.member_1[0u];
                                let _e2585 = local_7.member_2[0u];
                                let _e2597 = local_7.member[1u];
                                let _e2603 = local_7.member_1[1u];
                                let _e2609 = local_7.member_2[1u];
                                local_5 = array<array<f32, 3>, 4>(_e2573, array<f32, 3>((_e2573[0] - _e2579[0]), (_e2573[1] - _e2579[1]), (_e2573[2] - _e2579[2])), array<f32, 3>((_e2573[0] - _e2585[0]), (_e2573[1] - _e2585[1]), (_e2573[2] - _e2585[2])), _e2573);
                                local_6 = array<array<f32, 3>, 4>(_e2597, array<f32, 3>((_e2597[0] - _e2603[0]), (_e2597[1] - _e2603[1]), (_e2597[2] - _e2603[2])), array<f32, 3>((_e2597[0] - _e2609[0]), (_e2597[1] - _e2609[1]), (_e2597[2] - _e2609[2])), _e2597);
                                let _e2627 = local_7.member[0u];
                                if (_e2627[0] < 0f) {
                                    phi_3955_ = -(_e2627[0]);
                                } else {
                                    phi_3955_ = _e2627[0];
                                }
                                let _e2634 = phi_3955_;
                                if (_e2627[1] < 0f) {
                                    phi_3962_ = -(_e2627[1]);
                                } else {
                                    phi_3962_ = _e2627[1];
                                }
                                let _e2638 = phi_3962_;
                                if (_e2634 > _e2638) {
                                    phi_3967_ = _e2634;
                                } else {
                                    phi_3967_ = _e2638;
                                }
                                let _e2641 = phi_3967_;
                                if (_e2627[2] < 0f) {
                                    phi_3974_ = -(_e2627[2]);
                                } else {
                                    phi_3974_ = _e2627[2];
                                }
                                let _e2645 = phi_3974_;
                                if (_e2641 > _e2645) {
                                    phi_3979_ = _e2641;
                                } else {
                                    phi_3979_ = _e2645;
                                }
                                let _e2648 = phi_3979_;
                                let _e2651 = local_7.member[1u];
                                if (_e2651[0] < 0f) {
                                    phi_3992_ = -(_e2651[0]);
                                } else {
                                    phi_3992_ = _e2651[0];
                                }
                                let _e2658 = phi_3992_;
                                if (_e2651[1] < 0f) {
                                    phi_3999_ = -(_e2651[1]);
                                } else {
                                    phi_3999_ = _e2651[1];
                                }
                                let _e2662 = phi_3999_;
                                if (_e2658 > _e2662) {
                                    phi_4004_ = _e2658;
                                } else {
                                    phi_4004_ = _e2662;
                                }
                                let _e2665 = phi_4004_;
                                if (_e2651[2] < 0f) {
                                    phi_4011_ = -(_e2651[2]);
                                } else {
                                    phi_4011_ = _e2651[2];
                                }
                                let _e2669 = phi_4011_;
                                if (_e2665 > _e2669) {
                                    phi_4016_ = _e2665;
                                } else {
                                    phi_4016_ = _e2669;
                                }
                                let _e2672 = phi_4016_;
                                if (_e2648 > _e2672) {
                                    phi_4021_ = _e2648;
                                } else {
                                    phi_4021_ = _e2672;
                                }
                                let _e2675 = phi_4021_;
                                let _e2677 = local_7.member_3;
                                let _e2681 = local_7.member_1[0u];
                                if (_e2681[0] < 0f) {
                                    phi_4038_ = -(_e2681[0]);
                                } else {
                                    phi_4038_ = _e2681[0];
                                }
                                let _e2688 = phi_4038_;
                                if (_e2681[1] < 0f) {
                                    phi_4045_ = -(_e2681[1]);
                                } else {
                                    phi_4045_ = _e2681[1];
                                }
                                let _e2692 = phi_4045_;
                                if (_e2688 > _e2692) {
                                    phi_4050_ = _e2688;
                                } else {
                                    phi_4050_ = _e2692;
                                }
                                let _e2695 = phi_4050_;
                                if (_e2681[2] < 0f) {
                                    phi_4057_ = -(_e2681[2]);
                                } else {
                                    phi_4057_ = _e2681[2];
                                }
                                let _e2699 = phi_4057_;
                                if (_e2695 > _e2699) {
                                    phi_4062_ = _e2695;
                                } else {
                                    phi_4062_ = _e2699;
                                }
                                let _e2702 = phi_4062_;
                                let _e2705 = local_7.member_1[1u];
                                if (_e2705[0] < 0f) {
                                    phi_4076_ = -(_e2705[0]);
                                } else {
                                    phi_4076_ = _e2705[0];
                                }
                                let _e2712 = phi_4076_;
                                if (_e2705[1] < 0f) {
                                    phi_4083_ = -(_e2705[1]);
                                } else {
                                    phi_4083_ = _e2705[1];
                                }
                                let _e2716 = phi_4083_;
                                if (_e2712 > _e2716) {
                                    phi_4088_ = _e2712;
                                } else {
                                    phi_4088_ = _e2716;
                                }
                                let _e2719 = phi_4088_;
                                if (_e2705[2] < 0f) {
                                    phi_4095_ = -(_e2705[2]);
                                } else {
                                    phi_4095_ = _e2705[2];
                                }
                                let _e2723 = phi_4095_;
                                if (_e2719 > _e2723) {
                                    phi_4100_ = _e2719;
                                } else {
                                    phi_4100_ = _e2723;
                                }
                                let _e2726 = phi_4100_;
                                if (_e2702 > _e2726) {
                                    phi_4105_ = _e2702;
                                } else {
                                    phi_4105_ = _e2726;
                                }
                                let _e2729 = phi_4105_;
                                let _e2731 = local_7.member_3;
                                let _e2735 = local_7.member_2[0u];
                                if (_e2735[0] < 0f) {
                                    phi_4122_ = -(_e2735[0]);
                                } else {
                                    phi_4122_ = _e2735[0];
                                }
                                let _e2742 = phi_4122_;
                                if (_e2735[1] < 0f) {
                                    phi_4129_ = -(_e2735[1]);
                                } else {
                                    phi_4129_ = _e2735[1];
                                }
                                let _e2746 = phi_4129_;
                                if (_e2742 > _e2746) {
                                    phi_4134_ = _e2742;
                                } else {
                                    phi_4134_ = _e2746;
                                }
                                let _e2749 = phi_4134_;
                                if (_e2735[2] < 0f) {
                                    phi_4141_ = -(_e2735[2]);
                                } else {
                                    phi_4141_ = _e2735[2];
                                }
                                let _e2753 = phi_4141_;
                                if (_e2749 > _e2753) {
                                    phi_4146_ = _e2749;
                                } else {
                                    phi_4146_ = _e2753;
                                }
                                let _e2756 = phi_4146_;
                                let _e2759 = local_7.member_2[1u];
                                if (_e2759[0] < 0f) {
                                    phi_4160_ = -(_e2759[0]);
                                } else {
                                    phi_4160_ = _e2759[0];
                                }
                                let _e2766 = phi_4160_;
                                if (_e2759[1] < 0f) {
                                    phi_4167_ = -(_e2759[1]);
                                } else {
                                    phi_4167_ = _e2759[1];
                                }
                                let _e2770 = phi_4167_;
                                if (_e2766 > _e2770) {
                                    phi_4172_ = _e2766;
                                } else {
                                    phi_4172_ = _e2770;
                                }
                                let _e2773 = phi_4172_;
                                if (_e2759[2] < 0f) {
                                    phi_4179_ = -(_e2759[2]);
                                } else {
                                    phi_4179_ = _e2759[2];
                                }
                                let _e2777 = phi_4179_;
                                if (_e2773 > _e2777) {
                                    phi_4184_ = _e2773;
                                } else {
                                    phi_4184_ = _e2777;
                                }
                                let _e2780 = phi_4184_;
                                if (_e2756 > _e2780) {
                                    phi_4189_ = _e2756;
                                } else {
                                    phi_4189_ = _e2780;
                                }
                                let _e2783 = phi_4189_;
                                let _e2785 = local_7.member_3;
                                let _e2788 = (((_e2675 + _e2677) + (_e2729 + _e2731)) + (_e2783 + _e2785));
                                let _e2791 = local_7.member_3;
                                let _e2795 = (((_e2015 * 1.0001f) + (_e2791 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2798 = ((_e2567 * _e2546) - (_e2570 * _e2545));
                                let _e2801 = ((_e2570 * _e2544) - (_e2564 * _e2546));
                                let _e2804 = ((_e2564 * _e2545) - (_e2567 * _e2544));
                                let _e2806 = local_5[0u];
                                let _e2814 = (((_e2798 * _e2806[0]) + (_e2801 * _e2806[1])) + (_e2804 * _e2806[2]));
                                phi_4227_ = type_21(0u, 4u);
                                phi_4230_ = _e2814;
                                phi_4232_ = _e2814;
                                loop {
                                    let _e2816 = phi_4227_;
                                    let _e2818 = phi_4230_;
                                    let _e2820 = phi_4232_;
                                    local_52 = _e2818;
                                    local_53 = _e2820;
                                    local_73 = _e2820;
                                    if (_e2816.member < _e2816.member_1) {
                                        phi_4228_ = type_21((_e2816.member + 1u), _e2816.member_1);
                                        phi_4255_ = type_21(1u, _e2816.member);
                                    } else {
                                        phi_4228_ = _e2816;
                                        phi_4255_ = type_21(0u, type_21().member_1);
                                    }
                                    let _e2832 = phi_4228_;
                                    let _e2834 = phi_4255_;
                                    let _e2838 = (bitcast<i32>(_e2834.member) != 0i);
                                    if _e2838 {
                                        let _e2840 = local_5[_e2834.member_1];
                                        let _e2848 = (((_e2798 * _e2840[0]) + (_e2801 * _e2840[1])) + (_e2804 * _e2840[2]));
                                        let _e2850 = local_6[_e2834.member_1];
                                        let _e2858 = (((_e2798 * _e2850[0]) + (_e2801 * _e2850[1])) + (_e2804 * _e2850[2]));
                                        if (_e2820 < _e2848) {
                                            phi_4305_ = _e2820;
                                        } else {
                                            phi_4305_ = _e2848;
                                        }
                                        let _e2861 = phi_4305_;
                                        if (_e2861 < _e2858) {
                                            phi_4310_ = _e2861;
                                        } else {
                                            phi_4310_ = _e2858;
                                        }
                                        let _e2864 = phi_4310_;
                                        if (_e2818 > _e2848) {
                                            phi_4315_ = _e2818;
                                        } else {
                                            phi_4315_ = _e2848;
                                        }
                                        let _e2867 = phi_4315_;
                                        if (_e2867 > _e2858) {
                                            phi_4320_ = _e2867;
                                        } else {
                                            phi_4320_ = _e2858;
                                        }
                                        let _e2870 = phi_4320_;
                                        phi_4231_ = _e2870;
                                        phi_4233_ = _e2864;
                                    } else {
                                        phi_4231_ = f32();
                                        phi_4233_ = f32();
                                    }
                                    let _e2872 = phi_4231_;
                                    let _e2874 = phi_4233_;
                                    continue;
                                    continuing {
                                        phi_4227_ = _e2832;
                                        phi_4230_ = _e2872;
                                        phi_4232_ = _e2874;
                                        break if !(_e2838);
                                    }
                                }
                                if (_e2798 < 0f) {
                                    phi_4326_ = -(_e2798);
                                } else {
                                    phi_4326_ = _e2798;
                                }
                                let _e2879 = phi_4326_;
                                if (_e2801 < 0f) {
                                    phi_4332_ = -(_e2801);
                                } else {
                                    phi_4332_ = _e2801;
                                }
                                let _e2883 = phi_4332_;
                                if (_e2804 < 0f) {
                                    phi_4339_ = -(_e2804);
                                } else {
                                    phi_4339_ = _e2804;
                                }
                                let _e2888 = phi_4339_;
                                let _e2889 = ((_e2879 + _e2883) + _e2888);
                                let _e2894 = local_52;
                                let _e2895 = -(_e2894);
                                let _e2897 = local_53;
                                if (_e2897 > _e2895) {
                                    let _e5729 = local_73;
                                    phi_4349_ = _e5729;
                                } else {
                                    phi_4349_ = _e2895;
                                }
                                let _e2900 = phi_4349_;
                                let _e2905 = (((_e2900 - ((_e2889 * _e2788) * (0.000000059604645f * 17f))) - (_e2889 * _e2795)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2908 = ((_e2567 * _e2561) - (_e2570 * _e2560));
                                let _e2911 = ((_e2570 * _e2559) - (_e2564 * _e2561));
                                let _e2914 = ((_e2564 * _e2560) - (_e2567 * _e2559));
                                let _e2916 = local_5[0u];
                                let _e2924 = (((_e2908 * _e2916[0]) + (_e2911 * _e2916[1])) + (_e2914 * _e2916[2]));
                                phi_4380_ = type_21(0u, 4u);
                                phi_4383_ = _e2924;
                                phi_4385_ = _e2924;
                                loop {
                                    let _e2926 = phi_4380_;
                                    let _e2928 = phi_4383_;
                                    let _e2930 = phi_4385_;
                                    local_54 = _e2928;
                                    local_55 = _e2930;
                                    local_74 = _e2930;
                                    if (_e2926.member < _e2926.member_1) {
                                        phi_4381_ = type_21((_e2926.member + 1u), _e2926.member_1);
                                        phi_4408_ = type_21(1u, _e2926.member);
                                    } else {
                                        phi_4381_ = _e2926;
                                        phi_4408_ = type_21(0u, type_21().member_1);
                                    }
                                    let _e2942 = phi_4381_;
                                    let _e2944 = phi_4408_;
                                    let _e2948 = (bitcast<i32>(_e2944.member) != 0i);
                                    if _e2948 {
                                        let _e2950 = local_5[_e2944.member_1];
                                        let _e2958 = (((_e2908 * _e2950[0]) + (_e2911 * _e2950[1])) + (_e2914 * _e2950[2]));
                                        let _e2960 = local_6[_e2944.member_1];
                                        let _e2968 = (((_e2908 * _e2960[0]) + (_e2911 * _e2960[1])) + (_e2914 * _e2960[2]));
                                        if (_e2930 < _e2958) {
                                            phi_4458_ = _e2930;
                                        } else {
                                            phi_4458_ = _e2958;
                                        }
                                        let _e2971 = phi_4458_;
                                        if (_e2971 < _e2968) {
                                            phi_4463_ = _e2971;
                                        } else {
                                            phi_4463_ = _e2968;
                                        }
                                        let _e2974 = phi_4463_;
                                        if (_e2928 > _e2958) {
                                            phi_4468_ = _e2928;
                                        } else {
                                            phi_4468_ = _e2958;
                                        }
                                        let _e2977 = phi_4468_;
                                        if (_e2977 > _e2968) {
                                            phi_4473_ = _e2977;
                                        } else {
                                            phi_4473_ = _e2968;
                                        }
                                        let _e2980 = phi_4473_;
                                        phi_4384_ = _e2980;
                                        phi_4386_ = _e2974;
                                    } else {
                                        phi_4384_ = f32();
                                        phi_4386_ = f32();
                                    }
                                    let _e2982 = phi_4384_;
                                    let _e2984 = phi_4386_;
                                    continue;
                                    continuing {
                                        phi_4380_ = _e2942;
                                        phi_4383_ = _e2982;
                                        phi_4385_ = _e2984;
                                        break if !(_e2948);
                                    }
                                }
                                if (_e2908 < 0f) {
                                    phi_4479_ = -(_e2908);
                                } else {
                                    phi_4479_ = _e2908;
                                }
                                let _e2989 = phi_4479_;
                                if (_e2911 < 0f) {
                                    phi_4485_ = -(_e2911);
                                } else {
                                    phi_4485_ = _e2911;
                                }
                                let _e2993 = phi_4485_;
                                if (_e2914 < 0f) {
                                    phi_4492_ = -(_e2914);
                                } else {
                                    phi_4492_ = _e2914;
                                }
                                let _e2998 = phi_4492_;
                                let _e2999 = ((_e2989 + _e2993) + _e2998);
                                let _e3004 = local_54;
                                let _e3005 = -(_e3004);
                                let _e3007 = local_55;
                                if (_e3007 > _e3005) {
                                    let _e5748 = local_74;
                                    phi_4502_ = _e5748;
                                } else {
                                    phi_4502_ = _e3005;
                                }
                                let _e3010 = phi_4502_;
                                let _e3015 = (((_e3010 - ((_e2999 * _e2788) * (0.000000059604645f * 17f))) - (_e2999 * _e2795)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2905 > _e3015) {
                                    phi_4512_ = _e2905;
                                } else {
                                    phi_4512_ = _e3015;
                                }
                                let _e3018 = phi_4512_;
                                let _e3019 = (_e2559 - _e2544);
                                let _e3020 = (_e2560 - _e2545);
                                let _e3021 = (_e2561 - _e2546);
                                let _e3024 = ((_e2567 * _e3021) - (_e2570 * _e3020));
                                let _e3027 = ((_e2570 * _e3019) - (_e2564 * _e3021));
                                let _e3030 = ((_e2564 * _e3020) - (_e2567 * _e3019));
                                let _e3032 = local_5[0u];
                                let _e3040 = (((_e3024 * _e3032[0]) + (_e3027 * _e3032[1])) + (_e3030 * _e3032[2]));
                                phi_4545_ = type_21(0u, 4u);
                                phi_4548_ = _e3040;
                                phi_4550_ = _e3040;
                                loop {
                                    let _e3042 = phi_4545_;
                                    let _e3044 = phi_4548_;
                                    let _e3046 = phi_4550_;
                                    local_56 = _e3044;
                                    local_57 = _e3046;
                                    local_75 = _e3046;
                                    if (_e3042.member < _e3042.member_1) {
                                        phi_4546_ = type_21((_e3042.member + 1u), _e3042.member_1);
                                        phi_4573_ = type_21(1u, _e3042.member);
                                    } else {
                                        phi_4546_ = _e3042;
                                        phi_4573_ = type_21(0u, type_21().member_1);
                                    }
                                    let _e3058 = phi_4546_;
                                    let _e3060 = phi_4573_;
                                    let _e3064 = (bitcast<i32>(_e3060.member) != 0i);
                                    if _e3064 {
                                        let _e3066 = local_5[_e3060.member_1];
                                        let _e3074 = (((_e3024 * _e3066[0]) + (_e3027 * _e3066[1])) + (_e3030 * _e3066[2]));
                                        let _e3076 = local_6[_e3060.member_1];
                                        let _e3084 = (((_e3024 * _e3076[0]) + (_e3027 * _e3076[1])) + (_e3030 * _e3076[2]));
                                        if (_e3046 < _e3074) {
                                            phi_4623_ = _e3046;
                                        } else {
                                            phi_4623_ = _e3074;
                                        }
                                        let _e3087 = phi_4623_;
                                        if (_e3087 < _e3084) {
                                            phi_4628_ = _e3087;
                                        } else {
                                            phi_4628_ = _e3084;
                                        }
                                        let _e3090 = phi_4628_;
                                        if (_e3044 > _e3074) {
                                            phi_4633_ = _e3044;
                                        } else {
                                            phi_4633_ = _e3074;
                                        }
                                        let _e3093 = phi_4633_;
                                        if (_e3093 > _e3084) {
                                            phi_4638_ = _e3093;
                                        } else {
                                            phi_4638_ = _e3084;
                                        }
                                        let _e3096 = phi_4638_;
                                        phi_4549_ = _e3096;
                                        phi_4551_ = _e3090;
                                    } else {
                                        phi_4549_ = f32();
                                        phi_4551_ = f32();
                                    }
                                    let _e3098 = phi_4549_;
                                    let _e3100 = phi_4551_;
                                    continue;
                                    continuing {
                                        phi_4545_ = _e3058;
                                        phi_4548_ = _e3098;
                                        phi_4550_ = _e3100;
                                        break if !(_e3064);
                                    }
                                }
                                if (_e3024 < 0f) {
                                    phi_4644_ = -(_e3024);
                                } else {
                                    phi_4644_ = _e3024;
                                }
                                let _e3105 = phi_4644_;
                                if (_e3027 < 0f) {
                                    phi_4650_ = -(_e3027);
                                } else {
                                    phi_4650_ = _e3027;
                                }
                                let _e3109 = phi_4650_;
                                if (_e3030 < 0f) {
                                    phi_4657_ = -(_e3030);
                                } else {
                                    phi_4657_ = _e3030;
                                }
                                let _e3114 = phi_4657_;
                                let _e3115 = ((_e3105 + _e3109) + _e3114);
                                let _e3120 = local_56;
                                let _e3121 = -(_e3120);
                                let _e3123 = local_57;
                                if (_e3123 > _e3121) {
                                    let _e5768 = local_75;
                                    phi_4667_ = _e5768;
                                } else {
                                    phi_4667_ = _e3121;
                                }
                                let _e3126 = phi_4667_;
                                let _e3131 = (((_e3126 - ((_e3115 * _e2788) * (0.000000059604645f * 17f))) - (_e3115 * _e2795)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e3018 > _e3131) {
                                    phi_4677_ = _e3018;
                                } else {
                                    phi_4677_ = _e3131;
                                }
                                let _e3134 = phi_4677_;
                                phi_4680_ = (_e3134 > 0f);
                            }
                            let _e3137 = phi_4680_;
                            if _e3137 {
                                phi_8116_ = false;
                            } else {
                                let _e3140 = local_7.member[0u];
                                let _e3146 = local_7.member[1u];
                                let _e3153 = ((_e3140[0] + _e3146[0]) * 0.5f);
                                let _e3154 = ((_e3140[1] + _e3146[1]) * 0.5f);
                                let _e3155 = ((_e3140[2] + _e3146[2]) * 0.5f);
                                let _e3158 = local_7.member_1[0u];
                                let _e3164 = local_7.member_1[1u];
                                let _e3171 = ((_e3158[0] + _e3164[0]) * 0.5f);
                                let _e3172 = ((_e3158[1] + _e3164[1]) * 0.5f);
                                let _e3173 = ((_e3158[2] + _e3164[2]) * 0.5f);
                                let _e3176 = local_7.member_2[0u];
                                let _e3182 = local_7.member_2[1u];
                                let _e3189 = ((_e3176[0] + _e3182[0]) * 0.5f);
                                let _e3190 = ((_e3176[1] + _e3182[1]) * 0.5f);
                                let _e3191 = ((_e3176[2] + _e3182[2]) * 0.5f);
                                let _e3194 = local_7.member[0u];
                                let _e3197 = local_7.member_1[0u];
                                let _e3200 = local_7.member_2[0u];
                                let _e3202 = local_7.member_3;
                                let _e3205 = local_7.member[1u];
                                let _e3208 = local_7.member_1[1u];
                                let _e3211 = local_7.member_2[1u];
                                let _e3213 = local_7.member_3;
                                local_4 = array<type_35, 2>(type_35(array<array<f32, 3>, 2>(_e3194, array<f32, 3>(_e3153, _e3154, _e3155)), array<array<f32, 3>, 2>(_e3197, array<f32, 3>(_e3171, _e3172, _e3173)), array<array<f32, 3>, 2>(_e3200, array<f32, 3>(_e3189, _e3190, _e3191)), _e3202), type_35(array<array<f32, 3>, 2>(array<f32, 3>(_e3153, _e3154, _e3155), _e3205), array<array<f32, 3>, 2>(array<f32, 3>(_e3171, _e3172, _e3173), _e3208), array<array<f32, 3>, 2>(array<f32, 3>(_e3189, _e3190, _e3191), _e3211), _e3213));
                                let _e3232 = local_4[0u].member_1[0u];
                                let _e3238 = local_4[0u].member_2[0u];
                                let _e3244 = ((_e3232[1] * _e3238[2]) - (_e3232[2] * _e3238[1]));
                                let _e3247 = ((_e3232[2] * _e3238[0]) - (_e3232[0] * _e3238[2]));
                                let _e3250 = ((_e3232[0] * _e3238[1]) - (_e3232[1] * _e3238[0]));
                                let _e3253 = local_4[0u].member_1[1u];
                                let _e3259 = local_4[0u].member_2[1u];
                                let _e3265 = ((_e3253[1] * _e3259[2]) - (_e3253[2] * _e3259[1]));
                                let _e3268 = ((_e3253[2] * _e3259[0]) - (_e3253[0] * _e3259[2]));
                                let _e3271 = ((_e3253[0] * _e3259[1]) - (_e3253[1] * _e3259[0]));
                                let _e3274 = local_4[0u].member_1[0u];
                                let _e3280 = local_4[0u].member_2[1u];
                                let _e3295 = local_4[0u].member_1[1u];
                                let _e3301 = local_4[0u].member_2[0u];
                                let _e3314 = (((_e3274[1] * _e3280[2]) - (_e3274[2] * _e3280[1])) + ((_e3295[1] * _e3301[2]) - (_e3295[2] * _e3301[1])));
                                let _e3315 = (((_e3274[2] * _e3280[0]) - (_e3274[0] * _e3280[2])) + ((_e3295[2] * _e3301[0]) - (_e3295[0] * _e3301[2])));
                                let _e3316 = (((_e3274[0] * _e3280[1]) - (_e3274[1] * _e3280[0])) + ((_e3295[0] * _e3301[1]) - (_e3295[1] * _e3301[0])));
                                let _e3319 = local_4[0u].member[0u];
                                let _e3330 = local_4[0u].member[1u];
                                let _e3341 = local_4[0u].member[0u];
                                let _e3350 = ((((_e3330[0] * _e3244) + (_e3330[1] * _e3247)) + (_e3330[2] * _e3250)) + (((_e3341[0] * _e3314) + (_e3341[1] * _e3315)) + (_e3341[2] * _e3316)));
                                let _e3353 = local_4[0u].member[0u];
                                let _e3364 = local_4[0u].member[1u];
                                let _e3373 = ((((_e3353[0] * _e3265) + (_e3353[1] * _e3268)) + (_e3353[2] * _e3271)) + (((_e3364[0] * _e3314) + (_e3364[1] * _e3315)) + (_e3364[2] * _e3316)));
                                let _e3376 = local_4[0u].member[1u];
                                let _e3387 = local_4[0u].member[0u];
                                if (_e3387[0] < 0f) {
                                    phi_5137_ = -(_e3387[0]);
                                } else {
                                    phi_5137_ = _e3387[0];
                                }
                                let _e3394 = phi_5137_;
                                if (_e3387[1] < 0f) {
                                    phi_5144_ = -(_e3387[1]);
                                } else {
                                    phi_5144_ = _e3387[1];
                                }
                                let _e3398 = phi_5144_;
                                if (_e3394 > _e3398) {
                                    phi_5149_ = _e3394;
                                } else {
                                    phi_5149_ = _e3398;
                                }
                                let _e3401 = phi_5149_;
                                if (_e3387[2] < 0f) {
                                    phi_5156_ = -(_e3387[2]);
                                } else {
                                    phi_5156_ = _e3387[2];
                                }
                                let _e3405 = phi_5156_;
                                if (_e3401 > _e3405) {
                                    phi_5161_ = _e3401;
                                } else {
                                    phi_5161_ = _e3405;
                                }
                                let _e3408 = phi_5161_;
                                let _e3411 = local_4[0u].member[1u];
                                if (_e3411[0] < 0f) {
                                    phi_5174_ = -(_e3411[0]);
                                } else {
                                    phi_5174_ = _e3411[0];
                                }
                                let _e3418 = phi_5174_;
                                if (_e3411[1] < 0f) {
                                    phi_5181_ = -(_e3411[1]);
                                } else {
                                    phi_5181_ = _e3411[1];
                                }
                                let _e3422 = phi_5181_;
                                if (_e3418 > _e3422) {
                                    phi_5186_ = _e3418;
                                } else {
                                    phi_5186_ = _e3422;
                                }
                                let _e3425 = phi_5186_;
                                if (_e3411[2] < 0f) {
                                    phi_5193_ = -(_e3411[2]);
                                } else {
                                    phi_5193_ = _e3411[2];
                                }
                                let _e3429 = phi_5193_;
                                if (_e3425 > _e3429) {
                                    phi_5198_ = _e3425;
                                } else {
                                    phi_5198_ = _e3429;
                                }
                                let _e3432 = phi_5198_;
                                if (_e3408 > _e3432) {
                                    phi_5203_ = _e3408;
                                } else {
                                    phi_5203_ = _e3432;
                                }
                                let _e3435 = phi_5203_;
                                let _e3437 = local_4[0u].member_3;
                                let _e3438 = (_e3435 + _e3437);
                                let _e3441 = local_4[0u].member_1[0u];
                                if (_e3441[0] < 0f) {
                                    phi_5220_ = -(_e3441[0]);
                                } else {
                                    phi_5220_ = _e3441[0];
                                }
                                let _e3448 = phi_5220_;
                                if (_e3441[1] < 0f) {
                                    phi_5227_ = -(_e3441[1]);
                                } else {
                                    phi_5227_ = _e3441[1];
                                }
                                let _e3452 = phi_5227_;
                                if (_e3448 > _e3452) {
                                    phi_5232_ = _e3448;
                                } else {
                                    phi_5232_ = _e3452;
                                }
                                let _e3455 = phi_5232_;
                                if (_e3441[2] < 0f) {
                                    phi_5239_ = -(_e3441[2]);
                                } else {
                                    phi_5239_ = _e3441[2];
                                }
                                let _e3459 = phi_5239_;
                                if (_e3455 > _e3459) {
                                    phi_5244_ = _e3455;
                                } else {
                                    phi_5244_ = _e3459;
                                }
                                let _e3462 = phi_5244_;
                                let _e3465 = local_4[0u].member_1[1u];
                                if (_e3465[0] < 0f) {
                                    phi_5258_ = -(_e3465[0]);
                                } else {
                                    phi_5258_ = _e3465[0];
                                }
                                let _e3472 = phi_5258_;
                                if (_e3465[1] < 0f) {
                                    phi_5265_ = -(_e3465[1]);
                                } else {
                                    phi_5265_ = _e3465[1];
                                }
                                let _e3476 = phi_5265_;
                                if (_e3472 > _e3476) {
                                    phi_5270_ = _e3472;
                                } else {
                                    phi_5270_ = _e3476;
                                }
                                let _e3479 = phi_5270_;
                                if (_e3465[2] < 0f) {
                                    phi_5277_ = -(_e3465[2]);
                                } else {
                                    phi_5277_ = _e3465[2];
                                }
                                let _e3483 = phi_5277_;
                                if (_e3479 > _e3483) {
                                    phi_5282_ = _e3479;
                                } else {
                                    phi_5282_ = _e3483;
                                }
                                let _e3486 = phi_5282_;
                                if (_e3462 > _e3486) {
                                    phi_5287_ = _e3462;
                                } else {
                                    phi_5287_ = _e3486;
                                }
                                let _e3489 = phi_5287_;
                                let _e3491 = local_4[0u].member_3;
                                let _e3492 = (_e3489 + _e3491);
                                let _e3495 = local_4[0u].member_2[0u];
                                if (_e3495[0] < 0f) {
                                    phi_5304_ = -(_e3495[0]);
                                } else {
                                    phi_5304_ = _e3495[0];
                                }
                                let _e3502 = phi_5304_;
                                if (_e3495[1] < 0f) {
                                    phi_5311_ = -(_e3495[1]);
                                } else {
                                    phi_5311_ = _e3495[1];
                                }
                                let _e3506 = phi_5311_;
                                if (_e3502 > _e3506) {
                                    phi_5316_ = _e3502;
                                } else {
                                    phi_5316_ = _e3506;
                                }
                                let _e3509 = phi_5316_;
                                if (_e3495[2] < 0f) {
                                    phi_5323_ = -(_e3495[2]);
                                } else {
                                    phi_5323_ = _e3495[2];
                                }
                                let _e3513 = phi_5323_;
                                if (_e3509 > _e3513) {
                                    phi_5328_ = _e3509;
                                } else {
                                    phi_5328_ = _e3513;
                                }
                                let _e3516 = phi_5328_;
                                let _e3519 = local_4[0u].member_2[1u];
                                if (_e3519[0] < 0f) {
                                    phi_5342_ = -(_e3519[0]);
                                } else {
                                    phi_5342_ = _e3519[0];
                                }
                                let _e3526 = phi_5342_;
                                if (_e3519[1] < 0f) {
                                    phi_5349_ = -(_e3519[1]);
                                } else {
                                    phi_5349_ = _e3519[1];
                                }
                                let _e3530 = phi_5349_;
                                if (_e3526 > _e3530) {
                                    phi_5354_ = _e3526;
                                } else {
                                    phi_5354_ = _e3530;
                                }
                                let _e3533 = phi_5354_;
                                if (_e3519[2] < 0f) {
                                    phi_5361_ = -(_e3519[2]);
                                } else {
                                    phi_5361_ = _e3519[2];
                                }
                                let _e3537 = phi_5361_;
                                if (_e3533 > _e3537) {
                                    phi_5366_ = _e3533;
                                } else {
                                    phi_5366_ = _e3537;
                                }
                                let _e3540 = phi_5366_;
                                if (_e3516 > _e3540) {
                                    phi_5371_ = _e3516;
                                } else {
                                    phi_5371_ = _e3540;
                                }
                                let _e3543 = phi_5371_;
                                let _e3545 = local_4[0u].member_3;
                                let _e3546 = (_e3543 + _e3545);
                                let _e3548 = ((_e3492 * 8f) * _e3546);
                                let _e3555 = local_4[0u].member_3;
                                if (_e3244 < 0f) {
                                    phi_5402_ = -(_e3244);
                                } else {
                                    phi_5402_ = _e3244;
                                }
                                let _e3572 = phi_5402_;
                                if (_e3247 < 0f) {
                                    phi_5408_ = -(_e3247);
                                } else {
                                    phi_5408_ = _e3247;
                                }
                                let _e3576 = phi_5408_;
                                if (_e3250 < 0f) {
                                    phi_5415_ = -(_e3250);
                                } else {
                                    phi_5415_ = _e3250;
                                }
                                let _e3581 = phi_5415_;
                                let _e3582 = ((_e3572 + _e3576) + _e3581);
                                if (_e3265 < 0f) {
                                    phi_5422_ = -(_e3265);
                                } else {
                                    phi_5422_ = _e3265;
                                }
                                let _e3586 = phi_5422_;
                                if (_e3268 < 0f) {
                                    phi_5428_ = -(_e3268);
                                } else {
                                    phi_5428_ = _e3268;
                                }
                                let _e3590 = phi_5428_;
                                if (_e3271 < 0f) {
                                    phi_5435_ = -(_e3271);
                                } else {
                                    phi_5435_ = _e3271;
                                }
                                let _e3595 = phi_5435_;
                                let _e3596 = ((_e3586 + _e3590) + _e3595);
                                if (_e3582 > _e3596) {
                                    phi_5441_ = _e3582;
                                } else {
                                    phi_5441_ = _e3596;
                                }
                                let _e3599 = phi_5441_;
                                if (_e3314 < 0f) {
                                    phi_5447_ = -(_e3314);
                                } else {
                                    phi_5447_ = _e3314;
                                }
                                let _e3603 = phi_5447_;
                                if (_e3315 < 0f) {
                                    phi_5453_ = -(_e3315);
                                } else {
                                    phi_5453_ = _e3315;
                                }
                                let _e3607 = phi_5453_;
                                if (_e3316 < 0f) {
                                    phi_5460_ = -(_e3316);
                                } else {
                                    phi_5460_ = _e3316;
                                }
                                let _e3612 = phi_5460_;
                                let _e3614 = (((_e3603 + _e3607) + _e3612) * 0.5f);
                                if (_e3599 > _e3614) {
                                    phi_5467_ = _e3599;
                                } else {
                                    phi_5467_ = _e3614;
                                }
                                let _e3617 = phi_5467_;
                                let _e3622 = local_4[0u].member_3;
                                let _e3635 = ((((_e3319[0] * _e3244) + (_e3319[1] * _e3247)) + (_e3319[2] * _e3250)) * 3f);
                                let _e3636 = ((((_e3376[0] * _e3265) + (_e3376[1] * _e3268)) + (_e3376[2] * _e3271)) * 3f);
                                if (_e3635 < _e3636) {
                                    phi_5491_ = _e3635;
                                } else {
                                    phi_5491_ = _e3636;
                                }
                                let _e3639 = phi_5491_;
                                if (_e3350 < _e3373) {
                                    phi_5496_ = _e3350;
                                } else {
                                    phi_5496_ = _e3373;
                                }
                                let _e3642 = phi_5496_;
                                if (_e3639 < _e3642) {
                                    phi_5501_ = _e3639;
                                } else {
                                    phi_5501_ = _e3642;
                                }
                                let _e3645 = phi_5501_;
                                if (_e3635 > _e3636) {
                                    phi_5506_ = _e3635;
                                } else {
                                    phi_5506_ = _e3636;
                                }
                                let _e3648 = phi_5506_;
                                if (_e3350 > _e3373) {
                                    phi_5511_ = _e3350;
                                } else {
                                    phi_5511_ = _e3373;
                                }
                                let _e3651 = phi_5511_;
                                if (_e3648 > _e3651) {
                                    phi_5516_ = _e3648;
                                } else {
                                    phi_5516_ = _e3651;
                                }
                                let _e3654 = phi_5516_;
                                let _e3659 = -(_e3654);
                                if (_e3645 > _e3659) {
                                    phi_5526_ = _e3645;
                                } else {
                                    phi_5526_ = _e3659;
                                }
                                let _e3662 = phi_5526_;
                                if ((_e3662 - ((((((_e3438 * 8f) * _e3548) * (0.000000059604645f * (490f / 64f))) + ((_e3555 * 19f) * ((_e3438 * (_e3492 + _e3546)) + (_e3492 * _e3546)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3438) * ((1f + _e3492) * (1f + _e3546))))) + ((_e2015 * (((_e3617 + (_e3548 * (0.000000059604645f * 4f))) + ((_e3622 * 6f) * (_e3492 + _e3546))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3492) * (1f + _e3546))))) * (3f * 1.0001f)))) > 0f) {
                                    phi_6502_ = true;
                                } else {
                                    let _e3667 = local_4[0u].member_1[0u];
                                    let _e3673 = local_4[0u].member_1[1u];
                                    let _e3677 = (_e3667[0] + _e3673[0]);
                                    let _e3678 = (_e3667[1] + _e3673[1]);
                                    let _e3679 = (_e3667[2] + _e3673[2]);
                                    let _e3682 = local_4[0u].member_2[0u];
                                    let _e3688 = local_4[0u].member_2[1u];
                                    let _e3692 = (_e3682[0] + _e3688[0]);
                                    let _e3693 = (_e3682[1] + _e3688[1]);
                                    let _e3694 = (_e3682[2] + _e3688[2]);
                                    let _e3697 = ((_e3678 * _e3694) - (_e3679 * _e3693));
                                    let _e3700 = ((_e3679 * _e3692) - (_e3677 * _e3694));
                                    let _e3703 = ((_e3677 * _e3693) - (_e3678 * _e3692));
                                    let _e3706 = local_4[0u].member[0u];
                                    let _e3712 = local_4[0u].member_1[0u];
                                    let _e3718 = local_4[0u].member_2[0u];
                                    let _e3730 = local_4[0u].member[1u];
                                    let _e3736 = local_4[0u].member_1[1u];
                                    let _e3742 = local_4[0u].member_2[1u];
                                    local_2 = array<array<f32, 3>, 4>(_e3706, array<f32, 3>((_e3706[0] - _e3712[0]), (_e3706[1] - _e3712[1]), (_e3706[2] - _e3712[2])), array<f32, 3>((_e3706[0] - _e3718[0]), (_e3706[1] - _e3718[1]), (_e3706[2] - _e3718[2])), _e3706);
                                    local_3 = array<array<f32, 3>, 4>(_e3730, array<f32, 3>((_e3730[0] - _e3736[0]), (_e3730[1] - _e3736[1]), (_e3730[2] - _e3736[2])), array<f32, 3>((_e3730[0] - _e3742[0]), (_e3730[1] - _e3742[1]), (_e3730[2] - _e3742[2])), _e3730);
                                    let _e3760 = local_4[0u].member[0u];
                                    if (_e3760[0] < 0f) {
                                        phi_5777_ = -(_e3760[0]);
                                    } else {
                                        phi_5777_ = _e3760[0];
                                    }
                                    let _e3767 = phi_5777_;
                                    if (_e3760[1] < 0f) {
                                        phi_5784_ = -(_e3760[1]);
                                    } else {
                                        phi_5784_ = _e3760[1];
                                    }
                                    let _e3771 = phi_5784_;
                                    if (_e3767 > _e3771) {
                                        phi_5789_ = _e3767;
                                    } else {
                                        phi_5789_ = _e3771;
                                    }
                                    let _e3774 = phi_5789_;
                                    if (_e3760[2] < 0f) {
                                        phi_5796_ = -(_e3760[2]);
                                    } else {
                                        phi_5796_ = _e3760[2];
                                    }
                                    let _e3778 = phi_5796_;
                                    if (_e3774 > _e3778) {
                                        phi_5801_ = _e3774;
                                    } else {
                                        phi_5801_ = _e3778;
                                    }
                                    let _e3781 = phi_5801_;
                                    let _e3784 = local_4[0u].member[1u];
                                    if (_e3784[0] < 0f) {
                                        phi_5814_ = -(_e3784[0]);
                                    } else {
                                        phi_5814_ = _e3784[0];
                                    }
                                    let _e3791 = phi_5814_;
                                    if (_e3784[1] < 0f) {
                                        phi_5821_ = -(_e3784[1]);
                                    } else {
                                        phi_5821_ = _e3784[1];
                                    }
                                    let _e3795 = phi_5821_;
                                    if (_e3791 > _e3795) {
                                        phi_5826_ = _e3791;
                                    } else {
                                        phi_5826_ = _e3795;
                                    }
                                    let _e3798 = phi_5826_;
                                    if (_e3784[2] < 0f) {
                                        phi_5833_ = -(_e3784[2]);
                                    } else {
                                        phi_5833_ = _e3784[2];
                                    }
                                    let _e3802 = phi_5833_;
                                    if (_e3798 > _e3802) {
                                        phi_5838_ = _e3798;
                                    } else {
                                        phi_5838_ = _e3802;
                                    }
                                    let _e3805 = phi_5838_;
                                    if (_e3781 > _e3805) {
                                        phi_5843_ = _e3781;
                                    } else {
                                        phi_5843_ = _e3805;
                                    }
                                    let _e3808 = phi_5843_;
                                    let _e3810 = local_4[0u].member_3;
                                    let _e3814 = local_4[0u].member_1[0u];
                                    if (_e3814[0] < 0f) {
                                        phi_5860_ = -(_e3814[0]);
                                    } else {
                                        phi_5860_ = _e3814[0];
                                    }
                                    let _e3821 = phi_5860_;
                                    if (_e3814[1] < 0f) {
                                        phi_5867_ = -(_e3814[1]);
                                    } else {
                                        phi_5867_ = _e3814[1];
                                    }
                                    let _e3825 = phi_5867_;
                                    if (_e3821 > _e3825) {
                                        phi_5872_ = _e3821;
                                    } else {
                                        phi_5872_ = _e3825;
                                    }
                                    let _e3828 = phi_5872_;
                                    if (_e3814[2] < 0f) {
                                        phi_5879_ = -(_e3814[2]);
                                    } else {
                                        phi_5879_ = _e3814[2];
                                    }
                                    let _e3832 = phi_5879_;
                                    if (_e3828 > _e3832) {
                                        phi_5884_ = _e3828;
                                    } else {
                                        phi_5884_ = _e3832;
                                    }
                                    let _e3835 = phi_5884_;
                                    let _e3838 = local_4[0u].member_1[1u];
                                    if (_e3838[0] < 0f) {
                                        phi_5898_ = -(_e3838[0]);
                                    } else {
                                        phi_5898_ = _e3838[0];
                                    }
                                    let _e3845 = phi_5898_;
                                    if (_e3838[1] < 0f) {
                                        phi_5905_ = -(_e3838[1]);
                                    } else {
                                        phi_5905_ = _e3838[1];
                                    }
                                    let _e3849 = phi_5905_;
                                    if (_e3845 > _e3849) {
                                        phi_5910_ = _e3845;
                                    } else {
                                        phi_5910_ = _e3849;
                                    }
                                    let _e3852 = phi_5910_;
                                    if (_e3838[2] < 0f) {
                                        phi_5917_ = -(_e3838[2]);
                                    } else {
                                        phi_5917_ = _e3838[2];
                                    }
                                    let _e3856 = phi_5917_;
                                    if (_e3852 > _e3856) {
                                        phi_5922_ = _e3852;
                                    } else {
                                        phi_5922_ = _e3856;
                                    }
                                    let _e3859 = phi_5922_;
                                    if (_e3835 > _e3859) {
                                        phi_5927_ = _e3835;
                                    } else {
                                        phi_5927_ = _e3859;
                                    }
                                    let _e3862 = phi_5927_;
                                    let _e3864 = local_4[0u].member_3;
                                    let _e3868 = local_4[0u].member_2[0u];
                                    if (_e3868[0] < 0f) {
                                        phi_5944_ = -(_e3868[0]);
                                    } else {
                                        phi_5944_ = _e3868[0];
                                    }
                                    let _e3875 = phi_5944_;
                                    if (_e3868[1] < 0f) {
                                        phi_5951_ = -(_e3868[1]);
                                    } else {
                                        phi_5951_ = _e3868[1];
                                    }
                                    let _e3879 = phi_5951_;
                                    if (_e3875 > _e3879) {
                                        phi_5956_ = _e3875;
                                    } else {
                                        phi_5956_ = _e3879;
                                    }
                                    let _e3882 = phi_5956_;
                                    if (_e3868[2] < 0f) {
                                        phi_5963_ = -(_e3868[2]);
                                    } else {
                                        phi_5963_ = _e3868[2];
                                    }
                                    let _e3886 = phi_5963_;
                                    if (_e3882 > _e3886) {
                                        phi_5968_ = _e3882;
                                    } else {
                                        phi_5968_ = _e3886;
                                    }
                                    let _e3889 = phi_5968_;
                                    let _e3892 = local_4[0u].member_2[1u];
                                    if (_e3892[0] < 0f) {
                                        phi_5982_ = -(_e3892[0]);
                                    } else {
                                        phi_5982_ = _e3892[0];
                                    }
                                    let _e3899 = phi_5982_;
                                    if (_e3892[1] < 0f) {
                                        phi_5989_ = -(_e3892[1]);
                                    } else {
                                        phi_5989_ = _e3892[1];
                                    }
                                    let _e3903 = phi_5989_;
                                    if (_e3899 > _e3903) {
                                        phi_5994_ = _e3899;
                                    } else {
                                        phi_5994_ = _e3903;
                                    }
                                    let _e3906 = phi_5994_;
                                    if (_e3892[2] < 0f) {
                                        phi_6001_ = -(_e3892[2]);
                                    } else {
                                        phi_6001_ = _e3892[2];
                                    }
                                    let _e3910 = phi_6001_;
                                    if (_e3906 > _e3910) {
                                        phi_6006_ = _e3906;
                                    } else {
                                        phi_6006_ = _e3910;
                                    }
                                    let _e3913 = phi_6006_;
                                    if (_e3889 > _e3913) {
                                        phi_6011_ = _e3889;
                                    } else {
                                        phi_6011_ = _e3913;
                                    }
                                    let _e3916 = phi_6011_;
                                    let _e3918 = local_4[0u].member_3;
                                    let _e3921 = (((_e3808 + _e3810) + (_e3862 + _e3864)) + (_e3916 + _e3918));
                                    let _e3924 = local_4[0u].member_3;
                                    let _e3928 = (((_e2015 * 1.0001f) + (_e3924 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3931 = ((_e3700 * _e3679) - (_e3703 * _e3678));
                                    let _e3934 = ((_e3703 * _e3677) - (_e3697 * _e3679));
                                    let _e3937 = ((_e3697 * _e3678) - (_e3700 * _e3677));
                                    let _e3939 = local_2[0u];
                                    let _e3947 = (((_e3931 * _e3939[0]) + (_e3934 * _e3939[1])) + (_e3937 * _e3939[2]));
                                    phi_6049_ = type_21(0u, 4u);
                                    phi_6052_ = _e3947;
                                    phi_6054_ = _e3947;
                                    loop {
                                        let _e3949 = phi_6049_;
                                        let _e3951 = phi_6052_;
                                        let _e3953 = phi_6054_;
                                        local_58 = _e3951;
                                        local_59 = _e3953;
                                        local_76 = _e3953;
                                        if (_e3949.member < _e3949.member_1) {
                                            phi_6050_ = type_21((_e3949.member + 1u), _e3949.member_1);
                                            phi_6077_ = type_21(1u, _e3949.member);
                                        } else {
                                            phi_6050_ = _e3949;
                                            phi_6077_ = type_21(0u, type_21().member_1);
                                        }
                                        let _e3965 = phi_6050_;
                                        let _e3967 = phi_6077_;
                                        let _e3971 = (bitcast<i32>(_e3967.member) != 0i);
                                        if _e3971 {
                                            let _e3973 = local_2[_e3967.member_1];
                                            let _e3981 = (((_e3931 * _e3973[0]) + (_e3934 * _e3973[1])) + (_e3937 * _e3973[2]));
                                            let _e3983 = local_3[_e3967.member_1];
                                            let _e3991 = (((_e3931 * _e3983[0]) + (_e3934 * _e3983[1])) + (_e3937 * _e3983[2]));
                                            if (_e3953 < _e3981) {
                                                phi_6127_ = _e3953;
                                            } else {
                                                phi_6127_ = _e3981;
                                            }
                                            let _e3994 = phi_6127_;
                                            if (_e3994 < _e3991) {
                                                phi_6132_ = _e3994;
                                            } else {
                                                phi_6132_ = _e3991;
                                            }
                                            let _e3997 = phi_6132_;
                                            if (_e3951 > _e3981) {
                                                phi_6137_ = _e3951;
                                            } else {
                                                phi_6137_ = _e3981;
                                            }
                                            let _e4000 = phi_6137_;
                                            if (_e4000 > _e3991) {
                                                phi_6142_ = _e4000;
                                            } else {
                                                phi_6142_ = _e3991;
                                            }
                                            let _e4003 = phi_6142_;
                                            phi_6053_ = _e4003;
                                            phi_6055_ = _e3997;
                                        } else {
                                            phi_6053_ = f32();
                                            phi_6055_ = f32();
                                        }
                                        let _e4005 = phi_6053_;
                                        let _e4007 = phi_6055_;
                                        continue;
                                        continuing {
                                            phi_6049_ = _e3965;
                                            phi_6052_ = _e4005;
                                            phi_6054_ = _e4007;
                                            break if !(_e3971);
                                        }
                                    }
                                    if (_e3931 < 0f) {
                                        phi_6148_ = -(_e3931);
                                    } else {
                                        phi_6148_ = _e3931;
                                    }
                                    let _e4012 = phi_6148_;
                                    if (_e3934 < 0f) {
                                        phi_6154_ = -(_e3934);
                                    } else {
                                        phi_6154_ = _e3934;
                                    }
                                    let _e4016 = phi_6154_;
                                    if (_e3937 < 0f) {
                                        phi_6161_ = -(_e3937);
                                    } else {
                                        phi_6161_ = _e3937;
                                    }
                                    let _e4021 = phi_6161_;
                                    let _e4022 = ((_e4012 + _e4016) + _e4021);
                                    let _e4027 = local_58;
                                    let _e4028 = -(_e4027);
                                    let _e4030 = local_59;
                                    if (_e4030 > _e4028) {
                                        let _e5873 = local_76;
                                        phi_6171_ = _e5873;
                                    } else {
                                        phi_6171_ = _e4028;
                                    }
                                    let _e4033 = phi_6171_;
                                    let _e4038 = (((_e4033 - ((_e4022 * _e3921) * (0.000000059604645f * 17f))) - (_e4022 * _e3928)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e4041 = ((_e3700 * _e3694) - (_e3703 * _e3693));
                                    let _e4044 = ((_e3703 * _e3692) - (_e3697 * _e3694));
                                    let _e4047 = ((_e3697 * _e3693) - (_e3700 * _e3692));
                                    let _e4049 = local_2[0u];
                                    let _e4057 = (((_e4041 * _e4049[0]) + (_e4044 * _e4049[1])) + (_e4047 * _e4049[2]));
                                    phi_6202_ = type_21(0u, 4u);
                                    phi_6205_ = _e4057;
                                    phi_6207_ = _e4057;
                                    loop {
                                        let _e4059 = phi_6202_;
                                        let _e4061 = phi_6205_;
                                        let _e4063 = phi_6207_;
                                        local_60 = _e4061;
                                        local_61 = _e4063;
                                        local_77 = _e4063;
                                        if (_e4059.member < _e4059.member_1) {
                                            phi_6203_ = type_21((_e4059.member + 1u), _e4059.member_1);
                                            phi_6230_ = type_21(1u, _e4059.member);
                                        } else {
                                            phi_6203_ = _e4059;
                                            phi_6230_ = type_21(0u, type_21().member_1);
                                        }
                                        let _e4075 = phi_6203_;
                                        let _e4077 = phi_6230_;
                                        let _e4081 = (bitcast<i32>(_e4077.member) != 0i);
                                        if _e4081 {
                                            let _e4083 = local_2[_e4077.member_1];
                                            let _e4091 = (((_e4041 * _e4083[0]) + (_e4044 * _e4083[1])) + (_e4047 * _e4083[2]));
                                            let _e4093 = local_3[_e4077.member_1];
                                            let _e4101 = (((_e4041 * _e4093[0]) + (_e4044 * _e4093[1])) + (_e4047 * _e4093[2]));
                                            if (_e4063 < _e4091) {
                                                phi_6280_ = _e4063;
                                            } else {
                                                phi_6280_ = _e4091;
                                            }
                                            let _e4104 = phi_6280_;
                                            if (_e4104 < _e4101) {
                                                phi_6285_ = _e4104;
                                            } else {
                                                phi_6285_ = _e4101;
                                            }
                                            let _e4107 = phi_6285_;
                                            if (_e4061 > _e4091) {
                                                phi_6290_ = _e4061;
                                            } else {
                                                phi_6290_ = _e4091;
                                            }
                                            let _e4110 = phi_6290_;
                                            if (_e4110 > _e4101) {
                                                phi_6295_ = _e4110;
                                            } else {
                                                phi_6295_ = _e4101;
                                            }
                                            let _e4113 = phi_6295_;
                                            phi_6206_ = _e4113;
                                            phi_6208_ = _e4107;
                                        } else {
                                            phi_6206_ = f32();
                                            phi_6208_ = f32();
                                        }
                                        let _e4115 = phi_6206_;
                                        let _e4117 = phi_6208_;
                                        continue;
                                        continuing {
                                            phi_6202_ = _e4075;
                                            phi_6205_ = _e4115;
                                            phi_6207_ = _e4117;
                                            break if !(_e4081);
                                        }
                                    }
                                    if (_e4041 < 0f) {
                                        phi_6301_ = -(_e4041);
                                    } else {
                                        phi_6301_ = _e4041;
                                    }
                                    let _e4122 = phi_6301_;
                                    if (_e4044 < 0f) {
                                        phi_6307_ = -(_e4044);
                                    } else {
                                        phi_6307_ = _e4044;
                                    }
                                    let _e4126 = phi_6307_;
                                    if (_e4047 < 0f) {
                                        phi_6314_ = -(_e4047);
                                    } else {
                                        phi_6314_ = _e4047;
                                    }
                                    let _e4131 = phi_6314_;
                                    let _e4132 = ((_e4122 + _e4126) + _e4131);
                                    let _e4137 = local_60;
                                    let _e4138 = -(_e4137);
                                    let _e4140 = local_61;
                                    if (_e4140 > _e4138) {
                                        let _e5892 = local_77;
                                        phi_6324_ = _e5892;
                                    } else {
                                        phi_6324_ = _e4138;
                                    }
                                    let _e4143 = phi_6324_;
                                    let _e4148 = (((_e4143 - ((_e4132 * _e3921) * (0.000000059604645f * 17f))) - (_e4132 * _e3928)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e4038 > _e4148) {
                                        phi_6334_ = _e4038;
                                    } else {
                                        phi_6334_ = _e4148;
                                    }
                                    let _e4151 = phi_6334_;
                                    let _e4152 = (_e3692 - _e3677);
                                    let _e4153 = (_e3693 - _e3678);
                                    let _e4154 = (_e3694 - _e3679);
                                    let _e4157 = ((_e3700 * _e4154) - (_e3703 * _e4153));
                                    let _e4160 = ((_e3703 * _e4152) - (_e3697 * _e4154));
                                    let _e4163 = ((_e3697 * _e4153) - (_e3700 * _e4152));
                                    let _e4165 = local_2[0u];
                                    let _e4173 = (((_e4157 * _e4165[0]) + (_e4160 * _e4165[1])) + (_e4163 * _e4165[2]));
                                    phi_6367_ = type_21(0u, 4u);
                                    phi_6370_ = _e4173;
                                    phi_6372_ = _e4173;
                                    loop {
                                        let _e4175 = phi_6367_;
                                        let _e4177 = phi_6370_;
                                        let _e4179 = phi_6372_;
                                        local_62 = _e4177;
                                        local_63 = _e4179;
                                        local_78 = _e4179;
                                        if (_e4175.member < _e4175.member_1) {
                                            phi_6368_ = type_21((_e4175.member + 1u), _e4175.member_1);
                                            phi_6395_ = type_21(1u, _e4175.member);
                                        } else {
                                            phi_6368_ = _e4175;
                                            phi_6395_ = type_21(0u, type_21().member_1);
                                        }
                                        let _e4191 = phi_6368_;
                                        let _e4193 = phi_6395_;
                                        let _e4197 = (bitcast<i32>(_e4193.member) != 0i);
                                        if _e4197 {
                                            let _e4199 = local_2[_e4193.member_1];
                                            let _e4207 = (((_e4157 * _e4199[0]) + (_e4160 * _e4199[1])) + (_e4163 * _e4199[2]));
                                            let _e4209 = local_3[_e4193.member_1];
                                            let _e4217 = (((_e4157 * _e4209[0]) + (_e4160 * _e4209[1])) + (_e4163 * _e4209[2]));
                                            if (_e4179 < _e4207) {
                                                phi_6445_ = _e4179;
                                            } else {
                                                phi_6445_ = _e4207;
                                            }
                                            let _e4220 = phi_6445_;
                                            if (_e4220 < _e4217) {
                                                phi_6450_ = _e4220;
                                            } else {
                                                phi_6450_ = _e4217;
                                            }
                                            let _e4223 = phi_6450_;
                                            if (_e4177 > _e4207) {
                                                phi_6455_ = _e4177;
                                            } else {
                                                phi_6455_ = _e4207;
                                            }
                                            let _e4226 = phi_6455_;
                                            if (_e4226 > _e4217) {
                                                phi_6460_ = _e4226;
                                            } else {
                                                phi_6460_ = _e4217;
                                            }
                                            let _e4229 = phi_6460_;
                                            phi_6371_ = _e4229;
                                            phi_6373_ = _e4223;
                                        } else {
                                            phi_6371_ = f32();
                                            phi_6373_ = f32();
                                        }
                                        let _e4231 = phi_6371_;
                                        let _e4233 = phi_6373_;
                                        continue;
                                        continuing {
                                            phi_6367_ = _e4191;
                                            phi_6370_ = _e4231;
                                            phi_6372_ = _e4233;
                                            break if !(_e4197);
                                        }
                                    }
                                    if (_e4157 < 0f) {
                                        phi_6466_ = -(_e4157);
                                    } else {
                                        phi_6466_ = _e4157;
                                    }
                                    let _e4238 = phi_6466_;
                                    if (_e4160 < 0f) {
                                        phi_6472_ = -(_e4160);
                                    } else {
                                        phi_6472_ = _e4160;
                                    }
                                    let _e4242 = phi_6472_;
                                    if (_e4163 < 0f) {
                                        phi_6479_ = -(_e4163);
                                    } else {
                                        phi_6479_ = _e4163;
                                    }
                                    let _e4247 = phi_6479_;
                                    let _e4248 = ((_e4238 + _e4242) + _e4247);
                                    let _e4253 = local_62;
                                    let _e4254 = -(_e4253);
                                    let _e4256 = local_63;
                                    if (_e4256 > _e4254) {
                                        let _e5912 = local_78;
                                        phi_6489_ = _e5912;
                                    } else {
                                        phi_6489_ = _e4254;
                                    }
                                    let _e4259 = phi_6489_;
                                    let _e4264 = (((_e4259 - ((_e4248 * _e3921) * (0.000000059604645f * 17f))) - (_e4248 * _e3928)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e4151 > _e4264) {
                                        phi_6499_ = _e4151;
                                    } else {
                                        phi_6499_ = _e4264;
                                    }
                                    let _e4267 = phi_6499_;
                                    phi_6502_ = (_e4267 > 0f);
                                }
                                let _e4270 = phi_6502_;
                                if _e4270 {
                                    let _e4274 = local_4[1u].member_1[0u];
                                    let _e4280 = local_4[1u].member_2[0u];
                                    let _e4286 = ((_e4274[1] * _e4280[2]) - (_e4274[2] * _e4280[1]));
                                    let _e4289 = ((_e4274[2] * _e4280[0]) - (_e4274[0] * _e4280[2]));
                                    let _e4292 = ((_e4274[0] * _e4280[1]) - (_e4274[1] * _e4280[0]));
                                    let _e4295 = local_4[1u].member_1[1u];
                                    let _e4301 = local_4[1u].member_2[1u];
                                    let _e4307 = ((_e4295[1] * _e4301[2]) - (_e4295[2] * _e4301[1]));
                                    let _e4310 = ((_e4295[2] * _e4301[0]) - (_e4295[0] * _e4301[2]));
                                    let _e4313 = ((_e4295[0] * _e4301[1]) - (_e4295[1] * _e4301[0]));
                                    let _e4316 = local_4[1u].member_1[0u];
                                    let _e4322 = local_4[1u].member_2[1u];
                                    let _e4337 = local_4[1u].member_1[1u];
                                    let _e4343 = local_4[1u].member_2[0u];
                                    let _e4356 = (((_e4316[1] * _e4322[2]) - (_e4316[2] * _e4322[1])) + ((_e4337[1] * _e4343[2]) - (_e4337[2] * _e4343[1])));
                                    let _e4357 = (((_e4316[2] * _e4322[0]) - (_e4316[0] * _e4322[2])) + ((_e4337[2] * _e4343[0]) - (_e4337[0] * _e4343[2])));
                                    let _e4358 = (((_e4316[0] * _e4322[1]) - (_e4316[1] * _e4322[0])) + ((_e4337[0] * _e4343[1]) - (_e4337[1] * _e4343[0])));
                                    let _e4361 = local_4[1u].member[0u];
                                    let _e4372 = local_4[1u].member[1u];
                                    let _e4383 = local_4[1u].member[0u];
                                    let _e4392 = ((((_e4372[0] * _e4286) + (_e4372[1] * _e4289)) + (_e4372[2] * _e4292)) + (((_e4383[0] * _e4356) + (_e4383[1] * _e4357)) + (_e4383[2] * _e4358)));
                                    let _e4395 = local_4[1u].member[0u];
                                    let _e4406 = local_4[1u].member[1u];
                                    let _e4415 = ((((_e4395[0] * _e4307) + (_e4395[1] * _e4310)) + (_e4395[2] * _e4313)) + (((_e4406[0] * _e4356) + (_e4406[1] * _e4357)) + (_e4406[2] * _e4358)));
                                    let _e4418 = local_4[1u].member[1u];
                                    let _e4429 = local_4[1u].member[0u];
                                    if (_e4429[0] < 0f) {
                                        phi_6748_ = -(_e4429[0]);
                                    } else {
                                        phi_6748_ = _e4429[0];
                                    }
                                    let _e4436 = phi_6748_;
                                    if (_e4429[1] < 0f) {
                                        phi_6755_ = -(_e4429[1]);
                                    } else {
                                        phi_6755_ = _e4429[1];
                                    }
                                    let _e4440 = phi_6755_;
                                    if (_e4436 > _e4440) {
                                        phi_6760_ = _e4436;
                                    } else {
                                        phi_6760_ = _e4440;
                                    }
                                    let _e4443 = phi_6760_;
                                    if (_e4429[2] < 0f) {
                                        phi_6767_ = -(_e4429[2]);
                                    } else {
                                        phi_6767_ = _e4429[2];
                                    }
                                    let _e4447 = phi_6767_;
                                    if (_e4443 > _e4447) {
                                        phi_6772_ = _e4443;
                                    } else {
                                        phi_6772_ = _e4447;
                                    }
                                    let _e4450 = phi_6772_;
                                    let _e4453 = local_4[1u].member[1u];
                                    if (_e4453[0] < 0f) {
                                        phi_6785_ = -(_e4453[0]);
                                    } else {
                                        phi_6785_ = _e4453[0];
                                    }
                                    let _e4460 = phi_6785_;
                                    if (_e4453[1] < 0f) {
                                        phi_6792_ = -(_e4453[1]);
                                    } else {
                                        phi_6792_ = _e4453[1];
                                    }
                                    let _e4464 = phi_6792_;
                                    if (_e4460 > _e4464) {
                                        phi_6797_ = _e4460;
                                    } else {
                                        phi_6797_ = _e4464;
                                    }
                                    let _e4467 = phi_6797_;
                                    if (_e4453[2] < 0f) {
                                        phi_6804_ = -(_e4453[2]);
                                    } else {
                                        phi_6804_ = _e4453[2];
                                    }
                                    let _e4471 = phi_6804_;
                                    if (_e4467 > _e4471) {
                                        phi_6809_ = _e4467;
                                    } else {
                                        phi_6809_ = _e4471;
                                    }
                                    let _e4474 = phi_6809_;
                                    if (_e4450 > _e4474) {
                                        phi_6814_ = _e4450;
                                    } else {
                                        phi_6814_ = _e4474;
                                    }
                                    let _e4477 = phi_6814_;
                                    let _e4479 = local_4[1u].member_3;
                                    let _e4480 = (_e4477 + _e4479);
                                    let _e4483 = local_4[1u].member_1[0u];
                                    if (_e4483[0] < 0f) {
                                        phi_6831_ = -(_e4483[0]);
                                    } else {
                                        phi_6831_ = _e4483[0];
                                    }
                                    let _e4490 = phi_6831_;
                                    if (_e4483[1] < 0f) {
                                        phi_6838_ = -(_e4483[1]);
                                    } else {
                                        phi_6838_ = _e4483[1];
                                    }
                                    let _e4494 = phi_6838_;
                                    if (_e4490 > _e4494) {
                                        phi_6843_ = _e4490;
                                    } else {
                                        phi_6843_ = _e4494;
                                    }
                                    let _e4497 = phi_6843_;
                                    if (_e4483[2] < 0f) {
                                        phi_6850_ = -(_e4483[2]);
                                    } else {
                                        phi_6850_ = _e4483[2];
                                    }
                                    let _e4501 = phi_6850_;
                                    if (_e4497 > _e4501) {
                                        phi_6855_ = _e4497;
                                    } else {
                                        phi_6855_ = _e4501;
                                    }
                                    let _e4504 = phi_6855_;
                                    let _e4507 = local_4[1u].member_1[1u];
                                    if (_e4507[0] < 0f) {
                                        phi_6869_ = -(_e4507[0]);
                                    } else {
                                        phi_6869_ = _e4507[0];
                                    }
                                    let _e4514 = phi_6869_;
                                    if (_e4507[1] < 0f) {
                                        phi_6876_ = -(_e4507[1]);
                                    } else {
                                        phi_6876_ = _e4507[1];
                                    }
                                    let _e4518 = phi_6876_;
                                    if (_e4514 > _e4518) {
                                        phi_6881_ = _e4514;
                                    } else {
                                        phi_6881_ = _e4518;
                                    }
                                    let _e4521 = phi_6881_;
                                    if (_e4507[2] < 0f) {
                                        phi_6888_ = -(_e4507[2]);
                                    } else {
                                        phi_6888_ = _e4507[2];
                                    }
                                    let _e4525 = phi_6888_;
                                    if (_e4521 > _e4525) {
                                        phi_6893_ = _e4521;
                                    } else {
                                        phi_6893_ = _e4525;
                                    }
                                    let _e4528 = phi_6893_;
                                    if (_e4504 > _e4528) {
                                        phi_6898_ = _e4504;
                                    } else {
                                        phi_6898_ = _e4528;
                                    }
                                    let _e4531 = phi_6898_;
                                    let _e4533 = local_4[1u].member_3;
                                    let _e4534 = (_e4531 + _e4533);
                                    let _e4537 = local_4[1u].member_2[0u];
                                    if (_e4537[0] < 0f) {
                                        phi_6915_ = -(_e4537[0]);
                                    } else {
                                        phi_6915_ = _e4537[0];
                                    }
                                    let _e4544 = phi_6915_;
                                    if (_e4537[1] < 0f) {
                                        phi_6922_ = -(_e4537[1]);
                                    } else {
                                        phi_6922_ = _e4537[1];
                                    }
                                    let _e4548 = phi_6922_;
                                    if (_e4544 > _e4548) {
                                        phi_6927_ = _e4544;
                                    } else {
                                        phi_6927_ = _e4548;
                                    }
                                    let _e4551 = phi_6927_;
                                    if (_e4537[2] < 0f) {
                                        phi_6934_ = -(_e4537[2]);
                                    } else {
                                        phi_6934_ = _e4537[2];
                                    }
                                    let _e4555 = phi_6934_;
                                    if (_e4551 > _e4555) {
                                        phi_6939_ = _e4551;
                                    } else {
                                        phi_6939_ = _e4555;
                                    }
                                    let _e4558 = phi_6939_;
                                    let _e4561 = local_4[1u].member_2[1u];
                                    if (_e4561[0] < 0f) {
                                        phi_6953_ = -(_e4561[0]);
                                    } else {
                                        phi_6953_ = _e4561[0];
                                    }
                                    let _e4568 = phi_6953_;
                                    if (_e4561[1] < 0f) {
                                        phi_6960_ = -(_e4561[1]);
                                    } else {
                                        phi_6960_ = _e4561[1];
                                    }
                                    let _e4572 = phi_6960_;
                                    if (_e4568 > _e4572) {
                                        phi_6965_ = _e4568;
                                    } else {
                                        phi_6965_ = _e4572;
                                    }
                                    let _e4575 = phi_6965_;
                                    if (_e4561[2] < 0f) {
                                        phi_6972_ = -(_e4561[2]);
                                    } else {
                                        phi_6972_ = _e4561[2];
                                    }
                                    let _e4579 = phi_6972_;
                                    if (_e4575 > _e4579) {
                                        phi_6977_ = _e4575;
                                    } else {
                                        phi_6977_ = _e4579;
                                    }
                                    let _e4582 = phi_6977_;
                                    if (_e4558 > _e4582) {
                                        phi_6982_ = _e4558;
                                    } else {
                                        phi_6982_ = _e4582;
                                    }
                                    let _e4585 = phi_6982_;
                                    let _e4587 = local_4[1u].member_3;
                                    let _e4588 = (_e4585 + _e4587);
                                    let _e4590 = ((_e4534 * 8f) * _e4588);
                                    let _e4597 = local_4[1u].member_3;
                                    if (_e4286 < 0f) {
                                        phi_7013_ = -(_e4286);
                                    } else {
                                        phi_7013_ = _e4286;
                                    }
                                    let _e4614 = phi_7013_;
                                    if (_e4289 < 0f) {
                                        phi_7019_ = -(_e4289);
                                    } else {
                                        phi_7019_ = _e4289;
                                    }
                                    let _e4618 = phi_7019_;
                                    if (_e4292 < 0f) {
                                        phi_7026_ = -(_e4292);
                                    } else {
                                        phi_7026_ = _e4292;
                                    }
                                    let _e4623 = phi_7026_;
                                    let _e4624 = ((_e4614 + _e4618) + _e4623);
                                    if (_e4307 < 0f) {
                                        phi_7033_ = -(_e4307);
                                    } else {
                                        phi_7033_ = _e4307;
                                    }
                                    let _e4628 = phi_7033_;
                                    if (_e4310 < 0f) {
                                        phi_7039_ = -(_e4310);
                                    } else {
                                        phi_7039_ = _e4310;
                                    }
                                    let _e4632 = phi_7039_;
                                    if (_e4313 < 0f) {
                                        phi_7046_ = -(_e4313);
                                    } else {
                                        phi_7046_ = _e4313;
                                    }
                                    let _e4637 = phi_7046_;
                                    let _e4638 = ((_e4628 + _e4632) + _e4637);
                                    if (_e4624 > _e4638) {
                                        phi_7052_ = _e4624;
                                    } else {
                                        phi_7052_ = _e4638;
                                    }
                                    let _e4641 = phi_7052_;
                                    if (_e4356 < 0f) {
                                        phi_7058_ = -(_e4356);
                                    } else {
                                        phi_7058_ = _e4356;
                                    }
                                    let _e4645 = phi_7058_;
                                    if (_e4357 < 0f) {
                                        phi_7064_ = -(_e4357);
                                    } else {
                                        phi_7064_ = _e4357;
                                    }
                                    let _e4649 = phi_7064_;
                                    if (_e4358 < 0f) {
                                        phi_7071_ = -(_e4358);
                                    } else {
                                        phi_7071_ = _e4358;
                                    }
                                    let _e4654 = phi_7071_;
                                    let _e4656 = (((_e4645 + _e4649) + _e4654) * 0.5f);
                                    if (_e4641 > _e4656) {
                                        phi_7078_ = _e4641;
                                    } else {
                                        phi_7078_ = _e4656;
                                    }
                                    let _e4659 = phi_7078_;
                                    let _e4664 = local_4[1u].member_3;
                                    let _e4677 = ((((_e4361[0] * _e4286) + (_e4361[1] * _e4289)) + (_e4361[2] * _e4292)) * 3f);
                                    let _e4678 = ((((_e4418[0] * _e4307) + (_e4418[1] * _e4310)) + (_e4418[2] * _e4313)) * 3f);
                                    if (_e4677 < _e4678) {
                                        phi_7102_ = _e4677;
                                    } else {
                                        phi_7102_ = _e4678;
                                    }
                                    let _e4681 = phi_7102_;
                                    if (_e4392 < _e4415) {
                                        phi_7107_ = _e4392;
                                    } else {
                                        phi_7107_ = _e4415;
                                    }
                                    let _e4684 = phi_7107_;
                                    if (_e4681 < _e4684) {
                                        phi_7112_ = _e4681;
                                    } else {
                                        phi_7112_ = _e4684;
                                    }
                                    let _e4687 = phi_7112_;
                                    if (_e4677 > _e4678) {
                                        phi_7117_ = _e4677;
                                    } else {
                                        phi_7117_ = _e4678;
                                    }
                                    let _e4690 = phi_7117_;
                                    if (_e4392 > _e4415) {
                                        phi_7122_ = _e4392;
                                    } else {
                                        phi_7122_ = _e4415;
                                    }
                                    let _e4693 = phi_7122_;
                                    if (_e4690 > _e4693) {
                                        phi_7127_ = _e4690;
                                    } else {
                                        phi_7127_ = _e4693;
                                    }
                                    let _e4696 = phi_7127_;
                                    let _e4701 = -(_e4696);
                                    if (_e4687 > _e4701) {
                                        phi_7137_ = _e4687;
                                    } else {
                                        phi_7137_ = _e4701;
                                    }
                                    let _e4704 = phi_7137_;
                                    if ((_e4704 - ((((((_e4480 * 8f) * _e4590) * (0.000000059604645f * (490f / 64f))) + ((_e4597 * 19f) * ((_e4480 * (_e4534 + _e4588)) + (_e4534 * _e4588)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4480) * ((1f + _e4534) * (1f + _e4588))))) + ((_e2015 * (((_e4659 + (_e4590 * (0.000000059604645f * 4f))) + ((_e4664 * 6f) * (_e4534 + _e4588))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4534) * (1f + _e4588))))) * (3f * 1.0001f)))) > 0f) {
                                        phi_8113_ = true;
                                    } else {
                                        let _e4709 = local_4[1u].member_1[0u];
                                        let _e4715 = local_4[1u].member_1[1u];
                                        let _e4719 = (_e4709[0] + _e4715[0]);
                                        let _e4720 = (_e4709[1] + _e4715[1]);
                                        let _e4721 = (_e4709[2] + _e4715[2]);
                                        let _e4724 = local_4[1u].member_2[0u];
                                        let _e4730 = local_4[1u].member_2[1u];
                                        let _e4734 = (_e4724[0] + _e4730[0]);
                                        let _e4735 = (_e4724[1] + _e4730[1]);
                                        let _e4736 = (_e4724[2] + _e4730[2]);
                                        let _e4739 = ((_e4720 * _e4736) - (_e4721 * _e4735));
                                        let _e4742 = ((_e4721 * _e4734) - (_e4719 * _e4736));
                                        let _e4745 = ((_e4719 * _e4735) - (_e4720 * _e4734));
                                        let _e4748 = local_4[1u].member[0u];
                                        let _e4754 = local_4[1u].member_1[0u];
                                        let _e4760 = local_4[1u].member_2[0u];
                                        let _e4772 = local_4[1u].member[1u];
                                        let _e4778 = local_4[1u].member_1[1u];
                                        let _e4784 = local_4[1u].member_2[1u];
                                        local = array<array<f32, 3>, 4>(_e4748, array<f32, 3>((_e4748[0] - _e4754[0]), (_e4748[1] - _e4754[1]), (_e4748[2] - _e4754[2])), array<f32, 3>((_e4748[0] - _e4760[0]), (_e4748[1] - _e4760[1]), (_e4748[2] - _e4760[2])), _e4748);
                                        local_1 = array<array<f32, 3>, 4>(_e4772, array<f32, 3>((_e4772[0] - _e4778[0]), (_e4772[1] - _e4778[1]), (_e4772[2] - _e4778[2])), array<f32, 3>((_e4772[0] - _e4784[0]), (_e4772[1] - _e4784[1]), (_e4772[2] - _e4784[2])), _e4772);
                                        let _e4802 = local_4[1u].member[0u];
                                        if (_e4802[0] < 0f) {
                                            phi_7388_ = -(_e4802[0]);
                                        } else {
                                            phi_7388_ = _e4802[0];
                                        }
                                        let _e4809 = phi_7388_;
                                        if (_e4802[1] < 0f) {
                                            phi_7395_ = -(_e4802[1]);
                                        } else {
                                            phi_7395_ = _e4802[1];
                                        }
                                        let _e4813 = phi_7395_;
                                        if (_e4809 > _e4813) {
                                            phi_7400_ = _e4809;
                                        } else {
                                            phi_7400_ = _e4813;
                                        }
                                        let _e4816 = phi_7400_;
                                        if (_e4802[2] < 0f) {
                                            phi_7407_ = -(_e4802[2]);
                                        } else {
                                            phi_7407_ = _e4802[2];
                                        }
                                        let _e4820 = phi_7407_;
                                        if (_e4816 > _e4820) {
                                            phi_7412_ = _e4816;
                                        } else {
                                            phi_7412_ = _e4820;
                                        }
                                        let _e4823 = phi_7412_;
                                        let _e4826 = local_4[1u].member[1u];
                                        if (_e4826[0] < 0f) {
                                            phi_7425_ = -(_e4826[0]);
                                        } else {
                                            phi_7425_ = _e4826[0];
                                        }
                                        let _e4833 = phi_7425_;
                                        if (_e4826[1] < 0f) {
                                            phi_7432_ = -(_e4826[1]);
                                        } else {
                                            phi_7432_ = _e4826[1];
                                        }
                                        let _e4837 = phi_7432_;
                                        if (_e4833 > _e4837) {
                                            phi_7437_ = _e4833;
                                        } else {
                                            phi_7437_ = _e4837;
                                        }
                                        let _e4840 = phi_7437_;
                                        if (_e4826[2] < 0f) {
                                            phi_7444_ = -(_e4826[2]);
                                        } else {
                                            phi_7444_ = _e4826[2];
                                        }
                                        let _e4844 = phi_7444_;
                                        if (_e4840 > _e4844) {
                                            phi_7449_ = _e4840;
                                        } else {
                                            phi_7449_ = _e4844;
                                        }
                                        let _e4847 = phi_7449_;
                                        if (_e4823 > _e4847) {
                                            phi_7454_ = _e4823;
                                        } else {
                                            phi_7454_ = _e4847;
                                        }
                                        let _e4850 = phi_7454_;
                                        let _e4852 = local_4[1u].member_3;
                                        let _e4856 = local_4[1u].member_1[0u];
                                        if (_e4856[0] < 0f) {
                                            phi_7471_ = -(_e4856[0]);
                                        } else {
                                            phi_7471_ = _e4856[0];
                                        }
                                        let _e4863 = phi_7471_;
                                        if (_e4856[1] < 0f) {
                                            phi_7478_ = -(_e4856[1]);
                                        } else {
                                            phi_7478_ = _e4856[1];
                                        }
                                        let _e4867 = phi_7478_;
                                        if (_e4863 > _e4867) {
                                            phi_7483_ = _e4863;
                                        } else {
                                            phi_7483_ = _e4867;
                                        }
                                        let _e4870 = phi_7483_;
                                        if (_e4856[2] < 0f) {
                                            phi_7490_ = -(_e4856[2]);
                                        } else {
                                            phi_7490_ = _e4856[2];
                                        }
                                        let _e4874 = phi_7490_;
                                        if (_e4870 > _e4874) {
                                            phi_7495_ = _e4870;
                                        } else {
                                            phi_7495_ = _e4874;
                                        }
                                        let _e4877 = phi_7495_;
                                        let _e4880 = local_4[1u].member_1[1u];
                                        if (_e4880[0] < 0f) {
                                            phi_7509_ = -(_e4880[0]);
                                        } else {
                                            phi_7509_ = _e4880[0];
                                        }
                                        let _e4887 = phi_7509_;
                                        if (_e4880[1] < 0f) {
                                            phi_7516_ = -(_e4880[1]);
                                        } else {
                                            phi_7516_ = _e4880[1];
                                        }
                                        let _e4891 = phi_7516_;
                                        if (_e4887 > _e4891) {
                                            phi_7521_ = _e4887;
                                        } else {
                                            phi_7521_ = _e4891;
                                        }
                                        let _e4894 = phi_7521_;
                                        if (_e4880[2] < 0f) {
                                            phi_7528_ = -(_e4880[2]);
                                        } else {
                                            phi_7528_ = _e4880[2];
                                        }
                                        let _e4898 = phi_7528_;
                                        if (_e4894 > _e4898) {
                                            phi_7533_ = _e4894;
                                        } else {
                                            phi_7533_ = _e4898;
                                        }
                                        let _e4901 = phi_7533_;
                                        if (_e4877 > _e4901) {
                                            phi_7538_ = _e4877;
                                        } else {
                                            phi_7538_ = _e4901;
                                        }
                                        let _e4904 = phi_7538_;
                                        let _e4906 = local_4[1u].member_3;
                                        let _e4910 = local_4[1u].member_2[0u];
                                        if (_e4910[0] < 0f) {
                                            phi_7555_ = -(_e4910[0]);
                                        } else {
                                            phi_7555_ = _e4910[0];
                                        }
                                        let _e4917 = phi_7555_;
                                        if (_e4910[1] < 0f) {
                                            phi_7562_ = -(_e4910[1]);
                                        } else {
                                            phi_7562_ = _e4910[1];
                                        }
                                        let _e4921 = phi_7562_;
                                        if (_e4917 > _e4921) {
                                            phi_7567_ = _e4917;
                                        } else {
                                            phi_7567_ = _e4921;
                                        }
                                        let _e4924 = phi_7567_;
                                        if (_e4910[2] < 0f) {
                                            phi_7574_ = -(_e4910[2]);
                                        } else {
                                            phi_7574_ = _e4910[2];
                                        }
                                        let _e4928 = phi_7574_;
                                        if (_e4924 > _e4928) {
                                            phi_7579_ = _e4924;
                                        } else {
                                            phi_7579_ = _e4928;
                                        }
                                        let _e4931 = phi_7579_;
                                        let _e4934 = local_4[1u].member_2[1u];
                                        if (_e4934[0] < 0f) {
                                            phi_7593_ = -(_e4934[0]);
                                        } else {
                                            phi_7593_ = _e4934[0];
                                        }
                                        let _e4941 = phi_7593_;
                                        if (_e4934[1] < 0f) {
                                            phi_7600_ = -(_e4934[1]);
                                        } else {
                                            phi_7600_ = _e4934[1];
                                        }
                                        let _e4945 = phi_7600_;
                                        if (_e4941 > _e4945) {
                                            phi_7605_ = _e4941;
                                        } else {
                                            phi_7605_ = _e4945;
                                        }
                                        let _e4948 = phi_7605_;
                                        if (_e4934[2] < 0f) {
                                            phi_7612_ = -(_e4934[2]);
                                        } else {
                                            phi_7612_ = _e4934[2];
                                        }
                                        let _e4952 = phi_7612_;
                                        if (_e4948 > _e4952) {
                                            phi_7617_ = _e4948;
                                        } else {
                                            phi_7617_ = _e4952;
                                        }
                                        let _e4955 = phi_7617_;
                                        if (_e4931 > _e4955) {
                                            phi_7622_ = _e4931;
                                        } else {
                                            phi_7622_ = _e4955;
                                        }
                                        let _e4958 = phi_7622_;
                                        let _e4960 = local_4[1u].member_3;
                                        let _e4963 = (((_e4850 + _e4852) + (_e4904 + _e4906)) + (_e4958 + _e4960));
                                        let _e4966 = local_4[1u].member_3;
                                        let _e4970 = (((_e2015 * 1.0001f) + (_e4966 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4973 = ((_e4742 * _e4721) - (_e4745 * _e4720));
                                        let _e4976 = ((_e4745 * _e4719) - (_e4739 * _e4721));
                                        let _e4979 = ((_e4739 * _e4720) - (_e4742 * _e4719));
                                        let _e4981 = local[0u];
                                        let _e4989 = (((_e4973 * _e4981[0]) + (_e4976 * _e4981[1])) + (_e4979 * _e4981[2]));
                                        phi_7660_ = type_21(0u, 4u);
                                        phi_7663_ = _e4989;
                                        phi_7665_ = _e4989;
                                        loop {
                                            let _e4991 = phi_7660_;
                                            let _e4993 = phi_7663_;
                                            let _e4995 = phi_7665_;
                                            local_64 = _e4993;
                                            local_65 = _e4995;
                                            local_79 = _e4995;
                                            if (_e4991.member < _e4991.member_1) {
                                                phi_7661_ = type_21((_e4991.member + 1u), _e4991.member_1);
                                                phi_7688_ = type_21(1u, _e4991.member);
                                            } else {
                                                phi_7661_ = _e4991;
                                                phi_7688_ = type_21(0u, type_21().member_1);
                                            }
                                            let _e5007 = phi_7661_;
                                            let _e5009 = phi_7688_;
                                            let _e5013 = (bitcast<i32>(_e5009.member) != 0i);
                                            if _e5013 {
                                                let _e5015 = local[_e5009.member_1];
                                                let _e5023 = (((_e4973 * _e5015[0]) + (_e4976 * _e5015[1])) + (_e4979 * _e5015[2]));
                                                let _e5025 = local_1[_e5009.member_1];
                                                let _e5033 = (((_e4973 * _e5025[0]) + (_e4976 * _e5025[1])) + (_e4979 * _e5025[2]));
                                                if (_e4995 < _e5023) {
                                                    phi_7738_ = _e4995;
                                                } else {
                                                    phi_7738_ = _e5023;
                                                }
                                                let _e5036 = phi_7738_;
                                                if (_e5036 < _e5033) {
                                                    phi_7743_ = _e5036;
                                                } else {
                                                    phi_7743_ = _e5033;
                                                }
                                                let _e5039 = phi_7743_;
                                                if (_e4993 > _e5023) {
                                                    phi_7748_ = _e4993;
                                                } else {
                                                    phi_7748_ = _e5023;
                                                }
                                                let _e5042 = phi_7748_;
                                                if (_e5042 > _e5033) {
                                                    phi_7753_ = _e5042;
                                                } else {
                                                    phi_7753_ = _e5033;
                                                }
                                                let _e5045 = phi_7753_;
                                                phi_7664_ = _e5045;
                                                phi_7666_ = _e5039;
                                            } else {
                                                phi_7664_ = f32();
                                                phi_7666_ = f32();
                                            }
                                            let _e5047 = phi_7664_;
                                            let _e5049 = phi_7666_;
                                            continue;
                                            continuing {
                                                phi_7660_ = _e5007;
                                                phi_7663_ = _e5047;
                                                phi_7665_ = _e5049;
                                                break if !(_e5013);
                                            }
                                        }
                                        if (_e4973 < 0f) {
                                            phi_7759_ = -(_e4973);
                                        } else {
                                            phi_7759_ = _e4973;
                                        }
                                        let _e5054 = phi_7759_;
                                        if (_e4976 < 0f) {
                                            phi_7765_ = -(_e4976);
                                        } else {
                                            phi_7765_ = _e4976;
                                        }
                                        let _e5058 = phi_7765_;
                                        if (_e4979 < 0f) {
                                            phi_7772_ = -(_e4979);
                                        } else {
                                            phi_7772_ = _e4979;
                                        }
                                        let _e5063 = phi_7772_;
                                        let _e5064 = ((_e5054 + _e5058) + _e5063);
                                        let _e5069 = local_64;
                                        let _e5070 = -(_e5069);
                                        let _e5072 = local_65;
                                        if (_e5072 > _e5070) {
                                            let _e6017 = local_79;
                                            phi_7782_ = _e6017;
                                        } else {
                                            phi_7782_ = _e5070;
                                        }
                                        let _e5075 = phi_7782_;
                                        let _e5080 = (((_e5075 - ((_e5064 * _e4963) * (0.000000059604645f * 17f))) - (_e5064 * _e4970)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e5083 = ((_e4742 * _e4736) - (_e4745 * _e4735));
                                        let _e5086 = ((_e4745 * _e4734) - (_e4739 * _e4736));
                                        let _e5089 = ((_e4739 * _e4735) - (_e4742 * _e4734));
                                        let _e5091 = local[0u];
                                        let _e5099 = (((_e5083 * _e5091[0]) + (_e5086 * _e5091[1])) + (_e5089 * _e5091[2]));
                                        phi_7813_ = type_21(0u, 4u);
                                        phi_7816_ = _e5099;
                                        phi_7818_ = _e5099;
                                        loop {
                                            let _e5101 = phi_7813_;
                                            let _e5103 = phi_7816_;
                                            let _e5105 = phi_7818_;
                                            local_66 = _e5103;
                                            local_67 = _e5105;
                                            local_80 = _e5105;
                                            if (_e5101.member < _e5101.member_1) {
                                                phi_7814_ = type_21((_e5101.member + 1u), _e5101.member_1);
                                                phi_7841_ = type_21(1u, _e5101.member);
                                            } else {
                                                phi_7814_ = _e5101;
                                                phi_7841_ = type_21(0u, type_21().member_1);
                                            }
                                            let _e5117 = phi_7814_;
                                            let _e5119 = phi_7841_;
                                            let _e5123 = (bitcast<i32>(_e5119.member) != 0i);
                                            if _e5123 {
                                                let _e5125 = local[_e5119.member_1];
                                                let _e5133 = (((_e5083 * _e5125[0]) + (_e5086 * _e5125[1])) + (_e5089 * _e5125[2]));
                                                let _e5135 = local_1[_e5119.member_1];
                                                let _e5143 = (((_e5083 * _e5135[0]) + (_e5086 * _e5135[1])) + (_e5089 * _e5135[2]));
                                                if (_e5105 < _e5133) {
                                                    phi_7891_ = _e5105;
                                                } else {
                                                    phi_7891_ = _e5133;
                                                }
                                                let _e5146 = phi_7891_;
                                                if (_e5146 < _e5143) {
                                                    phi_7896_ = _e5146;
                                                } else {
                                                    phi_7896_ = _e5143;
                                                }
                                                let _e5149 = phi_7896_;
                                                if (_e5103 > _e5133) {
                                                    phi_7901_ = _e5103;
                                                } else {
                                                    phi_7901_ = _e5133;
                                                }
                                                let _e5152 = phi_7901_;
                                                if (_e5152 > _e5143) {
                                                    phi_7906_ = _e5152;
                                                } else {
                                                    phi_7906_ = _e5143;
                                                }
                                                let _e5155 = phi_7906_;
                                                phi_7817_ = _e5155;
                                                phi_7819_ = _e5149;
                                            } else {
                                                phi_7817_ = f32();
                                                phi_7819_ = f32();
                                            }
                                            let _e5157 = phi_7817_;
                                            let _e5159 = phi_7819_;
                                            continue;
                                            continuing {
                                                phi_7813_ = _e5117;
                                                phi_7816_ = _e5157;
                                                phi_7818_ = _e5159;
                                                break if !(_e5123);
                                            }
                                        }
                                        if (_e5083 < 0f) {
                                            phi_7912_ = -(_e5083);
                                        } else {
                                            phi_7912_ = _e5083;
                                        }
                                        let _e5164 = phi_7912_;
                                        if (_e5086 < 0f) {
                                            phi_7918_ = -(_e5086);
                                        } else {
                                            phi_7918_ = _e5086;
                                        }
                                        let _e5168 = phi_7918_;
                                        if (_e5089 < 0f) {
                                            phi_7925_ = -(_e5089);
                                        } else {
                                            phi_7925_ = _e5089;
                                        }
                                        let _e5173 = phi_7925_;
                                        let _e5174 = ((_e5164 + _e5168) + _e5173);
                                        let _e5179 = local_66;
                                        let _e5180 = -(_e5179);
                                        let _e5182 = local_67;
                                        if (_e5182 > _e5180) {
                                            let _e6036 = local_80;
                                            phi_7935_ = _e6036;
                                        } else {
                                            phi_7935_ = _e5180;
                                        }
                                        let _e5185 = phi_7935_;
                                        let _e5190 = (((_e5185 - ((_e5174 * _e4963) * (0.000000059604645f * 17f))) - (_e5174 * _e4970)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e5080 > _e5190) {
                                            phi_7945_ = _e5080;
                                        } else {
                                            phi_7945_ = _e5190;
                                        }
                                        let _e5193 = phi_7945_;
                                        let _e5194 = (_e4734 - _e4719);
                                        let _e5195 = (_e4735 - _e4720);
                                        let _e5196 = (_e4736 - _e4721);
                                        let _e5199 = ((_e4742 * _e5196) - (_e4745 * _e5195));
                                        let _e5202 = ((_e4745 * _e5194) - (_e4739 * _e5196));
                                        let _e5205 = ((_e4739 * _e5195) - (_e4742 * _e5194));
                                        let _e5207 = local[0u];
                                        let _e5215 = (((_e5199 * _e5207[0]) + (_e5202 * _e5207[1])) + (_e5205 * _e5207[2]));
                                        phi_7978_ = type_21(0u, 4u);
                                        phi_7981_ = _e5215;
                                        phi_7983_ = _e5215;
                                        loop {
                                            let _e5217 = phi_7978_;
                                            let _e5219 = phi_7981_;
                                            let _e5221 = phi_7983_;
                                            local_68 = _e5219;
                                            local_69 = _e5221;
                                            local_81 = _e5221;
                                            if (_e5217.member < _e5217.member_1) {
                                                phi_7979_ = type_21((_e5217.member + 1u), _e5217.member_1);
                                                phi_8006_ = type_21(1u, _e5217.member);
                                            } else {
                                                phi_7979_ = _e5217;
                                                phi_8006_ = type_21(0u, type_21().member_1);
                                            }
                                            let _e5233 = phi_7979_;
                                            let _e5235 = phi_8006_;
                                            let _e5239 = (bitcast<i32>(_e5235.member) != 0i);
                                            if _e5239 {
                                                let _e5241 = local[_e5235.member_1];
                                                let _e5249 = (((_e5199 * _e5241[0]) + (_e5202 * _e5241[1])) + (_e5205 * _e5241[2]));
                                                let _e5251 = local_1[_e5235.member_1];
                                                let _e5259 = (((_e5199 * _e5251[0]) + (_e5202 * _e5251[1])) + (_e5205 * _e5251[2]));
                                                if (_e5221 < _e5249) {
                                                    phi_8056_ = _e5221;
                                                } else {
                                                    phi_8056_ = _e5249;
                                                }
                                                let _e5262 = phi_8056_;
                                                if (_e5262 < _e5259) {
                                                    phi_8061_ = _e5262;
                                                } else {
                                                    phi_8061_ = _e5259;
                                                }
                                                let _e5265 = phi_8061_;
                                                if (_e5219 > _e5249) {
                                                    phi_8066_ = _e5219;
                                                } else {
                                                    phi_8066_ = _e5249;
                                                }
                                                let _e5268 = phi_8066_;
                                                if (_e5268 > _e5259) {
                                                    phi_8071_ = _e5268;
                                                } else {
                                                    phi_8071_ = _e5259;
                                                }
                                                let _e5271 = phi_8071_;
                                                phi_7982_ = _e5271;
                                                phi_7984_ = _e5265;
                                            } else {
                                                phi_7982_ = f32();
                                                phi_7984_ = f32();
                                            }
                                            let _e5273 = phi_7982_;
                                            let _e5275 = phi_7984_;
                                            continue;
                                            continuing {
                                                phi_7978_ = _e5233;
                                                phi_7981_ = _e5273;
                                                phi_7983_ = _e5275;
                                                break if !(_e5239);
                                            }
                                        }
                                        if (_e5199 < 0f) {
                                            phi_8077_ = -(_e5199);
                                        } else {
                                            phi_8077_ = _e5199;
                                        }
                                        let _e5280 = phi_8077_;
                                        if (_e5202 < 0f) {
                                            phi_8083_ = -(_e5202);
                                        } else {
                                            phi_8083_ = _e5202;
                                        }
                                        let _e5284 = phi_8083_;
                                        if (_e5205 < 0f) {
                                            phi_8090_ = -(_e5205);
                                        } else {
                                            phi_8090_ = _e5205;
                                        }
                                        let _e5289 = phi_8090_;
                                        let _e5290 = ((_e5280 + _e5284) + _e5289);
                                        let _e5295 = local_68;
                                        let _e5296 = -(_e5295);
                                        let _e5298 = local_69;
                                        if (_e5298 > _e5296) {
                                            let _e6056 = local_81;
                                            phi_8100_ = _e6056;
                                        } else {
                                            phi_8100_ = _e5296;
                                        }
                                        let _e5301 = phi_8100_;
                                        let _e5306 = (((_e5301 - ((_e5290 * _e4963) * (0.000000059604645f * 17f))) - (_e5290 * _e4970)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e5193 > _e5306) {
                                            phi_8110_ = _e5193;
                                        } else {
                                            phi_8110_ = _e5306;
                                        }
                                        let _e5309 = phi_8110_;
                                        phi_8113_ = (_e5309 > 0f);
                                    }
                                    let _e5312 = phi_8113_;
                                    phi_8114_ = _e5312;
                                } else {
                                    phi_8114_ = false;
                                }
                                let _e5314 = phi_8114_;
                                phi_8116_ = !(_e5314);
                            }
                            let _e5317 = phi_8116_;
                            if _e5317 {
                                let _e5319 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1281] = ((2147483648u | (_e5319 << bitcast<u32>(12i))) | _e1284);
                            }
                        }
                        phi_8126_ = true;
                    }
                    let _e5326 = phi_8126_;
                    phi_8127_ = _e5326;
                } else {
                    phi_8127_ = false;
                }
                let _e5328 = phi_8127_;
                continue;
                continuing {
                    phi_1900_ = _e1273;
                    break if !(_e5328);
                }
            }
            workgroupBarrier();
            if (_e97 == 0u) {
                let _e5332 = atomicLoad((&counters[5u]));
                if (_e5332 > 0u) {
                    let _e5335 = atomicAdd((&output.member[0u]), _e5332);
                    if ((_e5335 + _e5332) < _e5335) {
                        let _e5339 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e5335);
                }
            }
            workgroupBarrier();
            let _e5342 = atomicLoad((&counters[6u]));
            if (_e97 == 0u) {
                let _e5345 = atomicLoad((&counters[7u]));
                if (_e5345 > 0u) {
                    let _e5348 = atomicAdd((&output.member[1u]), _e5345);
                    if ((_e5348 + _e5345) < _e5348) {
                        let _e5352 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_8177_ = type_21(0u, 16u);
            loop {
                let _e5354 = phi_8177_;
                if (_e5354.member < _e5354.member_1) {
                    phi_8178_ = type_21((_e5354.member + 1u), _e5354.member_1);
                    phi_8201_ = type_21(1u, _e5354.member);
                } else {
                    phi_8178_ = _e5354;
                    phi_8201_ = type_21(0u, type_21().member_1);
                }
                let _e5366 = phi_8178_;
                let _e5368 = phi_8201_;
                if (bitcast<i32>(_e5368.member) != 0i) {
                    let _e5374 = (_e97 + (_e5368.member_1 * 128u));
                    if (_e5374 >= _e1259) {
                        phi_8299_ = false;
                    } else {
                        let _e5377 = hits[_e5374];
                        if ((_e5377 & 2147483648u) == 0u) {
                            phi_8224_ = 4294967295u;
                        } else {
                            phi_8224_ = ((_e5377 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e5384 = phi_8224_;
                        if (_e5384 != 4294967295u) {
                            let _e5388 = ((_e5377 >> bitcast<u32>(10i)) & 3u);
                            let _e5395 = firsts[(2u * _e5388)];
                            let _e5398 = leaves.member[(_e5395 + ((_e5377 >> bitcast<u32>(5i)) & 31u))];
                            let _e5402 = firsts[((2u * _e5388) + 1u)];
                            let _e5405 = leaves.member[(_e5402 + (_e5377 & 31u))];
                            let _e5409 = params.member.member_16;
                            let _e5410 = (_e5342 + _e5384);
                            if (_e5410 < _e5409) {
                                atomicStore((&output.member[(4u + (2u * _e5410))]), _e5398.member_1);
                                atomicStore((&output.member[((2u * _e5410) + 5u)]), _e5405.member_1);
                            }
                        }
                        phi_8299_ = true;
                    }
                    let _e5419 = phi_8299_;
                    phi_8300_ = _e5419;
                } else {
                    phi_8300_ = false;
                }
                let _e5421 = phi_8300_;
                continue;
                continuing {
                    phi_8177_ = _e5366;
                    break if !(_e5421);
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
fn filter_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
