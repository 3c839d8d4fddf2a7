struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_11 {
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
    member_18: array<array<u32, 4>, 8>,
}

struct type_13 {
    member: type_11,
}

struct type_17 {
    member: array<type_6>,
}

struct type_21 {
    member: array<u32>,
}

struct type_23 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_26 {
    member: array<type_23>,
}

struct type_35 {
    member: u32,
    member_1: u32,
}

struct type_44 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_47 {
    member: array<type_44>,
}

struct type_63 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_70 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_78 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_13;
@group(0) @binding(1) 
var<storage> nodes: type_17;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_6, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(2) 
var<storage> leaves: type_26;
@group(0) @binding(3) 
var<storage> bodies: type_21;
@group(0) @binding(4) 
var<storage> keys: type_63;
@group(0) @binding(5) 
var<storage> paths: type_47;
@group(0) @binding(6) 
var<storage> input: type_21;
@group(0) @binding(7) 
var<storage, read_write> output: type_78;

fn function_() {
    var local: array<array<f32, 3>, 4>;
    var local_1: array<array<f32, 3>, 4>;
    var local_2: array<array<f32, 3>, 4>;
    var local_3: array<array<f32, 3>, 4>;
    var local_4: array<type_70, 2>;
    var local_5: array<array<f32, 3>, 4>;
    var local_6: array<array<f32, 3>, 4>;
    var local_7: type_70;
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
    var local_24: type_23;
    var local_25: type_23;
    var local_26: type_23;
    var local_27: type_23;
    var phi_232_: u32;
    var phi_270_: u32;
    var phi_271_: u32;
    var phi_278_: u32;
    var phi_294_: u32;
    var phi_315_: u32;
    var phi_316_: u32;
    var phi_319_: type_35;
    var phi_320_: type_35;
    var phi_343_: type_35;
    var phi_381_: u32;
    var phi_382_: u32;
    var phi_389_: u32;
    var phi_399_: u32;
    var phi_478_: array<u32, 2>;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_677_: type_6;
    var phi_690_: type_35;
    var phi_693_: u32;
    var phi_691_: type_35;
    var phi_716_: type_35;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_788_: bool;
    var phi_806_: u32;
    var phi_807_: u32;
    var phi_808_: u32;
    var phi_694_: u32;
    var phi_811_: type_35;
    var phi_814_: u32;
    var phi_812_: type_35;
    var phi_837_: type_35;
    var phi_983_: bool;
    var phi_984_: bool;
    var phi_985_: bool;
    var phi_986_: bool;
    var phi_987_: bool;
    var phi_991_: bool;
    var phi_947_: bool;
    var phi_948_: bool;
    var phi_949_: bool;
    var phi_953_: bool;
    var phi_992_: bool;
    var phi_996_: bool;
    var phi_997_: bool;
    var phi_1043_: bool;
    var phi_1053_: bool;
    var phi_1054_: bool;
    var phi_1058_: bool;
    var phi_1059_: bool;
    var phi_1108_: type_35;
    var phi_1111_: bool;
    var phi_1109_: type_35;
    var phi_1134_: type_35;
    var phi_1191_: type_35;
    var phi_1194_: array<u32, 2>;
    var phi_1192_: type_35;
    var phi_1217_: type_35;
    var phi_1292_: bool;
    var phi_1293_: bool;
    var phi_1297_: array<u32, 2>;
    var phi_1195_: array<u32, 2>;
    var phi_1348_: type_35;
    var phi_1351_: array<u32, 2>;
    var phi_1349_: type_35;
    var phi_1374_: type_35;
    var phi_1450_: bool;
    var phi_1451_: bool;
    var phi_1455_: array<u32, 2>;
    var phi_1352_: array<u32, 2>;
    var local_28: array<u32, 2>;
    var local_29: array<u32, 2>;
    var local_30: array<u32, 2>;
    var local_31: array<u32, 2>;
    var local_32: array<u32, 2>;
    var local_33: array<u32, 2>;
    var phi_1471_: bool;
    var phi_1472_: bool;
    var phi_1523_: type_35;
    var phi_1526_: array<u32, 2>;
    var phi_1524_: type_35;
    var phi_1549_: type_35;
    var phi_1624_: bool;
    var phi_1625_: bool;
    var phi_1629_: array<u32, 2>;
    var phi_1527_: array<u32, 2>;
    var phi_1680_: type_35;
    var phi_1683_: array<u32, 2>;
    var phi_1681_: type_35;
    var phi_1706_: type_35;
    var phi_1782_: bool;
    var phi_1783_: bool;
    var phi_1787_: array<u32, 2>;
    var phi_1684_: array<u32, 2>;
    var local_34: array<u32, 2>;
    var local_35: array<u32, 2>;
    var local_36: array<u32, 2>;
    var local_37: array<u32, 2>;
    var local_38: array<u32, 2>;
    var local_39: array<u32, 2>;
    var phi_1803_: bool;
    var phi_1804_: bool;
    var phi_1112_: bool;
    var phi_1808_: bool;
    var phi_1809_: bool;
    var phi_1810_: bool;
    var phi_1814_: bool;
    var phi_1815_: bool;
    var phi_1816_: bool;
    var phi_1817_: bool;
    var phi_1818_: bool;
    var phi_1822_: bool;
    var phi_1842_: type_35;
    var phi_1869_: u32;
    var phi_1870_: bool;
    var phi_815_: u32;
    var phi_1871_: bool;
    var phi_1878_: u32;
    var phi_1881_: type_35;
    var phi_1882_: type_35;
    var phi_1905_: type_35;
    var phi_2059_: bool;
    var phi_2060_: bool;
    var phi_2061_: bool;
    var phi_2062_: bool;
    var phi_2063_: bool;
    var phi_2067_: bool;
    var phi_2023_: bool;
    var phi_2024_: bool;
    var phi_2025_: bool;
    var phi_2029_: bool;
    var phi_2068_: bool;
    var phi_2072_: bool;
    var phi_2073_: bool;
    var phi_2119_: bool;
    var phi_2129_: bool;
    var phi_2130_: bool;
    var phi_2134_: bool;
    var phi_2135_: bool;
    var phi_2184_: type_35;
    var phi_2187_: bool;
    var phi_2185_: type_35;
    var phi_2210_: type_35;
    var phi_2267_: type_35;
    var phi_2270_: array<u32, 2>;
    var phi_2268_: type_35;
    var phi_2293_: type_35;
    var phi_2368_: bool;
    var phi_2369_: bool;
    var phi_2373_: array<u32, 2>;
    var phi_2271_: array<u32, 2>;
    var phi_2424_: type_35;
    var phi_2427_: array<u32, 2>;
    var phi_2425_: type_35;
    var phi_2450_: type_35;
    var phi_2526_: bool;
    var phi_2527_: bool;
    var phi_2531_: array<u32, 2>;
    var phi_2428_: array<u32, 2>;
    var local_40: array<u32, 2>;
    var local_41: array<u32, 2>;
    var local_42: array<u32, 2>;
    var local_43: array<u32, 2>;
    var local_44: array<u32, 2>;
    var local_45: array<u32, 2>;
    var phi_2547_: bool;
    var phi_2548_: bool;
    var phi_2599_: type_35;
    var phi_2602_: array<u32, 2>;
    var phi_2600_: type_35;
    var phi_2625_: type_35;
    var phi_2700_: bool;
    var phi_2701_: bool;
    var phi_2705_: array<u32, 2>;
    var phi_2603_: array<u32, 2>;
    var phi_2756_: type_35;
    var phi_2759_: array<u32, 2>;
    var phi_2757_: type_35;
    var phi_2782_: type_35;
    var phi_2858_: bool;
    var phi_2859_: bool;
    var phi_2863_: array<u32, 2>;
    var phi_2760_: array<u32, 2>;
    var local_46: array<u32, 2>;
    var local_47: array<u32, 2>;
    var local_48: array<u32, 2>;
    var local_49: array<u32, 2>;
    var local_50: array<u32, 2>;
    var local_51: array<u32, 2>;
    var phi_2879_: bool;
    var phi_2880_: bool;
    var phi_2188_: bool;
    var phi_2884_: bool;
    var phi_2885_: bool;
    var phi_2886_: bool;
    var phi_2890_: bool;
    var phi_2891_: bool;
    var phi_2892_: bool;
    var phi_2893_: bool;
    var phi_2894_: bool;
    var phi_2898_: bool;
    var phi_2944_: type_23;
    var phi_2945_: type_23;
    var phi_3334_: f32;
    var phi_3341_: f32;
    var phi_3346_: f32;
    var phi_3353_: f32;
    var phi_3358_: f32;
    var phi_3371_: f32;
    var phi_3378_: f32;
    var phi_3383_: f32;
    var phi_3390_: f32;
    var phi_3395_: f32;
    var phi_3400_: f32;
    var phi_3417_: f32;
    var phi_3424_: f32;
    var phi_3429_: f32;
    var phi_3436_: f32;
    var phi_3441_: f32;
    var phi_3455_: f32;
    var phi_3462_: f32;
    var phi_3467_: f32;
    var phi_3474_: f32;
    var phi_3479_: f32;
    var phi_3484_: f32;
    var phi_3501_: f32;
    var phi_3508_: f32;
    var phi_3513_: f32;
    var phi_3520_: f32;
    var phi_3525_: f32;
    var phi_3539_: f32;
    var phi_3546_: f32;
    var phi_3551_: f32;
    var phi_3558_: f32;
    var phi_3563_: f32;
    var phi_3568_: f32;
    var phi_3599_: f32;
    var phi_3605_: f32;
    var phi_3612_: f32;
    var phi_3619_: f32;
    var phi_3625_: f32;
    var phi_3632_: f32;
    var phi_3638_: f32;
    var phi_3644_: f32;
    var phi_3650_: f32;
    var phi_3657_: f32;
    var phi_3664_: f32;
    var phi_3688_: f32;
    var phi_3693_: f32;
    var phi_3698_: f32;
    var phi_3703_: f32;
    var phi_3708_: f32;
    var phi_3713_: f32;
    var phi_3723_: f32;
    var phi_3974_: f32;
    var phi_3981_: f32;
    var phi_3986_: f32;
    var phi_3993_: f32;
    var phi_3998_: f32;
    var phi_4011_: f32;
    var phi_4018_: f32;
    var phi_4023_: f32;
    var phi_4030_: f32;
    var phi_4035_: f32;
    var phi_4040_: f32;
    var phi_4057_: f32;
    var phi_4064_: f32;
    var phi_4069_: f32;
    var phi_4076_: f32;
    var phi_4081_: f32;
    var phi_4095_: f32;
    var phi_4102_: f32;
    var phi_4107_: f32;
    var phi_4114_: f32;
    var phi_4119_: f32;
    var phi_4124_: f32;
    var phi_4141_: f32;
    var phi_4148_: f32;
    var phi_4153_: f32;
    var phi_4160_: f32;
    var phi_4165_: f32;
    var phi_4179_: f32;
    var phi_4186_: f32;
    var phi_4191_: f32;
    var phi_4198_: f32;
    var phi_4203_: f32;
    var phi_4208_: f32;
    var phi_4246_: type_35;
    var phi_4249_: f32;
    var phi_4251_: f32;
    var phi_4247_: type_35;
    var phi_4274_: type_35;
    var phi_4324_: f32;
    var phi_4329_: f32;
    var phi_4334_: f32;
    var phi_4339_: f32;
    var phi_4250_: f32;
    var phi_4252_: f32;
    var phi_4345_: f32;
    var phi_4351_: f32;
    var phi_4358_: f32;
    var local_52: f32;
    var local_53: f32;
    var phi_4368_: f32;
    var phi_4399_: type_35;
    var phi_4402_: f32;
    var phi_4404_: f32;
    var phi_4400_: type_35;
    var phi_4427_: type_35;
    var phi_4477_: f32;
    var phi_4482_: f32;
    var phi_4487_: f32;
    var phi_4492_: f32;
    var phi_4403_: f32;
    var phi_4405_: f32;
    var phi_4498_: f32;
    var phi_4504_: f32;
    var phi_4511_: f32;
    var local_54: f32;
    var local_55: f32;
    var phi_4521_: f32;
    var phi_4531_: f32;
    var phi_4699_: bool;
    var phi_5156_: f32;
    var phi_5163_: f32;
    var phi_5168_: f32;
    var phi_5175_: f32;
    var phi_5180_: f32;
    var phi_5193_: f32;
    var phi_5200_: f32;
    var phi_5205_: f32;
    var phi_5212_: f32;
    var phi_5217_: f32;
    var phi_5222_: f32;
    var phi_5239_: f32;
    var phi_5246_: f32;
    var phi_5251_: f32;
    var phi_5258_: f32;
    var phi_5263_: f32;
    var phi_5277_: f32;
    var phi_5284_: f32;
    var phi_5289_: f32;
    var phi_5296_: f32;
    var phi_5301_: f32;
    var phi_5306_: f32;
    var phi_5323_: f32;
    var phi_5330_: f32;
    var phi_5335_: f32;
    var phi_5342_: f32;
    var phi_5347_: f32;
    var phi_5361_: f32;
    var phi_5368_: f32;
    var phi_5373_: f32;
    var phi_5380_: f32;
    var phi_5385_: f32;
    var phi_5390_: f32;
    var phi_5421_: f32;
    var phi_5427_: f32;
    var phi_5434_: f32;
    var phi_5441_: f32;
    var phi_5447_: f32;
    var phi_5454_: f32;
    var phi_5460_: f32;
    var phi_5466_: f32;
    var phi_5472_: f32;
    var phi_5479_: f32;
    var phi_5486_: f32;
    var phi_5510_: f32;
    var phi_5515_: f32;
    var phi_5520_: f32;
    var phi_5525_: f32;
    var phi_5530_: f32;
    var phi_5535_: f32;
    var phi_5545_: f32;
    var phi_5796_: f32;
    var phi_5803_: f32;
    var phi_5808_: f32;
    var phi_5815_: f32;
    var phi_5820_: f32;
    var phi_5833_: f32;
    var phi_5840_: f32;
    var phi_5845_: f32;
    var phi_5852_: f32;
    var phi_5857_: f32;
    var phi_5862_: f32;
    var phi_5879_: f32;
    var phi_5886_: f32;
    var phi_5891_: f32;
    var phi_5898_: f32;
    var phi_5903_: f32;
    var phi_5917_: f32;
    var phi_5924_: f32;
    var phi_5929_: f32;
    var phi_5936_: f32;
    var phi_5941_: f32;
    var phi_5946_: f32;
    var phi_5963_: f32;
    var phi_5970_: f32;
    var phi_5975_: f32;
    var phi_5982_: f32;
    var phi_5987_: f32;
    var phi_6001_: f32;
    var phi_6008_: f32;
    var phi_6013_: f32;
    var phi_6020_: f32;
    var phi_6025_: f32;
    var phi_6030_: f32;
    var phi_6068_: type_35;
    var phi_6071_: f32;
    var phi_6073_: f32;
    var phi_6069_: type_35;
    var phi_6096_: type_35;
    var phi_6146_: f32;
    var phi_6151_: f32;
    var phi_6156_: f32;
    var phi_6161_: f32;
    var phi_6072_: f32;
    var phi_6074_: f32;
    var phi_6167_: f32;
    var phi_6173_: f32;
    var phi_6180_: f32;
    var local_56: f32;
    var local_57: f32;
    var phi_6190_: f32;
    var phi_6221_: type_35;
    var phi_6224_: f32;
    var phi_6226_: f32;
    var phi_6222_: type_35;
    var phi_6249_: type_35;
    var phi_6299_: f32;
    var phi_6304_: f32;
    var phi_6309_: f32;
    var phi_6314_: f32;
    var phi_6225_: f32;
    var phi_6227_: f32;
    var phi_6320_: f32;
    var phi_6326_: f32;
    var phi_6333_: f32;
    var local_58: f32;
    var local_59: f32;
    var phi_6343_: f32;
    var phi_6353_: f32;
    var phi_6521_: bool;
    var phi_6767_: f32;
    var phi_6774_: f32;
    var phi_6779_: f32;
    var phi_6786_: f32;
    var phi_6791_: f32;
    var phi_6804_: f32;
    var phi_6811_: f32;
    var phi_6816_: f32;
    var phi_6823_: f32;
    var phi_6828_: f32;
    var phi_6833_: f32;
    var phi_6850_: f32;
    var phi_6857_: f32;
    var phi_6862_: f32;
    var phi_6869_: f32;
    var phi_6874_: f32;
    var phi_6888_: f32;
    var phi_6895_: f32;
    var phi_6900_: f32;
    var phi_6907_: f32;
    var phi_6912_: f32;
    var phi_6917_: f32;
    var phi_6934_: f32;
    var phi_6941_: f32;
    var phi_6946_: f32;
    var phi_6953_: f32;
    var phi_6958_: f32;
    var phi_6972_: f32;
    var phi_6979_: f32;
    var phi_6984_: f32;
    var phi_6991_: f32;
    var phi_6996_: f32;
    var phi_7001_: f32;
    var phi_7032_: f32;
    var phi_7038_: f32;
    var phi_7045_: f32;
    var phi_7052_: f32;
    var phi_7058_: f32;
    var phi_7065_: f32;
    var phi_7071_: f32;
    var phi_7077_: f32;
    var phi_7083_: f32;
    var phi_7090_: f32;
    var phi_7097_: f32;
    var phi_7121_: f32;
    var phi_7126_: f32;
    var phi_7131_: f32;
    var phi_7136_: f32;
    var phi_7141_: f32;
    var phi_7146_: f32;
    var phi_7156_: f32;
    var phi_7407_: f32;
    var phi_7414_: f32;
    var phi_7419_: f32;
    var phi_7426_: f32;
    var phi_7431_: f32;
    var phi_7444_: f32;
    var phi_7451_: f32;
    var phi_7456_: f32;
    var phi_7463_: f32;
    var phi_7468_: f32;
    var phi_7473_: f32;
    var phi_7490_: f32;
    var phi_7497_: f32;
    var phi_7502_: f32;
    var phi_7509_: f32;
    var phi_7514_: f32;
    var phi_7528_: f32;
    var phi_7535_: f32;
    var phi_7540_: f32;
    var phi_7547_: f32;
    var phi_7552_: f32;
    var phi_7557_: f32;
    var phi_7574_: f32;
    var phi_7581_: f32;
    var phi_7586_: f32;
    var phi_7593_: f32;
    var phi_7598_: f32;
    var phi_7612_: f32;
    var phi_7619_: f32;
    var phi_7624_: f32;
    var phi_7631_: f32;
    var phi_7636_: f32;
    var phi_7641_: f32;
    var phi_7679_: type_35;
    var phi_7682_: f32;
    var phi_7684_: f32;
    var phi_7680_: type_35;
    var phi_7707_: type_35;
    var phi_7757_: f32;
    var phi_7762_: f32;
    var phi_7767_: f32;
    var phi_7772_: f32;
    var phi_7683_: f32;
    var phi_7685_: f32;
    var phi_7778_: f32;
    var phi_7784_: f32;
    var phi_7791_: f32;
    var local_60: f32;
    var local_61: f32;
    var phi_7801_: f32;
    var phi_7832_: type_35;
    var phi_7835_: f32;
    var phi_7837_: f32;
    var phi_7833_: type_35;
    var phi_7860_: type_35;
    var phi_7910_: f32;
    var phi_7915_: f32;
    var phi_7920_: f32;
    var phi_7925_: f32;
    var phi_7836_: f32;
    var phi_7838_: f32;
    var phi_7931_: f32;
    var phi_7937_: f32;
    var phi_7944_: f32;
    var local_62: f32;
    var local_63: f32;
    var phi_7954_: f32;
    var phi_7964_: f32;
    var phi_8132_: bool;
    var phi_8133_: bool;
    var phi_8135_: bool;
    var phi_8145_: bool;
    var phi_8146_: bool;
    var phi_8178_: type_35;
    var phi_8179_: type_35;
    var phi_8202_: type_35;
    var phi_8225_: u32;
    var phi_8279_: type_35;
    var phi_8300_: bool;
    var phi_8301_: bool;
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
        phi_232_ = _e128;
    } else {
        phi_232_ = _e130;
    }
    let _e133 = phi_232_;
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
            phi_270_ = (_e145 + 1u);
        } else {
            phi_270_ = _e145;
        }
        let _e151 = phi_270_;
        phi_271_ = _e151;
    } else {
        phi_271_ = 0u;
    }
    let _e153 = phi_271_;
    let _e155 = params.member.member_14;
    if (_e155 < _e153) {
        phi_278_ = _e155;
    } else {
        phi_278_ = _e153;
    }
    let _e158 = phi_278_;
    let _e159 = (_e158 / 4u);
    if ((_e158 % 4u) > 0u) {
        phi_294_ = (_e159 + 1u);
    } else {
        phi_294_ = _e159;
    }
    let _e164 = phi_294_;
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
            phi_315_ = (_e168 + 1u);
        } else {
            phi_315_ = _e168;
        }
        let _e174 = phi_315_;
        phi_316_ = _e174;
    } else {
        phi_316_ = 0u;
    }
    let _e176 = phi_316_;
    phi_319_ = type_35(0u, _e176);
    loop {
        let _e179 = phi_319_;
        if (_e179.member < _e179.member_1) {
            phi_320_ = type_35((_e179.member + 1u), _e179.member_1);
            phi_343_ = type_35(1u, _e179.member);
        } else {
            phi_320_ = _e179;
            phi_343_ = type_35(0u, type_35().member_1);
        }
        let _e193 = phi_320_;
        let _e195 = phi_343_;
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
                    phi_381_ = (_e213 + 1u);
                } else {
                    phi_381_ = _e213;
                }
                let _e219 = phi_381_;
                phi_382_ = _e219;
            } else {
                phi_382_ = 0u;
            }
            let _e221 = phi_382_;
            let _e223 = params.member.member_14;
            if (_e223 < _e221) {
                phi_389_ = _e223;
            } else {
                phi_389_ = _e221;
            }
            let _e226 = phi_389_;
            let _e227 = (_e203 < _e226);
            let _e229 = params.member.member_12;
            if _e227 {
                let _e231 = params.member.member_13;
                phi_399_ = (_e203 * _e231);
            } else {
                phi_399_ = 0u;
            }
            let _e234 = phi_399_;
            let _e236 = (2u * (_e229 + _e234));
            let _e239 = input.member[(4u + _e236)];
            let _e242 = input.member[(_e236 + 5u)];
            if (_e110 < 8u) {
                atomicStore((&counters[_e110]), 0u);
            }
            workgroupBarrier();
            let _e249 = params.member.member_18[0u][1u];
            let _e250 = (_e249 + (_e239 * 32u));
            let _e255 = params.member.member_18[0u][1u];
            let _e256 = (_e255 + (_e242 * 32u));
            if (_e135 == 0u) {
                firsts[(2u * _e134)] = _e250;
                firsts[((2u * _e134) + 1u)] = _e256;
            }
            let _e264 = params.member.member_8;
            if (_e264 == 0u) {
                phi_478_ = array<u32, 2>(0u, 2u);
            } else {
                phi_478_ = array<u32, 2>(1u, 1u);
            }
            let _e267 = phi_478_;
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
            let _e279 = params.member.member_18[_e273][_e267[0]];
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
            let _e290 = params.member.member_18[_e284][_e267[1]];
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
            let _e304 = params.member.member_18[_e296][_e267[0]];
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
            let _e318 = params.member.member_18[_e310][_e267[1]];
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
                    phi_672_ = false;
                } else {
                    phi_672_ = true;
                }
                let _e410 = phi_672_;
                phi_673_ = _e410;
            } else {
                phi_673_ = true;
            }
            let _e412 = phi_673_;
            if _e412 {
                phi_677_ = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_677_ = _e307;
            }
            let _e414 = phi_677_;
            let _e416 = (_e110 / 32u);
            let _e417 = (_e110 % 32u);
            let _e419 = atomicLoad((&counters[_e416]));
            phi_690_ = type_35(0u, _e419);
            phi_693_ = 0u;
            loop {
                let _e422 = phi_690_;
                let _e424 = phi_693_;
                local_64 = _e424;
                if (_e422.member < _e422.member_1) {
                    phi_691_ = type_35((_e422.member + 1u), _e422.member_1);
                    phi_716_ = type_35(1u, _e422.member);
                } else {
                    phi_691_ = _e422;
                    phi_716_ = type_35(0u, type_35().member_1);
                }
                let _e438 = phi_691_;
                let _e440 = phi_716_;
                let _e444 = (bitcast<i32>(_e440.member) != 0i);
                if _e444 {
                    let _e448 = names[((_e416 * 32u) + _e440.member_1)];
                    let _e452 = columns[((_e416 * 32u) + _e440.member_1)];
                    if ((((((_e414.member[0] <= _e452.member_1[0]) && (_e452.member[0] <= _e414.member_1[0])) && (_e414.member[1] <= _e452.member_1[1])) && (_e452.member[1] <= _e414.member_1[1])) && (_e414.member[2] <= _e452.member_1[2])) && (_e452.member[2] <= _e414.member_1[2])) {
                        if (_e239 == _e242) {
                            let _e484 = (_e417 < _e448);
                            if _e484 {
                                phi_782_ = bool();
                            } else {
                                phi_782_ = false;
                            }
                            let _e486 = phi_782_;
                            phi_783_ = _e486;
                            phi_784_ = _e484;
                        } else {
                            phi_783_ = bool();
                            phi_784_ = true;
                        }
                        let _e488 = phi_783_;
                        let _e490 = phi_784_;
                        if _e490 {
                            phi_788_ = true;
                        } else {
                            phi_788_ = _e488;
                        }
                        let _e492 = phi_788_;
                        if _e492 {
                            let _e494 = atomicAdd((&counters[4u]), 1u);
                            if (_e494 < 2048u) {
                                hits[_e494] = (((_e416 << bitcast<u32>(10i)) | (_e417 << bitcast<u32>(5i))) | _e448);
                                phi_806_ = _e424;
                            } else {
                                phi_806_ = (_e424 | (1u << bitcast<u32>((_e440.member_1 & 31u))));
                            }
                            let _e508 = phi_806_;
                            phi_807_ = _e508;
                        } else {
                            phi_807_ = _e424;
                        }
                        let _e510 = phi_807_;
                        phi_808_ = _e510;
                    } else {
                        phi_808_ = _e424;
                    }
                    let _e512 = phi_808_;
                    phi_694_ = _e512;
                } else {
                    phi_694_ = u32();
                }
                let _e514 = phi_694_;
                continue;
                continuing {
                    phi_690_ = _e438;
                    phi_693_ = _e514;
                    break if !(_e444);
                }
            }
            phi_811_ = type_35(0u, 32u);
            let _e5247 = local_64;
            phi_814_ = _e5247;
            loop {
                let _e517 = phi_811_;
                let _e519 = phi_814_;
                if (_e517.member < _e517.member_1) {
                    phi_812_ = type_35((_e517.member + 1u), _e517.member_1);
                    phi_837_ = type_35(1u, _e517.member);
                } else {
                    phi_812_ = _e517;
                    phi_837_ = type_35(0u, type_35().member_1);
                }
                let _e533 = phi_812_;
                let _e535 = phi_837_;
                if (bitcast<i32>(_e535.member) != 0i) {
                    if (_e519 == 0u) {
                        phi_1869_ = u32();
                        phi_1870_ = false;
                    } else {
                        let _e546 = names[((_e134 * 32u) + select(firstTrailingBit(_e519), 32u, (_e519 == 0u)))];
                        let _e549 = (_e250 + _e135);
                        let _e550 = (_e256 + _e546);
                        let _e552 = leaves.member[_e549];
                        let _e554 = leaves.member[_e550];
                        local_24 = type_23(array<u32, 3>(_e552.member[0], _e552.member[1], _e552.member[2]), _e552.member_1);
                        local_25 = type_23(array<u32, 3>(_e554.member[0], _e554.member[1], _e554.member[2]), _e554.member_1);
                        let _e570 = nodes.member[_e549];
                        let _e572 = nodes.member[_e550];
                        let _e574 = params.member.member_1;
                        if ((_e574 & 1u) != 0u) {
                            let _e578 = params.member.member_8;
                            if (_e578 == 0u) {
                                let _e622 = local_24.member[0u];
                                let _e625 = local_25.member[0u];
                                if (_e622 == _e625) {
                                    phi_948_ = bool();
                                    phi_949_ = true;
                                } else {
                                    let _e629 = local_24.member[0u];
                                    let _e632 = local_25.member[1u];
                                    let _e633 = (_e629 == _e632);
                                    if _e633 {
                                        phi_947_ = bool();
                                    } else {
                                        let _e636 = local_24.member[0u];
                                        let _e639 = local_25.member[2u];
                                        phi_947_ = (_e636 == _e639);
                                    }
                                    let _e642 = phi_947_;
                                    phi_948_ = _e642;
                                    phi_949_ = _e633;
                                }
                                let _e644 = phi_948_;
                                let _e646 = phi_949_;
                                if _e646 {
                                    phi_953_ = true;
                                } else {
                                    phi_953_ = _e644;
                                }
                                let _e648 = phi_953_;
                                phi_992_ = _e648;
                            } else {
                                let _e582 = local_24.member[0u];
                                let _e585 = local_25.member[0u];
                                if (_e582 == _e585) {
                                    phi_986_ = bool();
                                    phi_987_ = true;
                                } else {
                                    let _e589 = local_24.member[0u];
                                    let _e592 = local_25.member[1u];
                                    if (_e589 == _e592) {
                                        phi_984_ = bool();
                                        phi_985_ = true;
                                    } else {
                                        let _e596 = local_24.member[1u];
                                        let _e599 = local_25.member[0u];
                                        let _e600 = (_e596 == _e599);
                                        if _e600 {
                                            phi_983_ = bool();
                                        } else {
                                            let _e603 = local_24.member[1u];
                                            let _e606 = local_25.member[1u];
                                            phi_983_ = (_e603 == _e606);
                                        }
                                        let _e609 = phi_983_;
                                        phi_984_ = _e609;
                                        phi_985_ = _e600;
                                    }
                                    let _e611 = phi_984_;
                                    let _e613 = phi_985_;
                                    phi_986_ = _e611;
                                    phi_987_ = _e613;
                                }
                                let _e615 = phi_986_;
                                let _e617 = phi_987_;
                                if _e617 {
                                    phi_991_ = true;
                                } else {
                                    phi_991_ = _e615;
                                }
                                let _e619 = phi_991_;
                                phi_992_ = _e619;
                            }
                            let _e650 = phi_992_;
                            if _e650 {
                                phi_996_ = false;
                            } else {
                                phi_996_ = true;
                            }
                            let _e652 = phi_996_;
                            phi_997_ = _e652;
                        } else {
                            phi_997_ = true;
                        }
                        let _e654 = phi_997_;
                        if _e654 {
                            let _e656 = params.member.member_1;
                            if ((_e656 & 2u) != 0u) {
                                let _e661 = local_24.member[0u];
                                let _e663 = bodies.member[_e661];
                                let _e666 = local_25.member[0u];
                                let _e668 = bodies.member[_e666];
                                if ((_e663 / 2u) == (_e668 / 2u)) {
                                    let _e673 = params.member.member_1;
                                    phi_1043_ = !(((_e673 & 4u) != 0u));
                                } else {
                                    phi_1043_ = false;
                                }
                                let _e678 = phi_1043_;
                                if _e678 {
                                    phi_1054_ = true;
                                } else {
                                    if (((_e663 & _e668) & 1u) == 0u) {
                                        phi_1053_ = false;
                                    } else {
                                        phi_1053_ = true;
                                    }
                                    let _e683 = phi_1053_;
                                    phi_1054_ = _e683;
                                }
                                let _e685 = phi_1054_;
                                if _e685 {
                                    phi_1058_ = false;
                                } else {
                                    phi_1058_ = true;
                                }
                                let _e687 = phi_1058_;
                                phi_1059_ = _e687;
                            } else {
                                phi_1059_ = true;
                            }
                            let _e689 = phi_1059_;
                            if _e689 {
                                let _e691 = params.member.member_1;
                                if ((_e691 & 32u) != 0u) {
                                    let _e695 = params.member.member_6;
                                    let _e736 = (((((((_e570.member_1[0] - _e572.member[0]) > _e695) && ((_e572.member_1[0] - _e570.member[0]) > _e695)) && ((_e570.member_1[1] - _e572.member[1]) > _e695)) && ((_e572.member_1[1] - _e570.member[1]) > _e695)) && ((_e570.member_1[2] - _e572.member[2]) > _e695)) && ((_e572.member_1[2] - _e570.member[2]) > _e695));
                                    if _e736 {
                                        phi_1808_ = bool();
                                    } else {
                                        phi_1108_ = type_35(0u, 3u);
                                        phi_1111_ = true;
                                        loop {
                                            let _e740 = phi_1108_;
                                            let _e742 = phi_1111_;
                                            local_65 = _e742;
                                            if (_e740.member < _e740.member_1) {
                                                phi_1109_ = type_35((_e740.member + 1u), _e740.member_1);
                                                phi_1134_ = type_35(1u, _e740.member);
                                            } else {
                                                phi_1109_ = _e740;
                                                phi_1134_ = type_35(0u, type_35().member_1);
                                            }
                                            let _e756 = phi_1109_;
                                            let _e758 = phi_1134_;
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
                                                phi_1191_ = type_35(1u, 3u);
                                                phi_1194_ = array<u32, 2>(_e794[0], _e794[1]);
                                                loop {
                                                    let _e799 = phi_1191_;
                                                    let _e801 = phi_1194_;
                                                    local_28 = _e801;
                                                    local_30 = _e801;
                                                    local_32 = _e801;
                                                    if (_e799.member < _e799.member_1) {
                                                        phi_1192_ = type_35((_e799.member + 1u), _e799.member_1);
                                                        phi_1217_ = type_35(1u, _e799.member);
                                                    } else {
                                                        phi_1192_ = _e799;
                                                        phi_1217_ = type_35(0u, type_35().member_1);
                                                    }
                                                    let _e815 = phi_1192_;
                                                    let _e817 = phi_1217_;
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
                                                            phi_1293_ = true;
                                                        } else {
                                                            if (_e801[1] == _e854[1]) {
                                                                phi_1292_ = (_e801[0] > _e854[0]);
                                                            } else {
                                                                phi_1292_ = false;
                                                            }
                                                            let _e865 = phi_1292_;
                                                            phi_1293_ = _e865;
                                                        }
                                                        let _e867 = phi_1293_;
                                                        if _e867 {
                                                            phi_1297_ = array<u32, 2>(_e854[0], _e854[1]);
                                                        } else {
                                                            phi_1297_ = _e801;
                                                        }
                                                        let _e869 = phi_1297_;
                                                        phi_1195_ = _e869;
                                                    } else {
                                                        phi_1195_ = array<u32, 2>();
                                                    }
                                                    let _e871 = phi_1195_;
                                                    continue;
                                                    continuing {
                                                        phi_1191_ = _e815;
                                                        phi_1194_ = _e871;
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
                                                phi_1348_ = type_35(1u, 3u);
                                                phi_1351_ = array<u32, 2>(_e905[0], _e905[1]);
                                                loop {
                                                    let _e910 = phi_1348_;
                                                    let _e912 = phi_1351_;
                                                    local_29 = _e912;
                                                    local_31 = _e912;
                                                    local_33 = _e912;
                                                    if (_e910.member < _e910.member_1) {
                                                        phi_1349_ = type_35((_e910.member + 1u), _e910.member_1);
                                                        phi_1374_ = type_35(1u, _e910.member);
                                                    } else {
                                                        phi_1349_ = _e910;
                                                        phi_1374_ = type_35(0u, type_35().member_1);
                                                    }
                                                    let _e926 = phi_1349_;
                                                    let _e928 = phi_1374_;
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
                                                            phi_1451_ = true;
                                                        } else {
                                                            if (_e966[1] == _e912[1]) {
                                                                phi_1450_ = (_e966[0] > _e912[0]);
                                                            } else {
                                                                phi_1450_ = false;
                                                            }
                                                            let _e977 = phi_1450_;
                                                            phi_1451_ = _e977;
                                                        }
                                                        let _e979 = phi_1451_;
                                                        if _e979 {
                                                            phi_1455_ = array<u32, 2>(_e966[0], _e966[1]);
                                                        } else {
                                                            phi_1455_ = _e912;
                                                        }
                                                        let _e981 = phi_1455_;
                                                        phi_1352_ = _e981;
                                                    } else {
                                                        phi_1352_ = array<u32, 2>();
                                                    }
                                                    let _e983 = phi_1352_;
                                                    continue;
                                                    continuing {
                                                        phi_1348_ = _e926;
                                                        phi_1351_ = _e983;
                                                        break if !(_e932);
                                                    }
                                                }
                                                let _e986 = local_28;
                                                let _e989 = local_29;
                                                if (_e986[1] > _e989[1]) {
                                                    phi_1472_ = true;
                                                } else {
                                                    let _e993 = local_30;
                                                    let _e996 = local_31;
                                                    if (_e993[1] == _e996[1]) {
                                                        let _e1000 = local_32;
                                                        let _e1003 = local_33;
                                                        phi_1471_ = (_e1000[0] > _e1003[0]);
                                                    } else {
                                                        phi_1471_ = false;
                                                    }
                                                    let _e1007 = phi_1471_;
                                                    phi_1472_ = _e1007;
                                                }
                                                let _e1009 = phi_1472_;
                                                let _e1012 = local_25.member[0u];
                                                let _e1014 = keys.member[_e1012];
                                                local_18 = array<array<u32, 2>, 6>(array<u32, 2>(_e1014[0][0], _e1014[0][1]), array<u32, 2>(_e1014[1][0], _e1014[1][1]), array<u32, 2>(_e1014[2][0], _e1014[2][1]), array<u32, 2>(_e1014[3][0], _e1014[3][1]), array<u32, 2>(_e1014[4][0], _e1014[4][1]), array<u32, 2>(_e1014[5][0], _e1014[5][1]));
                                                if (_e758.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1042 = local_18[_e758.member_1];
                                                phi_1523_ = type_35(1u, 3u);
                                                phi_1526_ = array<u32, 2>(_e1042[0], _e1042[1]);
                                                loop {
                                                    let _e1047 = phi_1523_;
                                                    let _e1049 = phi_1526_;
                                                    local_34 = _e1049;
                                                    local_36 = _e1049;
                                                    local_38 = _e1049;
                                                    if (_e1047.member < _e1047.member_1) {
                                                        phi_1524_ = type_35((_e1047.member + 1u), _e1047.member_1);
                                                        phi_1549_ = type_35(1u, _e1047.member);
                                                    } else {
                                                        phi_1524_ = _e1047;
                                                        phi_1549_ = type_35(0u, type_35().member_1);
                                                    }
                                                    let _e1063 = phi_1524_;
                                                    let _e1065 = phi_1549_;
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
                                                            phi_1625_ = true;
                                                        } else {
                                                            if (_e1049[1] == _e1102[1]) {
                                                                phi_1624_ = (_e1049[0] > _e1102[0]);
                                                            } else {
                                                                phi_1624_ = false;
                                                            }
                                                            let _e1113 = phi_1624_;
                                                            phi_1625_ = _e1113;
                                                        }
                                                        let _e1115 = phi_1625_;
                                                        if _e1115 {
                                                            phi_1629_ = array<u32, 2>(_e1102[0], _e1102[1]);
                                                        } else {
                                                            phi_1629_ = _e1049;
                                                        }
                                                        let _e1117 = phi_1629_;
                                                        phi_1527_ = _e1117;
                                                    } else {
                                                        phi_1527_ = array<u32, 2>();
                                                    }
                                                    let _e1119 = phi_1527_;
                                                    continue;
                                                    continuing {
                                                        phi_1523_ = _e1063;
                                                        phi_1526_ = _e1119;
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
                                                phi_1680_ = type_35(1u, 3u);
                                                phi_1683_ = array<u32, 2>(_e1153[0], _e1153[1]);
                                                loop {
                                                    let _e1158 = phi_1680_;
                                                    let _e1160 = phi_1683_;
                                                    local_35 = _e1160;
                                                    local_37 = _e1160;
                                                    local_39 = _e1160;
                                                    if (_e1158.member < _e1158.member_1) {
                                                        phi_1681_ = type_35((_e1158.member + 1u), _e1158.member_1);
                                                        phi_1706_ = type_35(1u, _e1158.member);
                                                    } else {
                                                        phi_1681_ = _e1158;
                                                        phi_1706_ = type_35(0u, type_35().member_1);
                                                    }
                                                    let _e1174 = phi_1681_;
                                                    let _e1176 = phi_1706_;
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
                                                            phi_1783_ = true;
                                                        } else {
                                                            if (_e1214[1] == _e1160[1]) {
                                                                phi_1782_ = (_e1214[0] > _e1160[0]);
                                                            } else {
                                                                phi_1782_ = false;
                                                            }
                                                            let _e1225 = phi_1782_;
                                                            phi_1783_ = _e1225;
                                                        }
                                                        let _e1227 = phi_1783_;
                                                        if _e1227 {
                                                            phi_1787_ = array<u32, 2>(_e1214[0], _e1214[1]);
                                                        } else {
                                                            phi_1787_ = _e1160;
                                                        }
                                                        let _e1229 = phi_1787_;
                                                        phi_1684_ = _e1229;
                                                    } else {
                                                        phi_1684_ = array<u32, 2>();
                                                    }
                                                    let _e1231 = phi_1684_;
                                                    continue;
                                                    continuing {
                                                        phi_1680_ = _e1174;
                                                        phi_1683_ = _e1231;
                                                        break if !(_e1180);
                                                    }
                                                }
                                                let _e1234 = local_34;
                                                let _e1237 = local_35;
                                                if (_e1234[1] > _e1237[1]) {
                                                    phi_1804_ = true;
                                                } else {
                                                    let _e1241 = local_36;
                                                    let _e1244 = local_37;
                                                    if (_e1241[1] == _e1244[1]) {
                                                        let _e1248 = local_38;
                                                        let _e1251 = local_39;
                                                        phi_1803_ = (_e1248[0] > _e1251[0]);
                                                    } else {
                                                        phi_1803_ = false;
                                                    }
                                                    let _e1255 = phi_1803_;
                                                    phi_1804_ = _e1255;
                                                }
                                                let _e1257 = phi_1804_;
                                                phi_1112_ = (_e742 && (!(_e1009) && !(_e1257)));
                                            } else {
                                                phi_1112_ = bool();
                                            }
                                            let _e1262 = phi_1112_;
                                            continue;
                                            continuing {
                                                phi_1108_ = _e756;
                                                phi_1111_ = _e1262;
                                                break if !(_e762);
                                            }
                                        }
                                        let _e5323 = local_65;
                                        phi_1808_ = _e5323;
                                    }
                                    let _e1265 = phi_1808_;
                                    phi_1809_ = _e1265;
                                    phi_1810_ = _e736;
                                } else {
                                    phi_1809_ = bool();
                                    phi_1810_ = true;
                                }
                                let _e1267 = phi_1809_;
                                let _e1269 = phi_1810_;
                                if _e1269 {
                                    phi_1814_ = false;
                                } else {
                                    phi_1814_ = true;
                                }
                                let _e1271 = phi_1814_;
                                phi_1815_ = _e1267;
                                phi_1816_ = _e1271;
                            } else {
                                phi_1815_ = false;
                                phi_1816_ = true;
                            }
                            let _e1273 = phi_1815_;
                            let _e1275 = phi_1816_;
                            phi_1817_ = _e1273;
                            phi_1818_ = _e1275;
                        } else {
                            phi_1817_ = false;
                            phi_1818_ = true;
                        }
                        let _e1277 = phi_1817_;
                        let _e1279 = phi_1818_;
                        if _e1279 {
                            phi_1822_ = _e1277;
                        } else {
                            phi_1822_ = true;
                        }
                        let _e1281 = phi_1822_;
                        if _e1281 {
                            let _e1283 = params.member.member_16;
                            let _e1285 = local_24.member_1;
                            let _e1287 = local_25.member_1;
                            if (_e1285 < _e1287) {
                                phi_1842_ = type_35(_e1285, _e1287);
                            } else {
                                phi_1842_ = type_35(_e1287, _e1285);
                            }
                            let _e1292 = phi_1842_;
                            let _e1296 = atomicAdd((&output.member[0u]), 1u);
                            if (_e1296 < _e1283) {
                                atomicStore((&output.member[(4u + (2u * _e1296))]), _e1292.member);
                                atomicStore((&output.member[((2u * _e1296) + 5u)]), _e1292.member_1);
                            }
                            let _e1305 = atomicAdd((&output.member[1u]), 1u);
                        }
                        phi_1869_ = (_e519 & (_e519 - 1u));
                        phi_1870_ = true;
                    }
                    let _e1307 = phi_1869_;
                    let _e1309 = phi_1870_;
                    phi_815_ = _e1307;
                    phi_1871_ = _e1309;
                } else {
                    phi_815_ = u32();
                    phi_1871_ = false;
                }
                let _e1311 = phi_815_;
                let _e1313 = phi_1871_;
                continue;
                continuing {
                    phi_811_ = _e533;
                    phi_814_ = _e1311;
                    break if !(_e1313);
                }
            }
            workgroupBarrier();
            let _e1316 = atomicLoad((&counters[4u]));
            if (2048u < _e1316) {
                phi_1878_ = 2048u;
            } else {
                phi_1878_ = _e1316;
            }
            let _e1319 = phi_1878_;
            phi_1881_ = type_35(0u, 16u);
            loop {
                let _e1321 = phi_1881_;
                if (_e1321.member < _e1321.member_1) {
                    phi_1882_ = type_35((_e1321.member + 1u), _e1321.member_1);
                    phi_1905_ = type_35(1u, _e1321.member);
                } else {
                    phi_1882_ = _e1321;
                    phi_1905_ = type_35(0u, type_35().member_1);
                }
                let _e1335 = phi_1882_;
                let _e1337 = phi_1905_;
                if (bitcast<i32>(_e1337.member) != 0i) {
                    let _e1343 = (_e110 + (_e1337.member_1 * 128u));
                    if (_e1343 >= _e1319) {
                        phi_8145_ = false;
                    } else {
                        let _e1346 = hits[_e1343];
                        let _e1349 = ((_e1346 >> bitcast<u32>(10i)) & 3u);
                        let _e1356 = firsts[(2u * _e1349)];
                        let _e1357 = (_e1356 + ((_e1346 >> bitcast<u32>(5i)) & 31u));
                        let _e1361 = firsts[((2u * _e1349) + 1u)];
                        let _e1362 = (_e1361 + (_e1346 & 31u));
                        let _e1364 = leaves.member[_e1357];
                        let _e1366 = leaves.member[_e1362];
                        local_26 = type_23(array<u32, 3>(_e1364.member[0], _e1364.member[1], _e1364.member[2]), _e1364.member_1);
                        local_27 = type_23(array<u32, 3>(_e1366.member[0], _e1366.member[1], _e1366.member[2]), _e1366.member_1);
                        let _e1382 = nodes.member[_e1357];
                        let _e1384 = nodes.member[_e1362];
                        let _e1386 = params.member.member_1;
                        if ((_e1386 & 1u) != 0u) {
                            let _e1390 = params.member.member_8;
                            if (_e1390 == 0u) {
                                let _e1434 = local_26.member[0u];
                                let _e1437 = local_27.member[0u];
                                if (_e1434 == _e1437) {
                                    phi_2024_ = bool();
                                    phi_2025_ = true;
                                } else {
                                    let _e1441 = local_26.member[0u];
                                    let _e1444 = local_27.member[1u];
                                    let _e1445 = (_e1441 == _e1444);
                                    if _e1445 {
                                        phi_2023_ = bool();
                                    } else {
                                        let _e1448 = local_26.member[0u];
                                        let _e1451 = local_27.member[2u];
                                        phi_2023_ = (_e1448 == _e1451);
                                    }
                                    let _e1454 = phi_2023_;
                                    phi_2024_ = _e1454;
                                    phi_2025_ = _e1445;
                                }
                                let _e1456 = phi_2024_;
                                let _e1458 = phi_2025_;
                                if _e1458 {
                                    phi_2029_ = true;
                                } else {
                                    phi_2029_ = _e1456;
                                }
                                let _e1460 = phi_2029_;
                                phi_2068_ = _e1460;
                            } else {
                                let _e1394 = local_26.member[0u];
                                let _e1397 = local_27.member[0u];
                                if (_e1394 == _e1397) {
                                    phi_2062_ = bool();
                                    phi_2063_ = true;
                                } else {
                                    let _e1401 = local_26.member[0u];
                                    let _e1404 = local_27.member[1u];
                                    if (_e1401 == _e1404) {
                                        phi_2060_ = bool();
                                        phi_2061_ = true;
                                    } else {
                                        let _e1408 = local_26.member[1u];
                                        let _e1411 = local_27.member[0u];
                                        let _e1412 = (_e1408 == _e1411);
                                        if _e1412 {
                                            phi_2059_ = bool();
                                        } else {
                                            let _e1415 = local_26.member[1u];
                                            let _e1418 = local_27.member[1u];
                                            phi_2059_ = (_e1415 == _e1418);
                                        }
                                        let _e1421 = phi_2059_;
                                        phi_2060_ = _e1421;
                                        phi_2061_ = _e1412;
                                    }
                                    let _e1423 = phi_2060_;
                                    let _e1425 = phi_2061_;
                                    phi_2062_ = _e1423;
                                    phi_2063_ = _e1425;
                                }
                                let _e1427 = phi_2062_;
                                let _e1429 = phi_2063_;
                                if _e1429 {
                                    phi_2067_ = true;
                                } else {
                                    phi_2067_ = _e1427;
                                }
                                let _e1431 = phi_2067_;
                                phi_2068_ = _e1431;
                            }
                            let _e1462 = phi_2068_;
                            if _e1462 {
                                phi_2072_ = false;
                            } else {
                                phi_2072_ = true;
                            }
                            let _e1464 = phi_2072_;
                            phi_2073_ = _e1464;
                        } else {
                            phi_2073_ = true;
                        }
                        let _e1466 = phi_2073_;
                        if _e1466 {
                            let _e1468 = params.member.member_1;
                            if ((_e1468 & 2u) != 0u) {
                                let _e1473 = local_26.member[0u];
                                let _e1475 = bodies.member[_e1473];
                                let _e1478 = local_27.member[0u];
                                let _e1480 = bodies.member[_e1478];
                                if ((_e1475 / 2u) == (_e1480 / 2u)) {
                                    let _e1485 = params.member.member_1;
                                    phi_2119_ = !(((_e1485 & 4u) != 0u));
                                } else {
                                    phi_2119_ = false;
                                }
                                let _e1490 = phi_2119_;
                                if _e1490 {
                                    phi_2130_ = true;
                                } else {
                                    if (((_e1475 & _e1480) & 1u) == 0u) {
                                        phi_2129_ = false;
                                    } else {
                                        phi_2129_ = true;
                                    }
                                    let _e1495 = phi_2129_;
                                    phi_2130_ = _e1495;
                                }
                                let _e1497 = phi_2130_;
                                if _e1497 {
                                    phi_2134_ = false;
                                } else {
                                    phi_2134_ = true;
                                }
                                let _e1499 = phi_2134_;
                                phi_2135_ = _e1499;
                            } else {
                                phi_2135_ = true;
                            }
                            let _e1501 = phi_2135_;
                            if _e1501 {
                                let _e1503 = params.member.member_1;
                                if ((_e1503 & 32u) != 0u) {
                                    let _e1507 = params.member.member_6;
                                    let _e1548 = (((((((_e1382.member_1[0] - _e1384.member[0]) > _e1507) && ((_e1384.member_1[0] - _e1382.member[0]) > _e1507)) && ((_e1382.member_1[1] - _e1384.member[1]) > _e1507)) && ((_e1384.member_1[1] - _e1382.member[1]) > _e1507)) && ((_e1382.member_1[2] - _e1384.member[2]) > _e1507)) && ((_e1384.member_1[2] - _e1382.member[2]) > _e1507));
                                    if _e1548 {
                                        phi_2884_ = bool();
                                    } else {
                                        phi_2184_ = type_35(0u, 3u);
                                        phi_2187_ = true;
                                        loop {
                                            let _e1552 = phi_2184_;
                                            let _e1554 = phi_2187_;
                                            local_66 = _e1554;
                                            if (_e1552.member < _e1552.member_1) {
                                                phi_2185_ = type_35((_e1552.member + 1u), _e1552.member_1);
                                                phi_2210_ = type_35(1u, _e1552.member);
                                            } else {
                                                phi_2185_ = _e1552;
                                                phi_2210_ = type_35(0u, type_35().member_1);
                                            }
                                            let _e1568 = phi_2185_;
                                            let _e1570 = phi_2210_;
                                            let _e1574 = (bitcast<i32>(_e1570.member) != 0i);
                                            if _e1574 {
                                                let _e1576 = local_26.member[0u];
                                                let _e1578 = keys.member[_e1576];
                                                local_14 = array<array<u32, 2>, 6>(array<u32, 2>(_e1578[0][0], _e1578[0][1]), array<u32, 2>(_e1578[1][0], _e1578[1][1]), array<u32, 2>(_e1578[2][0], _e1578[2][1]), array<u32, 2>(_e1578[3][0], _e1578[3][1]), array<u32, 2>(_e1578[4][0], _e1578[4][1]), array<u32, 2>(_e1578[5][0], _e1578[5][1]));
                                                if (_e1570.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1606 = local_14[_e1570.member_1];
                                                phi_2267_ = type_35(1u, 3u);
                                                phi_2270_ = array<u32, 2>(_e1606[0], _e1606[1]);
                                                loop {
                                                    let _e1611 = phi_2267_;
                                                    let _e1613 = phi_2270_;
                                                    local_40 = _e1613;
                                                    local_42 = _e1613;
                                                    local_44 = _e1613;
                                                    if (_e1611.member < _e1611.member_1) {
                                                        phi_2268_ = type_35((_e1611.member + 1u), _e1611.member_1);
                                                        phi_2293_ = type_35(1u, _e1611.member);
                                                    } else {
                                                        phi_2268_ = _e1611;
                                                        phi_2293_ = type_35(0u, type_35().member_1);
                                                    }
                                                    let _e1627 = phi_2268_;
                                                    let _e1629 = phi_2293_;
                                                    let _e1633 = (bitcast<i32>(_e1629.member) != 0i);
                                                    if _e1633 {
                                                        if (_e1629.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1636 = local_26.member[_e1629.member_1];
                                                        let _e1638 = keys.member[_e1636];
                                                        local_15 = array<array<u32, 2>, 6>(array<u32, 2>(_e1638[0][0], _e1638[0][1]), array<u32, 2>(_e1638[1][0], _e1638[1][1]), array<u32, 2>(_e1638[2][0], _e1638[2][1]), array<u32, 2>(_e1638[3][0], _e1638[3][1]), array<u32, 2>(_e1638[4][0], _e1638[4][1]), array<u32, 2>(_e1638[5][0], _e1638[5][1]));
                                                        if (_e1570.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1666 = local_15[_e1570.member_1];
                                                        if (_e1613[1] > _e1666[1]) {
                                                            phi_2369_ = true;
                                                        } else {
                                                            if (_e1613[1] == _e1666[1]) {
                                                                phi_2368_ = (_e1613[0] > _e1666[0]);
                                                            } else {
                                                                phi_2368_ = false;
                                                            }
                                                            let _e1677 = phi_2368_;
                                                            phi_2369_ = _e1677;
                                                        }
                                                        let _e1679 = phi_2369_;
                                                        if _e1679 {
                                                            phi_2373_ = array<u32, 2>(_e1666[0], _e1666[1]);
                                                        } else {
                                                            phi_2373_ = _e1613;
                                                        }
                                                        let _e1681 = phi_2373_;
                                                        phi_2271_ = _e1681;
                                                    } else {
                                                        phi_2271_ = array<u32, 2>();
                                                    }
                                                    let _e1683 = phi_2271_;
                                                    continue;
                                                    continuing {
                                                        phi_2267_ = _e1627;
                                                        phi_2270_ = _e1683;
                                                        break if !(_e1633);
                                                    }
                                                }
                                                let _e1686 = local_27.member[0u];
                                                let _e1688 = keys.member[_e1686];
                                                local_12 = array<array<u32, 2>, 6>(array<u32, 2>(_e1688[0][0], _e1688[0][1]), array<u32, 2>(_e1688[1][0], _e1688[1][1]), array<u32, 2>(_e1688[2][0], _e1688[2][1]), array<u32, 2>(_e1688[3][0], _e1688[3][1]), array<u32, 2>(_e1688[4][0], _e1688[4][1]), array<u32, 2>(_e1688[5][0], _e1688[5][1]));
                                                let _e1714 = (3u + _e1570.member_1);
                                                if (_e1714 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1717 = local_12[_e1714];
                                                phi_2424_ = type_35(1u, 3u);
                                                phi_2427_ = array<u32, 2>(_e1717[0], _e1717[1]);
                                                loop {
                                                    let _e1722 = phi_2424_;
                                                    let _e1724 = phi_2427_;
                                                    local_41 = _e1724;
                                                    local_43 = _e1724;
                                                    local_45 = _e1724;
                                                    if (_e1722.member < _e1722.member_1) {
                                                        phi_2425_ = type_35((_e1722.member + 1u), _e1722.member_1);
                                                        phi_2450_ = type_35(1u, _e1722.member);
                                                    } else {
                                                        phi_2425_ = _e1722;
                                                        phi_2450_ = type_35(0u, type_35().member_1);
                                                    }
                                                    let _e1738 = phi_2425_;
                                                    let _e1740 = phi_2450_;
                                                    let _e1744 = (bitcast<i32>(_e1740.member) != 0i);
                                                    if _e1744 {
                                                        if (_e1740.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1747 = local_27.member[_e1740.member_1];
                                                        let _e1749 = keys.member[_e1747];
                                                        local_13 = array<array<u32, 2>, 6>(array<u32, 2>(_e1749[0][0], _e1749[0][1]), array<u32, 2>(_e1749[1][0], _e1749[1][1]), array<u32, 2>(_e1749[2][0], _e1749[2][1]), array<u32, 2>(_e1749[3][0], _e1749[3][1]), array<u32, 2>(_e1749[4][0], _e1749[4][1]), array<u32, 2>(_e1749[5][0], _e1749[5][1]));
                                                        let _e1775 = (3u + _e1570.member_1);
                                                        if (_e1775 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1778 = local_13[_e1775];
                                                        if (_e1778[1] > _e1724[1]) {
                                                            phi_2527_ = true;
                                                        } else {
                                                            if (_e1778[1] == _e1724[1]) {
                                                                phi_2526_ = (_e1778[0] > _e1724[0]);
                                                            } else {
                                                                phi_2526_ = false;
                                                            }
                                                            let _e1789 = phi_2526_;
                                                            phi_2527_ = _e1789;
                                                        }
                                                        let _e1791 = phi_2527_;
                                                        if _e1791 {
                                                            phi_2531_ = array<u32, 2>(_e1778[0], _e1778[1]);
                                                        } else {
                                                            phi_2531_ = _e1724;
                                                        }
                                                        let _e1793 = phi_2531_;
                                                        phi_2428_ = _e1793;
                                                    } else {
                                                        phi_2428_ = array<u32, 2>();
                                                    }
                                                    let _e1795 = phi_2428_;
                                                    continue;
                                                    continuing {
                                                        phi_2424_ = _e1738;
                                                        phi_2427_ = _e1795;
                                                        break if !(_e1744);
                                                    }
                                                }
                                                let _e1798 = local_40;
                                                let _e1801 = local_41;
                                                if (_e1798[1] > _e1801[1]) {
                                                    phi_2548_ = true;
                                                } else {
                                                    let _e1805 = local_42;
                                                    let _e1808 = local_43;
                                                    if (_e1805[1] == _e1808[1]) {
                                                        let _e1812 = local_44;
                                                        let _e1815 = local_45;
                                                        phi_2547_ = (_e1812[0] > _e1815[0]);
                                                    } else {
                                                        phi_2547_ = false;
                                                    }
                                                    let _e1819 = phi_2547_;
                                                    phi_2548_ = _e1819;
                                                }
                                                let _e1821 = phi_2548_;
                                                let _e1824 = local_27.member[0u];
                                                let _e1826 = keys.member[_e1824];
                                                local_10 = array<array<u32, 2>, 6>(array<u32, 2>(_e1826[0][0], _e1826[0][1]), array<u32, 2>(_e1826[1][0], _e1826[1][1]), array<u32, 2>(_e1826[2][0], _e1826[2][1]), array<u32, 2>(_e1826[3][0], _e1826[3][1]), array<u32, 2>(_e1826[4][0], _e1826[4][1]), array<u32, 2>(_e1826[5][0], _e1826[5][1]));
                                                if (_e1570.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1854 = local_10[_e1570.member_1];
                                                phi_2599_ = type_35(1u, 3u);
                                                phi_2602_ = array<u32, 2>(_e1854[0], _e1854[1]);
                                                loop {
                                                    let _e1859 = phi_2599_;
                                                    let _e1861 = phi_2602_;
                                                    local_46 = _e1861;
                                                    local_48 = _e1861;
                                                    local_50 = _e1861;
                                                    if (_e1859.member < _e1859.member_1) {
                                                        phi_2600_ = type_35((_e1859.member + 1u), _e1859.member_1);
                                                        phi_2625_ = type_35(1u, _e1859.member);
                                                    } else {
                                                        phi_2600_ = _e1859;
                                                        phi_2625_ = type_35(0u, type_35().member_1);
                                                    }
                                                    let _e1875 = phi_2600_;
                                                    let _e1877 = phi_2625_;
                                                    let _e1881 = (bitcast<i32>(_e1877.member) != 0i);
                                                    if _e1881 {
                                                        if (_e1877.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1884 = local_27.member[_e1877.member_1];
                                                        let _e1886 = keys.member[_e1884];
                                                        local_11 = array<array<u32, 2>, 6>(array<u32, 2>(_e1886[0][0], _e1886[0][1]), array<u32, 2>(_e1886[1][0], _e1886[1][1]), array<u32, 2>(_e1886[2][0], _e1886[2][1]), array<u32, 2>(_e1886[3][0], _e1886[3][1]), array<u32, 2>(_e1886[4][0], _e1886[4][1]), array<u32, 2>(_e1886[5][0], _e1886[5][1]));
                                                        if (_e1570.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1914 = local_11[_e1570.member_1];
                                                        if (_e1861[1] > _e1914[1]) {
                                                            phi_2701_ = true;
                                                        } else {
                                                            if (_e1861[1] == _e1914[1]) {
                                                                phi_2700_ = (_e1861[0] > _e1914[0]);
                                                            } else {
                                                                phi_2700_ = false;
                                                            }
                                                            let _e1925 = phi_2700_;
                                                            phi_2701_ = _e1925;
                                                        }
                                                        let _e1927 = phi_2701_;
                                                        if _e1927 {
                                                            phi_2705_ = array<u32, 2>(_e1914[0], _e1914[1]);
                                                        } else {
                                                            phi_2705_ = _e1861;
                                                        }
                                                        let _e1929 = phi_2705_;
                                                        phi_2603_ = _e1929;
                                                    } else {
                                                        phi_2603_ = array<u32, 2>();
                                                    }
                                                    let _e1931 = phi_2603_;
                                                    continue;
                                                    continuing {
                                                        phi_2599_ = _e1875;
                                                        phi_2602_ = _e1931;
                                                        break if !(_e1881);
                                                    }
                                                }
                                                let _e1934 = local_26.member[0u];
                                                let _e1936 = keys.member[_e1934];
                                                local_8 = array<array<u32, 2>, 6>(array<u32, 2>(_e1936[0][0], _e1936[0][1]), array<u32, 2>(_e1936[1][0], _e1936[1][1]), array<u32, 2>(_e1936[2][0], _e1936[2][1]), array<u32, 2>(_e1936[3][0], _e1936[3][1]), array<u32, 2>(_e1936[4][0], _e1936[4][1]), array<u32, 2>(_e1936[5][0], _e1936[5][1]));
                                                let _e1962 = (3u + _e1570.member_1);
                                                if (_e1962 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1965 = local_8[_e1962];
                                                phi_2756_ = type_35(1u, 3u);
                                                phi_2759_ = array<u32, 2>(_e1965[0], _e1965[1]);
                                                loop {
                                                    let _e1970 = phi_2756_;
                                                    let _e1972 = phi_2759_;
                                                    local_47 = _e1972;
                                                    local_49 = _e1972;
                                                    local_51 = _e1972;
                                                    if (_e1970.member < _e1970.member_1) {
                                                        phi_2757_ = type_35((_e1970.member + 1u), _e1970.member_1);
                                                        phi_2782_ = type_35(1u, _e1970.member);
                                                    } else {
                                                        phi_2757_ = _e1970;
                                                        phi_2782_ = type_35(0u, type_35().member_1);
                                                    }
                                                    let _e1986 = phi_2757_;
                                                    let _e1988 = phi_2782_;
                                                    let _e1992 = (bitcast<i32>(_e1988.member) != 0i);
                                                    if _e1992 {
                                                        if (_e1988.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1995 = local_26.member[_e1988.member_1];
                                                        let _e1997 = keys.member[_e1995];
                                                        local_9 = array<array<u32, 2>, 6>(array<u32, 2>(_e1997[0][0], _e1997[0][1]), array<u32, 2>(_e1997[1][0], _e1997[1][1]), array<u32, 2>(_e1997[2][0], _e1997[2][1]), array<u32, 2>(_e1997[3][0], _e1997[3][1]), array<u32, 2>(_e1997[4][0], _e1997[4][1]), array<u32, 2>(_e1997[5][0], _e1997[5][1]));
                                                        let _e2023 = (3u + _e1570.member_1);
                                                        if (_e2023 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2026 = local_9[_e2023];
                                                        if (_e2026[1] > _e1972[1]) {
                                                            phi_2859_ = true;
                                                        } else {
                                                            if (_e2026[1] == _e1972[1]) {
                                                                phi_2858_ = (_e2026[0] > _e1972[0]);
                                                            } else {
                                                                phi_2858_ = false;
                                                            }
                                                            let _e2037 = phi_2858_;
                                                            phi_2859_ = _e2037;
                                                        }
                                                        let _e2039 = phi_2859_;
                                                        if _e2039 {
                                                            phi_2863_ = array<u32, 2>(_e2026[0], _e2026[1]);
                                                        } else {
                                                            phi_2863_ = _e1972;
                                                        }
                                                        let _e2041 = phi_2863_;
                                                        phi_2760_ = _e2041;
                                                    } else {
                                                        phi_2760_ = array<u32, 2>();
                                                    }
                                                    let _e2043 = phi_2760_;
                                                    continue;
                                                    continuing {
                                                        phi_2756_ = _e1986;
                                                        phi_2759_ = _e2043;
                                                        break if !(_e1992);
                                                    }
                                                }
                                                let _e2046 = local_46;
                                                let _e2049 = local_47;
                                                if (_e2046[1] > _e2049[1]) {
                                                    phi_2880_ = true;
                                                } else {
                                                    let _e2053 = local_48;
                                                    let _e2056 = local_49;
                                                    if (_e2053[1] == _e2056[1]) {
                                                        let _e2060 = local_50;
                                                        let _e2063 = local_51;
                                                        phi_2879_ = (_e2060[0] > _e2063[0]);
                                                    } else {
                                                        phi_2879_ = false;
                                                    }
                                                    let _e2067 = phi_2879_;
                                                    phi_2880_ = _e2067;
                                                }
                                                let _e2069 = phi_2880_;
                                                phi_2188_ = (_e1554 && (!(_e1821) && !(_e2069)));
                                            } else {
                                                phi_2188_ = bool();
                                            }
                                            let _e2074 = phi_2188_;
                                            continue;
                                            continuing {
                                                phi_2184_ = _e1568;
                                                phi_2187_ = _e2074;
                                                break if !(_e1574);
                                            }
                                        }
                                        let _e5414 = local_66;
                                        phi_2884_ = _e5414;
                                    }
                                    let _e2077 = phi_2884_;
                                    phi_2885_ = _e2077;
                                    phi_2886_ = _e1548;
                                } else {
                                    phi_2885_ = bool();
                                    phi_2886_ = true;
                                }
                                let _e2079 = phi_2885_;
                                let _e2081 = phi_2886_;
                                if _e2081 {
                                    phi_2890_ = false;
                                } else {
                                    phi_2890_ = true;
                                }
                                let _e2083 = phi_2890_;
                                phi_2891_ = _e2079;
                                phi_2892_ = _e2083;
                            } else {
                                phi_2891_ = false;
                                phi_2892_ = true;
                            }
                            let _e2085 = phi_2891_;
                            let _e2087 = phi_2892_;
                            phi_2893_ = _e2085;
                            phi_2894_ = _e2087;
                        } else {
                            phi_2893_ = false;
                            phi_2894_ = true;
                        }
                        let _e2089 = phi_2893_;
                        let _e2091 = phi_2894_;
                        if _e2091 {
                            phi_2898_ = _e2089;
                        } else {
                            phi_2898_ = true;
                        }
                        let _e2093 = phi_2898_;
                        if _e2093 {
                            let _e2095 = atomicAdd((&counters[7u]), 1u);
                            let _e2097 = local_26.member_1;
                            let _e2099 = local_27.member_1;
                            if (_e2097 < _e2099) {
                                phi_2944_ = _e1366;
                                phi_2945_ = _e1364;
                            } else {
                                phi_2944_ = _e1364;
                                phi_2945_ = _e1366;
                            }
                            let _e2102 = phi_2944_;
                            let _e2104 = phi_2945_;
                            let _e2106 = params.member.member_4;
                            let _e2108 = params.member.member_5;
                            let _e2118 = paths.member[_e2104.member[0]];
                            let _e2120 = paths.member[_e2104.member[1]];
                            let _e2126 = paths.member[_e2102.member[0]];
                            let _e2128 = paths.member[_e2102.member[1]];
                            local_7 = type_70(array<array<f32, 3>, 2>(array<f32, 3>((_e2126.member[0] - _e2118.member[0]), (_e2126.member[1] - _e2118.member[1]), (_e2126.member[2] - _e2118.member[2])), array<f32, 3>((_e2126.member_1[0] - _e2118.member_1[0]), (_e2126.member_1[1] - _e2118.member_1[1]), (_e2126.member_1[2] - _e2118.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e2120.member[0] - _e2118.member[0]), (_e2120.member[1] - _e2118.member[1]), (_e2120.member[2] - _e2118.member[2])), array<f32, 3>((_e2120.member_1[0] - _e2118.member_1[0]), (_e2120.member_1[1] - _e2118.member_1[1]), (_e2120.member_1[2] - _e2118.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e2126.member[0] - _e2128.member[0]), (_e2126.member[1] - _e2128.member[1]), (_e2126.member[2] - _e2128.member[2])), array<f32, 3>((_e2126.member_1[0] - _e2128.member_1[0]), (_e2126.member_1[1] - _e2128.member_1[1]), (_e2126.member_1[2] - _e2128.member_1[2]))), (_e2106 + _e2106));
                            let _e2188 = local_7.member_1[0u];
                            let _e2194 = local_7.member_2[0u];
                            let _e2200 = ((_e2188[1] * _e2194[2]) - (_e2188[2] * _e2194[1]));
                            let _e2203 = ((_e2188[2] * _e2194[0]) - (_e2188[0] * _e2194[2]));
                            let _e2206 = ((_e2188[0] * _e2194[1]) - (_e2188[1] * _e2194[0]));
                            let _e2209 = local_7.member_1[1u];
                            let _e2215 = local_7.member_2[1u];
                            let _e2221 = ((_e2209[1] * _e2215[2]) - (_e2209[2] * _e2215[1]));
                            let _e2224 = ((_e2209[2] * _e2215[0]) - (_e2209[0] * _e2215[2]));
                            let _e2227 = ((_e2209[0] * _e2215[1]) - (_e2209[1] * _e2215[0]));
                            let _e2230 = local_7.member_1[0u];
                            let _e2236 = local_7.member_2[1u];
                            let _e2251 = local_7.member_1[1u];
                            let _e2257 = local_7.member_2[0u];
                            let _e2270 = (((_e2230[1] * _e2236[2]) - (_e2230[2] * _e2236[1])) + ((_e2251[1] * _e2257[2]) - (_e2251[2] * _e2257[1])));
                            let _e2271 = (((_e2230[2] * _e2236[0]) - (_e2230[0] * _e2236[2])) + ((_e2251[2] * _e2257[0]) - (_e2251[0] * _e2257[2])));
                            let _e2272 = (((_e2230[0] * _e2236[1]) - (_e2230[1] * _e2236[0])) + ((_e2251[0] * _e2257[1]) - (_e2251[1] * _e2257[0])));
                            let _e2275 = local_7.member[0u];
                            let _e2286 = local_7.member[1u];
                            let _e2297 = local_7.member[0u];
                            let _e2306 = ((((_e2286[0] * _e2200) + (_e2286[1] * _e2203)) + (_e2286[2] * _e2206)) + (((_e2297[0] * _e2270) + (_e2297[1] * _e2271)) + (_e2297[2] * _e2272)));
                            let _e2309 = local_7.member[0u];
                            let _e2320 = local_7.member[1u];
                            let _e2329 = ((((_e2309[0] * _e2221) + (_e2309[1] * _e2224)) + (_e2309[2] * _e2227)) + (((_e2320[0] * _e2270) + (_e2320[1] * _e2271)) + (_e2320[2] * _e2272)));
                            let _e2332 = local_7.member[1u];
                            let _e2343 = local_7.member[0u];
                            if (_e2343[0] < 0f) {
                                phi_3334_ = -(_e2343[0]);
                            } else {
                                phi_3334_ = _e2343[0];
                            }
                            let _e2350 = phi_3334_;
                            if (_e2343[1] < 0f) {
                                phi_3341_ = -(_e2343[1]);
                            } else {
                                phi_3341_ = _e2343[1];
                            }
                            let _e2354 = phi_3341_;
                            if (_e2350 > _e2354) {
                                phi_3346_ = _e2350;
                            } else {
                                phi_3346_ = _e2354;
                            }
                            let _e2357 = phi_3346_;
                            if (_e2343[2] < 0f) {
                                phi_3353_ = -(_e2343[2]);
                            } else {
                                phi_3353_ = _e2343[2];
                            }
                            let _e2361 = phi_3353_;
                            if (_e2357 > _e2361) {
                                phi_3358_ = _e2357;
                            } else {
                                phi_3358_ = _e2361;
                            }
                            let _e2364 = phi_3358_;
                            let _e2367 = local_7.member[1u];
                            if (_e2367[0] < 0f) {
                                phi_3371_ = -(_e2367[0]);
                            } else {
                                phi_3371_ = _e2367[0];
                            }
                            let _e2374 = phi_3371_;
                            if (_e2367[1] < 0f) {
                                phi_3378_ = -(_e2367[1]);
                            } else {
                                phi_3378_ = _e2367[1];
                            }
                            let _e2378 = phi_3378_;
                            if (_e2374 > _e2378) {
                                phi_3383_ = _e2374;
                            } else {
                                phi_3383_ = _e2378;
                            }
                            let _e2381 = phi_3383_;
                            if (_e2367[2] < 0f) {
                                phi_3390_ = -(_e2367[2]);
                            } else {
                                phi_3390_ = _e2367[2];
                            }
                            let _e2385 = phi_3390_;
                            if (_e2381 > _e2385) {
                                phi_3395_ = _e2381;
                            } else {
                                phi_3395_ = _e2385;
                            }
                            let _e2388 = phi_3395_;
                            if (_e2364 > _e2388) {
                                phi_3400_ = _e2364;
                            } else {
                                phi_3400_ = _e2388;
                            }
                            let _e2391 = phi_3400_;
                            let _e2393 = local_7.member_3;
                            let _e2394 = (_e2391 + _e2393);
                            let _e2397 = local_7.member_1[0u];
                            if (_e2397[0] < 0f) {
                                phi_3417_ = -(_e2397[0]);
                            } else {
                                phi_3417_ = _e2397[0];
                            }
                            let _e2404 = phi_3417_;
                            if (_e2397[1] < 0f) {
                                phi_3424_ = -(_e2397[1]);
                            } else {
                                phi_3424_ = _e2397[1];
                            }
                            let _e2408 = phi_3424_;
                            if (_e2404 > _e2408) {
                                phi_3429_ = _e2404;
                            } else {
                                phi_3429_ = _e2408;
                            }
                            let _e2411 = phi_3429_;
                            if (_e2397[2] < 0f) {
                                phi_3436_ = -(_e2397[2]);
                            } else {
                                phi_3436_ = _e2397[2];
                            }
                            let _e2415 = phi_3436_;
                            if (_e2411 > _e2415) {
                                phi_3441_ = _e2411;
                            } else {
                                phi_3441_ = _e2415;
                            }
                            let _e2418 = phi_3441_;
                            let _e2421 = local_7.member_1[1u];
                            if (_e2421[0] < 0f) {
                                phi_3455_ = -(_e2421[0]);
                            } else {
                                phi_3455_ = _e2421[0];
                            }
                            let _e2428 = phi_3455_;
                            if (_e2421[1] < 0f) {
                                phi_3462_ = -(_e2421[1]);
                            } else {
                                phi_3462_ = _e2421[1];
                            }
                            let _e2432 = phi_3462_;
                            if (_e2428 > _e2432) {
                                phi_3467_ = _e2428;
                            } else {
                                phi_3467_ = _e2432;
                            }
                            let _e2435 = phi_3467_;
                            if (_e2421[2] < 0f) {
                                phi_3474_ = -(_e2421[2]);
                            } else {
                                phi_3474_ = _e2421[2];
                            }
                            let _e2439 = phi_3474_;
                            if (_e2435 > _e2439) {
                                phi_3479_ = _e2435;
                            } else {
                                phi_3479_ = _e2439;
                            }
                            let _e2442 = phi_3479_;
                            if (_e2418 > _e2442) {
                                phi_3484_ = _e2418;
                            } else {
                                phi_3484_ = _e2442;
                            }
                            let _e2445 = phi_3484_;
                            let _e2447 = local_7.member_3;
                            let _e2448 = (_e2445 + _e2447);
                            let _e2451 = local_7.member_2[0u];
                            if (_e2451[0] < 0f) {
                                phi_3501_ = -(_e2451[0]);
                            } else {
                                phi_3501_ = _e2451[0];
                            }
                            let _e2458 = phi_3501_;
                            if (_e2451[1] < 0f) {
                                phi_3508_ = -(_e2451[1]);
                            } else {
                                phi_3508_ = _e2451[1];
                            }
                            let _e2462 = phi_3508_;
                            if (_e2458 > _e2462) {
                                phi_3513_ = _e2458;
                            } else {
                                phi_3513_ = _e2462;
                            }
                            let _e2465 = phi_3513_;
                            if (_e2451[2] < 0f) {
                                phi_3520_ = -(_e2451[2]);
                            } else {
                                phi_3520_ = _e2451[2];
                            }
                            let _e2469 = phi_3520_;
                            if (_e2465 > _e2469) {
                                phi_3525_ = _e2465;
                            } else {
                                phi_3525_ = _e2469;
                            }
                            let _e2472 = phi_3525_;
                            let _e2475 = local_7.member_2[1u];
                            if (_e2475[0] < 0f) {
                                phi_3539_ = -(_e2475[0]);
                            } else {
                                phi_3539_ = _e2475[0];
                            }
                            let _e2482 = phi_3539_;
                            if (_e2475[1] < 0f) {
                                phi_3546_ = -(_e2475[1]);
                            } else {
                                phi_3546_ = _e2475[1];
                            }
                            let _e2486 = phi_3546_;
                            if (_e2482 > _e2486) {
                                phi_3551_ = _e2482;
                            } else {
                                phi_3551_ = _e2486;
                            }
                            let _e2489 = phi_3551_;
                            if (_e2475[2] < 0f) {
                                phi_3558_ = -(_e2475[2]);
                            } else {
                                phi_3558_ = _e2475[2];
                            }
                            let _e2493 = phi_3558_;
                            if (_e2489 > _e2493) {
                                phi_3563_ = _e2489;
                            } else {
                                phi_3563_ = _e2493;
                            }
                            let _e2496 = phi_3563_;
                            if (_e2472 > _e2496) {
                                phi_3568_ = _e2472;
                            } else {
                                phi_3568_ = _e2496;
                            }
                            let _e2499 = phi_3568_;
                            let _e2501 = local_7.member_3;
                            let _e2502 = (_e2499 + _e2501);
                            let _e2504 = ((_e2448 * 8f) * _e2502);
                            let _e2511 = local_7.member_3;
                            if (_e2200 < 0f) {
                                phi_3599_ = -(_e2200);
                            } else {
                                phi_3599_ = _e2200;
                            }
                            let _e2528 = phi_3599_;
                            if (_e2203 < 0f) {
                                phi_3605_ = -(_e2203);
                            } else {
                                phi_3605_ = _e2203;
                            }
                            let _e2532 = phi_3605_;
                            if (_e2206 < 0f) {
                                phi_3612_ = -(_e2206);
                            } else {
                                phi_3612_ = _e2206;
                            }
                            let _e2537 = phi_3612_;
                            let _e2538 = ((_e2528 + _e2532) + _e2537);
                            if (_e2221 < 0f) {
                                phi_3619_ = -(_e2221);
                            } else {
                                phi_3619_ = _e2221;
                            }
                            let _e2542 = phi_3619_;
                            if (_e2224 < 0f) {
                                phi_3625_ = -(_e2224);
                            } else {
                                phi_3625_ = _e2224;
                            }
                            let _e2546 = phi_3625_;
                            if (_e2227 < 0f) {
                                phi_3632_ = -(_e2227);
                            } else {
                                phi_3632_ = _e2227;
                            }
                            let _e2551 = phi_3632_;
                            let _e2552 = ((_e2542 + _e2546) + _e2551);
                            if (_e2538 > _e2552) {
                                phi_3638_ = _e2538;
                            } else {
                                phi_3638_ = _e2552;
                            }
                            let _e2555 = phi_3638_;
                            if (_e2270 < 0f) {
                                phi_3644_ = -(_e2270);
                            } else {
                                phi_3644_ = _e2270;
                            }
                            let _e2559 = phi_3644_;
                            if (_e2271 < 0f) {
                                phi_3650_ = -(_e2271);
                            } else {
                                phi_3650_ = _e2271;
                            }
                            let _e2563 = phi_3650_;
                            if (_e2272 < 0f) {
                                phi_3657_ = -(_e2272);
                            } else {
                                phi_3657_ = _e2272;
                            }
                            let _e2568 = phi_3657_;
                            let _e2570 = (((_e2559 + _e2563) + _e2568) * 0.5f);
                            if (_e2555 > _e2570) {
                                phi_3664_ = _e2555;
                            } else {
                                phi_3664_ = _e2570;
                            }
                            let _e2573 = phi_3664_;
                            let _e2578 = local_7.member_3;
                            let _e2591 = ((((_e2275[0] * _e2200) + (_e2275[1] * _e2203)) + (_e2275[2] * _e2206)) * 3f);
                            let _e2592 = ((((_e2332[0] * _e2221) + (_e2332[1] * _e2224)) + (_e2332[2] * _e2227)) * 3f);
                            if (_e2591 < _e2592) {
                                phi_3688_ = _e2591;
                            } else {
                                phi_3688_ = _e2592;
                            }
                            let _e2595 = phi_3688_;
                            if (_e2306 < _e2329) {
                                phi_3693_ = _e2306;
                            } else {
                                phi_3693_ = _e2329;
                            }
                            let _e2598 = phi_3693_;
                            if (_e2595 < _e2598) {
                                phi_3698_ = _e2595;
                            } else {
                                phi_3698_ = _e2598;
                            }
                            let _e2601 = phi_3698_;
                            if (_e2591 > _e2592) {
                                phi_3703_ = _e2591;
                            } else {
                                phi_3703_ = _e2592;
                            }
                            let _e2604 = phi_3703_;
                            if (_e2306 > _e2329) {
                                phi_3708_ = _e2306;
                            } else {
                                phi_3708_ = _e2329;
                            }
                            let _e2607 = phi_3708_;
                            if (_e2604 > _e2607) {
                                phi_3713_ = _e2604;
                            } else {
                                phi_3713_ = _e2607;
                            }
                            let _e2610 = phi_3713_;
                            let _e2615 = -(_e2610);
                            if (_e2601 > _e2615) {
                                phi_3723_ = _e2601;
                            } else {
                                phi_3723_ = _e2615;
                            }
                            let _e2618 = phi_3723_;
                            if ((_e2618 - ((((((_e2394 * 8f) * _e2504) * (0.000000059604645f * (490f / 64f))) + ((_e2511 * 19f) * ((_e2394 * (_e2448 + _e2502)) + (_e2448 * _e2502)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2394) * ((1f + _e2448) * (1f + _e2502))))) + ((_e2108 * (((_e2573 + (_e2504 * (0.000000059604645f * 4f))) + ((_e2578 * 6f) * (_e2448 + _e2502))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2448) * (1f + _e2502))))) * (3f * 1.0001f)))) > 0f) {
                                phi_4699_ = true;
                            } else {
                                let _e2623 = local_7.member_1[0u];
                                let _e2629 = local_7.member_1[1u];
                                let _e2633 = (_e2623[0] + _e2629[0]);
                                let _e2634 = (_e2623[1] + _e2629[1]);
                                let _e2635 = (_e2623[2] + _e2629[2]);
                                let _e2638 = local_7.member_2[0u];
                                let _e2644 = local_7.member_2[1u];
                                let _e2648 = (_e2638[0] + _e2644[0]);
                                let _e2649 = (_e2638[1] + _e2644[1]);
                                let _e2650 = (_e2638[2] + _e2644[2]);
                                let _e2653 = ((_e2634 * _e2650) - (_e2635 * _e2649));
                                let _e2656 = ((_e2635 * _e2648) - (_e2633 * _e2650));
                                let _e2659 = ((_e2633 * _e2649) - (_e2634 * _e2648));
                                let _e2662 = local_7.member[0u];
                                let _e2668 = local_7.member_1[0u];
                                let _e2674 = local_7.member_2[0u];
                                let _e2678 = (_e2662[0] - _e2668[0]);
                                let _e2679 = (_e2662[1] - _e2668[1]);
                                let _e2680 = (_e2662[2] - _e2668[2]);
                                let _e2689 = local_7.member[1u];
                                let _e2695 = local_7.member_1[1u];
                                let _e2701 = local_7.member_2[1u];
                                let _e2705 = (_e2689[0] - _e2695[0]);
                                let _e2706 = (_e2689[1] - _e2695[1]);
                                let _e2707 = (_e2689[2] - _e2695[2]);
                                local_5 = array<array<f32, 3>, 4>(_e2662, array<f32, 3>(_e2678, _e2679, _e2680), array<f32, 3>((_e2662[0] - _e2674[0]), (_e2662[1] - _e2674[1]), (_e2662[2] - _e2674[2])), array<f32, 3>((_e2678 - _e2674[0]), (_e2679 - _e2674[1]), (_e2680 - _e2674[2])));
                                local_6 = array<array<f32, 3>, 4>(_e2689, array<f32, 3>(_e2705, _e2706, _e2707), array<f32, 3>((_e2689[0] - _e2701[0]), (_e2689[1] - _e2701[1]), (_e2689[2] - _e2701[2])), array<f32, 3>((_e2705 - _e2701[0]), (_e2706 - _e2701[1]), (_e2707 - _e2701[2])));
                                let _e2724 = local_7.member[0u];
                                if (_e2724[0] < 0f) {
                                    phi_3974_ = -(_e2724[0]);
                                } else {
                                    phi_3974_ = _e2724[0];
                                }
                                let _e2731 = phi_3974_;
                                if (_e2724[1] < 0f) {
                                    phi_3981_ = -(_e2724[1]);
                                } else {
                                    phi_3981_ = _e2724[1];
                                }
                                let _e2735 = phi_3981_;
                                if (_e2731 > _e2735) {
                                    phi_3986_ = _e2731;
                                } else {
                                    phi_3986_ = _e2735;
                                }
                                let _e2738 = phi_3986_;
                                if (_e2724[2] < 0f) {
                                    phi_3993_ = -(_e2724[2]);
                                } else {
                                    phi_3993_ = _e2724[2];
                                }
                                let _e2742 = phi_3993_;
                                if (_e2738 > _e2742) {
                                    phi_3998_ = _e2738;
                                } else {
                                    phi_3998_ = _e2742;
                                }
                                let _e2745 = phi_3998_;
                                let _e2748 = local_7.member[1u];
                                if (_e2748[0] < 0f) {
                                    phi_4011_ = -(_e2748[0]);
                                } else {
                                    phi_4011_ = _e2748[0];
                                }
                                let _e2755 = phi_4011_;
                                if (_e2748[1] < 0f) {
                                    phi_4018_ = -(_e2748[1]);
                                } else {
                                    phi_4018_ = _e2748[1];
                                }
                                let _e2759 = phi_4018_;
                                if (_e2755 > _e2759) {
                                    phi_4023_ = _e2755;
                                } else {
                                    phi_4023_ = _e2759;
                                }
                                let _e2762 = phi_4023_;
                                if (_e2748[2] < 0f) {
                                    phi_4030_ = -(_e2748[2]);
                                } else {
                                    phi_4030_ = _e2748[2];
                                }
                                let _e2766 = phi_4030_;
                                if (_e2762 > _e2766) {
                                    phi_4035_ = _e2762;
                                } else {
                                    phi_4035_ = _e2766;
                                }
                                let _e2769 = phi_4035_;
                                if (_e2745 > _e2769) {
                                    phi_4040_ = _e2745;
                                } else {
                                    phi_4040_ = _e2769;
                                }
                                let _e2772 = phi_4040_;
                                let _e2774 = local_7.member_3;
                                let _e2778 = local_7.member_1[0u];
                                if (_e2778[0] < 0f) {
                                    phi_4057_ = -(_e2778[0]);
                                } else {
                                    phi_4057_ = _e2778[0];
                                }
                                let _e2785 = phi_4057_;
                                if (_e2778[1] < 0f) {
                                    phi_4064_ = -(_e2778[1]);
                                } else {
                                    phi_4064_ = _e2778[1];
                                }
                                let _e2789 = phi_4064_;
                                if (_e2785 > _e2789) {
                                    phi_4069_ = _e2785;
                                } else {
                                    phi_4069_ = _e2789;
                                }
                                let _e2792 = phi_4069_;
                                if (_e2778[2] < 0f) {
                                    phi_4076_ = -(_e2778[2]);
                                } else {
                                    phi_4076_ = _e2778[2];
                                }
                                let _e2796 = phi_4076_;
                                if (_e2792 > _e2796) {
                                    phi_4081_ = _e2792;
                                } else {
                                    phi_4081_ = _e2796;
                                }
                                let _e2799 = phi_4081_;
                                let _e2802 = local_7.member_1[1u];
                                if (_e2802[0] < 0f) {
                                    phi_4095_ = -(_e2802[0]);
                                } else {
                                    phi_4095_ = _e2802[0];
                                }
                                let _e2809 = phi_4095_;
                                if (_e2802[1] < 0f) {
                                    phi_4102_ = -(_e2802[1]);
                                } else {
                                    phi_4102_ = _e2802[1];
                                }
                                let _e2813 = phi_4102_;
                                if (_e2809 > _e2813) {
                                    phi_4107_ = _e2809;
                                } else {
                                    phi_4107_ = _e2813;
                                }
                                let _e2816 = phi_4107_;
                                if (_e2802[2] < 0f) {
                                    phi_4114_ = -(_e2802[2]);
                                } else {
                                    phi_4114_ = _e2802[2];
                                }
                                let _e2820 = phi_4114_;
                                if (_e2816 > _e2820) {
                                    phi_4119_ = _e2816;
                                } else {
                                    phi_4119_ = _e2820;
                                }
                                let _e2823 = phi_4119_;
                                if (_e2799 > _e2823) {
                                    phi_4124_ = _e2799;
                                } else {
                                    phi_4124_ = _e2823;
                                }
                                let _e2826 = phi_4124_;
                                let _e2828 = local_7.member_3;
                                let _e2832 = local_7.member_2[0u];
                                if (_e2832[0] < 0f) {
                                    phi_4141_ = -(_e2832[0]);
                                } else {
                                    phi_4141_ = _e2832[0];
                                }
                                let _e2839 = phi_4141_;
                                if (_e2832[1] < 0f) {
                                    phi_4148_ = -(_e2832[1]);
                                } else {
                                    phi_4148_ = _e2832[1];
                                }
                                let _e2843 = phi_4148_;
                                if (_e2839 > _e2843) {
                                    phi_4153_ = _e2839;
                                } else {
                                    phi_4153_ = _e2843;
                                }
                                let _e2846 = phi_4153_;
                                if (_e2832[2] < 0f) {
                                    phi_4160_ = -(_e2832[2]);
                                } else {
                                    phi_4160_ = _e2832[2];
                                }
                                let _e2850 = phi_4160_;
                                if (_e2846 > _e2850) {
                                    phi_4165_ = _e2846;
                                } else {
                                    phi_4165_ = _e2850;
                                }
                                let _e2853 = phi_4165_;
                                let _e2856 = local_7.member_2[1u];
                                if (_e2856[0] < 0f) {
                                    phi_4179_ = -(_e2856[0]);
                                } else {
                                    phi_4179_ = _e2856[0];
                                }
                                let _e2863 = phi_4179_;
                                if (_e2856[1] < 0f) {
                                    phi_4186_ = -(_e2856[1]);
                                } else {
                                    phi_4186_ = _e2856[1];
                                }
                                let _e2867 = phi_4186_;
                                if (_e2863 > _e2867) {
                                    phi_4191_ = _e2863;
                                } else {
                                    phi_4191_ = _e2867;
                                }
                                let _e2870 = phi_4191_;
                                if (_e2856[2] < 0f) {
                                    phi_4198_ = -(_e2856[2]);
                                } else {
                                    phi_4198_ = _e2856[2];
                                }
                                let _e2874 = phi_4198_;
                                if (_e2870 > _e2874) {
                                    phi_4203_ = _e2870;
                                } else {
                                    phi_4203_ = _e2874;
                                }
                                let _e2877 = phi_4203_;
                                if (_e2853 > _e2877) {
                                    phi_4208_ = _e2853;
                                } else {
                                    phi_4208_ = _e2877;
                                }
                                let _e2880 = phi_4208_;
                                let _e2882 = local_7.member_3;
                                let _e2885 = (((_e2772 + _e2774) + (_e2826 + _e2828)) + (_e2880 + _e2882));
                                let _e2888 = local_7.member_3;
                                let _e2892 = (((_e2108 * 1.0001f) + (_e2888 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2895 = ((_e2656 * _e2635) - (_e2659 * _e2634));
                                let _e2898 = ((_e2659 * _e2633) - (_e2653 * _e2635));
                                let _e2901 = ((_e2653 * _e2634) - (_e2656 * _e2633));
                                let _e2903 = local_5[0u];
                                let _e2911 = (((_e2895 * _e2903[0]) + (_e2898 * _e2903[1])) + (_e2901 * _e2903[2]));
                                phi_4246_ = type_35(0u, 4u);
                                phi_4249_ = _e2911;
                                phi_4251_ = _e2911;
                                loop {
                                    let _e2913 = phi_4246_;
                                    let _e2915 = phi_4249_;
                                    let _e2917 = phi_4251_;
                                    local_52 = _e2915;
                                    local_53 = _e2917;
                                    local_67 = _e2917;
                                    if (_e2913.member < _e2913.member_1) {
                                        phi_4247_ = type_35((_e2913.member + 1u), _e2913.member_1);
                                        phi_4274_ = type_35(1u, _e2913.member);
                                    } else {
                                        phi_4247_ = _e2913;
                                        phi_4274_ = type_35(0u, type_35().member_1);
                                    }
                                    let _e2931 = phi_4247_;
                                    let _e2933 = phi_4274_;
                                    let _e2937 = (bitcast<i32>(_e2933.member) != 0i);
                                    if _e2937 {
                                        if (_e2933.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2940 = local_5[_e2933.member_1];
                                        let _e2948 = (((_e2895 * _e2940[0]) + (_e2898 * _e2940[1])) + (_e2901 * _e2940[2]));
                                        if (_e2933.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2951 = local_6[_e2933.member_1];
                                        let _e2959 = (((_e2895 * _e2951[0]) + (_e2898 * _e2951[1])) + (_e2901 * _e2951[2]));
                                        if (_e2917 < _e2948) {
                                            phi_4324_ = _e2917;
                                        } else {
                                            phi_4324_ = _e2948;
                                        }
                                        let _e2962 = phi_4324_;
                                        if (_e2962 < _e2959) {
                                            phi_4329_ = _e2962;
                                        } else {
                                            phi_4329_ = _e2959;
                                        }
                                        let _e2965 = phi_4329_;
                                        if (_e2915 > _e2948) {
                                            phi_4334_ = _e2915;
                                        } else {
                                            phi_4334_ = _e2948;
                                        }
                                        let _e2968 = phi_4334_;
                                        if (_e2968 > _e2959) {
                                            phi_4339_ = _e2968;
                                        } else {
                                            phi_4339_ = _e2959;
                                        }
                                        let _e2971 = phi_4339_;
                                        phi_4250_ = _e2971;
                                        phi_4252_ = _e2965;
                                    } else {
                                        phi_4250_ = f32();
                                        phi_4252_ = f32();
                                    }
                                    let _e2973 = phi_4250_;
                                    let _e2975 = phi_4252_;
                                    continue;
                                    continuing {
                                        phi_4246_ = _e2931;
                                        phi_4249_ = _e2973;
                                        phi_4251_ = _e2975;
                                        break if !(_e2937);
                                    }
                                }
                                if (_e2895 < 0f) {
                                    phi_4345_ = -(_e2895);
                                } else {
                                    phi_4345_ = _e2895;
                                }
                                let _e2980 = phi_4345_;
                                if (_e2898 < 0f) {
                                    phi_4351_ = -(_e2898);
                                } else {
                                    phi_4351_ = _e2898;
                                }
                                let _e2984 = phi_4351_;
                                if (_e2901 < 0f) {
                                    phi_4358_ = -(_e2901);
                                } else {
                                    phi_4358_ = _e2901;
                                }
                                let _e2989 = phi_4358_;
                                let _e2990 = ((_e2980 + _e2984) + _e2989);
                                let _e2995 = local_52;
                                let _e2996 = -(_e2995);
                                let _e2998 = local_53;
                                if (_e2998 > _e2996) {
                                    let _e5527 = local_67;
                                    phi_4368_ = _e5527;
                                } else {
                                    phi_4368_ = _e2996;
                                }
                                let _e3001 = phi_4368_;
                                let _e3006 = (((_e3001 - ((_e2990 * _e2885) * (0.000000059604645f * 17f))) - (_e2990 * _e2892)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e3009 = ((_e2656 * _e2650) - (_e2659 * _e2649));
                                let _e3012 = ((_e2659 * _e2648) - (_e2653 * _e2650));
                                let _e3015 = ((_e2653 * _e2649) - (_e2656 * _e2648));
                                let _e3017 = local_5[0u];
                                let _e3025 = (((_e3009 * _e3017[0]) + (_e3012 * _e3017[1])) + (_e3015 * _e3017[2]));
                                phi_4399_ = type_35(0u, 4u);
                                phi_4402_ = _e3025;
                                phi_4404_ = _e3025;
                                loop {
                                    let _e3027 = phi_4399_;
                                    let _e3029 = phi_4402_;
                                    let _e3031 = phi_4404_;
                                    local_54 = _e3029;
                                    local_55 = _e3031;
                                    local_68 = _e3031;
                                    if (_e3027.member < _e3027.member_1) {
                                        phi_4400_ = type_35((_e3027.member + 1u), _e3027.member_1);
                                        phi_4427_ = type_35(1u, _e3027.member);
                                    } else {
                                        phi_4400_ = _e3027;
                                        phi_4427_ = type_35(0u, type_35().member_1);
                                    }
                                    let _e3045 = phi_4400_;
                                    let _e3047 = phi_4427_;
                                    let _e3051 = (bitcast<i32>(_e3047.member) != 0i);
                                    if _e3051 {
                                        if (_e3047.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e3054 = local_5[_e3047.member_1];
                                        let _e3062 = (((_e3009 * _e3054[0]) + (_e3012 * _e3054[1])) + (_e3015 * _e3054[2]));
                                        if (_e3047.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e3065 = local_6[_e3047.member_1];
                                        let _e3073 = (((_e3009 * _e3065[0]) + (_e3012 * _e3065[1])) + (_e3015 * _e3065[2]));
                                        if (_e3031 < _e3062) {
                                            phi_4477_ = _e3031;
                                        } else {
                                            phi_4477_ = _e3062;
                                        }
                                        let _e3076 = phi_4477_;
                                        if (_e3076 < _e3073) {
                                            phi_4482_ = _e3076;
                                        } else {
                                            phi_4482_ = _e3073;
                                        }
                                        let _e3079 = phi_4482_;
                                        if (_e3029 > _e3062) {
                                            phi_4487_ = _e3029;
                                        } else {
                                            phi_4487_ = _e3062;
                                        }
                                        let _e3082 = phi_4487_;
                                        if (_e3082 > _e3073) {
                                            phi_4492_ = _e3082;
                                        } else {
                                            phi_4492_ = _e3073;
                                        }
                                        let _e3085 = phi_4492_;
                                        phi_4403_ = _e3085;
                                        phi_4405_ = _e3079;
                                    } else {
                                        phi_4403_ = f32();
                                        phi_4405_ = f32();
                                    }
                                    let _e3087 = phi_4403_;
                                    let _e3089 = phi_4405_;
                                    continue;
                                    continuing {
                                        phi_4399_ = _e3045;
                                        phi_4402_ = _e3087;
                                        phi_4404_ = _e3089;
                                        break if !(_e3051);
                                    }
                                }
                                if (_e3009 < 0f) {
                                    phi_4498_ = -(_e3009);
                                } else {
                                    phi_4498_ = _e3009;
                                }
                                let _e3094 = phi_4498_;
                                if (_e3012 < 0f) {
                                    phi_4504_ = -(_e3012);
                                } else {
                                    phi_4504_ = _e3012;
                                }
                                let _e3098 = phi_4504_;
                                if (_e3015 < 0f) {
                                    phi_4511_ = -(_e3015);
                                } else {
                                    phi_4511_ = _e3015;
                                }
                                let _e3103 = phi_4511_;
                                let _e3104 = ((_e3094 + _e3098) + _e3103);
                                let _e3109 = local_54;
                                let _e3110 = -(_e3109);
                                let _e3112 = local_55;
                                if (_e3112 > _e3110) {
                                    let _e5546 = local_68;
                                    phi_4521_ = _e5546;
                                } else {
                                    phi_4521_ = _e3110;
                                }
                                let _e3115 = phi_4521_;
                                let _e3120 = (((_e3115 - ((_e3104 * _e2885) * (0.000000059604645f * 17f))) - (_e3104 * _e2892)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e3006 > _e3120) {
                                    phi_4531_ = _e3006;
                                } else {
                                    phi_4531_ = _e3120;
                                }
                                let _e3123 = phi_4531_;
                                phi_4699_ = (_e3123 > 0f);
                            }
                            let _e3126 = phi_4699_;
                            if _e3126 {
                                phi_8135_ = false;
                            } else {
                                let _e3129 = local_7.member[0u];
                                let _e3135 = local_7.member[1u];
                                let _e3142 = ((_e3129[0] + _e3135[0]) * 0.5f);
                                let _e3143 = ((_e3129[1] + _e3135[1]) * 0.5f);
                                let _e3144 = ((_e3129[2] + _e3135[2]) * 0.5f);
                                let _e3147 = local_7.member_1[0u];
                                let _e3153 = local_7.member_1[1u];
                                let _e3160 = ((_e3147[0] + _e3153[0]) * 0.5f);
                                let _e3161 = ((_e3147[1] + _e3153[1]) * 0.5f);
                                let _e3162 = ((_e3147[2] + _e3153[2]) * 0.5f);
                                let _e3165 = local_7.member_2[0u];
                                let _e3171 = local_7.member_2[1u];
                                let _e3178 = ((_e3165[0] + _e3171[0]) * 0.5f);
                                let _e3179 = ((_e3165[1] + _e3171[1]) * 0.5f);
                                let _e3180 = ((_e3165[2] + _e3171[2]) * 0.5f);
                                let _e3183 = local_7.member[0u];
                                let _e3186 = local_7.member_1[0u];
                                let _e3189 = local_7.member_2[0u];
                                let _e3191 = local_7.member_3;
                                let _e3194 = local_7.member[1u];
                                let _e3197 = local_7.member_1[1u];
                                let _e3200 = local_7.member_2[1u];
                                let _e3202 = local_7.member_3;
                                local_4 = array<type_70, 2>(type_70(array<array<f32, 3>, 2>(_e3183, array<f32, 3>(_e3142, _e3143, _e3144)), array<array<f32, 3>, 2>(_e3186, array<f32, 3>(_e3160, _e3161, _e3162)), array<array<f32, 3>, 2>(_e3189, array<f32, 3>(_e3178, _e3179, _e3180)), _e3191), type_70(array<array<f32, 3>, 2>(array<f32, 3>(_e3142, _e3143, _e3144), _e3194), array<array<f32, 3>, 2>(array<f32, 3>(_e3160, _e3161, _e3162), _e3197), array<array<f32, 3>, 2>(array<f32, 3>(_e3178, _e3179, _e3180), _e3200), _e3202));
                                let _e3221 = local_4[0u].member_1[0u];
                                let _e3227 = local_4[0u].member_2[0u];
                                let _e3233 = ((_e3221[1] * _e3227[2]) - (_e3221[2] * _e3227[1]));
                                let _e3236 = ((_e3221[2] * _e3227[0]) - (_e3221[0] * _e3227[2]));
                                let _e3239 = ((_e3221[0] * _e3227[1]) - (_e3221[1] * _e3227[0]));
                                let _e3242 = local_4[0u].member_1[1u];
                                let _e3248 = local_4[0u].member_2[1u];
                                let _e3254 = ((_e3242[1] * _e3248[2]) - (_e3242[2] * _e3248[1]));
                                let _e3257 = ((_e3242[2] * _e3248[0]) - (_e3242[0] * _e3248[2]));
                                let _e3260 = ((_e3242[0] * _e3248[1]) - (_e3242[1] * _e3248[0]));
                                let _e3263 = local_4[0u].member_1[0u];
                                let _e3269 = local_4[0u].member_2[1u];
                                let _e3284 = local_4[0u].member_1[1u];
                                let _e3290 = local_4[0u].member_2[0u];
                                let _e3303 = (((_e3263[1] * _e3269[2]) - (_e3263[2] * _e3269[1])) + ((_e3284[1] * _e3290[2]) - (_e3284[2] * _e3290[1])));
                                let _e3304 = (((_e3263[2] * _e3269[0]) - (_e3263[0] * _e3269[2])) + ((_e3284[2] * _e3290[0]) - (_e3284[0] * _e3290[2])));
                                let _e3305 = (((_e3263[0] * _e3269[1]) - (_e3263[1] * _e3269[0])) + ((_e3284[0] * _e3290[1]) - (_e3284[1] * _e3290[0])));
                                let _e3308 = local_4[0u].member[0u];
                                let _e3319 = local_4[0u].member[1u];
                                let _e3330 = local_4[0u].member[0u];
                                let _e3339 = ((((_e3319[0] * _e3233) + (_e3319[1] * _e3236)) + (_e3319[2] * _e3239)) + (((_e3330[0] * _e3303) + (_e3330[1] * _e3304)) + (_e3330[2] * _e3305)));
                                let _e3342 = local_4[0u].member[0u];
                                let _e3353 = local_4[0u].member[1u];
                                let _e3362 = ((((_e3342[0] * _e3254) + (_e3342[1] * _e3257)) + (_e3342[2] * _e3260)) + (((_e3353[0] * _e3303) + (_e3353[1] * _e3304)) + (_e3353[2] * _e3305)));
                                let _e3365 = local_4[0u].member[1u];
                                let _e3376 = local_4[0u].member[0u];
                                if (_e3376[0] < 0f) {
                                    phi_5156_ = -(_e3376[0]);
                                } else {
                                    phi_5156_ = _e3376[0];
                                }
                                let _e3383 = phi_5156_;
                                if (_e3376[1] < 0f) {
                                    phi_5163_ = -(_e3376[1]);
                                } else {
                                    phi_5163_ = _e3376[1];
                                }
                                let _e3387 = phi_5163_;
                                if (_e3383 > _e3387) {
                                    phi_5168_ = _e3383;
                                } else {
                                    phi_5168_ = _e3387;
                                }
                                let _e3390 = phi_5168_;
                                if (_e3376[2] < 0f) {
                                    phi_5175_ = -(_e3376[2]);
                                } else {
                                    phi_5175_ = _e3376[2];
                                }
                                let _e3394 = phi_5175_;
                                if (_e3390 > _e3394) {
                                    phi_5180_ = _e3390;
                                } else {
                                    phi_5180_ = _e3394;
                                }
                                let _e3397 = phi_5180_;
                                let _e3400 = local_4[0u].member[1u];
                                if (_e3400[0] < 0f) {
                                    phi_5193_ = -(_e3400[0]);
                                } else {
                                    phi_5193_ = _e3400[0];
                                }
                                let _e3407 = phi_5193_;
                                if (_e3400[1] < 0f) {
                                    phi_5200_ = -(_e3400[1]);
                                } else {
                                    phi_5200_ = _e3400[1];
                                }
                                let _e3411 = phi_5200_;
                                if (_e3407 > _e3411) {
                                    phi_5205_ = _e3407;
                                } else {
                                    phi_5205_ = _e3411;
                                }
                                let _e3414 = phi_5205_;
                                if (_e3400[2] < 0f) {
                                    phi_5212_ = -(_e3400[2]);
                                } else {
                                    phi_5212_ = _e3400[2];
                                }
                                let _e3418 = phi_5212_;
                                if (_e3414 > _e3418) {
                                    phi_5217_ = _e3414;
                                } else {
                                    phi_5217_ = _e3418;
                                }
                                let _e3421 = phi_5217_;
                                if (_e3397 > _e3421) {
                                    phi_5222_ = _e3397;
                                } else {
                                    phi_5222_ = _e3421;
                                }
                                let _e3424 = phi_5222_;
                                let _e3426 = local_4[0u].member_3;
                                let _e3427 = (_e3424 + _e3426);
                                let _e3430 = local_4[0u].member_1[0u];
                                if (_e3430[0] < 0f) {
                                    phi_5239_ = -(_e3430[0]);
                                } else {
                                    phi_5239_ = _e3430[0];
                                }
                                let _e3437 = phi_5239_;
                                if (_e3430[1] < 0f) {
                                    phi_5246_ = -(_e3430[1]);
                                } else {
                                    phi_5246_ = _e3430[1];
                                }
                                let _e3441 = phi_5246_;
                                if (_e3437 > _e3441) {
                                    phi_5251_ = _e3437;
                                } else {
                                    phi_5251_ = _e3441;
                                }
                                let _e3444 = phi_5251_;
                                if (_e3430[2] < 0f) {
                                    phi_5258_ = -(_e3430[2]);
                                } else {
                                    phi_5258_ = _e3430[2];
                                }
                                let _e3448 = phi_5258_;
                                if (_e3444 > _e3448) {
                                    phi_5263_ = _e3444;
                                } else {
                                    phi_5263_ = _e3448;
                                }
                                let _e3451 = phi_5263_;
                                let _e3454 = local_4[0u].member_1[1u];
                                if (_e3454[0] < 0f) {
                                    phi_5277_ = -(_e3454[0]);
                                } else {
                                    phi_5277_ = _e3454[0];
                                }
                                let _e3461 = phi_5277_;
                                if (_e3454[1] < 0f) {
                                    phi_5284_ = -(_e3454[1]);
                                } else {
                                    phi_5284_ = _e3454[1];
                                }
                                let _e3465 = phi_5284_;
                                if (_e3461 > _e3465) {
                                    phi_5289_ = _e3461;
                                } else {
                                    phi_5289_ = _e3465;
                                }
                                let _e3468 = phi_5289_;
                                if (_e3454[2] < 0f) {
                                    phi_5296_ = -(_e3454[2]);
                                } else {
                                    phi_5296_ = _e3454[2];
                                }
                                let _e3472 = phi_5296_;
                                if (_e3468 > _e3472) {
                                    phi_5301_ = _e3468;
                                } else {
                                    phi_5301_ = _e3472;
                                }
                                let _e3475 = phi_5301_;
                                if (_e3451 > _e3475) {
                                    phi_5306_ = _e3451;
                                } else {
                                    phi_5306_ = _e3475;
                                }
                                let _e3478 = phi_5306_;
                                let _e3480 = local_4[0u].member_3;
                                let _e3481 = (_e3478 + _e3480);
                                let _e3484 = local_4[0u].member_2[0u];
                                if (_e3484[0] < 0f) {
                                    phi_5323_ = -(_e3484[0]);
                                } else {
                                    phi_5323_ = _e3484[0];
                                }
                                let _e3491 = phi_5323_;
                                if (_e3484[1] < 0f) {
                                    phi_5330_ = -(_e3484[1]);
                                } else {
                                    phi_5330_ = _e3484[1];
                                }
                                let _e3495 = phi_5330_;
                                if (_e3491 > _e3495) {
                                    phi_5335_ = _e3491;
                                } else {
                                    phi_5335_ = _e3495;
                                }
                                let _e3498 = phi_5335_;
                                if (_e3484[2] < 0f) {
                                    phi_5342_ = -(_e3484[2]);
                                } else {
                                    phi_5342_ = _e3484[2];
                                }
                                let _e3502 = phi_5342_;
                                if (_e3498 > _e3502) {
                                    phi_5347_ = _e3498;
                                } else {
                                    phi_5347_ = _e3502;
                                }
                                let _e3505 = phi_5347_;
                                let _e3508 = local_4[0u].member_2[1u];
                                if (_e3508[0] < 0f) {
                                    phi_5361_ = -(_e3508[0]);
                                } else {
                                    phi_5361_ = _e3508[0];
                                }
                                let _e3515 = phi_5361_;
                                if (_e3508[1] < 0f) {
                                    phi_5368_ = -(_e3508[1]);
                                } else {
                                    phi_5368_ = _e3508[1];
                                }
                                let _e3519 = phi_5368_;
                                if (_e3515 > _e3519) {
                                    phi_5373_ = _e3515;
                                } else {
                                    phi_5373_ = _e3519;
                                }
                                let _e3522 = phi_5373_;
                                if (_e3508[2] < 0f) {
                                    phi_5380_ = -(_e3508[2]);
                                } else {
                                    phi_5380_ = _e3508[2];
                                }
                                let _e3526 = phi_5380_;
                                if (_e3522 > _e3526) {
                                    phi_5385_ = _e3522;
                                } else {
                                    phi_5385_ = _e3526;
                                }
                                let _e3529 = phi_5385_;
                                if (_e3505 > _e3529) {
                                    phi_5390_ = _e3505;
                                } else {
                                    phi_5390_ = _e3529;
                                }
                                let _e3532 = phi_5390_;
                                let _e3534 = local_4[0u].member_3;
                                let _e3535 = (_e3532 + _e3534);
                                let _e3537 = ((_e3481 * 8f) * _e3535);
                                let _e3544 = local_4[0u].member_3;
                                if (_e3233 < 0f) {
                                    phi_5421_ = -(_e3233);
                                } else {
                                    phi_5421_ = _e3233;
                                }
                                let _e3561 = phi_5421_;
                                if (_e3236 < 0f) {
                                    phi_5427_ = -(_e3236);
                                } else {
                                    phi_5427_ = _e3236;
                                }
                                let _e3565 = phi_5427_;
                                if (_e3239 < 0f) {
                                    phi_5434_ = -(_e3239);
                                } else {
                                    phi_5434_ = _e3239;
                                }
                                let _e3570 = phi_5434_;
                                let _e3571 = ((_e3561 + _e3565) + _e3570);
                                if (_e3254 < 0f) {
                                    phi_5441_ = -(_e3254);
                                } else {
                                    phi_5441_ = _e3254;
                                }
                                let _e3575 = phi_5441_;
                                if (_e3257 < 0f) {
                                    phi_5447_ = -(_e3257);
                                } else {
                                    phi_5447_ = _e3257;
                                }
                                let _e3579 = phi_5447_;
                                if (_e3260 < 0f) {
                                    phi_5454_ = -(_e3260);
                                } else {
                                    phi_5454_ = _e3260;
                                }
                                let _e3584 = phi_5454_;
                                let _e3585 = ((_e3575 + _e3579) + _e3584);
                                if (_e3571 > _e3585) {
                                    phi_5460_ = _e3571;
                                } else {
                                    phi_5460_ = _e3585;
                                }
                                let _e3588 = phi_5460_;
                                if (_e3303 < 0f) {
                                    phi_5466_ = -(_e3303);
                                } else {
                                    phi_5466_ = _e3303;
                                }
                                let _e3592 = phi_5466_;
                                if (_e3304 < 0f) {
                                    phi_5472_ = -(_e3304);
                                } else {
                                    phi_5472_ = _e3304;
                                }
                                let _e3596 = phi_5472_;
                                if (_e3305 < 0f) {
                                    phi_5479_ = -(_e3305);
                                } else {
                                    phi_5479_ = _e3305;
                                }
                                let _e3601 = phi_5479_;
                                let _e3603 = (((_e3592 + _e3596) + _e3601) * 0.5f);
                                if (_e3588 > _e3603) {
                                    phi_5486_ = _e3588;
                                } else {
                                    phi_5486_ = _e3603;
                                }
                                let _e3606 = phi_5486_;
                                let _e3611 = local_4[0u].member_3;
                                let _e3624 = ((((_e3308[0] * _e3233) + (_e3308[1] * _e3236)) + (_e3308[2] * _e3239)) * 3f);
                                let _e3625 = ((((_e3365[0] * _e3254) + (_e3365[1] * _e3257)) + (_e3365[2] * _e3260)) * 3f);
                                if (_e3624 < _e3625) {
                                    phi_5510_ = _e3624;
                                } else {
                                    phi_5510_ = _e3625;
                                }
                                let _e3628 = phi_5510_;
                                if (_e3339 < _e3362) {
                                    phi_5515_ = _e3339;
                                } else {
                                    phi_5515_ = _e3362;
                                }
                                let _e3631 = phi_5515_;
                                if (_e3628 < _e3631) {
                                    phi_5520_ = _e3628;
                                } else {
                                    phi_5520_ = _e3631;
                                }
                                let _e3634 = phi_5520_;
                                if (_e3624 > _e3625) {
                                    phi_5525_ = _e3624;
                                } else {
                                    phi_5525_ = _e3625;
                                }
                                let _e3637 = phi_5525_;
                                if (_e3339 > _e3362) {
                                    phi_5530_ = _e3339;
                                } else {
                                    phi_5530_ = _e3362;
                                }
                                let _e3640 = phi_5530_;
                                if (_e3637 > _e3640) {
                                    phi_5535_ = _e3637;
                                } else {
                                    phi_5535_ = _e3640;
                                }
                                let _e3643 = phi_5535_;
                                let _e3648 = -(_e3643);
                                if (_e3634 > _e3648) {
                                    phi_5545_ = _e3634;
                                } else {
                                    phi_5545_ = _e3648;
                                }
                                let _e3651 = phi_5545_;
                                if ((_e3651 - ((((((_e3427 * 8f) * _e3537) * (0.000000059604645f * (490f / 64f))) + ((_e3544 * 19f) * ((_e3427 * (_e3481 + _e3535)) + (_e3481 * _e3535)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3427) * ((1f + _e3481) * (1f + _e3535))))) + ((_e2108 * (((_e3606 + (_e3537 * (0.000000059604645f * 4f))) + ((_e3611 * 6f) * (_e3481 + _e3535))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3481) * (1f + _e3535))))) * (3f * 1.0001f)))) > 0f) {
                                    phi_6521_ = true;
                                } else {
                                    let _e3656 = local_4[0u].member_1[0u];
                                    let _e3662 = local_4[0u].member_1[1u];
                                    let _e3666 = (_e3656[0] + _e3662[0]);
                                    let _e3667 = (_e3656[1] + _e3662[1]);
                                    let _e3668 = (_e3656[2] + _e3662[2]);
                                    let _e3671 = local_4[0u].member_2[0u];
                                    let _e3677 = local_4[0u].member_2[1u];
                                    let _e3681 = (_e3671[0] + _e3677[0]);
                                    let _e3682 = (_e3671[1] + _e3677[1]);
                                    let _e3683 = (_e3671[2] + _e3677[2]);
                                    let _e3686 = ((_e3667 * _e3683) - (_e3668 * _e3682));
                                    let _e3689 = ((_e3668 * _e3681) - (_e3666 * _e3683));
                                    let _e3692 = ((_e3666 * _e3682) - (_e3667 * _e3681));
                                    let _e3695 = local_4[0u].member[0u];
                                    let _e3701 = local_4[0u].member_1[0u];
                                    let _e3707 = local_4[0u].member_2[0u];
                                    let _e3711 = (_e3695[0] - _e3701[0]);
                                    let _e3712 = (_e3695[1] - _e3701[1]);
                                    let _e3713 = (_e3695[2] - _e3701[2]);
                                    let _e3722 = local_4[0u].member[1u];
                                    let _e3728 = local_4[0u].member_1[1u];
                                    let _e3734 = local_4[0u].member_2[1u];
                                    let _e3738 = (_e3722[0] - _e3728[0]);
                                    let _e3739 = (_e3722[1] - _e3728[1]);
                                    let _e3740 = (_e3722[2] - _e3728[2]);
                                    local_2 = array<array<f32, 3>, 4>(_e3695, array<f32, 3>(_e3711, _e3712, _e3713), array<f32, 3>((_e3695[0] - _e3707[0]), (_e3695[1] - _e3707[1]), (_e3695[2] - _e3707[2])), array<f32, 3>((_e3711 - _e3707[0]), (_e3712 - _e3707[1]), (_e3713 - _e3707[2])));
                                    local_3 = array<array<f32, 3>, 4>(_e3722, array<f32, 3>(_e3738, _e3739, _e3740), array<f32, 3>((_e3722[0] - _e3734[0]), (_e3722[1] - _e3734[1]), (_e3722[2] - _e3734[2])), array<f32, 3>((_e3738 - _e3734[0]), (_e3739 - _e3734[1]), (_e3740 - _e3734[2])));
                                    let _e3757 = local_4[0u].member[0u];
                                    if (_e3757[0] < 0f) {
                                        phi_5796_ = -(_e3757[0]);
                                    } else {
                                        phi_5796_ = _e3757[0];
                                    }
                                    let _e3764 = phi_5796_;
                                    if (_e3757[1] < 0f) {
                                        phi_5803_ = -(_e3757[1]);
                                    } else {
                                        phi_5803_ = _e3757[1];
                                    }
                                    let _e3768 = phi_5803_;
                                    if (_e3764 > _e3768) {
                                        phi_5808_ = _e3764;
                                    } else {
                                        phi_5808_ = _e3768;
                                    }
                                    let _e3771 = phi_5808_;
                                    if (_e3757[2] < 0f) {
                                        phi_5815_ = -(_e3757[2]);
                                    } else {
                                        phi_5815_ = _e3757[2];
                                    }
                                    let _e3775 = phi_5815_;
                                    if (_e3771 > _e3775) {
                                        phi_5820_ = _e3771;
                                    } else {
                                        phi_5820_ = _e3775;
                                    }
                                    let _e3778 = phi_5820_;
                                    let _e3781 = local_4[0u].member[1u];
                                    if (_e3781[0] < 0f) {
                                        phi_5833_ = -(_e3781[0]);
                                    } else {
                                        phi_5833_ = _e3781[0];
                                    }
                                    let _e3788 = phi_5833_;
                                    if (_e3781[1] < 0f) {
                                        phi_5840_ = -(_e3781[1]);
                                    } else {
                                        phi_5840_ = _e3781[1];
                                    }
                                    let _e3792 = phi_5840_;
                                    if (_e3788 > _e3792) {
                                        phi_5845_ = _e3788;
                                    } else {
                                        phi_5845_ = _e3792;
                                    }
                                    let _e3795 = phi_5845_;
                                    if (_e3781[2] < 0f) {
                                        phi_5852_ = -(_e3781[2]);
                                    } else {
                                        phi_5852_ = _e3781[2];
                                    }
                                    let _e3799 = phi_5852_;
                                    if (_e3795 > _e3799) {
                                        phi_5857_ = _e3795;
                                    } else {
                                        phi_5857_ = _e3799;
                                    }
                                    let _e3802 = phi_5857_;
                                    if (_e3778 > _e3802) {
                                        phi_5862_ = _e3778;
                                    } else {
                                        phi_5862_ = _e3802;
                                    }
                                    let _e3805 = phi_5862_;
                                    let _e3807 = local_4[0u].member_3;
                                    let _e3811 = local_4[0u].member_1[0u];
                                    if (_e3811[0] < 0f) {
                                        phi_5879_ = -(_e3811[0]);
                                    } else {
                                        phi_5879_ = _e3811[0];
                                    }
                                    let _e3818 = phi_5879_;
                                    if (_e3811[1] < 0f) {
                                        phi_5886_ = -(_e3811[1]);
                                    } else {
                                        phi_5886_ = _e3811[1];
                                    }
                                    let _e3822 = phi_5886_;
                                    if (_e3818 > _e3822) {
                                        phi_5891_ = _e3818;
                                    } else {
                                        phi_5891_ = _e3822;
                                    }
                                    let _e3825 = phi_5891_;
                                    if (_e3811[2] < 0f) {
                                        phi_5898_ = -(_e3811[2]);
                                    } else {
                                        phi_5898_ = _e3811[2];
                                    }
                                    let _e3829 = phi_5898_;
                                    if (_e3825 > _e3829) {
                                        phi_5903_ = _e3825;
                                    } else {
                                        phi_5903_ = _e3829;
                                    }
                                    let _e3832 = phi_5903_;
                                    let _e3835 = local_4[0u].member_1[1u];
                                    if (_e3835[0] < 0f) {
                                        phi_5917_ = -(_e3835[0]);
                                    } else {
                                        phi_5917_ = _e3835[0];
                                    }
                                    let _e3842 = phi_5917_;
                                    if (_e3835[1] < 0f) {
                                        phi_5924_ = -(_e3835[1]);
                                    } else {
                                        phi_5924_ = _e3835[1];
                                    }
                                    let _e3846 = phi_5924_;
                                    if (_e3842 > _e3846) {
                                        phi_5929_ = _e3842;
                                    } else {
                                        phi_5929_ = _e3846;
                                    }
                                    let _e3849 = phi_5929_;
                                    if (_e3835[2] < 0f) {
                                        phi_5936_ = -(_e3835[2]);
                                    } else {
                                        phi_5936_ = _e3835[2];
                                    }
                                    let _e3853 = phi_5936_;
                                    if (_e3849 > _e3853) {
                                        phi_5941_ = _e3849;
                                    } else {
                                        phi_5941_ = _e3853;
                                    }
                                    let _e3856 = phi_5941_;
                                    if (_e3832 > _e3856) {
                                        phi_5946_ = _e3832;
                                    } else {
                                        phi_5946_ = _e3856;
                                    }
                                    let _e3859 = phi_5946_;
                                    let _e3861 = local_4[0u].member_3;
                                    let _e3865 = local_4[0u].member_2[0u];
                                    if (_e3865[0] < 0f) {
                                        phi_5963_ = -(_e3865[0]);
                                    } else {
                                        phi_5963_ = _e3865[0];
                                    }
                                    let _e3872 = phi_5963_;
                                    if (_e3865[1] < 0f) {
                                        phi_5970_ = -(_e3865[1]);
                                    } else {
                                        phi_5970_ = _e3865[1];
                                    }
                                    let _e3876 = phi_5970_;
                                    if (_e3872 > _e3876) {
                                        phi_5975_ = _e3872;
                                    } else {
                                        phi_5975_ = _e3876;
                                    }
                                    let _e3879 = phi_5975_;
                                    if (_e3865[2] < 0f) {
                                        phi_5982_ = -(_e3865[2]);
                                    } else {
                                        phi_5982_ = _e3865[2];
                                    }
                                    let _e3883 = phi_5982_;
                                    if (_e3879 > _e3883) {
                                        phi_5987_ = _e3879;
                                    } else {
                                        phi_5987_ = _e3883;
                                    }
                                    let _e3886 = phi_5987_;
                                    let _e3889 = local_4[0u].member_2[1u];
                                    if (_e3889[0] < 0f) {
                                        phi_6001_ = -(_e3889[0]);
                                    } else {
                                        phi_6001_ = _e3889[0];
                                    }
                                    let _e3896 = phi_6001_;
                                    if (_e3889[1] < 0f) {
                                        phi_6008_ = -(_e3889[1]);
                                    } else {
                                        phi_6008_ = _e3889[1];
                                    }
                                    let _e3900 = phi_6008_;
                                    if (_e3896 > _e3900) {
                                        phi_6013_ = _e3896;
                                    } else {
                                        phi_6013_ = _e3900;
                                    }
                                    let _e3903 = phi_6013_;
                                    if (_e3889[2] < 0f) {
                                        phi_6020_ = -(_e3889[2]);
                                    } else {
                                        phi_6020_ = _e3889[2];
                                    }
                                    let _e3907 = phi_6020_;
                                    if (_e3903 > _e3907) {
                                        phi_6025_ = _e3903;
                                    } else {
                                        phi_6025_ = _e3907;
                                    }
                                    let _e3910 = phi_6025_;
                                    if (_e3886 > _e3910) {
                                        phi_6030_ = _e3886;
                                    } else {
                                        phi_6030_ = _e3910;
                                    }
                                    let _e3913 = phi_6030_;
                                    let _e3915 = local_4[0u].member_3;
                                    let _e3918 = (((_e3805 + _e3807) + (_e3859 + _e3861)) + (_e3913 + _e3915));
                                    let _e3921 = local_4[0u].member_3;
                                    let _e3925 = (((_e2108 * 1.0001f) + (_e3921 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3928 = ((_e3689 * _e3668) - (_e3692 * _e3667));
                                    let _e3931 = ((_e3692 * _e3666) - (_e3686 * _e3668));
                                    let _e3934 = ((_e3686 * _e3667) - (_e3689 * _e3666));
                                    let _e3936 = local_2[0u];
                                    let _e3944 = (((_e3928 * _e3936[0]) + (_e3931 * _e3936[1])) + (_e3934 * _e3936[2]));
                                    phi_6068_ = type_35(0u, 4u);
                                    phi_6071_ = _e3944;
                                    phi_6073_ = _e3944;
                                    loop {
                                        let _e3946 = phi_6068_;
                                        let _e3948 = phi_6071_;
                                        let _e3950 = phi_6073_;
                                        local_56 = _e3948;
                                        local_57 = _e3950;
                                        local_69 = _e3950;
                                        if (_e3946.member < _e3946.member_1) {
                                            phi_6069_ = type_35((_e3946.member + 1u), _e3946.member_1);
                                            phi_6096_ = type_35(1u, _e3946.member);
                                        } else {
                                            phi_6069_ = _e3946;
                                            phi_6096_ = type_35(0u, type_35().member_1);
                                        }
                                        let _e3964 = phi_6069_;
                                        let _e3966 = phi_6096_;
                                        let _e3970 = (bitcast<i32>(_e3966.member) != 0i);
                                        if _e3970 {
                                            if (_e3966.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3973 = local_2[_e3966.member_1];
                                            let _e3981 = (((_e3928 * _e3973[0]) + (_e3931 * _e3973[1])) + (_e3934 * _e3973[2]));
                                            if (_e3966.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3984 = local_3[_e3966.member_1];
                                            let _e3992 = (((_e3928 * _e3984[0]) + (_e3931 * _e3984[1])) + (_e3934 * _e3984[2]));
                                            if (_e3950 < _e3981) {
                                                phi_6146_ = _e3950;
                                            } else {
                                                phi_6146_ = _e3981;
                                            }
                                            let _e3995 = phi_6146_;
                                            if (_e3995 < _e3992) {
                                                phi_6151_ = _e3995;
                                            } else {
                                                phi_6151_ = _e3992;
                                            }
                                            let _e3998 = phi_6151_;
                                            if (_e3948 > _e3981) {
                                                phi_6156_ = _e3948;
                                            } else {
                                                phi_6156_ = _e3981;
                                            }
                                            let _e4001 = phi_6156_;
                                            if (_e4001 > _e3992) {
                                                phi_6161_ = _e4001;
                                            } else {
                                                phi_6161_ = _e3992;
                                            }
                                            let _e4004 = phi_6161_;
                                            phi_6072_ = _e4004;
                                            phi_6074_ = _e3998;
                                        } else {
                                            phi_6072_ = f32();
                                            phi_6074_ = f32();
                                        }
                                        let _e4006 = phi_6072_;
                                        let _e4008 = phi_6074_;
                                        continue;
                                        continuing {
                                            phi_6068_ = _e3964;
                                            phi_6071_ = _e4006;
                                            phi_6073_ = _e4008;
                                            break if !(_e3970);
                                        }
                                    }
                                    if (_e3928 < 0f) {
                                        phi_6167_ = -(_e3928);
                                    } else {
                                        phi_6167_ = _e3928;
                                    }
                                    let _e4013 = phi_6167_;
                                    if (_e3931 < 0f) {
                                        phi_6173_ = -(_e3931);
                                    } else {
                                        phi_6173_ = _e3931;
                                    }
                                    let _e4017 = phi_6173_;
                                    if (_e3934 < 0f) {
                                        phi_6180_ = -(_e3934);
                                    } else {
                                        phi_6180_ = _e3934;
                                    }
                                    let _e4022 = phi_6180_;
                                    let _e4023 = ((_e4013 + _e4017) + _e4022);
                                    let _e4028 = local_56;
                                    let _e4029 = -(_e4028);
                                    let _e4031 = local_57;
                                    if (_e4031 > _e4029) {
                                        let _e5651 = local_69;
                                        phi_6190_ = _e5651;
                                    } else {
                                        phi_6190_ = _e4029;
                                    }
                                    let _e4034 = phi_6190_;
                                    let _e4039 = (((_e4034 - ((_e4023 * _e3918) * (0.000000059604645f * 17f))) - (_e4023 * _e3925)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e4042 = ((_e3689 * _e3683) - (_e3692 * _e3682));
                                    let _e4045 = ((_e3692 * _e3681) - (_e3686 * _e3683));
                                    let _e4048 = ((_e3686 * _e3682) - (_e3689 * _e3681));
                                    let _e4050 = local_2[0u];
                                    let _e4058 = (((_e4042 * _e4050[0]) + (_e4045 * _e4050[1])) + (_e4048 * _e4050[2]));
                                    phi_6221_ = type_35(0u, 4u);
                                    phi_6224_ = _e4058;
                                    phi_6226_ = _e4058;
                                    loop {
                                        let _e4060 = phi_6221_;
                                        let _e4062 = phi_6224_;
                                        let _e4064 = phi_6226_;
                                        local_58 = _e4062;
                                        local_59 = _e4064;
                                        local_70 = _e4064;
                                        if (_e4060.member < _e4060.member_1) {
                                            phi_6222_ = type_35((_e4060.member + 1u), _e4060.member_1);
                                            phi_6249_ = type_35(1u, _e4060.member);
                                        } else {
                                            phi_6222_ = _e4060;
                                            phi_6249_ = type_35(0u, type_35().member_1);
                                        }
                                        let _e4078 = phi_6222_;
                                        let _e4080 = phi_6249_;
                                        let _e4084 = (bitcast<i32>(_e4080.member) != 0i);
                                        if _e4084 {
                                            if (_e4080.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e4087 = local_2[_e4080.member_1];
                                            let _e4095 = (((_e4042 * _e4087[0]) + (_e4045 * _e4087[1])) + (_e4048 * _e4087[2]));
                                            if (_e4080.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e4098 = local_3[_e4080.member_1];
                                            let _e4106 = (((_e4042 * _e4098[0]) + (_e4045 * _e4098[1])) + (_e4048 * _e4098[2]));
                                            if (_e4064 < _e4095) {
                                                phi_6299_ = _e4064;
                                            } else {
                                                phi_6299_ = _e4095;
                                            }
                                            let _e4109 = phi_6299_;
                                            if (_e4109 < _e4106) {
                                                phi_6304_ = _e4109;
                                            } else {
                                                phi_6304_ = _e4106;
                                            }
                                            let _e4112 = phi_6304_;
                                            if (_e4062 > _e4095) {
                                                phi_6309_ = _e4062;
                                            } else {
                                                phi_6309_ = _e4095;
                                            }
                                            let _e4115 = phi_6309_;
                                            if (_e4115 > _e4106) {
                                                phi_6314_ = _e4115;
                                            } else {
                                                phi_6314_ = _e4106;
                                            }
                                            let _e4118 = phi_6314_;
                                            phi_6225_ = _e4118;
                                            phi_6227_ = _e4112;
                                        } else {
                                            phi_6225_ = f32();
                                            phi_6227_ = f32();
                                        }
                                        let _e4120 = phi_6225_;
                                        let _e4122 = phi_6227_;
                                        continue;
                                        continuing {
                                            phi_6221_ = _e4078;
                                            phi_6224_ = _e4120;
                                            phi_6226_ = _e4122;
                                            break if !(_e4084);
                                        }
                                    }
                                    if (_e4042 < 0f) {
                                        phi_6320_ = -(_e4042);
                                    } else {
                                        phi_6320_ = _e4042;
                                    }
                                    let _e4127 = phi_6320_;
                                    if (_e4045 < 0f) {
                                        phi_6326_ = -(_e4045);
                                    } else {
                                        phi_6326_ = _e4045;
                                    }
                                    let _e4131 = phi_6326_;
                                    if (_e4048 < 0f) {
                                        phi_6333_ = -(_e4048);
                                    } else {
                                        phi_6333_ = _e4048;
                                    }
                                    let _e4136 = phi_6333_;
                                    let _e4137 = ((_e4127 + _e4131) + _e4136);
                                    let _e4142 = local_58;
                                    let _e4143 = -(_e4142);
                                    let _e4145 = local_59;
                                    if (_e4145 > _e4143) {
                                        let _e5670 = local_70;
                                        phi_6343_ = _e5670;
                                    } else {
                                        phi_6343_ = _e4143;
                                    }
                                    let _e4148 = phi_6343_;
                                    let _e4153 = (((_e4148 - ((_e4137 * _e3918) * (0.000000059604645f * 17f))) - (_e4137 * _e3925)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e4039 > _e4153) {
                                        phi_6353_ = _e4039;
                                    } else {
                                        phi_6353_ = _e4153;
                                    }
                                    let _e4156 = phi_6353_;
                                    phi_6521_ = (_e4156 > 0f);
                                }
                                let _e4159 = phi_6521_;
                                if _e4159 {
                                    let _e4163 = local_4[1u].member_1[0u];
                                    let _e4169 = local_4[1u].member_2[0u];
                                    let _e4175 = ((_e4163[1] * _e4169[2]) - (_e4163[2] * _e4169[1]));
                                    let _e4178 = ((_e4163[2] * _e4169[0]) - (_e4163[0] * _e4169[2]));
                                    let _e4181 = ((_e4163[0] * _e4169[1]) - (_e4163[1] * _e4169[0]));
                                    let _e4184 = local_4[1u].member_1[1u];
                                    let _e4190 = local_4[1u].member_2[1u];
                                    let _e4196 = ((_e4184[1] * _e4190[2]) - (_e4184[2] * _e4190[1]));
                                    let _e4199 = ((_e4184[2] * _e4190[0]) - (_e4184[0] * _e4190[2]));
                                    let _e4202 = ((_e4184[0] * _e4190[1]) - (_e4184[1] * _e4190[0]));
                                    let _e4205 = local_4[1u].member_1[0u];
                                    let _e4211 = local_4[1u].member_2[1u];
                                    let _e4226 = local_4[1u].member_1[1u];
                                    let _e4232 = local_4[1u].member_2[0u];
                                    let _e4245 = (((_e4205[1] * _e4211[2]) - (_e4205[2] * _e4211[1])) + ((_e4226[1] * _e4232[2]) - (_e4226[2] * _e4232[1])));
                                    let _e4246 = (((_e4205[2] * _e4211[0]) - (_e4205[0] * _e4211[2])) + ((_e4226[2] * _e4232[0]) - (_e4226[0] * _e4232[2])));
                                    let _e4247 = (((_e4205[0] * _e4211[1]) - (_e4205[1] * _e4211[0])) + ((_e4226[0] * _e4232[1]) - (_e4226[1] * _e4232[0])));
                                    let _e4250 = local_4[1u].member[0u];
                                    let _e4261 = local_4[1u].member[1u];
                                    let _e4272 = local_4[1u].member[0u];
                                    let _e4281 = ((((_e4261[0] * _e4175) + (_e4261[1] * _e4178)) + (_e4261[2] * _e4181)) + (((_e4272[0] * _e4245) + (_e4272[1] * _e4246)) + (_e4272[2] * _e4247)));
                                    let _e4284 = local_4[1u].member[0u];
                                    let _e4295 = local_4[1u].member[1u];
                                    let _e4304 = ((((_e4284[0] * _e4196) + (_e4284[1] * _e4199)) + (_e4284[2] * _e4202)) + (((_e4295[0] * _e4245) + (_e4295[1] * _e4246)) + (_e4295[2] * _e4247)));
                                    let _e4307 = local_4[1u].member[1u];
                                    let _e4318 = local_4[1u].member[0u];
                                    if (_e4318[0] < 0f) {
                                        phi_6767_ = -(_e4318[0]);
                                    } else {
                                        phi_6767_ = _e4318[0];
                                    }
                                    let _e4325 = phi_6767_;
                                    if (_e4318[1] < 0f) {
                                        phi_6774_ = -(_e4318[1]);
                                    } else {
                                        phi_6774_ = _e4318[1];
                                    }
                                    let _e4329 = phi_6774_;
                                    if (_e4325 > _e4329) {
                                        phi_6779_ = _e4325;
                                    } else {
                                        phi_6779_ = _e4329;
                                    }
                                    let _e4332 = phi_6779_;
                                    if (_e4318[2] < 0f) {
                                        phi_6786_ = -(_e4318[2]);
                                    } else {
                                        phi_6786_ = _e4318[2];
                                    }
                                    let _e4336 = phi_6786_;
                                    if (_e4332 > _e4336) {
                                        phi_6791_ = _e4332;
                                    } else {
                                        phi_6791_ = _e4336;
                                    }
                                    let _e4339 = phi_6791_;
                                    let _e4342 = local_4[1u].member[1u];
                                    if (_e4342[0] < 0f) {
                                        phi_6804_ = -(_e4342[0]);
                                    } else {
                                        phi_6804_ = _e4342[0];
                                    }
                                    let _e4349 = phi_6804_;
                                    if (_e4342[1] < 0f) {
                                        phi_6811_ = -(_e4342[1]);
                                    } else {
                                        phi_6811_ = _e4342[1];
                                    }
                                    let _e4353 = phi_6811_;
                                    if (_e4349 > _e4353) {
                                        phi_6816_ = _e4349;
                                    } else {
                                        phi_6816_ = _e4353;
                                    }
                                    let _e4356 = phi_6816_;
                                    if (_e4342[2] < 0f) {
                                        phi_6823_ = -(_e4342[2]);
                                    } else {
                                        phi_6823_ = _e4342[2];
                                    }
                                    let _e4360 = phi_6823_;
                                    if (_e4356 > _e4360) {
                                        phi_6828_ = _e4356;
                                    } else {
                                        phi_6828_ = _e4360;
                                    }
                                    let _e4363 = phi_6828_;
                                    if (_e4339 > _e4363) {
                                        phi_6833_ = _e4339;
                                    } else {
                                        phi_6833_ = _e4363;
                                    }
                                    let _e4366 = phi_6833_;
                                    let _e4368 = local_4[1u].member_3;
                                    let _e4369 = (_e4366 + _e4368);
                                    let _e4372 = local_4[1u].member_1[0u];
                                    if (_e4372[0] < 0f) {
                                        phi_6850_ = -(_e4372[0]);
                                    } else {
                                        phi_6850_ = _e4372[0];
                                    }
                                    let _e4379 = phi_6850_;
                                    if (_e4372[1] < 0f) {
                                        phi_6857_ = -(_e4372[1]);
                                    } else {
                                        phi_6857_ = _e4372[1];
                                    }
                                    let _e4383 = phi_6857_;
                                    if (_e4379 > _e4383) {
                                        phi_6862_ = _e4379;
                                    } else {
                                        phi_6862_ = _e4383;
                                    }
                                    let _e4386 = phi_6862_;
                                    if (_e4372[2] < 0f) {
                                        phi_6869_ = -(_e4372[2]);
                                    } else {
                                        phi_6869_ = _e4372[2];
                                    }
                                    let _e4390 = phi_6869_;
                                    if (_e4386 > _e4390) {
                                        phi_6874_ = _e4386;
                                    } else {
                                        phi_6874_ = _e4390;
                                    }
                                    let _e4393 = phi_6874_;
                                    let _e4396 = local_4[1u].member_1[1u];
                                    if (_e4396[0] < 0f) {
                                        phi_6888_ = -(_e4396[0]);
                                    } else {
                                        phi_6888_ = _e4396[0];
                                    }
                                    let _e4403 = phi_6888_;
                                    if (_e4396[1] < 0f) {
                                        phi_6895_ = -(_e4396[1]);
                                    } else {
                                        phi_6895_ = _e4396[1];
                                    }
                                    let _e4407 = phi_6895_;
                                    if (_e4403 > _e4407) {
                                        phi_6900_ = _e4403;
                                    } else {
                                        phi_6900_ = _e4407;
                                    }
                                    let _e4410 = phi_6900_;
                                    if (_e4396[2] < 0f) {
                                        phi_6907_ = -(_e4396[2]);
                                    } else {
                                        phi_6907_ = _e4396[2];
                                    }
                                    let _e4414 = phi_6907_;
                                    if (_e4410 > _e4414) {
                                        phi_6912_ = _e4410;
                                    } else {
                                        phi_6912_ = _e4414;
                                    }
                                    let _e4417 = phi_6912_;
                                    if (_e4393 > _e4417) {
                                        phi_6917_ = _e4393;
                                    } else {
                                        phi_6917_ = _e4417;
                                    }
                                    let _e4420 = phi_6917_;
                                    let _e4422 = local_4[1u].member_3;
                                    let _e4423 = (_e4420 + _e4422);
                                    let _e4426 = local_4[1u].member_2[0u];
                                    if (_e4426[0] < 0f) {
                                        phi_6934_ = -(_e4426[0]);
                                    } else {
                                        phi_6934_ = _e4426[0];
                                    }
                                    let _e4433 = phi_6934_;
                                    if (_e4426[1] < 0f) {
                                        phi_6941_ = -(_e4426[1]);
                                    } else {
                                        phi_6941_ = _e4426[1];
                                    }
                                    let _e4437 = phi_6941_;
                                    if (_e4433 > _e4437) {
                                        phi_6946_ = _e4433;
                                    } else {
                                        phi_6946_ = _e4437;
                                    }
                                    let _e4440 = phi_6946_;
                                    if (_e4426[2] < 0f) {
                                        phi_6953_ = -(_e4426[2]);
                                    } else {
                                        phi_6953_ = _e4426[2];
                                    }
                                    let _e4444 = phi_6953_;
                                    if (_e4440 > _e4444) {
                                        phi_6958_ = _e4440;
                                    } else {
                                        phi_6958_ = _e4444;
                                    }
                                    let _e4447 = phi_6958_;
                                    let _e4450 = local_4[1u].member_2[1u];
                                    if (_e4450[0] < 0f) {
                                        phi_6972_ = -(_e4450[0]);
                                    } else {
                                        phi_6972_ = _e4450[0];
                                    }
                                    let _e4457 = phi_6972_;
                                    if (_e4450[1] < 0f) {
                                        phi_6979_ = -(_e4450[1]);
                                    } else {
                                        phi_6979_ = _e4450[1];
                                    }
                                    let _e4461 = phi_6979_;
                                    if (_e4457 > _e4461) {
                                        phi_6984_ = _e4457;
                                    } else {
                                        phi_6984_ = _e4461;
                                    }
                                    let _e4464 = phi_6984_;
                                    if (_e4450[2] < 0f) {
                                        phi_6991_ = -(_e4450[2]);
                                    } else {
                                        phi_6991_ = _e4450[2];
                                    }
                                    let _e4468 = phi_6991_;
                                    if (_e4464 > _e4468) {
                                        phi_6996_ = _e4464;
                                    } else {
                                        phi_6996_ = _e4468;
                                    }
                                    let _e4471 = phi_6996_;
                                    if (_e4447 > _e4471) {
                                        phi_7001_ = _e4447;
                                    } else {
                                        phi_7001_ = _e4471;
                                    }
                                    let _e4474 = phi_7001_;
                                    let _e4476 = local_4[1u].member_3;
                                    let _e4477 = (_e4474 + _e4476);
                                    let _e4479 = ((_e4423 * 8f) * _e4477);
                                    let _e4486 = local_4[1u].member_3;
                                    if (_e4175 < 0f) {
                                        phi_7032_ = -(_e4175);
                                    } else {
                                        phi_7032_ = _e4175;
                                    }
                                    let _e4503 = phi_7032_;
                                    if (_e4178 < 0f) {
                                        phi_7038_ = -(_e4178);
                                    } else {
                                        phi_7038_ = _e4178;
                                    }
                                    let _e4507 = phi_7038_;
                                    if (_e4181 < 0f) {
                                        phi_7045_ = -(_e4181);
                                    } else {
                                        phi_7045_ = _e4181;
                                    }
                                    let _e4512 = phi_7045_;
                                    let _e4513 = ((_e4503 + _e4507) + _e4512);
                                    if (_e4196 < 0f) {
                                        phi_7052_ = -(_e4196);
                                    } else {
                                        phi_7052_ = _e4196;
                                    }
                                    let _e4517 = phi_7052_;
                                    if (_e4199 < 0f) {
                                        phi_7058_ = -(_e4199);
                                    } else {
                                        phi_7058_ = _e4199;
                                    }
                                    let _e4521 = phi_7058_;
                                    if (_e4202 < 0f) {
                                        phi_7065_ = -(_e4202);
                                    } else {
                                        phi_7065_ = _e4202;
                                    }
                                    let _e4526 = phi_7065_;
                                    let _e4527 = ((_e4517 + _e4521) + _e4526);
                                    if (_e4513 > _e4527) {
                                        phi_7071_ = _e4513;
                                    } else {
                                        phi_7071_ = _e4527;
                                    }
                                    let _e4530 = phi_7071_;
                                    if (_e4245 < 0f) {
                                        phi_7077_ = -(_e4245);
                                    } else {
                                        phi_7077_ = _e4245;
                                    }
                                    let _e4534 = phi_7077_;
                                    if (_e4246 < 0f) {
                                        phi_7083_ = -(_e4246);
                                    } else {
                                        phi_7083_ = _e4246;
                                    }
                                    let _e4538 = phi_7083_;
                                    if (_e4247 < 0f) {
                                        phi_7090_ = -(_e4247);
                                    } else {
                                        phi_7090_ = _e4247;
                                    }
                                    let _e4543 = phi_7090_;
                                    let _e4545 = (((_e4534 + _e4538) + _e4543) * 0.5f);
                                    if (_e4530 > _e4545) {
                                        phi_7097_ = _e4530;
                                    } else {
                                        phi_7097_ = _e4545;
                                    }
                                    let _e4548 = phi_7097_;
                                    let _e4553 = local_4[1u].member_3;
                                    let _e4566 = ((((_e4250[0] * _e4175) + (_e4250[1] * _e4178)) + (_e4250[2] * _e4181)) * 3f);
                                    let _e4567 = ((((_e4307[0] * _e4196) + (_e4307[1] * _e4199)) + (_e4307[2] * _e4202)) * 3f);
                                    if (_e4566 < _e4567) {
                                        phi_7121_ = _e4566;
                                    } else {
                                        phi_7121_ = _e4567;
                                    }
                                    let _e4570 = phi_7121_;
                                    if (_e4281 < _e4304) {
                                        phi_7126_ = _e4281;
                                    } else {
                                        phi_7126_ = _e4304;
                                    }
                                    let _e4573 = phi_7126_;
                                    if (_e4570 < _e4573) {
                                        phi_7131_ = _e4570;
                                    } else {
                                        phi_7131_ = _e4573;
                                    }
                                    let _e4576 = phi_7131_;
                                    if (_e4566 > _e4567) {
                                        phi_7136_ = _e4566;
                                    } else {
                                        phi_7136_ = _e4567;
                                    }
                                    let _e4579 = phi_7136_;
                                    if (_e4281 > _e4304) {
                                        phi_7141_ = _e4281;
                                    } else {
                                        phi_7141_ = _e4304;
                                    }
                                    let _e4582 = phi_7141_;
                                    if (_e4579 > _e4582) {
                                        phi_7146_ = _e4579;
                                    } else {
                                        phi_7146_ = _e4582;
                                    }
                                    let _e4585 = phi_7146_;
                                    let _e4590 = -(_e4585);
                                    if (_e4576 > _e4590) {
                                        phi_7156_ = _e4576;
                                    } else {
                                        phi_7156_ = _e4590;
                                    }
                                    let _e4593 = phi_7156_;
                                    if ((_e4593 - ((((((_e4369 * 8f) * _e4479) * (0.000000059604645f * (490f / 64f))) + ((_e4486 * 19f) * ((_e4369 * (_e4423 + _e4477)) + (_e4423 * _e4477)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4369) * ((1f + _e4423) * (1f + _e4477))))) + ((_e2108 * (((_e4548 + (_e4479 * (0.000000059604645f * 4f))) + ((_e4553 * 6f) * (_e4423 + _e4477))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4423) * (1f + _e4477))))) * (3f * 1.0001f)))) > 0f) {
                                        phi_8132_ = true;
                                    } else {
                                        let _e4598 = local_4[1u].member_1[0u];
                                        let _e4604 = local_4[1u].member_1[1u];
                                        let _e4608 = (_e4598[0] + _e4604[0]);
                                        let _e4609 = (_e4598[1] + _e4604[1]);
                                        let _e4610 = (_e4598[2] + _e4604[2]);
                                        let _e4613 = local_4[1u].member_2[0u];
                                        let _e4619 = local_4[1u].member_2[1u];
                                        let _e4623 = (_e4613[0] + _e4619[0]);
                                        let _e4624 = (_e4613[1] + _e4619[1]);
                                        let _e4625 = (_e4613[2] + _e4619[2]);
                                        let _e4628 = ((_e4609 * _e4625) - (_e4610 * _e4624));
                                        let _e4631 = ((_e4610 * _e4623) - (_e4608 * _e4625));
                                        let _e4634 = ((_e4608 * _e4624) - (_e4609 * _e4623));
                                        let _e4637 = local_4[1u].member[0u];
                                        let _e4643 = local_4[1u].member_1[0u];
                                        let _e4649 = local_4[1u].member_2[0u];
                                        let _e4653 = (_e4637[0] - _e4643[0]);
                                        let _e4654 = (_e4637[1] - _e4643[1]);
                                        let _e4655 = (_e4637[2] - _e4643[2]);
                                        let _e4664 = local_4[1u].member[1u];
                                        let _e4670 = local_4[1u].member_1[1u];
                                        let _e4676 = local_4[1u].member_2[1u];
                                        let _e4680 = (_e4664[0] - _e4670[0]);
                                        let _e4681 = (_e4664[1] - _e4670[1]);
                                        let _e4682 = (_e4664[2] - _e4670[2]);
                                        local = array<array<f32, 3>, 4>(_e4637, array<f32, 3>(_e4653, _e4654, _e4655), array<f32, 3>((_e4637[0] - _e4649[0]), (_e4637[1] - _e4649[1]), (_e4637[2] - _e4649[2])), array<f32, 3>((_e4653 - _e4649[0]), (_e4654 - _e4649[1]), (_e4655 - _e4649[2])));
                                        local_1 = array<array<f32, 3>, 4>(_e4664, array<f32, 3>(_e4680, _e4681, _e4682), array<f32, 3>((_e4664[0] - _e4676[0]), (_e4664[1] - _e4676[1]), (_e4664[2] - _e4676[2])), array<f32, 3>((_e4680 - _e4676[0]), (_e4681 - _e4676[1]), (_e4682 - _e4676[2])));
                                        let _e4699 = local_4[1u].member[0u];
                                        if (_e4699[0] < 0f) {
                                            phi_7407_ = -(_e4699[0]);
                                        } else {
                                            phi_7407_ = _e4699[0];
                                        }
                                        let _e4706 = phi_7407_;
                                        if (_e4699[1] < 0f) {
                                            phi_7414_ = -(_e4699[1]);
                                        } else {
                                            phi_7414_ = _e4699[1];
                                        }
                                        let _e4710 = phi_7414_;
                                        if (_e4706 > _e4710) {
                                            phi_7419_ = _e4706;
                                        } else {
                                            phi_7419_ = _e4710;
                                        }
                                        let _e4713 = phi_7419_;
                                        if (_e4699[2] < 0f) {
                                            phi_7426_ = -(_e4699[2]);
                                        } else {
                                            phi_7426_ = _e4699[2];
                                        }
                                        let _e4717 = phi_7426_;
                                        if (_e4713 > _e4717) {
                                            phi_7431_ = _e4713;
                                        } else {
                                            phi_7431_ = _e4717;
                                        }
                                        let _e4720 = phi_7431_;
                                        let _e4723 = local_4[1u].member[1u];
                                        if (_e4723[0] < 0f) {
                                            phi_7444_ = -(_e4723[0]);
                                        } else {
                                            phi_7444_ = _e4723[0];
                                        }
                                        let _e4730 = phi_7444_;
                                        if (_e4723[1] < 0f) {
                                            phi_7451_ = -(_e4723[1]);
                                        } else {
                                            phi_7451_ = _e4723[1];
                                        }
                                        let _e4734 = phi_7451_;
                                        if (_e4730 > _e4734) {
                                            phi_7456_ = _e4730;
                                        } else {
                                            phi_7456_ = _e4734;
                                        }
                                        let _e4737 = phi_7456_;
                                        if (_e4723[2] < 0f) {
                                            phi_7463_ = -(_e4723[2]);
                                        } else {
                                            phi_7463_ = _e4723[2];
                                        }
                                        let _e4741 = phi_7463_;
                                        if (_e4737 > _e4741) {
                                            phi_7468_ = _e4737;
                                        } else {
                                            phi_7468_ = _e4741;
                                        }
                                        let _e4744 = phi_7468_;
                                        if (_e4720 > _e4744) {
                                            phi_7473_ = _e4720;
                                        } else {
                                            phi_7473_ = _e4744;
                                        }
                                        let _e4747 = phi_7473_;
                                        let _e4749 = local_4[1u].member_3;
                                        let _e4753 = local_4[1u].member_1[0u];
                                        if (_e4753[0] < 0f) {
                                            phi_7490_ = -(_e4753[0]);
                                        } else {
                                            phi_7490_ = _e4753[0];
                                        }
                                        let _e4760 = phi_7490_;
                                        if (_e4753[1] < 0f) {
                                            phi_7497_ = -(_e4753[1]);
                                        } else {
                                            phi_7497_ = _e4753[1];
                                        }
                                        let _e4764 = phi_7497_;
                                        if (_e4760 > _e4764) {
                                            phi_7502_ = _e4760;
                                        } else {
                                            phi_7502_ = _e4764;
                                        }
                                        let _e4767 = phi_7502_;
                                        if (_e4753[2] < 0f) {
                                            phi_7509_ = -(_e4753[2]);
                                        } else {
                                            phi_7509_ = _e4753[2];
                                        }
                                        let _e4771 = phi_7509_;
                                        if (_e4767 > _e4771) {
                                            phi_7514_ = _e4767;
                                        } else {
                                            phi_7514_ = _e4771;
                                        }
                                        let _e4774 = phi_7514_;
                                        let _e4777 = local_4[1u].member_1[1u];
                                        if (_e4777[0] < 0f) {
                                            phi_7528_ = -(_e4777[0]);
                                        } else {
                                            phi_7528_ = _e4777[0];
                                        }
                                        let _e4784 = phi_7528_;
                                        if (_e4777[1] < 0f) {
                                            phi_7535_ = -(_e4777[1]);
                                        } else {
                                            phi_7535_ = _e4777[1];
                                        }
                                        let _e4788 = phi_7535_;
                                        if (_e4784 > _e4788) {
                                            phi_7540_ = _e4784;
                                        } else {
                                            phi_7540_ = _e4788;
                                        }
                                        let _e4791 = phi_7540_;
                                        if (_e4777[2] < 0f) {
                                            phi_7547_ = -(_e4777[2]);
                                        } else {
                                            phi_7547_ = _e4777[2];
                                        }
                                        let _e4795 = phi_7547_;
                                        if (_e4791 > _e4795) {
                                            phi_7552_ = _e4791;
                                        } else {
                                            phi_7552_ = _e4795;
                                        }
                                        let _e4798 = phi_7552_;
                                        if (_e4774 > _e4798) {
                                            phi_7557_ = _e4774;
                                        } else {
                                            phi_7557_ = _e4798;
                                        }
                                        let _e4801 = phi_7557_;
                                        let _e4803 = local_4[1u].member_3;
                                        let _e4807 = local_4[1u].member_2[0u];
                                        if (_e4807[0] < 0f) {
                                            phi_7574_ = -(_e4807[0]);
                                        } else {
                                            phi_7574_ = _e4807[0];
                                        }
                                        let _e4814 = phi_7574_;
                                        if (_e4807[1] < 0f) {
                                            phi_7581_ = -(_e4807[1]);
                                        } else {
                                            phi_7581_ = _e4807[1];
                                        }
                                        let _e4818 = phi_7581_;
                                        if (_e4814 > _e4818) {
                                            phi_7586_ = _e4814;
                                        } else {
                                            phi_7586_ = _e4818;
                                        }
                                        let _e4821 = phi_7586_;
                                        if (_e4807[2] < 0f) {
                                            phi_7593_ = -(_e4807[2]);
                                        } else {
                                            phi_7593_ = _e4807[2];
                                        }
                                        let _e4825 = phi_7593_;
                                        if (_e4821 > _e4825) {
                                            phi_7598_ = _e4821;
                                        } else {
                                            phi_7598_ = _e4825;
                                        }
                                        let _e4828 = phi_7598_;
                                        let _e4831 = local_4[1u].member_2[1u];
                                        if (_e4831[0] < 0f) {
                                            phi_7612_ = -(_e4831[0]);
                                        } else {
                                            phi_7612_ = _e4831[0];
                                        }
                                        let _e4838 = phi_7612_;
                                        if (_e4831[1] < 0f) {
                                            phi_7619_ = -(_e4831[1]);
                                        } else {
                                            phi_7619_ = _e4831[1];
                                        }
                                        let _e4842 = phi_7619_;
                                        if (_e4838 > _e4842) {
                                            phi_7624_ = _e4838;
                                        } else {
                                            phi_7624_ = _e4842;
                                        }
                                        let _e4845 = phi_7624_;
                                        if (_e4831[2] < 0f) {
                                            phi_7631_ = -(_e4831[2]);
                                        } else {
                                            phi_7631_ = _e4831[2];
                                        }
                                        let _e4849 = phi_7631_;
                                        if (_e4845 > _e4849) {
                                            phi_7636_ = _e4845;
                                        } else {
                                            phi_7636_ = _e4849;
                                        }
                                        let _e4852 = phi_7636_;
                                        if (_e4828 > _e4852) {
                                            phi_7641_ = _e4828;
                                        } else {
                                            phi_7641_ = _e4852;
                                        }
                                        let _e4855 = phi_7641_;
                                        let _e4857 = local_4[1u].member_3;
                                        let _e4860 = (((_e4747 + _e4749) + (_e4801 + _e4803)) + (_e4855 + _e4857));
                                        let _e4863 = local_4[1u].member_3;
                                        let _e4867 = (((_e2108 * 1.0001f) + (_e4863 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4870 = ((_e4631 * _e4610) - (_e4634 * _e4609));
                                        let _e4873 = ((_e4634 * _e4608) - (_e4628 * _e4610));
                                        let _e4876 = ((_e4628 * _e4609) - (_e4631 * _e4608));
                                        let _e4878 = local[0u];
                                        let _e4886 = (((_e4870 * _e4878[0]) + (_e4873 * _e4878[1])) + (_e4876 * _e4878[2]));
                                        phi_7679_ = type_35(0u, 4u);
                                        phi_7682_ = _e4886;
                                        phi_7684_ = _e4886;
                                        loop {
                                            let _e4888 = phi_7679_;
                                            let _e4890 = phi_7682_;
                                            let _e4892 = phi_7684_;
                                            local_60 = _e4890;
                                            local_61 = _e4892;
                                            local_71 = _e4892;
                                            if (_e4888.member < _e4888.member_1) {
                                                phi_7680_ = type_35((_e4888.member + 1u), _e4888.member_1);
                                                phi_7707_ = type_35(1u, _e4888.member);
                                            } else {
                                                phi_7680_ = _e4888;
                                                phi_7707_ = type_35(0u, type_35().member_1);
                                            }
                                            let _e4906 = phi_7680_;
                                            let _e4908 = phi_7707_;
                                            let _e4912 = (bitcast<i32>(_e4908.member) != 0i);
                                            if _e4912 {
                                                if (_e4908.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4915 = local[_e4908.member_1];
                                                let _e4923 = (((_e4870 * _e4915[0]) + (_e4873 * _e4915[1])) + (_e4876 * _e4915[2]));
                                                if (_e4908.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4926 = local_1[_e4908.member_1];
                                                let _e4934 = (((_e4870 * _e4926[0]) + (_e4873 * _e4926[1])) + (_e4876 * _e4926[2]));
                                                if (_e4892 < _e4923) {
                                                    phi_7757_ = _e4892;
                                                } else {
                                                    phi_7757_ = _e4923;
                                                }
                                                let _e4937 = phi_7757_;
                                                if (_e4937 < _e4934) {
                                                    phi_7762_ = _e4937;
                                                } else {
                                                    phi_7762_ = _e4934;
                                                }
                                                let _e4940 = phi_7762_;
                                                if (_e4890 > _e4923) {
                                                    phi_7767_ = _e4890;
                                                } else {
                                                    phi_7767_ = _e4923;
                                                }
                                                let _e4943 = phi_7767_;
                                                if (_e4943 > _e4934) {
                                                    phi_7772_ = _e4943;
                                                } else {
                                                    phi_7772_ = _e4934;
                                                }
                                                let _e4946 = phi_7772_;
                                                phi_7683_ = _e4946;
                                                phi_7685_ = _e4940;
                                            } else {
                                                phi_7683_ = f32();
                                                phi_7685_ = f32();
                                            }
                                            let _e4948 = phi_7683_;
                                            let _e4950 = phi_7685_;
                                            continue;
                                            continuing {
                                                phi_7679_ = _e4906;
                                                phi_7682_ = _e4948;
                                                phi_7684_ = _e4950;
                                                break if !(_e4912);
                                            }
                                        }
                                        if (_e4870 < 0f) {
                                            phi_7778_ = -(_e4870);
                                        } else {
                                            phi_7778_ = _e4870;
                                        }
                                        let _e4955 = phi_7778_;
                                        if (_e4873 < 0f) {
                                            phi_7784_ = -(_e4873);
                                        } else {
                                            phi_7784_ = _e4873;
                                        }
                                        let _e4959 = phi_7784_;
                                        if (_e4876 < 0f) {
                                            phi_7791_ = -(_e4876);
                                        } else {
                                            phi_7791_ = _e4876;
                                        }
                                        let _e4964 = phi_7791_;
                                        let _e4965 = ((_e4955 + _e4959) + _e4964);
                                        let _e4970 = local_60;
                                        let _e4971 = -(_e4970);
                                        let _e4973 = local_61;
                                        if (_e4973 > _e4971) {
                                            let _e5775 = local_71;
                                            phi_7801_ = _e5775;
                                        } else {
                                            phi_7801_ = _e4971;
                                        }
                                        let _e4976 = phi_7801_;
                                        let _e4981 = (((_e4976 - ((_e4965 * _e4860) * (0.000000059604645f * 17f))) - (_e4965 * _e4867)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4984 = ((_e4631 * _e4625) - (_e4634 * _e4624));
                                        let _e4987 = ((_e4634 * _e4623) - (_e4628 * _e4625));
                                        let _e4990 = ((_e4628 * _e4624) - (_e4631 * _e4623));
                                        let _e4992 = local[0u];
                                        let _e5000 = (((_e4984 * _e4992[0]) + (_e4987 * _e4992[1])) + (_e4990 * _e4992[2]));
                                        phi_7832_ = type_35(0u, 4u);
                                        phi_7835_ = _e5000;
                                        phi_7837_ = _e5000;
                                        loop {
                                            let _e5002 = phi_7832_;
                                            let _e5004 = phi_7835_;
                                            let _e5006 = phi_7837_;
                                            local_62 = _e5004;
                                            local_63 = _e5006;
                                            local_72 = _e5006;
                                            if (_e5002.member < _e5002.member_1) {
                                                phi_7833_ = type_35((_e5002.member + 1u), _e5002.member_1);
                                                phi_7860_ = type_35(1u, _e5002.member);
                                            } else {
                                                phi_7833_ = _e5002;
                                                phi_7860_ = type_35(0u, type_35().member_1);
                                            }
                                            let _e5020 = phi_7833_;
                                            let _e5022 = phi_7860_;
                                            let _e5026 = (bitcast<i32>(_e5022.member) != 0i);
                                            if _e5026 {
                                                if (_e5022.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e5029 = local[_e5022.member_1];
                                                let _e5037 = (((_e4984 * _e5029[0]) + (_e4987 * _e5029[1])) + (_e4990 * _e5029[2]));
                                                if (_e5022.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e5040 = local_1[_e5022.member_1];
                                                let _e5048 = (((_e4984 * _e5040[0]) + (_e4987 * _e5040[1])) + (_e4990 * _e5040[2]));
                                                if (_e5006 < _e5037) {
                                                    phi_7910_ = _e5006;
                                                } else {
                                                    phi_7910_ = _e5037;
                                                }
                                                let _e5051 = phi_7910_;
                                                if (_e5051 < _e5048) {
                                                    phi_7915_ = _e5051;
                                                } else {
                                                    phi_7915_ = _e5048;
                                                }
                                                let _e5054 = phi_7915_;
                                                if (_e5004 > _e5037) {
                                                    phi_7920_ = _e5004;
                                                } else {
                                                    phi_7920_ = _e5037;
                                                }
                                                let _e5057 = phi_7920_;
                                                if (_e5057 > _e5048) {
                                                    phi_7925_ = _e5057;
                                                } else {
                                                    phi_7925_ = _e5048;
                                                }
                                                let _e5060 = phi_7925_;
                                                phi_7836_ = _e5060;
                                                phi_7838_ = _e5054;
                                            } else {
                                                phi_7836_ = f32();
                                                phi_7838_ = f32();
                                            }
                                            let _e5062 = phi_7836_;
                                            let _e5064 = phi_7838_;
                                            continue;
                                            continuing {
                                                phi_7832_ = _e5020;
                                                phi_7835_ = _e5062;
                                                phi_7837_ = _e5064;
                                                break if !(_e5026);
                                            }
                                        }
                                        if (_e4984 < 0f) {
                                            phi_7931_ = -(_e4984);
                                        } else {
                                            phi_7931_ = _e4984;
                                        }
                                        let _e5069 = phi_7931_;
                                        if (_e4987 < 0f) {
                                            phi_7937_ = -(_e4987);
                                        } else {
                                            phi_7937_ = _e4987;
                                        }
                                        let _e5073 = phi_7937_;
                                        if (_e4990 < 0f) {
                                            phi_7944_ = -(_e4990);
                                        } else {
                                            phi_7944_ = _e4990;
                                        }
                                        let _e5078 = phi_7944_;
                                        let _e5079 = ((_e5069 + _e5073) + _e5078);
                                        let _e5084 = local_62;
                                        let _e5085 = -(_e5084);
                                        let _e5087 = local_63;
                                        if (_e5087 > _e5085) {
                                            let _e5794 = local_72;
                                            phi_7954_ = _e5794;
                                        } else {
                                            phi_7954_ = _e5085;
                                        }
                                        let _e5090 = phi_7954_;
                                        let _e5095 = (((_e5090 - ((_e5079 * _e4860) * (0.000000059604645f * 17f))) - (_e5079 * _e4867)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4981 > _e5095) {
                                            phi_7964_ = _e4981;
                                        } else {
                                            phi_7964_ = _e5095;
                                        }
                                        let _e5098 = phi_7964_;
                                        phi_8132_ = (_e5098 > 0f);
                                    }
                                    let _e5101 = phi_8132_;
                                    phi_8133_ = _e5101;
                                } else {
                                    phi_8133_ = false;
                                }
                                let _e5103 = phi_8133_;
                                phi_8135_ = !(_e5103);
                            }
                            let _e5106 = phi_8135_;
                            if _e5106 {
                                let _e5108 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1343] = ((2147483648u | (_e5108 << bitcast<u32>(12i))) | _e1346);
                            }
                        }
                        phi_8145_ = true;
                    }
                    let _e5115 = phi_8145_;
                    phi_8146_ = _e5115;
                } else {
                    phi_8146_ = false;
                }
                let _e5117 = phi_8146_;
                continue;
                continuing {
                    phi_1881_ = _e1335;
                    break if !(_e5117);
                }
            }
            workgroupBarrier();
            if (_e110 == 0u) {
                let _e5121 = atomicLoad((&counters[5u]));
                if (_e5121 > 0u) {
                    let _e5124 = atomicAdd((&output.member[0u]), _e5121);
                    atomicStore((&counters[6u]), _e5124);
                }
            }
            workgroupBarrier();
            let _e5127 = atomicLoad((&counters[6u]));
            if (_e110 == 0u) {
                let _e5130 = atomicLoad((&counters[7u]));
                if (_e5130 > 0u) {
                    let _e5133 = atomicAdd((&output.member[1u]), _e5130);
                }
            }
            phi_8178_ = type_35(0u, 16u);
            loop {
                let _e5135 = phi_8178_;
                if (_e5135.member < _e5135.member_1) {
                    phi_8179_ = type_35((_e5135.member + 1u), _e5135.member_1);
                    phi_8202_ = type_35(1u, _e5135.member);
                } else {
                    phi_8179_ = _e5135;
                    phi_8202_ = type_35(0u, type_35().member_1);
                }
                let _e5149 = phi_8179_;
                let _e5151 = phi_8202_;
                if (bitcast<i32>(_e5151.member) != 0i) {
                    let _e5157 = (_e110 + (_e5151.member_1 * 128u));
                    if (_e5157 >= _e1319) {
                        phi_8300_ = false;
                    } else {
                        let _e5160 = hits[_e5157];
                        if ((_e5160 & 2147483648u) == 0u) {
                            phi_8225_ = 4294967295u;
                        } else {
                            phi_8225_ = ((_e5160 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e5167 = phi_8225_;
                        if (_e5167 != 4294967295u) {
                            let _e5171 = ((_e5160 >> bitcast<u32>(10i)) & 3u);
                            let _e5178 = firsts[(2u * _e5171)];
                            let _e5181 = leaves.member[(_e5178 + ((_e5160 >> bitcast<u32>(5i)) & 31u))];
                            let _e5185 = firsts[((2u * _e5171) + 1u)];
                            let _e5188 = leaves.member[(_e5185 + (_e5160 & 31u))];
                            let _e5192 = params.member.member_16;
                            let _e5193 = (_e5127 + _e5167);
                            if (_e5181.member_1 < _e5188.member_1) {
                                phi_8279_ = type_35(_e5181.member_1, _e5188.member_1);
                            } else {
                                phi_8279_ = type_35(_e5188.member_1, _e5181.member_1);
                            }
                            let _e5198 = phi_8279_;
                            if (_e5193 < _e5192) {
                                atomicStore((&output.member[(4u + (2u * _e5193))]), _e5198.member);
                                atomicStore((&output.member[((2u * _e5193) + 5u)]), _e5198.member_1);
                            }
                        }
                        phi_8300_ = true;
                    }
                    let _e5209 = phi_8300_;
                    phi_8301_ = _e5209;
                } else {
                    phi_8301_ = false;
                }
                let _e5211 = phi_8301_;
                continue;
                continuing {
                    phi_8178_ = _e5149;
                    break if !(_e5211);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_319_ = _e193;
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
