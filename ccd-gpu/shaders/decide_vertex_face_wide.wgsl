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
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_13 {
    member: type_11,
}

struct type_17 {
    member: array<u32>,
}

struct type_21 {
    member: array<array<u32, 3>>,
}

struct type_28 {
    member: i32,
    member_1: i32,
}

struct type_29 {
    member: u32,
    member_1: i32,
}

struct type_30 {
    member: u32,
    member_1: u32,
}

struct type_41 {
    member: array<array<f64, 3>>,
}

struct type_44 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_47 {
    member: array<type_44>,
}

struct type_55 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_56 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_60 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_62 {
    member: f64,
    member_1: f64,
}

struct type_70 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_73 {
    member: u32,
    member_1: f64,
}

struct type_74 {
    member: f64,
    member_1: f64,
    member_2: bool,
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
var<storage> paths: type_47;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_78;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> wide: type_41;
@group(0) @binding(4) 
var<storage> input: type_17;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_78;
@group(0) @binding(3) 
var<storage> elements: type_21;

fn function_(param: f64) -> array<u32, 2> {
    let _e95 = bitcast<u64>(param);
    return array<u32, 2>(u32(_e95), u32((_e95 / 4294967296lu)));
}

fn function_1() {
    var local: array<array<f64, 3>, 4>;
    var local_1: array<array<f64, 3>, 4>;
    var local_2: array<array<f64, 3>, 4>;
    var local_3: type_60;
    var local_4: type_60;
    var local_5: type_60;
    var local_6: array<type_62, 4>;
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
    var local_20: type_70;
    var phi_240_: u32;
    var phi_256_: u32;
    var phi_277_: u32;
    var phi_278_: u32;
    var phi_281_: type_30;
    var phi_282_: type_30;
    var phi_305_: type_30;
    var phi_637_: type_30;
    var phi_638_: type_30;
    var phi_661_: type_30;
    var phi_517_: type_30;
    var phi_518_: type_30;
    var phi_541_: type_30;
    var phi_551_: type_30;
    var phi_552_: type_30;
    var phi_575_: type_30;
    var phi_1129_: f64;
    var phi_1136_: f64;
    var phi_1141_: f64;
    var phi_1148_: f64;
    var phi_1153_: f64;
    var phi_1166_: f64;
    var phi_1173_: f64;
    var phi_1178_: f64;
    var phi_1185_: f64;
    var phi_1190_: f64;
    var phi_1195_: f64;
    var phi_1212_: f64;
    var phi_1219_: f64;
    var phi_1224_: f64;
    var phi_1231_: f64;
    var phi_1236_: f64;
    var phi_1250_: f64;
    var phi_1257_: f64;
    var phi_1262_: f64;
    var phi_1269_: f64;
    var phi_1274_: f64;
    var phi_1279_: f64;
    var phi_1296_: f64;
    var phi_1303_: f64;
    var phi_1308_: f64;
    var phi_1315_: f64;
    var phi_1320_: f64;
    var phi_1334_: f64;
    var phi_1341_: f64;
    var phi_1346_: f64;
    var phi_1353_: f64;
    var phi_1358_: f64;
    var phi_1363_: f64;
    var phi_1400_: f64;
    var phi_1406_: f64;
    var phi_1413_: f64;
    var phi_1420_: f64;
    var phi_1426_: f64;
    var phi_1433_: f64;
    var phi_1439_: f64;
    var phi_1445_: f64;
    var phi_1451_: f64;
    var phi_1458_: f64;
    var phi_1465_: f64;
    var phi_1493_: f64;
    var phi_1498_: f64;
    var phi_1503_: f64;
    var phi_1508_: f64;
    var phi_1513_: f64;
    var phi_1518_: f64;
    var phi_1529_: f64;
    var phi_4086_: f64;
    var phi_4092_: f64;
    var phi_4097_: f64;
    var phi_4103_: f64;
    var phi_4109_: f64;
    var phi_4114_: f64;
    var phi_4119_: f64;
    var phi_4129_: bool;
    var phi_4136_: f64;
    var phi_4144_: f64;
    var phi_4187_: type_28;
    var phi_4190_: f64;
    var phi_4211_: bool;
    var phi_4217_: type_29;
    var phi_4188_: type_28;
    var phi_4231_: type_29;
    var phi_4191_: f64;
    var local_21: f64;
    var phi_4180_: f64;
    var phi_4244_: f64;
    var phi_4250_: f64;
    var phi_4275_: type_30;
    var phi_4278_: u32;
    var phi_4276_: type_30;
    var phi_4301_: type_30;
    var phi_4345_: u32;
    var phi_4346_: u32;
    var phi_4279_: u32;
    var phi_4347_: u32;
    var phi_4367_: type_30;
    var phi_4368_: type_30;
    var phi_4391_: type_30;
    var phi_4445_: f64;
    var phi_4452_: f64;
    var phi_4464_: bool;
    var phi_4465_: bool;
    var phi_4466_: bool;
    var phi_4467_: bool;
    var phi_4471_: bool;
    var phi_4483_: type_74;
    var phi_4484_: type_74;
    var phi_4485_: bool;
    var phi_4486_: type_74;
    var phi_4487_: bool;
    var phi_4500_: f64;
    var phi_4513_: type_30;
    var phi_4516_: f64;
    var phi_4518_: f64;
    var phi_4520_: f64;
    var phi_4514_: type_30;
    var phi_4543_: type_30;
    var phi_4570_: f64;
    var phi_4571_: f64;
    var phi_4599_: f64;
    var phi_4615_: f64;
    var phi_4622_: bool;
    var phi_4623_: bool;
    var phi_4624_: bool;
    var phi_4630_: f64;
    var phi_4631_: f64;
    var phi_4632_: bool;
    var phi_4517_: f64;
    var phi_4519_: f64;
    var phi_4521_: f64;
    var phi_4633_: f64;
    var phi_4634_: bool;
    var phi_4635_: bool;
    var local_22: bool;
    var phi_4639_: f64;
    var phi_4640_: f64;
    var phi_4648_: type_30;
    var phi_4651_: f64;
    var phi_4649_: type_30;
    var phi_4674_: type_30;
    var phi_4717_: f64;
    var phi_4727_: f64;
    var phi_4737_: bool;
    var phi_4739_: bool;
    var phi_4744_: f64;
    var phi_4745_: bool;
    var phi_4746_: f64;
    var phi_4747_: bool;
    var phi_4748_: bool;
    var phi_4749_: bool;
    var phi_4750_: f64;
    var phi_4652_: f64;
    var phi_4751_: bool;
    var phi_4752_: bool;
    var phi_4753_: bool;
    var phi_4754_: bool;
    var local_23: bool;
    var phi_4758_: bool;
    var phi_4759_: bool;
    var phi_4763_: bool;
    var phi_4767_: f64;
    var phi_4768_: f64;
    var phi_4770_: type_74;
    var phi_4801_: f64;
    var phi_4808_: f64;
    var phi_4813_: f64;
    var phi_4820_: f64;
    var phi_4825_: f64;
    var phi_4838_: f64;
    var phi_4845_: f64;
    var phi_4850_: f64;
    var phi_4857_: f64;
    var phi_4862_: f64;
    var phi_4867_: f64;
    var phi_4926_: f64;
    var phi_4932_: f64;
    var phi_4937_: f64;
    var phi_4943_: f64;
    var phi_4948_: f64;
    var phi_4962_: f64;
    var phi_4968_: f64;
    var phi_4973_: f64;
    var phi_4979_: f64;
    var phi_4984_: f64;
    var phi_5010_: f64;
    var phi_5017_: f64;
    var phi_5022_: f64;
    var phi_5029_: f64;
    var phi_5034_: f64;
    var phi_5047_: f64;
    var phi_5054_: f64;
    var phi_5059_: f64;
    var phi_5066_: f64;
    var phi_5071_: f64;
    var phi_5076_: f64;
    var phi_5135_: f64;
    var phi_5141_: f64;
    var phi_5146_: f64;
    var phi_5152_: f64;
    var phi_5157_: f64;
    var phi_5171_: f64;
    var phi_5177_: f64;
    var phi_5182_: f64;
    var phi_5188_: f64;
    var phi_5193_: f64;
    var phi_5219_: f64;
    var phi_5226_: f64;
    var phi_5231_: f64;
    var phi_5238_: f64;
    var phi_5243_: f64;
    var phi_5256_: f64;
    var phi_5263_: f64;
    var phi_5268_: f64;
    var phi_5275_: f64;
    var phi_5280_: f64;
    var phi_5285_: f64;
    var phi_5344_: f64;
    var phi_5350_: f64;
    var phi_5355_: f64;
    var phi_5361_: f64;
    var phi_5366_: f64;
    var phi_5380_: f64;
    var phi_5386_: f64;
    var phi_5391_: f64;
    var phi_5397_: f64;
    var phi_5402_: f64;
    var phi_5451_: f64;
    var phi_5457_: f64;
    var phi_5485_: f64;
    var phi_5491_: f64;
    var phi_5496_: u32;
    var phi_5497_: u32;
    var phi_5467_: f64;
    var phi_5473_: f64;
    var phi_5478_: u32;
    var phi_5479_: u32;
    var phi_5498_: u32;
    var phi_5499_: u32;
    var phi_5570_: f64;
    var phi_5582_: f64;
    var phi_5721_: f64;
    var phi_5727_: f64;
    var phi_5734_: f64;
    var phi_5778_: type_30;
    var phi_5781_: bool;
    var phi_5779_: type_30;
    var phi_5804_: type_30;
    var phi_5831_: bool;
    var phi_5832_: bool;
    var phi_5782_: bool;
    var phi_5833_: bool;
    var phi_5834_: bool;
    var local_24: bool;
    var phi_5838_: bool;
    var local_25: bool;
    var phi_5845_: u32;
    var phi_5846_: u32;
    var phi_5847_: bool;
    var phi_5848_: u32;
    var phi_5849_: u32;
    var phi_5850_: bool;
    var phi_5854_: u32;
    var phi_5875_: bool;
    var phi_5876_: bool;
    var phi_5877_: bool;
    var phi_6074_: f64;
    var phi_6081_: f64;
    var phi_6086_: f64;
    var phi_6093_: f64;
    var phi_6098_: f64;
    var phi_6111_: f64;
    var phi_6118_: f64;
    var phi_6123_: f64;
    var phi_6130_: f64;
    var phi_6135_: f64;
    var phi_6140_: f64;
    var phi_6157_: f64;
    var phi_6164_: f64;
    var phi_6169_: f64;
    var phi_6176_: f64;
    var phi_6181_: f64;
    var phi_6195_: f64;
    var phi_6202_: f64;
    var phi_6207_: f64;
    var phi_6214_: f64;
    var phi_6219_: f64;
    var phi_6224_: f64;
    var phi_6241_: f64;
    var phi_6248_: f64;
    var phi_6253_: f64;
    var phi_6260_: f64;
    var phi_6265_: f64;
    var phi_6279_: f64;
    var phi_6286_: f64;
    var phi_6291_: f64;
    var phi_6298_: f64;
    var phi_6303_: f64;
    var phi_6308_: f64;
    var phi_6328_: type_30;
    var phi_6331_: f64;
    var phi_6329_: type_30;
    var phi_6354_: type_30;
    var phi_6530_: bool;
    var phi_6531_: bool;
    var phi_6532_: bool;
    var phi_6533_: bool;
    var phi_6537_: bool;
    var phi_6559_: array<f64, 3>;
    var phi_6560_: bool;
    var phi_6561_: array<f64, 3>;
    var phi_6562_: bool;
    var phi_6749_: f64;
    var phi_6751_: f64;
    var phi_6781_: f64;
    var phi_6783_: f64;
    var phi_6813_: f64;
    var phi_6815_: f64;
    var phi_6851_: type_30;
    var phi_6854_: array<f64, 3>;
    var phi_6852_: type_30;
    var phi_6877_: type_30;
    var phi_6944_: array<f64, 3>;
    var phi_6855_: array<f64, 3>;
    var phi_6945_: array<f64, 3>;
    var phi_6952_: f64;
    var phi_6959_: f64;
    var phi_6967_: f64;
    var phi_7012_: type_28;
    var phi_7015_: f64;
    var phi_7036_: bool;
    var phi_7042_: type_29;
    var phi_7013_: type_28;
    var phi_7056_: type_29;
    var phi_7016_: f64;
    var local_26: f64;
    var phi_7005_: f64;
    var phi_7069_: f64;
    var phi_7082_: type_30;
    var phi_7085_: f64;
    var phi_7083_: type_30;
    var phi_7108_: type_30;
    var phi_7159_: f64;
    var phi_7165_: f64;
    var phi_7179_: bool;
    var phi_7180_: bool;
    var phi_7214_: f64;
    var phi_7215_: f64;
    var phi_7216_: f64;
    var phi_7217_: bool;
    var phi_7221_: bool;
    var phi_7222_: f64;
    var phi_7223_: bool;
    var phi_7224_: bool;
    var phi_7225_: bool;
    var phi_7226_: f64;
    var phi_7227_: bool;
    var phi_7228_: bool;
    var phi_7229_: bool;
    var phi_7086_: f64;
    var phi_7230_: bool;
    var phi_7231_: bool;
    var phi_7232_: bool;
    var phi_7233_: bool;
    var local_27: bool;
    var local_28: f64;
    var local_29: f64;
    var local_30: f64;
    var phi_7251_: bool;
    var phi_7252_: bool;
    var phi_7253_: bool;
    var phi_7254_: bool;
    var phi_7255_: bool;
    var phi_7256_: bool;
    var phi_7257_: bool;
    var phi_7258_: bool;
    var phi_7259_: bool;
    var phi_7260_: bool;
    var phi_7261_: bool;
    var phi_7262_: bool;
    var phi_7263_: bool;
    var phi_7264_: f64;
    var phi_7265_: f64;
    var phi_7266_: bool;
    var phi_7267_: bool;
    var phi_7268_: bool;
    var phi_7269_: bool;
    var phi_7270_: bool;
    var phi_7271_: bool;
    var phi_7272_: bool;
    var phi_7273_: f64;
    var phi_7274_: f64;
    var phi_7275_: bool;
    var phi_7276_: bool;
    var phi_7277_: bool;
    var phi_7278_: bool;
    var phi_7279_: bool;
    var phi_7280_: bool;
    var phi_7281_: bool;
    var phi_7282_: bool;
    var phi_7283_: f64;
    var phi_6332_: f64;
    var phi_7284_: bool;
    var phi_7285_: bool;
    var phi_7286_: bool;
    var phi_7287_: bool;
    var phi_7288_: bool;
    var phi_7289_: bool;
    var phi_7290_: bool;
    var phi_7291_: bool;
    var phi_7292_: bool;
    var local_31: bool;
    var phi_7297_: type_73;
    var phi_7298_: bool;
    var phi_7299_: bool;
    var phi_7300_: bool;
    var phi_7301_: bool;
    var phi_7302_: bool;
    var phi_7303_: bool;
    var phi_7304_: bool;
    var phi_7308_: f64;
    var phi_7309_: bool;
    var phi_7310_: bool;
    var phi_7311_: bool;
    var phi_7312_: bool;
    var phi_7313_: bool;
    var phi_7314_: bool;
    var phi_7315_: bool;
    var phi_7320_: type_73;
    var phi_7321_: bool;
    var phi_7322_: bool;
    var phi_7323_: bool;
    var phi_7324_: bool;
    var phi_7325_: bool;
    var phi_7326_: bool;
    var local_32: f64;
    var phi_7331_: type_73;
    var phi_7332_: bool;
    var phi_7333_: bool;
    var phi_7334_: bool;
    var phi_7335_: bool;
    var phi_7336_: bool;
    var local_33: f64;
    var phi_7341_: type_73;
    var phi_7342_: bool;
    var phi_7343_: bool;
    var phi_7344_: bool;
    var phi_7345_: bool;
    var local_34: f64;
    var phi_7350_: type_73;
    var phi_7351_: bool;
    var phi_7352_: bool;
    var phi_7353_: bool;
    var phi_7354_: bool;
    var phi_7358_: type_73;
    var phi_7359_: bool;
    var phi_7360_: bool;
    var phi_7361_: bool;
    var phi_7365_: bool;
    var phi_7366_: bool;
    var phi_7370_: bool;
    var phi_7371_: bool;
    var phi_7375_: bool;
    var phi_7376_: bool;
    var local_35: f64;
    var phi_7381_: type_73;
    var phi_7382_: bool;
    var phi_7386_: type_73;
    var phi_7393_: bool;
    var phi_7394_: f64;
    var phi_7395_: bool;
    var phi_7396_: bool;
    var phi_7397_: bool;
    var phi_7398_: f64;
    var phi_7399_: bool;
    var phi_7400_: bool;
    var phi_7401_: bool;
    var phi_7402_: f64;
    var phi_7403_: bool;
    var phi_7404_: bool;
    var phi_7405_: bool;
    var phi_7406_: bool;
    var phi_7410_: bool;
    var phi_7411_: bool;
    var phi_7412_: bool;
    var phi_7413_: f64;
    var phi_7414_: type_74;
    var phi_7415_: bool;
    var phi_7416_: bool;
    var phi_7417_: bool;
    var phi_7418_: bool;
    var local_36: bool;
    var phi_7423_: type_73;
    var phi_7424_: bool;
    var phi_7425_: bool;
    var local_37: f64;
    var phi_7430_: type_73;
    var phi_7431_: bool;
    var local_38: type_74;
    var phi_7437_: type_73;
    var phi_7438_: bool;
    var phi_7442_: type_73;
    var phi_1732_: f64;
    var phi_1739_: f64;
    var phi_1744_: f64;
    var phi_1751_: f64;
    var phi_1756_: f64;
    var phi_1769_: f64;
    var phi_1776_: f64;
    var phi_1781_: f64;
    var phi_1788_: f64;
    var phi_1793_: f64;
    var phi_1798_: f64;
    var phi_1815_: f64;
    var phi_1822_: f64;
    var phi_1827_: f64;
    var phi_1834_: f64;
    var phi_1839_: f64;
    var phi_1853_: f64;
    var phi_1860_: f64;
    var phi_1865_: f64;
    var phi_1872_: f64;
    var phi_1877_: f64;
    var phi_1882_: f64;
    var phi_1899_: f64;
    var phi_1906_: f64;
    var phi_1911_: f64;
    var phi_1918_: f64;
    var phi_1923_: f64;
    var phi_1937_: f64;
    var phi_1944_: f64;
    var phi_1949_: f64;
    var phi_1956_: f64;
    var phi_1961_: f64;
    var phi_1966_: f64;
    var phi_1986_: type_30;
    var phi_1989_: f64;
    var phi_1987_: type_30;
    var phi_2012_: type_30;
    var phi_2188_: bool;
    var phi_2189_: bool;
    var phi_2190_: bool;
    var phi_2191_: bool;
    var phi_2195_: bool;
    var phi_2217_: array<f64, 3>;
    var phi_2218_: bool;
    var phi_2219_: array<f64, 3>;
    var phi_2220_: bool;
    var phi_2407_: f64;
    var phi_2409_: f64;
    var phi_2439_: f64;
    var phi_2441_: f64;
    var phi_2471_: f64;
    var phi_2473_: f64;
    var phi_2509_: type_30;
    var phi_2512_: array<f64, 3>;
    var phi_2510_: type_30;
    var phi_2535_: type_30;
    var phi_2602_: array<f64, 3>;
    var phi_2513_: array<f64, 3>;
    var phi_2603_: array<f64, 3>;
    var phi_2610_: f64;
    var phi_2617_: f64;
    var phi_2625_: f64;
    var phi_2670_: type_28;
    var phi_2673_: f64;
    var phi_2694_: bool;
    var phi_2700_: type_29;
    var phi_2671_: type_28;
    var phi_2714_: type_29;
    var phi_2674_: f64;
    var local_39: f64;
    var phi_2663_: f64;
    var phi_2727_: f64;
    var phi_2740_: type_30;
    var phi_2743_: f64;
    var phi_2741_: type_30;
    var phi_2766_: type_30;
    var phi_2817_: f64;
    var phi_2823_: f64;
    var phi_2837_: bool;
    var phi_2838_: bool;
    var phi_2872_: f64;
    var phi_2873_: f64;
    var phi_2874_: f64;
    var phi_2875_: bool;
    var phi_2879_: bool;
    var phi_2880_: f64;
    var phi_2881_: bool;
    var phi_2882_: bool;
    var phi_2883_: bool;
    var phi_2884_: f64;
    var phi_2885_: bool;
    var phi_2886_: bool;
    var phi_2887_: bool;
    var phi_2744_: f64;
    var phi_2888_: bool;
    var phi_2889_: bool;
    var phi_2890_: bool;
    var phi_2891_: bool;
    var local_40: bool;
    var local_41: f64;
    var local_42: f64;
    var local_43: f64;
    var phi_2909_: bool;
    var phi_2910_: bool;
    var phi_2911_: bool;
    var phi_2912_: bool;
    var phi_2913_: bool;
    var phi_2914_: bool;
    var phi_2915_: bool;
    var phi_2916_: bool;
    var phi_2917_: bool;
    var phi_2918_: bool;
    var phi_2919_: bool;
    var phi_2920_: bool;
    var phi_2921_: bool;
    var phi_2922_: f64;
    var phi_2923_: f64;
    var phi_2924_: bool;
    var phi_2925_: bool;
    var phi_2926_: bool;
    var phi_2927_: bool;
    var phi_2928_: bool;
    var phi_2929_: bool;
    var phi_2930_: bool;
    var phi_2931_: f64;
    var phi_2932_: f64;
    var phi_2933_: bool;
    var phi_2934_: bool;
    var phi_2935_: bool;
    var phi_2936_: bool;
    var phi_2937_: bool;
    var phi_2938_: bool;
    var phi_2939_: bool;
    var phi_2940_: bool;
    var phi_2941_: f64;
    var phi_1990_: f64;
    var phi_2942_: bool;
    var phi_2943_: bool;
    var phi_2944_: bool;
    var phi_2945_: bool;
    var phi_2946_: bool;
    var phi_2947_: bool;
    var phi_2948_: bool;
    var phi_2949_: bool;
    var phi_2950_: bool;
    var local_44: bool;
    var phi_2955_: type_73;
    var phi_2956_: bool;
    var phi_2957_: bool;
    var phi_2958_: bool;
    var phi_2959_: bool;
    var phi_2960_: bool;
    var phi_2961_: bool;
    var phi_2962_: bool;
    var phi_2966_: f64;
    var phi_2967_: bool;
    var phi_2968_: bool;
    var phi_2969_: bool;
    var phi_2970_: bool;
    var phi_2971_: bool;
    var phi_2972_: bool;
    var phi_2973_: bool;
    var phi_2978_: type_73;
    var phi_2979_: bool;
    var phi_2980_: bool;
    var phi_2981_: bool;
    var phi_2982_: bool;
    var phi_2983_: bool;
    var phi_2984_: bool;
    var local_45: f64;
    var phi_2989_: type_73;
    var phi_2990_: bool;
    var phi_2991_: bool;
    var phi_2992_: bool;
    var phi_2993_: bool;
    var phi_2994_: bool;
    var local_46: f64;
    var phi_2999_: type_73;
    var phi_3000_: bool;
    var phi_3001_: bool;
    var phi_3002_: bool;
    var phi_3003_: bool;
    var local_47: f64;
    var phi_3008_: type_73;
    var phi_3009_: bool;
    var phi_3010_: bool;
    var phi_3011_: bool;
    var phi_3012_: bool;
    var phi_3016_: type_73;
    var phi_3017_: bool;
    var phi_3018_: bool;
    var phi_3019_: bool;
    var phi_3023_: bool;
    var phi_3024_: bool;
    var phi_3028_: bool;
    var phi_3029_: bool;
    var phi_3033_: bool;
    var phi_3034_: bool;
    var local_48: f64;
    var phi_3039_: type_73;
    var phi_3040_: bool;
    var phi_3044_: type_73;
    var phi_3058_: type_30;
    var phi_3059_: type_30;
    var phi_3082_: type_30;
    var phi_3103_: f64;
    var phi_3273_: bool;
    var phi_3274_: bool;
    var phi_3275_: bool;
    var phi_3276_: bool;
    var phi_3280_: bool;
    var phi_3302_: array<f64, 3>;
    var phi_3303_: bool;
    var phi_3304_: array<f64, 3>;
    var phi_3305_: bool;
    var phi_3492_: f64;
    var phi_3494_: f64;
    var phi_3524_: f64;
    var phi_3526_: f64;
    var phi_3556_: f64;
    var phi_3558_: f64;
    var phi_3594_: type_30;
    var phi_3597_: array<f64, 3>;
    var phi_3595_: type_30;
    var phi_3620_: type_30;
    var phi_3687_: array<f64, 3>;
    var phi_3598_: array<f64, 3>;
    var phi_3688_: array<f64, 3>;
    var phi_3720_: type_28;
    var phi_3723_: f64;
    var phi_3744_: bool;
    var phi_3750_: type_29;
    var phi_3721_: type_28;
    var phi_3764_: type_29;
    var phi_3724_: f64;
    var local_49: f64;
    var phi_3713_: f64;
    var phi_3777_: f64;
    var phi_3795_: f64;
    var phi_3802_: f64;
    var phi_3807_: f64;
    var phi_3814_: f64;
    var phi_3819_: f64;
    var phi_3832_: f64;
    var phi_3839_: f64;
    var phi_3844_: f64;
    var phi_3851_: f64;
    var phi_3856_: f64;
    var phi_3861_: f64;
    var phi_3878_: f64;
    var phi_3885_: f64;
    var phi_3890_: f64;
    var phi_3897_: f64;
    var phi_3902_: f64;
    var phi_3916_: f64;
    var phi_3923_: f64;
    var phi_3928_: f64;
    var phi_3935_: f64;
    var phi_3940_: f64;
    var phi_3945_: f64;
    var phi_3962_: f64;
    var phi_3969_: f64;
    var phi_3974_: f64;
    var phi_3981_: f64;
    var phi_3986_: f64;
    var phi_4000_: f64;
    var phi_4007_: f64;
    var phi_4012_: f64;
    var phi_4019_: f64;
    var phi_4024_: f64;
    var phi_4029_: f64;
    var phi_4053_: bool;
    var phi_4054_: bool;
    var phi_4055_: bool;
    var local_50: bool;
    var phi_4060_: type_73;
    var phi_4061_: bool;
    var phi_4066_: type_73;
    var phi_4067_: bool;
    var phi_4069_: type_73;
    var phi_4070_: type_73;
    var phi_4071_: bool;
    var phi_4075_: type_73;
    var phi_7446_: type_73;
    var phi_7447_: type_73;
    var phi_7460_: type_56;
    var phi_7483_: u32;
    var phi_7487_: type_55;
    var phi_7488_: bool;
    var phi_7506_: u32;
    var local_51: u32;
    var local_52: f64;
    var local_53: f64;
    var local_54: bool;
    var local_55: bool;
    var local_56: f64;
    var local_57: array<f64, 3>;
    var local_58: bool;
    var local_59: bool;
    var local_60: f64;
    var local_61: f64;
    var local_62: bool;
    var local_63: bool;
    var local_64: bool;
    var local_65: bool;
    var local_66: bool;
    var local_67: bool;
    var local_68: bool;
    var local_69: f64;
    var local_70: f64;
    var local_71: bool;
    var local_72: bool;
    var local_73: bool;
    var local_74: array<f64, 3>;
    var local_75: bool;
    var local_76: bool;
    var local_77: f64;
    var local_78: f64;
    var local_79: bool;
    var local_80: bool;
    var local_81: bool;
    var local_82: bool;
    var local_83: bool;
    var local_84: bool;
    var local_85: bool;
    var local_86: f64;
    var local_87: f64;
    var local_88: bool;
    var local_89: array<f64, 3>;

    let _e115 = id_1;
    let _e116 = n_1;
    let _e117 = lane_1;
    let _e129 = ((_e115.y * _e116.x) + _e115.x);
    let _e132 = (_e116.x * _e116.y);
    let _e134 = params.member.member_15;
    let _e136 = input.member[0u];
    if (_e134 < _e136) {
        phi_240_ = _e134;
    } else {
        phi_240_ = _e136;
    }
    let _e139 = phi_240_;
    let _e140 = (_e139 / 64u);
    if ((_e139 % 64u) > 0u) {
        phi_256_ = (_e140 + 1u);
    } else {
        phi_256_ = _e140;
    }
    let _e145 = phi_256_;
    if (_e145 > _e129) {
        let _e147 = (_e145 - _e129);
        if (_e132 == 0u) {
            return;
        }
        let _e149 = (_e147 / _e132);
        if (_e132 == 0u) {
            return;
        }
        if ((_e147 % _e132) > 0u) {
            phi_277_ = (_e149 + 1u);
        } else {
            phi_277_ = _e149;
        }
        let _e155 = phi_277_;
        phi_278_ = _e155;
    } else {
        phi_278_ = 0u;
    }
    let _e157 = phi_278_;
    phi_281_ = type_30(0u, _e157);
    loop {
        let _e160 = phi_281_;
        if (_e160.member < _e160.member_1) {
            phi_282_ = type_30((_e160.member + 1u), _e160.member_1);
            phi_305_ = type_30(1u, _e160.member);
        } else {
            phi_282_ = _e160;
            phi_305_ = type_30(0u, type_30().member_1);
        }
        let _e174 = phi_282_;
        let _e176 = phi_305_;
        let _e180 = (bitcast<i32>(_e176.member) != 0i);
        if _e180 {
            let _e184 = (((_e129 + (_e176.member_1 * _e132)) * 64u) + _e117);
            let _e186 = params.member.member_8;
            if (_e184 < _e139) {
                let _e189 = (2u * _e184);
                let _e192 = input.member[(4u + _e189)];
                let _e195 = input.member[(_e189 + 5u)];
                let _e197 = elements.member[_e195];
                local_15 = array<u32, 4>(_e192, _e197[0], _e197[1], _e197[2]);
                local_16[0u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[1u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[2u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[3u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[0u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[1u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[2u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[3u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                let _e211 = params.member.member_1;
                if ((_e211 & 8u) != 0u) {
                    let _e261 = paths.member[_e192];
                    let _e263 = paths.member[_e197[0]];
                    let _e269 = paths.member[_e197[1]];
                    let _e271 = paths.member[_e197[2]];
                    local_18 = array<array<f32, 3>, 4>(array<f32, 3>(_e261.member[0], _e261.member[1], _e261.member[2]), array<f32, 3>(_e263.member[0], _e263.member[1], _e263.member[2]), array<f32, 3>(_e269.member[0], _e269.member[1], _e269.member[2]), array<f32, 3>(_e271.member[0], _e271.member[1], _e271.member[2]));
                    local_19 = array<array<f32, 3>, 4>(array<f32, 3>(_e261.member_1[0], _e261.member_1[1], _e261.member_1[2]), array<f32, 3>(_e263.member_1[0], _e263.member_1[1], _e263.member_1[2]), array<f32, 3>(_e269.member_1[0], _e269.member_1[1], _e269.member_1[2]), array<f32, 3>(_e271.member_1[0], _e271.member_1[1], _e271.member_1[2]));
                    phi_517_ = type_30(0u, 4u);
                    loop {
                        let _e311 = phi_517_;
                        if (_e311.member < _e311.member_1) {
                            phi_518_ = type_30((_e311.member + 1u), _e311.member_1);
                            phi_541_ = type_30(1u, _e311.member);
                        } else {
                            phi_518_ = _e311;
                            phi_541_ = type_30(0u, type_30().member_1);
                        }
                        let _e325 = phi_518_;
                        let _e327 = phi_541_;
                        let _e331 = (bitcast<i32>(_e327.member) != 0i);
                        if _e331 {
                            phi_551_ = type_30(0u, 3u);
                            loop {
                                let _e333 = phi_551_;
                                if (_e333.member < _e333.member_1) {
                                    phi_552_ = type_30((_e333.member + 1u), _e333.member_1);
                                    phi_575_ = type_30(1u, _e333.member);
                                } else {
                                    phi_552_ = _e333;
                                    phi_575_ = type_30(0u, type_30().member_1);
                                }
                                let _e347 = phi_552_;
                                let _e349 = phi_575_;
                                let _e353 = (bitcast<i32>(_e349.member) != 0i);
                                if _e353 {
                                    if (_e327.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e349.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e358 = local_18[_e327.member_1][_e349.member_1];
                                    if (_e327.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e349.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    local_16[_e327.member_1][_e349.member_1] = f64(_e358);
                                    if (_e327.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e349.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e368 = local_19[_e327.member_1][_e349.member_1];
                                    if (_e327.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e349.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    local_17[_e327.member_1][_e349.member_1] = f64(_e368);
                                }
                                continue;
                                continuing {
                                    phi_551_ = _e347;
                                    break if !(_e353);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_517_ = _e325;
                            break if !(_e331);
                        }
                    }
                } else {
                    phi_637_ = type_30(0u, 4u);
                    loop {
                        let _e215 = phi_637_;
                        if (_e215.member < _e215.member_1) {
                            phi_638_ = type_30((_e215.member + 1u), _e215.member_1);
                            phi_661_ = type_30(1u, _e215.member);
                        } else {
                            phi_638_ = _e215;
                            phi_661_ = type_30(0u, type_30().member_1);
                        }
                        let _e229 = phi_638_;
                        let _e231 = phi_661_;
                        let _e235 = (bitcast<i32>(_e231.member) != 0i);
                        if _e235 {
                            if (_e231.member_1 < 4u) {
                            } else {
                                return;
                            }
                            let _e238 = local_15[_e231.member_1];
                            let _e240 = wide.member[_e238];
                            let _e243 = params.member.member[0u];
                            let _e246 = wide.member[(_e243 + _e238)];
                            if (_e231.member_1 < 4u) {
                            } else {
                                return;
                            }
                            local_16[_e231.member_1] = array<f64, 3>(_e240[0], _e240[1], _e240[2]);
                            if (_e231.member_1 < 4u) {
                            } else {
                                return;
                            }
                            local_17[_e231.member_1] = array<f64, 3>(_e246[0], _e246[1], _e246[2]);
                        }
                        continue;
                        continuing {
                            phi_637_ = _e229;
                            break if !(_e235);
                        }
                    }
                }
                let _e376 = local_16;
                let _e393 = local_17;
                local_20 = type_70(array<array<f64, 3>, 2>(array<f64, 3>((_e376[0][0] - _e376[1][0]), (_e376[0][1] - _e376[1][1]), (_e376[0][2] - _e376[1][2])), array<f64, 3>((_e393[0][0] - _e393[1][0]), (_e393[0][1] - _e393[1][1]), (_e393[0][2] - _e393[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e376[2][0] - _e376[1][0]), (_e376[2][1] - _e376[1][1]), (_e376[2][2] - _e376[1][2])), array<f64, 3>((_e393[2][0] - _e393[1][0]), (_e393[2][1] - _e393[1][1]), (_e393[2][2] - _e393[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e376[3][0] - _e376[1][0]), (_e376[3][1] - _e376[1][1]), (_e376[3][2] - _e376[1][2])), array<f64, 3>((_e393[3][0] - _e393[1][0]), (_e393[3][1] - _e393[1][1]), (_e393[3][2] - _e393[1][2]))), (0.0lf + 0.0lf));
                let _e440 = params.member.member_7;
                let _e447 = bitcast<f64>(((u64(_e440[1]) * 4294967296lu) + u64(_e440[0])));
                let _e448 = f64(0f);
                let _e451 = local_20.member_1[0u];
                let _e457 = local_20.member_2[0u];
                let _e463 = ((_e451[1] * _e457[2]) - (_e451[2] * _e457[1]));
                let _e466 = ((_e451[2] * _e457[0]) - (_e451[0] * _e457[2]));
                let _e469 = ((_e451[0] * _e457[1]) - (_e451[1] * _e457[0]));
                let _e472 = local_20.member_1[1u];
                let _e478 = local_20.member_2[1u];
                let _e484 = ((_e472[1] * _e478[2]) - (_e472[2] * _e478[1]));
                let _e487 = ((_e472[2] * _e478[0]) - (_e472[0] * _e478[2]));
                let _e490 = ((_e472[0] * _e478[1]) - (_e472[1] * _e478[0]));
                let _e493 = local_20.member_1[0u];
                let _e499 = local_20.member_2[1u];
                let _e514 = local_20.member_1[1u];
                let _e520 = local_20.member_2[0u];
                let _e533 = (((_e493[1] * _e499[2]) - (_e493[2] * _e499[1])) + ((_e514[1] * _e520[2]) - (_e514[2] * _e520[1])));
                let _e534 = (((_e493[2] * _e499[0]) - (_e493[0] * _e499[2])) + ((_e514[2] * _e520[0]) - (_e514[0] * _e520[2])));
                let _e535 = (((_e493[0] * _e499[1]) - (_e493[1] * _e499[0])) + ((_e514[0] * _e520[1]) - (_e514[1] * _e520[0])));
                let _e538 = local_20.member[0u];
                let _e546 = (((_e538[0] * _e463) + (_e538[1] * _e466)) + (_e538[2] * _e469));
                let _e549 = local_20.member[1u];
                let _e560 = local_20.member[0u];
                let _e569 = ((((_e549[0] * _e463) + (_e549[1] * _e466)) + (_e549[2] * _e469)) + (((_e560[0] * _e533) + (_e560[1] * _e534)) + (_e560[2] * _e535)));
                let _e572 = local_20.member[0u];
                let _e583 = local_20.member[1u];
                let _e592 = ((((_e572[0] * _e484) + (_e572[1] * _e487)) + (_e572[2] * _e490)) + (((_e583[0] * _e533) + (_e583[1] * _e534)) + (_e583[2] * _e535)));
                let _e595 = local_20.member[1u];
                let _e603 = (((_e595[0] * _e484) + (_e595[1] * _e487)) + (_e595[2] * _e490));
                let _e606 = local_20.member[0u];
                if (_e606[0] < 0.0lf) {
                    phi_1129_ = -(_e606[0]);
                } else {
                    phi_1129_ = _e606[0];
                }
                let _e613 = phi_1129_;
                if (_e606[1] < 0.0lf) {
                    phi_1136_ = -(_e606[1]);
                } else {
                    phi_1136_ = _e606[1];
                }
                let _e617 = phi_1136_;
                if (_e613 > _e617) {
                    phi_1141_ = _e613;
                } else {
                    phi_1141_ = _e617;
                }
                let _e620 = phi_1141_;
                if (_e606[2] < 0.0lf) {
                    phi_1148_ = -(_e606[2]);
                } else {
                    phi_1148_ = _e606[2];
                }
                let _e624 = phi_1148_;
                if (_e620 > _e624) {
                    phi_1153_ = _e620;
                } else {
                    phi_1153_ = _e624;
                }
                let _e627 = phi_1153_;
                let _e630 = local_20.member[1u];
                if (_e630[0] < 0.0lf) {
                    phi_1166_ = -(_e630[0]);
                } else {
                    phi_1166_ = _e630[0];
                }
                let _e637 = phi_1166_;
                if (_e630[1] < 0.0lf) {
                    phi_1173_ = -(_e630[1]);
                } else {
                    phi_1173_ = _e630[1];
                }
                let _e641 = phi_1173_;
                if (_e637 > _e641) {
                    phi_1178_ = _e637;
                } else {
                    phi_1178_ = _e641;
                }
                let _e644 = phi_1178_;
                if (_e630[2] < 0.0lf) {
                    phi_1185_ = -(_e630[2]);
                } else {
                    phi_1185_ = _e630[2];
                }
                let _e648 = phi_1185_;
                if (_e644 > _e648) {
                    phi_1190_ = _e644;
                } else {
                    phi_1190_ = _e648;
                }
                let _e651 = phi_1190_;
                if (_e627 > _e651) {
                    phi_1195_ = _e627;
                } else {
                    phi_1195_ = _e651;
                }
                let _e654 = phi_1195_;
                let _e656 = local_20.member_3;
                let _e657 = (_e654 + _e656);
                let _e660 = local_20.member_1[0u];
                if (_e660[0] < 0.0lf) {
                    phi_1212_ = -(_e660[0]);
                } else {
                    phi_1212_ = _e660[0];
                }
                let _e667 = phi_1212_;
                if (_e660[1] < 0.0lf) {
                    phi_1219_ = -(_e660[1]);
                } else {
                    phi_1219_ = _e660[1];
                }
                let _e671 = phi_1219_;
                if (_e667 > _e671) {
                    phi_1224_ = _e667;
                } else {
                    phi_1224_ = _e671;
                }
                let _e674 = phi_1224_;
                if (_e660[2] < 0.0lf) {
                    phi_1231_ = -(_e660[2]);
                } else {
                    phi_1231_ = _e660[2];
                }
                let _e678 = phi_1231_;
                if (_e674 > _e678) {
                    phi_1236_ = _e674;
                } else {
                    phi_1236_ = _e678;
                }
                let _e681 = phi_1236_;
                let _e684 = local_20.member_1[1u];
                if (_e684[0] < 0.0lf) {
                    phi_1250_ = -(_e684[0]);
                } else {
                    phi_1250_ = _e684[0];
                }
                let _e691 = phi_1250_;
                if (_e684[1] < 0.0lf) {
                    phi_1257_ = -(_e684[1]);
                } else {
                    phi_1257_ = _e684[1];
                }
                let _e695 = phi_1257_;
                if (_e691 > _e695) {
                    phi_1262_ = _e691;
                } else {
                    phi_1262_ = _e695;
                }
                let _e698 = phi_1262_;
                if (_e684[2] < 0.0lf) {
                    phi_1269_ = -(_e684[2]);
                } else {
                    phi_1269_ = _e684[2];
                }
                let _e702 = phi_1269_;
                if (_e698 > _e702) {
                    phi_1274_ = _e698;
                } else {
                    phi_1274_ = _e702;
                }
                let _e705 = phi_1274_;
                if (_e681 > _e705) {
                    phi_1279_ = _e681;
                } else {
                    phi_1279_ = _e705;
                }
                let _e708 = phi_1279_;
                let _e710 = local_20.member_3;
                let _e711 = (_e708 + _e710);
                let _e714 = local_20.member_2[0u];
                if (_e714[0] < 0.0lf) {
                    phi_1296_ = -(_e714[0]);
                } else {
                    phi_1296_ = _e714[0];
                }
                let _e721 = phi_1296_;
                if (_e714[1] < 0.0lf) {
                    phi_1303_ = -(_e714[1]);
                } else {
                    phi_1303_ = _e714[1];
                }
                let _e725 = phi_1303_;
                if (_e721 > _e725) {
                    phi_1308_ = _e721;
                } else {
                    phi_1308_ = _e725;
                }
                let _e728 = phi_1308_;
                if (_e714[2] < 0.0lf) {
                    phi_1315_ = -(_e714[2]);
                } else {
                    phi_1315_ = _e714[2];
                }
                let _e732 = phi_1315_;
                if (_e728 > _e732) {
                    phi_1320_ = _e728;
                } else {
                    phi_1320_ = _e732;
                }
                let _e735 = phi_1320_;
                let _e738 = local_20.member_2[1u];
                if (_e738[0] < 0.0lf) {
                    phi_1334_ = -(_e738[0]);
                } else {
                    phi_1334_ = _e738[0];
                }
                let _e745 = phi_1334_;
                if (_e738[1] < 0.0lf) {
                    phi_1341_ = -(_e738[1]);
                } else {
                    phi_1341_ = _e738[1];
                }
                let _e749 = phi_1341_;
                if (_e745 > _e749) {
                    phi_1346_ = _e745;
                } else {
                    phi_1346_ = _e749;
                }
                let _e752 = phi_1346_;
                if (_e738[2] < 0.0lf) {
                    phi_1353_ = -(_e738[2]);
                } else {
                    phi_1353_ = _e738[2];
                }
                let _e756 = phi_1353_;
                if (_e752 > _e756) {
                    phi_1358_ = _e752;
                } else {
                    phi_1358_ = _e756;
                }
                let _e759 = phi_1358_;
                if (_e735 > _e759) {
                    phi_1363_ = _e735;
                } else {
                    phi_1363_ = _e759;
                }
                let _e762 = phi_1363_;
                let _e764 = local_20.member_3;
                let _e765 = (_e762 + _e764);
                let _e766 = f64(1f);
                let _e767 = f64(8f);
                let _e769 = ((_e711 * _e767) * _e765);
                let _e777 = local_20.member_3;
                if (_e463 < 0.0lf) {
                    phi_1400_ = -(_e463);
                } else {
                    phi_1400_ = _e463;
                }
                let _e797 = phi_1400_;
                if (_e466 < 0.0lf) {
                    phi_1406_ = -(_e466);
                } else {
                    phi_1406_ = _e466;
                }
                let _e801 = phi_1406_;
                if (_e469 < 0.0lf) {
                    phi_1413_ = -(_e469);
                } else {
                    phi_1413_ = _e469;
                }
                let _e806 = phi_1413_;
                let _e807 = ((_e797 + _e801) + _e806);
                if (_e484 < 0.0lf) {
                    phi_1420_ = -(_e484);
                } else {
                    phi_1420_ = _e484;
                }
                let _e811 = phi_1420_;
                if (_e487 < 0.0lf) {
                    phi_1426_ = -(_e487);
                } else {
                    phi_1426_ = _e487;
                }
                let _e815 = phi_1426_;
                if (_e490 < 0.0lf) {
                    phi_1433_ = -(_e490);
                } else {
                    phi_1433_ = _e490;
                }
                let _e820 = phi_1433_;
                let _e821 = ((_e811 + _e815) + _e820);
                if (_e807 > _e821) {
                    phi_1439_ = _e807;
                } else {
                    phi_1439_ = _e821;
                }
                let _e824 = phi_1439_;
                if (_e533 < 0.0lf) {
                    phi_1445_ = -(_e533);
                } else {
                    phi_1445_ = _e533;
                }
                let _e828 = phi_1445_;
                if (_e534 < 0.0lf) {
                    phi_1451_ = -(_e534);
                } else {
                    phi_1451_ = _e534;
                }
                let _e832 = phi_1451_;
                if (_e535 < 0.0lf) {
                    phi_1458_ = -(_e535);
                } else {
                    phi_1458_ = _e535;
                }
                let _e837 = phi_1458_;
                let _e839 = (((_e828 + _e832) + _e837) * f64(0.5f));
                if (_e824 > _e839) {
                    phi_1465_ = _e824;
                } else {
                    phi_1465_ = _e839;
                }
                let _e842 = phi_1465_;
                let _e848 = local_20.member_3;
                let _e862 = (((((_e657 * _e767) * _e769) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e777 * f64(19f)) * ((_e657 * (_e711 + _e765)) + (_e711 * _e765)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e766 + _e657) * ((_e766 + _e711) * (_e766 + _e765)))));
                let _e863 = f64(3f);
                let _e864 = (_e546 * _e863);
                let _e865 = (_e603 * _e863);
                if (_e864 < _e865) {
                    phi_1493_ = _e864;
                } else {
                    phi_1493_ = _e865;
                }
                let _e868 = phi_1493_;
                if (_e569 < _e592) {
                    phi_1498_ = _e569;
                } else {
                    phi_1498_ = _e592;
                }
                let _e871 = phi_1498_;
                if (_e868 < _e871) {
                    phi_1503_ = _e868;
                } else {
                    phi_1503_ = _e871;
                }
                let _e874 = phi_1503_;
                if (_e864 > _e865) {
                    phi_1508_ = _e864;
                } else {
                    phi_1508_ = _e865;
                }
                let _e877 = phi_1508_;
                if (_e569 > _e592) {
                    phi_1513_ = _e569;
                } else {
                    phi_1513_ = _e592;
                }
                let _e880 = phi_1513_;
                if (_e877 > _e880) {
                    phi_1518_ = _e877;
                } else {
                    phi_1518_ = _e880;
                }
                let _e883 = phi_1518_;
                let _e889 = -(_e883);
                if (_e874 > _e889) {
                    phi_1529_ = _e874;
                } else {
                    phi_1529_ = _e889;
                }
                let _e892 = phi_1529_;
                if ((_e892 - (_e862 + ((_e447 * (((_e842 + (_e769 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e848 * f64(6f)) * (_e711 + _e765))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e766 + _e711) * (_e766 + _e765))))) * f64((3f * 1.0001f))))) > _e448) {
                    phi_7447_ = type_73(0u, type_73().member_1);
                } else {
                    if (_e447 > _e448) {
                        let _e3269 = f64(1f);
                        let _e3273 = local_20.member[0u];
                        let _e3279 = local_20.member_1[0u];
                        let _e3285 = local_20.member_2[0u];
                        local_12 = array<array<f64, 3>, 4>(_e3273, array<f64, 3>((_e3273[0] - _e3279[0]), (_e3273[1] - _e3279[1]), (_e3273[2] - _e3279[2])), array<f64, 3>((_e3273[0] - _e3285[0]), (_e3273[1] - _e3285[1]), (_e3273[2] - _e3285[2])), _e3273);
                        let _e3300 = local_20.member[1u];
                        let _e3306 = local_20.member_1[1u];
                        let _e3312 = local_20.member_2[1u];
                        local_13 = array<array<f64, 3>, 4>(_e3300, array<f64, 3>((_e3300[0] - _e3306[0]), (_e3300[1] - _e3306[1]), (_e3300[2] - _e3306[2])), array<f64, 3>((_e3300[0] - _e3312[0]), (_e3300[1] - _e3312[1]), (_e3300[2] - _e3312[2])), _e3300);
                        let _e3327 = local_20.member[0u];
                        if (_e3327[0] < 0.0lf) {
                            phi_1732_ = -(_e3327[0]);
                        } else {
                            phi_1732_ = _e3327[0];
                        }
                        let _e3334 = phi_1732_;
                        if (_e3327[1] < 0.0lf) {
                            phi_1739_ = -(_e3327[1]);
                        } else {
                            phi_1739_ = _e3327[1];
                        }
                        let _e3338 = phi_1739_;
                        if (_e3334 > _e3338) {
                            phi_1744_ = _e3334;
                        } else {
                            phi_1744_ = _e3338;
                        }
                        let _e3341 = phi_1744_;
                        if (_e3327[2] < 0.0lf) {
                            phi_1751_ = -(_e3327[2]);
                        } else {
                            phi_1751_ = _e3327[2];
                        }
                        let _e3345 = phi_1751_;
                        if (_e3341 > _e3345) {
                            phi_1756_ = _e3341;
                        } else {
                            phi_1756_ = _e3345;
                        }
                        let _e3348 = phi_1756_;
                        let _e3351 = local_20.member[1u];
                        if (_e3351[0] < 0.0lf) {
                            phi_1769_ = -(_e3351[0]);
                        } else {
                            phi_1769_ = _e3351[0];
                        }
                        let _e3358 = phi_1769_;
                        if (_e3351[1] < 0.0lf) {
                            phi_1776_ = -(_e3351[1]);
                        } else {
                            phi_1776_ = _e3351[1];
                        }
                        let _e3362 = phi_1776_;
                        if (_e3358 > _e3362) {
                            phi_1781_ = _e3358;
                        } else {
                            phi_1781_ = _e3362;
                        }
                        let _e3365 = phi_1781_;
                        if (_e3351[2] < 0.0lf) {
                            phi_1788_ = -(_e3351[2]);
                        } else {
                            phi_1788_ = _e3351[2];
                        }
                        let _e3369 = phi_1788_;
                        if (_e3365 > _e3369) {
                            phi_1793_ = _e3365;
                        } else {
                            phi_1793_ = _e3369;
                        }
                        let _e3372 = phi_1793_;
                        if (_e3348 > _e3372) {
                            phi_1798_ = _e3348;
                        } else {
                            phi_1798_ = _e3372;
                        }
                        let _e3375 = phi_1798_;
                        let _e3377 = local_20.member_3;
                        let _e3381 = local_20.member_1[0u];
                        if (_e3381[0] < 0.0lf) {
                            phi_1815_ = -(_e3381[0]);
                        } else {
                            phi_1815_ = _e3381[0];
                        }
                        let _e3388 = phi_1815_;
                        if (_e3381[1] < 0.0lf) {
                            phi_1822_ = -(_e3381[1]);
                        } else {
                            phi_1822_ = _e3381[1];
                        }
                        let _e3392 = phi_1822_;
                        if (_e3388 > _e3392) {
                            phi_1827_ = _e3388;
                        } else {
                            phi_1827_ = _e3392;
                        }
                        let _e3395 = phi_1827_;
                        if (_e3381[2] < 0.0lf) {
                            phi_1834_ = -(_e3381[2]);
                        } else {
                            phi_1834_ = _e3381[2];
                        }
                        let _e3399 = phi_1834_;
                        if (_e3395 > _e3399) {
                            phi_1839_ = _e3395;
                        } else {
                            phi_1839_ = _e3399;
                        }
                        let _e3402 = phi_1839_;
                        let _e3405 = local_20.member_1[1u];
                        if (_e3405[0] < 0.0lf) {
                            phi_1853_ = -(_e3405[0]);
                        } else {
                            phi_1853_ = _e3405[0];
                        }
                        let _e3412 = phi_1853_;
                        if (_e3405[1] < 0.0lf) {
                            phi_1860_ = -(_e3405[1]);
                        } else {
                            phi_1860_ = _e3405[1];
                        }
                        let _e3416 = phi_1860_;
                        if (_e3412 > _e3416) {
                            phi_1865_ = _e3412;
                        } else {
                            phi_1865_ = _e3416;
                        }
                        let _e3419 = phi_1865_;
                        if (_e3405[2] < 0.0lf) {
                            phi_1872_ = -(_e3405[2]);
                        } else {
                            phi_1872_ = _e3405[2];
                        }
                        let _e3423 = phi_1872_;
                        if (_e3419 > _e3423) {
                            phi_1877_ = _e3419;
                        } else {
                            phi_1877_ = _e3423;
                        }
                        let _e3426 = phi_1877_;
                        if (_e3402 > _e3426) {
                            phi_1882_ = _e3402;
                        } else {
                            phi_1882_ = _e3426;
                        }
                        let _e3429 = phi_1882_;
                        let _e3431 = local_20.member_3;
                        let _e3435 = local_20.member_2[0u];
                        if (_e3435[0] < 0.0lf) {
                            phi_1899_ = -(_e3435[0]);
                        } else {
                            phi_1899_ = _e3435[0];
                        }
                        let _e3442 = phi_1899_;
                        if (_e3435[1] < 0.0lf) {
                            phi_1906_ = -(_e3435[1]);
                        } else {
                            phi_1906_ = _e3435[1];
                        }
                        let _e3446 = phi_1906_;
                        if (_e3442 > _e3446) {
                            phi_1911_ = _e3442;
                        } else {
                            phi_1911_ = _e3446;
                        }
                        let _e3449 = phi_1911_;
                        if (_e3435[2] < 0.0lf) {
                            phi_1918_ = -(_e3435[2]);
                        } else {
                            phi_1918_ = _e3435[2];
                        }
                        let _e3453 = phi_1918_;
                        if (_e3449 > _e3453) {
                            phi_1923_ = _e3449;
                        } else {
                            phi_1923_ = _e3453;
                        }
                        let _e3456 = phi_1923_;
                        let _e3459 = local_20.member_2[1u];
                        if (_e3459[0] < 0.0lf) {
                            phi_1937_ = -(_e3459[0]);
                        } else {
                            phi_1937_ = _e3459[0];
                        }
                        let _e3466 = phi_1937_;
                        if (_e3459[1] < 0.0lf) {
                            phi_1944_ = -(_e3459[1]);
                        } else {
                            phi_1944_ = _e3459[1];
                        }
                        let _e3470 = phi_1944_;
                        if (_e3466 > _e3470) {
                            phi_1949_ = _e3466;
                        } else {
                            phi_1949_ = _e3470;
                        }
                        let _e3473 = phi_1949_;
                        if (_e3459[2] < 0.0lf) {
                            phi_1956_ = -(_e3459[2]);
                        } else {
                            phi_1956_ = _e3459[2];
                        }
                        let _e3477 = phi_1956_;
                        if (_e3473 > _e3477) {
                            phi_1961_ = _e3473;
                        } else {
                            phi_1961_ = _e3477;
                        }
                        let _e3480 = phi_1961_;
                        if (_e3456 > _e3480) {
                            phi_1966_ = _e3456;
                        } else {
                            phi_1966_ = _e3480;
                        }
                        let _e3483 = phi_1966_;
                        let _e3485 = local_20.member_3;
                        let _e3493 = local_20.member_3;
                        phi_1986_ = type_30(0u, 48u);
                        phi_1989_ = f64(0f);
                        loop {
                            let _e3502 = phi_1986_;
                            let _e3504 = phi_1989_;
                            local_87 = _e3504;
                            local_45 = _e3504;
                            local_46 = _e3504;
                            local_47 = _e3504;
                            local_48 = _e3504;
                            if (_e3502.member < _e3502.member_1) {
                                phi_1987_ = type_30((_e3502.member + 1u), _e3502.member_1);
                                phi_2012_ = type_30(1u, _e3502.member);
                            } else {
                                phi_1987_ = _e3502;
                                phi_2012_ = type_30(0u, type_30().member_1);
                            }
                            let _e3518 = phi_1987_;
                            let _e3520 = phi_2012_;
                            if (bitcast<i32>(_e3520.member) != 0i) {
                                let _e3526 = local_20.member[0u];
                                let _e3532 = local_20.member[1u];
                                let _e3542 = (_e3526[0] + ((_e3532[0] - _e3526[0]) * _e3504));
                                let _e3543 = (_e3526[1] + ((_e3532[1] - _e3526[1]) * _e3504));
                                let _e3544 = (_e3526[2] + ((_e3532[2] - _e3526[2]) * _e3504));
                                let _e3547 = local_20.member_1[0u];
                                let _e3553 = local_20.member_1[1u];
                                let _e3563 = (_e3547[0] + ((_e3553[0] - _e3547[0]) * _e3504));
                                let _e3564 = (_e3547[1] + ((_e3553[1] - _e3547[1]) * _e3504));
                                let _e3565 = (_e3547[2] + ((_e3553[2] - _e3547[2]) * _e3504));
                                let _e3568 = local_20.member_2[0u];
                                let _e3574 = local_20.member_2[1u];
                                let _e3584 = (_e3568[0] + ((_e3574[0] - _e3568[0]) * _e3504));
                                let _e3585 = (_e3568[1] + ((_e3574[1] - _e3568[1]) * _e3504));
                                let _e3586 = (_e3568[2] + ((_e3574[2] - _e3568[2]) * _e3504));
                                let _e3591 = (((_e3563 * _e3563) + (_e3564 * _e3564)) + (_e3565 * _e3565));
                                let _e3596 = (((_e3563 * _e3584) + (_e3564 * _e3585)) + (_e3565 * _e3586));
                                let _e3601 = (((_e3584 * _e3584) + (_e3585 * _e3585)) + (_e3586 * _e3586));
                                let _e3606 = (((_e3542 * _e3563) + (_e3543 * _e3564)) + (_e3544 * _e3565));
                                let _e3611 = (((_e3542 * _e3584) + (_e3543 * _e3585)) + (_e3544 * _e3586));
                                let _e3614 = ((_e3591 * _e3601) - (_e3596 * _e3596));
                                let _e3615 = f64(0f);
                                let _e3620 = (((_e3606 * _e3601) - (_e3611 * _e3596)) / _e3614);
                                let _e3624 = (((_e3611 * _e3591) - (_e3606 * _e3596)) / _e3614);
                                if (_e3620 >= _e3615) {
                                    if (_e3624 >= _e3615) {
                                        phi_2188_ = ((_e3620 + _e3624) <= f64(1f));
                                        phi_2189_ = false;
                                    } else {
                                        phi_2188_ = bool();
                                        phi_2189_ = true;
                                    }
                                    let _e3630 = phi_2188_;
                                    let _e3632 = phi_2189_;
                                    phi_2190_ = _e3630;
                                    phi_2191_ = _e3632;
                                } else {
                                    phi_2190_ = bool();
                                    phi_2191_ = true;
                                }
                                let _e3634 = phi_2190_;
                                let _e3636 = phi_2191_;
                                if _e3636 {
                                    phi_2195_ = false;
                                } else {
                                    phi_2195_ = _e3634;
                                }
                                let _e3638 = phi_2195_;
                                if (_e3614 > _e3615) {
                                    if _e3638 {
                                        phi_2217_ = array<f64, 3>((_e3542 - ((_e3563 * _e3620) + (_e3584 * _e3624))), (_e3543 - ((_e3564 * _e3620) + (_e3585 * _e3624))), (_e3544 - ((_e3565 * _e3620) + (_e3586 * _e3624))));
                                        phi_2218_ = false;
                                    } else {
                                        phi_2217_ = array<f64, 3>();
                                        phi_2218_ = true;
                                    }
                                    let _e3654 = phi_2217_;
                                    let _e3656 = phi_2218_;
                                    phi_2219_ = _e3654;
                                    phi_2220_ = _e3656;
                                } else {
                                    phi_2219_ = array<f64, 3>();
                                    phi_2220_ = true;
                                }
                                let _e3658 = phi_2219_;
                                let _e3660 = phi_2220_;
                                if _e3660 {
                                    let _e3661 = (_e3542 - _e3563);
                                    let _e3662 = (_e3543 - _e3564);
                                    let _e3663 = (_e3544 - _e3565);
                                    let _e3664 = (_e3584 - _e3563);
                                    let _e3665 = (_e3585 - _e3564);
                                    let _e3666 = (_e3586 - _e3565);
                                    let _e3677 = ((((_e3661 * _e3664) + (_e3662 * _e3665)) + (_e3663 * _e3666)) / (((_e3664 * _e3664) + (_e3665 * _e3665)) + (_e3666 * _e3666)));
                                    if (_e3677 > f64(0f)) {
                                        if (_e3677 < f64(1f)) {
                                            phi_2407_ = _e3677;
                                        } else {
                                            phi_2407_ = f64(1f);
                                        }
                                        let _e3685 = phi_2407_;
                                        phi_2409_ = _e3685;
                                    } else {
                                        phi_2409_ = f64(0f);
                                    }
                                    let _e3687 = phi_2409_;
                                    let _e3691 = (_e3661 - (_e3664 * _e3687));
                                    let _e3692 = (_e3662 - (_e3665 * _e3687));
                                    let _e3693 = (_e3663 - (_e3666 * _e3687));
                                    let _e3704 = ((((_e3542 * _e3563) + (_e3543 * _e3564)) + (_e3544 * _e3565)) / (((_e3563 * _e3563) + (_e3564 * _e3564)) + (_e3565 * _e3565)));
                                    if (_e3704 > f64(0f)) {
                                        if (_e3704 < f64(1f)) {
                                            phi_2439_ = _e3704;
                                        } else {
                                            phi_2439_ = f64(1f);
                                        }
                                        let _e3712 = phi_2439_;
                                        phi_2441_ = _e3712;
                                    } else {
                                        phi_2441_ = f64(0f);
                                    }
                                    let _e3714 = phi_2441_;
                                    let _e3731 = ((((_e3542 * _e3584) + (_e3543 * _e3585)) + (_e3544 * _e3586)) / (((_e3584 * _e3584) + (_e3585 * _e3585)) + (_e3586 * _e3586)));
                                    if (_e3731 > f64(0f)) {
                                        if (_e3731 < f64(1f)) {
                                            phi_2471_ = _e3731;
                                        } else {
                                            phi_2471_ = f64(1f);
                                        }
                                        let _e3739 = phi_2471_;
                                        phi_2473_ = _e3739;
                                    } else {
                                        phi_2473_ = f64(0f);
                                    }
                                    let _e3741 = phi_2473_;
                                    local_11[0u] = array<f64, 3>((_e3542 - (_e3563 * _e3714)), (_e3543 - (_e3564 * _e3714)), (_e3544 - (_e3565 * _e3714)));
                                    local_11[1u] = array<f64, 3>((_e3542 - (_e3584 * _e3741)), (_e3543 - (_e3585 * _e3741)), (_e3544 - (_e3586 * _e3741)));
                                    local_11[2u] = array<f64, 3>(_e3691, _e3692, _e3693);
                                    local_11[3u] = array<f64, 3>(_e3691, _e3692, _e3693);
                                    let _e3757 = local_11[0u];
                                    phi_2509_ = type_30(1u, 4u);
                                    phi_2512_ = array<f64, 3>(_e3757[0], _e3757[1], _e3757[2]);
                                    loop {
                                        let _e3763 = phi_2509_;
                                        let _e3765 = phi_2512_;
                                        local_74 = _e3765;
                                        if (_e3763.member < _e3763.member_1) {
                                            phi_2510_ = type_30((_e3763.member + 1u), _e3763.member_1);
                                            phi_2535_ = type_30(1u, _e3763.member);
                                        } else {
                                            phi_2510_ = _e3763;
                                            phi_2535_ = type_30(0u, type_30().member_1);
                                        }
                                        let _e3779 = phi_2510_;
                                        let _e3781 = phi_2535_;
                                        let _e3785 = (bitcast<i32>(_e3781.member) != 0i);
                                        if _e3785 {
                                            if (_e3781.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3788 = local_11[_e3781.member_1];
                                            if (_e3781.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3794 = local_11[_e3781.member_1];
                                            if ((((_e3788[0] * _e3794[0]) + (_e3788[1] * _e3794[1])) + (_e3788[2] * _e3794[2])) < (((_e3765[0] * _e3765[0]) + (_e3765[1] * _e3765[1])) + (_e3765[2] * _e3765[2]))) {
                                                if (_e3781.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3817 = local_11[_e3781.member_1];
                                                phi_2602_ = array<f64, 3>(_e3817[0], _e3817[1], _e3817[2]);
                                            } else {
                                                phi_2602_ = _e3765;
                                            }
                                            let _e3823 = phi_2602_;
                                            phi_2513_ = _e3823;
                                        } else {
                                            phi_2513_ = array<f64, 3>();
                                        }
                                        let _e3825 = phi_2513_;
                                        continue;
                                        continuing {
                                            phi_2509_ = _e3779;
                                            phi_2512_ = _e3825;
                                            break if !(_e3785);
                                        }
                                    }
                                    let _e5600 = local_74;
                                    phi_2603_ = _e5600;
                                } else {
                                    phi_2603_ = _e3658;
                                }
                                let _e3828 = phi_2603_;
                                if (_e3828[0] < 0.0lf) {
                                    phi_2610_ = -(_e3828[0]);
                                } else {
                                    phi_2610_ = _e3828[0];
                                }
                                let _e3833 = phi_2610_;
                                if (_e3828[1] < 0.0lf) {
                                    phi_2617_ = -(_e3828[1]);
                                } else {
                                    phi_2617_ = _e3828[1];
                                }
                                let _e3838 = phi_2617_;
                                if (_e3828[2] < 0.0lf) {
                                    phi_2625_ = -(_e3828[2]);
                                } else {
                                    phi_2625_ = _e3828[2];
                                }
                                let _e3844 = phi_2625_;
                                let _e3845 = ((_e3833 + _e3838) + _e3844);
                                if (_e3845 > f64(0f)) {
                                    if ((bitcast<u64>(_e3845) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e3851 = (f64(1f) / _e3845);
                                        let _e3853 = (_e3828[0] * _e3851);
                                        let _e3855 = (_e3828[1] * _e3851);
                                        let _e3857 = (_e3828[2] * _e3851);
                                        let _e3862 = (((_e3853 * _e3853) + (_e3855 * _e3855)) + (_e3857 * _e3857));
                                        if (_e3862 <= 2.2250738585072014e-308lf) {
                                            if (_e3862 > 0.0lf) {
                                                phi_2663_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2663_ = 0.0lf;
                                            }
                                            let _e3920 = phi_2663_;
                                            phi_2727_ = _e3920;
                                        } else {
                                            phi_2670_ = type_28(0i, 5i);
                                            phi_2673_ = bitcast<f64>(((bitcast<u64>(_e3862) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e3869 = phi_2670_;
                                                let _e3871 = phi_2673_;
                                                local_39 = _e3871;
                                                if (_e3869.member < _e3869.member_1) {
                                                    let _e3879 = (_e3869.member + 1i);
                                                    if ((false == (_e3879 > _e3869.member)) != false) {
                                                        phi_2694_ = true;
                                                    } else {
                                                        phi_2694_ = false;
                                                    }
                                                    let _e3884 = phi_2694_;
                                                    if _e3884 {
                                                        phi_2700_ = type_29(0u, type_29().member_1);
                                                    } else {
                                                        phi_2700_ = type_29(1u, _e3879);
                                                    }
                                                    let _e3890 = phi_2700_;
                                                    if (bitcast<i32>(_e3890.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2671_ = type_28(_e3890.member_1, _e3869.member_1);
                                                    phi_2714_ = type_29(1u, _e3869.member);
                                                } else {
                                                    phi_2671_ = _e3869;
                                                    phi_2714_ = type_29(0u, type_29().member_1);
                                                }
                                                let _e3900 = phi_2671_;
                                                let _e3902 = phi_2714_;
                                                let _e3905 = (bitcast<i32>(_e3902.member) != 0i);
                                                if _e3905 {
                                                    phi_2674_ = (0.5lf * (_e3871 + (_e3862 / _e3871)));
                                                } else {
                                                    phi_2674_ = f64();
                                                }
                                                let _e3910 = phi_2674_;
                                                continue;
                                                continuing {
                                                    phi_2670_ = _e3900;
                                                    phi_2673_ = _e3910;
                                                    break if !(_e3905);
                                                }
                                            }
                                            let _e3915 = local_39;
                                            phi_2727_ = (_e3915 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e3922 = phi_2727_;
                                        phi_2740_ = type_30(0u, 4u);
                                        phi_2743_ = f64(2f);
                                        loop {
                                            let _e3934 = phi_2740_;
                                            let _e3936 = phi_2743_;
                                            local_41 = _e3936;
                                            local_42 = _e3936;
                                            local_43 = _e3936;
                                            local_77 = _e3936;
                                            local_78 = _e3936;
                                            if (_e3934.member < _e3934.member_1) {
                                                phi_2741_ = type_30((_e3934.member + 1u), _e3934.member_1);
                                                phi_2766_ = type_30(1u, _e3934.member);
                                            } else {
                                                phi_2741_ = _e3934;
                                                phi_2766_ = type_30(0u, type_30().member_1);
                                            }
                                            let _e3950 = phi_2741_;
                                            let _e3952 = phi_2766_;
                                            if (bitcast<i32>(_e3952.member) != 0i) {
                                                if (_e3952.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3959 = local_12[_e3952.member_1];
                                                let _e3967 = (((_e3853 * _e3959[0]) + (_e3855 * _e3959[1])) + (_e3857 * _e3959[2]));
                                                if (_e3952.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3970 = local_13[_e3952.member_1];
                                                let _e3978 = (((_e3853 * _e3970[0]) + (_e3855 * _e3970[1])) + (_e3857 * _e3970[2]));
                                                if (_e3967 < 0.0lf) {
                                                    phi_2817_ = -(_e3967);
                                                } else {
                                                    phi_2817_ = _e3967;
                                                }
                                                let _e3982 = phi_2817_;
                                                if (_e3978 < 0.0lf) {
                                                    phi_2823_ = -(_e3978);
                                                } else {
                                                    phi_2823_ = _e3978;
                                                }
                                                let _e3986 = phi_2823_;
                                                let _e3991 = (((((((((_e3375 + _e3377) + (_e3429 + _e3431)) + (_e3483 + _e3485)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3493 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e447 * _e3922) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e3982 + _e3986) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e3967 > _e3991) {
                                                    if (_e3978 > _e3991) {
                                                        phi_2837_ = false;
                                                    } else {
                                                        phi_2837_ = true;
                                                    }
                                                    let _e3995 = phi_2837_;
                                                    phi_2838_ = _e3995;
                                                } else {
                                                    phi_2838_ = true;
                                                }
                                                let _e3997 = phi_2838_;
                                                if _e3997 {
                                                    if ((_e3967 + ((_e3978 - _e3967) * _e3504)) > _e3991) {
                                                        if (_e3978 < _e3967) {
                                                            let _e4006 = ((_e3967 - _e3978) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                            if _e4006 {
                                                                let _e4014 = (((_e3967 - _e3991) / (_e3967 - _e3978)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                if (_e3936 < _e4014) {
                                                                    phi_2872_ = _e3936;
                                                                } else {
                                                                    phi_2872_ = _e4014;
                                                                }
                                                                let _e4017 = phi_2872_;
                                                                phi_2873_ = _e4017;
                                                            } else {
                                                                phi_2873_ = f64();
                                                            }
                                                            let _e4019 = phi_2873_;
                                                            phi_2874_ = _e4019;
                                                            phi_2875_ = _e4006;
                                                        } else {
                                                            phi_2874_ = _e3936;
                                                            phi_2875_ = true;
                                                        }
                                                        let _e4021 = phi_2874_;
                                                        let _e4023 = phi_2875_;
                                                        if _e4023 {
                                                            phi_2879_ = false;
                                                        } else {
                                                            phi_2879_ = true;
                                                        }
                                                        let _e4025 = phi_2879_;
                                                        phi_2880_ = _e4021;
                                                        phi_2881_ = _e4023;
                                                        phi_2882_ = _e4025;
                                                        phi_2883_ = false;
                                                    } else {
                                                        phi_2880_ = f64();
                                                        phi_2881_ = false;
                                                        phi_2882_ = false;
                                                        phi_2883_ = true;
                                                    }
                                                    let _e4027 = phi_2880_;
                                                    let _e4029 = phi_2881_;
                                                    let _e4031 = phi_2882_;
                                                    let _e4033 = phi_2883_;
                                                    phi_2884_ = _e4027;
                                                    phi_2885_ = _e4029;
                                                    phi_2886_ = _e4031;
                                                    phi_2887_ = _e4033;
                                                } else {
                                                    phi_2884_ = _e3936;
                                                    phi_2885_ = true;
                                                    phi_2886_ = false;
                                                    phi_2887_ = false;
                                                }
                                                let _e4035 = phi_2884_;
                                                let _e4037 = phi_2885_;
                                                let _e4039 = phi_2886_;
                                                let _e4041 = phi_2887_;
                                                phi_2744_ = _e4035;
                                                phi_2888_ = _e4037;
                                                phi_2889_ = false;
                                                phi_2890_ = _e4039;
                                                phi_2891_ = _e4041;
                                            } else {
                                                phi_2744_ = f64();
                                                phi_2888_ = false;
                                                phi_2889_ = true;
                                                phi_2890_ = false;
                                                phi_2891_ = false;
                                            }
                                            let _e4043 = phi_2744_;
                                            let _e4045 = phi_2888_;
                                            let _e4047 = phi_2889_;
                                            let _e4049 = phi_2890_;
                                            let _e4051 = phi_2891_;
                                            local_40 = _e4047;
                                            local_75 = _e4049;
                                            local_76 = _e4051;
                                            continue;
                                            continuing {
                                                phi_2740_ = _e3950;
                                                phi_2743_ = _e4043;
                                                break if !(_e4045);
                                            }
                                        }
                                        let _e4054 = local_40;
                                        if _e4054 {
                                            let _e4056 = local_41;
                                            let _e4057 = (_e4056 > _e3269);
                                            if _e4057 {
                                                phi_2913_ = false;
                                                phi_2914_ = false;
                                                phi_2915_ = false;
                                            } else {
                                                let _e4059 = local_42;
                                                if (_e4059 > _e3504) {
                                                    let _e4062 = local_43;
                                                    let _e4065 = ((_e4062 - _e3504) < f64(0.00000000023283064f));
                                                    if _e4065 {
                                                        phi_2909_ = false;
                                                    } else {
                                                        phi_2909_ = true;
                                                    }
                                                    let _e4067 = phi_2909_;
                                                    phi_2910_ = _e4067;
                                                    phi_2911_ = _e4065;
                                                    phi_2912_ = false;
                                                } else {
                                                    phi_2910_ = false;
                                                    phi_2911_ = false;
                                                    phi_2912_ = true;
                                                }
                                                let _e4069 = phi_2910_;
                                                let _e4071 = phi_2911_;
                                                let _e4073 = phi_2912_;
                                                phi_2913_ = _e4069;
                                                phi_2914_ = _e4071;
                                                phi_2915_ = _e4073;
                                            }
                                            let _e4075 = phi_2913_;
                                            let _e4077 = phi_2914_;
                                            let _e4079 = phi_2915_;
                                            phi_2916_ = _e4075;
                                            phi_2917_ = _e4057;
                                            phi_2918_ = _e4077;
                                            phi_2919_ = _e4079;
                                            phi_2920_ = false;
                                            phi_2921_ = false;
                                        } else {
                                            phi_2916_ = false;
                                            phi_2917_ = false;
                                            phi_2918_ = false;
                                            phi_2919_ = false;
                                            let _e5657 = local_75;
                                            phi_2920_ = _e5657;
                                            let _e5660 = local_76;
                                            phi_2921_ = _e5660;
                                        }
                                        let _e4081 = phi_2916_;
                                        let _e4083 = phi_2917_;
                                        let _e4085 = phi_2918_;
                                        let _e4087 = phi_2919_;
                                        let _e4089 = phi_2920_;
                                        let _e4091 = phi_2921_;
                                        let _e5663 = local_77;
                                        phi_2922_ = _e5663;
                                        let _e5666 = local_78;
                                        phi_2923_ = _e5666;
                                        phi_2924_ = _e4081;
                                        phi_2925_ = _e4083;
                                        phi_2926_ = _e4085;
                                        phi_2927_ = _e4087;
                                        phi_2928_ = _e4089;
                                        phi_2929_ = _e4091;
                                        phi_2930_ = false;
                                    } else {
                                        phi_2922_ = f64();
                                        phi_2923_ = f64();
                                        phi_2924_ = false;
                                        phi_2925_ = false;
                                        phi_2926_ = false;
                                        phi_2927_ = false;
                                        phi_2928_ = false;
                                        phi_2929_ = false;
                                        phi_2930_ = true;
                                    }
                                    let _e4093 = phi_2922_;
                                    let _e4095 = phi_2923_;
                                    let _e4097 = phi_2924_;
                                    let _e4099 = phi_2925_;
                                    let _e4101 = phi_2926_;
                                    let _e4103 = phi_2927_;
                                    let _e4105 = phi_2928_;
                                    let _e4107 = phi_2929_;
                                    let _e4109 = phi_2930_;
                                    phi_2931_ = _e4093;
                                    phi_2932_ = _e4095;
                                    phi_2933_ = _e4097;
                                    phi_2934_ = _e4099;
                                    phi_2935_ = _e4101;
                                    phi_2936_ = _e4103;
                                    phi_2937_ = _e4105;
                                    phi_2938_ = _e4107;
                                    phi_2939_ = _e4109;
                                    phi_2940_ = false;
                                } else {
                                    phi_2931_ = f64();
                                    phi_2932_ = f64();
                                    phi_2933_ = false;
                                    phi_2934_ = false;
                                    phi_2935_ = false;
                                    phi_2936_ = false;
                                    phi_2937_ = false;
                                    phi_2938_ = false;
                                    phi_2939_ = false;
                                    phi_2940_ = true;
                                }
                                let _e4111 = phi_2931_;
                                let _e4113 = phi_2932_;
                                let _e4115 = phi_2933_;
                                let _e4117 = phi_2934_;
                                let _e4119 = phi_2935_;
                                let _e4121 = phi_2936_;
                                let _e4123 = phi_2937_;
                                let _e4125 = phi_2938_;
                                let _e4127 = phi_2939_;
                                let _e4129 = phi_2940_;
                                phi_2941_ = _e4111;
                                phi_1990_ = _e4113;
                                phi_2942_ = _e4115;
                                phi_2943_ = _e4117;
                                phi_2944_ = _e4119;
                                phi_2945_ = false;
                                phi_2946_ = _e4121;
                                phi_2947_ = _e4123;
                                phi_2948_ = _e4125;
                                phi_2949_ = _e4127;
                                phi_2950_ = _e4129;
                            } else {
                                phi_2941_ = f64();
                                phi_1990_ = f64();
                                phi_2942_ = false;
                                phi_2943_ = false;
                                phi_2944_ = false;
                                phi_2945_ = true;
                                phi_2946_ = false;
                                phi_2947_ = false;
                                phi_2948_ = false;
                                phi_2949_ = false;
                                phi_2950_ = false;
                            }
                            let _e4131 = phi_2941_;
                            let _e4133 = phi_1990_;
                            let _e4135 = phi_2942_;
                            let _e4137 = phi_2943_;
                            let _e4139 = phi_2944_;
                            let _e4141 = phi_2945_;
                            let _e4143 = phi_2946_;
                            let _e4145 = phi_2947_;
                            let _e4147 = phi_2948_;
                            let _e4149 = phi_2949_;
                            let _e4151 = phi_2950_;
                            local_44 = _e4137;
                            local_79 = _e4139;
                            local_80 = _e4141;
                            local_81 = _e4143;
                            local_82 = _e4145;
                            local_83 = _e4147;
                            local_84 = _e4149;
                            local_85 = _e4151;
                            local_86 = _e4131;
                            local_88 = _e4137;
                            continue;
                            continuing {
                                phi_1986_ = _e3518;
                                phi_1989_ = _e4133;
                                break if !(_e4135);
                            }
                        }
                        let _e4154 = local_44;
                        if _e4154 {
                            phi_2955_ = type_73(0u, type_73().member_1);
                            phi_2956_ = false;
                            phi_2957_ = false;
                            phi_2958_ = false;
                            phi_2959_ = false;
                            phi_2960_ = false;
                            phi_2961_ = false;
                            phi_2962_ = false;
                        } else {
                            phi_2955_ = type_73();
                            let _e5699 = local_79;
                            phi_2956_ = _e5699;
                            let _e5702 = local_80;
                            phi_2957_ = _e5702;
                            let _e5705 = local_81;
                            phi_2958_ = _e5705;
                            let _e5708 = local_82;
                            phi_2959_ = _e5708;
                            let _e5711 = local_83;
                            phi_2960_ = _e5711;
                            let _e5714 = local_84;
                            phi_2961_ = _e5714;
                            let _e5717 = local_85;
                            phi_2962_ = _e5717;
                        }
                        let _e4159 = phi_2955_;
                        let _e4161 = phi_2956_;
                        let _e4163 = phi_2957_;
                        let _e4165 = phi_2958_;
                        let _e4167 = phi_2959_;
                        let _e4169 = phi_2960_;
                        let _e4171 = phi_2961_;
                        let _e4173 = phi_2962_;
                        if _e4161 {
                            let _e5720 = local_86;
                            phi_2966_ = _e5720;
                            phi_2967_ = true;
                            phi_2968_ = false;
                            phi_2969_ = false;
                            phi_2970_ = false;
                            phi_2971_ = false;
                            phi_2972_ = false;
                            phi_2973_ = false;
                        } else {
                            let _e5722 = local_87;
                            phi_2966_ = _e5722;
                            phi_2967_ = _e4163;
                            phi_2968_ = _e4165;
                            phi_2969_ = _e4167;
                            phi_2970_ = _e4169;
                            let _e5729 = local_88;
                            phi_2971_ = _e5729;
                            phi_2972_ = _e4171;
                            phi_2973_ = _e4173;
                        }
                        let _e4175 = phi_2966_;
                        let _e4177 = phi_2967_;
                        let _e4179 = phi_2968_;
                        let _e4181 = phi_2969_;
                        let _e4183 = phi_2970_;
                        let _e4185 = phi_2971_;
                        let _e4187 = phi_2972_;
                        let _e4189 = phi_2973_;
                        if _e4177 {
                            phi_2978_ = type_73(1u, _e4175);
                            phi_2979_ = false;
                            phi_2980_ = false;
                            phi_2981_ = false;
                            phi_2982_ = false;
                            phi_2983_ = false;
                            phi_2984_ = false;
                        } else {
                            phi_2978_ = type_73();
                            phi_2979_ = _e4179;
                            phi_2980_ = _e4181;
                            phi_2981_ = _e4183;
                            phi_2982_ = _e4185;
                            phi_2983_ = _e4187;
                            phi_2984_ = _e4189;
                        }
                        let _e4192 = phi_2978_;
                        let _e4194 = phi_2979_;
                        let _e4196 = phi_2980_;
                        let _e4198 = phi_2981_;
                        let _e4200 = phi_2982_;
                        let _e4202 = phi_2983_;
                        let _e4204 = phi_2984_;
                        if _e4194 {
                            let _e4206 = local_45;
                            phi_2989_ = type_73(1u, _e4206);
                            phi_2990_ = false;
                            phi_2991_ = false;
                            phi_2992_ = true;
                            phi_2993_ = false;
                            phi_2994_ = false;
                        } else {
                            phi_2989_ = _e4159;
                            phi_2990_ = _e4196;
                            phi_2991_ = _e4198;
                            phi_2992_ = _e4200;
                            phi_2993_ = _e4202;
                            phi_2994_ = _e4204;
                        }
                        let _e4209 = phi_2989_;
                        let _e4211 = phi_2990_;
                        let _e4213 = phi_2991_;
                        let _e4215 = phi_2992_;
                        let _e4217 = phi_2993_;
                        let _e4219 = phi_2994_;
                        if _e4211 {
                            let _e4221 = local_46;
                            phi_2999_ = type_73(1u, _e4221);
                            phi_3000_ = false;
                            phi_3001_ = false;
                            phi_3002_ = false;
                            phi_3003_ = false;
                        } else {
                            phi_2999_ = type_73();
                            phi_3000_ = _e4213;
                            phi_3001_ = _e4215;
                            phi_3002_ = _e4217;
                            phi_3003_ = _e4219;
                        }
                        let _e4224 = phi_2999_;
                        let _e4226 = phi_3000_;
                        let _e4228 = phi_3001_;
                        let _e4230 = phi_3002_;
                        let _e4232 = phi_3003_;
                        if _e4226 {
                            let _e4234 = local_47;
                            phi_3008_ = type_73(1u, _e4234);
                            phi_3009_ = true;
                            phi_3010_ = false;
                            phi_3011_ = false;
                            phi_3012_ = false;
                        } else {
                            phi_3008_ = _e4224;
                            phi_3009_ = _e4211;
                            phi_3010_ = _e4228;
                            phi_3011_ = _e4230;
                            phi_3012_ = _e4232;
                        }
                        let _e4237 = phi_3008_;
                        let _e4239 = phi_3009_;
                        let _e4241 = phi_3010_;
                        let _e4243 = phi_3011_;
                        let _e4245 = phi_3012_;
                        if _e4239 {
                            phi_3016_ = _e4237;
                            phi_3017_ = true;
                            phi_3018_ = false;
                            phi_3019_ = false;
                        } else {
                            phi_3016_ = _e4209;
                            phi_3017_ = _e4241;
                            phi_3018_ = _e4243;
                            phi_3019_ = _e4245;
                        }
                        let _e4247 = phi_3016_;
                        let _e4249 = phi_3017_;
                        let _e4251 = phi_3018_;
                        let _e4253 = phi_3019_;
                        if _e4249 {
                            phi_3023_ = false;
                            phi_3024_ = false;
                        } else {
                            phi_3023_ = _e4251;
                            phi_3024_ = _e4253;
                        }
                        let _e4255 = phi_3023_;
                        let _e4257 = phi_3024_;
                        if _e4255 {
                            phi_3028_ = false;
                            phi_3029_ = false;
                        } else {
                            phi_3028_ = _e4257;
                            phi_3029_ = _e4249;
                        }
                        let _e4259 = phi_3028_;
                        let _e4261 = phi_3029_;
                        if _e4259 {
                            phi_3033_ = true;
                            phi_3034_ = false;
                        } else {
                            phi_3033_ = _e4255;
                            phi_3034_ = _e4261;
                        }
                        let _e4263 = phi_3033_;
                        let _e4265 = phi_3034_;
                        if _e4263 {
                            let _e4267 = local_48;
                            phi_3039_ = type_73(1u, _e4267);
                            phi_3040_ = true;
                        } else {
                            phi_3039_ = _e4247;
                            phi_3040_ = _e4265;
                        }
                        let _e4270 = phi_3039_;
                        let _e4272 = phi_3040_;
                        if _e4272 {
                            phi_3044_ = _e4270;
                        } else {
                            phi_3044_ = _e4192;
                        }
                        let _e4274 = phi_3044_;
                        if (_e4274.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_3058_ = type_30(0u, 3u);
                            loop {
                                let _e4287 = phi_3058_;
                                if (_e4287.member < _e4287.member_1) {
                                    phi_3059_ = type_30((_e4287.member + 1u), _e4287.member_1);
                                    phi_3082_ = type_30(1u, _e4287.member);
                                } else {
                                    phi_3059_ = _e4287;
                                    phi_3082_ = type_30(0u, type_30().member_1);
                                }
                                let _e4301 = phi_3059_;
                                let _e4303 = phi_3082_;
                                if (bitcast<i32>(_e4303.member) != 0i) {
                                    if (_e4303.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4310 = local_14[_e4303.member_1];
                                    let _e4312 = (_e4274.member_1 + f64(_e4310));
                                    if (_e4312 < _e3269) {
                                        phi_3103_ = _e4312;
                                    } else {
                                        phi_3103_ = _e3269;
                                    }
                                    let _e4315 = phi_3103_;
                                    let _e4318 = local_20.member[0u];
                                    let _e4324 = local_20.member[1u];
                                    let _e4334 = (_e4318[0] + ((_e4324[0] - _e4318[0]) * _e4315));
                                    let _e4335 = (_e4318[1] + ((_e4324[1] - _e4318[1]) * _e4315));
                                    let _e4336 = (_e4318[2] + ((_e4324[2] - _e4318[2]) * _e4315));
                                    let _e4339 = local_20.member_1[0u];
                                    let _e4345 = local_20.member_1[1u];
                                    let _e4355 = (_e4339[0] + ((_e4345[0] - _e4339[0]) * _e4315));
                                    let _e4356 = (_e4339[1] + ((_e4345[1] - _e4339[1]) * _e4315));
                                    let _e4357 = (_e4339[2] + ((_e4345[2] - _e4339[2]) * _e4315));
                                    let _e4360 = local_20.member_2[0u];
                                    let _e4366 = local_20.member_2[1u];
                                    let _e4376 = (_e4360[0] + ((_e4366[0] - _e4360[0]) * _e4315));
                                    let _e4377 = (_e4360[1] + ((_e4366[1] - _e4360[1]) * _e4315));
                                    let _e4378 = (_e4360[2] + ((_e4366[2] - _e4360[2]) * _e4315));
                                    let _e4383 = (((_e4355 * _e4355) + (_e4356 * _e4356)) + (_e4357 * _e4357));
                                    let _e4388 = (((_e4355 * _e4376) + (_e4356 * _e4377)) + (_e4357 * _e4378));
                                    let _e4393 = (((_e4376 * _e4376) + (_e4377 * _e4377)) + (_e4378 * _e4378));
                                    let _e4398 = (((_e4334 * _e4355) + (_e4335 * _e4356)) + (_e4336 * _e4357));
                                    let _e4403 = (((_e4334 * _e4376) + (_e4335 * _e4377)) + (_e4336 * _e4378));
                                    let _e4406 = ((_e4383 * _e4393) - (_e4388 * _e4388));
                                    let _e4407 = f64(0f);
                                    let _e4412 = (((_e4398 * _e4393) - (_e4403 * _e4388)) / _e4406);
                                    let _e4416 = (((_e4403 * _e4383) - (_e4398 * _e4388)) / _e4406);
                                    if (_e4412 >= _e4407) {
                                        if (_e4416 >= _e4407) {
                                            phi_3273_ = ((_e4412 + _e4416) <= f64(1f));
                                            phi_3274_ = false;
                                        } else {
                                            phi_3273_ = bool();
                                            phi_3274_ = true;
                                        }
                                        let _e4422 = phi_3273_;
                                        let _e4424 = phi_3274_;
                                        phi_3275_ = _e4422;
                                        phi_3276_ = _e4424;
                                    } else {
                                        phi_3275_ = bool();
                                        phi_3276_ = true;
                                    }
                                    let _e4426 = phi_3275_;
                                    let _e4428 = phi_3276_;
                                    if _e4428 {
                                        phi_3280_ = false;
                                    } else {
                                        phi_3280_ = _e4426;
                                    }
                                    let _e4430 = phi_3280_;
                                    if (_e4406 > _e4407) {
                                        if _e4430 {
                                            phi_3302_ = array<f64, 3>((_e4334 - ((_e4355 * _e4412) + (_e4376 * _e4416))), (_e4335 - ((_e4356 * _e4412) + (_e4377 * _e4416))), (_e4336 - ((_e4357 * _e4412) + (_e4378 * _e4416))));
                                            phi_3303_ = false;
                                        } else {
                                            phi_3302_ = array<f64, 3>();
                                            phi_3303_ = true;
                                        }
                                        let _e4446 = phi_3302_;
                                        let _e4448 = phi_3303_;
                                        phi_3304_ = _e4446;
                                        phi_3305_ = _e4448;
                                    } else {
                                        phi_3304_ = array<f64, 3>();
                                        phi_3305_ = true;
                                    }
                                    let _e4450 = phi_3304_;
                                    let _e4452 = phi_3305_;
                                    if _e4452 {
                                        let _e4453 = (_e4334 - _e4355);
                                        let _e4454 = (_e4335 - _e4356);
                                        let _e4455 = (_e4336 - _e4357);
                                        let _e4456 = (_e4376 - _e4355);
                                        let _e4457 = (_e4377 - _e4356);
                                        let _e4458 = (_e4378 - _e4357);
                                        let _e4469 = ((((_e4453 * _e4456) + (_e4454 * _e4457)) + (_e4455 * _e4458)) / (((_e4456 * _e4456) + (_e4457 * _e4457)) + (_e4458 * _e4458)));
                                        if (_e4469 > f64(0f)) {
                                            if (_e4469 < f64(1f)) {
                                                phi_3492_ = _e4469;
                                            } else {
                                                phi_3492_ = f64(1f);
                                            }
                                            let _e4477 = phi_3492_;
                                            phi_3494_ = _e4477;
                                        } else {
                                            phi_3494_ = f64(0f);
                                        }
                                        let _e4479 = phi_3494_;
                                        let _e4483 = (_e4453 - (_e4456 * _e4479));
                                        let _e4484 = (_e4454 - (_e4457 * _e4479));
                                        let _e4485 = (_e4455 - (_e4458 * _e4479));
                                        let _e4496 = ((((_e4334 * _e4355) + (_e4335 * _e4356)) + (_e4336 * _e4357)) / (((_e4355 * _e4355) + (_e4356 * _e4356)) + (_e4357 * _e4357)));
                                        if (_e4496 > f64(0f)) {
                                            if (_e4496 < f64(1f)) {
                                                phi_3524_ = _e4496;
                                            } else {
                                                phi_3524_ = f64(1f);
                                            }
                                            let _e4504 = phi_3524_;
                                            phi_3526_ = _e4504;
                                        } else {
                                            phi_3526_ = f64(0f);
                                        }
                                        let _e4506 = phi_3526_;
                                        let _e4523 = ((((_e4334 * _e4376) + (_e4335 * _e4377)) + (_e4336 * _e4378)) / (((_e4376 * _e4376) + (_e4377 * _e4377)) + (_e4378 * _e4378)));
                                        if (_e4523 > f64(0f)) {
                                            if (_e4523 < f64(1f)) {
                                                phi_3556_ = _e4523;
                                            } else {
                                                phi_3556_ = f64(1f);
                                            }
                                            let _e4531 = phi_3556_;
                                            phi_3558_ = _e4531;
                                        } else {
                                            phi_3558_ = f64(0f);
                                        }
                                        let _e4533 = phi_3558_;
                                        local_10[0u] = array<f64, 3>((_e4334 - (_e4355 * _e4506)), (_e4335 - (_e4356 * _e4506)), (_e4336 - (_e4357 * _e4506)));
                                        local_10[1u] = array<f64, 3>((_e4334 - (_e4376 * _e4533)), (_e4335 - (_e4377 * _e4533)), (_e4336 - (_e4378 * _e4533)));
                                        local_10[2u] = array<f64, 3>(_e4483, _e4484, _e4485);
                                        local_10[3u] = array<f64, 3>(_e4483, _e4484, _e4485);
                                        let _e4549 = local_10[0u];
                                        phi_3594_ = type_30(1u, 4u);
                                        phi_3597_ = array<f64, 3>(_e4549[0], _e4549[1], _e4549[2]);
                                        loop {
                                            let _e4555 = phi_3594_;
                                            let _e4557 = phi_3597_;
                                            local_89 = _e4557;
                                            if (_e4555.member < _e4555.member_1) {
                                                phi_3595_ = type_30((_e4555.member + 1u), _e4555.member_1);
                                                phi_3620_ = type_30(1u, _e4555.member);
                                            } else {
                                                phi_3595_ = _e4555;
                                                phi_3620_ = type_30(0u, type_30().member_1);
                                            }
                                            let _e4571 = phi_3595_;
                                            let _e4573 = phi_3620_;
                                            let _e4577 = (bitcast<i32>(_e4573.member) != 0i);
                                            if _e4577 {
                                                if (_e4573.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4580 = local_10[_e4573.member_1];
                                                if (_e4573.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4586 = local_10[_e4573.member_1];
                                                if ((((_e4580[0] * _e4586[0]) + (_e4580[1] * _e4586[1])) + (_e4580[2] * _e4586[2])) < (((_e4557[0] * _e4557[0]) + (_e4557[1] * _e4557[1])) + (_e4557[2] * _e4557[2]))) {
                                                    if (_e4573.member_1 < 4u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e4609 = local_10[_e4573.member_1];
                                                    phi_3687_ = array<f64, 3>(_e4609[0], _e4609[1], _e4609[2]);
                                                } else {
                                                    phi_3687_ = _e4557;
                                                }
                                                let _e4615 = phi_3687_;
                                                phi_3598_ = _e4615;
                                            } else {
                                                phi_3598_ = array<f64, 3>();
                                            }
                                            let _e4617 = phi_3598_;
                                            continue;
                                            continuing {
                                                phi_3594_ = _e4571;
                                                phi_3597_ = _e4617;
                                                break if !(_e4577);
                                            }
                                        }
                                        let _e5799 = local_89;
                                        phi_3688_ = _e5799;
                                    } else {
                                        phi_3688_ = _e4450;
                                    }
                                    let _e4620 = phi_3688_;
                                    let _e4631 = (((_e4620[0] * _e4620[0]) + (_e4620[1] * _e4620[1])) + (_e4620[2] * _e4620[2]));
                                    if (_e4631 <= 2.2250738585072014e-308lf) {
                                        if (_e4631 > 0.0lf) {
                                            phi_3713_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3713_ = 0.0lf;
                                        }
                                        let _e4689 = phi_3713_;
                                        phi_3777_ = _e4689;
                                    } else {
                                        phi_3720_ = type_28(0i, 5i);
                                        phi_3723_ = bitcast<f64>(((bitcast<u64>(_e4631) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e4638 = phi_3720_;
                                            let _e4640 = phi_3723_;
                                            local_49 = _e4640;
                                            if (_e4638.member < _e4638.member_1) {
                                                let _e4648 = (_e4638.member + 1i);
                                                if ((false == (_e4648 > _e4638.member)) != false) {
                                                    phi_3744_ = true;
                                                } else {
                                                    phi_3744_ = false;
                                                }
                                                let _e4653 = phi_3744_;
                                                if _e4653 {
                                                    phi_3750_ = type_29(0u, type_29().member_1);
                                                } else {
                                                    phi_3750_ = type_29(1u, _e4648);
                                                }
                                                let _e4659 = phi_3750_;
                                                if (bitcast<i32>(_e4659.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3721_ = type_28(_e4659.member_1, _e4638.member_1);
                                                phi_3764_ = type_29(1u, _e4638.member);
                                            } else {
                                                phi_3721_ = _e4638;
                                                phi_3764_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e4669 = phi_3721_;
                                            let _e4671 = phi_3764_;
                                            let _e4674 = (bitcast<i32>(_e4671.member) != 0i);
                                            if _e4674 {
                                                phi_3724_ = (0.5lf * (_e4640 + (_e4631 / _e4640)));
                                            } else {
                                                phi_3724_ = f64();
                                            }
                                            let _e4679 = phi_3724_;
                                            continue;
                                            continuing {
                                                phi_3720_ = _e4669;
                                                phi_3723_ = _e4679;
                                                break if !(_e4674);
                                            }
                                        }
                                        let _e4684 = local_49;
                                        phi_3777_ = (_e4684 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e4691 = phi_3777_;
                                    let _e4699 = local_20.member[0u];
                                    if (_e4699[0] < 0.0lf) {
                                        phi_3795_ = -(_e4699[0]);
                                    } else {
                                        phi_3795_ = _e4699[0];
                                    }
                                    let _e4706 = phi_3795_;
                                    if (_e4699[1] < 0.0lf) {
                                        phi_3802_ = -(_e4699[1]);
                                    } else {
                                        phi_3802_ = _e4699[1];
                                    }
                                    let _e4710 = phi_3802_;
                                    if (_e4706 > _e4710) {
                                        phi_3807_ = _e4706;
                                    } else {
                                        phi_3807_ = _e4710;
                                    }
                                    let _e4713 = phi_3807_;
                                    if (_e4699[2] < 0.0lf) {
                                        phi_3814_ = -(_e4699[2]);
                                    } else {
                                        phi_3814_ = _e4699[2];
                                    }
                                    let _e4717 = phi_3814_;
                                    if (_e4713 > _e4717) {
                                        phi_3819_ = _e4713;
                                    } else {
                                        phi_3819_ = _e4717;
                                    }
                                    let _e4720 = phi_3819_;
                                    let _e4723 = local_20.member[1u];
                                    if (_e4723[0] < 0.0lf) {
                                        phi_3832_ = -(_e4723[0]);
                                    } else {
                                        phi_3832_ = _e4723[0];
                                    }
                                    let _e4730 = phi_3832_;
                                    if (_e4723[1] < 0.0lf) {
                                        phi_3839_ = -(_e4723[1]);
                                    } else {
                                        phi_3839_ = _e4723[1];
                                    }
                                    let _e4734 = phi_3839_;
                                    if (_e4730 > _e4734) {
                                        phi_3844_ = _e4730;
                                    } else {
                                        phi_3844_ = _e4734;
                                    }
                                    let _e4737 = phi_3844_;
                                    if (_e4723[2] < 0.0lf) {
                                        phi_3851_ = -(_e4723[2]);
                                    } else {
                                        phi_3851_ = _e4723[2];
                                    }
                                    let _e4741 = phi_3851_;
                                    if (_e4737 > _e4741) {
                                        phi_3856_ = _e4737;
                                    } else {
                                        phi_3856_ = _e4741;
                                    }
                                    let _e4744 = phi_3856_;
                                    if (_e4720 > _e4744) {
                                        phi_3861_ = _e4720;
                                    } else {
                                        phi_3861_ = _e4744;
                                    }
                                    let _e4747 = phi_3861_;
                                    let _e4749 = local_20.member_3;
                                    let _e4753 = local_20.member_1[0u];
                                    if (_e4753[0] < 0.0lf) {
                                        phi_3878_ = -(_e4753[0]);
                                    } else {
                                        phi_3878_ = _e4753[0];
                                    }
                                    let _e4760 = phi_3878_;
                                    if (_e4753[1] < 0.0lf) {
                                        phi_3885_ = -(_e4753[1]);
                                    } else {
                                        phi_3885_ = _e4753[1];
                                    }
                                    let _e4764 = phi_3885_;
                                    if (_e4760 > _e4764) {
                                        phi_3890_ = _e4760;
                                    } else {
                                        phi_3890_ = _e4764;
                                    }
                                    let _e4767 = phi_3890_;
                                    if (_e4753[2] < 0.0lf) {
                                        phi_3897_ = -(_e4753[2]);
                                    } else {
                                        phi_3897_ = _e4753[2];
                                    }
                                    let _e4771 = phi_3897_;
                                    if (_e4767 > _e4771) {
                                        phi_3902_ = _e4767;
                                    } else {
                                        phi_3902_ = _e4771;
                                    }
                                    let _e4774 = phi_3902_;
                                    let _e4777 = local_20.member_1[1u];
                                    if (_e4777[0] < 0.0lf) {
                                        phi_3916_ = -(_e4777[0]);
                                    } else {
                                        phi_3916_ = _e4777[0];
                                    }
                                    let _e4784 = phi_3916_;
                                    if (_e4777[1] < 0.0lf) {
                                        phi_3923_ = -(_e4777[1]);
                                    } else {
                                        phi_3923_ = _e4777[1];
                                    }
                                    let _e4788 = phi_3923_;
                                    if (_e4784 > _e4788) {
                                        phi_3928_ = _e4784;
                                    } else {
                                        phi_3928_ = _e4788;
                                    }
                                    let _e4791 = phi_3928_;
                                    if (_e4777[2] < 0.0lf) {
                                        phi_3935_ = -(_e4777[2]);
                                    } else {
                                        phi_3935_ = _e4777[2];
                                    }
                                    let _e4795 = phi_3935_;
                                    if (_e4791 > _e4795) {
                                        phi_3940_ = _e4791;
                                    } else {
                                        phi_3940_ = _e4795;
                                    }
                                    let _e4798 = phi_3940_;
                                    if (_e4774 > _e4798) {
                                        phi_3945_ = _e4774;
                                    } else {
                                        phi_3945_ = _e4798;
                                    }
                                    let _e4801 = phi_3945_;
                                    let _e4803 = local_20.member_3;
                                    let _e4807 = local_20.member_2[0u];
                                    if (_e4807[0] < 0.0lf) {
                                        phi_3962_ = -(_e4807[0]);
                                    } else {
                                        phi_3962_ = _e4807[0];
                                    }
                                    let _e4814 = phi_3962_;
                                    if (_e4807[1] < 0.0lf) {
                                        phi_3969_ = -(_e4807[1]);
                                    } else {
                                        phi_3969_ = _e4807[1];
                                    }
                                    let _e4818 = phi_3969_;
                                    if (_e4814 > _e4818) {
                                        phi_3974_ = _e4814;
                                    } else {
                                        phi_3974_ = _e4818;
                                    }
                                    let _e4821 = phi_3974_;
                                    if (_e4807[2] < 0.0lf) {
                                        phi_3981_ = -(_e4807[2]);
                                    } else {
                                        phi_3981_ = _e4807[2];
                                    }
                                    let _e4825 = phi_3981_;
                                    if (_e4821 > _e4825) {
                                        phi_3986_ = _e4821;
                                    } else {
                                        phi_3986_ = _e4825;
                                    }
                                    let _e4828 = phi_3986_;
                                    let _e4831 = local_20.member_2[1u];
                                    if (_e4831[0] < 0.0lf) {
                                        phi_4000_ = -(_e4831[0]);
                                    } else {
                                        phi_4000_ = _e4831[0];
                                    }
                                    let _e4838 = phi_4000_;
                                    if (_e4831[1] < 0.0lf) {
                                        phi_4007_ = -(_e4831[1]);
                                    } else {
                                        phi_4007_ = _e4831[1];
                                    }
                                    let _e4842 = phi_4007_;
                                    if (_e4838 > _e4842) {
                                        phi_4012_ = _e4838;
                                    } else {
                                        phi_4012_ = _e4842;
                                    }
                                    let _e4845 = phi_4012_;
                                    if (_e4831[2] < 0.0lf) {
                                        phi_4019_ = -(_e4831[2]);
                                    } else {
                                        phi_4019_ = _e4831[2];
                                    }
                                    let _e4849 = phi_4019_;
                                    if (_e4845 > _e4849) {
                                        phi_4024_ = _e4845;
                                    } else {
                                        phi_4024_ = _e4849;
                                    }
                                    let _e4852 = phi_4024_;
                                    if (_e4828 > _e4852) {
                                        phi_4029_ = _e4828;
                                    } else {
                                        phi_4029_ = _e4852;
                                    }
                                    let _e4855 = phi_4029_;
                                    let _e4857 = local_20.member_3;
                                    let _e4865 = local_20.member_3;
                                    let _e4875 = (((_e4691 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e4747 + _e4749) + (_e4801 + _e4803)) + (_e4855 + _e4857)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4865 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e447);
                                    if _e4875 {
                                        phi_4053_ = false;
                                    } else {
                                        phi_4053_ = true;
                                    }
                                    let _e4877 = phi_4053_;
                                    phi_4054_ = _e4877;
                                    phi_4055_ = _e4875;
                                } else {
                                    phi_4054_ = false;
                                    phi_4055_ = false;
                                }
                                let _e4879 = phi_4054_;
                                let _e4881 = phi_4055_;
                                local_50 = _e4881;
                                continue;
                                continuing {
                                    phi_3058_ = _e4301;
                                    break if !(_e4879);
                                }
                            }
                            let _e4884 = local_50;
                            if _e4884 {
                                phi_4060_ = type_73(1u, _e4274.member_1);
                                phi_4061_ = false;
                            } else {
                                phi_4060_ = type_73();
                                phi_4061_ = true;
                            }
                            let _e4887 = phi_4060_;
                            let _e4889 = phi_4061_;
                            if _e4889 {
                                phi_4066_ = type_73(2u, _e4274.member_1);
                                phi_4067_ = false;
                            } else {
                                phi_4066_ = type_73();
                                phi_4067_ = true;
                            }
                            let _e4892 = phi_4066_;
                            let _e4894 = phi_4067_;
                            phi_4069_ = _e4892;
                            phi_4070_ = _e4887;
                            phi_4071_ = _e4894;
                        } else {
                            phi_4069_ = type_73();
                            phi_4070_ = type_73(0u, type_73().member_1);
                            phi_4071_ = true;
                        }
                        let _e4896 = phi_4069_;
                        let _e4898 = phi_4070_;
                        let _e4900 = phi_4071_;
                        if _e4900 {
                            phi_4075_ = _e4898;
                        } else {
                            phi_4075_ = _e4896;
                        }
                        let _e4902 = phi_4075_;
                        phi_7446_ = _e4902;
                    } else {
                        if (_e546 < 0.0lf) {
                            phi_4086_ = -(_e546);
                        } else {
                            phi_4086_ = _e546;
                        }
                        let _e901 = phi_4086_;
                        if (_e569 < 0.0lf) {
                            phi_4092_ = -(_e569);
                        } else {
                            phi_4092_ = _e569;
                        }
                        let _e905 = phi_4092_;
                        if (_e901 > _e905) {
                            phi_4097_ = _e901;
                        } else {
                            phi_4097_ = _e905;
                        }
                        let _e908 = phi_4097_;
                        if (_e592 < 0.0lf) {
                            phi_4103_ = -(_e592);
                        } else {
                            phi_4103_ = _e592;
                        }
                        let _e912 = phi_4103_;
                        if (_e603 < 0.0lf) {
                            phi_4109_ = -(_e603);
                        } else {
                            phi_4109_ = _e603;
                        }
                        let _e916 = phi_4109_;
                        if (_e912 > _e916) {
                            phi_4114_ = _e912;
                        } else {
                            phi_4114_ = _e916;
                        }
                        let _e919 = phi_4114_;
                        if (_e908 > _e919) {
                            phi_4119_ = _e908;
                        } else {
                            phi_4119_ = _e919;
                        }
                        let _e922 = phi_4119_;
                        let _e924 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e925 = f64(1f);
                        if (_e922 >= _e924) {
                            phi_4129_ = (_e922 <= (_e925 / _e924));
                        } else {
                            phi_4129_ = false;
                        }
                        let _e930 = phi_4129_;
                        if _e930 {
                            phi_4136_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_4136_ = f64(2f);
                        }
                        let _e935 = phi_4136_;
                        let _e937 = ((_e862 * f64(0.34f)) + (_e922 * _e935));
                        if _e930 {
                            phi_4144_ = (_e925 / _e922);
                        } else {
                            phi_4144_ = f64(0f);
                        }
                        let _e941 = phi_4144_;
                        let _e942 = f64(0f);
                        let _e943 = f64(1f);
                        let _e944 = f64(3f);
                        let _e950 = ((_e569 - (_e944 * _e546)) * _e941);
                        let _e951 = ((_e592 - _e569) * _e941);
                        let _e952 = (((_e944 * _e603) - _e592) * _e941);
                        local_7[0u] = _e942;
                        local_7[1u] = _e943;
                        local_7[2u] = _e943;
                        local_7[3u] = _e943;
                        let _e959 = ((_e951 * _e951) - (_e950 * _e952));
                        if (_e959 > _e942) {
                            if (_e959 <= 2.2250738585072014e-308lf) {
                                if (_e959 > 0.0lf) {
                                    phi_4180_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4180_ = 0.0lf;
                                }
                                let _e1018 = phi_4180_;
                                phi_4244_ = _e1018;
                            } else {
                                phi_4187_ = type_28(0i, 5i);
                                phi_4190_ = bitcast<f64>(((bitcast<u64>(_e959) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e967 = phi_4187_;
                                    let _e969 = phi_4190_;
                                    local_21 = _e969;
                                    if (_e967.member < _e967.member_1) {
                                        let _e977 = (_e967.member + 1i);
                                        if ((false == (_e977 > _e967.member)) != false) {
                                            phi_4211_ = true;
                                        } else {
                                            phi_4211_ = false;
                                        }
                                        let _e982 = phi_4211_;
                                        if _e982 {
                                            phi_4217_ = type_29(0u, type_29().member_1);
                                        } else {
                                            phi_4217_ = type_29(1u, _e977);
                                        }
                                        let _e988 = phi_4217_;
                                        if (bitcast<i32>(_e988.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_4188_ = type_28(_e988.member_1, _e967.member_1);
                                        phi_4231_ = type_29(1u, _e967.member);
                                    } else {
                                        phi_4188_ = _e967;
                                        phi_4231_ = type_29(0u, type_29().member_1);
                                    }
                                    let _e998 = phi_4188_;
                                    let _e1000 = phi_4231_;
                                    let _e1003 = (bitcast<i32>(_e1000.member) != 0i);
                                    if _e1003 {
                                        phi_4191_ = (0.5lf * (_e969 + (_e959 / _e969)));
                                    } else {
                                        phi_4191_ = f64();
                                    }
                                    let _e1008 = phi_4191_;
                                    continue;
                                    continuing {
                                        phi_4187_ = _e998;
                                        phi_4190_ = _e1008;
                                        break if !(_e1003);
                                    }
                                }
                                let _e1013 = local_21;
                                phi_4244_ = (_e1013 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1020 = phi_4244_;
                            if (_e951 < _e942) {
                                phi_4250_ = -(_e1020);
                            } else {
                                phi_4250_ = _e1020;
                            }
                            let _e1024 = phi_4250_;
                            let _e1026 = -((_e951 + _e1024));
                            local_8[0u] = (_e1026 / (_e1026 + _e952));
                            local_8[1u] = (_e950 / (_e950 + _e1026));
                            let _e1035 = local_8[1u];
                            let _e1036 = local_8[0u];
                            if (_e1035 < _e1036) {
                                let _e1039 = local_8[1u];
                                let _e1041 = local_8[0u];
                                local_8[0u] = _e1039;
                                local_8[1u] = _e1041;
                            }
                            phi_4275_ = type_30(0u, 2u);
                            phi_4278_ = 1u;
                            loop {
                                let _e1045 = phi_4275_;
                                let _e1047 = phi_4278_;
                                local_51 = _e1047;
                                if (_e1045.member < _e1045.member_1) {
                                    phi_4276_ = type_30((_e1045.member + 1u), _e1045.member_1);
                                    phi_4301_ = type_30(1u, _e1045.member);
                                } else {
                                    phi_4276_ = _e1045;
                                    phi_4301_ = type_30(0u, type_30().member_1);
                                }
                                let _e1061 = phi_4276_;
                                let _e1063 = phi_4301_;
                                let _e1067 = (bitcast<i32>(_e1063.member) != 0i);
                                if _e1067 {
                                    if (_e1063.member_1 < 2u) {
                                    } else {
                                        return;
                                    }
                                    let _e1070 = local_8[_e1063.member_1];
                                    if (_e1070 > _e942) {
                                        if (_e1063.member_1 < 2u) {
                                        } else {
                                            return;
                                        }
                                        let _e1074 = local_8[_e1063.member_1];
                                        if (_e1074 < _e943) {
                                            if (_e1063.member_1 < 2u) {
                                            } else {
                                                return;
                                            }
                                            let _e1078 = local_8[_e1063.member_1];
                                            if (_e1047 < 4u) {
                                            } else {
                                                return;
                                            }
                                            local_7[_e1047] = _e1078;
                                            phi_4345_ = (_e1047 + 1u);
                                        } else {
                                            phi_4345_ = _e1047;
                                        }
                                        let _e1083 = phi_4345_;
                                        phi_4346_ = _e1083;
                                    } else {
                                        phi_4346_ = _e1047;
                                    }
                                    let _e1085 = phi_4346_;
                                    phi_4279_ = _e1085;
                                } else {
                                    phi_4279_ = u32();
                                }
                                let _e1087 = phi_4279_;
                                continue;
                                continuing {
                                    phi_4275_ = _e1061;
                                    phi_4278_ = _e1087;
                                    break if !(_e1067);
                                }
                            }
                            let _e5089 = local_51;
                            phi_4347_ = _e5089;
                        } else {
                            phi_4347_ = 1u;
                        }
                        let _e1090 = phi_4347_;
                        if (_e1090 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e1090] = _e943;
                        let _e1093 = local_7;
                        local_9 = _e1093;
                        phi_4367_ = type_30(0u, _e1090);
                        loop {
                            let _e1096 = phi_4367_;
                            if (_e1096.member < _e1096.member_1) {
                                phi_4368_ = type_30((_e1096.member + 1u), _e1096.member_1);
                                phi_4391_ = type_30(1u, _e1096.member);
                            } else {
                                phi_4368_ = _e1096;
                                phi_4391_ = type_30(0u, type_30().member_1);
                            }
                            let _e1110 = phi_4368_;
                            let _e1112 = phi_4391_;
                            if (bitcast<i32>(_e1112.member) != 0i) {
                                if (_e1112.member_1 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1119 = local_9[_e1112.member_1];
                                let _e1120 = (_e1112.member_1 + 1u);
                                if (_e1120 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1123 = local_9[_e1120];
                                let _e1125 = (f64(1f) - _e1119);
                                let _e1136 = ((((_e546 * _e1125) + (_e569 * _e1119)) * (_e1125 * _e1125)) + (((_e592 * _e1125) + (_e603 * _e1119)) * (_e1119 * _e1119)));
                                let _e1138 = (f64(1f) - _e1123);
                                let _e1149 = ((((_e546 * _e1138) + (_e569 * _e1123)) * (_e1138 * _e1138)) + (((_e592 * _e1138) + (_e603 * _e1123)) * (_e1123 * _e1123)));
                                if (_e1136 < 0.0lf) {
                                    phi_4445_ = -(_e1136);
                                } else {
                                    phi_4445_ = _e1136;
                                }
                                let _e1153 = phi_4445_;
                                let _e1154 = (_e1153 > _e937);
                                if (_e1149 < 0.0lf) {
                                    phi_4452_ = -(_e1149);
                                } else {
                                    phi_4452_ = _e1149;
                                }
                                let _e1158 = phi_4452_;
                                let _e1159 = (_e1158 > _e937);
                                let _e1160 = f64(0f);
                                if _e1154 {
                                    if _e1159 {
                                        phi_4464_ = ((_e1136 > _e1160) != (_e1149 > _e1160));
                                        phi_4465_ = false;
                                    } else {
                                        phi_4464_ = bool();
                                        phi_4465_ = true;
                                    }
                                    let _e1165 = phi_4464_;
                                    let _e1167 = phi_4465_;
                                    phi_4466_ = _e1165;
                                    phi_4467_ = _e1167;
                                } else {
                                    phi_4466_ = bool();
                                    phi_4467_ = true;
                                }
                                let _e1169 = phi_4466_;
                                let _e1171 = phi_4467_;
                                if _e1171 {
                                    phi_4471_ = false;
                                } else {
                                    phi_4471_ = _e1169;
                                }
                                let _e1173 = phi_4471_;
                                if _e1154 {
                                    if _e1159 {
                                        if _e1173 {
                                            phi_4483_ = type_74();
                                        } else {
                                            phi_4483_ = type_74(f64(1f), _e1160, _e1173);
                                        }
                                        let _e1177 = phi_4483_;
                                        phi_4484_ = _e1177;
                                        phi_4485_ = _e1173;
                                    } else {
                                        phi_4484_ = type_74();
                                        phi_4485_ = true;
                                    }
                                    let _e1179 = phi_4484_;
                                    let _e1181 = phi_4485_;
                                    phi_4486_ = _e1179;
                                    phi_4487_ = _e1181;
                                } else {
                                    phi_4486_ = type_74();
                                    phi_4487_ = true;
                                }
                                let _e1183 = phi_4486_;
                                let _e1185 = phi_4487_;
                                if _e1185 {
                                    if _e1154 {
                                        if (_e1136 < _e1160) {
                                            phi_4500_ = f64(-1f);
                                        } else {
                                            phi_4500_ = f64(1f);
                                        }
                                        let _e1190 = phi_4500_;
                                        let _e1191 = f64(0.00000000000022737368f);
                                        let _e1192 = f64(0.5f);
                                        let _e1193 = f64(3f);
                                        let _e1196 = (_e592 - _e569);
                                        phi_4513_ = type_30(0u, 64u);
                                        phi_4516_ = _e1123;
                                        phi_4518_ = _e1119;
                                        phi_4520_ = (_e1192 * (_e1119 + _e1123));
                                        loop {
                                            let _e1202 = phi_4513_;
                                            let _e1204 = phi_4516_;
                                            let _e1206 = phi_4518_;
                                            let _e1208 = phi_4520_;
                                            local_53 = _e1206;
                                            if (_e1202.member < _e1202.member_1) {
                                                phi_4514_ = type_30((_e1202.member + 1u), _e1202.member_1);
                                                phi_4543_ = type_30(1u, _e1202.member);
                                            } else {
                                                phi_4514_ = _e1202;
                                                phi_4543_ = type_30(0u, type_30().member_1);
                                            }
                                            let _e1222 = phi_4514_;
                                            let _e1224 = phi_4543_;
                                            if (bitcast<i32>(_e1224.member) != 0i) {
                                                let _e1229 = (f64(1f) - _e1208);
                                                let _e1242 = ((_e1190 * ((((_e546 * _e1229) + (_e569 * _e1208)) * (_e1229 * _e1229)) + (((_e592 * _e1229) + (_e603 * _e1208)) * (_e1208 * _e1208)))) - _e937);
                                                if (_e1242 > f64(0f)) {
                                                    phi_4570_ = _e1204;
                                                    phi_4571_ = _e1208;
                                                } else {
                                                    phi_4570_ = _e1208;
                                                    phi_4571_ = _e1206;
                                                }
                                                let _e1246 = phi_4570_;
                                                let _e1248 = phi_4571_;
                                                let _e1250 = ((_e1246 - _e1248) > _e1191);
                                                if _e1250 {
                                                    let _e1252 = (f64(1f) - _e1208);
                                                    let _e1264 = (-(_e1242) / (_e1190 * (((((_e569 - (_e1193 * _e546)) * _e1252) + (_e1196 * _e1208)) * _e1252) + (((_e1196 * _e1252) + (((_e1193 * _e603) - _e592) * _e1208)) * _e1208))));
                                                    if (_e1242 > f64(0f)) {
                                                        phi_4599_ = (_e1192 * _e1191);
                                                    } else {
                                                        phi_4599_ = -((_e1192 * _e1191));
                                                    }
                                                    let _e1271 = phi_4599_;
                                                    let _e1273 = ((_e1208 + _e1264) + _e1271);
                                                    if (_e1273 > _e1248) {
                                                        if (_e1273 < _e1246) {
                                                            if (_e1264 < 0.0lf) {
                                                                phi_4615_ = -(_e1264);
                                                            } else {
                                                                phi_4615_ = _e1264;
                                                            }
                                                            let _e1279 = phi_4615_;
                                                            if (_e1279 < (_e1192 * (_e1246 - _e1248))) {
                                                                phi_4622_ = false;
                                                            } else {
                                                                phi_4622_ = true;
                                                            }
                                                            let _e1284 = phi_4622_;
                                                            phi_4623_ = _e1284;
                                                        } else {
                                                            phi_4623_ = true;
                                                        }
                                                        let _e1286 = phi_4623_;
                                                        phi_4624_ = _e1286;
                                                    } else {
                                                        phi_4624_ = true;
                                                    }
                                                    let _e1288 = phi_4624_;
                                                    if _e1288 {
                                                        phi_4630_ = (_e1192 * (_e1248 + _e1246));
                                                    } else {
                                                        phi_4630_ = _e1273;
                                                    }
                                                    let _e1292 = phi_4630_;
                                                    phi_4631_ = _e1292;
                                                    phi_4632_ = false;
                                                } else {
                                                    phi_4631_ = f64();
                                                    phi_4632_ = true;
                                                }
                                                let _e1294 = phi_4631_;
                                                let _e1296 = phi_4632_;
                                                phi_4517_ = _e1246;
                                                phi_4519_ = _e1248;
                                                phi_4521_ = _e1294;
                                                phi_4633_ = _e1248;
                                                phi_4634_ = _e1250;
                                                phi_4635_ = _e1296;
                                            } else {
                                                phi_4517_ = f64();
                                                phi_4519_ = f64();
                                                phi_4521_ = f64();
                                                phi_4633_ = f64();
                                                phi_4634_ = false;
                                                phi_4635_ = false;
                                            }
                                            let _e1298 = phi_4517_;
                                            let _e1300 = phi_4519_;
                                            let _e1302 = phi_4521_;
                                            let _e1304 = phi_4633_;
                                            let _e1306 = phi_4634_;
                                            let _e1308 = phi_4635_;
                                            local_22 = _e1308;
                                            local_52 = _e1304;
                                            continue;
                                            continuing {
                                                phi_4513_ = _e1222;
                                                phi_4516_ = _e1298;
                                                phi_4518_ = _e1300;
                                                phi_4520_ = _e1302;
                                                break if !(_e1306);
                                            }
                                        }
                                        let _e1311 = local_22;
                                        if _e1311 {
                                            let _e5131 = local_52;
                                            phi_4639_ = _e5131;
                                        } else {
                                            let _e5133 = local_53;
                                            phi_4639_ = _e5133;
                                        }
                                        let _e1313 = phi_4639_;
                                        phi_4640_ = _e1313;
                                    } else {
                                        phi_4640_ = _e1119;
                                    }
                                    let _e1315 = phi_4640_;
                                    if _e1159 {
                                        phi_4648_ = type_30(0u, 64u);
                                        phi_4651_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1319 = phi_4648_;
                                            let _e1321 = phi_4651_;
                                            if (_e1319.member < _e1319.member_1) {
                                                phi_4649_ = type_30((_e1319.member + 1u), _e1319.member_1);
                                                phi_4674_ = type_30(1u, _e1319.member);
                                            } else {
                                                phi_4649_ = _e1319;
                                                phi_4674_ = type_30(0u, type_30().member_1);
                                            }
                                            let _e1335 = phi_4649_;
                                            let _e1337 = phi_4674_;
                                            if (bitcast<i32>(_e1337.member) != 0i) {
                                                let _e1341 = (_e1315 + _e1321);
                                                if (_e1341 < _e1123) {
                                                    let _e1344 = (f64(1f) - _e1341);
                                                    let _e1355 = ((((_e546 * _e1344) + (_e569 * _e1341)) * (_e1344 * _e1344)) + (((_e592 * _e1344) + (_e603 * _e1341)) * (_e1341 * _e1341)));
                                                    let _e1357 = (f64(1f) - _e1315);
                                                    let _e1368 = ((((_e546 * _e1357) + (_e569 * _e1315)) * (_e1357 * _e1357)) + (((_e592 * _e1357) + (_e603 * _e1315)) * (_e1315 * _e1315)));
                                                    if (_e1355 < 0.0lf) {
                                                        phi_4717_ = -(_e1355);
                                                    } else {
                                                        phi_4717_ = _e1355;
                                                    }
                                                    let _e1372 = phi_4717_;
                                                    if (_e1372 > _e937) {
                                                        if (_e1368 < 0.0lf) {
                                                            phi_4727_ = -(_e1368);
                                                        } else {
                                                            phi_4727_ = _e1368;
                                                        }
                                                        let _e1377 = phi_4727_;
                                                        if (_e1377 > _e937) {
                                                            phi_4737_ = ((_e1355 > f64(0f)) == (_e1368 > f64(0f)));
                                                        } else {
                                                            phi_4737_ = false;
                                                        }
                                                        let _e1385 = phi_4737_;
                                                        phi_4739_ = !(_e1385);
                                                    } else {
                                                        phi_4739_ = false;
                                                    }
                                                    let _e1388 = phi_4739_;
                                                    if _e1388 {
                                                        phi_4744_ = f64();
                                                        phi_4745_ = false;
                                                    } else {
                                                        phi_4744_ = (_e1321 + _e1321);
                                                        phi_4745_ = true;
                                                    }
                                                    let _e1391 = phi_4744_;
                                                    let _e1393 = phi_4745_;
                                                    phi_4746_ = _e1391;
                                                    phi_4747_ = _e1393;
                                                    phi_4748_ = _e1388;
                                                    phi_4749_ = false;
                                                } else {
                                                    phi_4746_ = f64();
                                                    phi_4747_ = false;
                                                    phi_4748_ = false;
                                                    phi_4749_ = true;
                                                }
                                                let _e1395 = phi_4746_;
                                                let _e1397 = phi_4747_;
                                                let _e1399 = phi_4748_;
                                                let _e1401 = phi_4749_;
                                                phi_4750_ = _e1341;
                                                phi_4652_ = _e1395;
                                                phi_4751_ = _e1397;
                                                phi_4752_ = _e1399;
                                                phi_4753_ = _e1401;
                                                phi_4754_ = false;
                                            } else {
                                                phi_4750_ = f64();
                                                phi_4652_ = f64();
                                                phi_4751_ = false;
                                                phi_4752_ = false;
                                                phi_4753_ = false;
                                                phi_4754_ = true;
                                            }
                                            let _e1403 = phi_4750_;
                                            let _e1405 = phi_4652_;
                                            let _e1407 = phi_4751_;
                                            let _e1409 = phi_4752_;
                                            let _e1411 = phi_4753_;
                                            let _e1413 = phi_4754_;
                                            local_23 = _e1409;
                                            local_54 = _e1411;
                                            local_55 = _e1413;
                                            local_56 = _e1403;
                                            continue;
                                            continuing {
                                                phi_4648_ = _e1335;
                                                phi_4651_ = _e1405;
                                                break if !(_e1407);
                                            }
                                        }
                                        let _e1416 = local_23;
                                        if _e1416 {
                                            phi_4758_ = false;
                                            phi_4759_ = false;
                                        } else {
                                            let _e5158 = local_54;
                                            phi_4758_ = _e5158;
                                            let _e5161 = local_55;
                                            phi_4759_ = _e5161;
                                        }
                                        let _e1418 = phi_4758_;
                                        let _e1420 = phi_4759_;
                                        if _e1418 {
                                            phi_4763_ = true;
                                        } else {
                                            phi_4763_ = _e1420;
                                        }
                                        let _e1422 = phi_4763_;
                                        if _e1422 {
                                            phi_4767_ = _e1123;
                                        } else {
                                            let _e5165 = local_56;
                                            phi_4767_ = _e5165;
                                        }
                                        let _e1424 = phi_4767_;
                                        phi_4768_ = _e1424;
                                    } else {
                                        phi_4768_ = _e1123;
                                    }
                                    let _e1426 = phi_4768_;
                                    phi_4770_ = type_74(_e1315, _e1426, _e1173);
                                } else {
                                    phi_4770_ = _e1183;
                                }
                                let _e1429 = phi_4770_;
                                if (_e1429.member > _e1429.member_1) {
                                    phi_7402_ = f64();
                                    phi_7403_ = true;
                                    phi_7404_ = false;
                                    phi_7405_ = false;
                                    phi_7406_ = false;
                                } else {
                                    let _e1437 = ((_e1429.member_1 - _e1429.member) * f64(0.5f));
                                    let _e1438 = (_e1429.member + _e1437);
                                    let _e1441 = (_e1437 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1443 = local_20.member_3;
                                    let _e1446 = local_20.member[0u];
                                    if (_e1446[0] < 0.0lf) {
                                        phi_4801_ = -(_e1446[0]);
                                    } else {
                                        phi_4801_ = _e1446[0];
                                    }
                                    let _e1453 = phi_4801_;
                                    if (_e1446[1] < 0.0lf) {
                                        phi_4808_ = -(_e1446[1]);
                                    } else {
                                        phi_4808_ = _e1446[1];
                                    }
                                    let _e1457 = phi_4808_;
                                    if (_e1453 > _e1457) {
                                        phi_4813_ = _e1453;
                                    } else {
                                        phi_4813_ = _e1457;
                                    }
                                    let _e1460 = phi_4813_;
                                    if (_e1446[2] < 0.0lf) {
                                        phi_4820_ = -(_e1446[2]);
                                    } else {
                                        phi_4820_ = _e1446[2];
                                    }
                                    let _e1464 = phi_4820_;
                                    if (_e1460 > _e1464) {
                                        phi_4825_ = _e1460;
                                    } else {
                                        phi_4825_ = _e1464;
                                    }
                                    let _e1467 = phi_4825_;
                                    let _e1469 = local_20.member[1u];
                                    if (_e1469[0] < 0.0lf) {
                                        phi_4838_ = -(_e1469[0]);
                                    } else {
                                        phi_4838_ = _e1469[0];
                                    }
                                    let _e1476 = phi_4838_;
                                    if (_e1469[1] < 0.0lf) {
                                        phi_4845_ = -(_e1469[1]);
                                    } else {
                                        phi_4845_ = _e1469[1];
                                    }
                                    let _e1480 = phi_4845_;
                                    if (_e1476 > _e1480) {
                                        phi_4850_ = _e1476;
                                    } else {
                                        phi_4850_ = _e1480;
                                    }
                                    let _e1483 = phi_4850_;
                                    if (_e1469[2] < 0.0lf) {
                                        phi_4857_ = -(_e1469[2]);
                                    } else {
                                        phi_4857_ = _e1469[2];
                                    }
                                    let _e1487 = phi_4857_;
                                    if (_e1483 > _e1487) {
                                        phi_4862_ = _e1483;
                                    } else {
                                        phi_4862_ = _e1487;
                                    }
                                    let _e1490 = phi_4862_;
                                    if (_e1467 > _e1490) {
                                        phi_4867_ = _e1467;
                                    } else {
                                        phi_4867_ = _e1490;
                                    }
                                    let _e1493 = phi_4867_;
                                    let _e1496 = local_20.member[0u];
                                    let _e1501 = local_20.member[1u];
                                    let _e1511 = (_e1496[0] + ((_e1501[0] - _e1496[0]) * _e1438));
                                    let _e1512 = (_e1496[1] + ((_e1501[1] - _e1496[1]) * _e1438));
                                    let _e1513 = (_e1496[2] + ((_e1501[2] - _e1496[2]) * _e1438));
                                    let _e1515 = local_20.member[1u];
                                    let _e1520 = local_20.member[0u];
                                    let _e1524 = (_e1515[0] - _e1520[0]);
                                    let _e1525 = (_e1515[1] - _e1520[1]);
                                    let _e1526 = (_e1515[2] - _e1520[2]);
                                    if (_e1524 < 0.0lf) {
                                        phi_4926_ = -(_e1524);
                                    } else {
                                        phi_4926_ = _e1524;
                                    }
                                    let _e1530 = phi_4926_;
                                    if (_e1525 < 0.0lf) {
                                        phi_4932_ = -(_e1525);
                                    } else {
                                        phi_4932_ = _e1525;
                                    }
                                    let _e1534 = phi_4932_;
                                    if (_e1530 > _e1534) {
                                        phi_4937_ = _e1530;
                                    } else {
                                        phi_4937_ = _e1534;
                                    }
                                    let _e1537 = phi_4937_;
                                    if (_e1526 < 0.0lf) {
                                        phi_4943_ = -(_e1526);
                                    } else {
                                        phi_4943_ = _e1526;
                                    }
                                    let _e1541 = phi_4943_;
                                    if (_e1537 > _e1541) {
                                        phi_4948_ = _e1537;
                                    } else {
                                        phi_4948_ = _e1541;
                                    }
                                    let _e1544 = phi_4948_;
                                    let _e1552 = ((((_e1441 * _e1544) * f64(1.01f)) + ((_e1493 + _e1443) * (1.1102230246251565e-16lf * f64(8f)))) + _e1443);
                                    if (_e1511 < 0.0lf) {
                                        phi_4962_ = -(_e1511);
                                    } else {
                                        phi_4962_ = _e1511;
                                    }
                                    let _e1556 = phi_4962_;
                                    if (_e1512 < 0.0lf) {
                                        phi_4968_ = -(_e1512);
                                    } else {
                                        phi_4968_ = _e1512;
                                    }
                                    let _e1560 = phi_4968_;
                                    if (_e1556 > _e1560) {
                                        phi_4973_ = _e1556;
                                    } else {
                                        phi_4973_ = _e1560;
                                    }
                                    let _e1563 = phi_4973_;
                                    if (_e1513 < 0.0lf) {
                                        phi_4979_ = -(_e1513);
                                    } else {
                                        phi_4979_ = _e1513;
                                    }
                                    let _e1567 = phi_4979_;
                                    if (_e1563 > _e1567) {
                                        phi_4984_ = _e1563;
                                    } else {
                                        phi_4984_ = _e1567;
                                    }
                                    let _e1570 = phi_4984_;
                                    local_3 = type_60(array<f64, 3>(_e1511, _e1512, _e1513), _e1552, (_e1570 + _e1552));
                                    let _e1576 = local_20.member_3;
                                    let _e1578 = local_20.member_1[0u];
                                    if (_e1578[0] < 0.0lf) {
                                        phi_5010_ = -(_e1578[0]);
                                    } else {
                                        phi_5010_ = _e1578[0];
                                    }
                                    let _e1585 = phi_5010_;
                                    if (_e1578[1] < 0.0lf) {
                                        phi_5017_ = -(_e1578[1]);
                                    } else {
                                        phi_5017_ = _e1578[1];
                                    }
                                    let _e1589 = phi_5017_;
                                    if (_e1585 > _e1589) {
                                        phi_5022_ = _e1585;
                                    } else {
                                        phi_5022_ = _e1589;
                                    }
                                    let _e1592 = phi_5022_;
                                    if (_e1578[2] < 0.0lf) {
                                        phi_5029_ = -(_e1578[2]);
                                    } else {
                                        phi_5029_ = _e1578[2];
                                    }
                                    let _e1596 = phi_5029_;
                                    if (_e1592 > _e1596) {
                                        phi_5034_ = _e1592;
                                    } else {
                                        phi_5034_ = _e1596;
                                    }
                                    let _e1599 = phi_5034_;
                                    let _e1601 = local_20.member_1[1u];
                                    if (_e1601[0] < 0.0lf) {
                                        phi_5047_ = -(_e1601[0]);
                                    } else {
                                        phi_5047_ = _e1601[0];
                                    }
                                    let _e1608 = phi_5047_;
                                    if (_e1601[1] < 0.0lf) {
                                        phi_5054_ = -(_e1601[1]);
                                    } else {
                                        phi_5054_ = _e1601[1];
                                    }
                                    let _e1612 = phi_5054_;
                                    if (_e1608 > _e1612) {
                                        phi_5059_ = _e1608;
                                    } else {
                                        phi_5059_ = _e1612;
                                    }
                                    let _e1615 = phi_5059_;
                                    if (_e1601[2] < 0.0lf) {
                                        phi_5066_ = -(_e1601[2]);
                                    } else {
                                        phi_5066_ = _e1601[2];
                                    }
                                    let _e1619 = phi_5066_;
                                    if (_e1615 > _e1619) {
                                        phi_5071_ = _e1615;
                                    } else {
                                        phi_5071_ = _e1619;
                                    }
                                    let _e1622 = phi_5071_;
                                    if (_e1599 > _e1622) {
                                        phi_5076_ = _e1599;
                                    } else {
                                        phi_5076_ = _e1622;
                                    }
                                    let _e1625 = phi_5076_;
                                    let _e1628 = local_20.member_1[0u];
                                    let _e1633 = local_20.member_1[1u];
                                    let _e1643 = (_e1628[0] + ((_e1633[0] - _e1628[0]) * _e1438));
                                    let _e1644 = (_e1628[1] + ((_e1633[1] - _e1628[1]) * _e1438));
                                    let _e1645 = (_e1628[2] + ((_e1633[2] - _e1628[2]) * _e1438));
                                    let _e1647 = local_20.member_1[1u];
                                    let _e1652 = local_20.member_1[0u];
                                    let _e1656 = (_e1647[0] - _e1652[0]);
                                    let _e1657 = (_e1647[1] - _e1652[1]);
                                    let _e1658 = (_e1647[2] - _e1652[2]);
                                    if (_e1656 < 0.0lf) {
                                        phi_5135_ = -(_e1656);
                                    } else {
                                        phi_5135_ = _e1656;
                                    }
                                    let _e1662 = phi_5135_;
                                    if (_e1657 < 0.0lf) {
                                        phi_5141_ = -(_e1657);
                                    } else {
                                        phi_5141_ = _e1657;
                                    }
                                    let _e1666 = phi_5141_;
                                    if (_e1662 > _e1666) {
                                        phi_5146_ = _e1662;
                                    } else {
                                        phi_5146_ = _e1666;
                                    }
                                    let _e1669 = phi_5146_;
                                    if (_e1658 < 0.0lf) {
                                        phi_5152_ = -(_e1658);
                                    } else {
                                        phi_5152_ = _e1658;
                                    }
                                    let _e1673 = phi_5152_;
                                    if (_e1669 > _e1673) {
                                        phi_5157_ = _e1669;
                                    } else {
                                        phi_5157_ = _e1673;
                                    }
                                    let _e1676 = phi_5157_;
                                    let _e1684 = ((((_e1441 * _e1676) * f64(1.01f)) + ((_e1625 + _e1576) * (1.1102230246251565e-16lf * f64(8f)))) + _e1576);
                                    if (_e1643 < 0.0lf) {
                                        phi_5171_ = -(_e1643);
                                    } else {
                                        phi_5171_ = _e1643;
                                    }
                                    let _e1688 = phi_5171_;
                                    if (_e1644 < 0.0lf) {
                                        phi_5177_ = -(_e1644);
                                    } else {
                                        phi_5177_ = _e1644;
                                    }
                                    let _e1692 = phi_5177_;
                                    if (_e1688 > _e1692) {
                                        phi_5182_ = _e1688;
                                    } else {
                                        phi_5182_ = _e1692;
                                    }
                                    let _e1695 = phi_5182_;
                                    if (_e1645 < 0.0lf) {
                                        phi_5188_ = -(_e1645);
                                    } else {
                                        phi_5188_ = _e1645;
                                    }
                                    let _e1699 = phi_5188_;
                                    if (_e1695 > _e1699) {
                                        phi_5193_ = _e1695;
                                    } else {
                                        phi_5193_ = _e1699;
                                    }
                                    let _e1702 = phi_5193_;
                                    local_4 = type_60(array<f64, 3>(_e1643, _e1644, _e1645), _e1684, (_e1702 + _e1684));
                                    let _e1708 = local_20.member_3;
                                    let _e1710 = local_20.member_2[0u];
                                    if (_e1710[0] < 0.0lf) {
                                        phi_5219_ = -(_e1710[0]);
                                    } else {
                                        phi_5219_ = _e1710[0];
                                    }
                                    let _e1717 = phi_5219_;
                                    if (_e1710[1] < 0.0lf) {
                                        phi_5226_ = -(_e1710[1]);
                                    } else {
                                        phi_5226_ = _e1710[1];
                                    }
                                    let _e1721 = phi_5226_;
                                    if (_e1717 > _e1721) {
                                        phi_5231_ = _e1717;
                                    } else {
                                        phi_5231_ = _e1721;
                                    }
                                    let _e1724 = phi_5231_;
                                    if (_e1710[2] < 0.0lf) {
                                        phi_5238_ = -(_e1710[2]);
                                    } else {
                                        phi_5238_ = _e1710[2];
                                    }
                                    let _e1728 = phi_5238_;
                                    if (_e1724 > _e1728) {
                                        phi_5243_ = _e1724;
                                    } else {
                                        phi_5243_ = _e1728;
                                    }
                                    let _e1731 = phi_5243_;
                                    let _e1733 = local_20.member_2[1u];
                                    if (_e1733[0] < 0.0lf) {
                                        phi_5256_ = -(_e1733[0]);
                                    } else {
                                        phi_5256_ = _e1733[0];
                                    }
                                    let _e1740 = phi_5256_;
                                    if (_e1733[1] < 0.0lf) {
                                        phi_5263_ = -(_e1733[1]);
                                    } else {
                                        phi_5263_ = _e1733[1];
                                    }
                                    let _e1744 = phi_5263_;
                                    if (_e1740 > _e1744) {
                                        phi_5268_ = _e1740;
                                    } else {
                                        phi_5268_ = _e1744;
                                    }
                                    let _e1747 = phi_5268_;
                                    if (_e1733[2] < 0.0lf) {
                                        phi_5275_ = -(_e1733[2]);
                                    } else {
                                        phi_5275_ = _e1733[2];
                                    }
                                    let _e1751 = phi_5275_;
                                    if (_e1747 > _e1751) {
                                        phi_5280_ = _e1747;
                                    } else {
                                        phi_5280_ = _e1751;
                                    }
                                    let _e1754 = phi_5280_;
                                    if (_e1731 > _e1754) {
                                        phi_5285_ = _e1731;
                                    } else {
                                        phi_5285_ = _e1754;
                                    }
                                    let _e1757 = phi_5285_;
                                    let _e1760 = local_20.member_2[0u];
                                    let _e1765 = local_20.member_2[1u];
                                    let _e1775 = (_e1760[0] + ((_e1765[0] - _e1760[0]) * _e1438));
                                    let _e1776 = (_e1760[1] + ((_e1765[1] - _e1760[1]) * _e1438));
                                    let _e1777 = (_e1760[2] + ((_e1765[2] - _e1760[2]) * _e1438));
                                    let _e1779 = local_20.member_2[1u];
                                    let _e1784 = local_20.member_2[0u];
                                    let _e1788 = (_e1779[0] - _e1784[0]);
                                    let _e1789 = (_e1779[1] - _e1784[1]);
                                    let _e1790 = (_e1779[2] - _e1784[2]);
                                    if (_e1788 < 0.0lf) {
                                        phi_5344_ = -(_e1788);
                                    } else {
                                        phi_5344_ = _e1788;
                                    }
                                    let _e1794 = phi_5344_;
                                    if (_e1789 < 0.0lf) {
                                        phi_5350_ = -(_e1789);
                                    } else {
                                        phi_5350_ = _e1789;
                                    }
                                    let _e1798 = phi_5350_;
                                    if (_e1794 > _e1798) {
                                        phi_5355_ = _e1794;
                                    } else {
                                        phi_5355_ = _e1798;
                                    }
                                    let _e1801 = phi_5355_;
                                    if (_e1790 < 0.0lf) {
                                        phi_5361_ = -(_e1790);
                                    } else {
                                        phi_5361_ = _e1790;
                                    }
                                    let _e1805 = phi_5361_;
                                    if (_e1801 > _e1805) {
                                        phi_5366_ = _e1801;
                                    } else {
                                        phi_5366_ = _e1805;
                                    }
                                    let _e1808 = phi_5366_;
                                    let _e1816 = ((((_e1441 * _e1808) * f64(1.01f)) + ((_e1757 + _e1708) * (1.1102230246251565e-16lf * f64(8f)))) + _e1708);
                                    if (_e1775 < 0.0lf) {
                                        phi_5380_ = -(_e1775);
                                    } else {
                                        phi_5380_ = _e1775;
                                    }
                                    let _e1820 = phi_5380_;
                                    if (_e1776 < 0.0lf) {
                                        phi_5386_ = -(_e1776);
                                    } else {
                                        phi_5386_ = _e1776;
                                    }
                                    let _e1824 = phi_5386_;
                                    if (_e1820 > _e1824) {
                                        phi_5391_ = _e1820;
                                    } else {
                                        phi_5391_ = _e1824;
                                    }
                                    let _e1827 = phi_5391_;
                                    if (_e1777 < 0.0lf) {
                                        phi_5397_ = -(_e1777);
                                    } else {
                                        phi_5397_ = _e1777;
                                    }
                                    let _e1831 = phi_5397_;
                                    if (_e1827 > _e1831) {
                                        phi_5402_ = _e1827;
                                    } else {
                                        phi_5402_ = _e1831;
                                    }
                                    let _e1834 = phi_5402_;
                                    local_5 = type_60(array<f64, 3>(_e1775, _e1776, _e1777), _e1816, (_e1834 + _e1816));
                                    let _e1839 = local_4.member;
                                    let _e1844 = local_5.member;
                                    let _e1850 = ((_e1839[1] * _e1844[2]) - (_e1839[2] * _e1844[1]));
                                    let _e1853 = ((_e1839[2] * _e1844[0]) - (_e1839[0] * _e1844[2]));
                                    let _e1856 = ((_e1839[0] * _e1844[1]) - (_e1839[1] * _e1844[0]));
                                    if (_e1850 < 0.0lf) {
                                        phi_5451_ = -(_e1850);
                                    } else {
                                        phi_5451_ = _e1850;
                                    }
                                    let _e1860 = phi_5451_;
                                    if (_e1853 < 0.0lf) {
                                        phi_5457_ = -(_e1853);
                                    } else {
                                        phi_5457_ = _e1853;
                                    }
                                    let _e1864 = phi_5457_;
                                    if (_e1860 > _e1864) {
                                        if (_e1850 < 0.0lf) {
                                            phi_5467_ = -(_e1850);
                                        } else {
                                            phi_5467_ = _e1850;
                                        }
                                        let _e1882 = phi_5467_;
                                        if (_e1856 < 0.0lf) {
                                            phi_5473_ = -(_e1856);
                                        } else {
                                            phi_5473_ = _e1856;
                                        }
                                        let _e1886 = phi_5473_;
                                        if (_e1882 > _e1886) {
                                            phi_5478_ = 2u;
                                            phi_5479_ = 1u;
                                        } else {
                                            phi_5478_ = 1u;
                                            phi_5479_ = 0u;
                                        }
                                        let _e1889 = phi_5478_;
                                        let _e1891 = phi_5479_;
                                        phi_5498_ = _e1889;
                                        phi_5499_ = _e1891;
                                    } else {
                                        if (_e1853 < 0.0lf) {
                                            phi_5485_ = -(_e1853);
                                        } else {
                                            phi_5485_ = _e1853;
                                        }
                                        let _e1869 = phi_5485_;
                                        if (_e1856 < 0.0lf) {
                                            phi_5491_ = -(_e1856);
                                        } else {
                                            phi_5491_ = _e1856;
                                        }
                                        let _e1873 = phi_5491_;
                                        if (_e1869 > _e1873) {
                                            phi_5496_ = 0u;
                                            phi_5497_ = 2u;
                                        } else {
                                            phi_5496_ = 1u;
                                            phi_5497_ = 0u;
                                        }
                                        let _e1876 = phi_5496_;
                                        let _e1878 = phi_5497_;
                                        phi_5498_ = _e1876;
                                        phi_5499_ = _e1878;
                                    }
                                    let _e1893 = phi_5498_;
                                    let _e1895 = phi_5499_;
                                    if (_e1895 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1899 = local_4.member[_e1895];
                                    if (_e1893 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1903 = local_5.member[_e1893];
                                    if (_e1893 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1908 = local_4.member[_e1893];
                                    if (_e1895 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1912 = local_5.member[_e1895];
                                    let _e1914 = ((_e1899 * _e1903) - (_e1908 * _e1912));
                                    let _e1915 = f64(1f);
                                    let _e1917 = local_4.member_1;
                                    let _e1919 = local_5.member_2;
                                    let _e1922 = local_4.member_2;
                                    let _e1924 = local_5.member_1;
                                    let _e1930 = local_4.member_2;
                                    let _e1932 = local_5.member_2;
                                    let _e1941 = local_4.member_2;
                                    let _e1944 = local_5.member_2;
                                    let _e1948 = (((((_e1917 * _e1919) + (_e1922 * _e1924)) * f64(2.01f)) + ((_e1930 * _e1932) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1915 + _e1941) * (_e1915 + _e1944))));
                                    if (_e1914 < 0.0lf) {
                                        phi_5570_ = -(_e1914);
                                    } else {
                                        phi_5570_ = _e1914;
                                    }
                                    let _e1952 = phi_5570_;
                                    if (_e1952 > _e1948) {
                                        if (_e1914 < f64(0f)) {
                                            phi_5582_ = f64(-1f);
                                        } else {
                                            phi_5582_ = f64(1f);
                                        }
                                        let _e1959 = phi_5582_;
                                        if (_e1895 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1963 = local_3.member[_e1895];
                                        if (_e1893 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1967 = local_5.member[_e1893];
                                        if (_e1893 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1972 = local_3.member[_e1893];
                                        if (_e1895 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1976 = local_5.member[_e1895];
                                        let _e1979 = f64(1f);
                                        let _e1981 = local_3.member_1;
                                        let _e1983 = local_5.member_2;
                                        let _e1986 = local_3.member_2;
                                        let _e1988 = local_5.member_1;
                                        let _e1994 = local_3.member_2;
                                        let _e1996 = local_5.member_2;
                                        let _e2005 = local_3.member_2;
                                        let _e2008 = local_5.member_2;
                                        let _e2012 = (((((_e1981 * _e1983) + (_e1986 * _e1988)) * f64(2.01f)) + ((_e1994 * _e1996) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1979 + _e2005) * (_e1979 + _e2008))));
                                        if (_e1895 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2016 = local_4.member[_e1895];
                                        if (_e1893 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2020 = local_3.member[_e1893];
                                        if (_e1893 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2025 = local_4.member[_e1893];
                                        if (_e1895 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2029 = local_3.member[_e1895];
                                        let _e2032 = f64(1f);
                                        let _e2034 = local_4.member_1;
                                        let _e2036 = local_3.member_2;
                                        let _e2039 = local_4.member_2;
                                        let _e2041 = local_3.member_1;
                                        let _e2047 = local_4.member_2;
                                        let _e2049 = local_3.member_2;
                                        let _e2058 = local_4.member_2;
                                        let _e2061 = local_3.member_2;
                                        let _e2065 = (((((_e2034 * _e2036) + (_e2039 * _e2041)) * f64(2.01f)) + ((_e2047 * _e2049) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2032 + _e2058) * (_e2032 + _e2061))));
                                        let _e2066 = (_e1914 * _e1959);
                                        let _e2067 = (((_e1963 * _e1967) - (_e1972 * _e1976)) * _e1959);
                                        let _e2068 = (((_e2016 * _e2020) - (_e2025 * _e2029)) * _e1959);
                                        if (_e2066 < 0.0lf) {
                                            phi_5721_ = -(_e2066);
                                        } else {
                                            phi_5721_ = _e2066;
                                        }
                                        let _e2072 = phi_5721_;
                                        if (_e2067 < 0.0lf) {
                                            phi_5727_ = -(_e2067);
                                        } else {
                                            phi_5727_ = _e2067;
                                        }
                                        let _e2076 = phi_5727_;
                                        if (_e2068 < 0.0lf) {
                                            phi_5734_ = -(_e2068);
                                        } else {
                                            phi_5734_ = _e2068;
                                        }
                                        let _e2081 = phi_5734_;
                                        let _e2087 = ((_e2066 - _e2067) - _e2068);
                                        let _e2090 = (((_e1948 + _e2012) + _e2065) + (((_e2072 + _e2076) + _e2081) * (1.1102230246251565e-16lf * f64(4f))));
                                        local_6[0u].member = _e2067;
                                        local_6[0u].member_1 = _e2012;
                                        local_6[1u].member = _e2068;
                                        local_6[1u].member_1 = _e2065;
                                        local_6[2u].member = _e2087;
                                        local_6[2u].member_1 = _e2090;
                                        local_6[3u].member = _e2087;
                                        local_6[3u].member_1 = _e2090;
                                        phi_5778_ = type_30(0u, 4u);
                                        phi_5781_ = true;
                                        loop {
                                            let _e2105 = phi_5778_;
                                            let _e2107 = phi_5781_;
                                            local_25 = _e2107;
                                            if (_e2105.member < _e2105.member_1) {
                                                phi_5779_ = type_30((_e2105.member + 1u), _e2105.member_1);
                                                phi_5804_ = type_30(1u, _e2105.member);
                                            } else {
                                                phi_5779_ = _e2105;
                                                phi_5804_ = type_30(0u, type_30().member_1);
                                            }
                                            let _e2121 = phi_5779_;
                                            let _e2123 = phi_5804_;
                                            if (bitcast<i32>(_e2123.member) != 0i) {
                                                if (_e2123.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e2131 = local_6[_e2123.member_1].member;
                                                let _e2134 = local_6[_e2123.member_1].member_1;
                                                let _e2136 = (_e2131 < -(_e2134));
                                                if _e2136 {
                                                    phi_5831_ = bool();
                                                    phi_5832_ = false;
                                                } else {
                                                    phi_5831_ = (_e2107 && (_e2131 > _e2134));
                                                    phi_5832_ = true;
                                                }
                                                let _e2140 = phi_5831_;
                                                let _e2142 = phi_5832_;
                                                phi_5782_ = _e2140;
                                                phi_5833_ = _e2142;
                                                phi_5834_ = _e2136;
                                            } else {
                                                phi_5782_ = bool();
                                                phi_5833_ = false;
                                                phi_5834_ = false;
                                            }
                                            let _e2144 = phi_5782_;
                                            let _e2146 = phi_5833_;
                                            let _e2148 = phi_5834_;
                                            local_24 = _e2148;
                                            continue;
                                            continuing {
                                                phi_5778_ = _e2121;
                                                phi_5781_ = _e2144;
                                                break if !(_e2146);
                                            }
                                        }
                                        let _e2151 = local_24;
                                        if _e2151 {
                                            phi_5838_ = false;
                                        } else {
                                            phi_5838_ = true;
                                        }
                                        let _e2153 = phi_5838_;
                                        if _e2153 {
                                            let _e2155 = local_25;
                                            if _e2155 {
                                                phi_5845_ = 1u;
                                            } else {
                                                phi_5845_ = 2u;
                                            }
                                            let _e2157 = phi_5845_;
                                            phi_5846_ = _e2157;
                                            phi_5847_ = false;
                                        } else {
                                            phi_5846_ = u32();
                                            phi_5847_ = true;
                                        }
                                        let _e2159 = phi_5846_;
                                        let _e2161 = phi_5847_;
                                        phi_5848_ = _e2159;
                                        phi_5849_ = 0u;
                                        phi_5850_ = _e2161;
                                    } else {
                                        phi_5848_ = u32();
                                        phi_5849_ = 2u;
                                        phi_5850_ = true;
                                    }
                                    let _e2163 = phi_5848_;
                                    let _e2165 = phi_5849_;
                                    let _e2167 = phi_5850_;
                                    if _e2167 {
                                        phi_5854_ = _e2165;
                                    } else {
                                        phi_5854_ = _e2163;
                                    }
                                    let _e2169 = phi_5854_;
                                    let _e2170 = (_e2169 == 0u);
                                    if _e2170 {
                                        phi_7398_ = f64();
                                        phi_7399_ = false;
                                        phi_7400_ = false;
                                        phi_7401_ = false;
                                    } else {
                                        if (_e2169 == 1u) {
                                            if _e1429.member_2 {
                                                if ((_e1429.member_1 - _e1429.member) <= f64(0.0000005f)) {
                                                    phi_5875_ = false;
                                                } else {
                                                    phi_5875_ = true;
                                                }
                                                let _e2179 = phi_5875_;
                                                phi_5876_ = _e2179;
                                            } else {
                                                phi_5876_ = true;
                                            }
                                            let _e2181 = phi_5876_;
                                            phi_5877_ = _e2181;
                                        } else {
                                            phi_5877_ = true;
                                        }
                                        let _e2183 = phi_5877_;
                                        if _e2183 {
                                            let _e2189 = local_20.member[0u];
                                            let _e2195 = local_20.member_1[0u];
                                            let _e2201 = local_20.member_2[0u];
                                            local_1 = array<array<f64, 3>, 4>(_e2189, array<f64, 3>((_e2189[0] - _e2195[0]), (_e2189[1] - _e2195[1]), (_e2189[2] - _e2195[2])), array<f64, 3>((_e2189[0] - _e2201[0]), (_e2189[1] - _e2201[1]), (_e2189[2] - _e2201[2])), _e2189);
                                            let _e2216 = local_20.member[1u];
                                            let _e2222 = local_20.member_1[1u];
                                            let _e2228 = local_20.member_2[1u];
                                            local_2 = array<array<f64, 3>, 4>(_e2216, array<f64, 3>((_e2216[0] - _e2222[0]), (_e2216[1] - _e2222[1]), (_e2216[2] - _e2222[2])), array<f64, 3>((_e2216[0] - _e2228[0]), (_e2216[1] - _e2228[1]), (_e2216[2] - _e2228[2])), _e2216);
                                            let _e2243 = local_20.member[0u];
                                            if (_e2243[0] < 0.0lf) {
                                                phi_6074_ = -(_e2243[0]);
                                            } else {
                                                phi_6074_ = _e2243[0];
                                            }
                                            let _e2250 = phi_6074_;
                                            if (_e2243[1] < 0.0lf) {
                                                phi_6081_ = -(_e2243[1]);
                                            } else {
                                                phi_6081_ = _e2243[1];
                                            }
                                            let _e2254 = phi_6081_;
                                            if (_e2250 > _e2254) {
                                                phi_6086_ = _e2250;
                                            } else {
                                                phi_6086_ = _e2254;
                                            }
                                            let _e2257 = phi_6086_;
                                            if (_e2243[2] < 0.0lf) {
                                                phi_6093_ = -(_e2243[2]);
                                            } else {
                                                phi_6093_ = _e2243[2];
                                            }
                                            let _e2261 = phi_6093_;
                                            if (_e2257 > _e2261) {
                                                phi_6098_ = _e2257;
                                            } else {
                                                phi_6098_ = _e2261;
                                            }
                                            let _e2264 = phi_6098_;
                                            let _e2267 = local_20.member[1u];
                                            if (_e2267[0] < 0.0lf) {
                                                phi_6111_ = -(_e2267[0]);
                                            } else {
                                                phi_6111_ = _e2267[0];
                                            }
                                            let _e2274 = phi_6111_;
                                            if (_e2267[1] < 0.0lf) {
                                                phi_6118_ = -(_e2267[1]);
                                            } else {
                                                phi_6118_ = _e2267[1];
                                            }
                                            let _e2278 = phi_6118_;
                                            if (_e2274 > _e2278) {
                                                phi_6123_ = _e2274;
                                            } else {
                                                phi_6123_ = _e2278;
                                            }
                                            let _e2281 = phi_6123_;
                                            if (_e2267[2] < 0.0lf) {
                                                phi_6130_ = -(_e2267[2]);
                                            } else {
                                                phi_6130_ = _e2267[2];
                                            }
                                            let _e2285 = phi_6130_;
                                            if (_e2281 > _e2285) {
                                                phi_6135_ = _e2281;
                                            } else {
                                                phi_6135_ = _e2285;
                                            }
                                            let _e2288 = phi_6135_;
                                            if (_e2264 > _e2288) {
                                                phi_6140_ = _e2264;
                                            } else {
                                                phi_6140_ = _e2288;
                                            }
                                            let _e2291 = phi_6140_;
                                            let _e2293 = local_20.member_3;
                                            let _e2297 = local_20.member_1[0u];
                                            if (_e2297[0] < 0.0lf) {
                                                phi_6157_ = -(_e2297[0]);
                                            } else {
                                                phi_6157_ = _e2297[0];
                                            }
                                            let _e2304 = phi_6157_;
                                            if (_e2297[1] < 0.0lf) {
                                                phi_6164_ = -(_e2297[1]);
                                            } else {
                                                phi_6164_ = _e2297[1];
                                            }
                                            let _e2308 = phi_6164_;
                                            if (_e2304 > _e2308) {
                                                phi_6169_ = _e2304;
                                            } else {
                                                phi_6169_ = _e2308;
                                            }
                                            let _e2311 = phi_6169_;
                                            if (_e2297[2] < 0.0lf) {
                                                phi_6176_ = -(_e2297[2]);
                                            } else {
                                                phi_6176_ = _e2297[2];
                                            }
                                            let _e2315 = phi_6176_;
                                            if (_e2311 > _e2315) {
                                                phi_6181_ = _e2311;
                                            } else {
                                                phi_6181_ = _e2315;
                                            }
                                            let _e2318 = phi_6181_;
                                            let _e2321 = local_20.member_1[1u];
                                            if (_e2321[0] < 0.0lf) {
                                                phi_6195_ = -(_e2321[0]);
                                            } else {
                                                phi_6195_ = _e2321[0];
                                            }
                                            let _e2328 = phi_6195_;
                                            if (_e2321[1] < 0.0lf) {
                                                phi_6202_ = -(_e2321[1]);
                                            } else {
                                                phi_6202_ = _e2321[1];
                                            }
                                            let _e2332 = phi_6202_;
                                            if (_e2328 > _e2332) {
                                                phi_6207_ = _e2328;
                                            } else {
                                                phi_6207_ = _e2332;
                                            }
                                            let _e2335 = phi_6207_;
                                            if (_e2321[2] < 0.0lf) {
                                                phi_6214_ = -(_e2321[2]);
                                            } else {
                                                phi_6214_ = _e2321[2];
                                            }
                                            let _e2339 = phi_6214_;
                                            if (_e2335 > _e2339) {
                                                phi_6219_ = _e2335;
                                            } else {
                                                phi_6219_ = _e2339;
                                            }
                                            let _e2342 = phi_6219_;
                                            if (_e2318 > _e2342) {
                                                phi_6224_ = _e2318;
                                            } else {
                                                phi_6224_ = _e2342;
                                            }
                                            let _e2345 = phi_6224_;
                                            let _e2347 = local_20.member_3;
                                            let _e2351 = local_20.member_2[0u];
                                            if (_e2351[0] < 0.0lf) {
                                                phi_6241_ = -(_e2351[0]);
                                            } else {
                                                phi_6241_ = _e2351[0];
                                            }
                                            let _e2358 = phi_6241_;
                                            if (_e2351[1] < 0.0lf) {
                                                phi_6248_ = -(_e2351[1]);
                                            } else {
                                                phi_6248_ = _e2351[1];
                                            }
                                            let _e2362 = phi_6248_;
                                            if (_e2358 > _e2362) {
                                                phi_6253_ = _e2358;
                                            } else {
                                                phi_6253_ = _e2362;
                                            }
                                            let _e2365 = phi_6253_;
                                            if (_e2351[2] < 0.0lf) {
                                                phi_6260_ = -(_e2351[2]);
                                            } else {
                                                phi_6260_ = _e2351[2];
                                            }
                                            let _e2369 = phi_6260_;
                                            if (_e2365 > _e2369) {
                                                phi_6265_ = _e2365;
                                            } else {
                                                phi_6265_ = _e2369;
                                            }
                                            let _e2372 = phi_6265_;
                                            let _e2375 = local_20.member_2[1u];
                                            if (_e2375[0] < 0.0lf) {
                                                phi_6279_ = -(_e2375[0]);
                                            } else {
                                                phi_6279_ = _e2375[0];
                                            }
                                            let _e2382 = phi_6279_;
                                            if (_e2375[1] < 0.0lf) {
                                                phi_6286_ = -(_e2375[1]);
                                            } else {
                                                phi_6286_ = _e2375[1];
                                            }
                                            let _e2386 = phi_6286_;
                                            if (_e2382 > _e2386) {
                                                phi_6291_ = _e2382;
                                            } else {
                                                phi_6291_ = _e2386;
                                            }
                                            let _e2389 = phi_6291_;
                                            if (_e2375[2] < 0.0lf) {
                                                phi_6298_ = -(_e2375[2]);
                                            } else {
                                                phi_6298_ = _e2375[2];
                                            }
                                            let _e2393 = phi_6298_;
                                            if (_e2389 > _e2393) {
                                                phi_6303_ = _e2389;
                                            } else {
                                                phi_6303_ = _e2393;
                                            }
                                            let _e2396 = phi_6303_;
                                            if (_e2372 > _e2396) {
                                                phi_6308_ = _e2372;
                                            } else {
                                                phi_6308_ = _e2396;
                                            }
                                            let _e2399 = phi_6308_;
                                            let _e2401 = local_20.member_3;
                                            let _e2409 = local_20.member_3;
                                            phi_6328_ = type_30(0u, 48u);
                                            phi_6331_ = _e1429.member;
                                            loop {
                                                let _e2418 = phi_6328_;
                                                let _e2420 = phi_6331_;
                                                local_70 = _e2420;
                                                local_32 = _e2420;
                                                local_33 = _e2420;
                                                local_34 = _e2420;
                                                local_35 = _e2420;
                                                if (_e2418.member < _e2418.member_1) {
                                                    phi_6329_ = type_30((_e2418.member + 1u), _e2418.member_1);
                                                    phi_6354_ = type_30(1u, _e2418.member);
                                                } else {
                                                    phi_6329_ = _e2418;
                                                    phi_6354_ = type_30(0u, type_30().member_1);
                                                }
                                                let _e2434 = phi_6329_;
                                                let _e2436 = phi_6354_;
                                                if (bitcast<i32>(_e2436.member) != 0i) {
                                                    let _e2442 = local_20.member[0u];
                                                    let _e2448 = local_20.member[1u];
                                                    let _e2458 = (_e2442[0] + ((_e2448[0] - _e2442[0]) * _e2420));
                                                    let _e2459 = (_e2442[1] + ((_e2448[1] - _e2442[1]) * _e2420));
                                                    let _e2460 = (_e2442[2] + ((_e2448[2] - _e2442[2]) * _e2420));
                                                    let _e2463 = local_20.member_1[0u];
                                                    let _e2469 = local_20.member_1[1u];
                                                    let _e2479 = (_e2463[0] + ((_e2469[0] - _e2463[0]) * _e2420));
                                                    let _e2480 = (_e2463[1] + ((_e2469[1] - _e2463[1]) * _e2420));
                                                    let _e2481 = (_e2463[2] + ((_e2469[2] - _e2463[2]) * _e2420));
                                                    let _e2484 = local_20.member_2[0u];
                                                    let _e2490 = local_20.member_2[1u];
                                                    let _e2500 = (_e2484[0] + ((_e2490[0] - _e2484[0]) * _e2420));
                                                    let _e2501 = (_e2484[1] + ((_e2490[1] - _e2484[1]) * _e2420));
                                                    let _e2502 = (_e2484[2] + ((_e2490[2] - _e2484[2]) * _e2420));
                                                    let _e2507 = (((_e2479 * _e2479) + (_e2480 * _e2480)) + (_e2481 * _e2481));
                                                    let _e2512 = (((_e2479 * _e2500) + (_e2480 * _e2501)) + (_e2481 * _e2502));
                                                    let _e2517 = (((_e2500 * _e2500) + (_e2501 * _e2501)) + (_e2502 * _e2502));
                                                    let _e2522 = (((_e2458 * _e2479) + (_e2459 * _e2480)) + (_e2460 * _e2481));
                                                    let _e2527 = (((_e2458 * _e2500) + (_e2459 * _e2501)) + (_e2460 * _e2502));
                                                    let _e2530 = ((_e2507 * _e2517) - (_e2512 * _e2512));
                                                    let _e2531 = f64(0f);
                                                    let _e2536 = (((_e2522 * _e2517) - (_e2527 * _e2512)) / _e2530);
                                                    let _e2540 = (((_e2527 * _e2507) - (_e2522 * _e2512)) / _e2530);
                                                    if (_e2536 >= _e2531) {
                                                        if (_e2540 >= _e2531) {
                                                            phi_6530_ = ((_e2536 + _e2540) <= f64(1f));
                                                            phi_6531_ = false;
                                                        } else {
                                                            phi_6530_ = bool();
                                                            phi_6531_ = true;
                                                        }
                                                        let _e2546 = phi_6530_;
                                                        let _e2548 = phi_6531_;
                                                        phi_6532_ = _e2546;
                                                        phi_6533_ = _e2548;
                                                    } else {
                                                        phi_6532_ = bool();
                                                        phi_6533_ = true;
                                                    }
                                                    let _e2550 = phi_6532_;
                                                    let _e2552 = phi_6533_;
                                                    if _e2552 {
                                                        phi_6537_ = false;
                                                    } else {
                                                        phi_6537_ = _e2550;
                                                    }
                                                    let _e2554 = phi_6537_;
                                                    if (_e2530 > _e2531) {
                                                        if _e2554 {
                                                            phi_6559_ = array<f64, 3>((_e2458 - ((_e2479 * _e2536) + (_e2500 * _e2540))), (_e2459 - ((_e2480 * _e2536) + (_e2501 * _e2540))), (_e2460 - ((_e2481 * _e2536) + (_e2502 * _e2540))));
                                                            phi_6560_ = false;
                                                        } else {
                                                            phi_6559_ = array<f64, 3>();
                                                            phi_6560_ = true;
                                                        }
                                                        let _e2570 = phi_6559_;
                                                        let _e2572 = phi_6560_;
                                                        phi_6561_ = _e2570;
                                                        phi_6562_ = _e2572;
                                                    } else {
                                                        phi_6561_ = array<f64, 3>();
                                                        phi_6562_ = true;
                                                    }
                                                    let _e2574 = phi_6561_;
                                                    let _e2576 = phi_6562_;
                                                    if _e2576 {
                                                        let _e2577 = (_e2458 - _e2479);
                                                        let _e2578 = (_e2459 - _e2480);
                                                        let _e2579 = (_e2460 - _e2481);
                                                        let _e2580 = (_e2500 - _e2479);
                                                        let _e2581 = (_e2501 - _e2480);
                                                        let _e2582 = (_e2502 - _e2481);
                                                        let _e2593 = ((((_e2577 * _e2580) + (_e2578 * _e2581)) + (_e2579 * _e2582)) / (((_e2580 * _e2580) + (_e2581 * _e2581)) + (_e2582 * _e2582)));
                                                        if (_e2593 > f64(0f)) {
                                                            if (_e2593 < f64(1f)) {
                                                                phi_6749_ = _e2593;
                                                            } else {
                                                                phi_6749_ = f64(1f);
                                                            }
                                                            let _e2601 = phi_6749_;
                                                            phi_6751_ = _e2601;
                                                        } else {
                                                            phi_6751_ = f64(0f);
                                                        }
                                                        let _e2603 = phi_6751_;
                                                        let _e2607 = (_e2577 - (_e2580 * _e2603));
                                                        let _e2608 = (_e2578 - (_e2581 * _e2603));
                                                        let _e2609 = (_e2579 - (_e2582 * _e2603));
                                                        let _e2620 = ((((_e2458 * _e2479) + (_e2459 * _e2480)) + (_e2460 * _e2481)) / (((_e2479 * _e2479) + (_e2480 * _e2480)) + (_e2481 * _e2481)));
                                                        if (_e2620 > f64(0f)) {
                                                            if (_e2620 < f64(1f)) {
                                                                phi_6781_ = _e2620;
                                                            } else {
                                                                phi_6781_ = f64(1f);
                                                            }
                                                            let _e2628 = phi_6781_;
                                                            phi_6783_ = _e2628;
                                                        } else {
                                                            phi_6783_ = f64(0f);
                                                        }
                                                        let _e2630 = phi_6783_;
                                                        let _e2647 = ((((_e2458 * _e2500) + (_e2459 * _e2501)) + (_e2460 * _e2502)) / (((_e2500 * _e2500) + (_e2501 * _e2501)) + (_e2502 * _e2502)));
                                                        if (_e2647 > f64(0f)) {
                                                            if (_e2647 < f64(1f)) {
                                                                phi_6813_ = _e2647;
                                                            } else {
                                                                phi_6813_ = f64(1f);
                                                            }
                                                            let _e2655 = phi_6813_;
                                                            phi_6815_ = _e2655;
                                                        } else {
                                                            phi_6815_ = f64(0f);
                                                        }
                                                        let _e2657 = phi_6815_;
                                                        local[0u] = array<f64, 3>((_e2458 - (_e2479 * _e2630)), (_e2459 - (_e2480 * _e2630)), (_e2460 - (_e2481 * _e2630)));
                                                        local[1u] = array<f64, 3>((_e2458 - (_e2500 * _e2657)), (_e2459 - (_e2501 * _e2657)), (_e2460 - (_e2502 * _e2657)));
                                                        local[2u] = array<f64, 3>(_e2607, _e2608, _e2609);
                                                        local[3u] = array<f64, 3>(_e2607, _e2608, _e2609);
                                                        let _e2673 = local[0u];
                                                        phi_6851_ = type_30(1u, 4u);
                                                        phi_6854_ = array<f64, 3>(_e2673[0], _e2673[1], _e2673[2]);
                                                        loop {
                                                            let _e2679 = phi_6851_;
                                                            let _e2681 = phi_6854_;
                                                            local_57 = _e2681;
                                                            if (_e2679.member < _e2679.member_1) {
                                                                phi_6852_ = type_30((_e2679.member + 1u), _e2679.member_1);
                                                                phi_6877_ = type_30(1u, _e2679.member);
                                                            } else {
                                                                phi_6852_ = _e2679;
                                                                phi_6877_ = type_30(0u, type_30().member_1);
                                                            }
                                                            let _e2695 = phi_6852_;
                                                            let _e2697 = phi_6877_;
                                                            let _e2701 = (bitcast<i32>(_e2697.member) != 0i);
                                                            if _e2701 {
                                                                if (_e2697.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2704 = local[_e2697.member_1];
                                                                if (_e2697.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2710 = local[_e2697.member_1];
                                                                if ((((_e2704[0] * _e2710[0]) + (_e2704[1] * _e2710[1])) + (_e2704[2] * _e2710[2])) < (((_e2681[0] * _e2681[0]) + (_e2681[1] * _e2681[1])) + (_e2681[2] * _e2681[2]))) {
                                                                    if (_e2697.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2733 = local[_e2697.member_1];
                                                                    phi_6944_ = array<f64, 3>(_e2733[0], _e2733[1], _e2733[2]);
                                                                } else {
                                                                    phi_6944_ = _e2681;
                                                                }
                                                                let _e2739 = phi_6944_;
                                                                phi_6855_ = _e2739;
                                                            } else {
                                                                phi_6855_ = array<f64, 3>();
                                                            }
                                                            let _e2741 = phi_6855_;
                                                            continue;
                                                            continuing {
                                                                phi_6851_ = _e2695;
                                                                phi_6854_ = _e2741;
                                                                break if !(_e2701);
                                                            }
                                                        }
                                                        let _e5330 = local_57;
                                                        phi_6945_ = _e5330;
                                                    } else {
                                                        phi_6945_ = _e2574;
                                                    }
                                                    let _e2744 = phi_6945_;
                                                    if (_e2744[0] < 0.0lf) {
                                                        phi_6952_ = -(_e2744[0]);
                                                    } else {
                                                        phi_6952_ = _e2744[0];
                                                    }
                                                    let _e2749 = phi_6952_;
                                                    if (_e2744[1] < 0.0lf) {
                                                        phi_6959_ = -(_e2744[1]);
                                                    } else {
                                                        phi_6959_ = _e2744[1];
                                                    }
                                                    let _e2754 = phi_6959_;
                                                    if (_e2744[2] < 0.0lf) {
                                                        phi_6967_ = -(_e2744[2]);
                                                    } else {
                                                        phi_6967_ = _e2744[2];
                                                    }
                                                    let _e2760 = phi_6967_;
                                                    let _e2761 = ((_e2749 + _e2754) + _e2760);
                                                    if (_e2761 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2761) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2767 = (f64(1f) / _e2761);
                                                            let _e2769 = (_e2744[0] * _e2767);
                                                            let _e2771 = (_e2744[1] * _e2767);
                                                            let _e2773 = (_e2744[2] * _e2767);
                                                            let _e2778 = (((_e2769 * _e2769) + (_e2771 * _e2771)) + (_e2773 * _e2773));
                                                            if (_e2778 <= 2.2250738585072014e-308lf) {
                                                                if (_e2778 > 0.0lf) {
                                                                    phi_7005_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_7005_ = 0.0lf;
                                                                }
                                                                let _e2836 = phi_7005_;
                                                                phi_7069_ = _e2836;
                                                            } else {
                                                                phi_7012_ = type_28(0i, 5i);
                                                                phi_7015_ = bitcast<f64>(((bitcast<u64>(_e2778) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2785 = phi_7012_;
                                                                    let _e2787 = phi_7015_;
                                                                    local_26 = _e2787;
                                                                    if (_e2785.member < _e2785.member_1) {
                                                                        let _e2795 = (_e2785.member + 1i);
                                                                        if ((false == (_e2795 > _e2785.member)) != false) {
                                                                            phi_7036_ = true;
                                                                        } else {
                                                                            phi_7036_ = false;
                                                                        }
                                                                        let _e2800 = phi_7036_;
                                                                        if _e2800 {
                                                                            phi_7042_ = type_29(0u, type_29().member_1);
                                                                        } else {
                                                                            phi_7042_ = type_29(1u, _e2795);
                                                                        }
                                                                        let _e2806 = phi_7042_;
                                                                        if (bitcast<i32>(_e2806.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_7013_ = type_28(_e2806.member_1, _e2785.member_1);
                                                                        phi_7056_ = type_29(1u, _e2785.member);
                                                                    } else {
                                                                        phi_7013_ = _e2785;
                                                                        phi_7056_ = type_29(0u, type_29().member_1);
                                                                    }
                                                                    let _e2816 = phi_7013_;
                                                                    let _e2818 = phi_7056_;
                                                                    let _e2821 = (bitcast<i32>(_e2818.member) != 0i);
                                                                    if _e2821 {
                                                                        phi_7016_ = (0.5lf * (_e2787 + (_e2778 / _e2787)));
                                                                    } else {
                                                                        phi_7016_ = f64();
                                                                    }
                                                                    let _e2826 = phi_7016_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7012_ = _e2816;
                                                                        phi_7015_ = _e2826;
                                                                        break if !(_e2821);
                                                                    }
                                                                }
                                                                let _e2831 = local_26;
                                                                phi_7069_ = (_e2831 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2838 = phi_7069_;
                                                            phi_7082_ = type_30(0u, 4u);
                                                            phi_7085_ = f64(2f);
                                                            loop {
                                                                let _e2850 = phi_7082_;
                                                                let _e2852 = phi_7085_;
                                                                local_28 = _e2852;
                                                                local_29 = _e2852;
                                                                local_30 = _e2852;
                                                                local_60 = _e2852;
                                                                local_61 = _e2852;
                                                                if (_e2850.member < _e2850.member_1) {
                                                                    phi_7083_ = type_30((_e2850.member + 1u), _e2850.member_1);
                                                                    phi_7108_ = type_30(1u, _e2850.member);
                                                                } else {
                                                                    phi_7083_ = _e2850;
                                                                    phi_7108_ = type_30(0u, type_30().member_1);
                                                                }
                                                                let _e2866 = phi_7083_;
                                                                let _e2868 = phi_7108_;
                                                                if (bitcast<i32>(_e2868.member) != 0i) {
                                                                    if (_e2868.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2875 = local_1[_e2868.member_1];
                                                                    let _e2883 = (((_e2769 * _e2875[0]) + (_e2771 * _e2875[1])) + (_e2773 * _e2875[2]));
                                                                    if (_e2868.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2886 = local_2[_e2868.member_1];
                                                                    let _e2894 = (((_e2769 * _e2886[0]) + (_e2771 * _e2886[1])) + (_e2773 * _e2886[2]));
                                                                    if (_e2883 < 0.0lf) {
                                                                        phi_7159_ = -(_e2883);
                                                                    } else {
                                                                        phi_7159_ = _e2883;
                                                                    }
                                                                    let _e2898 = phi_7159_;
                                                                    if (_e2894 < 0.0lf) {
                                                                        phi_7165_ = -(_e2894);
                                                                    } else {
                                                                        phi_7165_ = _e2894;
                                                                    }
                                                                    let _e2902 = phi_7165_;
                                                                    let _e2907 = (((((((((_e2291 + _e2293) + (_e2345 + _e2347)) + (_e2399 + _e2401)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2409 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2838) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2898 + _e2902) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2883 > _e2907) {
                                                                        if (_e2894 > _e2907) {
                                                                            phi_7179_ = false;
                                                                        } else {
                                                                            phi_7179_ = true;
                                                                        }
                                                                        let _e2911 = phi_7179_;
                                                                        phi_7180_ = _e2911;
                                                                    } else {
                                                                        phi_7180_ = true;
                                                                    }
                                                                    let _e2913 = phi_7180_;
                                                                    if _e2913 {
                                                                        if ((_e2883 + ((_e2894 - _e2883) * _e2420)) > _e2907) {
                                                                            if (_e2894 < _e2883) {
                                                                                let _e2922 = ((_e2883 - _e2894) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                                                if _e2922 {
                                                                                    let _e2930 = (((_e2883 - _e2907) / (_e2883 - _e2894)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    if (_e2852 < _e2930) {
                                                                                        phi_7214_ = _e2852;
                                                                                    } else {
                                                                                        phi_7214_ = _e2930;
                                                                                    }
                                                                                    let _e2933 = phi_7214_;
                                                                                    phi_7215_ = _e2933;
                                                                                } else {
                                                                                    phi_7215_ = f64();
                                                                                }
                                                                                let _e2935 = phi_7215_;
                                                                                phi_7216_ = _e2935;
                                                                                phi_7217_ = _e2922;
                                                                            } else {
                                                                                phi_7216_ = _e2852;
                                                                                phi_7217_ = true;
                                                                            }
                                                                            let _e2937 = phi_7216_;
                                                                            let _e2939 = phi_7217_;
                                                                            if _e2939 {
                                                                                phi_7221_ = false;
                                                                            } else {
                                                                                phi_7221_ = true;
                                                                            }
                                                                            let _e2941 = phi_7221_;
                                                                            phi_7222_ = _e2937;
                                                                            phi_7223_ = _e2939;
                                                                            phi_7224_ = _e2941;
                                                                            phi_7225_ = false;
                                                                        } else {
                                                                            phi_7222_ = f64();
                                                                            phi_7223_ = false;
                                                                            phi_7224_ = false;
                                                                            phi_7225_ = true;
                                                                        }
                                                                        let _e2943 = phi_7222_;
                                                                        let _e2945 = phi_7223_;
                                                                        let _e2947 = phi_7224_;
                                                                        let _e2949 = phi_7225_;
                                                                        phi_7226_ = _e2943;
                                                                        phi_7227_ = _e2945;
                                                                        phi_7228_ = _e2947;
                                                                        phi_7229_ = _e2949;
                                                                    } else {
                                                                        phi_7226_ = _e2852;
                                                                        phi_7227_ = true;
                                                                        phi_7228_ = false;
                                                                        phi_7229_ = false;
                                                                    }
                                                                    let _e2951 = phi_7226_;
                                                                    let _e2953 = phi_7227_;
                                                                    let _e2955 = phi_7228_;
                                                                    let _e2957 = phi_7229_;
                                                                    phi_7086_ = _e2951;
                                                                    phi_7230_ = _e2953;
                                                                    phi_7231_ = false;
                                                                    phi_7232_ = _e2955;
                                                                    phi_7233_ = _e2957;
                                                                } else {
                                                                    phi_7086_ = f64();
                                                                    phi_7230_ = false;
                                                                    phi_7231_ = true;
                                                                    phi_7232_ = false;
                                                                    phi_7233_ = false;
                                                                }
                                                                let _e2959 = phi_7086_;
                                                                let _e2961 = phi_7230_;
                                                                let _e2963 = phi_7231_;
                                                                let _e2965 = phi_7232_;
                                                                let _e2967 = phi_7233_;
                                                                local_27 = _e2963;
                                                                local_58 = _e2965;
                                                                local_59 = _e2967;
                                                                continue;
                                                                continuing {
                                                                    phi_7082_ = _e2866;
                                                                    phi_7085_ = _e2959;
                                                                    break if !(_e2961);
                                                                }
                                                            }
                                                            let _e2970 = local_27;
                                                            if _e2970 {
                                                                let _e2972 = local_28;
                                                                let _e2973 = (_e2972 > _e1429.member_1);
                                                                if _e2973 {
                                                                    phi_7255_ = false;
                                                                    phi_7256_ = false;
                                                                    phi_7257_ = false;
                                                                } else {
                                                                    let _e2975 = local_29;
                                                                    if (_e2975 > _e2420) {
                                                                        let _e2978 = local_30;
                                                                        let _e2981 = ((_e2978 - _e2420) < f64(0.00000000023283064f));
                                                                        if _e2981 {
                                                                            phi_7251_ = false;
                                                                        } else {
                                                                            phi_7251_ = true;
                                                                        }
                                                                        let _e2983 = phi_7251_;
                                                                        phi_7252_ = _e2983;
                                                                        phi_7253_ = _e2981;
                                                                        phi_7254_ = false;
                                                                    } else {
                                                                        phi_7252_ = false;
                                                                        phi_7253_ = false;
                                                                        phi_7254_ = true;
                                                                    }
                                                                    let _e2985 = phi_7252_;
                                                                    let _e2987 = phi_7253_;
                                                                    let _e2989 = phi_7254_;
                                                                    phi_7255_ = _e2985;
                                                                    phi_7256_ = _e2987;
                                                                    phi_7257_ = _e2989;
                                                                }
                                                                let _e2991 = phi_7255_;
                                                                let _e2993 = phi_7256_;
                                                                let _e2995 = phi_7257_;
                                                                phi_7258_ = _e2991;
                                                                phi_7259_ = _e2973;
                                                                phi_7260_ = _e2993;
                                                                phi_7261_ = _e2995;
                                                                phi_7262_ = false;
                                                                phi_7263_ = false;
                                                            } else {
                                                                phi_7258_ = false;
                                                                phi_7259_ = false;
                                                                phi_7260_ = false;
                                                                phi_7261_ = false;
                                                                let _e5387 = local_58;
                                                                phi_7262_ = _e5387;
                                                                let _e5390 = local_59;
                                                                phi_7263_ = _e5390;
                                                            }
                                                            let _e2997 = phi_7258_;
                                                            let _e2999 = phi_7259_;
                                                            let _e3001 = phi_7260_;
                                                            let _e3003 = phi_7261_;
                                                            let _e3005 = phi_7262_;
                                                            let _e3007 = phi_7263_;
                                                            let _e5393 = local_60;
                                                            phi_7264_ = _e5393;
                                                            let _e5396 = local_61;
                                                            phi_7265_ = _e5396;
                                                            phi_7266_ = _e2997;
                                                            phi_7267_ = _e2999;
                                                            phi_7268_ = _e3001;
                                                            phi_7269_ = _e3003;
                                                            phi_7270_ = _e3005;
                                                            phi_7271_ = _e3007;
                                                            phi_7272_ = false;
                                                        } else {
                                                            phi_7264_ = f64();
                                                            phi_7265_ = f64();
                                                            phi_7266_ = false;
                                                            phi_7267_ = false;
                                                            phi_7268_ = false;
                                                            phi_7269_ = false;
                                                            phi_7270_ = false;
                                                            phi_7271_ = false;
                                                            phi_7272_ = true;
                                                        }
                                                        let _e3009 = phi_7264_;
                                                        let _e3011 = phi_7265_;
                                                        let _e3013 = phi_7266_;
                                                        let _e3015 = phi_7267_;
                                                        let _e3017 = phi_7268_;
                                                        let _e3019 = phi_7269_;
                                                        let _e3021 = phi_7270_;
                                                        let _e3023 = phi_7271_;
                                                        let _e3025 = phi_7272_;
                                                        phi_7273_ = _e3009;
                                                        phi_7274_ = _e3011;
                                                        phi_7275_ = _e3013;
                                                        phi_7276_ = _e3015;
                                                        phi_7277_ = _e3017;
                                                        phi_7278_ = _e3019;
                                                        phi_7279_ = _e3021;
                                                        phi_7280_ = _e3023;
                                                        phi_7281_ = _e3025;
                                                        phi_7282_ = false;
                                                    } else {
                                                        phi_7273_ = f64();
                                                        phi_7274_ = f64();
                                                        phi_7275_ = false;
                                                        phi_7276_ = false;
                                                        phi_7277_ = false;
                                                        phi_7278_ = false;
                                                        phi_7279_ = false;
                                                        phi_7280_ = false;
                                                        phi_7281_ = false;
                                                        phi_7282_ = true;
                                                    }
                                                    let _e3027 = phi_7273_;
                                                    let _e3029 = phi_7274_;
                                                    let _e3031 = phi_7275_;
                                                    let _e3033 = phi_7276_;
                                                    let _e3035 = phi_7277_;
                                                    let _e3037 = phi_7278_;
                                                    let _e3039 = phi_7279_;
                                                    let _e3041 = phi_7280_;
                                                    let _e3043 = phi_7281_;
                                                    let _e3045 = phi_7282_;
                                                    phi_7283_ = _e3027;
                                                    phi_6332_ = _e3029;
                                                    phi_7284_ = _e3031;
                                                    phi_7285_ = _e3033;
                                                    phi_7286_ = _e3035;
                                                    phi_7287_ = false;
                                                    phi_7288_ = _e3037;
                                                    phi_7289_ = _e3039;
                                                    phi_7290_ = _e3041;
                                                    phi_7291_ = _e3043;
                                                    phi_7292_ = _e3045;
                                                } else {
                                                    phi_7283_ = f64();
                                                    phi_6332_ = f64();
                                                    phi_7284_ = false;
                                                    phi_7285_ = false;
                                                    phi_7286_ = false;
                                                    phi_7287_ = true;
                                                    phi_7288_ = false;
                                                    phi_7289_ = false;
                                                    phi_7290_ = false;
                                                    phi_7291_ = false;
                                                    phi_7292_ = false;
                                                }
                                                let _e3047 = phi_7283_;
                                                let _e3049 = phi_6332_;
                                                let _e3051 = phi_7284_;
                                                let _e3053 = phi_7285_;
                                                let _e3055 = phi_7286_;
                                                let _e3057 = phi_7287_;
                                                let _e3059 = phi_7288_;
                                                let _e3061 = phi_7289_;
                                                let _e3063 = phi_7290_;
                                                let _e3065 = phi_7291_;
                                                let _e3067 = phi_7292_;
                                                local_31 = _e3053;
                                                local_62 = _e3055;
                                                local_63 = _e3057;
                                                local_64 = _e3059;
                                                local_65 = _e3061;
                                                local_66 = _e3063;
                                                local_67 = _e3065;
                                                local_68 = _e3067;
                                                local_69 = _e3047;
                                                local_71 = _e3053;
                                                continue;
                                                continuing {
                                                    phi_6328_ = _e2434;
                                                    phi_6331_ = _e3049;
                                                    break if !(_e3051);
                                                }
                                            }
                                            let _e3070 = local_31;
                                            if _e3070 {
                                                phi_7297_ = type_73(0u, type_73().member_1);
                                                phi_7298_ = false;
                                                phi_7299_ = false;
                                                phi_7300_ = false;
                                                phi_7301_ = false;
                                                phi_7302_ = false;
                                                phi_7303_ = false;
                                                phi_7304_ = false;
                                            } else {
                                                phi_7297_ = type_73();
                                                let _e5429 = local_62;
                                                phi_7298_ = _e5429;
                                                let _e5432 = local_63;
                                                phi_7299_ = _e5432;
                                                let _e5435 = local_64;
                                                phi_7300_ = _e5435;
                                                let _e5438 = local_65;
                                                phi_7301_ = _e5438;
                                                let _e5441 = local_66;
                                                phi_7302_ = _e5441;
                                                let _e5444 = local_67;
                                                phi_7303_ = _e5444;
                                                let _e5447 = local_68;
                                                phi_7304_ = _e5447;
                                            }
                                            let _e3075 = phi_7297_;
                                            let _e3077 = phi_7298_;
                                            let _e3079 = phi_7299_;
                                            let _e3081 = phi_7300_;
                                            let _e3083 = phi_7301_;
                                            let _e3085 = phi_7302_;
                                            let _e3087 = phi_7303_;
                                            let _e3089 = phi_7304_;
                                            if _e3077 {
                                                let _e5450 = local_69;
                                                phi_7308_ = _e5450;
                                                phi_7309_ = true;
                                                phi_7310_ = false;
                                                phi_7311_ = false;
                                                phi_7312_ = false;
                                                phi_7313_ = false;
                                                phi_7314_ = false;
                                                phi_7315_ = false;
                                            } else {
                                                let _e5452 = local_70;
                                                phi_7308_ = _e5452;
                                                phi_7309_ = _e3079;
                                                phi_7310_ = _e3081;
                                                phi_7311_ = _e3083;
                                                phi_7312_ = _e3085;
                                                let _e5459 = local_71;
                                                phi_7313_ = _e5459;
                                                phi_7314_ = _e3087;
                                                phi_7315_ = _e3089;
                                            }
                                            let _e3091 = phi_7308_;
                                            let _e3093 = phi_7309_;
                                            let _e3095 = phi_7310_;
                                            let _e3097 = phi_7311_;
                                            let _e3099 = phi_7312_;
                                            let _e3101 = phi_7313_;
                                            let _e3103 = phi_7314_;
                                            let _e3105 = phi_7315_;
                                            if _e3093 {
                                                phi_7320_ = type_73(1u, _e3091);
                                                phi_7321_ = false;
                                                phi_7322_ = false;
                                                phi_7323_ = false;
                                                phi_7324_ = false;
                                                phi_7325_ = false;
                                                phi_7326_ = false;
                                            } else {
                                                phi_7320_ = type_73();
                                                phi_7321_ = _e3095;
                                                phi_7322_ = _e3097;
                                                phi_7323_ = _e3099;
                                                phi_7324_ = _e3101;
                                                phi_7325_ = _e3103;
                                                phi_7326_ = _e3105;
                                            }
                                            let _e3108 = phi_7320_;
                                            let _e3110 = phi_7321_;
                                            let _e3112 = phi_7322_;
                                            let _e3114 = phi_7323_;
                                            let _e3116 = phi_7324_;
                                            let _e3118 = phi_7325_;
                                            let _e3120 = phi_7326_;
                                            if _e3110 {
                                                let _e3122 = local_32;
                                                phi_7331_ = type_73(1u, _e3122);
                                                phi_7332_ = false;
                                                phi_7333_ = false;
                                                phi_7334_ = true;
                                                phi_7335_ = false;
                                                phi_7336_ = false;
                                            } else {
                                                phi_7331_ = _e3075;
                                                phi_7332_ = _e3112;
                                                phi_7333_ = _e3114;
                                                phi_7334_ = _e3116;
                                                phi_7335_ = _e3118;
                                                phi_7336_ = _e3120;
                                            }
                                            let _e3125 = phi_7331_;
                                            let _e3127 = phi_7332_;
                                            let _e3129 = phi_7333_;
                                            let _e3131 = phi_7334_;
                                            let _e3133 = phi_7335_;
                                            let _e3135 = phi_7336_;
                                            if _e3127 {
                                                let _e3137 = local_33;
                                                phi_7341_ = type_73(1u, _e3137);
                                                phi_7342_ = false;
                                                phi_7343_ = false;
                                                phi_7344_ = false;
                                                phi_7345_ = false;
                                            } else {
                                                phi_7341_ = type_73();
                                                phi_7342_ = _e3129;
                                                phi_7343_ = _e3131;
                                                phi_7344_ = _e3133;
                                                phi_7345_ = _e3135;
                                            }
                                            let _e3140 = phi_7341_;
                                            let _e3142 = phi_7342_;
                                            let _e3144 = phi_7343_;
                                            let _e3146 = phi_7344_;
                                            let _e3148 = phi_7345_;
                                            if _e3142 {
                                                let _e3150 = local_34;
                                                phi_7350_ = type_73(1u, _e3150);
                                                phi_7351_ = true;
                                                phi_7352_ = false;
                                                phi_7353_ = false;
                                                phi_7354_ = false;
                                            } else {
                                                phi_7350_ = _e3140;
                                                phi_7351_ = _e3127;
                                                phi_7352_ = _e3144;
                                                phi_7353_ = _e3146;
                                                phi_7354_ = _e3148;
                                            }
                                            let _e3153 = phi_7350_;
                                            let _e3155 = phi_7351_;
                                            let _e3157 = phi_7352_;
                                            let _e3159 = phi_7353_;
                                            let _e3161 = phi_7354_;
                                            if _e3155 {
                                                phi_7358_ = _e3153;
                                                phi_7359_ = true;
                                                phi_7360_ = false;
                                                phi_7361_ = false;
                                            } else {
                                                phi_7358_ = _e3125;
                                                phi_7359_ = _e3157;
                                                phi_7360_ = _e3159;
                                                phi_7361_ = _e3161;
                                            }
                                            let _e3163 = phi_7358_;
                                            let _e3165 = phi_7359_;
                                            let _e3167 = phi_7360_;
                                            let _e3169 = phi_7361_;
                                            if _e3165 {
                                                phi_7365_ = false;
                                                phi_7366_ = false;
                                            } else {
                                                phi_7365_ = _e3167;
                                                phi_7366_ = _e3169;
                                            }
                                            let _e3171 = phi_7365_;
                                            let _e3173 = phi_7366_;
                                            if _e3171 {
                                                phi_7370_ = false;
                                                phi_7371_ = false;
                                            } else {
                                                phi_7370_ = _e3173;
                                                phi_7371_ = _e3165;
                                            }
                                            let _e3175 = phi_7370_;
                                            let _e3177 = phi_7371_;
                                            if _e3175 {
                                                phi_7375_ = true;
                                                phi_7376_ = false;
                                            } else {
                                                phi_7375_ = _e3171;
                                                phi_7376_ = _e3177;
                                            }
                                            let _e3179 = phi_7375_;
                                            let _e3181 = phi_7376_;
                                            if _e3179 {
                                                let _e3183 = local_35;
                                                phi_7381_ = type_73(1u, _e3183);
                                                phi_7382_ = true;
                                            } else {
                                                phi_7381_ = _e3163;
                                                phi_7382_ = _e3181;
                                            }
                                            let _e3186 = phi_7381_;
                                            let _e3188 = phi_7382_;
                                            if _e3188 {
                                                phi_7386_ = _e3186;
                                            } else {
                                                phi_7386_ = _e3108;
                                            }
                                            let _e3190 = phi_7386_;
                                            let _e3193 = (_e3190.member != 0u);
                                            if _e3193 {
                                                phi_7393_ = false;
                                            } else {
                                                phi_7393_ = true;
                                            }
                                            let _e3195 = phi_7393_;
                                            phi_7394_ = _e3190.member_1;
                                            phi_7395_ = _e3195;
                                            phi_7396_ = _e3193;
                                            phi_7397_ = false;
                                        } else {
                                            phi_7394_ = f64();
                                            phi_7395_ = false;
                                            phi_7396_ = false;
                                            phi_7397_ = true;
                                        }
                                        let _e3197 = phi_7394_;
                                        let _e3199 = phi_7395_;
                                        let _e3201 = phi_7396_;
                                        let _e3203 = phi_7397_;
                                        phi_7398_ = _e3197;
                                        phi_7399_ = _e3199;
                                        phi_7400_ = _e3201;
                                        phi_7401_ = _e3203;
                                    }
                                    let _e3205 = phi_7398_;
                                    let _e3207 = phi_7399_;
                                    let _e3209 = phi_7400_;
                                    let _e3211 = phi_7401_;
                                    phi_7402_ = _e3205;
                                    phi_7403_ = _e2170;
                                    phi_7404_ = _e3207;
                                    phi_7405_ = _e3209;
                                    phi_7406_ = _e3211;
                                }
                                let _e3213 = phi_7402_;
                                let _e3215 = phi_7403_;
                                let _e3217 = phi_7404_;
                                let _e3219 = phi_7405_;
                                let _e3221 = phi_7406_;
                                if _e3215 {
                                    phi_7410_ = true;
                                    phi_7411_ = false;
                                    phi_7412_ = false;
                                } else {
                                    phi_7410_ = _e3217;
                                    phi_7411_ = _e3219;
                                    phi_7412_ = _e3221;
                                }
                                let _e3223 = phi_7410_;
                                let _e3225 = phi_7411_;
                                let _e3227 = phi_7412_;
                                phi_7413_ = _e3213;
                                phi_7414_ = _e1429;
                                phi_7415_ = _e3223;
                                phi_7416_ = false;
                                phi_7417_ = _e3225;
                                phi_7418_ = _e3227;
                            } else {
                                phi_7413_ = f64();
                                phi_7414_ = type_74();
                                phi_7415_ = false;
                                phi_7416_ = true;
                                phi_7417_ = false;
                                phi_7418_ = false;
                            }
                            let _e3229 = phi_7413_;
                            let _e3231 = phi_7414_;
                            let _e3233 = phi_7415_;
                            let _e3235 = phi_7416_;
                            let _e3237 = phi_7417_;
                            let _e3239 = phi_7418_;
                            local_36 = _e3235;
                            local_72 = _e3237;
                            local_73 = _e3239;
                            local_37 = _e3229;
                            local_38 = _e3231;
                            continue;
                            continuing {
                                phi_4367_ = _e1110;
                                break if !(_e3233);
                            }
                        }
                        let _e3242 = local_36;
                        if _e3242 {
                            phi_7423_ = type_73(0u, type_73().member_1);
                            phi_7424_ = false;
                            phi_7425_ = false;
                        } else {
                            phi_7423_ = type_73();
                            let _e5529 = local_72;
                            phi_7424_ = _e5529;
                            let _e5532 = local_73;
                            phi_7425_ = _e5532;
                        }
                        let _e3247 = phi_7423_;
                        let _e3249 = phi_7424_;
                        let _e3251 = phi_7425_;
                        if _e3249 {
                            let _e3253 = local_37;
                            phi_7430_ = type_73(2u, _e3253);
                            phi_7431_ = false;
                        } else {
                            phi_7430_ = type_73();
                            phi_7431_ = _e3251;
                        }
                        let _e3256 = phi_7430_;
                        let _e3258 = phi_7431_;
                        if _e3258 {
                            let _e3260 = local_38;
                            phi_7437_ = type_73(1u, _e3260.member);
                            phi_7438_ = true;
                        } else {
                            phi_7437_ = _e3256;
                            phi_7438_ = _e3249;
                        }
                        let _e3264 = phi_7437_;
                        let _e3266 = phi_7438_;
                        if _e3266 {
                            phi_7442_ = _e3264;
                        } else {
                            phi_7442_ = _e3247;
                        }
                        let _e3268 = phi_7442_;
                        phi_7446_ = _e3268;
                    }
                    let _e4904 = phi_7446_;
                    phi_7447_ = _e4904;
                }
                let _e4909 = phi_7447_;
                switch bitcast<i32>(_e4909.member) {
                    case 0: {
                        phi_7460_ = type_56(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4915 = function_(_e4909.member_1);
                        phi_7460_ = type_56(0u, _e4915, true);
                        break;
                    }
                    case 2: {
                        let _e4913 = function_(_e4909.member_1);
                        phi_7460_ = type_56(1u, _e4913, true);
                        break;
                    }
                    default: {
                        phi_7460_ = type_56();
                        break;
                    }
                }
                let _e4918 = phi_7460_;
                if _e4918.member_2 {
                    let _e4925 = (_e4918.member_1[1] >> bitcast<u32>(20i));
                    if (_e4925 <= 896u) {
                        phi_7483_ = 0u;
                    } else {
                        phi_7483_ = ((((_e4925 - 896u) << bitcast<u32>(23i)) | ((_e4918.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4918.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4940 = phi_7483_;
                    let _e4942 = atomicMin((&earliest.member[0u]), _e4940);
                }
                phi_7487_ = type_55(_e186, _e4918.member, _e192, _e195, _e4918.member_1);
                phi_7488_ = _e4918.member_2;
            } else {
                phi_7487_ = type_55(_e186, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_7488_ = false;
            }
            let _e4944 = phi_7487_;
            let _e4946 = phi_7488_;
            let _e4948 = params.member.member_1;
            if ((_e4948 & 16u) != 0u) {
                if (_e117 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4946 {
                    let _e4954 = atomicAdd((&counters[0u]), 1u);
                    phi_7506_ = _e4954;
                } else {
                    phi_7506_ = 0u;
                }
                let _e4956 = phi_7506_;
                workgroupBarrier();
                if (_e117 == 0u) {
                    let _e4959 = atomicLoad((&counters[0u]));
                    if (_e4959 > 0u) {
                        let _e4962 = atomicAdd((&contacts.member[0u]), _e4959);
                        atomicStore((&counters[1u]), _e4962);
                    }
                }
                workgroupBarrier();
                let _e4965 = atomicLoad((&counters[1u]));
                let _e4966 = (_e4965 + _e4956);
                if _e4946 {
                    let _e4968 = params.member.member_16;
                    if (_e4966 < _e4968) {
                        let _e4970 = (6u * _e4966);
                        atomicStore((&contacts.member[(4u + _e4970)]), _e4944.member);
                        atomicStore((&contacts.member[(_e4970 + 5u)]), _e4944.member_1);
                        atomicStore((&contacts.member[(_e4970 + 6u)]), _e4944.member_2);
                        atomicStore((&contacts.member[(_e4970 + 7u)]), _e4944.member_3);
                        atomicStore((&contacts.member[(_e4970 + 8u)]), _e4944.member_4[0]);
                        atomicStore((&contacts.member[(_e4970 + 9u)]), _e4944.member_4[1]);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_281_ = _e174;
            break if !(_e180);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_1();
}
