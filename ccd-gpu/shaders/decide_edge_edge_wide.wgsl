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
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_50 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_52 {
    member: f64,
    member_1: f64,
}

struct type_60 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_62 {
    member: array<f64, 3>,
    member_1: array<f64, 3>,
}

struct type_65 {
    member: array<type_62>,
}

struct type_71 {
    member: u32,
    member_1: f64,
}

struct type_72 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_76 {
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
var<storage, read_write> earliest: type_76;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> wide: type_65;
@group(0) @binding(3) 
var<storage> elements: type_20;
@group(0) @binding(4) 
var<storage> input: type_16;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_76;

fn function_() {
    var local: array<array<f64, 3>, 4>;
    var local_1: array<array<f64, 3>, 4>;
    var local_2: array<array<f64, 3>, 4>;
    var local_3: type_50;
    var local_4: type_50;
    var local_5: type_50;
    var local_6: array<type_52, 4>;
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
    var local_20: type_60;
    var phi_228_: u32;
    var phi_244_: u32;
    var phi_265_: u32;
    var phi_266_: u32;
    var phi_269_: type_28;
    var phi_270_: type_28;
    var phi_293_: type_28;
    var phi_635_: type_28;
    var phi_636_: type_28;
    var phi_659_: type_28;
    var phi_515_: type_28;
    var phi_516_: type_28;
    var phi_539_: type_28;
    var phi_549_: type_28;
    var phi_550_: type_28;
    var phi_573_: type_28;
    var phi_1116_: f64;
    var phi_1123_: f64;
    var phi_1128_: f64;
    var phi_1135_: f64;
    var phi_1140_: f64;
    var phi_1153_: f64;
    var phi_1160_: f64;
    var phi_1165_: f64;
    var phi_1172_: f64;
    var phi_1177_: f64;
    var phi_1182_: f64;
    var phi_1199_: f64;
    var phi_1206_: f64;
    var phi_1211_: f64;
    var phi_1218_: f64;
    var phi_1223_: f64;
    var phi_1237_: f64;
    var phi_1244_: f64;
    var phi_1249_: f64;
    var phi_1256_: f64;
    var phi_1261_: f64;
    var phi_1266_: f64;
    var phi_1283_: f64;
    var phi_1290_: f64;
    var phi_1295_: f64;
    var phi_1302_: f64;
    var phi_1307_: f64;
    var phi_1321_: f64;
    var phi_1328_: f64;
    var phi_1333_: f64;
    var phi_1340_: f64;
    var phi_1345_: f64;
    var phi_1350_: f64;
    var phi_1387_: f64;
    var phi_1393_: f64;
    var phi_1400_: f64;
    var phi_1407_: f64;
    var phi_1413_: f64;
    var phi_1420_: f64;
    var phi_1426_: f64;
    var phi_1432_: f64;
    var phi_1438_: f64;
    var phi_1445_: f64;
    var phi_1452_: f64;
    var phi_1480_: f64;
    var phi_1485_: f64;
    var phi_1490_: f64;
    var phi_1495_: f64;
    var phi_1500_: f64;
    var phi_1505_: f64;
    var phi_1516_: f64;
    var phi_4070_: f64;
    var phi_4076_: f64;
    var phi_4081_: f64;
    var phi_4087_: f64;
    var phi_4093_: f64;
    var phi_4098_: f64;
    var phi_4103_: f64;
    var phi_4147_: type_26;
    var phi_4150_: f64;
    var phi_4171_: bool;
    var phi_4177_: type_27;
    var phi_4148_: type_26;
    var phi_4191_: type_27;
    var phi_4151_: f64;
    var local_21: f64;
    var phi_4140_: f64;
    var phi_4204_: f64;
    var phi_4210_: f64;
    var phi_4235_: type_28;
    var phi_4238_: u32;
    var phi_4236_: type_28;
    var phi_4261_: type_28;
    var phi_4305_: u32;
    var phi_4306_: u32;
    var phi_4239_: u32;
    var phi_4307_: u32;
    var phi_4327_: type_28;
    var phi_4328_: type_28;
    var phi_4351_: type_28;
    var phi_4405_: f64;
    var phi_4412_: f64;
    var phi_4433_: bool;
    var phi_4434_: bool;
    var phi_4435_: bool;
    var phi_4436_: bool;
    var phi_4437_: bool;
    var phi_4438_: bool;
    var phi_4439_: bool;
    var phi_4440_: bool;
    var phi_4441_: bool;
    var phi_4442_: bool;
    var phi_4443_: bool;
    var phi_4453_: bool;
    var phi_4454_: bool;
    var phi_4455_: bool;
    var phi_4456_: bool;
    var phi_4462_: type_72;
    var phi_4463_: bool;
    var phi_4476_: f64;
    var phi_4489_: type_28;
    var phi_4492_: f64;
    var phi_4494_: f64;
    var phi_4496_: f64;
    var phi_4490_: type_28;
    var phi_4519_: type_28;
    var phi_4546_: f64;
    var phi_4547_: f64;
    var phi_4575_: f64;
    var phi_4591_: f64;
    var phi_4598_: bool;
    var phi_4599_: bool;
    var phi_4600_: bool;
    var phi_4606_: f64;
    var phi_4607_: f64;
    var phi_4608_: bool;
    var phi_4493_: f64;
    var phi_4495_: f64;
    var phi_4497_: f64;
    var phi_4609_: f64;
    var phi_4610_: bool;
    var phi_4611_: bool;
    var local_22: bool;
    var phi_4615_: f64;
    var phi_4616_: f64;
    var phi_4624_: type_28;
    var phi_4627_: f64;
    var phi_4625_: type_28;
    var phi_4650_: type_28;
    var phi_4693_: f64;
    var phi_4703_: f64;
    var phi_4713_: bool;
    var phi_4715_: bool;
    var phi_4720_: f64;
    var phi_4721_: bool;
    var phi_4722_: f64;
    var phi_4723_: bool;
    var phi_4724_: bool;
    var phi_4725_: bool;
    var phi_4726_: f64;
    var phi_4628_: f64;
    var phi_4727_: bool;
    var phi_4728_: bool;
    var phi_4729_: bool;
    var phi_4730_: bool;
    var local_23: bool;
    var phi_4734_: bool;
    var phi_4735_: bool;
    var phi_4739_: bool;
    var phi_4743_: f64;
    var phi_4744_: f64;
    var phi_4746_: type_72;
    var phi_4777_: f64;
    var phi_4784_: f64;
    var phi_4789_: f64;
    var phi_4796_: f64;
    var phi_4801_: f64;
    var phi_4814_: f64;
    var phi_4821_: f64;
    var phi_4826_: f64;
    var phi_4833_: f64;
    var phi_4838_: f64;
    var phi_4843_: f64;
    var phi_4902_: f64;
    var phi_4908_: f64;
    var phi_4913_: f64;
    var phi_4919_: f64;
    var phi_4924_: f64;
    var phi_4938_: f64;
    var phi_4944_: f64;
    var phi_4949_: f64;
    var phi_4955_: f64;
    var phi_4960_: f64;
    var phi_4986_: f64;
    var phi_4993_: f64;
    var phi_4998_: f64;
    var phi_5005_: f64;
    var phi_5010_: f64;
    var phi_5023_: f64;
    var phi_5030_: f64;
    var phi_5035_: f64;
    var phi_5042_: f64;
    var phi_5047_: f64;
    var phi_5052_: f64;
    var phi_5111_: f64;
    var phi_5117_: f64;
    var phi_5122_: f64;
    var phi_5128_: f64;
    var phi_5133_: f64;
    var phi_5147_: f64;
    var phi_5153_: f64;
    var phi_5158_: f64;
    var phi_5164_: f64;
    var phi_5169_: f64;
    var phi_5195_: f64;
    var phi_5202_: f64;
    var phi_5207_: f64;
    var phi_5214_: f64;
    var phi_5219_: f64;
    var phi_5232_: f64;
    var phi_5239_: f64;
    var phi_5244_: f64;
    var phi_5251_: f64;
    var phi_5256_: f64;
    var phi_5261_: f64;
    var phi_5320_: f64;
    var phi_5326_: f64;
    var phi_5331_: f64;
    var phi_5337_: f64;
    var phi_5342_: f64;
    var phi_5356_: f64;
    var phi_5362_: f64;
    var phi_5367_: f64;
    var phi_5373_: f64;
    var phi_5378_: f64;
    var phi_5427_: f64;
    var phi_5433_: f64;
    var phi_5461_: f64;
    var phi_5467_: f64;
    var phi_5472_: u32;
    var phi_5473_: u32;
    var phi_5443_: f64;
    var phi_5449_: f64;
    var phi_5454_: u32;
    var phi_5455_: u32;
    var phi_5474_: u32;
    var phi_5475_: u32;
    var phi_5546_: f64;
    var phi_5558_: f64;
    var phi_5697_: f64;
    var phi_5703_: f64;
    var phi_5710_: f64;
    var phi_5754_: type_28;
    var phi_5757_: bool;
    var phi_5755_: type_28;
    var phi_5780_: type_28;
    var phi_5807_: bool;
    var phi_5808_: bool;
    var phi_5758_: bool;
    var phi_5809_: bool;
    var phi_5810_: bool;
    var local_24: bool;
    var phi_5814_: bool;
    var local_25: bool;
    var phi_5821_: u32;
    var phi_5822_: u32;
    var phi_5823_: bool;
    var phi_5824_: u32;
    var phi_5825_: u32;
    var phi_5826_: bool;
    var phi_5830_: u32;
    var phi_5851_: bool;
    var phi_5852_: bool;
    var phi_5853_: bool;
    var phi_6050_: f64;
    var phi_6057_: f64;
    var phi_6062_: f64;
    var phi_6069_: f64;
    var phi_6074_: f64;
    var phi_6087_: f64;
    var phi_6094_: f64;
    var phi_6099_: f64;
    var phi_6106_: f64;
    var phi_6111_: f64;
    var phi_6116_: f64;
    var phi_6133_: f64;
    var phi_6140_: f64;
    var phi_6145_: f64;
    var phi_6152_: f64;
    var phi_6157_: f64;
    var phi_6171_: f64;
    var phi_6178_: f64;
    var phi_6183_: f64;
    var phi_6190_: f64;
    var phi_6195_: f64;
    var phi_6200_: f64;
    var phi_6217_: f64;
    var phi_6224_: f64;
    var phi_6229_: f64;
    var phi_6236_: f64;
    var phi_6241_: f64;
    var phi_6255_: f64;
    var phi_6262_: f64;
    var phi_6267_: f64;
    var phi_6274_: f64;
    var phi_6279_: f64;
    var phi_6284_: f64;
    var phi_6304_: type_28;
    var phi_6307_: f64;
    var phi_6305_: type_28;
    var phi_6330_: type_28;
    var phi_6486_: bool;
    var phi_6487_: bool;
    var phi_6488_: bool;
    var phi_6489_: bool;
    var phi_6490_: bool;
    var phi_6491_: bool;
    var phi_6521_: bool;
    var phi_6522_: bool;
    var phi_6523_: bool;
    var phi_6524_: bool;
    var phi_6548_: array<f64, 3>;
    var phi_6549_: bool;
    var phi_6550_: array<f64, 3>;
    var phi_6551_: bool;
    var phi_6552_: bool;
    var phi_6553_: array<f64, 3>;
    var phi_6554_: bool;
    var phi_6555_: bool;
    var phi_6559_: bool;
    var phi_6592_: f64;
    var phi_6594_: f64;
    var phi_6624_: f64;
    var phi_6626_: f64;
    var phi_6656_: f64;
    var phi_6658_: f64;
    var phi_6691_: f64;
    var phi_6693_: f64;
    var phi_6848_: type_28;
    var phi_6851_: array<f64, 3>;
    var phi_6849_: type_28;
    var phi_6874_: type_28;
    var phi_6941_: array<f64, 3>;
    var phi_6852_: array<f64, 3>;
    var phi_6942_: array<f64, 3>;
    var phi_6949_: f64;
    var phi_6956_: f64;
    var phi_6964_: f64;
    var phi_7009_: type_26;
    var phi_7012_: f64;
    var phi_7033_: bool;
    var phi_7039_: type_27;
    var phi_7010_: type_26;
    var phi_7053_: type_27;
    var phi_7013_: f64;
    var local_26: f64;
    var phi_7002_: f64;
    var phi_7066_: f64;
    var phi_7079_: type_28;
    var phi_7082_: f64;
    var phi_7080_: type_28;
    var phi_7105_: type_28;
    var phi_7156_: f64;
    var phi_7162_: f64;
    var phi_7176_: bool;
    var phi_7177_: bool;
    var phi_7204_: f64;
    var phi_7205_: f64;
    var phi_7206_: f64;
    var phi_7207_: f64;
    var phi_7208_: bool;
    var phi_7083_: f64;
    var phi_7209_: bool;
    var phi_7210_: bool;
    var local_27: bool;
    var local_28: f64;
    var local_29: f64;
    var local_30: f64;
    var phi_7228_: bool;
    var phi_7229_: bool;
    var phi_7230_: bool;
    var phi_7231_: bool;
    var phi_7232_: bool;
    var phi_7233_: bool;
    var phi_7234_: bool;
    var phi_7235_: bool;
    var phi_7236_: bool;
    var phi_7237_: bool;
    var phi_7238_: bool;
    var phi_7239_: bool;
    var phi_7240_: f64;
    var phi_7241_: f64;
    var phi_7242_: bool;
    var phi_7243_: bool;
    var phi_7244_: bool;
    var phi_7245_: bool;
    var phi_7246_: bool;
    var phi_7247_: bool;
    var phi_7248_: f64;
    var phi_7249_: f64;
    var phi_7250_: bool;
    var phi_7251_: bool;
    var phi_7252_: bool;
    var phi_7253_: bool;
    var phi_7254_: bool;
    var phi_7255_: bool;
    var phi_7256_: bool;
    var phi_7257_: f64;
    var phi_6308_: f64;
    var phi_7258_: bool;
    var phi_7259_: bool;
    var phi_7260_: bool;
    var phi_7261_: bool;
    var phi_7262_: bool;
    var phi_7263_: bool;
    var phi_7264_: bool;
    var phi_7265_: bool;
    var local_31: bool;
    var phi_7270_: type_71;
    var phi_7271_: bool;
    var phi_7272_: bool;
    var phi_7273_: bool;
    var phi_7274_: bool;
    var phi_7275_: bool;
    var phi_7276_: bool;
    var phi_7280_: f64;
    var phi_7281_: bool;
    var phi_7282_: bool;
    var phi_7283_: bool;
    var phi_7284_: bool;
    var phi_7285_: bool;
    var phi_7286_: bool;
    var phi_7291_: type_71;
    var phi_7292_: bool;
    var phi_7293_: bool;
    var phi_7294_: bool;
    var phi_7295_: bool;
    var phi_7296_: bool;
    var local_32: f64;
    var phi_7301_: type_71;
    var phi_7302_: bool;
    var phi_7303_: bool;
    var phi_7304_: bool;
    var phi_7305_: bool;
    var local_33: f64;
    var phi_7310_: type_71;
    var phi_7311_: bool;
    var phi_7312_: bool;
    var phi_7313_: bool;
    var phi_7317_: bool;
    var phi_7318_: bool;
    var phi_7322_: bool;
    var phi_7323_: bool;
    var phi_7327_: bool;
    var phi_7328_: bool;
    var local_34: f64;
    var phi_7333_: type_71;
    var phi_7334_: bool;
    var phi_7338_: type_71;
    var phi_7345_: bool;
    var phi_7346_: f64;
    var phi_7347_: bool;
    var phi_7348_: bool;
    var phi_7349_: bool;
    var phi_7350_: f64;
    var phi_7351_: bool;
    var phi_7352_: bool;
    var phi_7353_: bool;
    var phi_7354_: f64;
    var phi_7355_: bool;
    var phi_7356_: bool;
    var phi_7357_: bool;
    var phi_7358_: bool;
    var phi_7362_: bool;
    var phi_7363_: bool;
    var phi_7364_: bool;
    var phi_7365_: f64;
    var phi_7366_: type_72;
    var phi_7367_: bool;
    var phi_7368_: bool;
    var phi_7369_: bool;
    var phi_7370_: bool;
    var local_35: bool;
    var phi_7375_: type_71;
    var phi_7376_: bool;
    var phi_7377_: bool;
    var local_36: f64;
    var phi_7382_: type_71;
    var phi_7383_: bool;
    var local_37: type_72;
    var phi_7389_: type_71;
    var phi_7390_: bool;
    var phi_7394_: type_71;
    var phi_1719_: f64;
    var phi_1726_: f64;
    var phi_1731_: f64;
    var phi_1738_: f64;
    var phi_1743_: f64;
    var phi_1756_: f64;
    var phi_1763_: f64;
    var phi_1768_: f64;
    var phi_1775_: f64;
    var phi_1780_: f64;
    var phi_1785_: f64;
    var phi_1802_: f64;
    var phi_1809_: f64;
    var phi_1814_: f64;
    var phi_1821_: f64;
    var phi_1826_: f64;
    var phi_1840_: f64;
    var phi_1847_: f64;
    var phi_1852_: f64;
    var phi_1859_: f64;
    var phi_1864_: f64;
    var phi_1869_: f64;
    var phi_1886_: f64;
    var phi_1893_: f64;
    var phi_1898_: f64;
    var phi_1905_: f64;
    var phi_1910_: f64;
    var phi_1924_: f64;
    var phi_1931_: f64;
    var phi_1936_: f64;
    var phi_1943_: f64;
    var phi_1948_: f64;
    var phi_1953_: f64;
    var phi_1973_: type_28;
    var phi_1976_: f64;
    var phi_1974_: type_28;
    var phi_1999_: type_28;
    var phi_2155_: bool;
    var phi_2156_: bool;
    var phi_2157_: bool;
    var phi_2158_: bool;
    var phi_2159_: bool;
    var phi_2160_: bool;
    var phi_2190_: bool;
    var phi_2191_: bool;
    var phi_2192_: bool;
    var phi_2193_: bool;
    var phi_2217_: array<f64, 3>;
    var phi_2218_: bool;
    var phi_2219_: array<f64, 3>;
    var phi_2220_: bool;
    var phi_2221_: bool;
    var phi_2222_: array<f64, 3>;
    var phi_2223_: bool;
    var phi_2224_: bool;
    var phi_2228_: bool;
    var phi_2261_: f64;
    var phi_2263_: f64;
    var phi_2293_: f64;
    var phi_2295_: f64;
    var phi_2325_: f64;
    var phi_2327_: f64;
    var phi_2360_: f64;
    var phi_2362_: f64;
    var phi_2517_: type_28;
    var phi_2520_: array<f64, 3>;
    var phi_2518_: type_28;
    var phi_2543_: type_28;
    var phi_2610_: array<f64, 3>;
    var phi_2521_: array<f64, 3>;
    var phi_2611_: array<f64, 3>;
    var phi_2618_: f64;
    var phi_2625_: f64;
    var phi_2633_: f64;
    var phi_2678_: type_26;
    var phi_2681_: f64;
    var phi_2702_: bool;
    var phi_2708_: type_27;
    var phi_2679_: type_26;
    var phi_2722_: type_27;
    var phi_2682_: f64;
    var local_38: f64;
    var phi_2671_: f64;
    var phi_2735_: f64;
    var phi_2748_: type_28;
    var phi_2751_: f64;
    var phi_2749_: type_28;
    var phi_2774_: type_28;
    var phi_2825_: f64;
    var phi_2831_: f64;
    var phi_2845_: bool;
    var phi_2846_: bool;
    var phi_2873_: f64;
    var phi_2874_: f64;
    var phi_2875_: f64;
    var phi_2876_: f64;
    var phi_2877_: bool;
    var phi_2752_: f64;
    var phi_2878_: bool;
    var phi_2879_: bool;
    var local_39: bool;
    var local_40: f64;
    var local_41: f64;
    var local_42: f64;
    var phi_2897_: bool;
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
    var phi_2909_: f64;
    var phi_2910_: f64;
    var phi_2911_: bool;
    var phi_2912_: bool;
    var phi_2913_: bool;
    var phi_2914_: bool;
    var phi_2915_: bool;
    var phi_2916_: bool;
    var phi_2917_: f64;
    var phi_2918_: f64;
    var phi_2919_: bool;
    var phi_2920_: bool;
    var phi_2921_: bool;
    var phi_2922_: bool;
    var phi_2923_: bool;
    var phi_2924_: bool;
    var phi_2925_: bool;
    var phi_2926_: f64;
    var phi_1977_: f64;
    var phi_2927_: bool;
    var phi_2928_: bool;
    var phi_2929_: bool;
    var phi_2930_: bool;
    var phi_2931_: bool;
    var phi_2932_: bool;
    var phi_2933_: bool;
    var phi_2934_: bool;
    var local_43: bool;
    var phi_2939_: type_71;
    var phi_2940_: bool;
    var phi_2941_: bool;
    var phi_2942_: bool;
    var phi_2943_: bool;
    var phi_2944_: bool;
    var phi_2945_: bool;
    var phi_2949_: f64;
    var phi_2950_: bool;
    var phi_2951_: bool;
    var phi_2952_: bool;
    var phi_2953_: bool;
    var phi_2954_: bool;
    var phi_2955_: bool;
    var phi_2960_: type_71;
    var phi_2961_: bool;
    var phi_2962_: bool;
    var phi_2963_: bool;
    var phi_2964_: bool;
    var phi_2965_: bool;
    var local_44: f64;
    var phi_2970_: type_71;
    var phi_2971_: bool;
    var phi_2972_: bool;
    var phi_2973_: bool;
    var phi_2974_: bool;
    var local_45: f64;
    var phi_2979_: type_71;
    var phi_2980_: bool;
    var phi_2981_: bool;
    var phi_2982_: bool;
    var phi_2986_: bool;
    var phi_2987_: bool;
    var phi_2991_: bool;
    var phi_2992_: bool;
    var phi_2996_: bool;
    var phi_2997_: bool;
    var local_46: f64;
    var phi_3002_: type_71;
    var phi_3003_: bool;
    var phi_3007_: type_71;
    var phi_3021_: type_28;
    var phi_3022_: type_28;
    var phi_3045_: type_28;
    var phi_3066_: f64;
    var phi_3216_: bool;
    var phi_3217_: bool;
    var phi_3218_: bool;
    var phi_3219_: bool;
    var phi_3220_: bool;
    var phi_3221_: bool;
    var phi_3251_: bool;
    var phi_3252_: bool;
    var phi_3253_: bool;
    var phi_3254_: bool;
    var phi_3278_: array<f64, 3>;
    var phi_3279_: bool;
    var phi_3280_: array<f64, 3>;
    var phi_3281_: bool;
    var phi_3282_: bool;
    var phi_3283_: array<f64, 3>;
    var phi_3284_: bool;
    var phi_3285_: bool;
    var phi_3289_: bool;
    var phi_3322_: f64;
    var phi_3324_: f64;
    var phi_3354_: f64;
    var phi_3356_: f64;
    var phi_3386_: f64;
    var phi_3388_: f64;
    var phi_3421_: f64;
    var phi_3423_: f64;
    var phi_3578_: type_28;
    var phi_3581_: array<f64, 3>;
    var phi_3579_: type_28;
    var phi_3604_: type_28;
    var phi_3671_: array<f64, 3>;
    var phi_3582_: array<f64, 3>;
    var phi_3672_: array<f64, 3>;
    var phi_3704_: type_26;
    var phi_3707_: f64;
    var phi_3728_: bool;
    var phi_3734_: type_27;
    var phi_3705_: type_26;
    var phi_3748_: type_27;
    var phi_3708_: f64;
    var local_47: f64;
    var phi_3697_: f64;
    var phi_3761_: f64;
    var phi_3779_: f64;
    var phi_3786_: f64;
    var phi_3791_: f64;
    var phi_3798_: f64;
    var phi_3803_: f64;
    var phi_3816_: f64;
    var phi_3823_: f64;
    var phi_3828_: f64;
    var phi_3835_: f64;
    var phi_3840_: f64;
    var phi_3845_: f64;
    var phi_3862_: f64;
    var phi_3869_: f64;
    var phi_3874_: f64;
    var phi_3881_: f64;
    var phi_3886_: f64;
    var phi_3900_: f64;
    var phi_3907_: f64;
    var phi_3912_: f64;
    var phi_3919_: f64;
    var phi_3924_: f64;
    var phi_3929_: f64;
    var phi_3946_: f64;
    var phi_3953_: f64;
    var phi_3958_: f64;
    var phi_3965_: f64;
    var phi_3970_: f64;
    var phi_3984_: f64;
    var phi_3991_: f64;
    var phi_3996_: f64;
    var phi_4003_: f64;
    var phi_4008_: f64;
    var phi_4013_: f64;
    var phi_4037_: bool;
    var phi_4038_: bool;
    var phi_4039_: bool;
    var local_48: bool;
    var phi_4044_: type_71;
    var phi_4045_: bool;
    var phi_4050_: type_71;
    var phi_4051_: bool;
    var phi_4053_: type_71;
    var phi_4054_: type_71;
    var phi_4055_: bool;
    var phi_4059_: type_71;
    var phi_7398_: type_71;
    var phi_7399_: type_71;
    var phi_7420_: type_45;
    var phi_7443_: u32;
    var phi_7464_: u32;
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
        phi_228_ = _e132;
    } else {
        phi_228_ = _e134;
    }
    let _e137 = phi_228_;
    let _e138 = (_e137 / 64u);
    if ((_e137 % 64u) > 0u) {
        phi_244_ = (_e138 + 1u);
    } else {
        phi_244_ = _e138;
    }
    let _e143 = phi_244_;
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
            phi_265_ = (_e147 + 1u);
        } else {
            phi_265_ = _e147;
        }
        let _e153 = phi_265_;
        phi_266_ = _e153;
    } else {
        phi_266_ = 0u;
    }
    let _e155 = phi_266_;
    phi_269_ = type_28(0u, _e155);
    loop {
        let _e158 = phi_269_;
        if (_e158.member < _e158.member_1) {
            phi_270_ = type_28((_e158.member + 1u), _e158.member_1);
            phi_293_ = type_28(1u, _e158.member);
        } else {
            phi_270_ = _e158;
            phi_293_ = type_28(0u, type_28().member_1);
        }
        let _e172 = phi_270_;
        let _e174 = phi_293_;
        let _e178 = (bitcast<i32>(_e174.member) != 0i);
        if _e178 {
            let _e182 = (((_e127 + (_e174.member_1 * _e130)) * 64u) + _e115);
            let _e184 = params.member.member_8;
            if (_e182 < _e137) {
                let _e199 = (2u * _e182);
                let _e202 = input.member[(4u + _e199)];
                let _e205 = input.member[(_e199 + 5u)];
                let _e207 = elements.member[_e202];
                let _e209 = elements.member[_e205];
                local_15 = array<u32, 4>(_e207[0], _e207[1], _e209[0], _e209[1]);
                local_16[0u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[1u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[2u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[3u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[0u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[1u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[2u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[3u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                let _e224 = params.member.member_1;
                if ((_e224 & 8u) != 0u) {
                    let _e270 = paths.member[_e207[0]];
                    let _e272 = paths.member[_e207[1]];
                    let _e278 = paths.member[_e209[0]];
                    let _e280 = paths.member[_e209[1]];
                    local_18 = array<array<f32, 3>, 4>(array<f32, 3>(_e270.member[0], _e270.member[1], _e270.member[2]), array<f32, 3>(_e272.member[0], _e272.member[1], _e272.member[2]), array<f32, 3>(_e278.member[0], _e278.member[1], _e278.member[2]), array<f32, 3>(_e280.member[0], _e280.member[1], _e280.member[2]));
                    local_19 = array<array<f32, 3>, 4>(array<f32, 3>(_e270.member_1[0], _e270.member_1[1], _e270.member_1[2]), array<f32, 3>(_e272.member_1[0], _e272.member_1[1], _e272.member_1[2]), array<f32, 3>(_e278.member_1[0], _e278.member_1[1], _e278.member_1[2]), array<f32, 3>(_e280.member_1[0], _e280.member_1[1], _e280.member_1[2]));
                    phi_515_ = type_28(0u, 4u);
                    loop {
                        let _e320 = phi_515_;
                        if (_e320.member < _e320.member_1) {
                            phi_516_ = type_28((_e320.member + 1u), _e320.member_1);
                            phi_539_ = type_28(1u, _e320.member);
                        } else {
                            phi_516_ = _e320;
                            phi_539_ = type_28(0u, type_28().member_1);
                        }
                        let _e334 = phi_516_;
                        let _e336 = phi_539_;
                        let _e340 = (bitcast<i32>(_e336.member) != 0i);
                        if _e340 {
                            phi_549_ = type_28(0u, 3u);
                            loop {
                                let _e342 = phi_549_;
                                if (_e342.member < _e342.member_1) {
                                    phi_550_ = type_28((_e342.member + 1u), _e342.member_1);
                                    phi_573_ = type_28(1u, _e342.member);
                                } else {
                                    phi_550_ = _e342;
                                    phi_573_ = type_28(0u, type_28().member_1);
                                }
                                let _e356 = phi_550_;
                                let _e358 = phi_573_;
                                let _e362 = (bitcast<i32>(_e358.member) != 0i);
                                if _e362 {
                                    if (_e336.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e358.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e367 = local_18[_e336.member_1][_e358.member_1];
                                    if (_e336.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e358.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    local_16[_e336.member_1][_e358.member_1] = f64(_e367);
                                    if (_e336.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e358.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e377 = local_19[_e336.member_1][_e358.member_1];
                                    if (_e336.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e358.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    local_17[_e336.member_1][_e358.member_1] = f64(_e377);
                                }
                                continue;
                                continuing {
                                    phi_549_ = _e356;
                                    break if !(_e362);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_515_ = _e334;
                            break if !(_e340);
                        }
                    }
                } else {
                    phi_635_ = type_28(0u, 4u);
                    loop {
                        let _e228 = phi_635_;
                        if (_e228.member < _e228.member_1) {
                            phi_636_ = type_28((_e228.member + 1u), _e228.member_1);
                            phi_659_ = type_28(1u, _e228.member);
                        } else {
                            phi_636_ = _e228;
                            phi_659_ = type_28(0u, type_28().member_1);
                        }
                        let _e242 = phi_636_;
                        let _e244 = phi_659_;
                        let _e248 = (bitcast<i32>(_e244.member) != 0i);
                        if _e248 {
                            if (_e244.member_1 < 4u) {
                            } else {
                                return;
                            }
                            let _e251 = local_15[_e244.member_1];
                            let _e253 = wide.member[_e251];
                            if (_e244.member_1 < 4u) {
                            } else {
                                return;
                            }
                            local_16[_e244.member_1] = array<f64, 3>(_e253.member[0], _e253.member[1], _e253.member[2]);
                            if (_e244.member_1 < 4u) {
                            } else {
                                return;
                            }
                            local_17[_e244.member_1] = array<f64, 3>(_e253.member_1[0], _e253.member_1[1], _e253.member_1[2]);
                        }
                        continue;
                        continuing {
                            phi_635_ = _e242;
                            break if !(_e248);
                        }
                    }
                }
                let _e385 = local_16;
                let _e402 = local_17;
                local_20 = type_60(array<array<f64, 3>, 2>(array<f64, 3>((_e385[2][0] - _e385[0][0]), (_e385[2][1] - _e385[0][1]), (_e385[2][2] - _e385[0][2])), array<f64, 3>((_e402[2][0] - _e402[0][0]), (_e402[2][1] - _e402[0][1]), (_e402[2][2] - _e402[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e385[1][0] - _e385[0][0]), (_e385[1][1] - _e385[0][1]), (_e385[1][2] - _e385[0][2])), array<f64, 3>((_e402[1][0] - _e402[0][0]), (_e402[1][1] - _e402[0][1]), (_e402[1][2] - _e402[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e385[2][0] - _e385[3][0]), (_e385[2][1] - _e385[3][1]), (_e385[2][2] - _e385[3][2])), array<f64, 3>((_e402[2][0] - _e402[3][0]), (_e402[2][1] - _e402[3][1]), (_e402[2][2] - _e402[3][2]))), (0.0lf + 0.0lf));
                let _e449 = params.member.member_7;
                let _e456 = bitcast<f64>(((u64(_e449[1]) * 4294967296lu) + u64(_e449[0])));
                let _e457 = f64(0f);
                let _e460 = local_20.member_1[0u];
                let _e466 = local_20.member_2[0u];
                let _e472 = ((_e460[1] * _e466[2]) - (_e460[2] * _e466[1]));
                let _e475 = ((_e460[2] * _e466[0]) - (_e460[0] * _e466[2]));
                let _e478 = ((_e460[0] * _e466[1]) - (_e460[1] * _e466[0]));
                let _e481 = local_20.member_1[1u];
                let _e487 = local_20.member_2[1u];
                let _e493 = ((_e481[1] * _e487[2]) - (_e481[2] * _e487[1]));
                let _e496 = ((_e481[2] * _e487[0]) - (_e481[0] * _e487[2]));
                let _e499 = ((_e481[0] * _e487[1]) - (_e481[1] * _e487[0]));
                let _e502 = local_20.member_1[0u];
                let _e508 = local_20.member_2[1u];
                let _e523 = local_20.member_1[1u];
                let _e529 = local_20.member_2[0u];
                let _e542 = (((_e502[1] * _e508[2]) - (_e502[2] * _e508[1])) + ((_e523[1] * _e529[2]) - (_e523[2] * _e529[1])));
                let _e543 = (((_e502[2] * _e508[0]) - (_e502[0] * _e508[2])) + ((_e523[2] * _e529[0]) - (_e523[0] * _e529[2])));
                let _e544 = (((_e502[0] * _e508[1]) - (_e502[1] * _e508[0])) + ((_e523[0] * _e529[1]) - (_e523[1] * _e529[0])));
                let _e547 = local_20.member[0u];
                let _e555 = (((_e547[0] * _e472) + (_e547[1] * _e475)) + (_e547[2] * _e478));
                let _e558 = local_20.member[1u];
                let _e569 = local_20.member[0u];
                let _e578 = ((((_e558[0] * _e472) + (_e558[1] * _e475)) + (_e558[2] * _e478)) + (((_e569[0] * _e542) + (_e569[1] * _e543)) + (_e569[2] * _e544)));
                let _e581 = local_20.member[0u];
                let _e592 = local_20.member[1u];
                let _e601 = ((((_e581[0] * _e493) + (_e581[1] * _e496)) + (_e581[2] * _e499)) + (((_e592[0] * _e542) + (_e592[1] * _e543)) + (_e592[2] * _e544)));
                let _e604 = local_20.member[1u];
                let _e612 = (((_e604[0] * _e493) + (_e604[1] * _e496)) + (_e604[2] * _e499));
                let _e615 = local_20.member[0u];
                if (_e615[0] < 0.0lf) {
                    phi_1116_ = -(_e615[0]);
                } else {
                    phi_1116_ = _e615[0];
                }
                let _e622 = phi_1116_;
                if (_e615[1] < 0.0lf) {
                    phi_1123_ = -(_e615[1]);
                } else {
                    phi_1123_ = _e615[1];
                }
                let _e626 = phi_1123_;
                if (_e622 > _e626) {
                    phi_1128_ = _e622;
                } else {
                    phi_1128_ = _e626;
                }
                let _e629 = phi_1128_;
                if (_e615[2] < 0.0lf) {
                    phi_1135_ = -(_e615[2]);
                } else {
                    phi_1135_ = _e615[2];
                }
                let _e633 = phi_1135_;
                if (_e629 > _e633) {
                    phi_1140_ = _e629;
                } else {
                    phi_1140_ = _e633;
                }
                let _e636 = phi_1140_;
                let _e639 = local_20.member[1u];
                if (_e639[0] < 0.0lf) {
                    phi_1153_ = -(_e639[0]);
                } else {
                    phi_1153_ = _e639[0];
                }
                let _e646 = phi_1153_;
                if (_e639[1] < 0.0lf) {
                    phi_1160_ = -(_e639[1]);
                } else {
                    phi_1160_ = _e639[1];
                }
                let _e650 = phi_1160_;
                if (_e646 > _e650) {
                    phi_1165_ = _e646;
                } else {
                    phi_1165_ = _e650;
                }
                let _e653 = phi_1165_;
                if (_e639[2] < 0.0lf) {
                    phi_1172_ = -(_e639[2]);
                } else {
                    phi_1172_ = _e639[2];
                }
                let _e657 = phi_1172_;
                if (_e653 > _e657) {
                    phi_1177_ = _e653;
                } else {
                    phi_1177_ = _e657;
                }
                let _e660 = phi_1177_;
                if (_e636 > _e660) {
                    phi_1182_ = _e636;
                } else {
                    phi_1182_ = _e660;
                }
                let _e663 = phi_1182_;
                let _e665 = local_20.member_3;
                let _e666 = (_e663 + _e665);
                let _e669 = local_20.member_1[0u];
                if (_e669[0] < 0.0lf) {
                    phi_1199_ = -(_e669[0]);
                } else {
                    phi_1199_ = _e669[0];
                }
                let _e676 = phi_1199_;
                if (_e669[1] < 0.0lf) {
                    phi_1206_ = -(_e669[1]);
                } else {
                    phi_1206_ = _e669[1];
                }
                let _e680 = phi_1206_;
                if (_e676 > _e680) {
                    phi_1211_ = _e676;
                } else {
                    phi_1211_ = _e680;
                }
                let _e683 = phi_1211_;
                if (_e669[2] < 0.0lf) {
                    phi_1218_ = -(_e669[2]);
                } else {
                    phi_1218_ = _e669[2];
                }
                let _e687 = phi_1218_;
                if (_e683 > _e687) {
                    phi_1223_ = _e683;
                } else {
                    phi_1223_ = _e687;
                }
                let _e690 = phi_1223_;
                let _e693 = local_20.member_1[1u];
                if (_e693[0] < 0.0lf) {
                    phi_1237_ = -(_e693[0]);
                } else {
                    phi_1237_ = _e693[0];
                }
                let _e700 = phi_1237_;
                if (_e693[1] < 0.0lf) {
                    phi_1244_ = -(_e693[1]);
                } else {
                    phi_1244_ = _e693[1];
                }
                let _e704 = phi_1244_;
                if (_e700 > _e704) {
                    phi_1249_ = _e700;
                } else {
                    phi_1249_ = _e704;
                }
                let _e707 = phi_1249_;
                if (_e693[2] < 0.0lf) {
                    phi_1256_ = -(_e693[2]);
                } else {
                    phi_1256_ = _e693[2];
                }
                let _e711 = phi_1256_;
                if (_e707 > _e711) {
                    phi_1261_ = _e707;
                } else {
                    phi_1261_ = _e711;
                }
                let _e714 = phi_1261_;
                if (_e690 > _e714) {
                    phi_1266_ = _e690;
                } else {
                    phi_1266_ = _e714;
                }
                let _e717 = phi_1266_;
                let _e719 = local_20.member_3;
                let _e720 = (_e717 + _e719);
                let _e723 = local_20.member_2[0u];
                if (_e723[0] < 0.0lf) {
                    phi_1283_ = -(_e723[0]);
                } else {
                    phi_1283_ = _e723[0];
                }
                let _e730 = phi_1283_;
                if (_e723[1] < 0.0lf) {
                    phi_1290_ = -(_e723[1]);
                } else {
                    phi_1290_ = _e723[1];
                }
                let _e734 = phi_1290_;
                if (_e730 > _e734) {
                    phi_1295_ = _e730;
                } else {
                    phi_1295_ = _e734;
                }
                let _e737 = phi_1295_;
                if (_e723[2] < 0.0lf) {
                    phi_1302_ = -(_e723[2]);
                } else {
                    phi_1302_ = _e723[2];
                }
                let _e741 = phi_1302_;
                if (_e737 > _e741) {
                    phi_1307_ = _e737;
                } else {
                    phi_1307_ = _e741;
                }
                let _e744 = phi_1307_;
                let _e747 = local_20.member_2[1u];
                if (_e747[0] < 0.0lf) {
                    phi_1321_ = -(_e747[0]);
                } else {
                    phi_1321_ = _e747[0];
                }
                let _e754 = phi_1321_;
                if (_e747[1] < 0.0lf) {
                    phi_1328_ = -(_e747[1]);
                } else {
                    phi_1328_ = _e747[1];
                }
                let _e758 = phi_1328_;
                if (_e754 > _e758) {
                    phi_1333_ = _e754;
                } else {
                    phi_1333_ = _e758;
                }
                let _e761 = phi_1333_;
                if (_e747[2] < 0.0lf) {
                    phi_1340_ = -(_e747[2]);
                } else {
                    phi_1340_ = _e747[2];
                }
                let _e765 = phi_1340_;
                if (_e761 > _e765) {
                    phi_1345_ = _e761;
                } else {
                    phi_1345_ = _e765;
                }
                let _e768 = phi_1345_;
                if (_e744 > _e768) {
                    phi_1350_ = _e744;
                } else {
                    phi_1350_ = _e768;
                }
                let _e771 = phi_1350_;
                let _e773 = local_20.member_3;
                let _e774 = (_e771 + _e773);
                let _e775 = f64(1f);
                let _e776 = f64(8f);
                let _e778 = ((_e720 * _e776) * _e774);
                let _e786 = local_20.member_3;
                if (_e472 < 0.0lf) {
                    phi_1387_ = -(_e472);
                } else {
                    phi_1387_ = _e472;
                }
                let _e806 = phi_1387_;
                if (_e475 < 0.0lf) {
                    phi_1393_ = -(_e475);
                } else {
                    phi_1393_ = _e475;
                }
                let _e810 = phi_1393_;
                if (_e478 < 0.0lf) {
                    phi_1400_ = -(_e478);
                } else {
                    phi_1400_ = _e478;
                }
                let _e815 = phi_1400_;
                let _e816 = ((_e806 + _e810) + _e815);
                if (_e493 < 0.0lf) {
                    phi_1407_ = -(_e493);
                } else {
                    phi_1407_ = _e493;
                }
                let _e820 = phi_1407_;
                if (_e496 < 0.0lf) {
                    phi_1413_ = -(_e496);
                } else {
                    phi_1413_ = _e496;
                }
                let _e824 = phi_1413_;
                if (_e499 < 0.0lf) {
                    phi_1420_ = -(_e499);
                } else {
                    phi_1420_ = _e499;
                }
                let _e829 = phi_1420_;
                let _e830 = ((_e820 + _e824) + _e829);
                if (_e816 > _e830) {
                    phi_1426_ = _e816;
                } else {
                    phi_1426_ = _e830;
                }
                let _e833 = phi_1426_;
                if (_e542 < 0.0lf) {
                    phi_1432_ = -(_e542);
                } else {
                    phi_1432_ = _e542;
                }
                let _e837 = phi_1432_;
                if (_e543 < 0.0lf) {
                    phi_1438_ = -(_e543);
                } else {
                    phi_1438_ = _e543;
                }
                let _e841 = phi_1438_;
                if (_e544 < 0.0lf) {
                    phi_1445_ = -(_e544);
                } else {
                    phi_1445_ = _e544;
                }
                let _e846 = phi_1445_;
                let _e848 = (((_e837 + _e841) + _e846) * f64(0.5f));
                if (_e833 > _e848) {
                    phi_1452_ = _e833;
                } else {
                    phi_1452_ = _e848;
                }
                let _e851 = phi_1452_;
                let _e857 = local_20.member_3;
                let _e871 = (((((_e666 * _e776) * _e778) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e786 * f64(19f)) * ((_e666 * (_e720 + _e774)) + (_e720 * _e774)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e775 + _e666) * ((_e775 + _e720) * (_e775 + _e774)))));
                let _e872 = f64(3f);
                let _e873 = (_e555 * _e872);
                let _e874 = (_e612 * _e872);
                if (_e873 < _e874) {
                    phi_1480_ = _e873;
                } else {
                    phi_1480_ = _e874;
                }
                let _e877 = phi_1480_;
                if (_e578 < _e601) {
                    phi_1485_ = _e578;
                } else {
                    phi_1485_ = _e601;
                }
                let _e880 = phi_1485_;
                if (_e877 < _e880) {
                    phi_1490_ = _e877;
                } else {
                    phi_1490_ = _e880;
                }
                let _e883 = phi_1490_;
                if (_e873 > _e874) {
                    phi_1495_ = _e873;
                } else {
                    phi_1495_ = _e874;
                }
                let _e886 = phi_1495_;
                if (_e578 > _e601) {
                    phi_1500_ = _e578;
                } else {
                    phi_1500_ = _e601;
                }
                let _e889 = phi_1500_;
                if (_e886 > _e889) {
                    phi_1505_ = _e886;
                } else {
                    phi_1505_ = _e889;
                }
                let _e892 = phi_1505_;
                let _e898 = -(_e892);
                if (_e883 > _e898) {
                    phi_1516_ = _e883;
                } else {
                    phi_1516_ = _e898;
                }
                let _e901 = phi_1516_;
                if ((_e901 - (_e871 + ((_e456 * (((_e851 + (_e778 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e857 * f64(6f)) * (_e720 + _e774))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e775 + _e720) * (_e775 + _e774))))) * f64((3f * 1.0001f))))) > _e457) {
                    phi_7399_ = type_71(0u, type_71().member_1);
                } else {
                    if (_e456 > _e457) {
                        let _e3268 = f64(1f);
                        let _e3272 = local_20.member[0u];
                        let _e3278 = local_20.member_1[0u];
                        let _e3284 = local_20.member_2[0u];
                        let _e3288 = (_e3272[0] - _e3278[0]);
                        let _e3289 = (_e3272[1] - _e3278[1]);
                        let _e3290 = (_e3272[2] - _e3278[2]);
                        local_12 = array<array<f64, 3>, 4>(_e3272, array<f64, 3>(_e3288, _e3289, _e3290), array<f64, 3>((_e3272[0] - _e3284[0]), (_e3272[1] - _e3284[1]), (_e3272[2] - _e3284[2])), array<f64, 3>((_e3288 - _e3284[0]), (_e3289 - _e3284[1]), (_e3290 - _e3284[2])));
                        let _e3303 = local_20.member[1u];
                        let _e3309 = local_20.member_1[1u];
                        let _e3315 = local_20.member_2[1u];
                        let _e3319 = (_e3303[0] - _e3309[0]);
                        let _e3320 = (_e3303[1] - _e3309[1]);
                        let _e3321 = (_e3303[2] - _e3309[2]);
                        local_13 = array<array<f64, 3>, 4>(_e3303, array<f64, 3>(_e3319, _e3320, _e3321), array<f64, 3>((_e3303[0] - _e3315[0]), (_e3303[1] - _e3315[1]), (_e3303[2] - _e3315[2])), array<f64, 3>((_e3319 - _e3315[0]), (_e3320 - _e3315[1]), (_e3321 - _e3315[2])));
                        let _e3334 = local_20.member[0u];
                        if (_e3334[0] < 0.0lf) {
                            phi_1719_ = -(_e3334[0]);
                        } else {
                            phi_1719_ = _e3334[0];
                        }
                        let _e3341 = phi_1719_;
                        if (_e3334[1] < 0.0lf) {
                            phi_1726_ = -(_e3334[1]);
                        } else {
                            phi_1726_ = _e3334[1];
                        }
                        let _e3345 = phi_1726_;
                        if (_e3341 > _e3345) {
                            phi_1731_ = _e3341;
                        } else {
                            phi_1731_ = _e3345;
                        }
                        let _e3348 = phi_1731_;
                        if (_e3334[2] < 0.0lf) {
                            phi_1738_ = -(_e3334[2]);
                        } else {
                            phi_1738_ = _e3334[2];
                        }
                        let _e3352 = phi_1738_;
                        if (_e3348 > _e3352) {
                            phi_1743_ = _e3348;
                        } else {
                            phi_1743_ = _e3352;
                        }
                        let _e3355 = phi_1743_;
                        let _e3358 = local_20.member[1u];
                        if (_e3358[0] < 0.0lf) {
                            phi_1756_ = -(_e3358[0]);
                        } else {
                            phi_1756_ = _e3358[0];
                        }
                        let _e3365 = phi_1756_;
                        if (_e3358[1] < 0.0lf) {
                            phi_1763_ = -(_e3358[1]);
                        } else {
                            phi_1763_ = _e3358[1];
                        }
                        let _e3369 = phi_1763_;
                        if (_e3365 > _e3369) {
                            phi_1768_ = _e3365;
                        } else {
                            phi_1768_ = _e3369;
                        }
                        let _e3372 = phi_1768_;
                        if (_e3358[2] < 0.0lf) {
                            phi_1775_ = -(_e3358[2]);
                        } else {
                            phi_1775_ = _e3358[2];
                        }
                        let _e3376 = phi_1775_;
                        if (_e3372 > _e3376) {
                            phi_1780_ = _e3372;
                        } else {
                            phi_1780_ = _e3376;
                        }
                        let _e3379 = phi_1780_;
                        if (_e3355 > _e3379) {
                            phi_1785_ = _e3355;
                        } else {
                            phi_1785_ = _e3379;
                        }
                        let _e3382 = phi_1785_;
                        let _e3384 = local_20.member_3;
                        let _e3388 = local_20.member_1[0u];
                        if (_e3388[0] < 0.0lf) {
                            phi_1802_ = -(_e3388[0]);
                        } else {
                            phi_1802_ = _e3388[0];
                        }
                        let _e3395 = phi_1802_;
                        if (_e3388[1] < 0.0lf) {
                            phi_1809_ = -(_e3388[1]);
                        } else {
                            phi_1809_ = _e3388[1];
                        }
                        let _e3399 = phi_1809_;
                        if (_e3395 > _e3399) {
                            phi_1814_ = _e3395;
                        } else {
                            phi_1814_ = _e3399;
                        }
                        let _e3402 = phi_1814_;
                        if (_e3388[2] < 0.0lf) {
                            phi_1821_ = -(_e3388[2]);
                        } else {
                            phi_1821_ = _e3388[2];
                        }
                        let _e3406 = phi_1821_;
                        if (_e3402 > _e3406) {
                            phi_1826_ = _e3402;
                        } else {
                            phi_1826_ = _e3406;
                        }
                        let _e3409 = phi_1826_;
                        let _e3412 = local_20.member_1[1u];
                        if (_e3412[0] < 0.0lf) {
                            phi_1840_ = -(_e3412[0]);
                        } else {
                            phi_1840_ = _e3412[0];
                        }
                        let _e3419 = phi_1840_;
                        if (_e3412[1] < 0.0lf) {
                            phi_1847_ = -(_e3412[1]);
                        } else {
                            phi_1847_ = _e3412[1];
                        }
                        let _e3423 = phi_1847_;
                        if (_e3419 > _e3423) {
                            phi_1852_ = _e3419;
                        } else {
                            phi_1852_ = _e3423;
                        }
                        let _e3426 = phi_1852_;
                        if (_e3412[2] < 0.0lf) {
                            phi_1859_ = -(_e3412[2]);
                        } else {
                            phi_1859_ = _e3412[2];
                        }
                        let _e3430 = phi_1859_;
                        if (_e3426 > _e3430) {
                            phi_1864_ = _e3426;
                        } else {
                            phi_1864_ = _e3430;
                        }
                        let _e3433 = phi_1864_;
                        if (_e3409 > _e3433) {
                            phi_1869_ = _e3409;
                        } else {
                            phi_1869_ = _e3433;
                        }
                        let _e3436 = phi_1869_;
                        let _e3438 = local_20.member_3;
                        let _e3442 = local_20.member_2[0u];
                        if (_e3442[0] < 0.0lf) {
                            phi_1886_ = -(_e3442[0]);
                        } else {
                            phi_1886_ = _e3442[0];
                        }
                        let _e3449 = phi_1886_;
                        if (_e3442[1] < 0.0lf) {
                            phi_1893_ = -(_e3442[1]);
                        } else {
                            phi_1893_ = _e3442[1];
                        }
                        let _e3453 = phi_1893_;
                        if (_e3449 > _e3453) {
                            phi_1898_ = _e3449;
                        } else {
                            phi_1898_ = _e3453;
                        }
                        let _e3456 = phi_1898_;
                        if (_e3442[2] < 0.0lf) {
                            phi_1905_ = -(_e3442[2]);
                        } else {
                            phi_1905_ = _e3442[2];
                        }
                        let _e3460 = phi_1905_;
                        if (_e3456 > _e3460) {
                            phi_1910_ = _e3456;
                        } else {
                            phi_1910_ = _e3460;
                        }
                        let _e3463 = phi_1910_;
                        let _e3466 = local_20.member_2[1u];
                        if (_e3466[0] < 0.0lf) {
                            phi_1924_ = -(_e3466[0]);
                        } else {
                            phi_1924_ = _e3466[0];
                        }
                        let _e3473 = phi_1924_;
                        if (_e3466[1] < 0.0lf) {
                            phi_1931_ = -(_e3466[1]);
                        } else {
                            phi_1931_ = _e3466[1];
                        }
                        let _e3477 = phi_1931_;
                        if (_e3473 > _e3477) {
                            phi_1936_ = _e3473;
                        } else {
                            phi_1936_ = _e3477;
                        }
                        let _e3480 = phi_1936_;
                        if (_e3466[2] < 0.0lf) {
                            phi_1943_ = -(_e3466[2]);
                        } else {
                            phi_1943_ = _e3466[2];
                        }
                        let _e3484 = phi_1943_;
                        if (_e3480 > _e3484) {
                            phi_1948_ = _e3480;
                        } else {
                            phi_1948_ = _e3484;
                        }
                        let _e3487 = phi_1948_;
                        if (_e3463 > _e3487) {
                            phi_1953_ = _e3463;
                        } else {
                            phi_1953_ = _e3487;
                        }
                        let _e3490 = phi_1953_;
                        let _e3492 = local_20.member_3;
                        let _e3500 = local_20.member_3;
                        phi_1973_ = type_28(0u, 48u);
                        phi_1976_ = f64(0f);
                        loop {
                            let _e3509 = phi_1973_;
                            let _e3511 = phi_1976_;
                            local_79 = _e3511;
                            local_44 = _e3511;
                            local_45 = _e3511;
                            local_46 = _e3511;
                            if (_e3509.member < _e3509.member_1) {
                                phi_1974_ = type_28((_e3509.member + 1u), _e3509.member_1);
                                phi_1999_ = type_28(1u, _e3509.member);
                            } else {
                                phi_1974_ = _e3509;
                                phi_1999_ = type_28(0u, type_28().member_1);
                            }
                            let _e3525 = phi_1974_;
                            let _e3527 = phi_1999_;
                            if (bitcast<i32>(_e3527.member) != 0i) {
                                let _e3533 = local_20.member[0u];
                                let _e3539 = local_20.member[1u];
                                let _e3549 = (_e3533[0] + ((_e3539[0] - _e3533[0]) * _e3511));
                                let _e3550 = (_e3533[1] + ((_e3539[1] - _e3533[1]) * _e3511));
                                let _e3551 = (_e3533[2] + ((_e3539[2] - _e3533[2]) * _e3511));
                                let _e3554 = local_20.member_1[0u];
                                let _e3560 = local_20.member_1[1u];
                                let _e3570 = (_e3554[0] + ((_e3560[0] - _e3554[0]) * _e3511));
                                let _e3571 = (_e3554[1] + ((_e3560[1] - _e3554[1]) * _e3511));
                                let _e3572 = (_e3554[2] + ((_e3560[2] - _e3554[2]) * _e3511));
                                let _e3575 = local_20.member_2[0u];
                                let _e3581 = local_20.member_2[1u];
                                let _e3591 = (_e3575[0] + ((_e3581[0] - _e3575[0]) * _e3511));
                                let _e3592 = (_e3575[1] + ((_e3581[1] - _e3575[1]) * _e3511));
                                let _e3593 = (_e3575[2] + ((_e3581[2] - _e3575[2]) * _e3511));
                                let _e3598 = (((_e3570 * _e3570) + (_e3571 * _e3571)) + (_e3572 * _e3572));
                                let _e3603 = (((_e3570 * _e3591) + (_e3571 * _e3592)) + (_e3572 * _e3593));
                                let _e3608 = (((_e3591 * _e3591) + (_e3592 * _e3592)) + (_e3593 * _e3593));
                                let _e3613 = (((_e3549 * _e3570) + (_e3550 * _e3571)) + (_e3551 * _e3572));
                                let _e3618 = (((_e3549 * _e3591) + (_e3550 * _e3592)) + (_e3551 * _e3593));
                                let _e3621 = ((_e3598 * _e3608) - (_e3603 * _e3603));
                                let _e3622 = f64(0f);
                                let _e3623 = f64(1f);
                                let _e3627 = (((_e3613 * _e3608) - (_e3618 * _e3603)) / _e3621);
                                let _e3631 = (((_e3618 * _e3598) - (_e3613 * _e3603)) / _e3621);
                                if (_e3627 >= _e3622) {
                                    if (_e3631 >= _e3622) {
                                        if (_e3627 <= _e3623) {
                                            phi_2155_ = (_e3631 <= _e3623);
                                            phi_2156_ = false;
                                        } else {
                                            phi_2155_ = bool();
                                            phi_2156_ = true;
                                        }
                                        let _e3637 = phi_2155_;
                                        let _e3639 = phi_2156_;
                                        phi_2157_ = _e3637;
                                        phi_2158_ = _e3639;
                                    } else {
                                        phi_2157_ = bool();
                                        phi_2158_ = true;
                                    }
                                    let _e3641 = phi_2157_;
                                    let _e3643 = phi_2158_;
                                    phi_2159_ = _e3641;
                                    phi_2160_ = _e3643;
                                } else {
                                    phi_2159_ = bool();
                                    phi_2160_ = true;
                                }
                                let _e3645 = phi_2159_;
                                let _e3647 = phi_2160_;
                                if _e3647 {
                                    let _e3648 = (_e3621 > _e3622);
                                    if _e3648 {
                                        phi_2190_ = false;
                                    } else {
                                        phi_2190_ = true;
                                    }
                                    let _e3650 = phi_2190_;
                                    phi_2191_ = false;
                                    phi_2192_ = _e3650;
                                    phi_2193_ = _e3648;
                                } else {
                                    phi_2191_ = true;
                                    phi_2192_ = false;
                                    phi_2193_ = false;
                                }
                                let _e3652 = phi_2191_;
                                let _e3654 = phi_2192_;
                                let _e3656 = phi_2193_;
                                if _e3652 {
                                    if (_e3621 > _e3622) {
                                        if _e3645 {
                                            phi_2217_ = array<f64, 3>((_e3549 - ((_e3570 * _e3627) + (_e3591 * _e3631))), (_e3550 - ((_e3571 * _e3627) + (_e3592 * _e3631))), (_e3551 - ((_e3572 * _e3627) + (_e3593 * _e3631))));
                                            phi_2218_ = false;
                                        } else {
                                            phi_2217_ = array<f64, 3>();
                                            phi_2218_ = true;
                                        }
                                        let _e3672 = phi_2217_;
                                        let _e3674 = phi_2218_;
                                        phi_2219_ = _e3672;
                                        phi_2220_ = false;
                                        phi_2221_ = _e3674;
                                    } else {
                                        phi_2219_ = array<f64, 3>();
                                        phi_2220_ = true;
                                        phi_2221_ = false;
                                    }
                                    let _e3676 = phi_2219_;
                                    let _e3678 = phi_2220_;
                                    let _e3680 = phi_2221_;
                                    phi_2222_ = _e3676;
                                    phi_2223_ = _e3678;
                                    phi_2224_ = _e3680;
                                } else {
                                    phi_2222_ = array<f64, 3>();
                                    phi_2223_ = _e3654;
                                    phi_2224_ = _e3656;
                                }
                                let _e3682 = phi_2222_;
                                let _e3684 = phi_2223_;
                                let _e3686 = phi_2224_;
                                if _e3684 {
                                    phi_2228_ = true;
                                } else {
                                    phi_2228_ = _e3686;
                                }
                                let _e3688 = phi_2228_;
                                if _e3688 {
                                    let _e3689 = (_e3549 - _e3570);
                                    let _e3690 = (_e3550 - _e3571);
                                    let _e3691 = (_e3551 - _e3572);
                                    let _e3702 = ((((_e3549 * _e3570) + (_e3550 * _e3571)) + (_e3551 * _e3572)) / (((_e3570 * _e3570) + (_e3571 * _e3571)) + (_e3572 * _e3572)));
                                    if (_e3702 > f64(0f)) {
                                        if (_e3702 < f64(1f)) {
                                            phi_2261_ = _e3702;
                                        } else {
                                            phi_2261_ = f64(1f);
                                        }
                                        let _e3710 = phi_2261_;
                                        phi_2263_ = _e3710;
                                    } else {
                                        phi_2263_ = f64(0f);
                                    }
                                    let _e3712 = phi_2263_;
                                    let _e3729 = ((((_e3549 * _e3591) + (_e3550 * _e3592)) + (_e3551 * _e3593)) / (((_e3591 * _e3591) + (_e3592 * _e3592)) + (_e3593 * _e3593)));
                                    if (_e3729 > f64(0f)) {
                                        if (_e3729 < f64(1f)) {
                                            phi_2293_ = _e3729;
                                        } else {
                                            phi_2293_ = f64(1f);
                                        }
                                        let _e3737 = phi_2293_;
                                        phi_2295_ = _e3737;
                                    } else {
                                        phi_2295_ = f64(0f);
                                    }
                                    let _e3739 = phi_2295_;
                                    let _e3756 = ((((_e3689 * _e3591) + (_e3690 * _e3592)) + (_e3691 * _e3593)) / (((_e3591 * _e3591) + (_e3592 * _e3592)) + (_e3593 * _e3593)));
                                    if (_e3756 > f64(0f)) {
                                        if (_e3756 < f64(1f)) {
                                            phi_2325_ = _e3756;
                                        } else {
                                            phi_2325_ = f64(1f);
                                        }
                                        let _e3764 = phi_2325_;
                                        phi_2327_ = _e3764;
                                    } else {
                                        phi_2327_ = f64(0f);
                                    }
                                    let _e3766 = phi_2327_;
                                    let _e3773 = (_e3549 - _e3591);
                                    let _e3774 = (_e3550 - _e3592);
                                    let _e3775 = (_e3551 - _e3593);
                                    let _e3786 = ((((_e3773 * _e3570) + (_e3774 * _e3571)) + (_e3775 * _e3572)) / (((_e3570 * _e3570) + (_e3571 * _e3571)) + (_e3572 * _e3572)));
                                    if (_e3786 > f64(0f)) {
                                        if (_e3786 < f64(1f)) {
                                            phi_2360_ = _e3786;
                                        } else {
                                            phi_2360_ = f64(1f);
                                        }
                                        let _e3794 = phi_2360_;
                                        phi_2362_ = _e3794;
                                    } else {
                                        phi_2362_ = f64(0f);
                                    }
                                    let _e3796 = phi_2362_;
                                    local_11[0u] = array<f64, 3>((_e3549 - (_e3570 * _e3712)), (_e3550 - (_e3571 * _e3712)), (_e3551 - (_e3572 * _e3712)));
                                    local_11[1u] = array<f64, 3>((_e3549 - (_e3591 * _e3739)), (_e3550 - (_e3592 * _e3739)), (_e3551 - (_e3593 * _e3739)));
                                    local_11[2u] = array<f64, 3>((_e3689 - (_e3591 * _e3766)), (_e3690 - (_e3592 * _e3766)), (_e3691 - (_e3593 * _e3766)));
                                    local_11[3u] = array<f64, 3>((_e3773 - (_e3570 * _e3796)), (_e3774 - (_e3571 * _e3796)), (_e3775 - (_e3572 * _e3796)));
                                    let _e3812 = local_11[0u];
                                    phi_2517_ = type_28(1u, 4u);
                                    phi_2520_ = array<f64, 3>(_e3812[0], _e3812[1], _e3812[2]);
                                    loop {
                                        let _e3818 = phi_2517_;
                                        let _e3820 = phi_2520_;
                                        local_69 = _e3820;
                                        if (_e3818.member < _e3818.member_1) {
                                            phi_2518_ = type_28((_e3818.member + 1u), _e3818.member_1);
                                            phi_2543_ = type_28(1u, _e3818.member);
                                        } else {
                                            phi_2518_ = _e3818;
                                            phi_2543_ = type_28(0u, type_28().member_1);
                                        }
                                        let _e3834 = phi_2518_;
                                        let _e3836 = phi_2543_;
                                        let _e3840 = (bitcast<i32>(_e3836.member) != 0i);
                                        if _e3840 {
                                            if (_e3836.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3843 = local_11[_e3836.member_1];
                                            if (_e3836.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3849 = local_11[_e3836.member_1];
                                            if ((((_e3843[0] * _e3849[0]) + (_e3843[1] * _e3849[1])) + (_e3843[2] * _e3849[2])) < (((_e3820[0] * _e3820[0]) + (_e3820[1] * _e3820[1])) + (_e3820[2] * _e3820[2]))) {
                                                if (_e3836.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3872 = local_11[_e3836.member_1];
                                                phi_2610_ = array<f64, 3>(_e3872[0], _e3872[1], _e3872[2]);
                                            } else {
                                                phi_2610_ = _e3820;
                                            }
                                            let _e3878 = phi_2610_;
                                            phi_2521_ = _e3878;
                                        } else {
                                            phi_2521_ = array<f64, 3>();
                                        }
                                        let _e3880 = phi_2521_;
                                        continue;
                                        continuing {
                                            phi_2517_ = _e3834;
                                            phi_2520_ = _e3880;
                                            break if !(_e3840);
                                        }
                                    }
                                    let _e5630 = local_69;
                                    phi_2611_ = _e5630;
                                } else {
                                    phi_2611_ = _e3682;
                                }
                                let _e3883 = phi_2611_;
                                if (_e3883[0] < 0.0lf) {
                                    phi_2618_ = -(_e3883[0]);
                                } else {
                                    phi_2618_ = _e3883[0];
                                }
                                let _e3888 = phi_2618_;
                                if (_e3883[1] < 0.0lf) {
                                    phi_2625_ = -(_e3883[1]);
                                } else {
                                    phi_2625_ = _e3883[1];
                                }
                                let _e3893 = phi_2625_;
                                if (_e3883[2] < 0.0lf) {
                                    phi_2633_ = -(_e3883[2]);
                                } else {
                                    phi_2633_ = _e3883[2];
                                }
                                let _e3899 = phi_2633_;
                                let _e3900 = ((_e3888 + _e3893) + _e3899);
                                if (_e3900 > f64(0f)) {
                                    if ((bitcast<u64>(_e3900) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e3906 = (f64(1f) / _e3900);
                                        let _e3908 = (_e3883[0] * _e3906);
                                        let _e3910 = (_e3883[1] * _e3906);
                                        let _e3912 = (_e3883[2] * _e3906);
                                        let _e3917 = (((_e3908 * _e3908) + (_e3910 * _e3910)) + (_e3912 * _e3912));
                                        if (_e3917 <= 2.2250738585072014e-308lf) {
                                            if (_e3917 > 0.0lf) {
                                                phi_2671_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2671_ = 0.0lf;
                                            }
                                            let _e3975 = phi_2671_;
                                            phi_2735_ = _e3975;
                                        } else {
                                            phi_2678_ = type_26(0i, 5i);
                                            phi_2681_ = bitcast<f64>(((bitcast<u64>(_e3917) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e3924 = phi_2678_;
                                                let _e3926 = phi_2681_;
                                                local_38 = _e3926;
                                                if (_e3924.member < _e3924.member_1) {
                                                    let _e3934 = (_e3924.member + 1i);
                                                    if ((false == (_e3934 > _e3924.member)) != false) {
                                                        phi_2702_ = true;
                                                    } else {
                                                        phi_2702_ = false;
                                                    }
                                                    let _e3939 = phi_2702_;
                                                    if _e3939 {
                                                        phi_2708_ = type_27(0u, type_27().member_1);
                                                    } else {
                                                        phi_2708_ = type_27(1u, _e3934);
                                                    }
                                                    let _e3945 = phi_2708_;
                                                    if (bitcast<i32>(_e3945.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2679_ = type_26(_e3945.member_1, _e3924.member_1);
                                                    phi_2722_ = type_27(1u, _e3924.member);
                                                } else {
                                                    phi_2679_ = _e3924;
                                                    phi_2722_ = type_27(0u, type_27().member_1);
                                                }
                                                let _e3955 = phi_2679_;
                                                let _e3957 = phi_2722_;
                                                let _e3960 = (bitcast<i32>(_e3957.member) != 0i);
                                                if _e3960 {
                                                    phi_2682_ = (0.5lf * (_e3926 + (_e3917 / _e3926)));
                                                } else {
                                                    phi_2682_ = f64();
                                                }
                                                let _e3965 = phi_2682_;
                                                continue;
                                                continuing {
                                                    phi_2678_ = _e3955;
                                                    phi_2681_ = _e3965;
                                                    break if !(_e3960);
                                                }
                                            }
                                            let _e3970 = local_38;
                                            phi_2735_ = (_e3970 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e3977 = phi_2735_;
                                        phi_2748_ = type_28(0u, 4u);
                                        phi_2751_ = f64(2f);
                                        loop {
                                            let _e3989 = phi_2748_;
                                            let _e3991 = phi_2751_;
                                            local_40 = _e3991;
                                            local_41 = _e3991;
                                            local_42 = _e3991;
                                            local_70 = _e3991;
                                            local_71 = _e3991;
                                            if (_e3989.member < _e3989.member_1) {
                                                phi_2749_ = type_28((_e3989.member + 1u), _e3989.member_1);
                                                phi_2774_ = type_28(1u, _e3989.member);
                                            } else {
                                                phi_2749_ = _e3989;
                                                phi_2774_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4005 = phi_2749_;
                                            let _e4007 = phi_2774_;
                                            if (bitcast<i32>(_e4007.member) != 0i) {
                                                if (_e4007.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4014 = local_12[_e4007.member_1];
                                                let _e4022 = (((_e3908 * _e4014[0]) + (_e3910 * _e4014[1])) + (_e3912 * _e4014[2]));
                                                if (_e4007.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4025 = local_13[_e4007.member_1];
                                                let _e4033 = (((_e3908 * _e4025[0]) + (_e3910 * _e4025[1])) + (_e3912 * _e4025[2]));
                                                if (_e4022 < 0.0lf) {
                                                    phi_2825_ = -(_e4022);
                                                } else {
                                                    phi_2825_ = _e4022;
                                                }
                                                let _e4037 = phi_2825_;
                                                if (_e4033 < 0.0lf) {
                                                    phi_2831_ = -(_e4033);
                                                } else {
                                                    phi_2831_ = _e4033;
                                                }
                                                let _e4041 = phi_2831_;
                                                let _e4046 = (((((((((_e3382 + _e3384) + (_e3436 + _e3438)) + (_e3490 + _e3492)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3500 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e456 * _e3977) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e4037 + _e4041) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e4022 > _e4046) {
                                                    if (_e4033 > _e4046) {
                                                        phi_2845_ = false;
                                                    } else {
                                                        phi_2845_ = true;
                                                    }
                                                    let _e4050 = phi_2845_;
                                                    phi_2846_ = _e4050;
                                                } else {
                                                    phi_2846_ = true;
                                                }
                                                let _e4052 = phi_2846_;
                                                if _e4052 {
                                                    let _e4056 = ((_e4022 + ((_e4033 - _e4022) * _e3511)) > _e4046);
                                                    if _e4056 {
                                                        if (_e4033 < _e4022) {
                                                            let _e4065 = (((_e4022 - _e4046) / (_e4022 - _e4033)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                            if (_e3991 < _e4065) {
                                                                phi_2873_ = _e3991;
                                                            } else {
                                                                phi_2873_ = _e4065;
                                                            }
                                                            let _e4068 = phi_2873_;
                                                            phi_2874_ = _e4068;
                                                        } else {
                                                            phi_2874_ = _e3991;
                                                        }
                                                        let _e4070 = phi_2874_;
                                                        phi_2875_ = _e4070;
                                                    } else {
                                                        phi_2875_ = f64();
                                                    }
                                                    let _e4072 = phi_2875_;
                                                    phi_2876_ = _e4072;
                                                    phi_2877_ = _e4056;
                                                } else {
                                                    phi_2876_ = _e3991;
                                                    phi_2877_ = true;
                                                }
                                                let _e4074 = phi_2876_;
                                                let _e4076 = phi_2877_;
                                                phi_2752_ = _e4074;
                                                phi_2878_ = _e4076;
                                                phi_2879_ = false;
                                            } else {
                                                phi_2752_ = f64();
                                                phi_2878_ = false;
                                                phi_2879_ = true;
                                            }
                                            let _e4078 = phi_2752_;
                                            let _e4080 = phi_2878_;
                                            let _e4082 = phi_2879_;
                                            local_39 = _e4082;
                                            continue;
                                            continuing {
                                                phi_2748_ = _e4005;
                                                phi_2751_ = _e4078;
                                                break if !(_e4080);
                                            }
                                        }
                                        let _e4085 = local_39;
                                        if _e4085 {
                                            let _e4087 = local_40;
                                            let _e4088 = (_e4087 > _e3268);
                                            if _e4088 {
                                                phi_2901_ = false;
                                                phi_2902_ = false;
                                                phi_2903_ = false;
                                            } else {
                                                let _e4090 = local_41;
                                                if (_e4090 > _e3511) {
                                                    let _e4093 = local_42;
                                                    let _e4096 = ((_e4093 - _e3511) < f64(0.00000000023283064f));
                                                    if _e4096 {
                                                        phi_2897_ = false;
                                                    } else {
                                                        phi_2897_ = true;
                                                    }
                                                    let _e4098 = phi_2897_;
                                                    phi_2898_ = _e4098;
                                                    phi_2899_ = _e4096;
                                                    phi_2900_ = false;
                                                } else {
                                                    phi_2898_ = false;
                                                    phi_2899_ = false;
                                                    phi_2900_ = true;
                                                }
                                                let _e4100 = phi_2898_;
                                                let _e4102 = phi_2899_;
                                                let _e4104 = phi_2900_;
                                                phi_2901_ = _e4100;
                                                phi_2902_ = _e4102;
                                                phi_2903_ = _e4104;
                                            }
                                            let _e4106 = phi_2901_;
                                            let _e4108 = phi_2902_;
                                            let _e4110 = phi_2903_;
                                            phi_2904_ = _e4106;
                                            phi_2905_ = _e4088;
                                            phi_2906_ = _e4108;
                                            phi_2907_ = _e4110;
                                            phi_2908_ = false;
                                        } else {
                                            phi_2904_ = false;
                                            phi_2905_ = false;
                                            phi_2906_ = false;
                                            phi_2907_ = false;
                                            phi_2908_ = true;
                                        }
                                        let _e4112 = phi_2904_;
                                        let _e4114 = phi_2905_;
                                        let _e4116 = phi_2906_;
                                        let _e4118 = phi_2907_;
                                        let _e4120 = phi_2908_;
                                        let _e5678 = local_70;
                                        phi_2909_ = _e5678;
                                        let _e5681 = local_71;
                                        phi_2910_ = _e5681;
                                        phi_2911_ = _e4112;
                                        phi_2912_ = _e4114;
                                        phi_2913_ = _e4116;
                                        phi_2914_ = _e4118;
                                        phi_2915_ = _e4120;
                                        phi_2916_ = false;
                                    } else {
                                        phi_2909_ = f64();
                                        phi_2910_ = f64();
                                        phi_2911_ = false;
                                        phi_2912_ = false;
                                        phi_2913_ = false;
                                        phi_2914_ = false;
                                        phi_2915_ = false;
                                        phi_2916_ = true;
                                    }
                                    let _e4122 = phi_2909_;
                                    let _e4124 = phi_2910_;
                                    let _e4126 = phi_2911_;
                                    let _e4128 = phi_2912_;
                                    let _e4130 = phi_2913_;
                                    let _e4132 = phi_2914_;
                                    let _e4134 = phi_2915_;
                                    let _e4136 = phi_2916_;
                                    phi_2917_ = _e4122;
                                    phi_2918_ = _e4124;
                                    phi_2919_ = _e4126;
                                    phi_2920_ = _e4128;
                                    phi_2921_ = _e4130;
                                    phi_2922_ = _e4132;
                                    phi_2923_ = _e4134;
                                    phi_2924_ = _e4136;
                                    phi_2925_ = false;
                                } else {
                                    phi_2917_ = f64();
                                    phi_2918_ = f64();
                                    phi_2919_ = false;
                                    phi_2920_ = false;
                                    phi_2921_ = false;
                                    phi_2922_ = false;
                                    phi_2923_ = false;
                                    phi_2924_ = false;
                                    phi_2925_ = true;
                                }
                                let _e4138 = phi_2917_;
                                let _e4140 = phi_2918_;
                                let _e4142 = phi_2919_;
                                let _e4144 = phi_2920_;
                                let _e4146 = phi_2921_;
                                let _e4148 = phi_2922_;
                                let _e4150 = phi_2923_;
                                let _e4152 = phi_2924_;
                                let _e4154 = phi_2925_;
                                phi_2926_ = _e4138;
                                phi_1977_ = _e4140;
                                phi_2927_ = _e4142;
                                phi_2928_ = _e4144;
                                phi_2929_ = _e4146;
                                phi_2930_ = false;
                                phi_2931_ = _e4148;
                                phi_2932_ = _e4150;
                                phi_2933_ = _e4152;
                                phi_2934_ = _e4154;
                            } else {
                                phi_2926_ = f64();
                                phi_1977_ = f64();
                                phi_2927_ = false;
                                phi_2928_ = false;
                                phi_2929_ = false;
                                phi_2930_ = true;
                                phi_2931_ = false;
                                phi_2932_ = false;
                                phi_2933_ = false;
                                phi_2934_ = false;
                            }
                            let _e4156 = phi_2926_;
                            let _e4158 = phi_1977_;
                            let _e4160 = phi_2927_;
                            let _e4162 = phi_2928_;
                            let _e4164 = phi_2929_;
                            let _e4166 = phi_2930_;
                            let _e4168 = phi_2931_;
                            let _e4170 = phi_2932_;
                            let _e4172 = phi_2933_;
                            let _e4174 = phi_2934_;
                            local_43 = _e4162;
                            local_72 = _e4164;
                            local_73 = _e4166;
                            local_74 = _e4168;
                            local_75 = _e4170;
                            local_76 = _e4172;
                            local_77 = _e4174;
                            local_78 = _e4156;
                            local_80 = _e4162;
                            continue;
                            continuing {
                                phi_1973_ = _e3525;
                                phi_1976_ = _e4158;
                                break if !(_e4160);
                            }
                        }
                        let _e4177 = local_43;
                        if _e4177 {
                            phi_2939_ = type_71(0u, type_71().member_1);
                            phi_2940_ = false;
                            phi_2941_ = false;
                            phi_2942_ = false;
                            phi_2943_ = false;
                            phi_2944_ = false;
                            phi_2945_ = false;
                        } else {
                            phi_2939_ = type_71();
                            let _e5711 = local_72;
                            phi_2940_ = _e5711;
                            let _e5714 = local_73;
                            phi_2941_ = _e5714;
                            let _e5717 = local_74;
                            phi_2942_ = _e5717;
                            let _e5720 = local_75;
                            phi_2943_ = _e5720;
                            let _e5723 = local_76;
                            phi_2944_ = _e5723;
                            let _e5726 = local_77;
                            phi_2945_ = _e5726;
                        }
                        let _e4182 = phi_2939_;
                        let _e4184 = phi_2940_;
                        let _e4186 = phi_2941_;
                        let _e4188 = phi_2942_;
                        let _e4190 = phi_2943_;
                        let _e4192 = phi_2944_;
                        let _e4194 = phi_2945_;
                        if _e4184 {
                            let _e5729 = local_78;
                            phi_2949_ = _e5729;
                            phi_2950_ = true;
                            phi_2951_ = false;
                            phi_2952_ = false;
                            phi_2953_ = false;
                            phi_2954_ = false;
                            phi_2955_ = false;
                        } else {
                            let _e5731 = local_79;
                            phi_2949_ = _e5731;
                            phi_2950_ = _e4186;
                            phi_2951_ = _e4188;
                            phi_2952_ = _e4190;
                            let _e5737 = local_80;
                            phi_2953_ = _e5737;
                            phi_2954_ = _e4192;
                            phi_2955_ = _e4194;
                        }
                        let _e4196 = phi_2949_;
                        let _e4198 = phi_2950_;
                        let _e4200 = phi_2951_;
                        let _e4202 = phi_2952_;
                        let _e4204 = phi_2953_;
                        let _e4206 = phi_2954_;
                        let _e4208 = phi_2955_;
                        if _e4198 {
                            phi_2960_ = type_71(1u, _e4196);
                            phi_2961_ = false;
                            phi_2962_ = false;
                            phi_2963_ = false;
                            phi_2964_ = false;
                            phi_2965_ = false;
                        } else {
                            phi_2960_ = type_71();
                            phi_2961_ = _e4200;
                            phi_2962_ = _e4202;
                            phi_2963_ = _e4204;
                            phi_2964_ = _e4206;
                            phi_2965_ = _e4208;
                        }
                        let _e4211 = phi_2960_;
                        let _e4213 = phi_2961_;
                        let _e4215 = phi_2962_;
                        let _e4217 = phi_2963_;
                        let _e4219 = phi_2964_;
                        let _e4221 = phi_2965_;
                        if _e4213 {
                            let _e4223 = local_44;
                            phi_2970_ = type_71(1u, _e4223);
                            phi_2971_ = false;
                            phi_2972_ = true;
                            phi_2973_ = false;
                            phi_2974_ = false;
                        } else {
                            phi_2970_ = _e4182;
                            phi_2971_ = _e4215;
                            phi_2972_ = _e4217;
                            phi_2973_ = _e4219;
                            phi_2974_ = _e4221;
                        }
                        let _e4226 = phi_2970_;
                        let _e4228 = phi_2971_;
                        let _e4230 = phi_2972_;
                        let _e4232 = phi_2973_;
                        let _e4234 = phi_2974_;
                        if _e4228 {
                            let _e4236 = local_45;
                            phi_2979_ = type_71(1u, _e4236);
                            phi_2980_ = true;
                            phi_2981_ = false;
                            phi_2982_ = false;
                        } else {
                            phi_2979_ = _e4226;
                            phi_2980_ = _e4230;
                            phi_2981_ = _e4232;
                            phi_2982_ = _e4234;
                        }
                        let _e4239 = phi_2979_;
                        let _e4241 = phi_2980_;
                        let _e4243 = phi_2981_;
                        let _e4245 = phi_2982_;
                        if _e4241 {
                            phi_2986_ = false;
                            phi_2987_ = false;
                        } else {
                            phi_2986_ = _e4243;
                            phi_2987_ = _e4245;
                        }
                        let _e4247 = phi_2986_;
                        let _e4249 = phi_2987_;
                        if _e4247 {
                            phi_2991_ = false;
                            phi_2992_ = false;
                        } else {
                            phi_2991_ = _e4249;
                            phi_2992_ = _e4241;
                        }
                        let _e4251 = phi_2991_;
                        let _e4253 = phi_2992_;
                        if _e4251 {
                            phi_2996_ = true;
                            phi_2997_ = false;
                        } else {
                            phi_2996_ = _e4247;
                            phi_2997_ = _e4253;
                        }
                        let _e4255 = phi_2996_;
                        let _e4257 = phi_2997_;
                        if _e4255 {
                            let _e4259 = local_46;
                            phi_3002_ = type_71(1u, _e4259);
                            phi_3003_ = true;
                        } else {
                            phi_3002_ = _e4239;
                            phi_3003_ = _e4257;
                        }
                        let _e4262 = phi_3002_;
                        let _e4264 = phi_3003_;
                        if _e4264 {
                            phi_3007_ = _e4262;
                        } else {
                            phi_3007_ = _e4211;
                        }
                        let _e4266 = phi_3007_;
                        if (_e4266.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_3021_ = type_28(0u, 3u);
                            loop {
                                let _e4279 = phi_3021_;
                                if (_e4279.member < _e4279.member_1) {
                                    phi_3022_ = type_28((_e4279.member + 1u), _e4279.member_1);
                                    phi_3045_ = type_28(1u, _e4279.member);
                                } else {
                                    phi_3022_ = _e4279;
                                    phi_3045_ = type_28(0u, type_28().member_1);
                                }
                                let _e4293 = phi_3022_;
                                let _e4295 = phi_3045_;
                                if (bitcast<i32>(_e4295.member) != 0i) {
                                    if (_e4295.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4302 = local_14[_e4295.member_1];
                                    let _e4304 = (_e4266.member_1 + f64(_e4302));
                                    if (_e4304 < _e3268) {
                                        phi_3066_ = _e4304;
                                    } else {
                                        phi_3066_ = _e3268;
                                    }
                                    let _e4307 = phi_3066_;
                                    let _e4310 = local_20.member[0u];
                                    let _e4316 = local_20.member[1u];
                                    let _e4326 = (_e4310[0] + ((_e4316[0] - _e4310[0]) * _e4307));
                                    let _e4327 = (_e4310[1] + ((_e4316[1] - _e4310[1]) * _e4307));
                                    let _e4328 = (_e4310[2] + ((_e4316[2] - _e4310[2]) * _e4307));
                                    let _e4331 = local_20.member_1[0u];
                                    let _e4337 = local_20.member_1[1u];
                                    let _e4347 = (_e4331[0] + ((_e4337[0] - _e4331[0]) * _e4307));
                                    let _e4348 = (_e4331[1] + ((_e4337[1] - _e4331[1]) * _e4307));
                                    let _e4349 = (_e4331[2] + ((_e4337[2] - _e4331[2]) * _e4307));
                                    let _e4352 = local_20.member_2[0u];
                                    let _e4358 = local_20.member_2[1u];
                                    let _e4368 = (_e4352[0] + ((_e4358[0] - _e4352[0]) * _e4307));
                                    let _e4369 = (_e4352[1] + ((_e4358[1] - _e4352[1]) * _e4307));
                                    let _e4370 = (_e4352[2] + ((_e4358[2] - _e4352[2]) * _e4307));
                                    let _e4375 = (((_e4347 * _e4347) + (_e4348 * _e4348)) + (_e4349 * _e4349));
                                    let _e4380 = (((_e4347 * _e4368) + (_e4348 * _e4369)) + (_e4349 * _e4370));
                                    let _e4385 = (((_e4368 * _e4368) + (_e4369 * _e4369)) + (_e4370 * _e4370));
                                    let _e4390 = (((_e4326 * _e4347) + (_e4327 * _e4348)) + (_e4328 * _e4349));
                                    let _e4395 = (((_e4326 * _e4368) + (_e4327 * _e4369)) + (_e4328 * _e4370));
                                    let _e4398 = ((_e4375 * _e4385) - (_e4380 * _e4380));
                                    let _e4399 = f64(0f);
                                    let _e4400 = f64(1f);
                                    let _e4404 = (((_e4390 * _e4385) - (_e4395 * _e4380)) / _e4398);
                                    let _e4408 = (((_e4395 * _e4375) - (_e4390 * _e4380)) / _e4398);
                                    if (_e4404 >= _e4399) {
                                        if (_e4408 >= _e4399) {
                                            if (_e4404 <= _e4400) {
                                                phi_3216_ = (_e4408 <= _e4400);
                                                phi_3217_ = false;
                                            } else {
                                                phi_3216_ = bool();
                                                phi_3217_ = true;
                                            }
                                            let _e4414 = phi_3216_;
                                            let _e4416 = phi_3217_;
                                            phi_3218_ = _e4414;
                                            phi_3219_ = _e4416;
                                        } else {
                                            phi_3218_ = bool();
                                            phi_3219_ = true;
                                        }
                                        let _e4418 = phi_3218_;
                                        let _e4420 = phi_3219_;
                                        phi_3220_ = _e4418;
                                        phi_3221_ = _e4420;
                                    } else {
                                        phi_3220_ = bool();
                                        phi_3221_ = true;
                                    }
                                    let _e4422 = phi_3220_;
                                    let _e4424 = phi_3221_;
                                    if _e4424 {
                                        let _e4425 = (_e4398 > _e4399);
                                        if _e4425 {
                                            phi_3251_ = false;
                                        } else {
                                            phi_3251_ = true;
                                        }
                                        let _e4427 = phi_3251_;
                                        phi_3252_ = false;
                                        phi_3253_ = _e4427;
                                        phi_3254_ = _e4425;
                                    } else {
                                        phi_3252_ = true;
                                        phi_3253_ = false;
                                        phi_3254_ = false;
                                    }
                                    let _e4429 = phi_3252_;
                                    let _e4431 = phi_3253_;
                                    let _e4433 = phi_3254_;
                                    if _e4429 {
                                        if (_e4398 > _e4399) {
                                            if _e4422 {
                                                phi_3278_ = array<f64, 3>((_e4326 - ((_e4347 * _e4404) + (_e4368 * _e4408))), (_e4327 - ((_e4348 * _e4404) + (_e4369 * _e4408))), (_e4328 - ((_e4349 * _e4404) + (_e4370 * _e4408))));
                                                phi_3279_ = false;
                                            } else {
                                                phi_3278_ = array<f64, 3>();
                                                phi_3279_ = true;
                                            }
                                            let _e4449 = phi_3278_;
                                            let _e4451 = phi_3279_;
                                            phi_3280_ = _e4449;
                                            phi_3281_ = false;
                                            phi_3282_ = _e4451;
                                        } else {
                                            phi_3280_ = array<f64, 3>();
                                            phi_3281_ = true;
                                            phi_3282_ = false;
                                        }
                                        let _e4453 = phi_3280_;
                                        let _e4455 = phi_3281_;
                                        let _e4457 = phi_3282_;
                                        phi_3283_ = _e4453;
                                        phi_3284_ = _e4455;
                                        phi_3285_ = _e4457;
                                    } else {
                                        phi_3283_ = array<f64, 3>();
                                        phi_3284_ = _e4431;
                                        phi_3285_ = _e4433;
                                    }
                                    let _e4459 = phi_3283_;
                                    let _e4461 = phi_3284_;
                                    let _e4463 = phi_3285_;
                                    if _e4461 {
                                        phi_3289_ = true;
                                    } else {
                                        phi_3289_ = _e4463;
                                    }
                                    let _e4465 = phi_3289_;
                                    if _e4465 {
                                        let _e4466 = (_e4326 - _e4347);
                                        let _e4467 = (_e4327 - _e4348);
                                        let _e4468 = (_e4328 - _e4349);
                                        let _e4479 = ((((_e4326 * _e4347) + (_e4327 * _e4348)) + (_e4328 * _e4349)) / (((_e4347 * _e4347) + (_e4348 * _e4348)) + (_e4349 * _e4349)));
                                        if (_e4479 > f64(0f)) {
                                            if (_e4479 < f64(1f)) {
                                                phi_3322_ = _e4479;
                                            } else {
                                                phi_3322_ = f64(1f);
                                            }
                                            let _e4487 = phi_3322_;
                                            phi_3324_ = _e4487;
                                        } else {
                                            phi_3324_ = f64(0f);
                                        }
                                        let _e4489 = phi_3324_;
                                        let _e4506 = ((((_e4326 * _e4368) + (_e4327 * _e4369)) + (_e4328 * _e4370)) / (((_e4368 * _e4368) + (_e4369 * _e4369)) + (_e4370 * _e4370)));
                                        if (_e4506 > f64(0f)) {
                                            if (_e4506 < f64(1f)) {
                                                phi_3354_ = _e4506;
                                            } else {
                                                phi_3354_ = f64(1f);
                                            }
                                            let _e4514 = phi_3354_;
                                            phi_3356_ = _e4514;
                                        } else {
                                            phi_3356_ = f64(0f);
                                        }
                                        let _e4516 = phi_3356_;
                                        let _e4533 = ((((_e4466 * _e4368) + (_e4467 * _e4369)) + (_e4468 * _e4370)) / (((_e4368 * _e4368) + (_e4369 * _e4369)) + (_e4370 * _e4370)));
                                        if (_e4533 > f64(0f)) {
                                            if (_e4533 < f64(1f)) {
                                                phi_3386_ = _e4533;
                                            } else {
                                                phi_3386_ = f64(1f);
                                            }
                                            let _e4541 = phi_3386_;
                                            phi_3388_ = _e4541;
                                        } else {
                                            phi_3388_ = f64(0f);
                                        }
                                        let _e4543 = phi_3388_;
                                        let _e4550 = (_e4326 - _e4368);
                                        let _e4551 = (_e4327 - _e4369);
                                        let _e4552 = (_e4328 - _e4370);
                                        let _e4563 = ((((_e4550 * _e4347) + (_e4551 * _e4348)) + (_e4552 * _e4349)) / (((_e4347 * _e4347) + (_e4348 * _e4348)) + (_e4349 * _e4349)));
                                        if (_e4563 > f64(0f)) {
                                            if (_e4563 < f64(1f)) {
                                                phi_3421_ = _e4563;
                                            } else {
                                                phi_3421_ = f64(1f);
                                            }
                                            let _e4571 = phi_3421_;
                                            phi_3423_ = _e4571;
                                        } else {
                                            phi_3423_ = f64(0f);
                                        }
                                        let _e4573 = phi_3423_;
                                        local_10[0u] = array<f64, 3>((_e4326 - (_e4347 * _e4489)), (_e4327 - (_e4348 * _e4489)), (_e4328 - (_e4349 * _e4489)));
                                        local_10[1u] = array<f64, 3>((_e4326 - (_e4368 * _e4516)), (_e4327 - (_e4369 * _e4516)), (_e4328 - (_e4370 * _e4516)));
                                        local_10[2u] = array<f64, 3>((_e4466 - (_e4368 * _e4543)), (_e4467 - (_e4369 * _e4543)), (_e4468 - (_e4370 * _e4543)));
                                        local_10[3u] = array<f64, 3>((_e4550 - (_e4347 * _e4573)), (_e4551 - (_e4348 * _e4573)), (_e4552 - (_e4349 * _e4573)));
                                        let _e4589 = local_10[0u];
                                        phi_3578_ = type_28(1u, 4u);
                                        phi_3581_ = array<f64, 3>(_e4589[0], _e4589[1], _e4589[2]);
                                        loop {
                                            let _e4595 = phi_3578_;
                                            let _e4597 = phi_3581_;
                                            local_81 = _e4597;
                                            if (_e4595.member < _e4595.member_1) {
                                                phi_3579_ = type_28((_e4595.member + 1u), _e4595.member_1);
                                                phi_3604_ = type_28(1u, _e4595.member);
                                            } else {
                                                phi_3579_ = _e4595;
                                                phi_3604_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4611 = phi_3579_;
                                            let _e4613 = phi_3604_;
                                            let _e4617 = (bitcast<i32>(_e4613.member) != 0i);
                                            if _e4617 {
                                                if (_e4613.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4620 = local_10[_e4613.member_1];
                                                if (_e4613.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4626 = local_10[_e4613.member_1];
                                                if ((((_e4620[0] * _e4626[0]) + (_e4620[1] * _e4626[1])) + (_e4620[2] * _e4626[2])) < (((_e4597[0] * _e4597[0]) + (_e4597[1] * _e4597[1])) + (_e4597[2] * _e4597[2]))) {
                                                    if (_e4613.member_1 < 4u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e4649 = local_10[_e4613.member_1];
                                                    phi_3671_ = array<f64, 3>(_e4649[0], _e4649[1], _e4649[2]);
                                                } else {
                                                    phi_3671_ = _e4597;
                                                }
                                                let _e4655 = phi_3671_;
                                                phi_3582_ = _e4655;
                                            } else {
                                                phi_3582_ = array<f64, 3>();
                                            }
                                            let _e4657 = phi_3582_;
                                            continue;
                                            continuing {
                                                phi_3578_ = _e4611;
                                                phi_3581_ = _e4657;
                                                break if !(_e4617);
                                            }
                                        }
                                        let _e5806 = local_81;
                                        phi_3672_ = _e5806;
                                    } else {
                                        phi_3672_ = _e4459;
                                    }
                                    let _e4660 = phi_3672_;
                                    let _e4671 = (((_e4660[0] * _e4660[0]) + (_e4660[1] * _e4660[1])) + (_e4660[2] * _e4660[2]));
                                    if (_e4671 <= 2.2250738585072014e-308lf) {
                                        if (_e4671 > 0.0lf) {
                                            phi_3697_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3697_ = 0.0lf;
                                        }
                                        let _e4729 = phi_3697_;
                                        phi_3761_ = _e4729;
                                    } else {
                                        phi_3704_ = type_26(0i, 5i);
                                        phi_3707_ = bitcast<f64>(((bitcast<u64>(_e4671) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e4678 = phi_3704_;
                                            let _e4680 = phi_3707_;
                                            local_47 = _e4680;
                                            if (_e4678.member < _e4678.member_1) {
                                                let _e4688 = (_e4678.member + 1i);
                                                if ((false == (_e4688 > _e4678.member)) != false) {
                                                    phi_3728_ = true;
                                                } else {
                                                    phi_3728_ = false;
                                                }
                                                let _e4693 = phi_3728_;
                                                if _e4693 {
                                                    phi_3734_ = type_27(0u, type_27().member_1);
                                                } else {
                                                    phi_3734_ = type_27(1u, _e4688);
                                                }
                                                let _e4699 = phi_3734_;
                                                if (bitcast<i32>(_e4699.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3705_ = type_26(_e4699.member_1, _e4678.member_1);
                                                phi_3748_ = type_27(1u, _e4678.member);
                                            } else {
                                                phi_3705_ = _e4678;
                                                phi_3748_ = type_27(0u, type_27().member_1);
                                            }
                                            let _e4709 = phi_3705_;
                                            let _e4711 = phi_3748_;
                                            let _e4714 = (bitcast<i32>(_e4711.member) != 0i);
                                            if _e4714 {
                                                phi_3708_ = (0.5lf * (_e4680 + (_e4671 / _e4680)));
                                            } else {
                                                phi_3708_ = f64();
                                            }
                                            let _e4719 = phi_3708_;
                                            continue;
                                            continuing {
                                                phi_3704_ = _e4709;
                                                phi_3707_ = _e4719;
                                                break if !(_e4714);
                                            }
                                        }
                                        let _e4724 = local_47;
                                        phi_3761_ = (_e4724 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e4731 = phi_3761_;
                                    let _e4739 = local_20.member[0u];
                                    if (_e4739[0] < 0.0lf) {
                                        phi_3779_ = -(_e4739[0]);
                                    } else {
                                        phi_3779_ = _e4739[0];
                                    }
                                    let _e4746 = phi_3779_;
                                    if (_e4739[1] < 0.0lf) {
                                        phi_3786_ = -(_e4739[1]);
                                    } else {
                                        phi_3786_ = _e4739[1];
                                    }
                                    let _e4750 = phi_3786_;
                                    if (_e4746 > _e4750) {
                                        phi_3791_ = _e4746;
                                    } else {
                                        phi_3791_ = _e4750;
                                    }
                                    let _e4753 = phi_3791_;
                                    if (_e4739[2] < 0.0lf) {
                                        phi_3798_ = -(_e4739[2]);
                                    } else {
                                        phi_3798_ = _e4739[2];
                                    }
                                    let _e4757 = phi_3798_;
                                    if (_e4753 > _e4757) {
                                        phi_3803_ = _e4753;
                                    } else {
                                        phi_3803_ = _e4757;
                                    }
                                    let _e4760 = phi_3803_;
                                    let _e4763 = local_20.member[1u];
                                    if (_e4763[0] < 0.0lf) {
                                        phi_3816_ = -(_e4763[0]);
                                    } else {
                                        phi_3816_ = _e4763[0];
                                    }
                                    let _e4770 = phi_3816_;
                                    if (_e4763[1] < 0.0lf) {
                                        phi_3823_ = -(_e4763[1]);
                                    } else {
                                        phi_3823_ = _e4763[1];
                                    }
                                    let _e4774 = phi_3823_;
                                    if (_e4770 > _e4774) {
                                        phi_3828_ = _e4770;
                                    } else {
                                        phi_3828_ = _e4774;
                                    }
                                    let _e4777 = phi_3828_;
                                    if (_e4763[2] < 0.0lf) {
                                        phi_3835_ = -(_e4763[2]);
                                    } else {
                                        phi_3835_ = _e4763[2];
                                    }
                                    let _e4781 = phi_3835_;
                                    if (_e4777 > _e4781) {
                                        phi_3840_ = _e4777;
                                    } else {
                                        phi_3840_ = _e4781;
                                    }
                                    let _e4784 = phi_3840_;
                                    if (_e4760 > _e4784) {
                                        phi_3845_ = _e4760;
                                    } else {
                                        phi_3845_ = _e4784;
                                    }
                                    let _e4787 = phi_3845_;
                                    let _e4789 = local_20.member_3;
                                    let _e4793 = local_20.member_1[0u];
                                    if (_e4793[0] < 0.0lf) {
                                        phi_3862_ = -(_e4793[0]);
                                    } else {
                                        phi_3862_ = _e4793[0];
                                    }
                                    let _e4800 = phi_3862_;
                                    if (_e4793[1] < 0.0lf) {
                                        phi_3869_ = -(_e4793[1]);
                                    } else {
                                        phi_3869_ = _e4793[1];
                                    }
                                    let _e4804 = phi_3869_;
                                    if (_e4800 > _e4804) {
                                        phi_3874_ = _e4800;
                                    } else {
                                        phi_3874_ = _e4804;
                                    }
                                    let _e4807 = phi_3874_;
                                    if (_e4793[2] < 0.0lf) {
                                        phi_3881_ = -(_e4793[2]);
                                    } else {
                                        phi_3881_ = _e4793[2];
                                    }
                                    let _e4811 = phi_3881_;
                                    if (_e4807 > _e4811) {
                                        phi_3886_ = _e4807;
                                    } else {
                                        phi_3886_ = _e4811;
                                    }
                                    let _e4814 = phi_3886_;
                                    let _e4817 = local_20.member_1[1u];
                                    if (_e4817[0] < 0.0lf) {
                                        phi_3900_ = -(_e4817[0]);
                                    } else {
                                        phi_3900_ = _e4817[0];
                                    }
                                    let _e4824 = phi_3900_;
                                    if (_e4817[1] < 0.0lf) {
                                        phi_3907_ = -(_e4817[1]);
                                    } else {
                                        phi_3907_ = _e4817[1];
                                    }
                                    let _e4828 = phi_3907_;
                                    if (_e4824 > _e4828) {
                                        phi_3912_ = _e4824;
                                    } else {
                                        phi_3912_ = _e4828;
                                    }
                                    let _e4831 = phi_3912_;
                                    if (_e4817[2] < 0.0lf) {
                                        phi_3919_ = -(_e4817[2]);
                                    } else {
                                        phi_3919_ = _e4817[2];
                                    }
                                    let _e4835 = phi_3919_;
                                    if (_e4831 > _e4835) {
                                        phi_3924_ = _e4831;
                                    } else {
                                        phi_3924_ = _e4835;
                                    }
                                    let _e4838 = phi_3924_;
                                    if (_e4814 > _e4838) {
                                        phi_3929_ = _e4814;
                                    } else {
                                        phi_3929_ = _e4838;
                                    }
                                    let _e4841 = phi_3929_;
                                    let _e4843 = local_20.member_3;
                                    let _e4847 = local_20.member_2[0u];
                                    if (_e4847[0] < 0.0lf) {
                                        phi_3946_ = -(_e4847[0]);
                                    } else {
                                        phi_3946_ = _e4847[0];
                                    }
                                    let _e4854 = phi_3946_;
                                    if (_e4847[1] < 0.0lf) {
                                        phi_3953_ = -(_e4847[1]);
                                    } else {
                                        phi_3953_ = _e4847[1];
                                    }
                                    let _e4858 = phi_3953_;
                                    if (_e4854 > _e4858) {
                                        phi_3958_ = _e4854;
                                    } else {
                                        phi_3958_ = _e4858;
                                    }
                                    let _e4861 = phi_3958_;
                                    if (_e4847[2] < 0.0lf) {
                                        phi_3965_ = -(_e4847[2]);
                                    } else {
                                        phi_3965_ = _e4847[2];
                                    }
                                    let _e4865 = phi_3965_;
                                    if (_e4861 > _e4865) {
                                        phi_3970_ = _e4861;
                                    } else {
                                        phi_3970_ = _e4865;
                                    }
                                    let _e4868 = phi_3970_;
                                    let _e4871 = local_20.member_2[1u];
                                    if (_e4871[0] < 0.0lf) {
                                        phi_3984_ = -(_e4871[0]);
                                    } else {
                                        phi_3984_ = _e4871[0];
                                    }
                                    let _e4878 = phi_3984_;
                                    if (_e4871[1] < 0.0lf) {
                                        phi_3991_ = -(_e4871[1]);
                                    } else {
                                        phi_3991_ = _e4871[1];
                                    }
                                    let _e4882 = phi_3991_;
                                    if (_e4878 > _e4882) {
                                        phi_3996_ = _e4878;
                                    } else {
                                        phi_3996_ = _e4882;
                                    }
                                    let _e4885 = phi_3996_;
                                    if (_e4871[2] < 0.0lf) {
                                        phi_4003_ = -(_e4871[2]);
                                    } else {
                                        phi_4003_ = _e4871[2];
                                    }
                                    let _e4889 = phi_4003_;
                                    if (_e4885 > _e4889) {
                                        phi_4008_ = _e4885;
                                    } else {
                                        phi_4008_ = _e4889;
                                    }
                                    let _e4892 = phi_4008_;
                                    if (_e4868 > _e4892) {
                                        phi_4013_ = _e4868;
                                    } else {
                                        phi_4013_ = _e4892;
                                    }
                                    let _e4895 = phi_4013_;
                                    let _e4897 = local_20.member_3;
                                    let _e4905 = local_20.member_3;
                                    let _e4915 = (((_e4731 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e4787 + _e4789) + (_e4841 + _e4843)) + (_e4895 + _e4897)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4905 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e456);
                                    if _e4915 {
                                        phi_4037_ = false;
                                    } else {
                                        phi_4037_ = true;
                                    }
                                    let _e4917 = phi_4037_;
                                    phi_4038_ = _e4917;
                                    phi_4039_ = _e4915;
                                } else {
                                    phi_4038_ = false;
                                    phi_4039_ = false;
                                }
                                let _e4919 = phi_4038_;
                                let _e4921 = phi_4039_;
                                local_48 = _e4921;
                                continue;
                                continuing {
                                    phi_3021_ = _e4293;
                                    break if !(_e4919);
                                }
                            }
                            let _e4924 = local_48;
                            if _e4924 {
                                phi_4044_ = type_71(1u, _e4266.member_1);
                                phi_4045_ = false;
                            } else {
                                phi_4044_ = type_71();
                                phi_4045_ = true;
                            }
                            let _e4927 = phi_4044_;
                            let _e4929 = phi_4045_;
                            if _e4929 {
                                phi_4050_ = type_71(2u, _e4266.member_1);
                                phi_4051_ = false;
                            } else {
                                phi_4050_ = type_71();
                                phi_4051_ = true;
                            }
                            let _e4932 = phi_4050_;
                            let _e4934 = phi_4051_;
                            phi_4053_ = _e4932;
                            phi_4054_ = _e4927;
                            phi_4055_ = _e4934;
                        } else {
                            phi_4053_ = type_71();
                            phi_4054_ = type_71(0u, type_71().member_1);
                            phi_4055_ = true;
                        }
                        let _e4936 = phi_4053_;
                        let _e4938 = phi_4054_;
                        let _e4940 = phi_4055_;
                        if _e4940 {
                            phi_4059_ = _e4938;
                        } else {
                            phi_4059_ = _e4936;
                        }
                        let _e4942 = phi_4059_;
                        phi_7398_ = _e4942;
                    } else {
                        if (_e555 < 0.0lf) {
                            phi_4070_ = -(_e555);
                        } else {
                            phi_4070_ = _e555;
                        }
                        let _e910 = phi_4070_;
                        if (_e578 < 0.0lf) {
                            phi_4076_ = -(_e578);
                        } else {
                            phi_4076_ = _e578;
                        }
                        let _e914 = phi_4076_;
                        if (_e910 > _e914) {
                            phi_4081_ = _e910;
                        } else {
                            phi_4081_ = _e914;
                        }
                        let _e917 = phi_4081_;
                        if (_e601 < 0.0lf) {
                            phi_4087_ = -(_e601);
                        } else {
                            phi_4087_ = _e601;
                        }
                        let _e921 = phi_4087_;
                        if (_e612 < 0.0lf) {
                            phi_4093_ = -(_e612);
                        } else {
                            phi_4093_ = _e612;
                        }
                        let _e925 = phi_4093_;
                        if (_e921 > _e925) {
                            phi_4098_ = _e921;
                        } else {
                            phi_4098_ = _e925;
                        }
                        let _e928 = phi_4098_;
                        if (_e917 > _e928) {
                            phi_4103_ = _e917;
                        } else {
                            phi_4103_ = _e928;
                        }
                        let _e931 = phi_4103_;
                        let _e935 = ((_e871 * f64(0.34f)) + (_e931 * (1.1102230246251565e-16lf * f64(256f))));
                        let _e936 = f64(0f);
                        let _e937 = f64(1f);
                        let _e938 = f64(3f);
                        let _e940 = (_e578 - (_e938 * _e555));
                        let _e941 = (_e601 - _e578);
                        let _e943 = ((_e938 * _e612) - _e601);
                        local_7[0u] = _e936;
                        local_7[1u] = _e937;
                        local_7[2u] = _e937;
                        local_7[3u] = _e937;
                        let _e950 = ((_e941 * _e941) - (_e940 * _e943));
                        if (_e950 > _e936) {
                            if (_e950 <= 2.2250738585072014e-308lf) {
                                if (_e950 > 0.0lf) {
                                    phi_4140_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4140_ = 0.0lf;
                                }
                                let _e1009 = phi_4140_;
                                phi_4204_ = _e1009;
                            } else {
                                phi_4147_ = type_26(0i, 5i);
                                phi_4150_ = bitcast<f64>(((bitcast<u64>(_e950) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e958 = phi_4147_;
                                    let _e960 = phi_4150_;
                                    local_21 = _e960;
                                    if (_e958.member < _e958.member_1) {
                                        let _e968 = (_e958.member + 1i);
                                        if ((false == (_e968 > _e958.member)) != false) {
                                            phi_4171_ = true;
                                        } else {
                                            phi_4171_ = false;
                                        }
                                        let _e973 = phi_4171_;
                                        if _e973 {
                                            phi_4177_ = type_27(0u, type_27().member_1);
                                        } else {
                                            phi_4177_ = type_27(1u, _e968);
                                        }
                                        let _e979 = phi_4177_;
                                        if (bitcast<i32>(_e979.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_4148_ = type_26(_e979.member_1, _e958.member_1);
                                        phi_4191_ = type_27(1u, _e958.member);
                                    } else {
                                        phi_4148_ = _e958;
                                        phi_4191_ = type_27(0u, type_27().member_1);
                                    }
                                    let _e989 = phi_4148_;
                                    let _e991 = phi_4191_;
                                    let _e994 = (bitcast<i32>(_e991.member) != 0i);
                                    if _e994 {
                                        phi_4151_ = (0.5lf * (_e960 + (_e950 / _e960)));
                                    } else {
                                        phi_4151_ = f64();
                                    }
                                    let _e999 = phi_4151_;
                                    continue;
                                    continuing {
                                        phi_4147_ = _e989;
                                        phi_4150_ = _e999;
                                        break if !(_e994);
                                    }
                                }
                                let _e1004 = local_21;
                                phi_4204_ = (_e1004 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1011 = phi_4204_;
                            if (_e941 < _e936) {
                                phi_4210_ = -(_e1011);
                            } else {
                                phi_4210_ = _e1011;
                            }
                            let _e1015 = phi_4210_;
                            let _e1017 = -((_e941 + _e1015));
                            local_8[0u] = (_e1017 / (_e1017 + _e943));
                            local_8[1u] = (_e940 / (_e940 + _e1017));
                            let _e1026 = local_8[1u];
                            let _e1027 = local_8[0u];
                            if (_e1026 < _e1027) {
                                let _e1030 = local_8[1u];
                                let _e1032 = local_8[0u];
                                local_8[0u] = _e1030;
                                local_8[1u] = _e1032;
                            }
                            phi_4235_ = type_28(0u, 2u);
                            phi_4238_ = 1u;
                            loop {
                                let _e1036 = phi_4235_;
                                let _e1038 = phi_4238_;
                                local_49 = _e1038;
                                if (_e1036.member < _e1036.member_1) {
                                    phi_4236_ = type_28((_e1036.member + 1u), _e1036.member_1);
                                    phi_4261_ = type_28(1u, _e1036.member);
                                } else {
                                    phi_4236_ = _e1036;
                                    phi_4261_ = type_28(0u, type_28().member_1);
                                }
                                let _e1052 = phi_4236_;
                                let _e1054 = phi_4261_;
                                let _e1058 = (bitcast<i32>(_e1054.member) != 0i);
                                if _e1058 {
                                    if (_e1054.member_1 < 2u) {
                                    } else {
                                        return;
                                    }
                                    let _e1061 = local_8[_e1054.member_1];
                                    if (_e1061 > _e936) {
                                        if (_e1054.member_1 < 2u) {
                                        } else {
                                            return;
                                        }
                                        let _e1065 = local_8[_e1054.member_1];
                                        if (_e1065 < _e937) {
                                            if (_e1054.member_1 < 2u) {
                                            } else {
                                                return;
                                            }
                                            let _e1069 = local_8[_e1054.member_1];
                                            if (_e1038 < 4u) {
                                            } else {
                                                return;
                                            }
                                            local_7[_e1038] = _e1069;
                                            phi_4305_ = (_e1038 + 1u);
                                        } else {
                                            phi_4305_ = _e1038;
                                        }
                                        let _e1074 = phi_4305_;
                                        phi_4306_ = _e1074;
                                    } else {
                                        phi_4306_ = _e1038;
                                    }
                                    let _e1076 = phi_4306_;
                                    phi_4239_ = _e1076;
                                } else {
                                    phi_4239_ = u32();
                                }
                                let _e1078 = phi_4239_;
                                continue;
                                continuing {
                                    phi_4235_ = _e1052;
                                    phi_4238_ = _e1078;
                                    break if !(_e1058);
                                }
                            }
                            let _e5123 = local_49;
                            phi_4307_ = _e5123;
                        } else {
                            phi_4307_ = 1u;
                        }
                        let _e1081 = phi_4307_;
                        if (_e1081 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e1081] = _e937;
                        let _e1084 = local_7;
                        local_9 = _e1084;
                        phi_4327_ = type_28(0u, _e1081);
                        loop {
                            let _e1087 = phi_4327_;
                            if (_e1087.member < _e1087.member_1) {
                                phi_4328_ = type_28((_e1087.member + 1u), _e1087.member_1);
                                phi_4351_ = type_28(1u, _e1087.member);
                            } else {
                                phi_4328_ = _e1087;
                                phi_4351_ = type_28(0u, type_28().member_1);
                            }
                            let _e1101 = phi_4328_;
                            let _e1103 = phi_4351_;
                            if (bitcast<i32>(_e1103.member) != 0i) {
                                if (_e1103.member_1 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1110 = local_9[_e1103.member_1];
                                let _e1111 = (_e1103.member_1 + 1u);
                                if (_e1111 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1114 = local_9[_e1111];
                                let _e1116 = (f64(1f) - _e1110);
                                let _e1127 = ((((_e555 * _e1116) + (_e578 * _e1110)) * (_e1116 * _e1116)) + (((_e601 * _e1116) + (_e612 * _e1110)) * (_e1110 * _e1110)));
                                let _e1129 = (f64(1f) - _e1114);
                                let _e1140 = ((((_e555 * _e1129) + (_e578 * _e1114)) * (_e1129 * _e1129)) + (((_e601 * _e1129) + (_e612 * _e1114)) * (_e1114 * _e1114)));
                                if (_e1127 < 0.0lf) {
                                    phi_4405_ = -(_e1127);
                                } else {
                                    phi_4405_ = _e1127;
                                }
                                let _e1144 = phi_4405_;
                                let _e1145 = (_e1144 > _e935);
                                if (_e1140 < 0.0lf) {
                                    phi_4412_ = -(_e1140);
                                } else {
                                    phi_4412_ = _e1140;
                                }
                                let _e1149 = phi_4412_;
                                let _e1150 = (_e1149 > _e935);
                                let _e1151 = f64(0f);
                                if _e1145 {
                                    if _e1150 {
                                        let _e1154 = ((_e1127 > _e1151) != (_e1140 > _e1151));
                                        if _e1145 {
                                            if _e1150 {
                                                if _e1154 {
                                                    phi_4433_ = false;
                                                } else {
                                                    phi_4433_ = true;
                                                }
                                                let _e1156 = phi_4433_;
                                                phi_4434_ = _e1156;
                                            } else {
                                                phi_4434_ = false;
                                            }
                                            let _e1158 = phi_4434_;
                                            phi_4435_ = _e1158;
                                        } else {
                                            phi_4435_ = false;
                                        }
                                        let _e1160 = phi_4435_;
                                        phi_4436_ = _e1154;
                                        phi_4437_ = _e1154;
                                        phi_4438_ = false;
                                        phi_4439_ = _e1160;
                                    } else {
                                        phi_4436_ = bool();
                                        phi_4437_ = bool();
                                        phi_4438_ = true;
                                        phi_4439_ = false;
                                    }
                                    let _e1162 = phi_4436_;
                                    let _e1164 = phi_4437_;
                                    let _e1166 = phi_4438_;
                                    let _e1168 = phi_4439_;
                                    phi_4440_ = _e1162;
                                    phi_4441_ = _e1164;
                                    phi_4442_ = _e1166;
                                    phi_4443_ = _e1168;
                                } else {
                                    phi_4440_ = bool();
                                    phi_4441_ = bool();
                                    phi_4442_ = true;
                                    phi_4443_ = false;
                                }
                                let _e1170 = phi_4440_;
                                let _e1172 = phi_4441_;
                                let _e1174 = phi_4442_;
                                let _e1176 = phi_4443_;
                                if _e1174 {
                                    if _e1145 {
                                        phi_4453_ = _e1150;
                                    } else {
                                        phi_4453_ = false;
                                    }
                                    let _e1178 = phi_4453_;
                                    phi_4454_ = false;
                                    phi_4455_ = false;
                                    phi_4456_ = _e1178;
                                } else {
                                    phi_4454_ = _e1172;
                                    phi_4455_ = _e1170;
                                    phi_4456_ = _e1176;
                                }
                                let _e1180 = phi_4454_;
                                let _e1182 = phi_4455_;
                                let _e1184 = phi_4456_;
                                if _e1184 {
                                    phi_4462_ = type_72(f64(1f), _e1151, _e1180);
                                    phi_4463_ = false;
                                } else {
                                    phi_4462_ = type_72();
                                    phi_4463_ = true;
                                }
                                let _e1188 = phi_4462_;
                                let _e1190 = phi_4463_;
                                if _e1190 {
                                    if _e1145 {
                                        if (_e1127 < _e1151) {
                                            phi_4476_ = f64(-1f);
                                        } else {
                                            phi_4476_ = f64(1f);
                                        }
                                        let _e1195 = phi_4476_;
                                        let _e1196 = f64(0.00000000000022737368f);
                                        let _e1197 = f64(0.5f);
                                        let _e1198 = f64(3f);
                                        let _e1201 = (_e601 - _e578);
                                        phi_4489_ = type_28(0u, 64u);
                                        phi_4492_ = _e1114;
                                        phi_4494_ = _e1110;
                                        phi_4496_ = (_e1197 * (_e1110 + _e1114));
                                        loop {
                                            let _e1207 = phi_4489_;
                                            let _e1209 = phi_4492_;
                                            let _e1211 = phi_4494_;
                                            let _e1213 = phi_4496_;
                                            local_51 = _e1211;
                                            if (_e1207.member < _e1207.member_1) {
                                                phi_4490_ = type_28((_e1207.member + 1u), _e1207.member_1);
                                                phi_4519_ = type_28(1u, _e1207.member);
                                            } else {
                                                phi_4490_ = _e1207;
                                                phi_4519_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1227 = phi_4490_;
                                            let _e1229 = phi_4519_;
                                            if (bitcast<i32>(_e1229.member) != 0i) {
                                                let _e1234 = (f64(1f) - _e1213);
                                                let _e1247 = ((_e1195 * ((((_e555 * _e1234) + (_e578 * _e1213)) * (_e1234 * _e1234)) + (((_e601 * _e1234) + (_e612 * _e1213)) * (_e1213 * _e1213)))) - _e935);
                                                if (_e1247 > f64(0f)) {
                                                    phi_4546_ = _e1209;
                                                    phi_4547_ = _e1213;
                                                } else {
                                                    phi_4546_ = _e1213;
                                                    phi_4547_ = _e1211;
                                                }
                                                let _e1251 = phi_4546_;
                                                let _e1253 = phi_4547_;
                                                let _e1255 = ((_e1251 - _e1253) > _e1196);
                                                if _e1255 {
                                                    let _e1257 = (f64(1f) - _e1213);
                                                    let _e1269 = (-(_e1247) / (_e1195 * (((((_e578 - (_e1198 * _e555)) * _e1257) + (_e1201 * _e1213)) * _e1257) + (((_e1201 * _e1257) + (((_e1198 * _e612) - _e601) * _e1213)) * _e1213))));
                                                    if (_e1247 > f64(0f)) {
                                                        phi_4575_ = (_e1197 * _e1196);
                                                    } else {
                                                        phi_4575_ = -((_e1197 * _e1196));
                                                    }
                                                    let _e1276 = phi_4575_;
                                                    let _e1278 = ((_e1213 + _e1269) + _e1276);
                                                    if (_e1278 > _e1253) {
                                                        if (_e1278 < _e1251) {
                                                            if (_e1269 < 0.0lf) {
                                                                phi_4591_ = -(_e1269);
                                                            } else {
                                                                phi_4591_ = _e1269;
                                                            }
                                                            let _e1284 = phi_4591_;
                                                            if (_e1284 < (_e1197 * (_e1251 - _e1253))) {
                                                                phi_4598_ = false;
                                                            } else {
                                                                phi_4598_ = true;
                                                            }
                                                            let _e1289 = phi_4598_;
                                                            phi_4599_ = _e1289;
                                                        } else {
                                                            phi_4599_ = true;
                                                        }
                                                        let _e1291 = phi_4599_;
                                                        phi_4600_ = _e1291;
                                                    } else {
                                                        phi_4600_ = true;
                                                    }
                                                    let _e1293 = phi_4600_;
                                                    if _e1293 {
                                                        phi_4606_ = (_e1197 * (_e1253 + _e1251));
                                                    } else {
                                                        phi_4606_ = _e1278;
                                                    }
                                                    let _e1297 = phi_4606_;
                                                    phi_4607_ = _e1297;
                                                    phi_4608_ = false;
                                                } else {
                                                    phi_4607_ = f64();
                                                    phi_4608_ = true;
                                                }
                                                let _e1299 = phi_4607_;
                                                let _e1301 = phi_4608_;
                                                phi_4493_ = _e1251;
                                                phi_4495_ = _e1253;
                                                phi_4497_ = _e1299;
                                                phi_4609_ = _e1253;
                                                phi_4610_ = _e1255;
                                                phi_4611_ = _e1301;
                                            } else {
                                                phi_4493_ = f64();
                                                phi_4495_ = f64();
                                                phi_4497_ = f64();
                                                phi_4609_ = f64();
                                                phi_4610_ = false;
                                                phi_4611_ = false;
                                            }
                                            let _e1303 = phi_4493_;
                                            let _e1305 = phi_4495_;
                                            let _e1307 = phi_4497_;
                                            let _e1309 = phi_4609_;
                                            let _e1311 = phi_4610_;
                                            let _e1313 = phi_4611_;
                                            local_22 = _e1313;
                                            local_50 = _e1309;
                                            continue;
                                            continuing {
                                                phi_4489_ = _e1227;
                                                phi_4492_ = _e1303;
                                                phi_4494_ = _e1305;
                                                phi_4496_ = _e1307;
                                                break if !(_e1311);
                                            }
                                        }
                                        let _e1316 = local_22;
                                        if _e1316 {
                                            let _e5172 = local_50;
                                            phi_4615_ = _e5172;
                                        } else {
                                            let _e5174 = local_51;
                                            phi_4615_ = _e5174;
                                        }
                                        let _e1318 = phi_4615_;
                                        phi_4616_ = _e1318;
                                    } else {
                                        phi_4616_ = _e1110;
                                    }
                                    let _e1320 = phi_4616_;
                                    if _e1150 {
                                        phi_4624_ = type_28(0u, 64u);
                                        phi_4627_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1324 = phi_4624_;
                                            let _e1326 = phi_4627_;
                                            if (_e1324.member < _e1324.member_1) {
                                                phi_4625_ = type_28((_e1324.member + 1u), _e1324.member_1);
                                                phi_4650_ = type_28(1u, _e1324.member);
                                            } else {
                                                phi_4625_ = _e1324;
                                                phi_4650_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1340 = phi_4625_;
                                            let _e1342 = phi_4650_;
                                            if (bitcast<i32>(_e1342.member) != 0i) {
                                                let _e1346 = (_e1320 + _e1326);
                                                if (_e1346 < _e1114) {
                                                    let _e1349 = (f64(1f) - _e1346);
                                                    let _e1360 = ((((_e555 * _e1349) + (_e578 * _e1346)) * (_e1349 * _e1349)) + (((_e601 * _e1349) + (_e612 * _e1346)) * (_e1346 * _e1346)));
                                                    let _e1362 = (f64(1f) - _e1320);
                                                    let _e1373 = ((((_e555 * _e1362) + (_e578 * _e1320)) * (_e1362 * _e1362)) + (((_e601 * _e1362) + (_e612 * _e1320)) * (_e1320 * _e1320)));
                                                    if (_e1360 < 0.0lf) {
                                                        phi_4693_ = -(_e1360);
                                                    } else {
                                                        phi_4693_ = _e1360;
                                                    }
                                                    let _e1377 = phi_4693_;
                                                    if (_e1377 > _e935) {
                                                        if (_e1373 < 0.0lf) {
                                                            phi_4703_ = -(_e1373);
                                                        } else {
                                                            phi_4703_ = _e1373;
                                                        }
                                                        let _e1382 = phi_4703_;
                                                        if (_e1382 > _e935) {
                                                            phi_4713_ = ((_e1360 > f64(0f)) == (_e1373 > f64(0f)));
                                                        } else {
                                                            phi_4713_ = false;
                                                        }
                                                        let _e1390 = phi_4713_;
                                                        phi_4715_ = !(_e1390);
                                                    } else {
                                                        phi_4715_ = false;
                                                    }
                                                    let _e1393 = phi_4715_;
                                                    if _e1393 {
                                                        phi_4720_ = f64();
                                                        phi_4721_ = false;
                                                    } else {
                                                        phi_4720_ = (_e1326 + _e1326);
                                                        phi_4721_ = true;
                                                    }
                                                    let _e1396 = phi_4720_;
                                                    let _e1398 = phi_4721_;
                                                    phi_4722_ = _e1396;
                                                    phi_4723_ = _e1398;
                                                    phi_4724_ = _e1393;
                                                    phi_4725_ = false;
                                                } else {
                                                    phi_4722_ = f64();
                                                    phi_4723_ = false;
                                                    phi_4724_ = false;
                                                    phi_4725_ = true;
                                                }
                                                let _e1400 = phi_4722_;
                                                let _e1402 = phi_4723_;
                                                let _e1404 = phi_4724_;
                                                let _e1406 = phi_4725_;
                                                phi_4726_ = _e1346;
                                                phi_4628_ = _e1400;
                                                phi_4727_ = _e1402;
                                                phi_4728_ = _e1404;
                                                phi_4729_ = _e1406;
                                                phi_4730_ = false;
                                            } else {
                                                phi_4726_ = f64();
                                                phi_4628_ = f64();
                                                phi_4727_ = false;
                                                phi_4728_ = false;
                                                phi_4729_ = false;
                                                phi_4730_ = true;
                                            }
                                            let _e1408 = phi_4726_;
                                            let _e1410 = phi_4628_;
                                            let _e1412 = phi_4727_;
                                            let _e1414 = phi_4728_;
                                            let _e1416 = phi_4729_;
                                            let _e1418 = phi_4730_;
                                            local_23 = _e1414;
                                            local_52 = _e1416;
                                            local_53 = _e1418;
                                            local_54 = _e1408;
                                            continue;
                                            continuing {
                                                phi_4624_ = _e1340;
                                                phi_4627_ = _e1410;
                                                break if !(_e1412);
                                            }
                                        }
                                        let _e1421 = local_23;
                                        if _e1421 {
                                            phi_4734_ = false;
                                            phi_4735_ = false;
                                        } else {
                                            let _e5199 = local_52;
                                            phi_4734_ = _e5199;
                                            let _e5202 = local_53;
                                            phi_4735_ = _e5202;
                                        }
                                        let _e1423 = phi_4734_;
                                        let _e1425 = phi_4735_;
                                        if _e1423 {
                                            phi_4739_ = true;
                                        } else {
                                            phi_4739_ = _e1425;
                                        }
                                        let _e1427 = phi_4739_;
                                        if _e1427 {
                                            phi_4743_ = _e1114;
                                        } else {
                                            let _e5206 = local_54;
                                            phi_4743_ = _e5206;
                                        }
                                        let _e1429 = phi_4743_;
                                        phi_4744_ = _e1429;
                                    } else {
                                        phi_4744_ = _e1114;
                                    }
                                    let _e1431 = phi_4744_;
                                    phi_4746_ = type_72(_e1320, _e1431, _e1182);
                                } else {
                                    phi_4746_ = _e1188;
                                }
                                let _e1434 = phi_4746_;
                                if (_e1434.member > _e1434.member_1) {
                                    phi_7354_ = f64();
                                    phi_7355_ = true;
                                    phi_7356_ = false;
                                    phi_7357_ = false;
                                    phi_7358_ = false;
                                } else {
                                    let _e1442 = ((_e1434.member_1 - _e1434.member) * f64(0.5f));
                                    let _e1443 = (_e1434.member + _e1442);
                                    let _e1446 = (_e1442 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1448 = local_20.member_3;
                                    let _e1451 = local_20.member[0u];
                                    if (_e1451[0] < 0.0lf) {
                                        phi_4777_ = -(_e1451[0]);
                                    } else {
                                        phi_4777_ = _e1451[0];
                                    }
                                    let _e1458 = phi_4777_;
                                    if (_e1451[1] < 0.0lf) {
                                        phi_4784_ = -(_e1451[1]);
                                    } else {
                                        phi_4784_ = _e1451[1];
                                    }
                                    let _e1462 = phi_4784_;
                                    if (_e1458 > _e1462) {
                                        phi_4789_ = _e1458;
                                    } else {
                                        phi_4789_ = _e1462;
                                    }
                                    let _e1465 = phi_4789_;
                                    if (_e1451[2] < 0.0lf) {
                                        phi_4796_ = -(_e1451[2]);
                                    } else {
                                        phi_4796_ = _e1451[2];
                                    }
                                    let _e1469 = phi_4796_;
                                    if (_e1465 > _e1469) {
                                        phi_4801_ = _e1465;
                                    } else {
                                        phi_4801_ = _e1469;
                                    }
                                    let _e1472 = phi_4801_;
                                    let _e1474 = local_20.member[1u];
                                    if (_e1474[0] < 0.0lf) {
                                        phi_4814_ = -(_e1474[0]);
                                    } else {
                                        phi_4814_ = _e1474[0];
                                    }
                                    let _e1481 = phi_4814_;
                                    if (_e1474[1] < 0.0lf) {
                                        phi_4821_ = -(_e1474[1]);
                                    } else {
                                        phi_4821_ = _e1474[1];
                                    }
                                    let _e1485 = phi_4821_;
                                    if (_e1481 > _e1485) {
                                        phi_4826_ = _e1481;
                                    } else {
                                        phi_4826_ = _e1485;
                                    }
                                    let _e1488 = phi_4826_;
                                    if (_e1474[2] < 0.0lf) {
                                        phi_4833_ = -(_e1474[2]);
                                    } else {
                                        phi_4833_ = _e1474[2];
                                    }
                                    let _e1492 = phi_4833_;
                                    if (_e1488 > _e1492) {
                                        phi_4838_ = _e1488;
                                    } else {
                                        phi_4838_ = _e1492;
                                    }
                                    let _e1495 = phi_4838_;
                                    if (_e1472 > _e1495) {
                                        phi_4843_ = _e1472;
                                    } else {
                                        phi_4843_ = _e1495;
                                    }
                                    let _e1498 = phi_4843_;
                                    let _e1501 = local_20.member[0u];
                                    let _e1506 = local_20.member[1u];
                                    let _e1516 = (_e1501[0] + ((_e1506[0] - _e1501[0]) * _e1443));
                                    let _e1517 = (_e1501[1] + ((_e1506[1] - _e1501[1]) * _e1443));
                                    let _e1518 = (_e1501[2] + ((_e1506[2] - _e1501[2]) * _e1443));
                                    let _e1520 = local_20.member[1u];
                                    let _e1525 = local_20.member[0u];
                                    let _e1529 = (_e1520[0] - _e1525[0]);
                                    let _e1530 = (_e1520[1] - _e1525[1]);
                                    let _e1531 = (_e1520[2] - _e1525[2]);
                                    if (_e1529 < 0.0lf) {
                                        phi_4902_ = -(_e1529);
                                    } else {
                                        phi_4902_ = _e1529;
                                    }
                                    let _e1535 = phi_4902_;
                                    if (_e1530 < 0.0lf) {
                                        phi_4908_ = -(_e1530);
                                    } else {
                                        phi_4908_ = _e1530;
                                    }
                                    let _e1539 = phi_4908_;
                                    if (_e1535 > _e1539) {
                                        phi_4913_ = _e1535;
                                    } else {
                                        phi_4913_ = _e1539;
                                    }
                                    let _e1542 = phi_4913_;
                                    if (_e1531 < 0.0lf) {
                                        phi_4919_ = -(_e1531);
                                    } else {
                                        phi_4919_ = _e1531;
                                    }
                                    let _e1546 = phi_4919_;
                                    if (_e1542 > _e1546) {
                                        phi_4924_ = _e1542;
                                    } else {
                                        phi_4924_ = _e1546;
                                    }
                                    let _e1549 = phi_4924_;
                                    let _e1557 = ((((_e1446 * _e1549) * f64(1.01f)) + ((_e1498 + _e1448) * (1.1102230246251565e-16lf * f64(8f)))) + _e1448);
                                    if (_e1516 < 0.0lf) {
                                        phi_4938_ = -(_e1516);
                                    } else {
                                        phi_4938_ = _e1516;
                                    }
                                    let _e1561 = phi_4938_;
                                    if (_e1517 < 0.0lf) {
                                        phi_4944_ = -(_e1517);
                                    } else {
                                        phi_4944_ = _e1517;
                                    }
                                    let _e1565 = phi_4944_;
                                    if (_e1561 > _e1565) {
                                        phi_4949_ = _e1561;
                                    } else {
                                        phi_4949_ = _e1565;
                                    }
                                    let _e1568 = phi_4949_;
                                    if (_e1518 < 0.0lf) {
                                        phi_4955_ = -(_e1518);
                                    } else {
                                        phi_4955_ = _e1518;
                                    }
                                    let _e1572 = phi_4955_;
                                    if (_e1568 > _e1572) {
                                        phi_4960_ = _e1568;
                                    } else {
                                        phi_4960_ = _e1572;
                                    }
                                    let _e1575 = phi_4960_;
                                    local_3 = type_50(array<f64, 3>(_e1516, _e1517, _e1518), _e1557, (_e1575 + _e1557));
                                    let _e1581 = local_20.member_3;
                                    let _e1583 = local_20.member_1[0u];
                                    if (_e1583[0] < 0.0lf) {
                                        phi_4986_ = -(_e1583[0]);
                                    } else {
                                        phi_4986_ = _e1583[0];
                                    }
                                    let _e1590 = phi_4986_;
                                    if (_e1583[1] < 0.0lf) {
                                        phi_4993_ = -(_e1583[1]);
                                    } else {
                                        phi_4993_ = _e1583[1];
                                    }
                                    let _e1594 = phi_4993_;
                                    if (_e1590 > _e1594) {
                                        phi_4998_ = _e1590;
                                    } else {
                                        phi_4998_ = _e1594;
                                    }
                                    let _e1597 = phi_4998_;
                                    if (_e1583[2] < 0.0lf) {
                                        phi_5005_ = -(_e1583[2]);
                                    } else {
                                        phi_5005_ = _e1583[2];
                                    }
                                    let _e1601 = phi_5005_;
                                    if (_e1597 > _e1601) {
                                        phi_5010_ = _e1597;
                                    } else {
                                        phi_5010_ = _e1601;
                                    }
                                    let _e1604 = phi_5010_;
                                    let _e1606 = local_20.member_1[1u];
                                    if (_e1606[0] < 0.0lf) {
                                        phi_5023_ = -(_e1606[0]);
                                    } else {
                                        phi_5023_ = _e1606[0];
                                    }
                                    let _e1613 = phi_5023_;
                                    if (_e1606[1] < 0.0lf) {
                                        phi_5030_ = -(_e1606[1]);
                                    } else {
                                        phi_5030_ = _e1606[1];
                                    }
                                    let _e1617 = phi_5030_;
                                    if (_e1613 > _e1617) {
                                        phi_5035_ = _e1613;
                                    } else {
                                        phi_5035_ = _e1617;
                                    }
                                    let _e1620 = phi_5035_;
                                    if (_e1606[2] < 0.0lf) {
                                        phi_5042_ = -(_e1606[2]);
                                    } else {
                                        phi_5042_ = _e1606[2];
                                    }
                                    let _e1624 = phi_5042_;
                                    if (_e1620 > _e1624) {
                                        phi_5047_ = _e1620;
                                    } else {
                                        phi_5047_ = _e1624;
                                    }
                                    let _e1627 = phi_5047_;
                                    if (_e1604 > _e1627) {
                                        phi_5052_ = _e1604;
                                    } else {
                                        phi_5052_ = _e1627;
                                    }
                                    let _e1630 = phi_5052_;
                                    let _e1633 = local_20.member_1[0u];
                                    let _e1638 = local_20.member_1[1u];
                                    let _e1648 = (_e1633[0] + ((_e1638[0] - _e1633[0]) * _e1443));
                                    let _e1649 = (_e1633[1] + ((_e1638[1] - _e1633[1]) * _e1443));
                                    let _e1650 = (_e1633[2] + ((_e1638[2] - _e1633[2]) * _e1443));
                                    let _e1652 = local_20.member_1[1u];
                                    let _e1657 = local_20.member_1[0u];
                                    let _e1661 = (_e1652[0] - _e1657[0]);
                                    let _e1662 = (_e1652[1] - _e1657[1]);
                                    let _e1663 = (_e1652[2] - _e1657[2]);
                                    if (_e1661 < 0.0lf) {
                                        phi_5111_ = -(_e1661);
                                    } else {
                                        phi_5111_ = _e1661;
                                    }
                                    let _e1667 = phi_5111_;
                                    if (_e1662 < 0.0lf) {
                                        phi_5117_ = -(_e1662);
                                    } else {
                                        phi_5117_ = _e1662;
                                    }
                                    let _e1671 = phi_5117_;
                                    if (_e1667 > _e1671) {
                                        phi_5122_ = _e1667;
                                    } else {
                                        phi_5122_ = _e1671;
                                    }
                                    let _e1674 = phi_5122_;
                                    if (_e1663 < 0.0lf) {
                                        phi_5128_ = -(_e1663);
                                    } else {
                                        phi_5128_ = _e1663;
                                    }
                                    let _e1678 = phi_5128_;
                                    if (_e1674 > _e1678) {
                                        phi_5133_ = _e1674;
                                    } else {
                                        phi_5133_ = _e1678;
                                    }
                                    let _e1681 = phi_5133_;
                                    let _e1689 = ((((_e1446 * _e1681) * f64(1.01f)) + ((_e1630 + _e1581) * (1.1102230246251565e-16lf * f64(8f)))) + _e1581);
                                    if (_e1648 < 0.0lf) {
                                        phi_5147_ = -(_e1648);
                                    } else {
                                        phi_5147_ = _e1648;
                                    }
                                    let _e1693 = phi_5147_;
                                    if (_e1649 < 0.0lf) {
                                        phi_5153_ = -(_e1649);
                                    } else {
                                        phi_5153_ = _e1649;
                                    }
                                    let _e1697 = phi_5153_;
                                    if (_e1693 > _e1697) {
                                        phi_5158_ = _e1693;
                                    } else {
                                        phi_5158_ = _e1697;
                                    }
                                    let _e1700 = phi_5158_;
                                    if (_e1650 < 0.0lf) {
                                        phi_5164_ = -(_e1650);
                                    } else {
                                        phi_5164_ = _e1650;
                                    }
                                    let _e1704 = phi_5164_;
                                    if (_e1700 > _e1704) {
                                        phi_5169_ = _e1700;
                                    } else {
                                        phi_5169_ = _e1704;
                                    }
                                    let _e1707 = phi_5169_;
                                    local_4 = type_50(array<f64, 3>(_e1648, _e1649, _e1650), _e1689, (_e1707 + _e1689));
                                    let _e1713 = local_20.member_3;
                                    let _e1715 = local_20.member_2[0u];
                                    if (_e1715[0] < 0.0lf) {
                                        phi_5195_ = -(_e1715[0]);
                                    } else {
                                        phi_5195_ = _e1715[0];
                                    }
                                    let _e1722 = phi_5195_;
                                    if (_e1715[1] < 0.0lf) {
                                        phi_5202_ = -(_e1715[1]);
                                    } else {
                                        phi_5202_ = _e1715[1];
                                    }
                                    let _e1726 = phi_5202_;
                                    if (_e1722 > _e1726) {
                                        phi_5207_ = _e1722;
                                    } else {
                                        phi_5207_ = _e1726;
                                    }
                                    let _e1729 = phi_5207_;
                                    if (_e1715[2] < 0.0lf) {
                                        phi_5214_ = -(_e1715[2]);
                                    } else {
                                        phi_5214_ = _e1715[2];
                                    }
                                    let _e1733 = phi_5214_;
                                    if (_e1729 > _e1733) {
                                        phi_5219_ = _e1729;
                                    } else {
                                        phi_5219_ = _e1733;
                                    }
                                    let _e1736 = phi_5219_;
                                    let _e1738 = local_20.member_2[1u];
                                    if (_e1738[0] < 0.0lf) {
                                        phi_5232_ = -(_e1738[0]);
                                    } else {
                                        phi_5232_ = _e1738[0];
                                    }
                                    let _e1745 = phi_5232_;
                                    if (_e1738[1] < 0.0lf) {
                                        phi_5239_ = -(_e1738[1]);
                                    } else {
                                        phi_5239_ = _e1738[1];
                                    }
                                    let _e1749 = phi_5239_;
                                    if (_e1745 > _e1749) {
                                        phi_5244_ = _e1745;
                                    } else {
                                        phi_5244_ = _e1749;
                                    }
                                    let _e1752 = phi_5244_;
                                    if (_e1738[2] < 0.0lf) {
                                        phi_5251_ = -(_e1738[2]);
                                    } else {
                                        phi_5251_ = _e1738[2];
                                    }
                                    let _e1756 = phi_5251_;
                                    if (_e1752 > _e1756) {
                                        phi_5256_ = _e1752;
                                    } else {
                                        phi_5256_ = _e1756;
                                    }
                                    let _e1759 = phi_5256_;
                                    if (_e1736 > _e1759) {
                                        phi_5261_ = _e1736;
                                    } else {
                                        phi_5261_ = _e1759;
                                    }
                                    let _e1762 = phi_5261_;
                                    let _e1765 = local_20.member_2[0u];
                                    let _e1770 = local_20.member_2[1u];
                                    let _e1780 = (_e1765[0] + ((_e1770[0] - _e1765[0]) * _e1443));
                                    let _e1781 = (_e1765[1] + ((_e1770[1] - _e1765[1]) * _e1443));
                                    let _e1782 = (_e1765[2] + ((_e1770[2] - _e1765[2]) * _e1443));
                                    let _e1784 = local_20.member_2[1u];
                                    let _e1789 = local_20.member_2[0u];
                                    let _e1793 = (_e1784[0] - _e1789[0]);
                                    let _e1794 = (_e1784[1] - _e1789[1]);
                                    let _e1795 = (_e1784[2] - _e1789[2]);
                                    if (_e1793 < 0.0lf) {
                                        phi_5320_ = -(_e1793);
                                    } else {
                                        phi_5320_ = _e1793;
                                    }
                                    let _e1799 = phi_5320_;
                                    if (_e1794 < 0.0lf) {
                                        phi_5326_ = -(_e1794);
                                    } else {
                                        phi_5326_ = _e1794;
                                    }
                                    let _e1803 = phi_5326_;
                                    if (_e1799 > _e1803) {
                                        phi_5331_ = _e1799;
                                    } else {
                                        phi_5331_ = _e1803;
                                    }
                                    let _e1806 = phi_5331_;
                                    if (_e1795 < 0.0lf) {
                                        phi_5337_ = -(_e1795);
                                    } else {
                                        phi_5337_ = _e1795;
                                    }
                                    let _e1810 = phi_5337_;
                                    if (_e1806 > _e1810) {
                                        phi_5342_ = _e1806;
                                    } else {
                                        phi_5342_ = _e1810;
                                    }
                                    let _e1813 = phi_5342_;
                                    let _e1821 = ((((_e1446 * _e1813) * f64(1.01f)) + ((_e1762 + _e1713) * (1.1102230246251565e-16lf * f64(8f)))) + _e1713);
                                    if (_e1780 < 0.0lf) {
                                        phi_5356_ = -(_e1780);
                                    } else {
                                        phi_5356_ = _e1780;
                                    }
                                    let _e1825 = phi_5356_;
                                    if (_e1781 < 0.0lf) {
                                        phi_5362_ = -(_e1781);
                                    } else {
                                        phi_5362_ = _e1781;
                                    }
                                    let _e1829 = phi_5362_;
                                    if (_e1825 > _e1829) {
                                        phi_5367_ = _e1825;
                                    } else {
                                        phi_5367_ = _e1829;
                                    }
                                    let _e1832 = phi_5367_;
                                    if (_e1782 < 0.0lf) {
                                        phi_5373_ = -(_e1782);
                                    } else {
                                        phi_5373_ = _e1782;
                                    }
                                    let _e1836 = phi_5373_;
                                    if (_e1832 > _e1836) {
                                        phi_5378_ = _e1832;
                                    } else {
                                        phi_5378_ = _e1836;
                                    }
                                    let _e1839 = phi_5378_;
                                    local_5 = type_50(array<f64, 3>(_e1780, _e1781, _e1782), _e1821, (_e1839 + _e1821));
                                    let _e1844 = local_4.member;
                                    let _e1849 = local_5.member;
                                    let _e1855 = ((_e1844[1] * _e1849[2]) - (_e1844[2] * _e1849[1]));
                                    let _e1858 = ((_e1844[2] * _e1849[0]) - (_e1844[0] * _e1849[2]));
                                    let _e1861 = ((_e1844[0] * _e1849[1]) - (_e1844[1] * _e1849[0]));
                                    if (_e1855 < 0.0lf) {
                                        phi_5427_ = -(_e1855);
                                    } else {
                                        phi_5427_ = _e1855;
                                    }
                                    let _e1865 = phi_5427_;
                                    if (_e1858 < 0.0lf) {
                                        phi_5433_ = -(_e1858);
                                    } else {
                                        phi_5433_ = _e1858;
                                    }
                                    let _e1869 = phi_5433_;
                                    if (_e1865 > _e1869) {
                                        if (_e1855 < 0.0lf) {
                                            phi_5443_ = -(_e1855);
                                        } else {
                                            phi_5443_ = _e1855;
                                        }
                                        let _e1887 = phi_5443_;
                                        if (_e1861 < 0.0lf) {
                                            phi_5449_ = -(_e1861);
                                        } else {
                                            phi_5449_ = _e1861;
                                        }
                                        let _e1891 = phi_5449_;
                                        if (_e1887 > _e1891) {
                                            phi_5454_ = 2u;
                                            phi_5455_ = 1u;
                                        } else {
                                            phi_5454_ = 1u;
                                            phi_5455_ = 0u;
                                        }
                                        let _e1894 = phi_5454_;
                                        let _e1896 = phi_5455_;
                                        phi_5474_ = _e1894;
                                        phi_5475_ = _e1896;
                                    } else {
                                        if (_e1858 < 0.0lf) {
                                            phi_5461_ = -(_e1858);
                                        } else {
                                            phi_5461_ = _e1858;
                                        }
                                        let _e1874 = phi_5461_;
                                        if (_e1861 < 0.0lf) {
                                            phi_5467_ = -(_e1861);
                                        } else {
                                            phi_5467_ = _e1861;
                                        }
                                        let _e1878 = phi_5467_;
                                        if (_e1874 > _e1878) {
                                            phi_5472_ = 0u;
                                            phi_5473_ = 2u;
                                        } else {
                                            phi_5472_ = 1u;
                                            phi_5473_ = 0u;
                                        }
                                        let _e1881 = phi_5472_;
                                        let _e1883 = phi_5473_;
                                        phi_5474_ = _e1881;
                                        phi_5475_ = _e1883;
                                    }
                                    let _e1898 = phi_5474_;
                                    let _e1900 = phi_5475_;
                                    if (_e1900 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1904 = local_4.member[_e1900];
                                    if (_e1898 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1908 = local_5.member[_e1898];
                                    if (_e1898 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1913 = local_4.member[_e1898];
                                    if (_e1900 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1917 = local_5.member[_e1900];
                                    let _e1919 = ((_e1904 * _e1908) - (_e1913 * _e1917));
                                    let _e1920 = f64(1f);
                                    let _e1922 = local_4.member_1;
                                    let _e1924 = local_5.member_2;
                                    let _e1927 = local_4.member_2;
                                    let _e1929 = local_5.member_1;
                                    let _e1935 = local_4.member_2;
                                    let _e1937 = local_5.member_2;
                                    let _e1946 = local_4.member_2;
                                    let _e1949 = local_5.member_2;
                                    let _e1953 = (((((_e1922 * _e1924) + (_e1927 * _e1929)) * f64(2.01f)) + ((_e1935 * _e1937) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1920 + _e1946) * (_e1920 + _e1949))));
                                    if (_e1919 < 0.0lf) {
                                        phi_5546_ = -(_e1919);
                                    } else {
                                        phi_5546_ = _e1919;
                                    }
                                    let _e1957 = phi_5546_;
                                    if (_e1957 > _e1953) {
                                        if (_e1919 < f64(0f)) {
                                            phi_5558_ = f64(-1f);
                                        } else {
                                            phi_5558_ = f64(1f);
                                        }
                                        let _e1964 = phi_5558_;
                                        if (_e1900 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1968 = local_3.member[_e1900];
                                        if (_e1898 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1972 = local_5.member[_e1898];
                                        if (_e1898 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1977 = local_3.member[_e1898];
                                        if (_e1900 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1981 = local_5.member[_e1900];
                                        let _e1984 = f64(1f);
                                        let _e1986 = local_3.member_1;
                                        let _e1988 = local_5.member_2;
                                        let _e1991 = local_3.member_2;
                                        let _e1993 = local_5.member_1;
                                        let _e1999 = local_3.member_2;
                                        let _e2001 = local_5.member_2;
                                        let _e2010 = local_3.member_2;
                                        let _e2013 = local_5.member_2;
                                        let _e2017 = (((((_e1986 * _e1988) + (_e1991 * _e1993)) * f64(2.01f)) + ((_e1999 * _e2001) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1984 + _e2010) * (_e1984 + _e2013))));
                                        if (_e1900 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2021 = local_4.member[_e1900];
                                        if (_e1898 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2025 = local_3.member[_e1898];
                                        if (_e1898 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2030 = local_4.member[_e1898];
                                        if (_e1900 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2034 = local_3.member[_e1900];
                                        let _e2037 = f64(1f);
                                        let _e2039 = local_4.member_1;
                                        let _e2041 = local_3.member_2;
                                        let _e2044 = local_4.member_2;
                                        let _e2046 = local_3.member_1;
                                        let _e2052 = local_4.member_2;
                                        let _e2054 = local_3.member_2;
                                        let _e2063 = local_4.member_2;
                                        let _e2066 = local_3.member_2;
                                        let _e2070 = (((((_e2039 * _e2041) + (_e2044 * _e2046)) * f64(2.01f)) + ((_e2052 * _e2054) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2037 + _e2063) * (_e2037 + _e2066))));
                                        let _e2071 = (_e1919 * _e1964);
                                        let _e2072 = (((_e1968 * _e1972) - (_e1977 * _e1981)) * _e1964);
                                        let _e2073 = (((_e2021 * _e2025) - (_e2030 * _e2034)) * _e1964);
                                        if (_e2071 < 0.0lf) {
                                            phi_5697_ = -(_e2071);
                                        } else {
                                            phi_5697_ = _e2071;
                                        }
                                        let _e2077 = phi_5697_;
                                        if (_e2072 < 0.0lf) {
                                            phi_5703_ = -(_e2072);
                                        } else {
                                            phi_5703_ = _e2072;
                                        }
                                        let _e2081 = phi_5703_;
                                        if (_e2073 < 0.0lf) {
                                            phi_5710_ = -(_e2073);
                                        } else {
                                            phi_5710_ = _e2073;
                                        }
                                        let _e2086 = phi_5710_;
                                        let _e2090 = (((_e2077 + _e2081) + _e2086) * (1.1102230246251565e-16lf * f64(4f)));
                                        local_6[0u].member = _e2072;
                                        local_6[0u].member_1 = _e2017;
                                        local_6[1u].member = _e2073;
                                        local_6[1u].member_1 = _e2070;
                                        local_6[2u].member = (_e2071 - _e2072);
                                        local_6[2u].member_1 = ((_e1953 + _e2017) + _e2090);
                                        local_6[3u].member = (_e2071 - _e2073);
                                        local_6[3u].member_1 = ((_e1953 + _e2070) + _e2090);
                                        phi_5754_ = type_28(0u, 4u);
                                        phi_5757_ = true;
                                        loop {
                                            let _e2111 = phi_5754_;
                                            let _e2113 = phi_5757_;
                                            local_25 = _e2113;
                                            if (_e2111.member < _e2111.member_1) {
                                                phi_5755_ = type_28((_e2111.member + 1u), _e2111.member_1);
                                                phi_5780_ = type_28(1u, _e2111.member);
                                            } else {
                                                phi_5755_ = _e2111;
                                                phi_5780_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e2127 = phi_5755_;
                                            let _e2129 = phi_5780_;
                                            if (bitcast<i32>(_e2129.member) != 0i) {
                                                if (_e2129.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e2137 = local_6[_e2129.member_1].member;
                                                let _e2140 = local_6[_e2129.member_1].member_1;
                                                let _e2142 = (_e2137 < -(_e2140));
                                                if _e2142 {
                                                    phi_5807_ = bool();
                                                    phi_5808_ = false;
                                                } else {
                                                    phi_5807_ = (_e2113 && (_e2137 > _e2140));
                                                    phi_5808_ = true;
                                                }
                                                let _e2146 = phi_5807_;
                                                let _e2148 = phi_5808_;
                                                phi_5758_ = _e2146;
                                                phi_5809_ = _e2148;
                                                phi_5810_ = _e2142;
                                            } else {
                                                phi_5758_ = bool();
                                                phi_5809_ = false;
                                                phi_5810_ = false;
                                            }
                                            let _e2150 = phi_5758_;
                                            let _e2152 = phi_5809_;
                                            let _e2154 = phi_5810_;
                                            local_24 = _e2154;
                                            continue;
                                            continuing {
                                                phi_5754_ = _e2127;
                                                phi_5757_ = _e2150;
                                                break if !(_e2152);
                                            }
                                        }
                                        let _e2157 = local_24;
                                        if _e2157 {
                                            phi_5814_ = false;
                                        } else {
                                            phi_5814_ = true;
                                        }
                                        let _e2159 = phi_5814_;
                                        if _e2159 {
                                            let _e2161 = local_25;
                                            if _e2161 {
                                                phi_5821_ = 1u;
                                            } else {
                                                phi_5821_ = 2u;
                                            }
                                            let _e2163 = phi_5821_;
                                            phi_5822_ = _e2163;
                                            phi_5823_ = false;
                                        } else {
                                            phi_5822_ = u32();
                                            phi_5823_ = true;
                                        }
                                        let _e2165 = phi_5822_;
                                        let _e2167 = phi_5823_;
                                        phi_5824_ = _e2165;
                                        phi_5825_ = 0u;
                                        phi_5826_ = _e2167;
                                    } else {
                                        phi_5824_ = u32();
                                        phi_5825_ = 2u;
                                        phi_5826_ = true;
                                    }
                                    let _e2169 = phi_5824_;
                                    let _e2171 = phi_5825_;
                                    let _e2173 = phi_5826_;
                                    if _e2173 {
                                        phi_5830_ = _e2171;
                                    } else {
                                        phi_5830_ = _e2169;
                                    }
                                    let _e2175 = phi_5830_;
                                    let _e2176 = (_e2175 == 0u);
                                    if _e2176 {
                                        phi_7350_ = f64();
                                        phi_7351_ = false;
                                        phi_7352_ = false;
                                        phi_7353_ = false;
                                    } else {
                                        if (_e2175 == 1u) {
                                            if _e1434.member_2 {
                                                if ((_e1434.member_1 - _e1434.member) <= f64(0.0000005f)) {
                                                    phi_5851_ = false;
                                                } else {
                                                    phi_5851_ = true;
                                                }
                                                let _e2185 = phi_5851_;
                                                phi_5852_ = _e2185;
                                            } else {
                                                phi_5852_ = true;
                                            }
                                            let _e2187 = phi_5852_;
                                            phi_5853_ = _e2187;
                                        } else {
                                            phi_5853_ = true;
                                        }
                                        let _e2189 = phi_5853_;
                                        if _e2189 {
                                            let _e2195 = local_20.member[0u];
                                            let _e2201 = local_20.member_1[0u];
                                            let _e2207 = local_20.member_2[0u];
                                            let _e2211 = (_e2195[0] - _e2201[0]);
                                            let _e2212 = (_e2195[1] - _e2201[1]);
                                            let _e2213 = (_e2195[2] - _e2201[2]);
                                            local_1 = array<array<f64, 3>, 4>(_e2195, array<f64, 3>(_e2211, _e2212, _e2213), array<f64, 3>((_e2195[0] - _e2207[0]), (_e2195[1] - _e2207[1]), (_e2195[2] - _e2207[2])), array<f64, 3>((_e2211 - _e2207[0]), (_e2212 - _e2207[1]), (_e2213 - _e2207[2])));
                                            let _e2226 = local_20.member[1u];
                                            let _e2232 = local_20.member_1[1u];
                                            let _e2238 = local_20.member_2[1u];
                                            let _e2242 = (_e2226[0] - _e2232[0]);
                                            let _e2243 = (_e2226[1] - _e2232[1]);
                                            let _e2244 = (_e2226[2] - _e2232[2]);
                                            local_2 = array<array<f64, 3>, 4>(_e2226, array<f64, 3>(_e2242, _e2243, _e2244), array<f64, 3>((_e2226[0] - _e2238[0]), (_e2226[1] - _e2238[1]), (_e2226[2] - _e2238[2])), array<f64, 3>((_e2242 - _e2238[0]), (_e2243 - _e2238[1]), (_e2244 - _e2238[2])));
                                            let _e2257 = local_20.member[0u];
                                            if (_e2257[0] < 0.0lf) {
                                                phi_6050_ = -(_e2257[0]);
                                            } else {
                                                phi_6050_ = _e2257[0];
                                            }
                                            let _e2264 = phi_6050_;
                                            if (_e2257[1] < 0.0lf) {
                                                phi_6057_ = -(_e2257[1]);
                                            } else {
                                                phi_6057_ = _e2257[1];
                                            }
                                            let _e2268 = phi_6057_;
                                            if (_e2264 > _e2268) {
                                                phi_6062_ = _e2264;
                                            } else {
                                                phi_6062_ = _e2268;
                                            }
                                            let _e2271 = phi_6062_;
                                            if (_e2257[2] < 0.0lf) {
                                                phi_6069_ = -(_e2257[2]);
                                            } else {
                                                phi_6069_ = _e2257[2];
                                            }
                                            let _e2275 = phi_6069_;
                                            if (_e2271 > _e2275) {
                                                phi_6074_ = _e2271;
                                            } else {
                                                phi_6074_ = _e2275;
                                            }
                                            let _e2278 = phi_6074_;
                                            let _e2281 = local_20.member[1u];
                                            if (_e2281[0] < 0.0lf) {
                                                phi_6087_ = -(_e2281[0]);
                                            } else {
                                                phi_6087_ = _e2281[0];
                                            }
                                            let _e2288 = phi_6087_;
                                            if (_e2281[1] < 0.0lf) {
                                                phi_6094_ = -(_e2281[1]);
                                            } else {
                                                phi_6094_ = _e2281[1];
                                            }
                                            let _e2292 = phi_6094_;
                                            if (_e2288 > _e2292) {
                                                phi_6099_ = _e2288;
                                            } else {
                                                phi_6099_ = _e2292;
                                            }
                                            let _e2295 = phi_6099_;
                                            if (_e2281[2] < 0.0lf) {
                                                phi_6106_ = -(_e2281[2]);
                                            } else {
                                                phi_6106_ = _e2281[2];
                                            }
                                            let _e2299 = phi_6106_;
                                            if (_e2295 > _e2299) {
                                                phi_6111_ = _e2295;
                                            } else {
                                                phi_6111_ = _e2299;
                                            }
                                            let _e2302 = phi_6111_;
                                            if (_e2278 > _e2302) {
                                                phi_6116_ = _e2278;
                                            } else {
                                                phi_6116_ = _e2302;
                                            }
                                            let _e2305 = phi_6116_;
                                            let _e2307 = local_20.member_3;
                                            let _e2311 = local_20.member_1[0u];
                                            if (_e2311[0] < 0.0lf) {
                                                phi_6133_ = -(_e2311[0]);
                                            } else {
                                                phi_6133_ = _e2311[0];
                                            }
                                            let _e2318 = phi_6133_;
                                            if (_e2311[1] < 0.0lf) {
                                                phi_6140_ = -(_e2311[1]);
                                            } else {
                                                phi_6140_ = _e2311[1];
                                            }
                                            let _e2322 = phi_6140_;
                                            if (_e2318 > _e2322) {
                                                phi_6145_ = _e2318;
                                            } else {
                                                phi_6145_ = _e2322;
                                            }
                                            let _e2325 = phi_6145_;
                                            if (_e2311[2] < 0.0lf) {
                                                phi_6152_ = -(_e2311[2]);
                                            } else {
                                                phi_6152_ = _e2311[2];
                                            }
                                            let _e2329 = phi_6152_;
                                            if (_e2325 > _e2329) {
                                                phi_6157_ = _e2325;
                                            } else {
                                                phi_6157_ = _e2329;
                                            }
                                            let _e2332 = phi_6157_;
                                            let _e2335 = local_20.member_1[1u];
                                            if (_e2335[0] < 0.0lf) {
                                                phi_6171_ = -(_e2335[0]);
                                            } else {
                                                phi_6171_ = _e2335[0];
                                            }
                                            let _e2342 = phi_6171_;
                                            if (_e2335[1] < 0.0lf) {
                                                phi_6178_ = -(_e2335[1]);
                                            } else {
                                                phi_6178_ = _e2335[1];
                                            }
                                            let _e2346 = phi_6178_;
                                            if (_e2342 > _e2346) {
                                                phi_6183_ = _e2342;
                                            } else {
                                                phi_6183_ = _e2346;
                                            }
                                            let _e2349 = phi_6183_;
                                            if (_e2335[2] < 0.0lf) {
                                                phi_6190_ = -(_e2335[2]);
                                            } else {
                                                phi_6190_ = _e2335[2];
                                            }
                                            let _e2353 = phi_6190_;
                                            if (_e2349 > _e2353) {
                                                phi_6195_ = _e2349;
                                            } else {
                                                phi_6195_ = _e2353;
                                            }
                                            let _e2356 = phi_6195_;
                                            if (_e2332 > _e2356) {
                                                phi_6200_ = _e2332;
                                            } else {
                                                phi_6200_ = _e2356;
                                            }
                                            let _e2359 = phi_6200_;
                                            let _e2361 = local_20.member_3;
                                            let _e2365 = local_20.member_2[0u];
                                            if (_e2365[0] < 0.0lf) {
                                                phi_6217_ = -(_e2365[0]);
                                            } else {
                                                phi_6217_ = _e2365[0];
                                            }
                                            let _e2372 = phi_6217_;
                                            if (_e2365[1] < 0.0lf) {
                                                phi_6224_ = -(_e2365[1]);
                                            } else {
                                                phi_6224_ = _e2365[1];
                                            }
                                            let _e2376 = phi_6224_;
                                            if (_e2372 > _e2376) {
                                                phi_6229_ = _e2372;
                                            } else {
                                                phi_6229_ = _e2376;
                                            }
                                            let _e2379 = phi_6229_;
                                            if (_e2365[2] < 0.0lf) {
                                                phi_6236_ = -(_e2365[2]);
                                            } else {
                                                phi_6236_ = _e2365[2];
                                            }
                                            let _e2383 = phi_6236_;
                                            if (_e2379 > _e2383) {
                                                phi_6241_ = _e2379;
                                            } else {
                                                phi_6241_ = _e2383;
                                            }
                                            let _e2386 = phi_6241_;
                                            let _e2389 = local_20.member_2[1u];
                                            if (_e2389[0] < 0.0lf) {
                                                phi_6255_ = -(_e2389[0]);
                                            } else {
                                                phi_6255_ = _e2389[0];
                                            }
                                            let _e2396 = phi_6255_;
                                            if (_e2389[1] < 0.0lf) {
                                                phi_6262_ = -(_e2389[1]);
                                            } else {
                                                phi_6262_ = _e2389[1];
                                            }
                                            let _e2400 = phi_6262_;
                                            if (_e2396 > _e2400) {
                                                phi_6267_ = _e2396;
                                            } else {
                                                phi_6267_ = _e2400;
                                            }
                                            let _e2403 = phi_6267_;
                                            if (_e2389[2] < 0.0lf) {
                                                phi_6274_ = -(_e2389[2]);
                                            } else {
                                                phi_6274_ = _e2389[2];
                                            }
                                            let _e2407 = phi_6274_;
                                            if (_e2403 > _e2407) {
                                                phi_6279_ = _e2403;
                                            } else {
                                                phi_6279_ = _e2407;
                                            }
                                            let _e2410 = phi_6279_;
                                            if (_e2386 > _e2410) {
                                                phi_6284_ = _e2386;
                                            } else {
                                                phi_6284_ = _e2410;
                                            }
                                            let _e2413 = phi_6284_;
                                            let _e2415 = local_20.member_3;
                                            let _e2423 = local_20.member_3;
                                            phi_6304_ = type_28(0u, 48u);
                                            phi_6307_ = _e1434.member;
                                            loop {
                                                let _e2432 = phi_6304_;
                                                let _e2434 = phi_6307_;
                                                local_65 = _e2434;
                                                local_32 = _e2434;
                                                local_33 = _e2434;
                                                local_34 = _e2434;
                                                if (_e2432.member < _e2432.member_1) {
                                                    phi_6305_ = type_28((_e2432.member + 1u), _e2432.member_1);
                                                    phi_6330_ = type_28(1u, _e2432.member);
                                                } else {
                                                    phi_6305_ = _e2432;
                                                    phi_6330_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e2448 = phi_6305_;
                                                let _e2450 = phi_6330_;
                                                if (bitcast<i32>(_e2450.member) != 0i) {
                                                    let _e2456 = local_20.member[0u];
                                                    let _e2462 = local_20.member[1u];
                                                    let _e2472 = (_e2456[0] + ((_e2462[0] - _e2456[0]) * _e2434));
                                                    let _e2473 = (_e2456[1] + ((_e2462[1] - _e2456[1]) * _e2434));
                                                    let _e2474 = (_e2456[2] + ((_e2462[2] - _e2456[2]) * _e2434));
                                                    let _e2477 = local_20.member_1[0u];
                                                    let _e2483 = local_20.member_1[1u];
                                                    let _e2493 = (_e2477[0] + ((_e2483[0] - _e2477[0]) * _e2434));
                                                    let _e2494 = (_e2477[1] + ((_e2483[1] - _e2477[1]) * _e2434));
                                                    let _e2495 = (_e2477[2] + ((_e2483[2] - _e2477[2]) * _e2434));
                                                    let _e2498 = local_20.member_2[0u];
                                                    let _e2504 = local_20.member_2[1u];
                                                    let _e2514 = (_e2498[0] + ((_e2504[0] - _e2498[0]) * _e2434));
                                                    let _e2515 = (_e2498[1] + ((_e2504[1] - _e2498[1]) * _e2434));
                                                    let _e2516 = (_e2498[2] + ((_e2504[2] - _e2498[2]) * _e2434));
                                                    let _e2521 = (((_e2493 * _e2493) + (_e2494 * _e2494)) + (_e2495 * _e2495));
                                                    let _e2526 = (((_e2493 * _e2514) + (_e2494 * _e2515)) + (_e2495 * _e2516));
                                                    let _e2531 = (((_e2514 * _e2514) + (_e2515 * _e2515)) + (_e2516 * _e2516));
                                                    let _e2536 = (((_e2472 * _e2493) + (_e2473 * _e2494)) + (_e2474 * _e2495));
                                                    let _e2541 = (((_e2472 * _e2514) + (_e2473 * _e2515)) + (_e2474 * _e2516));
                                                    let _e2544 = ((_e2521 * _e2531) - (_e2526 * _e2526));
                                                    let _e2545 = f64(0f);
                                                    let _e2546 = f64(1f);
                                                    let _e2550 = (((_e2536 * _e2531) - (_e2541 * _e2526)) / _e2544);
                                                    let _e2554 = (((_e2541 * _e2521) - (_e2536 * _e2526)) / _e2544);
                                                    if (_e2550 >= _e2545) {
                                                        if (_e2554 >= _e2545) {
                                                            if (_e2550 <= _e2546) {
                                                                phi_6486_ = (_e2554 <= _e2546);
                                                                phi_6487_ = false;
                                                            } else {
                                                                phi_6486_ = bool();
                                                                phi_6487_ = true;
                                                            }
                                                            let _e2560 = phi_6486_;
                                                            let _e2562 = phi_6487_;
                                                            phi_6488_ = _e2560;
                                                            phi_6489_ = _e2562;
                                                        } else {
                                                            phi_6488_ = bool();
                                                            phi_6489_ = true;
                                                        }
                                                        let _e2564 = phi_6488_;
                                                        let _e2566 = phi_6489_;
                                                        phi_6490_ = _e2564;
                                                        phi_6491_ = _e2566;
                                                    } else {
                                                        phi_6490_ = bool();
                                                        phi_6491_ = true;
                                                    }
                                                    let _e2568 = phi_6490_;
                                                    let _e2570 = phi_6491_;
                                                    if _e2570 {
                                                        let _e2571 = (_e2544 > _e2545);
                                                        if _e2571 {
                                                            phi_6521_ = false;
                                                        } else {
                                                            phi_6521_ = true;
                                                        }
                                                        let _e2573 = phi_6521_;
                                                        phi_6522_ = false;
                                                        phi_6523_ = _e2573;
                                                        phi_6524_ = _e2571;
                                                    } else {
                                                        phi_6522_ = true;
                                                        phi_6523_ = false;
                                                        phi_6524_ = false;
                                                    }
                                                    let _e2575 = phi_6522_;
                                                    let _e2577 = phi_6523_;
                                                    let _e2579 = phi_6524_;
                                                    if _e2575 {
                                                        if (_e2544 > _e2545) {
                                                            if _e2568 {
                                                                phi_6548_ = array<f64, 3>((_e2472 - ((_e2493 * _e2550) + (_e2514 * _e2554))), (_e2473 - ((_e2494 * _e2550) + (_e2515 * _e2554))), (_e2474 - ((_e2495 * _e2550) + (_e2516 * _e2554))));
                                                                phi_6549_ = false;
                                                            } else {
                                                                phi_6548_ = array<f64, 3>();
                                                                phi_6549_ = true;
                                                            }
                                                            let _e2595 = phi_6548_;
                                                            let _e2597 = phi_6549_;
                                                            phi_6550_ = _e2595;
                                                            phi_6551_ = false;
                                                            phi_6552_ = _e2597;
                                                        } else {
                                                            phi_6550_ = array<f64, 3>();
                                                            phi_6551_ = true;
                                                            phi_6552_ = false;
                                                        }
                                                        let _e2599 = phi_6550_;
                                                        let _e2601 = phi_6551_;
                                                        let _e2603 = phi_6552_;
                                                        phi_6553_ = _e2599;
                                                        phi_6554_ = _e2601;
                                                        phi_6555_ = _e2603;
                                                    } else {
                                                        phi_6553_ = array<f64, 3>();
                                                        phi_6554_ = _e2577;
                                                        phi_6555_ = _e2579;
                                                    }
                                                    let _e2605 = phi_6553_;
                                                    let _e2607 = phi_6554_;
                                                    let _e2609 = phi_6555_;
                                                    if _e2607 {
                                                        phi_6559_ = true;
                                                    } else {
                                                        phi_6559_ = _e2609;
                                                    }
                                                    let _e2611 = phi_6559_;
                                                    if _e2611 {
                                                        let _e2612 = (_e2472 - _e2493);
                                                        let _e2613 = (_e2473 - _e2494);
                                                        let _e2614 = (_e2474 - _e2495);
                                                        let _e2625 = ((((_e2472 * _e2493) + (_e2473 * _e2494)) + (_e2474 * _e2495)) / (((_e2493 * _e2493) + (_e2494 * _e2494)) + (_e2495 * _e2495)));
                                                        if (_e2625 > f64(0f)) {
                                                            if (_e2625 < f64(1f)) {
                                                                phi_6592_ = _e2625;
                                                            } else {
                                                                phi_6592_ = f64(1f);
                                                            }
                                                            let _e2633 = phi_6592_;
                                                            phi_6594_ = _e2633;
                                                        } else {
                                                            phi_6594_ = f64(0f);
                                                        }
                                                        let _e2635 = phi_6594_;
                                                        let _e2652 = ((((_e2472 * _e2514) + (_e2473 * _e2515)) + (_e2474 * _e2516)) / (((_e2514 * _e2514) + (_e2515 * _e2515)) + (_e2516 * _e2516)));
                                                        if (_e2652 > f64(0f)) {
                                                            if (_e2652 < f64(1f)) {
                                                                phi_6624_ = _e2652;
                                                            } else {
                                                                phi_6624_ = f64(1f);
                                                            }
                                                            let _e2660 = phi_6624_;
                                                            phi_6626_ = _e2660;
                                                        } else {
                                                            phi_6626_ = f64(0f);
                                                        }
                                                        let _e2662 = phi_6626_;
                                                        let _e2679 = ((((_e2612 * _e2514) + (_e2613 * _e2515)) + (_e2614 * _e2516)) / (((_e2514 * _e2514) + (_e2515 * _e2515)) + (_e2516 * _e2516)));
                                                        if (_e2679 > f64(0f)) {
                                                            if (_e2679 < f64(1f)) {
                                                                phi_6656_ = _e2679;
                                                            } else {
                                                                phi_6656_ = f64(1f);
                                                            }
                                                            let _e2687 = phi_6656_;
                                                            phi_6658_ = _e2687;
                                                        } else {
                                                            phi_6658_ = f64(0f);
                                                        }
                                                        let _e2689 = phi_6658_;
                                                        let _e2696 = (_e2472 - _e2514);
                                                        let _e2697 = (_e2473 - _e2515);
                                                        let _e2698 = (_e2474 - _e2516);
                                                        let _e2709 = ((((_e2696 * _e2493) + (_e2697 * _e2494)) + (_e2698 * _e2495)) / (((_e2493 * _e2493) + (_e2494 * _e2494)) + (_e2495 * _e2495)));
                                                        if (_e2709 > f64(0f)) {
                                                            if (_e2709 < f64(1f)) {
                                                                phi_6691_ = _e2709;
                                                            } else {
                                                                phi_6691_ = f64(1f);
                                                            }
                                                            let _e2717 = phi_6691_;
                                                            phi_6693_ = _e2717;
                                                        } else {
                                                            phi_6693_ = f64(0f);
                                                        }
                                                        let _e2719 = phi_6693_;
                                                        local[0u] = array<f64, 3>((_e2472 - (_e2493 * _e2635)), (_e2473 - (_e2494 * _e2635)), (_e2474 - (_e2495 * _e2635)));
                                                        local[1u] = array<f64, 3>((_e2472 - (_e2514 * _e2662)), (_e2473 - (_e2515 * _e2662)), (_e2474 - (_e2516 * _e2662)));
                                                        local[2u] = array<f64, 3>((_e2612 - (_e2514 * _e2689)), (_e2613 - (_e2515 * _e2689)), (_e2614 - (_e2516 * _e2689)));
                                                        local[3u] = array<f64, 3>((_e2696 - (_e2493 * _e2719)), (_e2697 - (_e2494 * _e2719)), (_e2698 - (_e2495 * _e2719)));
                                                        let _e2735 = local[0u];
                                                        phi_6848_ = type_28(1u, 4u);
                                                        phi_6851_ = array<f64, 3>(_e2735[0], _e2735[1], _e2735[2]);
                                                        loop {
                                                            let _e2741 = phi_6848_;
                                                            let _e2743 = phi_6851_;
                                                            local_55 = _e2743;
                                                            if (_e2741.member < _e2741.member_1) {
                                                                phi_6849_ = type_28((_e2741.member + 1u), _e2741.member_1);
                                                                phi_6874_ = type_28(1u, _e2741.member);
                                                            } else {
                                                                phi_6849_ = _e2741;
                                                                phi_6874_ = type_28(0u, type_28().member_1);
                                                            }
                                                            let _e2757 = phi_6849_;
                                                            let _e2759 = phi_6874_;
                                                            let _e2763 = (bitcast<i32>(_e2759.member) != 0i);
                                                            if _e2763 {
                                                                if (_e2759.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2766 = local[_e2759.member_1];
                                                                if (_e2759.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2772 = local[_e2759.member_1];
                                                                if ((((_e2766[0] * _e2772[0]) + (_e2766[1] * _e2772[1])) + (_e2766[2] * _e2772[2])) < (((_e2743[0] * _e2743[0]) + (_e2743[1] * _e2743[1])) + (_e2743[2] * _e2743[2]))) {
                                                                    if (_e2759.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2795 = local[_e2759.member_1];
                                                                    phi_6941_ = array<f64, 3>(_e2795[0], _e2795[1], _e2795[2]);
                                                                } else {
                                                                    phi_6941_ = _e2743;
                                                                }
                                                                let _e2801 = phi_6941_;
                                                                phi_6852_ = _e2801;
                                                            } else {
                                                                phi_6852_ = array<f64, 3>();
                                                            }
                                                            let _e2803 = phi_6852_;
                                                            continue;
                                                            continuing {
                                                                phi_6848_ = _e2757;
                                                                phi_6851_ = _e2803;
                                                                break if !(_e2763);
                                                            }
                                                        }
                                                        let _e5383 = local_55;
                                                        phi_6942_ = _e5383;
                                                    } else {
                                                        phi_6942_ = _e2605;
                                                    }
                                                    let _e2806 = phi_6942_;
                                                    if (_e2806[0] < 0.0lf) {
                                                        phi_6949_ = -(_e2806[0]);
                                                    } else {
                                                        phi_6949_ = _e2806[0];
                                                    }
                                                    let _e2811 = phi_6949_;
                                                    if (_e2806[1] < 0.0lf) {
                                                        phi_6956_ = -(_e2806[1]);
                                                    } else {
                                                        phi_6956_ = _e2806[1];
                                                    }
                                                    let _e2816 = phi_6956_;
                                                    if (_e2806[2] < 0.0lf) {
                                                        phi_6964_ = -(_e2806[2]);
                                                    } else {
                                                        phi_6964_ = _e2806[2];
                                                    }
                                                    let _e2822 = phi_6964_;
                                                    let _e2823 = ((_e2811 + _e2816) + _e2822);
                                                    if (_e2823 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2823) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2829 = (f64(1f) / _e2823);
                                                            let _e2831 = (_e2806[0] * _e2829);
                                                            let _e2833 = (_e2806[1] * _e2829);
                                                            let _e2835 = (_e2806[2] * _e2829);
                                                            let _e2840 = (((_e2831 * _e2831) + (_e2833 * _e2833)) + (_e2835 * _e2835));
                                                            if (_e2840 <= 2.2250738585072014e-308lf) {
                                                                if (_e2840 > 0.0lf) {
                                                                    phi_7002_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_7002_ = 0.0lf;
                                                                }
                                                                let _e2898 = phi_7002_;
                                                                phi_7066_ = _e2898;
                                                            } else {
                                                                phi_7009_ = type_26(0i, 5i);
                                                                phi_7012_ = bitcast<f64>(((bitcast<u64>(_e2840) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2847 = phi_7009_;
                                                                    let _e2849 = phi_7012_;
                                                                    local_26 = _e2849;
                                                                    if (_e2847.member < _e2847.member_1) {
                                                                        let _e2857 = (_e2847.member + 1i);
                                                                        if ((false == (_e2857 > _e2847.member)) != false) {
                                                                            phi_7033_ = true;
                                                                        } else {
                                                                            phi_7033_ = false;
                                                                        }
                                                                        let _e2862 = phi_7033_;
                                                                        if _e2862 {
                                                                            phi_7039_ = type_27(0u, type_27().member_1);
                                                                        } else {
                                                                            phi_7039_ = type_27(1u, _e2857);
                                                                        }
                                                                        let _e2868 = phi_7039_;
                                                                        if (bitcast<i32>(_e2868.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_7010_ = type_26(_e2868.member_1, _e2847.member_1);
                                                                        phi_7053_ = type_27(1u, _e2847.member);
                                                                    } else {
                                                                        phi_7010_ = _e2847;
                                                                        phi_7053_ = type_27(0u, type_27().member_1);
                                                                    }
                                                                    let _e2878 = phi_7010_;
                                                                    let _e2880 = phi_7053_;
                                                                    let _e2883 = (bitcast<i32>(_e2880.member) != 0i);
                                                                    if _e2883 {
                                                                        phi_7013_ = (0.5lf * (_e2849 + (_e2840 / _e2849)));
                                                                    } else {
                                                                        phi_7013_ = f64();
                                                                    }
                                                                    let _e2888 = phi_7013_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7009_ = _e2878;
                                                                        phi_7012_ = _e2888;
                                                                        break if !(_e2883);
                                                                    }
                                                                }
                                                                let _e2893 = local_26;
                                                                phi_7066_ = (_e2893 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2900 = phi_7066_;
                                                            phi_7079_ = type_28(0u, 4u);
                                                            phi_7082_ = f64(2f);
                                                            loop {
                                                                let _e2912 = phi_7079_;
                                                                let _e2914 = phi_7082_;
                                                                local_28 = _e2914;
                                                                local_29 = _e2914;
                                                                local_30 = _e2914;
                                                                local_56 = _e2914;
                                                                local_57 = _e2914;
                                                                if (_e2912.member < _e2912.member_1) {
                                                                    phi_7080_ = type_28((_e2912.member + 1u), _e2912.member_1);
                                                                    phi_7105_ = type_28(1u, _e2912.member);
                                                                } else {
                                                                    phi_7080_ = _e2912;
                                                                    phi_7105_ = type_28(0u, type_28().member_1);
                                                                }
                                                                let _e2928 = phi_7080_;
                                                                let _e2930 = phi_7105_;
                                                                if (bitcast<i32>(_e2930.member) != 0i) {
                                                                    if (_e2930.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2937 = local_1[_e2930.member_1];
                                                                    let _e2945 = (((_e2831 * _e2937[0]) + (_e2833 * _e2937[1])) + (_e2835 * _e2937[2]));
                                                                    if (_e2930.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2948 = local_2[_e2930.member_1];
                                                                    let _e2956 = (((_e2831 * _e2948[0]) + (_e2833 * _e2948[1])) + (_e2835 * _e2948[2]));
                                                                    if (_e2945 < 0.0lf) {
                                                                        phi_7156_ = -(_e2945);
                                                                    } else {
                                                                        phi_7156_ = _e2945;
                                                                    }
                                                                    let _e2960 = phi_7156_;
                                                                    if (_e2956 < 0.0lf) {
                                                                        phi_7162_ = -(_e2956);
                                                                    } else {
                                                                        phi_7162_ = _e2956;
                                                                    }
                                                                    let _e2964 = phi_7162_;
                                                                    let _e2969 = (((((((((_e2305 + _e2307) + (_e2359 + _e2361)) + (_e2413 + _e2415)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2423 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2900) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2960 + _e2964) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2945 > _e2969) {
                                                                        if (_e2956 > _e2969) {
                                                                            phi_7176_ = false;
                                                                        } else {
                                                                            phi_7176_ = true;
                                                                        }
                                                                        let _e2973 = phi_7176_;
                                                                        phi_7177_ = _e2973;
                                                                    } else {
                                                                        phi_7177_ = true;
                                                                    }
                                                                    let _e2975 = phi_7177_;
                                                                    if _e2975 {
                                                                        let _e2979 = ((_e2945 + ((_e2956 - _e2945) * _e2434)) > _e2969);
                                                                        if _e2979 {
                                                                            if (_e2956 < _e2945) {
                                                                                let _e2988 = (((_e2945 - _e2969) / (_e2945 - _e2956)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                if (_e2914 < _e2988) {
                                                                                    phi_7204_ = _e2914;
                                                                                } else {
                                                                                    phi_7204_ = _e2988;
                                                                                }
                                                                                let _e2991 = phi_7204_;
                                                                                phi_7205_ = _e2991;
                                                                            } else {
                                                                                phi_7205_ = _e2914;
                                                                            }
                                                                            let _e2993 = phi_7205_;
                                                                            phi_7206_ = _e2993;
                                                                        } else {
                                                                            phi_7206_ = f64();
                                                                        }
                                                                        let _e2995 = phi_7206_;
                                                                        phi_7207_ = _e2995;
                                                                        phi_7208_ = _e2979;
                                                                    } else {
                                                                        phi_7207_ = _e2914;
                                                                        phi_7208_ = true;
                                                                    }
                                                                    let _e2997 = phi_7207_;
                                                                    let _e2999 = phi_7208_;
                                                                    phi_7083_ = _e2997;
                                                                    phi_7209_ = _e2999;
                                                                    phi_7210_ = false;
                                                                } else {
                                                                    phi_7083_ = f64();
                                                                    phi_7209_ = false;
                                                                    phi_7210_ = true;
                                                                }
                                                                let _e3001 = phi_7083_;
                                                                let _e3003 = phi_7209_;
                                                                let _e3005 = phi_7210_;
                                                                local_27 = _e3005;
                                                                continue;
                                                                continuing {
                                                                    phi_7079_ = _e2928;
                                                                    phi_7082_ = _e3001;
                                                                    break if !(_e3003);
                                                                }
                                                            }
                                                            let _e3008 = local_27;
                                                            if _e3008 {
                                                                let _e3010 = local_28;
                                                                let _e3011 = (_e3010 > _e1434.member_1);
                                                                if _e3011 {
                                                                    phi_7232_ = false;
                                                                    phi_7233_ = false;
                                                                    phi_7234_ = false;
                                                                } else {
                                                                    let _e3013 = local_29;
                                                                    if (_e3013 > _e2434) {
                                                                        let _e3016 = local_30;
                                                                        let _e3019 = ((_e3016 - _e2434) < f64(0.00000000023283064f));
                                                                        if _e3019 {
                                                                            phi_7228_ = false;
                                                                        } else {
                                                                            phi_7228_ = true;
                                                                        }
                                                                        let _e3021 = phi_7228_;
                                                                        phi_7229_ = _e3021;
                                                                        phi_7230_ = _e3019;
                                                                        phi_7231_ = false;
                                                                    } else {
                                                                        phi_7229_ = false;
                                                                        phi_7230_ = false;
                                                                        phi_7231_ = true;
                                                                    }
                                                                    let _e3023 = phi_7229_;
                                                                    let _e3025 = phi_7230_;
                                                                    let _e3027 = phi_7231_;
                                                                    phi_7232_ = _e3023;
                                                                    phi_7233_ = _e3025;
                                                                    phi_7234_ = _e3027;
                                                                }
                                                                let _e3029 = phi_7232_;
                                                                let _e3031 = phi_7233_;
                                                                let _e3033 = phi_7234_;
                                                                phi_7235_ = _e3029;
                                                                phi_7236_ = _e3011;
                                                                phi_7237_ = _e3031;
                                                                phi_7238_ = _e3033;
                                                                phi_7239_ = false;
                                                            } else {
                                                                phi_7235_ = false;
                                                                phi_7236_ = false;
                                                                phi_7237_ = false;
                                                                phi_7238_ = false;
                                                                phi_7239_ = true;
                                                            }
                                                            let _e3035 = phi_7235_;
                                                            let _e3037 = phi_7236_;
                                                            let _e3039 = phi_7237_;
                                                            let _e3041 = phi_7238_;
                                                            let _e3043 = phi_7239_;
                                                            let _e5431 = local_56;
                                                            phi_7240_ = _e5431;
                                                            let _e5434 = local_57;
                                                            phi_7241_ = _e5434;
                                                            phi_7242_ = _e3035;
                                                            phi_7243_ = _e3037;
                                                            phi_7244_ = _e3039;
                                                            phi_7245_ = _e3041;
                                                            phi_7246_ = _e3043;
                                                            phi_7247_ = false;
                                                        } else {
                                                            phi_7240_ = f64();
                                                            phi_7241_ = f64();
                                                            phi_7242_ = false;
                                                            phi_7243_ = false;
                                                            phi_7244_ = false;
                                                            phi_7245_ = false;
                                                            phi_7246_ = false;
                                                            phi_7247_ = true;
                                                        }
                                                        let _e3045 = phi_7240_;
                                                        let _e3047 = phi_7241_;
                                                        let _e3049 = phi_7242_;
                                                        let _e3051 = phi_7243_;
                                                        let _e3053 = phi_7244_;
                                                        let _e3055 = phi_7245_;
                                                        let _e3057 = phi_7246_;
                                                        let _e3059 = phi_7247_;
                                                        phi_7248_ = _e3045;
                                                        phi_7249_ = _e3047;
                                                        phi_7250_ = _e3049;
                                                        phi_7251_ = _e3051;
                                                        phi_7252_ = _e3053;
                                                        phi_7253_ = _e3055;
                                                        phi_7254_ = _e3057;
                                                        phi_7255_ = _e3059;
                                                        phi_7256_ = false;
                                                    } else {
                                                        phi_7248_ = f64();
                                                        phi_7249_ = f64();
                                                        phi_7250_ = false;
                                                        phi_7251_ = false;
                                                        phi_7252_ = false;
                                                        phi_7253_ = false;
                                                        phi_7254_ = false;
                                                        phi_7255_ = false;
                                                        phi_7256_ = true;
                                                    }
                                                    let _e3061 = phi_7248_;
                                                    let _e3063 = phi_7249_;
                                                    let _e3065 = phi_7250_;
                                                    let _e3067 = phi_7251_;
                                                    let _e3069 = phi_7252_;
                                                    let _e3071 = phi_7253_;
                                                    let _e3073 = phi_7254_;
                                                    let _e3075 = phi_7255_;
                                                    let _e3077 = phi_7256_;
                                                    phi_7257_ = _e3061;
                                                    phi_6308_ = _e3063;
                                                    phi_7258_ = _e3065;
                                                    phi_7259_ = _e3067;
                                                    phi_7260_ = _e3069;
                                                    phi_7261_ = false;
                                                    phi_7262_ = _e3071;
                                                    phi_7263_ = _e3073;
                                                    phi_7264_ = _e3075;
                                                    phi_7265_ = _e3077;
                                                } else {
                                                    phi_7257_ = f64();
                                                    phi_6308_ = f64();
                                                    phi_7258_ = false;
                                                    phi_7259_ = false;
                                                    phi_7260_ = false;
                                                    phi_7261_ = true;
                                                    phi_7262_ = false;
                                                    phi_7263_ = false;
                                                    phi_7264_ = false;
                                                    phi_7265_ = false;
                                                }
                                                let _e3079 = phi_7257_;
                                                let _e3081 = phi_6308_;
                                                let _e3083 = phi_7258_;
                                                let _e3085 = phi_7259_;
                                                let _e3087 = phi_7260_;
                                                let _e3089 = phi_7261_;
                                                let _e3091 = phi_7262_;
                                                let _e3093 = phi_7263_;
                                                let _e3095 = phi_7264_;
                                                let _e3097 = phi_7265_;
                                                local_31 = _e3085;
                                                local_58 = _e3087;
                                                local_59 = _e3089;
                                                local_60 = _e3091;
                                                local_61 = _e3093;
                                                local_62 = _e3095;
                                                local_63 = _e3097;
                                                local_64 = _e3079;
                                                local_66 = _e3085;
                                                continue;
                                                continuing {
                                                    phi_6304_ = _e2448;
                                                    phi_6307_ = _e3081;
                                                    break if !(_e3083);
                                                }
                                            }
                                            let _e3100 = local_31;
                                            if _e3100 {
                                                phi_7270_ = type_71(0u, type_71().member_1);
                                                phi_7271_ = false;
                                                phi_7272_ = false;
                                                phi_7273_ = false;
                                                phi_7274_ = false;
                                                phi_7275_ = false;
                                                phi_7276_ = false;
                                            } else {
                                                phi_7270_ = type_71();
                                                let _e5464 = local_58;
                                                phi_7271_ = _e5464;
                                                let _e5467 = local_59;
                                                phi_7272_ = _e5467;
                                                let _e5470 = local_60;
                                                phi_7273_ = _e5470;
                                                let _e5473 = local_61;
                                                phi_7274_ = _e5473;
                                                let _e5476 = local_62;
                                                phi_7275_ = _e5476;
                                                let _e5479 = local_63;
                                                phi_7276_ = _e5479;
                                            }
                                            let _e3105 = phi_7270_;
                                            let _e3107 = phi_7271_;
                                            let _e3109 = phi_7272_;
                                            let _e3111 = phi_7273_;
                                            let _e3113 = phi_7274_;
                                            let _e3115 = phi_7275_;
                                            let _e3117 = phi_7276_;
                                            if _e3107 {
                                                let _e5482 = local_64;
                                                phi_7280_ = _e5482;
                                                phi_7281_ = true;
                                                phi_7282_ = false;
                                                phi_7283_ = false;
                                                phi_7284_ = false;
                                                phi_7285_ = false;
                                                phi_7286_ = false;
                                            } else {
                                                let _e5484 = local_65;
                                                phi_7280_ = _e5484;
                                                phi_7281_ = _e3109;
                                                phi_7282_ = _e3111;
                                                phi_7283_ = _e3113;
                                                let _e5490 = local_66;
                                                phi_7284_ = _e5490;
                                                phi_7285_ = _e3115;
                                                phi_7286_ = _e3117;
                                            }
                                            let _e3119 = phi_7280_;
                                            let _e3121 = phi_7281_;
                                            let _e3123 = phi_7282_;
                                            let _e3125 = phi_7283_;
                                            let _e3127 = phi_7284_;
                                            let _e3129 = phi_7285_;
                                            let _e3131 = phi_7286_;
                                            if _e3121 {
                                                phi_7291_ = type_71(1u, _e3119);
                                                phi_7292_ = false;
                                                phi_7293_ = false;
                                                phi_7294_ = false;
                                                phi_7295_ = false;
                                                phi_7296_ = false;
                                            } else {
                                                phi_7291_ = type_71();
                                                phi_7292_ = _e3123;
                                                phi_7293_ = _e3125;
                                                phi_7294_ = _e3127;
                                                phi_7295_ = _e3129;
                                                phi_7296_ = _e3131;
                                            }
                                            let _e3134 = phi_7291_;
                                            let _e3136 = phi_7292_;
                                            let _e3138 = phi_7293_;
                                            let _e3140 = phi_7294_;
                                            let _e3142 = phi_7295_;
                                            let _e3144 = phi_7296_;
                                            if _e3136 {
                                                let _e3146 = local_32;
                                                phi_7301_ = type_71(1u, _e3146);
                                                phi_7302_ = false;
                                                phi_7303_ = true;
                                                phi_7304_ = false;
                                                phi_7305_ = false;
                                            } else {
                                                phi_7301_ = _e3105;
                                                phi_7302_ = _e3138;
                                                phi_7303_ = _e3140;
                                                phi_7304_ = _e3142;
                                                phi_7305_ = _e3144;
                                            }
                                            let _e3149 = phi_7301_;
                                            let _e3151 = phi_7302_;
                                            let _e3153 = phi_7303_;
                                            let _e3155 = phi_7304_;
                                            let _e3157 = phi_7305_;
                                            if _e3151 {
                                                let _e3159 = local_33;
                                                phi_7310_ = type_71(1u, _e3159);
                                                phi_7311_ = true;
                                                phi_7312_ = false;
                                                phi_7313_ = false;
                                            } else {
                                                phi_7310_ = _e3149;
                                                phi_7311_ = _e3153;
                                                phi_7312_ = _e3155;
                                                phi_7313_ = _e3157;
                                            }
                                            let _e3162 = phi_7310_;
                                            let _e3164 = phi_7311_;
                                            let _e3166 = phi_7312_;
                                            let _e3168 = phi_7313_;
                                            if _e3164 {
                                                phi_7317_ = false;
                                                phi_7318_ = false;
                                            } else {
                                                phi_7317_ = _e3166;
                                                phi_7318_ = _e3168;
                                            }
                                            let _e3170 = phi_7317_;
                                            let _e3172 = phi_7318_;
                                            if _e3170 {
                                                phi_7322_ = false;
                                                phi_7323_ = false;
                                            } else {
                                                phi_7322_ = _e3172;
                                                phi_7323_ = _e3164;
                                            }
                                            let _e3174 = phi_7322_;
                                            let _e3176 = phi_7323_;
                                            if _e3174 {
                                                phi_7327_ = true;
                                                phi_7328_ = false;
                                            } else {
                                                phi_7327_ = _e3170;
                                                phi_7328_ = _e3176;
                                            }
                                            let _e3178 = phi_7327_;
                                            let _e3180 = phi_7328_;
                                            if _e3178 {
                                                let _e3182 = local_34;
                                                phi_7333_ = type_71(1u, _e3182);
                                                phi_7334_ = true;
                                            } else {
                                                phi_7333_ = _e3162;
                                                phi_7334_ = _e3180;
                                            }
                                            let _e3185 = phi_7333_;
                                            let _e3187 = phi_7334_;
                                            if _e3187 {
                                                phi_7338_ = _e3185;
                                            } else {
                                                phi_7338_ = _e3134;
                                            }
                                            let _e3189 = phi_7338_;
                                            let _e3192 = (_e3189.member != 0u);
                                            if _e3192 {
                                                phi_7345_ = false;
                                            } else {
                                                phi_7345_ = true;
                                            }
                                            let _e3194 = phi_7345_;
                                            phi_7346_ = _e3189.member_1;
                                            phi_7347_ = _e3194;
                                            phi_7348_ = _e3192;
                                            phi_7349_ = false;
                                        } else {
                                            phi_7346_ = f64();
                                            phi_7347_ = false;
                                            phi_7348_ = false;
                                            phi_7349_ = true;
                                        }
                                        let _e3196 = phi_7346_;
                                        let _e3198 = phi_7347_;
                                        let _e3200 = phi_7348_;
                                        let _e3202 = phi_7349_;
                                        phi_7350_ = _e3196;
                                        phi_7351_ = _e3198;
                                        phi_7352_ = _e3200;
                                        phi_7353_ = _e3202;
                                    }
                                    let _e3204 = phi_7350_;
                                    let _e3206 = phi_7351_;
                                    let _e3208 = phi_7352_;
                                    let _e3210 = phi_7353_;
                                    phi_7354_ = _e3204;
                                    phi_7355_ = _e2176;
                                    phi_7356_ = _e3206;
                                    phi_7357_ = _e3208;
                                    phi_7358_ = _e3210;
                                }
                                let _e3212 = phi_7354_;
                                let _e3214 = phi_7355_;
                                let _e3216 = phi_7356_;
                                let _e3218 = phi_7357_;
                                let _e3220 = phi_7358_;
                                if _e3214 {
                                    phi_7362_ = true;
                                    phi_7363_ = false;
                                    phi_7364_ = false;
                                } else {
                                    phi_7362_ = _e3216;
                                    phi_7363_ = _e3218;
                                    phi_7364_ = _e3220;
                                }
                                let _e3222 = phi_7362_;
                                let _e3224 = phi_7363_;
                                let _e3226 = phi_7364_;
                                phi_7365_ = _e3212;
                                phi_7366_ = _e1434;
                                phi_7367_ = _e3222;
                                phi_7368_ = false;
                                phi_7369_ = _e3224;
                                phi_7370_ = _e3226;
                            } else {
                                phi_7365_ = f64();
                                phi_7366_ = type_72();
                                phi_7367_ = false;
                                phi_7368_ = true;
                                phi_7369_ = false;
                                phi_7370_ = false;
                            }
                            let _e3228 = phi_7365_;
                            let _e3230 = phi_7366_;
                            let _e3232 = phi_7367_;
                            let _e3234 = phi_7368_;
                            let _e3236 = phi_7369_;
                            let _e3238 = phi_7370_;
                            local_35 = _e3234;
                            local_67 = _e3236;
                            local_68 = _e3238;
                            local_36 = _e3228;
                            local_37 = _e3230;
                            continue;
                            continuing {
                                phi_4327_ = _e1101;
                                break if !(_e3232);
                            }
                        }
                        let _e3241 = local_35;
                        if _e3241 {
                            phi_7375_ = type_71(0u, type_71().member_1);
                            phi_7376_ = false;
                            phi_7377_ = false;
                        } else {
                            phi_7375_ = type_71();
                            let _e5547 = local_67;
                            phi_7376_ = _e5547;
                            let _e5550 = local_68;
                            phi_7377_ = _e5550;
                        }
                        let _e3246 = phi_7375_;
                        let _e3248 = phi_7376_;
                        let _e3250 = phi_7377_;
                        if _e3248 {
                            let _e3252 = local_36;
                            phi_7382_ = type_71(2u, _e3252);
                            phi_7383_ = false;
                        } else {
                            phi_7382_ = type_71();
                            phi_7383_ = _e3250;
                        }
                        let _e3255 = phi_7382_;
                        let _e3257 = phi_7383_;
                        if _e3257 {
                            let _e3259 = local_37;
                            phi_7389_ = type_71(1u, _e3259.member);
                            phi_7390_ = true;
                        } else {
                            phi_7389_ = _e3255;
                            phi_7390_ = _e3248;
                        }
                        let _e3263 = phi_7389_;
                        let _e3265 = phi_7390_;
                        if _e3265 {
                            phi_7394_ = _e3263;
                        } else {
                            phi_7394_ = _e3246;
                        }
                        let _e3267 = phi_7394_;
                        phi_7398_ = _e3267;
                    }
                    let _e4944 = phi_7398_;
                    phi_7399_ = _e4944;
                }
                let _e4949 = phi_7399_;
                switch bitcast<i32>(_e4949.member) {
                    case 0: {
                        phi_7420_ = type_45(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4959 = bitcast<u64>(_e4949.member_1);
                        phi_7420_ = type_45(0u, array<u32, 2>(u32(_e4959), u32((_e4959 / 4294967296lu))), true);
                        break;
                    }
                    case 2: {
                        let _e4953 = bitcast<u64>(_e4949.member_1);
                        phi_7420_ = type_45(1u, array<u32, 2>(u32(_e4953), u32((_e4953 / 4294967296lu))), true);
                        break;
                    }
                    default: {
                        phi_7420_ = type_45();
                        break;
                    }
                }
                let _e4966 = phi_7420_;
                if _e4966.member_2 {
                    let _e4972 = (_e4966.member_1[1] >> bitcast<u32>(20i));
                    if (_e4972 <= 896u) {
                        phi_7443_ = 0u;
                    } else {
                        phi_7443_ = ((((_e4972 - 896u) << bitcast<u32>(23i)) | ((_e4966.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4966.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4987 = phi_7443_;
                    let _e4989 = atomicMin((&earliest.member[0u]), _e4987);
                }
                let _e4991 = params.member.member_1;
                if ((_e4991 & 16u) != 0u) {
                    if (_e115 == 0u) {
                        atomicStore((&counters[0u]), 0u);
                    }
                    workgroupBarrier();
                    if _e4966.member_2 {
                        let _e4997 = atomicAdd((&counters[0u]), 1u);
                        phi_7464_ = _e4997;
                    } else {
                        phi_7464_ = 0u;
                    }
                    let _e4999 = phi_7464_;
                    workgroupBarrier();
                    if (_e115 == 0u) {
                        let _e5002 = atomicLoad((&counters[0u]));
                        if (_e5002 > 0u) {
                            let _e5005 = atomicAdd((&contacts.member[0u]), _e5002);
                            atomicStore((&counters[1u]), _e5005);
                        }
                    }
                    workgroupBarrier();
                    let _e5008 = atomicLoad((&counters[1u]));
                    let _e5009 = (_e5008 + _e4999);
                    if _e4966.member_2 {
                        let _e5011 = params.member.member_16;
                        if (_e5009 < _e5011) {
                            let _e5013 = (6u * _e5009);
                            atomicStore((&contacts.member[(4u + _e5013)]), _e184);
                            atomicStore((&contacts.member[(_e5013 + 5u)]), _e4966.member);
                            atomicStore((&contacts.member[(_e5013 + 6u)]), _e202);
                            atomicStore((&contacts.member[(_e5013 + 7u)]), _e205);
                            atomicStore((&contacts.member[(_e5013 + 8u)]), _e4966.member_1[0]);
                            atomicStore((&contacts.member[(_e5013 + 9u)]), _e4966.member_1[1]);
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
            phi_269_ = _e172;
            break if !(_e178);
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
