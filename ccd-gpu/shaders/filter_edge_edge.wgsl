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
    var phi_2945_: type_24;
    var phi_2946_: type_24;
    var phi_3335_: f32;
    var phi_3342_: f32;
    var phi_3347_: f32;
    var phi_3354_: f32;
    var phi_3359_: f32;
    var phi_3372_: f32;
    var phi_3379_: f32;
    var phi_3384_: f32;
    var phi_3391_: f32;
    var phi_3396_: f32;
    var phi_3401_: f32;
    var phi_3418_: f32;
    var phi_3425_: f32;
    var phi_3430_: f32;
    var phi_3437_: f32;
    var phi_3442_: f32;
    var phi_3456_: f32;
    var phi_3463_: f32;
    var phi_3468_: f32;
    var phi_3475_: f32;
    var phi_3480_: f32;
    var phi_3485_: f32;
    var phi_3502_: f32;
    var phi_3509_: f32;
    var phi_3514_: f32;
    var phi_3521_: f32;
    var phi_3526_: f32;
    var phi_3540_: f32;
    var phi_3547_: f32;
    var phi_3552_: f32;
    var phi_3559_: f32;
    var phi_3564_: f32;
    var phi_3569_: f32;
    var phi_3600_: f32;
    var phi_3606_: f32;
    var phi_3613_: f32;
    var phi_3620_: f32;
    var phi_3626_: f32;
    var phi_3633_: f32;
    var phi_3639_: f32;
    var phi_3645_: f32;
    var phi_3651_: f32;
    var phi_3658_: f32;
    var phi_3665_: f32;
    var phi_3689_: f32;
    var phi_3694_: f32;
    var phi_3699_: f32;
    var phi_3704_: f32;
    var phi_3709_: f32;
    var phi_3714_: f32;
    var phi_3724_: f32;
    var phi_3975_: f32;
    var phi_3982_: f32;
    var phi_3987_: f32;
    var phi_3994_: f32;
    var phi_3999_: f32;
    var phi_4012_: f32;
    var phi_4019_: f32;
    var phi_4024_: f32;
    var phi_4031_: f32;
    var phi_4036_: f32;
    var phi_4041_: f32;
    var phi_4058_: f32;
    var phi_4065_: f32;
    var phi_4070_: f32;
    var phi_4077_: f32;
    var phi_4082_: f32;
    var phi_4096_: f32;
    var phi_4103_: f32;
    var phi_4108_: f32;
    var phi_4115_: f32;
    var phi_4120_: f32;
    var phi_4125_: f32;
    var phi_4142_: f32;
    var phi_4149_: f32;
    var phi_4154_: f32;
    var phi_4161_: f32;
    var phi_4166_: f32;
    var phi_4180_: f32;
    var phi_4187_: f32;
    var phi_4192_: f32;
    var phi_4199_: f32;
    var phi_4204_: f32;
    var phi_4209_: f32;
    var phi_4247_: type_36;
    var phi_4250_: f32;
    var phi_4252_: f32;
    var phi_4248_: type_36;
    var phi_4275_: type_36;
    var phi_4325_: f32;
    var phi_4330_: f32;
    var phi_4335_: f32;
    var phi_4340_: f32;
    var phi_4251_: f32;
    var phi_4253_: f32;
    var phi_4346_: f32;
    var phi_4352_: f32;
    var phi_4359_: f32;
    var local_52: f32;
    var local_53: f32;
    var phi_4369_: f32;
    var phi_4400_: type_36;
    var phi_4403_: f32;
    var phi_4405_: f32;
    var phi_4401_: type_36;
    var phi_4428_: type_36;
    var phi_4478_: f32;
    var phi_4483_: f32;
    var phi_4488_: f32;
    var phi_4493_: f32;
    var phi_4404_: f32;
    var phi_4406_: f32;
    var phi_4499_: f32;
    var phi_4505_: f32;
    var phi_4512_: f32;
    var local_54: f32;
    var local_55: f32;
    var phi_4522_: f32;
    var phi_4532_: f32;
    var phi_4700_: bool;
    var phi_5157_: f32;
    var phi_5164_: f32;
    var phi_5169_: f32;
    var phi_5176_: f32;
    var phi_5181_: f32;
    var phi_5194_: f32;
    var phi_5201_: f32;
    var phi_5206_: f32;
    var phi_5213_: f32;
    var phi_5218_: f32;
    var phi_5223_: f32;
    var phi_5240_: f32;
    var phi_5247_: f32;
    var phi_5252_: f32;
    var phi_5259_: f32;
    var phi_5264_: f32;
    var phi_5278_: f32;
    var phi_5285_: f32;
    var phi_5290_: f32;
    var phi_5297_: f32;
    var phi_5302_: f32;
    var phi_5307_: f32;
    var phi_5324_: f32;
    var phi_5331_: f32;
    var phi_5336_: f32;
    var phi_5343_: f32;
    var phi_5348_: f32;
    var phi_5362_: f32;
    var phi_5369_: f32;
    var phi_5374_: f32;
    var phi_5381_: f32;
    var phi_5386_: f32;
    var phi_5391_: f32;
    var phi_5422_: f32;
    var phi_5428_: f32;
    var phi_5435_: f32;
    var phi_5442_: f32;
    var phi_5448_: f32;
    var phi_5455_: f32;
    var phi_5461_: f32;
    var phi_5467_: f32;
    var phi_5473_: f32;
    var phi_5480_: f32;
    var phi_5487_: f32;
    var phi_5511_: f32;
    var phi_5516_: f32;
    var phi_5521_: f32;
    var phi_5526_: f32;
    var phi_5531_: f32;
    var phi_5536_: f32;
    var phi_5546_: f32;
    var phi_5797_: f32;
    var phi_5804_: f32;
    var phi_5809_: f32;
    var phi_5816_: f32;
    var phi_5821_: f32;
    var phi_5834_: f32;
    var phi_5841_: f32;
    var phi_5846_: f32;
    var phi_5853_: f32;
    var phi_5858_: f32;
    var phi_5863_: f32;
    var phi_5880_: f32;
    var phi_5887_: f32;
    var phi_5892_: f32;
    var phi_5899_: f32;
    var phi_5904_: f32;
    var phi_5918_: f32;
    var phi_5925_: f32;
    var phi_5930_: f32;
    var phi_5937_: f32;
    var phi_5942_: f32;
    var phi_5947_: f32;
    var phi_5964_: f32;
    var phi_5971_: f32;
    var phi_5976_: f32;
    var phi_5983_: f32;
    var phi_5988_: f32;
    var phi_6002_: f32;
    var phi_6009_: f32;
    var phi_6014_: f32;
    var phi_6021_: f32;
    var phi_6026_: f32;
    var phi_6031_: f32;
    var phi_6069_: type_36;
    var phi_6072_: f32;
    var phi_6074_: f32;
    var phi_6070_: type_36;
    var phi_6097_: type_36;
    var phi_6147_: f32;
    var phi_6152_: f32;
    var phi_6157_: f32;
    var phi_6162_: f32;
    var phi_6073_: f32;
    var phi_6075_: f32;
    var phi_6168_: f32;
    var phi_6174_: f32;
    var phi_6181_: f32;
    var local_56: f32;
    var local_57: f32;
    var phi_6191_: f32;
    var phi_6222_: type_36;
    var phi_6225_: f32;
    var phi_6227_: f32;
    var phi_6223_: type_36;
    var phi_6250_: type_36;
    var phi_6300_: f32;
    var phi_6305_: f32;
    var phi_6310_: f32;
    var phi_6315_: f32;
    var phi_6226_: f32;
    var phi_6228_: f32;
    var phi_6321_: f32;
    var phi_6327_: f32;
    var phi_6334_: f32;
    var local_58: f32;
    var local_59: f32;
    var phi_6344_: f32;
    var phi_6354_: f32;
    var phi_6522_: bool;
    var phi_6768_: f32;
    var phi_6775_: f32;
    var phi_6780_: f32;
    var phi_6787_: f32;
    var phi_6792_: f32;
    var phi_6805_: f32;
    var phi_6812_: f32;
    var phi_6817_: f32;
    var phi_6824_: f32;
    var phi_6829_: f32;
    var phi_6834_: f32;
    var phi_6851_: f32;
    var phi_6858_: f32;
    var phi_6863_: f32;
    var phi_6870_: f32;
    var phi_6875_: f32;
    var phi_6889_: f32;
    var phi_6896_: f32;
    var phi_6901_: f32;
    var phi_6908_: f32;
    var phi_6913_: f32;
    var phi_6918_: f32;
    var phi_6935_: f32;
    var phi_6942_: f32;
    var phi_6947_: f32;
    var phi_6954_: f32;
    var phi_6959_: f32;
    var phi_6973_: f32;
    var phi_6980_: f32;
    var phi_6985_: f32;
    var phi_6992_: f32;
    var phi_6997_: f32;
    var phi_7002_: f32;
    var phi_7033_: f32;
    var phi_7039_: f32;
    var phi_7046_: f32;
    var phi_7053_: f32;
    var phi_7059_: f32;
    var phi_7066_: f32;
    var phi_7072_: f32;
    var phi_7078_: f32;
    var phi_7084_: f32;
    var phi_7091_: f32;
    var phi_7098_: f32;
    var phi_7122_: f32;
    var phi_7127_: f32;
    var phi_7132_: f32;
    var phi_7137_: f32;
    var phi_7142_: f32;
    var phi_7147_: f32;
    var phi_7157_: f32;
    var phi_7408_: f32;
    var phi_7415_: f32;
    var phi_7420_: f32;
    var phi_7427_: f32;
    var phi_7432_: f32;
    var phi_7445_: f32;
    var phi_7452_: f32;
    var phi_7457_: f32;
    var phi_7464_: f32;
    var phi_7469_: f32;
    var phi_7474_: f32;
    var phi_7491_: f32;
    var phi_7498_: f32;
    var phi_7503_: f32;
    var phi_7510_: f32;
    var phi_7515_: f32;
    var phi_7529_: f32;
    var phi_7536_: f32;
    var phi_7541_: f32;
    var phi_7548_: f32;
    var phi_7553_: f32;
    var phi_7558_: f32;
    var phi_7575_: f32;
    var phi_7582_: f32;
    var phi_7587_: f32;
    var phi_7594_: f32;
    var phi_7599_: f32;
    var phi_7613_: f32;
    var phi_7620_: f32;
    var phi_7625_: f32;
    var phi_7632_: f32;
    var phi_7637_: f32;
    var phi_7642_: f32;
    var phi_7680_: type_36;
    var phi_7683_: f32;
    var phi_7685_: f32;
    var phi_7681_: type_36;
    var phi_7708_: type_36;
    var phi_7758_: f32;
    var phi_7763_: f32;
    var phi_7768_: f32;
    var phi_7773_: f32;
    var phi_7684_: f32;
    var phi_7686_: f32;
    var phi_7779_: f32;
    var phi_7785_: f32;
    var phi_7792_: f32;
    var local_60: f32;
    var local_61: f32;
    var phi_7802_: f32;
    var phi_7833_: type_36;
    var phi_7836_: f32;
    var phi_7838_: f32;
    var phi_7834_: type_36;
    var phi_7861_: type_36;
    var phi_7911_: f32;
    var phi_7916_: f32;
    var phi_7921_: f32;
    var phi_7926_: f32;
    var phi_7837_: f32;
    var phi_7839_: f32;
    var phi_7932_: f32;
    var phi_7938_: f32;
    var phi_7945_: f32;
    var local_62: f32;
    var local_63: f32;
    var phi_7955_: f32;
    var phi_7965_: f32;
    var phi_8133_: bool;
    var phi_8134_: bool;
    var phi_8136_: bool;
    var phi_8146_: bool;
    var phi_8147_: bool;
    var phi_8179_: type_36;
    var phi_8180_: type_36;
    var phi_8203_: type_36;
    var phi_8226_: u32;
    var phi_8280_: type_36;
    var phi_8301_: bool;
    var phi_8302_: bool;
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
            let _e5247 = local_64;
            phi_815_ = _e5247;
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
                        phi_1870_ = u32();
                        phi_1871_ = false;
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
                                        let _e5323 = local_65;
                                        phi_1809_ = _e5323;
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
                            if (_e1296 < _e1283) {
                                atomicStore((&output.member[(4u + (2u * _e1296))]), _e1292.member);
                                atomicStore((&output.member[((2u * _e1296) + 5u)]), _e1292.member_1);
                            }
                            let _e1305 = atomicAdd((&output.member[1u]), 1u);
                        }
                        phi_1870_ = (_e519 & (_e519 - 1u));
                        phi_1871_ = true;
                    }
                    let _e1307 = phi_1870_;
                    let _e1309 = phi_1871_;
                    phi_816_ = _e1307;
                    phi_1872_ = _e1309;
                } else {
                    phi_816_ = u32();
                    phi_1872_ = false;
                }
                let _e1311 = phi_816_;
                let _e1313 = phi_1872_;
                continue;
                continuing {
                    phi_812_ = _e533;
                    phi_815_ = _e1311;
                    break if !(_e1313);
                }
            }
            workgroupBarrier();
            let _e1316 = atomicLoad((&counters[4u]));
            if (2048u < _e1316) {
                phi_1879_ = 2048u;
            } else {
                phi_1879_ = _e1316;
            }
            let _e1319 = phi_1879_;
            phi_1882_ = type_36(0u, 16u);
            loop {
                let _e1321 = phi_1882_;
                if (_e1321.member < _e1321.member_1) {
                    phi_1883_ = type_36((_e1321.member + 1u), _e1321.member_1);
                    phi_1906_ = type_36(1u, _e1321.member);
                } else {
                    phi_1883_ = _e1321;
                    phi_1906_ = type_36(0u, type_36().member_1);
                }
                let _e1335 = phi_1883_;
                let _e1337 = phi_1906_;
                if (bitcast<i32>(_e1337.member) != 0i) {
                    let _e1343 = (_e110 + (_e1337.member_1 * 128u));
                    if (_e1343 >= _e1319) {
                        phi_8146_ = false;
                    } else {
                        let _e1346 = hits[_e1343];
                        let _e1349 = ((_e1346 >> bitcast<u32>(10i)) & 3u);
                        let _e1356 = firsts[(2u * _e1349)];
                        let _e1357 = (_e1356 + ((_e1346 >> bitcast<u32>(5i)) & 31u));
                        let _e1361 = firsts[((2u * _e1349) + 1u)];
                        let _e1362 = (_e1361 + (_e1346 & 31u));
                        let _e1364 = leaves.member[_e1357];
                        let _e1366 = leaves.member[_e1362];
                        local_26 = type_24(array<u32, 3>(_e1364.member[0], _e1364.member[1], _e1364.member[2]), _e1364.member_1);
                        local_27 = type_24(array<u32, 3>(_e1366.member[0], _e1366.member[1], _e1366.member[2]), _e1366.member_1);
                        let _e1382 = nodes.member[_e1357];
                        let _e1384 = nodes.member[_e1362];
                        let _e1386 = params.member.member_1;
                        if ((_e1386 & 1u) != 0u) {
                            let _e1390 = params.member.member_8;
                            if (_e1390 == 0u) {
                                let _e1434 = local_26.member[0u];
                                let _e1437 = local_27.member[0u];
                                if (_e1434 == _e1437) {
                                    phi_2025_ = bool();
                                    phi_2026_ = true;
                                } else {
                                    let _e1441 = local_26.member[0u];
                                    let _e1444 = local_27.member[1u];
                                    let _e1445 = (_e1441 == _e1444);
                                    if _e1445 {
                                        phi_2024_ = bool();
                                    } else {
                                        let _e1448 = local_26.member[0u];
                                        let _e1451 = local_27.member[2u];
                                        phi_2024_ = (_e1448 == _e1451);
                                    }
                                    let _e1454 = phi_2024_;
                                    phi_2025_ = _e1454;
                                    phi_2026_ = _e1445;
                                }
                                let _e1456 = phi_2025_;
                                let _e1458 = phi_2026_;
                                if _e1458 {
                                    phi_2030_ = true;
                                } else {
                                    phi_2030_ = _e1456;
                                }
                                let _e1460 = phi_2030_;
                                phi_2069_ = _e1460;
                            } else {
                                let _e1394 = local_26.member[0u];
                                let _e1397 = local_27.member[0u];
                                if (_e1394 == _e1397) {
                                    phi_2063_ = bool();
                                    phi_2064_ = true;
                                } else {
                                    let _e1401 = local_26.member[0u];
                                    let _e1404 = local_27.member[1u];
                                    if (_e1401 == _e1404) {
                                        phi_2061_ = bool();
                                        phi_2062_ = true;
                                    } else {
                                        let _e1408 = local_26.member[1u];
                                        let _e1411 = local_27.member[0u];
                                        let _e1412 = (_e1408 == _e1411);
                                        if _e1412 {
                                            phi_2060_ = bool();
                                        } else {
                                            let _e1415 = local_26.member[1u];
                                            let _e1418 = local_27.member[1u];
                                            phi_2060_ = (_e1415 == _e1418);
                                        }
                                        let _e1421 = phi_2060_;
                                        phi_2061_ = _e1421;
                                        phi_2062_ = _e1412;
                                    }
                                    let _e1423 = phi_2061_;
                                    let _e1425 = phi_2062_;
                                    phi_2063_ = _e1423;
                                    phi_2064_ = _e1425;
                                }
                                let _e1427 = phi_2063_;
                                let _e1429 = phi_2064_;
                                if _e1429 {
                                    phi_2068_ = true;
                                } else {
                                    phi_2068_ = _e1427;
                                }
                                let _e1431 = phi_2068_;
                                phi_2069_ = _e1431;
                            }
                            let _e1462 = phi_2069_;
                            if _e1462 {
                                phi_2073_ = false;
                            } else {
                                phi_2073_ = true;
                            }
                            let _e1464 = phi_2073_;
                            phi_2074_ = _e1464;
                        } else {
                            phi_2074_ = true;
                        }
                        let _e1466 = phi_2074_;
                        if _e1466 {
                            let _e1468 = params.member.member_1;
                            if ((_e1468 & 2u) != 0u) {
                                let _e1473 = local_26.member[0u];
                                let _e1475 = bodies.member[_e1473];
                                let _e1478 = local_27.member[0u];
                                let _e1480 = bodies.member[_e1478];
                                if ((_e1475 / 2u) == (_e1480 / 2u)) {
                                    let _e1485 = params.member.member_1;
                                    phi_2120_ = !(((_e1485 & 4u) != 0u));
                                } else {
                                    phi_2120_ = false;
                                }
                                let _e1490 = phi_2120_;
                                if _e1490 {
                                    phi_2131_ = true;
                                } else {
                                    if (((_e1475 & _e1480) & 1u) == 0u) {
                                        phi_2130_ = false;
                                    } else {
                                        phi_2130_ = true;
                                    }
                                    let _e1495 = phi_2130_;
                                    phi_2131_ = _e1495;
                                }
                                let _e1497 = phi_2131_;
                                if _e1497 {
                                    phi_2135_ = false;
                                } else {
                                    phi_2135_ = true;
                                }
                                let _e1499 = phi_2135_;
                                phi_2136_ = _e1499;
                            } else {
                                phi_2136_ = true;
                            }
                            let _e1501 = phi_2136_;
                            if _e1501 {
                                let _e1503 = params.member.member_1;
                                if ((_e1503 & 32u) != 0u) {
                                    let _e1507 = params.member.member_6;
                                    let _e1548 = (((((((_e1382.member_1[0] - _e1384.member[0]) > _e1507) && ((_e1384.member_1[0] - _e1382.member[0]) > _e1507)) && ((_e1382.member_1[1] - _e1384.member[1]) > _e1507)) && ((_e1384.member_1[1] - _e1382.member[1]) > _e1507)) && ((_e1382.member_1[2] - _e1384.member[2]) > _e1507)) && ((_e1384.member_1[2] - _e1382.member[2]) > _e1507));
                                    if _e1548 {
                                        phi_2885_ = bool();
                                    } else {
                                        phi_2185_ = type_36(0u, 3u);
                                        phi_2188_ = true;
                                        loop {
                                            let _e1552 = phi_2185_;
                                            let _e1554 = phi_2188_;
                                            local_66 = _e1554;
                                            if (_e1552.member < _e1552.member_1) {
                                                phi_2186_ = type_36((_e1552.member + 1u), _e1552.member_1);
                                                phi_2211_ = type_36(1u, _e1552.member);
                                            } else {
                                                phi_2186_ = _e1552;
                                                phi_2211_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e1568 = phi_2186_;
                                            let _e1570 = phi_2211_;
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
                                                phi_2268_ = type_36(1u, 3u);
                                                phi_2271_ = array<u32, 2>(_e1606[0], _e1606[1]);
                                                loop {
                                                    let _e1611 = phi_2268_;
                                                    let _e1613 = phi_2271_;
                                                    local_40 = _e1613;
                                                    local_42 = _e1613;
                                                    local_44 = _e1613;
                                                    if (_e1611.member < _e1611.member_1) {
                                                        phi_2269_ = type_36((_e1611.member + 1u), _e1611.member_1);
                                                        phi_2294_ = type_36(1u, _e1611.member);
                                                    } else {
                                                        phi_2269_ = _e1611;
                                                        phi_2294_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1627 = phi_2269_;
                                                    let _e1629 = phi_2294_;
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
                                                            phi_2370_ = true;
                                                        } else {
                                                            if (_e1613[1] == _e1666[1]) {
                                                                phi_2369_ = (_e1613[0] > _e1666[0]);
                                                            } else {
                                                                phi_2369_ = false;
                                                            }
                                                            let _e1677 = phi_2369_;
                                                            phi_2370_ = _e1677;
                                                        }
                                                        let _e1679 = phi_2370_;
                                                        if _e1679 {
                                                            phi_2374_ = array<u32, 2>(_e1666[0], _e1666[1]);
                                                        } else {
                                                            phi_2374_ = _e1613;
                                                        }
                                                        let _e1681 = phi_2374_;
                                                        phi_2272_ = _e1681;
                                                    } else {
                                                        phi_2272_ = array<u32, 2>();
                                                    }
                                                    let _e1683 = phi_2272_;
                                                    continue;
                                                    continuing {
                                                        phi_2268_ = _e1627;
                                                        phi_2271_ = _e1683;
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
                                                phi_2425_ = type_36(1u, 3u);
                                                phi_2428_ = array<u32, 2>(_e1717[0], _e1717[1]);
                                                loop {
                                                    let _e1722 = phi_2425_;
                                                    let _e1724 = phi_2428_;
                                                    local_41 = _e1724;
                                                    local_43 = _e1724;
                                                    local_45 = _e1724;
                                                    if (_e1722.member < _e1722.member_1) {
                                                        phi_2426_ = type_36((_e1722.member + 1u), _e1722.member_1);
                                                        phi_2451_ = type_36(1u, _e1722.member);
                                                    } else {
                                                        phi_2426_ = _e1722;
                                                        phi_2451_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1738 = phi_2426_;
                                                    let _e1740 = phi_2451_;
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
                                                            phi_2528_ = true;
                                                        } else {
                                                            if (_e1778[1] == _e1724[1]) {
                                                                phi_2527_ = (_e1778[0] > _e1724[0]);
                                                            } else {
                                                                phi_2527_ = false;
                                                            }
                                                            let _e1789 = phi_2527_;
                                                            phi_2528_ = _e1789;
                                                        }
                                                        let _e1791 = phi_2528_;
                                                        if _e1791 {
                                                            phi_2532_ = array<u32, 2>(_e1778[0], _e1778[1]);
                                                        } else {
                                                            phi_2532_ = _e1724;
                                                        }
                                                        let _e1793 = phi_2532_;
                                                        phi_2429_ = _e1793;
                                                    } else {
                                                        phi_2429_ = array<u32, 2>();
                                                    }
                                                    let _e1795 = phi_2429_;
                                                    continue;
                                                    continuing {
                                                        phi_2425_ = _e1738;
                                                        phi_2428_ = _e1795;
                                                        break if !(_e1744);
                                                    }
                                                }
                                                let _e1798 = local_40;
                                                let _e1801 = local_41;
                                                if (_e1798[1] > _e1801[1]) {
                                                    phi_2549_ = true;
                                                } else {
                                                    let _e1805 = local_42;
                                                    let _e1808 = local_43;
                                                    if (_e1805[1] == _e1808[1]) {
                                                        let _e1812 = local_44;
                                                        let _e1815 = local_45;
                                                        phi_2548_ = (_e1812[0] > _e1815[0]);
                                                    } else {
                                                        phi_2548_ = false;
                                                    }
                                                    let _e1819 = phi_2548_;
                                                    phi_2549_ = _e1819;
                                                }
                                                let _e1821 = phi_2549_;
                                                let _e1824 = local_27.member[0u];
                                                let _e1826 = keys.member[_e1824];
                                                local_10 = array<array<u32, 2>, 6>(array<u32, 2>(_e1826[0][0], _e1826[0][1]), array<u32, 2>(_e1826[1][0], _e1826[1][1]), array<u32, 2>(_e1826[2][0], _e1826[2][1]), array<u32, 2>(_e1826[3][0], _e1826[3][1]), array<u32, 2>(_e1826[4][0], _e1826[4][1]), array<u32, 2>(_e1826[5][0], _e1826[5][1]));
                                                if (_e1570.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1854 = local_10[_e1570.member_1];
                                                phi_2600_ = type_36(1u, 3u);
                                                phi_2603_ = array<u32, 2>(_e1854[0], _e1854[1]);
                                                loop {
                                                    let _e1859 = phi_2600_;
                                                    let _e1861 = phi_2603_;
                                                    local_46 = _e1861;
                                                    local_48 = _e1861;
                                                    local_50 = _e1861;
                                                    if (_e1859.member < _e1859.member_1) {
                                                        phi_2601_ = type_36((_e1859.member + 1u), _e1859.member_1);
                                                        phi_2626_ = type_36(1u, _e1859.member);
                                                    } else {
                                                        phi_2601_ = _e1859;
                                                        phi_2626_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1875 = phi_2601_;
                                                    let _e1877 = phi_2626_;
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
                                                            phi_2702_ = true;
                                                        } else {
                                                            if (_e1861[1] == _e1914[1]) {
                                                                phi_2701_ = (_e1861[0] > _e1914[0]);
                                                            } else {
                                                                phi_2701_ = false;
                                                            }
                                                            let _e1925 = phi_2701_;
                                                            phi_2702_ = _e1925;
                                                        }
                                                        let _e1927 = phi_2702_;
                                                        if _e1927 {
                                                            phi_2706_ = array<u32, 2>(_e1914[0], _e1914[1]);
                                                        } else {
                                                            phi_2706_ = _e1861;
                                                        }
                                                        let _e1929 = phi_2706_;
                                                        phi_2604_ = _e1929;
                                                    } else {
                                                        phi_2604_ = array<u32, 2>();
                                                    }
                                                    let _e1931 = phi_2604_;
                                                    continue;
                                                    continuing {
                                                        phi_2600_ = _e1875;
                                                        phi_2603_ = _e1931;
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
                                                phi_2757_ = type_36(1u, 3u);
                                                phi_2760_ = array<u32, 2>(_e1965[0], _e1965[1]);
                                                loop {
                                                    let _e1970 = phi_2757_;
                                                    let _e1972 = phi_2760_;
                                                    local_47 = _e1972;
                                                    local_49 = _e1972;
                                                    local_51 = _e1972;
                                                    if (_e1970.member < _e1970.member_1) {
                                                        phi_2758_ = type_36((_e1970.member + 1u), _e1970.member_1);
                                                        phi_2783_ = type_36(1u, _e1970.member);
                                                    } else {
                                                        phi_2758_ = _e1970;
                                                        phi_2783_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1986 = phi_2758_;
                                                    let _e1988 = phi_2783_;
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
                                                            phi_2860_ = true;
                                                        } else {
                                                            if (_e2026[1] == _e1972[1]) {
                                                                phi_2859_ = (_e2026[0] > _e1972[0]);
                                                            } else {
                                                                phi_2859_ = false;
                                                            }
                                                            let _e2037 = phi_2859_;
                                                            phi_2860_ = _e2037;
                                                        }
                                                        let _e2039 = phi_2860_;
                                                        if _e2039 {
                                                            phi_2864_ = array<u32, 2>(_e2026[0], _e2026[1]);
                                                        } else {
                                                            phi_2864_ = _e1972;
                                                        }
                                                        let _e2041 = phi_2864_;
                                                        phi_2761_ = _e2041;
                                                    } else {
                                                        phi_2761_ = array<u32, 2>();
                                                    }
                                                    let _e2043 = phi_2761_;
                                                    continue;
                                                    continuing {
                                                        phi_2757_ = _e1986;
                                                        phi_2760_ = _e2043;
                                                        break if !(_e1992);
                                                    }
                                                }
                                                let _e2046 = local_46;
                                                let _e2049 = local_47;
                                                if (_e2046[1] > _e2049[1]) {
                                                    phi_2881_ = true;
                                                } else {
                                                    let _e2053 = local_48;
                                                    let _e2056 = local_49;
                                                    if (_e2053[1] == _e2056[1]) {
                                                        let _e2060 = local_50;
                                                        let _e2063 = local_51;
                                                        phi_2880_ = (_e2060[0] > _e2063[0]);
                                                    } else {
                                                        phi_2880_ = false;
                                                    }
                                                    let _e2067 = phi_2880_;
                                                    phi_2881_ = _e2067;
                                                }
                                                let _e2069 = phi_2881_;
                                                phi_2189_ = (_e1554 && (!(_e1821) && !(_e2069)));
                                            } else {
                                                phi_2189_ = bool();
                                            }
                                            let _e2074 = phi_2189_;
                                            continue;
                                            continuing {
                                                phi_2185_ = _e1568;
                                                phi_2188_ = _e2074;
                                                break if !(_e1574);
                                            }
                                        }
                                        let _e5414 = local_66;
                                        phi_2885_ = _e5414;
                                    }
                                    let _e2077 = phi_2885_;
                                    phi_2886_ = _e2077;
                                    phi_2887_ = _e1548;
                                } else {
                                    phi_2886_ = bool();
                                    phi_2887_ = true;
                                }
                                let _e2079 = phi_2886_;
                                let _e2081 = phi_2887_;
                                if _e2081 {
                                    phi_2891_ = false;
                                } else {
                                    phi_2891_ = true;
                                }
                                let _e2083 = phi_2891_;
                                phi_2892_ = _e2079;
                                phi_2893_ = _e2083;
                            } else {
                                phi_2892_ = false;
                                phi_2893_ = true;
                            }
                            let _e2085 = phi_2892_;
                            let _e2087 = phi_2893_;
                            phi_2894_ = _e2085;
                            phi_2895_ = _e2087;
                        } else {
                            phi_2894_ = false;
                            phi_2895_ = true;
                        }
                        let _e2089 = phi_2894_;
                        let _e2091 = phi_2895_;
                        if _e2091 {
                            phi_2899_ = _e2089;
                        } else {
                            phi_2899_ = true;
                        }
                        let _e2093 = phi_2899_;
                        if _e2093 {
                            let _e2095 = atomicAdd((&counters[7u]), 1u);
                            let _e2097 = local_26.member_1;
                            let _e2099 = local_27.member_1;
                            if (_e2097 < _e2099) {
                                phi_2945_ = _e1366;
                                phi_2946_ = _e1364;
                            } else {
                                phi_2945_ = _e1364;
                                phi_2946_ = _e1366;
                            }
                            let _e2102 = phi_2945_;
                            let _e2104 = phi_2946_;
                            let _e2106 = params.member.member_4;
                            let _e2108 = params.member.member_5;
                            let _e2118 = paths.member[_e2104.member[0]];
                            let _e2120 = paths.member[_e2104.member[1]];
                            let _e2126 = paths.member[_e2102.member[0]];
                            let _e2128 = paths.member[_e2102.member[1]];
                            local_7 = type_71(array<array<f32, 3>, 2>(array<f32, 3>((_e2126.member[0] - _e2118.member[0]), (_e2126.member[1] - _e2118.member[1]), (_e2126.member[2] - _e2118.member[2])), array<f32, 3>((_e2126.member_1[0] - _e2118.member_1[0]), (_e2126.member_1[1] - _e2118.member_1[1]), (_e2126.member_1[2] - _e2118.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e2120.member[0] - _e2118.member[0]), (_e2120.member[1] - _e2118.member[1]), (_e2120.member[2] - _e2118.member[2])), array<f32, 3>((_e2120.member_1[0] - _e2118.member_1[0]), (_e2120.member_1[1] - _e2118.member_1[1]), (_e2120.member_1[2] - _e2118.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e2126.member[0] - _e2128.member[0]), (_e2126.member[1] - _e2128.member[1]), (_e2126.member[2] - _e2128.member[2])), array<f32, 3>((_e2126.member_1[0] - _e2128.member_1[0]), (_e2126.member_1[1] - _e2128.member_1[1]), (_e2126.member_1[2] - _e2128.member_1[2]))), (_e2106 + _e2106));
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
                                phi_3335_ = -(_e2343[0]);
                            } else {
                                phi_3335_ = _e2343[0];
                            }
                            let _e2350 = phi_3335_;
                            if (_e2343[1] < 0f) {
                                phi_3342_ = -(_e2343[1]);
                            } else {
                                phi_3342_ = _e2343[1];
                            }
                            let _e2354 = phi_3342_;
                            if (_e2350 > _e2354) {
                                phi_3347_ = _e2350;
                            } else {
                                phi_3347_ = _e2354;
                            }
                            let _e2357 = phi_3347_;
                            if (_e2343[2] < 0f) {
                                phi_3354_ = -(_e2343[2]);
                            } else {
                                phi_3354_ = _e2343[2];
                            }
                            let _e2361 = phi_3354_;
                            if (_e2357 > _e2361) {
                                phi_3359_ = _e2357;
                            } else {
                                phi_3359_ = _e2361;
                            }
                            let _e2364 = phi_3359_;
                            let _e2367 = local_7.member[1u];
                            if (_e2367[0] < 0f) {
                                phi_3372_ = -(_e2367[0]);
                            } else {
                                phi_3372_ = _e2367[0];
                            }
                            let _e2374 = phi_3372_;
                            if (_e2367[1] < 0f) {
                                phi_3379_ = -(_e2367[1]);
                            } else {
                                phi_3379_ = _e2367[1];
                            }
                            let _e2378 = phi_3379_;
                            if (_e2374 > _e2378) {
                                phi_3384_ = _e2374;
                            } else {
                                phi_3384_ = _e2378;
                            }
                            let _e2381 = phi_3384_;
                            if (_e2367[2] < 0f) {
                                phi_3391_ = -(_e2367[2]);
                            } else {
                                phi_3391_ = _e2367[2];
                            }
                            let _e2385 = phi_3391_;
                            if (_e2381 > _e2385) {
                                phi_3396_ = _e2381;
                            } else {
                                phi_3396_ = _e2385;
                            }
                            let _e2388 = phi_3396_;
                            if (_e2364 > _e2388) {
                                phi_3401_ = _e2364;
                            } else {
                                phi_3401_ = _e2388;
                            }
                            let _e2391 = phi_3401_;
                            let _e2393 = local_7.member_3;
                            let _e2394 = (_e2391 + _e2393);
                            let _e2397 = local_7.member_1[0u];
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
                            let _e2421 = local_7.member_1[1u];
                            if (_e2421[0] < 0f) {
                                phi_3456_ = -(_e2421[0]);
                            } else {
                                phi_3456_ = _e2421[0];
                            }
                            let _e2428 = phi_3456_;
                            if (_e2421[1] < 0f) {
                                phi_3463_ = -(_e2421[1]);
                            } else {
                                phi_3463_ = _e2421[1];
                            }
                            let _e2432 = phi_3463_;
                            if (_e2428 > _e2432) {
                                phi_3468_ = _e2428;
                            } else {
                                phi_3468_ = _e2432;
                            }
                            let _e2435 = phi_3468_;
                            if (_e2421[2] < 0f) {
                                phi_3475_ = -(_e2421[2]);
                            } else {
                                phi_3475_ = _e2421[2];
                            }
                            let _e2439 = phi_3475_;
                            if (_e2435 > _e2439) {
                                phi_3480_ = _e2435;
                            } else {
                                phi_3480_ = _e2439;
                            }
                            let _e2442 = phi_3480_;
                            if (_e2418 > _e2442) {
                                phi_3485_ = _e2418;
                            } else {
                                phi_3485_ = _e2442;
                            }
                            let _e2445 = phi_3485_;
                            let _e2447 = local_7.member_3;
                            let _e2448 = (_e2445 + _e2447);
                            let _e2451 = local_7.member_2[0u];
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
                            let _e2475 = local_7.member_2[1u];
                            if (_e2475[0] < 0f) {
                                phi_3540_ = -(_e2475[0]);
                            } else {
                                phi_3540_ = _e2475[0];
                            }
                            let _e2482 = phi_3540_;
                            if (_e2475[1] < 0f) {
                                phi_3547_ = -(_e2475[1]);
                            } else {
                                phi_3547_ = _e2475[1];
                            }
                            let _e2486 = phi_3547_;
                            if (_e2482 > _e2486) {
                                phi_3552_ = _e2482;
                            } else {
                                phi_3552_ = _e2486;
                            }
                            let _e2489 = phi_3552_;
                            if (_e2475[2] < 0f) {
                                phi_3559_ = -(_e2475[2]);
                            } else {
                                phi_3559_ = _e2475[2];
                            }
                            let _e2493 = phi_3559_;
                            if (_e2489 > _e2493) {
                                phi_3564_ = _e2489;
                            } else {
                                phi_3564_ = _e2493;
                            }
                            let _e2496 = phi_3564_;
                            if (_e2472 > _e2496) {
                                phi_3569_ = _e2472;
                            } else {
                                phi_3569_ = _e2496;
                            }
                            let _e2499 = phi_3569_;
                            let _e2501 = local_7.member_3;
                            let _e2502 = (_e2499 + _e2501);
                            let _e2504 = ((_e2448 * 8f) * _e2502);
                            let _e2511 = local_7.member_3;
                            if (_e2200 < 0f) {
                                phi_3600_ = -(_e2200);
                            } else {
                                phi_3600_ = _e2200;
                            }
                            let _e2528 = phi_3600_;
                            if (_e2203 < 0f) {
                                phi_3606_ = -(_e2203);
                            } else {
                                phi_3606_ = _e2203;
                            }
                            let _e2532 = phi_3606_;
                            if (_e2206 < 0f) {
                                phi_3613_ = -(_e2206);
                            } else {
                                phi_3613_ = _e2206;
                            }
                            let _e2537 = phi_3613_;
                            let _e2538 = ((_e2528 + _e2532) + _e2537);
                            if (_e2221 < 0f) {
                                phi_3620_ = -(_e2221);
                            } else {
                                phi_3620_ = _e2221;
                            }
                            let _e2542 = phi_3620_;
                            if (_e2224 < 0f) {
                                phi_3626_ = -(_e2224);
                            } else {
                                phi_3626_ = _e2224;
                            }
                            let _e2546 = phi_3626_;
                            if (_e2227 < 0f) {
                                phi_3633_ = -(_e2227);
                            } else {
                                phi_3633_ = _e2227;
                            }
                            let _e2551 = phi_3633_;
                            let _e2552 = ((_e2542 + _e2546) + _e2551);
                            if (_e2538 > _e2552) {
                                phi_3639_ = _e2538;
                            } else {
                                phi_3639_ = _e2552;
                            }
                            let _e2555 = phi_3639_;
                            if (_e2270 < 0f) {
                                phi_3645_ = -(_e2270);
                            } else {
                                phi_3645_ = _e2270;
                            }
                            let _e2559 = phi_3645_;
                            if (_e2271 < 0f) {
                                phi_3651_ = -(_e2271);
                            } else {
                                phi_3651_ = _e2271;
                            }
                            let _e2563 = phi_3651_;
                            if (_e2272 < 0f) {
                                phi_3658_ = -(_e2272);
                            } else {
                                phi_3658_ = _e2272;
                            }
                            let _e2568 = phi_3658_;
                            let _e2570 = (((_e2559 + _e2563) + _e2568) * 0.5f);
                            if (_e2555 > _e2570) {
                                phi_3665_ = _e2555;
                            } else {
                                phi_3665_ = _e2570;
                            }
                            let _e2573 = phi_3665_;
                            let _e2578 = local_7.member_3;
                            let _e2591 = ((((_e2275[0] * _e2200) + (_e2275[1] * _e2203)) + (_e2275[2] * _e2206)) * 3f);
                            let _e2592 = ((((_e2332[0] * _e2221) + (_e2332[1] * _e2224)) + (_e2332[2] * _e2227)) * 3f);
                            if (_e2591 < _e2592) {
                                phi_3689_ = _e2591;
                            } else {
                                phi_3689_ = _e2592;
                            }
                            let _e2595 = phi_3689_;
                            if (_e2306 < _e2329) {
                                phi_3694_ = _e2306;
                            } else {
                                phi_3694_ = _e2329;
                            }
                            let _e2598 = phi_3694_;
                            if (_e2595 < _e2598) {
                                phi_3699_ = _e2595;
                            } else {
                                phi_3699_ = _e2598;
                            }
                            let _e2601 = phi_3699_;
                            if (_e2591 > _e2592) {
                                phi_3704_ = _e2591;
                            } else {
                                phi_3704_ = _e2592;
                            }
                            let _e2604 = phi_3704_;
                            if (_e2306 > _e2329) {
                                phi_3709_ = _e2306;
                            } else {
                                phi_3709_ = _e2329;
                            }
                            let _e2607 = phi_3709_;
                            if (_e2604 > _e2607) {
                                phi_3714_ = _e2604;
                            } else {
                                phi_3714_ = _e2607;
                            }
                            let _e2610 = phi_3714_;
                            let _e2615 = -(_e2610);
                            if (_e2601 > _e2615) {
                                phi_3724_ = _e2601;
                            } else {
                                phi_3724_ = _e2615;
                            }
                            let _e2618 = phi_3724_;
                            if ((_e2618 - ((((((_e2394 * 8f) * _e2504) * (0.000000059604645f * (490f / 64f))) + ((_e2511 * 19f) * ((_e2394 * (_e2448 + _e2502)) + (_e2448 * _e2502)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2394) * ((1f + _e2448) * (1f + _e2502))))) + ((_e2108 * (((_e2573 + (_e2504 * (0.000000059604645f * 4f))) + ((_e2578 * 6f) * (_e2448 + _e2502))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2448) * (1f + _e2502))))) * (3f * 1.0001f)))) > 0f) {
                                phi_4700_ = true;
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
                                    phi_3975_ = -(_e2724[0]);
                                } else {
                                    phi_3975_ = _e2724[0];
                                }
                                let _e2731 = phi_3975_;
                                if (_e2724[1] < 0f) {
                                    phi_3982_ = -(_e2724[1]);
                                } else {
                                    phi_3982_ = _e2724[1];
                                }
                                let _e2735 = phi_3982_;
                                if (_e2731 > _e2735) {
                                    phi_3987_ = _e2731;
                                } else {
                                    phi_3987_ = _e2735;
                                }
                                let _e2738 = phi_3987_;
                                if (_e2724[2] < 0f) {
                                    phi_3994_ = -(_e2724[2]);
                                } else {
                                    phi_3994_ = _e2724[2];
                                }
                                let _e2742 = phi_3994_;
                                if (_e2738 > _e2742) {
                                    phi_3999_ = _e2738;
                                } else {
                                    phi_3999_ = _e2742;
                                }
                                let _e2745 = phi_3999_;
                                let _e2748 = local_7.member[1u];
                                if (_e2748[0] < 0f) {
                                    phi_4012_ = -(_e2748[0]);
                                } else {
                                    phi_4012_ = _e2748[0];
                                }
                                let _e2755 = phi_4012_;
                                if (_e2748[1] < 0f) {
                                    phi_4019_ = -(_e2748[1]);
                                } else {
                                    phi_4019_ = _e2748[1];
                                }
                                let _e2759 = phi_4019_;
                                if (_e2755 > _e2759) {
                                    phi_4024_ = _e2755;
                                } else {
                                    phi_4024_ = _e2759;
                                }
                                let _e2762 = phi_4024_;
                                if (_e2748[2] < 0f) {
                                    phi_4031_ = -(_e2748[2]);
                                } else {
                                    phi_4031_ = _e2748[2];
                                }
                                let _e2766 = phi_4031_;
                                if (_e2762 > _e2766) {
                                    phi_4036_ = _e2762;
                                } else {
                                    phi_4036_ = _e2766;
                                }
                                let _e2769 = phi_4036_;
                                if (_e2745 > _e2769) {
                                    phi_4041_ = _e2745;
                                } else {
                                    phi_4041_ = _e2769;
                                }
                                let _e2772 = phi_4041_;
                                let _e2774 = local_7.member_3;
                                let _e2778 = local_7.member_1[0u];
                                if (_e2778[0] < 0f) {
                                    phi_4058_ = -(_e2778[0]);
                                } else {
                                    phi_4058_ = _e2778[0];
                                }
                                let _e2785 = phi_4058_;
                                if (_e2778[1] < 0f) {
                                    phi_4065_ = -(_e2778[1]);
                                } else {
                                    phi_4065_ = _e2778[1];
                                }
                                let _e2789 = phi_4065_;
                                if (_e2785 > _e2789) {
                                    phi_4070_ = _e2785;
                                } else {
                                    phi_4070_ = _e2789;
                                }
                                let _e2792 = phi_4070_;
                                if (_e2778[2] < 0f) {
                                    phi_4077_ = -(_e2778[2]);
                                } else {
                                    phi_4077_ = _e2778[2];
                                }
                                let _e2796 = phi_4077_;
                                if (_e2792 > _e2796) {
                                    phi_4082_ = _e2792;
                                } else {
                                    phi_4082_ = _e2796;
                                }
                                let _e2799 = phi_4082_;
                                let _e2802 = local_7.member_1[1u];
                                if (_e2802[0] < 0f) {
                                    phi_4096_ = -(_e2802[0]);
                                } else {
                                    phi_4096_ = _e2802[0];
                                }
                                let _e2809 = phi_4096_;
                                if (_e2802[1] < 0f) {
                                    phi_4103_ = -(_e2802[1]);
                                } else {
                                    phi_4103_ = _e2802[1];
                                }
                                let _e2813 = phi_4103_;
                                if (_e2809 > _e2813) {
                                    phi_4108_ = _e2809;
                                } else {
                                    phi_4108_ = _e2813;
                                }
                                let _e2816 = phi_4108_;
                                if (_e2802[2] < 0f) {
                                    phi_4115_ = -(_e2802[2]);
                                } else {
                                    phi_4115_ = _e2802[2];
                                }
                                let _e2820 = phi_4115_;
                                if (_e2816 > _e2820) {
                                    phi_4120_ = _e2816;
                                } else {
                                    phi_4120_ = _e2820;
                                }
                                let _e2823 = phi_4120_;
                                if (_e2799 > _e2823) {
                                    phi_4125_ = _e2799;
                                } else {
                                    phi_4125_ = _e2823;
                                }
                                let _e2826 = phi_4125_;
                                let _e2828 = local_7.member_3;
                                let _e2832 = local_7.member_2[0u];
                                if (_e2832[0] < 0f) {
                                    phi_4142_ = -(_e2832[0]);
                                } else {
                                    phi_4142_ = _e2832[0];
                                }
                                let _e2839 = phi_4142_;
                                if (_e2832[1] < 0f) {
                                    phi_4149_ = -(_e2832[1]);
                                } else {
                                    phi_4149_ = _e2832[1];
                                }
                                let _e2843 = phi_4149_;
                                if (_e2839 > _e2843) {
                                    phi_4154_ = _e2839;
                                } else {
                                    phi_4154_ = _e2843;
                                }
                                let _e2846 = phi_4154_;
                                if (_e2832[2] < 0f) {
                                    phi_4161_ = -(_e2832[2]);
                                } else {
                                    phi_4161_ = _e2832[2];
                                }
                                let _e2850 = phi_4161_;
                                if (_e2846 > _e2850) {
                                    phi_4166_ = _e2846;
                                } else {
                                    phi_4166_ = _e2850;
                                }
                                let _e2853 = phi_4166_;
                                let _e2856 = local_7.member_2[1u];
                                if (_e2856[0] < 0f) {
                                    phi_4180_ = -(_e2856[0]);
                                } else {
                                    phi_4180_ = _e2856[0];
                                }
                                let _e2863 = phi_4180_;
                                if (_e2856[1] < 0f) {
                                    phi_4187_ = -(_e2856[1]);
                                } else {
                                    phi_4187_ = _e2856[1];
                                }
                                let _e2867 = phi_4187_;
                                if (_e2863 > _e2867) {
                                    phi_4192_ = _e2863;
                                } else {
                                    phi_4192_ = _e2867;
                                }
                                let _e2870 = phi_4192_;
                                if (_e2856[2] < 0f) {
                                    phi_4199_ = -(_e2856[2]);
                                } else {
                                    phi_4199_ = _e2856[2];
                                }
                                let _e2874 = phi_4199_;
                                if (_e2870 > _e2874) {
                                    phi_4204_ = _e2870;
                                } else {
                                    phi_4204_ = _e2874;
                                }
                                let _e2877 = phi_4204_;
                                if (_e2853 > _e2877) {
                                    phi_4209_ = _e2853;
                                } else {
                                    phi_4209_ = _e2877;
                                }
                                let _e2880 = phi_4209_;
                                let _e2882 = local_7.member_3;
                                let _e2885 = (((_e2772 + _e2774) + (_e2826 + _e2828)) + (_e2880 + _e2882));
                                let _e2888 = local_7.member_3;
                                let _e2892 = (((_e2108 * 1.0001f) + (_e2888 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2895 = ((_e2656 * _e2635) - (_e2659 * _e2634));
                                let _e2898 = ((_e2659 * _e2633) - (_e2653 * _e2635));
                                let _e2901 = ((_e2653 * _e2634) - (_e2656 * _e2633));
                                let _e2903 = local_5[0u];
                                let _e2911 = (((_e2895 * _e2903[0]) + (_e2898 * _e2903[1])) + (_e2901 * _e2903[2]));
                                phi_4247_ = type_36(0u, 4u);
                                phi_4250_ = _e2911;
                                phi_4252_ = _e2911;
                                loop {
                                    let _e2913 = phi_4247_;
                                    let _e2915 = phi_4250_;
                                    let _e2917 = phi_4252_;
                                    local_52 = _e2915;
                                    local_53 = _e2917;
                                    local_67 = _e2917;
                                    if (_e2913.member < _e2913.member_1) {
                                        phi_4248_ = type_36((_e2913.member + 1u), _e2913.member_1);
                                        phi_4275_ = type_36(1u, _e2913.member);
                                    } else {
                                        phi_4248_ = _e2913;
                                        phi_4275_ = type_36(0u, type_36().member_1);
                                    }
                                    let _e2931 = phi_4248_;
                                    let _e2933 = phi_4275_;
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
                                            phi_4325_ = _e2917;
                                        } else {
                                            phi_4325_ = _e2948;
                                        }
                                        let _e2962 = phi_4325_;
                                        if (_e2962 < _e2959) {
                                            phi_4330_ = _e2962;
                                        } else {
                                            phi_4330_ = _e2959;
                                        }
                                        let _e2965 = phi_4330_;
                                        if (_e2915 > _e2948) {
                                            phi_4335_ = _e2915;
                                        } else {
                                            phi_4335_ = _e2948;
                                        }
                                        let _e2968 = phi_4335_;
                                        if (_e2968 > _e2959) {
                                            phi_4340_ = _e2968;
                                        } else {
                                            phi_4340_ = _e2959;
                                        }
                                        let _e2971 = phi_4340_;
                                        phi_4251_ = _e2971;
                                        phi_4253_ = _e2965;
                                    } else {
                                        phi_4251_ = f32();
                                        phi_4253_ = f32();
                                    }
                                    let _e2973 = phi_4251_;
                                    let _e2975 = phi_4253_;
                                    continue;
                                    continuing {
                                        phi_4247_ = _e2931;
                                        phi_4250_ = _e2973;
                                        phi_4252_ = _e2975;
                                        break if !(_e2937);
                                    }
                                }
                                if (_e2895 < 0f) {
                                    phi_4346_ = -(_e2895);
                                } else {
                                    phi_4346_ = _e2895;
                                }
                                let _e2980 = phi_4346_;
                                if (_e2898 < 0f) {
                                    phi_4352_ = -(_e2898);
                                } else {
                                    phi_4352_ = _e2898;
                                }
                                let _e2984 = phi_4352_;
                                if (_e2901 < 0f) {
                                    phi_4359_ = -(_e2901);
                                } else {
                                    phi_4359_ = _e2901;
                                }
                                let _e2989 = phi_4359_;
                                let _e2990 = ((_e2980 + _e2984) + _e2989);
                                let _e2995 = local_52;
                                let _e2996 = -(_e2995);
                                let _e2998 = local_53;
                                if (_e2998 > _e2996) {
                                    let _e5527 = local_67;
                                    phi_4369_ = _e5527;
                                } else {
                                    phi_4369_ = _e2996;
                                }
                                let _e3001 = phi_4369_;
                                let _e3006 = (((_e3001 - ((_e2990 * _e2885) * (0.000000059604645f * 17f))) - (_e2990 * _e2892)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e3009 = ((_e2656 * _e2650) - (_e2659 * _e2649));
                                let _e3012 = ((_e2659 * _e2648) - (_e2653 * _e2650));
                                let _e3015 = ((_e2653 * _e2649) - (_e2656 * _e2648));
                                let _e3017 = local_5[0u];
                                let _e3025 = (((_e3009 * _e3017[0]) + (_e3012 * _e3017[1])) + (_e3015 * _e3017[2]));
                                phi_4400_ = type_36(0u, 4u);
                                phi_4403_ = _e3025;
                                phi_4405_ = _e3025;
                                loop {
                                    let _e3027 = phi_4400_;
                                    let _e3029 = phi_4403_;
                                    let _e3031 = phi_4405_;
                                    local_54 = _e3029;
                                    local_55 = _e3031;
                                    local_68 = _e3031;
                                    if (_e3027.member < _e3027.member_1) {
                                        phi_4401_ = type_36((_e3027.member + 1u), _e3027.member_1);
                                        phi_4428_ = type_36(1u, _e3027.member);
                                    } else {
                                        phi_4401_ = _e3027;
                                        phi_4428_ = type_36(0u, type_36().member_1);
                                    }
                                    let _e3045 = phi_4401_;
                                    let _e3047 = phi_4428_;
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
                                            phi_4478_ = _e3031;
                                        } else {
                                            phi_4478_ = _e3062;
                                        }
                                        let _e3076 = phi_4478_;
                                        if (_e3076 < _e3073) {
                                            phi_4483_ = _e3076;
                                        } else {
                                            phi_4483_ = _e3073;
                                        }
                                        let _e3079 = phi_4483_;
                                        if (_e3029 > _e3062) {
                                            phi_4488_ = _e3029;
                                        } else {
                                            phi_4488_ = _e3062;
                                        }
                                        let _e3082 = phi_4488_;
                                        if (_e3082 > _e3073) {
                                            phi_4493_ = _e3082;
                                        } else {
                                            phi_4493_ = _e3073;
                                        }
                                        let _e3085 = phi_4493_;
                                        phi_4404_ = _e3085;
                                        phi_4406_ = _e3079;
                                    } else {
                                        phi_4404_ = f32();
                                        phi_4406_ = f32();
                                    }
                                    let _e3087 = phi_4404_;
                                    let _e3089 = phi_4406_;
                                    continue;
                                    continuing {
                                        phi_4400_ = _e3045;
                                        phi_4403_ = _e3087;
                                        phi_4405_ = _e3089;
                                        break if !(_e3051);
                                    }
                                }
                                if (_e3009 < 0f) {
                                    phi_4499_ = -(_e3009);
                                } else {
                                    phi_4499_ = _e3009;
                                }
                                let _e3094 = phi_4499_;
                                if (_e3012 < 0f) {
                                    phi_4505_ = -(_e3012);
                                } else {
                                    phi_4505_ = _e3012;
                                }
                                let _e3098 = phi_4505_;
                                if (_e3015 < 0f) {
                                    phi_4512_ = -(_e3015);
                                } else {
                                    phi_4512_ = _e3015;
                                }
                                let _e3103 = phi_4512_;
                                let _e3104 = ((_e3094 + _e3098) + _e3103);
                                let _e3109 = local_54;
                                let _e3110 = -(_e3109);
                                let _e3112 = local_55;
                                if (_e3112 > _e3110) {
                                    let _e5546 = local_68;
                                    phi_4522_ = _e5546;
                                } else {
                                    phi_4522_ = _e3110;
                                }
                                let _e3115 = phi_4522_;
                                let _e3120 = (((_e3115 - ((_e3104 * _e2885) * (0.000000059604645f * 17f))) - (_e3104 * _e2892)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e3006 > _e3120) {
                                    phi_4532_ = _e3006;
                                } else {
                                    phi_4532_ = _e3120;
                                }
                                let _e3123 = phi_4532_;
                                phi_4700_ = (_e3123 > 0f);
                            }
                            let _e3126 = phi_4700_;
                            if _e3126 {
                                phi_8136_ = false;
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
                                local_4 = array<type_71, 2>(type_71(array<array<f32, 3>, 2>(_e3183, array<f32, 3>(_e3142, _e3143, _e3144)), array<array<f32, 3>, 2>(_e3186, array<f32, 3>(_e3160, _e3161, _e3162)), array<array<f32, 3>, 2>(_e3189, array<f32, 3>(_e3178, _e3179, _e3180)), _e3191), type_71(array<array<f32, 3>, 2>(array<f32, 3>(_e3142, _e3143, _e3144), _e3194), array<array<f32, 3>, 2>(array<f32, 3>(_e3160, _e3161, _e3162), _e3197), array<array<f32, 3>, 2>(array<f32, 3>(_e3178, _e3179, _e3180), _e3200), _e3202));
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
                                    phi_5157_ = -(_e3376[0]);
                                } else {
                                    phi_5157_ = _e3376[0];
                                }
                                let _e3383 = phi_5157_;
                                if (_e3376[1] < 0f) {
                                    phi_5164_ = -(_e3376[1]);
                                } else {
                                    phi_5164_ = _e3376[1];
                                }
                                let _e3387 = phi_5164_;
                                if (_e3383 > _e3387) {
                                    phi_5169_ = _e3383;
                                } else {
                                    phi_5169_ = _e3387;
                                }
                                let _e3390 = phi_5169_;
                                if (_e3376[2] < 0f) {
                                    phi_5176_ = -(_e3376[2]);
                                } else {
                                    phi_5176_ = _e3376[2];
                                }
                                let _e3394 = phi_5176_;
                                if (_e3390 > _e3394) {
                                    phi_5181_ = _e3390;
                                } else {
                                    phi_5181_ = _e3394;
                                }
                                let _e3397 = phi_5181_;
                                let _e3400 = local_4[0u].member[1u];
                                if (_e3400[0] < 0f) {
                                    phi_5194_ = -(_e3400[0]);
                                } else {
                                    phi_5194_ = _e3400[0];
                                }
                                let _e3407 = phi_5194_;
                                if (_e3400[1] < 0f) {
                                    phi_5201_ = -(_e3400[1]);
                                } else {
                                    phi_5201_ = _e3400[1];
                                }
                                let _e3411 = phi_5201_;
                                if (_e3407 > _e3411) {
                                    phi_5206_ = _e3407;
                                } else {
                                    phi_5206_ = _e3411;
                                }
                                let _e3414 = phi_5206_;
                                if (_e3400[2] < 0f) {
                                    phi_5213_ = -(_e3400[2]);
                                } else {
                                    phi_5213_ = _e3400[2];
                                }
                                let _e3418 = phi_5213_;
                                if (_e3414 > _e3418) {
                                    phi_5218_ = _e3414;
                                } else {
                                    phi_5218_ = _e3418;
                                }
                                let _e3421 = phi_5218_;
                                if (_e3397 > _e3421) {
                                    phi_5223_ = _e3397;
                                } else {
                                    phi_5223_ = _e3421;
                                }
                                let _e3424 = phi_5223_;
                                let _e3426 = local_4[0u].member_3;
                                let _e3427 = (_e3424 + _e3426);
                                let _e3430 = local_4[0u].member_1[0u];
                                if (_e3430[0] < 0f) {
                                    phi_5240_ = -(_e3430[0]);
                                } else {
                                    phi_5240_ = _e3430[0];
                                }
                                let _e3437 = phi_5240_;
                                if (_e3430[1] < 0f) {
                                    phi_5247_ = -(_e3430[1]);
                                } else {
                                    phi_5247_ = _e3430[1];
                                }
                                let _e3441 = phi_5247_;
                                if (_e3437 > _e3441) {
                                    phi_5252_ = _e3437;
                                } else {
                                    phi_5252_ = _e3441;
                                }
                                let _e3444 = phi_5252_;
                                if (_e3430[2] < 0f) {
                                    phi_5259_ = -(_e3430[2]);
                                } else {
                                    phi_5259_ = _e3430[2];
                                }
                                let _e3448 = phi_5259_;
                                if (_e3444 > _e3448) {
                                    phi_5264_ = _e3444;
                                } else {
                                    phi_5264_ = _e3448;
                                }
                                let _e3451 = phi_5264_;
                                let _e3454 = local_4[0u].member_1[1u];
                                if (_e3454[0] < 0f) {
                                    phi_5278_ = -(_e3454[0]);
                                } else {
                                    phi_5278_ = _e3454[0];
                                }
                                let _e3461 = phi_5278_;
                                if (_e3454[1] < 0f) {
                                    phi_5285_ = -(_e3454[1]);
                                } else {
                                    phi_5285_ = _e3454[1];
                                }
                                let _e3465 = phi_5285_;
                                if (_e3461 > _e3465) {
                                    phi_5290_ = _e3461;
                                } else {
                                    phi_5290_ = _e3465;
                                }
                                let _e3468 = phi_5290_;
                                if (_e3454[2] < 0f) {
                                    phi_5297_ = -(_e3454[2]);
                                } else {
                                    phi_5297_ = _e3454[2];
                                }
                                let _e3472 = phi_5297_;
                                if (_e3468 > _e3472) {
                                    phi_5302_ = _e3468;
                                } else {
                                    phi_5302_ = _e3472;
                                }
                                let _e3475 = phi_5302_;
                                if (_e3451 > _e3475) {
                                    phi_5307_ = _e3451;
                                } else {
                                    phi_5307_ = _e3475;
                                }
                                let _e3478 = phi_5307_;
                                let _e3480 = local_4[0u].member_3;
                                let _e3481 = (_e3478 + _e3480);
                                let _e3484 = local_4[0u].member_2[0u];
                                if (_e3484[0] < 0f) {
                                    phi_5324_ = -(_e3484[0]);
                                } else {
                                    phi_5324_ = _e3484[0];
                                }
                                let _e3491 = phi_5324_;
                                if (_e3484[1] < 0f) {
                                    phi_5331_ = -(_e3484[1]);
                                } else {
                                    phi_5331_ = _e3484[1];
                                }
                                let _e3495 = phi_5331_;
                                if (_e3491 > _e3495) {
                                    phi_5336_ = _e3491;
                                } else {
                                    phi_5336_ = _e3495;
                                }
                                let _e3498 = phi_5336_;
                                if (_e3484[2] < 0f) {
                                    phi_5343_ = -(_e3484[2]);
                                } else {
                                    phi_5343_ = _e3484[2];
                                }
                                let _e3502 = phi_5343_;
                                if (_e3498 > _e3502) {
                                    phi_5348_ = _e3498;
                                } else {
                                    phi_5348_ = _e3502;
                                }
                                let _e3505 = phi_5348_;
                                let _e3508 = local_4[0u].member_2[1u];
                                if (_e3508[0] < 0f) {
                                    phi_5362_ = -(_e3508[0]);
                                } else {
                                    phi_5362_ = _e3508[0];
                                }
                                let _e3515 = phi_5362_;
                                if (_e3508[1] < 0f) {
                                    phi_5369_ = -(_e3508[1]);
                                } else {
                                    phi_5369_ = _e3508[1];
                                }
                                let _e3519 = phi_5369_;
                                if (_e3515 > _e3519) {
                                    phi_5374_ = _e3515;
                                } else {
                                    phi_5374_ = _e3519;
                                }
                                let _e3522 = phi_5374_;
                                if (_e3508[2] < 0f) {
                                    phi_5381_ = -(_e3508[2]);
                                } else {
                                    phi_5381_ = _e3508[2];
                                }
                                let _e3526 = phi_5381_;
                                if (_e3522 > _e3526) {
                                    phi_5386_ = _e3522;
                                } else {
                                    phi_5386_ = _e3526;
                                }
                                let _e3529 = phi_5386_;
                                if (_e3505 > _e3529) {
                                    phi_5391_ = _e3505;
                                } else {
                                    phi_5391_ = _e3529;
                                }
                                let _e3532 = phi_5391_;
                                let _e3534 = local_4[0u].member_3;
                                let _e3535 = (_e3532 + _e3534);
                                let _e3537 = ((_e3481 * 8f) * _e3535);
                                let _e3544 = local_4[0u].member_3;
                                if (_e3233 < 0f) {
                                    phi_5422_ = -(_e3233);
                                } else {
                                    phi_5422_ = _e3233;
                                }
                                let _e3561 = phi_5422_;
                                if (_e3236 < 0f) {
                                    phi_5428_ = -(_e3236);
                                } else {
                                    phi_5428_ = _e3236;
                                }
                                let _e3565 = phi_5428_;
                                if (_e3239 < 0f) {
                                    phi_5435_ = -(_e3239);
                                } else {
                                    phi_5435_ = _e3239;
                                }
                                let _e3570 = phi_5435_;
                                let _e3571 = ((_e3561 + _e3565) + _e3570);
                                if (_e3254 < 0f) {
                                    phi_5442_ = -(_e3254);
                                } else {
                                    phi_5442_ = _e3254;
                                }
                                let _e3575 = phi_5442_;
                                if (_e3257 < 0f) {
                                    phi_5448_ = -(_e3257);
                                } else {
                                    phi_5448_ = _e3257;
                                }
                                let _e3579 = phi_5448_;
                                if (_e3260 < 0f) {
                                    phi_5455_ = -(_e3260);
                                } else {
                                    phi_5455_ = _e3260;
                                }
                                let _e3584 = phi_5455_;
                                let _e3585 = ((_e3575 + _e3579) + _e3584);
                                if (_e3571 > _e3585) {
                                    phi_5461_ = _e3571;
                                } else {
                                    phi_5461_ = _e3585;
                                }
                                let _e3588 = phi_5461_;
                                if (_e3303 < 0f) {
                                    phi_5467_ = -(_e3303);
                                } else {
                                    phi_5467_ = _e3303;
                                }
                                let _e3592 = phi_5467_;
                                if (_e3304 < 0f) {
                                    phi_5473_ = -(_e3304);
                                } else {
                                    phi_5473_ = _e3304;
                                }
                                let _e3596 = phi_5473_;
                                if (_e3305 < 0f) {
                                    phi_5480_ = -(_e3305);
                                } else {
                                    phi_5480_ = _e3305;
                                }
                                let _e3601 = phi_5480_;
                                let _e3603 = (((_e3592 + _e3596) + _e3601) * 0.5f);
                                if (_e3588 > _e3603) {
                                    phi_5487_ = _e3588;
                                } else {
                                    phi_5487_ = _e3603;
                                }
                                let _e3606 = phi_5487_;
                                let _e3611 = local_4[0u].member_3;
                                let _e3624 = ((((_e3308[0] * _e3233) + (_e3308[1] * _e3236)) + (_e3308[2] * _e3239)) * 3f);
                                let _e3625 = ((((_e3365[0] * _e3254) + (_e3365[1] * _e3257)) + (_e3365[2] * _e3260)) * 3f);
                                if (_e3624 < _e3625) {
                                    phi_5511_ = _e3624;
                                } else {
                                    phi_5511_ = _e3625;
                                }
                                let _e3628 = phi_5511_;
                                if (_e3339 < _e3362) {
                                    phi_5516_ = _e3339;
                                } else {
                                    phi_5516_ = _e3362;
                                }
                                let _e3631 = phi_5516_;
                                if (_e3628 < _e3631) {
                                    phi_5521_ = _e3628;
                                } else {
                                    phi_5521_ = _e3631;
                                }
                                let _e3634 = phi_5521_;
                                if (_e3624 > _e3625) {
                                    phi_5526_ = _e3624;
                                } else {
                                    phi_5526_ = _e3625;
                                }
                                let _e3637 = phi_5526_;
                                if (_e3339 > _e3362) {
                                    phi_5531_ = _e3339;
                                } else {
                                    phi_5531_ = _e3362;
                                }
                                let _e3640 = phi_5531_;
                                if (_e3637 > _e3640) {
                                    phi_5536_ = _e3637;
                                } else {
                                    phi_5536_ = _e3640;
                                }
                                let _e3643 = phi_5536_;
                                let _e3648 = -(_e3643);
                                if (_e3634 > _e3648) {
                                    phi_5546_ = _e3634;
                                } else {
                                    phi_5546_ = _e3648;
                                }
                                let _e3651 = phi_5546_;
                                if ((_e3651 - ((((((_e3427 * 8f) * _e3537) * (0.000000059604645f * (490f / 64f))) + ((_e3544 * 19f) * ((_e3427 * (_e3481 + _e3535)) + (_e3481 * _e3535)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3427) * ((1f + _e3481) * (1f + _e3535))))) + ((_e2108 * (((_e3606 + (_e3537 * (0.000000059604645f * 4f))) + ((_e3611 * 6f) * (_e3481 + _e3535))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3481) * (1f + _e3535))))) * (3f * 1.0001f)))) > 0f) {
                                    phi_6522_ = true;
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
                                        phi_5797_ = -(_e3757[0]);
                                    } else {
                                        phi_5797_ = _e3757[0];
                                    }
                                    let _e3764 = phi_5797_;
                                    if (_e3757[1] < 0f) {
                                        phi_5804_ = -(_e3757[1]);
                                    } else {
                                        phi_5804_ = _e3757[1];
                                    }
                                    let _e3768 = phi_5804_;
                                    if (_e3764 > _e3768) {
                                        phi_5809_ = _e3764;
                                    } else {
                                        phi_5809_ = _e3768;
                                    }
                                    let _e3771 = phi_5809_;
                                    if (_e3757[2] < 0f) {
                                        phi_5816_ = -(_e3757[2]);
                                    } else {
                                        phi_5816_ = _e3757[2];
                                    }
                                    let _e3775 = phi_5816_;
                                    if (_e3771 > _e3775) {
                                        phi_5821_ = _e3771;
                                    } else {
                                        phi_5821_ = _e3775;
                                    }
                                    let _e3778 = phi_5821_;
                                    let _e3781 = local_4[0u].member[1u];
                                    if (_e3781[0] < 0f) {
                                        phi_5834_ = -(_e3781[0]);
                                    } else {
                                        phi_5834_ = _e3781[0];
                                    }
                                    let _e3788 = phi_5834_;
                                    if (_e3781[1] < 0f) {
                                        phi_5841_ = -(_e3781[1]);
                                    } else {
                                        phi_5841_ = _e3781[1];
                                    }
                                    let _e3792 = phi_5841_;
                                    if (_e3788 > _e3792) {
                                        phi_5846_ = _e3788;
                                    } else {
                                        phi_5846_ = _e3792;
                                    }
                                    let _e3795 = phi_5846_;
                                    if (_e3781[2] < 0f) {
                                        phi_5853_ = -(_e3781[2]);
                                    } else {
                                        phi_5853_ = _e3781[2];
                                    }
                                    let _e3799 = phi_5853_;
                                    if (_e3795 > _e3799) {
                                        phi_5858_ = _e3795;
                                    } else {
                                        phi_5858_ = _e3799;
                                    }
                                    let _e3802 = phi_5858_;
                                    if (_e3778 > _e3802) {
                                        phi_5863_ = _e3778;
                                    } else {
                                        phi_5863_ = _e3802;
                                    }
                                    let _e3805 = phi_5863_;
                                    let _e3807 = local_4[0u].member_3;
                                    let _e3811 = local_4[0u].member_1[0u];
                                    if (_e3811[0] < 0f) {
                                        phi_5880_ = -(_e3811[0]);
                                    } else {
                                        phi_5880_ = _e3811[0];
                                    }
                                    let _e3818 = phi_5880_;
                                    if (_e3811[1] < 0f) {
                                        phi_5887_ = -(_e3811[1]);
                                    } else {
                                        phi_5887_ = _e3811[1];
                                    }
                                    let _e3822 = phi_5887_;
                                    if (_e3818 > _e3822) {
                                        phi_5892_ = _e3818;
                                    } else {
                                        phi_5892_ = _e3822;
                                    }
                                    let _e3825 = phi_5892_;
                                    if (_e3811[2] < 0f) {
                                        phi_5899_ = -(_e3811[2]);
                                    } else {
                                        phi_5899_ = _e3811[2];
                                    }
                                    let _e3829 = phi_5899_;
                                    if (_e3825 > _e3829) {
                                        phi_5904_ = _e3825;
                                    } else {
                                        phi_5904_ = _e3829;
                                    }
                                    let _e3832 = phi_5904_;
                                    let _e3835 = local_4[0u].member_1[1u];
                                    if (_e3835[0] < 0f) {
                                        phi_5918_ = -(_e3835[0]);
                                    } else {
                                        phi_5918_ = _e3835[0];
                                    }
                                    let _e3842 = phi_5918_;
                                    if (_e3835[1] < 0f) {
                                        phi_5925_ = -(_e3835[1]);
                                    } else {
                                        phi_5925_ = _e3835[1];
                                    }
                                    let _e3846 = phi_5925_;
                                    if (_e3842 > _e3846) {
                                        phi_5930_ = _e3842;
                                    } else {
                                        phi_5930_ = _e3846;
                                    }
                                    let _e3849 = phi_5930_;
                                    if (_e3835[2] < 0f) {
                                        phi_5937_ = -(_e3835[2]);
                                    } else {
                                        phi_5937_ = _e3835[2];
                                    }
                                    let _e3853 = phi_5937_;
                                    if (_e3849 > _e3853) {
                                        phi_5942_ = _e3849;
                                    } else {
                                        phi_5942_ = _e3853;
                                    }
                                    let _e3856 = phi_5942_;
                                    if (_e3832 > _e3856) {
                                        phi_5947_ = _e3832;
                                    } else {
                                        phi_5947_ = _e3856;
                                    }
                                    let _e3859 = phi_5947_;
                                    let _e3861 = local_4[0u].member_3;
                                    let _e3865 = local_4[0u].member_2[0u];
                                    if (_e3865[0] < 0f) {
                                        phi_5964_ = -(_e3865[0]);
                                    } else {
                                        phi_5964_ = _e3865[0];
                                    }
                                    let _e3872 = phi_5964_;
                                    if (_e3865[1] < 0f) {
                                        phi_5971_ = -(_e3865[1]);
                                    } else {
                                        phi_5971_ = _e3865[1];
                                    }
                                    let _e3876 = phi_5971_;
                                    if (_e3872 > _e3876) {
                                        phi_5976_ = _e3872;
                                    } else {
                                        phi_5976_ = _e3876;
                                    }
                                    let _e3879 = phi_5976_;
                                    if (_e3865[2] < 0f) {
                                        phi_5983_ = -(_e3865[2]);
                                    } else {
                                        phi_5983_ = _e3865[2];
                                    }
                                    let _e3883 = phi_5983_;
                                    if (_e3879 > _e3883) {
                                        phi_5988_ = _e3879;
                                    } else {
                                        phi_5988_ = _e3883;
                                    }
                                    let _e3886 = phi_5988_;
                                    let _e3889 = local_4[0u].member_2[1u];
                                    if (_e3889[0] < 0f) {
                                        phi_6002_ = -(_e3889[0]);
                                    } else {
                                        phi_6002_ = _e3889[0];
                                    }
                                    let _e3896 = phi_6002_;
                                    if (_e3889[1] < 0f) {
                                        phi_6009_ = -(_e3889[1]);
                                    } else {
                                        phi_6009_ = _e3889[1];
                                    }
                                    let _e3900 = phi_6009_;
                                    if (_e3896 > _e3900) {
                                        phi_6014_ = _e3896;
                                    } else {
                                        phi_6014_ = _e3900;
                                    }
                                    let _e3903 = phi_6014_;
                                    if (_e3889[2] < 0f) {
                                        phi_6021_ = -(_e3889[2]);
                                    } else {
                                        phi_6021_ = _e3889[2];
                                    }
                                    let _e3907 = phi_6021_;
                                    if (_e3903 > _e3907) {
                                        phi_6026_ = _e3903;
                                    } else {
                                        phi_6026_ = _e3907;
                                    }
                                    let _e3910 = phi_6026_;
                                    if (_e3886 > _e3910) {
                                        phi_6031_ = _e3886;
                                    } else {
                                        phi_6031_ = _e3910;
                                    }
                                    let _e3913 = phi_6031_;
                                    let _e3915 = local_4[0u].member_3;
                                    let _e3918 = (((_e3805 + _e3807) + (_e3859 + _e3861)) + (_e3913 + _e3915));
                                    let _e3921 = local_4[0u].member_3;
                                    let _e3925 = (((_e2108 * 1.0001f) + (_e3921 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3928 = ((_e3689 * _e3668) - (_e3692 * _e3667));
                                    let _e3931 = ((_e3692 * _e3666) - (_e3686 * _e3668));
                                    let _e3934 = ((_e3686 * _e3667) - (_e3689 * _e3666));
                                    let _e3936 = local_2[0u];
                                    let _e3944 = (((_e3928 * _e3936[0]) + (_e3931 * _e3936[1])) + (_e3934 * _e3936[2]));
                                    phi_6069_ = type_36(0u, 4u);
                                    phi_6072_ = _e3944;
                                    phi_6074_ = _e3944;
                                    loop {
                                        let _e3946 = phi_6069_;
                                        let _e3948 = phi_6072_;
                                        let _e3950 = phi_6074_;
                                        local_56 = _e3948;
                                        local_57 = _e3950;
                                        local_69 = _e3950;
                                        if (_e3946.member < _e3946.member_1) {
                                            phi_6070_ = type_36((_e3946.member + 1u), _e3946.member_1);
                                            phi_6097_ = type_36(1u, _e3946.member);
                                        } else {
                                            phi_6070_ = _e3946;
                                            phi_6097_ = type_36(0u, type_36().member_1);
                                        }
                                        let _e3964 = phi_6070_;
                                        let _e3966 = phi_6097_;
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
                                                phi_6147_ = _e3950;
                                            } else {
                                                phi_6147_ = _e3981;
                                            }
                                            let _e3995 = phi_6147_;
                                            if (_e3995 < _e3992) {
                                                phi_6152_ = _e3995;
                                            } else {
                                                phi_6152_ = _e3992;
                                            }
                                            let _e3998 = phi_6152_;
                                            if (_e3948 > _e3981) {
                                                phi_6157_ = _e3948;
                                            } else {
                                                phi_6157_ = _e3981;
                                            }
                                            let _e4001 = phi_6157_;
                                            if (_e4001 > _e3992) {
                                                phi_6162_ = _e4001;
                                            } else {
                                                phi_6162_ = _e3992;
                                            }
                                            let _e4004 = phi_6162_;
                                            phi_6073_ = _e4004;
                                            phi_6075_ = _e3998;
                                        } else {
                                            phi_6073_ = f32();
                                            phi_6075_ = f32();
                                        }
                                        let _e4006 = phi_6073_;
                                        let _e4008 = phi_6075_;
                                        continue;
                                        continuing {
                                            phi_6069_ = _e3964;
                                            phi_6072_ = _e4006;
                                            phi_6074_ = _e4008;
                                            break if !(_e3970);
                                        }
                                    }
                                    if (_e3928 < 0f) {
                                        phi_6168_ = -(_e3928);
                                    } else {
                                        phi_6168_ = _e3928;
                                    }
                                    let _e4013 = phi_6168_;
                                    if (_e3931 < 0f) {
                                        phi_6174_ = -(_e3931);
                                    } else {
                                        phi_6174_ = _e3931;
                                    }
                                    let _e4017 = phi_6174_;
                                    if (_e3934 < 0f) {
                                        phi_6181_ = -(_e3934);
                                    } else {
                                        phi_6181_ = _e3934;
                                    }
                                    let _e4022 = phi_6181_;
                                    let _e4023 = ((_e4013 + _e4017) + _e4022);
                                    let _e4028 = local_56;
                                    let _e4029 = -(_e4028);
                                    let _e4031 = local_57;
                                    if (_e4031 > _e4029) {
                                        let _e5651 = local_69;
                                        phi_6191_ = _e5651;
                                    } else {
                                        phi_6191_ = _e4029;
                                    }
                                    let _e4034 = phi_6191_;
                                    let _e4039 = (((_e4034 - ((_e4023 * _e3918) * (0.000000059604645f * 17f))) - (_e4023 * _e3925)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e4042 = ((_e3689 * _e3683) - (_e3692 * _e3682));
                                    let _e4045 = ((_e3692 * _e3681) - (_e3686 * _e3683));
                                    let _e4048 = ((_e3686 * _e3682) - (_e3689 * _e3681));
                                    let _e4050 = local_2[0u];
                                    let _e4058 = (((_e4042 * _e4050[0]) + (_e4045 * _e4050[1])) + (_e4048 * _e4050[2]));
                                    phi_6222_ = type_36(0u, 4u);
                                    phi_6225_ = _e4058;
                                    phi_6227_ = _e4058;
                                    loop {
                                        let _e4060 = phi_6222_;
                                        let _e4062 = phi_6225_;
                                        let _e4064 = phi_6227_;
                                        local_58 = _e4062;
                                        local_59 = _e4064;
                                        local_70 = _e4064;
                                        if (_e4060.member < _e4060.member_1) {
                                            phi_6223_ = type_36((_e4060.member + 1u), _e4060.member_1);
                                            phi_6250_ = type_36(1u, _e4060.member);
                                        } else {
                                            phi_6223_ = _e4060;
                                            phi_6250_ = type_36(0u, type_36().member_1);
                                        }
                                        let _e4078 = phi_6223_;
                                        let _e4080 = phi_6250_;
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
                                                phi_6300_ = _e4064;
                                            } else {
                                                phi_6300_ = _e4095;
                                            }
                                            let _e4109 = phi_6300_;
                                            if (_e4109 < _e4106) {
                                                phi_6305_ = _e4109;
                                            } else {
                                                phi_6305_ = _e4106;
                                            }
                                            let _e4112 = phi_6305_;
                                            if (_e4062 > _e4095) {
                                                phi_6310_ = _e4062;
                                            } else {
                                                phi_6310_ = _e4095;
                                            }
                                            let _e4115 = phi_6310_;
                                            if (_e4115 > _e4106) {
                                                phi_6315_ = _e4115;
                                            } else {
                                                phi_6315_ = _e4106;
                                            }
                                            let _e4118 = phi_6315_;
                                            phi_6226_ = _e4118;
                                            phi_6228_ = _e4112;
                                        } else {
                                            phi_6226_ = f32();
                                            phi_6228_ = f32();
                                        }
                                        let _e4120 = phi_6226_;
                                        let _e4122 = phi_6228_;
                                        continue;
                                        continuing {
                                            phi_6222_ = _e4078;
                                            phi_6225_ = _e4120;
                                            phi_6227_ = _e4122;
                                            break if !(_e4084);
                                        }
                                    }
                                    if (_e4042 < 0f) {
                                        phi_6321_ = -(_e4042);
                                    } else {
                                        phi_6321_ = _e4042;
                                    }
                                    let _e4127 = phi_6321_;
                                    if (_e4045 < 0f) {
                                        phi_6327_ = -(_e4045);
                                    } else {
                                        phi_6327_ = _e4045;
                                    }
                                    let _e4131 = phi_6327_;
                                    if (_e4048 < 0f) {
                                        phi_6334_ = -(_e4048);
                                    } else {
                                        phi_6334_ = _e4048;
                                    }
                                    let _e4136 = phi_6334_;
                                    let _e4137 = ((_e4127 + _e4131) + _e4136);
                                    let _e4142 = local_58;
                                    let _e4143 = -(_e4142);
                                    let _e4145 = local_59;
                                    if (_e4145 > _e4143) {
                                        let _e5670 = local_70;
                                        phi_6344_ = _e5670;
                                    } else {
                                        phi_6344_ = _e4143;
                                    }
                                    let _e4148 = phi_6344_;
                                    let _e4153 = (((_e4148 - ((_e4137 * _e3918) * (0.000000059604645f * 17f))) - (_e4137 * _e3925)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e4039 > _e4153) {
                                        phi_6354_ = _e4039;
                                    } else {
                                        phi_6354_ = _e4153;
                                    }
                                    let _e4156 = phi_6354_;
                                    phi_6522_ = (_e4156 > 0f);
                                }
                                let _e4159 = phi_6522_;
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
                                        phi_6768_ = -(_e4318[0]);
                                    } else {
                                        phi_6768_ = _e4318[0];
                                    }
                                    let _e4325 = phi_6768_;
                                    if (_e4318[1] < 0f) {
                                        phi_6775_ = -(_e4318[1]);
                                    } else {
                                        phi_6775_ = _e4318[1];
                                    }
                                    let _e4329 = phi_6775_;
                                    if (_e4325 > _e4329) {
                                        phi_6780_ = _e4325;
                                    } else {
                                        phi_6780_ = _e4329;
                                    }
                                    let _e4332 = phi_6780_;
                                    if (_e4318[2] < 0f) {
                                        phi_6787_ = -(_e4318[2]);
                                    } else {
                                        phi_6787_ = _e4318[2];
                                    }
                                    let _e4336 = phi_6787_;
                                    if (_e4332 > _e4336) {
                                        phi_6792_ = _e4332;
                                    } else {
                                        phi_6792_ = _e4336;
                                    }
                                    let _e4339 = phi_6792_;
                                    let _e4342 = local_4[1u].member[1u];
                                    if (_e4342[0] < 0f) {
                                        phi_6805_ = -(_e4342[0]);
                                    } else {
                                        phi_6805_ = _e4342[0];
                                    }
                                    let _e4349 = phi_6805_;
                                    if (_e4342[1] < 0f) {
                                        phi_6812_ = -(_e4342[1]);
                                    } else {
                                        phi_6812_ = _e4342[1];
                                    }
                                    let _e4353 = phi_6812_;
                                    if (_e4349 > _e4353) {
                                        phi_6817_ = _e4349;
                                    } else {
                                        phi_6817_ = _e4353;
                                    }
                                    let _e4356 = phi_6817_;
                                    if (_e4342[2] < 0f) {
                                        phi_6824_ = -(_e4342[2]);
                                    } else {
                                        phi_6824_ = _e4342[2];
                                    }
                                    let _e4360 = phi_6824_;
                                    if (_e4356 > _e4360) {
                                        phi_6829_ = _e4356;
                                    } else {
                                        phi_6829_ = _e4360;
                                    }
                                    let _e4363 = phi_6829_;
                                    if (_e4339 > _e4363) {
                                        phi_6834_ = _e4339;
                                    } else {
                                        phi_6834_ = _e4363;
                                    }
                                    let _e4366 = phi_6834_;
                                    let _e4368 = local_4[1u].member_3;
                                    let _e4369 = (_e4366 + _e4368);
                                    let _e4372 = local_4[1u].member_1[0u];
                                    if (_e4372[0] < 0f) {
                                        phi_6851_ = -(_e4372[0]);
                                    } else {
                                        phi_6851_ = _e4372[0];
                                    }
                                    let _e4379 = phi_6851_;
                                    if (_e4372[1] < 0f) {
                                        phi_6858_ = -(_e4372[1]);
                                    } else {
                                        phi_6858_ = _e4372[1];
                                    }
                                    let _e4383 = phi_6858_;
                                    if (_e4379 > _e4383) {
                                        phi_6863_ = _e4379;
                                    } else {
                                        phi_6863_ = _e4383;
                                    }
                                    let _e4386 = phi_6863_;
                                    if (_e4372[2] < 0f) {
                                        phi_6870_ = -(_e4372[2]);
                                    } else {
                                        phi_6870_ = _e4372[2];
                                    }
                                    let _e4390 = phi_6870_;
                                    if (_e4386 > _e4390) {
                                        phi_6875_ = _e4386;
                                    } else {
                                        phi_6875_ = _e4390;
                                    }
                                    let _e4393 = phi_6875_;
                                    let _e4396 = local_4[1u].member_1[1u];
                                    if (_e4396[0] < 0f) {
                                        phi_6889_ = -(_e4396[0]);
                                    } else {
                                        phi_6889_ = _e4396[0];
                                    }
                                    let _e4403 = phi_6889_;
                                    if (_e4396[1] < 0f) {
                                        phi_6896_ = -(_e4396[1]);
                                    } else {
                                        phi_6896_ = _e4396[1];
                                    }
                                    let _e4407 = phi_6896_;
                                    if (_e4403 > _e4407) {
                                        phi_6901_ = _e4403;
                                    } else {
                                        phi_6901_ = _e4407;
                                    }
                                    let _e4410 = phi_6901_;
                                    if (_e4396[2] < 0f) {
                                        phi_6908_ = -(_e4396[2]);
                                    } else {
                                        phi_6908_ = _e4396[2];
                                    }
                                    let _e4414 = phi_6908_;
                                    if (_e4410 > _e4414) {
                                        phi_6913_ = _e4410;
                                    } else {
                                        phi_6913_ = _e4414;
                                    }
                                    let _e4417 = phi_6913_;
                                    if (_e4393 > _e4417) {
                                        phi_6918_ = _e4393;
                                    } else {
                                        phi_6918_ = _e4417;
                                    }
                                    let _e4420 = phi_6918_;
                                    let _e4422 = local_4[1u].member_3;
                                    let _e4423 = (_e4420 + _e4422);
                                    let _e4426 = local_4[1u].member_2[0u];
                                    if (_e4426[0] < 0f) {
                                        phi_6935_ = -(_e4426[0]);
                                    } else {
                                        phi_6935_ = _e4426[0];
                                    }
                                    let _e4433 = phi_6935_;
                                    if (_e4426[1] < 0f) {
                                        phi_6942_ = -(_e4426[1]);
                                    } else {
                                        phi_6942_ = _e4426[1];
                                    }
                                    let _e4437 = phi_6942_;
                                    if (_e4433 > _e4437) {
                                        phi_6947_ = _e4433;
                                    } else {
                                        phi_6947_ = _e4437;
                                    }
                                    let _e4440 = phi_6947_;
                                    if (_e4426[2] < 0f) {
                                        phi_6954_ = -(_e4426[2]);
                                    } else {
                                        phi_6954_ = _e4426[2];
                                    }
                                    let _e4444 = phi_6954_;
                                    if (_e4440 > _e4444) {
                                        phi_6959_ = _e4440;
                                    } else {
                                        phi_6959_ = _e4444;
                                    }
                                    let _e4447 = phi_6959_;
                                    let _e4450 = local_4[1u].member_2[1u];
                                    if (_e4450[0] < 0f) {
                                        phi_6973_ = -(_e4450[0]);
                                    } else {
                                        phi_6973_ = _e4450[0];
                                    }
                                    let _e4457 = phi_6973_;
                                    if (_e4450[1] < 0f) {
                                        phi_6980_ = -(_e4450[1]);
                                    } else {
                                        phi_6980_ = _e4450[1];
                                    }
                                    let _e4461 = phi_6980_;
                                    if (_e4457 > _e4461) {
                                        phi_6985_ = _e4457;
                                    } else {
                                        phi_6985_ = _e4461;
                                    }
                                    let _e4464 = phi_6985_;
                                    if (_e4450[2] < 0f) {
                                        phi_6992_ = -(_e4450[2]);
                                    } else {
                                        phi_6992_ = _e4450[2];
                                    }
                                    let _e4468 = phi_6992_;
                                    if (_e4464 > _e4468) {
                                        phi_6997_ = _e4464;
                                    } else {
                                        phi_6997_ = _e4468;
                                    }
                                    let _e4471 = phi_6997_;
                                    if (_e4447 > _e4471) {
                                        phi_7002_ = _e4447;
                                    } else {
                                        phi_7002_ = _e4471;
                                    }
                                    let _e4474 = phi_7002_;
                                    let _e4476 = local_4[1u].member_3;
                                    let _e4477 = (_e4474 + _e4476);
                                    let _e4479 = ((_e4423 * 8f) * _e4477);
                                    let _e4486 = local_4[1u].member_3;
                                    if (_e4175 < 0f) {
                                        phi_7033_ = -(_e4175);
                                    } else {
                                        phi_7033_ = _e4175;
                                    }
                                    let _e4503 = phi_7033_;
                                    if (_e4178 < 0f) {
                                        phi_7039_ = -(_e4178);
                                    } else {
                                        phi_7039_ = _e4178;
                                    }
                                    let _e4507 = phi_7039_;
                                    if (_e4181 < 0f) {
                                        phi_7046_ = -(_e4181);
                                    } else {
                                        phi_7046_ = _e4181;
                                    }
                                    let _e4512 = phi_7046_;
                                    let _e4513 = ((_e4503 + _e4507) + _e4512);
                                    if (_e4196 < 0f) {
                                        phi_7053_ = -(_e4196);
                                    } else {
                                        phi_7053_ = _e4196;
                                    }
                                    let _e4517 = phi_7053_;
                                    if (_e4199 < 0f) {
                                        phi_7059_ = -(_e4199);
                                    } else {
                                        phi_7059_ = _e4199;
                                    }
                                    let _e4521 = phi_7059_;
                                    if (_e4202 < 0f) {
                                        phi_7066_ = -(_e4202);
                                    } else {
                                        phi_7066_ = _e4202;
                                    }
                                    let _e4526 = phi_7066_;
                                    let _e4527 = ((_e4517 + _e4521) + _e4526);
                                    if (_e4513 > _e4527) {
                                        phi_7072_ = _e4513;
                                    } else {
                                        phi_7072_ = _e4527;
                                    }
                                    let _e4530 = phi_7072_;
                                    if (_e4245 < 0f) {
                                        phi_7078_ = -(_e4245);
                                    } else {
                                        phi_7078_ = _e4245;
                                    }
                                    let _e4534 = phi_7078_;
                                    if (_e4246 < 0f) {
                                        phi_7084_ = -(_e4246);
                                    } else {
                                        phi_7084_ = _e4246;
                                    }
                                    let _e4538 = phi_7084_;
                                    if (_e4247 < 0f) {
                                        phi_7091_ = -(_e4247);
                                    } else {
                                        phi_7091_ = _e4247;
                                    }
                                    let _e4543 = phi_7091_;
                                    let _e4545 = (((_e4534 + _e4538) + _e4543) * 0.5f);
                                    if (_e4530 > _e4545) {
                                        phi_7098_ = _e4530;
                                    } else {
                                        phi_7098_ = _e4545;
                                    }
                                    let _e4548 = phi_7098_;
                                    let _e4553 = local_4[1u].member_3;
                                    let _e4566 = ((((_e4250[0] * _e4175) + (_e4250[1] * _e4178)) + (_e4250[2] * _e4181)) * 3f);
                                    let _e4567 = ((((_e4307[0] * _e4196) + (_e4307[1] * _e4199)) + (_e4307[2] * _e4202)) * 3f);
                                    if (_e4566 < _e4567) {
                                        phi_7122_ = _e4566;
                                    } else {
                                        phi_7122_ = _e4567;
                                    }
                                    let _e4570 = phi_7122_;
                                    if (_e4281 < _e4304) {
                                        phi_7127_ = _e4281;
                                    } else {
                                        phi_7127_ = _e4304;
                                    }
                                    let _e4573 = phi_7127_;
                                    if (_e4570 < _e4573) {
                                        phi_7132_ = _e4570;
                                    } else {
                                        phi_7132_ = _e4573;
                                    }
                                    let _e4576 = phi_7132_;
                                    if (_e4566 > _e4567) {
                                        phi_7137_ = _e4566;
                                    } else {
                                        phi_7137_ = _e4567;
                                    }
                                    let _e4579 = phi_7137_;
                                    if (_e4281 > _e4304) {
                                        phi_7142_ = _e4281;
                                    } else {
                                        phi_7142_ = _e4304;
                                    }
                                    let _e4582 = phi_7142_;
                                    if (_e4579 > _e4582) {
                                        phi_7147_ = _e4579;
                                    } else {
                                        phi_7147_ = _e4582;
                                    }
                                    let _e4585 = phi_7147_;
                                    let _e4590 = -(_e4585);
                                    if (_e4576 > _e4590) {
                                        phi_7157_ = _e4576;
                                    } else {
                                        phi_7157_ = _e4590;
                                    }
                                    let _e4593 = phi_7157_;
                                    if ((_e4593 - ((((((_e4369 * 8f) * _e4479) * (0.000000059604645f * (490f / 64f))) + ((_e4486 * 19f) * ((_e4369 * (_e4423 + _e4477)) + (_e4423 * _e4477)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4369) * ((1f + _e4423) * (1f + _e4477))))) + ((_e2108 * (((_e4548 + (_e4479 * (0.000000059604645f * 4f))) + ((_e4553 * 6f) * (_e4423 + _e4477))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4423) * (1f + _e4477))))) * (3f * 1.0001f)))) > 0f) {
                                        phi_8133_ = true;
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
                                            phi_7408_ = -(_e4699[0]);
                                        } else {
                                            phi_7408_ = _e4699[0];
                                        }
                                        let _e4706 = phi_7408_;
                                        if (_e4699[1] < 0f) {
                                            phi_7415_ = -(_e4699[1]);
                                        } else {
                                            phi_7415_ = _e4699[1];
                                        }
                                        let _e4710 = phi_7415_;
                                        if (_e4706 > _e4710) {
                                            phi_7420_ = _e4706;
                                        } else {
                                            phi_7420_ = _e4710;
                                        }
                                        let _e4713 = phi_7420_;
                                        if (_e4699[2] < 0f) {
                                            phi_7427_ = -(_e4699[2]);
                                        } else {
                                            phi_7427_ = _e4699[2];
                                        }
                                        let _e4717 = phi_7427_;
                                        if (_e4713 > _e4717) {
                                            phi_7432_ = _e4713;
                                        } else {
                                            phi_7432_ = _e4717;
                                        }
                                        let _e4720 = phi_7432_;
                                        let _e4723 = local_4[1u].member[1u];
                                        if (_e4723[0] < 0f) {
                                            phi_7445_ = -(_e4723[0]);
                                        } else {
                                            phi_7445_ = _e4723[0];
                                        }
                                        let _e4730 = phi_7445_;
                                        if (_e4723[1] < 0f) {
                                            phi_7452_ = -(_e4723[1]);
                                        } else {
                                            phi_7452_ = _e4723[1];
                                        }
                                        let _e4734 = phi_7452_;
                                        if (_e4730 > _e4734) {
                                            phi_7457_ = _e4730;
                                        } else {
                                            phi_7457_ = _e4734;
                                        }
                                        let _e4737 = phi_7457_;
                                        if (_e4723[2] < 0f) {
                                            phi_7464_ = -(_e4723[2]);
                                        } else {
                                            phi_7464_ = _e4723[2];
                                        }
                                        let _e4741 = phi_7464_;
                                        if (_e4737 > _e4741) {
                                            phi_7469_ = _e4737;
                                        } else {
                                            phi_7469_ = _e4741;
                                        }
                                        let _e4744 = phi_7469_;
                                        if (_e4720 > _e4744) {
                                            phi_7474_ = _e4720;
                                        } else {
                                            phi_7474_ = _e4744;
                                        }
                                        let _e4747 = phi_7474_;
                                        let _e4749 = local_4[1u].member_3;
                                        let _e4753 = local_4[1u].member_1[0u];
                                        if (_e4753[0] < 0f) {
                                            phi_7491_ = -(_e4753[0]);
                                        } else {
                                            phi_7491_ = _e4753[0];
                                        }
                                        let _e4760 = phi_7491_;
                                        if (_e4753[1] < 0f) {
                                            phi_7498_ = -(_e4753[1]);
                                        } else {
                                            phi_7498_ = _e4753[1];
                                        }
                                        let _e4764 = phi_7498_;
                                        if (_e4760 > _e4764) {
                                            phi_7503_ = _e4760;
                                        } else {
                                            phi_7503_ = _e4764;
                                        }
                                        let _e4767 = phi_7503_;
                                        if (_e4753[2] < 0f) {
                                            phi_7510_ = -(_e4753[2]);
                                        } else {
                                            phi_7510_ = _e4753[2];
                                        }
                                        let _e4771 = phi_7510_;
                                        if (_e4767 > _e4771) {
                                            phi_7515_ = _e4767;
                                        } else {
                                            phi_7515_ = _e4771;
                                        }
                                        let _e4774 = phi_7515_;
                                        let _e4777 = local_4[1u].member_1[1u];
                                        if (_e4777[0] < 0f) {
                                            phi_7529_ = -(_e4777[0]);
                                        } else {
                                            phi_7529_ = _e4777[0];
                                        }
                                        let _e4784 = phi_7529_;
                                        if (_e4777[1] < 0f) {
                                            phi_7536_ = -(_e4777[1]);
                                        } else {
                                            phi_7536_ = _e4777[1];
                                        }
                                        let _e4788 = phi_7536_;
                                        if (_e4784 > _e4788) {
                                            phi_7541_ = _e4784;
                                        } else {
                                            phi_7541_ = _e4788;
                                        }
                                        let _e4791 = phi_7541_;
                                        if (_e4777[2] < 0f) {
                                            phi_7548_ = -(_e4777[2]);
                                        } else {
                                            phi_7548_ = _e4777[2];
                                        }
                                        let _e4795 = phi_7548_;
                                        if (_e4791 > _e4795) {
                                            phi_7553_ = _e4791;
                                        } else {
                                            phi_7553_ = _e4795;
                                        }
                                        let _e4798 = phi_7553_;
                                        if (_e4774 > _e4798) {
                                            phi_7558_ = _e4774;
                                        } else {
                                            phi_7558_ = _e4798;
                                        }
                                        let _e4801 = phi_7558_;
                                        let _e4803 = local_4[1u].member_3;
                                        let _e4807 = local_4[1u].member_2[0u];
                                        if (_e4807[0] < 0f) {
                                            phi_7575_ = -(_e4807[0]);
                                        } else {
                                            phi_7575_ = _e4807[0];
                                        }
                                        let _e4814 = phi_7575_;
                                        if (_e4807[1] < 0f) {
                                            phi_7582_ = -(_e4807[1]);
                                        } else {
                                            phi_7582_ = _e4807[1];
                                        }
                                        let _e4818 = phi_7582_;
                                        if (_e4814 > _e4818) {
                                            phi_7587_ = _e4814;
                                        } else {
                                            phi_7587_ = _e4818;
                                        }
                                        let _e4821 = phi_7587_;
                                        if (_e4807[2] < 0f) {
                                            phi_7594_ = -(_e4807[2]);
                                        } else {
                                            phi_7594_ = _e4807[2];
                                        }
                                        let _e4825 = phi_7594_;
                                        if (_e4821 > _e4825) {
                                            phi_7599_ = _e4821;
                                        } else {
                                            phi_7599_ = _e4825;
                                        }
                                        let _e4828 = phi_7599_;
                                        let _e4831 = local_4[1u].member_2[1u];
                                        if (_e4831[0] < 0f) {
                                            phi_7613_ = -(_e4831[0]);
                                        } else {
                                            phi_7613_ = _e4831[0];
                                        }
                                        let _e4838 = phi_7613_;
                                        if (_e4831[1] < 0f) {
                                            phi_7620_ = -(_e4831[1]);
                                        } else {
                                            phi_7620_ = _e4831[1];
                                        }
                                        let _e4842 = phi_7620_;
                                        if (_e4838 > _e4842) {
                                            phi_7625_ = _e4838;
                                        } else {
                                            phi_7625_ = _e4842;
                                        }
                                        let _e4845 = phi_7625_;
                                        if (_e4831[2] < 0f) {
                                            phi_7632_ = -(_e4831[2]);
                                        } else {
                                            phi_7632_ = _e4831[2];
                                        }
                                        let _e4849 = phi_7632_;
                                        if (_e4845 > _e4849) {
                                            phi_7637_ = _e4845;
                                        } else {
                                            phi_7637_ = _e4849;
                                        }
                                        let _e4852 = phi_7637_;
                                        if (_e4828 > _e4852) {
                                            phi_7642_ = _e4828;
                                        } else {
                                            phi_7642_ = _e4852;
                                        }
                                        let _e4855 = phi_7642_;
                                        let _e4857 = local_4[1u].member_3;
                                        let _e4860 = (((_e4747 + _e4749) + (_e4801 + _e4803)) + (_e4855 + _e4857));
                                        let _e4863 = local_4[1u].member_3;
                                        let _e4867 = (((_e2108 * 1.0001f) + (_e4863 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4870 = ((_e4631 * _e4610) - (_e4634 * _e4609));
                                        let _e4873 = ((_e4634 * _e4608) - (_e4628 * _e4610));
                                        let _e4876 = ((_e4628 * _e4609) - (_e4631 * _e4608));
                                        let _e4878 = local[0u];
                                        let _e4886 = (((_e4870 * _e4878[0]) + (_e4873 * _e4878[1])) + (_e4876 * _e4878[2]));
                                        phi_7680_ = type_36(0u, 4u);
                                        phi_7683_ = _e4886;
                                        phi_7685_ = _e4886;
                                        loop {
                                            let _e4888 = phi_7680_;
                                            let _e4890 = phi_7683_;
                                            let _e4892 = phi_7685_;
                                            local_60 = _e4890;
                                            local_61 = _e4892;
                                            local_71 = _e4892;
                                            if (_e4888.member < _e4888.member_1) {
                                                phi_7681_ = type_36((_e4888.member + 1u), _e4888.member_1);
                                                phi_7708_ = type_36(1u, _e4888.member);
                                            } else {
                                                phi_7681_ = _e4888;
                                                phi_7708_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e4906 = phi_7681_;
                                            let _e4908 = phi_7708_;
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
                                                    phi_7758_ = _e4892;
                                                } else {
                                                    phi_7758_ = _e4923;
                                                }
                                                let _e4937 = phi_7758_;
                                                if (_e4937 < _e4934) {
                                                    phi_7763_ = _e4937;
                                                } else {
                                                    phi_7763_ = _e4934;
                                                }
                                                let _e4940 = phi_7763_;
                                                if (_e4890 > _e4923) {
                                                    phi_7768_ = _e4890;
                                                } else {
                                                    phi_7768_ = _e4923;
                                                }
                                                let _e4943 = phi_7768_;
                                                if (_e4943 > _e4934) {
                                                    phi_7773_ = _e4943;
                                                } else {
                                                    phi_7773_ = _e4934;
                                                }
                                                let _e4946 = phi_7773_;
                                                phi_7684_ = _e4946;
                                                phi_7686_ = _e4940;
                                            } else {
                                                phi_7684_ = f32();
                                                phi_7686_ = f32();
                                            }
                                            let _e4948 = phi_7684_;
                                            let _e4950 = phi_7686_;
                                            continue;
                                            continuing {
                                                phi_7680_ = _e4906;
                                                phi_7683_ = _e4948;
                                                phi_7685_ = _e4950;
                                                break if !(_e4912);
                                            }
                                        }
                                        if (_e4870 < 0f) {
                                            phi_7779_ = -(_e4870);
                                        } else {
                                            phi_7779_ = _e4870;
                                        }
                                        let _e4955 = phi_7779_;
                                        if (_e4873 < 0f) {
                                            phi_7785_ = -(_e4873);
                                        } else {
                                            phi_7785_ = _e4873;
                                        }
                                        let _e4959 = phi_7785_;
                                        if (_e4876 < 0f) {
                                            phi_7792_ = -(_e4876);
                                        } else {
                                            phi_7792_ = _e4876;
                                        }
                                        let _e4964 = phi_7792_;
                                        let _e4965 = ((_e4955 + _e4959) + _e4964);
                                        let _e4970 = local_60;
                                        let _e4971 = -(_e4970);
                                        let _e4973 = local_61;
                                        if (_e4973 > _e4971) {
                                            let _e5775 = local_71;
                                            phi_7802_ = _e5775;
                                        } else {
                                            phi_7802_ = _e4971;
                                        }
                                        let _e4976 = phi_7802_;
                                        let _e4981 = (((_e4976 - ((_e4965 * _e4860) * (0.000000059604645f * 17f))) - (_e4965 * _e4867)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4984 = ((_e4631 * _e4625) - (_e4634 * _e4624));
                                        let _e4987 = ((_e4634 * _e4623) - (_e4628 * _e4625));
                                        let _e4990 = ((_e4628 * _e4624) - (_e4631 * _e4623));
                                        let _e4992 = local[0u];
                                        let _e5000 = (((_e4984 * _e4992[0]) + (_e4987 * _e4992[1])) + (_e4990 * _e4992[2]));
                                        phi_7833_ = type_36(0u, 4u);
                                        phi_7836_ = _e5000;
                                        phi_7838_ = _e5000;
                                        loop {
                                            let _e5002 = phi_7833_;
                                            let _e5004 = phi_7836_;
                                            let _e5006 = phi_7838_;
                                            local_62 = _e5004;
                                            local_63 = _e5006;
                                            local_72 = _e5006;
                                            if (_e5002.member < _e5002.member_1) {
                                                phi_7834_ = type_36((_e5002.member + 1u), _e5002.member_1);
                                                phi_7861_ = type_36(1u, _e5002.member);
                                            } else {
                                                phi_7834_ = _e5002;
                                                phi_7861_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e5020 = phi_7834_;
                                            let _e5022 = phi_7861_;
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
                                                    phi_7911_ = _e5006;
                                                } else {
                                                    phi_7911_ = _e5037;
                                                }
                                                let _e5051 = phi_7911_;
                                                if (_e5051 < _e5048) {
                                                    phi_7916_ = _e5051;
                                                } else {
                                                    phi_7916_ = _e5048;
                                                }
                                                let _e5054 = phi_7916_;
                                                if (_e5004 > _e5037) {
                                                    phi_7921_ = _e5004;
                                                } else {
                                                    phi_7921_ = _e5037;
                                                }
                                                let _e5057 = phi_7921_;
                                                if (_e5057 > _e5048) {
                                                    phi_7926_ = _e5057;
                                                } else {
                                                    phi_7926_ = _e5048;
                                                }
                                                let _e5060 = phi_7926_;
                                                phi_7837_ = _e5060;
                                                phi_7839_ = _e5054;
                                            } else {
                                                phi_7837_ = f32();
                                                phi_7839_ = f32();
                                            }
                                            let _e5062 = phi_7837_;
                                            let _e5064 = phi_7839_;
                                            continue;
                                            continuing {
                                                phi_7833_ = _e5020;
                                                phi_7836_ = _e5062;
                                                phi_7838_ = _e5064;
                                                break if !(_e5026);
                                            }
                                        }
                                        if (_e4984 < 0f) {
                                            phi_7932_ = -(_e4984);
                                        } else {
                                            phi_7932_ = _e4984;
                                        }
                                        let _e5069 = phi_7932_;
                                        if (_e4987 < 0f) {
                                            phi_7938_ = -(_e4987);
                                        } else {
                                            phi_7938_ = _e4987;
                                        }
                                        let _e5073 = phi_7938_;
                                        if (_e4990 < 0f) {
                                            phi_7945_ = -(_e4990);
                                        } else {
                                            phi_7945_ = _e4990;
                                        }
                                        let _e5078 = phi_7945_;
                                        let _e5079 = ((_e5069 + _e5073) + _e5078);
                                        let _e5084 = local_62;
                                        let _e5085 = -(_e5084);
                                        let _e5087 = local_63;
                                        if (_e5087 > _e5085) {
                                            let _e5794 = local_72;
                                            phi_7955_ = _e5794;
                                        } else {
                                            phi_7955_ = _e5085;
                                        }
                                        let _e5090 = phi_7955_;
                                        let _e5095 = (((_e5090 - ((_e5079 * _e4860) * (0.000000059604645f * 17f))) - (_e5079 * _e4867)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4981 > _e5095) {
                                            phi_7965_ = _e4981;
                                        } else {
                                            phi_7965_ = _e5095;
                                        }
                                        let _e5098 = phi_7965_;
                                        phi_8133_ = (_e5098 > 0f);
                                    }
                                    let _e5101 = phi_8133_;
                                    phi_8134_ = _e5101;
                                } else {
                                    phi_8134_ = false;
                                }
                                let _e5103 = phi_8134_;
                                phi_8136_ = !(_e5103);
                            }
                            let _e5106 = phi_8136_;
                            if _e5106 {
                                let _e5108 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1343] = ((2147483648u | (_e5108 << bitcast<u32>(12i))) | _e1346);
                            }
                        }
                        phi_8146_ = true;
                    }
                    let _e5115 = phi_8146_;
                    phi_8147_ = _e5115;
                } else {
                    phi_8147_ = false;
                }
                let _e5117 = phi_8147_;
                continue;
                continuing {
                    phi_1882_ = _e1335;
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
            phi_8179_ = type_36(0u, 16u);
            loop {
                let _e5135 = phi_8179_;
                if (_e5135.member < _e5135.member_1) {
                    phi_8180_ = type_36((_e5135.member + 1u), _e5135.member_1);
                    phi_8203_ = type_36(1u, _e5135.member);
                } else {
                    phi_8180_ = _e5135;
                    phi_8203_ = type_36(0u, type_36().member_1);
                }
                let _e5149 = phi_8180_;
                let _e5151 = phi_8203_;
                if (bitcast<i32>(_e5151.member) != 0i) {
                    let _e5157 = (_e110 + (_e5151.member_1 * 128u));
                    if (_e5157 >= _e1319) {
                        phi_8301_ = false;
                    } else {
                        let _e5160 = hits[_e5157];
                        if ((_e5160 & 2147483648u) == 0u) {
                            phi_8226_ = 4294967295u;
                        } else {
                            phi_8226_ = ((_e5160 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e5167 = phi_8226_;
                        if (_e5167 != 4294967295u) {
                            let _e5171 = ((_e5160 >> bitcast<u32>(10i)) & 3u);
                            let _e5178 = firsts[(2u * _e5171)];
                            let _e5181 = leaves.member[(_e5178 + ((_e5160 >> bitcast<u32>(5i)) & 31u))];
                            let _e5185 = firsts[((2u * _e5171) + 1u)];
                            let _e5188 = leaves.member[(_e5185 + (_e5160 & 31u))];
                            let _e5192 = params.member.member_16;
                            let _e5193 = (_e5127 + _e5167);
                            if (_e5181.member_1 < _e5188.member_1) {
                                phi_8280_ = type_36(_e5181.member_1, _e5188.member_1);
                            } else {
                                phi_8280_ = type_36(_e5188.member_1, _e5181.member_1);
                            }
                            let _e5198 = phi_8280_;
                            if (_e5193 < _e5192) {
                                atomicStore((&output.member[(4u + (2u * _e5193))]), _e5198.member);
                                atomicStore((&output.member[((2u * _e5193) + 5u)]), _e5198.member_1);
                            }
                        }
                        phi_8301_ = true;
                    }
                    let _e5209 = phi_8301_;
                    phi_8302_ = _e5209;
                } else {
                    phi_8302_ = false;
                }
                let _e5211 = phi_8302_;
                continue;
                continuing {
                    phi_8179_ = _e5149;
                    break if !(_e5211);
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
