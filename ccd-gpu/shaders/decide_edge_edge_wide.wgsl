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
                let _e457 = bitcast<f64>(((u64(_e449[1]) << bitcast<u64>(32lu)) | u64(_e449[0])));
                let _e458 = f64(0f);
                let _e461 = local_20.member_1[0u];
                let _e467 = local_20.member_2[0u];
                let _e473 = ((_e461[1] * _e467[2]) - (_e461[2] * _e467[1]));
                let _e476 = ((_e461[2] * _e467[0]) - (_e461[0] * _e467[2]));
                let _e479 = ((_e461[0] * _e467[1]) - (_e461[1] * _e467[0]));
                let _e482 = local_20.member_1[1u];
                let _e488 = local_20.member_2[1u];
                let _e494 = ((_e482[1] * _e488[2]) - (_e482[2] * _e488[1]));
                let _e497 = ((_e482[2] * _e488[0]) - (_e482[0] * _e488[2]));
                let _e500 = ((_e482[0] * _e488[1]) - (_e482[1] * _e488[0]));
                let _e503 = local_20.member_1[0u];
                let _e509 = local_20.member_2[1u];
                let _e524 = local_20.member_1[1u];
                let _e530 = local_20.member_2[0u];
                let _e543 = (((_e503[1] * _e509[2]) - (_e503[2] * _e509[1])) + ((_e524[1] * _e530[2]) - (_e524[2] * _e530[1])));
                let _e544 = (((_e503[2] * _e509[0]) - (_e503[0] * _e509[2])) + ((_e524[2] * _e530[0]) - (_e524[0] * _e530[2])));
                let _e545 = (((_e503[0] * _e509[1]) - (_e503[1] * _e509[0])) + ((_e524[0] * _e530[1]) - (_e524[1] * _e530[0])));
                let _e548 = local_20.member[0u];
                let _e556 = (((_e548[0] * _e473) + (_e548[1] * _e476)) + (_e548[2] * _e479));
                let _e559 = local_20.member[1u];
                let _e570 = local_20.member[0u];
                let _e579 = ((((_e559[0] * _e473) + (_e559[1] * _e476)) + (_e559[2] * _e479)) + (((_e570[0] * _e543) + (_e570[1] * _e544)) + (_e570[2] * _e545)));
                let _e582 = local_20.member[0u];
                let _e593 = local_20.member[1u];
                let _e602 = ((((_e582[0] * _e494) + (_e582[1] * _e497)) + (_e582[2] * _e500)) + (((_e593[0] * _e543) + (_e593[1] * _e544)) + (_e593[2] * _e545)));
                let _e605 = local_20.member[1u];
                let _e613 = (((_e605[0] * _e494) + (_e605[1] * _e497)) + (_e605[2] * _e500));
                let _e616 = local_20.member[0u];
                if (_e616[0] < 0.0lf) {
                    phi_1116_ = -(_e616[0]);
                } else {
                    phi_1116_ = _e616[0];
                }
                let _e623 = phi_1116_;
                if (_e616[1] < 0.0lf) {
                    phi_1123_ = -(_e616[1]);
                } else {
                    phi_1123_ = _e616[1];
                }
                let _e627 = phi_1123_;
                if (_e623 > _e627) {
                    phi_1128_ = _e623;
                } else {
                    phi_1128_ = _e627;
                }
                let _e630 = phi_1128_;
                if (_e616[2] < 0.0lf) {
                    phi_1135_ = -(_e616[2]);
                } else {
                    phi_1135_ = _e616[2];
                }
                let _e634 = phi_1135_;
                if (_e630 > _e634) {
                    phi_1140_ = _e630;
                } else {
                    phi_1140_ = _e634;
                }
                let _e637 = phi_1140_;
                let _e640 = local_20.member[1u];
                if (_e640[0] < 0.0lf) {
                    phi_1153_ = -(_e640[0]);
                } else {
                    phi_1153_ = _e640[0];
                }
                let _e647 = phi_1153_;
                if (_e640[1] < 0.0lf) {
                    phi_1160_ = -(_e640[1]);
                } else {
                    phi_1160_ = _e640[1];
                }
                let _e651 = phi_1160_;
                if (_e647 > _e651) {
                    phi_1165_ = _e647;
                } else {
                    phi_1165_ = _e651;
                }
                let _e654 = phi_1165_;
                if (_e640[2] < 0.0lf) {
                    phi_1172_ = -(_e640[2]);
                } else {
                    phi_1172_ = _e640[2];
                }
                let _e658 = phi_1172_;
                if (_e654 > _e658) {
                    phi_1177_ = _e654;
                } else {
                    phi_1177_ = _e658;
                }
                let _e661 = phi_1177_;
                if (_e637 > _e661) {
                    phi_1182_ = _e637;
                } else {
                    phi_1182_ = _e661;
                }
                let _e664 = phi_1182_;
                let _e666 = local_20.member_3;
                let _e667 = (_e664 + _e666);
                let _e670 = local_20.member_1[0u];
                if (_e670[0] < 0.0lf) {
                    phi_1199_ = -(_e670[0]);
                } else {
                    phi_1199_ = _e670[0];
                }
                let _e677 = phi_1199_;
                if (_e670[1] < 0.0lf) {
                    phi_1206_ = -(_e670[1]);
                } else {
                    phi_1206_ = _e670[1];
                }
                let _e681 = phi_1206_;
                if (_e677 > _e681) {
                    phi_1211_ = _e677;
                } else {
                    phi_1211_ = _e681;
                }
                let _e684 = phi_1211_;
                if (_e670[2] < 0.0lf) {
                    phi_1218_ = -(_e670[2]);
                } else {
                    phi_1218_ = _e670[2];
                }
                let _e688 = phi_1218_;
                if (_e684 > _e688) {
                    phi_1223_ = _e684;
                } else {
                    phi_1223_ = _e688;
                }
                let _e691 = phi_1223_;
                let _e694 = local_20.member_1[1u];
                if (_e694[0] < 0.0lf) {
                    phi_1237_ = -(_e694[0]);
                } else {
                    phi_1237_ = _e694[0];
                }
                let _e701 = phi_1237_;
                if (_e694[1] < 0.0lf) {
                    phi_1244_ = -(_e694[1]);
                } else {
                    phi_1244_ = _e694[1];
                }
                let _e705 = phi_1244_;
                if (_e701 > _e705) {
                    phi_1249_ = _e701;
                } else {
                    phi_1249_ = _e705;
                }
                let _e708 = phi_1249_;
                if (_e694[2] < 0.0lf) {
                    phi_1256_ = -(_e694[2]);
                } else {
                    phi_1256_ = _e694[2];
                }
                let _e712 = phi_1256_;
                if (_e708 > _e712) {
                    phi_1261_ = _e708;
                } else {
                    phi_1261_ = _e712;
                }
                let _e715 = phi_1261_;
                if (_e691 > _e715) {
                    phi_1266_ = _e691;
                } else {
                    phi_1266_ = _e715;
                }
                let _e718 = phi_1266_;
                let _e720 = local_20.member_3;
                let _e721 = (_e718 + _e720);
                let _e724 = local_20.member_2[0u];
                if (_e724[0] < 0.0lf) {
                    phi_1283_ = -(_e724[0]);
                } else {
                    phi_1283_ = _e724[0];
                }
                let _e731 = phi_1283_;
                if (_e724[1] < 0.0lf) {
                    phi_1290_ = -(_e724[1]);
                } else {
                    phi_1290_ = _e724[1];
                }
                let _e735 = phi_1290_;
                if (_e731 > _e735) {
                    phi_1295_ = _e731;
                } else {
                    phi_1295_ = _e735;
                }
                let _e738 = phi_1295_;
                if (_e724[2] < 0.0lf) {
                    phi_1302_ = -(_e724[2]);
                } else {
                    phi_1302_ = _e724[2];
                }
                let _e742 = phi_1302_;
                if (_e738 > _e742) {
                    phi_1307_ = _e738;
                } else {
                    phi_1307_ = _e742;
                }
                let _e745 = phi_1307_;
                let _e748 = local_20.member_2[1u];
                if (_e748[0] < 0.0lf) {
                    phi_1321_ = -(_e748[0]);
                } else {
                    phi_1321_ = _e748[0];
                }
                let _e755 = phi_1321_;
                if (_e748[1] < 0.0lf) {
                    phi_1328_ = -(_e748[1]);
                } else {
                    phi_1328_ = _e748[1];
                }
                let _e759 = phi_1328_;
                if (_e755 > _e759) {
                    phi_1333_ = _e755;
                } else {
                    phi_1333_ = _e759;
                }
                let _e762 = phi_1333_;
                if (_e748[2] < 0.0lf) {
                    phi_1340_ = -(_e748[2]);
                } else {
                    phi_1340_ = _e748[2];
                }
                let _e766 = phi_1340_;
                if (_e762 > _e766) {
                    phi_1345_ = _e762;
                } else {
                    phi_1345_ = _e766;
                }
                let _e769 = phi_1345_;
                if (_e745 > _e769) {
                    phi_1350_ = _e745;
                } else {
                    phi_1350_ = _e769;
                }
                let _e772 = phi_1350_;
                let _e774 = local_20.member_3;
                let _e775 = (_e772 + _e774);
                let _e776 = f64(1f);
                let _e777 = f64(8f);
                let _e779 = ((_e721 * _e777) * _e775);
                let _e787 = local_20.member_3;
                if (_e473 < 0.0lf) {
                    phi_1387_ = -(_e473);
                } else {
                    phi_1387_ = _e473;
                }
                let _e807 = phi_1387_;
                if (_e476 < 0.0lf) {
                    phi_1393_ = -(_e476);
                } else {
                    phi_1393_ = _e476;
                }
                let _e811 = phi_1393_;
                if (_e479 < 0.0lf) {
                    phi_1400_ = -(_e479);
                } else {
                    phi_1400_ = _e479;
                }
                let _e816 = phi_1400_;
                let _e817 = ((_e807 + _e811) + _e816);
                if (_e494 < 0.0lf) {
                    phi_1407_ = -(_e494);
                } else {
                    phi_1407_ = _e494;
                }
                let _e821 = phi_1407_;
                if (_e497 < 0.0lf) {
                    phi_1413_ = -(_e497);
                } else {
                    phi_1413_ = _e497;
                }
                let _e825 = phi_1413_;
                if (_e500 < 0.0lf) {
                    phi_1420_ = -(_e500);
                } else {
                    phi_1420_ = _e500;
                }
                let _e830 = phi_1420_;
                let _e831 = ((_e821 + _e825) + _e830);
                if (_e817 > _e831) {
                    phi_1426_ = _e817;
                } else {
                    phi_1426_ = _e831;
                }
                let _e834 = phi_1426_;
                if (_e543 < 0.0lf) {
                    phi_1432_ = -(_e543);
                } else {
                    phi_1432_ = _e543;
                }
                let _e838 = phi_1432_;
                if (_e544 < 0.0lf) {
                    phi_1438_ = -(_e544);
                } else {
                    phi_1438_ = _e544;
                }
                let _e842 = phi_1438_;
                if (_e545 < 0.0lf) {
                    phi_1445_ = -(_e545);
                } else {
                    phi_1445_ = _e545;
                }
                let _e847 = phi_1445_;
                let _e849 = (((_e838 + _e842) + _e847) * f64(0.5f));
                if (_e834 > _e849) {
                    phi_1452_ = _e834;
                } else {
                    phi_1452_ = _e849;
                }
                let _e852 = phi_1452_;
                let _e858 = local_20.member_3;
                let _e872 = (((((_e667 * _e777) * _e779) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e787 * f64(19f)) * ((_e667 * (_e721 + _e775)) + (_e721 * _e775)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e776 + _e667) * ((_e776 + _e721) * (_e776 + _e775)))));
                let _e873 = f64(3f);
                let _e874 = (_e556 * _e873);
                let _e875 = (_e613 * _e873);
                if (_e874 < _e875) {
                    phi_1480_ = _e874;
                } else {
                    phi_1480_ = _e875;
                }
                let _e878 = phi_1480_;
                if (_e579 < _e602) {
                    phi_1485_ = _e579;
                } else {
                    phi_1485_ = _e602;
                }
                let _e881 = phi_1485_;
                if (_e878 < _e881) {
                    phi_1490_ = _e878;
                } else {
                    phi_1490_ = _e881;
                }
                let _e884 = phi_1490_;
                if (_e874 > _e875) {
                    phi_1495_ = _e874;
                } else {
                    phi_1495_ = _e875;
                }
                let _e887 = phi_1495_;
                if (_e579 > _e602) {
                    phi_1500_ = _e579;
                } else {
                    phi_1500_ = _e602;
                }
                let _e890 = phi_1500_;
                if (_e887 > _e890) {
                    phi_1505_ = _e887;
                } else {
                    phi_1505_ = _e890;
                }
                let _e893 = phi_1505_;
                let _e899 = -(_e893);
                if (_e884 > _e899) {
                    phi_1516_ = _e884;
                } else {
                    phi_1516_ = _e899;
                }
                let _e902 = phi_1516_;
                if ((_e902 - (_e872 + ((_e457 * (((_e852 + (_e779 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e858 * f64(6f)) * (_e721 + _e775))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e776 + _e721) * (_e776 + _e775))))) * f64((3f * 1.0001f))))) > _e458) {
                    phi_7399_ = type_71(0u, type_71().member_1);
                } else {
                    if (_e457 > _e458) {
                        let _e3279 = f64(1f);
                        let _e3283 = local_20.member[0u];
                        let _e3289 = local_20.member_1[0u];
                        let _e3295 = local_20.member_2[0u];
                        let _e3299 = (_e3283[0] - _e3289[0]);
                        let _e3300 = (_e3283[1] - _e3289[1]);
                        let _e3301 = (_e3283[2] - _e3289[2]);
                        local_12 = array<array<f64, 3>, 4>(_e3283, array<f64, 3>(_e3299, _e3300, _e3301), array<f64, 3>((_e3283[0] - _e3295[0]), (_e3283[1] - _e3295[1]), (_e3283[2] - _e3295[2])), array<f64, 3>((_e3299 - _e3295[0]), (_e3300 - _e3295[1]), (_e3301 - _e3295[2])));
                        let _e3314 = local_20.member[1u];
                        let _e3320 = local_20.member_1[1u];
                        let _e3326 = local_20.member_2[1u];
                        let _e3330 = (_e3314[0] - _e3320[0]);
                        let _e3331 = (_e3314[1] - _e3320[1]);
                        let _e3332 = (_e3314[2] - _e3320[2]);
                        local_13 = array<array<f64, 3>, 4>(_e3314, array<f64, 3>(_e3330, _e3331, _e3332), array<f64, 3>((_e3314[0] - _e3326[0]), (_e3314[1] - _e3326[1]), (_e3314[2] - _e3326[2])), array<f64, 3>((_e3330 - _e3326[0]), (_e3331 - _e3326[1]), (_e3332 - _e3326[2])));
                        let _e3345 = local_20.member[0u];
                        if (_e3345[0] < 0.0lf) {
                            phi_1719_ = -(_e3345[0]);
                        } else {
                            phi_1719_ = _e3345[0];
                        }
                        let _e3352 = phi_1719_;
                        if (_e3345[1] < 0.0lf) {
                            phi_1726_ = -(_e3345[1]);
                        } else {
                            phi_1726_ = _e3345[1];
                        }
                        let _e3356 = phi_1726_;
                        if (_e3352 > _e3356) {
                            phi_1731_ = _e3352;
                        } else {
                            phi_1731_ = _e3356;
                        }
                        let _e3359 = phi_1731_;
                        if (_e3345[2] < 0.0lf) {
                            phi_1738_ = -(_e3345[2]);
                        } else {
                            phi_1738_ = _e3345[2];
                        }
                        let _e3363 = phi_1738_;
                        if (_e3359 > _e3363) {
                            phi_1743_ = _e3359;
                        } else {
                            phi_1743_ = _e3363;
                        }
                        let _e3366 = phi_1743_;
                        let _e3369 = local_20.member[1u];
                        if (_e3369[0] < 0.0lf) {
                            phi_1756_ = -(_e3369[0]);
                        } else {
                            phi_1756_ = _e3369[0];
                        }
                        let _e3376 = phi_1756_;
                        if (_e3369[1] < 0.0lf) {
                            phi_1763_ = -(_e3369[1]);
                        } else {
                            phi_1763_ = _e3369[1];
                        }
                        let _e3380 = phi_1763_;
                        if (_e3376 > _e3380) {
                            phi_1768_ = _e3376;
                        } else {
                            phi_1768_ = _e3380;
                        }
                        let _e3383 = phi_1768_;
                        if (_e3369[2] < 0.0lf) {
                            phi_1775_ = -(_e3369[2]);
                        } else {
                            phi_1775_ = _e3369[2];
                        }
                        let _e3387 = phi_1775_;
                        if (_e3383 > _e3387) {
                            phi_1780_ = _e3383;
                        } else {
                            phi_1780_ = _e3387;
                        }
                        let _e3390 = phi_1780_;
                        if (_e3366 > _e3390) {
                            phi_1785_ = _e3366;
                        } else {
                            phi_1785_ = _e3390;
                        }
                        let _e3393 = phi_1785_;
                        let _e3395 = local_20.member_3;
                        let _e3399 = local_20.member_1[0u];
                        if (_e3399[0] < 0.0lf) {
                            phi_1802_ = -(_e3399[0]);
                        } else {
                            phi_1802_ = _e3399[0];
                        }
                        let _e3406 = phi_1802_;
                        if (_e3399[1] < 0.0lf) {
                            phi_1809_ = -(_e3399[1]);
                        } else {
                            phi_1809_ = _e3399[1];
                        }
                        let _e3410 = phi_1809_;
                        if (_e3406 > _e3410) {
                            phi_1814_ = _e3406;
                        } else {
                            phi_1814_ = _e3410;
                        }
                        let _e3413 = phi_1814_;
                        if (_e3399[2] < 0.0lf) {
                            phi_1821_ = -(_e3399[2]);
                        } else {
                            phi_1821_ = _e3399[2];
                        }
                        let _e3417 = phi_1821_;
                        if (_e3413 > _e3417) {
                            phi_1826_ = _e3413;
                        } else {
                            phi_1826_ = _e3417;
                        }
                        let _e3420 = phi_1826_;
                        let _e3423 = local_20.member_1[1u];
                        if (_e3423[0] < 0.0lf) {
                            phi_1840_ = -(_e3423[0]);
                        } else {
                            phi_1840_ = _e3423[0];
                        }
                        let _e3430 = phi_1840_;
                        if (_e3423[1] < 0.0lf) {
                            phi_1847_ = -(_e3423[1]);
                        } else {
                            phi_1847_ = _e3423[1];
                        }
                        let _e3434 = phi_1847_;
                        if (_e3430 > _e3434) {
                            phi_1852_ = _e3430;
                        } else {
                            phi_1852_ = _e3434;
                        }
                        let _e3437 = phi_1852_;
                        if (_e3423[2] < 0.0lf) {
                            phi_1859_ = -(_e3423[2]);
                        } else {
                            phi_1859_ = _e3423[2];
                        }
                        let _e3441 = phi_1859_;
                        if (_e3437 > _e3441) {
                            phi_1864_ = _e3437;
                        } else {
                            phi_1864_ = _e3441;
                        }
                        let _e3444 = phi_1864_;
                        if (_e3420 > _e3444) {
                            phi_1869_ = _e3420;
                        } else {
                            phi_1869_ = _e3444;
                        }
                        let _e3447 = phi_1869_;
                        let _e3449 = local_20.member_3;
                        let _e3453 = local_20.member_2[0u];
                        if (_e3453[0] < 0.0lf) {
                            phi_1886_ = -(_e3453[0]);
                        } else {
                            phi_1886_ = _e3453[0];
                        }
                        let _e3460 = phi_1886_;
                        if (_e3453[1] < 0.0lf) {
                            phi_1893_ = -(_e3453[1]);
                        } else {
                            phi_1893_ = _e3453[1];
                        }
                        let _e3464 = phi_1893_;
                        if (_e3460 > _e3464) {
                            phi_1898_ = _e3460;
                        } else {
                            phi_1898_ = _e3464;
                        }
                        let _e3467 = phi_1898_;
                        if (_e3453[2] < 0.0lf) {
                            phi_1905_ = -(_e3453[2]);
                        } else {
                            phi_1905_ = _e3453[2];
                        }
                        let _e3471 = phi_1905_;
                        if (_e3467 > _e3471) {
                            phi_1910_ = _e3467;
                        } else {
                            phi_1910_ = _e3471;
                        }
                        let _e3474 = phi_1910_;
                        let _e3477 = local_20.member_2[1u];
                        if (_e3477[0] < 0.0lf) {
                            phi_1924_ = -(_e3477[0]);
                        } else {
                            phi_1924_ = _e3477[0];
                        }
                        let _e3484 = phi_1924_;
                        if (_e3477[1] < 0.0lf) {
                            phi_1931_ = -(_e3477[1]);
                        } else {
                            phi_1931_ = _e3477[1];
                        }
                        let _e3488 = phi_1931_;
                        if (_e3484 > _e3488) {
                            phi_1936_ = _e3484;
                        } else {
                            phi_1936_ = _e3488;
                        }
                        let _e3491 = phi_1936_;
                        if (_e3477[2] < 0.0lf) {
                            phi_1943_ = -(_e3477[2]);
                        } else {
                            phi_1943_ = _e3477[2];
                        }
                        let _e3495 = phi_1943_;
                        if (_e3491 > _e3495) {
                            phi_1948_ = _e3491;
                        } else {
                            phi_1948_ = _e3495;
                        }
                        let _e3498 = phi_1948_;
                        if (_e3474 > _e3498) {
                            phi_1953_ = _e3474;
                        } else {
                            phi_1953_ = _e3498;
                        }
                        let _e3501 = phi_1953_;
                        let _e3503 = local_20.member_3;
                        let _e3511 = local_20.member_3;
                        phi_1973_ = type_28(0u, 48u);
                        phi_1976_ = f64(0f);
                        loop {
                            let _e3520 = phi_1973_;
                            let _e3522 = phi_1976_;
                            local_79 = _e3522;
                            local_44 = _e3522;
                            local_45 = _e3522;
                            local_46 = _e3522;
                            if (_e3520.member < _e3520.member_1) {
                                phi_1974_ = type_28((_e3520.member + 1u), _e3520.member_1);
                                phi_1999_ = type_28(1u, _e3520.member);
                            } else {
                                phi_1974_ = _e3520;
                                phi_1999_ = type_28(0u, type_28().member_1);
                            }
                            let _e3536 = phi_1974_;
                            let _e3538 = phi_1999_;
                            if (bitcast<i32>(_e3538.member) != 0i) {
                                let _e3544 = local_20.member[0u];
                                let _e3550 = local_20.member[1u];
                                let _e3560 = (_e3544[0] + ((_e3550[0] - _e3544[0]) * _e3522));
                                let _e3561 = (_e3544[1] + ((_e3550[1] - _e3544[1]) * _e3522));
                                let _e3562 = (_e3544[2] + ((_e3550[2] - _e3544[2]) * _e3522));
                                let _e3565 = local_20.member_1[0u];
                                let _e3571 = local_20.member_1[1u];
                                let _e3581 = (_e3565[0] + ((_e3571[0] - _e3565[0]) * _e3522));
                                let _e3582 = (_e3565[1] + ((_e3571[1] - _e3565[1]) * _e3522));
                                let _e3583 = (_e3565[2] + ((_e3571[2] - _e3565[2]) * _e3522));
                                let _e3586 = local_20.member_2[0u];
                                let _e3592 = local_20.member_2[1u];
                                let _e3602 = (_e3586[0] + ((_e3592[0] - _e3586[0]) * _e3522));
                                let _e3603 = (_e3586[1] + ((_e3592[1] - _e3586[1]) * _e3522));
                                let _e3604 = (_e3586[2] + ((_e3592[2] - _e3586[2]) * _e3522));
                                let _e3609 = (((_e3581 * _e3581) + (_e3582 * _e3582)) + (_e3583 * _e3583));
                                let _e3614 = (((_e3581 * _e3602) + (_e3582 * _e3603)) + (_e3583 * _e3604));
                                let _e3619 = (((_e3602 * _e3602) + (_e3603 * _e3603)) + (_e3604 * _e3604));
                                let _e3624 = (((_e3560 * _e3581) + (_e3561 * _e3582)) + (_e3562 * _e3583));
                                let _e3629 = (((_e3560 * _e3602) + (_e3561 * _e3603)) + (_e3562 * _e3604));
                                let _e3632 = ((_e3609 * _e3619) - (_e3614 * _e3614));
                                let _e3633 = f64(0f);
                                let _e3634 = f64(1f);
                                let _e3638 = (((_e3624 * _e3619) - (_e3629 * _e3614)) / _e3632);
                                let _e3642 = (((_e3629 * _e3609) - (_e3624 * _e3614)) / _e3632);
                                if (_e3638 >= _e3633) {
                                    if (_e3642 >= _e3633) {
                                        if (_e3638 <= _e3634) {
                                            phi_2155_ = (_e3642 <= _e3634);
                                            phi_2156_ = false;
                                        } else {
                                            phi_2155_ = bool();
                                            phi_2156_ = true;
                                        }
                                        let _e3648 = phi_2155_;
                                        let _e3650 = phi_2156_;
                                        phi_2157_ = _e3648;
                                        phi_2158_ = _e3650;
                                    } else {
                                        phi_2157_ = bool();
                                        phi_2158_ = true;
                                    }
                                    let _e3652 = phi_2157_;
                                    let _e3654 = phi_2158_;
                                    phi_2159_ = _e3652;
                                    phi_2160_ = _e3654;
                                } else {
                                    phi_2159_ = bool();
                                    phi_2160_ = true;
                                }
                                let _e3656 = phi_2159_;
                                let _e3658 = phi_2160_;
                                if _e3658 {
                                    let _e3659 = (_e3632 > _e3633);
                                    if _e3659 {
                                        phi_2190_ = false;
                                    } else {
                                        phi_2190_ = true;
                                    }
                                    let _e3661 = phi_2190_;
                                    phi_2191_ = false;
                                    phi_2192_ = _e3661;
                                    phi_2193_ = _e3659;
                                } else {
                                    phi_2191_ = true;
                                    phi_2192_ = false;
                                    phi_2193_ = false;
                                }
                                let _e3663 = phi_2191_;
                                let _e3665 = phi_2192_;
                                let _e3667 = phi_2193_;
                                if _e3663 {
                                    if (_e3632 > _e3633) {
                                        if _e3656 {
                                            phi_2217_ = array<f64, 3>((_e3560 - ((_e3581 * _e3638) + (_e3602 * _e3642))), (_e3561 - ((_e3582 * _e3638) + (_e3603 * _e3642))), (_e3562 - ((_e3583 * _e3638) + (_e3604 * _e3642))));
                                            phi_2218_ = false;
                                        } else {
                                            phi_2217_ = array<f64, 3>();
                                            phi_2218_ = true;
                                        }
                                        let _e3683 = phi_2217_;
                                        let _e3685 = phi_2218_;
                                        phi_2219_ = _e3683;
                                        phi_2220_ = false;
                                        phi_2221_ = _e3685;
                                    } else {
                                        phi_2219_ = array<f64, 3>();
                                        phi_2220_ = true;
                                        phi_2221_ = false;
                                    }
                                    let _e3687 = phi_2219_;
                                    let _e3689 = phi_2220_;
                                    let _e3691 = phi_2221_;
                                    phi_2222_ = _e3687;
                                    phi_2223_ = _e3689;
                                    phi_2224_ = _e3691;
                                } else {
                                    phi_2222_ = array<f64, 3>();
                                    phi_2223_ = _e3665;
                                    phi_2224_ = _e3667;
                                }
                                let _e3693 = phi_2222_;
                                let _e3695 = phi_2223_;
                                let _e3697 = phi_2224_;
                                if _e3695 {
                                    phi_2228_ = true;
                                } else {
                                    phi_2228_ = _e3697;
                                }
                                let _e3699 = phi_2228_;
                                if _e3699 {
                                    let _e3700 = (_e3560 - _e3581);
                                    let _e3701 = (_e3561 - _e3582);
                                    let _e3702 = (_e3562 - _e3583);
                                    let _e3713 = ((((_e3560 * _e3581) + (_e3561 * _e3582)) + (_e3562 * _e3583)) / (((_e3581 * _e3581) + (_e3582 * _e3582)) + (_e3583 * _e3583)));
                                    if (_e3713 > f64(0f)) {
                                        if (_e3713 < f64(1f)) {
                                            phi_2261_ = _e3713;
                                        } else {
                                            phi_2261_ = f64(1f);
                                        }
                                        let _e3721 = phi_2261_;
                                        phi_2263_ = _e3721;
                                    } else {
                                        phi_2263_ = f64(0f);
                                    }
                                    let _e3723 = phi_2263_;
                                    let _e3740 = ((((_e3560 * _e3602) + (_e3561 * _e3603)) + (_e3562 * _e3604)) / (((_e3602 * _e3602) + (_e3603 * _e3603)) + (_e3604 * _e3604)));
                                    if (_e3740 > f64(0f)) {
                                        if (_e3740 < f64(1f)) {
                                            phi_2293_ = _e3740;
                                        } else {
                                            phi_2293_ = f64(1f);
                                        }
                                        let _e3748 = phi_2293_;
                                        phi_2295_ = _e3748;
                                    } else {
                                        phi_2295_ = f64(0f);
                                    }
                                    let _e3750 = phi_2295_;
                                    let _e3767 = ((((_e3700 * _e3602) + (_e3701 * _e3603)) + (_e3702 * _e3604)) / (((_e3602 * _e3602) + (_e3603 * _e3603)) + (_e3604 * _e3604)));
                                    if (_e3767 > f64(0f)) {
                                        if (_e3767 < f64(1f)) {
                                            phi_2325_ = _e3767;
                                        } else {
                                            phi_2325_ = f64(1f);
                                        }
                                        let _e3775 = phi_2325_;
                                        phi_2327_ = _e3775;
                                    } else {
                                        phi_2327_ = f64(0f);
                                    }
                                    let _e3777 = phi_2327_;
                                    let _e3784 = (_e3560 - _e3602);
                                    let _e3785 = (_e3561 - _e3603);
                                    let _e3786 = (_e3562 - _e3604);
                                    let _e3797 = ((((_e3784 * _e3581) + (_e3785 * _e3582)) + (_e3786 * _e3583)) / (((_e3581 * _e3581) + (_e3582 * _e3582)) + (_e3583 * _e3583)));
                                    if (_e3797 > f64(0f)) {
                                        if (_e3797 < f64(1f)) {
                                            phi_2360_ = _e3797;
                                        } else {
                                            phi_2360_ = f64(1f);
                                        }
                                        let _e3805 = phi_2360_;
                                        phi_2362_ = _e3805;
                                    } else {
                                        phi_2362_ = f64(0f);
                                    }
                                    let _e3807 = phi_2362_;
                                    local_11[0u] = array<f64, 3>((_e3560 - (_e3581 * _e3723)), (_e3561 - (_e3582 * _e3723)), (_e3562 - (_e3583 * _e3723)));
                                    local_11[1u] = array<f64, 3>((_e3560 - (_e3602 * _e3750)), (_e3561 - (_e3603 * _e3750)), (_e3562 - (_e3604 * _e3750)));
                                    local_11[2u] = array<f64, 3>((_e3700 - (_e3602 * _e3777)), (_e3701 - (_e3603 * _e3777)), (_e3702 - (_e3604 * _e3777)));
                                    local_11[3u] = array<f64, 3>((_e3784 - (_e3581 * _e3807)), (_e3785 - (_e3582 * _e3807)), (_e3786 - (_e3583 * _e3807)));
                                    let _e3823 = local_11[0u];
                                    phi_2517_ = type_28(1u, 4u);
                                    phi_2520_ = array<f64, 3>(_e3823[0], _e3823[1], _e3823[2]);
                                    loop {
                                        let _e3829 = phi_2517_;
                                        let _e3831 = phi_2520_;
                                        local_69 = _e3831;
                                        if (_e3829.member < _e3829.member_1) {
                                            phi_2518_ = type_28((_e3829.member + 1u), _e3829.member_1);
                                            phi_2543_ = type_28(1u, _e3829.member);
                                        } else {
                                            phi_2518_ = _e3829;
                                            phi_2543_ = type_28(0u, type_28().member_1);
                                        }
                                        let _e3845 = phi_2518_;
                                        let _e3847 = phi_2543_;
                                        let _e3851 = (bitcast<i32>(_e3847.member) != 0i);
                                        if _e3851 {
                                            if (_e3847.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3854 = local_11[_e3847.member_1];
                                            if (_e3847.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3860 = local_11[_e3847.member_1];
                                            if ((((_e3854[0] * _e3860[0]) + (_e3854[1] * _e3860[1])) + (_e3854[2] * _e3860[2])) < (((_e3831[0] * _e3831[0]) + (_e3831[1] * _e3831[1])) + (_e3831[2] * _e3831[2]))) {
                                                if (_e3847.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3883 = local_11[_e3847.member_1];
                                                phi_2610_ = array<f64, 3>(_e3883[0], _e3883[1], _e3883[2]);
                                            } else {
                                                phi_2610_ = _e3831;
                                            }
                                            let _e3889 = phi_2610_;
                                            phi_2521_ = _e3889;
                                        } else {
                                            phi_2521_ = array<f64, 3>();
                                        }
                                        let _e3891 = phi_2521_;
                                        continue;
                                        continuing {
                                            phi_2517_ = _e3845;
                                            phi_2520_ = _e3891;
                                            break if !(_e3851);
                                        }
                                    }
                                    let _e5653 = local_69;
                                    phi_2611_ = _e5653;
                                } else {
                                    phi_2611_ = _e3693;
                                }
                                let _e3894 = phi_2611_;
                                if (_e3894[0] < 0.0lf) {
                                    phi_2618_ = -(_e3894[0]);
                                } else {
                                    phi_2618_ = _e3894[0];
                                }
                                let _e3899 = phi_2618_;
                                if (_e3894[1] < 0.0lf) {
                                    phi_2625_ = -(_e3894[1]);
                                } else {
                                    phi_2625_ = _e3894[1];
                                }
                                let _e3904 = phi_2625_;
                                if (_e3894[2] < 0.0lf) {
                                    phi_2633_ = -(_e3894[2]);
                                } else {
                                    phi_2633_ = _e3894[2];
                                }
                                let _e3910 = phi_2633_;
                                let _e3911 = ((_e3899 + _e3904) + _e3910);
                                if (_e3911 > f64(0f)) {
                                    if ((bitcast<u64>(_e3911) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e3917 = (f64(1f) / _e3911);
                                        let _e3919 = (_e3894[0] * _e3917);
                                        let _e3921 = (_e3894[1] * _e3917);
                                        let _e3923 = (_e3894[2] * _e3917);
                                        let _e3928 = (((_e3919 * _e3919) + (_e3921 * _e3921)) + (_e3923 * _e3923));
                                        if (_e3928 <= 2.2250738585072014e-308lf) {
                                            if (_e3928 > 0.0lf) {
                                                phi_2671_ = (bitcast<f64>(((4503599627370496lu >> bitcast<u64>(1lu)) + 2303426169912950784lu)) * 2.0lf);
                                            } else {
                                                phi_2671_ = 0.0lf;
                                            }
                                            let _e3991 = phi_2671_;
                                            phi_2735_ = _e3991;
                                        } else {
                                            phi_2678_ = type_26(0i, 5i);
                                            phi_2681_ = bitcast<f64>(((bitcast<u64>(_e3928) >> bitcast<u64>(1lu)) + 2303426169912950784lu));
                                            loop {
                                                let _e3936 = phi_2678_;
                                                let _e3938 = phi_2681_;
                                                local_38 = _e3938;
                                                if (_e3936.member < _e3936.member_1) {
                                                    let _e3946 = (_e3936.member + 1i);
                                                    if ((false == (_e3946 > _e3936.member)) != false) {
                                                        phi_2702_ = true;
                                                    } else {
                                                        phi_2702_ = false;
                                                    }
                                                    let _e3951 = phi_2702_;
                                                    if _e3951 {
                                                        phi_2708_ = type_27(0u, type_27().member_1);
                                                    } else {
                                                        phi_2708_ = type_27(1u, _e3946);
                                                    }
                                                    let _e3957 = phi_2708_;
                                                    if (bitcast<i32>(_e3957.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2679_ = type_26(_e3957.member_1, _e3936.member_1);
                                                    phi_2722_ = type_27(1u, _e3936.member);
                                                } else {
                                                    phi_2679_ = _e3936;
                                                    phi_2722_ = type_27(0u, type_27().member_1);
                                                }
                                                let _e3967 = phi_2679_;
                                                let _e3969 = phi_2722_;
                                                let _e3972 = (bitcast<i32>(_e3969.member) != 0i);
                                                if _e3972 {
                                                    phi_2682_ = (0.5lf * (_e3938 + (_e3928 / _e3938)));
                                                } else {
                                                    phi_2682_ = f64();
                                                }
                                                let _e3977 = phi_2682_;
                                                continue;
                                                continuing {
                                                    phi_2678_ = _e3967;
                                                    phi_2681_ = _e3977;
                                                    break if !(_e3972);
                                                }
                                            }
                                            let _e3982 = local_38;
                                            phi_2735_ = (_e3982 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e3993 = phi_2735_;
                                        phi_2748_ = type_28(0u, 4u);
                                        phi_2751_ = f64(2f);
                                        loop {
                                            let _e4005 = phi_2748_;
                                            let _e4007 = phi_2751_;
                                            local_40 = _e4007;
                                            local_41 = _e4007;
                                            local_42 = _e4007;
                                            local_70 = _e4007;
                                            local_71 = _e4007;
                                            if (_e4005.member < _e4005.member_1) {
                                                phi_2749_ = type_28((_e4005.member + 1u), _e4005.member_1);
                                                phi_2774_ = type_28(1u, _e4005.member);
                                            } else {
                                                phi_2749_ = _e4005;
                                                phi_2774_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4021 = phi_2749_;
                                            let _e4023 = phi_2774_;
                                            if (bitcast<i32>(_e4023.member) != 0i) {
                                                if (_e4023.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4030 = local_12[_e4023.member_1];
                                                let _e4038 = (((_e3919 * _e4030[0]) + (_e3921 * _e4030[1])) + (_e3923 * _e4030[2]));
                                                if (_e4023.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4041 = local_13[_e4023.member_1];
                                                let _e4049 = (((_e3919 * _e4041[0]) + (_e3921 * _e4041[1])) + (_e3923 * _e4041[2]));
                                                if (_e4038 < 0.0lf) {
                                                    phi_2825_ = -(_e4038);
                                                } else {
                                                    phi_2825_ = _e4038;
                                                }
                                                let _e4053 = phi_2825_;
                                                if (_e4049 < 0.0lf) {
                                                    phi_2831_ = -(_e4049);
                                                } else {
                                                    phi_2831_ = _e4049;
                                                }
                                                let _e4057 = phi_2831_;
                                                let _e4062 = (((((((((_e3393 + _e3395) + (_e3447 + _e3449)) + (_e3501 + _e3503)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3511 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e457 * _e3993) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e4053 + _e4057) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e4038 > _e4062) {
                                                    if (_e4049 > _e4062) {
                                                        phi_2845_ = false;
                                                    } else {
                                                        phi_2845_ = true;
                                                    }
                                                    let _e4066 = phi_2845_;
                                                    phi_2846_ = _e4066;
                                                } else {
                                                    phi_2846_ = true;
                                                }
                                                let _e4068 = phi_2846_;
                                                if _e4068 {
                                                    let _e4072 = ((_e4038 + ((_e4049 - _e4038) * _e3522)) > _e4062);
                                                    if _e4072 {
                                                        if (_e4049 < _e4038) {
                                                            let _e4081 = (((_e4038 - _e4062) / (_e4038 - _e4049)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                            if (_e4007 < _e4081) {
                                                                phi_2873_ = _e4007;
                                                            } else {
                                                                phi_2873_ = _e4081;
                                                            }
                                                            let _e4084 = phi_2873_;
                                                            phi_2874_ = _e4084;
                                                        } else {
                                                            phi_2874_ = _e4007;
                                                        }
                                                        let _e4086 = phi_2874_;
                                                        phi_2875_ = _e4086;
                                                    } else {
                                                        phi_2875_ = f64();
                                                    }
                                                    let _e4088 = phi_2875_;
                                                    phi_2876_ = _e4088;
                                                    phi_2877_ = _e4072;
                                                } else {
                                                    phi_2876_ = _e4007;
                                                    phi_2877_ = true;
                                                }
                                                let _e4090 = phi_2876_;
                                                let _e4092 = phi_2877_;
                                                phi_2752_ = _e4090;
                                                phi_2878_ = _e4092;
                                                phi_2879_ = false;
                                            } else {
                                                phi_2752_ = f64();
                                                phi_2878_ = false;
                                                phi_2879_ = true;
                                            }
                                            let _e4094 = phi_2752_;
                                            let _e4096 = phi_2878_;
                                            let _e4098 = phi_2879_;
                                            local_39 = _e4098;
                                            continue;
                                            continuing {
                                                phi_2748_ = _e4021;
                                                phi_2751_ = _e4094;
                                                break if !(_e4096);
                                            }
                                        }
                                        let _e4101 = local_39;
                                        if _e4101 {
                                            let _e4103 = local_40;
                                            let _e4104 = (_e4103 > _e3279);
                                            if _e4104 {
                                                phi_2901_ = false;
                                                phi_2902_ = false;
                                                phi_2903_ = false;
                                            } else {
                                                let _e4106 = local_41;
                                                if (_e4106 > _e3522) {
                                                    let _e4109 = local_42;
                                                    let _e4112 = ((_e4109 - _e3522) < f64(0.00000000023283064f));
                                                    if _e4112 {
                                                        phi_2897_ = false;
                                                    } else {
                                                        phi_2897_ = true;
                                                    }
                                                    let _e4114 = phi_2897_;
                                                    phi_2898_ = _e4114;
                                                    phi_2899_ = _e4112;
                                                    phi_2900_ = false;
                                                } else {
                                                    phi_2898_ = false;
                                                    phi_2899_ = false;
                                                    phi_2900_ = true;
                                                }
                                                let _e4116 = phi_2898_;
                                                let _e4118 = phi_2899_;
                                                let _e4120 = phi_2900_;
                                                phi_2901_ = _e4116;
                                                phi_2902_ = _e4118;
                                                phi_2903_ = _e4120;
                                            }
                                            let _e4122 = phi_2901_;
                                            let _e4124 = phi_2902_;
                                            let _e4126 = phi_2903_;
                                            phi_2904_ = _e4122;
                                            phi_2905_ = _e4104;
                                            phi_2906_ = _e4124;
                                            phi_2907_ = _e4126;
                                            phi_2908_ = false;
                                        } else {
                                            phi_2904_ = false;
                                            phi_2905_ = false;
                                            phi_2906_ = false;
                                            phi_2907_ = false;
                                            phi_2908_ = true;
                                        }
                                        let _e4128 = phi_2904_;
                                        let _e4130 = phi_2905_;
                                        let _e4132 = phi_2906_;
                                        let _e4134 = phi_2907_;
                                        let _e4136 = phi_2908_;
                                        let _e5701 = local_70;
                                        phi_2909_ = _e5701;
                                        let _e5704 = local_71;
                                        phi_2910_ = _e5704;
                                        phi_2911_ = _e4128;
                                        phi_2912_ = _e4130;
                                        phi_2913_ = _e4132;
                                        phi_2914_ = _e4134;
                                        phi_2915_ = _e4136;
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
                                    let _e4138 = phi_2909_;
                                    let _e4140 = phi_2910_;
                                    let _e4142 = phi_2911_;
                                    let _e4144 = phi_2912_;
                                    let _e4146 = phi_2913_;
                                    let _e4148 = phi_2914_;
                                    let _e4150 = phi_2915_;
                                    let _e4152 = phi_2916_;
                                    phi_2917_ = _e4138;
                                    phi_2918_ = _e4140;
                                    phi_2919_ = _e4142;
                                    phi_2920_ = _e4144;
                                    phi_2921_ = _e4146;
                                    phi_2922_ = _e4148;
                                    phi_2923_ = _e4150;
                                    phi_2924_ = _e4152;
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
                                let _e4154 = phi_2917_;
                                let _e4156 = phi_2918_;
                                let _e4158 = phi_2919_;
                                let _e4160 = phi_2920_;
                                let _e4162 = phi_2921_;
                                let _e4164 = phi_2922_;
                                let _e4166 = phi_2923_;
                                let _e4168 = phi_2924_;
                                let _e4170 = phi_2925_;
                                phi_2926_ = _e4154;
                                phi_1977_ = _e4156;
                                phi_2927_ = _e4158;
                                phi_2928_ = _e4160;
                                phi_2929_ = _e4162;
                                phi_2930_ = false;
                                phi_2931_ = _e4164;
                                phi_2932_ = _e4166;
                                phi_2933_ = _e4168;
                                phi_2934_ = _e4170;
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
                            let _e4172 = phi_2926_;
                            let _e4174 = phi_1977_;
                            let _e4176 = phi_2927_;
                            let _e4178 = phi_2928_;
                            let _e4180 = phi_2929_;
                            let _e4182 = phi_2930_;
                            let _e4184 = phi_2931_;
                            let _e4186 = phi_2932_;
                            let _e4188 = phi_2933_;
                            let _e4190 = phi_2934_;
                            local_43 = _e4178;
                            local_72 = _e4180;
                            local_73 = _e4182;
                            local_74 = _e4184;
                            local_75 = _e4186;
                            local_76 = _e4188;
                            local_77 = _e4190;
                            local_78 = _e4172;
                            local_80 = _e4178;
                            continue;
                            continuing {
                                phi_1973_ = _e3536;
                                phi_1976_ = _e4174;
                                break if !(_e4176);
                            }
                        }
                        let _e4193 = local_43;
                        if _e4193 {
                            phi_2939_ = type_71(0u, type_71().member_1);
                            phi_2940_ = false;
                            phi_2941_ = false;
                            phi_2942_ = false;
                            phi_2943_ = false;
                            phi_2944_ = false;
                            phi_2945_ = false;
                        } else {
                            phi_2939_ = type_71();
                            let _e5734 = local_72;
                            phi_2940_ = _e5734;
                            let _e5737 = local_73;
                            phi_2941_ = _e5737;
                            let _e5740 = local_74;
                            phi_2942_ = _e5740;
                            let _e5743 = local_75;
                            phi_2943_ = _e5743;
                            let _e5746 = local_76;
                            phi_2944_ = _e5746;
                            let _e5749 = local_77;
                            phi_2945_ = _e5749;
                        }
                        let _e4198 = phi_2939_;
                        let _e4200 = phi_2940_;
                        let _e4202 = phi_2941_;
                        let _e4204 = phi_2942_;
                        let _e4206 = phi_2943_;
                        let _e4208 = phi_2944_;
                        let _e4210 = phi_2945_;
                        if _e4200 {
                            let _e5752 = local_78;
                            phi_2949_ = _e5752;
                            phi_2950_ = true;
                            phi_2951_ = false;
                            phi_2952_ = false;
                            phi_2953_ = false;
                            phi_2954_ = false;
                            phi_2955_ = false;
                        } else {
                            let _e5754 = local_79;
                            phi_2949_ = _e5754;
                            phi_2950_ = _e4202;
                            phi_2951_ = _e4204;
                            phi_2952_ = _e4206;
                            let _e5760 = local_80;
                            phi_2953_ = _e5760;
                            phi_2954_ = _e4208;
                            phi_2955_ = _e4210;
                        }
                        let _e4212 = phi_2949_;
                        let _e4214 = phi_2950_;
                        let _e4216 = phi_2951_;
                        let _e4218 = phi_2952_;
                        let _e4220 = phi_2953_;
                        let _e4222 = phi_2954_;
                        let _e4224 = phi_2955_;
                        if _e4214 {
                            phi_2960_ = type_71(1u, _e4212);
                            phi_2961_ = false;
                            phi_2962_ = false;
                            phi_2963_ = false;
                            phi_2964_ = false;
                            phi_2965_ = false;
                        } else {
                            phi_2960_ = type_71();
                            phi_2961_ = _e4216;
                            phi_2962_ = _e4218;
                            phi_2963_ = _e4220;
                            phi_2964_ = _e4222;
                            phi_2965_ = _e4224;
                        }
                        let _e4227 = phi_2960_;
                        let _e4229 = phi_2961_;
                        let _e4231 = phi_2962_;
                        let _e4233 = phi_2963_;
                        let _e4235 = phi_2964_;
                        let _e4237 = phi_2965_;
                        if _e4229 {
                            let _e4239 = local_44;
                            phi_2970_ = type_71(1u, _e4239);
                            phi_2971_ = false;
                            phi_2972_ = true;
                            phi_2973_ = false;
                            phi_2974_ = false;
                        } else {
                            phi_2970_ = _e4198;
                            phi_2971_ = _e4231;
                            phi_2972_ = _e4233;
                            phi_2973_ = _e4235;
                            phi_2974_ = _e4237;
                        }
                        let _e4242 = phi_2970_;
                        let _e4244 = phi_2971_;
                        let _e4246 = phi_2972_;
                        let _e4248 = phi_2973_;
                        let _e4250 = phi_2974_;
                        if _e4244 {
                            let _e4252 = local_45;
                            phi_2979_ = type_71(1u, _e4252);
                            phi_2980_ = true;
                            phi_2981_ = false;
                            phi_2982_ = false;
                        } else {
                            phi_2979_ = _e4242;
                            phi_2980_ = _e4246;
                            phi_2981_ = _e4248;
                            phi_2982_ = _e4250;
                        }
                        let _e4255 = phi_2979_;
                        let _e4257 = phi_2980_;
                        let _e4259 = phi_2981_;
                        let _e4261 = phi_2982_;
                        if _e4257 {
                            phi_2986_ = false;
                            phi_2987_ = false;
                        } else {
                            phi_2986_ = _e4259;
                            phi_2987_ = _e4261;
                        }
                        let _e4263 = phi_2986_;
                        let _e4265 = phi_2987_;
                        if _e4263 {
                            phi_2991_ = false;
                            phi_2992_ = false;
                        } else {
                            phi_2991_ = _e4265;
                            phi_2992_ = _e4257;
                        }
                        let _e4267 = phi_2991_;
                        let _e4269 = phi_2992_;
                        if _e4267 {
                            phi_2996_ = true;
                            phi_2997_ = false;
                        } else {
                            phi_2996_ = _e4263;
                            phi_2997_ = _e4269;
                        }
                        let _e4271 = phi_2996_;
                        let _e4273 = phi_2997_;
                        if _e4271 {
                            let _e4275 = local_46;
                            phi_3002_ = type_71(1u, _e4275);
                            phi_3003_ = true;
                        } else {
                            phi_3002_ = _e4255;
                            phi_3003_ = _e4273;
                        }
                        let _e4278 = phi_3002_;
                        let _e4280 = phi_3003_;
                        if _e4280 {
                            phi_3007_ = _e4278;
                        } else {
                            phi_3007_ = _e4227;
                        }
                        let _e4282 = phi_3007_;
                        if (_e4282.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_3021_ = type_28(0u, 3u);
                            loop {
                                let _e4295 = phi_3021_;
                                if (_e4295.member < _e4295.member_1) {
                                    phi_3022_ = type_28((_e4295.member + 1u), _e4295.member_1);
                                    phi_3045_ = type_28(1u, _e4295.member);
                                } else {
                                    phi_3022_ = _e4295;
                                    phi_3045_ = type_28(0u, type_28().member_1);
                                }
                                let _e4309 = phi_3022_;
                                let _e4311 = phi_3045_;
                                if (bitcast<i32>(_e4311.member) != 0i) {
                                    if (_e4311.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4318 = local_14[_e4311.member_1];
                                    let _e4320 = (_e4282.member_1 + f64(_e4318));
                                    if (_e4320 < _e3279) {
                                        phi_3066_ = _e4320;
                                    } else {
                                        phi_3066_ = _e3279;
                                    }
                                    let _e4323 = phi_3066_;
                                    let _e4326 = local_20.member[0u];
                                    let _e4332 = local_20.member[1u];
                                    let _e4342 = (_e4326[0] + ((_e4332[0] - _e4326[0]) * _e4323));
                                    let _e4343 = (_e4326[1] + ((_e4332[1] - _e4326[1]) * _e4323));
                                    let _e4344 = (_e4326[2] + ((_e4332[2] - _e4326[2]) * _e4323));
                                    let _e4347 = local_20.member_1[0u];
                                    let _e4353 = local_20.member_1[1u];
                                    let _e4363 = (_e4347[0] + ((_e4353[0] - _e4347[0]) * _e4323));
                                    let _e4364 = (_e4347[1] + ((_e4353[1] - _e4347[1]) * _e4323));
                                    let _e4365 = (_e4347[2] + ((_e4353[2] - _e4347[2]) * _e4323));
                                    let _e4368 = local_20.member_2[0u];
                                    let _e4374 = local_20.member_2[1u];
                                    let _e4384 = (_e4368[0] + ((_e4374[0] - _e4368[0]) * _e4323));
                                    let _e4385 = (_e4368[1] + ((_e4374[1] - _e4368[1]) * _e4323));
                                    let _e4386 = (_e4368[2] + ((_e4374[2] - _e4368[2]) * _e4323));
                                    let _e4391 = (((_e4363 * _e4363) + (_e4364 * _e4364)) + (_e4365 * _e4365));
                                    let _e4396 = (((_e4363 * _e4384) + (_e4364 * _e4385)) + (_e4365 * _e4386));
                                    let _e4401 = (((_e4384 * _e4384) + (_e4385 * _e4385)) + (_e4386 * _e4386));
                                    let _e4406 = (((_e4342 * _e4363) + (_e4343 * _e4364)) + (_e4344 * _e4365));
                                    let _e4411 = (((_e4342 * _e4384) + (_e4343 * _e4385)) + (_e4344 * _e4386));
                                    let _e4414 = ((_e4391 * _e4401) - (_e4396 * _e4396));
                                    let _e4415 = f64(0f);
                                    let _e4416 = f64(1f);
                                    let _e4420 = (((_e4406 * _e4401) - (_e4411 * _e4396)) / _e4414);
                                    let _e4424 = (((_e4411 * _e4391) - (_e4406 * _e4396)) / _e4414);
                                    if (_e4420 >= _e4415) {
                                        if (_e4424 >= _e4415) {
                                            if (_e4420 <= _e4416) {
                                                phi_3216_ = (_e4424 <= _e4416);
                                                phi_3217_ = false;
                                            } else {
                                                phi_3216_ = bool();
                                                phi_3217_ = true;
                                            }
                                            let _e4430 = phi_3216_;
                                            let _e4432 = phi_3217_;
                                            phi_3218_ = _e4430;
                                            phi_3219_ = _e4432;
                                        } else {
                                            phi_3218_ = bool();
                                            phi_3219_ = true;
                                        }
                                        let _e4434 = phi_3218_;
                                        let _e4436 = phi_3219_;
                                        phi_3220_ = _e4434;
                                        phi_3221_ = _e4436;
                                    } else {
                                        phi_3220_ = bool();
                                        phi_3221_ = true;
                                    }
                                    let _e4438 = phi_3220_;
                                    let _e4440 = phi_3221_;
                                    if _e4440 {
                                        let _e4441 = (_e4414 > _e4415);
                                        if _e4441 {
                                            phi_3251_ = false;
                                        } else {
                                            phi_3251_ = true;
                                        }
                                        let _e4443 = phi_3251_;
                                        phi_3252_ = false;
                                        phi_3253_ = _e4443;
                                        phi_3254_ = _e4441;
                                    } else {
                                        phi_3252_ = true;
                                        phi_3253_ = false;
                                        phi_3254_ = false;
                                    }
                                    let _e4445 = phi_3252_;
                                    let _e4447 = phi_3253_;
                                    let _e4449 = phi_3254_;
                                    if _e4445 {
                                        if (_e4414 > _e4415) {
                                            if _e4438 {
                                                phi_3278_ = array<f64, 3>((_e4342 - ((_e4363 * _e4420) + (_e4384 * _e4424))), (_e4343 - ((_e4364 * _e4420) + (_e4385 * _e4424))), (_e4344 - ((_e4365 * _e4420) + (_e4386 * _e4424))));
                                                phi_3279_ = false;
                                            } else {
                                                phi_3278_ = array<f64, 3>();
                                                phi_3279_ = true;
                                            }
                                            let _e4465 = phi_3278_;
                                            let _e4467 = phi_3279_;
                                            phi_3280_ = _e4465;
                                            phi_3281_ = false;
                                            phi_3282_ = _e4467;
                                        } else {
                                            phi_3280_ = array<f64, 3>();
                                            phi_3281_ = true;
                                            phi_3282_ = false;
                                        }
                                        let _e4469 = phi_3280_;
                                        let _e4471 = phi_3281_;
                                        let _e4473 = phi_3282_;
                                        phi_3283_ = _e4469;
                                        phi_3284_ = _e4471;
                                        phi_3285_ = _e4473;
                                    } else {
                                        phi_3283_ = array<f64, 3>();
                                        phi_3284_ = _e4447;
                                        phi_3285_ = _e4449;
                                    }
                                    let _e4475 = phi_3283_;
                                    let _e4477 = phi_3284_;
                                    let _e4479 = phi_3285_;
                                    if _e4477 {
                                        phi_3289_ = true;
                                    } else {
                                        phi_3289_ = _e4479;
                                    }
                                    let _e4481 = phi_3289_;
                                    if _e4481 {
                                        let _e4482 = (_e4342 - _e4363);
                                        let _e4483 = (_e4343 - _e4364);
                                        let _e4484 = (_e4344 - _e4365);
                                        let _e4495 = ((((_e4342 * _e4363) + (_e4343 * _e4364)) + (_e4344 * _e4365)) / (((_e4363 * _e4363) + (_e4364 * _e4364)) + (_e4365 * _e4365)));
                                        if (_e4495 > f64(0f)) {
                                            if (_e4495 < f64(1f)) {
                                                phi_3322_ = _e4495;
                                            } else {
                                                phi_3322_ = f64(1f);
                                            }
                                            let _e4503 = phi_3322_;
                                            phi_3324_ = _e4503;
                                        } else {
                                            phi_3324_ = f64(0f);
                                        }
                                        let _e4505 = phi_3324_;
                                        let _e4522 = ((((_e4342 * _e4384) + (_e4343 * _e4385)) + (_e4344 * _e4386)) / (((_e4384 * _e4384) + (_e4385 * _e4385)) + (_e4386 * _e4386)));
                                        if (_e4522 > f64(0f)) {
                                            if (_e4522 < f64(1f)) {
                                                phi_3354_ = _e4522;
                                            } else {
                                                phi_3354_ = f64(1f);
                                            }
                                            let _e4530 = phi_3354_;
                                            phi_3356_ = _e4530;
                                        } else {
                                            phi_3356_ = f64(0f);
                                        }
                                        let _e4532 = phi_3356_;
                                        let _e4549 = ((((_e4482 * _e4384) + (_e4483 * _e4385)) + (_e4484 * _e4386)) / (((_e4384 * _e4384) + (_e4385 * _e4385)) + (_e4386 * _e4386)));
                                        if (_e4549 > f64(0f)) {
                                            if (_e4549 < f64(1f)) {
                                                phi_3386_ = _e4549;
                                            } else {
                                                phi_3386_ = f64(1f);
                                            }
                                            let _e4557 = phi_3386_;
                                            phi_3388_ = _e4557;
                                        } else {
                                            phi_3388_ = f64(0f);
                                        }
                                        let _e4559 = phi_3388_;
                                        let _e4566 = (_e4342 - _e4384);
                                        let _e4567 = (_e4343 - _e4385);
                                        let _e4568 = (_e4344 - _e4386);
                                        let _e4579 = ((((_e4566 * _e4363) + (_e4567 * _e4364)) + (_e4568 * _e4365)) / (((_e4363 * _e4363) + (_e4364 * _e4364)) + (_e4365 * _e4365)));
                                        if (_e4579 > f64(0f)) {
                                            if (_e4579 < f64(1f)) {
                                                phi_3421_ = _e4579;
                                            } else {
                                                phi_3421_ = f64(1f);
                                            }
                                            let _e4587 = phi_3421_;
                                            phi_3423_ = _e4587;
                                        } else {
                                            phi_3423_ = f64(0f);
                                        }
                                        let _e4589 = phi_3423_;
                                        local_10[0u] = array<f64, 3>((_e4342 - (_e4363 * _e4505)), (_e4343 - (_e4364 * _e4505)), (_e4344 - (_e4365 * _e4505)));
                                        local_10[1u] = array<f64, 3>((_e4342 - (_e4384 * _e4532)), (_e4343 - (_e4385 * _e4532)), (_e4344 - (_e4386 * _e4532)));
                                        local_10[2u] = array<f64, 3>((_e4482 - (_e4384 * _e4559)), (_e4483 - (_e4385 * _e4559)), (_e4484 - (_e4386 * _e4559)));
                                        local_10[3u] = array<f64, 3>((_e4566 - (_e4363 * _e4589)), (_e4567 - (_e4364 * _e4589)), (_e4568 - (_e4365 * _e4589)));
                                        let _e4605 = local_10[0u];
                                        phi_3578_ = type_28(1u, 4u);
                                        phi_3581_ = array<f64, 3>(_e4605[0], _e4605[1], _e4605[2]);
                                        loop {
                                            let _e4611 = phi_3578_;
                                            let _e4613 = phi_3581_;
                                            local_81 = _e4613;
                                            if (_e4611.member < _e4611.member_1) {
                                                phi_3579_ = type_28((_e4611.member + 1u), _e4611.member_1);
                                                phi_3604_ = type_28(1u, _e4611.member);
                                            } else {
                                                phi_3579_ = _e4611;
                                                phi_3604_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4627 = phi_3579_;
                                            let _e4629 = phi_3604_;
                                            let _e4633 = (bitcast<i32>(_e4629.member) != 0i);
                                            if _e4633 {
                                                if (_e4629.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4636 = local_10[_e4629.member_1];
                                                if (_e4629.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4642 = local_10[_e4629.member_1];
                                                if ((((_e4636[0] * _e4642[0]) + (_e4636[1] * _e4642[1])) + (_e4636[2] * _e4642[2])) < (((_e4613[0] * _e4613[0]) + (_e4613[1] * _e4613[1])) + (_e4613[2] * _e4613[2]))) {
                                                    if (_e4629.member_1 < 4u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e4665 = local_10[_e4629.member_1];
                                                    phi_3671_ = array<f64, 3>(_e4665[0], _e4665[1], _e4665[2]);
                                                } else {
                                                    phi_3671_ = _e4613;
                                                }
                                                let _e4671 = phi_3671_;
                                                phi_3582_ = _e4671;
                                            } else {
                                                phi_3582_ = array<f64, 3>();
                                            }
                                            let _e4673 = phi_3582_;
                                            continue;
                                            continuing {
                                                phi_3578_ = _e4627;
                                                phi_3581_ = _e4673;
                                                break if !(_e4633);
                                            }
                                        }
                                        let _e5829 = local_81;
                                        phi_3672_ = _e5829;
                                    } else {
                                        phi_3672_ = _e4475;
                                    }
                                    let _e4676 = phi_3672_;
                                    let _e4687 = (((_e4676[0] * _e4676[0]) + (_e4676[1] * _e4676[1])) + (_e4676[2] * _e4676[2]));
                                    if (_e4687 <= 2.2250738585072014e-308lf) {
                                        if (_e4687 > 0.0lf) {
                                            phi_3697_ = (bitcast<f64>(((4503599627370496lu >> bitcast<u64>(1lu)) + 2303426169912950784lu)) * 2.0lf);
                                        } else {
                                            phi_3697_ = 0.0lf;
                                        }
                                        let _e4750 = phi_3697_;
                                        phi_3761_ = _e4750;
                                    } else {
                                        phi_3704_ = type_26(0i, 5i);
                                        phi_3707_ = bitcast<f64>(((bitcast<u64>(_e4687) >> bitcast<u64>(1lu)) + 2303426169912950784lu));
                                        loop {
                                            let _e4695 = phi_3704_;
                                            let _e4697 = phi_3707_;
                                            local_47 = _e4697;
                                            if (_e4695.member < _e4695.member_1) {
                                                let _e4705 = (_e4695.member + 1i);
                                                if ((false == (_e4705 > _e4695.member)) != false) {
                                                    phi_3728_ = true;
                                                } else {
                                                    phi_3728_ = false;
                                                }
                                                let _e4710 = phi_3728_;
                                                if _e4710 {
                                                    phi_3734_ = type_27(0u, type_27().member_1);
                                                } else {
                                                    phi_3734_ = type_27(1u, _e4705);
                                                }
                                                let _e4716 = phi_3734_;
                                                if (bitcast<i32>(_e4716.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3705_ = type_26(_e4716.member_1, _e4695.member_1);
                                                phi_3748_ = type_27(1u, _e4695.member);
                                            } else {
                                                phi_3705_ = _e4695;
                                                phi_3748_ = type_27(0u, type_27().member_1);
                                            }
                                            let _e4726 = phi_3705_;
                                            let _e4728 = phi_3748_;
                                            let _e4731 = (bitcast<i32>(_e4728.member) != 0i);
                                            if _e4731 {
                                                phi_3708_ = (0.5lf * (_e4697 + (_e4687 / _e4697)));
                                            } else {
                                                phi_3708_ = f64();
                                            }
                                            let _e4736 = phi_3708_;
                                            continue;
                                            continuing {
                                                phi_3704_ = _e4726;
                                                phi_3707_ = _e4736;
                                                break if !(_e4731);
                                            }
                                        }
                                        let _e4741 = local_47;
                                        phi_3761_ = (_e4741 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e4752 = phi_3761_;
                                    let _e4760 = local_20.member[0u];
                                    if (_e4760[0] < 0.0lf) {
                                        phi_3779_ = -(_e4760[0]);
                                    } else {
                                        phi_3779_ = _e4760[0];
                                    }
                                    let _e4767 = phi_3779_;
                                    if (_e4760[1] < 0.0lf) {
                                        phi_3786_ = -(_e4760[1]);
                                    } else {
                                        phi_3786_ = _e4760[1];
                                    }
                                    let _e4771 = phi_3786_;
                                    if (_e4767 > _e4771) {
                                        phi_3791_ = _e4767;
                                    } else {
                                        phi_3791_ = _e4771;
                                    }
                                    let _e4774 = phi_3791_;
                                    if (_e4760[2] < 0.0lf) {
                                        phi_3798_ = -(_e4760[2]);
                                    } else {
                                        phi_3798_ = _e4760[2];
                                    }
                                    let _e4778 = phi_3798_;
                                    if (_e4774 > _e4778) {
                                        phi_3803_ = _e4774;
                                    } else {
                                        phi_3803_ = _e4778;
                                    }
                                    let _e4781 = phi_3803_;
                                    let _e4784 = local_20.member[1u];
                                    if (_e4784[0] < 0.0lf) {
                                        phi_3816_ = -(_e4784[0]);
                                    } else {
                                        phi_3816_ = _e4784[0];
                                    }
                                    let _e4791 = phi_3816_;
                                    if (_e4784[1] < 0.0lf) {
                                        phi_3823_ = -(_e4784[1]);
                                    } else {
                                        phi_3823_ = _e4784[1];
                                    }
                                    let _e4795 = phi_3823_;
                                    if (_e4791 > _e4795) {
                                        phi_3828_ = _e4791;
                                    } else {
                                        phi_3828_ = _e4795;
                                    }
                                    let _e4798 = phi_3828_;
                                    if (_e4784[2] < 0.0lf) {
                                        phi_3835_ = -(_e4784[2]);
                                    } else {
                                        phi_3835_ = _e4784[2];
                                    }
                                    let _e4802 = phi_3835_;
                                    if (_e4798 > _e4802) {
                                        phi_3840_ = _e4798;
                                    } else {
                                        phi_3840_ = _e4802;
                                    }
                                    let _e4805 = phi_3840_;
                                    if (_e4781 > _e4805) {
                                        phi_3845_ = _e4781;
                                    } else {
                                        phi_3845_ = _e4805;
                                    }
                                    let _e4808 = phi_3845_;
                                    let _e4810 = local_20.member_3;
                                    let _e4814 = local_20.member_1[0u];
                                    if (_e4814[0] < 0.0lf) {
                                        phi_3862_ = -(_e4814[0]);
                                    } else {
                                        phi_3862_ = _e4814[0];
                                    }
                                    let _e4821 = phi_3862_;
                                    if (_e4814[1] < 0.0lf) {
                                        phi_3869_ = -(_e4814[1]);
                                    } else {
                                        phi_3869_ = _e4814[1];
                                    }
                                    let _e4825 = phi_3869_;
                                    if (_e4821 > _e4825) {
                                        phi_3874_ = _e4821;
                                    } else {
                                        phi_3874_ = _e4825;
                                    }
                                    let _e4828 = phi_3874_;
                                    if (_e4814[2] < 0.0lf) {
                                        phi_3881_ = -(_e4814[2]);
                                    } else {
                                        phi_3881_ = _e4814[2];
                                    }
                                    let _e4832 = phi_3881_;
                                    if (_e4828 > _e4832) {
                                        phi_3886_ = _e4828;
                                    } else {
                                        phi_3886_ = _e4832;
                                    }
                                    let _e4835 = phi_3886_;
                                    let _e4838 = local_20.member_1[1u];
                                    if (_e4838[0] < 0.0lf) {
                                        phi_3900_ = -(_e4838[0]);
                                    } else {
                                        phi_3900_ = _e4838[0];
                                    }
                                    let _e4845 = phi_3900_;
                                    if (_e4838[1] < 0.0lf) {
                                        phi_3907_ = -(_e4838[1]);
                                    } else {
                                        phi_3907_ = _e4838[1];
                                    }
                                    let _e4849 = phi_3907_;
                                    if (_e4845 > _e4849) {
                                        phi_3912_ = _e4845;
                                    } else {
                                        phi_3912_ = _e4849;
                                    }
                                    let _e4852 = phi_3912_;
                                    if (_e4838[2] < 0.0lf) {
                                        phi_3919_ = -(_e4838[2]);
                                    } else {
                                        phi_3919_ = _e4838[2];
                                    }
                                    let _e4856 = phi_3919_;
                                    if (_e4852 > _e4856) {
                                        phi_3924_ = _e4852;
                                    } else {
                                        phi_3924_ = _e4856;
                                    }
                                    let _e4859 = phi_3924_;
                                    if (_e4835 > _e4859) {
                                        phi_3929_ = _e4835;
                                    } else {
                                        phi_3929_ = _e4859;
                                    }
                                    let _e4862 = phi_3929_;
                                    let _e4864 = local_20.member_3;
                                    let _e4868 = local_20.member_2[0u];
                                    if (_e4868[0] < 0.0lf) {
                                        phi_3946_ = -(_e4868[0]);
                                    } else {
                                        phi_3946_ = _e4868[0];
                                    }
                                    let _e4875 = phi_3946_;
                                    if (_e4868[1] < 0.0lf) {
                                        phi_3953_ = -(_e4868[1]);
                                    } else {
                                        phi_3953_ = _e4868[1];
                                    }
                                    let _e4879 = phi_3953_;
                                    if (_e4875 > _e4879) {
                                        phi_3958_ = _e4875;
                                    } else {
                                        phi_3958_ = _e4879;
                                    }
                                    let _e4882 = phi_3958_;
                                    if (_e4868[2] < 0.0lf) {
                                        phi_3965_ = -(_e4868[2]);
                                    } else {
                                        phi_3965_ = _e4868[2];
                                    }
                                    let _e4886 = phi_3965_;
                                    if (_e4882 > _e4886) {
                                        phi_3970_ = _e4882;
                                    } else {
                                        phi_3970_ = _e4886;
                                    }
                                    let _e4889 = phi_3970_;
                                    let _e4892 = local_20.member_2[1u];
                                    if (_e4892[0] < 0.0lf) {
                                        phi_3984_ = -(_e4892[0]);
                                    } else {
                                        phi_3984_ = _e4892[0];
                                    }
                                    let _e4899 = phi_3984_;
                                    if (_e4892[1] < 0.0lf) {
                                        phi_3991_ = -(_e4892[1]);
                                    } else {
                                        phi_3991_ = _e4892[1];
                                    }
                                    let _e4903 = phi_3991_;
                                    if (_e4899 > _e4903) {
                                        phi_3996_ = _e4899;
                                    } else {
                                        phi_3996_ = _e4903;
                                    }
                                    let _e4906 = phi_3996_;
                                    if (_e4892[2] < 0.0lf) {
                                        phi_4003_ = -(_e4892[2]);
                                    } else {
                                        phi_4003_ = _e4892[2];
                                    }
                                    let _e4910 = phi_4003_;
                                    if (_e4906 > _e4910) {
                                        phi_4008_ = _e4906;
                                    } else {
                                        phi_4008_ = _e4910;
                                    }
                                    let _e4913 = phi_4008_;
                                    if (_e4889 > _e4913) {
                                        phi_4013_ = _e4889;
                                    } else {
                                        phi_4013_ = _e4913;
                                    }
                                    let _e4916 = phi_4013_;
                                    let _e4918 = local_20.member_3;
                                    let _e4926 = local_20.member_3;
                                    let _e4936 = (((_e4752 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e4808 + _e4810) + (_e4862 + _e4864)) + (_e4916 + _e4918)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4926 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e457);
                                    if _e4936 {
                                        phi_4037_ = false;
                                    } else {
                                        phi_4037_ = true;
                                    }
                                    let _e4938 = phi_4037_;
                                    phi_4038_ = _e4938;
                                    phi_4039_ = _e4936;
                                } else {
                                    phi_4038_ = false;
                                    phi_4039_ = false;
                                }
                                let _e4940 = phi_4038_;
                                let _e4942 = phi_4039_;
                                local_48 = _e4942;
                                continue;
                                continuing {
                                    phi_3021_ = _e4309;
                                    break if !(_e4940);
                                }
                            }
                            let _e4945 = local_48;
                            if _e4945 {
                                phi_4044_ = type_71(1u, _e4282.member_1);
                                phi_4045_ = false;
                            } else {
                                phi_4044_ = type_71();
                                phi_4045_ = true;
                            }
                            let _e4948 = phi_4044_;
                            let _e4950 = phi_4045_;
                            if _e4950 {
                                phi_4050_ = type_71(2u, _e4282.member_1);
                                phi_4051_ = false;
                            } else {
                                phi_4050_ = type_71();
                                phi_4051_ = true;
                            }
                            let _e4953 = phi_4050_;
                            let _e4955 = phi_4051_;
                            phi_4053_ = _e4953;
                            phi_4054_ = _e4948;
                            phi_4055_ = _e4955;
                        } else {
                            phi_4053_ = type_71();
                            phi_4054_ = type_71(0u, type_71().member_1);
                            phi_4055_ = true;
                        }
                        let _e4957 = phi_4053_;
                        let _e4959 = phi_4054_;
                        let _e4961 = phi_4055_;
                        if _e4961 {
                            phi_4059_ = _e4959;
                        } else {
                            phi_4059_ = _e4957;
                        }
                        let _e4963 = phi_4059_;
                        phi_7398_ = _e4963;
                    } else {
                        if (_e556 < 0.0lf) {
                            phi_4070_ = -(_e556);
                        } else {
                            phi_4070_ = _e556;
                        }
                        let _e911 = phi_4070_;
                        if (_e579 < 0.0lf) {
                            phi_4076_ = -(_e579);
                        } else {
                            phi_4076_ = _e579;
                        }
                        let _e915 = phi_4076_;
                        if (_e911 > _e915) {
                            phi_4081_ = _e911;
                        } else {
                            phi_4081_ = _e915;
                        }
                        let _e918 = phi_4081_;
                        if (_e602 < 0.0lf) {
                            phi_4087_ = -(_e602);
                        } else {
                            phi_4087_ = _e602;
                        }
                        let _e922 = phi_4087_;
                        if (_e613 < 0.0lf) {
                            phi_4093_ = -(_e613);
                        } else {
                            phi_4093_ = _e613;
                        }
                        let _e926 = phi_4093_;
                        if (_e922 > _e926) {
                            phi_4098_ = _e922;
                        } else {
                            phi_4098_ = _e926;
                        }
                        let _e929 = phi_4098_;
                        if (_e918 > _e929) {
                            phi_4103_ = _e918;
                        } else {
                            phi_4103_ = _e929;
                        }
                        let _e932 = phi_4103_;
                        let _e936 = ((_e872 * f64(0.34f)) + (_e932 * (1.1102230246251565e-16lf * f64(256f))));
                        let _e937 = f64(0f);
                        let _e938 = f64(1f);
                        let _e939 = f64(3f);
                        let _e941 = (_e579 - (_e939 * _e556));
                        let _e942 = (_e602 - _e579);
                        let _e944 = ((_e939 * _e613) - _e602);
                        local_7[0u] = _e937;
                        local_7[1u] = _e938;
                        local_7[2u] = _e938;
                        local_7[3u] = _e938;
                        let _e951 = ((_e942 * _e942) - (_e941 * _e944));
                        if (_e951 > _e937) {
                            if (_e951 <= 2.2250738585072014e-308lf) {
                                if (_e951 > 0.0lf) {
                                    phi_4140_ = (bitcast<f64>(((4503599627370496lu >> bitcast<u64>(1lu)) + 2303426169912950784lu)) * 2.0lf);
                                } else {
                                    phi_4140_ = 0.0lf;
                                }
                                let _e1015 = phi_4140_;
                                phi_4204_ = _e1015;
                            } else {
                                phi_4147_ = type_26(0i, 5i);
                                phi_4150_ = bitcast<f64>(((bitcast<u64>(_e951) >> bitcast<u64>(1lu)) + 2303426169912950784lu));
                                loop {
                                    let _e960 = phi_4147_;
                                    let _e962 = phi_4150_;
                                    local_21 = _e962;
                                    if (_e960.member < _e960.member_1) {
                                        let _e970 = (_e960.member + 1i);
                                        if ((false == (_e970 > _e960.member)) != false) {
                                            phi_4171_ = true;
                                        } else {
                                            phi_4171_ = false;
                                        }
                                        let _e975 = phi_4171_;
                                        if _e975 {
                                            phi_4177_ = type_27(0u, type_27().member_1);
                                        } else {
                                            phi_4177_ = type_27(1u, _e970);
                                        }
                                        let _e981 = phi_4177_;
                                        if (bitcast<i32>(_e981.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_4148_ = type_26(_e981.member_1, _e960.member_1);
                                        phi_4191_ = type_27(1u, _e960.member);
                                    } else {
                                        phi_4148_ = _e960;
                                        phi_4191_ = type_27(0u, type_27().member_1);
                                    }
                                    let _e991 = phi_4148_;
                                    let _e993 = phi_4191_;
                                    let _e996 = (bitcast<i32>(_e993.member) != 0i);
                                    if _e996 {
                                        phi_4151_ = (0.5lf * (_e962 + (_e951 / _e962)));
                                    } else {
                                        phi_4151_ = f64();
                                    }
                                    let _e1001 = phi_4151_;
                                    continue;
                                    continuing {
                                        phi_4147_ = _e991;
                                        phi_4150_ = _e1001;
                                        break if !(_e996);
                                    }
                                }
                                let _e1006 = local_21;
                                phi_4204_ = (_e1006 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1017 = phi_4204_;
                            if (_e942 < _e937) {
                                phi_4210_ = -(_e1017);
                            } else {
                                phi_4210_ = _e1017;
                            }
                            let _e1021 = phi_4210_;
                            let _e1023 = -((_e942 + _e1021));
                            local_8[0u] = (_e1023 / (_e1023 + _e944));
                            local_8[1u] = (_e941 / (_e941 + _e1023));
                            let _e1032 = local_8[1u];
                            let _e1033 = local_8[0u];
                            if (_e1032 < _e1033) {
                                let _e1036 = local_8[1u];
                                let _e1038 = local_8[0u];
                                local_8[0u] = _e1036;
                                local_8[1u] = _e1038;
                            }
                            phi_4235_ = type_28(0u, 2u);
                            phi_4238_ = 1u;
                            loop {
                                let _e1042 = phi_4235_;
                                let _e1044 = phi_4238_;
                                local_49 = _e1044;
                                if (_e1042.member < _e1042.member_1) {
                                    phi_4236_ = type_28((_e1042.member + 1u), _e1042.member_1);
                                    phi_4261_ = type_28(1u, _e1042.member);
                                } else {
                                    phi_4236_ = _e1042;
                                    phi_4261_ = type_28(0u, type_28().member_1);
                                }
                                let _e1058 = phi_4236_;
                                let _e1060 = phi_4261_;
                                let _e1064 = (bitcast<i32>(_e1060.member) != 0i);
                                if _e1064 {
                                    if (_e1060.member_1 < 2u) {
                                    } else {
                                        return;
                                    }
                                    let _e1067 = local_8[_e1060.member_1];
                                    if (_e1067 > _e937) {
                                        if (_e1060.member_1 < 2u) {
                                        } else {
                                            return;
                                        }
                                        let _e1071 = local_8[_e1060.member_1];
                                        if (_e1071 < _e938) {
                                            if (_e1060.member_1 < 2u) {
                                            } else {
                                                return;
                                            }
                                            let _e1075 = local_8[_e1060.member_1];
                                            if (_e1044 < 4u) {
                                            } else {
                                                return;
                                            }
                                            local_7[_e1044] = _e1075;
                                            phi_4305_ = (_e1044 + 1u);
                                        } else {
                                            phi_4305_ = _e1044;
                                        }
                                        let _e1080 = phi_4305_;
                                        phi_4306_ = _e1080;
                                    } else {
                                        phi_4306_ = _e1044;
                                    }
                                    let _e1082 = phi_4306_;
                                    phi_4239_ = _e1082;
                                } else {
                                    phi_4239_ = u32();
                                }
                                let _e1084 = phi_4239_;
                                continue;
                                continuing {
                                    phi_4235_ = _e1058;
                                    phi_4238_ = _e1084;
                                    break if !(_e1064);
                                }
                            }
                            let _e5146 = local_49;
                            phi_4307_ = _e5146;
                        } else {
                            phi_4307_ = 1u;
                        }
                        let _e1087 = phi_4307_;
                        if (_e1087 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e1087] = _e938;
                        let _e1090 = local_7;
                        local_9 = _e1090;
                        phi_4327_ = type_28(0u, _e1087);
                        loop {
                            let _e1093 = phi_4327_;
                            if (_e1093.member < _e1093.member_1) {
                                phi_4328_ = type_28((_e1093.member + 1u), _e1093.member_1);
                                phi_4351_ = type_28(1u, _e1093.member);
                            } else {
                                phi_4328_ = _e1093;
                                phi_4351_ = type_28(0u, type_28().member_1);
                            }
                            let _e1107 = phi_4328_;
                            let _e1109 = phi_4351_;
                            if (bitcast<i32>(_e1109.member) != 0i) {
                                if (_e1109.member_1 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1116 = local_9[_e1109.member_1];
                                let _e1117 = (_e1109.member_1 + 1u);
                                if (_e1117 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1120 = local_9[_e1117];
                                let _e1122 = (f64(1f) - _e1116);
                                let _e1133 = ((((_e556 * _e1122) + (_e579 * _e1116)) * (_e1122 * _e1122)) + (((_e602 * _e1122) + (_e613 * _e1116)) * (_e1116 * _e1116)));
                                let _e1135 = (f64(1f) - _e1120);
                                let _e1146 = ((((_e556 * _e1135) + (_e579 * _e1120)) * (_e1135 * _e1135)) + (((_e602 * _e1135) + (_e613 * _e1120)) * (_e1120 * _e1120)));
                                if (_e1133 < 0.0lf) {
                                    phi_4405_ = -(_e1133);
                                } else {
                                    phi_4405_ = _e1133;
                                }
                                let _e1150 = phi_4405_;
                                let _e1151 = (_e1150 > _e936);
                                if (_e1146 < 0.0lf) {
                                    phi_4412_ = -(_e1146);
                                } else {
                                    phi_4412_ = _e1146;
                                }
                                let _e1155 = phi_4412_;
                                let _e1156 = (_e1155 > _e936);
                                let _e1157 = f64(0f);
                                if _e1151 {
                                    if _e1156 {
                                        let _e1160 = ((_e1133 > _e1157) != (_e1146 > _e1157));
                                        if _e1151 {
                                            if _e1156 {
                                                if _e1160 {
                                                    phi_4433_ = false;
                                                } else {
                                                    phi_4433_ = true;
                                                }
                                                let _e1162 = phi_4433_;
                                                phi_4434_ = _e1162;
                                            } else {
                                                phi_4434_ = false;
                                            }
                                            let _e1164 = phi_4434_;
                                            phi_4435_ = _e1164;
                                        } else {
                                            phi_4435_ = false;
                                        }
                                        let _e1166 = phi_4435_;
                                        phi_4436_ = _e1160;
                                        phi_4437_ = _e1160;
                                        phi_4438_ = false;
                                        phi_4439_ = _e1166;
                                    } else {
                                        phi_4436_ = bool();
                                        phi_4437_ = bool();
                                        phi_4438_ = true;
                                        phi_4439_ = false;
                                    }
                                    let _e1168 = phi_4436_;
                                    let _e1170 = phi_4437_;
                                    let _e1172 = phi_4438_;
                                    let _e1174 = phi_4439_;
                                    phi_4440_ = _e1168;
                                    phi_4441_ = _e1170;
                                    phi_4442_ = _e1172;
                                    phi_4443_ = _e1174;
                                } else {
                                    phi_4440_ = bool();
                                    phi_4441_ = bool();
                                    phi_4442_ = true;
                                    phi_4443_ = false;
                                }
                                let _e1176 = phi_4440_;
                                let _e1178 = phi_4441_;
                                let _e1180 = phi_4442_;
                                let _e1182 = phi_4443_;
                                if _e1180 {
                                    if _e1151 {
                                        phi_4453_ = _e1156;
                                    } else {
                                        phi_4453_ = false;
                                    }
                                    let _e1184 = phi_4453_;
                                    phi_4454_ = false;
                                    phi_4455_ = false;
                                    phi_4456_ = _e1184;
                                } else {
                                    phi_4454_ = _e1178;
                                    phi_4455_ = _e1176;
                                    phi_4456_ = _e1182;
                                }
                                let _e1186 = phi_4454_;
                                let _e1188 = phi_4455_;
                                let _e1190 = phi_4456_;
                                if _e1190 {
                                    phi_4462_ = type_72(f64(1f), _e1157, _e1186);
                                    phi_4463_ = false;
                                } else {
                                    phi_4462_ = type_72();
                                    phi_4463_ = true;
                                }
                                let _e1194 = phi_4462_;
                                let _e1196 = phi_4463_;
                                if _e1196 {
                                    if _e1151 {
                                        if (_e1133 < _e1157) {
                                            phi_4476_ = f64(-1f);
                                        } else {
                                            phi_4476_ = f64(1f);
                                        }
                                        let _e1201 = phi_4476_;
                                        let _e1202 = f64(0.00000000000022737368f);
                                        let _e1203 = f64(0.5f);
                                        let _e1204 = f64(3f);
                                        let _e1207 = (_e602 - _e579);
                                        phi_4489_ = type_28(0u, 64u);
                                        phi_4492_ = _e1120;
                                        phi_4494_ = _e1116;
                                        phi_4496_ = (_e1203 * (_e1116 + _e1120));
                                        loop {
                                            let _e1213 = phi_4489_;
                                            let _e1215 = phi_4492_;
                                            let _e1217 = phi_4494_;
                                            let _e1219 = phi_4496_;
                                            local_51 = _e1217;
                                            if (_e1213.member < _e1213.member_1) {
                                                phi_4490_ = type_28((_e1213.member + 1u), _e1213.member_1);
                                                phi_4519_ = type_28(1u, _e1213.member);
                                            } else {
                                                phi_4490_ = _e1213;
                                                phi_4519_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1233 = phi_4490_;
                                            let _e1235 = phi_4519_;
                                            if (bitcast<i32>(_e1235.member) != 0i) {
                                                let _e1240 = (f64(1f) - _e1219);
                                                let _e1253 = ((_e1201 * ((((_e556 * _e1240) + (_e579 * _e1219)) * (_e1240 * _e1240)) + (((_e602 * _e1240) + (_e613 * _e1219)) * (_e1219 * _e1219)))) - _e936);
                                                if (_e1253 > f64(0f)) {
                                                    phi_4546_ = _e1215;
                                                    phi_4547_ = _e1219;
                                                } else {
                                                    phi_4546_ = _e1219;
                                                    phi_4547_ = _e1217;
                                                }
                                                let _e1257 = phi_4546_;
                                                let _e1259 = phi_4547_;
                                                let _e1261 = ((_e1257 - _e1259) > _e1202);
                                                if _e1261 {
                                                    let _e1263 = (f64(1f) - _e1219);
                                                    let _e1275 = (-(_e1253) / (_e1201 * (((((_e579 - (_e1204 * _e556)) * _e1263) + (_e1207 * _e1219)) * _e1263) + (((_e1207 * _e1263) + (((_e1204 * _e613) - _e602) * _e1219)) * _e1219))));
                                                    if (_e1253 > f64(0f)) {
                                                        phi_4575_ = (_e1203 * _e1202);
                                                    } else {
                                                        phi_4575_ = -((_e1203 * _e1202));
                                                    }
                                                    let _e1282 = phi_4575_;
                                                    let _e1284 = ((_e1219 + _e1275) + _e1282);
                                                    if (_e1284 > _e1259) {
                                                        if (_e1284 < _e1257) {
                                                            if (_e1275 < 0.0lf) {
                                                                phi_4591_ = -(_e1275);
                                                            } else {
                                                                phi_4591_ = _e1275;
                                                            }
                                                            let _e1290 = phi_4591_;
                                                            if (_e1290 < (_e1203 * (_e1257 - _e1259))) {
                                                                phi_4598_ = false;
                                                            } else {
                                                                phi_4598_ = true;
                                                            }
                                                            let _e1295 = phi_4598_;
                                                            phi_4599_ = _e1295;
                                                        } else {
                                                            phi_4599_ = true;
                                                        }
                                                        let _e1297 = phi_4599_;
                                                        phi_4600_ = _e1297;
                                                    } else {
                                                        phi_4600_ = true;
                                                    }
                                                    let _e1299 = phi_4600_;
                                                    if _e1299 {
                                                        phi_4606_ = (_e1203 * (_e1259 + _e1257));
                                                    } else {
                                                        phi_4606_ = _e1284;
                                                    }
                                                    let _e1303 = phi_4606_;
                                                    phi_4607_ = _e1303;
                                                    phi_4608_ = false;
                                                } else {
                                                    phi_4607_ = f64();
                                                    phi_4608_ = true;
                                                }
                                                let _e1305 = phi_4607_;
                                                let _e1307 = phi_4608_;
                                                phi_4493_ = _e1257;
                                                phi_4495_ = _e1259;
                                                phi_4497_ = _e1305;
                                                phi_4609_ = _e1259;
                                                phi_4610_ = _e1261;
                                                phi_4611_ = _e1307;
                                            } else {
                                                phi_4493_ = f64();
                                                phi_4495_ = f64();
                                                phi_4497_ = f64();
                                                phi_4609_ = f64();
                                                phi_4610_ = false;
                                                phi_4611_ = false;
                                            }
                                            let _e1309 = phi_4493_;
                                            let _e1311 = phi_4495_;
                                            let _e1313 = phi_4497_;
                                            let _e1315 = phi_4609_;
                                            let _e1317 = phi_4610_;
                                            let _e1319 = phi_4611_;
                                            local_22 = _e1319;
                                            local_50 = _e1315;
                                            continue;
                                            continuing {
                                                phi_4489_ = _e1233;
                                                phi_4492_ = _e1309;
                                                phi_4494_ = _e1311;
                                                phi_4496_ = _e1313;
                                                break if !(_e1317);
                                            }
                                        }
                                        let _e1322 = local_22;
                                        if _e1322 {
                                            let _e5195 = local_50;
                                            phi_4615_ = _e5195;
                                        } else {
                                            let _e5197 = local_51;
                                            phi_4615_ = _e5197;
                                        }
                                        let _e1324 = phi_4615_;
                                        phi_4616_ = _e1324;
                                    } else {
                                        phi_4616_ = _e1116;
                                    }
                                    let _e1326 = phi_4616_;
                                    if _e1156 {
                                        phi_4624_ = type_28(0u, 64u);
                                        phi_4627_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1330 = phi_4624_;
                                            let _e1332 = phi_4627_;
                                            if (_e1330.member < _e1330.member_1) {
                                                phi_4625_ = type_28((_e1330.member + 1u), _e1330.member_1);
                                                phi_4650_ = type_28(1u, _e1330.member);
                                            } else {
                                                phi_4625_ = _e1330;
                                                phi_4650_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1346 = phi_4625_;
                                            let _e1348 = phi_4650_;
                                            if (bitcast<i32>(_e1348.member) != 0i) {
                                                let _e1352 = (_e1326 + _e1332);
                                                if (_e1352 < _e1120) {
                                                    let _e1355 = (f64(1f) - _e1352);
                                                    let _e1366 = ((((_e556 * _e1355) + (_e579 * _e1352)) * (_e1355 * _e1355)) + (((_e602 * _e1355) + (_e613 * _e1352)) * (_e1352 * _e1352)));
                                                    let _e1368 = (f64(1f) - _e1326);
                                                    let _e1379 = ((((_e556 * _e1368) + (_e579 * _e1326)) * (_e1368 * _e1368)) + (((_e602 * _e1368) + (_e613 * _e1326)) * (_e1326 * _e1326)));
                                                    if (_e1366 < 0.0lf) {
                                                        phi_4693_ = -(_e1366);
                                                    } else {
                                                        phi_4693_ = _e1366;
                                                    }
                                                    let _e1383 = phi_4693_;
                                                    if (_e1383 > _e936) {
                                                        if (_e1379 < 0.0lf) {
                                                            phi_4703_ = -(_e1379);
                                                        } else {
                                                            phi_4703_ = _e1379;
                                                        }
                                                        let _e1388 = phi_4703_;
                                                        if (_e1388 > _e936) {
                                                            phi_4713_ = ((_e1366 > f64(0f)) == (_e1379 > f64(0f)));
                                                        } else {
                                                            phi_4713_ = false;
                                                        }
                                                        let _e1396 = phi_4713_;
                                                        phi_4715_ = !(_e1396);
                                                    } else {
                                                        phi_4715_ = false;
                                                    }
                                                    let _e1399 = phi_4715_;
                                                    if _e1399 {
                                                        phi_4720_ = f64();
                                                        phi_4721_ = false;
                                                    } else {
                                                        phi_4720_ = (_e1332 + _e1332);
                                                        phi_4721_ = true;
                                                    }
                                                    let _e1402 = phi_4720_;
                                                    let _e1404 = phi_4721_;
                                                    phi_4722_ = _e1402;
                                                    phi_4723_ = _e1404;
                                                    phi_4724_ = _e1399;
                                                    phi_4725_ = false;
                                                } else {
                                                    phi_4722_ = f64();
                                                    phi_4723_ = false;
                                                    phi_4724_ = false;
                                                    phi_4725_ = true;
                                                }
                                                let _e1406 = phi_4722_;
                                                let _e1408 = phi_4723_;
                                                let _e1410 = phi_4724_;
                                                let _e1412 = phi_4725_;
                                                phi_4726_ = _e1352;
                                                phi_4628_ = _e1406;
                                                phi_4727_ = _e1408;
                                                phi_4728_ = _e1410;
                                                phi_4729_ = _e1412;
                                                phi_4730_ = false;
                                            } else {
                                                phi_4726_ = f64();
                                                phi_4628_ = f64();
                                                phi_4727_ = false;
                                                phi_4728_ = false;
                                                phi_4729_ = false;
                                                phi_4730_ = true;
                                            }
                                            let _e1414 = phi_4726_;
                                            let _e1416 = phi_4628_;
                                            let _e1418 = phi_4727_;
                                            let _e1420 = phi_4728_;
                                            let _e1422 = phi_4729_;
                                            let _e1424 = phi_4730_;
                                            local_23 = _e1420;
                                            local_52 = _e1422;
                                            local_53 = _e1424;
                                            local_54 = _e1414;
                                            continue;
                                            continuing {
                                                phi_4624_ = _e1346;
                                                phi_4627_ = _e1416;
                                                break if !(_e1418);
                                            }
                                        }
                                        let _e1427 = local_23;
                                        if _e1427 {
                                            phi_4734_ = false;
                                            phi_4735_ = false;
                                        } else {
                                            let _e5222 = local_52;
                                            phi_4734_ = _e5222;
                                            let _e5225 = local_53;
                                            phi_4735_ = _e5225;
                                        }
                                        let _e1429 = phi_4734_;
                                        let _e1431 = phi_4735_;
                                        if _e1429 {
                                            phi_4739_ = true;
                                        } else {
                                            phi_4739_ = _e1431;
                                        }
                                        let _e1433 = phi_4739_;
                                        if _e1433 {
                                            phi_4743_ = _e1120;
                                        } else {
                                            let _e5229 = local_54;
                                            phi_4743_ = _e5229;
                                        }
                                        let _e1435 = phi_4743_;
                                        phi_4744_ = _e1435;
                                    } else {
                                        phi_4744_ = _e1120;
                                    }
                                    let _e1437 = phi_4744_;
                                    phi_4746_ = type_72(_e1326, _e1437, _e1188);
                                } else {
                                    phi_4746_ = _e1194;
                                }
                                let _e1440 = phi_4746_;
                                if (_e1440.member > _e1440.member_1) {
                                    phi_7354_ = f64();
                                    phi_7355_ = true;
                                    phi_7356_ = false;
                                    phi_7357_ = false;
                                    phi_7358_ = false;
                                } else {
                                    let _e1448 = ((_e1440.member_1 - _e1440.member) * f64(0.5f));
                                    let _e1449 = (_e1440.member + _e1448);
                                    let _e1452 = (_e1448 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1454 = local_20.member_3;
                                    let _e1457 = local_20.member[0u];
                                    if (_e1457[0] < 0.0lf) {
                                        phi_4777_ = -(_e1457[0]);
                                    } else {
                                        phi_4777_ = _e1457[0];
                                    }
                                    let _e1464 = phi_4777_;
                                    if (_e1457[1] < 0.0lf) {
                                        phi_4784_ = -(_e1457[1]);
                                    } else {
                                        phi_4784_ = _e1457[1];
                                    }
                                    let _e1468 = phi_4784_;
                                    if (_e1464 > _e1468) {
                                        phi_4789_ = _e1464;
                                    } else {
                                        phi_4789_ = _e1468;
                                    }
                                    let _e1471 = phi_4789_;
                                    if (_e1457[2] < 0.0lf) {
                                        phi_4796_ = -(_e1457[2]);
                                    } else {
                                        phi_4796_ = _e1457[2];
                                    }
                                    let _e1475 = phi_4796_;
                                    if (_e1471 > _e1475) {
                                        phi_4801_ = _e1471;
                                    } else {
                                        phi_4801_ = _e1475;
                                    }
                                    let _e1478 = phi_4801_;
                                    let _e1480 = local_20.member[1u];
                                    if (_e1480[0] < 0.0lf) {
                                        phi_4814_ = -(_e1480[0]);
                                    } else {
                                        phi_4814_ = _e1480[0];
                                    }
                                    let _e1487 = phi_4814_;
                                    if (_e1480[1] < 0.0lf) {
                                        phi_4821_ = -(_e1480[1]);
                                    } else {
                                        phi_4821_ = _e1480[1];
                                    }
                                    let _e1491 = phi_4821_;
                                    if (_e1487 > _e1491) {
                                        phi_4826_ = _e1487;
                                    } else {
                                        phi_4826_ = _e1491;
                                    }
                                    let _e1494 = phi_4826_;
                                    if (_e1480[2] < 0.0lf) {
                                        phi_4833_ = -(_e1480[2]);
                                    } else {
                                        phi_4833_ = _e1480[2];
                                    }
                                    let _e1498 = phi_4833_;
                                    if (_e1494 > _e1498) {
                                        phi_4838_ = _e1494;
                                    } else {
                                        phi_4838_ = _e1498;
                                    }
                                    let _e1501 = phi_4838_;
                                    if (_e1478 > _e1501) {
                                        phi_4843_ = _e1478;
                                    } else {
                                        phi_4843_ = _e1501;
                                    }
                                    let _e1504 = phi_4843_;
                                    let _e1507 = local_20.member[0u];
                                    let _e1512 = local_20.member[1u];
                                    let _e1522 = (_e1507[0] + ((_e1512[0] - _e1507[0]) * _e1449));
                                    let _e1523 = (_e1507[1] + ((_e1512[1] - _e1507[1]) * _e1449));
                                    let _e1524 = (_e1507[2] + ((_e1512[2] - _e1507[2]) * _e1449));
                                    let _e1526 = local_20.member[1u];
                                    let _e1531 = local_20.member[0u];
                                    let _e1535 = (_e1526[0] - _e1531[0]);
                                    let _e1536 = (_e1526[1] - _e1531[1]);
                                    let _e1537 = (_e1526[2] - _e1531[2]);
                                    if (_e1535 < 0.0lf) {
                                        phi_4902_ = -(_e1535);
                                    } else {
                                        phi_4902_ = _e1535;
                                    }
                                    let _e1541 = phi_4902_;
                                    if (_e1536 < 0.0lf) {
                                        phi_4908_ = -(_e1536);
                                    } else {
                                        phi_4908_ = _e1536;
                                    }
                                    let _e1545 = phi_4908_;
                                    if (_e1541 > _e1545) {
                                        phi_4913_ = _e1541;
                                    } else {
                                        phi_4913_ = _e1545;
                                    }
                                    let _e1548 = phi_4913_;
                                    if (_e1537 < 0.0lf) {
                                        phi_4919_ = -(_e1537);
                                    } else {
                                        phi_4919_ = _e1537;
                                    }
                                    let _e1552 = phi_4919_;
                                    if (_e1548 > _e1552) {
                                        phi_4924_ = _e1548;
                                    } else {
                                        phi_4924_ = _e1552;
                                    }
                                    let _e1555 = phi_4924_;
                                    let _e1563 = ((((_e1452 * _e1555) * f64(1.01f)) + ((_e1504 + _e1454) * (1.1102230246251565e-16lf * f64(8f)))) + _e1454);
                                    if (_e1522 < 0.0lf) {
                                        phi_4938_ = -(_e1522);
                                    } else {
                                        phi_4938_ = _e1522;
                                    }
                                    let _e1567 = phi_4938_;
                                    if (_e1523 < 0.0lf) {
                                        phi_4944_ = -(_e1523);
                                    } else {
                                        phi_4944_ = _e1523;
                                    }
                                    let _e1571 = phi_4944_;
                                    if (_e1567 > _e1571) {
                                        phi_4949_ = _e1567;
                                    } else {
                                        phi_4949_ = _e1571;
                                    }
                                    let _e1574 = phi_4949_;
                                    if (_e1524 < 0.0lf) {
                                        phi_4955_ = -(_e1524);
                                    } else {
                                        phi_4955_ = _e1524;
                                    }
                                    let _e1578 = phi_4955_;
                                    if (_e1574 > _e1578) {
                                        phi_4960_ = _e1574;
                                    } else {
                                        phi_4960_ = _e1578;
                                    }
                                    let _e1581 = phi_4960_;
                                    local_3 = type_50(array<f64, 3>(_e1522, _e1523, _e1524), _e1563, (_e1581 + _e1563));
                                    let _e1587 = local_20.member_3;
                                    let _e1589 = local_20.member_1[0u];
                                    if (_e1589[0] < 0.0lf) {
                                        phi_4986_ = -(_e1589[0]);
                                    } else {
                                        phi_4986_ = _e1589[0];
                                    }
                                    let _e1596 = phi_4986_;
                                    if (_e1589[1] < 0.0lf) {
                                        phi_4993_ = -(_e1589[1]);
                                    } else {
                                        phi_4993_ = _e1589[1];
                                    }
                                    let _e1600 = phi_4993_;
                                    if (_e1596 > _e1600) {
                                        phi_4998_ = _e1596;
                                    } else {
                                        phi_4998_ = _e1600;
                                    }
                                    let _e1603 = phi_4998_;
                                    if (_e1589[2] < 0.0lf) {
                                        phi_5005_ = -(_e1589[2]);
                                    } else {
                                        phi_5005_ = _e1589[2];
                                    }
                                    let _e1607 = phi_5005_;
                                    if (_e1603 > _e1607) {
                                        phi_5010_ = _e1603;
                                    } else {
                                        phi_5010_ = _e1607;
                                    }
                                    let _e1610 = phi_5010_;
                                    let _e1612 = local_20.member_1[1u];
                                    if (_e1612[0] < 0.0lf) {
                                        phi_5023_ = -(_e1612[0]);
                                    } else {
                                        phi_5023_ = _e1612[0];
                                    }
                                    let _e1619 = phi_5023_;
                                    if (_e1612[1] < 0.0lf) {
                                        phi_5030_ = -(_e1612[1]);
                                    } else {
                                        phi_5030_ = _e1612[1];
                                    }
                                    let _e1623 = phi_5030_;
                                    if (_e1619 > _e1623) {
                                        phi_5035_ = _e1619;
                                    } else {
                                        phi_5035_ = _e1623;
                                    }
                                    let _e1626 = phi_5035_;
                                    if (_e1612[2] < 0.0lf) {
                                        phi_5042_ = -(_e1612[2]);
                                    } else {
                                        phi_5042_ = _e1612[2];
                                    }
                                    let _e1630 = phi_5042_;
                                    if (_e1626 > _e1630) {
                                        phi_5047_ = _e1626;
                                    } else {
                                        phi_5047_ = _e1630;
                                    }
                                    let _e1633 = phi_5047_;
                                    if (_e1610 > _e1633) {
                                        phi_5052_ = _e1610;
                                    } else {
                                        phi_5052_ = _e1633;
                                    }
                                    let _e1636 = phi_5052_;
                                    let _e1639 = local_20.member_1[0u];
                                    let _e1644 = local_20.member_1[1u];
                                    let _e1654 = (_e1639[0] + ((_e1644[0] - _e1639[0]) * _e1449));
                                    let _e1655 = (_e1639[1] + ((_e1644[1] - _e1639[1]) * _e1449));
                                    let _e1656 = (_e1639[2] + ((_e1644[2] - _e1639[2]) * _e1449));
                                    let _e1658 = local_20.member_1[1u];
                                    let _e1663 = local_20.member_1[0u];
                                    let _e1667 = (_e1658[0] - _e1663[0]);
                                    let _e1668 = (_e1658[1] - _e1663[1]);
                                    let _e1669 = (_e1658[2] - _e1663[2]);
                                    if (_e1667 < 0.0lf) {
                                        phi_5111_ = -(_e1667);
                                    } else {
                                        phi_5111_ = _e1667;
                                    }
                                    let _e1673 = phi_5111_;
                                    if (_e1668 < 0.0lf) {
                                        phi_5117_ = -(_e1668);
                                    } else {
                                        phi_5117_ = _e1668;
                                    }
                                    let _e1677 = phi_5117_;
                                    if (_e1673 > _e1677) {
                                        phi_5122_ = _e1673;
                                    } else {
                                        phi_5122_ = _e1677;
                                    }
                                    let _e1680 = phi_5122_;
                                    if (_e1669 < 0.0lf) {
                                        phi_5128_ = -(_e1669);
                                    } else {
                                        phi_5128_ = _e1669;
                                    }
                                    let _e1684 = phi_5128_;
                                    if (_e1680 > _e1684) {
                                        phi_5133_ = _e1680;
                                    } else {
                                        phi_5133_ = _e1684;
                                    }
                                    let _e1687 = phi_5133_;
                                    let _e1695 = ((((_e1452 * _e1687) * f64(1.01f)) + ((_e1636 + _e1587) * (1.1102230246251565e-16lf * f64(8f)))) + _e1587);
                                    if (_e1654 < 0.0lf) {
                                        phi_5147_ = -(_e1654);
                                    } else {
                                        phi_5147_ = _e1654;
                                    }
                                    let _e1699 = phi_5147_;
                                    if (_e1655 < 0.0lf) {
                                        phi_5153_ = -(_e1655);
                                    } else {
                                        phi_5153_ = _e1655;
                                    }
                                    let _e1703 = phi_5153_;
                                    if (_e1699 > _e1703) {
                                        phi_5158_ = _e1699;
                                    } else {
                                        phi_5158_ = _e1703;
                                    }
                                    let _e1706 = phi_5158_;
                                    if (_e1656 < 0.0lf) {
                                        phi_5164_ = -(_e1656);
                                    } else {
                                        phi_5164_ = _e1656;
                                    }
                                    let _e1710 = phi_5164_;
                                    if (_e1706 > _e1710) {
                                        phi_5169_ = _e1706;
                                    } else {
                                        phi_5169_ = _e1710;
                                    }
                                    let _e1713 = phi_5169_;
                                    local_4 = type_50(array<f64, 3>(_e1654, _e1655, _e1656), _e1695, (_e1713 + _e1695));
                                    let _e1719 = local_20.member_3;
                                    let _e1721 = local_20.member_2[0u];
                                    if (_e1721[0] < 0.0lf) {
                                        phi_5195_ = -(_e1721[0]);
                                    } else {
                                        phi_5195_ = _e1721[0];
                                    }
                                    let _e1728 = phi_5195_;
                                    if (_e1721[1] < 0.0lf) {
                                        phi_5202_ = -(_e1721[1]);
                                    } else {
                                        phi_5202_ = _e1721[1];
                                    }
                                    let _e1732 = phi_5202_;
                                    if (_e1728 > _e1732) {
                                        phi_5207_ = _e1728;
                                    } else {
                                        phi_5207_ = _e1732;
                                    }
                                    let _e1735 = phi_5207_;
                                    if (_e1721[2] < 0.0lf) {
                                        phi_5214_ = -(_e1721[2]);
                                    } else {
                                        phi_5214_ = _e1721[2];
                                    }
                                    let _e1739 = phi_5214_;
                                    if (_e1735 > _e1739) {
                                        phi_5219_ = _e1735;
                                    } else {
                                        phi_5219_ = _e1739;
                                    }
                                    let _e1742 = phi_5219_;
                                    let _e1744 = local_20.member_2[1u];
                                    if (_e1744[0] < 0.0lf) {
                                        phi_5232_ = -(_e1744[0]);
                                    } else {
                                        phi_5232_ = _e1744[0];
                                    }
                                    let _e1751 = phi_5232_;
                                    if (_e1744[1] < 0.0lf) {
                                        phi_5239_ = -(_e1744[1]);
                                    } else {
                                        phi_5239_ = _e1744[1];
                                    }
                                    let _e1755 = phi_5239_;
                                    if (_e1751 > _e1755) {
                                        phi_5244_ = _e1751;
                                    } else {
                                        phi_5244_ = _e1755;
                                    }
                                    let _e1758 = phi_5244_;
                                    if (_e1744[2] < 0.0lf) {
                                        phi_5251_ = -(_e1744[2]);
                                    } else {
                                        phi_5251_ = _e1744[2];
                                    }
                                    let _e1762 = phi_5251_;
                                    if (_e1758 > _e1762) {
                                        phi_5256_ = _e1758;
                                    } else {
                                        phi_5256_ = _e1762;
                                    }
                                    let _e1765 = phi_5256_;
                                    if (_e1742 > _e1765) {
                                        phi_5261_ = _e1742;
                                    } else {
                                        phi_5261_ = _e1765;
                                    }
                                    let _e1768 = phi_5261_;
                                    let _e1771 = local_20.member_2[0u];
                                    let _e1776 = local_20.member_2[1u];
                                    let _e1786 = (_e1771[0] + ((_e1776[0] - _e1771[0]) * _e1449));
                                    let _e1787 = (_e1771[1] + ((_e1776[1] - _e1771[1]) * _e1449));
                                    let _e1788 = (_e1771[2] + ((_e1776[2] - _e1771[2]) * _e1449));
                                    let _e1790 = local_20.member_2[1u];
                                    let _e1795 = local_20.member_2[0u];
                                    let _e1799 = (_e1790[0] - _e1795[0]);
                                    let _e1800 = (_e1790[1] - _e1795[1]);
                                    let _e1801 = (_e1790[2] - _e1795[2]);
                                    if (_e1799 < 0.0lf) {
                                        phi_5320_ = -(_e1799);
                                    } else {
                                        phi_5320_ = _e1799;
                                    }
                                    let _e1805 = phi_5320_;
                                    if (_e1800 < 0.0lf) {
                                        phi_5326_ = -(_e1800);
                                    } else {
                                        phi_5326_ = _e1800;
                                    }
                                    let _e1809 = phi_5326_;
                                    if (_e1805 > _e1809) {
                                        phi_5331_ = _e1805;
                                    } else {
                                        phi_5331_ = _e1809;
                                    }
                                    let _e1812 = phi_5331_;
                                    if (_e1801 < 0.0lf) {
                                        phi_5337_ = -(_e1801);
                                    } else {
                                        phi_5337_ = _e1801;
                                    }
                                    let _e1816 = phi_5337_;
                                    if (_e1812 > _e1816) {
                                        phi_5342_ = _e1812;
                                    } else {
                                        phi_5342_ = _e1816;
                                    }
                                    let _e1819 = phi_5342_;
                                    let _e1827 = ((((_e1452 * _e1819) * f64(1.01f)) + ((_e1768 + _e1719) * (1.1102230246251565e-16lf * f64(8f)))) + _e1719);
                                    if (_e1786 < 0.0lf) {
                                        phi_5356_ = -(_e1786);
                                    } else {
                                        phi_5356_ = _e1786;
                                    }
                                    let _e1831 = phi_5356_;
                                    if (_e1787 < 0.0lf) {
                                        phi_5362_ = -(_e1787);
                                    } else {
                                        phi_5362_ = _e1787;
                                    }
                                    let _e1835 = phi_5362_;
                                    if (_e1831 > _e1835) {
                                        phi_5367_ = _e1831;
                                    } else {
                                        phi_5367_ = _e1835;
                                    }
                                    let _e1838 = phi_5367_;
                                    if (_e1788 < 0.0lf) {
                                        phi_5373_ = -(_e1788);
                                    } else {
                                        phi_5373_ = _e1788;
                                    }
                                    let _e1842 = phi_5373_;
                                    if (_e1838 > _e1842) {
                                        phi_5378_ = _e1838;
                                    } else {
                                        phi_5378_ = _e1842;
                                    }
                                    let _e1845 = phi_5378_;
                                    local_5 = type_50(array<f64, 3>(_e1786, _e1787, _e1788), _e1827, (_e1845 + _e1827));
                                    let _e1850 = local_4.member;
                                    let _e1855 = local_5.member;
                                    let _e1861 = ((_e1850[1] * _e1855[2]) - (_e1850[2] * _e1855[1]));
                                    let _e1864 = ((_e1850[2] * _e1855[0]) - (_e1850[0] * _e1855[2]));
                                    let _e1867 = ((_e1850[0] * _e1855[1]) - (_e1850[1] * _e1855[0]));
                                    if (_e1861 < 0.0lf) {
                                        phi_5427_ = -(_e1861);
                                    } else {
                                        phi_5427_ = _e1861;
                                    }
                                    let _e1871 = phi_5427_;
                                    if (_e1864 < 0.0lf) {
                                        phi_5433_ = -(_e1864);
                                    } else {
                                        phi_5433_ = _e1864;
                                    }
                                    let _e1875 = phi_5433_;
                                    if (_e1871 > _e1875) {
                                        if (_e1861 < 0.0lf) {
                                            phi_5443_ = -(_e1861);
                                        } else {
                                            phi_5443_ = _e1861;
                                        }
                                        let _e1893 = phi_5443_;
                                        if (_e1867 < 0.0lf) {
                                            phi_5449_ = -(_e1867);
                                        } else {
                                            phi_5449_ = _e1867;
                                        }
                                        let _e1897 = phi_5449_;
                                        if (_e1893 > _e1897) {
                                            phi_5454_ = 2u;
                                            phi_5455_ = 1u;
                                        } else {
                                            phi_5454_ = 1u;
                                            phi_5455_ = 0u;
                                        }
                                        let _e1900 = phi_5454_;
                                        let _e1902 = phi_5455_;
                                        phi_5474_ = _e1900;
                                        phi_5475_ = _e1902;
                                    } else {
                                        if (_e1864 < 0.0lf) {
                                            phi_5461_ = -(_e1864);
                                        } else {
                                            phi_5461_ = _e1864;
                                        }
                                        let _e1880 = phi_5461_;
                                        if (_e1867 < 0.0lf) {
                                            phi_5467_ = -(_e1867);
                                        } else {
                                            phi_5467_ = _e1867;
                                        }
                                        let _e1884 = phi_5467_;
                                        if (_e1880 > _e1884) {
                                            phi_5472_ = 0u;
                                            phi_5473_ = 2u;
                                        } else {
                                            phi_5472_ = 1u;
                                            phi_5473_ = 0u;
                                        }
                                        let _e1887 = phi_5472_;
                                        let _e1889 = phi_5473_;
                                        phi_5474_ = _e1887;
                                        phi_5475_ = _e1889;
                                    }
                                    let _e1904 = phi_5474_;
                                    let _e1906 = phi_5475_;
                                    if (_e1906 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1910 = local_4.member[_e1906];
                                    if (_e1904 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1914 = local_5.member[_e1904];
                                    if (_e1904 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1919 = local_4.member[_e1904];
                                    if (_e1906 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1923 = local_5.member[_e1906];
                                    let _e1925 = ((_e1910 * _e1914) - (_e1919 * _e1923));
                                    let _e1926 = f64(1f);
                                    let _e1928 = local_4.member_1;
                                    let _e1930 = local_5.member_2;
                                    let _e1933 = local_4.member_2;
                                    let _e1935 = local_5.member_1;
                                    let _e1941 = local_4.member_2;
                                    let _e1943 = local_5.member_2;
                                    let _e1952 = local_4.member_2;
                                    let _e1955 = local_5.member_2;
                                    let _e1959 = (((((_e1928 * _e1930) + (_e1933 * _e1935)) * f64(2.01f)) + ((_e1941 * _e1943) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1926 + _e1952) * (_e1926 + _e1955))));
                                    if (_e1925 < 0.0lf) {
                                        phi_5546_ = -(_e1925);
                                    } else {
                                        phi_5546_ = _e1925;
                                    }
                                    let _e1963 = phi_5546_;
                                    if (_e1963 > _e1959) {
                                        if (_e1925 < f64(0f)) {
                                            phi_5558_ = f64(-1f);
                                        } else {
                                            phi_5558_ = f64(1f);
                                        }
                                        let _e1970 = phi_5558_;
                                        if (_e1906 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1974 = local_3.member[_e1906];
                                        if (_e1904 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1978 = local_5.member[_e1904];
                                        if (_e1904 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1983 = local_3.member[_e1904];
                                        if (_e1906 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1987 = local_5.member[_e1906];
                                        let _e1990 = f64(1f);
                                        let _e1992 = local_3.member_1;
                                        let _e1994 = local_5.member_2;
                                        let _e1997 = local_3.member_2;
                                        let _e1999 = local_5.member_1;
                                        let _e2005 = local_3.member_2;
                                        let _e2007 = local_5.member_2;
                                        let _e2016 = local_3.member_2;
                                        let _e2019 = local_5.member_2;
                                        let _e2023 = (((((_e1992 * _e1994) + (_e1997 * _e1999)) * f64(2.01f)) + ((_e2005 * _e2007) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1990 + _e2016) * (_e1990 + _e2019))));
                                        if (_e1906 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2027 = local_4.member[_e1906];
                                        if (_e1904 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2031 = local_3.member[_e1904];
                                        if (_e1904 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2036 = local_4.member[_e1904];
                                        if (_e1906 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2040 = local_3.member[_e1906];
                                        let _e2043 = f64(1f);
                                        let _e2045 = local_4.member_1;
                                        let _e2047 = local_3.member_2;
                                        let _e2050 = local_4.member_2;
                                        let _e2052 = local_3.member_1;
                                        let _e2058 = local_4.member_2;
                                        let _e2060 = local_3.member_2;
                                        let _e2069 = local_4.member_2;
                                        let _e2072 = local_3.member_2;
                                        let _e2076 = (((((_e2045 * _e2047) + (_e2050 * _e2052)) * f64(2.01f)) + ((_e2058 * _e2060) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2043 + _e2069) * (_e2043 + _e2072))));
                                        let _e2077 = (_e1925 * _e1970);
                                        let _e2078 = (((_e1974 * _e1978) - (_e1983 * _e1987)) * _e1970);
                                        let _e2079 = (((_e2027 * _e2031) - (_e2036 * _e2040)) * _e1970);
                                        if (_e2077 < 0.0lf) {
                                            phi_5697_ = -(_e2077);
                                        } else {
                                            phi_5697_ = _e2077;
                                        }
                                        let _e2083 = phi_5697_;
                                        if (_e2078 < 0.0lf) {
                                            phi_5703_ = -(_e2078);
                                        } else {
                                            phi_5703_ = _e2078;
                                        }
                                        let _e2087 = phi_5703_;
                                        if (_e2079 < 0.0lf) {
                                            phi_5710_ = -(_e2079);
                                        } else {
                                            phi_5710_ = _e2079;
                                        }
                                        let _e2092 = phi_5710_;
                                        let _e2096 = (((_e2083 + _e2087) + _e2092) * (1.1102230246251565e-16lf * f64(4f)));
                                        local_6[0u].member = _e2078;
                                        local_6[0u].member_1 = _e2023;
                                        local_6[1u].member = _e2079;
                                        local_6[1u].member_1 = _e2076;
                                        local_6[2u].member = (_e2077 - _e2078);
                                        local_6[2u].member_1 = ((_e1959 + _e2023) + _e2096);
                                        local_6[3u].member = (_e2077 - _e2079);
                                        local_6[3u].member_1 = ((_e1959 + _e2076) + _e2096);
                                        phi_5754_ = type_28(0u, 4u);
                                        phi_5757_ = true;
                                        loop {
                                            let _e2117 = phi_5754_;
                                            let _e2119 = phi_5757_;
                                            local_25 = _e2119;
                                            if (_e2117.member < _e2117.member_1) {
                                                phi_5755_ = type_28((_e2117.member + 1u), _e2117.member_1);
                                                phi_5780_ = type_28(1u, _e2117.member);
                                            } else {
                                                phi_5755_ = _e2117;
                                                phi_5780_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e2133 = phi_5755_;
                                            let _e2135 = phi_5780_;
                                            if (bitcast<i32>(_e2135.member) != 0i) {
                                                if (_e2135.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e2143 = local_6[_e2135.member_1].member;
                                                let _e2146 = local_6[_e2135.member_1].member_1;
                                                let _e2148 = (_e2143 < -(_e2146));
                                                if _e2148 {
                                                    phi_5807_ = bool();
                                                    phi_5808_ = false;
                                                } else {
                                                    phi_5807_ = (_e2119 && (_e2143 > _e2146));
                                                    phi_5808_ = true;
                                                }
                                                let _e2152 = phi_5807_;
                                                let _e2154 = phi_5808_;
                                                phi_5758_ = _e2152;
                                                phi_5809_ = _e2154;
                                                phi_5810_ = _e2148;
                                            } else {
                                                phi_5758_ = bool();
                                                phi_5809_ = false;
                                                phi_5810_ = false;
                                            }
                                            let _e2156 = phi_5758_;
                                            let _e2158 = phi_5809_;
                                            let _e2160 = phi_5810_;
                                            local_24 = _e2160;
                                            continue;
                                            continuing {
                                                phi_5754_ = _e2133;
                                                phi_5757_ = _e2156;
                                                break if !(_e2158);
                                            }
                                        }
                                        let _e2163 = local_24;
                                        if _e2163 {
                                            phi_5814_ = false;
                                        } else {
                                            phi_5814_ = true;
                                        }
                                        let _e2165 = phi_5814_;
                                        if _e2165 {
                                            let _e2167 = local_25;
                                            if _e2167 {
                                                phi_5821_ = 1u;
                                            } else {
                                                phi_5821_ = 2u;
                                            }
                                            let _e2169 = phi_5821_;
                                            phi_5822_ = _e2169;
                                            phi_5823_ = false;
                                        } else {
                                            phi_5822_ = u32();
                                            phi_5823_ = true;
                                        }
                                        let _e2171 = phi_5822_;
                                        let _e2173 = phi_5823_;
                                        phi_5824_ = _e2171;
                                        phi_5825_ = 0u;
                                        phi_5826_ = _e2173;
                                    } else {
                                        phi_5824_ = u32();
                                        phi_5825_ = 2u;
                                        phi_5826_ = true;
                                    }
                                    let _e2175 = phi_5824_;
                                    let _e2177 = phi_5825_;
                                    let _e2179 = phi_5826_;
                                    if _e2179 {
                                        phi_5830_ = _e2177;
                                    } else {
                                        phi_5830_ = _e2175;
                                    }
                                    let _e2181 = phi_5830_;
                                    let _e2182 = (_e2181 == 0u);
                                    if _e2182 {
                                        phi_7350_ = f64();
                                        phi_7351_ = false;
                                        phi_7352_ = false;
                                        phi_7353_ = false;
                                    } else {
                                        if (_e2181 == 1u) {
                                            if _e1440.member_2 {
                                                if ((_e1440.member_1 - _e1440.member) <= f64(0.0000005f)) {
                                                    phi_5851_ = false;
                                                } else {
                                                    phi_5851_ = true;
                                                }
                                                let _e2191 = phi_5851_;
                                                phi_5852_ = _e2191;
                                            } else {
                                                phi_5852_ = true;
                                            }
                                            let _e2193 = phi_5852_;
                                            phi_5853_ = _e2193;
                                        } else {
                                            phi_5853_ = true;
                                        }
                                        let _e2195 = phi_5853_;
                                        if _e2195 {
                                            let _e2201 = local_20.member[0u];
                                            let _e2207 = local_20.member_1[0u];
                                            let _e2213 = local_20.member_2[0u];
                                            let _e2217 = (_e2201[0] - _e2207[0]);
                                            let _e2218 = (_e2201[1] - _e2207[1]);
                                            let _e2219 = (_e2201[2] - _e2207[2]);
                                            local_1 = array<array<f64, 3>, 4>(_e2201, array<f64, 3>(_e2217, _e2218, _e2219), array<f64, 3>((_e2201[0] - _e2213[0]), (_e2201[1] - _e2213[1]), (_e2201[2] - _e2213[2])), array<f64, 3>((_e2217 - _e2213[0]), (_e2218 - _e2213[1]), (_e2219 - _e2213[2])));
                                            let _e2232 = local_20.member[1u];
                                            let _e2238 = local_20.member_1[1u];
                                            let _e2244 = local_20.member_2[1u];
                                            let _e2248 = (_e2232[0] - _e2238[0]);
                                            let _e2249 = (_e2232[1] - _e2238[1]);
                                            let _e2250 = (_e2232[2] - _e2238[2]);
                                            local_2 = array<array<f64, 3>, 4>(_e2232, array<f64, 3>(_e2248, _e2249, _e2250), array<f64, 3>((_e2232[0] - _e2244[0]), (_e2232[1] - _e2244[1]), (_e2232[2] - _e2244[2])), array<f64, 3>((_e2248 - _e2244[0]), (_e2249 - _e2244[1]), (_e2250 - _e2244[2])));
                                            let _e2263 = local_20.member[0u];
                                            if (_e2263[0] < 0.0lf) {
                                                phi_6050_ = -(_e2263[0]);
                                            } else {
                                                phi_6050_ = _e2263[0];
                                            }
                                            let _e2270 = phi_6050_;
                                            if (_e2263[1] < 0.0lf) {
                                                phi_6057_ = -(_e2263[1]);
                                            } else {
                                                phi_6057_ = _e2263[1];
                                            }
                                            let _e2274 = phi_6057_;
                                            if (_e2270 > _e2274) {
                                                phi_6062_ = _e2270;
                                            } else {
                                                phi_6062_ = _e2274;
                                            }
                                            let _e2277 = phi_6062_;
                                            if (_e2263[2] < 0.0lf) {
                                                phi_6069_ = -(_e2263[2]);
                                            } else {
                                                phi_6069_ = _e2263[2];
                                            }
                                            let _e2281 = phi_6069_;
                                            if (_e2277 > _e2281) {
                                                phi_6074_ = _e2277;
                                            } else {
                                                phi_6074_ = _e2281;
                                            }
                                            let _e2284 = phi_6074_;
                                            let _e2287 = local_20.member[1u];
                                            if (_e2287[0] < 0.0lf) {
                                                phi_6087_ = -(_e2287[0]);
                                            } else {
                                                phi_6087_ = _e2287[0];
                                            }
                                            let _e2294 = phi_6087_;
                                            if (_e2287[1] < 0.0lf) {
                                                phi_6094_ = -(_e2287[1]);
                                            } else {
                                                phi_6094_ = _e2287[1];
                                            }
                                            let _e2298 = phi_6094_;
                                            if (_e2294 > _e2298) {
                                                phi_6099_ = _e2294;
                                            } else {
                                                phi_6099_ = _e2298;
                                            }
                                            let _e2301 = phi_6099_;
                                            if (_e2287[2] < 0.0lf) {
                                                phi_6106_ = -(_e2287[2]);
                                            } else {
                                                phi_6106_ = _e2287[2];
                                            }
                                            let _e2305 = phi_6106_;
                                            if (_e2301 > _e2305) {
                                                phi_6111_ = _e2301;
                                            } else {
                                                phi_6111_ = _e2305;
                                            }
                                            let _e2308 = phi_6111_;
                                            if (_e2284 > _e2308) {
                                                phi_6116_ = _e2284;
                                            } else {
                                                phi_6116_ = _e2308;
                                            }
                                            let _e2311 = phi_6116_;
                                            let _e2313 = local_20.member_3;
                                            let _e2317 = local_20.member_1[0u];
                                            if (_e2317[0] < 0.0lf) {
                                                phi_6133_ = -(_e2317[0]);
                                            } else {
                                                phi_6133_ = _e2317[0];
                                            }
                                            let _e2324 = phi_6133_;
                                            if (_e2317[1] < 0.0lf) {
                                                phi_6140_ = -(_e2317[1]);
                                            } else {
                                                phi_6140_ = _e2317[1];
                                            }
                                            let _e2328 = phi_6140_;
                                            if (_e2324 > _e2328) {
                                                phi_6145_ = _e2324;
                                            } else {
                                                phi_6145_ = _e2328;
                                            }
                                            let _e2331 = phi_6145_;
                                            if (_e2317[2] < 0.0lf) {
                                                phi_6152_ = -(_e2317[2]);
                                            } else {
                                                phi_6152_ = _e2317[2];
                                            }
                                            let _e2335 = phi_6152_;
                                            if (_e2331 > _e2335) {
                                                phi_6157_ = _e2331;
                                            } else {
                                                phi_6157_ = _e2335;
                                            }
                                            let _e2338 = phi_6157_;
                                            let _e2341 = local_20.member_1[1u];
                                            if (_e2341[0] < 0.0lf) {
                                                phi_6171_ = -(_e2341[0]);
                                            } else {
                                                phi_6171_ = _e2341[0];
                                            }
                                            let _e2348 = phi_6171_;
                                            if (_e2341[1] < 0.0lf) {
                                                phi_6178_ = -(_e2341[1]);
                                            } else {
                                                phi_6178_ = _e2341[1];
                                            }
                                            let _e2352 = phi_6178_;
                                            if (_e2348 > _e2352) {
                                                phi_6183_ = _e2348;
                                            } else {
                                                phi_6183_ = _e2352;
                                            }
                                            let _e2355 = phi_6183_;
                                            if (_e2341[2] < 0.0lf) {
                                                phi_6190_ = -(_e2341[2]);
                                            } else {
                                                phi_6190_ = _e2341[2];
                                            }
                                            let _e2359 = phi_6190_;
                                            if (_e2355 > _e2359) {
                                                phi_6195_ = _e2355;
                                            } else {
                                                phi_6195_ = _e2359;
                                            }
                                            let _e2362 = phi_6195_;
                                            if (_e2338 > _e2362) {
                                                phi_6200_ = _e2338;
                                            } else {
                                                phi_6200_ = _e2362;
                                            }
                                            let _e2365 = phi_6200_;
                                            let _e2367 = local_20.member_3;
                                            let _e2371 = local_20.member_2[0u];
                                            if (_e2371[0] < 0.0lf) {
                                                phi_6217_ = -(_e2371[0]);
                                            } else {
                                                phi_6217_ = _e2371[0];
                                            }
                                            let _e2378 = phi_6217_;
                                            if (_e2371[1] < 0.0lf) {
                                                phi_6224_ = -(_e2371[1]);
                                            } else {
                                                phi_6224_ = _e2371[1];
                                            }
                                            let _e2382 = phi_6224_;
                                            if (_e2378 > _e2382) {
                                                phi_6229_ = _e2378;
                                            } else {
                                                phi_6229_ = _e2382;
                                            }
                                            let _e2385 = phi_6229_;
                                            if (_e2371[2] < 0.0lf) {
                                                phi_6236_ = -(_e2371[2]);
                                            } else {
                                                phi_6236_ = _e2371[2];
                                            }
                                            let _e2389 = phi_6236_;
                                            if (_e2385 > _e2389) {
                                                phi_6241_ = _e2385;
                                            } else {
                                                phi_6241_ = _e2389;
                                            }
                                            let _e2392 = phi_6241_;
                                            let _e2395 = local_20.member_2[1u];
                                            if (_e2395[0] < 0.0lf) {
                                                phi_6255_ = -(_e2395[0]);
                                            } else {
                                                phi_6255_ = _e2395[0];
                                            }
                                            let _e2402 = phi_6255_;
                                            if (_e2395[1] < 0.0lf) {
                                                phi_6262_ = -(_e2395[1]);
                                            } else {
                                                phi_6262_ = _e2395[1];
                                            }
                                            let _e2406 = phi_6262_;
                                            if (_e2402 > _e2406) {
                                                phi_6267_ = _e2402;
                                            } else {
                                                phi_6267_ = _e2406;
                                            }
                                            let _e2409 = phi_6267_;
                                            if (_e2395[2] < 0.0lf) {
                                                phi_6274_ = -(_e2395[2]);
                                            } else {
                                                phi_6274_ = _e2395[2];
                                            }
                                            let _e2413 = phi_6274_;
                                            if (_e2409 > _e2413) {
                                                phi_6279_ = _e2409;
                                            } else {
                                                phi_6279_ = _e2413;
                                            }
                                            let _e2416 = phi_6279_;
                                            if (_e2392 > _e2416) {
                                                phi_6284_ = _e2392;
                                            } else {
                                                phi_6284_ = _e2416;
                                            }
                                            let _e2419 = phi_6284_;
                                            let _e2421 = local_20.member_3;
                                            let _e2429 = local_20.member_3;
                                            phi_6304_ = type_28(0u, 48u);
                                            phi_6307_ = _e1440.member;
                                            loop {
                                                let _e2438 = phi_6304_;
                                                let _e2440 = phi_6307_;
                                                local_65 = _e2440;
                                                local_32 = _e2440;
                                                local_33 = _e2440;
                                                local_34 = _e2440;
                                                if (_e2438.member < _e2438.member_1) {
                                                    phi_6305_ = type_28((_e2438.member + 1u), _e2438.member_1);
                                                    phi_6330_ = type_28(1u, _e2438.member);
                                                } else {
                                                    phi_6305_ = _e2438;
                                                    phi_6330_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e2454 = phi_6305_;
                                                let _e2456 = phi_6330_;
                                                if (bitcast<i32>(_e2456.member) != 0i) {
                                                    let _e2462 = local_20.member[0u];
                                                    let _e2468 = local_20.member[1u];
                                                    let _e2478 = (_e2462[0] + ((_e2468[0] - _e2462[0]) * _e2440));
                                                    let _e2479 = (_e2462[1] + ((_e2468[1] - _e2462[1]) * _e2440));
                                                    let _e2480 = (_e2462[2] + ((_e2468[2] - _e2462[2]) * _e2440));
                                                    let _e2483 = local_20.member_1[0u];
                                                    let _e2489 = local_20.member_1[1u];
                                                    let _e2499 = (_e2483[0] + ((_e2489[0] - _e2483[0]) * _e2440));
                                                    let _e2500 = (_e2483[1] + ((_e2489[1] - _e2483[1]) * _e2440));
                                                    let _e2501 = (_e2483[2] + ((_e2489[2] - _e2483[2]) * _e2440));
                                                    let _e2504 = local_20.member_2[0u];
                                                    let _e2510 = local_20.member_2[1u];
                                                    let _e2520 = (_e2504[0] + ((_e2510[0] - _e2504[0]) * _e2440));
                                                    let _e2521 = (_e2504[1] + ((_e2510[1] - _e2504[1]) * _e2440));
                                                    let _e2522 = (_e2504[2] + ((_e2510[2] - _e2504[2]) * _e2440));
                                                    let _e2527 = (((_e2499 * _e2499) + (_e2500 * _e2500)) + (_e2501 * _e2501));
                                                    let _e2532 = (((_e2499 * _e2520) + (_e2500 * _e2521)) + (_e2501 * _e2522));
                                                    let _e2537 = (((_e2520 * _e2520) + (_e2521 * _e2521)) + (_e2522 * _e2522));
                                                    let _e2542 = (((_e2478 * _e2499) + (_e2479 * _e2500)) + (_e2480 * _e2501));
                                                    let _e2547 = (((_e2478 * _e2520) + (_e2479 * _e2521)) + (_e2480 * _e2522));
                                                    let _e2550 = ((_e2527 * _e2537) - (_e2532 * _e2532));
                                                    let _e2551 = f64(0f);
                                                    let _e2552 = f64(1f);
                                                    let _e2556 = (((_e2542 * _e2537) - (_e2547 * _e2532)) / _e2550);
                                                    let _e2560 = (((_e2547 * _e2527) - (_e2542 * _e2532)) / _e2550);
                                                    if (_e2556 >= _e2551) {
                                                        if (_e2560 >= _e2551) {
                                                            if (_e2556 <= _e2552) {
                                                                phi_6486_ = (_e2560 <= _e2552);
                                                                phi_6487_ = false;
                                                            } else {
                                                                phi_6486_ = bool();
                                                                phi_6487_ = true;
                                                            }
                                                            let _e2566 = phi_6486_;
                                                            let _e2568 = phi_6487_;
                                                            phi_6488_ = _e2566;
                                                            phi_6489_ = _e2568;
                                                        } else {
                                                            phi_6488_ = bool();
                                                            phi_6489_ = true;
                                                        }
                                                        let _e2570 = phi_6488_;
                                                        let _e2572 = phi_6489_;
                                                        phi_6490_ = _e2570;
                                                        phi_6491_ = _e2572;
                                                    } else {
                                                        phi_6490_ = bool();
                                                        phi_6491_ = true;
                                                    }
                                                    let _e2574 = phi_6490_;
                                                    let _e2576 = phi_6491_;
                                                    if _e2576 {
                                                        let _e2577 = (_e2550 > _e2551);
                                                        if _e2577 {
                                                            phi_6521_ = false;
                                                        } else {
                                                            phi_6521_ = true;
                                                        }
                                                        let _e2579 = phi_6521_;
                                                        phi_6522_ = false;
                                                        phi_6523_ = _e2579;
                                                        phi_6524_ = _e2577;
                                                    } else {
                                                        phi_6522_ = true;
                                                        phi_6523_ = false;
                                                        phi_6524_ = false;
                                                    }
                                                    let _e2581 = phi_6522_;
                                                    let _e2583 = phi_6523_;
                                                    let _e2585 = phi_6524_;
                                                    if _e2581 {
                                                        if (_e2550 > _e2551) {
                                                            if _e2574 {
                                                                phi_6548_ = array<f64, 3>((_e2478 - ((_e2499 * _e2556) + (_e2520 * _e2560))), (_e2479 - ((_e2500 * _e2556) + (_e2521 * _e2560))), (_e2480 - ((_e2501 * _e2556) + (_e2522 * _e2560))));
                                                                phi_6549_ = false;
                                                            } else {
                                                                phi_6548_ = array<f64, 3>();
                                                                phi_6549_ = true;
                                                            }
                                                            let _e2601 = phi_6548_;
                                                            let _e2603 = phi_6549_;
                                                            phi_6550_ = _e2601;
                                                            phi_6551_ = false;
                                                            phi_6552_ = _e2603;
                                                        } else {
                                                            phi_6550_ = array<f64, 3>();
                                                            phi_6551_ = true;
                                                            phi_6552_ = false;
                                                        }
                                                        let _e2605 = phi_6550_;
                                                        let _e2607 = phi_6551_;
                                                        let _e2609 = phi_6552_;
                                                        phi_6553_ = _e2605;
                                                        phi_6554_ = _e2607;
                                                        phi_6555_ = _e2609;
                                                    } else {
                                                        phi_6553_ = array<f64, 3>();
                                                        phi_6554_ = _e2583;
                                                        phi_6555_ = _e2585;
                                                    }
                                                    let _e2611 = phi_6553_;
                                                    let _e2613 = phi_6554_;
                                                    let _e2615 = phi_6555_;
                                                    if _e2613 {
                                                        phi_6559_ = true;
                                                    } else {
                                                        phi_6559_ = _e2615;
                                                    }
                                                    let _e2617 = phi_6559_;
                                                    if _e2617 {
                                                        let _e2618 = (_e2478 - _e2499);
                                                        let _e2619 = (_e2479 - _e2500);
                                                        let _e2620 = (_e2480 - _e2501);
                                                        let _e2631 = ((((_e2478 * _e2499) + (_e2479 * _e2500)) + (_e2480 * _e2501)) / (((_e2499 * _e2499) + (_e2500 * _e2500)) + (_e2501 * _e2501)));
                                                        if (_e2631 > f64(0f)) {
                                                            if (_e2631 < f64(1f)) {
                                                                phi_6592_ = _e2631;
                                                            } else {
                                                                phi_6592_ = f64(1f);
                                                            }
                                                            let _e2639 = phi_6592_;
                                                            phi_6594_ = _e2639;
                                                        } else {
                                                            phi_6594_ = f64(0f);
                                                        }
                                                        let _e2641 = phi_6594_;
                                                        let _e2658 = ((((_e2478 * _e2520) + (_e2479 * _e2521)) + (_e2480 * _e2522)) / (((_e2520 * _e2520) + (_e2521 * _e2521)) + (_e2522 * _e2522)));
                                                        if (_e2658 > f64(0f)) {
                                                            if (_e2658 < f64(1f)) {
                                                                phi_6624_ = _e2658;
                                                            } else {
                                                                phi_6624_ = f64(1f);
                                                            }
                                                            let _e2666 = phi_6624_;
                                                            phi_6626_ = _e2666;
                                                        } else {
                                                            phi_6626_ = f64(0f);
                                                        }
                                                        let _e2668 = phi_6626_;
                                                        let _e2685 = ((((_e2618 * _e2520) + (_e2619 * _e2521)) + (_e2620 * _e2522)) / (((_e2520 * _e2520) + (_e2521 * _e2521)) + (_e2522 * _e2522)));
                                                        if (_e2685 > f64(0f)) {
                                                            if (_e2685 < f64(1f)) {
                                                                phi_6656_ = _e2685;
                                                            } else {
                                                                phi_6656_ = f64(1f);
                                                            }
                                                            let _e2693 = phi_6656_;
                                                            phi_6658_ = _e2693;
                                                        } else {
                                                            phi_6658_ = f64(0f);
                                                        }
                                                        let _e2695 = phi_6658_;
                                                        let _e2702 = (_e2478 - _e2520);
                                                        let _e2703 = (_e2479 - _e2521);
                                                        let _e2704 = (_e2480 - _e2522);
                                                        let _e2715 = ((((_e2702 * _e2499) + (_e2703 * _e2500)) + (_e2704 * _e2501)) / (((_e2499 * _e2499) + (_e2500 * _e2500)) + (_e2501 * _e2501)));
                                                        if (_e2715 > f64(0f)) {
                                                            if (_e2715 < f64(1f)) {
                                                                phi_6691_ = _e2715;
                                                            } else {
                                                                phi_6691_ = f64(1f);
                                                            }
                                                            let _e2723 = phi_6691_;
                                                            phi_6693_ = _e2723;
                                                        } else {
                                                            phi_6693_ = f64(0f);
                                                        }
                                                        let _e2725 = phi_6693_;
                                                        local[0u] = array<f64, 3>((_e2478 - (_e2499 * _e2641)), (_e2479 - (_e2500 * _e2641)), (_e2480 - (_e2501 * _e2641)));
                                                        local[1u] = array<f64, 3>((_e2478 - (_e2520 * _e2668)), (_e2479 - (_e2521 * _e2668)), (_e2480 - (_e2522 * _e2668)));
                                                        local[2u] = array<f64, 3>((_e2618 - (_e2520 * _e2695)), (_e2619 - (_e2521 * _e2695)), (_e2620 - (_e2522 * _e2695)));
                                                        local[3u] = array<f64, 3>((_e2702 - (_e2499 * _e2725)), (_e2703 - (_e2500 * _e2725)), (_e2704 - (_e2501 * _e2725)));
                                                        let _e2741 = local[0u];
                                                        phi_6848_ = type_28(1u, 4u);
                                                        phi_6851_ = array<f64, 3>(_e2741[0], _e2741[1], _e2741[2]);
                                                        loop {
                                                            let _e2747 = phi_6848_;
                                                            let _e2749 = phi_6851_;
                                                            local_55 = _e2749;
                                                            if (_e2747.member < _e2747.member_1) {
                                                                phi_6849_ = type_28((_e2747.member + 1u), _e2747.member_1);
                                                                phi_6874_ = type_28(1u, _e2747.member);
                                                            } else {
                                                                phi_6849_ = _e2747;
                                                                phi_6874_ = type_28(0u, type_28().member_1);
                                                            }
                                                            let _e2763 = phi_6849_;
                                                            let _e2765 = phi_6874_;
                                                            let _e2769 = (bitcast<i32>(_e2765.member) != 0i);
                                                            if _e2769 {
                                                                if (_e2765.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2772 = local[_e2765.member_1];
                                                                if (_e2765.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2778 = local[_e2765.member_1];
                                                                if ((((_e2772[0] * _e2778[0]) + (_e2772[1] * _e2778[1])) + (_e2772[2] * _e2778[2])) < (((_e2749[0] * _e2749[0]) + (_e2749[1] * _e2749[1])) + (_e2749[2] * _e2749[2]))) {
                                                                    if (_e2765.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2801 = local[_e2765.member_1];
                                                                    phi_6941_ = array<f64, 3>(_e2801[0], _e2801[1], _e2801[2]);
                                                                } else {
                                                                    phi_6941_ = _e2749;
                                                                }
                                                                let _e2807 = phi_6941_;
                                                                phi_6852_ = _e2807;
                                                            } else {
                                                                phi_6852_ = array<f64, 3>();
                                                            }
                                                            let _e2809 = phi_6852_;
                                                            continue;
                                                            continuing {
                                                                phi_6848_ = _e2763;
                                                                phi_6851_ = _e2809;
                                                                break if !(_e2769);
                                                            }
                                                        }
                                                        let _e5406 = local_55;
                                                        phi_6942_ = _e5406;
                                                    } else {
                                                        phi_6942_ = _e2611;
                                                    }
                                                    let _e2812 = phi_6942_;
                                                    if (_e2812[0] < 0.0lf) {
                                                        phi_6949_ = -(_e2812[0]);
                                                    } else {
                                                        phi_6949_ = _e2812[0];
                                                    }
                                                    let _e2817 = phi_6949_;
                                                    if (_e2812[1] < 0.0lf) {
                                                        phi_6956_ = -(_e2812[1]);
                                                    } else {
                                                        phi_6956_ = _e2812[1];
                                                    }
                                                    let _e2822 = phi_6956_;
                                                    if (_e2812[2] < 0.0lf) {
                                                        phi_6964_ = -(_e2812[2]);
                                                    } else {
                                                        phi_6964_ = _e2812[2];
                                                    }
                                                    let _e2828 = phi_6964_;
                                                    let _e2829 = ((_e2817 + _e2822) + _e2828);
                                                    if (_e2829 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2829) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2835 = (f64(1f) / _e2829);
                                                            let _e2837 = (_e2812[0] * _e2835);
                                                            let _e2839 = (_e2812[1] * _e2835);
                                                            let _e2841 = (_e2812[2] * _e2835);
                                                            let _e2846 = (((_e2837 * _e2837) + (_e2839 * _e2839)) + (_e2841 * _e2841));
                                                            if (_e2846 <= 2.2250738585072014e-308lf) {
                                                                if (_e2846 > 0.0lf) {
                                                                    phi_7002_ = (bitcast<f64>(((4503599627370496lu >> bitcast<u64>(1lu)) + 2303426169912950784lu)) * 2.0lf);
                                                                } else {
                                                                    phi_7002_ = 0.0lf;
                                                                }
                                                                let _e2909 = phi_7002_;
                                                                phi_7066_ = _e2909;
                                                            } else {
                                                                phi_7009_ = type_26(0i, 5i);
                                                                phi_7012_ = bitcast<f64>(((bitcast<u64>(_e2846) >> bitcast<u64>(1lu)) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2854 = phi_7009_;
                                                                    let _e2856 = phi_7012_;
                                                                    local_26 = _e2856;
                                                                    if (_e2854.member < _e2854.member_1) {
                                                                        let _e2864 = (_e2854.member + 1i);
                                                                        if ((false == (_e2864 > _e2854.member)) != false) {
                                                                            phi_7033_ = true;
                                                                        } else {
                                                                            phi_7033_ = false;
                                                                        }
                                                                        let _e2869 = phi_7033_;
                                                                        if _e2869 {
                                                                            phi_7039_ = type_27(0u, type_27().member_1);
                                                                        } else {
                                                                            phi_7039_ = type_27(1u, _e2864);
                                                                        }
                                                                        let _e2875 = phi_7039_;
                                                                        if (bitcast<i32>(_e2875.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_7010_ = type_26(_e2875.member_1, _e2854.member_1);
                                                                        phi_7053_ = type_27(1u, _e2854.member);
                                                                    } else {
                                                                        phi_7010_ = _e2854;
                                                                        phi_7053_ = type_27(0u, type_27().member_1);
                                                                    }
                                                                    let _e2885 = phi_7010_;
                                                                    let _e2887 = phi_7053_;
                                                                    let _e2890 = (bitcast<i32>(_e2887.member) != 0i);
                                                                    if _e2890 {
                                                                        phi_7013_ = (0.5lf * (_e2856 + (_e2846 / _e2856)));
                                                                    } else {
                                                                        phi_7013_ = f64();
                                                                    }
                                                                    let _e2895 = phi_7013_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7009_ = _e2885;
                                                                        phi_7012_ = _e2895;
                                                                        break if !(_e2890);
                                                                    }
                                                                }
                                                                let _e2900 = local_26;
                                                                phi_7066_ = (_e2900 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2911 = phi_7066_;
                                                            phi_7079_ = type_28(0u, 4u);
                                                            phi_7082_ = f64(2f);
                                                            loop {
                                                                let _e2923 = phi_7079_;
                                                                let _e2925 = phi_7082_;
                                                                local_28 = _e2925;
                                                                local_29 = _e2925;
                                                                local_30 = _e2925;
                                                                local_56 = _e2925;
                                                                local_57 = _e2925;
                                                                if (_e2923.member < _e2923.member_1) {
                                                                    phi_7080_ = type_28((_e2923.member + 1u), _e2923.member_1);
                                                                    phi_7105_ = type_28(1u, _e2923.member);
                                                                } else {
                                                                    phi_7080_ = _e2923;
                                                                    phi_7105_ = type_28(0u, type_28().member_1);
                                                                }
                                                                let _e2939 = phi_7080_;
                                                                let _e2941 = phi_7105_;
                                                                if (bitcast<i32>(_e2941.member) != 0i) {
                                                                    if (_e2941.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2948 = local_1[_e2941.member_1];
                                                                    let _e2956 = (((_e2837 * _e2948[0]) + (_e2839 * _e2948[1])) + (_e2841 * _e2948[2]));
                                                                    if (_e2941.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2959 = local_2[_e2941.member_1];
                                                                    let _e2967 = (((_e2837 * _e2959[0]) + (_e2839 * _e2959[1])) + (_e2841 * _e2959[2]));
                                                                    if (_e2956 < 0.0lf) {
                                                                        phi_7156_ = -(_e2956);
                                                                    } else {
                                                                        phi_7156_ = _e2956;
                                                                    }
                                                                    let _e2971 = phi_7156_;
                                                                    if (_e2967 < 0.0lf) {
                                                                        phi_7162_ = -(_e2967);
                                                                    } else {
                                                                        phi_7162_ = _e2967;
                                                                    }
                                                                    let _e2975 = phi_7162_;
                                                                    let _e2980 = (((((((((_e2311 + _e2313) + (_e2365 + _e2367)) + (_e2419 + _e2421)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2429 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2911) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2971 + _e2975) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2956 > _e2980) {
                                                                        if (_e2967 > _e2980) {
                                                                            phi_7176_ = false;
                                                                        } else {
                                                                            phi_7176_ = true;
                                                                        }
                                                                        let _e2984 = phi_7176_;
                                                                        phi_7177_ = _e2984;
                                                                    } else {
                                                                        phi_7177_ = true;
                                                                    }
                                                                    let _e2986 = phi_7177_;
                                                                    if _e2986 {
                                                                        let _e2990 = ((_e2956 + ((_e2967 - _e2956) * _e2440)) > _e2980);
                                                                        if _e2990 {
                                                                            if (_e2967 < _e2956) {
                                                                                let _e2999 = (((_e2956 - _e2980) / (_e2956 - _e2967)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                if (_e2925 < _e2999) {
                                                                                    phi_7204_ = _e2925;
                                                                                } else {
                                                                                    phi_7204_ = _e2999;
                                                                                }
                                                                                let _e3002 = phi_7204_;
                                                                                phi_7205_ = _e3002;
                                                                            } else {
                                                                                phi_7205_ = _e2925;
                                                                            }
                                                                            let _e3004 = phi_7205_;
                                                                            phi_7206_ = _e3004;
                                                                        } else {
                                                                            phi_7206_ = f64();
                                                                        }
                                                                        let _e3006 = phi_7206_;
                                                                        phi_7207_ = _e3006;
                                                                        phi_7208_ = _e2990;
                                                                    } else {
                                                                        phi_7207_ = _e2925;
                                                                        phi_7208_ = true;
                                                                    }
                                                                    let _e3008 = phi_7207_;
                                                                    let _e3010 = phi_7208_;
                                                                    phi_7083_ = _e3008;
                                                                    phi_7209_ = _e3010;
                                                                    phi_7210_ = false;
                                                                } else {
                                                                    phi_7083_ = f64();
                                                                    phi_7209_ = false;
                                                                    phi_7210_ = true;
                                                                }
                                                                let _e3012 = phi_7083_;
                                                                let _e3014 = phi_7209_;
                                                                let _e3016 = phi_7210_;
                                                                local_27 = _e3016;
                                                                continue;
                                                                continuing {
                                                                    phi_7079_ = _e2939;
                                                                    phi_7082_ = _e3012;
                                                                    break if !(_e3014);
                                                                }
                                                            }
                                                            let _e3019 = local_27;
                                                            if _e3019 {
                                                                let _e3021 = local_28;
                                                                let _e3022 = (_e3021 > _e1440.member_1);
                                                                if _e3022 {
                                                                    phi_7232_ = false;
                                                                    phi_7233_ = false;
                                                                    phi_7234_ = false;
                                                                } else {
                                                                    let _e3024 = local_29;
                                                                    if (_e3024 > _e2440) {
                                                                        let _e3027 = local_30;
                                                                        let _e3030 = ((_e3027 - _e2440) < f64(0.00000000023283064f));
                                                                        if _e3030 {
                                                                            phi_7228_ = false;
                                                                        } else {
                                                                            phi_7228_ = true;
                                                                        }
                                                                        let _e3032 = phi_7228_;
                                                                        phi_7229_ = _e3032;
                                                                        phi_7230_ = _e3030;
                                                                        phi_7231_ = false;
                                                                    } else {
                                                                        phi_7229_ = false;
                                                                        phi_7230_ = false;
                                                                        phi_7231_ = true;
                                                                    }
                                                                    let _e3034 = phi_7229_;
                                                                    let _e3036 = phi_7230_;
                                                                    let _e3038 = phi_7231_;
                                                                    phi_7232_ = _e3034;
                                                                    phi_7233_ = _e3036;
                                                                    phi_7234_ = _e3038;
                                                                }
                                                                let _e3040 = phi_7232_;
                                                                let _e3042 = phi_7233_;
                                                                let _e3044 = phi_7234_;
                                                                phi_7235_ = _e3040;
                                                                phi_7236_ = _e3022;
                                                                phi_7237_ = _e3042;
                                                                phi_7238_ = _e3044;
                                                                phi_7239_ = false;
                                                            } else {
                                                                phi_7235_ = false;
                                                                phi_7236_ = false;
                                                                phi_7237_ = false;
                                                                phi_7238_ = false;
                                                                phi_7239_ = true;
                                                            }
                                                            let _e3046 = phi_7235_;
                                                            let _e3048 = phi_7236_;
                                                            let _e3050 = phi_7237_;
                                                            let _e3052 = phi_7238_;
                                                            let _e3054 = phi_7239_;
                                                            let _e5454 = local_56;
                                                            phi_7240_ = _e5454;
                                                            let _e5457 = local_57;
                                                            phi_7241_ = _e5457;
                                                            phi_7242_ = _e3046;
                                                            phi_7243_ = _e3048;
                                                            phi_7244_ = _e3050;
                                                            phi_7245_ = _e3052;
                                                            phi_7246_ = _e3054;
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
                                                        let _e3056 = phi_7240_;
                                                        let _e3058 = phi_7241_;
                                                        let _e3060 = phi_7242_;
                                                        let _e3062 = phi_7243_;
                                                        let _e3064 = phi_7244_;
                                                        let _e3066 = phi_7245_;
                                                        let _e3068 = phi_7246_;
                                                        let _e3070 = phi_7247_;
                                                        phi_7248_ = _e3056;
                                                        phi_7249_ = _e3058;
                                                        phi_7250_ = _e3060;
                                                        phi_7251_ = _e3062;
                                                        phi_7252_ = _e3064;
                                                        phi_7253_ = _e3066;
                                                        phi_7254_ = _e3068;
                                                        phi_7255_ = _e3070;
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
                                                    let _e3072 = phi_7248_;
                                                    let _e3074 = phi_7249_;
                                                    let _e3076 = phi_7250_;
                                                    let _e3078 = phi_7251_;
                                                    let _e3080 = phi_7252_;
                                                    let _e3082 = phi_7253_;
                                                    let _e3084 = phi_7254_;
                                                    let _e3086 = phi_7255_;
                                                    let _e3088 = phi_7256_;
                                                    phi_7257_ = _e3072;
                                                    phi_6308_ = _e3074;
                                                    phi_7258_ = _e3076;
                                                    phi_7259_ = _e3078;
                                                    phi_7260_ = _e3080;
                                                    phi_7261_ = false;
                                                    phi_7262_ = _e3082;
                                                    phi_7263_ = _e3084;
                                                    phi_7264_ = _e3086;
                                                    phi_7265_ = _e3088;
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
                                                let _e3090 = phi_7257_;
                                                let _e3092 = phi_6308_;
                                                let _e3094 = phi_7258_;
                                                let _e3096 = phi_7259_;
                                                let _e3098 = phi_7260_;
                                                let _e3100 = phi_7261_;
                                                let _e3102 = phi_7262_;
                                                let _e3104 = phi_7263_;
                                                let _e3106 = phi_7264_;
                                                let _e3108 = phi_7265_;
                                                local_31 = _e3096;
                                                local_58 = _e3098;
                                                local_59 = _e3100;
                                                local_60 = _e3102;
                                                local_61 = _e3104;
                                                local_62 = _e3106;
                                                local_63 = _e3108;
                                                local_64 = _e3090;
                                                local_66 = _e3096;
                                                continue;
                                                continuing {
                                                    phi_6304_ = _e2454;
                                                    phi_6307_ = _e3092;
                                                    break if !(_e3094);
                                                }
                                            }
                                            let _e3111 = local_31;
                                            if _e3111 {
                                                phi_7270_ = type_71(0u, type_71().member_1);
                                                phi_7271_ = false;
                                                phi_7272_ = false;
                                                phi_7273_ = false;
                                                phi_7274_ = false;
                                                phi_7275_ = false;
                                                phi_7276_ = false;
                                            } else {
                                                phi_7270_ = type_71();
                                                let _e5487 = local_58;
                                                phi_7271_ = _e5487;
                                                let _e5490 = local_59;
                                                phi_7272_ = _e5490;
                                                let _e5493 = local_60;
                                                phi_7273_ = _e5493;
                                                let _e5496 = local_61;
                                                phi_7274_ = _e5496;
                                                let _e5499 = local_62;
                                                phi_7275_ = _e5499;
                                                let _e5502 = local_63;
                                                phi_7276_ = _e5502;
                                            }
                                            let _e3116 = phi_7270_;
                                            let _e3118 = phi_7271_;
                                            let _e3120 = phi_7272_;
                                            let _e3122 = phi_7273_;
                                            let _e3124 = phi_7274_;
                                            let _e3126 = phi_7275_;
                                            let _e3128 = phi_7276_;
                                            if _e3118 {
                                                let _e5505 = local_64;
                                                phi_7280_ = _e5505;
                                                phi_7281_ = true;
                                                phi_7282_ = false;
                                                phi_7283_ = false;
                                                phi_7284_ = false;
                                                phi_7285_ = false;
                                                phi_7286_ = false;
                                            } else {
                                                let _e5507 = local_65;
                                                phi_7280_ = _e5507;
                                                phi_7281_ = _e3120;
                                                phi_7282_ = _e3122;
                                                phi_7283_ = _e3124;
                                                let _e5513 = local_66;
                                                phi_7284_ = _e5513;
                                                phi_7285_ = _e3126;
                                                phi_7286_ = _e3128;
                                            }
                                            let _e3130 = phi_7280_;
                                            let _e3132 = phi_7281_;
                                            let _e3134 = phi_7282_;
                                            let _e3136 = phi_7283_;
                                            let _e3138 = phi_7284_;
                                            let _e3140 = phi_7285_;
                                            let _e3142 = phi_7286_;
                                            if _e3132 {
                                                phi_7291_ = type_71(1u, _e3130);
                                                phi_7292_ = false;
                                                phi_7293_ = false;
                                                phi_7294_ = false;
                                                phi_7295_ = false;
                                                phi_7296_ = false;
                                            } else {
                                                phi_7291_ = type_71();
                                                phi_7292_ = _e3134;
                                                phi_7293_ = _e3136;
                                                phi_7294_ = _e3138;
                                                phi_7295_ = _e3140;
                                                phi_7296_ = _e3142;
                                            }
                                            let _e3145 = phi_7291_;
                                            let _e3147 = phi_7292_;
                                            let _e3149 = phi_7293_;
                                            let _e3151 = phi_7294_;
                                            let _e3153 = phi_7295_;
                                            let _e3155 = phi_7296_;
                                            if _e3147 {
                                                let _e3157 = local_32;
                                                phi_7301_ = type_71(1u, _e3157);
                                                phi_7302_ = false;
                                                phi_7303_ = true;
                                                phi_7304_ = false;
                                                phi_7305_ = false;
                                            } else {
                                                phi_7301_ = _e3116;
                                                phi_7302_ = _e3149;
                                                phi_7303_ = _e3151;
                                                phi_7304_ = _e3153;
                                                phi_7305_ = _e3155;
                                            }
                                            let _e3160 = phi_7301_;
                                            let _e3162 = phi_7302_;
                                            let _e3164 = phi_7303_;
                                            let _e3166 = phi_7304_;
                                            let _e3168 = phi_7305_;
                                            if _e3162 {
                                                let _e3170 = local_33;
                                                phi_7310_ = type_71(1u, _e3170);
                                                phi_7311_ = true;
                                                phi_7312_ = false;
                                                phi_7313_ = false;
                                            } else {
                                                phi_7310_ = _e3160;
                                                phi_7311_ = _e3164;
                                                phi_7312_ = _e3166;
                                                phi_7313_ = _e3168;
                                            }
                                            let _e3173 = phi_7310_;
                                            let _e3175 = phi_7311_;
                                            let _e3177 = phi_7312_;
                                            let _e3179 = phi_7313_;
                                            if _e3175 {
                                                phi_7317_ = false;
                                                phi_7318_ = false;
                                            } else {
                                                phi_7317_ = _e3177;
                                                phi_7318_ = _e3179;
                                            }
                                            let _e3181 = phi_7317_;
                                            let _e3183 = phi_7318_;
                                            if _e3181 {
                                                phi_7322_ = false;
                                                phi_7323_ = false;
                                            } else {
                                                phi_7322_ = _e3183;
                                                phi_7323_ = _e3175;
                                            }
                                            let _e3185 = phi_7322_;
                                            let _e3187 = phi_7323_;
                                            if _e3185 {
                                                phi_7327_ = true;
                                                phi_7328_ = false;
                                            } else {
                                                phi_7327_ = _e3181;
                                                phi_7328_ = _e3187;
                                            }
                                            let _e3189 = phi_7327_;
                                            let _e3191 = phi_7328_;
                                            if _e3189 {
                                                let _e3193 = local_34;
                                                phi_7333_ = type_71(1u, _e3193);
                                                phi_7334_ = true;
                                            } else {
                                                phi_7333_ = _e3173;
                                                phi_7334_ = _e3191;
                                            }
                                            let _e3196 = phi_7333_;
                                            let _e3198 = phi_7334_;
                                            if _e3198 {
                                                phi_7338_ = _e3196;
                                            } else {
                                                phi_7338_ = _e3145;
                                            }
                                            let _e3200 = phi_7338_;
                                            let _e3203 = (_e3200.member != 0u);
                                            if _e3203 {
                                                phi_7345_ = false;
                                            } else {
                                                phi_7345_ = true;
                                            }
                                            let _e3205 = phi_7345_;
                                            phi_7346_ = _e3200.member_1;
                                            phi_7347_ = _e3205;
                                            phi_7348_ = _e3203;
                                            phi_7349_ = false;
                                        } else {
                                            phi_7346_ = f64();
                                            phi_7347_ = false;
                                            phi_7348_ = false;
                                            phi_7349_ = true;
                                        }
                                        let _e3207 = phi_7346_;
                                        let _e3209 = phi_7347_;
                                        let _e3211 = phi_7348_;
                                        let _e3213 = phi_7349_;
                                        phi_7350_ = _e3207;
                                        phi_7351_ = _e3209;
                                        phi_7352_ = _e3211;
                                        phi_7353_ = _e3213;
                                    }
                                    let _e3215 = phi_7350_;
                                    let _e3217 = phi_7351_;
                                    let _e3219 = phi_7352_;
                                    let _e3221 = phi_7353_;
                                    phi_7354_ = _e3215;
                                    phi_7355_ = _e2182;
                                    phi_7356_ = _e3217;
                                    phi_7357_ = _e3219;
                                    phi_7358_ = _e3221;
                                }
                                let _e3223 = phi_7354_;
                                let _e3225 = phi_7355_;
                                let _e3227 = phi_7356_;
                                let _e3229 = phi_7357_;
                                let _e3231 = phi_7358_;
                                if _e3225 {
                                    phi_7362_ = true;
                                    phi_7363_ = false;
                                    phi_7364_ = false;
                                } else {
                                    phi_7362_ = _e3227;
                                    phi_7363_ = _e3229;
                                    phi_7364_ = _e3231;
                                }
                                let _e3233 = phi_7362_;
                                let _e3235 = phi_7363_;
                                let _e3237 = phi_7364_;
                                phi_7365_ = _e3223;
                                phi_7366_ = _e1440;
                                phi_7367_ = _e3233;
                                phi_7368_ = false;
                                phi_7369_ = _e3235;
                                phi_7370_ = _e3237;
                            } else {
                                phi_7365_ = f64();
                                phi_7366_ = type_72();
                                phi_7367_ = false;
                                phi_7368_ = true;
                                phi_7369_ = false;
                                phi_7370_ = false;
                            }
                            let _e3239 = phi_7365_;
                            let _e3241 = phi_7366_;
                            let _e3243 = phi_7367_;
                            let _e3245 = phi_7368_;
                            let _e3247 = phi_7369_;
                            let _e3249 = phi_7370_;
                            local_35 = _e3245;
                            local_67 = _e3247;
                            local_68 = _e3249;
                            local_36 = _e3239;
                            local_37 = _e3241;
                            continue;
                            continuing {
                                phi_4327_ = _e1107;
                                break if !(_e3243);
                            }
                        }
                        let _e3252 = local_35;
                        if _e3252 {
                            phi_7375_ = type_71(0u, type_71().member_1);
                            phi_7376_ = false;
                            phi_7377_ = false;
                        } else {
                            phi_7375_ = type_71();
                            let _e5570 = local_67;
                            phi_7376_ = _e5570;
                            let _e5573 = local_68;
                            phi_7377_ = _e5573;
                        }
                        let _e3257 = phi_7375_;
                        let _e3259 = phi_7376_;
                        let _e3261 = phi_7377_;
                        if _e3259 {
                            let _e3263 = local_36;
                            phi_7382_ = type_71(2u, _e3263);
                            phi_7383_ = false;
                        } else {
                            phi_7382_ = type_71();
                            phi_7383_ = _e3261;
                        }
                        let _e3266 = phi_7382_;
                        let _e3268 = phi_7383_;
                        if _e3268 {
                            let _e3270 = local_37;
                            phi_7389_ = type_71(1u, _e3270.member);
                            phi_7390_ = true;
                        } else {
                            phi_7389_ = _e3266;
                            phi_7390_ = _e3259;
                        }
                        let _e3274 = phi_7389_;
                        let _e3276 = phi_7390_;
                        if _e3276 {
                            phi_7394_ = _e3274;
                        } else {
                            phi_7394_ = _e3257;
                        }
                        let _e3278 = phi_7394_;
                        phi_7398_ = _e3278;
                    }
                    let _e4965 = phi_7398_;
                    phi_7399_ = _e4965;
                }
                let _e4970 = phi_7399_;
                switch bitcast<i32>(_e4970.member) {
                    case 0: {
                        phi_7420_ = type_45(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4981 = bitcast<u64>(_e4970.member_1);
                        phi_7420_ = type_45(0u, array<u32, 2>(u32(_e4981), u32((_e4981 >> bitcast<u64>(32lu)))), true);
                        break;
                    }
                    case 2: {
                        let _e4974 = bitcast<u64>(_e4970.member_1);
                        phi_7420_ = type_45(1u, array<u32, 2>(u32(_e4974), u32((_e4974 >> bitcast<u64>(32lu)))), true);
                        break;
                    }
                    default: {
                        phi_7420_ = type_45();
                        break;
                    }
                }
                let _e4989 = phi_7420_;
                if _e4989.member_2 {
                    let _e4995 = (_e4989.member_1[1] >> bitcast<u32>(20i));
                    if (_e4995 <= 896u) {
                        phi_7443_ = 0u;
                    } else {
                        phi_7443_ = ((((_e4995 - 896u) << bitcast<u32>(23i)) | ((_e4989.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4989.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5010 = phi_7443_;
                    let _e5012 = atomicMin((&earliest.member[0u]), _e5010);
                }
                let _e5014 = params.member.member_1;
                if ((_e5014 & 16u) != 0u) {
                    if (_e115 == 0u) {
                        atomicStore((&counters[0u]), 0u);
                    }
                    workgroupBarrier();
                    if _e4989.member_2 {
                        let _e5020 = atomicAdd((&counters[0u]), 1u);
                        phi_7464_ = _e5020;
                    } else {
                        phi_7464_ = 0u;
                    }
                    let _e5022 = phi_7464_;
                    workgroupBarrier();
                    if (_e115 == 0u) {
                        let _e5025 = atomicLoad((&counters[0u]));
                        if (_e5025 > 0u) {
                            let _e5028 = atomicAdd((&contacts.member[0u]), _e5025);
                            atomicStore((&counters[1u]), _e5028);
                        }
                    }
                    workgroupBarrier();
                    let _e5031 = atomicLoad((&counters[1u]));
                    let _e5032 = (_e5031 + _e5022);
                    if _e4989.member_2 {
                        let _e5034 = params.member.member_16;
                        if (_e5032 < _e5034) {
                            let _e5036 = (6u * _e5032);
                            atomicStore((&contacts.member[(4u + _e5036)]), _e184);
                            atomicStore((&contacts.member[(_e5036 + 5u)]), _e4989.member);
                            atomicStore((&contacts.member[(_e5036 + 6u)]), _e202);
                            atomicStore((&contacts.member[(_e5036 + 7u)]), _e205);
                            atomicStore((&contacts.member[(_e5036 + 8u)]), _e4989.member_1[0]);
                            atomicStore((&contacts.member[(_e5036 + 9u)]), _e4989.member_1[1]);
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
