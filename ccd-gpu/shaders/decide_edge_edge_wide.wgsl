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
    member: array<array<u32, 2>>,
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

struct type_40 {
    member: array<array<f64, 3>>,
}

struct type_43 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_46 {
    member: array<type_43>,
}

struct type_54 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_55 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_59 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_61 {
    member: f64,
    member_1: f64,
}

struct type_69 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
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
var<storage> params: type_13;
@group(0) @binding(1) 
var<storage> paths: type_46;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_77;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> wide: type_40;
@group(0) @binding(3) 
var<storage> elements: type_21;
@group(0) @binding(4) 
var<storage> input: type_17;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_77;

fn function_(param: f64) -> array<u32, 2> {
    let _e95 = bitcast<u64>(param);
    return array<u32, 2>(u32(_e95), u32((_e95 / 4294967296lu)));
}

fn function_1() {
    var local: array<array<f64, 3>, 4>;
    var local_1: array<array<f64, 3>, 4>;
    var local_2: array<array<f64, 3>, 4>;
    var local_3: type_59;
    var local_4: type_59;
    var local_5: type_59;
    var local_6: array<type_61, 4>;
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
    var local_20: type_69;
    var phi_232_: u32;
    var phi_248_: u32;
    var phi_269_: u32;
    var phi_270_: u32;
    var phi_273_: type_29;
    var phi_274_: type_29;
    var phi_297_: type_29;
    var phi_640_: type_29;
    var phi_641_: type_29;
    var phi_664_: type_29;
    var phi_520_: type_29;
    var phi_521_: type_29;
    var phi_544_: type_29;
    var phi_554_: type_29;
    var phi_555_: type_29;
    var phi_578_: type_29;
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
    var phi_4190_: type_27;
    var phi_4193_: f64;
    var phi_4214_: bool;
    var phi_4220_: type_28;
    var phi_4191_: type_27;
    var phi_4234_: type_28;
    var phi_4194_: f64;
    var local_21: f64;
    var phi_4183_: f64;
    var phi_4247_: f64;
    var phi_4253_: f64;
    var phi_4278_: type_29;
    var phi_4281_: u32;
    var phi_4279_: type_29;
    var phi_4304_: type_29;
    var phi_4348_: u32;
    var phi_4349_: u32;
    var phi_4282_: u32;
    var phi_4350_: u32;
    var phi_4370_: type_29;
    var phi_4371_: type_29;
    var phi_4394_: type_29;
    var phi_4448_: f64;
    var phi_4455_: f64;
    var phi_4467_: bool;
    var phi_4468_: bool;
    var phi_4469_: bool;
    var phi_4470_: bool;
    var phi_4474_: bool;
    var phi_4486_: type_73;
    var phi_4487_: type_73;
    var phi_4488_: bool;
    var phi_4489_: type_73;
    var phi_4490_: bool;
    var phi_4503_: f64;
    var phi_4516_: type_29;
    var phi_4519_: f64;
    var phi_4521_: f64;
    var phi_4523_: f64;
    var phi_4517_: type_29;
    var phi_4546_: type_29;
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
    var phi_4651_: type_29;
    var phi_4654_: f64;
    var phi_4652_: type_29;
    var phi_4677_: type_29;
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
    var phi_4773_: type_73;
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
    var phi_5781_: type_29;
    var phi_5784_: bool;
    var phi_5782_: type_29;
    var phi_5807_: type_29;
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
    var phi_6331_: type_29;
    var phi_6334_: f64;
    var phi_6332_: type_29;
    var phi_6357_: type_29;
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
    var phi_6854_: type_29;
    var phi_6857_: array<f64, 3>;
    var phi_6855_: type_29;
    var phi_6880_: type_29;
    var phi_6947_: array<f64, 3>;
    var phi_6858_: array<f64, 3>;
    var phi_6948_: array<f64, 3>;
    var phi_6955_: f64;
    var phi_6962_: f64;
    var phi_6970_: f64;
    var phi_7015_: type_27;
    var phi_7018_: f64;
    var phi_7039_: bool;
    var phi_7045_: type_28;
    var phi_7016_: type_27;
    var phi_7059_: type_28;
    var phi_7019_: f64;
    var local_26: f64;
    var phi_7008_: f64;
    var phi_7072_: f64;
    var phi_7085_: type_29;
    var phi_7088_: f64;
    var phi_7086_: type_29;
    var phi_7111_: type_29;
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
    var phi_7300_: type_72;
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
    var phi_7323_: type_72;
    var phi_7324_: bool;
    var phi_7325_: bool;
    var phi_7326_: bool;
    var phi_7327_: bool;
    var phi_7328_: bool;
    var phi_7329_: bool;
    var local_32: f64;
    var phi_7334_: type_72;
    var phi_7335_: bool;
    var phi_7336_: bool;
    var phi_7337_: bool;
    var phi_7338_: bool;
    var phi_7339_: bool;
    var local_33: f64;
    var phi_7344_: type_72;
    var phi_7345_: bool;
    var phi_7346_: bool;
    var phi_7347_: bool;
    var phi_7348_: bool;
    var local_34: f64;
    var phi_7353_: type_72;
    var phi_7354_: bool;
    var phi_7355_: bool;
    var phi_7356_: bool;
    var phi_7357_: bool;
    var phi_7361_: type_72;
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
    var phi_7384_: type_72;
    var phi_7385_: bool;
    var phi_7389_: type_72;
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
    var phi_7417_: type_73;
    var phi_7418_: bool;
    var phi_7419_: bool;
    var phi_7420_: bool;
    var phi_7421_: bool;
    var local_36: bool;
    var phi_7426_: type_72;
    var phi_7427_: bool;
    var phi_7428_: bool;
    var local_37: f64;
    var phi_7433_: type_72;
    var phi_7434_: bool;
    var local_38: type_73;
    var phi_7440_: type_72;
    var phi_7441_: bool;
    var phi_7445_: type_72;
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
    var phi_1989_: type_29;
    var phi_1992_: f64;
    var phi_1990_: type_29;
    var phi_2015_: type_29;
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
    var phi_2512_: type_29;
    var phi_2515_: array<f64, 3>;
    var phi_2513_: type_29;
    var phi_2538_: type_29;
    var phi_2605_: array<f64, 3>;
    var phi_2516_: array<f64, 3>;
    var phi_2606_: array<f64, 3>;
    var phi_2613_: f64;
    var phi_2620_: f64;
    var phi_2628_: f64;
    var phi_2673_: type_27;
    var phi_2676_: f64;
    var phi_2697_: bool;
    var phi_2703_: type_28;
    var phi_2674_: type_27;
    var phi_2717_: type_28;
    var phi_2677_: f64;
    var local_39: f64;
    var phi_2666_: f64;
    var phi_2730_: f64;
    var phi_2743_: type_29;
    var phi_2746_: f64;
    var phi_2744_: type_29;
    var phi_2769_: type_29;
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
    var phi_2958_: type_72;
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
    var phi_2981_: type_72;
    var phi_2982_: bool;
    var phi_2983_: bool;
    var phi_2984_: bool;
    var phi_2985_: bool;
    var phi_2986_: bool;
    var phi_2987_: bool;
    var local_45: f64;
    var phi_2992_: type_72;
    var phi_2993_: bool;
    var phi_2994_: bool;
    var phi_2995_: bool;
    var phi_2996_: bool;
    var phi_2997_: bool;
    var local_46: f64;
    var phi_3002_: type_72;
    var phi_3003_: bool;
    var phi_3004_: bool;
    var phi_3005_: bool;
    var phi_3006_: bool;
    var local_47: f64;
    var phi_3011_: type_72;
    var phi_3012_: bool;
    var phi_3013_: bool;
    var phi_3014_: bool;
    var phi_3015_: bool;
    var phi_3019_: type_72;
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
    var phi_3042_: type_72;
    var phi_3043_: bool;
    var phi_3047_: type_72;
    var phi_3061_: type_29;
    var phi_3062_: type_29;
    var phi_3085_: type_29;
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
    var phi_3597_: type_29;
    var phi_3600_: array<f64, 3>;
    var phi_3598_: type_29;
    var phi_3623_: type_29;
    var phi_3690_: array<f64, 3>;
    var phi_3601_: array<f64, 3>;
    var phi_3691_: array<f64, 3>;
    var phi_3723_: type_27;
    var phi_3726_: f64;
    var phi_3747_: bool;
    var phi_3753_: type_28;
    var phi_3724_: type_27;
    var phi_3767_: type_28;
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
    var phi_4063_: type_72;
    var phi_4064_: bool;
    var phi_4069_: type_72;
    var phi_4070_: bool;
    var phi_4072_: type_72;
    var phi_4073_: type_72;
    var phi_4074_: bool;
    var phi_4078_: type_72;
    var phi_7449_: type_72;
    var phi_7450_: type_72;
    var phi_7463_: type_55;
    var phi_7486_: u32;
    var phi_7490_: type_54;
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

    let _e115 = id_1;
    let _e116 = n_1;
    let _e117 = lane_1;
    let _e129 = ((_e115.y * _e116.x) + _e115.x);
    let _e132 = (_e116.x * _e116.y);
    let _e134 = params.member.member_15;
    let _e136 = input.member[0u];
    if (_e134 < _e136) {
        phi_232_ = _e134;
    } else {
        phi_232_ = _e136;
    }
    let _e139 = phi_232_;
    let _e140 = (_e139 / 64u);
    if ((_e139 % 64u) > 0u) {
        phi_248_ = (_e140 + 1u);
    } else {
        phi_248_ = _e140;
    }
    let _e145 = phi_248_;
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
            phi_269_ = (_e149 + 1u);
        } else {
            phi_269_ = _e149;
        }
        let _e155 = phi_269_;
        phi_270_ = _e155;
    } else {
        phi_270_ = 0u;
    }
    let _e157 = phi_270_;
    phi_273_ = type_29(0u, _e157);
    loop {
        let _e160 = phi_273_;
        if (_e160.member < _e160.member_1) {
            phi_274_ = type_29((_e160.member + 1u), _e160.member_1);
            phi_297_ = type_29(1u, _e160.member);
        } else {
            phi_274_ = _e160;
            phi_297_ = type_29(0u, type_29().member_1);
        }
        let _e174 = phi_274_;
        let _e176 = phi_297_;
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
                    let _e264 = paths.member[_e197[0]];
                    let _e266 = paths.member[_e197[1]];
                    let _e272 = paths.member[_e199[0]];
                    let _e274 = paths.member[_e199[1]];
                    local_18 = array<array<f32, 3>, 4>(array<f32, 3>(_e264.member[0], _e264.member[1], _e264.member[2]), array<f32, 3>(_e266.member[0], _e266.member[1], _e266.member[2]), array<f32, 3>(_e272.member[0], _e272.member[1], _e272.member[2]), array<f32, 3>(_e274.member[0], _e274.member[1], _e274.member[2]));
                    local_19 = array<array<f32, 3>, 4>(array<f32, 3>(_e264.member_1[0], _e264.member_1[1], _e264.member_1[2]), array<f32, 3>(_e266.member_1[0], _e266.member_1[1], _e266.member_1[2]), array<f32, 3>(_e272.member_1[0], _e272.member_1[1], _e272.member_1[2]), array<f32, 3>(_e274.member_1[0], _e274.member_1[1], _e274.member_1[2]));
                    phi_520_ = type_29(0u, 4u);
                    loop {
                        let _e314 = phi_520_;
                        if (_e314.member < _e314.member_1) {
                            phi_521_ = type_29((_e314.member + 1u), _e314.member_1);
                            phi_544_ = type_29(1u, _e314.member);
                        } else {
                            phi_521_ = _e314;
                            phi_544_ = type_29(0u, type_29().member_1);
                        }
                        let _e328 = phi_521_;
                        let _e330 = phi_544_;
                        let _e334 = (bitcast<i32>(_e330.member) != 0i);
                        if _e334 {
                            phi_554_ = type_29(0u, 3u);
                            loop {
                                let _e336 = phi_554_;
                                if (_e336.member < _e336.member_1) {
                                    phi_555_ = type_29((_e336.member + 1u), _e336.member_1);
                                    phi_578_ = type_29(1u, _e336.member);
                                } else {
                                    phi_555_ = _e336;
                                    phi_578_ = type_29(0u, type_29().member_1);
                                }
                                let _e350 = phi_555_;
                                let _e352 = phi_578_;
                                let _e356 = (bitcast<i32>(_e352.member) != 0i);
                                if _e356 {
                                    if (_e330.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e352.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e361 = local_18[_e330.member_1][_e352.member_1];
                                    if (_e330.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e352.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    local_16[_e330.member_1][_e352.member_1] = f64(_e361);
                                    if (_e330.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e352.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e371 = local_19[_e330.member_1][_e352.member_1];
                                    if (_e330.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e352.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    local_17[_e330.member_1][_e352.member_1] = f64(_e371);
                                }
                                continue;
                                continuing {
                                    phi_554_ = _e350;
                                    break if !(_e356);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_520_ = _e328;
                            break if !(_e334);
                        }
                    }
                } else {
                    phi_640_ = type_29(0u, 4u);
                    loop {
                        let _e218 = phi_640_;
                        if (_e218.member < _e218.member_1) {
                            phi_641_ = type_29((_e218.member + 1u), _e218.member_1);
                            phi_664_ = type_29(1u, _e218.member);
                        } else {
                            phi_641_ = _e218;
                            phi_664_ = type_29(0u, type_29().member_1);
                        }
                        let _e232 = phi_641_;
                        let _e234 = phi_664_;
                        let _e238 = (bitcast<i32>(_e234.member) != 0i);
                        if _e238 {
                            if (_e234.member_1 < 4u) {
                            } else {
                                return;
                            }
                            let _e241 = local_15[_e234.member_1];
                            let _e243 = wide.member[_e241];
                            let _e246 = params.member.member[0u];
                            let _e249 = wide.member[(_e246 + _e241)];
                            if (_e234.member_1 < 4u) {
                            } else {
                                return;
                            }
                            local_16[_e234.member_1] = array<f64, 3>(_e243[0], _e243[1], _e243[2]);
                            if (_e234.member_1 < 4u) {
                            } else {
                                return;
                            }
                            local_17[_e234.member_1] = array<f64, 3>(_e249[0], _e249[1], _e249[2]);
                        }
                        continue;
                        continuing {
                            phi_640_ = _e232;
                            break if !(_e238);
                        }
                    }
                }
                let _e379 = local_16;
                let _e396 = local_17;
                local_20 = type_69(array<array<f64, 3>, 2>(array<f64, 3>((_e379[2][0] - _e379[0][0]), (_e379[2][1] - _e379[0][1]), (_e379[2][2] - _e379[0][2])), array<f64, 3>((_e396[2][0] - _e396[0][0]), (_e396[2][1] - _e396[0][1]), (_e396[2][2] - _e396[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e379[1][0] - _e379[0][0]), (_e379[1][1] - _e379[0][1]), (_e379[1][2] - _e379[0][2])), array<f64, 3>((_e396[1][0] - _e396[0][0]), (_e396[1][1] - _e396[0][1]), (_e396[1][2] - _e396[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e379[2][0] - _e379[3][0]), (_e379[2][1] - _e379[3][1]), (_e379[2][2] - _e379[3][2])), array<f64, 3>((_e396[2][0] - _e396[3][0]), (_e396[2][1] - _e396[3][1]), (_e396[2][2] - _e396[3][2]))), (0.0lf + 0.0lf));
                let _e443 = params.member.member_7;
                let _e450 = bitcast<f64>(((u64(_e443[1]) * 4294967296lu) + u64(_e443[0])));
                let _e451 = f64(0f);
                let _e454 = local_20.member_1[0u];
                let _e460 = local_20.member_2[0u];
                let _e466 = ((_e454[1] * _e460[2]) - (_e454[2] * _e460[1]));
                let _e469 = ((_e454[2] * _e460[0]) - (_e454[0] * _e460[2]));
                let _e472 = ((_e454[0] * _e460[1]) - (_e454[1] * _e460[0]));
                let _e475 = local_20.member_1[1u];
                let _e481 = local_20.member_2[1u];
                let _e487 = ((_e475[1] * _e481[2]) - (_e475[2] * _e481[1]));
                let _e490 = ((_e475[2] * _e481[0]) - (_e475[0] * _e481[2]));
                let _e493 = ((_e475[0] * _e481[1]) - (_e475[1] * _e481[0]));
                let _e496 = local_20.member_1[0u];
                let _e502 = local_20.member_2[1u];
                let _e517 = local_20.member_1[1u];
                let _e523 = local_20.member_2[0u];
                let _e536 = (((_e496[1] * _e502[2]) - (_e496[2] * _e502[1])) + ((_e517[1] * _e523[2]) - (_e517[2] * _e523[1])));
                let _e537 = (((_e496[2] * _e502[0]) - (_e496[0] * _e502[2])) + ((_e517[2] * _e523[0]) - (_e517[0] * _e523[2])));
                let _e538 = (((_e496[0] * _e502[1]) - (_e496[1] * _e502[0])) + ((_e517[0] * _e523[1]) - (_e517[1] * _e523[0])));
                let _e541 = local_20.member[0u];
                let _e549 = (((_e541[0] * _e466) + (_e541[1] * _e469)) + (_e541[2] * _e472));
                let _e552 = local_20.member[1u];
                let _e563 = local_20.member[0u];
                let _e572 = ((((_e552[0] * _e466) + (_e552[1] * _e469)) + (_e552[2] * _e472)) + (((_e563[0] * _e536) + (_e563[1] * _e537)) + (_e563[2] * _e538)));
                let _e575 = local_20.member[0u];
                let _e586 = local_20.member[1u];
                let _e595 = ((((_e575[0] * _e487) + (_e575[1] * _e490)) + (_e575[2] * _e493)) + (((_e586[0] * _e536) + (_e586[1] * _e537)) + (_e586[2] * _e538)));
                let _e598 = local_20.member[1u];
                let _e606 = (((_e598[0] * _e487) + (_e598[1] * _e490)) + (_e598[2] * _e493));
                let _e609 = local_20.member[0u];
                if (_e609[0] < 0.0lf) {
                    phi_1132_ = -(_e609[0]);
                } else {
                    phi_1132_ = _e609[0];
                }
                let _e616 = phi_1132_;
                if (_e609[1] < 0.0lf) {
                    phi_1139_ = -(_e609[1]);
                } else {
                    phi_1139_ = _e609[1];
                }
                let _e620 = phi_1139_;
                if (_e616 > _e620) {
                    phi_1144_ = _e616;
                } else {
                    phi_1144_ = _e620;
                }
                let _e623 = phi_1144_;
                if (_e609[2] < 0.0lf) {
                    phi_1151_ = -(_e609[2]);
                } else {
                    phi_1151_ = _e609[2];
                }
                let _e627 = phi_1151_;
                if (_e623 > _e627) {
                    phi_1156_ = _e623;
                } else {
                    phi_1156_ = _e627;
                }
                let _e630 = phi_1156_;
                let _e633 = local_20.member[1u];
                if (_e633[0] < 0.0lf) {
                    phi_1169_ = -(_e633[0]);
                } else {
                    phi_1169_ = _e633[0];
                }
                let _e640 = phi_1169_;
                if (_e633[1] < 0.0lf) {
                    phi_1176_ = -(_e633[1]);
                } else {
                    phi_1176_ = _e633[1];
                }
                let _e644 = phi_1176_;
                if (_e640 > _e644) {
                    phi_1181_ = _e640;
                } else {
                    phi_1181_ = _e644;
                }
                let _e647 = phi_1181_;
                if (_e633[2] < 0.0lf) {
                    phi_1188_ = -(_e633[2]);
                } else {
                    phi_1188_ = _e633[2];
                }
                let _e651 = phi_1188_;
                if (_e647 > _e651) {
                    phi_1193_ = _e647;
                } else {
                    phi_1193_ = _e651;
                }
                let _e654 = phi_1193_;
                if (_e630 > _e654) {
                    phi_1198_ = _e630;
                } else {
                    phi_1198_ = _e654;
                }
                let _e657 = phi_1198_;
                let _e659 = local_20.member_3;
                let _e660 = (_e657 + _e659);
                let _e663 = local_20.member_1[0u];
                if (_e663[0] < 0.0lf) {
                    phi_1215_ = -(_e663[0]);
                } else {
                    phi_1215_ = _e663[0];
                }
                let _e670 = phi_1215_;
                if (_e663[1] < 0.0lf) {
                    phi_1222_ = -(_e663[1]);
                } else {
                    phi_1222_ = _e663[1];
                }
                let _e674 = phi_1222_;
                if (_e670 > _e674) {
                    phi_1227_ = _e670;
                } else {
                    phi_1227_ = _e674;
                }
                let _e677 = phi_1227_;
                if (_e663[2] < 0.0lf) {
                    phi_1234_ = -(_e663[2]);
                } else {
                    phi_1234_ = _e663[2];
                }
                let _e681 = phi_1234_;
                if (_e677 > _e681) {
                    phi_1239_ = _e677;
                } else {
                    phi_1239_ = _e681;
                }
                let _e684 = phi_1239_;
                let _e687 = local_20.member_1[1u];
                if (_e687[0] < 0.0lf) {
                    phi_1253_ = -(_e687[0]);
                } else {
                    phi_1253_ = _e687[0];
                }
                let _e694 = phi_1253_;
                if (_e687[1] < 0.0lf) {
                    phi_1260_ = -(_e687[1]);
                } else {
                    phi_1260_ = _e687[1];
                }
                let _e698 = phi_1260_;
                if (_e694 > _e698) {
                    phi_1265_ = _e694;
                } else {
                    phi_1265_ = _e698;
                }
                let _e701 = phi_1265_;
                if (_e687[2] < 0.0lf) {
                    phi_1272_ = -(_e687[2]);
                } else {
                    phi_1272_ = _e687[2];
                }
                let _e705 = phi_1272_;
                if (_e701 > _e705) {
                    phi_1277_ = _e701;
                } else {
                    phi_1277_ = _e705;
                }
                let _e708 = phi_1277_;
                if (_e684 > _e708) {
                    phi_1282_ = _e684;
                } else {
                    phi_1282_ = _e708;
                }
                let _e711 = phi_1282_;
                let _e713 = local_20.member_3;
                let _e714 = (_e711 + _e713);
                let _e717 = local_20.member_2[0u];
                if (_e717[0] < 0.0lf) {
                    phi_1299_ = -(_e717[0]);
                } else {
                    phi_1299_ = _e717[0];
                }
                let _e724 = phi_1299_;
                if (_e717[1] < 0.0lf) {
                    phi_1306_ = -(_e717[1]);
                } else {
                    phi_1306_ = _e717[1];
                }
                let _e728 = phi_1306_;
                if (_e724 > _e728) {
                    phi_1311_ = _e724;
                } else {
                    phi_1311_ = _e728;
                }
                let _e731 = phi_1311_;
                if (_e717[2] < 0.0lf) {
                    phi_1318_ = -(_e717[2]);
                } else {
                    phi_1318_ = _e717[2];
                }
                let _e735 = phi_1318_;
                if (_e731 > _e735) {
                    phi_1323_ = _e731;
                } else {
                    phi_1323_ = _e735;
                }
                let _e738 = phi_1323_;
                let _e741 = local_20.member_2[1u];
                if (_e741[0] < 0.0lf) {
                    phi_1337_ = -(_e741[0]);
                } else {
                    phi_1337_ = _e741[0];
                }
                let _e748 = phi_1337_;
                if (_e741[1] < 0.0lf) {
                    phi_1344_ = -(_e741[1]);
                } else {
                    phi_1344_ = _e741[1];
                }
                let _e752 = phi_1344_;
                if (_e748 > _e752) {
                    phi_1349_ = _e748;
                } else {
                    phi_1349_ = _e752;
                }
                let _e755 = phi_1349_;
                if (_e741[2] < 0.0lf) {
                    phi_1356_ = -(_e741[2]);
                } else {
                    phi_1356_ = _e741[2];
                }
                let _e759 = phi_1356_;
                if (_e755 > _e759) {
                    phi_1361_ = _e755;
                } else {
                    phi_1361_ = _e759;
                }
                let _e762 = phi_1361_;
                if (_e738 > _e762) {
                    phi_1366_ = _e738;
                } else {
                    phi_1366_ = _e762;
                }
                let _e765 = phi_1366_;
                let _e767 = local_20.member_3;
                let _e768 = (_e765 + _e767);
                let _e769 = f64(1f);
                let _e770 = f64(8f);
                let _e772 = ((_e714 * _e770) * _e768);
                let _e780 = local_20.member_3;
                if (_e466 < 0.0lf) {
                    phi_1403_ = -(_e466);
                } else {
                    phi_1403_ = _e466;
                }
                let _e800 = phi_1403_;
                if (_e469 < 0.0lf) {
                    phi_1409_ = -(_e469);
                } else {
                    phi_1409_ = _e469;
                }
                let _e804 = phi_1409_;
                if (_e472 < 0.0lf) {
                    phi_1416_ = -(_e472);
                } else {
                    phi_1416_ = _e472;
                }
                let _e809 = phi_1416_;
                let _e810 = ((_e800 + _e804) + _e809);
                if (_e487 < 0.0lf) {
                    phi_1423_ = -(_e487);
                } else {
                    phi_1423_ = _e487;
                }
                let _e814 = phi_1423_;
                if (_e490 < 0.0lf) {
                    phi_1429_ = -(_e490);
                } else {
                    phi_1429_ = _e490;
                }
                let _e818 = phi_1429_;
                if (_e493 < 0.0lf) {
                    phi_1436_ = -(_e493);
                } else {
                    phi_1436_ = _e493;
                }
                let _e823 = phi_1436_;
                let _e824 = ((_e814 + _e818) + _e823);
                if (_e810 > _e824) {
                    phi_1442_ = _e810;
                } else {
                    phi_1442_ = _e824;
                }
                let _e827 = phi_1442_;
                if (_e536 < 0.0lf) {
                    phi_1448_ = -(_e536);
                } else {
                    phi_1448_ = _e536;
                }
                let _e831 = phi_1448_;
                if (_e537 < 0.0lf) {
                    phi_1454_ = -(_e537);
                } else {
                    phi_1454_ = _e537;
                }
                let _e835 = phi_1454_;
                if (_e538 < 0.0lf) {
                    phi_1461_ = -(_e538);
                } else {
                    phi_1461_ = _e538;
                }
                let _e840 = phi_1461_;
                let _e842 = (((_e831 + _e835) + _e840) * f64(0.5f));
                if (_e827 > _e842) {
                    phi_1468_ = _e827;
                } else {
                    phi_1468_ = _e842;
                }
                let _e845 = phi_1468_;
                let _e851 = local_20.member_3;
                let _e865 = (((((_e660 * _e770) * _e772) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e780 * f64(19f)) * ((_e660 * (_e714 + _e768)) + (_e714 * _e768)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e769 + _e660) * ((_e769 + _e714) * (_e769 + _e768)))));
                let _e866 = f64(3f);
                let _e867 = (_e549 * _e866);
                let _e868 = (_e606 * _e866);
                if (_e867 < _e868) {
                    phi_1496_ = _e867;
                } else {
                    phi_1496_ = _e868;
                }
                let _e871 = phi_1496_;
                if (_e572 < _e595) {
                    phi_1501_ = _e572;
                } else {
                    phi_1501_ = _e595;
                }
                let _e874 = phi_1501_;
                if (_e871 < _e874) {
                    phi_1506_ = _e871;
                } else {
                    phi_1506_ = _e874;
                }
                let _e877 = phi_1506_;
                if (_e867 > _e868) {
                    phi_1511_ = _e867;
                } else {
                    phi_1511_ = _e868;
                }
                let _e880 = phi_1511_;
                if (_e572 > _e595) {
                    phi_1516_ = _e572;
                } else {
                    phi_1516_ = _e595;
                }
                let _e883 = phi_1516_;
                if (_e880 > _e883) {
                    phi_1521_ = _e880;
                } else {
                    phi_1521_ = _e883;
                }
                let _e886 = phi_1521_;
                let _e892 = -(_e886);
                if (_e877 > _e892) {
                    phi_1532_ = _e877;
                } else {
                    phi_1532_ = _e892;
                }
                let _e895 = phi_1532_;
                if ((_e895 - (_e865 + ((_e450 * (((_e845 + (_e772 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e851 * f64(6f)) * (_e714 + _e768))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e769 + _e714) * (_e769 + _e768))))) * f64((3f * 1.0001f))))) > _e451) {
                    phi_7450_ = type_72(0u, type_72().member_1);
                } else {
                    if (_e450 > _e451) {
                        let _e3312 = f64(1f);
                        let _e3316 = local_20.member[0u];
                        let _e3322 = local_20.member_1[0u];
                        let _e3328 = local_20.member_2[0u];
                        let _e3332 = (_e3316[0] - _e3322[0]);
                        let _e3333 = (_e3316[1] - _e3322[1]);
                        let _e3334 = (_e3316[2] - _e3322[2]);
                        local_12 = array<array<f64, 3>, 4>(_e3316, array<f64, 3>(_e3332, _e3333, _e3334), array<f64, 3>((_e3316[0] - _e3328[0]), (_e3316[1] - _e3328[1]), (_e3316[2] - _e3328[2])), array<f64, 3>((_e3332 - _e3328[0]), (_e3333 - _e3328[1]), (_e3334 - _e3328[2])));
                        let _e3347 = local_20.member[1u];
                        let _e3353 = local_20.member_1[1u];
                        let _e3359 = local_20.member_2[1u];
                        let _e3363 = (_e3347[0] - _e3353[0]);
                        let _e3364 = (_e3347[1] - _e3353[1]);
                        let _e3365 = (_e3347[2] - _e3353[2]);
                        local_13 = array<array<f64, 3>, 4>(_e3347, array<f64, 3>(_e3363, _e3364, _e3365), array<f64, 3>((_e3347[0] - _e3359[0]), (_e3347[1] - _e3359[1]), (_e3347[2] - _e3359[2])), array<f64, 3>((_e3363 - _e3359[0]), (_e3364 - _e3359[1]), (_e3365 - _e3359[2])));
                        let _e3378 = local_20.member[0u];
                        if (_e3378[0] < 0.0lf) {
                            phi_1735_ = -(_e3378[0]);
                        } else {
                            phi_1735_ = _e3378[0];
                        }
                        let _e3385 = phi_1735_;
                        if (_e3378[1] < 0.0lf) {
                            phi_1742_ = -(_e3378[1]);
                        } else {
                            phi_1742_ = _e3378[1];
                        }
                        let _e3389 = phi_1742_;
                        if (_e3385 > _e3389) {
                            phi_1747_ = _e3385;
                        } else {
                            phi_1747_ = _e3389;
                        }
                        let _e3392 = phi_1747_;
                        if (_e3378[2] < 0.0lf) {
                            phi_1754_ = -(_e3378[2]);
                        } else {
                            phi_1754_ = _e3378[2];
                        }
                        let _e3396 = phi_1754_;
                        if (_e3392 > _e3396) {
                            phi_1759_ = _e3392;
                        } else {
                            phi_1759_ = _e3396;
                        }
                        let _e3399 = phi_1759_;
                        let _e3402 = local_20.member[1u];
                        if (_e3402[0] < 0.0lf) {
                            phi_1772_ = -(_e3402[0]);
                        } else {
                            phi_1772_ = _e3402[0];
                        }
                        let _e3409 = phi_1772_;
                        if (_e3402[1] < 0.0lf) {
                            phi_1779_ = -(_e3402[1]);
                        } else {
                            phi_1779_ = _e3402[1];
                        }
                        let _e3413 = phi_1779_;
                        if (_e3409 > _e3413) {
                            phi_1784_ = _e3409;
                        } else {
                            phi_1784_ = _e3413;
                        }
                        let _e3416 = phi_1784_;
                        if (_e3402[2] < 0.0lf) {
                            phi_1791_ = -(_e3402[2]);
                        } else {
                            phi_1791_ = _e3402[2];
                        }
                        let _e3420 = phi_1791_;
                        if (_e3416 > _e3420) {
                            phi_1796_ = _e3416;
                        } else {
                            phi_1796_ = _e3420;
                        }
                        let _e3423 = phi_1796_;
                        if (_e3399 > _e3423) {
                            phi_1801_ = _e3399;
                        } else {
                            phi_1801_ = _e3423;
                        }
                        let _e3426 = phi_1801_;
                        let _e3428 = local_20.member_3;
                        let _e3432 = local_20.member_1[0u];
                        if (_e3432[0] < 0.0lf) {
                            phi_1818_ = -(_e3432[0]);
                        } else {
                            phi_1818_ = _e3432[0];
                        }
                        let _e3439 = phi_1818_;
                        if (_e3432[1] < 0.0lf) {
                            phi_1825_ = -(_e3432[1]);
                        } else {
                            phi_1825_ = _e3432[1];
                        }
                        let _e3443 = phi_1825_;
                        if (_e3439 > _e3443) {
                            phi_1830_ = _e3439;
                        } else {
                            phi_1830_ = _e3443;
                        }
                        let _e3446 = phi_1830_;
                        if (_e3432[2] < 0.0lf) {
                            phi_1837_ = -(_e3432[2]);
                        } else {
                            phi_1837_ = _e3432[2];
                        }
                        let _e3450 = phi_1837_;
                        if (_e3446 > _e3450) {
                            phi_1842_ = _e3446;
                        } else {
                            phi_1842_ = _e3450;
                        }
                        let _e3453 = phi_1842_;
                        let _e3456 = local_20.member_1[1u];
                        if (_e3456[0] < 0.0lf) {
                            phi_1856_ = -(_e3456[0]);
                        } else {
                            phi_1856_ = _e3456[0];
                        }
                        let _e3463 = phi_1856_;
                        if (_e3456[1] < 0.0lf) {
                            phi_1863_ = -(_e3456[1]);
                        } else {
                            phi_1863_ = _e3456[1];
                        }
                        let _e3467 = phi_1863_;
                        if (_e3463 > _e3467) {
                            phi_1868_ = _e3463;
                        } else {
                            phi_1868_ = _e3467;
                        }
                        let _e3470 = phi_1868_;
                        if (_e3456[2] < 0.0lf) {
                            phi_1875_ = -(_e3456[2]);
                        } else {
                            phi_1875_ = _e3456[2];
                        }
                        let _e3474 = phi_1875_;
                        if (_e3470 > _e3474) {
                            phi_1880_ = _e3470;
                        } else {
                            phi_1880_ = _e3474;
                        }
                        let _e3477 = phi_1880_;
                        if (_e3453 > _e3477) {
                            phi_1885_ = _e3453;
                        } else {
                            phi_1885_ = _e3477;
                        }
                        let _e3480 = phi_1885_;
                        let _e3482 = local_20.member_3;
                        let _e3486 = local_20.member_2[0u];
                        if (_e3486[0] < 0.0lf) {
                            phi_1902_ = -(_e3486[0]);
                        } else {
                            phi_1902_ = _e3486[0];
                        }
                        let _e3493 = phi_1902_;
                        if (_e3486[1] < 0.0lf) {
                            phi_1909_ = -(_e3486[1]);
                        } else {
                            phi_1909_ = _e3486[1];
                        }
                        let _e3497 = phi_1909_;
                        if (_e3493 > _e3497) {
                            phi_1914_ = _e3493;
                        } else {
                            phi_1914_ = _e3497;
                        }
                        let _e3500 = phi_1914_;
                        if (_e3486[2] < 0.0lf) {
                            phi_1921_ = -(_e3486[2]);
                        } else {
                            phi_1921_ = _e3486[2];
                        }
                        let _e3504 = phi_1921_;
                        if (_e3500 > _e3504) {
                            phi_1926_ = _e3500;
                        } else {
                            phi_1926_ = _e3504;
                        }
                        let _e3507 = phi_1926_;
                        let _e3510 = local_20.member_2[1u];
                        if (_e3510[0] < 0.0lf) {
                            phi_1940_ = -(_e3510[0]);
                        } else {
                            phi_1940_ = _e3510[0];
                        }
                        let _e3517 = phi_1940_;
                        if (_e3510[1] < 0.0lf) {
                            phi_1947_ = -(_e3510[1]);
                        } else {
                            phi_1947_ = _e3510[1];
                        }
                        let _e3521 = phi_1947_;
                        if (_e3517 > _e3521) {
                            phi_1952_ = _e3517;
                        } else {
                            phi_1952_ = _e3521;
                        }
                        let _e3524 = phi_1952_;
                        if (_e3510[2] < 0.0lf) {
                            phi_1959_ = -(_e3510[2]);
                        } else {
                            phi_1959_ = _e3510[2];
                        }
                        let _e3528 = phi_1959_;
                        if (_e3524 > _e3528) {
                            phi_1964_ = _e3524;
                        } else {
                            phi_1964_ = _e3528;
                        }
                        let _e3531 = phi_1964_;
                        if (_e3507 > _e3531) {
                            phi_1969_ = _e3507;
                        } else {
                            phi_1969_ = _e3531;
                        }
                        let _e3534 = phi_1969_;
                        let _e3536 = local_20.member_3;
                        let _e3544 = local_20.member_3;
                        phi_1989_ = type_29(0u, 48u);
                        phi_1992_ = f64(0f);
                        loop {
                            let _e3553 = phi_1989_;
                            let _e3555 = phi_1992_;
                            local_87 = _e3555;
                            local_45 = _e3555;
                            local_46 = _e3555;
                            local_47 = _e3555;
                            local_48 = _e3555;
                            if (_e3553.member < _e3553.member_1) {
                                phi_1990_ = type_29((_e3553.member + 1u), _e3553.member_1);
                                phi_2015_ = type_29(1u, _e3553.member);
                            } else {
                                phi_1990_ = _e3553;
                                phi_2015_ = type_29(0u, type_29().member_1);
                            }
                            let _e3569 = phi_1990_;
                            let _e3571 = phi_2015_;
                            if (bitcast<i32>(_e3571.member) != 0i) {
                                let _e3577 = local_20.member[0u];
                                let _e3583 = local_20.member[1u];
                                let _e3593 = (_e3577[0] + ((_e3583[0] - _e3577[0]) * _e3555));
                                let _e3594 = (_e3577[1] + ((_e3583[1] - _e3577[1]) * _e3555));
                                let _e3595 = (_e3577[2] + ((_e3583[2] - _e3577[2]) * _e3555));
                                let _e3598 = local_20.member_1[0u];
                                let _e3604 = local_20.member_1[1u];
                                let _e3614 = (_e3598[0] + ((_e3604[0] - _e3598[0]) * _e3555));
                                let _e3615 = (_e3598[1] + ((_e3604[1] - _e3598[1]) * _e3555));
                                let _e3616 = (_e3598[2] + ((_e3604[2] - _e3598[2]) * _e3555));
                                let _e3619 = local_20.member_2[0u];
                                let _e3625 = local_20.member_2[1u];
                                let _e3635 = (_e3619[0] + ((_e3625[0] - _e3619[0]) * _e3555));
                                let _e3636 = (_e3619[1] + ((_e3625[1] - _e3619[1]) * _e3555));
                                let _e3637 = (_e3619[2] + ((_e3625[2] - _e3619[2]) * _e3555));
                                let _e3642 = (((_e3614 * _e3614) + (_e3615 * _e3615)) + (_e3616 * _e3616));
                                let _e3647 = (((_e3614 * _e3635) + (_e3615 * _e3636)) + (_e3616 * _e3637));
                                let _e3652 = (((_e3635 * _e3635) + (_e3636 * _e3636)) + (_e3637 * _e3637));
                                let _e3657 = (((_e3593 * _e3614) + (_e3594 * _e3615)) + (_e3595 * _e3616));
                                let _e3662 = (((_e3593 * _e3635) + (_e3594 * _e3636)) + (_e3595 * _e3637));
                                let _e3665 = ((_e3642 * _e3652) - (_e3647 * _e3647));
                                let _e3666 = f64(0f);
                                let _e3667 = f64(1f);
                                let _e3671 = (((_e3657 * _e3652) - (_e3662 * _e3647)) / _e3665);
                                let _e3675 = (((_e3662 * _e3642) - (_e3657 * _e3647)) / _e3665);
                                if (_e3671 >= _e3666) {
                                    if (_e3675 >= _e3666) {
                                        if (_e3671 <= _e3667) {
                                            phi_2171_ = (_e3675 <= _e3667);
                                            phi_2172_ = false;
                                        } else {
                                            phi_2171_ = bool();
                                            phi_2172_ = true;
                                        }
                                        let _e3681 = phi_2171_;
                                        let _e3683 = phi_2172_;
                                        phi_2173_ = _e3681;
                                        phi_2174_ = _e3683;
                                    } else {
                                        phi_2173_ = bool();
                                        phi_2174_ = true;
                                    }
                                    let _e3685 = phi_2173_;
                                    let _e3687 = phi_2174_;
                                    phi_2175_ = _e3685;
                                    phi_2176_ = _e3687;
                                } else {
                                    phi_2175_ = bool();
                                    phi_2176_ = true;
                                }
                                let _e3689 = phi_2175_;
                                let _e3691 = phi_2176_;
                                if _e3691 {
                                    phi_2180_ = false;
                                } else {
                                    phi_2180_ = _e3689;
                                }
                                let _e3693 = phi_2180_;
                                if (_e3665 > _e3666) {
                                    if _e3693 {
                                        phi_2220_ = array<f64, 3>((_e3593 - ((_e3614 * _e3671) + (_e3635 * _e3675))), (_e3594 - ((_e3615 * _e3671) + (_e3636 * _e3675))), (_e3595 - ((_e3616 * _e3671) + (_e3637 * _e3675))));
                                        phi_2221_ = false;
                                    } else {
                                        phi_2220_ = array<f64, 3>();
                                        phi_2221_ = true;
                                    }
                                    let _e3709 = phi_2220_;
                                    let _e3711 = phi_2221_;
                                    phi_2222_ = _e3709;
                                    phi_2223_ = _e3711;
                                } else {
                                    phi_2222_ = array<f64, 3>();
                                    phi_2223_ = true;
                                }
                                let _e3713 = phi_2222_;
                                let _e3715 = phi_2223_;
                                if _e3715 {
                                    let _e3716 = (_e3593 - _e3614);
                                    let _e3717 = (_e3594 - _e3615);
                                    let _e3718 = (_e3595 - _e3616);
                                    let _e3729 = ((((_e3593 * _e3614) + (_e3594 * _e3615)) + (_e3595 * _e3616)) / (((_e3614 * _e3614) + (_e3615 * _e3615)) + (_e3616 * _e3616)));
                                    if (_e3729 > f64(0f)) {
                                        if (_e3729 < f64(1f)) {
                                            phi_2256_ = _e3729;
                                        } else {
                                            phi_2256_ = f64(1f);
                                        }
                                        let _e3737 = phi_2256_;
                                        phi_2258_ = _e3737;
                                    } else {
                                        phi_2258_ = f64(0f);
                                    }
                                    let _e3739 = phi_2258_;
                                    let _e3756 = ((((_e3593 * _e3635) + (_e3594 * _e3636)) + (_e3595 * _e3637)) / (((_e3635 * _e3635) + (_e3636 * _e3636)) + (_e3637 * _e3637)));
                                    if (_e3756 > f64(0f)) {
                                        if (_e3756 < f64(1f)) {
                                            phi_2288_ = _e3756;
                                        } else {
                                            phi_2288_ = f64(1f);
                                        }
                                        let _e3764 = phi_2288_;
                                        phi_2290_ = _e3764;
                                    } else {
                                        phi_2290_ = f64(0f);
                                    }
                                    let _e3766 = phi_2290_;
                                    let _e3783 = ((((_e3716 * _e3635) + (_e3717 * _e3636)) + (_e3718 * _e3637)) / (((_e3635 * _e3635) + (_e3636 * _e3636)) + (_e3637 * _e3637)));
                                    if (_e3783 > f64(0f)) {
                                        if (_e3783 < f64(1f)) {
                                            phi_2320_ = _e3783;
                                        } else {
                                            phi_2320_ = f64(1f);
                                        }
                                        let _e3791 = phi_2320_;
                                        phi_2322_ = _e3791;
                                    } else {
                                        phi_2322_ = f64(0f);
                                    }
                                    let _e3793 = phi_2322_;
                                    let _e3800 = (_e3593 - _e3635);
                                    let _e3801 = (_e3594 - _e3636);
                                    let _e3802 = (_e3595 - _e3637);
                                    let _e3813 = ((((_e3800 * _e3614) + (_e3801 * _e3615)) + (_e3802 * _e3616)) / (((_e3614 * _e3614) + (_e3615 * _e3615)) + (_e3616 * _e3616)));
                                    if (_e3813 > f64(0f)) {
                                        if (_e3813 < f64(1f)) {
                                            phi_2355_ = _e3813;
                                        } else {
                                            phi_2355_ = f64(1f);
                                        }
                                        let _e3821 = phi_2355_;
                                        phi_2357_ = _e3821;
                                    } else {
                                        phi_2357_ = f64(0f);
                                    }
                                    let _e3823 = phi_2357_;
                                    local_11[0u] = array<f64, 3>((_e3593 - (_e3614 * _e3739)), (_e3594 - (_e3615 * _e3739)), (_e3595 - (_e3616 * _e3739)));
                                    local_11[1u] = array<f64, 3>((_e3593 - (_e3635 * _e3766)), (_e3594 - (_e3636 * _e3766)), (_e3595 - (_e3637 * _e3766)));
                                    local_11[2u] = array<f64, 3>((_e3716 - (_e3635 * _e3793)), (_e3717 - (_e3636 * _e3793)), (_e3718 - (_e3637 * _e3793)));
                                    local_11[3u] = array<f64, 3>((_e3800 - (_e3614 * _e3823)), (_e3801 - (_e3615 * _e3823)), (_e3802 - (_e3616 * _e3823)));
                                    let _e3839 = local_11[0u];
                                    phi_2512_ = type_29(1u, 4u);
                                    phi_2515_ = array<f64, 3>(_e3839[0], _e3839[1], _e3839[2]);
                                    loop {
                                        let _e3845 = phi_2512_;
                                        let _e3847 = phi_2515_;
                                        local_74 = _e3847;
                                        if (_e3845.member < _e3845.member_1) {
                                            phi_2513_ = type_29((_e3845.member + 1u), _e3845.member_1);
                                            phi_2538_ = type_29(1u, _e3845.member);
                                        } else {
                                            phi_2513_ = _e3845;
                                            phi_2538_ = type_29(0u, type_29().member_1);
                                        }
                                        let _e3861 = phi_2513_;
                                        let _e3863 = phi_2538_;
                                        let _e3867 = (bitcast<i32>(_e3863.member) != 0i);
                                        if _e3867 {
                                            if (_e3863.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3870 = local_11[_e3863.member_1];
                                            if (_e3863.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3876 = local_11[_e3863.member_1];
                                            if ((((_e3870[0] * _e3876[0]) + (_e3870[1] * _e3876[1])) + (_e3870[2] * _e3876[2])) < (((_e3847[0] * _e3847[0]) + (_e3847[1] * _e3847[1])) + (_e3847[2] * _e3847[2]))) {
                                                if (_e3863.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3899 = local_11[_e3863.member_1];
                                                phi_2605_ = array<f64, 3>(_e3899[0], _e3899[1], _e3899[2]);
                                            } else {
                                                phi_2605_ = _e3847;
                                            }
                                            let _e3905 = phi_2605_;
                                            phi_2516_ = _e3905;
                                        } else {
                                            phi_2516_ = array<f64, 3>();
                                        }
                                        let _e3907 = phi_2516_;
                                        continue;
                                        continuing {
                                            phi_2512_ = _e3861;
                                            phi_2515_ = _e3907;
                                            break if !(_e3867);
                                        }
                                    }
                                    let _e5721 = local_74;
                                    phi_2606_ = _e5721;
                                } else {
                                    phi_2606_ = _e3713;
                                }
                                let _e3910 = phi_2606_;
                                if (_e3910[0] < 0.0lf) {
                                    phi_2613_ = -(_e3910[0]);
                                } else {
                                    phi_2613_ = _e3910[0];
                                }
                                let _e3915 = phi_2613_;
                                if (_e3910[1] < 0.0lf) {
                                    phi_2620_ = -(_e3910[1]);
                                } else {
                                    phi_2620_ = _e3910[1];
                                }
                                let _e3920 = phi_2620_;
                                if (_e3910[2] < 0.0lf) {
                                    phi_2628_ = -(_e3910[2]);
                                } else {
                                    phi_2628_ = _e3910[2];
                                }
                                let _e3926 = phi_2628_;
                                let _e3927 = ((_e3915 + _e3920) + _e3926);
                                if (_e3927 > f64(0f)) {
                                    if ((bitcast<u64>(_e3927) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e3933 = (f64(1f) / _e3927);
                                        let _e3935 = (_e3910[0] * _e3933);
                                        let _e3937 = (_e3910[1] * _e3933);
                                        let _e3939 = (_e3910[2] * _e3933);
                                        let _e3944 = (((_e3935 * _e3935) + (_e3937 * _e3937)) + (_e3939 * _e3939));
                                        if (_e3944 <= 2.2250738585072014e-308lf) {
                                            if (_e3944 > 0.0lf) {
                                                phi_2666_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2666_ = 0.0lf;
                                            }
                                            let _e4002 = phi_2666_;
                                            phi_2730_ = _e4002;
                                        } else {
                                            phi_2673_ = type_27(0i, 5i);
                                            phi_2676_ = bitcast<f64>(((bitcast<u64>(_e3944) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e3951 = phi_2673_;
                                                let _e3953 = phi_2676_;
                                                local_39 = _e3953;
                                                if (_e3951.member < _e3951.member_1) {
                                                    let _e3961 = (_e3951.member + 1i);
                                                    if ((false == (_e3961 > _e3951.member)) != false) {
                                                        phi_2697_ = true;
                                                    } else {
                                                        phi_2697_ = false;
                                                    }
                                                    let _e3966 = phi_2697_;
                                                    if _e3966 {
                                                        phi_2703_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_2703_ = type_28(1u, _e3961);
                                                    }
                                                    let _e3972 = phi_2703_;
                                                    if (bitcast<i32>(_e3972.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2674_ = type_27(_e3972.member_1, _e3951.member_1);
                                                    phi_2717_ = type_28(1u, _e3951.member);
                                                } else {
                                                    phi_2674_ = _e3951;
                                                    phi_2717_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e3982 = phi_2674_;
                                                let _e3984 = phi_2717_;
                                                let _e3987 = (bitcast<i32>(_e3984.member) != 0i);
                                                if _e3987 {
                                                    phi_2677_ = (0.5lf * (_e3953 + (_e3944 / _e3953)));
                                                } else {
                                                    phi_2677_ = f64();
                                                }
                                                let _e3992 = phi_2677_;
                                                continue;
                                                continuing {
                                                    phi_2673_ = _e3982;
                                                    phi_2676_ = _e3992;
                                                    break if !(_e3987);
                                                }
                                            }
                                            let _e3997 = local_39;
                                            phi_2730_ = (_e3997 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e4004 = phi_2730_;
                                        phi_2743_ = type_29(0u, 4u);
                                        phi_2746_ = f64(2f);
                                        loop {
                                            let _e4016 = phi_2743_;
                                            let _e4018 = phi_2746_;
                                            local_41 = _e4018;
                                            local_42 = _e4018;
                                            local_43 = _e4018;
                                            local_77 = _e4018;
                                            local_78 = _e4018;
                                            if (_e4016.member < _e4016.member_1) {
                                                phi_2744_ = type_29((_e4016.member + 1u), _e4016.member_1);
                                                phi_2769_ = type_29(1u, _e4016.member);
                                            } else {
                                                phi_2744_ = _e4016;
                                                phi_2769_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e4032 = phi_2744_;
                                            let _e4034 = phi_2769_;
                                            if (bitcast<i32>(_e4034.member) != 0i) {
                                                if (_e4034.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4041 = local_12[_e4034.member_1];
                                                let _e4049 = (((_e3935 * _e4041[0]) + (_e3937 * _e4041[1])) + (_e3939 * _e4041[2]));
                                                if (_e4034.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4052 = local_13[_e4034.member_1];
                                                let _e4060 = (((_e3935 * _e4052[0]) + (_e3937 * _e4052[1])) + (_e3939 * _e4052[2]));
                                                if (_e4049 < 0.0lf) {
                                                    phi_2820_ = -(_e4049);
                                                } else {
                                                    phi_2820_ = _e4049;
                                                }
                                                let _e4064 = phi_2820_;
                                                if (_e4060 < 0.0lf) {
                                                    phi_2826_ = -(_e4060);
                                                } else {
                                                    phi_2826_ = _e4060;
                                                }
                                                let _e4068 = phi_2826_;
                                                let _e4073 = (((((((((_e3426 + _e3428) + (_e3480 + _e3482)) + (_e3534 + _e3536)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3544 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e450 * _e4004) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e4064 + _e4068) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e4049 > _e4073) {
                                                    if (_e4060 > _e4073) {
                                                        phi_2840_ = false;
                                                    } else {
                                                        phi_2840_ = true;
                                                    }
                                                    let _e4077 = phi_2840_;
                                                    phi_2841_ = _e4077;
                                                } else {
                                                    phi_2841_ = true;
                                                }
                                                let _e4079 = phi_2841_;
                                                if _e4079 {
                                                    if ((_e4049 + ((_e4060 - _e4049) * _e3555)) > _e4073) {
                                                        if (_e4060 < _e4049) {
                                                            let _e4088 = ((_e4049 - _e4060) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                            if _e4088 {
                                                                let _e4096 = (((_e4049 - _e4073) / (_e4049 - _e4060)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                if (_e4018 < _e4096) {
                                                                    phi_2875_ = _e4018;
                                                                } else {
                                                                    phi_2875_ = _e4096;
                                                                }
                                                                let _e4099 = phi_2875_;
                                                                phi_2876_ = _e4099;
                                                            } else {
                                                                phi_2876_ = f64();
                                                            }
                                                            let _e4101 = phi_2876_;
                                                            phi_2877_ = _e4101;
                                                            phi_2878_ = _e4088;
                                                        } else {
                                                            phi_2877_ = _e4018;
                                                            phi_2878_ = true;
                                                        }
                                                        let _e4103 = phi_2877_;
                                                        let _e4105 = phi_2878_;
                                                        if _e4105 {
                                                            phi_2882_ = false;
                                                        } else {
                                                            phi_2882_ = true;
                                                        }
                                                        let _e4107 = phi_2882_;
                                                        phi_2883_ = _e4103;
                                                        phi_2884_ = _e4105;
                                                        phi_2885_ = _e4107;
                                                        phi_2886_ = false;
                                                    } else {
                                                        phi_2883_ = f64();
                                                        phi_2884_ = false;
                                                        phi_2885_ = false;
                                                        phi_2886_ = true;
                                                    }
                                                    let _e4109 = phi_2883_;
                                                    let _e4111 = phi_2884_;
                                                    let _e4113 = phi_2885_;
                                                    let _e4115 = phi_2886_;
                                                    phi_2887_ = _e4109;
                                                    phi_2888_ = _e4111;
                                                    phi_2889_ = _e4113;
                                                    phi_2890_ = _e4115;
                                                } else {
                                                    phi_2887_ = _e4018;
                                                    phi_2888_ = true;
                                                    phi_2889_ = false;
                                                    phi_2890_ = false;
                                                }
                                                let _e4117 = phi_2887_;
                                                let _e4119 = phi_2888_;
                                                let _e4121 = phi_2889_;
                                                let _e4123 = phi_2890_;
                                                phi_2747_ = _e4117;
                                                phi_2891_ = _e4119;
                                                phi_2892_ = false;
                                                phi_2893_ = _e4121;
                                                phi_2894_ = _e4123;
                                            } else {
                                                phi_2747_ = f64();
                                                phi_2891_ = false;
                                                phi_2892_ = true;
                                                phi_2893_ = false;
                                                phi_2894_ = false;
                                            }
                                            let _e4125 = phi_2747_;
                                            let _e4127 = phi_2891_;
                                            let _e4129 = phi_2892_;
                                            let _e4131 = phi_2893_;
                                            let _e4133 = phi_2894_;
                                            local_40 = _e4129;
                                            local_75 = _e4131;
                                            local_76 = _e4133;
                                            continue;
                                            continuing {
                                                phi_2743_ = _e4032;
                                                phi_2746_ = _e4125;
                                                break if !(_e4127);
                                            }
                                        }
                                        let _e4136 = local_40;
                                        if _e4136 {
                                            let _e4138 = local_41;
                                            let _e4139 = (_e4138 > _e3312);
                                            if _e4139 {
                                                phi_2916_ = false;
                                                phi_2917_ = false;
                                                phi_2918_ = false;
                                            } else {
                                                let _e4141 = local_42;
                                                if (_e4141 > _e3555) {
                                                    let _e4144 = local_43;
                                                    let _e4147 = ((_e4144 - _e3555) < f64(0.00000000023283064f));
                                                    if _e4147 {
                                                        phi_2912_ = false;
                                                    } else {
                                                        phi_2912_ = true;
                                                    }
                                                    let _e4149 = phi_2912_;
                                                    phi_2913_ = _e4149;
                                                    phi_2914_ = _e4147;
                                                    phi_2915_ = false;
                                                } else {
                                                    phi_2913_ = false;
                                                    phi_2914_ = false;
                                                    phi_2915_ = true;
                                                }
                                                let _e4151 = phi_2913_;
                                                let _e4153 = phi_2914_;
                                                let _e4155 = phi_2915_;
                                                phi_2916_ = _e4151;
                                                phi_2917_ = _e4153;
                                                phi_2918_ = _e4155;
                                            }
                                            let _e4157 = phi_2916_;
                                            let _e4159 = phi_2917_;
                                            let _e4161 = phi_2918_;
                                            phi_2919_ = _e4157;
                                            phi_2920_ = _e4139;
                                            phi_2921_ = _e4159;
                                            phi_2922_ = _e4161;
                                            phi_2923_ = false;
                                            phi_2924_ = false;
                                        } else {
                                            phi_2919_ = false;
                                            phi_2920_ = false;
                                            phi_2921_ = false;
                                            phi_2922_ = false;
                                            let _e5778 = local_75;
                                            phi_2923_ = _e5778;
                                            let _e5781 = local_76;
                                            phi_2924_ = _e5781;
                                        }
                                        let _e4163 = phi_2919_;
                                        let _e4165 = phi_2920_;
                                        let _e4167 = phi_2921_;
                                        let _e4169 = phi_2922_;
                                        let _e4171 = phi_2923_;
                                        let _e4173 = phi_2924_;
                                        let _e5784 = local_77;
                                        phi_2925_ = _e5784;
                                        let _e5787 = local_78;
                                        phi_2926_ = _e5787;
                                        phi_2927_ = _e4163;
                                        phi_2928_ = _e4165;
                                        phi_2929_ = _e4167;
                                        phi_2930_ = _e4169;
                                        phi_2931_ = _e4171;
                                        phi_2932_ = _e4173;
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
                                    let _e4175 = phi_2925_;
                                    let _e4177 = phi_2926_;
                                    let _e4179 = phi_2927_;
                                    let _e4181 = phi_2928_;
                                    let _e4183 = phi_2929_;
                                    let _e4185 = phi_2930_;
                                    let _e4187 = phi_2931_;
                                    let _e4189 = phi_2932_;
                                    let _e4191 = phi_2933_;
                                    phi_2934_ = _e4175;
                                    phi_2935_ = _e4177;
                                    phi_2936_ = _e4179;
                                    phi_2937_ = _e4181;
                                    phi_2938_ = _e4183;
                                    phi_2939_ = _e4185;
                                    phi_2940_ = _e4187;
                                    phi_2941_ = _e4189;
                                    phi_2942_ = _e4191;
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
                                let _e4193 = phi_2934_;
                                let _e4195 = phi_2935_;
                                let _e4197 = phi_2936_;
                                let _e4199 = phi_2937_;
                                let _e4201 = phi_2938_;
                                let _e4203 = phi_2939_;
                                let _e4205 = phi_2940_;
                                let _e4207 = phi_2941_;
                                let _e4209 = phi_2942_;
                                let _e4211 = phi_2943_;
                                phi_2944_ = _e4193;
                                phi_1993_ = _e4195;
                                phi_2945_ = _e4197;
                                phi_2946_ = _e4199;
                                phi_2947_ = _e4201;
                                phi_2948_ = false;
                                phi_2949_ = _e4203;
                                phi_2950_ = _e4205;
                                phi_2951_ = _e4207;
                                phi_2952_ = _e4209;
                                phi_2953_ = _e4211;
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
                            let _e4213 = phi_2944_;
                            let _e4215 = phi_1993_;
                            let _e4217 = phi_2945_;
                            let _e4219 = phi_2946_;
                            let _e4221 = phi_2947_;
                            let _e4223 = phi_2948_;
                            let _e4225 = phi_2949_;
                            let _e4227 = phi_2950_;
                            let _e4229 = phi_2951_;
                            let _e4231 = phi_2952_;
                            let _e4233 = phi_2953_;
                            local_44 = _e4219;
                            local_79 = _e4221;
                            local_80 = _e4223;
                            local_81 = _e4225;
                            local_82 = _e4227;
                            local_83 = _e4229;
                            local_84 = _e4231;
                            local_85 = _e4233;
                            local_86 = _e4213;
                            local_88 = _e4219;
                            continue;
                            continuing {
                                phi_1989_ = _e3569;
                                phi_1992_ = _e4215;
                                break if !(_e4217);
                            }
                        }
                        let _e4236 = local_44;
                        if _e4236 {
                            phi_2958_ = type_72(0u, type_72().member_1);
                            phi_2959_ = false;
                            phi_2960_ = false;
                            phi_2961_ = false;
                            phi_2962_ = false;
                            phi_2963_ = false;
                            phi_2964_ = false;
                            phi_2965_ = false;
                        } else {
                            phi_2958_ = type_72();
                            let _e5820 = local_79;
                            phi_2959_ = _e5820;
                            let _e5823 = local_80;
                            phi_2960_ = _e5823;
                            let _e5826 = local_81;
                            phi_2961_ = _e5826;
                            let _e5829 = local_82;
                            phi_2962_ = _e5829;
                            let _e5832 = local_83;
                            phi_2963_ = _e5832;
                            let _e5835 = local_84;
                            phi_2964_ = _e5835;
                            let _e5838 = local_85;
                            phi_2965_ = _e5838;
                        }
                        let _e4241 = phi_2958_;
                        let _e4243 = phi_2959_;
                        let _e4245 = phi_2960_;
                        let _e4247 = phi_2961_;
                        let _e4249 = phi_2962_;
                        let _e4251 = phi_2963_;
                        let _e4253 = phi_2964_;
                        let _e4255 = phi_2965_;
                        if _e4243 {
                            let _e5841 = local_86;
                            phi_2969_ = _e5841;
                            phi_2970_ = true;
                            phi_2971_ = false;
                            phi_2972_ = false;
                            phi_2973_ = false;
                            phi_2974_ = false;
                            phi_2975_ = false;
                            phi_2976_ = false;
                        } else {
                            let _e5843 = local_87;
                            phi_2969_ = _e5843;
                            phi_2970_ = _e4245;
                            phi_2971_ = _e4247;
                            phi_2972_ = _e4249;
                            phi_2973_ = _e4251;
                            let _e5850 = local_88;
                            phi_2974_ = _e5850;
                            phi_2975_ = _e4253;
                            phi_2976_ = _e4255;
                        }
                        let _e4257 = phi_2969_;
                        let _e4259 = phi_2970_;
                        let _e4261 = phi_2971_;
                        let _e4263 = phi_2972_;
                        let _e4265 = phi_2973_;
                        let _e4267 = phi_2974_;
                        let _e4269 = phi_2975_;
                        let _e4271 = phi_2976_;
                        if _e4259 {
                            phi_2981_ = type_72(1u, _e4257);
                            phi_2982_ = false;
                            phi_2983_ = false;
                            phi_2984_ = false;
                            phi_2985_ = false;
                            phi_2986_ = false;
                            phi_2987_ = false;
                        } else {
                            phi_2981_ = type_72();
                            phi_2982_ = _e4261;
                            phi_2983_ = _e4263;
                            phi_2984_ = _e4265;
                            phi_2985_ = _e4267;
                            phi_2986_ = _e4269;
                            phi_2987_ = _e4271;
                        }
                        let _e4274 = phi_2981_;
                        let _e4276 = phi_2982_;
                        let _e4278 = phi_2983_;
                        let _e4280 = phi_2984_;
                        let _e4282 = phi_2985_;
                        let _e4284 = phi_2986_;
                        let _e4286 = phi_2987_;
                        if _e4276 {
                            let _e4288 = local_45;
                            phi_2992_ = type_72(1u, _e4288);
                            phi_2993_ = false;
                            phi_2994_ = false;
                            phi_2995_ = true;
                            phi_2996_ = false;
                            phi_2997_ = false;
                        } else {
                            phi_2992_ = _e4241;
                            phi_2993_ = _e4278;
                            phi_2994_ = _e4280;
                            phi_2995_ = _e4282;
                            phi_2996_ = _e4284;
                            phi_2997_ = _e4286;
                        }
                        let _e4291 = phi_2992_;
                        let _e4293 = phi_2993_;
                        let _e4295 = phi_2994_;
                        let _e4297 = phi_2995_;
                        let _e4299 = phi_2996_;
                        let _e4301 = phi_2997_;
                        if _e4293 {
                            let _e4303 = local_46;
                            phi_3002_ = type_72(1u, _e4303);
                            phi_3003_ = false;
                            phi_3004_ = false;
                            phi_3005_ = false;
                            phi_3006_ = false;
                        } else {
                            phi_3002_ = type_72();
                            phi_3003_ = _e4295;
                            phi_3004_ = _e4297;
                            phi_3005_ = _e4299;
                            phi_3006_ = _e4301;
                        }
                        let _e4306 = phi_3002_;
                        let _e4308 = phi_3003_;
                        let _e4310 = phi_3004_;
                        let _e4312 = phi_3005_;
                        let _e4314 = phi_3006_;
                        if _e4308 {
                            let _e4316 = local_47;
                            phi_3011_ = type_72(1u, _e4316);
                            phi_3012_ = true;
                            phi_3013_ = false;
                            phi_3014_ = false;
                            phi_3015_ = false;
                        } else {
                            phi_3011_ = _e4306;
                            phi_3012_ = _e4293;
                            phi_3013_ = _e4310;
                            phi_3014_ = _e4312;
                            phi_3015_ = _e4314;
                        }
                        let _e4319 = phi_3011_;
                        let _e4321 = phi_3012_;
                        let _e4323 = phi_3013_;
                        let _e4325 = phi_3014_;
                        let _e4327 = phi_3015_;
                        if _e4321 {
                            phi_3019_ = _e4319;
                            phi_3020_ = true;
                            phi_3021_ = false;
                            phi_3022_ = false;
                        } else {
                            phi_3019_ = _e4291;
                            phi_3020_ = _e4323;
                            phi_3021_ = _e4325;
                            phi_3022_ = _e4327;
                        }
                        let _e4329 = phi_3019_;
                        let _e4331 = phi_3020_;
                        let _e4333 = phi_3021_;
                        let _e4335 = phi_3022_;
                        if _e4331 {
                            phi_3026_ = false;
                            phi_3027_ = false;
                        } else {
                            phi_3026_ = _e4333;
                            phi_3027_ = _e4335;
                        }
                        let _e4337 = phi_3026_;
                        let _e4339 = phi_3027_;
                        if _e4337 {
                            phi_3031_ = false;
                            phi_3032_ = false;
                        } else {
                            phi_3031_ = _e4339;
                            phi_3032_ = _e4331;
                        }
                        let _e4341 = phi_3031_;
                        let _e4343 = phi_3032_;
                        if _e4341 {
                            phi_3036_ = true;
                            phi_3037_ = false;
                        } else {
                            phi_3036_ = _e4337;
                            phi_3037_ = _e4343;
                        }
                        let _e4345 = phi_3036_;
                        let _e4347 = phi_3037_;
                        if _e4345 {
                            let _e4349 = local_48;
                            phi_3042_ = type_72(1u, _e4349);
                            phi_3043_ = true;
                        } else {
                            phi_3042_ = _e4329;
                            phi_3043_ = _e4347;
                        }
                        let _e4352 = phi_3042_;
                        let _e4354 = phi_3043_;
                        if _e4354 {
                            phi_3047_ = _e4352;
                        } else {
                            phi_3047_ = _e4274;
                        }
                        let _e4356 = phi_3047_;
                        if (_e4356.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_3061_ = type_29(0u, 3u);
                            loop {
                                let _e4369 = phi_3061_;
                                if (_e4369.member < _e4369.member_1) {
                                    phi_3062_ = type_29((_e4369.member + 1u), _e4369.member_1);
                                    phi_3085_ = type_29(1u, _e4369.member);
                                } else {
                                    phi_3062_ = _e4369;
                                    phi_3085_ = type_29(0u, type_29().member_1);
                                }
                                let _e4383 = phi_3062_;
                                let _e4385 = phi_3085_;
                                if (bitcast<i32>(_e4385.member) != 0i) {
                                    if (_e4385.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4392 = local_14[_e4385.member_1];
                                    let _e4394 = (_e4356.member_1 + f64(_e4392));
                                    if (_e4394 < _e3312) {
                                        phi_3106_ = _e4394;
                                    } else {
                                        phi_3106_ = _e3312;
                                    }
                                    let _e4397 = phi_3106_;
                                    let _e4400 = local_20.member[0u];
                                    let _e4406 = local_20.member[1u];
                                    let _e4416 = (_e4400[0] + ((_e4406[0] - _e4400[0]) * _e4397));
                                    let _e4417 = (_e4400[1] + ((_e4406[1] - _e4400[1]) * _e4397));
                                    let _e4418 = (_e4400[2] + ((_e4406[2] - _e4400[2]) * _e4397));
                                    let _e4421 = local_20.member_1[0u];
                                    let _e4427 = local_20.member_1[1u];
                                    let _e4437 = (_e4421[0] + ((_e4427[0] - _e4421[0]) * _e4397));
                                    let _e4438 = (_e4421[1] + ((_e4427[1] - _e4421[1]) * _e4397));
                                    let _e4439 = (_e4421[2] + ((_e4427[2] - _e4421[2]) * _e4397));
                                    let _e4442 = local_20.member_2[0u];
                                    let _e4448 = local_20.member_2[1u];
                                    let _e4458 = (_e4442[0] + ((_e4448[0] - _e4442[0]) * _e4397));
                                    let _e4459 = (_e4442[1] + ((_e4448[1] - _e4442[1]) * _e4397));
                                    let _e4460 = (_e4442[2] + ((_e4448[2] - _e4442[2]) * _e4397));
                                    let _e4465 = (((_e4437 * _e4437) + (_e4438 * _e4438)) + (_e4439 * _e4439));
                                    let _e4470 = (((_e4437 * _e4458) + (_e4438 * _e4459)) + (_e4439 * _e4460));
                                    let _e4475 = (((_e4458 * _e4458) + (_e4459 * _e4459)) + (_e4460 * _e4460));
                                    let _e4480 = (((_e4416 * _e4437) + (_e4417 * _e4438)) + (_e4418 * _e4439));
                                    let _e4485 = (((_e4416 * _e4458) + (_e4417 * _e4459)) + (_e4418 * _e4460));
                                    let _e4488 = ((_e4465 * _e4475) - (_e4470 * _e4470));
                                    let _e4489 = f64(0f);
                                    let _e4490 = f64(1f);
                                    let _e4494 = (((_e4480 * _e4475) - (_e4485 * _e4470)) / _e4488);
                                    let _e4498 = (((_e4485 * _e4465) - (_e4480 * _e4470)) / _e4488);
                                    if (_e4494 >= _e4489) {
                                        if (_e4498 >= _e4489) {
                                            if (_e4494 <= _e4490) {
                                                phi_3256_ = (_e4498 <= _e4490);
                                                phi_3257_ = false;
                                            } else {
                                                phi_3256_ = bool();
                                                phi_3257_ = true;
                                            }
                                            let _e4504 = phi_3256_;
                                            let _e4506 = phi_3257_;
                                            phi_3258_ = _e4504;
                                            phi_3259_ = _e4506;
                                        } else {
                                            phi_3258_ = bool();
                                            phi_3259_ = true;
                                        }
                                        let _e4508 = phi_3258_;
                                        let _e4510 = phi_3259_;
                                        phi_3260_ = _e4508;
                                        phi_3261_ = _e4510;
                                    } else {
                                        phi_3260_ = bool();
                                        phi_3261_ = true;
                                    }
                                    let _e4512 = phi_3260_;
                                    let _e4514 = phi_3261_;
                                    if _e4514 {
                                        phi_3265_ = false;
                                    } else {
                                        phi_3265_ = _e4512;
                                    }
                                    let _e4516 = phi_3265_;
                                    if (_e4488 > _e4489) {
                                        if _e4516 {
                                            phi_3305_ = array<f64, 3>((_e4416 - ((_e4437 * _e4494) + (_e4458 * _e4498))), (_e4417 - ((_e4438 * _e4494) + (_e4459 * _e4498))), (_e4418 - ((_e4439 * _e4494) + (_e4460 * _e4498))));
                                            phi_3306_ = false;
                                        } else {
                                            phi_3305_ = array<f64, 3>();
                                            phi_3306_ = true;
                                        }
                                        let _e4532 = phi_3305_;
                                        let _e4534 = phi_3306_;
                                        phi_3307_ = _e4532;
                                        phi_3308_ = _e4534;
                                    } else {
                                        phi_3307_ = array<f64, 3>();
                                        phi_3308_ = true;
                                    }
                                    let _e4536 = phi_3307_;
                                    let _e4538 = phi_3308_;
                                    if _e4538 {
                                        let _e4539 = (_e4416 - _e4437);
                                        let _e4540 = (_e4417 - _e4438);
                                        let _e4541 = (_e4418 - _e4439);
                                        let _e4552 = ((((_e4416 * _e4437) + (_e4417 * _e4438)) + (_e4418 * _e4439)) / (((_e4437 * _e4437) + (_e4438 * _e4438)) + (_e4439 * _e4439)));
                                        if (_e4552 > f64(0f)) {
                                            if (_e4552 < f64(1f)) {
                                                phi_3341_ = _e4552;
                                            } else {
                                                phi_3341_ = f64(1f);
                                            }
                                            let _e4560 = phi_3341_;
                                            phi_3343_ = _e4560;
                                        } else {
                                            phi_3343_ = f64(0f);
                                        }
                                        let _e4562 = phi_3343_;
                                        let _e4579 = ((((_e4416 * _e4458) + (_e4417 * _e4459)) + (_e4418 * _e4460)) / (((_e4458 * _e4458) + (_e4459 * _e4459)) + (_e4460 * _e4460)));
                                        if (_e4579 > f64(0f)) {
                                            if (_e4579 < f64(1f)) {
                                                phi_3373_ = _e4579;
                                            } else {
                                                phi_3373_ = f64(1f);
                                            }
                                            let _e4587 = phi_3373_;
                                            phi_3375_ = _e4587;
                                        } else {
                                            phi_3375_ = f64(0f);
                                        }
                                        let _e4589 = phi_3375_;
                                        let _e4606 = ((((_e4539 * _e4458) + (_e4540 * _e4459)) + (_e4541 * _e4460)) / (((_e4458 * _e4458) + (_e4459 * _e4459)) + (_e4460 * _e4460)));
                                        if (_e4606 > f64(0f)) {
                                            if (_e4606 < f64(1f)) {
                                                phi_3405_ = _e4606;
                                            } else {
                                                phi_3405_ = f64(1f);
                                            }
                                            let _e4614 = phi_3405_;
                                            phi_3407_ = _e4614;
                                        } else {
                                            phi_3407_ = f64(0f);
                                        }
                                        let _e4616 = phi_3407_;
                                        let _e4623 = (_e4416 - _e4458);
                                        let _e4624 = (_e4417 - _e4459);
                                        let _e4625 = (_e4418 - _e4460);
                                        let _e4636 = ((((_e4623 * _e4437) + (_e4624 * _e4438)) + (_e4625 * _e4439)) / (((_e4437 * _e4437) + (_e4438 * _e4438)) + (_e4439 * _e4439)));
                                        if (_e4636 > f64(0f)) {
                                            if (_e4636 < f64(1f)) {
                                                phi_3440_ = _e4636;
                                            } else {
                                                phi_3440_ = f64(1f);
                                            }
                                            let _e4644 = phi_3440_;
                                            phi_3442_ = _e4644;
                                        } else {
                                            phi_3442_ = f64(0f);
                                        }
                                        let _e4646 = phi_3442_;
                                        local_10[0u] = array<f64, 3>((_e4416 - (_e4437 * _e4562)), (_e4417 - (_e4438 * _e4562)), (_e4418 - (_e4439 * _e4562)));
                                        local_10[1u] = array<f64, 3>((_e4416 - (_e4458 * _e4589)), (_e4417 - (_e4459 * _e4589)), (_e4418 - (_e4460 * _e4589)));
                                        local_10[2u] = array<f64, 3>((_e4539 - (_e4458 * _e4616)), (_e4540 - (_e4459 * _e4616)), (_e4541 - (_e4460 * _e4616)));
                                        local_10[3u] = array<f64, 3>((_e4623 - (_e4437 * _e4646)), (_e4624 - (_e4438 * _e4646)), (_e4625 - (_e4439 * _e4646)));
                                        let _e4662 = local_10[0u];
                                        phi_3597_ = type_29(1u, 4u);
                                        phi_3600_ = array<f64, 3>(_e4662[0], _e4662[1], _e4662[2]);
                                        loop {
                                            let _e4668 = phi_3597_;
                                            let _e4670 = phi_3600_;
                                            local_89 = _e4670;
                                            if (_e4668.member < _e4668.member_1) {
                                                phi_3598_ = type_29((_e4668.member + 1u), _e4668.member_1);
                                                phi_3623_ = type_29(1u, _e4668.member);
                                            } else {
                                                phi_3598_ = _e4668;
                                                phi_3623_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e4684 = phi_3598_;
                                            let _e4686 = phi_3623_;
                                            let _e4690 = (bitcast<i32>(_e4686.member) != 0i);
                                            if _e4690 {
                                                if (_e4686.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4693 = local_10[_e4686.member_1];
                                                if (_e4686.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4699 = local_10[_e4686.member_1];
                                                if ((((_e4693[0] * _e4699[0]) + (_e4693[1] * _e4699[1])) + (_e4693[2] * _e4699[2])) < (((_e4670[0] * _e4670[0]) + (_e4670[1] * _e4670[1])) + (_e4670[2] * _e4670[2]))) {
                                                    if (_e4686.member_1 < 4u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e4722 = local_10[_e4686.member_1];
                                                    phi_3690_ = array<f64, 3>(_e4722[0], _e4722[1], _e4722[2]);
                                                } else {
                                                    phi_3690_ = _e4670;
                                                }
                                                let _e4728 = phi_3690_;
                                                phi_3601_ = _e4728;
                                            } else {
                                                phi_3601_ = array<f64, 3>();
                                            }
                                            let _e4730 = phi_3601_;
                                            continue;
                                            continuing {
                                                phi_3597_ = _e4684;
                                                phi_3600_ = _e4730;
                                                break if !(_e4690);
                                            }
                                        }
                                        let _e5924 = local_89;
                                        phi_3691_ = _e5924;
                                    } else {
                                        phi_3691_ = _e4536;
                                    }
                                    let _e4733 = phi_3691_;
                                    let _e4744 = (((_e4733[0] * _e4733[0]) + (_e4733[1] * _e4733[1])) + (_e4733[2] * _e4733[2]));
                                    if (_e4744 <= 2.2250738585072014e-308lf) {
                                        if (_e4744 > 0.0lf) {
                                            phi_3716_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3716_ = 0.0lf;
                                        }
                                        let _e4802 = phi_3716_;
                                        phi_3780_ = _e4802;
                                    } else {
                                        phi_3723_ = type_27(0i, 5i);
                                        phi_3726_ = bitcast<f64>(((bitcast<u64>(_e4744) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e4751 = phi_3723_;
                                            let _e4753 = phi_3726_;
                                            local_49 = _e4753;
                                            if (_e4751.member < _e4751.member_1) {
                                                let _e4761 = (_e4751.member + 1i);
                                                if ((false == (_e4761 > _e4751.member)) != false) {
                                                    phi_3747_ = true;
                                                } else {
                                                    phi_3747_ = false;
                                                }
                                                let _e4766 = phi_3747_;
                                                if _e4766 {
                                                    phi_3753_ = type_28(0u, type_28().member_1);
                                                } else {
                                                    phi_3753_ = type_28(1u, _e4761);
                                                }
                                                let _e4772 = phi_3753_;
                                                if (bitcast<i32>(_e4772.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3724_ = type_27(_e4772.member_1, _e4751.member_1);
                                                phi_3767_ = type_28(1u, _e4751.member);
                                            } else {
                                                phi_3724_ = _e4751;
                                                phi_3767_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4782 = phi_3724_;
                                            let _e4784 = phi_3767_;
                                            let _e4787 = (bitcast<i32>(_e4784.member) != 0i);
                                            if _e4787 {
                                                phi_3727_ = (0.5lf * (_e4753 + (_e4744 / _e4753)));
                                            } else {
                                                phi_3727_ = f64();
                                            }
                                            let _e4792 = phi_3727_;
                                            continue;
                                            continuing {
                                                phi_3723_ = _e4782;
                                                phi_3726_ = _e4792;
                                                break if !(_e4787);
                                            }
                                        }
                                        let _e4797 = local_49;
                                        phi_3780_ = (_e4797 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e4804 = phi_3780_;
                                    let _e4812 = local_20.member[0u];
                                    if (_e4812[0] < 0.0lf) {
                                        phi_3798_ = -(_e4812[0]);
                                    } else {
                                        phi_3798_ = _e4812[0];
                                    }
                                    let _e4819 = phi_3798_;
                                    if (_e4812[1] < 0.0lf) {
                                        phi_3805_ = -(_e4812[1]);
                                    } else {
                                        phi_3805_ = _e4812[1];
                                    }
                                    let _e4823 = phi_3805_;
                                    if (_e4819 > _e4823) {
                                        phi_3810_ = _e4819;
                                    } else {
                                        phi_3810_ = _e4823;
                                    }
                                    let _e4826 = phi_3810_;
                                    if (_e4812[2] < 0.0lf) {
                                        phi_3817_ = -(_e4812[2]);
                                    } else {
                                        phi_3817_ = _e4812[2];
                                    }
                                    let _e4830 = phi_3817_;
                                    if (_e4826 > _e4830) {
                                        phi_3822_ = _e4826;
                                    } else {
                                        phi_3822_ = _e4830;
                                    }
                                    let _e4833 = phi_3822_;
                                    let _e4836 = local_20.member[1u];
                                    if (_e4836[0] < 0.0lf) {
                                        phi_3835_ = -(_e4836[0]);
                                    } else {
                                        phi_3835_ = _e4836[0];
                                    }
                                    let _e4843 = phi_3835_;
                                    if (_e4836[1] < 0.0lf) {
                                        phi_3842_ = -(_e4836[1]);
                                    } else {
                                        phi_3842_ = _e4836[1];
                                    }
                                    let _e4847 = phi_3842_;
                                    if (_e4843 > _e4847) {
                                        phi_3847_ = _e4843;
                                    } else {
                                        phi_3847_ = _e4847;
                                    }
                                    let _e4850 = phi_3847_;
                                    if (_e4836[2] < 0.0lf) {
                                        phi_3854_ = -(_e4836[2]);
                                    } else {
                                        phi_3854_ = _e4836[2];
                                    }
                                    let _e4854 = phi_3854_;
                                    if (_e4850 > _e4854) {
                                        phi_3859_ = _e4850;
                                    } else {
                                        phi_3859_ = _e4854;
                                    }
                                    let _e4857 = phi_3859_;
                                    if (_e4833 > _e4857) {
                                        phi_3864_ = _e4833;
                                    } else {
                                        phi_3864_ = _e4857;
                                    }
                                    let _e4860 = phi_3864_;
                                    let _e4862 = local_20.member_3;
                                    let _e4866 = local_20.member_1[0u];
                                    if (_e4866[0] < 0.0lf) {
                                        phi_3881_ = -(_e4866[0]);
                                    } else {
                                        phi_3881_ = _e4866[0];
                                    }
                                    let _e4873 = phi_3881_;
                                    if (_e4866[1] < 0.0lf) {
                                        phi_3888_ = -(_e4866[1]);
                                    } else {
                                        phi_3888_ = _e4866[1];
                                    }
                                    let _e4877 = phi_3888_;
                                    if (_e4873 > _e4877) {
                                        phi_3893_ = _e4873;
                                    } else {
                                        phi_3893_ = _e4877;
                                    }
                                    let _e4880 = phi_3893_;
                                    if (_e4866[2] < 0.0lf) {
                                        phi_3900_ = -(_e4866[2]);
                                    } else {
                                        phi_3900_ = _e4866[2];
                                    }
                                    let _e4884 = phi_3900_;
                                    if (_e4880 > _e4884) {
                                        phi_3905_ = _e4880;
                                    } else {
                                        phi_3905_ = _e4884;
                                    }
                                    let _e4887 = phi_3905_;
                                    let _e4890 = local_20.member_1[1u];
                                    if (_e4890[0] < 0.0lf) {
                                        phi_3919_ = -(_e4890[0]);
                                    } else {
                                        phi_3919_ = _e4890[0];
                                    }
                                    let _e4897 = phi_3919_;
                                    if (_e4890[1] < 0.0lf) {
                                        phi_3926_ = -(_e4890[1]);
                                    } else {
                                        phi_3926_ = _e4890[1];
                                    }
                                    let _e4901 = phi_3926_;
                                    if (_e4897 > _e4901) {
                                        phi_3931_ = _e4897;
                                    } else {
                                        phi_3931_ = _e4901;
                                    }
                                    let _e4904 = phi_3931_;
                                    if (_e4890[2] < 0.0lf) {
                                        phi_3938_ = -(_e4890[2]);
                                    } else {
                                        phi_3938_ = _e4890[2];
                                    }
                                    let _e4908 = phi_3938_;
                                    if (_e4904 > _e4908) {
                                        phi_3943_ = _e4904;
                                    } else {
                                        phi_3943_ = _e4908;
                                    }
                                    let _e4911 = phi_3943_;
                                    if (_e4887 > _e4911) {
                                        phi_3948_ = _e4887;
                                    } else {
                                        phi_3948_ = _e4911;
                                    }
                                    let _e4914 = phi_3948_;
                                    let _e4916 = local_20.member_3;
                                    let _e4920 = local_20.member_2[0u];
                                    if (_e4920[0] < 0.0lf) {
                                        phi_3965_ = -(_e4920[0]);
                                    } else {
                                        phi_3965_ = _e4920[0];
                                    }
                                    let _e4927 = phi_3965_;
                                    if (_e4920[1] < 0.0lf) {
                                        phi_3972_ = -(_e4920[1]);
                                    } else {
                                        phi_3972_ = _e4920[1];
                                    }
                                    let _e4931 = phi_3972_;
                                    if (_e4927 > _e4931) {
                                        phi_3977_ = _e4927;
                                    } else {
                                        phi_3977_ = _e4931;
                                    }
                                    let _e4934 = phi_3977_;
                                    if (_e4920[2] < 0.0lf) {
                                        phi_3984_ = -(_e4920[2]);
                                    } else {
                                        phi_3984_ = _e4920[2];
                                    }
                                    let _e4938 = phi_3984_;
                                    if (_e4934 > _e4938) {
                                        phi_3989_ = _e4934;
                                    } else {
                                        phi_3989_ = _e4938;
                                    }
                                    let _e4941 = phi_3989_;
                                    let _e4944 = local_20.member_2[1u];
                                    if (_e4944[0] < 0.0lf) {
                                        phi_4003_ = -(_e4944[0]);
                                    } else {
                                        phi_4003_ = _e4944[0];
                                    }
                                    let _e4951 = phi_4003_;
                                    if (_e4944[1] < 0.0lf) {
                                        phi_4010_ = -(_e4944[1]);
                                    } else {
                                        phi_4010_ = _e4944[1];
                                    }
                                    let _e4955 = phi_4010_;
                                    if (_e4951 > _e4955) {
                                        phi_4015_ = _e4951;
                                    } else {
                                        phi_4015_ = _e4955;
                                    }
                                    let _e4958 = phi_4015_;
                                    if (_e4944[2] < 0.0lf) {
                                        phi_4022_ = -(_e4944[2]);
                                    } else {
                                        phi_4022_ = _e4944[2];
                                    }
                                    let _e4962 = phi_4022_;
                                    if (_e4958 > _e4962) {
                                        phi_4027_ = _e4958;
                                    } else {
                                        phi_4027_ = _e4962;
                                    }
                                    let _e4965 = phi_4027_;
                                    if (_e4941 > _e4965) {
                                        phi_4032_ = _e4941;
                                    } else {
                                        phi_4032_ = _e4965;
                                    }
                                    let _e4968 = phi_4032_;
                                    let _e4970 = local_20.member_3;
                                    let _e4978 = local_20.member_3;
                                    let _e4988 = (((_e4804 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e4860 + _e4862) + (_e4914 + _e4916)) + (_e4968 + _e4970)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4978 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e450);
                                    if _e4988 {
                                        phi_4056_ = false;
                                    } else {
                                        phi_4056_ = true;
                                    }
                                    let _e4990 = phi_4056_;
                                    phi_4057_ = _e4990;
                                    phi_4058_ = _e4988;
                                } else {
                                    phi_4057_ = false;
                                    phi_4058_ = false;
                                }
                                let _e4992 = phi_4057_;
                                let _e4994 = phi_4058_;
                                local_50 = _e4994;
                                continue;
                                continuing {
                                    phi_3061_ = _e4383;
                                    break if !(_e4992);
                                }
                            }
                            let _e4997 = local_50;
                            if _e4997 {
                                phi_4063_ = type_72(1u, _e4356.member_1);
                                phi_4064_ = false;
                            } else {
                                phi_4063_ = type_72();
                                phi_4064_ = true;
                            }
                            let _e5000 = phi_4063_;
                            let _e5002 = phi_4064_;
                            if _e5002 {
                                phi_4069_ = type_72(2u, _e4356.member_1);
                                phi_4070_ = false;
                            } else {
                                phi_4069_ = type_72();
                                phi_4070_ = true;
                            }
                            let _e5005 = phi_4069_;
                            let _e5007 = phi_4070_;
                            phi_4072_ = _e5005;
                            phi_4073_ = _e5000;
                            phi_4074_ = _e5007;
                        } else {
                            phi_4072_ = type_72();
                            phi_4073_ = type_72(0u, type_72().member_1);
                            phi_4074_ = true;
                        }
                        let _e5009 = phi_4072_;
                        let _e5011 = phi_4073_;
                        let _e5013 = phi_4074_;
                        if _e5013 {
                            phi_4078_ = _e5011;
                        } else {
                            phi_4078_ = _e5009;
                        }
                        let _e5015 = phi_4078_;
                        phi_7449_ = _e5015;
                    } else {
                        if (_e549 < 0.0lf) {
                            phi_4089_ = -(_e549);
                        } else {
                            phi_4089_ = _e549;
                        }
                        let _e904 = phi_4089_;
                        if (_e572 < 0.0lf) {
                            phi_4095_ = -(_e572);
                        } else {
                            phi_4095_ = _e572;
                        }
                        let _e908 = phi_4095_;
                        if (_e904 > _e908) {
                            phi_4100_ = _e904;
                        } else {
                            phi_4100_ = _e908;
                        }
                        let _e911 = phi_4100_;
                        if (_e595 < 0.0lf) {
                            phi_4106_ = -(_e595);
                        } else {
                            phi_4106_ = _e595;
                        }
                        let _e915 = phi_4106_;
                        if (_e606 < 0.0lf) {
                            phi_4112_ = -(_e606);
                        } else {
                            phi_4112_ = _e606;
                        }
                        let _e919 = phi_4112_;
                        if (_e915 > _e919) {
                            phi_4117_ = _e915;
                        } else {
                            phi_4117_ = _e919;
                        }
                        let _e922 = phi_4117_;
                        if (_e911 > _e922) {
                            phi_4122_ = _e911;
                        } else {
                            phi_4122_ = _e922;
                        }
                        let _e925 = phi_4122_;
                        let _e927 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e928 = f64(1f);
                        if (_e925 >= _e927) {
                            phi_4132_ = (_e925 <= (_e928 / _e927));
                        } else {
                            phi_4132_ = false;
                        }
                        let _e933 = phi_4132_;
                        if _e933 {
                            phi_4139_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_4139_ = f64(2f);
                        }
                        let _e938 = phi_4139_;
                        let _e940 = ((_e865 * f64(0.34f)) + (_e925 * _e938));
                        if _e933 {
                            phi_4147_ = (_e928 / _e925);
                        } else {
                            phi_4147_ = f64(0f);
                        }
                        let _e944 = phi_4147_;
                        let _e945 = f64(0f);
                        let _e946 = f64(1f);
                        let _e947 = f64(3f);
                        let _e953 = ((_e572 - (_e947 * _e549)) * _e944);
                        let _e954 = ((_e595 - _e572) * _e944);
                        let _e955 = (((_e947 * _e606) - _e595) * _e944);
                        local_7[0u] = _e945;
                        local_7[1u] = _e946;
                        local_7[2u] = _e946;
                        local_7[3u] = _e946;
                        let _e962 = ((_e954 * _e954) - (_e953 * _e955));
                        if (_e962 > _e945) {
                            if (_e962 <= 2.2250738585072014e-308lf) {
                                if (_e962 > 0.0lf) {
                                    phi_4183_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4183_ = 0.0lf;
                                }
                                let _e1021 = phi_4183_;
                                phi_4247_ = _e1021;
                            } else {
                                phi_4190_ = type_27(0i, 5i);
                                phi_4193_ = bitcast<f64>(((bitcast<u64>(_e962) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e970 = phi_4190_;
                                    let _e972 = phi_4193_;
                                    local_21 = _e972;
                                    if (_e970.member < _e970.member_1) {
                                        let _e980 = (_e970.member + 1i);
                                        if ((false == (_e980 > _e970.member)) != false) {
                                            phi_4214_ = true;
                                        } else {
                                            phi_4214_ = false;
                                        }
                                        let _e985 = phi_4214_;
                                        if _e985 {
                                            phi_4220_ = type_28(0u, type_28().member_1);
                                        } else {
                                            phi_4220_ = type_28(1u, _e980);
                                        }
                                        let _e991 = phi_4220_;
                                        if (bitcast<i32>(_e991.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_4191_ = type_27(_e991.member_1, _e970.member_1);
                                        phi_4234_ = type_28(1u, _e970.member);
                                    } else {
                                        phi_4191_ = _e970;
                                        phi_4234_ = type_28(0u, type_28().member_1);
                                    }
                                    let _e1001 = phi_4191_;
                                    let _e1003 = phi_4234_;
                                    let _e1006 = (bitcast<i32>(_e1003.member) != 0i);
                                    if _e1006 {
                                        phi_4194_ = (0.5lf * (_e972 + (_e962 / _e972)));
                                    } else {
                                        phi_4194_ = f64();
                                    }
                                    let _e1011 = phi_4194_;
                                    continue;
                                    continuing {
                                        phi_4190_ = _e1001;
                                        phi_4193_ = _e1011;
                                        break if !(_e1006);
                                    }
                                }
                                let _e1016 = local_21;
                                phi_4247_ = (_e1016 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1023 = phi_4247_;
                            if (_e954 < _e945) {
                                phi_4253_ = -(_e1023);
                            } else {
                                phi_4253_ = _e1023;
                            }
                            let _e1027 = phi_4253_;
                            let _e1029 = -((_e954 + _e1027));
                            local_8[0u] = (_e1029 / (_e1029 + _e955));
                            local_8[1u] = (_e953 / (_e953 + _e1029));
                            let _e1038 = local_8[1u];
                            let _e1039 = local_8[0u];
                            if (_e1038 < _e1039) {
                                let _e1042 = local_8[1u];
                                let _e1044 = local_8[0u];
                                local_8[0u] = _e1042;
                                local_8[1u] = _e1044;
                            }
                            phi_4278_ = type_29(0u, 2u);
                            phi_4281_ = 1u;
                            loop {
                                let _e1048 = phi_4278_;
                                let _e1050 = phi_4281_;
                                local_51 = _e1050;
                                if (_e1048.member < _e1048.member_1) {
                                    phi_4279_ = type_29((_e1048.member + 1u), _e1048.member_1);
                                    phi_4304_ = type_29(1u, _e1048.member);
                                } else {
                                    phi_4279_ = _e1048;
                                    phi_4304_ = type_29(0u, type_29().member_1);
                                }
                                let _e1064 = phi_4279_;
                                let _e1066 = phi_4304_;
                                let _e1070 = (bitcast<i32>(_e1066.member) != 0i);
                                if _e1070 {
                                    if (_e1066.member_1 < 2u) {
                                    } else {
                                        return;
                                    }
                                    let _e1073 = local_8[_e1066.member_1];
                                    if (_e1073 > _e945) {
                                        if (_e1066.member_1 < 2u) {
                                        } else {
                                            return;
                                        }
                                        let _e1077 = local_8[_e1066.member_1];
                                        if (_e1077 < _e946) {
                                            if (_e1066.member_1 < 2u) {
                                            } else {
                                                return;
                                            }
                                            let _e1081 = local_8[_e1066.member_1];
                                            if (_e1050 < 4u) {
                                            } else {
                                                return;
                                            }
                                            local_7[_e1050] = _e1081;
                                            phi_4348_ = (_e1050 + 1u);
                                        } else {
                                            phi_4348_ = _e1050;
                                        }
                                        let _e1086 = phi_4348_;
                                        phi_4349_ = _e1086;
                                    } else {
                                        phi_4349_ = _e1050;
                                    }
                                    let _e1088 = phi_4349_;
                                    phi_4282_ = _e1088;
                                } else {
                                    phi_4282_ = u32();
                                }
                                let _e1090 = phi_4282_;
                                continue;
                                continuing {
                                    phi_4278_ = _e1064;
                                    phi_4281_ = _e1090;
                                    break if !(_e1070);
                                }
                            }
                            let _e5202 = local_51;
                            phi_4350_ = _e5202;
                        } else {
                            phi_4350_ = 1u;
                        }
                        let _e1093 = phi_4350_;
                        if (_e1093 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e1093] = _e946;
                        let _e1096 = local_7;
                        local_9 = _e1096;
                        phi_4370_ = type_29(0u, _e1093);
                        loop {
                            let _e1099 = phi_4370_;
                            if (_e1099.member < _e1099.member_1) {
                                phi_4371_ = type_29((_e1099.member + 1u), _e1099.member_1);
                                phi_4394_ = type_29(1u, _e1099.member);
                            } else {
                                phi_4371_ = _e1099;
                                phi_4394_ = type_29(0u, type_29().member_1);
                            }
                            let _e1113 = phi_4371_;
                            let _e1115 = phi_4394_;
                            if (bitcast<i32>(_e1115.member) != 0i) {
                                if (_e1115.member_1 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1122 = local_9[_e1115.member_1];
                                let _e1123 = (_e1115.member_1 + 1u);
                                if (_e1123 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1126 = local_9[_e1123];
                                let _e1128 = (f64(1f) - _e1122);
                                let _e1139 = ((((_e549 * _e1128) + (_e572 * _e1122)) * (_e1128 * _e1128)) + (((_e595 * _e1128) + (_e606 * _e1122)) * (_e1122 * _e1122)));
                                let _e1141 = (f64(1f) - _e1126);
                                let _e1152 = ((((_e549 * _e1141) + (_e572 * _e1126)) * (_e1141 * _e1141)) + (((_e595 * _e1141) + (_e606 * _e1126)) * (_e1126 * _e1126)));
                                if (_e1139 < 0.0lf) {
                                    phi_4448_ = -(_e1139);
                                } else {
                                    phi_4448_ = _e1139;
                                }
                                let _e1156 = phi_4448_;
                                let _e1157 = (_e1156 > _e940);
                                if (_e1152 < 0.0lf) {
                                    phi_4455_ = -(_e1152);
                                } else {
                                    phi_4455_ = _e1152;
                                }
                                let _e1161 = phi_4455_;
                                let _e1162 = (_e1161 > _e940);
                                let _e1163 = f64(0f);
                                if _e1157 {
                                    if _e1162 {
                                        phi_4467_ = ((_e1139 > _e1163) != (_e1152 > _e1163));
                                        phi_4468_ = false;
                                    } else {
                                        phi_4467_ = bool();
                                        phi_4468_ = true;
                                    }
                                    let _e1168 = phi_4467_;
                                    let _e1170 = phi_4468_;
                                    phi_4469_ = _e1168;
                                    phi_4470_ = _e1170;
                                } else {
                                    phi_4469_ = bool();
                                    phi_4470_ = true;
                                }
                                let _e1172 = phi_4469_;
                                let _e1174 = phi_4470_;
                                if _e1174 {
                                    phi_4474_ = false;
                                } else {
                                    phi_4474_ = _e1172;
                                }
                                let _e1176 = phi_4474_;
                                if _e1157 {
                                    if _e1162 {
                                        if _e1176 {
                                            phi_4486_ = type_73();
                                        } else {
                                            phi_4486_ = type_73(f64(1f), _e1163, _e1176);
                                        }
                                        let _e1180 = phi_4486_;
                                        phi_4487_ = _e1180;
                                        phi_4488_ = _e1176;
                                    } else {
                                        phi_4487_ = type_73();
                                        phi_4488_ = true;
                                    }
                                    let _e1182 = phi_4487_;
                                    let _e1184 = phi_4488_;
                                    phi_4489_ = _e1182;
                                    phi_4490_ = _e1184;
                                } else {
                                    phi_4489_ = type_73();
                                    phi_4490_ = true;
                                }
                                let _e1186 = phi_4489_;
                                let _e1188 = phi_4490_;
                                if _e1188 {
                                    if _e1157 {
                                        if (_e1139 < _e1163) {
                                            phi_4503_ = f64(-1f);
                                        } else {
                                            phi_4503_ = f64(1f);
                                        }
                                        let _e1193 = phi_4503_;
                                        let _e1194 = f64(0.00000000000022737368f);
                                        let _e1195 = f64(0.5f);
                                        let _e1196 = f64(3f);
                                        let _e1199 = (_e595 - _e572);
                                        phi_4516_ = type_29(0u, 64u);
                                        phi_4519_ = _e1126;
                                        phi_4521_ = _e1122;
                                        phi_4523_ = (_e1195 * (_e1122 + _e1126));
                                        loop {
                                            let _e1205 = phi_4516_;
                                            let _e1207 = phi_4519_;
                                            let _e1209 = phi_4521_;
                                            let _e1211 = phi_4523_;
                                            local_53 = _e1209;
                                            if (_e1205.member < _e1205.member_1) {
                                                phi_4517_ = type_29((_e1205.member + 1u), _e1205.member_1);
                                                phi_4546_ = type_29(1u, _e1205.member);
                                            } else {
                                                phi_4517_ = _e1205;
                                                phi_4546_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1225 = phi_4517_;
                                            let _e1227 = phi_4546_;
                                            if (bitcast<i32>(_e1227.member) != 0i) {
                                                let _e1232 = (f64(1f) - _e1211);
                                                let _e1245 = ((_e1193 * ((((_e549 * _e1232) + (_e572 * _e1211)) * (_e1232 * _e1232)) + (((_e595 * _e1232) + (_e606 * _e1211)) * (_e1211 * _e1211)))) - _e940);
                                                if (_e1245 > f64(0f)) {
                                                    phi_4573_ = _e1207;
                                                    phi_4574_ = _e1211;
                                                } else {
                                                    phi_4573_ = _e1211;
                                                    phi_4574_ = _e1209;
                                                }
                                                let _e1249 = phi_4573_;
                                                let _e1251 = phi_4574_;
                                                let _e1253 = ((_e1249 - _e1251) > _e1194);
                                                if _e1253 {
                                                    let _e1255 = (f64(1f) - _e1211);
                                                    let _e1267 = (-(_e1245) / (_e1193 * (((((_e572 - (_e1196 * _e549)) * _e1255) + (_e1199 * _e1211)) * _e1255) + (((_e1199 * _e1255) + (((_e1196 * _e606) - _e595) * _e1211)) * _e1211))));
                                                    if (_e1245 > f64(0f)) {
                                                        phi_4602_ = (_e1195 * _e1194);
                                                    } else {
                                                        phi_4602_ = -((_e1195 * _e1194));
                                                    }
                                                    let _e1274 = phi_4602_;
                                                    let _e1276 = ((_e1211 + _e1267) + _e1274);
                                                    if (_e1276 > _e1251) {
                                                        if (_e1276 < _e1249) {
                                                            if (_e1267 < 0.0lf) {
                                                                phi_4618_ = -(_e1267);
                                                            } else {
                                                                phi_4618_ = _e1267;
                                                            }
                                                            let _e1282 = phi_4618_;
                                                            if (_e1282 < (_e1195 * (_e1249 - _e1251))) {
                                                                phi_4625_ = false;
                                                            } else {
                                                                phi_4625_ = true;
                                                            }
                                                            let _e1287 = phi_4625_;
                                                            phi_4626_ = _e1287;
                                                        } else {
                                                            phi_4626_ = true;
                                                        }
                                                        let _e1289 = phi_4626_;
                                                        phi_4627_ = _e1289;
                                                    } else {
                                                        phi_4627_ = true;
                                                    }
                                                    let _e1291 = phi_4627_;
                                                    if _e1291 {
                                                        phi_4633_ = (_e1195 * (_e1251 + _e1249));
                                                    } else {
                                                        phi_4633_ = _e1276;
                                                    }
                                                    let _e1295 = phi_4633_;
                                                    phi_4634_ = _e1295;
                                                    phi_4635_ = false;
                                                } else {
                                                    phi_4634_ = f64();
                                                    phi_4635_ = true;
                                                }
                                                let _e1297 = phi_4634_;
                                                let _e1299 = phi_4635_;
                                                phi_4520_ = _e1249;
                                                phi_4522_ = _e1251;
                                                phi_4524_ = _e1297;
                                                phi_4636_ = _e1251;
                                                phi_4637_ = _e1253;
                                                phi_4638_ = _e1299;
                                            } else {
                                                phi_4520_ = f64();
                                                phi_4522_ = f64();
                                                phi_4524_ = f64();
                                                phi_4636_ = f64();
                                                phi_4637_ = false;
                                                phi_4638_ = false;
                                            }
                                            let _e1301 = phi_4520_;
                                            let _e1303 = phi_4522_;
                                            let _e1305 = phi_4524_;
                                            let _e1307 = phi_4636_;
                                            let _e1309 = phi_4637_;
                                            let _e1311 = phi_4638_;
                                            local_22 = _e1311;
                                            local_52 = _e1307;
                                            continue;
                                            continuing {
                                                phi_4516_ = _e1225;
                                                phi_4519_ = _e1301;
                                                phi_4521_ = _e1303;
                                                phi_4523_ = _e1305;
                                                break if !(_e1309);
                                            }
                                        }
                                        let _e1314 = local_22;
                                        if _e1314 {
                                            let _e5244 = local_52;
                                            phi_4642_ = _e5244;
                                        } else {
                                            let _e5246 = local_53;
                                            phi_4642_ = _e5246;
                                        }
                                        let _e1316 = phi_4642_;
                                        phi_4643_ = _e1316;
                                    } else {
                                        phi_4643_ = _e1122;
                                    }
                                    let _e1318 = phi_4643_;
                                    if _e1162 {
                                        phi_4651_ = type_29(0u, 64u);
                                        phi_4654_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1322 = phi_4651_;
                                            let _e1324 = phi_4654_;
                                            if (_e1322.member < _e1322.member_1) {
                                                phi_4652_ = type_29((_e1322.member + 1u), _e1322.member_1);
                                                phi_4677_ = type_29(1u, _e1322.member);
                                            } else {
                                                phi_4652_ = _e1322;
                                                phi_4677_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1338 = phi_4652_;
                                            let _e1340 = phi_4677_;
                                            if (bitcast<i32>(_e1340.member) != 0i) {
                                                let _e1344 = (_e1318 + _e1324);
                                                if (_e1344 < _e1126) {
                                                    let _e1347 = (f64(1f) - _e1344);
                                                    let _e1358 = ((((_e549 * _e1347) + (_e572 * _e1344)) * (_e1347 * _e1347)) + (((_e595 * _e1347) + (_e606 * _e1344)) * (_e1344 * _e1344)));
                                                    let _e1360 = (f64(1f) - _e1318);
                                                    let _e1371 = ((((_e549 * _e1360) + (_e572 * _e1318)) * (_e1360 * _e1360)) + (((_e595 * _e1360) + (_e606 * _e1318)) * (_e1318 * _e1318)));
                                                    if (_e1358 < 0.0lf) {
                                                        phi_4720_ = -(_e1358);
                                                    } else {
                                                        phi_4720_ = _e1358;
                                                    }
                                                    let _e1375 = phi_4720_;
                                                    if (_e1375 > _e940) {
                                                        if (_e1371 < 0.0lf) {
                                                            phi_4730_ = -(_e1371);
                                                        } else {
                                                            phi_4730_ = _e1371;
                                                        }
                                                        let _e1380 = phi_4730_;
                                                        if (_e1380 > _e940) {
                                                            phi_4740_ = ((_e1358 > f64(0f)) == (_e1371 > f64(0f)));
                                                        } else {
                                                            phi_4740_ = false;
                                                        }
                                                        let _e1388 = phi_4740_;
                                                        phi_4742_ = !(_e1388);
                                                    } else {
                                                        phi_4742_ = false;
                                                    }
                                                    let _e1391 = phi_4742_;
                                                    if _e1391 {
                                                        phi_4747_ = f64();
                                                        phi_4748_ = false;
                                                    } else {
                                                        phi_4747_ = (_e1324 + _e1324);
                                                        phi_4748_ = true;
                                                    }
                                                    let _e1394 = phi_4747_;
                                                    let _e1396 = phi_4748_;
                                                    phi_4749_ = _e1394;
                                                    phi_4750_ = _e1396;
                                                    phi_4751_ = _e1391;
                                                    phi_4752_ = false;
                                                } else {
                                                    phi_4749_ = f64();
                                                    phi_4750_ = false;
                                                    phi_4751_ = false;
                                                    phi_4752_ = true;
                                                }
                                                let _e1398 = phi_4749_;
                                                let _e1400 = phi_4750_;
                                                let _e1402 = phi_4751_;
                                                let _e1404 = phi_4752_;
                                                phi_4753_ = _e1344;
                                                phi_4655_ = _e1398;
                                                phi_4754_ = _e1400;
                                                phi_4755_ = _e1402;
                                                phi_4756_ = _e1404;
                                                phi_4757_ = false;
                                            } else {
                                                phi_4753_ = f64();
                                                phi_4655_ = f64();
                                                phi_4754_ = false;
                                                phi_4755_ = false;
                                                phi_4756_ = false;
                                                phi_4757_ = true;
                                            }
                                            let _e1406 = phi_4753_;
                                            let _e1408 = phi_4655_;
                                            let _e1410 = phi_4754_;
                                            let _e1412 = phi_4755_;
                                            let _e1414 = phi_4756_;
                                            let _e1416 = phi_4757_;
                                            local_23 = _e1412;
                                            local_54 = _e1414;
                                            local_55 = _e1416;
                                            local_56 = _e1406;
                                            continue;
                                            continuing {
                                                phi_4651_ = _e1338;
                                                phi_4654_ = _e1408;
                                                break if !(_e1410);
                                            }
                                        }
                                        let _e1419 = local_23;
                                        if _e1419 {
                                            phi_4761_ = false;
                                            phi_4762_ = false;
                                        } else {
                                            let _e5271 = local_54;
                                            phi_4761_ = _e5271;
                                            let _e5274 = local_55;
                                            phi_4762_ = _e5274;
                                        }
                                        let _e1421 = phi_4761_;
                                        let _e1423 = phi_4762_;
                                        if _e1421 {
                                            phi_4766_ = true;
                                        } else {
                                            phi_4766_ = _e1423;
                                        }
                                        let _e1425 = phi_4766_;
                                        if _e1425 {
                                            phi_4770_ = _e1126;
                                        } else {
                                            let _e5278 = local_56;
                                            phi_4770_ = _e5278;
                                        }
                                        let _e1427 = phi_4770_;
                                        phi_4771_ = _e1427;
                                    } else {
                                        phi_4771_ = _e1126;
                                    }
                                    let _e1429 = phi_4771_;
                                    phi_4773_ = type_73(_e1318, _e1429, _e1176);
                                } else {
                                    phi_4773_ = _e1186;
                                }
                                let _e1432 = phi_4773_;
                                if (_e1432.member > _e1432.member_1) {
                                    phi_7405_ = f64();
                                    phi_7406_ = true;
                                    phi_7407_ = false;
                                    phi_7408_ = false;
                                    phi_7409_ = false;
                                } else {
                                    let _e1440 = ((_e1432.member_1 - _e1432.member) * f64(0.5f));
                                    let _e1441 = (_e1432.member + _e1440);
                                    let _e1444 = (_e1440 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1446 = local_20.member_3;
                                    let _e1449 = local_20.member[0u];
                                    if (_e1449[0] < 0.0lf) {
                                        phi_4804_ = -(_e1449[0]);
                                    } else {
                                        phi_4804_ = _e1449[0];
                                    }
                                    let _e1456 = phi_4804_;
                                    if (_e1449[1] < 0.0lf) {
                                        phi_4811_ = -(_e1449[1]);
                                    } else {
                                        phi_4811_ = _e1449[1];
                                    }
                                    let _e1460 = phi_4811_;
                                    if (_e1456 > _e1460) {
                                        phi_4816_ = _e1456;
                                    } else {
                                        phi_4816_ = _e1460;
                                    }
                                    let _e1463 = phi_4816_;
                                    if (_e1449[2] < 0.0lf) {
                                        phi_4823_ = -(_e1449[2]);
                                    } else {
                                        phi_4823_ = _e1449[2];
                                    }
                                    let _e1467 = phi_4823_;
                                    if (_e1463 > _e1467) {
                                        phi_4828_ = _e1463;
                                    } else {
                                        phi_4828_ = _e1467;
                                    }
                                    let _e1470 = phi_4828_;
                                    let _e1472 = local_20.member[1u];
                                    if (_e1472[0] < 0.0lf) {
                                        phi_4841_ = -(_e1472[0]);
                                    } else {
                                        phi_4841_ = _e1472[0];
                                    }
                                    let _e1479 = phi_4841_;
                                    if (_e1472[1] < 0.0lf) {
                                        phi_4848_ = -(_e1472[1]);
                                    } else {
                                        phi_4848_ = _e1472[1];
                                    }
                                    let _e1483 = phi_4848_;
                                    if (_e1479 > _e1483) {
                                        phi_4853_ = _e1479;
                                    } else {
                                        phi_4853_ = _e1483;
                                    }
                                    let _e1486 = phi_4853_;
                                    if (_e1472[2] < 0.0lf) {
                                        phi_4860_ = -(_e1472[2]);
                                    } else {
                                        phi_4860_ = _e1472[2];
                                    }
                                    let _e1490 = phi_4860_;
                                    if (_e1486 > _e1490) {
                                        phi_4865_ = _e1486;
                                    } else {
                                        phi_4865_ = _e1490;
                                    }
                                    let _e1493 = phi_4865_;
                                    if (_e1470 > _e1493) {
                                        phi_4870_ = _e1470;
                                    } else {
                                        phi_4870_ = _e1493;
                                    }
                                    let _e1496 = phi_4870_;
                                    let _e1499 = local_20.member[0u];
                                    let _e1504 = local_20.member[1u];
                                    let _e1514 = (_e1499[0] + ((_e1504[0] - _e1499[0]) * _e1441));
                                    let _e1515 = (_e1499[1] + ((_e1504[1] - _e1499[1]) * _e1441));
                                    let _e1516 = (_e1499[2] + ((_e1504[2] - _e1499[2]) * _e1441));
                                    let _e1518 = local_20.member[1u];
                                    let _e1523 = local_20.member[0u];
                                    let _e1527 = (_e1518[0] - _e1523[0]);
                                    let _e1528 = (_e1518[1] - _e1523[1]);
                                    let _e1529 = (_e1518[2] - _e1523[2]);
                                    if (_e1527 < 0.0lf) {
                                        phi_4929_ = -(_e1527);
                                    } else {
                                        phi_4929_ = _e1527;
                                    }
                                    let _e1533 = phi_4929_;
                                    if (_e1528 < 0.0lf) {
                                        phi_4935_ = -(_e1528);
                                    } else {
                                        phi_4935_ = _e1528;
                                    }
                                    let _e1537 = phi_4935_;
                                    if (_e1533 > _e1537) {
                                        phi_4940_ = _e1533;
                                    } else {
                                        phi_4940_ = _e1537;
                                    }
                                    let _e1540 = phi_4940_;
                                    if (_e1529 < 0.0lf) {
                                        phi_4946_ = -(_e1529);
                                    } else {
                                        phi_4946_ = _e1529;
                                    }
                                    let _e1544 = phi_4946_;
                                    if (_e1540 > _e1544) {
                                        phi_4951_ = _e1540;
                                    } else {
                                        phi_4951_ = _e1544;
                                    }
                                    let _e1547 = phi_4951_;
                                    let _e1555 = ((((_e1444 * _e1547) * f64(1.01f)) + ((_e1496 + _e1446) * (1.1102230246251565e-16lf * f64(8f)))) + _e1446);
                                    if (_e1514 < 0.0lf) {
                                        phi_4965_ = -(_e1514);
                                    } else {
                                        phi_4965_ = _e1514;
                                    }
                                    let _e1559 = phi_4965_;
                                    if (_e1515 < 0.0lf) {
                                        phi_4971_ = -(_e1515);
                                    } else {
                                        phi_4971_ = _e1515;
                                    }
                                    let _e1563 = phi_4971_;
                                    if (_e1559 > _e1563) {
                                        phi_4976_ = _e1559;
                                    } else {
                                        phi_4976_ = _e1563;
                                    }
                                    let _e1566 = phi_4976_;
                                    if (_e1516 < 0.0lf) {
                                        phi_4982_ = -(_e1516);
                                    } else {
                                        phi_4982_ = _e1516;
                                    }
                                    let _e1570 = phi_4982_;
                                    if (_e1566 > _e1570) {
                                        phi_4987_ = _e1566;
                                    } else {
                                        phi_4987_ = _e1570;
                                    }
                                    let _e1573 = phi_4987_;
                                    local_3 = type_59(array<f64, 3>(_e1514, _e1515, _e1516), _e1555, (_e1573 + _e1555));
                                    let _e1579 = local_20.member_3;
                                    let _e1581 = local_20.member_1[0u];
                                    if (_e1581[0] < 0.0lf) {
                                        phi_5013_ = -(_e1581[0]);
                                    } else {
                                        phi_5013_ = _e1581[0];
                                    }
                                    let _e1588 = phi_5013_;
                                    if (_e1581[1] < 0.0lf) {
                                        phi_5020_ = -(_e1581[1]);
                                    } else {
                                        phi_5020_ = _e1581[1];
                                    }
                                    let _e1592 = phi_5020_;
                                    if (_e1588 > _e1592) {
                                        phi_5025_ = _e1588;
                                    } else {
                                        phi_5025_ = _e1592;
                                    }
                                    let _e1595 = phi_5025_;
                                    if (_e1581[2] < 0.0lf) {
                                        phi_5032_ = -(_e1581[2]);
                                    } else {
                                        phi_5032_ = _e1581[2];
                                    }
                                    let _e1599 = phi_5032_;
                                    if (_e1595 > _e1599) {
                                        phi_5037_ = _e1595;
                                    } else {
                                        phi_5037_ = _e1599;
                                    }
                                    let _e1602 = phi_5037_;
                                    let _e1604 = local_20.member_1[1u];
                                    if (_e1604[0] < 0.0lf) {
                                        phi_5050_ = -(_e1604[0]);
                                    } else {
                                        phi_5050_ = _e1604[0];
                                    }
                                    let _e1611 = phi_5050_;
                                    if (_e1604[1] < 0.0lf) {
                                        phi_5057_ = -(_e1604[1]);
                                    } else {
                                        phi_5057_ = _e1604[1];
                                    }
                                    let _e1615 = phi_5057_;
                                    if (_e1611 > _e1615) {
                                        phi_5062_ = _e1611;
                                    } else {
                                        phi_5062_ = _e1615;
                                    }
                                    let _e1618 = phi_5062_;
                                    if (_e1604[2] < 0.0lf) {
                                        phi_5069_ = -(_e1604[2]);
                                    } else {
                                        phi_5069_ = _e1604[2];
                                    }
                                    let _e1622 = phi_5069_;
                                    if (_e1618 > _e1622) {
                                        phi_5074_ = _e1618;
                                    } else {
                                        phi_5074_ = _e1622;
                                    }
                                    let _e1625 = phi_5074_;
                                    if (_e1602 > _e1625) {
                                        phi_5079_ = _e1602;
                                    } else {
                                        phi_5079_ = _e1625;
                                    }
                                    let _e1628 = phi_5079_;
                                    let _e1631 = local_20.member_1[0u];
                                    let _e1636 = local_20.member_1[1u];
                                    let _e1646 = (_e1631[0] + ((_e1636[0] - _e1631[0]) * _e1441));
                                    let _e1647 = (_e1631[1] + ((_e1636[1] - _e1631[1]) * _e1441));
                                    let _e1648 = (_e1631[2] + ((_e1636[2] - _e1631[2]) * _e1441));
                                    let _e1650 = local_20.member_1[1u];
                                    let _e1655 = local_20.member_1[0u];
                                    let _e1659 = (_e1650[0] - _e1655[0]);
                                    let _e1660 = (_e1650[1] - _e1655[1]);
                                    let _e1661 = (_e1650[2] - _e1655[2]);
                                    if (_e1659 < 0.0lf) {
                                        phi_5138_ = -(_e1659);
                                    } else {
                                        phi_5138_ = _e1659;
                                    }
                                    let _e1665 = phi_5138_;
                                    if (_e1660 < 0.0lf) {
                                        phi_5144_ = -(_e1660);
                                    } else {
                                        phi_5144_ = _e1660;
                                    }
                                    let _e1669 = phi_5144_;
                                    if (_e1665 > _e1669) {
                                        phi_5149_ = _e1665;
                                    } else {
                                        phi_5149_ = _e1669;
                                    }
                                    let _e1672 = phi_5149_;
                                    if (_e1661 < 0.0lf) {
                                        phi_5155_ = -(_e1661);
                                    } else {
                                        phi_5155_ = _e1661;
                                    }
                                    let _e1676 = phi_5155_;
                                    if (_e1672 > _e1676) {
                                        phi_5160_ = _e1672;
                                    } else {
                                        phi_5160_ = _e1676;
                                    }
                                    let _e1679 = phi_5160_;
                                    let _e1687 = ((((_e1444 * _e1679) * f64(1.01f)) + ((_e1628 + _e1579) * (1.1102230246251565e-16lf * f64(8f)))) + _e1579);
                                    if (_e1646 < 0.0lf) {
                                        phi_5174_ = -(_e1646);
                                    } else {
                                        phi_5174_ = _e1646;
                                    }
                                    let _e1691 = phi_5174_;
                                    if (_e1647 < 0.0lf) {
                                        phi_5180_ = -(_e1647);
                                    } else {
                                        phi_5180_ = _e1647;
                                    }
                                    let _e1695 = phi_5180_;
                                    if (_e1691 > _e1695) {
                                        phi_5185_ = _e1691;
                                    } else {
                                        phi_5185_ = _e1695;
                                    }
                                    let _e1698 = phi_5185_;
                                    if (_e1648 < 0.0lf) {
                                        phi_5191_ = -(_e1648);
                                    } else {
                                        phi_5191_ = _e1648;
                                    }
                                    let _e1702 = phi_5191_;
                                    if (_e1698 > _e1702) {
                                        phi_5196_ = _e1698;
                                    } else {
                                        phi_5196_ = _e1702;
                                    }
                                    let _e1705 = phi_5196_;
                                    local_4 = type_59(array<f64, 3>(_e1646, _e1647, _e1648), _e1687, (_e1705 + _e1687));
                                    let _e1711 = local_20.member_3;
                                    let _e1713 = local_20.member_2[0u];
                                    if (_e1713[0] < 0.0lf) {
                                        phi_5222_ = -(_e1713[0]);
                                    } else {
                                        phi_5222_ = _e1713[0];
                                    }
                                    let _e1720 = phi_5222_;
                                    if (_e1713[1] < 0.0lf) {
                                        phi_5229_ = -(_e1713[1]);
                                    } else {
                                        phi_5229_ = _e1713[1];
                                    }
                                    let _e1724 = phi_5229_;
                                    if (_e1720 > _e1724) {
                                        phi_5234_ = _e1720;
                                    } else {
                                        phi_5234_ = _e1724;
                                    }
                                    let _e1727 = phi_5234_;
                                    if (_e1713[2] < 0.0lf) {
                                        phi_5241_ = -(_e1713[2]);
                                    } else {
                                        phi_5241_ = _e1713[2];
                                    }
                                    let _e1731 = phi_5241_;
                                    if (_e1727 > _e1731) {
                                        phi_5246_ = _e1727;
                                    } else {
                                        phi_5246_ = _e1731;
                                    }
                                    let _e1734 = phi_5246_;
                                    let _e1736 = local_20.member_2[1u];
                                    if (_e1736[0] < 0.0lf) {
                                        phi_5259_ = -(_e1736[0]);
                                    } else {
                                        phi_5259_ = _e1736[0];
                                    }
                                    let _e1743 = phi_5259_;
                                    if (_e1736[1] < 0.0lf) {
                                        phi_5266_ = -(_e1736[1]);
                                    } else {
                                        phi_5266_ = _e1736[1];
                                    }
                                    let _e1747 = phi_5266_;
                                    if (_e1743 > _e1747) {
                                        phi_5271_ = _e1743;
                                    } else {
                                        phi_5271_ = _e1747;
                                    }
                                    let _e1750 = phi_5271_;
                                    if (_e1736[2] < 0.0lf) {
                                        phi_5278_ = -(_e1736[2]);
                                    } else {
                                        phi_5278_ = _e1736[2];
                                    }
                                    let _e1754 = phi_5278_;
                                    if (_e1750 > _e1754) {
                                        phi_5283_ = _e1750;
                                    } else {
                                        phi_5283_ = _e1754;
                                    }
                                    let _e1757 = phi_5283_;
                                    if (_e1734 > _e1757) {
                                        phi_5288_ = _e1734;
                                    } else {
                                        phi_5288_ = _e1757;
                                    }
                                    let _e1760 = phi_5288_;
                                    let _e1763 = local_20.member_2[0u];
                                    let _e1768 = local_20.member_2[1u];
                                    let _e1778 = (_e1763[0] + ((_e1768[0] - _e1763[0]) * _e1441));
                                    let _e1779 = (_e1763[1] + ((_e1768[1] - _e1763[1]) * _e1441));
                                    let _e1780 = (_e1763[2] + ((_e1768[2] - _e1763[2]) * _e1441));
                                    let _e1782 = local_20.member_2[1u];
                                    let _e1787 = local_20.member_2[0u];
                                    let _e1791 = (_e1782[0] - _e1787[0]);
                                    let _e1792 = (_e1782[1] - _e1787[1]);
                                    let _e1793 = (_e1782[2] - _e1787[2]);
                                    if (_e1791 < 0.0lf) {
                                        phi_5347_ = -(_e1791);
                                    } else {
                                        phi_5347_ = _e1791;
                                    }
                                    let _e1797 = phi_5347_;
                                    if (_e1792 < 0.0lf) {
                                        phi_5353_ = -(_e1792);
                                    } else {
                                        phi_5353_ = _e1792;
                                    }
                                    let _e1801 = phi_5353_;
                                    if (_e1797 > _e1801) {
                                        phi_5358_ = _e1797;
                                    } else {
                                        phi_5358_ = _e1801;
                                    }
                                    let _e1804 = phi_5358_;
                                    if (_e1793 < 0.0lf) {
                                        phi_5364_ = -(_e1793);
                                    } else {
                                        phi_5364_ = _e1793;
                                    }
                                    let _e1808 = phi_5364_;
                                    if (_e1804 > _e1808) {
                                        phi_5369_ = _e1804;
                                    } else {
                                        phi_5369_ = _e1808;
                                    }
                                    let _e1811 = phi_5369_;
                                    let _e1819 = ((((_e1444 * _e1811) * f64(1.01f)) + ((_e1760 + _e1711) * (1.1102230246251565e-16lf * f64(8f)))) + _e1711);
                                    if (_e1778 < 0.0lf) {
                                        phi_5383_ = -(_e1778);
                                    } else {
                                        phi_5383_ = _e1778;
                                    }
                                    let _e1823 = phi_5383_;
                                    if (_e1779 < 0.0lf) {
                                        phi_5389_ = -(_e1779);
                                    } else {
                                        phi_5389_ = _e1779;
                                    }
                                    let _e1827 = phi_5389_;
                                    if (_e1823 > _e1827) {
                                        phi_5394_ = _e1823;
                                    } else {
                                        phi_5394_ = _e1827;
                                    }
                                    let _e1830 = phi_5394_;
                                    if (_e1780 < 0.0lf) {
                                        phi_5400_ = -(_e1780);
                                    } else {
                                        phi_5400_ = _e1780;
                                    }
                                    let _e1834 = phi_5400_;
                                    if (_e1830 > _e1834) {
                                        phi_5405_ = _e1830;
                                    } else {
                                        phi_5405_ = _e1834;
                                    }
                                    let _e1837 = phi_5405_;
                                    local_5 = type_59(array<f64, 3>(_e1778, _e1779, _e1780), _e1819, (_e1837 + _e1819));
                                    let _e1842 = local_4.member;
                                    let _e1847 = local_5.member;
                                    let _e1853 = ((_e1842[1] * _e1847[2]) - (_e1842[2] * _e1847[1]));
                                    let _e1856 = ((_e1842[2] * _e1847[0]) - (_e1842[0] * _e1847[2]));
                                    let _e1859 = ((_e1842[0] * _e1847[1]) - (_e1842[1] * _e1847[0]));
                                    if (_e1853 < 0.0lf) {
                                        phi_5454_ = -(_e1853);
                                    } else {
                                        phi_5454_ = _e1853;
                                    }
                                    let _e1863 = phi_5454_;
                                    if (_e1856 < 0.0lf) {
                                        phi_5460_ = -(_e1856);
                                    } else {
                                        phi_5460_ = _e1856;
                                    }
                                    let _e1867 = phi_5460_;
                                    if (_e1863 > _e1867) {
                                        if (_e1853 < 0.0lf) {
                                            phi_5470_ = -(_e1853);
                                        } else {
                                            phi_5470_ = _e1853;
                                        }
                                        let _e1885 = phi_5470_;
                                        if (_e1859 < 0.0lf) {
                                            phi_5476_ = -(_e1859);
                                        } else {
                                            phi_5476_ = _e1859;
                                        }
                                        let _e1889 = phi_5476_;
                                        if (_e1885 > _e1889) {
                                            phi_5481_ = 2u;
                                            phi_5482_ = 1u;
                                        } else {
                                            phi_5481_ = 1u;
                                            phi_5482_ = 0u;
                                        }
                                        let _e1892 = phi_5481_;
                                        let _e1894 = phi_5482_;
                                        phi_5501_ = _e1892;
                                        phi_5502_ = _e1894;
                                    } else {
                                        if (_e1856 < 0.0lf) {
                                            phi_5488_ = -(_e1856);
                                        } else {
                                            phi_5488_ = _e1856;
                                        }
                                        let _e1872 = phi_5488_;
                                        if (_e1859 < 0.0lf) {
                                            phi_5494_ = -(_e1859);
                                        } else {
                                            phi_5494_ = _e1859;
                                        }
                                        let _e1876 = phi_5494_;
                                        if (_e1872 > _e1876) {
                                            phi_5499_ = 0u;
                                            phi_5500_ = 2u;
                                        } else {
                                            phi_5499_ = 1u;
                                            phi_5500_ = 0u;
                                        }
                                        let _e1879 = phi_5499_;
                                        let _e1881 = phi_5500_;
                                        phi_5501_ = _e1879;
                                        phi_5502_ = _e1881;
                                    }
                                    let _e1896 = phi_5501_;
                                    let _e1898 = phi_5502_;
                                    if (_e1898 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1902 = local_4.member[_e1898];
                                    if (_e1896 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1906 = local_5.member[_e1896];
                                    if (_e1896 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1911 = local_4.member[_e1896];
                                    if (_e1898 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1915 = local_5.member[_e1898];
                                    let _e1917 = ((_e1902 * _e1906) - (_e1911 * _e1915));
                                    let _e1918 = f64(1f);
                                    let _e1920 = local_4.member_1;
                                    let _e1922 = local_5.member_2;
                                    let _e1925 = local_4.member_2;
                                    let _e1927 = local_5.member_1;
                                    let _e1933 = local_4.member_2;
                                    let _e1935 = local_5.member_2;
                                    let _e1944 = local_4.member_2;
                                    let _e1947 = local_5.member_2;
                                    let _e1951 = (((((_e1920 * _e1922) + (_e1925 * _e1927)) * f64(2.01f)) + ((_e1933 * _e1935) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1918 + _e1944) * (_e1918 + _e1947))));
                                    if (_e1917 < 0.0lf) {
                                        phi_5573_ = -(_e1917);
                                    } else {
                                        phi_5573_ = _e1917;
                                    }
                                    let _e1955 = phi_5573_;
                                    if (_e1955 > _e1951) {
                                        if (_e1917 < f64(0f)) {
                                            phi_5585_ = f64(-1f);
                                        } else {
                                            phi_5585_ = f64(1f);
                                        }
                                        let _e1962 = phi_5585_;
                                        if (_e1898 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1966 = local_3.member[_e1898];
                                        if (_e1896 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1970 = local_5.member[_e1896];
                                        if (_e1896 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1975 = local_3.member[_e1896];
                                        if (_e1898 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1979 = local_5.member[_e1898];
                                        let _e1982 = f64(1f);
                                        let _e1984 = local_3.member_1;
                                        let _e1986 = local_5.member_2;
                                        let _e1989 = local_3.member_2;
                                        let _e1991 = local_5.member_1;
                                        let _e1997 = local_3.member_2;
                                        let _e1999 = local_5.member_2;
                                        let _e2008 = local_3.member_2;
                                        let _e2011 = local_5.member_2;
                                        let _e2015 = (((((_e1984 * _e1986) + (_e1989 * _e1991)) * f64(2.01f)) + ((_e1997 * _e1999) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1982 + _e2008) * (_e1982 + _e2011))));
                                        if (_e1898 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2019 = local_4.member[_e1898];
                                        if (_e1896 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2023 = local_3.member[_e1896];
                                        if (_e1896 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2028 = local_4.member[_e1896];
                                        if (_e1898 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2032 = local_3.member[_e1898];
                                        let _e2035 = f64(1f);
                                        let _e2037 = local_4.member_1;
                                        let _e2039 = local_3.member_2;
                                        let _e2042 = local_4.member_2;
                                        let _e2044 = local_3.member_1;
                                        let _e2050 = local_4.member_2;
                                        let _e2052 = local_3.member_2;
                                        let _e2061 = local_4.member_2;
                                        let _e2064 = local_3.member_2;
                                        let _e2068 = (((((_e2037 * _e2039) + (_e2042 * _e2044)) * f64(2.01f)) + ((_e2050 * _e2052) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2035 + _e2061) * (_e2035 + _e2064))));
                                        let _e2069 = (_e1917 * _e1962);
                                        let _e2070 = (((_e1966 * _e1970) - (_e1975 * _e1979)) * _e1962);
                                        let _e2071 = (((_e2019 * _e2023) - (_e2028 * _e2032)) * _e1962);
                                        if (_e2069 < 0.0lf) {
                                            phi_5724_ = -(_e2069);
                                        } else {
                                            phi_5724_ = _e2069;
                                        }
                                        let _e2075 = phi_5724_;
                                        if (_e2070 < 0.0lf) {
                                            phi_5730_ = -(_e2070);
                                        } else {
                                            phi_5730_ = _e2070;
                                        }
                                        let _e2079 = phi_5730_;
                                        if (_e2071 < 0.0lf) {
                                            phi_5737_ = -(_e2071);
                                        } else {
                                            phi_5737_ = _e2071;
                                        }
                                        let _e2084 = phi_5737_;
                                        let _e2088 = (((_e2075 + _e2079) + _e2084) * (1.1102230246251565e-16lf * f64(4f)));
                                        local_6[0u].member = _e2070;
                                        local_6[0u].member_1 = _e2015;
                                        local_6[1u].member = _e2071;
                                        local_6[1u].member_1 = _e2068;
                                        local_6[2u].member = (_e2069 - _e2070);
                                        local_6[2u].member_1 = ((_e1951 + _e2015) + _e2088);
                                        local_6[3u].member = (_e2069 - _e2071);
                                        local_6[3u].member_1 = ((_e1951 + _e2068) + _e2088);
                                        phi_5781_ = type_29(0u, 4u);
                                        phi_5784_ = true;
                                        loop {
                                            let _e2109 = phi_5781_;
                                            let _e2111 = phi_5784_;
                                            local_25 = _e2111;
                                            if (_e2109.member < _e2109.member_1) {
                                                phi_5782_ = type_29((_e2109.member + 1u), _e2109.member_1);
                                                phi_5807_ = type_29(1u, _e2109.member);
                                            } else {
                                                phi_5782_ = _e2109;
                                                phi_5807_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e2125 = phi_5782_;
                                            let _e2127 = phi_5807_;
                                            if (bitcast<i32>(_e2127.member) != 0i) {
                                                if (_e2127.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e2135 = local_6[_e2127.member_1].member;
                                                let _e2138 = local_6[_e2127.member_1].member_1;
                                                let _e2140 = (_e2135 < -(_e2138));
                                                if _e2140 {
                                                    phi_5834_ = bool();
                                                    phi_5835_ = false;
                                                } else {
                                                    phi_5834_ = (_e2111 && (_e2135 > _e2138));
                                                    phi_5835_ = true;
                                                }
                                                let _e2144 = phi_5834_;
                                                let _e2146 = phi_5835_;
                                                phi_5785_ = _e2144;
                                                phi_5836_ = _e2146;
                                                phi_5837_ = _e2140;
                                            } else {
                                                phi_5785_ = bool();
                                                phi_5836_ = false;
                                                phi_5837_ = false;
                                            }
                                            let _e2148 = phi_5785_;
                                            let _e2150 = phi_5836_;
                                            let _e2152 = phi_5837_;
                                            local_24 = _e2152;
                                            continue;
                                            continuing {
                                                phi_5781_ = _e2125;
                                                phi_5784_ = _e2148;
                                                break if !(_e2150);
                                            }
                                        }
                                        let _e2155 = local_24;
                                        if _e2155 {
                                            phi_5841_ = false;
                                        } else {
                                            phi_5841_ = true;
                                        }
                                        let _e2157 = phi_5841_;
                                        if _e2157 {
                                            let _e2159 = local_25;
                                            if _e2159 {
                                                phi_5848_ = 1u;
                                            } else {
                                                phi_5848_ = 2u;
                                            }
                                            let _e2161 = phi_5848_;
                                            phi_5849_ = _e2161;
                                            phi_5850_ = false;
                                        } else {
                                            phi_5849_ = u32();
                                            phi_5850_ = true;
                                        }
                                        let _e2163 = phi_5849_;
                                        let _e2165 = phi_5850_;
                                        phi_5851_ = _e2163;
                                        phi_5852_ = 0u;
                                        phi_5853_ = _e2165;
                                    } else {
                                        phi_5851_ = u32();
                                        phi_5852_ = 2u;
                                        phi_5853_ = true;
                                    }
                                    let _e2167 = phi_5851_;
                                    let _e2169 = phi_5852_;
                                    let _e2171 = phi_5853_;
                                    if _e2171 {
                                        phi_5857_ = _e2169;
                                    } else {
                                        phi_5857_ = _e2167;
                                    }
                                    let _e2173 = phi_5857_;
                                    let _e2174 = (_e2173 == 0u);
                                    if _e2174 {
                                        phi_7401_ = f64();
                                        phi_7402_ = false;
                                        phi_7403_ = false;
                                        phi_7404_ = false;
                                    } else {
                                        if (_e2173 == 1u) {
                                            if _e1432.member_2 {
                                                if ((_e1432.member_1 - _e1432.member) <= f64(0.0000005f)) {
                                                    phi_5878_ = false;
                                                } else {
                                                    phi_5878_ = true;
                                                }
                                                let _e2183 = phi_5878_;
                                                phi_5879_ = _e2183;
                                            } else {
                                                phi_5879_ = true;
                                            }
                                            let _e2185 = phi_5879_;
                                            phi_5880_ = _e2185;
                                        } else {
                                            phi_5880_ = true;
                                        }
                                        let _e2187 = phi_5880_;
                                        if _e2187 {
                                            let _e2193 = local_20.member[0u];
                                            let _e2199 = local_20.member_1[0u];
                                            let _e2205 = local_20.member_2[0u];
                                            let _e2209 = (_e2193[0] - _e2199[0]);
                                            let _e2210 = (_e2193[1] - _e2199[1]);
                                            let _e2211 = (_e2193[2] - _e2199[2]);
                                            local_1 = array<array<f64, 3>, 4>(_e2193, array<f64, 3>(_e2209, _e2210, _e2211), array<f64, 3>((_e2193[0] - _e2205[0]), (_e2193[1] - _e2205[1]), (_e2193[2] - _e2205[2])), array<f64, 3>((_e2209 - _e2205[0]), (_e2210 - _e2205[1]), (_e2211 - _e2205[2])));
                                            let _e2224 = local_20.member[1u];
                                            let _e2230 = local_20.member_1[1u];
                                            let _e2236 = local_20.member_2[1u];
                                            let _e2240 = (_e2224[0] - _e2230[0]);
                                            let _e2241 = (_e2224[1] - _e2230[1]);
                                            let _e2242 = (_e2224[2] - _e2230[2]);
                                            local_2 = array<array<f64, 3>, 4>(_e2224, array<f64, 3>(_e2240, _e2241, _e2242), array<f64, 3>((_e2224[0] - _e2236[0]), (_e2224[1] - _e2236[1]), (_e2224[2] - _e2236[2])), array<f64, 3>((_e2240 - _e2236[0]), (_e2241 - _e2236[1]), (_e2242 - _e2236[2])));
                                            let _e2255 = local_20.member[0u];
                                            if (_e2255[0] < 0.0lf) {
                                                phi_6077_ = -(_e2255[0]);
                                            } else {
                                                phi_6077_ = _e2255[0];
                                            }
                                            let _e2262 = phi_6077_;
                                            if (_e2255[1] < 0.0lf) {
                                                phi_6084_ = -(_e2255[1]);
                                            } else {
                                                phi_6084_ = _e2255[1];
                                            }
                                            let _e2266 = phi_6084_;
                                            if (_e2262 > _e2266) {
                                                phi_6089_ = _e2262;
                                            } else {
                                                phi_6089_ = _e2266;
                                            }
                                            let _e2269 = phi_6089_;
                                            if (_e2255[2] < 0.0lf) {
                                                phi_6096_ = -(_e2255[2]);
                                            } else {
                                                phi_6096_ = _e2255[2];
                                            }
                                            let _e2273 = phi_6096_;
                                            if (_e2269 > _e2273) {
                                                phi_6101_ = _e2269;
                                            } else {
                                                phi_6101_ = _e2273;
                                            }
                                            let _e2276 = phi_6101_;
                                            let _e2279 = local_20.member[1u];
                                            if (_e2279[0] < 0.0lf) {
                                                phi_6114_ = -(_e2279[0]);
                                            } else {
                                                phi_6114_ = _e2279[0];
                                            }
                                            let _e2286 = phi_6114_;
                                            if (_e2279[1] < 0.0lf) {
                                                phi_6121_ = -(_e2279[1]);
                                            } else {
                                                phi_6121_ = _e2279[1];
                                            }
                                            let _e2290 = phi_6121_;
                                            if (_e2286 > _e2290) {
                                                phi_6126_ = _e2286;
                                            } else {
                                                phi_6126_ = _e2290;
                                            }
                                            let _e2293 = phi_6126_;
                                            if (_e2279[2] < 0.0lf) {
                                                phi_6133_ = -(_e2279[2]);
                                            } else {
                                                phi_6133_ = _e2279[2];
                                            }
                                            let _e2297 = phi_6133_;
                                            if (_e2293 > _e2297) {
                                                phi_6138_ = _e2293;
                                            } else {
                                                phi_6138_ = _e2297;
                                            }
                                            let _e2300 = phi_6138_;
                                            if (_e2276 > _e2300) {
                                                phi_6143_ = _e2276;
                                            } else {
                                                phi_6143_ = _e2300;
                                            }
                                            let _e2303 = phi_6143_;
                                            let _e2305 = local_20.member_3;
                                            let _e2309 = local_20.member_1[0u];
                                            if (_e2309[0] < 0.0lf) {
                                                phi_6160_ = -(_e2309[0]);
                                            } else {
                                                phi_6160_ = _e2309[0];
                                            }
                                            let _e2316 = phi_6160_;
                                            if (_e2309[1] < 0.0lf) {
                                                phi_6167_ = -(_e2309[1]);
                                            } else {
                                                phi_6167_ = _e2309[1];
                                            }
                                            let _e2320 = phi_6167_;
                                            if (_e2316 > _e2320) {
                                                phi_6172_ = _e2316;
                                            } else {
                                                phi_6172_ = _e2320;
                                            }
                                            let _e2323 = phi_6172_;
                                            if (_e2309[2] < 0.0lf) {
                                                phi_6179_ = -(_e2309[2]);
                                            } else {
                                                phi_6179_ = _e2309[2];
                                            }
                                            let _e2327 = phi_6179_;
                                            if (_e2323 > _e2327) {
                                                phi_6184_ = _e2323;
                                            } else {
                                                phi_6184_ = _e2327;
                                            }
                                            let _e2330 = phi_6184_;
                                            let _e2333 = local_20.member_1[1u];
                                            if (_e2333[0] < 0.0lf) {
                                                phi_6198_ = -(_e2333[0]);
                                            } else {
                                                phi_6198_ = _e2333[0];
                                            }
                                            let _e2340 = phi_6198_;
                                            if (_e2333[1] < 0.0lf) {
                                                phi_6205_ = -(_e2333[1]);
                                            } else {
                                                phi_6205_ = _e2333[1];
                                            }
                                            let _e2344 = phi_6205_;
                                            if (_e2340 > _e2344) {
                                                phi_6210_ = _e2340;
                                            } else {
                                                phi_6210_ = _e2344;
                                            }
                                            let _e2347 = phi_6210_;
                                            if (_e2333[2] < 0.0lf) {
                                                phi_6217_ = -(_e2333[2]);
                                            } else {
                                                phi_6217_ = _e2333[2];
                                            }
                                            let _e2351 = phi_6217_;
                                            if (_e2347 > _e2351) {
                                                phi_6222_ = _e2347;
                                            } else {
                                                phi_6222_ = _e2351;
                                            }
                                            let _e2354 = phi_6222_;
                                            if (_e2330 > _e2354) {
                                                phi_6227_ = _e2330;
                                            } else {
                                                phi_6227_ = _e2354;
                                            }
                                            let _e2357 = phi_6227_;
                                            let _e2359 = local_20.member_3;
                                            let _e2363 = local_20.member_2[0u];
                                            if (_e2363[0] < 0.0lf) {
                                                phi_6244_ = -(_e2363[0]);
                                            } else {
                                                phi_6244_ = _e2363[0];
                                            }
                                            let _e2370 = phi_6244_;
                                            if (_e2363[1] < 0.0lf) {
                                                phi_6251_ = -(_e2363[1]);
                                            } else {
                                                phi_6251_ = _e2363[1];
                                            }
                                            let _e2374 = phi_6251_;
                                            if (_e2370 > _e2374) {
                                                phi_6256_ = _e2370;
                                            } else {
                                                phi_6256_ = _e2374;
                                            }
                                            let _e2377 = phi_6256_;
                                            if (_e2363[2] < 0.0lf) {
                                                phi_6263_ = -(_e2363[2]);
                                            } else {
                                                phi_6263_ = _e2363[2];
                                            }
                                            let _e2381 = phi_6263_;
                                            if (_e2377 > _e2381) {
                                                phi_6268_ = _e2377;
                                            } else {
                                                phi_6268_ = _e2381;
                                            }
                                            let _e2384 = phi_6268_;
                                            let _e2387 = local_20.member_2[1u];
                                            if (_e2387[0] < 0.0lf) {
                                                phi_6282_ = -(_e2387[0]);
                                            } else {
                                                phi_6282_ = _e2387[0];
                                            }
                                            let _e2394 = phi_6282_;
                                            if (_e2387[1] < 0.0lf) {
                                                phi_6289_ = -(_e2387[1]);
                                            } else {
                                                phi_6289_ = _e2387[1];
                                            }
                                            let _e2398 = phi_6289_;
                                            if (_e2394 > _e2398) {
                                                phi_6294_ = _e2394;
                                            } else {
                                                phi_6294_ = _e2398;
                                            }
                                            let _e2401 = phi_6294_;
                                            if (_e2387[2] < 0.0lf) {
                                                phi_6301_ = -(_e2387[2]);
                                            } else {
                                                phi_6301_ = _e2387[2];
                                            }
                                            let _e2405 = phi_6301_;
                                            if (_e2401 > _e2405) {
                                                phi_6306_ = _e2401;
                                            } else {
                                                phi_6306_ = _e2405;
                                            }
                                            let _e2408 = phi_6306_;
                                            if (_e2384 > _e2408) {
                                                phi_6311_ = _e2384;
                                            } else {
                                                phi_6311_ = _e2408;
                                            }
                                            let _e2411 = phi_6311_;
                                            let _e2413 = local_20.member_3;
                                            let _e2421 = local_20.member_3;
                                            phi_6331_ = type_29(0u, 48u);
                                            phi_6334_ = _e1432.member;
                                            loop {
                                                let _e2430 = phi_6331_;
                                                let _e2432 = phi_6334_;
                                                local_70 = _e2432;
                                                local_32 = _e2432;
                                                local_33 = _e2432;
                                                local_34 = _e2432;
                                                local_35 = _e2432;
                                                if (_e2430.member < _e2430.member_1) {
                                                    phi_6332_ = type_29((_e2430.member + 1u), _e2430.member_1);
                                                    phi_6357_ = type_29(1u, _e2430.member);
                                                } else {
                                                    phi_6332_ = _e2430;
                                                    phi_6357_ = type_29(0u, type_29().member_1);
                                                }
                                                let _e2446 = phi_6332_;
                                                let _e2448 = phi_6357_;
                                                if (bitcast<i32>(_e2448.member) != 0i) {
                                                    let _e2454 = local_20.member[0u];
                                                    let _e2460 = local_20.member[1u];
                                                    let _e2470 = (_e2454[0] + ((_e2460[0] - _e2454[0]) * _e2432));
                                                    let _e2471 = (_e2454[1] + ((_e2460[1] - _e2454[1]) * _e2432));
                                                    let _e2472 = (_e2454[2] + ((_e2460[2] - _e2454[2]) * _e2432));
                                                    let _e2475 = local_20.member_1[0u];
                                                    let _e2481 = local_20.member_1[1u];
                                                    let _e2491 = (_e2475[0] + ((_e2481[0] - _e2475[0]) * _e2432));
                                                    let _e2492 = (_e2475[1] + ((_e2481[1] - _e2475[1]) * _e2432));
                                                    let _e2493 = (_e2475[2] + ((_e2481[2] - _e2475[2]) * _e2432));
                                                    let _e2496 = local_20.member_2[0u];
                                                    let _e2502 = local_20.member_2[1u];
                                                    let _e2512 = (_e2496[0] + ((_e2502[0] - _e2496[0]) * _e2432));
                                                    let _e2513 = (_e2496[1] + ((_e2502[1] - _e2496[1]) * _e2432));
                                                    let _e2514 = (_e2496[2] + ((_e2502[2] - _e2496[2]) * _e2432));
                                                    let _e2519 = (((_e2491 * _e2491) + (_e2492 * _e2492)) + (_e2493 * _e2493));
                                                    let _e2524 = (((_e2491 * _e2512) + (_e2492 * _e2513)) + (_e2493 * _e2514));
                                                    let _e2529 = (((_e2512 * _e2512) + (_e2513 * _e2513)) + (_e2514 * _e2514));
                                                    let _e2534 = (((_e2470 * _e2491) + (_e2471 * _e2492)) + (_e2472 * _e2493));
                                                    let _e2539 = (((_e2470 * _e2512) + (_e2471 * _e2513)) + (_e2472 * _e2514));
                                                    let _e2542 = ((_e2519 * _e2529) - (_e2524 * _e2524));
                                                    let _e2543 = f64(0f);
                                                    let _e2544 = f64(1f);
                                                    let _e2548 = (((_e2534 * _e2529) - (_e2539 * _e2524)) / _e2542);
                                                    let _e2552 = (((_e2539 * _e2519) - (_e2534 * _e2524)) / _e2542);
                                                    if (_e2548 >= _e2543) {
                                                        if (_e2552 >= _e2543) {
                                                            if (_e2548 <= _e2544) {
                                                                phi_6513_ = (_e2552 <= _e2544);
                                                                phi_6514_ = false;
                                                            } else {
                                                                phi_6513_ = bool();
                                                                phi_6514_ = true;
                                                            }
                                                            let _e2558 = phi_6513_;
                                                            let _e2560 = phi_6514_;
                                                            phi_6515_ = _e2558;
                                                            phi_6516_ = _e2560;
                                                        } else {
                                                            phi_6515_ = bool();
                                                            phi_6516_ = true;
                                                        }
                                                        let _e2562 = phi_6515_;
                                                        let _e2564 = phi_6516_;
                                                        phi_6517_ = _e2562;
                                                        phi_6518_ = _e2564;
                                                    } else {
                                                        phi_6517_ = bool();
                                                        phi_6518_ = true;
                                                    }
                                                    let _e2566 = phi_6517_;
                                                    let _e2568 = phi_6518_;
                                                    if _e2568 {
                                                        phi_6522_ = false;
                                                    } else {
                                                        phi_6522_ = _e2566;
                                                    }
                                                    let _e2570 = phi_6522_;
                                                    if (_e2542 > _e2543) {
                                                        if _e2570 {
                                                            phi_6562_ = array<f64, 3>((_e2470 - ((_e2491 * _e2548) + (_e2512 * _e2552))), (_e2471 - ((_e2492 * _e2548) + (_e2513 * _e2552))), (_e2472 - ((_e2493 * _e2548) + (_e2514 * _e2552))));
                                                            phi_6563_ = false;
                                                        } else {
                                                            phi_6562_ = array<f64, 3>();
                                                            phi_6563_ = true;
                                                        }
                                                        let _e2586 = phi_6562_;
                                                        let _e2588 = phi_6563_;
                                                        phi_6564_ = _e2586;
                                                        phi_6565_ = _e2588;
                                                    } else {
                                                        phi_6564_ = array<f64, 3>();
                                                        phi_6565_ = true;
                                                    }
                                                    let _e2590 = phi_6564_;
                                                    let _e2592 = phi_6565_;
                                                    if _e2592 {
                                                        let _e2593 = (_e2470 - _e2491);
                                                        let _e2594 = (_e2471 - _e2492);
                                                        let _e2595 = (_e2472 - _e2493);
                                                        let _e2606 = ((((_e2470 * _e2491) + (_e2471 * _e2492)) + (_e2472 * _e2493)) / (((_e2491 * _e2491) + (_e2492 * _e2492)) + (_e2493 * _e2493)));
                                                        if (_e2606 > f64(0f)) {
                                                            if (_e2606 < f64(1f)) {
                                                                phi_6598_ = _e2606;
                                                            } else {
                                                                phi_6598_ = f64(1f);
                                                            }
                                                            let _e2614 = phi_6598_;
                                                            phi_6600_ = _e2614;
                                                        } else {
                                                            phi_6600_ = f64(0f);
                                                        }
                                                        let _e2616 = phi_6600_;
                                                        let _e2633 = ((((_e2470 * _e2512) + (_e2471 * _e2513)) + (_e2472 * _e2514)) / (((_e2512 * _e2512) + (_e2513 * _e2513)) + (_e2514 * _e2514)));
                                                        if (_e2633 > f64(0f)) {
                                                            if (_e2633 < f64(1f)) {
                                                                phi_6630_ = _e2633;
                                                            } else {
                                                                phi_6630_ = f64(1f);
                                                            }
                                                            let _e2641 = phi_6630_;
                                                            phi_6632_ = _e2641;
                                                        } else {
                                                            phi_6632_ = f64(0f);
                                                        }
                                                        let _e2643 = phi_6632_;
                                                        let _e2660 = ((((_e2593 * _e2512) + (_e2594 * _e2513)) + (_e2595 * _e2514)) / (((_e2512 * _e2512) + (_e2513 * _e2513)) + (_e2514 * _e2514)));
                                                        if (_e2660 > f64(0f)) {
                                                            if (_e2660 < f64(1f)) {
                                                                phi_6662_ = _e2660;
                                                            } else {
                                                                phi_6662_ = f64(1f);
                                                            }
                                                            let _e2668 = phi_6662_;
                                                            phi_6664_ = _e2668;
                                                        } else {
                                                            phi_6664_ = f64(0f);
                                                        }
                                                        let _e2670 = phi_6664_;
                                                        let _e2677 = (_e2470 - _e2512);
                                                        let _e2678 = (_e2471 - _e2513);
                                                        let _e2679 = (_e2472 - _e2514);
                                                        let _e2690 = ((((_e2677 * _e2491) + (_e2678 * _e2492)) + (_e2679 * _e2493)) / (((_e2491 * _e2491) + (_e2492 * _e2492)) + (_e2493 * _e2493)));
                                                        if (_e2690 > f64(0f)) {
                                                            if (_e2690 < f64(1f)) {
                                                                phi_6697_ = _e2690;
                                                            } else {
                                                                phi_6697_ = f64(1f);
                                                            }
                                                            let _e2698 = phi_6697_;
                                                            phi_6699_ = _e2698;
                                                        } else {
                                                            phi_6699_ = f64(0f);
                                                        }
                                                        let _e2700 = phi_6699_;
                                                        local[0u] = array<f64, 3>((_e2470 - (_e2491 * _e2616)), (_e2471 - (_e2492 * _e2616)), (_e2472 - (_e2493 * _e2616)));
                                                        local[1u] = array<f64, 3>((_e2470 - (_e2512 * _e2643)), (_e2471 - (_e2513 * _e2643)), (_e2472 - (_e2514 * _e2643)));
                                                        local[2u] = array<f64, 3>((_e2593 - (_e2512 * _e2670)), (_e2594 - (_e2513 * _e2670)), (_e2595 - (_e2514 * _e2670)));
                                                        local[3u] = array<f64, 3>((_e2677 - (_e2491 * _e2700)), (_e2678 - (_e2492 * _e2700)), (_e2679 - (_e2493 * _e2700)));
                                                        let _e2716 = local[0u];
                                                        phi_6854_ = type_29(1u, 4u);
                                                        phi_6857_ = array<f64, 3>(_e2716[0], _e2716[1], _e2716[2]);
                                                        loop {
                                                            let _e2722 = phi_6854_;
                                                            let _e2724 = phi_6857_;
                                                            local_57 = _e2724;
                                                            if (_e2722.member < _e2722.member_1) {
                                                                phi_6855_ = type_29((_e2722.member + 1u), _e2722.member_1);
                                                                phi_6880_ = type_29(1u, _e2722.member);
                                                            } else {
                                                                phi_6855_ = _e2722;
                                                                phi_6880_ = type_29(0u, type_29().member_1);
                                                            }
                                                            let _e2738 = phi_6855_;
                                                            let _e2740 = phi_6880_;
                                                            let _e2744 = (bitcast<i32>(_e2740.member) != 0i);
                                                            if _e2744 {
                                                                if (_e2740.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2747 = local[_e2740.member_1];
                                                                if (_e2740.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2753 = local[_e2740.member_1];
                                                                if ((((_e2747[0] * _e2753[0]) + (_e2747[1] * _e2753[1])) + (_e2747[2] * _e2753[2])) < (((_e2724[0] * _e2724[0]) + (_e2724[1] * _e2724[1])) + (_e2724[2] * _e2724[2]))) {
                                                                    if (_e2740.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2776 = local[_e2740.member_1];
                                                                    phi_6947_ = array<f64, 3>(_e2776[0], _e2776[1], _e2776[2]);
                                                                } else {
                                                                    phi_6947_ = _e2724;
                                                                }
                                                                let _e2782 = phi_6947_;
                                                                phi_6858_ = _e2782;
                                                            } else {
                                                                phi_6858_ = array<f64, 3>();
                                                            }
                                                            let _e2784 = phi_6858_;
                                                            continue;
                                                            continuing {
                                                                phi_6854_ = _e2738;
                                                                phi_6857_ = _e2784;
                                                                break if !(_e2744);
                                                            }
                                                        }
                                                        let _e5447 = local_57;
                                                        phi_6948_ = _e5447;
                                                    } else {
                                                        phi_6948_ = _e2590;
                                                    }
                                                    let _e2787 = phi_6948_;
                                                    if (_e2787[0] < 0.0lf) {
                                                        phi_6955_ = -(_e2787[0]);
                                                    } else {
                                                        phi_6955_ = _e2787[0];
                                                    }
                                                    let _e2792 = phi_6955_;
                                                    if (_e2787[1] < 0.0lf) {
                                                        phi_6962_ = -(_e2787[1]);
                                                    } else {
                                                        phi_6962_ = _e2787[1];
                                                    }
                                                    let _e2797 = phi_6962_;
                                                    if (_e2787[2] < 0.0lf) {
                                                        phi_6970_ = -(_e2787[2]);
                                                    } else {
                                                        phi_6970_ = _e2787[2];
                                                    }
                                                    let _e2803 = phi_6970_;
                                                    let _e2804 = ((_e2792 + _e2797) + _e2803);
                                                    if (_e2804 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2804) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2810 = (f64(1f) / _e2804);
                                                            let _e2812 = (_e2787[0] * _e2810);
                                                            let _e2814 = (_e2787[1] * _e2810);
                                                            let _e2816 = (_e2787[2] * _e2810);
                                                            let _e2821 = (((_e2812 * _e2812) + (_e2814 * _e2814)) + (_e2816 * _e2816));
                                                            if (_e2821 <= 2.2250738585072014e-308lf) {
                                                                if (_e2821 > 0.0lf) {
                                                                    phi_7008_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_7008_ = 0.0lf;
                                                                }
                                                                let _e2879 = phi_7008_;
                                                                phi_7072_ = _e2879;
                                                            } else {
                                                                phi_7015_ = type_27(0i, 5i);
                                                                phi_7018_ = bitcast<f64>(((bitcast<u64>(_e2821) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2828 = phi_7015_;
                                                                    let _e2830 = phi_7018_;
                                                                    local_26 = _e2830;
                                                                    if (_e2828.member < _e2828.member_1) {
                                                                        let _e2838 = (_e2828.member + 1i);
                                                                        if ((false == (_e2838 > _e2828.member)) != false) {
                                                                            phi_7039_ = true;
                                                                        } else {
                                                                            phi_7039_ = false;
                                                                        }
                                                                        let _e2843 = phi_7039_;
                                                                        if _e2843 {
                                                                            phi_7045_ = type_28(0u, type_28().member_1);
                                                                        } else {
                                                                            phi_7045_ = type_28(1u, _e2838);
                                                                        }
                                                                        let _e2849 = phi_7045_;
                                                                        if (bitcast<i32>(_e2849.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_7016_ = type_27(_e2849.member_1, _e2828.member_1);
                                                                        phi_7059_ = type_28(1u, _e2828.member);
                                                                    } else {
                                                                        phi_7016_ = _e2828;
                                                                        phi_7059_ = type_28(0u, type_28().member_1);
                                                                    }
                                                                    let _e2859 = phi_7016_;
                                                                    let _e2861 = phi_7059_;
                                                                    let _e2864 = (bitcast<i32>(_e2861.member) != 0i);
                                                                    if _e2864 {
                                                                        phi_7019_ = (0.5lf * (_e2830 + (_e2821 / _e2830)));
                                                                    } else {
                                                                        phi_7019_ = f64();
                                                                    }
                                                                    let _e2869 = phi_7019_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7015_ = _e2859;
                                                                        phi_7018_ = _e2869;
                                                                        break if !(_e2864);
                                                                    }
                                                                }
                                                                let _e2874 = local_26;
                                                                phi_7072_ = (_e2874 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2881 = phi_7072_;
                                                            phi_7085_ = type_29(0u, 4u);
                                                            phi_7088_ = f64(2f);
                                                            loop {
                                                                let _e2893 = phi_7085_;
                                                                let _e2895 = phi_7088_;
                                                                local_28 = _e2895;
                                                                local_29 = _e2895;
                                                                local_30 = _e2895;
                                                                local_60 = _e2895;
                                                                local_61 = _e2895;
                                                                if (_e2893.member < _e2893.member_1) {
                                                                    phi_7086_ = type_29((_e2893.member + 1u), _e2893.member_1);
                                                                    phi_7111_ = type_29(1u, _e2893.member);
                                                                } else {
                                                                    phi_7086_ = _e2893;
                                                                    phi_7111_ = type_29(0u, type_29().member_1);
                                                                }
                                                                let _e2909 = phi_7086_;
                                                                let _e2911 = phi_7111_;
                                                                if (bitcast<i32>(_e2911.member) != 0i) {
                                                                    if (_e2911.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2918 = local_1[_e2911.member_1];
                                                                    let _e2926 = (((_e2812 * _e2918[0]) + (_e2814 * _e2918[1])) + (_e2816 * _e2918[2]));
                                                                    if (_e2911.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2929 = local_2[_e2911.member_1];
                                                                    let _e2937 = (((_e2812 * _e2929[0]) + (_e2814 * _e2929[1])) + (_e2816 * _e2929[2]));
                                                                    if (_e2926 < 0.0lf) {
                                                                        phi_7162_ = -(_e2926);
                                                                    } else {
                                                                        phi_7162_ = _e2926;
                                                                    }
                                                                    let _e2941 = phi_7162_;
                                                                    if (_e2937 < 0.0lf) {
                                                                        phi_7168_ = -(_e2937);
                                                                    } else {
                                                                        phi_7168_ = _e2937;
                                                                    }
                                                                    let _e2945 = phi_7168_;
                                                                    let _e2950 = (((((((((_e2303 + _e2305) + (_e2357 + _e2359)) + (_e2411 + _e2413)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2421 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2881) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2941 + _e2945) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2926 > _e2950) {
                                                                        if (_e2937 > _e2950) {
                                                                            phi_7182_ = false;
                                                                        } else {
                                                                            phi_7182_ = true;
                                                                        }
                                                                        let _e2954 = phi_7182_;
                                                                        phi_7183_ = _e2954;
                                                                    } else {
                                                                        phi_7183_ = true;
                                                                    }
                                                                    let _e2956 = phi_7183_;
                                                                    if _e2956 {
                                                                        if ((_e2926 + ((_e2937 - _e2926) * _e2432)) > _e2950) {
                                                                            if (_e2937 < _e2926) {
                                                                                let _e2965 = ((_e2926 - _e2937) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                                                if _e2965 {
                                                                                    let _e2973 = (((_e2926 - _e2950) / (_e2926 - _e2937)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    if (_e2895 < _e2973) {
                                                                                        phi_7217_ = _e2895;
                                                                                    } else {
                                                                                        phi_7217_ = _e2973;
                                                                                    }
                                                                                    let _e2976 = phi_7217_;
                                                                                    phi_7218_ = _e2976;
                                                                                } else {
                                                                                    phi_7218_ = f64();
                                                                                }
                                                                                let _e2978 = phi_7218_;
                                                                                phi_7219_ = _e2978;
                                                                                phi_7220_ = _e2965;
                                                                            } else {
                                                                                phi_7219_ = _e2895;
                                                                                phi_7220_ = true;
                                                                            }
                                                                            let _e2980 = phi_7219_;
                                                                            let _e2982 = phi_7220_;
                                                                            if _e2982 {
                                                                                phi_7224_ = false;
                                                                            } else {
                                                                                phi_7224_ = true;
                                                                            }
                                                                            let _e2984 = phi_7224_;
                                                                            phi_7225_ = _e2980;
                                                                            phi_7226_ = _e2982;
                                                                            phi_7227_ = _e2984;
                                                                            phi_7228_ = false;
                                                                        } else {
                                                                            phi_7225_ = f64();
                                                                            phi_7226_ = false;
                                                                            phi_7227_ = false;
                                                                            phi_7228_ = true;
                                                                        }
                                                                        let _e2986 = phi_7225_;
                                                                        let _e2988 = phi_7226_;
                                                                        let _e2990 = phi_7227_;
                                                                        let _e2992 = phi_7228_;
                                                                        phi_7229_ = _e2986;
                                                                        phi_7230_ = _e2988;
                                                                        phi_7231_ = _e2990;
                                                                        phi_7232_ = _e2992;
                                                                    } else {
                                                                        phi_7229_ = _e2895;
                                                                        phi_7230_ = true;
                                                                        phi_7231_ = false;
                                                                        phi_7232_ = false;
                                                                    }
                                                                    let _e2994 = phi_7229_;
                                                                    let _e2996 = phi_7230_;
                                                                    let _e2998 = phi_7231_;
                                                                    let _e3000 = phi_7232_;
                                                                    phi_7089_ = _e2994;
                                                                    phi_7233_ = _e2996;
                                                                    phi_7234_ = false;
                                                                    phi_7235_ = _e2998;
                                                                    phi_7236_ = _e3000;
                                                                } else {
                                                                    phi_7089_ = f64();
                                                                    phi_7233_ = false;
                                                                    phi_7234_ = true;
                                                                    phi_7235_ = false;
                                                                    phi_7236_ = false;
                                                                }
                                                                let _e3002 = phi_7089_;
                                                                let _e3004 = phi_7233_;
                                                                let _e3006 = phi_7234_;
                                                                let _e3008 = phi_7235_;
                                                                let _e3010 = phi_7236_;
                                                                local_27 = _e3006;
                                                                local_58 = _e3008;
                                                                local_59 = _e3010;
                                                                continue;
                                                                continuing {
                                                                    phi_7085_ = _e2909;
                                                                    phi_7088_ = _e3002;
                                                                    break if !(_e3004);
                                                                }
                                                            }
                                                            let _e3013 = local_27;
                                                            if _e3013 {
                                                                let _e3015 = local_28;
                                                                let _e3016 = (_e3015 > _e1432.member_1);
                                                                if _e3016 {
                                                                    phi_7258_ = false;
                                                                    phi_7259_ = false;
                                                                    phi_7260_ = false;
                                                                } else {
                                                                    let _e3018 = local_29;
                                                                    if (_e3018 > _e2432) {
                                                                        let _e3021 = local_30;
                                                                        let _e3024 = ((_e3021 - _e2432) < f64(0.00000000023283064f));
                                                                        if _e3024 {
                                                                            phi_7254_ = false;
                                                                        } else {
                                                                            phi_7254_ = true;
                                                                        }
                                                                        let _e3026 = phi_7254_;
                                                                        phi_7255_ = _e3026;
                                                                        phi_7256_ = _e3024;
                                                                        phi_7257_ = false;
                                                                    } else {
                                                                        phi_7255_ = false;
                                                                        phi_7256_ = false;
                                                                        phi_7257_ = true;
                                                                    }
                                                                    let _e3028 = phi_7255_;
                                                                    let _e3030 = phi_7256_;
                                                                    let _e3032 = phi_7257_;
                                                                    phi_7258_ = _e3028;
                                                                    phi_7259_ = _e3030;
                                                                    phi_7260_ = _e3032;
                                                                }
                                                                let _e3034 = phi_7258_;
                                                                let _e3036 = phi_7259_;
                                                                let _e3038 = phi_7260_;
                                                                phi_7261_ = _e3034;
                                                                phi_7262_ = _e3016;
                                                                phi_7263_ = _e3036;
                                                                phi_7264_ = _e3038;
                                                                phi_7265_ = false;
                                                                phi_7266_ = false;
                                                            } else {
                                                                phi_7261_ = false;
                                                                phi_7262_ = false;
                                                                phi_7263_ = false;
                                                                phi_7264_ = false;
                                                                let _e5504 = local_58;
                                                                phi_7265_ = _e5504;
                                                                let _e5507 = local_59;
                                                                phi_7266_ = _e5507;
                                                            }
                                                            let _e3040 = phi_7261_;
                                                            let _e3042 = phi_7262_;
                                                            let _e3044 = phi_7263_;
                                                            let _e3046 = phi_7264_;
                                                            let _e3048 = phi_7265_;
                                                            let _e3050 = phi_7266_;
                                                            let _e5510 = local_60;
                                                            phi_7267_ = _e5510;
                                                            let _e5513 = local_61;
                                                            phi_7268_ = _e5513;
                                                            phi_7269_ = _e3040;
                                                            phi_7270_ = _e3042;
                                                            phi_7271_ = _e3044;
                                                            phi_7272_ = _e3046;
                                                            phi_7273_ = _e3048;
                                                            phi_7274_ = _e3050;
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
                                                        let _e3052 = phi_7267_;
                                                        let _e3054 = phi_7268_;
                                                        let _e3056 = phi_7269_;
                                                        let _e3058 = phi_7270_;
                                                        let _e3060 = phi_7271_;
                                                        let _e3062 = phi_7272_;
                                                        let _e3064 = phi_7273_;
                                                        let _e3066 = phi_7274_;
                                                        let _e3068 = phi_7275_;
                                                        phi_7276_ = _e3052;
                                                        phi_7277_ = _e3054;
                                                        phi_7278_ = _e3056;
                                                        phi_7279_ = _e3058;
                                                        phi_7280_ = _e3060;
                                                        phi_7281_ = _e3062;
                                                        phi_7282_ = _e3064;
                                                        phi_7283_ = _e3066;
                                                        phi_7284_ = _e3068;
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
                                                    let _e3070 = phi_7276_;
                                                    let _e3072 = phi_7277_;
                                                    let _e3074 = phi_7278_;
                                                    let _e3076 = phi_7279_;
                                                    let _e3078 = phi_7280_;
                                                    let _e3080 = phi_7281_;
                                                    let _e3082 = phi_7282_;
                                                    let _e3084 = phi_7283_;
                                                    let _e3086 = phi_7284_;
                                                    let _e3088 = phi_7285_;
                                                    phi_7286_ = _e3070;
                                                    phi_6335_ = _e3072;
                                                    phi_7287_ = _e3074;
                                                    phi_7288_ = _e3076;
                                                    phi_7289_ = _e3078;
                                                    phi_7290_ = false;
                                                    phi_7291_ = _e3080;
                                                    phi_7292_ = _e3082;
                                                    phi_7293_ = _e3084;
                                                    phi_7294_ = _e3086;
                                                    phi_7295_ = _e3088;
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
                                                let _e3090 = phi_7286_;
                                                let _e3092 = phi_6335_;
                                                let _e3094 = phi_7287_;
                                                let _e3096 = phi_7288_;
                                                let _e3098 = phi_7289_;
                                                let _e3100 = phi_7290_;
                                                let _e3102 = phi_7291_;
                                                let _e3104 = phi_7292_;
                                                let _e3106 = phi_7293_;
                                                let _e3108 = phi_7294_;
                                                let _e3110 = phi_7295_;
                                                local_31 = _e3096;
                                                local_62 = _e3098;
                                                local_63 = _e3100;
                                                local_64 = _e3102;
                                                local_65 = _e3104;
                                                local_66 = _e3106;
                                                local_67 = _e3108;
                                                local_68 = _e3110;
                                                local_69 = _e3090;
                                                local_71 = _e3096;
                                                continue;
                                                continuing {
                                                    phi_6331_ = _e2446;
                                                    phi_6334_ = _e3092;
                                                    break if !(_e3094);
                                                }
                                            }
                                            let _e3113 = local_31;
                                            if _e3113 {
                                                phi_7300_ = type_72(0u, type_72().member_1);
                                                phi_7301_ = false;
                                                phi_7302_ = false;
                                                phi_7303_ = false;
                                                phi_7304_ = false;
                                                phi_7305_ = false;
                                                phi_7306_ = false;
                                                phi_7307_ = false;
                                            } else {
                                                phi_7300_ = type_72();
                                                let _e5546 = local_62;
                                                phi_7301_ = _e5546;
                                                let _e5549 = local_63;
                                                phi_7302_ = _e5549;
                                                let _e5552 = local_64;
                                                phi_7303_ = _e5552;
                                                let _e5555 = local_65;
                                                phi_7304_ = _e5555;
                                                let _e5558 = local_66;
                                                phi_7305_ = _e5558;
                                                let _e5561 = local_67;
                                                phi_7306_ = _e5561;
                                                let _e5564 = local_68;
                                                phi_7307_ = _e5564;
                                            }
                                            let _e3118 = phi_7300_;
                                            let _e3120 = phi_7301_;
                                            let _e3122 = phi_7302_;
                                            let _e3124 = phi_7303_;
                                            let _e3126 = phi_7304_;
                                            let _e3128 = phi_7305_;
                                            let _e3130 = phi_7306_;
                                            let _e3132 = phi_7307_;
                                            if _e3120 {
                                                let _e5567 = local_69;
                                                phi_7311_ = _e5567;
                                                phi_7312_ = true;
                                                phi_7313_ = false;
                                                phi_7314_ = false;
                                                phi_7315_ = false;
                                                phi_7316_ = false;
                                                phi_7317_ = false;
                                                phi_7318_ = false;
                                            } else {
                                                let _e5569 = local_70;
                                                phi_7311_ = _e5569;
                                                phi_7312_ = _e3122;
                                                phi_7313_ = _e3124;
                                                phi_7314_ = _e3126;
                                                phi_7315_ = _e3128;
                                                let _e5576 = local_71;
                                                phi_7316_ = _e5576;
                                                phi_7317_ = _e3130;
                                                phi_7318_ = _e3132;
                                            }
                                            let _e3134 = phi_7311_;
                                            let _e3136 = phi_7312_;
                                            let _e3138 = phi_7313_;
                                            let _e3140 = phi_7314_;
                                            let _e3142 = phi_7315_;
                                            let _e3144 = phi_7316_;
                                            let _e3146 = phi_7317_;
                                            let _e3148 = phi_7318_;
                                            if _e3136 {
                                                phi_7323_ = type_72(1u, _e3134);
                                                phi_7324_ = false;
                                                phi_7325_ = false;
                                                phi_7326_ = false;
                                                phi_7327_ = false;
                                                phi_7328_ = false;
                                                phi_7329_ = false;
                                            } else {
                                                phi_7323_ = type_72();
                                                phi_7324_ = _e3138;
                                                phi_7325_ = _e3140;
                                                phi_7326_ = _e3142;
                                                phi_7327_ = _e3144;
                                                phi_7328_ = _e3146;
                                                phi_7329_ = _e3148;
                                            }
                                            let _e3151 = phi_7323_;
                                            let _e3153 = phi_7324_;
                                            let _e3155 = phi_7325_;
                                            let _e3157 = phi_7326_;
                                            let _e3159 = phi_7327_;
                                            let _e3161 = phi_7328_;
                                            let _e3163 = phi_7329_;
                                            if _e3153 {
                                                let _e3165 = local_32;
                                                phi_7334_ = type_72(1u, _e3165);
                                                phi_7335_ = false;
                                                phi_7336_ = false;
                                                phi_7337_ = true;
                                                phi_7338_ = false;
                                                phi_7339_ = false;
                                            } else {
                                                phi_7334_ = _e3118;
                                                phi_7335_ = _e3155;
                                                phi_7336_ = _e3157;
                                                phi_7337_ = _e3159;
                                                phi_7338_ = _e3161;
                                                phi_7339_ = _e3163;
                                            }
                                            let _e3168 = phi_7334_;
                                            let _e3170 = phi_7335_;
                                            let _e3172 = phi_7336_;
                                            let _e3174 = phi_7337_;
                                            let _e3176 = phi_7338_;
                                            let _e3178 = phi_7339_;
                                            if _e3170 {
                                                let _e3180 = local_33;
                                                phi_7344_ = type_72(1u, _e3180);
                                                phi_7345_ = false;
                                                phi_7346_ = false;
                                                phi_7347_ = false;
                                                phi_7348_ = false;
                                            } else {
                                                phi_7344_ = type_72();
                                                phi_7345_ = _e3172;
                                                phi_7346_ = _e3174;
                                                phi_7347_ = _e3176;
                                                phi_7348_ = _e3178;
                                            }
                                            let _e3183 = phi_7344_;
                                            let _e3185 = phi_7345_;
                                            let _e3187 = phi_7346_;
                                            let _e3189 = phi_7347_;
                                            let _e3191 = phi_7348_;
                                            if _e3185 {
                                                let _e3193 = local_34;
                                                phi_7353_ = type_72(1u, _e3193);
                                                phi_7354_ = true;
                                                phi_7355_ = false;
                                                phi_7356_ = false;
                                                phi_7357_ = false;
                                            } else {
                                                phi_7353_ = _e3183;
                                                phi_7354_ = _e3170;
                                                phi_7355_ = _e3187;
                                                phi_7356_ = _e3189;
                                                phi_7357_ = _e3191;
                                            }
                                            let _e3196 = phi_7353_;
                                            let _e3198 = phi_7354_;
                                            let _e3200 = phi_7355_;
                                            let _e3202 = phi_7356_;
                                            let _e3204 = phi_7357_;
                                            if _e3198 {
                                                phi_7361_ = _e3196;
                                                phi_7362_ = true;
                                                phi_7363_ = false;
                                                phi_7364_ = false;
                                            } else {
                                                phi_7361_ = _e3168;
                                                phi_7362_ = _e3200;
                                                phi_7363_ = _e3202;
                                                phi_7364_ = _e3204;
                                            }
                                            let _e3206 = phi_7361_;
                                            let _e3208 = phi_7362_;
                                            let _e3210 = phi_7363_;
                                            let _e3212 = phi_7364_;
                                            if _e3208 {
                                                phi_7368_ = false;
                                                phi_7369_ = false;
                                            } else {
                                                phi_7368_ = _e3210;
                                                phi_7369_ = _e3212;
                                            }
                                            let _e3214 = phi_7368_;
                                            let _e3216 = phi_7369_;
                                            if _e3214 {
                                                phi_7373_ = false;
                                                phi_7374_ = false;
                                            } else {
                                                phi_7373_ = _e3216;
                                                phi_7374_ = _e3208;
                                            }
                                            let _e3218 = phi_7373_;
                                            let _e3220 = phi_7374_;
                                            if _e3218 {
                                                phi_7378_ = true;
                                                phi_7379_ = false;
                                            } else {
                                                phi_7378_ = _e3214;
                                                phi_7379_ = _e3220;
                                            }
                                            let _e3222 = phi_7378_;
                                            let _e3224 = phi_7379_;
                                            if _e3222 {
                                                let _e3226 = local_35;
                                                phi_7384_ = type_72(1u, _e3226);
                                                phi_7385_ = true;
                                            } else {
                                                phi_7384_ = _e3206;
                                                phi_7385_ = _e3224;
                                            }
                                            let _e3229 = phi_7384_;
                                            let _e3231 = phi_7385_;
                                            if _e3231 {
                                                phi_7389_ = _e3229;
                                            } else {
                                                phi_7389_ = _e3151;
                                            }
                                            let _e3233 = phi_7389_;
                                            let _e3236 = (_e3233.member != 0u);
                                            if _e3236 {
                                                phi_7396_ = false;
                                            } else {
                                                phi_7396_ = true;
                                            }
                                            let _e3238 = phi_7396_;
                                            phi_7397_ = _e3233.member_1;
                                            phi_7398_ = _e3238;
                                            phi_7399_ = _e3236;
                                            phi_7400_ = false;
                                        } else {
                                            phi_7397_ = f64();
                                            phi_7398_ = false;
                                            phi_7399_ = false;
                                            phi_7400_ = true;
                                        }
                                        let _e3240 = phi_7397_;
                                        let _e3242 = phi_7398_;
                                        let _e3244 = phi_7399_;
                                        let _e3246 = phi_7400_;
                                        phi_7401_ = _e3240;
                                        phi_7402_ = _e3242;
                                        phi_7403_ = _e3244;
                                        phi_7404_ = _e3246;
                                    }
                                    let _e3248 = phi_7401_;
                                    let _e3250 = phi_7402_;
                                    let _e3252 = phi_7403_;
                                    let _e3254 = phi_7404_;
                                    phi_7405_ = _e3248;
                                    phi_7406_ = _e2174;
                                    phi_7407_ = _e3250;
                                    phi_7408_ = _e3252;
                                    phi_7409_ = _e3254;
                                }
                                let _e3256 = phi_7405_;
                                let _e3258 = phi_7406_;
                                let _e3260 = phi_7407_;
                                let _e3262 = phi_7408_;
                                let _e3264 = phi_7409_;
                                if _e3258 {
                                    phi_7413_ = true;
                                    phi_7414_ = false;
                                    phi_7415_ = false;
                                } else {
                                    phi_7413_ = _e3260;
                                    phi_7414_ = _e3262;
                                    phi_7415_ = _e3264;
                                }
                                let _e3266 = phi_7413_;
                                let _e3268 = phi_7414_;
                                let _e3270 = phi_7415_;
                                phi_7416_ = _e3256;
                                phi_7417_ = _e1432;
                                phi_7418_ = _e3266;
                                phi_7419_ = false;
                                phi_7420_ = _e3268;
                                phi_7421_ = _e3270;
                            } else {
                                phi_7416_ = f64();
                                phi_7417_ = type_73();
                                phi_7418_ = false;
                                phi_7419_ = true;
                                phi_7420_ = false;
                                phi_7421_ = false;
                            }
                            let _e3272 = phi_7416_;
                            let _e3274 = phi_7417_;
                            let _e3276 = phi_7418_;
                            let _e3278 = phi_7419_;
                            let _e3280 = phi_7420_;
                            let _e3282 = phi_7421_;
                            local_36 = _e3278;
                            local_72 = _e3280;
                            local_73 = _e3282;
                            local_37 = _e3272;
                            local_38 = _e3274;
                            continue;
                            continuing {
                                phi_4370_ = _e1113;
                                break if !(_e3276);
                            }
                        }
                        let _e3285 = local_36;
                        if _e3285 {
                            phi_7426_ = type_72(0u, type_72().member_1);
                            phi_7427_ = false;
                            phi_7428_ = false;
                        } else {
                            phi_7426_ = type_72();
                            let _e5646 = local_72;
                            phi_7427_ = _e5646;
                            let _e5649 = local_73;
                            phi_7428_ = _e5649;
                        }
                        let _e3290 = phi_7426_;
                        let _e3292 = phi_7427_;
                        let _e3294 = phi_7428_;
                        if _e3292 {
                            let _e3296 = local_37;
                            phi_7433_ = type_72(2u, _e3296);
                            phi_7434_ = false;
                        } else {
                            phi_7433_ = type_72();
                            phi_7434_ = _e3294;
                        }
                        let _e3299 = phi_7433_;
                        let _e3301 = phi_7434_;
                        if _e3301 {
                            let _e3303 = local_38;
                            phi_7440_ = type_72(1u, _e3303.member);
                            phi_7441_ = true;
                        } else {
                            phi_7440_ = _e3299;
                            phi_7441_ = _e3292;
                        }
                        let _e3307 = phi_7440_;
                        let _e3309 = phi_7441_;
                        if _e3309 {
                            phi_7445_ = _e3307;
                        } else {
                            phi_7445_ = _e3290;
                        }
                        let _e3311 = phi_7445_;
                        phi_7449_ = _e3311;
                    }
                    let _e5017 = phi_7449_;
                    phi_7450_ = _e5017;
                }
                let _e5022 = phi_7450_;
                switch bitcast<i32>(_e5022.member) {
                    case 0: {
                        phi_7463_ = type_55(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5028 = function_(_e5022.member_1);
                        phi_7463_ = type_55(0u, _e5028, true);
                        break;
                    }
                    case 2: {
                        let _e5026 = function_(_e5022.member_1);
                        phi_7463_ = type_55(1u, _e5026, true);
                        break;
                    }
                    default: {
                        phi_7463_ = type_55();
                        break;
                    }
                }
                let _e5031 = phi_7463_;
                if _e5031.member_2 {
                    let _e5038 = (_e5031.member_1[1] >> bitcast<u32>(20i));
                    if (_e5038 <= 896u) {
                        phi_7486_ = 0u;
                    } else {
                        phi_7486_ = ((((_e5038 - 896u) << bitcast<u32>(23i)) | ((_e5031.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5031.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5053 = phi_7486_;
                    let _e5055 = atomicMin((&earliest.member[0u]), _e5053);
                }
                phi_7490_ = type_54(_e186, _e5031.member, _e192, _e195, _e5031.member_1);
                phi_7491_ = _e5031.member_2;
            } else {
                phi_7490_ = type_54(_e186, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_7491_ = false;
            }
            let _e5057 = phi_7490_;
            let _e5059 = phi_7491_;
            let _e5061 = params.member.member_1;
            if ((_e5061 & 16u) != 0u) {
                if (_e117 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5059 {
                    let _e5067 = atomicAdd((&counters[0u]), 1u);
                    phi_7509_ = _e5067;
                } else {
                    phi_7509_ = 0u;
                }
                let _e5069 = phi_7509_;
                workgroupBarrier();
                if (_e117 == 0u) {
                    let _e5072 = atomicLoad((&counters[0u]));
                    if (_e5072 > 0u) {
                        let _e5075 = atomicAdd((&contacts.member[0u]), _e5072);
                        atomicStore((&counters[1u]), _e5075);
                    }
                }
                workgroupBarrier();
                let _e5078 = atomicLoad((&counters[1u]));
                let _e5079 = (_e5078 + _e5069);
                if _e5059 {
                    let _e5081 = params.member.member_16;
                    if (_e5079 < _e5081) {
                        let _e5083 = (6u * _e5079);
                        atomicStore((&contacts.member[(4u + _e5083)]), _e5057.member);
                        atomicStore((&contacts.member[(_e5083 + 5u)]), _e5057.member_1);
                        atomicStore((&contacts.member[(_e5083 + 6u)]), _e5057.member_2);
                        atomicStore((&contacts.member[(_e5083 + 7u)]), _e5057.member_3);
                        atomicStore((&contacts.member[(_e5083 + 8u)]), _e5057.member_4[0]);
                        atomicStore((&contacts.member[(_e5083 + 9u)]), _e5057.member_4[1]);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_273_ = _e174;
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
    function_1();
}
