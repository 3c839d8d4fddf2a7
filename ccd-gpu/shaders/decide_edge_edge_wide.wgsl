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
    member: array<array<u32, 2>>,
}

struct type_26 {
    member: i32,
    member_1: i32,
}

struct type_27 {
    member: u32,
    member_1: i32,
}

struct type_28 {
    member: u32,
    member_1: u32,
}

struct type_35 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_38 {
    member: array<type_35>,
}

struct type_45 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
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
var<storage> paths: type_38;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_77;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> wide: type_66;
@group(0) @binding(3) 
var<storage> elements: type_20;
@group(0) @binding(4) 
var<storage> input: type_16;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_77;

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
    var phi_230_: u32;
    var phi_246_: u32;
    var phi_267_: u32;
    var phi_268_: u32;
    var phi_271_: type_28;
    var phi_272_: type_28;
    var phi_295_: type_28;
    var phi_638_: type_28;
    var phi_639_: type_28;
    var phi_662_: type_28;
    var phi_518_: type_28;
    var phi_519_: type_28;
    var phi_542_: type_28;
    var phi_552_: type_28;
    var phi_553_: type_28;
    var phi_576_: type_28;
    var phi_1119_: f64;
    var phi_1126_: f64;
    var phi_1131_: f64;
    var phi_1138_: f64;
    var phi_1143_: f64;
    var phi_1156_: f64;
    var phi_1163_: f64;
    var phi_1168_: f64;
    var phi_1175_: f64;
    var phi_1180_: f64;
    var phi_1185_: f64;
    var phi_1202_: f64;
    var phi_1209_: f64;
    var phi_1214_: f64;
    var phi_1221_: f64;
    var phi_1226_: f64;
    var phi_1240_: f64;
    var phi_1247_: f64;
    var phi_1252_: f64;
    var phi_1259_: f64;
    var phi_1264_: f64;
    var phi_1269_: f64;
    var phi_1286_: f64;
    var phi_1293_: f64;
    var phi_1298_: f64;
    var phi_1305_: f64;
    var phi_1310_: f64;
    var phi_1324_: f64;
    var phi_1331_: f64;
    var phi_1336_: f64;
    var phi_1343_: f64;
    var phi_1348_: f64;
    var phi_1353_: f64;
    var phi_1390_: f64;
    var phi_1396_: f64;
    var phi_1403_: f64;
    var phi_1410_: f64;
    var phi_1416_: f64;
    var phi_1423_: f64;
    var phi_1429_: f64;
    var phi_1435_: f64;
    var phi_1441_: f64;
    var phi_1448_: f64;
    var phi_1455_: f64;
    var phi_1483_: f64;
    var phi_1488_: f64;
    var phi_1493_: f64;
    var phi_1498_: f64;
    var phi_1503_: f64;
    var phi_1508_: f64;
    var phi_1519_: f64;
    var phi_4076_: f64;
    var phi_4082_: f64;
    var phi_4087_: f64;
    var phi_4093_: f64;
    var phi_4099_: f64;
    var phi_4104_: f64;
    var phi_4109_: f64;
    var phi_4119_: bool;
    var phi_4126_: f64;
    var phi_4134_: f64;
    var phi_4177_: type_26;
    var phi_4180_: f64;
    var phi_4201_: bool;
    var phi_4207_: type_27;
    var phi_4178_: type_26;
    var phi_4221_: type_27;
    var phi_4181_: f64;
    var local_21: f64;
    var phi_4170_: f64;
    var phi_4234_: f64;
    var phi_4240_: f64;
    var phi_4265_: type_28;
    var phi_4268_: u32;
    var phi_4266_: type_28;
    var phi_4291_: type_28;
    var phi_4335_: u32;
    var phi_4336_: u32;
    var phi_4269_: u32;
    var phi_4337_: u32;
    var phi_4357_: type_28;
    var phi_4358_: type_28;
    var phi_4381_: type_28;
    var phi_4435_: f64;
    var phi_4442_: f64;
    var phi_4454_: bool;
    var phi_4455_: bool;
    var phi_4456_: bool;
    var phi_4457_: bool;
    var phi_4461_: bool;
    var phi_4473_: type_73;
    var phi_4474_: type_73;
    var phi_4475_: bool;
    var phi_4476_: type_73;
    var phi_4477_: bool;
    var phi_4490_: f64;
    var phi_4503_: type_28;
    var phi_4506_: f64;
    var phi_4508_: f64;
    var phi_4510_: f64;
    var phi_4504_: type_28;
    var phi_4533_: type_28;
    var phi_4560_: f64;
    var phi_4561_: f64;
    var phi_4589_: f64;
    var phi_4605_: f64;
    var phi_4612_: bool;
    var phi_4613_: bool;
    var phi_4614_: bool;
    var phi_4620_: f64;
    var phi_4621_: f64;
    var phi_4622_: bool;
    var phi_4507_: f64;
    var phi_4509_: f64;
    var phi_4511_: f64;
    var phi_4623_: f64;
    var phi_4624_: bool;
    var phi_4625_: bool;
    var local_22: bool;
    var phi_4629_: f64;
    var phi_4630_: f64;
    var phi_4638_: type_28;
    var phi_4641_: f64;
    var phi_4639_: type_28;
    var phi_4664_: type_28;
    var phi_4707_: f64;
    var phi_4717_: f64;
    var phi_4727_: bool;
    var phi_4729_: bool;
    var phi_4734_: f64;
    var phi_4735_: bool;
    var phi_4736_: f64;
    var phi_4737_: bool;
    var phi_4738_: bool;
    var phi_4739_: bool;
    var phi_4740_: f64;
    var phi_4642_: f64;
    var phi_4741_: bool;
    var phi_4742_: bool;
    var phi_4743_: bool;
    var phi_4744_: bool;
    var local_23: bool;
    var phi_4748_: bool;
    var phi_4749_: bool;
    var phi_4753_: bool;
    var phi_4757_: f64;
    var phi_4758_: f64;
    var phi_4760_: type_73;
    var phi_4791_: f64;
    var phi_4798_: f64;
    var phi_4803_: f64;
    var phi_4810_: f64;
    var phi_4815_: f64;
    var phi_4828_: f64;
    var phi_4835_: f64;
    var phi_4840_: f64;
    var phi_4847_: f64;
    var phi_4852_: f64;
    var phi_4857_: f64;
    var phi_4916_: f64;
    var phi_4922_: f64;
    var phi_4927_: f64;
    var phi_4933_: f64;
    var phi_4938_: f64;
    var phi_4952_: f64;
    var phi_4958_: f64;
    var phi_4963_: f64;
    var phi_4969_: f64;
    var phi_4974_: f64;
    var phi_5000_: f64;
    var phi_5007_: f64;
    var phi_5012_: f64;
    var phi_5019_: f64;
    var phi_5024_: f64;
    var phi_5037_: f64;
    var phi_5044_: f64;
    var phi_5049_: f64;
    var phi_5056_: f64;
    var phi_5061_: f64;
    var phi_5066_: f64;
    var phi_5125_: f64;
    var phi_5131_: f64;
    var phi_5136_: f64;
    var phi_5142_: f64;
    var phi_5147_: f64;
    var phi_5161_: f64;
    var phi_5167_: f64;
    var phi_5172_: f64;
    var phi_5178_: f64;
    var phi_5183_: f64;
    var phi_5209_: f64;
    var phi_5216_: f64;
    var phi_5221_: f64;
    var phi_5228_: f64;
    var phi_5233_: f64;
    var phi_5246_: f64;
    var phi_5253_: f64;
    var phi_5258_: f64;
    var phi_5265_: f64;
    var phi_5270_: f64;
    var phi_5275_: f64;
    var phi_5334_: f64;
    var phi_5340_: f64;
    var phi_5345_: f64;
    var phi_5351_: f64;
    var phi_5356_: f64;
    var phi_5370_: f64;
    var phi_5376_: f64;
    var phi_5381_: f64;
    var phi_5387_: f64;
    var phi_5392_: f64;
    var phi_5441_: f64;
    var phi_5447_: f64;
    var phi_5475_: f64;
    var phi_5481_: f64;
    var phi_5486_: u32;
    var phi_5487_: u32;
    var phi_5457_: f64;
    var phi_5463_: f64;
    var phi_5468_: u32;
    var phi_5469_: u32;
    var phi_5488_: u32;
    var phi_5489_: u32;
    var phi_5560_: f64;
    var phi_5572_: f64;
    var phi_5711_: f64;
    var phi_5717_: f64;
    var phi_5724_: f64;
    var phi_5768_: type_28;
    var phi_5771_: bool;
    var phi_5769_: type_28;
    var phi_5794_: type_28;
    var phi_5821_: bool;
    var phi_5822_: bool;
    var phi_5772_: bool;
    var phi_5823_: bool;
    var phi_5824_: bool;
    var local_24: bool;
    var phi_5828_: bool;
    var local_25: bool;
    var phi_5835_: u32;
    var phi_5836_: u32;
    var phi_5837_: bool;
    var phi_5838_: u32;
    var phi_5839_: u32;
    var phi_5840_: bool;
    var phi_5844_: u32;
    var phi_5865_: bool;
    var phi_5866_: bool;
    var phi_5867_: bool;
    var phi_6064_: f64;
    var phi_6071_: f64;
    var phi_6076_: f64;
    var phi_6083_: f64;
    var phi_6088_: f64;
    var phi_6101_: f64;
    var phi_6108_: f64;
    var phi_6113_: f64;
    var phi_6120_: f64;
    var phi_6125_: f64;
    var phi_6130_: f64;
    var phi_6147_: f64;
    var phi_6154_: f64;
    var phi_6159_: f64;
    var phi_6166_: f64;
    var phi_6171_: f64;
    var phi_6185_: f64;
    var phi_6192_: f64;
    var phi_6197_: f64;
    var phi_6204_: f64;
    var phi_6209_: f64;
    var phi_6214_: f64;
    var phi_6231_: f64;
    var phi_6238_: f64;
    var phi_6243_: f64;
    var phi_6250_: f64;
    var phi_6255_: f64;
    var phi_6269_: f64;
    var phi_6276_: f64;
    var phi_6281_: f64;
    var phi_6288_: f64;
    var phi_6293_: f64;
    var phi_6298_: f64;
    var phi_6318_: type_28;
    var phi_6321_: f64;
    var phi_6319_: type_28;
    var phi_6344_: type_28;
    var phi_6500_: bool;
    var phi_6501_: bool;
    var phi_6502_: bool;
    var phi_6503_: bool;
    var phi_6504_: bool;
    var phi_6505_: bool;
    var phi_6509_: bool;
    var phi_6549_: array<f64, 3>;
    var phi_6550_: bool;
    var phi_6551_: array<f64, 3>;
    var phi_6552_: bool;
    var phi_6585_: f64;
    var phi_6587_: f64;
    var phi_6617_: f64;
    var phi_6619_: f64;
    var phi_6649_: f64;
    var phi_6651_: f64;
    var phi_6684_: f64;
    var phi_6686_: f64;
    var phi_6841_: type_28;
    var phi_6844_: array<f64, 3>;
    var phi_6842_: type_28;
    var phi_6867_: type_28;
    var phi_6934_: array<f64, 3>;
    var phi_6845_: array<f64, 3>;
    var phi_6935_: array<f64, 3>;
    var phi_6942_: f64;
    var phi_6949_: f64;
    var phi_6957_: f64;
    var phi_7002_: type_26;
    var phi_7005_: f64;
    var phi_7026_: bool;
    var phi_7032_: type_27;
    var phi_7003_: type_26;
    var phi_7046_: type_27;
    var phi_7006_: f64;
    var local_26: f64;
    var phi_6995_: f64;
    var phi_7059_: f64;
    var phi_7072_: type_28;
    var phi_7075_: f64;
    var phi_7073_: type_28;
    var phi_7098_: type_28;
    var phi_7149_: f64;
    var phi_7155_: f64;
    var phi_7169_: bool;
    var phi_7170_: bool;
    var phi_7204_: f64;
    var phi_7205_: f64;
    var phi_7206_: f64;
    var phi_7207_: bool;
    var phi_7211_: bool;
    var phi_7212_: f64;
    var phi_7213_: bool;
    var phi_7214_: bool;
    var phi_7215_: bool;
    var phi_7216_: f64;
    var phi_7217_: bool;
    var phi_7218_: bool;
    var phi_7219_: bool;
    var phi_7076_: f64;
    var phi_7220_: bool;
    var phi_7221_: bool;
    var phi_7222_: bool;
    var phi_7223_: bool;
    var local_27: bool;
    var local_28: f64;
    var local_29: f64;
    var local_30: f64;
    var phi_7241_: bool;
    var phi_7242_: bool;
    var phi_7243_: bool;
    var phi_7244_: bool;
    var phi_7245_: bool;
    var phi_7246_: bool;
    var phi_7247_: bool;
    var phi_7248_: bool;
    var phi_7249_: bool;
    var phi_7250_: bool;
    var phi_7251_: bool;
    var phi_7252_: bool;
    var phi_7253_: bool;
    var phi_7254_: f64;
    var phi_7255_: f64;
    var phi_7256_: bool;
    var phi_7257_: bool;
    var phi_7258_: bool;
    var phi_7259_: bool;
    var phi_7260_: bool;
    var phi_7261_: bool;
    var phi_7262_: bool;
    var phi_7263_: f64;
    var phi_7264_: f64;
    var phi_7265_: bool;
    var phi_7266_: bool;
    var phi_7267_: bool;
    var phi_7268_: bool;
    var phi_7269_: bool;
    var phi_7270_: bool;
    var phi_7271_: bool;
    var phi_7272_: bool;
    var phi_7273_: f64;
    var phi_6322_: f64;
    var phi_7274_: bool;
    var phi_7275_: bool;
    var phi_7276_: bool;
    var phi_7277_: bool;
    var phi_7278_: bool;
    var phi_7279_: bool;
    var phi_7280_: bool;
    var phi_7281_: bool;
    var phi_7282_: bool;
    var local_31: bool;
    var phi_7287_: type_72;
    var phi_7288_: bool;
    var phi_7289_: bool;
    var phi_7290_: bool;
    var phi_7291_: bool;
    var phi_7292_: bool;
    var phi_7293_: bool;
    var phi_7294_: bool;
    var phi_7298_: f64;
    var phi_7299_: bool;
    var phi_7300_: bool;
    var phi_7301_: bool;
    var phi_7302_: bool;
    var phi_7303_: bool;
    var phi_7304_: bool;
    var phi_7305_: bool;
    var phi_7310_: type_72;
    var phi_7311_: bool;
    var phi_7312_: bool;
    var phi_7313_: bool;
    var phi_7314_: bool;
    var phi_7315_: bool;
    var phi_7316_: bool;
    var local_32: f64;
    var phi_7321_: type_72;
    var phi_7322_: bool;
    var phi_7323_: bool;
    var phi_7324_: bool;
    var phi_7325_: bool;
    var phi_7326_: bool;
    var local_33: f64;
    var phi_7331_: type_72;
    var phi_7332_: bool;
    var phi_7333_: bool;
    var phi_7334_: bool;
    var phi_7335_: bool;
    var local_34: f64;
    var phi_7340_: type_72;
    var phi_7341_: bool;
    var phi_7342_: bool;
    var phi_7343_: bool;
    var phi_7344_: bool;
    var phi_7348_: type_72;
    var phi_7349_: bool;
    var phi_7350_: bool;
    var phi_7351_: bool;
    var phi_7355_: bool;
    var phi_7356_: bool;
    var phi_7360_: bool;
    var phi_7361_: bool;
    var phi_7365_: bool;
    var phi_7366_: bool;
    var local_35: f64;
    var phi_7371_: type_72;
    var phi_7372_: bool;
    var phi_7376_: type_72;
    var phi_7383_: bool;
    var phi_7384_: f64;
    var phi_7385_: bool;
    var phi_7386_: bool;
    var phi_7387_: bool;
    var phi_7388_: f64;
    var phi_7389_: bool;
    var phi_7390_: bool;
    var phi_7391_: bool;
    var phi_7392_: f64;
    var phi_7393_: bool;
    var phi_7394_: bool;
    var phi_7395_: bool;
    var phi_7396_: bool;
    var phi_7400_: bool;
    var phi_7401_: bool;
    var phi_7402_: bool;
    var phi_7403_: f64;
    var phi_7404_: type_73;
    var phi_7405_: bool;
    var phi_7406_: bool;
    var phi_7407_: bool;
    var phi_7408_: bool;
    var local_36: bool;
    var phi_7413_: type_72;
    var phi_7414_: bool;
    var phi_7415_: bool;
    var local_37: f64;
    var phi_7420_: type_72;
    var phi_7421_: bool;
    var local_38: type_73;
    var phi_7427_: type_72;
    var phi_7428_: bool;
    var phi_7432_: type_72;
    var phi_1722_: f64;
    var phi_1729_: f64;
    var phi_1734_: f64;
    var phi_1741_: f64;
    var phi_1746_: f64;
    var phi_1759_: f64;
    var phi_1766_: f64;
    var phi_1771_: f64;
    var phi_1778_: f64;
    var phi_1783_: f64;
    var phi_1788_: f64;
    var phi_1805_: f64;
    var phi_1812_: f64;
    var phi_1817_: f64;
    var phi_1824_: f64;
    var phi_1829_: f64;
    var phi_1843_: f64;
    var phi_1850_: f64;
    var phi_1855_: f64;
    var phi_1862_: f64;
    var phi_1867_: f64;
    var phi_1872_: f64;
    var phi_1889_: f64;
    var phi_1896_: f64;
    var phi_1901_: f64;
    var phi_1908_: f64;
    var phi_1913_: f64;
    var phi_1927_: f64;
    var phi_1934_: f64;
    var phi_1939_: f64;
    var phi_1946_: f64;
    var phi_1951_: f64;
    var phi_1956_: f64;
    var phi_1976_: type_28;
    var phi_1979_: f64;
    var phi_1977_: type_28;
    var phi_2002_: type_28;
    var phi_2158_: bool;
    var phi_2159_: bool;
    var phi_2160_: bool;
    var phi_2161_: bool;
    var phi_2162_: bool;
    var phi_2163_: bool;
    var phi_2167_: bool;
    var phi_2207_: array<f64, 3>;
    var phi_2208_: bool;
    var phi_2209_: array<f64, 3>;
    var phi_2210_: bool;
    var phi_2243_: f64;
    var phi_2245_: f64;
    var phi_2275_: f64;
    var phi_2277_: f64;
    var phi_2307_: f64;
    var phi_2309_: f64;
    var phi_2342_: f64;
    var phi_2344_: f64;
    var phi_2499_: type_28;
    var phi_2502_: array<f64, 3>;
    var phi_2500_: type_28;
    var phi_2525_: type_28;
    var phi_2592_: array<f64, 3>;
    var phi_2503_: array<f64, 3>;
    var phi_2593_: array<f64, 3>;
    var phi_2600_: f64;
    var phi_2607_: f64;
    var phi_2615_: f64;
    var phi_2660_: type_26;
    var phi_2663_: f64;
    var phi_2684_: bool;
    var phi_2690_: type_27;
    var phi_2661_: type_26;
    var phi_2704_: type_27;
    var phi_2664_: f64;
    var local_39: f64;
    var phi_2653_: f64;
    var phi_2717_: f64;
    var phi_2730_: type_28;
    var phi_2733_: f64;
    var phi_2731_: type_28;
    var phi_2756_: type_28;
    var phi_2807_: f64;
    var phi_2813_: f64;
    var phi_2827_: bool;
    var phi_2828_: bool;
    var phi_2862_: f64;
    var phi_2863_: f64;
    var phi_2864_: f64;
    var phi_2865_: bool;
    var phi_2869_: bool;
    var phi_2870_: f64;
    var phi_2871_: bool;
    var phi_2872_: bool;
    var phi_2873_: bool;
    var phi_2874_: f64;
    var phi_2875_: bool;
    var phi_2876_: bool;
    var phi_2877_: bool;
    var phi_2734_: f64;
    var phi_2878_: bool;
    var phi_2879_: bool;
    var phi_2880_: bool;
    var phi_2881_: bool;
    var local_40: bool;
    var local_41: f64;
    var local_42: f64;
    var local_43: f64;
    var phi_2899_: bool;
    var phi_2900_: bool;
    var phi_2901_: bool;
    var phi_2902_: bool;
    var phi_2903_: bool;
    var phi_2904_: bool;
    var phi_2905_: bool;
    var phi_2906_: bool;
    var phi_2907_: bool;
    var phi_2908_: bool;
    var phi_2909_: bool;
    var phi_2910_: bool;
    var phi_2911_: bool;
    var phi_2912_: f64;
    var phi_2913_: f64;
    var phi_2914_: bool;
    var phi_2915_: bool;
    var phi_2916_: bool;
    var phi_2917_: bool;
    var phi_2918_: bool;
    var phi_2919_: bool;
    var phi_2920_: bool;
    var phi_2921_: f64;
    var phi_2922_: f64;
    var phi_2923_: bool;
    var phi_2924_: bool;
    var phi_2925_: bool;
    var phi_2926_: bool;
    var phi_2927_: bool;
    var phi_2928_: bool;
    var phi_2929_: bool;
    var phi_2930_: bool;
    var phi_2931_: f64;
    var phi_1980_: f64;
    var phi_2932_: bool;
    var phi_2933_: bool;
    var phi_2934_: bool;
    var phi_2935_: bool;
    var phi_2936_: bool;
    var phi_2937_: bool;
    var phi_2938_: bool;
    var phi_2939_: bool;
    var phi_2940_: bool;
    var local_44: bool;
    var phi_2945_: type_72;
    var phi_2946_: bool;
    var phi_2947_: bool;
    var phi_2948_: bool;
    var phi_2949_: bool;
    var phi_2950_: bool;
    var phi_2951_: bool;
    var phi_2952_: bool;
    var phi_2956_: f64;
    var phi_2957_: bool;
    var phi_2958_: bool;
    var phi_2959_: bool;
    var phi_2960_: bool;
    var phi_2961_: bool;
    var phi_2962_: bool;
    var phi_2963_: bool;
    var phi_2968_: type_72;
    var phi_2969_: bool;
    var phi_2970_: bool;
    var phi_2971_: bool;
    var phi_2972_: bool;
    var phi_2973_: bool;
    var phi_2974_: bool;
    var local_45: f64;
    var phi_2979_: type_72;
    var phi_2980_: bool;
    var phi_2981_: bool;
    var phi_2982_: bool;
    var phi_2983_: bool;
    var phi_2984_: bool;
    var local_46: f64;
    var phi_2989_: type_72;
    var phi_2990_: bool;
    var phi_2991_: bool;
    var phi_2992_: bool;
    var phi_2993_: bool;
    var local_47: f64;
    var phi_2998_: type_72;
    var phi_2999_: bool;
    var phi_3000_: bool;
    var phi_3001_: bool;
    var phi_3002_: bool;
    var phi_3006_: type_72;
    var phi_3007_: bool;
    var phi_3008_: bool;
    var phi_3009_: bool;
    var phi_3013_: bool;
    var phi_3014_: bool;
    var phi_3018_: bool;
    var phi_3019_: bool;
    var phi_3023_: bool;
    var phi_3024_: bool;
    var local_48: f64;
    var phi_3029_: type_72;
    var phi_3030_: bool;
    var phi_3034_: type_72;
    var phi_3048_: type_28;
    var phi_3049_: type_28;
    var phi_3072_: type_28;
    var phi_3093_: f64;
    var phi_3243_: bool;
    var phi_3244_: bool;
    var phi_3245_: bool;
    var phi_3246_: bool;
    var phi_3247_: bool;
    var phi_3248_: bool;
    var phi_3252_: bool;
    var phi_3292_: array<f64, 3>;
    var phi_3293_: bool;
    var phi_3294_: array<f64, 3>;
    var phi_3295_: bool;
    var phi_3328_: f64;
    var phi_3330_: f64;
    var phi_3360_: f64;
    var phi_3362_: f64;
    var phi_3392_: f64;
    var phi_3394_: f64;
    var phi_3427_: f64;
    var phi_3429_: f64;
    var phi_3584_: type_28;
    var phi_3587_: array<f64, 3>;
    var phi_3585_: type_28;
    var phi_3610_: type_28;
    var phi_3677_: array<f64, 3>;
    var phi_3588_: array<f64, 3>;
    var phi_3678_: array<f64, 3>;
    var phi_3710_: type_26;
    var phi_3713_: f64;
    var phi_3734_: bool;
    var phi_3740_: type_27;
    var phi_3711_: type_26;
    var phi_3754_: type_27;
    var phi_3714_: f64;
    var local_49: f64;
    var phi_3703_: f64;
    var phi_3767_: f64;
    var phi_3785_: f64;
    var phi_3792_: f64;
    var phi_3797_: f64;
    var phi_3804_: f64;
    var phi_3809_: f64;
    var phi_3822_: f64;
    var phi_3829_: f64;
    var phi_3834_: f64;
    var phi_3841_: f64;
    var phi_3846_: f64;
    var phi_3851_: f64;
    var phi_3868_: f64;
    var phi_3875_: f64;
    var phi_3880_: f64;
    var phi_3887_: f64;
    var phi_3892_: f64;
    var phi_3906_: f64;
    var phi_3913_: f64;
    var phi_3918_: f64;
    var phi_3925_: f64;
    var phi_3930_: f64;
    var phi_3935_: f64;
    var phi_3952_: f64;
    var phi_3959_: f64;
    var phi_3964_: f64;
    var phi_3971_: f64;
    var phi_3976_: f64;
    var phi_3990_: f64;
    var phi_3997_: f64;
    var phi_4002_: f64;
    var phi_4009_: f64;
    var phi_4014_: f64;
    var phi_4019_: f64;
    var phi_4043_: bool;
    var phi_4044_: bool;
    var phi_4045_: bool;
    var local_50: bool;
    var phi_4050_: type_72;
    var phi_4051_: bool;
    var phi_4056_: type_72;
    var phi_4057_: bool;
    var phi_4059_: type_72;
    var phi_4060_: type_72;
    var phi_4061_: bool;
    var phi_4065_: type_72;
    var phi_7436_: type_72;
    var phi_7437_: type_72;
    var phi_7458_: type_46;
    var phi_7481_: u32;
    var phi_7485_: type_45;
    var phi_7486_: bool;
    var phi_7504_: u32;
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
        phi_230_ = _e134;
    } else {
        phi_230_ = _e136;
    }
    let _e139 = phi_230_;
    let _e140 = (_e139 / 64u);
    if ((_e139 % 64u) > 0u) {
        phi_246_ = (_e140 + 1u);
    } else {
        phi_246_ = _e140;
    }
    let _e145 = phi_246_;
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
            phi_267_ = (_e149 + 1u);
        } else {
            phi_267_ = _e149;
        }
        let _e155 = phi_267_;
        phi_268_ = _e155;
    } else {
        phi_268_ = 0u;
    }
    let _e157 = phi_268_;
    phi_271_ = type_28(0u, _e157);
    loop {
        let _e160 = phi_271_;
        if (_e160.member < _e160.member_1) {
            phi_272_ = type_28((_e160.member + 1u), _e160.member_1);
            phi_295_ = type_28(1u, _e160.member);
        } else {
            phi_272_ = _e160;
            phi_295_ = type_28(0u, type_28().member_1);
        }
        let _e174 = phi_272_;
        let _e176 = phi_295_;
        let _e180 = (bitcast<i32>(_e176.member) != 0i);
        if _e180 {
            let _e184 = (((_e129 + (_e176.member_1 * _e132)) * 64u) + _e117);
            let _e186 = params.member.member_8;
            if (_e184 < _e139) {
                let _e189 = (2u * _e184);
                let _e192 = input.member[(4u + _e189)];
                let _e195 = input.member[(_e189 + 5u)];
                let _e197 = elements.member[_e192];
                let _e199 = elements.member[_e195];
                local_15 = array<u32, 4>(_e197[0], _e197[1], _e199[0], _e199[1]);
                local_16[0u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[1u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[2u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[3u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[0u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[1u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[2u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[3u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                let _e214 = params.member.member_1;
                if ((_e214 & 8u) != 0u) {
                    let _e260 = paths.member[_e197[0]];
                    let _e262 = paths.member[_e197[1]];
                    let _e268 = paths.member[_e199[0]];
                    let _e270 = paths.member[_e199[1]];
                    local_18 = array<array<f32, 3>, 4>(array<f32, 3>(_e260.member[0], _e260.member[1], _e260.member[2]), array<f32, 3>(_e262.member[0], _e262.member[1], _e262.member[2]), array<f32, 3>(_e268.member[0], _e268.member[1], _e268.member[2]), array<f32, 3>(_e270.member[0], _e270.member[1], _e270.member[2]));
                    local_19 = array<array<f32, 3>, 4>(array<f32, 3>(_e260.member_1[0], _e260.member_1[1], _e260.member_1[2]), array<f32, 3>(_e262.member_1[0], _e262.member_1[1], _e262.member_1[2]), array<f32, 3>(_e268.member_1[0], _e268.member_1[1], _e268.member_1[2]), array<f32, 3>(_e270.member_1[0], _e270.member_1[1], _e270.member_1[2]));
                    phi_518_ = type_28(0u, 4u);
                    loop {
                        let _e310 = phi_518_;
                        if (_e310.member < _e310.member_1) {
                            phi_519_ = type_28((_e310.member + 1u), _e310.member_1);
                            phi_542_ = type_28(1u, _e310.member);
                        } else {
                            phi_519_ = _e310;
                            phi_542_ = type_28(0u, type_28().member_1);
                        }
                        let _e324 = phi_519_;
                        let _e326 = phi_542_;
                        let _e330 = (bitcast<i32>(_e326.member) != 0i);
                        if _e330 {
                            phi_552_ = type_28(0u, 3u);
                            loop {
                                let _e332 = phi_552_;
                                if (_e332.member < _e332.member_1) {
                                    phi_553_ = type_28((_e332.member + 1u), _e332.member_1);
                                    phi_576_ = type_28(1u, _e332.member);
                                } else {
                                    phi_553_ = _e332;
                                    phi_576_ = type_28(0u, type_28().member_1);
                                }
                                let _e346 = phi_553_;
                                let _e348 = phi_576_;
                                let _e352 = (bitcast<i32>(_e348.member) != 0i);
                                if _e352 {
                                    if (_e326.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e348.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e357 = local_18[_e326.member_1][_e348.member_1];
                                    if (_e326.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e348.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    local_16[_e326.member_1][_e348.member_1] = f64(_e357);
                                    if (_e326.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e348.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e367 = local_19[_e326.member_1][_e348.member_1];
                                    if (_e326.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e348.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    local_17[_e326.member_1][_e348.member_1] = f64(_e367);
                                }
                                continue;
                                continuing {
                                    phi_552_ = _e346;
                                    break if !(_e352);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_518_ = _e324;
                            break if !(_e330);
                        }
                    }
                } else {
                    phi_638_ = type_28(0u, 4u);
                    loop {
                        let _e218 = phi_638_;
                        if (_e218.member < _e218.member_1) {
                            phi_639_ = type_28((_e218.member + 1u), _e218.member_1);
                            phi_662_ = type_28(1u, _e218.member);
                        } else {
                            phi_639_ = _e218;
                            phi_662_ = type_28(0u, type_28().member_1);
                        }
                        let _e232 = phi_639_;
                        let _e234 = phi_662_;
                        let _e238 = (bitcast<i32>(_e234.member) != 0i);
                        if _e238 {
                            if (_e234.member_1 < 4u) {
                            } else {
                                return;
                            }
                            let _e241 = local_15[_e234.member_1];
                            let _e243 = wide.member[_e241];
                            if (_e234.member_1 < 4u) {
                            } else {
                                return;
                            }
                            local_16[_e234.member_1] = array<f64, 3>(_e243.member[0], _e243.member[1], _e243.member[2]);
                            if (_e234.member_1 < 4u) {
                            } else {
                                return;
                            }
                            local_17[_e234.member_1] = array<f64, 3>(_e243.member_1[0], _e243.member_1[1], _e243.member_1[2]);
                        }
                        continue;
                        continuing {
                            phi_638_ = _e232;
                            break if !(_e238);
                        }
                    }
                }
                let _e375 = local_16;
                let _e392 = local_17;
                local_20 = type_61(array<array<f64, 3>, 2>(array<f64, 3>((_e375[2][0] - _e375[0][0]), (_e375[2][1] - _e375[0][1]), (_e375[2][2] - _e375[0][2])), array<f64, 3>((_e392[2][0] - _e392[0][0]), (_e392[2][1] - _e392[0][1]), (_e392[2][2] - _e392[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e375[1][0] - _e375[0][0]), (_e375[1][1] - _e375[0][1]), (_e375[1][2] - _e375[0][2])), array<f64, 3>((_e392[1][0] - _e392[0][0]), (_e392[1][1] - _e392[0][1]), (_e392[1][2] - _e392[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e375[2][0] - _e375[3][0]), (_e375[2][1] - _e375[3][1]), (_e375[2][2] - _e375[3][2])), array<f64, 3>((_e392[2][0] - _e392[3][0]), (_e392[2][1] - _e392[3][1]), (_e392[2][2] - _e392[3][2]))), (0.0lf + 0.0lf));
                let _e439 = params.member.member_7;
                let _e446 = bitcast<f64>(((u64(_e439[1]) * 4294967296lu) + u64(_e439[0])));
                let _e447 = f64(0f);
                let _e450 = local_20.member_1[0u];
                let _e456 = local_20.member_2[0u];
                let _e462 = ((_e450[1] * _e456[2]) - (_e450[2] * _e456[1]));
                let _e465 = ((_e450[2] * _e456[0]) - (_e450[0] * _e456[2]));
                let _e468 = ((_e450[0] * _e456[1]) - (_e450[1] * _e456[0]));
                let _e471 = local_20.member_1[1u];
                let _e477 = local_20.member_2[1u];
                let _e483 = ((_e471[1] * _e477[2]) - (_e471[2] * _e477[1]));
                let _e486 = ((_e471[2] * _e477[0]) - (_e471[0] * _e477[2]));
                let _e489 = ((_e471[0] * _e477[1]) - (_e471[1] * _e477[0]));
                let _e492 = local_20.member_1[0u];
                let _e498 = local_20.member_2[1u];
                let _e513 = local_20.member_1[1u];
                let _e519 = local_20.member_2[0u];
                let _e532 = (((_e492[1] * _e498[2]) - (_e492[2] * _e498[1])) + ((_e513[1] * _e519[2]) - (_e513[2] * _e519[1])));
                let _e533 = (((_e492[2] * _e498[0]) - (_e492[0] * _e498[2])) + ((_e513[2] * _e519[0]) - (_e513[0] * _e519[2])));
                let _e534 = (((_e492[0] * _e498[1]) - (_e492[1] * _e498[0])) + ((_e513[0] * _e519[1]) - (_e513[1] * _e519[0])));
                let _e537 = local_20.member[0u];
                let _e545 = (((_e537[0] * _e462) + (_e537[1] * _e465)) + (_e537[2] * _e468));
                let _e548 = local_20.member[1u];
                let _e559 = local_20.member[0u];
                let _e568 = ((((_e548[0] * _e462) + (_e548[1] * _e465)) + (_e548[2] * _e468)) + (((_e559[0] * _e532) + (_e559[1] * _e533)) + (_e559[2] * _e534)));
                let _e571 = local_20.member[0u];
                let _e582 = local_20.member[1u];
                let _e591 = ((((_e571[0] * _e483) + (_e571[1] * _e486)) + (_e571[2] * _e489)) + (((_e582[0] * _e532) + (_e582[1] * _e533)) + (_e582[2] * _e534)));
                let _e594 = local_20.member[1u];
                let _e602 = (((_e594[0] * _e483) + (_e594[1] * _e486)) + (_e594[2] * _e489));
                let _e605 = local_20.member[0u];
                if (_e605[0] < 0.0lf) {
                    phi_1119_ = -(_e605[0]);
                } else {
                    phi_1119_ = _e605[0];
                }
                let _e612 = phi_1119_;
                if (_e605[1] < 0.0lf) {
                    phi_1126_ = -(_e605[1]);
                } else {
                    phi_1126_ = _e605[1];
                }
                let _e616 = phi_1126_;
                if (_e612 > _e616) {
                    phi_1131_ = _e612;
                } else {
                    phi_1131_ = _e616;
                }
                let _e619 = phi_1131_;
                if (_e605[2] < 0.0lf) {
                    phi_1138_ = -(_e605[2]);
                } else {
                    phi_1138_ = _e605[2];
                }
                let _e623 = phi_1138_;
                if (_e619 > _e623) {
                    phi_1143_ = _e619;
                } else {
                    phi_1143_ = _e623;
                }
                let _e626 = phi_1143_;
                let _e629 = local_20.member[1u];
                if (_e629[0] < 0.0lf) {
                    phi_1156_ = -(_e629[0]);
                } else {
                    phi_1156_ = _e629[0];
                }
                let _e636 = phi_1156_;
                if (_e629[1] < 0.0lf) {
                    phi_1163_ = -(_e629[1]);
                } else {
                    phi_1163_ = _e629[1];
                }
                let _e640 = phi_1163_;
                if (_e636 > _e640) {
                    phi_1168_ = _e636;
                } else {
                    phi_1168_ = _e640;
                }
                let _e643 = phi_1168_;
                if (_e629[2] < 0.0lf) {
                    phi_1175_ = -(_e629[2]);
                } else {
                    phi_1175_ = _e629[2];
                }
                let _e647 = phi_1175_;
                if (_e643 > _e647) {
                    phi_1180_ = _e643;
                } else {
                    phi_1180_ = _e647;
                }
                let _e650 = phi_1180_;
                if (_e626 > _e650) {
                    phi_1185_ = _e626;
                } else {
                    phi_1185_ = _e650;
                }
                let _e653 = phi_1185_;
                let _e655 = local_20.member_3;
                let _e656 = (_e653 + _e655);
                let _e659 = local_20.member_1[0u];
                if (_e659[0] < 0.0lf) {
                    phi_1202_ = -(_e659[0]);
                } else {
                    phi_1202_ = _e659[0];
                }
                let _e666 = phi_1202_;
                if (_e659[1] < 0.0lf) {
                    phi_1209_ = -(_e659[1]);
                } else {
                    phi_1209_ = _e659[1];
                }
                let _e670 = phi_1209_;
                if (_e666 > _e670) {
                    phi_1214_ = _e666;
                } else {
                    phi_1214_ = _e670;
                }
                let _e673 = phi_1214_;
                if (_e659[2] < 0.0lf) {
                    phi_1221_ = -(_e659[2]);
                } else {
                    phi_1221_ = _e659[2];
                }
                let _e677 = phi_1221_;
                if (_e673 > _e677) {
                    phi_1226_ = _e673;
                } else {
                    phi_1226_ = _e677;
                }
                let _e680 = phi_1226_;
                let _e683 = local_20.member_1[1u];
                if (_e683[0] < 0.0lf) {
                    phi_1240_ = -(_e683[0]);
                } else {
                    phi_1240_ = _e683[0];
                }
                let _e690 = phi_1240_;
                if (_e683[1] < 0.0lf) {
                    phi_1247_ = -(_e683[1]);
                } else {
                    phi_1247_ = _e683[1];
                }
                let _e694 = phi_1247_;
                if (_e690 > _e694) {
                    phi_1252_ = _e690;
                } else {
                    phi_1252_ = _e694;
                }
                let _e697 = phi_1252_;
                if (_e683[2] < 0.0lf) {
                    phi_1259_ = -(_e683[2]);
                } else {
                    phi_1259_ = _e683[2];
                }
                let _e701 = phi_1259_;
                if (_e697 > _e701) {
                    phi_1264_ = _e697;
                } else {
                    phi_1264_ = _e701;
                }
                let _e704 = phi_1264_;
                if (_e680 > _e704) {
                    phi_1269_ = _e680;
                } else {
                    phi_1269_ = _e704;
                }
                let _e707 = phi_1269_;
                let _e709 = local_20.member_3;
                let _e710 = (_e707 + _e709);
                let _e713 = local_20.member_2[0u];
                if (_e713[0] < 0.0lf) {
                    phi_1286_ = -(_e713[0]);
                } else {
                    phi_1286_ = _e713[0];
                }
                let _e720 = phi_1286_;
                if (_e713[1] < 0.0lf) {
                    phi_1293_ = -(_e713[1]);
                } else {
                    phi_1293_ = _e713[1];
                }
                let _e724 = phi_1293_;
                if (_e720 > _e724) {
                    phi_1298_ = _e720;
                } else {
                    phi_1298_ = _e724;
                }
                let _e727 = phi_1298_;
                if (_e713[2] < 0.0lf) {
                    phi_1305_ = -(_e713[2]);
                } else {
                    phi_1305_ = _e713[2];
                }
                let _e731 = phi_1305_;
                if (_e727 > _e731) {
                    phi_1310_ = _e727;
                } else {
                    phi_1310_ = _e731;
                }
                let _e734 = phi_1310_;
                let _e737 = local_20.member_2[1u];
                if (_e737[0] < 0.0lf) {
                    phi_1324_ = -(_e737[0]);
                } else {
                    phi_1324_ = _e737[0];
                }
                let _e744 = phi_1324_;
                if (_e737[1] < 0.0lf) {
                    phi_1331_ = -(_e737[1]);
                } else {
                    phi_1331_ = _e737[1];
                }
                let _e748 = phi_1331_;
                if (_e744 > _e748) {
                    phi_1336_ = _e744;
                } else {
                    phi_1336_ = _e748;
                }
                let _e751 = phi_1336_;
                if (_e737[2] < 0.0lf) {
                    phi_1343_ = -(_e737[2]);
                } else {
                    phi_1343_ = _e737[2];
                }
                let _e755 = phi_1343_;
                if (_e751 > _e755) {
                    phi_1348_ = _e751;
                } else {
                    phi_1348_ = _e755;
                }
                let _e758 = phi_1348_;
                if (_e734 > _e758) {
                    phi_1353_ = _e734;
                } else {
                    phi_1353_ = _e758;
                }
                let _e761 = phi_1353_;
                let _e763 = local_20.member_3;
                let _e764 = (_e761 + _e763);
                let _e765 = f64(1f);
                let _e766 = f64(8f);
                let _e768 = ((_e710 * _e766) * _e764);
                let _e776 = local_20.member_3;
                if (_e462 < 0.0lf) {
                    phi_1390_ = -(_e462);
                } else {
                    phi_1390_ = _e462;
                }
                let _e796 = phi_1390_;
                if (_e465 < 0.0lf) {
                    phi_1396_ = -(_e465);
                } else {
                    phi_1396_ = _e465;
                }
                let _e800 = phi_1396_;
                if (_e468 < 0.0lf) {
                    phi_1403_ = -(_e468);
                } else {
                    phi_1403_ = _e468;
                }
                let _e805 = phi_1403_;
                let _e806 = ((_e796 + _e800) + _e805);
                if (_e483 < 0.0lf) {
                    phi_1410_ = -(_e483);
                } else {
                    phi_1410_ = _e483;
                }
                let _e810 = phi_1410_;
                if (_e486 < 0.0lf) {
                    phi_1416_ = -(_e486);
                } else {
                    phi_1416_ = _e486;
                }
                let _e814 = phi_1416_;
                if (_e489 < 0.0lf) {
                    phi_1423_ = -(_e489);
                } else {
                    phi_1423_ = _e489;
                }
                let _e819 = phi_1423_;
                let _e820 = ((_e810 + _e814) + _e819);
                if (_e806 > _e820) {
                    phi_1429_ = _e806;
                } else {
                    phi_1429_ = _e820;
                }
                let _e823 = phi_1429_;
                if (_e532 < 0.0lf) {
                    phi_1435_ = -(_e532);
                } else {
                    phi_1435_ = _e532;
                }
                let _e827 = phi_1435_;
                if (_e533 < 0.0lf) {
                    phi_1441_ = -(_e533);
                } else {
                    phi_1441_ = _e533;
                }
                let _e831 = phi_1441_;
                if (_e534 < 0.0lf) {
                    phi_1448_ = -(_e534);
                } else {
                    phi_1448_ = _e534;
                }
                let _e836 = phi_1448_;
                let _e838 = (((_e827 + _e831) + _e836) * f64(0.5f));
                if (_e823 > _e838) {
                    phi_1455_ = _e823;
                } else {
                    phi_1455_ = _e838;
                }
                let _e841 = phi_1455_;
                let _e847 = local_20.member_3;
                let _e861 = (((((_e656 * _e766) * _e768) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e776 * f64(19f)) * ((_e656 * (_e710 + _e764)) + (_e710 * _e764)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e765 + _e656) * ((_e765 + _e710) * (_e765 + _e764)))));
                let _e862 = f64(3f);
                let _e863 = (_e545 * _e862);
                let _e864 = (_e602 * _e862);
                if (_e863 < _e864) {
                    phi_1483_ = _e863;
                } else {
                    phi_1483_ = _e864;
                }
                let _e867 = phi_1483_;
                if (_e568 < _e591) {
                    phi_1488_ = _e568;
                } else {
                    phi_1488_ = _e591;
                }
                let _e870 = phi_1488_;
                if (_e867 < _e870) {
                    phi_1493_ = _e867;
                } else {
                    phi_1493_ = _e870;
                }
                let _e873 = phi_1493_;
                if (_e863 > _e864) {
                    phi_1498_ = _e863;
                } else {
                    phi_1498_ = _e864;
                }
                let _e876 = phi_1498_;
                if (_e568 > _e591) {
                    phi_1503_ = _e568;
                } else {
                    phi_1503_ = _e591;
                }
                let _e879 = phi_1503_;
                if (_e876 > _e879) {
                    phi_1508_ = _e876;
                } else {
                    phi_1508_ = _e879;
                }
                let _e882 = phi_1508_;
                let _e888 = -(_e882);
                if (_e873 > _e888) {
                    phi_1519_ = _e873;
                } else {
                    phi_1519_ = _e888;
                }
                let _e891 = phi_1519_;
                if ((_e891 - (_e861 + ((_e446 * (((_e841 + (_e768 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e847 * f64(6f)) * (_e710 + _e764))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e765 + _e710) * (_e765 + _e764))))) * f64((3f * 1.0001f))))) > _e447) {
                    phi_7437_ = type_72(0u, type_72().member_1);
                } else {
                    if (_e446 > _e447) {
                        let _e3308 = f64(1f);
                        let _e3312 = local_20.member[0u];
                        let _e3318 = local_20.member_1[0u];
                        let _e3324 = local_20.member_2[0u];
                        let _e3328 = (_e3312[0] - _e3318[0]);
                        let _e3329 = (_e3312[1] - _e3318[1]);
                        let _e3330 = (_e3312[2] - _e3318[2]);
                        local_12 = array<array<f64, 3>, 4>(_e3312, array<f64, 3>(_e3328, _e3329, _e3330), array<f64, 3>((_e3312[0] - _e3324[0]), (_e3312[1] - _e3324[1]), (_e3312[2] - _e3324[2])), array<f64, 3>((_e3328 - _e3324[0]), (_e3329 - _e3324[1]), (_e3330 - _e3324[2])));
                        let _e3343 = local_20.member[1u];
                        let _e3349 = local_20.member_1[1u];
                        let _e3355 = local_20.member_2[1u];
                        let _e3359 = (_e3343[0] - _e3349[0]);
                        let _e3360 = (_e3343[1] - _e3349[1]);
                        let _e3361 = (_e3343[2] - _e3349[2]);
                        local_13 = array<array<f64, 3>, 4>(_e3343, array<f64, 3>(_e3359, _e3360, _e3361), array<f64, 3>((_e3343[0] - _e3355[0]), (_e3343[1] - _e3355[1]), (_e3343[2] - _e3355[2])), array<f64, 3>((_e3359 - _e3355[0]), (_e3360 - _e3355[1]), (_e3361 - _e3355[2])));
                        let _e3374 = local_20.member[0u];
                        if (_e3374[0] < 0.0lf) {
                            phi_1722_ = -(_e3374[0]);
                        } else {
                            phi_1722_ = _e3374[0];
                        }
                        let _e3381 = phi_1722_;
                        if (_e3374[1] < 0.0lf) {
                            phi_1729_ = -(_e3374[1]);
                        } else {
                            phi_1729_ = _e3374[1];
                        }
                        let _e3385 = phi_1729_;
                        if (_e3381 > _e3385) {
                            phi_1734_ = _e3381;
                        } else {
                            phi_1734_ = _e3385;
                        }
                        let _e3388 = phi_1734_;
                        if (_e3374[2] < 0.0lf) {
                            phi_1741_ = -(_e3374[2]);
                        } else {
                            phi_1741_ = _e3374[2];
                        }
                        let _e3392 = phi_1741_;
                        if (_e3388 > _e3392) {
                            phi_1746_ = _e3388;
                        } else {
                            phi_1746_ = _e3392;
                        }
                        let _e3395 = phi_1746_;
                        let _e3398 = local_20.member[1u];
                        if (_e3398[0] < 0.0lf) {
                            phi_1759_ = -(_e3398[0]);
                        } else {
                            phi_1759_ = _e3398[0];
                        }
                        let _e3405 = phi_1759_;
                        if (_e3398[1] < 0.0lf) {
                            phi_1766_ = -(_e3398[1]);
                        } else {
                            phi_1766_ = _e3398[1];
                        }
                        let _e3409 = phi_1766_;
                        if (_e3405 > _e3409) {
                            phi_1771_ = _e3405;
                        } else {
                            phi_1771_ = _e3409;
                        }
                        let _e3412 = phi_1771_;
                        if (_e3398[2] < 0.0lf) {
                            phi_1778_ = -(_e3398[2]);
                        } else {
                            phi_1778_ = _e3398[2];
                        }
                        let _e3416 = phi_1778_;
                        if (_e3412 > _e3416) {
                            phi_1783_ = _e3412;
                        } else {
                            phi_1783_ = _e3416;
                        }
                        let _e3419 = phi_1783_;
                        if (_e3395 > _e3419) {
                            phi_1788_ = _e3395;
                        } else {
                            phi_1788_ = _e3419;
                        }
                        let _e3422 = phi_1788_;
                        let _e3424 = local_20.member_3;
                        let _e3428 = local_20.member_1[0u];
                        if (_e3428[0] < 0.0lf) {
                            phi_1805_ = -(_e3428[0]);
                        } else {
                            phi_1805_ = _e3428[0];
                        }
                        let _e3435 = phi_1805_;
                        if (_e3428[1] < 0.0lf) {
                            phi_1812_ = -(_e3428[1]);
                        } else {
                            phi_1812_ = _e3428[1];
                        }
                        let _e3439 = phi_1812_;
                        if (_e3435 > _e3439) {
                            phi_1817_ = _e3435;
                        } else {
                            phi_1817_ = _e3439;
                        }
                        let _e3442 = phi_1817_;
                        if (_e3428[2] < 0.0lf) {
                            phi_1824_ = -(_e3428[2]);
                        } else {
                            phi_1824_ = _e3428[2];
                        }
                        let _e3446 = phi_1824_;
                        if (_e3442 > _e3446) {
                            phi_1829_ = _e3442;
                        } else {
                            phi_1829_ = _e3446;
                        }
                        let _e3449 = phi_1829_;
                        let _e3452 = local_20.member_1[1u];
                        if (_e3452[0] < 0.0lf) {
                            phi_1843_ = -(_e3452[0]);
                        } else {
                            phi_1843_ = _e3452[0];
                        }
                        let _e3459 = phi_1843_;
                        if (_e3452[1] < 0.0lf) {
                            phi_1850_ = -(_e3452[1]);
                        } else {
                            phi_1850_ = _e3452[1];
                        }
                        let _e3463 = phi_1850_;
                        if (_e3459 > _e3463) {
                            phi_1855_ = _e3459;
                        } else {
                            phi_1855_ = _e3463;
                        }
                        let _e3466 = phi_1855_;
                        if (_e3452[2] < 0.0lf) {
                            phi_1862_ = -(_e3452[2]);
                        } else {
                            phi_1862_ = _e3452[2];
                        }
                        let _e3470 = phi_1862_;
                        if (_e3466 > _e3470) {
                            phi_1867_ = _e3466;
                        } else {
                            phi_1867_ = _e3470;
                        }
                        let _e3473 = phi_1867_;
                        if (_e3449 > _e3473) {
                            phi_1872_ = _e3449;
                        } else {
                            phi_1872_ = _e3473;
                        }
                        let _e3476 = phi_1872_;
                        let _e3478 = local_20.member_3;
                        let _e3482 = local_20.member_2[0u];
                        if (_e3482[0] < 0.0lf) {
                            phi_1889_ = -(_e3482[0]);
                        } else {
                            phi_1889_ = _e3482[0];
                        }
                        let _e3489 = phi_1889_;
                        if (_e3482[1] < 0.0lf) {
                            phi_1896_ = -(_e3482[1]);
                        } else {
                            phi_1896_ = _e3482[1];
                        }
                        let _e3493 = phi_1896_;
                        if (_e3489 > _e3493) {
                            phi_1901_ = _e3489;
                        } else {
                            phi_1901_ = _e3493;
                        }
                        let _e3496 = phi_1901_;
                        if (_e3482[2] < 0.0lf) {
                            phi_1908_ = -(_e3482[2]);
                        } else {
                            phi_1908_ = _e3482[2];
                        }
                        let _e3500 = phi_1908_;
                        if (_e3496 > _e3500) {
                            phi_1913_ = _e3496;
                        } else {
                            phi_1913_ = _e3500;
                        }
                        let _e3503 = phi_1913_;
                        let _e3506 = local_20.member_2[1u];
                        if (_e3506[0] < 0.0lf) {
                            phi_1927_ = -(_e3506[0]);
                        } else {
                            phi_1927_ = _e3506[0];
                        }
                        let _e3513 = phi_1927_;
                        if (_e3506[1] < 0.0lf) {
                            phi_1934_ = -(_e3506[1]);
                        } else {
                            phi_1934_ = _e3506[1];
                        }
                        let _e3517 = phi_1934_;
                        if (_e3513 > _e3517) {
                            phi_1939_ = _e3513;
                        } else {
                            phi_1939_ = _e3517;
                        }
                        let _e3520 = phi_1939_;
                        if (_e3506[2] < 0.0lf) {
                            phi_1946_ = -(_e3506[2]);
                        } else {
                            phi_1946_ = _e3506[2];
                        }
                        let _e3524 = phi_1946_;
                        if (_e3520 > _e3524) {
                            phi_1951_ = _e3520;
                        } else {
                            phi_1951_ = _e3524;
                        }
                        let _e3527 = phi_1951_;
                        if (_e3503 > _e3527) {
                            phi_1956_ = _e3503;
                        } else {
                            phi_1956_ = _e3527;
                        }
                        let _e3530 = phi_1956_;
                        let _e3532 = local_20.member_3;
                        let _e3540 = local_20.member_3;
                        phi_1976_ = type_28(0u, 48u);
                        phi_1979_ = f64(0f);
                        loop {
                            let _e3549 = phi_1976_;
                            let _e3551 = phi_1979_;
                            local_87 = _e3551;
                            local_45 = _e3551;
                            local_46 = _e3551;
                            local_47 = _e3551;
                            local_48 = _e3551;
                            if (_e3549.member < _e3549.member_1) {
                                phi_1977_ = type_28((_e3549.member + 1u), _e3549.member_1);
                                phi_2002_ = type_28(1u, _e3549.member);
                            } else {
                                phi_1977_ = _e3549;
                                phi_2002_ = type_28(0u, type_28().member_1);
                            }
                            let _e3565 = phi_1977_;
                            let _e3567 = phi_2002_;
                            if (bitcast<i32>(_e3567.member) != 0i) {
                                let _e3573 = local_20.member[0u];
                                let _e3579 = local_20.member[1u];
                                let _e3589 = (_e3573[0] + ((_e3579[0] - _e3573[0]) * _e3551));
                                let _e3590 = (_e3573[1] + ((_e3579[1] - _e3573[1]) * _e3551));
                                let _e3591 = (_e3573[2] + ((_e3579[2] - _e3573[2]) * _e3551));
                                let _e3594 = local_20.member_1[0u];
                                let _e3600 = local_20.member_1[1u];
                                let _e3610 = (_e3594[0] + ((_e3600[0] - _e3594[0]) * _e3551));
                                let _e3611 = (_e3594[1] + ((_e3600[1] - _e3594[1]) * _e3551));
                                let _e3612 = (_e3594[2] + ((_e3600[2] - _e3594[2]) * _e3551));
                                let _e3615 = local_20.member_2[0u];
                                let _e3621 = local_20.member_2[1u];
                                let _e3631 = (_e3615[0] + ((_e3621[0] - _e3615[0]) * _e3551));
                                let _e3632 = (_e3615[1] + ((_e3621[1] - _e3615[1]) * _e3551));
                                let _e3633 = (_e3615[2] + ((_e3621[2] - _e3615[2]) * _e3551));
                                let _e3638 = (((_e3610 * _e3610) + (_e3611 * _e3611)) + (_e3612 * _e3612));
                                let _e3643 = (((_e3610 * _e3631) + (_e3611 * _e3632)) + (_e3612 * _e3633));
                                let _e3648 = (((_e3631 * _e3631) + (_e3632 * _e3632)) + (_e3633 * _e3633));
                                let _e3653 = (((_e3589 * _e3610) + (_e3590 * _e3611)) + (_e3591 * _e3612));
                                let _e3658 = (((_e3589 * _e3631) + (_e3590 * _e3632)) + (_e3591 * _e3633));
                                let _e3661 = ((_e3638 * _e3648) - (_e3643 * _e3643));
                                let _e3662 = f64(0f);
                                let _e3663 = f64(1f);
                                let _e3667 = (((_e3653 * _e3648) - (_e3658 * _e3643)) / _e3661);
                                let _e3671 = (((_e3658 * _e3638) - (_e3653 * _e3643)) / _e3661);
                                if (_e3667 >= _e3662) {
                                    if (_e3671 >= _e3662) {
                                        if (_e3667 <= _e3663) {
                                            phi_2158_ = (_e3671 <= _e3663);
                                            phi_2159_ = false;
                                        } else {
                                            phi_2158_ = bool();
                                            phi_2159_ = true;
                                        }
                                        let _e3677 = phi_2158_;
                                        let _e3679 = phi_2159_;
                                        phi_2160_ = _e3677;
                                        phi_2161_ = _e3679;
                                    } else {
                                        phi_2160_ = bool();
                                        phi_2161_ = true;
                                    }
                                    let _e3681 = phi_2160_;
                                    let _e3683 = phi_2161_;
                                    phi_2162_ = _e3681;
                                    phi_2163_ = _e3683;
                                } else {
                                    phi_2162_ = bool();
                                    phi_2163_ = true;
                                }
                                let _e3685 = phi_2162_;
                                let _e3687 = phi_2163_;
                                if _e3687 {
                                    phi_2167_ = false;
                                } else {
                                    phi_2167_ = _e3685;
                                }
                                let _e3689 = phi_2167_;
                                if (_e3661 > _e3662) {
                                    if _e3689 {
                                        phi_2207_ = array<f64, 3>((_e3589 - ((_e3610 * _e3667) + (_e3631 * _e3671))), (_e3590 - ((_e3611 * _e3667) + (_e3632 * _e3671))), (_e3591 - ((_e3612 * _e3667) + (_e3633 * _e3671))));
                                        phi_2208_ = false;
                                    } else {
                                        phi_2207_ = array<f64, 3>();
                                        phi_2208_ = true;
                                    }
                                    let _e3705 = phi_2207_;
                                    let _e3707 = phi_2208_;
                                    phi_2209_ = _e3705;
                                    phi_2210_ = _e3707;
                                } else {
                                    phi_2209_ = array<f64, 3>();
                                    phi_2210_ = true;
                                }
                                let _e3709 = phi_2209_;
                                let _e3711 = phi_2210_;
                                if _e3711 {
                                    let _e3712 = (_e3589 - _e3610);
                                    let _e3713 = (_e3590 - _e3611);
                                    let _e3714 = (_e3591 - _e3612);
                                    let _e3725 = ((((_e3589 * _e3610) + (_e3590 * _e3611)) + (_e3591 * _e3612)) / (((_e3610 * _e3610) + (_e3611 * _e3611)) + (_e3612 * _e3612)));
                                    if (_e3725 > f64(0f)) {
                                        if (_e3725 < f64(1f)) {
                                            phi_2243_ = _e3725;
                                        } else {
                                            phi_2243_ = f64(1f);
                                        }
                                        let _e3733 = phi_2243_;
                                        phi_2245_ = _e3733;
                                    } else {
                                        phi_2245_ = f64(0f);
                                    }
                                    let _e3735 = phi_2245_;
                                    let _e3752 = ((((_e3589 * _e3631) + (_e3590 * _e3632)) + (_e3591 * _e3633)) / (((_e3631 * _e3631) + (_e3632 * _e3632)) + (_e3633 * _e3633)));
                                    if (_e3752 > f64(0f)) {
                                        if (_e3752 < f64(1f)) {
                                            phi_2275_ = _e3752;
                                        } else {
                                            phi_2275_ = f64(1f);
                                        }
                                        let _e3760 = phi_2275_;
                                        phi_2277_ = _e3760;
                                    } else {
                                        phi_2277_ = f64(0f);
                                    }
                                    let _e3762 = phi_2277_;
                                    let _e3779 = ((((_e3712 * _e3631) + (_e3713 * _e3632)) + (_e3714 * _e3633)) / (((_e3631 * _e3631) + (_e3632 * _e3632)) + (_e3633 * _e3633)));
                                    if (_e3779 > f64(0f)) {
                                        if (_e3779 < f64(1f)) {
                                            phi_2307_ = _e3779;
                                        } else {
                                            phi_2307_ = f64(1f);
                                        }
                                        let _e3787 = phi_2307_;
                                        phi_2309_ = _e3787;
                                    } else {
                                        phi_2309_ = f64(0f);
                                    }
                                    let _e3789 = phi_2309_;
                                    let _e3796 = (_e3589 - _e3631);
                                    let _e3797 = (_e3590 - _e3632);
                                    let _e3798 = (_e3591 - _e3633);
                                    let _e3809 = ((((_e3796 * _e3610) + (_e3797 * _e3611)) + (_e3798 * _e3612)) / (((_e3610 * _e3610) + (_e3611 * _e3611)) + (_e3612 * _e3612)));
                                    if (_e3809 > f64(0f)) {
                                        if (_e3809 < f64(1f)) {
                                            phi_2342_ = _e3809;
                                        } else {
                                            phi_2342_ = f64(1f);
                                        }
                                        let _e3817 = phi_2342_;
                                        phi_2344_ = _e3817;
                                    } else {
                                        phi_2344_ = f64(0f);
                                    }
                                    let _e3819 = phi_2344_;
                                    local_11[0u] = array<f64, 3>((_e3589 - (_e3610 * _e3735)), (_e3590 - (_e3611 * _e3735)), (_e3591 - (_e3612 * _e3735)));
                                    local_11[1u] = array<f64, 3>((_e3589 - (_e3631 * _e3762)), (_e3590 - (_e3632 * _e3762)), (_e3591 - (_e3633 * _e3762)));
                                    local_11[2u] = array<f64, 3>((_e3712 - (_e3631 * _e3789)), (_e3713 - (_e3632 * _e3789)), (_e3714 - (_e3633 * _e3789)));
                                    local_11[3u] = array<f64, 3>((_e3796 - (_e3610 * _e3819)), (_e3797 - (_e3611 * _e3819)), (_e3798 - (_e3612 * _e3819)));
                                    let _e3835 = local_11[0u];
                                    phi_2499_ = type_28(1u, 4u);
                                    phi_2502_ = array<f64, 3>(_e3835[0], _e3835[1], _e3835[2]);
                                    loop {
                                        let _e3841 = phi_2499_;
                                        let _e3843 = phi_2502_;
                                        local_74 = _e3843;
                                        if (_e3841.member < _e3841.member_1) {
                                            phi_2500_ = type_28((_e3841.member + 1u), _e3841.member_1);
                                            phi_2525_ = type_28(1u, _e3841.member);
                                        } else {
                                            phi_2500_ = _e3841;
                                            phi_2525_ = type_28(0u, type_28().member_1);
                                        }
                                        let _e3857 = phi_2500_;
                                        let _e3859 = phi_2525_;
                                        let _e3863 = (bitcast<i32>(_e3859.member) != 0i);
                                        if _e3863 {
                                            if (_e3859.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3866 = local_11[_e3859.member_1];
                                            if (_e3859.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3872 = local_11[_e3859.member_1];
                                            if ((((_e3866[0] * _e3872[0]) + (_e3866[1] * _e3872[1])) + (_e3866[2] * _e3872[2])) < (((_e3843[0] * _e3843[0]) + (_e3843[1] * _e3843[1])) + (_e3843[2] * _e3843[2]))) {
                                                if (_e3859.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3895 = local_11[_e3859.member_1];
                                                phi_2592_ = array<f64, 3>(_e3895[0], _e3895[1], _e3895[2]);
                                            } else {
                                                phi_2592_ = _e3843;
                                            }
                                            let _e3901 = phi_2592_;
                                            phi_2503_ = _e3901;
                                        } else {
                                            phi_2503_ = array<f64, 3>();
                                        }
                                        let _e3903 = phi_2503_;
                                        continue;
                                        continuing {
                                            phi_2499_ = _e3857;
                                            phi_2502_ = _e3903;
                                            break if !(_e3863);
                                        }
                                    }
                                    let _e5725 = local_74;
                                    phi_2593_ = _e5725;
                                } else {
                                    phi_2593_ = _e3709;
                                }
                                let _e3906 = phi_2593_;
                                if (_e3906[0] < 0.0lf) {
                                    phi_2600_ = -(_e3906[0]);
                                } else {
                                    phi_2600_ = _e3906[0];
                                }
                                let _e3911 = phi_2600_;
                                if (_e3906[1] < 0.0lf) {
                                    phi_2607_ = -(_e3906[1]);
                                } else {
                                    phi_2607_ = _e3906[1];
                                }
                                let _e3916 = phi_2607_;
                                if (_e3906[2] < 0.0lf) {
                                    phi_2615_ = -(_e3906[2]);
                                } else {
                                    phi_2615_ = _e3906[2];
                                }
                                let _e3922 = phi_2615_;
                                let _e3923 = ((_e3911 + _e3916) + _e3922);
                                if (_e3923 > f64(0f)) {
                                    if ((bitcast<u64>(_e3923) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e3929 = (f64(1f) / _e3923);
                                        let _e3931 = (_e3906[0] * _e3929);
                                        let _e3933 = (_e3906[1] * _e3929);
                                        let _e3935 = (_e3906[2] * _e3929);
                                        let _e3940 = (((_e3931 * _e3931) + (_e3933 * _e3933)) + (_e3935 * _e3935));
                                        if (_e3940 <= 2.2250738585072014e-308lf) {
                                            if (_e3940 > 0.0lf) {
                                                phi_2653_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2653_ = 0.0lf;
                                            }
                                            let _e3998 = phi_2653_;
                                            phi_2717_ = _e3998;
                                        } else {
                                            phi_2660_ = type_26(0i, 5i);
                                            phi_2663_ = bitcast<f64>(((bitcast<u64>(_e3940) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e3947 = phi_2660_;
                                                let _e3949 = phi_2663_;
                                                local_39 = _e3949;
                                                if (_e3947.member < _e3947.member_1) {
                                                    let _e3957 = (_e3947.member + 1i);
                                                    if ((false == (_e3957 > _e3947.member)) != false) {
                                                        phi_2684_ = true;
                                                    } else {
                                                        phi_2684_ = false;
                                                    }
                                                    let _e3962 = phi_2684_;
                                                    if _e3962 {
                                                        phi_2690_ = type_27(0u, type_27().member_1);
                                                    } else {
                                                        phi_2690_ = type_27(1u, _e3957);
                                                    }
                                                    let _e3968 = phi_2690_;
                                                    if (bitcast<i32>(_e3968.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2661_ = type_26(_e3968.member_1, _e3947.member_1);
                                                    phi_2704_ = type_27(1u, _e3947.member);
                                                } else {
                                                    phi_2661_ = _e3947;
                                                    phi_2704_ = type_27(0u, type_27().member_1);
                                                }
                                                let _e3978 = phi_2661_;
                                                let _e3980 = phi_2704_;
                                                let _e3983 = (bitcast<i32>(_e3980.member) != 0i);
                                                if _e3983 {
                                                    phi_2664_ = (0.5lf * (_e3949 + (_e3940 / _e3949)));
                                                } else {
                                                    phi_2664_ = f64();
                                                }
                                                let _e3988 = phi_2664_;
                                                continue;
                                                continuing {
                                                    phi_2660_ = _e3978;
                                                    phi_2663_ = _e3988;
                                                    break if !(_e3983);
                                                }
                                            }
                                            let _e3993 = local_39;
                                            phi_2717_ = (_e3993 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e4000 = phi_2717_;
                                        phi_2730_ = type_28(0u, 4u);
                                        phi_2733_ = f64(2f);
                                        loop {
                                            let _e4012 = phi_2730_;
                                            let _e4014 = phi_2733_;
                                            local_41 = _e4014;
                                            local_42 = _e4014;
                                            local_43 = _e4014;
                                            local_77 = _e4014;
                                            local_78 = _e4014;
                                            if (_e4012.member < _e4012.member_1) {
                                                phi_2731_ = type_28((_e4012.member + 1u), _e4012.member_1);
                                                phi_2756_ = type_28(1u, _e4012.member);
                                            } else {
                                                phi_2731_ = _e4012;
                                                phi_2756_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4028 = phi_2731_;
                                            let _e4030 = phi_2756_;
                                            if (bitcast<i32>(_e4030.member) != 0i) {
                                                if (_e4030.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4037 = local_12[_e4030.member_1];
                                                let _e4045 = (((_e3931 * _e4037[0]) + (_e3933 * _e4037[1])) + (_e3935 * _e4037[2]));
                                                if (_e4030.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4048 = local_13[_e4030.member_1];
                                                let _e4056 = (((_e3931 * _e4048[0]) + (_e3933 * _e4048[1])) + (_e3935 * _e4048[2]));
                                                if (_e4045 < 0.0lf) {
                                                    phi_2807_ = -(_e4045);
                                                } else {
                                                    phi_2807_ = _e4045;
                                                }
                                                let _e4060 = phi_2807_;
                                                if (_e4056 < 0.0lf) {
                                                    phi_2813_ = -(_e4056);
                                                } else {
                                                    phi_2813_ = _e4056;
                                                }
                                                let _e4064 = phi_2813_;
                                                let _e4069 = (((((((((_e3422 + _e3424) + (_e3476 + _e3478)) + (_e3530 + _e3532)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3540 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e446 * _e4000) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e4060 + _e4064) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e4045 > _e4069) {
                                                    if (_e4056 > _e4069) {
                                                        phi_2827_ = false;
                                                    } else {
                                                        phi_2827_ = true;
                                                    }
                                                    let _e4073 = phi_2827_;
                                                    phi_2828_ = _e4073;
                                                } else {
                                                    phi_2828_ = true;
                                                }
                                                let _e4075 = phi_2828_;
                                                if _e4075 {
                                                    if ((_e4045 + ((_e4056 - _e4045) * _e3551)) > _e4069) {
                                                        if (_e4056 < _e4045) {
                                                            let _e4084 = ((_e4045 - _e4056) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                            if _e4084 {
                                                                let _e4092 = (((_e4045 - _e4069) / (_e4045 - _e4056)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                if (_e4014 < _e4092) {
                                                                    phi_2862_ = _e4014;
                                                                } else {
                                                                    phi_2862_ = _e4092;
                                                                }
                                                                let _e4095 = phi_2862_;
                                                                phi_2863_ = _e4095;
                                                            } else {
                                                                phi_2863_ = f64();
                                                            }
                                                            let _e4097 = phi_2863_;
                                                            phi_2864_ = _e4097;
                                                            phi_2865_ = _e4084;
                                                        } else {
                                                            phi_2864_ = _e4014;
                                                            phi_2865_ = true;
                                                        }
                                                        let _e4099 = phi_2864_;
                                                        let _e4101 = phi_2865_;
                                                        if _e4101 {
                                                            phi_2869_ = false;
                                                        } else {
                                                            phi_2869_ = true;
                                                        }
                                                        let _e4103 = phi_2869_;
                                                        phi_2870_ = _e4099;
                                                        phi_2871_ = _e4101;
                                                        phi_2872_ = _e4103;
                                                        phi_2873_ = false;
                                                    } else {
                                                        phi_2870_ = f64();
                                                        phi_2871_ = false;
                                                        phi_2872_ = false;
                                                        phi_2873_ = true;
                                                    }
                                                    let _e4105 = phi_2870_;
                                                    let _e4107 = phi_2871_;
                                                    let _e4109 = phi_2872_;
                                                    let _e4111 = phi_2873_;
                                                    phi_2874_ = _e4105;
                                                    phi_2875_ = _e4107;
                                                    phi_2876_ = _e4109;
                                                    phi_2877_ = _e4111;
                                                } else {
                                                    phi_2874_ = _e4014;
                                                    phi_2875_ = true;
                                                    phi_2876_ = false;
                                                    phi_2877_ = false;
                                                }
                                                let _e4113 = phi_2874_;
                                                let _e4115 = phi_2875_;
                                                let _e4117 = phi_2876_;
                                                let _e4119 = phi_2877_;
                                                phi_2734_ = _e4113;
                                                phi_2878_ = _e4115;
                                                phi_2879_ = false;
                                                phi_2880_ = _e4117;
                                                phi_2881_ = _e4119;
                                            } else {
                                                phi_2734_ = f64();
                                                phi_2878_ = false;
                                                phi_2879_ = true;
                                                phi_2880_ = false;
                                                phi_2881_ = false;
                                            }
                                            let _e4121 = phi_2734_;
                                            let _e4123 = phi_2878_;
                                            let _e4125 = phi_2879_;
                                            let _e4127 = phi_2880_;
                                            let _e4129 = phi_2881_;
                                            local_40 = _e4125;
                                            local_75 = _e4127;
                                            local_76 = _e4129;
                                            continue;
                                            continuing {
                                                phi_2730_ = _e4028;
                                                phi_2733_ = _e4121;
                                                break if !(_e4123);
                                            }
                                        }
                                        let _e4132 = local_40;
                                        if _e4132 {
                                            let _e4134 = local_41;
                                            let _e4135 = (_e4134 > _e3308);
                                            if _e4135 {
                                                phi_2903_ = false;
                                                phi_2904_ = false;
                                                phi_2905_ = false;
                                            } else {
                                                let _e4137 = local_42;
                                                if (_e4137 > _e3551) {
                                                    let _e4140 = local_43;
                                                    let _e4143 = ((_e4140 - _e3551) < f64(0.00000000023283064f));
                                                    if _e4143 {
                                                        phi_2899_ = false;
                                                    } else {
                                                        phi_2899_ = true;
                                                    }
                                                    let _e4145 = phi_2899_;
                                                    phi_2900_ = _e4145;
                                                    phi_2901_ = _e4143;
                                                    phi_2902_ = false;
                                                } else {
                                                    phi_2900_ = false;
                                                    phi_2901_ = false;
                                                    phi_2902_ = true;
                                                }
                                                let _e4147 = phi_2900_;
                                                let _e4149 = phi_2901_;
                                                let _e4151 = phi_2902_;
                                                phi_2903_ = _e4147;
                                                phi_2904_ = _e4149;
                                                phi_2905_ = _e4151;
                                            }
                                            let _e4153 = phi_2903_;
                                            let _e4155 = phi_2904_;
                                            let _e4157 = phi_2905_;
                                            phi_2906_ = _e4153;
                                            phi_2907_ = _e4135;
                                            phi_2908_ = _e4155;
                                            phi_2909_ = _e4157;
                                            phi_2910_ = false;
                                            phi_2911_ = false;
                                        } else {
                                            phi_2906_ = false;
                                            phi_2907_ = false;
                                            phi_2908_ = false;
                                            phi_2909_ = false;
                                            let _e5782 = local_75;
                                            phi_2910_ = _e5782;
                                            let _e5785 = local_76;
                                            phi_2911_ = _e5785;
                                        }
                                        let _e4159 = phi_2906_;
                                        let _e4161 = phi_2907_;
                                        let _e4163 = phi_2908_;
                                        let _e4165 = phi_2909_;
                                        let _e4167 = phi_2910_;
                                        let _e4169 = phi_2911_;
                                        let _e5788 = local_77;
                                        phi_2912_ = _e5788;
                                        let _e5791 = local_78;
                                        phi_2913_ = _e5791;
                                        phi_2914_ = _e4159;
                                        phi_2915_ = _e4161;
                                        phi_2916_ = _e4163;
                                        phi_2917_ = _e4165;
                                        phi_2918_ = _e4167;
                                        phi_2919_ = _e4169;
                                        phi_2920_ = false;
                                    } else {
                                        phi_2912_ = f64();
                                        phi_2913_ = f64();
                                        phi_2914_ = false;
                                        phi_2915_ = false;
                                        phi_2916_ = false;
                                        phi_2917_ = false;
                                        phi_2918_ = false;
                                        phi_2919_ = false;
                                        phi_2920_ = true;
                                    }
                                    let _e4171 = phi_2912_;
                                    let _e4173 = phi_2913_;
                                    let _e4175 = phi_2914_;
                                    let _e4177 = phi_2915_;
                                    let _e4179 = phi_2916_;
                                    let _e4181 = phi_2917_;
                                    let _e4183 = phi_2918_;
                                    let _e4185 = phi_2919_;
                                    let _e4187 = phi_2920_;
                                    phi_2921_ = _e4171;
                                    phi_2922_ = _e4173;
                                    phi_2923_ = _e4175;
                                    phi_2924_ = _e4177;
                                    phi_2925_ = _e4179;
                                    phi_2926_ = _e4181;
                                    phi_2927_ = _e4183;
                                    phi_2928_ = _e4185;
                                    phi_2929_ = _e4187;
                                    phi_2930_ = false;
                                } else {
                                    phi_2921_ = f64();
                                    phi_2922_ = f64();
                                    phi_2923_ = false;
                                    phi_2924_ = false;
                                    phi_2925_ = false;
                                    phi_2926_ = false;
                                    phi_2927_ = false;
                                    phi_2928_ = false;
                                    phi_2929_ = false;
                                    phi_2930_ = true;
                                }
                                let _e4189 = phi_2921_;
                                let _e4191 = phi_2922_;
                                let _e4193 = phi_2923_;
                                let _e4195 = phi_2924_;
                                let _e4197 = phi_2925_;
                                let _e4199 = phi_2926_;
                                let _e4201 = phi_2927_;
                                let _e4203 = phi_2928_;
                                let _e4205 = phi_2929_;
                                let _e4207 = phi_2930_;
                                phi_2931_ = _e4189;
                                phi_1980_ = _e4191;
                                phi_2932_ = _e4193;
                                phi_2933_ = _e4195;
                                phi_2934_ = _e4197;
                                phi_2935_ = false;
                                phi_2936_ = _e4199;
                                phi_2937_ = _e4201;
                                phi_2938_ = _e4203;
                                phi_2939_ = _e4205;
                                phi_2940_ = _e4207;
                            } else {
                                phi_2931_ = f64();
                                phi_1980_ = f64();
                                phi_2932_ = false;
                                phi_2933_ = false;
                                phi_2934_ = false;
                                phi_2935_ = true;
                                phi_2936_ = false;
                                phi_2937_ = false;
                                phi_2938_ = false;
                                phi_2939_ = false;
                                phi_2940_ = false;
                            }
                            let _e4209 = phi_2931_;
                            let _e4211 = phi_1980_;
                            let _e4213 = phi_2932_;
                            let _e4215 = phi_2933_;
                            let _e4217 = phi_2934_;
                            let _e4219 = phi_2935_;
                            let _e4221 = phi_2936_;
                            let _e4223 = phi_2937_;
                            let _e4225 = phi_2938_;
                            let _e4227 = phi_2939_;
                            let _e4229 = phi_2940_;
                            local_44 = _e4215;
                            local_79 = _e4217;
                            local_80 = _e4219;
                            local_81 = _e4221;
                            local_82 = _e4223;
                            local_83 = _e4225;
                            local_84 = _e4227;
                            local_85 = _e4229;
                            local_86 = _e4209;
                            local_88 = _e4215;
                            continue;
                            continuing {
                                phi_1976_ = _e3565;
                                phi_1979_ = _e4211;
                                break if !(_e4213);
                            }
                        }
                        let _e4232 = local_44;
                        if _e4232 {
                            phi_2945_ = type_72(0u, type_72().member_1);
                            phi_2946_ = false;
                            phi_2947_ = false;
                            phi_2948_ = false;
                            phi_2949_ = false;
                            phi_2950_ = false;
                            phi_2951_ = false;
                            phi_2952_ = false;
                        } else {
                            phi_2945_ = type_72();
                            let _e5824 = local_79;
                            phi_2946_ = _e5824;
                            let _e5827 = local_80;
                            phi_2947_ = _e5827;
                            let _e5830 = local_81;
                            phi_2948_ = _e5830;
                            let _e5833 = local_82;
                            phi_2949_ = _e5833;
                            let _e5836 = local_83;
                            phi_2950_ = _e5836;
                            let _e5839 = local_84;
                            phi_2951_ = _e5839;
                            let _e5842 = local_85;
                            phi_2952_ = _e5842;
                        }
                        let _e4237 = phi_2945_;
                        let _e4239 = phi_2946_;
                        let _e4241 = phi_2947_;
                        let _e4243 = phi_2948_;
                        let _e4245 = phi_2949_;
                        let _e4247 = phi_2950_;
                        let _e4249 = phi_2951_;
                        let _e4251 = phi_2952_;
                        if _e4239 {
                            let _e5845 = local_86;
                            phi_2956_ = _e5845;
                            phi_2957_ = true;
                            phi_2958_ = false;
                            phi_2959_ = false;
                            phi_2960_ = false;
                            phi_2961_ = false;
                            phi_2962_ = false;
                            phi_2963_ = false;
                        } else {
                            let _e5847 = local_87;
                            phi_2956_ = _e5847;
                            phi_2957_ = _e4241;
                            phi_2958_ = _e4243;
                            phi_2959_ = _e4245;
                            phi_2960_ = _e4247;
                            let _e5854 = local_88;
                            phi_2961_ = _e5854;
                            phi_2962_ = _e4249;
                            phi_2963_ = _e4251;
                        }
                        let _e4253 = phi_2956_;
                        let _e4255 = phi_2957_;
                        let _e4257 = phi_2958_;
                        let _e4259 = phi_2959_;
                        let _e4261 = phi_2960_;
                        let _e4263 = phi_2961_;
                        let _e4265 = phi_2962_;
                        let _e4267 = phi_2963_;
                        if _e4255 {
                            phi_2968_ = type_72(1u, _e4253);
                            phi_2969_ = false;
                            phi_2970_ = false;
                            phi_2971_ = false;
                            phi_2972_ = false;
                            phi_2973_ = false;
                            phi_2974_ = false;
                        } else {
                            phi_2968_ = type_72();
                            phi_2969_ = _e4257;
                            phi_2970_ = _e4259;
                            phi_2971_ = _e4261;
                            phi_2972_ = _e4263;
                            phi_2973_ = _e4265;
                            phi_2974_ = _e4267;
                        }
                        let _e4270 = phi_2968_;
                        let _e4272 = phi_2969_;
                        let _e4274 = phi_2970_;
                        let _e4276 = phi_2971_;
                        let _e4278 = phi_2972_;
                        let _e4280 = phi_2973_;
                        let _e4282 = phi_2974_;
                        if _e4272 {
                            let _e4284 = local_45;
                            phi_2979_ = type_72(1u, _e4284);
                            phi_2980_ = false;
                            phi_2981_ = false;
                            phi_2982_ = true;
                            phi_2983_ = false;
                            phi_2984_ = false;
                        } else {
                            phi_2979_ = _e4237;
                            phi_2980_ = _e4274;
                            phi_2981_ = _e4276;
                            phi_2982_ = _e4278;
                            phi_2983_ = _e4280;
                            phi_2984_ = _e4282;
                        }
                        let _e4287 = phi_2979_;
                        let _e4289 = phi_2980_;
                        let _e4291 = phi_2981_;
                        let _e4293 = phi_2982_;
                        let _e4295 = phi_2983_;
                        let _e4297 = phi_2984_;
                        if _e4289 {
                            let _e4299 = local_46;
                            phi_2989_ = type_72(1u, _e4299);
                            phi_2990_ = false;
                            phi_2991_ = false;
                            phi_2992_ = false;
                            phi_2993_ = false;
                        } else {
                            phi_2989_ = type_72();
                            phi_2990_ = _e4291;
                            phi_2991_ = _e4293;
                            phi_2992_ = _e4295;
                            phi_2993_ = _e4297;
                        }
                        let _e4302 = phi_2989_;
                        let _e4304 = phi_2990_;
                        let _e4306 = phi_2991_;
                        let _e4308 = phi_2992_;
                        let _e4310 = phi_2993_;
                        if _e4304 {
                            let _e4312 = local_47;
                            phi_2998_ = type_72(1u, _e4312);
                            phi_2999_ = true;
                            phi_3000_ = false;
                            phi_3001_ = false;
                            phi_3002_ = false;
                        } else {
                            phi_2998_ = _e4302;
                            phi_2999_ = _e4289;
                            phi_3000_ = _e4306;
                            phi_3001_ = _e4308;
                            phi_3002_ = _e4310;
                        }
                        let _e4315 = phi_2998_;
                        let _e4317 = phi_2999_;
                        let _e4319 = phi_3000_;
                        let _e4321 = phi_3001_;
                        let _e4323 = phi_3002_;
                        if _e4317 {
                            phi_3006_ = _e4315;
                            phi_3007_ = true;
                            phi_3008_ = false;
                            phi_3009_ = false;
                        } else {
                            phi_3006_ = _e4287;
                            phi_3007_ = _e4319;
                            phi_3008_ = _e4321;
                            phi_3009_ = _e4323;
                        }
                        let _e4325 = phi_3006_;
                        let _e4327 = phi_3007_;
                        let _e4329 = phi_3008_;
                        let _e4331 = phi_3009_;
                        if _e4327 {
                            phi_3013_ = false;
                            phi_3014_ = false;
                        } else {
                            phi_3013_ = _e4329;
                            phi_3014_ = _e4331;
                        }
                        let _e4333 = phi_3013_;
                        let _e4335 = phi_3014_;
                        if _e4333 {
                            phi_3018_ = false;
                            phi_3019_ = false;
                        } else {
                            phi_3018_ = _e4335;
                            phi_3019_ = _e4327;
                        }
                        let _e4337 = phi_3018_;
                        let _e4339 = phi_3019_;
                        if _e4337 {
                            phi_3023_ = true;
                            phi_3024_ = false;
                        } else {
                            phi_3023_ = _e4333;
                            phi_3024_ = _e4339;
                        }
                        let _e4341 = phi_3023_;
                        let _e4343 = phi_3024_;
                        if _e4341 {
                            let _e4345 = local_48;
                            phi_3029_ = type_72(1u, _e4345);
                            phi_3030_ = true;
                        } else {
                            phi_3029_ = _e4325;
                            phi_3030_ = _e4343;
                        }
                        let _e4348 = phi_3029_;
                        let _e4350 = phi_3030_;
                        if _e4350 {
                            phi_3034_ = _e4348;
                        } else {
                            phi_3034_ = _e4270;
                        }
                        let _e4352 = phi_3034_;
                        if (_e4352.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_3048_ = type_28(0u, 3u);
                            loop {
                                let _e4365 = phi_3048_;
                                if (_e4365.member < _e4365.member_1) {
                                    phi_3049_ = type_28((_e4365.member + 1u), _e4365.member_1);
                                    phi_3072_ = type_28(1u, _e4365.member);
                                } else {
                                    phi_3049_ = _e4365;
                                    phi_3072_ = type_28(0u, type_28().member_1);
                                }
                                let _e4379 = phi_3049_;
                                let _e4381 = phi_3072_;
                                if (bitcast<i32>(_e4381.member) != 0i) {
                                    if (_e4381.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4388 = local_14[_e4381.member_1];
                                    let _e4390 = (_e4352.member_1 + f64(_e4388));
                                    if (_e4390 < _e3308) {
                                        phi_3093_ = _e4390;
                                    } else {
                                        phi_3093_ = _e3308;
                                    }
                                    let _e4393 = phi_3093_;
                                    let _e4396 = local_20.member[0u];
                                    let _e4402 = local_20.member[1u];
                                    let _e4412 = (_e4396[0] + ((_e4402[0] - _e4396[0]) * _e4393));
                                    let _e4413 = (_e4396[1] + ((_e4402[1] - _e4396[1]) * _e4393));
                                    let _e4414 = (_e4396[2] + ((_e4402[2] - _e4396[2]) * _e4393));
                                    let _e4417 = local_20.member_1[0u];
                                    let _e4423 = local_20.member_1[1u];
                                    let _e4433 = (_e4417[0] + ((_e4423[0] - _e4417[0]) * _e4393));
                                    let _e4434 = (_e4417[1] + ((_e4423[1] - _e4417[1]) * _e4393));
                                    let _e4435 = (_e4417[2] + ((_e4423[2] - _e4417[2]) * _e4393));
                                    let _e4438 = local_20.member_2[0u];
                                    let _e4444 = local_20.member_2[1u];
                                    let _e4454 = (_e4438[0] + ((_e4444[0] - _e4438[0]) * _e4393));
                                    let _e4455 = (_e4438[1] + ((_e4444[1] - _e4438[1]) * _e4393));
                                    let _e4456 = (_e4438[2] + ((_e4444[2] - _e4438[2]) * _e4393));
                                    let _e4461 = (((_e4433 * _e4433) + (_e4434 * _e4434)) + (_e4435 * _e4435));
                                    let _e4466 = (((_e4433 * _e4454) + (_e4434 * _e4455)) + (_e4435 * _e4456));
                                    let _e4471 = (((_e4454 * _e4454) + (_e4455 * _e4455)) + (_e4456 * _e4456));
                                    let _e4476 = (((_e4412 * _e4433) + (_e4413 * _e4434)) + (_e4414 * _e4435));
                                    let _e4481 = (((_e4412 * _e4454) + (_e4413 * _e4455)) + (_e4414 * _e4456));
                                    let _e4484 = ((_e4461 * _e4471) - (_e4466 * _e4466));
                                    let _e4485 = f64(0f);
                                    let _e4486 = f64(1f);
                                    let _e4490 = (((_e4476 * _e4471) - (_e4481 * _e4466)) / _e4484);
                                    let _e4494 = (((_e4481 * _e4461) - (_e4476 * _e4466)) / _e4484);
                                    if (_e4490 >= _e4485) {
                                        if (_e4494 >= _e4485) {
                                            if (_e4490 <= _e4486) {
                                                phi_3243_ = (_e4494 <= _e4486);
                                                phi_3244_ = false;
                                            } else {
                                                phi_3243_ = bool();
                                                phi_3244_ = true;
                                            }
                                            let _e4500 = phi_3243_;
                                            let _e4502 = phi_3244_;
                                            phi_3245_ = _e4500;
                                            phi_3246_ = _e4502;
                                        } else {
                                            phi_3245_ = bool();
                                            phi_3246_ = true;
                                        }
                                        let _e4504 = phi_3245_;
                                        let _e4506 = phi_3246_;
                                        phi_3247_ = _e4504;
                                        phi_3248_ = _e4506;
                                    } else {
                                        phi_3247_ = bool();
                                        phi_3248_ = true;
                                    }
                                    let _e4508 = phi_3247_;
                                    let _e4510 = phi_3248_;
                                    if _e4510 {
                                        phi_3252_ = false;
                                    } else {
                                        phi_3252_ = _e4508;
                                    }
                                    let _e4512 = phi_3252_;
                                    if (_e4484 > _e4485) {
                                        if _e4512 {
                                            phi_3292_ = array<f64, 3>((_e4412 - ((_e4433 * _e4490) + (_e4454 * _e4494))), (_e4413 - ((_e4434 * _e4490) + (_e4455 * _e4494))), (_e4414 - ((_e4435 * _e4490) + (_e4456 * _e4494))));
                                            phi_3293_ = false;
                                        } else {
                                            phi_3292_ = array<f64, 3>();
                                            phi_3293_ = true;
                                        }
                                        let _e4528 = phi_3292_;
                                        let _e4530 = phi_3293_;
                                        phi_3294_ = _e4528;
                                        phi_3295_ = _e4530;
                                    } else {
                                        phi_3294_ = array<f64, 3>();
                                        phi_3295_ = true;
                                    }
                                    let _e4532 = phi_3294_;
                                    let _e4534 = phi_3295_;
                                    if _e4534 {
                                        let _e4535 = (_e4412 - _e4433);
                                        let _e4536 = (_e4413 - _e4434);
                                        let _e4537 = (_e4414 - _e4435);
                                        let _e4548 = ((((_e4412 * _e4433) + (_e4413 * _e4434)) + (_e4414 * _e4435)) / (((_e4433 * _e4433) + (_e4434 * _e4434)) + (_e4435 * _e4435)));
                                        if (_e4548 > f64(0f)) {
                                            if (_e4548 < f64(1f)) {
                                                phi_3328_ = _e4548;
                                            } else {
                                                phi_3328_ = f64(1f);
                                            }
                                            let _e4556 = phi_3328_;
                                            phi_3330_ = _e4556;
                                        } else {
                                            phi_3330_ = f64(0f);
                                        }
                                        let _e4558 = phi_3330_;
                                        let _e4575 = ((((_e4412 * _e4454) + (_e4413 * _e4455)) + (_e4414 * _e4456)) / (((_e4454 * _e4454) + (_e4455 * _e4455)) + (_e4456 * _e4456)));
                                        if (_e4575 > f64(0f)) {
                                            if (_e4575 < f64(1f)) {
                                                phi_3360_ = _e4575;
                                            } else {
                                                phi_3360_ = f64(1f);
                                            }
                                            let _e4583 = phi_3360_;
                                            phi_3362_ = _e4583;
                                        } else {
                                            phi_3362_ = f64(0f);
                                        }
                                        let _e4585 = phi_3362_;
                                        let _e4602 = ((((_e4535 * _e4454) + (_e4536 * _e4455)) + (_e4537 * _e4456)) / (((_e4454 * _e4454) + (_e4455 * _e4455)) + (_e4456 * _e4456)));
                                        if (_e4602 > f64(0f)) {
                                            if (_e4602 < f64(1f)) {
                                                phi_3392_ = _e4602;
                                            } else {
                                                phi_3392_ = f64(1f);
                                            }
                                            let _e4610 = phi_3392_;
                                            phi_3394_ = _e4610;
                                        } else {
                                            phi_3394_ = f64(0f);
                                        }
                                        let _e4612 = phi_3394_;
                                        let _e4619 = (_e4412 - _e4454);
                                        let _e4620 = (_e4413 - _e4455);
                                        let _e4621 = (_e4414 - _e4456);
                                        let _e4632 = ((((_e4619 * _e4433) + (_e4620 * _e4434)) + (_e4621 * _e4435)) / (((_e4433 * _e4433) + (_e4434 * _e4434)) + (_e4435 * _e4435)));
                                        if (_e4632 > f64(0f)) {
                                            if (_e4632 < f64(1f)) {
                                                phi_3427_ = _e4632;
                                            } else {
                                                phi_3427_ = f64(1f);
                                            }
                                            let _e4640 = phi_3427_;
                                            phi_3429_ = _e4640;
                                        } else {
                                            phi_3429_ = f64(0f);
                                        }
                                        let _e4642 = phi_3429_;
                                        local_10[0u] = array<f64, 3>((_e4412 - (_e4433 * _e4558)), (_e4413 - (_e4434 * _e4558)), (_e4414 - (_e4435 * _e4558)));
                                        local_10[1u] = array<f64, 3>((_e4412 - (_e4454 * _e4585)), (_e4413 - (_e4455 * _e4585)), (_e4414 - (_e4456 * _e4585)));
                                        local_10[2u] = array<f64, 3>((_e4535 - (_e4454 * _e4612)), (_e4536 - (_e4455 * _e4612)), (_e4537 - (_e4456 * _e4612)));
                                        local_10[3u] = array<f64, 3>((_e4619 - (_e4433 * _e4642)), (_e4620 - (_e4434 * _e4642)), (_e4621 - (_e4435 * _e4642)));
                                        let _e4658 = local_10[0u];
                                        phi_3584_ = type_28(1u, 4u);
                                        phi_3587_ = array<f64, 3>(_e4658[0], _e4658[1], _e4658[2]);
                                        loop {
                                            let _e4664 = phi_3584_;
                                            let _e4666 = phi_3587_;
                                            local_89 = _e4666;
                                            if (_e4664.member < _e4664.member_1) {
                                                phi_3585_ = type_28((_e4664.member + 1u), _e4664.member_1);
                                                phi_3610_ = type_28(1u, _e4664.member);
                                            } else {
                                                phi_3585_ = _e4664;
                                                phi_3610_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4680 = phi_3585_;
                                            let _e4682 = phi_3610_;
                                            let _e4686 = (bitcast<i32>(_e4682.member) != 0i);
                                            if _e4686 {
                                                if (_e4682.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4689 = local_10[_e4682.member_1];
                                                if (_e4682.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4695 = local_10[_e4682.member_1];
                                                if ((((_e4689[0] * _e4695[0]) + (_e4689[1] * _e4695[1])) + (_e4689[2] * _e4695[2])) < (((_e4666[0] * _e4666[0]) + (_e4666[1] * _e4666[1])) + (_e4666[2] * _e4666[2]))) {
                                                    if (_e4682.member_1 < 4u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e4718 = local_10[_e4682.member_1];
                                                    phi_3677_ = array<f64, 3>(_e4718[0], _e4718[1], _e4718[2]);
                                                } else {
                                                    phi_3677_ = _e4666;
                                                }
                                                let _e4724 = phi_3677_;
                                                phi_3588_ = _e4724;
                                            } else {
                                                phi_3588_ = array<f64, 3>();
                                            }
                                            let _e4726 = phi_3588_;
                                            continue;
                                            continuing {
                                                phi_3584_ = _e4680;
                                                phi_3587_ = _e4726;
                                                break if !(_e4686);
                                            }
                                        }
                                        let _e5928 = local_89;
                                        phi_3678_ = _e5928;
                                    } else {
                                        phi_3678_ = _e4532;
                                    }
                                    let _e4729 = phi_3678_;
                                    let _e4740 = (((_e4729[0] * _e4729[0]) + (_e4729[1] * _e4729[1])) + (_e4729[2] * _e4729[2]));
                                    if (_e4740 <= 2.2250738585072014e-308lf) {
                                        if (_e4740 > 0.0lf) {
                                            phi_3703_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3703_ = 0.0lf;
                                        }
                                        let _e4798 = phi_3703_;
                                        phi_3767_ = _e4798;
                                    } else {
                                        phi_3710_ = type_26(0i, 5i);
                                        phi_3713_ = bitcast<f64>(((bitcast<u64>(_e4740) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e4747 = phi_3710_;
                                            let _e4749 = phi_3713_;
                                            local_49 = _e4749;
                                            if (_e4747.member < _e4747.member_1) {
                                                let _e4757 = (_e4747.member + 1i);
                                                if ((false == (_e4757 > _e4747.member)) != false) {
                                                    phi_3734_ = true;
                                                } else {
                                                    phi_3734_ = false;
                                                }
                                                let _e4762 = phi_3734_;
                                                if _e4762 {
                                                    phi_3740_ = type_27(0u, type_27().member_1);
                                                } else {
                                                    phi_3740_ = type_27(1u, _e4757);
                                                }
                                                let _e4768 = phi_3740_;
                                                if (bitcast<i32>(_e4768.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3711_ = type_26(_e4768.member_1, _e4747.member_1);
                                                phi_3754_ = type_27(1u, _e4747.member);
                                            } else {
                                                phi_3711_ = _e4747;
                                                phi_3754_ = type_27(0u, type_27().member_1);
                                            }
                                            let _e4778 = phi_3711_;
                                            let _e4780 = phi_3754_;
                                            let _e4783 = (bitcast<i32>(_e4780.member) != 0i);
                                            if _e4783 {
                                                phi_3714_ = (0.5lf * (_e4749 + (_e4740 / _e4749)));
                                            } else {
                                                phi_3714_ = f64();
                                            }
                                            let _e4788 = phi_3714_;
                                            continue;
                                            continuing {
                                                phi_3710_ = _e4778;
                                                phi_3713_ = _e4788;
                                                break if !(_e4783);
                                            }
                                        }
                                        let _e4793 = local_49;
                                        phi_3767_ = (_e4793 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e4800 = phi_3767_;
                                    let _e4808 = local_20.member[0u];
                                    if (_e4808[0] < 0.0lf) {
                                        phi_3785_ = -(_e4808[0]);
                                    } else {
                                        phi_3785_ = _e4808[0];
                                    }
                                    let _e4815 = phi_3785_;
                                    if (_e4808[1] < 0.0lf) {
                                        phi_3792_ = -(_e4808[1]);
                                    } else {
                                        phi_3792_ = _e4808[1];
                                    }
                                    let _e4819 = phi_3792_;
                                    if (_e4815 > _e4819) {
                                        phi_3797_ = _e4815;
                                    } else {
                                        phi_3797_ = _e4819;
                                    }
                                    let _e4822 = phi_3797_;
                                    if (_e4808[2] < 0.0lf) {
                                        phi_3804_ = -(_e4808[2]);
                                    } else {
                                        phi_3804_ = _e4808[2];
                                    }
                                    let _e4826 = phi_3804_;
                                    if (_e4822 > _e4826) {
                                        phi_3809_ = _e4822;
                                    } else {
                                        phi_3809_ = _e4826;
                                    }
                                    let _e4829 = phi_3809_;
                                    let _e4832 = local_20.member[1u];
                                    if (_e4832[0] < 0.0lf) {
                                        phi_3822_ = -(_e4832[0]);
                                    } else {
                                        phi_3822_ = _e4832[0];
                                    }
                                    let _e4839 = phi_3822_;
                                    if (_e4832[1] < 0.0lf) {
                                        phi_3829_ = -(_e4832[1]);
                                    } else {
                                        phi_3829_ = _e4832[1];
                                    }
                                    let _e4843 = phi_3829_;
                                    if (_e4839 > _e4843) {
                                        phi_3834_ = _e4839;
                                    } else {
                                        phi_3834_ = _e4843;
                                    }
                                    let _e4846 = phi_3834_;
                                    if (_e4832[2] < 0.0lf) {
                                        phi_3841_ = -(_e4832[2]);
                                    } else {
                                        phi_3841_ = _e4832[2];
                                    }
                                    let _e4850 = phi_3841_;
                                    if (_e4846 > _e4850) {
                                        phi_3846_ = _e4846;
                                    } else {
                                        phi_3846_ = _e4850;
                                    }
                                    let _e4853 = phi_3846_;
                                    if (_e4829 > _e4853) {
                                        phi_3851_ = _e4829;
                                    } else {
                                        phi_3851_ = _e4853;
                                    }
                                    let _e4856 = phi_3851_;
                                    let _e4858 = local_20.member_3;
                                    let _e4862 = local_20.member_1[0u];
                                    if (_e4862[0] < 0.0lf) {
                                        phi_3868_ = -(_e4862[0]);
                                    } else {
                                        phi_3868_ = _e4862[0];
                                    }
                                    let _e4869 = phi_3868_;
                                    if (_e4862[1] < 0.0lf) {
                                        phi_3875_ = -(_e4862[1]);
                                    } else {
                                        phi_3875_ = _e4862[1];
                                    }
                                    let _e4873 = phi_3875_;
                                    if (_e4869 > _e4873) {
                                        phi_3880_ = _e4869;
                                    } else {
                                        phi_3880_ = _e4873;
                                    }
                                    let _e4876 = phi_3880_;
                                    if (_e4862[2] < 0.0lf) {
                                        phi_3887_ = -(_e4862[2]);
                                    } else {
                                        phi_3887_ = _e4862[2];
                                    }
                                    let _e4880 = phi_3887_;
                                    if (_e4876 > _e4880) {
                                        phi_3892_ = _e4876;
                                    } else {
                                        phi_3892_ = _e4880;
                                    }
                                    let _e4883 = phi_3892_;
                                    let _e4886 = local_20.member_1[1u];
                                    if (_e4886[0] < 0.0lf) {
                                        phi_3906_ = -(_e4886[0]);
                                    } else {
                                        phi_3906_ = _e4886[0];
                                    }
                                    let _e4893 = phi_3906_;
                                    if (_e4886[1] < 0.0lf) {
                                        phi_3913_ = -(_e4886[1]);
                                    } else {
                                        phi_3913_ = _e4886[1];
                                    }
                                    let _e4897 = phi_3913_;
                                    if (_e4893 > _e4897) {
                                        phi_3918_ = _e4893;
                                    } else {
                                        phi_3918_ = _e4897;
                                    }
                                    let _e4900 = phi_3918_;
                                    if (_e4886[2] < 0.0lf) {
                                        phi_3925_ = -(_e4886[2]);
                                    } else {
                                        phi_3925_ = _e4886[2];
                                    }
                                    let _e4904 = phi_3925_;
                                    if (_e4900 > _e4904) {
                                        phi_3930_ = _e4900;
                                    } else {
                                        phi_3930_ = _e4904;
                                    }
                                    let _e4907 = phi_3930_;
                                    if (_e4883 > _e4907) {
                                        phi_3935_ = _e4883;
                                    } else {
                                        phi_3935_ = _e4907;
                                    }
                                    let _e4910 = phi_3935_;
                                    let _e4912 = local_20.member_3;
                                    let _e4916 = local_20.member_2[0u];
                                    if (_e4916[0] < 0.0lf) {
                                        phi_3952_ = -(_e4916[0]);
                                    } else {
                                        phi_3952_ = _e4916[0];
                                    }
                                    let _e4923 = phi_3952_;
                                    if (_e4916[1] < 0.0lf) {
                                        phi_3959_ = -(_e4916[1]);
                                    } else {
                                        phi_3959_ = _e4916[1];
                                    }
                                    let _e4927 = phi_3959_;
                                    if (_e4923 > _e4927) {
                                        phi_3964_ = _e4923;
                                    } else {
                                        phi_3964_ = _e4927;
                                    }
                                    let _e4930 = phi_3964_;
                                    if (_e4916[2] < 0.0lf) {
                                        phi_3971_ = -(_e4916[2]);
                                    } else {
                                        phi_3971_ = _e4916[2];
                                    }
                                    let _e4934 = phi_3971_;
                                    if (_e4930 > _e4934) {
                                        phi_3976_ = _e4930;
                                    } else {
                                        phi_3976_ = _e4934;
                                    }
                                    let _e4937 = phi_3976_;
                                    let _e4940 = local_20.member_2[1u];
                                    if (_e4940[0] < 0.0lf) {
                                        phi_3990_ = -(_e4940[0]);
                                    } else {
                                        phi_3990_ = _e4940[0];
                                    }
                                    let _e4947 = phi_3990_;
                                    if (_e4940[1] < 0.0lf) {
                                        phi_3997_ = -(_e4940[1]);
                                    } else {
                                        phi_3997_ = _e4940[1];
                                    }
                                    let _e4951 = phi_3997_;
                                    if (_e4947 > _e4951) {
                                        phi_4002_ = _e4947;
                                    } else {
                                        phi_4002_ = _e4951;
                                    }
                                    let _e4954 = phi_4002_;
                                    if (_e4940[2] < 0.0lf) {
                                        phi_4009_ = -(_e4940[2]);
                                    } else {
                                        phi_4009_ = _e4940[2];
                                    }
                                    let _e4958 = phi_4009_;
                                    if (_e4954 > _e4958) {
                                        phi_4014_ = _e4954;
                                    } else {
                                        phi_4014_ = _e4958;
                                    }
                                    let _e4961 = phi_4014_;
                                    if (_e4937 > _e4961) {
                                        phi_4019_ = _e4937;
                                    } else {
                                        phi_4019_ = _e4961;
                                    }
                                    let _e4964 = phi_4019_;
                                    let _e4966 = local_20.member_3;
                                    let _e4974 = local_20.member_3;
                                    let _e4984 = (((_e4800 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e4856 + _e4858) + (_e4910 + _e4912)) + (_e4964 + _e4966)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4974 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e446);
                                    if _e4984 {
                                        phi_4043_ = false;
                                    } else {
                                        phi_4043_ = true;
                                    }
                                    let _e4986 = phi_4043_;
                                    phi_4044_ = _e4986;
                                    phi_4045_ = _e4984;
                                } else {
                                    phi_4044_ = false;
                                    phi_4045_ = false;
                                }
                                let _e4988 = phi_4044_;
                                let _e4990 = phi_4045_;
                                local_50 = _e4990;
                                continue;
                                continuing {
                                    phi_3048_ = _e4379;
                                    break if !(_e4988);
                                }
                            }
                            let _e4993 = local_50;
                            if _e4993 {
                                phi_4050_ = type_72(1u, _e4352.member_1);
                                phi_4051_ = false;
                            } else {
                                phi_4050_ = type_72();
                                phi_4051_ = true;
                            }
                            let _e4996 = phi_4050_;
                            let _e4998 = phi_4051_;
                            if _e4998 {
                                phi_4056_ = type_72(2u, _e4352.member_1);
                                phi_4057_ = false;
                            } else {
                                phi_4056_ = type_72();
                                phi_4057_ = true;
                            }
                            let _e5001 = phi_4056_;
                            let _e5003 = phi_4057_;
                            phi_4059_ = _e5001;
                            phi_4060_ = _e4996;
                            phi_4061_ = _e5003;
                        } else {
                            phi_4059_ = type_72();
                            phi_4060_ = type_72(0u, type_72().member_1);
                            phi_4061_ = true;
                        }
                        let _e5005 = phi_4059_;
                        let _e5007 = phi_4060_;
                        let _e5009 = phi_4061_;
                        if _e5009 {
                            phi_4065_ = _e5007;
                        } else {
                            phi_4065_ = _e5005;
                        }
                        let _e5011 = phi_4065_;
                        phi_7436_ = _e5011;
                    } else {
                        if (_e545 < 0.0lf) {
                            phi_4076_ = -(_e545);
                        } else {
                            phi_4076_ = _e545;
                        }
                        let _e900 = phi_4076_;
                        if (_e568 < 0.0lf) {
                            phi_4082_ = -(_e568);
                        } else {
                            phi_4082_ = _e568;
                        }
                        let _e904 = phi_4082_;
                        if (_e900 > _e904) {
                            phi_4087_ = _e900;
                        } else {
                            phi_4087_ = _e904;
                        }
                        let _e907 = phi_4087_;
                        if (_e591 < 0.0lf) {
                            phi_4093_ = -(_e591);
                        } else {
                            phi_4093_ = _e591;
                        }
                        let _e911 = phi_4093_;
                        if (_e602 < 0.0lf) {
                            phi_4099_ = -(_e602);
                        } else {
                            phi_4099_ = _e602;
                        }
                        let _e915 = phi_4099_;
                        if (_e911 > _e915) {
                            phi_4104_ = _e911;
                        } else {
                            phi_4104_ = _e915;
                        }
                        let _e918 = phi_4104_;
                        if (_e907 > _e918) {
                            phi_4109_ = _e907;
                        } else {
                            phi_4109_ = _e918;
                        }
                        let _e921 = phi_4109_;
                        let _e923 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e924 = f64(1f);
                        if (_e921 >= _e923) {
                            phi_4119_ = (_e921 <= (_e924 / _e923));
                        } else {
                            phi_4119_ = false;
                        }
                        let _e929 = phi_4119_;
                        if _e929 {
                            phi_4126_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_4126_ = f64(2f);
                        }
                        let _e934 = phi_4126_;
                        let _e936 = ((_e861 * f64(0.34f)) + (_e921 * _e934));
                        if _e929 {
                            phi_4134_ = (_e924 / _e921);
                        } else {
                            phi_4134_ = f64(0f);
                        }
                        let _e940 = phi_4134_;
                        let _e941 = f64(0f);
                        let _e942 = f64(1f);
                        let _e943 = f64(3f);
                        let _e949 = ((_e568 - (_e943 * _e545)) * _e940);
                        let _e950 = ((_e591 - _e568) * _e940);
                        let _e951 = (((_e943 * _e602) - _e591) * _e940);
                        local_7[0u] = _e941;
                        local_7[1u] = _e942;
                        local_7[2u] = _e942;
                        local_7[3u] = _e942;
                        let _e958 = ((_e950 * _e950) - (_e949 * _e951));
                        if (_e958 > _e941) {
                            if (_e958 <= 2.2250738585072014e-308lf) {
                                if (_e958 > 0.0lf) {
                                    phi_4170_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4170_ = 0.0lf;
                                }
                                let _e1017 = phi_4170_;
                                phi_4234_ = _e1017;
                            } else {
                                phi_4177_ = type_26(0i, 5i);
                                phi_4180_ = bitcast<f64>(((bitcast<u64>(_e958) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e966 = phi_4177_;
                                    let _e968 = phi_4180_;
                                    local_21 = _e968;
                                    if (_e966.member < _e966.member_1) {
                                        let _e976 = (_e966.member + 1i);
                                        if ((false == (_e976 > _e966.member)) != false) {
                                            phi_4201_ = true;
                                        } else {
                                            phi_4201_ = false;
                                        }
                                        let _e981 = phi_4201_;
                                        if _e981 {
                                            phi_4207_ = type_27(0u, type_27().member_1);
                                        } else {
                                            phi_4207_ = type_27(1u, _e976);
                                        }
                                        let _e987 = phi_4207_;
                                        if (bitcast<i32>(_e987.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_4178_ = type_26(_e987.member_1, _e966.member_1);
                                        phi_4221_ = type_27(1u, _e966.member);
                                    } else {
                                        phi_4178_ = _e966;
                                        phi_4221_ = type_27(0u, type_27().member_1);
                                    }
                                    let _e997 = phi_4178_;
                                    let _e999 = phi_4221_;
                                    let _e1002 = (bitcast<i32>(_e999.member) != 0i);
                                    if _e1002 {
                                        phi_4181_ = (0.5lf * (_e968 + (_e958 / _e968)));
                                    } else {
                                        phi_4181_ = f64();
                                    }
                                    let _e1007 = phi_4181_;
                                    continue;
                                    continuing {
                                        phi_4177_ = _e997;
                                        phi_4180_ = _e1007;
                                        break if !(_e1002);
                                    }
                                }
                                let _e1012 = local_21;
                                phi_4234_ = (_e1012 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1019 = phi_4234_;
                            if (_e950 < _e941) {
                                phi_4240_ = -(_e1019);
                            } else {
                                phi_4240_ = _e1019;
                            }
                            let _e1023 = phi_4240_;
                            let _e1025 = -((_e950 + _e1023));
                            local_8[0u] = (_e1025 / (_e1025 + _e951));
                            local_8[1u] = (_e949 / (_e949 + _e1025));
                            let _e1034 = local_8[1u];
                            let _e1035 = local_8[0u];
                            if (_e1034 < _e1035) {
                                let _e1038 = local_8[1u];
                                let _e1040 = local_8[0u];
                                local_8[0u] = _e1038;
                                local_8[1u] = _e1040;
                            }
                            phi_4265_ = type_28(0u, 2u);
                            phi_4268_ = 1u;
                            loop {
                                let _e1044 = phi_4265_;
                                let _e1046 = phi_4268_;
                                local_51 = _e1046;
                                if (_e1044.member < _e1044.member_1) {
                                    phi_4266_ = type_28((_e1044.member + 1u), _e1044.member_1);
                                    phi_4291_ = type_28(1u, _e1044.member);
                                } else {
                                    phi_4266_ = _e1044;
                                    phi_4291_ = type_28(0u, type_28().member_1);
                                }
                                let _e1060 = phi_4266_;
                                let _e1062 = phi_4291_;
                                let _e1066 = (bitcast<i32>(_e1062.member) != 0i);
                                if _e1066 {
                                    if (_e1062.member_1 < 2u) {
                                    } else {
                                        return;
                                    }
                                    let _e1069 = local_8[_e1062.member_1];
                                    if (_e1069 > _e941) {
                                        if (_e1062.member_1 < 2u) {
                                        } else {
                                            return;
                                        }
                                        let _e1073 = local_8[_e1062.member_1];
                                        if (_e1073 < _e942) {
                                            if (_e1062.member_1 < 2u) {
                                            } else {
                                                return;
                                            }
                                            let _e1077 = local_8[_e1062.member_1];
                                            if (_e1046 < 4u) {
                                            } else {
                                                return;
                                            }
                                            local_7[_e1046] = _e1077;
                                            phi_4335_ = (_e1046 + 1u);
                                        } else {
                                            phi_4335_ = _e1046;
                                        }
                                        let _e1082 = phi_4335_;
                                        phi_4336_ = _e1082;
                                    } else {
                                        phi_4336_ = _e1046;
                                    }
                                    let _e1084 = phi_4336_;
                                    phi_4269_ = _e1084;
                                } else {
                                    phi_4269_ = u32();
                                }
                                let _e1086 = phi_4269_;
                                continue;
                                continuing {
                                    phi_4265_ = _e1060;
                                    phi_4268_ = _e1086;
                                    break if !(_e1066);
                                }
                            }
                            let _e5206 = local_51;
                            phi_4337_ = _e5206;
                        } else {
                            phi_4337_ = 1u;
                        }
                        let _e1089 = phi_4337_;
                        if (_e1089 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e1089] = _e942;
                        let _e1092 = local_7;
                        local_9 = _e1092;
                        phi_4357_ = type_28(0u, _e1089);
                        loop {
                            let _e1095 = phi_4357_;
                            if (_e1095.member < _e1095.member_1) {
                                phi_4358_ = type_28((_e1095.member + 1u), _e1095.member_1);
                                phi_4381_ = type_28(1u, _e1095.member);
                            } else {
                                phi_4358_ = _e1095;
                                phi_4381_ = type_28(0u, type_28().member_1);
                            }
                            let _e1109 = phi_4358_;
                            let _e1111 = phi_4381_;
                            if (bitcast<i32>(_e1111.member) != 0i) {
                                if (_e1111.member_1 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1118 = local_9[_e1111.member_1];
                                let _e1119 = (_e1111.member_1 + 1u);
                                if (_e1119 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1122 = local_9[_e1119];
                                let _e1124 = (f64(1f) - _e1118);
                                let _e1135 = ((((_e545 * _e1124) + (_e568 * _e1118)) * (_e1124 * _e1124)) + (((_e591 * _e1124) + (_e602 * _e1118)) * (_e1118 * _e1118)));
                                let _e1137 = (f64(1f) - _e1122);
                                let _e1148 = ((((_e545 * _e1137) + (_e568 * _e1122)) * (_e1137 * _e1137)) + (((_e591 * _e1137) + (_e602 * _e1122)) * (_e1122 * _e1122)));
                                if (_e1135 < 0.0lf) {
                                    phi_4435_ = -(_e1135);
                                } else {
                                    phi_4435_ = _e1135;
                                }
                                let _e1152 = phi_4435_;
                                let _e1153 = (_e1152 > _e936);
                                if (_e1148 < 0.0lf) {
                                    phi_4442_ = -(_e1148);
                                } else {
                                    phi_4442_ = _e1148;
                                }
                                let _e1157 = phi_4442_;
                                let _e1158 = (_e1157 > _e936);
                                let _e1159 = f64(0f);
                                if _e1153 {
                                    if _e1158 {
                                        phi_4454_ = ((_e1135 > _e1159) != (_e1148 > _e1159));
                                        phi_4455_ = false;
                                    } else {
                                        phi_4454_ = bool();
                                        phi_4455_ = true;
                                    }
                                    let _e1164 = phi_4454_;
                                    let _e1166 = phi_4455_;
                                    phi_4456_ = _e1164;
                                    phi_4457_ = _e1166;
                                } else {
                                    phi_4456_ = bool();
                                    phi_4457_ = true;
                                }
                                let _e1168 = phi_4456_;
                                let _e1170 = phi_4457_;
                                if _e1170 {
                                    phi_4461_ = false;
                                } else {
                                    phi_4461_ = _e1168;
                                }
                                let _e1172 = phi_4461_;
                                if _e1153 {
                                    if _e1158 {
                                        if _e1172 {
                                            phi_4473_ = type_73();
                                        } else {
                                            phi_4473_ = type_73(f64(1f), _e1159, _e1172);
                                        }
                                        let _e1176 = phi_4473_;
                                        phi_4474_ = _e1176;
                                        phi_4475_ = _e1172;
                                    } else {
                                        phi_4474_ = type_73();
                                        phi_4475_ = true;
                                    }
                                    let _e1178 = phi_4474_;
                                    let _e1180 = phi_4475_;
                                    phi_4476_ = _e1178;
                                    phi_4477_ = _e1180;
                                } else {
                                    phi_4476_ = type_73();
                                    phi_4477_ = true;
                                }
                                let _e1182 = phi_4476_;
                                let _e1184 = phi_4477_;
                                if _e1184 {
                                    if _e1153 {
                                        if (_e1135 < _e1159) {
                                            phi_4490_ = f64(-1f);
                                        } else {
                                            phi_4490_ = f64(1f);
                                        }
                                        let _e1189 = phi_4490_;
                                        let _e1190 = f64(0.00000000000022737368f);
                                        let _e1191 = f64(0.5f);
                                        let _e1192 = f64(3f);
                                        let _e1195 = (_e591 - _e568);
                                        phi_4503_ = type_28(0u, 64u);
                                        phi_4506_ = _e1122;
                                        phi_4508_ = _e1118;
                                        phi_4510_ = (_e1191 * (_e1118 + _e1122));
                                        loop {
                                            let _e1201 = phi_4503_;
                                            let _e1203 = phi_4506_;
                                            let _e1205 = phi_4508_;
                                            let _e1207 = phi_4510_;
                                            local_53 = _e1205;
                                            if (_e1201.member < _e1201.member_1) {
                                                phi_4504_ = type_28((_e1201.member + 1u), _e1201.member_1);
                                                phi_4533_ = type_28(1u, _e1201.member);
                                            } else {
                                                phi_4504_ = _e1201;
                                                phi_4533_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1221 = phi_4504_;
                                            let _e1223 = phi_4533_;
                                            if (bitcast<i32>(_e1223.member) != 0i) {
                                                let _e1228 = (f64(1f) - _e1207);
                                                let _e1241 = ((_e1189 * ((((_e545 * _e1228) + (_e568 * _e1207)) * (_e1228 * _e1228)) + (((_e591 * _e1228) + (_e602 * _e1207)) * (_e1207 * _e1207)))) - _e936);
                                                if (_e1241 > f64(0f)) {
                                                    phi_4560_ = _e1203;
                                                    phi_4561_ = _e1207;
                                                } else {
                                                    phi_4560_ = _e1207;
                                                    phi_4561_ = _e1205;
                                                }
                                                let _e1245 = phi_4560_;
                                                let _e1247 = phi_4561_;
                                                let _e1249 = ((_e1245 - _e1247) > _e1190);
                                                if _e1249 {
                                                    let _e1251 = (f64(1f) - _e1207);
                                                    let _e1263 = (-(_e1241) / (_e1189 * (((((_e568 - (_e1192 * _e545)) * _e1251) + (_e1195 * _e1207)) * _e1251) + (((_e1195 * _e1251) + (((_e1192 * _e602) - _e591) * _e1207)) * _e1207))));
                                                    if (_e1241 > f64(0f)) {
                                                        phi_4589_ = (_e1191 * _e1190);
                                                    } else {
                                                        phi_4589_ = -((_e1191 * _e1190));
                                                    }
                                                    let _e1270 = phi_4589_;
                                                    let _e1272 = ((_e1207 + _e1263) + _e1270);
                                                    if (_e1272 > _e1247) {
                                                        if (_e1272 < _e1245) {
                                                            if (_e1263 < 0.0lf) {
                                                                phi_4605_ = -(_e1263);
                                                            } else {
                                                                phi_4605_ = _e1263;
                                                            }
                                                            let _e1278 = phi_4605_;
                                                            if (_e1278 < (_e1191 * (_e1245 - _e1247))) {
                                                                phi_4612_ = false;
                                                            } else {
                                                                phi_4612_ = true;
                                                            }
                                                            let _e1283 = phi_4612_;
                                                            phi_4613_ = _e1283;
                                                        } else {
                                                            phi_4613_ = true;
                                                        }
                                                        let _e1285 = phi_4613_;
                                                        phi_4614_ = _e1285;
                                                    } else {
                                                        phi_4614_ = true;
                                                    }
                                                    let _e1287 = phi_4614_;
                                                    if _e1287 {
                                                        phi_4620_ = (_e1191 * (_e1247 + _e1245));
                                                    } else {
                                                        phi_4620_ = _e1272;
                                                    }
                                                    let _e1291 = phi_4620_;
                                                    phi_4621_ = _e1291;
                                                    phi_4622_ = false;
                                                } else {
                                                    phi_4621_ = f64();
                                                    phi_4622_ = true;
                                                }
                                                let _e1293 = phi_4621_;
                                                let _e1295 = phi_4622_;
                                                phi_4507_ = _e1245;
                                                phi_4509_ = _e1247;
                                                phi_4511_ = _e1293;
                                                phi_4623_ = _e1247;
                                                phi_4624_ = _e1249;
                                                phi_4625_ = _e1295;
                                            } else {
                                                phi_4507_ = f64();
                                                phi_4509_ = f64();
                                                phi_4511_ = f64();
                                                phi_4623_ = f64();
                                                phi_4624_ = false;
                                                phi_4625_ = false;
                                            }
                                            let _e1297 = phi_4507_;
                                            let _e1299 = phi_4509_;
                                            let _e1301 = phi_4511_;
                                            let _e1303 = phi_4623_;
                                            let _e1305 = phi_4624_;
                                            let _e1307 = phi_4625_;
                                            local_22 = _e1307;
                                            local_52 = _e1303;
                                            continue;
                                            continuing {
                                                phi_4503_ = _e1221;
                                                phi_4506_ = _e1297;
                                                phi_4508_ = _e1299;
                                                phi_4510_ = _e1301;
                                                break if !(_e1305);
                                            }
                                        }
                                        let _e1310 = local_22;
                                        if _e1310 {
                                            let _e5248 = local_52;
                                            phi_4629_ = _e5248;
                                        } else {
                                            let _e5250 = local_53;
                                            phi_4629_ = _e5250;
                                        }
                                        let _e1312 = phi_4629_;
                                        phi_4630_ = _e1312;
                                    } else {
                                        phi_4630_ = _e1118;
                                    }
                                    let _e1314 = phi_4630_;
                                    if _e1158 {
                                        phi_4638_ = type_28(0u, 64u);
                                        phi_4641_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1318 = phi_4638_;
                                            let _e1320 = phi_4641_;
                                            if (_e1318.member < _e1318.member_1) {
                                                phi_4639_ = type_28((_e1318.member + 1u), _e1318.member_1);
                                                phi_4664_ = type_28(1u, _e1318.member);
                                            } else {
                                                phi_4639_ = _e1318;
                                                phi_4664_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1334 = phi_4639_;
                                            let _e1336 = phi_4664_;
                                            if (bitcast<i32>(_e1336.member) != 0i) {
                                                let _e1340 = (_e1314 + _e1320);
                                                if (_e1340 < _e1122) {
                                                    let _e1343 = (f64(1f) - _e1340);
                                                    let _e1354 = ((((_e545 * _e1343) + (_e568 * _e1340)) * (_e1343 * _e1343)) + (((_e591 * _e1343) + (_e602 * _e1340)) * (_e1340 * _e1340)));
                                                    let _e1356 = (f64(1f) - _e1314);
                                                    let _e1367 = ((((_e545 * _e1356) + (_e568 * _e1314)) * (_e1356 * _e1356)) + (((_e591 * _e1356) + (_e602 * _e1314)) * (_e1314 * _e1314)));
                                                    if (_e1354 < 0.0lf) {
                                                        phi_4707_ = -(_e1354);
                                                    } else {
                                                        phi_4707_ = _e1354;
                                                    }
                                                    let _e1371 = phi_4707_;
                                                    if (_e1371 > _e936) {
                                                        if (_e1367 < 0.0lf) {
                                                            phi_4717_ = -(_e1367);
                                                        } else {
                                                            phi_4717_ = _e1367;
                                                        }
                                                        let _e1376 = phi_4717_;
                                                        if (_e1376 > _e936) {
                                                            phi_4727_ = ((_e1354 > f64(0f)) == (_e1367 > f64(0f)));
                                                        } else {
                                                            phi_4727_ = false;
                                                        }
                                                        let _e1384 = phi_4727_;
                                                        phi_4729_ = !(_e1384);
                                                    } else {
                                                        phi_4729_ = false;
                                                    }
                                                    let _e1387 = phi_4729_;
                                                    if _e1387 {
                                                        phi_4734_ = f64();
                                                        phi_4735_ = false;
                                                    } else {
                                                        phi_4734_ = (_e1320 + _e1320);
                                                        phi_4735_ = true;
                                                    }
                                                    let _e1390 = phi_4734_;
                                                    let _e1392 = phi_4735_;
                                                    phi_4736_ = _e1390;
                                                    phi_4737_ = _e1392;
                                                    phi_4738_ = _e1387;
                                                    phi_4739_ = false;
                                                } else {
                                                    phi_4736_ = f64();
                                                    phi_4737_ = false;
                                                    phi_4738_ = false;
                                                    phi_4739_ = true;
                                                }
                                                let _e1394 = phi_4736_;
                                                let _e1396 = phi_4737_;
                                                let _e1398 = phi_4738_;
                                                let _e1400 = phi_4739_;
                                                phi_4740_ = _e1340;
                                                phi_4642_ = _e1394;
                                                phi_4741_ = _e1396;
                                                phi_4742_ = _e1398;
                                                phi_4743_ = _e1400;
                                                phi_4744_ = false;
                                            } else {
                                                phi_4740_ = f64();
                                                phi_4642_ = f64();
                                                phi_4741_ = false;
                                                phi_4742_ = false;
                                                phi_4743_ = false;
                                                phi_4744_ = true;
                                            }
                                            let _e1402 = phi_4740_;
                                            let _e1404 = phi_4642_;
                                            let _e1406 = phi_4741_;
                                            let _e1408 = phi_4742_;
                                            let _e1410 = phi_4743_;
                                            let _e1412 = phi_4744_;
                                            local_23 = _e1408;
                                            local_54 = _e1410;
                                            local_55 = _e1412;
                                            local_56 = _e1402;
                                            continue;
                                            continuing {
                                                phi_4638_ = _e1334;
                                                phi_4641_ = _e1404;
                                                break if !(_e1406);
                                            }
                                        }
                                        let _e1415 = local_23;
                                        if _e1415 {
                                            phi_4748_ = false;
                                            phi_4749_ = false;
                                        } else {
                                            let _e5275 = local_54;
                                            phi_4748_ = _e5275;
                                            let _e5278 = local_55;
                                            phi_4749_ = _e5278;
                                        }
                                        let _e1417 = phi_4748_;
                                        let _e1419 = phi_4749_;
                                        if _e1417 {
                                            phi_4753_ = true;
                                        } else {
                                            phi_4753_ = _e1419;
                                        }
                                        let _e1421 = phi_4753_;
                                        if _e1421 {
                                            phi_4757_ = _e1122;
                                        } else {
                                            let _e5282 = local_56;
                                            phi_4757_ = _e5282;
                                        }
                                        let _e1423 = phi_4757_;
                                        phi_4758_ = _e1423;
                                    } else {
                                        phi_4758_ = _e1122;
                                    }
                                    let _e1425 = phi_4758_;
                                    phi_4760_ = type_73(_e1314, _e1425, _e1172);
                                } else {
                                    phi_4760_ = _e1182;
                                }
                                let _e1428 = phi_4760_;
                                if (_e1428.member > _e1428.member_1) {
                                    phi_7392_ = f64();
                                    phi_7393_ = true;
                                    phi_7394_ = false;
                                    phi_7395_ = false;
                                    phi_7396_ = false;
                                } else {
                                    let _e1436 = ((_e1428.member_1 - _e1428.member) * f64(0.5f));
                                    let _e1437 = (_e1428.member + _e1436);
                                    let _e1440 = (_e1436 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1442 = local_20.member_3;
                                    let _e1445 = local_20.member[0u];
                                    if (_e1445[0] < 0.0lf) {
                                        phi_4791_ = -(_e1445[0]);
                                    } else {
                                        phi_4791_ = _e1445[0];
                                    }
                                    let _e1452 = phi_4791_;
                                    if (_e1445[1] < 0.0lf) {
                                        phi_4798_ = -(_e1445[1]);
                                    } else {
                                        phi_4798_ = _e1445[1];
                                    }
                                    let _e1456 = phi_4798_;
                                    if (_e1452 > _e1456) {
                                        phi_4803_ = _e1452;
                                    } else {
                                        phi_4803_ = _e1456;
                                    }
                                    let _e1459 = phi_4803_;
                                    if (_e1445[2] < 0.0lf) {
                                        phi_4810_ = -(_e1445[2]);
                                    } else {
                                        phi_4810_ = _e1445[2];
                                    }
                                    let _e1463 = phi_4810_;
                                    if (_e1459 > _e1463) {
                                        phi_4815_ = _e1459;
                                    } else {
                                        phi_4815_ = _e1463;
                                    }
                                    let _e1466 = phi_4815_;
                                    let _e1468 = local_20.member[1u];
                                    if (_e1468[0] < 0.0lf) {
                                        phi_4828_ = -(_e1468[0]);
                                    } else {
                                        phi_4828_ = _e1468[0];
                                    }
                                    let _e1475 = phi_4828_;
                                    if (_e1468[1] < 0.0lf) {
                                        phi_4835_ = -(_e1468[1]);
                                    } else {
                                        phi_4835_ = _e1468[1];
                                    }
                                    let _e1479 = phi_4835_;
                                    if (_e1475 > _e1479) {
                                        phi_4840_ = _e1475;
                                    } else {
                                        phi_4840_ = _e1479;
                                    }
                                    let _e1482 = phi_4840_;
                                    if (_e1468[2] < 0.0lf) {
                                        phi_4847_ = -(_e1468[2]);
                                    } else {
                                        phi_4847_ = _e1468[2];
                                    }
                                    let _e1486 = phi_4847_;
                                    if (_e1482 > _e1486) {
                                        phi_4852_ = _e1482;
                                    } else {
                                        phi_4852_ = _e1486;
                                    }
                                    let _e1489 = phi_4852_;
                                    if (_e1466 > _e1489) {
                                        phi_4857_ = _e1466;
                                    } else {
                                        phi_4857_ = _e1489;
                                    }
                                    let _e1492 = phi_4857_;
                                    let _e1495 = local_20.member[0u];
                                    let _e1500 = local_20.member[1u];
                                    let _e1510 = (_e1495[0] + ((_e1500[0] - _e1495[0]) * _e1437));
                                    let _e1511 = (_e1495[1] + ((_e1500[1] - _e1495[1]) * _e1437));
                                    let _e1512 = (_e1495[2] + ((_e1500[2] - _e1495[2]) * _e1437));
                                    let _e1514 = local_20.member[1u];
                                    let _e1519 = local_20.member[0u];
                                    let _e1523 = (_e1514[0] - _e1519[0]);
                                    let _e1524 = (_e1514[1] - _e1519[1]);
                                    let _e1525 = (_e1514[2] - _e1519[2]);
                                    if (_e1523 < 0.0lf) {
                                        phi_4916_ = -(_e1523);
                                    } else {
                                        phi_4916_ = _e1523;
                                    }
                                    let _e1529 = phi_4916_;
                                    if (_e1524 < 0.0lf) {
                                        phi_4922_ = -(_e1524);
                                    } else {
                                        phi_4922_ = _e1524;
                                    }
                                    let _e1533 = phi_4922_;
                                    if (_e1529 > _e1533) {
                                        phi_4927_ = _e1529;
                                    } else {
                                        phi_4927_ = _e1533;
                                    }
                                    let _e1536 = phi_4927_;
                                    if (_e1525 < 0.0lf) {
                                        phi_4933_ = -(_e1525);
                                    } else {
                                        phi_4933_ = _e1525;
                                    }
                                    let _e1540 = phi_4933_;
                                    if (_e1536 > _e1540) {
                                        phi_4938_ = _e1536;
                                    } else {
                                        phi_4938_ = _e1540;
                                    }
                                    let _e1543 = phi_4938_;
                                    let _e1551 = ((((_e1440 * _e1543) * f64(1.01f)) + ((_e1492 + _e1442) * (1.1102230246251565e-16lf * f64(8f)))) + _e1442);
                                    if (_e1510 < 0.0lf) {
                                        phi_4952_ = -(_e1510);
                                    } else {
                                        phi_4952_ = _e1510;
                                    }
                                    let _e1555 = phi_4952_;
                                    if (_e1511 < 0.0lf) {
                                        phi_4958_ = -(_e1511);
                                    } else {
                                        phi_4958_ = _e1511;
                                    }
                                    let _e1559 = phi_4958_;
                                    if (_e1555 > _e1559) {
                                        phi_4963_ = _e1555;
                                    } else {
                                        phi_4963_ = _e1559;
                                    }
                                    let _e1562 = phi_4963_;
                                    if (_e1512 < 0.0lf) {
                                        phi_4969_ = -(_e1512);
                                    } else {
                                        phi_4969_ = _e1512;
                                    }
                                    let _e1566 = phi_4969_;
                                    if (_e1562 > _e1566) {
                                        phi_4974_ = _e1562;
                                    } else {
                                        phi_4974_ = _e1566;
                                    }
                                    let _e1569 = phi_4974_;
                                    local_3 = type_51(array<f64, 3>(_e1510, _e1511, _e1512), _e1551, (_e1569 + _e1551));
                                    let _e1575 = local_20.member_3;
                                    let _e1577 = local_20.member_1[0u];
                                    if (_e1577[0] < 0.0lf) {
                                        phi_5000_ = -(_e1577[0]);
                                    } else {
                                        phi_5000_ = _e1577[0];
                                    }
                                    let _e1584 = phi_5000_;
                                    if (_e1577[1] < 0.0lf) {
                                        phi_5007_ = -(_e1577[1]);
                                    } else {
                                        phi_5007_ = _e1577[1];
                                    }
                                    let _e1588 = phi_5007_;
                                    if (_e1584 > _e1588) {
                                        phi_5012_ = _e1584;
                                    } else {
                                        phi_5012_ = _e1588;
                                    }
                                    let _e1591 = phi_5012_;
                                    if (_e1577[2] < 0.0lf) {
                                        phi_5019_ = -(_e1577[2]);
                                    } else {
                                        phi_5019_ = _e1577[2];
                                    }
                                    let _e1595 = phi_5019_;
                                    if (_e1591 > _e1595) {
                                        phi_5024_ = _e1591;
                                    } else {
                                        phi_5024_ = _e1595;
                                    }
                                    let _e1598 = phi_5024_;
                                    let _e1600 = local_20.member_1[1u];
                                    if (_e1600[0] < 0.0lf) {
                                        phi_5037_ = -(_e1600[0]);
                                    } else {
                                        phi_5037_ = _e1600[0];
                                    }
                                    let _e1607 = phi_5037_;
                                    if (_e1600[1] < 0.0lf) {
                                        phi_5044_ = -(_e1600[1]);
                                    } else {
                                        phi_5044_ = _e1600[1];
                                    }
                                    let _e1611 = phi_5044_;
                                    if (_e1607 > _e1611) {
                                        phi_5049_ = _e1607;
                                    } else {
                                        phi_5049_ = _e1611;
                                    }
                                    let _e1614 = phi_5049_;
                                    if (_e1600[2] < 0.0lf) {
                                        phi_5056_ = -(_e1600[2]);
                                    } else {
                                        phi_5056_ = _e1600[2];
                                    }
                                    let _e1618 = phi_5056_;
                                    if (_e1614 > _e1618) {
                                        phi_5061_ = _e1614;
                                    } else {
                                        phi_5061_ = _e1618;
                                    }
                                    let _e1621 = phi_5061_;
                                    if (_e1598 > _e1621) {
                                        phi_5066_ = _e1598;
                                    } else {
                                        phi_5066_ = _e1621;
                                    }
                                    let _e1624 = phi_5066_;
                                    let _e1627 = local_20.member_1[0u];
                                    let _e1632 = local_20.member_1[1u];
                                    let _e1642 = (_e1627[0] + ((_e1632[0] - _e1627[0]) * _e1437));
                                    let _e1643 = (_e1627[1] + ((_e1632[1] - _e1627[1]) * _e1437));
                                    let _e1644 = (_e1627[2] + ((_e1632[2] - _e1627[2]) * _e1437));
                                    let _e1646 = local_20.member_1[1u];
                                    let _e1651 = local_20.member_1[0u];
                                    let _e1655 = (_e1646[0] - _e1651[0]);
                                    let _e1656 = (_e1646[1] - _e1651[1]);
                                    let _e1657 = (_e1646[2] - _e1651[2]);
                                    if (_e1655 < 0.0lf) {
                                        phi_5125_ = -(_e1655);
                                    } else {
                                        phi_5125_ = _e1655;
                                    }
                                    let _e1661 = phi_5125_;
                                    if (_e1656 < 0.0lf) {
                                        phi_5131_ = -(_e1656);
                                    } else {
                                        phi_5131_ = _e1656;
                                    }
                                    let _e1665 = phi_5131_;
                                    if (_e1661 > _e1665) {
                                        phi_5136_ = _e1661;
                                    } else {
                                        phi_5136_ = _e1665;
                                    }
                                    let _e1668 = phi_5136_;
                                    if (_e1657 < 0.0lf) {
                                        phi_5142_ = -(_e1657);
                                    } else {
                                        phi_5142_ = _e1657;
                                    }
                                    let _e1672 = phi_5142_;
                                    if (_e1668 > _e1672) {
                                        phi_5147_ = _e1668;
                                    } else {
                                        phi_5147_ = _e1672;
                                    }
                                    let _e1675 = phi_5147_;
                                    let _e1683 = ((((_e1440 * _e1675) * f64(1.01f)) + ((_e1624 + _e1575) * (1.1102230246251565e-16lf * f64(8f)))) + _e1575);
                                    if (_e1642 < 0.0lf) {
                                        phi_5161_ = -(_e1642);
                                    } else {
                                        phi_5161_ = _e1642;
                                    }
                                    let _e1687 = phi_5161_;
                                    if (_e1643 < 0.0lf) {
                                        phi_5167_ = -(_e1643);
                                    } else {
                                        phi_5167_ = _e1643;
                                    }
                                    let _e1691 = phi_5167_;
                                    if (_e1687 > _e1691) {
                                        phi_5172_ = _e1687;
                                    } else {
                                        phi_5172_ = _e1691;
                                    }
                                    let _e1694 = phi_5172_;
                                    if (_e1644 < 0.0lf) {
                                        phi_5178_ = -(_e1644);
                                    } else {
                                        phi_5178_ = _e1644;
                                    }
                                    let _e1698 = phi_5178_;
                                    if (_e1694 > _e1698) {
                                        phi_5183_ = _e1694;
                                    } else {
                                        phi_5183_ = _e1698;
                                    }
                                    let _e1701 = phi_5183_;
                                    local_4 = type_51(array<f64, 3>(_e1642, _e1643, _e1644), _e1683, (_e1701 + _e1683));
                                    let _e1707 = local_20.member_3;
                                    let _e1709 = local_20.member_2[0u];
                                    if (_e1709[0] < 0.0lf) {
                                        phi_5209_ = -(_e1709[0]);
                                    } else {
                                        phi_5209_ = _e1709[0];
                                    }
                                    let _e1716 = phi_5209_;
                                    if (_e1709[1] < 0.0lf) {
                                        phi_5216_ = -(_e1709[1]);
                                    } else {
                                        phi_5216_ = _e1709[1];
                                    }
                                    let _e1720 = phi_5216_;
                                    if (_e1716 > _e1720) {
                                        phi_5221_ = _e1716;
                                    } else {
                                        phi_5221_ = _e1720;
                                    }
                                    let _e1723 = phi_5221_;
                                    if (_e1709[2] < 0.0lf) {
                                        phi_5228_ = -(_e1709[2]);
                                    } else {
                                        phi_5228_ = _e1709[2];
                                    }
                                    let _e1727 = phi_5228_;
                                    if (_e1723 > _e1727) {
                                        phi_5233_ = _e1723;
                                    } else {
                                        phi_5233_ = _e1727;
                                    }
                                    let _e1730 = phi_5233_;
                                    let _e1732 = local_20.member_2[1u];
                                    if (_e1732[0] < 0.0lf) {
                                        phi_5246_ = -(_e1732[0]);
                                    } else {
                                        phi_5246_ = _e1732[0];
                                    }
                                    let _e1739 = phi_5246_;
                                    if (_e1732[1] < 0.0lf) {
                                        phi_5253_ = -(_e1732[1]);
                                    } else {
                                        phi_5253_ = _e1732[1];
                                    }
                                    let _e1743 = phi_5253_;
                                    if (_e1739 > _e1743) {
                                        phi_5258_ = _e1739;
                                    } else {
                                        phi_5258_ = _e1743;
                                    }
                                    let _e1746 = phi_5258_;
                                    if (_e1732[2] < 0.0lf) {
                                        phi_5265_ = -(_e1732[2]);
                                    } else {
                                        phi_5265_ = _e1732[2];
                                    }
                                    let _e1750 = phi_5265_;
                                    if (_e1746 > _e1750) {
                                        phi_5270_ = _e1746;
                                    } else {
                                        phi_5270_ = _e1750;
                                    }
                                    let _e1753 = phi_5270_;
                                    if (_e1730 > _e1753) {
                                        phi_5275_ = _e1730;
                                    } else {
                                        phi_5275_ = _e1753;
                                    }
                                    let _e1756 = phi_5275_;
                                    let _e1759 = local_20.member_2[0u];
                                    let _e1764 = local_20.member_2[1u];
                                    let _e1774 = (_e1759[0] + ((_e1764[0] - _e1759[0]) * _e1437));
                                    let _e1775 = (_e1759[1] + ((_e1764[1] - _e1759[1]) * _e1437));
                                    let _e1776 = (_e1759[2] + ((_e1764[2] - _e1759[2]) * _e1437));
                                    let _e1778 = local_20.member_2[1u];
                                    let _e1783 = local_20.member_2[0u];
                                    let _e1787 = (_e1778[0] - _e1783[0]);
                                    let _e1788 = (_e1778[1] - _e1783[1]);
                                    let _e1789 = (_e1778[2] - _e1783[2]);
                                    if (_e1787 < 0.0lf) {
                                        phi_5334_ = -(_e1787);
                                    } else {
                                        phi_5334_ = _e1787;
                                    }
                                    let _e1793 = phi_5334_;
                                    if (_e1788 < 0.0lf) {
                                        phi_5340_ = -(_e1788);
                                    } else {
                                        phi_5340_ = _e1788;
                                    }
                                    let _e1797 = phi_5340_;
                                    if (_e1793 > _e1797) {
                                        phi_5345_ = _e1793;
                                    } else {
                                        phi_5345_ = _e1797;
                                    }
                                    let _e1800 = phi_5345_;
                                    if (_e1789 < 0.0lf) {
                                        phi_5351_ = -(_e1789);
                                    } else {
                                        phi_5351_ = _e1789;
                                    }
                                    let _e1804 = phi_5351_;
                                    if (_e1800 > _e1804) {
                                        phi_5356_ = _e1800;
                                    } else {
                                        phi_5356_ = _e1804;
                                    }
                                    let _e1807 = phi_5356_;
                                    let _e1815 = ((((_e1440 * _e1807) * f64(1.01f)) + ((_e1756 + _e1707) * (1.1102230246251565e-16lf * f64(8f)))) + _e1707);
                                    if (_e1774 < 0.0lf) {
                                        phi_5370_ = -(_e1774);
                                    } else {
                                        phi_5370_ = _e1774;
                                    }
                                    let _e1819 = phi_5370_;
                                    if (_e1775 < 0.0lf) {
                                        phi_5376_ = -(_e1775);
                                    } else {
                                        phi_5376_ = _e1775;
                                    }
                                    let _e1823 = phi_5376_;
                                    if (_e1819 > _e1823) {
                                        phi_5381_ = _e1819;
                                    } else {
                                        phi_5381_ = _e1823;
                                    }
                                    let _e1826 = phi_5381_;
                                    if (_e1776 < 0.0lf) {
                                        phi_5387_ = -(_e1776);
                                    } else {
                                        phi_5387_ = _e1776;
                                    }
                                    let _e1830 = phi_5387_;
                                    if (_e1826 > _e1830) {
                                        phi_5392_ = _e1826;
                                    } else {
                                        phi_5392_ = _e1830;
                                    }
                                    let _e1833 = phi_5392_;
                                    local_5 = type_51(array<f64, 3>(_e1774, _e1775, _e1776), _e1815, (_e1833 + _e1815));
                                    let _e1838 = local_4.member;
                                    let _e1843 = local_5.member;
                                    let _e1849 = ((_e1838[1] * _e1843[2]) - (_e1838[2] * _e1843[1]));
                                    let _e1852 = ((_e1838[2] * _e1843[0]) - (_e1838[0] * _e1843[2]));
                                    let _e1855 = ((_e1838[0] * _e1843[1]) - (_e1838[1] * _e1843[0]));
                                    if (_e1849 < 0.0lf) {
                                        phi_5441_ = -(_e1849);
                                    } else {
                                        phi_5441_ = _e1849;
                                    }
                                    let _e1859 = phi_5441_;
                                    if (_e1852 < 0.0lf) {
                                        phi_5447_ = -(_e1852);
                                    } else {
                                        phi_5447_ = _e1852;
                                    }
                                    let _e1863 = phi_5447_;
                                    if (_e1859 > _e1863) {
                                        if (_e1849 < 0.0lf) {
                                            phi_5457_ = -(_e1849);
                                        } else {
                                            phi_5457_ = _e1849;
                                        }
                                        let _e1881 = phi_5457_;
                                        if (_e1855 < 0.0lf) {
                                            phi_5463_ = -(_e1855);
                                        } else {
                                            phi_5463_ = _e1855;
                                        }
                                        let _e1885 = phi_5463_;
                                        if (_e1881 > _e1885) {
                                            phi_5468_ = 2u;
                                            phi_5469_ = 1u;
                                        } else {
                                            phi_5468_ = 1u;
                                            phi_5469_ = 0u;
                                        }
                                        let _e1888 = phi_5468_;
                                        let _e1890 = phi_5469_;
                                        phi_5488_ = _e1888;
                                        phi_5489_ = _e1890;
                                    } else {
                                        if (_e1852 < 0.0lf) {
                                            phi_5475_ = -(_e1852);
                                        } else {
                                            phi_5475_ = _e1852;
                                        }
                                        let _e1868 = phi_5475_;
                                        if (_e1855 < 0.0lf) {
                                            phi_5481_ = -(_e1855);
                                        } else {
                                            phi_5481_ = _e1855;
                                        }
                                        let _e1872 = phi_5481_;
                                        if (_e1868 > _e1872) {
                                            phi_5486_ = 0u;
                                            phi_5487_ = 2u;
                                        } else {
                                            phi_5486_ = 1u;
                                            phi_5487_ = 0u;
                                        }
                                        let _e1875 = phi_5486_;
                                        let _e1877 = phi_5487_;
                                        phi_5488_ = _e1875;
                                        phi_5489_ = _e1877;
                                    }
                                    let _e1892 = phi_5488_;
                                    let _e1894 = phi_5489_;
                                    if (_e1894 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1898 = local_4.member[_e1894];
                                    if (_e1892 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1902 = local_5.member[_e1892];
                                    if (_e1892 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1907 = local_4.member[_e1892];
                                    if (_e1894 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1911 = local_5.member[_e1894];
                                    let _e1913 = ((_e1898 * _e1902) - (_e1907 * _e1911));
                                    let _e1914 = f64(1f);
                                    let _e1916 = local_4.member_1;
                                    let _e1918 = local_5.member_2;
                                    let _e1921 = local_4.member_2;
                                    let _e1923 = local_5.member_1;
                                    let _e1929 = local_4.member_2;
                                    let _e1931 = local_5.member_2;
                                    let _e1940 = local_4.member_2;
                                    let _e1943 = local_5.member_2;
                                    let _e1947 = (((((_e1916 * _e1918) + (_e1921 * _e1923)) * f64(2.01f)) + ((_e1929 * _e1931) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1914 + _e1940) * (_e1914 + _e1943))));
                                    if (_e1913 < 0.0lf) {
                                        phi_5560_ = -(_e1913);
                                    } else {
                                        phi_5560_ = _e1913;
                                    }
                                    let _e1951 = phi_5560_;
                                    if (_e1951 > _e1947) {
                                        if (_e1913 < f64(0f)) {
                                            phi_5572_ = f64(-1f);
                                        } else {
                                            phi_5572_ = f64(1f);
                                        }
                                        let _e1958 = phi_5572_;
                                        if (_e1894 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1962 = local_3.member[_e1894];
                                        if (_e1892 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1966 = local_5.member[_e1892];
                                        if (_e1892 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1971 = local_3.member[_e1892];
                                        if (_e1894 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1975 = local_5.member[_e1894];
                                        let _e1978 = f64(1f);
                                        let _e1980 = local_3.member_1;
                                        let _e1982 = local_5.member_2;
                                        let _e1985 = local_3.member_2;
                                        let _e1987 = local_5.member_1;
                                        let _e1993 = local_3.member_2;
                                        let _e1995 = local_5.member_2;
                                        let _e2004 = local_3.member_2;
                                        let _e2007 = local_5.member_2;
                                        let _e2011 = (((((_e1980 * _e1982) + (_e1985 * _e1987)) * f64(2.01f)) + ((_e1993 * _e1995) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1978 + _e2004) * (_e1978 + _e2007))));
                                        if (_e1894 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2015 = local_4.member[_e1894];
                                        if (_e1892 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2019 = local_3.member[_e1892];
                                        if (_e1892 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2024 = local_4.member[_e1892];
                                        if (_e1894 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2028 = local_3.member[_e1894];
                                        let _e2031 = f64(1f);
                                        let _e2033 = local_4.member_1;
                                        let _e2035 = local_3.member_2;
                                        let _e2038 = local_4.member_2;
                                        let _e2040 = local_3.member_1;
                                        let _e2046 = local_4.member_2;
                                        let _e2048 = local_3.member_2;
                                        let _e2057 = local_4.member_2;
                                        let _e2060 = local_3.member_2;
                                        let _e2064 = (((((_e2033 * _e2035) + (_e2038 * _e2040)) * f64(2.01f)) + ((_e2046 * _e2048) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2031 + _e2057) * (_e2031 + _e2060))));
                                        let _e2065 = (_e1913 * _e1958);
                                        let _e2066 = (((_e1962 * _e1966) - (_e1971 * _e1975)) * _e1958);
                                        let _e2067 = (((_e2015 * _e2019) - (_e2024 * _e2028)) * _e1958);
                                        if (_e2065 < 0.0lf) {
                                            phi_5711_ = -(_e2065);
                                        } else {
                                            phi_5711_ = _e2065;
                                        }
                                        let _e2071 = phi_5711_;
                                        if (_e2066 < 0.0lf) {
                                            phi_5717_ = -(_e2066);
                                        } else {
                                            phi_5717_ = _e2066;
                                        }
                                        let _e2075 = phi_5717_;
                                        if (_e2067 < 0.0lf) {
                                            phi_5724_ = -(_e2067);
                                        } else {
                                            phi_5724_ = _e2067;
                                        }
                                        let _e2080 = phi_5724_;
                                        let _e2084 = (((_e2071 + _e2075) + _e2080) * (1.1102230246251565e-16lf * f64(4f)));
                                        local_6[0u].member = _e2066;
                                        local_6[0u].member_1 = _e2011;
                                        local_6[1u].member = _e2067;
                                        local_6[1u].member_1 = _e2064;
                                        local_6[2u].member = (_e2065 - _e2066);
                                        local_6[2u].member_1 = ((_e1947 + _e2011) + _e2084);
                                        local_6[3u].member = (_e2065 - _e2067);
                                        local_6[3u].member_1 = ((_e1947 + _e2064) + _e2084);
                                        phi_5768_ = type_28(0u, 4u);
                                        phi_5771_ = true;
                                        loop {
                                            let _e2105 = phi_5768_;
                                            let _e2107 = phi_5771_;
                                            local_25 = _e2107;
                                            if (_e2105.member < _e2105.member_1) {
                                                phi_5769_ = type_28((_e2105.member + 1u), _e2105.member_1);
                                                phi_5794_ = type_28(1u, _e2105.member);
                                            } else {
                                                phi_5769_ = _e2105;
                                                phi_5794_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e2121 = phi_5769_;
                                            let _e2123 = phi_5794_;
                                            if (bitcast<i32>(_e2123.member) != 0i) {
                                                if (_e2123.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e2131 = local_6[_e2123.member_1].member;
                                                let _e2134 = local_6[_e2123.member_1].member_1;
                                                let _e2136 = (_e2131 < -(_e2134));
                                                if _e2136 {
                                                    phi_5821_ = bool();
                                                    phi_5822_ = false;
                                                } else {
                                                    phi_5821_ = (_e2107 && (_e2131 > _e2134));
                                                    phi_5822_ = true;
                                                }
                                                let _e2140 = phi_5821_;
                                                let _e2142 = phi_5822_;
                                                phi_5772_ = _e2140;
                                                phi_5823_ = _e2142;
                                                phi_5824_ = _e2136;
                                            } else {
                                                phi_5772_ = bool();
                                                phi_5823_ = false;
                                                phi_5824_ = false;
                                            }
                                            let _e2144 = phi_5772_;
                                            let _e2146 = phi_5823_;
                                            let _e2148 = phi_5824_;
                                            local_24 = _e2148;
                                            continue;
                                            continuing {
                                                phi_5768_ = _e2121;
                                                phi_5771_ = _e2144;
                                                break if !(_e2146);
                                            }
                                        }
                                        let _e2151 = local_24;
                                        if _e2151 {
                                            phi_5828_ = false;
                                        } else {
                                            phi_5828_ = true;
                                        }
                                        let _e2153 = phi_5828_;
                                        if _e2153 {
                                            let _e2155 = local_25;
                                            if _e2155 {
                                                phi_5835_ = 1u;
                                            } else {
                                                phi_5835_ = 2u;
                                            }
                                            let _e2157 = phi_5835_;
                                            phi_5836_ = _e2157;
                                            phi_5837_ = false;
                                        } else {
                                            phi_5836_ = u32();
                                            phi_5837_ = true;
                                        }
                                        let _e2159 = phi_5836_;
                                        let _e2161 = phi_5837_;
                                        phi_5838_ = _e2159;
                                        phi_5839_ = 0u;
                                        phi_5840_ = _e2161;
                                    } else {
                                        phi_5838_ = u32();
                                        phi_5839_ = 2u;
                                        phi_5840_ = true;
                                    }
                                    let _e2163 = phi_5838_;
                                    let _e2165 = phi_5839_;
                                    let _e2167 = phi_5840_;
                                    if _e2167 {
                                        phi_5844_ = _e2165;
                                    } else {
                                        phi_5844_ = _e2163;
                                    }
                                    let _e2169 = phi_5844_;
                                    let _e2170 = (_e2169 == 0u);
                                    if _e2170 {
                                        phi_7388_ = f64();
                                        phi_7389_ = false;
                                        phi_7390_ = false;
                                        phi_7391_ = false;
                                    } else {
                                        if (_e2169 == 1u) {
                                            if _e1428.member_2 {
                                                if ((_e1428.member_1 - _e1428.member) <= f64(0.0000005f)) {
                                                    phi_5865_ = false;
                                                } else {
                                                    phi_5865_ = true;
                                                }
                                                let _e2179 = phi_5865_;
                                                phi_5866_ = _e2179;
                                            } else {
                                                phi_5866_ = true;
                                            }
                                            let _e2181 = phi_5866_;
                                            phi_5867_ = _e2181;
                                        } else {
                                            phi_5867_ = true;
                                        }
                                        let _e2183 = phi_5867_;
                                        if _e2183 {
                                            let _e2189 = local_20.member[0u];
                                            let _e2195 = local_20.member_1[0u];
                                            let _e2201 = local_20.member_2[0u];
                                            let _e2205 = (_e2189[0] - _e2195[0]);
                                            let _e2206 = (_e2189[1] - _e2195[1]);
                                            let _e2207 = (_e2189[2] - _e2195[2]);
                                            local_1 = array<array<f64, 3>, 4>(_e2189, array<f64, 3>(_e2205, _e2206, _e2207), array<f64, 3>((_e2189[0] - _e2201[0]), (_e2189[1] - _e2201[1]), (_e2189[2] - _e2201[2])), array<f64, 3>((_e2205 - _e2201[0]), (_e2206 - _e2201[1]), (_e2207 - _e2201[2])));
                                            let _e2220 = local_20.member[1u];
                                            let _e2226 = local_20.member_1[1u];
                                            let _e2232 = local_20.member_2[1u];
                                            let _e2236 = (_e2220[0] - _e2226[0]);
                                            let _e2237 = (_e2220[1] - _e2226[1]);
                                            let _e2238 = (_e2220[2] - _e2226[2]);
                                            local_2 = array<array<f64, 3>, 4>(_e2220, array<f64, 3>(_e2236, _e2237, _e2238), array<f64, 3>((_e2220[0] - _e2232[0]), (_e2220[1] - _e2232[1]), (_e2220[2] - _e2232[2])), array<f64, 3>((_e2236 - _e2232[0]), (_e2237 - _e2232[1]), (_e2238 - _e2232[2])));
                                            let _e2251 = local_20.member[0u];
                                            if (_e2251[0] < 0.0lf) {
                                                phi_6064_ = -(_e2251[0]);
                                            } else {
                                                phi_6064_ = _e2251[0];
                                            }
                                            let _e2258 = phi_6064_;
                                            if (_e2251[1] < 0.0lf) {
                                                phi_6071_ = -(_e2251[1]);
                                            } else {
                                                phi_6071_ = _e2251[1];
                                            }
                                            let _e2262 = phi_6071_;
                                            if (_e2258 > _e2262) {
                                                phi_6076_ = _e2258;
                                            } else {
                                                phi_6076_ = _e2262;
                                            }
                                            let _e2265 = phi_6076_;
                                            if (_e2251[2] < 0.0lf) {
                                                phi_6083_ = -(_e2251[2]);
                                            } else {
                                                phi_6083_ = _e2251[2];
                                            }
                                            let _e2269 = phi_6083_;
                                            if (_e2265 > _e2269) {
                                                phi_6088_ = _e2265;
                                            } else {
                                                phi_6088_ = _e2269;
                                            }
                                            let _e2272 = phi_6088_;
                                            let _e2275 = local_20.member[1u];
                                            if (_e2275[0] < 0.0lf) {
                                                phi_6101_ = -(_e2275[0]);
                                            } else {
                                                phi_6101_ = _e2275[0];
                                            }
                                            let _e2282 = phi_6101_;
                                            if (_e2275[1] < 0.0lf) {
                                                phi_6108_ = -(_e2275[1]);
                                            } else {
                                                phi_6108_ = _e2275[1];
                                            }
                                            let _e2286 = phi_6108_;
                                            if (_e2282 > _e2286) {
                                                phi_6113_ = _e2282;
                                            } else {
                                                phi_6113_ = _e2286;
                                            }
                                            let _e2289 = phi_6113_;
                                            if (_e2275[2] < 0.0lf) {
                                                phi_6120_ = -(_e2275[2]);
                                            } else {
                                                phi_6120_ = _e2275[2];
                                            }
                                            let _e2293 = phi_6120_;
                                            if (_e2289 > _e2293) {
                                                phi_6125_ = _e2289;
                                            } else {
                                                phi_6125_ = _e2293;
                                            }
                                            let _e2296 = phi_6125_;
                                            if (_e2272 > _e2296) {
                                                phi_6130_ = _e2272;
                                            } else {
                                                phi_6130_ = _e2296;
                                            }
                                            let _e2299 = phi_6130_;
                                            let _e2301 = local_20.member_3;
                                            let _e2305 = local_20.member_1[0u];
                                            if (_e2305[0] < 0.0lf) {
                                                phi_6147_ = -(_e2305[0]);
                                            } else {
                                                phi_6147_ = _e2305[0];
                                            }
                                            let _e2312 = phi_6147_;
                                            if (_e2305[1] < 0.0lf) {
                                                phi_6154_ = -(_e2305[1]);
                                            } else {
                                                phi_6154_ = _e2305[1];
                                            }
                                            let _e2316 = phi_6154_;
                                            if (_e2312 > _e2316) {
                                                phi_6159_ = _e2312;
                                            } else {
                                                phi_6159_ = _e2316;
                                            }
                                            let _e2319 = phi_6159_;
                                            if (_e2305[2] < 0.0lf) {
                                                phi_6166_ = -(_e2305[2]);
                                            } else {
                                                phi_6166_ = _e2305[2];
                                            }
                                            let _e2323 = phi_6166_;
                                            if (_e2319 > _e2323) {
                                                phi_6171_ = _e2319;
                                            } else {
                                                phi_6171_ = _e2323;
                                            }
                                            let _e2326 = phi_6171_;
                                            let _e2329 = local_20.member_1[1u];
                                            if (_e2329[0] < 0.0lf) {
                                                phi_6185_ = -(_e2329[0]);
                                            } else {
                                                phi_6185_ = _e2329[0];
                                            }
                                            let _e2336 = phi_6185_;
                                            if (_e2329[1] < 0.0lf) {
                                                phi_6192_ = -(_e2329[1]);
                                            } else {
                                                phi_6192_ = _e2329[1];
                                            }
                                            let _e2340 = phi_6192_;
                                            if (_e2336 > _e2340) {
                                                phi_6197_ = _e2336;
                                            } else {
                                                phi_6197_ = _e2340;
                                            }
                                            let _e2343 = phi_6197_;
                                            if (_e2329[2] < 0.0lf) {
                                                phi_6204_ = -(_e2329[2]);
                                            } else {
                                                phi_6204_ = _e2329[2];
                                            }
                                            let _e2347 = phi_6204_;
                                            if (_e2343 > _e2347) {
                                                phi_6209_ = _e2343;
                                            } else {
                                                phi_6209_ = _e2347;
                                            }
                                            let _e2350 = phi_6209_;
                                            if (_e2326 > _e2350) {
                                                phi_6214_ = _e2326;
                                            } else {
                                                phi_6214_ = _e2350;
                                            }
                                            let _e2353 = phi_6214_;
                                            let _e2355 = local_20.member_3;
                                            let _e2359 = local_20.member_2[0u];
                                            if (_e2359[0] < 0.0lf) {
                                                phi_6231_ = -(_e2359[0]);
                                            } else {
                                                phi_6231_ = _e2359[0];
                                            }
                                            let _e2366 = phi_6231_;
                                            if (_e2359[1] < 0.0lf) {
                                                phi_6238_ = -(_e2359[1]);
                                            } else {
                                                phi_6238_ = _e2359[1];
                                            }
                                            let _e2370 = phi_6238_;
                                            if (_e2366 > _e2370) {
                                                phi_6243_ = _e2366;
                                            } else {
                                                phi_6243_ = _e2370;
                                            }
                                            let _e2373 = phi_6243_;
                                            if (_e2359[2] < 0.0lf) {
                                                phi_6250_ = -(_e2359[2]);
                                            } else {
                                                phi_6250_ = _e2359[2];
                                            }
                                            let _e2377 = phi_6250_;
                                            if (_e2373 > _e2377) {
                                                phi_6255_ = _e2373;
                                            } else {
                                                phi_6255_ = _e2377;
                                            }
                                            let _e2380 = phi_6255_;
                                            let _e2383 = local_20.member_2[1u];
                                            if (_e2383[0] < 0.0lf) {
                                                phi_6269_ = -(_e2383[0]);
                                            } else {
                                                phi_6269_ = _e2383[0];
                                            }
                                            let _e2390 = phi_6269_;
                                            if (_e2383[1] < 0.0lf) {
                                                phi_6276_ = -(_e2383[1]);
                                            } else {
                                                phi_6276_ = _e2383[1];
                                            }
                                            let _e2394 = phi_6276_;
                                            if (_e2390 > _e2394) {
                                                phi_6281_ = _e2390;
                                            } else {
                                                phi_6281_ = _e2394;
                                            }
                                            let _e2397 = phi_6281_;
                                            if (_e2383[2] < 0.0lf) {
                                                phi_6288_ = -(_e2383[2]);
                                            } else {
                                                phi_6288_ = _e2383[2];
                                            }
                                            let _e2401 = phi_6288_;
                                            if (_e2397 > _e2401) {
                                                phi_6293_ = _e2397;
                                            } else {
                                                phi_6293_ = _e2401;
                                            }
                                            let _e2404 = phi_6293_;
                                            if (_e2380 > _e2404) {
                                                phi_6298_ = _e2380;
                                            } else {
                                                phi_6298_ = _e2404;
                                            }
                                            let _e2407 = phi_6298_;
                                            let _e2409 = local_20.member_3;
                                            let _e2417 = local_20.member_3;
                                            phi_6318_ = type_28(0u, 48u);
                                            phi_6321_ = _e1428.member;
                                            loop {
                                                let _e2426 = phi_6318_;
                                                let _e2428 = phi_6321_;
                                                local_70 = _e2428;
                                                local_32 = _e2428;
                                                local_33 = _e2428;
                                                local_34 = _e2428;
                                                local_35 = _e2428;
                                                if (_e2426.member < _e2426.member_1) {
                                                    phi_6319_ = type_28((_e2426.member + 1u), _e2426.member_1);
                                                    phi_6344_ = type_28(1u, _e2426.member);
                                                } else {
                                                    phi_6319_ = _e2426;
                                                    phi_6344_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e2442 = phi_6319_;
                                                let _e2444 = phi_6344_;
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
                                                    let _e2540 = f64(1f);
                                                    let _e2544 = (((_e2530 * _e2525) - (_e2535 * _e2520)) / _e2538);
                                                    let _e2548 = (((_e2535 * _e2515) - (_e2530 * _e2520)) / _e2538);
                                                    if (_e2544 >= _e2539) {
                                                        if (_e2548 >= _e2539) {
                                                            if (_e2544 <= _e2540) {
                                                                phi_6500_ = (_e2548 <= _e2540);
                                                                phi_6501_ = false;
                                                            } else {
                                                                phi_6500_ = bool();
                                                                phi_6501_ = true;
                                                            }
                                                            let _e2554 = phi_6500_;
                                                            let _e2556 = phi_6501_;
                                                            phi_6502_ = _e2554;
                                                            phi_6503_ = _e2556;
                                                        } else {
                                                            phi_6502_ = bool();
                                                            phi_6503_ = true;
                                                        }
                                                        let _e2558 = phi_6502_;
                                                        let _e2560 = phi_6503_;
                                                        phi_6504_ = _e2558;
                                                        phi_6505_ = _e2560;
                                                    } else {
                                                        phi_6504_ = bool();
                                                        phi_6505_ = true;
                                                    }
                                                    let _e2562 = phi_6504_;
                                                    let _e2564 = phi_6505_;
                                                    if _e2564 {
                                                        phi_6509_ = false;
                                                    } else {
                                                        phi_6509_ = _e2562;
                                                    }
                                                    let _e2566 = phi_6509_;
                                                    if (_e2538 > _e2539) {
                                                        if _e2566 {
                                                            phi_6549_ = array<f64, 3>((_e2466 - ((_e2487 * _e2544) + (_e2508 * _e2548))), (_e2467 - ((_e2488 * _e2544) + (_e2509 * _e2548))), (_e2468 - ((_e2489 * _e2544) + (_e2510 * _e2548))));
                                                            phi_6550_ = false;
                                                        } else {
                                                            phi_6549_ = array<f64, 3>();
                                                            phi_6550_ = true;
                                                        }
                                                        let _e2582 = phi_6549_;
                                                        let _e2584 = phi_6550_;
                                                        phi_6551_ = _e2582;
                                                        phi_6552_ = _e2584;
                                                    } else {
                                                        phi_6551_ = array<f64, 3>();
                                                        phi_6552_ = true;
                                                    }
                                                    let _e2586 = phi_6551_;
                                                    let _e2588 = phi_6552_;
                                                    if _e2588 {
                                                        let _e2589 = (_e2466 - _e2487);
                                                        let _e2590 = (_e2467 - _e2488);
                                                        let _e2591 = (_e2468 - _e2489);
                                                        let _e2602 = ((((_e2466 * _e2487) + (_e2467 * _e2488)) + (_e2468 * _e2489)) / (((_e2487 * _e2487) + (_e2488 * _e2488)) + (_e2489 * _e2489)));
                                                        if (_e2602 > f64(0f)) {
                                                            if (_e2602 < f64(1f)) {
                                                                phi_6585_ = _e2602;
                                                            } else {
                                                                phi_6585_ = f64(1f);
                                                            }
                                                            let _e2610 = phi_6585_;
                                                            phi_6587_ = _e2610;
                                                        } else {
                                                            phi_6587_ = f64(0f);
                                                        }
                                                        let _e2612 = phi_6587_;
                                                        let _e2629 = ((((_e2466 * _e2508) + (_e2467 * _e2509)) + (_e2468 * _e2510)) / (((_e2508 * _e2508) + (_e2509 * _e2509)) + (_e2510 * _e2510)));
                                                        if (_e2629 > f64(0f)) {
                                                            if (_e2629 < f64(1f)) {
                                                                phi_6617_ = _e2629;
                                                            } else {
                                                                phi_6617_ = f64(1f);
                                                            }
                                                            let _e2637 = phi_6617_;
                                                            phi_6619_ = _e2637;
                                                        } else {
                                                            phi_6619_ = f64(0f);
                                                        }
                                                        let _e2639 = phi_6619_;
                                                        let _e2656 = ((((_e2589 * _e2508) + (_e2590 * _e2509)) + (_e2591 * _e2510)) / (((_e2508 * _e2508) + (_e2509 * _e2509)) + (_e2510 * _e2510)));
                                                        if (_e2656 > f64(0f)) {
                                                            if (_e2656 < f64(1f)) {
                                                                phi_6649_ = _e2656;
                                                            } else {
                                                                phi_6649_ = f64(1f);
                                                            }
                                                            let _e2664 = phi_6649_;
                                                            phi_6651_ = _e2664;
                                                        } else {
                                                            phi_6651_ = f64(0f);
                                                        }
                                                        let _e2666 = phi_6651_;
                                                        let _e2673 = (_e2466 - _e2508);
                                                        let _e2674 = (_e2467 - _e2509);
                                                        let _e2675 = (_e2468 - _e2510);
                                                        let _e2686 = ((((_e2673 * _e2487) + (_e2674 * _e2488)) + (_e2675 * _e2489)) / (((_e2487 * _e2487) + (_e2488 * _e2488)) + (_e2489 * _e2489)));
                                                        if (_e2686 > f64(0f)) {
                                                            if (_e2686 < f64(1f)) {
                                                                phi_6684_ = _e2686;
                                                            } else {
                                                                phi_6684_ = f64(1f);
                                                            }
                                                            let _e2694 = phi_6684_;
                                                            phi_6686_ = _e2694;
                                                        } else {
                                                            phi_6686_ = f64(0f);
                                                        }
                                                        let _e2696 = phi_6686_;
                                                        local[0u] = array<f64, 3>((_e2466 - (_e2487 * _e2612)), (_e2467 - (_e2488 * _e2612)), (_e2468 - (_e2489 * _e2612)));
                                                        local[1u] = array<f64, 3>((_e2466 - (_e2508 * _e2639)), (_e2467 - (_e2509 * _e2639)), (_e2468 - (_e2510 * _e2639)));
                                                        local[2u] = array<f64, 3>((_e2589 - (_e2508 * _e2666)), (_e2590 - (_e2509 * _e2666)), (_e2591 - (_e2510 * _e2666)));
                                                        local[3u] = array<f64, 3>((_e2673 - (_e2487 * _e2696)), (_e2674 - (_e2488 * _e2696)), (_e2675 - (_e2489 * _e2696)));
                                                        let _e2712 = local[0u];
                                                        phi_6841_ = type_28(1u, 4u);
                                                        phi_6844_ = array<f64, 3>(_e2712[0], _e2712[1], _e2712[2]);
                                                        loop {
                                                            let _e2718 = phi_6841_;
                                                            let _e2720 = phi_6844_;
                                                            local_57 = _e2720;
                                                            if (_e2718.member < _e2718.member_1) {
                                                                phi_6842_ = type_28((_e2718.member + 1u), _e2718.member_1);
                                                                phi_6867_ = type_28(1u, _e2718.member);
                                                            } else {
                                                                phi_6842_ = _e2718;
                                                                phi_6867_ = type_28(0u, type_28().member_1);
                                                            }
                                                            let _e2734 = phi_6842_;
                                                            let _e2736 = phi_6867_;
                                                            let _e2740 = (bitcast<i32>(_e2736.member) != 0i);
                                                            if _e2740 {
                                                                if (_e2736.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2743 = local[_e2736.member_1];
                                                                if (_e2736.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2749 = local[_e2736.member_1];
                                                                if ((((_e2743[0] * _e2749[0]) + (_e2743[1] * _e2749[1])) + (_e2743[2] * _e2749[2])) < (((_e2720[0] * _e2720[0]) + (_e2720[1] * _e2720[1])) + (_e2720[2] * _e2720[2]))) {
                                                                    if (_e2736.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2772 = local[_e2736.member_1];
                                                                    phi_6934_ = array<f64, 3>(_e2772[0], _e2772[1], _e2772[2]);
                                                                } else {
                                                                    phi_6934_ = _e2720;
                                                                }
                                                                let _e2778 = phi_6934_;
                                                                phi_6845_ = _e2778;
                                                            } else {
                                                                phi_6845_ = array<f64, 3>();
                                                            }
                                                            let _e2780 = phi_6845_;
                                                            continue;
                                                            continuing {
                                                                phi_6841_ = _e2734;
                                                                phi_6844_ = _e2780;
                                                                break if !(_e2740);
                                                            }
                                                        }
                                                        let _e5451 = local_57;
                                                        phi_6935_ = _e5451;
                                                    } else {
                                                        phi_6935_ = _e2586;
                                                    }
                                                    let _e2783 = phi_6935_;
                                                    if (_e2783[0] < 0.0lf) {
                                                        phi_6942_ = -(_e2783[0]);
                                                    } else {
                                                        phi_6942_ = _e2783[0];
                                                    }
                                                    let _e2788 = phi_6942_;
                                                    if (_e2783[1] < 0.0lf) {
                                                        phi_6949_ = -(_e2783[1]);
                                                    } else {
                                                        phi_6949_ = _e2783[1];
                                                    }
                                                    let _e2793 = phi_6949_;
                                                    if (_e2783[2] < 0.0lf) {
                                                        phi_6957_ = -(_e2783[2]);
                                                    } else {
                                                        phi_6957_ = _e2783[2];
                                                    }
                                                    let _e2799 = phi_6957_;
                                                    let _e2800 = ((_e2788 + _e2793) + _e2799);
                                                    if (_e2800 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2800) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2806 = (f64(1f) / _e2800);
                                                            let _e2808 = (_e2783[0] * _e2806);
                                                            let _e2810 = (_e2783[1] * _e2806);
                                                            let _e2812 = (_e2783[2] * _e2806);
                                                            let _e2817 = (((_e2808 * _e2808) + (_e2810 * _e2810)) + (_e2812 * _e2812));
                                                            if (_e2817 <= 2.2250738585072014e-308lf) {
                                                                if (_e2817 > 0.0lf) {
                                                                    phi_6995_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_6995_ = 0.0lf;
                                                                }
                                                                let _e2875 = phi_6995_;
                                                                phi_7059_ = _e2875;
                                                            } else {
                                                                phi_7002_ = type_26(0i, 5i);
                                                                phi_7005_ = bitcast<f64>(((bitcast<u64>(_e2817) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2824 = phi_7002_;
                                                                    let _e2826 = phi_7005_;
                                                                    local_26 = _e2826;
                                                                    if (_e2824.member < _e2824.member_1) {
                                                                        let _e2834 = (_e2824.member + 1i);
                                                                        if ((false == (_e2834 > _e2824.member)) != false) {
                                                                            phi_7026_ = true;
                                                                        } else {
                                                                            phi_7026_ = false;
                                                                        }
                                                                        let _e2839 = phi_7026_;
                                                                        if _e2839 {
                                                                            phi_7032_ = type_27(0u, type_27().member_1);
                                                                        } else {
                                                                            phi_7032_ = type_27(1u, _e2834);
                                                                        }
                                                                        let _e2845 = phi_7032_;
                                                                        if (bitcast<i32>(_e2845.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_7003_ = type_26(_e2845.member_1, _e2824.member_1);
                                                                        phi_7046_ = type_27(1u, _e2824.member);
                                                                    } else {
                                                                        phi_7003_ = _e2824;
                                                                        phi_7046_ = type_27(0u, type_27().member_1);
                                                                    }
                                                                    let _e2855 = phi_7003_;
                                                                    let _e2857 = phi_7046_;
                                                                    let _e2860 = (bitcast<i32>(_e2857.member) != 0i);
                                                                    if _e2860 {
                                                                        phi_7006_ = (0.5lf * (_e2826 + (_e2817 / _e2826)));
                                                                    } else {
                                                                        phi_7006_ = f64();
                                                                    }
                                                                    let _e2865 = phi_7006_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7002_ = _e2855;
                                                                        phi_7005_ = _e2865;
                                                                        break if !(_e2860);
                                                                    }
                                                                }
                                                                let _e2870 = local_26;
                                                                phi_7059_ = (_e2870 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2877 = phi_7059_;
                                                            phi_7072_ = type_28(0u, 4u);
                                                            phi_7075_ = f64(2f);
                                                            loop {
                                                                let _e2889 = phi_7072_;
                                                                let _e2891 = phi_7075_;
                                                                local_28 = _e2891;
                                                                local_29 = _e2891;
                                                                local_30 = _e2891;
                                                                local_60 = _e2891;
                                                                local_61 = _e2891;
                                                                if (_e2889.member < _e2889.member_1) {
                                                                    phi_7073_ = type_28((_e2889.member + 1u), _e2889.member_1);
                                                                    phi_7098_ = type_28(1u, _e2889.member);
                                                                } else {
                                                                    phi_7073_ = _e2889;
                                                                    phi_7098_ = type_28(0u, type_28().member_1);
                                                                }
                                                                let _e2905 = phi_7073_;
                                                                let _e2907 = phi_7098_;
                                                                if (bitcast<i32>(_e2907.member) != 0i) {
                                                                    if (_e2907.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2914 = local_1[_e2907.member_1];
                                                                    let _e2922 = (((_e2808 * _e2914[0]) + (_e2810 * _e2914[1])) + (_e2812 * _e2914[2]));
                                                                    if (_e2907.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2925 = local_2[_e2907.member_1];
                                                                    let _e2933 = (((_e2808 * _e2925[0]) + (_e2810 * _e2925[1])) + (_e2812 * _e2925[2]));
                                                                    if (_e2922 < 0.0lf) {
                                                                        phi_7149_ = -(_e2922);
                                                                    } else {
                                                                        phi_7149_ = _e2922;
                                                                    }
                                                                    let _e2937 = phi_7149_;
                                                                    if (_e2933 < 0.0lf) {
                                                                        phi_7155_ = -(_e2933);
                                                                    } else {
                                                                        phi_7155_ = _e2933;
                                                                    }
                                                                    let _e2941 = phi_7155_;
                                                                    let _e2946 = (((((((((_e2299 + _e2301) + (_e2353 + _e2355)) + (_e2407 + _e2409)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2417 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2877) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2937 + _e2941) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2922 > _e2946) {
                                                                        if (_e2933 > _e2946) {
                                                                            phi_7169_ = false;
                                                                        } else {
                                                                            phi_7169_ = true;
                                                                        }
                                                                        let _e2950 = phi_7169_;
                                                                        phi_7170_ = _e2950;
                                                                    } else {
                                                                        phi_7170_ = true;
                                                                    }
                                                                    let _e2952 = phi_7170_;
                                                                    if _e2952 {
                                                                        if ((_e2922 + ((_e2933 - _e2922) * _e2428)) > _e2946) {
                                                                            if (_e2933 < _e2922) {
                                                                                let _e2961 = ((_e2922 - _e2933) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                                                if _e2961 {
                                                                                    let _e2969 = (((_e2922 - _e2946) / (_e2922 - _e2933)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    if (_e2891 < _e2969) {
                                                                                        phi_7204_ = _e2891;
                                                                                    } else {
                                                                                        phi_7204_ = _e2969;
                                                                                    }
                                                                                    let _e2972 = phi_7204_;
                                                                                    phi_7205_ = _e2972;
                                                                                } else {
                                                                                    phi_7205_ = f64();
                                                                                }
                                                                                let _e2974 = phi_7205_;
                                                                                phi_7206_ = _e2974;
                                                                                phi_7207_ = _e2961;
                                                                            } else {
                                                                                phi_7206_ = _e2891;
                                                                                phi_7207_ = true;
                                                                            }
                                                                            let _e2976 = phi_7206_;
                                                                            let _e2978 = phi_7207_;
                                                                            if _e2978 {
                                                                                phi_7211_ = false;
                                                                            } else {
                                                                                phi_7211_ = true;
                                                                            }
                                                                            let _e2980 = phi_7211_;
                                                                            phi_7212_ = _e2976;
                                                                            phi_7213_ = _e2978;
                                                                            phi_7214_ = _e2980;
                                                                            phi_7215_ = false;
                                                                        } else {
                                                                            phi_7212_ = f64();
                                                                            phi_7213_ = false;
                                                                            phi_7214_ = false;
                                                                            phi_7215_ = true;
                                                                        }
                                                                        let _e2982 = phi_7212_;
                                                                        let _e2984 = phi_7213_;
                                                                        let _e2986 = phi_7214_;
                                                                        let _e2988 = phi_7215_;
                                                                        phi_7216_ = _e2982;
                                                                        phi_7217_ = _e2984;
                                                                        phi_7218_ = _e2986;
                                                                        phi_7219_ = _e2988;
                                                                    } else {
                                                                        phi_7216_ = _e2891;
                                                                        phi_7217_ = true;
                                                                        phi_7218_ = false;
                                                                        phi_7219_ = false;
                                                                    }
                                                                    let _e2990 = phi_7216_;
                                                                    let _e2992 = phi_7217_;
                                                                    let _e2994 = phi_7218_;
                                                                    let _e2996 = phi_7219_;
                                                                    phi_7076_ = _e2990;
                                                                    phi_7220_ = _e2992;
                                                                    phi_7221_ = false;
                                                                    phi_7222_ = _e2994;
                                                                    phi_7223_ = _e2996;
                                                                } else {
                                                                    phi_7076_ = f64();
                                                                    phi_7220_ = false;
                                                                    phi_7221_ = true;
                                                                    phi_7222_ = false;
                                                                    phi_7223_ = false;
                                                                }
                                                                let _e2998 = phi_7076_;
                                                                let _e3000 = phi_7220_;
                                                                let _e3002 = phi_7221_;
                                                                let _e3004 = phi_7222_;
                                                                let _e3006 = phi_7223_;
                                                                local_27 = _e3002;
                                                                local_58 = _e3004;
                                                                local_59 = _e3006;
                                                                continue;
                                                                continuing {
                                                                    phi_7072_ = _e2905;
                                                                    phi_7075_ = _e2998;
                                                                    break if !(_e3000);
                                                                }
                                                            }
                                                            let _e3009 = local_27;
                                                            if _e3009 {
                                                                let _e3011 = local_28;
                                                                let _e3012 = (_e3011 > _e1428.member_1);
                                                                if _e3012 {
                                                                    phi_7245_ = false;
                                                                    phi_7246_ = false;
                                                                    phi_7247_ = false;
                                                                } else {
                                                                    let _e3014 = local_29;
                                                                    if (_e3014 > _e2428) {
                                                                        let _e3017 = local_30;
                                                                        let _e3020 = ((_e3017 - _e2428) < f64(0.00000000023283064f));
                                                                        if _e3020 {
                                                                            phi_7241_ = false;
                                                                        } else {
                                                                            phi_7241_ = true;
                                                                        }
                                                                        let _e3022 = phi_7241_;
                                                                        phi_7242_ = _e3022;
                                                                        phi_7243_ = _e3020;
                                                                        phi_7244_ = false;
                                                                    } else {
                                                                        phi_7242_ = false;
                                                                        phi_7243_ = false;
                                                                        phi_7244_ = true;
                                                                    }
                                                                    let _e3024 = phi_7242_;
                                                                    let _e3026 = phi_7243_;
                                                                    let _e3028 = phi_7244_;
                                                                    phi_7245_ = _e3024;
                                                                    phi_7246_ = _e3026;
                                                                    phi_7247_ = _e3028;
                                                                }
                                                                let _e3030 = phi_7245_;
                                                                let _e3032 = phi_7246_;
                                                                let _e3034 = phi_7247_;
                                                                phi_7248_ = _e3030;
                                                                phi_7249_ = _e3012;
                                                                phi_7250_ = _e3032;
                                                                phi_7251_ = _e3034;
                                                                phi_7252_ = false;
                                                                phi_7253_ = false;
                                                            } else {
                                                                phi_7248_ = false;
                                                                phi_7249_ = false;
                                                                phi_7250_ = false;
                                                                phi_7251_ = false;
                                                                let _e5508 = local_58;
                                                                phi_7252_ = _e5508;
                                                                let _e5511 = local_59;
                                                                phi_7253_ = _e5511;
                                                            }
                                                            let _e3036 = phi_7248_;
                                                            let _e3038 = phi_7249_;
                                                            let _e3040 = phi_7250_;
                                                            let _e3042 = phi_7251_;
                                                            let _e3044 = phi_7252_;
                                                            let _e3046 = phi_7253_;
                                                            let _e5514 = local_60;
                                                            phi_7254_ = _e5514;
                                                            let _e5517 = local_61;
                                                            phi_7255_ = _e5517;
                                                            phi_7256_ = _e3036;
                                                            phi_7257_ = _e3038;
                                                            phi_7258_ = _e3040;
                                                            phi_7259_ = _e3042;
                                                            phi_7260_ = _e3044;
                                                            phi_7261_ = _e3046;
                                                            phi_7262_ = false;
                                                        } else {
                                                            phi_7254_ = f64();
                                                            phi_7255_ = f64();
                                                            phi_7256_ = false;
                                                            phi_7257_ = false;
                                                            phi_7258_ = false;
                                                            phi_7259_ = false;
                                                            phi_7260_ = false;
                                                            phi_7261_ = false;
                                                            phi_7262_ = true;
                                                        }
                                                        let _e3048 = phi_7254_;
                                                        let _e3050 = phi_7255_;
                                                        let _e3052 = phi_7256_;
                                                        let _e3054 = phi_7257_;
                                                        let _e3056 = phi_7258_;
                                                        let _e3058 = phi_7259_;
                                                        let _e3060 = phi_7260_;
                                                        let _e3062 = phi_7261_;
                                                        let _e3064 = phi_7262_;
                                                        phi_7263_ = _e3048;
                                                        phi_7264_ = _e3050;
                                                        phi_7265_ = _e3052;
                                                        phi_7266_ = _e3054;
                                                        phi_7267_ = _e3056;
                                                        phi_7268_ = _e3058;
                                                        phi_7269_ = _e3060;
                                                        phi_7270_ = _e3062;
                                                        phi_7271_ = _e3064;
                                                        phi_7272_ = false;
                                                    } else {
                                                        phi_7263_ = f64();
                                                        phi_7264_ = f64();
                                                        phi_7265_ = false;
                                                        phi_7266_ = false;
                                                        phi_7267_ = false;
                                                        phi_7268_ = false;
                                                        phi_7269_ = false;
                                                        phi_7270_ = false;
                                                        phi_7271_ = false;
                                                        phi_7272_ = true;
                                                    }
                                                    let _e3066 = phi_7263_;
                                                    let _e3068 = phi_7264_;
                                                    let _e3070 = phi_7265_;
                                                    let _e3072 = phi_7266_;
                                                    let _e3074 = phi_7267_;
                                                    let _e3076 = phi_7268_;
                                                    let _e3078 = phi_7269_;
                                                    let _e3080 = phi_7270_;
                                                    let _e3082 = phi_7271_;
                                                    let _e3084 = phi_7272_;
                                                    phi_7273_ = _e3066;
                                                    phi_6322_ = _e3068;
                                                    phi_7274_ = _e3070;
                                                    phi_7275_ = _e3072;
                                                    phi_7276_ = _e3074;
                                                    phi_7277_ = false;
                                                    phi_7278_ = _e3076;
                                                    phi_7279_ = _e3078;
                                                    phi_7280_ = _e3080;
                                                    phi_7281_ = _e3082;
                                                    phi_7282_ = _e3084;
                                                } else {
                                                    phi_7273_ = f64();
                                                    phi_6322_ = f64();
                                                    phi_7274_ = false;
                                                    phi_7275_ = false;
                                                    phi_7276_ = false;
                                                    phi_7277_ = true;
                                                    phi_7278_ = false;
                                                    phi_7279_ = false;
                                                    phi_7280_ = false;
                                                    phi_7281_ = false;
                                                    phi_7282_ = false;
                                                }
                                                let _e3086 = phi_7273_;
                                                let _e3088 = phi_6322_;
                                                let _e3090 = phi_7274_;
                                                let _e3092 = phi_7275_;
                                                let _e3094 = phi_7276_;
                                                let _e3096 = phi_7277_;
                                                let _e3098 = phi_7278_;
                                                let _e3100 = phi_7279_;
                                                let _e3102 = phi_7280_;
                                                let _e3104 = phi_7281_;
                                                let _e3106 = phi_7282_;
                                                local_31 = _e3092;
                                                local_62 = _e3094;
                                                local_63 = _e3096;
                                                local_64 = _e3098;
                                                local_65 = _e3100;
                                                local_66 = _e3102;
                                                local_67 = _e3104;
                                                local_68 = _e3106;
                                                local_69 = _e3086;
                                                local_71 = _e3092;
                                                continue;
                                                continuing {
                                                    phi_6318_ = _e2442;
                                                    phi_6321_ = _e3088;
                                                    break if !(_e3090);
                                                }
                                            }
                                            let _e3109 = local_31;
                                            if _e3109 {
                                                phi_7287_ = type_72(0u, type_72().member_1);
                                                phi_7288_ = false;
                                                phi_7289_ = false;
                                                phi_7290_ = false;
                                                phi_7291_ = false;
                                                phi_7292_ = false;
                                                phi_7293_ = false;
                                                phi_7294_ = false;
                                            } else {
                                                phi_7287_ = type_72();
                                                let _e5550 = local_62;
                                                phi_7288_ = _e5550;
                                                let _e5553 = local_63;
                                                phi_7289_ = _e5553;
                                                let _e5556 = local_64;
                                                phi_7290_ = _e5556;
                                                let _e5559 = local_65;
                                                phi_7291_ = _e5559;
                                                let _e5562 = local_66;
                                                phi_7292_ = _e5562;
                                                let _e5565 = local_67;
                                                phi_7293_ = _e5565;
                                                let _e5568 = local_68;
                                                phi_7294_ = _e5568;
                                            }
                                            let _e3114 = phi_7287_;
                                            let _e3116 = phi_7288_;
                                            let _e3118 = phi_7289_;
                                            let _e3120 = phi_7290_;
                                            let _e3122 = phi_7291_;
                                            let _e3124 = phi_7292_;
                                            let _e3126 = phi_7293_;
                                            let _e3128 = phi_7294_;
                                            if _e3116 {
                                                let _e5571 = local_69;
                                                phi_7298_ = _e5571;
                                                phi_7299_ = true;
                                                phi_7300_ = false;
                                                phi_7301_ = false;
                                                phi_7302_ = false;
                                                phi_7303_ = false;
                                                phi_7304_ = false;
                                                phi_7305_ = false;
                                            } else {
                                                let _e5573 = local_70;
                                                phi_7298_ = _e5573;
                                                phi_7299_ = _e3118;
                                                phi_7300_ = _e3120;
                                                phi_7301_ = _e3122;
                                                phi_7302_ = _e3124;
                                                let _e5580 = local_71;
                                                phi_7303_ = _e5580;
                                                phi_7304_ = _e3126;
                                                phi_7305_ = _e3128;
                                            }
                                            let _e3130 = phi_7298_;
                                            let _e3132 = phi_7299_;
                                            let _e3134 = phi_7300_;
                                            let _e3136 = phi_7301_;
                                            let _e3138 = phi_7302_;
                                            let _e3140 = phi_7303_;
                                            let _e3142 = phi_7304_;
                                            let _e3144 = phi_7305_;
                                            if _e3132 {
                                                phi_7310_ = type_72(1u, _e3130);
                                                phi_7311_ = false;
                                                phi_7312_ = false;
                                                phi_7313_ = false;
                                                phi_7314_ = false;
                                                phi_7315_ = false;
                                                phi_7316_ = false;
                                            } else {
                                                phi_7310_ = type_72();
                                                phi_7311_ = _e3134;
                                                phi_7312_ = _e3136;
                                                phi_7313_ = _e3138;
                                                phi_7314_ = _e3140;
                                                phi_7315_ = _e3142;
                                                phi_7316_ = _e3144;
                                            }
                                            let _e3147 = phi_7310_;
                                            let _e3149 = phi_7311_;
                                            let _e3151 = phi_7312_;
                                            let _e3153 = phi_7313_;
                                            let _e3155 = phi_7314_;
                                            let _e3157 = phi_7315_;
                                            let _e3159 = phi_7316_;
                                            if _e3149 {
                                                let _e3161 = local_32;
                                                phi_7321_ = type_72(1u, _e3161);
                                                phi_7322_ = false;
                                                phi_7323_ = false;
                                                phi_7324_ = true;
                                                phi_7325_ = false;
                                                phi_7326_ = false;
                                            } else {
                                                phi_7321_ = _e3114;
                                                phi_7322_ = _e3151;
                                                phi_7323_ = _e3153;
                                                phi_7324_ = _e3155;
                                                phi_7325_ = _e3157;
                                                phi_7326_ = _e3159;
                                            }
                                            let _e3164 = phi_7321_;
                                            let _e3166 = phi_7322_;
                                            let _e3168 = phi_7323_;
                                            let _e3170 = phi_7324_;
                                            let _e3172 = phi_7325_;
                                            let _e3174 = phi_7326_;
                                            if _e3166 {
                                                let _e3176 = local_33;
                                                phi_7331_ = type_72(1u, _e3176);
                                                phi_7332_ = false;
                                                phi_7333_ = false;
                                                phi_7334_ = false;
                                                phi_7335_ = false;
                                            } else {
                                                phi_7331_ = type_72();
                                                phi_7332_ = _e3168;
                                                phi_7333_ = _e3170;
                                                phi_7334_ = _e3172;
                                                phi_7335_ = _e3174;
                                            }
                                            let _e3179 = phi_7331_;
                                            let _e3181 = phi_7332_;
                                            let _e3183 = phi_7333_;
                                            let _e3185 = phi_7334_;
                                            let _e3187 = phi_7335_;
                                            if _e3181 {
                                                let _e3189 = local_34;
                                                phi_7340_ = type_72(1u, _e3189);
                                                phi_7341_ = true;
                                                phi_7342_ = false;
                                                phi_7343_ = false;
                                                phi_7344_ = false;
                                            } else {
                                                phi_7340_ = _e3179;
                                                phi_7341_ = _e3166;
                                                phi_7342_ = _e3183;
                                                phi_7343_ = _e3185;
                                                phi_7344_ = _e3187;
                                            }
                                            let _e3192 = phi_7340_;
                                            let _e3194 = phi_7341_;
                                            let _e3196 = phi_7342_;
                                            let _e3198 = phi_7343_;
                                            let _e3200 = phi_7344_;
                                            if _e3194 {
                                                phi_7348_ = _e3192;
                                                phi_7349_ = true;
                                                phi_7350_ = false;
                                                phi_7351_ = false;
                                            } else {
                                                phi_7348_ = _e3164;
                                                phi_7349_ = _e3196;
                                                phi_7350_ = _e3198;
                                                phi_7351_ = _e3200;
                                            }
                                            let _e3202 = phi_7348_;
                                            let _e3204 = phi_7349_;
                                            let _e3206 = phi_7350_;
                                            let _e3208 = phi_7351_;
                                            if _e3204 {
                                                phi_7355_ = false;
                                                phi_7356_ = false;
                                            } else {
                                                phi_7355_ = _e3206;
                                                phi_7356_ = _e3208;
                                            }
                                            let _e3210 = phi_7355_;
                                            let _e3212 = phi_7356_;
                                            if _e3210 {
                                                phi_7360_ = false;
                                                phi_7361_ = false;
                                            } else {
                                                phi_7360_ = _e3212;
                                                phi_7361_ = _e3204;
                                            }
                                            let _e3214 = phi_7360_;
                                            let _e3216 = phi_7361_;
                                            if _e3214 {
                                                phi_7365_ = true;
                                                phi_7366_ = false;
                                            } else {
                                                phi_7365_ = _e3210;
                                                phi_7366_ = _e3216;
                                            }
                                            let _e3218 = phi_7365_;
                                            let _e3220 = phi_7366_;
                                            if _e3218 {
                                                let _e3222 = local_35;
                                                phi_7371_ = type_72(1u, _e3222);
                                                phi_7372_ = true;
                                            } else {
                                                phi_7371_ = _e3202;
                                                phi_7372_ = _e3220;
                                            }
                                            let _e3225 = phi_7371_;
                                            let _e3227 = phi_7372_;
                                            if _e3227 {
                                                phi_7376_ = _e3225;
                                            } else {
                                                phi_7376_ = _e3147;
                                            }
                                            let _e3229 = phi_7376_;
                                            let _e3232 = (_e3229.member != 0u);
                                            if _e3232 {
                                                phi_7383_ = false;
                                            } else {
                                                phi_7383_ = true;
                                            }
                                            let _e3234 = phi_7383_;
                                            phi_7384_ = _e3229.member_1;
                                            phi_7385_ = _e3234;
                                            phi_7386_ = _e3232;
                                            phi_7387_ = false;
                                        } else {
                                            phi_7384_ = f64();
                                            phi_7385_ = false;
                                            phi_7386_ = false;
                                            phi_7387_ = true;
                                        }
                                        let _e3236 = phi_7384_;
                                        let _e3238 = phi_7385_;
                                        let _e3240 = phi_7386_;
                                        let _e3242 = phi_7387_;
                                        phi_7388_ = _e3236;
                                        phi_7389_ = _e3238;
                                        phi_7390_ = _e3240;
                                        phi_7391_ = _e3242;
                                    }
                                    let _e3244 = phi_7388_;
                                    let _e3246 = phi_7389_;
                                    let _e3248 = phi_7390_;
                                    let _e3250 = phi_7391_;
                                    phi_7392_ = _e3244;
                                    phi_7393_ = _e2170;
                                    phi_7394_ = _e3246;
                                    phi_7395_ = _e3248;
                                    phi_7396_ = _e3250;
                                }
                                let _e3252 = phi_7392_;
                                let _e3254 = phi_7393_;
                                let _e3256 = phi_7394_;
                                let _e3258 = phi_7395_;
                                let _e3260 = phi_7396_;
                                if _e3254 {
                                    phi_7400_ = true;
                                    phi_7401_ = false;
                                    phi_7402_ = false;
                                } else {
                                    phi_7400_ = _e3256;
                                    phi_7401_ = _e3258;
                                    phi_7402_ = _e3260;
                                }
                                let _e3262 = phi_7400_;
                                let _e3264 = phi_7401_;
                                let _e3266 = phi_7402_;
                                phi_7403_ = _e3252;
                                phi_7404_ = _e1428;
                                phi_7405_ = _e3262;
                                phi_7406_ = false;
                                phi_7407_ = _e3264;
                                phi_7408_ = _e3266;
                            } else {
                                phi_7403_ = f64();
                                phi_7404_ = type_73();
                                phi_7405_ = false;
                                phi_7406_ = true;
                                phi_7407_ = false;
                                phi_7408_ = false;
                            }
                            let _e3268 = phi_7403_;
                            let _e3270 = phi_7404_;
                            let _e3272 = phi_7405_;
                            let _e3274 = phi_7406_;
                            let _e3276 = phi_7407_;
                            let _e3278 = phi_7408_;
                            local_36 = _e3274;
                            local_72 = _e3276;
                            local_73 = _e3278;
                            local_37 = _e3268;
                            local_38 = _e3270;
                            continue;
                            continuing {
                                phi_4357_ = _e1109;
                                break if !(_e3272);
                            }
                        }
                        let _e3281 = local_36;
                        if _e3281 {
                            phi_7413_ = type_72(0u, type_72().member_1);
                            phi_7414_ = false;
                            phi_7415_ = false;
                        } else {
                            phi_7413_ = type_72();
                            let _e5650 = local_72;
                            phi_7414_ = _e5650;
                            let _e5653 = local_73;
                            phi_7415_ = _e5653;
                        }
                        let _e3286 = phi_7413_;
                        let _e3288 = phi_7414_;
                        let _e3290 = phi_7415_;
                        if _e3288 {
                            let _e3292 = local_37;
                            phi_7420_ = type_72(2u, _e3292);
                            phi_7421_ = false;
                        } else {
                            phi_7420_ = type_72();
                            phi_7421_ = _e3290;
                        }
                        let _e3295 = phi_7420_;
                        let _e3297 = phi_7421_;
                        if _e3297 {
                            let _e3299 = local_38;
                            phi_7427_ = type_72(1u, _e3299.member);
                            phi_7428_ = true;
                        } else {
                            phi_7427_ = _e3295;
                            phi_7428_ = _e3288;
                        }
                        let _e3303 = phi_7427_;
                        let _e3305 = phi_7428_;
                        if _e3305 {
                            phi_7432_ = _e3303;
                        } else {
                            phi_7432_ = _e3286;
                        }
                        let _e3307 = phi_7432_;
                        phi_7436_ = _e3307;
                    }
                    let _e5013 = phi_7436_;
                    phi_7437_ = _e5013;
                }
                let _e5018 = phi_7437_;
                switch bitcast<i32>(_e5018.member) {
                    case 0: {
                        phi_7458_ = type_46(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5028 = bitcast<u64>(_e5018.member_1);
                        phi_7458_ = type_46(0u, array<u32, 2>(u32(_e5028), u32((_e5028 / 4294967296lu))), true);
                        break;
                    }
                    case 2: {
                        let _e5022 = bitcast<u64>(_e5018.member_1);
                        phi_7458_ = type_46(1u, array<u32, 2>(u32(_e5022), u32((_e5022 / 4294967296lu))), true);
                        break;
                    }
                    default: {
                        phi_7458_ = type_46();
                        break;
                    }
                }
                let _e5035 = phi_7458_;
                if _e5035.member_2 {
                    let _e5042 = (_e5035.member_1[1] >> bitcast<u32>(20i));
                    if (_e5042 <= 896u) {
                        phi_7481_ = 0u;
                    } else {
                        phi_7481_ = ((((_e5042 - 896u) << bitcast<u32>(23i)) | ((_e5035.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5035.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5057 = phi_7481_;
                    let _e5059 = atomicMin((&earliest.member[0u]), _e5057);
                }
                phi_7485_ = type_45(_e186, _e5035.member, _e192, _e195, _e5035.member_1);
                phi_7486_ = _e5035.member_2;
            } else {
                phi_7485_ = type_45(_e186, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_7486_ = false;
            }
            let _e5061 = phi_7485_;
            let _e5063 = phi_7486_;
            let _e5065 = params.member.member_1;
            if ((_e5065 & 16u) != 0u) {
                if (_e117 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5063 {
                    let _e5071 = atomicAdd((&counters[0u]), 1u);
                    phi_7504_ = _e5071;
                } else {
                    phi_7504_ = 0u;
                }
                let _e5073 = phi_7504_;
                workgroupBarrier();
                if (_e117 == 0u) {
                    let _e5076 = atomicLoad((&counters[0u]));
                    if (_e5076 > 0u) {
                        let _e5079 = atomicAdd((&contacts.member[0u]), _e5076);
                        atomicStore((&counters[1u]), _e5079);
                    }
                }
                workgroupBarrier();
                let _e5082 = atomicLoad((&counters[1u]));
                let _e5083 = (_e5082 + _e5073);
                if _e5063 {
                    let _e5085 = params.member.member_16;
                    if (_e5083 < _e5085) {
                        let _e5087 = (6u * _e5083);
                        atomicStore((&contacts.member[(4u + _e5087)]), _e5061.member);
                        atomicStore((&contacts.member[(_e5087 + 5u)]), _e5061.member_1);
                        atomicStore((&contacts.member[(_e5087 + 6u)]), _e5061.member_2);
                        atomicStore((&contacts.member[(_e5087 + 7u)]), _e5061.member_3);
                        atomicStore((&contacts.member[(_e5087 + 8u)]), _e5061.member_4[0]);
                        atomicStore((&contacts.member[(_e5087 + 9u)]), _e5061.member_4[1]);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_271_ = _e174;
            break if !(_e180);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
