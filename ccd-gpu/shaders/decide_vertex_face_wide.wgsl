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
    member_18: array<array<u32, 4>, 8>,
}

struct type_12 {
    member: type_10,
}

struct type_16 {
    member: array<u32>,
}

struct type_20 {
    member: array<array<u32, 3>>,
}

struct type_27 {
    member: i32,
    member_1: i32,
}

struct type_28 {
    member: u32,
    member_1: i32,
}

struct type_29 {
    member: u32,
    member_1: u32,
}

struct type_36 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_39 {
    member: array<type_36>,
}

struct type_46 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_51 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_53 {
    member: f64,
    member_1: f64,
}

struct type_61 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_63 {
    member: array<f64, 3>,
    member_1: array<f64, 3>,
}

struct type_66 {
    member: array<type_63>,
}

struct type_72 {
    member: u32,
    member_1: f64,
}

struct type_73 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_77 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_12;
@group(0) @binding(1) 
var<storage> paths: type_39;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_77;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> wide: type_66;
@group(0) @binding(4) 
var<storage> input: type_16;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_77;
@group(0) @binding(3) 
var<storage> elements: type_20;

fn function_() {
    var local: array<array<f64, 3>, 4>;
    var local_1: array<array<f64, 3>, 4>;
    var local_2: array<array<f64, 3>, 4>;
    var local_3: type_51;
    var local_4: type_51;
    var local_5: type_51;
    var local_6: array<type_53, 4>;
    var local_7: array<f64, 4>;
    var local_8: array<f64, 2>;
    var local_9: array<f64, 4>;
    var local_10: array<array<f64, 3>, 4>;
    var local_11: array<array<f64, 3>, 4>;
    var local_12: array<array<f64, 3>, 4>;
    var local_13: array<array<f64, 3>, 4>;
    var local_14: array<f32, 3>;
    var local_15: array<u32, 4>;
    var local_16: array<array<f64, 3>, 4>;
    var local_17: array<array<f64, 3>, 4>;
    var local_18: array<array<f32, 3>, 4>;
    var local_19: array<array<f32, 3>, 4>;
    var local_20: type_61;
    var phi_229_: u32;
    var phi_245_: u32;
    var phi_266_: u32;
    var phi_267_: u32;
    var phi_270_: type_29;
    var phi_271_: type_29;
    var phi_294_: type_29;
    var phi_625_: type_29;
    var phi_626_: type_29;
    var phi_649_: type_29;
    var phi_505_: type_29;
    var phi_506_: type_29;
    var phi_529_: type_29;
    var phi_539_: type_29;
    var phi_540_: type_29;
    var phi_563_: type_29;
    var phi_1106_: f64;
    var phi_1113_: f64;
    var phi_1118_: f64;
    var phi_1125_: f64;
    var phi_1130_: f64;
    var phi_1143_: f64;
    var phi_1150_: f64;
    var phi_1155_: f64;
    var phi_1162_: f64;
    var phi_1167_: f64;
    var phi_1172_: f64;
    var phi_1189_: f64;
    var phi_1196_: f64;
    var phi_1201_: f64;
    var phi_1208_: f64;
    var phi_1213_: f64;
    var phi_1227_: f64;
    var phi_1234_: f64;
    var phi_1239_: f64;
    var phi_1246_: f64;
    var phi_1251_: f64;
    var phi_1256_: f64;
    var phi_1273_: f64;
    var phi_1280_: f64;
    var phi_1285_: f64;
    var phi_1292_: f64;
    var phi_1297_: f64;
    var phi_1311_: f64;
    var phi_1318_: f64;
    var phi_1323_: f64;
    var phi_1330_: f64;
    var phi_1335_: f64;
    var phi_1340_: f64;
    var phi_1377_: f64;
    var phi_1383_: f64;
    var phi_1390_: f64;
    var phi_1397_: f64;
    var phi_1403_: f64;
    var phi_1410_: f64;
    var phi_1416_: f64;
    var phi_1422_: f64;
    var phi_1428_: f64;
    var phi_1435_: f64;
    var phi_1442_: f64;
    var phi_1470_: f64;
    var phi_1475_: f64;
    var phi_1480_: f64;
    var phi_1485_: f64;
    var phi_1490_: f64;
    var phi_1495_: f64;
    var phi_1506_: f64;
    var phi_4060_: f64;
    var phi_4066_: f64;
    var phi_4071_: f64;
    var phi_4077_: f64;
    var phi_4083_: f64;
    var phi_4088_: f64;
    var phi_4093_: f64;
    var phi_4137_: type_27;
    var phi_4140_: f64;
    var phi_4161_: bool;
    var phi_4167_: type_28;
    var phi_4138_: type_27;
    var phi_4181_: type_28;
    var phi_4141_: f64;
    var local_21: f64;
    var phi_4130_: f64;
    var phi_4194_: f64;
    var phi_4200_: f64;
    var phi_4225_: type_29;
    var phi_4228_: u32;
    var phi_4226_: type_29;
    var phi_4251_: type_29;
    var phi_4295_: u32;
    var phi_4296_: u32;
    var phi_4229_: u32;
    var phi_4297_: u32;
    var phi_4317_: type_29;
    var phi_4318_: type_29;
    var phi_4341_: type_29;
    var phi_4395_: f64;
    var phi_4402_: f64;
    var phi_4423_: bool;
    var phi_4424_: bool;
    var phi_4425_: bool;
    var phi_4426_: bool;
    var phi_4427_: bool;
    var phi_4428_: bool;
    var phi_4429_: bool;
    var phi_4430_: bool;
    var phi_4431_: bool;
    var phi_4432_: bool;
    var phi_4433_: bool;
    var phi_4443_: bool;
    var phi_4444_: bool;
    var phi_4445_: bool;
    var phi_4446_: bool;
    var phi_4452_: type_73;
    var phi_4453_: bool;
    var phi_4466_: f64;
    var phi_4479_: type_29;
    var phi_4482_: f64;
    var phi_4484_: f64;
    var phi_4486_: f64;
    var phi_4480_: type_29;
    var phi_4509_: type_29;
    var phi_4536_: f64;
    var phi_4537_: f64;
    var phi_4565_: f64;
    var phi_4581_: f64;
    var phi_4588_: bool;
    var phi_4589_: bool;
    var phi_4590_: bool;
    var phi_4596_: f64;
    var phi_4597_: f64;
    var phi_4598_: bool;
    var phi_4483_: f64;
    var phi_4485_: f64;
    var phi_4487_: f64;
    var phi_4599_: f64;
    var phi_4600_: bool;
    var phi_4601_: bool;
    var local_22: bool;
    var phi_4605_: f64;
    var phi_4606_: f64;
    var phi_4614_: type_29;
    var phi_4617_: f64;
    var phi_4615_: type_29;
    var phi_4640_: type_29;
    var phi_4683_: f64;
    var phi_4693_: f64;
    var phi_4703_: bool;
    var phi_4705_: bool;
    var phi_4710_: f64;
    var phi_4711_: bool;
    var phi_4712_: f64;
    var phi_4713_: bool;
    var phi_4714_: bool;
    var phi_4715_: bool;
    var phi_4716_: f64;
    var phi_4618_: f64;
    var phi_4717_: bool;
    var phi_4718_: bool;
    var phi_4719_: bool;
    var phi_4720_: bool;
    var local_23: bool;
    var phi_4724_: bool;
    var phi_4725_: bool;
    var phi_4729_: bool;
    var phi_4733_: f64;
    var phi_4734_: f64;
    var phi_4736_: type_73;
    var phi_4767_: f64;
    var phi_4774_: f64;
    var phi_4779_: f64;
    var phi_4786_: f64;
    var phi_4791_: f64;
    var phi_4804_: f64;
    var phi_4811_: f64;
    var phi_4816_: f64;
    var phi_4823_: f64;
    var phi_4828_: f64;
    var phi_4833_: f64;
    var phi_4892_: f64;
    var phi_4898_: f64;
    var phi_4903_: f64;
    var phi_4909_: f64;
    var phi_4914_: f64;
    var phi_4928_: f64;
    var phi_4934_: f64;
    var phi_4939_: f64;
    var phi_4945_: f64;
    var phi_4950_: f64;
    var phi_4976_: f64;
    var phi_4983_: f64;
    var phi_4988_: f64;
    var phi_4995_: f64;
    var phi_5000_: f64;
    var phi_5013_: f64;
    var phi_5020_: f64;
    var phi_5025_: f64;
    var phi_5032_: f64;
    var phi_5037_: f64;
    var phi_5042_: f64;
    var phi_5101_: f64;
    var phi_5107_: f64;
    var phi_5112_: f64;
    var phi_5118_: f64;
    var phi_5123_: f64;
    var phi_5137_: f64;
    var phi_5143_: f64;
    var phi_5148_: f64;
    var phi_5154_: f64;
    var phi_5159_: f64;
    var phi_5185_: f64;
    var phi_5192_: f64;
    var phi_5197_: f64;
    var phi_5204_: f64;
    var phi_5209_: f64;
    var phi_5222_: f64;
    var phi_5229_: f64;
    var phi_5234_: f64;
    var phi_5241_: f64;
    var phi_5246_: f64;
    var phi_5251_: f64;
    var phi_5310_: f64;
    var phi_5316_: f64;
    var phi_5321_: f64;
    var phi_5327_: f64;
    var phi_5332_: f64;
    var phi_5346_: f64;
    var phi_5352_: f64;
    var phi_5357_: f64;
    var phi_5363_: f64;
    var phi_5368_: f64;
    var phi_5417_: f64;
    var phi_5423_: f64;
    var phi_5451_: f64;
    var phi_5457_: f64;
    var phi_5462_: u32;
    var phi_5463_: u32;
    var phi_5433_: f64;
    var phi_5439_: f64;
    var phi_5444_: u32;
    var phi_5445_: u32;
    var phi_5464_: u32;
    var phi_5465_: u32;
    var phi_5536_: f64;
    var phi_5548_: f64;
    var phi_5687_: f64;
    var phi_5693_: f64;
    var phi_5700_: f64;
    var phi_5744_: type_29;
    var phi_5747_: bool;
    var phi_5745_: type_29;
    var phi_5770_: type_29;
    var phi_5797_: bool;
    var phi_5798_: bool;
    var phi_5748_: bool;
    var phi_5799_: bool;
    var phi_5800_: bool;
    var local_24: bool;
    var phi_5804_: bool;
    var local_25: bool;
    var phi_5811_: u32;
    var phi_5812_: u32;
    var phi_5813_: bool;
    var phi_5814_: u32;
    var phi_5815_: u32;
    var phi_5816_: bool;
    var phi_5820_: u32;
    var phi_5841_: bool;
    var phi_5842_: bool;
    var phi_5843_: bool;
    var phi_6040_: f64;
    var phi_6047_: f64;
    var phi_6052_: f64;
    var phi_6059_: f64;
    var phi_6064_: f64;
    var phi_6077_: f64;
    var phi_6084_: f64;
    var phi_6089_: f64;
    var phi_6096_: f64;
    var phi_6101_: f64;
    var phi_6106_: f64;
    var phi_6123_: f64;
    var phi_6130_: f64;
    var phi_6135_: f64;
    var phi_6142_: f64;
    var phi_6147_: f64;
    var phi_6161_: f64;
    var phi_6168_: f64;
    var phi_6173_: f64;
    var phi_6180_: f64;
    var phi_6185_: f64;
    var phi_6190_: f64;
    var phi_6207_: f64;
    var phi_6214_: f64;
    var phi_6219_: f64;
    var phi_6226_: f64;
    var phi_6231_: f64;
    var phi_6245_: f64;
    var phi_6252_: f64;
    var phi_6257_: f64;
    var phi_6264_: f64;
    var phi_6269_: f64;
    var phi_6274_: f64;
    var phi_6294_: type_29;
    var phi_6297_: f64;
    var phi_6295_: type_29;
    var phi_6320_: type_29;
    var phi_6495_: bool;
    var phi_6496_: bool;
    var phi_6497_: bool;
    var phi_6498_: bool;
    var phi_6511_: bool;
    var phi_6512_: bool;
    var phi_6513_: bool;
    var phi_6514_: bool;
    var phi_6538_: array<f64, 3>;
    var phi_6539_: bool;
    var phi_6540_: array<f64, 3>;
    var phi_6541_: bool;
    var phi_6542_: bool;
    var phi_6543_: array<f64, 3>;
    var phi_6544_: bool;
    var phi_6545_: bool;
    var phi_6549_: bool;
    var phi_6736_: f64;
    var phi_6738_: f64;
    var phi_6768_: f64;
    var phi_6770_: f64;
    var phi_6800_: f64;
    var phi_6802_: f64;
    var phi_6838_: type_29;
    var phi_6841_: array<f64, 3>;
    var phi_6839_: type_29;
    var phi_6864_: type_29;
    var phi_6931_: array<f64, 3>;
    var phi_6842_: array<f64, 3>;
    var phi_6932_: array<f64, 3>;
    var phi_6939_: f64;
    var phi_6946_: f64;
    var phi_6954_: f64;
    var phi_6999_: type_27;
    var phi_7002_: f64;
    var phi_7023_: bool;
    var phi_7029_: type_28;
    var phi_7000_: type_27;
    var phi_7043_: type_28;
    var phi_7003_: f64;
    var local_26: f64;
    var phi_6992_: f64;
    var phi_7056_: f64;
    var phi_7069_: type_29;
    var phi_7072_: f64;
    var phi_7070_: type_29;
    var phi_7095_: type_29;
    var phi_7146_: f64;
    var phi_7152_: f64;
    var phi_7166_: bool;
    var phi_7167_: bool;
    var phi_7194_: f64;
    var phi_7195_: f64;
    var phi_7196_: f64;
    var phi_7197_: f64;
    var phi_7198_: bool;
    var phi_7073_: f64;
    var phi_7199_: bool;
    var phi_7200_: bool;
    var local_27: bool;
    var local_28: f64;
    var local_29: f64;
    var local_30: f64;
    var phi_7218_: bool;
    var phi_7219_: bool;
    var phi_7220_: bool;
    var phi_7221_: bool;
    var phi_7222_: bool;
    var phi_7223_: bool;
    var phi_7224_: bool;
    var phi_7225_: bool;
    var phi_7226_: bool;
    var phi_7227_: bool;
    var phi_7228_: bool;
    var phi_7229_: bool;
    var phi_7230_: f64;
    var phi_7231_: f64;
    var phi_7232_: bool;
    var phi_7233_: bool;
    var phi_7234_: bool;
    var phi_7235_: bool;
    var phi_7236_: bool;
    var phi_7237_: bool;
    var phi_7238_: f64;
    var phi_7239_: f64;
    var phi_7240_: bool;
    var phi_7241_: bool;
    var phi_7242_: bool;
    var phi_7243_: bool;
    var phi_7244_: bool;
    var phi_7245_: bool;
    var phi_7246_: bool;
    var phi_7247_: f64;
    var phi_6298_: f64;
    var phi_7248_: bool;
    var phi_7249_: bool;
    var phi_7250_: bool;
    var phi_7251_: bool;
    var phi_7252_: bool;
    var phi_7253_: bool;
    var phi_7254_: bool;
    var phi_7255_: bool;
    var local_31: bool;
    var phi_7260_: type_72;
    var phi_7261_: bool;
    var phi_7262_: bool;
    var phi_7263_: bool;
    var phi_7264_: bool;
    var phi_7265_: bool;
    var phi_7266_: bool;
    var phi_7270_: f64;
    var phi_7271_: bool;
    var phi_7272_: bool;
    var phi_7273_: bool;
    var phi_7274_: bool;
    var phi_7275_: bool;
    var phi_7276_: bool;
    var phi_7281_: type_72;
    var phi_7282_: bool;
    var phi_7283_: bool;
    var phi_7284_: bool;
    var phi_7285_: bool;
    var phi_7286_: bool;
    var local_32: f64;
    var phi_7291_: type_72;
    var phi_7292_: bool;
    var phi_7293_: bool;
    var phi_7294_: bool;
    var phi_7295_: bool;
    var local_33: f64;
    var phi_7300_: type_72;
    var phi_7301_: bool;
    var phi_7302_: bool;
    var phi_7303_: bool;
    var phi_7307_: bool;
    var phi_7308_: bool;
    var phi_7312_: bool;
    var phi_7313_: bool;
    var phi_7317_: bool;
    var phi_7318_: bool;
    var local_34: f64;
    var phi_7323_: type_72;
    var phi_7324_: bool;
    var phi_7328_: type_72;
    var phi_7335_: bool;
    var phi_7336_: f64;
    var phi_7337_: bool;
    var phi_7338_: bool;
    var phi_7339_: bool;
    var phi_7340_: f64;
    var phi_7341_: bool;
    var phi_7342_: bool;
    var phi_7343_: bool;
    var phi_7344_: f64;
    var phi_7345_: bool;
    var phi_7346_: bool;
    var phi_7347_: bool;
    var phi_7348_: bool;
    var phi_7352_: bool;
    var phi_7353_: bool;
    var phi_7354_: bool;
    var phi_7355_: f64;
    var phi_7356_: type_73;
    var phi_7357_: bool;
    var phi_7358_: bool;
    var phi_7359_: bool;
    var phi_7360_: bool;
    var local_35: bool;
    var phi_7365_: type_72;
    var phi_7366_: bool;
    var phi_7367_: bool;
    var local_36: f64;
    var phi_7372_: type_72;
    var phi_7373_: bool;
    var local_37: type_73;
    var phi_7379_: type_72;
    var phi_7380_: bool;
    var phi_7384_: type_72;
    var phi_1709_: f64;
    var phi_1716_: f64;
    var phi_1721_: f64;
    var phi_1728_: f64;
    var phi_1733_: f64;
    var phi_1746_: f64;
    var phi_1753_: f64;
    var phi_1758_: f64;
    var phi_1765_: f64;
    var phi_1770_: f64;
    var phi_1775_: f64;
    var phi_1792_: f64;
    var phi_1799_: f64;
    var phi_1804_: f64;
    var phi_1811_: f64;
    var phi_1816_: f64;
    var phi_1830_: f64;
    var phi_1837_: f64;
    var phi_1842_: f64;
    var phi_1849_: f64;
    var phi_1854_: f64;
    var phi_1859_: f64;
    var phi_1876_: f64;
    var phi_1883_: f64;
    var phi_1888_: f64;
    var phi_1895_: f64;
    var phi_1900_: f64;
    var phi_1914_: f64;
    var phi_1921_: f64;
    var phi_1926_: f64;
    var phi_1933_: f64;
    var phi_1938_: f64;
    var phi_1943_: f64;
    var phi_1963_: type_29;
    var phi_1966_: f64;
    var phi_1964_: type_29;
    var phi_1989_: type_29;
    var phi_2164_: bool;
    var phi_2165_: bool;
    var phi_2166_: bool;
    var phi_2167_: bool;
    var phi_2180_: bool;
    var phi_2181_: bool;
    var phi_2182_: bool;
    var phi_2183_: bool;
    var phi_2207_: array<f64, 3>;
    var phi_2208_: bool;
    var phi_2209_: array<f64, 3>;
    var phi_2210_: bool;
    var phi_2211_: bool;
    var phi_2212_: array<f64, 3>;
    var phi_2213_: bool;
    var phi_2214_: bool;
    var phi_2218_: bool;
    var phi_2405_: f64;
    var phi_2407_: f64;
    var phi_2437_: f64;
    var phi_2439_: f64;
    var phi_2469_: f64;
    var phi_2471_: f64;
    var phi_2507_: type_29;
    var phi_2510_: array<f64, 3>;
    var phi_2508_: type_29;
    var phi_2533_: type_29;
    var phi_2600_: array<f64, 3>;
    var phi_2511_: array<f64, 3>;
    var phi_2601_: array<f64, 3>;
    var phi_2608_: f64;
    var phi_2615_: f64;
    var phi_2623_: f64;
    var phi_2668_: type_27;
    var phi_2671_: f64;
    var phi_2692_: bool;
    var phi_2698_: type_28;
    var phi_2669_: type_27;
    var phi_2712_: type_28;
    var phi_2672_: f64;
    var local_38: f64;
    var phi_2661_: f64;
    var phi_2725_: f64;
    var phi_2738_: type_29;
    var phi_2741_: f64;
    var phi_2739_: type_29;
    var phi_2764_: type_29;
    var phi_2815_: f64;
    var phi_2821_: f64;
    var phi_2835_: bool;
    var phi_2836_: bool;
    var phi_2863_: f64;
    var phi_2864_: f64;
    var phi_2865_: f64;
    var phi_2866_: f64;
    var phi_2867_: bool;
    var phi_2742_: f64;
    var phi_2868_: bool;
    var phi_2869_: bool;
    var local_39: bool;
    var local_40: f64;
    var local_41: f64;
    var local_42: f64;
    var phi_2887_: bool;
    var phi_2888_: bool;
    var phi_2889_: bool;
    var phi_2890_: bool;
    var phi_2891_: bool;
    var phi_2892_: bool;
    var phi_2893_: bool;
    var phi_2894_: bool;
    var phi_2895_: bool;
    var phi_2896_: bool;
    var phi_2897_: bool;
    var phi_2898_: bool;
    var phi_2899_: f64;
    var phi_2900_: f64;
    var phi_2901_: bool;
    var phi_2902_: bool;
    var phi_2903_: bool;
    var phi_2904_: bool;
    var phi_2905_: bool;
    var phi_2906_: bool;
    var phi_2907_: f64;
    var phi_2908_: f64;
    var phi_2909_: bool;
    var phi_2910_: bool;
    var phi_2911_: bool;
    var phi_2912_: bool;
    var phi_2913_: bool;
    var phi_2914_: bool;
    var phi_2915_: bool;
    var phi_2916_: f64;
    var phi_1967_: f64;
    var phi_2917_: bool;
    var phi_2918_: bool;
    var phi_2919_: bool;
    var phi_2920_: bool;
    var phi_2921_: bool;
    var phi_2922_: bool;
    var phi_2923_: bool;
    var phi_2924_: bool;
    var local_43: bool;
    var phi_2929_: type_72;
    var phi_2930_: bool;
    var phi_2931_: bool;
    var phi_2932_: bool;
    var phi_2933_: bool;
    var phi_2934_: bool;
    var phi_2935_: bool;
    var phi_2939_: f64;
    var phi_2940_: bool;
    var phi_2941_: bool;
    var phi_2942_: bool;
    var phi_2943_: bool;
    var phi_2944_: bool;
    var phi_2945_: bool;
    var phi_2950_: type_72;
    var phi_2951_: bool;
    var phi_2952_: bool;
    var phi_2953_: bool;
    var phi_2954_: bool;
    var phi_2955_: bool;
    var local_44: f64;
    var phi_2960_: type_72;
    var phi_2961_: bool;
    var phi_2962_: bool;
    var phi_2963_: bool;
    var phi_2964_: bool;
    var local_45: f64;
    var phi_2969_: type_72;
    var phi_2970_: bool;
    var phi_2971_: bool;
    var phi_2972_: bool;
    var phi_2976_: bool;
    var phi_2977_: bool;
    var phi_2981_: bool;
    var phi_2982_: bool;
    var phi_2986_: bool;
    var phi_2987_: bool;
    var local_46: f64;
    var phi_2992_: type_72;
    var phi_2993_: bool;
    var phi_2997_: type_72;
    var phi_3011_: type_29;
    var phi_3012_: type_29;
    var phi_3035_: type_29;
    var phi_3056_: f64;
    var phi_3225_: bool;
    var phi_3226_: bool;
    var phi_3227_: bool;
    var phi_3228_: bool;
    var phi_3241_: bool;
    var phi_3242_: bool;
    var phi_3243_: bool;
    var phi_3244_: bool;
    var phi_3268_: array<f64, 3>;
    var phi_3269_: bool;
    var phi_3270_: array<f64, 3>;
    var phi_3271_: bool;
    var phi_3272_: bool;
    var phi_3273_: array<f64, 3>;
    var phi_3274_: bool;
    var phi_3275_: bool;
    var phi_3279_: bool;
    var phi_3466_: f64;
    var phi_3468_: f64;
    var phi_3498_: f64;
    var phi_3500_: f64;
    var phi_3530_: f64;
    var phi_3532_: f64;
    var phi_3568_: type_29;
    var phi_3571_: array<f64, 3>;
    var phi_3569_: type_29;
    var phi_3594_: type_29;
    var phi_3661_: array<f64, 3>;
    var phi_3572_: array<f64, 3>;
    var phi_3662_: array<f64, 3>;
    var phi_3694_: type_27;
    var phi_3697_: f64;
    var phi_3718_: bool;
    var phi_3724_: type_28;
    var phi_3695_: type_27;
    var phi_3738_: type_28;
    var phi_3698_: f64;
    var local_47: f64;
    var phi_3687_: f64;
    var phi_3751_: f64;
    var phi_3769_: f64;
    var phi_3776_: f64;
    var phi_3781_: f64;
    var phi_3788_: f64;
    var phi_3793_: f64;
    var phi_3806_: f64;
    var phi_3813_: f64;
    var phi_3818_: f64;
    var phi_3825_: f64;
    var phi_3830_: f64;
    var phi_3835_: f64;
    var phi_3852_: f64;
    var phi_3859_: f64;
    var phi_3864_: f64;
    var phi_3871_: f64;
    var phi_3876_: f64;
    var phi_3890_: f64;
    var phi_3897_: f64;
    var phi_3902_: f64;
    var phi_3909_: f64;
    var phi_3914_: f64;
    var phi_3919_: f64;
    var phi_3936_: f64;
    var phi_3943_: f64;
    var phi_3948_: f64;
    var phi_3955_: f64;
    var phi_3960_: f64;
    var phi_3974_: f64;
    var phi_3981_: f64;
    var phi_3986_: f64;
    var phi_3993_: f64;
    var phi_3998_: f64;
    var phi_4003_: f64;
    var phi_4027_: bool;
    var phi_4028_: bool;
    var phi_4029_: bool;
    var local_48: bool;
    var phi_4034_: type_72;
    var phi_4035_: bool;
    var phi_4040_: type_72;
    var phi_4041_: bool;
    var phi_4043_: type_72;
    var phi_4044_: type_72;
    var phi_4045_: bool;
    var phi_4049_: type_72;
    var phi_7388_: type_72;
    var phi_7389_: type_72;
    var phi_7410_: type_46;
    var phi_7433_: u32;
    var phi_7454_: u32;
    var local_49: u32;
    var local_50: f64;
    var local_51: f64;
    var local_52: bool;
    var local_53: bool;
    var local_54: f64;
    var local_55: array<f64, 3>;
    var local_56: f64;
    var local_57: f64;
    var local_58: bool;
    var local_59: bool;
    var local_60: bool;
    var local_61: bool;
    var local_62: bool;
    var local_63: bool;
    var local_64: f64;
    var local_65: f64;
    var local_66: bool;
    var local_67: bool;
    var local_68: bool;
    var local_69: array<f64, 3>;
    var local_70: f64;
    var local_71: f64;
    var local_72: bool;
    var local_73: bool;
    var local_74: bool;
    var local_75: bool;
    var local_76: bool;
    var local_77: bool;
    var local_78: f64;
    var local_79: f64;
    var local_80: bool;
    var local_81: array<f64, 3>;

    let _e113 = id_1;
    let _e114 = n_1;
    let _e115 = lane_1;
    let _e127 = ((_e113.y * _e114.x) + _e113.x);
    let _e130 = (_e114.x * _e114.y);
    let _e132 = params.member.member_15;
    let _e134 = input.member[0u];
    if (_e132 < _e134) {
        phi_229_ = _e132;
    } else {
        phi_229_ = _e134;
    }
    let _e137 = phi_229_;
    let _e138 = (_e137 / 64u);
    if ((_e137 % 64u) > 0u) {
        phi_245_ = (_e138 + 1u);
    } else {
        phi_245_ = _e138;
    }
    let _e143 = phi_245_;
    if (_e143 > _e127) {
        let _e145 = (_e143 - _e127);
        if (_e130 == 0u) {
            return;
        }
        let _e147 = (_e145 / _e130);
        if (_e130 == 0u) {
            return;
        }
        if ((_e145 % _e130) > 0u) {
            phi_266_ = (_e147 + 1u);
        } else {
            phi_266_ = _e147;
        }
        let _e153 = phi_266_;
        phi_267_ = _e153;
    } else {
        phi_267_ = 0u;
    }
    let _e155 = phi_267_;
    phi_270_ = type_29(0u, _e155);
    loop {
        let _e158 = phi_270_;
        if (_e158.member < _e158.member_1) {
            phi_271_ = type_29((_e158.member + 1u), _e158.member_1);
            phi_294_ = type_29(1u, _e158.member);
        } else {
            phi_271_ = _e158;
            phi_294_ = type_29(0u, type_29().member_1);
        }
        let _e172 = phi_271_;
        let _e174 = phi_294_;
        let _e178 = (bitcast<i32>(_e174.member) != 0i);
        if _e178 {
            let _e182 = (((_e127 + (_e174.member_1 * _e130)) * 64u) + _e115);
            let _e184 = params.member.member_8;
            if (_e182 < _e137) {
                let _e199 = (2u * _e182);
                let _e202 = input.member[(4u + _e199)];
                let _e205 = input.member[(_e199 + 5u)];
                let _e207 = elements.member[_e205];
                local_15 = array<u32, 4>(_e202, _e207[0], _e207[1], _e207[2]);
                local_16[0u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[1u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[2u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[3u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[0u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[1u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[2u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[3u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                let _e221 = params.member.member_1;
                if ((_e221 & 8u) != 0u) {
                    let _e267 = paths.member[_e202];
                    let _e269 = paths.member[_e207[0]];
                    let _e275 = paths.member[_e207[1]];
                    let _e277 = paths.member[_e207[2]];
                    local_18 = array<array<f32, 3>, 4>(array<f32, 3>(_e267.member[0], _e267.member[1], _e267.member[2]), array<f32, 3>(_e269.member[0], _e269.member[1], _e269.member[2]), array<f32, 3>(_e275.member[0], _e275.member[1], _e275.member[2]), array<f32, 3>(_e277.member[0], _e277.member[1], _e277.member[2]));
                    local_19 = array<array<f32, 3>, 4>(array<f32, 3>(_e267.member_1[0], _e267.member_1[1], _e267.member_1[2]), array<f32, 3>(_e269.member_1[0], _e269.member_1[1], _e269.member_1[2]), array<f32, 3>(_e275.member_1[0], _e275.member_1[1], _e275.member_1[2]), array<f32, 3>(_e277.member_1[0], _e277.member_1[1], _e277.member_1[2]));
                    phi_505_ = type_29(0u, 4u);
                    loop {
                        let _e317 = phi_505_;
                        if (_e317.member < _e317.member_1) {
                            phi_506_ = type_29((_e317.member + 1u), _e317.member_1);
                            phi_529_ = type_29(1u, _e317.member);
                        } else {
                            phi_506_ = _e317;
                            phi_529_ = type_29(0u, type_29().member_1);
                        }
                        let _e331 = phi_506_;
                        let _e333 = phi_529_;
                        let _e337 = (bitcast<i32>(_e333.member) != 0i);
                        if _e337 {
                            phi_539_ = type_29(0u, 3u);
                            loop {
                                let _e339 = phi_539_;
                                if (_e339.member < _e339.member_1) {
                                    phi_540_ = type_29((_e339.member + 1u), _e339.member_1);
                                    phi_563_ = type_29(1u, _e339.member);
                                } else {
                                    phi_540_ = _e339;
                                    phi_563_ = type_29(0u, type_29().member_1);
                                }
                                let _e353 = phi_540_;
                                let _e355 = phi_563_;
                                let _e359 = (bitcast<i32>(_e355.member) != 0i);
                                if _e359 {
                                    if (_e333.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e355.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e364 = local_18[_e333.member_1][_e355.member_1];
                                    if (_e333.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e355.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    local_16[_e333.member_1][_e355.member_1] = f64(_e364);
                                    if (_e333.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e355.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e374 = local_19[_e333.member_1][_e355.member_1];
                                    if (_e333.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e355.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    local_17[_e333.member_1][_e355.member_1] = f64(_e374);
                                }
                                continue;
                                continuing {
                                    phi_539_ = _e353;
                                    break if !(_e359);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_505_ = _e331;
                            break if !(_e337);
                        }
                    }
                } else {
                    phi_625_ = type_29(0u, 4u);
                    loop {
                        let _e225 = phi_625_;
                        if (_e225.member < _e225.member_1) {
                            phi_626_ = type_29((_e225.member + 1u), _e225.member_1);
                            phi_649_ = type_29(1u, _e225.member);
                        } else {
                            phi_626_ = _e225;
                            phi_649_ = type_29(0u, type_29().member_1);
                        }
                        let _e239 = phi_626_;
                        let _e241 = phi_649_;
                        let _e245 = (bitcast<i32>(_e241.member) != 0i);
                        if _e245 {
                            if (_e241.member_1 < 4u) {
                            } else {
                                return;
                            }
                            let _e248 = local_15[_e241.member_1];
                            let _e250 = wide.member[_e248];
                            if (_e241.member_1 < 4u) {
                            } else {
                                return;
                            }
                            local_16[_e241.member_1] = array<f64, 3>(_e250.member[0], _e250.member[1], _e250.member[2]);
                            if (_e241.member_1 < 4u) {
                            } else {
                                return;
                            }
                            local_17[_e241.member_1] = array<f64, 3>(_e250.member_1[0], _e250.member_1[1], _e250.member_1[2]);
                        }
                        continue;
                        continuing {
                            phi_625_ = _e239;
                            break if !(_e245);
                        }
                    }
                }
                let _e382 = local_16;
                let _e399 = local_17;
                local_20 = type_61(array<array<f64, 3>, 2>(array<f64, 3>((_e382[0][0] - _e382[1][0]), (_e382[0][1] - _e382[1][1]), (_e382[0][2] - _e382[1][2])), array<f64, 3>((_e399[0][0] - _e399[1][0]), (_e399[0][1] - _e399[1][1]), (_e399[0][2] - _e399[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e382[2][0] - _e382[1][0]), (_e382[2][1] - _e382[1][1]), (_e382[2][2] - _e382[1][2])), array<f64, 3>((_e399[2][0] - _e399[1][0]), (_e399[2][1] - _e399[1][1]), (_e399[2][2] - _e399[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e382[3][0] - _e382[1][0]), (_e382[3][1] - _e382[1][1]), (_e382[3][2] - _e382[1][2])), array<f64, 3>((_e399[3][0] - _e399[1][0]), (_e399[3][1] - _e399[1][1]), (_e399[3][2] - _e399[1][2]))), (0.0lf + 0.0lf));
                let _e446 = params.member.member_7;
                let _e454 = bitcast<f64>(((u64(_e446[1]) << bitcast<u64>(32lu)) | u64(_e446[0])));
                let _e455 = f64(0f);
                let _e458 = local_20.member_1[0u];
                let _e464 = local_20.member_2[0u];
                let _e470 = ((_e458[1] * _e464[2]) - (_e458[2] * _e464[1]));
                let _e473 = ((_e458[2] * _e464[0]) - (_e458[0] * _e464[2]));
                let _e476 = ((_e458[0] * _e464[1]) - (_e458[1] * _e464[0]));
                let _e479 = local_20.member_1[1u];
                let _e485 = local_20.member_2[1u];
                let _e491 = ((_e479[1] * _e485[2]) - (_e479[2] * _e485[1]));
                let _e494 = ((_e479[2] * _e485[0]) - (_e479[0] * _e485[2]));
                let _e497 = ((_e479[0] * _e485[1]) - (_e479[1] * _e485[0]));
                let _e500 = local_20.member_1[0u];
                let _e506 = local_20.member_2[1u];
                let _e521 = local_20.member_1[1u];
                let _e527 = local_20.member_2[0u];
                let _e540 = (((_e500[1] * _e506[2]) - (_e500[2] * _e506[1])) + ((_e521[1] * _e527[2]) - (_e521[2] * _e527[1])));
                let _e541 = (((_e500[2] * _e506[0]) - (_e500[0] * _e506[2])) + ((_e521[2] * _e527[0]) - (_e521[0] * _e527[2])));
                let _e542 = (((_e500[0] * _e506[1]) - (_e500[1] * _e506[0])) + ((_e521[0] * _e527[1]) - (_e521[1] * _e527[0])));
                let _e545 = local_20.member[0u];
                let _e553 = (((_e545[0] * _e470) + (_e545[1] * _e473)) + (_e545[2] * _e476));
                let _e556 = local_20.member[1u];
                let _e567 = local_20.member[0u];
                let _e576 = ((((_e556[0] * _e470) + (_e556[1] * _e473)) + (_e556[2] * _e476)) + (((_e567[0] * _e540) + (_e567[1] * _e541)) + (_e567[2] * _e542)));
                let _e579 = local_20.member[0u];
                let _e590 = local_20.member[1u];
                let _e599 = ((((_e579[0] * _e491) + (_e579[1] * _e494)) + (_e579[2] * _e497)) + (((_e590[0] * _e540) + (_e590[1] * _e541)) + (_e590[2] * _e542)));
                let _e602 = local_20.member[1u];
                let _e610 = (((_e602[0] * _e491) + (_e602[1] * _e494)) + (_e602[2] * _e497));
                let _e613 = local_20.member[0u];
                if (_e613[0] < 0.0lf) {
                    phi_1106_ = -(_e613[0]);
                } else {
                    phi_1106_ = _e613[0];
                }
                let _e620 = phi_1106_;
                if (_e613[1] < 0.0lf) {
                    phi_1113_ = -(_e613[1]);
                } else {
                    phi_1113_ = _e613[1];
                }
                let _e624 = phi_1113_;
                if (_e620 > _e624) {
                    phi_1118_ = _e620;
                } else {
                    phi_1118_ = _e624;
                }
                let _e627 = phi_1118_;
                if (_e613[2] < 0.0lf) {
                    phi_1125_ = -(_e613[2]);
                } else {
                    phi_1125_ = _e613[2];
                }
                let _e631 = phi_1125_;
                if (_e627 > _e631) {
                    phi_1130_ = _e627;
                } else {
                    phi_1130_ = _e631;
                }
                let _e634 = phi_1130_;
                let _e637 = local_20.member[1u];
                if (_e637[0] < 0.0lf) {
                    phi_1143_ = -(_e637[0]);
                } else {
                    phi_1143_ = _e637[0];
                }
                let _e644 = phi_1143_;
                if (_e637[1] < 0.0lf) {
                    phi_1150_ = -(_e637[1]);
                } else {
                    phi_1150_ = _e637[1];
                }
                let _e648 = phi_1150_;
                if (_e644 > _e648) {
                    phi_1155_ = _e644;
                } else {
                    phi_1155_ = _e648;
                }
                let _e651 = phi_1155_;
                if (_e637[2] < 0.0lf) {
                    phi_1162_ = -(_e637[2]);
                } else {
                    phi_1162_ = _e637[2];
                }
                let _e655 = phi_1162_;
                if (_e651 > _e655) {
                    phi_1167_ = _e651;
                } else {
                    phi_1167_ = _e655;
                }
                let _e658 = phi_1167_;
                if (_e634 > _e658) {
                    phi_1172_ = _e634;
                } else {
                    phi_1172_ = _e658;
                }
                let _e661 = phi_1172_;
                let _e663 = local_20.member_3;
                let _e664 = (_e661 + _e663);
                let _e667 = local_20.member_1[0u];
                if (_e667[0] < 0.0lf) {
                    phi_1189_ = -(_e667[0]);
                } else {
                    phi_1189_ = _e667[0];
                }
                let _e674 = phi_1189_;
                if (_e667[1] < 0.0lf) {
                    phi_1196_ = -(_e667[1]);
                } else {
                    phi_1196_ = _e667[1];
                }
                let _e678 = phi_1196_;
                if (_e674 > _e678) {
                    phi_1201_ = _e674;
                } else {
                    phi_1201_ = _e678;
                }
                let _e681 = phi_1201_;
                if (_e667[2] < 0.0lf) {
                    phi_1208_ = -(_e667[2]);
                } else {
                    phi_1208_ = _e667[2];
                }
                let _e685 = phi_1208_;
                if (_e681 > _e685) {
                    phi_1213_ = _e681;
                } else {
                    phi_1213_ = _e685;
                }
                let _e688 = phi_1213_;
                let _e691 = local_20.member_1[1u];
                if (_e691[0] < 0.0lf) {
                    phi_1227_ = -(_e691[0]);
                } else {
                    phi_1227_ = _e691[0];
                }
                let _e698 = phi_1227_;
                if (_e691[1] < 0.0lf) {
                    phi_1234_ = -(_e691[1]);
                } else {
                    phi_1234_ = _e691[1];
                }
                let _e702 = phi_1234_;
                if (_e698 > _e702) {
                    phi_1239_ = _e698;
                } else {
                    phi_1239_ = _e702;
                }
                let _e705 = phi_1239_;
                if (_e691[2] < 0.0lf) {
                    phi_1246_ = -(_e691[2]);
                } else {
                    phi_1246_ = _e691[2];
                }
                let _e709 = phi_1246_;
                if (_e705 > _e709) {
                    phi_1251_ = _e705;
                } else {
                    phi_1251_ = _e709;
                }
                let _e712 = phi_1251_;
                if (_e688 > _e712) {
                    phi_1256_ = _e688;
                } else {
                    phi_1256_ = _e712;
                }
                let _e715 = phi_1256_;
                let _e717 = local_20.member_3;
                let _e718 = (_e715 + _e717);
                let _e721 = local_20.member_2[0u];
                if (_e721[0] < 0.0lf) {
                    phi_1273_ = -(_e721[0]);
                } else {
                    phi_1273_ = _e721[0];
                }
                let _e728 = phi_1273_;
                if (_e721[1] < 0.0lf) {
                    phi_1280_ = -(_e721[1]);
                } else {
                    phi_1280_ = _e721[1];
                }
                let _e732 = phi_1280_;
                if (_e728 > _e732) {
                    phi_1285_ = _e728;
                } else {
                    phi_1285_ = _e732;
                }
                let _e735 = phi_1285_;
                if (_e721[2] < 0.0lf) {
                    phi_1292_ = -(_e721[2]);
                } else {
                    phi_1292_ = _e721[2];
                }
                let _e739 = phi_1292_;
                if (_e735 > _e739) {
                    phi_1297_ = _e735;
                } else {
                    phi_1297_ = _e739;
                }
                let _e742 = phi_1297_;
                let _e745 = local_20.member_2[1u];
                if (_e745[0] < 0.0lf) {
                    phi_1311_ = -(_e745[0]);
                } else {
                    phi_1311_ = _e745[0];
                }
                let _e752 = phi_1311_;
                if (_e745[1] < 0.0lf) {
                    phi_1318_ = -(_e745[1]);
                } else {
                    phi_1318_ = _e745[1];
                }
                let _e756 = phi_1318_;
                if (_e752 > _e756) {
                    phi_1323_ = _e752;
                } else {
                    phi_1323_ = _e756;
                }
                let _e759 = phi_1323_;
                if (_e745[2] < 0.0lf) {
                    phi_1330_ = -(_e745[2]);
                } else {
                    phi_1330_ = _e745[2];
                }
                let _e763 = phi_1330_;
                if (_e759 > _e763) {
                    phi_1335_ = _e759;
                } else {
                    phi_1335_ = _e763;
                }
                let _e766 = phi_1335_;
                if (_e742 > _e766) {
                    phi_1340_ = _e742;
                } else {
                    phi_1340_ = _e766;
                }
                let _e769 = phi_1340_;
                let _e771 = local_20.member_3;
                let _e772 = (_e769 + _e771);
                let _e773 = f64(1f);
                let _e774 = f64(8f);
                let _e776 = ((_e718 * _e774) * _e772);
                let _e784 = local_20.member_3;
                if (_e470 < 0.0lf) {
                    phi_1377_ = -(_e470);
                } else {
                    phi_1377_ = _e470;
                }
                let _e804 = phi_1377_;
                if (_e473 < 0.0lf) {
                    phi_1383_ = -(_e473);
                } else {
                    phi_1383_ = _e473;
                }
                let _e808 = phi_1383_;
                if (_e476 < 0.0lf) {
                    phi_1390_ = -(_e476);
                } else {
                    phi_1390_ = _e476;
                }
                let _e813 = phi_1390_;
                let _e814 = ((_e804 + _e808) + _e813);
                if (_e491 < 0.0lf) {
                    phi_1397_ = -(_e491);
                } else {
                    phi_1397_ = _e491;
                }
                let _e818 = phi_1397_;
                if (_e494 < 0.0lf) {
                    phi_1403_ = -(_e494);
                } else {
                    phi_1403_ = _e494;
                }
                let _e822 = phi_1403_;
                if (_e497 < 0.0lf) {
                    phi_1410_ = -(_e497);
                } else {
                    phi_1410_ = _e497;
                }
                let _e827 = phi_1410_;
                let _e828 = ((_e818 + _e822) + _e827);
                if (_e814 > _e828) {
                    phi_1416_ = _e814;
                } else {
                    phi_1416_ = _e828;
                }
                let _e831 = phi_1416_;
                if (_e540 < 0.0lf) {
                    phi_1422_ = -(_e540);
                } else {
                    phi_1422_ = _e540;
                }
                let _e835 = phi_1422_;
                if (_e541 < 0.0lf) {
                    phi_1428_ = -(_e541);
                } else {
                    phi_1428_ = _e541;
                }
                let _e839 = phi_1428_;
                if (_e542 < 0.0lf) {
                    phi_1435_ = -(_e542);
                } else {
                    phi_1435_ = _e542;
                }
                let _e844 = phi_1435_;
                let _e846 = (((_e835 + _e839) + _e844) * f64(0.5f));
                if (_e831 > _e846) {
                    phi_1442_ = _e831;
                } else {
                    phi_1442_ = _e846;
                }
                let _e849 = phi_1442_;
                let _e855 = local_20.member_3;
                let _e869 = (((((_e664 * _e774) * _e776) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e784 * f64(19f)) * ((_e664 * (_e718 + _e772)) + (_e718 * _e772)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e773 + _e664) * ((_e773 + _e718) * (_e773 + _e772)))));
                let _e870 = f64(3f);
                let _e871 = (_e553 * _e870);
                let _e872 = (_e610 * _e870);
                if (_e871 < _e872) {
                    phi_1470_ = _e871;
                } else {
                    phi_1470_ = _e872;
                }
                let _e875 = phi_1470_;
                if (_e576 < _e599) {
                    phi_1475_ = _e576;
                } else {
                    phi_1475_ = _e599;
                }
                let _e878 = phi_1475_;
                if (_e875 < _e878) {
                    phi_1480_ = _e875;
                } else {
                    phi_1480_ = _e878;
                }
                let _e881 = phi_1480_;
                if (_e871 > _e872) {
                    phi_1485_ = _e871;
                } else {
                    phi_1485_ = _e872;
                }
                let _e884 = phi_1485_;
                if (_e576 > _e599) {
                    phi_1490_ = _e576;
                } else {
                    phi_1490_ = _e599;
                }
                let _e887 = phi_1490_;
                if (_e884 > _e887) {
                    phi_1495_ = _e884;
                } else {
                    phi_1495_ = _e887;
                }
                let _e890 = phi_1495_;
                let _e896 = -(_e890);
                if (_e881 > _e896) {
                    phi_1506_ = _e881;
                } else {
                    phi_1506_ = _e896;
                }
                let _e899 = phi_1506_;
                if ((_e899 - (_e869 + ((_e454 * (((_e849 + (_e776 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e855 * f64(6f)) * (_e718 + _e772))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e773 + _e718) * (_e773 + _e772))))) * f64((3f * 1.0001f))))) > _e455) {
                    phi_7389_ = type_72(0u, type_72().member_1);
                } else {
                    if (_e454 > _e455) {
                        let _e3236 = f64(1f);
                        let _e3240 = local_20.member[0u];
                        let _e3246 = local_20.member_1[0u];
                        let _e3252 = local_20.member_2[0u];
                        local_12 = array<array<f64, 3>, 4>(_e3240, array<f64, 3>((_e3240[0] - _e3246[0]), (_e3240[1] - _e3246[1]), (_e3240[2] - _e3246[2])), array<f64, 3>((_e3240[0] - _e3252[0]), (_e3240[1] - _e3252[1]), (_e3240[2] - _e3252[2])), _e3240);
                        let _e3267 = local_20.member[1u];
                        let _e3273 = local_20.member_1[1u];
                        let _e3279 = local_20.member_2[1u];
                        local_13 = array<array<f64, 3>, 4>(_e3267, array<f64, 3>((_e3267[0] - _e3273[0]), (_e3267[1] - _e3273[1]), (_e3267[2] - _e3273[2])), array<f64, 3>((_e3267[0] - _e3279[0]), (_e3267[1] - _e3279[1]), (_e3267[2] - _e3279[2])), _e3267);
                        let _e3294 = local_20.member[0u];
                        if (_e3294[0] < 0.0lf) {
                            phi_1709_ = -(_e3294[0]);
                        } else {
                            phi_1709_ = _e3294[0];
                        }
                        let _e3301 = phi_1709_;
                        if (_e3294[1] < 0.0lf) {
                            phi_1716_ = -(_e3294[1]);
                        } else {
                            phi_1716_ = _e3294[1];
                        }
                        let _e3305 = phi_1716_;
                        if (_e3301 > _e3305) {
                            phi_1721_ = _e3301;
                        } else {
                            phi_1721_ = _e3305;
                        }
                        let _e3308 = phi_1721_;
                        if (_e3294[2] < 0.0lf) {
                            phi_1728_ = -(_e3294[2]);
                        } else {
                            phi_1728_ = _e3294[2];
                        }
                        let _e3312 = phi_1728_;
                        if (_e3308 > _e3312) {
                            phi_1733_ = _e3308;
                        } else {
                            phi_1733_ = _e3312;
                        }
                        let _e3315 = phi_1733_;
                        let _e3318 = local_20.member[1u];
                        if (_e3318[0] < 0.0lf) {
                            phi_1746_ = -(_e3318[0]);
                        } else {
                            phi_1746_ = _e3318[0];
                        }
                        let _e3325 = phi_1746_;
                        if (_e3318[1] < 0.0lf) {
                            phi_1753_ = -(_e3318[1]);
                        } else {
                            phi_1753_ = _e3318[1];
                        }
                        let _e3329 = phi_1753_;
                        if (_e3325 > _e3329) {
                            phi_1758_ = _e3325;
                        } else {
                            phi_1758_ = _e3329;
                        }
                        let _e3332 = phi_1758_;
                        if (_e3318[2] < 0.0lf) {
                            phi_1765_ = -(_e3318[2]);
                        } else {
                            phi_1765_ = _e3318[2];
                        }
                        let _e3336 = phi_1765_;
                        if (_e3332 > _e3336) {
                            phi_1770_ = _e3332;
                        } else {
                            phi_1770_ = _e3336;
                        }
                        let _e3339 = phi_1770_;
                        if (_e3315 > _e3339) {
                            phi_1775_ = _e3315;
                        } else {
                            phi_1775_ = _e3339;
                        }
                        let _e3342 = phi_1775_;
                        let _e3344 = local_20.member_3;
                        let _e3348 = local_20.member_1[0u];
                        if (_e3348[0] < 0.0lf) {
                            phi_1792_ = -(_e3348[0]);
                        } else {
                            phi_1792_ = _e3348[0];
                        }
                        let _e3355 = phi_1792_;
                        if (_e3348[1] < 0.0lf) {
                            phi_1799_ = -(_e3348[1]);
                        } else {
                            phi_1799_ = _e3348[1];
                        }
                        let _e3359 = phi_1799_;
                        if (_e3355 > _e3359) {
                            phi_1804_ = _e3355;
                        } else {
                            phi_1804_ = _e3359;
                        }
                        let _e3362 = phi_1804_;
                        if (_e3348[2] < 0.0lf) {
                            phi_1811_ = -(_e3348[2]);
                        } else {
                            phi_1811_ = _e3348[2];
                        }
                        let _e3366 = phi_1811_;
                        if (_e3362 > _e3366) {
                            phi_1816_ = _e3362;
                        } else {
                            phi_1816_ = _e3366;
                        }
                        let _e3369 = phi_1816_;
                        let _e3372 = local_20.member_1[1u];
                        if (_e3372[0] < 0.0lf) {
                            phi_1830_ = -(_e3372[0]);
                        } else {
                            phi_1830_ = _e3372[0];
                        }
                        let _e3379 = phi_1830_;
                        if (_e3372[1] < 0.0lf) {
                            phi_1837_ = -(_e3372[1]);
                        } else {
                            phi_1837_ = _e3372[1];
                        }
                        let _e3383 = phi_1837_;
                        if (_e3379 > _e3383) {
                            phi_1842_ = _e3379;
                        } else {
                            phi_1842_ = _e3383;
                        }
                        let _e3386 = phi_1842_;
                        if (_e3372[2] < 0.0lf) {
                            phi_1849_ = -(_e3372[2]);
                        } else {
                            phi_1849_ = _e3372[2];
                        }
                        let _e3390 = phi_1849_;
                        if (_e3386 > _e3390) {
                            phi_1854_ = _e3386;
                        } else {
                            phi_1854_ = _e3390;
                        }
                        let _e3393 = phi_1854_;
                        if (_e3369 > _e3393) {
                            phi_1859_ = _e3369;
                        } else {
                            phi_1859_ = _e3393;
                        }
                        let _e3396 = phi_1859_;
                        let _e3398 = local_20.member_3;
                        let _e3402 = local_20.member_2[0u];
                        if (_e3402[0] < 0.0lf) {
                            phi_1876_ = -(_e3402[0]);
                        } else {
                            phi_1876_ = _e3402[0];
                        }
                        let _e3409 = phi_1876_;
                        if (_e3402[1] < 0.0lf) {
                            phi_1883_ = -(_e3402[1]);
                        } else {
                            phi_1883_ = _e3402[1];
                        }
                        let _e3413 = phi_1883_;
                        if (_e3409 > _e3413) {
                            phi_1888_ = _e3409;
                        } else {
                            phi_1888_ = _e3413;
                        }
                        let _e3416 = phi_1888_;
                        if (_e3402[2] < 0.0lf) {
                            phi_1895_ = -(_e3402[2]);
                        } else {
                            phi_1895_ = _e3402[2];
                        }
                        let _e3420 = phi_1895_;
                        if (_e3416 > _e3420) {
                            phi_1900_ = _e3416;
                        } else {
                            phi_1900_ = _e3420;
                        }
                        let _e3423 = phi_1900_;
                        let _e3426 = local_20.member_2[1u];
                        if (_e3426[0] < 0.0lf) {
                            phi_1914_ = -(_e3426[0]);
                        } else {
                            phi_1914_ = _e3426[0];
                        }
                        let _e3433 = phi_1914_;
                        if (_e3426[1] < 0.0lf) {
                            phi_1921_ = -(_e3426[1]);
                        } else {
                            phi_1921_ = _e3426[1];
                        }
                        let _e3437 = phi_1921_;
                        if (_e3433 > _e3437) {
                            phi_1926_ = _e3433;
                        } else {
                            phi_1926_ = _e3437;
                        }
                        let _e3440 = phi_1926_;
                        if (_e3426[2] < 0.0lf) {
                            phi_1933_ = -(_e3426[2]);
                        } else {
                            phi_1933_ = _e3426[2];
                        }
                        let _e3444 = phi_1933_;
                        if (_e3440 > _e3444) {
                            phi_1938_ = _e3440;
                        } else {
                            phi_1938_ = _e3444;
                        }
                        let _e3447 = phi_1938_;
                        if (_e3423 > _e3447) {
                            phi_1943_ = _e3423;
                        } else {
                            phi_1943_ = _e3447;
                        }
                        let _e3450 = phi_1943_;
                        let _e3452 = local_20.member_3;
                        let _e3460 = local_20.member_3;
                        phi_1963_ = type_29(0u, 48u);
                        phi_1966_ = f64(0f);
                        loop {
                            let _e3469 = phi_1963_;
                            let _e3471 = phi_1966_;
                            local_79 = _e3471;
                            local_44 = _e3471;
                            local_45 = _e3471;
                            local_46 = _e3471;
                            if (_e3469.member < _e3469.member_1) {
                                phi_1964_ = type_29((_e3469.member + 1u), _e3469.member_1);
                                phi_1989_ = type_29(1u, _e3469.member);
                            } else {
                                phi_1964_ = _e3469;
                                phi_1989_ = type_29(0u, type_29().member_1);
                            }
                            let _e3485 = phi_1964_;
                            let _e3487 = phi_1989_;
                            if (bitcast<i32>(_e3487.member) != 0i) {
                                let _e3493 = local_20.member[0u];
                                let _e3499 = local_20.member[1u];
                                let _e3509 = (_e3493[0] + ((_e3499[0] - _e3493[0]) * _e3471));
                                let _e3510 = (_e3493[1] + ((_e3499[1] - _e3493[1]) * _e3471));
                                let _e3511 = (_e3493[2] + ((_e3499[2] - _e3493[2]) * _e3471));
                                let _e3514 = local_20.member_1[0u];
                                let _e3520 = local_20.member_1[1u];
                                let _e3530 = (_e3514[0] + ((_e3520[0] - _e3514[0]) * _e3471));
                                let _e3531 = (_e3514[1] + ((_e3520[1] - _e3514[1]) * _e3471));
                                let _e3532 = (_e3514[2] + ((_e3520[2] - _e3514[2]) * _e3471));
                                let _e3535 = local_20.member_2[0u];
                                let _e3541 = local_20.member_2[1u];
                                let _e3551 = (_e3535[0] + ((_e3541[0] - _e3535[0]) * _e3471));
                                let _e3552 = (_e3535[1] + ((_e3541[1] - _e3535[1]) * _e3471));
                                let _e3553 = (_e3535[2] + ((_e3541[2] - _e3535[2]) * _e3471));
                                let _e3558 = (((_e3530 * _e3530) + (_e3531 * _e3531)) + (_e3532 * _e3532));
                                let _e3563 = (((_e3530 * _e3551) + (_e3531 * _e3552)) + (_e3532 * _e3553));
                                let _e3568 = (((_e3551 * _e3551) + (_e3552 * _e3552)) + (_e3553 * _e3553));
                                let _e3573 = (((_e3509 * _e3530) + (_e3510 * _e3531)) + (_e3511 * _e3532));
                                let _e3578 = (((_e3509 * _e3551) + (_e3510 * _e3552)) + (_e3511 * _e3553));
                                let _e3581 = ((_e3558 * _e3568) - (_e3563 * _e3563));
                                let _e3582 = f64(0f);
                                let _e3587 = (((_e3573 * _e3568) - (_e3578 * _e3563)) / _e3581);
                                let _e3591 = (((_e3578 * _e3558) - (_e3573 * _e3563)) / _e3581);
                                if (_e3587 >= _e3582) {
                                    if (_e3591 >= _e3582) {
                                        phi_2164_ = ((_e3587 + _e3591) <= f64(1f));
                                        phi_2165_ = false;
                                    } else {
                                        phi_2164_ = bool();
                                        phi_2165_ = true;
                                    }
                                    let _e3597 = phi_2164_;
                                    let _e3599 = phi_2165_;
                                    phi_2166_ = _e3597;
                                    phi_2167_ = _e3599;
                                } else {
                                    phi_2166_ = bool();
                                    phi_2167_ = true;
                                }
                                let _e3601 = phi_2166_;
                                let _e3603 = phi_2167_;
                                if _e3603 {
                                    let _e3604 = (_e3581 > _e3582);
                                    if _e3604 {
                                        phi_2180_ = false;
                                    } else {
                                        phi_2180_ = true;
                                    }
                                    let _e3606 = phi_2180_;
                                    phi_2181_ = false;
                                    phi_2182_ = _e3606;
                                    phi_2183_ = _e3604;
                                } else {
                                    phi_2181_ = true;
                                    phi_2182_ = false;
                                    phi_2183_ = false;
                                }
                                let _e3608 = phi_2181_;
                                let _e3610 = phi_2182_;
                                let _e3612 = phi_2183_;
                                if _e3608 {
                                    if (_e3581 > _e3582) {
                                        if _e3601 {
                                            phi_2207_ = array<f64, 3>((_e3509 - ((_e3530 * _e3587) + (_e3551 * _e3591))), (_e3510 - ((_e3531 * _e3587) + (_e3552 * _e3591))), (_e3511 - ((_e3532 * _e3587) + (_e3553 * _e3591))));
                                            phi_2208_ = false;
                                        } else {
                                            phi_2207_ = array<f64, 3>();
                                            phi_2208_ = true;
                                        }
                                        let _e3628 = phi_2207_;
                                        let _e3630 = phi_2208_;
                                        phi_2209_ = _e3628;
                                        phi_2210_ = false;
                                        phi_2211_ = _e3630;
                                    } else {
                                        phi_2209_ = array<f64, 3>();
                                        phi_2210_ = true;
                                        phi_2211_ = false;
                                    }
                                    let _e3632 = phi_2209_;
                                    let _e3634 = phi_2210_;
                                    let _e3636 = phi_2211_;
                                    phi_2212_ = _e3632;
                                    phi_2213_ = _e3634;
                                    phi_2214_ = _e3636;
                                } else {
                                    phi_2212_ = array<f64, 3>();
                                    phi_2213_ = _e3610;
                                    phi_2214_ = _e3612;
                                }
                                let _e3638 = phi_2212_;
                                let _e3640 = phi_2213_;
                                let _e3642 = phi_2214_;
                                if _e3640 {
                                    phi_2218_ = true;
                                } else {
                                    phi_2218_ = _e3642;
                                }
                                let _e3644 = phi_2218_;
                                if _e3644 {
                                    let _e3645 = (_e3509 - _e3530);
                                    let _e3646 = (_e3510 - _e3531);
                                    let _e3647 = (_e3511 - _e3532);
                                    let _e3648 = (_e3551 - _e3530);
                                    let _e3649 = (_e3552 - _e3531);
                                    let _e3650 = (_e3553 - _e3532);
                                    let _e3661 = ((((_e3645 * _e3648) + (_e3646 * _e3649)) + (_e3647 * _e3650)) / (((_e3648 * _e3648) + (_e3649 * _e3649)) + (_e3650 * _e3650)));
                                    if (_e3661 > f64(0f)) {
                                        if (_e3661 < f64(1f)) {
                                            phi_2405_ = _e3661;
                                        } else {
                                            phi_2405_ = f64(1f);
                                        }
                                        let _e3669 = phi_2405_;
                                        phi_2407_ = _e3669;
                                    } else {
                                        phi_2407_ = f64(0f);
                                    }
                                    let _e3671 = phi_2407_;
                                    let _e3675 = (_e3645 - (_e3648 * _e3671));
                                    let _e3676 = (_e3646 - (_e3649 * _e3671));
                                    let _e3677 = (_e3647 - (_e3650 * _e3671));
                                    let _e3688 = ((((_e3509 * _e3530) + (_e3510 * _e3531)) + (_e3511 * _e3532)) / (((_e3530 * _e3530) + (_e3531 * _e3531)) + (_e3532 * _e3532)));
                                    if (_e3688 > f64(0f)) {
                                        if (_e3688 < f64(1f)) {
                                            phi_2437_ = _e3688;
                                        } else {
                                            phi_2437_ = f64(1f);
                                        }
                                        let _e3696 = phi_2437_;
                                        phi_2439_ = _e3696;
                                    } else {
                                        phi_2439_ = f64(0f);
                                    }
                                    let _e3698 = phi_2439_;
                                    let _e3715 = ((((_e3509 * _e3551) + (_e3510 * _e3552)) + (_e3511 * _e3553)) / (((_e3551 * _e3551) + (_e3552 * _e3552)) + (_e3553 * _e3553)));
                                    if (_e3715 > f64(0f)) {
                                        if (_e3715 < f64(1f)) {
                                            phi_2469_ = _e3715;
                                        } else {
                                            phi_2469_ = f64(1f);
                                        }
                                        let _e3723 = phi_2469_;
                                        phi_2471_ = _e3723;
                                    } else {
                                        phi_2471_ = f64(0f);
                                    }
                                    let _e3725 = phi_2471_;
                                    local_11[0u] = array<f64, 3>((_e3509 - (_e3530 * _e3698)), (_e3510 - (_e3531 * _e3698)), (_e3511 - (_e3532 * _e3698)));
                                    local_11[1u] = array<f64, 3>((_e3509 - (_e3551 * _e3725)), (_e3510 - (_e3552 * _e3725)), (_e3511 - (_e3553 * _e3725)));
                                    local_11[2u] = array<f64, 3>(_e3675, _e3676, _e3677);
                                    local_11[3u] = array<f64, 3>(_e3675, _e3676, _e3677);
                                    let _e3741 = local_11[0u];
                                    phi_2507_ = type_29(1u, 4u);
                                    phi_2510_ = array<f64, 3>(_e3741[0], _e3741[1], _e3741[2]);
                                    loop {
                                        let _e3747 = phi_2507_;
                                        let _e3749 = phi_2510_;
                                        local_69 = _e3749;
                                        if (_e3747.member < _e3747.member_1) {
                                            phi_2508_ = type_29((_e3747.member + 1u), _e3747.member_1);
                                            phi_2533_ = type_29(1u, _e3747.member);
                                        } else {
                                            phi_2508_ = _e3747;
                                            phi_2533_ = type_29(0u, type_29().member_1);
                                        }
                                        let _e3763 = phi_2508_;
                                        let _e3765 = phi_2533_;
                                        let _e3769 = (bitcast<i32>(_e3765.member) != 0i);
                                        if _e3769 {
                                            if (_e3765.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3772 = local_11[_e3765.member_1];
                                            if (_e3765.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3778 = local_11[_e3765.member_1];
                                            if ((((_e3772[0] * _e3778[0]) + (_e3772[1] * _e3778[1])) + (_e3772[2] * _e3778[2])) < (((_e3749[0] * _e3749[0]) + (_e3749[1] * _e3749[1])) + (_e3749[2] * _e3749[2]))) {
                                                if (_e3765.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3801 = local_11[_e3765.member_1];
                                                phi_2600_ = array<f64, 3>(_e3801[0], _e3801[1], _e3801[2]);
                                            } else {
                                                phi_2600_ = _e3749;
                                            }
                                            let _e3807 = phi_2600_;
                                            phi_2511_ = _e3807;
                                        } else {
                                            phi_2511_ = array<f64, 3>();
                                        }
                                        let _e3809 = phi_2511_;
                                        continue;
                                        continuing {
                                            phi_2507_ = _e3763;
                                            phi_2510_ = _e3809;
                                            break if !(_e3769);
                                        }
                                    }
                                    let _e5532 = local_69;
                                    phi_2601_ = _e5532;
                                } else {
                                    phi_2601_ = _e3638;
                                }
                                let _e3812 = phi_2601_;
                                if (_e3812[0] < 0.0lf) {
                                    phi_2608_ = -(_e3812[0]);
                                } else {
                                    phi_2608_ = _e3812[0];
                                }
                                let _e3817 = phi_2608_;
                                if (_e3812[1] < 0.0lf) {
                                    phi_2615_ = -(_e3812[1]);
                                } else {
                                    phi_2615_ = _e3812[1];
                                }
                                let _e3822 = phi_2615_;
                                if (_e3812[2] < 0.0lf) {
                                    phi_2623_ = -(_e3812[2]);
                                } else {
                                    phi_2623_ = _e3812[2];
                                }
                                let _e3828 = phi_2623_;
                                let _e3829 = ((_e3817 + _e3822) + _e3828);
                                if (_e3829 > f64(0f)) {
                                    if ((bitcast<u64>(_e3829) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e3835 = (f64(1f) / _e3829);
                                        let _e3837 = (_e3812[0] * _e3835);
                                        let _e3839 = (_e3812[1] * _e3835);
                                        let _e3841 = (_e3812[2] * _e3835);
                                        let _e3846 = (((_e3837 * _e3837) + (_e3839 * _e3839)) + (_e3841 * _e3841));
                                        if (_e3846 <= 2.2250738585072014e-308lf) {
                                            if (_e3846 > 0.0lf) {
                                                phi_2661_ = (bitcast<f64>(((4503599627370496lu >> bitcast<u64>(1lu)) + 2303426169912950784lu)) * 2.0lf);
                                            } else {
                                                phi_2661_ = 0.0lf;
                                            }
                                            let _e3909 = phi_2661_;
                                            phi_2725_ = _e3909;
                                        } else {
                                            phi_2668_ = type_27(0i, 5i);
                                            phi_2671_ = bitcast<f64>(((bitcast<u64>(_e3846) >> bitcast<u64>(1lu)) + 2303426169912950784lu));
                                            loop {
                                                let _e3854 = phi_2668_;
                                                let _e3856 = phi_2671_;
                                                local_38 = _e3856;
                                                if (_e3854.member < _e3854.member_1) {
                                                    let _e3864 = (_e3854.member + 1i);
                                                    if ((false == (_e3864 > _e3854.member)) != false) {
                                                        phi_2692_ = true;
                                                    } else {
                                                        phi_2692_ = false;
                                                    }
                                                    let _e3869 = phi_2692_;
                                                    if _e3869 {
                                                        phi_2698_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_2698_ = type_28(1u, _e3864);
                                                    }
                                                    let _e3875 = phi_2698_;
                                                    if (bitcast<i32>(_e3875.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2669_ = type_27(_e3875.member_1, _e3854.member_1);
                                                    phi_2712_ = type_28(1u, _e3854.member);
                                                } else {
                                                    phi_2669_ = _e3854;
                                                    phi_2712_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e3885 = phi_2669_;
                                                let _e3887 = phi_2712_;
                                                let _e3890 = (bitcast<i32>(_e3887.member) != 0i);
                                                if _e3890 {
                                                    phi_2672_ = (0.5lf * (_e3856 + (_e3846 / _e3856)));
                                                } else {
                                                    phi_2672_ = f64();
                                                }
                                                let _e3895 = phi_2672_;
                                                continue;
                                                continuing {
                                                    phi_2668_ = _e3885;
                                                    phi_2671_ = _e3895;
                                                    break if !(_e3890);
                                                }
                                            }
                                            let _e3900 = local_38;
                                            phi_2725_ = (_e3900 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e3911 = phi_2725_;
                                        phi_2738_ = type_29(0u, 4u);
                                        phi_2741_ = f64(2f);
                                        loop {
                                            let _e3923 = phi_2738_;
                                            let _e3925 = phi_2741_;
                                            local_40 = _e3925;
                                            local_41 = _e3925;
                                            local_42 = _e3925;
                                            local_70 = _e3925;
                                            local_71 = _e3925;
                                            if (_e3923.member < _e3923.member_1) {
                                                phi_2739_ = type_29((_e3923.member + 1u), _e3923.member_1);
                                                phi_2764_ = type_29(1u, _e3923.member);
                                            } else {
                                                phi_2739_ = _e3923;
                                                phi_2764_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e3939 = phi_2739_;
                                            let _e3941 = phi_2764_;
                                            if (bitcast<i32>(_e3941.member) != 0i) {
                                                if (_e3941.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3948 = local_12[_e3941.member_1];
                                                let _e3956 = (((_e3837 * _e3948[0]) + (_e3839 * _e3948[1])) + (_e3841 * _e3948[2]));
                                                if (_e3941.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3959 = local_13[_e3941.member_1];
                                                let _e3967 = (((_e3837 * _e3959[0]) + (_e3839 * _e3959[1])) + (_e3841 * _e3959[2]));
                                                if (_e3956 < 0.0lf) {
                                                    phi_2815_ = -(_e3956);
                                                } else {
                                                    phi_2815_ = _e3956;
                                                }
                                                let _e3971 = phi_2815_;
                                                if (_e3967 < 0.0lf) {
                                                    phi_2821_ = -(_e3967);
                                                } else {
                                                    phi_2821_ = _e3967;
                                                }
                                                let _e3975 = phi_2821_;
                                                let _e3980 = (((((((((_e3342 + _e3344) + (_e3396 + _e3398)) + (_e3450 + _e3452)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3460 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e454 * _e3911) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e3971 + _e3975) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e3956 > _e3980) {
                                                    if (_e3967 > _e3980) {
                                                        phi_2835_ = false;
                                                    } else {
                                                        phi_2835_ = true;
                                                    }
                                                    let _e3984 = phi_2835_;
                                                    phi_2836_ = _e3984;
                                                } else {
                                                    phi_2836_ = true;
                                                }
                                                let _e3986 = phi_2836_;
                                                if _e3986 {
                                                    let _e3990 = ((_e3956 + ((_e3967 - _e3956) * _e3471)) > _e3980);
                                                    if _e3990 {
                                                        if (_e3967 < _e3956) {
                                                            let _e3999 = (((_e3956 - _e3980) / (_e3956 - _e3967)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                            if (_e3925 < _e3999) {
                                                                phi_2863_ = _e3925;
                                                            } else {
                                                                phi_2863_ = _e3999;
                                                            }
                                                            let _e4002 = phi_2863_;
                                                            phi_2864_ = _e4002;
                                                        } else {
                                                            phi_2864_ = _e3925;
                                                        }
                                                        let _e4004 = phi_2864_;
                                                        phi_2865_ = _e4004;
                                                    } else {
                                                        phi_2865_ = f64();
                                                    }
                                                    let _e4006 = phi_2865_;
                                                    phi_2866_ = _e4006;
                                                    phi_2867_ = _e3990;
                                                } else {
                                                    phi_2866_ = _e3925;
                                                    phi_2867_ = true;
                                                }
                                                let _e4008 = phi_2866_;
                                                let _e4010 = phi_2867_;
                                                phi_2742_ = _e4008;
                                                phi_2868_ = _e4010;
                                                phi_2869_ = false;
                                            } else {
                                                phi_2742_ = f64();
                                                phi_2868_ = false;
                                                phi_2869_ = true;
                                            }
                                            let _e4012 = phi_2742_;
                                            let _e4014 = phi_2868_;
                                            let _e4016 = phi_2869_;
                                            local_39 = _e4016;
                                            continue;
                                            continuing {
                                                phi_2738_ = _e3939;
                                                phi_2741_ = _e4012;
                                                break if !(_e4014);
                                            }
                                        }
                                        let _e4019 = local_39;
                                        if _e4019 {
                                            let _e4021 = local_40;
                                            let _e4022 = (_e4021 > _e3236);
                                            if _e4022 {
                                                phi_2891_ = false;
                                                phi_2892_ = false;
                                                phi_2893_ = false;
                                            } else {
                                                let _e4024 = local_41;
                                                if (_e4024 > _e3471) {
                                                    let _e4027 = local_42;
                                                    let _e4030 = ((_e4027 - _e3471) < f64(0.00000000023283064f));
                                                    if _e4030 {
                                                        phi_2887_ = false;
                                                    } else {
                                                        phi_2887_ = true;
                                                    }
                                                    let _e4032 = phi_2887_;
                                                    phi_2888_ = _e4032;
                                                    phi_2889_ = _e4030;
                                                    phi_2890_ = false;
                                                } else {
                                                    phi_2888_ = false;
                                                    phi_2889_ = false;
                                                    phi_2890_ = true;
                                                }
                                                let _e4034 = phi_2888_;
                                                let _e4036 = phi_2889_;
                                                let _e4038 = phi_2890_;
                                                phi_2891_ = _e4034;
                                                phi_2892_ = _e4036;
                                                phi_2893_ = _e4038;
                                            }
                                            let _e4040 = phi_2891_;
                                            let _e4042 = phi_2892_;
                                            let _e4044 = phi_2893_;
                                            phi_2894_ = _e4040;
                                            phi_2895_ = _e4022;
                                            phi_2896_ = _e4042;
                                            phi_2897_ = _e4044;
                                            phi_2898_ = false;
                                        } else {
                                            phi_2894_ = false;
                                            phi_2895_ = false;
                                            phi_2896_ = false;
                                            phi_2897_ = false;
                                            phi_2898_ = true;
                                        }
                                        let _e4046 = phi_2894_;
                                        let _e4048 = phi_2895_;
                                        let _e4050 = phi_2896_;
                                        let _e4052 = phi_2897_;
                                        let _e4054 = phi_2898_;
                                        let _e5580 = local_70;
                                        phi_2899_ = _e5580;
                                        let _e5583 = local_71;
                                        phi_2900_ = _e5583;
                                        phi_2901_ = _e4046;
                                        phi_2902_ = _e4048;
                                        phi_2903_ = _e4050;
                                        phi_2904_ = _e4052;
                                        phi_2905_ = _e4054;
                                        phi_2906_ = false;
                                    } else {
                                        phi_2899_ = f64();
                                        phi_2900_ = f64();
                                        phi_2901_ = false;
                                        phi_2902_ = false;
                                        phi_2903_ = false;
                                        phi_2904_ = false;
                                        phi_2905_ = false;
                                        phi_2906_ = true;
                                    }
                                    let _e4056 = phi_2899_;
                                    let _e4058 = phi_2900_;
                                    let _e4060 = phi_2901_;
                                    let _e4062 = phi_2902_;
                                    let _e4064 = phi_2903_;
                                    let _e4066 = phi_2904_;
                                    let _e4068 = phi_2905_;
                                    let _e4070 = phi_2906_;
                                    phi_2907_ = _e4056;
                                    phi_2908_ = _e4058;
                                    phi_2909_ = _e4060;
                                    phi_2910_ = _e4062;
                                    phi_2911_ = _e4064;
                                    phi_2912_ = _e4066;
                                    phi_2913_ = _e4068;
                                    phi_2914_ = _e4070;
                                    phi_2915_ = false;
                                } else {
                                    phi_2907_ = f64();
                                    phi_2908_ = f64();
                                    phi_2909_ = false;
                                    phi_2910_ = false;
                                    phi_2911_ = false;
                                    phi_2912_ = false;
                                    phi_2913_ = false;
                                    phi_2914_ = false;
                                    phi_2915_ = true;
                                }
                                let _e4072 = phi_2907_;
                                let _e4074 = phi_2908_;
                                let _e4076 = phi_2909_;
                                let _e4078 = phi_2910_;
                                let _e4080 = phi_2911_;
                                let _e4082 = phi_2912_;
                                let _e4084 = phi_2913_;
                                let _e4086 = phi_2914_;
                                let _e4088 = phi_2915_;
                                phi_2916_ = _e4072;
                                phi_1967_ = _e4074;
                                phi_2917_ = _e4076;
                                phi_2918_ = _e4078;
                                phi_2919_ = _e4080;
                                phi_2920_ = false;
                                phi_2921_ = _e4082;
                                phi_2922_ = _e4084;
                                phi_2923_ = _e4086;
                                phi_2924_ = _e4088;
                            } else {
                                phi_2916_ = f64();
                                phi_1967_ = f64();
                                phi_2917_ = false;
                                phi_2918_ = false;
                                phi_2919_ = false;
                                phi_2920_ = true;
                                phi_2921_ = false;
                                phi_2922_ = false;
                                phi_2923_ = false;
                                phi_2924_ = false;
                            }
                            let _e4090 = phi_2916_;
                            let _e4092 = phi_1967_;
                            let _e4094 = phi_2917_;
                            let _e4096 = phi_2918_;
                            let _e4098 = phi_2919_;
                            let _e4100 = phi_2920_;
                            let _e4102 = phi_2921_;
                            let _e4104 = phi_2922_;
                            let _e4106 = phi_2923_;
                            let _e4108 = phi_2924_;
                            local_43 = _e4096;
                            local_72 = _e4098;
                            local_73 = _e4100;
                            local_74 = _e4102;
                            local_75 = _e4104;
                            local_76 = _e4106;
                            local_77 = _e4108;
                            local_78 = _e4090;
                            local_80 = _e4096;
                            continue;
                            continuing {
                                phi_1963_ = _e3485;
                                phi_1966_ = _e4092;
                                break if !(_e4094);
                            }
                        }
                        let _e4111 = local_43;
                        if _e4111 {
                            phi_2929_ = type_72(0u, type_72().member_1);
                            phi_2930_ = false;
                            phi_2931_ = false;
                            phi_2932_ = false;
                            phi_2933_ = false;
                            phi_2934_ = false;
                            phi_2935_ = false;
                        } else {
                            phi_2929_ = type_72();
                            let _e5613 = local_72;
                            phi_2930_ = _e5613;
                            let _e5616 = local_73;
                            phi_2931_ = _e5616;
                            let _e5619 = local_74;
                            phi_2932_ = _e5619;
                            let _e5622 = local_75;
                            phi_2933_ = _e5622;
                            let _e5625 = local_76;
                            phi_2934_ = _e5625;
                            let _e5628 = local_77;
                            phi_2935_ = _e5628;
                        }
                        let _e4116 = phi_2929_;
                        let _e4118 = phi_2930_;
                        let _e4120 = phi_2931_;
                        let _e4122 = phi_2932_;
                        let _e4124 = phi_2933_;
                        let _e4126 = phi_2934_;
                        let _e4128 = phi_2935_;
                        if _e4118 {
                            let _e5631 = local_78;
                            phi_2939_ = _e5631;
                            phi_2940_ = true;
                            phi_2941_ = false;
                            phi_2942_ = false;
                            phi_2943_ = false;
                            phi_2944_ = false;
                            phi_2945_ = false;
                        } else {
                            let _e5633 = local_79;
                            phi_2939_ = _e5633;
                            phi_2940_ = _e4120;
                            phi_2941_ = _e4122;
                            phi_2942_ = _e4124;
                            let _e5639 = local_80;
                            phi_2943_ = _e5639;
                            phi_2944_ = _e4126;
                            phi_2945_ = _e4128;
                        }
                        let _e4130 = phi_2939_;
                        let _e4132 = phi_2940_;
                        let _e4134 = phi_2941_;
                        let _e4136 = phi_2942_;
                        let _e4138 = phi_2943_;
                        let _e4140 = phi_2944_;
                        let _e4142 = phi_2945_;
                        if _e4132 {
                            phi_2950_ = type_72(1u, _e4130);
                            phi_2951_ = false;
                            phi_2952_ = false;
                            phi_2953_ = false;
                            phi_2954_ = false;
                            phi_2955_ = false;
                        } else {
                            phi_2950_ = type_72();
                            phi_2951_ = _e4134;
                            phi_2952_ = _e4136;
                            phi_2953_ = _e4138;
                            phi_2954_ = _e4140;
                            phi_2955_ = _e4142;
                        }
                        let _e4145 = phi_2950_;
                        let _e4147 = phi_2951_;
                        let _e4149 = phi_2952_;
                        let _e4151 = phi_2953_;
                        let _e4153 = phi_2954_;
                        let _e4155 = phi_2955_;
                        if _e4147 {
                            let _e4157 = local_44;
                            phi_2960_ = type_72(1u, _e4157);
                            phi_2961_ = false;
                            phi_2962_ = true;
                            phi_2963_ = false;
                            phi_2964_ = false;
                        } else {
                            phi_2960_ = _e4116;
                            phi_2961_ = _e4149;
                            phi_2962_ = _e4151;
                            phi_2963_ = _e4153;
                            phi_2964_ = _e4155;
                        }
                        let _e4160 = phi_2960_;
                        let _e4162 = phi_2961_;
                        let _e4164 = phi_2962_;
                        let _e4166 = phi_2963_;
                        let _e4168 = phi_2964_;
                        if _e4162 {
                            let _e4170 = local_45;
                            phi_2969_ = type_72(1u, _e4170);
                            phi_2970_ = true;
                            phi_2971_ = false;
                            phi_2972_ = false;
                        } else {
                            phi_2969_ = _e4160;
                            phi_2970_ = _e4164;
                            phi_2971_ = _e4166;
                            phi_2972_ = _e4168;
                        }
                        let _e4173 = phi_2969_;
                        let _e4175 = phi_2970_;
                        let _e4177 = phi_2971_;
                        let _e4179 = phi_2972_;
                        if _e4175 {
                            phi_2976_ = false;
                            phi_2977_ = false;
                        } else {
                            phi_2976_ = _e4177;
                            phi_2977_ = _e4179;
                        }
                        let _e4181 = phi_2976_;
                        let _e4183 = phi_2977_;
                        if _e4181 {
                            phi_2981_ = false;
                            phi_2982_ = false;
                        } else {
                            phi_2981_ = _e4183;
                            phi_2982_ = _e4175;
                        }
                        let _e4185 = phi_2981_;
                        let _e4187 = phi_2982_;
                        if _e4185 {
                            phi_2986_ = true;
                            phi_2987_ = false;
                        } else {
                            phi_2986_ = _e4181;
                            phi_2987_ = _e4187;
                        }
                        let _e4189 = phi_2986_;
                        let _e4191 = phi_2987_;
                        if _e4189 {
                            let _e4193 = local_46;
                            phi_2992_ = type_72(1u, _e4193);
                            phi_2993_ = true;
                        } else {
                            phi_2992_ = _e4173;
                            phi_2993_ = _e4191;
                        }
                        let _e4196 = phi_2992_;
                        let _e4198 = phi_2993_;
                        if _e4198 {
                            phi_2997_ = _e4196;
                        } else {
                            phi_2997_ = _e4145;
                        }
                        let _e4200 = phi_2997_;
                        if (_e4200.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_3011_ = type_29(0u, 3u);
                            loop {
                                let _e4213 = phi_3011_;
                                if (_e4213.member < _e4213.member_1) {
                                    phi_3012_ = type_29((_e4213.member + 1u), _e4213.member_1);
                                    phi_3035_ = type_29(1u, _e4213.member);
                                } else {
                                    phi_3012_ = _e4213;
                                    phi_3035_ = type_29(0u, type_29().member_1);
                                }
                                let _e4227 = phi_3012_;
                                let _e4229 = phi_3035_;
                                if (bitcast<i32>(_e4229.member) != 0i) {
                                    if (_e4229.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4236 = local_14[_e4229.member_1];
                                    let _e4238 = (_e4200.member_1 + f64(_e4236));
                                    if (_e4238 < _e3236) {
                                        phi_3056_ = _e4238;
                                    } else {
                                        phi_3056_ = _e3236;
                                    }
                                    let _e4241 = phi_3056_;
                                    let _e4244 = local_20.member[0u];
                                    let _e4250 = local_20.member[1u];
                                    let _e4260 = (_e4244[0] + ((_e4250[0] - _e4244[0]) * _e4241));
                                    let _e4261 = (_e4244[1] + ((_e4250[1] - _e4244[1]) * _e4241));
                                    let _e4262 = (_e4244[2] + ((_e4250[2] - _e4244[2]) * _e4241));
                                    let _e4265 = local_20.member_1[0u];
                                    let _e4271 = local_20.member_1[1u];
                                    let _e4281 = (_e4265[0] + ((_e4271[0] - _e4265[0]) * _e4241));
                                    let _e4282 = (_e4265[1] + ((_e4271[1] - _e4265[1]) * _e4241));
                                    let _e4283 = (_e4265[2] + ((_e4271[2] - _e4265[2]) * _e4241));
                                    let _e4286 = local_20.member_2[0u];
                                    let _e4292 = local_20.member_2[1u];
                                    let _e4302 = (_e4286[0] + ((_e4292[0] - _e4286[0]) * _e4241));
                                    let _e4303 = (_e4286[1] + ((_e4292[1] - _e4286[1]) * _e4241));
                                    let _e4304 = (_e4286[2] + ((_e4292[2] - _e4286[2]) * _e4241));
                                    let _e4309 = (((_e4281 * _e4281) + (_e4282 * _e4282)) + (_e4283 * _e4283));
                                    let _e4314 = (((_e4281 * _e4302) + (_e4282 * _e4303)) + (_e4283 * _e4304));
                                    let _e4319 = (((_e4302 * _e4302) + (_e4303 * _e4303)) + (_e4304 * _e4304));
                                    let _e4324 = (((_e4260 * _e4281) + (_e4261 * _e4282)) + (_e4262 * _e4283));
                                    let _e4329 = (((_e4260 * _e4302) + (_e4261 * _e4303)) + (_e4262 * _e4304));
                                    let _e4332 = ((_e4309 * _e4319) - (_e4314 * _e4314));
                                    let _e4333 = f64(0f);
                                    let _e4338 = (((_e4324 * _e4319) - (_e4329 * _e4314)) / _e4332);
                                    let _e4342 = (((_e4329 * _e4309) - (_e4324 * _e4314)) / _e4332);
                                    if (_e4338 >= _e4333) {
                                        if (_e4342 >= _e4333) {
                                            phi_3225_ = ((_e4338 + _e4342) <= f64(1f));
                                            phi_3226_ = false;
                                        } else {
                                            phi_3225_ = bool();
                                            phi_3226_ = true;
                                        }
                                        let _e4348 = phi_3225_;
                                        let _e4350 = phi_3226_;
                                        phi_3227_ = _e4348;
                                        phi_3228_ = _e4350;
                                    } else {
                                        phi_3227_ = bool();
                                        phi_3228_ = true;
                                    }
                                    let _e4352 = phi_3227_;
                                    let _e4354 = phi_3228_;
                                    if _e4354 {
                                        let _e4355 = (_e4332 > _e4333);
                                        if _e4355 {
                                            phi_3241_ = false;
                                        } else {
                                            phi_3241_ = true;
                                        }
                                        let _e4357 = phi_3241_;
                                        phi_3242_ = false;
                                        phi_3243_ = _e4357;
                                        phi_3244_ = _e4355;
                                    } else {
                                        phi_3242_ = true;
                                        phi_3243_ = false;
                                        phi_3244_ = false;
                                    }
                                    let _e4359 = phi_3242_;
                                    let _e4361 = phi_3243_;
                                    let _e4363 = phi_3244_;
                                    if _e4359 {
                                        if (_e4332 > _e4333) {
                                            if _e4352 {
                                                phi_3268_ = array<f64, 3>((_e4260 - ((_e4281 * _e4338) + (_e4302 * _e4342))), (_e4261 - ((_e4282 * _e4338) + (_e4303 * _e4342))), (_e4262 - ((_e4283 * _e4338) + (_e4304 * _e4342))));
                                                phi_3269_ = false;
                                            } else {
                                                phi_3268_ = array<f64, 3>();
                                                phi_3269_ = true;
                                            }
                                            let _e4379 = phi_3268_;
                                            let _e4381 = phi_3269_;
                                            phi_3270_ = _e4379;
                                            phi_3271_ = false;
                                            phi_3272_ = _e4381;
                                        } else {
                                            phi_3270_ = array<f64, 3>();
                                            phi_3271_ = true;
                                            phi_3272_ = false;
                                        }
                                        let _e4383 = phi_3270_;
                                        let _e4385 = phi_3271_;
                                        let _e4387 = phi_3272_;
                                        phi_3273_ = _e4383;
                                        phi_3274_ = _e4385;
                                        phi_3275_ = _e4387;
                                    } else {
                                        phi_3273_ = array<f64, 3>();
                                        phi_3274_ = _e4361;
                                        phi_3275_ = _e4363;
                                    }
                                    let _e4389 = phi_3273_;
                                    let _e4391 = phi_3274_;
                                    let _e4393 = phi_3275_;
                                    if _e4391 {
                                        phi_3279_ = true;
                                    } else {
                                        phi_3279_ = _e4393;
                                    }
                                    let _e4395 = phi_3279_;
                                    if _e4395 {
                                        let _e4396 = (_e4260 - _e4281);
                                        let _e4397 = (_e4261 - _e4282);
                                        let _e4398 = (_e4262 - _e4283);
                                        let _e4399 = (_e4302 - _e4281);
                                        let _e4400 = (_e4303 - _e4282);
                                        let _e4401 = (_e4304 - _e4283);
                                        let _e4412 = ((((_e4396 * _e4399) + (_e4397 * _e4400)) + (_e4398 * _e4401)) / (((_e4399 * _e4399) + (_e4400 * _e4400)) + (_e4401 * _e4401)));
                                        if (_e4412 > f64(0f)) {
                                            if (_e4412 < f64(1f)) {
                                                phi_3466_ = _e4412;
                                            } else {
                                                phi_3466_ = f64(1f);
                                            }
                                            let _e4420 = phi_3466_;
                                            phi_3468_ = _e4420;
                                        } else {
                                            phi_3468_ = f64(0f);
                                        }
                                        let _e4422 = phi_3468_;
                                        let _e4426 = (_e4396 - (_e4399 * _e4422));
                                        let _e4427 = (_e4397 - (_e4400 * _e4422));
                                        let _e4428 = (_e4398 - (_e4401 * _e4422));
                                        let _e4439 = ((((_e4260 * _e4281) + (_e4261 * _e4282)) + (_e4262 * _e4283)) / (((_e4281 * _e4281) + (_e4282 * _e4282)) + (_e4283 * _e4283)));
                                        if (_e4439 > f64(0f)) {
                                            if (_e4439 < f64(1f)) {
                                                phi_3498_ = _e4439;
                                            } else {
                                                phi_3498_ = f64(1f);
                                            }
                                            let _e4447 = phi_3498_;
                                            phi_3500_ = _e4447;
                                        } else {
                                            phi_3500_ = f64(0f);
                                        }
                                        let _e4449 = phi_3500_;
                                        let _e4466 = ((((_e4260 * _e4302) + (_e4261 * _e4303)) + (_e4262 * _e4304)) / (((_e4302 * _e4302) + (_e4303 * _e4303)) + (_e4304 * _e4304)));
                                        if (_e4466 > f64(0f)) {
                                            if (_e4466 < f64(1f)) {
                                                phi_3530_ = _e4466;
                                            } else {
                                                phi_3530_ = f64(1f);
                                            }
                                            let _e4474 = phi_3530_;
                                            phi_3532_ = _e4474;
                                        } else {
                                            phi_3532_ = f64(0f);
                                        }
                                        let _e4476 = phi_3532_;
                                        local_10[0u] = array<f64, 3>((_e4260 - (_e4281 * _e4449)), (_e4261 - (_e4282 * _e4449)), (_e4262 - (_e4283 * _e4449)));
                                        local_10[1u] = array<f64, 3>((_e4260 - (_e4302 * _e4476)), (_e4261 - (_e4303 * _e4476)), (_e4262 - (_e4304 * _e4476)));
                                        local_10[2u] = array<f64, 3>(_e4426, _e4427, _e4428);
                                        local_10[3u] = array<f64, 3>(_e4426, _e4427, _e4428);
                                        let _e4492 = local_10[0u];
                                        phi_3568_ = type_29(1u, 4u);
                                        phi_3571_ = array<f64, 3>(_e4492[0], _e4492[1], _e4492[2]);
                                        loop {
                                            let _e4498 = phi_3568_;
                                            let _e4500 = phi_3571_;
                                            local_81 = _e4500;
                                            if (_e4498.member < _e4498.member_1) {
                                                phi_3569_ = type_29((_e4498.member + 1u), _e4498.member_1);
                                                phi_3594_ = type_29(1u, _e4498.member);
                                            } else {
                                                phi_3569_ = _e4498;
                                                phi_3594_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e4514 = phi_3569_;
                                            let _e4516 = phi_3594_;
                                            let _e4520 = (bitcast<i32>(_e4516.member) != 0i);
                                            if _e4520 {
                                                if (_e4516.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4523 = local_10[_e4516.member_1];
                                                if (_e4516.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4529 = local_10[_e4516.member_1];
                                                if ((((_e4523[0] * _e4529[0]) + (_e4523[1] * _e4529[1])) + (_e4523[2] * _e4529[2])) < (((_e4500[0] * _e4500[0]) + (_e4500[1] * _e4500[1])) + (_e4500[2] * _e4500[2]))) {
                                                    if (_e4516.member_1 < 4u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e4552 = local_10[_e4516.member_1];
                                                    phi_3661_ = array<f64, 3>(_e4552[0], _e4552[1], _e4552[2]);
                                                } else {
                                                    phi_3661_ = _e4500;
                                                }
                                                let _e4558 = phi_3661_;
                                                phi_3572_ = _e4558;
                                            } else {
                                                phi_3572_ = array<f64, 3>();
                                            }
                                            let _e4560 = phi_3572_;
                                            continue;
                                            continuing {
                                                phi_3568_ = _e4514;
                                                phi_3571_ = _e4560;
                                                break if !(_e4520);
                                            }
                                        }
                                        let _e5704 = local_81;
                                        phi_3662_ = _e5704;
                                    } else {
                                        phi_3662_ = _e4389;
                                    }
                                    let _e4563 = phi_3662_;
                                    let _e4574 = (((_e4563[0] * _e4563[0]) + (_e4563[1] * _e4563[1])) + (_e4563[2] * _e4563[2]));
                                    if (_e4574 <= 2.2250738585072014e-308lf) {
                                        if (_e4574 > 0.0lf) {
                                            phi_3687_ = (bitcast<f64>(((4503599627370496lu >> bitcast<u64>(1lu)) + 2303426169912950784lu)) * 2.0lf);
                                        } else {
                                            phi_3687_ = 0.0lf;
                                        }
                                        let _e4637 = phi_3687_;
                                        phi_3751_ = _e4637;
                                    } else {
                                        phi_3694_ = type_27(0i, 5i);
                                        phi_3697_ = bitcast<f64>(((bitcast<u64>(_e4574) >> bitcast<u64>(1lu)) + 2303426169912950784lu));
                                        loop {
                                            let _e4582 = phi_3694_;
                                            let _e4584 = phi_3697_;
                                            local_47 = _e4584;
                                            if (_e4582.member < _e4582.member_1) {
                                                let _e4592 = (_e4582.member + 1i);
                                                if ((false == (_e4592 > _e4582.member)) != false) {
                                                    phi_3718_ = true;
                                                } else {
                                                    phi_3718_ = false;
                                                }
                                                let _e4597 = phi_3718_;
                                                if _e4597 {
                                                    phi_3724_ = type_28(0u, type_28().member_1);
                                                } else {
                                                    phi_3724_ = type_28(1u, _e4592);
                                                }
                                                let _e4603 = phi_3724_;
                                                if (bitcast<i32>(_e4603.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3695_ = type_27(_e4603.member_1, _e4582.member_1);
                                                phi_3738_ = type_28(1u, _e4582.member);
                                            } else {
                                                phi_3695_ = _e4582;
                                                phi_3738_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4613 = phi_3695_;
                                            let _e4615 = phi_3738_;
                                            let _e4618 = (bitcast<i32>(_e4615.member) != 0i);
                                            if _e4618 {
                                                phi_3698_ = (0.5lf * (_e4584 + (_e4574 / _e4584)));
                                            } else {
                                                phi_3698_ = f64();
                                            }
                                            let _e4623 = phi_3698_;
                                            continue;
                                            continuing {
                                                phi_3694_ = _e4613;
                                                phi_3697_ = _e4623;
                                                break if !(_e4618);
                                            }
                                        }
                                        let _e4628 = local_47;
                                        phi_3751_ = (_e4628 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e4639 = phi_3751_;
                                    let _e4647 = local_20.member[0u];
                                    if (_e4647[0] < 0.0lf) {
                                        phi_3769_ = -(_e4647[0]);
                                    } else {
                                        phi_3769_ = _e4647[0];
                                    }
                                    let _e4654 = phi_3769_;
                                    if (_e4647[1] < 0.0lf) {
                                        phi_3776_ = -(_e4647[1]);
                                    } else {
                                        phi_3776_ = _e4647[1];
                                    }
                                    let _e4658 = phi_3776_;
                                    if (_e4654 > _e4658) {
                                        phi_3781_ = _e4654;
                                    } else {
                                        phi_3781_ = _e4658;
                                    }
                                    let _e4661 = phi_3781_;
                                    if (_e4647[2] < 0.0lf) {
                                        phi_3788_ = -(_e4647[2]);
                                    } else {
                                        phi_3788_ = _e4647[2];
                                    }
                                    let _e4665 = phi_3788_;
                                    if (_e4661 > _e4665) {
                                        phi_3793_ = _e4661;
                                    } else {
                                        phi_3793_ = _e4665;
                                    }
                                    let _e4668 = phi_3793_;
                                    let _e4671 = local_20.member[1u];
                                    if (_e4671[0] < 0.0lf) {
                                        phi_3806_ = -(_e4671[0]);
                                    } else {
                                        phi_3806_ = _e4671[0];
                                    }
                                    let _e4678 = phi_3806_;
                                    if (_e4671[1] < 0.0lf) {
                                        phi_3813_ = -(_e4671[1]);
                                    } else {
                                        phi_3813_ = _e4671[1];
                                    }
                                    let _e4682 = phi_3813_;
                                    if (_e4678 > _e4682) {
                                        phi_3818_ = _e4678;
                                    } else {
                                        phi_3818_ = _e4682;
                                    }
                                    let _e4685 = phi_3818_;
                                    if (_e4671[2] < 0.0lf) {
                                        phi_3825_ = -(_e4671[2]);
                                    } else {
                                        phi_3825_ = _e4671[2];
                                    }
                                    let _e4689 = phi_3825_;
                                    if (_e4685 > _e4689) {
                                        phi_3830_ = _e4685;
                                    } else {
                                        phi_3830_ = _e4689;
                                    }
                                    let _e4692 = phi_3830_;
                                    if (_e4668 > _e4692) {
                                        phi_3835_ = _e4668;
                                    } else {
                                        phi_3835_ = _e4692;
                                    }
                                    let _e4695 = phi_3835_;
                                    let _e4697 = local_20.member_3;
                                    let _e4701 = local_20.member_1[0u];
                                    if (_e4701[0] < 0.0lf) {
                                        phi_3852_ = -(_e4701[0]);
                                    } else {
                                        phi_3852_ = _e4701[0];
                                    }
                                    let _e4708 = phi_3852_;
                                    if (_e4701[1] < 0.0lf) {
                                        phi_3859_ = -(_e4701[1]);
                                    } else {
                                        phi_3859_ = _e4701[1];
                                    }
                                    let _e4712 = phi_3859_;
                                    if (_e4708 > _e4712) {
                                        phi_3864_ = _e4708;
                                    } else {
                                        phi_3864_ = _e4712;
                                    }
                                    let _e4715 = phi_3864_;
                                    if (_e4701[2] < 0.0lf) {
                                        phi_3871_ = -(_e4701[2]);
                                    } else {
                                        phi_3871_ = _e4701[2];
                                    }
                                    let _e4719 = phi_3871_;
                                    if (_e4715 > _e4719) {
                                        phi_3876_ = _e4715;
                                    } else {
                                        phi_3876_ = _e4719;
                                    }
                                    let _e4722 = phi_3876_;
                                    let _e4725 = local_20.member_1[1u];
                                    if (_e4725[0] < 0.0lf) {
                                        phi_3890_ = -(_e4725[0]);
                                    } else {
                                        phi_3890_ = _e4725[0];
                                    }
                                    let _e4732 = phi_3890_;
                                    if (_e4725[1] < 0.0lf) {
                                        phi_3897_ = -(_e4725[1]);
                                    } else {
                                        phi_3897_ = _e4725[1];
                                    }
                                    let _e4736 = phi_3897_;
                                    if (_e4732 > _e4736) {
                                        phi_3902_ = _e4732;
                                    } else {
                                        phi_3902_ = _e4736;
                                    }
                                    let _e4739 = phi_3902_;
                                    if (_e4725[2] < 0.0lf) {
                                        phi_3909_ = -(_e4725[2]);
                                    } else {
                                        phi_3909_ = _e4725[2];
                                    }
                                    let _e4743 = phi_3909_;
                                    if (_e4739 > _e4743) {
                                        phi_3914_ = _e4739;
                                    } else {
                                        phi_3914_ = _e4743;
                                    }
                                    let _e4746 = phi_3914_;
                                    if (_e4722 > _e4746) {
                                        phi_3919_ = _e4722;
                                    } else {
                                        phi_3919_ = _e4746;
                                    }
                                    let _e4749 = phi_3919_;
                                    let _e4751 = local_20.member_3;
                                    let _e4755 = local_20.member_2[0u];
                                    if (_e4755[0] < 0.0lf) {
                                        phi_3936_ = -(_e4755[0]);
                                    } else {
                                        phi_3936_ = _e4755[0];
                                    }
                                    let _e4762 = phi_3936_;
                                    if (_e4755[1] < 0.0lf) {
                                        phi_3943_ = -(_e4755[1]);
                                    } else {
                                        phi_3943_ = _e4755[1];
                                    }
                                    let _e4766 = phi_3943_;
                                    if (_e4762 > _e4766) {
                                        phi_3948_ = _e4762;
                                    } else {
                                        phi_3948_ = _e4766;
                                    }
                                    let _e4769 = phi_3948_;
                                    if (_e4755[2] < 0.0lf) {
                                        phi_3955_ = -(_e4755[2]);
                                    } else {
                                        phi_3955_ = _e4755[2];
                                    }
                                    let _e4773 = phi_3955_;
                                    if (_e4769 > _e4773) {
                                        phi_3960_ = _e4769;
                                    } else {
                                        phi_3960_ = _e4773;
                                    }
                                    let _e4776 = phi_3960_;
                                    let _e4779 = local_20.member_2[1u];
                                    if (_e4779[0] < 0.0lf) {
                                        phi_3974_ = -(_e4779[0]);
                                    } else {
                                        phi_3974_ = _e4779[0];
                                    }
                                    let _e4786 = phi_3974_;
                                    if (_e4779[1] < 0.0lf) {
                                        phi_3981_ = -(_e4779[1]);
                                    } else {
                                        phi_3981_ = _e4779[1];
                                    }
                                    let _e4790 = phi_3981_;
                                    if (_e4786 > _e4790) {
                                        phi_3986_ = _e4786;
                                    } else {
                                        phi_3986_ = _e4790;
                                    }
                                    let _e4793 = phi_3986_;
                                    if (_e4779[2] < 0.0lf) {
                                        phi_3993_ = -(_e4779[2]);
                                    } else {
                                        phi_3993_ = _e4779[2];
                                    }
                                    let _e4797 = phi_3993_;
                                    if (_e4793 > _e4797) {
                                        phi_3998_ = _e4793;
                                    } else {
                                        phi_3998_ = _e4797;
                                    }
                                    let _e4800 = phi_3998_;
                                    if (_e4776 > _e4800) {
                                        phi_4003_ = _e4776;
                                    } else {
                                        phi_4003_ = _e4800;
                                    }
                                    let _e4803 = phi_4003_;
                                    let _e4805 = local_20.member_3;
                                    let _e4813 = local_20.member_3;
                                    let _e4823 = (((_e4639 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e4695 + _e4697) + (_e4749 + _e4751)) + (_e4803 + _e4805)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4813 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e454);
                                    if _e4823 {
                                        phi_4027_ = false;
                                    } else {
                                        phi_4027_ = true;
                                    }
                                    let _e4825 = phi_4027_;
                                    phi_4028_ = _e4825;
                                    phi_4029_ = _e4823;
                                } else {
                                    phi_4028_ = false;
                                    phi_4029_ = false;
                                }
                                let _e4827 = phi_4028_;
                                let _e4829 = phi_4029_;
                                local_48 = _e4829;
                                continue;
                                continuing {
                                    phi_3011_ = _e4227;
                                    break if !(_e4827);
                                }
                            }
                            let _e4832 = local_48;
                            if _e4832 {
                                phi_4034_ = type_72(1u, _e4200.member_1);
                                phi_4035_ = false;
                            } else {
                                phi_4034_ = type_72();
                                phi_4035_ = true;
                            }
                            let _e4835 = phi_4034_;
                            let _e4837 = phi_4035_;
                            if _e4837 {
                                phi_4040_ = type_72(2u, _e4200.member_1);
                                phi_4041_ = false;
                            } else {
                                phi_4040_ = type_72();
                                phi_4041_ = true;
                            }
                            let _e4840 = phi_4040_;
                            let _e4842 = phi_4041_;
                            phi_4043_ = _e4840;
                            phi_4044_ = _e4835;
                            phi_4045_ = _e4842;
                        } else {
                            phi_4043_ = type_72();
                            phi_4044_ = type_72(0u, type_72().member_1);
                            phi_4045_ = true;
                        }
                        let _e4844 = phi_4043_;
                        let _e4846 = phi_4044_;
                        let _e4848 = phi_4045_;
                        if _e4848 {
                            phi_4049_ = _e4846;
                        } else {
                            phi_4049_ = _e4844;
                        }
                        let _e4850 = phi_4049_;
                        phi_7388_ = _e4850;
                    } else {
                        if (_e553 < 0.0lf) {
                            phi_4060_ = -(_e553);
                        } else {
                            phi_4060_ = _e553;
                        }
                        let _e908 = phi_4060_;
                        if (_e576 < 0.0lf) {
                            phi_4066_ = -(_e576);
                        } else {
                            phi_4066_ = _e576;
                        }
                        let _e912 = phi_4066_;
                        if (_e908 > _e912) {
                            phi_4071_ = _e908;
                        } else {
                            phi_4071_ = _e912;
                        }
                        let _e915 = phi_4071_;
                        if (_e599 < 0.0lf) {
                            phi_4077_ = -(_e599);
                        } else {
                            phi_4077_ = _e599;
                        }
                        let _e919 = phi_4077_;
                        if (_e610 < 0.0lf) {
                            phi_4083_ = -(_e610);
                        } else {
                            phi_4083_ = _e610;
                        }
                        let _e923 = phi_4083_;
                        if (_e919 > _e923) {
                            phi_4088_ = _e919;
                        } else {
                            phi_4088_ = _e923;
                        }
                        let _e926 = phi_4088_;
                        if (_e915 > _e926) {
                            phi_4093_ = _e915;
                        } else {
                            phi_4093_ = _e926;
                        }
                        let _e929 = phi_4093_;
                        let _e933 = ((_e869 * f64(0.34f)) + (_e929 * (1.1102230246251565e-16lf * f64(256f))));
                        let _e934 = f64(0f);
                        let _e935 = f64(1f);
                        let _e936 = f64(3f);
                        let _e938 = (_e576 - (_e936 * _e553));
                        let _e939 = (_e599 - _e576);
                        let _e941 = ((_e936 * _e610) - _e599);
                        local_7[0u] = _e934;
                        local_7[1u] = _e935;
                        local_7[2u] = _e935;
                        local_7[3u] = _e935;
                        let _e948 = ((_e939 * _e939) - (_e938 * _e941));
                        if (_e948 > _e934) {
                            if (_e948 <= 2.2250738585072014e-308lf) {
                                if (_e948 > 0.0lf) {
                                    phi_4130_ = (bitcast<f64>(((4503599627370496lu >> bitcast<u64>(1lu)) + 2303426169912950784lu)) * 2.0lf);
                                } else {
                                    phi_4130_ = 0.0lf;
                                }
                                let _e1012 = phi_4130_;
                                phi_4194_ = _e1012;
                            } else {
                                phi_4137_ = type_27(0i, 5i);
                                phi_4140_ = bitcast<f64>(((bitcast<u64>(_e948) >> bitcast<u64>(1lu)) + 2303426169912950784lu));
                                loop {
                                    let _e957 = phi_4137_;
                                    let _e959 = phi_4140_;
                                    local_21 = _e959;
                                    if (_e957.member < _e957.member_1) {
                                        let _e967 = (_e957.member + 1i);
                                        if ((false == (_e967 > _e957.member)) != false) {
                                            phi_4161_ = true;
                                        } else {
                                            phi_4161_ = false;
                                        }
                                        let _e972 = phi_4161_;
                                        if _e972 {
                                            phi_4167_ = type_28(0u, type_28().member_1);
                                        } else {
                                            phi_4167_ = type_28(1u, _e967);
                                        }
                                        let _e978 = phi_4167_;
                                        if (bitcast<i32>(_e978.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_4138_ = type_27(_e978.member_1, _e957.member_1);
                                        phi_4181_ = type_28(1u, _e957.member);
                                    } else {
                                        phi_4138_ = _e957;
                                        phi_4181_ = type_28(0u, type_28().member_1);
                                    }
                                    let _e988 = phi_4138_;
                                    let _e990 = phi_4181_;
                                    let _e993 = (bitcast<i32>(_e990.member) != 0i);
                                    if _e993 {
                                        phi_4141_ = (0.5lf * (_e959 + (_e948 / _e959)));
                                    } else {
                                        phi_4141_ = f64();
                                    }
                                    let _e998 = phi_4141_;
                                    continue;
                                    continuing {
                                        phi_4137_ = _e988;
                                        phi_4140_ = _e998;
                                        break if !(_e993);
                                    }
                                }
                                let _e1003 = local_21;
                                phi_4194_ = (_e1003 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1014 = phi_4194_;
                            if (_e939 < _e934) {
                                phi_4200_ = -(_e1014);
                            } else {
                                phi_4200_ = _e1014;
                            }
                            let _e1018 = phi_4200_;
                            let _e1020 = -((_e939 + _e1018));
                            local_8[0u] = (_e1020 / (_e1020 + _e941));
                            local_8[1u] = (_e938 / (_e938 + _e1020));
                            let _e1029 = local_8[1u];
                            let _e1030 = local_8[0u];
                            if (_e1029 < _e1030) {
                                let _e1033 = local_8[1u];
                                let _e1035 = local_8[0u];
                                local_8[0u] = _e1033;
                                local_8[1u] = _e1035;
                            }
                            phi_4225_ = type_29(0u, 2u);
                            phi_4228_ = 1u;
                            loop {
                                let _e1039 = phi_4225_;
                                let _e1041 = phi_4228_;
                                local_49 = _e1041;
                                if (_e1039.member < _e1039.member_1) {
                                    phi_4226_ = type_29((_e1039.member + 1u), _e1039.member_1);
                                    phi_4251_ = type_29(1u, _e1039.member);
                                } else {
                                    phi_4226_ = _e1039;
                                    phi_4251_ = type_29(0u, type_29().member_1);
                                }
                                let _e1055 = phi_4226_;
                                let _e1057 = phi_4251_;
                                let _e1061 = (bitcast<i32>(_e1057.member) != 0i);
                                if _e1061 {
                                    if (_e1057.member_1 < 2u) {
                                    } else {
                                        return;
                                    }
                                    let _e1064 = local_8[_e1057.member_1];
                                    if (_e1064 > _e934) {
                                        if (_e1057.member_1 < 2u) {
                                        } else {
                                            return;
                                        }
                                        let _e1068 = local_8[_e1057.member_1];
                                        if (_e1068 < _e935) {
                                            if (_e1057.member_1 < 2u) {
                                            } else {
                                                return;
                                            }
                                            let _e1072 = local_8[_e1057.member_1];
                                            if (_e1041 < 4u) {
                                            } else {
                                                return;
                                            }
                                            local_7[_e1041] = _e1072;
                                            phi_4295_ = (_e1041 + 1u);
                                        } else {
                                            phi_4295_ = _e1041;
                                        }
                                        let _e1077 = phi_4295_;
                                        phi_4296_ = _e1077;
                                    } else {
                                        phi_4296_ = _e1041;
                                    }
                                    let _e1079 = phi_4296_;
                                    phi_4229_ = _e1079;
                                } else {
                                    phi_4229_ = u32();
                                }
                                let _e1081 = phi_4229_;
                                continue;
                                continuing {
                                    phi_4225_ = _e1055;
                                    phi_4228_ = _e1081;
                                    break if !(_e1061);
                                }
                            }
                            let _e5033 = local_49;
                            phi_4297_ = _e5033;
                        } else {
                            phi_4297_ = 1u;
                        }
                        let _e1084 = phi_4297_;
                        if (_e1084 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e1084] = _e935;
                        let _e1087 = local_7;
                        local_9 = _e1087;
                        phi_4317_ = type_29(0u, _e1084);
                        loop {
                            let _e1090 = phi_4317_;
                            if (_e1090.member < _e1090.member_1) {
                                phi_4318_ = type_29((_e1090.member + 1u), _e1090.member_1);
                                phi_4341_ = type_29(1u, _e1090.member);
                            } else {
                                phi_4318_ = _e1090;
                                phi_4341_ = type_29(0u, type_29().member_1);
                            }
                            let _e1104 = phi_4318_;
                            let _e1106 = phi_4341_;
                            if (bitcast<i32>(_e1106.member) != 0i) {
                                if (_e1106.member_1 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1113 = local_9[_e1106.member_1];
                                let _e1114 = (_e1106.member_1 + 1u);
                                if (_e1114 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1117 = local_9[_e1114];
                                let _e1119 = (f64(1f) - _e1113);
                                let _e1130 = ((((_e553 * _e1119) + (_e576 * _e1113)) * (_e1119 * _e1119)) + (((_e599 * _e1119) + (_e610 * _e1113)) * (_e1113 * _e1113)));
                                let _e1132 = (f64(1f) - _e1117);
                                let _e1143 = ((((_e553 * _e1132) + (_e576 * _e1117)) * (_e1132 * _e1132)) + (((_e599 * _e1132) + (_e610 * _e1117)) * (_e1117 * _e1117)));
                                if (_e1130 < 0.0lf) {
                                    phi_4395_ = -(_e1130);
                                } else {
                                    phi_4395_ = _e1130;
                                }
                                let _e1147 = phi_4395_;
                                let _e1148 = (_e1147 > _e933);
                                if (_e1143 < 0.0lf) {
                                    phi_4402_ = -(_e1143);
                                } else {
                                    phi_4402_ = _e1143;
                                }
                                let _e1152 = phi_4402_;
                                let _e1153 = (_e1152 > _e933);
                                let _e1154 = f64(0f);
                                if _e1148 {
                                    if _e1153 {
                                        let _e1157 = ((_e1130 > _e1154) != (_e1143 > _e1154));
                                        if _e1148 {
                                            if _e1153 {
                                                if _e1157 {
                                                    phi_4423_ = false;
                                                } else {
                                                    phi_4423_ = true;
                                                }
                                                let _e1159 = phi_4423_;
                                                phi_4424_ = _e1159;
                                            } else {
                                                phi_4424_ = false;
                                            }
                                            let _e1161 = phi_4424_;
                                            phi_4425_ = _e1161;
                                        } else {
                                            phi_4425_ = false;
                                        }
                                        let _e1163 = phi_4425_;
                                        phi_4426_ = _e1157;
                                        phi_4427_ = _e1157;
                                        phi_4428_ = false;
                                        phi_4429_ = _e1163;
                                    } else {
                                        phi_4426_ = bool();
                                        phi_4427_ = bool();
                                        phi_4428_ = true;
                                        phi_4429_ = false;
                                    }
                                    let _e1165 = phi_4426_;
                                    let _e1167 = phi_4427_;
                                    let _e1169 = phi_4428_;
                                    let _e1171 = phi_4429_;
                                    phi_4430_ = _e1165;
                                    phi_4431_ = _e1167;
                                    phi_4432_ = _e1169;
                                    phi_4433_ = _e1171;
                                } else {
                                    phi_4430_ = bool();
                                    phi_4431_ = bool();
                                    phi_4432_ = true;
                                    phi_4433_ = false;
                                }
                                let _e1173 = phi_4430_;
                                let _e1175 = phi_4431_;
                                let _e1177 = phi_4432_;
                                let _e1179 = phi_4433_;
                                if _e1177 {
                                    if _e1148 {
                                        phi_4443_ = _e1153;
                                    } else {
                                        phi_4443_ = false;
                                    }
                                    let _e1181 = phi_4443_;
                                    phi_4444_ = false;
                                    phi_4445_ = false;
                                    phi_4446_ = _e1181;
                                } else {
                                    phi_4444_ = _e1175;
                                    phi_4445_ = _e1173;
                                    phi_4446_ = _e1179;
                                }
                                let _e1183 = phi_4444_;
                                let _e1185 = phi_4445_;
                                let _e1187 = phi_4446_;
                                if _e1187 {
                                    phi_4452_ = type_73(f64(1f), _e1154, _e1183);
                                    phi_4453_ = false;
                                } else {
                                    phi_4452_ = type_73();
                                    phi_4453_ = true;
                                }
                                let _e1191 = phi_4452_;
                                let _e1193 = phi_4453_;
                                if _e1193 {
                                    if _e1148 {
                                        if (_e1130 < _e1154) {
                                            phi_4466_ = f64(-1f);
                                        } else {
                                            phi_4466_ = f64(1f);
                                        }
                                        let _e1198 = phi_4466_;
                                        let _e1199 = f64(0.00000000000022737368f);
                                        let _e1200 = f64(0.5f);
                                        let _e1201 = f64(3f);
                                        let _e1204 = (_e599 - _e576);
                                        phi_4479_ = type_29(0u, 64u);
                                        phi_4482_ = _e1117;
                                        phi_4484_ = _e1113;
                                        phi_4486_ = (_e1200 * (_e1113 + _e1117));
                                        loop {
                                            let _e1210 = phi_4479_;
                                            let _e1212 = phi_4482_;
                                            let _e1214 = phi_4484_;
                                            let _e1216 = phi_4486_;
                                            local_51 = _e1214;
                                            if (_e1210.member < _e1210.member_1) {
                                                phi_4480_ = type_29((_e1210.member + 1u), _e1210.member_1);
                                                phi_4509_ = type_29(1u, _e1210.member);
                                            } else {
                                                phi_4480_ = _e1210;
                                                phi_4509_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1230 = phi_4480_;
                                            let _e1232 = phi_4509_;
                                            if (bitcast<i32>(_e1232.member) != 0i) {
                                                let _e1237 = (f64(1f) - _e1216);
                                                let _e1250 = ((_e1198 * ((((_e553 * _e1237) + (_e576 * _e1216)) * (_e1237 * _e1237)) + (((_e599 * _e1237) + (_e610 * _e1216)) * (_e1216 * _e1216)))) - _e933);
                                                if (_e1250 > f64(0f)) {
                                                    phi_4536_ = _e1212;
                                                    phi_4537_ = _e1216;
                                                } else {
                                                    phi_4536_ = _e1216;
                                                    phi_4537_ = _e1214;
                                                }
                                                let _e1254 = phi_4536_;
                                                let _e1256 = phi_4537_;
                                                let _e1258 = ((_e1254 - _e1256) > _e1199);
                                                if _e1258 {
                                                    let _e1260 = (f64(1f) - _e1216);
                                                    let _e1272 = (-(_e1250) / (_e1198 * (((((_e576 - (_e1201 * _e553)) * _e1260) + (_e1204 * _e1216)) * _e1260) + (((_e1204 * _e1260) + (((_e1201 * _e610) - _e599) * _e1216)) * _e1216))));
                                                    if (_e1250 > f64(0f)) {
                                                        phi_4565_ = (_e1200 * _e1199);
                                                    } else {
                                                        phi_4565_ = -((_e1200 * _e1199));
                                                    }
                                                    let _e1279 = phi_4565_;
                                                    let _e1281 = ((_e1216 + _e1272) + _e1279);
                                                    if (_e1281 > _e1256) {
                                                        if (_e1281 < _e1254) {
                                                            if (_e1272 < 0.0lf) {
                                                                phi_4581_ = -(_e1272);
                                                            } else {
                                                                phi_4581_ = _e1272;
                                                            }
                                                            let _e1287 = phi_4581_;
                                                            if (_e1287 < (_e1200 * (_e1254 - _e1256))) {
                                                                phi_4588_ = false;
                                                            } else {
                                                                phi_4588_ = true;
                                                            }
                                                            let _e1292 = phi_4588_;
                                                            phi_4589_ = _e1292;
                                                        } else {
                                                            phi_4589_ = true;
                                                        }
                                                        let _e1294 = phi_4589_;
                                                        phi_4590_ = _e1294;
                                                    } else {
                                                        phi_4590_ = true;
                                                    }
                                                    let _e1296 = phi_4590_;
                                                    if _e1296 {
                                                        phi_4596_ = (_e1200 * (_e1256 + _e1254));
                                                    } else {
                                                        phi_4596_ = _e1281;
                                                    }
                                                    let _e1300 = phi_4596_;
                                                    phi_4597_ = _e1300;
                                                    phi_4598_ = false;
                                                } else {
                                                    phi_4597_ = f64();
                                                    phi_4598_ = true;
                                                }
                                                let _e1302 = phi_4597_;
                                                let _e1304 = phi_4598_;
                                                phi_4483_ = _e1254;
                                                phi_4485_ = _e1256;
                                                phi_4487_ = _e1302;
                                                phi_4599_ = _e1256;
                                                phi_4600_ = _e1258;
                                                phi_4601_ = _e1304;
                                            } else {
                                                phi_4483_ = f64();
                                                phi_4485_ = f64();
                                                phi_4487_ = f64();
                                                phi_4599_ = f64();
                                                phi_4600_ = false;
                                                phi_4601_ = false;
                                            }
                                            let _e1306 = phi_4483_;
                                            let _e1308 = phi_4485_;
                                            let _e1310 = phi_4487_;
                                            let _e1312 = phi_4599_;
                                            let _e1314 = phi_4600_;
                                            let _e1316 = phi_4601_;
                                            local_22 = _e1316;
                                            local_50 = _e1312;
                                            continue;
                                            continuing {
                                                phi_4479_ = _e1230;
                                                phi_4482_ = _e1306;
                                                phi_4484_ = _e1308;
                                                phi_4486_ = _e1310;
                                                break if !(_e1314);
                                            }
                                        }
                                        let _e1319 = local_22;
                                        if _e1319 {
                                            let _e5082 = local_50;
                                            phi_4605_ = _e5082;
                                        } else {
                                            let _e5084 = local_51;
                                            phi_4605_ = _e5084;
                                        }
                                        let _e1321 = phi_4605_;
                                        phi_4606_ = _e1321;
                                    } else {
                                        phi_4606_ = _e1113;
                                    }
                                    let _e1323 = phi_4606_;
                                    if _e1153 {
                                        phi_4614_ = type_29(0u, 64u);
                                        phi_4617_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1327 = phi_4614_;
                                            let _e1329 = phi_4617_;
                                            if (_e1327.member < _e1327.member_1) {
                                                phi_4615_ = type_29((_e1327.member + 1u), _e1327.member_1);
                                                phi_4640_ = type_29(1u, _e1327.member);
                                            } else {
                                                phi_4615_ = _e1327;
                                                phi_4640_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1343 = phi_4615_;
                                            let _e1345 = phi_4640_;
                                            if (bitcast<i32>(_e1345.member) != 0i) {
                                                let _e1349 = (_e1323 + _e1329);
                                                if (_e1349 < _e1117) {
                                                    let _e1352 = (f64(1f) - _e1349);
                                                    let _e1363 = ((((_e553 * _e1352) + (_e576 * _e1349)) * (_e1352 * _e1352)) + (((_e599 * _e1352) + (_e610 * _e1349)) * (_e1349 * _e1349)));
                                                    let _e1365 = (f64(1f) - _e1323);
                                                    let _e1376 = ((((_e553 * _e1365) + (_e576 * _e1323)) * (_e1365 * _e1365)) + (((_e599 * _e1365) + (_e610 * _e1323)) * (_e1323 * _e1323)));
                                                    if (_e1363 < 0.0lf) {
                                                        phi_4683_ = -(_e1363);
                                                    } else {
                                                        phi_4683_ = _e1363;
                                                    }
                                                    let _e1380 = phi_4683_;
                                                    if (_e1380 > _e933) {
                                                        if (_e1376 < 0.0lf) {
                                                            phi_4693_ = -(_e1376);
                                                        } else {
                                                            phi_4693_ = _e1376;
                                                        }
                                                        let _e1385 = phi_4693_;
                                                        if (_e1385 > _e933) {
                                                            phi_4703_ = ((_e1363 > f64(0f)) == (_e1376 > f64(0f)));
                                                        } else {
                                                            phi_4703_ = false;
                                                        }
                                                        let _e1393 = phi_4703_;
                                                        phi_4705_ = !(_e1393);
                                                    } else {
                                                        phi_4705_ = false;
                                                    }
                                                    let _e1396 = phi_4705_;
                                                    if _e1396 {
                                                        phi_4710_ = f64();
                                                        phi_4711_ = false;
                                                    } else {
                                                        phi_4710_ = (_e1329 + _e1329);
                                                        phi_4711_ = true;
                                                    }
                                                    let _e1399 = phi_4710_;
                                                    let _e1401 = phi_4711_;
                                                    phi_4712_ = _e1399;
                                                    phi_4713_ = _e1401;
                                                    phi_4714_ = _e1396;
                                                    phi_4715_ = false;
                                                } else {
                                                    phi_4712_ = f64();
                                                    phi_4713_ = false;
                                                    phi_4714_ = false;
                                                    phi_4715_ = true;
                                                }
                                                let _e1403 = phi_4712_;
                                                let _e1405 = phi_4713_;
                                                let _e1407 = phi_4714_;
                                                let _e1409 = phi_4715_;
                                                phi_4716_ = _e1349;
                                                phi_4618_ = _e1403;
                                                phi_4717_ = _e1405;
                                                phi_4718_ = _e1407;
                                                phi_4719_ = _e1409;
                                                phi_4720_ = false;
                                            } else {
                                                phi_4716_ = f64();
                                                phi_4618_ = f64();
                                                phi_4717_ = false;
                                                phi_4718_ = false;
                                                phi_4719_ = false;
                                                phi_4720_ = true;
                                            }
                                            let _e1411 = phi_4716_;
                                            let _e1413 = phi_4618_;
                                            let _e1415 = phi_4717_;
                                            let _e1417 = phi_4718_;
                                            let _e1419 = phi_4719_;
                                            let _e1421 = phi_4720_;
                                            local_23 = _e1417;
                                            local_52 = _e1419;
                                            local_53 = _e1421;
                                            local_54 = _e1411;
                                            continue;
                                            continuing {
                                                phi_4614_ = _e1343;
                                                phi_4617_ = _e1413;
                                                break if !(_e1415);
                                            }
                                        }
                                        let _e1424 = local_23;
                                        if _e1424 {
                                            phi_4724_ = false;
                                            phi_4725_ = false;
                                        } else {
                                            let _e5109 = local_52;
                                            phi_4724_ = _e5109;
                                            let _e5112 = local_53;
                                            phi_4725_ = _e5112;
                                        }
                                        let _e1426 = phi_4724_;
                                        let _e1428 = phi_4725_;
                                        if _e1426 {
                                            phi_4729_ = true;
                                        } else {
                                            phi_4729_ = _e1428;
                                        }
                                        let _e1430 = phi_4729_;
                                        if _e1430 {
                                            phi_4733_ = _e1117;
                                        } else {
                                            let _e5116 = local_54;
                                            phi_4733_ = _e5116;
                                        }
                                        let _e1432 = phi_4733_;
                                        phi_4734_ = _e1432;
                                    } else {
                                        phi_4734_ = _e1117;
                                    }
                                    let _e1434 = phi_4734_;
                                    phi_4736_ = type_73(_e1323, _e1434, _e1185);
                                } else {
                                    phi_4736_ = _e1191;
                                }
                                let _e1437 = phi_4736_;
                                if (_e1437.member > _e1437.member_1) {
                                    phi_7344_ = f64();
                                    phi_7345_ = true;
                                    phi_7346_ = false;
                                    phi_7347_ = false;
                                    phi_7348_ = false;
                                } else {
                                    let _e1445 = ((_e1437.member_1 - _e1437.member) * f64(0.5f));
                                    let _e1446 = (_e1437.member + _e1445);
                                    let _e1449 = (_e1445 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1451 = local_20.member_3;
                                    let _e1454 = local_20.member[0u];
                                    if (_e1454[0] < 0.0lf) {
                                        phi_4767_ = -(_e1454[0]);
                                    } else {
                                        phi_4767_ = _e1454[0];
                                    }
                                    let _e1461 = phi_4767_;
                                    if (_e1454[1] < 0.0lf) {
                                        phi_4774_ = -(_e1454[1]);
                                    } else {
                                        phi_4774_ = _e1454[1];
                                    }
                                    let _e1465 = phi_4774_;
                                    if (_e1461 > _e1465) {
                                        phi_4779_ = _e1461;
                                    } else {
                                        phi_4779_ = _e1465;
                                    }
                                    let _e1468 = phi_4779_;
                                    if (_e1454[2] < 0.0lf) {
                                        phi_4786_ = -(_e1454[2]);
                                    } else {
                                        phi_4786_ = _e1454[2];
                                    }
                                    let _e1472 = phi_4786_;
                                    if (_e1468 > _e1472) {
                                        phi_4791_ = _e1468;
                                    } else {
                                        phi_4791_ = _e1472;
                                    }
                                    let _e1475 = phi_4791_;
                                    let _e1477 = local_20.member[1u];
                                    if (_e1477[0] < 0.0lf) {
                                        phi_4804_ = -(_e1477[0]);
                                    } else {
                                        phi_4804_ = _e1477[0];
                                    }
                                    let _e1484 = phi_4804_;
                                    if (_e1477[1] < 0.0lf) {
                                        phi_4811_ = -(_e1477[1]);
                                    } else {
                                        phi_4811_ = _e1477[1];
                                    }
                                    let _e1488 = phi_4811_;
                                    if (_e1484 > _e1488) {
                                        phi_4816_ = _e1484;
                                    } else {
                                        phi_4816_ = _e1488;
                                    }
                                    let _e1491 = phi_4816_;
                                    if (_e1477[2] < 0.0lf) {
                                        phi_4823_ = -(_e1477[2]);
                                    } else {
                                        phi_4823_ = _e1477[2];
                                    }
                                    let _e1495 = phi_4823_;
                                    if (_e1491 > _e1495) {
                                        phi_4828_ = _e1491;
                                    } else {
                                        phi_4828_ = _e1495;
                                    }
                                    let _e1498 = phi_4828_;
                                    if (_e1475 > _e1498) {
                                        phi_4833_ = _e1475;
                                    } else {
                                        phi_4833_ = _e1498;
                                    }
                                    let _e1501 = phi_4833_;
                                    let _e1504 = local_20.member[0u];
                                    let _e1509 = local_20.member[1u];
                                    let _e1519 = (_e1504[0] + ((_e1509[0] - _e1504[0]) * _e1446));
                                    let _e1520 = (_e1504[1] + ((_e1509[1] - _e1504[1]) * _e1446));
                                    let _e1521 = (_e1504[2] + ((_e1509[2] - _e1504[2]) * _e1446));
                                    let _e1523 = local_20.member[1u];
                                    let _e1528 = local_20.member[0u];
                                    let _e1532 = (_e1523[0] - _e1528[0]);
                                    let _e1533 = (_e1523[1] - _e1528[1]);
                                    let _e1534 = (_e1523[2] - _e1528[2]);
                                    if (_e1532 < 0.0lf) {
                                        phi_4892_ = -(_e1532);
                                    } else {
                                        phi_4892_ = _e1532;
                                    }
                                    let _e1538 = phi_4892_;
                                    if (_e1533 < 0.0lf) {
                                        phi_4898_ = -(_e1533);
                                    } else {
                                        phi_4898_ = _e1533;
                                    }
                                    let _e1542 = phi_4898_;
                                    if (_e1538 > _e1542) {
                                        phi_4903_ = _e1538;
                                    } else {
                                        phi_4903_ = _e1542;
                                    }
                                    let _e1545 = phi_4903_;
                                    if (_e1534 < 0.0lf) {
                                        phi_4909_ = -(_e1534);
                                    } else {
                                        phi_4909_ = _e1534;
                                    }
                                    let _e1549 = phi_4909_;
                                    if (_e1545 > _e1549) {
                                        phi_4914_ = _e1545;
                                    } else {
                                        phi_4914_ = _e1549;
                                    }
                                    let _e1552 = phi_4914_;
                                    let _e1560 = ((((_e1449 * _e1552) * f64(1.01f)) + ((_e1501 + _e1451) * (1.1102230246251565e-16lf * f64(8f)))) + _e1451);
                                    if (_e1519 < 0.0lf) {
                                        phi_4928_ = -(_e1519);
                                    } else {
                                        phi_4928_ = _e1519;
                                    }
                                    let _e1564 = phi_4928_;
                                    if (_e1520 < 0.0lf) {
                                        phi_4934_ = -(_e1520);
                                    } else {
                                        phi_4934_ = _e1520;
                                    }
                                    let _e1568 = phi_4934_;
                                    if (_e1564 > _e1568) {
                                        phi_4939_ = _e1564;
                                    } else {
                                        phi_4939_ = _e1568;
                                    }
                                    let _e1571 = phi_4939_;
                                    if (_e1521 < 0.0lf) {
                                        phi_4945_ = -(_e1521);
                                    } else {
                                        phi_4945_ = _e1521;
                                    }
                                    let _e1575 = phi_4945_;
                                    if (_e1571 > _e1575) {
                                        phi_4950_ = _e1571;
                                    } else {
                                        phi_4950_ = _e1575;
                                    }
                                    let _e1578 = phi_4950_;
                                    local_3 = type_51(array<f64, 3>(_e1519, _e1520, _e1521), _e1560, (_e1578 + _e1560));
                                    let _e1584 = local_20.member_3;
                                    let _e1586 = local_20.member_1[0u];
                                    if (_e1586[0] < 0.0lf) {
                                        phi_4976_ = -(_e1586[0]);
                                    } else {
                                        phi_4976_ = _e1586[0];
                                    }
                                    let _e1593 = phi_4976_;
                                    if (_e1586[1] < 0.0lf) {
                                        phi_4983_ = -(_e1586[1]);
                                    } else {
                                        phi_4983_ = _e1586[1];
                                    }
                                    let _e1597 = phi_4983_;
                                    if (_e1593 > _e1597) {
                                        phi_4988_ = _e1593;
                                    } else {
                                        phi_4988_ = _e1597;
                                    }
                                    let _e1600 = phi_4988_;
                                    if (_e1586[2] < 0.0lf) {
                                        phi_4995_ = -(_e1586[2]);
                                    } else {
                                        phi_4995_ = _e1586[2];
                                    }
                                    let _e1604 = phi_4995_;
                                    if (_e1600 > _e1604) {
                                        phi_5000_ = _e1600;
                                    } else {
                                        phi_5000_ = _e1604;
                                    }
                                    let _e1607 = phi_5000_;
                                    let _e1609 = local_20.member_1[1u];
                                    if (_e1609[0] < 0.0lf) {
                                        phi_5013_ = -(_e1609[0]);
                                    } else {
                                        phi_5013_ = _e1609[0];
                                    }
                                    let _e1616 = phi_5013_;
                                    if (_e1609[1] < 0.0lf) {
                                        phi_5020_ = -(_e1609[1]);
                                    } else {
                                        phi_5020_ = _e1609[1];
                                    }
                                    let _e1620 = phi_5020_;
                                    if (_e1616 > _e1620) {
                                        phi_5025_ = _e1616;
                                    } else {
                                        phi_5025_ = _e1620;
                                    }
                                    let _e1623 = phi_5025_;
                                    if (_e1609[2] < 0.0lf) {
                                        phi_5032_ = -(_e1609[2]);
                                    } else {
                                        phi_5032_ = _e1609[2];
                                    }
                                    let _e1627 = phi_5032_;
                                    if (_e1623 > _e1627) {
                                        phi_5037_ = _e1623;
                                    } else {
                                        phi_5037_ = _e1627;
                                    }
                                    let _e1630 = phi_5037_;
                                    if (_e1607 > _e1630) {
                                        phi_5042_ = _e1607;
                                    } else {
                                        phi_5042_ = _e1630;
                                    }
                                    let _e1633 = phi_5042_;
                                    let _e1636 = local_20.member_1[0u];
                                    let _e1641 = local_20.member_1[1u];
                                    let _e1651 = (_e1636[0] + ((_e1641[0] - _e1636[0]) * _e1446));
                                    let _e1652 = (_e1636[1] + ((_e1641[1] - _e1636[1]) * _e1446));
                                    let _e1653 = (_e1636[2] + ((_e1641[2] - _e1636[2]) * _e1446));
                                    let _e1655 = local_20.member_1[1u];
                                    let _e1660 = local_20.member_1[0u];
                                    let _e1664 = (_e1655[0] - _e1660[0]);
                                    let _e1665 = (_e1655[1] - _e1660[1]);
                                    let _e1666 = (_e1655[2] - _e1660[2]);
                                    if (_e1664 < 0.0lf) {
                                        phi_5101_ = -(_e1664);
                                    } else {
                                        phi_5101_ = _e1664;
                                    }
                                    let _e1670 = phi_5101_;
                                    if (_e1665 < 0.0lf) {
                                        phi_5107_ = -(_e1665);
                                    } else {
                                        phi_5107_ = _e1665;
                                    }
                                    let _e1674 = phi_5107_;
                                    if (_e1670 > _e1674) {
                                        phi_5112_ = _e1670;
                                    } else {
                                        phi_5112_ = _e1674;
                                    }
                                    let _e1677 = phi_5112_;
                                    if (_e1666 < 0.0lf) {
                                        phi_5118_ = -(_e1666);
                                    } else {
                                        phi_5118_ = _e1666;
                                    }
                                    let _e1681 = phi_5118_;
                                    if (_e1677 > _e1681) {
                                        phi_5123_ = _e1677;
                                    } else {
                                        phi_5123_ = _e1681;
                                    }
                                    let _e1684 = phi_5123_;
                                    let _e1692 = ((((_e1449 * _e1684) * f64(1.01f)) + ((_e1633 + _e1584) * (1.1102230246251565e-16lf * f64(8f)))) + _e1584);
                                    if (_e1651 < 0.0lf) {
                                        phi_5137_ = -(_e1651);
                                    } else {
                                        phi_5137_ = _e1651;
                                    }
                                    let _e1696 = phi_5137_;
                                    if (_e1652 < 0.0lf) {
                                        phi_5143_ = -(_e1652);
                                    } else {
                                        phi_5143_ = _e1652;
                                    }
                                    let _e1700 = phi_5143_;
                                    if (_e1696 > _e1700) {
                                        phi_5148_ = _e1696;
                                    } else {
                                        phi_5148_ = _e1700;
                                    }
                                    let _e1703 = phi_5148_;
                                    if (_e1653 < 0.0lf) {
                                        phi_5154_ = -(_e1653);
                                    } else {
                                        phi_5154_ = _e1653;
                                    }
                                    let _e1707 = phi_5154_;
                                    if (_e1703 > _e1707) {
                                        phi_5159_ = _e1703;
                                    } else {
                                        phi_5159_ = _e1707;
                                    }
                                    let _e1710 = phi_5159_;
                                    local_4 = type_51(array<f64, 3>(_e1651, _e1652, _e1653), _e1692, (_e1710 + _e1692));
                                    let _e1716 = local_20.member_3;
                                    let _e1718 = local_20.member_2[0u];
                                    if (_e1718[0] < 0.0lf) {
                                        phi_5185_ = -(_e1718[0]);
                                    } else {
                                        phi_5185_ = _e1718[0];
                                    }
                                    let _e1725 = phi_5185_;
                                    if (_e1718[1] < 0.0lf) {
                                        phi_5192_ = -(_e1718[1]);
                                    } else {
                                        phi_5192_ = _e1718[1];
                                    }
                                    let _e1729 = phi_5192_;
                                    if (_e1725 > _e1729) {
                                        phi_5197_ = _e1725;
                                    } else {
                                        phi_5197_ = _e1729;
                                    }
                                    let _e1732 = phi_5197_;
                                    if (_e1718[2] < 0.0lf) {
                                        phi_5204_ = -(_e1718[2]);
                                    } else {
                                        phi_5204_ = _e1718[2];
                                    }
                                    let _e1736 = phi_5204_;
                                    if (_e1732 > _e1736) {
                                        phi_5209_ = _e1732;
                                    } else {
                                        phi_5209_ = _e1736;
                                    }
                                    let _e1739 = phi_5209_;
                                    let _e1741 = local_20.member_2[1u];
                                    if (_e1741[0] < 0.0lf) {
                                        phi_5222_ = -(_e1741[0]);
                                    } else {
                                        phi_5222_ = _e1741[0];
                                    }
                                    let _e1748 = phi_5222_;
                                    if (_e1741[1] < 0.0lf) {
                                        phi_5229_ = -(_e1741[1]);
                                    } else {
                                        phi_5229_ = _e1741[1];
                                    }
                                    let _e1752 = phi_5229_;
                                    if (_e1748 > _e1752) {
                                        phi_5234_ = _e1748;
                                    } else {
                                        phi_5234_ = _e1752;
                                    }
                                    let _e1755 = phi_5234_;
                                    if (_e1741[2] < 0.0lf) {
                                        phi_5241_ = -(_e1741[2]);
                                    } else {
                                        phi_5241_ = _e1741[2];
                                    }
                                    let _e1759 = phi_5241_;
                                    if (_e1755 > _e1759) {
                                        phi_5246_ = _e1755;
                                    } else {
                                        phi_5246_ = _e1759;
                                    }
                                    let _e1762 = phi_5246_;
                                    if (_e1739 > _e1762) {
                                        phi_5251_ = _e1739;
                                    } else {
                                        phi_5251_ = _e1762;
                                    }
                                    let _e1765 = phi_5251_;
                                    let _e1768 = local_20.member_2[0u];
                                    let _e1773 = local_20.member_2[1u];
                                    let _e1783 = (_e1768[0] + ((_e1773[0] - _e1768[0]) * _e1446));
                                    let _e1784 = (_e1768[1] + ((_e1773[1] - _e1768[1]) * _e1446));
                                    let _e1785 = (_e1768[2] + ((_e1773[2] - _e1768[2]) * _e1446));
                                    let _e1787 = local_20.member_2[1u];
                                    let _e1792 = local_20.member_2[0u];
                                    let _e1796 = (_e1787[0] - _e1792[0]);
                                    let _e1797 = (_e1787[1] - _e1792[1]);
                                    let _e1798 = (_e1787[2] - _e1792[2]);
                                    if (_e1796 < 0.0lf) {
                                        phi_5310_ = -(_e1796);
                                    } else {
                                        phi_5310_ = _e1796;
                                    }
                                    let _e1802 = phi_5310_;
                                    if (_e1797 < 0.0lf) {
                                        phi_5316_ = -(_e1797);
                                    } else {
                                        phi_5316_ = _e1797;
                                    }
                                    let _e1806 = phi_5316_;
                                    if (_e1802 > _e1806) {
                                        phi_5321_ = _e1802;
                                    } else {
                                        phi_5321_ = _e1806;
                                    }
                                    let _e1809 = phi_5321_;
                                    if (_e1798 < 0.0lf) {
                                        phi_5327_ = -(_e1798);
                                    } else {
                                        phi_5327_ = _e1798;
                                    }
                                    let _e1813 = phi_5327_;
                                    if (_e1809 > _e1813) {
                                        phi_5332_ = _e1809;
                                    } else {
                                        phi_5332_ = _e1813;
                                    }
                                    let _e1816 = phi_5332_;
                                    let _e1824 = ((((_e1449 * _e1816) * f64(1.01f)) + ((_e1765 + _e1716) * (1.1102230246251565e-16lf * f64(8f)))) + _e1716);
                                    if (_e1783 < 0.0lf) {
                                        phi_5346_ = -(_e1783);
                                    } else {
                                        phi_5346_ = _e1783;
                                    }
                                    let _e1828 = phi_5346_;
                                    if (_e1784 < 0.0lf) {
                                        phi_5352_ = -(_e1784);
                                    } else {
                                        phi_5352_ = _e1784;
                                    }
                                    let _e1832 = phi_5352_;
                                    if (_e1828 > _e1832) {
                                        phi_5357_ = _e1828;
                                    } else {
                                        phi_5357_ = _e1832;
                                    }
                                    let _e1835 = phi_5357_;
                                    if (_e1785 < 0.0lf) {
                                        phi_5363_ = -(_e1785);
                                    } else {
                                        phi_5363_ = _e1785;
                                    }
                                    let _e1839 = phi_5363_;
                                    if (_e1835 > _e1839) {
                                        phi_5368_ = _e1835;
                                    } else {
                                        phi_5368_ = _e1839;
                                    }
                                    let _e1842 = phi_5368_;
                                    local_5 = type_51(array<f64, 3>(_e1783, _e1784, _e1785), _e1824, (_e1842 + _e1824));
                                    let _e1847 = local_4.member;
                                    let _e1852 = local_5.member;
                                    let _e1858 = ((_e1847[1] * _e1852[2]) - (_e1847[2] * _e1852[1]));
                                    let _e1861 = ((_e1847[2] * _e1852[0]) - (_e1847[0] * _e1852[2]));
                                    let _e1864 = ((_e1847[0] * _e1852[1]) - (_e1847[1] * _e1852[0]));
                                    if (_e1858 < 0.0lf) {
                                        phi_5417_ = -(_e1858);
                                    } else {
                                        phi_5417_ = _e1858;
                                    }
                                    let _e1868 = phi_5417_;
                                    if (_e1861 < 0.0lf) {
                                        phi_5423_ = -(_e1861);
                                    } else {
                                        phi_5423_ = _e1861;
                                    }
                                    let _e1872 = phi_5423_;
                                    if (_e1868 > _e1872) {
                                        if (_e1858 < 0.0lf) {
                                            phi_5433_ = -(_e1858);
                                        } else {
                                            phi_5433_ = _e1858;
                                        }
                                        let _e1890 = phi_5433_;
                                        if (_e1864 < 0.0lf) {
                                            phi_5439_ = -(_e1864);
                                        } else {
                                            phi_5439_ = _e1864;
                                        }
                                        let _e1894 = phi_5439_;
                                        if (_e1890 > _e1894) {
                                            phi_5444_ = 2u;
                                            phi_5445_ = 1u;
                                        } else {
                                            phi_5444_ = 1u;
                                            phi_5445_ = 0u;
                                        }
                                        let _e1897 = phi_5444_;
                                        let _e1899 = phi_5445_;
                                        phi_5464_ = _e1897;
                                        phi_5465_ = _e1899;
                                    } else {
                                        if (_e1861 < 0.0lf) {
                                            phi_5451_ = -(_e1861);
                                        } else {
                                            phi_5451_ = _e1861;
                                        }
                                        let _e1877 = phi_5451_;
                                        if (_e1864 < 0.0lf) {
                                            phi_5457_ = -(_e1864);
                                        } else {
                                            phi_5457_ = _e1864;
                                        }
                                        let _e1881 = phi_5457_;
                                        if (_e1877 > _e1881) {
                                            phi_5462_ = 0u;
                                            phi_5463_ = 2u;
                                        } else {
                                            phi_5462_ = 1u;
                                            phi_5463_ = 0u;
                                        }
                                        let _e1884 = phi_5462_;
                                        let _e1886 = phi_5463_;
                                        phi_5464_ = _e1884;
                                        phi_5465_ = _e1886;
                                    }
                                    let _e1901 = phi_5464_;
                                    let _e1903 = phi_5465_;
                                    if (_e1903 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1907 = local_4.member[_e1903];
                                    if (_e1901 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1911 = local_5.member[_e1901];
                                    if (_e1901 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1916 = local_4.member[_e1901];
                                    if (_e1903 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1920 = local_5.member[_e1903];
                                    let _e1922 = ((_e1907 * _e1911) - (_e1916 * _e1920));
                                    let _e1923 = f64(1f);
                                    let _e1925 = local_4.member_1;
                                    let _e1927 = local_5.member_2;
                                    let _e1930 = local_4.member_2;
                                    let _e1932 = local_5.member_1;
                                    let _e1938 = local_4.member_2;
                                    let _e1940 = local_5.member_2;
                                    let _e1949 = local_4.member_2;
                                    let _e1952 = local_5.member_2;
                                    let _e1956 = (((((_e1925 * _e1927) + (_e1930 * _e1932)) * f64(2.01f)) + ((_e1938 * _e1940) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1923 + _e1949) * (_e1923 + _e1952))));
                                    if (_e1922 < 0.0lf) {
                                        phi_5536_ = -(_e1922);
                                    } else {
                                        phi_5536_ = _e1922;
                                    }
                                    let _e1960 = phi_5536_;
                                    if (_e1960 > _e1956) {
                                        if (_e1922 < f64(0f)) {
                                            phi_5548_ = f64(-1f);
                                        } else {
                                            phi_5548_ = f64(1f);
                                        }
                                        let _e1967 = phi_5548_;
                                        if (_e1903 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1971 = local_3.member[_e1903];
                                        if (_e1901 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1975 = local_5.member[_e1901];
                                        if (_e1901 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1980 = local_3.member[_e1901];
                                        if (_e1903 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1984 = local_5.member[_e1903];
                                        let _e1987 = f64(1f);
                                        let _e1989 = local_3.member_1;
                                        let _e1991 = local_5.member_2;
                                        let _e1994 = local_3.member_2;
                                        let _e1996 = local_5.member_1;
                                        let _e2002 = local_3.member_2;
                                        let _e2004 = local_5.member_2;
                                        let _e2013 = local_3.member_2;
                                        let _e2016 = local_5.member_2;
                                        let _e2020 = (((((_e1989 * _e1991) + (_e1994 * _e1996)) * f64(2.01f)) + ((_e2002 * _e2004) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1987 + _e2013) * (_e1987 + _e2016))));
                                        if (_e1903 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2024 = local_4.member[_e1903];
                                        if (_e1901 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2028 = local_3.member[_e1901];
                                        if (_e1901 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2033 = local_4.member[_e1901];
                                        if (_e1903 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2037 = local_3.member[_e1903];
                                        let _e2040 = f64(1f);
                                        let _e2042 = local_4.member_1;
                                        let _e2044 = local_3.member_2;
                                        let _e2047 = local_4.member_2;
                                        let _e2049 = local_3.member_1;
                                        let _e2055 = local_4.member_2;
                                        let _e2057 = local_3.member_2;
                                        let _e2066 = local_4.member_2;
                                        let _e2069 = local_3.member_2;
                                        let _e2073 = (((((_e2042 * _e2044) + (_e2047 * _e2049)) * f64(2.01f)) + ((_e2055 * _e2057) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2040 + _e2066) * (_e2040 + _e2069))));
                                        let _e2074 = (_e1922 * _e1967);
                                        let _e2075 = (((_e1971 * _e1975) - (_e1980 * _e1984)) * _e1967);
                                        let _e2076 = (((_e2024 * _e2028) - (_e2033 * _e2037)) * _e1967);
                                        if (_e2074 < 0.0lf) {
                                            phi_5687_ = -(_e2074);
                                        } else {
                                            phi_5687_ = _e2074;
                                        }
                                        let _e2080 = phi_5687_;
                                        if (_e2075 < 0.0lf) {
                                            phi_5693_ = -(_e2075);
                                        } else {
                                            phi_5693_ = _e2075;
                                        }
                                        let _e2084 = phi_5693_;
                                        if (_e2076 < 0.0lf) {
                                            phi_5700_ = -(_e2076);
                                        } else {
                                            phi_5700_ = _e2076;
                                        }
                                        let _e2089 = phi_5700_;
                                        let _e2095 = ((_e2074 - _e2075) - _e2076);
                                        let _e2098 = (((_e1956 + _e2020) + _e2073) + (((_e2080 + _e2084) + _e2089) * (1.1102230246251565e-16lf * f64(4f))));
                                        local_6[0u].member = _e2075;
                                        local_6[0u].member_1 = _e2020;
                                        local_6[1u].member = _e2076;
                                        local_6[1u].member_1 = _e2073;
                                        local_6[2u].member = _e2095;
                                        local_6[2u].member_1 = _e2098;
                                        local_6[3u].member = _e2095;
                                        local_6[3u].member_1 = _e2098;
                                        phi_5744_ = type_29(0u, 4u);
                                        phi_5747_ = true;
                                        loop {
                                            let _e2113 = phi_5744_;
                                            let _e2115 = phi_5747_;
                                            local_25 = _e2115;
                                            if (_e2113.member < _e2113.member_1) {
                                                phi_5745_ = type_29((_e2113.member + 1u), _e2113.member_1);
                                                phi_5770_ = type_29(1u, _e2113.member);
                                            } else {
                                                phi_5745_ = _e2113;
                                                phi_5770_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e2129 = phi_5745_;
                                            let _e2131 = phi_5770_;
                                            if (bitcast<i32>(_e2131.member) != 0i) {
                                                if (_e2131.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e2139 = local_6[_e2131.member_1].member;
                                                let _e2142 = local_6[_e2131.member_1].member_1;
                                                let _e2144 = (_e2139 < -(_e2142));
                                                if _e2144 {
                                                    phi_5797_ = bool();
                                                    phi_5798_ = false;
                                                } else {
                                                    phi_5797_ = (_e2115 && (_e2139 > _e2142));
                                                    phi_5798_ = true;
                                                }
                                                let _e2148 = phi_5797_;
                                                let _e2150 = phi_5798_;
                                                phi_5748_ = _e2148;
                                                phi_5799_ = _e2150;
                                                phi_5800_ = _e2144;
                                            } else {
                                                phi_5748_ = bool();
                                                phi_5799_ = false;
                                                phi_5800_ = false;
                                            }
                                            let _e2152 = phi_5748_;
                                            let _e2154 = phi_5799_;
                                            let _e2156 = phi_5800_;
                                            local_24 = _e2156;
                                            continue;
                                            continuing {
                                                phi_5744_ = _e2129;
                                                phi_5747_ = _e2152;
                                                break if !(_e2154);
                                            }
                                        }
                                        let _e2159 = local_24;
                                        if _e2159 {
                                            phi_5804_ = false;
                                        } else {
                                            phi_5804_ = true;
                                        }
                                        let _e2161 = phi_5804_;
                                        if _e2161 {
                                            let _e2163 = local_25;
                                            if _e2163 {
                                                phi_5811_ = 1u;
                                            } else {
                                                phi_5811_ = 2u;
                                            }
                                            let _e2165 = phi_5811_;
                                            phi_5812_ = _e2165;
                                            phi_5813_ = false;
                                        } else {
                                            phi_5812_ = u32();
                                            phi_5813_ = true;
                                        }
                                        let _e2167 = phi_5812_;
                                        let _e2169 = phi_5813_;
                                        phi_5814_ = _e2167;
                                        phi_5815_ = 0u;
                                        phi_5816_ = _e2169;
                                    } else {
                                        phi_5814_ = u32();
                                        phi_5815_ = 2u;
                                        phi_5816_ = true;
                                    }
                                    let _e2171 = phi_5814_;
                                    let _e2173 = phi_5815_;
                                    let _e2175 = phi_5816_;
                                    if _e2175 {
                                        phi_5820_ = _e2173;
                                    } else {
                                        phi_5820_ = _e2171;
                                    }
                                    let _e2177 = phi_5820_;
                                    let _e2178 = (_e2177 == 0u);
                                    if _e2178 {
                                        phi_7340_ = f64();
                                        phi_7341_ = false;
                                        phi_7342_ = false;
                                        phi_7343_ = false;
                                    } else {
                                        if (_e2177 == 1u) {
                                            if _e1437.member_2 {
                                                if ((_e1437.member_1 - _e1437.member) <= f64(0.0000005f)) {
                                                    phi_5841_ = false;
                                                } else {
                                                    phi_5841_ = true;
                                                }
                                                let _e2187 = phi_5841_;
                                                phi_5842_ = _e2187;
                                            } else {
                                                phi_5842_ = true;
                                            }
                                            let _e2189 = phi_5842_;
                                            phi_5843_ = _e2189;
                                        } else {
                                            phi_5843_ = true;
                                        }
                                        let _e2191 = phi_5843_;
                                        if _e2191 {
                                            let _e2197 = local_20.member[0u];
                                            let _e2203 = local_20.member_1[0u];
                                            let _e2209 = local_20.member_2[0u];
                                            local_1 = array<array<f64, 3>, 4>(_e2197, array<f64, 3>((_e2197[0] - _e2203[0]), (_e2197[1] - _e2203[1]), (_e2197[2] - _e2203[2])), array<f64, 3>((_e2197[0] - _e2209[0]), (_e2197[1] - _e2209[1]), (_e2197[2] - _e2209[2])), _e2197);
                                            let _e2224 = local_20.member[1u];
                                            let _e2230 = local_20.member_1[1u];
                                            let _e2236 = local_20.member_2[1u];
                                            local_2 = array<array<f64, 3>, 4>(_e2224, array<f64, 3>((_e2224[0] - _e2230[0]), (_e2224[1] - _e2230[1]), (_e2224[2] - _e2230[2])), array<f64, 3>((_e2224[0] - _e2236[0]), (_e2224[1] - _e2236[1]), (_e2224[2] - _e2236[2])), _e2224);
                                            let _e2251 = local_20.member[0u];
                                            if (_e2251[0] < 0.0lf) {
                                                phi_6040_ = -(_e2251[0]);
                                            } else {
                                                phi_6040_ = _e2251[0];
                                            }
                                            let _e2258 = phi_6040_;
                                            if (_e2251[1] < 0.0lf) {
                                                phi_6047_ = -(_e2251[1]);
                                            } else {
                                                phi_6047_ = _e2251[1];
                                            }
                                            let _e2262 = phi_6047_;
                                            if (_e2258 > _e2262) {
                                                phi_6052_ = _e2258;
                                            } else {
                                                phi_6052_ = _e2262;
                                            }
                                            let _e2265 = phi_6052_;
                                            if (_e2251[2] < 0.0lf) {
                                                phi_6059_ = -(_e2251[2]);
                                            } else {
                                                phi_6059_ = _e2251[2];
                                            }
                                            let _e2269 = phi_6059_;
                                            if (_e2265 > _e2269) {
                                                phi_6064_ = _e2265;
                                            } else {
                                                phi_6064_ = _e2269;
                                            }
                                            let _e2272 = phi_6064_;
                                            let _e2275 = local_20.member[1u];
                                            if (_e2275[0] < 0.0lf) {
                                                phi_6077_ = -(_e2275[0]);
                                            } else {
                                                phi_6077_ = _e2275[0];
                                            }
                                            let _e2282 = phi_6077_;
                                            if (_e2275[1] < 0.0lf) {
                                                phi_6084_ = -(_e2275[1]);
                                            } else {
                                                phi_6084_ = _e2275[1];
                                            }
                                            let _e2286 = phi_6084_;
                                            if (_e2282 > _e2286) {
                                                phi_6089_ = _e2282;
                                            } else {
                                                phi_6089_ = _e2286;
                                            }
                                            let _e2289 = phi_6089_;
                                            if (_e2275[2] < 0.0lf) {
                                                phi_6096_ = -(_e2275[2]);
                                            } else {
                                                phi_6096_ = _e2275[2];
                                            }
                                            let _e2293 = phi_6096_;
                                            if (_e2289 > _e2293) {
                                                phi_6101_ = _e2289;
                                            } else {
                                                phi_6101_ = _e2293;
                                            }
                                            let _e2296 = phi_6101_;
                                            if (_e2272 > _e2296) {
                                                phi_6106_ = _e2272;
                                            } else {
                                                phi_6106_ = _e2296;
                                            }
                                            let _e2299 = phi_6106_;
                                            let _e2301 = local_20.member_3;
                                            let _e2305 = local_20.member_1[0u];
                                            if (_e2305[0] < 0.0lf) {
                                                phi_6123_ = -(_e2305[0]);
                                            } else {
                                                phi_6123_ = _e2305[0];
                                            }
                                            let _e2312 = phi_6123_;
                                            if (_e2305[1] < 0.0lf) {
                                                phi_6130_ = -(_e2305[1]);
                                            } else {
                                                phi_6130_ = _e2305[1];
                                            }
                                            let _e2316 = phi_6130_;
                                            if (_e2312 > _e2316) {
                                                phi_6135_ = _e2312;
                                            } else {
                                                phi_6135_ = _e2316;
                                            }
                                            let _e2319 = phi_6135_;
                                            if (_e2305[2] < 0.0lf) {
                                                phi_6142_ = -(_e2305[2]);
                                            } else {
                                                phi_6142_ = _e2305[2];
                                            }
                                            let _e2323 = phi_6142_;
                                            if (_e2319 > _e2323) {
                                                phi_6147_ = _e2319;
                                            } else {
                                                phi_6147_ = _e2323;
                                            }
                                            let _e2326 = phi_6147_;
                                            let _e2329 = local_20.member_1[1u];
                                            if (_e2329[0] < 0.0lf) {
                                                phi_6161_ = -(_e2329[0]);
                                            } else {
                                                phi_6161_ = _e2329[0];
                                            }
                                            let _e2336 = phi_6161_;
                                            if (_e2329[1] < 0.0lf) {
                                                phi_6168_ = -(_e2329[1]);
                                            } else {
                                                phi_6168_ = _e2329[1];
                                            }
                                            let _e2340 = phi_6168_;
                                            if (_e2336 > _e2340) {
                                                phi_6173_ = _e2336;
                                            } else {
                                                phi_6173_ = _e2340;
                                            }
                                            let _e2343 = phi_6173_;
                                            if (_e2329[2] < 0.0lf) {
                                                phi_6180_ = -(_e2329[2]);
                                            } else {
                                                phi_6180_ = _e2329[2];
                                            }
                                            let _e2347 = phi_6180_;
                                            if (_e2343 > _e2347) {
                                                phi_6185_ = _e2343;
                                            } else {
                                                phi_6185_ = _e2347;
                                            }
                                            let _e2350 = phi_6185_;
                                            if (_e2326 > _e2350) {
                                                phi_6190_ = _e2326;
                                            } else {
                                                phi_6190_ = _e2350;
                                            }
                                            let _e2353 = phi_6190_;
                                            let _e2355 = local_20.member_3;
                                            let _e2359 = local_20.member_2[0u];
                                            if (_e2359[0] < 0.0lf) {
                                                phi_6207_ = -(_e2359[0]);
                                            } else {
                                                phi_6207_ = _e2359[0];
                                            }
                                            let _e2366 = phi_6207_;
                                            if (_e2359[1] < 0.0lf) {
                                                phi_6214_ = -(_e2359[1]);
                                            } else {
                                                phi_6214_ = _e2359[1];
                                            }
                                            let _e2370 = phi_6214_;
                                            if (_e2366 > _e2370) {
                                                phi_6219_ = _e2366;
                                            } else {
                                                phi_6219_ = _e2370;
                                            }
                                            let _e2373 = phi_6219_;
                                            if (_e2359[2] < 0.0lf) {
                                                phi_6226_ = -(_e2359[2]);
                                            } else {
                                                phi_6226_ = _e2359[2];
                                            }
                                            let _e2377 = phi_6226_;
                                            if (_e2373 > _e2377) {
                                                phi_6231_ = _e2373;
                                            } else {
                                                phi_6231_ = _e2377;
                                            }
                                            let _e2380 = phi_6231_;
                                            let _e2383 = local_20.member_2[1u];
                                            if (_e2383[0] < 0.0lf) {
                                                phi_6245_ = -(_e2383[0]);
                                            } else {
                                                phi_6245_ = _e2383[0];
                                            }
                                            let _e2390 = phi_6245_;
                                            if (_e2383[1] < 0.0lf) {
                                                phi_6252_ = -(_e2383[1]);
                                            } else {
                                                phi_6252_ = _e2383[1];
                                            }
                                            let _e2394 = phi_6252_;
                                            if (_e2390 > _e2394) {
                                                phi_6257_ = _e2390;
                                            } else {
                                                phi_6257_ = _e2394;
                                            }
                                            let _e2397 = phi_6257_;
                                            if (_e2383[2] < 0.0lf) {
                                                phi_6264_ = -(_e2383[2]);
                                            } else {
                                                phi_6264_ = _e2383[2];
                                            }
                                            let _e2401 = phi_6264_;
                                            if (_e2397 > _e2401) {
                                                phi_6269_ = _e2397;
                                            } else {
                                                phi_6269_ = _e2401;
                                            }
                                            let _e2404 = phi_6269_;
                                            if (_e2380 > _e2404) {
                                                phi_6274_ = _e2380;
                                            } else {
                                                phi_6274_ = _e2404;
                                            }
                                            let _e2407 = phi_6274_;
                                            let _e2409 = local_20.member_3;
                                            let _e2417 = local_20.member_3;
                                            phi_6294_ = type_29(0u, 48u);
                                            phi_6297_ = _e1437.member;
                                            loop {
                                                let _e2426 = phi_6294_;
                                                let _e2428 = phi_6297_;
                                                local_65 = _e2428;
                                                local_32 = _e2428;
                                                local_33 = _e2428;
                                                local_34 = _e2428;
                                                if (_e2426.member < _e2426.member_1) {
                                                    phi_6295_ = type_29((_e2426.member + 1u), _e2426.member_1);
                                                    phi_6320_ = type_29(1u, _e2426.member);
                                                } else {
                                                    phi_6295_ = _e2426;
                                                    phi_6320_ = type_29(0u, type_29().member_1);
                                                }
                                                let _e2442 = phi_6295_;
                                                let _e2444 = phi_6320_;
                                                if (bitcast<i32>(_e2444.member) != 0i) {
                                                    let _e2450 = local_20.member[0u];
                                                    let _e2456 = local_20.member[1u];
                                                    let _e2466 = (_e2450[0] + ((_e2456[0] - _e2450[0]) * _e2428));
                                                    let _e2467 = (_e2450[1] + ((_e2456[1] - _e2450[1]) * _e2428));
                                                    let _e2468 = (_e2450[2] + ((_e2456[2] - _e2450[2]) * _e2428));
                                                    let _e2471 = local_20.member_1[0u];
                                                    let _e2477 = local_20.member_1[1u];
                                                    let _e2487 = (_e2471[0] + ((_e2477[0] - _e2471[0]) * _e2428));
                                                    let _e2488 = (_e2471[1] + ((_e2477[1] - _e2471[1]) * _e2428));
                                                    let _e2489 = (_e2471[2] + ((_e2477[2] - _e2471[2]) * _e2428));
                                                    let _e2492 = local_20.member_2[0u];
                                                    let _e2498 = local_20.member_2[1u];
                                                    let _e2508 = (_e2492[0] + ((_e2498[0] - _e2492[0]) * _e2428));
                                                    let _e2509 = (_e2492[1] + ((_e2498[1] - _e2492[1]) * _e2428));
                                                    let _e2510 = (_e2492[2] + ((_e2498[2] - _e2492[2]) * _e2428));
                                                    let _e2515 = (((_e2487 * _e2487) + (_e2488 * _e2488)) + (_e2489 * _e2489));
                                                    let _e2520 = (((_e2487 * _e2508) + (_e2488 * _e2509)) + (_e2489 * _e2510));
                                                    let _e2525 = (((_e2508 * _e2508) + (_e2509 * _e2509)) + (_e2510 * _e2510));
                                                    let _e2530 = (((_e2466 * _e2487) + (_e2467 * _e2488)) + (_e2468 * _e2489));
                                                    let _e2535 = (((_e2466 * _e2508) + (_e2467 * _e2509)) + (_e2468 * _e2510));
                                                    let _e2538 = ((_e2515 * _e2525) - (_e2520 * _e2520));
                                                    let _e2539 = f64(0f);
                                                    let _e2544 = (((_e2530 * _e2525) - (_e2535 * _e2520)) / _e2538);
                                                    let _e2548 = (((_e2535 * _e2515) - (_e2530 * _e2520)) / _e2538);
                                                    if (_e2544 >= _e2539) {
                                                        if (_e2548 >= _e2539) {
                                                            phi_6495_ = ((_e2544 + _e2548) <= f64(1f));
                                                            phi_6496_ = false;
                                                        } else {
                                                            phi_6495_ = bool();
                                                            phi_6496_ = true;
                                                        }
                                                        let _e2554 = phi_6495_;
                                                        let _e2556 = phi_6496_;
                                                        phi_6497_ = _e2554;
                                                        phi_6498_ = _e2556;
                                                    } else {
                                                        phi_6497_ = bool();
                                                        phi_6498_ = true;
                                                    }
                                                    let _e2558 = phi_6497_;
                                                    let _e2560 = phi_6498_;
                                                    if _e2560 {
                                                        let _e2561 = (_e2538 > _e2539);
                                                        if _e2561 {
                                                            phi_6511_ = false;
                                                        } else {
                                                            phi_6511_ = true;
                                                        }
                                                        let _e2563 = phi_6511_;
                                                        phi_6512_ = false;
                                                        phi_6513_ = _e2563;
                                                        phi_6514_ = _e2561;
                                                    } else {
                                                        phi_6512_ = true;
                                                        phi_6513_ = false;
                                                        phi_6514_ = false;
                                                    }
                                                    let _e2565 = phi_6512_;
                                                    let _e2567 = phi_6513_;
                                                    let _e2569 = phi_6514_;
                                                    if _e2565 {
                                                        if (_e2538 > _e2539) {
                                                            if _e2558 {
                                                                phi_6538_ = array<f64, 3>((_e2466 - ((_e2487 * _e2544) + (_e2508 * _e2548))), (_e2467 - ((_e2488 * _e2544) + (_e2509 * _e2548))), (_e2468 - ((_e2489 * _e2544) + (_e2510 * _e2548))));
                                                                phi_6539_ = false;
                                                            } else {
                                                                phi_6538_ = array<f64, 3>();
                                                                phi_6539_ = true;
                                                            }
                                                            let _e2585 = phi_6538_;
                                                            let _e2587 = phi_6539_;
                                                            phi_6540_ = _e2585;
                                                            phi_6541_ = false;
                                                            phi_6542_ = _e2587;
                                                        } else {
                                                            phi_6540_ = array<f64, 3>();
                                                            phi_6541_ = true;
                                                            phi_6542_ = false;
                                                        }
                                                        let _e2589 = phi_6540_;
                                                        let _e2591 = phi_6541_;
                                                        let _e2593 = phi_6542_;
                                                        phi_6543_ = _e2589;
                                                        phi_6544_ = _e2591;
                                                        phi_6545_ = _e2593;
                                                    } else {
                                                        phi_6543_ = array<f64, 3>();
                                                        phi_6544_ = _e2567;
                                                        phi_6545_ = _e2569;
                                                    }
                                                    let _e2595 = phi_6543_;
                                                    let _e2597 = phi_6544_;
                                                    let _e2599 = phi_6545_;
                                                    if _e2597 {
                                                        phi_6549_ = true;
                                                    } else {
                                                        phi_6549_ = _e2599;
                                                    }
                                                    let _e2601 = phi_6549_;
                                                    if _e2601 {
                                                        let _e2602 = (_e2466 - _e2487);
                                                        let _e2603 = (_e2467 - _e2488);
                                                        let _e2604 = (_e2468 - _e2489);
                                                        let _e2605 = (_e2508 - _e2487);
                                                        let _e2606 = (_e2509 - _e2488);
                                                        let _e2607 = (_e2510 - _e2489);
                                                        let _e2618 = ((((_e2602 * _e2605) + (_e2603 * _e2606)) + (_e2604 * _e2607)) / (((_e2605 * _e2605) + (_e2606 * _e2606)) + (_e2607 * _e2607)));
                                                        if (_e2618 > f64(0f)) {
                                                            if (_e2618 < f64(1f)) {
                                                                phi_6736_ = _e2618;
                                                            } else {
                                                                phi_6736_ = f64(1f);
                                                            }
                                                            let _e2626 = phi_6736_;
                                                            phi_6738_ = _e2626;
                                                        } else {
                                                            phi_6738_ = f64(0f);
                                                        }
                                                        let _e2628 = phi_6738_;
                                                        let _e2632 = (_e2602 - (_e2605 * _e2628));
                                                        let _e2633 = (_e2603 - (_e2606 * _e2628));
                                                        let _e2634 = (_e2604 - (_e2607 * _e2628));
                                                        let _e2645 = ((((_e2466 * _e2487) + (_e2467 * _e2488)) + (_e2468 * _e2489)) / (((_e2487 * _e2487) + (_e2488 * _e2488)) + (_e2489 * _e2489)));
                                                        if (_e2645 > f64(0f)) {
                                                            if (_e2645 < f64(1f)) {
                                                                phi_6768_ = _e2645;
                                                            } else {
                                                                phi_6768_ = f64(1f);
                                                            }
                                                            let _e2653 = phi_6768_;
                                                            phi_6770_ = _e2653;
                                                        } else {
                                                            phi_6770_ = f64(0f);
                                                        }
                                                        let _e2655 = phi_6770_;
                                                        let _e2672 = ((((_e2466 * _e2508) + (_e2467 * _e2509)) + (_e2468 * _e2510)) / (((_e2508 * _e2508) + (_e2509 * _e2509)) + (_e2510 * _e2510)));
                                                        if (_e2672 > f64(0f)) {
                                                            if (_e2672 < f64(1f)) {
                                                                phi_6800_ = _e2672;
                                                            } else {
                                                                phi_6800_ = f64(1f);
                                                            }
                                                            let _e2680 = phi_6800_;
                                                            phi_6802_ = _e2680;
                                                        } else {
                                                            phi_6802_ = f64(0f);
                                                        }
                                                        let _e2682 = phi_6802_;
                                                        local[0u] = array<f64, 3>((_e2466 - (_e2487 * _e2655)), (_e2467 - (_e2488 * _e2655)), (_e2468 - (_e2489 * _e2655)));
                                                        local[1u] = array<f64, 3>((_e2466 - (_e2508 * _e2682)), (_e2467 - (_e2509 * _e2682)), (_e2468 - (_e2510 * _e2682)));
                                                        local[2u] = array<f64, 3>(_e2632, _e2633, _e2634);
                                                        local[3u] = array<f64, 3>(_e2632, _e2633, _e2634);
                                                        let _e2698 = local[0u];
                                                        phi_6838_ = type_29(1u, 4u);
                                                        phi_6841_ = array<f64, 3>(_e2698[0], _e2698[1], _e2698[2]);
                                                        loop {
                                                            let _e2704 = phi_6838_;
                                                            let _e2706 = phi_6841_;
                                                            local_55 = _e2706;
                                                            if (_e2704.member < _e2704.member_1) {
                                                                phi_6839_ = type_29((_e2704.member + 1u), _e2704.member_1);
                                                                phi_6864_ = type_29(1u, _e2704.member);
                                                            } else {
                                                                phi_6839_ = _e2704;
                                                                phi_6864_ = type_29(0u, type_29().member_1);
                                                            }
                                                            let _e2720 = phi_6839_;
                                                            let _e2722 = phi_6864_;
                                                            let _e2726 = (bitcast<i32>(_e2722.member) != 0i);
                                                            if _e2726 {
                                                                if (_e2722.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2729 = local[_e2722.member_1];
                                                                if (_e2722.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2735 = local[_e2722.member_1];
                                                                if ((((_e2729[0] * _e2735[0]) + (_e2729[1] * _e2735[1])) + (_e2729[2] * _e2735[2])) < (((_e2706[0] * _e2706[0]) + (_e2706[1] * _e2706[1])) + (_e2706[2] * _e2706[2]))) {
                                                                    if (_e2722.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2758 = local[_e2722.member_1];
                                                                    phi_6931_ = array<f64, 3>(_e2758[0], _e2758[1], _e2758[2]);
                                                                } else {
                                                                    phi_6931_ = _e2706;
                                                                }
                                                                let _e2764 = phi_6931_;
                                                                phi_6842_ = _e2764;
                                                            } else {
                                                                phi_6842_ = array<f64, 3>();
                                                            }
                                                            let _e2766 = phi_6842_;
                                                            continue;
                                                            continuing {
                                                                phi_6838_ = _e2720;
                                                                phi_6841_ = _e2766;
                                                                break if !(_e2726);
                                                            }
                                                        }
                                                        let _e5289 = local_55;
                                                        phi_6932_ = _e5289;
                                                    } else {
                                                        phi_6932_ = _e2595;
                                                    }
                                                    let _e2769 = phi_6932_;
                                                    if (_e2769[0] < 0.0lf) {
                                                        phi_6939_ = -(_e2769[0]);
                                                    } else {
                                                        phi_6939_ = _e2769[0];
                                                    }
                                                    let _e2774 = phi_6939_;
                                                    if (_e2769[1] < 0.0lf) {
                                                        phi_6946_ = -(_e2769[1]);
                                                    } else {
                                                        phi_6946_ = _e2769[1];
                                                    }
                                                    let _e2779 = phi_6946_;
                                                    if (_e2769[2] < 0.0lf) {
                                                        phi_6954_ = -(_e2769[2]);
                                                    } else {
                                                        phi_6954_ = _e2769[2];
                                                    }
                                                    let _e2785 = phi_6954_;
                                                    let _e2786 = ((_e2774 + _e2779) + _e2785);
                                                    if (_e2786 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2786) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2792 = (f64(1f) / _e2786);
                                                            let _e2794 = (_e2769[0] * _e2792);
                                                            let _e2796 = (_e2769[1] * _e2792);
                                                            let _e2798 = (_e2769[2] * _e2792);
                                                            let _e2803 = (((_e2794 * _e2794) + (_e2796 * _e2796)) + (_e2798 * _e2798));
                                                            if (_e2803 <= 2.2250738585072014e-308lf) {
                                                                if (_e2803 > 0.0lf) {
                                                                    phi_6992_ = (bitcast<f64>(((4503599627370496lu >> bitcast<u64>(1lu)) + 2303426169912950784lu)) * 2.0lf);
                                                                } else {
                                                                    phi_6992_ = 0.0lf;
                                                                }
                                                                let _e2866 = phi_6992_;
                                                                phi_7056_ = _e2866;
                                                            } else {
                                                                phi_6999_ = type_27(0i, 5i);
                                                                phi_7002_ = bitcast<f64>(((bitcast<u64>(_e2803) >> bitcast<u64>(1lu)) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2811 = phi_6999_;
                                                                    let _e2813 = phi_7002_;
                                                                    local_26 = _e2813;
                                                                    if (_e2811.member < _e2811.member_1) {
                                                                        let _e2821 = (_e2811.member + 1i);
                                                                        if ((false == (_e2821 > _e2811.member)) != false) {
                                                                            phi_7023_ = true;
                                                                        } else {
                                                                            phi_7023_ = false;
                                                                        }
                                                                        let _e2826 = phi_7023_;
                                                                        if _e2826 {
                                                                            phi_7029_ = type_28(0u, type_28().member_1);
                                                                        } else {
                                                                            phi_7029_ = type_28(1u, _e2821);
                                                                        }
                                                                        let _e2832 = phi_7029_;
                                                                        if (bitcast<i32>(_e2832.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_7000_ = type_27(_e2832.member_1, _e2811.member_1);
                                                                        phi_7043_ = type_28(1u, _e2811.member);
                                                                    } else {
                                                                        phi_7000_ = _e2811;
                                                                        phi_7043_ = type_28(0u, type_28().member_1);
                                                                    }
                                                                    let _e2842 = phi_7000_;
                                                                    let _e2844 = phi_7043_;
                                                                    let _e2847 = (bitcast<i32>(_e2844.member) != 0i);
                                                                    if _e2847 {
                                                                        phi_7003_ = (0.5lf * (_e2813 + (_e2803 / _e2813)));
                                                                    } else {
                                                                        phi_7003_ = f64();
                                                                    }
                                                                    let _e2852 = phi_7003_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6999_ = _e2842;
                                                                        phi_7002_ = _e2852;
                                                                        break if !(_e2847);
                                                                    }
                                                                }
                                                                let _e2857 = local_26;
                                                                phi_7056_ = (_e2857 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2868 = phi_7056_;
                                                            phi_7069_ = type_29(0u, 4u);
                                                            phi_7072_ = f64(2f);
                                                            loop {
                                                                let _e2880 = phi_7069_;
                                                                let _e2882 = phi_7072_;
                                                                local_28 = _e2882;
                                                                local_29 = _e2882;
                                                                local_30 = _e2882;
                                                                local_56 = _e2882;
                                                                local_57 = _e2882;
                                                                if (_e2880.member < _e2880.member_1) {
                                                                    phi_7070_ = type_29((_e2880.member + 1u), _e2880.member_1);
                                                                    phi_7095_ = type_29(1u, _e2880.member);
                                                                } else {
                                                                    phi_7070_ = _e2880;
                                                                    phi_7095_ = type_29(0u, type_29().member_1);
                                                                }
                                                                let _e2896 = phi_7070_;
                                                                let _e2898 = phi_7095_;
                                                                if (bitcast<i32>(_e2898.member) != 0i) {
                                                                    if (_e2898.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2905 = local_1[_e2898.member_1];
                                                                    let _e2913 = (((_e2794 * _e2905[0]) + (_e2796 * _e2905[1])) + (_e2798 * _e2905[2]));
                                                                    if (_e2898.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2916 = local_2[_e2898.member_1];
                                                                    let _e2924 = (((_e2794 * _e2916[0]) + (_e2796 * _e2916[1])) + (_e2798 * _e2916[2]));
                                                                    if (_e2913 < 0.0lf) {
                                                                        phi_7146_ = -(_e2913);
                                                                    } else {
                                                                        phi_7146_ = _e2913;
                                                                    }
                                                                    let _e2928 = phi_7146_;
                                                                    if (_e2924 < 0.0lf) {
                                                                        phi_7152_ = -(_e2924);
                                                                    } else {
                                                                        phi_7152_ = _e2924;
                                                                    }
                                                                    let _e2932 = phi_7152_;
                                                                    let _e2937 = (((((((((_e2299 + _e2301) + (_e2353 + _e2355)) + (_e2407 + _e2409)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2417 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2868) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2928 + _e2932) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2913 > _e2937) {
                                                                        if (_e2924 > _e2937) {
                                                                            phi_7166_ = false;
                                                                        } else {
                                                                            phi_7166_ = true;
                                                                        }
                                                                        let _e2941 = phi_7166_;
                                                                        phi_7167_ = _e2941;
                                                                    } else {
                                                                        phi_7167_ = true;
                                                                    }
                                                                    let _e2943 = phi_7167_;
                                                                    if _e2943 {
                                                                        let _e2947 = ((_e2913 + ((_e2924 - _e2913) * _e2428)) > _e2937);
                                                                        if _e2947 {
                                                                            if (_e2924 < _e2913) {
                                                                                let _e2956 = (((_e2913 - _e2937) / (_e2913 - _e2924)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                if (_e2882 < _e2956) {
                                                                                    phi_7194_ = _e2882;
                                                                                } else {
                                                                                    phi_7194_ = _e2956;
                                                                                }
                                                                                let _e2959 = phi_7194_;
                                                                                phi_7195_ = _e2959;
                                                                            } else {
                                                                                phi_7195_ = _e2882;
                                                                            }
                                                                            let _e2961 = phi_7195_;
                                                                            phi_7196_ = _e2961;
                                                                        } else {
                                                                            phi_7196_ = f64();
                                                                        }
                                                                        let _e2963 = phi_7196_;
                                                                        phi_7197_ = _e2963;
                                                                        phi_7198_ = _e2947;
                                                                    } else {
                                                                        phi_7197_ = _e2882;
                                                                        phi_7198_ = true;
                                                                    }
                                                                    let _e2965 = phi_7197_;
                                                                    let _e2967 = phi_7198_;
                                                                    phi_7073_ = _e2965;
                                                                    phi_7199_ = _e2967;
                                                                    phi_7200_ = false;
                                                                } else {
                                                                    phi_7073_ = f64();
                                                                    phi_7199_ = false;
                                                                    phi_7200_ = true;
                                                                }
                                                                let _e2969 = phi_7073_;
                                                                let _e2971 = phi_7199_;
                                                                let _e2973 = phi_7200_;
                                                                local_27 = _e2973;
                                                                continue;
                                                                continuing {
                                                                    phi_7069_ = _e2896;
                                                                    phi_7072_ = _e2969;
                                                                    break if !(_e2971);
                                                                }
                                                            }
                                                            let _e2976 = local_27;
                                                            if _e2976 {
                                                                let _e2978 = local_28;
                                                                let _e2979 = (_e2978 > _e1437.member_1);
                                                                if _e2979 {
                                                                    phi_7222_ = false;
                                                                    phi_7223_ = false;
                                                                    phi_7224_ = false;
                                                                } else {
                                                                    let _e2981 = local_29;
                                                                    if (_e2981 > _e2428) {
                                                                        let _e2984 = local_30;
                                                                        let _e2987 = ((_e2984 - _e2428) < f64(0.00000000023283064f));
                                                                        if _e2987 {
                                                                            phi_7218_ = false;
                                                                        } else {
                                                                            phi_7218_ = true;
                                                                        }
                                                                        let _e2989 = phi_7218_;
                                                                        phi_7219_ = _e2989;
                                                                        phi_7220_ = _e2987;
                                                                        phi_7221_ = false;
                                                                    } else {
                                                                        phi_7219_ = false;
                                                                        phi_7220_ = false;
                                                                        phi_7221_ = true;
                                                                    }
                                                                    let _e2991 = phi_7219_;
                                                                    let _e2993 = phi_7220_;
                                                                    let _e2995 = phi_7221_;
                                                                    phi_7222_ = _e2991;
                                                                    phi_7223_ = _e2993;
                                                                    phi_7224_ = _e2995;
                                                                }
                                                                let _e2997 = phi_7222_;
                                                                let _e2999 = phi_7223_;
                                                                let _e3001 = phi_7224_;
                                                                phi_7225_ = _e2997;
                                                                phi_7226_ = _e2979;
                                                                phi_7227_ = _e2999;
                                                                phi_7228_ = _e3001;
                                                                phi_7229_ = false;
                                                            } else {
                                                                phi_7225_ = false;
                                                                phi_7226_ = false;
                                                                phi_7227_ = false;
                                                                phi_7228_ = false;
                                                                phi_7229_ = true;
                                                            }
                                                            let _e3003 = phi_7225_;
                                                            let _e3005 = phi_7226_;
                                                            let _e3007 = phi_7227_;
                                                            let _e3009 = phi_7228_;
                                                            let _e3011 = phi_7229_;
                                                            let _e5337 = local_56;
                                                            phi_7230_ = _e5337;
                                                            let _e5340 = local_57;
                                                            phi_7231_ = _e5340;
                                                            phi_7232_ = _e3003;
                                                            phi_7233_ = _e3005;
                                                            phi_7234_ = _e3007;
                                                            phi_7235_ = _e3009;
                                                            phi_7236_ = _e3011;
                                                            phi_7237_ = false;
                                                        } else {
                                                            phi_7230_ = f64();
                                                            phi_7231_ = f64();
                                                            phi_7232_ = false;
                                                            phi_7233_ = false;
                                                            phi_7234_ = false;
                                                            phi_7235_ = false;
                                                            phi_7236_ = false;
                                                            phi_7237_ = true;
                                                        }
                                                        let _e3013 = phi_7230_;
                                                        let _e3015 = phi_7231_;
                                                        let _e3017 = phi_7232_;
                                                        let _e3019 = phi_7233_;
                                                        let _e3021 = phi_7234_;
                                                        let _e3023 = phi_7235_;
                                                        let _e3025 = phi_7236_;
                                                        let _e3027 = phi_7237_;
                                                        phi_7238_ = _e3013;
                                                        phi_7239_ = _e3015;
                                                        phi_7240_ = _e3017;
                                                        phi_7241_ = _e3019;
                                                        phi_7242_ = _e3021;
                                                        phi_7243_ = _e3023;
                                                        phi_7244_ = _e3025;
                                                        phi_7245_ = _e3027;
                                                        phi_7246_ = false;
                                                    } else {
                                                        phi_7238_ = f64();
                                                        phi_7239_ = f64();
                                                        phi_7240_ = false;
                                                        phi_7241_ = false;
                                                        phi_7242_ = false;
                                                        phi_7243_ = false;
                                                        phi_7244_ = false;
                                                        phi_7245_ = false;
                                                        phi_7246_ = true;
                                                    }
                                                    let _e3029 = phi_7238_;
                                                    let _e3031 = phi_7239_;
                                                    let _e3033 = phi_7240_;
                                                    let _e3035 = phi_7241_;
                                                    let _e3037 = phi_7242_;
                                                    let _e3039 = phi_7243_;
                                                    let _e3041 = phi_7244_;
                                                    let _e3043 = phi_7245_;
                                                    let _e3045 = phi_7246_;
                                                    phi_7247_ = _e3029;
                                                    phi_6298_ = _e3031;
                                                    phi_7248_ = _e3033;
                                                    phi_7249_ = _e3035;
                                                    phi_7250_ = _e3037;
                                                    phi_7251_ = false;
                                                    phi_7252_ = _e3039;
                                                    phi_7253_ = _e3041;
                                                    phi_7254_ = _e3043;
                                                    phi_7255_ = _e3045;
                                                } else {
                                                    phi_7247_ = f64();
                                                    phi_6298_ = f64();
                                                    phi_7248_ = false;
                                                    phi_7249_ = false;
                                                    phi_7250_ = false;
                                                    phi_7251_ = true;
                                                    phi_7252_ = false;
                                                    phi_7253_ = false;
                                                    phi_7254_ = false;
                                                    phi_7255_ = false;
                                                }
                                                let _e3047 = phi_7247_;
                                                let _e3049 = phi_6298_;
                                                let _e3051 = phi_7248_;
                                                let _e3053 = phi_7249_;
                                                let _e3055 = phi_7250_;
                                                let _e3057 = phi_7251_;
                                                let _e3059 = phi_7252_;
                                                let _e3061 = phi_7253_;
                                                let _e3063 = phi_7254_;
                                                let _e3065 = phi_7255_;
                                                local_31 = _e3053;
                                                local_58 = _e3055;
                                                local_59 = _e3057;
                                                local_60 = _e3059;
                                                local_61 = _e3061;
                                                local_62 = _e3063;
                                                local_63 = _e3065;
                                                local_64 = _e3047;
                                                local_66 = _e3053;
                                                continue;
                                                continuing {
                                                    phi_6294_ = _e2442;
                                                    phi_6297_ = _e3049;
                                                    break if !(_e3051);
                                                }
                                            }
                                            let _e3068 = local_31;
                                            if _e3068 {
                                                phi_7260_ = type_72(0u, type_72().member_1);
                                                phi_7261_ = false;
                                                phi_7262_ = false;
                                                phi_7263_ = false;
                                                phi_7264_ = false;
                                                phi_7265_ = false;
                                                phi_7266_ = false;
                                            } else {
                                                phi_7260_ = type_72();
                                                let _e5370 = local_58;
                                                phi_7261_ = _e5370;
                                                let _e5373 = local_59;
                                                phi_7262_ = _e5373;
                                                let _e5376 = local_60;
                                                phi_7263_ = _e5376;
                                                let _e5379 = local_61;
                                                phi_7264_ = _e5379;
                                                let _e5382 = local_62;
                                                phi_7265_ = _e5382;
                                                let _e5385 = local_63;
                                                phi_7266_ = _e5385;
                                            }
                                            let _e3073 = phi_7260_;
                                            let _e3075 = phi_7261_;
                                            let _e3077 = phi_7262_;
                                            let _e3079 = phi_7263_;
                                            let _e3081 = phi_7264_;
                                            let _e3083 = phi_7265_;
                                            let _e3085 = phi_7266_;
                                            if _e3075 {
                                                let _e5388 = local_64;
                                                phi_7270_ = _e5388;
                                                phi_7271_ = true;
                                                phi_7272_ = false;
                                                phi_7273_ = false;
                                                phi_7274_ = false;
                                                phi_7275_ = false;
                                                phi_7276_ = false;
                                            } else {
                                                let _e5390 = local_65;
                                                phi_7270_ = _e5390;
                                                phi_7271_ = _e3077;
                                                phi_7272_ = _e3079;
                                                phi_7273_ = _e3081;
                                                let _e5396 = local_66;
                                                phi_7274_ = _e5396;
                                                phi_7275_ = _e3083;
                                                phi_7276_ = _e3085;
                                            }
                                            let _e3087 = phi_7270_;
                                            let _e3089 = phi_7271_;
                                            let _e3091 = phi_7272_;
                                            let _e3093 = phi_7273_;
                                            let _e3095 = phi_7274_;
                                            let _e3097 = phi_7275_;
                                            let _e3099 = phi_7276_;
                                            if _e3089 {
                                                phi_7281_ = type_72(1u, _e3087);
                                                phi_7282_ = false;
                                                phi_7283_ = false;
                                                phi_7284_ = false;
                                                phi_7285_ = false;
                                                phi_7286_ = false;
                                            } else {
                                                phi_7281_ = type_72();
                                                phi_7282_ = _e3091;
                                                phi_7283_ = _e3093;
                                                phi_7284_ = _e3095;
                                                phi_7285_ = _e3097;
                                                phi_7286_ = _e3099;
                                            }
                                            let _e3102 = phi_7281_;
                                            let _e3104 = phi_7282_;
                                            let _e3106 = phi_7283_;
                                            let _e3108 = phi_7284_;
                                            let _e3110 = phi_7285_;
                                            let _e3112 = phi_7286_;
                                            if _e3104 {
                                                let _e3114 = local_32;
                                                phi_7291_ = type_72(1u, _e3114);
                                                phi_7292_ = false;
                                                phi_7293_ = true;
                                                phi_7294_ = false;
                                                phi_7295_ = false;
                                            } else {
                                                phi_7291_ = _e3073;
                                                phi_7292_ = _e3106;
                                                phi_7293_ = _e3108;
                                                phi_7294_ = _e3110;
                                                phi_7295_ = _e3112;
                                            }
                                            let _e3117 = phi_7291_;
                                            let _e3119 = phi_7292_;
                                            let _e3121 = phi_7293_;
                                            let _e3123 = phi_7294_;
                                            let _e3125 = phi_7295_;
                                            if _e3119 {
                                                let _e3127 = local_33;
                                                phi_7300_ = type_72(1u, _e3127);
                                                phi_7301_ = true;
                                                phi_7302_ = false;
                                                phi_7303_ = false;
                                            } else {
                                                phi_7300_ = _e3117;
                                                phi_7301_ = _e3121;
                                                phi_7302_ = _e3123;
                                                phi_7303_ = _e3125;
                                            }
                                            let _e3130 = phi_7300_;
                                            let _e3132 = phi_7301_;
                                            let _e3134 = phi_7302_;
                                            let _e3136 = phi_7303_;
                                            if _e3132 {
                                                phi_7307_ = false;
                                                phi_7308_ = false;
                                            } else {
                                                phi_7307_ = _e3134;
                                                phi_7308_ = _e3136;
                                            }
                                            let _e3138 = phi_7307_;
                                            let _e3140 = phi_7308_;
                                            if _e3138 {
                                                phi_7312_ = false;
                                                phi_7313_ = false;
                                            } else {
                                                phi_7312_ = _e3140;
                                                phi_7313_ = _e3132;
                                            }
                                            let _e3142 = phi_7312_;
                                            let _e3144 = phi_7313_;
                                            if _e3142 {
                                                phi_7317_ = true;
                                                phi_7318_ = false;
                                            } else {
                                                phi_7317_ = _e3138;
                                                phi_7318_ = _e3144;
                                            }
                                            let _e3146 = phi_7317_;
                                            let _e3148 = phi_7318_;
                                            if _e3146 {
                                                let _e3150 = local_34;
                                                phi_7323_ = type_72(1u, _e3150);
                                                phi_7324_ = true;
                                            } else {
                                                phi_7323_ = _e3130;
                                                phi_7324_ = _e3148;
                                            }
                                            let _e3153 = phi_7323_;
                                            let _e3155 = phi_7324_;
                                            if _e3155 {
                                                phi_7328_ = _e3153;
                                            } else {
                                                phi_7328_ = _e3102;
                                            }
                                            let _e3157 = phi_7328_;
                                            let _e3160 = (_e3157.member != 0u);
                                            if _e3160 {
                                                phi_7335_ = false;
                                            } else {
                                                phi_7335_ = true;
                                            }
                                            let _e3162 = phi_7335_;
                                            phi_7336_ = _e3157.member_1;
                                            phi_7337_ = _e3162;
                                            phi_7338_ = _e3160;
                                            phi_7339_ = false;
                                        } else {
                                            phi_7336_ = f64();
                                            phi_7337_ = false;
                                            phi_7338_ = false;
                                            phi_7339_ = true;
                                        }
                                        let _e3164 = phi_7336_;
                                        let _e3166 = phi_7337_;
                                        let _e3168 = phi_7338_;
                                        let _e3170 = phi_7339_;
                                        phi_7340_ = _e3164;
                                        phi_7341_ = _e3166;
                                        phi_7342_ = _e3168;
                                        phi_7343_ = _e3170;
                                    }
                                    let _e3172 = phi_7340_;
                                    let _e3174 = phi_7341_;
                                    let _e3176 = phi_7342_;
                                    let _e3178 = phi_7343_;
                                    phi_7344_ = _e3172;
                                    phi_7345_ = _e2178;
                                    phi_7346_ = _e3174;
                                    phi_7347_ = _e3176;
                                    phi_7348_ = _e3178;
                                }
                                let _e3180 = phi_7344_;
                                let _e3182 = phi_7345_;
                                let _e3184 = phi_7346_;
                                let _e3186 = phi_7347_;
                                let _e3188 = phi_7348_;
                                if _e3182 {
                                    phi_7352_ = true;
                                    phi_7353_ = false;
                                    phi_7354_ = false;
                                } else {
                                    phi_7352_ = _e3184;
                                    phi_7353_ = _e3186;
                                    phi_7354_ = _e3188;
                                }
                                let _e3190 = phi_7352_;
                                let _e3192 = phi_7353_;
                                let _e3194 = phi_7354_;
                                phi_7355_ = _e3180;
                                phi_7356_ = _e1437;
                                phi_7357_ = _e3190;
                                phi_7358_ = false;
                                phi_7359_ = _e3192;
                                phi_7360_ = _e3194;
                            } else {
                                phi_7355_ = f64();
                                phi_7356_ = type_73();
                                phi_7357_ = false;
                                phi_7358_ = true;
                                phi_7359_ = false;
                                phi_7360_ = false;
                            }
                            let _e3196 = phi_7355_;
                            let _e3198 = phi_7356_;
                            let _e3200 = phi_7357_;
                            let _e3202 = phi_7358_;
                            let _e3204 = phi_7359_;
                            let _e3206 = phi_7360_;
                            local_35 = _e3202;
                            local_67 = _e3204;
                            local_68 = _e3206;
                            local_36 = _e3196;
                            local_37 = _e3198;
                            continue;
                            continuing {
                                phi_4317_ = _e1104;
                                break if !(_e3200);
                            }
                        }
                        let _e3209 = local_35;
                        if _e3209 {
                            phi_7365_ = type_72(0u, type_72().member_1);
                            phi_7366_ = false;
                            phi_7367_ = false;
                        } else {
                            phi_7365_ = type_72();
                            let _e5453 = local_67;
                            phi_7366_ = _e5453;
                            let _e5456 = local_68;
                            phi_7367_ = _e5456;
                        }
                        let _e3214 = phi_7365_;
                        let _e3216 = phi_7366_;
                        let _e3218 = phi_7367_;
                        if _e3216 {
                            let _e3220 = local_36;
                            phi_7372_ = type_72(2u, _e3220);
                            phi_7373_ = false;
                        } else {
                            phi_7372_ = type_72();
                            phi_7373_ = _e3218;
                        }
                        let _e3223 = phi_7372_;
                        let _e3225 = phi_7373_;
                        if _e3225 {
                            let _e3227 = local_37;
                            phi_7379_ = type_72(1u, _e3227.member);
                            phi_7380_ = true;
                        } else {
                            phi_7379_ = _e3223;
                            phi_7380_ = _e3216;
                        }
                        let _e3231 = phi_7379_;
                        let _e3233 = phi_7380_;
                        if _e3233 {
                            phi_7384_ = _e3231;
                        } else {
                            phi_7384_ = _e3214;
                        }
                        let _e3235 = phi_7384_;
                        phi_7388_ = _e3235;
                    }
                    let _e4852 = phi_7388_;
                    phi_7389_ = _e4852;
                }
                let _e4857 = phi_7389_;
                switch bitcast<i32>(_e4857.member) {
                    case 0: {
                        phi_7410_ = type_46(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4868 = bitcast<u64>(_e4857.member_1);
                        phi_7410_ = type_46(0u, array<u32, 2>(u32(_e4868), u32((_e4868 >> bitcast<u64>(32lu)))), true);
                        break;
                    }
                    case 2: {
                        let _e4861 = bitcast<u64>(_e4857.member_1);
                        phi_7410_ = type_46(1u, array<u32, 2>(u32(_e4861), u32((_e4861 >> bitcast<u64>(32lu)))), true);
                        break;
                    }
                    default: {
                        phi_7410_ = type_46();
                        break;
                    }
                }
                let _e4876 = phi_7410_;
                if _e4876.member_2 {
                    let _e4882 = (_e4876.member_1[1] >> bitcast<u32>(20i));
                    if (_e4882 <= 896u) {
                        phi_7433_ = 0u;
                    } else {
                        phi_7433_ = ((((_e4882 - 896u) << bitcast<u32>(23i)) | ((_e4876.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4876.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4897 = phi_7433_;
                    let _e4899 = atomicMin((&earliest.member[0u]), _e4897);
                }
                let _e4901 = params.member.member_1;
                if ((_e4901 & 16u) != 0u) {
                    if (_e115 == 0u) {
                        atomicStore((&counters[0u]), 0u);
                    }
                    workgroupBarrier();
                    if _e4876.member_2 {
                        let _e4907 = atomicAdd((&counters[0u]), 1u);
                        phi_7454_ = _e4907;
                    } else {
                        phi_7454_ = 0u;
                    }
                    let _e4909 = phi_7454_;
                    workgroupBarrier();
                    if (_e115 == 0u) {
                        let _e4912 = atomicLoad((&counters[0u]));
                        if (_e4912 > 0u) {
                            let _e4915 = atomicAdd((&contacts.member[0u]), _e4912);
                            atomicStore((&counters[1u]), _e4915);
                        }
                    }
                    workgroupBarrier();
                    let _e4918 = atomicLoad((&counters[1u]));
                    let _e4919 = (_e4918 + _e4909);
                    if _e4876.member_2 {
                        let _e4921 = params.member.member_16;
                        if (_e4919 < _e4921) {
                            let _e4923 = (6u * _e4919);
                            atomicStore((&contacts.member[(4u + _e4923)]), _e184);
                            atomicStore((&contacts.member[(_e4923 + 5u)]), _e4876.member);
                            atomicStore((&contacts.member[(_e4923 + 6u)]), _e202);
                            atomicStore((&contacts.member[(_e4923 + 7u)]), _e205);
                            atomicStore((&contacts.member[(_e4923 + 8u)]), _e4876.member_1[0]);
                            atomicStore((&contacts.member[(_e4923 + 9u)]), _e4876.member_1[1]);
                        }
                    }
                }
            } else {
                let _e187 = params.member.member_1;
                if ((_e187 & 16u) != 0u) {
                    if (_e115 == 0u) {
                        atomicStore((&counters[0u]), 0u);
                    }
                    workgroupBarrier();
                    workgroupBarrier();
                    if (_e115 == 0u) {
                        let _e194 = atomicLoad((&counters[0u]));
                        if (_e194 > 0u) {
                            let _e197 = atomicAdd((&contacts.member[0u]), _e194);
                            atomicStore((&counters[1u]), _e197);
                        }
                    }
                    workgroupBarrier();
                }
            }
        }
        continue;
        continuing {
            phi_270_ = _e172;
            break if !(_e178);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
