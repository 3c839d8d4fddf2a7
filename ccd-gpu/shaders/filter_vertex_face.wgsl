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
    var phi_1870_: u32;
    var phi_1871_: bool;
    var phi_816_: u32;
    var phi_1872_: bool;
    var phi_1879_: u32;
    var phi_1882_: type_36;
    var phi_1883_: type_36;
    var phi_1906_: type_36;
    var phi_2060_: bool;
    var phi_2061_: bool;
    var phi_2062_: bool;
    var phi_2063_: bool;
    var phi_2064_: bool;
    var phi_2068_: bool;
    var phi_2024_: bool;
    var phi_2025_: bool;
    var phi_2026_: bool;
    var phi_2030_: bool;
    var phi_2069_: bool;
    var phi_2073_: bool;
    var phi_2074_: bool;
    var phi_2120_: bool;
    var phi_2130_: bool;
    var phi_2131_: bool;
    var phi_2135_: bool;
    var phi_2136_: bool;
    var phi_2185_: type_36;
    var phi_2188_: bool;
    var phi_2186_: type_36;
    var phi_2211_: type_36;
    var phi_2268_: type_36;
    var phi_2271_: array<u32, 2>;
    var phi_2269_: type_36;
    var phi_2294_: type_36;
    var phi_2369_: bool;
    var phi_2370_: bool;
    var phi_2374_: array<u32, 2>;
    var phi_2272_: array<u32, 2>;
    var phi_2425_: type_36;
    var phi_2428_: array<u32, 2>;
    var phi_2426_: type_36;
    var phi_2451_: type_36;
    var phi_2527_: bool;
    var phi_2528_: bool;
    var phi_2532_: array<u32, 2>;
    var phi_2429_: array<u32, 2>;
    var local_40: array<u32, 2>;
    var local_41: array<u32, 2>;
    var local_42: array<u32, 2>;
    var local_43: array<u32, 2>;
    var local_44: array<u32, 2>;
    var local_45: array<u32, 2>;
    var phi_2548_: bool;
    var phi_2549_: bool;
    var phi_2600_: type_36;
    var phi_2603_: array<u32, 2>;
    var phi_2601_: type_36;
    var phi_2626_: type_36;
    var phi_2701_: bool;
    var phi_2702_: bool;
    var phi_2706_: array<u32, 2>;
    var phi_2604_: array<u32, 2>;
    var phi_2757_: type_36;
    var phi_2760_: array<u32, 2>;
    var phi_2758_: type_36;
    var phi_2783_: type_36;
    var phi_2859_: bool;
    var phi_2860_: bool;
    var phi_2864_: array<u32, 2>;
    var phi_2761_: array<u32, 2>;
    var local_46: array<u32, 2>;
    var local_47: array<u32, 2>;
    var local_48: array<u32, 2>;
    var local_49: array<u32, 2>;
    var local_50: array<u32, 2>;
    var local_51: array<u32, 2>;
    var phi_2880_: bool;
    var phi_2881_: bool;
    var phi_2189_: bool;
    var phi_2885_: bool;
    var phi_2886_: bool;
    var phi_2887_: bool;
    var phi_2891_: bool;
    var phi_2892_: bool;
    var phi_2893_: bool;
    var phi_2894_: bool;
    var phi_2895_: bool;
    var phi_2899_: bool;
    var phi_3297_: f32;
    var phi_3304_: f32;
    var phi_3309_: f32;
    var phi_3316_: f32;
    var phi_3321_: f32;
    var phi_3334_: f32;
    var phi_3341_: f32;
    var phi_3346_: f32;
    var phi_3353_: f32;
    var phi_3358_: f32;
    var phi_3363_: f32;
    var phi_3380_: f32;
    var phi_3387_: f32;
    var phi_3392_: f32;
    var phi_3399_: f32;
    var phi_3404_: f32;
    var phi_3418_: f32;
    var phi_3425_: f32;
    var phi_3430_: f32;
    var phi_3437_: f32;
    var phi_3442_: f32;
    var phi_3447_: f32;
    var phi_3464_: f32;
    var phi_3471_: f32;
    var phi_3476_: f32;
    var phi_3483_: f32;
    var phi_3488_: f32;
    var phi_3502_: f32;
    var phi_3509_: f32;
    var phi_3514_: f32;
    var phi_3521_: f32;
    var phi_3526_: f32;
    var phi_3531_: f32;
    var phi_3562_: f32;
    var phi_3568_: f32;
    var phi_3575_: f32;
    var phi_3582_: f32;
    var phi_3588_: f32;
    var phi_3595_: f32;
    var phi_3601_: f32;
    var phi_3607_: f32;
    var phi_3613_: f32;
    var phi_3620_: f32;
    var phi_3627_: f32;
    var phi_3651_: f32;
    var phi_3656_: f32;
    var phi_3661_: f32;
    var phi_3666_: f32;
    var phi_3671_: f32;
    var phi_3676_: f32;
    var phi_3686_: f32;
    var phi_3937_: f32;
    var phi_3944_: f32;
    var phi_3949_: f32;
    var phi_3956_: f32;
    var phi_3961_: f32;
    var phi_3974_: f32;
    var phi_3981_: f32;
    var phi_3986_: f32;
    var phi_3993_: f32;
    var phi_3998_: f32;
    var phi_4003_: f32;
    var phi_4020_: f32;
    var phi_4027_: f32;
    var phi_4032_: f32;
    var phi_4039_: f32;
    var phi_4044_: f32;
    var phi_4058_: f32;
    var phi_4065_: f32;
    var phi_4070_: f32;
    var phi_4077_: f32;
    var phi_4082_: f32;
    var phi_4087_: f32;
    var phi_4104_: f32;
    var phi_4111_: f32;
    var phi_4116_: f32;
    var phi_4123_: f32;
    var phi_4128_: f32;
    var phi_4142_: f32;
    var phi_4149_: f32;
    var phi_4154_: f32;
    var phi_4161_: f32;
    var phi_4166_: f32;
    var phi_4171_: f32;
    var phi_4209_: type_36;
    var phi_4212_: f32;
    var phi_4214_: f32;
    var phi_4210_: type_36;
    var phi_4237_: type_36;
    var phi_4287_: f32;
    var phi_4292_: f32;
    var phi_4297_: f32;
    var phi_4302_: f32;
    var phi_4213_: f32;
    var phi_4215_: f32;
    var phi_4308_: f32;
    var phi_4314_: f32;
    var phi_4321_: f32;
    var local_52: f32;
    var local_53: f32;
    var phi_4331_: f32;
    var phi_4362_: type_36;
    var phi_4365_: f32;
    var phi_4367_: f32;
    var phi_4363_: type_36;
    var phi_4390_: type_36;
    var phi_4440_: f32;
    var phi_4445_: f32;
    var phi_4450_: f32;
    var phi_4455_: f32;
    var phi_4366_: f32;
    var phi_4368_: f32;
    var phi_4461_: f32;
    var phi_4467_: f32;
    var phi_4474_: f32;
    var local_54: f32;
    var local_55: f32;
    var phi_4484_: f32;
    var phi_4494_: f32;
    var phi_4527_: type_36;
    var phi_4530_: f32;
    var phi_4532_: f32;
    var phi_4528_: type_36;
    var phi_4555_: type_36;
    var phi_4605_: f32;
    var phi_4610_: f32;
    var phi_4615_: f32;
    var phi_4620_: f32;
    var phi_4531_: f32;
    var phi_4533_: f32;
    var phi_4626_: f32;
    var phi_4632_: f32;
    var phi_4639_: f32;
    var local_56: f32;
    var local_57: f32;
    var phi_4649_: f32;
    var phi_4659_: f32;
    var phi_4662_: bool;
    var phi_5119_: f32;
    var phi_5126_: f32;
    var phi_5131_: f32;
    var phi_5138_: f32;
    var phi_5143_: f32;
    var phi_5156_: f32;
    var phi_5163_: f32;
    var phi_5168_: f32;
    var phi_5175_: f32;
    var phi_5180_: f32;
    var phi_5185_: f32;
    var phi_5202_: f32;
    var phi_5209_: f32;
    var phi_5214_: f32;
    var phi_5221_: f32;
    var phi_5226_: f32;
    var phi_5240_: f32;
    var phi_5247_: f32;
    var phi_5252_: f32;
    var phi_5259_: f32;
    var phi_5264_: f32;
    var phi_5269_: f32;
    var phi_5286_: f32;
    var phi_5293_: f32;
    var phi_5298_: f32;
    var phi_5305_: f32;
    var phi_5310_: f32;
    var phi_5324_: f32;
    var phi_5331_: f32;
    var phi_5336_: f32;
    var phi_5343_: f32;
    var phi_5348_: f32;
    var phi_5353_: f32;
    var phi_5384_: f32;
    var phi_5390_: f32;
    var phi_5397_: f32;
    var phi_5404_: f32;
    var phi_5410_: f32;
    var phi_5417_: f32;
    var phi_5423_: f32;
    var phi_5429_: f32;
    var phi_5435_: f32;
    var phi_5442_: f32;
    var phi_5449_: f32;
    var phi_5473_: f32;
    var phi_5478_: f32;
    var phi_5483_: f32;
    var phi_5488_: f32;
    var phi_5493_: f32;
    var phi_5498_: f32;
    var phi_5508_: f32;
    var phi_5759_: f32;
    var phi_5766_: f32;
    var phi_5771_: f32;
    var phi_5778_: f32;
    var phi_5783_: f32;
    var phi_5796_: f32;
    var phi_5803_: f32;
    var phi_5808_: f32;
    var phi_5815_: f32;
    var phi_5820_: f32;
    var phi_5825_: f32;
    var phi_5842_: f32;
    var phi_5849_: f32;
    var phi_5854_: f32;
    var phi_5861_: f32;
    var phi_5866_: f32;
    var phi_5880_: f32;
    var phi_5887_: f32;
    var phi_5892_: f32;
    var phi_5899_: f32;
    var phi_5904_: f32;
    var phi_5909_: f32;
    var phi_5926_: f32;
    var phi_5933_: f32;
    var phi_5938_: f32;
    var phi_5945_: f32;
    var phi_5950_: f32;
    var phi_5964_: f32;
    var phi_5971_: f32;
    var phi_5976_: f32;
    var phi_5983_: f32;
    var phi_5988_: f32;
    var phi_5993_: f32;
    var phi_6031_: type_36;
    var phi_6034_: f32;
    var phi_6036_: f32;
    var phi_6032_: type_36;
    var phi_6059_: type_36;
    var phi_6109_: f32;
    var phi_6114_: f32;
    var phi_6119_: f32;
    var phi_6124_: f32;
    var phi_6035_: f32;
    var phi_6037_: f32;
    var phi_6130_: f32;
    var phi_6136_: f32;
    var phi_6143_: f32;
    var local_58: f32;
    var local_59: f32;
    var phi_6153_: f32;
    var phi_6184_: type_36;
    var phi_6187_: f32;
    var phi_6189_: f32;
    var phi_6185_: type_36;
    var phi_6212_: type_36;
    var phi_6262_: f32;
    var phi_6267_: f32;
    var phi_6272_: f32;
    var phi_6277_: f32;
    var phi_6188_: f32;
    var phi_6190_: f32;
    var phi_6283_: f32;
    var phi_6289_: f32;
    var phi_6296_: f32;
    var local_60: f32;
    var local_61: f32;
    var phi_6306_: f32;
    var phi_6316_: f32;
    var phi_6349_: type_36;
    var phi_6352_: f32;
    var phi_6354_: f32;
    var phi_6350_: type_36;
    var phi_6377_: type_36;
    var phi_6427_: f32;
    var phi_6432_: f32;
    var phi_6437_: f32;
    var phi_6442_: f32;
    var phi_6353_: f32;
    var phi_6355_: f32;
    var phi_6448_: f32;
    var phi_6454_: f32;
    var phi_6461_: f32;
    var local_62: f32;
    var local_63: f32;
    var phi_6471_: f32;
    var phi_6481_: f32;
    var phi_6484_: bool;
    var phi_6730_: f32;
    var phi_6737_: f32;
    var phi_6742_: f32;
    var phi_6749_: f32;
    var phi_6754_: f32;
    var phi_6767_: f32;
    var phi_6774_: f32;
    var phi_6779_: f32;
    var phi_6786_: f32;
    var phi_6791_: f32;
    var phi_6796_: f32;
    var phi_6813_: f32;
    var phi_6820_: f32;
    var phi_6825_: f32;
    var phi_6832_: f32;
    var phi_6837_: f32;
    var phi_6851_: f32;
    var phi_6858_: f32;
    var phi_6863_: f32;
    var phi_6870_: f32;
    var phi_6875_: f32;
    var phi_6880_: f32;
    var phi_6897_: f32;
    var phi_6904_: f32;
    var phi_6909_: f32;
    var phi_6916_: f32;
    var phi_6921_: f32;
    var phi_6935_: f32;
    var phi_6942_: f32;
    var phi_6947_: f32;
    var phi_6954_: f32;
    var phi_6959_: f32;
    var phi_6964_: f32;
    var phi_6995_: f32;
    var phi_7001_: f32;
    var phi_7008_: f32;
    var phi_7015_: f32;
    var phi_7021_: f32;
    var phi_7028_: f32;
    var phi_7034_: f32;
    var phi_7040_: f32;
    var phi_7046_: f32;
    var phi_7053_: f32;
    var phi_7060_: f32;
    var phi_7084_: f32;
    var phi_7089_: f32;
    var phi_7094_: f32;
    var phi_7099_: f32;
    var phi_7104_: f32;
    var phi_7109_: f32;
    var phi_7119_: f32;
    var phi_7370_: f32;
    var phi_7377_: f32;
    var phi_7382_: f32;
    var phi_7389_: f32;
    var phi_7394_: f32;
    var phi_7407_: f32;
    var phi_7414_: f32;
    var phi_7419_: f32;
    var phi_7426_: f32;
    var phi_7431_: f32;
    var phi_7436_: f32;
    var phi_7453_: f32;
    var phi_7460_: f32;
    var phi_7465_: f32;
    var phi_7472_: f32;
    var phi_7477_: f32;
    var phi_7491_: f32;
    var phi_7498_: f32;
    var phi_7503_: f32;
    var phi_7510_: f32;
    var phi_7515_: f32;
    var phi_7520_: f32;
    var phi_7537_: f32;
    var phi_7544_: f32;
    var phi_7549_: f32;
    var phi_7556_: f32;
    var phi_7561_: f32;
    var phi_7575_: f32;
    var phi_7582_: f32;
    var phi_7587_: f32;
    var phi_7594_: f32;
    var phi_7599_: f32;
    var phi_7604_: f32;
    var phi_7642_: type_36;
    var phi_7645_: f32;
    var phi_7647_: f32;
    var phi_7643_: type_36;
    var phi_7670_: type_36;
    var phi_7720_: f32;
    var phi_7725_: f32;
    var phi_7730_: f32;
    var phi_7735_: f32;
    var phi_7646_: f32;
    var phi_7648_: f32;
    var phi_7741_: f32;
    var phi_7747_: f32;
    var phi_7754_: f32;
    var local_64: f32;
    var local_65: f32;
    var phi_7764_: f32;
    var phi_7795_: type_36;
    var phi_7798_: f32;
    var phi_7800_: f32;
    var phi_7796_: type_36;
    var phi_7823_: type_36;
    var phi_7873_: f32;
    var phi_7878_: f32;
    var phi_7883_: f32;
    var phi_7888_: f32;
    var phi_7799_: f32;
    var phi_7801_: f32;
    var phi_7894_: f32;
    var phi_7900_: f32;
    var phi_7907_: f32;
    var local_66: f32;
    var local_67: f32;
    var phi_7917_: f32;
    var phi_7927_: f32;
    var phi_7960_: type_36;
    var phi_7963_: f32;
    var phi_7965_: f32;
    var phi_7961_: type_36;
    var phi_7988_: type_36;
    var phi_8038_: f32;
    var phi_8043_: f32;
    var phi_8048_: f32;
    var phi_8053_: f32;
    var phi_7964_: f32;
    var phi_7966_: f32;
    var phi_8059_: f32;
    var phi_8065_: f32;
    var phi_8072_: f32;
    var local_68: f32;
    var local_69: f32;
    var phi_8082_: f32;
    var phi_8092_: f32;
    var phi_8095_: bool;
    var phi_8096_: bool;
    var phi_8098_: bool;
    var phi_8108_: bool;
    var phi_8109_: bool;
    var phi_8141_: type_36;
    var phi_8142_: type_36;
    var phi_8165_: type_36;
    var phi_8188_: u32;
    var phi_8263_: bool;
    var phi_8264_: bool;
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
            let _e5547 = local_70;
            phi_815_ = _e5547;
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
                        phi_1870_ = u32();
                        phi_1871_ = false;
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
                                        let _e5623 = local_71;
                                        phi_1809_ = _e5623;
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
                            if (_e1277 < _e1271) {
                                atomicStore((&output.member[(4u + (2u * _e1277))]), _e1273);
                                atomicStore((&output.member[((2u * _e1277) + 5u)]), _e1275);
                            }
                            let _e1286 = atomicAdd((&output.member[1u]), 1u);
                        }
                        phi_1870_ = (_e507 & (_e507 - 1u));
                        phi_1871_ = true;
                    }
                    let _e1288 = phi_1870_;
                    let _e1290 = phi_1871_;
                    phi_816_ = _e1288;
                    phi_1872_ = _e1290;
                } else {
                    phi_816_ = u32();
                    phi_1872_ = false;
                }
                let _e1292 = phi_816_;
                let _e1294 = phi_1872_;
                continue;
                continuing {
                    phi_812_ = _e521;
                    phi_815_ = _e1292;
                    break if !(_e1294);
                }
            }
            workgroupBarrier();
            let _e1297 = atomicLoad((&counters[4u]));
            if (2048u < _e1297) {
                phi_1879_ = 2048u;
            } else {
                phi_1879_ = _e1297;
            }
            let _e1300 = phi_1879_;
            phi_1882_ = type_36(0u, 16u);
            loop {
                let _e1302 = phi_1882_;
                if (_e1302.member < _e1302.member_1) {
                    phi_1883_ = type_36((_e1302.member + 1u), _e1302.member_1);
                    phi_1906_ = type_36(1u, _e1302.member);
                } else {
                    phi_1883_ = _e1302;
                    phi_1906_ = type_36(0u, type_36().member_1);
                }
                let _e1316 = phi_1883_;
                let _e1318 = phi_1906_;
                if (bitcast<i32>(_e1318.member) != 0i) {
                    let _e1324 = (_e110 + (_e1318.member_1 * 128u));
                    if (_e1324 >= _e1300) {
                        phi_8108_ = false;
                    } else {
                        let _e1327 = hits[_e1324];
                        let _e1330 = ((_e1327 >> bitcast<u32>(10i)) & 3u);
                        let _e1337 = firsts[(2u * _e1330)];
                        let _e1338 = (_e1337 + ((_e1327 >> bitcast<u32>(5i)) & 31u));
                        let _e1342 = firsts[((2u * _e1330) + 1u)];
                        let _e1343 = (_e1342 + (_e1327 & 31u));
                        let _e1345 = leaves.member[_e1338];
                        let _e1347 = leaves.member[_e1343];
                        local_26 = type_24(array<u32, 3>(_e1345.member[0], _e1345.member[1], _e1345.member[2]), _e1345.member_1);
                        local_27 = type_24(array<u32, 3>(_e1347.member[0], _e1347.member[1], _e1347.member[2]), _e1347.member_1);
                        let _e1363 = nodes.member[_e1338];
                        let _e1365 = nodes.member[_e1343];
                        let _e1367 = params.member.member_1;
                        if ((_e1367 & 1u) != 0u) {
                            let _e1371 = params.member.member_8;
                            if (_e1371 == 0u) {
                                let _e1415 = local_26.member[0u];
                                let _e1418 = local_27.member[0u];
                                if (_e1415 == _e1418) {
                                    phi_2025_ = bool();
                                    phi_2026_ = true;
                                } else {
                                    let _e1422 = local_26.member[0u];
                                    let _e1425 = local_27.member[1u];
                                    let _e1426 = (_e1422 == _e1425);
                                    if _e1426 {
                                        phi_2024_ = bool();
                                    } else {
                                        let _e1429 = local_26.member[0u];
                                        let _e1432 = local_27.member[2u];
                                        phi_2024_ = (_e1429 == _e1432);
                                    }
                                    let _e1435 = phi_2024_;
                                    phi_2025_ = _e1435;
                                    phi_2026_ = _e1426;
                                }
                                let _e1437 = phi_2025_;
                                let _e1439 = phi_2026_;
                                if _e1439 {
                                    phi_2030_ = true;
                                } else {
                                    phi_2030_ = _e1437;
                                }
                                let _e1441 = phi_2030_;
                                phi_2069_ = _e1441;
                            } else {
                                let _e1375 = local_26.member[0u];
                                let _e1378 = local_27.member[0u];
                                if (_e1375 == _e1378) {
                                    phi_2063_ = bool();
                                    phi_2064_ = true;
                                } else {
                                    let _e1382 = local_26.member[0u];
                                    let _e1385 = local_27.member[1u];
                                    if (_e1382 == _e1385) {
                                        phi_2061_ = bool();
                                        phi_2062_ = true;
                                    } else {
                                        let _e1389 = local_26.member[1u];
                                        let _e1392 = local_27.member[0u];
                                        let _e1393 = (_e1389 == _e1392);
                                        if _e1393 {
                                            phi_2060_ = bool();
                                        } else {
                                            let _e1396 = local_26.member[1u];
                                            let _e1399 = local_27.member[1u];
                                            phi_2060_ = (_e1396 == _e1399);
                                        }
                                        let _e1402 = phi_2060_;
                                        phi_2061_ = _e1402;
                                        phi_2062_ = _e1393;
                                    }
                                    let _e1404 = phi_2061_;
                                    let _e1406 = phi_2062_;
                                    phi_2063_ = _e1404;
                                    phi_2064_ = _e1406;
                                }
                                let _e1408 = phi_2063_;
                                let _e1410 = phi_2064_;
                                if _e1410 {
                                    phi_2068_ = true;
                                } else {
                                    phi_2068_ = _e1408;
                                }
                                let _e1412 = phi_2068_;
                                phi_2069_ = _e1412;
                            }
                            let _e1443 = phi_2069_;
                            if _e1443 {
                                phi_2073_ = false;
                            } else {
                                phi_2073_ = true;
                            }
                            let _e1445 = phi_2073_;
                            phi_2074_ = _e1445;
                        } else {
                            phi_2074_ = true;
                        }
                        let _e1447 = phi_2074_;
                        if _e1447 {
                            let _e1449 = params.member.member_1;
                            if ((_e1449 & 2u) != 0u) {
                                let _e1454 = local_26.member[0u];
                                let _e1456 = bodies.member[_e1454];
                                let _e1459 = local_27.member[0u];
                                let _e1461 = bodies.member[_e1459];
                                if ((_e1456 / 2u) == (_e1461 / 2u)) {
                                    let _e1466 = params.member.member_1;
                                    phi_2120_ = !(((_e1466 & 4u) != 0u));
                                } else {
                                    phi_2120_ = false;
                                }
                                let _e1471 = phi_2120_;
                                if _e1471 {
                                    phi_2131_ = true;
                                } else {
                                    if (((_e1456 & _e1461) & 1u) == 0u) {
                                        phi_2130_ = false;
                                    } else {
                                        phi_2130_ = true;
                                    }
                                    let _e1476 = phi_2130_;
                                    phi_2131_ = _e1476;
                                }
                                let _e1478 = phi_2131_;
                                if _e1478 {
                                    phi_2135_ = false;
                                } else {
                                    phi_2135_ = true;
                                }
                                let _e1480 = phi_2135_;
                                phi_2136_ = _e1480;
                            } else {
                                phi_2136_ = true;
                            }
                            let _e1482 = phi_2136_;
                            if _e1482 {
                                let _e1484 = params.member.member_1;
                                if ((_e1484 & 32u) != 0u) {
                                    let _e1488 = params.member.member_6;
                                    let _e1529 = (((((((_e1363.member_1[0] - _e1365.member[0]) > _e1488) && ((_e1365.member_1[0] - _e1363.member[0]) > _e1488)) && ((_e1363.member_1[1] - _e1365.member[1]) > _e1488)) && ((_e1365.member_1[1] - _e1363.member[1]) > _e1488)) && ((_e1363.member_1[2] - _e1365.member[2]) > _e1488)) && ((_e1365.member_1[2] - _e1363.member[2]) > _e1488));
                                    if _e1529 {
                                        phi_2885_ = bool();
                                    } else {
                                        phi_2185_ = type_36(0u, 3u);
                                        phi_2188_ = true;
                                        loop {
                                            let _e1533 = phi_2185_;
                                            let _e1535 = phi_2188_;
                                            local_72 = _e1535;
                                            if (_e1533.member < _e1533.member_1) {
                                                phi_2186_ = type_36((_e1533.member + 1u), _e1533.member_1);
                                                phi_2211_ = type_36(1u, _e1533.member);
                                            } else {
                                                phi_2186_ = _e1533;
                                                phi_2211_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e1549 = phi_2186_;
                                            let _e1551 = phi_2211_;
                                            let _e1555 = (bitcast<i32>(_e1551.member) != 0i);
                                            if _e1555 {
                                                let _e1557 = local_26.member[0u];
                                                let _e1559 = keys.member[_e1557];
                                                local_14 = array<array<u32, 2>, 6>(array<u32, 2>(_e1559[0][0], _e1559[0][1]), array<u32, 2>(_e1559[1][0], _e1559[1][1]), array<u32, 2>(_e1559[2][0], _e1559[2][1]), array<u32, 2>(_e1559[3][0], _e1559[3][1]), array<u32, 2>(_e1559[4][0], _e1559[4][1]), array<u32, 2>(_e1559[5][0], _e1559[5][1]));
                                                if (_e1551.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1587 = local_14[_e1551.member_1];
                                                phi_2268_ = type_36(1u, 3u);
                                                phi_2271_ = array<u32, 2>(_e1587[0], _e1587[1]);
                                                loop {
                                                    let _e1592 = phi_2268_;
                                                    let _e1594 = phi_2271_;
                                                    local_40 = _e1594;
                                                    local_42 = _e1594;
                                                    local_44 = _e1594;
                                                    if (_e1592.member < _e1592.member_1) {
                                                        phi_2269_ = type_36((_e1592.member + 1u), _e1592.member_1);
                                                        phi_2294_ = type_36(1u, _e1592.member);
                                                    } else {
                                                        phi_2269_ = _e1592;
                                                        phi_2294_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1608 = phi_2269_;
                                                    let _e1610 = phi_2294_;
                                                    let _e1614 = (bitcast<i32>(_e1610.member) != 0i);
                                                    if _e1614 {
                                                        if (_e1610.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1617 = local_26.member[_e1610.member_1];
                                                        let _e1619 = keys.member[_e1617];
                                                        local_15 = array<array<u32, 2>, 6>(array<u32, 2>(_e1619[0][0], _e1619[0][1]), array<u32, 2>(_e1619[1][0], _e1619[1][1]), array<u32, 2>(_e1619[2][0], _e1619[2][1]), array<u32, 2>(_e1619[3][0], _e1619[3][1]), array<u32, 2>(_e1619[4][0], _e1619[4][1]), array<u32, 2>(_e1619[5][0], _e1619[5][1]));
                                                        if (_e1551.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1647 = local_15[_e1551.member_1];
                                                        if (_e1594[1] > _e1647[1]) {
                                                            phi_2370_ = true;
                                                        } else {
                                                            if (_e1594[1] == _e1647[1]) {
                                                                phi_2369_ = (_e1594[0] > _e1647[0]);
                                                            } else {
                                                                phi_2369_ = false;
                                                            }
                                                            let _e1658 = phi_2369_;
                                                            phi_2370_ = _e1658;
                                                        }
                                                        let _e1660 = phi_2370_;
                                                        if _e1660 {
                                                            phi_2374_ = array<u32, 2>(_e1647[0], _e1647[1]);
                                                        } else {
                                                            phi_2374_ = _e1594;
                                                        }
                                                        let _e1662 = phi_2374_;
                                                        phi_2272_ = _e1662;
                                                    } else {
                                                        phi_2272_ = array<u32, 2>();
                                                    }
                                                    let _e1664 = phi_2272_;
                                                    continue;
                                                    continuing {
                                                        phi_2268_ = _e1608;
                                                        phi_2271_ = _e1664;
                                                        break if !(_e1614);
                                                    }
                                                }
                                                let _e1667 = local_27.member[0u];
                                                let _e1669 = keys.member[_e1667];
                                                local_12 = array<array<u32, 2>, 6>(array<u32, 2>(_e1669[0][0], _e1669[0][1]), array<u32, 2>(_e1669[1][0], _e1669[1][1]), array<u32, 2>(_e1669[2][0], _e1669[2][1]), array<u32, 2>(_e1669[3][0], _e1669[3][1]), array<u32, 2>(_e1669[4][0], _e1669[4][1]), array<u32, 2>(_e1669[5][0], _e1669[5][1]));
                                                let _e1695 = (3u + _e1551.member_1);
                                                if (_e1695 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1698 = local_12[_e1695];
                                                phi_2425_ = type_36(1u, 3u);
                                                phi_2428_ = array<u32, 2>(_e1698[0], _e1698[1]);
                                                loop {
                                                    let _e1703 = phi_2425_;
                                                    let _e1705 = phi_2428_;
                                                    local_41 = _e1705;
                                                    local_43 = _e1705;
                                                    local_45 = _e1705;
                                                    if (_e1703.member < _e1703.member_1) {
                                                        phi_2426_ = type_36((_e1703.member + 1u), _e1703.member_1);
                                                        phi_2451_ = type_36(1u, _e1703.member);
                                                    } else {
                                                        phi_2426_ = _e1703;
                                                        phi_2451_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1719 = phi_2426_;
                                                    let _e1721 = phi_2451_;
                                                    let _e1725 = (bitcast<i32>(_e1721.member) != 0i);
                                                    if _e1725 {
                                                        if (_e1721.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1728 = local_27.member[_e1721.member_1];
                                                        let _e1730 = keys.member[_e1728];
                                                        local_13 = array<array<u32, 2>, 6>(array<u32, 2>(_e1730[0][0], _e1730[0][1]), array<u32, 2>(_e1730[1][0], _e1730[1][1]), array<u32, 2>(_e1730[2][0], _e1730[2][1]), array<u32, 2>(_e1730[3][0], _e1730[3][1]), array<u32, 2>(_e1730[4][0], _e1730[4][1]), array<u32, 2>(_e1730[5][0], _e1730[5][1]));
                                                        let _e1756 = (3u + _e1551.member_1);
                                                        if (_e1756 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1759 = local_13[_e1756];
                                                        if (_e1759[1] > _e1705[1]) {
                                                            phi_2528_ = true;
                                                        } else {
                                                            if (_e1759[1] == _e1705[1]) {
                                                                phi_2527_ = (_e1759[0] > _e1705[0]);
                                                            } else {
                                                                phi_2527_ = false;
                                                            }
                                                            let _e1770 = phi_2527_;
                                                            phi_2528_ = _e1770;
                                                        }
                                                        let _e1772 = phi_2528_;
                                                        if _e1772 {
                                                            phi_2532_ = array<u32, 2>(_e1759[0], _e1759[1]);
                                                        } else {
                                                            phi_2532_ = _e1705;
                                                        }
                                                        let _e1774 = phi_2532_;
                                                        phi_2429_ = _e1774;
                                                    } else {
                                                        phi_2429_ = array<u32, 2>();
                                                    }
                                                    let _e1776 = phi_2429_;
                                                    continue;
                                                    continuing {
                                                        phi_2425_ = _e1719;
                                                        phi_2428_ = _e1776;
                                                        break if !(_e1725);
                                                    }
                                                }
                                                let _e1779 = local_40;
                                                let _e1782 = local_41;
                                                if (_e1779[1] > _e1782[1]) {
                                                    phi_2549_ = true;
                                                } else {
                                                    let _e1786 = local_42;
                                                    let _e1789 = local_43;
                                                    if (_e1786[1] == _e1789[1]) {
                                                        let _e1793 = local_44;
                                                        let _e1796 = local_45;
                                                        phi_2548_ = (_e1793[0] > _e1796[0]);
                                                    } else {
                                                        phi_2548_ = false;
                                                    }
                                                    let _e1800 = phi_2548_;
                                                    phi_2549_ = _e1800;
                                                }
                                                let _e1802 = phi_2549_;
                                                let _e1805 = local_27.member[0u];
                                                let _e1807 = keys.member[_e1805];
                                                local_10 = array<array<u32, 2>, 6>(array<u32, 2>(_e1807[0][0], _e1807[0][1]), array<u32, 2>(_e1807[1][0], _e1807[1][1]), array<u32, 2>(_e1807[2][0], _e1807[2][1]), array<u32, 2>(_e1807[3][0], _e1807[3][1]), array<u32, 2>(_e1807[4][0], _e1807[4][1]), array<u32, 2>(_e1807[5][0], _e1807[5][1]));
                                                if (_e1551.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1835 = local_10[_e1551.member_1];
                                                phi_2600_ = type_36(1u, 3u);
                                                phi_2603_ = array<u32, 2>(_e1835[0], _e1835[1]);
                                                loop {
                                                    let _e1840 = phi_2600_;
                                                    let _e1842 = phi_2603_;
                                                    local_46 = _e1842;
                                                    local_48 = _e1842;
                                                    local_50 = _e1842;
                                                    if (_e1840.member < _e1840.member_1) {
                                                        phi_2601_ = type_36((_e1840.member + 1u), _e1840.member_1);
                                                        phi_2626_ = type_36(1u, _e1840.member);
                                                    } else {
                                                        phi_2601_ = _e1840;
                                                        phi_2626_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1856 = phi_2601_;
                                                    let _e1858 = phi_2626_;
                                                    let _e1862 = (bitcast<i32>(_e1858.member) != 0i);
                                                    if _e1862 {
                                                        if (_e1858.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1865 = local_27.member[_e1858.member_1];
                                                        let _e1867 = keys.member[_e1865];
                                                        local_11 = array<array<u32, 2>, 6>(array<u32, 2>(_e1867[0][0], _e1867[0][1]), array<u32, 2>(_e1867[1][0], _e1867[1][1]), array<u32, 2>(_e1867[2][0], _e1867[2][1]), array<u32, 2>(_e1867[3][0], _e1867[3][1]), array<u32, 2>(_e1867[4][0], _e1867[4][1]), array<u32, 2>(_e1867[5][0], _e1867[5][1]));
                                                        if (_e1551.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1895 = local_11[_e1551.member_1];
                                                        if (_e1842[1] > _e1895[1]) {
                                                            phi_2702_ = true;
                                                        } else {
                                                            if (_e1842[1] == _e1895[1]) {
                                                                phi_2701_ = (_e1842[0] > _e1895[0]);
                                                            } else {
                                                                phi_2701_ = false;
                                                            }
                                                            let _e1906 = phi_2701_;
                                                            phi_2702_ = _e1906;
                                                        }
                                                        let _e1908 = phi_2702_;
                                                        if _e1908 {
                                                            phi_2706_ = array<u32, 2>(_e1895[0], _e1895[1]);
                                                        } else {
                                                            phi_2706_ = _e1842;
                                                        }
                                                        let _e1910 = phi_2706_;
                                                        phi_2604_ = _e1910;
                                                    } else {
                                                        phi_2604_ = array<u32, 2>();
                                                    }
                                                    let _e1912 = phi_2604_;
                                                    continue;
                                                    continuing {
                                                        phi_2600_ = _e1856;
                                                        phi_2603_ = _e1912;
                                                        break if !(_e1862);
                                                    }
                                                }
                                                let _e1915 = local_26.member[0u];
                                                let _e1917 = keys.member[_e1915];
                                                local_8 = array<array<u32, 2>, 6>(array<u32, 2>(_e1917[0][0], _e1917[0][1]), array<u32, 2>(_e1917[1][0], _e1917[1][1]), array<u32, 2>(_e1917[2][0], _e1917[2][1]), array<u32, 2>(_e1917[3][0], _e1917[3][1]), array<u32, 2>(_e1917[4][0], _e1917[4][1]), array<u32, 2>(_e1917[5][0], _e1917[5][1]));
                                                let _e1943 = (3u + _e1551.member_1);
                                                if (_e1943 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1946 = local_8[_e1943];
                                                phi_2757_ = type_36(1u, 3u);
                                                phi_2760_ = array<u32, 2>(_e1946[0], _e1946[1]);
                                                loop {
                                                    let _e1951 = phi_2757_;
                                                    let _e1953 = phi_2760_;
                                                    local_47 = _e1953;
                                                    local_49 = _e1953;
                                                    local_51 = _e1953;
                                                    if (_e1951.member < _e1951.member_1) {
                                                        phi_2758_ = type_36((_e1951.member + 1u), _e1951.member_1);
                                                        phi_2783_ = type_36(1u, _e1951.member);
                                                    } else {
                                                        phi_2758_ = _e1951;
                                                        phi_2783_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1967 = phi_2758_;
                                                    let _e1969 = phi_2783_;
                                                    let _e1973 = (bitcast<i32>(_e1969.member) != 0i);
                                                    if _e1973 {
                                                        if (_e1969.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1976 = local_26.member[_e1969.member_1];
                                                        let _e1978 = keys.member[_e1976];
                                                        local_9 = array<array<u32, 2>, 6>(array<u32, 2>(_e1978[0][0], _e1978[0][1]), array<u32, 2>(_e1978[1][0], _e1978[1][1]), array<u32, 2>(_e1978[2][0], _e1978[2][1]), array<u32, 2>(_e1978[3][0], _e1978[3][1]), array<u32, 2>(_e1978[4][0], _e1978[4][1]), array<u32, 2>(_e1978[5][0], _e1978[5][1]));
                                                        let _e2004 = (3u + _e1551.member_1);
                                                        if (_e2004 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2007 = local_9[_e2004];
                                                        if (_e2007[1] > _e1953[1]) {
                                                            phi_2860_ = true;
                                                        } else {
                                                            if (_e2007[1] == _e1953[1]) {
                                                                phi_2859_ = (_e2007[0] > _e1953[0]);
                                                            } else {
                                                                phi_2859_ = false;
                                                            }
                                                            let _e2018 = phi_2859_;
                                                            phi_2860_ = _e2018;
                                                        }
                                                        let _e2020 = phi_2860_;
                                                        if _e2020 {
                                                            phi_2864_ = array<u32, 2>(_e2007[0], _e2007[1]);
                                                        } else {
                                                            phi_2864_ = _e1953;
                                                        }
                                                        let _e2022 = phi_2864_;
                                                        phi_2761_ = _e2022;
                                                    } else {
                                                        phi_2761_ = array<u32, 2>();
                                                    }
                                                    let _e2024 = phi_2761_;
                                                    continue;
                                                    continuing {
                                                        phi_2757_ = _e1967;
                                                        phi_2760_ = _e2024;
                                                        break if !(_e1973);
                                                    }
                                                }
                                                let _e2027 = local_46;
                                                let _e2030 = local_47;
                                                if (_e2027[1] > _e2030[1]) {
                                                    phi_2881_ = true;
                                                } else {
                                                    let _e2034 = local_48;
                                                    let _e2037 = local_49;
                                                    if (_e2034[1] == _e2037[1]) {
                                                        let _e2041 = local_50;
                                                        let _e2044 = local_51;
                                                        phi_2880_ = (_e2041[0] > _e2044[0]);
                                                    } else {
                                                        phi_2880_ = false;
                                                    }
                                                    let _e2048 = phi_2880_;
                                                    phi_2881_ = _e2048;
                                                }
                                                let _e2050 = phi_2881_;
                                                phi_2189_ = (_e1535 && (!(_e1802) && !(_e2050)));
                                            } else {
                                                phi_2189_ = bool();
                                            }
                                            let _e2055 = phi_2189_;
                                            continue;
                                            continuing {
                                                phi_2185_ = _e1549;
                                                phi_2188_ = _e2055;
                                                break if !(_e1555);
                                            }
                                        }
                                        let _e5713 = local_72;
                                        phi_2885_ = _e5713;
                                    }
                                    let _e2058 = phi_2885_;
                                    phi_2886_ = _e2058;
                                    phi_2887_ = _e1529;
                                } else {
                                    phi_2886_ = bool();
                                    phi_2887_ = true;
                                }
                                let _e2060 = phi_2886_;
                                let _e2062 = phi_2887_;
                                if _e2062 {
                                    phi_2891_ = false;
                                } else {
                                    phi_2891_ = true;
                                }
                                let _e2064 = phi_2891_;
                                phi_2892_ = _e2060;
                                phi_2893_ = _e2064;
                            } else {
                                phi_2892_ = false;
                                phi_2893_ = true;
                            }
                            let _e2066 = phi_2892_;
                            let _e2068 = phi_2893_;
                            phi_2894_ = _e2066;
                            phi_2895_ = _e2068;
                        } else {
                            phi_2894_ = false;
                            phi_2895_ = true;
                        }
                        let _e2070 = phi_2894_;
                        let _e2072 = phi_2895_;
                        if _e2072 {
                            phi_2899_ = _e2070;
                        } else {
                            phi_2899_ = true;
                        }
                        let _e2074 = phi_2899_;
                        if _e2074 {
                            let _e2076 = atomicAdd((&counters[7u]), 1u);
                            let _e2078 = params.member.member_4;
                            let _e2080 = params.member.member_5;
                            let _e2083 = local_26.member[0u];
                            let _e2086 = local_27.member[0u];
                            let _e2089 = local_27.member[1u];
                            let _e2092 = local_27.member[2u];
                            let _e2094 = paths.member[_e2083];
                            let _e2096 = paths.member[_e2086];
                            let _e2102 = paths.member[_e2089];
                            let _e2104 = paths.member[_e2092];
                            local_7 = type_71(array<array<f32, 3>, 2>(array<f32, 3>((_e2094.member[0] - _e2096.member[0]), (_e2094.member[1] - _e2096.member[1]), (_e2094.member[2] - _e2096.member[2])), array<f32, 3>((_e2094.member_1[0] - _e2096.member_1[0]), (_e2094.member_1[1] - _e2096.member_1[1]), (_e2094.member_1[2] - _e2096.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e2102.member[0] - _e2096.member[0]), (_e2102.member[1] - _e2096.member[1]), (_e2102.member[2] - _e2096.member[2])), array<f32, 3>((_e2102.member_1[0] - _e2096.member_1[0]), (_e2102.member_1[1] - _e2096.member_1[1]), (_e2102.member_1[2] - _e2096.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e2104.member[0] - _e2096.member[0]), (_e2104.member[1] - _e2096.member[1]), (_e2104.member[2] - _e2096.member[2])), array<f32, 3>((_e2104.member_1[0] - _e2096.member_1[0]), (_e2104.member_1[1] - _e2096.member_1[1]), (_e2104.member_1[2] - _e2096.member_1[2]))), (_e2078 + _e2078));
                            let _e2164 = local_7.member_1[0u];
                            let _e2170 = local_7.member_2[0u];
                            let _e2176 = ((_e2164[1] * _e2170[2]) - (_e2164[2] * _e2170[1]));
                            let _e2179 = ((_e2164[2] * _e2170[0]) - (_e2164[0] * _e2170[2]));
                            let _e2182 = ((_e2164[0] * _e2170[1]) - (_e2164[1] * _e2170[0]));
                            let _e2185 = local_7.member_1[1u];
                            let _e2191 = local_7.member_2[1u];
                            let _e2197 = ((_e2185[1] * _e2191[2]) - (_e2185[2] * _e2191[1]));
                            let _e2200 = ((_e2185[2] * _e2191[0]) - (_e2185[0] * _e2191[2]));
                            let _e2203 = ((_e2185[0] * _e2191[1]) - (_e2185[1] * _e2191[0]));
                            let _e2206 = local_7.member_1[0u];
                            let _e2212 = local_7.member_2[1u];
                            let _e2227 = local_7.member_1[1u];
                            let _e2233 = local_7.member_2[0u];
                            let _e2246 = (((_e2206[1] * _e2212[2]) - (_e2206[2] * _e2212[1])) + ((_e2227[1] * _e2233[2]) - (_e2227[2] * _e2233[1])));
                            let _e2247 = (((_e2206[2] * _e2212[0]) - (_e2206[0] * _e2212[2])) + ((_e2227[2] * _e2233[0]) - (_e2227[0] * _e2233[2])));
                            let _e2248 = (((_e2206[0] * _e2212[1]) - (_e2206[1] * _e2212[0])) + ((_e2227[0] * _e2233[1]) - (_e2227[1] * _e2233[0])));
                            let _e2251 = local_7.member[0u];
                            let _e2262 = local_7.member[1u];
                            let _e2273 = local_7.member[0u];
                            let _e2282 = ((((_e2262[0] * _e2176) + (_e2262[1] * _e2179)) + (_e2262[2] * _e2182)) + (((_e2273[0] * _e2246) + (_e2273[1] * _e2247)) + (_e2273[2] * _e2248)));
                            let _e2285 = local_7.member[0u];
                            let _e2296 = local_7.member[1u];
                            let _e2305 = ((((_e2285[0] * _e2197) + (_e2285[1] * _e2200)) + (_e2285[2] * _e2203)) + (((_e2296[0] * _e2246) + (_e2296[1] * _e2247)) + (_e2296[2] * _e2248)));
                            let _e2308 = local_7.member[1u];
                            let _e2319 = local_7.member[0u];
                            if (_e2319[0] < 0f) {
                                phi_3297_ = -(_e2319[0]);
                            } else {
                                phi_3297_ = _e2319[0];
                            }
                            let _e2326 = phi_3297_;
                            if (_e2319[1] < 0f) {
                                phi_3304_ = -(_e2319[1]);
                            } else {
                                phi_3304_ = _e2319[1];
                            }
                            let _e2330 = phi_3304_;
                            if (_e2326 > _e2330) {
                                phi_3309_ = _e2326;
                            } else {
                                phi_3309_ = _e2330;
                            }
                            let _e2333 = phi_3309_;
                            if (_e2319[2] < 0f) {
                                phi_3316_ = -(_e2319[2]);
                            } else {
                                phi_3316_ = _e2319[2];
                            }
                            let _e2337 = phi_3316_;
                            if (_e2333 > _e2337) {
                                phi_3321_ = _e2333;
                            } else {
                                phi_3321_ = _e2337;
                            }
                            let _e2340 = phi_3321_;
                            let _e2343 = local_7.member[1u];
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
                            if (_e2340 > _e2364) {
                                phi_3363_ = _e2340;
                            } else {
                                phi_3363_ = _e2364;
                            }
                            let _e2367 = phi_3363_;
                            let _e2369 = local_7.member_3;
                            let _e2370 = (_e2367 + _e2369);
                            let _e2373 = local_7.member_1[0u];
                            if (_e2373[0] < 0f) {
                                phi_3380_ = -(_e2373[0]);
                            } else {
                                phi_3380_ = _e2373[0];
                            }
                            let _e2380 = phi_3380_;
                            if (_e2373[1] < 0f) {
                                phi_3387_ = -(_e2373[1]);
                            } else {
                                phi_3387_ = _e2373[1];
                            }
                            let _e2384 = phi_3387_;
                            if (_e2380 > _e2384) {
                                phi_3392_ = _e2380;
                            } else {
                                phi_3392_ = _e2384;
                            }
                            let _e2387 = phi_3392_;
                            if (_e2373[2] < 0f) {
                                phi_3399_ = -(_e2373[2]);
                            } else {
                                phi_3399_ = _e2373[2];
                            }
                            let _e2391 = phi_3399_;
                            if (_e2387 > _e2391) {
                                phi_3404_ = _e2387;
                            } else {
                                phi_3404_ = _e2391;
                            }
                            let _e2394 = phi_3404_;
                            let _e2397 = local_7.member_1[1u];
                            if (_e2397[0] < 0f) {
                                phi_3418_ = -(_e2397[0]);
                            } else {
                                phi_3418_ = _e2397[0];
                            }
                            let _e2404 = phi_3418_;
                            if (_e2397[1] < 0f) {
                                phi_3425_ = -(_e2397[1]);
                            } else {
                                phi_3425_ = _e2397[1];
                            }
                            let _e2408 = phi_3425_;
                            if (_e2404 > _e2408) {
                                phi_3430_ = _e2404;
                            } else {
                                phi_3430_ = _e2408;
                            }
                            let _e2411 = phi_3430_;
                            if (_e2397[2] < 0f) {
                                phi_3437_ = -(_e2397[2]);
                            } else {
                                phi_3437_ = _e2397[2];
                            }
                            let _e2415 = phi_3437_;
                            if (_e2411 > _e2415) {
                                phi_3442_ = _e2411;
                            } else {
                                phi_3442_ = _e2415;
                            }
                            let _e2418 = phi_3442_;
                            if (_e2394 > _e2418) {
                                phi_3447_ = _e2394;
                            } else {
                                phi_3447_ = _e2418;
                            }
                            let _e2421 = phi_3447_;
                            let _e2423 = local_7.member_3;
                            let _e2424 = (_e2421 + _e2423);
                            let _e2427 = local_7.member_2[0u];
                            if (_e2427[0] < 0f) {
                                phi_3464_ = -(_e2427[0]);
                            } else {
                                phi_3464_ = _e2427[0];
                            }
                            let _e2434 = phi_3464_;
                            if (_e2427[1] < 0f) {
                                phi_3471_ = -(_e2427[1]);
                            } else {
                                phi_3471_ = _e2427[1];
                            }
                            let _e2438 = phi_3471_;
                            if (_e2434 > _e2438) {
                                phi_3476_ = _e2434;
                            } else {
                                phi_3476_ = _e2438;
                            }
                            let _e2441 = phi_3476_;
                            if (_e2427[2] < 0f) {
                                phi_3483_ = -(_e2427[2]);
                            } else {
                                phi_3483_ = _e2427[2];
                            }
                            let _e2445 = phi_3483_;
                            if (_e2441 > _e2445) {
                                phi_3488_ = _e2441;
                            } else {
                                phi_3488_ = _e2445;
                            }
                            let _e2448 = phi_3488_;
                            let _e2451 = local_7.member_2[1u];
                            if (_e2451[0] < 0f) {
                                phi_3502_ = -(_e2451[0]);
                            } else {
                                phi_3502_ = _e2451[0];
                            }
                            let _e2458 = phi_3502_;
                            if (_e2451[1] < 0f) {
                                phi_3509_ = -(_e2451[1]);
                            } else {
                                phi_3509_ = _e2451[1];
                            }
                            let _e2462 = phi_3509_;
                            if (_e2458 > _e2462) {
                                phi_3514_ = _e2458;
                            } else {
                                phi_3514_ = _e2462;
                            }
                            let _e2465 = phi_3514_;
                            if (_e2451[2] < 0f) {
                                phi_3521_ = -(_e2451[2]);
                            } else {
                                phi_3521_ = _e2451[2];
                            }
                            let _e2469 = phi_3521_;
                            if (_e2465 > _e2469) {
                                phi_3526_ = _e2465;
                            } else {
                                phi_3526_ = _e2469;
                            }
                            let _e2472 = phi_3526_;
                            if (_e2448 > _e2472) {
                                phi_3531_ = _e2448;
                            } else {
                                phi_3531_ = _e2472;
                            }
                            let _e2475 = phi_3531_;
                            let _e2477 = local_7.member_3;
                            let _e2478 = (_e2475 + _e2477);
                            let _e2480 = ((_e2424 * 8f) * _e2478);
                            let _e2487 = local_7.member_3;
                            if (_e2176 < 0f) {
                                phi_3562_ = -(_e2176);
                            } else {
                                phi_3562_ = _e2176;
                            }
                            let _e2504 = phi_3562_;
                            if (_e2179 < 0f) {
                                phi_3568_ = -(_e2179);
                            } else {
                                phi_3568_ = _e2179;
                            }
                            let _e2508 = phi_3568_;
                            if (_e2182 < 0f) {
                                phi_3575_ = -(_e2182);
                            } else {
                                phi_3575_ = _e2182;
                            }
                            let _e2513 = phi_3575_;
                            let _e2514 = ((_e2504 + _e2508) + _e2513);
                            if (_e2197 < 0f) {
                                phi_3582_ = -(_e2197);
                            } else {
                                phi_3582_ = _e2197;
                            }
                            let _e2518 = phi_3582_;
                            if (_e2200 < 0f) {
                                phi_3588_ = -(_e2200);
                            } else {
                                phi_3588_ = _e2200;
                            }
                            let _e2522 = phi_3588_;
                            if (_e2203 < 0f) {
                                phi_3595_ = -(_e2203);
                            } else {
                                phi_3595_ = _e2203;
                            }
                            let _e2527 = phi_3595_;
                            let _e2528 = ((_e2518 + _e2522) + _e2527);
                            if (_e2514 > _e2528) {
                                phi_3601_ = _e2514;
                            } else {
                                phi_3601_ = _e2528;
                            }
                            let _e2531 = phi_3601_;
                            if (_e2246 < 0f) {
                                phi_3607_ = -(_e2246);
                            } else {
                                phi_3607_ = _e2246;
                            }
                            let _e2535 = phi_3607_;
                            if (_e2247 < 0f) {
                                phi_3613_ = -(_e2247);
                            } else {
                                phi_3613_ = _e2247;
                            }
                            let _e2539 = phi_3613_;
                            if (_e2248 < 0f) {
                                phi_3620_ = -(_e2248);
                            } else {
                                phi_3620_ = _e2248;
                            }
                            let _e2544 = phi_3620_;
                            let _e2546 = (((_e2535 + _e2539) + _e2544) * 0.5f);
                            if (_e2531 > _e2546) {
                                phi_3627_ = _e2531;
                            } else {
                                phi_3627_ = _e2546;
                            }
                            let _e2549 = phi_3627_;
                            let _e2554 = local_7.member_3;
                            let _e2567 = ((((_e2251[0] * _e2176) + (_e2251[1] * _e2179)) + (_e2251[2] * _e2182)) * 3f);
                            let _e2568 = ((((_e2308[0] * _e2197) + (_e2308[1] * _e2200)) + (_e2308[2] * _e2203)) * 3f);
                            if (_e2567 < _e2568) {
                                phi_3651_ = _e2567;
                            } else {
                                phi_3651_ = _e2568;
                            }
                            let _e2571 = phi_3651_;
                            if (_e2282 < _e2305) {
                                phi_3656_ = _e2282;
                            } else {
                                phi_3656_ = _e2305;
                            }
                            let _e2574 = phi_3656_;
                            if (_e2571 < _e2574) {
                                phi_3661_ = _e2571;
                            } else {
                                phi_3661_ = _e2574;
                            }
                            let _e2577 = phi_3661_;
                            if (_e2567 > _e2568) {
                                phi_3666_ = _e2567;
                            } else {
                                phi_3666_ = _e2568;
                            }
                            let _e2580 = phi_3666_;
                            if (_e2282 > _e2305) {
                                phi_3671_ = _e2282;
                            } else {
                                phi_3671_ = _e2305;
                            }
                            let _e2583 = phi_3671_;
                            if (_e2580 > _e2583) {
                                phi_3676_ = _e2580;
                            } else {
                                phi_3676_ = _e2583;
                            }
                            let _e2586 = phi_3676_;
                            let _e2591 = -(_e2586);
                            if (_e2577 > _e2591) {
                                phi_3686_ = _e2577;
                            } else {
                                phi_3686_ = _e2591;
                            }
                            let _e2594 = phi_3686_;
                            if ((_e2594 - ((((((_e2370 * 8f) * _e2480) * (0.000000059604645f * (490f / 64f))) + ((_e2487 * 19f) * ((_e2370 * (_e2424 + _e2478)) + (_e2424 * _e2478)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2370) * ((1f + _e2424) * (1f + _e2478))))) + ((_e2080 * (((_e2549 + (_e2480 * (0.000000059604645f * 4f))) + ((_e2554 * 6f) * (_e2424 + _e2478))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2424) * (1f + _e2478))))) * (3f * 1.0001f)))) > 0f) {
                                phi_4662_ = true;
                            } else {
                                let _e2599 = local_7.member_1[0u];
                                let _e2605 = local_7.member_1[1u];
                                let _e2609 = (_e2599[0] + _e2605[0]);
                                let _e2610 = (_e2599[1] + _e2605[1]);
                                let _e2611 = (_e2599[2] + _e2605[2]);
                                let _e2614 = local_7.member_2[0u];
                                let _e2620 = local_7.member_2[1u];
                                let _e2624 = (_e2614[0] + _e2620[0]);
                                let _e2625 = (_e2614[1] + _e2620[1]);
                                let _e2626 = (_e2614[2] + _e2620[2]);
                                let _e2629 = ((_e2610 * _e2626) - (_e2611 * _e2625));
                                let _e2632 = ((_e2611 * _e2624) - (_e2609 * _e2626));
                                let _e2635 = ((_e2609 * _e2625) - (_e2610 * _e2624));
                                let _e2638 = local_7.member[0u];
                                let _e2644 = local_7.member_1[0u];
                                let _e2650 = local_7.member_2[0u];
                                let _e2662 = local_7.member[1u];
                                let _e2668 = local_7.member_1[1u];
                                let _e2674 = local_7.member_2[1u];
                                local_5 = array<array<f32, 3>, 4>(_e2638, array<f32, 3>((_e2638[0] - _e2644[0]), (_e2638[1] - _e2644[1]), (_e2638[2] - _e2644[2])), array<f32, 3>((_e2638[0] - _e2650[0]), (_e2638[1] - _e2650[1]), (_e2638[2] - _e2650[2])), _e2638);
                                local_6 = array<array<f32, 3>, 4>(_e2662, array<f32, 3>((_e2662[0] - _e2668[0]), (_e2662[1] - _e2668[1]), (_e2662[2] - _e2668[2])), array<f32, 3>((_e2662[0] - _e2674[0]), (_e2662[1] - _e2674[1]), (_e2662[2] - _e2674[2])), _e2662);
                                let _e2692 = local_7.member[0u];
                                if (_e2692[0] < 0f) {
                                    phi_3937_ = -(_e2692[0]);
                                } else {
                                    phi_3937_ = _e2692[0];
                                }
                                let _e2699 = phi_3937_;
                                if (_e2692[1] < 0f) {
                                    phi_3944_ = -(_e2692[1]);
                                } else {
                                    phi_3944_ = _e2692[1];
                                }
                                let _e2703 = phi_3944_;
                                if (_e2699 > _e2703) {
                                    phi_3949_ = _e2699;
                                } else {
                                    phi_3949_ = _e2703;
                                }
                                let _e2706 = phi_3949_;
                                if (_e2692[2] < 0f) {
                                    phi_3956_ = -(_e2692[2]);
                                } else {
                                    phi_3956_ = _e2692[2];
                                }
                                let _e2710 = phi_3956_;
                                if (_e2706 > _e2710) {
                                    phi_3961_ = _e2706;
                                } else {
                                    phi_3961_ = _e2710;
                                }
                                let _e2713 = phi_3961_;
                                let _e2716 = local_7.member[1u];
                                if (_e2716[0] < 0f) {
                                    phi_3974_ = -(_e2716[0]);
                                } else {
                                    phi_3974_ = _e2716[0];
                                }
                                let _e2723 = phi_3974_;
                                if (_e2716[1] < 0f) {
                                    phi_3981_ = -(_e2716[1]);
                                } else {
                                    phi_3981_ = _e2716[1];
                                }
                                let _e2727 = phi_3981_;
                                if (_e2723 > _e2727) {
                                    phi_3986_ = _e2723;
                                } else {
                                    phi_3986_ = _e2727;
                                }
                                let _e2730 = phi_3986_;
                                if (_e2716[2] < 0f) {
                                    phi_3993_ = -(_e2716[2]);
                                } else {
                                    phi_3993_ = _e2716[2];
                                }
                                let _e2734 = phi_3993_;
                                if (_e2730 > _e2734) {
                                    phi_3998_ = _e2730;
                                } else {
                                    phi_3998_ = _e2734;
                                }
                                let _e2737 = phi_3998_;
                                if (_e2713 > _e2737) {
                                    phi_4003_ = _e2713;
                                } else {
                                    phi_4003_ = _e2737;
                                }
                                let _e2740 = phi_4003_;
                                let _e2742 = local_7.member_3;
                                let _e2746 = local_7.member_1[0u];
                                if (_e2746[0] < 0f) {
                                    phi_4020_ = -(_e2746[0]);
                                } else {
                                    phi_4020_ = _e2746[0];
                                }
                                let _e2753 = phi_4020_;
                                if (_e2746[1] < 0f) {
                                    phi_4027_ = -(_e2746[1]);
                                } else {
                                    phi_4027_ = _e2746[1];
                                }
                                let _e2757 = phi_4027_;
                                if (_e2753 > _e2757) {
                                    phi_4032_ = _e2753;
                                } else {
                                    phi_4032_ = _e2757;
                                }
                                let _e2760 = phi_4032_;
                                if (_e2746[2] < 0f) {
                                    phi_4039_ = -(_e2746[2]);
                                } else {
                                    phi_4039_ = _e2746[2];
                                }
                                let _e2764 = phi_4039_;
                                if (_e2760 > _e2764) {
                                    phi_4044_ = _e2760;
                                } else {
                                    phi_4044_ = _e2764;
                                }
                                let _e2767 = phi_4044_;
                                let _e2770 = local_7.member_1[1u];
                                if (_e2770[0] < 0f) {
                                    phi_4058_ = -(_e2770[0]);
                                } else {
                                    phi_4058_ = _e2770[0];
                                }
                                let _e2777 = phi_4058_;
                                if (_e2770[1] < 0f) {
                                    phi_4065_ = -(_e2770[1]);
                                } else {
                                    phi_4065_ = _e2770[1];
                                }
                                let _e2781 = phi_4065_;
                                if (_e2777 > _e2781) {
                                    phi_4070_ = _e2777;
                                } else {
                                    phi_4070_ = _e2781;
                                }
                                let _e2784 = phi_4070_;
                                if (_e2770[2] < 0f) {
                                    phi_4077_ = -(_e2770[2]);
                                } else {
                                    phi_4077_ = _e2770[2];
                                }
                                let _e2788 = phi_4077_;
                                if (_e2784 > _e2788) {
                                    phi_4082_ = _e2784;
                                } else {
                                    phi_4082_ = _e2788;
                                }
                                let _e2791 = phi_4082_;
                                if (_e2767 > _e2791) {
                                    phi_4087_ = _e2767;
                                } else {
                                    phi_4087_ = _e2791;
                                }
                                let _e2794 = phi_4087_;
                                let _e2796 = local_7.member_3;
                                let _e2800 = local_7.member_2[0u];
                                if (_e2800[0] < 0f) {
                                    phi_4104_ = -(_e2800[0]);
                                } else {
                                    phi_4104_ = _e2800[0];
                                }
                                let _e2807 = phi_4104_;
                                if (_e2800[1] < 0f) {
                                    phi_4111_ = -(_e2800[1]);
                                } else {
                                    phi_4111_ = _e2800[1];
                                }
                                let _e2811 = phi_4111_;
                                if (_e2807 > _e2811) {
                                    phi_4116_ = _e2807;
                                } else {
                                    phi_4116_ = _e2811;
                                }
                                let _e2814 = phi_4116_;
                                if (_e2800[2] < 0f) {
                                    phi_4123_ = -(_e2800[2]);
                                } else {
                                    phi_4123_ = _e2800[2];
                                }
                                let _e2818 = phi_4123_;
                                if (_e2814 > _e2818) {
                                    phi_4128_ = _e2814;
                                } else {
                                    phi_4128_ = _e2818;
                                }
                                let _e2821 = phi_4128_;
                                let _e2824 = local_7.member_2[1u];
                                if (_e2824[0] < 0f) {
                                    phi_4142_ = -(_e2824[0]);
                                } else {
                                    phi_4142_ = _e2824[0];
                                }
                                let _e2831 = phi_4142_;
                                if (_e2824[1] < 0f) {
                                    phi_4149_ = -(_e2824[1]);
                                } else {
                                    phi_4149_ = _e2824[1];
                                }
                                let _e2835 = phi_4149_;
                                if (_e2831 > _e2835) {
                                    phi_4154_ = _e2831;
                                } else {
                                    phi_4154_ = _e2835;
                                }
                                let _e2838 = phi_4154_;
                                if (_e2824[2] < 0f) {
                                    phi_4161_ = -(_e2824[2]);
                                } else {
                                    phi_4161_ = _e2824[2];
                                }
                                let _e2842 = phi_4161_;
                                if (_e2838 > _e2842) {
                                    phi_4166_ = _e2838;
                                } else {
                                    phi_4166_ = _e2842;
                                }
                                let _e2845 = phi_4166_;
                                if (_e2821 > _e2845) {
                                    phi_4171_ = _e2821;
                                } else {
                                    phi_4171_ = _e2845;
                                }
                                let _e2848 = phi_4171_;
                                let _e2850 = local_7.member_3;
                                let _e2853 = (((_e2740 + _e2742) + (_e2794 + _e2796)) + (_e2848 + _e2850));
                                let _e2856 = local_7.member_3;
                                let _e2860 = (((_e2080 * 1.0001f) + (_e2856 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2863 = ((_e2632 * _e2611) - (_e2635 * _e2610));
                                let _e2866 = ((_e2635 * _e2609) - (_e2629 * _e2611));
                                let _e2869 = ((_e2629 * _e2610) - (_e2632 * _e2609));
                                let _e2871 = local_5[0u];
                                let _e2879 = (((_e2863 * _e2871[0]) + (_e2866 * _e2871[1])) + (_e2869 * _e2871[2]));
                                phi_4209_ = type_36(0u, 4u);
                                phi_4212_ = _e2879;
                                phi_4214_ = _e2879;
                                loop {
                                    let _e2881 = phi_4209_;
                                    let _e2883 = phi_4212_;
                                    let _e2885 = phi_4214_;
                                    local_52 = _e2883;
                                    local_53 = _e2885;
                                    local_73 = _e2885;
                                    if (_e2881.member < _e2881.member_1) {
                                        phi_4210_ = type_36((_e2881.member + 1u), _e2881.member_1);
                                        phi_4237_ = type_36(1u, _e2881.member);
                                    } else {
                                        phi_4210_ = _e2881;
                                        phi_4237_ = type_36(0u, type_36().member_1);
                                    }
                                    let _e2899 = phi_4210_;
                                    let _e2901 = phi_4237_;
                                    let _e2905 = (bitcast<i32>(_e2901.member) != 0i);
                                    if _e2905 {
                                        if (_e2901.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2908 = local_5[_e2901.member_1];
                                        let _e2916 = (((_e2863 * _e2908[0]) + (_e2866 * _e2908[1])) + (_e2869 * _e2908[2]));
                                        if (_e2901.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2919 = local_6[_e2901.member_1];
                                        let _e2927 = (((_e2863 * _e2919[0]) + (_e2866 * _e2919[1])) + (_e2869 * _e2919[2]));
                                        if (_e2885 < _e2916) {
                                            phi_4287_ = _e2885;
                                        } else {
                                            phi_4287_ = _e2916;
                                        }
                                        let _e2930 = phi_4287_;
                                        if (_e2930 < _e2927) {
                                            phi_4292_ = _e2930;
                                        } else {
                                            phi_4292_ = _e2927;
                                        }
                                        let _e2933 = phi_4292_;
                                        if (_e2883 > _e2916) {
                                            phi_4297_ = _e2883;
                                        } else {
                                            phi_4297_ = _e2916;
                                        }
                                        let _e2936 = phi_4297_;
                                        if (_e2936 > _e2927) {
                                            phi_4302_ = _e2936;
                                        } else {
                                            phi_4302_ = _e2927;
                                        }
                                        let _e2939 = phi_4302_;
                                        phi_4213_ = _e2939;
                                        phi_4215_ = _e2933;
                                    } else {
                                        phi_4213_ = f32();
                                        phi_4215_ = f32();
                                    }
                                    let _e2941 = phi_4213_;
                                    let _e2943 = phi_4215_;
                                    continue;
                                    continuing {
                                        phi_4209_ = _e2899;
                                        phi_4212_ = _e2941;
                                        phi_4214_ = _e2943;
                                        break if !(_e2905);
                                    }
                                }
                                if (_e2863 < 0f) {
                                    phi_4308_ = -(_e2863);
                                } else {
                                    phi_4308_ = _e2863;
                                }
                                let _e2948 = phi_4308_;
                                if (_e2866 < 0f) {
                                    phi_4314_ = -(_e2866);
                                } else {
                                    phi_4314_ = _e2866;
                                }
                                let _e2952 = phi_4314_;
                                if (_e2869 < 0f) {
                                    phi_4321_ = -(_e2869);
                                } else {
                                    phi_4321_ = _e2869;
                                }
                                let _e2957 = phi_4321_;
                                let _e2958 = ((_e2948 + _e2952) + _e2957);
                                let _e2963 = local_52;
                                let _e2964 = -(_e2963);
                                let _e2966 = local_53;
                                if (_e2966 > _e2964) {
                                    let _e5824 = local_73;
                                    phi_4331_ = _e5824;
                                } else {
                                    phi_4331_ = _e2964;
                                }
                                let _e2969 = phi_4331_;
                                let _e2974 = (((_e2969 - ((_e2958 * _e2853) * (0.000000059604645f * 17f))) - (_e2958 * _e2860)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2977 = ((_e2632 * _e2626) - (_e2635 * _e2625));
                                let _e2980 = ((_e2635 * _e2624) - (_e2629 * _e2626));
                                let _e2983 = ((_e2629 * _e2625) - (_e2632 * _e2624));
                                let _e2985 = local_5[0u];
                                let _e2993 = (((_e2977 * _e2985[0]) + (_e2980 * _e2985[1])) + (_e2983 * _e2985[2]));
                                phi_4362_ = type_36(0u, 4u);
                                phi_4365_ = _e2993;
                                phi_4367_ = _e2993;
                                loop {
                                    let _e2995 = phi_4362_;
                                    let _e2997 = phi_4365_;
                                    let _e2999 = phi_4367_;
                                    local_54 = _e2997;
                                    local_55 = _e2999;
                                    local_74 = _e2999;
                                    if (_e2995.member < _e2995.member_1) {
                                        phi_4363_ = type_36((_e2995.member + 1u), _e2995.member_1);
                                        phi_4390_ = type_36(1u, _e2995.member);
                                    } else {
                                        phi_4363_ = _e2995;
                                        phi_4390_ = type_36(0u, type_36().member_1);
                                    }
                                    let _e3013 = phi_4363_;
                                    let _e3015 = phi_4390_;
                                    let _e3019 = (bitcast<i32>(_e3015.member) != 0i);
                                    if _e3019 {
                                        if (_e3015.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e3022 = local_5[_e3015.member_1];
                                        let _e3030 = (((_e2977 * _e3022[0]) + (_e2980 * _e3022[1])) + (_e2983 * _e3022[2]));
                                        if (_e3015.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e3033 = local_6[_e3015.member_1];
                                        let _e3041 = (((_e2977 * _e3033[0]) + (_e2980 * _e3033[1])) + (_e2983 * _e3033[2]));
                                        if (_e2999 < _e3030) {
                                            phi_4440_ = _e2999;
                                        } else {
                                            phi_4440_ = _e3030;
                                        }
                                        let _e3044 = phi_4440_;
                                        if (_e3044 < _e3041) {
                                            phi_4445_ = _e3044;
                                        } else {
                                            phi_4445_ = _e3041;
                                        }
                                        let _e3047 = phi_4445_;
                                        if (_e2997 > _e3030) {
                                            phi_4450_ = _e2997;
                                        } else {
                                            phi_4450_ = _e3030;
                                        }
                                        let _e3050 = phi_4450_;
                                        if (_e3050 > _e3041) {
                                            phi_4455_ = _e3050;
                                        } else {
                                            phi_4455_ = _e3041;
                                        }
                                        let _e3053 = phi_4455_;
                                        phi_4366_ = _e3053;
                                        phi_4368_ = _e3047;
                                    } else {
                                        phi_4366_ = f32();
                                        phi_4368_ = f32();
                                    }
                                    let _e3055 = phi_4366_;
                                    let _e3057 = phi_4368_;
                                    continue;
                                    continuing {
                                        phi_4362_ = _e3013;
                                        phi_4365_ = _e3055;
                                        phi_4367_ = _e3057;
                                        break if !(_e3019);
                                    }
                                }
                                if (_e2977 < 0f) {
                                    phi_4461_ = -(_e2977);
                                } else {
                                    phi_4461_ = _e2977;
                                }
                                let _e3062 = phi_4461_;
                                if (_e2980 < 0f) {
                                    phi_4467_ = -(_e2980);
                                } else {
                                    phi_4467_ = _e2980;
                                }
                                let _e3066 = phi_4467_;
                                if (_e2983 < 0f) {
                                    phi_4474_ = -(_e2983);
                                } else {
                                    phi_4474_ = _e2983;
                                }
                                let _e3071 = phi_4474_;
                                let _e3072 = ((_e3062 + _e3066) + _e3071);
                                let _e3077 = local_54;
                                let _e3078 = -(_e3077);
                                let _e3080 = local_55;
                                if (_e3080 > _e3078) {
                                    let _e5843 = local_74;
                                    phi_4484_ = _e5843;
                                } else {
                                    phi_4484_ = _e3078;
                                }
                                let _e3083 = phi_4484_;
                                let _e3088 = (((_e3083 - ((_e3072 * _e2853) * (0.000000059604645f * 17f))) - (_e3072 * _e2860)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2974 > _e3088) {
                                    phi_4494_ = _e2974;
                                } else {
                                    phi_4494_ = _e3088;
                                }
                                let _e3091 = phi_4494_;
                                let _e3092 = (_e2624 - _e2609);
                                let _e3093 = (_e2625 - _e2610);
                                let _e3094 = (_e2626 - _e2611);
                                let _e3097 = ((_e2632 * _e3094) - (_e2635 * _e3093));
                                let _e3100 = ((_e2635 * _e3092) - (_e2629 * _e3094));
                                let _e3103 = ((_e2629 * _e3093) - (_e2632 * _e3092));
                                let _e3105 = local_5[0u];
                                let _e3113 = (((_e3097 * _e3105[0]) + (_e3100 * _e3105[1])) + (_e3103 * _e3105[2]));
                                phi_4527_ = type_36(0u, 4u);
                                phi_4530_ = _e3113;
                                phi_4532_ = _e3113;
                                loop {
                                    let _e3115 = phi_4527_;
                                    let _e3117 = phi_4530_;
                                    let _e3119 = phi_4532_;
                                    local_56 = _e3117;
                                    local_57 = _e3119;
                                    local_75 = _e3119;
                                    if (_e3115.member < _e3115.member_1) {
                                        phi_4528_ = type_36((_e3115.member + 1u), _e3115.member_1);
                                        phi_4555_ = type_36(1u, _e3115.member);
                                    } else {
                                        phi_4528_ = _e3115;
                                        phi_4555_ = type_36(0u, type_36().member_1);
                                    }
                                    let _e3133 = phi_4528_;
                                    let _e3135 = phi_4555_;
                                    let _e3139 = (bitcast<i32>(_e3135.member) != 0i);
                                    if _e3139 {
                                        if (_e3135.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e3142 = local_5[_e3135.member_1];
                                        let _e3150 = (((_e3097 * _e3142[0]) + (_e3100 * _e3142[1])) + (_e3103 * _e3142[2]));
                                        if (_e3135.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e3153 = local_6[_e3135.member_1];
                                        let _e3161 = (((_e3097 * _e3153[0]) + (_e3100 * _e3153[1])) + (_e3103 * _e3153[2]));
                                        if (_e3119 < _e3150) {
                                            phi_4605_ = _e3119;
                                        } else {
                                            phi_4605_ = _e3150;
                                        }
                                        let _e3164 = phi_4605_;
                                        if (_e3164 < _e3161) {
                                            phi_4610_ = _e3164;
                                        } else {
                                            phi_4610_ = _e3161;
                                        }
                                        let _e3167 = phi_4610_;
                                        if (_e3117 > _e3150) {
                                            phi_4615_ = _e3117;
                                        } else {
                                            phi_4615_ = _e3150;
                                        }
                                        let _e3170 = phi_4615_;
                                        if (_e3170 > _e3161) {
                                            phi_4620_ = _e3170;
                                        } else {
                                            phi_4620_ = _e3161;
                                        }
                                        let _e3173 = phi_4620_;
                                        phi_4531_ = _e3173;
                                        phi_4533_ = _e3167;
                                    } else {
                                        phi_4531_ = f32();
                                        phi_4533_ = f32();
                                    }
                                    let _e3175 = phi_4531_;
                                    let _e3177 = phi_4533_;
                                    continue;
                                    continuing {
                                        phi_4527_ = _e3133;
                                        phi_4530_ = _e3175;
                                        phi_4532_ = _e3177;
                                        break if !(_e3139);
                                    }
                                }
                                if (_e3097 < 0f) {
                                    phi_4626_ = -(_e3097);
                                } else {
                                    phi_4626_ = _e3097;
                                }
                                let _e3182 = phi_4626_;
                                if (_e3100 < 0f) {
                                    phi_4632_ = -(_e3100);
                                } else {
                                    phi_4632_ = _e3100;
                                }
                                let _e3186 = phi_4632_;
                                if (_e3103 < 0f) {
                                    phi_4639_ = -(_e3103);
                                } else {
                                    phi_4639_ = _e3103;
                                }
                                let _e3191 = phi_4639_;
                                let _e3192 = ((_e3182 + _e3186) + _e3191);
                                let _e3197 = local_56;
                                let _e3198 = -(_e3197);
                                let _e3200 = local_57;
                                if (_e3200 > _e3198) {
                                    let _e5863 = local_75;
                                    phi_4649_ = _e5863;
                                } else {
                                    phi_4649_ = _e3198;
                                }
                                let _e3203 = phi_4649_;
                                let _e3208 = (((_e3203 - ((_e3192 * _e2853) * (0.000000059604645f * 17f))) - (_e3192 * _e2860)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e3091 > _e3208) {
                                    phi_4659_ = _e3091;
                                } else {
                                    phi_4659_ = _e3208;
                                }
                                let _e3211 = phi_4659_;
                                phi_4662_ = (_e3211 > 0f);
                            }
                            let _e3214 = phi_4662_;
                            if _e3214 {
                                phi_8098_ = false;
                            } else {
                                let _e3217 = local_7.member[0u];
                                let _e3223 = local_7.member[1u];
                                let _e3230 = ((_e3217[0] + _e3223[0]) * 0.5f);
                                let _e3231 = ((_e3217[1] + _e3223[1]) * 0.5f);
                                let _e3232 = ((_e3217[2] + _e3223[2]) * 0.5f);
                                let _e3235 = local_7.member_1[0u];
                                let _e3241 = local_7.member_1[1u];
                                let _e3248 = ((_e3235[0] + _e3241[0]) * 0.5f);
                                let _e3249 = ((_e3235[1] + _e3241[1]) * 0.5f);
                                let _e3250 = ((_e3235[2] + _e3241[2]) * 0.5f);
                                let _e3253 = local_7.member_2[0u];
                                let _e3259 = local_7.member_2[1u];
                                let _e3266 = ((_e3253[0] + _e3259[0]) * 0.5f);
                                let _e3267 = ((_e3253[1] + _e3259[1]) * 0.5f);
                                let _e3268 = ((_e3253[2] + _e3259[2]) * 0.5f);
                                let _e3271 = local_7.member[0u];
                                let _e3274 = local_7.member_1[0u];
                                let _e3277 = local_7.member_2[0u];
                                let _e3279 = local_7.member_3;
                                let _e3282 = local_7.member[1u];
                                let _e3285 = local_7.member_1[1u];
                                let _e3288 = local_7.member_2[1u];
                                let _e3290 = local_7.member_3;
                                local_4 = array<type_71, 2>(type_71(array<array<f32, 3>, 2>(_e3271, array<f32, 3>(_e3230, _e3231, _e3232)), array<array<f32, 3>, 2>(_e3274, array<f32, 3>(_e3248, _e3249, _e3250)), array<array<f32, 3>, 2>(_e3277, array<f32, 3>(_e3266, _e3267, _e3268)), _e3279), type_71(array<array<f32, 3>, 2>(array<f32, 3>(_e3230, _e3231, _e3232), _e3282), array<array<f32, 3>, 2>(array<f32, 3>(_e3248, _e3249, _e3250), _e3285), array<array<f32, 3>, 2>(array<f32, 3>(_e3266, _e3267, _e3268), _e3288), _e3290));
                                let _e3309 = local_4[0u].member_1[0u];
                                let _e3315 = local_4[0u].member_2[0u];
                                let _e3321 = ((_e3309[1] * _e3315[2]) - (_e3309[2] * _e3315[1]));
                                let _e3324 = ((_e3309[2] * _e3315[0]) - (_e3309[0] * _e3315[2]));
                                let _e3327 = ((_e3309[0] * _e3315[1]) - (_e3309[1] * _e3315[0]));
                                let _e3330 = local_4[0u].member_1[1u];
                                let _e3336 = local_4[0u].member_2[1u];
                                let _e3342 = ((_e3330[1] * _e3336[2]) - (_e3330[2] * _e3336[1]));
                                let _e3345 = ((_e3330[2] * _e3336[0]) - (_e3330[0] * _e3336[2]));
                                let _e3348 = ((_e3330[0] * _e3336[1]) - (_e3330[1] * _e3336[0]));
                                let _e3351 = local_4[0u].member_1[0u];
                                let _e3357 = local_4[0u].member_2[1u];
                                let _e3372 = local_4[0u].member_1[1u];
                                let _e3378 = local_4[0u].member_2[0u];
                                let _e3391 = (((_e3351[1] * _e3357[2]) - (_e3351[2] * _e3357[1])) + ((_e3372[1] * _e3378[2]) - (_e3372[2] * _e3378[1])));
                                let _e3392 = (((_e3351[2] * _e3357[0]) - (_e3351[0] * _e3357[2])) + ((_e3372[2] * _e3378[0]) - (_e3372[0] * _e3378[2])));
                                let _e3393 = (((_e3351[0] * _e3357[1]) - (_e3351[1] * _e3357[0])) + ((_e3372[0] * _e3378[1]) - (_e3372[1] * _e3378[0])));
                                let _e3396 = local_4[0u].member[0u];
                                let _e3407 = local_4[0u].member[1u];
                                let _e3418 = local_4[0u].member[0u];
                                let _e3427 = ((((_e3407[0] * _e3321) + (_e3407[1] * _e3324)) + (_e3407[2] * _e3327)) + (((_e3418[0] * _e3391) + (_e3418[1] * _e3392)) + (_e3418[2] * _e3393)));
                                let _e3430 = local_4[0u].member[0u];
                                let _e3441 = local_4[0u].member[1u];
                                let _e3450 = ((((_e3430[0] * _e3342) + (_e3430[1] * _e3345)) + (_e3430[2] * _e3348)) + (((_e3441[0] * _e3391) + (_e3441[1] * _e3392)) + (_e3441[2] * _e3393)));
                                let _e3453 = local_4[0u].member[1u];
                                let _e3464 = local_4[0u].member[0u];
                                if (_e3464[0] < 0f) {
                                    phi_5119_ = -(_e3464[0]);
                                } else {
                                    phi_5119_ = _e3464[0];
                                }
                                let _e3471 = phi_5119_;
                                if (_e3464[1] < 0f) {
                                    phi_5126_ = -(_e3464[1]);
                                } else {
                                    phi_5126_ = _e3464[1];
                                }
                                let _e3475 = phi_5126_;
                                if (_e3471 > _e3475) {
                                    phi_5131_ = _e3471;
                                } else {
                                    phi_5131_ = _e3475;
                                }
                                let _e3478 = phi_5131_;
                                if (_e3464[2] < 0f) {
                                    phi_5138_ = -(_e3464[2]);
                                } else {
                                    phi_5138_ = _e3464[2];
                                }
                                let _e3482 = phi_5138_;
                                if (_e3478 > _e3482) {
                                    phi_5143_ = _e3478;
                                } else {
                                    phi_5143_ = _e3482;
                                }
                                let _e3485 = phi_5143_;
                                let _e3488 = local_4[0u].member[1u];
                                if (_e3488[0] < 0f) {
                                    phi_5156_ = -(_e3488[0]);
                                } else {
                                    phi_5156_ = _e3488[0];
                                }
                                let _e3495 = phi_5156_;
                                if (_e3488[1] < 0f) {
                                    phi_5163_ = -(_e3488[1]);
                                } else {
                                    phi_5163_ = _e3488[1];
                                }
                                let _e3499 = phi_5163_;
                                if (_e3495 > _e3499) {
                                    phi_5168_ = _e3495;
                                } else {
                                    phi_5168_ = _e3499;
                                }
                                let _e3502 = phi_5168_;
                                if (_e3488[2] < 0f) {
                                    phi_5175_ = -(_e3488[2]);
                                } else {
                                    phi_5175_ = _e3488[2];
                                }
                                let _e3506 = phi_5175_;
                                if (_e3502 > _e3506) {
                                    phi_5180_ = _e3502;
                                } else {
                                    phi_5180_ = _e3506;
                                }
                                let _e3509 = phi_5180_;
                                if (_e3485 > _e3509) {
                                    phi_5185_ = _e3485;
                                } else {
                                    phi_5185_ = _e3509;
                                }
                                let _e3512 = phi_5185_;
                                let _e3514 = local_4[0u].member_3;
                                let _e3515 = (_e3512 + _e3514);
                                let _e3518 = local_4[0u].member_1[0u];
                                if (_e3518[0] < 0f) {
                                    phi_5202_ = -(_e3518[0]);
                                } else {
                                    phi_5202_ = _e3518[0];
                                }
                                let _e3525 = phi_5202_;
                                if (_e3518[1] < 0f) {
                                    phi_5209_ = -(_e3518[1]);
                                } else {
                                    phi_5209_ = _e3518[1];
                                }
                                let _e3529 = phi_5209_;
                                if (_e3525 > _e3529) {
                                    phi_5214_ = _e3525;
                                } else {
                                    phi_5214_ = _e3529;
                                }
                                let _e3532 = phi_5214_;
                                if (_e3518[2] < 0f) {
                                    phi_5221_ = -(_e3518[2]);
                                } else {
                                    phi_5221_ = _e3518[2];
                                }
                                let _e3536 = phi_5221_;
                                if (_e3532 > _e3536) {
                                    phi_5226_ = _e3532;
                                } else {
                                    phi_5226_ = _e3536;
                                }
                                let _e3539 = phi_5226_;
                                let _e3542 = local_4[0u].member_1[1u];
                                if (_e3542[0] < 0f) {
                                    phi_5240_ = -(_e3542[0]);
                                } else {
                                    phi_5240_ = _e3542[0];
                                }
                                let _e3549 = phi_5240_;
                                if (_e3542[1] < 0f) {
                                    phi_5247_ = -(_e3542[1]);
                                } else {
                                    phi_5247_ = _e3542[1];
                                }
                                let _e3553 = phi_5247_;
                                if (_e3549 > _e3553) {
                                    phi_5252_ = _e3549;
                                } else {
                                    phi_5252_ = _e3553;
                                }
                                let _e3556 = phi_5252_;
                                if (_e3542[2] < 0f) {
                                    phi_5259_ = -(_e3542[2]);
                                } else {
                                    phi_5259_ = _e3542[2];
                                }
                                let _e3560 = phi_5259_;
                                if (_e3556 > _e3560) {
                                    phi_5264_ = _e3556;
                                } else {
                                    phi_5264_ = _e3560;
                                }
                                let _e3563 = phi_5264_;
                                if (_e3539 > _e3563) {
                                    phi_5269_ = _e3539;
                                } else {
                                    phi_5269_ = _e3563;
                                }
                                let _e3566 = phi_5269_;
                                let _e3568 = local_4[0u].member_3;
                                let _e3569 = (_e3566 + _e3568);
                                let _e3572 = local_4[0u].member_2[0u];
                                if (_e3572[0] < 0f) {
                                    phi_5286_ = -(_e3572[0]);
                                } else {
                                    phi_5286_ = _e3572[0];
                                }
                                let _e3579 = phi_5286_;
                                if (_e3572[1] < 0f) {
                                    phi_5293_ = -(_e3572[1]);
                                } else {
                                    phi_5293_ = _e3572[1];
                                }
                                let _e3583 = phi_5293_;
                                if (_e3579 > _e3583) {
                                    phi_5298_ = _e3579;
                                } else {
                                    phi_5298_ = _e3583;
                                }
                                let _e3586 = phi_5298_;
                                if (_e3572[2] < 0f) {
                                    phi_5305_ = -(_e3572[2]);
                                } else {
                                    phi_5305_ = _e3572[2];
                                }
                                let _e3590 = phi_5305_;
                                if (_e3586 > _e3590) {
                                    phi_5310_ = _e3586;
                                } else {
                                    phi_5310_ = _e3590;
                                }
                                let _e3593 = phi_5310_;
                                let _e3596 = local_4[0u].member_2[1u];
                                if (_e3596[0] < 0f) {
                                    phi_5324_ = -(_e3596[0]);
                                } else {
                                    phi_5324_ = _e3596[0];
                                }
                                let _e3603 = phi_5324_;
                                if (_e3596[1] < 0f) {
                                    phi_5331_ = -(_e3596[1]);
                                } else {
                                    phi_5331_ = _e3596[1];
                                }
                                let _e3607 = phi_5331_;
                                if (_e3603 > _e3607) {
                                    phi_5336_ = _e3603;
                                } else {
                                    phi_5336_ = _e3607;
                                }
                                let _e3610 = phi_5336_;
                                if (_e3596[2] < 0f) {
                                    phi_5343_ = -(_e3596[2]);
                                } else {
                                    phi_5343_ = _e3596[2];
                                }
                                let _e3614 = phi_5343_;
                                if (_e3610 > _e3614) {
                                    phi_5348_ = _e3610;
                                } else {
                                    phi_5348_ = _e3614;
                                }
                                let _e3617 = phi_5348_;
                                if (_e3593 > _e3617) {
                                    phi_5353_ = _e3593;
                                } else {
                                    phi_5353_ = _e3617;
                                }
                                let _e3620 = phi_5353_;
                                let _e3622 = local_4[0u].member_3;
                                let _e3623 = (_e3620 + _e3622);
                                let _e3625 = ((_e3569 * 8f) * _e3623);
                                let _e3632 = local_4[0u].member_3;
                                if (_e3321 < 0f) {
                                    phi_5384_ = -(_e3321);
                                } else {
                                    phi_5384_ = _e3321;
                                }
                                let _e3649 = phi_5384_;
                                if (_e3324 < 0f) {
                                    phi_5390_ = -(_e3324);
                                } else {
                                    phi_5390_ = _e3324;
                                }
                                let _e3653 = phi_5390_;
                                if (_e3327 < 0f) {
                                    phi_5397_ = -(_e3327);
                                } else {
                                    phi_5397_ = _e3327;
                                }
                                let _e3658 = phi_5397_;
                                let _e3659 = ((_e3649 + _e3653) + _e3658);
                                if (_e3342 < 0f) {
                                    phi_5404_ = -(_e3342);
                                } else {
                                    phi_5404_ = _e3342;
                                }
                                let _e3663 = phi_5404_;
                                if (_e3345 < 0f) {
                                    phi_5410_ = -(_e3345);
                                } else {
                                    phi_5410_ = _e3345;
                                }
                                let _e3667 = phi_5410_;
                                if (_e3348 < 0f) {
                                    phi_5417_ = -(_e3348);
                                } else {
                                    phi_5417_ = _e3348;
                                }
                                let _e3672 = phi_5417_;
                                let _e3673 = ((_e3663 + _e3667) + _e3672);
                                if (_e3659 > _e3673) {
                                    phi_5423_ = _e3659;
                                } else {
                                    phi_5423_ = _e3673;
                                }
                                let _e3676 = phi_5423_;
                                if (_e3391 < 0f) {
                                    phi_5429_ = -(_e3391);
                                } else {
                                    phi_5429_ = _e3391;
                                }
                                let _e3680 = phi_5429_;
                                if (_e3392 < 0f) {
                                    phi_5435_ = -(_e3392);
                                } else {
                                    phi_5435_ = _e3392;
                                }
                                let _e3684 = phi_5435_;
                                if (_e3393 < 0f) {
                                    phi_5442_ = -(_e3393);
                                } else {
                                    phi_5442_ = _e3393;
                                }
                                let _e3689 = phi_5442_;
                                let _e3691 = (((_e3680 + _e3684) + _e3689) * 0.5f);
                                if (_e3676 > _e3691) {
                                    phi_5449_ = _e3676;
                                } else {
                                    phi_5449_ = _e3691;
                                }
                                let _e3694 = phi_5449_;
                                let _e3699 = local_4[0u].member_3;
                                let _e3712 = ((((_e3396[0] * _e3321) + (_e3396[1] * _e3324)) + (_e3396[2] * _e3327)) * 3f);
                                let _e3713 = ((((_e3453[0] * _e3342) + (_e3453[1] * _e3345)) + (_e3453[2] * _e3348)) * 3f);
                                if (_e3712 < _e3713) {
                                    phi_5473_ = _e3712;
                                } else {
                                    phi_5473_ = _e3713;
                                }
                                let _e3716 = phi_5473_;
                                if (_e3427 < _e3450) {
                                    phi_5478_ = _e3427;
                                } else {
                                    phi_5478_ = _e3450;
                                }
                                let _e3719 = phi_5478_;
                                if (_e3716 < _e3719) {
                                    phi_5483_ = _e3716;
                                } else {
                                    phi_5483_ = _e3719;
                                }
                                let _e3722 = phi_5483_;
                                if (_e3712 > _e3713) {
                                    phi_5488_ = _e3712;
                                } else {
                                    phi_5488_ = _e3713;
                                }
                                let _e3725 = phi_5488_;
                                if (_e3427 > _e3450) {
                                    phi_5493_ = _e3427;
                                } else {
                                    phi_5493_ = _e3450;
                                }
                                let _e3728 = phi_5493_;
                                if (_e3725 > _e3728) {
                                    phi_5498_ = _e3725;
                                } else {
                                    phi_5498_ = _e3728;
                                }
                                let _e3731 = phi_5498_;
                                let _e3736 = -(_e3731);
                                if (_e3722 > _e3736) {
                                    phi_5508_ = _e3722;
                                } else {
                                    phi_5508_ = _e3736;
                                }
                                let _e3739 = phi_5508_;
                                if ((_e3739 - ((((((_e3515 * 8f) * _e3625) * (0.000000059604645f * (490f / 64f))) + ((_e3632 * 19f) * ((_e3515 * (_e3569 + _e3623)) + (_e3569 * _e3623)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3515) * ((1f + _e3569) * (1f + _e3623))))) + ((_e2080 * (((_e3694 + (_e3625 * (0.000000059604645f * 4f))) + ((_e3699 * 6f) * (_e3569 + _e3623))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3569) * (1f + _e3623))))) * (3f * 1.0001f)))) > 0f) {
                                    phi_6484_ = true;
                                } else {
                                    let _e3744 = local_4[0u].member_1[0u];
                                    let _e3750 = local_4[0u].member_1[1u];
                                    let _e3754 = (_e3744[0] + _e3750[0]);
                                    let _e3755 = (_e3744[1] + _e3750[1]);
                                    let _e3756 = (_e3744[2] + _e3750[2]);
                                    let _e3759 = local_4[0u].member_2[0u];
                                    let _e3765 = local_4[0u].member_2[1u];
                                    let _e3769 = (_e3759[0] + _e3765[0]);
                                    let _e3770 = (_e3759[1] + _e3765[1]);
                                    let _e3771 = (_e3759[2] + _e3765[2]);
                                    let _e3774 = ((_e3755 * _e3771) - (_e3756 * _e3770));
                                    let _e3777 = ((_e3756 * _e3769) - (_e3754 * _e3771));
                                    let _e3780 = ((_e3754 * _e3770) - (_e3755 * _e3769));
                                    let _e3783 = local_4[0u].member[0u];
                                    let _e3789 = local_4[0u].member_1[0u];
                                    let _e3795 = local_4[0u].member_2[0u];
                                    let _e3807 = local_4[0u].member[1u];
                                    let _e3813 = local_4[0u].member_1[1u];
                                    let _e3819 = local_4[0u].member_2[1u];
                                    local_2 = array<array<f32, 3>, 4>(_e3783, array<f32, 3>((_e3783[0] - _e3789[0]), (_e3783[1] - _e3789[1]), (_e3783[2] - _e3789[2])), array<f32, 3>((_e3783[0] - _e3795[0]), (_e3783[1] - _e3795[1]), (_e3783[2] - _e3795[2])), _e3783);
                                    local_3 = array<array<f32, 3>, 4>(_e3807, array<f32, 3>((_e3807[0] - _e3813[0]), (_e3807[1] - _e3813[1]), (_e3807[2] - _e3813[2])), array<f32, 3>((_e3807[0] - _e3819[0]), (_e3807[1] - _e3819[1]), (_e3807[2] - _e3819[2])), _e3807);
                                    let _e3837 = local_4[0u].member[0u];
                                    if (_e3837[0] < 0f) {
                                        phi_5759_ = -(_e3837[0]);
                                    } else {
                                        phi_5759_ = _e3837[0];
                                    }
                                    let _e3844 = phi_5759_;
                                    if (_e3837[1] < 0f) {
                                        phi_5766_ = -(_e3837[1]);
                                    } else {
                                        phi_5766_ = _e3837[1];
                                    }
                                    let _e3848 = phi_5766_;
                                    if (_e3844 > _e3848) {
                                        phi_5771_ = _e3844;
                                    } else {
                                        phi_5771_ = _e3848;
                                    }
                                    let _e3851 = phi_5771_;
                                    if (_e3837[2] < 0f) {
                                        phi_5778_ = -(_e3837[2]);
                                    } else {
                                        phi_5778_ = _e3837[2];
                                    }
                                    let _e3855 = phi_5778_;
                                    if (_e3851 > _e3855) {
                                        phi_5783_ = _e3851;
                                    } else {
                                        phi_5783_ = _e3855;
                                    }
                                    let _e3858 = phi_5783_;
                                    let _e3861 = local_4[0u].member[1u];
                                    if (_e3861[0] < 0f) {
                                        phi_5796_ = -(_e3861[0]);
                                    } else {
                                        phi_5796_ = _e3861[0];
                                    }
                                    let _e3868 = phi_5796_;
                                    if (_e3861[1] < 0f) {
                                        phi_5803_ = -(_e3861[1]);
                                    } else {
                                        phi_5803_ = _e3861[1];
                                    }
                                    let _e3872 = phi_5803_;
                                    if (_e3868 > _e3872) {
                                        phi_5808_ = _e3868;
                                    } else {
                                        phi_5808_ = _e3872;
                                    }
                                    let _e3875 = phi_5808_;
                                    if (_e3861[2] < 0f) {
                                        phi_5815_ = -(_e3861[2]);
                                    } else {
                                        phi_5815_ = _e3861[2];
                                    }
                                    let _e3879 = phi_5815_;
                                    if (_e3875 > _e3879) {
                                        phi_5820_ = _e3875;
                                    } else {
                                        phi_5820_ = _e3879;
                                    }
                                    let _e3882 = phi_5820_;
                                    if (_e3858 > _e3882) {
                                        phi_5825_ = _e3858;
                                    } else {
                                        phi_5825_ = _e3882;
                                    }
                                    let _e3885 = phi_5825_;
                                    let _e3887 = local_4[0u].member_3;
                                    let _e3891 = local_4[0u].member_1[0u];
                                    if (_e3891[0] < 0f) {
                                        phi_5842_ = -(_e3891[0]);
                                    } else {
                                        phi_5842_ = _e3891[0];
                                    }
                                    let _e3898 = phi_5842_;
                                    if (_e3891[1] < 0f) {
                                        phi_5849_ = -(_e3891[1]);
                                    } else {
                                        phi_5849_ = _e3891[1];
                                    }
                                    let _e3902 = phi_5849_;
                                    if (_e3898 > _e3902) {
                                        phi_5854_ = _e3898;
                                    } else {
                                        phi_5854_ = _e3902;
                                    }
                                    let _e3905 = phi_5854_;
                                    if (_e3891[2] < 0f) {
                                        phi_5861_ = -(_e3891[2]);
                                    } else {
                                        phi_5861_ = _e3891[2];
                                    }
                                    let _e3909 = phi_5861_;
                                    if (_e3905 > _e3909) {
                                        phi_5866_ = _e3905;
                                    } else {
                                        phi_5866_ = _e3909;
                                    }
                                    let _e3912 = phi_5866_;
                                    let _e3915 = local_4[0u].member_1[1u];
                                    if (_e3915[0] < 0f) {
                                        phi_5880_ = -(_e3915[0]);
                                    } else {
                                        phi_5880_ = _e3915[0];
                                    }
                                    let _e3922 = phi_5880_;
                                    if (_e3915[1] < 0f) {
                                        phi_5887_ = -(_e3915[1]);
                                    } else {
                                        phi_5887_ = _e3915[1];
                                    }
                                    let _e3926 = phi_5887_;
                                    if (_e3922 > _e3926) {
                                        phi_5892_ = _e3922;
                                    } else {
                                        phi_5892_ = _e3926;
                                    }
                                    let _e3929 = phi_5892_;
                                    if (_e3915[2] < 0f) {
                                        phi_5899_ = -(_e3915[2]);
                                    } else {
                                        phi_5899_ = _e3915[2];
                                    }
                                    let _e3933 = phi_5899_;
                                    if (_e3929 > _e3933) {
                                        phi_5904_ = _e3929;
                                    } else {
                                        phi_5904_ = _e3933;
                                    }
                                    let _e3936 = phi_5904_;
                                    if (_e3912 > _e3936) {
                                        phi_5909_ = _e3912;
                                    } else {
                                        phi_5909_ = _e3936;
                                    }
                                    let _e3939 = phi_5909_;
                                    let _e3941 = local_4[0u].member_3;
                                    let _e3945 = local_4[0u].member_2[0u];
                                    if (_e3945[0] < 0f) {
                                        phi_5926_ = -(_e3945[0]);
                                    } else {
                                        phi_5926_ = _e3945[0];
                                    }
                                    let _e3952 = phi_5926_;
                                    if (_e3945[1] < 0f) {
                                        phi_5933_ = -(_e3945[1]);
                                    } else {
                                        phi_5933_ = _e3945[1];
                                    }
                                    let _e3956 = phi_5933_;
                                    if (_e3952 > _e3956) {
                                        phi_5938_ = _e3952;
                                    } else {
                                        phi_5938_ = _e3956;
                                    }
                                    let _e3959 = phi_5938_;
                                    if (_e3945[2] < 0f) {
                                        phi_5945_ = -(_e3945[2]);
                                    } else {
                                        phi_5945_ = _e3945[2];
                                    }
                                    let _e3963 = phi_5945_;
                                    if (_e3959 > _e3963) {
                                        phi_5950_ = _e3959;
                                    } else {
                                        phi_5950_ = _e3963;
                                    }
                                    let _e3966 = phi_5950_;
                                    let _e3969 = local_4[0u].member_2[1u];
                                    if (_e3969[0] < 0f) {
                                        phi_5964_ = -(_e3969[0]);
                                    } else {
                                        phi_5964_ = _e3969[0];
                                    }
                                    let _e3976 = phi_5964_;
                                    if (_e3969[1] < 0f) {
                                        phi_5971_ = -(_e3969[1]);
                                    } else {
                                        phi_5971_ = _e3969[1];
                                    }
                                    let _e3980 = phi_5971_;
                                    if (_e3976 > _e3980) {
                                        phi_5976_ = _e3976;
                                    } else {
                                        phi_5976_ = _e3980;
                                    }
                                    let _e3983 = phi_5976_;
                                    if (_e3969[2] < 0f) {
                                        phi_5983_ = -(_e3969[2]);
                                    } else {
                                        phi_5983_ = _e3969[2];
                                    }
                                    let _e3987 = phi_5983_;
                                    if (_e3983 > _e3987) {
                                        phi_5988_ = _e3983;
                                    } else {
                                        phi_5988_ = _e3987;
                                    }
                                    let _e3990 = phi_5988_;
                                    if (_e3966 > _e3990) {
                                        phi_5993_ = _e3966;
                                    } else {
                                        phi_5993_ = _e3990;
                                    }
                                    let _e3993 = phi_5993_;
                                    let _e3995 = local_4[0u].member_3;
                                    let _e3998 = (((_e3885 + _e3887) + (_e3939 + _e3941)) + (_e3993 + _e3995));
                                    let _e4001 = local_4[0u].member_3;
                                    let _e4005 = (((_e2080 * 1.0001f) + (_e4001 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e4008 = ((_e3777 * _e3756) - (_e3780 * _e3755));
                                    let _e4011 = ((_e3780 * _e3754) - (_e3774 * _e3756));
                                    let _e4014 = ((_e3774 * _e3755) - (_e3777 * _e3754));
                                    let _e4016 = local_2[0u];
                                    let _e4024 = (((_e4008 * _e4016[0]) + (_e4011 * _e4016[1])) + (_e4014 * _e4016[2]));
                                    phi_6031_ = type_36(0u, 4u);
                                    phi_6034_ = _e4024;
                                    phi_6036_ = _e4024;
                                    loop {
                                        let _e4026 = phi_6031_;
                                        let _e4028 = phi_6034_;
                                        let _e4030 = phi_6036_;
                                        local_58 = _e4028;
                                        local_59 = _e4030;
                                        local_76 = _e4030;
                                        if (_e4026.member < _e4026.member_1) {
                                            phi_6032_ = type_36((_e4026.member + 1u), _e4026.member_1);
                                            phi_6059_ = type_36(1u, _e4026.member);
                                        } else {
                                            phi_6032_ = _e4026;
                                            phi_6059_ = type_36(0u, type_36().member_1);
                                        }
                                        let _e4044 = phi_6032_;
                                        let _e4046 = phi_6059_;
                                        let _e4050 = (bitcast<i32>(_e4046.member) != 0i);
                                        if _e4050 {
                                            if (_e4046.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e4053 = local_2[_e4046.member_1];
                                            let _e4061 = (((_e4008 * _e4053[0]) + (_e4011 * _e4053[1])) + (_e4014 * _e4053[2]));
                                            if (_e4046.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e4064 = local_3[_e4046.member_1];
                                            let _e4072 = (((_e4008 * _e4064[0]) + (_e4011 * _e4064[1])) + (_e4014 * _e4064[2]));
                                            if (_e4030 < _e4061) {
                                                phi_6109_ = _e4030;
                                            } else {
                                                phi_6109_ = _e4061;
                                            }
                                            let _e4075 = phi_6109_;
                                            if (_e4075 < _e4072) {
                                                phi_6114_ = _e4075;
                                            } else {
                                                phi_6114_ = _e4072;
                                            }
                                            let _e4078 = phi_6114_;
                                            if (_e4028 > _e4061) {
                                                phi_6119_ = _e4028;
                                            } else {
                                                phi_6119_ = _e4061;
                                            }
                                            let _e4081 = phi_6119_;
                                            if (_e4081 > _e4072) {
                                                phi_6124_ = _e4081;
                                            } else {
                                                phi_6124_ = _e4072;
                                            }
                                            let _e4084 = phi_6124_;
                                            phi_6035_ = _e4084;
                                            phi_6037_ = _e4078;
                                        } else {
                                            phi_6035_ = f32();
                                            phi_6037_ = f32();
                                        }
                                        let _e4086 = phi_6035_;
                                        let _e4088 = phi_6037_;
                                        continue;
                                        continuing {
                                            phi_6031_ = _e4044;
                                            phi_6034_ = _e4086;
                                            phi_6036_ = _e4088;
                                            break if !(_e4050);
                                        }
                                    }
                                    if (_e4008 < 0f) {
                                        phi_6130_ = -(_e4008);
                                    } else {
                                        phi_6130_ = _e4008;
                                    }
                                    let _e4093 = phi_6130_;
                                    if (_e4011 < 0f) {
                                        phi_6136_ = -(_e4011);
                                    } else {
                                        phi_6136_ = _e4011;
                                    }
                                    let _e4097 = phi_6136_;
                                    if (_e4014 < 0f) {
                                        phi_6143_ = -(_e4014);
                                    } else {
                                        phi_6143_ = _e4014;
                                    }
                                    let _e4102 = phi_6143_;
                                    let _e4103 = ((_e4093 + _e4097) + _e4102);
                                    let _e4108 = local_58;
                                    let _e4109 = -(_e4108);
                                    let _e4111 = local_59;
                                    if (_e4111 > _e4109) {
                                        let _e5968 = local_76;
                                        phi_6153_ = _e5968;
                                    } else {
                                        phi_6153_ = _e4109;
                                    }
                                    let _e4114 = phi_6153_;
                                    let _e4119 = (((_e4114 - ((_e4103 * _e3998) * (0.000000059604645f * 17f))) - (_e4103 * _e4005)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e4122 = ((_e3777 * _e3771) - (_e3780 * _e3770));
                                    let _e4125 = ((_e3780 * _e3769) - (_e3774 * _e3771));
                                    let _e4128 = ((_e3774 * _e3770) - (_e3777 * _e3769));
                                    let _e4130 = local_2[0u];
                                    let _e4138 = (((_e4122 * _e4130[0]) + (_e4125 * _e4130[1])) + (_e4128 * _e4130[2]));
                                    phi_6184_ = type_36(0u, 4u);
                                    phi_6187_ = _e4138;
                                    phi_6189_ = _e4138;
                                    loop {
                                        let _e4140 = phi_6184_;
                                        let _e4142 = phi_6187_;
                                        let _e4144 = phi_6189_;
                                        local_60 = _e4142;
                                        local_61 = _e4144;
                                        local_77 = _e4144;
                                        if (_e4140.member < _e4140.member_1) {
                                            phi_6185_ = type_36((_e4140.member + 1u), _e4140.member_1);
                                            phi_6212_ = type_36(1u, _e4140.member);
                                        } else {
                                            phi_6185_ = _e4140;
                                            phi_6212_ = type_36(0u, type_36().member_1);
                                        }
                                        let _e4158 = phi_6185_;
                                        let _e4160 = phi_6212_;
                                        let _e4164 = (bitcast<i32>(_e4160.member) != 0i);
                                        if _e4164 {
                                            if (_e4160.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e4167 = local_2[_e4160.member_1];
                                            let _e4175 = (((_e4122 * _e4167[0]) + (_e4125 * _e4167[1])) + (_e4128 * _e4167[2]));
                                            if (_e4160.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e4178 = local_3[_e4160.member_1];
                                            let _e4186 = (((_e4122 * _e4178[0]) + (_e4125 * _e4178[1])) + (_e4128 * _e4178[2]));
                                            if (_e4144 < _e4175) {
                                                phi_6262_ = _e4144;
                                            } else {
                                                phi_6262_ = _e4175;
                                            }
                                            let _e4189 = phi_6262_;
                                            if (_e4189 < _e4186) {
                                                phi_6267_ = _e4189;
                                            } else {
                                                phi_6267_ = _e4186;
                                            }
                                            let _e4192 = phi_6267_;
                                            if (_e4142 > _e4175) {
                                                phi_6272_ = _e4142;
                                            } else {
                                                phi_6272_ = _e4175;
                                            }
                                            let _e4195 = phi_6272_;
                                            if (_e4195 > _e4186) {
                                                phi_6277_ = _e4195;
                                            } else {
                                                phi_6277_ = _e4186;
                                            }
                                            let _e4198 = phi_6277_;
                                            phi_6188_ = _e4198;
                                            phi_6190_ = _e4192;
                                        } else {
                                            phi_6188_ = f32();
                                            phi_6190_ = f32();
                                        }
                                        let _e4200 = phi_6188_;
                                        let _e4202 = phi_6190_;
                                        continue;
                                        continuing {
                                            phi_6184_ = _e4158;
                                            phi_6187_ = _e4200;
                                            phi_6189_ = _e4202;
                                            break if !(_e4164);
                                        }
                                    }
                                    if (_e4122 < 0f) {
                                        phi_6283_ = -(_e4122);
                                    } else {
                                        phi_6283_ = _e4122;
                                    }
                                    let _e4207 = phi_6283_;
                                    if (_e4125 < 0f) {
                                        phi_6289_ = -(_e4125);
                                    } else {
                                        phi_6289_ = _e4125;
                                    }
                                    let _e4211 = phi_6289_;
                                    if (_e4128 < 0f) {
                                        phi_6296_ = -(_e4128);
                                    } else {
                                        phi_6296_ = _e4128;
                                    }
                                    let _e4216 = phi_6296_;
                                    let _e4217 = ((_e4207 + _e4211) + _e4216);
                                    let _e4222 = local_60;
                                    let _e4223 = -(_e4222);
                                    let _e4225 = local_61;
                                    if (_e4225 > _e4223) {
                                        let _e5987 = local_77;
                                        phi_6306_ = _e5987;
                                    } else {
                                        phi_6306_ = _e4223;
                                    }
                                    let _e4228 = phi_6306_;
                                    let _e4233 = (((_e4228 - ((_e4217 * _e3998) * (0.000000059604645f * 17f))) - (_e4217 * _e4005)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e4119 > _e4233) {
                                        phi_6316_ = _e4119;
                                    } else {
                                        phi_6316_ = _e4233;
                                    }
                                    let _e4236 = phi_6316_;
                                    let _e4237 = (_e3769 - _e3754);
                                    let _e4238 = (_e3770 - _e3755);
                                    let _e4239 = (_e3771 - _e3756);
                                    let _e4242 = ((_e3777 * _e4239) - (_e3780 * _e4238));
                                    let _e4245 = ((_e3780 * _e4237) - (_e3774 * _e4239));
                                    let _e4248 = ((_e3774 * _e4238) - (_e3777 * _e4237));
                                    let _e4250 = local_2[0u];
                                    let _e4258 = (((_e4242 * _e4250[0]) + (_e4245 * _e4250[1])) + (_e4248 * _e4250[2]));
                                    phi_6349_ = type_36(0u, 4u);
                                    phi_6352_ = _e4258;
                                    phi_6354_ = _e4258;
                                    loop {
                                        let _e4260 = phi_6349_;
                                        let _e4262 = phi_6352_;
                                        let _e4264 = phi_6354_;
                                        local_62 = _e4262;
                                        local_63 = _e4264;
                                        local_78 = _e4264;
                                        if (_e4260.member < _e4260.member_1) {
                                            phi_6350_ = type_36((_e4260.member + 1u), _e4260.member_1);
                                            phi_6377_ = type_36(1u, _e4260.member);
                                        } else {
                                            phi_6350_ = _e4260;
                                            phi_6377_ = type_36(0u, type_36().member_1);
                                        }
                                        let _e4278 = phi_6350_;
                                        let _e4280 = phi_6377_;
                                        let _e4284 = (bitcast<i32>(_e4280.member) != 0i);
                                        if _e4284 {
                                            if (_e4280.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e4287 = local_2[_e4280.member_1];
                                            let _e4295 = (((_e4242 * _e4287[0]) + (_e4245 * _e4287[1])) + (_e4248 * _e4287[2]));
                                            if (_e4280.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e4298 = local_3[_e4280.member_1];
                                            let _e4306 = (((_e4242 * _e4298[0]) + (_e4245 * _e4298[1])) + (_e4248 * _e4298[2]));
                                            if (_e4264 < _e4295) {
                                                phi_6427_ = _e4264;
                                            } else {
                                                phi_6427_ = _e4295;
                                            }
                                            let _e4309 = phi_6427_;
                                            if (_e4309 < _e4306) {
                                                phi_6432_ = _e4309;
                                            } else {
                                                phi_6432_ = _e4306;
                                            }
                                            let _e4312 = phi_6432_;
                                            if (_e4262 > _e4295) {
                                                phi_6437_ = _e4262;
                                            } else {
                                                phi_6437_ = _e4295;
                                            }
                                            let _e4315 = phi_6437_;
                                            if (_e4315 > _e4306) {
                                                phi_6442_ = _e4315;
                                            } else {
                                                phi_6442_ = _e4306;
                                            }
                                            let _e4318 = phi_6442_;
                                            phi_6353_ = _e4318;
                                            phi_6355_ = _e4312;
                                        } else {
                                            phi_6353_ = f32();
                                            phi_6355_ = f32();
                                        }
                                        let _e4320 = phi_6353_;
                                        let _e4322 = phi_6355_;
                                        continue;
                                        continuing {
                                            phi_6349_ = _e4278;
                                            phi_6352_ = _e4320;
                                            phi_6354_ = _e4322;
                                            break if !(_e4284);
                                        }
                                    }
                                    if (_e4242 < 0f) {
                                        phi_6448_ = -(_e4242);
                                    } else {
                                        phi_6448_ = _e4242;
                                    }
                                    let _e4327 = phi_6448_;
                                    if (_e4245 < 0f) {
                                        phi_6454_ = -(_e4245);
                                    } else {
                                        phi_6454_ = _e4245;
                                    }
                                    let _e4331 = phi_6454_;
                                    if (_e4248 < 0f) {
                                        phi_6461_ = -(_e4248);
                                    } else {
                                        phi_6461_ = _e4248;
                                    }
                                    let _e4336 = phi_6461_;
                                    let _e4337 = ((_e4327 + _e4331) + _e4336);
                                    let _e4342 = local_62;
                                    let _e4343 = -(_e4342);
                                    let _e4345 = local_63;
                                    if (_e4345 > _e4343) {
                                        let _e6007 = local_78;
                                        phi_6471_ = _e6007;
                                    } else {
                                        phi_6471_ = _e4343;
                                    }
                                    let _e4348 = phi_6471_;
                                    let _e4353 = (((_e4348 - ((_e4337 * _e3998) * (0.000000059604645f * 17f))) - (_e4337 * _e4005)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e4236 > _e4353) {
                                        phi_6481_ = _e4236;
                                    } else {
                                        phi_6481_ = _e4353;
                                    }
                                    let _e4356 = phi_6481_;
                                    phi_6484_ = (_e4356 > 0f);
                                }
                                let _e4359 = phi_6484_;
                                if _e4359 {
                                    let _e4363 = local_4[1u].member_1[0u];
                                    let _e4369 = local_4[1u].member_2[0u];
                                    let _e4375 = ((_e4363[1] * _e4369[2]) - (_e4363[2] * _e4369[1]));
                                    let _e4378 = ((_e4363[2] * _e4369[0]) - (_e4363[0] * _e4369[2]));
                                    let _e4381 = ((_e4363[0] * _e4369[1]) - (_e4363[1] * _e4369[0]));
                                    let _e4384 = local_4[1u].member_1[1u];
                                    let _e4390 = local_4[1u].member_2[1u];
                                    let _e4396 = ((_e4384[1] * _e4390[2]) - (_e4384[2] * _e4390[1]));
                                    let _e4399 = ((_e4384[2] * _e4390[0]) - (_e4384[0] * _e4390[2]));
                                    let _e4402 = ((_e4384[0] * _e4390[1]) - (_e4384[1] * _e4390[0]));
                                    let _e4405 = local_4[1u].member_1[0u];
                                    let _e4411 = local_4[1u].member_2[1u];
                                    let _e4426 = local_4[1u].member_1[1u];
                                    let _e4432 = local_4[1u].member_2[0u];
                                    let _e4445 = (((_e4405[1] * _e4411[2]) - (_e4405[2] * _e4411[1])) + ((_e4426[1] * _e4432[2]) - (_e4426[2] * _e4432[1])));
                                    let _e4446 = (((_e4405[2] * _e4411[0]) - (_e4405[0] * _e4411[2])) + ((_e4426[2] * _e4432[0]) - (_e4426[0] * _e4432[2])));
                                    let _e4447 = (((_e4405[0] * _e4411[1]) - (_e4405[1] * _e4411[0])) + ((_e4426[0] * _e4432[1]) - (_e4426[1] * _e4432[0])));
                                    let _e4450 = local_4[1u].member[0u];
                                    let _e4461 = local_4[1u].member[1u];
                                    let _e4472 = local_4[1u].member[0u];
                                    let _e4481 = ((((_e4461[0] * _e4375) + (_e4461[1] * _e4378)) + (_e4461[2] * _e4381)) + (((_e4472[0] * _e4445) + (_e4472[1] * _e4446)) + (_e4472[2] * _e4447)));
                                    let _e4484 = local_4[1u].member[0u];
                                    let _e4495 = local_4[1u].member[1u];
                                    let _e4504 = ((((_e4484[0] * _e4396) + (_e4484[1] * _e4399)) + (_e4484[2] * _e4402)) + (((_e4495[0] * _e4445) + (_e4495[1] * _e4446)) + (_e4495[2] * _e4447)));
                                    let _e4507 = local_4[1u].member[1u];
                                    let _e4518 = local_4[1u].member[0u];
                                    if (_e4518[0] < 0f) {
                                        phi_6730_ = -(_e4518[0]);
                                    } else {
                                        phi_6730_ = _e4518[0];
                                    }
                                    let _e4525 = phi_6730_;
                                    if (_e4518[1] < 0f) {
                                        phi_6737_ = -(_e4518[1]);
                                    } else {
                                        phi_6737_ = _e4518[1];
                                    }
                                    let _e4529 = phi_6737_;
                                    if (_e4525 > _e4529) {
                                        phi_6742_ = _e4525;
                                    } else {
                                        phi_6742_ = _e4529;
                                    }
                                    let _e4532 = phi_6742_;
                                    if (_e4518[2] < 0f) {
                                        phi_6749_ = -(_e4518[2]);
                                    } else {
                                        phi_6749_ = _e4518[2];
                                    }
                                    let _e4536 = phi_6749_;
                                    if (_e4532 > _e4536) {
                                        phi_6754_ = _e4532;
                                    } else {
                                        phi_6754_ = _e4536;
                                    }
                                    let _e4539 = phi_6754_;
                                    let _e4542 = local_4[1u].member[1u];
                                    if (_e4542[0] < 0f) {
                                        phi_6767_ = -(_e4542[0]);
                                    } else {
                                        phi_6767_ = _e4542[0];
                                    }
                                    let _e4549 = phi_6767_;
                                    if (_e4542[1] < 0f) {
                                        phi_6774_ = -(_e4542[1]);
                                    } else {
                                        phi_6774_ = _e4542[1];
                                    }
                                    let _e4553 = phi_6774_;
                                    if (_e4549 > _e4553) {
                                        phi_6779_ = _e4549;
                                    } else {
                                        phi_6779_ = _e4553;
                                    }
                                    let _e4556 = phi_6779_;
                                    if (_e4542[2] < 0f) {
                                        phi_6786_ = -(_e4542[2]);
                                    } else {
                                        phi_6786_ = _e4542[2];
                                    }
                                    let _e4560 = phi_6786_;
                                    if (_e4556 > _e4560) {
                                        phi_6791_ = _e4556;
                                    } else {
                                        phi_6791_ = _e4560;
                                    }
                                    let _e4563 = phi_6791_;
                                    if (_e4539 > _e4563) {
                                        phi_6796_ = _e4539;
                                    } else {
                                        phi_6796_ = _e4563;
                                    }
                                    let _e4566 = phi_6796_;
                                    let _e4568 = local_4[1u].member_3;
                                    let _e4569 = (_e4566 + _e4568);
                                    let _e4572 = local_4[1u].member_1[0u];
                                    if (_e4572[0] < 0f) {
                                        phi_6813_ = -(_e4572[0]);
                                    } else {
                                        phi_6813_ = _e4572[0];
                                    }
                                    let _e4579 = phi_6813_;
                                    if (_e4572[1] < 0f) {
                                        phi_6820_ = -(_e4572[1]);
                                    } else {
                                        phi_6820_ = _e4572[1];
                                    }
                                    let _e4583 = phi_6820_;
                                    if (_e4579 > _e4583) {
                                        phi_6825_ = _e4579;
                                    } else {
                                        phi_6825_ = _e4583;
                                    }
                                    let _e4586 = phi_6825_;
                                    if (_e4572[2] < 0f) {
                                        phi_6832_ = -(_e4572[2]);
                                    } else {
                                        phi_6832_ = _e4572[2];
                                    }
                                    let _e4590 = phi_6832_;
                                    if (_e4586 > _e4590) {
                                        phi_6837_ = _e4586;
                                    } else {
                                        phi_6837_ = _e4590;
                                    }
                                    let _e4593 = phi_6837_;
                                    let _e4596 = local_4[1u].member_1[1u];
                                    if (_e4596[0] < 0f) {
                                        phi_6851_ = -(_e4596[0]);
                                    } else {
                                        phi_6851_ = _e4596[0];
                                    }
                                    let _e4603 = phi_6851_;
                                    if (_e4596[1] < 0f) {
                                        phi_6858_ = -(_e4596[1]);
                                    } else {
                                        phi_6858_ = _e4596[1];
                                    }
                                    let _e4607 = phi_6858_;
                                    if (_e4603 > _e4607) {
                                        phi_6863_ = _e4603;
                                    } else {
                                        phi_6863_ = _e4607;
                                    }
                                    let _e4610 = phi_6863_;
                                    if (_e4596[2] < 0f) {
                                        phi_6870_ = -(_e4596[2]);
                                    } else {
                                        phi_6870_ = _e4596[2];
                                    }
                                    let _e4614 = phi_6870_;
                                    if (_e4610 > _e4614) {
                                        phi_6875_ = _e4610;
                                    } else {
                                        phi_6875_ = _e4614;
                                    }
                                    let _e4617 = phi_6875_;
                                    if (_e4593 > _e4617) {
                                        phi_6880_ = _e4593;
                                    } else {
                                        phi_6880_ = _e4617;
                                    }
                                    let _e4620 = phi_6880_;
                                    let _e4622 = local_4[1u].member_3;
                                    let _e4623 = (_e4620 + _e4622);
                                    let _e4626 = local_4[1u].member_2[0u];
                                    if (_e4626[0] < 0f) {
                                        phi_6897_ = -(_e4626[0]);
                                    } else {
                                        phi_6897_ = _e4626[0];
                                    }
                                    let _e4633 = phi_6897_;
                                    if (_e4626[1] < 0f) {
                                        phi_6904_ = -(_e4626[1]);
                                    } else {
                                        phi_6904_ = _e4626[1];
                                    }
                                    let _e4637 = phi_6904_;
                                    if (_e4633 > _e4637) {
                                        phi_6909_ = _e4633;
                                    } else {
                                        phi_6909_ = _e4637;
                                    }
                                    let _e4640 = phi_6909_;
                                    if (_e4626[2] < 0f) {
                                        phi_6916_ = -(_e4626[2]);
                                    } else {
                                        phi_6916_ = _e4626[2];
                                    }
                                    let _e4644 = phi_6916_;
                                    if (_e4640 > _e4644) {
                                        phi_6921_ = _e4640;
                                    } else {
                                        phi_6921_ = _e4644;
                                    }
                                    let _e4647 = phi_6921_;
                                    let _e4650 = local_4[1u].member_2[1u];
                                    if (_e4650[0] < 0f) {
                                        phi_6935_ = -(_e4650[0]);
                                    } else {
                                        phi_6935_ = _e4650[0];
                                    }
                                    let _e4657 = phi_6935_;
                                    if (_e4650[1] < 0f) {
                                        phi_6942_ = -(_e4650[1]);
                                    } else {
                                        phi_6942_ = _e4650[1];
                                    }
                                    let _e4661 = phi_6942_;
                                    if (_e4657 > _e4661) {
                                        phi_6947_ = _e4657;
                                    } else {
                                        phi_6947_ = _e4661;
                                    }
                                    let _e4664 = phi_6947_;
                                    if (_e4650[2] < 0f) {
                                        phi_6954_ = -(_e4650[2]);
                                    } else {
                                        phi_6954_ = _e4650[2];
                                    }
                                    let _e4668 = phi_6954_;
                                    if (_e4664 > _e4668) {
                                        phi_6959_ = _e4664;
                                    } else {
                                        phi_6959_ = _e4668;
                                    }
                                    let _e4671 = phi_6959_;
                                    if (_e4647 > _e4671) {
                                        phi_6964_ = _e4647;
                                    } else {
                                        phi_6964_ = _e4671;
                                    }
                                    let _e4674 = phi_6964_;
                                    let _e4676 = local_4[1u].member_3;
                                    let _e4677 = (_e4674 + _e4676);
                                    let _e4679 = ((_e4623 * 8f) * _e4677);
                                    let _e4686 = local_4[1u].member_3;
                                    if (_e4375 < 0f) {
                                        phi_6995_ = -(_e4375);
                                    } else {
                                        phi_6995_ = _e4375;
                                    }
                                    let _e4703 = phi_6995_;
                                    if (_e4378 < 0f) {
                                        phi_7001_ = -(_e4378);
                                    } else {
                                        phi_7001_ = _e4378;
                                    }
                                    let _e4707 = phi_7001_;
                                    if (_e4381 < 0f) {
                                        phi_7008_ = -(_e4381);
                                    } else {
                                        phi_7008_ = _e4381;
                                    }
                                    let _e4712 = phi_7008_;
                                    let _e4713 = ((_e4703 + _e4707) + _e4712);
                                    if (_e4396 < 0f) {
                                        phi_7015_ = -(_e4396);
                                    } else {
                                        phi_7015_ = _e4396;
                                    }
                                    let _e4717 = phi_7015_;
                                    if (_e4399 < 0f) {
                                        phi_7021_ = -(_e4399);
                                    } else {
                                        phi_7021_ = _e4399;
                                    }
                                    let _e4721 = phi_7021_;
                                    if (_e4402 < 0f) {
                                        phi_7028_ = -(_e4402);
                                    } else {
                                        phi_7028_ = _e4402;
                                    }
                                    let _e4726 = phi_7028_;
                                    let _e4727 = ((_e4717 + _e4721) + _e4726);
                                    if (_e4713 > _e4727) {
                                        phi_7034_ = _e4713;
                                    } else {
                                        phi_7034_ = _e4727;
                                    }
                                    let _e4730 = phi_7034_;
                                    if (_e4445 < 0f) {
                                        phi_7040_ = -(_e4445);
                                    } else {
                                        phi_7040_ = _e4445;
                                    }
                                    let _e4734 = phi_7040_;
                                    if (_e4446 < 0f) {
                                        phi_7046_ = -(_e4446);
                                    } else {
                                        phi_7046_ = _e4446;
                                    }
                                    let _e4738 = phi_7046_;
                                    if (_e4447 < 0f) {
                                        phi_7053_ = -(_e4447);
                                    } else {
                                        phi_7053_ = _e4447;
                                    }
                                    let _e4743 = phi_7053_;
                                    let _e4745 = (((_e4734 + _e4738) + _e4743) * 0.5f);
                                    if (_e4730 > _e4745) {
                                        phi_7060_ = _e4730;
                                    } else {
                                        phi_7060_ = _e4745;
                                    }
                                    let _e4748 = phi_7060_;
                                    let _e4753 = local_4[1u].member_3;
                                    let _e4766 = ((((_e4450[0] * _e4375) + (_e4450[1] * _e4378)) + (_e4450[2] * _e4381)) * 3f);
                                    let _e4767 = ((((_e4507[0] * _e4396) + (_e4507[1] * _e4399)) + (_e4507[2] * _e4402)) * 3f);
                                    if (_e4766 < _e4767) {
                                        phi_7084_ = _e4766;
                                    } else {
                                        phi_7084_ = _e4767;
                                    }
                                    let _e4770 = phi_7084_;
                                    if (_e4481 < _e4504) {
                                        phi_7089_ = _e4481;
                                    } else {
                                        phi_7089_ = _e4504;
                                    }
                                    let _e4773 = phi_7089_;
                                    if (_e4770 < _e4773) {
                                        phi_7094_ = _e4770;
                                    } else {
                                        phi_7094_ = _e4773;
                                    }
                                    let _e4776 = phi_7094_;
                                    if (_e4766 > _e4767) {
                                        phi_7099_ = _e4766;
                                    } else {
                                        phi_7099_ = _e4767;
                                    }
                                    let _e4779 = phi_7099_;
                                    if (_e4481 > _e4504) {
                                        phi_7104_ = _e4481;
                                    } else {
                                        phi_7104_ = _e4504;
                                    }
                                    let _e4782 = phi_7104_;
                                    if (_e4779 > _e4782) {
                                        phi_7109_ = _e4779;
                                    } else {
                                        phi_7109_ = _e4782;
                                    }
                                    let _e4785 = phi_7109_;
                                    let _e4790 = -(_e4785);
                                    if (_e4776 > _e4790) {
                                        phi_7119_ = _e4776;
                                    } else {
                                        phi_7119_ = _e4790;
                                    }
                                    let _e4793 = phi_7119_;
                                    if ((_e4793 - ((((((_e4569 * 8f) * _e4679) * (0.000000059604645f * (490f / 64f))) + ((_e4686 * 19f) * ((_e4569 * (_e4623 + _e4677)) + (_e4623 * _e4677)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4569) * ((1f + _e4623) * (1f + _e4677))))) + ((_e2080 * (((_e4748 + (_e4679 * (0.000000059604645f * 4f))) + ((_e4753 * 6f) * (_e4623 + _e4677))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4623) * (1f + _e4677))))) * (3f * 1.0001f)))) > 0f) {
                                        phi_8095_ = true;
                                    } else {
                                        let _e4798 = local_4[1u].member_1[0u];
                                        let _e4804 = local_4[1u].member_1[1u];
                                        let _e4808 = (_e4798[0] + _e4804[0]);
                                        let _e4809 = (_e4798[1] + _e4804[1]);
                                        let _e4810 = (_e4798[2] + _e4804[2]);
                                        let _e4813 = local_4[1u].member_2[0u];
                                        let _e4819 = local_4[1u].member_2[1u];
                                        let _e4823 = (_e4813[0] + _e4819[0]);
                                        let _e4824 = (_e4813[1] + _e4819[1]);
                                        let _e4825 = (_e4813[2] + _e4819[2]);
                                        let _e4828 = ((_e4809 * _e4825) - (_e4810 * _e4824));
                                        let _e4831 = ((_e4810 * _e4823) - (_e4808 * _e4825));
                                        let _e4834 = ((_e4808 * _e4824) - (_e4809 * _e4823));
                                        let _e4837 = local_4[1u].member[0u];
                                        let _e4843 = local_4[1u].member_1[0u];
                                        let _e4849 = local_4[1u].member_2[0u];
                                        let _e4861 = local_4[1u].member[1u];
                                        let _e4867 = local_4[1u].member_1[1u];
                                        let _e4873 = local_4[1u].member_2[1u];
                                        local = array<array<f32, 3>, 4>(_e4837, array<f32, 3>((_e4837[0] - _e4843[0]), (_e4837[1] - _e4843[1]), (_e4837[2] - _e4843[2])), array<f32, 3>((_e4837[0] - _e4849[0]), (_e4837[1] - _e4849[1]), (_e4837[2] - _e4849[2])), _e4837);
                                        local_1 = array<array<f32, 3>, 4>(_e4861, array<f32, 3>((_e4861[0] - _e4867[0]), (_e4861[1] - _e4867[1]), (_e4861[2] - _e4867[2])), array<f32, 3>((_e4861[0] - _e4873[0]), (_e4861[1] - _e4873[1]), (_e4861[2] - _e4873[2])), _e4861);
                                        let _e4891 = local_4[1u].member[0u];
                                        if (_e4891[0] < 0f) {
                                            phi_7370_ = -(_e4891[0]);
                                        } else {
                                            phi_7370_ = _e4891[0];
                                        }
                                        let _e4898 = phi_7370_;
                                        if (_e4891[1] < 0f) {
                                            phi_7377_ = -(_e4891[1]);
                                        } else {
                                            phi_7377_ = _e4891[1];
                                        }
                                        let _e4902 = phi_7377_;
                                        if (_e4898 > _e4902) {
                                            phi_7382_ = _e4898;
                                        } else {
                                            phi_7382_ = _e4902;
                                        }
                                        let _e4905 = phi_7382_;
                                        if (_e4891[2] < 0f) {
                                            phi_7389_ = -(_e4891[2]);
                                        } else {
                                            phi_7389_ = _e4891[2];
                                        }
                                        let _e4909 = phi_7389_;
                                        if (_e4905 > _e4909) {
                                            phi_7394_ = _e4905;
                                        } else {
                                            phi_7394_ = _e4909;
                                        }
                                        let _e4912 = phi_7394_;
                                        let _e4915 = local_4[1u].member[1u];
                                        if (_e4915[0] < 0f) {
                                            phi_7407_ = -(_e4915[0]);
                                        } else {
                                            phi_7407_ = _e4915[0];
                                        }
                                        let _e4922 = phi_7407_;
                                        if (_e4915[1] < 0f) {
                                            phi_7414_ = -(_e4915[1]);
                                        } else {
                                            phi_7414_ = _e4915[1];
                                        }
                                        let _e4926 = phi_7414_;
                                        if (_e4922 > _e4926) {
                                            phi_7419_ = _e4922;
                                        } else {
                                            phi_7419_ = _e4926;
                                        }
                                        let _e4929 = phi_7419_;
                                        if (_e4915[2] < 0f) {
                                            phi_7426_ = -(_e4915[2]);
                                        } else {
                                            phi_7426_ = _e4915[2];
                                        }
                                        let _e4933 = phi_7426_;
                                        if (_e4929 > _e4933) {
                                            phi_7431_ = _e4929;
                                        } else {
                                            phi_7431_ = _e4933;
                                        }
                                        let _e4936 = phi_7431_;
                                        if (_e4912 > _e4936) {
                                            phi_7436_ = _e4912;
                                        } else {
                                            phi_7436_ = _e4936;
                                        }
                                        let _e4939 = phi_7436_;
                                        let _e4941 = local_4[1u].member_3;
                                        let _e4945 = local_4[1u].member_1[0u];
                                        if (_e4945[0] < 0f) {
                                            phi_7453_ = -(_e4945[0]);
                                        } else {
                                            phi_7453_ = _e4945[0];
                                        }
                                        let _e4952 = phi_7453_;
                                        if (_e4945[1] < 0f) {
                                            phi_7460_ = -(_e4945[1]);
                                        } else {
                                            phi_7460_ = _e4945[1];
                                        }
                                        let _e4956 = phi_7460_;
                                        if (_e4952 > _e4956) {
                                            phi_7465_ = _e4952;
                                        } else {
                                            phi_7465_ = _e4956;
                                        }
                                        let _e4959 = phi_7465_;
                                        if (_e4945[2] < 0f) {
                                            phi_7472_ = -(_e4945[2]);
                                        } else {
                                            phi_7472_ = _e4945[2];
                                        }
                                        let _e4963 = phi_7472_;
                                        if (_e4959 > _e4963) {
                                            phi_7477_ = _e4959;
                                        } else {
                                            phi_7477_ = _e4963;
                                        }
                                        let _e4966 = phi_7477_;
                                        let _e4969 = local_4[1u].member_1[1u];
                                        if (_e4969[0] < 0f) {
                                            phi_7491_ = -(_e4969[0]);
                                        } else {
                                            phi_7491_ = _e4969[0];
                                        }
                                        let _e4976 = phi_7491_;
                                        if (_e4969[1] < 0f) {
                                            phi_7498_ = -(_e4969[1]);
                                        } else {
                                            phi_7498_ = _e4969[1];
                                        }
                                        let _e4980 = phi_7498_;
                                        if (_e4976 > _e4980) {
                                            phi_7503_ = _e4976;
                                        } else {
                                            phi_7503_ = _e4980;
                                        }
                                        let _e4983 = phi_7503_;
                                        if (_e4969[2] < 0f) {
                                            phi_7510_ = -(_e4969[2]);
                                        } else {
                                            phi_7510_ = _e4969[2];
                                        }
                                        let _e4987 = phi_7510_;
                                        if (_e4983 > _e4987) {
                                            phi_7515_ = _e4983;
                                        } else {
                                            phi_7515_ = _e4987;
                                        }
                                        let _e4990 = phi_7515_;
                                        if (_e4966 > _e4990) {
                                            phi_7520_ = _e4966;
                                        } else {
                                            phi_7520_ = _e4990;
                                        }
                                        let _e4993 = phi_7520_;
                                        let _e4995 = local_4[1u].member_3;
                                        let _e4999 = local_4[1u].member_2[0u];
                                        if (_e4999[0] < 0f) {
                                            phi_7537_ = -(_e4999[0]);
                                        } else {
                                            phi_7537_ = _e4999[0];
                                        }
                                        let _e5006 = phi_7537_;
                                        if (_e4999[1] < 0f) {
                                            phi_7544_ = -(_e4999[1]);
                                        } else {
                                            phi_7544_ = _e4999[1];
                                        }
                                        let _e5010 = phi_7544_;
                                        if (_e5006 > _e5010) {
                                            phi_7549_ = _e5006;
                                        } else {
                                            phi_7549_ = _e5010;
                                        }
                                        let _e5013 = phi_7549_;
                                        if (_e4999[2] < 0f) {
                                            phi_7556_ = -(_e4999[2]);
                                        } else {
                                            phi_7556_ = _e4999[2];
                                        }
                                        let _e5017 = phi_7556_;
                                        if (_e5013 > _e5017) {
                                            phi_7561_ = _e5013;
                                        } else {
                                            phi_7561_ = _e5017;
                                        }
                                        let _e5020 = phi_7561_;
                                        let _e5023 = local_4[1u].member_2[1u];
                                        if (_e5023[0] < 0f) {
                                            phi_7575_ = -(_e5023[0]);
                                        } else {
                                            phi_7575_ = _e5023[0];
                                        }
                                        let _e5030 = phi_7575_;
                                        if (_e5023[1] < 0f) {
                                            phi_7582_ = -(_e5023[1]);
                                        } else {
                                            phi_7582_ = _e5023[1];
                                        }
                                        let _e5034 = phi_7582_;
                                        if (_e5030 > _e5034) {
                                            phi_7587_ = _e5030;
                                        } else {
                                            phi_7587_ = _e5034;
                                        }
                                        let _e5037 = phi_7587_;
                                        if (_e5023[2] < 0f) {
                                            phi_7594_ = -(_e5023[2]);
                                        } else {
                                            phi_7594_ = _e5023[2];
                                        }
                                        let _e5041 = phi_7594_;
                                        if (_e5037 > _e5041) {
                                            phi_7599_ = _e5037;
                                        } else {
                                            phi_7599_ = _e5041;
                                        }
                                        let _e5044 = phi_7599_;
                                        if (_e5020 > _e5044) {
                                            phi_7604_ = _e5020;
                                        } else {
                                            phi_7604_ = _e5044;
                                        }
                                        let _e5047 = phi_7604_;
                                        let _e5049 = local_4[1u].member_3;
                                        let _e5052 = (((_e4939 + _e4941) + (_e4993 + _e4995)) + (_e5047 + _e5049));
                                        let _e5055 = local_4[1u].member_3;
                                        let _e5059 = (((_e2080 * 1.0001f) + (_e5055 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e5062 = ((_e4831 * _e4810) - (_e4834 * _e4809));
                                        let _e5065 = ((_e4834 * _e4808) - (_e4828 * _e4810));
                                        let _e5068 = ((_e4828 * _e4809) - (_e4831 * _e4808));
                                        let _e5070 = local[0u];
                                        let _e5078 = (((_e5062 * _e5070[0]) + (_e5065 * _e5070[1])) + (_e5068 * _e5070[2]));
                                        phi_7642_ = type_36(0u, 4u);
                                        phi_7645_ = _e5078;
                                        phi_7647_ = _e5078;
                                        loop {
                                            let _e5080 = phi_7642_;
                                            let _e5082 = phi_7645_;
                                            let _e5084 = phi_7647_;
                                            local_64 = _e5082;
                                            local_65 = _e5084;
                                            local_79 = _e5084;
                                            if (_e5080.member < _e5080.member_1) {
                                                phi_7643_ = type_36((_e5080.member + 1u), _e5080.member_1);
                                                phi_7670_ = type_36(1u, _e5080.member);
                                            } else {
                                                phi_7643_ = _e5080;
                                                phi_7670_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e5098 = phi_7643_;
                                            let _e5100 = phi_7670_;
                                            let _e5104 = (bitcast<i32>(_e5100.member) != 0i);
                                            if _e5104 {
                                                if (_e5100.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e5107 = local[_e5100.member_1];
                                                let _e5115 = (((_e5062 * _e5107[0]) + (_e5065 * _e5107[1])) + (_e5068 * _e5107[2]));
                                                if (_e5100.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e5118 = local_1[_e5100.member_1];
                                                let _e5126 = (((_e5062 * _e5118[0]) + (_e5065 * _e5118[1])) + (_e5068 * _e5118[2]));
                                                if (_e5084 < _e5115) {
                                                    phi_7720_ = _e5084;
                                                } else {
                                                    phi_7720_ = _e5115;
                                                }
                                                let _e5129 = phi_7720_;
                                                if (_e5129 < _e5126) {
                                                    phi_7725_ = _e5129;
                                                } else {
                                                    phi_7725_ = _e5126;
                                                }
                                                let _e5132 = phi_7725_;
                                                if (_e5082 > _e5115) {
                                                    phi_7730_ = _e5082;
                                                } else {
                                                    phi_7730_ = _e5115;
                                                }
                                                let _e5135 = phi_7730_;
                                                if (_e5135 > _e5126) {
                                                    phi_7735_ = _e5135;
                                                } else {
                                                    phi_7735_ = _e5126;
                                                }
                                                let _e5138 = phi_7735_;
                                                phi_7646_ = _e5138;
                                                phi_7648_ = _e5132;
                                            } else {
                                                phi_7646_ = f32();
                                                phi_7648_ = f32();
                                            }
                                            let _e5140 = phi_7646_;
                                            let _e5142 = phi_7648_;
                                            continue;
                                            continuing {
                                                phi_7642_ = _e5098;
                                                phi_7645_ = _e5140;
                                                phi_7647_ = _e5142;
                                                break if !(_e5104);
                                            }
                                        }
                                        if (_e5062 < 0f) {
                                            phi_7741_ = -(_e5062);
                                        } else {
                                            phi_7741_ = _e5062;
                                        }
                                        let _e5147 = phi_7741_;
                                        if (_e5065 < 0f) {
                                            phi_7747_ = -(_e5065);
                                        } else {
                                            phi_7747_ = _e5065;
                                        }
                                        let _e5151 = phi_7747_;
                                        if (_e5068 < 0f) {
                                            phi_7754_ = -(_e5068);
                                        } else {
                                            phi_7754_ = _e5068;
                                        }
                                        let _e5156 = phi_7754_;
                                        let _e5157 = ((_e5147 + _e5151) + _e5156);
                                        let _e5162 = local_64;
                                        let _e5163 = -(_e5162);
                                        let _e5165 = local_65;
                                        if (_e5165 > _e5163) {
                                            let _e6112 = local_79;
                                            phi_7764_ = _e6112;
                                        } else {
                                            phi_7764_ = _e5163;
                                        }
                                        let _e5168 = phi_7764_;
                                        let _e5173 = (((_e5168 - ((_e5157 * _e5052) * (0.000000059604645f * 17f))) - (_e5157 * _e5059)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e5176 = ((_e4831 * _e4825) - (_e4834 * _e4824));
                                        let _e5179 = ((_e4834 * _e4823) - (_e4828 * _e4825));
                                        let _e5182 = ((_e4828 * _e4824) - (_e4831 * _e4823));
                                        let _e5184 = local[0u];
                                        let _e5192 = (((_e5176 * _e5184[0]) + (_e5179 * _e5184[1])) + (_e5182 * _e5184[2]));
                                        phi_7795_ = type_36(0u, 4u);
                                        phi_7798_ = _e5192;
                                        phi_7800_ = _e5192;
                                        loop {
                                            let _e5194 = phi_7795_;
                                            let _e5196 = phi_7798_;
                                            let _e5198 = phi_7800_;
                                            local_66 = _e5196;
                                            local_67 = _e5198;
                                            local_80 = _e5198;
                                            if (_e5194.member < _e5194.member_1) {
                                                phi_7796_ = type_36((_e5194.member + 1u), _e5194.member_1);
                                                phi_7823_ = type_36(1u, _e5194.member);
                                            } else {
                                                phi_7796_ = _e5194;
                                                phi_7823_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e5212 = phi_7796_;
                                            let _e5214 = phi_7823_;
                                            let _e5218 = (bitcast<i32>(_e5214.member) != 0i);
                                            if _e5218 {
                                                if (_e5214.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e5221 = local[_e5214.member_1];
                                                let _e5229 = (((_e5176 * _e5221[0]) + (_e5179 * _e5221[1])) + (_e5182 * _e5221[2]));
                                                if (_e5214.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e5232 = local_1[_e5214.member_1];
                                                let _e5240 = (((_e5176 * _e5232[0]) + (_e5179 * _e5232[1])) + (_e5182 * _e5232[2]));
                                                if (_e5198 < _e5229) {
                                                    phi_7873_ = _e5198;
                                                } else {
                                                    phi_7873_ = _e5229;
                                                }
                                                let _e5243 = phi_7873_;
                                                if (_e5243 < _e5240) {
                                                    phi_7878_ = _e5243;
                                                } else {
                                                    phi_7878_ = _e5240;
                                                }
                                                let _e5246 = phi_7878_;
                                                if (_e5196 > _e5229) {
                                                    phi_7883_ = _e5196;
                                                } else {
                                                    phi_7883_ = _e5229;
                                                }
                                                let _e5249 = phi_7883_;
                                                if (_e5249 > _e5240) {
                                                    phi_7888_ = _e5249;
                                                } else {
                                                    phi_7888_ = _e5240;
                                                }
                                                let _e5252 = phi_7888_;
                                                phi_7799_ = _e5252;
                                                phi_7801_ = _e5246;
                                            } else {
                                                phi_7799_ = f32();
                                                phi_7801_ = f32();
                                            }
                                            let _e5254 = phi_7799_;
                                            let _e5256 = phi_7801_;
                                            continue;
                                            continuing {
                                                phi_7795_ = _e5212;
                                                phi_7798_ = _e5254;
                                                phi_7800_ = _e5256;
                                                break if !(_e5218);
                                            }
                                        }
                                        if (_e5176 < 0f) {
                                            phi_7894_ = -(_e5176);
                                        } else {
                                            phi_7894_ = _e5176;
                                        }
                                        let _e5261 = phi_7894_;
                                        if (_e5179 < 0f) {
                                            phi_7900_ = -(_e5179);
                                        } else {
                                            phi_7900_ = _e5179;
                                        }
                                        let _e5265 = phi_7900_;
                                        if (_e5182 < 0f) {
                                            phi_7907_ = -(_e5182);
                                        } else {
                                            phi_7907_ = _e5182;
                                        }
                                        let _e5270 = phi_7907_;
                                        let _e5271 = ((_e5261 + _e5265) + _e5270);
                                        let _e5276 = local_66;
                                        let _e5277 = -(_e5276);
                                        let _e5279 = local_67;
                                        if (_e5279 > _e5277) {
                                            let _e6131 = local_80;
                                            phi_7917_ = _e6131;
                                        } else {
                                            phi_7917_ = _e5277;
                                        }
                                        let _e5282 = phi_7917_;
                                        let _e5287 = (((_e5282 - ((_e5271 * _e5052) * (0.000000059604645f * 17f))) - (_e5271 * _e5059)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e5173 > _e5287) {
                                            phi_7927_ = _e5173;
                                        } else {
                                            phi_7927_ = _e5287;
                                        }
                                        let _e5290 = phi_7927_;
                                        let _e5291 = (_e4823 - _e4808);
                                        let _e5292 = (_e4824 - _e4809);
                                        let _e5293 = (_e4825 - _e4810);
                                        let _e5296 = ((_e4831 * _e5293) - (_e4834 * _e5292));
                                        let _e5299 = ((_e4834 * _e5291) - (_e4828 * _e5293));
                                        let _e5302 = ((_e4828 * _e5292) - (_e4831 * _e5291));
                                        let _e5304 = local[0u];
                                        let _e5312 = (((_e5296 * _e5304[0]) + (_e5299 * _e5304[1])) + (_e5302 * _e5304[2]));
                                        phi_7960_ = type_36(0u, 4u);
                                        phi_7963_ = _e5312;
                                        phi_7965_ = _e5312;
                                        loop {
                                            let _e5314 = phi_7960_;
                                            let _e5316 = phi_7963_;
                                            let _e5318 = phi_7965_;
                                            local_68 = _e5316;
                                            local_69 = _e5318;
                                            local_81 = _e5318;
                                            if (_e5314.member < _e5314.member_1) {
                                                phi_7961_ = type_36((_e5314.member + 1u), _e5314.member_1);
                                                phi_7988_ = type_36(1u, _e5314.member);
                                            } else {
                                                phi_7961_ = _e5314;
                                                phi_7988_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e5332 = phi_7961_;
                                            let _e5334 = phi_7988_;
                                            let _e5338 = (bitcast<i32>(_e5334.member) != 0i);
                                            if _e5338 {
                                                if (_e5334.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e5341 = local[_e5334.member_1];
                                                let _e5349 = (((_e5296 * _e5341[0]) + (_e5299 * _e5341[1])) + (_e5302 * _e5341[2]));
                                                if (_e5334.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e5352 = local_1[_e5334.member_1];
                                                let _e5360 = (((_e5296 * _e5352[0]) + (_e5299 * _e5352[1])) + (_e5302 * _e5352[2]));
                                                if (_e5318 < _e5349) {
                                                    phi_8038_ = _e5318;
                                                } else {
                                                    phi_8038_ = _e5349;
                                                }
                                                let _e5363 = phi_8038_;
                                                if (_e5363 < _e5360) {
                                                    phi_8043_ = _e5363;
                                                } else {
                                                    phi_8043_ = _e5360;
                                                }
                                                let _e5366 = phi_8043_;
                                                if (_e5316 > _e5349) {
                                                    phi_8048_ = _e5316;
                                                } else {
                                                    phi_8048_ = _e5349;
                                                }
                                                let _e5369 = phi_8048_;
                                                if (_e5369 > _e5360) {
                                                    phi_8053_ = _e5369;
                                                } else {
                                                    phi_8053_ = _e5360;
                                                }
                                                let _e5372 = phi_8053_;
                                                phi_7964_ = _e5372;
                                                phi_7966_ = _e5366;
                                            } else {
                                                phi_7964_ = f32();
                                                phi_7966_ = f32();
                                            }
                                            let _e5374 = phi_7964_;
                                            let _e5376 = phi_7966_;
                                            continue;
                                            continuing {
                                                phi_7960_ = _e5332;
                                                phi_7963_ = _e5374;
                                                phi_7965_ = _e5376;
                                                break if !(_e5338);
                                            }
                                        }
                                        if (_e5296 < 0f) {
                                            phi_8059_ = -(_e5296);
                                        } else {
                                            phi_8059_ = _e5296;
                                        }
                                        let _e5381 = phi_8059_;
                                        if (_e5299 < 0f) {
                                            phi_8065_ = -(_e5299);
                                        } else {
                                            phi_8065_ = _e5299;
                                        }
                                        let _e5385 = phi_8065_;
                                        if (_e5302 < 0f) {
                                            phi_8072_ = -(_e5302);
                                        } else {
                                            phi_8072_ = _e5302;
                                        }
                                        let _e5390 = phi_8072_;
                                        let _e5391 = ((_e5381 + _e5385) + _e5390);
                                        let _e5396 = local_68;
                                        let _e5397 = -(_e5396);
                                        let _e5399 = local_69;
                                        if (_e5399 > _e5397) {
                                            let _e6151 = local_81;
                                            phi_8082_ = _e6151;
                                        } else {
                                            phi_8082_ = _e5397;
                                        }
                                        let _e5402 = phi_8082_;
                                        let _e5407 = (((_e5402 - ((_e5391 * _e5052) * (0.000000059604645f * 17f))) - (_e5391 * _e5059)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e5290 > _e5407) {
                                            phi_8092_ = _e5290;
                                        } else {
                                            phi_8092_ = _e5407;
                                        }
                                        let _e5410 = phi_8092_;
                                        phi_8095_ = (_e5410 > 0f);
                                    }
                                    let _e5413 = phi_8095_;
                                    phi_8096_ = _e5413;
                                } else {
                                    phi_8096_ = false;
                                }
                                let _e5415 = phi_8096_;
                                phi_8098_ = !(_e5415);
                            }
                            let _e5418 = phi_8098_;
                            if _e5418 {
                                let _e5420 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1324] = ((2147483648u | (_e5420 << bitcast<u32>(12i))) | _e1327);
                            }
                        }
                        phi_8108_ = true;
                    }
                    let _e5427 = phi_8108_;
                    phi_8109_ = _e5427;
                } else {
                    phi_8109_ = false;
                }
                let _e5429 = phi_8109_;
                continue;
                continuing {
                    phi_1882_ = _e1316;
                    break if !(_e5429);
                }
            }
            workgroupBarrier();
            if (_e110 == 0u) {
                let _e5433 = atomicLoad((&counters[5u]));
                if (_e5433 > 0u) {
                    let _e5436 = atomicAdd((&output.member[0u]), _e5433);
                    atomicStore((&counters[6u]), _e5436);
                }
            }
            workgroupBarrier();
            let _e5439 = atomicLoad((&counters[6u]));
            if (_e110 == 0u) {
                let _e5442 = atomicLoad((&counters[7u]));
                if (_e5442 > 0u) {
                    let _e5445 = atomicAdd((&output.member[1u]), _e5442);
                }
            }
            phi_8141_ = type_36(0u, 16u);
            loop {
                let _e5447 = phi_8141_;
                if (_e5447.member < _e5447.member_1) {
                    phi_8142_ = type_36((_e5447.member + 1u), _e5447.member_1);
                    phi_8165_ = type_36(1u, _e5447.member);
                } else {
                    phi_8142_ = _e5447;
                    phi_8165_ = type_36(0u, type_36().member_1);
                }
                let _e5461 = phi_8142_;
                let _e5463 = phi_8165_;
                if (bitcast<i32>(_e5463.member) != 0i) {
                    let _e5469 = (_e110 + (_e5463.member_1 * 128u));
                    if (_e5469 >= _e1300) {
                        phi_8263_ = false;
                    } else {
                        let _e5472 = hits[_e5469];
                        if ((_e5472 & 2147483648u) == 0u) {
                            phi_8188_ = 4294967295u;
                        } else {
                            phi_8188_ = ((_e5472 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e5479 = phi_8188_;
                        if (_e5479 != 4294967295u) {
                            let _e5483 = ((_e5472 >> bitcast<u32>(10i)) & 3u);
                            let _e5490 = firsts[(2u * _e5483)];
                            let _e5493 = leaves.member[(_e5490 + ((_e5472 >> bitcast<u32>(5i)) & 31u))];
                            let _e5497 = firsts[((2u * _e5483) + 1u)];
                            let _e5500 = leaves.member[(_e5497 + (_e5472 & 31u))];
                            let _e5504 = params.member.member_16;
                            let _e5505 = (_e5439 + _e5479);
                            if (_e5505 < _e5504) {
                                atomicStore((&output.member[(4u + (2u * _e5505))]), _e5493.member_1);
                                atomicStore((&output.member[((2u * _e5505) + 5u)]), _e5500.member_1);
                            }
                        }
                        phi_8263_ = true;
                    }
                    let _e5514 = phi_8263_;
                    phi_8264_ = _e5514;
                } else {
                    phi_8264_ = false;
                }
                let _e5516 = phi_8264_;
                continue;
                continuing {
                    phi_8141_ = _e5461;
                    break if !(_e5516);
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
