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

fn function_(param: f64) -> array<u32, 2> {
    let _e95 = bitcast<u64>(param);
    return array<u32, 2>(u32(_e95), u32((_e95 / 4294967296lu)));
}

fn function_1() {
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
    var phi_232_: u32;
    var phi_248_: u32;
    var phi_269_: u32;
    var phi_270_: u32;
    var phi_273_: type_28;
    var phi_274_: type_28;
    var phi_297_: type_28;
    var phi_640_: type_28;
    var phi_641_: type_28;
    var phi_664_: type_28;
    var phi_520_: type_28;
    var phi_521_: type_28;
    var phi_544_: type_28;
    var phi_554_: type_28;
    var phi_555_: type_28;
    var phi_578_: type_28;
    var phi_1121_: f64;
    var phi_1128_: f64;
    var phi_1133_: f64;
    var phi_1140_: f64;
    var phi_1145_: f64;
    var phi_1158_: f64;
    var phi_1165_: f64;
    var phi_1170_: f64;
    var phi_1177_: f64;
    var phi_1182_: f64;
    var phi_1187_: f64;
    var phi_1204_: f64;
    var phi_1211_: f64;
    var phi_1216_: f64;
    var phi_1223_: f64;
    var phi_1228_: f64;
    var phi_1242_: f64;
    var phi_1249_: f64;
    var phi_1254_: f64;
    var phi_1261_: f64;
    var phi_1266_: f64;
    var phi_1271_: f64;
    var phi_1288_: f64;
    var phi_1295_: f64;
    var phi_1300_: f64;
    var phi_1307_: f64;
    var phi_1312_: f64;
    var phi_1326_: f64;
    var phi_1333_: f64;
    var phi_1338_: f64;
    var phi_1345_: f64;
    var phi_1350_: f64;
    var phi_1355_: f64;
    var phi_1392_: f64;
    var phi_1398_: f64;
    var phi_1405_: f64;
    var phi_1412_: f64;
    var phi_1418_: f64;
    var phi_1425_: f64;
    var phi_1431_: f64;
    var phi_1437_: f64;
    var phi_1443_: f64;
    var phi_1450_: f64;
    var phi_1457_: f64;
    var phi_1485_: f64;
    var phi_1490_: f64;
    var phi_1495_: f64;
    var phi_1500_: f64;
    var phi_1505_: f64;
    var phi_1510_: f64;
    var phi_1521_: f64;
    var phi_4078_: f64;
    var phi_4084_: f64;
    var phi_4089_: f64;
    var phi_4095_: f64;
    var phi_4101_: f64;
    var phi_4106_: f64;
    var phi_4111_: f64;
    var phi_4121_: bool;
    var phi_4128_: f64;
    var phi_4136_: f64;
    var phi_4179_: type_26;
    var phi_4182_: f64;
    var phi_4203_: bool;
    var phi_4209_: type_27;
    var phi_4180_: type_26;
    var phi_4223_: type_27;
    var phi_4183_: f64;
    var local_21: f64;
    var phi_4172_: f64;
    var phi_4236_: f64;
    var phi_4242_: f64;
    var phi_4267_: type_28;
    var phi_4270_: u32;
    var phi_4268_: type_28;
    var phi_4293_: type_28;
    var phi_4337_: u32;
    var phi_4338_: u32;
    var phi_4271_: u32;
    var phi_4339_: u32;
    var phi_4359_: type_28;
    var phi_4360_: type_28;
    var phi_4383_: type_28;
    var phi_4437_: f64;
    var phi_4444_: f64;
    var phi_4456_: bool;
    var phi_4457_: bool;
    var phi_4458_: bool;
    var phi_4459_: bool;
    var phi_4463_: bool;
    var phi_4475_: type_73;
    var phi_4476_: type_73;
    var phi_4477_: bool;
    var phi_4478_: type_73;
    var phi_4479_: bool;
    var phi_4492_: f64;
    var phi_4505_: type_28;
    var phi_4508_: f64;
    var phi_4510_: f64;
    var phi_4512_: f64;
    var phi_4506_: type_28;
    var phi_4535_: type_28;
    var phi_4562_: f64;
    var phi_4563_: f64;
    var phi_4591_: f64;
    var phi_4607_: f64;
    var phi_4614_: bool;
    var phi_4615_: bool;
    var phi_4616_: bool;
    var phi_4622_: f64;
    var phi_4623_: f64;
    var phi_4624_: bool;
    var phi_4509_: f64;
    var phi_4511_: f64;
    var phi_4513_: f64;
    var phi_4625_: f64;
    var phi_4626_: bool;
    var phi_4627_: bool;
    var local_22: bool;
    var phi_4631_: f64;
    var phi_4632_: f64;
    var phi_4640_: type_28;
    var phi_4643_: f64;
    var phi_4641_: type_28;
    var phi_4666_: type_28;
    var phi_4709_: f64;
    var phi_4719_: f64;
    var phi_4729_: bool;
    var phi_4731_: bool;
    var phi_4736_: f64;
    var phi_4737_: bool;
    var phi_4738_: f64;
    var phi_4739_: bool;
    var phi_4740_: bool;
    var phi_4741_: bool;
    var phi_4742_: f64;
    var phi_4644_: f64;
    var phi_4743_: bool;
    var phi_4744_: bool;
    var phi_4745_: bool;
    var phi_4746_: bool;
    var local_23: bool;
    var phi_4750_: bool;
    var phi_4751_: bool;
    var phi_4755_: bool;
    var phi_4759_: f64;
    var phi_4760_: f64;
    var phi_4762_: type_73;
    var phi_4793_: f64;
    var phi_4800_: f64;
    var phi_4805_: f64;
    var phi_4812_: f64;
    var phi_4817_: f64;
    var phi_4830_: f64;
    var phi_4837_: f64;
    var phi_4842_: f64;
    var phi_4849_: f64;
    var phi_4854_: f64;
    var phi_4859_: f64;
    var phi_4918_: f64;
    var phi_4924_: f64;
    var phi_4929_: f64;
    var phi_4935_: f64;
    var phi_4940_: f64;
    var phi_4954_: f64;
    var phi_4960_: f64;
    var phi_4965_: f64;
    var phi_4971_: f64;
    var phi_4976_: f64;
    var phi_5002_: f64;
    var phi_5009_: f64;
    var phi_5014_: f64;
    var phi_5021_: f64;
    var phi_5026_: f64;
    var phi_5039_: f64;
    var phi_5046_: f64;
    var phi_5051_: f64;
    var phi_5058_: f64;
    var phi_5063_: f64;
    var phi_5068_: f64;
    var phi_5127_: f64;
    var phi_5133_: f64;
    var phi_5138_: f64;
    var phi_5144_: f64;
    var phi_5149_: f64;
    var phi_5163_: f64;
    var phi_5169_: f64;
    var phi_5174_: f64;
    var phi_5180_: f64;
    var phi_5185_: f64;
    var phi_5211_: f64;
    var phi_5218_: f64;
    var phi_5223_: f64;
    var phi_5230_: f64;
    var phi_5235_: f64;
    var phi_5248_: f64;
    var phi_5255_: f64;
    var phi_5260_: f64;
    var phi_5267_: f64;
    var phi_5272_: f64;
    var phi_5277_: f64;
    var phi_5336_: f64;
    var phi_5342_: f64;
    var phi_5347_: f64;
    var phi_5353_: f64;
    var phi_5358_: f64;
    var phi_5372_: f64;
    var phi_5378_: f64;
    var phi_5383_: f64;
    var phi_5389_: f64;
    var phi_5394_: f64;
    var phi_5443_: f64;
    var phi_5449_: f64;
    var phi_5477_: f64;
    var phi_5483_: f64;
    var phi_5488_: u32;
    var phi_5489_: u32;
    var phi_5459_: f64;
    var phi_5465_: f64;
    var phi_5470_: u32;
    var phi_5471_: u32;
    var phi_5490_: u32;
    var phi_5491_: u32;
    var phi_5562_: f64;
    var phi_5574_: f64;
    var phi_5713_: f64;
    var phi_5719_: f64;
    var phi_5726_: f64;
    var phi_5770_: type_28;
    var phi_5773_: bool;
    var phi_5771_: type_28;
    var phi_5796_: type_28;
    var phi_5823_: bool;
    var phi_5824_: bool;
    var phi_5774_: bool;
    var phi_5825_: bool;
    var phi_5826_: bool;
    var local_24: bool;
    var phi_5830_: bool;
    var local_25: bool;
    var phi_5837_: u32;
    var phi_5838_: u32;
    var phi_5839_: bool;
    var phi_5840_: u32;
    var phi_5841_: u32;
    var phi_5842_: bool;
    var phi_5846_: u32;
    var phi_5867_: bool;
    var phi_5868_: bool;
    var phi_5869_: bool;
    var phi_6066_: f64;
    var phi_6073_: f64;
    var phi_6078_: f64;
    var phi_6085_: f64;
    var phi_6090_: f64;
    var phi_6103_: f64;
    var phi_6110_: f64;
    var phi_6115_: f64;
    var phi_6122_: f64;
    var phi_6127_: f64;
    var phi_6132_: f64;
    var phi_6149_: f64;
    var phi_6156_: f64;
    var phi_6161_: f64;
    var phi_6168_: f64;
    var phi_6173_: f64;
    var phi_6187_: f64;
    var phi_6194_: f64;
    var phi_6199_: f64;
    var phi_6206_: f64;
    var phi_6211_: f64;
    var phi_6216_: f64;
    var phi_6233_: f64;
    var phi_6240_: f64;
    var phi_6245_: f64;
    var phi_6252_: f64;
    var phi_6257_: f64;
    var phi_6271_: f64;
    var phi_6278_: f64;
    var phi_6283_: f64;
    var phi_6290_: f64;
    var phi_6295_: f64;
    var phi_6300_: f64;
    var phi_6320_: type_28;
    var phi_6323_: f64;
    var phi_6321_: type_28;
    var phi_6346_: type_28;
    var phi_6502_: bool;
    var phi_6503_: bool;
    var phi_6504_: bool;
    var phi_6505_: bool;
    var phi_6506_: bool;
    var phi_6507_: bool;
    var phi_6511_: bool;
    var phi_6551_: array<f64, 3>;
    var phi_6552_: bool;
    var phi_6553_: array<f64, 3>;
    var phi_6554_: bool;
    var phi_6587_: f64;
    var phi_6589_: f64;
    var phi_6619_: f64;
    var phi_6621_: f64;
    var phi_6651_: f64;
    var phi_6653_: f64;
    var phi_6686_: f64;
    var phi_6688_: f64;
    var phi_6843_: type_28;
    var phi_6846_: array<f64, 3>;
    var phi_6844_: type_28;
    var phi_6869_: type_28;
    var phi_6936_: array<f64, 3>;
    var phi_6847_: array<f64, 3>;
    var phi_6937_: array<f64, 3>;
    var phi_6944_: f64;
    var phi_6951_: f64;
    var phi_6959_: f64;
    var phi_7004_: type_26;
    var phi_7007_: f64;
    var phi_7028_: bool;
    var phi_7034_: type_27;
    var phi_7005_: type_26;
    var phi_7048_: type_27;
    var phi_7008_: f64;
    var local_26: f64;
    var phi_6997_: f64;
    var phi_7061_: f64;
    var phi_7074_: type_28;
    var phi_7077_: f64;
    var phi_7075_: type_28;
    var phi_7100_: type_28;
    var phi_7151_: f64;
    var phi_7157_: f64;
    var phi_7171_: bool;
    var phi_7172_: bool;
    var phi_7206_: f64;
    var phi_7207_: f64;
    var phi_7208_: f64;
    var phi_7209_: bool;
    var phi_7213_: bool;
    var phi_7214_: f64;
    var phi_7215_: bool;
    var phi_7216_: bool;
    var phi_7217_: bool;
    var phi_7218_: f64;
    var phi_7219_: bool;
    var phi_7220_: bool;
    var phi_7221_: bool;
    var phi_7078_: f64;
    var phi_7222_: bool;
    var phi_7223_: bool;
    var phi_7224_: bool;
    var phi_7225_: bool;
    var local_27: bool;
    var local_28: f64;
    var local_29: f64;
    var local_30: f64;
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
    var phi_7254_: bool;
    var phi_7255_: bool;
    var phi_7256_: f64;
    var phi_7257_: f64;
    var phi_7258_: bool;
    var phi_7259_: bool;
    var phi_7260_: bool;
    var phi_7261_: bool;
    var phi_7262_: bool;
    var phi_7263_: bool;
    var phi_7264_: bool;
    var phi_7265_: f64;
    var phi_7266_: f64;
    var phi_7267_: bool;
    var phi_7268_: bool;
    var phi_7269_: bool;
    var phi_7270_: bool;
    var phi_7271_: bool;
    var phi_7272_: bool;
    var phi_7273_: bool;
    var phi_7274_: bool;
    var phi_7275_: f64;
    var phi_6324_: f64;
    var phi_7276_: bool;
    var phi_7277_: bool;
    var phi_7278_: bool;
    var phi_7279_: bool;
    var phi_7280_: bool;
    var phi_7281_: bool;
    var phi_7282_: bool;
    var phi_7283_: bool;
    var phi_7284_: bool;
    var local_31: bool;
    var phi_7289_: type_72;
    var phi_7290_: bool;
    var phi_7291_: bool;
    var phi_7292_: bool;
    var phi_7293_: bool;
    var phi_7294_: bool;
    var phi_7295_: bool;
    var phi_7296_: bool;
    var phi_7300_: f64;
    var phi_7301_: bool;
    var phi_7302_: bool;
    var phi_7303_: bool;
    var phi_7304_: bool;
    var phi_7305_: bool;
    var phi_7306_: bool;
    var phi_7307_: bool;
    var phi_7312_: type_72;
    var phi_7313_: bool;
    var phi_7314_: bool;
    var phi_7315_: bool;
    var phi_7316_: bool;
    var phi_7317_: bool;
    var phi_7318_: bool;
    var local_32: f64;
    var phi_7323_: type_72;
    var phi_7324_: bool;
    var phi_7325_: bool;
    var phi_7326_: bool;
    var phi_7327_: bool;
    var phi_7328_: bool;
    var local_33: f64;
    var phi_7333_: type_72;
    var phi_7334_: bool;
    var phi_7335_: bool;
    var phi_7336_: bool;
    var phi_7337_: bool;
    var local_34: f64;
    var phi_7342_: type_72;
    var phi_7343_: bool;
    var phi_7344_: bool;
    var phi_7345_: bool;
    var phi_7346_: bool;
    var phi_7350_: type_72;
    var phi_7351_: bool;
    var phi_7352_: bool;
    var phi_7353_: bool;
    var phi_7357_: bool;
    var phi_7358_: bool;
    var phi_7362_: bool;
    var phi_7363_: bool;
    var phi_7367_: bool;
    var phi_7368_: bool;
    var local_35: f64;
    var phi_7373_: type_72;
    var phi_7374_: bool;
    var phi_7378_: type_72;
    var phi_7385_: bool;
    var phi_7386_: f64;
    var phi_7387_: bool;
    var phi_7388_: bool;
    var phi_7389_: bool;
    var phi_7390_: f64;
    var phi_7391_: bool;
    var phi_7392_: bool;
    var phi_7393_: bool;
    var phi_7394_: f64;
    var phi_7395_: bool;
    var phi_7396_: bool;
    var phi_7397_: bool;
    var phi_7398_: bool;
    var phi_7402_: bool;
    var phi_7403_: bool;
    var phi_7404_: bool;
    var phi_7405_: f64;
    var phi_7406_: type_73;
    var phi_7407_: bool;
    var phi_7408_: bool;
    var phi_7409_: bool;
    var phi_7410_: bool;
    var local_36: bool;
    var phi_7415_: type_72;
    var phi_7416_: bool;
    var phi_7417_: bool;
    var local_37: f64;
    var phi_7422_: type_72;
    var phi_7423_: bool;
    var local_38: type_73;
    var phi_7429_: type_72;
    var phi_7430_: bool;
    var phi_7434_: type_72;
    var phi_1724_: f64;
    var phi_1731_: f64;
    var phi_1736_: f64;
    var phi_1743_: f64;
    var phi_1748_: f64;
    var phi_1761_: f64;
    var phi_1768_: f64;
    var phi_1773_: f64;
    var phi_1780_: f64;
    var phi_1785_: f64;
    var phi_1790_: f64;
    var phi_1807_: f64;
    var phi_1814_: f64;
    var phi_1819_: f64;
    var phi_1826_: f64;
    var phi_1831_: f64;
    var phi_1845_: f64;
    var phi_1852_: f64;
    var phi_1857_: f64;
    var phi_1864_: f64;
    var phi_1869_: f64;
    var phi_1874_: f64;
    var phi_1891_: f64;
    var phi_1898_: f64;
    var phi_1903_: f64;
    var phi_1910_: f64;
    var phi_1915_: f64;
    var phi_1929_: f64;
    var phi_1936_: f64;
    var phi_1941_: f64;
    var phi_1948_: f64;
    var phi_1953_: f64;
    var phi_1958_: f64;
    var phi_1978_: type_28;
    var phi_1981_: f64;
    var phi_1979_: type_28;
    var phi_2004_: type_28;
    var phi_2160_: bool;
    var phi_2161_: bool;
    var phi_2162_: bool;
    var phi_2163_: bool;
    var phi_2164_: bool;
    var phi_2165_: bool;
    var phi_2169_: bool;
    var phi_2209_: array<f64, 3>;
    var phi_2210_: bool;
    var phi_2211_: array<f64, 3>;
    var phi_2212_: bool;
    var phi_2245_: f64;
    var phi_2247_: f64;
    var phi_2277_: f64;
    var phi_2279_: f64;
    var phi_2309_: f64;
    var phi_2311_: f64;
    var phi_2344_: f64;
    var phi_2346_: f64;
    var phi_2501_: type_28;
    var phi_2504_: array<f64, 3>;
    var phi_2502_: type_28;
    var phi_2527_: type_28;
    var phi_2594_: array<f64, 3>;
    var phi_2505_: array<f64, 3>;
    var phi_2595_: array<f64, 3>;
    var phi_2602_: f64;
    var phi_2609_: f64;
    var phi_2617_: f64;
    var phi_2662_: type_26;
    var phi_2665_: f64;
    var phi_2686_: bool;
    var phi_2692_: type_27;
    var phi_2663_: type_26;
    var phi_2706_: type_27;
    var phi_2666_: f64;
    var local_39: f64;
    var phi_2655_: f64;
    var phi_2719_: f64;
    var phi_2732_: type_28;
    var phi_2735_: f64;
    var phi_2733_: type_28;
    var phi_2758_: type_28;
    var phi_2809_: f64;
    var phi_2815_: f64;
    var phi_2829_: bool;
    var phi_2830_: bool;
    var phi_2864_: f64;
    var phi_2865_: f64;
    var phi_2866_: f64;
    var phi_2867_: bool;
    var phi_2871_: bool;
    var phi_2872_: f64;
    var phi_2873_: bool;
    var phi_2874_: bool;
    var phi_2875_: bool;
    var phi_2876_: f64;
    var phi_2877_: bool;
    var phi_2878_: bool;
    var phi_2879_: bool;
    var phi_2736_: f64;
    var phi_2880_: bool;
    var phi_2881_: bool;
    var phi_2882_: bool;
    var phi_2883_: bool;
    var local_40: bool;
    var local_41: f64;
    var local_42: f64;
    var local_43: f64;
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
    var phi_2912_: bool;
    var phi_2913_: bool;
    var phi_2914_: f64;
    var phi_2915_: f64;
    var phi_2916_: bool;
    var phi_2917_: bool;
    var phi_2918_: bool;
    var phi_2919_: bool;
    var phi_2920_: bool;
    var phi_2921_: bool;
    var phi_2922_: bool;
    var phi_2923_: f64;
    var phi_2924_: f64;
    var phi_2925_: bool;
    var phi_2926_: bool;
    var phi_2927_: bool;
    var phi_2928_: bool;
    var phi_2929_: bool;
    var phi_2930_: bool;
    var phi_2931_: bool;
    var phi_2932_: bool;
    var phi_2933_: f64;
    var phi_1982_: f64;
    var phi_2934_: bool;
    var phi_2935_: bool;
    var phi_2936_: bool;
    var phi_2937_: bool;
    var phi_2938_: bool;
    var phi_2939_: bool;
    var phi_2940_: bool;
    var phi_2941_: bool;
    var phi_2942_: bool;
    var local_44: bool;
    var phi_2947_: type_72;
    var phi_2948_: bool;
    var phi_2949_: bool;
    var phi_2950_: bool;
    var phi_2951_: bool;
    var phi_2952_: bool;
    var phi_2953_: bool;
    var phi_2954_: bool;
    var phi_2958_: f64;
    var phi_2959_: bool;
    var phi_2960_: bool;
    var phi_2961_: bool;
    var phi_2962_: bool;
    var phi_2963_: bool;
    var phi_2964_: bool;
    var phi_2965_: bool;
    var phi_2970_: type_72;
    var phi_2971_: bool;
    var phi_2972_: bool;
    var phi_2973_: bool;
    var phi_2974_: bool;
    var phi_2975_: bool;
    var phi_2976_: bool;
    var local_45: f64;
    var phi_2981_: type_72;
    var phi_2982_: bool;
    var phi_2983_: bool;
    var phi_2984_: bool;
    var phi_2985_: bool;
    var phi_2986_: bool;
    var local_46: f64;
    var phi_2991_: type_72;
    var phi_2992_: bool;
    var phi_2993_: bool;
    var phi_2994_: bool;
    var phi_2995_: bool;
    var local_47: f64;
    var phi_3000_: type_72;
    var phi_3001_: bool;
    var phi_3002_: bool;
    var phi_3003_: bool;
    var phi_3004_: bool;
    var phi_3008_: type_72;
    var phi_3009_: bool;
    var phi_3010_: bool;
    var phi_3011_: bool;
    var phi_3015_: bool;
    var phi_3016_: bool;
    var phi_3020_: bool;
    var phi_3021_: bool;
    var phi_3025_: bool;
    var phi_3026_: bool;
    var local_48: f64;
    var phi_3031_: type_72;
    var phi_3032_: bool;
    var phi_3036_: type_72;
    var phi_3050_: type_28;
    var phi_3051_: type_28;
    var phi_3074_: type_28;
    var phi_3095_: f64;
    var phi_3245_: bool;
    var phi_3246_: bool;
    var phi_3247_: bool;
    var phi_3248_: bool;
    var phi_3249_: bool;
    var phi_3250_: bool;
    var phi_3254_: bool;
    var phi_3294_: array<f64, 3>;
    var phi_3295_: bool;
    var phi_3296_: array<f64, 3>;
    var phi_3297_: bool;
    var phi_3330_: f64;
    var phi_3332_: f64;
    var phi_3362_: f64;
    var phi_3364_: f64;
    var phi_3394_: f64;
    var phi_3396_: f64;
    var phi_3429_: f64;
    var phi_3431_: f64;
    var phi_3586_: type_28;
    var phi_3589_: array<f64, 3>;
    var phi_3587_: type_28;
    var phi_3612_: type_28;
    var phi_3679_: array<f64, 3>;
    var phi_3590_: array<f64, 3>;
    var phi_3680_: array<f64, 3>;
    var phi_3712_: type_26;
    var phi_3715_: f64;
    var phi_3736_: bool;
    var phi_3742_: type_27;
    var phi_3713_: type_26;
    var phi_3756_: type_27;
    var phi_3716_: f64;
    var local_49: f64;
    var phi_3705_: f64;
    var phi_3769_: f64;
    var phi_3787_: f64;
    var phi_3794_: f64;
    var phi_3799_: f64;
    var phi_3806_: f64;
    var phi_3811_: f64;
    var phi_3824_: f64;
    var phi_3831_: f64;
    var phi_3836_: f64;
    var phi_3843_: f64;
    var phi_3848_: f64;
    var phi_3853_: f64;
    var phi_3870_: f64;
    var phi_3877_: f64;
    var phi_3882_: f64;
    var phi_3889_: f64;
    var phi_3894_: f64;
    var phi_3908_: f64;
    var phi_3915_: f64;
    var phi_3920_: f64;
    var phi_3927_: f64;
    var phi_3932_: f64;
    var phi_3937_: f64;
    var phi_3954_: f64;
    var phi_3961_: f64;
    var phi_3966_: f64;
    var phi_3973_: f64;
    var phi_3978_: f64;
    var phi_3992_: f64;
    var phi_3999_: f64;
    var phi_4004_: f64;
    var phi_4011_: f64;
    var phi_4016_: f64;
    var phi_4021_: f64;
    var phi_4045_: bool;
    var phi_4046_: bool;
    var phi_4047_: bool;
    var local_50: bool;
    var phi_4052_: type_72;
    var phi_4053_: bool;
    var phi_4058_: type_72;
    var phi_4059_: bool;
    var phi_4061_: type_72;
    var phi_4062_: type_72;
    var phi_4063_: bool;
    var phi_4067_: type_72;
    var phi_7438_: type_72;
    var phi_7439_: type_72;
    var phi_7452_: type_46;
    var phi_7475_: u32;
    var phi_7479_: type_45;
    var phi_7480_: bool;
    var phi_7498_: u32;
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
    phi_273_ = type_28(0u, _e157);
    loop {
        let _e160 = phi_273_;
        if (_e160.member < _e160.member_1) {
            phi_274_ = type_28((_e160.member + 1u), _e160.member_1);
            phi_297_ = type_28(1u, _e160.member);
        } else {
            phi_274_ = _e160;
            phi_297_ = type_28(0u, type_28().member_1);
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
                    let _e260 = paths.member[_e197[0]];
                    let _e262 = paths.member[_e197[1]];
                    let _e268 = paths.member[_e199[0]];
                    let _e270 = paths.member[_e199[1]];
                    local_18 = array<array<f32, 3>, 4>(array<f32, 3>(_e260.member[0], _e260.member[1], _e260.member[2]), array<f32, 3>(_e262.member[0], _e262.member[1], _e262.member[2]), array<f32, 3>(_e268.member[0], _e268.member[1], _e268.member[2]), array<f32, 3>(_e270.member[0], _e270.member[1], _e270.member[2]));
                    local_19 = array<array<f32, 3>, 4>(array<f32, 3>(_e260.member_1[0], _e260.member_1[1], _e260.member_1[2]), array<f32, 3>(_e262.member_1[0], _e262.member_1[1], _e262.member_1[2]), array<f32, 3>(_e268.member_1[0], _e268.member_1[1], _e268.member_1[2]), array<f32, 3>(_e270.member_1[0], _e270.member_1[1], _e270.member_1[2]));
                    phi_520_ = type_28(0u, 4u);
                    loop {
                        let _e310 = phi_520_;
                        if (_e310.member < _e310.member_1) {
                            phi_521_ = type_28((_e310.member + 1u), _e310.member_1);
                            phi_544_ = type_28(1u, _e310.member);
                        } else {
                            phi_521_ = _e310;
                            phi_544_ = type_28(0u, type_28().member_1);
                        }
                        let _e324 = phi_521_;
                        let _e326 = phi_544_;
                        let _e330 = (bitcast<i32>(_e326.member) != 0i);
                        if _e330 {
                            phi_554_ = type_28(0u, 3u);
                            loop {
                                let _e332 = phi_554_;
                                if (_e332.member < _e332.member_1) {
                                    phi_555_ = type_28((_e332.member + 1u), _e332.member_1);
                                    phi_578_ = type_28(1u, _e332.member);
                                } else {
                                    phi_555_ = _e332;
                                    phi_578_ = type_28(0u, type_28().member_1);
                                }
                                let _e346 = phi_555_;
                                let _e348 = phi_578_;
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
                                    phi_554_ = _e346;
                                    break if !(_e352);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_520_ = _e324;
                            break if !(_e330);
                        }
                    }
                } else {
                    phi_640_ = type_28(0u, 4u);
                    loop {
                        let _e218 = phi_640_;
                        if (_e218.member < _e218.member_1) {
                            phi_641_ = type_28((_e218.member + 1u), _e218.member_1);
                            phi_664_ = type_28(1u, _e218.member);
                        } else {
                            phi_641_ = _e218;
                            phi_664_ = type_28(0u, type_28().member_1);
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
                            phi_640_ = _e232;
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
                    phi_1121_ = -(_e605[0]);
                } else {
                    phi_1121_ = _e605[0];
                }
                let _e612 = phi_1121_;
                if (_e605[1] < 0.0lf) {
                    phi_1128_ = -(_e605[1]);
                } else {
                    phi_1128_ = _e605[1];
                }
                let _e616 = phi_1128_;
                if (_e612 > _e616) {
                    phi_1133_ = _e612;
                } else {
                    phi_1133_ = _e616;
                }
                let _e619 = phi_1133_;
                if (_e605[2] < 0.0lf) {
                    phi_1140_ = -(_e605[2]);
                } else {
                    phi_1140_ = _e605[2];
                }
                let _e623 = phi_1140_;
                if (_e619 > _e623) {
                    phi_1145_ = _e619;
                } else {
                    phi_1145_ = _e623;
                }
                let _e626 = phi_1145_;
                let _e629 = local_20.member[1u];
                if (_e629[0] < 0.0lf) {
                    phi_1158_ = -(_e629[0]);
                } else {
                    phi_1158_ = _e629[0];
                }
                let _e636 = phi_1158_;
                if (_e629[1] < 0.0lf) {
                    phi_1165_ = -(_e629[1]);
                } else {
                    phi_1165_ = _e629[1];
                }
                let _e640 = phi_1165_;
                if (_e636 > _e640) {
                    phi_1170_ = _e636;
                } else {
                    phi_1170_ = _e640;
                }
                let _e643 = phi_1170_;
                if (_e629[2] < 0.0lf) {
                    phi_1177_ = -(_e629[2]);
                } else {
                    phi_1177_ = _e629[2];
                }
                let _e647 = phi_1177_;
                if (_e643 > _e647) {
                    phi_1182_ = _e643;
                } else {
                    phi_1182_ = _e647;
                }
                let _e650 = phi_1182_;
                if (_e626 > _e650) {
                    phi_1187_ = _e626;
                } else {
                    phi_1187_ = _e650;
                }
                let _e653 = phi_1187_;
                let _e655 = local_20.member_3;
                let _e656 = (_e653 + _e655);
                let _e659 = local_20.member_1[0u];
                if (_e659[0] < 0.0lf) {
                    phi_1204_ = -(_e659[0]);
                } else {
                    phi_1204_ = _e659[0];
                }
                let _e666 = phi_1204_;
                if (_e659[1] < 0.0lf) {
                    phi_1211_ = -(_e659[1]);
                } else {
                    phi_1211_ = _e659[1];
                }
                let _e670 = phi_1211_;
                if (_e666 > _e670) {
                    phi_1216_ = _e666;
                } else {
                    phi_1216_ = _e670;
                }
                let _e673 = phi_1216_;
                if (_e659[2] < 0.0lf) {
                    phi_1223_ = -(_e659[2]);
                } else {
                    phi_1223_ = _e659[2];
                }
                let _e677 = phi_1223_;
                if (_e673 > _e677) {
                    phi_1228_ = _e673;
                } else {
                    phi_1228_ = _e677;
                }
                let _e680 = phi_1228_;
                let _e683 = local_20.member_1[1u];
                if (_e683[0] < 0.0lf) {
                    phi_1242_ = -(_e683[0]);
                } else {
                    phi_1242_ = _e683[0];
                }
                let _e690 = phi_1242_;
                if (_e683[1] < 0.0lf) {
                    phi_1249_ = -(_e683[1]);
                } else {
                    phi_1249_ = _e683[1];
                }
                let _e694 = phi_1249_;
                if (_e690 > _e694) {
                    phi_1254_ = _e690;
                } else {
                    phi_1254_ = _e694;
                }
                let _e697 = phi_1254_;
                if (_e683[2] < 0.0lf) {
                    phi_1261_ = -(_e683[2]);
                } else {
                    phi_1261_ = _e683[2];
                }
                let _e701 = phi_1261_;
                if (_e697 > _e701) {
                    phi_1266_ = _e697;
                } else {
                    phi_1266_ = _e701;
                }
                let _e704 = phi_1266_;
                if (_e680 > _e704) {
                    phi_1271_ = _e680;
                } else {
                    phi_1271_ = _e704;
                }
                let _e707 = phi_1271_;
                let _e709 = local_20.member_3;
                let _e710 = (_e707 + _e709);
                let _e713 = local_20.member_2[0u];
                if (_e713[0] < 0.0lf) {
                    phi_1288_ = -(_e713[0]);
                } else {
                    phi_1288_ = _e713[0];
                }
                let _e720 = phi_1288_;
                if (_e713[1] < 0.0lf) {
                    phi_1295_ = -(_e713[1]);
                } else {
                    phi_1295_ = _e713[1];
                }
                let _e724 = phi_1295_;
                if (_e720 > _e724) {
                    phi_1300_ = _e720;
                } else {
                    phi_1300_ = _e724;
                }
                let _e727 = phi_1300_;
                if (_e713[2] < 0.0lf) {
                    phi_1307_ = -(_e713[2]);
                } else {
                    phi_1307_ = _e713[2];
                }
                let _e731 = phi_1307_;
                if (_e727 > _e731) {
                    phi_1312_ = _e727;
                } else {
                    phi_1312_ = _e731;
                }
                let _e734 = phi_1312_;
                let _e737 = local_20.member_2[1u];
                if (_e737[0] < 0.0lf) {
                    phi_1326_ = -(_e737[0]);
                } else {
                    phi_1326_ = _e737[0];
                }
                let _e744 = phi_1326_;
                if (_e737[1] < 0.0lf) {
                    phi_1333_ = -(_e737[1]);
                } else {
                    phi_1333_ = _e737[1];
                }
                let _e748 = phi_1333_;
                if (_e744 > _e748) {
                    phi_1338_ = _e744;
                } else {
                    phi_1338_ = _e748;
                }
                let _e751 = phi_1338_;
                if (_e737[2] < 0.0lf) {
                    phi_1345_ = -(_e737[2]);
                } else {
                    phi_1345_ = _e737[2];
                }
                let _e755 = phi_1345_;
                if (_e751 > _e755) {
                    phi_1350_ = _e751;
                } else {
                    phi_1350_ = _e755;
                }
                let _e758 = phi_1350_;
                if (_e734 > _e758) {
                    phi_1355_ = _e734;
                } else {
                    phi_1355_ = _e758;
                }
                let _e761 = phi_1355_;
                let _e763 = local_20.member_3;
                let _e764 = (_e761 + _e763);
                let _e765 = f64(1f);
                let _e766 = f64(8f);
                let _e768 = ((_e710 * _e766) * _e764);
                let _e776 = local_20.member_3;
                if (_e462 < 0.0lf) {
                    phi_1392_ = -(_e462);
                } else {
                    phi_1392_ = _e462;
                }
                let _e796 = phi_1392_;
                if (_e465 < 0.0lf) {
                    phi_1398_ = -(_e465);
                } else {
                    phi_1398_ = _e465;
                }
                let _e800 = phi_1398_;
                if (_e468 < 0.0lf) {
                    phi_1405_ = -(_e468);
                } else {
                    phi_1405_ = _e468;
                }
                let _e805 = phi_1405_;
                let _e806 = ((_e796 + _e800) + _e805);
                if (_e483 < 0.0lf) {
                    phi_1412_ = -(_e483);
                } else {
                    phi_1412_ = _e483;
                }
                let _e810 = phi_1412_;
                if (_e486 < 0.0lf) {
                    phi_1418_ = -(_e486);
                } else {
                    phi_1418_ = _e486;
                }
                let _e814 = phi_1418_;
                if (_e489 < 0.0lf) {
                    phi_1425_ = -(_e489);
                } else {
                    phi_1425_ = _e489;
                }
                let _e819 = phi_1425_;
                let _e820 = ((_e810 + _e814) + _e819);
                if (_e806 > _e820) {
                    phi_1431_ = _e806;
                } else {
                    phi_1431_ = _e820;
                }
                let _e823 = phi_1431_;
                if (_e532 < 0.0lf) {
                    phi_1437_ = -(_e532);
                } else {
                    phi_1437_ = _e532;
                }
                let _e827 = phi_1437_;
                if (_e533 < 0.0lf) {
                    phi_1443_ = -(_e533);
                } else {
                    phi_1443_ = _e533;
                }
                let _e831 = phi_1443_;
                if (_e534 < 0.0lf) {
                    phi_1450_ = -(_e534);
                } else {
                    phi_1450_ = _e534;
                }
                let _e836 = phi_1450_;
                let _e838 = (((_e827 + _e831) + _e836) * f64(0.5f));
                if (_e823 > _e838) {
                    phi_1457_ = _e823;
                } else {
                    phi_1457_ = _e838;
                }
                let _e841 = phi_1457_;
                let _e847 = local_20.member_3;
                let _e861 = (((((_e656 * _e766) * _e768) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e776 * f64(19f)) * ((_e656 * (_e710 + _e764)) + (_e710 * _e764)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e765 + _e656) * ((_e765 + _e710) * (_e765 + _e764)))));
                let _e862 = f64(3f);
                let _e863 = (_e545 * _e862);
                let _e864 = (_e602 * _e862);
                if (_e863 < _e864) {
                    phi_1485_ = _e863;
                } else {
                    phi_1485_ = _e864;
                }
                let _e867 = phi_1485_;
                if (_e568 < _e591) {
                    phi_1490_ = _e568;
                } else {
                    phi_1490_ = _e591;
                }
                let _e870 = phi_1490_;
                if (_e867 < _e870) {
                    phi_1495_ = _e867;
                } else {
                    phi_1495_ = _e870;
                }
                let _e873 = phi_1495_;
                if (_e863 > _e864) {
                    phi_1500_ = _e863;
                } else {
                    phi_1500_ = _e864;
                }
                let _e876 = phi_1500_;
                if (_e568 > _e591) {
                    phi_1505_ = _e568;
                } else {
                    phi_1505_ = _e591;
                }
                let _e879 = phi_1505_;
                if (_e876 > _e879) {
                    phi_1510_ = _e876;
                } else {
                    phi_1510_ = _e879;
                }
                let _e882 = phi_1510_;
                let _e888 = -(_e882);
                if (_e873 > _e888) {
                    phi_1521_ = _e873;
                } else {
                    phi_1521_ = _e888;
                }
                let _e891 = phi_1521_;
                if ((_e891 - (_e861 + ((_e446 * (((_e841 + (_e768 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e847 * f64(6f)) * (_e710 + _e764))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e765 + _e710) * (_e765 + _e764))))) * f64((3f * 1.0001f))))) > _e447) {
                    phi_7439_ = type_72(0u, type_72().member_1);
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
                            phi_1724_ = -(_e3374[0]);
                        } else {
                            phi_1724_ = _e3374[0];
                        }
                        let _e3381 = phi_1724_;
                        if (_e3374[1] < 0.0lf) {
                            phi_1731_ = -(_e3374[1]);
                        } else {
                            phi_1731_ = _e3374[1];
                        }
                        let _e3385 = phi_1731_;
                        if (_e3381 > _e3385) {
                            phi_1736_ = _e3381;
                        } else {
                            phi_1736_ = _e3385;
                        }
                        let _e3388 = phi_1736_;
                        if (_e3374[2] < 0.0lf) {
                            phi_1743_ = -(_e3374[2]);
                        } else {
                            phi_1743_ = _e3374[2];
                        }
                        let _e3392 = phi_1743_;
                        if (_e3388 > _e3392) {
                            phi_1748_ = _e3388;
                        } else {
                            phi_1748_ = _e3392;
                        }
                        let _e3395 = phi_1748_;
                        let _e3398 = local_20.member[1u];
                        if (_e3398[0] < 0.0lf) {
                            phi_1761_ = -(_e3398[0]);
                        } else {
                            phi_1761_ = _e3398[0];
                        }
                        let _e3405 = phi_1761_;
                        if (_e3398[1] < 0.0lf) {
                            phi_1768_ = -(_e3398[1]);
                        } else {
                            phi_1768_ = _e3398[1];
                        }
                        let _e3409 = phi_1768_;
                        if (_e3405 > _e3409) {
                            phi_1773_ = _e3405;
                        } else {
                            phi_1773_ = _e3409;
                        }
                        let _e3412 = phi_1773_;
                        if (_e3398[2] < 0.0lf) {
                            phi_1780_ = -(_e3398[2]);
                        } else {
                            phi_1780_ = _e3398[2];
                        }
                        let _e3416 = phi_1780_;
                        if (_e3412 > _e3416) {
                            phi_1785_ = _e3412;
                        } else {
                            phi_1785_ = _e3416;
                        }
                        let _e3419 = phi_1785_;
                        if (_e3395 > _e3419) {
                            phi_1790_ = _e3395;
                        } else {
                            phi_1790_ = _e3419;
                        }
                        let _e3422 = phi_1790_;
                        let _e3424 = local_20.member_3;
                        let _e3428 = local_20.member_1[0u];
                        if (_e3428[0] < 0.0lf) {
                            phi_1807_ = -(_e3428[0]);
                        } else {
                            phi_1807_ = _e3428[0];
                        }
                        let _e3435 = phi_1807_;
                        if (_e3428[1] < 0.0lf) {
                            phi_1814_ = -(_e3428[1]);
                        } else {
                            phi_1814_ = _e3428[1];
                        }
                        let _e3439 = phi_1814_;
                        if (_e3435 > _e3439) {
                            phi_1819_ = _e3435;
                        } else {
                            phi_1819_ = _e3439;
                        }
                        let _e3442 = phi_1819_;
                        if (_e3428[2] < 0.0lf) {
                            phi_1826_ = -(_e3428[2]);
                        } else {
                            phi_1826_ = _e3428[2];
                        }
                        let _e3446 = phi_1826_;
                        if (_e3442 > _e3446) {
                            phi_1831_ = _e3442;
                        } else {
                            phi_1831_ = _e3446;
                        }
                        let _e3449 = phi_1831_;
                        let _e3452 = local_20.member_1[1u];
                        if (_e3452[0] < 0.0lf) {
                            phi_1845_ = -(_e3452[0]);
                        } else {
                            phi_1845_ = _e3452[0];
                        }
                        let _e3459 = phi_1845_;
                        if (_e3452[1] < 0.0lf) {
                            phi_1852_ = -(_e3452[1]);
                        } else {
                            phi_1852_ = _e3452[1];
                        }
                        let _e3463 = phi_1852_;
                        if (_e3459 > _e3463) {
                            phi_1857_ = _e3459;
                        } else {
                            phi_1857_ = _e3463;
                        }
                        let _e3466 = phi_1857_;
                        if (_e3452[2] < 0.0lf) {
                            phi_1864_ = -(_e3452[2]);
                        } else {
                            phi_1864_ = _e3452[2];
                        }
                        let _e3470 = phi_1864_;
                        if (_e3466 > _e3470) {
                            phi_1869_ = _e3466;
                        } else {
                            phi_1869_ = _e3470;
                        }
                        let _e3473 = phi_1869_;
                        if (_e3449 > _e3473) {
                            phi_1874_ = _e3449;
                        } else {
                            phi_1874_ = _e3473;
                        }
                        let _e3476 = phi_1874_;
                        let _e3478 = local_20.member_3;
                        let _e3482 = local_20.member_2[0u];
                        if (_e3482[0] < 0.0lf) {
                            phi_1891_ = -(_e3482[0]);
                        } else {
                            phi_1891_ = _e3482[0];
                        }
                        let _e3489 = phi_1891_;
                        if (_e3482[1] < 0.0lf) {
                            phi_1898_ = -(_e3482[1]);
                        } else {
                            phi_1898_ = _e3482[1];
                        }
                        let _e3493 = phi_1898_;
                        if (_e3489 > _e3493) {
                            phi_1903_ = _e3489;
                        } else {
                            phi_1903_ = _e3493;
                        }
                        let _e3496 = phi_1903_;
                        if (_e3482[2] < 0.0lf) {
                            phi_1910_ = -(_e3482[2]);
                        } else {
                            phi_1910_ = _e3482[2];
                        }
                        let _e3500 = phi_1910_;
                        if (_e3496 > _e3500) {
                            phi_1915_ = _e3496;
                        } else {
                            phi_1915_ = _e3500;
                        }
                        let _e3503 = phi_1915_;
                        let _e3506 = local_20.member_2[1u];
                        if (_e3506[0] < 0.0lf) {
                            phi_1929_ = -(_e3506[0]);
                        } else {
                            phi_1929_ = _e3506[0];
                        }
                        let _e3513 = phi_1929_;
                        if (_e3506[1] < 0.0lf) {
                            phi_1936_ = -(_e3506[1]);
                        } else {
                            phi_1936_ = _e3506[1];
                        }
                        let _e3517 = phi_1936_;
                        if (_e3513 > _e3517) {
                            phi_1941_ = _e3513;
                        } else {
                            phi_1941_ = _e3517;
                        }
                        let _e3520 = phi_1941_;
                        if (_e3506[2] < 0.0lf) {
                            phi_1948_ = -(_e3506[2]);
                        } else {
                            phi_1948_ = _e3506[2];
                        }
                        let _e3524 = phi_1948_;
                        if (_e3520 > _e3524) {
                            phi_1953_ = _e3520;
                        } else {
                            phi_1953_ = _e3524;
                        }
                        let _e3527 = phi_1953_;
                        if (_e3503 > _e3527) {
                            phi_1958_ = _e3503;
                        } else {
                            phi_1958_ = _e3527;
                        }
                        let _e3530 = phi_1958_;
                        let _e3532 = local_20.member_3;
                        let _e3540 = local_20.member_3;
                        phi_1978_ = type_28(0u, 48u);
                        phi_1981_ = f64(0f);
                        loop {
                            let _e3549 = phi_1978_;
                            let _e3551 = phi_1981_;
                            local_87 = _e3551;
                            local_45 = _e3551;
                            local_46 = _e3551;
                            local_47 = _e3551;
                            local_48 = _e3551;
                            if (_e3549.member < _e3549.member_1) {
                                phi_1979_ = type_28((_e3549.member + 1u), _e3549.member_1);
                                phi_2004_ = type_28(1u, _e3549.member);
                            } else {
                                phi_1979_ = _e3549;
                                phi_2004_ = type_28(0u, type_28().member_1);
                            }
                            let _e3565 = phi_1979_;
                            let _e3567 = phi_2004_;
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
                                            phi_2160_ = (_e3671 <= _e3663);
                                            phi_2161_ = false;
                                        } else {
                                            phi_2160_ = bool();
                                            phi_2161_ = true;
                                        }
                                        let _e3677 = phi_2160_;
                                        let _e3679 = phi_2161_;
                                        phi_2162_ = _e3677;
                                        phi_2163_ = _e3679;
                                    } else {
                                        phi_2162_ = bool();
                                        phi_2163_ = true;
                                    }
                                    let _e3681 = phi_2162_;
                                    let _e3683 = phi_2163_;
                                    phi_2164_ = _e3681;
                                    phi_2165_ = _e3683;
                                } else {
                                    phi_2164_ = bool();
                                    phi_2165_ = true;
                                }
                                let _e3685 = phi_2164_;
                                let _e3687 = phi_2165_;
                                if _e3687 {
                                    phi_2169_ = false;
                                } else {
                                    phi_2169_ = _e3685;
                                }
                                let _e3689 = phi_2169_;
                                if (_e3661 > _e3662) {
                                    if _e3689 {
                                        phi_2209_ = array<f64, 3>((_e3589 - ((_e3610 * _e3667) + (_e3631 * _e3671))), (_e3590 - ((_e3611 * _e3667) + (_e3632 * _e3671))), (_e3591 - ((_e3612 * _e3667) + (_e3633 * _e3671))));
                                        phi_2210_ = false;
                                    } else {
                                        phi_2209_ = array<f64, 3>();
                                        phi_2210_ = true;
                                    }
                                    let _e3705 = phi_2209_;
                                    let _e3707 = phi_2210_;
                                    phi_2211_ = _e3705;
                                    phi_2212_ = _e3707;
                                } else {
                                    phi_2211_ = array<f64, 3>();
                                    phi_2212_ = true;
                                }
                                let _e3709 = phi_2211_;
                                let _e3711 = phi_2212_;
                                if _e3711 {
                                    let _e3712 = (_e3589 - _e3610);
                                    let _e3713 = (_e3590 - _e3611);
                                    let _e3714 = (_e3591 - _e3612);
                                    let _e3725 = ((((_e3589 * _e3610) + (_e3590 * _e3611)) + (_e3591 * _e3612)) / (((_e3610 * _e3610) + (_e3611 * _e3611)) + (_e3612 * _e3612)));
                                    if (_e3725 > f64(0f)) {
                                        if (_e3725 < f64(1f)) {
                                            phi_2245_ = _e3725;
                                        } else {
                                            phi_2245_ = f64(1f);
                                        }
                                        let _e3733 = phi_2245_;
                                        phi_2247_ = _e3733;
                                    } else {
                                        phi_2247_ = f64(0f);
                                    }
                                    let _e3735 = phi_2247_;
                                    let _e3752 = ((((_e3589 * _e3631) + (_e3590 * _e3632)) + (_e3591 * _e3633)) / (((_e3631 * _e3631) + (_e3632 * _e3632)) + (_e3633 * _e3633)));
                                    if (_e3752 > f64(0f)) {
                                        if (_e3752 < f64(1f)) {
                                            phi_2277_ = _e3752;
                                        } else {
                                            phi_2277_ = f64(1f);
                                        }
                                        let _e3760 = phi_2277_;
                                        phi_2279_ = _e3760;
                                    } else {
                                        phi_2279_ = f64(0f);
                                    }
                                    let _e3762 = phi_2279_;
                                    let _e3779 = ((((_e3712 * _e3631) + (_e3713 * _e3632)) + (_e3714 * _e3633)) / (((_e3631 * _e3631) + (_e3632 * _e3632)) + (_e3633 * _e3633)));
                                    if (_e3779 > f64(0f)) {
                                        if (_e3779 < f64(1f)) {
                                            phi_2309_ = _e3779;
                                        } else {
                                            phi_2309_ = f64(1f);
                                        }
                                        let _e3787 = phi_2309_;
                                        phi_2311_ = _e3787;
                                    } else {
                                        phi_2311_ = f64(0f);
                                    }
                                    let _e3789 = phi_2311_;
                                    let _e3796 = (_e3589 - _e3631);
                                    let _e3797 = (_e3590 - _e3632);
                                    let _e3798 = (_e3591 - _e3633);
                                    let _e3809 = ((((_e3796 * _e3610) + (_e3797 * _e3611)) + (_e3798 * _e3612)) / (((_e3610 * _e3610) + (_e3611 * _e3611)) + (_e3612 * _e3612)));
                                    if (_e3809 > f64(0f)) {
                                        if (_e3809 < f64(1f)) {
                                            phi_2344_ = _e3809;
                                        } else {
                                            phi_2344_ = f64(1f);
                                        }
                                        let _e3817 = phi_2344_;
                                        phi_2346_ = _e3817;
                                    } else {
                                        phi_2346_ = f64(0f);
                                    }
                                    let _e3819 = phi_2346_;
                                    local_11[0u] = array<f64, 3>((_e3589 - (_e3610 * _e3735)), (_e3590 - (_e3611 * _e3735)), (_e3591 - (_e3612 * _e3735)));
                                    local_11[1u] = array<f64, 3>((_e3589 - (_e3631 * _e3762)), (_e3590 - (_e3632 * _e3762)), (_e3591 - (_e3633 * _e3762)));
                                    local_11[2u] = array<f64, 3>((_e3712 - (_e3631 * _e3789)), (_e3713 - (_e3632 * _e3789)), (_e3714 - (_e3633 * _e3789)));
                                    local_11[3u] = array<f64, 3>((_e3796 - (_e3610 * _e3819)), (_e3797 - (_e3611 * _e3819)), (_e3798 - (_e3612 * _e3819)));
                                    let _e3835 = local_11[0u];
                                    phi_2501_ = type_28(1u, 4u);
                                    phi_2504_ = array<f64, 3>(_e3835[0], _e3835[1], _e3835[2]);
                                    loop {
                                        let _e3841 = phi_2501_;
                                        let _e3843 = phi_2504_;
                                        local_74 = _e3843;
                                        if (_e3841.member < _e3841.member_1) {
                                            phi_2502_ = type_28((_e3841.member + 1u), _e3841.member_1);
                                            phi_2527_ = type_28(1u, _e3841.member);
                                        } else {
                                            phi_2502_ = _e3841;
                                            phi_2527_ = type_28(0u, type_28().member_1);
                                        }
                                        let _e3857 = phi_2502_;
                                        let _e3859 = phi_2527_;
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
                                                phi_2594_ = array<f64, 3>(_e3895[0], _e3895[1], _e3895[2]);
                                            } else {
                                                phi_2594_ = _e3843;
                                            }
                                            let _e3901 = phi_2594_;
                                            phi_2505_ = _e3901;
                                        } else {
                                            phi_2505_ = array<f64, 3>();
                                        }
                                        let _e3903 = phi_2505_;
                                        continue;
                                        continuing {
                                            phi_2501_ = _e3857;
                                            phi_2504_ = _e3903;
                                            break if !(_e3863);
                                        }
                                    }
                                    let _e5717 = local_74;
                                    phi_2595_ = _e5717;
                                } else {
                                    phi_2595_ = _e3709;
                                }
                                let _e3906 = phi_2595_;
                                if (_e3906[0] < 0.0lf) {
                                    phi_2602_ = -(_e3906[0]);
                                } else {
                                    phi_2602_ = _e3906[0];
                                }
                                let _e3911 = phi_2602_;
                                if (_e3906[1] < 0.0lf) {
                                    phi_2609_ = -(_e3906[1]);
                                } else {
                                    phi_2609_ = _e3906[1];
                                }
                                let _e3916 = phi_2609_;
                                if (_e3906[2] < 0.0lf) {
                                    phi_2617_ = -(_e3906[2]);
                                } else {
                                    phi_2617_ = _e3906[2];
                                }
                                let _e3922 = phi_2617_;
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
                                                phi_2655_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2655_ = 0.0lf;
                                            }
                                            let _e3998 = phi_2655_;
                                            phi_2719_ = _e3998;
                                        } else {
                                            phi_2662_ = type_26(0i, 5i);
                                            phi_2665_ = bitcast<f64>(((bitcast<u64>(_e3940) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e3947 = phi_2662_;
                                                let _e3949 = phi_2665_;
                                                local_39 = _e3949;
                                                if (_e3947.member < _e3947.member_1) {
                                                    let _e3957 = (_e3947.member + 1i);
                                                    if ((false == (_e3957 > _e3947.member)) != false) {
                                                        phi_2686_ = true;
                                                    } else {
                                                        phi_2686_ = false;
                                                    }
                                                    let _e3962 = phi_2686_;
                                                    if _e3962 {
                                                        phi_2692_ = type_27(0u, type_27().member_1);
                                                    } else {
                                                        phi_2692_ = type_27(1u, _e3957);
                                                    }
                                                    let _e3968 = phi_2692_;
                                                    if (bitcast<i32>(_e3968.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2663_ = type_26(_e3968.member_1, _e3947.member_1);
                                                    phi_2706_ = type_27(1u, _e3947.member);
                                                } else {
                                                    phi_2663_ = _e3947;
                                                    phi_2706_ = type_27(0u, type_27().member_1);
                                                }
                                                let _e3978 = phi_2663_;
                                                let _e3980 = phi_2706_;
                                                let _e3983 = (bitcast<i32>(_e3980.member) != 0i);
                                                if _e3983 {
                                                    phi_2666_ = (0.5lf * (_e3949 + (_e3940 / _e3949)));
                                                } else {
                                                    phi_2666_ = f64();
                                                }
                                                let _e3988 = phi_2666_;
                                                continue;
                                                continuing {
                                                    phi_2662_ = _e3978;
                                                    phi_2665_ = _e3988;
                                                    break if !(_e3983);
                                                }
                                            }
                                            let _e3993 = local_39;
                                            phi_2719_ = (_e3993 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e4000 = phi_2719_;
                                        phi_2732_ = type_28(0u, 4u);
                                        phi_2735_ = f64(2f);
                                        loop {
                                            let _e4012 = phi_2732_;
                                            let _e4014 = phi_2735_;
                                            local_41 = _e4014;
                                            local_42 = _e4014;
                                            local_43 = _e4014;
                                            local_77 = _e4014;
                                            local_78 = _e4014;
                                            if (_e4012.member < _e4012.member_1) {
                                                phi_2733_ = type_28((_e4012.member + 1u), _e4012.member_1);
                                                phi_2758_ = type_28(1u, _e4012.member);
                                            } else {
                                                phi_2733_ = _e4012;
                                                phi_2758_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4028 = phi_2733_;
                                            let _e4030 = phi_2758_;
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
                                                    phi_2809_ = -(_e4045);
                                                } else {
                                                    phi_2809_ = _e4045;
                                                }
                                                let _e4060 = phi_2809_;
                                                if (_e4056 < 0.0lf) {
                                                    phi_2815_ = -(_e4056);
                                                } else {
                                                    phi_2815_ = _e4056;
                                                }
                                                let _e4064 = phi_2815_;
                                                let _e4069 = (((((((((_e3422 + _e3424) + (_e3476 + _e3478)) + (_e3530 + _e3532)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3540 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e446 * _e4000) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e4060 + _e4064) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e4045 > _e4069) {
                                                    if (_e4056 > _e4069) {
                                                        phi_2829_ = false;
                                                    } else {
                                                        phi_2829_ = true;
                                                    }
                                                    let _e4073 = phi_2829_;
                                                    phi_2830_ = _e4073;
                                                } else {
                                                    phi_2830_ = true;
                                                }
                                                let _e4075 = phi_2830_;
                                                if _e4075 {
                                                    if ((_e4045 + ((_e4056 - _e4045) * _e3551)) > _e4069) {
                                                        if (_e4056 < _e4045) {
                                                            let _e4084 = ((_e4045 - _e4056) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                            if _e4084 {
                                                                let _e4092 = (((_e4045 - _e4069) / (_e4045 - _e4056)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                if (_e4014 < _e4092) {
                                                                    phi_2864_ = _e4014;
                                                                } else {
                                                                    phi_2864_ = _e4092;
                                                                }
                                                                let _e4095 = phi_2864_;
                                                                phi_2865_ = _e4095;
                                                            } else {
                                                                phi_2865_ = f64();
                                                            }
                                                            let _e4097 = phi_2865_;
                                                            phi_2866_ = _e4097;
                                                            phi_2867_ = _e4084;
                                                        } else {
                                                            phi_2866_ = _e4014;
                                                            phi_2867_ = true;
                                                        }
                                                        let _e4099 = phi_2866_;
                                                        let _e4101 = phi_2867_;
                                                        if _e4101 {
                                                            phi_2871_ = false;
                                                        } else {
                                                            phi_2871_ = true;
                                                        }
                                                        let _e4103 = phi_2871_;
                                                        phi_2872_ = _e4099;
                                                        phi_2873_ = _e4101;
                                                        phi_2874_ = _e4103;
                                                        phi_2875_ = false;
                                                    } else {
                                                        phi_2872_ = f64();
                                                        phi_2873_ = false;
                                                        phi_2874_ = false;
                                                        phi_2875_ = true;
                                                    }
                                                    let _e4105 = phi_2872_;
                                                    let _e4107 = phi_2873_;
                                                    let _e4109 = phi_2874_;
                                                    let _e4111 = phi_2875_;
                                                    phi_2876_ = _e4105;
                                                    phi_2877_ = _e4107;
                                                    phi_2878_ = _e4109;
                                                    phi_2879_ = _e4111;
                                                } else {
                                                    phi_2876_ = _e4014;
                                                    phi_2877_ = true;
                                                    phi_2878_ = false;
                                                    phi_2879_ = false;
                                                }
                                                let _e4113 = phi_2876_;
                                                let _e4115 = phi_2877_;
                                                let _e4117 = phi_2878_;
                                                let _e4119 = phi_2879_;
                                                phi_2736_ = _e4113;
                                                phi_2880_ = _e4115;
                                                phi_2881_ = false;
                                                phi_2882_ = _e4117;
                                                phi_2883_ = _e4119;
                                            } else {
                                                phi_2736_ = f64();
                                                phi_2880_ = false;
                                                phi_2881_ = true;
                                                phi_2882_ = false;
                                                phi_2883_ = false;
                                            }
                                            let _e4121 = phi_2736_;
                                            let _e4123 = phi_2880_;
                                            let _e4125 = phi_2881_;
                                            let _e4127 = phi_2882_;
                                            let _e4129 = phi_2883_;
                                            local_40 = _e4125;
                                            local_75 = _e4127;
                                            local_76 = _e4129;
                                            continue;
                                            continuing {
                                                phi_2732_ = _e4028;
                                                phi_2735_ = _e4121;
                                                break if !(_e4123);
                                            }
                                        }
                                        let _e4132 = local_40;
                                        if _e4132 {
                                            let _e4134 = local_41;
                                            let _e4135 = (_e4134 > _e3308);
                                            if _e4135 {
                                                phi_2905_ = false;
                                                phi_2906_ = false;
                                                phi_2907_ = false;
                                            } else {
                                                let _e4137 = local_42;
                                                if (_e4137 > _e3551) {
                                                    let _e4140 = local_43;
                                                    let _e4143 = ((_e4140 - _e3551) < f64(0.00000000023283064f));
                                                    if _e4143 {
                                                        phi_2901_ = false;
                                                    } else {
                                                        phi_2901_ = true;
                                                    }
                                                    let _e4145 = phi_2901_;
                                                    phi_2902_ = _e4145;
                                                    phi_2903_ = _e4143;
                                                    phi_2904_ = false;
                                                } else {
                                                    phi_2902_ = false;
                                                    phi_2903_ = false;
                                                    phi_2904_ = true;
                                                }
                                                let _e4147 = phi_2902_;
                                                let _e4149 = phi_2903_;
                                                let _e4151 = phi_2904_;
                                                phi_2905_ = _e4147;
                                                phi_2906_ = _e4149;
                                                phi_2907_ = _e4151;
                                            }
                                            let _e4153 = phi_2905_;
                                            let _e4155 = phi_2906_;
                                            let _e4157 = phi_2907_;
                                            phi_2908_ = _e4153;
                                            phi_2909_ = _e4135;
                                            phi_2910_ = _e4155;
                                            phi_2911_ = _e4157;
                                            phi_2912_ = false;
                                            phi_2913_ = false;
                                        } else {
                                            phi_2908_ = false;
                                            phi_2909_ = false;
                                            phi_2910_ = false;
                                            phi_2911_ = false;
                                            let _e5774 = local_75;
                                            phi_2912_ = _e5774;
                                            let _e5777 = local_76;
                                            phi_2913_ = _e5777;
                                        }
                                        let _e4159 = phi_2908_;
                                        let _e4161 = phi_2909_;
                                        let _e4163 = phi_2910_;
                                        let _e4165 = phi_2911_;
                                        let _e4167 = phi_2912_;
                                        let _e4169 = phi_2913_;
                                        let _e5780 = local_77;
                                        phi_2914_ = _e5780;
                                        let _e5783 = local_78;
                                        phi_2915_ = _e5783;
                                        phi_2916_ = _e4159;
                                        phi_2917_ = _e4161;
                                        phi_2918_ = _e4163;
                                        phi_2919_ = _e4165;
                                        phi_2920_ = _e4167;
                                        phi_2921_ = _e4169;
                                        phi_2922_ = false;
                                    } else {
                                        phi_2914_ = f64();
                                        phi_2915_ = f64();
                                        phi_2916_ = false;
                                        phi_2917_ = false;
                                        phi_2918_ = false;
                                        phi_2919_ = false;
                                        phi_2920_ = false;
                                        phi_2921_ = false;
                                        phi_2922_ = true;
                                    }
                                    let _e4171 = phi_2914_;
                                    let _e4173 = phi_2915_;
                                    let _e4175 = phi_2916_;
                                    let _e4177 = phi_2917_;
                                    let _e4179 = phi_2918_;
                                    let _e4181 = phi_2919_;
                                    let _e4183 = phi_2920_;
                                    let _e4185 = phi_2921_;
                                    let _e4187 = phi_2922_;
                                    phi_2923_ = _e4171;
                                    phi_2924_ = _e4173;
                                    phi_2925_ = _e4175;
                                    phi_2926_ = _e4177;
                                    phi_2927_ = _e4179;
                                    phi_2928_ = _e4181;
                                    phi_2929_ = _e4183;
                                    phi_2930_ = _e4185;
                                    phi_2931_ = _e4187;
                                    phi_2932_ = false;
                                } else {
                                    phi_2923_ = f64();
                                    phi_2924_ = f64();
                                    phi_2925_ = false;
                                    phi_2926_ = false;
                                    phi_2927_ = false;
                                    phi_2928_ = false;
                                    phi_2929_ = false;
                                    phi_2930_ = false;
                                    phi_2931_ = false;
                                    phi_2932_ = true;
                                }
                                let _e4189 = phi_2923_;
                                let _e4191 = phi_2924_;
                                let _e4193 = phi_2925_;
                                let _e4195 = phi_2926_;
                                let _e4197 = phi_2927_;
                                let _e4199 = phi_2928_;
                                let _e4201 = phi_2929_;
                                let _e4203 = phi_2930_;
                                let _e4205 = phi_2931_;
                                let _e4207 = phi_2932_;
                                phi_2933_ = _e4189;
                                phi_1982_ = _e4191;
                                phi_2934_ = _e4193;
                                phi_2935_ = _e4195;
                                phi_2936_ = _e4197;
                                phi_2937_ = false;
                                phi_2938_ = _e4199;
                                phi_2939_ = _e4201;
                                phi_2940_ = _e4203;
                                phi_2941_ = _e4205;
                                phi_2942_ = _e4207;
                            } else {
                                phi_2933_ = f64();
                                phi_1982_ = f64();
                                phi_2934_ = false;
                                phi_2935_ = false;
                                phi_2936_ = false;
                                phi_2937_ = true;
                                phi_2938_ = false;
                                phi_2939_ = false;
                                phi_2940_ = false;
                                phi_2941_ = false;
                                phi_2942_ = false;
                            }
                            let _e4209 = phi_2933_;
                            let _e4211 = phi_1982_;
                            let _e4213 = phi_2934_;
                            let _e4215 = phi_2935_;
                            let _e4217 = phi_2936_;
                            let _e4219 = phi_2937_;
                            let _e4221 = phi_2938_;
                            let _e4223 = phi_2939_;
                            let _e4225 = phi_2940_;
                            let _e4227 = phi_2941_;
                            let _e4229 = phi_2942_;
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
                                phi_1978_ = _e3565;
                                phi_1981_ = _e4211;
                                break if !(_e4213);
                            }
                        }
                        let _e4232 = local_44;
                        if _e4232 {
                            phi_2947_ = type_72(0u, type_72().member_1);
                            phi_2948_ = false;
                            phi_2949_ = false;
                            phi_2950_ = false;
                            phi_2951_ = false;
                            phi_2952_ = false;
                            phi_2953_ = false;
                            phi_2954_ = false;
                        } else {
                            phi_2947_ = type_72();
                            let _e5816 = local_79;
                            phi_2948_ = _e5816;
                            let _e5819 = local_80;
                            phi_2949_ = _e5819;
                            let _e5822 = local_81;
                            phi_2950_ = _e5822;
                            let _e5825 = local_82;
                            phi_2951_ = _e5825;
                            let _e5828 = local_83;
                            phi_2952_ = _e5828;
                            let _e5831 = local_84;
                            phi_2953_ = _e5831;
                            let _e5834 = local_85;
                            phi_2954_ = _e5834;
                        }
                        let _e4237 = phi_2947_;
                        let _e4239 = phi_2948_;
                        let _e4241 = phi_2949_;
                        let _e4243 = phi_2950_;
                        let _e4245 = phi_2951_;
                        let _e4247 = phi_2952_;
                        let _e4249 = phi_2953_;
                        let _e4251 = phi_2954_;
                        if _e4239 {
                            let _e5837 = local_86;
                            phi_2958_ = _e5837;
                            phi_2959_ = true;
                            phi_2960_ = false;
                            phi_2961_ = false;
                            phi_2962_ = false;
                            phi_2963_ = false;
                            phi_2964_ = false;
                            phi_2965_ = false;
                        } else {
                            let _e5839 = local_87;
                            phi_2958_ = _e5839;
                            phi_2959_ = _e4241;
                            phi_2960_ = _e4243;
                            phi_2961_ = _e4245;
                            phi_2962_ = _e4247;
                            let _e5846 = local_88;
                            phi_2963_ = _e5846;
                            phi_2964_ = _e4249;
                            phi_2965_ = _e4251;
                        }
                        let _e4253 = phi_2958_;
                        let _e4255 = phi_2959_;
                        let _e4257 = phi_2960_;
                        let _e4259 = phi_2961_;
                        let _e4261 = phi_2962_;
                        let _e4263 = phi_2963_;
                        let _e4265 = phi_2964_;
                        let _e4267 = phi_2965_;
                        if _e4255 {
                            phi_2970_ = type_72(1u, _e4253);
                            phi_2971_ = false;
                            phi_2972_ = false;
                            phi_2973_ = false;
                            phi_2974_ = false;
                            phi_2975_ = false;
                            phi_2976_ = false;
                        } else {
                            phi_2970_ = type_72();
                            phi_2971_ = _e4257;
                            phi_2972_ = _e4259;
                            phi_2973_ = _e4261;
                            phi_2974_ = _e4263;
                            phi_2975_ = _e4265;
                            phi_2976_ = _e4267;
                        }
                        let _e4270 = phi_2970_;
                        let _e4272 = phi_2971_;
                        let _e4274 = phi_2972_;
                        let _e4276 = phi_2973_;
                        let _e4278 = phi_2974_;
                        let _e4280 = phi_2975_;
                        let _e4282 = phi_2976_;
                        if _e4272 {
                            let _e4284 = local_45;
                            phi_2981_ = type_72(1u, _e4284);
                            phi_2982_ = false;
                            phi_2983_ = false;
                            phi_2984_ = true;
                            phi_2985_ = false;
                            phi_2986_ = false;
                        } else {
                            phi_2981_ = _e4237;
                            phi_2982_ = _e4274;
                            phi_2983_ = _e4276;
                            phi_2984_ = _e4278;
                            phi_2985_ = _e4280;
                            phi_2986_ = _e4282;
                        }
                        let _e4287 = phi_2981_;
                        let _e4289 = phi_2982_;
                        let _e4291 = phi_2983_;
                        let _e4293 = phi_2984_;
                        let _e4295 = phi_2985_;
                        let _e4297 = phi_2986_;
                        if _e4289 {
                            let _e4299 = local_46;
                            phi_2991_ = type_72(1u, _e4299);
                            phi_2992_ = false;
                            phi_2993_ = false;
                            phi_2994_ = false;
                            phi_2995_ = false;
                        } else {
                            phi_2991_ = type_72();
                            phi_2992_ = _e4291;
                            phi_2993_ = _e4293;
                            phi_2994_ = _e4295;
                            phi_2995_ = _e4297;
                        }
                        let _e4302 = phi_2991_;
                        let _e4304 = phi_2992_;
                        let _e4306 = phi_2993_;
                        let _e4308 = phi_2994_;
                        let _e4310 = phi_2995_;
                        if _e4304 {
                            let _e4312 = local_47;
                            phi_3000_ = type_72(1u, _e4312);
                            phi_3001_ = true;
                            phi_3002_ = false;
                            phi_3003_ = false;
                            phi_3004_ = false;
                        } else {
                            phi_3000_ = _e4302;
                            phi_3001_ = _e4289;
                            phi_3002_ = _e4306;
                            phi_3003_ = _e4308;
                            phi_3004_ = _e4310;
                        }
                        let _e4315 = phi_3000_;
                        let _e4317 = phi_3001_;
                        let _e4319 = phi_3002_;
                        let _e4321 = phi_3003_;
                        let _e4323 = phi_3004_;
                        if _e4317 {
                            phi_3008_ = _e4315;
                            phi_3009_ = true;
                            phi_3010_ = false;
                            phi_3011_ = false;
                        } else {
                            phi_3008_ = _e4287;
                            phi_3009_ = _e4319;
                            phi_3010_ = _e4321;
                            phi_3011_ = _e4323;
                        }
                        let _e4325 = phi_3008_;
                        let _e4327 = phi_3009_;
                        let _e4329 = phi_3010_;
                        let _e4331 = phi_3011_;
                        if _e4327 {
                            phi_3015_ = false;
                            phi_3016_ = false;
                        } else {
                            phi_3015_ = _e4329;
                            phi_3016_ = _e4331;
                        }
                        let _e4333 = phi_3015_;
                        let _e4335 = phi_3016_;
                        if _e4333 {
                            phi_3020_ = false;
                            phi_3021_ = false;
                        } else {
                            phi_3020_ = _e4335;
                            phi_3021_ = _e4327;
                        }
                        let _e4337 = phi_3020_;
                        let _e4339 = phi_3021_;
                        if _e4337 {
                            phi_3025_ = true;
                            phi_3026_ = false;
                        } else {
                            phi_3025_ = _e4333;
                            phi_3026_ = _e4339;
                        }
                        let _e4341 = phi_3025_;
                        let _e4343 = phi_3026_;
                        if _e4341 {
                            let _e4345 = local_48;
                            phi_3031_ = type_72(1u, _e4345);
                            phi_3032_ = true;
                        } else {
                            phi_3031_ = _e4325;
                            phi_3032_ = _e4343;
                        }
                        let _e4348 = phi_3031_;
                        let _e4350 = phi_3032_;
                        if _e4350 {
                            phi_3036_ = _e4348;
                        } else {
                            phi_3036_ = _e4270;
                        }
                        let _e4352 = phi_3036_;
                        if (_e4352.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_3050_ = type_28(0u, 3u);
                            loop {
                                let _e4365 = phi_3050_;
                                if (_e4365.member < _e4365.member_1) {
                                    phi_3051_ = type_28((_e4365.member + 1u), _e4365.member_1);
                                    phi_3074_ = type_28(1u, _e4365.member);
                                } else {
                                    phi_3051_ = _e4365;
                                    phi_3074_ = type_28(0u, type_28().member_1);
                                }
                                let _e4379 = phi_3051_;
                                let _e4381 = phi_3074_;
                                if (bitcast<i32>(_e4381.member) != 0i) {
                                    if (_e4381.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4388 = local_14[_e4381.member_1];
                                    let _e4390 = (_e4352.member_1 + f64(_e4388));
                                    if (_e4390 < _e3308) {
                                        phi_3095_ = _e4390;
                                    } else {
                                        phi_3095_ = _e3308;
                                    }
                                    let _e4393 = phi_3095_;
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
                                                phi_3245_ = (_e4494 <= _e4486);
                                                phi_3246_ = false;
                                            } else {
                                                phi_3245_ = bool();
                                                phi_3246_ = true;
                                            }
                                            let _e4500 = phi_3245_;
                                            let _e4502 = phi_3246_;
                                            phi_3247_ = _e4500;
                                            phi_3248_ = _e4502;
                                        } else {
                                            phi_3247_ = bool();
                                            phi_3248_ = true;
                                        }
                                        let _e4504 = phi_3247_;
                                        let _e4506 = phi_3248_;
                                        phi_3249_ = _e4504;
                                        phi_3250_ = _e4506;
                                    } else {
                                        phi_3249_ = bool();
                                        phi_3250_ = true;
                                    }
                                    let _e4508 = phi_3249_;
                                    let _e4510 = phi_3250_;
                                    if _e4510 {
                                        phi_3254_ = false;
                                    } else {
                                        phi_3254_ = _e4508;
                                    }
                                    let _e4512 = phi_3254_;
                                    if (_e4484 > _e4485) {
                                        if _e4512 {
                                            phi_3294_ = array<f64, 3>((_e4412 - ((_e4433 * _e4490) + (_e4454 * _e4494))), (_e4413 - ((_e4434 * _e4490) + (_e4455 * _e4494))), (_e4414 - ((_e4435 * _e4490) + (_e4456 * _e4494))));
                                            phi_3295_ = false;
                                        } else {
                                            phi_3294_ = array<f64, 3>();
                                            phi_3295_ = true;
                                        }
                                        let _e4528 = phi_3294_;
                                        let _e4530 = phi_3295_;
                                        phi_3296_ = _e4528;
                                        phi_3297_ = _e4530;
                                    } else {
                                        phi_3296_ = array<f64, 3>();
                                        phi_3297_ = true;
                                    }
                                    let _e4532 = phi_3296_;
                                    let _e4534 = phi_3297_;
                                    if _e4534 {
                                        let _e4535 = (_e4412 - _e4433);
                                        let _e4536 = (_e4413 - _e4434);
                                        let _e4537 = (_e4414 - _e4435);
                                        let _e4548 = ((((_e4412 * _e4433) + (_e4413 * _e4434)) + (_e4414 * _e4435)) / (((_e4433 * _e4433) + (_e4434 * _e4434)) + (_e4435 * _e4435)));
                                        if (_e4548 > f64(0f)) {
                                            if (_e4548 < f64(1f)) {
                                                phi_3330_ = _e4548;
                                            } else {
                                                phi_3330_ = f64(1f);
                                            }
                                            let _e4556 = phi_3330_;
                                            phi_3332_ = _e4556;
                                        } else {
                                            phi_3332_ = f64(0f);
                                        }
                                        let _e4558 = phi_3332_;
                                        let _e4575 = ((((_e4412 * _e4454) + (_e4413 * _e4455)) + (_e4414 * _e4456)) / (((_e4454 * _e4454) + (_e4455 * _e4455)) + (_e4456 * _e4456)));
                                        if (_e4575 > f64(0f)) {
                                            if (_e4575 < f64(1f)) {
                                                phi_3362_ = _e4575;
                                            } else {
                                                phi_3362_ = f64(1f);
                                            }
                                            let _e4583 = phi_3362_;
                                            phi_3364_ = _e4583;
                                        } else {
                                            phi_3364_ = f64(0f);
                                        }
                                        let _e4585 = phi_3364_;
                                        let _e4602 = ((((_e4535 * _e4454) + (_e4536 * _e4455)) + (_e4537 * _e4456)) / (((_e4454 * _e4454) + (_e4455 * _e4455)) + (_e4456 * _e4456)));
                                        if (_e4602 > f64(0f)) {
                                            if (_e4602 < f64(1f)) {
                                                phi_3394_ = _e4602;
                                            } else {
                                                phi_3394_ = f64(1f);
                                            }
                                            let _e4610 = phi_3394_;
                                            phi_3396_ = _e4610;
                                        } else {
                                            phi_3396_ = f64(0f);
                                        }
                                        let _e4612 = phi_3396_;
                                        let _e4619 = (_e4412 - _e4454);
                                        let _e4620 = (_e4413 - _e4455);
                                        let _e4621 = (_e4414 - _e4456);
                                        let _e4632 = ((((_e4619 * _e4433) + (_e4620 * _e4434)) + (_e4621 * _e4435)) / (((_e4433 * _e4433) + (_e4434 * _e4434)) + (_e4435 * _e4435)));
                                        if (_e4632 > f64(0f)) {
                                            if (_e4632 < f64(1f)) {
                                                phi_3429_ = _e4632;
                                            } else {
                                                phi_3429_ = f64(1f);
                                            }
                                            let _e4640 = phi_3429_;
                                            phi_3431_ = _e4640;
                                        } else {
                                            phi_3431_ = f64(0f);
                                        }
                                        let _e4642 = phi_3431_;
                                        local_10[0u] = array<f64, 3>((_e4412 - (_e4433 * _e4558)), (_e4413 - (_e4434 * _e4558)), (_e4414 - (_e4435 * _e4558)));
                                        local_10[1u] = array<f64, 3>((_e4412 - (_e4454 * _e4585)), (_e4413 - (_e4455 * _e4585)), (_e4414 - (_e4456 * _e4585)));
                                        local_10[2u] = array<f64, 3>((_e4535 - (_e4454 * _e4612)), (_e4536 - (_e4455 * _e4612)), (_e4537 - (_e4456 * _e4612)));
                                        local_10[3u] = array<f64, 3>((_e4619 - (_e4433 * _e4642)), (_e4620 - (_e4434 * _e4642)), (_e4621 - (_e4435 * _e4642)));
                                        let _e4658 = local_10[0u];
                                        phi_3586_ = type_28(1u, 4u);
                                        phi_3589_ = array<f64, 3>(_e4658[0], _e4658[1], _e4658[2]);
                                        loop {
                                            let _e4664 = phi_3586_;
                                            let _e4666 = phi_3589_;
                                            local_89 = _e4666;
                                            if (_e4664.member < _e4664.member_1) {
                                                phi_3587_ = type_28((_e4664.member + 1u), _e4664.member_1);
                                                phi_3612_ = type_28(1u, _e4664.member);
                                            } else {
                                                phi_3587_ = _e4664;
                                                phi_3612_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4680 = phi_3587_;
                                            let _e4682 = phi_3612_;
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
                                                    phi_3679_ = array<f64, 3>(_e4718[0], _e4718[1], _e4718[2]);
                                                } else {
                                                    phi_3679_ = _e4666;
                                                }
                                                let _e4724 = phi_3679_;
                                                phi_3590_ = _e4724;
                                            } else {
                                                phi_3590_ = array<f64, 3>();
                                            }
                                            let _e4726 = phi_3590_;
                                            continue;
                                            continuing {
                                                phi_3586_ = _e4680;
                                                phi_3589_ = _e4726;
                                                break if !(_e4686);
                                            }
                                        }
                                        let _e5920 = local_89;
                                        phi_3680_ = _e5920;
                                    } else {
                                        phi_3680_ = _e4532;
                                    }
                                    let _e4729 = phi_3680_;
                                    let _e4740 = (((_e4729[0] * _e4729[0]) + (_e4729[1] * _e4729[1])) + (_e4729[2] * _e4729[2]));
                                    if (_e4740 <= 2.2250738585072014e-308lf) {
                                        if (_e4740 > 0.0lf) {
                                            phi_3705_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3705_ = 0.0lf;
                                        }
                                        let _e4798 = phi_3705_;
                                        phi_3769_ = _e4798;
                                    } else {
                                        phi_3712_ = type_26(0i, 5i);
                                        phi_3715_ = bitcast<f64>(((bitcast<u64>(_e4740) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e4747 = phi_3712_;
                                            let _e4749 = phi_3715_;
                                            local_49 = _e4749;
                                            if (_e4747.member < _e4747.member_1) {
                                                let _e4757 = (_e4747.member + 1i);
                                                if ((false == (_e4757 > _e4747.member)) != false) {
                                                    phi_3736_ = true;
                                                } else {
                                                    phi_3736_ = false;
                                                }
                                                let _e4762 = phi_3736_;
                                                if _e4762 {
                                                    phi_3742_ = type_27(0u, type_27().member_1);
                                                } else {
                                                    phi_3742_ = type_27(1u, _e4757);
                                                }
                                                let _e4768 = phi_3742_;
                                                if (bitcast<i32>(_e4768.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3713_ = type_26(_e4768.member_1, _e4747.member_1);
                                                phi_3756_ = type_27(1u, _e4747.member);
                                            } else {
                                                phi_3713_ = _e4747;
                                                phi_3756_ = type_27(0u, type_27().member_1);
                                            }
                                            let _e4778 = phi_3713_;
                                            let _e4780 = phi_3756_;
                                            let _e4783 = (bitcast<i32>(_e4780.member) != 0i);
                                            if _e4783 {
                                                phi_3716_ = (0.5lf * (_e4749 + (_e4740 / _e4749)));
                                            } else {
                                                phi_3716_ = f64();
                                            }
                                            let _e4788 = phi_3716_;
                                            continue;
                                            continuing {
                                                phi_3712_ = _e4778;
                                                phi_3715_ = _e4788;
                                                break if !(_e4783);
                                            }
                                        }
                                        let _e4793 = local_49;
                                        phi_3769_ = (_e4793 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e4800 = phi_3769_;
                                    let _e4808 = local_20.member[0u];
                                    if (_e4808[0] < 0.0lf) {
                                        phi_3787_ = -(_e4808[0]);
                                    } else {
                                        phi_3787_ = _e4808[0];
                                    }
                                    let _e4815 = phi_3787_;
                                    if (_e4808[1] < 0.0lf) {
                                        phi_3794_ = -(_e4808[1]);
                                    } else {
                                        phi_3794_ = _e4808[1];
                                    }
                                    let _e4819 = phi_3794_;
                                    if (_e4815 > _e4819) {
                                        phi_3799_ = _e4815;
                                    } else {
                                        phi_3799_ = _e4819;
                                    }
                                    let _e4822 = phi_3799_;
                                    if (_e4808[2] < 0.0lf) {
                                        phi_3806_ = -(_e4808[2]);
                                    } else {
                                        phi_3806_ = _e4808[2];
                                    }
                                    let _e4826 = phi_3806_;
                                    if (_e4822 > _e4826) {
                                        phi_3811_ = _e4822;
                                    } else {
                                        phi_3811_ = _e4826;
                                    }
                                    let _e4829 = phi_3811_;
                                    let _e4832 = local_20.member[1u];
                                    if (_e4832[0] < 0.0lf) {
                                        phi_3824_ = -(_e4832[0]);
                                    } else {
                                        phi_3824_ = _e4832[0];
                                    }
                                    let _e4839 = phi_3824_;
                                    if (_e4832[1] < 0.0lf) {
                                        phi_3831_ = -(_e4832[1]);
                                    } else {
                                        phi_3831_ = _e4832[1];
                                    }
                                    let _e4843 = phi_3831_;
                                    if (_e4839 > _e4843) {
                                        phi_3836_ = _e4839;
                                    } else {
                                        phi_3836_ = _e4843;
                                    }
                                    let _e4846 = phi_3836_;
                                    if (_e4832[2] < 0.0lf) {
                                        phi_3843_ = -(_e4832[2]);
                                    } else {
                                        phi_3843_ = _e4832[2];
                                    }
                                    let _e4850 = phi_3843_;
                                    if (_e4846 > _e4850) {
                                        phi_3848_ = _e4846;
                                    } else {
                                        phi_3848_ = _e4850;
                                    }
                                    let _e4853 = phi_3848_;
                                    if (_e4829 > _e4853) {
                                        phi_3853_ = _e4829;
                                    } else {
                                        phi_3853_ = _e4853;
                                    }
                                    let _e4856 = phi_3853_;
                                    let _e4858 = local_20.member_3;
                                    let _e4862 = local_20.member_1[0u];
                                    if (_e4862[0] < 0.0lf) {
                                        phi_3870_ = -(_e4862[0]);
                                    } else {
                                        phi_3870_ = _e4862[0];
                                    }
                                    let _e4869 = phi_3870_;
                                    if (_e4862[1] < 0.0lf) {
                                        phi_3877_ = -(_e4862[1]);
                                    } else {
                                        phi_3877_ = _e4862[1];
                                    }
                                    let _e4873 = phi_3877_;
                                    if (_e4869 > _e4873) {
                                        phi_3882_ = _e4869;
                                    } else {
                                        phi_3882_ = _e4873;
                                    }
                                    let _e4876 = phi_3882_;
                                    if (_e4862[2] < 0.0lf) {
                                        phi_3889_ = -(_e4862[2]);
                                    } else {
                                        phi_3889_ = _e4862[2];
                                    }
                                    let _e4880 = phi_3889_;
                                    if (_e4876 > _e4880) {
                                        phi_3894_ = _e4876;
                                    } else {
                                        phi_3894_ = _e4880;
                                    }
                                    let _e4883 = phi_3894_;
                                    let _e4886 = local_20.member_1[1u];
                                    if (_e4886[0] < 0.0lf) {
                                        phi_3908_ = -(_e4886[0]);
                                    } else {
                                        phi_3908_ = _e4886[0];
                                    }
                                    let _e4893 = phi_3908_;
                                    if (_e4886[1] < 0.0lf) {
                                        phi_3915_ = -(_e4886[1]);
                                    } else {
                                        phi_3915_ = _e4886[1];
                                    }
                                    let _e4897 = phi_3915_;
                                    if (_e4893 > _e4897) {
                                        phi_3920_ = _e4893;
                                    } else {
                                        phi_3920_ = _e4897;
                                    }
                                    let _e4900 = phi_3920_;
                                    if (_e4886[2] < 0.0lf) {
                                        phi_3927_ = -(_e4886[2]);
                                    } else {
                                        phi_3927_ = _e4886[2];
                                    }
                                    let _e4904 = phi_3927_;
                                    if (_e4900 > _e4904) {
                                        phi_3932_ = _e4900;
                                    } else {
                                        phi_3932_ = _e4904;
                                    }
                                    let _e4907 = phi_3932_;
                                    if (_e4883 > _e4907) {
                                        phi_3937_ = _e4883;
                                    } else {
                                        phi_3937_ = _e4907;
                                    }
                                    let _e4910 = phi_3937_;
                                    let _e4912 = local_20.member_3;
                                    let _e4916 = local_20.member_2[0u];
                                    if (_e4916[0] < 0.0lf) {
                                        phi_3954_ = -(_e4916[0]);
                                    } else {
                                        phi_3954_ = _e4916[0];
                                    }
                                    let _e4923 = phi_3954_;
                                    if (_e4916[1] < 0.0lf) {
                                        phi_3961_ = -(_e4916[1]);
                                    } else {
                                        phi_3961_ = _e4916[1];
                                    }
                                    let _e4927 = phi_3961_;
                                    if (_e4923 > _e4927) {
                                        phi_3966_ = _e4923;
                                    } else {
                                        phi_3966_ = _e4927;
                                    }
                                    let _e4930 = phi_3966_;
                                    if (_e4916[2] < 0.0lf) {
                                        phi_3973_ = -(_e4916[2]);
                                    } else {
                                        phi_3973_ = _e4916[2];
                                    }
                                    let _e4934 = phi_3973_;
                                    if (_e4930 > _e4934) {
                                        phi_3978_ = _e4930;
                                    } else {
                                        phi_3978_ = _e4934;
                                    }
                                    let _e4937 = phi_3978_;
                                    let _e4940 = local_20.member_2[1u];
                                    if (_e4940[0] < 0.0lf) {
                                        phi_3992_ = -(_e4940[0]);
                                    } else {
                                        phi_3992_ = _e4940[0];
                                    }
                                    let _e4947 = phi_3992_;
                                    if (_e4940[1] < 0.0lf) {
                                        phi_3999_ = -(_e4940[1]);
                                    } else {
                                        phi_3999_ = _e4940[1];
                                    }
                                    let _e4951 = phi_3999_;
                                    if (_e4947 > _e4951) {
                                        phi_4004_ = _e4947;
                                    } else {
                                        phi_4004_ = _e4951;
                                    }
                                    let _e4954 = phi_4004_;
                                    if (_e4940[2] < 0.0lf) {
                                        phi_4011_ = -(_e4940[2]);
                                    } else {
                                        phi_4011_ = _e4940[2];
                                    }
                                    let _e4958 = phi_4011_;
                                    if (_e4954 > _e4958) {
                                        phi_4016_ = _e4954;
                                    } else {
                                        phi_4016_ = _e4958;
                                    }
                                    let _e4961 = phi_4016_;
                                    if (_e4937 > _e4961) {
                                        phi_4021_ = _e4937;
                                    } else {
                                        phi_4021_ = _e4961;
                                    }
                                    let _e4964 = phi_4021_;
                                    let _e4966 = local_20.member_3;
                                    let _e4974 = local_20.member_3;
                                    let _e4984 = (((_e4800 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e4856 + _e4858) + (_e4910 + _e4912)) + (_e4964 + _e4966)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4974 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e446);
                                    if _e4984 {
                                        phi_4045_ = false;
                                    } else {
                                        phi_4045_ = true;
                                    }
                                    let _e4986 = phi_4045_;
                                    phi_4046_ = _e4986;
                                    phi_4047_ = _e4984;
                                } else {
                                    phi_4046_ = false;
                                    phi_4047_ = false;
                                }
                                let _e4988 = phi_4046_;
                                let _e4990 = phi_4047_;
                                local_50 = _e4990;
                                continue;
                                continuing {
                                    phi_3050_ = _e4379;
                                    break if !(_e4988);
                                }
                            }
                            let _e4993 = local_50;
                            if _e4993 {
                                phi_4052_ = type_72(1u, _e4352.member_1);
                                phi_4053_ = false;
                            } else {
                                phi_4052_ = type_72();
                                phi_4053_ = true;
                            }
                            let _e4996 = phi_4052_;
                            let _e4998 = phi_4053_;
                            if _e4998 {
                                phi_4058_ = type_72(2u, _e4352.member_1);
                                phi_4059_ = false;
                            } else {
                                phi_4058_ = type_72();
                                phi_4059_ = true;
                            }
                            let _e5001 = phi_4058_;
                            let _e5003 = phi_4059_;
                            phi_4061_ = _e5001;
                            phi_4062_ = _e4996;
                            phi_4063_ = _e5003;
                        } else {
                            phi_4061_ = type_72();
                            phi_4062_ = type_72(0u, type_72().member_1);
                            phi_4063_ = true;
                        }
                        let _e5005 = phi_4061_;
                        let _e5007 = phi_4062_;
                        let _e5009 = phi_4063_;
                        if _e5009 {
                            phi_4067_ = _e5007;
                        } else {
                            phi_4067_ = _e5005;
                        }
                        let _e5011 = phi_4067_;
                        phi_7438_ = _e5011;
                    } else {
                        if (_e545 < 0.0lf) {
                            phi_4078_ = -(_e545);
                        } else {
                            phi_4078_ = _e545;
                        }
                        let _e900 = phi_4078_;
                        if (_e568 < 0.0lf) {
                            phi_4084_ = -(_e568);
                        } else {
                            phi_4084_ = _e568;
                        }
                        let _e904 = phi_4084_;
                        if (_e900 > _e904) {
                            phi_4089_ = _e900;
                        } else {
                            phi_4089_ = _e904;
                        }
                        let _e907 = phi_4089_;
                        if (_e591 < 0.0lf) {
                            phi_4095_ = -(_e591);
                        } else {
                            phi_4095_ = _e591;
                        }
                        let _e911 = phi_4095_;
                        if (_e602 < 0.0lf) {
                            phi_4101_ = -(_e602);
                        } else {
                            phi_4101_ = _e602;
                        }
                        let _e915 = phi_4101_;
                        if (_e911 > _e915) {
                            phi_4106_ = _e911;
                        } else {
                            phi_4106_ = _e915;
                        }
                        let _e918 = phi_4106_;
                        if (_e907 > _e918) {
                            phi_4111_ = _e907;
                        } else {
                            phi_4111_ = _e918;
                        }
                        let _e921 = phi_4111_;
                        let _e923 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e924 = f64(1f);
                        if (_e921 >= _e923) {
                            phi_4121_ = (_e921 <= (_e924 / _e923));
                        } else {
                            phi_4121_ = false;
                        }
                        let _e929 = phi_4121_;
                        if _e929 {
                            phi_4128_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_4128_ = f64(2f);
                        }
                        let _e934 = phi_4128_;
                        let _e936 = ((_e861 * f64(0.34f)) + (_e921 * _e934));
                        if _e929 {
                            phi_4136_ = (_e924 / _e921);
                        } else {
                            phi_4136_ = f64(0f);
                        }
                        let _e940 = phi_4136_;
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
                                    phi_4172_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4172_ = 0.0lf;
                                }
                                let _e1017 = phi_4172_;
                                phi_4236_ = _e1017;
                            } else {
                                phi_4179_ = type_26(0i, 5i);
                                phi_4182_ = bitcast<f64>(((bitcast<u64>(_e958) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e966 = phi_4179_;
                                    let _e968 = phi_4182_;
                                    local_21 = _e968;
                                    if (_e966.member < _e966.member_1) {
                                        let _e976 = (_e966.member + 1i);
                                        if ((false == (_e976 > _e966.member)) != false) {
                                            phi_4203_ = true;
                                        } else {
                                            phi_4203_ = false;
                                        }
                                        let _e981 = phi_4203_;
                                        if _e981 {
                                            phi_4209_ = type_27(0u, type_27().member_1);
                                        } else {
                                            phi_4209_ = type_27(1u, _e976);
                                        }
                                        let _e987 = phi_4209_;
                                        if (bitcast<i32>(_e987.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_4180_ = type_26(_e987.member_1, _e966.member_1);
                                        phi_4223_ = type_27(1u, _e966.member);
                                    } else {
                                        phi_4180_ = _e966;
                                        phi_4223_ = type_27(0u, type_27().member_1);
                                    }
                                    let _e997 = phi_4180_;
                                    let _e999 = phi_4223_;
                                    let _e1002 = (bitcast<i32>(_e999.member) != 0i);
                                    if _e1002 {
                                        phi_4183_ = (0.5lf * (_e968 + (_e958 / _e968)));
                                    } else {
                                        phi_4183_ = f64();
                                    }
                                    let _e1007 = phi_4183_;
                                    continue;
                                    continuing {
                                        phi_4179_ = _e997;
                                        phi_4182_ = _e1007;
                                        break if !(_e1002);
                                    }
                                }
                                let _e1012 = local_21;
                                phi_4236_ = (_e1012 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1019 = phi_4236_;
                            if (_e950 < _e941) {
                                phi_4242_ = -(_e1019);
                            } else {
                                phi_4242_ = _e1019;
                            }
                            let _e1023 = phi_4242_;
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
                            phi_4267_ = type_28(0u, 2u);
                            phi_4270_ = 1u;
                            loop {
                                let _e1044 = phi_4267_;
                                let _e1046 = phi_4270_;
                                local_51 = _e1046;
                                if (_e1044.member < _e1044.member_1) {
                                    phi_4268_ = type_28((_e1044.member + 1u), _e1044.member_1);
                                    phi_4293_ = type_28(1u, _e1044.member);
                                } else {
                                    phi_4268_ = _e1044;
                                    phi_4293_ = type_28(0u, type_28().member_1);
                                }
                                let _e1060 = phi_4268_;
                                let _e1062 = phi_4293_;
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
                                            phi_4337_ = (_e1046 + 1u);
                                        } else {
                                            phi_4337_ = _e1046;
                                        }
                                        let _e1082 = phi_4337_;
                                        phi_4338_ = _e1082;
                                    } else {
                                        phi_4338_ = _e1046;
                                    }
                                    let _e1084 = phi_4338_;
                                    phi_4271_ = _e1084;
                                } else {
                                    phi_4271_ = u32();
                                }
                                let _e1086 = phi_4271_;
                                continue;
                                continuing {
                                    phi_4267_ = _e1060;
                                    phi_4270_ = _e1086;
                                    break if !(_e1066);
                                }
                            }
                            let _e5198 = local_51;
                            phi_4339_ = _e5198;
                        } else {
                            phi_4339_ = 1u;
                        }
                        let _e1089 = phi_4339_;
                        if (_e1089 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e1089] = _e942;
                        let _e1092 = local_7;
                        local_9 = _e1092;
                        phi_4359_ = type_28(0u, _e1089);
                        loop {
                            let _e1095 = phi_4359_;
                            if (_e1095.member < _e1095.member_1) {
                                phi_4360_ = type_28((_e1095.member + 1u), _e1095.member_1);
                                phi_4383_ = type_28(1u, _e1095.member);
                            } else {
                                phi_4360_ = _e1095;
                                phi_4383_ = type_28(0u, type_28().member_1);
                            }
                            let _e1109 = phi_4360_;
                            let _e1111 = phi_4383_;
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
                                    phi_4437_ = -(_e1135);
                                } else {
                                    phi_4437_ = _e1135;
                                }
                                let _e1152 = phi_4437_;
                                let _e1153 = (_e1152 > _e936);
                                if (_e1148 < 0.0lf) {
                                    phi_4444_ = -(_e1148);
                                } else {
                                    phi_4444_ = _e1148;
                                }
                                let _e1157 = phi_4444_;
                                let _e1158 = (_e1157 > _e936);
                                let _e1159 = f64(0f);
                                if _e1153 {
                                    if _e1158 {
                                        phi_4456_ = ((_e1135 > _e1159) != (_e1148 > _e1159));
                                        phi_4457_ = false;
                                    } else {
                                        phi_4456_ = bool();
                                        phi_4457_ = true;
                                    }
                                    let _e1164 = phi_4456_;
                                    let _e1166 = phi_4457_;
                                    phi_4458_ = _e1164;
                                    phi_4459_ = _e1166;
                                } else {
                                    phi_4458_ = bool();
                                    phi_4459_ = true;
                                }
                                let _e1168 = phi_4458_;
                                let _e1170 = phi_4459_;
                                if _e1170 {
                                    phi_4463_ = false;
                                } else {
                                    phi_4463_ = _e1168;
                                }
                                let _e1172 = phi_4463_;
                                if _e1153 {
                                    if _e1158 {
                                        if _e1172 {
                                            phi_4475_ = type_73();
                                        } else {
                                            phi_4475_ = type_73(f64(1f), _e1159, _e1172);
                                        }
                                        let _e1176 = phi_4475_;
                                        phi_4476_ = _e1176;
                                        phi_4477_ = _e1172;
                                    } else {
                                        phi_4476_ = type_73();
                                        phi_4477_ = true;
                                    }
                                    let _e1178 = phi_4476_;
                                    let _e1180 = phi_4477_;
                                    phi_4478_ = _e1178;
                                    phi_4479_ = _e1180;
                                } else {
                                    phi_4478_ = type_73();
                                    phi_4479_ = true;
                                }
                                let _e1182 = phi_4478_;
                                let _e1184 = phi_4479_;
                                if _e1184 {
                                    if _e1153 {
                                        if (_e1135 < _e1159) {
                                            phi_4492_ = f64(-1f);
                                        } else {
                                            phi_4492_ = f64(1f);
                                        }
                                        let _e1189 = phi_4492_;
                                        let _e1190 = f64(0.00000000000022737368f);
                                        let _e1191 = f64(0.5f);
                                        let _e1192 = f64(3f);
                                        let _e1195 = (_e591 - _e568);
                                        phi_4505_ = type_28(0u, 64u);
                                        phi_4508_ = _e1122;
                                        phi_4510_ = _e1118;
                                        phi_4512_ = (_e1191 * (_e1118 + _e1122));
                                        loop {
                                            let _e1201 = phi_4505_;
                                            let _e1203 = phi_4508_;
                                            let _e1205 = phi_4510_;
                                            let _e1207 = phi_4512_;
                                            local_53 = _e1205;
                                            if (_e1201.member < _e1201.member_1) {
                                                phi_4506_ = type_28((_e1201.member + 1u), _e1201.member_1);
                                                phi_4535_ = type_28(1u, _e1201.member);
                                            } else {
                                                phi_4506_ = _e1201;
                                                phi_4535_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1221 = phi_4506_;
                                            let _e1223 = phi_4535_;
                                            if (bitcast<i32>(_e1223.member) != 0i) {
                                                let _e1228 = (f64(1f) - _e1207);
                                                let _e1241 = ((_e1189 * ((((_e545 * _e1228) + (_e568 * _e1207)) * (_e1228 * _e1228)) + (((_e591 * _e1228) + (_e602 * _e1207)) * (_e1207 * _e1207)))) - _e936);
                                                if (_e1241 > f64(0f)) {
                                                    phi_4562_ = _e1203;
                                                    phi_4563_ = _e1207;
                                                } else {
                                                    phi_4562_ = _e1207;
                                                    phi_4563_ = _e1205;
                                                }
                                                let _e1245 = phi_4562_;
                                                let _e1247 = phi_4563_;
                                                let _e1249 = ((_e1245 - _e1247) > _e1190);
                                                if _e1249 {
                                                    let _e1251 = (f64(1f) - _e1207);
                                                    let _e1263 = (-(_e1241) / (_e1189 * (((((_e568 - (_e1192 * _e545)) * _e1251) + (_e1195 * _e1207)) * _e1251) + (((_e1195 * _e1251) + (((_e1192 * _e602) - _e591) * _e1207)) * _e1207))));
                                                    if (_e1241 > f64(0f)) {
                                                        phi_4591_ = (_e1191 * _e1190);
                                                    } else {
                                                        phi_4591_ = -((_e1191 * _e1190));
                                                    }
                                                    let _e1270 = phi_4591_;
                                                    let _e1272 = ((_e1207 + _e1263) + _e1270);
                                                    if (_e1272 > _e1247) {
                                                        if (_e1272 < _e1245) {
                                                            if (_e1263 < 0.0lf) {
                                                                phi_4607_ = -(_e1263);
                                                            } else {
                                                                phi_4607_ = _e1263;
                                                            }
                                                            let _e1278 = phi_4607_;
                                                            if (_e1278 < (_e1191 * (_e1245 - _e1247))) {
                                                                phi_4614_ = false;
                                                            } else {
                                                                phi_4614_ = true;
                                                            }
                                                            let _e1283 = phi_4614_;
                                                            phi_4615_ = _e1283;
                                                        } else {
                                                            phi_4615_ = true;
                                                        }
                                                        let _e1285 = phi_4615_;
                                                        phi_4616_ = _e1285;
                                                    } else {
                                                        phi_4616_ = true;
                                                    }
                                                    let _e1287 = phi_4616_;
                                                    if _e1287 {
                                                        phi_4622_ = (_e1191 * (_e1247 + _e1245));
                                                    } else {
                                                        phi_4622_ = _e1272;
                                                    }
                                                    let _e1291 = phi_4622_;
                                                    phi_4623_ = _e1291;
                                                    phi_4624_ = false;
                                                } else {
                                                    phi_4623_ = f64();
                                                    phi_4624_ = true;
                                                }
                                                let _e1293 = phi_4623_;
                                                let _e1295 = phi_4624_;
                                                phi_4509_ = _e1245;
                                                phi_4511_ = _e1247;
                                                phi_4513_ = _e1293;
                                                phi_4625_ = _e1247;
                                                phi_4626_ = _e1249;
                                                phi_4627_ = _e1295;
                                            } else {
                                                phi_4509_ = f64();
                                                phi_4511_ = f64();
                                                phi_4513_ = f64();
                                                phi_4625_ = f64();
                                                phi_4626_ = false;
                                                phi_4627_ = false;
                                            }
                                            let _e1297 = phi_4509_;
                                            let _e1299 = phi_4511_;
                                            let _e1301 = phi_4513_;
                                            let _e1303 = phi_4625_;
                                            let _e1305 = phi_4626_;
                                            let _e1307 = phi_4627_;
                                            local_22 = _e1307;
                                            local_52 = _e1303;
                                            continue;
                                            continuing {
                                                phi_4505_ = _e1221;
                                                phi_4508_ = _e1297;
                                                phi_4510_ = _e1299;
                                                phi_4512_ = _e1301;
                                                break if !(_e1305);
                                            }
                                        }
                                        let _e1310 = local_22;
                                        if _e1310 {
                                            let _e5240 = local_52;
                                            phi_4631_ = _e5240;
                                        } else {
                                            let _e5242 = local_53;
                                            phi_4631_ = _e5242;
                                        }
                                        let _e1312 = phi_4631_;
                                        phi_4632_ = _e1312;
                                    } else {
                                        phi_4632_ = _e1118;
                                    }
                                    let _e1314 = phi_4632_;
                                    if _e1158 {
                                        phi_4640_ = type_28(0u, 64u);
                                        phi_4643_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1318 = phi_4640_;
                                            let _e1320 = phi_4643_;
                                            if (_e1318.member < _e1318.member_1) {
                                                phi_4641_ = type_28((_e1318.member + 1u), _e1318.member_1);
                                                phi_4666_ = type_28(1u, _e1318.member);
                                            } else {
                                                phi_4641_ = _e1318;
                                                phi_4666_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1334 = phi_4641_;
                                            let _e1336 = phi_4666_;
                                            if (bitcast<i32>(_e1336.member) != 0i) {
                                                let _e1340 = (_e1314 + _e1320);
                                                if (_e1340 < _e1122) {
                                                    let _e1343 = (f64(1f) - _e1340);
                                                    let _e1354 = ((((_e545 * _e1343) + (_e568 * _e1340)) * (_e1343 * _e1343)) + (((_e591 * _e1343) + (_e602 * _e1340)) * (_e1340 * _e1340)));
                                                    let _e1356 = (f64(1f) - _e1314);
                                                    let _e1367 = ((((_e545 * _e1356) + (_e568 * _e1314)) * (_e1356 * _e1356)) + (((_e591 * _e1356) + (_e602 * _e1314)) * (_e1314 * _e1314)));
                                                    if (_e1354 < 0.0lf) {
                                                        phi_4709_ = -(_e1354);
                                                    } else {
                                                        phi_4709_ = _e1354;
                                                    }
                                                    let _e1371 = phi_4709_;
                                                    if (_e1371 > _e936) {
                                                        if (_e1367 < 0.0lf) {
                                                            phi_4719_ = -(_e1367);
                                                        } else {
                                                            phi_4719_ = _e1367;
                                                        }
                                                        let _e1376 = phi_4719_;
                                                        if (_e1376 > _e936) {
                                                            phi_4729_ = ((_e1354 > f64(0f)) == (_e1367 > f64(0f)));
                                                        } else {
                                                            phi_4729_ = false;
                                                        }
                                                        let _e1384 = phi_4729_;
                                                        phi_4731_ = !(_e1384);
                                                    } else {
                                                        phi_4731_ = false;
                                                    }
                                                    let _e1387 = phi_4731_;
                                                    if _e1387 {
                                                        phi_4736_ = f64();
                                                        phi_4737_ = false;
                                                    } else {
                                                        phi_4736_ = (_e1320 + _e1320);
                                                        phi_4737_ = true;
                                                    }
                                                    let _e1390 = phi_4736_;
                                                    let _e1392 = phi_4737_;
                                                    phi_4738_ = _e1390;
                                                    phi_4739_ = _e1392;
                                                    phi_4740_ = _e1387;
                                                    phi_4741_ = false;
                                                } else {
                                                    phi_4738_ = f64();
                                                    phi_4739_ = false;
                                                    phi_4740_ = false;
                                                    phi_4741_ = true;
                                                }
                                                let _e1394 = phi_4738_;
                                                let _e1396 = phi_4739_;
                                                let _e1398 = phi_4740_;
                                                let _e1400 = phi_4741_;
                                                phi_4742_ = _e1340;
                                                phi_4644_ = _e1394;
                                                phi_4743_ = _e1396;
                                                phi_4744_ = _e1398;
                                                phi_4745_ = _e1400;
                                                phi_4746_ = false;
                                            } else {
                                                phi_4742_ = f64();
                                                phi_4644_ = f64();
                                                phi_4743_ = false;
                                                phi_4744_ = false;
                                                phi_4745_ = false;
                                                phi_4746_ = true;
                                            }
                                            let _e1402 = phi_4742_;
                                            let _e1404 = phi_4644_;
                                            let _e1406 = phi_4743_;
                                            let _e1408 = phi_4744_;
                                            let _e1410 = phi_4745_;
                                            let _e1412 = phi_4746_;
                                            local_23 = _e1408;
                                            local_54 = _e1410;
                                            local_55 = _e1412;
                                            local_56 = _e1402;
                                            continue;
                                            continuing {
                                                phi_4640_ = _e1334;
                                                phi_4643_ = _e1404;
                                                break if !(_e1406);
                                            }
                                        }
                                        let _e1415 = local_23;
                                        if _e1415 {
                                            phi_4750_ = false;
                                            phi_4751_ = false;
                                        } else {
                                            let _e5267 = local_54;
                                            phi_4750_ = _e5267;
                                            let _e5270 = local_55;
                                            phi_4751_ = _e5270;
                                        }
                                        let _e1417 = phi_4750_;
                                        let _e1419 = phi_4751_;
                                        if _e1417 {
                                            phi_4755_ = true;
                                        } else {
                                            phi_4755_ = _e1419;
                                        }
                                        let _e1421 = phi_4755_;
                                        if _e1421 {
                                            phi_4759_ = _e1122;
                                        } else {
                                            let _e5274 = local_56;
                                            phi_4759_ = _e5274;
                                        }
                                        let _e1423 = phi_4759_;
                                        phi_4760_ = _e1423;
                                    } else {
                                        phi_4760_ = _e1122;
                                    }
                                    let _e1425 = phi_4760_;
                                    phi_4762_ = type_73(_e1314, _e1425, _e1172);
                                } else {
                                    phi_4762_ = _e1182;
                                }
                                let _e1428 = phi_4762_;
                                if (_e1428.member > _e1428.member_1) {
                                    phi_7394_ = f64();
                                    phi_7395_ = true;
                                    phi_7396_ = false;
                                    phi_7397_ = false;
                                    phi_7398_ = false;
                                } else {
                                    let _e1436 = ((_e1428.member_1 - _e1428.member) * f64(0.5f));
                                    let _e1437 = (_e1428.member + _e1436);
                                    let _e1440 = (_e1436 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1442 = local_20.member_3;
                                    let _e1445 = local_20.member[0u];
                                    if (_e1445[0] < 0.0lf) {
                                        phi_4793_ = -(_e1445[0]);
                                    } else {
                                        phi_4793_ = _e1445[0];
                                    }
                                    let _e1452 = phi_4793_;
                                    if (_e1445[1] < 0.0lf) {
                                        phi_4800_ = -(_e1445[1]);
                                    } else {
                                        phi_4800_ = _e1445[1];
                                    }
                                    let _e1456 = phi_4800_;
                                    if (_e1452 > _e1456) {
                                        phi_4805_ = _e1452;
                                    } else {
                                        phi_4805_ = _e1456;
                                    }
                                    let _e1459 = phi_4805_;
                                    if (_e1445[2] < 0.0lf) {
                                        phi_4812_ = -(_e1445[2]);
                                    } else {
                                        phi_4812_ = _e1445[2];
                                    }
                                    let _e1463 = phi_4812_;
                                    if (_e1459 > _e1463) {
                                        phi_4817_ = _e1459;
                                    } else {
                                        phi_4817_ = _e1463;
                                    }
                                    let _e1466 = phi_4817_;
                                    let _e1468 = local_20.member[1u];
                                    if (_e1468[0] < 0.0lf) {
                                        phi_4830_ = -(_e1468[0]);
                                    } else {
                                        phi_4830_ = _e1468[0];
                                    }
                                    let _e1475 = phi_4830_;
                                    if (_e1468[1] < 0.0lf) {
                                        phi_4837_ = -(_e1468[1]);
                                    } else {
                                        phi_4837_ = _e1468[1];
                                    }
                                    let _e1479 = phi_4837_;
                                    if (_e1475 > _e1479) {
                                        phi_4842_ = _e1475;
                                    } else {
                                        phi_4842_ = _e1479;
                                    }
                                    let _e1482 = phi_4842_;
                                    if (_e1468[2] < 0.0lf) {
                                        phi_4849_ = -(_e1468[2]);
                                    } else {
                                        phi_4849_ = _e1468[2];
                                    }
                                    let _e1486 = phi_4849_;
                                    if (_e1482 > _e1486) {
                                        phi_4854_ = _e1482;
                                    } else {
                                        phi_4854_ = _e1486;
                                    }
                                    let _e1489 = phi_4854_;
                                    if (_e1466 > _e1489) {
                                        phi_4859_ = _e1466;
                                    } else {
                                        phi_4859_ = _e1489;
                                    }
                                    let _e1492 = phi_4859_;
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
                                        phi_4918_ = -(_e1523);
                                    } else {
                                        phi_4918_ = _e1523;
                                    }
                                    let _e1529 = phi_4918_;
                                    if (_e1524 < 0.0lf) {
                                        phi_4924_ = -(_e1524);
                                    } else {
                                        phi_4924_ = _e1524;
                                    }
                                    let _e1533 = phi_4924_;
                                    if (_e1529 > _e1533) {
                                        phi_4929_ = _e1529;
                                    } else {
                                        phi_4929_ = _e1533;
                                    }
                                    let _e1536 = phi_4929_;
                                    if (_e1525 < 0.0lf) {
                                        phi_4935_ = -(_e1525);
                                    } else {
                                        phi_4935_ = _e1525;
                                    }
                                    let _e1540 = phi_4935_;
                                    if (_e1536 > _e1540) {
                                        phi_4940_ = _e1536;
                                    } else {
                                        phi_4940_ = _e1540;
                                    }
                                    let _e1543 = phi_4940_;
                                    let _e1551 = ((((_e1440 * _e1543) * f64(1.01f)) + ((_e1492 + _e1442) * (1.1102230246251565e-16lf * f64(8f)))) + _e1442);
                                    if (_e1510 < 0.0lf) {
                                        phi_4954_ = -(_e1510);
                                    } else {
                                        phi_4954_ = _e1510;
                                    }
                                    let _e1555 = phi_4954_;
                                    if (_e1511 < 0.0lf) {
                                        phi_4960_ = -(_e1511);
                                    } else {
                                        phi_4960_ = _e1511;
                                    }
                                    let _e1559 = phi_4960_;
                                    if (_e1555 > _e1559) {
                                        phi_4965_ = _e1555;
                                    } else {
                                        phi_4965_ = _e1559;
                                    }
                                    let _e1562 = phi_4965_;
                                    if (_e1512 < 0.0lf) {
                                        phi_4971_ = -(_e1512);
                                    } else {
                                        phi_4971_ = _e1512;
                                    }
                                    let _e1566 = phi_4971_;
                                    if (_e1562 > _e1566) {
                                        phi_4976_ = _e1562;
                                    } else {
                                        phi_4976_ = _e1566;
                                    }
                                    let _e1569 = phi_4976_;
                                    local_3 = type_51(array<f64, 3>(_e1510, _e1511, _e1512), _e1551, (_e1569 + _e1551));
                                    let _e1575 = local_20.member_3;
                                    let _e1577 = local_20.member_1[0u];
                                    if (_e1577[0] < 0.0lf) {
                                        phi_5002_ = -(_e1577[0]);
                                    } else {
                                        phi_5002_ = _e1577[0];
                                    }
                                    let _e1584 = phi_5002_;
                                    if (_e1577[1] < 0.0lf) {
                                        phi_5009_ = -(_e1577[1]);
                                    } else {
                                        phi_5009_ = _e1577[1];
                                    }
                                    let _e1588 = phi_5009_;
                                    if (_e1584 > _e1588) {
                                        phi_5014_ = _e1584;
                                    } else {
                                        phi_5014_ = _e1588;
                                    }
                                    let _e1591 = phi_5014_;
                                    if (_e1577[2] < 0.0lf) {
                                        phi_5021_ = -(_e1577[2]);
                                    } else {
                                        phi_5021_ = _e1577[2];
                                    }
                                    let _e1595 = phi_5021_;
                                    if (_e1591 > _e1595) {
                                        phi_5026_ = _e1591;
                                    } else {
                                        phi_5026_ = _e1595;
                                    }
                                    let _e1598 = phi_5026_;
                                    let _e1600 = local_20.member_1[1u];
                                    if (_e1600[0] < 0.0lf) {
                                        phi_5039_ = -(_e1600[0]);
                                    } else {
                                        phi_5039_ = _e1600[0];
                                    }
                                    let _e1607 = phi_5039_;
                                    if (_e1600[1] < 0.0lf) {
                                        phi_5046_ = -(_e1600[1]);
                                    } else {
                                        phi_5046_ = _e1600[1];
                                    }
                                    let _e1611 = phi_5046_;
                                    if (_e1607 > _e1611) {
                                        phi_5051_ = _e1607;
                                    } else {
                                        phi_5051_ = _e1611;
                                    }
                                    let _e1614 = phi_5051_;
                                    if (_e1600[2] < 0.0lf) {
                                        phi_5058_ = -(_e1600[2]);
                                    } else {
                                        phi_5058_ = _e1600[2];
                                    }
                                    let _e1618 = phi_5058_;
                                    if (_e1614 > _e1618) {
                                        phi_5063_ = _e1614;
                                    } else {
                                        phi_5063_ = _e1618;
                                    }
                                    let _e1621 = phi_5063_;
                                    if (_e1598 > _e1621) {
                                        phi_5068_ = _e1598;
                                    } else {
                                        phi_5068_ = _e1621;
                                    }
                                    let _e1624 = phi_5068_;
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
                                        phi_5127_ = -(_e1655);
                                    } else {
                                        phi_5127_ = _e1655;
                                    }
                                    let _e1661 = phi_5127_;
                                    if (_e1656 < 0.0lf) {
                                        phi_5133_ = -(_e1656);
                                    } else {
                                        phi_5133_ = _e1656;
                                    }
                                    let _e1665 = phi_5133_;
                                    if (_e1661 > _e1665) {
                                        phi_5138_ = _e1661;
                                    } else {
                                        phi_5138_ = _e1665;
                                    }
                                    let _e1668 = phi_5138_;
                                    if (_e1657 < 0.0lf) {
                                        phi_5144_ = -(_e1657);
                                    } else {
                                        phi_5144_ = _e1657;
                                    }
                                    let _e1672 = phi_5144_;
                                    if (_e1668 > _e1672) {
                                        phi_5149_ = _e1668;
                                    } else {
                                        phi_5149_ = _e1672;
                                    }
                                    let _e1675 = phi_5149_;
                                    let _e1683 = ((((_e1440 * _e1675) * f64(1.01f)) + ((_e1624 + _e1575) * (1.1102230246251565e-16lf * f64(8f)))) + _e1575);
                                    if (_e1642 < 0.0lf) {
                                        phi_5163_ = -(_e1642);
                                    } else {
                                        phi_5163_ = _e1642;
                                    }
                                    let _e1687 = phi_5163_;
                                    if (_e1643 < 0.0lf) {
                                        phi_5169_ = -(_e1643);
                                    } else {
                                        phi_5169_ = _e1643;
                                    }
                                    let _e1691 = phi_5169_;
                                    if (_e1687 > _e1691) {
                                        phi_5174_ = _e1687;
                                    } else {
                                        phi_5174_ = _e1691;
                                    }
                                    let _e1694 = phi_5174_;
                                    if (_e1644 < 0.0lf) {
                                        phi_5180_ = -(_e1644);
                                    } else {
                                        phi_5180_ = _e1644;
                                    }
                                    let _e1698 = phi_5180_;
                                    if (_e1694 > _e1698) {
                                        phi_5185_ = _e1694;
                                    } else {
                                        phi_5185_ = _e1698;
                                    }
                                    let _e1701 = phi_5185_;
                                    local_4 = type_51(array<f64, 3>(_e1642, _e1643, _e1644), _e1683, (_e1701 + _e1683));
                                    let _e1707 = local_20.member_3;
                                    let _e1709 = local_20.member_2[0u];
                                    if (_e1709[0] < 0.0lf) {
                                        phi_5211_ = -(_e1709[0]);
                                    } else {
                                        phi_5211_ = _e1709[0];
                                    }
                                    let _e1716 = phi_5211_;
                                    if (_e1709[1] < 0.0lf) {
                                        phi_5218_ = -(_e1709[1]);
                                    } else {
                                        phi_5218_ = _e1709[1];
                                    }
                                    let _e1720 = phi_5218_;
                                    if (_e1716 > _e1720) {
                                        phi_5223_ = _e1716;
                                    } else {
                                        phi_5223_ = _e1720;
                                    }
                                    let _e1723 = phi_5223_;
                                    if (_e1709[2] < 0.0lf) {
                                        phi_5230_ = -(_e1709[2]);
                                    } else {
                                        phi_5230_ = _e1709[2];
                                    }
                                    let _e1727 = phi_5230_;
                                    if (_e1723 > _e1727) {
                                        phi_5235_ = _e1723;
                                    } else {
                                        phi_5235_ = _e1727;
                                    }
                                    let _e1730 = phi_5235_;
                                    let _e1732 = local_20.member_2[1u];
                                    if (_e1732[0] < 0.0lf) {
                                        phi_5248_ = -(_e1732[0]);
                                    } else {
                                        phi_5248_ = _e1732[0];
                                    }
                                    let _e1739 = phi_5248_;
                                    if (_e1732[1] < 0.0lf) {
                                        phi_5255_ = -(_e1732[1]);
                                    } else {
                                        phi_5255_ = _e1732[1];
                                    }
                                    let _e1743 = phi_5255_;
                                    if (_e1739 > _e1743) {
                                        phi_5260_ = _e1739;
                                    } else {
                                        phi_5260_ = _e1743;
                                    }
                                    let _e1746 = phi_5260_;
                                    if (_e1732[2] < 0.0lf) {
                                        phi_5267_ = -(_e1732[2]);
                                    } else {
                                        phi_5267_ = _e1732[2];
                                    }
                                    let _e1750 = phi_5267_;
                                    if (_e1746 > _e1750) {
                                        phi_5272_ = _e1746;
                                    } else {
                                        phi_5272_ = _e1750;
                                    }
                                    let _e1753 = phi_5272_;
                                    if (_e1730 > _e1753) {
                                        phi_5277_ = _e1730;
                                    } else {
                                        phi_5277_ = _e1753;
                                    }
                                    let _e1756 = phi_5277_;
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
                                        phi_5336_ = -(_e1787);
                                    } else {
                                        phi_5336_ = _e1787;
                                    }
                                    let _e1793 = phi_5336_;
                                    if (_e1788 < 0.0lf) {
                                        phi_5342_ = -(_e1788);
                                    } else {
                                        phi_5342_ = _e1788;
                                    }
                                    let _e1797 = phi_5342_;
                                    if (_e1793 > _e1797) {
                                        phi_5347_ = _e1793;
                                    } else {
                                        phi_5347_ = _e1797;
                                    }
                                    let _e1800 = phi_5347_;
                                    if (_e1789 < 0.0lf) {
                                        phi_5353_ = -(_e1789);
                                    } else {
                                        phi_5353_ = _e1789;
                                    }
                                    let _e1804 = phi_5353_;
                                    if (_e1800 > _e1804) {
                                        phi_5358_ = _e1800;
                                    } else {
                                        phi_5358_ = _e1804;
                                    }
                                    let _e1807 = phi_5358_;
                                    let _e1815 = ((((_e1440 * _e1807) * f64(1.01f)) + ((_e1756 + _e1707) * (1.1102230246251565e-16lf * f64(8f)))) + _e1707);
                                    if (_e1774 < 0.0lf) {
                                        phi_5372_ = -(_e1774);
                                    } else {
                                        phi_5372_ = _e1774;
                                    }
                                    let _e1819 = phi_5372_;
                                    if (_e1775 < 0.0lf) {
                                        phi_5378_ = -(_e1775);
                                    } else {
                                        phi_5378_ = _e1775;
                                    }
                                    let _e1823 = phi_5378_;
                                    if (_e1819 > _e1823) {
                                        phi_5383_ = _e1819;
                                    } else {
                                        phi_5383_ = _e1823;
                                    }
                                    let _e1826 = phi_5383_;
                                    if (_e1776 < 0.0lf) {
                                        phi_5389_ = -(_e1776);
                                    } else {
                                        phi_5389_ = _e1776;
                                    }
                                    let _e1830 = phi_5389_;
                                    if (_e1826 > _e1830) {
                                        phi_5394_ = _e1826;
                                    } else {
                                        phi_5394_ = _e1830;
                                    }
                                    let _e1833 = phi_5394_;
                                    local_5 = type_51(array<f64, 3>(_e1774, _e1775, _e1776), _e1815, (_e1833 + _e1815));
                                    let _e1838 = local_4.member;
                                    let _e1843 = local_5.member;
                                    let _e1849 = ((_e1838[1] * _e1843[2]) - (_e1838[2] * _e1843[1]));
                                    let _e1852 = ((_e1838[2] * _e1843[0]) - (_e1838[0] * _e1843[2]));
                                    let _e1855 = ((_e1838[0] * _e1843[1]) - (_e1838[1] * _e1843[0]));
                                    if (_e1849 < 0.0lf) {
                                        phi_5443_ = -(_e1849);
                                    } else {
                                        phi_5443_ = _e1849;
                                    }
                                    let _e1859 = phi_5443_;
                                    if (_e1852 < 0.0lf) {
                                        phi_5449_ = -(_e1852);
                                    } else {
                                        phi_5449_ = _e1852;
                                    }
                                    let _e1863 = phi_5449_;
                                    if (_e1859 > _e1863) {
                                        if (_e1849 < 0.0lf) {
                                            phi_5459_ = -(_e1849);
                                        } else {
                                            phi_5459_ = _e1849;
                                        }
                                        let _e1881 = phi_5459_;
                                        if (_e1855 < 0.0lf) {
                                            phi_5465_ = -(_e1855);
                                        } else {
                                            phi_5465_ = _e1855;
                                        }
                                        let _e1885 = phi_5465_;
                                        if (_e1881 > _e1885) {
                                            phi_5470_ = 2u;
                                            phi_5471_ = 1u;
                                        } else {
                                            phi_5470_ = 1u;
                                            phi_5471_ = 0u;
                                        }
                                        let _e1888 = phi_5470_;
                                        let _e1890 = phi_5471_;
                                        phi_5490_ = _e1888;
                                        phi_5491_ = _e1890;
                                    } else {
                                        if (_e1852 < 0.0lf) {
                                            phi_5477_ = -(_e1852);
                                        } else {
                                            phi_5477_ = _e1852;
                                        }
                                        let _e1868 = phi_5477_;
                                        if (_e1855 < 0.0lf) {
                                            phi_5483_ = -(_e1855);
                                        } else {
                                            phi_5483_ = _e1855;
                                        }
                                        let _e1872 = phi_5483_;
                                        if (_e1868 > _e1872) {
                                            phi_5488_ = 0u;
                                            phi_5489_ = 2u;
                                        } else {
                                            phi_5488_ = 1u;
                                            phi_5489_ = 0u;
                                        }
                                        let _e1875 = phi_5488_;
                                        let _e1877 = phi_5489_;
                                        phi_5490_ = _e1875;
                                        phi_5491_ = _e1877;
                                    }
                                    let _e1892 = phi_5490_;
                                    let _e1894 = phi_5491_;
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
                                        phi_5562_ = -(_e1913);
                                    } else {
                                        phi_5562_ = _e1913;
                                    }
                                    let _e1951 = phi_5562_;
                                    if (_e1951 > _e1947) {
                                        if (_e1913 < f64(0f)) {
                                            phi_5574_ = f64(-1f);
                                        } else {
                                            phi_5574_ = f64(1f);
                                        }
                                        let _e1958 = phi_5574_;
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
                                            phi_5713_ = -(_e2065);
                                        } else {
                                            phi_5713_ = _e2065;
                                        }
                                        let _e2071 = phi_5713_;
                                        if (_e2066 < 0.0lf) {
                                            phi_5719_ = -(_e2066);
                                        } else {
                                            phi_5719_ = _e2066;
                                        }
                                        let _e2075 = phi_5719_;
                                        if (_e2067 < 0.0lf) {
                                            phi_5726_ = -(_e2067);
                                        } else {
                                            phi_5726_ = _e2067;
                                        }
                                        let _e2080 = phi_5726_;
                                        let _e2084 = (((_e2071 + _e2075) + _e2080) * (1.1102230246251565e-16lf * f64(4f)));
                                        local_6[0u].member = _e2066;
                                        local_6[0u].member_1 = _e2011;
                                        local_6[1u].member = _e2067;
                                        local_6[1u].member_1 = _e2064;
                                        local_6[2u].member = (_e2065 - _e2066);
                                        local_6[2u].member_1 = ((_e1947 + _e2011) + _e2084);
                                        local_6[3u].member = (_e2065 - _e2067);
                                        local_6[3u].member_1 = ((_e1947 + _e2064) + _e2084);
                                        phi_5770_ = type_28(0u, 4u);
                                        phi_5773_ = true;
                                        loop {
                                            let _e2105 = phi_5770_;
                                            let _e2107 = phi_5773_;
                                            local_25 = _e2107;
                                            if (_e2105.member < _e2105.member_1) {
                                                phi_5771_ = type_28((_e2105.member + 1u), _e2105.member_1);
                                                phi_5796_ = type_28(1u, _e2105.member);
                                            } else {
                                                phi_5771_ = _e2105;
                                                phi_5796_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e2121 = phi_5771_;
                                            let _e2123 = phi_5796_;
                                            if (bitcast<i32>(_e2123.member) != 0i) {
                                                if (_e2123.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e2131 = local_6[_e2123.member_1].member;
                                                let _e2134 = local_6[_e2123.member_1].member_1;
                                                let _e2136 = (_e2131 < -(_e2134));
                                                if _e2136 {
                                                    phi_5823_ = bool();
                                                    phi_5824_ = false;
                                                } else {
                                                    phi_5823_ = (_e2107 && (_e2131 > _e2134));
                                                    phi_5824_ = true;
                                                }
                                                let _e2140 = phi_5823_;
                                                let _e2142 = phi_5824_;
                                                phi_5774_ = _e2140;
                                                phi_5825_ = _e2142;
                                                phi_5826_ = _e2136;
                                            } else {
                                                phi_5774_ = bool();
                                                phi_5825_ = false;
                                                phi_5826_ = false;
                                            }
                                            let _e2144 = phi_5774_;
                                            let _e2146 = phi_5825_;
                                            let _e2148 = phi_5826_;
                                            local_24 = _e2148;
                                            continue;
                                            continuing {
                                                phi_5770_ = _e2121;
                                                phi_5773_ = _e2144;
                                                break if !(_e2146);
                                            }
                                        }
                                        let _e2151 = local_24;
                                        if _e2151 {
                                            phi_5830_ = false;
                                        } else {
                                            phi_5830_ = true;
                                        }
                                        let _e2153 = phi_5830_;
                                        if _e2153 {
                                            let _e2155 = local_25;
                                            if _e2155 {
                                                phi_5837_ = 1u;
                                            } else {
                                                phi_5837_ = 2u;
                                            }
                                            let _e2157 = phi_5837_;
                                            phi_5838_ = _e2157;
                                            phi_5839_ = false;
                                        } else {
                                            phi_5838_ = u32();
                                            phi_5839_ = true;
                                        }
                                        let _e2159 = phi_5838_;
                                        let _e2161 = phi_5839_;
                                        phi_5840_ = _e2159;
                                        phi_5841_ = 0u;
                                        phi_5842_ = _e2161;
                                    } else {
                                        phi_5840_ = u32();
                                        phi_5841_ = 2u;
                                        phi_5842_ = true;
                                    }
                                    let _e2163 = phi_5840_;
                                    let _e2165 = phi_5841_;
                                    let _e2167 = phi_5842_;
                                    if _e2167 {
                                        phi_5846_ = _e2165;
                                    } else {
                                        phi_5846_ = _e2163;
                                    }
                                    let _e2169 = phi_5846_;
                                    let _e2170 = (_e2169 == 0u);
                                    if _e2170 {
                                        phi_7390_ = f64();
                                        phi_7391_ = false;
                                        phi_7392_ = false;
                                        phi_7393_ = false;
                                    } else {
                                        if (_e2169 == 1u) {
                                            if _e1428.member_2 {
                                                if ((_e1428.member_1 - _e1428.member) <= f64(0.0000005f)) {
                                                    phi_5867_ = false;
                                                } else {
                                                    phi_5867_ = true;
                                                }
                                                let _e2179 = phi_5867_;
                                                phi_5868_ = _e2179;
                                            } else {
                                                phi_5868_ = true;
                                            }
                                            let _e2181 = phi_5868_;
                                            phi_5869_ = _e2181;
                                        } else {
                                            phi_5869_ = true;
                                        }
                                        let _e2183 = phi_5869_;
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
                                                phi_6066_ = -(_e2251[0]);
                                            } else {
                                                phi_6066_ = _e2251[0];
                                            }
                                            let _e2258 = phi_6066_;
                                            if (_e2251[1] < 0.0lf) {
                                                phi_6073_ = -(_e2251[1]);
                                            } else {
                                                phi_6073_ = _e2251[1];
                                            }
                                            let _e2262 = phi_6073_;
                                            if (_e2258 > _e2262) {
                                                phi_6078_ = _e2258;
                                            } else {
                                                phi_6078_ = _e2262;
                                            }
                                            let _e2265 = phi_6078_;
                                            if (_e2251[2] < 0.0lf) {
                                                phi_6085_ = -(_e2251[2]);
                                            } else {
                                                phi_6085_ = _e2251[2];
                                            }
                                            let _e2269 = phi_6085_;
                                            if (_e2265 > _e2269) {
                                                phi_6090_ = _e2265;
                                            } else {
                                                phi_6090_ = _e2269;
                                            }
                                            let _e2272 = phi_6090_;
                                            let _e2275 = local_20.member[1u];
                                            if (_e2275[0] < 0.0lf) {
                                                phi_6103_ = -(_e2275[0]);
                                            } else {
                                                phi_6103_ = _e2275[0];
                                            }
                                            let _e2282 = phi_6103_;
                                            if (_e2275[1] < 0.0lf) {
                                                phi_6110_ = -(_e2275[1]);
                                            } else {
                                                phi_6110_ = _e2275[1];
                                            }
                                            let _e2286 = phi_6110_;
                                            if (_e2282 > _e2286) {
                                                phi_6115_ = _e2282;
                                            } else {
                                                phi_6115_ = _e2286;
                                            }
                                            let _e2289 = phi_6115_;
                                            if (_e2275[2] < 0.0lf) {
                                                phi_6122_ = -(_e2275[2]);
                                            } else {
                                                phi_6122_ = _e2275[2];
                                            }
                                            let _e2293 = phi_6122_;
                                            if (_e2289 > _e2293) {
                                                phi_6127_ = _e2289;
                                            } else {
                                                phi_6127_ = _e2293;
                                            }
                                            let _e2296 = phi_6127_;
                                            if (_e2272 > _e2296) {
                                                phi_6132_ = _e2272;
                                            } else {
                                                phi_6132_ = _e2296;
                                            }
                                            let _e2299 = phi_6132_;
                                            let _e2301 = local_20.member_3;
                                            let _e2305 = local_20.member_1[0u];
                                            if (_e2305[0] < 0.0lf) {
                                                phi_6149_ = -(_e2305[0]);
                                            } else {
                                                phi_6149_ = _e2305[0];
                                            }
                                            let _e2312 = phi_6149_;
                                            if (_e2305[1] < 0.0lf) {
                                                phi_6156_ = -(_e2305[1]);
                                            } else {
                                                phi_6156_ = _e2305[1];
                                            }
                                            let _e2316 = phi_6156_;
                                            if (_e2312 > _e2316) {
                                                phi_6161_ = _e2312;
                                            } else {
                                                phi_6161_ = _e2316;
                                            }
                                            let _e2319 = phi_6161_;
                                            if (_e2305[2] < 0.0lf) {
                                                phi_6168_ = -(_e2305[2]);
                                            } else {
                                                phi_6168_ = _e2305[2];
                                            }
                                            let _e2323 = phi_6168_;
                                            if (_e2319 > _e2323) {
                                                phi_6173_ = _e2319;
                                            } else {
                                                phi_6173_ = _e2323;
                                            }
                                            let _e2326 = phi_6173_;
                                            let _e2329 = local_20.member_1[1u];
                                            if (_e2329[0] < 0.0lf) {
                                                phi_6187_ = -(_e2329[0]);
                                            } else {
                                                phi_6187_ = _e2329[0];
                                            }
                                            let _e2336 = phi_6187_;
                                            if (_e2329[1] < 0.0lf) {
                                                phi_6194_ = -(_e2329[1]);
                                            } else {
                                                phi_6194_ = _e2329[1];
                                            }
                                            let _e2340 = phi_6194_;
                                            if (_e2336 > _e2340) {
                                                phi_6199_ = _e2336;
                                            } else {
                                                phi_6199_ = _e2340;
                                            }
                                            let _e2343 = phi_6199_;
                                            if (_e2329[2] < 0.0lf) {
                                                phi_6206_ = -(_e2329[2]);
                                            } else {
                                                phi_6206_ = _e2329[2];
                                            }
                                            let _e2347 = phi_6206_;
                                            if (_e2343 > _e2347) {
                                                phi_6211_ = _e2343;
                                            } else {
                                                phi_6211_ = _e2347;
                                            }
                                            let _e2350 = phi_6211_;
                                            if (_e2326 > _e2350) {
                                                phi_6216_ = _e2326;
                                            } else {
                                                phi_6216_ = _e2350;
                                            }
                                            let _e2353 = phi_6216_;
                                            let _e2355 = local_20.member_3;
                                            let _e2359 = local_20.member_2[0u];
                                            if (_e2359[0] < 0.0lf) {
                                                phi_6233_ = -(_e2359[0]);
                                            } else {
                                                phi_6233_ = _e2359[0];
                                            }
                                            let _e2366 = phi_6233_;
                                            if (_e2359[1] < 0.0lf) {
                                                phi_6240_ = -(_e2359[1]);
                                            } else {
                                                phi_6240_ = _e2359[1];
                                            }
                                            let _e2370 = phi_6240_;
                                            if (_e2366 > _e2370) {
                                                phi_6245_ = _e2366;
                                            } else {
                                                phi_6245_ = _e2370;
                                            }
                                            let _e2373 = phi_6245_;
                                            if (_e2359[2] < 0.0lf) {
                                                phi_6252_ = -(_e2359[2]);
                                            } else {
                                                phi_6252_ = _e2359[2];
                                            }
                                            let _e2377 = phi_6252_;
                                            if (_e2373 > _e2377) {
                                                phi_6257_ = _e2373;
                                            } else {
                                                phi_6257_ = _e2377;
                                            }
                                            let _e2380 = phi_6257_;
                                            let _e2383 = local_20.member_2[1u];
                                            if (_e2383[0] < 0.0lf) {
                                                phi_6271_ = -(_e2383[0]);
                                            } else {
                                                phi_6271_ = _e2383[0];
                                            }
                                            let _e2390 = phi_6271_;
                                            if (_e2383[1] < 0.0lf) {
                                                phi_6278_ = -(_e2383[1]);
                                            } else {
                                                phi_6278_ = _e2383[1];
                                            }
                                            let _e2394 = phi_6278_;
                                            if (_e2390 > _e2394) {
                                                phi_6283_ = _e2390;
                                            } else {
                                                phi_6283_ = _e2394;
                                            }
                                            let _e2397 = phi_6283_;
                                            if (_e2383[2] < 0.0lf) {
                                                phi_6290_ = -(_e2383[2]);
                                            } else {
                                                phi_6290_ = _e2383[2];
                                            }
                                            let _e2401 = phi_6290_;
                                            if (_e2397 > _e2401) {
                                                phi_6295_ = _e2397;
                                            } else {
                                                phi_6295_ = _e2401;
                                            }
                                            let _e2404 = phi_6295_;
                                            if (_e2380 > _e2404) {
                                                phi_6300_ = _e2380;
                                            } else {
                                                phi_6300_ = _e2404;
                                            }
                                            let _e2407 = phi_6300_;
                                            let _e2409 = local_20.member_3;
                                            let _e2417 = local_20.member_3;
                                            phi_6320_ = type_28(0u, 48u);
                                            phi_6323_ = _e1428.member;
                                            loop {
                                                let _e2426 = phi_6320_;
                                                let _e2428 = phi_6323_;
                                                local_70 = _e2428;
                                                local_32 = _e2428;
                                                local_33 = _e2428;
                                                local_34 = _e2428;
                                                local_35 = _e2428;
                                                if (_e2426.member < _e2426.member_1) {
                                                    phi_6321_ = type_28((_e2426.member + 1u), _e2426.member_1);
                                                    phi_6346_ = type_28(1u, _e2426.member);
                                                } else {
                                                    phi_6321_ = _e2426;
                                                    phi_6346_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e2442 = phi_6321_;
                                                let _e2444 = phi_6346_;
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
                                                                phi_6502_ = (_e2548 <= _e2540);
                                                                phi_6503_ = false;
                                                            } else {
                                                                phi_6502_ = bool();
                                                                phi_6503_ = true;
                                                            }
                                                            let _e2554 = phi_6502_;
                                                            let _e2556 = phi_6503_;
                                                            phi_6504_ = _e2554;
                                                            phi_6505_ = _e2556;
                                                        } else {
                                                            phi_6504_ = bool();
                                                            phi_6505_ = true;
                                                        }
                                                        let _e2558 = phi_6504_;
                                                        let _e2560 = phi_6505_;
                                                        phi_6506_ = _e2558;
                                                        phi_6507_ = _e2560;
                                                    } else {
                                                        phi_6506_ = bool();
                                                        phi_6507_ = true;
                                                    }
                                                    let _e2562 = phi_6506_;
                                                    let _e2564 = phi_6507_;
                                                    if _e2564 {
                                                        phi_6511_ = false;
                                                    } else {
                                                        phi_6511_ = _e2562;
                                                    }
                                                    let _e2566 = phi_6511_;
                                                    if (_e2538 > _e2539) {
                                                        if _e2566 {
                                                            phi_6551_ = array<f64, 3>((_e2466 - ((_e2487 * _e2544) + (_e2508 * _e2548))), (_e2467 - ((_e2488 * _e2544) + (_e2509 * _e2548))), (_e2468 - ((_e2489 * _e2544) + (_e2510 * _e2548))));
                                                            phi_6552_ = false;
                                                        } else {
                                                            phi_6551_ = array<f64, 3>();
                                                            phi_6552_ = true;
                                                        }
                                                        let _e2582 = phi_6551_;
                                                        let _e2584 = phi_6552_;
                                                        phi_6553_ = _e2582;
                                                        phi_6554_ = _e2584;
                                                    } else {
                                                        phi_6553_ = array<f64, 3>();
                                                        phi_6554_ = true;
                                                    }
                                                    let _e2586 = phi_6553_;
                                                    let _e2588 = phi_6554_;
                                                    if _e2588 {
                                                        let _e2589 = (_e2466 - _e2487);
                                                        let _e2590 = (_e2467 - _e2488);
                                                        let _e2591 = (_e2468 - _e2489);
                                                        let _e2602 = ((((_e2466 * _e2487) + (_e2467 * _e2488)) + (_e2468 * _e2489)) / (((_e2487 * _e2487) + (_e2488 * _e2488)) + (_e2489 * _e2489)));
                                                        if (_e2602 > f64(0f)) {
                                                            if (_e2602 < f64(1f)) {
                                                                phi_6587_ = _e2602;
                                                            } else {
                                                                phi_6587_ = f64(1f);
                                                            }
                                                            let _e2610 = phi_6587_;
                                                            phi_6589_ = _e2610;
                                                        } else {
                                                            phi_6589_ = f64(0f);
                                                        }
                                                        let _e2612 = phi_6589_;
                                                        let _e2629 = ((((_e2466 * _e2508) + (_e2467 * _e2509)) + (_e2468 * _e2510)) / (((_e2508 * _e2508) + (_e2509 * _e2509)) + (_e2510 * _e2510)));
                                                        if (_e2629 > f64(0f)) {
                                                            if (_e2629 < f64(1f)) {
                                                                phi_6619_ = _e2629;
                                                            } else {
                                                                phi_6619_ = f64(1f);
                                                            }
                                                            let _e2637 = phi_6619_;
                                                            phi_6621_ = _e2637;
                                                        } else {
                                                            phi_6621_ = f64(0f);
                                                        }
                                                        let _e2639 = phi_6621_;
                                                        let _e2656 = ((((_e2589 * _e2508) + (_e2590 * _e2509)) + (_e2591 * _e2510)) / (((_e2508 * _e2508) + (_e2509 * _e2509)) + (_e2510 * _e2510)));
                                                        if (_e2656 > f64(0f)) {
                                                            if (_e2656 < f64(1f)) {
                                                                phi_6651_ = _e2656;
                                                            } else {
                                                                phi_6651_ = f64(1f);
                                                            }
                                                            let _e2664 = phi_6651_;
                                                            phi_6653_ = _e2664;
                                                        } else {
                                                            phi_6653_ = f64(0f);
                                                        }
                                                        let _e2666 = phi_6653_;
                                                        let _e2673 = (_e2466 - _e2508);
                                                        let _e2674 = (_e2467 - _e2509);
                                                        let _e2675 = (_e2468 - _e2510);
                                                        let _e2686 = ((((_e2673 * _e2487) + (_e2674 * _e2488)) + (_e2675 * _e2489)) / (((_e2487 * _e2487) + (_e2488 * _e2488)) + (_e2489 * _e2489)));
                                                        if (_e2686 > f64(0f)) {
                                                            if (_e2686 < f64(1f)) {
                                                                phi_6686_ = _e2686;
                                                            } else {
                                                                phi_6686_ = f64(1f);
                                                            }
                                                            let _e2694 = phi_6686_;
                                                            phi_6688_ = _e2694;
                                                        } else {
                                                            phi_6688_ = f64(0f);
                                                        }
                                                        let _e2696 = phi_6688_;
                                                        local[0u] = array<f64, 3>((_e2466 - (_e2487 * _e2612)), (_e2467 - (_e2488 * _e2612)), (_e2468 - (_e2489 * _e2612)));
                                                        local[1u] = array<f64, 3>((_e2466 - (_e2508 * _e2639)), (_e2467 - (_e2509 * _e2639)), (_e2468 - (_e2510 * _e2639)));
                                                        local[2u] = array<f64, 3>((_e2589 - (_e2508 * _e2666)), (_e2590 - (_e2509 * _e2666)), (_e2591 - (_e2510 * _e2666)));
                                                        local[3u] = array<f64, 3>((_e2673 - (_e2487 * _e2696)), (_e2674 - (_e2488 * _e2696)), (_e2675 - (_e2489 * _e2696)));
                                                        let _e2712 = local[0u];
                                                        phi_6843_ = type_28(1u, 4u);
                                                        phi_6846_ = array<f64, 3>(_e2712[0], _e2712[1], _e2712[2]);
                                                        loop {
                                                            let _e2718 = phi_6843_;
                                                            let _e2720 = phi_6846_;
                                                            local_57 = _e2720;
                                                            if (_e2718.member < _e2718.member_1) {
                                                                phi_6844_ = type_28((_e2718.member + 1u), _e2718.member_1);
                                                                phi_6869_ = type_28(1u, _e2718.member);
                                                            } else {
                                                                phi_6844_ = _e2718;
                                                                phi_6869_ = type_28(0u, type_28().member_1);
                                                            }
                                                            let _e2734 = phi_6844_;
                                                            let _e2736 = phi_6869_;
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
                                                                    phi_6936_ = array<f64, 3>(_e2772[0], _e2772[1], _e2772[2]);
                                                                } else {
                                                                    phi_6936_ = _e2720;
                                                                }
                                                                let _e2778 = phi_6936_;
                                                                phi_6847_ = _e2778;
                                                            } else {
                                                                phi_6847_ = array<f64, 3>();
                                                            }
                                                            let _e2780 = phi_6847_;
                                                            continue;
                                                            continuing {
                                                                phi_6843_ = _e2734;
                                                                phi_6846_ = _e2780;
                                                                break if !(_e2740);
                                                            }
                                                        }
                                                        let _e5443 = local_57;
                                                        phi_6937_ = _e5443;
                                                    } else {
                                                        phi_6937_ = _e2586;
                                                    }
                                                    let _e2783 = phi_6937_;
                                                    if (_e2783[0] < 0.0lf) {
                                                        phi_6944_ = -(_e2783[0]);
                                                    } else {
                                                        phi_6944_ = _e2783[0];
                                                    }
                                                    let _e2788 = phi_6944_;
                                                    if (_e2783[1] < 0.0lf) {
                                                        phi_6951_ = -(_e2783[1]);
                                                    } else {
                                                        phi_6951_ = _e2783[1];
                                                    }
                                                    let _e2793 = phi_6951_;
                                                    if (_e2783[2] < 0.0lf) {
                                                        phi_6959_ = -(_e2783[2]);
                                                    } else {
                                                        phi_6959_ = _e2783[2];
                                                    }
                                                    let _e2799 = phi_6959_;
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
                                                                    phi_6997_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_6997_ = 0.0lf;
                                                                }
                                                                let _e2875 = phi_6997_;
                                                                phi_7061_ = _e2875;
                                                            } else {
                                                                phi_7004_ = type_26(0i, 5i);
                                                                phi_7007_ = bitcast<f64>(((bitcast<u64>(_e2817) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2824 = phi_7004_;
                                                                    let _e2826 = phi_7007_;
                                                                    local_26 = _e2826;
                                                                    if (_e2824.member < _e2824.member_1) {
                                                                        let _e2834 = (_e2824.member + 1i);
                                                                        if ((false == (_e2834 > _e2824.member)) != false) {
                                                                            phi_7028_ = true;
                                                                        } else {
                                                                            phi_7028_ = false;
                                                                        }
                                                                        let _e2839 = phi_7028_;
                                                                        if _e2839 {
                                                                            phi_7034_ = type_27(0u, type_27().member_1);
                                                                        } else {
                                                                            phi_7034_ = type_27(1u, _e2834);
                                                                        }
                                                                        let _e2845 = phi_7034_;
                                                                        if (bitcast<i32>(_e2845.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_7005_ = type_26(_e2845.member_1, _e2824.member_1);
                                                                        phi_7048_ = type_27(1u, _e2824.member);
                                                                    } else {
                                                                        phi_7005_ = _e2824;
                                                                        phi_7048_ = type_27(0u, type_27().member_1);
                                                                    }
                                                                    let _e2855 = phi_7005_;
                                                                    let _e2857 = phi_7048_;
                                                                    let _e2860 = (bitcast<i32>(_e2857.member) != 0i);
                                                                    if _e2860 {
                                                                        phi_7008_ = (0.5lf * (_e2826 + (_e2817 / _e2826)));
                                                                    } else {
                                                                        phi_7008_ = f64();
                                                                    }
                                                                    let _e2865 = phi_7008_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7004_ = _e2855;
                                                                        phi_7007_ = _e2865;
                                                                        break if !(_e2860);
                                                                    }
                                                                }
                                                                let _e2870 = local_26;
                                                                phi_7061_ = (_e2870 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2877 = phi_7061_;
                                                            phi_7074_ = type_28(0u, 4u);
                                                            phi_7077_ = f64(2f);
                                                            loop {
                                                                let _e2889 = phi_7074_;
                                                                let _e2891 = phi_7077_;
                                                                local_28 = _e2891;
                                                                local_29 = _e2891;
                                                                local_30 = _e2891;
                                                                local_60 = _e2891;
                                                                local_61 = _e2891;
                                                                if (_e2889.member < _e2889.member_1) {
                                                                    phi_7075_ = type_28((_e2889.member + 1u), _e2889.member_1);
                                                                    phi_7100_ = type_28(1u, _e2889.member);
                                                                } else {
                                                                    phi_7075_ = _e2889;
                                                                    phi_7100_ = type_28(0u, type_28().member_1);
                                                                }
                                                                let _e2905 = phi_7075_;
                                                                let _e2907 = phi_7100_;
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
                                                                        phi_7151_ = -(_e2922);
                                                                    } else {
                                                                        phi_7151_ = _e2922;
                                                                    }
                                                                    let _e2937 = phi_7151_;
                                                                    if (_e2933 < 0.0lf) {
                                                                        phi_7157_ = -(_e2933);
                                                                    } else {
                                                                        phi_7157_ = _e2933;
                                                                    }
                                                                    let _e2941 = phi_7157_;
                                                                    let _e2946 = (((((((((_e2299 + _e2301) + (_e2353 + _e2355)) + (_e2407 + _e2409)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2417 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2877) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2937 + _e2941) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2922 > _e2946) {
                                                                        if (_e2933 > _e2946) {
                                                                            phi_7171_ = false;
                                                                        } else {
                                                                            phi_7171_ = true;
                                                                        }
                                                                        let _e2950 = phi_7171_;
                                                                        phi_7172_ = _e2950;
                                                                    } else {
                                                                        phi_7172_ = true;
                                                                    }
                                                                    let _e2952 = phi_7172_;
                                                                    if _e2952 {
                                                                        if ((_e2922 + ((_e2933 - _e2922) * _e2428)) > _e2946) {
                                                                            if (_e2933 < _e2922) {
                                                                                let _e2961 = ((_e2922 - _e2933) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                                                if _e2961 {
                                                                                    let _e2969 = (((_e2922 - _e2946) / (_e2922 - _e2933)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    if (_e2891 < _e2969) {
                                                                                        phi_7206_ = _e2891;
                                                                                    } else {
                                                                                        phi_7206_ = _e2969;
                                                                                    }
                                                                                    let _e2972 = phi_7206_;
                                                                                    phi_7207_ = _e2972;
                                                                                } else {
                                                                                    phi_7207_ = f64();
                                                                                }
                                                                                let _e2974 = phi_7207_;
                                                                                phi_7208_ = _e2974;
                                                                                phi_7209_ = _e2961;
                                                                            } else {
                                                                                phi_7208_ = _e2891;
                                                                                phi_7209_ = true;
                                                                            }
                                                                            let _e2976 = phi_7208_;
                                                                            let _e2978 = phi_7209_;
                                                                            if _e2978 {
                                                                                phi_7213_ = false;
                                                                            } else {
                                                                                phi_7213_ = true;
                                                                            }
                                                                            let _e2980 = phi_7213_;
                                                                            phi_7214_ = _e2976;
                                                                            phi_7215_ = _e2978;
                                                                            phi_7216_ = _e2980;
                                                                            phi_7217_ = false;
                                                                        } else {
                                                                            phi_7214_ = f64();
                                                                            phi_7215_ = false;
                                                                            phi_7216_ = false;
                                                                            phi_7217_ = true;
                                                                        }
                                                                        let _e2982 = phi_7214_;
                                                                        let _e2984 = phi_7215_;
                                                                        let _e2986 = phi_7216_;
                                                                        let _e2988 = phi_7217_;
                                                                        phi_7218_ = _e2982;
                                                                        phi_7219_ = _e2984;
                                                                        phi_7220_ = _e2986;
                                                                        phi_7221_ = _e2988;
                                                                    } else {
                                                                        phi_7218_ = _e2891;
                                                                        phi_7219_ = true;
                                                                        phi_7220_ = false;
                                                                        phi_7221_ = false;
                                                                    }
                                                                    let _e2990 = phi_7218_;
                                                                    let _e2992 = phi_7219_;
                                                                    let _e2994 = phi_7220_;
                                                                    let _e2996 = phi_7221_;
                                                                    phi_7078_ = _e2990;
                                                                    phi_7222_ = _e2992;
                                                                    phi_7223_ = false;
                                                                    phi_7224_ = _e2994;
                                                                    phi_7225_ = _e2996;
                                                                } else {
                                                                    phi_7078_ = f64();
                                                                    phi_7222_ = false;
                                                                    phi_7223_ = true;
                                                                    phi_7224_ = false;
                                                                    phi_7225_ = false;
                                                                }
                                                                let _e2998 = phi_7078_;
                                                                let _e3000 = phi_7222_;
                                                                let _e3002 = phi_7223_;
                                                                let _e3004 = phi_7224_;
                                                                let _e3006 = phi_7225_;
                                                                local_27 = _e3002;
                                                                local_58 = _e3004;
                                                                local_59 = _e3006;
                                                                continue;
                                                                continuing {
                                                                    phi_7074_ = _e2905;
                                                                    phi_7077_ = _e2998;
                                                                    break if !(_e3000);
                                                                }
                                                            }
                                                            let _e3009 = local_27;
                                                            if _e3009 {
                                                                let _e3011 = local_28;
                                                                let _e3012 = (_e3011 > _e1428.member_1);
                                                                if _e3012 {
                                                                    phi_7247_ = false;
                                                                    phi_7248_ = false;
                                                                    phi_7249_ = false;
                                                                } else {
                                                                    let _e3014 = local_29;
                                                                    if (_e3014 > _e2428) {
                                                                        let _e3017 = local_30;
                                                                        let _e3020 = ((_e3017 - _e2428) < f64(0.00000000023283064f));
                                                                        if _e3020 {
                                                                            phi_7243_ = false;
                                                                        } else {
                                                                            phi_7243_ = true;
                                                                        }
                                                                        let _e3022 = phi_7243_;
                                                                        phi_7244_ = _e3022;
                                                                        phi_7245_ = _e3020;
                                                                        phi_7246_ = false;
                                                                    } else {
                                                                        phi_7244_ = false;
                                                                        phi_7245_ = false;
                                                                        phi_7246_ = true;
                                                                    }
                                                                    let _e3024 = phi_7244_;
                                                                    let _e3026 = phi_7245_;
                                                                    let _e3028 = phi_7246_;
                                                                    phi_7247_ = _e3024;
                                                                    phi_7248_ = _e3026;
                                                                    phi_7249_ = _e3028;
                                                                }
                                                                let _e3030 = phi_7247_;
                                                                let _e3032 = phi_7248_;
                                                                let _e3034 = phi_7249_;
                                                                phi_7250_ = _e3030;
                                                                phi_7251_ = _e3012;
                                                                phi_7252_ = _e3032;
                                                                phi_7253_ = _e3034;
                                                                phi_7254_ = false;
                                                                phi_7255_ = false;
                                                            } else {
                                                                phi_7250_ = false;
                                                                phi_7251_ = false;
                                                                phi_7252_ = false;
                                                                phi_7253_ = false;
                                                                let _e5500 = local_58;
                                                                phi_7254_ = _e5500;
                                                                let _e5503 = local_59;
                                                                phi_7255_ = _e5503;
                                                            }
                                                            let _e3036 = phi_7250_;
                                                            let _e3038 = phi_7251_;
                                                            let _e3040 = phi_7252_;
                                                            let _e3042 = phi_7253_;
                                                            let _e3044 = phi_7254_;
                                                            let _e3046 = phi_7255_;
                                                            let _e5506 = local_60;
                                                            phi_7256_ = _e5506;
                                                            let _e5509 = local_61;
                                                            phi_7257_ = _e5509;
                                                            phi_7258_ = _e3036;
                                                            phi_7259_ = _e3038;
                                                            phi_7260_ = _e3040;
                                                            phi_7261_ = _e3042;
                                                            phi_7262_ = _e3044;
                                                            phi_7263_ = _e3046;
                                                            phi_7264_ = false;
                                                        } else {
                                                            phi_7256_ = f64();
                                                            phi_7257_ = f64();
                                                            phi_7258_ = false;
                                                            phi_7259_ = false;
                                                            phi_7260_ = false;
                                                            phi_7261_ = false;
                                                            phi_7262_ = false;
                                                            phi_7263_ = false;
                                                            phi_7264_ = true;
                                                        }
                                                        let _e3048 = phi_7256_;
                                                        let _e3050 = phi_7257_;
                                                        let _e3052 = phi_7258_;
                                                        let _e3054 = phi_7259_;
                                                        let _e3056 = phi_7260_;
                                                        let _e3058 = phi_7261_;
                                                        let _e3060 = phi_7262_;
                                                        let _e3062 = phi_7263_;
                                                        let _e3064 = phi_7264_;
                                                        phi_7265_ = _e3048;
                                                        phi_7266_ = _e3050;
                                                        phi_7267_ = _e3052;
                                                        phi_7268_ = _e3054;
                                                        phi_7269_ = _e3056;
                                                        phi_7270_ = _e3058;
                                                        phi_7271_ = _e3060;
                                                        phi_7272_ = _e3062;
                                                        phi_7273_ = _e3064;
                                                        phi_7274_ = false;
                                                    } else {
                                                        phi_7265_ = f64();
                                                        phi_7266_ = f64();
                                                        phi_7267_ = false;
                                                        phi_7268_ = false;
                                                        phi_7269_ = false;
                                                        phi_7270_ = false;
                                                        phi_7271_ = false;
                                                        phi_7272_ = false;
                                                        phi_7273_ = false;
                                                        phi_7274_ = true;
                                                    }
                                                    let _e3066 = phi_7265_;
                                                    let _e3068 = phi_7266_;
                                                    let _e3070 = phi_7267_;
                                                    let _e3072 = phi_7268_;
                                                    let _e3074 = phi_7269_;
                                                    let _e3076 = phi_7270_;
                                                    let _e3078 = phi_7271_;
                                                    let _e3080 = phi_7272_;
                                                    let _e3082 = phi_7273_;
                                                    let _e3084 = phi_7274_;
                                                    phi_7275_ = _e3066;
                                                    phi_6324_ = _e3068;
                                                    phi_7276_ = _e3070;
                                                    phi_7277_ = _e3072;
                                                    phi_7278_ = _e3074;
                                                    phi_7279_ = false;
                                                    phi_7280_ = _e3076;
                                                    phi_7281_ = _e3078;
                                                    phi_7282_ = _e3080;
                                                    phi_7283_ = _e3082;
                                                    phi_7284_ = _e3084;
                                                } else {
                                                    phi_7275_ = f64();
                                                    phi_6324_ = f64();
                                                    phi_7276_ = false;
                                                    phi_7277_ = false;
                                                    phi_7278_ = false;
                                                    phi_7279_ = true;
                                                    phi_7280_ = false;
                                                    phi_7281_ = false;
                                                    phi_7282_ = false;
                                                    phi_7283_ = false;
                                                    phi_7284_ = false;
                                                }
                                                let _e3086 = phi_7275_;
                                                let _e3088 = phi_6324_;
                                                let _e3090 = phi_7276_;
                                                let _e3092 = phi_7277_;
                                                let _e3094 = phi_7278_;
                                                let _e3096 = phi_7279_;
                                                let _e3098 = phi_7280_;
                                                let _e3100 = phi_7281_;
                                                let _e3102 = phi_7282_;
                                                let _e3104 = phi_7283_;
                                                let _e3106 = phi_7284_;
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
                                                    phi_6320_ = _e2442;
                                                    phi_6323_ = _e3088;
                                                    break if !(_e3090);
                                                }
                                            }
                                            let _e3109 = local_31;
                                            if _e3109 {
                                                phi_7289_ = type_72(0u, type_72().member_1);
                                                phi_7290_ = false;
                                                phi_7291_ = false;
                                                phi_7292_ = false;
                                                phi_7293_ = false;
                                                phi_7294_ = false;
                                                phi_7295_ = false;
                                                phi_7296_ = false;
                                            } else {
                                                phi_7289_ = type_72();
                                                let _e5542 = local_62;
                                                phi_7290_ = _e5542;
                                                let _e5545 = local_63;
                                                phi_7291_ = _e5545;
                                                let _e5548 = local_64;
                                                phi_7292_ = _e5548;
                                                let _e5551 = local_65;
                                                phi_7293_ = _e5551;
                                                let _e5554 = local_66;
                                                phi_7294_ = _e5554;
                                                let _e5557 = local_67;
                                                phi_7295_ = _e5557;
                                                let _e5560 = local_68;
                                                phi_7296_ = _e5560;
                                            }
                                            let _e3114 = phi_7289_;
                                            let _e3116 = phi_7290_;
                                            let _e3118 = phi_7291_;
                                            let _e3120 = phi_7292_;
                                            let _e3122 = phi_7293_;
                                            let _e3124 = phi_7294_;
                                            let _e3126 = phi_7295_;
                                            let _e3128 = phi_7296_;
                                            if _e3116 {
                                                let _e5563 = local_69;
                                                phi_7300_ = _e5563;
                                                phi_7301_ = true;
                                                phi_7302_ = false;
                                                phi_7303_ = false;
                                                phi_7304_ = false;
                                                phi_7305_ = false;
                                                phi_7306_ = false;
                                                phi_7307_ = false;
                                            } else {
                                                let _e5565 = local_70;
                                                phi_7300_ = _e5565;
                                                phi_7301_ = _e3118;
                                                phi_7302_ = _e3120;
                                                phi_7303_ = _e3122;
                                                phi_7304_ = _e3124;
                                                let _e5572 = local_71;
                                                phi_7305_ = _e5572;
                                                phi_7306_ = _e3126;
                                                phi_7307_ = _e3128;
                                            }
                                            let _e3130 = phi_7300_;
                                            let _e3132 = phi_7301_;
                                            let _e3134 = phi_7302_;
                                            let _e3136 = phi_7303_;
                                            let _e3138 = phi_7304_;
                                            let _e3140 = phi_7305_;
                                            let _e3142 = phi_7306_;
                                            let _e3144 = phi_7307_;
                                            if _e3132 {
                                                phi_7312_ = type_72(1u, _e3130);
                                                phi_7313_ = false;
                                                phi_7314_ = false;
                                                phi_7315_ = false;
                                                phi_7316_ = false;
                                                phi_7317_ = false;
                                                phi_7318_ = false;
                                            } else {
                                                phi_7312_ = type_72();
                                                phi_7313_ = _e3134;
                                                phi_7314_ = _e3136;
                                                phi_7315_ = _e3138;
                                                phi_7316_ = _e3140;
                                                phi_7317_ = _e3142;
                                                phi_7318_ = _e3144;
                                            }
                                            let _e3147 = phi_7312_;
                                            let _e3149 = phi_7313_;
                                            let _e3151 = phi_7314_;
                                            let _e3153 = phi_7315_;
                                            let _e3155 = phi_7316_;
                                            let _e3157 = phi_7317_;
                                            let _e3159 = phi_7318_;
                                            if _e3149 {
                                                let _e3161 = local_32;
                                                phi_7323_ = type_72(1u, _e3161);
                                                phi_7324_ = false;
                                                phi_7325_ = false;
                                                phi_7326_ = true;
                                                phi_7327_ = false;
                                                phi_7328_ = false;
                                            } else {
                                                phi_7323_ = _e3114;
                                                phi_7324_ = _e3151;
                                                phi_7325_ = _e3153;
                                                phi_7326_ = _e3155;
                                                phi_7327_ = _e3157;
                                                phi_7328_ = _e3159;
                                            }
                                            let _e3164 = phi_7323_;
                                            let _e3166 = phi_7324_;
                                            let _e3168 = phi_7325_;
                                            let _e3170 = phi_7326_;
                                            let _e3172 = phi_7327_;
                                            let _e3174 = phi_7328_;
                                            if _e3166 {
                                                let _e3176 = local_33;
                                                phi_7333_ = type_72(1u, _e3176);
                                                phi_7334_ = false;
                                                phi_7335_ = false;
                                                phi_7336_ = false;
                                                phi_7337_ = false;
                                            } else {
                                                phi_7333_ = type_72();
                                                phi_7334_ = _e3168;
                                                phi_7335_ = _e3170;
                                                phi_7336_ = _e3172;
                                                phi_7337_ = _e3174;
                                            }
                                            let _e3179 = phi_7333_;
                                            let _e3181 = phi_7334_;
                                            let _e3183 = phi_7335_;
                                            let _e3185 = phi_7336_;
                                            let _e3187 = phi_7337_;
                                            if _e3181 {
                                                let _e3189 = local_34;
                                                phi_7342_ = type_72(1u, _e3189);
                                                phi_7343_ = true;
                                                phi_7344_ = false;
                                                phi_7345_ = false;
                                                phi_7346_ = false;
                                            } else {
                                                phi_7342_ = _e3179;
                                                phi_7343_ = _e3166;
                                                phi_7344_ = _e3183;
                                                phi_7345_ = _e3185;
                                                phi_7346_ = _e3187;
                                            }
                                            let _e3192 = phi_7342_;
                                            let _e3194 = phi_7343_;
                                            let _e3196 = phi_7344_;
                                            let _e3198 = phi_7345_;
                                            let _e3200 = phi_7346_;
                                            if _e3194 {
                                                phi_7350_ = _e3192;
                                                phi_7351_ = true;
                                                phi_7352_ = false;
                                                phi_7353_ = false;
                                            } else {
                                                phi_7350_ = _e3164;
                                                phi_7351_ = _e3196;
                                                phi_7352_ = _e3198;
                                                phi_7353_ = _e3200;
                                            }
                                            let _e3202 = phi_7350_;
                                            let _e3204 = phi_7351_;
                                            let _e3206 = phi_7352_;
                                            let _e3208 = phi_7353_;
                                            if _e3204 {
                                                phi_7357_ = false;
                                                phi_7358_ = false;
                                            } else {
                                                phi_7357_ = _e3206;
                                                phi_7358_ = _e3208;
                                            }
                                            let _e3210 = phi_7357_;
                                            let _e3212 = phi_7358_;
                                            if _e3210 {
                                                phi_7362_ = false;
                                                phi_7363_ = false;
                                            } else {
                                                phi_7362_ = _e3212;
                                                phi_7363_ = _e3204;
                                            }
                                            let _e3214 = phi_7362_;
                                            let _e3216 = phi_7363_;
                                            if _e3214 {
                                                phi_7367_ = true;
                                                phi_7368_ = false;
                                            } else {
                                                phi_7367_ = _e3210;
                                                phi_7368_ = _e3216;
                                            }
                                            let _e3218 = phi_7367_;
                                            let _e3220 = phi_7368_;
                                            if _e3218 {
                                                let _e3222 = local_35;
                                                phi_7373_ = type_72(1u, _e3222);
                                                phi_7374_ = true;
                                            } else {
                                                phi_7373_ = _e3202;
                                                phi_7374_ = _e3220;
                                            }
                                            let _e3225 = phi_7373_;
                                            let _e3227 = phi_7374_;
                                            if _e3227 {
                                                phi_7378_ = _e3225;
                                            } else {
                                                phi_7378_ = _e3147;
                                            }
                                            let _e3229 = phi_7378_;
                                            let _e3232 = (_e3229.member != 0u);
                                            if _e3232 {
                                                phi_7385_ = false;
                                            } else {
                                                phi_7385_ = true;
                                            }
                                            let _e3234 = phi_7385_;
                                            phi_7386_ = _e3229.member_1;
                                            phi_7387_ = _e3234;
                                            phi_7388_ = _e3232;
                                            phi_7389_ = false;
                                        } else {
                                            phi_7386_ = f64();
                                            phi_7387_ = false;
                                            phi_7388_ = false;
                                            phi_7389_ = true;
                                        }
                                        let _e3236 = phi_7386_;
                                        let _e3238 = phi_7387_;
                                        let _e3240 = phi_7388_;
                                        let _e3242 = phi_7389_;
                                        phi_7390_ = _e3236;
                                        phi_7391_ = _e3238;
                                        phi_7392_ = _e3240;
                                        phi_7393_ = _e3242;
                                    }
                                    let _e3244 = phi_7390_;
                                    let _e3246 = phi_7391_;
                                    let _e3248 = phi_7392_;
                                    let _e3250 = phi_7393_;
                                    phi_7394_ = _e3244;
                                    phi_7395_ = _e2170;
                                    phi_7396_ = _e3246;
                                    phi_7397_ = _e3248;
                                    phi_7398_ = _e3250;
                                }
                                let _e3252 = phi_7394_;
                                let _e3254 = phi_7395_;
                                let _e3256 = phi_7396_;
                                let _e3258 = phi_7397_;
                                let _e3260 = phi_7398_;
                                if _e3254 {
                                    phi_7402_ = true;
                                    phi_7403_ = false;
                                    phi_7404_ = false;
                                } else {
                                    phi_7402_ = _e3256;
                                    phi_7403_ = _e3258;
                                    phi_7404_ = _e3260;
                                }
                                let _e3262 = phi_7402_;
                                let _e3264 = phi_7403_;
                                let _e3266 = phi_7404_;
                                phi_7405_ = _e3252;
                                phi_7406_ = _e1428;
                                phi_7407_ = _e3262;
                                phi_7408_ = false;
                                phi_7409_ = _e3264;
                                phi_7410_ = _e3266;
                            } else {
                                phi_7405_ = f64();
                                phi_7406_ = type_73();
                                phi_7407_ = false;
                                phi_7408_ = true;
                                phi_7409_ = false;
                                phi_7410_ = false;
                            }
                            let _e3268 = phi_7405_;
                            let _e3270 = phi_7406_;
                            let _e3272 = phi_7407_;
                            let _e3274 = phi_7408_;
                            let _e3276 = phi_7409_;
                            let _e3278 = phi_7410_;
                            local_36 = _e3274;
                            local_72 = _e3276;
                            local_73 = _e3278;
                            local_37 = _e3268;
                            local_38 = _e3270;
                            continue;
                            continuing {
                                phi_4359_ = _e1109;
                                break if !(_e3272);
                            }
                        }
                        let _e3281 = local_36;
                        if _e3281 {
                            phi_7415_ = type_72(0u, type_72().member_1);
                            phi_7416_ = false;
                            phi_7417_ = false;
                        } else {
                            phi_7415_ = type_72();
                            let _e5642 = local_72;
                            phi_7416_ = _e5642;
                            let _e5645 = local_73;
                            phi_7417_ = _e5645;
                        }
                        let _e3286 = phi_7415_;
                        let _e3288 = phi_7416_;
                        let _e3290 = phi_7417_;
                        if _e3288 {
                            let _e3292 = local_37;
                            phi_7422_ = type_72(2u, _e3292);
                            phi_7423_ = false;
                        } else {
                            phi_7422_ = type_72();
                            phi_7423_ = _e3290;
                        }
                        let _e3295 = phi_7422_;
                        let _e3297 = phi_7423_;
                        if _e3297 {
                            let _e3299 = local_38;
                            phi_7429_ = type_72(1u, _e3299.member);
                            phi_7430_ = true;
                        } else {
                            phi_7429_ = _e3295;
                            phi_7430_ = _e3288;
                        }
                        let _e3303 = phi_7429_;
                        let _e3305 = phi_7430_;
                        if _e3305 {
                            phi_7434_ = _e3303;
                        } else {
                            phi_7434_ = _e3286;
                        }
                        let _e3307 = phi_7434_;
                        phi_7438_ = _e3307;
                    }
                    let _e5013 = phi_7438_;
                    phi_7439_ = _e5013;
                }
                let _e5018 = phi_7439_;
                switch bitcast<i32>(_e5018.member) {
                    case 0: {
                        phi_7452_ = type_46(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5024 = function_(_e5018.member_1);
                        phi_7452_ = type_46(0u, _e5024, true);
                        break;
                    }
                    case 2: {
                        let _e5022 = function_(_e5018.member_1);
                        phi_7452_ = type_46(1u, _e5022, true);
                        break;
                    }
                    default: {
                        phi_7452_ = type_46();
                        break;
                    }
                }
                let _e5027 = phi_7452_;
                if _e5027.member_2 {
                    let _e5034 = (_e5027.member_1[1] >> bitcast<u32>(20i));
                    if (_e5034 <= 896u) {
                        phi_7475_ = 0u;
                    } else {
                        phi_7475_ = ((((_e5034 - 896u) << bitcast<u32>(23i)) | ((_e5027.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5027.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5049 = phi_7475_;
                    let _e5051 = atomicMin((&earliest.member[0u]), _e5049);
                }
                phi_7479_ = type_45(_e186, _e5027.member, _e192, _e195, _e5027.member_1);
                phi_7480_ = _e5027.member_2;
            } else {
                phi_7479_ = type_45(_e186, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_7480_ = false;
            }
            let _e5053 = phi_7479_;
            let _e5055 = phi_7480_;
            let _e5057 = params.member.member_1;
            if ((_e5057 & 16u) != 0u) {
                if (_e117 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5055 {
                    let _e5063 = atomicAdd((&counters[0u]), 1u);
                    phi_7498_ = _e5063;
                } else {
                    phi_7498_ = 0u;
                }
                let _e5065 = phi_7498_;
                workgroupBarrier();
                if (_e117 == 0u) {
                    let _e5068 = atomicLoad((&counters[0u]));
                    if (_e5068 > 0u) {
                        let _e5071 = atomicAdd((&contacts.member[0u]), _e5068);
                        atomicStore((&counters[1u]), _e5071);
                    }
                }
                workgroupBarrier();
                let _e5074 = atomicLoad((&counters[1u]));
                let _e5075 = (_e5074 + _e5065);
                if _e5055 {
                    let _e5077 = params.member.member_16;
                    if (_e5075 < _e5077) {
                        let _e5079 = (6u * _e5075);
                        atomicStore((&contacts.member[(4u + _e5079)]), _e5053.member);
                        atomicStore((&contacts.member[(_e5079 + 5u)]), _e5053.member_1);
                        atomicStore((&contacts.member[(_e5079 + 6u)]), _e5053.member_2);
                        atomicStore((&contacts.member[(_e5079 + 7u)]), _e5053.member_3);
                        atomicStore((&contacts.member[(_e5079 + 8u)]), _e5053.member_4[0]);
                        atomicStore((&contacts.member[(_e5079 + 9u)]), _e5053.member_4[1]);
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
