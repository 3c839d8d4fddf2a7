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
    var phi_807_: u32;
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
    var phi_4227_: type_36;
    var phi_4230_: f32;
    var phi_4232_: f32;
    var phi_4228_: type_36;
    var phi_4255_: type_36;
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
    var phi_4380_: type_36;
    var phi_4383_: f32;
    var phi_4385_: f32;
    var phi_4381_: type_36;
    var phi_4408_: type_36;
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
    var phi_4545_: type_36;
    var phi_4548_: f32;
    var phi_4550_: f32;
    var phi_4546_: type_36;
    var phi_4573_: type_36;
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
    var phi_6049_: type_36;
    var phi_6052_: f32;
    var phi_6054_: f32;
    var phi_6050_: type_36;
    var phi_6077_: type_36;
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
    var phi_6202_: type_36;
    var phi_6205_: f32;
    var phi_6207_: f32;
    var phi_6203_: type_36;
    var phi_6230_: type_36;
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
    var phi_6367_: type_36;
    var phi_6370_: f32;
    var phi_6372_: f32;
    var phi_6368_: type_36;
    var phi_6395_: type_36;
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
    var phi_7660_: type_36;
    var phi_7663_: f32;
    var phi_7665_: f32;
    var phi_7661_: type_36;
    var phi_7688_: type_36;
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
    var phi_7813_: type_36;
    var phi_7816_: f32;
    var phi_7818_: f32;
    var phi_7814_: type_36;
    var phi_7841_: type_36;
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
    var phi_7978_: type_36;
    var phi_7981_: f32;
    var phi_7983_: f32;
    var phi_7979_: type_36;
    var phi_8006_: type_36;
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
    var phi_8177_: type_36;
    var phi_8178_: type_36;
    var phi_8201_: type_36;
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
            let _e249 = params.member.member_20[0u][0u];
            let _e250 = (_e249 + (_e239 * 32u));
            let _e255 = params.member.member_20[0u][2u];
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
            let _e415 = (_e110 / 32u);
            let _e418 = atomicLoad((&counters[_e415]));
            phi_691_ = type_36(0u, _e418);
            phi_694_ = 0u;
            loop {
                let _e421 = phi_691_;
                let _e423 = phi_694_;
                local_70 = _e423;
                if (_e421.member < _e421.member_1) {
                    phi_692_ = type_36((_e421.member + 1u), _e421.member_1);
                    phi_717_ = type_36(1u, _e421.member);
                } else {
                    phi_692_ = _e421;
                    phi_717_ = type_36(0u, type_36().member_1);
                }
                let _e437 = phi_692_;
                let _e439 = phi_717_;
                let _e443 = (bitcast<i32>(_e439.member) != 0i);
                if _e443 {
                    let _e447 = names[((_e415 * 32u) + _e439.member_1)];
                    let _e451 = columns[((_e415 * 32u) + _e439.member_1)];
                    if ((((((_e414.member[0] <= _e451.member_1[0]) && (_e451.member[0] <= _e414.member_1[0])) && (_e414.member[1] <= _e451.member_1[1])) && (_e451.member[1] <= _e414.member_1[1])) && (_e414.member[2] <= _e451.member_1[2])) && (_e451.member[2] <= _e414.member_1[2])) {
                        let _e484 = atomicAdd((&counters[4u]), 1u);
                        if (_e484 < 2048u) {
                            hits[_e484] = (((_e415 << bitcast<u32>(10i)) | ((_e110 % 32u) << bitcast<u32>(5i))) | _e447);
                            phi_807_ = _e423;
                        } else {
                            phi_807_ = (_e423 | (1u << bitcast<u32>((_e439.member_1 & 31u))));
                        }
                        let _e498 = phi_807_;
                        phi_809_ = _e498;
                    } else {
                        phi_809_ = _e423;
                    }
                    let _e500 = phi_809_;
                    phi_695_ = _e500;
                } else {
                    phi_695_ = u32();
                }
                let _e502 = phi_695_;
                continue;
                continuing {
                    phi_691_ = _e437;
                    phi_694_ = _e502;
                    break if !(_e443);
                }
            }
            phi_812_ = type_36(0u, 32u);
            let _e5563 = local_70;
            phi_815_ = _e5563;
            loop {
                let _e505 = phi_812_;
                let _e507 = phi_815_;
                if (_e505.member < _e505.member_1) {
                    phi_813_ = type_36((_e505.member + 1u), _e505.member_1);
                    phi_838_ = type_36(1u, _e505.member);
                } else {
                    phi_813_ = _e505;
                    phi_838_ = type_36(0u, type_36().member_1);
                }
                let _e521 = phi_813_;
                let _e523 = phi_838_;
                if (bitcast<i32>(_e523.member) != 0i) {
                    if (_e507 == 0u) {
                        phi_1888_ = u32();
                        phi_1889_ = false;
                    } else {
                        let _e534 = names[((_e134 * 32u) + select(firstTrailingBit(_e507), 32u, (_e507 == 0u)))];
                        let _e537 = (_e250 + _e135);
                        let _e538 = (_e256 + _e534);
                        let _e540 = leaves.member[_e537];
                        let _e542 = leaves.member[_e538];
                        local_24 = type_24(array<u32, 3>(_e540.member[0], _e540.member[1], _e540.member[2]), _e540.member_1);
                        local_25 = type_24(array<u32, 3>(_e542.member[0], _e542.member[1], _e542.member[2]), _e542.member_1);
                        let _e558 = nodes.member[_e537];
                        let _e560 = nodes.member[_e538];
                        let _e562 = params.member.member_1;
                        if ((_e562 & 1u) != 0u) {
                            let _e566 = params.member.member_8;
                            if (_e566 == 0u) {
                                let _e610 = local_24.member[0u];
                                let _e613 = local_25.member[0u];
                                if (_e610 == _e613) {
                                    phi_949_ = bool();
                                    phi_950_ = true;
                                } else {
                                    let _e617 = local_24.member[0u];
                                    let _e620 = local_25.member[1u];
                                    let _e621 = (_e617 == _e620);
                                    if _e621 {
                                        phi_948_ = bool();
                                    } else {
                                        let _e624 = local_24.member[0u];
                                        let _e627 = local_25.member[2u];
                                        phi_948_ = (_e624 == _e627);
                                    }
                                    let _e630 = phi_948_;
                                    phi_949_ = _e630;
                                    phi_950_ = _e621;
                                }
                                let _e632 = phi_949_;
                                let _e634 = phi_950_;
                                if _e634 {
                                    phi_954_ = true;
                                } else {
                                    phi_954_ = _e632;
                                }
                                let _e636 = phi_954_;
                                phi_993_ = _e636;
                            } else {
                                let _e570 = local_24.member[0u];
                                let _e573 = local_25.member[0u];
                                if (_e570 == _e573) {
                                    phi_987_ = bool();
                                    phi_988_ = true;
                                } else {
                                    let _e577 = local_24.member[0u];
                                    let _e580 = local_25.member[1u];
                                    if (_e577 == _e580) {
                                        phi_985_ = bool();
                                        phi_986_ = true;
                                    } else {
                                        let _e584 = local_24.member[1u];
                                        let _e587 = local_25.member[0u];
                                        let _e588 = (_e584 == _e587);
                                        if _e588 {
                                            phi_984_ = bool();
                                        } else {
                                            let _e591 = local_24.member[1u];
                                            let _e594 = local_25.member[1u];
                                            phi_984_ = (_e591 == _e594);
                                        }
                                        let _e597 = phi_984_;
                                        phi_985_ = _e597;
                                        phi_986_ = _e588;
                                    }
                                    let _e599 = phi_985_;
                                    let _e601 = phi_986_;
                                    phi_987_ = _e599;
                                    phi_988_ = _e601;
                                }
                                let _e603 = phi_987_;
                                let _e605 = phi_988_;
                                if _e605 {
                                    phi_992_ = true;
                                } else {
                                    phi_992_ = _e603;
                                }
                                let _e607 = phi_992_;
                                phi_993_ = _e607;
                            }
                            let _e638 = phi_993_;
                            if _e638 {
                                phi_997_ = false;
                            } else {
                                phi_997_ = true;
                            }
                            let _e640 = phi_997_;
                            phi_998_ = _e640;
                        } else {
                            phi_998_ = true;
                        }
                        let _e642 = phi_998_;
                        if _e642 {
                            let _e644 = params.member.member_1;
                            if ((_e644 & 2u) != 0u) {
                                let _e649 = local_24.member[0u];
                                let _e651 = bodies.member[_e649];
                                let _e654 = local_25.member[0u];
                                let _e656 = bodies.member[_e654];
                                if ((_e651 / 2u) == (_e656 / 2u)) {
                                    let _e661 = params.member.member_1;
                                    phi_1044_ = !(((_e661 & 4u) != 0u));
                                } else {
                                    phi_1044_ = false;
                                }
                                let _e666 = phi_1044_;
                                if _e666 {
                                    phi_1055_ = true;
                                } else {
                                    if (((_e651 & _e656) & 1u) == 0u) {
                                        phi_1054_ = false;
                                    } else {
                                        phi_1054_ = true;
                                    }
                                    let _e671 = phi_1054_;
                                    phi_1055_ = _e671;
                                }
                                let _e673 = phi_1055_;
                                if _e673 {
                                    phi_1059_ = false;
                                } else {
                                    phi_1059_ = true;
                                }
                                let _e675 = phi_1059_;
                                phi_1060_ = _e675;
                            } else {
                                phi_1060_ = true;
                            }
                            let _e677 = phi_1060_;
                            if _e677 {
                                let _e679 = params.member.member_1;
                                if ((_e679 & 32u) != 0u) {
                                    let _e683 = params.member.member_6;
                                    let _e724 = (((((((_e558.member_1[0] - _e560.member[0]) > _e683) && ((_e560.member_1[0] - _e558.member[0]) > _e683)) && ((_e558.member_1[1] - _e560.member[1]) > _e683)) && ((_e560.member_1[1] - _e558.member[1]) > _e683)) && ((_e558.member_1[2] - _e560.member[2]) > _e683)) && ((_e560.member_1[2] - _e558.member[2]) > _e683));
                                    if _e724 {
                                        phi_1809_ = bool();
                                    } else {
                                        phi_1109_ = type_36(0u, 3u);
                                        phi_1112_ = true;
                                        loop {
                                            let _e728 = phi_1109_;
                                            let _e730 = phi_1112_;
                                            local_71 = _e730;
                                            if (_e728.member < _e728.member_1) {
                                                phi_1110_ = type_36((_e728.member + 1u), _e728.member_1);
                                                phi_1135_ = type_36(1u, _e728.member);
                                            } else {
                                                phi_1110_ = _e728;
                                                phi_1135_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e744 = phi_1110_;
                                            let _e746 = phi_1135_;
                                            let _e750 = (bitcast<i32>(_e746.member) != 0i);
                                            if _e750 {
                                                let _e752 = local_24.member[0u];
                                                let _e754 = keys.member[_e752];
                                                local_22 = array<array<u32, 2>, 6>(array<u32, 2>(_e754[0][0], _e754[0][1]), array<u32, 2>(_e754[1][0], _e754[1][1]), array<u32, 2>(_e754[2][0], _e754[2][1]), array<u32, 2>(_e754[3][0], _e754[3][1]), array<u32, 2>(_e754[4][0], _e754[4][1]), array<u32, 2>(_e754[5][0], _e754[5][1]));
                                                if (_e746.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e782 = local_22[_e746.member_1];
                                                phi_1192_ = type_36(1u, 3u);
                                                phi_1195_ = array<u32, 2>(_e782[0], _e782[1]);
                                                loop {
                                                    let _e787 = phi_1192_;
                                                    let _e789 = phi_1195_;
                                                    local_28 = _e789;
                                                    local_30 = _e789;
                                                    local_32 = _e789;
                                                    if (_e787.member < _e787.member_1) {
                                                        phi_1193_ = type_36((_e787.member + 1u), _e787.member_1);
                                                        phi_1218_ = type_36(1u, _e787.member);
                                                    } else {
                                                        phi_1193_ = _e787;
                                                        phi_1218_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e803 = phi_1193_;
                                                    let _e805 = phi_1218_;
                                                    let _e809 = (bitcast<i32>(_e805.member) != 0i);
                                                    if _e809 {
                                                        if (_e805.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e812 = local_24.member[_e805.member_1];
                                                        let _e814 = keys.member[_e812];
                                                        local_23 = array<array<u32, 2>, 6>(array<u32, 2>(_e814[0][0], _e814[0][1]), array<u32, 2>(_e814[1][0], _e814[1][1]), array<u32, 2>(_e814[2][0], _e814[2][1]), array<u32, 2>(_e814[3][0], _e814[3][1]), array<u32, 2>(_e814[4][0], _e814[4][1]), array<u32, 2>(_e814[5][0], _e814[5][1]));
                                                        if (_e746.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e842 = local_23[_e746.member_1];
                                                        if (_e789[1] > _e842[1]) {
                                                            phi_1294_ = true;
                                                        } else {
                                                            if (_e789[1] == _e842[1]) {
                                                                phi_1293_ = (_e789[0] > _e842[0]);
                                                            } else {
                                                                phi_1293_ = false;
                                                            }
                                                            let _e853 = phi_1293_;
                                                            phi_1294_ = _e853;
                                                        }
                                                        let _e855 = phi_1294_;
                                                        if _e855 {
                                                            phi_1298_ = array<u32, 2>(_e842[0], _e842[1]);
                                                        } else {
                                                            phi_1298_ = _e789;
                                                        }
                                                        let _e857 = phi_1298_;
                                                        phi_1196_ = _e857;
                                                    } else {
                                                        phi_1196_ = array<u32, 2>();
                                                    }
                                                    let _e859 = phi_1196_;
                                                    continue;
                                                    continuing {
                                                        phi_1192_ = _e803;
                                                        phi_1195_ = _e859;
                                                        break if !(_e809);
                                                    }
                                                }
                                                let _e862 = local_25.member[0u];
                                                let _e864 = keys.member[_e862];
                                                local_20 = array<array<u32, 2>, 6>(array<u32, 2>(_e864[0][0], _e864[0][1]), array<u32, 2>(_e864[1][0], _e864[1][1]), array<u32, 2>(_e864[2][0], _e864[2][1]), array<u32, 2>(_e864[3][0], _e864[3][1]), array<u32, 2>(_e864[4][0], _e864[4][1]), array<u32, 2>(_e864[5][0], _e864[5][1]));
                                                let _e890 = (3u + _e746.member_1);
                                                if (_e890 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e893 = local_20[_e890];
                                                phi_1349_ = type_36(1u, 3u);
                                                phi_1352_ = array<u32, 2>(_e893[0], _e893[1]);
                                                loop {
                                                    let _e898 = phi_1349_;
                                                    let _e900 = phi_1352_;
                                                    local_29 = _e900;
                                                    local_31 = _e900;
                                                    local_33 = _e900;
                                                    if (_e898.member < _e898.member_1) {
                                                        phi_1350_ = type_36((_e898.member + 1u), _e898.member_1);
                                                        phi_1375_ = type_36(1u, _e898.member);
                                                    } else {
                                                        phi_1350_ = _e898;
                                                        phi_1375_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e914 = phi_1350_;
                                                    let _e916 = phi_1375_;
                                                    let _e920 = (bitcast<i32>(_e916.member) != 0i);
                                                    if _e920 {
                                                        if (_e916.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e923 = local_25.member[_e916.member_1];
                                                        let _e925 = keys.member[_e923];
                                                        local_21 = array<array<u32, 2>, 6>(array<u32, 2>(_e925[0][0], _e925[0][1]), array<u32, 2>(_e925[1][0], _e925[1][1]), array<u32, 2>(_e925[2][0], _e925[2][1]), array<u32, 2>(_e925[3][0], _e925[3][1]), array<u32, 2>(_e925[4][0], _e925[4][1]), array<u32, 2>(_e925[5][0], _e925[5][1]));
                                                        let _e951 = (3u + _e746.member_1);
                                                        if (_e951 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e954 = local_21[_e951];
                                                        if (_e954[1] > _e900[1]) {
                                                            phi_1452_ = true;
                                                        } else {
                                                            if (_e954[1] == _e900[1]) {
                                                                phi_1451_ = (_e954[0] > _e900[0]);
                                                            } else {
                                                                phi_1451_ = false;
                                                            }
                                                            let _e965 = phi_1451_;
                                                            phi_1452_ = _e965;
                                                        }
                                                        let _e967 = phi_1452_;
                                                        if _e967 {
                                                            phi_1456_ = array<u32, 2>(_e954[0], _e954[1]);
                                                        } else {
                                                            phi_1456_ = _e900;
                                                        }
                                                        let _e969 = phi_1456_;
                                                        phi_1353_ = _e969;
                                                    } else {
                                                        phi_1353_ = array<u32, 2>();
                                                    }
                                                    let _e971 = phi_1353_;
                                                    continue;
                                                    continuing {
                                                        phi_1349_ = _e914;
                                                        phi_1352_ = _e971;
                                                        break if !(_e920);
                                                    }
                                                }
                                                let _e974 = local_28;
                                                let _e977 = local_29;
                                                if (_e974[1] > _e977[1]) {
                                                    phi_1473_ = true;
                                                } else {
                                                    let _e981 = local_30;
                                                    let _e984 = local_31;
                                                    if (_e981[1] == _e984[1]) {
                                                        let _e988 = local_32;
                                                        let _e991 = local_33;
                                                        phi_1472_ = (_e988[0] > _e991[0]);
                                                    } else {
                                                        phi_1472_ = false;
                                                    }
                                                    let _e995 = phi_1472_;
                                                    phi_1473_ = _e995;
                                                }
                                                let _e997 = phi_1473_;
                                                let _e1000 = local_25.member[0u];
                                                let _e1002 = keys.member[_e1000];
                                                local_18 = array<array<u32, 2>, 6>(array<u32, 2>(_e1002[0][0], _e1002[0][1]), array<u32, 2>(_e1002[1][0], _e1002[1][1]), array<u32, 2>(_e1002[2][0], _e1002[2][1]), array<u32, 2>(_e1002[3][0], _e1002[3][1]), array<u32, 2>(_e1002[4][0], _e1002[4][1]), array<u32, 2>(_e1002[5][0], _e1002[5][1]));
                                                if (_e746.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1030 = local_18[_e746.member_1];
                                                phi_1524_ = type_36(1u, 3u);
                                                phi_1527_ = array<u32, 2>(_e1030[0], _e1030[1]);
                                                loop {
                                                    let _e1035 = phi_1524_;
                                                    let _e1037 = phi_1527_;
                                                    local_34 = _e1037;
                                                    local_36 = _e1037;
                                                    local_38 = _e1037;
                                                    if (_e1035.member < _e1035.member_1) {
                                                        phi_1525_ = type_36((_e1035.member + 1u), _e1035.member_1);
                                                        phi_1550_ = type_36(1u, _e1035.member);
                                                    } else {
                                                        phi_1525_ = _e1035;
                                                        phi_1550_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1051 = phi_1525_;
                                                    let _e1053 = phi_1550_;
                                                    let _e1057 = (bitcast<i32>(_e1053.member) != 0i);
                                                    if _e1057 {
                                                        if (_e1053.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1060 = local_25.member[_e1053.member_1];
                                                        let _e1062 = keys.member[_e1060];
                                                        local_19 = array<array<u32, 2>, 6>(array<u32, 2>(_e1062[0][0], _e1062[0][1]), array<u32, 2>(_e1062[1][0], _e1062[1][1]), array<u32, 2>(_e1062[2][0], _e1062[2][1]), array<u32, 2>(_e1062[3][0], _e1062[3][1]), array<u32, 2>(_e1062[4][0], _e1062[4][1]), array<u32, 2>(_e1062[5][0], _e1062[5][1]));
                                                        if (_e746.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1090 = local_19[_e746.member_1];
                                                        if (_e1037[1] > _e1090[1]) {
                                                            phi_1626_ = true;
                                                        } else {
                                                            if (_e1037[1] == _e1090[1]) {
                                                                phi_1625_ = (_e1037[0] > _e1090[0]);
                                                            } else {
                                                                phi_1625_ = false;
                                                            }
                                                            let _e1101 = phi_1625_;
                                                            phi_1626_ = _e1101;
                                                        }
                                                        let _e1103 = phi_1626_;
                                                        if _e1103 {
                                                            phi_1630_ = array<u32, 2>(_e1090[0], _e1090[1]);
                                                        } else {
                                                            phi_1630_ = _e1037;
                                                        }
                                                        let _e1105 = phi_1630_;
                                                        phi_1528_ = _e1105;
                                                    } else {
                                                        phi_1528_ = array<u32, 2>();
                                                    }
                                                    let _e1107 = phi_1528_;
                                                    continue;
                                                    continuing {
                                                        phi_1524_ = _e1051;
                                                        phi_1527_ = _e1107;
                                                        break if !(_e1057);
                                                    }
                                                }
                                                let _e1110 = local_24.member[0u];
                                                let _e1112 = keys.member[_e1110];
                                                local_16 = array<array<u32, 2>, 6>(array<u32, 2>(_e1112[0][0], _e1112[0][1]), array<u32, 2>(_e1112[1][0], _e1112[1][1]), array<u32, 2>(_e1112[2][0], _e1112[2][1]), array<u32, 2>(_e1112[3][0], _e1112[3][1]), array<u32, 2>(_e1112[4][0], _e1112[4][1]), array<u32, 2>(_e1112[5][0], _e1112[5][1]));
                                                let _e1138 = (3u + _e746.member_1);
                                                if (_e1138 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1141 = local_16[_e1138];
                                                phi_1681_ = type_36(1u, 3u);
                                                phi_1684_ = array<u32, 2>(_e1141[0], _e1141[1]);
                                                loop {
                                                    let _e1146 = phi_1681_;
                                                    let _e1148 = phi_1684_;
                                                    local_35 = _e1148;
                                                    local_37 = _e1148;
                                                    local_39 = _e1148;
                                                    if (_e1146.member < _e1146.member_1) {
                                                        phi_1682_ = type_36((_e1146.member + 1u), _e1146.member_1);
                                                        phi_1707_ = type_36(1u, _e1146.member);
                                                    } else {
                                                        phi_1682_ = _e1146;
                                                        phi_1707_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1162 = phi_1682_;
                                                    let _e1164 = phi_1707_;
                                                    let _e1168 = (bitcast<i32>(_e1164.member) != 0i);
                                                    if _e1168 {
                                                        if (_e1164.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1171 = local_24.member[_e1164.member_1];
                                                        let _e1173 = keys.member[_e1171];
                                                        local_17 = array<array<u32, 2>, 6>(array<u32, 2>(_e1173[0][0], _e1173[0][1]), array<u32, 2>(_e1173[1][0], _e1173[1][1]), array<u32, 2>(_e1173[2][0], _e1173[2][1]), array<u32, 2>(_e1173[3][0], _e1173[3][1]), array<u32, 2>(_e1173[4][0], _e1173[4][1]), array<u32, 2>(_e1173[5][0], _e1173[5][1]));
                                                        let _e1199 = (3u + _e746.member_1);
                                                        if (_e1199 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1202 = local_17[_e1199];
                                                        if (_e1202[1] > _e1148[1]) {
                                                            phi_1784_ = true;
                                                        } else {
                                                            if (_e1202[1] == _e1148[1]) {
                                                                phi_1783_ = (_e1202[0] > _e1148[0]);
                                                            } else {
                                                                phi_1783_ = false;
                                                            }
                                                            let _e1213 = phi_1783_;
                                                            phi_1784_ = _e1213;
                                                        }
                                                        let _e1215 = phi_1784_;
                                                        if _e1215 {
                                                            phi_1788_ = array<u32, 2>(_e1202[0], _e1202[1]);
                                                        } else {
                                                            phi_1788_ = _e1148;
                                                        }
                                                        let _e1217 = phi_1788_;
                                                        phi_1685_ = _e1217;
                                                    } else {
                                                        phi_1685_ = array<u32, 2>();
                                                    }
                                                    let _e1219 = phi_1685_;
                                                    continue;
                                                    continuing {
                                                        phi_1681_ = _e1162;
                                                        phi_1684_ = _e1219;
                                                        break if !(_e1168);
                                                    }
                                                }
                                                let _e1222 = local_34;
                                                let _e1225 = local_35;
                                                if (_e1222[1] > _e1225[1]) {
                                                    phi_1805_ = true;
                                                } else {
                                                    let _e1229 = local_36;
                                                    let _e1232 = local_37;
                                                    if (_e1229[1] == _e1232[1]) {
                                                        let _e1236 = local_38;
                                                        let _e1239 = local_39;
                                                        phi_1804_ = (_e1236[0] > _e1239[0]);
                                                    } else {
                                                        phi_1804_ = false;
                                                    }
                                                    let _e1243 = phi_1804_;
                                                    phi_1805_ = _e1243;
                                                }
                                                let _e1245 = phi_1805_;
                                                phi_1113_ = (_e730 && (!(_e997) && !(_e1245)));
                                            } else {
                                                phi_1113_ = bool();
                                            }
                                            let _e1250 = phi_1113_;
                                            continue;
                                            continuing {
                                                phi_1109_ = _e744;
                                                phi_1112_ = _e1250;
                                                break if !(_e750);
                                            }
                                        }
                                        let _e5639 = local_71;
                                        phi_1809_ = _e5639;
                                    }
                                    let _e1253 = phi_1809_;
                                    phi_1810_ = _e1253;
                                    phi_1811_ = _e724;
                                } else {
                                    phi_1810_ = bool();
                                    phi_1811_ = true;
                                }
                                let _e1255 = phi_1810_;
                                let _e1257 = phi_1811_;
                                if _e1257 {
                                    phi_1815_ = false;
                                } else {
                                    phi_1815_ = true;
                                }
                                let _e1259 = phi_1815_;
                                phi_1816_ = _e1255;
                                phi_1817_ = _e1259;
                            } else {
                                phi_1816_ = false;
                                phi_1817_ = true;
                            }
                            let _e1261 = phi_1816_;
                            let _e1263 = phi_1817_;
                            phi_1818_ = _e1261;
                            phi_1819_ = _e1263;
                        } else {
                            phi_1818_ = false;
                            phi_1819_ = true;
                        }
                        let _e1265 = phi_1818_;
                        let _e1267 = phi_1819_;
                        if _e1267 {
                            phi_1823_ = _e1265;
                        } else {
                            phi_1823_ = true;
                        }
                        let _e1269 = phi_1823_;
                        if _e1269 {
                            let _e1271 = params.member.member_16;
                            let _e1273 = local_24.member_1;
                            let _e1275 = local_25.member_1;
                            let _e1277 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e1277 + 1u) < _e1277) {
                                let _e1281 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e1277 < _e1271) {
                                atomicStore((&output.member[(4u + (2u * _e1277))]), _e1273);
                                atomicStore((&output.member[((2u * _e1277) + 5u)]), _e1275);
                            }
                            let _e1290 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e1290 + 1u) < _e1290) {
                                let _e1294 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1888_ = (_e507 & (_e507 - 1u));
                        phi_1889_ = true;
                    }
                    let _e1296 = phi_1888_;
                    let _e1298 = phi_1889_;
                    phi_816_ = _e1296;
                    phi_1890_ = _e1298;
                } else {
                    phi_816_ = u32();
                    phi_1890_ = false;
                }
                let _e1300 = phi_816_;
                let _e1302 = phi_1890_;
                continue;
                continuing {
                    phi_812_ = _e521;
                    phi_815_ = _e1300;
                    break if !(_e1302);
                }
            }
            workgroupBarrier();
            let _e1305 = atomicLoad((&counters[4u]));
            if (2048u < _e1305) {
                phi_1897_ = 2048u;
            } else {
                phi_1897_ = _e1305;
            }
            let _e1308 = phi_1897_;
            phi_1900_ = type_36(0u, 16u);
            loop {
                let _e1310 = phi_1900_;
                if (_e1310.member < _e1310.member_1) {
                    phi_1901_ = type_36((_e1310.member + 1u), _e1310.member_1);
                    phi_1924_ = type_36(1u, _e1310.member);
                } else {
                    phi_1901_ = _e1310;
                    phi_1924_ = type_36(0u, type_36().member_1);
                }
                let _e1324 = phi_1901_;
                let _e1326 = phi_1924_;
                if (bitcast<i32>(_e1326.member) != 0i) {
                    let _e1332 = (_e110 + (_e1326.member_1 * 128u));
                    if (_e1332 >= _e1308) {
                        phi_8126_ = false;
                    } else {
                        let _e1335 = hits[_e1332];
                        let _e1338 = ((_e1335 >> bitcast<u32>(10i)) & 3u);
                        let _e1345 = firsts[(2u * _e1338)];
                        let _e1346 = (_e1345 + ((_e1335 >> bitcast<u32>(5i)) & 31u));
                        let _e1350 = firsts[((2u * _e1338) + 1u)];
                        let _e1351 = (_e1350 + (_e1335 & 31u));
                        let _e1353 = leaves.member[_e1346];
                        let _e1355 = leaves.member[_e1351];
                        local_26 = type_24(array<u32, 3>(_e1353.member[0], _e1353.member[1], _e1353.member[2]), _e1353.member_1);
                        local_27 = type_24(array<u32, 3>(_e1355.member[0], _e1355.member[1], _e1355.member[2]), _e1355.member_1);
                        let _e1371 = nodes.member[_e1346];
                        let _e1373 = nodes.member[_e1351];
                        let _e1375 = params.member.member_1;
                        if ((_e1375 & 1u) != 0u) {
                            let _e1379 = params.member.member_8;
                            if (_e1379 == 0u) {
                                let _e1423 = local_26.member[0u];
                                let _e1426 = local_27.member[0u];
                                if (_e1423 == _e1426) {
                                    phi_2043_ = bool();
                                    phi_2044_ = true;
                                } else {
                                    let _e1430 = local_26.member[0u];
                                    let _e1433 = local_27.member[1u];
                                    let _e1434 = (_e1430 == _e1433);
                                    if _e1434 {
                                        phi_2042_ = bool();
                                    } else {
                                        let _e1437 = local_26.member[0u];
                                        let _e1440 = local_27.member[2u];
                                        phi_2042_ = (_e1437 == _e1440);
                                    }
                                    let _e1443 = phi_2042_;
                                    phi_2043_ = _e1443;
                                    phi_2044_ = _e1434;
                                }
                                let _e1445 = phi_2043_;
                                let _e1447 = phi_2044_;
                                if _e1447 {
                                    phi_2048_ = true;
                                } else {
                                    phi_2048_ = _e1445;
                                }
                                let _e1449 = phi_2048_;
                                phi_2087_ = _e1449;
                            } else {
                                let _e1383 = local_26.member[0u];
                                let _e1386 = local_27.member[0u];
                                if (_e1383 == _e1386) {
                                    phi_2081_ = bool();
                                    phi_2082_ = true;
                                } else {
                                    let _e1390 = local_26.member[0u];
                                    let _e1393 = local_27.member[1u];
                                    if (_e1390 == _e1393) {
                                        phi_2079_ = bool();
                                        phi_2080_ = true;
                                    } else {
                                        let _e1397 = local_26.member[1u];
                                        let _e1400 = local_27.member[0u];
                                        let _e1401 = (_e1397 == _e1400);
                                        if _e1401 {
                                            phi_2078_ = bool();
                                        } else {
                                            let _e1404 = local_26.member[1u];
                                            let _e1407 = local_27.member[1u];
                                            phi_2078_ = (_e1404 == _e1407);
                                        }
                                        let _e1410 = phi_2078_;
                                        phi_2079_ = _e1410;
                                        phi_2080_ = _e1401;
                                    }
                                    let _e1412 = phi_2079_;
                                    let _e1414 = phi_2080_;
                                    phi_2081_ = _e1412;
                                    phi_2082_ = _e1414;
                                }
                                let _e1416 = phi_2081_;
                                let _e1418 = phi_2082_;
                                if _e1418 {
                                    phi_2086_ = true;
                                } else {
                                    phi_2086_ = _e1416;
                                }
                                let _e1420 = phi_2086_;
                                phi_2087_ = _e1420;
                            }
                            let _e1451 = phi_2087_;
                            if _e1451 {
                                phi_2091_ = false;
                            } else {
                                phi_2091_ = true;
                            }
                            let _e1453 = phi_2091_;
                            phi_2092_ = _e1453;
                        } else {
                            phi_2092_ = true;
                        }
                        let _e1455 = phi_2092_;
                        if _e1455 {
                            let _e1457 = params.member.member_1;
                            if ((_e1457 & 2u) != 0u) {
                                let _e1462 = local_26.member[0u];
                                let _e1464 = bodies.member[_e1462];
                                let _e1467 = local_27.member[0u];
                                let _e1469 = bodies.member[_e1467];
                                if ((_e1464 / 2u) == (_e1469 / 2u)) {
                                    let _e1474 = params.member.member_1;
                                    phi_2138_ = !(((_e1474 & 4u) != 0u));
                                } else {
                                    phi_2138_ = false;
                                }
                                let _e1479 = phi_2138_;
                                if _e1479 {
                                    phi_2149_ = true;
                                } else {
                                    if (((_e1464 & _e1469) & 1u) == 0u) {
                                        phi_2148_ = false;
                                    } else {
                                        phi_2148_ = true;
                                    }
                                    let _e1484 = phi_2148_;
                                    phi_2149_ = _e1484;
                                }
                                let _e1486 = phi_2149_;
                                if _e1486 {
                                    phi_2153_ = false;
                                } else {
                                    phi_2153_ = true;
                                }
                                let _e1488 = phi_2153_;
                                phi_2154_ = _e1488;
                            } else {
                                phi_2154_ = true;
                            }
                            let _e1490 = phi_2154_;
                            if _e1490 {
                                let _e1492 = params.member.member_1;
                                if ((_e1492 & 32u) != 0u) {
                                    let _e1496 = params.member.member_6;
                                    let _e1537 = (((((((_e1371.member_1[0] - _e1373.member[0]) > _e1496) && ((_e1373.member_1[0] - _e1371.member[0]) > _e1496)) && ((_e1371.member_1[1] - _e1373.member[1]) > _e1496)) && ((_e1373.member_1[1] - _e1371.member[1]) > _e1496)) && ((_e1371.member_1[2] - _e1373.member[2]) > _e1496)) && ((_e1373.member_1[2] - _e1371.member[2]) > _e1496));
                                    if _e1537 {
                                        phi_2903_ = bool();
                                    } else {
                                        phi_2203_ = type_36(0u, 3u);
                                        phi_2206_ = true;
                                        loop {
                                            let _e1541 = phi_2203_;
                                            let _e1543 = phi_2206_;
                                            local_72 = _e1543;
                                            if (_e1541.member < _e1541.member_1) {
                                                phi_2204_ = type_36((_e1541.member + 1u), _e1541.member_1);
                                                phi_2229_ = type_36(1u, _e1541.member);
                                            } else {
                                                phi_2204_ = _e1541;
                                                phi_2229_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e1557 = phi_2204_;
                                            let _e1559 = phi_2229_;
                                            let _e1563 = (bitcast<i32>(_e1559.member) != 0i);
                                            if _e1563 {
                                                let _e1565 = local_26.member[0u];
                                                let _e1567 = keys.member[_e1565];
                                                local_14 = array<array<u32, 2>, 6>(array<u32, 2>(_e1567[0][0], _e1567[0][1]), array<u32, 2>(_e1567[1][0], _e1567[1][1]), array<u32, 2>(_e1567[2][0], _e1567[2][1]), array<u32, 2>(_e1567[3][0], _e1567[3][1]), array<u32, 2>(_e1567[4][0], _e1567[4][1]), array<u32, 2>(_e1567[5][0], _e1567[5][1]));
                                                if (_e1559.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1595 = local_14[_e1559.member_1];
                                                phi_2286_ = type_36(1u, 3u);
                                                phi_2289_ = array<u32, 2>(_e1595[0], _e1595[1]);
                                                loop {
                                                    let _e1600 = phi_2286_;
                                                    let _e1602 = phi_2289_;
                                                    local_40 = _e1602;
                                                    local_42 = _e1602;
                                                    local_44 = _e1602;
                                                    if (_e1600.member < _e1600.member_1) {
                                                        phi_2287_ = type_36((_e1600.member + 1u), _e1600.member_1);
                                                        phi_2312_ = type_36(1u, _e1600.member);
                                                    } else {
                                                        phi_2287_ = _e1600;
                                                        phi_2312_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1616 = phi_2287_;
                                                    let _e1618 = phi_2312_;
                                                    let _e1622 = (bitcast<i32>(_e1618.member) != 0i);
                                                    if _e1622 {
                                                        if (_e1618.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1625 = local_26.member[_e1618.member_1];
                                                        let _e1627 = keys.member[_e1625];
                                                        local_15 = array<array<u32, 2>, 6>(array<u32, 2>(_e1627[0][0], _e1627[0][1]), array<u32, 2>(_e1627[1][0], _e1627[1][1]), array<u32, 2>(_e1627[2][0], _e1627[2][1]), array<u32, 2>(_e1627[3][0], _e1627[3][1]), array<u32, 2>(_e1627[4][0], _e1627[4][1]), array<u32, 2>(_e1627[5][0], _e1627[5][1]));
                                                        if (_e1559.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1655 = local_15[_e1559.member_1];
                                                        if (_e1602[1] > _e1655[1]) {
                                                            phi_2388_ = true;
                                                        } else {
                                                            if (_e1602[1] == _e1655[1]) {
                                                                phi_2387_ = (_e1602[0] > _e1655[0]);
                                                            } else {
                                                                phi_2387_ = false;
                                                            }
                                                            let _e1666 = phi_2387_;
                                                            phi_2388_ = _e1666;
                                                        }
                                                        let _e1668 = phi_2388_;
                                                        if _e1668 {
                                                            phi_2392_ = array<u32, 2>(_e1655[0], _e1655[1]);
                                                        } else {
                                                            phi_2392_ = _e1602;
                                                        }
                                                        let _e1670 = phi_2392_;
                                                        phi_2290_ = _e1670;
                                                    } else {
                                                        phi_2290_ = array<u32, 2>();
                                                    }
                                                    let _e1672 = phi_2290_;
                                                    continue;
                                                    continuing {
                                                        phi_2286_ = _e1616;
                                                        phi_2289_ = _e1672;
                                                        break if !(_e1622);
                                                    }
                                                }
                                                let _e1675 = local_27.member[0u];
                                                let _e1677 = keys.member[_e1675];
                                                local_12 = array<array<u32, 2>, 6>(array<u32, 2>(_e1677[0][0], _e1677[0][1]), array<u32, 2>(_e1677[1][0], _e1677[1][1]), array<u32, 2>(_e1677[2][0], _e1677[2][1]), array<u32, 2>(_e1677[3][0], _e1677[3][1]), array<u32, 2>(_e1677[4][0], _e1677[4][1]), array<u32, 2>(_e1677[5][0], _e1677[5][1]));
                                                let _e1703 = (3u + _e1559.member_1);
                                                if (_e1703 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1706 = local_12[_e1703];
                                                phi_2443_ = type_36(1u, 3u);
                                                phi_2446_ = array<u32, 2>(_e1706[0], _e1706[1]);
                                                loop {
                                                    let _e1711 = phi_2443_;
                                                    let _e1713 = phi_2446_;
                                                    local_41 = _e1713;
                                                    local_43 = _e1713;
                                                    local_45 = _e1713;
                                                    if (_e1711.member < _e1711.member_1) {
                                                        phi_2444_ = type_36((_e1711.member + 1u), _e1711.member_1);
                                                        phi_2469_ = type_36(1u, _e1711.member);
                                                    } else {
                                                        phi_2444_ = _e1711;
                                                        phi_2469_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1727 = phi_2444_;
                                                    let _e1729 = phi_2469_;
                                                    let _e1733 = (bitcast<i32>(_e1729.member) != 0i);
                                                    if _e1733 {
                                                        if (_e1729.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1736 = local_27.member[_e1729.member_1];
                                                        let _e1738 = keys.member[_e1736];
                                                        local_13 = array<array<u32, 2>, 6>(array<u32, 2>(_e1738[0][0], _e1738[0][1]), array<u32, 2>(_e1738[1][0], _e1738[1][1]), array<u32, 2>(_e1738[2][0], _e1738[2][1]), array<u32, 2>(_e1738[3][0], _e1738[3][1]), array<u32, 2>(_e1738[4][0], _e1738[4][1]), array<u32, 2>(_e1738[5][0], _e1738[5][1]));
                                                        let _e1764 = (3u + _e1559.member_1);
                                                        if (_e1764 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1767 = local_13[_e1764];
                                                        if (_e1767[1] > _e1713[1]) {
                                                            phi_2546_ = true;
                                                        } else {
                                                            if (_e1767[1] == _e1713[1]) {
                                                                phi_2545_ = (_e1767[0] > _e1713[0]);
                                                            } else {
                                                                phi_2545_ = false;
                                                            }
                                                            let _e1778 = phi_2545_;
                                                            phi_2546_ = _e1778;
                                                        }
                                                        let _e1780 = phi_2546_;
                                                        if _e1780 {
                                                            phi_2550_ = array<u32, 2>(_e1767[0], _e1767[1]);
                                                        } else {
                                                            phi_2550_ = _e1713;
                                                        }
                                                        let _e1782 = phi_2550_;
                                                        phi_2447_ = _e1782;
                                                    } else {
                                                        phi_2447_ = array<u32, 2>();
                                                    }
                                                    let _e1784 = phi_2447_;
                                                    continue;
                                                    continuing {
                                                        phi_2443_ = _e1727;
                                                        phi_2446_ = _e1784;
                                                        break if !(_e1733);
                                                    }
                                                }
                                                let _e1787 = local_40;
                                                let _e1790 = local_41;
                                                if (_e1787[1] > _e1790[1]) {
                                                    phi_2567_ = true;
                                                } else {
                                                    let _e1794 = local_42;
                                                    let _e1797 = local_43;
                                                    if (_e1794[1] == _e1797[1]) {
                                                        let _e1801 = local_44;
                                                        let _e1804 = local_45;
                                                        phi_2566_ = (_e1801[0] > _e1804[0]);
                                                    } else {
                                                        phi_2566_ = false;
                                                    }
                                                    let _e1808 = phi_2566_;
                                                    phi_2567_ = _e1808;
                                                }
                                                let _e1810 = phi_2567_;
                                                let _e1813 = local_27.member[0u];
                                                let _e1815 = keys.member[_e1813];
                                                local_10 = array<array<u32, 2>, 6>(array<u32, 2>(_e1815[0][0], _e1815[0][1]), array<u32, 2>(_e1815[1][0], _e1815[1][1]), array<u32, 2>(_e1815[2][0], _e1815[2][1]), array<u32, 2>(_e1815[3][0], _e1815[3][1]), array<u32, 2>(_e1815[4][0], _e1815[4][1]), array<u32, 2>(_e1815[5][0], _e1815[5][1]));
                                                if (_e1559.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1843 = local_10[_e1559.member_1];
                                                phi_2618_ = type_36(1u, 3u);
                                                phi_2621_ = array<u32, 2>(_e1843[0], _e1843[1]);
                                                loop {
                                                    let _e1848 = phi_2618_;
                                                    let _e1850 = phi_2621_;
                                                    local_46 = _e1850;
                                                    local_48 = _e1850;
                                                    local_50 = _e1850;
                                                    if (_e1848.member < _e1848.member_1) {
                                                        phi_2619_ = type_36((_e1848.member + 1u), _e1848.member_1);
                                                        phi_2644_ = type_36(1u, _e1848.member);
                                                    } else {
                                                        phi_2619_ = _e1848;
                                                        phi_2644_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1864 = phi_2619_;
                                                    let _e1866 = phi_2644_;
                                                    let _e1870 = (bitcast<i32>(_e1866.member) != 0i);
                                                    if _e1870 {
                                                        if (_e1866.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1873 = local_27.member[_e1866.member_1];
                                                        let _e1875 = keys.member[_e1873];
                                                        local_11 = array<array<u32, 2>, 6>(array<u32, 2>(_e1875[0][0], _e1875[0][1]), array<u32, 2>(_e1875[1][0], _e1875[1][1]), array<u32, 2>(_e1875[2][0], _e1875[2][1]), array<u32, 2>(_e1875[3][0], _e1875[3][1]), array<u32, 2>(_e1875[4][0], _e1875[4][1]), array<u32, 2>(_e1875[5][0], _e1875[5][1]));
                                                        if (_e1559.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1903 = local_11[_e1559.member_1];
                                                        if (_e1850[1] > _e1903[1]) {
                                                            phi_2720_ = true;
                                                        } else {
                                                            if (_e1850[1] == _e1903[1]) {
                                                                phi_2719_ = (_e1850[0] > _e1903[0]);
                                                            } else {
                                                                phi_2719_ = false;
                                                            }
                                                            let _e1914 = phi_2719_;
                                                            phi_2720_ = _e1914;
                                                        }
                                                        let _e1916 = phi_2720_;
                                                        if _e1916 {
                                                            phi_2724_ = array<u32, 2>(_e1903[0], _e1903[1]);
                                                        } else {
                                                            phi_2724_ = _e1850;
                                                        }
                                                        let _e1918 = phi_2724_;
                                                        phi_2622_ = _e1918;
                                                    } else {
                                                        phi_2622_ = array<u32, 2>();
                                                    }
                                                    let _e1920 = phi_2622_;
                                                    continue;
                                                    continuing {
                                                        phi_2618_ = _e1864;
                                                        phi_2621_ = _e1920;
                                                        break if !(_e1870);
                                                    }
                                                }
                                                let _e1923 = local_26.member[0u];
                                                let _e1925 = keys.member[_e1923];
                                                local_8 = array<array<u32, 2>, 6>(array<u32, 2>(_e1925[0][0], _e1925[0][1]), array<u32, 2>(_e1925[1][0], _e1925[1][1]), array<u32, 2>(_e1925[2][0], _e1925[2][1]), array<u32, 2>(_e1925[3][0], _e1925[3][1]), array<u32, 2>(_e1925[4][0], _e1925[4][1]), array<u32, 2>(_e1925[5][0], _e1925[5][1]));
                                                let _e1951 = (3u + _e1559.member_1);
                                                if (_e1951 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1954 = local_8[_e1951];
                                                phi_2775_ = type_36(1u, 3u);
                                                phi_2778_ = array<u32, 2>(_e1954[0], _e1954[1]);
                                                loop {
                                                    let _e1959 = phi_2775_;
                                                    let _e1961 = phi_2778_;
                                                    local_47 = _e1961;
                                                    local_49 = _e1961;
                                                    local_51 = _e1961;
                                                    if (_e1959.member < _e1959.member_1) {
                                                        phi_2776_ = type_36((_e1959.member + 1u), _e1959.member_1);
                                                        phi_2801_ = type_36(1u, _e1959.member);
                                                    } else {
                                                        phi_2776_ = _e1959;
                                                        phi_2801_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1975 = phi_2776_;
                                                    let _e1977 = phi_2801_;
                                                    let _e1981 = (bitcast<i32>(_e1977.member) != 0i);
                                                    if _e1981 {
                                                        if (_e1977.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1984 = local_26.member[_e1977.member_1];
                                                        let _e1986 = keys.member[_e1984];
                                                        local_9 = array<array<u32, 2>, 6>(array<u32, 2>(_e1986[0][0], _e1986[0][1]), array<u32, 2>(_e1986[1][0], _e1986[1][1]), array<u32, 2>(_e1986[2][0], _e1986[2][1]), array<u32, 2>(_e1986[3][0], _e1986[3][1]), array<u32, 2>(_e1986[4][0], _e1986[4][1]), array<u32, 2>(_e1986[5][0], _e1986[5][1]));
                                                        let _e2012 = (3u + _e1559.member_1);
                                                        if (_e2012 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2015 = local_9[_e2012];
                                                        if (_e2015[1] > _e1961[1]) {
                                                            phi_2878_ = true;
                                                        } else {
                                                            if (_e2015[1] == _e1961[1]) {
                                                                phi_2877_ = (_e2015[0] > _e1961[0]);
                                                            } else {
                                                                phi_2877_ = false;
                                                            }
                                                            let _e2026 = phi_2877_;
                                                            phi_2878_ = _e2026;
                                                        }
                                                        let _e2028 = phi_2878_;
                                                        if _e2028 {
                                                            phi_2882_ = array<u32, 2>(_e2015[0], _e2015[1]);
                                                        } else {
                                                            phi_2882_ = _e1961;
                                                        }
                                                        let _e2030 = phi_2882_;
                                                        phi_2779_ = _e2030;
                                                    } else {
                                                        phi_2779_ = array<u32, 2>();
                                                    }
                                                    let _e2032 = phi_2779_;
                                                    continue;
                                                    continuing {
                                                        phi_2775_ = _e1975;
                                                        phi_2778_ = _e2032;
                                                        break if !(_e1981);
                                                    }
                                                }
                                                let _e2035 = local_46;
                                                let _e2038 = local_47;
                                                if (_e2035[1] > _e2038[1]) {
                                                    phi_2899_ = true;
                                                } else {
                                                    let _e2042 = local_48;
                                                    let _e2045 = local_49;
                                                    if (_e2042[1] == _e2045[1]) {
                                                        let _e2049 = local_50;
                                                        let _e2052 = local_51;
                                                        phi_2898_ = (_e2049[0] > _e2052[0]);
                                                    } else {
                                                        phi_2898_ = false;
                                                    }
                                                    let _e2056 = phi_2898_;
                                                    phi_2899_ = _e2056;
                                                }
                                                let _e2058 = phi_2899_;
                                                phi_2207_ = (_e1543 && (!(_e1810) && !(_e2058)));
                                            } else {
                                                phi_2207_ = bool();
                                            }
                                            let _e2063 = phi_2207_;
                                            continue;
                                            continuing {
                                                phi_2203_ = _e1557;
                                                phi_2206_ = _e2063;
                                                break if !(_e1563);
                                            }
                                        }
                                        let _e5729 = local_72;
                                        phi_2903_ = _e5729;
                                    }
                                    let _e2066 = phi_2903_;
                                    phi_2904_ = _e2066;
                                    phi_2905_ = _e1537;
                                } else {
                                    phi_2904_ = bool();
                                    phi_2905_ = true;
                                }
                                let _e2068 = phi_2904_;
                                let _e2070 = phi_2905_;
                                if _e2070 {
                                    phi_2909_ = false;
                                } else {
                                    phi_2909_ = true;
                                }
                                let _e2072 = phi_2909_;
                                phi_2910_ = _e2068;
                                phi_2911_ = _e2072;
                            } else {
                                phi_2910_ = false;
                                phi_2911_ = true;
                            }
                            let _e2074 = phi_2910_;
                            let _e2076 = phi_2911_;
                            phi_2912_ = _e2074;
                            phi_2913_ = _e2076;
                        } else {
                            phi_2912_ = false;
                            phi_2913_ = true;
                        }
                        let _e2078 = phi_2912_;
                        let _e2080 = phi_2913_;
                        if _e2080 {
                            phi_2917_ = _e2078;
                        } else {
                            phi_2917_ = true;
                        }
                        let _e2082 = phi_2917_;
                        if _e2082 {
                            let _e2084 = atomicAdd((&counters[7u]), 1u);
                            let _e2086 = params.member.member_4;
                            let _e2088 = params.member.member_5;
                            let _e2091 = local_26.member[0u];
                            let _e2094 = local_27.member[0u];
                            let _e2097 = local_27.member[1u];
                            let _e2100 = local_27.member[2u];
                            let _e2102 = paths.member[_e2091];
                            let _e2104 = paths.member[_e2094];
                            let _e2110 = paths.member[_e2097];
                            let _e2112 = paths.member[_e2100];
                            local_7 = type_71(array<array<f32, 3>, 2>(array<f32, 3>((_e2102.member[0] - _e2104.member[0]), (_e2102.member[1] - _e2104.member[1]), (_e2102.member[2] - _e2104.member[2])), array<f32, 3>((_e2102.member_1[0] - _e2104.member_1[0]), (_e2102.member_1[1] - _e2104.member_1[1]), (_e2102.member_1[2] - _e2104.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e2110.member[0] - _e2104.member[0]), (_e2110.member[1] - _e2104.member[1]), (_e2110.member[2] - _e2104.member[2])), array<f32, 3>((_e2110.member_1[0] - _e2104.member_1[0]), (_e2110.member_1[1] - _e2104.member_1[1]), (_e2110.member_1[2] - _e2104.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e2112.member[0] - _e2104.member[0]), (_e2112.member[1] - _e2104.member[1]), (_e2112.member[2] - _e2104.member[2])), array<f32, 3>((_e2112.member_1[0] - _e2104.member_1[0]), (_e2112.member_1[1] - _e2104.member_1[1]), (_e2112.member_1[2] - _e2104.member_1[2]))), (_e2086 + _e2086));
                            let _e2172 = local_7.member_1[0u];
                            let _e2178 = local_7.member_2[0u];
                            let _e2184 = ((_e2172[1] * _e2178[2]) - (_e2172[2] * _e2178[1]));
                            let _e2187 = ((_e2172[2] * _e2178[0]) - (_e2172[0] * _e2178[2]));
                            let _e2190 = ((_e2172[0] * _e2178[1]) - (_e2172[1] * _e2178[0]));
                            let _e2193 = local_7.member_1[1u];
                            let _e2199 = local_7.member_2[1u];
                            let _e2205 = ((_e2193[1] * _e2199[2]) - (_e2193[2] * _e2199[1]));
                            let _e2208 = ((_e2193[2] * _e2199[0]) - (_e2193[0] * _e2199[2]));
                            let _e2211 = ((_e2193[0] * _e2199[1]) - (_e2193[1] * _e2199[0]));
                            let _e2214 = local_7.member_1[0u];
                            let _e2220 = local_7.member_2[1u];
                            let _e2235 = local_7.member_1[1u];
                            let _e2241 = local_7.member_2[0u];
                            let _e2254 = (((_e2214[1] * _e2220[2]) - (_e2214[2] * _e2220[1])) + ((_e2235[1] * _e2241[2]) - (_e2235[2] * _e2241[1])));
                            let _e2255 = (((_e2214[2] * _e2220[0]) - (_e2214[0] * _e2220[2])) + ((_e2235[2] * _e2241[0]) - (_e2235[0] * _e2241[2])));
                            let _e2256 = (((_e2214[0] * _e2220[1]) - (_e2214[1] * _e2220[0])) + ((_e2235[0] * _e2241[1]) - (_e2235[1] * _e2241[0])));
                            let _e2259 = local_7.member[0u];
                            let _e2270 = local_7.member[1u];
                            let _e2281 = local_7.member[0u];
                            let _e2290 = ((((_e2270[0] * _e2184) + (_e2270[1] * _e2187)) + (_e2270[2] * _e2190)) + (((_e2281[0] * _e2254) + (_e2281[1] * _e2255)) + (_e2281[2] * _e2256)));
                            let _e2293 = local_7.member[0u];
                            let _e2304 = local_7.member[1u];
                            let _e2313 = ((((_e2293[0] * _e2205) + (_e2293[1] * _e2208)) + (_e2293[2] * _e2211)) + (((_e2304[0] * _e2254) + (_e2304[1] * _e2255)) + (_e2304[2] * _e2256)));
                            let _e2316 = local_7.member[1u];
                            let _e2327 = local_7.member[0u];
                            if (_e2327[0] < 0f) {
                                phi_3315_ = -(_e2327[0]);
                            } else {
                                phi_3315_ = _e2327[0];
                            }
                            let _e2334 = phi_3315_;
                            if (_e2327[1] < 0f) {
                                phi_3322_ = -(_e2327[1]);
                            } else {
                                phi_3322_ = _e2327[1];
                            }
                            let _e2338 = phi_3322_;
                            if (_e2334 > _e2338) {
                                phi_3327_ = _e2334;
                            } else {
                                phi_3327_ = _e2338;
                            }
                            let _e2341 = phi_3327_;
                            if (_e2327[2] < 0f) {
                                phi_3334_ = -(_e2327[2]);
                            } else {
                                phi_3334_ = _e2327[2];
                            }
                            let _e2345 = phi_3334_;
                            if (_e2341 > _e2345) {
                                phi_3339_ = _e2341;
                            } else {
                                phi_3339_ = _e2345;
                            }
                            let _e2348 = phi_3339_;
                            let _e2351 = local_7.member[1u];
                            if (_e2351[0] < 0f) {
                                phi_3352_ = -(_e2351[0]);
                            } else {
                                phi_3352_ = _e2351[0];
                            }
                            let _e2358 = phi_3352_;
                            if (_e2351[1] < 0f) {
                                phi_3359_ = -(_e2351[1]);
                            } else {
                                phi_3359_ = _e2351[1];
                            }
                            let _e2362 = phi_3359_;
                            if (_e2358 > _e2362) {
                                phi_3364_ = _e2358;
                            } else {
                                phi_3364_ = _e2362;
                            }
                            let _e2365 = phi_3364_;
                            if (_e2351[2] < 0f) {
                                phi_3371_ = -(_e2351[2]);
                            } else {
                                phi_3371_ = _e2351[2];
                            }
                            let _e2369 = phi_3371_;
                            if (_e2365 > _e2369) {
                                phi_3376_ = _e2365;
                            } else {
                                phi_3376_ = _e2369;
                            }
                            let _e2372 = phi_3376_;
                            if (_e2348 > _e2372) {
                                phi_3381_ = _e2348;
                            } else {
                                phi_3381_ = _e2372;
                            }
                            let _e2375 = phi_3381_;
                            let _e2377 = local_7.member_3;
                            let _e2378 = (_e2375 + _e2377);
                            let _e2381 = local_7.member_1[0u];
                            if (_e2381[0] < 0f) {
                                phi_3398_ = -(_e2381[0]);
                            } else {
                                phi_3398_ = _e2381[0];
                            }
                            let _e2388 = phi_3398_;
                            if (_e2381[1] < 0f) {
                                phi_3405_ = -(_e2381[1]);
                            } else {
                                phi_3405_ = _e2381[1];
                            }
                            let _e2392 = phi_3405_;
                            if (_e2388 > _e2392) {
                                phi_3410_ = _e2388;
                            } else {
                                phi_3410_ = _e2392;
                            }
                            let _e2395 = phi_3410_;
                            if (_e2381[2] < 0f) {
                                phi_3417_ = -(_e2381[2]);
                            } else {
                                phi_3417_ = _e2381[2];
                            }
                            let _e2399 = phi_3417_;
                            if (_e2395 > _e2399) {
                                phi_3422_ = _e2395;
                            } else {
                                phi_3422_ = _e2399;
                            }
                            let _e2402 = phi_3422_;
                            let _e2405 = local_7.member_1[1u];
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
                            if (_e2402 > _e2426) {
                                phi_3465_ = _e2402;
                            } else {
                                phi_3465_ = _e2426;
                            }
                            let _e2429 = phi_3465_;
                            let _e2431 = local_7.member_3;
                            let _e2432 = (_e2429 + _e2431);
                            let _e2435 = local_7.member_2[0u];
                            if (_e2435[0] < 0f) {
                                phi_3482_ = -(_e2435[0]);
                            } else {
                                phi_3482_ = _e2435[0];
                            }
                            let _e2442 = phi_3482_;
                            if (_e2435[1] < 0f) {
                                phi_3489_ = -(_e2435[1]);
                            } else {
                                phi_3489_ = _e2435[1];
                            }
                            let _e2446 = phi_3489_;
                            if (_e2442 > _e2446) {
                                phi_3494_ = _e2442;
                            } else {
                                phi_3494_ = _e2446;
                            }
                            let _e2449 = phi_3494_;
                            if (_e2435[2] < 0f) {
                                phi_3501_ = -(_e2435[2]);
                            } else {
                                phi_3501_ = _e2435[2];
                            }
                            let _e2453 = phi_3501_;
                            if (_e2449 > _e2453) {
                                phi_3506_ = _e2449;
                            } else {
                                phi_3506_ = _e2453;
                            }
                            let _e2456 = phi_3506_;
                            let _e2459 = local_7.member_2[1u];
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
                            if (_e2456 > _e2480) {
                                phi_3549_ = _e2456;
                            } else {
                                phi_3549_ = _e2480;
                            }
                            let _e2483 = phi_3549_;
                            let _e2485 = local_7.member_3;
                            let _e2486 = (_e2483 + _e2485);
                            let _e2488 = ((_e2432 * 8f) * _e2486);
                            let _e2495 = local_7.member_3;
                            if (_e2184 < 0f) {
                                phi_3580_ = -(_e2184);
                            } else {
                                phi_3580_ = _e2184;
                            }
                            let _e2512 = phi_3580_;
                            if (_e2187 < 0f) {
                                phi_3586_ = -(_e2187);
                            } else {
                                phi_3586_ = _e2187;
                            }
                            let _e2516 = phi_3586_;
                            if (_e2190 < 0f) {
                                phi_3593_ = -(_e2190);
                            } else {
                                phi_3593_ = _e2190;
                            }
                            let _e2521 = phi_3593_;
                            let _e2522 = ((_e2512 + _e2516) + _e2521);
                            if (_e2205 < 0f) {
                                phi_3600_ = -(_e2205);
                            } else {
                                phi_3600_ = _e2205;
                            }
                            let _e2526 = phi_3600_;
                            if (_e2208 < 0f) {
                                phi_3606_ = -(_e2208);
                            } else {
                                phi_3606_ = _e2208;
                            }
                            let _e2530 = phi_3606_;
                            if (_e2211 < 0f) {
                                phi_3613_ = -(_e2211);
                            } else {
                                phi_3613_ = _e2211;
                            }
                            let _e2535 = phi_3613_;
                            let _e2536 = ((_e2526 + _e2530) + _e2535);
                            if (_e2522 > _e2536) {
                                phi_3619_ = _e2522;
                            } else {
                                phi_3619_ = _e2536;
                            }
                            let _e2539 = phi_3619_;
                            if (_e2254 < 0f) {
                                phi_3625_ = -(_e2254);
                            } else {
                                phi_3625_ = _e2254;
                            }
                            let _e2543 = phi_3625_;
                            if (_e2255 < 0f) {
                                phi_3631_ = -(_e2255);
                            } else {
                                phi_3631_ = _e2255;
                            }
                            let _e2547 = phi_3631_;
                            if (_e2256 < 0f) {
                                phi_3638_ = -(_e2256);
                            } else {
                                phi_3638_ = _e2256;
                            }
                            let _e2552 = phi_3638_;
                            let _e2554 = (((_e2543 + _e2547) + _e2552) * 0.5f);
                            if (_e2539 > _e2554) {
                                phi_3645_ = _e2539;
                            } else {
                                phi_3645_ = _e2554;
                            }
                            let _e2557 = phi_3645_;
                            let _e2562 = local_7.member_3;
                            let _e2575 = ((((_e2259[0] * _e2184) + (_e2259[1] * _e2187)) + (_e2259[2] * _e2190)) * 3f);
                            let _e2576 = ((((_e2316[0] * _e2205) + (_e2316[1] * _e2208)) + (_e2316[2] * _e2211)) * 3f);
                            if (_e2575 < _e2576) {
                                phi_3669_ = _e2575;
                            } else {
                                phi_3669_ = _e2576;
                            }
                            let _e2579 = phi_3669_;
                            if (_e2290 < _e2313) {
                                phi_3674_ = _e2290;
                            } else {
                                phi_3674_ = _e2313;
                            }
                            let _e2582 = phi_3674_;
                            if (_e2579 < _e2582) {
                                phi_3679_ = _e2579;
                            } else {
                                phi_3679_ = _e2582;
                            }
                            let _e2585 = phi_3679_;
                            if (_e2575 > _e2576) {
                                phi_3684_ = _e2575;
                            } else {
                                phi_3684_ = _e2576;
                            }
                            let _e2588 = phi_3684_;
                            if (_e2290 > _e2313) {
                                phi_3689_ = _e2290;
                            } else {
                                phi_3689_ = _e2313;
                            }
                            let _e2591 = phi_3689_;
                            if (_e2588 > _e2591) {
                                phi_3694_ = _e2588;
                            } else {
                                phi_3694_ = _e2591;
                            }
                            let _e2594 = phi_3694_;
                            let _e2599 = -(_e2594);
                            if (_e2585 > _e2599) {
                                phi_3704_ = _e2585;
                            } else {
                                phi_3704_ = _e2599;
                            }
                            let _e2602 = phi_3704_;
                            if ((_e2602 - ((((((_e2378 * 8f) * _e2488) * (0.000000059604645f * (490f / 64f))) + ((_e2495 * 19f) * ((_e2378 * (_e2432 + _e2486)) + (_e2432 * _e2486)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2378) * ((1f + _e2432) * (1f + _e2486))))) + ((_e2088 * (((_e2557 + (_e2488 * (0.000000059604645f * 4f))) + ((_e2562 * 6f) * (_e2432 + _e2486))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2432) * (1f + _e2486))))) * (3f * 1.0001f)))) > 0f) {
                                phi_4680_ = true;
                            } else {
                                let _e2607 = local_7.member_1[0u];
                                let _e2613 = local_7.member_1[1u];
                                let _e2617 = (_e2607[0] + _e2613[0]);
                                let _e2618 = (_e2607[1] + _e2613[1]);
                                let _e2619 = (_e2607[2] + _e2613[2]);
                                let _e2622 = local_7.member_2[0u];
                                let _e2628 = local_7.member_2[1u];
                                let _e2632 = (_e2622[0] + _e2628[0]);
                                let _e2633 = (_e2622[1] + _e2628[1]);
                                let _e2634 = (_e2622[2] + _e2628[2]);
                                let _e2637 = ((_e2618 * _e2634) - (_e2619 * _e2633));
                                let _e2640 = ((_e2619 * _e2632) - (_e2617 * _e2634));
                                let _e2643 = ((_e2617 * _e2633) - (_e2618 * _e2632));
                                let _e2646 = local_7.member[0u];
                                let _e2652 = local_7.member_1[0u];
                                let _e2658 = local_7.member_2[0u];
                                let _e2670 = local_7.member[1u];
                                let _e2676 = local_7.member_1[1u];
                                let _e2682 = local_7.member_2[1u];
                                local_5 = array<array<f32, 3>, 4>(_e2646, array<f32, 3>((_e2646[0] - _e2652[0]), (_e2646[1] - _e2652[1]), (_e2646[2] - _e2652[2])), array<f32, 3>((_e2646[0] - _e2658[0]), (_e2646[1] - _e2658[1]), (_e2646[2] - _e2658[2])), _e2646);
                                local_6 = array<array<f32, 3>, 4>(_e2670, array<f32, 3>((_e2670[0] - _e2676[0]), (_e2670[1] - _e2676[1]), (_e2670[2] - _e2676[2])), array<f32, 3>((_e2670[0] - _e2682[0]), (_e2670[1] - _e2682[1]), (_e2670[2] - _e2682[2])), _e2670);
                                let _e2700 = local_7.member[0u];
                                if (_e2700[0] < 0f) {
                                    phi_3955_ = -(_e2700[0]);
                                } else {
                                    phi_3955_ = _e2700[0];
                                }
                                let _e2707 = phi_3955_;
                                if (_e2700[1] < 0f) {
                                    phi_3962_ = -(_e2700[1]);
                                } else {
                                    phi_3962_ = _e2700[1];
                                }
                                let _e2711 = phi_3962_;
                                if (_e2707 > _e2711) {
                                    phi_3967_ = _e2707;
                                } else {
                                    phi_3967_ = _e2711;
                                }
                                let _e2714 = phi_3967_;
                                if (_e2700[2] < 0f) {
                                    phi_3974_ = -(_e2700[2]);
                                } else {
                                    phi_3974_ = _e2700[2];
                                }
                                let _e2718 = phi_3974_;
                                if (_e2714 > _e2718) {
                                    phi_3979_ = _e2714;
                                } else {
                                    phi_3979_ = _e2718;
                                }
                                let _e2721 = phi_3979_;
                                let _e2724 = local_7.member[1u];
                                if (_e2724[0] < 0f) {
                                    phi_3992_ = -(_e2724[0]);
                                } else {
                                    phi_3992_ = _e2724[0];
                                }
                                let _e2731 = phi_3992_;
                                if (_e2724[1] < 0f) {
                                    phi_3999_ = -(_e2724[1]);
                                } else {
                                    phi_3999_ = _e2724[1];
                                }
                                let _e2735 = phi_3999_;
                                if (_e2731 > _e2735) {
                                    phi_4004_ = _e2731;
                                } else {
                                    phi_4004_ = _e2735;
                                }
                                let _e2738 = phi_4004_;
                                if (_e2724[2] < 0f) {
                                    phi_4011_ = -(_e2724[2]);
                                } else {
                                    phi_4011_ = _e2724[2];
                                }
                                let _e2742 = phi_4011_;
                                if (_e2738 > _e2742) {
                                    phi_4016_ = _e2738;
                                } else {
                                    phi_4016_ = _e2742;
                                }
                                let _e2745 = phi_4016_;
                                if (_e2721 > _e2745) {
                                    phi_4021_ = _e2721;
                                } else {
                                    phi_4021_ = _e2745;
                                }
                                let _e2748 = phi_4021_;
                                let _e2750 = local_7.member_3;
                                let _e2754 = local_7.member_1[0u];
                                if (_e2754[0] < 0f) {
                                    phi_4038_ = -(_e2754[0]);
                                } else {
                                    phi_4038_ = _e2754[0];
                                }
                                let _e2761 = phi_4038_;
                                if (_e2754[1] < 0f) {
                                    phi_4045_ = -(_e2754[1]);
                                } else {
                                    phi_4045_ = _e2754[1];
                                }
                                let _e2765 = phi_4045_;
                                if (_e2761 > _e2765) {
                                    phi_4050_ = _e2761;
                                } else {
                                    phi_4050_ = _e2765;
                                }
                                let _e2768 = phi_4050_;
                                if (_e2754[2] < 0f) {
                                    phi_4057_ = -(_e2754[2]);
                                } else {
                                    phi_4057_ = _e2754[2];
                                }
                                let _e2772 = phi_4057_;
                                if (_e2768 > _e2772) {
                                    phi_4062_ = _e2768;
                                } else {
                                    phi_4062_ = _e2772;
                                }
                                let _e2775 = phi_4062_;
                                let _e2778 = local_7.member_1[1u];
                                if (_e2778[0] < 0f) {
                                    phi_4076_ = -(_e2778[0]);
                                } else {
                                    phi_4076_ = _e2778[0];
                                }
                                let _e2785 = phi_4076_;
                                if (_e2778[1] < 0f) {
                                    phi_4083_ = -(_e2778[1]);
                                } else {
                                    phi_4083_ = _e2778[1];
                                }
                                let _e2789 = phi_4083_;
                                if (_e2785 > _e2789) {
                                    phi_4088_ = _e2785;
                                } else {
                                    phi_4088_ = _e2789;
                                }
                                let _e2792 = phi_4088_;
                                if (_e2778[2] < 0f) {
                                    phi_4095_ = -(_e2778[2]);
                                } else {
                                    phi_4095_ = _e2778[2];
                                }
                                let _e2796 = phi_4095_;
                                if (_e2792 > _e2796) {
                                    phi_4100_ = _e2792;
                                } else {
                                    phi_4100_ = _e2796;
                                }
                                let _e2799 = phi_4100_;
                                if (_e2775 > _e2799) {
                                    phi_4105_ = _e2775;
                                } else {
                                    phi_4105_ = _e2799;
                                }
                                let _e2802 = phi_4105_;
                                let _e2804 = local_7.member_3;
                                let _e2808 = local_7.member_2[0u];
                                if (_e2808[0] < 0f) {
                                    phi_4122_ = -(_e2808[0]);
                                } else {
                                    phi_4122_ = _e2808[0];
                                }
                                let _e2815 = phi_4122_;
                                if (_e2808[1] < 0f) {
                                    phi_4129_ = -(_e2808[1]);
                                } else {
                                    phi_4129_ = _e2808[1];
                                }
                                let _e2819 = phi_4129_;
                                if (_e2815 > _e2819) {
                                    phi_4134_ = _e2815;
                                } else {
                                    phi_4134_ = _e2819;
                                }
                                let _e2822 = phi_4134_;
                                if (_e2808[2] < 0f) {
                                    phi_4141_ = -(_e2808[2]);
                                } else {
                                    phi_4141_ = _e2808[2];
                                }
                                let _e2826 = phi_4141_;
                                if (_e2822 > _e2826) {
                                    phi_4146_ = _e2822;
                                } else {
                                    phi_4146_ = _e2826;
                                }
                                let _e2829 = phi_4146_;
                                let _e2832 = local_7.member_2[1u];
                                if (_e2832[0] < 0f) {
                                    phi_4160_ = -(_e2832[0]);
                                } else {
                                    phi_4160_ = _e2832[0];
                                }
                                let _e2839 = phi_4160_;
                                if (_e2832[1] < 0f) {
                                    phi_4167_ = -(_e2832[1]);
                                } else {
                                    phi_4167_ = _e2832[1];
                                }
                                let _e2843 = phi_4167_;
                                if (_e2839 > _e2843) {
                                    phi_4172_ = _e2839;
                                } else {
                                    phi_4172_ = _e2843;
                                }
                                let _e2846 = phi_4172_;
                                if (_e2832[2] < 0f) {
                                    phi_4179_ = -(_e2832[2]);
                                } else {
                                    phi_4179_ = _e2832[2];
                                }
                                let _e2850 = phi_4179_;
                                if (_e2846 > _e2850) {
                                    phi_4184_ = _e2846;
                                } else {
                                    phi_4184_ = _e2850;
                                }
                                let _e2853 = phi_4184_;
                                if (_e2829 > _e2853) {
                                    phi_4189_ = _e2829;
                                } else {
                                    phi_4189_ = _e2853;
                                }
                                let _e2856 = phi_4189_;
                                let _e2858 = local_7.member_3;
                                let _e2861 = (((_e2748 + _e2750) + (_e2802 + _e2804)) + (_e2856 + _e2858));
                                let _e2864 = local_7.member_3;
                                let _e2868 = (((_e2088 * 1.0001f) + (_e2864 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2871 = ((_e2640 * _e2619) - (_e2643 * _e2618));
                                let _e2874 = ((_e2643 * _e2617) - (_e2637 * _e2619));
                                let _e2877 = ((_e2637 * _e2618) - (_e2640 * _e2617));
                                let _e2879 = local_5[0u];
                                let _e2887 = (((_e2871 * _e2879[0]) + (_e2874 * _e2879[1])) + (_e2877 * _e2879[2]));
                                phi_4227_ = type_36(0u, 4u);
                                phi_4230_ = _e2887;
                                phi_4232_ = _e2887;
                                loop {
                                    let _e2889 = phi_4227_;
                                    let _e2891 = phi_4230_;
                                    let _e2893 = phi_4232_;
                                    local_52 = _e2891;
                                    local_53 = _e2893;
                                    local_73 = _e2893;
                                    if (_e2889.member < _e2889.member_1) {
                                        phi_4228_ = type_36((_e2889.member + 1u), _e2889.member_1);
                                        phi_4255_ = type_36(1u, _e2889.member);
                                    } else {
                                        phi_4228_ = _e2889;
                                        phi_4255_ = type_36(0u, type_36().member_1);
                                    }
                                    let _e2907 = phi_4228_;
                                    let _e2909 = phi_4255_;
                                    let _e2913 = (bitcast<i32>(_e2909.member) != 0i);
                                    if _e2913 {
                                        if (_e2909.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2916 = local_5[_e2909.member_1];
                                        let _e2924 = (((_e2871 * _e2916[0]) + (_e2874 * _e2916[1])) + (_e2877 * _e2916[2]));
                                        if (_e2909.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2927 = local_6[_e2909.member_1];
                                        let _e2935 = (((_e2871 * _e2927[0]) + (_e2874 * _e2927[1])) + (_e2877 * _e2927[2]));
                                        if (_e2893 < _e2924) {
                                            phi_4305_ = _e2893;
                                        } else {
                                            phi_4305_ = _e2924;
                                        }
                                        let _e2938 = phi_4305_;
                                        if (_e2938 < _e2935) {
                                            phi_4310_ = _e2938;
                                        } else {
                                            phi_4310_ = _e2935;
                                        }
                                        let _e2941 = phi_4310_;
                                        if (_e2891 > _e2924) {
                                            phi_4315_ = _e2891;
                                        } else {
                                            phi_4315_ = _e2924;
                                        }
                                        let _e2944 = phi_4315_;
                                        if (_e2944 > _e2935) {
                                            phi_4320_ = _e2944;
                                        } else {
                                            phi_4320_ = _e2935;
                                        }
                                        let _e2947 = phi_4320_;
                                        phi_4231_ = _e2947;
                                        phi_4233_ = _e2941;
                                    } else {
                                        phi_4231_ = f32();
                                        phi_4233_ = f32();
                                    }
                                    let _e2949 = phi_4231_;
                                    let _e2951 = phi_4233_;
                                    continue;
                                    continuing {
                                        phi_4227_ = _e2907;
                                        phi_4230_ = _e2949;
                                        phi_4232_ = _e2951;
                                        break if !(_e2913);
                                    }
                                }
                                if (_e2871 < 0f) {
                                    phi_4326_ = -(_e2871);
                                } else {
                                    phi_4326_ = _e2871;
                                }
                                let _e2956 = phi_4326_;
                                if (_e2874 < 0f) {
                                    phi_4332_ = -(_e2874);
                                } else {
                                    phi_4332_ = _e2874;
                                }
                                let _e2960 = phi_4332_;
                                if (_e2877 < 0f) {
                                    phi_4339_ = -(_e2877);
                                } else {
                                    phi_4339_ = _e2877;
                                }
                                let _e2965 = phi_4339_;
                                let _e2966 = ((_e2956 + _e2960) + _e2965);
                                let _e2971 = local_52;
                                let _e2972 = -(_e2971);
                                let _e2974 = local_53;
                                if (_e2974 > _e2972) {
                                    let _e5840 = local_73;
                                    phi_4349_ = _e5840;
                                } else {
                                    phi_4349_ = _e2972;
                                }
                                let _e2977 = phi_4349_;
                                let _e2982 = (((_e2977 - ((_e2966 * _e2861) * (0.000000059604645f * 17f))) - (_e2966 * _e2868)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2985 = ((_e2640 * _e2634) - (_e2643 * _e2633));
                                let _e2988 = ((_e2643 * _e2632) - (_e2637 * _e2634));
                                let _e2991 = ((_e2637 * _e2633) - (_e2640 * _e2632));
                                let _e2993 = local_5[0u];
                                let _e3001 = (((_e2985 * _e2993[0]) + (_e2988 * _e2993[1])) + (_e2991 * _e2993[2]));
                                phi_4380_ = type_36(0u, 4u);
                                phi_4383_ = _e3001;
                                phi_4385_ = _e3001;
                                loop {
                                    let _e3003 = phi_4380_;
                                    let _e3005 = phi_4383_;
                                    let _e3007 = phi_4385_;
                                    local_54 = _e3005;
                                    local_55 = _e3007;
                                    local_74 = _e3007;
                                    if (_e3003.member < _e3003.member_1) {
                                        phi_4381_ = type_36((_e3003.member + 1u), _e3003.member_1);
                                        phi_4408_ = type_36(1u, _e3003.member);
                                    } else {
                                        phi_4381_ = _e3003;
                                        phi_4408_ = type_36(0u, type_36().member_1);
                                    }
                                    let _e3021 = phi_4381_;
                                    let _e3023 = phi_4408_;
                                    let _e3027 = (bitcast<i32>(_e3023.member) != 0i);
                                    if _e3027 {
                                        if (_e3023.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e3030 = local_5[_e3023.member_1];
                                        let _e3038 = (((_e2985 * _e3030[0]) + (_e2988 * _e3030[1])) + (_e2991 * _e3030[2]));
                                        if (_e3023.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e3041 = local_6[_e3023.member_1];
                                        let _e3049 = (((_e2985 * _e3041[0]) + (_e2988 * _e3041[1])) + (_e2991 * _e3041[2]));
                                        if (_e3007 < _e3038) {
                                            phi_4458_ = _e3007;
                                        } else {
                                            phi_4458_ = _e3038;
                                        }
                                        let _e3052 = phi_4458_;
                                        if (_e3052 < _e3049) {
                                            phi_4463_ = _e3052;
                                        } else {
                                            phi_4463_ = _e3049;
                                        }
                                        let _e3055 = phi_4463_;
                                        if (_e3005 > _e3038) {
                                            phi_4468_ = _e3005;
                                        } else {
                                            phi_4468_ = _e3038;
                                        }
                                        let _e3058 = phi_4468_;
                                        if (_e3058 > _e3049) {
                                            phi_4473_ = _e3058;
                                        } else {
                                            phi_4473_ = _e3049;
                                        }
                                        let _e3061 = phi_4473_;
                                        phi_4384_ = _e3061;
                                        phi_4386_ = _e3055;
                                    } else {
                                        phi_4384_ = f32();
                                        phi_4386_ = f32();
                                    }
                                    let _e3063 = phi_4384_;
                                    let _e3065 = phi_4386_;
                                    continue;
                                    continuing {
                                        phi_4380_ = _e3021;
                                        phi_4383_ = _e3063;
                                        phi_4385_ = _e3065;
                                        break if !(_e3027);
                                    }
                                }
                                if (_e2985 < 0f) {
                                    phi_4479_ = -(_e2985);
                                } else {
                                    phi_4479_ = _e2985;
                                }
                                let _e3070 = phi_4479_;
                                if (_e2988 < 0f) {
                                    phi_4485_ = -(_e2988);
                                } else {
                                    phi_4485_ = _e2988;
                                }
                                let _e3074 = phi_4485_;
                                if (_e2991 < 0f) {
                                    phi_4492_ = -(_e2991);
                                } else {
                                    phi_4492_ = _e2991;
                                }
                                let _e3079 = phi_4492_;
                                let _e3080 = ((_e3070 + _e3074) + _e3079);
                                let _e3085 = local_54;
                                let _e3086 = -(_e3085);
                                let _e3088 = local_55;
                                if (_e3088 > _e3086) {
                                    let _e5859 = local_74;
                                    phi_4502_ = _e5859;
                                } else {
                                    phi_4502_ = _e3086;
                                }
                                let _e3091 = phi_4502_;
                                let _e3096 = (((_e3091 - ((_e3080 * _e2861) * (0.000000059604645f * 17f))) - (_e3080 * _e2868)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2982 > _e3096) {
                                    phi_4512_ = _e2982;
                                } else {
                                    phi_4512_ = _e3096;
                                }
                                let _e3099 = phi_4512_;
                                let _e3100 = (_e2632 - _e2617);
                                let _e3101 = (_e2633 - _e2618);
                                let _e3102 = (_e2634 - _e2619);
                                let _e3105 = ((_e2640 * _e3102) - (_e2643 * _e3101));
                                let _e3108 = ((_e2643 * _e3100) - (_e2637 * _e3102));
                                let _e3111 = ((_e2637 * _e3101) - (_e2640 * _e3100));
                                let _e3113 = local_5[0u];
                                let _e3121 = (((_e3105 * _e3113[0]) + (_e3108 * _e3113[1])) + (_e3111 * _e3113[2]));
                                phi_4545_ = type_36(0u, 4u);
                                phi_4548_ = _e3121;
                                phi_4550_ = _e3121;
                                loop {
                                    let _e3123 = phi_4545_;
                                    let _e3125 = phi_4548_;
                                    let _e3127 = phi_4550_;
                                    local_56 = _e3125;
                                    local_57 = _e3127;
                                    local_75 = _e3127;
                                    if (_e3123.member < _e3123.member_1) {
                                        phi_4546_ = type_36((_e3123.member + 1u), _e3123.member_1);
                                        phi_4573_ = type_36(1u, _e3123.member);
                                    } else {
                                        phi_4546_ = _e3123;
                                        phi_4573_ = type_36(0u, type_36().member_1);
                                    }
                                    let _e3141 = phi_4546_;
                                    let _e3143 = phi_4573_;
                                    let _e3147 = (bitcast<i32>(_e3143.member) != 0i);
                                    if _e3147 {
                                        if (_e3143.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e3150 = local_5[_e3143.member_1];
                                        let _e3158 = (((_e3105 * _e3150[0]) + (_e3108 * _e3150[1])) + (_e3111 * _e3150[2]));
                                        if (_e3143.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e3161 = local_6[_e3143.member_1];
                                        let _e3169 = (((_e3105 * _e3161[0]) + (_e3108 * _e3161[1])) + (_e3111 * _e3161[2]));
                                        if (_e3127 < _e3158) {
                                            phi_4623_ = _e3127;
                                        } else {
                                            phi_4623_ = _e3158;
                                        }
                                        let _e3172 = phi_4623_;
                                        if (_e3172 < _e3169) {
                                            phi_4628_ = _e3172;
                                        } else {
                                            phi_4628_ = _e3169;
                                        }
                                        let _e3175 = phi_4628_;
                                        if (_e3125 > _e3158) {
                                            phi_4633_ = _e3125;
                                        } else {
                                            phi_4633_ = _e3158;
                                        }
                                        let _e3178 = phi_4633_;
                                        if (_e3178 > _e3169) {
                                            phi_4638_ = _e3178;
                                        } else {
                                            phi_4638_ = _e3169;
                                        }
                                        let _e3181 = phi_4638_;
                                        phi_4549_ = _e3181;
                                        phi_4551_ = _e3175;
                                    } else {
                                        phi_4549_ = f32();
                                        phi_4551_ = f32();
                                    }
                                    let _e3183 = phi_4549_;
                                    let _e3185 = phi_4551_;
                                    continue;
                                    continuing {
                                        phi_4545_ = _e3141;
                                        phi_4548_ = _e3183;
                                        phi_4550_ = _e3185;
                                        break if !(_e3147);
                                    }
                                }
                                if (_e3105 < 0f) {
                                    phi_4644_ = -(_e3105);
                                } else {
                                    phi_4644_ = _e3105;
                                }
                                let _e3190 = phi_4644_;
                                if (_e3108 < 0f) {
                                    phi_4650_ = -(_e3108);
                                } else {
                                    phi_4650_ = _e3108;
                                }
                                let _e3194 = phi_4650_;
                                if (_e3111 < 0f) {
                                    phi_4657_ = -(_e3111);
                                } else {
                                    phi_4657_ = _e3111;
                                }
                                let _e3199 = phi_4657_;
                                let _e3200 = ((_e3190 + _e3194) + _e3199);
                                let _e3205 = local_56;
                                let _e3206 = -(_e3205);
                                let _e3208 = local_57;
                                if (_e3208 > _e3206) {
                                    let _e5879 = local_75;
                                    phi_4667_ = _e5879;
                                } else {
                                    phi_4667_ = _e3206;
                                }
                                let _e3211 = phi_4667_;
                                let _e3216 = (((_e3211 - ((_e3200 * _e2861) * (0.000000059604645f * 17f))) - (_e3200 * _e2868)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e3099 > _e3216) {
                                    phi_4677_ = _e3099;
                                } else {
                                    phi_4677_ = _e3216;
                                }
                                let _e3219 = phi_4677_;
                                phi_4680_ = (_e3219 > 0f);
                            }
                            let _e3222 = phi_4680_;
                            if _e3222 {
                                phi_8116_ = false;
                            } else {
                                let _e3225 = local_7.member[0u];
                                let _e3231 = local_7.member[1u];
                                let _e3238 = ((_e3225[0] + _e3231[0]) * 0.5f);
                                let _e3239 = ((_e3225[1] + _e3231[1]) * 0.5f);
                                let _e3240 = ((_e3225[2] + _e3231[2]) * 0.5f);
                                let _e3243 = local_7.member_1[0u];
                                let _e3249 = local_7.member_1[1u];
                                let _e3256 = ((_e3243[0] + _e3249[0]) * 0.5f);
                                let _e3257 = ((_e3243[1] + _e3249[1]) * 0.5f);
                                let _e3258 = ((_e3243[2] + _e3249[2]) * 0.5f);
                                let _e3261 = local_7.member_2[0u];
                                let _e3267 = local_7.member_2[1u];
                                let _e3274 = ((_e3261[0] + _e3267[0]) * 0.5f);
                                let _e3275 = ((_e3261[1] + _e3267[1]) * 0.5f);
                                let _e3276 = ((_e3261[2] + _e3267[2]) * 0.5f);
                                let _e3279 = local_7.member[0u];
                                let _e3282 = local_7.member_1[0u];
                                let _e3285 = local_7.member_2[0u];
                                let _e3287 = local_7.member_3;
                                let _e3290 = local_7.member[1u];
                                let _e3293 = local_7.member_1[1u];
                                let _e3296 = local_7.member_2[1u];
                                let _e3298 = local_7.member_3;
                                local_4 = array<type_71, 2>(type_71(array<array<f32, 3>, 2>(_e3279, array<f32, 3>(_e3238, _e3239, _e3240)), array<array<f32, 3>, 2>(_e3282, array<f32, 3>(_e3256, _e3257, _e3258)), array<array<f32, 3>, 2>(_e3285, array<f32, 3>(_e3274, _e3275, _e3276)), _e3287), type_71(array<array<f32, 3>, 2>(array<f32, 3>(_e3238, _e3239, _e3240), _e3290), array<array<f32, 3>, 2>(array<f32, 3>(_e3256, _e3257, _e3258), _e3293), array<array<f32, 3>, 2>(array<f32, 3>(_e3274, _e3275, _e3276), _e3296), _e3298));
                                let _e3317 = local_4[0u].member_1[0u];
                                let _e3323 = local_4[0u].member_2[0u];
                                let _e3329 = ((_e3317[1] * _e3323[2]) - (_e3317[2] * _e3323[1]));
                                let _e3332 = ((_e3317[2] * _e3323[0]) - (_e3317[0] * _e3323[2]));
                                let _e3335 = ((_e3317[0] * _e3323[1]) - (_e3317[1] * _e3323[0]));
                                let _e3338 = local_4[0u].member_1[1u];
                                let _e3344 = local_4[0u].member_2[1u];
                                let _e3350 = ((_e3338[1] * _e3344[2]) - (_e3338[2] * _e3344[1]));
                                let _e3353 = ((_e3338[2] * _e3344[0]) - (_e3338[0] * _e3344[2]));
                                let _e3356 = ((_e3338[0] * _e3344[1]) - (_e3338[1] * _e3344[0]));
                                let _e3359 = local_4[0u].member_1[0u];
                                let _e3365 = local_4[0u].member_2[1u];
                                let _e3380 = local_4[0u].member_1[1u];
                                let _e3386 = local_4[0u].member_2[0u];
                                let _e3399 = (((_e3359[1] * _e3365[2]) - (_e3359[2] * _e3365[1])) + ((_e3380[1] * _e3386[2]) - (_e3380[2] * _e3386[1])));
                                let _e3400 = (((_e3359[2] * _e3365[0]) - (_e3359[0] * _e3365[2])) + ((_e3380[2] * _e3386[0]) - (_e3380[0] * _e3386[2])));
                                let _e3401 = (((_e3359[0] * _e3365[1]) - (_e3359[1] * _e3365[0])) + ((_e3380[0] * _e3386[1]) - (_e3380[1] * _e3386[0])));
                                let _e3404 = local_4[0u].member[0u];
                                let _e3415 = local_4[0u].member[1u];
                                let _e3426 = local_4[0u].member[0u];
                                let _e3435 = ((((_e3415[0] * _e3329) + (_e3415[1] * _e3332)) + (_e3415[2] * _e3335)) + (((_e3426[0] * _e3399) + (_e3426[1] * _e3400)) + (_e3426[2] * _e3401)));
                                let _e3438 = local_4[0u].member[0u];
                                let _e3449 = local_4[0u].member[1u];
                                let _e3458 = ((((_e3438[0] * _e3350) + (_e3438[1] * _e3353)) + (_e3438[2] * _e3356)) + (((_e3449[0] * _e3399) + (_e3449[1] * _e3400)) + (_e3449[2] * _e3401)));
                                let _e3461 = local_4[0u].member[1u];
                                let _e3472 = local_4[0u].member[0u];
                                if (_e3472[0] < 0f) {
                                    phi_5137_ = -(_e3472[0]);
                                } else {
                                    phi_5137_ = _e3472[0];
                                }
                                let _e3479 = phi_5137_;
                                if (_e3472[1] < 0f) {
                                    phi_5144_ = -(_e3472[1]);
                                } else {
                                    phi_5144_ = _e3472[1];
                                }
                                let _e3483 = phi_5144_;
                                if (_e3479 > _e3483) {
                                    phi_5149_ = _e3479;
                                } else {
                                    phi_5149_ = _e3483;
                                }
                                let _e3486 = phi_5149_;
                                if (_e3472[2] < 0f) {
                                    phi_5156_ = -(_e3472[2]);
                                } else {
                                    phi_5156_ = _e3472[2];
                                }
                                let _e3490 = phi_5156_;
                                if (_e3486 > _e3490) {
                                    phi_5161_ = _e3486;
                                } else {
                                    phi_5161_ = _e3490;
                                }
                                let _e3493 = phi_5161_;
                                let _e3496 = local_4[0u].member[1u];
                                if (_e3496[0] < 0f) {
                                    phi_5174_ = -(_e3496[0]);
                                } else {
                                    phi_5174_ = _e3496[0];
                                }
                                let _e3503 = phi_5174_;
                                if (_e3496[1] < 0f) {
                                    phi_5181_ = -(_e3496[1]);
                                } else {
                                    phi_5181_ = _e3496[1];
                                }
                                let _e3507 = phi_5181_;
                                if (_e3503 > _e3507) {
                                    phi_5186_ = _e3503;
                                } else {
                                    phi_5186_ = _e3507;
                                }
                                let _e3510 = phi_5186_;
                                if (_e3496[2] < 0f) {
                                    phi_5193_ = -(_e3496[2]);
                                } else {
                                    phi_5193_ = _e3496[2];
                                }
                                let _e3514 = phi_5193_;
                                if (_e3510 > _e3514) {
                                    phi_5198_ = _e3510;
                                } else {
                                    phi_5198_ = _e3514;
                                }
                                let _e3517 = phi_5198_;
                                if (_e3493 > _e3517) {
                                    phi_5203_ = _e3493;
                                } else {
                                    phi_5203_ = _e3517;
                                }
                                let _e3520 = phi_5203_;
                                let _e3522 = local_4[0u].member_3;
                                let _e3523 = (_e3520 + _e3522);
                                let _e3526 = local_4[0u].member_1[0u];
                                if (_e3526[0] < 0f) {
                                    phi_5220_ = -(_e3526[0]);
                                } else {
                                    phi_5220_ = _e3526[0];
                                }
                                let _e3533 = phi_5220_;
                                if (_e3526[1] < 0f) {
                                    phi_5227_ = -(_e3526[1]);
                                } else {
                                    phi_5227_ = _e3526[1];
                                }
                                let _e3537 = phi_5227_;
                                if (_e3533 > _e3537) {
                                    phi_5232_ = _e3533;
                                } else {
                                    phi_5232_ = _e3537;
                                }
                                let _e3540 = phi_5232_;
                                if (_e3526[2] < 0f) {
                                    phi_5239_ = -(_e3526[2]);
                                } else {
                                    phi_5239_ = _e3526[2];
                                }
                                let _e3544 = phi_5239_;
                                if (_e3540 > _e3544) {
                                    phi_5244_ = _e3540;
                                } else {
                                    phi_5244_ = _e3544;
                                }
                                let _e3547 = phi_5244_;
                                let _e3550 = local_4[0u].member_1[1u];
                                if (_e3550[0] < 0f) {
                                    phi_5258_ = -(_e3550[0]);
                                } else {
                                    phi_5258_ = _e3550[0];
                                }
                                let _e3557 = phi_5258_;
                                if (_e3550[1] < 0f) {
                                    phi_5265_ = -(_e3550[1]);
                                } else {
                                    phi_5265_ = _e3550[1];
                                }
                                let _e3561 = phi_5265_;
                                if (_e3557 > _e3561) {
                                    phi_5270_ = _e3557;
                                } else {
                                    phi_5270_ = _e3561;
                                }
                                let _e3564 = phi_5270_;
                                if (_e3550[2] < 0f) {
                                    phi_5277_ = -(_e3550[2]);
                                } else {
                                    phi_5277_ = _e3550[2];
                                }
                                let _e3568 = phi_5277_;
                                if (_e3564 > _e3568) {
                                    phi_5282_ = _e3564;
                                } else {
                                    phi_5282_ = _e3568;
                                }
                                let _e3571 = phi_5282_;
                                if (_e3547 > _e3571) {
                                    phi_5287_ = _e3547;
                                } else {
                                    phi_5287_ = _e3571;
                                }
                                let _e3574 = phi_5287_;
                                let _e3576 = local_4[0u].member_3;
                                let _e3577 = (_e3574 + _e3576);
                                let _e3580 = local_4[0u].member_2[0u];
                                if (_e3580[0] < 0f) {
                                    phi_5304_ = -(_e3580[0]);
                                } else {
                                    phi_5304_ = _e3580[0];
                                }
                                let _e3587 = phi_5304_;
                                if (_e3580[1] < 0f) {
                                    phi_5311_ = -(_e3580[1]);
                                } else {
                                    phi_5311_ = _e3580[1];
                                }
                                let _e3591 = phi_5311_;
                                if (_e3587 > _e3591) {
                                    phi_5316_ = _e3587;
                                } else {
                                    phi_5316_ = _e3591;
                                }
                                let _e3594 = phi_5316_;
                                if (_e3580[2] < 0f) {
                                    phi_5323_ = -(_e3580[2]);
                                } else {
                                    phi_5323_ = _e3580[2];
                                }
                                let _e3598 = phi_5323_;
                                if (_e3594 > _e3598) {
                                    phi_5328_ = _e3594;
                                } else {
                                    phi_5328_ = _e3598;
                                }
                                let _e3601 = phi_5328_;
                                let _e3604 = local_4[0u].member_2[1u];
                                if (_e3604[0] < 0f) {
                                    phi_5342_ = -(_e3604[0]);
                                } else {
                                    phi_5342_ = _e3604[0];
                                }
                                let _e3611 = phi_5342_;
                                if (_e3604[1] < 0f) {
                                    phi_5349_ = -(_e3604[1]);
                                } else {
                                    phi_5349_ = _e3604[1];
                                }
                                let _e3615 = phi_5349_;
                                if (_e3611 > _e3615) {
                                    phi_5354_ = _e3611;
                                } else {
                                    phi_5354_ = _e3615;
                                }
                                let _e3618 = phi_5354_;
                                if (_e3604[2] < 0f) {
                                    phi_5361_ = -(_e3604[2]);
                                } else {
                                    phi_5361_ = _e3604[2];
                                }
                                let _e3622 = phi_5361_;
                                if (_e3618 > _e3622) {
                                    phi_5366_ = _e3618;
                                } else {
                                    phi_5366_ = _e3622;
                                }
                                let _e3625 = phi_5366_;
                                if (_e3601 > _e3625) {
                                    phi_5371_ = _e3601;
                                } else {
                                    phi_5371_ = _e3625;
                                }
                                let _e3628 = phi_5371_;
                                let _e3630 = local_4[0u].member_3;
                                let _e3631 = (_e3628 + _e3630);
                                let _e3633 = ((_e3577 * 8f) * _e3631);
                                let _e3640 = local_4[0u].member_3;
                                if (_e3329 < 0f) {
                                    phi_5402_ = -(_e3329);
                                } else {
                                    phi_5402_ = _e3329;
                                }
                                let _e3657 = phi_5402_;
                                if (_e3332 < 0f) {
                                    phi_5408_ = -(_e3332);
                                } else {
                                    phi_5408_ = _e3332;
                                }
                                let _e3661 = phi_5408_;
                                if (_e3335 < 0f) {
                                    phi_5415_ = -(_e3335);
                                } else {
                                    phi_5415_ = _e3335;
                                }
                                let _e3666 = phi_5415_;
                                let _e3667 = ((_e3657 + _e3661) + _e3666);
                                if (_e3350 < 0f) {
                                    phi_5422_ = -(_e3350);
                                } else {
                                    phi_5422_ = _e3350;
                                }
                                let _e3671 = phi_5422_;
                                if (_e3353 < 0f) {
                                    phi_5428_ = -(_e3353);
                                } else {
                                    phi_5428_ = _e3353;
                                }
                                let _e3675 = phi_5428_;
                                if (_e3356 < 0f) {
                                    phi_5435_ = -(_e3356);
                                } else {
                                    phi_5435_ = _e3356;
                                }
                                let _e3680 = phi_5435_;
                                let _e3681 = ((_e3671 + _e3675) + _e3680);
                                if (_e3667 > _e3681) {
                                    phi_5441_ = _e3667;
                                } else {
                                    phi_5441_ = _e3681;
                                }
                                let _e3684 = phi_5441_;
                                if (_e3399 < 0f) {
                                    phi_5447_ = -(_e3399);
                                } else {
                                    phi_5447_ = _e3399;
                                }
                                let _e3688 = phi_5447_;
                                if (_e3400 < 0f) {
                                    phi_5453_ = -(_e3400);
                                } else {
                                    phi_5453_ = _e3400;
                                }
                                let _e3692 = phi_5453_;
                                if (_e3401 < 0f) {
                                    phi_5460_ = -(_e3401);
                                } else {
                                    phi_5460_ = _e3401;
                                }
                                let _e3697 = phi_5460_;
                                let _e3699 = (((_e3688 + _e3692) + _e3697) * 0.5f);
                                if (_e3684 > _e3699) {
                                    phi_5467_ = _e3684;
                                } else {
                                    phi_5467_ = _e3699;
                                }
                                let _e3702 = phi_5467_;
                                let _e3707 = local_4[0u].member_3;
                                let _e3720 = ((((_e3404[0] * _e3329) + (_e3404[1] * _e3332)) + (_e3404[2] * _e3335)) * 3f);
                                let _e3721 = ((((_e3461[0] * _e3350) + (_e3461[1] * _e3353)) + (_e3461[2] * _e3356)) * 3f);
                                if (_e3720 < _e3721) {
                                    phi_5491_ = _e3720;
                                } else {
                                    phi_5491_ = _e3721;
                                }
                                let _e3724 = phi_5491_;
                                if (_e3435 < _e3458) {
                                    phi_5496_ = _e3435;
                                } else {
                                    phi_5496_ = _e3458;
                                }
                                let _e3727 = phi_5496_;
                                if (_e3724 < _e3727) {
                                    phi_5501_ = _e3724;
                                } else {
                                    phi_5501_ = _e3727;
                                }
                                let _e3730 = phi_5501_;
                                if (_e3720 > _e3721) {
                                    phi_5506_ = _e3720;
                                } else {
                                    phi_5506_ = _e3721;
                                }
                                let _e3733 = phi_5506_;
                                if (_e3435 > _e3458) {
                                    phi_5511_ = _e3435;
                                } else {
                                    phi_5511_ = _e3458;
                                }
                                let _e3736 = phi_5511_;
                                if (_e3733 > _e3736) {
                                    phi_5516_ = _e3733;
                                } else {
                                    phi_5516_ = _e3736;
                                }
                                let _e3739 = phi_5516_;
                                let _e3744 = -(_e3739);
                                if (_e3730 > _e3744) {
                                    phi_5526_ = _e3730;
                                } else {
                                    phi_5526_ = _e3744;
                                }
                                let _e3747 = phi_5526_;
                                if ((_e3747 - ((((((_e3523 * 8f) * _e3633) * (0.000000059604645f * (490f / 64f))) + ((_e3640 * 19f) * ((_e3523 * (_e3577 + _e3631)) + (_e3577 * _e3631)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3523) * ((1f + _e3577) * (1f + _e3631))))) + ((_e2088 * (((_e3702 + (_e3633 * (0.000000059604645f * 4f))) + ((_e3707 * 6f) * (_e3577 + _e3631))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3577) * (1f + _e3631))))) * (3f * 1.0001f)))) > 0f) {
                                    phi_6502_ = true;
                                } else {
                                    let _e3752 = local_4[0u].member_1[0u];
                                    let _e3758 = local_4[0u].member_1[1u];
                                    let _e3762 = (_e3752[0] + _e3758[0]);
                                    let _e3763 = (_e3752[1] + _e3758[1]);
                                    let _e3764 = (_e3752[2] + _e3758[2]);
                                    let _e3767 = local_4[0u].member_2[0u];
                                    let _e3773 = local_4[0u].member_2[1u];
                                    let _e3777 = (_e3767[0] + _e3773[0]);
                                    let _e3778 = (_e3767[1] + _e3773[1]);
                                    let _e3779 = (_e3767[2] + _e3773[2]);
                                    let _e3782 = ((_e3763 * _e3779) - (_e3764 * _e3778));
                                    let _e3785 = ((_e3764 * _e3777) - (_e3762 * _e3779));
                                    let _e3788 = ((_e3762 * _e3778) - (_e3763 * _e3777));
                                    let _e3791 = local_4[0u].member[0u];
                                    let _e3797 = local_4[0u].member_1[0u];
                                    let _e3803 = local_4[0u].member_2[0u];
                                    let _e3815 = local_4[0u].member[1u];
                                    let _e3821 = local_4[0u].member_1[1u];
                                    let _e3827 = local_4[0u].member_2[1u];
                                    local_2 = array<array<f32, 3>, 4>(_e3791, array<f32, 3>((_e3791[0] - _e3797[0]), (_e3791[1] - _e3797[1]), (_e3791[2] - _e3797[2])), array<f32, 3>((_e3791[0] - _e3803[0]), (_e3791[1] - _e3803[1]), (_e3791[2] - _e3803[2])), _e3791);
                                    local_3 = array<array<f32, 3>, 4>(_e3815, array<f32, 3>((_e3815[0] - _e3821[0]), (_e3815[1] - _e3821[1]), (_e3815[2] - _e3821[2])), array<f32, 3>((_e3815[0] - _e3827[0]), (_e3815[1] - _e3827[1]), (_e3815[2] - _e3827[2])), _e3815);
                                    let _e3845 = local_4[0u].member[0u];
                                    if (_e3845[0] < 0f) {
                                        phi_5777_ = -(_e3845[0]);
                                    } else {
                                        phi_5777_ = _e3845[0];
                                    }
                                    let _e3852 = phi_5777_;
                                    if (_e3845[1] < 0f) {
                                        phi_5784_ = -(_e3845[1]);
                                    } else {
                                        phi_5784_ = _e3845[1];
                                    }
                                    let _e3856 = phi_5784_;
                                    if (_e3852 > _e3856) {
                                        phi_5789_ = _e3852;
                                    } else {
                                        phi_5789_ = _e3856;
                                    }
                                    let _e3859 = phi_5789_;
                                    if (_e3845[2] < 0f) {
                                        phi_5796_ = -(_e3845[2]);
                                    } else {
                                        phi_5796_ = _e3845[2];
                                    }
                                    let _e3863 = phi_5796_;
                                    if (_e3859 > _e3863) {
                                        phi_5801_ = _e3859;
                                    } else {
                                        phi_5801_ = _e3863;
                                    }
                                    let _e3866 = phi_5801_;
                                    let _e3869 = local_4[0u].member[1u];
                                    if (_e3869[0] < 0f) {
                                        phi_5814_ = -(_e3869[0]);
                                    } else {
                                        phi_5814_ = _e3869[0];
                                    }
                                    let _e3876 = phi_5814_;
                                    if (_e3869[1] < 0f) {
                                        phi_5821_ = -(_e3869[1]);
                                    } else {
                                        phi_5821_ = _e3869[1];
                                    }
                                    let _e3880 = phi_5821_;
                                    if (_e3876 > _e3880) {
                                        phi_5826_ = _e3876;
                                    } else {
                                        phi_5826_ = _e3880;
                                    }
                                    let _e3883 = phi_5826_;
                                    if (_e3869[2] < 0f) {
                                        phi_5833_ = -(_e3869[2]);
                                    } else {
                                        phi_5833_ = _e3869[2];
                                    }
                                    let _e3887 = phi_5833_;
                                    if (_e3883 > _e3887) {
                                        phi_5838_ = _e3883;
                                    } else {
                                        phi_5838_ = _e3887;
                                    }
                                    let _e3890 = phi_5838_;
                                    if (_e3866 > _e3890) {
                                        phi_5843_ = _e3866;
                                    } else {
                                        phi_5843_ = _e3890;
                                    }
                                    let _e3893 = phi_5843_;
                                    let _e3895 = local_4[0u].member_3;
                                    let _e3899 = local_4[0u].member_1[0u];
                                    if (_e3899[0] < 0f) {
                                        phi_5860_ = -(_e3899[0]);
                                    } else {
                                        phi_5860_ = _e3899[0];
                                    }
                                    let _e3906 = phi_5860_;
                                    if (_e3899[1] < 0f) {
                                        phi_5867_ = -(_e3899[1]);
                                    } else {
                                        phi_5867_ = _e3899[1];
                                    }
                                    let _e3910 = phi_5867_;
                                    if (_e3906 > _e3910) {
                                        phi_5872_ = _e3906;
                                    } else {
                                        phi_5872_ = _e3910;
                                    }
                                    let _e3913 = phi_5872_;
                                    if (_e3899[2] < 0f) {
                                        phi_5879_ = -(_e3899[2]);
                                    } else {
                                        phi_5879_ = _e3899[2];
                                    }
                                    let _e3917 = phi_5879_;
                                    if (_e3913 > _e3917) {
                                        phi_5884_ = _e3913;
                                    } else {
                                        phi_5884_ = _e3917;
                                    }
                                    let _e3920 = phi_5884_;
                                    let _e3923 = local_4[0u].member_1[1u];
                                    if (_e3923[0] < 0f) {
                                        phi_5898_ = -(_e3923[0]);
                                    } else {
                                        phi_5898_ = _e3923[0];
                                    }
                                    let _e3930 = phi_5898_;
                                    if (_e3923[1] < 0f) {
                                        phi_5905_ = -(_e3923[1]);
                                    } else {
                                        phi_5905_ = _e3923[1];
                                    }
                                    let _e3934 = phi_5905_;
                                    if (_e3930 > _e3934) {
                                        phi_5910_ = _e3930;
                                    } else {
                                        phi_5910_ = _e3934;
                                    }
                                    let _e3937 = phi_5910_;
                                    if (_e3923[2] < 0f) {
                                        phi_5917_ = -(_e3923[2]);
                                    } else {
                                        phi_5917_ = _e3923[2];
                                    }
                                    let _e3941 = phi_5917_;
                                    if (_e3937 > _e3941) {
                                        phi_5922_ = _e3937;
                                    } else {
                                        phi_5922_ = _e3941;
                                    }
                                    let _e3944 = phi_5922_;
                                    if (_e3920 > _e3944) {
                                        phi_5927_ = _e3920;
                                    } else {
                                        phi_5927_ = _e3944;
                                    }
                                    let _e3947 = phi_5927_;
                                    let _e3949 = local_4[0u].member_3;
                                    let _e3953 = local_4[0u].member_2[0u];
                                    if (_e3953[0] < 0f) {
                                        phi_5944_ = -(_e3953[0]);
                                    } else {
                                        phi_5944_ = _e3953[0];
                                    }
                                    let _e3960 = phi_5944_;
                                    if (_e3953[1] < 0f) {
                                        phi_5951_ = -(_e3953[1]);
                                    } else {
                                        phi_5951_ = _e3953[1];
                                    }
                                    let _e3964 = phi_5951_;
                                    if (_e3960 > _e3964) {
                                        phi_5956_ = _e3960;
                                    } else {
                                        phi_5956_ = _e3964;
                                    }
                                    let _e3967 = phi_5956_;
                                    if (_e3953[2] < 0f) {
                                        phi_5963_ = -(_e3953[2]);
                                    } else {
                                        phi_5963_ = _e3953[2];
                                    }
                                    let _e3971 = phi_5963_;
                                    if (_e3967 > _e3971) {
                                        phi_5968_ = _e3967;
                                    } else {
                                        phi_5968_ = _e3971;
                                    }
                                    let _e3974 = phi_5968_;
                                    let _e3977 = local_4[0u].member_2[1u];
                                    if (_e3977[0] < 0f) {
                                        phi_5982_ = -(_e3977[0]);
                                    } else {
                                        phi_5982_ = _e3977[0];
                                    }
                                    let _e3984 = phi_5982_;
                                    if (_e3977[1] < 0f) {
                                        phi_5989_ = -(_e3977[1]);
                                    } else {
                                        phi_5989_ = _e3977[1];
                                    }
                                    let _e3988 = phi_5989_;
                                    if (_e3984 > _e3988) {
                                        phi_5994_ = _e3984;
                                    } else {
                                        phi_5994_ = _e3988;
                                    }
                                    let _e3991 = phi_5994_;
                                    if (_e3977[2] < 0f) {
                                        phi_6001_ = -(_e3977[2]);
                                    } else {
                                        phi_6001_ = _e3977[2];
                                    }
                                    let _e3995 = phi_6001_;
                                    if (_e3991 > _e3995) {
                                        phi_6006_ = _e3991;
                                    } else {
                                        phi_6006_ = _e3995;
                                    }
                                    let _e3998 = phi_6006_;
                                    if (_e3974 > _e3998) {
                                        phi_6011_ = _e3974;
                                    } else {
                                        phi_6011_ = _e3998;
                                    }
                                    let _e4001 = phi_6011_;
                                    let _e4003 = local_4[0u].member_3;
                                    let _e4006 = (((_e3893 + _e3895) + (_e3947 + _e3949)) + (_e4001 + _e4003));
                                    let _e4009 = local_4[0u].member_3;
                                    let _e4013 = (((_e2088 * 1.0001f) + (_e4009 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e4016 = ((_e3785 * _e3764) - (_e3788 * _e3763));
                                    let _e4019 = ((_e3788 * _e3762) - (_e3782 * _e3764));
                                    let _e4022 = ((_e3782 * _e3763) - (_e3785 * _e3762));
                                    let _e4024 = local_2[0u];
                                    let _e4032 = (((_e4016 * _e4024[0]) + (_e4019 * _e4024[1])) + (_e4022 * _e4024[2]));
                                    phi_6049_ = type_36(0u, 4u);
                                    phi_6052_ = _e4032;
                                    phi_6054_ = _e4032;
                                    loop {
                                        let _e4034 = phi_6049_;
                                        let _e4036 = phi_6052_;
                                        let _e4038 = phi_6054_;
                                        local_58 = _e4036;
                                        local_59 = _e4038;
                                        local_76 = _e4038;
                                        if (_e4034.member < _e4034.member_1) {
                                            phi_6050_ = type_36((_e4034.member + 1u), _e4034.member_1);
                                            phi_6077_ = type_36(1u, _e4034.member);
                                        } else {
                                            phi_6050_ = _e4034;
                                            phi_6077_ = type_36(0u, type_36().member_1);
                                        }
                                        let _e4052 = phi_6050_;
                                        let _e4054 = phi_6077_;
                                        let _e4058 = (bitcast<i32>(_e4054.member) != 0i);
                                        if _e4058 {
                                            if (_e4054.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e4061 = local_2[_e4054.member_1];
                                            let _e4069 = (((_e4016 * _e4061[0]) + (_e4019 * _e4061[1])) + (_e4022 * _e4061[2]));
                                            if (_e4054.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e4072 = local_3[_e4054.member_1];
                                            let _e4080 = (((_e4016 * _e4072[0]) + (_e4019 * _e4072[1])) + (_e4022 * _e4072[2]));
                                            if (_e4038 < _e4069) {
                                                phi_6127_ = _e4038;
                                            } else {
                                                phi_6127_ = _e4069;
                                            }
                                            let _e4083 = phi_6127_;
                                            if (_e4083 < _e4080) {
                                                phi_6132_ = _e4083;
                                            } else {
                                                phi_6132_ = _e4080;
                                            }
                                            let _e4086 = phi_6132_;
                                            if (_e4036 > _e4069) {
                                                phi_6137_ = _e4036;
                                            } else {
                                                phi_6137_ = _e4069;
                                            }
                                            let _e4089 = phi_6137_;
                                            if (_e4089 > _e4080) {
                                                phi_6142_ = _e4089;
                                            } else {
                                                phi_6142_ = _e4080;
                                            }
                                            let _e4092 = phi_6142_;
                                            phi_6053_ = _e4092;
                                            phi_6055_ = _e4086;
                                        } else {
                                            phi_6053_ = f32();
                                            phi_6055_ = f32();
                                        }
                                        let _e4094 = phi_6053_;
                                        let _e4096 = phi_6055_;
                                        continue;
                                        continuing {
                                            phi_6049_ = _e4052;
                                            phi_6052_ = _e4094;
                                            phi_6054_ = _e4096;
                                            break if !(_e4058);
                                        }
                                    }
                                    if (_e4016 < 0f) {
                                        phi_6148_ = -(_e4016);
                                    } else {
                                        phi_6148_ = _e4016;
                                    }
                                    let _e4101 = phi_6148_;
                                    if (_e4019 < 0f) {
                                        phi_6154_ = -(_e4019);
                                    } else {
                                        phi_6154_ = _e4019;
                                    }
                                    let _e4105 = phi_6154_;
                                    if (_e4022 < 0f) {
                                        phi_6161_ = -(_e4022);
                                    } else {
                                        phi_6161_ = _e4022;
                                    }
                                    let _e4110 = phi_6161_;
                                    let _e4111 = ((_e4101 + _e4105) + _e4110);
                                    let _e4116 = local_58;
                                    let _e4117 = -(_e4116);
                                    let _e4119 = local_59;
                                    if (_e4119 > _e4117) {
                                        let _e5984 = local_76;
                                        phi_6171_ = _e5984;
                                    } else {
                                        phi_6171_ = _e4117;
                                    }
                                    let _e4122 = phi_6171_;
                                    let _e4127 = (((_e4122 - ((_e4111 * _e4006) * (0.000000059604645f * 17f))) - (_e4111 * _e4013)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e4130 = ((_e3785 * _e3779) - (_e3788 * _e3778));
                                    let _e4133 = ((_e3788 * _e3777) - (_e3782 * _e3779));
                                    let _e4136 = ((_e3782 * _e3778) - (_e3785 * _e3777));
                                    let _e4138 = local_2[0u];
                                    let _e4146 = (((_e4130 * _e4138[0]) + (_e4133 * _e4138[1])) + (_e4136 * _e4138[2]));
                                    phi_6202_ = type_36(0u, 4u);
                                    phi_6205_ = _e4146;
                                    phi_6207_ = _e4146;
                                    loop {
                                        let _e4148 = phi_6202_;
                                        let _e4150 = phi_6205_;
                                        let _e4152 = phi_6207_;
                                        local_60 = _e4150;
                                        local_61 = _e4152;
                                        local_77 = _e4152;
                                        if (_e4148.member < _e4148.member_1) {
                                            phi_6203_ = type_36((_e4148.member + 1u), _e4148.member_1);
                                            phi_6230_ = type_36(1u, _e4148.member);
                                        } else {
                                            phi_6203_ = _e4148;
                                            phi_6230_ = type_36(0u, type_36().member_1);
                                        }
                                        let _e4166 = phi_6203_;
                                        let _e4168 = phi_6230_;
                                        let _e4172 = (bitcast<i32>(_e4168.member) != 0i);
                                        if _e4172 {
                                            if (_e4168.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e4175 = local_2[_e4168.member_1];
                                            let _e4183 = (((_e4130 * _e4175[0]) + (_e4133 * _e4175[1])) + (_e4136 * _e4175[2]));
                                            if (_e4168.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e4186 = local_3[_e4168.member_1];
                                            let _e4194 = (((_e4130 * _e4186[0]) + (_e4133 * _e4186[1])) + (_e4136 * _e4186[2]));
                                            if (_e4152 < _e4183) {
                                                phi_6280_ = _e4152;
                                            } else {
                                                phi_6280_ = _e4183;
                                            }
                                            let _e4197 = phi_6280_;
                                            if (_e4197 < _e4194) {
                                                phi_6285_ = _e4197;
                                            } else {
                                                phi_6285_ = _e4194;
                                            }
                                            let _e4200 = phi_6285_;
                                            if (_e4150 > _e4183) {
                                                phi_6290_ = _e4150;
                                            } else {
                                                phi_6290_ = _e4183;
                                            }
                                            let _e4203 = phi_6290_;
                                            if (_e4203 > _e4194) {
                                                phi_6295_ = _e4203;
                                            } else {
                                                phi_6295_ = _e4194;
                                            }
                                            let _e4206 = phi_6295_;
                                            phi_6206_ = _e4206;
                                            phi_6208_ = _e4200;
                                        } else {
                                            phi_6206_ = f32();
                                            phi_6208_ = f32();
                                        }
                                        let _e4208 = phi_6206_;
                                        let _e4210 = phi_6208_;
                                        continue;
                                        continuing {
                                            phi_6202_ = _e4166;
                                            phi_6205_ = _e4208;
                                            phi_6207_ = _e4210;
                                            break if !(_e4172);
                                        }
                                    }
                                    if (_e4130 < 0f) {
                                        phi_6301_ = -(_e4130);
                                    } else {
                                        phi_6301_ = _e4130;
                                    }
                                    let _e4215 = phi_6301_;
                                    if (_e4133 < 0f) {
                                        phi_6307_ = -(_e4133);
                                    } else {
                                        phi_6307_ = _e4133;
                                    }
                                    let _e4219 = phi_6307_;
                                    if (_e4136 < 0f) {
                                        phi_6314_ = -(_e4136);
                                    } else {
                                        phi_6314_ = _e4136;
                                    }
                                    let _e4224 = phi_6314_;
                                    let _e4225 = ((_e4215 + _e4219) + _e4224);
                                    let _e4230 = local_60;
                                    let _e4231 = -(_e4230);
                                    let _e4233 = local_61;
                                    if (_e4233 > _e4231) {
                                        let _e6003 = local_77;
                                        phi_6324_ = _e6003;
                                    } else {
                                        phi_6324_ = _e4231;
                                    }
                                    let _e4236 = phi_6324_;
                                    let _e4241 = (((_e4236 - ((_e4225 * _e4006) * (0.000000059604645f * 17f))) - (_e4225 * _e4013)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e4127 > _e4241) {
                                        phi_6334_ = _e4127;
                                    } else {
                                        phi_6334_ = _e4241;
                                    }
                                    let _e4244 = phi_6334_;
                                    let _e4245 = (_e3777 - _e3762);
                                    let _e4246 = (_e3778 - _e3763);
                                    let _e4247 = (_e3779 - _e3764);
                                    let _e4250 = ((_e3785 * _e4247) - (_e3788 * _e4246));
                                    let _e4253 = ((_e3788 * _e4245) - (_e3782 * _e4247));
                                    let _e4256 = ((_e3782 * _e4246) - (_e3785 * _e4245));
                                    let _e4258 = local_2[0u];
                                    let _e4266 = (((_e4250 * _e4258[0]) + (_e4253 * _e4258[1])) + (_e4256 * _e4258[2]));
                                    phi_6367_ = type_36(0u, 4u);
                                    phi_6370_ = _e4266;
                                    phi_6372_ = _e4266;
                                    loop {
                                        let _e4268 = phi_6367_;
                                        let _e4270 = phi_6370_;
                                        let _e4272 = phi_6372_;
                                        local_62 = _e4270;
                                        local_63 = _e4272;
                                        local_78 = _e4272;
                                        if (_e4268.member < _e4268.member_1) {
                                            phi_6368_ = type_36((_e4268.member + 1u), _e4268.member_1);
                                            phi_6395_ = type_36(1u, _e4268.member);
                                        } else {
                                            phi_6368_ = _e4268;
                                            phi_6395_ = type_36(0u, type_36().member_1);
                                        }
                                        let _e4286 = phi_6368_;
                                        let _e4288 = phi_6395_;
                                        let _e4292 = (bitcast<i32>(_e4288.member) != 0i);
                                        if _e4292 {
                                            if (_e4288.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e4295 = local_2[_e4288.member_1];
                                            let _e4303 = (((_e4250 * _e4295[0]) + (_e4253 * _e4295[1])) + (_e4256 * _e4295[2]));
                                            if (_e4288.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e4306 = local_3[_e4288.member_1];
                                            let _e4314 = (((_e4250 * _e4306[0]) + (_e4253 * _e4306[1])) + (_e4256 * _e4306[2]));
                                            if (_e4272 < _e4303) {
                                                phi_6445_ = _e4272;
                                            } else {
                                                phi_6445_ = _e4303;
                                            }
                                            let _e4317 = phi_6445_;
                                            if (_e4317 < _e4314) {
                                                phi_6450_ = _e4317;
                                            } else {
                                                phi_6450_ = _e4314;
                                            }
                                            let _e4320 = phi_6450_;
                                            if (_e4270 > _e4303) {
                                                phi_6455_ = _e4270;
                                            } else {
                                                phi_6455_ = _e4303;
                                            }
                                            let _e4323 = phi_6455_;
                                            if (_e4323 > _e4314) {
                                                phi_6460_ = _e4323;
                                            } else {
                                                phi_6460_ = _e4314;
                                            }
                                            let _e4326 = phi_6460_;
                                            phi_6371_ = _e4326;
                                            phi_6373_ = _e4320;
                                        } else {
                                            phi_6371_ = f32();
                                            phi_6373_ = f32();
                                        }
                                        let _e4328 = phi_6371_;
                                        let _e4330 = phi_6373_;
                                        continue;
                                        continuing {
                                            phi_6367_ = _e4286;
                                            phi_6370_ = _e4328;
                                            phi_6372_ = _e4330;
                                            break if !(_e4292);
                                        }
                                    }
                                    if (_e4250 < 0f) {
                                        phi_6466_ = -(_e4250);
                                    } else {
                                        phi_6466_ = _e4250;
                                    }
                                    let _e4335 = phi_6466_;
                                    if (_e4253 < 0f) {
                                        phi_6472_ = -(_e4253);
                                    } else {
                                        phi_6472_ = _e4253;
                                    }
                                    let _e4339 = phi_6472_;
                                    if (_e4256 < 0f) {
                                        phi_6479_ = -(_e4256);
                                    } else {
                                        phi_6479_ = _e4256;
                                    }
                                    let _e4344 = phi_6479_;
                                    let _e4345 = ((_e4335 + _e4339) + _e4344);
                                    let _e4350 = local_62;
                                    let _e4351 = -(_e4350);
                                    let _e4353 = local_63;
                                    if (_e4353 > _e4351) {
                                        let _e6023 = local_78;
                                        phi_6489_ = _e6023;
                                    } else {
                                        phi_6489_ = _e4351;
                                    }
                                    let _e4356 = phi_6489_;
                                    let _e4361 = (((_e4356 - ((_e4345 * _e4006) * (0.000000059604645f * 17f))) - (_e4345 * _e4013)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e4244 > _e4361) {
                                        phi_6499_ = _e4244;
                                    } else {
                                        phi_6499_ = _e4361;
                                    }
                                    let _e4364 = phi_6499_;
                                    phi_6502_ = (_e4364 > 0f);
                                }
                                let _e4367 = phi_6502_;
                                if _e4367 {
                                    let _e4371 = local_4[1u].member_1[0u];
                                    let _e4377 = local_4[1u].member_2[0u];
                                    let _e4383 = ((_e4371[1] * _e4377[2]) - (_e4371[2] * _e4377[1]));
                                    let _e4386 = ((_e4371[2] * _e4377[0]) - (_e4371[0] * _e4377[2]));
                                    let _e4389 = ((_e4371[0] * _e4377[1]) - (_e4371[1] * _e4377[0]));
                                    let _e4392 = local_4[1u].member_1[1u];
                                    let _e4398 = local_4[1u].member_2[1u];
                                    let _e4404 = ((_e4392[1] * _e4398[2]) - (_e4392[2] * _e4398[1]));
                                    let _e4407 = ((_e4392[2] * _e4398[0]) - (_e4392[0] * _e4398[2]));
                                    let _e4410 = ((_e4392[0] * _e4398[1]) - (_e4392[1] * _e4398[0]));
                                    let _e4413 = local_4[1u].member_1[0u];
                                    let _e4419 = local_4[1u].member_2[1u];
                                    let _e4434 = local_4[1u].member_1[1u];
                                    let _e4440 = local_4[1u].member_2[0u];
                                    let _e4453 = (((_e4413[1] * _e4419[2]) - (_e4413[2] * _e4419[1])) + ((_e4434[1] * _e4440[2]) - (_e4434[2] * _e4440[1])));
                                    let _e4454 = (((_e4413[2] * _e4419[0]) - (_e4413[0] * _e4419[2])) + ((_e4434[2] * _e4440[0]) - (_e4434[0] * _e4440[2])));
                                    let _e4455 = (((_e4413[0] * _e4419[1]) - (_e4413[1] * _e4419[0])) + ((_e4434[0] * _e4440[1]) - (_e4434[1] * _e4440[0])));
                                    let _e4458 = local_4[1u].member[0u];
                                    let _e4469 = local_4[1u].member[1u];
                                    let _e4480 = local_4[1u].member[0u];
                                    let _e4489 = ((((_e4469[0] * _e4383) + (_e4469[1] * _e4386)) + (_e4469[2] * _e4389)) + (((_e4480[0] * _e4453) + (_e4480[1] * _e4454)) + (_e4480[2] * _e4455)));
                                    let _e4492 = local_4[1u].member[0u];
                                    let _e4503 = local_4[1u].member[1u];
                                    let _e4512 = ((((_e4492[0] * _e4404) + (_e4492[1] * _e4407)) + (_e4492[2] * _e4410)) + (((_e4503[0] * _e4453) + (_e4503[1] * _e4454)) + (_e4503[2] * _e4455)));
                                    let _e4515 = local_4[1u].member[1u];
                                    let _e4526 = local_4[1u].member[0u];
                                    if (_e4526[0] < 0f) {
                                        phi_6748_ = -(_e4526[0]);
                                    } else {
                                        phi_6748_ = _e4526[0];
                                    }
                                    let _e4533 = phi_6748_;
                                    if (_e4526[1] < 0f) {
                                        phi_6755_ = -(_e4526[1]);
                                    } else {
                                        phi_6755_ = _e4526[1];
                                    }
                                    let _e4537 = phi_6755_;
                                    if (_e4533 > _e4537) {
                                        phi_6760_ = _e4533;
                                    } else {
                                        phi_6760_ = _e4537;
                                    }
                                    let _e4540 = phi_6760_;
                                    if (_e4526[2] < 0f) {
                                        phi_6767_ = -(_e4526[2]);
                                    } else {
                                        phi_6767_ = _e4526[2];
                                    }
                                    let _e4544 = phi_6767_;
                                    if (_e4540 > _e4544) {
                                        phi_6772_ = _e4540;
                                    } else {
                                        phi_6772_ = _e4544;
                                    }
                                    let _e4547 = phi_6772_;
                                    let _e4550 = local_4[1u].member[1u];
                                    if (_e4550[0] < 0f) {
                                        phi_6785_ = -(_e4550[0]);
                                    } else {
                                        phi_6785_ = _e4550[0];
                                    }
                                    let _e4557 = phi_6785_;
                                    if (_e4550[1] < 0f) {
                                        phi_6792_ = -(_e4550[1]);
                                    } else {
                                        phi_6792_ = _e4550[1];
                                    }
                                    let _e4561 = phi_6792_;
                                    if (_e4557 > _e4561) {
                                        phi_6797_ = _e4557;
                                    } else {
                                        phi_6797_ = _e4561;
                                    }
                                    let _e4564 = phi_6797_;
                                    if (_e4550[2] < 0f) {
                                        phi_6804_ = -(_e4550[2]);
                                    } else {
                                        phi_6804_ = _e4550[2];
                                    }
                                    let _e4568 = phi_6804_;
                                    if (_e4564 > _e4568) {
                                        phi_6809_ = _e4564;
                                    } else {
                                        phi_6809_ = _e4568;
                                    }
                                    let _e4571 = phi_6809_;
                                    if (_e4547 > _e4571) {
                                        phi_6814_ = _e4547;
                                    } else {
                                        phi_6814_ = _e4571;
                                    }
                                    let _e4574 = phi_6814_;
                                    let _e4576 = local_4[1u].member_3;
                                    let _e4577 = (_e4574 + _e4576);
                                    let _e4580 = local_4[1u].member_1[0u];
                                    if (_e4580[0] < 0f) {
                                        phi_6831_ = -(_e4580[0]);
                                    } else {
                                        phi_6831_ = _e4580[0];
                                    }
                                    let _e4587 = phi_6831_;
                                    if (_e4580[1] < 0f) {
                                        phi_6838_ = -(_e4580[1]);
                                    } else {
                                        phi_6838_ = _e4580[1];
                                    }
                                    let _e4591 = phi_6838_;
                                    if (_e4587 > _e4591) {
                                        phi_6843_ = _e4587;
                                    } else {
                                        phi_6843_ = _e4591;
                                    }
                                    let _e4594 = phi_6843_;
                                    if (_e4580[2] < 0f) {
                                        phi_6850_ = -(_e4580[2]);
                                    } else {
                                        phi_6850_ = _e4580[2];
                                    }
                                    let _e4598 = phi_6850_;
                                    if (_e4594 > _e4598) {
                                        phi_6855_ = _e4594;
                                    } else {
                                        phi_6855_ = _e4598;
                                    }
                                    let _e4601 = phi_6855_;
                                    let _e4604 = local_4[1u].member_1[1u];
                                    if (_e4604[0] < 0f) {
                                        phi_6869_ = -(_e4604[0]);
                                    } else {
                                        phi_6869_ = _e4604[0];
                                    }
                                    let _e4611 = phi_6869_;
                                    if (_e4604[1] < 0f) {
                                        phi_6876_ = -(_e4604[1]);
                                    } else {
                                        phi_6876_ = _e4604[1];
                                    }
                                    let _e4615 = phi_6876_;
                                    if (_e4611 > _e4615) {
                                        phi_6881_ = _e4611;
                                    } else {
                                        phi_6881_ = _e4615;
                                    }
                                    let _e4618 = phi_6881_;
                                    if (_e4604[2] < 0f) {
                                        phi_6888_ = -(_e4604[2]);
                                    } else {
                                        phi_6888_ = _e4604[2];
                                    }
                                    let _e4622 = phi_6888_;
                                    if (_e4618 > _e4622) {
                                        phi_6893_ = _e4618;
                                    } else {
                                        phi_6893_ = _e4622;
                                    }
                                    let _e4625 = phi_6893_;
                                    if (_e4601 > _e4625) {
                                        phi_6898_ = _e4601;
                                    } else {
                                        phi_6898_ = _e4625;
                                    }
                                    let _e4628 = phi_6898_;
                                    let _e4630 = local_4[1u].member_3;
                                    let _e4631 = (_e4628 + _e4630);
                                    let _e4634 = local_4[1u].member_2[0u];
                                    if (_e4634[0] < 0f) {
                                        phi_6915_ = -(_e4634[0]);
                                    } else {
                                        phi_6915_ = _e4634[0];
                                    }
                                    let _e4641 = phi_6915_;
                                    if (_e4634[1] < 0f) {
                                        phi_6922_ = -(_e4634[1]);
                                    } else {
                                        phi_6922_ = _e4634[1];
                                    }
                                    let _e4645 = phi_6922_;
                                    if (_e4641 > _e4645) {
                                        phi_6927_ = _e4641;
                                    } else {
                                        phi_6927_ = _e4645;
                                    }
                                    let _e4648 = phi_6927_;
                                    if (_e4634[2] < 0f) {
                                        phi_6934_ = -(_e4634[2]);
                                    } else {
                                        phi_6934_ = _e4634[2];
                                    }
                                    let _e4652 = phi_6934_;
                                    if (_e4648 > _e4652) {
                                        phi_6939_ = _e4648;
                                    } else {
                                        phi_6939_ = _e4652;
                                    }
                                    let _e4655 = phi_6939_;
                                    let _e4658 = local_4[1u].member_2[1u];
                                    if (_e4658[0] < 0f) {
                                        phi_6953_ = -(_e4658[0]);
                                    } else {
                                        phi_6953_ = _e4658[0];
                                    }
                                    let _e4665 = phi_6953_;
                                    if (_e4658[1] < 0f) {
                                        phi_6960_ = -(_e4658[1]);
                                    } else {
                                        phi_6960_ = _e4658[1];
                                    }
                                    let _e4669 = phi_6960_;
                                    if (_e4665 > _e4669) {
                                        phi_6965_ = _e4665;
                                    } else {
                                        phi_6965_ = _e4669;
                                    }
                                    let _e4672 = phi_6965_;
                                    if (_e4658[2] < 0f) {
                                        phi_6972_ = -(_e4658[2]);
                                    } else {
                                        phi_6972_ = _e4658[2];
                                    }
                                    let _e4676 = phi_6972_;
                                    if (_e4672 > _e4676) {
                                        phi_6977_ = _e4672;
                                    } else {
                                        phi_6977_ = _e4676;
                                    }
                                    let _e4679 = phi_6977_;
                                    if (_e4655 > _e4679) {
                                        phi_6982_ = _e4655;
                                    } else {
                                        phi_6982_ = _e4679;
                                    }
                                    let _e4682 = phi_6982_;
                                    let _e4684 = local_4[1u].member_3;
                                    let _e4685 = (_e4682 + _e4684);
                                    let _e4687 = ((_e4631 * 8f) * _e4685);
                                    let _e4694 = local_4[1u].member_3;
                                    if (_e4383 < 0f) {
                                        phi_7013_ = -(_e4383);
                                    } else {
                                        phi_7013_ = _e4383;
                                    }
                                    let _e4711 = phi_7013_;
                                    if (_e4386 < 0f) {
                                        phi_7019_ = -(_e4386);
                                    } else {
                                        phi_7019_ = _e4386;
                                    }
                                    let _e4715 = phi_7019_;
                                    if (_e4389 < 0f) {
                                        phi_7026_ = -(_e4389);
                                    } else {
                                        phi_7026_ = _e4389;
                                    }
                                    let _e4720 = phi_7026_;
                                    let _e4721 = ((_e4711 + _e4715) + _e4720);
                                    if (_e4404 < 0f) {
                                        phi_7033_ = -(_e4404);
                                    } else {
                                        phi_7033_ = _e4404;
                                    }
                                    let _e4725 = phi_7033_;
                                    if (_e4407 < 0f) {
                                        phi_7039_ = -(_e4407);
                                    } else {
                                        phi_7039_ = _e4407;
                                    }
                                    let _e4729 = phi_7039_;
                                    if (_e4410 < 0f) {
                                        phi_7046_ = -(_e4410);
                                    } else {
                                        phi_7046_ = _e4410;
                                    }
                                    let _e4734 = phi_7046_;
                                    let _e4735 = ((_e4725 + _e4729) + _e4734);
                                    if (_e4721 > _e4735) {
                                        phi_7052_ = _e4721;
                                    } else {
                                        phi_7052_ = _e4735;
                                    }
                                    let _e4738 = phi_7052_;
                                    if (_e4453 < 0f) {
                                        phi_7058_ = -(_e4453);
                                    } else {
                                        phi_7058_ = _e4453;
                                    }
                                    let _e4742 = phi_7058_;
                                    if (_e4454 < 0f) {
                                        phi_7064_ = -(_e4454);
                                    } else {
                                        phi_7064_ = _e4454;
                                    }
                                    let _e4746 = phi_7064_;
                                    if (_e4455 < 0f) {
                                        phi_7071_ = -(_e4455);
                                    } else {
                                        phi_7071_ = _e4455;
                                    }
                                    let _e4751 = phi_7071_;
                                    let _e4753 = (((_e4742 + _e4746) + _e4751) * 0.5f);
                                    if (_e4738 > _e4753) {
                                        phi_7078_ = _e4738;
                                    } else {
                                        phi_7078_ = _e4753;
                                    }
                                    let _e4756 = phi_7078_;
                                    let _e4761 = local_4[1u].member_3;
                                    let _e4774 = ((((_e4458[0] * _e4383) + (_e4458[1] * _e4386)) + (_e4458[2] * _e4389)) * 3f);
                                    let _e4775 = ((((_e4515[0] * _e4404) + (_e4515[1] * _e4407)) + (_e4515[2] * _e4410)) * 3f);
                                    if (_e4774 < _e4775) {
                                        phi_7102_ = _e4774;
                                    } else {
                                        phi_7102_ = _e4775;
                                    }
                                    let _e4778 = phi_7102_;
                                    if (_e4489 < _e4512) {
                                        phi_7107_ = _e4489;
                                    } else {
                                        phi_7107_ = _e4512;
                                    }
                                    let _e4781 = phi_7107_;
                                    if (_e4778 < _e4781) {
                                        phi_7112_ = _e4778;
                                    } else {
                                        phi_7112_ = _e4781;
                                    }
                                    let _e4784 = phi_7112_;
                                    if (_e4774 > _e4775) {
                                        phi_7117_ = _e4774;
                                    } else {
                                        phi_7117_ = _e4775;
                                    }
                                    let _e4787 = phi_7117_;
                                    if (_e4489 > _e4512) {
                                        phi_7122_ = _e4489;
                                    } else {
                                        phi_7122_ = _e4512;
                                    }
                                    let _e4790 = phi_7122_;
                                    if (_e4787 > _e4790) {
                                        phi_7127_ = _e4787;
                                    } else {
                                        phi_7127_ = _e4790;
                                    }
                                    let _e4793 = phi_7127_;
                                    let _e4798 = -(_e4793);
                                    if (_e4784 > _e4798) {
                                        phi_7137_ = _e4784;
                                    } else {
                                        phi_7137_ = _e4798;
                                    }
                                    let _e4801 = phi_7137_;
                                    if ((_e4801 - ((((((_e4577 * 8f) * _e4687) * (0.000000059604645f * (490f / 64f))) + ((_e4694 * 19f) * ((_e4577 * (_e4631 + _e4685)) + (_e4631 * _e4685)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4577) * ((1f + _e4631) * (1f + _e4685))))) + ((_e2088 * (((_e4756 + (_e4687 * (0.000000059604645f * 4f))) + ((_e4761 * 6f) * (_e4631 + _e4685))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4631) * (1f + _e4685))))) * (3f * 1.0001f)))) > 0f) {
                                        phi_8113_ = true;
                                    } else {
                                        let _e4806 = local_4[1u].member_1[0u];
                                        let _e4812 = local_4[1u].member_1[1u];
                                        let _e4816 = (_e4806[0] + _e4812[0]);
                                        let _e4817 = (_e4806[1] + _e4812[1]);
                                        let _e4818 = (_e4806[2] + _e4812[2]);
                                        let _e4821 = local_4[1u].member_2[0u];
                                        let _e4827 = local_4[1u].member_2[1u];
                                        let _e4831 = (_e4821[0] + _e4827[0]);
                                        let _e4832 = (_e4821[1] + _e4827[1]);
                                        let _e4833 = (_e4821[2] + _e4827[2]);
                                        let _e4836 = ((_e4817 * _e4833) - (_e4818 * _e4832));
                                        let _e4839 = ((_e4818 * _e4831) - (_e4816 * _e4833));
                                        let _e4842 = ((_e4816 * _e4832) - (_e4817 * _e4831));
                                        let _e4845 = local_4[1u].member[0u];
                                        let _e4851 = local_4[1u].member_1[0u];
                                        let _e4857 = local_4[1u].member_2[0u];
                                        let _e4869 = local_4[1u].member[1u];
                                        let _e4875 = local_4[1u].member_1[1u];
                                        let _e4881 = local_4[1u].member_2[1u];
                                        local = array<array<f32, 3>, 4>(_e4845, array<f32, 3>((_e4845[0] - _e4851[0]), (_e4845[1] - _e4851[1]), (_e4845[2] - _e4851[2])), array<f32, 3>((_e4845[0] - _e4857[0]), (_e4845[1] - _e4857[1]), (_e4845[2] - _e4857[2])), _e4845);
                                        local_1 = array<array<f32, 3>, 4>(_e4869, array<f32, 3>((_e4869[0] - _e4875[0]), (_e4869[1] - _e4875[1]), (_e4869[2] - _e4875[2])), array<f32, 3>((_e4869[0] - _e4881[0]), (_e4869[1] - _e4881[1]), (_e4869[2] - _e4881[2])), _e4869);
                                        let _e4899 = local_4[1u].member[0u];
                                        if (_e4899[0] < 0f) {
                                            phi_7388_ = -(_e4899[0]);
                                        } else {
                                            phi_7388_ = _e4899[0];
                                        }
                                        let _e4906 = phi_7388_;
                                        if (_e4899[1] < 0f) {
                                            phi_7395_ = -(_e4899[1]);
                                        } else {
                                            phi_7395_ = _e4899[1];
                                        }
                                        let _e4910 = phi_7395_;
                                        if (_e4906 > _e4910) {
                                            phi_7400_ = _e4906;
                                        } else {
                                            phi_7400_ = _e4910;
                                        }
                                        let _e4913 = phi_7400_;
                                        if (_e4899[2] < 0f) {
                                            phi_7407_ = -(_e4899[2]);
                                        } else {
                                            phi_7407_ = _e4899[2];
                                        }
                                        let _e4917 = phi_7407_;
                                        if (_e4913 > _e4917) {
                                            phi_7412_ = _e4913;
                                        } else {
                                            phi_7412_ = _e4917;
                                        }
                                        let _e4920 = phi_7412_;
                                        let _e4923 = local_4[1u].member[1u];
                                        if (_e4923[0] < 0f) {
                                            phi_7425_ = -(_e4923[0]);
                                        } else {
                                            phi_7425_ = _e4923[0];
                                        }
                                        let _e4930 = phi_7425_;
                                        if (_e4923[1] < 0f) {
                                            phi_7432_ = -(_e4923[1]);
                                        } else {
                                            phi_7432_ = _e4923[1];
                                        }
                                        let _e4934 = phi_7432_;
                                        if (_e4930 > _e4934) {
                                            phi_7437_ = _e4930;
                                        } else {
                                            phi_7437_ = _e4934;
                                        }
                                        let _e4937 = phi_7437_;
                                        if (_e4923[2] < 0f) {
                                            phi_7444_ = -(_e4923[2]);
                                        } else {
                                            phi_7444_ = _e4923[2];
                                        }
                                        let _e4941 = phi_7444_;
                                        if (_e4937 > _e4941) {
                                            phi_7449_ = _e4937;
                                        } else {
                                            phi_7449_ = _e4941;
                                        }
                                        let _e4944 = phi_7449_;
                                        if (_e4920 > _e4944) {
                                            phi_7454_ = _e4920;
                                        } else {
                                            phi_7454_ = _e4944;
                                        }
                                        let _e4947 = phi_7454_;
                                        let _e4949 = local_4[1u].member_3;
                                        let _e4953 = local_4[1u].member_1[0u];
                                        if (_e4953[0] < 0f) {
                                            phi_7471_ = -(_e4953[0]);
                                        } else {
                                            phi_7471_ = _e4953[0];
                                        }
                                        let _e4960 = phi_7471_;
                                        if (_e4953[1] < 0f) {
                                            phi_7478_ = -(_e4953[1]);
                                        } else {
                                            phi_7478_ = _e4953[1];
                                        }
                                        let _e4964 = phi_7478_;
                                        if (_e4960 > _e4964) {
                                            phi_7483_ = _e4960;
                                        } else {
                                            phi_7483_ = _e4964;
                                        }
                                        let _e4967 = phi_7483_;
                                        if (_e4953[2] < 0f) {
                                            phi_7490_ = -(_e4953[2]);
                                        } else {
                                            phi_7490_ = _e4953[2];
                                        }
                                        let _e4971 = phi_7490_;
                                        if (_e4967 > _e4971) {
                                            phi_7495_ = _e4967;
                                        } else {
                                            phi_7495_ = _e4971;
                                        }
                                        let _e4974 = phi_7495_;
                                        let _e4977 = local_4[1u].member_1[1u];
                                        if (_e4977[0] < 0f) {
                                            phi_7509_ = -(_e4977[0]);
                                        } else {
                                            phi_7509_ = _e4977[0];
                                        }
                                        let _e4984 = phi_7509_;
                                        if (_e4977[1] < 0f) {
                                            phi_7516_ = -(_e4977[1]);
                                        } else {
                                            phi_7516_ = _e4977[1];
                                        }
                                        let _e4988 = phi_7516_;
                                        if (_e4984 > _e4988) {
                                            phi_7521_ = _e4984;
                                        } else {
                                            phi_7521_ = _e4988;
                                        }
                                        let _e4991 = phi_7521_;
                                        if (_e4977[2] < 0f) {
                                            phi_7528_ = -(_e4977[2]);
                                        } else {
                                            phi_7528_ = _e4977[2];
                                        }
                                        let _e4995 = phi_7528_;
                                        if (_e4991 > _e4995) {
                                            phi_7533_ = _e4991;
                                        } else {
                                            phi_7533_ = _e4995;
                                        }
                                        let _e4998 = phi_7533_;
                                        if (_e4974 > _e4998) {
                                            phi_7538_ = _e4974;
                                        } else {
                                            phi_7538_ = _e4998;
                                        }
                                        let _e5001 = phi_7538_;
                                        let _e5003 = local_4[1u].member_3;
                                        let _e5007 = local_4[1u].member_2[0u];
                                        if (_e5007[0] < 0f) {
                                            phi_7555_ = -(_e5007[0]);
                                        } else {
                                            phi_7555_ = _e5007[0];
                                        }
                                        let _e5014 = phi_7555_;
                                        if (_e5007[1] < 0f) {
                                            phi_7562_ = -(_e5007[1]);
                                        } else {
                                            phi_7562_ = _e5007[1];
                                        }
                                        let _e5018 = phi_7562_;
                                        if (_e5014 > _e5018) {
                                            phi_7567_ = _e5014;
                                        } else {
                                            phi_7567_ = _e5018;
                                        }
                                        let _e5021 = phi_7567_;
                                        if (_e5007[2] < 0f) {
                                            phi_7574_ = -(_e5007[2]);
                                        } else {
                                            phi_7574_ = _e5007[2];
                                        }
                                        let _e5025 = phi_7574_;
                                        if (_e5021 > _e5025) {
                                            phi_7579_ = _e5021;
                                        } else {
                                            phi_7579_ = _e5025;
                                        }
                                        let _e5028 = phi_7579_;
                                        let _e5031 = local_4[1u].member_2[1u];
                                        if (_e5031[0] < 0f) {
                                            phi_7593_ = -(_e5031[0]);
                                        } else {
                                            phi_7593_ = _e5031[0];
                                        }
                                        let _e5038 = phi_7593_;
                                        if (_e5031[1] < 0f) {
                                            phi_7600_ = -(_e5031[1]);
                                        } else {
                                            phi_7600_ = _e5031[1];
                                        }
                                        let _e5042 = phi_7600_;
                                        if (_e5038 > _e5042) {
                                            phi_7605_ = _e5038;
                                        } else {
                                            phi_7605_ = _e5042;
                                        }
                                        let _e5045 = phi_7605_;
                                        if (_e5031[2] < 0f) {
                                            phi_7612_ = -(_e5031[2]);
                                        } else {
                                            phi_7612_ = _e5031[2];
                                        }
                                        let _e5049 = phi_7612_;
                                        if (_e5045 > _e5049) {
                                            phi_7617_ = _e5045;
                                        } else {
                                            phi_7617_ = _e5049;
                                        }
                                        let _e5052 = phi_7617_;
                                        if (_e5028 > _e5052) {
                                            phi_7622_ = _e5028;
                                        } else {
                                            phi_7622_ = _e5052;
                                        }
                                        let _e5055 = phi_7622_;
                                        let _e5057 = local_4[1u].member_3;
                                        let _e5060 = (((_e4947 + _e4949) + (_e5001 + _e5003)) + (_e5055 + _e5057));
                                        let _e5063 = local_4[1u].member_3;
                                        let _e5067 = (((_e2088 * 1.0001f) + (_e5063 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e5070 = ((_e4839 * _e4818) - (_e4842 * _e4817));
                                        let _e5073 = ((_e4842 * _e4816) - (_e4836 * _e4818));
                                        let _e5076 = ((_e4836 * _e4817) - (_e4839 * _e4816));
                                        let _e5078 = local[0u];
                                        let _e5086 = (((_e5070 * _e5078[0]) + (_e5073 * _e5078[1])) + (_e5076 * _e5078[2]));
                                        phi_7660_ = type_36(0u, 4u);
                                        phi_7663_ = _e5086;
                                        phi_7665_ = _e5086;
                                        loop {
                                            let _e5088 = phi_7660_;
                                            let _e5090 = phi_7663_;
                                            let _e5092 = phi_7665_;
                                            local_64 = _e5090;
                                            local_65 = _e5092;
                                            local_79 = _e5092;
                                            if (_e5088.member < _e5088.member_1) {
                                                phi_7661_ = type_36((_e5088.member + 1u), _e5088.member_1);
                                                phi_7688_ = type_36(1u, _e5088.member);
                                            } else {
                                                phi_7661_ = _e5088;
                                                phi_7688_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e5106 = phi_7661_;
                                            let _e5108 = phi_7688_;
                                            let _e5112 = (bitcast<i32>(_e5108.member) != 0i);
                                            if _e5112 {
                                                if (_e5108.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e5115 = local[_e5108.member_1];
                                                let _e5123 = (((_e5070 * _e5115[0]) + (_e5073 * _e5115[1])) + (_e5076 * _e5115[2]));
                                                if (_e5108.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e5126 = local_1[_e5108.member_1];
                                                let _e5134 = (((_e5070 * _e5126[0]) + (_e5073 * _e5126[1])) + (_e5076 * _e5126[2]));
                                                if (_e5092 < _e5123) {
                                                    phi_7738_ = _e5092;
                                                } else {
                                                    phi_7738_ = _e5123;
                                                }
                                                let _e5137 = phi_7738_;
                                                if (_e5137 < _e5134) {
                                                    phi_7743_ = _e5137;
                                                } else {
                                                    phi_7743_ = _e5134;
                                                }
                                                let _e5140 = phi_7743_;
                                                if (_e5090 > _e5123) {
                                                    phi_7748_ = _e5090;
                                                } else {
                                                    phi_7748_ = _e5123;
                                                }
                                                let _e5143 = phi_7748_;
                                                if (_e5143 > _e5134) {
                                                    phi_7753_ = _e5143;
                                                } else {
                                                    phi_7753_ = _e5134;
                                                }
                                                let _e5146 = phi_7753_;
                                                phi_7664_ = _e5146;
                                                phi_7666_ = _e5140;
                                            } else {
                                                phi_7664_ = f32();
                                                phi_7666_ = f32();
                                            }
                                            let _e5148 = phi_7664_;
                                            let _e5150 = phi_7666_;
                                            continue;
                                            continuing {
                                                phi_7660_ = _e5106;
                                                phi_7663_ = _e5148;
                                                phi_7665_ = _e5150;
                                                break if !(_e5112);
                                            }
                                        }
                                        if (_e5070 < 0f) {
                                            phi_7759_ = -(_e5070);
                                        } else {
                                            phi_7759_ = _e5070;
                                        }
                                        let _e5155 = phi_7759_;
                                        if (_e5073 < 0f) {
                                            phi_7765_ = -(_e5073);
                                        } else {
                                            phi_7765_ = _e5073;
                                        }
                                        let _e5159 = phi_7765_;
                                        if (_e5076 < 0f) {
                                            phi_7772_ = -(_e5076);
                                        } else {
                                            phi_7772_ = _e5076;
                                        }
                                        let _e5164 = phi_7772_;
                                        let _e5165 = ((_e5155 + _e5159) + _e5164);
                                        let _e5170 = local_64;
                                        let _e5171 = -(_e5170);
                                        let _e5173 = local_65;
                                        if (_e5173 > _e5171) {
                                            let _e6128 = local_79;
                                            phi_7782_ = _e6128;
                                        } else {
                                            phi_7782_ = _e5171;
                                        }
                                        let _e5176 = phi_7782_;
                                        let _e5181 = (((_e5176 - ((_e5165 * _e5060) * (0.000000059604645f * 17f))) - (_e5165 * _e5067)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e5184 = ((_e4839 * _e4833) - (_e4842 * _e4832));
                                        let _e5187 = ((_e4842 * _e4831) - (_e4836 * _e4833));
                                        let _e5190 = ((_e4836 * _e4832) - (_e4839 * _e4831));
                                        let _e5192 = local[0u];
                                        let _e5200 = (((_e5184 * _e5192[0]) + (_e5187 * _e5192[1])) + (_e5190 * _e5192[2]));
                                        phi_7813_ = type_36(0u, 4u);
                                        phi_7816_ = _e5200;
                                        phi_7818_ = _e5200;
                                        loop {
                                            let _e5202 = phi_7813_;
                                            let _e5204 = phi_7816_;
                                            let _e5206 = phi_7818_;
                                            local_66 = _e5204;
                                            local_67 = _e5206;
                                            local_80 = _e5206;
                                            if (_e5202.member < _e5202.member_1) {
                                                phi_7814_ = type_36((_e5202.member + 1u), _e5202.member_1);
                                                phi_7841_ = type_36(1u, _e5202.member);
                                            } else {
                                                phi_7814_ = _e5202;
                                                phi_7841_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e5220 = phi_7814_;
                                            let _e5222 = phi_7841_;
                                            let _e5226 = (bitcast<i32>(_e5222.member) != 0i);
                                            if _e5226 {
                                                if (_e5222.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e5229 = local[_e5222.member_1];
                                                let _e5237 = (((_e5184 * _e5229[0]) + (_e5187 * _e5229[1])) + (_e5190 * _e5229[2]));
                                                if (_e5222.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e5240 = local_1[_e5222.member_1];
                                                let _e5248 = (((_e5184 * _e5240[0]) + (_e5187 * _e5240[1])) + (_e5190 * _e5240[2]));
                                                if (_e5206 < _e5237) {
                                                    phi_7891_ = _e5206;
                                                } else {
                                                    phi_7891_ = _e5237;
                                                }
                                                let _e5251 = phi_7891_;
                                                if (_e5251 < _e5248) {
                                                    phi_7896_ = _e5251;
                                                } else {
                                                    phi_7896_ = _e5248;
                                                }
                                                let _e5254 = phi_7896_;
                                                if (_e5204 > _e5237) {
                                                    phi_7901_ = _e5204;
                                                } else {
                                                    phi_7901_ = _e5237;
                                                }
                                                let _e5257 = phi_7901_;
                                                if (_e5257 > _e5248) {
                                                    phi_7906_ = _e5257;
                                                } else {
                                                    phi_7906_ = _e5248;
                                                }
                                                let _e5260 = phi_7906_;
                                                phi_7817_ = _e5260;
                                                phi_7819_ = _e5254;
                                            } else {
                                                phi_7817_ = f32();
                                                phi_7819_ = f32();
                                            }
                                            let _e5262 = phi_7817_;
                                            let _e5264 = phi_7819_;
                                            continue;
                                            continuing {
                                                phi_7813_ = _e5220;
                                                phi_7816_ = _e5262;
                                                phi_7818_ = _e5264;
                                                break if !(_e5226);
                                            }
                                        }
                                        if (_e5184 < 0f) {
                                            phi_7912_ = -(_e5184);
                                        } else {
                                            phi_7912_ = _e5184;
                                        }
                                        let _e5269 = phi_7912_;
                                        if (_e5187 < 0f) {
                                            phi_7918_ = -(_e5187);
                                        } else {
                                            phi_7918_ = _e5187;
                                        }
                                        let _e5273 = phi_7918_;
                                        if (_e5190 < 0f) {
                                            phi_7925_ = -(_e5190);
                                        } else {
                                            phi_7925_ = _e5190;
                                        }
                                        let _e5278 = phi_7925_;
                                        let _e5279 = ((_e5269 + _e5273) + _e5278);
                                        let _e5284 = local_66;
                                        let _e5285 = -(_e5284);
                                        let _e5287 = local_67;
                                        if (_e5287 > _e5285) {
                                            let _e6147 = local_80;
                                            phi_7935_ = _e6147;
                                        } else {
                                            phi_7935_ = _e5285;
                                        }
                                        let _e5290 = phi_7935_;
                                        let _e5295 = (((_e5290 - ((_e5279 * _e5060) * (0.000000059604645f * 17f))) - (_e5279 * _e5067)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e5181 > _e5295) {
                                            phi_7945_ = _e5181;
                                        } else {
                                            phi_7945_ = _e5295;
                                        }
                                        let _e5298 = phi_7945_;
                                        let _e5299 = (_e4831 - _e4816);
                                        let _e5300 = (_e4832 - _e4817);
                                        let _e5301 = (_e4833 - _e4818);
                                        let _e5304 = ((_e4839 * _e5301) - (_e4842 * _e5300));
                                        let _e5307 = ((_e4842 * _e5299) - (_e4836 * _e5301));
                                        let _e5310 = ((_e4836 * _e5300) - (_e4839 * _e5299));
                                        let _e5312 = local[0u];
                                        let _e5320 = (((_e5304 * _e5312[0]) + (_e5307 * _e5312[1])) + (_e5310 * _e5312[2]));
                                        phi_7978_ = type_36(0u, 4u);
                                        phi_7981_ = _e5320;
                                        phi_7983_ = _e5320;
                                        loop {
                                            let _e5322 = phi_7978_;
                                            let _e5324 = phi_7981_;
                                            let _e5326 = phi_7983_;
                                            local_68 = _e5324;
                                            local_69 = _e5326;
                                            local_81 = _e5326;
                                            if (_e5322.member < _e5322.member_1) {
                                                phi_7979_ = type_36((_e5322.member + 1u), _e5322.member_1);
                                                phi_8006_ = type_36(1u, _e5322.member);
                                            } else {
                                                phi_7979_ = _e5322;
                                                phi_8006_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e5340 = phi_7979_;
                                            let _e5342 = phi_8006_;
                                            let _e5346 = (bitcast<i32>(_e5342.member) != 0i);
                                            if _e5346 {
                                                if (_e5342.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e5349 = local[_e5342.member_1];
                                                let _e5357 = (((_e5304 * _e5349[0]) + (_e5307 * _e5349[1])) + (_e5310 * _e5349[2]));
                                                if (_e5342.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e5360 = local_1[_e5342.member_1];
                                                let _e5368 = (((_e5304 * _e5360[0]) + (_e5307 * _e5360[1])) + (_e5310 * _e5360[2]));
                                                if (_e5326 < _e5357) {
                                                    phi_8056_ = _e5326;
                                                } else {
                                                    phi_8056_ = _e5357;
                                                }
                                                let _e5371 = phi_8056_;
                                                if (_e5371 < _e5368) {
                                                    phi_8061_ = _e5371;
                                                } else {
                                                    phi_8061_ = _e5368;
                                                }
                                                let _e5374 = phi_8061_;
                                                if (_e5324 > _e5357) {
                                                    phi_8066_ = _e5324;
                                                } else {
                                                    phi_8066_ = _e5357;
                                                }
                                                let _e5377 = phi_8066_;
                                                if (_e5377 > _e5368) {
                                                    phi_8071_ = _e5377;
                                                } else {
                                                    phi_8071_ = _e5368;
                                                }
                                                let _e5380 = phi_8071_;
                                                phi_7982_ = _e5380;
                                                phi_7984_ = _e5374;
                                            } else {
                                                phi_7982_ = f32();
                                                phi_7984_ = f32();
                                            }
                                            let _e5382 = phi_7982_;
                                            let _e5384 = phi_7984_;
                                            continue;
                                            continuing {
                                                phi_7978_ = _e5340;
                                                phi_7981_ = _e5382;
                                                phi_7983_ = _e5384;
                                                break if !(_e5346);
                                            }
                                        }
                                        if (_e5304 < 0f) {
                                            phi_8077_ = -(_e5304);
                                        } else {
                                            phi_8077_ = _e5304;
                                        }
                                        let _e5389 = phi_8077_;
                                        if (_e5307 < 0f) {
                                            phi_8083_ = -(_e5307);
                                        } else {
                                            phi_8083_ = _e5307;
                                        }
                                        let _e5393 = phi_8083_;
                                        if (_e5310 < 0f) {
                                            phi_8090_ = -(_e5310);
                                        } else {
                                            phi_8090_ = _e5310;
                                        }
                                        let _e5398 = phi_8090_;
                                        let _e5399 = ((_e5389 + _e5393) + _e5398);
                                        let _e5404 = local_68;
                                        let _e5405 = -(_e5404);
                                        let _e5407 = local_69;
                                        if (_e5407 > _e5405) {
                                            let _e6167 = local_81;
                                            phi_8100_ = _e6167;
                                        } else {
                                            phi_8100_ = _e5405;
                                        }
                                        let _e5410 = phi_8100_;
                                        let _e5415 = (((_e5410 - ((_e5399 * _e5060) * (0.000000059604645f * 17f))) - (_e5399 * _e5067)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e5298 > _e5415) {
                                            phi_8110_ = _e5298;
                                        } else {
                                            phi_8110_ = _e5415;
                                        }
                                        let _e5418 = phi_8110_;
                                        phi_8113_ = (_e5418 > 0f);
                                    }
                                    let _e5421 = phi_8113_;
                                    phi_8114_ = _e5421;
                                } else {
                                    phi_8114_ = false;
                                }
                                let _e5423 = phi_8114_;
                                phi_8116_ = !(_e5423);
                            }
                            let _e5426 = phi_8116_;
                            if _e5426 {
                                let _e5428 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1332] = ((2147483648u | (_e5428 << bitcast<u32>(12i))) | _e1335);
                            }
                        }
                        phi_8126_ = true;
                    }
                    let _e5435 = phi_8126_;
                    phi_8127_ = _e5435;
                } else {
                    phi_8127_ = false;
                }
                let _e5437 = phi_8127_;
                continue;
                continuing {
                    phi_1900_ = _e1324;
                    break if !(_e5437);
                }
            }
            workgroupBarrier();
            if (_e110 == 0u) {
                let _e5441 = atomicLoad((&counters[5u]));
                if (_e5441 > 0u) {
                    let _e5444 = atomicAdd((&output.member[0u]), _e5441);
                    if ((_e5444 + _e5441) < _e5444) {
                        let _e5448 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e5444);
                }
            }
            workgroupBarrier();
            let _e5451 = atomicLoad((&counters[6u]));
            if (_e110 == 0u) {
                let _e5454 = atomicLoad((&counters[7u]));
                if (_e5454 > 0u) {
                    let _e5457 = atomicAdd((&output.member[1u]), _e5454);
                    if ((_e5457 + _e5454) < _e5457) {
                        let _e5461 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_8177_ = type_36(0u, 16u);
            loop {
                let _e5463 = phi_8177_;
                if (_e5463.member < _e5463.member_1) {
                    phi_8178_ = type_36((_e5463.member + 1u), _e5463.member_1);
                    phi_8201_ = type_36(1u, _e5463.member);
                } else {
                    phi_8178_ = _e5463;
                    phi_8201_ = type_36(0u, type_36().member_1);
                }
                let _e5477 = phi_8178_;
                let _e5479 = phi_8201_;
                if (bitcast<i32>(_e5479.member) != 0i) {
                    let _e5485 = (_e110 + (_e5479.member_1 * 128u));
                    if (_e5485 >= _e1308) {
                        phi_8299_ = false;
                    } else {
                        let _e5488 = hits[_e5485];
                        if ((_e5488 & 2147483648u) == 0u) {
                            phi_8224_ = 4294967295u;
                        } else {
                            phi_8224_ = ((_e5488 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e5495 = phi_8224_;
                        if (_e5495 != 4294967295u) {
                            let _e5499 = ((_e5488 >> bitcast<u32>(10i)) & 3u);
                            let _e5506 = firsts[(2u * _e5499)];
                            let _e5509 = leaves.member[(_e5506 + ((_e5488 >> bitcast<u32>(5i)) & 31u))];
                            let _e5513 = firsts[((2u * _e5499) + 1u)];
                            let _e5516 = leaves.member[(_e5513 + (_e5488 & 31u))];
                            let _e5520 = params.member.member_16;
                            let _e5521 = (_e5451 + _e5495);
                            if (_e5521 < _e5520) {
                                atomicStore((&output.member[(4u + (2u * _e5521))]), _e5509.member_1);
                                atomicStore((&output.member[((2u * _e5521) + 5u)]), _e5516.member_1);
                            }
                        }
                        phi_8299_ = true;
                    }
                    let _e5530 = phi_8299_;
                    phi_8300_ = _e5530;
                } else {
                    phi_8300_ = false;
                }
                let _e5532 = phi_8300_;
                continue;
                continuing {
                    phi_8177_ = _e5477;
                    break if !(_e5532);
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
fn filter_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
