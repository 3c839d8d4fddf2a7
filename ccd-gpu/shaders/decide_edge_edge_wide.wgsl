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
    member: array<array<u32, 2>>,
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
@group(0) @binding(3) 
var<storage> elements: type_14;
@group(0) @binding(4) 
var<storage> input: type_12;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_44;

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
    var phi_232_: u32;
    var phi_248_: u32;
    var phi_269_: u32;
    var phi_270_: u32;
    var phi_273_: type_19;
    var phi_274_: type_19;
    var phi_297_: type_19;
    var phi_640_: type_19;
    var phi_641_: type_19;
    var phi_664_: type_19;
    var phi_520_: type_19;
    var phi_521_: type_19;
    var phi_544_: type_19;
    var phi_554_: type_19;
    var phi_555_: type_19;
    var phi_578_: type_19;
    var phi_1132_: f64;
    var phi_1139_: f64;
    var phi_1144_: f64;
    var phi_1151_: f64;
    var phi_1156_: f64;
    var phi_1169_: f64;
    var phi_1176_: f64;
    var phi_1181_: f64;
    var phi_1188_: f64;
    var phi_1193_: f64;
    var phi_1198_: f64;
    var phi_1215_: f64;
    var phi_1222_: f64;
    var phi_1227_: f64;
    var phi_1234_: f64;
    var phi_1239_: f64;
    var phi_1253_: f64;
    var phi_1260_: f64;
    var phi_1265_: f64;
    var phi_1272_: f64;
    var phi_1277_: f64;
    var phi_1282_: f64;
    var phi_1299_: f64;
    var phi_1306_: f64;
    var phi_1311_: f64;
    var phi_1318_: f64;
    var phi_1323_: f64;
    var phi_1337_: f64;
    var phi_1344_: f64;
    var phi_1349_: f64;
    var phi_1356_: f64;
    var phi_1361_: f64;
    var phi_1366_: f64;
    var phi_1403_: f64;
    var phi_1409_: f64;
    var phi_1416_: f64;
    var phi_1423_: f64;
    var phi_1429_: f64;
    var phi_1436_: f64;
    var phi_1442_: f64;
    var phi_1448_: f64;
    var phi_1454_: f64;
    var phi_1461_: f64;
    var phi_1468_: f64;
    var phi_1496_: f64;
    var phi_1501_: f64;
    var phi_1506_: f64;
    var phi_1511_: f64;
    var phi_1516_: f64;
    var phi_1521_: f64;
    var phi_1532_: f64;
    var phi_4089_: f64;
    var phi_4095_: f64;
    var phi_4100_: f64;
    var phi_4106_: f64;
    var phi_4112_: f64;
    var phi_4117_: f64;
    var phi_4122_: f64;
    var phi_4132_: bool;
    var phi_4139_: f64;
    var phi_4147_: f64;
    var phi_4190_: type_17;
    var phi_4193_: f64;
    var phi_4214_: bool;
    var phi_4220_: type_18;
    var phi_4191_: type_17;
    var phi_4234_: type_18;
    var phi_4194_: f64;
    var local_21: f64;
    var phi_4183_: f64;
    var phi_4247_: f64;
    var phi_4253_: f64;
    var phi_4278_: type_19;
    var phi_4281_: u32;
    var phi_4279_: type_19;
    var phi_4304_: type_19;
    var phi_4348_: u32;
    var phi_4349_: u32;
    var phi_4282_: u32;
    var phi_4350_: u32;
    var phi_4370_: type_19;
    var phi_4371_: type_19;
    var phi_4394_: type_19;
    var phi_4448_: f64;
    var phi_4455_: f64;
    var phi_4467_: bool;
    var phi_4468_: bool;
    var phi_4469_: bool;
    var phi_4470_: bool;
    var phi_4474_: bool;
    var phi_4486_: type_41;
    var phi_4487_: type_41;
    var phi_4488_: bool;
    var phi_4489_: type_41;
    var phi_4490_: bool;
    var phi_4503_: f64;
    var phi_4516_: type_19;
    var phi_4519_: f64;
    var phi_4521_: f64;
    var phi_4523_: f64;
    var phi_4517_: type_19;
    var phi_4546_: type_19;
    var phi_4573_: f64;
    var phi_4574_: f64;
    var phi_4602_: f64;
    var phi_4618_: f64;
    var phi_4625_: bool;
    var phi_4626_: bool;
    var phi_4627_: bool;
    var phi_4633_: f64;
    var phi_4634_: f64;
    var phi_4635_: bool;
    var phi_4520_: f64;
    var phi_4522_: f64;
    var phi_4524_: f64;
    var phi_4636_: f64;
    var phi_4637_: bool;
    var phi_4638_: bool;
    var local_22: bool;
    var phi_4642_: f64;
    var phi_4643_: f64;
    var phi_4651_: type_19;
    var phi_4654_: f64;
    var phi_4652_: type_19;
    var phi_4677_: type_19;
    var phi_4720_: f64;
    var phi_4730_: f64;
    var phi_4740_: bool;
    var phi_4742_: bool;
    var phi_4747_: f64;
    var phi_4748_: bool;
    var phi_4749_: f64;
    var phi_4750_: bool;
    var phi_4751_: bool;
    var phi_4752_: bool;
    var phi_4753_: f64;
    var phi_4655_: f64;
    var phi_4754_: bool;
    var phi_4755_: bool;
    var phi_4756_: bool;
    var phi_4757_: bool;
    var local_23: bool;
    var phi_4761_: bool;
    var phi_4762_: bool;
    var phi_4766_: bool;
    var phi_4770_: f64;
    var phi_4771_: f64;
    var phi_4773_: type_41;
    var phi_4804_: f64;
    var phi_4811_: f64;
    var phi_4816_: f64;
    var phi_4823_: f64;
    var phi_4828_: f64;
    var phi_4841_: f64;
    var phi_4848_: f64;
    var phi_4853_: f64;
    var phi_4860_: f64;
    var phi_4865_: f64;
    var phi_4870_: f64;
    var phi_4929_: f64;
    var phi_4935_: f64;
    var phi_4940_: f64;
    var phi_4946_: f64;
    var phi_4951_: f64;
    var phi_4965_: f64;
    var phi_4971_: f64;
    var phi_4976_: f64;
    var phi_4982_: f64;
    var phi_4987_: f64;
    var phi_5013_: f64;
    var phi_5020_: f64;
    var phi_5025_: f64;
    var phi_5032_: f64;
    var phi_5037_: f64;
    var phi_5050_: f64;
    var phi_5057_: f64;
    var phi_5062_: f64;
    var phi_5069_: f64;
    var phi_5074_: f64;
    var phi_5079_: f64;
    var phi_5138_: f64;
    var phi_5144_: f64;
    var phi_5149_: f64;
    var phi_5155_: f64;
    var phi_5160_: f64;
    var phi_5174_: f64;
    var phi_5180_: f64;
    var phi_5185_: f64;
    var phi_5191_: f64;
    var phi_5196_: f64;
    var phi_5222_: f64;
    var phi_5229_: f64;
    var phi_5234_: f64;
    var phi_5241_: f64;
    var phi_5246_: f64;
    var phi_5259_: f64;
    var phi_5266_: f64;
    var phi_5271_: f64;
    var phi_5278_: f64;
    var phi_5283_: f64;
    var phi_5288_: f64;
    var phi_5347_: f64;
    var phi_5353_: f64;
    var phi_5358_: f64;
    var phi_5364_: f64;
    var phi_5369_: f64;
    var phi_5383_: f64;
    var phi_5389_: f64;
    var phi_5394_: f64;
    var phi_5400_: f64;
    var phi_5405_: f64;
    var phi_5454_: f64;
    var phi_5460_: f64;
    var phi_5488_: f64;
    var phi_5494_: f64;
    var phi_5499_: u32;
    var phi_5500_: u32;
    var phi_5470_: f64;
    var phi_5476_: f64;
    var phi_5481_: u32;
    var phi_5482_: u32;
    var phi_5501_: u32;
    var phi_5502_: u32;
    var phi_5573_: f64;
    var phi_5585_: f64;
    var phi_5724_: f64;
    var phi_5730_: f64;
    var phi_5737_: f64;
    var phi_5781_: type_19;
    var phi_5784_: bool;
    var phi_5782_: type_19;
    var phi_5807_: type_19;
    var phi_5834_: bool;
    var phi_5835_: bool;
    var phi_5785_: bool;
    var phi_5836_: bool;
    var phi_5837_: bool;
    var local_24: bool;
    var phi_5841_: bool;
    var local_25: bool;
    var phi_5848_: u32;
    var phi_5849_: u32;
    var phi_5850_: bool;
    var phi_5851_: u32;
    var phi_5852_: u32;
    var phi_5853_: bool;
    var phi_5857_: u32;
    var phi_5878_: bool;
    var phi_5879_: bool;
    var phi_5880_: bool;
    var phi_6077_: f64;
    var phi_6084_: f64;
    var phi_6089_: f64;
    var phi_6096_: f64;
    var phi_6101_: f64;
    var phi_6114_: f64;
    var phi_6121_: f64;
    var phi_6126_: f64;
    var phi_6133_: f64;
    var phi_6138_: f64;
    var phi_6143_: f64;
    var phi_6160_: f64;
    var phi_6167_: f64;
    var phi_6172_: f64;
    var phi_6179_: f64;
    var phi_6184_: f64;
    var phi_6198_: f64;
    var phi_6205_: f64;
    var phi_6210_: f64;
    var phi_6217_: f64;
    var phi_6222_: f64;
    var phi_6227_: f64;
    var phi_6244_: f64;
    var phi_6251_: f64;
    var phi_6256_: f64;
    var phi_6263_: f64;
    var phi_6268_: f64;
    var phi_6282_: f64;
    var phi_6289_: f64;
    var phi_6294_: f64;
    var phi_6301_: f64;
    var phi_6306_: f64;
    var phi_6311_: f64;
    var phi_6331_: type_19;
    var phi_6334_: f64;
    var phi_6332_: type_19;
    var phi_6357_: type_19;
    var phi_6513_: bool;
    var phi_6514_: bool;
    var phi_6515_: bool;
    var phi_6516_: bool;
    var phi_6517_: bool;
    var phi_6518_: bool;
    var phi_6522_: bool;
    var phi_6562_: array<f64, 3>;
    var phi_6563_: bool;
    var phi_6564_: array<f64, 3>;
    var phi_6565_: bool;
    var phi_6598_: f64;
    var phi_6600_: f64;
    var phi_6630_: f64;
    var phi_6632_: f64;
    var phi_6662_: f64;
    var phi_6664_: f64;
    var phi_6697_: f64;
    var phi_6699_: f64;
    var phi_6854_: type_19;
    var phi_6857_: array<f64, 3>;
    var phi_6855_: type_19;
    var phi_6880_: type_19;
    var phi_6947_: array<f64, 3>;
    var phi_6858_: array<f64, 3>;
    var phi_6948_: array<f64, 3>;
    var phi_6955_: f64;
    var phi_6962_: f64;
    var phi_6970_: f64;
    var phi_7015_: type_17;
    var phi_7018_: f64;
    var phi_7039_: bool;
    var phi_7045_: type_18;
    var phi_7016_: type_17;
    var phi_7059_: type_18;
    var phi_7019_: f64;
    var local_26: f64;
    var phi_7008_: f64;
    var phi_7072_: f64;
    var phi_7085_: type_19;
    var phi_7088_: f64;
    var phi_7086_: type_19;
    var phi_7111_: type_19;
    var phi_7162_: f64;
    var phi_7168_: f64;
    var phi_7182_: bool;
    var phi_7183_: bool;
    var phi_7217_: f64;
    var phi_7218_: f64;
    var phi_7219_: f64;
    var phi_7220_: bool;
    var phi_7224_: bool;
    var phi_7225_: f64;
    var phi_7226_: bool;
    var phi_7227_: bool;
    var phi_7228_: bool;
    var phi_7229_: f64;
    var phi_7230_: bool;
    var phi_7231_: bool;
    var phi_7232_: bool;
    var phi_7089_: f64;
    var phi_7233_: bool;
    var phi_7234_: bool;
    var phi_7235_: bool;
    var phi_7236_: bool;
    var local_27: bool;
    var local_28: f64;
    var local_29: f64;
    var local_30: f64;
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
    var phi_7264_: bool;
    var phi_7265_: bool;
    var phi_7266_: bool;
    var phi_7267_: f64;
    var phi_7268_: f64;
    var phi_7269_: bool;
    var phi_7270_: bool;
    var phi_7271_: bool;
    var phi_7272_: bool;
    var phi_7273_: bool;
    var phi_7274_: bool;
    var phi_7275_: bool;
    var phi_7276_: f64;
    var phi_7277_: f64;
    var phi_7278_: bool;
    var phi_7279_: bool;
    var phi_7280_: bool;
    var phi_7281_: bool;
    var phi_7282_: bool;
    var phi_7283_: bool;
    var phi_7284_: bool;
    var phi_7285_: bool;
    var phi_7286_: f64;
    var phi_6335_: f64;
    var phi_7287_: bool;
    var phi_7288_: bool;
    var phi_7289_: bool;
    var phi_7290_: bool;
    var phi_7291_: bool;
    var phi_7292_: bool;
    var phi_7293_: bool;
    var phi_7294_: bool;
    var phi_7295_: bool;
    var local_31: bool;
    var phi_7300_: type_40;
    var phi_7301_: bool;
    var phi_7302_: bool;
    var phi_7303_: bool;
    var phi_7304_: bool;
    var phi_7305_: bool;
    var phi_7306_: bool;
    var phi_7307_: bool;
    var phi_7311_: f64;
    var phi_7312_: bool;
    var phi_7313_: bool;
    var phi_7314_: bool;
    var phi_7315_: bool;
    var phi_7316_: bool;
    var phi_7317_: bool;
    var phi_7318_: bool;
    var phi_7323_: type_40;
    var phi_7324_: bool;
    var phi_7325_: bool;
    var phi_7326_: bool;
    var phi_7327_: bool;
    var phi_7328_: bool;
    var phi_7329_: bool;
    var local_32: f64;
    var phi_7334_: type_40;
    var phi_7335_: bool;
    var phi_7336_: bool;
    var phi_7337_: bool;
    var phi_7338_: bool;
    var phi_7339_: bool;
    var local_33: f64;
    var phi_7344_: type_40;
    var phi_7345_: bool;
    var phi_7346_: bool;
    var phi_7347_: bool;
    var phi_7348_: bool;
    var local_34: f64;
    var phi_7353_: type_40;
    var phi_7354_: bool;
    var phi_7355_: bool;
    var phi_7356_: bool;
    var phi_7357_: bool;
    var phi_7361_: type_40;
    var phi_7362_: bool;
    var phi_7363_: bool;
    var phi_7364_: bool;
    var phi_7368_: bool;
    var phi_7369_: bool;
    var phi_7373_: bool;
    var phi_7374_: bool;
    var phi_7378_: bool;
    var phi_7379_: bool;
    var local_35: f64;
    var phi_7384_: type_40;
    var phi_7385_: bool;
    var phi_7389_: type_40;
    var phi_7396_: bool;
    var phi_7397_: f64;
    var phi_7398_: bool;
    var phi_7399_: bool;
    var phi_7400_: bool;
    var phi_7401_: f64;
    var phi_7402_: bool;
    var phi_7403_: bool;
    var phi_7404_: bool;
    var phi_7405_: f64;
    var phi_7406_: bool;
    var phi_7407_: bool;
    var phi_7408_: bool;
    var phi_7409_: bool;
    var phi_7413_: bool;
    var phi_7414_: bool;
    var phi_7415_: bool;
    var phi_7416_: f64;
    var phi_7417_: type_41;
    var phi_7418_: bool;
    var phi_7419_: bool;
    var phi_7420_: bool;
    var phi_7421_: bool;
    var local_36: bool;
    var phi_7426_: type_40;
    var phi_7427_: bool;
    var phi_7428_: bool;
    var local_37: f64;
    var phi_7433_: type_40;
    var phi_7434_: bool;
    var local_38: type_41;
    var phi_7440_: type_40;
    var phi_7441_: bool;
    var phi_7445_: type_40;
    var phi_1735_: f64;
    var phi_1742_: f64;
    var phi_1747_: f64;
    var phi_1754_: f64;
    var phi_1759_: f64;
    var phi_1772_: f64;
    var phi_1779_: f64;
    var phi_1784_: f64;
    var phi_1791_: f64;
    var phi_1796_: f64;
    var phi_1801_: f64;
    var phi_1818_: f64;
    var phi_1825_: f64;
    var phi_1830_: f64;
    var phi_1837_: f64;
    var phi_1842_: f64;
    var phi_1856_: f64;
    var phi_1863_: f64;
    var phi_1868_: f64;
    var phi_1875_: f64;
    var phi_1880_: f64;
    var phi_1885_: f64;
    var phi_1902_: f64;
    var phi_1909_: f64;
    var phi_1914_: f64;
    var phi_1921_: f64;
    var phi_1926_: f64;
    var phi_1940_: f64;
    var phi_1947_: f64;
    var phi_1952_: f64;
    var phi_1959_: f64;
    var phi_1964_: f64;
    var phi_1969_: f64;
    var phi_1989_: type_19;
    var phi_1992_: f64;
    var phi_1990_: type_19;
    var phi_2015_: type_19;
    var phi_2171_: bool;
    var phi_2172_: bool;
    var phi_2173_: bool;
    var phi_2174_: bool;
    var phi_2175_: bool;
    var phi_2176_: bool;
    var phi_2180_: bool;
    var phi_2220_: array<f64, 3>;
    var phi_2221_: bool;
    var phi_2222_: array<f64, 3>;
    var phi_2223_: bool;
    var phi_2256_: f64;
    var phi_2258_: f64;
    var phi_2288_: f64;
    var phi_2290_: f64;
    var phi_2320_: f64;
    var phi_2322_: f64;
    var phi_2355_: f64;
    var phi_2357_: f64;
    var phi_2512_: type_19;
    var phi_2515_: array<f64, 3>;
    var phi_2513_: type_19;
    var phi_2538_: type_19;
    var phi_2605_: array<f64, 3>;
    var phi_2516_: array<f64, 3>;
    var phi_2606_: array<f64, 3>;
    var phi_2613_: f64;
    var phi_2620_: f64;
    var phi_2628_: f64;
    var phi_2673_: type_17;
    var phi_2676_: f64;
    var phi_2697_: bool;
    var phi_2703_: type_18;
    var phi_2674_: type_17;
    var phi_2717_: type_18;
    var phi_2677_: f64;
    var local_39: f64;
    var phi_2666_: f64;
    var phi_2730_: f64;
    var phi_2743_: type_19;
    var phi_2746_: f64;
    var phi_2744_: type_19;
    var phi_2769_: type_19;
    var phi_2820_: f64;
    var phi_2826_: f64;
    var phi_2840_: bool;
    var phi_2841_: bool;
    var phi_2875_: f64;
    var phi_2876_: f64;
    var phi_2877_: f64;
    var phi_2878_: bool;
    var phi_2882_: bool;
    var phi_2883_: f64;
    var phi_2884_: bool;
    var phi_2885_: bool;
    var phi_2886_: bool;
    var phi_2887_: f64;
    var phi_2888_: bool;
    var phi_2889_: bool;
    var phi_2890_: bool;
    var phi_2747_: f64;
    var phi_2891_: bool;
    var phi_2892_: bool;
    var phi_2893_: bool;
    var phi_2894_: bool;
    var local_40: bool;
    var local_41: f64;
    var local_42: f64;
    var local_43: f64;
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
    var phi_2922_: bool;
    var phi_2923_: bool;
    var phi_2924_: bool;
    var phi_2925_: f64;
    var phi_2926_: f64;
    var phi_2927_: bool;
    var phi_2928_: bool;
    var phi_2929_: bool;
    var phi_2930_: bool;
    var phi_2931_: bool;
    var phi_2932_: bool;
    var phi_2933_: bool;
    var phi_2934_: f64;
    var phi_2935_: f64;
    var phi_2936_: bool;
    var phi_2937_: bool;
    var phi_2938_: bool;
    var phi_2939_: bool;
    var phi_2940_: bool;
    var phi_2941_: bool;
    var phi_2942_: bool;
    var phi_2943_: bool;
    var phi_2944_: f64;
    var phi_1993_: f64;
    var phi_2945_: bool;
    var phi_2946_: bool;
    var phi_2947_: bool;
    var phi_2948_: bool;
    var phi_2949_: bool;
    var phi_2950_: bool;
    var phi_2951_: bool;
    var phi_2952_: bool;
    var phi_2953_: bool;
    var local_44: bool;
    var phi_2958_: type_40;
    var phi_2959_: bool;
    var phi_2960_: bool;
    var phi_2961_: bool;
    var phi_2962_: bool;
    var phi_2963_: bool;
    var phi_2964_: bool;
    var phi_2965_: bool;
    var phi_2969_: f64;
    var phi_2970_: bool;
    var phi_2971_: bool;
    var phi_2972_: bool;
    var phi_2973_: bool;
    var phi_2974_: bool;
    var phi_2975_: bool;
    var phi_2976_: bool;
    var phi_2981_: type_40;
    var phi_2982_: bool;
    var phi_2983_: bool;
    var phi_2984_: bool;
    var phi_2985_: bool;
    var phi_2986_: bool;
    var phi_2987_: bool;
    var local_45: f64;
    var phi_2992_: type_40;
    var phi_2993_: bool;
    var phi_2994_: bool;
    var phi_2995_: bool;
    var phi_2996_: bool;
    var phi_2997_: bool;
    var local_46: f64;
    var phi_3002_: type_40;
    var phi_3003_: bool;
    var phi_3004_: bool;
    var phi_3005_: bool;
    var phi_3006_: bool;
    var local_47: f64;
    var phi_3011_: type_40;
    var phi_3012_: bool;
    var phi_3013_: bool;
    var phi_3014_: bool;
    var phi_3015_: bool;
    var phi_3019_: type_40;
    var phi_3020_: bool;
    var phi_3021_: bool;
    var phi_3022_: bool;
    var phi_3026_: bool;
    var phi_3027_: bool;
    var phi_3031_: bool;
    var phi_3032_: bool;
    var phi_3036_: bool;
    var phi_3037_: bool;
    var local_48: f64;
    var phi_3042_: type_40;
    var phi_3043_: bool;
    var phi_3047_: type_40;
    var phi_3061_: type_19;
    var phi_3062_: type_19;
    var phi_3085_: type_19;
    var phi_3106_: f64;
    var phi_3256_: bool;
    var phi_3257_: bool;
    var phi_3258_: bool;
    var phi_3259_: bool;
    var phi_3260_: bool;
    var phi_3261_: bool;
    var phi_3265_: bool;
    var phi_3305_: array<f64, 3>;
    var phi_3306_: bool;
    var phi_3307_: array<f64, 3>;
    var phi_3308_: bool;
    var phi_3341_: f64;
    var phi_3343_: f64;
    var phi_3373_: f64;
    var phi_3375_: f64;
    var phi_3405_: f64;
    var phi_3407_: f64;
    var phi_3440_: f64;
    var phi_3442_: f64;
    var phi_3597_: type_19;
    var phi_3600_: array<f64, 3>;
    var phi_3598_: type_19;
    var phi_3623_: type_19;
    var phi_3690_: array<f64, 3>;
    var phi_3601_: array<f64, 3>;
    var phi_3691_: array<f64, 3>;
    var phi_3723_: type_17;
    var phi_3726_: f64;
    var phi_3747_: bool;
    var phi_3753_: type_18;
    var phi_3724_: type_17;
    var phi_3767_: type_18;
    var phi_3727_: f64;
    var local_49: f64;
    var phi_3716_: f64;
    var phi_3780_: f64;
    var phi_3798_: f64;
    var phi_3805_: f64;
    var phi_3810_: f64;
    var phi_3817_: f64;
    var phi_3822_: f64;
    var phi_3835_: f64;
    var phi_3842_: f64;
    var phi_3847_: f64;
    var phi_3854_: f64;
    var phi_3859_: f64;
    var phi_3864_: f64;
    var phi_3881_: f64;
    var phi_3888_: f64;
    var phi_3893_: f64;
    var phi_3900_: f64;
    var phi_3905_: f64;
    var phi_3919_: f64;
    var phi_3926_: f64;
    var phi_3931_: f64;
    var phi_3938_: f64;
    var phi_3943_: f64;
    var phi_3948_: f64;
    var phi_3965_: f64;
    var phi_3972_: f64;
    var phi_3977_: f64;
    var phi_3984_: f64;
    var phi_3989_: f64;
    var phi_4003_: f64;
    var phi_4010_: f64;
    var phi_4015_: f64;
    var phi_4022_: f64;
    var phi_4027_: f64;
    var phi_4032_: f64;
    var phi_4056_: bool;
    var phi_4057_: bool;
    var phi_4058_: bool;
    var local_50: bool;
    var phi_4063_: type_40;
    var phi_4064_: bool;
    var phi_4069_: type_40;
    var phi_4070_: bool;
    var phi_4072_: type_40;
    var phi_4073_: type_40;
    var phi_4074_: bool;
    var phi_4078_: type_40;
    var phi_7449_: type_40;
    var phi_7450_: type_40;
    var phi_7463_: type_31;
    var phi_7486_: u32;
    var phi_7490_: type_30;
    var phi_7491_: bool;
    var phi_7509_: u32;
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
        phi_232_ = _e129;
    } else {
        phi_232_ = _e131;
    }
    let _e134 = phi_232_;
    let _e135 = (_e134 / 64u);
    if ((_e134 % 64u) > 0u) {
        phi_248_ = (_e135 + 1u);
    } else {
        phi_248_ = _e135;
    }
    let _e140 = phi_248_;
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
            phi_269_ = (_e144 + 1u);
        } else {
            phi_269_ = _e144;
        }
        let _e150 = phi_269_;
        phi_270_ = _e150;
    } else {
        phi_270_ = 0u;
    }
    let _e152 = phi_270_;
    phi_273_ = type_19(0u, _e152);
    loop {
        let _e155 = phi_273_;
        if (_e155.member < _e155.member_1) {
            phi_274_ = type_19((_e155.member + 1u), _e155.member_1);
            phi_297_ = type_19(1u, _e155.member);
        } else {
            phi_274_ = _e155;
            phi_297_ = type_19(0u, type_19().member_1);
        }
        let _e167 = phi_274_;
        let _e169 = phi_297_;
        let _e173 = (bitcast<i32>(_e169.member) != 0i);
        if _e173 {
            let _e177 = (((_e124 + (_e169.member_1 * _e127)) * 64u) + _e112);
            let _e179 = params.member.member_8;
            if (_e177 < _e134) {
                let _e182 = (2u * _e177);
                let _e185 = input.member[(4u + _e182)];
                let _e188 = input.member[(_e182 + 5u)];
                let _e190 = elements.member[_e185];
                let _e192 = elements.member[_e188];
                local_15 = array<u32, 4>(_e190[0], _e190[1], _e192[0], _e192[1]);
                local_16[0u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[1u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[2u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[3u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[0u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[1u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[2u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[3u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                let _e207 = params.member.member_1;
                if ((_e207 & 8u) != 0u) {
                    let _e252 = paths.member[_e190[0]];
                    let _e254 = paths.member[_e190[1]];
                    let _e260 = paths.member[_e192[0]];
                    let _e262 = paths.member[_e192[1]];
                    local_18 = array<array<f32, 3>, 4>(array<f32, 3>(_e252.member[0], _e252.member[1], _e252.member[2]), array<f32, 3>(_e254.member[0], _e254.member[1], _e254.member[2]), array<f32, 3>(_e260.member[0], _e260.member[1], _e260.member[2]), array<f32, 3>(_e262.member[0], _e262.member[1], _e262.member[2]));
                    local_19 = array<array<f32, 3>, 4>(array<f32, 3>(_e252.member_1[0], _e252.member_1[1], _e252.member_1[2]), array<f32, 3>(_e254.member_1[0], _e254.member_1[1], _e254.member_1[2]), array<f32, 3>(_e260.member_1[0], _e260.member_1[1], _e260.member_1[2]), array<f32, 3>(_e262.member_1[0], _e262.member_1[1], _e262.member_1[2]));
                    phi_520_ = type_19(0u, 4u);
                    loop {
                        let _e302 = phi_520_;
                        if (_e302.member < _e302.member_1) {
                            phi_521_ = type_19((_e302.member + 1u), _e302.member_1);
                            phi_544_ = type_19(1u, _e302.member);
                        } else {
                            phi_521_ = _e302;
                            phi_544_ = type_19(0u, type_19().member_1);
                        }
                        let _e314 = phi_521_;
                        let _e316 = phi_544_;
                        let _e320 = (bitcast<i32>(_e316.member) != 0i);
                        if _e320 {
                            phi_554_ = type_19(0u, 3u);
                            loop {
                                let _e322 = phi_554_;
                                if (_e322.member < _e322.member_1) {
                                    phi_555_ = type_19((_e322.member + 1u), _e322.member_1);
                                    phi_578_ = type_19(1u, _e322.member);
                                } else {
                                    phi_555_ = _e322;
                                    phi_578_ = type_19(0u, type_19().member_1);
                                }
                                let _e334 = phi_555_;
                                let _e336 = phi_578_;
                                let _e340 = (bitcast<i32>(_e336.member) != 0i);
                                if _e340 {
                                    let _e343 = local_18[_e316.member_1][_e336.member_1];
                                    local_16[_e316.member_1][_e336.member_1] = f64(_e343);
                                    let _e349 = local_19[_e316.member_1][_e336.member_1];
                                    local_17[_e316.member_1][_e336.member_1] = f64(_e349);
                                }
                                continue;
                                continuing {
                                    phi_554_ = _e334;
                                    break if !(_e340);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_520_ = _e314;
                            break if !(_e320);
                        }
                    }
                } else {
                    phi_640_ = type_19(0u, 4u);
                    loop {
                        let _e211 = phi_640_;
                        if (_e211.member < _e211.member_1) {
                            phi_641_ = type_19((_e211.member + 1u), _e211.member_1);
                            phi_664_ = type_19(1u, _e211.member);
                        } else {
                            phi_641_ = _e211;
                            phi_664_ = type_19(0u, type_19().member_1);
                        }
                        let _e223 = phi_641_;
                        let _e225 = phi_664_;
                        let _e229 = (bitcast<i32>(_e225.member) != 0i);
                        if _e229 {
                            let _e231 = local_15[_e225.member_1];
                            let _e233 = wide.member[_e231];
                            let _e236 = params.member.member[0u];
                            let _e239 = wide.member[(_e236 + _e231)];
                            local_16[_e225.member_1] = array<f64, 3>(_e233[0], _e233[1], _e233[2]);
                            local_17[_e225.member_1] = array<f64, 3>(_e239[0], _e239[1], _e239[2]);
                        }
                        continue;
                        continuing {
                            phi_640_ = _e223;
                            break if !(_e229);
                        }
                    }
                }
                let _e355 = local_16;
                let _e372 = local_17;
                local_20 = type_39(array<array<f64, 3>, 2>(array<f64, 3>((_e355[2][0] - _e355[0][0]), (_e355[2][1] - _e355[0][1]), (_e355[2][2] - _e355[0][2])), array<f64, 3>((_e372[2][0] - _e372[0][0]), (_e372[2][1] - _e372[0][1]), (_e372[2][2] - _e372[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e355[1][0] - _e355[0][0]), (_e355[1][1] - _e355[0][1]), (_e355[1][2] - _e355[0][2])), array<f64, 3>((_e372[1][0] - _e372[0][0]), (_e372[1][1] - _e372[0][1]), (_e372[1][2] - _e372[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e355[2][0] - _e355[3][0]), (_e355[2][1] - _e355[3][1]), (_e355[2][2] - _e355[3][2])), array<f64, 3>((_e372[2][0] - _e372[3][0]), (_e372[2][1] - _e372[3][1]), (_e372[2][2] - _e372[3][2]))), (0.0lf + 0.0lf));
                let _e419 = params.member.member_7;
                let _e426 = bitcast<f64>(((u64(_e419[1]) * 4294967296lu) + u64(_e419[0])));
                let _e427 = f64(0f);
                let _e430 = local_20.member_1[0u];
                let _e436 = local_20.member_2[0u];
                let _e442 = ((_e430[1] * _e436[2]) - (_e430[2] * _e436[1]));
                let _e445 = ((_e430[2] * _e436[0]) - (_e430[0] * _e436[2]));
                let _e448 = ((_e430[0] * _e436[1]) - (_e430[1] * _e436[0]));
                let _e451 = local_20.member_1[1u];
                let _e457 = local_20.member_2[1u];
                let _e463 = ((_e451[1] * _e457[2]) - (_e451[2] * _e457[1]));
                let _e466 = ((_e451[2] * _e457[0]) - (_e451[0] * _e457[2]));
                let _e469 = ((_e451[0] * _e457[1]) - (_e451[1] * _e457[0]));
                let _e472 = local_20.member_1[0u];
                let _e478 = local_20.member_2[1u];
                let _e493 = local_20.member_1[1u];
                let _e499 = local_20.member_2[0u];
                let _e512 = (((_e472[1] * _e478[2]) - (_e472[2] * _e478[1])) + ((_e493[1] * _e499[2]) - (_e493[2] * _e499[1])));
                let _e513 = (((_e472[2] * _e478[0]) - (_e472[0] * _e478[2])) + ((_e493[2] * _e499[0]) - (_e493[0] * _e499[2])));
                let _e514 = (((_e472[0] * _e478[1]) - (_e472[1] * _e478[0])) + ((_e493[0] * _e499[1]) - (_e493[1] * _e499[0])));
                let _e517 = local_20.member[0u];
                let _e525 = (((_e517[0] * _e442) + (_e517[1] * _e445)) + (_e517[2] * _e448));
                let _e528 = local_20.member[1u];
                let _e539 = local_20.member[0u];
                let _e548 = ((((_e528[0] * _e442) + (_e528[1] * _e445)) + (_e528[2] * _e448)) + (((_e539[0] * _e512) + (_e539[1] * _e513)) + (_e539[2] * _e514)));
                let _e551 = local_20.member[0u];
                let _e562 = local_20.member[1u];
                let _e571 = ((((_e551[0] * _e463) + (_e551[1] * _e466)) + (_e551[2] * _e469)) + (((_e562[0] * _e512) + (_e562[1] * _e513)) + (_e562[2] * _e514)));
                let _e574 = local_20.member[1u];
                let _e582 = (((_e574[0] * _e463) + (_e574[1] * _e466)) + (_e574[2] * _e469));
                let _e585 = local_20.member[0u];
                if (_e585[0] < 0.0lf) {
                    phi_1132_ = -(_e585[0]);
                } else {
                    phi_1132_ = _e585[0];
                }
                let _e592 = phi_1132_;
                if (_e585[1] < 0.0lf) {
                    phi_1139_ = -(_e585[1]);
                } else {
                    phi_1139_ = _e585[1];
                }
                let _e596 = phi_1139_;
                if (_e592 > _e596) {
                    phi_1144_ = _e592;
                } else {
                    phi_1144_ = _e596;
                }
                let _e599 = phi_1144_;
                if (_e585[2] < 0.0lf) {
                    phi_1151_ = -(_e585[2]);
                } else {
                    phi_1151_ = _e585[2];
                }
                let _e603 = phi_1151_;
                if (_e599 > _e603) {
                    phi_1156_ = _e599;
                } else {
                    phi_1156_ = _e603;
                }
                let _e606 = phi_1156_;
                let _e609 = local_20.member[1u];
                if (_e609[0] < 0.0lf) {
                    phi_1169_ = -(_e609[0]);
                } else {
                    phi_1169_ = _e609[0];
                }
                let _e616 = phi_1169_;
                if (_e609[1] < 0.0lf) {
                    phi_1176_ = -(_e609[1]);
                } else {
                    phi_1176_ = _e609[1];
                }
                let _e620 = phi_1176_;
                if (_e616 > _e620) {
                    phi_1181_ = _e616;
                } else {
                    phi_1181_ = _e620;
                }
                let _e623 = phi_1181_;
                if (_e609[2] < 0.0lf) {
                    phi_1188_ = -(_e609[2]);
                } else {
                    phi_1188_ = _e609[2];
                }
                let _e627 = phi_1188_;
                if (_e623 > _e627) {
                    phi_1193_ = _e623;
                } else {
                    phi_1193_ = _e627;
                }
                let _e630 = phi_1193_;
                if (_e606 > _e630) {
                    phi_1198_ = _e606;
                } else {
                    phi_1198_ = _e630;
                }
                let _e633 = phi_1198_;
                let _e635 = local_20.member_3;
                let _e636 = (_e633 + _e635);
                let _e639 = local_20.member_1[0u];
                if (_e639[0] < 0.0lf) {
                    phi_1215_ = -(_e639[0]);
                } else {
                    phi_1215_ = _e639[0];
                }
                let _e646 = phi_1215_;
                if (_e639[1] < 0.0lf) {
                    phi_1222_ = -(_e639[1]);
                } else {
                    phi_1222_ = _e639[1];
                }
                let _e650 = phi_1222_;
                if (_e646 > _e650) {
                    phi_1227_ = _e646;
                } else {
                    phi_1227_ = _e650;
                }
                let _e653 = phi_1227_;
                if (_e639[2] < 0.0lf) {
                    phi_1234_ = -(_e639[2]);
                } else {
                    phi_1234_ = _e639[2];
                }
                let _e657 = phi_1234_;
                if (_e653 > _e657) {
                    phi_1239_ = _e653;
                } else {
                    phi_1239_ = _e657;
                }
                let _e660 = phi_1239_;
                let _e663 = local_20.member_1[1u];
                if (_e663[0] < 0.0lf) {
                    phi_1253_ = -(_e663[0]);
                } else {
                    phi_1253_ = _e663[0];
                }
                let _e670 = phi_1253_;
                if (_e663[1] < 0.0lf) {
                    phi_1260_ = -(_e663[1]);
                } else {
                    phi_1260_ = _e663[1];
                }
                let _e674 = phi_1260_;
                if (_e670 > _e674) {
                    phi_1265_ = _e670;
                } else {
                    phi_1265_ = _e674;
                }
                let _e677 = phi_1265_;
                if (_e663[2] < 0.0lf) {
                    phi_1272_ = -(_e663[2]);
                } else {
                    phi_1272_ = _e663[2];
                }
                let _e681 = phi_1272_;
                if (_e677 > _e681) {
                    phi_1277_ = _e677;
                } else {
                    phi_1277_ = _e681;
                }
                let _e684 = phi_1277_;
                if (_e660 > _e684) {
                    phi_1282_ = _e660;
                } else {
                    phi_1282_ = _e684;
                }
                let _e687 = phi_1282_;
                let _e689 = local_20.member_3;
                let _e690 = (_e687 + _e689);
                let _e693 = local_20.member_2[0u];
                if (_e693[0] < 0.0lf) {
                    phi_1299_ = -(_e693[0]);
                } else {
                    phi_1299_ = _e693[0];
                }
                let _e700 = phi_1299_;
                if (_e693[1] < 0.0lf) {
                    phi_1306_ = -(_e693[1]);
                } else {
                    phi_1306_ = _e693[1];
                }
                let _e704 = phi_1306_;
                if (_e700 > _e704) {
                    phi_1311_ = _e700;
                } else {
                    phi_1311_ = _e704;
                }
                let _e707 = phi_1311_;
                if (_e693[2] < 0.0lf) {
                    phi_1318_ = -(_e693[2]);
                } else {
                    phi_1318_ = _e693[2];
                }
                let _e711 = phi_1318_;
                if (_e707 > _e711) {
                    phi_1323_ = _e707;
                } else {
                    phi_1323_ = _e711;
                }
                let _e714 = phi_1323_;
                let _e717 = local_20.member_2[1u];
                if (_e717[0] < 0.0lf) {
                    phi_1337_ = -(_e717[0]);
                } else {
                    phi_1337_ = _e717[0];
                }
                let _e724 = phi_1337_;
                if (_e717[1] < 0.0lf) {
                    phi_1344_ = -(_e717[1]);
                } else {
                    phi_1344_ = _e717[1];
                }
                let _e728 = phi_1344_;
                if (_e724 > _e728) {
                    phi_1349_ = _e724;
                } else {
                    phi_1349_ = _e728;
                }
                let _e731 = phi_1349_;
                if (_e717[2] < 0.0lf) {
                    phi_1356_ = -(_e717[2]);
                } else {
                    phi_1356_ = _e717[2];
                }
                let _e735 = phi_1356_;
                if (_e731 > _e735) {
                    phi_1361_ = _e731;
                } else {
                    phi_1361_ = _e735;
                }
                let _e738 = phi_1361_;
                if (_e714 > _e738) {
                    phi_1366_ = _e714;
                } else {
                    phi_1366_ = _e738;
                }
                let _e741 = phi_1366_;
                let _e743 = local_20.member_3;
                let _e744 = (_e741 + _e743);
                let _e745 = f64(1f);
                let _e746 = f64(8f);
                let _e748 = ((_e690 * _e746) * _e744);
                let _e756 = local_20.member_3;
                if (_e442 < 0.0lf) {
                    phi_1403_ = -(_e442);
                } else {
                    phi_1403_ = _e442;
                }
                let _e776 = phi_1403_;
                if (_e445 < 0.0lf) {
                    phi_1409_ = -(_e445);
                } else {
                    phi_1409_ = _e445;
                }
                let _e780 = phi_1409_;
                if (_e448 < 0.0lf) {
                    phi_1416_ = -(_e448);
                } else {
                    phi_1416_ = _e448;
                }
                let _e785 = phi_1416_;
                let _e786 = ((_e776 + _e780) + _e785);
                if (_e463 < 0.0lf) {
                    phi_1423_ = -(_e463);
                } else {
                    phi_1423_ = _e463;
                }
                let _e790 = phi_1423_;
                if (_e466 < 0.0lf) {
                    phi_1429_ = -(_e466);
                } else {
                    phi_1429_ = _e466;
                }
                let _e794 = phi_1429_;
                if (_e469 < 0.0lf) {
                    phi_1436_ = -(_e469);
                } else {
                    phi_1436_ = _e469;
                }
                let _e799 = phi_1436_;
                let _e800 = ((_e790 + _e794) + _e799);
                if (_e786 > _e800) {
                    phi_1442_ = _e786;
                } else {
                    phi_1442_ = _e800;
                }
                let _e803 = phi_1442_;
                if (_e512 < 0.0lf) {
                    phi_1448_ = -(_e512);
                } else {
                    phi_1448_ = _e512;
                }
                let _e807 = phi_1448_;
                if (_e513 < 0.0lf) {
                    phi_1454_ = -(_e513);
                } else {
                    phi_1454_ = _e513;
                }
                let _e811 = phi_1454_;
                if (_e514 < 0.0lf) {
                    phi_1461_ = -(_e514);
                } else {
                    phi_1461_ = _e514;
                }
                let _e816 = phi_1461_;
                let _e818 = (((_e807 + _e811) + _e816) * f64(0.5f));
                if (_e803 > _e818) {
                    phi_1468_ = _e803;
                } else {
                    phi_1468_ = _e818;
                }
                let _e821 = phi_1468_;
                let _e827 = local_20.member_3;
                let _e841 = (((((_e636 * _e746) * _e748) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e756 * f64(19f)) * ((_e636 * (_e690 + _e744)) + (_e690 * _e744)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e745 + _e636) * ((_e745 + _e690) * (_e745 + _e744)))));
                let _e842 = f64(3f);
                let _e843 = (_e525 * _e842);
                let _e844 = (_e582 * _e842);
                if (_e843 < _e844) {
                    phi_1496_ = _e843;
                } else {
                    phi_1496_ = _e844;
                }
                let _e847 = phi_1496_;
                if (_e548 < _e571) {
                    phi_1501_ = _e548;
                } else {
                    phi_1501_ = _e571;
                }
                let _e850 = phi_1501_;
                if (_e847 < _e850) {
                    phi_1506_ = _e847;
                } else {
                    phi_1506_ = _e850;
                }
                let _e853 = phi_1506_;
                if (_e843 > _e844) {
                    phi_1511_ = _e843;
                } else {
                    phi_1511_ = _e844;
                }
                let _e856 = phi_1511_;
                if (_e548 > _e571) {
                    phi_1516_ = _e548;
                } else {
                    phi_1516_ = _e571;
                }
                let _e859 = phi_1516_;
                if (_e856 > _e859) {
                    phi_1521_ = _e856;
                } else {
                    phi_1521_ = _e859;
                }
                let _e862 = phi_1521_;
                let _e868 = -(_e862);
                if (_e853 > _e868) {
                    phi_1532_ = _e853;
                } else {
                    phi_1532_ = _e868;
                }
                let _e871 = phi_1532_;
                if ((_e871 - (_e841 + ((_e426 * (((_e821 + (_e748 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e827 * f64(6f)) * (_e690 + _e744))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e745 + _e690) * (_e745 + _e744))))) * f64((3f * 1.0001f))))) > _e427) {
                    phi_7450_ = type_40(0u, type_40().member_1);
                } else {
                    if (_e426 > _e427) {
                        let _e3233 = f64(1f);
                        let _e3237 = local_20.member[0u];
                        let _e3243 = local_20.member_1[0u];
                        let _e3249 = local_20.member_2[0u];
                        let _e3253 = (_e3237[0] - _e3243[0]);
                        let _e3254 = (_e3237[1] - _e3243[1]);
                        let _e3255 = (_e3237[2] - _e3243[2]);
                        local_12 = array<array<f64, 3>, 4>(_e3237, array<f64, 3>(_e3253, _e3254, _e3255), array<f64, 3>((_e3237[0] - _e3249[0]), (_e3237[1] - _e3249[1]), (_e3237[2] - _e3249[2])), array<f64, 3>((_e3253 - _e3249[0]), (_e3254 - _e3249[1]), (_e3255 - _e3249[2])));
                        let _e3268 = local_20.member[1u];
                        let _e3274 = local_20.member_1[1u];
                        let _e3280 = local_20.member_2[1u];
                        let _e3284 = (_e3268[0] - _e3274[0]);
                        let _e3285 = (_e3268[1] - _e3274[1]);
                        let _e3286 = (_e3268[2] - _e3274[2]);
                        local_13 = array<array<f64, 3>, 4>(_e3268, array<f64, 3>(_e3284, _e3285, _e3286), array<f64, 3>((_e3268[0] - _e3280[0]), (_e3268[1] - _e3280[1]), (_e3268[2] - _e3280[2])), array<f64, 3>((_e3284 - _e3280[0]), (_e3285 - _e3280[1]), (_e3286 - _e3280[2])));
                        let _e3299 = local_20.member[0u];
                        if (_e3299[0] < 0.0lf) {
                            phi_1735_ = -(_e3299[0]);
                        } else {
                            phi_1735_ = _e3299[0];
                        }
                        let _e3306 = phi_1735_;
                        if (_e3299[1] < 0.0lf) {
                            phi_1742_ = -(_e3299[1]);
                        } else {
                            phi_1742_ = _e3299[1];
                        }
                        let _e3310 = phi_1742_;
                        if (_e3306 > _e3310) {
                            phi_1747_ = _e3306;
                        } else {
                            phi_1747_ = _e3310;
                        }
                        let _e3313 = phi_1747_;
                        if (_e3299[2] < 0.0lf) {
                            phi_1754_ = -(_e3299[2]);
                        } else {
                            phi_1754_ = _e3299[2];
                        }
                        let _e3317 = phi_1754_;
                        if (_e3313 > _e3317) {
                            phi_1759_ = _e3313;
                        } else {
                            phi_1759_ = _e3317;
                        }
                        let _e3320 = phi_1759_;
                        let _e3323 = local_20.member[1u];
                        if (_e3323[0] < 0.0lf) {
                            phi_1772_ = -(_e3323[0]);
                        } else {
                            phi_1772_ = _e3323[0];
                        }
                        let _e3330 = phi_1772_;
                        if (_e3323[1] < 0.0lf) {
                            phi_1779_ = -(_e3323[1]);
                        } else {
                            phi_1779_ = _e3323[1];
                        }
                        let _e3334 = phi_1779_;
                        if (_e3330 > _e3334) {
                            phi_1784_ = _e3330;
                        } else {
                            phi_1784_ = _e3334;
                        }
                        let _e3337 = phi_1784_;
                        if (_e3323[2] < 0.0lf) {
                            phi_1791_ = -(_e3323[2]);
                        } else {
                            phi_1791_ = _e3323[2];
                        }
                        let _e3341 = phi_1791_;
                        if (_e3337 > _e3341) {
                            phi_1796_ = _e3337;
                        } else {
                            phi_1796_ = _e3341;
                        }
                        let _e3344 = phi_1796_;
                        if (_e3320 > _e3344) {
                            phi_1801_ = _e3320;
                        } else {
                            phi_1801_ = _e3344;
                        }
                        let _e3347 = phi_1801_;
                        let _e3349 = local_20.member_3;
                        let _e3353 = local_20.member_1[0u];
                        if (_e3353[0] < 0.0lf) {
                            phi_1818_ = -(_e3353[0]);
                        } else {
                            phi_1818_ = _e3353[0];
                        }
                        let _e3360 = phi_1818_;
                        if (_e3353[1] < 0.0lf) {
                            phi_1825_ = -(_e3353[1]);
                        } else {
                            phi_1825_ = _e3353[1];
                        }
                        let _e3364 = phi_1825_;
                        if (_e3360 > _e3364) {
                            phi_1830_ = _e3360;
                        } else {
                            phi_1830_ = _e3364;
                        }
                        let _e3367 = phi_1830_;
                        if (_e3353[2] < 0.0lf) {
                            phi_1837_ = -(_e3353[2]);
                        } else {
                            phi_1837_ = _e3353[2];
                        }
                        let _e3371 = phi_1837_;
                        if (_e3367 > _e3371) {
                            phi_1842_ = _e3367;
                        } else {
                            phi_1842_ = _e3371;
                        }
                        let _e3374 = phi_1842_;
                        let _e3377 = local_20.member_1[1u];
                        if (_e3377[0] < 0.0lf) {
                            phi_1856_ = -(_e3377[0]);
                        } else {
                            phi_1856_ = _e3377[0];
                        }
                        let _e3384 = phi_1856_;
                        if (_e3377[1] < 0.0lf) {
                            phi_1863_ = -(_e3377[1]);
                        } else {
                            phi_1863_ = _e3377[1];
                        }
                        let _e3388 = phi_1863_;
                        if (_e3384 > _e3388) {
                            phi_1868_ = _e3384;
                        } else {
                            phi_1868_ = _e3388;
                        }
                        let _e3391 = phi_1868_;
                        if (_e3377[2] < 0.0lf) {
                            phi_1875_ = -(_e3377[2]);
                        } else {
                            phi_1875_ = _e3377[2];
                        }
                        let _e3395 = phi_1875_;
                        if (_e3391 > _e3395) {
                            phi_1880_ = _e3391;
                        } else {
                            phi_1880_ = _e3395;
                        }
                        let _e3398 = phi_1880_;
                        if (_e3374 > _e3398) {
                            phi_1885_ = _e3374;
                        } else {
                            phi_1885_ = _e3398;
                        }
                        let _e3401 = phi_1885_;
                        let _e3403 = local_20.member_3;
                        let _e3407 = local_20.member_2[0u];
                        if (_e3407[0] < 0.0lf) {
                            phi_1902_ = -(_e3407[0]);
                        } else {
                            phi_1902_ = _e3407[0];
                        }
                        let _e3414 = phi_1902_;
                        if (_e3407[1] < 0.0lf) {
                            phi_1909_ = -(_e3407[1]);
                        } else {
                            phi_1909_ = _e3407[1];
                        }
                        let _e3418 = phi_1909_;
                        if (_e3414 > _e3418) {
                            phi_1914_ = _e3414;
                        } else {
                            phi_1914_ = _e3418;
                        }
                        let _e3421 = phi_1914_;
                        if (_e3407[2] < 0.0lf) {
                            phi_1921_ = -(_e3407[2]);
                        } else {
                            phi_1921_ = _e3407[2];
                        }
                        let _e3425 = phi_1921_;
                        if (_e3421 > _e3425) {
                            phi_1926_ = _e3421;
                        } else {
                            phi_1926_ = _e3425;
                        }
                        let _e3428 = phi_1926_;
                        let _e3431 = local_20.member_2[1u];
                        if (_e3431[0] < 0.0lf) {
                            phi_1940_ = -(_e3431[0]);
                        } else {
                            phi_1940_ = _e3431[0];
                        }
                        let _e3438 = phi_1940_;
                        if (_e3431[1] < 0.0lf) {
                            phi_1947_ = -(_e3431[1]);
                        } else {
                            phi_1947_ = _e3431[1];
                        }
                        let _e3442 = phi_1947_;
                        if (_e3438 > _e3442) {
                            phi_1952_ = _e3438;
                        } else {
                            phi_1952_ = _e3442;
                        }
                        let _e3445 = phi_1952_;
                        if (_e3431[2] < 0.0lf) {
                            phi_1959_ = -(_e3431[2]);
                        } else {
                            phi_1959_ = _e3431[2];
                        }
                        let _e3449 = phi_1959_;
                        if (_e3445 > _e3449) {
                            phi_1964_ = _e3445;
                        } else {
                            phi_1964_ = _e3449;
                        }
                        let _e3452 = phi_1964_;
                        if (_e3428 > _e3452) {
                            phi_1969_ = _e3428;
                        } else {
                            phi_1969_ = _e3452;
                        }
                        let _e3455 = phi_1969_;
                        let _e3457 = local_20.member_3;
                        let _e3465 = local_20.member_3;
                        phi_1989_ = type_19(0u, 48u);
                        phi_1992_ = f64(0f);
                        loop {
                            let _e3474 = phi_1989_;
                            let _e3476 = phi_1992_;
                            local_87 = _e3476;
                            local_45 = _e3476;
                            local_46 = _e3476;
                            local_47 = _e3476;
                            local_48 = _e3476;
                            if (_e3474.member < _e3474.member_1) {
                                phi_1990_ = type_19((_e3474.member + 1u), _e3474.member_1);
                                phi_2015_ = type_19(1u, _e3474.member);
                            } else {
                                phi_1990_ = _e3474;
                                phi_2015_ = type_19(0u, type_19().member_1);
                            }
                            let _e3488 = phi_1990_;
                            let _e3490 = phi_2015_;
                            if (bitcast<i32>(_e3490.member) != 0i) {
                                let _e3496 = local_20.member[0u];
                                let _e3502 = local_20.member[1u];
                                let _e3512 = (_e3496[0] + ((_e3502[0] - _e3496[0]) * _e3476));
                                let _e3513 = (_e3496[1] + ((_e3502[1] - _e3496[1]) * _e3476));
                                let _e3514 = (_e3496[2] + ((_e3502[2] - _e3496[2]) * _e3476));
                                let _e3517 = local_20.member_1[0u];
                                let _e3523 = local_20.member_1[1u];
                                let _e3533 = (_e3517[0] + ((_e3523[0] - _e3517[0]) * _e3476));
                                let _e3534 = (_e3517[1] + ((_e3523[1] - _e3517[1]) * _e3476));
                                let _e3535 = (_e3517[2] + ((_e3523[2] - _e3517[2]) * _e3476));
                                let _e3538 = local_20.member_2[0u];
                                let _e3544 = local_20.member_2[1u];
                                let _e3554 = (_e3538[0] + ((_e3544[0] - _e3538[0]) * _e3476));
                                let _e3555 = (_e3538[1] + ((_e3544[1] - _e3538[1]) * _e3476));
                                let _e3556 = (_e3538[2] + ((_e3544[2] - _e3538[2]) * _e3476));
                                let _e3561 = (((_e3533 * _e3533) + (_e3534 * _e3534)) + (_e3535 * _e3535));
                                let _e3566 = (((_e3533 * _e3554) + (_e3534 * _e3555)) + (_e3535 * _e3556));
                                let _e3571 = (((_e3554 * _e3554) + (_e3555 * _e3555)) + (_e3556 * _e3556));
                                let _e3576 = (((_e3512 * _e3533) + (_e3513 * _e3534)) + (_e3514 * _e3535));
                                let _e3581 = (((_e3512 * _e3554) + (_e3513 * _e3555)) + (_e3514 * _e3556));
                                let _e3584 = ((_e3561 * _e3571) - (_e3566 * _e3566));
                                let _e3585 = f64(0f);
                                let _e3586 = f64(1f);
                                let _e3590 = (((_e3576 * _e3571) - (_e3581 * _e3566)) / _e3584);
                                let _e3594 = (((_e3581 * _e3561) - (_e3576 * _e3566)) / _e3584);
                                if (_e3590 >= _e3585) {
                                    if (_e3594 >= _e3585) {
                                        if (_e3590 <= _e3586) {
                                            phi_2171_ = (_e3594 <= _e3586);
                                            phi_2172_ = false;
                                        } else {
                                            phi_2171_ = bool();
                                            phi_2172_ = true;
                                        }
                                        let _e3600 = phi_2171_;
                                        let _e3602 = phi_2172_;
                                        phi_2173_ = _e3600;
                                        phi_2174_ = _e3602;
                                    } else {
                                        phi_2173_ = bool();
                                        phi_2174_ = true;
                                    }
                                    let _e3604 = phi_2173_;
                                    let _e3606 = phi_2174_;
                                    phi_2175_ = _e3604;
                                    phi_2176_ = _e3606;
                                } else {
                                    phi_2175_ = bool();
                                    phi_2176_ = true;
                                }
                                let _e3608 = phi_2175_;
                                let _e3610 = phi_2176_;
                                if _e3610 {
                                    phi_2180_ = false;
                                } else {
                                    phi_2180_ = _e3608;
                                }
                                let _e3612 = phi_2180_;
                                if (_e3584 > _e3585) {
                                    if _e3612 {
                                        phi_2220_ = array<f64, 3>((_e3512 - ((_e3533 * _e3590) + (_e3554 * _e3594))), (_e3513 - ((_e3534 * _e3590) + (_e3555 * _e3594))), (_e3514 - ((_e3535 * _e3590) + (_e3556 * _e3594))));
                                        phi_2221_ = false;
                                    } else {
                                        phi_2220_ = array<f64, 3>();
                                        phi_2221_ = true;
                                    }
                                    let _e3628 = phi_2220_;
                                    let _e3630 = phi_2221_;
                                    phi_2222_ = _e3628;
                                    phi_2223_ = _e3630;
                                } else {
                                    phi_2222_ = array<f64, 3>();
                                    phi_2223_ = true;
                                }
                                let _e3632 = phi_2222_;
                                let _e3634 = phi_2223_;
                                if _e3634 {
                                    let _e3635 = (_e3512 - _e3533);
                                    let _e3636 = (_e3513 - _e3534);
                                    let _e3637 = (_e3514 - _e3535);
                                    let _e3648 = ((((_e3512 * _e3533) + (_e3513 * _e3534)) + (_e3514 * _e3535)) / (((_e3533 * _e3533) + (_e3534 * _e3534)) + (_e3535 * _e3535)));
                                    if (_e3648 > f64(0f)) {
                                        if (_e3648 < f64(1f)) {
                                            phi_2256_ = _e3648;
                                        } else {
                                            phi_2256_ = f64(1f);
                                        }
                                        let _e3656 = phi_2256_;
                                        phi_2258_ = _e3656;
                                    } else {
                                        phi_2258_ = f64(0f);
                                    }
                                    let _e3658 = phi_2258_;
                                    let _e3675 = ((((_e3512 * _e3554) + (_e3513 * _e3555)) + (_e3514 * _e3556)) / (((_e3554 * _e3554) + (_e3555 * _e3555)) + (_e3556 * _e3556)));
                                    if (_e3675 > f64(0f)) {
                                        if (_e3675 < f64(1f)) {
                                            phi_2288_ = _e3675;
                                        } else {
                                            phi_2288_ = f64(1f);
                                        }
                                        let _e3683 = phi_2288_;
                                        phi_2290_ = _e3683;
                                    } else {
                                        phi_2290_ = f64(0f);
                                    }
                                    let _e3685 = phi_2290_;
                                    let _e3702 = ((((_e3635 * _e3554) + (_e3636 * _e3555)) + (_e3637 * _e3556)) / (((_e3554 * _e3554) + (_e3555 * _e3555)) + (_e3556 * _e3556)));
                                    if (_e3702 > f64(0f)) {
                                        if (_e3702 < f64(1f)) {
                                            phi_2320_ = _e3702;
                                        } else {
                                            phi_2320_ = f64(1f);
                                        }
                                        let _e3710 = phi_2320_;
                                        phi_2322_ = _e3710;
                                    } else {
                                        phi_2322_ = f64(0f);
                                    }
                                    let _e3712 = phi_2322_;
                                    let _e3719 = (_e3512 - _e3554);
                                    let _e3720 = (_e3513 - _e3555);
                                    let _e3721 = (_e3514 - _e3556);
                                    let _e3732 = ((((_e3719 * _e3533) + (_e3720 * _e3534)) + (_e3721 * _e3535)) / (((_e3533 * _e3533) + (_e3534 * _e3534)) + (_e3535 * _e3535)));
                                    if (_e3732 > f64(0f)) {
                                        if (_e3732 < f64(1f)) {
                                            phi_2355_ = _e3732;
                                        } else {
                                            phi_2355_ = f64(1f);
                                        }
                                        let _e3740 = phi_2355_;
                                        phi_2357_ = _e3740;
                                    } else {
                                        phi_2357_ = f64(0f);
                                    }
                                    let _e3742 = phi_2357_;
                                    local_11[0u] = array<f64, 3>((_e3512 - (_e3533 * _e3658)), (_e3513 - (_e3534 * _e3658)), (_e3514 - (_e3535 * _e3658)));
                                    local_11[1u] = array<f64, 3>((_e3512 - (_e3554 * _e3685)), (_e3513 - (_e3555 * _e3685)), (_e3514 - (_e3556 * _e3685)));
                                    local_11[2u] = array<f64, 3>((_e3635 - (_e3554 * _e3712)), (_e3636 - (_e3555 * _e3712)), (_e3637 - (_e3556 * _e3712)));
                                    local_11[3u] = array<f64, 3>((_e3719 - (_e3533 * _e3742)), (_e3720 - (_e3534 * _e3742)), (_e3721 - (_e3535 * _e3742)));
                                    let _e3758 = local_11[0u];
                                    phi_2512_ = type_19(1u, 4u);
                                    phi_2515_ = array<f64, 3>(_e3758[0], _e3758[1], _e3758[2]);
                                    loop {
                                        let _e3764 = phi_2512_;
                                        let _e3766 = phi_2515_;
                                        local_74 = _e3766;
                                        if (_e3764.member < _e3764.member_1) {
                                            phi_2513_ = type_19((_e3764.member + 1u), _e3764.member_1);
                                            phi_2538_ = type_19(1u, _e3764.member);
                                        } else {
                                            phi_2513_ = _e3764;
                                            phi_2538_ = type_19(0u, type_19().member_1);
                                        }
                                        let _e3778 = phi_2513_;
                                        let _e3780 = phi_2538_;
                                        let _e3784 = (bitcast<i32>(_e3780.member) != 0i);
                                        if _e3784 {
                                            let _e3786 = local_11[_e3780.member_1];
                                            let _e3791 = local_11[_e3780.member_1];
                                            if ((((_e3786[0] * _e3791[0]) + (_e3786[1] * _e3791[1])) + (_e3786[2] * _e3791[2])) < (((_e3766[0] * _e3766[0]) + (_e3766[1] * _e3766[1])) + (_e3766[2] * _e3766[2]))) {
                                                let _e3813 = local_11[_e3780.member_1];
                                                phi_2605_ = array<f64, 3>(_e3813[0], _e3813[1], _e3813[2]);
                                            } else {
                                                phi_2605_ = _e3766;
                                            }
                                            let _e3819 = phi_2605_;
                                            phi_2516_ = _e3819;
                                        } else {
                                            phi_2516_ = array<f64, 3>();
                                        }
                                        let _e3821 = phi_2516_;
                                        continue;
                                        continuing {
                                            phi_2512_ = _e3778;
                                            phi_2515_ = _e3821;
                                            break if !(_e3784);
                                        }
                                    }
                                    let _e5608 = local_74;
                                    phi_2606_ = _e5608;
                                } else {
                                    phi_2606_ = _e3632;
                                }
                                let _e3824 = phi_2606_;
                                if (_e3824[0] < 0.0lf) {
                                    phi_2613_ = -(_e3824[0]);
                                } else {
                                    phi_2613_ = _e3824[0];
                                }
                                let _e3829 = phi_2613_;
                                if (_e3824[1] < 0.0lf) {
                                    phi_2620_ = -(_e3824[1]);
                                } else {
                                    phi_2620_ = _e3824[1];
                                }
                                let _e3834 = phi_2620_;
                                if (_e3824[2] < 0.0lf) {
                                    phi_2628_ = -(_e3824[2]);
                                } else {
                                    phi_2628_ = _e3824[2];
                                }
                                let _e3840 = phi_2628_;
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
                                                phi_2666_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2666_ = 0.0lf;
                                            }
                                            let _e3910 = phi_2666_;
                                            phi_2730_ = _e3910;
                                        } else {
                                            phi_2673_ = type_17(0i, 5i);
                                            phi_2676_ = bitcast<f64>(((bitcast<u64>(_e3858) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e3865 = phi_2673_;
                                                let _e3867 = phi_2676_;
                                                local_39 = _e3867;
                                                if (_e3865.member < _e3865.member_1) {
                                                    let _e3874 = (_e3865.member + 1i);
                                                    if ((false == (_e3874 > _e3865.member)) != false) {
                                                        phi_2697_ = true;
                                                    } else {
                                                        phi_2697_ = false;
                                                    }
                                                    let _e3879 = phi_2697_;
                                                    if _e3879 {
                                                        phi_2703_ = type_18(0u, type_18().member_1);
                                                    } else {
                                                        phi_2703_ = type_18(1u, _e3874);
                                                    }
                                                    let _e3884 = phi_2703_;
                                                    phi_2674_ = type_17(_e3884.member_1, _e3865.member_1);
                                                    phi_2717_ = type_18(1u, _e3865.member);
                                                } else {
                                                    phi_2674_ = _e3865;
                                                    phi_2717_ = type_18(0u, type_18().member_1);
                                                }
                                                let _e3890 = phi_2674_;
                                                let _e3892 = phi_2717_;
                                                let _e3895 = (bitcast<i32>(_e3892.member) != 0i);
                                                if _e3895 {
                                                    phi_2677_ = (0.5lf * (_e3867 + (_e3858 / _e3867)));
                                                } else {
                                                    phi_2677_ = f64();
                                                }
                                                let _e3900 = phi_2677_;
                                                continue;
                                                continuing {
                                                    phi_2673_ = _e3890;
                                                    phi_2676_ = _e3900;
                                                    break if !(_e3895);
                                                }
                                            }
                                            let _e3905 = local_39;
                                            phi_2730_ = (_e3905 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e3912 = phi_2730_;
                                        phi_2743_ = type_19(0u, 4u);
                                        phi_2746_ = f64(2f);
                                        loop {
                                            let _e3924 = phi_2743_;
                                            let _e3926 = phi_2746_;
                                            local_41 = _e3926;
                                            local_42 = _e3926;
                                            local_43 = _e3926;
                                            local_77 = _e3926;
                                            local_78 = _e3926;
                                            if (_e3924.member < _e3924.member_1) {
                                                phi_2744_ = type_19((_e3924.member + 1u), _e3924.member_1);
                                                phi_2769_ = type_19(1u, _e3924.member);
                                            } else {
                                                phi_2744_ = _e3924;
                                                phi_2769_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e3938 = phi_2744_;
                                            let _e3940 = phi_2769_;
                                            if (bitcast<i32>(_e3940.member) != 0i) {
                                                let _e3946 = local_12[_e3940.member_1];
                                                let _e3954 = (((_e3849 * _e3946[0]) + (_e3851 * _e3946[1])) + (_e3853 * _e3946[2]));
                                                let _e3956 = local_13[_e3940.member_1];
                                                let _e3964 = (((_e3849 * _e3956[0]) + (_e3851 * _e3956[1])) + (_e3853 * _e3956[2]));
                                                if (_e3954 < 0.0lf) {
                                                    phi_2820_ = -(_e3954);
                                                } else {
                                                    phi_2820_ = _e3954;
                                                }
                                                let _e3968 = phi_2820_;
                                                if (_e3964 < 0.0lf) {
                                                    phi_2826_ = -(_e3964);
                                                } else {
                                                    phi_2826_ = _e3964;
                                                }
                                                let _e3972 = phi_2826_;
                                                let _e3977 = (((((((((_e3347 + _e3349) + (_e3401 + _e3403)) + (_e3455 + _e3457)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3465 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e426 * _e3912) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e3968 + _e3972) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e3954 > _e3977) {
                                                    if (_e3964 > _e3977) {
                                                        phi_2840_ = false;
                                                    } else {
                                                        phi_2840_ = true;
                                                    }
                                                    let _e3981 = phi_2840_;
                                                    phi_2841_ = _e3981;
                                                } else {
                                                    phi_2841_ = true;
                                                }
                                                let _e3983 = phi_2841_;
                                                if _e3983 {
                                                    if ((_e3954 + ((_e3964 - _e3954) * _e3476)) > _e3977) {
                                                        if (_e3964 < _e3954) {
                                                            let _e3992 = ((_e3954 - _e3964) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                            if _e3992 {
                                                                let _e4000 = (((_e3954 - _e3977) / (_e3954 - _e3964)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                if (_e3926 < _e4000) {
                                                                    phi_2875_ = _e3926;
                                                                } else {
                                                                    phi_2875_ = _e4000;
                                                                }
                                                                let _e4003 = phi_2875_;
                                                                phi_2876_ = _e4003;
                                                            } else {
                                                                phi_2876_ = f64();
                                                            }
                                                            let _e4005 = phi_2876_;
                                                            phi_2877_ = _e4005;
                                                            phi_2878_ = _e3992;
                                                        } else {
                                                            phi_2877_ = _e3926;
                                                            phi_2878_ = true;
                                                        }
                                                        let _e4007 = phi_2877_;
                                                        let _e4009 = phi_2878_;
                                                        if _e4009 {
                                                            phi_2882_ = false;
                                                        } else {
                                                            phi_2882_ = true;
                                                        }
                                                        let _e4011 = phi_2882_;
                                                        phi_2883_ = _e4007;
                                                        phi_2884_ = _e4009;
                                                        phi_2885_ = _e4011;
                                                        phi_2886_ = false;
                                                    } else {
                                                        phi_2883_ = f64();
                                                        phi_2884_ = false;
                                                        phi_2885_ = false;
                                                        phi_2886_ = true;
                                                    }
                                                    let _e4013 = phi_2883_;
                                                    let _e4015 = phi_2884_;
                                                    let _e4017 = phi_2885_;
                                                    let _e4019 = phi_2886_;
                                                    phi_2887_ = _e4013;
                                                    phi_2888_ = _e4015;
                                                    phi_2889_ = _e4017;
                                                    phi_2890_ = _e4019;
                                                } else {
                                                    phi_2887_ = _e3926;
                                                    phi_2888_ = true;
                                                    phi_2889_ = false;
                                                    phi_2890_ = false;
                                                }
                                                let _e4021 = phi_2887_;
                                                let _e4023 = phi_2888_;
                                                let _e4025 = phi_2889_;
                                                let _e4027 = phi_2890_;
                                                phi_2747_ = _e4021;
                                                phi_2891_ = _e4023;
                                                phi_2892_ = false;
                                                phi_2893_ = _e4025;
                                                phi_2894_ = _e4027;
                                            } else {
                                                phi_2747_ = f64();
                                                phi_2891_ = false;
                                                phi_2892_ = true;
                                                phi_2893_ = false;
                                                phi_2894_ = false;
                                            }
                                            let _e4029 = phi_2747_;
                                            let _e4031 = phi_2891_;
                                            let _e4033 = phi_2892_;
                                            let _e4035 = phi_2893_;
                                            let _e4037 = phi_2894_;
                                            local_40 = _e4033;
                                            local_75 = _e4035;
                                            local_76 = _e4037;
                                            continue;
                                            continuing {
                                                phi_2743_ = _e3938;
                                                phi_2746_ = _e4029;
                                                break if !(_e4031);
                                            }
                                        }
                                        let _e4040 = local_40;
                                        if _e4040 {
                                            let _e4042 = local_41;
                                            let _e4043 = (_e4042 > _e3233);
                                            if _e4043 {
                                                phi_2916_ = false;
                                                phi_2917_ = false;
                                                phi_2918_ = false;
                                            } else {
                                                let _e4045 = local_42;
                                                if (_e4045 > _e3476) {
                                                    let _e4048 = local_43;
                                                    let _e4051 = ((_e4048 - _e3476) < f64(0.00000000023283064f));
                                                    if _e4051 {
                                                        phi_2912_ = false;
                                                    } else {
                                                        phi_2912_ = true;
                                                    }
                                                    let _e4053 = phi_2912_;
                                                    phi_2913_ = _e4053;
                                                    phi_2914_ = _e4051;
                                                    phi_2915_ = false;
                                                } else {
                                                    phi_2913_ = false;
                                                    phi_2914_ = false;
                                                    phi_2915_ = true;
                                                }
                                                let _e4055 = phi_2913_;
                                                let _e4057 = phi_2914_;
                                                let _e4059 = phi_2915_;
                                                phi_2916_ = _e4055;
                                                phi_2917_ = _e4057;
                                                phi_2918_ = _e4059;
                                            }
                                            let _e4061 = phi_2916_;
                                            let _e4063 = phi_2917_;
                                            let _e4065 = phi_2918_;
                                            phi_2919_ = _e4061;
                                            phi_2920_ = _e4043;
                                            phi_2921_ = _e4063;
                                            phi_2922_ = _e4065;
                                            phi_2923_ = false;
                                            phi_2924_ = false;
                                        } else {
                                            phi_2919_ = false;
                                            phi_2920_ = false;
                                            phi_2921_ = false;
                                            phi_2922_ = false;
                                            let _e5665 = local_75;
                                            phi_2923_ = _e5665;
                                            let _e5668 = local_76;
                                            phi_2924_ = _e5668;
                                        }
                                        let _e4067 = phi_2919_;
                                        let _e4069 = phi_2920_;
                                        let _e4071 = phi_2921_;
                                        let _e4073 = phi_2922_;
                                        let _e4075 = phi_2923_;
                                        let _e4077 = phi_2924_;
                                        let _e5671 = local_77;
                                        phi_2925_ = _e5671;
                                        let _e5674 = local_78;
                                        phi_2926_ = _e5674;
                                        phi_2927_ = _e4067;
                                        phi_2928_ = _e4069;
                                        phi_2929_ = _e4071;
                                        phi_2930_ = _e4073;
                                        phi_2931_ = _e4075;
                                        phi_2932_ = _e4077;
                                        phi_2933_ = false;
                                    } else {
                                        phi_2925_ = f64();
                                        phi_2926_ = f64();
                                        phi_2927_ = false;
                                        phi_2928_ = false;
                                        phi_2929_ = false;
                                        phi_2930_ = false;
                                        phi_2931_ = false;
                                        phi_2932_ = false;
                                        phi_2933_ = true;
                                    }
                                    let _e4079 = phi_2925_;
                                    let _e4081 = phi_2926_;
                                    let _e4083 = phi_2927_;
                                    let _e4085 = phi_2928_;
                                    let _e4087 = phi_2929_;
                                    let _e4089 = phi_2930_;
                                    let _e4091 = phi_2931_;
                                    let _e4093 = phi_2932_;
                                    let _e4095 = phi_2933_;
                                    phi_2934_ = _e4079;
                                    phi_2935_ = _e4081;
                                    phi_2936_ = _e4083;
                                    phi_2937_ = _e4085;
                                    phi_2938_ = _e4087;
                                    phi_2939_ = _e4089;
                                    phi_2940_ = _e4091;
                                    phi_2941_ = _e4093;
                                    phi_2942_ = _e4095;
                                    phi_2943_ = false;
                                } else {
                                    phi_2934_ = f64();
                                    phi_2935_ = f64();
                                    phi_2936_ = false;
                                    phi_2937_ = false;
                                    phi_2938_ = false;
                                    phi_2939_ = false;
                                    phi_2940_ = false;
                                    phi_2941_ = false;
                                    phi_2942_ = false;
                                    phi_2943_ = true;
                                }
                                let _e4097 = phi_2934_;
                                let _e4099 = phi_2935_;
                                let _e4101 = phi_2936_;
                                let _e4103 = phi_2937_;
                                let _e4105 = phi_2938_;
                                let _e4107 = phi_2939_;
                                let _e4109 = phi_2940_;
                                let _e4111 = phi_2941_;
                                let _e4113 = phi_2942_;
                                let _e4115 = phi_2943_;
                                phi_2944_ = _e4097;
                                phi_1993_ = _e4099;
                                phi_2945_ = _e4101;
                                phi_2946_ = _e4103;
                                phi_2947_ = _e4105;
                                phi_2948_ = false;
                                phi_2949_ = _e4107;
                                phi_2950_ = _e4109;
                                phi_2951_ = _e4111;
                                phi_2952_ = _e4113;
                                phi_2953_ = _e4115;
                            } else {
                                phi_2944_ = f64();
                                phi_1993_ = f64();
                                phi_2945_ = false;
                                phi_2946_ = false;
                                phi_2947_ = false;
                                phi_2948_ = true;
                                phi_2949_ = false;
                                phi_2950_ = false;
                                phi_2951_ = false;
                                phi_2952_ = false;
                                phi_2953_ = false;
                            }
                            let _e4117 = phi_2944_;
                            let _e4119 = phi_1993_;
                            let _e4121 = phi_2945_;
                            let _e4123 = phi_2946_;
                            let _e4125 = phi_2947_;
                            let _e4127 = phi_2948_;
                            let _e4129 = phi_2949_;
                            let _e4131 = phi_2950_;
                            let _e4133 = phi_2951_;
                            let _e4135 = phi_2952_;
                            let _e4137 = phi_2953_;
                            local_44 = _e4123;
                            local_79 = _e4125;
                            local_80 = _e4127;
                            local_81 = _e4129;
                            local_82 = _e4131;
                            local_83 = _e4133;
                            local_84 = _e4135;
                            local_85 = _e4137;
                            local_86 = _e4117;
                            local_88 = _e4123;
                            continue;
                            continuing {
                                phi_1989_ = _e3488;
                                phi_1992_ = _e4119;
                                break if !(_e4121);
                            }
                        }
                        let _e4140 = local_44;
                        if _e4140 {
                            phi_2958_ = type_40(0u, type_40().member_1);
                            phi_2959_ = false;
                            phi_2960_ = false;
                            phi_2961_ = false;
                            phi_2962_ = false;
                            phi_2963_ = false;
                            phi_2964_ = false;
                            phi_2965_ = false;
                        } else {
                            phi_2958_ = type_40();
                            let _e5707 = local_79;
                            phi_2959_ = _e5707;
                            let _e5710 = local_80;
                            phi_2960_ = _e5710;
                            let _e5713 = local_81;
                            phi_2961_ = _e5713;
                            let _e5716 = local_82;
                            phi_2962_ = _e5716;
                            let _e5719 = local_83;
                            phi_2963_ = _e5719;
                            let _e5722 = local_84;
                            phi_2964_ = _e5722;
                            let _e5725 = local_85;
                            phi_2965_ = _e5725;
                        }
                        let _e4144 = phi_2958_;
                        let _e4146 = phi_2959_;
                        let _e4148 = phi_2960_;
                        let _e4150 = phi_2961_;
                        let _e4152 = phi_2962_;
                        let _e4154 = phi_2963_;
                        let _e4156 = phi_2964_;
                        let _e4158 = phi_2965_;
                        if _e4146 {
                            let _e5728 = local_86;
                            phi_2969_ = _e5728;
                            phi_2970_ = true;
                            phi_2971_ = false;
                            phi_2972_ = false;
                            phi_2973_ = false;
                            phi_2974_ = false;
                            phi_2975_ = false;
                            phi_2976_ = false;
                        } else {
                            let _e5730 = local_87;
                            phi_2969_ = _e5730;
                            phi_2970_ = _e4148;
                            phi_2971_ = _e4150;
                            phi_2972_ = _e4152;
                            phi_2973_ = _e4154;
                            let _e5737 = local_88;
                            phi_2974_ = _e5737;
                            phi_2975_ = _e4156;
                            phi_2976_ = _e4158;
                        }
                        let _e4160 = phi_2969_;
                        let _e4162 = phi_2970_;
                        let _e4164 = phi_2971_;
                        let _e4166 = phi_2972_;
                        let _e4168 = phi_2973_;
                        let _e4170 = phi_2974_;
                        let _e4172 = phi_2975_;
                        let _e4174 = phi_2976_;
                        if _e4162 {
                            phi_2981_ = type_40(1u, _e4160);
                            phi_2982_ = false;
                            phi_2983_ = false;
                            phi_2984_ = false;
                            phi_2985_ = false;
                            phi_2986_ = false;
                            phi_2987_ = false;
                        } else {
                            phi_2981_ = type_40();
                            phi_2982_ = _e4164;
                            phi_2983_ = _e4166;
                            phi_2984_ = _e4168;
                            phi_2985_ = _e4170;
                            phi_2986_ = _e4172;
                            phi_2987_ = _e4174;
                        }
                        let _e4177 = phi_2981_;
                        let _e4179 = phi_2982_;
                        let _e4181 = phi_2983_;
                        let _e4183 = phi_2984_;
                        let _e4185 = phi_2985_;
                        let _e4187 = phi_2986_;
                        let _e4189 = phi_2987_;
                        if _e4179 {
                            let _e4191 = local_45;
                            phi_2992_ = type_40(1u, _e4191);
                            phi_2993_ = false;
                            phi_2994_ = false;
                            phi_2995_ = true;
                            phi_2996_ = false;
                            phi_2997_ = false;
                        } else {
                            phi_2992_ = _e4144;
                            phi_2993_ = _e4181;
                            phi_2994_ = _e4183;
                            phi_2995_ = _e4185;
                            phi_2996_ = _e4187;
                            phi_2997_ = _e4189;
                        }
                        let _e4194 = phi_2992_;
                        let _e4196 = phi_2993_;
                        let _e4198 = phi_2994_;
                        let _e4200 = phi_2995_;
                        let _e4202 = phi_2996_;
                        let _e4204 = phi_2997_;
                        if _e4196 {
                            let _e4206 = local_46;
                            phi_3002_ = type_40(1u, _e4206);
                            phi_3003_ = false;
                            phi_3004_ = false;
                            phi_3005_ = false;
                            phi_3006_ = false;
                        } else {
                            phi_3002_ = type_40();
                            phi_3003_ = _e4198;
                            phi_3004_ = _e4200;
                            phi_3005_ = _e4202;
                            phi_3006_ = _e4204;
                        }
                        let _e4209 = phi_3002_;
                        let _e4211 = phi_3003_;
                        let _e4213 = phi_3004_;
                        let _e4215 = phi_3005_;
                        let _e4217 = phi_3006_;
                        if _e4211 {
                            let _e4219 = local_47;
                            phi_3011_ = type_40(1u, _e4219);
                            phi_3012_ = true;
                            phi_3013_ = false;
                            phi_3014_ = false;
                            phi_3015_ = false;
                        } else {
                            phi_3011_ = _e4209;
                            phi_3012_ = _e4196;
                            phi_3013_ = _e4213;
                            phi_3014_ = _e4215;
                            phi_3015_ = _e4217;
                        }
                        let _e4222 = phi_3011_;
                        let _e4224 = phi_3012_;
                        let _e4226 = phi_3013_;
                        let _e4228 = phi_3014_;
                        let _e4230 = phi_3015_;
                        if _e4224 {
                            phi_3019_ = _e4222;
                            phi_3020_ = true;
                            phi_3021_ = false;
                            phi_3022_ = false;
                        } else {
                            phi_3019_ = _e4194;
                            phi_3020_ = _e4226;
                            phi_3021_ = _e4228;
                            phi_3022_ = _e4230;
                        }
                        let _e4232 = phi_3019_;
                        let _e4234 = phi_3020_;
                        let _e4236 = phi_3021_;
                        let _e4238 = phi_3022_;
                        if _e4234 {
                            phi_3026_ = false;
                            phi_3027_ = false;
                        } else {
                            phi_3026_ = _e4236;
                            phi_3027_ = _e4238;
                        }
                        let _e4240 = phi_3026_;
                        let _e4242 = phi_3027_;
                        if _e4240 {
                            phi_3031_ = false;
                            phi_3032_ = false;
                        } else {
                            phi_3031_ = _e4242;
                            phi_3032_ = _e4234;
                        }
                        let _e4244 = phi_3031_;
                        let _e4246 = phi_3032_;
                        if _e4244 {
                            phi_3036_ = true;
                            phi_3037_ = false;
                        } else {
                            phi_3036_ = _e4240;
                            phi_3037_ = _e4246;
                        }
                        let _e4248 = phi_3036_;
                        let _e4250 = phi_3037_;
                        if _e4248 {
                            let _e4252 = local_48;
                            phi_3042_ = type_40(1u, _e4252);
                            phi_3043_ = true;
                        } else {
                            phi_3042_ = _e4232;
                            phi_3043_ = _e4250;
                        }
                        let _e4255 = phi_3042_;
                        let _e4257 = phi_3043_;
                        if _e4257 {
                            phi_3047_ = _e4255;
                        } else {
                            phi_3047_ = _e4177;
                        }
                        let _e4259 = phi_3047_;
                        if (_e4259.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_3061_ = type_19(0u, 3u);
                            loop {
                                let _e4271 = phi_3061_;
                                if (_e4271.member < _e4271.member_1) {
                                    phi_3062_ = type_19((_e4271.member + 1u), _e4271.member_1);
                                    phi_3085_ = type_19(1u, _e4271.member);
                                } else {
                                    phi_3062_ = _e4271;
                                    phi_3085_ = type_19(0u, type_19().member_1);
                                }
                                let _e4283 = phi_3062_;
                                let _e4285 = phi_3085_;
                                if (bitcast<i32>(_e4285.member) != 0i) {
                                    let _e4291 = local_14[_e4285.member_1];
                                    let _e4293 = (_e4259.member_1 + f64(_e4291));
                                    if (_e4293 < _e3233) {
                                        phi_3106_ = _e4293;
                                    } else {
                                        phi_3106_ = _e3233;
                                    }
                                    let _e4296 = phi_3106_;
                                    let _e4299 = local_20.member[0u];
                                    let _e4305 = local_20.member[1u];
                                    let _e4315 = (_e4299[0] + ((_e4305[0] - _e4299[0]) * _e4296));
                                    let _e4316 = (_e4299[1] + ((_e4305[1] - _e4299[1]) * _e4296));
                                    let _e4317 = (_e4299[2] + ((_e4305[2] - _e4299[2]) * _e4296));
                                    let _e4320 = local_20.member_1[0u];
                                    let _e4326 = local_20.member_1[1u];
                                    let _e4336 = (_e4320[0] + ((_e4326[0] - _e4320[0]) * _e4296));
                                    let _e4337 = (_e4320[1] + ((_e4326[1] - _e4320[1]) * _e4296));
                                    let _e4338 = (_e4320[2] + ((_e4326[2] - _e4320[2]) * _e4296));
                                    let _e4341 = local_20.member_2[0u];
                                    let _e4347 = local_20.member_2[1u];
                                    let _e4357 = (_e4341[0] + ((_e4347[0] - _e4341[0]) * _e4296));
                                    let _e4358 = (_e4341[1] + ((_e4347[1] - _e4341[1]) * _e4296));
                                    let _e4359 = (_e4341[2] + ((_e4347[2] - _e4341[2]) * _e4296));
                                    let _e4364 = (((_e4336 * _e4336) + (_e4337 * _e4337)) + (_e4338 * _e4338));
                                    let _e4369 = (((_e4336 * _e4357) + (_e4337 * _e4358)) + (_e4338 * _e4359));
                                    let _e4374 = (((_e4357 * _e4357) + (_e4358 * _e4358)) + (_e4359 * _e4359));
                                    let _e4379 = (((_e4315 * _e4336) + (_e4316 * _e4337)) + (_e4317 * _e4338));
                                    let _e4384 = (((_e4315 * _e4357) + (_e4316 * _e4358)) + (_e4317 * _e4359));
                                    let _e4387 = ((_e4364 * _e4374) - (_e4369 * _e4369));
                                    let _e4388 = f64(0f);
                                    let _e4389 = f64(1f);
                                    let _e4393 = (((_e4379 * _e4374) - (_e4384 * _e4369)) / _e4387);
                                    let _e4397 = (((_e4384 * _e4364) - (_e4379 * _e4369)) / _e4387);
                                    if (_e4393 >= _e4388) {
                                        if (_e4397 >= _e4388) {
                                            if (_e4393 <= _e4389) {
                                                phi_3256_ = (_e4397 <= _e4389);
                                                phi_3257_ = false;
                                            } else {
                                                phi_3256_ = bool();
                                                phi_3257_ = true;
                                            }
                                            let _e4403 = phi_3256_;
                                            let _e4405 = phi_3257_;
                                            phi_3258_ = _e4403;
                                            phi_3259_ = _e4405;
                                        } else {
                                            phi_3258_ = bool();
                                            phi_3259_ = true;
                                        }
                                        let _e4407 = phi_3258_;
                                        let _e4409 = phi_3259_;
                                        phi_3260_ = _e4407;
                                        phi_3261_ = _e4409;
                                    } else {
                                        phi_3260_ = bool();
                                        phi_3261_ = true;
                                    }
                                    let _e4411 = phi_3260_;
                                    let _e4413 = phi_3261_;
                                    if _e4413 {
                                        phi_3265_ = false;
                                    } else {
                                        phi_3265_ = _e4411;
                                    }
                                    let _e4415 = phi_3265_;
                                    if (_e4387 > _e4388) {
                                        if _e4415 {
                                            phi_3305_ = array<f64, 3>((_e4315 - ((_e4336 * _e4393) + (_e4357 * _e4397))), (_e4316 - ((_e4337 * _e4393) + (_e4358 * _e4397))), (_e4317 - ((_e4338 * _e4393) + (_e4359 * _e4397))));
                                            phi_3306_ = false;
                                        } else {
                                            phi_3305_ = array<f64, 3>();
                                            phi_3306_ = true;
                                        }
                                        let _e4431 = phi_3305_;
                                        let _e4433 = phi_3306_;
                                        phi_3307_ = _e4431;
                                        phi_3308_ = _e4433;
                                    } else {
                                        phi_3307_ = array<f64, 3>();
                                        phi_3308_ = true;
                                    }
                                    let _e4435 = phi_3307_;
                                    let _e4437 = phi_3308_;
                                    if _e4437 {
                                        let _e4438 = (_e4315 - _e4336);
                                        let _e4439 = (_e4316 - _e4337);
                                        let _e4440 = (_e4317 - _e4338);
                                        let _e4451 = ((((_e4315 * _e4336) + (_e4316 * _e4337)) + (_e4317 * _e4338)) / (((_e4336 * _e4336) + (_e4337 * _e4337)) + (_e4338 * _e4338)));
                                        if (_e4451 > f64(0f)) {
                                            if (_e4451 < f64(1f)) {
                                                phi_3341_ = _e4451;
                                            } else {
                                                phi_3341_ = f64(1f);
                                            }
                                            let _e4459 = phi_3341_;
                                            phi_3343_ = _e4459;
                                        } else {
                                            phi_3343_ = f64(0f);
                                        }
                                        let _e4461 = phi_3343_;
                                        let _e4478 = ((((_e4315 * _e4357) + (_e4316 * _e4358)) + (_e4317 * _e4359)) / (((_e4357 * _e4357) + (_e4358 * _e4358)) + (_e4359 * _e4359)));
                                        if (_e4478 > f64(0f)) {
                                            if (_e4478 < f64(1f)) {
                                                phi_3373_ = _e4478;
                                            } else {
                                                phi_3373_ = f64(1f);
                                            }
                                            let _e4486 = phi_3373_;
                                            phi_3375_ = _e4486;
                                        } else {
                                            phi_3375_ = f64(0f);
                                        }
                                        let _e4488 = phi_3375_;
                                        let _e4505 = ((((_e4438 * _e4357) + (_e4439 * _e4358)) + (_e4440 * _e4359)) / (((_e4357 * _e4357) + (_e4358 * _e4358)) + (_e4359 * _e4359)));
                                        if (_e4505 > f64(0f)) {
                                            if (_e4505 < f64(1f)) {
                                                phi_3405_ = _e4505;
                                            } else {
                                                phi_3405_ = f64(1f);
                                            }
                                            let _e4513 = phi_3405_;
                                            phi_3407_ = _e4513;
                                        } else {
                                            phi_3407_ = f64(0f);
                                        }
                                        let _e4515 = phi_3407_;
                                        let _e4522 = (_e4315 - _e4357);
                                        let _e4523 = (_e4316 - _e4358);
                                        let _e4524 = (_e4317 - _e4359);
                                        let _e4535 = ((((_e4522 * _e4336) + (_e4523 * _e4337)) + (_e4524 * _e4338)) / (((_e4336 * _e4336) + (_e4337 * _e4337)) + (_e4338 * _e4338)));
                                        if (_e4535 > f64(0f)) {
                                            if (_e4535 < f64(1f)) {
                                                phi_3440_ = _e4535;
                                            } else {
                                                phi_3440_ = f64(1f);
                                            }
                                            let _e4543 = phi_3440_;
                                            phi_3442_ = _e4543;
                                        } else {
                                            phi_3442_ = f64(0f);
                                        }
                                        let _e4545 = phi_3442_;
                                        local_10[0u] = array<f64, 3>((_e4315 - (_e4336 * _e4461)), (_e4316 - (_e4337 * _e4461)), (_e4317 - (_e4338 * _e4461)));
                                        local_10[1u] = array<f64, 3>((_e4315 - (_e4357 * _e4488)), (_e4316 - (_e4358 * _e4488)), (_e4317 - (_e4359 * _e4488)));
                                        local_10[2u] = array<f64, 3>((_e4438 - (_e4357 * _e4515)), (_e4439 - (_e4358 * _e4515)), (_e4440 - (_e4359 * _e4515)));
                                        local_10[3u] = array<f64, 3>((_e4522 - (_e4336 * _e4545)), (_e4523 - (_e4337 * _e4545)), (_e4524 - (_e4338 * _e4545)));
                                        let _e4561 = local_10[0u];
                                        phi_3597_ = type_19(1u, 4u);
                                        phi_3600_ = array<f64, 3>(_e4561[0], _e4561[1], _e4561[2]);
                                        loop {
                                            let _e4567 = phi_3597_;
                                            let _e4569 = phi_3600_;
                                            local_89 = _e4569;
                                            if (_e4567.member < _e4567.member_1) {
                                                phi_3598_ = type_19((_e4567.member + 1u), _e4567.member_1);
                                                phi_3623_ = type_19(1u, _e4567.member);
                                            } else {
                                                phi_3598_ = _e4567;
                                                phi_3623_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e4581 = phi_3598_;
                                            let _e4583 = phi_3623_;
                                            let _e4587 = (bitcast<i32>(_e4583.member) != 0i);
                                            if _e4587 {
                                                let _e4589 = local_10[_e4583.member_1];
                                                let _e4594 = local_10[_e4583.member_1];
                                                if ((((_e4589[0] * _e4594[0]) + (_e4589[1] * _e4594[1])) + (_e4589[2] * _e4594[2])) < (((_e4569[0] * _e4569[0]) + (_e4569[1] * _e4569[1])) + (_e4569[2] * _e4569[2]))) {
                                                    let _e4616 = local_10[_e4583.member_1];
                                                    phi_3690_ = array<f64, 3>(_e4616[0], _e4616[1], _e4616[2]);
                                                } else {
                                                    phi_3690_ = _e4569;
                                                }
                                                let _e4622 = phi_3690_;
                                                phi_3601_ = _e4622;
                                            } else {
                                                phi_3601_ = array<f64, 3>();
                                            }
                                            let _e4624 = phi_3601_;
                                            continue;
                                            continuing {
                                                phi_3597_ = _e4581;
                                                phi_3600_ = _e4624;
                                                break if !(_e4587);
                                            }
                                        }
                                        let _e5811 = local_89;
                                        phi_3691_ = _e5811;
                                    } else {
                                        phi_3691_ = _e4435;
                                    }
                                    let _e4627 = phi_3691_;
                                    let _e4638 = (((_e4627[0] * _e4627[0]) + (_e4627[1] * _e4627[1])) + (_e4627[2] * _e4627[2]));
                                    if (_e4638 <= 2.2250738585072014e-308lf) {
                                        if (_e4638 > 0.0lf) {
                                            phi_3716_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3716_ = 0.0lf;
                                        }
                                        let _e4690 = phi_3716_;
                                        phi_3780_ = _e4690;
                                    } else {
                                        phi_3723_ = type_17(0i, 5i);
                                        phi_3726_ = bitcast<f64>(((bitcast<u64>(_e4638) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e4645 = phi_3723_;
                                            let _e4647 = phi_3726_;
                                            local_49 = _e4647;
                                            if (_e4645.member < _e4645.member_1) {
                                                let _e4654 = (_e4645.member + 1i);
                                                if ((false == (_e4654 > _e4645.member)) != false) {
                                                    phi_3747_ = true;
                                                } else {
                                                    phi_3747_ = false;
                                                }
                                                let _e4659 = phi_3747_;
                                                if _e4659 {
                                                    phi_3753_ = type_18(0u, type_18().member_1);
                                                } else {
                                                    phi_3753_ = type_18(1u, _e4654);
                                                }
                                                let _e4664 = phi_3753_;
                                                phi_3724_ = type_17(_e4664.member_1, _e4645.member_1);
                                                phi_3767_ = type_18(1u, _e4645.member);
                                            } else {
                                                phi_3724_ = _e4645;
                                                phi_3767_ = type_18(0u, type_18().member_1);
                                            }
                                            let _e4670 = phi_3724_;
                                            let _e4672 = phi_3767_;
                                            let _e4675 = (bitcast<i32>(_e4672.member) != 0i);
                                            if _e4675 {
                                                phi_3727_ = (0.5lf * (_e4647 + (_e4638 / _e4647)));
                                            } else {
                                                phi_3727_ = f64();
                                            }
                                            let _e4680 = phi_3727_;
                                            continue;
                                            continuing {
                                                phi_3723_ = _e4670;
                                                phi_3726_ = _e4680;
                                                break if !(_e4675);
                                            }
                                        }
                                        let _e4685 = local_49;
                                        phi_3780_ = (_e4685 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e4692 = phi_3780_;
                                    let _e4700 = local_20.member[0u];
                                    if (_e4700[0] < 0.0lf) {
                                        phi_3798_ = -(_e4700[0]);
                                    } else {
                                        phi_3798_ = _e4700[0];
                                    }
                                    let _e4707 = phi_3798_;
                                    if (_e4700[1] < 0.0lf) {
                                        phi_3805_ = -(_e4700[1]);
                                    } else {
                                        phi_3805_ = _e4700[1];
                                    }
                                    let _e4711 = phi_3805_;
                                    if (_e4707 > _e4711) {
                                        phi_3810_ = _e4707;
                                    } else {
                                        phi_3810_ = _e4711;
                                    }
                                    let _e4714 = phi_3810_;
                                    if (_e4700[2] < 0.0lf) {
                                        phi_3817_ = -(_e4700[2]);
                                    } else {
                                        phi_3817_ = _e4700[2];
                                    }
                                    let _e4718 = phi_3817_;
                                    if (_e4714 > _e4718) {
                                        phi_3822_ = _e4714;
                                    } else {
                                        phi_3822_ = _e4718;
                                    }
                                    let _e4721 = phi_3822_;
                                    let _e4724 = local_20.member[1u];
                                    if (_e4724[0] < 0.0lf) {
                                        phi_3835_ = -(_e4724[0]);
                                    } else {
                                        phi_3835_ = _e4724[0];
                                    }
                                    let _e4731 = phi_3835_;
                                    if (_e4724[1] < 0.0lf) {
                                        phi_3842_ = -(_e4724[1]);
                                    } else {
                                        phi_3842_ = _e4724[1];
                                    }
                                    let _e4735 = phi_3842_;
                                    if (_e4731 > _e4735) {
                                        phi_3847_ = _e4731;
                                    } else {
                                        phi_3847_ = _e4735;
                                    }
                                    let _e4738 = phi_3847_;
                                    if (_e4724[2] < 0.0lf) {
                                        phi_3854_ = -(_e4724[2]);
                                    } else {
                                        phi_3854_ = _e4724[2];
                                    }
                                    let _e4742 = phi_3854_;
                                    if (_e4738 > _e4742) {
                                        phi_3859_ = _e4738;
                                    } else {
                                        phi_3859_ = _e4742;
                                    }
                                    let _e4745 = phi_3859_;
                                    if (_e4721 > _e4745) {
                                        phi_3864_ = _e4721;
                                    } else {
                                        phi_3864_ = _e4745;
                                    }
                                    let _e4748 = phi_3864_;
                                    let _e4750 = local_20.member_3;
                                    let _e4754 = local_20.member_1[0u];
                                    if (_e4754[0] < 0.0lf) {
                                        phi_3881_ = -(_e4754[0]);
                                    } else {
                                        phi_3881_ = _e4754[0];
                                    }
                                    let _e4761 = phi_3881_;
                                    if (_e4754[1] < 0.0lf) {
                                        phi_3888_ = -(_e4754[1]);
                                    } else {
                                        phi_3888_ = _e4754[1];
                                    }
                                    let _e4765 = phi_3888_;
                                    if (_e4761 > _e4765) {
                                        phi_3893_ = _e4761;
                                    } else {
                                        phi_3893_ = _e4765;
                                    }
                                    let _e4768 = phi_3893_;
                                    if (_e4754[2] < 0.0lf) {
                                        phi_3900_ = -(_e4754[2]);
                                    } else {
                                        phi_3900_ = _e4754[2];
                                    }
                                    let _e4772 = phi_3900_;
                                    if (_e4768 > _e4772) {
                                        phi_3905_ = _e4768;
                                    } else {
                                        phi_3905_ = _e4772;
                                    }
                                    let _e4775 = phi_3905_;
                                    let _e4778 = local_20.member_1[1u];
                                    if (_e4778[0] < 0.0lf) {
                                        phi_3919_ = -(_e4778[0]);
                                    } else {
                                        phi_3919_ = _e4778[0];
                                    }
                                    let _e4785 = phi_3919_;
                                    if (_e4778[1] < 0.0lf) {
                                        phi_3926_ = -(_e4778[1]);
                                    } else {
                                        phi_3926_ = _e4778[1];
                                    }
                                    let _e4789 = phi_3926_;
                                    if (_e4785 > _e4789) {
                                        phi_3931_ = _e4785;
                                    } else {
                                        phi_3931_ = _e4789;
                                    }
                                    let _e4792 = phi_3931_;
                                    if (_e4778[2] < 0.0lf) {
                                        phi_3938_ = -(_e4778[2]);
                                    } else {
                                        phi_3938_ = _e4778[2];
                                    }
                                    let _e4796 = phi_3938_;
                                    if (_e4792 > _e4796) {
                                        phi_3943_ = _e4792;
                                    } else {
                                        phi_3943_ = _e4796;
                                    }
                                    let _e4799 = phi_3943_;
                                    if (_e4775 > _e4799) {
                                        phi_3948_ = _e4775;
                                    } else {
                                        phi_3948_ = _e4799;
                                    }
                                    let _e4802 = phi_3948_;
                                    let _e4804 = local_20.member_3;
                                    let _e4808 = local_20.member_2[0u];
                                    if (_e4808[0] < 0.0lf) {
                                        phi_3965_ = -(_e4808[0]);
                                    } else {
                                        phi_3965_ = _e4808[0];
                                    }
                                    let _e4815 = phi_3965_;
                                    if (_e4808[1] < 0.0lf) {
                                        phi_3972_ = -(_e4808[1]);
                                    } else {
                                        phi_3972_ = _e4808[1];
                                    }
                                    let _e4819 = phi_3972_;
                                    if (_e4815 > _e4819) {
                                        phi_3977_ = _e4815;
                                    } else {
                                        phi_3977_ = _e4819;
                                    }
                                    let _e4822 = phi_3977_;
                                    if (_e4808[2] < 0.0lf) {
                                        phi_3984_ = -(_e4808[2]);
                                    } else {
                                        phi_3984_ = _e4808[2];
                                    }
                                    let _e4826 = phi_3984_;
                                    if (_e4822 > _e4826) {
                                        phi_3989_ = _e4822;
                                    } else {
                                        phi_3989_ = _e4826;
                                    }
                                    let _e4829 = phi_3989_;
                                    let _e4832 = local_20.member_2[1u];
                                    if (_e4832[0] < 0.0lf) {
                                        phi_4003_ = -(_e4832[0]);
                                    } else {
                                        phi_4003_ = _e4832[0];
                                    }
                                    let _e4839 = phi_4003_;
                                    if (_e4832[1] < 0.0lf) {
                                        phi_4010_ = -(_e4832[1]);
                                    } else {
                                        phi_4010_ = _e4832[1];
                                    }
                                    let _e4843 = phi_4010_;
                                    if (_e4839 > _e4843) {
                                        phi_4015_ = _e4839;
                                    } else {
                                        phi_4015_ = _e4843;
                                    }
                                    let _e4846 = phi_4015_;
                                    if (_e4832[2] < 0.0lf) {
                                        phi_4022_ = -(_e4832[2]);
                                    } else {
                                        phi_4022_ = _e4832[2];
                                    }
                                    let _e4850 = phi_4022_;
                                    if (_e4846 > _e4850) {
                                        phi_4027_ = _e4846;
                                    } else {
                                        phi_4027_ = _e4850;
                                    }
                                    let _e4853 = phi_4027_;
                                    if (_e4829 > _e4853) {
                                        phi_4032_ = _e4829;
                                    } else {
                                        phi_4032_ = _e4853;
                                    }
                                    let _e4856 = phi_4032_;
                                    let _e4858 = local_20.member_3;
                                    let _e4866 = local_20.member_3;
                                    let _e4876 = (((_e4692 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e4748 + _e4750) + (_e4802 + _e4804)) + (_e4856 + _e4858)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4866 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e426);
                                    if _e4876 {
                                        phi_4056_ = false;
                                    } else {
                                        phi_4056_ = true;
                                    }
                                    let _e4878 = phi_4056_;
                                    phi_4057_ = _e4878;
                                    phi_4058_ = _e4876;
                                } else {
                                    phi_4057_ = false;
                                    phi_4058_ = false;
                                }
                                let _e4880 = phi_4057_;
                                let _e4882 = phi_4058_;
                                local_50 = _e4882;
                                continue;
                                continuing {
                                    phi_3061_ = _e4283;
                                    break if !(_e4880);
                                }
                            }
                            let _e4885 = local_50;
                            if _e4885 {
                                phi_4063_ = type_40(1u, _e4259.member_1);
                                phi_4064_ = false;
                            } else {
                                phi_4063_ = type_40();
                                phi_4064_ = true;
                            }
                            let _e4888 = phi_4063_;
                            let _e4890 = phi_4064_;
                            if _e4890 {
                                phi_4069_ = type_40(2u, _e4259.member_1);
                                phi_4070_ = false;
                            } else {
                                phi_4069_ = type_40();
                                phi_4070_ = true;
                            }
                            let _e4893 = phi_4069_;
                            let _e4895 = phi_4070_;
                            phi_4072_ = _e4893;
                            phi_4073_ = _e4888;
                            phi_4074_ = _e4895;
                        } else {
                            phi_4072_ = type_40();
                            phi_4073_ = type_40(0u, type_40().member_1);
                            phi_4074_ = true;
                        }
                        let _e4897 = phi_4072_;
                        let _e4899 = phi_4073_;
                        let _e4901 = phi_4074_;
                        if _e4901 {
                            phi_4078_ = _e4899;
                        } else {
                            phi_4078_ = _e4897;
                        }
                        let _e4903 = phi_4078_;
                        phi_7449_ = _e4903;
                    } else {
                        if (_e525 < 0.0lf) {
                            phi_4089_ = -(_e525);
                        } else {
                            phi_4089_ = _e525;
                        }
                        let _e880 = phi_4089_;
                        if (_e548 < 0.0lf) {
                            phi_4095_ = -(_e548);
                        } else {
                            phi_4095_ = _e548;
                        }
                        let _e884 = phi_4095_;
                        if (_e880 > _e884) {
                            phi_4100_ = _e880;
                        } else {
                            phi_4100_ = _e884;
                        }
                        let _e887 = phi_4100_;
                        if (_e571 < 0.0lf) {
                            phi_4106_ = -(_e571);
                        } else {
                            phi_4106_ = _e571;
                        }
                        let _e891 = phi_4106_;
                        if (_e582 < 0.0lf) {
                            phi_4112_ = -(_e582);
                        } else {
                            phi_4112_ = _e582;
                        }
                        let _e895 = phi_4112_;
                        if (_e891 > _e895) {
                            phi_4117_ = _e891;
                        } else {
                            phi_4117_ = _e895;
                        }
                        let _e898 = phi_4117_;
                        if (_e887 > _e898) {
                            phi_4122_ = _e887;
                        } else {
                            phi_4122_ = _e898;
                        }
                        let _e901 = phi_4122_;
                        let _e903 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e904 = f64(1f);
                        if (_e901 >= _e903) {
                            phi_4132_ = (_e901 <= (_e904 / _e903));
                        } else {
                            phi_4132_ = false;
                        }
                        let _e909 = phi_4132_;
                        if _e909 {
                            phi_4139_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_4139_ = f64(2f);
                        }
                        let _e914 = phi_4139_;
                        let _e916 = ((_e841 * f64(0.34f)) + (_e901 * _e914));
                        if _e909 {
                            phi_4147_ = (_e904 / _e901);
                        } else {
                            phi_4147_ = f64(0f);
                        }
                        let _e920 = phi_4147_;
                        let _e921 = f64(0f);
                        let _e922 = f64(1f);
                        let _e923 = f64(3f);
                        let _e929 = ((_e548 - (_e923 * _e525)) * _e920);
                        let _e930 = ((_e571 - _e548) * _e920);
                        let _e931 = (((_e923 * _e582) - _e571) * _e920);
                        local_7[0u] = _e921;
                        local_7[1u] = _e922;
                        local_7[2u] = _e922;
                        local_7[3u] = _e922;
                        let _e938 = ((_e930 * _e930) - (_e929 * _e931));
                        if (_e938 > _e921) {
                            if (_e938 <= 2.2250738585072014e-308lf) {
                                if (_e938 > 0.0lf) {
                                    phi_4183_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4183_ = 0.0lf;
                                }
                                let _e991 = phi_4183_;
                                phi_4247_ = _e991;
                            } else {
                                phi_4190_ = type_17(0i, 5i);
                                phi_4193_ = bitcast<f64>(((bitcast<u64>(_e938) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e946 = phi_4190_;
                                    let _e948 = phi_4193_;
                                    local_21 = _e948;
                                    if (_e946.member < _e946.member_1) {
                                        let _e955 = (_e946.member + 1i);
                                        if ((false == (_e955 > _e946.member)) != false) {
                                            phi_4214_ = true;
                                        } else {
                                            phi_4214_ = false;
                                        }
                                        let _e960 = phi_4214_;
                                        if _e960 {
                                            phi_4220_ = type_18(0u, type_18().member_1);
                                        } else {
                                            phi_4220_ = type_18(1u, _e955);
                                        }
                                        let _e965 = phi_4220_;
                                        phi_4191_ = type_17(_e965.member_1, _e946.member_1);
                                        phi_4234_ = type_18(1u, _e946.member);
                                    } else {
                                        phi_4191_ = _e946;
                                        phi_4234_ = type_18(0u, type_18().member_1);
                                    }
                                    let _e971 = phi_4191_;
                                    let _e973 = phi_4234_;
                                    let _e976 = (bitcast<i32>(_e973.member) != 0i);
                                    if _e976 {
                                        phi_4194_ = (0.5lf * (_e948 + (_e938 / _e948)));
                                    } else {
                                        phi_4194_ = f64();
                                    }
                                    let _e981 = phi_4194_;
                                    continue;
                                    continuing {
                                        phi_4190_ = _e971;
                                        phi_4193_ = _e981;
                                        break if !(_e976);
                                    }
                                }
                                let _e986 = local_21;
                                phi_4247_ = (_e986 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e993 = phi_4247_;
                            if (_e930 < _e921) {
                                phi_4253_ = -(_e993);
                            } else {
                                phi_4253_ = _e993;
                            }
                            let _e997 = phi_4253_;
                            let _e999 = -((_e930 + _e997));
                            local_8[0u] = (_e999 / (_e999 + _e931));
                            local_8[1u] = (_e929 / (_e929 + _e999));
                            let _e1008 = local_8[1u];
                            let _e1009 = local_8[0u];
                            if (_e1008 < _e1009) {
                                let _e1012 = local_8[1u];
                                let _e1014 = local_8[0u];
                                local_8[0u] = _e1012;
                                local_8[1u] = _e1014;
                            }
                            phi_4278_ = type_19(0u, 2u);
                            phi_4281_ = 1u;
                            loop {
                                let _e1018 = phi_4278_;
                                let _e1020 = phi_4281_;
                                local_51 = _e1020;
                                if (_e1018.member < _e1018.member_1) {
                                    phi_4279_ = type_19((_e1018.member + 1u), _e1018.member_1);
                                    phi_4304_ = type_19(1u, _e1018.member);
                                } else {
                                    phi_4279_ = _e1018;
                                    phi_4304_ = type_19(0u, type_19().member_1);
                                }
                                let _e1032 = phi_4279_;
                                let _e1034 = phi_4304_;
                                let _e1038 = (bitcast<i32>(_e1034.member) != 0i);
                                if _e1038 {
                                    let _e1040 = local_8[_e1034.member_1];
                                    if (_e1040 > _e921) {
                                        let _e1043 = local_8[_e1034.member_1];
                                        if (_e1043 < _e922) {
                                            let _e1046 = local_8[_e1034.member_1];
                                            local_7[_e1020] = _e1046;
                                            phi_4348_ = (_e1020 + 1u);
                                        } else {
                                            phi_4348_ = _e1020;
                                        }
                                        let _e1050 = phi_4348_;
                                        phi_4349_ = _e1050;
                                    } else {
                                        phi_4349_ = _e1020;
                                    }
                                    let _e1052 = phi_4349_;
                                    phi_4282_ = _e1052;
                                } else {
                                    phi_4282_ = u32();
                                }
                                let _e1054 = phi_4282_;
                                continue;
                                continuing {
                                    phi_4278_ = _e1032;
                                    phi_4281_ = _e1054;
                                    break if !(_e1038);
                                }
                            }
                            let _e5089 = local_51;
                            phi_4350_ = _e5089;
                        } else {
                            phi_4350_ = 1u;
                        }
                        let _e1057 = phi_4350_;
                        local_7[_e1057] = _e922;
                        let _e1059 = local_7;
                        local_9 = _e1059;
                        phi_4370_ = type_19(0u, _e1057);
                        loop {
                            let _e1062 = phi_4370_;
                            if (_e1062.member < _e1062.member_1) {
                                phi_4371_ = type_19((_e1062.member + 1u), _e1062.member_1);
                                phi_4394_ = type_19(1u, _e1062.member);
                            } else {
                                phi_4371_ = _e1062;
                                phi_4394_ = type_19(0u, type_19().member_1);
                            }
                            let _e1074 = phi_4371_;
                            let _e1076 = phi_4394_;
                            if (bitcast<i32>(_e1076.member) != 0i) {
                                let _e1082 = local_9[_e1076.member_1];
                                let _e1085 = local_9[(_e1076.member_1 + 1u)];
                                let _e1087 = (f64(1f) - _e1082);
                                let _e1098 = ((((_e525 * _e1087) + (_e548 * _e1082)) * (_e1087 * _e1087)) + (((_e571 * _e1087) + (_e582 * _e1082)) * (_e1082 * _e1082)));
                                let _e1100 = (f64(1f) - _e1085);
                                let _e1111 = ((((_e525 * _e1100) + (_e548 * _e1085)) * (_e1100 * _e1100)) + (((_e571 * _e1100) + (_e582 * _e1085)) * (_e1085 * _e1085)));
                                if (_e1098 < 0.0lf) {
                                    phi_4448_ = -(_e1098);
                                } else {
                                    phi_4448_ = _e1098;
                                }
                                let _e1115 = phi_4448_;
                                let _e1116 = (_e1115 > _e916);
                                if (_e1111 < 0.0lf) {
                                    phi_4455_ = -(_e1111);
                                } else {
                                    phi_4455_ = _e1111;
                                }
                                let _e1120 = phi_4455_;
                                let _e1121 = (_e1120 > _e916);
                                let _e1122 = f64(0f);
                                if _e1116 {
                                    if _e1121 {
                                        phi_4467_ = ((_e1098 > _e1122) != (_e1111 > _e1122));
                                        phi_4468_ = false;
                                    } else {
                                        phi_4467_ = bool();
                                        phi_4468_ = true;
                                    }
                                    let _e1127 = phi_4467_;
                                    let _e1129 = phi_4468_;
                                    phi_4469_ = _e1127;
                                    phi_4470_ = _e1129;
                                } else {
                                    phi_4469_ = bool();
                                    phi_4470_ = true;
                                }
                                let _e1131 = phi_4469_;
                                let _e1133 = phi_4470_;
                                if _e1133 {
                                    phi_4474_ = false;
                                } else {
                                    phi_4474_ = _e1131;
                                }
                                let _e1135 = phi_4474_;
                                if _e1116 {
                                    if _e1121 {
                                        if _e1135 {
                                            phi_4486_ = type_41();
                                        } else {
                                            phi_4486_ = type_41(f64(1f), _e1122, _e1135);
                                        }
                                        let _e1139 = phi_4486_;
                                        phi_4487_ = _e1139;
                                        phi_4488_ = _e1135;
                                    } else {
                                        phi_4487_ = type_41();
                                        phi_4488_ = true;
                                    }
                                    let _e1141 = phi_4487_;
                                    let _e1143 = phi_4488_;
                                    phi_4489_ = _e1141;
                                    phi_4490_ = _e1143;
                                } else {
                                    phi_4489_ = type_41();
                                    phi_4490_ = true;
                                }
                                let _e1145 = phi_4489_;
                                let _e1147 = phi_4490_;
                                if _e1147 {
                                    if _e1116 {
                                        if (_e1098 < _e1122) {
                                            phi_4503_ = f64(-1f);
                                        } else {
                                            phi_4503_ = f64(1f);
                                        }
                                        let _e1152 = phi_4503_;
                                        let _e1153 = f64(0.00000000000022737368f);
                                        let _e1154 = f64(0.5f);
                                        let _e1155 = f64(3f);
                                        let _e1158 = (_e571 - _e548);
                                        phi_4516_ = type_19(0u, 64u);
                                        phi_4519_ = _e1085;
                                        phi_4521_ = _e1082;
                                        phi_4523_ = (_e1154 * (_e1082 + _e1085));
                                        loop {
                                            let _e1164 = phi_4516_;
                                            let _e1166 = phi_4519_;
                                            let _e1168 = phi_4521_;
                                            let _e1170 = phi_4523_;
                                            local_53 = _e1168;
                                            if (_e1164.member < _e1164.member_1) {
                                                phi_4517_ = type_19((_e1164.member + 1u), _e1164.member_1);
                                                phi_4546_ = type_19(1u, _e1164.member);
                                            } else {
                                                phi_4517_ = _e1164;
                                                phi_4546_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1182 = phi_4517_;
                                            let _e1184 = phi_4546_;
                                            if (bitcast<i32>(_e1184.member) != 0i) {
                                                let _e1189 = (f64(1f) - _e1170);
                                                let _e1202 = ((_e1152 * ((((_e525 * _e1189) + (_e548 * _e1170)) * (_e1189 * _e1189)) + (((_e571 * _e1189) + (_e582 * _e1170)) * (_e1170 * _e1170)))) - _e916);
                                                if (_e1202 > f64(0f)) {
                                                    phi_4573_ = _e1166;
                                                    phi_4574_ = _e1170;
                                                } else {
                                                    phi_4573_ = _e1170;
                                                    phi_4574_ = _e1168;
                                                }
                                                let _e1206 = phi_4573_;
                                                let _e1208 = phi_4574_;
                                                let _e1210 = ((_e1206 - _e1208) > _e1153);
                                                if _e1210 {
                                                    let _e1212 = (f64(1f) - _e1170);
                                                    let _e1224 = (-(_e1202) / (_e1152 * (((((_e548 - (_e1155 * _e525)) * _e1212) + (_e1158 * _e1170)) * _e1212) + (((_e1158 * _e1212) + (((_e1155 * _e582) - _e571) * _e1170)) * _e1170))));
                                                    if (_e1202 > f64(0f)) {
                                                        phi_4602_ = (_e1154 * _e1153);
                                                    } else {
                                                        phi_4602_ = -((_e1154 * _e1153));
                                                    }
                                                    let _e1231 = phi_4602_;
                                                    let _e1233 = ((_e1170 + _e1224) + _e1231);
                                                    if (_e1233 > _e1208) {
                                                        if (_e1233 < _e1206) {
                                                            if (_e1224 < 0.0lf) {
                                                                phi_4618_ = -(_e1224);
                                                            } else {
                                                                phi_4618_ = _e1224;
                                                            }
                                                            let _e1239 = phi_4618_;
                                                            if (_e1239 < (_e1154 * (_e1206 - _e1208))) {
                                                                phi_4625_ = false;
                                                            } else {
                                                                phi_4625_ = true;
                                                            }
                                                            let _e1244 = phi_4625_;
                                                            phi_4626_ = _e1244;
                                                        } else {
                                                            phi_4626_ = true;
                                                        }
                                                        let _e1246 = phi_4626_;
                                                        phi_4627_ = _e1246;
                                                    } else {
                                                        phi_4627_ = true;
                                                    }
                                                    let _e1248 = phi_4627_;
                                                    if _e1248 {
                                                        phi_4633_ = (_e1154 * (_e1208 + _e1206));
                                                    } else {
                                                        phi_4633_ = _e1233;
                                                    }
                                                    let _e1252 = phi_4633_;
                                                    phi_4634_ = _e1252;
                                                    phi_4635_ = false;
                                                } else {
                                                    phi_4634_ = f64();
                                                    phi_4635_ = true;
                                                }
                                                let _e1254 = phi_4634_;
                                                let _e1256 = phi_4635_;
                                                phi_4520_ = _e1206;
                                                phi_4522_ = _e1208;
                                                phi_4524_ = _e1254;
                                                phi_4636_ = _e1208;
                                                phi_4637_ = _e1210;
                                                phi_4638_ = _e1256;
                                            } else {
                                                phi_4520_ = f64();
                                                phi_4522_ = f64();
                                                phi_4524_ = f64();
                                                phi_4636_ = f64();
                                                phi_4637_ = false;
                                                phi_4638_ = false;
                                            }
                                            let _e1258 = phi_4520_;
                                            let _e1260 = phi_4522_;
                                            let _e1262 = phi_4524_;
                                            let _e1264 = phi_4636_;
                                            let _e1266 = phi_4637_;
                                            let _e1268 = phi_4638_;
                                            local_22 = _e1268;
                                            local_52 = _e1264;
                                            continue;
                                            continuing {
                                                phi_4516_ = _e1182;
                                                phi_4519_ = _e1258;
                                                phi_4521_ = _e1260;
                                                phi_4523_ = _e1262;
                                                break if !(_e1266);
                                            }
                                        }
                                        let _e1271 = local_22;
                                        if _e1271 {
                                            let _e5131 = local_52;
                                            phi_4642_ = _e5131;
                                        } else {
                                            let _e5133 = local_53;
                                            phi_4642_ = _e5133;
                                        }
                                        let _e1273 = phi_4642_;
                                        phi_4643_ = _e1273;
                                    } else {
                                        phi_4643_ = _e1082;
                                    }
                                    let _e1275 = phi_4643_;
                                    if _e1121 {
                                        phi_4651_ = type_19(0u, 64u);
                                        phi_4654_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1279 = phi_4651_;
                                            let _e1281 = phi_4654_;
                                            if (_e1279.member < _e1279.member_1) {
                                                phi_4652_ = type_19((_e1279.member + 1u), _e1279.member_1);
                                                phi_4677_ = type_19(1u, _e1279.member);
                                            } else {
                                                phi_4652_ = _e1279;
                                                phi_4677_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1293 = phi_4652_;
                                            let _e1295 = phi_4677_;
                                            if (bitcast<i32>(_e1295.member) != 0i) {
                                                let _e1299 = (_e1275 + _e1281);
                                                if (_e1299 < _e1085) {
                                                    let _e1302 = (f64(1f) - _e1299);
                                                    let _e1313 = ((((_e525 * _e1302) + (_e548 * _e1299)) * (_e1302 * _e1302)) + (((_e571 * _e1302) + (_e582 * _e1299)) * (_e1299 * _e1299)));
                                                    let _e1315 = (f64(1f) - _e1275);
                                                    let _e1326 = ((((_e525 * _e1315) + (_e548 * _e1275)) * (_e1315 * _e1315)) + (((_e571 * _e1315) + (_e582 * _e1275)) * (_e1275 * _e1275)));
                                                    if (_e1313 < 0.0lf) {
                                                        phi_4720_ = -(_e1313);
                                                    } else {
                                                        phi_4720_ = _e1313;
                                                    }
                                                    let _e1330 = phi_4720_;
                                                    if (_e1330 > _e916) {
                                                        if (_e1326 < 0.0lf) {
                                                            phi_4730_ = -(_e1326);
                                                        } else {
                                                            phi_4730_ = _e1326;
                                                        }
                                                        let _e1335 = phi_4730_;
                                                        if (_e1335 > _e916) {
                                                            phi_4740_ = ((_e1313 > f64(0f)) == (_e1326 > f64(0f)));
                                                        } else {
                                                            phi_4740_ = false;
                                                        }
                                                        let _e1343 = phi_4740_;
                                                        phi_4742_ = !(_e1343);
                                                    } else {
                                                        phi_4742_ = false;
                                                    }
                                                    let _e1346 = phi_4742_;
                                                    if _e1346 {
                                                        phi_4747_ = f64();
                                                        phi_4748_ = false;
                                                    } else {
                                                        phi_4747_ = (_e1281 + _e1281);
                                                        phi_4748_ = true;
                                                    }
                                                    let _e1349 = phi_4747_;
                                                    let _e1351 = phi_4748_;
                                                    phi_4749_ = _e1349;
                                                    phi_4750_ = _e1351;
                                                    phi_4751_ = _e1346;
                                                    phi_4752_ = false;
                                                } else {
                                                    phi_4749_ = f64();
                                                    phi_4750_ = false;
                                                    phi_4751_ = false;
                                                    phi_4752_ = true;
                                                }
                                                let _e1353 = phi_4749_;
                                                let _e1355 = phi_4750_;
                                                let _e1357 = phi_4751_;
                                                let _e1359 = phi_4752_;
                                                phi_4753_ = _e1299;
                                                phi_4655_ = _e1353;
                                                phi_4754_ = _e1355;
                                                phi_4755_ = _e1357;
                                                phi_4756_ = _e1359;
                                                phi_4757_ = false;
                                            } else {
                                                phi_4753_ = f64();
                                                phi_4655_ = f64();
                                                phi_4754_ = false;
                                                phi_4755_ = false;
                                                phi_4756_ = false;
                                                phi_4757_ = true;
                                            }
                                            let _e1361 = phi_4753_;
                                            let _e1363 = phi_4655_;
                                            let _e1365 = phi_4754_;
                                            let _e1367 = phi_4755_;
                                            let _e1369 = phi_4756_;
                                            let _e1371 = phi_4757_;
                                            local_23 = _e1367;
                                            local_54 = _e1369;
                                            local_55 = _e1371;
                                            local_56 = _e1361;
                                            continue;
                                            continuing {
                                                phi_4651_ = _e1293;
                                                phi_4654_ = _e1363;
                                                break if !(_e1365);
                                            }
                                        }
                                        let _e1374 = local_23;
                                        if _e1374 {
                                            phi_4761_ = false;
                                            phi_4762_ = false;
                                        } else {
                                            let _e5158 = local_54;
                                            phi_4761_ = _e5158;
                                            let _e5161 = local_55;
                                            phi_4762_ = _e5161;
                                        }
                                        let _e1376 = phi_4761_;
                                        let _e1378 = phi_4762_;
                                        if _e1376 {
                                            phi_4766_ = true;
                                        } else {
                                            phi_4766_ = _e1378;
                                        }
                                        let _e1380 = phi_4766_;
                                        if _e1380 {
                                            phi_4770_ = _e1085;
                                        } else {
                                            let _e5165 = local_56;
                                            phi_4770_ = _e5165;
                                        }
                                        let _e1382 = phi_4770_;
                                        phi_4771_ = _e1382;
                                    } else {
                                        phi_4771_ = _e1085;
                                    }
                                    let _e1384 = phi_4771_;
                                    phi_4773_ = type_41(_e1275, _e1384, _e1135);
                                } else {
                                    phi_4773_ = _e1145;
                                }
                                let _e1387 = phi_4773_;
                                if (_e1387.member > _e1387.member_1) {
                                    phi_7405_ = f64();
                                    phi_7406_ = true;
                                    phi_7407_ = false;
                                    phi_7408_ = false;
                                    phi_7409_ = false;
                                } else {
                                    let _e1395 = ((_e1387.member_1 - _e1387.member) * f64(0.5f));
                                    let _e1396 = (_e1387.member + _e1395);
                                    let _e1399 = (_e1395 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1401 = local_20.member_3;
                                    let _e1404 = local_20.member[0u];
                                    if (_e1404[0] < 0.0lf) {
                                        phi_4804_ = -(_e1404[0]);
                                    } else {
                                        phi_4804_ = _e1404[0];
                                    }
                                    let _e1411 = phi_4804_;
                                    if (_e1404[1] < 0.0lf) {
                                        phi_4811_ = -(_e1404[1]);
                                    } else {
                                        phi_4811_ = _e1404[1];
                                    }
                                    let _e1415 = phi_4811_;
                                    if (_e1411 > _e1415) {
                                        phi_4816_ = _e1411;
                                    } else {
                                        phi_4816_ = _e1415;
                                    }
                                    let _e1418 = phi_4816_;
                                    if (_e1404[2] < 0.0lf) {
                                        phi_4823_ = -(_e1404[2]);
                                    } else {
                                        phi_4823_ = _e1404[2];
                                    }
                                    let _e1422 = phi_4823_;
                                    if (_e1418 > _e1422) {
                                        phi_4828_ = _e1418;
                                    } else {
                                        phi_4828_ = _e1422;
                                    }
                                    let _e1425 = phi_4828_;
                                    let _e1427 = local_20.member[1u];
                                    if (_e1427[0] < 0.0lf) {
                                        phi_4841_ = -(_e1427[0]);
                                    } else {
                                        phi_4841_ = _e1427[0];
                                    }
                                    let _e1434 = phi_4841_;
                                    if (_e1427[1] < 0.0lf) {
                                        phi_4848_ = -(_e1427[1]);
                                    } else {
                                        phi_4848_ = _e1427[1];
                                    }
                                    let _e1438 = phi_4848_;
                                    if (_e1434 > _e1438) {
                                        phi_4853_ = _e1434;
                                    } else {
                                        phi_4853_ = _e1438;
                                    }
                                    let _e1441 = phi_4853_;
                                    if (_e1427[2] < 0.0lf) {
                                        phi_4860_ = -(_e1427[2]);
                                    } else {
                                        phi_4860_ = _e1427[2];
                                    }
                                    let _e1445 = phi_4860_;
                                    if (_e1441 > _e1445) {
                                        phi_4865_ = _e1441;
                                    } else {
                                        phi_4865_ = _e1445;
                                    }
                                    let _e1448 = phi_4865_;
                                    if (_e1425 > _e1448) {
                                        phi_4870_ = _e1425;
                                    } else {
                                        phi_4870_ = _e1448;
                                    }
                                    let _e1451 = phi_4870_;
                                    let _e1454 = local_20.member[0u];
                                    let _e1459 = local_20.member[1u];
                                    let _e1469 = (_e1454[0] + ((_e1459[0] - _e1454[0]) * _e1396));
                                    let _e1470 = (_e1454[1] + ((_e1459[1] - _e1454[1]) * _e1396));
                                    let _e1471 = (_e1454[2] + ((_e1459[2] - _e1454[2]) * _e1396));
                                    let _e1473 = local_20.member[1u];
                                    let _e1478 = local_20.member[0u];
                                    let _e1482 = (_e1473[0] - _e1478[0]);
                                    let _e1483 = (_e1473[1] - _e1478[1]);
                                    let _e1484 = (_e1473[2] - _e1478[2]);
                                    if (_e1482 < 0.0lf) {
                                        phi_4929_ = -(_e1482);
                                    } else {
                                        phi_4929_ = _e1482;
                                    }
                                    let _e1488 = phi_4929_;
                                    if (_e1483 < 0.0lf) {
                                        phi_4935_ = -(_e1483);
                                    } else {
                                        phi_4935_ = _e1483;
                                    }
                                    let _e1492 = phi_4935_;
                                    if (_e1488 > _e1492) {
                                        phi_4940_ = _e1488;
                                    } else {
                                        phi_4940_ = _e1492;
                                    }
                                    let _e1495 = phi_4940_;
                                    if (_e1484 < 0.0lf) {
                                        phi_4946_ = -(_e1484);
                                    } else {
                                        phi_4946_ = _e1484;
                                    }
                                    let _e1499 = phi_4946_;
                                    if (_e1495 > _e1499) {
                                        phi_4951_ = _e1495;
                                    } else {
                                        phi_4951_ = _e1499;
                                    }
                                    let _e1502 = phi_4951_;
                                    let _e1510 = ((((_e1399 * _e1502) * f64(1.01f)) + ((_e1451 + _e1401) * (1.1102230246251565e-16lf * f64(8f)))) + _e1401);
                                    if (_e1469 < 0.0lf) {
                                        phi_4965_ = -(_e1469);
                                    } else {
                                        phi_4965_ = _e1469;
                                    }
                                    let _e1514 = phi_4965_;
                                    if (_e1470 < 0.0lf) {
                                        phi_4971_ = -(_e1470);
                                    } else {
                                        phi_4971_ = _e1470;
                                    }
                                    let _e1518 = phi_4971_;
                                    if (_e1514 > _e1518) {
                                        phi_4976_ = _e1514;
                                    } else {
                                        phi_4976_ = _e1518;
                                    }
                                    let _e1521 = phi_4976_;
                                    if (_e1471 < 0.0lf) {
                                        phi_4982_ = -(_e1471);
                                    } else {
                                        phi_4982_ = _e1471;
                                    }
                                    let _e1525 = phi_4982_;
                                    if (_e1521 > _e1525) {
                                        phi_4987_ = _e1521;
                                    } else {
                                        phi_4987_ = _e1525;
                                    }
                                    let _e1528 = phi_4987_;
                                    local_3 = type_33(array<f64, 3>(_e1469, _e1470, _e1471), _e1510, (_e1528 + _e1510));
                                    let _e1534 = local_20.member_3;
                                    let _e1536 = local_20.member_1[0u];
                                    if (_e1536[0] < 0.0lf) {
                                        phi_5013_ = -(_e1536[0]);
                                    } else {
                                        phi_5013_ = _e1536[0];
                                    }
                                    let _e1543 = phi_5013_;
                                    if (_e1536[1] < 0.0lf) {
                                        phi_5020_ = -(_e1536[1]);
                                    } else {
                                        phi_5020_ = _e1536[1];
                                    }
                                    let _e1547 = phi_5020_;
                                    if (_e1543 > _e1547) {
                                        phi_5025_ = _e1543;
                                    } else {
                                        phi_5025_ = _e1547;
                                    }
                                    let _e1550 = phi_5025_;
                                    if (_e1536[2] < 0.0lf) {
                                        phi_5032_ = -(_e1536[2]);
                                    } else {
                                        phi_5032_ = _e1536[2];
                                    }
                                    let _e1554 = phi_5032_;
                                    if (_e1550 > _e1554) {
                                        phi_5037_ = _e1550;
                                    } else {
                                        phi_5037_ = _e1554;
                                    }
                                    let _e1557 = phi_5037_;
                                    let _e1559 = local_20.member_1[1u];
                                    if (_e1559[0] < 0.0lf) {
                                        phi_5050_ = -(_e1559[0]);
                                    } else {
                                        phi_5050_ = _e1559[0];
                                    }
                                    let _e1566 = phi_5050_;
                                    if (_e1559[1] < 0.0lf) {
                                        phi_5057_ = -(_e1559[1]);
                                    } else {
                                        phi_5057_ = _e1559[1];
                                    }
                                    let _e1570 = phi_5057_;
                                    if (_e1566 > _e1570) {
                                        phi_5062_ = _e1566;
                                    } else {
                                        phi_5062_ = _e1570;
                                    }
                                    let _e1573 = phi_5062_;
                                    if (_e1559[2] < 0.0lf) {
                                        phi_5069_ = -(_e1559[2]);
                                    } else {
                                        phi_5069_ = _e1559[2];
                                    }
                                    let _e1577 = phi_5069_;
                                    if (_e1573 > _e1577) {
                                        phi_5074_ = _e1573;
                                    } else {
                                        phi_5074_ = _e1577;
                                    }
                                    let _e1580 = phi_5074_;
                                    if (_e1557 > _e1580) {
                                        phi_5079_ = _e1557;
                                    } else {
                                        phi_5079_ = _e1580;
                                    }
                                    let _e1583 = phi_5079_;
                                    let _e1586 = local_20.member_1[0u];
                                    let _e1591 = local_20.member_1[1u];
                                    let _e1601 = (_e1586[0] + ((_e1591[0] - _e1586[0]) * _e1396));
                                    let _e1602 = (_e1586[1] + ((_e1591[1] - _e1586[1]) * _e1396));
                                    let _e1603 = (_e1586[2] + ((_e1591[2] - _e1586[2]) * _e1396));
                                    let _e1605 = local_20.member_1[1u];
                                    let _e1610 = local_20.member_1[0u];
                                    let _e1614 = (_e1605[0] - _e1610[0]);
                                    let _e1615 = (_e1605[1] - _e1610[1]);
                                    let _e1616 = (_e1605[2] - _e1610[2]);
                                    if (_e1614 < 0.0lf) {
                                        phi_5138_ = -(_e1614);
                                    } else {
                                        phi_5138_ = _e1614;
                                    }
                                    let _e1620 = phi_5138_;
                                    if (_e1615 < 0.0lf) {
                                        phi_5144_ = -(_e1615);
                                    } else {
                                        phi_5144_ = _e1615;
                                    }
                                    let _e1624 = phi_5144_;
                                    if (_e1620 > _e1624) {
                                        phi_5149_ = _e1620;
                                    } else {
                                        phi_5149_ = _e1624;
                                    }
                                    let _e1627 = phi_5149_;
                                    if (_e1616 < 0.0lf) {
                                        phi_5155_ = -(_e1616);
                                    } else {
                                        phi_5155_ = _e1616;
                                    }
                                    let _e1631 = phi_5155_;
                                    if (_e1627 > _e1631) {
                                        phi_5160_ = _e1627;
                                    } else {
                                        phi_5160_ = _e1631;
                                    }
                                    let _e1634 = phi_5160_;
                                    let _e1642 = ((((_e1399 * _e1634) * f64(1.01f)) + ((_e1583 + _e1534) * (1.1102230246251565e-16lf * f64(8f)))) + _e1534);
                                    if (_e1601 < 0.0lf) {
                                        phi_5174_ = -(_e1601);
                                    } else {
                                        phi_5174_ = _e1601;
                                    }
                                    let _e1646 = phi_5174_;
                                    if (_e1602 < 0.0lf) {
                                        phi_5180_ = -(_e1602);
                                    } else {
                                        phi_5180_ = _e1602;
                                    }
                                    let _e1650 = phi_5180_;
                                    if (_e1646 > _e1650) {
                                        phi_5185_ = _e1646;
                                    } else {
                                        phi_5185_ = _e1650;
                                    }
                                    let _e1653 = phi_5185_;
                                    if (_e1603 < 0.0lf) {
                                        phi_5191_ = -(_e1603);
                                    } else {
                                        phi_5191_ = _e1603;
                                    }
                                    let _e1657 = phi_5191_;
                                    if (_e1653 > _e1657) {
                                        phi_5196_ = _e1653;
                                    } else {
                                        phi_5196_ = _e1657;
                                    }
                                    let _e1660 = phi_5196_;
                                    local_4 = type_33(array<f64, 3>(_e1601, _e1602, _e1603), _e1642, (_e1660 + _e1642));
                                    let _e1666 = local_20.member_3;
                                    let _e1668 = local_20.member_2[0u];
                                    if (_e1668[0] < 0.0lf) {
                                        phi_5222_ = -(_e1668[0]);
                                    } else {
                                        phi_5222_ = _e1668[0];
                                    }
                                    let _e1675 = phi_5222_;
                                    if (_e1668[1] < 0.0lf) {
                                        phi_5229_ = -(_e1668[1]);
                                    } else {
                                        phi_5229_ = _e1668[1];
                                    }
                                    let _e1679 = phi_5229_;
                                    if (_e1675 > _e1679) {
                                        phi_5234_ = _e1675;
                                    } else {
                                        phi_5234_ = _e1679;
                                    }
                                    let _e1682 = phi_5234_;
                                    if (_e1668[2] < 0.0lf) {
                                        phi_5241_ = -(_e1668[2]);
                                    } else {
                                        phi_5241_ = _e1668[2];
                                    }
                                    let _e1686 = phi_5241_;
                                    if (_e1682 > _e1686) {
                                        phi_5246_ = _e1682;
                                    } else {
                                        phi_5246_ = _e1686;
                                    }
                                    let _e1689 = phi_5246_;
                                    let _e1691 = local_20.member_2[1u];
                                    if (_e1691[0] < 0.0lf) {
                                        phi_5259_ = -(_e1691[0]);
                                    } else {
                                        phi_5259_ = _e1691[0];
                                    }
                                    let _e1698 = phi_5259_;
                                    if (_e1691[1] < 0.0lf) {
                                        phi_5266_ = -(_e1691[1]);
                                    } else {
                                        phi_5266_ = _e1691[1];
                                    }
                                    let _e1702 = phi_5266_;
                                    if (_e1698 > _e1702) {
                                        phi_5271_ = _e1698;
                                    } else {
                                        phi_5271_ = _e1702;
                                    }
                                    let _e1705 = phi_5271_;
                                    if (_e1691[2] < 0.0lf) {
                                        phi_5278_ = -(_e1691[2]);
                                    } else {
                                        phi_5278_ = _e1691[2];
                                    }
                                    let _e1709 = phi_5278_;
                                    if (_e1705 > _e1709) {
                                        phi_5283_ = _e1705;
                                    } else {
                                        phi_5283_ = _e1709;
                                    }
                                    let _e1712 = phi_5283_;
                                    if (_e1689 > _e1712) {
                                        phi_5288_ = _e1689;
                                    } else {
                                        phi_5288_ = _e1712;
                                    }
                                    let _e1715 = phi_5288_;
                                    let _e1718 = local_20.member_2[0u];
                                    let _e1723 = local_20.member_2[1u];
                                    let _e1733 = (_e1718[0] + ((_e1723[0] - _e1718[0]) * _e1396));
                                    let _e1734 = (_e1718[1] + ((_e1723[1] - _e1718[1]) * _e1396));
                                    let _e1735 = (_e1718[2] + ((_e1723[2] - _e1718[2]) * _e1396));
                                    let _e1737 = local_20.member_2[1u];
                                    let _e1742 = local_20.member_2[0u];
                                    let _e1746 = (_e1737[0] - _e1742[0]);
                                    let _e1747 = (_e1737[1] - _e1742[1]);
                                    let _e1748 = (_e1737[2] - _e1742[2]);
                                    if (_e1746 < 0.0lf) {
                                        phi_5347_ = -(_e1746);
                                    } else {
                                        phi_5347_ = _e1746;
                                    }
                                    let _e1752 = phi_5347_;
                                    if (_e1747 < 0.0lf) {
                                        phi_5353_ = -(_e1747);
                                    } else {
                                        phi_5353_ = _e1747;
                                    }
                                    let _e1756 = phi_5353_;
                                    if (_e1752 > _e1756) {
                                        phi_5358_ = _e1752;
                                    } else {
                                        phi_5358_ = _e1756;
                                    }
                                    let _e1759 = phi_5358_;
                                    if (_e1748 < 0.0lf) {
                                        phi_5364_ = -(_e1748);
                                    } else {
                                        phi_5364_ = _e1748;
                                    }
                                    let _e1763 = phi_5364_;
                                    if (_e1759 > _e1763) {
                                        phi_5369_ = _e1759;
                                    } else {
                                        phi_5369_ = _e1763;
                                    }
                                    let _e1766 = phi_5369_;
                                    let _e1774 = ((((_e1399 * _e1766) * f64(1.01f)) + ((_e1715 + _e1666) * (1.1102230246251565e-16lf * f64(8f)))) + _e1666);
                                    if (_e1733 < 0.0lf) {
                                        phi_5383_ = -(_e1733);
                                    } else {
                                        phi_5383_ = _e1733;
                                    }
                                    let _e1778 = phi_5383_;
                                    if (_e1734 < 0.0lf) {
                                        phi_5389_ = -(_e1734);
                                    } else {
                                        phi_5389_ = _e1734;
                                    }
                                    let _e1782 = phi_5389_;
                                    if (_e1778 > _e1782) {
                                        phi_5394_ = _e1778;
                                    } else {
                                        phi_5394_ = _e1782;
                                    }
                                    let _e1785 = phi_5394_;
                                    if (_e1735 < 0.0lf) {
                                        phi_5400_ = -(_e1735);
                                    } else {
                                        phi_5400_ = _e1735;
                                    }
                                    let _e1789 = phi_5400_;
                                    if (_e1785 > _e1789) {
                                        phi_5405_ = _e1785;
                                    } else {
                                        phi_5405_ = _e1789;
                                    }
                                    let _e1792 = phi_5405_;
                                    local_5 = type_33(array<f64, 3>(_e1733, _e1734, _e1735), _e1774, (_e1792 + _e1774));
                                    let _e1797 = local_4.member;
                                    let _e1802 = local_5.member;
                                    let _e1808 = ((_e1797[1] * _e1802[2]) - (_e1797[2] * _e1802[1]));
                                    let _e1811 = ((_e1797[2] * _e1802[0]) - (_e1797[0] * _e1802[2]));
                                    let _e1814 = ((_e1797[0] * _e1802[1]) - (_e1797[1] * _e1802[0]));
                                    if (_e1808 < 0.0lf) {
                                        phi_5454_ = -(_e1808);
                                    } else {
                                        phi_5454_ = _e1808;
                                    }
                                    let _e1818 = phi_5454_;
                                    if (_e1811 < 0.0lf) {
                                        phi_5460_ = -(_e1811);
                                    } else {
                                        phi_5460_ = _e1811;
                                    }
                                    let _e1822 = phi_5460_;
                                    if (_e1818 > _e1822) {
                                        if (_e1808 < 0.0lf) {
                                            phi_5470_ = -(_e1808);
                                        } else {
                                            phi_5470_ = _e1808;
                                        }
                                        let _e1840 = phi_5470_;
                                        if (_e1814 < 0.0lf) {
                                            phi_5476_ = -(_e1814);
                                        } else {
                                            phi_5476_ = _e1814;
                                        }
                                        let _e1844 = phi_5476_;
                                        if (_e1840 > _e1844) {
                                            phi_5481_ = 2u;
                                            phi_5482_ = 1u;
                                        } else {
                                            phi_5481_ = 1u;
                                            phi_5482_ = 0u;
                                        }
                                        let _e1847 = phi_5481_;
                                        let _e1849 = phi_5482_;
                                        phi_5501_ = _e1847;
                                        phi_5502_ = _e1849;
                                    } else {
                                        if (_e1811 < 0.0lf) {
                                            phi_5488_ = -(_e1811);
                                        } else {
                                            phi_5488_ = _e1811;
                                        }
                                        let _e1827 = phi_5488_;
                                        if (_e1814 < 0.0lf) {
                                            phi_5494_ = -(_e1814);
                                        } else {
                                            phi_5494_ = _e1814;
                                        }
                                        let _e1831 = phi_5494_;
                                        if (_e1827 > _e1831) {
                                            phi_5499_ = 0u;
                                            phi_5500_ = 2u;
                                        } else {
                                            phi_5499_ = 1u;
                                            phi_5500_ = 0u;
                                        }
                                        let _e1834 = phi_5499_;
                                        let _e1836 = phi_5500_;
                                        phi_5501_ = _e1834;
                                        phi_5502_ = _e1836;
                                    }
                                    let _e1851 = phi_5501_;
                                    let _e1853 = phi_5502_;
                                    let _e1856 = local_4.member[_e1853];
                                    let _e1859 = local_5.member[_e1851];
                                    let _e1863 = local_4.member[_e1851];
                                    let _e1866 = local_5.member[_e1853];
                                    let _e1868 = ((_e1856 * _e1859) - (_e1863 * _e1866));
                                    let _e1869 = f64(1f);
                                    let _e1871 = local_4.member_1;
                                    let _e1873 = local_5.member_2;
                                    let _e1876 = local_4.member_2;
                                    let _e1878 = local_5.member_1;
                                    let _e1884 = local_4.member_2;
                                    let _e1886 = local_5.member_2;
                                    let _e1895 = local_4.member_2;
                                    let _e1898 = local_5.member_2;
                                    let _e1902 = (((((_e1871 * _e1873) + (_e1876 * _e1878)) * f64(2.01f)) + ((_e1884 * _e1886) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1869 + _e1895) * (_e1869 + _e1898))));
                                    if (_e1868 < 0.0lf) {
                                        phi_5573_ = -(_e1868);
                                    } else {
                                        phi_5573_ = _e1868;
                                    }
                                    let _e1906 = phi_5573_;
                                    if (_e1906 > _e1902) {
                                        if (_e1868 < f64(0f)) {
                                            phi_5585_ = f64(-1f);
                                        } else {
                                            phi_5585_ = f64(1f);
                                        }
                                        let _e1913 = phi_5585_;
                                        let _e1916 = local_3.member[_e1853];
                                        let _e1919 = local_5.member[_e1851];
                                        let _e1923 = local_3.member[_e1851];
                                        let _e1926 = local_5.member[_e1853];
                                        let _e1929 = f64(1f);
                                        let _e1931 = local_3.member_1;
                                        let _e1933 = local_5.member_2;
                                        let _e1936 = local_3.member_2;
                                        let _e1938 = local_5.member_1;
                                        let _e1944 = local_3.member_2;
                                        let _e1946 = local_5.member_2;
                                        let _e1955 = local_3.member_2;
                                        let _e1958 = local_5.member_2;
                                        let _e1962 = (((((_e1931 * _e1933) + (_e1936 * _e1938)) * f64(2.01f)) + ((_e1944 * _e1946) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1929 + _e1955) * (_e1929 + _e1958))));
                                        let _e1965 = local_4.member[_e1853];
                                        let _e1968 = local_3.member[_e1851];
                                        let _e1972 = local_4.member[_e1851];
                                        let _e1975 = local_3.member[_e1853];
                                        let _e1978 = f64(1f);
                                        let _e1980 = local_4.member_1;
                                        let _e1982 = local_3.member_2;
                                        let _e1985 = local_4.member_2;
                                        let _e1987 = local_3.member_1;
                                        let _e1993 = local_4.member_2;
                                        let _e1995 = local_3.member_2;
                                        let _e2004 = local_4.member_2;
                                        let _e2007 = local_3.member_2;
                                        let _e2011 = (((((_e1980 * _e1982) + (_e1985 * _e1987)) * f64(2.01f)) + ((_e1993 * _e1995) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1978 + _e2004) * (_e1978 + _e2007))));
                                        let _e2012 = (_e1868 * _e1913);
                                        let _e2013 = (((_e1916 * _e1919) - (_e1923 * _e1926)) * _e1913);
                                        let _e2014 = (((_e1965 * _e1968) - (_e1972 * _e1975)) * _e1913);
                                        if (_e2012 < 0.0lf) {
                                            phi_5724_ = -(_e2012);
                                        } else {
                                            phi_5724_ = _e2012;
                                        }
                                        let _e2018 = phi_5724_;
                                        if (_e2013 < 0.0lf) {
                                            phi_5730_ = -(_e2013);
                                        } else {
                                            phi_5730_ = _e2013;
                                        }
                                        let _e2022 = phi_5730_;
                                        if (_e2014 < 0.0lf) {
                                            phi_5737_ = -(_e2014);
                                        } else {
                                            phi_5737_ = _e2014;
                                        }
                                        let _e2027 = phi_5737_;
                                        let _e2031 = (((_e2018 + _e2022) + _e2027) * (1.1102230246251565e-16lf * f64(4f)));
                                        local_6[0u].member = _e2013;
                                        local_6[0u].member_1 = _e1962;
                                        local_6[1u].member = _e2014;
                                        local_6[1u].member_1 = _e2011;
                                        local_6[2u].member = (_e2012 - _e2013);
                                        local_6[2u].member_1 = ((_e1902 + _e1962) + _e2031);
                                        local_6[3u].member = (_e2012 - _e2014);
                                        local_6[3u].member_1 = ((_e1902 + _e2011) + _e2031);
                                        phi_5781_ = type_19(0u, 4u);
                                        phi_5784_ = true;
                                        loop {
                                            let _e2052 = phi_5781_;
                                            let _e2054 = phi_5784_;
                                            local_25 = _e2054;
                                            if (_e2052.member < _e2052.member_1) {
                                                phi_5782_ = type_19((_e2052.member + 1u), _e2052.member_1);
                                                phi_5807_ = type_19(1u, _e2052.member);
                                            } else {
                                                phi_5782_ = _e2052;
                                                phi_5807_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e2066 = phi_5782_;
                                            let _e2068 = phi_5807_;
                                            if (bitcast<i32>(_e2068.member) != 0i) {
                                                let _e2075 = local_6[_e2068.member_1].member;
                                                let _e2078 = local_6[_e2068.member_1].member_1;
                                                let _e2080 = (_e2075 < -(_e2078));
                                                if _e2080 {
                                                    phi_5834_ = bool();
                                                    phi_5835_ = false;
                                                } else {
                                                    phi_5834_ = (_e2054 && (_e2075 > _e2078));
                                                    phi_5835_ = true;
                                                }
                                                let _e2084 = phi_5834_;
                                                let _e2086 = phi_5835_;
                                                phi_5785_ = _e2084;
                                                phi_5836_ = _e2086;
                                                phi_5837_ = _e2080;
                                            } else {
                                                phi_5785_ = bool();
                                                phi_5836_ = false;
                                                phi_5837_ = false;
                                            }
                                            let _e2088 = phi_5785_;
                                            let _e2090 = phi_5836_;
                                            let _e2092 = phi_5837_;
                                            local_24 = _e2092;
                                            continue;
                                            continuing {
                                                phi_5781_ = _e2066;
                                                phi_5784_ = _e2088;
                                                break if !(_e2090);
                                            }
                                        }
                                        let _e2095 = local_24;
                                        if _e2095 {
                                            phi_5841_ = false;
                                        } else {
                                            phi_5841_ = true;
                                        }
                                        let _e2097 = phi_5841_;
                                        if _e2097 {
                                            let _e2099 = local_25;
                                            if _e2099 {
                                                phi_5848_ = 1u;
                                            } else {
                                                phi_5848_ = 2u;
                                            }
                                            let _e2101 = phi_5848_;
                                            phi_5849_ = _e2101;
                                            phi_5850_ = false;
                                        } else {
                                            phi_5849_ = u32();
                                            phi_5850_ = true;
                                        }
                                        let _e2103 = phi_5849_;
                                        let _e2105 = phi_5850_;
                                        phi_5851_ = _e2103;
                                        phi_5852_ = 0u;
                                        phi_5853_ = _e2105;
                                    } else {
                                        phi_5851_ = u32();
                                        phi_5852_ = 2u;
                                        phi_5853_ = true;
                                    }
                                    let _e2107 = phi_5851_;
                                    let _e2109 = phi_5852_;
                                    let _e2111 = phi_5853_;
                                    if _e2111 {
                                        phi_5857_ = _e2109;
                                    } else {
                                        phi_5857_ = _e2107;
                                    }
                                    let _e2113 = phi_5857_;
                                    let _e2114 = (_e2113 == 0u);
                                    if _e2114 {
                                        phi_7401_ = f64();
                                        phi_7402_ = false;
                                        phi_7403_ = false;
                                        phi_7404_ = false;
                                    } else {
                                        if (_e2113 == 1u) {
                                            if _e1387.member_2 {
                                                if ((_e1387.member_1 - _e1387.member) <= f64(0.0000005f)) {
                                                    phi_5878_ = false;
                                                } else {
                                                    phi_5878_ = true;
                                                }
                                                let _e2123 = phi_5878_;
                                                phi_5879_ = _e2123;
                                            } else {
                                                phi_5879_ = true;
                                            }
                                            let _e2125 = phi_5879_;
                                            phi_5880_ = _e2125;
                                        } else {
                                            phi_5880_ = true;
                                        }
                                        let _e2127 = phi_5880_;
                                        if _e2127 {
                                            let _e2133 = local_20.member[0u];
                                            let _e2139 = local_20.member_1[0u];
                                            let _e2145 = local_20.member_2[0u];
                                            let _e2149 = (_e2133[0] - _e2139[0]);
                                            let _e2150 = (_e2133[1] - _e2139[1]);
                                            let _e2151 = (_e2133[2] - _e2139[2]);
                                            local_1 = array<array<f64, 3>, 4>(_e2133, array<f64, 3>(_e2149, _e2150, _e2151), array<f64, 3>((_e2133[0] - _e2145[0]), (_e2133[1] - _e2145[1]), (_e2133[2] - _e2145[2])), array<f64, 3>((_e2149 - _e2145[0]), (_e2150 - _e2145[1]), (_e2151 - _e2145[2])));
                                            let _e2164 = local_20.member[1u];
                                            let _e2170 = local_20.member_1[1u];
                                            let _e2176 = local_20.member_2[1u];
                                            let _e2180 = (_e2164[0] - _e2170[0]);
                                            let _e2181 = (_e2164[1] - _e2170[1]);
                                            let _e2182 = (_e2164[2] - _e2170[2]);
                                            local_2 = array<array<f64, 3>, 4>(_e2164, array<f64, 3>(_e2180, _e2181, _e2182), array<f64, 3>((_e2164[0] - _e2176[0]), (_e2164[1] - _e2176[1]), (_e2164[2] - _e2176[2])), array<f64, 3>((_e2180 - _e2176[0]), (_e2181 - _e2176[1]), (_e2182 - _e2176[2])));
                                            let _e2195 = local_20.member[0u];
                                            if (_e2195[0] < 0.0lf) {
                                                phi_6077_ = -(_e2195[0]);
                                            } else {
                                                phi_6077_ = _e2195[0];
                                            }
                                            let _e2202 = phi_6077_;
                                            if (_e2195[1] < 0.0lf) {
                                                phi_6084_ = -(_e2195[1]);
                                            } else {
                                                phi_6084_ = _e2195[1];
                                            }
                                            let _e2206 = phi_6084_;
                                            if (_e2202 > _e2206) {
                                                phi_6089_ = _e2202;
                                            } else {
                                                phi_6089_ = _e2206;
                                            }
                                            let _e2209 = phi_6089_;
                                            if (_e2195[2] < 0.0lf) {
                                                phi_6096_ = -(_e2195[2]);
                                            } else {
                                                phi_6096_ = _e2195[2];
                                            }
                                            let _e2213 = phi_6096_;
                                            if (_e2209 > _e2213) {
                                                phi_6101_ = _e2209;
                                            } else {
                                                phi_6101_ = _e2213;
                                            }
                                            let _e2216 = phi_6101_;
                                            let _e2219 = local_20.member[1u];
                                            if (_e2219[0] < 0.0lf) {
                                                phi_6114_ = -(_e2219[0]);
                                            } else {
                                                phi_6114_ = _e2219[0];
                                            }
                                            let _e2226 = phi_6114_;
                                            if (_e2219[1] < 0.0lf) {
                                                phi_6121_ = -(_e2219[1]);
                                            } else {
                                                phi_6121_ = _e2219[1];
                                            }
                                            let _e2230 = phi_6121_;
                                            if (_e2226 > _e2230) {
                                                phi_6126_ = _e2226;
                                            } else {
                                                phi_6126_ = _e2230;
                                            }
                                            let _e2233 = phi_6126_;
                                            if (_e2219[2] < 0.0lf) {
                                                phi_6133_ = -(_e2219[2]);
                                            } else {
                                                phi_6133_ = _e2219[2];
                                            }
                                            let _e2237 = phi_6133_;
                                            if (_e2233 > _e2237) {
                                                phi_6138_ = _e2233;
                                            } else {
                                                phi_6138_ = _e2237;
                                            }
                                            let _e2240 = phi_6138_;
                                            if (_e2216 > _e2240) {
                                                phi_6143_ = _e2216;
                                            } else {
                                                phi_6143_ = _e2240;
                                            }
                                            let _e2243 = phi_6143_;
                                            let _e2245 = local_20.member_3;
                                            let _e2249 = local_20.member_1[0u];
                                            if (_e2249[0] < 0.0lf) {
                                                phi_6160_ = -(_e2249[0]);
                                            } else {
                                                phi_6160_ = _e2249[0];
                                            }
                                            let _e2256 = phi_6160_;
                                            if (_e2249[1] < 0.0lf) {
                                                phi_6167_ = -(_e2249[1]);
                                            } else {
                                                phi_6167_ = _e2249[1];
                                            }
                                            let _e2260 = phi_6167_;
                                            if (_e2256 > _e2260) {
                                                phi_6172_ = _e2256;
                                            } else {
                                                phi_6172_ = _e2260;
                                            }
                                            let _e2263 = phi_6172_;
                                            if (_e2249[2] < 0.0lf) {
                                                phi_6179_ = -(_e2249[2]);
                                            } else {
                                                phi_6179_ = _e2249[2];
                                            }
                                            let _e2267 = phi_6179_;
                                            if (_e2263 > _e2267) {
                                                phi_6184_ = _e2263;
                                            } else {
                                                phi_6184_ = _e2267;
                                            }
                                            let _e2270 = phi_6184_;
                                            let _e2273 = local_20.member_1[1u];
                                            if (_e2273[0] < 0.0lf) {
                                                phi_6198_ = -(_e2273[0]);
                                            } else {
                                                phi_6198_ = _e2273[0];
                                            }
                                            let _e2280 = phi_6198_;
                                            if (_e2273[1] < 0.0lf) {
                                                phi_6205_ = -(_e2273[1]);
                                            } else {
                                                phi_6205_ = _e2273[1];
                                            }
                                            let _e2284 = phi_6205_;
                                            if (_e2280 > _e2284) {
                                                phi_6210_ = _e2280;
                                            } else {
                                                phi_6210_ = _e2284;
                                            }
                                            let _e2287 = phi_6210_;
                                            if (_e2273[2] < 0.0lf) {
                                                phi_6217_ = -(_e2273[2]);
                                            } else {
                                                phi_6217_ = _e2273[2];
                                            }
                                            let _e2291 = phi_6217_;
                                            if (_e2287 > _e2291) {
                                                phi_6222_ = _e2287;
                                            } else {
                                                phi_6222_ = _e2291;
                                            }
                                            let _e2294 = phi_6222_;
                                            if (_e2270 > _e2294) {
                                                phi_6227_ = _e2270;
                                            } else {
                                                phi_6227_ = _e2294;
                                            }
                                            let _e2297 = phi_6227_;
                                            let _e2299 = local_20.member_3;
                                            let _e2303 = local_20.member_2[0u];
                                            if (_e2303[0] < 0.0lf) {
                                                phi_6244_ = -(_e2303[0]);
                                            } else {
                                                phi_6244_ = _e2303[0];
                                            }
                                            let _e2310 = phi_6244_;
                                            if (_e2303[1] < 0.0lf) {
                                                phi_6251_ = -(_e2303[1]);
                                            } else {
                                                phi_6251_ = _e2303[1];
                                            }
                                            let _e2314 = phi_6251_;
                                            if (_e2310 > _e2314) {
                                                phi_6256_ = _e2310;
                                            } else {
                                                phi_6256_ = _e2314;
                                            }
                                            let _e2317 = phi_6256_;
                                            if (_e2303[2] < 0.0lf) {
                                                phi_6263_ = -(_e2303[2]);
                                            } else {
                                                phi_6263_ = _e2303[2];
                                            }
                                            let _e2321 = phi_6263_;
                                            if (_e2317 > _e2321) {
                                                phi_6268_ = _e2317;
                                            } else {
                                                phi_6268_ = _e2321;
                                            }
                                            let _e2324 = phi_6268_;
                                            let _e2327 = local_20.member_2[1u];
                                            if (_e2327[0] < 0.0lf) {
                                                phi_6282_ = -(_e2327[0]);
                                            } else {
                                                phi_6282_ = _e2327[0];
                                            }
                                            let _e2334 = phi_6282_;
                                            if (_e2327[1] < 0.0lf) {
                                                phi_6289_ = -(_e2327[1]);
                                            } else {
                                                phi_6289_ = _e2327[1];
                                            }
                                            let _e2338 = phi_6289_;
                                            if (_e2334 > _e2338) {
                                                phi_6294_ = _e2334;
                                            } else {
                                                phi_6294_ = _e2338;
                                            }
                                            let _e2341 = phi_6294_;
                                            if (_e2327[2] < 0.0lf) {
                                                phi_6301_ = -(_e2327[2]);
                                            } else {
                                                phi_6301_ = _e2327[2];
                                            }
                                            let _e2345 = phi_6301_;
                                            if (_e2341 > _e2345) {
                                                phi_6306_ = _e2341;
                                            } else {
                                                phi_6306_ = _e2345;
                                            }
                                            let _e2348 = phi_6306_;
                                            if (_e2324 > _e2348) {
                                                phi_6311_ = _e2324;
                                            } else {
                                                phi_6311_ = _e2348;
                                            }
                                            let _e2351 = phi_6311_;
                                            let _e2353 = local_20.member_3;
                                            let _e2361 = local_20.member_3;
                                            phi_6331_ = type_19(0u, 48u);
                                            phi_6334_ = _e1387.member;
                                            loop {
                                                let _e2370 = phi_6331_;
                                                let _e2372 = phi_6334_;
                                                local_70 = _e2372;
                                                local_32 = _e2372;
                                                local_33 = _e2372;
                                                local_34 = _e2372;
                                                local_35 = _e2372;
                                                if (_e2370.member < _e2370.member_1) {
                                                    phi_6332_ = type_19((_e2370.member + 1u), _e2370.member_1);
                                                    phi_6357_ = type_19(1u, _e2370.member);
                                                } else {
                                                    phi_6332_ = _e2370;
                                                    phi_6357_ = type_19(0u, type_19().member_1);
                                                }
                                                let _e2384 = phi_6332_;
                                                let _e2386 = phi_6357_;
                                                if (bitcast<i32>(_e2386.member) != 0i) {
                                                    let _e2392 = local_20.member[0u];
                                                    let _e2398 = local_20.member[1u];
                                                    let _e2408 = (_e2392[0] + ((_e2398[0] - _e2392[0]) * _e2372));
                                                    let _e2409 = (_e2392[1] + ((_e2398[1] - _e2392[1]) * _e2372));
                                                    let _e2410 = (_e2392[2] + ((_e2398[2] - _e2392[2]) * _e2372));
                                                    let _e2413 = local_20.member_1[0u];
                                                    let _e2419 = local_20.member_1[1u];
                                                    let _e2429 = (_e2413[0] + ((_e2419[0] - _e2413[0]) * _e2372));
                                                    let _e2430 = (_e2413[1] + ((_e2419[1] - _e2413[1]) * _e2372));
                                                    let _e2431 = (_e2413[2] + ((_e2419[2] - _e2413[2]) * _e2372));
                                                    let _e2434 = local_20.member_2[0u];
                                                    let _e2440 = local_20.member_2[1u];
                                                    let _e2450 = (_e2434[0] + ((_e2440[0] - _e2434[0]) * _e2372));
                                                    let _e2451 = (_e2434[1] + ((_e2440[1] - _e2434[1]) * _e2372));
                                                    let _e2452 = (_e2434[2] + ((_e2440[2] - _e2434[2]) * _e2372));
                                                    let _e2457 = (((_e2429 * _e2429) + (_e2430 * _e2430)) + (_e2431 * _e2431));
                                                    let _e2462 = (((_e2429 * _e2450) + (_e2430 * _e2451)) + (_e2431 * _e2452));
                                                    let _e2467 = (((_e2450 * _e2450) + (_e2451 * _e2451)) + (_e2452 * _e2452));
                                                    let _e2472 = (((_e2408 * _e2429) + (_e2409 * _e2430)) + (_e2410 * _e2431));
                                                    let _e2477 = (((_e2408 * _e2450) + (_e2409 * _e2451)) + (_e2410 * _e2452));
                                                    let _e2480 = ((_e2457 * _e2467) - (_e2462 * _e2462));
                                                    let _e2481 = f64(0f);
                                                    let _e2482 = f64(1f);
                                                    let _e2486 = (((_e2472 * _e2467) - (_e2477 * _e2462)) / _e2480);
                                                    let _e2490 = (((_e2477 * _e2457) - (_e2472 * _e2462)) / _e2480);
                                                    if (_e2486 >= _e2481) {
                                                        if (_e2490 >= _e2481) {
                                                            if (_e2486 <= _e2482) {
                                                                phi_6513_ = (_e2490 <= _e2482);
                                                                phi_6514_ = false;
                                                            } else {
                                                                phi_6513_ = bool();
                                                                phi_6514_ = true;
                                                            }
                                                            let _e2496 = phi_6513_;
                                                            let _e2498 = phi_6514_;
                                                            phi_6515_ = _e2496;
                                                            phi_6516_ = _e2498;
                                                        } else {
                                                            phi_6515_ = bool();
                                                            phi_6516_ = true;
                                                        }
                                                        let _e2500 = phi_6515_;
                                                        let _e2502 = phi_6516_;
                                                        phi_6517_ = _e2500;
                                                        phi_6518_ = _e2502;
                                                    } else {
                                                        phi_6517_ = bool();
                                                        phi_6518_ = true;
                                                    }
                                                    let _e2504 = phi_6517_;
                                                    let _e2506 = phi_6518_;
                                                    if _e2506 {
                                                        phi_6522_ = false;
                                                    } else {
                                                        phi_6522_ = _e2504;
                                                    }
                                                    let _e2508 = phi_6522_;
                                                    if (_e2480 > _e2481) {
                                                        if _e2508 {
                                                            phi_6562_ = array<f64, 3>((_e2408 - ((_e2429 * _e2486) + (_e2450 * _e2490))), (_e2409 - ((_e2430 * _e2486) + (_e2451 * _e2490))), (_e2410 - ((_e2431 * _e2486) + (_e2452 * _e2490))));
                                                            phi_6563_ = false;
                                                        } else {
                                                            phi_6562_ = array<f64, 3>();
                                                            phi_6563_ = true;
                                                        }
                                                        let _e2524 = phi_6562_;
                                                        let _e2526 = phi_6563_;
                                                        phi_6564_ = _e2524;
                                                        phi_6565_ = _e2526;
                                                    } else {
                                                        phi_6564_ = array<f64, 3>();
                                                        phi_6565_ = true;
                                                    }
                                                    let _e2528 = phi_6564_;
                                                    let _e2530 = phi_6565_;
                                                    if _e2530 {
                                                        let _e2531 = (_e2408 - _e2429);
                                                        let _e2532 = (_e2409 - _e2430);
                                                        let _e2533 = (_e2410 - _e2431);
                                                        let _e2544 = ((((_e2408 * _e2429) + (_e2409 * _e2430)) + (_e2410 * _e2431)) / (((_e2429 * _e2429) + (_e2430 * _e2430)) + (_e2431 * _e2431)));
                                                        if (_e2544 > f64(0f)) {
                                                            if (_e2544 < f64(1f)) {
                                                                phi_6598_ = _e2544;
                                                            } else {
                                                                phi_6598_ = f64(1f);
                                                            }
                                                            let _e2552 = phi_6598_;
                                                            phi_6600_ = _e2552;
                                                        } else {
                                                            phi_6600_ = f64(0f);
                                                        }
                                                        let _e2554 = phi_6600_;
                                                        let _e2571 = ((((_e2408 * _e2450) + (_e2409 * _e2451)) + (_e2410 * _e2452)) / (((_e2450 * _e2450) + (_e2451 * _e2451)) + (_e2452 * _e2452)));
                                                        if (_e2571 > f64(0f)) {
                                                            if (_e2571 < f64(1f)) {
                                                                phi_6630_ = _e2571;
                                                            } else {
                                                                phi_6630_ = f64(1f);
                                                            }
                                                            let _e2579 = phi_6630_;
                                                            phi_6632_ = _e2579;
                                                        } else {
                                                            phi_6632_ = f64(0f);
                                                        }
                                                        let _e2581 = phi_6632_;
                                                        let _e2598 = ((((_e2531 * _e2450) + (_e2532 * _e2451)) + (_e2533 * _e2452)) / (((_e2450 * _e2450) + (_e2451 * _e2451)) + (_e2452 * _e2452)));
                                                        if (_e2598 > f64(0f)) {
                                                            if (_e2598 < f64(1f)) {
                                                                phi_6662_ = _e2598;
                                                            } else {
                                                                phi_6662_ = f64(1f);
                                                            }
                                                            let _e2606 = phi_6662_;
                                                            phi_6664_ = _e2606;
                                                        } else {
                                                            phi_6664_ = f64(0f);
                                                        }
                                                        let _e2608 = phi_6664_;
                                                        let _e2615 = (_e2408 - _e2450);
                                                        let _e2616 = (_e2409 - _e2451);
                                                        let _e2617 = (_e2410 - _e2452);
                                                        let _e2628 = ((((_e2615 * _e2429) + (_e2616 * _e2430)) + (_e2617 * _e2431)) / (((_e2429 * _e2429) + (_e2430 * _e2430)) + (_e2431 * _e2431)));
                                                        if (_e2628 > f64(0f)) {
                                                            if (_e2628 < f64(1f)) {
                                                                phi_6697_ = _e2628;
                                                            } else {
                                                                phi_6697_ = f64(1f);
                                                            }
                                                            let _e2636 = phi_6697_;
                                                            phi_6699_ = _e2636;
                                                        } else {
                                                            phi_6699_ = f64(0f);
                                                        }
                                                        let _e2638 = phi_6699_;
                                                        local[0u] = array<f64, 3>((_e2408 - (_e2429 * _e2554)), (_e2409 - (_e2430 * _e2554)), (_e2410 - (_e2431 * _e2554)));
                                                        local[1u] = array<f64, 3>((_e2408 - (_e2450 * _e2581)), (_e2409 - (_e2451 * _e2581)), (_e2410 - (_e2452 * _e2581)));
                                                        local[2u] = array<f64, 3>((_e2531 - (_e2450 * _e2608)), (_e2532 - (_e2451 * _e2608)), (_e2533 - (_e2452 * _e2608)));
                                                        local[3u] = array<f64, 3>((_e2615 - (_e2429 * _e2638)), (_e2616 - (_e2430 * _e2638)), (_e2617 - (_e2431 * _e2638)));
                                                        let _e2654 = local[0u];
                                                        phi_6854_ = type_19(1u, 4u);
                                                        phi_6857_ = array<f64, 3>(_e2654[0], _e2654[1], _e2654[2]);
                                                        loop {
                                                            let _e2660 = phi_6854_;
                                                            let _e2662 = phi_6857_;
                                                            local_57 = _e2662;
                                                            if (_e2660.member < _e2660.member_1) {
                                                                phi_6855_ = type_19((_e2660.member + 1u), _e2660.member_1);
                                                                phi_6880_ = type_19(1u, _e2660.member);
                                                            } else {
                                                                phi_6855_ = _e2660;
                                                                phi_6880_ = type_19(0u, type_19().member_1);
                                                            }
                                                            let _e2674 = phi_6855_;
                                                            let _e2676 = phi_6880_;
                                                            let _e2680 = (bitcast<i32>(_e2676.member) != 0i);
                                                            if _e2680 {
                                                                let _e2682 = local[_e2676.member_1];
                                                                let _e2687 = local[_e2676.member_1];
                                                                if ((((_e2682[0] * _e2687[0]) + (_e2682[1] * _e2687[1])) + (_e2682[2] * _e2687[2])) < (((_e2662[0] * _e2662[0]) + (_e2662[1] * _e2662[1])) + (_e2662[2] * _e2662[2]))) {
                                                                    let _e2709 = local[_e2676.member_1];
                                                                    phi_6947_ = array<f64, 3>(_e2709[0], _e2709[1], _e2709[2]);
                                                                } else {
                                                                    phi_6947_ = _e2662;
                                                                }
                                                                let _e2715 = phi_6947_;
                                                                phi_6858_ = _e2715;
                                                            } else {
                                                                phi_6858_ = array<f64, 3>();
                                                            }
                                                            let _e2717 = phi_6858_;
                                                            continue;
                                                            continuing {
                                                                phi_6854_ = _e2674;
                                                                phi_6857_ = _e2717;
                                                                break if !(_e2680);
                                                            }
                                                        }
                                                        let _e5334 = local_57;
                                                        phi_6948_ = _e5334;
                                                    } else {
                                                        phi_6948_ = _e2528;
                                                    }
                                                    let _e2720 = phi_6948_;
                                                    if (_e2720[0] < 0.0lf) {
                                                        phi_6955_ = -(_e2720[0]);
                                                    } else {
                                                        phi_6955_ = _e2720[0];
                                                    }
                                                    let _e2725 = phi_6955_;
                                                    if (_e2720[1] < 0.0lf) {
                                                        phi_6962_ = -(_e2720[1]);
                                                    } else {
                                                        phi_6962_ = _e2720[1];
                                                    }
                                                    let _e2730 = phi_6962_;
                                                    if (_e2720[2] < 0.0lf) {
                                                        phi_6970_ = -(_e2720[2]);
                                                    } else {
                                                        phi_6970_ = _e2720[2];
                                                    }
                                                    let _e2736 = phi_6970_;
                                                    let _e2737 = ((_e2725 + _e2730) + _e2736);
                                                    if (_e2737 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2737) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2743 = (f64(1f) / _e2737);
                                                            let _e2745 = (_e2720[0] * _e2743);
                                                            let _e2747 = (_e2720[1] * _e2743);
                                                            let _e2749 = (_e2720[2] * _e2743);
                                                            let _e2754 = (((_e2745 * _e2745) + (_e2747 * _e2747)) + (_e2749 * _e2749));
                                                            if (_e2754 <= 2.2250738585072014e-308lf) {
                                                                if (_e2754 > 0.0lf) {
                                                                    phi_7008_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_7008_ = 0.0lf;
                                                                }
                                                                let _e2806 = phi_7008_;
                                                                phi_7072_ = _e2806;
                                                            } else {
                                                                phi_7015_ = type_17(0i, 5i);
                                                                phi_7018_ = bitcast<f64>(((bitcast<u64>(_e2754) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2761 = phi_7015_;
                                                                    let _e2763 = phi_7018_;
                                                                    local_26 = _e2763;
                                                                    if (_e2761.member < _e2761.member_1) {
                                                                        let _e2770 = (_e2761.member + 1i);
                                                                        if ((false == (_e2770 > _e2761.member)) != false) {
                                                                            phi_7039_ = true;
                                                                        } else {
                                                                            phi_7039_ = false;
                                                                        }
                                                                        let _e2775 = phi_7039_;
                                                                        if _e2775 {
                                                                            phi_7045_ = type_18(0u, type_18().member_1);
                                                                        } else {
                                                                            phi_7045_ = type_18(1u, _e2770);
                                                                        }
                                                                        let _e2780 = phi_7045_;
                                                                        phi_7016_ = type_17(_e2780.member_1, _e2761.member_1);
                                                                        phi_7059_ = type_18(1u, _e2761.member);
                                                                    } else {
                                                                        phi_7016_ = _e2761;
                                                                        phi_7059_ = type_18(0u, type_18().member_1);
                                                                    }
                                                                    let _e2786 = phi_7016_;
                                                                    let _e2788 = phi_7059_;
                                                                    let _e2791 = (bitcast<i32>(_e2788.member) != 0i);
                                                                    if _e2791 {
                                                                        phi_7019_ = (0.5lf * (_e2763 + (_e2754 / _e2763)));
                                                                    } else {
                                                                        phi_7019_ = f64();
                                                                    }
                                                                    let _e2796 = phi_7019_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7015_ = _e2786;
                                                                        phi_7018_ = _e2796;
                                                                        break if !(_e2791);
                                                                    }
                                                                }
                                                                let _e2801 = local_26;
                                                                phi_7072_ = (_e2801 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2808 = phi_7072_;
                                                            phi_7085_ = type_19(0u, 4u);
                                                            phi_7088_ = f64(2f);
                                                            loop {
                                                                let _e2820 = phi_7085_;
                                                                let _e2822 = phi_7088_;
                                                                local_28 = _e2822;
                                                                local_29 = _e2822;
                                                                local_30 = _e2822;
                                                                local_60 = _e2822;
                                                                local_61 = _e2822;
                                                                if (_e2820.member < _e2820.member_1) {
                                                                    phi_7086_ = type_19((_e2820.member + 1u), _e2820.member_1);
                                                                    phi_7111_ = type_19(1u, _e2820.member);
                                                                } else {
                                                                    phi_7086_ = _e2820;
                                                                    phi_7111_ = type_19(0u, type_19().member_1);
                                                                }
                                                                let _e2834 = phi_7086_;
                                                                let _e2836 = phi_7111_;
                                                                if (bitcast<i32>(_e2836.member) != 0i) {
                                                                    let _e2842 = local_1[_e2836.member_1];
                                                                    let _e2850 = (((_e2745 * _e2842[0]) + (_e2747 * _e2842[1])) + (_e2749 * _e2842[2]));
                                                                    let _e2852 = local_2[_e2836.member_1];
                                                                    let _e2860 = (((_e2745 * _e2852[0]) + (_e2747 * _e2852[1])) + (_e2749 * _e2852[2]));
                                                                    if (_e2850 < 0.0lf) {
                                                                        phi_7162_ = -(_e2850);
                                                                    } else {
                                                                        phi_7162_ = _e2850;
                                                                    }
                                                                    let _e2864 = phi_7162_;
                                                                    if (_e2860 < 0.0lf) {
                                                                        phi_7168_ = -(_e2860);
                                                                    } else {
                                                                        phi_7168_ = _e2860;
                                                                    }
                                                                    let _e2868 = phi_7168_;
                                                                    let _e2873 = (((((((((_e2243 + _e2245) + (_e2297 + _e2299)) + (_e2351 + _e2353)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2361 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2808) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2864 + _e2868) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2850 > _e2873) {
                                                                        if (_e2860 > _e2873) {
                                                                            phi_7182_ = false;
                                                                        } else {
                                                                            phi_7182_ = true;
                                                                        }
                                                                        let _e2877 = phi_7182_;
                                                                        phi_7183_ = _e2877;
                                                                    } else {
                                                                        phi_7183_ = true;
                                                                    }
                                                                    let _e2879 = phi_7183_;
                                                                    if _e2879 {
                                                                        if ((_e2850 + ((_e2860 - _e2850) * _e2372)) > _e2873) {
                                                                            if (_e2860 < _e2850) {
                                                                                let _e2888 = ((_e2850 - _e2860) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                                                if _e2888 {
                                                                                    let _e2896 = (((_e2850 - _e2873) / (_e2850 - _e2860)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    if (_e2822 < _e2896) {
                                                                                        phi_7217_ = _e2822;
                                                                                    } else {
                                                                                        phi_7217_ = _e2896;
                                                                                    }
                                                                                    let _e2899 = phi_7217_;
                                                                                    phi_7218_ = _e2899;
                                                                                } else {
                                                                                    phi_7218_ = f64();
                                                                                }
                                                                                let _e2901 = phi_7218_;
                                                                                phi_7219_ = _e2901;
                                                                                phi_7220_ = _e2888;
                                                                            } else {
                                                                                phi_7219_ = _e2822;
                                                                                phi_7220_ = true;
                                                                            }
                                                                            let _e2903 = phi_7219_;
                                                                            let _e2905 = phi_7220_;
                                                                            if _e2905 {
                                                                                phi_7224_ = false;
                                                                            } else {
                                                                                phi_7224_ = true;
                                                                            }
                                                                            let _e2907 = phi_7224_;
                                                                            phi_7225_ = _e2903;
                                                                            phi_7226_ = _e2905;
                                                                            phi_7227_ = _e2907;
                                                                            phi_7228_ = false;
                                                                        } else {
                                                                            phi_7225_ = f64();
                                                                            phi_7226_ = false;
                                                                            phi_7227_ = false;
                                                                            phi_7228_ = true;
                                                                        }
                                                                        let _e2909 = phi_7225_;
                                                                        let _e2911 = phi_7226_;
                                                                        let _e2913 = phi_7227_;
                                                                        let _e2915 = phi_7228_;
                                                                        phi_7229_ = _e2909;
                                                                        phi_7230_ = _e2911;
                                                                        phi_7231_ = _e2913;
                                                                        phi_7232_ = _e2915;
                                                                    } else {
                                                                        phi_7229_ = _e2822;
                                                                        phi_7230_ = true;
                                                                        phi_7231_ = false;
                                                                        phi_7232_ = false;
                                                                    }
                                                                    let _e2917 = phi_7229_;
                                                                    let _e2919 = phi_7230_;
                                                                    let _e2921 = phi_7231_;
                                                                    let _e2923 = phi_7232_;
                                                                    phi_7089_ = _e2917;
                                                                    phi_7233_ = _e2919;
                                                                    phi_7234_ = false;
                                                                    phi_7235_ = _e2921;
                                                                    phi_7236_ = _e2923;
                                                                } else {
                                                                    phi_7089_ = f64();
                                                                    phi_7233_ = false;
                                                                    phi_7234_ = true;
                                                                    phi_7235_ = false;
                                                                    phi_7236_ = false;
                                                                }
                                                                let _e2925 = phi_7089_;
                                                                let _e2927 = phi_7233_;
                                                                let _e2929 = phi_7234_;
                                                                let _e2931 = phi_7235_;
                                                                let _e2933 = phi_7236_;
                                                                local_27 = _e2929;
                                                                local_58 = _e2931;
                                                                local_59 = _e2933;
                                                                continue;
                                                                continuing {
                                                                    phi_7085_ = _e2834;
                                                                    phi_7088_ = _e2925;
                                                                    break if !(_e2927);
                                                                }
                                                            }
                                                            let _e2936 = local_27;
                                                            if _e2936 {
                                                                let _e2938 = local_28;
                                                                let _e2939 = (_e2938 > _e1387.member_1);
                                                                if _e2939 {
                                                                    phi_7258_ = false;
                                                                    phi_7259_ = false;
                                                                    phi_7260_ = false;
                                                                } else {
                                                                    let _e2941 = local_29;
                                                                    if (_e2941 > _e2372) {
                                                                        let _e2944 = local_30;
                                                                        let _e2947 = ((_e2944 - _e2372) < f64(0.00000000023283064f));
                                                                        if _e2947 {
                                                                            phi_7254_ = false;
                                                                        } else {
                                                                            phi_7254_ = true;
                                                                        }
                                                                        let _e2949 = phi_7254_;
                                                                        phi_7255_ = _e2949;
                                                                        phi_7256_ = _e2947;
                                                                        phi_7257_ = false;
                                                                    } else {
                                                                        phi_7255_ = false;
                                                                        phi_7256_ = false;
                                                                        phi_7257_ = true;
                                                                    }
                                                                    let _e2951 = phi_7255_;
                                                                    let _e2953 = phi_7256_;
                                                                    let _e2955 = phi_7257_;
                                                                    phi_7258_ = _e2951;
                                                                    phi_7259_ = _e2953;
                                                                    phi_7260_ = _e2955;
                                                                }
                                                                let _e2957 = phi_7258_;
                                                                let _e2959 = phi_7259_;
                                                                let _e2961 = phi_7260_;
                                                                phi_7261_ = _e2957;
                                                                phi_7262_ = _e2939;
                                                                phi_7263_ = _e2959;
                                                                phi_7264_ = _e2961;
                                                                phi_7265_ = false;
                                                                phi_7266_ = false;
                                                            } else {
                                                                phi_7261_ = false;
                                                                phi_7262_ = false;
                                                                phi_7263_ = false;
                                                                phi_7264_ = false;
                                                                let _e5391 = local_58;
                                                                phi_7265_ = _e5391;
                                                                let _e5394 = local_59;
                                                                phi_7266_ = _e5394;
                                                            }
                                                            let _e2963 = phi_7261_;
                                                            let _e2965 = phi_7262_;
                                                            let _e2967 = phi_7263_;
                                                            let _e2969 = phi_7264_;
                                                            let _e2971 = phi_7265_;
                                                            let _e2973 = phi_7266_;
                                                            let _e5397 = local_60;
                                                            phi_7267_ = _e5397;
                                                            let _e5400 = local_61;
                                                            phi_7268_ = _e5400;
                                                            phi_7269_ = _e2963;
                                                            phi_7270_ = _e2965;
                                                            phi_7271_ = _e2967;
                                                            phi_7272_ = _e2969;
                                                            phi_7273_ = _e2971;
                                                            phi_7274_ = _e2973;
                                                            phi_7275_ = false;
                                                        } else {
                                                            phi_7267_ = f64();
                                                            phi_7268_ = f64();
                                                            phi_7269_ = false;
                                                            phi_7270_ = false;
                                                            phi_7271_ = false;
                                                            phi_7272_ = false;
                                                            phi_7273_ = false;
                                                            phi_7274_ = false;
                                                            phi_7275_ = true;
                                                        }
                                                        let _e2975 = phi_7267_;
                                                        let _e2977 = phi_7268_;
                                                        let _e2979 = phi_7269_;
                                                        let _e2981 = phi_7270_;
                                                        let _e2983 = phi_7271_;
                                                        let _e2985 = phi_7272_;
                                                        let _e2987 = phi_7273_;
                                                        let _e2989 = phi_7274_;
                                                        let _e2991 = phi_7275_;
                                                        phi_7276_ = _e2975;
                                                        phi_7277_ = _e2977;
                                                        phi_7278_ = _e2979;
                                                        phi_7279_ = _e2981;
                                                        phi_7280_ = _e2983;
                                                        phi_7281_ = _e2985;
                                                        phi_7282_ = _e2987;
                                                        phi_7283_ = _e2989;
                                                        phi_7284_ = _e2991;
                                                        phi_7285_ = false;
                                                    } else {
                                                        phi_7276_ = f64();
                                                        phi_7277_ = f64();
                                                        phi_7278_ = false;
                                                        phi_7279_ = false;
                                                        phi_7280_ = false;
                                                        phi_7281_ = false;
                                                        phi_7282_ = false;
                                                        phi_7283_ = false;
                                                        phi_7284_ = false;
                                                        phi_7285_ = true;
                                                    }
                                                    let _e2993 = phi_7276_;
                                                    let _e2995 = phi_7277_;
                                                    let _e2997 = phi_7278_;
                                                    let _e2999 = phi_7279_;
                                                    let _e3001 = phi_7280_;
                                                    let _e3003 = phi_7281_;
                                                    let _e3005 = phi_7282_;
                                                    let _e3007 = phi_7283_;
                                                    let _e3009 = phi_7284_;
                                                    let _e3011 = phi_7285_;
                                                    phi_7286_ = _e2993;
                                                    phi_6335_ = _e2995;
                                                    phi_7287_ = _e2997;
                                                    phi_7288_ = _e2999;
                                                    phi_7289_ = _e3001;
                                                    phi_7290_ = false;
                                                    phi_7291_ = _e3003;
                                                    phi_7292_ = _e3005;
                                                    phi_7293_ = _e3007;
                                                    phi_7294_ = _e3009;
                                                    phi_7295_ = _e3011;
                                                } else {
                                                    phi_7286_ = f64();
                                                    phi_6335_ = f64();
                                                    phi_7287_ = false;
                                                    phi_7288_ = false;
                                                    phi_7289_ = false;
                                                    phi_7290_ = true;
                                                    phi_7291_ = false;
                                                    phi_7292_ = false;
                                                    phi_7293_ = false;
                                                    phi_7294_ = false;
                                                    phi_7295_ = false;
                                                }
                                                let _e3013 = phi_7286_;
                                                let _e3015 = phi_6335_;
                                                let _e3017 = phi_7287_;
                                                let _e3019 = phi_7288_;
                                                let _e3021 = phi_7289_;
                                                let _e3023 = phi_7290_;
                                                let _e3025 = phi_7291_;
                                                let _e3027 = phi_7292_;
                                                let _e3029 = phi_7293_;
                                                let _e3031 = phi_7294_;
                                                let _e3033 = phi_7295_;
                                                local_31 = _e3019;
                                                local_62 = _e3021;
                                                local_63 = _e3023;
                                                local_64 = _e3025;
                                                local_65 = _e3027;
                                                local_66 = _e3029;
                                                local_67 = _e3031;
                                                local_68 = _e3033;
                                                local_69 = _e3013;
                                                local_71 = _e3019;
                                                continue;
                                                continuing {
                                                    phi_6331_ = _e2384;
                                                    phi_6334_ = _e3015;
                                                    break if !(_e3017);
                                                }
                                            }
                                            let _e3036 = local_31;
                                            if _e3036 {
                                                phi_7300_ = type_40(0u, type_40().member_1);
                                                phi_7301_ = false;
                                                phi_7302_ = false;
                                                phi_7303_ = false;
                                                phi_7304_ = false;
                                                phi_7305_ = false;
                                                phi_7306_ = false;
                                                phi_7307_ = false;
                                            } else {
                                                phi_7300_ = type_40();
                                                let _e5433 = local_62;
                                                phi_7301_ = _e5433;
                                                let _e5436 = local_63;
                                                phi_7302_ = _e5436;
                                                let _e5439 = local_64;
                                                phi_7303_ = _e5439;
                                                let _e5442 = local_65;
                                                phi_7304_ = _e5442;
                                                let _e5445 = local_66;
                                                phi_7305_ = _e5445;
                                                let _e5448 = local_67;
                                                phi_7306_ = _e5448;
                                                let _e5451 = local_68;
                                                phi_7307_ = _e5451;
                                            }
                                            let _e3040 = phi_7300_;
                                            let _e3042 = phi_7301_;
                                            let _e3044 = phi_7302_;
                                            let _e3046 = phi_7303_;
                                            let _e3048 = phi_7304_;
                                            let _e3050 = phi_7305_;
                                            let _e3052 = phi_7306_;
                                            let _e3054 = phi_7307_;
                                            if _e3042 {
                                                let _e5454 = local_69;
                                                phi_7311_ = _e5454;
                                                phi_7312_ = true;
                                                phi_7313_ = false;
                                                phi_7314_ = false;
                                                phi_7315_ = false;
                                                phi_7316_ = false;
                                                phi_7317_ = false;
                                                phi_7318_ = false;
                                            } else {
                                                let _e5456 = local_70;
                                                phi_7311_ = _e5456;
                                                phi_7312_ = _e3044;
                                                phi_7313_ = _e3046;
                                                phi_7314_ = _e3048;
                                                phi_7315_ = _e3050;
                                                let _e5463 = local_71;
                                                phi_7316_ = _e5463;
                                                phi_7317_ = _e3052;
                                                phi_7318_ = _e3054;
                                            }
                                            let _e3056 = phi_7311_;
                                            let _e3058 = phi_7312_;
                                            let _e3060 = phi_7313_;
                                            let _e3062 = phi_7314_;
                                            let _e3064 = phi_7315_;
                                            let _e3066 = phi_7316_;
                                            let _e3068 = phi_7317_;
                                            let _e3070 = phi_7318_;
                                            if _e3058 {
                                                phi_7323_ = type_40(1u, _e3056);
                                                phi_7324_ = false;
                                                phi_7325_ = false;
                                                phi_7326_ = false;
                                                phi_7327_ = false;
                                                phi_7328_ = false;
                                                phi_7329_ = false;
                                            } else {
                                                phi_7323_ = type_40();
                                                phi_7324_ = _e3060;
                                                phi_7325_ = _e3062;
                                                phi_7326_ = _e3064;
                                                phi_7327_ = _e3066;
                                                phi_7328_ = _e3068;
                                                phi_7329_ = _e3070;
                                            }
                                            let _e3073 = phi_7323_;
                                            let _e3075 = phi_7324_;
                                            let _e3077 = phi_7325_;
                                            let _e3079 = phi_7326_;
                                            let _e3081 = phi_7327_;
                                            let _e3083 = phi_7328_;
                                            let _e3085 = phi_7329_;
                                            if _e3075 {
                                                let _e3087 = local_32;
                                                phi_7334_ = type_40(1u, _e3087);
                                                phi_7335_ = false;
                                                phi_7336_ = false;
                                                phi_7337_ = true;
                                                phi_7338_ = false;
                                                phi_7339_ = false;
                                            } else {
                                                phi_7334_ = _e3040;
                                                phi_7335_ = _e3077;
                                                phi_7336_ = _e3079;
                                                phi_7337_ = _e3081;
                                                phi_7338_ = _e3083;
                                                phi_7339_ = _e3085;
                                            }
                                            let _e3090 = phi_7334_;
                                            let _e3092 = phi_7335_;
                                            let _e3094 = phi_7336_;
                                            let _e3096 = phi_7337_;
                                            let _e3098 = phi_7338_;
                                            let _e3100 = phi_7339_;
                                            if _e3092 {
                                                let _e3102 = local_33;
                                                phi_7344_ = type_40(1u, _e3102);
                                                phi_7345_ = false;
                                                phi_7346_ = false;
                                                phi_7347_ = false;
                                                phi_7348_ = false;
                                            } else {
                                                phi_7344_ = type_40();
                                                phi_7345_ = _e3094;
                                                phi_7346_ = _e3096;
                                                phi_7347_ = _e3098;
                                                phi_7348_ = _e3100;
                                            }
                                            let _e3105 = phi_7344_;
                                            let _e3107 = phi_7345_;
                                            let _e3109 = phi_7346_;
                                            let _e3111 = phi_7347_;
                                            let _e3113 = phi_7348_;
                                            if _e3107 {
                                                let _e3115 = local_34;
                                                phi_7353_ = type_40(1u, _e3115);
                                                phi_7354_ = true;
                                                phi_7355_ = false;
                                                phi_7356_ = false;
                                                phi_7357_ = false;
                                            } else {
                                                phi_7353_ = _e3105;
                                                phi_7354_ = _e3092;
                                                phi_7355_ = _e3109;
                                                phi_7356_ = _e3111;
                                                phi_7357_ = _e3113;
                                            }
                                            let _e3118 = phi_7353_;
                                            let _e3120 = phi_7354_;
                                            let _e3122 = phi_7355_;
                                            let _e3124 = phi_7356_;
                                            let _e3126 = phi_7357_;
                                            if _e3120 {
                                                phi_7361_ = _e3118;
                                                phi_7362_ = true;
                                                phi_7363_ = false;
                                                phi_7364_ = false;
                                            } else {
                                                phi_7361_ = _e3090;
                                                phi_7362_ = _e3122;
                                                phi_7363_ = _e3124;
                                                phi_7364_ = _e3126;
                                            }
                                            let _e3128 = phi_7361_;
                                            let _e3130 = phi_7362_;
                                            let _e3132 = phi_7363_;
                                            let _e3134 = phi_7364_;
                                            if _e3130 {
                                                phi_7368_ = false;
                                                phi_7369_ = false;
                                            } else {
                                                phi_7368_ = _e3132;
                                                phi_7369_ = _e3134;
                                            }
                                            let _e3136 = phi_7368_;
                                            let _e3138 = phi_7369_;
                                            if _e3136 {
                                                phi_7373_ = false;
                                                phi_7374_ = false;
                                            } else {
                                                phi_7373_ = _e3138;
                                                phi_7374_ = _e3130;
                                            }
                                            let _e3140 = phi_7373_;
                                            let _e3142 = phi_7374_;
                                            if _e3140 {
                                                phi_7378_ = true;
                                                phi_7379_ = false;
                                            } else {
                                                phi_7378_ = _e3136;
                                                phi_7379_ = _e3142;
                                            }
                                            let _e3144 = phi_7378_;
                                            let _e3146 = phi_7379_;
                                            if _e3144 {
                                                let _e3148 = local_35;
                                                phi_7384_ = type_40(1u, _e3148);
                                                phi_7385_ = true;
                                            } else {
                                                phi_7384_ = _e3128;
                                                phi_7385_ = _e3146;
                                            }
                                            let _e3151 = phi_7384_;
                                            let _e3153 = phi_7385_;
                                            if _e3153 {
                                                phi_7389_ = _e3151;
                                            } else {
                                                phi_7389_ = _e3073;
                                            }
                                            let _e3155 = phi_7389_;
                                            let _e3158 = (_e3155.member != 0u);
                                            if _e3158 {
                                                phi_7396_ = false;
                                            } else {
                                                phi_7396_ = true;
                                            }
                                            let _e3160 = phi_7396_;
                                            phi_7397_ = _e3155.member_1;
                                            phi_7398_ = _e3160;
                                            phi_7399_ = _e3158;
                                            phi_7400_ = false;
                                        } else {
                                            phi_7397_ = f64();
                                            phi_7398_ = false;
                                            phi_7399_ = false;
                                            phi_7400_ = true;
                                        }
                                        let _e3162 = phi_7397_;
                                        let _e3164 = phi_7398_;
                                        let _e3166 = phi_7399_;
                                        let _e3168 = phi_7400_;
                                        phi_7401_ = _e3162;
                                        phi_7402_ = _e3164;
                                        phi_7403_ = _e3166;
                                        phi_7404_ = _e3168;
                                    }
                                    let _e3170 = phi_7401_;
                                    let _e3172 = phi_7402_;
                                    let _e3174 = phi_7403_;
                                    let _e3176 = phi_7404_;
                                    phi_7405_ = _e3170;
                                    phi_7406_ = _e2114;
                                    phi_7407_ = _e3172;
                                    phi_7408_ = _e3174;
                                    phi_7409_ = _e3176;
                                }
                                let _e3178 = phi_7405_;
                                let _e3180 = phi_7406_;
                                let _e3182 = phi_7407_;
                                let _e3184 = phi_7408_;
                                let _e3186 = phi_7409_;
                                if _e3180 {
                                    phi_7413_ = true;
                                    phi_7414_ = false;
                                    phi_7415_ = false;
                                } else {
                                    phi_7413_ = _e3182;
                                    phi_7414_ = _e3184;
                                    phi_7415_ = _e3186;
                                }
                                let _e3188 = phi_7413_;
                                let _e3190 = phi_7414_;
                                let _e3192 = phi_7415_;
                                phi_7416_ = _e3178;
                                phi_7417_ = _e1387;
                                phi_7418_ = _e3188;
                                phi_7419_ = false;
                                phi_7420_ = _e3190;
                                phi_7421_ = _e3192;
                            } else {
                                phi_7416_ = f64();
                                phi_7417_ = type_41();
                                phi_7418_ = false;
                                phi_7419_ = true;
                                phi_7420_ = false;
                                phi_7421_ = false;
                            }
                            let _e3194 = phi_7416_;
                            let _e3196 = phi_7417_;
                            let _e3198 = phi_7418_;
                            let _e3200 = phi_7419_;
                            let _e3202 = phi_7420_;
                            let _e3204 = phi_7421_;
                            local_36 = _e3200;
                            local_72 = _e3202;
                            local_73 = _e3204;
                            local_37 = _e3194;
                            local_38 = _e3196;
                            continue;
                            continuing {
                                phi_4370_ = _e1074;
                                break if !(_e3198);
                            }
                        }
                        let _e3207 = local_36;
                        if _e3207 {
                            phi_7426_ = type_40(0u, type_40().member_1);
                            phi_7427_ = false;
                            phi_7428_ = false;
                        } else {
                            phi_7426_ = type_40();
                            let _e5533 = local_72;
                            phi_7427_ = _e5533;
                            let _e5536 = local_73;
                            phi_7428_ = _e5536;
                        }
                        let _e3211 = phi_7426_;
                        let _e3213 = phi_7427_;
                        let _e3215 = phi_7428_;
                        if _e3213 {
                            let _e3217 = local_37;
                            phi_7433_ = type_40(2u, _e3217);
                            phi_7434_ = false;
                        } else {
                            phi_7433_ = type_40();
                            phi_7434_ = _e3215;
                        }
                        let _e3220 = phi_7433_;
                        let _e3222 = phi_7434_;
                        if _e3222 {
                            let _e3224 = local_38;
                            phi_7440_ = type_40(1u, _e3224.member);
                            phi_7441_ = true;
                        } else {
                            phi_7440_ = _e3220;
                            phi_7441_ = _e3213;
                        }
                        let _e3228 = phi_7440_;
                        let _e3230 = phi_7441_;
                        if _e3230 {
                            phi_7445_ = _e3228;
                        } else {
                            phi_7445_ = _e3211;
                        }
                        let _e3232 = phi_7445_;
                        phi_7449_ = _e3232;
                    }
                    let _e4905 = phi_7449_;
                    phi_7450_ = _e4905;
                }
                let _e4909 = phi_7450_;
                switch bitcast<i32>(_e4909.member) {
                    case 0: {
                        phi_7463_ = type_31(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4915 = function_(_e4909.member_1);
                        phi_7463_ = type_31(0u, _e4915, true);
                        break;
                    }
                    case 2: {
                        let _e4913 = function_(_e4909.member_1);
                        phi_7463_ = type_31(1u, _e4913, true);
                        break;
                    }
                    default: {
                        phi_7463_ = type_31();
                        break;
                    }
                }
                let _e4918 = phi_7463_;
                if _e4918.member_2 {
                    let _e4925 = (_e4918.member_1[1] >> bitcast<u32>(20i));
                    if (_e4925 <= 896u) {
                        phi_7486_ = 0u;
                    } else {
                        phi_7486_ = ((((_e4925 - 896u) << bitcast<u32>(23i)) | ((_e4918.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4918.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4940 = phi_7486_;
                    let _e4942 = atomicMin((&earliest.member[0u]), _e4940);
                }
                phi_7490_ = type_30(_e179, _e4918.member, _e185, _e188, _e4918.member_1);
                phi_7491_ = _e4918.member_2;
            } else {
                phi_7490_ = type_30(_e179, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_7491_ = false;
            }
            let _e4944 = phi_7490_;
            let _e4946 = phi_7491_;
            let _e4948 = params.member.member_1;
            if ((_e4948 & 16u) != 0u) {
                if (_e112 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4946 {
                    let _e4954 = atomicAdd((&counters[0u]), 1u);
                    phi_7509_ = _e4954;
                } else {
                    phi_7509_ = 0u;
                }
                let _e4956 = phi_7509_;
                workgroupBarrier();
                if (_e112 == 0u) {
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
            phi_273_ = _e167;
            break if !(_e173);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_1(id, n, lane);
}
