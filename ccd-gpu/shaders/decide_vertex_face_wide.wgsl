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
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_47 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_52 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_54 {
    member: f64,
    member_1: f64,
}

struct type_62 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_64 {
    member: array<f64, 3>,
    member_1: array<f64, 3>,
}

struct type_67 {
    member: array<type_64>,
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
var<storage> params: type_12;
@group(0) @binding(1) 
var<storage> paths: type_39;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_78;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> wide: type_67;
@group(0) @binding(4) 
var<storage> input: type_16;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_78;
@group(0) @binding(3) 
var<storage> elements: type_20;

fn function_(param: f64) -> array<u32, 2> {
    let _e95 = bitcast<u64>(param);
    return array<u32, 2>(u32(_e95), u32((_e95 / 4294967296lu)));
}

fn function_1() {
    var local: array<array<f64, 3>, 4>;
    var local_1: array<array<f64, 3>, 4>;
    var local_2: array<array<f64, 3>, 4>;
    var local_3: type_52;
    var local_4: type_52;
    var local_5: type_52;
    var local_6: array<type_54, 4>;
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
    var local_20: type_62;
    var phi_240_: u32;
    var phi_256_: u32;
    var phi_277_: u32;
    var phi_278_: u32;
    var phi_281_: type_29;
    var phi_282_: type_29;
    var phi_305_: type_29;
    var phi_637_: type_29;
    var phi_638_: type_29;
    var phi_661_: type_29;
    var phi_517_: type_29;
    var phi_518_: type_29;
    var phi_541_: type_29;
    var phi_551_: type_29;
    var phi_552_: type_29;
    var phi_575_: type_29;
    var phi_1118_: f64;
    var phi_1125_: f64;
    var phi_1130_: f64;
    var phi_1137_: f64;
    var phi_1142_: f64;
    var phi_1155_: f64;
    var phi_1162_: f64;
    var phi_1167_: f64;
    var phi_1174_: f64;
    var phi_1179_: f64;
    var phi_1184_: f64;
    var phi_1201_: f64;
    var phi_1208_: f64;
    var phi_1213_: f64;
    var phi_1220_: f64;
    var phi_1225_: f64;
    var phi_1239_: f64;
    var phi_1246_: f64;
    var phi_1251_: f64;
    var phi_1258_: f64;
    var phi_1263_: f64;
    var phi_1268_: f64;
    var phi_1285_: f64;
    var phi_1292_: f64;
    var phi_1297_: f64;
    var phi_1304_: f64;
    var phi_1309_: f64;
    var phi_1323_: f64;
    var phi_1330_: f64;
    var phi_1335_: f64;
    var phi_1342_: f64;
    var phi_1347_: f64;
    var phi_1352_: f64;
    var phi_1389_: f64;
    var phi_1395_: f64;
    var phi_1402_: f64;
    var phi_1409_: f64;
    var phi_1415_: f64;
    var phi_1422_: f64;
    var phi_1428_: f64;
    var phi_1434_: f64;
    var phi_1440_: f64;
    var phi_1447_: f64;
    var phi_1454_: f64;
    var phi_1482_: f64;
    var phi_1487_: f64;
    var phi_1492_: f64;
    var phi_1497_: f64;
    var phi_1502_: f64;
    var phi_1507_: f64;
    var phi_1518_: f64;
    var phi_4075_: f64;
    var phi_4081_: f64;
    var phi_4086_: f64;
    var phi_4092_: f64;
    var phi_4098_: f64;
    var phi_4103_: f64;
    var phi_4108_: f64;
    var phi_4118_: bool;
    var phi_4125_: f64;
    var phi_4133_: f64;
    var phi_4176_: type_27;
    var phi_4179_: f64;
    var phi_4200_: bool;
    var phi_4206_: type_28;
    var phi_4177_: type_27;
    var phi_4220_: type_28;
    var phi_4180_: f64;
    var local_21: f64;
    var phi_4169_: f64;
    var phi_4233_: f64;
    var phi_4239_: f64;
    var phi_4264_: type_29;
    var phi_4267_: u32;
    var phi_4265_: type_29;
    var phi_4290_: type_29;
    var phi_4334_: u32;
    var phi_4335_: u32;
    var phi_4268_: u32;
    var phi_4336_: u32;
    var phi_4356_: type_29;
    var phi_4357_: type_29;
    var phi_4380_: type_29;
    var phi_4434_: f64;
    var phi_4441_: f64;
    var phi_4453_: bool;
    var phi_4454_: bool;
    var phi_4455_: bool;
    var phi_4456_: bool;
    var phi_4460_: bool;
    var phi_4472_: type_74;
    var phi_4473_: type_74;
    var phi_4474_: bool;
    var phi_4475_: type_74;
    var phi_4476_: bool;
    var phi_4489_: f64;
    var phi_4502_: type_29;
    var phi_4505_: f64;
    var phi_4507_: f64;
    var phi_4509_: f64;
    var phi_4503_: type_29;
    var phi_4532_: type_29;
    var phi_4559_: f64;
    var phi_4560_: f64;
    var phi_4588_: f64;
    var phi_4604_: f64;
    var phi_4611_: bool;
    var phi_4612_: bool;
    var phi_4613_: bool;
    var phi_4619_: f64;
    var phi_4620_: f64;
    var phi_4621_: bool;
    var phi_4506_: f64;
    var phi_4508_: f64;
    var phi_4510_: f64;
    var phi_4622_: f64;
    var phi_4623_: bool;
    var phi_4624_: bool;
    var local_22: bool;
    var phi_4628_: f64;
    var phi_4629_: f64;
    var phi_4637_: type_29;
    var phi_4640_: f64;
    var phi_4638_: type_29;
    var phi_4663_: type_29;
    var phi_4706_: f64;
    var phi_4716_: f64;
    var phi_4726_: bool;
    var phi_4728_: bool;
    var phi_4733_: f64;
    var phi_4734_: bool;
    var phi_4735_: f64;
    var phi_4736_: bool;
    var phi_4737_: bool;
    var phi_4738_: bool;
    var phi_4739_: f64;
    var phi_4641_: f64;
    var phi_4740_: bool;
    var phi_4741_: bool;
    var phi_4742_: bool;
    var phi_4743_: bool;
    var local_23: bool;
    var phi_4747_: bool;
    var phi_4748_: bool;
    var phi_4752_: bool;
    var phi_4756_: f64;
    var phi_4757_: f64;
    var phi_4759_: type_74;
    var phi_4790_: f64;
    var phi_4797_: f64;
    var phi_4802_: f64;
    var phi_4809_: f64;
    var phi_4814_: f64;
    var phi_4827_: f64;
    var phi_4834_: f64;
    var phi_4839_: f64;
    var phi_4846_: f64;
    var phi_4851_: f64;
    var phi_4856_: f64;
    var phi_4915_: f64;
    var phi_4921_: f64;
    var phi_4926_: f64;
    var phi_4932_: f64;
    var phi_4937_: f64;
    var phi_4951_: f64;
    var phi_4957_: f64;
    var phi_4962_: f64;
    var phi_4968_: f64;
    var phi_4973_: f64;
    var phi_4999_: f64;
    var phi_5006_: f64;
    var phi_5011_: f64;
    var phi_5018_: f64;
    var phi_5023_: f64;
    var phi_5036_: f64;
    var phi_5043_: f64;
    var phi_5048_: f64;
    var phi_5055_: f64;
    var phi_5060_: f64;
    var phi_5065_: f64;
    var phi_5124_: f64;
    var phi_5130_: f64;
    var phi_5135_: f64;
    var phi_5141_: f64;
    var phi_5146_: f64;
    var phi_5160_: f64;
    var phi_5166_: f64;
    var phi_5171_: f64;
    var phi_5177_: f64;
    var phi_5182_: f64;
    var phi_5208_: f64;
    var phi_5215_: f64;
    var phi_5220_: f64;
    var phi_5227_: f64;
    var phi_5232_: f64;
    var phi_5245_: f64;
    var phi_5252_: f64;
    var phi_5257_: f64;
    var phi_5264_: f64;
    var phi_5269_: f64;
    var phi_5274_: f64;
    var phi_5333_: f64;
    var phi_5339_: f64;
    var phi_5344_: f64;
    var phi_5350_: f64;
    var phi_5355_: f64;
    var phi_5369_: f64;
    var phi_5375_: f64;
    var phi_5380_: f64;
    var phi_5386_: f64;
    var phi_5391_: f64;
    var phi_5440_: f64;
    var phi_5446_: f64;
    var phi_5474_: f64;
    var phi_5480_: f64;
    var phi_5485_: u32;
    var phi_5486_: u32;
    var phi_5456_: f64;
    var phi_5462_: f64;
    var phi_5467_: u32;
    var phi_5468_: u32;
    var phi_5487_: u32;
    var phi_5488_: u32;
    var phi_5559_: f64;
    var phi_5571_: f64;
    var phi_5710_: f64;
    var phi_5716_: f64;
    var phi_5723_: f64;
    var phi_5767_: type_29;
    var phi_5770_: bool;
    var phi_5768_: type_29;
    var phi_5793_: type_29;
    var phi_5820_: bool;
    var phi_5821_: bool;
    var phi_5771_: bool;
    var phi_5822_: bool;
    var phi_5823_: bool;
    var local_24: bool;
    var phi_5827_: bool;
    var local_25: bool;
    var phi_5834_: u32;
    var phi_5835_: u32;
    var phi_5836_: bool;
    var phi_5837_: u32;
    var phi_5838_: u32;
    var phi_5839_: bool;
    var phi_5843_: u32;
    var phi_5864_: bool;
    var phi_5865_: bool;
    var phi_5866_: bool;
    var phi_6063_: f64;
    var phi_6070_: f64;
    var phi_6075_: f64;
    var phi_6082_: f64;
    var phi_6087_: f64;
    var phi_6100_: f64;
    var phi_6107_: f64;
    var phi_6112_: f64;
    var phi_6119_: f64;
    var phi_6124_: f64;
    var phi_6129_: f64;
    var phi_6146_: f64;
    var phi_6153_: f64;
    var phi_6158_: f64;
    var phi_6165_: f64;
    var phi_6170_: f64;
    var phi_6184_: f64;
    var phi_6191_: f64;
    var phi_6196_: f64;
    var phi_6203_: f64;
    var phi_6208_: f64;
    var phi_6213_: f64;
    var phi_6230_: f64;
    var phi_6237_: f64;
    var phi_6242_: f64;
    var phi_6249_: f64;
    var phi_6254_: f64;
    var phi_6268_: f64;
    var phi_6275_: f64;
    var phi_6280_: f64;
    var phi_6287_: f64;
    var phi_6292_: f64;
    var phi_6297_: f64;
    var phi_6317_: type_29;
    var phi_6320_: f64;
    var phi_6318_: type_29;
    var phi_6343_: type_29;
    var phi_6519_: bool;
    var phi_6520_: bool;
    var phi_6521_: bool;
    var phi_6522_: bool;
    var phi_6526_: bool;
    var phi_6548_: array<f64, 3>;
    var phi_6549_: bool;
    var phi_6550_: array<f64, 3>;
    var phi_6551_: bool;
    var phi_6738_: f64;
    var phi_6740_: f64;
    var phi_6770_: f64;
    var phi_6772_: f64;
    var phi_6802_: f64;
    var phi_6804_: f64;
    var phi_6840_: type_29;
    var phi_6843_: array<f64, 3>;
    var phi_6841_: type_29;
    var phi_6866_: type_29;
    var phi_6933_: array<f64, 3>;
    var phi_6844_: array<f64, 3>;
    var phi_6934_: array<f64, 3>;
    var phi_6941_: f64;
    var phi_6948_: f64;
    var phi_6956_: f64;
    var phi_7001_: type_27;
    var phi_7004_: f64;
    var phi_7025_: bool;
    var phi_7031_: type_28;
    var phi_7002_: type_27;
    var phi_7045_: type_28;
    var phi_7005_: f64;
    var local_26: f64;
    var phi_6994_: f64;
    var phi_7058_: f64;
    var phi_7071_: type_29;
    var phi_7074_: f64;
    var phi_7072_: type_29;
    var phi_7097_: type_29;
    var phi_7148_: f64;
    var phi_7154_: f64;
    var phi_7168_: bool;
    var phi_7169_: bool;
    var phi_7203_: f64;
    var phi_7204_: f64;
    var phi_7205_: f64;
    var phi_7206_: bool;
    var phi_7210_: bool;
    var phi_7211_: f64;
    var phi_7212_: bool;
    var phi_7213_: bool;
    var phi_7214_: bool;
    var phi_7215_: f64;
    var phi_7216_: bool;
    var phi_7217_: bool;
    var phi_7218_: bool;
    var phi_7075_: f64;
    var phi_7219_: bool;
    var phi_7220_: bool;
    var phi_7221_: bool;
    var phi_7222_: bool;
    var local_27: bool;
    var local_28: f64;
    var local_29: f64;
    var local_30: f64;
    var phi_7240_: bool;
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
    var phi_7253_: f64;
    var phi_7254_: f64;
    var phi_7255_: bool;
    var phi_7256_: bool;
    var phi_7257_: bool;
    var phi_7258_: bool;
    var phi_7259_: bool;
    var phi_7260_: bool;
    var phi_7261_: bool;
    var phi_7262_: f64;
    var phi_7263_: f64;
    var phi_7264_: bool;
    var phi_7265_: bool;
    var phi_7266_: bool;
    var phi_7267_: bool;
    var phi_7268_: bool;
    var phi_7269_: bool;
    var phi_7270_: bool;
    var phi_7271_: bool;
    var phi_7272_: f64;
    var phi_6321_: f64;
    var phi_7273_: bool;
    var phi_7274_: bool;
    var phi_7275_: bool;
    var phi_7276_: bool;
    var phi_7277_: bool;
    var phi_7278_: bool;
    var phi_7279_: bool;
    var phi_7280_: bool;
    var phi_7281_: bool;
    var local_31: bool;
    var phi_7286_: type_73;
    var phi_7287_: bool;
    var phi_7288_: bool;
    var phi_7289_: bool;
    var phi_7290_: bool;
    var phi_7291_: bool;
    var phi_7292_: bool;
    var phi_7293_: bool;
    var phi_7297_: f64;
    var phi_7298_: bool;
    var phi_7299_: bool;
    var phi_7300_: bool;
    var phi_7301_: bool;
    var phi_7302_: bool;
    var phi_7303_: bool;
    var phi_7304_: bool;
    var phi_7309_: type_73;
    var phi_7310_: bool;
    var phi_7311_: bool;
    var phi_7312_: bool;
    var phi_7313_: bool;
    var phi_7314_: bool;
    var phi_7315_: bool;
    var local_32: f64;
    var phi_7320_: type_73;
    var phi_7321_: bool;
    var phi_7322_: bool;
    var phi_7323_: bool;
    var phi_7324_: bool;
    var phi_7325_: bool;
    var local_33: f64;
    var phi_7330_: type_73;
    var phi_7331_: bool;
    var phi_7332_: bool;
    var phi_7333_: bool;
    var phi_7334_: bool;
    var local_34: f64;
    var phi_7339_: type_73;
    var phi_7340_: bool;
    var phi_7341_: bool;
    var phi_7342_: bool;
    var phi_7343_: bool;
    var phi_7347_: type_73;
    var phi_7348_: bool;
    var phi_7349_: bool;
    var phi_7350_: bool;
    var phi_7354_: bool;
    var phi_7355_: bool;
    var phi_7359_: bool;
    var phi_7360_: bool;
    var phi_7364_: bool;
    var phi_7365_: bool;
    var local_35: f64;
    var phi_7370_: type_73;
    var phi_7371_: bool;
    var phi_7375_: type_73;
    var phi_7382_: bool;
    var phi_7383_: f64;
    var phi_7384_: bool;
    var phi_7385_: bool;
    var phi_7386_: bool;
    var phi_7387_: f64;
    var phi_7388_: bool;
    var phi_7389_: bool;
    var phi_7390_: bool;
    var phi_7391_: f64;
    var phi_7392_: bool;
    var phi_7393_: bool;
    var phi_7394_: bool;
    var phi_7395_: bool;
    var phi_7399_: bool;
    var phi_7400_: bool;
    var phi_7401_: bool;
    var phi_7402_: f64;
    var phi_7403_: type_74;
    var phi_7404_: bool;
    var phi_7405_: bool;
    var phi_7406_: bool;
    var phi_7407_: bool;
    var local_36: bool;
    var phi_7412_: type_73;
    var phi_7413_: bool;
    var phi_7414_: bool;
    var local_37: f64;
    var phi_7419_: type_73;
    var phi_7420_: bool;
    var local_38: type_74;
    var phi_7426_: type_73;
    var phi_7427_: bool;
    var phi_7431_: type_73;
    var phi_1721_: f64;
    var phi_1728_: f64;
    var phi_1733_: f64;
    var phi_1740_: f64;
    var phi_1745_: f64;
    var phi_1758_: f64;
    var phi_1765_: f64;
    var phi_1770_: f64;
    var phi_1777_: f64;
    var phi_1782_: f64;
    var phi_1787_: f64;
    var phi_1804_: f64;
    var phi_1811_: f64;
    var phi_1816_: f64;
    var phi_1823_: f64;
    var phi_1828_: f64;
    var phi_1842_: f64;
    var phi_1849_: f64;
    var phi_1854_: f64;
    var phi_1861_: f64;
    var phi_1866_: f64;
    var phi_1871_: f64;
    var phi_1888_: f64;
    var phi_1895_: f64;
    var phi_1900_: f64;
    var phi_1907_: f64;
    var phi_1912_: f64;
    var phi_1926_: f64;
    var phi_1933_: f64;
    var phi_1938_: f64;
    var phi_1945_: f64;
    var phi_1950_: f64;
    var phi_1955_: f64;
    var phi_1975_: type_29;
    var phi_1978_: f64;
    var phi_1976_: type_29;
    var phi_2001_: type_29;
    var phi_2177_: bool;
    var phi_2178_: bool;
    var phi_2179_: bool;
    var phi_2180_: bool;
    var phi_2184_: bool;
    var phi_2206_: array<f64, 3>;
    var phi_2207_: bool;
    var phi_2208_: array<f64, 3>;
    var phi_2209_: bool;
    var phi_2396_: f64;
    var phi_2398_: f64;
    var phi_2428_: f64;
    var phi_2430_: f64;
    var phi_2460_: f64;
    var phi_2462_: f64;
    var phi_2498_: type_29;
    var phi_2501_: array<f64, 3>;
    var phi_2499_: type_29;
    var phi_2524_: type_29;
    var phi_2591_: array<f64, 3>;
    var phi_2502_: array<f64, 3>;
    var phi_2592_: array<f64, 3>;
    var phi_2599_: f64;
    var phi_2606_: f64;
    var phi_2614_: f64;
    var phi_2659_: type_27;
    var phi_2662_: f64;
    var phi_2683_: bool;
    var phi_2689_: type_28;
    var phi_2660_: type_27;
    var phi_2703_: type_28;
    var phi_2663_: f64;
    var local_39: f64;
    var phi_2652_: f64;
    var phi_2716_: f64;
    var phi_2729_: type_29;
    var phi_2732_: f64;
    var phi_2730_: type_29;
    var phi_2755_: type_29;
    var phi_2806_: f64;
    var phi_2812_: f64;
    var phi_2826_: bool;
    var phi_2827_: bool;
    var phi_2861_: f64;
    var phi_2862_: f64;
    var phi_2863_: f64;
    var phi_2864_: bool;
    var phi_2868_: bool;
    var phi_2869_: f64;
    var phi_2870_: bool;
    var phi_2871_: bool;
    var phi_2872_: bool;
    var phi_2873_: f64;
    var phi_2874_: bool;
    var phi_2875_: bool;
    var phi_2876_: bool;
    var phi_2733_: f64;
    var phi_2877_: bool;
    var phi_2878_: bool;
    var phi_2879_: bool;
    var phi_2880_: bool;
    var local_40: bool;
    var local_41: f64;
    var local_42: f64;
    var local_43: f64;
    var phi_2898_: bool;
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
    var phi_2911_: f64;
    var phi_2912_: f64;
    var phi_2913_: bool;
    var phi_2914_: bool;
    var phi_2915_: bool;
    var phi_2916_: bool;
    var phi_2917_: bool;
    var phi_2918_: bool;
    var phi_2919_: bool;
    var phi_2920_: f64;
    var phi_2921_: f64;
    var phi_2922_: bool;
    var phi_2923_: bool;
    var phi_2924_: bool;
    var phi_2925_: bool;
    var phi_2926_: bool;
    var phi_2927_: bool;
    var phi_2928_: bool;
    var phi_2929_: bool;
    var phi_2930_: f64;
    var phi_1979_: f64;
    var phi_2931_: bool;
    var phi_2932_: bool;
    var phi_2933_: bool;
    var phi_2934_: bool;
    var phi_2935_: bool;
    var phi_2936_: bool;
    var phi_2937_: bool;
    var phi_2938_: bool;
    var phi_2939_: bool;
    var local_44: bool;
    var phi_2944_: type_73;
    var phi_2945_: bool;
    var phi_2946_: bool;
    var phi_2947_: bool;
    var phi_2948_: bool;
    var phi_2949_: bool;
    var phi_2950_: bool;
    var phi_2951_: bool;
    var phi_2955_: f64;
    var phi_2956_: bool;
    var phi_2957_: bool;
    var phi_2958_: bool;
    var phi_2959_: bool;
    var phi_2960_: bool;
    var phi_2961_: bool;
    var phi_2962_: bool;
    var phi_2967_: type_73;
    var phi_2968_: bool;
    var phi_2969_: bool;
    var phi_2970_: bool;
    var phi_2971_: bool;
    var phi_2972_: bool;
    var phi_2973_: bool;
    var local_45: f64;
    var phi_2978_: type_73;
    var phi_2979_: bool;
    var phi_2980_: bool;
    var phi_2981_: bool;
    var phi_2982_: bool;
    var phi_2983_: bool;
    var local_46: f64;
    var phi_2988_: type_73;
    var phi_2989_: bool;
    var phi_2990_: bool;
    var phi_2991_: bool;
    var phi_2992_: bool;
    var local_47: f64;
    var phi_2997_: type_73;
    var phi_2998_: bool;
    var phi_2999_: bool;
    var phi_3000_: bool;
    var phi_3001_: bool;
    var phi_3005_: type_73;
    var phi_3006_: bool;
    var phi_3007_: bool;
    var phi_3008_: bool;
    var phi_3012_: bool;
    var phi_3013_: bool;
    var phi_3017_: bool;
    var phi_3018_: bool;
    var phi_3022_: bool;
    var phi_3023_: bool;
    var local_48: f64;
    var phi_3028_: type_73;
    var phi_3029_: bool;
    var phi_3033_: type_73;
    var phi_3047_: type_29;
    var phi_3048_: type_29;
    var phi_3071_: type_29;
    var phi_3092_: f64;
    var phi_3262_: bool;
    var phi_3263_: bool;
    var phi_3264_: bool;
    var phi_3265_: bool;
    var phi_3269_: bool;
    var phi_3291_: array<f64, 3>;
    var phi_3292_: bool;
    var phi_3293_: array<f64, 3>;
    var phi_3294_: bool;
    var phi_3481_: f64;
    var phi_3483_: f64;
    var phi_3513_: f64;
    var phi_3515_: f64;
    var phi_3545_: f64;
    var phi_3547_: f64;
    var phi_3583_: type_29;
    var phi_3586_: array<f64, 3>;
    var phi_3584_: type_29;
    var phi_3609_: type_29;
    var phi_3676_: array<f64, 3>;
    var phi_3587_: array<f64, 3>;
    var phi_3677_: array<f64, 3>;
    var phi_3709_: type_27;
    var phi_3712_: f64;
    var phi_3733_: bool;
    var phi_3739_: type_28;
    var phi_3710_: type_27;
    var phi_3753_: type_28;
    var phi_3713_: f64;
    var local_49: f64;
    var phi_3702_: f64;
    var phi_3766_: f64;
    var phi_3784_: f64;
    var phi_3791_: f64;
    var phi_3796_: f64;
    var phi_3803_: f64;
    var phi_3808_: f64;
    var phi_3821_: f64;
    var phi_3828_: f64;
    var phi_3833_: f64;
    var phi_3840_: f64;
    var phi_3845_: f64;
    var phi_3850_: f64;
    var phi_3867_: f64;
    var phi_3874_: f64;
    var phi_3879_: f64;
    var phi_3886_: f64;
    var phi_3891_: f64;
    var phi_3905_: f64;
    var phi_3912_: f64;
    var phi_3917_: f64;
    var phi_3924_: f64;
    var phi_3929_: f64;
    var phi_3934_: f64;
    var phi_3951_: f64;
    var phi_3958_: f64;
    var phi_3963_: f64;
    var phi_3970_: f64;
    var phi_3975_: f64;
    var phi_3989_: f64;
    var phi_3996_: f64;
    var phi_4001_: f64;
    var phi_4008_: f64;
    var phi_4013_: f64;
    var phi_4018_: f64;
    var phi_4042_: bool;
    var phi_4043_: bool;
    var phi_4044_: bool;
    var local_50: bool;
    var phi_4049_: type_73;
    var phi_4050_: bool;
    var phi_4055_: type_73;
    var phi_4056_: bool;
    var phi_4058_: type_73;
    var phi_4059_: type_73;
    var phi_4060_: bool;
    var phi_4064_: type_73;
    var phi_7435_: type_73;
    var phi_7436_: type_73;
    var phi_7449_: type_47;
    var phi_7472_: u32;
    var phi_7476_: type_46;
    var phi_7477_: bool;
    var phi_7495_: u32;
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
    phi_281_ = type_29(0u, _e157);
    loop {
        let _e160 = phi_281_;
        if (_e160.member < _e160.member_1) {
            phi_282_ = type_29((_e160.member + 1u), _e160.member_1);
            phi_305_ = type_29(1u, _e160.member);
        } else {
            phi_282_ = _e160;
            phi_305_ = type_29(0u, type_29().member_1);
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
                    let _e257 = paths.member[_e192];
                    let _e259 = paths.member[_e197[0]];
                    let _e265 = paths.member[_e197[1]];
                    let _e267 = paths.member[_e197[2]];
                    local_18 = array<array<f32, 3>, 4>(array<f32, 3>(_e257.member[0], _e257.member[1], _e257.member[2]), array<f32, 3>(_e259.member[0], _e259.member[1], _e259.member[2]), array<f32, 3>(_e265.member[0], _e265.member[1], _e265.member[2]), array<f32, 3>(_e267.member[0], _e267.member[1], _e267.member[2]));
                    local_19 = array<array<f32, 3>, 4>(array<f32, 3>(_e257.member_1[0], _e257.member_1[1], _e257.member_1[2]), array<f32, 3>(_e259.member_1[0], _e259.member_1[1], _e259.member_1[2]), array<f32, 3>(_e265.member_1[0], _e265.member_1[1], _e265.member_1[2]), array<f32, 3>(_e267.member_1[0], _e267.member_1[1], _e267.member_1[2]));
                    phi_517_ = type_29(0u, 4u);
                    loop {
                        let _e307 = phi_517_;
                        if (_e307.member < _e307.member_1) {
                            phi_518_ = type_29((_e307.member + 1u), _e307.member_1);
                            phi_541_ = type_29(1u, _e307.member);
                        } else {
                            phi_518_ = _e307;
                            phi_541_ = type_29(0u, type_29().member_1);
                        }
                        let _e321 = phi_518_;
                        let _e323 = phi_541_;
                        let _e327 = (bitcast<i32>(_e323.member) != 0i);
                        if _e327 {
                            phi_551_ = type_29(0u, 3u);
                            loop {
                                let _e329 = phi_551_;
                                if (_e329.member < _e329.member_1) {
                                    phi_552_ = type_29((_e329.member + 1u), _e329.member_1);
                                    phi_575_ = type_29(1u, _e329.member);
                                } else {
                                    phi_552_ = _e329;
                                    phi_575_ = type_29(0u, type_29().member_1);
                                }
                                let _e343 = phi_552_;
                                let _e345 = phi_575_;
                                let _e349 = (bitcast<i32>(_e345.member) != 0i);
                                if _e349 {
                                    if (_e323.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e345.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e354 = local_18[_e323.member_1][_e345.member_1];
                                    if (_e323.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e345.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    local_16[_e323.member_1][_e345.member_1] = f64(_e354);
                                    if (_e323.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e345.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e364 = local_19[_e323.member_1][_e345.member_1];
                                    if (_e323.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e345.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    local_17[_e323.member_1][_e345.member_1] = f64(_e364);
                                }
                                continue;
                                continuing {
                                    phi_551_ = _e343;
                                    break if !(_e349);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_517_ = _e321;
                            break if !(_e327);
                        }
                    }
                } else {
                    phi_637_ = type_29(0u, 4u);
                    loop {
                        let _e215 = phi_637_;
                        if (_e215.member < _e215.member_1) {
                            phi_638_ = type_29((_e215.member + 1u), _e215.member_1);
                            phi_661_ = type_29(1u, _e215.member);
                        } else {
                            phi_638_ = _e215;
                            phi_661_ = type_29(0u, type_29().member_1);
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
                            if (_e231.member_1 < 4u) {
                            } else {
                                return;
                            }
                            local_16[_e231.member_1] = array<f64, 3>(_e240.member[0], _e240.member[1], _e240.member[2]);
                            if (_e231.member_1 < 4u) {
                            } else {
                                return;
                            }
                            local_17[_e231.member_1] = array<f64, 3>(_e240.member_1[0], _e240.member_1[1], _e240.member_1[2]);
                        }
                        continue;
                        continuing {
                            phi_637_ = _e229;
                            break if !(_e235);
                        }
                    }
                }
                let _e372 = local_16;
                let _e389 = local_17;
                local_20 = type_62(array<array<f64, 3>, 2>(array<f64, 3>((_e372[0][0] - _e372[1][0]), (_e372[0][1] - _e372[1][1]), (_e372[0][2] - _e372[1][2])), array<f64, 3>((_e389[0][0] - _e389[1][0]), (_e389[0][1] - _e389[1][1]), (_e389[0][2] - _e389[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e372[2][0] - _e372[1][0]), (_e372[2][1] - _e372[1][1]), (_e372[2][2] - _e372[1][2])), array<f64, 3>((_e389[2][0] - _e389[1][0]), (_e389[2][1] - _e389[1][1]), (_e389[2][2] - _e389[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e372[3][0] - _e372[1][0]), (_e372[3][1] - _e372[1][1]), (_e372[3][2] - _e372[1][2])), array<f64, 3>((_e389[3][0] - _e389[1][0]), (_e389[3][1] - _e389[1][1]), (_e389[3][2] - _e389[1][2]))), (0.0lf + 0.0lf));
                let _e436 = params.member.member_7;
                let _e443 = bitcast<f64>(((u64(_e436[1]) * 4294967296lu) + u64(_e436[0])));
                let _e444 = f64(0f);
                let _e447 = local_20.member_1[0u];
                let _e453 = local_20.member_2[0u];
                let _e459 = ((_e447[1] * _e453[2]) - (_e447[2] * _e453[1]));
                let _e462 = ((_e447[2] * _e453[0]) - (_e447[0] * _e453[2]));
                let _e465 = ((_e447[0] * _e453[1]) - (_e447[1] * _e453[0]));
                let _e468 = local_20.member_1[1u];
                let _e474 = local_20.member_2[1u];
                let _e480 = ((_e468[1] * _e474[2]) - (_e468[2] * _e474[1]));
                let _e483 = ((_e468[2] * _e474[0]) - (_e468[0] * _e474[2]));
                let _e486 = ((_e468[0] * _e474[1]) - (_e468[1] * _e474[0]));
                let _e489 = local_20.member_1[0u];
                let _e495 = local_20.member_2[1u];
                let _e510 = local_20.member_1[1u];
                let _e516 = local_20.member_2[0u];
                let _e529 = (((_e489[1] * _e495[2]) - (_e489[2] * _e495[1])) + ((_e510[1] * _e516[2]) - (_e510[2] * _e516[1])));
                let _e530 = (((_e489[2] * _e495[0]) - (_e489[0] * _e495[2])) + ((_e510[2] * _e516[0]) - (_e510[0] * _e516[2])));
                let _e531 = (((_e489[0] * _e495[1]) - (_e489[1] * _e495[0])) + ((_e510[0] * _e516[1]) - (_e510[1] * _e516[0])));
                let _e534 = local_20.member[0u];
                let _e542 = (((_e534[0] * _e459) + (_e534[1] * _e462)) + (_e534[2] * _e465));
                let _e545 = local_20.member[1u];
                let _e556 = local_20.member[0u];
                let _e565 = ((((_e545[0] * _e459) + (_e545[1] * _e462)) + (_e545[2] * _e465)) + (((_e556[0] * _e529) + (_e556[1] * _e530)) + (_e556[2] * _e531)));
                let _e568 = local_20.member[0u];
                let _e579 = local_20.member[1u];
                let _e588 = ((((_e568[0] * _e480) + (_e568[1] * _e483)) + (_e568[2] * _e486)) + (((_e579[0] * _e529) + (_e579[1] * _e530)) + (_e579[2] * _e531)));
                let _e591 = local_20.member[1u];
                let _e599 = (((_e591[0] * _e480) + (_e591[1] * _e483)) + (_e591[2] * _e486));
                let _e602 = local_20.member[0u];
                if (_e602[0] < 0.0lf) {
                    phi_1118_ = -(_e602[0]);
                } else {
                    phi_1118_ = _e602[0];
                }
                let _e609 = phi_1118_;
                if (_e602[1] < 0.0lf) {
                    phi_1125_ = -(_e602[1]);
                } else {
                    phi_1125_ = _e602[1];
                }
                let _e613 = phi_1125_;
                if (_e609 > _e613) {
                    phi_1130_ = _e609;
                } else {
                    phi_1130_ = _e613;
                }
                let _e616 = phi_1130_;
                if (_e602[2] < 0.0lf) {
                    phi_1137_ = -(_e602[2]);
                } else {
                    phi_1137_ = _e602[2];
                }
                let _e620 = phi_1137_;
                if (_e616 > _e620) {
                    phi_1142_ = _e616;
                } else {
                    phi_1142_ = _e620;
                }
                let _e623 = phi_1142_;
                let _e626 = local_20.member[1u];
                if (_e626[0] < 0.0lf) {
                    phi_1155_ = -(_e626[0]);
                } else {
                    phi_1155_ = _e626[0];
                }
                let _e633 = phi_1155_;
                if (_e626[1] < 0.0lf) {
                    phi_1162_ = -(_e626[1]);
                } else {
                    phi_1162_ = _e626[1];
                }
                let _e637 = phi_1162_;
                if (_e633 > _e637) {
                    phi_1167_ = _e633;
                } else {
                    phi_1167_ = _e637;
                }
                let _e640 = phi_1167_;
                if (_e626[2] < 0.0lf) {
                    phi_1174_ = -(_e626[2]);
                } else {
                    phi_1174_ = _e626[2];
                }
                let _e644 = phi_1174_;
                if (_e640 > _e644) {
                    phi_1179_ = _e640;
                } else {
                    phi_1179_ = _e644;
                }
                let _e647 = phi_1179_;
                if (_e623 > _e647) {
                    phi_1184_ = _e623;
                } else {
                    phi_1184_ = _e647;
                }
                let _e650 = phi_1184_;
                let _e652 = local_20.member_3;
                let _e653 = (_e650 + _e652);
                let _e656 = local_20.member_1[0u];
                if (_e656[0] < 0.0lf) {
                    phi_1201_ = -(_e656[0]);
                } else {
                    phi_1201_ = _e656[0];
                }
                let _e663 = phi_1201_;
                if (_e656[1] < 0.0lf) {
                    phi_1208_ = -(_e656[1]);
                } else {
                    phi_1208_ = _e656[1];
                }
                let _e667 = phi_1208_;
                if (_e663 > _e667) {
                    phi_1213_ = _e663;
                } else {
                    phi_1213_ = _e667;
                }
                let _e670 = phi_1213_;
                if (_e656[2] < 0.0lf) {
                    phi_1220_ = -(_e656[2]);
                } else {
                    phi_1220_ = _e656[2];
                }
                let _e674 = phi_1220_;
                if (_e670 > _e674) {
                    phi_1225_ = _e670;
                } else {
                    phi_1225_ = _e674;
                }
                let _e677 = phi_1225_;
                let _e680 = local_20.member_1[1u];
                if (_e680[0] < 0.0lf) {
                    phi_1239_ = -(_e680[0]);
                } else {
                    phi_1239_ = _e680[0];
                }
                let _e687 = phi_1239_;
                if (_e680[1] < 0.0lf) {
                    phi_1246_ = -(_e680[1]);
                } else {
                    phi_1246_ = _e680[1];
                }
                let _e691 = phi_1246_;
                if (_e687 > _e691) {
                    phi_1251_ = _e687;
                } else {
                    phi_1251_ = _e691;
                }
                let _e694 = phi_1251_;
                if (_e680[2] < 0.0lf) {
                    phi_1258_ = -(_e680[2]);
                } else {
                    phi_1258_ = _e680[2];
                }
                let _e698 = phi_1258_;
                if (_e694 > _e698) {
                    phi_1263_ = _e694;
                } else {
                    phi_1263_ = _e698;
                }
                let _e701 = phi_1263_;
                if (_e677 > _e701) {
                    phi_1268_ = _e677;
                } else {
                    phi_1268_ = _e701;
                }
                let _e704 = phi_1268_;
                let _e706 = local_20.member_3;
                let _e707 = (_e704 + _e706);
                let _e710 = local_20.member_2[0u];
                if (_e710[0] < 0.0lf) {
                    phi_1285_ = -(_e710[0]);
                } else {
                    phi_1285_ = _e710[0];
                }
                let _e717 = phi_1285_;
                if (_e710[1] < 0.0lf) {
                    phi_1292_ = -(_e710[1]);
                } else {
                    phi_1292_ = _e710[1];
                }
                let _e721 = phi_1292_;
                if (_e717 > _e721) {
                    phi_1297_ = _e717;
                } else {
                    phi_1297_ = _e721;
                }
                let _e724 = phi_1297_;
                if (_e710[2] < 0.0lf) {
                    phi_1304_ = -(_e710[2]);
                } else {
                    phi_1304_ = _e710[2];
                }
                let _e728 = phi_1304_;
                if (_e724 > _e728) {
                    phi_1309_ = _e724;
                } else {
                    phi_1309_ = _e728;
                }
                let _e731 = phi_1309_;
                let _e734 = local_20.member_2[1u];
                if (_e734[0] < 0.0lf) {
                    phi_1323_ = -(_e734[0]);
                } else {
                    phi_1323_ = _e734[0];
                }
                let _e741 = phi_1323_;
                if (_e734[1] < 0.0lf) {
                    phi_1330_ = -(_e734[1]);
                } else {
                    phi_1330_ = _e734[1];
                }
                let _e745 = phi_1330_;
                if (_e741 > _e745) {
                    phi_1335_ = _e741;
                } else {
                    phi_1335_ = _e745;
                }
                let _e748 = phi_1335_;
                if (_e734[2] < 0.0lf) {
                    phi_1342_ = -(_e734[2]);
                } else {
                    phi_1342_ = _e734[2];
                }
                let _e752 = phi_1342_;
                if (_e748 > _e752) {
                    phi_1347_ = _e748;
                } else {
                    phi_1347_ = _e752;
                }
                let _e755 = phi_1347_;
                if (_e731 > _e755) {
                    phi_1352_ = _e731;
                } else {
                    phi_1352_ = _e755;
                }
                let _e758 = phi_1352_;
                let _e760 = local_20.member_3;
                let _e761 = (_e758 + _e760);
                let _e762 = f64(1f);
                let _e763 = f64(8f);
                let _e765 = ((_e707 * _e763) * _e761);
                let _e773 = local_20.member_3;
                if (_e459 < 0.0lf) {
                    phi_1389_ = -(_e459);
                } else {
                    phi_1389_ = _e459;
                }
                let _e793 = phi_1389_;
                if (_e462 < 0.0lf) {
                    phi_1395_ = -(_e462);
                } else {
                    phi_1395_ = _e462;
                }
                let _e797 = phi_1395_;
                if (_e465 < 0.0lf) {
                    phi_1402_ = -(_e465);
                } else {
                    phi_1402_ = _e465;
                }
                let _e802 = phi_1402_;
                let _e803 = ((_e793 + _e797) + _e802);
                if (_e480 < 0.0lf) {
                    phi_1409_ = -(_e480);
                } else {
                    phi_1409_ = _e480;
                }
                let _e807 = phi_1409_;
                if (_e483 < 0.0lf) {
                    phi_1415_ = -(_e483);
                } else {
                    phi_1415_ = _e483;
                }
                let _e811 = phi_1415_;
                if (_e486 < 0.0lf) {
                    phi_1422_ = -(_e486);
                } else {
                    phi_1422_ = _e486;
                }
                let _e816 = phi_1422_;
                let _e817 = ((_e807 + _e811) + _e816);
                if (_e803 > _e817) {
                    phi_1428_ = _e803;
                } else {
                    phi_1428_ = _e817;
                }
                let _e820 = phi_1428_;
                if (_e529 < 0.0lf) {
                    phi_1434_ = -(_e529);
                } else {
                    phi_1434_ = _e529;
                }
                let _e824 = phi_1434_;
                if (_e530 < 0.0lf) {
                    phi_1440_ = -(_e530);
                } else {
                    phi_1440_ = _e530;
                }
                let _e828 = phi_1440_;
                if (_e531 < 0.0lf) {
                    phi_1447_ = -(_e531);
                } else {
                    phi_1447_ = _e531;
                }
                let _e833 = phi_1447_;
                let _e835 = (((_e824 + _e828) + _e833) * f64(0.5f));
                if (_e820 > _e835) {
                    phi_1454_ = _e820;
                } else {
                    phi_1454_ = _e835;
                }
                let _e838 = phi_1454_;
                let _e844 = local_20.member_3;
                let _e858 = (((((_e653 * _e763) * _e765) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e773 * f64(19f)) * ((_e653 * (_e707 + _e761)) + (_e707 * _e761)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e762 + _e653) * ((_e762 + _e707) * (_e762 + _e761)))));
                let _e859 = f64(3f);
                let _e860 = (_e542 * _e859);
                let _e861 = (_e599 * _e859);
                if (_e860 < _e861) {
                    phi_1482_ = _e860;
                } else {
                    phi_1482_ = _e861;
                }
                let _e864 = phi_1482_;
                if (_e565 < _e588) {
                    phi_1487_ = _e565;
                } else {
                    phi_1487_ = _e588;
                }
                let _e867 = phi_1487_;
                if (_e864 < _e867) {
                    phi_1492_ = _e864;
                } else {
                    phi_1492_ = _e867;
                }
                let _e870 = phi_1492_;
                if (_e860 > _e861) {
                    phi_1497_ = _e860;
                } else {
                    phi_1497_ = _e861;
                }
                let _e873 = phi_1497_;
                if (_e565 > _e588) {
                    phi_1502_ = _e565;
                } else {
                    phi_1502_ = _e588;
                }
                let _e876 = phi_1502_;
                if (_e873 > _e876) {
                    phi_1507_ = _e873;
                } else {
                    phi_1507_ = _e876;
                }
                let _e879 = phi_1507_;
                let _e885 = -(_e879);
                if (_e870 > _e885) {
                    phi_1518_ = _e870;
                } else {
                    phi_1518_ = _e885;
                }
                let _e888 = phi_1518_;
                if ((_e888 - (_e858 + ((_e443 * (((_e838 + (_e765 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e844 * f64(6f)) * (_e707 + _e761))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e762 + _e707) * (_e762 + _e761))))) * f64((3f * 1.0001f))))) > _e444) {
                    phi_7436_ = type_73(0u, type_73().member_1);
                } else {
                    if (_e443 > _e444) {
                        let _e3265 = f64(1f);
                        let _e3269 = local_20.member[0u];
                        let _e3275 = local_20.member_1[0u];
                        let _e3281 = local_20.member_2[0u];
                        local_12 = array<array<f64, 3>, 4>(_e3269, array<f64, 3>((_e3269[0] - _e3275[0]), (_e3269[1] - _e3275[1]), (_e3269[2] - _e3275[2])), array<f64, 3>((_e3269[0] - _e3281[0]), (_e3269[1] - _e3281[1]), (_e3269[2] - _e3281[2])), _e3269);
                        let _e3296 = local_20.member[1u];
                        let _e3302 = local_20.member_1[1u];
                        let _e3308 = local_20.member_2[1u];
                        local_13 = array<array<f64, 3>, 4>(_e3296, array<f64, 3>((_e3296[0] - _e3302[0]), (_e3296[1] - _e3302[1]), (_e3296[2] - _e3302[2])), array<f64, 3>((_e3296[0] - _e3308[0]), (_e3296[1] - _e3308[1]), (_e3296[2] - _e3308[2])), _e3296);
                        let _e3323 = local_20.member[0u];
                        if (_e3323[0] < 0.0lf) {
                            phi_1721_ = -(_e3323[0]);
                        } else {
                            phi_1721_ = _e3323[0];
                        }
                        let _e3330 = phi_1721_;
                        if (_e3323[1] < 0.0lf) {
                            phi_1728_ = -(_e3323[1]);
                        } else {
                            phi_1728_ = _e3323[1];
                        }
                        let _e3334 = phi_1728_;
                        if (_e3330 > _e3334) {
                            phi_1733_ = _e3330;
                        } else {
                            phi_1733_ = _e3334;
                        }
                        let _e3337 = phi_1733_;
                        if (_e3323[2] < 0.0lf) {
                            phi_1740_ = -(_e3323[2]);
                        } else {
                            phi_1740_ = _e3323[2];
                        }
                        let _e3341 = phi_1740_;
                        if (_e3337 > _e3341) {
                            phi_1745_ = _e3337;
                        } else {
                            phi_1745_ = _e3341;
                        }
                        let _e3344 = phi_1745_;
                        let _e3347 = local_20.member[1u];
                        if (_e3347[0] < 0.0lf) {
                            phi_1758_ = -(_e3347[0]);
                        } else {
                            phi_1758_ = _e3347[0];
                        }
                        let _e3354 = phi_1758_;
                        if (_e3347[1] < 0.0lf) {
                            phi_1765_ = -(_e3347[1]);
                        } else {
                            phi_1765_ = _e3347[1];
                        }
                        let _e3358 = phi_1765_;
                        if (_e3354 > _e3358) {
                            phi_1770_ = _e3354;
                        } else {
                            phi_1770_ = _e3358;
                        }
                        let _e3361 = phi_1770_;
                        if (_e3347[2] < 0.0lf) {
                            phi_1777_ = -(_e3347[2]);
                        } else {
                            phi_1777_ = _e3347[2];
                        }
                        let _e3365 = phi_1777_;
                        if (_e3361 > _e3365) {
                            phi_1782_ = _e3361;
                        } else {
                            phi_1782_ = _e3365;
                        }
                        let _e3368 = phi_1782_;
                        if (_e3344 > _e3368) {
                            phi_1787_ = _e3344;
                        } else {
                            phi_1787_ = _e3368;
                        }
                        let _e3371 = phi_1787_;
                        let _e3373 = local_20.member_3;
                        let _e3377 = local_20.member_1[0u];
                        if (_e3377[0] < 0.0lf) {
                            phi_1804_ = -(_e3377[0]);
                        } else {
                            phi_1804_ = _e3377[0];
                        }
                        let _e3384 = phi_1804_;
                        if (_e3377[1] < 0.0lf) {
                            phi_1811_ = -(_e3377[1]);
                        } else {
                            phi_1811_ = _e3377[1];
                        }
                        let _e3388 = phi_1811_;
                        if (_e3384 > _e3388) {
                            phi_1816_ = _e3384;
                        } else {
                            phi_1816_ = _e3388;
                        }
                        let _e3391 = phi_1816_;
                        if (_e3377[2] < 0.0lf) {
                            phi_1823_ = -(_e3377[2]);
                        } else {
                            phi_1823_ = _e3377[2];
                        }
                        let _e3395 = phi_1823_;
                        if (_e3391 > _e3395) {
                            phi_1828_ = _e3391;
                        } else {
                            phi_1828_ = _e3395;
                        }
                        let _e3398 = phi_1828_;
                        let _e3401 = local_20.member_1[1u];
                        if (_e3401[0] < 0.0lf) {
                            phi_1842_ = -(_e3401[0]);
                        } else {
                            phi_1842_ = _e3401[0];
                        }
                        let _e3408 = phi_1842_;
                        if (_e3401[1] < 0.0lf) {
                            phi_1849_ = -(_e3401[1]);
                        } else {
                            phi_1849_ = _e3401[1];
                        }
                        let _e3412 = phi_1849_;
                        if (_e3408 > _e3412) {
                            phi_1854_ = _e3408;
                        } else {
                            phi_1854_ = _e3412;
                        }
                        let _e3415 = phi_1854_;
                        if (_e3401[2] < 0.0lf) {
                            phi_1861_ = -(_e3401[2]);
                        } else {
                            phi_1861_ = _e3401[2];
                        }
                        let _e3419 = phi_1861_;
                        if (_e3415 > _e3419) {
                            phi_1866_ = _e3415;
                        } else {
                            phi_1866_ = _e3419;
                        }
                        let _e3422 = phi_1866_;
                        if (_e3398 > _e3422) {
                            phi_1871_ = _e3398;
                        } else {
                            phi_1871_ = _e3422;
                        }
                        let _e3425 = phi_1871_;
                        let _e3427 = local_20.member_3;
                        let _e3431 = local_20.member_2[0u];
                        if (_e3431[0] < 0.0lf) {
                            phi_1888_ = -(_e3431[0]);
                        } else {
                            phi_1888_ = _e3431[0];
                        }
                        let _e3438 = phi_1888_;
                        if (_e3431[1] < 0.0lf) {
                            phi_1895_ = -(_e3431[1]);
                        } else {
                            phi_1895_ = _e3431[1];
                        }
                        let _e3442 = phi_1895_;
                        if (_e3438 > _e3442) {
                            phi_1900_ = _e3438;
                        } else {
                            phi_1900_ = _e3442;
                        }
                        let _e3445 = phi_1900_;
                        if (_e3431[2] < 0.0lf) {
                            phi_1907_ = -(_e3431[2]);
                        } else {
                            phi_1907_ = _e3431[2];
                        }
                        let _e3449 = phi_1907_;
                        if (_e3445 > _e3449) {
                            phi_1912_ = _e3445;
                        } else {
                            phi_1912_ = _e3449;
                        }
                        let _e3452 = phi_1912_;
                        let _e3455 = local_20.member_2[1u];
                        if (_e3455[0] < 0.0lf) {
                            phi_1926_ = -(_e3455[0]);
                        } else {
                            phi_1926_ = _e3455[0];
                        }
                        let _e3462 = phi_1926_;
                        if (_e3455[1] < 0.0lf) {
                            phi_1933_ = -(_e3455[1]);
                        } else {
                            phi_1933_ = _e3455[1];
                        }
                        let _e3466 = phi_1933_;
                        if (_e3462 > _e3466) {
                            phi_1938_ = _e3462;
                        } else {
                            phi_1938_ = _e3466;
                        }
                        let _e3469 = phi_1938_;
                        if (_e3455[2] < 0.0lf) {
                            phi_1945_ = -(_e3455[2]);
                        } else {
                            phi_1945_ = _e3455[2];
                        }
                        let _e3473 = phi_1945_;
                        if (_e3469 > _e3473) {
                            phi_1950_ = _e3469;
                        } else {
                            phi_1950_ = _e3473;
                        }
                        let _e3476 = phi_1950_;
                        if (_e3452 > _e3476) {
                            phi_1955_ = _e3452;
                        } else {
                            phi_1955_ = _e3476;
                        }
                        let _e3479 = phi_1955_;
                        let _e3481 = local_20.member_3;
                        let _e3489 = local_20.member_3;
                        phi_1975_ = type_29(0u, 48u);
                        phi_1978_ = f64(0f);
                        loop {
                            let _e3498 = phi_1975_;
                            let _e3500 = phi_1978_;
                            local_87 = _e3500;
                            local_45 = _e3500;
                            local_46 = _e3500;
                            local_47 = _e3500;
                            local_48 = _e3500;
                            if (_e3498.member < _e3498.member_1) {
                                phi_1976_ = type_29((_e3498.member + 1u), _e3498.member_1);
                                phi_2001_ = type_29(1u, _e3498.member);
                            } else {
                                phi_1976_ = _e3498;
                                phi_2001_ = type_29(0u, type_29().member_1);
                            }
                            let _e3514 = phi_1976_;
                            let _e3516 = phi_2001_;
                            if (bitcast<i32>(_e3516.member) != 0i) {
                                let _e3522 = local_20.member[0u];
                                let _e3528 = local_20.member[1u];
                                let _e3538 = (_e3522[0] + ((_e3528[0] - _e3522[0]) * _e3500));
                                let _e3539 = (_e3522[1] + ((_e3528[1] - _e3522[1]) * _e3500));
                                let _e3540 = (_e3522[2] + ((_e3528[2] - _e3522[2]) * _e3500));
                                let _e3543 = local_20.member_1[0u];
                                let _e3549 = local_20.member_1[1u];
                                let _e3559 = (_e3543[0] + ((_e3549[0] - _e3543[0]) * _e3500));
                                let _e3560 = (_e3543[1] + ((_e3549[1] - _e3543[1]) * _e3500));
                                let _e3561 = (_e3543[2] + ((_e3549[2] - _e3543[2]) * _e3500));
                                let _e3564 = local_20.member_2[0u];
                                let _e3570 = local_20.member_2[1u];
                                let _e3580 = (_e3564[0] + ((_e3570[0] - _e3564[0]) * _e3500));
                                let _e3581 = (_e3564[1] + ((_e3570[1] - _e3564[1]) * _e3500));
                                let _e3582 = (_e3564[2] + ((_e3570[2] - _e3564[2]) * _e3500));
                                let _e3587 = (((_e3559 * _e3559) + (_e3560 * _e3560)) + (_e3561 * _e3561));
                                let _e3592 = (((_e3559 * _e3580) + (_e3560 * _e3581)) + (_e3561 * _e3582));
                                let _e3597 = (((_e3580 * _e3580) + (_e3581 * _e3581)) + (_e3582 * _e3582));
                                let _e3602 = (((_e3538 * _e3559) + (_e3539 * _e3560)) + (_e3540 * _e3561));
                                let _e3607 = (((_e3538 * _e3580) + (_e3539 * _e3581)) + (_e3540 * _e3582));
                                let _e3610 = ((_e3587 * _e3597) - (_e3592 * _e3592));
                                let _e3611 = f64(0f);
                                let _e3616 = (((_e3602 * _e3597) - (_e3607 * _e3592)) / _e3610);
                                let _e3620 = (((_e3607 * _e3587) - (_e3602 * _e3592)) / _e3610);
                                if (_e3616 >= _e3611) {
                                    if (_e3620 >= _e3611) {
                                        phi_2177_ = ((_e3616 + _e3620) <= f64(1f));
                                        phi_2178_ = false;
                                    } else {
                                        phi_2177_ = bool();
                                        phi_2178_ = true;
                                    }
                                    let _e3626 = phi_2177_;
                                    let _e3628 = phi_2178_;
                                    phi_2179_ = _e3626;
                                    phi_2180_ = _e3628;
                                } else {
                                    phi_2179_ = bool();
                                    phi_2180_ = true;
                                }
                                let _e3630 = phi_2179_;
                                let _e3632 = phi_2180_;
                                if _e3632 {
                                    phi_2184_ = false;
                                } else {
                                    phi_2184_ = _e3630;
                                }
                                let _e3634 = phi_2184_;
                                if (_e3610 > _e3611) {
                                    if _e3634 {
                                        phi_2206_ = array<f64, 3>((_e3538 - ((_e3559 * _e3616) + (_e3580 * _e3620))), (_e3539 - ((_e3560 * _e3616) + (_e3581 * _e3620))), (_e3540 - ((_e3561 * _e3616) + (_e3582 * _e3620))));
                                        phi_2207_ = false;
                                    } else {
                                        phi_2206_ = array<f64, 3>();
                                        phi_2207_ = true;
                                    }
                                    let _e3650 = phi_2206_;
                                    let _e3652 = phi_2207_;
                                    phi_2208_ = _e3650;
                                    phi_2209_ = _e3652;
                                } else {
                                    phi_2208_ = array<f64, 3>();
                                    phi_2209_ = true;
                                }
                                let _e3654 = phi_2208_;
                                let _e3656 = phi_2209_;
                                if _e3656 {
                                    let _e3657 = (_e3538 - _e3559);
                                    let _e3658 = (_e3539 - _e3560);
                                    let _e3659 = (_e3540 - _e3561);
                                    let _e3660 = (_e3580 - _e3559);
                                    let _e3661 = (_e3581 - _e3560);
                                    let _e3662 = (_e3582 - _e3561);
                                    let _e3673 = ((((_e3657 * _e3660) + (_e3658 * _e3661)) + (_e3659 * _e3662)) / (((_e3660 * _e3660) + (_e3661 * _e3661)) + (_e3662 * _e3662)));
                                    if (_e3673 > f64(0f)) {
                                        if (_e3673 < f64(1f)) {
                                            phi_2396_ = _e3673;
                                        } else {
                                            phi_2396_ = f64(1f);
                                        }
                                        let _e3681 = phi_2396_;
                                        phi_2398_ = _e3681;
                                    } else {
                                        phi_2398_ = f64(0f);
                                    }
                                    let _e3683 = phi_2398_;
                                    let _e3687 = (_e3657 - (_e3660 * _e3683));
                                    let _e3688 = (_e3658 - (_e3661 * _e3683));
                                    let _e3689 = (_e3659 - (_e3662 * _e3683));
                                    let _e3700 = ((((_e3538 * _e3559) + (_e3539 * _e3560)) + (_e3540 * _e3561)) / (((_e3559 * _e3559) + (_e3560 * _e3560)) + (_e3561 * _e3561)));
                                    if (_e3700 > f64(0f)) {
                                        if (_e3700 < f64(1f)) {
                                            phi_2428_ = _e3700;
                                        } else {
                                            phi_2428_ = f64(1f);
                                        }
                                        let _e3708 = phi_2428_;
                                        phi_2430_ = _e3708;
                                    } else {
                                        phi_2430_ = f64(0f);
                                    }
                                    let _e3710 = phi_2430_;
                                    let _e3727 = ((((_e3538 * _e3580) + (_e3539 * _e3581)) + (_e3540 * _e3582)) / (((_e3580 * _e3580) + (_e3581 * _e3581)) + (_e3582 * _e3582)));
                                    if (_e3727 > f64(0f)) {
                                        if (_e3727 < f64(1f)) {
                                            phi_2460_ = _e3727;
                                        } else {
                                            phi_2460_ = f64(1f);
                                        }
                                        let _e3735 = phi_2460_;
                                        phi_2462_ = _e3735;
                                    } else {
                                        phi_2462_ = f64(0f);
                                    }
                                    let _e3737 = phi_2462_;
                                    local_11[0u] = array<f64, 3>((_e3538 - (_e3559 * _e3710)), (_e3539 - (_e3560 * _e3710)), (_e3540 - (_e3561 * _e3710)));
                                    local_11[1u] = array<f64, 3>((_e3538 - (_e3580 * _e3737)), (_e3539 - (_e3581 * _e3737)), (_e3540 - (_e3582 * _e3737)));
                                    local_11[2u] = array<f64, 3>(_e3687, _e3688, _e3689);
                                    local_11[3u] = array<f64, 3>(_e3687, _e3688, _e3689);
                                    let _e3753 = local_11[0u];
                                    phi_2498_ = type_29(1u, 4u);
                                    phi_2501_ = array<f64, 3>(_e3753[0], _e3753[1], _e3753[2]);
                                    loop {
                                        let _e3759 = phi_2498_;
                                        let _e3761 = phi_2501_;
                                        local_74 = _e3761;
                                        if (_e3759.member < _e3759.member_1) {
                                            phi_2499_ = type_29((_e3759.member + 1u), _e3759.member_1);
                                            phi_2524_ = type_29(1u, _e3759.member);
                                        } else {
                                            phi_2499_ = _e3759;
                                            phi_2524_ = type_29(0u, type_29().member_1);
                                        }
                                        let _e3775 = phi_2499_;
                                        let _e3777 = phi_2524_;
                                        let _e3781 = (bitcast<i32>(_e3777.member) != 0i);
                                        if _e3781 {
                                            if (_e3777.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3784 = local_11[_e3777.member_1];
                                            if (_e3777.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3790 = local_11[_e3777.member_1];
                                            if ((((_e3784[0] * _e3790[0]) + (_e3784[1] * _e3790[1])) + (_e3784[2] * _e3790[2])) < (((_e3761[0] * _e3761[0]) + (_e3761[1] * _e3761[1])) + (_e3761[2] * _e3761[2]))) {
                                                if (_e3777.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3813 = local_11[_e3777.member_1];
                                                phi_2591_ = array<f64, 3>(_e3813[0], _e3813[1], _e3813[2]);
                                            } else {
                                                phi_2591_ = _e3761;
                                            }
                                            let _e3819 = phi_2591_;
                                            phi_2502_ = _e3819;
                                        } else {
                                            phi_2502_ = array<f64, 3>();
                                        }
                                        let _e3821 = phi_2502_;
                                        continue;
                                        continuing {
                                            phi_2498_ = _e3775;
                                            phi_2501_ = _e3821;
                                            break if !(_e3781);
                                        }
                                    }
                                    let _e5596 = local_74;
                                    phi_2592_ = _e5596;
                                } else {
                                    phi_2592_ = _e3654;
                                }
                                let _e3824 = phi_2592_;
                                if (_e3824[0] < 0.0lf) {
                                    phi_2599_ = -(_e3824[0]);
                                } else {
                                    phi_2599_ = _e3824[0];
                                }
                                let _e3829 = phi_2599_;
                                if (_e3824[1] < 0.0lf) {
                                    phi_2606_ = -(_e3824[1]);
                                } else {
                                    phi_2606_ = _e3824[1];
                                }
                                let _e3834 = phi_2606_;
                                if (_e3824[2] < 0.0lf) {
                                    phi_2614_ = -(_e3824[2]);
                                } else {
                                    phi_2614_ = _e3824[2];
                                }
                                let _e3840 = phi_2614_;
                                let _e3841 = ((_e3829 + _e3834) + _e3840);
                                if (_e3841 > f64(0f)) {
                                    if ((bitcast<u64>(_e3841) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e3847 = (f64(1f) / _e3841);
                                        let _e3849 = (_e3824[0] * _e3847);
                                        let _e3851 = (_e3824[1] * _e3847);
                                        let _e3853 = (_e3824[2] * _e3847);
                                        let _e3858 = (((_e3849 * _e3849) + (_e3851 * _e3851)) + (_e3853 * _e3853));
                                        if (_e3858 <= 2.2250738585072014e-308lf) {
                                            if (_e3858 > 0.0lf) {
                                                phi_2652_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2652_ = 0.0lf;
                                            }
                                            let _e3916 = phi_2652_;
                                            phi_2716_ = _e3916;
                                        } else {
                                            phi_2659_ = type_27(0i, 5i);
                                            phi_2662_ = bitcast<f64>(((bitcast<u64>(_e3858) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e3865 = phi_2659_;
                                                let _e3867 = phi_2662_;
                                                local_39 = _e3867;
                                                if (_e3865.member < _e3865.member_1) {
                                                    let _e3875 = (_e3865.member + 1i);
                                                    if ((false == (_e3875 > _e3865.member)) != false) {
                                                        phi_2683_ = true;
                                                    } else {
                                                        phi_2683_ = false;
                                                    }
                                                    let _e3880 = phi_2683_;
                                                    if _e3880 {
                                                        phi_2689_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_2689_ = type_28(1u, _e3875);
                                                    }
                                                    let _e3886 = phi_2689_;
                                                    if (bitcast<i32>(_e3886.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2660_ = type_27(_e3886.member_1, _e3865.member_1);
                                                    phi_2703_ = type_28(1u, _e3865.member);
                                                } else {
                                                    phi_2660_ = _e3865;
                                                    phi_2703_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e3896 = phi_2660_;
                                                let _e3898 = phi_2703_;
                                                let _e3901 = (bitcast<i32>(_e3898.member) != 0i);
                                                if _e3901 {
                                                    phi_2663_ = (0.5lf * (_e3867 + (_e3858 / _e3867)));
                                                } else {
                                                    phi_2663_ = f64();
                                                }
                                                let _e3906 = phi_2663_;
                                                continue;
                                                continuing {
                                                    phi_2659_ = _e3896;
                                                    phi_2662_ = _e3906;
                                                    break if !(_e3901);
                                                }
                                            }
                                            let _e3911 = local_39;
                                            phi_2716_ = (_e3911 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e3918 = phi_2716_;
                                        phi_2729_ = type_29(0u, 4u);
                                        phi_2732_ = f64(2f);
                                        loop {
                                            let _e3930 = phi_2729_;
                                            let _e3932 = phi_2732_;
                                            local_41 = _e3932;
                                            local_42 = _e3932;
                                            local_43 = _e3932;
                                            local_77 = _e3932;
                                            local_78 = _e3932;
                                            if (_e3930.member < _e3930.member_1) {
                                                phi_2730_ = type_29((_e3930.member + 1u), _e3930.member_1);
                                                phi_2755_ = type_29(1u, _e3930.member);
                                            } else {
                                                phi_2730_ = _e3930;
                                                phi_2755_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e3946 = phi_2730_;
                                            let _e3948 = phi_2755_;
                                            if (bitcast<i32>(_e3948.member) != 0i) {
                                                if (_e3948.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3955 = local_12[_e3948.member_1];
                                                let _e3963 = (((_e3849 * _e3955[0]) + (_e3851 * _e3955[1])) + (_e3853 * _e3955[2]));
                                                if (_e3948.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3966 = local_13[_e3948.member_1];
                                                let _e3974 = (((_e3849 * _e3966[0]) + (_e3851 * _e3966[1])) + (_e3853 * _e3966[2]));
                                                if (_e3963 < 0.0lf) {
                                                    phi_2806_ = -(_e3963);
                                                } else {
                                                    phi_2806_ = _e3963;
                                                }
                                                let _e3978 = phi_2806_;
                                                if (_e3974 < 0.0lf) {
                                                    phi_2812_ = -(_e3974);
                                                } else {
                                                    phi_2812_ = _e3974;
                                                }
                                                let _e3982 = phi_2812_;
                                                let _e3987 = (((((((((_e3371 + _e3373) + (_e3425 + _e3427)) + (_e3479 + _e3481)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3489 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e443 * _e3918) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e3978 + _e3982) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e3963 > _e3987) {
                                                    if (_e3974 > _e3987) {
                                                        phi_2826_ = false;
                                                    } else {
                                                        phi_2826_ = true;
                                                    }
                                                    let _e3991 = phi_2826_;
                                                    phi_2827_ = _e3991;
                                                } else {
                                                    phi_2827_ = true;
                                                }
                                                let _e3993 = phi_2827_;
                                                if _e3993 {
                                                    if ((_e3963 + ((_e3974 - _e3963) * _e3500)) > _e3987) {
                                                        if (_e3974 < _e3963) {
                                                            let _e4002 = ((_e3963 - _e3974) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                            if _e4002 {
                                                                let _e4010 = (((_e3963 - _e3987) / (_e3963 - _e3974)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                if (_e3932 < _e4010) {
                                                                    phi_2861_ = _e3932;
                                                                } else {
                                                                    phi_2861_ = _e4010;
                                                                }
                                                                let _e4013 = phi_2861_;
                                                                phi_2862_ = _e4013;
                                                            } else {
                                                                phi_2862_ = f64();
                                                            }
                                                            let _e4015 = phi_2862_;
                                                            phi_2863_ = _e4015;
                                                            phi_2864_ = _e4002;
                                                        } else {
                                                            phi_2863_ = _e3932;
                                                            phi_2864_ = true;
                                                        }
                                                        let _e4017 = phi_2863_;
                                                        let _e4019 = phi_2864_;
                                                        if _e4019 {
                                                            phi_2868_ = false;
                                                        } else {
                                                            phi_2868_ = true;
                                                        }
                                                        let _e4021 = phi_2868_;
                                                        phi_2869_ = _e4017;
                                                        phi_2870_ = _e4019;
                                                        phi_2871_ = _e4021;
                                                        phi_2872_ = false;
                                                    } else {
                                                        phi_2869_ = f64();
                                                        phi_2870_ = false;
                                                        phi_2871_ = false;
                                                        phi_2872_ = true;
                                                    }
                                                    let _e4023 = phi_2869_;
                                                    let _e4025 = phi_2870_;
                                                    let _e4027 = phi_2871_;
                                                    let _e4029 = phi_2872_;
                                                    phi_2873_ = _e4023;
                                                    phi_2874_ = _e4025;
                                                    phi_2875_ = _e4027;
                                                    phi_2876_ = _e4029;
                                                } else {
                                                    phi_2873_ = _e3932;
                                                    phi_2874_ = true;
                                                    phi_2875_ = false;
                                                    phi_2876_ = false;
                                                }
                                                let _e4031 = phi_2873_;
                                                let _e4033 = phi_2874_;
                                                let _e4035 = phi_2875_;
                                                let _e4037 = phi_2876_;
                                                phi_2733_ = _e4031;
                                                phi_2877_ = _e4033;
                                                phi_2878_ = false;
                                                phi_2879_ = _e4035;
                                                phi_2880_ = _e4037;
                                            } else {
                                                phi_2733_ = f64();
                                                phi_2877_ = false;
                                                phi_2878_ = true;
                                                phi_2879_ = false;
                                                phi_2880_ = false;
                                            }
                                            let _e4039 = phi_2733_;
                                            let _e4041 = phi_2877_;
                                            let _e4043 = phi_2878_;
                                            let _e4045 = phi_2879_;
                                            let _e4047 = phi_2880_;
                                            local_40 = _e4043;
                                            local_75 = _e4045;
                                            local_76 = _e4047;
                                            continue;
                                            continuing {
                                                phi_2729_ = _e3946;
                                                phi_2732_ = _e4039;
                                                break if !(_e4041);
                                            }
                                        }
                                        let _e4050 = local_40;
                                        if _e4050 {
                                            let _e4052 = local_41;
                                            let _e4053 = (_e4052 > _e3265);
                                            if _e4053 {
                                                phi_2902_ = false;
                                                phi_2903_ = false;
                                                phi_2904_ = false;
                                            } else {
                                                let _e4055 = local_42;
                                                if (_e4055 > _e3500) {
                                                    let _e4058 = local_43;
                                                    let _e4061 = ((_e4058 - _e3500) < f64(0.00000000023283064f));
                                                    if _e4061 {
                                                        phi_2898_ = false;
                                                    } else {
                                                        phi_2898_ = true;
                                                    }
                                                    let _e4063 = phi_2898_;
                                                    phi_2899_ = _e4063;
                                                    phi_2900_ = _e4061;
                                                    phi_2901_ = false;
                                                } else {
                                                    phi_2899_ = false;
                                                    phi_2900_ = false;
                                                    phi_2901_ = true;
                                                }
                                                let _e4065 = phi_2899_;
                                                let _e4067 = phi_2900_;
                                                let _e4069 = phi_2901_;
                                                phi_2902_ = _e4065;
                                                phi_2903_ = _e4067;
                                                phi_2904_ = _e4069;
                                            }
                                            let _e4071 = phi_2902_;
                                            let _e4073 = phi_2903_;
                                            let _e4075 = phi_2904_;
                                            phi_2905_ = _e4071;
                                            phi_2906_ = _e4053;
                                            phi_2907_ = _e4073;
                                            phi_2908_ = _e4075;
                                            phi_2909_ = false;
                                            phi_2910_ = false;
                                        } else {
                                            phi_2905_ = false;
                                            phi_2906_ = false;
                                            phi_2907_ = false;
                                            phi_2908_ = false;
                                            let _e5653 = local_75;
                                            phi_2909_ = _e5653;
                                            let _e5656 = local_76;
                                            phi_2910_ = _e5656;
                                        }
                                        let _e4077 = phi_2905_;
                                        let _e4079 = phi_2906_;
                                        let _e4081 = phi_2907_;
                                        let _e4083 = phi_2908_;
                                        let _e4085 = phi_2909_;
                                        let _e4087 = phi_2910_;
                                        let _e5659 = local_77;
                                        phi_2911_ = _e5659;
                                        let _e5662 = local_78;
                                        phi_2912_ = _e5662;
                                        phi_2913_ = _e4077;
                                        phi_2914_ = _e4079;
                                        phi_2915_ = _e4081;
                                        phi_2916_ = _e4083;
                                        phi_2917_ = _e4085;
                                        phi_2918_ = _e4087;
                                        phi_2919_ = false;
                                    } else {
                                        phi_2911_ = f64();
                                        phi_2912_ = f64();
                                        phi_2913_ = false;
                                        phi_2914_ = false;
                                        phi_2915_ = false;
                                        phi_2916_ = false;
                                        phi_2917_ = false;
                                        phi_2918_ = false;
                                        phi_2919_ = true;
                                    }
                                    let _e4089 = phi_2911_;
                                    let _e4091 = phi_2912_;
                                    let _e4093 = phi_2913_;
                                    let _e4095 = phi_2914_;
                                    let _e4097 = phi_2915_;
                                    let _e4099 = phi_2916_;
                                    let _e4101 = phi_2917_;
                                    let _e4103 = phi_2918_;
                                    let _e4105 = phi_2919_;
                                    phi_2920_ = _e4089;
                                    phi_2921_ = _e4091;
                                    phi_2922_ = _e4093;
                                    phi_2923_ = _e4095;
                                    phi_2924_ = _e4097;
                                    phi_2925_ = _e4099;
                                    phi_2926_ = _e4101;
                                    phi_2927_ = _e4103;
                                    phi_2928_ = _e4105;
                                    phi_2929_ = false;
                                } else {
                                    phi_2920_ = f64();
                                    phi_2921_ = f64();
                                    phi_2922_ = false;
                                    phi_2923_ = false;
                                    phi_2924_ = false;
                                    phi_2925_ = false;
                                    phi_2926_ = false;
                                    phi_2927_ = false;
                                    phi_2928_ = false;
                                    phi_2929_ = true;
                                }
                                let _e4107 = phi_2920_;
                                let _e4109 = phi_2921_;
                                let _e4111 = phi_2922_;
                                let _e4113 = phi_2923_;
                                let _e4115 = phi_2924_;
                                let _e4117 = phi_2925_;
                                let _e4119 = phi_2926_;
                                let _e4121 = phi_2927_;
                                let _e4123 = phi_2928_;
                                let _e4125 = phi_2929_;
                                phi_2930_ = _e4107;
                                phi_1979_ = _e4109;
                                phi_2931_ = _e4111;
                                phi_2932_ = _e4113;
                                phi_2933_ = _e4115;
                                phi_2934_ = false;
                                phi_2935_ = _e4117;
                                phi_2936_ = _e4119;
                                phi_2937_ = _e4121;
                                phi_2938_ = _e4123;
                                phi_2939_ = _e4125;
                            } else {
                                phi_2930_ = f64();
                                phi_1979_ = f64();
                                phi_2931_ = false;
                                phi_2932_ = false;
                                phi_2933_ = false;
                                phi_2934_ = true;
                                phi_2935_ = false;
                                phi_2936_ = false;
                                phi_2937_ = false;
                                phi_2938_ = false;
                                phi_2939_ = false;
                            }
                            let _e4127 = phi_2930_;
                            let _e4129 = phi_1979_;
                            let _e4131 = phi_2931_;
                            let _e4133 = phi_2932_;
                            let _e4135 = phi_2933_;
                            let _e4137 = phi_2934_;
                            let _e4139 = phi_2935_;
                            let _e4141 = phi_2936_;
                            let _e4143 = phi_2937_;
                            let _e4145 = phi_2938_;
                            let _e4147 = phi_2939_;
                            local_44 = _e4133;
                            local_79 = _e4135;
                            local_80 = _e4137;
                            local_81 = _e4139;
                            local_82 = _e4141;
                            local_83 = _e4143;
                            local_84 = _e4145;
                            local_85 = _e4147;
                            local_86 = _e4127;
                            local_88 = _e4133;
                            continue;
                            continuing {
                                phi_1975_ = _e3514;
                                phi_1978_ = _e4129;
                                break if !(_e4131);
                            }
                        }
                        let _e4150 = local_44;
                        if _e4150 {
                            phi_2944_ = type_73(0u, type_73().member_1);
                            phi_2945_ = false;
                            phi_2946_ = false;
                            phi_2947_ = false;
                            phi_2948_ = false;
                            phi_2949_ = false;
                            phi_2950_ = false;
                            phi_2951_ = false;
                        } else {
                            phi_2944_ = type_73();
                            let _e5695 = local_79;
                            phi_2945_ = _e5695;
                            let _e5698 = local_80;
                            phi_2946_ = _e5698;
                            let _e5701 = local_81;
                            phi_2947_ = _e5701;
                            let _e5704 = local_82;
                            phi_2948_ = _e5704;
                            let _e5707 = local_83;
                            phi_2949_ = _e5707;
                            let _e5710 = local_84;
                            phi_2950_ = _e5710;
                            let _e5713 = local_85;
                            phi_2951_ = _e5713;
                        }
                        let _e4155 = phi_2944_;
                        let _e4157 = phi_2945_;
                        let _e4159 = phi_2946_;
                        let _e4161 = phi_2947_;
                        let _e4163 = phi_2948_;
                        let _e4165 = phi_2949_;
                        let _e4167 = phi_2950_;
                        let _e4169 = phi_2951_;
                        if _e4157 {
                            let _e5716 = local_86;
                            phi_2955_ = _e5716;
                            phi_2956_ = true;
                            phi_2957_ = false;
                            phi_2958_ = false;
                            phi_2959_ = false;
                            phi_2960_ = false;
                            phi_2961_ = false;
                            phi_2962_ = false;
                        } else {
                            let _e5718 = local_87;
                            phi_2955_ = _e5718;
                            phi_2956_ = _e4159;
                            phi_2957_ = _e4161;
                            phi_2958_ = _e4163;
                            phi_2959_ = _e4165;
                            let _e5725 = local_88;
                            phi_2960_ = _e5725;
                            phi_2961_ = _e4167;
                            phi_2962_ = _e4169;
                        }
                        let _e4171 = phi_2955_;
                        let _e4173 = phi_2956_;
                        let _e4175 = phi_2957_;
                        let _e4177 = phi_2958_;
                        let _e4179 = phi_2959_;
                        let _e4181 = phi_2960_;
                        let _e4183 = phi_2961_;
                        let _e4185 = phi_2962_;
                        if _e4173 {
                            phi_2967_ = type_73(1u, _e4171);
                            phi_2968_ = false;
                            phi_2969_ = false;
                            phi_2970_ = false;
                            phi_2971_ = false;
                            phi_2972_ = false;
                            phi_2973_ = false;
                        } else {
                            phi_2967_ = type_73();
                            phi_2968_ = _e4175;
                            phi_2969_ = _e4177;
                            phi_2970_ = _e4179;
                            phi_2971_ = _e4181;
                            phi_2972_ = _e4183;
                            phi_2973_ = _e4185;
                        }
                        let _e4188 = phi_2967_;
                        let _e4190 = phi_2968_;
                        let _e4192 = phi_2969_;
                        let _e4194 = phi_2970_;
                        let _e4196 = phi_2971_;
                        let _e4198 = phi_2972_;
                        let _e4200 = phi_2973_;
                        if _e4190 {
                            let _e4202 = local_45;
                            phi_2978_ = type_73(1u, _e4202);
                            phi_2979_ = false;
                            phi_2980_ = false;
                            phi_2981_ = true;
                            phi_2982_ = false;
                            phi_2983_ = false;
                        } else {
                            phi_2978_ = _e4155;
                            phi_2979_ = _e4192;
                            phi_2980_ = _e4194;
                            phi_2981_ = _e4196;
                            phi_2982_ = _e4198;
                            phi_2983_ = _e4200;
                        }
                        let _e4205 = phi_2978_;
                        let _e4207 = phi_2979_;
                        let _e4209 = phi_2980_;
                        let _e4211 = phi_2981_;
                        let _e4213 = phi_2982_;
                        let _e4215 = phi_2983_;
                        if _e4207 {
                            let _e4217 = local_46;
                            phi_2988_ = type_73(1u, _e4217);
                            phi_2989_ = false;
                            phi_2990_ = false;
                            phi_2991_ = false;
                            phi_2992_ = false;
                        } else {
                            phi_2988_ = type_73();
                            phi_2989_ = _e4209;
                            phi_2990_ = _e4211;
                            phi_2991_ = _e4213;
                            phi_2992_ = _e4215;
                        }
                        let _e4220 = phi_2988_;
                        let _e4222 = phi_2989_;
                        let _e4224 = phi_2990_;
                        let _e4226 = phi_2991_;
                        let _e4228 = phi_2992_;
                        if _e4222 {
                            let _e4230 = local_47;
                            phi_2997_ = type_73(1u, _e4230);
                            phi_2998_ = true;
                            phi_2999_ = false;
                            phi_3000_ = false;
                            phi_3001_ = false;
                        } else {
                            phi_2997_ = _e4220;
                            phi_2998_ = _e4207;
                            phi_2999_ = _e4224;
                            phi_3000_ = _e4226;
                            phi_3001_ = _e4228;
                        }
                        let _e4233 = phi_2997_;
                        let _e4235 = phi_2998_;
                        let _e4237 = phi_2999_;
                        let _e4239 = phi_3000_;
                        let _e4241 = phi_3001_;
                        if _e4235 {
                            phi_3005_ = _e4233;
                            phi_3006_ = true;
                            phi_3007_ = false;
                            phi_3008_ = false;
                        } else {
                            phi_3005_ = _e4205;
                            phi_3006_ = _e4237;
                            phi_3007_ = _e4239;
                            phi_3008_ = _e4241;
                        }
                        let _e4243 = phi_3005_;
                        let _e4245 = phi_3006_;
                        let _e4247 = phi_3007_;
                        let _e4249 = phi_3008_;
                        if _e4245 {
                            phi_3012_ = false;
                            phi_3013_ = false;
                        } else {
                            phi_3012_ = _e4247;
                            phi_3013_ = _e4249;
                        }
                        let _e4251 = phi_3012_;
                        let _e4253 = phi_3013_;
                        if _e4251 {
                            phi_3017_ = false;
                            phi_3018_ = false;
                        } else {
                            phi_3017_ = _e4253;
                            phi_3018_ = _e4245;
                        }
                        let _e4255 = phi_3017_;
                        let _e4257 = phi_3018_;
                        if _e4255 {
                            phi_3022_ = true;
                            phi_3023_ = false;
                        } else {
                            phi_3022_ = _e4251;
                            phi_3023_ = _e4257;
                        }
                        let _e4259 = phi_3022_;
                        let _e4261 = phi_3023_;
                        if _e4259 {
                            let _e4263 = local_48;
                            phi_3028_ = type_73(1u, _e4263);
                            phi_3029_ = true;
                        } else {
                            phi_3028_ = _e4243;
                            phi_3029_ = _e4261;
                        }
                        let _e4266 = phi_3028_;
                        let _e4268 = phi_3029_;
                        if _e4268 {
                            phi_3033_ = _e4266;
                        } else {
                            phi_3033_ = _e4188;
                        }
                        let _e4270 = phi_3033_;
                        if (_e4270.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_3047_ = type_29(0u, 3u);
                            loop {
                                let _e4283 = phi_3047_;
                                if (_e4283.member < _e4283.member_1) {
                                    phi_3048_ = type_29((_e4283.member + 1u), _e4283.member_1);
                                    phi_3071_ = type_29(1u, _e4283.member);
                                } else {
                                    phi_3048_ = _e4283;
                                    phi_3071_ = type_29(0u, type_29().member_1);
                                }
                                let _e4297 = phi_3048_;
                                let _e4299 = phi_3071_;
                                if (bitcast<i32>(_e4299.member) != 0i) {
                                    if (_e4299.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4306 = local_14[_e4299.member_1];
                                    let _e4308 = (_e4270.member_1 + f64(_e4306));
                                    if (_e4308 < _e3265) {
                                        phi_3092_ = _e4308;
                                    } else {
                                        phi_3092_ = _e3265;
                                    }
                                    let _e4311 = phi_3092_;
                                    let _e4314 = local_20.member[0u];
                                    let _e4320 = local_20.member[1u];
                                    let _e4330 = (_e4314[0] + ((_e4320[0] - _e4314[0]) * _e4311));
                                    let _e4331 = (_e4314[1] + ((_e4320[1] - _e4314[1]) * _e4311));
                                    let _e4332 = (_e4314[2] + ((_e4320[2] - _e4314[2]) * _e4311));
                                    let _e4335 = local_20.member_1[0u];
                                    let _e4341 = local_20.member_1[1u];
                                    let _e4351 = (_e4335[0] + ((_e4341[0] - _e4335[0]) * _e4311));
                                    let _e4352 = (_e4335[1] + ((_e4341[1] - _e4335[1]) * _e4311));
                                    let _e4353 = (_e4335[2] + ((_e4341[2] - _e4335[2]) * _e4311));
                                    let _e4356 = local_20.member_2[0u];
                                    let _e4362 = local_20.member_2[1u];
                                    let _e4372 = (_e4356[0] + ((_e4362[0] - _e4356[0]) * _e4311));
                                    let _e4373 = (_e4356[1] + ((_e4362[1] - _e4356[1]) * _e4311));
                                    let _e4374 = (_e4356[2] + ((_e4362[2] - _e4356[2]) * _e4311));
                                    let _e4379 = (((_e4351 * _e4351) + (_e4352 * _e4352)) + (_e4353 * _e4353));
                                    let _e4384 = (((_e4351 * _e4372) + (_e4352 * _e4373)) + (_e4353 * _e4374));
                                    let _e4389 = (((_e4372 * _e4372) + (_e4373 * _e4373)) + (_e4374 * _e4374));
                                    let _e4394 = (((_e4330 * _e4351) + (_e4331 * _e4352)) + (_e4332 * _e4353));
                                    let _e4399 = (((_e4330 * _e4372) + (_e4331 * _e4373)) + (_e4332 * _e4374));
                                    let _e4402 = ((_e4379 * _e4389) - (_e4384 * _e4384));
                                    let _e4403 = f64(0f);
                                    let _e4408 = (((_e4394 * _e4389) - (_e4399 * _e4384)) / _e4402);
                                    let _e4412 = (((_e4399 * _e4379) - (_e4394 * _e4384)) / _e4402);
                                    if (_e4408 >= _e4403) {
                                        if (_e4412 >= _e4403) {
                                            phi_3262_ = ((_e4408 + _e4412) <= f64(1f));
                                            phi_3263_ = false;
                                        } else {
                                            phi_3262_ = bool();
                                            phi_3263_ = true;
                                        }
                                        let _e4418 = phi_3262_;
                                        let _e4420 = phi_3263_;
                                        phi_3264_ = _e4418;
                                        phi_3265_ = _e4420;
                                    } else {
                                        phi_3264_ = bool();
                                        phi_3265_ = true;
                                    }
                                    let _e4422 = phi_3264_;
                                    let _e4424 = phi_3265_;
                                    if _e4424 {
                                        phi_3269_ = false;
                                    } else {
                                        phi_3269_ = _e4422;
                                    }
                                    let _e4426 = phi_3269_;
                                    if (_e4402 > _e4403) {
                                        if _e4426 {
                                            phi_3291_ = array<f64, 3>((_e4330 - ((_e4351 * _e4408) + (_e4372 * _e4412))), (_e4331 - ((_e4352 * _e4408) + (_e4373 * _e4412))), (_e4332 - ((_e4353 * _e4408) + (_e4374 * _e4412))));
                                            phi_3292_ = false;
                                        } else {
                                            phi_3291_ = array<f64, 3>();
                                            phi_3292_ = true;
                                        }
                                        let _e4442 = phi_3291_;
                                        let _e4444 = phi_3292_;
                                        phi_3293_ = _e4442;
                                        phi_3294_ = _e4444;
                                    } else {
                                        phi_3293_ = array<f64, 3>();
                                        phi_3294_ = true;
                                    }
                                    let _e4446 = phi_3293_;
                                    let _e4448 = phi_3294_;
                                    if _e4448 {
                                        let _e4449 = (_e4330 - _e4351);
                                        let _e4450 = (_e4331 - _e4352);
                                        let _e4451 = (_e4332 - _e4353);
                                        let _e4452 = (_e4372 - _e4351);
                                        let _e4453 = (_e4373 - _e4352);
                                        let _e4454 = (_e4374 - _e4353);
                                        let _e4465 = ((((_e4449 * _e4452) + (_e4450 * _e4453)) + (_e4451 * _e4454)) / (((_e4452 * _e4452) + (_e4453 * _e4453)) + (_e4454 * _e4454)));
                                        if (_e4465 > f64(0f)) {
                                            if (_e4465 < f64(1f)) {
                                                phi_3481_ = _e4465;
                                            } else {
                                                phi_3481_ = f64(1f);
                                            }
                                            let _e4473 = phi_3481_;
                                            phi_3483_ = _e4473;
                                        } else {
                                            phi_3483_ = f64(0f);
                                        }
                                        let _e4475 = phi_3483_;
                                        let _e4479 = (_e4449 - (_e4452 * _e4475));
                                        let _e4480 = (_e4450 - (_e4453 * _e4475));
                                        let _e4481 = (_e4451 - (_e4454 * _e4475));
                                        let _e4492 = ((((_e4330 * _e4351) + (_e4331 * _e4352)) + (_e4332 * _e4353)) / (((_e4351 * _e4351) + (_e4352 * _e4352)) + (_e4353 * _e4353)));
                                        if (_e4492 > f64(0f)) {
                                            if (_e4492 < f64(1f)) {
                                                phi_3513_ = _e4492;
                                            } else {
                                                phi_3513_ = f64(1f);
                                            }
                                            let _e4500 = phi_3513_;
                                            phi_3515_ = _e4500;
                                        } else {
                                            phi_3515_ = f64(0f);
                                        }
                                        let _e4502 = phi_3515_;
                                        let _e4519 = ((((_e4330 * _e4372) + (_e4331 * _e4373)) + (_e4332 * _e4374)) / (((_e4372 * _e4372) + (_e4373 * _e4373)) + (_e4374 * _e4374)));
                                        if (_e4519 > f64(0f)) {
                                            if (_e4519 < f64(1f)) {
                                                phi_3545_ = _e4519;
                                            } else {
                                                phi_3545_ = f64(1f);
                                            }
                                            let _e4527 = phi_3545_;
                                            phi_3547_ = _e4527;
                                        } else {
                                            phi_3547_ = f64(0f);
                                        }
                                        let _e4529 = phi_3547_;
                                        local_10[0u] = array<f64, 3>((_e4330 - (_e4351 * _e4502)), (_e4331 - (_e4352 * _e4502)), (_e4332 - (_e4353 * _e4502)));
                                        local_10[1u] = array<f64, 3>((_e4330 - (_e4372 * _e4529)), (_e4331 - (_e4373 * _e4529)), (_e4332 - (_e4374 * _e4529)));
                                        local_10[2u] = array<f64, 3>(_e4479, _e4480, _e4481);
                                        local_10[3u] = array<f64, 3>(_e4479, _e4480, _e4481);
                                        let _e4545 = local_10[0u];
                                        phi_3583_ = type_29(1u, 4u);
                                        phi_3586_ = array<f64, 3>(_e4545[0], _e4545[1], _e4545[2]);
                                        loop {
                                            let _e4551 = phi_3583_;
                                            let _e4553 = phi_3586_;
                                            local_89 = _e4553;
                                            if (_e4551.member < _e4551.member_1) {
                                                phi_3584_ = type_29((_e4551.member + 1u), _e4551.member_1);
                                                phi_3609_ = type_29(1u, _e4551.member);
                                            } else {
                                                phi_3584_ = _e4551;
                                                phi_3609_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e4567 = phi_3584_;
                                            let _e4569 = phi_3609_;
                                            let _e4573 = (bitcast<i32>(_e4569.member) != 0i);
                                            if _e4573 {
                                                if (_e4569.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4576 = local_10[_e4569.member_1];
                                                if (_e4569.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4582 = local_10[_e4569.member_1];
                                                if ((((_e4576[0] * _e4582[0]) + (_e4576[1] * _e4582[1])) + (_e4576[2] * _e4582[2])) < (((_e4553[0] * _e4553[0]) + (_e4553[1] * _e4553[1])) + (_e4553[2] * _e4553[2]))) {
                                                    if (_e4569.member_1 < 4u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e4605 = local_10[_e4569.member_1];
                                                    phi_3676_ = array<f64, 3>(_e4605[0], _e4605[1], _e4605[2]);
                                                } else {
                                                    phi_3676_ = _e4553;
                                                }
                                                let _e4611 = phi_3676_;
                                                phi_3587_ = _e4611;
                                            } else {
                                                phi_3587_ = array<f64, 3>();
                                            }
                                            let _e4613 = phi_3587_;
                                            continue;
                                            continuing {
                                                phi_3583_ = _e4567;
                                                phi_3586_ = _e4613;
                                                break if !(_e4573);
                                            }
                                        }
                                        let _e5795 = local_89;
                                        phi_3677_ = _e5795;
                                    } else {
                                        phi_3677_ = _e4446;
                                    }
                                    let _e4616 = phi_3677_;
                                    let _e4627 = (((_e4616[0] * _e4616[0]) + (_e4616[1] * _e4616[1])) + (_e4616[2] * _e4616[2]));
                                    if (_e4627 <= 2.2250738585072014e-308lf) {
                                        if (_e4627 > 0.0lf) {
                                            phi_3702_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3702_ = 0.0lf;
                                        }
                                        let _e4685 = phi_3702_;
                                        phi_3766_ = _e4685;
                                    } else {
                                        phi_3709_ = type_27(0i, 5i);
                                        phi_3712_ = bitcast<f64>(((bitcast<u64>(_e4627) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e4634 = phi_3709_;
                                            let _e4636 = phi_3712_;
                                            local_49 = _e4636;
                                            if (_e4634.member < _e4634.member_1) {
                                                let _e4644 = (_e4634.member + 1i);
                                                if ((false == (_e4644 > _e4634.member)) != false) {
                                                    phi_3733_ = true;
                                                } else {
                                                    phi_3733_ = false;
                                                }
                                                let _e4649 = phi_3733_;
                                                if _e4649 {
                                                    phi_3739_ = type_28(0u, type_28().member_1);
                                                } else {
                                                    phi_3739_ = type_28(1u, _e4644);
                                                }
                                                let _e4655 = phi_3739_;
                                                if (bitcast<i32>(_e4655.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3710_ = type_27(_e4655.member_1, _e4634.member_1);
                                                phi_3753_ = type_28(1u, _e4634.member);
                                            } else {
                                                phi_3710_ = _e4634;
                                                phi_3753_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4665 = phi_3710_;
                                            let _e4667 = phi_3753_;
                                            let _e4670 = (bitcast<i32>(_e4667.member) != 0i);
                                            if _e4670 {
                                                phi_3713_ = (0.5lf * (_e4636 + (_e4627 / _e4636)));
                                            } else {
                                                phi_3713_ = f64();
                                            }
                                            let _e4675 = phi_3713_;
                                            continue;
                                            continuing {
                                                phi_3709_ = _e4665;
                                                phi_3712_ = _e4675;
                                                break if !(_e4670);
                                            }
                                        }
                                        let _e4680 = local_49;
                                        phi_3766_ = (_e4680 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e4687 = phi_3766_;
                                    let _e4695 = local_20.member[0u];
                                    if (_e4695[0] < 0.0lf) {
                                        phi_3784_ = -(_e4695[0]);
                                    } else {
                                        phi_3784_ = _e4695[0];
                                    }
                                    let _e4702 = phi_3784_;
                                    if (_e4695[1] < 0.0lf) {
                                        phi_3791_ = -(_e4695[1]);
                                    } else {
                                        phi_3791_ = _e4695[1];
                                    }
                                    let _e4706 = phi_3791_;
                                    if (_e4702 > _e4706) {
                                        phi_3796_ = _e4702;
                                    } else {
                                        phi_3796_ = _e4706;
                                    }
                                    let _e4709 = phi_3796_;
                                    if (_e4695[2] < 0.0lf) {
                                        phi_3803_ = -(_e4695[2]);
                                    } else {
                                        phi_3803_ = _e4695[2];
                                    }
                                    let _e4713 = phi_3803_;
                                    if (_e4709 > _e4713) {
                                        phi_3808_ = _e4709;
                                    } else {
                                        phi_3808_ = _e4713;
                                    }
                                    let _e4716 = phi_3808_;
                                    let _e4719 = local_20.member[1u];
                                    if (_e4719[0] < 0.0lf) {
                                        phi_3821_ = -(_e4719[0]);
                                    } else {
                                        phi_3821_ = _e4719[0];
                                    }
                                    let _e4726 = phi_3821_;
                                    if (_e4719[1] < 0.0lf) {
                                        phi_3828_ = -(_e4719[1]);
                                    } else {
                                        phi_3828_ = _e4719[1];
                                    }
                                    let _e4730 = phi_3828_;
                                    if (_e4726 > _e4730) {
                                        phi_3833_ = _e4726;
                                    } else {
                                        phi_3833_ = _e4730;
                                    }
                                    let _e4733 = phi_3833_;
                                    if (_e4719[2] < 0.0lf) {
                                        phi_3840_ = -(_e4719[2]);
                                    } else {
                                        phi_3840_ = _e4719[2];
                                    }
                                    let _e4737 = phi_3840_;
                                    if (_e4733 > _e4737) {
                                        phi_3845_ = _e4733;
                                    } else {
                                        phi_3845_ = _e4737;
                                    }
                                    let _e4740 = phi_3845_;
                                    if (_e4716 > _e4740) {
                                        phi_3850_ = _e4716;
                                    } else {
                                        phi_3850_ = _e4740;
                                    }
                                    let _e4743 = phi_3850_;
                                    let _e4745 = local_20.member_3;
                                    let _e4749 = local_20.member_1[0u];
                                    if (_e4749[0] < 0.0lf) {
                                        phi_3867_ = -(_e4749[0]);
                                    } else {
                                        phi_3867_ = _e4749[0];
                                    }
                                    let _e4756 = phi_3867_;
                                    if (_e4749[1] < 0.0lf) {
                                        phi_3874_ = -(_e4749[1]);
                                    } else {
                                        phi_3874_ = _e4749[1];
                                    }
                                    let _e4760 = phi_3874_;
                                    if (_e4756 > _e4760) {
                                        phi_3879_ = _e4756;
                                    } else {
                                        phi_3879_ = _e4760;
                                    }
                                    let _e4763 = phi_3879_;
                                    if (_e4749[2] < 0.0lf) {
                                        phi_3886_ = -(_e4749[2]);
                                    } else {
                                        phi_3886_ = _e4749[2];
                                    }
                                    let _e4767 = phi_3886_;
                                    if (_e4763 > _e4767) {
                                        phi_3891_ = _e4763;
                                    } else {
                                        phi_3891_ = _e4767;
                                    }
                                    let _e4770 = phi_3891_;
                                    let _e4773 = local_20.member_1[1u];
                                    if (_e4773[0] < 0.0lf) {
                                        phi_3905_ = -(_e4773[0]);
                                    } else {
                                        phi_3905_ = _e4773[0];
                                    }
                                    let _e4780 = phi_3905_;
                                    if (_e4773[1] < 0.0lf) {
                                        phi_3912_ = -(_e4773[1]);
                                    } else {
                                        phi_3912_ = _e4773[1];
                                    }
                                    let _e4784 = phi_3912_;
                                    if (_e4780 > _e4784) {
                                        phi_3917_ = _e4780;
                                    } else {
                                        phi_3917_ = _e4784;
                                    }
                                    let _e4787 = phi_3917_;
                                    if (_e4773[2] < 0.0lf) {
                                        phi_3924_ = -(_e4773[2]);
                                    } else {
                                        phi_3924_ = _e4773[2];
                                    }
                                    let _e4791 = phi_3924_;
                                    if (_e4787 > _e4791) {
                                        phi_3929_ = _e4787;
                                    } else {
                                        phi_3929_ = _e4791;
                                    }
                                    let _e4794 = phi_3929_;
                                    if (_e4770 > _e4794) {
                                        phi_3934_ = _e4770;
                                    } else {
                                        phi_3934_ = _e4794;
                                    }
                                    let _e4797 = phi_3934_;
                                    let _e4799 = local_20.member_3;
                                    let _e4803 = local_20.member_2[0u];
                                    if (_e4803[0] < 0.0lf) {
                                        phi_3951_ = -(_e4803[0]);
                                    } else {
                                        phi_3951_ = _e4803[0];
                                    }
                                    let _e4810 = phi_3951_;
                                    if (_e4803[1] < 0.0lf) {
                                        phi_3958_ = -(_e4803[1]);
                                    } else {
                                        phi_3958_ = _e4803[1];
                                    }
                                    let _e4814 = phi_3958_;
                                    if (_e4810 > _e4814) {
                                        phi_3963_ = _e4810;
                                    } else {
                                        phi_3963_ = _e4814;
                                    }
                                    let _e4817 = phi_3963_;
                                    if (_e4803[2] < 0.0lf) {
                                        phi_3970_ = -(_e4803[2]);
                                    } else {
                                        phi_3970_ = _e4803[2];
                                    }
                                    let _e4821 = phi_3970_;
                                    if (_e4817 > _e4821) {
                                        phi_3975_ = _e4817;
                                    } else {
                                        phi_3975_ = _e4821;
                                    }
                                    let _e4824 = phi_3975_;
                                    let _e4827 = local_20.member_2[1u];
                                    if (_e4827[0] < 0.0lf) {
                                        phi_3989_ = -(_e4827[0]);
                                    } else {
                                        phi_3989_ = _e4827[0];
                                    }
                                    let _e4834 = phi_3989_;
                                    if (_e4827[1] < 0.0lf) {
                                        phi_3996_ = -(_e4827[1]);
                                    } else {
                                        phi_3996_ = _e4827[1];
                                    }
                                    let _e4838 = phi_3996_;
                                    if (_e4834 > _e4838) {
                                        phi_4001_ = _e4834;
                                    } else {
                                        phi_4001_ = _e4838;
                                    }
                                    let _e4841 = phi_4001_;
                                    if (_e4827[2] < 0.0lf) {
                                        phi_4008_ = -(_e4827[2]);
                                    } else {
                                        phi_4008_ = _e4827[2];
                                    }
                                    let _e4845 = phi_4008_;
                                    if (_e4841 > _e4845) {
                                        phi_4013_ = _e4841;
                                    } else {
                                        phi_4013_ = _e4845;
                                    }
                                    let _e4848 = phi_4013_;
                                    if (_e4824 > _e4848) {
                                        phi_4018_ = _e4824;
                                    } else {
                                        phi_4018_ = _e4848;
                                    }
                                    let _e4851 = phi_4018_;
                                    let _e4853 = local_20.member_3;
                                    let _e4861 = local_20.member_3;
                                    let _e4871 = (((_e4687 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e4743 + _e4745) + (_e4797 + _e4799)) + (_e4851 + _e4853)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4861 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e443);
                                    if _e4871 {
                                        phi_4042_ = false;
                                    } else {
                                        phi_4042_ = true;
                                    }
                                    let _e4873 = phi_4042_;
                                    phi_4043_ = _e4873;
                                    phi_4044_ = _e4871;
                                } else {
                                    phi_4043_ = false;
                                    phi_4044_ = false;
                                }
                                let _e4875 = phi_4043_;
                                let _e4877 = phi_4044_;
                                local_50 = _e4877;
                                continue;
                                continuing {
                                    phi_3047_ = _e4297;
                                    break if !(_e4875);
                                }
                            }
                            let _e4880 = local_50;
                            if _e4880 {
                                phi_4049_ = type_73(1u, _e4270.member_1);
                                phi_4050_ = false;
                            } else {
                                phi_4049_ = type_73();
                                phi_4050_ = true;
                            }
                            let _e4883 = phi_4049_;
                            let _e4885 = phi_4050_;
                            if _e4885 {
                                phi_4055_ = type_73(2u, _e4270.member_1);
                                phi_4056_ = false;
                            } else {
                                phi_4055_ = type_73();
                                phi_4056_ = true;
                            }
                            let _e4888 = phi_4055_;
                            let _e4890 = phi_4056_;
                            phi_4058_ = _e4888;
                            phi_4059_ = _e4883;
                            phi_4060_ = _e4890;
                        } else {
                            phi_4058_ = type_73();
                            phi_4059_ = type_73(0u, type_73().member_1);
                            phi_4060_ = true;
                        }
                        let _e4892 = phi_4058_;
                        let _e4894 = phi_4059_;
                        let _e4896 = phi_4060_;
                        if _e4896 {
                            phi_4064_ = _e4894;
                        } else {
                            phi_4064_ = _e4892;
                        }
                        let _e4898 = phi_4064_;
                        phi_7435_ = _e4898;
                    } else {
                        if (_e542 < 0.0lf) {
                            phi_4075_ = -(_e542);
                        } else {
                            phi_4075_ = _e542;
                        }
                        let _e897 = phi_4075_;
                        if (_e565 < 0.0lf) {
                            phi_4081_ = -(_e565);
                        } else {
                            phi_4081_ = _e565;
                        }
                        let _e901 = phi_4081_;
                        if (_e897 > _e901) {
                            phi_4086_ = _e897;
                        } else {
                            phi_4086_ = _e901;
                        }
                        let _e904 = phi_4086_;
                        if (_e588 < 0.0lf) {
                            phi_4092_ = -(_e588);
                        } else {
                            phi_4092_ = _e588;
                        }
                        let _e908 = phi_4092_;
                        if (_e599 < 0.0lf) {
                            phi_4098_ = -(_e599);
                        } else {
                            phi_4098_ = _e599;
                        }
                        let _e912 = phi_4098_;
                        if (_e908 > _e912) {
                            phi_4103_ = _e908;
                        } else {
                            phi_4103_ = _e912;
                        }
                        let _e915 = phi_4103_;
                        if (_e904 > _e915) {
                            phi_4108_ = _e904;
                        } else {
                            phi_4108_ = _e915;
                        }
                        let _e918 = phi_4108_;
                        let _e920 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e921 = f64(1f);
                        if (_e918 >= _e920) {
                            phi_4118_ = (_e918 <= (_e921 / _e920));
                        } else {
                            phi_4118_ = false;
                        }
                        let _e926 = phi_4118_;
                        if _e926 {
                            phi_4125_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_4125_ = f64(2f);
                        }
                        let _e931 = phi_4125_;
                        let _e933 = ((_e858 * f64(0.34f)) + (_e918 * _e931));
                        if _e926 {
                            phi_4133_ = (_e921 / _e918);
                        } else {
                            phi_4133_ = f64(0f);
                        }
                        let _e937 = phi_4133_;
                        let _e938 = f64(0f);
                        let _e939 = f64(1f);
                        let _e940 = f64(3f);
                        let _e946 = ((_e565 - (_e940 * _e542)) * _e937);
                        let _e947 = ((_e588 - _e565) * _e937);
                        let _e948 = (((_e940 * _e599) - _e588) * _e937);
                        local_7[0u] = _e938;
                        local_7[1u] = _e939;
                        local_7[2u] = _e939;
                        local_7[3u] = _e939;
                        let _e955 = ((_e947 * _e947) - (_e946 * _e948));
                        if (_e955 > _e938) {
                            if (_e955 <= 2.2250738585072014e-308lf) {
                                if (_e955 > 0.0lf) {
                                    phi_4169_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4169_ = 0.0lf;
                                }
                                let _e1014 = phi_4169_;
                                phi_4233_ = _e1014;
                            } else {
                                phi_4176_ = type_27(0i, 5i);
                                phi_4179_ = bitcast<f64>(((bitcast<u64>(_e955) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e963 = phi_4176_;
                                    let _e965 = phi_4179_;
                                    local_21 = _e965;
                                    if (_e963.member < _e963.member_1) {
                                        let _e973 = (_e963.member + 1i);
                                        if ((false == (_e973 > _e963.member)) != false) {
                                            phi_4200_ = true;
                                        } else {
                                            phi_4200_ = false;
                                        }
                                        let _e978 = phi_4200_;
                                        if _e978 {
                                            phi_4206_ = type_28(0u, type_28().member_1);
                                        } else {
                                            phi_4206_ = type_28(1u, _e973);
                                        }
                                        let _e984 = phi_4206_;
                                        if (bitcast<i32>(_e984.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_4177_ = type_27(_e984.member_1, _e963.member_1);
                                        phi_4220_ = type_28(1u, _e963.member);
                                    } else {
                                        phi_4177_ = _e963;
                                        phi_4220_ = type_28(0u, type_28().member_1);
                                    }
                                    let _e994 = phi_4177_;
                                    let _e996 = phi_4220_;
                                    let _e999 = (bitcast<i32>(_e996.member) != 0i);
                                    if _e999 {
                                        phi_4180_ = (0.5lf * (_e965 + (_e955 / _e965)));
                                    } else {
                                        phi_4180_ = f64();
                                    }
                                    let _e1004 = phi_4180_;
                                    continue;
                                    continuing {
                                        phi_4176_ = _e994;
                                        phi_4179_ = _e1004;
                                        break if !(_e999);
                                    }
                                }
                                let _e1009 = local_21;
                                phi_4233_ = (_e1009 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1016 = phi_4233_;
                            if (_e947 < _e938) {
                                phi_4239_ = -(_e1016);
                            } else {
                                phi_4239_ = _e1016;
                            }
                            let _e1020 = phi_4239_;
                            let _e1022 = -((_e947 + _e1020));
                            local_8[0u] = (_e1022 / (_e1022 + _e948));
                            local_8[1u] = (_e946 / (_e946 + _e1022));
                            let _e1031 = local_8[1u];
                            let _e1032 = local_8[0u];
                            if (_e1031 < _e1032) {
                                let _e1035 = local_8[1u];
                                let _e1037 = local_8[0u];
                                local_8[0u] = _e1035;
                                local_8[1u] = _e1037;
                            }
                            phi_4264_ = type_29(0u, 2u);
                            phi_4267_ = 1u;
                            loop {
                                let _e1041 = phi_4264_;
                                let _e1043 = phi_4267_;
                                local_51 = _e1043;
                                if (_e1041.member < _e1041.member_1) {
                                    phi_4265_ = type_29((_e1041.member + 1u), _e1041.member_1);
                                    phi_4290_ = type_29(1u, _e1041.member);
                                } else {
                                    phi_4265_ = _e1041;
                                    phi_4290_ = type_29(0u, type_29().member_1);
                                }
                                let _e1057 = phi_4265_;
                                let _e1059 = phi_4290_;
                                let _e1063 = (bitcast<i32>(_e1059.member) != 0i);
                                if _e1063 {
                                    if (_e1059.member_1 < 2u) {
                                    } else {
                                        return;
                                    }
                                    let _e1066 = local_8[_e1059.member_1];
                                    if (_e1066 > _e938) {
                                        if (_e1059.member_1 < 2u) {
                                        } else {
                                            return;
                                        }
                                        let _e1070 = local_8[_e1059.member_1];
                                        if (_e1070 < _e939) {
                                            if (_e1059.member_1 < 2u) {
                                            } else {
                                                return;
                                            }
                                            let _e1074 = local_8[_e1059.member_1];
                                            if (_e1043 < 4u) {
                                            } else {
                                                return;
                                            }
                                            local_7[_e1043] = _e1074;
                                            phi_4334_ = (_e1043 + 1u);
                                        } else {
                                            phi_4334_ = _e1043;
                                        }
                                        let _e1079 = phi_4334_;
                                        phi_4335_ = _e1079;
                                    } else {
                                        phi_4335_ = _e1043;
                                    }
                                    let _e1081 = phi_4335_;
                                    phi_4268_ = _e1081;
                                } else {
                                    phi_4268_ = u32();
                                }
                                let _e1083 = phi_4268_;
                                continue;
                                continuing {
                                    phi_4264_ = _e1057;
                                    phi_4267_ = _e1083;
                                    break if !(_e1063);
                                }
                            }
                            let _e5085 = local_51;
                            phi_4336_ = _e5085;
                        } else {
                            phi_4336_ = 1u;
                        }
                        let _e1086 = phi_4336_;
                        if (_e1086 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e1086] = _e939;
                        let _e1089 = local_7;
                        local_9 = _e1089;
                        phi_4356_ = type_29(0u, _e1086);
                        loop {
                            let _e1092 = phi_4356_;
                            if (_e1092.member < _e1092.member_1) {
                                phi_4357_ = type_29((_e1092.member + 1u), _e1092.member_1);
                                phi_4380_ = type_29(1u, _e1092.member);
                            } else {
                                phi_4357_ = _e1092;
                                phi_4380_ = type_29(0u, type_29().member_1);
                            }
                            let _e1106 = phi_4357_;
                            let _e1108 = phi_4380_;
                            if (bitcast<i32>(_e1108.member) != 0i) {
                                if (_e1108.member_1 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1115 = local_9[_e1108.member_1];
                                let _e1116 = (_e1108.member_1 + 1u);
                                if (_e1116 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1119 = local_9[_e1116];
                                let _e1121 = (f64(1f) - _e1115);
                                let _e1132 = ((((_e542 * _e1121) + (_e565 * _e1115)) * (_e1121 * _e1121)) + (((_e588 * _e1121) + (_e599 * _e1115)) * (_e1115 * _e1115)));
                                let _e1134 = (f64(1f) - _e1119);
                                let _e1145 = ((((_e542 * _e1134) + (_e565 * _e1119)) * (_e1134 * _e1134)) + (((_e588 * _e1134) + (_e599 * _e1119)) * (_e1119 * _e1119)));
                                if (_e1132 < 0.0lf) {
                                    phi_4434_ = -(_e1132);
                                } else {
                                    phi_4434_ = _e1132;
                                }
                                let _e1149 = phi_4434_;
                                let _e1150 = (_e1149 > _e933);
                                if (_e1145 < 0.0lf) {
                                    phi_4441_ = -(_e1145);
                                } else {
                                    phi_4441_ = _e1145;
                                }
                                let _e1154 = phi_4441_;
                                let _e1155 = (_e1154 > _e933);
                                let _e1156 = f64(0f);
                                if _e1150 {
                                    if _e1155 {
                                        phi_4453_ = ((_e1132 > _e1156) != (_e1145 > _e1156));
                                        phi_4454_ = false;
                                    } else {
                                        phi_4453_ = bool();
                                        phi_4454_ = true;
                                    }
                                    let _e1161 = phi_4453_;
                                    let _e1163 = phi_4454_;
                                    phi_4455_ = _e1161;
                                    phi_4456_ = _e1163;
                                } else {
                                    phi_4455_ = bool();
                                    phi_4456_ = true;
                                }
                                let _e1165 = phi_4455_;
                                let _e1167 = phi_4456_;
                                if _e1167 {
                                    phi_4460_ = false;
                                } else {
                                    phi_4460_ = _e1165;
                                }
                                let _e1169 = phi_4460_;
                                if _e1150 {
                                    if _e1155 {
                                        if _e1169 {
                                            phi_4472_ = type_74();
                                        } else {
                                            phi_4472_ = type_74(f64(1f), _e1156, _e1169);
                                        }
                                        let _e1173 = phi_4472_;
                                        phi_4473_ = _e1173;
                                        phi_4474_ = _e1169;
                                    } else {
                                        phi_4473_ = type_74();
                                        phi_4474_ = true;
                                    }
                                    let _e1175 = phi_4473_;
                                    let _e1177 = phi_4474_;
                                    phi_4475_ = _e1175;
                                    phi_4476_ = _e1177;
                                } else {
                                    phi_4475_ = type_74();
                                    phi_4476_ = true;
                                }
                                let _e1179 = phi_4475_;
                                let _e1181 = phi_4476_;
                                if _e1181 {
                                    if _e1150 {
                                        if (_e1132 < _e1156) {
                                            phi_4489_ = f64(-1f);
                                        } else {
                                            phi_4489_ = f64(1f);
                                        }
                                        let _e1186 = phi_4489_;
                                        let _e1187 = f64(0.00000000000022737368f);
                                        let _e1188 = f64(0.5f);
                                        let _e1189 = f64(3f);
                                        let _e1192 = (_e588 - _e565);
                                        phi_4502_ = type_29(0u, 64u);
                                        phi_4505_ = _e1119;
                                        phi_4507_ = _e1115;
                                        phi_4509_ = (_e1188 * (_e1115 + _e1119));
                                        loop {
                                            let _e1198 = phi_4502_;
                                            let _e1200 = phi_4505_;
                                            let _e1202 = phi_4507_;
                                            let _e1204 = phi_4509_;
                                            local_53 = _e1202;
                                            if (_e1198.member < _e1198.member_1) {
                                                phi_4503_ = type_29((_e1198.member + 1u), _e1198.member_1);
                                                phi_4532_ = type_29(1u, _e1198.member);
                                            } else {
                                                phi_4503_ = _e1198;
                                                phi_4532_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1218 = phi_4503_;
                                            let _e1220 = phi_4532_;
                                            if (bitcast<i32>(_e1220.member) != 0i) {
                                                let _e1225 = (f64(1f) - _e1204);
                                                let _e1238 = ((_e1186 * ((((_e542 * _e1225) + (_e565 * _e1204)) * (_e1225 * _e1225)) + (((_e588 * _e1225) + (_e599 * _e1204)) * (_e1204 * _e1204)))) - _e933);
                                                if (_e1238 > f64(0f)) {
                                                    phi_4559_ = _e1200;
                                                    phi_4560_ = _e1204;
                                                } else {
                                                    phi_4559_ = _e1204;
                                                    phi_4560_ = _e1202;
                                                }
                                                let _e1242 = phi_4559_;
                                                let _e1244 = phi_4560_;
                                                let _e1246 = ((_e1242 - _e1244) > _e1187);
                                                if _e1246 {
                                                    let _e1248 = (f64(1f) - _e1204);
                                                    let _e1260 = (-(_e1238) / (_e1186 * (((((_e565 - (_e1189 * _e542)) * _e1248) + (_e1192 * _e1204)) * _e1248) + (((_e1192 * _e1248) + (((_e1189 * _e599) - _e588) * _e1204)) * _e1204))));
                                                    if (_e1238 > f64(0f)) {
                                                        phi_4588_ = (_e1188 * _e1187);
                                                    } else {
                                                        phi_4588_ = -((_e1188 * _e1187));
                                                    }
                                                    let _e1267 = phi_4588_;
                                                    let _e1269 = ((_e1204 + _e1260) + _e1267);
                                                    if (_e1269 > _e1244) {
                                                        if (_e1269 < _e1242) {
                                                            if (_e1260 < 0.0lf) {
                                                                phi_4604_ = -(_e1260);
                                                            } else {
                                                                phi_4604_ = _e1260;
                                                            }
                                                            let _e1275 = phi_4604_;
                                                            if (_e1275 < (_e1188 * (_e1242 - _e1244))) {
                                                                phi_4611_ = false;
                                                            } else {
                                                                phi_4611_ = true;
                                                            }
                                                            let _e1280 = phi_4611_;
                                                            phi_4612_ = _e1280;
                                                        } else {
                                                            phi_4612_ = true;
                                                        }
                                                        let _e1282 = phi_4612_;
                                                        phi_4613_ = _e1282;
                                                    } else {
                                                        phi_4613_ = true;
                                                    }
                                                    let _e1284 = phi_4613_;
                                                    if _e1284 {
                                                        phi_4619_ = (_e1188 * (_e1244 + _e1242));
                                                    } else {
                                                        phi_4619_ = _e1269;
                                                    }
                                                    let _e1288 = phi_4619_;
                                                    phi_4620_ = _e1288;
                                                    phi_4621_ = false;
                                                } else {
                                                    phi_4620_ = f64();
                                                    phi_4621_ = true;
                                                }
                                                let _e1290 = phi_4620_;
                                                let _e1292 = phi_4621_;
                                                phi_4506_ = _e1242;
                                                phi_4508_ = _e1244;
                                                phi_4510_ = _e1290;
                                                phi_4622_ = _e1244;
                                                phi_4623_ = _e1246;
                                                phi_4624_ = _e1292;
                                            } else {
                                                phi_4506_ = f64();
                                                phi_4508_ = f64();
                                                phi_4510_ = f64();
                                                phi_4622_ = f64();
                                                phi_4623_ = false;
                                                phi_4624_ = false;
                                            }
                                            let _e1294 = phi_4506_;
                                            let _e1296 = phi_4508_;
                                            let _e1298 = phi_4510_;
                                            let _e1300 = phi_4622_;
                                            let _e1302 = phi_4623_;
                                            let _e1304 = phi_4624_;
                                            local_22 = _e1304;
                                            local_52 = _e1300;
                                            continue;
                                            continuing {
                                                phi_4502_ = _e1218;
                                                phi_4505_ = _e1294;
                                                phi_4507_ = _e1296;
                                                phi_4509_ = _e1298;
                                                break if !(_e1302);
                                            }
                                        }
                                        let _e1307 = local_22;
                                        if _e1307 {
                                            let _e5127 = local_52;
                                            phi_4628_ = _e5127;
                                        } else {
                                            let _e5129 = local_53;
                                            phi_4628_ = _e5129;
                                        }
                                        let _e1309 = phi_4628_;
                                        phi_4629_ = _e1309;
                                    } else {
                                        phi_4629_ = _e1115;
                                    }
                                    let _e1311 = phi_4629_;
                                    if _e1155 {
                                        phi_4637_ = type_29(0u, 64u);
                                        phi_4640_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1315 = phi_4637_;
                                            let _e1317 = phi_4640_;
                                            if (_e1315.member < _e1315.member_1) {
                                                phi_4638_ = type_29((_e1315.member + 1u), _e1315.member_1);
                                                phi_4663_ = type_29(1u, _e1315.member);
                                            } else {
                                                phi_4638_ = _e1315;
                                                phi_4663_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1331 = phi_4638_;
                                            let _e1333 = phi_4663_;
                                            if (bitcast<i32>(_e1333.member) != 0i) {
                                                let _e1337 = (_e1311 + _e1317);
                                                if (_e1337 < _e1119) {
                                                    let _e1340 = (f64(1f) - _e1337);
                                                    let _e1351 = ((((_e542 * _e1340) + (_e565 * _e1337)) * (_e1340 * _e1340)) + (((_e588 * _e1340) + (_e599 * _e1337)) * (_e1337 * _e1337)));
                                                    let _e1353 = (f64(1f) - _e1311);
                                                    let _e1364 = ((((_e542 * _e1353) + (_e565 * _e1311)) * (_e1353 * _e1353)) + (((_e588 * _e1353) + (_e599 * _e1311)) * (_e1311 * _e1311)));
                                                    if (_e1351 < 0.0lf) {
                                                        phi_4706_ = -(_e1351);
                                                    } else {
                                                        phi_4706_ = _e1351;
                                                    }
                                                    let _e1368 = phi_4706_;
                                                    if (_e1368 > _e933) {
                                                        if (_e1364 < 0.0lf) {
                                                            phi_4716_ = -(_e1364);
                                                        } else {
                                                            phi_4716_ = _e1364;
                                                        }
                                                        let _e1373 = phi_4716_;
                                                        if (_e1373 > _e933) {
                                                            phi_4726_ = ((_e1351 > f64(0f)) == (_e1364 > f64(0f)));
                                                        } else {
                                                            phi_4726_ = false;
                                                        }
                                                        let _e1381 = phi_4726_;
                                                        phi_4728_ = !(_e1381);
                                                    } else {
                                                        phi_4728_ = false;
                                                    }
                                                    let _e1384 = phi_4728_;
                                                    if _e1384 {
                                                        phi_4733_ = f64();
                                                        phi_4734_ = false;
                                                    } else {
                                                        phi_4733_ = (_e1317 + _e1317);
                                                        phi_4734_ = true;
                                                    }
                                                    let _e1387 = phi_4733_;
                                                    let _e1389 = phi_4734_;
                                                    phi_4735_ = _e1387;
                                                    phi_4736_ = _e1389;
                                                    phi_4737_ = _e1384;
                                                    phi_4738_ = false;
                                                } else {
                                                    phi_4735_ = f64();
                                                    phi_4736_ = false;
                                                    phi_4737_ = false;
                                                    phi_4738_ = true;
                                                }
                                                let _e1391 = phi_4735_;
                                                let _e1393 = phi_4736_;
                                                let _e1395 = phi_4737_;
                                                let _e1397 = phi_4738_;
                                                phi_4739_ = _e1337;
                                                phi_4641_ = _e1391;
                                                phi_4740_ = _e1393;
                                                phi_4741_ = _e1395;
                                                phi_4742_ = _e1397;
                                                phi_4743_ = false;
                                            } else {
                                                phi_4739_ = f64();
                                                phi_4641_ = f64();
                                                phi_4740_ = false;
                                                phi_4741_ = false;
                                                phi_4742_ = false;
                                                phi_4743_ = true;
                                            }
                                            let _e1399 = phi_4739_;
                                            let _e1401 = phi_4641_;
                                            let _e1403 = phi_4740_;
                                            let _e1405 = phi_4741_;
                                            let _e1407 = phi_4742_;
                                            let _e1409 = phi_4743_;
                                            local_23 = _e1405;
                                            local_54 = _e1407;
                                            local_55 = _e1409;
                                            local_56 = _e1399;
                                            continue;
                                            continuing {
                                                phi_4637_ = _e1331;
                                                phi_4640_ = _e1401;
                                                break if !(_e1403);
                                            }
                                        }
                                        let _e1412 = local_23;
                                        if _e1412 {
                                            phi_4747_ = false;
                                            phi_4748_ = false;
                                        } else {
                                            let _e5154 = local_54;
                                            phi_4747_ = _e5154;
                                            let _e5157 = local_55;
                                            phi_4748_ = _e5157;
                                        }
                                        let _e1414 = phi_4747_;
                                        let _e1416 = phi_4748_;
                                        if _e1414 {
                                            phi_4752_ = true;
                                        } else {
                                            phi_4752_ = _e1416;
                                        }
                                        let _e1418 = phi_4752_;
                                        if _e1418 {
                                            phi_4756_ = _e1119;
                                        } else {
                                            let _e5161 = local_56;
                                            phi_4756_ = _e5161;
                                        }
                                        let _e1420 = phi_4756_;
                                        phi_4757_ = _e1420;
                                    } else {
                                        phi_4757_ = _e1119;
                                    }
                                    let _e1422 = phi_4757_;
                                    phi_4759_ = type_74(_e1311, _e1422, _e1169);
                                } else {
                                    phi_4759_ = _e1179;
                                }
                                let _e1425 = phi_4759_;
                                if (_e1425.member > _e1425.member_1) {
                                    phi_7391_ = f64();
                                    phi_7392_ = true;
                                    phi_7393_ = false;
                                    phi_7394_ = false;
                                    phi_7395_ = false;
                                } else {
                                    let _e1433 = ((_e1425.member_1 - _e1425.member) * f64(0.5f));
                                    let _e1434 = (_e1425.member + _e1433);
                                    let _e1437 = (_e1433 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1439 = local_20.member_3;
                                    let _e1442 = local_20.member[0u];
                                    if (_e1442[0] < 0.0lf) {
                                        phi_4790_ = -(_e1442[0]);
                                    } else {
                                        phi_4790_ = _e1442[0];
                                    }
                                    let _e1449 = phi_4790_;
                                    if (_e1442[1] < 0.0lf) {
                                        phi_4797_ = -(_e1442[1]);
                                    } else {
                                        phi_4797_ = _e1442[1];
                                    }
                                    let _e1453 = phi_4797_;
                                    if (_e1449 > _e1453) {
                                        phi_4802_ = _e1449;
                                    } else {
                                        phi_4802_ = _e1453;
                                    }
                                    let _e1456 = phi_4802_;
                                    if (_e1442[2] < 0.0lf) {
                                        phi_4809_ = -(_e1442[2]);
                                    } else {
                                        phi_4809_ = _e1442[2];
                                    }
                                    let _e1460 = phi_4809_;
                                    if (_e1456 > _e1460) {
                                        phi_4814_ = _e1456;
                                    } else {
                                        phi_4814_ = _e1460;
                                    }
                                    let _e1463 = phi_4814_;
                                    let _e1465 = local_20.member[1u];
                                    if (_e1465[0] < 0.0lf) {
                                        phi_4827_ = -(_e1465[0]);
                                    } else {
                                        phi_4827_ = _e1465[0];
                                    }
                                    let _e1472 = phi_4827_;
                                    if (_e1465[1] < 0.0lf) {
                                        phi_4834_ = -(_e1465[1]);
                                    } else {
                                        phi_4834_ = _e1465[1];
                                    }
                                    let _e1476 = phi_4834_;
                                    if (_e1472 > _e1476) {
                                        phi_4839_ = _e1472;
                                    } else {
                                        phi_4839_ = _e1476;
                                    }
                                    let _e1479 = phi_4839_;
                                    if (_e1465[2] < 0.0lf) {
                                        phi_4846_ = -(_e1465[2]);
                                    } else {
                                        phi_4846_ = _e1465[2];
                                    }
                                    let _e1483 = phi_4846_;
                                    if (_e1479 > _e1483) {
                                        phi_4851_ = _e1479;
                                    } else {
                                        phi_4851_ = _e1483;
                                    }
                                    let _e1486 = phi_4851_;
                                    if (_e1463 > _e1486) {
                                        phi_4856_ = _e1463;
                                    } else {
                                        phi_4856_ = _e1486;
                                    }
                                    let _e1489 = phi_4856_;
                                    let _e1492 = local_20.member[0u];
                                    let _e1497 = local_20.member[1u];
                                    let _e1507 = (_e1492[0] + ((_e1497[0] - _e1492[0]) * _e1434));
                                    let _e1508 = (_e1492[1] + ((_e1497[1] - _e1492[1]) * _e1434));
                                    let _e1509 = (_e1492[2] + ((_e1497[2] - _e1492[2]) * _e1434));
                                    let _e1511 = local_20.member[1u];
                                    let _e1516 = local_20.member[0u];
                                    let _e1520 = (_e1511[0] - _e1516[0]);
                                    let _e1521 = (_e1511[1] - _e1516[1]);
                                    let _e1522 = (_e1511[2] - _e1516[2]);
                                    if (_e1520 < 0.0lf) {
                                        phi_4915_ = -(_e1520);
                                    } else {
                                        phi_4915_ = _e1520;
                                    }
                                    let _e1526 = phi_4915_;
                                    if (_e1521 < 0.0lf) {
                                        phi_4921_ = -(_e1521);
                                    } else {
                                        phi_4921_ = _e1521;
                                    }
                                    let _e1530 = phi_4921_;
                                    if (_e1526 > _e1530) {
                                        phi_4926_ = _e1526;
                                    } else {
                                        phi_4926_ = _e1530;
                                    }
                                    let _e1533 = phi_4926_;
                                    if (_e1522 < 0.0lf) {
                                        phi_4932_ = -(_e1522);
                                    } else {
                                        phi_4932_ = _e1522;
                                    }
                                    let _e1537 = phi_4932_;
                                    if (_e1533 > _e1537) {
                                        phi_4937_ = _e1533;
                                    } else {
                                        phi_4937_ = _e1537;
                                    }
                                    let _e1540 = phi_4937_;
                                    let _e1548 = ((((_e1437 * _e1540) * f64(1.01f)) + ((_e1489 + _e1439) * (1.1102230246251565e-16lf * f64(8f)))) + _e1439);
                                    if (_e1507 < 0.0lf) {
                                        phi_4951_ = -(_e1507);
                                    } else {
                                        phi_4951_ = _e1507;
                                    }
                                    let _e1552 = phi_4951_;
                                    if (_e1508 < 0.0lf) {
                                        phi_4957_ = -(_e1508);
                                    } else {
                                        phi_4957_ = _e1508;
                                    }
                                    let _e1556 = phi_4957_;
                                    if (_e1552 > _e1556) {
                                        phi_4962_ = _e1552;
                                    } else {
                                        phi_4962_ = _e1556;
                                    }
                                    let _e1559 = phi_4962_;
                                    if (_e1509 < 0.0lf) {
                                        phi_4968_ = -(_e1509);
                                    } else {
                                        phi_4968_ = _e1509;
                                    }
                                    let _e1563 = phi_4968_;
                                    if (_e1559 > _e1563) {
                                        phi_4973_ = _e1559;
                                    } else {
                                        phi_4973_ = _e1563;
                                    }
                                    let _e1566 = phi_4973_;
                                    local_3 = type_52(array<f64, 3>(_e1507, _e1508, _e1509), _e1548, (_e1566 + _e1548));
                                    let _e1572 = local_20.member_3;
                                    let _e1574 = local_20.member_1[0u];
                                    if (_e1574[0] < 0.0lf) {
                                        phi_4999_ = -(_e1574[0]);
                                    } else {
                                        phi_4999_ = _e1574[0];
                                    }
                                    let _e1581 = phi_4999_;
                                    if (_e1574[1] < 0.0lf) {
                                        phi_5006_ = -(_e1574[1]);
                                    } else {
                                        phi_5006_ = _e1574[1];
                                    }
                                    let _e1585 = phi_5006_;
                                    if (_e1581 > _e1585) {
                                        phi_5011_ = _e1581;
                                    } else {
                                        phi_5011_ = _e1585;
                                    }
                                    let _e1588 = phi_5011_;
                                    if (_e1574[2] < 0.0lf) {
                                        phi_5018_ = -(_e1574[2]);
                                    } else {
                                        phi_5018_ = _e1574[2];
                                    }
                                    let _e1592 = phi_5018_;
                                    if (_e1588 > _e1592) {
                                        phi_5023_ = _e1588;
                                    } else {
                                        phi_5023_ = _e1592;
                                    }
                                    let _e1595 = phi_5023_;
                                    let _e1597 = local_20.member_1[1u];
                                    if (_e1597[0] < 0.0lf) {
                                        phi_5036_ = -(_e1597[0]);
                                    } else {
                                        phi_5036_ = _e1597[0];
                                    }
                                    let _e1604 = phi_5036_;
                                    if (_e1597[1] < 0.0lf) {
                                        phi_5043_ = -(_e1597[1]);
                                    } else {
                                        phi_5043_ = _e1597[1];
                                    }
                                    let _e1608 = phi_5043_;
                                    if (_e1604 > _e1608) {
                                        phi_5048_ = _e1604;
                                    } else {
                                        phi_5048_ = _e1608;
                                    }
                                    let _e1611 = phi_5048_;
                                    if (_e1597[2] < 0.0lf) {
                                        phi_5055_ = -(_e1597[2]);
                                    } else {
                                        phi_5055_ = _e1597[2];
                                    }
                                    let _e1615 = phi_5055_;
                                    if (_e1611 > _e1615) {
                                        phi_5060_ = _e1611;
                                    } else {
                                        phi_5060_ = _e1615;
                                    }
                                    let _e1618 = phi_5060_;
                                    if (_e1595 > _e1618) {
                                        phi_5065_ = _e1595;
                                    } else {
                                        phi_5065_ = _e1618;
                                    }
                                    let _e1621 = phi_5065_;
                                    let _e1624 = local_20.member_1[0u];
                                    let _e1629 = local_20.member_1[1u];
                                    let _e1639 = (_e1624[0] + ((_e1629[0] - _e1624[0]) * _e1434));
                                    let _e1640 = (_e1624[1] + ((_e1629[1] - _e1624[1]) * _e1434));
                                    let _e1641 = (_e1624[2] + ((_e1629[2] - _e1624[2]) * _e1434));
                                    let _e1643 = local_20.member_1[1u];
                                    let _e1648 = local_20.member_1[0u];
                                    let _e1652 = (_e1643[0] - _e1648[0]);
                                    let _e1653 = (_e1643[1] - _e1648[1]);
                                    let _e1654 = (_e1643[2] - _e1648[2]);
                                    if (_e1652 < 0.0lf) {
                                        phi_5124_ = -(_e1652);
                                    } else {
                                        phi_5124_ = _e1652;
                                    }
                                    let _e1658 = phi_5124_;
                                    if (_e1653 < 0.0lf) {
                                        phi_5130_ = -(_e1653);
                                    } else {
                                        phi_5130_ = _e1653;
                                    }
                                    let _e1662 = phi_5130_;
                                    if (_e1658 > _e1662) {
                                        phi_5135_ = _e1658;
                                    } else {
                                        phi_5135_ = _e1662;
                                    }
                                    let _e1665 = phi_5135_;
                                    if (_e1654 < 0.0lf) {
                                        phi_5141_ = -(_e1654);
                                    } else {
                                        phi_5141_ = _e1654;
                                    }
                                    let _e1669 = phi_5141_;
                                    if (_e1665 > _e1669) {
                                        phi_5146_ = _e1665;
                                    } else {
                                        phi_5146_ = _e1669;
                                    }
                                    let _e1672 = phi_5146_;
                                    let _e1680 = ((((_e1437 * _e1672) * f64(1.01f)) + ((_e1621 + _e1572) * (1.1102230246251565e-16lf * f64(8f)))) + _e1572);
                                    if (_e1639 < 0.0lf) {
                                        phi_5160_ = -(_e1639);
                                    } else {
                                        phi_5160_ = _e1639;
                                    }
                                    let _e1684 = phi_5160_;
                                    if (_e1640 < 0.0lf) {
                                        phi_5166_ = -(_e1640);
                                    } else {
                                        phi_5166_ = _e1640;
                                    }
                                    let _e1688 = phi_5166_;
                                    if (_e1684 > _e1688) {
                                        phi_5171_ = _e1684;
                                    } else {
                                        phi_5171_ = _e1688;
                                    }
                                    let _e1691 = phi_5171_;
                                    if (_e1641 < 0.0lf) {
                                        phi_5177_ = -(_e1641);
                                    } else {
                                        phi_5177_ = _e1641;
                                    }
                                    let _e1695 = phi_5177_;
                                    if (_e1691 > _e1695) {
                                        phi_5182_ = _e1691;
                                    } else {
                                        phi_5182_ = _e1695;
                                    }
                                    let _e1698 = phi_5182_;
                                    local_4 = type_52(array<f64, 3>(_e1639, _e1640, _e1641), _e1680, (_e1698 + _e1680));
                                    let _e1704 = local_20.member_3;
                                    let _e1706 = local_20.member_2[0u];
                                    if (_e1706[0] < 0.0lf) {
                                        phi_5208_ = -(_e1706[0]);
                                    } else {
                                        phi_5208_ = _e1706[0];
                                    }
                                    let _e1713 = phi_5208_;
                                    if (_e1706[1] < 0.0lf) {
                                        phi_5215_ = -(_e1706[1]);
                                    } else {
                                        phi_5215_ = _e1706[1];
                                    }
                                    let _e1717 = phi_5215_;
                                    if (_e1713 > _e1717) {
                                        phi_5220_ = _e1713;
                                    } else {
                                        phi_5220_ = _e1717;
                                    }
                                    let _e1720 = phi_5220_;
                                    if (_e1706[2] < 0.0lf) {
                                        phi_5227_ = -(_e1706[2]);
                                    } else {
                                        phi_5227_ = _e1706[2];
                                    }
                                    let _e1724 = phi_5227_;
                                    if (_e1720 > _e1724) {
                                        phi_5232_ = _e1720;
                                    } else {
                                        phi_5232_ = _e1724;
                                    }
                                    let _e1727 = phi_5232_;
                                    let _e1729 = local_20.member_2[1u];
                                    if (_e1729[0] < 0.0lf) {
                                        phi_5245_ = -(_e1729[0]);
                                    } else {
                                        phi_5245_ = _e1729[0];
                                    }
                                    let _e1736 = phi_5245_;
                                    if (_e1729[1] < 0.0lf) {
                                        phi_5252_ = -(_e1729[1]);
                                    } else {
                                        phi_5252_ = _e1729[1];
                                    }
                                    let _e1740 = phi_5252_;
                                    if (_e1736 > _e1740) {
                                        phi_5257_ = _e1736;
                                    } else {
                                        phi_5257_ = _e1740;
                                    }
                                    let _e1743 = phi_5257_;
                                    if (_e1729[2] < 0.0lf) {
                                        phi_5264_ = -(_e1729[2]);
                                    } else {
                                        phi_5264_ = _e1729[2];
                                    }
                                    let _e1747 = phi_5264_;
                                    if (_e1743 > _e1747) {
                                        phi_5269_ = _e1743;
                                    } else {
                                        phi_5269_ = _e1747;
                                    }
                                    let _e1750 = phi_5269_;
                                    if (_e1727 > _e1750) {
                                        phi_5274_ = _e1727;
                                    } else {
                                        phi_5274_ = _e1750;
                                    }
                                    let _e1753 = phi_5274_;
                                    let _e1756 = local_20.member_2[0u];
                                    let _e1761 = local_20.member_2[1u];
                                    let _e1771 = (_e1756[0] + ((_e1761[0] - _e1756[0]) * _e1434));
                                    let _e1772 = (_e1756[1] + ((_e1761[1] - _e1756[1]) * _e1434));
                                    let _e1773 = (_e1756[2] + ((_e1761[2] - _e1756[2]) * _e1434));
                                    let _e1775 = local_20.member_2[1u];
                                    let _e1780 = local_20.member_2[0u];
                                    let _e1784 = (_e1775[0] - _e1780[0]);
                                    let _e1785 = (_e1775[1] - _e1780[1]);
                                    let _e1786 = (_e1775[2] - _e1780[2]);
                                    if (_e1784 < 0.0lf) {
                                        phi_5333_ = -(_e1784);
                                    } else {
                                        phi_5333_ = _e1784;
                                    }
                                    let _e1790 = phi_5333_;
                                    if (_e1785 < 0.0lf) {
                                        phi_5339_ = -(_e1785);
                                    } else {
                                        phi_5339_ = _e1785;
                                    }
                                    let _e1794 = phi_5339_;
                                    if (_e1790 > _e1794) {
                                        phi_5344_ = _e1790;
                                    } else {
                                        phi_5344_ = _e1794;
                                    }
                                    let _e1797 = phi_5344_;
                                    if (_e1786 < 0.0lf) {
                                        phi_5350_ = -(_e1786);
                                    } else {
                                        phi_5350_ = _e1786;
                                    }
                                    let _e1801 = phi_5350_;
                                    if (_e1797 > _e1801) {
                                        phi_5355_ = _e1797;
                                    } else {
                                        phi_5355_ = _e1801;
                                    }
                                    let _e1804 = phi_5355_;
                                    let _e1812 = ((((_e1437 * _e1804) * f64(1.01f)) + ((_e1753 + _e1704) * (1.1102230246251565e-16lf * f64(8f)))) + _e1704);
                                    if (_e1771 < 0.0lf) {
                                        phi_5369_ = -(_e1771);
                                    } else {
                                        phi_5369_ = _e1771;
                                    }
                                    let _e1816 = phi_5369_;
                                    if (_e1772 < 0.0lf) {
                                        phi_5375_ = -(_e1772);
                                    } else {
                                        phi_5375_ = _e1772;
                                    }
                                    let _e1820 = phi_5375_;
                                    if (_e1816 > _e1820) {
                                        phi_5380_ = _e1816;
                                    } else {
                                        phi_5380_ = _e1820;
                                    }
                                    let _e1823 = phi_5380_;
                                    if (_e1773 < 0.0lf) {
                                        phi_5386_ = -(_e1773);
                                    } else {
                                        phi_5386_ = _e1773;
                                    }
                                    let _e1827 = phi_5386_;
                                    if (_e1823 > _e1827) {
                                        phi_5391_ = _e1823;
                                    } else {
                                        phi_5391_ = _e1827;
                                    }
                                    let _e1830 = phi_5391_;
                                    local_5 = type_52(array<f64, 3>(_e1771, _e1772, _e1773), _e1812, (_e1830 + _e1812));
                                    let _e1835 = local_4.member;
                                    let _e1840 = local_5.member;
                                    let _e1846 = ((_e1835[1] * _e1840[2]) - (_e1835[2] * _e1840[1]));
                                    let _e1849 = ((_e1835[2] * _e1840[0]) - (_e1835[0] * _e1840[2]));
                                    let _e1852 = ((_e1835[0] * _e1840[1]) - (_e1835[1] * _e1840[0]));
                                    if (_e1846 < 0.0lf) {
                                        phi_5440_ = -(_e1846);
                                    } else {
                                        phi_5440_ = _e1846;
                                    }
                                    let _e1856 = phi_5440_;
                                    if (_e1849 < 0.0lf) {
                                        phi_5446_ = -(_e1849);
                                    } else {
                                        phi_5446_ = _e1849;
                                    }
                                    let _e1860 = phi_5446_;
                                    if (_e1856 > _e1860) {
                                        if (_e1846 < 0.0lf) {
                                            phi_5456_ = -(_e1846);
                                        } else {
                                            phi_5456_ = _e1846;
                                        }
                                        let _e1878 = phi_5456_;
                                        if (_e1852 < 0.0lf) {
                                            phi_5462_ = -(_e1852);
                                        } else {
                                            phi_5462_ = _e1852;
                                        }
                                        let _e1882 = phi_5462_;
                                        if (_e1878 > _e1882) {
                                            phi_5467_ = 2u;
                                            phi_5468_ = 1u;
                                        } else {
                                            phi_5467_ = 1u;
                                            phi_5468_ = 0u;
                                        }
                                        let _e1885 = phi_5467_;
                                        let _e1887 = phi_5468_;
                                        phi_5487_ = _e1885;
                                        phi_5488_ = _e1887;
                                    } else {
                                        if (_e1849 < 0.0lf) {
                                            phi_5474_ = -(_e1849);
                                        } else {
                                            phi_5474_ = _e1849;
                                        }
                                        let _e1865 = phi_5474_;
                                        if (_e1852 < 0.0lf) {
                                            phi_5480_ = -(_e1852);
                                        } else {
                                            phi_5480_ = _e1852;
                                        }
                                        let _e1869 = phi_5480_;
                                        if (_e1865 > _e1869) {
                                            phi_5485_ = 0u;
                                            phi_5486_ = 2u;
                                        } else {
                                            phi_5485_ = 1u;
                                            phi_5486_ = 0u;
                                        }
                                        let _e1872 = phi_5485_;
                                        let _e1874 = phi_5486_;
                                        phi_5487_ = _e1872;
                                        phi_5488_ = _e1874;
                                    }
                                    let _e1889 = phi_5487_;
                                    let _e1891 = phi_5488_;
                                    if (_e1891 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1895 = local_4.member[_e1891];
                                    if (_e1889 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1899 = local_5.member[_e1889];
                                    if (_e1889 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1904 = local_4.member[_e1889];
                                    if (_e1891 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1908 = local_5.member[_e1891];
                                    let _e1910 = ((_e1895 * _e1899) - (_e1904 * _e1908));
                                    let _e1911 = f64(1f);
                                    let _e1913 = local_4.member_1;
                                    let _e1915 = local_5.member_2;
                                    let _e1918 = local_4.member_2;
                                    let _e1920 = local_5.member_1;
                                    let _e1926 = local_4.member_2;
                                    let _e1928 = local_5.member_2;
                                    let _e1937 = local_4.member_2;
                                    let _e1940 = local_5.member_2;
                                    let _e1944 = (((((_e1913 * _e1915) + (_e1918 * _e1920)) * f64(2.01f)) + ((_e1926 * _e1928) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1911 + _e1937) * (_e1911 + _e1940))));
                                    if (_e1910 < 0.0lf) {
                                        phi_5559_ = -(_e1910);
                                    } else {
                                        phi_5559_ = _e1910;
                                    }
                                    let _e1948 = phi_5559_;
                                    if (_e1948 > _e1944) {
                                        if (_e1910 < f64(0f)) {
                                            phi_5571_ = f64(-1f);
                                        } else {
                                            phi_5571_ = f64(1f);
                                        }
                                        let _e1955 = phi_5571_;
                                        if (_e1891 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1959 = local_3.member[_e1891];
                                        if (_e1889 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1963 = local_5.member[_e1889];
                                        if (_e1889 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1968 = local_3.member[_e1889];
                                        if (_e1891 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1972 = local_5.member[_e1891];
                                        let _e1975 = f64(1f);
                                        let _e1977 = local_3.member_1;
                                        let _e1979 = local_5.member_2;
                                        let _e1982 = local_3.member_2;
                                        let _e1984 = local_5.member_1;
                                        let _e1990 = local_3.member_2;
                                        let _e1992 = local_5.member_2;
                                        let _e2001 = local_3.member_2;
                                        let _e2004 = local_5.member_2;
                                        let _e2008 = (((((_e1977 * _e1979) + (_e1982 * _e1984)) * f64(2.01f)) + ((_e1990 * _e1992) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1975 + _e2001) * (_e1975 + _e2004))));
                                        if (_e1891 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2012 = local_4.member[_e1891];
                                        if (_e1889 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2016 = local_3.member[_e1889];
                                        if (_e1889 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2021 = local_4.member[_e1889];
                                        if (_e1891 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2025 = local_3.member[_e1891];
                                        let _e2028 = f64(1f);
                                        let _e2030 = local_4.member_1;
                                        let _e2032 = local_3.member_2;
                                        let _e2035 = local_4.member_2;
                                        let _e2037 = local_3.member_1;
                                        let _e2043 = local_4.member_2;
                                        let _e2045 = local_3.member_2;
                                        let _e2054 = local_4.member_2;
                                        let _e2057 = local_3.member_2;
                                        let _e2061 = (((((_e2030 * _e2032) + (_e2035 * _e2037)) * f64(2.01f)) + ((_e2043 * _e2045) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2028 + _e2054) * (_e2028 + _e2057))));
                                        let _e2062 = (_e1910 * _e1955);
                                        let _e2063 = (((_e1959 * _e1963) - (_e1968 * _e1972)) * _e1955);
                                        let _e2064 = (((_e2012 * _e2016) - (_e2021 * _e2025)) * _e1955);
                                        if (_e2062 < 0.0lf) {
                                            phi_5710_ = -(_e2062);
                                        } else {
                                            phi_5710_ = _e2062;
                                        }
                                        let _e2068 = phi_5710_;
                                        if (_e2063 < 0.0lf) {
                                            phi_5716_ = -(_e2063);
                                        } else {
                                            phi_5716_ = _e2063;
                                        }
                                        let _e2072 = phi_5716_;
                                        if (_e2064 < 0.0lf) {
                                            phi_5723_ = -(_e2064);
                                        } else {
                                            phi_5723_ = _e2064;
                                        }
                                        let _e2077 = phi_5723_;
                                        let _e2083 = ((_e2062 - _e2063) - _e2064);
                                        let _e2086 = (((_e1944 + _e2008) + _e2061) + (((_e2068 + _e2072) + _e2077) * (1.1102230246251565e-16lf * f64(4f))));
                                        local_6[0u].member = _e2063;
                                        local_6[0u].member_1 = _e2008;
                                        local_6[1u].member = _e2064;
                                        local_6[1u].member_1 = _e2061;
                                        local_6[2u].member = _e2083;
                                        local_6[2u].member_1 = _e2086;
                                        local_6[3u].member = _e2083;
                                        local_6[3u].member_1 = _e2086;
                                        phi_5767_ = type_29(0u, 4u);
                                        phi_5770_ = true;
                                        loop {
                                            let _e2101 = phi_5767_;
                                            let _e2103 = phi_5770_;
                                            local_25 = _e2103;
                                            if (_e2101.member < _e2101.member_1) {
                                                phi_5768_ = type_29((_e2101.member + 1u), _e2101.member_1);
                                                phi_5793_ = type_29(1u, _e2101.member);
                                            } else {
                                                phi_5768_ = _e2101;
                                                phi_5793_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e2117 = phi_5768_;
                                            let _e2119 = phi_5793_;
                                            if (bitcast<i32>(_e2119.member) != 0i) {
                                                if (_e2119.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e2127 = local_6[_e2119.member_1].member;
                                                let _e2130 = local_6[_e2119.member_1].member_1;
                                                let _e2132 = (_e2127 < -(_e2130));
                                                if _e2132 {
                                                    phi_5820_ = bool();
                                                    phi_5821_ = false;
                                                } else {
                                                    phi_5820_ = (_e2103 && (_e2127 > _e2130));
                                                    phi_5821_ = true;
                                                }
                                                let _e2136 = phi_5820_;
                                                let _e2138 = phi_5821_;
                                                phi_5771_ = _e2136;
                                                phi_5822_ = _e2138;
                                                phi_5823_ = _e2132;
                                            } else {
                                                phi_5771_ = bool();
                                                phi_5822_ = false;
                                                phi_5823_ = false;
                                            }
                                            let _e2140 = phi_5771_;
                                            let _e2142 = phi_5822_;
                                            let _e2144 = phi_5823_;
                                            local_24 = _e2144;
                                            continue;
                                            continuing {
                                                phi_5767_ = _e2117;
                                                phi_5770_ = _e2140;
                                                break if !(_e2142);
                                            }
                                        }
                                        let _e2147 = local_24;
                                        if _e2147 {
                                            phi_5827_ = false;
                                        } else {
                                            phi_5827_ = true;
                                        }
                                        let _e2149 = phi_5827_;
                                        if _e2149 {
                                            let _e2151 = local_25;
                                            if _e2151 {
                                                phi_5834_ = 1u;
                                            } else {
                                                phi_5834_ = 2u;
                                            }
                                            let _e2153 = phi_5834_;
                                            phi_5835_ = _e2153;
                                            phi_5836_ = false;
                                        } else {
                                            phi_5835_ = u32();
                                            phi_5836_ = true;
                                        }
                                        let _e2155 = phi_5835_;
                                        let _e2157 = phi_5836_;
                                        phi_5837_ = _e2155;
                                        phi_5838_ = 0u;
                                        phi_5839_ = _e2157;
                                    } else {
                                        phi_5837_ = u32();
                                        phi_5838_ = 2u;
                                        phi_5839_ = true;
                                    }
                                    let _e2159 = phi_5837_;
                                    let _e2161 = phi_5838_;
                                    let _e2163 = phi_5839_;
                                    if _e2163 {
                                        phi_5843_ = _e2161;
                                    } else {
                                        phi_5843_ = _e2159;
                                    }
                                    let _e2165 = phi_5843_;
                                    let _e2166 = (_e2165 == 0u);
                                    if _e2166 {
                                        phi_7387_ = f64();
                                        phi_7388_ = false;
                                        phi_7389_ = false;
                                        phi_7390_ = false;
                                    } else {
                                        if (_e2165 == 1u) {
                                            if _e1425.member_2 {
                                                if ((_e1425.member_1 - _e1425.member) <= f64(0.0000005f)) {
                                                    phi_5864_ = false;
                                                } else {
                                                    phi_5864_ = true;
                                                }
                                                let _e2175 = phi_5864_;
                                                phi_5865_ = _e2175;
                                            } else {
                                                phi_5865_ = true;
                                            }
                                            let _e2177 = phi_5865_;
                                            phi_5866_ = _e2177;
                                        } else {
                                            phi_5866_ = true;
                                        }
                                        let _e2179 = phi_5866_;
                                        if _e2179 {
                                            let _e2185 = local_20.member[0u];
                                            let _e2191 = local_20.member_1[0u];
                                            let _e2197 = local_20.member_2[0u];
                                            local_1 = array<array<f64, 3>, 4>(_e2185, array<f64, 3>((_e2185[0] - _e2191[0]), (_e2185[1] - _e2191[1]), (_e2185[2] - _e2191[2])), array<f64, 3>((_e2185[0] - _e2197[0]), (_e2185[1] - _e2197[1]), (_e2185[2] - _e2197[2])), _e2185);
                                            let _e2212 = local_20.member[1u];
                                            let _e2218 = local_20.member_1[1u];
                                            let _e2224 = local_20.member_2[1u];
                                            local_2 = array<array<f64, 3>, 4>(_e2212, array<f64, 3>((_e2212[0] - _e2218[0]), (_e2212[1] - _e2218[1]), (_e2212[2] - _e2218[2])), array<f64, 3>((_e2212[0] - _e2224[0]), (_e2212[1] - _e2224[1]), (_e2212[2] - _e2224[2])), _e2212);
                                            let _e2239 = local_20.member[0u];
                                            if (_e2239[0] < 0.0lf) {
                                                phi_6063_ = -(_e2239[0]);
                                            } else {
                                                phi_6063_ = _e2239[0];
                                            }
                                            let _e2246 = phi_6063_;
                                            if (_e2239[1] < 0.0lf) {
                                                phi_6070_ = -(_e2239[1]);
                                            } else {
                                                phi_6070_ = _e2239[1];
                                            }
                                            let _e2250 = phi_6070_;
                                            if (_e2246 > _e2250) {
                                                phi_6075_ = _e2246;
                                            } else {
                                                phi_6075_ = _e2250;
                                            }
                                            let _e2253 = phi_6075_;
                                            if (_e2239[2] < 0.0lf) {
                                                phi_6082_ = -(_e2239[2]);
                                            } else {
                                                phi_6082_ = _e2239[2];
                                            }
                                            let _e2257 = phi_6082_;
                                            if (_e2253 > _e2257) {
                                                phi_6087_ = _e2253;
                                            } else {
                                                phi_6087_ = _e2257;
                                            }
                                            let _e2260 = phi_6087_;
                                            let _e2263 = local_20.member[1u];
                                            if (_e2263[0] < 0.0lf) {
                                                phi_6100_ = -(_e2263[0]);
                                            } else {
                                                phi_6100_ = _e2263[0];
                                            }
                                            let _e2270 = phi_6100_;
                                            if (_e2263[1] < 0.0lf) {
                                                phi_6107_ = -(_e2263[1]);
                                            } else {
                                                phi_6107_ = _e2263[1];
                                            }
                                            let _e2274 = phi_6107_;
                                            if (_e2270 > _e2274) {
                                                phi_6112_ = _e2270;
                                            } else {
                                                phi_6112_ = _e2274;
                                            }
                                            let _e2277 = phi_6112_;
                                            if (_e2263[2] < 0.0lf) {
                                                phi_6119_ = -(_e2263[2]);
                                            } else {
                                                phi_6119_ = _e2263[2];
                                            }
                                            let _e2281 = phi_6119_;
                                            if (_e2277 > _e2281) {
                                                phi_6124_ = _e2277;
                                            } else {
                                                phi_6124_ = _e2281;
                                            }
                                            let _e2284 = phi_6124_;
                                            if (_e2260 > _e2284) {
                                                phi_6129_ = _e2260;
                                            } else {
                                                phi_6129_ = _e2284;
                                            }
                                            let _e2287 = phi_6129_;
                                            let _e2289 = local_20.member_3;
                                            let _e2293 = local_20.member_1[0u];
                                            if (_e2293[0] < 0.0lf) {
                                                phi_6146_ = -(_e2293[0]);
                                            } else {
                                                phi_6146_ = _e2293[0];
                                            }
                                            let _e2300 = phi_6146_;
                                            if (_e2293[1] < 0.0lf) {
                                                phi_6153_ = -(_e2293[1]);
                                            } else {
                                                phi_6153_ = _e2293[1];
                                            }
                                            let _e2304 = phi_6153_;
                                            if (_e2300 > _e2304) {
                                                phi_6158_ = _e2300;
                                            } else {
                                                phi_6158_ = _e2304;
                                            }
                                            let _e2307 = phi_6158_;
                                            if (_e2293[2] < 0.0lf) {
                                                phi_6165_ = -(_e2293[2]);
                                            } else {
                                                phi_6165_ = _e2293[2];
                                            }
                                            let _e2311 = phi_6165_;
                                            if (_e2307 > _e2311) {
                                                phi_6170_ = _e2307;
                                            } else {
                                                phi_6170_ = _e2311;
                                            }
                                            let _e2314 = phi_6170_;
                                            let _e2317 = local_20.member_1[1u];
                                            if (_e2317[0] < 0.0lf) {
                                                phi_6184_ = -(_e2317[0]);
                                            } else {
                                                phi_6184_ = _e2317[0];
                                            }
                                            let _e2324 = phi_6184_;
                                            if (_e2317[1] < 0.0lf) {
                                                phi_6191_ = -(_e2317[1]);
                                            } else {
                                                phi_6191_ = _e2317[1];
                                            }
                                            let _e2328 = phi_6191_;
                                            if (_e2324 > _e2328) {
                                                phi_6196_ = _e2324;
                                            } else {
                                                phi_6196_ = _e2328;
                                            }
                                            let _e2331 = phi_6196_;
                                            if (_e2317[2] < 0.0lf) {
                                                phi_6203_ = -(_e2317[2]);
                                            } else {
                                                phi_6203_ = _e2317[2];
                                            }
                                            let _e2335 = phi_6203_;
                                            if (_e2331 > _e2335) {
                                                phi_6208_ = _e2331;
                                            } else {
                                                phi_6208_ = _e2335;
                                            }
                                            let _e2338 = phi_6208_;
                                            if (_e2314 > _e2338) {
                                                phi_6213_ = _e2314;
                                            } else {
                                                phi_6213_ = _e2338;
                                            }
                                            let _e2341 = phi_6213_;
                                            let _e2343 = local_20.member_3;
                                            let _e2347 = local_20.member_2[0u];
                                            if (_e2347[0] < 0.0lf) {
                                                phi_6230_ = -(_e2347[0]);
                                            } else {
                                                phi_6230_ = _e2347[0];
                                            }
                                            let _e2354 = phi_6230_;
                                            if (_e2347[1] < 0.0lf) {
                                                phi_6237_ = -(_e2347[1]);
                                            } else {
                                                phi_6237_ = _e2347[1];
                                            }
                                            let _e2358 = phi_6237_;
                                            if (_e2354 > _e2358) {
                                                phi_6242_ = _e2354;
                                            } else {
                                                phi_6242_ = _e2358;
                                            }
                                            let _e2361 = phi_6242_;
                                            if (_e2347[2] < 0.0lf) {
                                                phi_6249_ = -(_e2347[2]);
                                            } else {
                                                phi_6249_ = _e2347[2];
                                            }
                                            let _e2365 = phi_6249_;
                                            if (_e2361 > _e2365) {
                                                phi_6254_ = _e2361;
                                            } else {
                                                phi_6254_ = _e2365;
                                            }
                                            let _e2368 = phi_6254_;
                                            let _e2371 = local_20.member_2[1u];
                                            if (_e2371[0] < 0.0lf) {
                                                phi_6268_ = -(_e2371[0]);
                                            } else {
                                                phi_6268_ = _e2371[0];
                                            }
                                            let _e2378 = phi_6268_;
                                            if (_e2371[1] < 0.0lf) {
                                                phi_6275_ = -(_e2371[1]);
                                            } else {
                                                phi_6275_ = _e2371[1];
                                            }
                                            let _e2382 = phi_6275_;
                                            if (_e2378 > _e2382) {
                                                phi_6280_ = _e2378;
                                            } else {
                                                phi_6280_ = _e2382;
                                            }
                                            let _e2385 = phi_6280_;
                                            if (_e2371[2] < 0.0lf) {
                                                phi_6287_ = -(_e2371[2]);
                                            } else {
                                                phi_6287_ = _e2371[2];
                                            }
                                            let _e2389 = phi_6287_;
                                            if (_e2385 > _e2389) {
                                                phi_6292_ = _e2385;
                                            } else {
                                                phi_6292_ = _e2389;
                                            }
                                            let _e2392 = phi_6292_;
                                            if (_e2368 > _e2392) {
                                                phi_6297_ = _e2368;
                                            } else {
                                                phi_6297_ = _e2392;
                                            }
                                            let _e2395 = phi_6297_;
                                            let _e2397 = local_20.member_3;
                                            let _e2405 = local_20.member_3;
                                            phi_6317_ = type_29(0u, 48u);
                                            phi_6320_ = _e1425.member;
                                            loop {
                                                let _e2414 = phi_6317_;
                                                let _e2416 = phi_6320_;
                                                local_70 = _e2416;
                                                local_32 = _e2416;
                                                local_33 = _e2416;
                                                local_34 = _e2416;
                                                local_35 = _e2416;
                                                if (_e2414.member < _e2414.member_1) {
                                                    phi_6318_ = type_29((_e2414.member + 1u), _e2414.member_1);
                                                    phi_6343_ = type_29(1u, _e2414.member);
                                                } else {
                                                    phi_6318_ = _e2414;
                                                    phi_6343_ = type_29(0u, type_29().member_1);
                                                }
                                                let _e2430 = phi_6318_;
                                                let _e2432 = phi_6343_;
                                                if (bitcast<i32>(_e2432.member) != 0i) {
                                                    let _e2438 = local_20.member[0u];
                                                    let _e2444 = local_20.member[1u];
                                                    let _e2454 = (_e2438[0] + ((_e2444[0] - _e2438[0]) * _e2416));
                                                    let _e2455 = (_e2438[1] + ((_e2444[1] - _e2438[1]) * _e2416));
                                                    let _e2456 = (_e2438[2] + ((_e2444[2] - _e2438[2]) * _e2416));
                                                    let _e2459 = local_20.member_1[0u];
                                                    let _e2465 = local_20.member_1[1u];
                                                    let _e2475 = (_e2459[0] + ((_e2465[0] - _e2459[0]) * _e2416));
                                                    let _e2476 = (_e2459[1] + ((_e2465[1] - _e2459[1]) * _e2416));
                                                    let _e2477 = (_e2459[2] + ((_e2465[2] - _e2459[2]) * _e2416));
                                                    let _e2480 = local_20.member_2[0u];
                                                    let _e2486 = local_20.member_2[1u];
                                                    let _e2496 = (_e2480[0] + ((_e2486[0] - _e2480[0]) * _e2416));
                                                    let _e2497 = (_e2480[1] + ((_e2486[1] - _e2480[1]) * _e2416));
                                                    let _e2498 = (_e2480[2] + ((_e2486[2] - _e2480[2]) * _e2416));
                                                    let _e2503 = (((_e2475 * _e2475) + (_e2476 * _e2476)) + (_e2477 * _e2477));
                                                    let _e2508 = (((_e2475 * _e2496) + (_e2476 * _e2497)) + (_e2477 * _e2498));
                                                    let _e2513 = (((_e2496 * _e2496) + (_e2497 * _e2497)) + (_e2498 * _e2498));
                                                    let _e2518 = (((_e2454 * _e2475) + (_e2455 * _e2476)) + (_e2456 * _e2477));
                                                    let _e2523 = (((_e2454 * _e2496) + (_e2455 * _e2497)) + (_e2456 * _e2498));
                                                    let _e2526 = ((_e2503 * _e2513) - (_e2508 * _e2508));
                                                    let _e2527 = f64(0f);
                                                    let _e2532 = (((_e2518 * _e2513) - (_e2523 * _e2508)) / _e2526);
                                                    let _e2536 = (((_e2523 * _e2503) - (_e2518 * _e2508)) / _e2526);
                                                    if (_e2532 >= _e2527) {
                                                        if (_e2536 >= _e2527) {
                                                            phi_6519_ = ((_e2532 + _e2536) <= f64(1f));
                                                            phi_6520_ = false;
                                                        } else {
                                                            phi_6519_ = bool();
                                                            phi_6520_ = true;
                                                        }
                                                        let _e2542 = phi_6519_;
                                                        let _e2544 = phi_6520_;
                                                        phi_6521_ = _e2542;
                                                        phi_6522_ = _e2544;
                                                    } else {
                                                        phi_6521_ = bool();
                                                        phi_6522_ = true;
                                                    }
                                                    let _e2546 = phi_6521_;
                                                    let _e2548 = phi_6522_;
                                                    if _e2548 {
                                                        phi_6526_ = false;
                                                    } else {
                                                        phi_6526_ = _e2546;
                                                    }
                                                    let _e2550 = phi_6526_;
                                                    if (_e2526 > _e2527) {
                                                        if _e2550 {
                                                            phi_6548_ = array<f64, 3>((_e2454 - ((_e2475 * _e2532) + (_e2496 * _e2536))), (_e2455 - ((_e2476 * _e2532) + (_e2497 * _e2536))), (_e2456 - ((_e2477 * _e2532) + (_e2498 * _e2536))));
                                                            phi_6549_ = false;
                                                        } else {
                                                            phi_6548_ = array<f64, 3>();
                                                            phi_6549_ = true;
                                                        }
                                                        let _e2566 = phi_6548_;
                                                        let _e2568 = phi_6549_;
                                                        phi_6550_ = _e2566;
                                                        phi_6551_ = _e2568;
                                                    } else {
                                                        phi_6550_ = array<f64, 3>();
                                                        phi_6551_ = true;
                                                    }
                                                    let _e2570 = phi_6550_;
                                                    let _e2572 = phi_6551_;
                                                    if _e2572 {
                                                        let _e2573 = (_e2454 - _e2475);
                                                        let _e2574 = (_e2455 - _e2476);
                                                        let _e2575 = (_e2456 - _e2477);
                                                        let _e2576 = (_e2496 - _e2475);
                                                        let _e2577 = (_e2497 - _e2476);
                                                        let _e2578 = (_e2498 - _e2477);
                                                        let _e2589 = ((((_e2573 * _e2576) + (_e2574 * _e2577)) + (_e2575 * _e2578)) / (((_e2576 * _e2576) + (_e2577 * _e2577)) + (_e2578 * _e2578)));
                                                        if (_e2589 > f64(0f)) {
                                                            if (_e2589 < f64(1f)) {
                                                                phi_6738_ = _e2589;
                                                            } else {
                                                                phi_6738_ = f64(1f);
                                                            }
                                                            let _e2597 = phi_6738_;
                                                            phi_6740_ = _e2597;
                                                        } else {
                                                            phi_6740_ = f64(0f);
                                                        }
                                                        let _e2599 = phi_6740_;
                                                        let _e2603 = (_e2573 - (_e2576 * _e2599));
                                                        let _e2604 = (_e2574 - (_e2577 * _e2599));
                                                        let _e2605 = (_e2575 - (_e2578 * _e2599));
                                                        let _e2616 = ((((_e2454 * _e2475) + (_e2455 * _e2476)) + (_e2456 * _e2477)) / (((_e2475 * _e2475) + (_e2476 * _e2476)) + (_e2477 * _e2477)));
                                                        if (_e2616 > f64(0f)) {
                                                            if (_e2616 < f64(1f)) {
                                                                phi_6770_ = _e2616;
                                                            } else {
                                                                phi_6770_ = f64(1f);
                                                            }
                                                            let _e2624 = phi_6770_;
                                                            phi_6772_ = _e2624;
                                                        } else {
                                                            phi_6772_ = f64(0f);
                                                        }
                                                        let _e2626 = phi_6772_;
                                                        let _e2643 = ((((_e2454 * _e2496) + (_e2455 * _e2497)) + (_e2456 * _e2498)) / (((_e2496 * _e2496) + (_e2497 * _e2497)) + (_e2498 * _e2498)));
                                                        if (_e2643 > f64(0f)) {
                                                            if (_e2643 < f64(1f)) {
                                                                phi_6802_ = _e2643;
                                                            } else {
                                                                phi_6802_ = f64(1f);
                                                            }
                                                            let _e2651 = phi_6802_;
                                                            phi_6804_ = _e2651;
                                                        } else {
                                                            phi_6804_ = f64(0f);
                                                        }
                                                        let _e2653 = phi_6804_;
                                                        local[0u] = array<f64, 3>((_e2454 - (_e2475 * _e2626)), (_e2455 - (_e2476 * _e2626)), (_e2456 - (_e2477 * _e2626)));
                                                        local[1u] = array<f64, 3>((_e2454 - (_e2496 * _e2653)), (_e2455 - (_e2497 * _e2653)), (_e2456 - (_e2498 * _e2653)));
                                                        local[2u] = array<f64, 3>(_e2603, _e2604, _e2605);
                                                        local[3u] = array<f64, 3>(_e2603, _e2604, _e2605);
                                                        let _e2669 = local[0u];
                                                        phi_6840_ = type_29(1u, 4u);
                                                        phi_6843_ = array<f64, 3>(_e2669[0], _e2669[1], _e2669[2]);
                                                        loop {
                                                            let _e2675 = phi_6840_;
                                                            let _e2677 = phi_6843_;
                                                            local_57 = _e2677;
                                                            if (_e2675.member < _e2675.member_1) {
                                                                phi_6841_ = type_29((_e2675.member + 1u), _e2675.member_1);
                                                                phi_6866_ = type_29(1u, _e2675.member);
                                                            } else {
                                                                phi_6841_ = _e2675;
                                                                phi_6866_ = type_29(0u, type_29().member_1);
                                                            }
                                                            let _e2691 = phi_6841_;
                                                            let _e2693 = phi_6866_;
                                                            let _e2697 = (bitcast<i32>(_e2693.member) != 0i);
                                                            if _e2697 {
                                                                if (_e2693.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2700 = local[_e2693.member_1];
                                                                if (_e2693.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2706 = local[_e2693.member_1];
                                                                if ((((_e2700[0] * _e2706[0]) + (_e2700[1] * _e2706[1])) + (_e2700[2] * _e2706[2])) < (((_e2677[0] * _e2677[0]) + (_e2677[1] * _e2677[1])) + (_e2677[2] * _e2677[2]))) {
                                                                    if (_e2693.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2729 = local[_e2693.member_1];
                                                                    phi_6933_ = array<f64, 3>(_e2729[0], _e2729[1], _e2729[2]);
                                                                } else {
                                                                    phi_6933_ = _e2677;
                                                                }
                                                                let _e2735 = phi_6933_;
                                                                phi_6844_ = _e2735;
                                                            } else {
                                                                phi_6844_ = array<f64, 3>();
                                                            }
                                                            let _e2737 = phi_6844_;
                                                            continue;
                                                            continuing {
                                                                phi_6840_ = _e2691;
                                                                phi_6843_ = _e2737;
                                                                break if !(_e2697);
                                                            }
                                                        }
                                                        let _e5326 = local_57;
                                                        phi_6934_ = _e5326;
                                                    } else {
                                                        phi_6934_ = _e2570;
                                                    }
                                                    let _e2740 = phi_6934_;
                                                    if (_e2740[0] < 0.0lf) {
                                                        phi_6941_ = -(_e2740[0]);
                                                    } else {
                                                        phi_6941_ = _e2740[0];
                                                    }
                                                    let _e2745 = phi_6941_;
                                                    if (_e2740[1] < 0.0lf) {
                                                        phi_6948_ = -(_e2740[1]);
                                                    } else {
                                                        phi_6948_ = _e2740[1];
                                                    }
                                                    let _e2750 = phi_6948_;
                                                    if (_e2740[2] < 0.0lf) {
                                                        phi_6956_ = -(_e2740[2]);
                                                    } else {
                                                        phi_6956_ = _e2740[2];
                                                    }
                                                    let _e2756 = phi_6956_;
                                                    let _e2757 = ((_e2745 + _e2750) + _e2756);
                                                    if (_e2757 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2757) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2763 = (f64(1f) / _e2757);
                                                            let _e2765 = (_e2740[0] * _e2763);
                                                            let _e2767 = (_e2740[1] * _e2763);
                                                            let _e2769 = (_e2740[2] * _e2763);
                                                            let _e2774 = (((_e2765 * _e2765) + (_e2767 * _e2767)) + (_e2769 * _e2769));
                                                            if (_e2774 <= 2.2250738585072014e-308lf) {
                                                                if (_e2774 > 0.0lf) {
                                                                    phi_6994_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_6994_ = 0.0lf;
                                                                }
                                                                let _e2832 = phi_6994_;
                                                                phi_7058_ = _e2832;
                                                            } else {
                                                                phi_7001_ = type_27(0i, 5i);
                                                                phi_7004_ = bitcast<f64>(((bitcast<u64>(_e2774) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2781 = phi_7001_;
                                                                    let _e2783 = phi_7004_;
                                                                    local_26 = _e2783;
                                                                    if (_e2781.member < _e2781.member_1) {
                                                                        let _e2791 = (_e2781.member + 1i);
                                                                        if ((false == (_e2791 > _e2781.member)) != false) {
                                                                            phi_7025_ = true;
                                                                        } else {
                                                                            phi_7025_ = false;
                                                                        }
                                                                        let _e2796 = phi_7025_;
                                                                        if _e2796 {
                                                                            phi_7031_ = type_28(0u, type_28().member_1);
                                                                        } else {
                                                                            phi_7031_ = type_28(1u, _e2791);
                                                                        }
                                                                        let _e2802 = phi_7031_;
                                                                        if (bitcast<i32>(_e2802.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_7002_ = type_27(_e2802.member_1, _e2781.member_1);
                                                                        phi_7045_ = type_28(1u, _e2781.member);
                                                                    } else {
                                                                        phi_7002_ = _e2781;
                                                                        phi_7045_ = type_28(0u, type_28().member_1);
                                                                    }
                                                                    let _e2812 = phi_7002_;
                                                                    let _e2814 = phi_7045_;
                                                                    let _e2817 = (bitcast<i32>(_e2814.member) != 0i);
                                                                    if _e2817 {
                                                                        phi_7005_ = (0.5lf * (_e2783 + (_e2774 / _e2783)));
                                                                    } else {
                                                                        phi_7005_ = f64();
                                                                    }
                                                                    let _e2822 = phi_7005_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7001_ = _e2812;
                                                                        phi_7004_ = _e2822;
                                                                        break if !(_e2817);
                                                                    }
                                                                }
                                                                let _e2827 = local_26;
                                                                phi_7058_ = (_e2827 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2834 = phi_7058_;
                                                            phi_7071_ = type_29(0u, 4u);
                                                            phi_7074_ = f64(2f);
                                                            loop {
                                                                let _e2846 = phi_7071_;
                                                                let _e2848 = phi_7074_;
                                                                local_28 = _e2848;
                                                                local_29 = _e2848;
                                                                local_30 = _e2848;
                                                                local_60 = _e2848;
                                                                local_61 = _e2848;
                                                                if (_e2846.member < _e2846.member_1) {
                                                                    phi_7072_ = type_29((_e2846.member + 1u), _e2846.member_1);
                                                                    phi_7097_ = type_29(1u, _e2846.member);
                                                                } else {
                                                                    phi_7072_ = _e2846;
                                                                    phi_7097_ = type_29(0u, type_29().member_1);
                                                                }
                                                                let _e2862 = phi_7072_;
                                                                let _e2864 = phi_7097_;
                                                                if (bitcast<i32>(_e2864.member) != 0i) {
                                                                    if (_e2864.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2871 = local_1[_e2864.member_1];
                                                                    let _e2879 = (((_e2765 * _e2871[0]) + (_e2767 * _e2871[1])) + (_e2769 * _e2871[2]));
                                                                    if (_e2864.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2882 = local_2[_e2864.member_1];
                                                                    let _e2890 = (((_e2765 * _e2882[0]) + (_e2767 * _e2882[1])) + (_e2769 * _e2882[2]));
                                                                    if (_e2879 < 0.0lf) {
                                                                        phi_7148_ = -(_e2879);
                                                                    } else {
                                                                        phi_7148_ = _e2879;
                                                                    }
                                                                    let _e2894 = phi_7148_;
                                                                    if (_e2890 < 0.0lf) {
                                                                        phi_7154_ = -(_e2890);
                                                                    } else {
                                                                        phi_7154_ = _e2890;
                                                                    }
                                                                    let _e2898 = phi_7154_;
                                                                    let _e2903 = (((((((((_e2287 + _e2289) + (_e2341 + _e2343)) + (_e2395 + _e2397)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2405 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2834) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2894 + _e2898) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2879 > _e2903) {
                                                                        if (_e2890 > _e2903) {
                                                                            phi_7168_ = false;
                                                                        } else {
                                                                            phi_7168_ = true;
                                                                        }
                                                                        let _e2907 = phi_7168_;
                                                                        phi_7169_ = _e2907;
                                                                    } else {
                                                                        phi_7169_ = true;
                                                                    }
                                                                    let _e2909 = phi_7169_;
                                                                    if _e2909 {
                                                                        if ((_e2879 + ((_e2890 - _e2879) * _e2416)) > _e2903) {
                                                                            if (_e2890 < _e2879) {
                                                                                let _e2918 = ((_e2879 - _e2890) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                                                if _e2918 {
                                                                                    let _e2926 = (((_e2879 - _e2903) / (_e2879 - _e2890)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    if (_e2848 < _e2926) {
                                                                                        phi_7203_ = _e2848;
                                                                                    } else {
                                                                                        phi_7203_ = _e2926;
                                                                                    }
                                                                                    let _e2929 = phi_7203_;
                                                                                    phi_7204_ = _e2929;
                                                                                } else {
                                                                                    phi_7204_ = f64();
                                                                                }
                                                                                let _e2931 = phi_7204_;
                                                                                phi_7205_ = _e2931;
                                                                                phi_7206_ = _e2918;
                                                                            } else {
                                                                                phi_7205_ = _e2848;
                                                                                phi_7206_ = true;
                                                                            }
                                                                            let _e2933 = phi_7205_;
                                                                            let _e2935 = phi_7206_;
                                                                            if _e2935 {
                                                                                phi_7210_ = false;
                                                                            } else {
                                                                                phi_7210_ = true;
                                                                            }
                                                                            let _e2937 = phi_7210_;
                                                                            phi_7211_ = _e2933;
                                                                            phi_7212_ = _e2935;
                                                                            phi_7213_ = _e2937;
                                                                            phi_7214_ = false;
                                                                        } else {
                                                                            phi_7211_ = f64();
                                                                            phi_7212_ = false;
                                                                            phi_7213_ = false;
                                                                            phi_7214_ = true;
                                                                        }
                                                                        let _e2939 = phi_7211_;
                                                                        let _e2941 = phi_7212_;
                                                                        let _e2943 = phi_7213_;
                                                                        let _e2945 = phi_7214_;
                                                                        phi_7215_ = _e2939;
                                                                        phi_7216_ = _e2941;
                                                                        phi_7217_ = _e2943;
                                                                        phi_7218_ = _e2945;
                                                                    } else {
                                                                        phi_7215_ = _e2848;
                                                                        phi_7216_ = true;
                                                                        phi_7217_ = false;
                                                                        phi_7218_ = false;
                                                                    }
                                                                    let _e2947 = phi_7215_;
                                                                    let _e2949 = phi_7216_;
                                                                    let _e2951 = phi_7217_;
                                                                    let _e2953 = phi_7218_;
                                                                    phi_7075_ = _e2947;
                                                                    phi_7219_ = _e2949;
                                                                    phi_7220_ = false;
                                                                    phi_7221_ = _e2951;
                                                                    phi_7222_ = _e2953;
                                                                } else {
                                                                    phi_7075_ = f64();
                                                                    phi_7219_ = false;
                                                                    phi_7220_ = true;
                                                                    phi_7221_ = false;
                                                                    phi_7222_ = false;
                                                                }
                                                                let _e2955 = phi_7075_;
                                                                let _e2957 = phi_7219_;
                                                                let _e2959 = phi_7220_;
                                                                let _e2961 = phi_7221_;
                                                                let _e2963 = phi_7222_;
                                                                local_27 = _e2959;
                                                                local_58 = _e2961;
                                                                local_59 = _e2963;
                                                                continue;
                                                                continuing {
                                                                    phi_7071_ = _e2862;
                                                                    phi_7074_ = _e2955;
                                                                    break if !(_e2957);
                                                                }
                                                            }
                                                            let _e2966 = local_27;
                                                            if _e2966 {
                                                                let _e2968 = local_28;
                                                                let _e2969 = (_e2968 > _e1425.member_1);
                                                                if _e2969 {
                                                                    phi_7244_ = false;
                                                                    phi_7245_ = false;
                                                                    phi_7246_ = false;
                                                                } else {
                                                                    let _e2971 = local_29;
                                                                    if (_e2971 > _e2416) {
                                                                        let _e2974 = local_30;
                                                                        let _e2977 = ((_e2974 - _e2416) < f64(0.00000000023283064f));
                                                                        if _e2977 {
                                                                            phi_7240_ = false;
                                                                        } else {
                                                                            phi_7240_ = true;
                                                                        }
                                                                        let _e2979 = phi_7240_;
                                                                        phi_7241_ = _e2979;
                                                                        phi_7242_ = _e2977;
                                                                        phi_7243_ = false;
                                                                    } else {
                                                                        phi_7241_ = false;
                                                                        phi_7242_ = false;
                                                                        phi_7243_ = true;
                                                                    }
                                                                    let _e2981 = phi_7241_;
                                                                    let _e2983 = phi_7242_;
                                                                    let _e2985 = phi_7243_;
                                                                    phi_7244_ = _e2981;
                                                                    phi_7245_ = _e2983;
                                                                    phi_7246_ = _e2985;
                                                                }
                                                                let _e2987 = phi_7244_;
                                                                let _e2989 = phi_7245_;
                                                                let _e2991 = phi_7246_;
                                                                phi_7247_ = _e2987;
                                                                phi_7248_ = _e2969;
                                                                phi_7249_ = _e2989;
                                                                phi_7250_ = _e2991;
                                                                phi_7251_ = false;
                                                                phi_7252_ = false;
                                                            } else {
                                                                phi_7247_ = false;
                                                                phi_7248_ = false;
                                                                phi_7249_ = false;
                                                                phi_7250_ = false;
                                                                let _e5383 = local_58;
                                                                phi_7251_ = _e5383;
                                                                let _e5386 = local_59;
                                                                phi_7252_ = _e5386;
                                                            }
                                                            let _e2993 = phi_7247_;
                                                            let _e2995 = phi_7248_;
                                                            let _e2997 = phi_7249_;
                                                            let _e2999 = phi_7250_;
                                                            let _e3001 = phi_7251_;
                                                            let _e3003 = phi_7252_;
                                                            let _e5389 = local_60;
                                                            phi_7253_ = _e5389;
                                                            let _e5392 = local_61;
                                                            phi_7254_ = _e5392;
                                                            phi_7255_ = _e2993;
                                                            phi_7256_ = _e2995;
                                                            phi_7257_ = _e2997;
                                                            phi_7258_ = _e2999;
                                                            phi_7259_ = _e3001;
                                                            phi_7260_ = _e3003;
                                                            phi_7261_ = false;
                                                        } else {
                                                            phi_7253_ = f64();
                                                            phi_7254_ = f64();
                                                            phi_7255_ = false;
                                                            phi_7256_ = false;
                                                            phi_7257_ = false;
                                                            phi_7258_ = false;
                                                            phi_7259_ = false;
                                                            phi_7260_ = false;
                                                            phi_7261_ = true;
                                                        }
                                                        let _e3005 = phi_7253_;
                                                        let _e3007 = phi_7254_;
                                                        let _e3009 = phi_7255_;
                                                        let _e3011 = phi_7256_;
                                                        let _e3013 = phi_7257_;
                                                        let _e3015 = phi_7258_;
                                                        let _e3017 = phi_7259_;
                                                        let _e3019 = phi_7260_;
                                                        let _e3021 = phi_7261_;
                                                        phi_7262_ = _e3005;
                                                        phi_7263_ = _e3007;
                                                        phi_7264_ = _e3009;
                                                        phi_7265_ = _e3011;
                                                        phi_7266_ = _e3013;
                                                        phi_7267_ = _e3015;
                                                        phi_7268_ = _e3017;
                                                        phi_7269_ = _e3019;
                                                        phi_7270_ = _e3021;
                                                        phi_7271_ = false;
                                                    } else {
                                                        phi_7262_ = f64();
                                                        phi_7263_ = f64();
                                                        phi_7264_ = false;
                                                        phi_7265_ = false;
                                                        phi_7266_ = false;
                                                        phi_7267_ = false;
                                                        phi_7268_ = false;
                                                        phi_7269_ = false;
                                                        phi_7270_ = false;
                                                        phi_7271_ = true;
                                                    }
                                                    let _e3023 = phi_7262_;
                                                    let _e3025 = phi_7263_;
                                                    let _e3027 = phi_7264_;
                                                    let _e3029 = phi_7265_;
                                                    let _e3031 = phi_7266_;
                                                    let _e3033 = phi_7267_;
                                                    let _e3035 = phi_7268_;
                                                    let _e3037 = phi_7269_;
                                                    let _e3039 = phi_7270_;
                                                    let _e3041 = phi_7271_;
                                                    phi_7272_ = _e3023;
                                                    phi_6321_ = _e3025;
                                                    phi_7273_ = _e3027;
                                                    phi_7274_ = _e3029;
                                                    phi_7275_ = _e3031;
                                                    phi_7276_ = false;
                                                    phi_7277_ = _e3033;
                                                    phi_7278_ = _e3035;
                                                    phi_7279_ = _e3037;
                                                    phi_7280_ = _e3039;
                                                    phi_7281_ = _e3041;
                                                } else {
                                                    phi_7272_ = f64();
                                                    phi_6321_ = f64();
                                                    phi_7273_ = false;
                                                    phi_7274_ = false;
                                                    phi_7275_ = false;
                                                    phi_7276_ = true;
                                                    phi_7277_ = false;
                                                    phi_7278_ = false;
                                                    phi_7279_ = false;
                                                    phi_7280_ = false;
                                                    phi_7281_ = false;
                                                }
                                                let _e3043 = phi_7272_;
                                                let _e3045 = phi_6321_;
                                                let _e3047 = phi_7273_;
                                                let _e3049 = phi_7274_;
                                                let _e3051 = phi_7275_;
                                                let _e3053 = phi_7276_;
                                                let _e3055 = phi_7277_;
                                                let _e3057 = phi_7278_;
                                                let _e3059 = phi_7279_;
                                                let _e3061 = phi_7280_;
                                                let _e3063 = phi_7281_;
                                                local_31 = _e3049;
                                                local_62 = _e3051;
                                                local_63 = _e3053;
                                                local_64 = _e3055;
                                                local_65 = _e3057;
                                                local_66 = _e3059;
                                                local_67 = _e3061;
                                                local_68 = _e3063;
                                                local_69 = _e3043;
                                                local_71 = _e3049;
                                                continue;
                                                continuing {
                                                    phi_6317_ = _e2430;
                                                    phi_6320_ = _e3045;
                                                    break if !(_e3047);
                                                }
                                            }
                                            let _e3066 = local_31;
                                            if _e3066 {
                                                phi_7286_ = type_73(0u, type_73().member_1);
                                                phi_7287_ = false;
                                                phi_7288_ = false;
                                                phi_7289_ = false;
                                                phi_7290_ = false;
                                                phi_7291_ = false;
                                                phi_7292_ = false;
                                                phi_7293_ = false;
                                            } else {
                                                phi_7286_ = type_73();
                                                let _e5425 = local_62;
                                                phi_7287_ = _e5425;
                                                let _e5428 = local_63;
                                                phi_7288_ = _e5428;
                                                let _e5431 = local_64;
                                                phi_7289_ = _e5431;
                                                let _e5434 = local_65;
                                                phi_7290_ = _e5434;
                                                let _e5437 = local_66;
                                                phi_7291_ = _e5437;
                                                let _e5440 = local_67;
                                                phi_7292_ = _e5440;
                                                let _e5443 = local_68;
                                                phi_7293_ = _e5443;
                                            }
                                            let _e3071 = phi_7286_;
                                            let _e3073 = phi_7287_;
                                            let _e3075 = phi_7288_;
                                            let _e3077 = phi_7289_;
                                            let _e3079 = phi_7290_;
                                            let _e3081 = phi_7291_;
                                            let _e3083 = phi_7292_;
                                            let _e3085 = phi_7293_;
                                            if _e3073 {
                                                let _e5446 = local_69;
                                                phi_7297_ = _e5446;
                                                phi_7298_ = true;
                                                phi_7299_ = false;
                                                phi_7300_ = false;
                                                phi_7301_ = false;
                                                phi_7302_ = false;
                                                phi_7303_ = false;
                                                phi_7304_ = false;
                                            } else {
                                                let _e5448 = local_70;
                                                phi_7297_ = _e5448;
                                                phi_7298_ = _e3075;
                                                phi_7299_ = _e3077;
                                                phi_7300_ = _e3079;
                                                phi_7301_ = _e3081;
                                                let _e5455 = local_71;
                                                phi_7302_ = _e5455;
                                                phi_7303_ = _e3083;
                                                phi_7304_ = _e3085;
                                            }
                                            let _e3087 = phi_7297_;
                                            let _e3089 = phi_7298_;
                                            let _e3091 = phi_7299_;
                                            let _e3093 = phi_7300_;
                                            let _e3095 = phi_7301_;
                                            let _e3097 = phi_7302_;
                                            let _e3099 = phi_7303_;
                                            let _e3101 = phi_7304_;
                                            if _e3089 {
                                                phi_7309_ = type_73(1u, _e3087);
                                                phi_7310_ = false;
                                                phi_7311_ = false;
                                                phi_7312_ = false;
                                                phi_7313_ = false;
                                                phi_7314_ = false;
                                                phi_7315_ = false;
                                            } else {
                                                phi_7309_ = type_73();
                                                phi_7310_ = _e3091;
                                                phi_7311_ = _e3093;
                                                phi_7312_ = _e3095;
                                                phi_7313_ = _e3097;
                                                phi_7314_ = _e3099;
                                                phi_7315_ = _e3101;
                                            }
                                            let _e3104 = phi_7309_;
                                            let _e3106 = phi_7310_;
                                            let _e3108 = phi_7311_;
                                            let _e3110 = phi_7312_;
                                            let _e3112 = phi_7313_;
                                            let _e3114 = phi_7314_;
                                            let _e3116 = phi_7315_;
                                            if _e3106 {
                                                let _e3118 = local_32;
                                                phi_7320_ = type_73(1u, _e3118);
                                                phi_7321_ = false;
                                                phi_7322_ = false;
                                                phi_7323_ = true;
                                                phi_7324_ = false;
                                                phi_7325_ = false;
                                            } else {
                                                phi_7320_ = _e3071;
                                                phi_7321_ = _e3108;
                                                phi_7322_ = _e3110;
                                                phi_7323_ = _e3112;
                                                phi_7324_ = _e3114;
                                                phi_7325_ = _e3116;
                                            }
                                            let _e3121 = phi_7320_;
                                            let _e3123 = phi_7321_;
                                            let _e3125 = phi_7322_;
                                            let _e3127 = phi_7323_;
                                            let _e3129 = phi_7324_;
                                            let _e3131 = phi_7325_;
                                            if _e3123 {
                                                let _e3133 = local_33;
                                                phi_7330_ = type_73(1u, _e3133);
                                                phi_7331_ = false;
                                                phi_7332_ = false;
                                                phi_7333_ = false;
                                                phi_7334_ = false;
                                            } else {
                                                phi_7330_ = type_73();
                                                phi_7331_ = _e3125;
                                                phi_7332_ = _e3127;
                                                phi_7333_ = _e3129;
                                                phi_7334_ = _e3131;
                                            }
                                            let _e3136 = phi_7330_;
                                            let _e3138 = phi_7331_;
                                            let _e3140 = phi_7332_;
                                            let _e3142 = phi_7333_;
                                            let _e3144 = phi_7334_;
                                            if _e3138 {
                                                let _e3146 = local_34;
                                                phi_7339_ = type_73(1u, _e3146);
                                                phi_7340_ = true;
                                                phi_7341_ = false;
                                                phi_7342_ = false;
                                                phi_7343_ = false;
                                            } else {
                                                phi_7339_ = _e3136;
                                                phi_7340_ = _e3123;
                                                phi_7341_ = _e3140;
                                                phi_7342_ = _e3142;
                                                phi_7343_ = _e3144;
                                            }
                                            let _e3149 = phi_7339_;
                                            let _e3151 = phi_7340_;
                                            let _e3153 = phi_7341_;
                                            let _e3155 = phi_7342_;
                                            let _e3157 = phi_7343_;
                                            if _e3151 {
                                                phi_7347_ = _e3149;
                                                phi_7348_ = true;
                                                phi_7349_ = false;
                                                phi_7350_ = false;
                                            } else {
                                                phi_7347_ = _e3121;
                                                phi_7348_ = _e3153;
                                                phi_7349_ = _e3155;
                                                phi_7350_ = _e3157;
                                            }
                                            let _e3159 = phi_7347_;
                                            let _e3161 = phi_7348_;
                                            let _e3163 = phi_7349_;
                                            let _e3165 = phi_7350_;
                                            if _e3161 {
                                                phi_7354_ = false;
                                                phi_7355_ = false;
                                            } else {
                                                phi_7354_ = _e3163;
                                                phi_7355_ = _e3165;
                                            }
                                            let _e3167 = phi_7354_;
                                            let _e3169 = phi_7355_;
                                            if _e3167 {
                                                phi_7359_ = false;
                                                phi_7360_ = false;
                                            } else {
                                                phi_7359_ = _e3169;
                                                phi_7360_ = _e3161;
                                            }
                                            let _e3171 = phi_7359_;
                                            let _e3173 = phi_7360_;
                                            if _e3171 {
                                                phi_7364_ = true;
                                                phi_7365_ = false;
                                            } else {
                                                phi_7364_ = _e3167;
                                                phi_7365_ = _e3173;
                                            }
                                            let _e3175 = phi_7364_;
                                            let _e3177 = phi_7365_;
                                            if _e3175 {
                                                let _e3179 = local_35;
                                                phi_7370_ = type_73(1u, _e3179);
                                                phi_7371_ = true;
                                            } else {
                                                phi_7370_ = _e3159;
                                                phi_7371_ = _e3177;
                                            }
                                            let _e3182 = phi_7370_;
                                            let _e3184 = phi_7371_;
                                            if _e3184 {
                                                phi_7375_ = _e3182;
                                            } else {
                                                phi_7375_ = _e3104;
                                            }
                                            let _e3186 = phi_7375_;
                                            let _e3189 = (_e3186.member != 0u);
                                            if _e3189 {
                                                phi_7382_ = false;
                                            } else {
                                                phi_7382_ = true;
                                            }
                                            let _e3191 = phi_7382_;
                                            phi_7383_ = _e3186.member_1;
                                            phi_7384_ = _e3191;
                                            phi_7385_ = _e3189;
                                            phi_7386_ = false;
                                        } else {
                                            phi_7383_ = f64();
                                            phi_7384_ = false;
                                            phi_7385_ = false;
                                            phi_7386_ = true;
                                        }
                                        let _e3193 = phi_7383_;
                                        let _e3195 = phi_7384_;
                                        let _e3197 = phi_7385_;
                                        let _e3199 = phi_7386_;
                                        phi_7387_ = _e3193;
                                        phi_7388_ = _e3195;
                                        phi_7389_ = _e3197;
                                        phi_7390_ = _e3199;
                                    }
                                    let _e3201 = phi_7387_;
                                    let _e3203 = phi_7388_;
                                    let _e3205 = phi_7389_;
                                    let _e3207 = phi_7390_;
                                    phi_7391_ = _e3201;
                                    phi_7392_ = _e2166;
                                    phi_7393_ = _e3203;
                                    phi_7394_ = _e3205;
                                    phi_7395_ = _e3207;
                                }
                                let _e3209 = phi_7391_;
                                let _e3211 = phi_7392_;
                                let _e3213 = phi_7393_;
                                let _e3215 = phi_7394_;
                                let _e3217 = phi_7395_;
                                if _e3211 {
                                    phi_7399_ = true;
                                    phi_7400_ = false;
                                    phi_7401_ = false;
                                } else {
                                    phi_7399_ = _e3213;
                                    phi_7400_ = _e3215;
                                    phi_7401_ = _e3217;
                                }
                                let _e3219 = phi_7399_;
                                let _e3221 = phi_7400_;
                                let _e3223 = phi_7401_;
                                phi_7402_ = _e3209;
                                phi_7403_ = _e1425;
                                phi_7404_ = _e3219;
                                phi_7405_ = false;
                                phi_7406_ = _e3221;
                                phi_7407_ = _e3223;
                            } else {
                                phi_7402_ = f64();
                                phi_7403_ = type_74();
                                phi_7404_ = false;
                                phi_7405_ = true;
                                phi_7406_ = false;
                                phi_7407_ = false;
                            }
                            let _e3225 = phi_7402_;
                            let _e3227 = phi_7403_;
                            let _e3229 = phi_7404_;
                            let _e3231 = phi_7405_;
                            let _e3233 = phi_7406_;
                            let _e3235 = phi_7407_;
                            local_36 = _e3231;
                            local_72 = _e3233;
                            local_73 = _e3235;
                            local_37 = _e3225;
                            local_38 = _e3227;
                            continue;
                            continuing {
                                phi_4356_ = _e1106;
                                break if !(_e3229);
                            }
                        }
                        let _e3238 = local_36;
                        if _e3238 {
                            phi_7412_ = type_73(0u, type_73().member_1);
                            phi_7413_ = false;
                            phi_7414_ = false;
                        } else {
                            phi_7412_ = type_73();
                            let _e5525 = local_72;
                            phi_7413_ = _e5525;
                            let _e5528 = local_73;
                            phi_7414_ = _e5528;
                        }
                        let _e3243 = phi_7412_;
                        let _e3245 = phi_7413_;
                        let _e3247 = phi_7414_;
                        if _e3245 {
                            let _e3249 = local_37;
                            phi_7419_ = type_73(2u, _e3249);
                            phi_7420_ = false;
                        } else {
                            phi_7419_ = type_73();
                            phi_7420_ = _e3247;
                        }
                        let _e3252 = phi_7419_;
                        let _e3254 = phi_7420_;
                        if _e3254 {
                            let _e3256 = local_38;
                            phi_7426_ = type_73(1u, _e3256.member);
                            phi_7427_ = true;
                        } else {
                            phi_7426_ = _e3252;
                            phi_7427_ = _e3245;
                        }
                        let _e3260 = phi_7426_;
                        let _e3262 = phi_7427_;
                        if _e3262 {
                            phi_7431_ = _e3260;
                        } else {
                            phi_7431_ = _e3243;
                        }
                        let _e3264 = phi_7431_;
                        phi_7435_ = _e3264;
                    }
                    let _e4900 = phi_7435_;
                    phi_7436_ = _e4900;
                }
                let _e4905 = phi_7436_;
                switch bitcast<i32>(_e4905.member) {
                    case 0: {
                        phi_7449_ = type_47(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4911 = function_(_e4905.member_1);
                        phi_7449_ = type_47(0u, _e4911, true);
                        break;
                    }
                    case 2: {
                        let _e4909 = function_(_e4905.member_1);
                        phi_7449_ = type_47(1u, _e4909, true);
                        break;
                    }
                    default: {
                        phi_7449_ = type_47();
                        break;
                    }
                }
                let _e4914 = phi_7449_;
                if _e4914.member_2 {
                    let _e4921 = (_e4914.member_1[1] >> bitcast<u32>(20i));
                    if (_e4921 <= 896u) {
                        phi_7472_ = 0u;
                    } else {
                        phi_7472_ = ((((_e4921 - 896u) << bitcast<u32>(23i)) | ((_e4914.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4914.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4936 = phi_7472_;
                    let _e4938 = atomicMin((&earliest.member[0u]), _e4936);
                }
                phi_7476_ = type_46(_e186, _e4914.member, _e192, _e195, _e4914.member_1);
                phi_7477_ = _e4914.member_2;
            } else {
                phi_7476_ = type_46(_e186, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_7477_ = false;
            }
            let _e4940 = phi_7476_;
            let _e4942 = phi_7477_;
            let _e4944 = params.member.member_1;
            if ((_e4944 & 16u) != 0u) {
                if (_e117 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4942 {
                    let _e4950 = atomicAdd((&counters[0u]), 1u);
                    phi_7495_ = _e4950;
                } else {
                    phi_7495_ = 0u;
                }
                let _e4952 = phi_7495_;
                workgroupBarrier();
                if (_e117 == 0u) {
                    let _e4955 = atomicLoad((&counters[0u]));
                    if (_e4955 > 0u) {
                        let _e4958 = atomicAdd((&contacts.member[0u]), _e4955);
                        atomicStore((&counters[1u]), _e4958);
                    }
                }
                workgroupBarrier();
                let _e4961 = atomicLoad((&counters[1u]));
                let _e4962 = (_e4961 + _e4952);
                if _e4942 {
                    let _e4964 = params.member.member_16;
                    if (_e4962 < _e4964) {
                        let _e4966 = (6u * _e4962);
                        atomicStore((&contacts.member[(4u + _e4966)]), _e4940.member);
                        atomicStore((&contacts.member[(_e4966 + 5u)]), _e4940.member_1);
                        atomicStore((&contacts.member[(_e4966 + 6u)]), _e4940.member_2);
                        atomicStore((&contacts.member[(_e4966 + 7u)]), _e4940.member_3);
                        atomicStore((&contacts.member[(_e4966 + 8u)]), _e4940.member_4[0]);
                        atomicStore((&contacts.member[(_e4966 + 9u)]), _e4940.member_4[1]);
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
