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
                let _e453 = bitcast<f64>(((u64(_e446[1]) * 4294967296lu) + u64(_e446[0])));
                let _e454 = f64(0f);
                let _e457 = local_20.member_1[0u];
                let _e463 = local_20.member_2[0u];
                let _e469 = ((_e457[1] * _e463[2]) - (_e457[2] * _e463[1]));
                let _e472 = ((_e457[2] * _e463[0]) - (_e457[0] * _e463[2]));
                let _e475 = ((_e457[0] * _e463[1]) - (_e457[1] * _e463[0]));
                let _e478 = local_20.member_1[1u];
                let _e484 = local_20.member_2[1u];
                let _e490 = ((_e478[1] * _e484[2]) - (_e478[2] * _e484[1]));
                let _e493 = ((_e478[2] * _e484[0]) - (_e478[0] * _e484[2]));
                let _e496 = ((_e478[0] * _e484[1]) - (_e478[1] * _e484[0]));
                let _e499 = local_20.member_1[0u];
                let _e505 = local_20.member_2[1u];
                let _e520 = local_20.member_1[1u];
                let _e526 = local_20.member_2[0u];
                let _e539 = (((_e499[1] * _e505[2]) - (_e499[2] * _e505[1])) + ((_e520[1] * _e526[2]) - (_e520[2] * _e526[1])));
                let _e540 = (((_e499[2] * _e505[0]) - (_e499[0] * _e505[2])) + ((_e520[2] * _e526[0]) - (_e520[0] * _e526[2])));
                let _e541 = (((_e499[0] * _e505[1]) - (_e499[1] * _e505[0])) + ((_e520[0] * _e526[1]) - (_e520[1] * _e526[0])));
                let _e544 = local_20.member[0u];
                let _e552 = (((_e544[0] * _e469) + (_e544[1] * _e472)) + (_e544[2] * _e475));
                let _e555 = local_20.member[1u];
                let _e566 = local_20.member[0u];
                let _e575 = ((((_e555[0] * _e469) + (_e555[1] * _e472)) + (_e555[2] * _e475)) + (((_e566[0] * _e539) + (_e566[1] * _e540)) + (_e566[2] * _e541)));
                let _e578 = local_20.member[0u];
                let _e589 = local_20.member[1u];
                let _e598 = ((((_e578[0] * _e490) + (_e578[1] * _e493)) + (_e578[2] * _e496)) + (((_e589[0] * _e539) + (_e589[1] * _e540)) + (_e589[2] * _e541)));
                let _e601 = local_20.member[1u];
                let _e609 = (((_e601[0] * _e490) + (_e601[1] * _e493)) + (_e601[2] * _e496));
                let _e612 = local_20.member[0u];
                if (_e612[0] < 0.0lf) {
                    phi_1106_ = -(_e612[0]);
                } else {
                    phi_1106_ = _e612[0];
                }
                let _e619 = phi_1106_;
                if (_e612[1] < 0.0lf) {
                    phi_1113_ = -(_e612[1]);
                } else {
                    phi_1113_ = _e612[1];
                }
                let _e623 = phi_1113_;
                if (_e619 > _e623) {
                    phi_1118_ = _e619;
                } else {
                    phi_1118_ = _e623;
                }
                let _e626 = phi_1118_;
                if (_e612[2] < 0.0lf) {
                    phi_1125_ = -(_e612[2]);
                } else {
                    phi_1125_ = _e612[2];
                }
                let _e630 = phi_1125_;
                if (_e626 > _e630) {
                    phi_1130_ = _e626;
                } else {
                    phi_1130_ = _e630;
                }
                let _e633 = phi_1130_;
                let _e636 = local_20.member[1u];
                if (_e636[0] < 0.0lf) {
                    phi_1143_ = -(_e636[0]);
                } else {
                    phi_1143_ = _e636[0];
                }
                let _e643 = phi_1143_;
                if (_e636[1] < 0.0lf) {
                    phi_1150_ = -(_e636[1]);
                } else {
                    phi_1150_ = _e636[1];
                }
                let _e647 = phi_1150_;
                if (_e643 > _e647) {
                    phi_1155_ = _e643;
                } else {
                    phi_1155_ = _e647;
                }
                let _e650 = phi_1155_;
                if (_e636[2] < 0.0lf) {
                    phi_1162_ = -(_e636[2]);
                } else {
                    phi_1162_ = _e636[2];
                }
                let _e654 = phi_1162_;
                if (_e650 > _e654) {
                    phi_1167_ = _e650;
                } else {
                    phi_1167_ = _e654;
                }
                let _e657 = phi_1167_;
                if (_e633 > _e657) {
                    phi_1172_ = _e633;
                } else {
                    phi_1172_ = _e657;
                }
                let _e660 = phi_1172_;
                let _e662 = local_20.member_3;
                let _e663 = (_e660 + _e662);
                let _e666 = local_20.member_1[0u];
                if (_e666[0] < 0.0lf) {
                    phi_1189_ = -(_e666[0]);
                } else {
                    phi_1189_ = _e666[0];
                }
                let _e673 = phi_1189_;
                if (_e666[1] < 0.0lf) {
                    phi_1196_ = -(_e666[1]);
                } else {
                    phi_1196_ = _e666[1];
                }
                let _e677 = phi_1196_;
                if (_e673 > _e677) {
                    phi_1201_ = _e673;
                } else {
                    phi_1201_ = _e677;
                }
                let _e680 = phi_1201_;
                if (_e666[2] < 0.0lf) {
                    phi_1208_ = -(_e666[2]);
                } else {
                    phi_1208_ = _e666[2];
                }
                let _e684 = phi_1208_;
                if (_e680 > _e684) {
                    phi_1213_ = _e680;
                } else {
                    phi_1213_ = _e684;
                }
                let _e687 = phi_1213_;
                let _e690 = local_20.member_1[1u];
                if (_e690[0] < 0.0lf) {
                    phi_1227_ = -(_e690[0]);
                } else {
                    phi_1227_ = _e690[0];
                }
                let _e697 = phi_1227_;
                if (_e690[1] < 0.0lf) {
                    phi_1234_ = -(_e690[1]);
                } else {
                    phi_1234_ = _e690[1];
                }
                let _e701 = phi_1234_;
                if (_e697 > _e701) {
                    phi_1239_ = _e697;
                } else {
                    phi_1239_ = _e701;
                }
                let _e704 = phi_1239_;
                if (_e690[2] < 0.0lf) {
                    phi_1246_ = -(_e690[2]);
                } else {
                    phi_1246_ = _e690[2];
                }
                let _e708 = phi_1246_;
                if (_e704 > _e708) {
                    phi_1251_ = _e704;
                } else {
                    phi_1251_ = _e708;
                }
                let _e711 = phi_1251_;
                if (_e687 > _e711) {
                    phi_1256_ = _e687;
                } else {
                    phi_1256_ = _e711;
                }
                let _e714 = phi_1256_;
                let _e716 = local_20.member_3;
                let _e717 = (_e714 + _e716);
                let _e720 = local_20.member_2[0u];
                if (_e720[0] < 0.0lf) {
                    phi_1273_ = -(_e720[0]);
                } else {
                    phi_1273_ = _e720[0];
                }
                let _e727 = phi_1273_;
                if (_e720[1] < 0.0lf) {
                    phi_1280_ = -(_e720[1]);
                } else {
                    phi_1280_ = _e720[1];
                }
                let _e731 = phi_1280_;
                if (_e727 > _e731) {
                    phi_1285_ = _e727;
                } else {
                    phi_1285_ = _e731;
                }
                let _e734 = phi_1285_;
                if (_e720[2] < 0.0lf) {
                    phi_1292_ = -(_e720[2]);
                } else {
                    phi_1292_ = _e720[2];
                }
                let _e738 = phi_1292_;
                if (_e734 > _e738) {
                    phi_1297_ = _e734;
                } else {
                    phi_1297_ = _e738;
                }
                let _e741 = phi_1297_;
                let _e744 = local_20.member_2[1u];
                if (_e744[0] < 0.0lf) {
                    phi_1311_ = -(_e744[0]);
                } else {
                    phi_1311_ = _e744[0];
                }
                let _e751 = phi_1311_;
                if (_e744[1] < 0.0lf) {
                    phi_1318_ = -(_e744[1]);
                } else {
                    phi_1318_ = _e744[1];
                }
                let _e755 = phi_1318_;
                if (_e751 > _e755) {
                    phi_1323_ = _e751;
                } else {
                    phi_1323_ = _e755;
                }
                let _e758 = phi_1323_;
                if (_e744[2] < 0.0lf) {
                    phi_1330_ = -(_e744[2]);
                } else {
                    phi_1330_ = _e744[2];
                }
                let _e762 = phi_1330_;
                if (_e758 > _e762) {
                    phi_1335_ = _e758;
                } else {
                    phi_1335_ = _e762;
                }
                let _e765 = phi_1335_;
                if (_e741 > _e765) {
                    phi_1340_ = _e741;
                } else {
                    phi_1340_ = _e765;
                }
                let _e768 = phi_1340_;
                let _e770 = local_20.member_3;
                let _e771 = (_e768 + _e770);
                let _e772 = f64(1f);
                let _e773 = f64(8f);
                let _e775 = ((_e717 * _e773) * _e771);
                let _e783 = local_20.member_3;
                if (_e469 < 0.0lf) {
                    phi_1377_ = -(_e469);
                } else {
                    phi_1377_ = _e469;
                }
                let _e803 = phi_1377_;
                if (_e472 < 0.0lf) {
                    phi_1383_ = -(_e472);
                } else {
                    phi_1383_ = _e472;
                }
                let _e807 = phi_1383_;
                if (_e475 < 0.0lf) {
                    phi_1390_ = -(_e475);
                } else {
                    phi_1390_ = _e475;
                }
                let _e812 = phi_1390_;
                let _e813 = ((_e803 + _e807) + _e812);
                if (_e490 < 0.0lf) {
                    phi_1397_ = -(_e490);
                } else {
                    phi_1397_ = _e490;
                }
                let _e817 = phi_1397_;
                if (_e493 < 0.0lf) {
                    phi_1403_ = -(_e493);
                } else {
                    phi_1403_ = _e493;
                }
                let _e821 = phi_1403_;
                if (_e496 < 0.0lf) {
                    phi_1410_ = -(_e496);
                } else {
                    phi_1410_ = _e496;
                }
                let _e826 = phi_1410_;
                let _e827 = ((_e817 + _e821) + _e826);
                if (_e813 > _e827) {
                    phi_1416_ = _e813;
                } else {
                    phi_1416_ = _e827;
                }
                let _e830 = phi_1416_;
                if (_e539 < 0.0lf) {
                    phi_1422_ = -(_e539);
                } else {
                    phi_1422_ = _e539;
                }
                let _e834 = phi_1422_;
                if (_e540 < 0.0lf) {
                    phi_1428_ = -(_e540);
                } else {
                    phi_1428_ = _e540;
                }
                let _e838 = phi_1428_;
                if (_e541 < 0.0lf) {
                    phi_1435_ = -(_e541);
                } else {
                    phi_1435_ = _e541;
                }
                let _e843 = phi_1435_;
                let _e845 = (((_e834 + _e838) + _e843) * f64(0.5f));
                if (_e830 > _e845) {
                    phi_1442_ = _e830;
                } else {
                    phi_1442_ = _e845;
                }
                let _e848 = phi_1442_;
                let _e854 = local_20.member_3;
                let _e868 = (((((_e663 * _e773) * _e775) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e783 * f64(19f)) * ((_e663 * (_e717 + _e771)) + (_e717 * _e771)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e772 + _e663) * ((_e772 + _e717) * (_e772 + _e771)))));
                let _e869 = f64(3f);
                let _e870 = (_e552 * _e869);
                let _e871 = (_e609 * _e869);
                if (_e870 < _e871) {
                    phi_1470_ = _e870;
                } else {
                    phi_1470_ = _e871;
                }
                let _e874 = phi_1470_;
                if (_e575 < _e598) {
                    phi_1475_ = _e575;
                } else {
                    phi_1475_ = _e598;
                }
                let _e877 = phi_1475_;
                if (_e874 < _e877) {
                    phi_1480_ = _e874;
                } else {
                    phi_1480_ = _e877;
                }
                let _e880 = phi_1480_;
                if (_e870 > _e871) {
                    phi_1485_ = _e870;
                } else {
                    phi_1485_ = _e871;
                }
                let _e883 = phi_1485_;
                if (_e575 > _e598) {
                    phi_1490_ = _e575;
                } else {
                    phi_1490_ = _e598;
                }
                let _e886 = phi_1490_;
                if (_e883 > _e886) {
                    phi_1495_ = _e883;
                } else {
                    phi_1495_ = _e886;
                }
                let _e889 = phi_1495_;
                let _e895 = -(_e889);
                if (_e880 > _e895) {
                    phi_1506_ = _e880;
                } else {
                    phi_1506_ = _e895;
                }
                let _e898 = phi_1506_;
                if ((_e898 - (_e868 + ((_e453 * (((_e848 + (_e775 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e854 * f64(6f)) * (_e717 + _e771))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e772 + _e717) * (_e772 + _e771))))) * f64((3f * 1.0001f))))) > _e454) {
                    phi_7389_ = type_72(0u, type_72().member_1);
                } else {
                    if (_e453 > _e454) {
                        let _e3225 = f64(1f);
                        let _e3229 = local_20.member[0u];
                        let _e3235 = local_20.member_1[0u];
                        let _e3241 = local_20.member_2[0u];
                        local_12 = array<array<f64, 3>, 4>(_e3229, array<f64, 3>((_e3229[0] - _e3235[0]), (_e3229[1] - _e3235[1]), (_e3229[2] - _e3235[2])), array<f64, 3>((_e3229[0] - _e3241[0]), (_e3229[1] - _e3241[1]), (_e3229[2] - _e3241[2])), _e3229);
                        let _e3256 = local_20.member[1u];
                        let _e3262 = local_20.member_1[1u];
                        let _e3268 = local_20.member_2[1u];
                        local_13 = array<array<f64, 3>, 4>(_e3256, array<f64, 3>((_e3256[0] - _e3262[0]), (_e3256[1] - _e3262[1]), (_e3256[2] - _e3262[2])), array<f64, 3>((_e3256[0] - _e3268[0]), (_e3256[1] - _e3268[1]), (_e3256[2] - _e3268[2])), _e3256);
                        let _e3283 = local_20.member[0u];
                        if (_e3283[0] < 0.0lf) {
                            phi_1709_ = -(_e3283[0]);
                        } else {
                            phi_1709_ = _e3283[0];
                        }
                        let _e3290 = phi_1709_;
                        if (_e3283[1] < 0.0lf) {
                            phi_1716_ = -(_e3283[1]);
                        } else {
                            phi_1716_ = _e3283[1];
                        }
                        let _e3294 = phi_1716_;
                        if (_e3290 > _e3294) {
                            phi_1721_ = _e3290;
                        } else {
                            phi_1721_ = _e3294;
                        }
                        let _e3297 = phi_1721_;
                        if (_e3283[2] < 0.0lf) {
                            phi_1728_ = -(_e3283[2]);
                        } else {
                            phi_1728_ = _e3283[2];
                        }
                        let _e3301 = phi_1728_;
                        if (_e3297 > _e3301) {
                            phi_1733_ = _e3297;
                        } else {
                            phi_1733_ = _e3301;
                        }
                        let _e3304 = phi_1733_;
                        let _e3307 = local_20.member[1u];
                        if (_e3307[0] < 0.0lf) {
                            phi_1746_ = -(_e3307[0]);
                        } else {
                            phi_1746_ = _e3307[0];
                        }
                        let _e3314 = phi_1746_;
                        if (_e3307[1] < 0.0lf) {
                            phi_1753_ = -(_e3307[1]);
                        } else {
                            phi_1753_ = _e3307[1];
                        }
                        let _e3318 = phi_1753_;
                        if (_e3314 > _e3318) {
                            phi_1758_ = _e3314;
                        } else {
                            phi_1758_ = _e3318;
                        }
                        let _e3321 = phi_1758_;
                        if (_e3307[2] < 0.0lf) {
                            phi_1765_ = -(_e3307[2]);
                        } else {
                            phi_1765_ = _e3307[2];
                        }
                        let _e3325 = phi_1765_;
                        if (_e3321 > _e3325) {
                            phi_1770_ = _e3321;
                        } else {
                            phi_1770_ = _e3325;
                        }
                        let _e3328 = phi_1770_;
                        if (_e3304 > _e3328) {
                            phi_1775_ = _e3304;
                        } else {
                            phi_1775_ = _e3328;
                        }
                        let _e3331 = phi_1775_;
                        let _e3333 = local_20.member_3;
                        let _e3337 = local_20.member_1[0u];
                        if (_e3337[0] < 0.0lf) {
                            phi_1792_ = -(_e3337[0]);
                        } else {
                            phi_1792_ = _e3337[0];
                        }
                        let _e3344 = phi_1792_;
                        if (_e3337[1] < 0.0lf) {
                            phi_1799_ = -(_e3337[1]);
                        } else {
                            phi_1799_ = _e3337[1];
                        }
                        let _e3348 = phi_1799_;
                        if (_e3344 > _e3348) {
                            phi_1804_ = _e3344;
                        } else {
                            phi_1804_ = _e3348;
                        }
                        let _e3351 = phi_1804_;
                        if (_e3337[2] < 0.0lf) {
                            phi_1811_ = -(_e3337[2]);
                        } else {
                            phi_1811_ = _e3337[2];
                        }
                        let _e3355 = phi_1811_;
                        if (_e3351 > _e3355) {
                            phi_1816_ = _e3351;
                        } else {
                            phi_1816_ = _e3355;
                        }
                        let _e3358 = phi_1816_;
                        let _e3361 = local_20.member_1[1u];
                        if (_e3361[0] < 0.0lf) {
                            phi_1830_ = -(_e3361[0]);
                        } else {
                            phi_1830_ = _e3361[0];
                        }
                        let _e3368 = phi_1830_;
                        if (_e3361[1] < 0.0lf) {
                            phi_1837_ = -(_e3361[1]);
                        } else {
                            phi_1837_ = _e3361[1];
                        }
                        let _e3372 = phi_1837_;
                        if (_e3368 > _e3372) {
                            phi_1842_ = _e3368;
                        } else {
                            phi_1842_ = _e3372;
                        }
                        let _e3375 = phi_1842_;
                        if (_e3361[2] < 0.0lf) {
                            phi_1849_ = -(_e3361[2]);
                        } else {
                            phi_1849_ = _e3361[2];
                        }
                        let _e3379 = phi_1849_;
                        if (_e3375 > _e3379) {
                            phi_1854_ = _e3375;
                        } else {
                            phi_1854_ = _e3379;
                        }
                        let _e3382 = phi_1854_;
                        if (_e3358 > _e3382) {
                            phi_1859_ = _e3358;
                        } else {
                            phi_1859_ = _e3382;
                        }
                        let _e3385 = phi_1859_;
                        let _e3387 = local_20.member_3;
                        let _e3391 = local_20.member_2[0u];
                        if (_e3391[0] < 0.0lf) {
                            phi_1876_ = -(_e3391[0]);
                        } else {
                            phi_1876_ = _e3391[0];
                        }
                        let _e3398 = phi_1876_;
                        if (_e3391[1] < 0.0lf) {
                            phi_1883_ = -(_e3391[1]);
                        } else {
                            phi_1883_ = _e3391[1];
                        }
                        let _e3402 = phi_1883_;
                        if (_e3398 > _e3402) {
                            phi_1888_ = _e3398;
                        } else {
                            phi_1888_ = _e3402;
                        }
                        let _e3405 = phi_1888_;
                        if (_e3391[2] < 0.0lf) {
                            phi_1895_ = -(_e3391[2]);
                        } else {
                            phi_1895_ = _e3391[2];
                        }
                        let _e3409 = phi_1895_;
                        if (_e3405 > _e3409) {
                            phi_1900_ = _e3405;
                        } else {
                            phi_1900_ = _e3409;
                        }
                        let _e3412 = phi_1900_;
                        let _e3415 = local_20.member_2[1u];
                        if (_e3415[0] < 0.0lf) {
                            phi_1914_ = -(_e3415[0]);
                        } else {
                            phi_1914_ = _e3415[0];
                        }
                        let _e3422 = phi_1914_;
                        if (_e3415[1] < 0.0lf) {
                            phi_1921_ = -(_e3415[1]);
                        } else {
                            phi_1921_ = _e3415[1];
                        }
                        let _e3426 = phi_1921_;
                        if (_e3422 > _e3426) {
                            phi_1926_ = _e3422;
                        } else {
                            phi_1926_ = _e3426;
                        }
                        let _e3429 = phi_1926_;
                        if (_e3415[2] < 0.0lf) {
                            phi_1933_ = -(_e3415[2]);
                        } else {
                            phi_1933_ = _e3415[2];
                        }
                        let _e3433 = phi_1933_;
                        if (_e3429 > _e3433) {
                            phi_1938_ = _e3429;
                        } else {
                            phi_1938_ = _e3433;
                        }
                        let _e3436 = phi_1938_;
                        if (_e3412 > _e3436) {
                            phi_1943_ = _e3412;
                        } else {
                            phi_1943_ = _e3436;
                        }
                        let _e3439 = phi_1943_;
                        let _e3441 = local_20.member_3;
                        let _e3449 = local_20.member_3;
                        phi_1963_ = type_29(0u, 48u);
                        phi_1966_ = f64(0f);
                        loop {
                            let _e3458 = phi_1963_;
                            let _e3460 = phi_1966_;
                            local_79 = _e3460;
                            local_44 = _e3460;
                            local_45 = _e3460;
                            local_46 = _e3460;
                            if (_e3458.member < _e3458.member_1) {
                                phi_1964_ = type_29((_e3458.member + 1u), _e3458.member_1);
                                phi_1989_ = type_29(1u, _e3458.member);
                            } else {
                                phi_1964_ = _e3458;
                                phi_1989_ = type_29(0u, type_29().member_1);
                            }
                            let _e3474 = phi_1964_;
                            let _e3476 = phi_1989_;
                            if (bitcast<i32>(_e3476.member) != 0i) {
                                let _e3482 = local_20.member[0u];
                                let _e3488 = local_20.member[1u];
                                let _e3498 = (_e3482[0] + ((_e3488[0] - _e3482[0]) * _e3460));
                                let _e3499 = (_e3482[1] + ((_e3488[1] - _e3482[1]) * _e3460));
                                let _e3500 = (_e3482[2] + ((_e3488[2] - _e3482[2]) * _e3460));
                                let _e3503 = local_20.member_1[0u];
                                let _e3509 = local_20.member_1[1u];
                                let _e3519 = (_e3503[0] + ((_e3509[0] - _e3503[0]) * _e3460));
                                let _e3520 = (_e3503[1] + ((_e3509[1] - _e3503[1]) * _e3460));
                                let _e3521 = (_e3503[2] + ((_e3509[2] - _e3503[2]) * _e3460));
                                let _e3524 = local_20.member_2[0u];
                                let _e3530 = local_20.member_2[1u];
                                let _e3540 = (_e3524[0] + ((_e3530[0] - _e3524[0]) * _e3460));
                                let _e3541 = (_e3524[1] + ((_e3530[1] - _e3524[1]) * _e3460));
                                let _e3542 = (_e3524[2] + ((_e3530[2] - _e3524[2]) * _e3460));
                                let _e3547 = (((_e3519 * _e3519) + (_e3520 * _e3520)) + (_e3521 * _e3521));
                                let _e3552 = (((_e3519 * _e3540) + (_e3520 * _e3541)) + (_e3521 * _e3542));
                                let _e3557 = (((_e3540 * _e3540) + (_e3541 * _e3541)) + (_e3542 * _e3542));
                                let _e3562 = (((_e3498 * _e3519) + (_e3499 * _e3520)) + (_e3500 * _e3521));
                                let _e3567 = (((_e3498 * _e3540) + (_e3499 * _e3541)) + (_e3500 * _e3542));
                                let _e3570 = ((_e3547 * _e3557) - (_e3552 * _e3552));
                                let _e3571 = f64(0f);
                                let _e3576 = (((_e3562 * _e3557) - (_e3567 * _e3552)) / _e3570);
                                let _e3580 = (((_e3567 * _e3547) - (_e3562 * _e3552)) / _e3570);
                                if (_e3576 >= _e3571) {
                                    if (_e3580 >= _e3571) {
                                        phi_2164_ = ((_e3576 + _e3580) <= f64(1f));
                                        phi_2165_ = false;
                                    } else {
                                        phi_2164_ = bool();
                                        phi_2165_ = true;
                                    }
                                    let _e3586 = phi_2164_;
                                    let _e3588 = phi_2165_;
                                    phi_2166_ = _e3586;
                                    phi_2167_ = _e3588;
                                } else {
                                    phi_2166_ = bool();
                                    phi_2167_ = true;
                                }
                                let _e3590 = phi_2166_;
                                let _e3592 = phi_2167_;
                                if _e3592 {
                                    let _e3593 = (_e3570 > _e3571);
                                    if _e3593 {
                                        phi_2180_ = false;
                                    } else {
                                        phi_2180_ = true;
                                    }
                                    let _e3595 = phi_2180_;
                                    phi_2181_ = false;
                                    phi_2182_ = _e3595;
                                    phi_2183_ = _e3593;
                                } else {
                                    phi_2181_ = true;
                                    phi_2182_ = false;
                                    phi_2183_ = false;
                                }
                                let _e3597 = phi_2181_;
                                let _e3599 = phi_2182_;
                                let _e3601 = phi_2183_;
                                if _e3597 {
                                    if (_e3570 > _e3571) {
                                        if _e3590 {
                                            phi_2207_ = array<f64, 3>((_e3498 - ((_e3519 * _e3576) + (_e3540 * _e3580))), (_e3499 - ((_e3520 * _e3576) + (_e3541 * _e3580))), (_e3500 - ((_e3521 * _e3576) + (_e3542 * _e3580))));
                                            phi_2208_ = false;
                                        } else {
                                            phi_2207_ = array<f64, 3>();
                                            phi_2208_ = true;
                                        }
                                        let _e3617 = phi_2207_;
                                        let _e3619 = phi_2208_;
                                        phi_2209_ = _e3617;
                                        phi_2210_ = false;
                                        phi_2211_ = _e3619;
                                    } else {
                                        phi_2209_ = array<f64, 3>();
                                        phi_2210_ = true;
                                        phi_2211_ = false;
                                    }
                                    let _e3621 = phi_2209_;
                                    let _e3623 = phi_2210_;
                                    let _e3625 = phi_2211_;
                                    phi_2212_ = _e3621;
                                    phi_2213_ = _e3623;
                                    phi_2214_ = _e3625;
                                } else {
                                    phi_2212_ = array<f64, 3>();
                                    phi_2213_ = _e3599;
                                    phi_2214_ = _e3601;
                                }
                                let _e3627 = phi_2212_;
                                let _e3629 = phi_2213_;
                                let _e3631 = phi_2214_;
                                if _e3629 {
                                    phi_2218_ = true;
                                } else {
                                    phi_2218_ = _e3631;
                                }
                                let _e3633 = phi_2218_;
                                if _e3633 {
                                    let _e3634 = (_e3498 - _e3519);
                                    let _e3635 = (_e3499 - _e3520);
                                    let _e3636 = (_e3500 - _e3521);
                                    let _e3637 = (_e3540 - _e3519);
                                    let _e3638 = (_e3541 - _e3520);
                                    let _e3639 = (_e3542 - _e3521);
                                    let _e3650 = ((((_e3634 * _e3637) + (_e3635 * _e3638)) + (_e3636 * _e3639)) / (((_e3637 * _e3637) + (_e3638 * _e3638)) + (_e3639 * _e3639)));
                                    if (_e3650 > f64(0f)) {
                                        if (_e3650 < f64(1f)) {
                                            phi_2405_ = _e3650;
                                        } else {
                                            phi_2405_ = f64(1f);
                                        }
                                        let _e3658 = phi_2405_;
                                        phi_2407_ = _e3658;
                                    } else {
                                        phi_2407_ = f64(0f);
                                    }
                                    let _e3660 = phi_2407_;
                                    let _e3664 = (_e3634 - (_e3637 * _e3660));
                                    let _e3665 = (_e3635 - (_e3638 * _e3660));
                                    let _e3666 = (_e3636 - (_e3639 * _e3660));
                                    let _e3677 = ((((_e3498 * _e3519) + (_e3499 * _e3520)) + (_e3500 * _e3521)) / (((_e3519 * _e3519) + (_e3520 * _e3520)) + (_e3521 * _e3521)));
                                    if (_e3677 > f64(0f)) {
                                        if (_e3677 < f64(1f)) {
                                            phi_2437_ = _e3677;
                                        } else {
                                            phi_2437_ = f64(1f);
                                        }
                                        let _e3685 = phi_2437_;
                                        phi_2439_ = _e3685;
                                    } else {
                                        phi_2439_ = f64(0f);
                                    }
                                    let _e3687 = phi_2439_;
                                    let _e3704 = ((((_e3498 * _e3540) + (_e3499 * _e3541)) + (_e3500 * _e3542)) / (((_e3540 * _e3540) + (_e3541 * _e3541)) + (_e3542 * _e3542)));
                                    if (_e3704 > f64(0f)) {
                                        if (_e3704 < f64(1f)) {
                                            phi_2469_ = _e3704;
                                        } else {
                                            phi_2469_ = f64(1f);
                                        }
                                        let _e3712 = phi_2469_;
                                        phi_2471_ = _e3712;
                                    } else {
                                        phi_2471_ = f64(0f);
                                    }
                                    let _e3714 = phi_2471_;
                                    local_11[0u] = array<f64, 3>((_e3498 - (_e3519 * _e3687)), (_e3499 - (_e3520 * _e3687)), (_e3500 - (_e3521 * _e3687)));
                                    local_11[1u] = array<f64, 3>((_e3498 - (_e3540 * _e3714)), (_e3499 - (_e3541 * _e3714)), (_e3500 - (_e3542 * _e3714)));
                                    local_11[2u] = array<f64, 3>(_e3664, _e3665, _e3666);
                                    local_11[3u] = array<f64, 3>(_e3664, _e3665, _e3666);
                                    let _e3730 = local_11[0u];
                                    phi_2507_ = type_29(1u, 4u);
                                    phi_2510_ = array<f64, 3>(_e3730[0], _e3730[1], _e3730[2]);
                                    loop {
                                        let _e3736 = phi_2507_;
                                        let _e3738 = phi_2510_;
                                        local_69 = _e3738;
                                        if (_e3736.member < _e3736.member_1) {
                                            phi_2508_ = type_29((_e3736.member + 1u), _e3736.member_1);
                                            phi_2533_ = type_29(1u, _e3736.member);
                                        } else {
                                            phi_2508_ = _e3736;
                                            phi_2533_ = type_29(0u, type_29().member_1);
                                        }
                                        let _e3752 = phi_2508_;
                                        let _e3754 = phi_2533_;
                                        let _e3758 = (bitcast<i32>(_e3754.member) != 0i);
                                        if _e3758 {
                                            if (_e3754.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3761 = local_11[_e3754.member_1];
                                            if (_e3754.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3767 = local_11[_e3754.member_1];
                                            if ((((_e3761[0] * _e3767[0]) + (_e3761[1] * _e3767[1])) + (_e3761[2] * _e3767[2])) < (((_e3738[0] * _e3738[0]) + (_e3738[1] * _e3738[1])) + (_e3738[2] * _e3738[2]))) {
                                                if (_e3754.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3790 = local_11[_e3754.member_1];
                                                phi_2600_ = array<f64, 3>(_e3790[0], _e3790[1], _e3790[2]);
                                            } else {
                                                phi_2600_ = _e3738;
                                            }
                                            let _e3796 = phi_2600_;
                                            phi_2511_ = _e3796;
                                        } else {
                                            phi_2511_ = array<f64, 3>();
                                        }
                                        let _e3798 = phi_2511_;
                                        continue;
                                        continuing {
                                            phi_2507_ = _e3752;
                                            phi_2510_ = _e3798;
                                            break if !(_e3758);
                                        }
                                    }
                                    let _e5509 = local_69;
                                    phi_2601_ = _e5509;
                                } else {
                                    phi_2601_ = _e3627;
                                }
                                let _e3801 = phi_2601_;
                                if (_e3801[0] < 0.0lf) {
                                    phi_2608_ = -(_e3801[0]);
                                } else {
                                    phi_2608_ = _e3801[0];
                                }
                                let _e3806 = phi_2608_;
                                if (_e3801[1] < 0.0lf) {
                                    phi_2615_ = -(_e3801[1]);
                                } else {
                                    phi_2615_ = _e3801[1];
                                }
                                let _e3811 = phi_2615_;
                                if (_e3801[2] < 0.0lf) {
                                    phi_2623_ = -(_e3801[2]);
                                } else {
                                    phi_2623_ = _e3801[2];
                                }
                                let _e3817 = phi_2623_;
                                let _e3818 = ((_e3806 + _e3811) + _e3817);
                                if (_e3818 > f64(0f)) {
                                    if ((bitcast<u64>(_e3818) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e3824 = (f64(1f) / _e3818);
                                        let _e3826 = (_e3801[0] * _e3824);
                                        let _e3828 = (_e3801[1] * _e3824);
                                        let _e3830 = (_e3801[2] * _e3824);
                                        let _e3835 = (((_e3826 * _e3826) + (_e3828 * _e3828)) + (_e3830 * _e3830));
                                        if (_e3835 <= 2.2250738585072014e-308lf) {
                                            if (_e3835 > 0.0lf) {
                                                phi_2661_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2661_ = 0.0lf;
                                            }
                                            let _e3893 = phi_2661_;
                                            phi_2725_ = _e3893;
                                        } else {
                                            phi_2668_ = type_27(0i, 5i);
                                            phi_2671_ = bitcast<f64>(((bitcast<u64>(_e3835) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e3842 = phi_2668_;
                                                let _e3844 = phi_2671_;
                                                local_38 = _e3844;
                                                if (_e3842.member < _e3842.member_1) {
                                                    let _e3852 = (_e3842.member + 1i);
                                                    if ((false == (_e3852 > _e3842.member)) != false) {
                                                        phi_2692_ = true;
                                                    } else {
                                                        phi_2692_ = false;
                                                    }
                                                    let _e3857 = phi_2692_;
                                                    if _e3857 {
                                                        phi_2698_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_2698_ = type_28(1u, _e3852);
                                                    }
                                                    let _e3863 = phi_2698_;
                                                    if (bitcast<i32>(_e3863.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2669_ = type_27(_e3863.member_1, _e3842.member_1);
                                                    phi_2712_ = type_28(1u, _e3842.member);
                                                } else {
                                                    phi_2669_ = _e3842;
                                                    phi_2712_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e3873 = phi_2669_;
                                                let _e3875 = phi_2712_;
                                                let _e3878 = (bitcast<i32>(_e3875.member) != 0i);
                                                if _e3878 {
                                                    phi_2672_ = (0.5lf * (_e3844 + (_e3835 / _e3844)));
                                                } else {
                                                    phi_2672_ = f64();
                                                }
                                                let _e3883 = phi_2672_;
                                                continue;
                                                continuing {
                                                    phi_2668_ = _e3873;
                                                    phi_2671_ = _e3883;
                                                    break if !(_e3878);
                                                }
                                            }
                                            let _e3888 = local_38;
                                            phi_2725_ = (_e3888 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e3895 = phi_2725_;
                                        phi_2738_ = type_29(0u, 4u);
                                        phi_2741_ = f64(2f);
                                        loop {
                                            let _e3907 = phi_2738_;
                                            let _e3909 = phi_2741_;
                                            local_40 = _e3909;
                                            local_41 = _e3909;
                                            local_42 = _e3909;
                                            local_70 = _e3909;
                                            local_71 = _e3909;
                                            if (_e3907.member < _e3907.member_1) {
                                                phi_2739_ = type_29((_e3907.member + 1u), _e3907.member_1);
                                                phi_2764_ = type_29(1u, _e3907.member);
                                            } else {
                                                phi_2739_ = _e3907;
                                                phi_2764_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e3923 = phi_2739_;
                                            let _e3925 = phi_2764_;
                                            if (bitcast<i32>(_e3925.member) != 0i) {
                                                if (_e3925.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3932 = local_12[_e3925.member_1];
                                                let _e3940 = (((_e3826 * _e3932[0]) + (_e3828 * _e3932[1])) + (_e3830 * _e3932[2]));
                                                if (_e3925.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3943 = local_13[_e3925.member_1];
                                                let _e3951 = (((_e3826 * _e3943[0]) + (_e3828 * _e3943[1])) + (_e3830 * _e3943[2]));
                                                if (_e3940 < 0.0lf) {
                                                    phi_2815_ = -(_e3940);
                                                } else {
                                                    phi_2815_ = _e3940;
                                                }
                                                let _e3955 = phi_2815_;
                                                if (_e3951 < 0.0lf) {
                                                    phi_2821_ = -(_e3951);
                                                } else {
                                                    phi_2821_ = _e3951;
                                                }
                                                let _e3959 = phi_2821_;
                                                let _e3964 = (((((((((_e3331 + _e3333) + (_e3385 + _e3387)) + (_e3439 + _e3441)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3449 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e453 * _e3895) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e3955 + _e3959) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e3940 > _e3964) {
                                                    if (_e3951 > _e3964) {
                                                        phi_2835_ = false;
                                                    } else {
                                                        phi_2835_ = true;
                                                    }
                                                    let _e3968 = phi_2835_;
                                                    phi_2836_ = _e3968;
                                                } else {
                                                    phi_2836_ = true;
                                                }
                                                let _e3970 = phi_2836_;
                                                if _e3970 {
                                                    let _e3974 = ((_e3940 + ((_e3951 - _e3940) * _e3460)) > _e3964);
                                                    if _e3974 {
                                                        if (_e3951 < _e3940) {
                                                            let _e3983 = (((_e3940 - _e3964) / (_e3940 - _e3951)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                            if (_e3909 < _e3983) {
                                                                phi_2863_ = _e3909;
                                                            } else {
                                                                phi_2863_ = _e3983;
                                                            }
                                                            let _e3986 = phi_2863_;
                                                            phi_2864_ = _e3986;
                                                        } else {
                                                            phi_2864_ = _e3909;
                                                        }
                                                        let _e3988 = phi_2864_;
                                                        phi_2865_ = _e3988;
                                                    } else {
                                                        phi_2865_ = f64();
                                                    }
                                                    let _e3990 = phi_2865_;
                                                    phi_2866_ = _e3990;
                                                    phi_2867_ = _e3974;
                                                } else {
                                                    phi_2866_ = _e3909;
                                                    phi_2867_ = true;
                                                }
                                                let _e3992 = phi_2866_;
                                                let _e3994 = phi_2867_;
                                                phi_2742_ = _e3992;
                                                phi_2868_ = _e3994;
                                                phi_2869_ = false;
                                            } else {
                                                phi_2742_ = f64();
                                                phi_2868_ = false;
                                                phi_2869_ = true;
                                            }
                                            let _e3996 = phi_2742_;
                                            let _e3998 = phi_2868_;
                                            let _e4000 = phi_2869_;
                                            local_39 = _e4000;
                                            continue;
                                            continuing {
                                                phi_2738_ = _e3923;
                                                phi_2741_ = _e3996;
                                                break if !(_e3998);
                                            }
                                        }
                                        let _e4003 = local_39;
                                        if _e4003 {
                                            let _e4005 = local_40;
                                            let _e4006 = (_e4005 > _e3225);
                                            if _e4006 {
                                                phi_2891_ = false;
                                                phi_2892_ = false;
                                                phi_2893_ = false;
                                            } else {
                                                let _e4008 = local_41;
                                                if (_e4008 > _e3460) {
                                                    let _e4011 = local_42;
                                                    let _e4014 = ((_e4011 - _e3460) < f64(0.00000000023283064f));
                                                    if _e4014 {
                                                        phi_2887_ = false;
                                                    } else {
                                                        phi_2887_ = true;
                                                    }
                                                    let _e4016 = phi_2887_;
                                                    phi_2888_ = _e4016;
                                                    phi_2889_ = _e4014;
                                                    phi_2890_ = false;
                                                } else {
                                                    phi_2888_ = false;
                                                    phi_2889_ = false;
                                                    phi_2890_ = true;
                                                }
                                                let _e4018 = phi_2888_;
                                                let _e4020 = phi_2889_;
                                                let _e4022 = phi_2890_;
                                                phi_2891_ = _e4018;
                                                phi_2892_ = _e4020;
                                                phi_2893_ = _e4022;
                                            }
                                            let _e4024 = phi_2891_;
                                            let _e4026 = phi_2892_;
                                            let _e4028 = phi_2893_;
                                            phi_2894_ = _e4024;
                                            phi_2895_ = _e4006;
                                            phi_2896_ = _e4026;
                                            phi_2897_ = _e4028;
                                            phi_2898_ = false;
                                        } else {
                                            phi_2894_ = false;
                                            phi_2895_ = false;
                                            phi_2896_ = false;
                                            phi_2897_ = false;
                                            phi_2898_ = true;
                                        }
                                        let _e4030 = phi_2894_;
                                        let _e4032 = phi_2895_;
                                        let _e4034 = phi_2896_;
                                        let _e4036 = phi_2897_;
                                        let _e4038 = phi_2898_;
                                        let _e5557 = local_70;
                                        phi_2899_ = _e5557;
                                        let _e5560 = local_71;
                                        phi_2900_ = _e5560;
                                        phi_2901_ = _e4030;
                                        phi_2902_ = _e4032;
                                        phi_2903_ = _e4034;
                                        phi_2904_ = _e4036;
                                        phi_2905_ = _e4038;
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
                                    let _e4040 = phi_2899_;
                                    let _e4042 = phi_2900_;
                                    let _e4044 = phi_2901_;
                                    let _e4046 = phi_2902_;
                                    let _e4048 = phi_2903_;
                                    let _e4050 = phi_2904_;
                                    let _e4052 = phi_2905_;
                                    let _e4054 = phi_2906_;
                                    phi_2907_ = _e4040;
                                    phi_2908_ = _e4042;
                                    phi_2909_ = _e4044;
                                    phi_2910_ = _e4046;
                                    phi_2911_ = _e4048;
                                    phi_2912_ = _e4050;
                                    phi_2913_ = _e4052;
                                    phi_2914_ = _e4054;
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
                                let _e4056 = phi_2907_;
                                let _e4058 = phi_2908_;
                                let _e4060 = phi_2909_;
                                let _e4062 = phi_2910_;
                                let _e4064 = phi_2911_;
                                let _e4066 = phi_2912_;
                                let _e4068 = phi_2913_;
                                let _e4070 = phi_2914_;
                                let _e4072 = phi_2915_;
                                phi_2916_ = _e4056;
                                phi_1967_ = _e4058;
                                phi_2917_ = _e4060;
                                phi_2918_ = _e4062;
                                phi_2919_ = _e4064;
                                phi_2920_ = false;
                                phi_2921_ = _e4066;
                                phi_2922_ = _e4068;
                                phi_2923_ = _e4070;
                                phi_2924_ = _e4072;
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
                            let _e4074 = phi_2916_;
                            let _e4076 = phi_1967_;
                            let _e4078 = phi_2917_;
                            let _e4080 = phi_2918_;
                            let _e4082 = phi_2919_;
                            let _e4084 = phi_2920_;
                            let _e4086 = phi_2921_;
                            let _e4088 = phi_2922_;
                            let _e4090 = phi_2923_;
                            let _e4092 = phi_2924_;
                            local_43 = _e4080;
                            local_72 = _e4082;
                            local_73 = _e4084;
                            local_74 = _e4086;
                            local_75 = _e4088;
                            local_76 = _e4090;
                            local_77 = _e4092;
                            local_78 = _e4074;
                            local_80 = _e4080;
                            continue;
                            continuing {
                                phi_1963_ = _e3474;
                                phi_1966_ = _e4076;
                                break if !(_e4078);
                            }
                        }
                        let _e4095 = local_43;
                        if _e4095 {
                            phi_2929_ = type_72(0u, type_72().member_1);
                            phi_2930_ = false;
                            phi_2931_ = false;
                            phi_2932_ = false;
                            phi_2933_ = false;
                            phi_2934_ = false;
                            phi_2935_ = false;
                        } else {
                            phi_2929_ = type_72();
                            let _e5590 = local_72;
                            phi_2930_ = _e5590;
                            let _e5593 = local_73;
                            phi_2931_ = _e5593;
                            let _e5596 = local_74;
                            phi_2932_ = _e5596;
                            let _e5599 = local_75;
                            phi_2933_ = _e5599;
                            let _e5602 = local_76;
                            phi_2934_ = _e5602;
                            let _e5605 = local_77;
                            phi_2935_ = _e5605;
                        }
                        let _e4100 = phi_2929_;
                        let _e4102 = phi_2930_;
                        let _e4104 = phi_2931_;
                        let _e4106 = phi_2932_;
                        let _e4108 = phi_2933_;
                        let _e4110 = phi_2934_;
                        let _e4112 = phi_2935_;
                        if _e4102 {
                            let _e5608 = local_78;
                            phi_2939_ = _e5608;
                            phi_2940_ = true;
                            phi_2941_ = false;
                            phi_2942_ = false;
                            phi_2943_ = false;
                            phi_2944_ = false;
                            phi_2945_ = false;
                        } else {
                            let _e5610 = local_79;
                            phi_2939_ = _e5610;
                            phi_2940_ = _e4104;
                            phi_2941_ = _e4106;
                            phi_2942_ = _e4108;
                            let _e5616 = local_80;
                            phi_2943_ = _e5616;
                            phi_2944_ = _e4110;
                            phi_2945_ = _e4112;
                        }
                        let _e4114 = phi_2939_;
                        let _e4116 = phi_2940_;
                        let _e4118 = phi_2941_;
                        let _e4120 = phi_2942_;
                        let _e4122 = phi_2943_;
                        let _e4124 = phi_2944_;
                        let _e4126 = phi_2945_;
                        if _e4116 {
                            phi_2950_ = type_72(1u, _e4114);
                            phi_2951_ = false;
                            phi_2952_ = false;
                            phi_2953_ = false;
                            phi_2954_ = false;
                            phi_2955_ = false;
                        } else {
                            phi_2950_ = type_72();
                            phi_2951_ = _e4118;
                            phi_2952_ = _e4120;
                            phi_2953_ = _e4122;
                            phi_2954_ = _e4124;
                            phi_2955_ = _e4126;
                        }
                        let _e4129 = phi_2950_;
                        let _e4131 = phi_2951_;
                        let _e4133 = phi_2952_;
                        let _e4135 = phi_2953_;
                        let _e4137 = phi_2954_;
                        let _e4139 = phi_2955_;
                        if _e4131 {
                            let _e4141 = local_44;
                            phi_2960_ = type_72(1u, _e4141);
                            phi_2961_ = false;
                            phi_2962_ = true;
                            phi_2963_ = false;
                            phi_2964_ = false;
                        } else {
                            phi_2960_ = _e4100;
                            phi_2961_ = _e4133;
                            phi_2962_ = _e4135;
                            phi_2963_ = _e4137;
                            phi_2964_ = _e4139;
                        }
                        let _e4144 = phi_2960_;
                        let _e4146 = phi_2961_;
                        let _e4148 = phi_2962_;
                        let _e4150 = phi_2963_;
                        let _e4152 = phi_2964_;
                        if _e4146 {
                            let _e4154 = local_45;
                            phi_2969_ = type_72(1u, _e4154);
                            phi_2970_ = true;
                            phi_2971_ = false;
                            phi_2972_ = false;
                        } else {
                            phi_2969_ = _e4144;
                            phi_2970_ = _e4148;
                            phi_2971_ = _e4150;
                            phi_2972_ = _e4152;
                        }
                        let _e4157 = phi_2969_;
                        let _e4159 = phi_2970_;
                        let _e4161 = phi_2971_;
                        let _e4163 = phi_2972_;
                        if _e4159 {
                            phi_2976_ = false;
                            phi_2977_ = false;
                        } else {
                            phi_2976_ = _e4161;
                            phi_2977_ = _e4163;
                        }
                        let _e4165 = phi_2976_;
                        let _e4167 = phi_2977_;
                        if _e4165 {
                            phi_2981_ = false;
                            phi_2982_ = false;
                        } else {
                            phi_2981_ = _e4167;
                            phi_2982_ = _e4159;
                        }
                        let _e4169 = phi_2981_;
                        let _e4171 = phi_2982_;
                        if _e4169 {
                            phi_2986_ = true;
                            phi_2987_ = false;
                        } else {
                            phi_2986_ = _e4165;
                            phi_2987_ = _e4171;
                        }
                        let _e4173 = phi_2986_;
                        let _e4175 = phi_2987_;
                        if _e4173 {
                            let _e4177 = local_46;
                            phi_2992_ = type_72(1u, _e4177);
                            phi_2993_ = true;
                        } else {
                            phi_2992_ = _e4157;
                            phi_2993_ = _e4175;
                        }
                        let _e4180 = phi_2992_;
                        let _e4182 = phi_2993_;
                        if _e4182 {
                            phi_2997_ = _e4180;
                        } else {
                            phi_2997_ = _e4129;
                        }
                        let _e4184 = phi_2997_;
                        if (_e4184.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_3011_ = type_29(0u, 3u);
                            loop {
                                let _e4197 = phi_3011_;
                                if (_e4197.member < _e4197.member_1) {
                                    phi_3012_ = type_29((_e4197.member + 1u), _e4197.member_1);
                                    phi_3035_ = type_29(1u, _e4197.member);
                                } else {
                                    phi_3012_ = _e4197;
                                    phi_3035_ = type_29(0u, type_29().member_1);
                                }
                                let _e4211 = phi_3012_;
                                let _e4213 = phi_3035_;
                                if (bitcast<i32>(_e4213.member) != 0i) {
                                    if (_e4213.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4220 = local_14[_e4213.member_1];
                                    let _e4222 = (_e4184.member_1 + f64(_e4220));
                                    if (_e4222 < _e3225) {
                                        phi_3056_ = _e4222;
                                    } else {
                                        phi_3056_ = _e3225;
                                    }
                                    let _e4225 = phi_3056_;
                                    let _e4228 = local_20.member[0u];
                                    let _e4234 = local_20.member[1u];
                                    let _e4244 = (_e4228[0] + ((_e4234[0] - _e4228[0]) * _e4225));
                                    let _e4245 = (_e4228[1] + ((_e4234[1] - _e4228[1]) * _e4225));
                                    let _e4246 = (_e4228[2] + ((_e4234[2] - _e4228[2]) * _e4225));
                                    let _e4249 = local_20.member_1[0u];
                                    let _e4255 = local_20.member_1[1u];
                                    let _e4265 = (_e4249[0] + ((_e4255[0] - _e4249[0]) * _e4225));
                                    let _e4266 = (_e4249[1] + ((_e4255[1] - _e4249[1]) * _e4225));
                                    let _e4267 = (_e4249[2] + ((_e4255[2] - _e4249[2]) * _e4225));
                                    let _e4270 = local_20.member_2[0u];
                                    let _e4276 = local_20.member_2[1u];
                                    let _e4286 = (_e4270[0] + ((_e4276[0] - _e4270[0]) * _e4225));
                                    let _e4287 = (_e4270[1] + ((_e4276[1] - _e4270[1]) * _e4225));
                                    let _e4288 = (_e4270[2] + ((_e4276[2] - _e4270[2]) * _e4225));
                                    let _e4293 = (((_e4265 * _e4265) + (_e4266 * _e4266)) + (_e4267 * _e4267));
                                    let _e4298 = (((_e4265 * _e4286) + (_e4266 * _e4287)) + (_e4267 * _e4288));
                                    let _e4303 = (((_e4286 * _e4286) + (_e4287 * _e4287)) + (_e4288 * _e4288));
                                    let _e4308 = (((_e4244 * _e4265) + (_e4245 * _e4266)) + (_e4246 * _e4267));
                                    let _e4313 = (((_e4244 * _e4286) + (_e4245 * _e4287)) + (_e4246 * _e4288));
                                    let _e4316 = ((_e4293 * _e4303) - (_e4298 * _e4298));
                                    let _e4317 = f64(0f);
                                    let _e4322 = (((_e4308 * _e4303) - (_e4313 * _e4298)) / _e4316);
                                    let _e4326 = (((_e4313 * _e4293) - (_e4308 * _e4298)) / _e4316);
                                    if (_e4322 >= _e4317) {
                                        if (_e4326 >= _e4317) {
                                            phi_3225_ = ((_e4322 + _e4326) <= f64(1f));
                                            phi_3226_ = false;
                                        } else {
                                            phi_3225_ = bool();
                                            phi_3226_ = true;
                                        }
                                        let _e4332 = phi_3225_;
                                        let _e4334 = phi_3226_;
                                        phi_3227_ = _e4332;
                                        phi_3228_ = _e4334;
                                    } else {
                                        phi_3227_ = bool();
                                        phi_3228_ = true;
                                    }
                                    let _e4336 = phi_3227_;
                                    let _e4338 = phi_3228_;
                                    if _e4338 {
                                        let _e4339 = (_e4316 > _e4317);
                                        if _e4339 {
                                            phi_3241_ = false;
                                        } else {
                                            phi_3241_ = true;
                                        }
                                        let _e4341 = phi_3241_;
                                        phi_3242_ = false;
                                        phi_3243_ = _e4341;
                                        phi_3244_ = _e4339;
                                    } else {
                                        phi_3242_ = true;
                                        phi_3243_ = false;
                                        phi_3244_ = false;
                                    }
                                    let _e4343 = phi_3242_;
                                    let _e4345 = phi_3243_;
                                    let _e4347 = phi_3244_;
                                    if _e4343 {
                                        if (_e4316 > _e4317) {
                                            if _e4336 {
                                                phi_3268_ = array<f64, 3>((_e4244 - ((_e4265 * _e4322) + (_e4286 * _e4326))), (_e4245 - ((_e4266 * _e4322) + (_e4287 * _e4326))), (_e4246 - ((_e4267 * _e4322) + (_e4288 * _e4326))));
                                                phi_3269_ = false;
                                            } else {
                                                phi_3268_ = array<f64, 3>();
                                                phi_3269_ = true;
                                            }
                                            let _e4363 = phi_3268_;
                                            let _e4365 = phi_3269_;
                                            phi_3270_ = _e4363;
                                            phi_3271_ = false;
                                            phi_3272_ = _e4365;
                                        } else {
                                            phi_3270_ = array<f64, 3>();
                                            phi_3271_ = true;
                                            phi_3272_ = false;
                                        }
                                        let _e4367 = phi_3270_;
                                        let _e4369 = phi_3271_;
                                        let _e4371 = phi_3272_;
                                        phi_3273_ = _e4367;
                                        phi_3274_ = _e4369;
                                        phi_3275_ = _e4371;
                                    } else {
                                        phi_3273_ = array<f64, 3>();
                                        phi_3274_ = _e4345;
                                        phi_3275_ = _e4347;
                                    }
                                    let _e4373 = phi_3273_;
                                    let _e4375 = phi_3274_;
                                    let _e4377 = phi_3275_;
                                    if _e4375 {
                                        phi_3279_ = true;
                                    } else {
                                        phi_3279_ = _e4377;
                                    }
                                    let _e4379 = phi_3279_;
                                    if _e4379 {
                                        let _e4380 = (_e4244 - _e4265);
                                        let _e4381 = (_e4245 - _e4266);
                                        let _e4382 = (_e4246 - _e4267);
                                        let _e4383 = (_e4286 - _e4265);
                                        let _e4384 = (_e4287 - _e4266);
                                        let _e4385 = (_e4288 - _e4267);
                                        let _e4396 = ((((_e4380 * _e4383) + (_e4381 * _e4384)) + (_e4382 * _e4385)) / (((_e4383 * _e4383) + (_e4384 * _e4384)) + (_e4385 * _e4385)));
                                        if (_e4396 > f64(0f)) {
                                            if (_e4396 < f64(1f)) {
                                                phi_3466_ = _e4396;
                                            } else {
                                                phi_3466_ = f64(1f);
                                            }
                                            let _e4404 = phi_3466_;
                                            phi_3468_ = _e4404;
                                        } else {
                                            phi_3468_ = f64(0f);
                                        }
                                        let _e4406 = phi_3468_;
                                        let _e4410 = (_e4380 - (_e4383 * _e4406));
                                        let _e4411 = (_e4381 - (_e4384 * _e4406));
                                        let _e4412 = (_e4382 - (_e4385 * _e4406));
                                        let _e4423 = ((((_e4244 * _e4265) + (_e4245 * _e4266)) + (_e4246 * _e4267)) / (((_e4265 * _e4265) + (_e4266 * _e4266)) + (_e4267 * _e4267)));
                                        if (_e4423 > f64(0f)) {
                                            if (_e4423 < f64(1f)) {
                                                phi_3498_ = _e4423;
                                            } else {
                                                phi_3498_ = f64(1f);
                                            }
                                            let _e4431 = phi_3498_;
                                            phi_3500_ = _e4431;
                                        } else {
                                            phi_3500_ = f64(0f);
                                        }
                                        let _e4433 = phi_3500_;
                                        let _e4450 = ((((_e4244 * _e4286) + (_e4245 * _e4287)) + (_e4246 * _e4288)) / (((_e4286 * _e4286) + (_e4287 * _e4287)) + (_e4288 * _e4288)));
                                        if (_e4450 > f64(0f)) {
                                            if (_e4450 < f64(1f)) {
                                                phi_3530_ = _e4450;
                                            } else {
                                                phi_3530_ = f64(1f);
                                            }
                                            let _e4458 = phi_3530_;
                                            phi_3532_ = _e4458;
                                        } else {
                                            phi_3532_ = f64(0f);
                                        }
                                        let _e4460 = phi_3532_;
                                        local_10[0u] = array<f64, 3>((_e4244 - (_e4265 * _e4433)), (_e4245 - (_e4266 * _e4433)), (_e4246 - (_e4267 * _e4433)));
                                        local_10[1u] = array<f64, 3>((_e4244 - (_e4286 * _e4460)), (_e4245 - (_e4287 * _e4460)), (_e4246 - (_e4288 * _e4460)));
                                        local_10[2u] = array<f64, 3>(_e4410, _e4411, _e4412);
                                        local_10[3u] = array<f64, 3>(_e4410, _e4411, _e4412);
                                        let _e4476 = local_10[0u];
                                        phi_3568_ = type_29(1u, 4u);
                                        phi_3571_ = array<f64, 3>(_e4476[0], _e4476[1], _e4476[2]);
                                        loop {
                                            let _e4482 = phi_3568_;
                                            let _e4484 = phi_3571_;
                                            local_81 = _e4484;
                                            if (_e4482.member < _e4482.member_1) {
                                                phi_3569_ = type_29((_e4482.member + 1u), _e4482.member_1);
                                                phi_3594_ = type_29(1u, _e4482.member);
                                            } else {
                                                phi_3569_ = _e4482;
                                                phi_3594_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e4498 = phi_3569_;
                                            let _e4500 = phi_3594_;
                                            let _e4504 = (bitcast<i32>(_e4500.member) != 0i);
                                            if _e4504 {
                                                if (_e4500.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4507 = local_10[_e4500.member_1];
                                                if (_e4500.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4513 = local_10[_e4500.member_1];
                                                if ((((_e4507[0] * _e4513[0]) + (_e4507[1] * _e4513[1])) + (_e4507[2] * _e4513[2])) < (((_e4484[0] * _e4484[0]) + (_e4484[1] * _e4484[1])) + (_e4484[2] * _e4484[2]))) {
                                                    if (_e4500.member_1 < 4u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e4536 = local_10[_e4500.member_1];
                                                    phi_3661_ = array<f64, 3>(_e4536[0], _e4536[1], _e4536[2]);
                                                } else {
                                                    phi_3661_ = _e4484;
                                                }
                                                let _e4542 = phi_3661_;
                                                phi_3572_ = _e4542;
                                            } else {
                                                phi_3572_ = array<f64, 3>();
                                            }
                                            let _e4544 = phi_3572_;
                                            continue;
                                            continuing {
                                                phi_3568_ = _e4498;
                                                phi_3571_ = _e4544;
                                                break if !(_e4504);
                                            }
                                        }
                                        let _e5681 = local_81;
                                        phi_3662_ = _e5681;
                                    } else {
                                        phi_3662_ = _e4373;
                                    }
                                    let _e4547 = phi_3662_;
                                    let _e4558 = (((_e4547[0] * _e4547[0]) + (_e4547[1] * _e4547[1])) + (_e4547[2] * _e4547[2]));
                                    if (_e4558 <= 2.2250738585072014e-308lf) {
                                        if (_e4558 > 0.0lf) {
                                            phi_3687_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3687_ = 0.0lf;
                                        }
                                        let _e4616 = phi_3687_;
                                        phi_3751_ = _e4616;
                                    } else {
                                        phi_3694_ = type_27(0i, 5i);
                                        phi_3697_ = bitcast<f64>(((bitcast<u64>(_e4558) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e4565 = phi_3694_;
                                            let _e4567 = phi_3697_;
                                            local_47 = _e4567;
                                            if (_e4565.member < _e4565.member_1) {
                                                let _e4575 = (_e4565.member + 1i);
                                                if ((false == (_e4575 > _e4565.member)) != false) {
                                                    phi_3718_ = true;
                                                } else {
                                                    phi_3718_ = false;
                                                }
                                                let _e4580 = phi_3718_;
                                                if _e4580 {
                                                    phi_3724_ = type_28(0u, type_28().member_1);
                                                } else {
                                                    phi_3724_ = type_28(1u, _e4575);
                                                }
                                                let _e4586 = phi_3724_;
                                                if (bitcast<i32>(_e4586.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3695_ = type_27(_e4586.member_1, _e4565.member_1);
                                                phi_3738_ = type_28(1u, _e4565.member);
                                            } else {
                                                phi_3695_ = _e4565;
                                                phi_3738_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4596 = phi_3695_;
                                            let _e4598 = phi_3738_;
                                            let _e4601 = (bitcast<i32>(_e4598.member) != 0i);
                                            if _e4601 {
                                                phi_3698_ = (0.5lf * (_e4567 + (_e4558 / _e4567)));
                                            } else {
                                                phi_3698_ = f64();
                                            }
                                            let _e4606 = phi_3698_;
                                            continue;
                                            continuing {
                                                phi_3694_ = _e4596;
                                                phi_3697_ = _e4606;
                                                break if !(_e4601);
                                            }
                                        }
                                        let _e4611 = local_47;
                                        phi_3751_ = (_e4611 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e4618 = phi_3751_;
                                    let _e4626 = local_20.member[0u];
                                    if (_e4626[0] < 0.0lf) {
                                        phi_3769_ = -(_e4626[0]);
                                    } else {
                                        phi_3769_ = _e4626[0];
                                    }
                                    let _e4633 = phi_3769_;
                                    if (_e4626[1] < 0.0lf) {
                                        phi_3776_ = -(_e4626[1]);
                                    } else {
                                        phi_3776_ = _e4626[1];
                                    }
                                    let _e4637 = phi_3776_;
                                    if (_e4633 > _e4637) {
                                        phi_3781_ = _e4633;
                                    } else {
                                        phi_3781_ = _e4637;
                                    }
                                    let _e4640 = phi_3781_;
                                    if (_e4626[2] < 0.0lf) {
                                        phi_3788_ = -(_e4626[2]);
                                    } else {
                                        phi_3788_ = _e4626[2];
                                    }
                                    let _e4644 = phi_3788_;
                                    if (_e4640 > _e4644) {
                                        phi_3793_ = _e4640;
                                    } else {
                                        phi_3793_ = _e4644;
                                    }
                                    let _e4647 = phi_3793_;
                                    let _e4650 = local_20.member[1u];
                                    if (_e4650[0] < 0.0lf) {
                                        phi_3806_ = -(_e4650[0]);
                                    } else {
                                        phi_3806_ = _e4650[0];
                                    }
                                    let _e4657 = phi_3806_;
                                    if (_e4650[1] < 0.0lf) {
                                        phi_3813_ = -(_e4650[1]);
                                    } else {
                                        phi_3813_ = _e4650[1];
                                    }
                                    let _e4661 = phi_3813_;
                                    if (_e4657 > _e4661) {
                                        phi_3818_ = _e4657;
                                    } else {
                                        phi_3818_ = _e4661;
                                    }
                                    let _e4664 = phi_3818_;
                                    if (_e4650[2] < 0.0lf) {
                                        phi_3825_ = -(_e4650[2]);
                                    } else {
                                        phi_3825_ = _e4650[2];
                                    }
                                    let _e4668 = phi_3825_;
                                    if (_e4664 > _e4668) {
                                        phi_3830_ = _e4664;
                                    } else {
                                        phi_3830_ = _e4668;
                                    }
                                    let _e4671 = phi_3830_;
                                    if (_e4647 > _e4671) {
                                        phi_3835_ = _e4647;
                                    } else {
                                        phi_3835_ = _e4671;
                                    }
                                    let _e4674 = phi_3835_;
                                    let _e4676 = local_20.member_3;
                                    let _e4680 = local_20.member_1[0u];
                                    if (_e4680[0] < 0.0lf) {
                                        phi_3852_ = -(_e4680[0]);
                                    } else {
                                        phi_3852_ = _e4680[0];
                                    }
                                    let _e4687 = phi_3852_;
                                    if (_e4680[1] < 0.0lf) {
                                        phi_3859_ = -(_e4680[1]);
                                    } else {
                                        phi_3859_ = _e4680[1];
                                    }
                                    let _e4691 = phi_3859_;
                                    if (_e4687 > _e4691) {
                                        phi_3864_ = _e4687;
                                    } else {
                                        phi_3864_ = _e4691;
                                    }
                                    let _e4694 = phi_3864_;
                                    if (_e4680[2] < 0.0lf) {
                                        phi_3871_ = -(_e4680[2]);
                                    } else {
                                        phi_3871_ = _e4680[2];
                                    }
                                    let _e4698 = phi_3871_;
                                    if (_e4694 > _e4698) {
                                        phi_3876_ = _e4694;
                                    } else {
                                        phi_3876_ = _e4698;
                                    }
                                    let _e4701 = phi_3876_;
                                    let _e4704 = local_20.member_1[1u];
                                    if (_e4704[0] < 0.0lf) {
                                        phi_3890_ = -(_e4704[0]);
                                    } else {
                                        phi_3890_ = _e4704[0];
                                    }
                                    let _e4711 = phi_3890_;
                                    if (_e4704[1] < 0.0lf) {
                                        phi_3897_ = -(_e4704[1]);
                                    } else {
                                        phi_3897_ = _e4704[1];
                                    }
                                    let _e4715 = phi_3897_;
                                    if (_e4711 > _e4715) {
                                        phi_3902_ = _e4711;
                                    } else {
                                        phi_3902_ = _e4715;
                                    }
                                    let _e4718 = phi_3902_;
                                    if (_e4704[2] < 0.0lf) {
                                        phi_3909_ = -(_e4704[2]);
                                    } else {
                                        phi_3909_ = _e4704[2];
                                    }
                                    let _e4722 = phi_3909_;
                                    if (_e4718 > _e4722) {
                                        phi_3914_ = _e4718;
                                    } else {
                                        phi_3914_ = _e4722;
                                    }
                                    let _e4725 = phi_3914_;
                                    if (_e4701 > _e4725) {
                                        phi_3919_ = _e4701;
                                    } else {
                                        phi_3919_ = _e4725;
                                    }
                                    let _e4728 = phi_3919_;
                                    let _e4730 = local_20.member_3;
                                    let _e4734 = local_20.member_2[0u];
                                    if (_e4734[0] < 0.0lf) {
                                        phi_3936_ = -(_e4734[0]);
                                    } else {
                                        phi_3936_ = _e4734[0];
                                    }
                                    let _e4741 = phi_3936_;
                                    if (_e4734[1] < 0.0lf) {
                                        phi_3943_ = -(_e4734[1]);
                                    } else {
                                        phi_3943_ = _e4734[1];
                                    }
                                    let _e4745 = phi_3943_;
                                    if (_e4741 > _e4745) {
                                        phi_3948_ = _e4741;
                                    } else {
                                        phi_3948_ = _e4745;
                                    }
                                    let _e4748 = phi_3948_;
                                    if (_e4734[2] < 0.0lf) {
                                        phi_3955_ = -(_e4734[2]);
                                    } else {
                                        phi_3955_ = _e4734[2];
                                    }
                                    let _e4752 = phi_3955_;
                                    if (_e4748 > _e4752) {
                                        phi_3960_ = _e4748;
                                    } else {
                                        phi_3960_ = _e4752;
                                    }
                                    let _e4755 = phi_3960_;
                                    let _e4758 = local_20.member_2[1u];
                                    if (_e4758[0] < 0.0lf) {
                                        phi_3974_ = -(_e4758[0]);
                                    } else {
                                        phi_3974_ = _e4758[0];
                                    }
                                    let _e4765 = phi_3974_;
                                    if (_e4758[1] < 0.0lf) {
                                        phi_3981_ = -(_e4758[1]);
                                    } else {
                                        phi_3981_ = _e4758[1];
                                    }
                                    let _e4769 = phi_3981_;
                                    if (_e4765 > _e4769) {
                                        phi_3986_ = _e4765;
                                    } else {
                                        phi_3986_ = _e4769;
                                    }
                                    let _e4772 = phi_3986_;
                                    if (_e4758[2] < 0.0lf) {
                                        phi_3993_ = -(_e4758[2]);
                                    } else {
                                        phi_3993_ = _e4758[2];
                                    }
                                    let _e4776 = phi_3993_;
                                    if (_e4772 > _e4776) {
                                        phi_3998_ = _e4772;
                                    } else {
                                        phi_3998_ = _e4776;
                                    }
                                    let _e4779 = phi_3998_;
                                    if (_e4755 > _e4779) {
                                        phi_4003_ = _e4755;
                                    } else {
                                        phi_4003_ = _e4779;
                                    }
                                    let _e4782 = phi_4003_;
                                    let _e4784 = local_20.member_3;
                                    let _e4792 = local_20.member_3;
                                    let _e4802 = (((_e4618 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e4674 + _e4676) + (_e4728 + _e4730)) + (_e4782 + _e4784)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4792 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e453);
                                    if _e4802 {
                                        phi_4027_ = false;
                                    } else {
                                        phi_4027_ = true;
                                    }
                                    let _e4804 = phi_4027_;
                                    phi_4028_ = _e4804;
                                    phi_4029_ = _e4802;
                                } else {
                                    phi_4028_ = false;
                                    phi_4029_ = false;
                                }
                                let _e4806 = phi_4028_;
                                let _e4808 = phi_4029_;
                                local_48 = _e4808;
                                continue;
                                continuing {
                                    phi_3011_ = _e4211;
                                    break if !(_e4806);
                                }
                            }
                            let _e4811 = local_48;
                            if _e4811 {
                                phi_4034_ = type_72(1u, _e4184.member_1);
                                phi_4035_ = false;
                            } else {
                                phi_4034_ = type_72();
                                phi_4035_ = true;
                            }
                            let _e4814 = phi_4034_;
                            let _e4816 = phi_4035_;
                            if _e4816 {
                                phi_4040_ = type_72(2u, _e4184.member_1);
                                phi_4041_ = false;
                            } else {
                                phi_4040_ = type_72();
                                phi_4041_ = true;
                            }
                            let _e4819 = phi_4040_;
                            let _e4821 = phi_4041_;
                            phi_4043_ = _e4819;
                            phi_4044_ = _e4814;
                            phi_4045_ = _e4821;
                        } else {
                            phi_4043_ = type_72();
                            phi_4044_ = type_72(0u, type_72().member_1);
                            phi_4045_ = true;
                        }
                        let _e4823 = phi_4043_;
                        let _e4825 = phi_4044_;
                        let _e4827 = phi_4045_;
                        if _e4827 {
                            phi_4049_ = _e4825;
                        } else {
                            phi_4049_ = _e4823;
                        }
                        let _e4829 = phi_4049_;
                        phi_7388_ = _e4829;
                    } else {
                        if (_e552 < 0.0lf) {
                            phi_4060_ = -(_e552);
                        } else {
                            phi_4060_ = _e552;
                        }
                        let _e907 = phi_4060_;
                        if (_e575 < 0.0lf) {
                            phi_4066_ = -(_e575);
                        } else {
                            phi_4066_ = _e575;
                        }
                        let _e911 = phi_4066_;
                        if (_e907 > _e911) {
                            phi_4071_ = _e907;
                        } else {
                            phi_4071_ = _e911;
                        }
                        let _e914 = phi_4071_;
                        if (_e598 < 0.0lf) {
                            phi_4077_ = -(_e598);
                        } else {
                            phi_4077_ = _e598;
                        }
                        let _e918 = phi_4077_;
                        if (_e609 < 0.0lf) {
                            phi_4083_ = -(_e609);
                        } else {
                            phi_4083_ = _e609;
                        }
                        let _e922 = phi_4083_;
                        if (_e918 > _e922) {
                            phi_4088_ = _e918;
                        } else {
                            phi_4088_ = _e922;
                        }
                        let _e925 = phi_4088_;
                        if (_e914 > _e925) {
                            phi_4093_ = _e914;
                        } else {
                            phi_4093_ = _e925;
                        }
                        let _e928 = phi_4093_;
                        let _e932 = ((_e868 * f64(0.34f)) + (_e928 * (1.1102230246251565e-16lf * f64(256f))));
                        let _e933 = f64(0f);
                        let _e934 = f64(1f);
                        let _e935 = f64(3f);
                        let _e937 = (_e575 - (_e935 * _e552));
                        let _e938 = (_e598 - _e575);
                        let _e940 = ((_e935 * _e609) - _e598);
                        local_7[0u] = _e933;
                        local_7[1u] = _e934;
                        local_7[2u] = _e934;
                        local_7[3u] = _e934;
                        let _e947 = ((_e938 * _e938) - (_e937 * _e940));
                        if (_e947 > _e933) {
                            if (_e947 <= 2.2250738585072014e-308lf) {
                                if (_e947 > 0.0lf) {
                                    phi_4130_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4130_ = 0.0lf;
                                }
                                let _e1006 = phi_4130_;
                                phi_4194_ = _e1006;
                            } else {
                                phi_4137_ = type_27(0i, 5i);
                                phi_4140_ = bitcast<f64>(((bitcast<u64>(_e947) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e955 = phi_4137_;
                                    let _e957 = phi_4140_;
                                    local_21 = _e957;
                                    if (_e955.member < _e955.member_1) {
                                        let _e965 = (_e955.member + 1i);
                                        if ((false == (_e965 > _e955.member)) != false) {
                                            phi_4161_ = true;
                                        } else {
                                            phi_4161_ = false;
                                        }
                                        let _e970 = phi_4161_;
                                        if _e970 {
                                            phi_4167_ = type_28(0u, type_28().member_1);
                                        } else {
                                            phi_4167_ = type_28(1u, _e965);
                                        }
                                        let _e976 = phi_4167_;
                                        if (bitcast<i32>(_e976.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_4138_ = type_27(_e976.member_1, _e955.member_1);
                                        phi_4181_ = type_28(1u, _e955.member);
                                    } else {
                                        phi_4138_ = _e955;
                                        phi_4181_ = type_28(0u, type_28().member_1);
                                    }
                                    let _e986 = phi_4138_;
                                    let _e988 = phi_4181_;
                                    let _e991 = (bitcast<i32>(_e988.member) != 0i);
                                    if _e991 {
                                        phi_4141_ = (0.5lf * (_e957 + (_e947 / _e957)));
                                    } else {
                                        phi_4141_ = f64();
                                    }
                                    let _e996 = phi_4141_;
                                    continue;
                                    continuing {
                                        phi_4137_ = _e986;
                                        phi_4140_ = _e996;
                                        break if !(_e991);
                                    }
                                }
                                let _e1001 = local_21;
                                phi_4194_ = (_e1001 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1008 = phi_4194_;
                            if (_e938 < _e933) {
                                phi_4200_ = -(_e1008);
                            } else {
                                phi_4200_ = _e1008;
                            }
                            let _e1012 = phi_4200_;
                            let _e1014 = -((_e938 + _e1012));
                            local_8[0u] = (_e1014 / (_e1014 + _e940));
                            local_8[1u] = (_e937 / (_e937 + _e1014));
                            let _e1023 = local_8[1u];
                            let _e1024 = local_8[0u];
                            if (_e1023 < _e1024) {
                                let _e1027 = local_8[1u];
                                let _e1029 = local_8[0u];
                                local_8[0u] = _e1027;
                                local_8[1u] = _e1029;
                            }
                            phi_4225_ = type_29(0u, 2u);
                            phi_4228_ = 1u;
                            loop {
                                let _e1033 = phi_4225_;
                                let _e1035 = phi_4228_;
                                local_49 = _e1035;
                                if (_e1033.member < _e1033.member_1) {
                                    phi_4226_ = type_29((_e1033.member + 1u), _e1033.member_1);
                                    phi_4251_ = type_29(1u, _e1033.member);
                                } else {
                                    phi_4226_ = _e1033;
                                    phi_4251_ = type_29(0u, type_29().member_1);
                                }
                                let _e1049 = phi_4226_;
                                let _e1051 = phi_4251_;
                                let _e1055 = (bitcast<i32>(_e1051.member) != 0i);
                                if _e1055 {
                                    if (_e1051.member_1 < 2u) {
                                    } else {
                                        return;
                                    }
                                    let _e1058 = local_8[_e1051.member_1];
                                    if (_e1058 > _e933) {
                                        if (_e1051.member_1 < 2u) {
                                        } else {
                                            return;
                                        }
                                        let _e1062 = local_8[_e1051.member_1];
                                        if (_e1062 < _e934) {
                                            if (_e1051.member_1 < 2u) {
                                            } else {
                                                return;
                                            }
                                            let _e1066 = local_8[_e1051.member_1];
                                            if (_e1035 < 4u) {
                                            } else {
                                                return;
                                            }
                                            local_7[_e1035] = _e1066;
                                            phi_4295_ = (_e1035 + 1u);
                                        } else {
                                            phi_4295_ = _e1035;
                                        }
                                        let _e1071 = phi_4295_;
                                        phi_4296_ = _e1071;
                                    } else {
                                        phi_4296_ = _e1035;
                                    }
                                    let _e1073 = phi_4296_;
                                    phi_4229_ = _e1073;
                                } else {
                                    phi_4229_ = u32();
                                }
                                let _e1075 = phi_4229_;
                                continue;
                                continuing {
                                    phi_4225_ = _e1049;
                                    phi_4228_ = _e1075;
                                    break if !(_e1055);
                                }
                            }
                            let _e5010 = local_49;
                            phi_4297_ = _e5010;
                        } else {
                            phi_4297_ = 1u;
                        }
                        let _e1078 = phi_4297_;
                        if (_e1078 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e1078] = _e934;
                        let _e1081 = local_7;
                        local_9 = _e1081;
                        phi_4317_ = type_29(0u, _e1078);
                        loop {
                            let _e1084 = phi_4317_;
                            if (_e1084.member < _e1084.member_1) {
                                phi_4318_ = type_29((_e1084.member + 1u), _e1084.member_1);
                                phi_4341_ = type_29(1u, _e1084.member);
                            } else {
                                phi_4318_ = _e1084;
                                phi_4341_ = type_29(0u, type_29().member_1);
                            }
                            let _e1098 = phi_4318_;
                            let _e1100 = phi_4341_;
                            if (bitcast<i32>(_e1100.member) != 0i) {
                                if (_e1100.member_1 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1107 = local_9[_e1100.member_1];
                                let _e1108 = (_e1100.member_1 + 1u);
                                if (_e1108 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1111 = local_9[_e1108];
                                let _e1113 = (f64(1f) - _e1107);
                                let _e1124 = ((((_e552 * _e1113) + (_e575 * _e1107)) * (_e1113 * _e1113)) + (((_e598 * _e1113) + (_e609 * _e1107)) * (_e1107 * _e1107)));
                                let _e1126 = (f64(1f) - _e1111);
                                let _e1137 = ((((_e552 * _e1126) + (_e575 * _e1111)) * (_e1126 * _e1126)) + (((_e598 * _e1126) + (_e609 * _e1111)) * (_e1111 * _e1111)));
                                if (_e1124 < 0.0lf) {
                                    phi_4395_ = -(_e1124);
                                } else {
                                    phi_4395_ = _e1124;
                                }
                                let _e1141 = phi_4395_;
                                let _e1142 = (_e1141 > _e932);
                                if (_e1137 < 0.0lf) {
                                    phi_4402_ = -(_e1137);
                                } else {
                                    phi_4402_ = _e1137;
                                }
                                let _e1146 = phi_4402_;
                                let _e1147 = (_e1146 > _e932);
                                let _e1148 = f64(0f);
                                if _e1142 {
                                    if _e1147 {
                                        let _e1151 = ((_e1124 > _e1148) != (_e1137 > _e1148));
                                        if _e1142 {
                                            if _e1147 {
                                                if _e1151 {
                                                    phi_4423_ = false;
                                                } else {
                                                    phi_4423_ = true;
                                                }
                                                let _e1153 = phi_4423_;
                                                phi_4424_ = _e1153;
                                            } else {
                                                phi_4424_ = false;
                                            }
                                            let _e1155 = phi_4424_;
                                            phi_4425_ = _e1155;
                                        } else {
                                            phi_4425_ = false;
                                        }
                                        let _e1157 = phi_4425_;
                                        phi_4426_ = _e1151;
                                        phi_4427_ = _e1151;
                                        phi_4428_ = false;
                                        phi_4429_ = _e1157;
                                    } else {
                                        phi_4426_ = bool();
                                        phi_4427_ = bool();
                                        phi_4428_ = true;
                                        phi_4429_ = false;
                                    }
                                    let _e1159 = phi_4426_;
                                    let _e1161 = phi_4427_;
                                    let _e1163 = phi_4428_;
                                    let _e1165 = phi_4429_;
                                    phi_4430_ = _e1159;
                                    phi_4431_ = _e1161;
                                    phi_4432_ = _e1163;
                                    phi_4433_ = _e1165;
                                } else {
                                    phi_4430_ = bool();
                                    phi_4431_ = bool();
                                    phi_4432_ = true;
                                    phi_4433_ = false;
                                }
                                let _e1167 = phi_4430_;
                                let _e1169 = phi_4431_;
                                let _e1171 = phi_4432_;
                                let _e1173 = phi_4433_;
                                if _e1171 {
                                    if _e1142 {
                                        phi_4443_ = _e1147;
                                    } else {
                                        phi_4443_ = false;
                                    }
                                    let _e1175 = phi_4443_;
                                    phi_4444_ = false;
                                    phi_4445_ = false;
                                    phi_4446_ = _e1175;
                                } else {
                                    phi_4444_ = _e1169;
                                    phi_4445_ = _e1167;
                                    phi_4446_ = _e1173;
                                }
                                let _e1177 = phi_4444_;
                                let _e1179 = phi_4445_;
                                let _e1181 = phi_4446_;
                                if _e1181 {
                                    phi_4452_ = type_73(f64(1f), _e1148, _e1177);
                                    phi_4453_ = false;
                                } else {
                                    phi_4452_ = type_73();
                                    phi_4453_ = true;
                                }
                                let _e1185 = phi_4452_;
                                let _e1187 = phi_4453_;
                                if _e1187 {
                                    if _e1142 {
                                        if (_e1124 < _e1148) {
                                            phi_4466_ = f64(-1f);
                                        } else {
                                            phi_4466_ = f64(1f);
                                        }
                                        let _e1192 = phi_4466_;
                                        let _e1193 = f64(0.00000000000022737368f);
                                        let _e1194 = f64(0.5f);
                                        let _e1195 = f64(3f);
                                        let _e1198 = (_e598 - _e575);
                                        phi_4479_ = type_29(0u, 64u);
                                        phi_4482_ = _e1111;
                                        phi_4484_ = _e1107;
                                        phi_4486_ = (_e1194 * (_e1107 + _e1111));
                                        loop {
                                            let _e1204 = phi_4479_;
                                            let _e1206 = phi_4482_;
                                            let _e1208 = phi_4484_;
                                            let _e1210 = phi_4486_;
                                            local_51 = _e1208;
                                            if (_e1204.member < _e1204.member_1) {
                                                phi_4480_ = type_29((_e1204.member + 1u), _e1204.member_1);
                                                phi_4509_ = type_29(1u, _e1204.member);
                                            } else {
                                                phi_4480_ = _e1204;
                                                phi_4509_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1224 = phi_4480_;
                                            let _e1226 = phi_4509_;
                                            if (bitcast<i32>(_e1226.member) != 0i) {
                                                let _e1231 = (f64(1f) - _e1210);
                                                let _e1244 = ((_e1192 * ((((_e552 * _e1231) + (_e575 * _e1210)) * (_e1231 * _e1231)) + (((_e598 * _e1231) + (_e609 * _e1210)) * (_e1210 * _e1210)))) - _e932);
                                                if (_e1244 > f64(0f)) {
                                                    phi_4536_ = _e1206;
                                                    phi_4537_ = _e1210;
                                                } else {
                                                    phi_4536_ = _e1210;
                                                    phi_4537_ = _e1208;
                                                }
                                                let _e1248 = phi_4536_;
                                                let _e1250 = phi_4537_;
                                                let _e1252 = ((_e1248 - _e1250) > _e1193);
                                                if _e1252 {
                                                    let _e1254 = (f64(1f) - _e1210);
                                                    let _e1266 = (-(_e1244) / (_e1192 * (((((_e575 - (_e1195 * _e552)) * _e1254) + (_e1198 * _e1210)) * _e1254) + (((_e1198 * _e1254) + (((_e1195 * _e609) - _e598) * _e1210)) * _e1210))));
                                                    if (_e1244 > f64(0f)) {
                                                        phi_4565_ = (_e1194 * _e1193);
                                                    } else {
                                                        phi_4565_ = -((_e1194 * _e1193));
                                                    }
                                                    let _e1273 = phi_4565_;
                                                    let _e1275 = ((_e1210 + _e1266) + _e1273);
                                                    if (_e1275 > _e1250) {
                                                        if (_e1275 < _e1248) {
                                                            if (_e1266 < 0.0lf) {
                                                                phi_4581_ = -(_e1266);
                                                            } else {
                                                                phi_4581_ = _e1266;
                                                            }
                                                            let _e1281 = phi_4581_;
                                                            if (_e1281 < (_e1194 * (_e1248 - _e1250))) {
                                                                phi_4588_ = false;
                                                            } else {
                                                                phi_4588_ = true;
                                                            }
                                                            let _e1286 = phi_4588_;
                                                            phi_4589_ = _e1286;
                                                        } else {
                                                            phi_4589_ = true;
                                                        }
                                                        let _e1288 = phi_4589_;
                                                        phi_4590_ = _e1288;
                                                    } else {
                                                        phi_4590_ = true;
                                                    }
                                                    let _e1290 = phi_4590_;
                                                    if _e1290 {
                                                        phi_4596_ = (_e1194 * (_e1250 + _e1248));
                                                    } else {
                                                        phi_4596_ = _e1275;
                                                    }
                                                    let _e1294 = phi_4596_;
                                                    phi_4597_ = _e1294;
                                                    phi_4598_ = false;
                                                } else {
                                                    phi_4597_ = f64();
                                                    phi_4598_ = true;
                                                }
                                                let _e1296 = phi_4597_;
                                                let _e1298 = phi_4598_;
                                                phi_4483_ = _e1248;
                                                phi_4485_ = _e1250;
                                                phi_4487_ = _e1296;
                                                phi_4599_ = _e1250;
                                                phi_4600_ = _e1252;
                                                phi_4601_ = _e1298;
                                            } else {
                                                phi_4483_ = f64();
                                                phi_4485_ = f64();
                                                phi_4487_ = f64();
                                                phi_4599_ = f64();
                                                phi_4600_ = false;
                                                phi_4601_ = false;
                                            }
                                            let _e1300 = phi_4483_;
                                            let _e1302 = phi_4485_;
                                            let _e1304 = phi_4487_;
                                            let _e1306 = phi_4599_;
                                            let _e1308 = phi_4600_;
                                            let _e1310 = phi_4601_;
                                            local_22 = _e1310;
                                            local_50 = _e1306;
                                            continue;
                                            continuing {
                                                phi_4479_ = _e1224;
                                                phi_4482_ = _e1300;
                                                phi_4484_ = _e1302;
                                                phi_4486_ = _e1304;
                                                break if !(_e1308);
                                            }
                                        }
                                        let _e1313 = local_22;
                                        if _e1313 {
                                            let _e5059 = local_50;
                                            phi_4605_ = _e5059;
                                        } else {
                                            let _e5061 = local_51;
                                            phi_4605_ = _e5061;
                                        }
                                        let _e1315 = phi_4605_;
                                        phi_4606_ = _e1315;
                                    } else {
                                        phi_4606_ = _e1107;
                                    }
                                    let _e1317 = phi_4606_;
                                    if _e1147 {
                                        phi_4614_ = type_29(0u, 64u);
                                        phi_4617_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1321 = phi_4614_;
                                            let _e1323 = phi_4617_;
                                            if (_e1321.member < _e1321.member_1) {
                                                phi_4615_ = type_29((_e1321.member + 1u), _e1321.member_1);
                                                phi_4640_ = type_29(1u, _e1321.member);
                                            } else {
                                                phi_4615_ = _e1321;
                                                phi_4640_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1337 = phi_4615_;
                                            let _e1339 = phi_4640_;
                                            if (bitcast<i32>(_e1339.member) != 0i) {
                                                let _e1343 = (_e1317 + _e1323);
                                                if (_e1343 < _e1111) {
                                                    let _e1346 = (f64(1f) - _e1343);
                                                    let _e1357 = ((((_e552 * _e1346) + (_e575 * _e1343)) * (_e1346 * _e1346)) + (((_e598 * _e1346) + (_e609 * _e1343)) * (_e1343 * _e1343)));
                                                    let _e1359 = (f64(1f) - _e1317);
                                                    let _e1370 = ((((_e552 * _e1359) + (_e575 * _e1317)) * (_e1359 * _e1359)) + (((_e598 * _e1359) + (_e609 * _e1317)) * (_e1317 * _e1317)));
                                                    if (_e1357 < 0.0lf) {
                                                        phi_4683_ = -(_e1357);
                                                    } else {
                                                        phi_4683_ = _e1357;
                                                    }
                                                    let _e1374 = phi_4683_;
                                                    if (_e1374 > _e932) {
                                                        if (_e1370 < 0.0lf) {
                                                            phi_4693_ = -(_e1370);
                                                        } else {
                                                            phi_4693_ = _e1370;
                                                        }
                                                        let _e1379 = phi_4693_;
                                                        if (_e1379 > _e932) {
                                                            phi_4703_ = ((_e1357 > f64(0f)) == (_e1370 > f64(0f)));
                                                        } else {
                                                            phi_4703_ = false;
                                                        }
                                                        let _e1387 = phi_4703_;
                                                        phi_4705_ = !(_e1387);
                                                    } else {
                                                        phi_4705_ = false;
                                                    }
                                                    let _e1390 = phi_4705_;
                                                    if _e1390 {
                                                        phi_4710_ = f64();
                                                        phi_4711_ = false;
                                                    } else {
                                                        phi_4710_ = (_e1323 + _e1323);
                                                        phi_4711_ = true;
                                                    }
                                                    let _e1393 = phi_4710_;
                                                    let _e1395 = phi_4711_;
                                                    phi_4712_ = _e1393;
                                                    phi_4713_ = _e1395;
                                                    phi_4714_ = _e1390;
                                                    phi_4715_ = false;
                                                } else {
                                                    phi_4712_ = f64();
                                                    phi_4713_ = false;
                                                    phi_4714_ = false;
                                                    phi_4715_ = true;
                                                }
                                                let _e1397 = phi_4712_;
                                                let _e1399 = phi_4713_;
                                                let _e1401 = phi_4714_;
                                                let _e1403 = phi_4715_;
                                                phi_4716_ = _e1343;
                                                phi_4618_ = _e1397;
                                                phi_4717_ = _e1399;
                                                phi_4718_ = _e1401;
                                                phi_4719_ = _e1403;
                                                phi_4720_ = false;
                                            } else {
                                                phi_4716_ = f64();
                                                phi_4618_ = f64();
                                                phi_4717_ = false;
                                                phi_4718_ = false;
                                                phi_4719_ = false;
                                                phi_4720_ = true;
                                            }
                                            let _e1405 = phi_4716_;
                                            let _e1407 = phi_4618_;
                                            let _e1409 = phi_4717_;
                                            let _e1411 = phi_4718_;
                                            let _e1413 = phi_4719_;
                                            let _e1415 = phi_4720_;
                                            local_23 = _e1411;
                                            local_52 = _e1413;
                                            local_53 = _e1415;
                                            local_54 = _e1405;
                                            continue;
                                            continuing {
                                                phi_4614_ = _e1337;
                                                phi_4617_ = _e1407;
                                                break if !(_e1409);
                                            }
                                        }
                                        let _e1418 = local_23;
                                        if _e1418 {
                                            phi_4724_ = false;
                                            phi_4725_ = false;
                                        } else {
                                            let _e5086 = local_52;
                                            phi_4724_ = _e5086;
                                            let _e5089 = local_53;
                                            phi_4725_ = _e5089;
                                        }
                                        let _e1420 = phi_4724_;
                                        let _e1422 = phi_4725_;
                                        if _e1420 {
                                            phi_4729_ = true;
                                        } else {
                                            phi_4729_ = _e1422;
                                        }
                                        let _e1424 = phi_4729_;
                                        if _e1424 {
                                            phi_4733_ = _e1111;
                                        } else {
                                            let _e5093 = local_54;
                                            phi_4733_ = _e5093;
                                        }
                                        let _e1426 = phi_4733_;
                                        phi_4734_ = _e1426;
                                    } else {
                                        phi_4734_ = _e1111;
                                    }
                                    let _e1428 = phi_4734_;
                                    phi_4736_ = type_73(_e1317, _e1428, _e1179);
                                } else {
                                    phi_4736_ = _e1185;
                                }
                                let _e1431 = phi_4736_;
                                if (_e1431.member > _e1431.member_1) {
                                    phi_7344_ = f64();
                                    phi_7345_ = true;
                                    phi_7346_ = false;
                                    phi_7347_ = false;
                                    phi_7348_ = false;
                                } else {
                                    let _e1439 = ((_e1431.member_1 - _e1431.member) * f64(0.5f));
                                    let _e1440 = (_e1431.member + _e1439);
                                    let _e1443 = (_e1439 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1445 = local_20.member_3;
                                    let _e1448 = local_20.member[0u];
                                    if (_e1448[0] < 0.0lf) {
                                        phi_4767_ = -(_e1448[0]);
                                    } else {
                                        phi_4767_ = _e1448[0];
                                    }
                                    let _e1455 = phi_4767_;
                                    if (_e1448[1] < 0.0lf) {
                                        phi_4774_ = -(_e1448[1]);
                                    } else {
                                        phi_4774_ = _e1448[1];
                                    }
                                    let _e1459 = phi_4774_;
                                    if (_e1455 > _e1459) {
                                        phi_4779_ = _e1455;
                                    } else {
                                        phi_4779_ = _e1459;
                                    }
                                    let _e1462 = phi_4779_;
                                    if (_e1448[2] < 0.0lf) {
                                        phi_4786_ = -(_e1448[2]);
                                    } else {
                                        phi_4786_ = _e1448[2];
                                    }
                                    let _e1466 = phi_4786_;
                                    if (_e1462 > _e1466) {
                                        phi_4791_ = _e1462;
                                    } else {
                                        phi_4791_ = _e1466;
                                    }
                                    let _e1469 = phi_4791_;
                                    let _e1471 = local_20.member[1u];
                                    if (_e1471[0] < 0.0lf) {
                                        phi_4804_ = -(_e1471[0]);
                                    } else {
                                        phi_4804_ = _e1471[0];
                                    }
                                    let _e1478 = phi_4804_;
                                    if (_e1471[1] < 0.0lf) {
                                        phi_4811_ = -(_e1471[1]);
                                    } else {
                                        phi_4811_ = _e1471[1];
                                    }
                                    let _e1482 = phi_4811_;
                                    if (_e1478 > _e1482) {
                                        phi_4816_ = _e1478;
                                    } else {
                                        phi_4816_ = _e1482;
                                    }
                                    let _e1485 = phi_4816_;
                                    if (_e1471[2] < 0.0lf) {
                                        phi_4823_ = -(_e1471[2]);
                                    } else {
                                        phi_4823_ = _e1471[2];
                                    }
                                    let _e1489 = phi_4823_;
                                    if (_e1485 > _e1489) {
                                        phi_4828_ = _e1485;
                                    } else {
                                        phi_4828_ = _e1489;
                                    }
                                    let _e1492 = phi_4828_;
                                    if (_e1469 > _e1492) {
                                        phi_4833_ = _e1469;
                                    } else {
                                        phi_4833_ = _e1492;
                                    }
                                    let _e1495 = phi_4833_;
                                    let _e1498 = local_20.member[0u];
                                    let _e1503 = local_20.member[1u];
                                    let _e1513 = (_e1498[0] + ((_e1503[0] - _e1498[0]) * _e1440));
                                    let _e1514 = (_e1498[1] + ((_e1503[1] - _e1498[1]) * _e1440));
                                    let _e1515 = (_e1498[2] + ((_e1503[2] - _e1498[2]) * _e1440));
                                    let _e1517 = local_20.member[1u];
                                    let _e1522 = local_20.member[0u];
                                    let _e1526 = (_e1517[0] - _e1522[0]);
                                    let _e1527 = (_e1517[1] - _e1522[1]);
                                    let _e1528 = (_e1517[2] - _e1522[2]);
                                    if (_e1526 < 0.0lf) {
                                        phi_4892_ = -(_e1526);
                                    } else {
                                        phi_4892_ = _e1526;
                                    }
                                    let _e1532 = phi_4892_;
                                    if (_e1527 < 0.0lf) {
                                        phi_4898_ = -(_e1527);
                                    } else {
                                        phi_4898_ = _e1527;
                                    }
                                    let _e1536 = phi_4898_;
                                    if (_e1532 > _e1536) {
                                        phi_4903_ = _e1532;
                                    } else {
                                        phi_4903_ = _e1536;
                                    }
                                    let _e1539 = phi_4903_;
                                    if (_e1528 < 0.0lf) {
                                        phi_4909_ = -(_e1528);
                                    } else {
                                        phi_4909_ = _e1528;
                                    }
                                    let _e1543 = phi_4909_;
                                    if (_e1539 > _e1543) {
                                        phi_4914_ = _e1539;
                                    } else {
                                        phi_4914_ = _e1543;
                                    }
                                    let _e1546 = phi_4914_;
                                    let _e1554 = ((((_e1443 * _e1546) * f64(1.01f)) + ((_e1495 + _e1445) * (1.1102230246251565e-16lf * f64(8f)))) + _e1445);
                                    if (_e1513 < 0.0lf) {
                                        phi_4928_ = -(_e1513);
                                    } else {
                                        phi_4928_ = _e1513;
                                    }
                                    let _e1558 = phi_4928_;
                                    if (_e1514 < 0.0lf) {
                                        phi_4934_ = -(_e1514);
                                    } else {
                                        phi_4934_ = _e1514;
                                    }
                                    let _e1562 = phi_4934_;
                                    if (_e1558 > _e1562) {
                                        phi_4939_ = _e1558;
                                    } else {
                                        phi_4939_ = _e1562;
                                    }
                                    let _e1565 = phi_4939_;
                                    if (_e1515 < 0.0lf) {
                                        phi_4945_ = -(_e1515);
                                    } else {
                                        phi_4945_ = _e1515;
                                    }
                                    let _e1569 = phi_4945_;
                                    if (_e1565 > _e1569) {
                                        phi_4950_ = _e1565;
                                    } else {
                                        phi_4950_ = _e1569;
                                    }
                                    let _e1572 = phi_4950_;
                                    local_3 = type_51(array<f64, 3>(_e1513, _e1514, _e1515), _e1554, (_e1572 + _e1554));
                                    let _e1578 = local_20.member_3;
                                    let _e1580 = local_20.member_1[0u];
                                    if (_e1580[0] < 0.0lf) {
                                        phi_4976_ = -(_e1580[0]);
                                    } else {
                                        phi_4976_ = _e1580[0];
                                    }
                                    let _e1587 = phi_4976_;
                                    if (_e1580[1] < 0.0lf) {
                                        phi_4983_ = -(_e1580[1]);
                                    } else {
                                        phi_4983_ = _e1580[1];
                                    }
                                    let _e1591 = phi_4983_;
                                    if (_e1587 > _e1591) {
                                        phi_4988_ = _e1587;
                                    } else {
                                        phi_4988_ = _e1591;
                                    }
                                    let _e1594 = phi_4988_;
                                    if (_e1580[2] < 0.0lf) {
                                        phi_4995_ = -(_e1580[2]);
                                    } else {
                                        phi_4995_ = _e1580[2];
                                    }
                                    let _e1598 = phi_4995_;
                                    if (_e1594 > _e1598) {
                                        phi_5000_ = _e1594;
                                    } else {
                                        phi_5000_ = _e1598;
                                    }
                                    let _e1601 = phi_5000_;
                                    let _e1603 = local_20.member_1[1u];
                                    if (_e1603[0] < 0.0lf) {
                                        phi_5013_ = -(_e1603[0]);
                                    } else {
                                        phi_5013_ = _e1603[0];
                                    }
                                    let _e1610 = phi_5013_;
                                    if (_e1603[1] < 0.0lf) {
                                        phi_5020_ = -(_e1603[1]);
                                    } else {
                                        phi_5020_ = _e1603[1];
                                    }
                                    let _e1614 = phi_5020_;
                                    if (_e1610 > _e1614) {
                                        phi_5025_ = _e1610;
                                    } else {
                                        phi_5025_ = _e1614;
                                    }
                                    let _e1617 = phi_5025_;
                                    if (_e1603[2] < 0.0lf) {
                                        phi_5032_ = -(_e1603[2]);
                                    } else {
                                        phi_5032_ = _e1603[2];
                                    }
                                    let _e1621 = phi_5032_;
                                    if (_e1617 > _e1621) {
                                        phi_5037_ = _e1617;
                                    } else {
                                        phi_5037_ = _e1621;
                                    }
                                    let _e1624 = phi_5037_;
                                    if (_e1601 > _e1624) {
                                        phi_5042_ = _e1601;
                                    } else {
                                        phi_5042_ = _e1624;
                                    }
                                    let _e1627 = phi_5042_;
                                    let _e1630 = local_20.member_1[0u];
                                    let _e1635 = local_20.member_1[1u];
                                    let _e1645 = (_e1630[0] + ((_e1635[0] - _e1630[0]) * _e1440));
                                    let _e1646 = (_e1630[1] + ((_e1635[1] - _e1630[1]) * _e1440));
                                    let _e1647 = (_e1630[2] + ((_e1635[2] - _e1630[2]) * _e1440));
                                    let _e1649 = local_20.member_1[1u];
                                    let _e1654 = local_20.member_1[0u];
                                    let _e1658 = (_e1649[0] - _e1654[0]);
                                    let _e1659 = (_e1649[1] - _e1654[1]);
                                    let _e1660 = (_e1649[2] - _e1654[2]);
                                    if (_e1658 < 0.0lf) {
                                        phi_5101_ = -(_e1658);
                                    } else {
                                        phi_5101_ = _e1658;
                                    }
                                    let _e1664 = phi_5101_;
                                    if (_e1659 < 0.0lf) {
                                        phi_5107_ = -(_e1659);
                                    } else {
                                        phi_5107_ = _e1659;
                                    }
                                    let _e1668 = phi_5107_;
                                    if (_e1664 > _e1668) {
                                        phi_5112_ = _e1664;
                                    } else {
                                        phi_5112_ = _e1668;
                                    }
                                    let _e1671 = phi_5112_;
                                    if (_e1660 < 0.0lf) {
                                        phi_5118_ = -(_e1660);
                                    } else {
                                        phi_5118_ = _e1660;
                                    }
                                    let _e1675 = phi_5118_;
                                    if (_e1671 > _e1675) {
                                        phi_5123_ = _e1671;
                                    } else {
                                        phi_5123_ = _e1675;
                                    }
                                    let _e1678 = phi_5123_;
                                    let _e1686 = ((((_e1443 * _e1678) * f64(1.01f)) + ((_e1627 + _e1578) * (1.1102230246251565e-16lf * f64(8f)))) + _e1578);
                                    if (_e1645 < 0.0lf) {
                                        phi_5137_ = -(_e1645);
                                    } else {
                                        phi_5137_ = _e1645;
                                    }
                                    let _e1690 = phi_5137_;
                                    if (_e1646 < 0.0lf) {
                                        phi_5143_ = -(_e1646);
                                    } else {
                                        phi_5143_ = _e1646;
                                    }
                                    let _e1694 = phi_5143_;
                                    if (_e1690 > _e1694) {
                                        phi_5148_ = _e1690;
                                    } else {
                                        phi_5148_ = _e1694;
                                    }
                                    let _e1697 = phi_5148_;
                                    if (_e1647 < 0.0lf) {
                                        phi_5154_ = -(_e1647);
                                    } else {
                                        phi_5154_ = _e1647;
                                    }
                                    let _e1701 = phi_5154_;
                                    if (_e1697 > _e1701) {
                                        phi_5159_ = _e1697;
                                    } else {
                                        phi_5159_ = _e1701;
                                    }
                                    let _e1704 = phi_5159_;
                                    local_4 = type_51(array<f64, 3>(_e1645, _e1646, _e1647), _e1686, (_e1704 + _e1686));
                                    let _e1710 = local_20.member_3;
                                    let _e1712 = local_20.member_2[0u];
                                    if (_e1712[0] < 0.0lf) {
                                        phi_5185_ = -(_e1712[0]);
                                    } else {
                                        phi_5185_ = _e1712[0];
                                    }
                                    let _e1719 = phi_5185_;
                                    if (_e1712[1] < 0.0lf) {
                                        phi_5192_ = -(_e1712[1]);
                                    } else {
                                        phi_5192_ = _e1712[1];
                                    }
                                    let _e1723 = phi_5192_;
                                    if (_e1719 > _e1723) {
                                        phi_5197_ = _e1719;
                                    } else {
                                        phi_5197_ = _e1723;
                                    }
                                    let _e1726 = phi_5197_;
                                    if (_e1712[2] < 0.0lf) {
                                        phi_5204_ = -(_e1712[2]);
                                    } else {
                                        phi_5204_ = _e1712[2];
                                    }
                                    let _e1730 = phi_5204_;
                                    if (_e1726 > _e1730) {
                                        phi_5209_ = _e1726;
                                    } else {
                                        phi_5209_ = _e1730;
                                    }
                                    let _e1733 = phi_5209_;
                                    let _e1735 = local_20.member_2[1u];
                                    if (_e1735[0] < 0.0lf) {
                                        phi_5222_ = -(_e1735[0]);
                                    } else {
                                        phi_5222_ = _e1735[0];
                                    }
                                    let _e1742 = phi_5222_;
                                    if (_e1735[1] < 0.0lf) {
                                        phi_5229_ = -(_e1735[1]);
                                    } else {
                                        phi_5229_ = _e1735[1];
                                    }
                                    let _e1746 = phi_5229_;
                                    if (_e1742 > _e1746) {
                                        phi_5234_ = _e1742;
                                    } else {
                                        phi_5234_ = _e1746;
                                    }
                                    let _e1749 = phi_5234_;
                                    if (_e1735[2] < 0.0lf) {
                                        phi_5241_ = -(_e1735[2]);
                                    } else {
                                        phi_5241_ = _e1735[2];
                                    }
                                    let _e1753 = phi_5241_;
                                    if (_e1749 > _e1753) {
                                        phi_5246_ = _e1749;
                                    } else {
                                        phi_5246_ = _e1753;
                                    }
                                    let _e1756 = phi_5246_;
                                    if (_e1733 > _e1756) {
                                        phi_5251_ = _e1733;
                                    } else {
                                        phi_5251_ = _e1756;
                                    }
                                    let _e1759 = phi_5251_;
                                    let _e1762 = local_20.member_2[0u];
                                    let _e1767 = local_20.member_2[1u];
                                    let _e1777 = (_e1762[0] + ((_e1767[0] - _e1762[0]) * _e1440));
                                    let _e1778 = (_e1762[1] + ((_e1767[1] - _e1762[1]) * _e1440));
                                    let _e1779 = (_e1762[2] + ((_e1767[2] - _e1762[2]) * _e1440));
                                    let _e1781 = local_20.member_2[1u];
                                    let _e1786 = local_20.member_2[0u];
                                    let _e1790 = (_e1781[0] - _e1786[0]);
                                    let _e1791 = (_e1781[1] - _e1786[1]);
                                    let _e1792 = (_e1781[2] - _e1786[2]);
                                    if (_e1790 < 0.0lf) {
                                        phi_5310_ = -(_e1790);
                                    } else {
                                        phi_5310_ = _e1790;
                                    }
                                    let _e1796 = phi_5310_;
                                    if (_e1791 < 0.0lf) {
                                        phi_5316_ = -(_e1791);
                                    } else {
                                        phi_5316_ = _e1791;
                                    }
                                    let _e1800 = phi_5316_;
                                    if (_e1796 > _e1800) {
                                        phi_5321_ = _e1796;
                                    } else {
                                        phi_5321_ = _e1800;
                                    }
                                    let _e1803 = phi_5321_;
                                    if (_e1792 < 0.0lf) {
                                        phi_5327_ = -(_e1792);
                                    } else {
                                        phi_5327_ = _e1792;
                                    }
                                    let _e1807 = phi_5327_;
                                    if (_e1803 > _e1807) {
                                        phi_5332_ = _e1803;
                                    } else {
                                        phi_5332_ = _e1807;
                                    }
                                    let _e1810 = phi_5332_;
                                    let _e1818 = ((((_e1443 * _e1810) * f64(1.01f)) + ((_e1759 + _e1710) * (1.1102230246251565e-16lf * f64(8f)))) + _e1710);
                                    if (_e1777 < 0.0lf) {
                                        phi_5346_ = -(_e1777);
                                    } else {
                                        phi_5346_ = _e1777;
                                    }
                                    let _e1822 = phi_5346_;
                                    if (_e1778 < 0.0lf) {
                                        phi_5352_ = -(_e1778);
                                    } else {
                                        phi_5352_ = _e1778;
                                    }
                                    let _e1826 = phi_5352_;
                                    if (_e1822 > _e1826) {
                                        phi_5357_ = _e1822;
                                    } else {
                                        phi_5357_ = _e1826;
                                    }
                                    let _e1829 = phi_5357_;
                                    if (_e1779 < 0.0lf) {
                                        phi_5363_ = -(_e1779);
                                    } else {
                                        phi_5363_ = _e1779;
                                    }
                                    let _e1833 = phi_5363_;
                                    if (_e1829 > _e1833) {
                                        phi_5368_ = _e1829;
                                    } else {
                                        phi_5368_ = _e1833;
                                    }
                                    let _e1836 = phi_5368_;
                                    local_5 = type_51(array<f64, 3>(_e1777, _e1778, _e1779), _e1818, (_e1836 + _e1818));
                                    let _e1841 = local_4.member;
                                    let _e1846 = local_5.member;
                                    let _e1852 = ((_e1841[1] * _e1846[2]) - (_e1841[2] * _e1846[1]));
                                    let _e1855 = ((_e1841[2] * _e1846[0]) - (_e1841[0] * _e1846[2]));
                                    let _e1858 = ((_e1841[0] * _e1846[1]) - (_e1841[1] * _e1846[0]));
                                    if (_e1852 < 0.0lf) {
                                        phi_5417_ = -(_e1852);
                                    } else {
                                        phi_5417_ = _e1852;
                                    }
                                    let _e1862 = phi_5417_;
                                    if (_e1855 < 0.0lf) {
                                        phi_5423_ = -(_e1855);
                                    } else {
                                        phi_5423_ = _e1855;
                                    }
                                    let _e1866 = phi_5423_;
                                    if (_e1862 > _e1866) {
                                        if (_e1852 < 0.0lf) {
                                            phi_5433_ = -(_e1852);
                                        } else {
                                            phi_5433_ = _e1852;
                                        }
                                        let _e1884 = phi_5433_;
                                        if (_e1858 < 0.0lf) {
                                            phi_5439_ = -(_e1858);
                                        } else {
                                            phi_5439_ = _e1858;
                                        }
                                        let _e1888 = phi_5439_;
                                        if (_e1884 > _e1888) {
                                            phi_5444_ = 2u;
                                            phi_5445_ = 1u;
                                        } else {
                                            phi_5444_ = 1u;
                                            phi_5445_ = 0u;
                                        }
                                        let _e1891 = phi_5444_;
                                        let _e1893 = phi_5445_;
                                        phi_5464_ = _e1891;
                                        phi_5465_ = _e1893;
                                    } else {
                                        if (_e1855 < 0.0lf) {
                                            phi_5451_ = -(_e1855);
                                        } else {
                                            phi_5451_ = _e1855;
                                        }
                                        let _e1871 = phi_5451_;
                                        if (_e1858 < 0.0lf) {
                                            phi_5457_ = -(_e1858);
                                        } else {
                                            phi_5457_ = _e1858;
                                        }
                                        let _e1875 = phi_5457_;
                                        if (_e1871 > _e1875) {
                                            phi_5462_ = 0u;
                                            phi_5463_ = 2u;
                                        } else {
                                            phi_5462_ = 1u;
                                            phi_5463_ = 0u;
                                        }
                                        let _e1878 = phi_5462_;
                                        let _e1880 = phi_5463_;
                                        phi_5464_ = _e1878;
                                        phi_5465_ = _e1880;
                                    }
                                    let _e1895 = phi_5464_;
                                    let _e1897 = phi_5465_;
                                    if (_e1897 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1901 = local_4.member[_e1897];
                                    if (_e1895 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1905 = local_5.member[_e1895];
                                    if (_e1895 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1910 = local_4.member[_e1895];
                                    if (_e1897 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1914 = local_5.member[_e1897];
                                    let _e1916 = ((_e1901 * _e1905) - (_e1910 * _e1914));
                                    let _e1917 = f64(1f);
                                    let _e1919 = local_4.member_1;
                                    let _e1921 = local_5.member_2;
                                    let _e1924 = local_4.member_2;
                                    let _e1926 = local_5.member_1;
                                    let _e1932 = local_4.member_2;
                                    let _e1934 = local_5.member_2;
                                    let _e1943 = local_4.member_2;
                                    let _e1946 = local_5.member_2;
                                    let _e1950 = (((((_e1919 * _e1921) + (_e1924 * _e1926)) * f64(2.01f)) + ((_e1932 * _e1934) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1917 + _e1943) * (_e1917 + _e1946))));
                                    if (_e1916 < 0.0lf) {
                                        phi_5536_ = -(_e1916);
                                    } else {
                                        phi_5536_ = _e1916;
                                    }
                                    let _e1954 = phi_5536_;
                                    if (_e1954 > _e1950) {
                                        if (_e1916 < f64(0f)) {
                                            phi_5548_ = f64(-1f);
                                        } else {
                                            phi_5548_ = f64(1f);
                                        }
                                        let _e1961 = phi_5548_;
                                        if (_e1897 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1965 = local_3.member[_e1897];
                                        if (_e1895 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1969 = local_5.member[_e1895];
                                        if (_e1895 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1974 = local_3.member[_e1895];
                                        if (_e1897 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1978 = local_5.member[_e1897];
                                        let _e1981 = f64(1f);
                                        let _e1983 = local_3.member_1;
                                        let _e1985 = local_5.member_2;
                                        let _e1988 = local_3.member_2;
                                        let _e1990 = local_5.member_1;
                                        let _e1996 = local_3.member_2;
                                        let _e1998 = local_5.member_2;
                                        let _e2007 = local_3.member_2;
                                        let _e2010 = local_5.member_2;
                                        let _e2014 = (((((_e1983 * _e1985) + (_e1988 * _e1990)) * f64(2.01f)) + ((_e1996 * _e1998) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1981 + _e2007) * (_e1981 + _e2010))));
                                        if (_e1897 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2018 = local_4.member[_e1897];
                                        if (_e1895 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2022 = local_3.member[_e1895];
                                        if (_e1895 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2027 = local_4.member[_e1895];
                                        if (_e1897 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2031 = local_3.member[_e1897];
                                        let _e2034 = f64(1f);
                                        let _e2036 = local_4.member_1;
                                        let _e2038 = local_3.member_2;
                                        let _e2041 = local_4.member_2;
                                        let _e2043 = local_3.member_1;
                                        let _e2049 = local_4.member_2;
                                        let _e2051 = local_3.member_2;
                                        let _e2060 = local_4.member_2;
                                        let _e2063 = local_3.member_2;
                                        let _e2067 = (((((_e2036 * _e2038) + (_e2041 * _e2043)) * f64(2.01f)) + ((_e2049 * _e2051) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2034 + _e2060) * (_e2034 + _e2063))));
                                        let _e2068 = (_e1916 * _e1961);
                                        let _e2069 = (((_e1965 * _e1969) - (_e1974 * _e1978)) * _e1961);
                                        let _e2070 = (((_e2018 * _e2022) - (_e2027 * _e2031)) * _e1961);
                                        if (_e2068 < 0.0lf) {
                                            phi_5687_ = -(_e2068);
                                        } else {
                                            phi_5687_ = _e2068;
                                        }
                                        let _e2074 = phi_5687_;
                                        if (_e2069 < 0.0lf) {
                                            phi_5693_ = -(_e2069);
                                        } else {
                                            phi_5693_ = _e2069;
                                        }
                                        let _e2078 = phi_5693_;
                                        if (_e2070 < 0.0lf) {
                                            phi_5700_ = -(_e2070);
                                        } else {
                                            phi_5700_ = _e2070;
                                        }
                                        let _e2083 = phi_5700_;
                                        let _e2089 = ((_e2068 - _e2069) - _e2070);
                                        let _e2092 = (((_e1950 + _e2014) + _e2067) + (((_e2074 + _e2078) + _e2083) * (1.1102230246251565e-16lf * f64(4f))));
                                        local_6[0u].member = _e2069;
                                        local_6[0u].member_1 = _e2014;
                                        local_6[1u].member = _e2070;
                                        local_6[1u].member_1 = _e2067;
                                        local_6[2u].member = _e2089;
                                        local_6[2u].member_1 = _e2092;
                                        local_6[3u].member = _e2089;
                                        local_6[3u].member_1 = _e2092;
                                        phi_5744_ = type_29(0u, 4u);
                                        phi_5747_ = true;
                                        loop {
                                            let _e2107 = phi_5744_;
                                            let _e2109 = phi_5747_;
                                            local_25 = _e2109;
                                            if (_e2107.member < _e2107.member_1) {
                                                phi_5745_ = type_29((_e2107.member + 1u), _e2107.member_1);
                                                phi_5770_ = type_29(1u, _e2107.member);
                                            } else {
                                                phi_5745_ = _e2107;
                                                phi_5770_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e2123 = phi_5745_;
                                            let _e2125 = phi_5770_;
                                            if (bitcast<i32>(_e2125.member) != 0i) {
                                                if (_e2125.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e2133 = local_6[_e2125.member_1].member;
                                                let _e2136 = local_6[_e2125.member_1].member_1;
                                                let _e2138 = (_e2133 < -(_e2136));
                                                if _e2138 {
                                                    phi_5797_ = bool();
                                                    phi_5798_ = false;
                                                } else {
                                                    phi_5797_ = (_e2109 && (_e2133 > _e2136));
                                                    phi_5798_ = true;
                                                }
                                                let _e2142 = phi_5797_;
                                                let _e2144 = phi_5798_;
                                                phi_5748_ = _e2142;
                                                phi_5799_ = _e2144;
                                                phi_5800_ = _e2138;
                                            } else {
                                                phi_5748_ = bool();
                                                phi_5799_ = false;
                                                phi_5800_ = false;
                                            }
                                            let _e2146 = phi_5748_;
                                            let _e2148 = phi_5799_;
                                            let _e2150 = phi_5800_;
                                            local_24 = _e2150;
                                            continue;
                                            continuing {
                                                phi_5744_ = _e2123;
                                                phi_5747_ = _e2146;
                                                break if !(_e2148);
                                            }
                                        }
                                        let _e2153 = local_24;
                                        if _e2153 {
                                            phi_5804_ = false;
                                        } else {
                                            phi_5804_ = true;
                                        }
                                        let _e2155 = phi_5804_;
                                        if _e2155 {
                                            let _e2157 = local_25;
                                            if _e2157 {
                                                phi_5811_ = 1u;
                                            } else {
                                                phi_5811_ = 2u;
                                            }
                                            let _e2159 = phi_5811_;
                                            phi_5812_ = _e2159;
                                            phi_5813_ = false;
                                        } else {
                                            phi_5812_ = u32();
                                            phi_5813_ = true;
                                        }
                                        let _e2161 = phi_5812_;
                                        let _e2163 = phi_5813_;
                                        phi_5814_ = _e2161;
                                        phi_5815_ = 0u;
                                        phi_5816_ = _e2163;
                                    } else {
                                        phi_5814_ = u32();
                                        phi_5815_ = 2u;
                                        phi_5816_ = true;
                                    }
                                    let _e2165 = phi_5814_;
                                    let _e2167 = phi_5815_;
                                    let _e2169 = phi_5816_;
                                    if _e2169 {
                                        phi_5820_ = _e2167;
                                    } else {
                                        phi_5820_ = _e2165;
                                    }
                                    let _e2171 = phi_5820_;
                                    let _e2172 = (_e2171 == 0u);
                                    if _e2172 {
                                        phi_7340_ = f64();
                                        phi_7341_ = false;
                                        phi_7342_ = false;
                                        phi_7343_ = false;
                                    } else {
                                        if (_e2171 == 1u) {
                                            if _e1431.member_2 {
                                                if ((_e1431.member_1 - _e1431.member) <= f64(0.0000005f)) {
                                                    phi_5841_ = false;
                                                } else {
                                                    phi_5841_ = true;
                                                }
                                                let _e2181 = phi_5841_;
                                                phi_5842_ = _e2181;
                                            } else {
                                                phi_5842_ = true;
                                            }
                                            let _e2183 = phi_5842_;
                                            phi_5843_ = _e2183;
                                        } else {
                                            phi_5843_ = true;
                                        }
                                        let _e2185 = phi_5843_;
                                        if _e2185 {
                                            let _e2191 = local_20.member[0u];
                                            let _e2197 = local_20.member_1[0u];
                                            let _e2203 = local_20.member_2[0u];
                                            local_1 = array<array<f64, 3>, 4>(_e2191, array<f64, 3>((_e2191[0] - _e2197[0]), (_e2191[1] - _e2197[1]), (_e2191[2] - _e2197[2])), array<f64, 3>((_e2191[0] - _e2203[0]), (_e2191[1] - _e2203[1]), (_e2191[2] - _e2203[2])), _e2191);
                                            let _e2218 = local_20.member[1u];
                                            let _e2224 = local_20.member_1[1u];
                                            let _e2230 = local_20.member_2[1u];
                                            local_2 = array<array<f64, 3>, 4>(_e2218, array<f64, 3>((_e2218[0] - _e2224[0]), (_e2218[1] - _e2224[1]), (_e2218[2] - _e2224[2])), array<f64, 3>((_e2218[0] - _e2230[0]), (_e2218[1] - _e2230[1]), (_e2218[2] - _e2230[2])), _e2218);
                                            let _e2245 = local_20.member[0u];
                                            if (_e2245[0] < 0.0lf) {
                                                phi_6040_ = -(_e2245[0]);
                                            } else {
                                                phi_6040_ = _e2245[0];
                                            }
                                            let _e2252 = phi_6040_;
                                            if (_e2245[1] < 0.0lf) {
                                                phi_6047_ = -(_e2245[1]);
                                            } else {
                                                phi_6047_ = _e2245[1];
                                            }
                                            let _e2256 = phi_6047_;
                                            if (_e2252 > _e2256) {
                                                phi_6052_ = _e2252;
                                            } else {
                                                phi_6052_ = _e2256;
                                            }
                                            let _e2259 = phi_6052_;
                                            if (_e2245[2] < 0.0lf) {
                                                phi_6059_ = -(_e2245[2]);
                                            } else {
                                                phi_6059_ = _e2245[2];
                                            }
                                            let _e2263 = phi_6059_;
                                            if (_e2259 > _e2263) {
                                                phi_6064_ = _e2259;
                                            } else {
                                                phi_6064_ = _e2263;
                                            }
                                            let _e2266 = phi_6064_;
                                            let _e2269 = local_20.member[1u];
                                            if (_e2269[0] < 0.0lf) {
                                                phi_6077_ = -(_e2269[0]);
                                            } else {
                                                phi_6077_ = _e2269[0];
                                            }
                                            let _e2276 = phi_6077_;
                                            if (_e2269[1] < 0.0lf) {
                                                phi_6084_ = -(_e2269[1]);
                                            } else {
                                                phi_6084_ = _e2269[1];
                                            }
                                            let _e2280 = phi_6084_;
                                            if (_e2276 > _e2280) {
                                                phi_6089_ = _e2276;
                                            } else {
                                                phi_6089_ = _e2280;
                                            }
                                            let _e2283 = phi_6089_;
                                            if (_e2269[2] < 0.0lf) {
                                                phi_6096_ = -(_e2269[2]);
                                            } else {
                                                phi_6096_ = _e2269[2];
                                            }
                                            let _e2287 = phi_6096_;
                                            if (_e2283 > _e2287) {
                                                phi_6101_ = _e2283;
                                            } else {
                                                phi_6101_ = _e2287;
                                            }
                                            let _e2290 = phi_6101_;
                                            if (_e2266 > _e2290) {
                                                phi_6106_ = _e2266;
                                            } else {
                                                phi_6106_ = _e2290;
                                            }
                                            let _e2293 = phi_6106_;
                                            let _e2295 = local_20.member_3;
                                            let _e2299 = local_20.member_1[0u];
                                            if (_e2299[0] < 0.0lf) {
                                                phi_6123_ = -(_e2299[0]);
                                            } else {
                                                phi_6123_ = _e2299[0];
                                            }
                                            let _e2306 = phi_6123_;
                                            if (_e2299[1] < 0.0lf) {
                                                phi_6130_ = -(_e2299[1]);
                                            } else {
                                                phi_6130_ = _e2299[1];
                                            }
                                            let _e2310 = phi_6130_;
                                            if (_e2306 > _e2310) {
                                                phi_6135_ = _e2306;
                                            } else {
                                                phi_6135_ = _e2310;
                                            }
                                            let _e2313 = phi_6135_;
                                            if (_e2299[2] < 0.0lf) {
                                                phi_6142_ = -(_e2299[2]);
                                            } else {
                                                phi_6142_ = _e2299[2];
                                            }
                                            let _e2317 = phi_6142_;
                                            if (_e2313 > _e2317) {
                                                phi_6147_ = _e2313;
                                            } else {
                                                phi_6147_ = _e2317;
                                            }
                                            let _e2320 = phi_6147_;
                                            let _e2323 = local_20.member_1[1u];
                                            if (_e2323[0] < 0.0lf) {
                                                phi_6161_ = -(_e2323[0]);
                                            } else {
                                                phi_6161_ = _e2323[0];
                                            }
                                            let _e2330 = phi_6161_;
                                            if (_e2323[1] < 0.0lf) {
                                                phi_6168_ = -(_e2323[1]);
                                            } else {
                                                phi_6168_ = _e2323[1];
                                            }
                                            let _e2334 = phi_6168_;
                                            if (_e2330 > _e2334) {
                                                phi_6173_ = _e2330;
                                            } else {
                                                phi_6173_ = _e2334;
                                            }
                                            let _e2337 = phi_6173_;
                                            if (_e2323[2] < 0.0lf) {
                                                phi_6180_ = -(_e2323[2]);
                                            } else {
                                                phi_6180_ = _e2323[2];
                                            }
                                            let _e2341 = phi_6180_;
                                            if (_e2337 > _e2341) {
                                                phi_6185_ = _e2337;
                                            } else {
                                                phi_6185_ = _e2341;
                                            }
                                            let _e2344 = phi_6185_;
                                            if (_e2320 > _e2344) {
                                                phi_6190_ = _e2320;
                                            } else {
                                                phi_6190_ = _e2344;
                                            }
                                            let _e2347 = phi_6190_;
                                            let _e2349 = local_20.member_3;
                                            let _e2353 = local_20.member_2[0u];
                                            if (_e2353[0] < 0.0lf) {
                                                phi_6207_ = -(_e2353[0]);
                                            } else {
                                                phi_6207_ = _e2353[0];
                                            }
                                            let _e2360 = phi_6207_;
                                            if (_e2353[1] < 0.0lf) {
                                                phi_6214_ = -(_e2353[1]);
                                            } else {
                                                phi_6214_ = _e2353[1];
                                            }
                                            let _e2364 = phi_6214_;
                                            if (_e2360 > _e2364) {
                                                phi_6219_ = _e2360;
                                            } else {
                                                phi_6219_ = _e2364;
                                            }
                                            let _e2367 = phi_6219_;
                                            if (_e2353[2] < 0.0lf) {
                                                phi_6226_ = -(_e2353[2]);
                                            } else {
                                                phi_6226_ = _e2353[2];
                                            }
                                            let _e2371 = phi_6226_;
                                            if (_e2367 > _e2371) {
                                                phi_6231_ = _e2367;
                                            } else {
                                                phi_6231_ = _e2371;
                                            }
                                            let _e2374 = phi_6231_;
                                            let _e2377 = local_20.member_2[1u];
                                            if (_e2377[0] < 0.0lf) {
                                                phi_6245_ = -(_e2377[0]);
                                            } else {
                                                phi_6245_ = _e2377[0];
                                            }
                                            let _e2384 = phi_6245_;
                                            if (_e2377[1] < 0.0lf) {
                                                phi_6252_ = -(_e2377[1]);
                                            } else {
                                                phi_6252_ = _e2377[1];
                                            }
                                            let _e2388 = phi_6252_;
                                            if (_e2384 > _e2388) {
                                                phi_6257_ = _e2384;
                                            } else {
                                                phi_6257_ = _e2388;
                                            }
                                            let _e2391 = phi_6257_;
                                            if (_e2377[2] < 0.0lf) {
                                                phi_6264_ = -(_e2377[2]);
                                            } else {
                                                phi_6264_ = _e2377[2];
                                            }
                                            let _e2395 = phi_6264_;
                                            if (_e2391 > _e2395) {
                                                phi_6269_ = _e2391;
                                            } else {
                                                phi_6269_ = _e2395;
                                            }
                                            let _e2398 = phi_6269_;
                                            if (_e2374 > _e2398) {
                                                phi_6274_ = _e2374;
                                            } else {
                                                phi_6274_ = _e2398;
                                            }
                                            let _e2401 = phi_6274_;
                                            let _e2403 = local_20.member_3;
                                            let _e2411 = local_20.member_3;
                                            phi_6294_ = type_29(0u, 48u);
                                            phi_6297_ = _e1431.member;
                                            loop {
                                                let _e2420 = phi_6294_;
                                                let _e2422 = phi_6297_;
                                                local_65 = _e2422;
                                                local_32 = _e2422;
                                                local_33 = _e2422;
                                                local_34 = _e2422;
                                                if (_e2420.member < _e2420.member_1) {
                                                    phi_6295_ = type_29((_e2420.member + 1u), _e2420.member_1);
                                                    phi_6320_ = type_29(1u, _e2420.member);
                                                } else {
                                                    phi_6295_ = _e2420;
                                                    phi_6320_ = type_29(0u, type_29().member_1);
                                                }
                                                let _e2436 = phi_6295_;
                                                let _e2438 = phi_6320_;
                                                if (bitcast<i32>(_e2438.member) != 0i) {
                                                    let _e2444 = local_20.member[0u];
                                                    let _e2450 = local_20.member[1u];
                                                    let _e2460 = (_e2444[0] + ((_e2450[0] - _e2444[0]) * _e2422));
                                                    let _e2461 = (_e2444[1] + ((_e2450[1] - _e2444[1]) * _e2422));
                                                    let _e2462 = (_e2444[2] + ((_e2450[2] - _e2444[2]) * _e2422));
                                                    let _e2465 = local_20.member_1[0u];
                                                    let _e2471 = local_20.member_1[1u];
                                                    let _e2481 = (_e2465[0] + ((_e2471[0] - _e2465[0]) * _e2422));
                                                    let _e2482 = (_e2465[1] + ((_e2471[1] - _e2465[1]) * _e2422));
                                                    let _e2483 = (_e2465[2] + ((_e2471[2] - _e2465[2]) * _e2422));
                                                    let _e2486 = local_20.member_2[0u];
                                                    let _e2492 = local_20.member_2[1u];
                                                    let _e2502 = (_e2486[0] + ((_e2492[0] - _e2486[0]) * _e2422));
                                                    let _e2503 = (_e2486[1] + ((_e2492[1] - _e2486[1]) * _e2422));
                                                    let _e2504 = (_e2486[2] + ((_e2492[2] - _e2486[2]) * _e2422));
                                                    let _e2509 = (((_e2481 * _e2481) + (_e2482 * _e2482)) + (_e2483 * _e2483));
                                                    let _e2514 = (((_e2481 * _e2502) + (_e2482 * _e2503)) + (_e2483 * _e2504));
                                                    let _e2519 = (((_e2502 * _e2502) + (_e2503 * _e2503)) + (_e2504 * _e2504));
                                                    let _e2524 = (((_e2460 * _e2481) + (_e2461 * _e2482)) + (_e2462 * _e2483));
                                                    let _e2529 = (((_e2460 * _e2502) + (_e2461 * _e2503)) + (_e2462 * _e2504));
                                                    let _e2532 = ((_e2509 * _e2519) - (_e2514 * _e2514));
                                                    let _e2533 = f64(0f);
                                                    let _e2538 = (((_e2524 * _e2519) - (_e2529 * _e2514)) / _e2532);
                                                    let _e2542 = (((_e2529 * _e2509) - (_e2524 * _e2514)) / _e2532);
                                                    if (_e2538 >= _e2533) {
                                                        if (_e2542 >= _e2533) {
                                                            phi_6495_ = ((_e2538 + _e2542) <= f64(1f));
                                                            phi_6496_ = false;
                                                        } else {
                                                            phi_6495_ = bool();
                                                            phi_6496_ = true;
                                                        }
                                                        let _e2548 = phi_6495_;
                                                        let _e2550 = phi_6496_;
                                                        phi_6497_ = _e2548;
                                                        phi_6498_ = _e2550;
                                                    } else {
                                                        phi_6497_ = bool();
                                                        phi_6498_ = true;
                                                    }
                                                    let _e2552 = phi_6497_;
                                                    let _e2554 = phi_6498_;
                                                    if _e2554 {
                                                        let _e2555 = (_e2532 > _e2533);
                                                        if _e2555 {
                                                            phi_6511_ = false;
                                                        } else {
                                                            phi_6511_ = true;
                                                        }
                                                        let _e2557 = phi_6511_;
                                                        phi_6512_ = false;
                                                        phi_6513_ = _e2557;
                                                        phi_6514_ = _e2555;
                                                    } else {
                                                        phi_6512_ = true;
                                                        phi_6513_ = false;
                                                        phi_6514_ = false;
                                                    }
                                                    let _e2559 = phi_6512_;
                                                    let _e2561 = phi_6513_;
                                                    let _e2563 = phi_6514_;
                                                    if _e2559 {
                                                        if (_e2532 > _e2533) {
                                                            if _e2552 {
                                                                phi_6538_ = array<f64, 3>((_e2460 - ((_e2481 * _e2538) + (_e2502 * _e2542))), (_e2461 - ((_e2482 * _e2538) + (_e2503 * _e2542))), (_e2462 - ((_e2483 * _e2538) + (_e2504 * _e2542))));
                                                                phi_6539_ = false;
                                                            } else {
                                                                phi_6538_ = array<f64, 3>();
                                                                phi_6539_ = true;
                                                            }
                                                            let _e2579 = phi_6538_;
                                                            let _e2581 = phi_6539_;
                                                            phi_6540_ = _e2579;
                                                            phi_6541_ = false;
                                                            phi_6542_ = _e2581;
                                                        } else {
                                                            phi_6540_ = array<f64, 3>();
                                                            phi_6541_ = true;
                                                            phi_6542_ = false;
                                                        }
                                                        let _e2583 = phi_6540_;
                                                        let _e2585 = phi_6541_;
                                                        let _e2587 = phi_6542_;
                                                        phi_6543_ = _e2583;
                                                        phi_6544_ = _e2585;
                                                        phi_6545_ = _e2587;
                                                    } else {
                                                        phi_6543_ = array<f64, 3>();
                                                        phi_6544_ = _e2561;
                                                        phi_6545_ = _e2563;
                                                    }
                                                    let _e2589 = phi_6543_;
                                                    let _e2591 = phi_6544_;
                                                    let _e2593 = phi_6545_;
                                                    if _e2591 {
                                                        phi_6549_ = true;
                                                    } else {
                                                        phi_6549_ = _e2593;
                                                    }
                                                    let _e2595 = phi_6549_;
                                                    if _e2595 {
                                                        let _e2596 = (_e2460 - _e2481);
                                                        let _e2597 = (_e2461 - _e2482);
                                                        let _e2598 = (_e2462 - _e2483);
                                                        let _e2599 = (_e2502 - _e2481);
                                                        let _e2600 = (_e2503 - _e2482);
                                                        let _e2601 = (_e2504 - _e2483);
                                                        let _e2612 = ((((_e2596 * _e2599) + (_e2597 * _e2600)) + (_e2598 * _e2601)) / (((_e2599 * _e2599) + (_e2600 * _e2600)) + (_e2601 * _e2601)));
                                                        if (_e2612 > f64(0f)) {
                                                            if (_e2612 < f64(1f)) {
                                                                phi_6736_ = _e2612;
                                                            } else {
                                                                phi_6736_ = f64(1f);
                                                            }
                                                            let _e2620 = phi_6736_;
                                                            phi_6738_ = _e2620;
                                                        } else {
                                                            phi_6738_ = f64(0f);
                                                        }
                                                        let _e2622 = phi_6738_;
                                                        let _e2626 = (_e2596 - (_e2599 * _e2622));
                                                        let _e2627 = (_e2597 - (_e2600 * _e2622));
                                                        let _e2628 = (_e2598 - (_e2601 * _e2622));
                                                        let _e2639 = ((((_e2460 * _e2481) + (_e2461 * _e2482)) + (_e2462 * _e2483)) / (((_e2481 * _e2481) + (_e2482 * _e2482)) + (_e2483 * _e2483)));
                                                        if (_e2639 > f64(0f)) {
                                                            if (_e2639 < f64(1f)) {
                                                                phi_6768_ = _e2639;
                                                            } else {
                                                                phi_6768_ = f64(1f);
                                                            }
                                                            let _e2647 = phi_6768_;
                                                            phi_6770_ = _e2647;
                                                        } else {
                                                            phi_6770_ = f64(0f);
                                                        }
                                                        let _e2649 = phi_6770_;
                                                        let _e2666 = ((((_e2460 * _e2502) + (_e2461 * _e2503)) + (_e2462 * _e2504)) / (((_e2502 * _e2502) + (_e2503 * _e2503)) + (_e2504 * _e2504)));
                                                        if (_e2666 > f64(0f)) {
                                                            if (_e2666 < f64(1f)) {
                                                                phi_6800_ = _e2666;
                                                            } else {
                                                                phi_6800_ = f64(1f);
                                                            }
                                                            let _e2674 = phi_6800_;
                                                            phi_6802_ = _e2674;
                                                        } else {
                                                            phi_6802_ = f64(0f);
                                                        }
                                                        let _e2676 = phi_6802_;
                                                        local[0u] = array<f64, 3>((_e2460 - (_e2481 * _e2649)), (_e2461 - (_e2482 * _e2649)), (_e2462 - (_e2483 * _e2649)));
                                                        local[1u] = array<f64, 3>((_e2460 - (_e2502 * _e2676)), (_e2461 - (_e2503 * _e2676)), (_e2462 - (_e2504 * _e2676)));
                                                        local[2u] = array<f64, 3>(_e2626, _e2627, _e2628);
                                                        local[3u] = array<f64, 3>(_e2626, _e2627, _e2628);
                                                        let _e2692 = local[0u];
                                                        phi_6838_ = type_29(1u, 4u);
                                                        phi_6841_ = array<f64, 3>(_e2692[0], _e2692[1], _e2692[2]);
                                                        loop {
                                                            let _e2698 = phi_6838_;
                                                            let _e2700 = phi_6841_;
                                                            local_55 = _e2700;
                                                            if (_e2698.member < _e2698.member_1) {
                                                                phi_6839_ = type_29((_e2698.member + 1u), _e2698.member_1);
                                                                phi_6864_ = type_29(1u, _e2698.member);
                                                            } else {
                                                                phi_6839_ = _e2698;
                                                                phi_6864_ = type_29(0u, type_29().member_1);
                                                            }
                                                            let _e2714 = phi_6839_;
                                                            let _e2716 = phi_6864_;
                                                            let _e2720 = (bitcast<i32>(_e2716.member) != 0i);
                                                            if _e2720 {
                                                                if (_e2716.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2723 = local[_e2716.member_1];
                                                                if (_e2716.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2729 = local[_e2716.member_1];
                                                                if ((((_e2723[0] * _e2729[0]) + (_e2723[1] * _e2729[1])) + (_e2723[2] * _e2729[2])) < (((_e2700[0] * _e2700[0]) + (_e2700[1] * _e2700[1])) + (_e2700[2] * _e2700[2]))) {
                                                                    if (_e2716.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2752 = local[_e2716.member_1];
                                                                    phi_6931_ = array<f64, 3>(_e2752[0], _e2752[1], _e2752[2]);
                                                                } else {
                                                                    phi_6931_ = _e2700;
                                                                }
                                                                let _e2758 = phi_6931_;
                                                                phi_6842_ = _e2758;
                                                            } else {
                                                                phi_6842_ = array<f64, 3>();
                                                            }
                                                            let _e2760 = phi_6842_;
                                                            continue;
                                                            continuing {
                                                                phi_6838_ = _e2714;
                                                                phi_6841_ = _e2760;
                                                                break if !(_e2720);
                                                            }
                                                        }
                                                        let _e5266 = local_55;
                                                        phi_6932_ = _e5266;
                                                    } else {
                                                        phi_6932_ = _e2589;
                                                    }
                                                    let _e2763 = phi_6932_;
                                                    if (_e2763[0] < 0.0lf) {
                                                        phi_6939_ = -(_e2763[0]);
                                                    } else {
                                                        phi_6939_ = _e2763[0];
                                                    }
                                                    let _e2768 = phi_6939_;
                                                    if (_e2763[1] < 0.0lf) {
                                                        phi_6946_ = -(_e2763[1]);
                                                    } else {
                                                        phi_6946_ = _e2763[1];
                                                    }
                                                    let _e2773 = phi_6946_;
                                                    if (_e2763[2] < 0.0lf) {
                                                        phi_6954_ = -(_e2763[2]);
                                                    } else {
                                                        phi_6954_ = _e2763[2];
                                                    }
                                                    let _e2779 = phi_6954_;
                                                    let _e2780 = ((_e2768 + _e2773) + _e2779);
                                                    if (_e2780 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2780) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2786 = (f64(1f) / _e2780);
                                                            let _e2788 = (_e2763[0] * _e2786);
                                                            let _e2790 = (_e2763[1] * _e2786);
                                                            let _e2792 = (_e2763[2] * _e2786);
                                                            let _e2797 = (((_e2788 * _e2788) + (_e2790 * _e2790)) + (_e2792 * _e2792));
                                                            if (_e2797 <= 2.2250738585072014e-308lf) {
                                                                if (_e2797 > 0.0lf) {
                                                                    phi_6992_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_6992_ = 0.0lf;
                                                                }
                                                                let _e2855 = phi_6992_;
                                                                phi_7056_ = _e2855;
                                                            } else {
                                                                phi_6999_ = type_27(0i, 5i);
                                                                phi_7002_ = bitcast<f64>(((bitcast<u64>(_e2797) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2804 = phi_6999_;
                                                                    let _e2806 = phi_7002_;
                                                                    local_26 = _e2806;
                                                                    if (_e2804.member < _e2804.member_1) {
                                                                        let _e2814 = (_e2804.member + 1i);
                                                                        if ((false == (_e2814 > _e2804.member)) != false) {
                                                                            phi_7023_ = true;
                                                                        } else {
                                                                            phi_7023_ = false;
                                                                        }
                                                                        let _e2819 = phi_7023_;
                                                                        if _e2819 {
                                                                            phi_7029_ = type_28(0u, type_28().member_1);
                                                                        } else {
                                                                            phi_7029_ = type_28(1u, _e2814);
                                                                        }
                                                                        let _e2825 = phi_7029_;
                                                                        if (bitcast<i32>(_e2825.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_7000_ = type_27(_e2825.member_1, _e2804.member_1);
                                                                        phi_7043_ = type_28(1u, _e2804.member);
                                                                    } else {
                                                                        phi_7000_ = _e2804;
                                                                        phi_7043_ = type_28(0u, type_28().member_1);
                                                                    }
                                                                    let _e2835 = phi_7000_;
                                                                    let _e2837 = phi_7043_;
                                                                    let _e2840 = (bitcast<i32>(_e2837.member) != 0i);
                                                                    if _e2840 {
                                                                        phi_7003_ = (0.5lf * (_e2806 + (_e2797 / _e2806)));
                                                                    } else {
                                                                        phi_7003_ = f64();
                                                                    }
                                                                    let _e2845 = phi_7003_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6999_ = _e2835;
                                                                        phi_7002_ = _e2845;
                                                                        break if !(_e2840);
                                                                    }
                                                                }
                                                                let _e2850 = local_26;
                                                                phi_7056_ = (_e2850 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2857 = phi_7056_;
                                                            phi_7069_ = type_29(0u, 4u);
                                                            phi_7072_ = f64(2f);
                                                            loop {
                                                                let _e2869 = phi_7069_;
                                                                let _e2871 = phi_7072_;
                                                                local_28 = _e2871;
                                                                local_29 = _e2871;
                                                                local_30 = _e2871;
                                                                local_56 = _e2871;
                                                                local_57 = _e2871;
                                                                if (_e2869.member < _e2869.member_1) {
                                                                    phi_7070_ = type_29((_e2869.member + 1u), _e2869.member_1);
                                                                    phi_7095_ = type_29(1u, _e2869.member);
                                                                } else {
                                                                    phi_7070_ = _e2869;
                                                                    phi_7095_ = type_29(0u, type_29().member_1);
                                                                }
                                                                let _e2885 = phi_7070_;
                                                                let _e2887 = phi_7095_;
                                                                if (bitcast<i32>(_e2887.member) != 0i) {
                                                                    if (_e2887.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2894 = local_1[_e2887.member_1];
                                                                    let _e2902 = (((_e2788 * _e2894[0]) + (_e2790 * _e2894[1])) + (_e2792 * _e2894[2]));
                                                                    if (_e2887.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2905 = local_2[_e2887.member_1];
                                                                    let _e2913 = (((_e2788 * _e2905[0]) + (_e2790 * _e2905[1])) + (_e2792 * _e2905[2]));
                                                                    if (_e2902 < 0.0lf) {
                                                                        phi_7146_ = -(_e2902);
                                                                    } else {
                                                                        phi_7146_ = _e2902;
                                                                    }
                                                                    let _e2917 = phi_7146_;
                                                                    if (_e2913 < 0.0lf) {
                                                                        phi_7152_ = -(_e2913);
                                                                    } else {
                                                                        phi_7152_ = _e2913;
                                                                    }
                                                                    let _e2921 = phi_7152_;
                                                                    let _e2926 = (((((((((_e2293 + _e2295) + (_e2347 + _e2349)) + (_e2401 + _e2403)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2411 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2857) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2917 + _e2921) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2902 > _e2926) {
                                                                        if (_e2913 > _e2926) {
                                                                            phi_7166_ = false;
                                                                        } else {
                                                                            phi_7166_ = true;
                                                                        }
                                                                        let _e2930 = phi_7166_;
                                                                        phi_7167_ = _e2930;
                                                                    } else {
                                                                        phi_7167_ = true;
                                                                    }
                                                                    let _e2932 = phi_7167_;
                                                                    if _e2932 {
                                                                        let _e2936 = ((_e2902 + ((_e2913 - _e2902) * _e2422)) > _e2926);
                                                                        if _e2936 {
                                                                            if (_e2913 < _e2902) {
                                                                                let _e2945 = (((_e2902 - _e2926) / (_e2902 - _e2913)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                if (_e2871 < _e2945) {
                                                                                    phi_7194_ = _e2871;
                                                                                } else {
                                                                                    phi_7194_ = _e2945;
                                                                                }
                                                                                let _e2948 = phi_7194_;
                                                                                phi_7195_ = _e2948;
                                                                            } else {
                                                                                phi_7195_ = _e2871;
                                                                            }
                                                                            let _e2950 = phi_7195_;
                                                                            phi_7196_ = _e2950;
                                                                        } else {
                                                                            phi_7196_ = f64();
                                                                        }
                                                                        let _e2952 = phi_7196_;
                                                                        phi_7197_ = _e2952;
                                                                        phi_7198_ = _e2936;
                                                                    } else {
                                                                        phi_7197_ = _e2871;
                                                                        phi_7198_ = true;
                                                                    }
                                                                    let _e2954 = phi_7197_;
                                                                    let _e2956 = phi_7198_;
                                                                    phi_7073_ = _e2954;
                                                                    phi_7199_ = _e2956;
                                                                    phi_7200_ = false;
                                                                } else {
                                                                    phi_7073_ = f64();
                                                                    phi_7199_ = false;
                                                                    phi_7200_ = true;
                                                                }
                                                                let _e2958 = phi_7073_;
                                                                let _e2960 = phi_7199_;
                                                                let _e2962 = phi_7200_;
                                                                local_27 = _e2962;
                                                                continue;
                                                                continuing {
                                                                    phi_7069_ = _e2885;
                                                                    phi_7072_ = _e2958;
                                                                    break if !(_e2960);
                                                                }
                                                            }
                                                            let _e2965 = local_27;
                                                            if _e2965 {
                                                                let _e2967 = local_28;
                                                                let _e2968 = (_e2967 > _e1431.member_1);
                                                                if _e2968 {
                                                                    phi_7222_ = false;
                                                                    phi_7223_ = false;
                                                                    phi_7224_ = false;
                                                                } else {
                                                                    let _e2970 = local_29;
                                                                    if (_e2970 > _e2422) {
                                                                        let _e2973 = local_30;
                                                                        let _e2976 = ((_e2973 - _e2422) < f64(0.00000000023283064f));
                                                                        if _e2976 {
                                                                            phi_7218_ = false;
                                                                        } else {
                                                                            phi_7218_ = true;
                                                                        }
                                                                        let _e2978 = phi_7218_;
                                                                        phi_7219_ = _e2978;
                                                                        phi_7220_ = _e2976;
                                                                        phi_7221_ = false;
                                                                    } else {
                                                                        phi_7219_ = false;
                                                                        phi_7220_ = false;
                                                                        phi_7221_ = true;
                                                                    }
                                                                    let _e2980 = phi_7219_;
                                                                    let _e2982 = phi_7220_;
                                                                    let _e2984 = phi_7221_;
                                                                    phi_7222_ = _e2980;
                                                                    phi_7223_ = _e2982;
                                                                    phi_7224_ = _e2984;
                                                                }
                                                                let _e2986 = phi_7222_;
                                                                let _e2988 = phi_7223_;
                                                                let _e2990 = phi_7224_;
                                                                phi_7225_ = _e2986;
                                                                phi_7226_ = _e2968;
                                                                phi_7227_ = _e2988;
                                                                phi_7228_ = _e2990;
                                                                phi_7229_ = false;
                                                            } else {
                                                                phi_7225_ = false;
                                                                phi_7226_ = false;
                                                                phi_7227_ = false;
                                                                phi_7228_ = false;
                                                                phi_7229_ = true;
                                                            }
                                                            let _e2992 = phi_7225_;
                                                            let _e2994 = phi_7226_;
                                                            let _e2996 = phi_7227_;
                                                            let _e2998 = phi_7228_;
                                                            let _e3000 = phi_7229_;
                                                            let _e5314 = local_56;
                                                            phi_7230_ = _e5314;
                                                            let _e5317 = local_57;
                                                            phi_7231_ = _e5317;
                                                            phi_7232_ = _e2992;
                                                            phi_7233_ = _e2994;
                                                            phi_7234_ = _e2996;
                                                            phi_7235_ = _e2998;
                                                            phi_7236_ = _e3000;
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
                                                        let _e3002 = phi_7230_;
                                                        let _e3004 = phi_7231_;
                                                        let _e3006 = phi_7232_;
                                                        let _e3008 = phi_7233_;
                                                        let _e3010 = phi_7234_;
                                                        let _e3012 = phi_7235_;
                                                        let _e3014 = phi_7236_;
                                                        let _e3016 = phi_7237_;
                                                        phi_7238_ = _e3002;
                                                        phi_7239_ = _e3004;
                                                        phi_7240_ = _e3006;
                                                        phi_7241_ = _e3008;
                                                        phi_7242_ = _e3010;
                                                        phi_7243_ = _e3012;
                                                        phi_7244_ = _e3014;
                                                        phi_7245_ = _e3016;
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
                                                    let _e3018 = phi_7238_;
                                                    let _e3020 = phi_7239_;
                                                    let _e3022 = phi_7240_;
                                                    let _e3024 = phi_7241_;
                                                    let _e3026 = phi_7242_;
                                                    let _e3028 = phi_7243_;
                                                    let _e3030 = phi_7244_;
                                                    let _e3032 = phi_7245_;
                                                    let _e3034 = phi_7246_;
                                                    phi_7247_ = _e3018;
                                                    phi_6298_ = _e3020;
                                                    phi_7248_ = _e3022;
                                                    phi_7249_ = _e3024;
                                                    phi_7250_ = _e3026;
                                                    phi_7251_ = false;
                                                    phi_7252_ = _e3028;
                                                    phi_7253_ = _e3030;
                                                    phi_7254_ = _e3032;
                                                    phi_7255_ = _e3034;
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
                                                let _e3036 = phi_7247_;
                                                let _e3038 = phi_6298_;
                                                let _e3040 = phi_7248_;
                                                let _e3042 = phi_7249_;
                                                let _e3044 = phi_7250_;
                                                let _e3046 = phi_7251_;
                                                let _e3048 = phi_7252_;
                                                let _e3050 = phi_7253_;
                                                let _e3052 = phi_7254_;
                                                let _e3054 = phi_7255_;
                                                local_31 = _e3042;
                                                local_58 = _e3044;
                                                local_59 = _e3046;
                                                local_60 = _e3048;
                                                local_61 = _e3050;
                                                local_62 = _e3052;
                                                local_63 = _e3054;
                                                local_64 = _e3036;
                                                local_66 = _e3042;
                                                continue;
                                                continuing {
                                                    phi_6294_ = _e2436;
                                                    phi_6297_ = _e3038;
                                                    break if !(_e3040);
                                                }
                                            }
                                            let _e3057 = local_31;
                                            if _e3057 {
                                                phi_7260_ = type_72(0u, type_72().member_1);
                                                phi_7261_ = false;
                                                phi_7262_ = false;
                                                phi_7263_ = false;
                                                phi_7264_ = false;
                                                phi_7265_ = false;
                                                phi_7266_ = false;
                                            } else {
                                                phi_7260_ = type_72();
                                                let _e5347 = local_58;
                                                phi_7261_ = _e5347;
                                                let _e5350 = local_59;
                                                phi_7262_ = _e5350;
                                                let _e5353 = local_60;
                                                phi_7263_ = _e5353;
                                                let _e5356 = local_61;
                                                phi_7264_ = _e5356;
                                                let _e5359 = local_62;
                                                phi_7265_ = _e5359;
                                                let _e5362 = local_63;
                                                phi_7266_ = _e5362;
                                            }
                                            let _e3062 = phi_7260_;
                                            let _e3064 = phi_7261_;
                                            let _e3066 = phi_7262_;
                                            let _e3068 = phi_7263_;
                                            let _e3070 = phi_7264_;
                                            let _e3072 = phi_7265_;
                                            let _e3074 = phi_7266_;
                                            if _e3064 {
                                                let _e5365 = local_64;
                                                phi_7270_ = _e5365;
                                                phi_7271_ = true;
                                                phi_7272_ = false;
                                                phi_7273_ = false;
                                                phi_7274_ = false;
                                                phi_7275_ = false;
                                                phi_7276_ = false;
                                            } else {
                                                let _e5367 = local_65;
                                                phi_7270_ = _e5367;
                                                phi_7271_ = _e3066;
                                                phi_7272_ = _e3068;
                                                phi_7273_ = _e3070;
                                                let _e5373 = local_66;
                                                phi_7274_ = _e5373;
                                                phi_7275_ = _e3072;
                                                phi_7276_ = _e3074;
                                            }
                                            let _e3076 = phi_7270_;
                                            let _e3078 = phi_7271_;
                                            let _e3080 = phi_7272_;
                                            let _e3082 = phi_7273_;
                                            let _e3084 = phi_7274_;
                                            let _e3086 = phi_7275_;
                                            let _e3088 = phi_7276_;
                                            if _e3078 {
                                                phi_7281_ = type_72(1u, _e3076);
                                                phi_7282_ = false;
                                                phi_7283_ = false;
                                                phi_7284_ = false;
                                                phi_7285_ = false;
                                                phi_7286_ = false;
                                            } else {
                                                phi_7281_ = type_72();
                                                phi_7282_ = _e3080;
                                                phi_7283_ = _e3082;
                                                phi_7284_ = _e3084;
                                                phi_7285_ = _e3086;
                                                phi_7286_ = _e3088;
                                            }
                                            let _e3091 = phi_7281_;
                                            let _e3093 = phi_7282_;
                                            let _e3095 = phi_7283_;
                                            let _e3097 = phi_7284_;
                                            let _e3099 = phi_7285_;
                                            let _e3101 = phi_7286_;
                                            if _e3093 {
                                                let _e3103 = local_32;
                                                phi_7291_ = type_72(1u, _e3103);
                                                phi_7292_ = false;
                                                phi_7293_ = true;
                                                phi_7294_ = false;
                                                phi_7295_ = false;
                                            } else {
                                                phi_7291_ = _e3062;
                                                phi_7292_ = _e3095;
                                                phi_7293_ = _e3097;
                                                phi_7294_ = _e3099;
                                                phi_7295_ = _e3101;
                                            }
                                            let _e3106 = phi_7291_;
                                            let _e3108 = phi_7292_;
                                            let _e3110 = phi_7293_;
                                            let _e3112 = phi_7294_;
                                            let _e3114 = phi_7295_;
                                            if _e3108 {
                                                let _e3116 = local_33;
                                                phi_7300_ = type_72(1u, _e3116);
                                                phi_7301_ = true;
                                                phi_7302_ = false;
                                                phi_7303_ = false;
                                            } else {
                                                phi_7300_ = _e3106;
                                                phi_7301_ = _e3110;
                                                phi_7302_ = _e3112;
                                                phi_7303_ = _e3114;
                                            }
                                            let _e3119 = phi_7300_;
                                            let _e3121 = phi_7301_;
                                            let _e3123 = phi_7302_;
                                            let _e3125 = phi_7303_;
                                            if _e3121 {
                                                phi_7307_ = false;
                                                phi_7308_ = false;
                                            } else {
                                                phi_7307_ = _e3123;
                                                phi_7308_ = _e3125;
                                            }
                                            let _e3127 = phi_7307_;
                                            let _e3129 = phi_7308_;
                                            if _e3127 {
                                                phi_7312_ = false;
                                                phi_7313_ = false;
                                            } else {
                                                phi_7312_ = _e3129;
                                                phi_7313_ = _e3121;
                                            }
                                            let _e3131 = phi_7312_;
                                            let _e3133 = phi_7313_;
                                            if _e3131 {
                                                phi_7317_ = true;
                                                phi_7318_ = false;
                                            } else {
                                                phi_7317_ = _e3127;
                                                phi_7318_ = _e3133;
                                            }
                                            let _e3135 = phi_7317_;
                                            let _e3137 = phi_7318_;
                                            if _e3135 {
                                                let _e3139 = local_34;
                                                phi_7323_ = type_72(1u, _e3139);
                                                phi_7324_ = true;
                                            } else {
                                                phi_7323_ = _e3119;
                                                phi_7324_ = _e3137;
                                            }
                                            let _e3142 = phi_7323_;
                                            let _e3144 = phi_7324_;
                                            if _e3144 {
                                                phi_7328_ = _e3142;
                                            } else {
                                                phi_7328_ = _e3091;
                                            }
                                            let _e3146 = phi_7328_;
                                            let _e3149 = (_e3146.member != 0u);
                                            if _e3149 {
                                                phi_7335_ = false;
                                            } else {
                                                phi_7335_ = true;
                                            }
                                            let _e3151 = phi_7335_;
                                            phi_7336_ = _e3146.member_1;
                                            phi_7337_ = _e3151;
                                            phi_7338_ = _e3149;
                                            phi_7339_ = false;
                                        } else {
                                            phi_7336_ = f64();
                                            phi_7337_ = false;
                                            phi_7338_ = false;
                                            phi_7339_ = true;
                                        }
                                        let _e3153 = phi_7336_;
                                        let _e3155 = phi_7337_;
                                        let _e3157 = phi_7338_;
                                        let _e3159 = phi_7339_;
                                        phi_7340_ = _e3153;
                                        phi_7341_ = _e3155;
                                        phi_7342_ = _e3157;
                                        phi_7343_ = _e3159;
                                    }
                                    let _e3161 = phi_7340_;
                                    let _e3163 = phi_7341_;
                                    let _e3165 = phi_7342_;
                                    let _e3167 = phi_7343_;
                                    phi_7344_ = _e3161;
                                    phi_7345_ = _e2172;
                                    phi_7346_ = _e3163;
                                    phi_7347_ = _e3165;
                                    phi_7348_ = _e3167;
                                }
                                let _e3169 = phi_7344_;
                                let _e3171 = phi_7345_;
                                let _e3173 = phi_7346_;
                                let _e3175 = phi_7347_;
                                let _e3177 = phi_7348_;
                                if _e3171 {
                                    phi_7352_ = true;
                                    phi_7353_ = false;
                                    phi_7354_ = false;
                                } else {
                                    phi_7352_ = _e3173;
                                    phi_7353_ = _e3175;
                                    phi_7354_ = _e3177;
                                }
                                let _e3179 = phi_7352_;
                                let _e3181 = phi_7353_;
                                let _e3183 = phi_7354_;
                                phi_7355_ = _e3169;
                                phi_7356_ = _e1431;
                                phi_7357_ = _e3179;
                                phi_7358_ = false;
                                phi_7359_ = _e3181;
                                phi_7360_ = _e3183;
                            } else {
                                phi_7355_ = f64();
                                phi_7356_ = type_73();
                                phi_7357_ = false;
                                phi_7358_ = true;
                                phi_7359_ = false;
                                phi_7360_ = false;
                            }
                            let _e3185 = phi_7355_;
                            let _e3187 = phi_7356_;
                            let _e3189 = phi_7357_;
                            let _e3191 = phi_7358_;
                            let _e3193 = phi_7359_;
                            let _e3195 = phi_7360_;
                            local_35 = _e3191;
                            local_67 = _e3193;
                            local_68 = _e3195;
                            local_36 = _e3185;
                            local_37 = _e3187;
                            continue;
                            continuing {
                                phi_4317_ = _e1098;
                                break if !(_e3189);
                            }
                        }
                        let _e3198 = local_35;
                        if _e3198 {
                            phi_7365_ = type_72(0u, type_72().member_1);
                            phi_7366_ = false;
                            phi_7367_ = false;
                        } else {
                            phi_7365_ = type_72();
                            let _e5430 = local_67;
                            phi_7366_ = _e5430;
                            let _e5433 = local_68;
                            phi_7367_ = _e5433;
                        }
                        let _e3203 = phi_7365_;
                        let _e3205 = phi_7366_;
                        let _e3207 = phi_7367_;
                        if _e3205 {
                            let _e3209 = local_36;
                            phi_7372_ = type_72(2u, _e3209);
                            phi_7373_ = false;
                        } else {
                            phi_7372_ = type_72();
                            phi_7373_ = _e3207;
                        }
                        let _e3212 = phi_7372_;
                        let _e3214 = phi_7373_;
                        if _e3214 {
                            let _e3216 = local_37;
                            phi_7379_ = type_72(1u, _e3216.member);
                            phi_7380_ = true;
                        } else {
                            phi_7379_ = _e3212;
                            phi_7380_ = _e3205;
                        }
                        let _e3220 = phi_7379_;
                        let _e3222 = phi_7380_;
                        if _e3222 {
                            phi_7384_ = _e3220;
                        } else {
                            phi_7384_ = _e3203;
                        }
                        let _e3224 = phi_7384_;
                        phi_7388_ = _e3224;
                    }
                    let _e4831 = phi_7388_;
                    phi_7389_ = _e4831;
                }
                let _e4836 = phi_7389_;
                switch bitcast<i32>(_e4836.member) {
                    case 0: {
                        phi_7410_ = type_46(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4846 = bitcast<u64>(_e4836.member_1);
                        phi_7410_ = type_46(0u, array<u32, 2>(u32(_e4846), u32((_e4846 / 4294967296lu))), true);
                        break;
                    }
                    case 2: {
                        let _e4840 = bitcast<u64>(_e4836.member_1);
                        phi_7410_ = type_46(1u, array<u32, 2>(u32(_e4840), u32((_e4840 / 4294967296lu))), true);
                        break;
                    }
                    default: {
                        phi_7410_ = type_46();
                        break;
                    }
                }
                let _e4853 = phi_7410_;
                if _e4853.member_2 {
                    let _e4859 = (_e4853.member_1[1] >> bitcast<u32>(20i));
                    if (_e4859 <= 896u) {
                        phi_7433_ = 0u;
                    } else {
                        phi_7433_ = ((((_e4859 - 896u) << bitcast<u32>(23i)) | ((_e4853.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4853.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4874 = phi_7433_;
                    let _e4876 = atomicMin((&earliest.member[0u]), _e4874);
                }
                let _e4878 = params.member.member_1;
                if ((_e4878 & 16u) != 0u) {
                    if (_e115 == 0u) {
                        atomicStore((&counters[0u]), 0u);
                    }
                    workgroupBarrier();
                    if _e4853.member_2 {
                        let _e4884 = atomicAdd((&counters[0u]), 1u);
                        phi_7454_ = _e4884;
                    } else {
                        phi_7454_ = 0u;
                    }
                    let _e4886 = phi_7454_;
                    workgroupBarrier();
                    if (_e115 == 0u) {
                        let _e4889 = atomicLoad((&counters[0u]));
                        if (_e4889 > 0u) {
                            let _e4892 = atomicAdd((&contacts.member[0u]), _e4889);
                            atomicStore((&counters[1u]), _e4892);
                        }
                    }
                    workgroupBarrier();
                    let _e4895 = atomicLoad((&counters[1u]));
                    let _e4896 = (_e4895 + _e4886);
                    if _e4853.member_2 {
                        let _e4898 = params.member.member_16;
                        if (_e4896 < _e4898) {
                            let _e4900 = (6u * _e4896);
                            atomicStore((&contacts.member[(4u + _e4900)]), _e184);
                            atomicStore((&contacts.member[(_e4900 + 5u)]), _e4853.member);
                            atomicStore((&contacts.member[(_e4900 + 6u)]), _e202);
                            atomicStore((&contacts.member[(_e4900 + 7u)]), _e205);
                            atomicStore((&contacts.member[(_e4900 + 8u)]), _e4853.member_1[0]);
                            atomicStore((&contacts.member[(_e4900 + 9u)]), _e4853.member_1[1]);
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
