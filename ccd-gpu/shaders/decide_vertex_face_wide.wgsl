struct type_9 {
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

struct type_10 {
    member: type_9,
}

struct type_12 {
    member: array<u32>,
}

struct type_14 {
    member: array<array<u32, 3>>,
}

struct type_17 {
    member: i32,
    member_1: i32,
}

struct type_18 {
    member: u32,
    member_1: i32,
}

struct type_19 {
    member: u32,
    member_1: u32,
}

struct type_23 {
    member: array<array<f64, 3>>,
}

struct type_25 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_27 {
    member: array<type_25>,
}

struct type_30 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_31 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_33 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_34 {
    member: f64,
    member_1: f64,
}

struct type_39 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_40 {
    member: u32,
    member_1: f64,
}

struct type_41 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_44 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_10;
@group(0) @binding(1) 
var<storage> paths: type_27;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_44;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> wide: type_23;
@group(0) @binding(4) 
var<storage> input: type_12;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_44;
@group(0) @binding(3) 
var<storage> elements: type_14;

fn function_(param: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_1(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<array<f64, 3>, 4>;
    var local_1: array<array<f64, 3>, 4>;
    var local_2: array<array<f64, 3>, 4>;
    var local_3: type_33;
    var local_4: type_33;
    var local_5: type_33;
    var local_6: array<type_34, 4>;
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
    var local_20: type_39;
    var phi_240_: u32;
    var phi_256_: u32;
    var phi_277_: u32;
    var phi_278_: u32;
    var phi_281_: type_19;
    var phi_282_: type_19;
    var phi_305_: type_19;
    var phi_637_: type_19;
    var phi_638_: type_19;
    var phi_661_: type_19;
    var phi_517_: type_19;
    var phi_518_: type_19;
    var phi_541_: type_19;
    var phi_551_: type_19;
    var phi_552_: type_19;
    var phi_575_: type_19;
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
    var phi_4187_: type_17;
    var phi_4190_: f64;
    var phi_4211_: bool;
    var phi_4217_: type_18;
    var phi_4188_: type_17;
    var phi_4231_: type_18;
    var phi_4191_: f64;
    var local_21: f64;
    var phi_4180_: f64;
    var phi_4244_: f64;
    var phi_4250_: f64;
    var phi_4275_: type_19;
    var phi_4278_: u32;
    var phi_4276_: type_19;
    var phi_4301_: type_19;
    var phi_4345_: u32;
    var phi_4346_: u32;
    var phi_4279_: u32;
    var phi_4347_: u32;
    var phi_4367_: type_19;
    var phi_4368_: type_19;
    var phi_4391_: type_19;
    var phi_4445_: f64;
    var phi_4452_: f64;
    var phi_4464_: bool;
    var phi_4465_: bool;
    var phi_4466_: bool;
    var phi_4467_: bool;
    var phi_4471_: bool;
    var phi_4483_: type_41;
    var phi_4484_: type_41;
    var phi_4485_: bool;
    var phi_4486_: type_41;
    var phi_4487_: bool;
    var phi_4500_: f64;
    var phi_4513_: type_19;
    var phi_4516_: f64;
    var phi_4518_: f64;
    var phi_4520_: f64;
    var phi_4514_: type_19;
    var phi_4543_: type_19;
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
    var phi_4648_: type_19;
    var phi_4651_: f64;
    var phi_4649_: type_19;
    var phi_4674_: type_19;
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
    var phi_4770_: type_41;
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
    var phi_5778_: type_19;
    var phi_5781_: bool;
    var phi_5779_: type_19;
    var phi_5804_: type_19;
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
    var phi_6328_: type_19;
    var phi_6331_: f64;
    var phi_6329_: type_19;
    var phi_6354_: type_19;
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
    var phi_6851_: type_19;
    var phi_6854_: array<f64, 3>;
    var phi_6852_: type_19;
    var phi_6877_: type_19;
    var phi_6944_: array<f64, 3>;
    var phi_6855_: array<f64, 3>;
    var phi_6945_: array<f64, 3>;
    var phi_6952_: f64;
    var phi_6959_: f64;
    var phi_6967_: f64;
    var phi_7012_: type_17;
    var phi_7015_: f64;
    var phi_7036_: bool;
    var phi_7042_: type_18;
    var phi_7013_: type_17;
    var phi_7056_: type_18;
    var phi_7016_: f64;
    var local_26: f64;
    var phi_7005_: f64;
    var phi_7069_: f64;
    var phi_7082_: type_19;
    var phi_7085_: f64;
    var phi_7083_: type_19;
    var phi_7108_: type_19;
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
    var phi_7297_: type_40;
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
    var phi_7320_: type_40;
    var phi_7321_: bool;
    var phi_7322_: bool;
    var phi_7323_: bool;
    var phi_7324_: bool;
    var phi_7325_: bool;
    var phi_7326_: bool;
    var local_32: f64;
    var phi_7331_: type_40;
    var phi_7332_: bool;
    var phi_7333_: bool;
    var phi_7334_: bool;
    var phi_7335_: bool;
    var phi_7336_: bool;
    var local_33: f64;
    var phi_7341_: type_40;
    var phi_7342_: bool;
    var phi_7343_: bool;
    var phi_7344_: bool;
    var phi_7345_: bool;
    var local_34: f64;
    var phi_7350_: type_40;
    var phi_7351_: bool;
    var phi_7352_: bool;
    var phi_7353_: bool;
    var phi_7354_: bool;
    var phi_7358_: type_40;
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
    var phi_7381_: type_40;
    var phi_7382_: bool;
    var phi_7386_: type_40;
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
    var phi_7414_: type_41;
    var phi_7415_: bool;
    var phi_7416_: bool;
    var phi_7417_: bool;
    var phi_7418_: bool;
    var local_36: bool;
    var phi_7423_: type_40;
    var phi_7424_: bool;
    var phi_7425_: bool;
    var local_37: f64;
    var phi_7430_: type_40;
    var phi_7431_: bool;
    var local_38: type_41;
    var phi_7437_: type_40;
    var phi_7438_: bool;
    var phi_7442_: type_40;
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
    var phi_1986_: type_19;
    var phi_1989_: f64;
    var phi_1987_: type_19;
    var phi_2012_: type_19;
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
    var phi_2509_: type_19;
    var phi_2512_: array<f64, 3>;
    var phi_2510_: type_19;
    var phi_2535_: type_19;
    var phi_2602_: array<f64, 3>;
    var phi_2513_: array<f64, 3>;
    var phi_2603_: array<f64, 3>;
    var phi_2610_: f64;
    var phi_2617_: f64;
    var phi_2625_: f64;
    var phi_2670_: type_17;
    var phi_2673_: f64;
    var phi_2694_: bool;
    var phi_2700_: type_18;
    var phi_2671_: type_17;
    var phi_2714_: type_18;
    var phi_2674_: f64;
    var local_39: f64;
    var phi_2663_: f64;
    var phi_2727_: f64;
    var phi_2740_: type_19;
    var phi_2743_: f64;
    var phi_2741_: type_19;
    var phi_2766_: type_19;
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
    var phi_2955_: type_40;
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
    var phi_2978_: type_40;
    var phi_2979_: bool;
    var phi_2980_: bool;
    var phi_2981_: bool;
    var phi_2982_: bool;
    var phi_2983_: bool;
    var phi_2984_: bool;
    var local_45: f64;
    var phi_2989_: type_40;
    var phi_2990_: bool;
    var phi_2991_: bool;
    var phi_2992_: bool;
    var phi_2993_: bool;
    var phi_2994_: bool;
    var local_46: f64;
    var phi_2999_: type_40;
    var phi_3000_: bool;
    var phi_3001_: bool;
    var phi_3002_: bool;
    var phi_3003_: bool;
    var local_47: f64;
    var phi_3008_: type_40;
    var phi_3009_: bool;
    var phi_3010_: bool;
    var phi_3011_: bool;
    var phi_3012_: bool;
    var phi_3016_: type_40;
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
    var phi_3039_: type_40;
    var phi_3040_: bool;
    var phi_3044_: type_40;
    var phi_3058_: type_19;
    var phi_3059_: type_19;
    var phi_3082_: type_19;
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
    var phi_3594_: type_19;
    var phi_3597_: array<f64, 3>;
    var phi_3595_: type_19;
    var phi_3620_: type_19;
    var phi_3687_: array<f64, 3>;
    var phi_3598_: array<f64, 3>;
    var phi_3688_: array<f64, 3>;
    var phi_3720_: type_17;
    var phi_3723_: f64;
    var phi_3744_: bool;
    var phi_3750_: type_18;
    var phi_3721_: type_17;
    var phi_3764_: type_18;
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
    var phi_4060_: type_40;
    var phi_4061_: bool;
    var phi_4066_: type_40;
    var phi_4067_: bool;
    var phi_4069_: type_40;
    var phi_4070_: type_40;
    var phi_4071_: bool;
    var phi_4075_: type_40;
    var phi_7446_: type_40;
    var phi_7447_: type_40;
    var phi_7460_: type_31;
    var phi_7483_: u32;
    var phi_7487_: type_30;
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
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e110 = id_2;
    let _e111 = n_2;
    let _e112 = lane_2;
    let _e124 = ((_e110.y * _e111.x) + _e110.x);
    let _e127 = (_e111.x * _e111.y);
    let _e129 = params.member.member_15;
    let _e131 = input.member[0u];
    if (_e129 < _e131) {
        phi_240_ = _e129;
    } else {
        phi_240_ = _e131;
    }
    let _e134 = phi_240_;
    let _e135 = (_e134 / 64u);
    if ((_e134 % 64u) > 0u) {
        phi_256_ = (_e135 + 1u);
    } else {
        phi_256_ = _e135;
    }
    let _e140 = phi_256_;
    if (_e140 > _e124) {
        let _e142 = (_e140 - _e124);
        if (_e127 == 0u) {
            return;
        }
        let _e144 = (_e142 / _e127);
        if (_e127 == 0u) {
            return;
        }
        if ((_e142 % _e127) > 0u) {
            phi_277_ = (_e144 + 1u);
        } else {
            phi_277_ = _e144;
        }
        let _e150 = phi_277_;
        phi_278_ = _e150;
    } else {
        phi_278_ = 0u;
    }
    let _e152 = phi_278_;
    phi_281_ = type_19(0u, _e152);
    loop {
        let _e155 = phi_281_;
        if (_e155.member < _e155.member_1) {
            phi_282_ = type_19((_e155.member + 1u), _e155.member_1);
            phi_305_ = type_19(1u, _e155.member);
        } else {
            phi_282_ = _e155;
            phi_305_ = type_19(0u, type_19().member_1);
        }
        let _e167 = phi_282_;
        let _e169 = phi_305_;
        let _e173 = (bitcast<i32>(_e169.member) != 0i);
        if _e173 {
            let _e177 = (((_e124 + (_e169.member_1 * _e127)) * 64u) + _e112);
            let _e179 = params.member.member_8;
            if (_e177 < _e134) {
                let _e182 = (2u * _e177);
                let _e185 = input.member[(4u + _e182)];
                let _e188 = input.member[(_e182 + 5u)];
                let _e190 = elements.member[_e188];
                local_15 = array<u32, 4>(_e185, _e190[0], _e190[1], _e190[2]);
                local_16[0u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[1u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[2u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[3u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[0u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[1u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[2u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[3u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                let _e204 = params.member.member_1;
                if ((_e204 & 8u) != 0u) {
                    let _e249 = paths.member[_e185];
                    let _e251 = paths.member[_e190[0]];
                    let _e257 = paths.member[_e190[1]];
                    let _e259 = paths.member[_e190[2]];
                    local_18 = array<array<f32, 3>, 4>(array<f32, 3>(_e249.member[0], _e249.member[1], _e249.member[2]), array<f32, 3>(_e251.member[0], _e251.member[1], _e251.member[2]), array<f32, 3>(_e257.member[0], _e257.member[1], _e257.member[2]), array<f32, 3>(_e259.member[0], _e259.member[1], _e259.member[2]));
                    local_19 = array<array<f32, 3>, 4>(array<f32, 3>(_e249.member_1[0], _e249.member_1[1], _e249.member_1[2]), array<f32, 3>(_e251.member_1[0], _e251.member_1[1], _e251.member_1[2]), array<f32, 3>(_e257.member_1[0], _e257.member_1[1], _e257.member_1[2]), array<f32, 3>(_e259.member_1[0], _e259.member_1[1], _e259.member_1[2]));
                    phi_517_ = type_19(0u, 4u);
                    loop {
                        let _e299 = phi_517_;
                        if (_e299.member < _e299.member_1) {
                            phi_518_ = type_19((_e299.member + 1u), _e299.member_1);
                            phi_541_ = type_19(1u, _e299.member);
                        } else {
                            phi_518_ = _e299;
                            phi_541_ = type_19(0u, type_19().member_1);
                        }
                        let _e311 = phi_518_;
                        let _e313 = phi_541_;
                        let _e317 = (bitcast<i32>(_e313.member) != 0i);
                        if _e317 {
                            phi_551_ = type_19(0u, 3u);
                            loop {
                                let _e319 = phi_551_;
                                if (_e319.member < _e319.member_1) {
                                    phi_552_ = type_19((_e319.member + 1u), _e319.member_1);
                                    phi_575_ = type_19(1u, _e319.member);
                                } else {
                                    phi_552_ = _e319;
                                    phi_575_ = type_19(0u, type_19().member_1);
                                }
                                let _e331 = phi_552_;
                                let _e333 = phi_575_;
                                let _e337 = (bitcast<i32>(_e333.member) != 0i);
                                if _e337 {
                                    let _e340 = local_18[_e313.member_1][_e333.member_1];
                                    local_16[_e313.member_1][_e333.member_1] = f64(_e340);
                                    let _e346 = local_19[_e313.member_1][_e333.member_1];
                                    local_17[_e313.member_1][_e333.member_1] = f64(_e346);
                                }
                                continue;
                                continuing {
                                    phi_551_ = _e331;
                                    break if !(_e337);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_517_ = _e311;
                            break if !(_e317);
                        }
                    }
                } else {
                    phi_637_ = type_19(0u, 4u);
                    loop {
                        let _e208 = phi_637_;
                        if (_e208.member < _e208.member_1) {
                            phi_638_ = type_19((_e208.member + 1u), _e208.member_1);
                            phi_661_ = type_19(1u, _e208.member);
                        } else {
                            phi_638_ = _e208;
                            phi_661_ = type_19(0u, type_19().member_1);
                        }
                        let _e220 = phi_638_;
                        let _e222 = phi_661_;
                        let _e226 = (bitcast<i32>(_e222.member) != 0i);
                        if _e226 {
                            let _e228 = local_15[_e222.member_1];
                            let _e230 = wide.member[_e228];
                            let _e233 = params.member.member[0u];
                            let _e236 = wide.member[(_e233 + _e228)];
                            local_16[_e222.member_1] = array<f64, 3>(_e230[0], _e230[1], _e230[2]);
                            local_17[_e222.member_1] = array<f64, 3>(_e236[0], _e236[1], _e236[2]);
                        }
                        continue;
                        continuing {
                            phi_637_ = _e220;
                            break if !(_e226);
                        }
                    }
                }
                let _e352 = local_16;
                let _e369 = local_17;
                local_20 = type_39(array<array<f64, 3>, 2>(array<f64, 3>((_e352[0][0] - _e352[1][0]), (_e352[0][1] - _e352[1][1]), (_e352[0][2] - _e352[1][2])), array<f64, 3>((_e369[0][0] - _e369[1][0]), (_e369[0][1] - _e369[1][1]), (_e369[0][2] - _e369[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e352[2][0] - _e352[1][0]), (_e352[2][1] - _e352[1][1]), (_e352[2][2] - _e352[1][2])), array<f64, 3>((_e369[2][0] - _e369[1][0]), (_e369[2][1] - _e369[1][1]), (_e369[2][2] - _e369[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e352[3][0] - _e352[1][0]), (_e352[3][1] - _e352[1][1]), (_e352[3][2] - _e352[1][2])), array<f64, 3>((_e369[3][0] - _e369[1][0]), (_e369[3][1] - _e369[1][1]), (_e369[3][2] - _e369[1][2]))), (0.0lf + 0.0lf));
                let _e416 = params.member.member_7;
                let _e423 = bitcast<f64>(((u64(_e416[1]) * 4294967296lu) + u64(_e416[0])));
                let _e424 = f64(0f);
                let _e427 = local_20.member_1[0u];
                let _e433 = local_20.member_2[0u];
                let _e439 = ((_e427[1] * _e433[2]) - (_e427[2] * _e433[1]));
                let _e442 = ((_e427[2] * _e433[0]) - (_e427[0] * _e433[2]));
                let _e445 = ((_e427[0] * _e433[1]) - (_e427[1] * _e433[0]));
                let _e448 = local_20.member_1[1u];
                let _e454 = local_20.member_2[1u];
                let _e460 = ((_e448[1] * _e454[2]) - (_e448[2] * _e454[1]));
                let _e463 = ((_e448[2] * _e454[0]) - (_e448[0] * _e454[2]));
                let _e466 = ((_e448[0] * _e454[1]) - (_e448[1] * _e454[0]));
                let _e469 = local_20.member_1[0u];
                let _e475 = local_20.member_2[1u];
                let _e490 = local_20.member_1[1u];
                let _e496 = local_20.member_2[0u];
                let _e509 = (((_e469[1] * _e475[2]) - (_e469[2] * _e475[1])) + ((_e490[1] * _e496[2]) - (_e490[2] * _e496[1])));
                let _e510 = (((_e469[2] * _e475[0]) - (_e469[0] * _e475[2])) + ((_e490[2] * _e496[0]) - (_e490[0] * _e496[2])));
                let _e511 = (((_e469[0] * _e475[1]) - (_e469[1] * _e475[0])) + ((_e490[0] * _e496[1]) - (_e490[1] * _e496[0])));
                let _e514 = local_20.member[0u];
                let _e522 = (((_e514[0] * _e439) + (_e514[1] * _e442)) + (_e514[2] * _e445));
                let _e525 = local_20.member[1u];
                let _e536 = local_20.member[0u];
                let _e545 = ((((_e525[0] * _e439) + (_e525[1] * _e442)) + (_e525[2] * _e445)) + (((_e536[0] * _e509) + (_e536[1] * _e510)) + (_e536[2] * _e511)));
                let _e548 = local_20.member[0u];
                let _e559 = local_20.member[1u];
                let _e568 = ((((_e548[0] * _e460) + (_e548[1] * _e463)) + (_e548[2] * _e466)) + (((_e559[0] * _e509) + (_e559[1] * _e510)) + (_e559[2] * _e511)));
                let _e571 = local_20.member[1u];
                let _e579 = (((_e571[0] * _e460) + (_e571[1] * _e463)) + (_e571[2] * _e466));
                let _e582 = local_20.member[0u];
                if (_e582[0] < 0.0lf) {
                    phi_1129_ = -(_e582[0]);
                } else {
                    phi_1129_ = _e582[0];
                }
                let _e589 = phi_1129_;
                if (_e582[1] < 0.0lf) {
                    phi_1136_ = -(_e582[1]);
                } else {
                    phi_1136_ = _e582[1];
                }
                let _e593 = phi_1136_;
                if (_e589 > _e593) {
                    phi_1141_ = _e589;
                } else {
                    phi_1141_ = _e593;
                }
                let _e596 = phi_1141_;
                if (_e582[2] < 0.0lf) {
                    phi_1148_ = -(_e582[2]);
                } else {
                    phi_1148_ = _e582[2];
                }
                let _e600 = phi_1148_;
                if (_e596 > _e600) {
                    phi_1153_ = _e596;
                } else {
                    phi_1153_ = _e600;
                }
                let _e603 = phi_1153_;
                let _e606 = local_20.member[1u];
                if (_e606[0] < 0.0lf) {
                    phi_1166_ = -(_e606[0]);
                } else {
                    phi_1166_ = _e606[0];
                }
                let _e613 = phi_1166_;
                if (_e606[1] < 0.0lf) {
                    phi_1173_ = -(_e606[1]);
                } else {
                    phi_1173_ = _e606[1];
                }
                let _e617 = phi_1173_;
                if (_e613 > _e617) {
                    phi_1178_ = _e613;
                } else {
                    phi_1178_ = _e617;
                }
                let _e620 = phi_1178_;
                if (_e606[2] < 0.0lf) {
                    phi_1185_ = -(_e606[2]);
                } else {
                    phi_1185_ = _e606[2];
                }
                let _e624 = phi_1185_;
                if (_e620 > _e624) {
                    phi_1190_ = _e620;
                } else {
                    phi_1190_ = _e624;
                }
                let _e627 = phi_1190_;
                if (_e603 > _e627) {
                    phi_1195_ = _e603;
                } else {
                    phi_1195_ = _e627;
                }
                let _e630 = phi_1195_;
                let _e632 = local_20.member_3;
                let _e633 = (_e630 + _e632);
                let _e636 = local_20.member_1[0u];
                if (_e636[0] < 0.0lf) {
                    phi_1212_ = -(_e636[0]);
                } else {
                    phi_1212_ = _e636[0];
                }
                let _e643 = phi_1212_;
                if (_e636[1] < 0.0lf) {
                    phi_1219_ = -(_e636[1]);
                } else {
                    phi_1219_ = _e636[1];
                }
                let _e647 = phi_1219_;
                if (_e643 > _e647) {
                    phi_1224_ = _e643;
                } else {
                    phi_1224_ = _e647;
                }
                let _e650 = phi_1224_;
                if (_e636[2] < 0.0lf) {
                    phi_1231_ = -(_e636[2]);
                } else {
                    phi_1231_ = _e636[2];
                }
                let _e654 = phi_1231_;
                if (_e650 > _e654) {
                    phi_1236_ = _e650;
                } else {
                    phi_1236_ = _e654;
                }
                let _e657 = phi_1236_;
                let _e660 = local_20.member_1[1u];
                if (_e660[0] < 0.0lf) {
                    phi_1250_ = -(_e660[0]);
                } else {
                    phi_1250_ = _e660[0];
                }
                let _e667 = phi_1250_;
                if (_e660[1] < 0.0lf) {
                    phi_1257_ = -(_e660[1]);
                } else {
                    phi_1257_ = _e660[1];
                }
                let _e671 = phi_1257_;
                if (_e667 > _e671) {
                    phi_1262_ = _e667;
                } else {
                    phi_1262_ = _e671;
                }
                let _e674 = phi_1262_;
                if (_e660[2] < 0.0lf) {
                    phi_1269_ = -(_e660[2]);
                } else {
                    phi_1269_ = _e660[2];
                }
                let _e678 = phi_1269_;
                if (_e674 > _e678) {
                    phi_1274_ = _e674;
                } else {
                    phi_1274_ = _e678;
                }
                let _e681 = phi_1274_;
                if (_e657 > _e681) {
                    phi_1279_ = _e657;
                } else {
                    phi_1279_ = _e681;
                }
                let _e684 = phi_1279_;
                let _e686 = local_20.member_3;
                let _e687 = (_e684 + _e686);
                let _e690 = local_20.member_2[0u];
                if (_e690[0] < 0.0lf) {
                    phi_1296_ = -(_e690[0]);
                } else {
                    phi_1296_ = _e690[0];
                }
                let _e697 = phi_1296_;
                if (_e690[1] < 0.0lf) {
                    phi_1303_ = -(_e690[1]);
                } else {
                    phi_1303_ = _e690[1];
                }
                let _e701 = phi_1303_;
                if (_e697 > _e701) {
                    phi_1308_ = _e697;
                } else {
                    phi_1308_ = _e701;
                }
                let _e704 = phi_1308_;
                if (_e690[2] < 0.0lf) {
                    phi_1315_ = -(_e690[2]);
                } else {
                    phi_1315_ = _e690[2];
                }
                let _e708 = phi_1315_;
                if (_e704 > _e708) {
                    phi_1320_ = _e704;
                } else {
                    phi_1320_ = _e708;
                }
                let _e711 = phi_1320_;
                let _e714 = local_20.member_2[1u];
                if (_e714[0] < 0.0lf) {
                    phi_1334_ = -(_e714[0]);
                } else {
                    phi_1334_ = _e714[0];
                }
                let _e721 = phi_1334_;
                if (_e714[1] < 0.0lf) {
                    phi_1341_ = -(_e714[1]);
                } else {
                    phi_1341_ = _e714[1];
                }
                let _e725 = phi_1341_;
                if (_e721 > _e725) {
                    phi_1346_ = _e721;
                } else {
                    phi_1346_ = _e725;
                }
                let _e728 = phi_1346_;
                if (_e714[2] < 0.0lf) {
                    phi_1353_ = -(_e714[2]);
                } else {
                    phi_1353_ = _e714[2];
                }
                let _e732 = phi_1353_;
                if (_e728 > _e732) {
                    phi_1358_ = _e728;
                } else {
                    phi_1358_ = _e732;
                }
                let _e735 = phi_1358_;
                if (_e711 > _e735) {
                    phi_1363_ = _e711;
                } else {
                    phi_1363_ = _e735;
                }
                let _e738 = phi_1363_;
                let _e740 = local_20.member_3;
                let _e741 = (_e738 + _e740);
                let _e742 = f64(1f);
                let _e743 = f64(8f);
                let _e745 = ((_e687 * _e743) * _e741);
                let _e753 = local_20.member_3;
                if (_e439 < 0.0lf) {
                    phi_1400_ = -(_e439);
                } else {
                    phi_1400_ = _e439;
                }
                let _e773 = phi_1400_;
                if (_e442 < 0.0lf) {
                    phi_1406_ = -(_e442);
                } else {
                    phi_1406_ = _e442;
                }
                let _e777 = phi_1406_;
                if (_e445 < 0.0lf) {
                    phi_1413_ = -(_e445);
                } else {
                    phi_1413_ = _e445;
                }
                let _e782 = phi_1413_;
                let _e783 = ((_e773 + _e777) + _e782);
                if (_e460 < 0.0lf) {
                    phi_1420_ = -(_e460);
                } else {
                    phi_1420_ = _e460;
                }
                let _e787 = phi_1420_;
                if (_e463 < 0.0lf) {
                    phi_1426_ = -(_e463);
                } else {
                    phi_1426_ = _e463;
                }
                let _e791 = phi_1426_;
                if (_e466 < 0.0lf) {
                    phi_1433_ = -(_e466);
                } else {
                    phi_1433_ = _e466;
                }
                let _e796 = phi_1433_;
                let _e797 = ((_e787 + _e791) + _e796);
                if (_e783 > _e797) {
                    phi_1439_ = _e783;
                } else {
                    phi_1439_ = _e797;
                }
                let _e800 = phi_1439_;
                if (_e509 < 0.0lf) {
                    phi_1445_ = -(_e509);
                } else {
                    phi_1445_ = _e509;
                }
                let _e804 = phi_1445_;
                if (_e510 < 0.0lf) {
                    phi_1451_ = -(_e510);
                } else {
                    phi_1451_ = _e510;
                }
                let _e808 = phi_1451_;
                if (_e511 < 0.0lf) {
                    phi_1458_ = -(_e511);
                } else {
                    phi_1458_ = _e511;
                }
                let _e813 = phi_1458_;
                let _e815 = (((_e804 + _e808) + _e813) * f64(0.5f));
                if (_e800 > _e815) {
                    phi_1465_ = _e800;
                } else {
                    phi_1465_ = _e815;
                }
                let _e818 = phi_1465_;
                let _e824 = local_20.member_3;
                let _e838 = (((((_e633 * _e743) * _e745) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e753 * f64(19f)) * ((_e633 * (_e687 + _e741)) + (_e687 * _e741)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e742 + _e633) * ((_e742 + _e687) * (_e742 + _e741)))));
                let _e839 = f64(3f);
                let _e840 = (_e522 * _e839);
                let _e841 = (_e579 * _e839);
                if (_e840 < _e841) {
                    phi_1493_ = _e840;
                } else {
                    phi_1493_ = _e841;
                }
                let _e844 = phi_1493_;
                if (_e545 < _e568) {
                    phi_1498_ = _e545;
                } else {
                    phi_1498_ = _e568;
                }
                let _e847 = phi_1498_;
                if (_e844 < _e847) {
                    phi_1503_ = _e844;
                } else {
                    phi_1503_ = _e847;
                }
                let _e850 = phi_1503_;
                if (_e840 > _e841) {
                    phi_1508_ = _e840;
                } else {
                    phi_1508_ = _e841;
                }
                let _e853 = phi_1508_;
                if (_e545 > _e568) {
                    phi_1513_ = _e545;
                } else {
                    phi_1513_ = _e568;
                }
                let _e856 = phi_1513_;
                if (_e853 > _e856) {
                    phi_1518_ = _e853;
                } else {
                    phi_1518_ = _e856;
                }
                let _e859 = phi_1518_;
                let _e865 = -(_e859);
                if (_e850 > _e865) {
                    phi_1529_ = _e850;
                } else {
                    phi_1529_ = _e865;
                }
                let _e868 = phi_1529_;
                if ((_e868 - (_e838 + ((_e423 * (((_e818 + (_e745 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e824 * f64(6f)) * (_e687 + _e741))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e742 + _e687) * (_e742 + _e741))))) * f64((3f * 1.0001f))))) > _e424) {
                    phi_7447_ = type_40(0u, type_40().member_1);
                } else {
                    if (_e423 > _e424) {
                        let _e3190 = f64(1f);
                        let _e3194 = local_20.member[0u];
                        let _e3200 = local_20.member_1[0u];
                        let _e3206 = local_20.member_2[0u];
                        local_12 = array<array<f64, 3>, 4>(_e3194, array<f64, 3>((_e3194[0] - _e3200[0]), (_e3194[1] - _e3200[1]), (_e3194[2] - _e3200[2])), array<f64, 3>((_e3194[0] - _e3206[0]), (_e3194[1] - _e3206[1]), (_e3194[2] - _e3206[2])), _e3194);
                        let _e3221 = local_20.member[1u];
                        let _e3227 = local_20.member_1[1u];
                        let _e3233 = local_20.member_2[1u];
                        local_13 = array<array<f64, 3>, 4>(_e3221, array<f64, 3>((_e3221[0] - _e3227[0]), (_e3221[1] - _e3227[1]), (_e3221[2] - _e3227[2])), array<f64, 3>((_e3221[0] - _e3233[0]), (_e3221[1] - _e3233[1]), (_e3221[2] - _e3233[2])), _e3221);
                        let _e3248 = local_20.member[0u];
                        if (_e3248[0] < 0.0lf) {
                            phi_1732_ = -(_e3248[0]);
                        } else {
                            phi_1732_ = _e3248[0];
                        }
                        let _e3255 = phi_1732_;
                        if (_e3248[1] < 0.0lf) {
                            phi_1739_ = -(_e3248[1]);
                        } else {
                            phi_1739_ = _e3248[1];
                        }
                        let _e3259 = phi_1739_;
                        if (_e3255 > _e3259) {
                            phi_1744_ = _e3255;
                        } else {
                            phi_1744_ = _e3259;
                        }
                        let _e3262 = phi_1744_;
                        if (_e3248[2] < 0.0lf) {
                            phi_1751_ = -(_e3248[2]);
                        } else {
                            phi_1751_ = _e3248[2];
                        }
                        let _e3266 = phi_1751_;
                        if (_e3262 > _e3266) {
                            phi_1756_ = _e3262;
                        } else {
                            phi_1756_ = _e3266;
                        }
                        let _e3269 = phi_1756_;
                        let _e3272 = local_20.member[1u];
                        if (_e3272[0] < 0.0lf) {
                            phi_1769_ = -(_e3272[0]);
                        } else {
                            phi_1769_ = _e3272[0];
                        }
                        let _e3279 = phi_1769_;
                        if (_e3272[1] < 0.0lf) {
                            phi_1776_ = -(_e3272[1]);
                        } else {
                            phi_1776_ = _e3272[1];
                        }
                        let _e3283 = phi_1776_;
                        if (_e3279 > _e3283) {
                            phi_1781_ = _e3279;
                        } else {
                            phi_1781_ = _e3283;
                        }
                        let _e3286 = phi_1781_;
                        if (_e3272[2] < 0.0lf) {
                            phi_1788_ = -(_e3272[2]);
                        } else {
                            phi_1788_ = _e3272[2];
                        }
                        let _e3290 = phi_1788_;
                        if (_e3286 > _e3290) {
                            phi_1793_ = _e3286;
                        } else {
                            phi_1793_ = _e3290;
                        }
                        let _e3293 = phi_1793_;
                        if (_e3269 > _e3293) {
                            phi_1798_ = _e3269;
                        } else {
                            phi_1798_ = _e3293;
                        }
                        let _e3296 = phi_1798_;
                        let _e3298 = local_20.member_3;
                        let _e3302 = local_20.member_1[0u];
                        if (_e3302[0] < 0.0lf) {
                            phi_1815_ = -(_e3302[0]);
                        } else {
                            phi_1815_ = _e3302[0];
                        }
                        let _e3309 = phi_1815_;
                        if (_e3302[1] < 0.0lf) {
                            phi_1822_ = -(_e3302[1]);
                        } else {
                            phi_1822_ = _e3302[1];
                        }
                        let _e3313 = phi_1822_;
                        if (_e3309 > _e3313) {
                            phi_1827_ = _e3309;
                        } else {
                            phi_1827_ = _e3313;
                        }
                        let _e3316 = phi_1827_;
                        if (_e3302[2] < 0.0lf) {
                            phi_1834_ = -(_e3302[2]);
                        } else {
                            phi_1834_ = _e3302[2];
                        }
                        let _e3320 = phi_1834_;
                        if (_e3316 > _e3320) {
                            phi_1839_ = _e3316;
                        } else {
                            phi_1839_ = _e3320;
                        }
                        let _e3323 = phi_1839_;
                        let _e3326 = local_20.member_1[1u];
                        if (_e3326[0] < 0.0lf) {
                            phi_1853_ = -(_e3326[0]);
                        } else {
                            phi_1853_ = _e3326[0];
                        }
                        let _e3333 = phi_1853_;
                        if (_e3326[1] < 0.0lf) {
                            phi_1860_ = -(_e3326[1]);
                        } else {
                            phi_1860_ = _e3326[1];
                        }
                        let _e3337 = phi_1860_;
                        if (_e3333 > _e3337) {
                            phi_1865_ = _e3333;
                        } else {
                            phi_1865_ = _e3337;
                        }
                        let _e3340 = phi_1865_;
                        if (_e3326[2] < 0.0lf) {
                            phi_1872_ = -(_e3326[2]);
                        } else {
                            phi_1872_ = _e3326[2];
                        }
                        let _e3344 = phi_1872_;
                        if (_e3340 > _e3344) {
                            phi_1877_ = _e3340;
                        } else {
                            phi_1877_ = _e3344;
                        }
                        let _e3347 = phi_1877_;
                        if (_e3323 > _e3347) {
                            phi_1882_ = _e3323;
                        } else {
                            phi_1882_ = _e3347;
                        }
                        let _e3350 = phi_1882_;
                        let _e3352 = local_20.member_3;
                        let _e3356 = local_20.member_2[0u];
                        if (_e3356[0] < 0.0lf) {
                            phi_1899_ = -(_e3356[0]);
                        } else {
                            phi_1899_ = _e3356[0];
                        }
                        let _e3363 = phi_1899_;
                        if (_e3356[1] < 0.0lf) {
                            phi_1906_ = -(_e3356[1]);
                        } else {
                            phi_1906_ = _e3356[1];
                        }
                        let _e3367 = phi_1906_;
                        if (_e3363 > _e3367) {
                            phi_1911_ = _e3363;
                        } else {
                            phi_1911_ = _e3367;
                        }
                        let _e3370 = phi_1911_;
                        if (_e3356[2] < 0.0lf) {
                            phi_1918_ = -(_e3356[2]);
                        } else {
                            phi_1918_ = _e3356[2];
                        }
                        let _e3374 = phi_1918_;
                        if (_e3370 > _e3374) {
                            phi_1923_ = _e3370;
                        } else {
                            phi_1923_ = _e3374;
                        }
                        let _e3377 = phi_1923_;
                        let _e3380 = local_20.member_2[1u];
                        if (_e3380[0] < 0.0lf) {
                            phi_1937_ = -(_e3380[0]);
                        } else {
                            phi_1937_ = _e3380[0];
                        }
                        let _e3387 = phi_1937_;
                        if (_e3380[1] < 0.0lf) {
                            phi_1944_ = -(_e3380[1]);
                        } else {
                            phi_1944_ = _e3380[1];
                        }
                        let _e3391 = phi_1944_;
                        if (_e3387 > _e3391) {
                            phi_1949_ = _e3387;
                        } else {
                            phi_1949_ = _e3391;
                        }
                        let _e3394 = phi_1949_;
                        if (_e3380[2] < 0.0lf) {
                            phi_1956_ = -(_e3380[2]);
                        } else {
                            phi_1956_ = _e3380[2];
                        }
                        let _e3398 = phi_1956_;
                        if (_e3394 > _e3398) {
                            phi_1961_ = _e3394;
                        } else {
                            phi_1961_ = _e3398;
                        }
                        let _e3401 = phi_1961_;
                        if (_e3377 > _e3401) {
                            phi_1966_ = _e3377;
                        } else {
                            phi_1966_ = _e3401;
                        }
                        let _e3404 = phi_1966_;
                        let _e3406 = local_20.member_3;
                        let _e3414 = local_20.member_3;
                        phi_1986_ = type_19(0u, 48u);
                        phi_1989_ = f64(0f);
                        loop {
                            let _e3423 = phi_1986_;
                            let _e3425 = phi_1989_;
                            local_87 = _e3425;
                            local_45 = _e3425;
                            local_46 = _e3425;
                            local_47 = _e3425;
                            local_48 = _e3425;
                            if (_e3423.member < _e3423.member_1) {
                                phi_1987_ = type_19((_e3423.member + 1u), _e3423.member_1);
                                phi_2012_ = type_19(1u, _e3423.member);
                            } else {
                                phi_1987_ = _e3423;
                                phi_2012_ = type_19(0u, type_19().member_1);
                            }
                            let _e3437 = phi_1987_;
                            let _e3439 = phi_2012_;
                            if (bitcast<i32>(_e3439.member) != 0i) {
                                let _e3445 = local_20.member[0u];
                                let _e3451 = local_20.member[1u];
                                let _e3461 = (_e3445[0] + ((_e3451[0] - _e3445[0]) * _e3425));
                                let _e3462 = (_e3445[1] + ((_e3451[1] - _e3445[1]) * _e3425));
                                let _e3463 = (_e3445[2] + ((_e3451[2] - _e3445[2]) * _e3425));
                                let _e3466 = local_20.member_1[0u];
                                let _e3472 = local_20.member_1[1u];
                                let _e3482 = (_e3466[0] + ((_e3472[0] - _e3466[0]) * _e3425));
                                let _e3483 = (_e3466[1] + ((_e3472[1] - _e3466[1]) * _e3425));
                                let _e3484 = (_e3466[2] + ((_e3472[2] - _e3466[2]) * _e3425));
                                let _e3487 = local_20.member_2[0u];
                                let _e3493 = local_20.member_2[1u];
                                let _e3503 = (_e3487[0] + ((_e3493[0] - _e3487[0]) * _e3425));
                                let _e3504 = (_e3487[1] + ((_e3493[1] - _e3487[1]) * _e3425));
                                let _e3505 = (_e3487[2] + ((_e3493[2] - _e3487[2]) * _e3425));
                                let _e3510 = (((_e3482 * _e3482) + (_e3483 * _e3483)) + (_e3484 * _e3484));
                                let _e3515 = (((_e3482 * _e3503) + (_e3483 * _e3504)) + (_e3484 * _e3505));
                                let _e3520 = (((_e3503 * _e3503) + (_e3504 * _e3504)) + (_e3505 * _e3505));
                                let _e3525 = (((_e3461 * _e3482) + (_e3462 * _e3483)) + (_e3463 * _e3484));
                                let _e3530 = (((_e3461 * _e3503) + (_e3462 * _e3504)) + (_e3463 * _e3505));
                                let _e3533 = ((_e3510 * _e3520) - (_e3515 * _e3515));
                                let _e3534 = f64(0f);
                                let _e3539 = (((_e3525 * _e3520) - (_e3530 * _e3515)) / _e3533);
                                let _e3543 = (((_e3530 * _e3510) - (_e3525 * _e3515)) / _e3533);
                                if (_e3539 >= _e3534) {
                                    if (_e3543 >= _e3534) {
                                        phi_2188_ = ((_e3539 + _e3543) <= f64(1f));
                                        phi_2189_ = false;
                                    } else {
                                        phi_2188_ = bool();
                                        phi_2189_ = true;
                                    }
                                    let _e3549 = phi_2188_;
                                    let _e3551 = phi_2189_;
                                    phi_2190_ = _e3549;
                                    phi_2191_ = _e3551;
                                } else {
                                    phi_2190_ = bool();
                                    phi_2191_ = true;
                                }
                                let _e3553 = phi_2190_;
                                let _e3555 = phi_2191_;
                                if _e3555 {
                                    phi_2195_ = false;
                                } else {
                                    phi_2195_ = _e3553;
                                }
                                let _e3557 = phi_2195_;
                                if (_e3533 > _e3534) {
                                    if _e3557 {
                                        phi_2217_ = array<f64, 3>((_e3461 - ((_e3482 * _e3539) + (_e3503 * _e3543))), (_e3462 - ((_e3483 * _e3539) + (_e3504 * _e3543))), (_e3463 - ((_e3484 * _e3539) + (_e3505 * _e3543))));
                                        phi_2218_ = false;
                                    } else {
                                        phi_2217_ = array<f64, 3>();
                                        phi_2218_ = true;
                                    }
                                    let _e3573 = phi_2217_;
                                    let _e3575 = phi_2218_;
                                    phi_2219_ = _e3573;
                                    phi_2220_ = _e3575;
                                } else {
                                    phi_2219_ = array<f64, 3>();
                                    phi_2220_ = true;
                                }
                                let _e3577 = phi_2219_;
                                let _e3579 = phi_2220_;
                                if _e3579 {
                                    let _e3580 = (_e3461 - _e3482);
                                    let _e3581 = (_e3462 - _e3483);
                                    let _e3582 = (_e3463 - _e3484);
                                    let _e3583 = (_e3503 - _e3482);
                                    let _e3584 = (_e3504 - _e3483);
                                    let _e3585 = (_e3505 - _e3484);
                                    let _e3596 = ((((_e3580 * _e3583) + (_e3581 * _e3584)) + (_e3582 * _e3585)) / (((_e3583 * _e3583) + (_e3584 * _e3584)) + (_e3585 * _e3585)));
                                    if (_e3596 > f64(0f)) {
                                        if (_e3596 < f64(1f)) {
                                            phi_2407_ = _e3596;
                                        } else {
                                            phi_2407_ = f64(1f);
                                        }
                                        let _e3604 = phi_2407_;
                                        phi_2409_ = _e3604;
                                    } else {
                                        phi_2409_ = f64(0f);
                                    }
                                    let _e3606 = phi_2409_;
                                    let _e3610 = (_e3580 - (_e3583 * _e3606));
                                    let _e3611 = (_e3581 - (_e3584 * _e3606));
                                    let _e3612 = (_e3582 - (_e3585 * _e3606));
                                    let _e3623 = ((((_e3461 * _e3482) + (_e3462 * _e3483)) + (_e3463 * _e3484)) / (((_e3482 * _e3482) + (_e3483 * _e3483)) + (_e3484 * _e3484)));
                                    if (_e3623 > f64(0f)) {
                                        if (_e3623 < f64(1f)) {
                                            phi_2439_ = _e3623;
                                        } else {
                                            phi_2439_ = f64(1f);
                                        }
                                        let _e3631 = phi_2439_;
                                        phi_2441_ = _e3631;
                                    } else {
                                        phi_2441_ = f64(0f);
                                    }
                                    let _e3633 = phi_2441_;
                                    let _e3650 = ((((_e3461 * _e3503) + (_e3462 * _e3504)) + (_e3463 * _e3505)) / (((_e3503 * _e3503) + (_e3504 * _e3504)) + (_e3505 * _e3505)));
                                    if (_e3650 > f64(0f)) {
                                        if (_e3650 < f64(1f)) {
                                            phi_2471_ = _e3650;
                                        } else {
                                            phi_2471_ = f64(1f);
                                        }
                                        let _e3658 = phi_2471_;
                                        phi_2473_ = _e3658;
                                    } else {
                                        phi_2473_ = f64(0f);
                                    }
                                    let _e3660 = phi_2473_;
                                    local_11[0u] = array<f64, 3>((_e3461 - (_e3482 * _e3633)), (_e3462 - (_e3483 * _e3633)), (_e3463 - (_e3484 * _e3633)));
                                    local_11[1u] = array<f64, 3>((_e3461 - (_e3503 * _e3660)), (_e3462 - (_e3504 * _e3660)), (_e3463 - (_e3505 * _e3660)));
                                    local_11[2u] = array<f64, 3>(_e3610, _e3611, _e3612);
                                    local_11[3u] = array<f64, 3>(_e3610, _e3611, _e3612);
                                    let _e3676 = local_11[0u];
                                    phi_2509_ = type_19(1u, 4u);
                                    phi_2512_ = array<f64, 3>(_e3676[0], _e3676[1], _e3676[2]);
                                    loop {
                                        let _e3682 = phi_2509_;
                                        let _e3684 = phi_2512_;
                                        local_74 = _e3684;
                                        if (_e3682.member < _e3682.member_1) {
                                            phi_2510_ = type_19((_e3682.member + 1u), _e3682.member_1);
                                            phi_2535_ = type_19(1u, _e3682.member);
                                        } else {
                                            phi_2510_ = _e3682;
                                            phi_2535_ = type_19(0u, type_19().member_1);
                                        }
                                        let _e3696 = phi_2510_;
                                        let _e3698 = phi_2535_;
                                        let _e3702 = (bitcast<i32>(_e3698.member) != 0i);
                                        if _e3702 {
                                            let _e3704 = local_11[_e3698.member_1];
                                            let _e3709 = local_11[_e3698.member_1];
                                            if ((((_e3704[0] * _e3709[0]) + (_e3704[1] * _e3709[1])) + (_e3704[2] * _e3709[2])) < (((_e3684[0] * _e3684[0]) + (_e3684[1] * _e3684[1])) + (_e3684[2] * _e3684[2]))) {
                                                let _e3731 = local_11[_e3698.member_1];
                                                phi_2602_ = array<f64, 3>(_e3731[0], _e3731[1], _e3731[2]);
                                            } else {
                                                phi_2602_ = _e3684;
                                            }
                                            let _e3737 = phi_2602_;
                                            phi_2513_ = _e3737;
                                        } else {
                                            phi_2513_ = array<f64, 3>();
                                        }
                                        let _e3739 = phi_2513_;
                                        continue;
                                        continuing {
                                            phi_2509_ = _e3696;
                                            phi_2512_ = _e3739;
                                            break if !(_e3702);
                                        }
                                    }
                                    let _e5487 = local_74;
                                    phi_2603_ = _e5487;
                                } else {
                                    phi_2603_ = _e3577;
                                }
                                let _e3742 = phi_2603_;
                                if (_e3742[0] < 0.0lf) {
                                    phi_2610_ = -(_e3742[0]);
                                } else {
                                    phi_2610_ = _e3742[0];
                                }
                                let _e3747 = phi_2610_;
                                if (_e3742[1] < 0.0lf) {
                                    phi_2617_ = -(_e3742[1]);
                                } else {
                                    phi_2617_ = _e3742[1];
                                }
                                let _e3752 = phi_2617_;
                                if (_e3742[2] < 0.0lf) {
                                    phi_2625_ = -(_e3742[2]);
                                } else {
                                    phi_2625_ = _e3742[2];
                                }
                                let _e3758 = phi_2625_;
                                let _e3759 = ((_e3747 + _e3752) + _e3758);
                                if (_e3759 > f64(0f)) {
                                    if ((bitcast<u64>(_e3759) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e3765 = (f64(1f) / _e3759);
                                        let _e3767 = (_e3742[0] * _e3765);
                                        let _e3769 = (_e3742[1] * _e3765);
                                        let _e3771 = (_e3742[2] * _e3765);
                                        let _e3776 = (((_e3767 * _e3767) + (_e3769 * _e3769)) + (_e3771 * _e3771));
                                        if (_e3776 <= 2.2250738585072014e-308lf) {
                                            if (_e3776 > 0.0lf) {
                                                phi_2663_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2663_ = 0.0lf;
                                            }
                                            let _e3828 = phi_2663_;
                                            phi_2727_ = _e3828;
                                        } else {
                                            phi_2670_ = type_17(0i, 5i);
                                            phi_2673_ = bitcast<f64>(((bitcast<u64>(_e3776) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e3783 = phi_2670_;
                                                let _e3785 = phi_2673_;
                                                local_39 = _e3785;
                                                if (_e3783.member < _e3783.member_1) {
                                                    let _e3792 = (_e3783.member + 1i);
                                                    if ((false == (_e3792 > _e3783.member)) != false) {
                                                        phi_2694_ = true;
                                                    } else {
                                                        phi_2694_ = false;
                                                    }
                                                    let _e3797 = phi_2694_;
                                                    if _e3797 {
                                                        phi_2700_ = type_18(0u, type_18().member_1);
                                                    } else {
                                                        phi_2700_ = type_18(1u, _e3792);
                                                    }
                                                    let _e3802 = phi_2700_;
                                                    phi_2671_ = type_17(_e3802.member_1, _e3783.member_1);
                                                    phi_2714_ = type_18(1u, _e3783.member);
                                                } else {
                                                    phi_2671_ = _e3783;
                                                    phi_2714_ = type_18(0u, type_18().member_1);
                                                }
                                                let _e3808 = phi_2671_;
                                                let _e3810 = phi_2714_;
                                                let _e3813 = (bitcast<i32>(_e3810.member) != 0i);
                                                if _e3813 {
                                                    phi_2674_ = (0.5lf * (_e3785 + (_e3776 / _e3785)));
                                                } else {
                                                    phi_2674_ = f64();
                                                }
                                                let _e3818 = phi_2674_;
                                                continue;
                                                continuing {
                                                    phi_2670_ = _e3808;
                                                    phi_2673_ = _e3818;
                                                    break if !(_e3813);
                                                }
                                            }
                                            let _e3823 = local_39;
                                            phi_2727_ = (_e3823 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e3830 = phi_2727_;
                                        phi_2740_ = type_19(0u, 4u);
                                        phi_2743_ = f64(2f);
                                        loop {
                                            let _e3842 = phi_2740_;
                                            let _e3844 = phi_2743_;
                                            local_41 = _e3844;
                                            local_42 = _e3844;
                                            local_43 = _e3844;
                                            local_77 = _e3844;
                                            local_78 = _e3844;
                                            if (_e3842.member < _e3842.member_1) {
                                                phi_2741_ = type_19((_e3842.member + 1u), _e3842.member_1);
                                                phi_2766_ = type_19(1u, _e3842.member);
                                            } else {
                                                phi_2741_ = _e3842;
                                                phi_2766_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e3856 = phi_2741_;
                                            let _e3858 = phi_2766_;
                                            if (bitcast<i32>(_e3858.member) != 0i) {
                                                let _e3864 = local_12[_e3858.member_1];
                                                let _e3872 = (((_e3767 * _e3864[0]) + (_e3769 * _e3864[1])) + (_e3771 * _e3864[2]));
                                                let _e3874 = local_13[_e3858.member_1];
                                                let _e3882 = (((_e3767 * _e3874[0]) + (_e3769 * _e3874[1])) + (_e3771 * _e3874[2]));
                                                if (_e3872 < 0.0lf) {
                                                    phi_2817_ = -(_e3872);
                                                } else {
                                                    phi_2817_ = _e3872;
                                                }
                                                let _e3886 = phi_2817_;
                                                if (_e3882 < 0.0lf) {
                                                    phi_2823_ = -(_e3882);
                                                } else {
                                                    phi_2823_ = _e3882;
                                                }
                                                let _e3890 = phi_2823_;
                                                let _e3895 = (((((((((_e3296 + _e3298) + (_e3350 + _e3352)) + (_e3404 + _e3406)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3414 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e423 * _e3830) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e3886 + _e3890) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e3872 > _e3895) {
                                                    if (_e3882 > _e3895) {
                                                        phi_2837_ = false;
                                                    } else {
                                                        phi_2837_ = true;
                                                    }
                                                    let _e3899 = phi_2837_;
                                                    phi_2838_ = _e3899;
                                                } else {
                                                    phi_2838_ = true;
                                                }
                                                let _e3901 = phi_2838_;
                                                if _e3901 {
                                                    if ((_e3872 + ((_e3882 - _e3872) * _e3425)) > _e3895) {
                                                        if (_e3882 < _e3872) {
                                                            let _e3910 = ((_e3872 - _e3882) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                            if _e3910 {
                                                                let _e3918 = (((_e3872 - _e3895) / (_e3872 - _e3882)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                if (_e3844 < _e3918) {
                                                                    phi_2872_ = _e3844;
                                                                } else {
                                                                    phi_2872_ = _e3918;
                                                                }
                                                                let _e3921 = phi_2872_;
                                                                phi_2873_ = _e3921;
                                                            } else {
                                                                phi_2873_ = f64();
                                                            }
                                                            let _e3923 = phi_2873_;
                                                            phi_2874_ = _e3923;
                                                            phi_2875_ = _e3910;
                                                        } else {
                                                            phi_2874_ = _e3844;
                                                            phi_2875_ = true;
                                                        }
                                                        let _e3925 = phi_2874_;
                                                        let _e3927 = phi_2875_;
                                                        if _e3927 {
                                                            phi_2879_ = false;
                                                        } else {
                                                            phi_2879_ = true;
                                                        }
                                                        let _e3929 = phi_2879_;
                                                        phi_2880_ = _e3925;
                                                        phi_2881_ = _e3927;
                                                        phi_2882_ = _e3929;
                                                        phi_2883_ = false;
                                                    } else {
                                                        phi_2880_ = f64();
                                                        phi_2881_ = false;
                                                        phi_2882_ = false;
                                                        phi_2883_ = true;
                                                    }
                                                    let _e3931 = phi_2880_;
                                                    let _e3933 = phi_2881_;
                                                    let _e3935 = phi_2882_;
                                                    let _e3937 = phi_2883_;
                                                    phi_2884_ = _e3931;
                                                    phi_2885_ = _e3933;
                                                    phi_2886_ = _e3935;
                                                    phi_2887_ = _e3937;
                                                } else {
                                                    phi_2884_ = _e3844;
                                                    phi_2885_ = true;
                                                    phi_2886_ = false;
                                                    phi_2887_ = false;
                                                }
                                                let _e3939 = phi_2884_;
                                                let _e3941 = phi_2885_;
                                                let _e3943 = phi_2886_;
                                                let _e3945 = phi_2887_;
                                                phi_2744_ = _e3939;
                                                phi_2888_ = _e3941;
                                                phi_2889_ = false;
                                                phi_2890_ = _e3943;
                                                phi_2891_ = _e3945;
                                            } else {
                                                phi_2744_ = f64();
                                                phi_2888_ = false;
                                                phi_2889_ = true;
                                                phi_2890_ = false;
                                                phi_2891_ = false;
                                            }
                                            let _e3947 = phi_2744_;
                                            let _e3949 = phi_2888_;
                                            let _e3951 = phi_2889_;
                                            let _e3953 = phi_2890_;
                                            let _e3955 = phi_2891_;
                                            local_40 = _e3951;
                                            local_75 = _e3953;
                                            local_76 = _e3955;
                                            continue;
                                            continuing {
                                                phi_2740_ = _e3856;
                                                phi_2743_ = _e3947;
                                                break if !(_e3949);
                                            }
                                        }
                                        let _e3958 = local_40;
                                        if _e3958 {
                                            let _e3960 = local_41;
                                            let _e3961 = (_e3960 > _e3190);
                                            if _e3961 {
                                                phi_2913_ = false;
                                                phi_2914_ = false;
                                                phi_2915_ = false;
                                            } else {
                                                let _e3963 = local_42;
                                                if (_e3963 > _e3425) {
                                                    let _e3966 = local_43;
                                                    let _e3969 = ((_e3966 - _e3425) < f64(0.00000000023283064f));
                                                    if _e3969 {
                                                        phi_2909_ = false;
                                                    } else {
                                                        phi_2909_ = true;
                                                    }
                                                    let _e3971 = phi_2909_;
                                                    phi_2910_ = _e3971;
                                                    phi_2911_ = _e3969;
                                                    phi_2912_ = false;
                                                } else {
                                                    phi_2910_ = false;
                                                    phi_2911_ = false;
                                                    phi_2912_ = true;
                                                }
                                                let _e3973 = phi_2910_;
                                                let _e3975 = phi_2911_;
                                                let _e3977 = phi_2912_;
                                                phi_2913_ = _e3973;
                                                phi_2914_ = _e3975;
                                                phi_2915_ = _e3977;
                                            }
                                            let _e3979 = phi_2913_;
                                            let _e3981 = phi_2914_;
                                            let _e3983 = phi_2915_;
                                            phi_2916_ = _e3979;
                                            phi_2917_ = _e3961;
                                            phi_2918_ = _e3981;
                                            phi_2919_ = _e3983;
                                            phi_2920_ = false;
                                            phi_2921_ = false;
                                        } else {
                                            phi_2916_ = false;
                                            phi_2917_ = false;
                                            phi_2918_ = false;
                                            phi_2919_ = false;
                                            let _e5544 = local_75;
                                            phi_2920_ = _e5544;
                                            let _e5547 = local_76;
                                            phi_2921_ = _e5547;
                                        }
                                        let _e3985 = phi_2916_;
                                        let _e3987 = phi_2917_;
                                        let _e3989 = phi_2918_;
                                        let _e3991 = phi_2919_;
                                        let _e3993 = phi_2920_;
                                        let _e3995 = phi_2921_;
                                        let _e5550 = local_77;
                                        phi_2922_ = _e5550;
                                        let _e5553 = local_78;
                                        phi_2923_ = _e5553;
                                        phi_2924_ = _e3985;
                                        phi_2925_ = _e3987;
                                        phi_2926_ = _e3989;
                                        phi_2927_ = _e3991;
                                        phi_2928_ = _e3993;
                                        phi_2929_ = _e3995;
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
                                    let _e3997 = phi_2922_;
                                    let _e3999 = phi_2923_;
                                    let _e4001 = phi_2924_;
                                    let _e4003 = phi_2925_;
                                    let _e4005 = phi_2926_;
                                    let _e4007 = phi_2927_;
                                    let _e4009 = phi_2928_;
                                    let _e4011 = phi_2929_;
                                    let _e4013 = phi_2930_;
                                    phi_2931_ = _e3997;
                                    phi_2932_ = _e3999;
                                    phi_2933_ = _e4001;
                                    phi_2934_ = _e4003;
                                    phi_2935_ = _e4005;
                                    phi_2936_ = _e4007;
                                    phi_2937_ = _e4009;
                                    phi_2938_ = _e4011;
                                    phi_2939_ = _e4013;
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
                                let _e4015 = phi_2931_;
                                let _e4017 = phi_2932_;
                                let _e4019 = phi_2933_;
                                let _e4021 = phi_2934_;
                                let _e4023 = phi_2935_;
                                let _e4025 = phi_2936_;
                                let _e4027 = phi_2937_;
                                let _e4029 = phi_2938_;
                                let _e4031 = phi_2939_;
                                let _e4033 = phi_2940_;
                                phi_2941_ = _e4015;
                                phi_1990_ = _e4017;
                                phi_2942_ = _e4019;
                                phi_2943_ = _e4021;
                                phi_2944_ = _e4023;
                                phi_2945_ = false;
                                phi_2946_ = _e4025;
                                phi_2947_ = _e4027;
                                phi_2948_ = _e4029;
                                phi_2949_ = _e4031;
                                phi_2950_ = _e4033;
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
                            let _e4035 = phi_2941_;
                            let _e4037 = phi_1990_;
                            let _e4039 = phi_2942_;
                            let _e4041 = phi_2943_;
                            let _e4043 = phi_2944_;
                            let _e4045 = phi_2945_;
                            let _e4047 = phi_2946_;
                            let _e4049 = phi_2947_;
                            let _e4051 = phi_2948_;
                            let _e4053 = phi_2949_;
                            let _e4055 = phi_2950_;
                            local_44 = _e4041;
                            local_79 = _e4043;
                            local_80 = _e4045;
                            local_81 = _e4047;
                            local_82 = _e4049;
                            local_83 = _e4051;
                            local_84 = _e4053;
                            local_85 = _e4055;
                            local_86 = _e4035;
                            local_88 = _e4041;
                            continue;
                            continuing {
                                phi_1986_ = _e3437;
                                phi_1989_ = _e4037;
                                break if !(_e4039);
                            }
                        }
                        let _e4058 = local_44;
                        if _e4058 {
                            phi_2955_ = type_40(0u, type_40().member_1);
                            phi_2956_ = false;
                            phi_2957_ = false;
                            phi_2958_ = false;
                            phi_2959_ = false;
                            phi_2960_ = false;
                            phi_2961_ = false;
                            phi_2962_ = false;
                        } else {
                            phi_2955_ = type_40();
                            let _e5586 = local_79;
                            phi_2956_ = _e5586;
                            let _e5589 = local_80;
                            phi_2957_ = _e5589;
                            let _e5592 = local_81;
                            phi_2958_ = _e5592;
                            let _e5595 = local_82;
                            phi_2959_ = _e5595;
                            let _e5598 = local_83;
                            phi_2960_ = _e5598;
                            let _e5601 = local_84;
                            phi_2961_ = _e5601;
                            let _e5604 = local_85;
                            phi_2962_ = _e5604;
                        }
                        let _e4062 = phi_2955_;
                        let _e4064 = phi_2956_;
                        let _e4066 = phi_2957_;
                        let _e4068 = phi_2958_;
                        let _e4070 = phi_2959_;
                        let _e4072 = phi_2960_;
                        let _e4074 = phi_2961_;
                        let _e4076 = phi_2962_;
                        if _e4064 {
                            let _e5607 = local_86;
                            phi_2966_ = _e5607;
                            phi_2967_ = true;
                            phi_2968_ = false;
                            phi_2969_ = false;
                            phi_2970_ = false;
                            phi_2971_ = false;
                            phi_2972_ = false;
                            phi_2973_ = false;
                        } else {
                            let _e5609 = local_87;
                            phi_2966_ = _e5609;
                            phi_2967_ = _e4066;
                            phi_2968_ = _e4068;
                            phi_2969_ = _e4070;
                            phi_2970_ = _e4072;
                            let _e5616 = local_88;
                            phi_2971_ = _e5616;
                            phi_2972_ = _e4074;
                            phi_2973_ = _e4076;
                        }
                        let _e4078 = phi_2966_;
                        let _e4080 = phi_2967_;
                        let _e4082 = phi_2968_;
                        let _e4084 = phi_2969_;
                        let _e4086 = phi_2970_;
                        let _e4088 = phi_2971_;
                        let _e4090 = phi_2972_;
                        let _e4092 = phi_2973_;
                        if _e4080 {
                            phi_2978_ = type_40(1u, _e4078);
                            phi_2979_ = false;
                            phi_2980_ = false;
                            phi_2981_ = false;
                            phi_2982_ = false;
                            phi_2983_ = false;
                            phi_2984_ = false;
                        } else {
                            phi_2978_ = type_40();
                            phi_2979_ = _e4082;
                            phi_2980_ = _e4084;
                            phi_2981_ = _e4086;
                            phi_2982_ = _e4088;
                            phi_2983_ = _e4090;
                            phi_2984_ = _e4092;
                        }
                        let _e4095 = phi_2978_;
                        let _e4097 = phi_2979_;
                        let _e4099 = phi_2980_;
                        let _e4101 = phi_2981_;
                        let _e4103 = phi_2982_;
                        let _e4105 = phi_2983_;
                        let _e4107 = phi_2984_;
                        if _e4097 {
                            let _e4109 = local_45;
                            phi_2989_ = type_40(1u, _e4109);
                            phi_2990_ = false;
                            phi_2991_ = false;
                            phi_2992_ = true;
                            phi_2993_ = false;
                            phi_2994_ = false;
                        } else {
                            phi_2989_ = _e4062;
                            phi_2990_ = _e4099;
                            phi_2991_ = _e4101;
                            phi_2992_ = _e4103;
                            phi_2993_ = _e4105;
                            phi_2994_ = _e4107;
                        }
                        let _e4112 = phi_2989_;
                        let _e4114 = phi_2990_;
                        let _e4116 = phi_2991_;
                        let _e4118 = phi_2992_;
                        let _e4120 = phi_2993_;
                        let _e4122 = phi_2994_;
                        if _e4114 {
                            let _e4124 = local_46;
                            phi_2999_ = type_40(1u, _e4124);
                            phi_3000_ = false;
                            phi_3001_ = false;
                            phi_3002_ = false;
                            phi_3003_ = false;
                        } else {
                            phi_2999_ = type_40();
                            phi_3000_ = _e4116;
                            phi_3001_ = _e4118;
                            phi_3002_ = _e4120;
                            phi_3003_ = _e4122;
                        }
                        let _e4127 = phi_2999_;
                        let _e4129 = phi_3000_;
                        let _e4131 = phi_3001_;
                        let _e4133 = phi_3002_;
                        let _e4135 = phi_3003_;
                        if _e4129 {
                            let _e4137 = local_47;
                            phi_3008_ = type_40(1u, _e4137);
                            phi_3009_ = true;
                            phi_3010_ = false;
                            phi_3011_ = false;
                            phi_3012_ = false;
                        } else {
                            phi_3008_ = _e4127;
                            phi_3009_ = _e4114;
                            phi_3010_ = _e4131;
                            phi_3011_ = _e4133;
                            phi_3012_ = _e4135;
                        }
                        let _e4140 = phi_3008_;
                        let _e4142 = phi_3009_;
                        let _e4144 = phi_3010_;
                        let _e4146 = phi_3011_;
                        let _e4148 = phi_3012_;
                        if _e4142 {
                            phi_3016_ = _e4140;
                            phi_3017_ = true;
                            phi_3018_ = false;
                            phi_3019_ = false;
                        } else {
                            phi_3016_ = _e4112;
                            phi_3017_ = _e4144;
                            phi_3018_ = _e4146;
                            phi_3019_ = _e4148;
                        }
                        let _e4150 = phi_3016_;
                        let _e4152 = phi_3017_;
                        let _e4154 = phi_3018_;
                        let _e4156 = phi_3019_;
                        if _e4152 {
                            phi_3023_ = false;
                            phi_3024_ = false;
                        } else {
                            phi_3023_ = _e4154;
                            phi_3024_ = _e4156;
                        }
                        let _e4158 = phi_3023_;
                        let _e4160 = phi_3024_;
                        if _e4158 {
                            phi_3028_ = false;
                            phi_3029_ = false;
                        } else {
                            phi_3028_ = _e4160;
                            phi_3029_ = _e4152;
                        }
                        let _e4162 = phi_3028_;
                        let _e4164 = phi_3029_;
                        if _e4162 {
                            phi_3033_ = true;
                            phi_3034_ = false;
                        } else {
                            phi_3033_ = _e4158;
                            phi_3034_ = _e4164;
                        }
                        let _e4166 = phi_3033_;
                        let _e4168 = phi_3034_;
                        if _e4166 {
                            let _e4170 = local_48;
                            phi_3039_ = type_40(1u, _e4170);
                            phi_3040_ = true;
                        } else {
                            phi_3039_ = _e4150;
                            phi_3040_ = _e4168;
                        }
                        let _e4173 = phi_3039_;
                        let _e4175 = phi_3040_;
                        if _e4175 {
                            phi_3044_ = _e4173;
                        } else {
                            phi_3044_ = _e4095;
                        }
                        let _e4177 = phi_3044_;
                        if (_e4177.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_3058_ = type_19(0u, 3u);
                            loop {
                                let _e4189 = phi_3058_;
                                if (_e4189.member < _e4189.member_1) {
                                    phi_3059_ = type_19((_e4189.member + 1u), _e4189.member_1);
                                    phi_3082_ = type_19(1u, _e4189.member);
                                } else {
                                    phi_3059_ = _e4189;
                                    phi_3082_ = type_19(0u, type_19().member_1);
                                }
                                let _e4201 = phi_3059_;
                                let _e4203 = phi_3082_;
                                if (bitcast<i32>(_e4203.member) != 0i) {
                                    let _e4209 = local_14[_e4203.member_1];
                                    let _e4211 = (_e4177.member_1 + f64(_e4209));
                                    if (_e4211 < _e3190) {
                                        phi_3103_ = _e4211;
                                    } else {
                                        phi_3103_ = _e3190;
                                    }
                                    let _e4214 = phi_3103_;
                                    let _e4217 = local_20.member[0u];
                                    let _e4223 = local_20.member[1u];
                                    let _e4233 = (_e4217[0] + ((_e4223[0] - _e4217[0]) * _e4214));
                                    let _e4234 = (_e4217[1] + ((_e4223[1] - _e4217[1]) * _e4214));
                                    let _e4235 = (_e4217[2] + ((_e4223[2] - _e4217[2]) * _e4214));
                                    let _e4238 = local_20.member_1[0u];
                                    let _e4244 = local_20.member_1[1u];
                                    let _e4254 = (_e4238[0] + ((_e4244[0] - _e4238[0]) * _e4214));
                                    let _e4255 = (_e4238[1] + ((_e4244[1] - _e4238[1]) * _e4214));
                                    let _e4256 = (_e4238[2] + ((_e4244[2] - _e4238[2]) * _e4214));
                                    let _e4259 = local_20.member_2[0u];
                                    let _e4265 = local_20.member_2[1u];
                                    let _e4275 = (_e4259[0] + ((_e4265[0] - _e4259[0]) * _e4214));
                                    let _e4276 = (_e4259[1] + ((_e4265[1] - _e4259[1]) * _e4214));
                                    let _e4277 = (_e4259[2] + ((_e4265[2] - _e4259[2]) * _e4214));
                                    let _e4282 = (((_e4254 * _e4254) + (_e4255 * _e4255)) + (_e4256 * _e4256));
                                    let _e4287 = (((_e4254 * _e4275) + (_e4255 * _e4276)) + (_e4256 * _e4277));
                                    let _e4292 = (((_e4275 * _e4275) + (_e4276 * _e4276)) + (_e4277 * _e4277));
                                    let _e4297 = (((_e4233 * _e4254) + (_e4234 * _e4255)) + (_e4235 * _e4256));
                                    let _e4302 = (((_e4233 * _e4275) + (_e4234 * _e4276)) + (_e4235 * _e4277));
                                    let _e4305 = ((_e4282 * _e4292) - (_e4287 * _e4287));
                                    let _e4306 = f64(0f);
                                    let _e4311 = (((_e4297 * _e4292) - (_e4302 * _e4287)) / _e4305);
                                    let _e4315 = (((_e4302 * _e4282) - (_e4297 * _e4287)) / _e4305);
                                    if (_e4311 >= _e4306) {
                                        if (_e4315 >= _e4306) {
                                            phi_3273_ = ((_e4311 + _e4315) <= f64(1f));
                                            phi_3274_ = false;
                                        } else {
                                            phi_3273_ = bool();
                                            phi_3274_ = true;
                                        }
                                        let _e4321 = phi_3273_;
                                        let _e4323 = phi_3274_;
                                        phi_3275_ = _e4321;
                                        phi_3276_ = _e4323;
                                    } else {
                                        phi_3275_ = bool();
                                        phi_3276_ = true;
                                    }
                                    let _e4325 = phi_3275_;
                                    let _e4327 = phi_3276_;
                                    if _e4327 {
                                        phi_3280_ = false;
                                    } else {
                                        phi_3280_ = _e4325;
                                    }
                                    let _e4329 = phi_3280_;
                                    if (_e4305 > _e4306) {
                                        if _e4329 {
                                            phi_3302_ = array<f64, 3>((_e4233 - ((_e4254 * _e4311) + (_e4275 * _e4315))), (_e4234 - ((_e4255 * _e4311) + (_e4276 * _e4315))), (_e4235 - ((_e4256 * _e4311) + (_e4277 * _e4315))));
                                            phi_3303_ = false;
                                        } else {
                                            phi_3302_ = array<f64, 3>();
                                            phi_3303_ = true;
                                        }
                                        let _e4345 = phi_3302_;
                                        let _e4347 = phi_3303_;
                                        phi_3304_ = _e4345;
                                        phi_3305_ = _e4347;
                                    } else {
                                        phi_3304_ = array<f64, 3>();
                                        phi_3305_ = true;
                                    }
                                    let _e4349 = phi_3304_;
                                    let _e4351 = phi_3305_;
                                    if _e4351 {
                                        let _e4352 = (_e4233 - _e4254);
                                        let _e4353 = (_e4234 - _e4255);
                                        let _e4354 = (_e4235 - _e4256);
                                        let _e4355 = (_e4275 - _e4254);
                                        let _e4356 = (_e4276 - _e4255);
                                        let _e4357 = (_e4277 - _e4256);
                                        let _e4368 = ((((_e4352 * _e4355) + (_e4353 * _e4356)) + (_e4354 * _e4357)) / (((_e4355 * _e4355) + (_e4356 * _e4356)) + (_e4357 * _e4357)));
                                        if (_e4368 > f64(0f)) {
                                            if (_e4368 < f64(1f)) {
                                                phi_3492_ = _e4368;
                                            } else {
                                                phi_3492_ = f64(1f);
                                            }
                                            let _e4376 = phi_3492_;
                                            phi_3494_ = _e4376;
                                        } else {
                                            phi_3494_ = f64(0f);
                                        }
                                        let _e4378 = phi_3494_;
                                        let _e4382 = (_e4352 - (_e4355 * _e4378));
                                        let _e4383 = (_e4353 - (_e4356 * _e4378));
                                        let _e4384 = (_e4354 - (_e4357 * _e4378));
                                        let _e4395 = ((((_e4233 * _e4254) + (_e4234 * _e4255)) + (_e4235 * _e4256)) / (((_e4254 * _e4254) + (_e4255 * _e4255)) + (_e4256 * _e4256)));
                                        if (_e4395 > f64(0f)) {
                                            if (_e4395 < f64(1f)) {
                                                phi_3524_ = _e4395;
                                            } else {
                                                phi_3524_ = f64(1f);
                                            }
                                            let _e4403 = phi_3524_;
                                            phi_3526_ = _e4403;
                                        } else {
                                            phi_3526_ = f64(0f);
                                        }
                                        let _e4405 = phi_3526_;
                                        let _e4422 = ((((_e4233 * _e4275) + (_e4234 * _e4276)) + (_e4235 * _e4277)) / (((_e4275 * _e4275) + (_e4276 * _e4276)) + (_e4277 * _e4277)));
                                        if (_e4422 > f64(0f)) {
                                            if (_e4422 < f64(1f)) {
                                                phi_3556_ = _e4422;
                                            } else {
                                                phi_3556_ = f64(1f);
                                            }
                                            let _e4430 = phi_3556_;
                                            phi_3558_ = _e4430;
                                        } else {
                                            phi_3558_ = f64(0f);
                                        }
                                        let _e4432 = phi_3558_;
                                        local_10[0u] = array<f64, 3>((_e4233 - (_e4254 * _e4405)), (_e4234 - (_e4255 * _e4405)), (_e4235 - (_e4256 * _e4405)));
                                        local_10[1u] = array<f64, 3>((_e4233 - (_e4275 * _e4432)), (_e4234 - (_e4276 * _e4432)), (_e4235 - (_e4277 * _e4432)));
                                        local_10[2u] = array<f64, 3>(_e4382, _e4383, _e4384);
                                        local_10[3u] = array<f64, 3>(_e4382, _e4383, _e4384);
                                        let _e4448 = local_10[0u];
                                        phi_3594_ = type_19(1u, 4u);
                                        phi_3597_ = array<f64, 3>(_e4448[0], _e4448[1], _e4448[2]);
                                        loop {
                                            let _e4454 = phi_3594_;
                                            let _e4456 = phi_3597_;
                                            local_89 = _e4456;
                                            if (_e4454.member < _e4454.member_1) {
                                                phi_3595_ = type_19((_e4454.member + 1u), _e4454.member_1);
                                                phi_3620_ = type_19(1u, _e4454.member);
                                            } else {
                                                phi_3595_ = _e4454;
                                                phi_3620_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e4468 = phi_3595_;
                                            let _e4470 = phi_3620_;
                                            let _e4474 = (bitcast<i32>(_e4470.member) != 0i);
                                            if _e4474 {
                                                let _e4476 = local_10[_e4470.member_1];
                                                let _e4481 = local_10[_e4470.member_1];
                                                if ((((_e4476[0] * _e4481[0]) + (_e4476[1] * _e4481[1])) + (_e4476[2] * _e4481[2])) < (((_e4456[0] * _e4456[0]) + (_e4456[1] * _e4456[1])) + (_e4456[2] * _e4456[2]))) {
                                                    let _e4503 = local_10[_e4470.member_1];
                                                    phi_3687_ = array<f64, 3>(_e4503[0], _e4503[1], _e4503[2]);
                                                } else {
                                                    phi_3687_ = _e4456;
                                                }
                                                let _e4509 = phi_3687_;
                                                phi_3598_ = _e4509;
                                            } else {
                                                phi_3598_ = array<f64, 3>();
                                            }
                                            let _e4511 = phi_3598_;
                                            continue;
                                            continuing {
                                                phi_3594_ = _e4468;
                                                phi_3597_ = _e4511;
                                                break if !(_e4474);
                                            }
                                        }
                                        let _e5686 = local_89;
                                        phi_3688_ = _e5686;
                                    } else {
                                        phi_3688_ = _e4349;
                                    }
                                    let _e4514 = phi_3688_;
                                    let _e4525 = (((_e4514[0] * _e4514[0]) + (_e4514[1] * _e4514[1])) + (_e4514[2] * _e4514[2]));
                                    if (_e4525 <= 2.2250738585072014e-308lf) {
                                        if (_e4525 > 0.0lf) {
                                            phi_3713_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3713_ = 0.0lf;
                                        }
                                        let _e4577 = phi_3713_;
                                        phi_3777_ = _e4577;
                                    } else {
                                        phi_3720_ = type_17(0i, 5i);
                                        phi_3723_ = bitcast<f64>(((bitcast<u64>(_e4525) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e4532 = phi_3720_;
                                            let _e4534 = phi_3723_;
                                            local_49 = _e4534;
                                            if (_e4532.member < _e4532.member_1) {
                                                let _e4541 = (_e4532.member + 1i);
                                                if ((false == (_e4541 > _e4532.member)) != false) {
                                                    phi_3744_ = true;
                                                } else {
                                                    phi_3744_ = false;
                                                }
                                                let _e4546 = phi_3744_;
                                                if _e4546 {
                                                    phi_3750_ = type_18(0u, type_18().member_1);
                                                } else {
                                                    phi_3750_ = type_18(1u, _e4541);
                                                }
                                                let _e4551 = phi_3750_;
                                                phi_3721_ = type_17(_e4551.member_1, _e4532.member_1);
                                                phi_3764_ = type_18(1u, _e4532.member);
                                            } else {
                                                phi_3721_ = _e4532;
                                                phi_3764_ = type_18(0u, type_18().member_1);
                                            }
                                            let _e4557 = phi_3721_;
                                            let _e4559 = phi_3764_;
                                            let _e4562 = (bitcast<i32>(_e4559.member) != 0i);
                                            if _e4562 {
                                                phi_3724_ = (0.5lf * (_e4534 + (_e4525 / _e4534)));
                                            } else {
                                                phi_3724_ = f64();
                                            }
                                            let _e4567 = phi_3724_;
                                            continue;
                                            continuing {
                                                phi_3720_ = _e4557;
                                                phi_3723_ = _e4567;
                                                break if !(_e4562);
                                            }
                                        }
                                        let _e4572 = local_49;
                                        phi_3777_ = (_e4572 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e4579 = phi_3777_;
                                    let _e4587 = local_20.member[0u];
                                    if (_e4587[0] < 0.0lf) {
                                        phi_3795_ = -(_e4587[0]);
                                    } else {
                                        phi_3795_ = _e4587[0];
                                    }
                                    let _e4594 = phi_3795_;
                                    if (_e4587[1] < 0.0lf) {
                                        phi_3802_ = -(_e4587[1]);
                                    } else {
                                        phi_3802_ = _e4587[1];
                                    }
                                    let _e4598 = phi_3802_;
                                    if (_e4594 > _e4598) {
                                        phi_3807_ = _e4594;
                                    } else {
                                        phi_3807_ = _e4598;
                                    }
                                    let _e4601 = phi_3807_;
                                    if (_e4587[2] < 0.0lf) {
                                        phi_3814_ = -(_e4587[2]);
                                    } else {
                                        phi_3814_ = _e4587[2];
                                    }
                                    let _e4605 = phi_3814_;
                                    if (_e4601 > _e4605) {
                                        phi_3819_ = _e4601;
                                    } else {
                                        phi_3819_ = _e4605;
                                    }
                                    let _e4608 = phi_3819_;
                                    let _e4611 = local_20.member[1u];
                                    if (_e4611[0] < 0.0lf) {
                                        phi_3832_ = -(_e4611[0]);
                                    } else {
                                        phi_3832_ = _e4611[0];
                                    }
                                    let _e4618 = phi_3832_;
                                    if (_e4611[1] < 0.0lf) {
                                        phi_3839_ = -(_e4611[1]);
                                    } else {
                                        phi_3839_ = _e4611[1];
                                    }
                                    let _e4622 = phi_3839_;
                                    if (_e4618 > _e4622) {
                                        phi_3844_ = _e4618;
                                    } else {
                                        phi_3844_ = _e4622;
                                    }
                                    let _e4625 = phi_3844_;
                                    if (_e4611[2] < 0.0lf) {
                                        phi_3851_ = -(_e4611[2]);
                                    } else {
                                        phi_3851_ = _e4611[2];
                                    }
                                    let _e4629 = phi_3851_;
                                    if (_e4625 > _e4629) {
                                        phi_3856_ = _e4625;
                                    } else {
                                        phi_3856_ = _e4629;
                                    }
                                    let _e4632 = phi_3856_;
                                    if (_e4608 > _e4632) {
                                        phi_3861_ = _e4608;
                                    } else {
                                        phi_3861_ = _e4632;
                                    }
                                    let _e4635 = phi_3861_;
                                    let _e4637 = local_20.member_3;
                                    let _e4641 = local_20.member_1[0u];
                                    if (_e4641[0] < 0.0lf) {
                                        phi_3878_ = -(_e4641[0]);
                                    } else {
                                        phi_3878_ = _e4641[0];
                                    }
                                    let _e4648 = phi_3878_;
                                    if (_e4641[1] < 0.0lf) {
                                        phi_3885_ = -(_e4641[1]);
                                    } else {
                                        phi_3885_ = _e4641[1];
                                    }
                                    let _e4652 = phi_3885_;
                                    if (_e4648 > _e4652) {
                                        phi_3890_ = _e4648;
                                    } else {
                                        phi_3890_ = _e4652;
                                    }
                                    let _e4655 = phi_3890_;
                                    if (_e4641[2] < 0.0lf) {
                                        phi_3897_ = -(_e4641[2]);
                                    } else {
                                        phi_3897_ = _e4641[2];
                                    }
                                    let _e4659 = phi_3897_;
                                    if (_e4655 > _e4659) {
                                        phi_3902_ = _e4655;
                                    } else {
                                        phi_3902_ = _e4659;
                                    }
                                    let _e4662 = phi_3902_;
                                    let _e4665 = local_20.member_1[1u];
                                    if (_e4665[0] < 0.0lf) {
                                        phi_3916_ = -(_e4665[0]);
                                    } else {
                                        phi_3916_ = _e4665[0];
                                    }
                                    let _e4672 = phi_3916_;
                                    if (_e4665[1] < 0.0lf) {
                                        phi_3923_ = -(_e4665[1]);
                                    } else {
                                        phi_3923_ = _e4665[1];
                                    }
                                    let _e4676 = phi_3923_;
                                    if (_e4672 > _e4676) {
                                        phi_3928_ = _e4672;
                                    } else {
                                        phi_3928_ = _e4676;
                                    }
                                    let _e4679 = phi_3928_;
                                    if (_e4665[2] < 0.0lf) {
                                        phi_3935_ = -(_e4665[2]);
                                    } else {
                                        phi_3935_ = _e4665[2];
                                    }
                                    let _e4683 = phi_3935_;
                                    if (_e4679 > _e4683) {
                                        phi_3940_ = _e4679;
                                    } else {
                                        phi_3940_ = _e4683;
                                    }
                                    let _e4686 = phi_3940_;
                                    if (_e4662 > _e4686) {
                                        phi_3945_ = _e4662;
                                    } else {
                                        phi_3945_ = _e4686;
                                    }
                                    let _e4689 = phi_3945_;
                                    let _e4691 = local_20.member_3;
                                    let _e4695 = local_20.member_2[0u];
                                    if (_e4695[0] < 0.0lf) {
                                        phi_3962_ = -(_e4695[0]);
                                    } else {
                                        phi_3962_ = _e4695[0];
                                    }
                                    let _e4702 = phi_3962_;
                                    if (_e4695[1] < 0.0lf) {
                                        phi_3969_ = -(_e4695[1]);
                                    } else {
                                        phi_3969_ = _e4695[1];
                                    }
                                    let _e4706 = phi_3969_;
                                    if (_e4702 > _e4706) {
                                        phi_3974_ = _e4702;
                                    } else {
                                        phi_3974_ = _e4706;
                                    }
                                    let _e4709 = phi_3974_;
                                    if (_e4695[2] < 0.0lf) {
                                        phi_3981_ = -(_e4695[2]);
                                    } else {
                                        phi_3981_ = _e4695[2];
                                    }
                                    let _e4713 = phi_3981_;
                                    if (_e4709 > _e4713) {
                                        phi_3986_ = _e4709;
                                    } else {
                                        phi_3986_ = _e4713;
                                    }
                                    let _e4716 = phi_3986_;
                                    let _e4719 = local_20.member_2[1u];
                                    if (_e4719[0] < 0.0lf) {
                                        phi_4000_ = -(_e4719[0]);
                                    } else {
                                        phi_4000_ = _e4719[0];
                                    }
                                    let _e4726 = phi_4000_;
                                    if (_e4719[1] < 0.0lf) {
                                        phi_4007_ = -(_e4719[1]);
                                    } else {
                                        phi_4007_ = _e4719[1];
                                    }
                                    let _e4730 = phi_4007_;
                                    if (_e4726 > _e4730) {
                                        phi_4012_ = _e4726;
                                    } else {
                                        phi_4012_ = _e4730;
                                    }
                                    let _e4733 = phi_4012_;
                                    if (_e4719[2] < 0.0lf) {
                                        phi_4019_ = -(_e4719[2]);
                                    } else {
                                        phi_4019_ = _e4719[2];
                                    }
                                    let _e4737 = phi_4019_;
                                    if (_e4733 > _e4737) {
                                        phi_4024_ = _e4733;
                                    } else {
                                        phi_4024_ = _e4737;
                                    }
                                    let _e4740 = phi_4024_;
                                    if (_e4716 > _e4740) {
                                        phi_4029_ = _e4716;
                                    } else {
                                        phi_4029_ = _e4740;
                                    }
                                    let _e4743 = phi_4029_;
                                    let _e4745 = local_20.member_3;
                                    let _e4753 = local_20.member_3;
                                    let _e4763 = (((_e4579 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e4635 + _e4637) + (_e4689 + _e4691)) + (_e4743 + _e4745)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4753 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e423);
                                    if _e4763 {
                                        phi_4053_ = false;
                                    } else {
                                        phi_4053_ = true;
                                    }
                                    let _e4765 = phi_4053_;
                                    phi_4054_ = _e4765;
                                    phi_4055_ = _e4763;
                                } else {
                                    phi_4054_ = false;
                                    phi_4055_ = false;
                                }
                                let _e4767 = phi_4054_;
                                let _e4769 = phi_4055_;
                                local_50 = _e4769;
                                continue;
                                continuing {
                                    phi_3058_ = _e4201;
                                    break if !(_e4767);
                                }
                            }
                            let _e4772 = local_50;
                            if _e4772 {
                                phi_4060_ = type_40(1u, _e4177.member_1);
                                phi_4061_ = false;
                            } else {
                                phi_4060_ = type_40();
                                phi_4061_ = true;
                            }
                            let _e4775 = phi_4060_;
                            let _e4777 = phi_4061_;
                            if _e4777 {
                                phi_4066_ = type_40(2u, _e4177.member_1);
                                phi_4067_ = false;
                            } else {
                                phi_4066_ = type_40();
                                phi_4067_ = true;
                            }
                            let _e4780 = phi_4066_;
                            let _e4782 = phi_4067_;
                            phi_4069_ = _e4780;
                            phi_4070_ = _e4775;
                            phi_4071_ = _e4782;
                        } else {
                            phi_4069_ = type_40();
                            phi_4070_ = type_40(0u, type_40().member_1);
                            phi_4071_ = true;
                        }
                        let _e4784 = phi_4069_;
                        let _e4786 = phi_4070_;
                        let _e4788 = phi_4071_;
                        if _e4788 {
                            phi_4075_ = _e4786;
                        } else {
                            phi_4075_ = _e4784;
                        }
                        let _e4790 = phi_4075_;
                        phi_7446_ = _e4790;
                    } else {
                        if (_e522 < 0.0lf) {
                            phi_4086_ = -(_e522);
                        } else {
                            phi_4086_ = _e522;
                        }
                        let _e877 = phi_4086_;
                        if (_e545 < 0.0lf) {
                            phi_4092_ = -(_e545);
                        } else {
                            phi_4092_ = _e545;
                        }
                        let _e881 = phi_4092_;
                        if (_e877 > _e881) {
                            phi_4097_ = _e877;
                        } else {
                            phi_4097_ = _e881;
                        }
                        let _e884 = phi_4097_;
                        if (_e568 < 0.0lf) {
                            phi_4103_ = -(_e568);
                        } else {
                            phi_4103_ = _e568;
                        }
                        let _e888 = phi_4103_;
                        if (_e579 < 0.0lf) {
                            phi_4109_ = -(_e579);
                        } else {
                            phi_4109_ = _e579;
                        }
                        let _e892 = phi_4109_;
                        if (_e888 > _e892) {
                            phi_4114_ = _e888;
                        } else {
                            phi_4114_ = _e892;
                        }
                        let _e895 = phi_4114_;
                        if (_e884 > _e895) {
                            phi_4119_ = _e884;
                        } else {
                            phi_4119_ = _e895;
                        }
                        let _e898 = phi_4119_;
                        let _e900 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e901 = f64(1f);
                        if (_e898 >= _e900) {
                            phi_4129_ = (_e898 <= (_e901 / _e900));
                        } else {
                            phi_4129_ = false;
                        }
                        let _e906 = phi_4129_;
                        if _e906 {
                            phi_4136_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_4136_ = f64(2f);
                        }
                        let _e911 = phi_4136_;
                        let _e913 = ((_e838 * f64(0.34f)) + (_e898 * _e911));
                        if _e906 {
                            phi_4144_ = (_e901 / _e898);
                        } else {
                            phi_4144_ = f64(0f);
                        }
                        let _e917 = phi_4144_;
                        let _e918 = f64(0f);
                        let _e919 = f64(1f);
                        let _e920 = f64(3f);
                        let _e926 = ((_e545 - (_e920 * _e522)) * _e917);
                        let _e927 = ((_e568 - _e545) * _e917);
                        let _e928 = (((_e920 * _e579) - _e568) * _e917);
                        local_7[0u] = _e918;
                        local_7[1u] = _e919;
                        local_7[2u] = _e919;
                        local_7[3u] = _e919;
                        let _e935 = ((_e927 * _e927) - (_e926 * _e928));
                        if (_e935 > _e918) {
                            if (_e935 <= 2.2250738585072014e-308lf) {
                                if (_e935 > 0.0lf) {
                                    phi_4180_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4180_ = 0.0lf;
                                }
                                let _e988 = phi_4180_;
                                phi_4244_ = _e988;
                            } else {
                                phi_4187_ = type_17(0i, 5i);
                                phi_4190_ = bitcast<f64>(((bitcast<u64>(_e935) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e943 = phi_4187_;
                                    let _e945 = phi_4190_;
                                    local_21 = _e945;
                                    if (_e943.member < _e943.member_1) {
                                        let _e952 = (_e943.member + 1i);
                                        if ((false == (_e952 > _e943.member)) != false) {
                                            phi_4211_ = true;
                                        } else {
                                            phi_4211_ = false;
                                        }
                                        let _e957 = phi_4211_;
                                        if _e957 {
                                            phi_4217_ = type_18(0u, type_18().member_1);
                                        } else {
                                            phi_4217_ = type_18(1u, _e952);
                                        }
                                        let _e962 = phi_4217_;
                                        phi_4188_ = type_17(_e962.member_1, _e943.member_1);
                                        phi_4231_ = type_18(1u, _e943.member);
                                    } else {
                                        phi_4188_ = _e943;
                                        phi_4231_ = type_18(0u, type_18().member_1);
                                    }
                                    let _e968 = phi_4188_;
                                    let _e970 = phi_4231_;
                                    let _e973 = (bitcast<i32>(_e970.member) != 0i);
                                    if _e973 {
                                        phi_4191_ = (0.5lf * (_e945 + (_e935 / _e945)));
                                    } else {
                                        phi_4191_ = f64();
                                    }
                                    let _e978 = phi_4191_;
                                    continue;
                                    continuing {
                                        phi_4187_ = _e968;
                                        phi_4190_ = _e978;
                                        break if !(_e973);
                                    }
                                }
                                let _e983 = local_21;
                                phi_4244_ = (_e983 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e990 = phi_4244_;
                            if (_e927 < _e918) {
                                phi_4250_ = -(_e990);
                            } else {
                                phi_4250_ = _e990;
                            }
                            let _e994 = phi_4250_;
                            let _e996 = -((_e927 + _e994));
                            local_8[0u] = (_e996 / (_e996 + _e928));
                            local_8[1u] = (_e926 / (_e926 + _e996));
                            let _e1005 = local_8[1u];
                            let _e1006 = local_8[0u];
                            if (_e1005 < _e1006) {
                                let _e1009 = local_8[1u];
                                let _e1011 = local_8[0u];
                                local_8[0u] = _e1009;
                                local_8[1u] = _e1011;
                            }
                            phi_4275_ = type_19(0u, 2u);
                            phi_4278_ = 1u;
                            loop {
                                let _e1015 = phi_4275_;
                                let _e1017 = phi_4278_;
                                local_51 = _e1017;
                                if (_e1015.member < _e1015.member_1) {
                                    phi_4276_ = type_19((_e1015.member + 1u), _e1015.member_1);
                                    phi_4301_ = type_19(1u, _e1015.member);
                                } else {
                                    phi_4276_ = _e1015;
                                    phi_4301_ = type_19(0u, type_19().member_1);
                                }
                                let _e1029 = phi_4276_;
                                let _e1031 = phi_4301_;
                                let _e1035 = (bitcast<i32>(_e1031.member) != 0i);
                                if _e1035 {
                                    let _e1037 = local_8[_e1031.member_1];
                                    if (_e1037 > _e918) {
                                        let _e1040 = local_8[_e1031.member_1];
                                        if (_e1040 < _e919) {
                                            let _e1043 = local_8[_e1031.member_1];
                                            local_7[_e1017] = _e1043;
                                            phi_4345_ = (_e1017 + 1u);
                                        } else {
                                            phi_4345_ = _e1017;
                                        }
                                        let _e1047 = phi_4345_;
                                        phi_4346_ = _e1047;
                                    } else {
                                        phi_4346_ = _e1017;
                                    }
                                    let _e1049 = phi_4346_;
                                    phi_4279_ = _e1049;
                                } else {
                                    phi_4279_ = u32();
                                }
                                let _e1051 = phi_4279_;
                                continue;
                                continuing {
                                    phi_4275_ = _e1029;
                                    phi_4278_ = _e1051;
                                    break if !(_e1035);
                                }
                            }
                            let _e4976 = local_51;
                            phi_4347_ = _e4976;
                        } else {
                            phi_4347_ = 1u;
                        }
                        let _e1054 = phi_4347_;
                        local_7[_e1054] = _e919;
                        let _e1056 = local_7;
                        local_9 = _e1056;
                        phi_4367_ = type_19(0u, _e1054);
                        loop {
                            let _e1059 = phi_4367_;
                            if (_e1059.member < _e1059.member_1) {
                                phi_4368_ = type_19((_e1059.member + 1u), _e1059.member_1);
                                phi_4391_ = type_19(1u, _e1059.member);
                            } else {
                                phi_4368_ = _e1059;
                                phi_4391_ = type_19(0u, type_19().member_1);
                            }
                            let _e1071 = phi_4368_;
                            let _e1073 = phi_4391_;
                            if (bitcast<i32>(_e1073.member) != 0i) {
                                let _e1079 = local_9[_e1073.member_1];
                                let _e1082 = local_9[(_e1073.member_1 + 1u)];
                                let _e1084 = (f64(1f) - _e1079);
                                let _e1095 = ((((_e522 * _e1084) + (_e545 * _e1079)) * (_e1084 * _e1084)) + (((_e568 * _e1084) + (_e579 * _e1079)) * (_e1079 * _e1079)));
                                let _e1097 = (f64(1f) - _e1082);
                                let _e1108 = ((((_e522 * _e1097) + (_e545 * _e1082)) * (_e1097 * _e1097)) + (((_e568 * _e1097) + (_e579 * _e1082)) * (_e1082 * _e1082)));
                                if (_e1095 < 0.0lf) {
                                    phi_4445_ = -(_e1095);
                                } else {
                                    phi_4445_ = _e1095;
                                }
                                let _e1112 = phi_4445_;
                                let _e1113 = (_e1112 > _e913);
                                if (_e1108 < 0.0lf) {
                                    phi_4452_ = -(_e1108);
                                } else {
                                    phi_4452_ = _e1108;
                                }
                                let _e1117 = phi_4452_;
                                let _e1118 = (_e1117 > _e913);
                                let _e1119 = f64(0f);
                                if _e1113 {
                                    if _e1118 {
                                        phi_4464_ = ((_e1095 > _e1119) != (_e1108 > _e1119));
                                        phi_4465_ = false;
                                    } else {
                                        phi_4464_ = bool();
                                        phi_4465_ = true;
                                    }
                                    let _e1124 = phi_4464_;
                                    let _e1126 = phi_4465_;
                                    phi_4466_ = _e1124;
                                    phi_4467_ = _e1126;
                                } else {
                                    phi_4466_ = bool();
                                    phi_4467_ = true;
                                }
                                let _e1128 = phi_4466_;
                                let _e1130 = phi_4467_;
                                if _e1130 {
                                    phi_4471_ = false;
                                } else {
                                    phi_4471_ = _e1128;
                                }
                                let _e1132 = phi_4471_;
                                if _e1113 {
                                    if _e1118 {
                                        if _e1132 {
                                            phi_4483_ = type_41();
                                        } else {
                                            phi_4483_ = type_41(f64(1f), _e1119, _e1132);
                                        }
                                        let _e1136 = phi_4483_;
                                        phi_4484_ = _e1136;
                                        phi_4485_ = _e1132;
                                    } else {
                                        phi_4484_ = type_41();
                                        phi_4485_ = true;
                                    }
                                    let _e1138 = phi_4484_;
                                    let _e1140 = phi_4485_;
                                    phi_4486_ = _e1138;
                                    phi_4487_ = _e1140;
                                } else {
                                    phi_4486_ = type_41();
                                    phi_4487_ = true;
                                }
                                let _e1142 = phi_4486_;
                                let _e1144 = phi_4487_;
                                if _e1144 {
                                    if _e1113 {
                                        if (_e1095 < _e1119) {
                                            phi_4500_ = f64(-1f);
                                        } else {
                                            phi_4500_ = f64(1f);
                                        }
                                        let _e1149 = phi_4500_;
                                        let _e1150 = f64(0.00000000000022737368f);
                                        let _e1151 = f64(0.5f);
                                        let _e1152 = f64(3f);
                                        let _e1155 = (_e568 - _e545);
                                        phi_4513_ = type_19(0u, 64u);
                                        phi_4516_ = _e1082;
                                        phi_4518_ = _e1079;
                                        phi_4520_ = (_e1151 * (_e1079 + _e1082));
                                        loop {
                                            let _e1161 = phi_4513_;
                                            let _e1163 = phi_4516_;
                                            let _e1165 = phi_4518_;
                                            let _e1167 = phi_4520_;
                                            local_53 = _e1165;
                                            if (_e1161.member < _e1161.member_1) {
                                                phi_4514_ = type_19((_e1161.member + 1u), _e1161.member_1);
                                                phi_4543_ = type_19(1u, _e1161.member);
                                            } else {
                                                phi_4514_ = _e1161;
                                                phi_4543_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1179 = phi_4514_;
                                            let _e1181 = phi_4543_;
                                            if (bitcast<i32>(_e1181.member) != 0i) {
                                                let _e1186 = (f64(1f) - _e1167);
                                                let _e1199 = ((_e1149 * ((((_e522 * _e1186) + (_e545 * _e1167)) * (_e1186 * _e1186)) + (((_e568 * _e1186) + (_e579 * _e1167)) * (_e1167 * _e1167)))) - _e913);
                                                if (_e1199 > f64(0f)) {
                                                    phi_4570_ = _e1163;
                                                    phi_4571_ = _e1167;
                                                } else {
                                                    phi_4570_ = _e1167;
                                                    phi_4571_ = _e1165;
                                                }
                                                let _e1203 = phi_4570_;
                                                let _e1205 = phi_4571_;
                                                let _e1207 = ((_e1203 - _e1205) > _e1150);
                                                if _e1207 {
                                                    let _e1209 = (f64(1f) - _e1167);
                                                    let _e1221 = (-(_e1199) / (_e1149 * (((((_e545 - (_e1152 * _e522)) * _e1209) + (_e1155 * _e1167)) * _e1209) + (((_e1155 * _e1209) + (((_e1152 * _e579) - _e568) * _e1167)) * _e1167))));
                                                    if (_e1199 > f64(0f)) {
                                                        phi_4599_ = (_e1151 * _e1150);
                                                    } else {
                                                        phi_4599_ = -((_e1151 * _e1150));
                                                    }
                                                    let _e1228 = phi_4599_;
                                                    let _e1230 = ((_e1167 + _e1221) + _e1228);
                                                    if (_e1230 > _e1205) {
                                                        if (_e1230 < _e1203) {
                                                            if (_e1221 < 0.0lf) {
                                                                phi_4615_ = -(_e1221);
                                                            } else {
                                                                phi_4615_ = _e1221;
                                                            }
                                                            let _e1236 = phi_4615_;
                                                            if (_e1236 < (_e1151 * (_e1203 - _e1205))) {
                                                                phi_4622_ = false;
                                                            } else {
                                                                phi_4622_ = true;
                                                            }
                                                            let _e1241 = phi_4622_;
                                                            phi_4623_ = _e1241;
                                                        } else {
                                                            phi_4623_ = true;
                                                        }
                                                        let _e1243 = phi_4623_;
                                                        phi_4624_ = _e1243;
                                                    } else {
                                                        phi_4624_ = true;
                                                    }
                                                    let _e1245 = phi_4624_;
                                                    if _e1245 {
                                                        phi_4630_ = (_e1151 * (_e1205 + _e1203));
                                                    } else {
                                                        phi_4630_ = _e1230;
                                                    }
                                                    let _e1249 = phi_4630_;
                                                    phi_4631_ = _e1249;
                                                    phi_4632_ = false;
                                                } else {
                                                    phi_4631_ = f64();
                                                    phi_4632_ = true;
                                                }
                                                let _e1251 = phi_4631_;
                                                let _e1253 = phi_4632_;
                                                phi_4517_ = _e1203;
                                                phi_4519_ = _e1205;
                                                phi_4521_ = _e1251;
                                                phi_4633_ = _e1205;
                                                phi_4634_ = _e1207;
                                                phi_4635_ = _e1253;
                                            } else {
                                                phi_4517_ = f64();
                                                phi_4519_ = f64();
                                                phi_4521_ = f64();
                                                phi_4633_ = f64();
                                                phi_4634_ = false;
                                                phi_4635_ = false;
                                            }
                                            let _e1255 = phi_4517_;
                                            let _e1257 = phi_4519_;
                                            let _e1259 = phi_4521_;
                                            let _e1261 = phi_4633_;
                                            let _e1263 = phi_4634_;
                                            let _e1265 = phi_4635_;
                                            local_22 = _e1265;
                                            local_52 = _e1261;
                                            continue;
                                            continuing {
                                                phi_4513_ = _e1179;
                                                phi_4516_ = _e1255;
                                                phi_4518_ = _e1257;
                                                phi_4520_ = _e1259;
                                                break if !(_e1263);
                                            }
                                        }
                                        let _e1268 = local_22;
                                        if _e1268 {
                                            let _e5018 = local_52;
                                            phi_4639_ = _e5018;
                                        } else {
                                            let _e5020 = local_53;
                                            phi_4639_ = _e5020;
                                        }
                                        let _e1270 = phi_4639_;
                                        phi_4640_ = _e1270;
                                    } else {
                                        phi_4640_ = _e1079;
                                    }
                                    let _e1272 = phi_4640_;
                                    if _e1118 {
                                        phi_4648_ = type_19(0u, 64u);
                                        phi_4651_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1276 = phi_4648_;
                                            let _e1278 = phi_4651_;
                                            if (_e1276.member < _e1276.member_1) {
                                                phi_4649_ = type_19((_e1276.member + 1u), _e1276.member_1);
                                                phi_4674_ = type_19(1u, _e1276.member);
                                            } else {
                                                phi_4649_ = _e1276;
                                                phi_4674_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1290 = phi_4649_;
                                            let _e1292 = phi_4674_;
                                            if (bitcast<i32>(_e1292.member) != 0i) {
                                                let _e1296 = (_e1272 + _e1278);
                                                if (_e1296 < _e1082) {
                                                    let _e1299 = (f64(1f) - _e1296);
                                                    let _e1310 = ((((_e522 * _e1299) + (_e545 * _e1296)) * (_e1299 * _e1299)) + (((_e568 * _e1299) + (_e579 * _e1296)) * (_e1296 * _e1296)));
                                                    let _e1312 = (f64(1f) - _e1272);
                                                    let _e1323 = ((((_e522 * _e1312) + (_e545 * _e1272)) * (_e1312 * _e1312)) + (((_e568 * _e1312) + (_e579 * _e1272)) * (_e1272 * _e1272)));
                                                    if (_e1310 < 0.0lf) {
                                                        phi_4717_ = -(_e1310);
                                                    } else {
                                                        phi_4717_ = _e1310;
                                                    }
                                                    let _e1327 = phi_4717_;
                                                    if (_e1327 > _e913) {
                                                        if (_e1323 < 0.0lf) {
                                                            phi_4727_ = -(_e1323);
                                                        } else {
                                                            phi_4727_ = _e1323;
                                                        }
                                                        let _e1332 = phi_4727_;
                                                        if (_e1332 > _e913) {
                                                            phi_4737_ = ((_e1310 > f64(0f)) == (_e1323 > f64(0f)));
                                                        } else {
                                                            phi_4737_ = false;
                                                        }
                                                        let _e1340 = phi_4737_;
                                                        phi_4739_ = !(_e1340);
                                                    } else {
                                                        phi_4739_ = false;
                                                    }
                                                    let _e1343 = phi_4739_;
                                                    if _e1343 {
                                                        phi_4744_ = f64();
                                                        phi_4745_ = false;
                                                    } else {
                                                        phi_4744_ = (_e1278 + _e1278);
                                                        phi_4745_ = true;
                                                    }
                                                    let _e1346 = phi_4744_;
                                                    let _e1348 = phi_4745_;
                                                    phi_4746_ = _e1346;
                                                    phi_4747_ = _e1348;
                                                    phi_4748_ = _e1343;
                                                    phi_4749_ = false;
                                                } else {
                                                    phi_4746_ = f64();
                                                    phi_4747_ = false;
                                                    phi_4748_ = false;
                                                    phi_4749_ = true;
                                                }
                                                let _e1350 = phi_4746_;
                                                let _e1352 = phi_4747_;
                                                let _e1354 = phi_4748_;
                                                let _e1356 = phi_4749_;
                                                phi_4750_ = _e1296;
                                                phi_4652_ = _e1350;
                                                phi_4751_ = _e1352;
                                                phi_4752_ = _e1354;
                                                phi_4753_ = _e1356;
                                                phi_4754_ = false;
                                            } else {
                                                phi_4750_ = f64();
                                                phi_4652_ = f64();
                                                phi_4751_ = false;
                                                phi_4752_ = false;
                                                phi_4753_ = false;
                                                phi_4754_ = true;
                                            }
                                            let _e1358 = phi_4750_;
                                            let _e1360 = phi_4652_;
                                            let _e1362 = phi_4751_;
                                            let _e1364 = phi_4752_;
                                            let _e1366 = phi_4753_;
                                            let _e1368 = phi_4754_;
                                            local_23 = _e1364;
                                            local_54 = _e1366;
                                            local_55 = _e1368;
                                            local_56 = _e1358;
                                            continue;
                                            continuing {
                                                phi_4648_ = _e1290;
                                                phi_4651_ = _e1360;
                                                break if !(_e1362);
                                            }
                                        }
                                        let _e1371 = local_23;
                                        if _e1371 {
                                            phi_4758_ = false;
                                            phi_4759_ = false;
                                        } else {
                                            let _e5045 = local_54;
                                            phi_4758_ = _e5045;
                                            let _e5048 = local_55;
                                            phi_4759_ = _e5048;
                                        }
                                        let _e1373 = phi_4758_;
                                        let _e1375 = phi_4759_;
                                        if _e1373 {
                                            phi_4763_ = true;
                                        } else {
                                            phi_4763_ = _e1375;
                                        }
                                        let _e1377 = phi_4763_;
                                        if _e1377 {
                                            phi_4767_ = _e1082;
                                        } else {
                                            let _e5052 = local_56;
                                            phi_4767_ = _e5052;
                                        }
                                        let _e1379 = phi_4767_;
                                        phi_4768_ = _e1379;
                                    } else {
                                        phi_4768_ = _e1082;
                                    }
                                    let _e1381 = phi_4768_;
                                    phi_4770_ = type_41(_e1272, _e1381, _e1132);
                                } else {
                                    phi_4770_ = _e1142;
                                }
                                let _e1384 = phi_4770_;
                                if (_e1384.member > _e1384.member_1) {
                                    phi_7402_ = f64();
                                    phi_7403_ = true;
                                    phi_7404_ = false;
                                    phi_7405_ = false;
                                    phi_7406_ = false;
                                } else {
                                    let _e1392 = ((_e1384.member_1 - _e1384.member) * f64(0.5f));
                                    let _e1393 = (_e1384.member + _e1392);
                                    let _e1396 = (_e1392 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1398 = local_20.member_3;
                                    let _e1401 = local_20.member[0u];
                                    if (_e1401[0] < 0.0lf) {
                                        phi_4801_ = -(_e1401[0]);
                                    } else {
                                        phi_4801_ = _e1401[0];
                                    }
                                    let _e1408 = phi_4801_;
                                    if (_e1401[1] < 0.0lf) {
                                        phi_4808_ = -(_e1401[1]);
                                    } else {
                                        phi_4808_ = _e1401[1];
                                    }
                                    let _e1412 = phi_4808_;
                                    if (_e1408 > _e1412) {
                                        phi_4813_ = _e1408;
                                    } else {
                                        phi_4813_ = _e1412;
                                    }
                                    let _e1415 = phi_4813_;
                                    if (_e1401[2] < 0.0lf) {
                                        phi_4820_ = -(_e1401[2]);
                                    } else {
                                        phi_4820_ = _e1401[2];
                                    }
                                    let _e1419 = phi_4820_;
                                    if (_e1415 > _e1419) {
                                        phi_4825_ = _e1415;
                                    } else {
                                        phi_4825_ = _e1419;
                                    }
                                    let _e1422 = phi_4825_;
                                    let _e1424 = local_20.member[1u];
                                    if (_e1424[0] < 0.0lf) {
                                        phi_4838_ = -(_e1424[0]);
                                    } else {
                                        phi_4838_ = _e1424[0];
                                    }
                                    let _e1431 = phi_4838_;
                                    if (_e1424[1] < 0.0lf) {
                                        phi_4845_ = -(_e1424[1]);
                                    } else {
                                        phi_4845_ = _e1424[1];
                                    }
                                    let _e1435 = phi_4845_;
                                    if (_e1431 > _e1435) {
                                        phi_4850_ = _e1431;
                                    } else {
                                        phi_4850_ = _e1435;
                                    }
                                    let _e1438 = phi_4850_;
                                    if (_e1424[2] < 0.0lf) {
                                        phi_4857_ = -(_e1424[2]);
                                    } else {
                                        phi_4857_ = _e1424[2];
                                    }
                                    let _e1442 = phi_4857_;
                                    if (_e1438 > _e1442) {
                                        phi_4862_ = _e1438;
                                    } else {
                                        phi_4862_ = _e1442;
                                    }
                                    let _e1445 = phi_4862_;
                                    if (_e1422 > _e1445) {
                                        phi_4867_ = _e1422;
                                    } else {
                                        phi_4867_ = _e1445;
                                    }
                                    let _e1448 = phi_4867_;
                                    let _e1451 = local_20.member[0u];
                                    let _e1456 = local_20.member[1u];
                                    let _e1466 = (_e1451[0] + ((_e1456[0] - _e1451[0]) * _e1393));
                                    let _e1467 = (_e1451[1] + ((_e1456[1] - _e1451[1]) * _e1393));
                                    let _e1468 = (_e1451[2] + ((_e1456[2] - _e1451[2]) * _e1393));
                                    let _e1470 = local_20.member[1u];
                                    let _e1475 = local_20.member[0u];
                                    let _e1479 = (_e1470[0] - _e1475[0]);
                                    let _e1480 = (_e1470[1] - _e1475[1]);
                                    let _e1481 = (_e1470[2] - _e1475[2]);
                                    if (_e1479 < 0.0lf) {
                                        phi_4926_ = -(_e1479);
                                    } else {
                                        phi_4926_ = _e1479;
                                    }
                                    let _e1485 = phi_4926_;
                                    if (_e1480 < 0.0lf) {
                                        phi_4932_ = -(_e1480);
                                    } else {
                                        phi_4932_ = _e1480;
                                    }
                                    let _e1489 = phi_4932_;
                                    if (_e1485 > _e1489) {
                                        phi_4937_ = _e1485;
                                    } else {
                                        phi_4937_ = _e1489;
                                    }
                                    let _e1492 = phi_4937_;
                                    if (_e1481 < 0.0lf) {
                                        phi_4943_ = -(_e1481);
                                    } else {
                                        phi_4943_ = _e1481;
                                    }
                                    let _e1496 = phi_4943_;
                                    if (_e1492 > _e1496) {
                                        phi_4948_ = _e1492;
                                    } else {
                                        phi_4948_ = _e1496;
                                    }
                                    let _e1499 = phi_4948_;
                                    let _e1507 = ((((_e1396 * _e1499) * f64(1.01f)) + ((_e1448 + _e1398) * (1.1102230246251565e-16lf * f64(8f)))) + _e1398);
                                    if (_e1466 < 0.0lf) {
                                        phi_4962_ = -(_e1466);
                                    } else {
                                        phi_4962_ = _e1466;
                                    }
                                    let _e1511 = phi_4962_;
                                    if (_e1467 < 0.0lf) {
                                        phi_4968_ = -(_e1467);
                                    } else {
                                        phi_4968_ = _e1467;
                                    }
                                    let _e1515 = phi_4968_;
                                    if (_e1511 > _e1515) {
                                        phi_4973_ = _e1511;
                                    } else {
                                        phi_4973_ = _e1515;
                                    }
                                    let _e1518 = phi_4973_;
                                    if (_e1468 < 0.0lf) {
                                        phi_4979_ = -(_e1468);
                                    } else {
                                        phi_4979_ = _e1468;
                                    }
                                    let _e1522 = phi_4979_;
                                    if (_e1518 > _e1522) {
                                        phi_4984_ = _e1518;
                                    } else {
                                        phi_4984_ = _e1522;
                                    }
                                    let _e1525 = phi_4984_;
                                    local_3 = type_33(array<f64, 3>(_e1466, _e1467, _e1468), _e1507, (_e1525 + _e1507));
                                    let _e1531 = local_20.member_3;
                                    let _e1533 = local_20.member_1[0u];
                                    if (_e1533[0] < 0.0lf) {
                                        phi_5010_ = -(_e1533[0]);
                                    } else {
                                        phi_5010_ = _e1533[0];
                                    }
                                    let _e1540 = phi_5010_;
                                    if (_e1533[1] < 0.0lf) {
                                        phi_5017_ = -(_e1533[1]);
                                    } else {
                                        phi_5017_ = _e1533[1];
                                    }
                                    let _e1544 = phi_5017_;
                                    if (_e1540 > _e1544) {
                                        phi_5022_ = _e1540;
                                    } else {
                                        phi_5022_ = _e1544;
                                    }
                                    let _e1547 = phi_5022_;
                                    if (_e1533[2] < 0.0lf) {
                                        phi_5029_ = -(_e1533[2]);
                                    } else {
                                        phi_5029_ = _e1533[2];
                                    }
                                    let _e1551 = phi_5029_;
                                    if (_e1547 > _e1551) {
                                        phi_5034_ = _e1547;
                                    } else {
                                        phi_5034_ = _e1551;
                                    }
                                    let _e1554 = phi_5034_;
                                    let _e1556 = local_20.member_1[1u];
                                    if (_e1556[0] < 0.0lf) {
                                        phi_5047_ = -(_e1556[0]);
                                    } else {
                                        phi_5047_ = _e1556[0];
                                    }
                                    let _e1563 = phi_5047_;
                                    if (_e1556[1] < 0.0lf) {
                                        phi_5054_ = -(_e1556[1]);
                                    } else {
                                        phi_5054_ = _e1556[1];
                                    }
                                    let _e1567 = phi_5054_;
                                    if (_e1563 > _e1567) {
                                        phi_5059_ = _e1563;
                                    } else {
                                        phi_5059_ = _e1567;
                                    }
                                    let _e1570 = phi_5059_;
                                    if (_e1556[2] < 0.0lf) {
                                        phi_5066_ = -(_e1556[2]);
                                    } else {
                                        phi_5066_ = _e1556[2];
                                    }
                                    let _e1574 = phi_5066_;
                                    if (_e1570 > _e1574) {
                                        phi_5071_ = _e1570;
                                    } else {
                                        phi_5071_ = _e1574;
                                    }
                                    let _e1577 = phi_5071_;
                                    if (_e1554 > _e1577) {
                                        phi_5076_ = _e1554;
                                    } else {
                                        phi_5076_ = _e1577;
                                    }
                                    let _e1580 = phi_5076_;
                                    let _e1583 = local_20.member_1[0u];
                                    let _e1588 = local_20.member_1[1u];
                                    let _e1598 = (_e1583[0] + ((_e1588[0] - _e1583[0]) * _e1393));
                                    let _e1599 = (_e1583[1] + ((_e1588[1] - _e1583[1]) * _e1393));
                                    let _e1600 = (_e1583[2] + ((_e1588[2] - _e1583[2]) * _e1393));
                                    let _e1602 = local_20.member_1[1u];
                                    let _e1607 = local_20.member_1[0u];
                                    let _e1611 = (_e1602[0] - _e1607[0]);
                                    let _e1612 = (_e1602[1] - _e1607[1]);
                                    let _e1613 = (_e1602[2] - _e1607[2]);
                                    if (_e1611 < 0.0lf) {
                                        phi_5135_ = -(_e1611);
                                    } else {
                                        phi_5135_ = _e1611;
                                    }
                                    let _e1617 = phi_5135_;
                                    if (_e1612 < 0.0lf) {
                                        phi_5141_ = -(_e1612);
                                    } else {
                                        phi_5141_ = _e1612;
                                    }
                                    let _e1621 = phi_5141_;
                                    if (_e1617 > _e1621) {
                                        phi_5146_ = _e1617;
                                    } else {
                                        phi_5146_ = _e1621;
                                    }
                                    let _e1624 = phi_5146_;
                                    if (_e1613 < 0.0lf) {
                                        phi_5152_ = -(_e1613);
                                    } else {
                                        phi_5152_ = _e1613;
                                    }
                                    let _e1628 = phi_5152_;
                                    if (_e1624 > _e1628) {
                                        phi_5157_ = _e1624;
                                    } else {
                                        phi_5157_ = _e1628;
                                    }
                                    let _e1631 = phi_5157_;
                                    let _e1639 = ((((_e1396 * _e1631) * f64(1.01f)) + ((_e1580 + _e1531) * (1.1102230246251565e-16lf * f64(8f)))) + _e1531);
                                    if (_e1598 < 0.0lf) {
                                        phi_5171_ = -(_e1598);
                                    } else {
                                        phi_5171_ = _e1598;
                                    }
                                    let _e1643 = phi_5171_;
                                    if (_e1599 < 0.0lf) {
                                        phi_5177_ = -(_e1599);
                                    } else {
                                        phi_5177_ = _e1599;
                                    }
                                    let _e1647 = phi_5177_;
                                    if (_e1643 > _e1647) {
                                        phi_5182_ = _e1643;
                                    } else {
                                        phi_5182_ = _e1647;
                                    }
                                    let _e1650 = phi_5182_;
                                    if (_e1600 < 0.0lf) {
                                        phi_5188_ = -(_e1600);
                                    } else {
                                        phi_5188_ = _e1600;
                                    }
                                    let _e1654 = phi_5188_;
                                    if (_e1650 > _e1654) {
                                        phi_5193_ = _e1650;
                                    } else {
                                        phi_5193_ = _e1654;
                                    }
                                    let _e1657 = phi_5193_;
                                    local_4 = type_33(array<f64, 3>(_e1598, _e1599, _e1600), _e1639, (_e1657 + _e1639));
                                    let _e1663 = local_20.member_3;
                                    let _e1665 = local_20.member_2[0u];
                                    if (_e1665[0] < 0.0lf) {
                                        phi_5219_ = -(_e1665[0]);
                                    } else {
                                        phi_5219_ = _e1665[0];
                                    }
                                    let _e1672 = phi_5219_;
                                    if (_e1665[1] < 0.0lf) {
                                        phi_5226_ = -(_e1665[1]);
                                    } else {
                                        phi_5226_ = _e1665[1];
                                    }
                                    let _e1676 = phi_5226_;
                                    if (_e1672 > _e1676) {
                                        phi_5231_ = _e1672;
                                    } else {
                                        phi_5231_ = _e1676;
                                    }
                                    let _e1679 = phi_5231_;
                                    if (_e1665[2] < 0.0lf) {
                                        phi_5238_ = -(_e1665[2]);
                                    } else {
                                        phi_5238_ = _e1665[2];
                                    }
                                    let _e1683 = phi_5238_;
                                    if (_e1679 > _e1683) {
                                        phi_5243_ = _e1679;
                                    } else {
                                        phi_5243_ = _e1683;
                                    }
                                    let _e1686 = phi_5243_;
                                    let _e1688 = local_20.member_2[1u];
                                    if (_e1688[0] < 0.0lf) {
                                        phi_5256_ = -(_e1688[0]);
                                    } else {
                                        phi_5256_ = _e1688[0];
                                    }
                                    let _e1695 = phi_5256_;
                                    if (_e1688[1] < 0.0lf) {
                                        phi_5263_ = -(_e1688[1]);
                                    } else {
                                        phi_5263_ = _e1688[1];
                                    }
                                    let _e1699 = phi_5263_;
                                    if (_e1695 > _e1699) {
                                        phi_5268_ = _e1695;
                                    } else {
                                        phi_5268_ = _e1699;
                                    }
                                    let _e1702 = phi_5268_;
                                    if (_e1688[2] < 0.0lf) {
                                        phi_5275_ = -(_e1688[2]);
                                    } else {
                                        phi_5275_ = _e1688[2];
                                    }
                                    let _e1706 = phi_5275_;
                                    if (_e1702 > _e1706) {
                                        phi_5280_ = _e1702;
                                    } else {
                                        phi_5280_ = _e1706;
                                    }
                                    let _e1709 = phi_5280_;
                                    if (_e1686 > _e1709) {
                                        phi_5285_ = _e1686;
                                    } else {
                                        phi_5285_ = _e1709;
                                    }
                                    let _e1712 = phi_5285_;
                                    let _e1715 = local_20.member_2[0u];
                                    let _e1720 = local_20.member_2[1u];
                                    let _e1730 = (_e1715[0] + ((_e1720[0] - _e1715[0]) * _e1393));
                                    let _e1731 = (_e1715[1] + ((_e1720[1] - _e1715[1]) * _e1393));
                                    let _e1732 = (_e1715[2] + ((_e1720[2] - _e1715[2]) * _e1393));
                                    let _e1734 = local_20.member_2[1u];
                                    let _e1739 = local_20.member_2[0u];
                                    let _e1743 = (_e1734[0] - _e1739[0]);
                                    let _e1744 = (_e1734[1] - _e1739[1]);
                                    let _e1745 = (_e1734[2] - _e1739[2]);
                                    if (_e1743 < 0.0lf) {
                                        phi_5344_ = -(_e1743);
                                    } else {
                                        phi_5344_ = _e1743;
                                    }
                                    let _e1749 = phi_5344_;
                                    if (_e1744 < 0.0lf) {
                                        phi_5350_ = -(_e1744);
                                    } else {
                                        phi_5350_ = _e1744;
                                    }
                                    let _e1753 = phi_5350_;
                                    if (_e1749 > _e1753) {
                                        phi_5355_ = _e1749;
                                    } else {
                                        phi_5355_ = _e1753;
                                    }
                                    let _e1756 = phi_5355_;
                                    if (_e1745 < 0.0lf) {
                                        phi_5361_ = -(_e1745);
                                    } else {
                                        phi_5361_ = _e1745;
                                    }
                                    let _e1760 = phi_5361_;
                                    if (_e1756 > _e1760) {
                                        phi_5366_ = _e1756;
                                    } else {
                                        phi_5366_ = _e1760;
                                    }
                                    let _e1763 = phi_5366_;
                                    let _e1771 = ((((_e1396 * _e1763) * f64(1.01f)) + ((_e1712 + _e1663) * (1.1102230246251565e-16lf * f64(8f)))) + _e1663);
                                    if (_e1730 < 0.0lf) {
                                        phi_5380_ = -(_e1730);
                                    } else {
                                        phi_5380_ = _e1730;
                                    }
                                    let _e1775 = phi_5380_;
                                    if (_e1731 < 0.0lf) {
                                        phi_5386_ = -(_e1731);
                                    } else {
                                        phi_5386_ = _e1731;
                                    }
                                    let _e1779 = phi_5386_;
                                    if (_e1775 > _e1779) {
                                        phi_5391_ = _e1775;
                                    } else {
                                        phi_5391_ = _e1779;
                                    }
                                    let _e1782 = phi_5391_;
                                    if (_e1732 < 0.0lf) {
                                        phi_5397_ = -(_e1732);
                                    } else {
                                        phi_5397_ = _e1732;
                                    }
                                    let _e1786 = phi_5397_;
                                    if (_e1782 > _e1786) {
                                        phi_5402_ = _e1782;
                                    } else {
                                        phi_5402_ = _e1786;
                                    }
                                    let _e1789 = phi_5402_;
                                    local_5 = type_33(array<f64, 3>(_e1730, _e1731, _e1732), _e1771, (_e1789 + _e1771));
                                    let _e1794 = local_4.member;
                                    let _e1799 = local_5.member;
                                    let _e1805 = ((_e1794[1] * _e1799[2]) - (_e1794[2] * _e1799[1]));
                                    let _e1808 = ((_e1794[2] * _e1799[0]) - (_e1794[0] * _e1799[2]));
                                    let _e1811 = ((_e1794[0] * _e1799[1]) - (_e1794[1] * _e1799[0]));
                                    if (_e1805 < 0.0lf) {
                                        phi_5451_ = -(_e1805);
                                    } else {
                                        phi_5451_ = _e1805;
                                    }
                                    let _e1815 = phi_5451_;
                                    if (_e1808 < 0.0lf) {
                                        phi_5457_ = -(_e1808);
                                    } else {
                                        phi_5457_ = _e1808;
                                    }
                                    let _e1819 = phi_5457_;
                                    if (_e1815 > _e1819) {
                                        if (_e1805 < 0.0lf) {
                                            phi_5467_ = -(_e1805);
                                        } else {
                                            phi_5467_ = _e1805;
                                        }
                                        let _e1837 = phi_5467_;
                                        if (_e1811 < 0.0lf) {
                                            phi_5473_ = -(_e1811);
                                        } else {
                                            phi_5473_ = _e1811;
                                        }
                                        let _e1841 = phi_5473_;
                                        if (_e1837 > _e1841) {
                                            phi_5478_ = 2u;
                                            phi_5479_ = 1u;
                                        } else {
                                            phi_5478_ = 1u;
                                            phi_5479_ = 0u;
                                        }
                                        let _e1844 = phi_5478_;
                                        let _e1846 = phi_5479_;
                                        phi_5498_ = _e1844;
                                        phi_5499_ = _e1846;
                                    } else {
                                        if (_e1808 < 0.0lf) {
                                            phi_5485_ = -(_e1808);
                                        } else {
                                            phi_5485_ = _e1808;
                                        }
                                        let _e1824 = phi_5485_;
                                        if (_e1811 < 0.0lf) {
                                            phi_5491_ = -(_e1811);
                                        } else {
                                            phi_5491_ = _e1811;
                                        }
                                        let _e1828 = phi_5491_;
                                        if (_e1824 > _e1828) {
                                            phi_5496_ = 0u;
                                            phi_5497_ = 2u;
                                        } else {
                                            phi_5496_ = 1u;
                                            phi_5497_ = 0u;
                                        }
                                        let _e1831 = phi_5496_;
                                        let _e1833 = phi_5497_;
                                        phi_5498_ = _e1831;
                                        phi_5499_ = _e1833;
                                    }
                                    let _e1848 = phi_5498_;
                                    let _e1850 = phi_5499_;
                                    let _e1853 = local_4.member[_e1850];
                                    let _e1856 = local_5.member[_e1848];
                                    let _e1860 = local_4.member[_e1848];
                                    let _e1863 = local_5.member[_e1850];
                                    let _e1865 = ((_e1853 * _e1856) - (_e1860 * _e1863));
                                    let _e1866 = f64(1f);
                                    let _e1868 = local_4.member_1;
                                    let _e1870 = local_5.member_2;
                                    let _e1873 = local_4.member_2;
                                    let _e1875 = local_5.member_1;
                                    let _e1881 = local_4.member_2;
                                    let _e1883 = local_5.member_2;
                                    let _e1892 = local_4.member_2;
                                    let _e1895 = local_5.member_2;
                                    let _e1899 = (((((_e1868 * _e1870) + (_e1873 * _e1875)) * f64(2.01f)) + ((_e1881 * _e1883) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1866 + _e1892) * (_e1866 + _e1895))));
                                    if (_e1865 < 0.0lf) {
                                        phi_5570_ = -(_e1865);
                                    } else {
                                        phi_5570_ = _e1865;
                                    }
                                    let _e1903 = phi_5570_;
                                    if (_e1903 > _e1899) {
                                        if (_e1865 < f64(0f)) {
                                            phi_5582_ = f64(-1f);
                                        } else {
                                            phi_5582_ = f64(1f);
                                        }
                                        let _e1910 = phi_5582_;
                                        let _e1913 = local_3.member[_e1850];
                                        let _e1916 = local_5.member[_e1848];
                                        let _e1920 = local_3.member[_e1848];
                                        let _e1923 = local_5.member[_e1850];
                                        let _e1926 = f64(1f);
                                        let _e1928 = local_3.member_1;
                                        let _e1930 = local_5.member_2;
                                        let _e1933 = local_3.member_2;
                                        let _e1935 = local_5.member_1;
                                        let _e1941 = local_3.member_2;
                                        let _e1943 = local_5.member_2;
                                        let _e1952 = local_3.member_2;
                                        let _e1955 = local_5.member_2;
                                        let _e1959 = (((((_e1928 * _e1930) + (_e1933 * _e1935)) * f64(2.01f)) + ((_e1941 * _e1943) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1926 + _e1952) * (_e1926 + _e1955))));
                                        let _e1962 = local_4.member[_e1850];
                                        let _e1965 = local_3.member[_e1848];
                                        let _e1969 = local_4.member[_e1848];
                                        let _e1972 = local_3.member[_e1850];
                                        let _e1975 = f64(1f);
                                        let _e1977 = local_4.member_1;
                                        let _e1979 = local_3.member_2;
                                        let _e1982 = local_4.member_2;
                                        let _e1984 = local_3.member_1;
                                        let _e1990 = local_4.member_2;
                                        let _e1992 = local_3.member_2;
                                        let _e2001 = local_4.member_2;
                                        let _e2004 = local_3.member_2;
                                        let _e2008 = (((((_e1977 * _e1979) + (_e1982 * _e1984)) * f64(2.01f)) + ((_e1990 * _e1992) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1975 + _e2001) * (_e1975 + _e2004))));
                                        let _e2009 = (_e1865 * _e1910);
                                        let _e2010 = (((_e1913 * _e1916) - (_e1920 * _e1923)) * _e1910);
                                        let _e2011 = (((_e1962 * _e1965) - (_e1969 * _e1972)) * _e1910);
                                        if (_e2009 < 0.0lf) {
                                            phi_5721_ = -(_e2009);
                                        } else {
                                            phi_5721_ = _e2009;
                                        }
                                        let _e2015 = phi_5721_;
                                        if (_e2010 < 0.0lf) {
                                            phi_5727_ = -(_e2010);
                                        } else {
                                            phi_5727_ = _e2010;
                                        }
                                        let _e2019 = phi_5727_;
                                        if (_e2011 < 0.0lf) {
                                            phi_5734_ = -(_e2011);
                                        } else {
                                            phi_5734_ = _e2011;
                                        }
                                        let _e2024 = phi_5734_;
                                        let _e2030 = ((_e2009 - _e2010) - _e2011);
                                        let _e2033 = (((_e1899 + _e1959) + _e2008) + (((_e2015 + _e2019) + _e2024) * (1.1102230246251565e-16lf * f64(4f))));
                                        local_6[0u].member = _e2010;
                                        local_6[0u].member_1 = _e1959;
                                        local_6[1u].member = _e2011;
                                        local_6[1u].member_1 = _e2008;
                                        local_6[2u].member = _e2030;
                                        local_6[2u].member_1 = _e2033;
                                        local_6[3u].member = _e2030;
                                        local_6[3u].member_1 = _e2033;
                                        phi_5778_ = type_19(0u, 4u);
                                        phi_5781_ = true;
                                        loop {
                                            let _e2048 = phi_5778_;
                                            let _e2050 = phi_5781_;
                                            local_25 = _e2050;
                                            if (_e2048.member < _e2048.member_1) {
                                                phi_5779_ = type_19((_e2048.member + 1u), _e2048.member_1);
                                                phi_5804_ = type_19(1u, _e2048.member);
                                            } else {
                                                phi_5779_ = _e2048;
                                                phi_5804_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e2062 = phi_5779_;
                                            let _e2064 = phi_5804_;
                                            if (bitcast<i32>(_e2064.member) != 0i) {
                                                let _e2071 = local_6[_e2064.member_1].member;
                                                let _e2074 = local_6[_e2064.member_1].member_1;
                                                let _e2076 = (_e2071 < -(_e2074));
                                                if _e2076 {
                                                    phi_5831_ = bool();
                                                    phi_5832_ = false;
                                                } else {
                                                    phi_5831_ = (_e2050 && (_e2071 > _e2074));
                                                    phi_5832_ = true;
                                                }
                                                let _e2080 = phi_5831_;
                                                let _e2082 = phi_5832_;
                                                phi_5782_ = _e2080;
                                                phi_5833_ = _e2082;
                                                phi_5834_ = _e2076;
                                            } else {
                                                phi_5782_ = bool();
                                                phi_5833_ = false;
                                                phi_5834_ = false;
                                            }
                                            let _e2084 = phi_5782_;
                                            let _e2086 = phi_5833_;
                                            let _e2088 = phi_5834_;
                                            local_24 = _e2088;
                                            continue;
                                            continuing {
                                                phi_5778_ = _e2062;
                                                phi_5781_ = _e2084;
                                                break if !(_e2086);
                                            }
                                        }
                                        let _e2091 = local_24;
                                        if _e2091 {
                                            phi_5838_ = false;
                                        } else {
                                            phi_5838_ = true;
                                        }
                                        let _e2093 = phi_5838_;
                                        if _e2093 {
                                            let _e2095 = local_25;
                                            if _e2095 {
                                                phi_5845_ = 1u;
                                            } else {
                                                phi_5845_ = 2u;
                                            }
                                            let _e2097 = phi_5845_;
                                            phi_5846_ = _e2097;
                                            phi_5847_ = false;
                                        } else {
                                            phi_5846_ = u32();
                                            phi_5847_ = true;
                                        }
                                        let _e2099 = phi_5846_;
                                        let _e2101 = phi_5847_;
                                        phi_5848_ = _e2099;
                                        phi_5849_ = 0u;
                                        phi_5850_ = _e2101;
                                    } else {
                                        phi_5848_ = u32();
                                        phi_5849_ = 2u;
                                        phi_5850_ = true;
                                    }
                                    let _e2103 = phi_5848_;
                                    let _e2105 = phi_5849_;
                                    let _e2107 = phi_5850_;
                                    if _e2107 {
                                        phi_5854_ = _e2105;
                                    } else {
                                        phi_5854_ = _e2103;
                                    }
                                    let _e2109 = phi_5854_;
                                    let _e2110 = (_e2109 == 0u);
                                    if _e2110 {
                                        phi_7398_ = f64();
                                        phi_7399_ = false;
                                        phi_7400_ = false;
                                        phi_7401_ = false;
                                    } else {
                                        if (_e2109 == 1u) {
                                            if _e1384.member_2 {
                                                if ((_e1384.member_1 - _e1384.member) <= f64(0.0000005f)) {
                                                    phi_5875_ = false;
                                                } else {
                                                    phi_5875_ = true;
                                                }
                                                let _e2119 = phi_5875_;
                                                phi_5876_ = _e2119;
                                            } else {
                                                phi_5876_ = true;
                                            }
                                            let _e2121 = phi_5876_;
                                            phi_5877_ = _e2121;
                                        } else {
                                            phi_5877_ = true;
                                        }
                                        let _e2123 = phi_5877_;
                                        if _e2123 {
                                            let _e2129 = local_20.member[0u];
                                            let _e2135 = local_20.member_1[0u];
                                            let _e2141 = local_20.member_2[0u];
                                            local_1 = array<array<f64, 3>, 4>(_e2129, array<f64, 3>((_e2129[0] - _e2135[0]), (_e2129[1] - _e2135[1]), (_e2129[2] - _e2135[2])), array<f64, 3>((_e2129[0] - _e2141[0]), (_e2129[1] - _e2141[1]), (_e2129[2] - _e2141[2])), _e2129);
                                            let _e2156 = local_20.member[1u];
                                            let _e2162 = local_20.member_1[1u];
                                            let _e2168 = local_20.member_2[1u];
                                            local_2 = array<array<f64, 3>, 4>(_e2156, array<f64, 3>((_e2156[0] - _e2162[0]), (_e2156[1] - _e2162[1]), (_e2156[2] - _e2162[2])), array<f64, 3>((_e2156[0] - _e2168[0]), (_e2156[1] - _e2168[1]), (_e2156[2] - _e2168[2])), _e2156);
                                            let _e2183 = local_20.member[0u];
                                            if (_e2183[0] < 0.0lf) {
                                                phi_6074_ = -(_e2183[0]);
                                            } else {
                                                phi_6074_ = _e2183[0];
                                            }
                                            let _e2190 = phi_6074_;
                                            if (_e2183[1] < 0.0lf) {
                                                phi_6081_ = -(_e2183[1]);
                                            } else {
                                                phi_6081_ = _e2183[1];
                                            }
                                            let _e2194 = phi_6081_;
                                            if (_e2190 > _e2194) {
                                                phi_6086_ = _e2190;
                                            } else {
                                                phi_6086_ = _e2194;
                                            }
                                            let _e2197 = phi_6086_;
                                            if (_e2183[2] < 0.0lf) {
                                                phi_6093_ = -(_e2183[2]);
                                            } else {
                                                phi_6093_ = _e2183[2];
                                            }
                                            let _e2201 = phi_6093_;
                                            if (_e2197 > _e2201) {
                                                phi_6098_ = _e2197;
                                            } else {
                                                phi_6098_ = _e2201;
                                            }
                                            let _e2204 = phi_6098_;
                                            let _e2207 = local_20.member[1u];
                                            if (_e2207[0] < 0.0lf) {
                                                phi_6111_ = -(_e2207[0]);
                                            } else {
                                                phi_6111_ = _e2207[0];
                                            }
                                            let _e2214 = phi_6111_;
                                            if (_e2207[1] < 0.0lf) {
                                                phi_6118_ = -(_e2207[1]);
                                            } else {
                                                phi_6118_ = _e2207[1];
                                            }
                                            let _e2218 = phi_6118_;
                                            if (_e2214 > _e2218) {
                                                phi_6123_ = _e2214;
                                            } else {
                                                phi_6123_ = _e2218;
                                            }
                                            let _e2221 = phi_6123_;
                                            if (_e2207[2] < 0.0lf) {
                                                phi_6130_ = -(_e2207[2]);
                                            } else {
                                                phi_6130_ = _e2207[2];
                                            }
                                            let _e2225 = phi_6130_;
                                            if (_e2221 > _e2225) {
                                                phi_6135_ = _e2221;
                                            } else {
                                                phi_6135_ = _e2225;
                                            }
                                            let _e2228 = phi_6135_;
                                            if (_e2204 > _e2228) {
                                                phi_6140_ = _e2204;
                                            } else {
                                                phi_6140_ = _e2228;
                                            }
                                            let _e2231 = phi_6140_;
                                            let _e2233 = local_20.member_3;
                                            let _e2237 = local_20.member_1[0u];
                                            if (_e2237[0] < 0.0lf) {
                                                phi_6157_ = -(_e2237[0]);
                                            } else {
                                                phi_6157_ = _e2237[0];
                                            }
                                            let _e2244 = phi_6157_;
                                            if (_e2237[1] < 0.0lf) {
                                                phi_6164_ = -(_e2237[1]);
                                            } else {
                                                phi_6164_ = _e2237[1];
                                            }
                                            let _e2248 = phi_6164_;
                                            if (_e2244 > _e2248) {
                                                phi_6169_ = _e2244;
                                            } else {
                                                phi_6169_ = _e2248;
                                            }
                                            let _e2251 = phi_6169_;
                                            if (_e2237[2] < 0.0lf) {
                                                phi_6176_ = -(_e2237[2]);
                                            } else {
                                                phi_6176_ = _e2237[2];
                                            }
                                            let _e2255 = phi_6176_;
                                            if (_e2251 > _e2255) {
                                                phi_6181_ = _e2251;
                                            } else {
                                                phi_6181_ = _e2255;
                                            }
                                            let _e2258 = phi_6181_;
                                            let _e2261 = local_20.member_1[1u];
                                            if (_e2261[0] < 0.0lf) {
                                                phi_6195_ = -(_e2261[0]);
                                            } else {
                                                phi_6195_ = _e2261[0];
                                            }
                                            let _e2268 = phi_6195_;
                                            if (_e2261[1] < 0.0lf) {
                                                phi_6202_ = -(_e2261[1]);
                                            } else {
                                                phi_6202_ = _e2261[1];
                                            }
                                            let _e2272 = phi_6202_;
                                            if (_e2268 > _e2272) {
                                                phi_6207_ = _e2268;
                                            } else {
                                                phi_6207_ = _e2272;
                                            }
                                            let _e2275 = phi_6207_;
                                            if (_e2261[2] < 0.0lf) {
                                                phi_6214_ = -(_e2261[2]);
                                            } else {
                                                phi_6214_ = _e2261[2];
                                            }
                                            let _e2279 = phi_6214_;
                                            if (_e2275 > _e2279) {
                                                phi_6219_ = _e2275;
                                            } else {
                                                phi_6219_ = _e2279;
                                            }
                                            let _e2282 = phi_6219_;
                                            if (_e2258 > _e2282) {
                                                phi_6224_ = _e2258;
                                            } else {
                                                phi_6224_ = _e2282;
                                            }
                                            let _e2285 = phi_6224_;
                                            let _e2287 = local_20.member_3;
                                            let _e2291 = local_20.member_2[0u];
                                            if (_e2291[0] < 0.0lf) {
                                                phi_6241_ = -(_e2291[0]);
                                            } else {
                                                phi_6241_ = _e2291[0];
                                            }
                                            let _e2298 = phi_6241_;
                                            if (_e2291[1] < 0.0lf) {
                                                phi_6248_ = -(_e2291[1]);
                                            } else {
                                                phi_6248_ = _e2291[1];
                                            }
                                            let _e2302 = phi_6248_;
                                            if (_e2298 > _e2302) {
                                                phi_6253_ = _e2298;
                                            } else {
                                                phi_6253_ = _e2302;
                                            }
                                            let _e2305 = phi_6253_;
                                            if (_e2291[2] < 0.0lf) {
                                                phi_6260_ = -(_e2291[2]);
                                            } else {
                                                phi_6260_ = _e2291[2];
                                            }
                                            let _e2309 = phi_6260_;
                                            if (_e2305 > _e2309) {
                                                phi_6265_ = _e2305;
                                            } else {
                                                phi_6265_ = _e2309;
                                            }
                                            let _e2312 = phi_6265_;
                                            let _e2315 = local_20.member_2[1u];
                                            if (_e2315[0] < 0.0lf) {
                                                phi_6279_ = -(_e2315[0]);
                                            } else {
                                                phi_6279_ = _e2315[0];
                                            }
                                            let _e2322 = phi_6279_;
                                            if (_e2315[1] < 0.0lf) {
                                                phi_6286_ = -(_e2315[1]);
                                            } else {
                                                phi_6286_ = _e2315[1];
                                            }
                                            let _e2326 = phi_6286_;
                                            if (_e2322 > _e2326) {
                                                phi_6291_ = _e2322;
                                            } else {
                                                phi_6291_ = _e2326;
                                            }
                                            let _e2329 = phi_6291_;
                                            if (_e2315[2] < 0.0lf) {
                                                phi_6298_ = -(_e2315[2]);
                                            } else {
                                                phi_6298_ = _e2315[2];
                                            }
                                            let _e2333 = phi_6298_;
                                            if (_e2329 > _e2333) {
                                                phi_6303_ = _e2329;
                                            } else {
                                                phi_6303_ = _e2333;
                                            }
                                            let _e2336 = phi_6303_;
                                            if (_e2312 > _e2336) {
                                                phi_6308_ = _e2312;
                                            } else {
                                                phi_6308_ = _e2336;
                                            }
                                            let _e2339 = phi_6308_;
                                            let _e2341 = local_20.member_3;
                                            let _e2349 = local_20.member_3;
                                            phi_6328_ = type_19(0u, 48u);
                                            phi_6331_ = _e1384.member;
                                            loop {
                                                let _e2358 = phi_6328_;
                                                let _e2360 = phi_6331_;
                                                local_70 = _e2360;
                                                local_32 = _e2360;
                                                local_33 = _e2360;
                                                local_34 = _e2360;
                                                local_35 = _e2360;
                                                if (_e2358.member < _e2358.member_1) {
                                                    phi_6329_ = type_19((_e2358.member + 1u), _e2358.member_1);
                                                    phi_6354_ = type_19(1u, _e2358.member);
                                                } else {
                                                    phi_6329_ = _e2358;
                                                    phi_6354_ = type_19(0u, type_19().member_1);
                                                }
                                                let _e2372 = phi_6329_;
                                                let _e2374 = phi_6354_;
                                                if (bitcast<i32>(_e2374.member) != 0i) {
                                                    let _e2380 = local_20.member[0u];
                                                    let _e2386 = local_20.member[1u];
                                                    let _e2396 = (_e2380[0] + ((_e2386[0] - _e2380[0]) * _e2360));
                                                    let _e2397 = (_e2380[1] + ((_e2386[1] - _e2380[1]) * _e2360));
                                                    let _e2398 = (_e2380[2] + ((_e2386[2] - _e2380[2]) * _e2360));
                                                    let _e2401 = local_20.member_1[0u];
                                                    let _e2407 = local_20.member_1[1u];
                                                    let _e2417 = (_e2401[0] + ((_e2407[0] - _e2401[0]) * _e2360));
                                                    let _e2418 = (_e2401[1] + ((_e2407[1] - _e2401[1]) * _e2360));
                                                    let _e2419 = (_e2401[2] + ((_e2407[2] - _e2401[2]) * _e2360));
                                                    let _e2422 = local_20.member_2[0u];
                                                    let _e2428 = local_20.member_2[1u];
                                                    let _e2438 = (_e2422[0] + ((_e2428[0] - _e2422[0]) * _e2360));
                                                    let _e2439 = (_e2422[1] + ((_e2428[1] - _e2422[1]) * _e2360));
                                                    let _e2440 = (_e2422[2] + ((_e2428[2] - _e2422[2]) * _e2360));
                                                    let _e2445 = (((_e2417 * _e2417) + (_e2418 * _e2418)) + (_e2419 * _e2419));
                                                    let _e2450 = (((_e2417 * _e2438) + (_e2418 * _e2439)) + (_e2419 * _e2440));
                                                    let _e2455 = (((_e2438 * _e2438) + (_e2439 * _e2439)) + (_e2440 * _e2440));
                                                    let _e2460 = (((_e2396 * _e2417) + (_e2397 * _e2418)) + (_e2398 * _e2419));
                                                    let _e2465 = (((_e2396 * _e2438) + (_e2397 * _e2439)) + (_e2398 * _e2440));
                                                    let _e2468 = ((_e2445 * _e2455) - (_e2450 * _e2450));
                                                    let _e2469 = f64(0f);
                                                    let _e2474 = (((_e2460 * _e2455) - (_e2465 * _e2450)) / _e2468);
                                                    let _e2478 = (((_e2465 * _e2445) - (_e2460 * _e2450)) / _e2468);
                                                    if (_e2474 >= _e2469) {
                                                        if (_e2478 >= _e2469) {
                                                            phi_6530_ = ((_e2474 + _e2478) <= f64(1f));
                                                            phi_6531_ = false;
                                                        } else {
                                                            phi_6530_ = bool();
                                                            phi_6531_ = true;
                                                        }
                                                        let _e2484 = phi_6530_;
                                                        let _e2486 = phi_6531_;
                                                        phi_6532_ = _e2484;
                                                        phi_6533_ = _e2486;
                                                    } else {
                                                        phi_6532_ = bool();
                                                        phi_6533_ = true;
                                                    }
                                                    let _e2488 = phi_6532_;
                                                    let _e2490 = phi_6533_;
                                                    if _e2490 {
                                                        phi_6537_ = false;
                                                    } else {
                                                        phi_6537_ = _e2488;
                                                    }
                                                    let _e2492 = phi_6537_;
                                                    if (_e2468 > _e2469) {
                                                        if _e2492 {
                                                            phi_6559_ = array<f64, 3>((_e2396 - ((_e2417 * _e2474) + (_e2438 * _e2478))), (_e2397 - ((_e2418 * _e2474) + (_e2439 * _e2478))), (_e2398 - ((_e2419 * _e2474) + (_e2440 * _e2478))));
                                                            phi_6560_ = false;
                                                        } else {
                                                            phi_6559_ = array<f64, 3>();
                                                            phi_6560_ = true;
                                                        }
                                                        let _e2508 = phi_6559_;
                                                        let _e2510 = phi_6560_;
                                                        phi_6561_ = _e2508;
                                                        phi_6562_ = _e2510;
                                                    } else {
                                                        phi_6561_ = array<f64, 3>();
                                                        phi_6562_ = true;
                                                    }
                                                    let _e2512 = phi_6561_;
                                                    let _e2514 = phi_6562_;
                                                    if _e2514 {
                                                        let _e2515 = (_e2396 - _e2417);
                                                        let _e2516 = (_e2397 - _e2418);
                                                        let _e2517 = (_e2398 - _e2419);
                                                        let _e2518 = (_e2438 - _e2417);
                                                        let _e2519 = (_e2439 - _e2418);
                                                        let _e2520 = (_e2440 - _e2419);
                                                        let _e2531 = ((((_e2515 * _e2518) + (_e2516 * _e2519)) + (_e2517 * _e2520)) / (((_e2518 * _e2518) + (_e2519 * _e2519)) + (_e2520 * _e2520)));
                                                        if (_e2531 > f64(0f)) {
                                                            if (_e2531 < f64(1f)) {
                                                                phi_6749_ = _e2531;
                                                            } else {
                                                                phi_6749_ = f64(1f);
                                                            }
                                                            let _e2539 = phi_6749_;
                                                            phi_6751_ = _e2539;
                                                        } else {
                                                            phi_6751_ = f64(0f);
                                                        }
                                                        let _e2541 = phi_6751_;
                                                        let _e2545 = (_e2515 - (_e2518 * _e2541));
                                                        let _e2546 = (_e2516 - (_e2519 * _e2541));
                                                        let _e2547 = (_e2517 - (_e2520 * _e2541));
                                                        let _e2558 = ((((_e2396 * _e2417) + (_e2397 * _e2418)) + (_e2398 * _e2419)) / (((_e2417 * _e2417) + (_e2418 * _e2418)) + (_e2419 * _e2419)));
                                                        if (_e2558 > f64(0f)) {
                                                            if (_e2558 < f64(1f)) {
                                                                phi_6781_ = _e2558;
                                                            } else {
                                                                phi_6781_ = f64(1f);
                                                            }
                                                            let _e2566 = phi_6781_;
                                                            phi_6783_ = _e2566;
                                                        } else {
                                                            phi_6783_ = f64(0f);
                                                        }
                                                        let _e2568 = phi_6783_;
                                                        let _e2585 = ((((_e2396 * _e2438) + (_e2397 * _e2439)) + (_e2398 * _e2440)) / (((_e2438 * _e2438) + (_e2439 * _e2439)) + (_e2440 * _e2440)));
                                                        if (_e2585 > f64(0f)) {
                                                            if (_e2585 < f64(1f)) {
                                                                phi_6813_ = _e2585;
                                                            } else {
                                                                phi_6813_ = f64(1f);
                                                            }
                                                            let _e2593 = phi_6813_;
                                                            phi_6815_ = _e2593;
                                                        } else {
                                                            phi_6815_ = f64(0f);
                                                        }
                                                        let _e2595 = phi_6815_;
                                                        local[0u] = array<f64, 3>((_e2396 - (_e2417 * _e2568)), (_e2397 - (_e2418 * _e2568)), (_e2398 - (_e2419 * _e2568)));
                                                        local[1u] = array<f64, 3>((_e2396 - (_e2438 * _e2595)), (_e2397 - (_e2439 * _e2595)), (_e2398 - (_e2440 * _e2595)));
                                                        local[2u] = array<f64, 3>(_e2545, _e2546, _e2547);
                                                        local[3u] = array<f64, 3>(_e2545, _e2546, _e2547);
                                                        let _e2611 = local[0u];
                                                        phi_6851_ = type_19(1u, 4u);
                                                        phi_6854_ = array<f64, 3>(_e2611[0], _e2611[1], _e2611[2]);
                                                        loop {
                                                            let _e2617 = phi_6851_;
                                                            let _e2619 = phi_6854_;
                                                            local_57 = _e2619;
                                                            if (_e2617.member < _e2617.member_1) {
                                                                phi_6852_ = type_19((_e2617.member + 1u), _e2617.member_1);
                                                                phi_6877_ = type_19(1u, _e2617.member);
                                                            } else {
                                                                phi_6852_ = _e2617;
                                                                phi_6877_ = type_19(0u, type_19().member_1);
                                                            }
                                                            let _e2631 = phi_6852_;
                                                            let _e2633 = phi_6877_;
                                                            let _e2637 = (bitcast<i32>(_e2633.member) != 0i);
                                                            if _e2637 {
                                                                let _e2639 = local[_e2633.member_1];
                                                                let _e2644 = local[_e2633.member_1];
                                                                if ((((_e2639[0] * _e2644[0]) + (_e2639[1] * _e2644[1])) + (_e2639[2] * _e2644[2])) < (((_e2619[0] * _e2619[0]) + (_e2619[1] * _e2619[1])) + (_e2619[2] * _e2619[2]))) {
                                                                    let _e2666 = local[_e2633.member_1];
                                                                    phi_6944_ = array<f64, 3>(_e2666[0], _e2666[1], _e2666[2]);
                                                                } else {
                                                                    phi_6944_ = _e2619;
                                                                }
                                                                let _e2672 = phi_6944_;
                                                                phi_6855_ = _e2672;
                                                            } else {
                                                                phi_6855_ = array<f64, 3>();
                                                            }
                                                            let _e2674 = phi_6855_;
                                                            continue;
                                                            continuing {
                                                                phi_6851_ = _e2631;
                                                                phi_6854_ = _e2674;
                                                                break if !(_e2637);
                                                            }
                                                        }
                                                        let _e5217 = local_57;
                                                        phi_6945_ = _e5217;
                                                    } else {
                                                        phi_6945_ = _e2512;
                                                    }
                                                    let _e2677 = phi_6945_;
                                                    if (_e2677[0] < 0.0lf) {
                                                        phi_6952_ = -(_e2677[0]);
                                                    } else {
                                                        phi_6952_ = _e2677[0];
                                                    }
                                                    let _e2682 = phi_6952_;
                                                    if (_e2677[1] < 0.0lf) {
                                                        phi_6959_ = -(_e2677[1]);
                                                    } else {
                                                        phi_6959_ = _e2677[1];
                                                    }
                                                    let _e2687 = phi_6959_;
                                                    if (_e2677[2] < 0.0lf) {
                                                        phi_6967_ = -(_e2677[2]);
                                                    } else {
                                                        phi_6967_ = _e2677[2];
                                                    }
                                                    let _e2693 = phi_6967_;
                                                    let _e2694 = ((_e2682 + _e2687) + _e2693);
                                                    if (_e2694 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2694) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2700 = (f64(1f) / _e2694);
                                                            let _e2702 = (_e2677[0] * _e2700);
                                                            let _e2704 = (_e2677[1] * _e2700);
                                                            let _e2706 = (_e2677[2] * _e2700);
                                                            let _e2711 = (((_e2702 * _e2702) + (_e2704 * _e2704)) + (_e2706 * _e2706));
                                                            if (_e2711 <= 2.2250738585072014e-308lf) {
                                                                if (_e2711 > 0.0lf) {
                                                                    phi_7005_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_7005_ = 0.0lf;
                                                                }
                                                                let _e2763 = phi_7005_;
                                                                phi_7069_ = _e2763;
                                                            } else {
                                                                phi_7012_ = type_17(0i, 5i);
                                                                phi_7015_ = bitcast<f64>(((bitcast<u64>(_e2711) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2718 = phi_7012_;
                                                                    let _e2720 = phi_7015_;
                                                                    local_26 = _e2720;
                                                                    if (_e2718.member < _e2718.member_1) {
                                                                        let _e2727 = (_e2718.member + 1i);
                                                                        if ((false == (_e2727 > _e2718.member)) != false) {
                                                                            phi_7036_ = true;
                                                                        } else {
                                                                            phi_7036_ = false;
                                                                        }
                                                                        let _e2732 = phi_7036_;
                                                                        if _e2732 {
                                                                            phi_7042_ = type_18(0u, type_18().member_1);
                                                                        } else {
                                                                            phi_7042_ = type_18(1u, _e2727);
                                                                        }
                                                                        let _e2737 = phi_7042_;
                                                                        phi_7013_ = type_17(_e2737.member_1, _e2718.member_1);
                                                                        phi_7056_ = type_18(1u, _e2718.member);
                                                                    } else {
                                                                        phi_7013_ = _e2718;
                                                                        phi_7056_ = type_18(0u, type_18().member_1);
                                                                    }
                                                                    let _e2743 = phi_7013_;
                                                                    let _e2745 = phi_7056_;
                                                                    let _e2748 = (bitcast<i32>(_e2745.member) != 0i);
                                                                    if _e2748 {
                                                                        phi_7016_ = (0.5lf * (_e2720 + (_e2711 / _e2720)));
                                                                    } else {
                                                                        phi_7016_ = f64();
                                                                    }
                                                                    let _e2753 = phi_7016_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7012_ = _e2743;
                                                                        phi_7015_ = _e2753;
                                                                        break if !(_e2748);
                                                                    }
                                                                }
                                                                let _e2758 = local_26;
                                                                phi_7069_ = (_e2758 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2765 = phi_7069_;
                                                            phi_7082_ = type_19(0u, 4u);
                                                            phi_7085_ = f64(2f);
                                                            loop {
                                                                let _e2777 = phi_7082_;
                                                                let _e2779 = phi_7085_;
                                                                local_28 = _e2779;
                                                                local_29 = _e2779;
                                                                local_30 = _e2779;
                                                                local_60 = _e2779;
                                                                local_61 = _e2779;
                                                                if (_e2777.member < _e2777.member_1) {
                                                                    phi_7083_ = type_19((_e2777.member + 1u), _e2777.member_1);
                                                                    phi_7108_ = type_19(1u, _e2777.member);
                                                                } else {
                                                                    phi_7083_ = _e2777;
                                                                    phi_7108_ = type_19(0u, type_19().member_1);
                                                                }
                                                                let _e2791 = phi_7083_;
                                                                let _e2793 = phi_7108_;
                                                                if (bitcast<i32>(_e2793.member) != 0i) {
                                                                    let _e2799 = local_1[_e2793.member_1];
                                                                    let _e2807 = (((_e2702 * _e2799[0]) + (_e2704 * _e2799[1])) + (_e2706 * _e2799[2]));
                                                                    let _e2809 = local_2[_e2793.member_1];
                                                                    let _e2817 = (((_e2702 * _e2809[0]) + (_e2704 * _e2809[1])) + (_e2706 * _e2809[2]));
                                                                    if (_e2807 < 0.0lf) {
                                                                        phi_7159_ = -(_e2807);
                                                                    } else {
                                                                        phi_7159_ = _e2807;
                                                                    }
                                                                    let _e2821 = phi_7159_;
                                                                    if (_e2817 < 0.0lf) {
                                                                        phi_7165_ = -(_e2817);
                                                                    } else {
                                                                        phi_7165_ = _e2817;
                                                                    }
                                                                    let _e2825 = phi_7165_;
                                                                    let _e2830 = (((((((((_e2231 + _e2233) + (_e2285 + _e2287)) + (_e2339 + _e2341)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2349 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2765) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2821 + _e2825) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2807 > _e2830) {
                                                                        if (_e2817 > _e2830) {
                                                                            phi_7179_ = false;
                                                                        } else {
                                                                            phi_7179_ = true;
                                                                        }
                                                                        let _e2834 = phi_7179_;
                                                                        phi_7180_ = _e2834;
                                                                    } else {
                                                                        phi_7180_ = true;
                                                                    }
                                                                    let _e2836 = phi_7180_;
                                                                    if _e2836 {
                                                                        if ((_e2807 + ((_e2817 - _e2807) * _e2360)) > _e2830) {
                                                                            if (_e2817 < _e2807) {
                                                                                let _e2845 = ((_e2807 - _e2817) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                                                if _e2845 {
                                                                                    let _e2853 = (((_e2807 - _e2830) / (_e2807 - _e2817)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    if (_e2779 < _e2853) {
                                                                                        phi_7214_ = _e2779;
                                                                                    } else {
                                                                                        phi_7214_ = _e2853;
                                                                                    }
                                                                                    let _e2856 = phi_7214_;
                                                                                    phi_7215_ = _e2856;
                                                                                } else {
                                                                                    phi_7215_ = f64();
                                                                                }
                                                                                let _e2858 = phi_7215_;
                                                                                phi_7216_ = _e2858;
                                                                                phi_7217_ = _e2845;
                                                                            } else {
                                                                                phi_7216_ = _e2779;
                                                                                phi_7217_ = true;
                                                                            }
                                                                            let _e2860 = phi_7216_;
                                                                            let _e2862 = phi_7217_;
                                                                            if _e2862 {
                                                                                phi_7221_ = false;
                                                                            } else {
                                                                                phi_7221_ = true;
                                                                            }
                                                                            let _e2864 = phi_7221_;
                                                                            phi_7222_ = _e2860;
                                                                            phi_7223_ = _e2862;
                                                                            phi_7224_ = _e2864;
                                                                            phi_7225_ = false;
                                                                        } else {
                                                                            phi_7222_ = f64();
                                                                            phi_7223_ = false;
                                                                            phi_7224_ = false;
                                                                            phi_7225_ = true;
                                                                        }
                                                                        let _e2866 = phi_7222_;
                                                                        let _e2868 = phi_7223_;
                                                                        let _e2870 = phi_7224_;
                                                                        let _e2872 = phi_7225_;
                                                                        phi_7226_ = _e2866;
                                                                        phi_7227_ = _e2868;
                                                                        phi_7228_ = _e2870;
                                                                        phi_7229_ = _e2872;
                                                                    } else {
                                                                        phi_7226_ = _e2779;
                                                                        phi_7227_ = true;
                                                                        phi_7228_ = false;
                                                                        phi_7229_ = false;
                                                                    }
                                                                    let _e2874 = phi_7226_;
                                                                    let _e2876 = phi_7227_;
                                                                    let _e2878 = phi_7228_;
                                                                    let _e2880 = phi_7229_;
                                                                    phi_7086_ = _e2874;
                                                                    phi_7230_ = _e2876;
                                                                    phi_7231_ = false;
                                                                    phi_7232_ = _e2878;
                                                                    phi_7233_ = _e2880;
                                                                } else {
                                                                    phi_7086_ = f64();
                                                                    phi_7230_ = false;
                                                                    phi_7231_ = true;
                                                                    phi_7232_ = false;
                                                                    phi_7233_ = false;
                                                                }
                                                                let _e2882 = phi_7086_;
                                                                let _e2884 = phi_7230_;
                                                                let _e2886 = phi_7231_;
                                                                let _e2888 = phi_7232_;
                                                                let _e2890 = phi_7233_;
                                                                local_27 = _e2886;
                                                                local_58 = _e2888;
                                                                local_59 = _e2890;
                                                                continue;
                                                                continuing {
                                                                    phi_7082_ = _e2791;
                                                                    phi_7085_ = _e2882;
                                                                    break if !(_e2884);
                                                                }
                                                            }
                                                            let _e2893 = local_27;
                                                            if _e2893 {
                                                                let _e2895 = local_28;
                                                                let _e2896 = (_e2895 > _e1384.member_1);
                                                                if _e2896 {
                                                                    phi_7255_ = false;
                                                                    phi_7256_ = false;
                                                                    phi_7257_ = false;
                                                                } else {
                                                                    let _e2898 = local_29;
                                                                    if (_e2898 > _e2360) {
                                                                        let _e2901 = local_30;
                                                                        let _e2904 = ((_e2901 - _e2360) < f64(0.00000000023283064f));
                                                                        if _e2904 {
                                                                            phi_7251_ = false;
                                                                        } else {
                                                                            phi_7251_ = true;
                                                                        }
                                                                        let _e2906 = phi_7251_;
                                                                        phi_7252_ = _e2906;
                                                                        phi_7253_ = _e2904;
                                                                        phi_7254_ = false;
                                                                    } else {
                                                                        phi_7252_ = false;
                                                                        phi_7253_ = false;
                                                                        phi_7254_ = true;
                                                                    }
                                                                    let _e2908 = phi_7252_;
                                                                    let _e2910 = phi_7253_;
                                                                    let _e2912 = phi_7254_;
                                                                    phi_7255_ = _e2908;
                                                                    phi_7256_ = _e2910;
                                                                    phi_7257_ = _e2912;
                                                                }
                                                                let _e2914 = phi_7255_;
                                                                let _e2916 = phi_7256_;
                                                                let _e2918 = phi_7257_;
                                                                phi_7258_ = _e2914;
                                                                phi_7259_ = _e2896;
                                                                phi_7260_ = _e2916;
                                                                phi_7261_ = _e2918;
                                                                phi_7262_ = false;
                                                                phi_7263_ = false;
                                                            } else {
                                                                phi_7258_ = false;
                                                                phi_7259_ = false;
                                                                phi_7260_ = false;
                                                                phi_7261_ = false;
                                                                let _e5274 = local_58;
                                                                phi_7262_ = _e5274;
                                                                let _e5277 = local_59;
                                                                phi_7263_ = _e5277;
                                                            }
                                                            let _e2920 = phi_7258_;
                                                            let _e2922 = phi_7259_;
                                                            let _e2924 = phi_7260_;
                                                            let _e2926 = phi_7261_;
                                                            let _e2928 = phi_7262_;
                                                            let _e2930 = phi_7263_;
                                                            let _e5280 = local_60;
                                                            phi_7264_ = _e5280;
                                                            let _e5283 = local_61;
                                                            phi_7265_ = _e5283;
                                                            phi_7266_ = _e2920;
                                                            phi_7267_ = _e2922;
                                                            phi_7268_ = _e2924;
                                                            phi_7269_ = _e2926;
                                                            phi_7270_ = _e2928;
                                                            phi_7271_ = _e2930;
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
                                                        let _e2932 = phi_7264_;
                                                        let _e2934 = phi_7265_;
                                                        let _e2936 = phi_7266_;
                                                        let _e2938 = phi_7267_;
                                                        let _e2940 = phi_7268_;
                                                        let _e2942 = phi_7269_;
                                                        let _e2944 = phi_7270_;
                                                        let _e2946 = phi_7271_;
                                                        let _e2948 = phi_7272_;
                                                        phi_7273_ = _e2932;
                                                        phi_7274_ = _e2934;
                                                        phi_7275_ = _e2936;
                                                        phi_7276_ = _e2938;
                                                        phi_7277_ = _e2940;
                                                        phi_7278_ = _e2942;
                                                        phi_7279_ = _e2944;
                                                        phi_7280_ = _e2946;
                                                        phi_7281_ = _e2948;
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
                                                    let _e2950 = phi_7273_;
                                                    let _e2952 = phi_7274_;
                                                    let _e2954 = phi_7275_;
                                                    let _e2956 = phi_7276_;
                                                    let _e2958 = phi_7277_;
                                                    let _e2960 = phi_7278_;
                                                    let _e2962 = phi_7279_;
                                                    let _e2964 = phi_7280_;
                                                    let _e2966 = phi_7281_;
                                                    let _e2968 = phi_7282_;
                                                    phi_7283_ = _e2950;
                                                    phi_6332_ = _e2952;
                                                    phi_7284_ = _e2954;
                                                    phi_7285_ = _e2956;
                                                    phi_7286_ = _e2958;
                                                    phi_7287_ = false;
                                                    phi_7288_ = _e2960;
                                                    phi_7289_ = _e2962;
                                                    phi_7290_ = _e2964;
                                                    phi_7291_ = _e2966;
                                                    phi_7292_ = _e2968;
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
                                                let _e2970 = phi_7283_;
                                                let _e2972 = phi_6332_;
                                                let _e2974 = phi_7284_;
                                                let _e2976 = phi_7285_;
                                                let _e2978 = phi_7286_;
                                                let _e2980 = phi_7287_;
                                                let _e2982 = phi_7288_;
                                                let _e2984 = phi_7289_;
                                                let _e2986 = phi_7290_;
                                                let _e2988 = phi_7291_;
                                                let _e2990 = phi_7292_;
                                                local_31 = _e2976;
                                                local_62 = _e2978;
                                                local_63 = _e2980;
                                                local_64 = _e2982;
                                                local_65 = _e2984;
                                                local_66 = _e2986;
                                                local_67 = _e2988;
                                                local_68 = _e2990;
                                                local_69 = _e2970;
                                                local_71 = _e2976;
                                                continue;
                                                continuing {
                                                    phi_6328_ = _e2372;
                                                    phi_6331_ = _e2972;
                                                    break if !(_e2974);
                                                }
                                            }
                                            let _e2993 = local_31;
                                            if _e2993 {
                                                phi_7297_ = type_40(0u, type_40().member_1);
                                                phi_7298_ = false;
                                                phi_7299_ = false;
                                                phi_7300_ = false;
                                                phi_7301_ = false;
                                                phi_7302_ = false;
                                                phi_7303_ = false;
                                                phi_7304_ = false;
                                            } else {
                                                phi_7297_ = type_40();
                                                let _e5316 = local_62;
                                                phi_7298_ = _e5316;
                                                let _e5319 = local_63;
                                                phi_7299_ = _e5319;
                                                let _e5322 = local_64;
                                                phi_7300_ = _e5322;
                                                let _e5325 = local_65;
                                                phi_7301_ = _e5325;
                                                let _e5328 = local_66;
                                                phi_7302_ = _e5328;
                                                let _e5331 = local_67;
                                                phi_7303_ = _e5331;
                                                let _e5334 = local_68;
                                                phi_7304_ = _e5334;
                                            }
                                            let _e2997 = phi_7297_;
                                            let _e2999 = phi_7298_;
                                            let _e3001 = phi_7299_;
                                            let _e3003 = phi_7300_;
                                            let _e3005 = phi_7301_;
                                            let _e3007 = phi_7302_;
                                            let _e3009 = phi_7303_;
                                            let _e3011 = phi_7304_;
                                            if _e2999 {
                                                let _e5337 = local_69;
                                                phi_7308_ = _e5337;
                                                phi_7309_ = true;
                                                phi_7310_ = false;
                                                phi_7311_ = false;
                                                phi_7312_ = false;
                                                phi_7313_ = false;
                                                phi_7314_ = false;
                                                phi_7315_ = false;
                                            } else {
                                                let _e5339 = local_70;
                                                phi_7308_ = _e5339;
                                                phi_7309_ = _e3001;
                                                phi_7310_ = _e3003;
                                                phi_7311_ = _e3005;
                                                phi_7312_ = _e3007;
                                                let _e5346 = local_71;
                                                phi_7313_ = _e5346;
                                                phi_7314_ = _e3009;
                                                phi_7315_ = _e3011;
                                            }
                                            let _e3013 = phi_7308_;
                                            let _e3015 = phi_7309_;
                                            let _e3017 = phi_7310_;
                                            let _e3019 = phi_7311_;
                                            let _e3021 = phi_7312_;
                                            let _e3023 = phi_7313_;
                                            let _e3025 = phi_7314_;
                                            let _e3027 = phi_7315_;
                                            if _e3015 {
                                                phi_7320_ = type_40(1u, _e3013);
                                                phi_7321_ = false;
                                                phi_7322_ = false;
                                                phi_7323_ = false;
                                                phi_7324_ = false;
                                                phi_7325_ = false;
                                                phi_7326_ = false;
                                            } else {
                                                phi_7320_ = type_40();
                                                phi_7321_ = _e3017;
                                                phi_7322_ = _e3019;
                                                phi_7323_ = _e3021;
                                                phi_7324_ = _e3023;
                                                phi_7325_ = _e3025;
                                                phi_7326_ = _e3027;
                                            }
                                            let _e3030 = phi_7320_;
                                            let _e3032 = phi_7321_;
                                            let _e3034 = phi_7322_;
                                            let _e3036 = phi_7323_;
                                            let _e3038 = phi_7324_;
                                            let _e3040 = phi_7325_;
                                            let _e3042 = phi_7326_;
                                            if _e3032 {
                                                let _e3044 = local_32;
                                                phi_7331_ = type_40(1u, _e3044);
                                                phi_7332_ = false;
                                                phi_7333_ = false;
                                                phi_7334_ = true;
                                                phi_7335_ = false;
                                                phi_7336_ = false;
                                            } else {
                                                phi_7331_ = _e2997;
                                                phi_7332_ = _e3034;
                                                phi_7333_ = _e3036;
                                                phi_7334_ = _e3038;
                                                phi_7335_ = _e3040;
                                                phi_7336_ = _e3042;
                                            }
                                            let _e3047 = phi_7331_;
                                            let _e3049 = phi_7332_;
                                            let _e3051 = phi_7333_;
                                            let _e3053 = phi_7334_;
                                            let _e3055 = phi_7335_;
                                            let _e3057 = phi_7336_;
                                            if _e3049 {
                                                let _e3059 = local_33;
                                                phi_7341_ = type_40(1u, _e3059);
                                                phi_7342_ = false;
                                                phi_7343_ = false;
                                                phi_7344_ = false;
                                                phi_7345_ = false;
                                            } else {
                                                phi_7341_ = type_40();
                                                phi_7342_ = _e3051;
                                                phi_7343_ = _e3053;
                                                phi_7344_ = _e3055;
                                                phi_7345_ = _e3057;
                                            }
                                            let _e3062 = phi_7341_;
                                            let _e3064 = phi_7342_;
                                            let _e3066 = phi_7343_;
                                            let _e3068 = phi_7344_;
                                            let _e3070 = phi_7345_;
                                            if _e3064 {
                                                let _e3072 = local_34;
                                                phi_7350_ = type_40(1u, _e3072);
                                                phi_7351_ = true;
                                                phi_7352_ = false;
                                                phi_7353_ = false;
                                                phi_7354_ = false;
                                            } else {
                                                phi_7350_ = _e3062;
                                                phi_7351_ = _e3049;
                                                phi_7352_ = _e3066;
                                                phi_7353_ = _e3068;
                                                phi_7354_ = _e3070;
                                            }
                                            let _e3075 = phi_7350_;
                                            let _e3077 = phi_7351_;
                                            let _e3079 = phi_7352_;
                                            let _e3081 = phi_7353_;
                                            let _e3083 = phi_7354_;
                                            if _e3077 {
                                                phi_7358_ = _e3075;
                                                phi_7359_ = true;
                                                phi_7360_ = false;
                                                phi_7361_ = false;
                                            } else {
                                                phi_7358_ = _e3047;
                                                phi_7359_ = _e3079;
                                                phi_7360_ = _e3081;
                                                phi_7361_ = _e3083;
                                            }
                                            let _e3085 = phi_7358_;
                                            let _e3087 = phi_7359_;
                                            let _e3089 = phi_7360_;
                                            let _e3091 = phi_7361_;
                                            if _e3087 {
                                                phi_7365_ = false;
                                                phi_7366_ = false;
                                            } else {
                                                phi_7365_ = _e3089;
                                                phi_7366_ = _e3091;
                                            }
                                            let _e3093 = phi_7365_;
                                            let _e3095 = phi_7366_;
                                            if _e3093 {
                                                phi_7370_ = false;
                                                phi_7371_ = false;
                                            } else {
                                                phi_7370_ = _e3095;
                                                phi_7371_ = _e3087;
                                            }
                                            let _e3097 = phi_7370_;
                                            let _e3099 = phi_7371_;
                                            if _e3097 {
                                                phi_7375_ = true;
                                                phi_7376_ = false;
                                            } else {
                                                phi_7375_ = _e3093;
                                                phi_7376_ = _e3099;
                                            }
                                            let _e3101 = phi_7375_;
                                            let _e3103 = phi_7376_;
                                            if _e3101 {
                                                let _e3105 = local_35;
                                                phi_7381_ = type_40(1u, _e3105);
                                                phi_7382_ = true;
                                            } else {
                                                phi_7381_ = _e3085;
                                                phi_7382_ = _e3103;
                                            }
                                            let _e3108 = phi_7381_;
                                            let _e3110 = phi_7382_;
                                            if _e3110 {
                                                phi_7386_ = _e3108;
                                            } else {
                                                phi_7386_ = _e3030;
                                            }
                                            let _e3112 = phi_7386_;
                                            let _e3115 = (_e3112.member != 0u);
                                            if _e3115 {
                                                phi_7393_ = false;
                                            } else {
                                                phi_7393_ = true;
                                            }
                                            let _e3117 = phi_7393_;
                                            phi_7394_ = _e3112.member_1;
                                            phi_7395_ = _e3117;
                                            phi_7396_ = _e3115;
                                            phi_7397_ = false;
                                        } else {
                                            phi_7394_ = f64();
                                            phi_7395_ = false;
                                            phi_7396_ = false;
                                            phi_7397_ = true;
                                        }
                                        let _e3119 = phi_7394_;
                                        let _e3121 = phi_7395_;
                                        let _e3123 = phi_7396_;
                                        let _e3125 = phi_7397_;
                                        phi_7398_ = _e3119;
                                        phi_7399_ = _e3121;
                                        phi_7400_ = _e3123;
                                        phi_7401_ = _e3125;
                                    }
                                    let _e3127 = phi_7398_;
                                    let _e3129 = phi_7399_;
                                    let _e3131 = phi_7400_;
                                    let _e3133 = phi_7401_;
                                    phi_7402_ = _e3127;
                                    phi_7403_ = _e2110;
                                    phi_7404_ = _e3129;
                                    phi_7405_ = _e3131;
                                    phi_7406_ = _e3133;
                                }
                                let _e3135 = phi_7402_;
                                let _e3137 = phi_7403_;
                                let _e3139 = phi_7404_;
                                let _e3141 = phi_7405_;
                                let _e3143 = phi_7406_;
                                if _e3137 {
                                    phi_7410_ = true;
                                    phi_7411_ = false;
                                    phi_7412_ = false;
                                } else {
                                    phi_7410_ = _e3139;
                                    phi_7411_ = _e3141;
                                    phi_7412_ = _e3143;
                                }
                                let _e3145 = phi_7410_;
                                let _e3147 = phi_7411_;
                                let _e3149 = phi_7412_;
                                phi_7413_ = _e3135;
                                phi_7414_ = _e1384;
                                phi_7415_ = _e3145;
                                phi_7416_ = false;
                                phi_7417_ = _e3147;
                                phi_7418_ = _e3149;
                            } else {
                                phi_7413_ = f64();
                                phi_7414_ = type_41();
                                phi_7415_ = false;
                                phi_7416_ = true;
                                phi_7417_ = false;
                                phi_7418_ = false;
                            }
                            let _e3151 = phi_7413_;
                            let _e3153 = phi_7414_;
                            let _e3155 = phi_7415_;
                            let _e3157 = phi_7416_;
                            let _e3159 = phi_7417_;
                            let _e3161 = phi_7418_;
                            local_36 = _e3157;
                            local_72 = _e3159;
                            local_73 = _e3161;
                            local_37 = _e3151;
                            local_38 = _e3153;
                            continue;
                            continuing {
                                phi_4367_ = _e1071;
                                break if !(_e3155);
                            }
                        }
                        let _e3164 = local_36;
                        if _e3164 {
                            phi_7423_ = type_40(0u, type_40().member_1);
                            phi_7424_ = false;
                            phi_7425_ = false;
                        } else {
                            phi_7423_ = type_40();
                            let _e5416 = local_72;
                            phi_7424_ = _e5416;
                            let _e5419 = local_73;
                            phi_7425_ = _e5419;
                        }
                        let _e3168 = phi_7423_;
                        let _e3170 = phi_7424_;
                        let _e3172 = phi_7425_;
                        if _e3170 {
                            let _e3174 = local_37;
                            phi_7430_ = type_40(2u, _e3174);
                            phi_7431_ = false;
                        } else {
                            phi_7430_ = type_40();
                            phi_7431_ = _e3172;
                        }
                        let _e3177 = phi_7430_;
                        let _e3179 = phi_7431_;
                        if _e3179 {
                            let _e3181 = local_38;
                            phi_7437_ = type_40(1u, _e3181.member);
                            phi_7438_ = true;
                        } else {
                            phi_7437_ = _e3177;
                            phi_7438_ = _e3170;
                        }
                        let _e3185 = phi_7437_;
                        let _e3187 = phi_7438_;
                        if _e3187 {
                            phi_7442_ = _e3185;
                        } else {
                            phi_7442_ = _e3168;
                        }
                        let _e3189 = phi_7442_;
                        phi_7446_ = _e3189;
                    }
                    let _e4792 = phi_7446_;
                    phi_7447_ = _e4792;
                }
                let _e4796 = phi_7447_;
                switch bitcast<i32>(_e4796.member) {
                    case 0: {
                        phi_7460_ = type_31(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4802 = function_(_e4796.member_1);
                        phi_7460_ = type_31(0u, _e4802, true);
                        break;
                    }
                    case 2: {
                        let _e4800 = function_(_e4796.member_1);
                        phi_7460_ = type_31(1u, _e4800, true);
                        break;
                    }
                    default: {
                        phi_7460_ = type_31();
                        break;
                    }
                }
                let _e4805 = phi_7460_;
                if _e4805.member_2 {
                    let _e4812 = (_e4805.member_1[1] >> bitcast<u32>(20i));
                    if (_e4812 <= 896u) {
                        phi_7483_ = 0u;
                    } else {
                        phi_7483_ = ((((_e4812 - 896u) << bitcast<u32>(23i)) | ((_e4805.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4805.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4827 = phi_7483_;
                    let _e4829 = atomicMin((&earliest.member[0u]), _e4827);
                }
                phi_7487_ = type_30(_e179, _e4805.member, _e185, _e188, _e4805.member_1);
                phi_7488_ = _e4805.member_2;
            } else {
                phi_7487_ = type_30(_e179, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_7488_ = false;
            }
            let _e4831 = phi_7487_;
            let _e4833 = phi_7488_;
            let _e4835 = params.member.member_1;
            if ((_e4835 & 16u) != 0u) {
                if (_e112 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4833 {
                    let _e4841 = atomicAdd((&counters[0u]), 1u);
                    phi_7506_ = _e4841;
                } else {
                    phi_7506_ = 0u;
                }
                let _e4843 = phi_7506_;
                workgroupBarrier();
                if (_e112 == 0u) {
                    let _e4846 = atomicLoad((&counters[0u]));
                    if (_e4846 > 0u) {
                        let _e4849 = atomicAdd((&contacts.member[0u]), _e4846);
                        atomicStore((&counters[1u]), _e4849);
                    }
                }
                workgroupBarrier();
                let _e4852 = atomicLoad((&counters[1u]));
                let _e4853 = (_e4852 + _e4843);
                if _e4833 {
                    let _e4855 = params.member.member_16;
                    if (_e4853 < _e4855) {
                        let _e4857 = (6u * _e4853);
                        atomicStore((&contacts.member[(4u + _e4857)]), _e4831.member);
                        atomicStore((&contacts.member[(_e4857 + 5u)]), _e4831.member_1);
                        atomicStore((&contacts.member[(_e4857 + 6u)]), _e4831.member_2);
                        atomicStore((&contacts.member[(_e4857 + 7u)]), _e4831.member_3);
                        atomicStore((&contacts.member[(_e4857 + 8u)]), _e4831.member_4[0]);
                        atomicStore((&contacts.member[(_e4857 + 9u)]), _e4831.member_4[1]);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_281_ = _e167;
            break if !(_e173);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_1(id, n, lane);
}
