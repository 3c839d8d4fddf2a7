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

fn function_() {
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
    var phi_229_: u32;
    var phi_245_: u32;
    var phi_266_: u32;
    var phi_267_: u32;
    var phi_270_: type_29;
    var phi_271_: type_29;
    var phi_294_: type_29;
    var phi_626_: type_29;
    var phi_627_: type_29;
    var phi_650_: type_29;
    var phi_506_: type_29;
    var phi_507_: type_29;
    var phi_530_: type_29;
    var phi_540_: type_29;
    var phi_541_: type_29;
    var phi_564_: type_29;
    var phi_1107_: f64;
    var phi_1114_: f64;
    var phi_1119_: f64;
    var phi_1126_: f64;
    var phi_1131_: f64;
    var phi_1144_: f64;
    var phi_1151_: f64;
    var phi_1156_: f64;
    var phi_1163_: f64;
    var phi_1168_: f64;
    var phi_1173_: f64;
    var phi_1190_: f64;
    var phi_1197_: f64;
    var phi_1202_: f64;
    var phi_1209_: f64;
    var phi_1214_: f64;
    var phi_1228_: f64;
    var phi_1235_: f64;
    var phi_1240_: f64;
    var phi_1247_: f64;
    var phi_1252_: f64;
    var phi_1257_: f64;
    var phi_1274_: f64;
    var phi_1281_: f64;
    var phi_1286_: f64;
    var phi_1293_: f64;
    var phi_1298_: f64;
    var phi_1312_: f64;
    var phi_1319_: f64;
    var phi_1324_: f64;
    var phi_1331_: f64;
    var phi_1336_: f64;
    var phi_1341_: f64;
    var phi_1378_: f64;
    var phi_1384_: f64;
    var phi_1391_: f64;
    var phi_1398_: f64;
    var phi_1404_: f64;
    var phi_1411_: f64;
    var phi_1417_: f64;
    var phi_1423_: f64;
    var phi_1429_: f64;
    var phi_1436_: f64;
    var phi_1443_: f64;
    var phi_1471_: f64;
    var phi_1476_: f64;
    var phi_1481_: f64;
    var phi_1486_: f64;
    var phi_1491_: f64;
    var phi_1496_: f64;
    var phi_1507_: f64;
    var phi_4019_: f64;
    var phi_4025_: f64;
    var phi_4030_: f64;
    var phi_4036_: f64;
    var phi_4042_: f64;
    var phi_4047_: f64;
    var phi_4052_: f64;
    var phi_4096_: type_27;
    var phi_4099_: f64;
    var phi_4120_: bool;
    var phi_4126_: type_28;
    var phi_4097_: type_27;
    var phi_4140_: type_28;
    var phi_4100_: f64;
    var local_21: f64;
    var phi_4089_: f64;
    var phi_4153_: f64;
    var phi_4159_: f64;
    var phi_4184_: type_29;
    var phi_4187_: u32;
    var phi_4185_: type_29;
    var phi_4210_: type_29;
    var phi_4254_: u32;
    var phi_4255_: u32;
    var phi_4188_: u32;
    var phi_4256_: u32;
    var phi_4276_: type_29;
    var phi_4277_: type_29;
    var phi_4300_: type_29;
    var phi_4354_: f64;
    var phi_4361_: f64;
    var phi_4373_: bool;
    var phi_4374_: bool;
    var phi_4375_: bool;
    var phi_4376_: bool;
    var phi_4380_: bool;
    var phi_4392_: type_74;
    var phi_4393_: type_74;
    var phi_4394_: bool;
    var phi_4395_: type_74;
    var phi_4396_: bool;
    var phi_4409_: f64;
    var phi_4422_: type_29;
    var phi_4425_: f64;
    var phi_4427_: f64;
    var phi_4429_: f64;
    var phi_4423_: type_29;
    var phi_4452_: type_29;
    var phi_4479_: f64;
    var phi_4480_: f64;
    var phi_4508_: f64;
    var phi_4524_: f64;
    var phi_4531_: bool;
    var phi_4532_: bool;
    var phi_4533_: bool;
    var phi_4539_: f64;
    var phi_4540_: f64;
    var phi_4541_: bool;
    var phi_4426_: f64;
    var phi_4428_: f64;
    var phi_4430_: f64;
    var phi_4542_: f64;
    var phi_4543_: bool;
    var phi_4544_: bool;
    var local_22: bool;
    var phi_4548_: f64;
    var phi_4549_: f64;
    var phi_4557_: type_29;
    var phi_4560_: f64;
    var phi_4558_: type_29;
    var phi_4583_: type_29;
    var phi_4626_: f64;
    var phi_4636_: f64;
    var phi_4646_: bool;
    var phi_4648_: bool;
    var phi_4653_: f64;
    var phi_4654_: bool;
    var phi_4655_: f64;
    var phi_4656_: bool;
    var phi_4657_: bool;
    var phi_4658_: bool;
    var phi_4659_: f64;
    var phi_4561_: f64;
    var phi_4660_: bool;
    var phi_4661_: bool;
    var phi_4662_: bool;
    var phi_4663_: bool;
    var local_23: bool;
    var phi_4667_: bool;
    var phi_4668_: bool;
    var phi_4672_: bool;
    var phi_4676_: f64;
    var phi_4677_: f64;
    var phi_4679_: type_74;
    var phi_4710_: f64;
    var phi_4717_: f64;
    var phi_4722_: f64;
    var phi_4729_: f64;
    var phi_4734_: f64;
    var phi_4747_: f64;
    var phi_4754_: f64;
    var phi_4759_: f64;
    var phi_4766_: f64;
    var phi_4771_: f64;
    var phi_4776_: f64;
    var phi_4835_: f64;
    var phi_4841_: f64;
    var phi_4846_: f64;
    var phi_4852_: f64;
    var phi_4857_: f64;
    var phi_4871_: f64;
    var phi_4877_: f64;
    var phi_4882_: f64;
    var phi_4888_: f64;
    var phi_4893_: f64;
    var phi_4919_: f64;
    var phi_4926_: f64;
    var phi_4931_: f64;
    var phi_4938_: f64;
    var phi_4943_: f64;
    var phi_4956_: f64;
    var phi_4963_: f64;
    var phi_4968_: f64;
    var phi_4975_: f64;
    var phi_4980_: f64;
    var phi_4985_: f64;
    var phi_5044_: f64;
    var phi_5050_: f64;
    var phi_5055_: f64;
    var phi_5061_: f64;
    var phi_5066_: f64;
    var phi_5080_: f64;
    var phi_5086_: f64;
    var phi_5091_: f64;
    var phi_5097_: f64;
    var phi_5102_: f64;
    var phi_5128_: f64;
    var phi_5135_: f64;
    var phi_5140_: f64;
    var phi_5147_: f64;
    var phi_5152_: f64;
    var phi_5165_: f64;
    var phi_5172_: f64;
    var phi_5177_: f64;
    var phi_5184_: f64;
    var phi_5189_: f64;
    var phi_5194_: f64;
    var phi_5253_: f64;
    var phi_5259_: f64;
    var phi_5264_: f64;
    var phi_5270_: f64;
    var phi_5275_: f64;
    var phi_5289_: f64;
    var phi_5295_: f64;
    var phi_5300_: f64;
    var phi_5306_: f64;
    var phi_5311_: f64;
    var phi_5360_: f64;
    var phi_5366_: f64;
    var phi_5394_: f64;
    var phi_5400_: f64;
    var phi_5405_: u32;
    var phi_5406_: u32;
    var phi_5376_: f64;
    var phi_5382_: f64;
    var phi_5387_: u32;
    var phi_5388_: u32;
    var phi_5407_: u32;
    var phi_5408_: u32;
    var phi_5479_: f64;
    var phi_5491_: f64;
    var phi_5630_: f64;
    var phi_5636_: f64;
    var phi_5643_: f64;
    var phi_5687_: type_29;
    var phi_5690_: bool;
    var phi_5688_: type_29;
    var phi_5713_: type_29;
    var phi_5740_: bool;
    var phi_5741_: bool;
    var phi_5691_: bool;
    var phi_5742_: bool;
    var phi_5743_: bool;
    var local_24: bool;
    var phi_5747_: bool;
    var local_25: bool;
    var phi_5754_: u32;
    var phi_5755_: u32;
    var phi_5756_: bool;
    var phi_5757_: u32;
    var phi_5758_: u32;
    var phi_5759_: bool;
    var phi_5763_: u32;
    var phi_5784_: bool;
    var phi_5785_: bool;
    var phi_5786_: bool;
    var phi_5983_: f64;
    var phi_5990_: f64;
    var phi_5995_: f64;
    var phi_6002_: f64;
    var phi_6007_: f64;
    var phi_6020_: f64;
    var phi_6027_: f64;
    var phi_6032_: f64;
    var phi_6039_: f64;
    var phi_6044_: f64;
    var phi_6049_: f64;
    var phi_6066_: f64;
    var phi_6073_: f64;
    var phi_6078_: f64;
    var phi_6085_: f64;
    var phi_6090_: f64;
    var phi_6104_: f64;
    var phi_6111_: f64;
    var phi_6116_: f64;
    var phi_6123_: f64;
    var phi_6128_: f64;
    var phi_6133_: f64;
    var phi_6150_: f64;
    var phi_6157_: f64;
    var phi_6162_: f64;
    var phi_6169_: f64;
    var phi_6174_: f64;
    var phi_6188_: f64;
    var phi_6195_: f64;
    var phi_6200_: f64;
    var phi_6207_: f64;
    var phi_6212_: f64;
    var phi_6217_: f64;
    var phi_6237_: type_29;
    var phi_6240_: f64;
    var phi_6238_: type_29;
    var phi_6263_: type_29;
    var phi_6439_: bool;
    var phi_6440_: bool;
    var phi_6441_: bool;
    var phi_6442_: bool;
    var phi_6446_: bool;
    var phi_6468_: array<f64, 3>;
    var phi_6469_: bool;
    var phi_6470_: array<f64, 3>;
    var phi_6471_: bool;
    var phi_6658_: f64;
    var phi_6660_: f64;
    var phi_6690_: f64;
    var phi_6692_: f64;
    var phi_6722_: f64;
    var phi_6724_: f64;
    var phi_6760_: type_29;
    var phi_6763_: array<f64, 3>;
    var phi_6761_: type_29;
    var phi_6786_: type_29;
    var phi_6853_: array<f64, 3>;
    var phi_6764_: array<f64, 3>;
    var phi_6854_: array<f64, 3>;
    var phi_6861_: f64;
    var phi_6868_: f64;
    var phi_6876_: f64;
    var phi_6921_: type_27;
    var phi_6924_: f64;
    var phi_6945_: bool;
    var phi_6951_: type_28;
    var phi_6922_: type_27;
    var phi_6965_: type_28;
    var phi_6925_: f64;
    var local_26: f64;
    var phi_6914_: f64;
    var phi_6978_: f64;
    var phi_6991_: type_29;
    var phi_6994_: f64;
    var phi_6992_: type_29;
    var phi_7017_: type_29;
    var phi_7068_: f64;
    var phi_7074_: f64;
    var phi_7088_: bool;
    var phi_7089_: bool;
    var phi_7116_: f64;
    var phi_7117_: f64;
    var phi_7118_: f64;
    var phi_7119_: f64;
    var phi_7120_: bool;
    var phi_6995_: f64;
    var phi_7121_: bool;
    var phi_7122_: bool;
    var local_27: bool;
    var local_28: f64;
    var local_29: f64;
    var local_30: f64;
    var phi_7140_: bool;
    var phi_7141_: bool;
    var phi_7142_: bool;
    var phi_7143_: bool;
    var phi_7144_: bool;
    var phi_7145_: bool;
    var phi_7146_: bool;
    var phi_7147_: bool;
    var phi_7148_: bool;
    var phi_7149_: bool;
    var phi_7150_: bool;
    var phi_7151_: bool;
    var phi_7152_: f64;
    var phi_7153_: f64;
    var phi_7154_: bool;
    var phi_7155_: bool;
    var phi_7156_: bool;
    var phi_7157_: bool;
    var phi_7158_: bool;
    var phi_7159_: bool;
    var phi_7160_: f64;
    var phi_7161_: f64;
    var phi_7162_: bool;
    var phi_7163_: bool;
    var phi_7164_: bool;
    var phi_7165_: bool;
    var phi_7166_: bool;
    var phi_7167_: bool;
    var phi_7168_: bool;
    var phi_7169_: f64;
    var phi_6241_: f64;
    var phi_7170_: bool;
    var phi_7171_: bool;
    var phi_7172_: bool;
    var phi_7173_: bool;
    var phi_7174_: bool;
    var phi_7175_: bool;
    var phi_7176_: bool;
    var phi_7177_: bool;
    var local_31: bool;
    var phi_7182_: type_73;
    var phi_7183_: bool;
    var phi_7184_: bool;
    var phi_7185_: bool;
    var phi_7186_: bool;
    var phi_7187_: bool;
    var phi_7188_: bool;
    var phi_7192_: f64;
    var phi_7193_: bool;
    var phi_7194_: bool;
    var phi_7195_: bool;
    var phi_7196_: bool;
    var phi_7197_: bool;
    var phi_7198_: bool;
    var phi_7203_: type_73;
    var phi_7204_: bool;
    var phi_7205_: bool;
    var phi_7206_: bool;
    var phi_7207_: bool;
    var phi_7208_: bool;
    var local_32: f64;
    var phi_7213_: type_73;
    var phi_7214_: bool;
    var phi_7215_: bool;
    var phi_7216_: bool;
    var phi_7217_: bool;
    var local_33: f64;
    var phi_7222_: type_73;
    var phi_7223_: bool;
    var phi_7224_: bool;
    var phi_7225_: bool;
    var phi_7229_: bool;
    var phi_7230_: bool;
    var phi_7234_: bool;
    var phi_7235_: bool;
    var phi_7239_: bool;
    var phi_7240_: bool;
    var local_34: f64;
    var phi_7245_: type_73;
    var phi_7246_: bool;
    var phi_7250_: type_73;
    var phi_7257_: bool;
    var phi_7258_: f64;
    var phi_7259_: bool;
    var phi_7260_: bool;
    var phi_7261_: bool;
    var phi_7262_: f64;
    var phi_7263_: bool;
    var phi_7264_: bool;
    var phi_7265_: bool;
    var phi_7266_: f64;
    var phi_7267_: bool;
    var phi_7268_: bool;
    var phi_7269_: bool;
    var phi_7270_: bool;
    var phi_7274_: bool;
    var phi_7275_: bool;
    var phi_7276_: bool;
    var phi_7277_: f64;
    var phi_7278_: type_74;
    var phi_7279_: bool;
    var phi_7280_: bool;
    var phi_7281_: bool;
    var phi_7282_: bool;
    var local_35: bool;
    var phi_7287_: type_73;
    var phi_7288_: bool;
    var phi_7289_: bool;
    var local_36: f64;
    var phi_7294_: type_73;
    var phi_7295_: bool;
    var local_37: type_74;
    var phi_7301_: type_73;
    var phi_7302_: bool;
    var phi_7306_: type_73;
    var phi_1710_: f64;
    var phi_1717_: f64;
    var phi_1722_: f64;
    var phi_1729_: f64;
    var phi_1734_: f64;
    var phi_1747_: f64;
    var phi_1754_: f64;
    var phi_1759_: f64;
    var phi_1766_: f64;
    var phi_1771_: f64;
    var phi_1776_: f64;
    var phi_1793_: f64;
    var phi_1800_: f64;
    var phi_1805_: f64;
    var phi_1812_: f64;
    var phi_1817_: f64;
    var phi_1831_: f64;
    var phi_1838_: f64;
    var phi_1843_: f64;
    var phi_1850_: f64;
    var phi_1855_: f64;
    var phi_1860_: f64;
    var phi_1877_: f64;
    var phi_1884_: f64;
    var phi_1889_: f64;
    var phi_1896_: f64;
    var phi_1901_: f64;
    var phi_1915_: f64;
    var phi_1922_: f64;
    var phi_1927_: f64;
    var phi_1934_: f64;
    var phi_1939_: f64;
    var phi_1944_: f64;
    var phi_1964_: type_29;
    var phi_1967_: f64;
    var phi_1965_: type_29;
    var phi_1990_: type_29;
    var phi_2166_: bool;
    var phi_2167_: bool;
    var phi_2168_: bool;
    var phi_2169_: bool;
    var phi_2173_: bool;
    var phi_2195_: array<f64, 3>;
    var phi_2196_: bool;
    var phi_2197_: array<f64, 3>;
    var phi_2198_: bool;
    var phi_2385_: f64;
    var phi_2387_: f64;
    var phi_2417_: f64;
    var phi_2419_: f64;
    var phi_2449_: f64;
    var phi_2451_: f64;
    var phi_2487_: type_29;
    var phi_2490_: array<f64, 3>;
    var phi_2488_: type_29;
    var phi_2513_: type_29;
    var phi_2580_: array<f64, 3>;
    var phi_2491_: array<f64, 3>;
    var phi_2581_: array<f64, 3>;
    var phi_2588_: f64;
    var phi_2595_: f64;
    var phi_2603_: f64;
    var phi_2648_: type_27;
    var phi_2651_: f64;
    var phi_2672_: bool;
    var phi_2678_: type_28;
    var phi_2649_: type_27;
    var phi_2692_: type_28;
    var phi_2652_: f64;
    var local_38: f64;
    var phi_2641_: f64;
    var phi_2705_: f64;
    var phi_2718_: type_29;
    var phi_2721_: f64;
    var phi_2719_: type_29;
    var phi_2744_: type_29;
    var phi_2795_: f64;
    var phi_2801_: f64;
    var phi_2815_: bool;
    var phi_2816_: bool;
    var phi_2843_: f64;
    var phi_2844_: f64;
    var phi_2845_: f64;
    var phi_2846_: f64;
    var phi_2847_: bool;
    var phi_2722_: f64;
    var phi_2848_: bool;
    var phi_2849_: bool;
    var local_39: bool;
    var local_40: f64;
    var local_41: f64;
    var local_42: f64;
    var phi_2867_: bool;
    var phi_2868_: bool;
    var phi_2869_: bool;
    var phi_2870_: bool;
    var phi_2871_: bool;
    var phi_2872_: bool;
    var phi_2873_: bool;
    var phi_2874_: bool;
    var phi_2875_: bool;
    var phi_2876_: bool;
    var phi_2877_: bool;
    var phi_2878_: bool;
    var phi_2879_: f64;
    var phi_2880_: f64;
    var phi_2881_: bool;
    var phi_2882_: bool;
    var phi_2883_: bool;
    var phi_2884_: bool;
    var phi_2885_: bool;
    var phi_2886_: bool;
    var phi_2887_: f64;
    var phi_2888_: f64;
    var phi_2889_: bool;
    var phi_2890_: bool;
    var phi_2891_: bool;
    var phi_2892_: bool;
    var phi_2893_: bool;
    var phi_2894_: bool;
    var phi_2895_: bool;
    var phi_2896_: f64;
    var phi_1968_: f64;
    var phi_2897_: bool;
    var phi_2898_: bool;
    var phi_2899_: bool;
    var phi_2900_: bool;
    var phi_2901_: bool;
    var phi_2902_: bool;
    var phi_2903_: bool;
    var phi_2904_: bool;
    var local_43: bool;
    var phi_2909_: type_73;
    var phi_2910_: bool;
    var phi_2911_: bool;
    var phi_2912_: bool;
    var phi_2913_: bool;
    var phi_2914_: bool;
    var phi_2915_: bool;
    var phi_2919_: f64;
    var phi_2920_: bool;
    var phi_2921_: bool;
    var phi_2922_: bool;
    var phi_2923_: bool;
    var phi_2924_: bool;
    var phi_2925_: bool;
    var phi_2930_: type_73;
    var phi_2931_: bool;
    var phi_2932_: bool;
    var phi_2933_: bool;
    var phi_2934_: bool;
    var phi_2935_: bool;
    var local_44: f64;
    var phi_2940_: type_73;
    var phi_2941_: bool;
    var phi_2942_: bool;
    var phi_2943_: bool;
    var phi_2944_: bool;
    var local_45: f64;
    var phi_2949_: type_73;
    var phi_2950_: bool;
    var phi_2951_: bool;
    var phi_2952_: bool;
    var phi_2956_: bool;
    var phi_2957_: bool;
    var phi_2961_: bool;
    var phi_2962_: bool;
    var phi_2966_: bool;
    var phi_2967_: bool;
    var local_46: f64;
    var phi_2972_: type_73;
    var phi_2973_: bool;
    var phi_2977_: type_73;
    var phi_2991_: type_29;
    var phi_2992_: type_29;
    var phi_3015_: type_29;
    var phi_3036_: f64;
    var phi_3206_: bool;
    var phi_3207_: bool;
    var phi_3208_: bool;
    var phi_3209_: bool;
    var phi_3213_: bool;
    var phi_3235_: array<f64, 3>;
    var phi_3236_: bool;
    var phi_3237_: array<f64, 3>;
    var phi_3238_: bool;
    var phi_3425_: f64;
    var phi_3427_: f64;
    var phi_3457_: f64;
    var phi_3459_: f64;
    var phi_3489_: f64;
    var phi_3491_: f64;
    var phi_3527_: type_29;
    var phi_3530_: array<f64, 3>;
    var phi_3528_: type_29;
    var phi_3553_: type_29;
    var phi_3620_: array<f64, 3>;
    var phi_3531_: array<f64, 3>;
    var phi_3621_: array<f64, 3>;
    var phi_3653_: type_27;
    var phi_3656_: f64;
    var phi_3677_: bool;
    var phi_3683_: type_28;
    var phi_3654_: type_27;
    var phi_3697_: type_28;
    var phi_3657_: f64;
    var local_47: f64;
    var phi_3646_: f64;
    var phi_3710_: f64;
    var phi_3728_: f64;
    var phi_3735_: f64;
    var phi_3740_: f64;
    var phi_3747_: f64;
    var phi_3752_: f64;
    var phi_3765_: f64;
    var phi_3772_: f64;
    var phi_3777_: f64;
    var phi_3784_: f64;
    var phi_3789_: f64;
    var phi_3794_: f64;
    var phi_3811_: f64;
    var phi_3818_: f64;
    var phi_3823_: f64;
    var phi_3830_: f64;
    var phi_3835_: f64;
    var phi_3849_: f64;
    var phi_3856_: f64;
    var phi_3861_: f64;
    var phi_3868_: f64;
    var phi_3873_: f64;
    var phi_3878_: f64;
    var phi_3895_: f64;
    var phi_3902_: f64;
    var phi_3907_: f64;
    var phi_3914_: f64;
    var phi_3919_: f64;
    var phi_3933_: f64;
    var phi_3940_: f64;
    var phi_3945_: f64;
    var phi_3952_: f64;
    var phi_3957_: f64;
    var phi_3962_: f64;
    var phi_3986_: bool;
    var phi_3987_: bool;
    var phi_3988_: bool;
    var local_48: bool;
    var phi_3993_: type_73;
    var phi_3994_: bool;
    var phi_3999_: type_73;
    var phi_4000_: bool;
    var phi_4002_: type_73;
    var phi_4003_: type_73;
    var phi_4004_: bool;
    var phi_4008_: type_73;
    var phi_7310_: type_73;
    var phi_7311_: type_73;
    var phi_7332_: type_47;
    var phi_7355_: u32;
    var phi_7359_: type_46;
    var phi_7360_: bool;
    var phi_7378_: u32;
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
                let _e187 = (2u * _e182);
                let _e190 = input.member[(4u + _e187)];
                let _e193 = input.member[(_e187 + 5u)];
                let _e195 = elements.member[_e193];
                local_15 = array<u32, 4>(_e190, _e195[0], _e195[1], _e195[2]);
                local_16[0u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[1u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[2u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[3u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[0u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[1u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[2u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[3u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                let _e209 = params.member.member_1;
                if ((_e209 & 8u) != 0u) {
                    let _e255 = paths.member[_e190];
                    let _e257 = paths.member[_e195[0]];
                    let _e263 = paths.member[_e195[1]];
                    let _e265 = paths.member[_e195[2]];
                    local_18 = array<array<f32, 3>, 4>(array<f32, 3>(_e255.member[0], _e255.member[1], _e255.member[2]), array<f32, 3>(_e257.member[0], _e257.member[1], _e257.member[2]), array<f32, 3>(_e263.member[0], _e263.member[1], _e263.member[2]), array<f32, 3>(_e265.member[0], _e265.member[1], _e265.member[2]));
                    local_19 = array<array<f32, 3>, 4>(array<f32, 3>(_e255.member_1[0], _e255.member_1[1], _e255.member_1[2]), array<f32, 3>(_e257.member_1[0], _e257.member_1[1], _e257.member_1[2]), array<f32, 3>(_e263.member_1[0], _e263.member_1[1], _e263.member_1[2]), array<f32, 3>(_e265.member_1[0], _e265.member_1[1], _e265.member_1[2]));
                    phi_506_ = type_29(0u, 4u);
                    loop {
                        let _e305 = phi_506_;
                        if (_e305.member < _e305.member_1) {
                            phi_507_ = type_29((_e305.member + 1u), _e305.member_1);
                            phi_530_ = type_29(1u, _e305.member);
                        } else {
                            phi_507_ = _e305;
                            phi_530_ = type_29(0u, type_29().member_1);
                        }
                        let _e319 = phi_507_;
                        let _e321 = phi_530_;
                        let _e325 = (bitcast<i32>(_e321.member) != 0i);
                        if _e325 {
                            phi_540_ = type_29(0u, 3u);
                            loop {
                                let _e327 = phi_540_;
                                if (_e327.member < _e327.member_1) {
                                    phi_541_ = type_29((_e327.member + 1u), _e327.member_1);
                                    phi_564_ = type_29(1u, _e327.member);
                                } else {
                                    phi_541_ = _e327;
                                    phi_564_ = type_29(0u, type_29().member_1);
                                }
                                let _e341 = phi_541_;
                                let _e343 = phi_564_;
                                let _e347 = (bitcast<i32>(_e343.member) != 0i);
                                if _e347 {
                                    if (_e321.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e343.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e352 = local_18[_e321.member_1][_e343.member_1];
                                    if (_e321.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e343.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    local_16[_e321.member_1][_e343.member_1] = f64(_e352);
                                    if (_e321.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e343.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e362 = local_19[_e321.member_1][_e343.member_1];
                                    if (_e321.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e343.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    local_17[_e321.member_1][_e343.member_1] = f64(_e362);
                                }
                                continue;
                                continuing {
                                    phi_540_ = _e341;
                                    break if !(_e347);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_506_ = _e319;
                            break if !(_e325);
                        }
                    }
                } else {
                    phi_626_ = type_29(0u, 4u);
                    loop {
                        let _e213 = phi_626_;
                        if (_e213.member < _e213.member_1) {
                            phi_627_ = type_29((_e213.member + 1u), _e213.member_1);
                            phi_650_ = type_29(1u, _e213.member);
                        } else {
                            phi_627_ = _e213;
                            phi_650_ = type_29(0u, type_29().member_1);
                        }
                        let _e227 = phi_627_;
                        let _e229 = phi_650_;
                        let _e233 = (bitcast<i32>(_e229.member) != 0i);
                        if _e233 {
                            if (_e229.member_1 < 4u) {
                            } else {
                                return;
                            }
                            let _e236 = local_15[_e229.member_1];
                            let _e238 = wide.member[_e236];
                            if (_e229.member_1 < 4u) {
                            } else {
                                return;
                            }
                            local_16[_e229.member_1] = array<f64, 3>(_e238.member[0], _e238.member[1], _e238.member[2]);
                            if (_e229.member_1 < 4u) {
                            } else {
                                return;
                            }
                            local_17[_e229.member_1] = array<f64, 3>(_e238.member_1[0], _e238.member_1[1], _e238.member_1[2]);
                        }
                        continue;
                        continuing {
                            phi_626_ = _e227;
                            break if !(_e233);
                        }
                    }
                }
                let _e370 = local_16;
                let _e387 = local_17;
                local_20 = type_62(array<array<f64, 3>, 2>(array<f64, 3>((_e370[0][0] - _e370[1][0]), (_e370[0][1] - _e370[1][1]), (_e370[0][2] - _e370[1][2])), array<f64, 3>((_e387[0][0] - _e387[1][0]), (_e387[0][1] - _e387[1][1]), (_e387[0][2] - _e387[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e370[2][0] - _e370[1][0]), (_e370[2][1] - _e370[1][1]), (_e370[2][2] - _e370[1][2])), array<f64, 3>((_e387[2][0] - _e387[1][0]), (_e387[2][1] - _e387[1][1]), (_e387[2][2] - _e387[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e370[3][0] - _e370[1][0]), (_e370[3][1] - _e370[1][1]), (_e370[3][2] - _e370[1][2])), array<f64, 3>((_e387[3][0] - _e387[1][0]), (_e387[3][1] - _e387[1][1]), (_e387[3][2] - _e387[1][2]))), (0.0lf + 0.0lf));
                let _e434 = params.member.member_7;
                let _e441 = bitcast<f64>(((u64(_e434[1]) * 4294967296lu) + u64(_e434[0])));
                let _e442 = f64(0f);
                let _e445 = local_20.member_1[0u];
                let _e451 = local_20.member_2[0u];
                let _e457 = ((_e445[1] * _e451[2]) - (_e445[2] * _e451[1]));
                let _e460 = ((_e445[2] * _e451[0]) - (_e445[0] * _e451[2]));
                let _e463 = ((_e445[0] * _e451[1]) - (_e445[1] * _e451[0]));
                let _e466 = local_20.member_1[1u];
                let _e472 = local_20.member_2[1u];
                let _e478 = ((_e466[1] * _e472[2]) - (_e466[2] * _e472[1]));
                let _e481 = ((_e466[2] * _e472[0]) - (_e466[0] * _e472[2]));
                let _e484 = ((_e466[0] * _e472[1]) - (_e466[1] * _e472[0]));
                let _e487 = local_20.member_1[0u];
                let _e493 = local_20.member_2[1u];
                let _e508 = local_20.member_1[1u];
                let _e514 = local_20.member_2[0u];
                let _e527 = (((_e487[1] * _e493[2]) - (_e487[2] * _e493[1])) + ((_e508[1] * _e514[2]) - (_e508[2] * _e514[1])));
                let _e528 = (((_e487[2] * _e493[0]) - (_e487[0] * _e493[2])) + ((_e508[2] * _e514[0]) - (_e508[0] * _e514[2])));
                let _e529 = (((_e487[0] * _e493[1]) - (_e487[1] * _e493[0])) + ((_e508[0] * _e514[1]) - (_e508[1] * _e514[0])));
                let _e532 = local_20.member[0u];
                let _e540 = (((_e532[0] * _e457) + (_e532[1] * _e460)) + (_e532[2] * _e463));
                let _e543 = local_20.member[1u];
                let _e554 = local_20.member[0u];
                let _e563 = ((((_e543[0] * _e457) + (_e543[1] * _e460)) + (_e543[2] * _e463)) + (((_e554[0] * _e527) + (_e554[1] * _e528)) + (_e554[2] * _e529)));
                let _e566 = local_20.member[0u];
                let _e577 = local_20.member[1u];
                let _e586 = ((((_e566[0] * _e478) + (_e566[1] * _e481)) + (_e566[2] * _e484)) + (((_e577[0] * _e527) + (_e577[1] * _e528)) + (_e577[2] * _e529)));
                let _e589 = local_20.member[1u];
                let _e597 = (((_e589[0] * _e478) + (_e589[1] * _e481)) + (_e589[2] * _e484));
                let _e600 = local_20.member[0u];
                if (_e600[0] < 0.0lf) {
                    phi_1107_ = -(_e600[0]);
                } else {
                    phi_1107_ = _e600[0];
                }
                let _e607 = phi_1107_;
                if (_e600[1] < 0.0lf) {
                    phi_1114_ = -(_e600[1]);
                } else {
                    phi_1114_ = _e600[1];
                }
                let _e611 = phi_1114_;
                if (_e607 > _e611) {
                    phi_1119_ = _e607;
                } else {
                    phi_1119_ = _e611;
                }
                let _e614 = phi_1119_;
                if (_e600[2] < 0.0lf) {
                    phi_1126_ = -(_e600[2]);
                } else {
                    phi_1126_ = _e600[2];
                }
                let _e618 = phi_1126_;
                if (_e614 > _e618) {
                    phi_1131_ = _e614;
                } else {
                    phi_1131_ = _e618;
                }
                let _e621 = phi_1131_;
                let _e624 = local_20.member[1u];
                if (_e624[0] < 0.0lf) {
                    phi_1144_ = -(_e624[0]);
                } else {
                    phi_1144_ = _e624[0];
                }
                let _e631 = phi_1144_;
                if (_e624[1] < 0.0lf) {
                    phi_1151_ = -(_e624[1]);
                } else {
                    phi_1151_ = _e624[1];
                }
                let _e635 = phi_1151_;
                if (_e631 > _e635) {
                    phi_1156_ = _e631;
                } else {
                    phi_1156_ = _e635;
                }
                let _e638 = phi_1156_;
                if (_e624[2] < 0.0lf) {
                    phi_1163_ = -(_e624[2]);
                } else {
                    phi_1163_ = _e624[2];
                }
                let _e642 = phi_1163_;
                if (_e638 > _e642) {
                    phi_1168_ = _e638;
                } else {
                    phi_1168_ = _e642;
                }
                let _e645 = phi_1168_;
                if (_e621 > _e645) {
                    phi_1173_ = _e621;
                } else {
                    phi_1173_ = _e645;
                }
                let _e648 = phi_1173_;
                let _e650 = local_20.member_3;
                let _e651 = (_e648 + _e650);
                let _e654 = local_20.member_1[0u];
                if (_e654[0] < 0.0lf) {
                    phi_1190_ = -(_e654[0]);
                } else {
                    phi_1190_ = _e654[0];
                }
                let _e661 = phi_1190_;
                if (_e654[1] < 0.0lf) {
                    phi_1197_ = -(_e654[1]);
                } else {
                    phi_1197_ = _e654[1];
                }
                let _e665 = phi_1197_;
                if (_e661 > _e665) {
                    phi_1202_ = _e661;
                } else {
                    phi_1202_ = _e665;
                }
                let _e668 = phi_1202_;
                if (_e654[2] < 0.0lf) {
                    phi_1209_ = -(_e654[2]);
                } else {
                    phi_1209_ = _e654[2];
                }
                let _e672 = phi_1209_;
                if (_e668 > _e672) {
                    phi_1214_ = _e668;
                } else {
                    phi_1214_ = _e672;
                }
                let _e675 = phi_1214_;
                let _e678 = local_20.member_1[1u];
                if (_e678[0] < 0.0lf) {
                    phi_1228_ = -(_e678[0]);
                } else {
                    phi_1228_ = _e678[0];
                }
                let _e685 = phi_1228_;
                if (_e678[1] < 0.0lf) {
                    phi_1235_ = -(_e678[1]);
                } else {
                    phi_1235_ = _e678[1];
                }
                let _e689 = phi_1235_;
                if (_e685 > _e689) {
                    phi_1240_ = _e685;
                } else {
                    phi_1240_ = _e689;
                }
                let _e692 = phi_1240_;
                if (_e678[2] < 0.0lf) {
                    phi_1247_ = -(_e678[2]);
                } else {
                    phi_1247_ = _e678[2];
                }
                let _e696 = phi_1247_;
                if (_e692 > _e696) {
                    phi_1252_ = _e692;
                } else {
                    phi_1252_ = _e696;
                }
                let _e699 = phi_1252_;
                if (_e675 > _e699) {
                    phi_1257_ = _e675;
                } else {
                    phi_1257_ = _e699;
                }
                let _e702 = phi_1257_;
                let _e704 = local_20.member_3;
                let _e705 = (_e702 + _e704);
                let _e708 = local_20.member_2[0u];
                if (_e708[0] < 0.0lf) {
                    phi_1274_ = -(_e708[0]);
                } else {
                    phi_1274_ = _e708[0];
                }
                let _e715 = phi_1274_;
                if (_e708[1] < 0.0lf) {
                    phi_1281_ = -(_e708[1]);
                } else {
                    phi_1281_ = _e708[1];
                }
                let _e719 = phi_1281_;
                if (_e715 > _e719) {
                    phi_1286_ = _e715;
                } else {
                    phi_1286_ = _e719;
                }
                let _e722 = phi_1286_;
                if (_e708[2] < 0.0lf) {
                    phi_1293_ = -(_e708[2]);
                } else {
                    phi_1293_ = _e708[2];
                }
                let _e726 = phi_1293_;
                if (_e722 > _e726) {
                    phi_1298_ = _e722;
                } else {
                    phi_1298_ = _e726;
                }
                let _e729 = phi_1298_;
                let _e732 = local_20.member_2[1u];
                if (_e732[0] < 0.0lf) {
                    phi_1312_ = -(_e732[0]);
                } else {
                    phi_1312_ = _e732[0];
                }
                let _e739 = phi_1312_;
                if (_e732[1] < 0.0lf) {
                    phi_1319_ = -(_e732[1]);
                } else {
                    phi_1319_ = _e732[1];
                }
                let _e743 = phi_1319_;
                if (_e739 > _e743) {
                    phi_1324_ = _e739;
                } else {
                    phi_1324_ = _e743;
                }
                let _e746 = phi_1324_;
                if (_e732[2] < 0.0lf) {
                    phi_1331_ = -(_e732[2]);
                } else {
                    phi_1331_ = _e732[2];
                }
                let _e750 = phi_1331_;
                if (_e746 > _e750) {
                    phi_1336_ = _e746;
                } else {
                    phi_1336_ = _e750;
                }
                let _e753 = phi_1336_;
                if (_e729 > _e753) {
                    phi_1341_ = _e729;
                } else {
                    phi_1341_ = _e753;
                }
                let _e756 = phi_1341_;
                let _e758 = local_20.member_3;
                let _e759 = (_e756 + _e758);
                let _e760 = f64(1f);
                let _e761 = f64(8f);
                let _e763 = ((_e705 * _e761) * _e759);
                let _e771 = local_20.member_3;
                if (_e457 < 0.0lf) {
                    phi_1378_ = -(_e457);
                } else {
                    phi_1378_ = _e457;
                }
                let _e791 = phi_1378_;
                if (_e460 < 0.0lf) {
                    phi_1384_ = -(_e460);
                } else {
                    phi_1384_ = _e460;
                }
                let _e795 = phi_1384_;
                if (_e463 < 0.0lf) {
                    phi_1391_ = -(_e463);
                } else {
                    phi_1391_ = _e463;
                }
                let _e800 = phi_1391_;
                let _e801 = ((_e791 + _e795) + _e800);
                if (_e478 < 0.0lf) {
                    phi_1398_ = -(_e478);
                } else {
                    phi_1398_ = _e478;
                }
                let _e805 = phi_1398_;
                if (_e481 < 0.0lf) {
                    phi_1404_ = -(_e481);
                } else {
                    phi_1404_ = _e481;
                }
                let _e809 = phi_1404_;
                if (_e484 < 0.0lf) {
                    phi_1411_ = -(_e484);
                } else {
                    phi_1411_ = _e484;
                }
                let _e814 = phi_1411_;
                let _e815 = ((_e805 + _e809) + _e814);
                if (_e801 > _e815) {
                    phi_1417_ = _e801;
                } else {
                    phi_1417_ = _e815;
                }
                let _e818 = phi_1417_;
                if (_e527 < 0.0lf) {
                    phi_1423_ = -(_e527);
                } else {
                    phi_1423_ = _e527;
                }
                let _e822 = phi_1423_;
                if (_e528 < 0.0lf) {
                    phi_1429_ = -(_e528);
                } else {
                    phi_1429_ = _e528;
                }
                let _e826 = phi_1429_;
                if (_e529 < 0.0lf) {
                    phi_1436_ = -(_e529);
                } else {
                    phi_1436_ = _e529;
                }
                let _e831 = phi_1436_;
                let _e833 = (((_e822 + _e826) + _e831) * f64(0.5f));
                if (_e818 > _e833) {
                    phi_1443_ = _e818;
                } else {
                    phi_1443_ = _e833;
                }
                let _e836 = phi_1443_;
                let _e842 = local_20.member_3;
                let _e856 = (((((_e651 * _e761) * _e763) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e771 * f64(19f)) * ((_e651 * (_e705 + _e759)) + (_e705 * _e759)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e760 + _e651) * ((_e760 + _e705) * (_e760 + _e759)))));
                let _e857 = f64(3f);
                let _e858 = (_e540 * _e857);
                let _e859 = (_e597 * _e857);
                if (_e858 < _e859) {
                    phi_1471_ = _e858;
                } else {
                    phi_1471_ = _e859;
                }
                let _e862 = phi_1471_;
                if (_e563 < _e586) {
                    phi_1476_ = _e563;
                } else {
                    phi_1476_ = _e586;
                }
                let _e865 = phi_1476_;
                if (_e862 < _e865) {
                    phi_1481_ = _e862;
                } else {
                    phi_1481_ = _e865;
                }
                let _e868 = phi_1481_;
                if (_e858 > _e859) {
                    phi_1486_ = _e858;
                } else {
                    phi_1486_ = _e859;
                }
                let _e871 = phi_1486_;
                if (_e563 > _e586) {
                    phi_1491_ = _e563;
                } else {
                    phi_1491_ = _e586;
                }
                let _e874 = phi_1491_;
                if (_e871 > _e874) {
                    phi_1496_ = _e871;
                } else {
                    phi_1496_ = _e874;
                }
                let _e877 = phi_1496_;
                let _e883 = -(_e877);
                if (_e868 > _e883) {
                    phi_1507_ = _e868;
                } else {
                    phi_1507_ = _e883;
                }
                let _e886 = phi_1507_;
                if ((_e886 - (_e856 + ((_e441 * (((_e836 + (_e763 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e842 * f64(6f)) * (_e705 + _e759))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e760 + _e705) * (_e760 + _e759))))) * f64((3f * 1.0001f))))) > _e442) {
                    phi_7311_ = type_73(0u, type_73().member_1);
                } else {
                    if (_e441 > _e442) {
                        let _e3182 = f64(1f);
                        let _e3186 = local_20.member[0u];
                        let _e3192 = local_20.member_1[0u];
                        let _e3198 = local_20.member_2[0u];
                        local_12 = array<array<f64, 3>, 4>(_e3186, array<f64, 3>((_e3186[0] - _e3192[0]), (_e3186[1] - _e3192[1]), (_e3186[2] - _e3192[2])), array<f64, 3>((_e3186[0] - _e3198[0]), (_e3186[1] - _e3198[1]), (_e3186[2] - _e3198[2])), _e3186);
                        let _e3213 = local_20.member[1u];
                        let _e3219 = local_20.member_1[1u];
                        let _e3225 = local_20.member_2[1u];
                        local_13 = array<array<f64, 3>, 4>(_e3213, array<f64, 3>((_e3213[0] - _e3219[0]), (_e3213[1] - _e3219[1]), (_e3213[2] - _e3219[2])), array<f64, 3>((_e3213[0] - _e3225[0]), (_e3213[1] - _e3225[1]), (_e3213[2] - _e3225[2])), _e3213);
                        let _e3240 = local_20.member[0u];
                        if (_e3240[0] < 0.0lf) {
                            phi_1710_ = -(_e3240[0]);
                        } else {
                            phi_1710_ = _e3240[0];
                        }
                        let _e3247 = phi_1710_;
                        if (_e3240[1] < 0.0lf) {
                            phi_1717_ = -(_e3240[1]);
                        } else {
                            phi_1717_ = _e3240[1];
                        }
                        let _e3251 = phi_1717_;
                        if (_e3247 > _e3251) {
                            phi_1722_ = _e3247;
                        } else {
                            phi_1722_ = _e3251;
                        }
                        let _e3254 = phi_1722_;
                        if (_e3240[2] < 0.0lf) {
                            phi_1729_ = -(_e3240[2]);
                        } else {
                            phi_1729_ = _e3240[2];
                        }
                        let _e3258 = phi_1729_;
                        if (_e3254 > _e3258) {
                            phi_1734_ = _e3254;
                        } else {
                            phi_1734_ = _e3258;
                        }
                        let _e3261 = phi_1734_;
                        let _e3264 = local_20.member[1u];
                        if (_e3264[0] < 0.0lf) {
                            phi_1747_ = -(_e3264[0]);
                        } else {
                            phi_1747_ = _e3264[0];
                        }
                        let _e3271 = phi_1747_;
                        if (_e3264[1] < 0.0lf) {
                            phi_1754_ = -(_e3264[1]);
                        } else {
                            phi_1754_ = _e3264[1];
                        }
                        let _e3275 = phi_1754_;
                        if (_e3271 > _e3275) {
                            phi_1759_ = _e3271;
                        } else {
                            phi_1759_ = _e3275;
                        }
                        let _e3278 = phi_1759_;
                        if (_e3264[2] < 0.0lf) {
                            phi_1766_ = -(_e3264[2]);
                        } else {
                            phi_1766_ = _e3264[2];
                        }
                        let _e3282 = phi_1766_;
                        if (_e3278 > _e3282) {
                            phi_1771_ = _e3278;
                        } else {
                            phi_1771_ = _e3282;
                        }
                        let _e3285 = phi_1771_;
                        if (_e3261 > _e3285) {
                            phi_1776_ = _e3261;
                        } else {
                            phi_1776_ = _e3285;
                        }
                        let _e3288 = phi_1776_;
                        let _e3290 = local_20.member_3;
                        let _e3294 = local_20.member_1[0u];
                        if (_e3294[0] < 0.0lf) {
                            phi_1793_ = -(_e3294[0]);
                        } else {
                            phi_1793_ = _e3294[0];
                        }
                        let _e3301 = phi_1793_;
                        if (_e3294[1] < 0.0lf) {
                            phi_1800_ = -(_e3294[1]);
                        } else {
                            phi_1800_ = _e3294[1];
                        }
                        let _e3305 = phi_1800_;
                        if (_e3301 > _e3305) {
                            phi_1805_ = _e3301;
                        } else {
                            phi_1805_ = _e3305;
                        }
                        let _e3308 = phi_1805_;
                        if (_e3294[2] < 0.0lf) {
                            phi_1812_ = -(_e3294[2]);
                        } else {
                            phi_1812_ = _e3294[2];
                        }
                        let _e3312 = phi_1812_;
                        if (_e3308 > _e3312) {
                            phi_1817_ = _e3308;
                        } else {
                            phi_1817_ = _e3312;
                        }
                        let _e3315 = phi_1817_;
                        let _e3318 = local_20.member_1[1u];
                        if (_e3318[0] < 0.0lf) {
                            phi_1831_ = -(_e3318[0]);
                        } else {
                            phi_1831_ = _e3318[0];
                        }
                        let _e3325 = phi_1831_;
                        if (_e3318[1] < 0.0lf) {
                            phi_1838_ = -(_e3318[1]);
                        } else {
                            phi_1838_ = _e3318[1];
                        }
                        let _e3329 = phi_1838_;
                        if (_e3325 > _e3329) {
                            phi_1843_ = _e3325;
                        } else {
                            phi_1843_ = _e3329;
                        }
                        let _e3332 = phi_1843_;
                        if (_e3318[2] < 0.0lf) {
                            phi_1850_ = -(_e3318[2]);
                        } else {
                            phi_1850_ = _e3318[2];
                        }
                        let _e3336 = phi_1850_;
                        if (_e3332 > _e3336) {
                            phi_1855_ = _e3332;
                        } else {
                            phi_1855_ = _e3336;
                        }
                        let _e3339 = phi_1855_;
                        if (_e3315 > _e3339) {
                            phi_1860_ = _e3315;
                        } else {
                            phi_1860_ = _e3339;
                        }
                        let _e3342 = phi_1860_;
                        let _e3344 = local_20.member_3;
                        let _e3348 = local_20.member_2[0u];
                        if (_e3348[0] < 0.0lf) {
                            phi_1877_ = -(_e3348[0]);
                        } else {
                            phi_1877_ = _e3348[0];
                        }
                        let _e3355 = phi_1877_;
                        if (_e3348[1] < 0.0lf) {
                            phi_1884_ = -(_e3348[1]);
                        } else {
                            phi_1884_ = _e3348[1];
                        }
                        let _e3359 = phi_1884_;
                        if (_e3355 > _e3359) {
                            phi_1889_ = _e3355;
                        } else {
                            phi_1889_ = _e3359;
                        }
                        let _e3362 = phi_1889_;
                        if (_e3348[2] < 0.0lf) {
                            phi_1896_ = -(_e3348[2]);
                        } else {
                            phi_1896_ = _e3348[2];
                        }
                        let _e3366 = phi_1896_;
                        if (_e3362 > _e3366) {
                            phi_1901_ = _e3362;
                        } else {
                            phi_1901_ = _e3366;
                        }
                        let _e3369 = phi_1901_;
                        let _e3372 = local_20.member_2[1u];
                        if (_e3372[0] < 0.0lf) {
                            phi_1915_ = -(_e3372[0]);
                        } else {
                            phi_1915_ = _e3372[0];
                        }
                        let _e3379 = phi_1915_;
                        if (_e3372[1] < 0.0lf) {
                            phi_1922_ = -(_e3372[1]);
                        } else {
                            phi_1922_ = _e3372[1];
                        }
                        let _e3383 = phi_1922_;
                        if (_e3379 > _e3383) {
                            phi_1927_ = _e3379;
                        } else {
                            phi_1927_ = _e3383;
                        }
                        let _e3386 = phi_1927_;
                        if (_e3372[2] < 0.0lf) {
                            phi_1934_ = -(_e3372[2]);
                        } else {
                            phi_1934_ = _e3372[2];
                        }
                        let _e3390 = phi_1934_;
                        if (_e3386 > _e3390) {
                            phi_1939_ = _e3386;
                        } else {
                            phi_1939_ = _e3390;
                        }
                        let _e3393 = phi_1939_;
                        if (_e3369 > _e3393) {
                            phi_1944_ = _e3369;
                        } else {
                            phi_1944_ = _e3393;
                        }
                        let _e3396 = phi_1944_;
                        let _e3398 = local_20.member_3;
                        let _e3406 = local_20.member_3;
                        phi_1964_ = type_29(0u, 48u);
                        phi_1967_ = f64(0f);
                        loop {
                            let _e3415 = phi_1964_;
                            let _e3417 = phi_1967_;
                            local_79 = _e3417;
                            local_44 = _e3417;
                            local_45 = _e3417;
                            local_46 = _e3417;
                            if (_e3415.member < _e3415.member_1) {
                                phi_1965_ = type_29((_e3415.member + 1u), _e3415.member_1);
                                phi_1990_ = type_29(1u, _e3415.member);
                            } else {
                                phi_1965_ = _e3415;
                                phi_1990_ = type_29(0u, type_29().member_1);
                            }
                            let _e3431 = phi_1965_;
                            let _e3433 = phi_1990_;
                            if (bitcast<i32>(_e3433.member) != 0i) {
                                let _e3439 = local_20.member[0u];
                                let _e3445 = local_20.member[1u];
                                let _e3455 = (_e3439[0] + ((_e3445[0] - _e3439[0]) * _e3417));
                                let _e3456 = (_e3439[1] + ((_e3445[1] - _e3439[1]) * _e3417));
                                let _e3457 = (_e3439[2] + ((_e3445[2] - _e3439[2]) * _e3417));
                                let _e3460 = local_20.member_1[0u];
                                let _e3466 = local_20.member_1[1u];
                                let _e3476 = (_e3460[0] + ((_e3466[0] - _e3460[0]) * _e3417));
                                let _e3477 = (_e3460[1] + ((_e3466[1] - _e3460[1]) * _e3417));
                                let _e3478 = (_e3460[2] + ((_e3466[2] - _e3460[2]) * _e3417));
                                let _e3481 = local_20.member_2[0u];
                                let _e3487 = local_20.member_2[1u];
                                let _e3497 = (_e3481[0] + ((_e3487[0] - _e3481[0]) * _e3417));
                                let _e3498 = (_e3481[1] + ((_e3487[1] - _e3481[1]) * _e3417));
                                let _e3499 = (_e3481[2] + ((_e3487[2] - _e3481[2]) * _e3417));
                                let _e3504 = (((_e3476 * _e3476) + (_e3477 * _e3477)) + (_e3478 * _e3478));
                                let _e3509 = (((_e3476 * _e3497) + (_e3477 * _e3498)) + (_e3478 * _e3499));
                                let _e3514 = (((_e3497 * _e3497) + (_e3498 * _e3498)) + (_e3499 * _e3499));
                                let _e3519 = (((_e3455 * _e3476) + (_e3456 * _e3477)) + (_e3457 * _e3478));
                                let _e3524 = (((_e3455 * _e3497) + (_e3456 * _e3498)) + (_e3457 * _e3499));
                                let _e3527 = ((_e3504 * _e3514) - (_e3509 * _e3509));
                                let _e3528 = f64(0f);
                                let _e3533 = (((_e3519 * _e3514) - (_e3524 * _e3509)) / _e3527);
                                let _e3537 = (((_e3524 * _e3504) - (_e3519 * _e3509)) / _e3527);
                                if (_e3533 >= _e3528) {
                                    if (_e3537 >= _e3528) {
                                        phi_2166_ = ((_e3533 + _e3537) <= f64(1f));
                                        phi_2167_ = false;
                                    } else {
                                        phi_2166_ = bool();
                                        phi_2167_ = true;
                                    }
                                    let _e3543 = phi_2166_;
                                    let _e3545 = phi_2167_;
                                    phi_2168_ = _e3543;
                                    phi_2169_ = _e3545;
                                } else {
                                    phi_2168_ = bool();
                                    phi_2169_ = true;
                                }
                                let _e3547 = phi_2168_;
                                let _e3549 = phi_2169_;
                                if _e3549 {
                                    phi_2173_ = false;
                                } else {
                                    phi_2173_ = _e3547;
                                }
                                let _e3551 = phi_2173_;
                                if (_e3527 > _e3528) {
                                    if _e3551 {
                                        phi_2195_ = array<f64, 3>((_e3455 - ((_e3476 * _e3533) + (_e3497 * _e3537))), (_e3456 - ((_e3477 * _e3533) + (_e3498 * _e3537))), (_e3457 - ((_e3478 * _e3533) + (_e3499 * _e3537))));
                                        phi_2196_ = false;
                                    } else {
                                        phi_2195_ = array<f64, 3>();
                                        phi_2196_ = true;
                                    }
                                    let _e3567 = phi_2195_;
                                    let _e3569 = phi_2196_;
                                    phi_2197_ = _e3567;
                                    phi_2198_ = _e3569;
                                } else {
                                    phi_2197_ = array<f64, 3>();
                                    phi_2198_ = true;
                                }
                                let _e3571 = phi_2197_;
                                let _e3573 = phi_2198_;
                                if _e3573 {
                                    let _e3574 = (_e3455 - _e3476);
                                    let _e3575 = (_e3456 - _e3477);
                                    let _e3576 = (_e3457 - _e3478);
                                    let _e3577 = (_e3497 - _e3476);
                                    let _e3578 = (_e3498 - _e3477);
                                    let _e3579 = (_e3499 - _e3478);
                                    let _e3590 = ((((_e3574 * _e3577) + (_e3575 * _e3578)) + (_e3576 * _e3579)) / (((_e3577 * _e3577) + (_e3578 * _e3578)) + (_e3579 * _e3579)));
                                    if (_e3590 > f64(0f)) {
                                        if (_e3590 < f64(1f)) {
                                            phi_2385_ = _e3590;
                                        } else {
                                            phi_2385_ = f64(1f);
                                        }
                                        let _e3598 = phi_2385_;
                                        phi_2387_ = _e3598;
                                    } else {
                                        phi_2387_ = f64(0f);
                                    }
                                    let _e3600 = phi_2387_;
                                    let _e3604 = (_e3574 - (_e3577 * _e3600));
                                    let _e3605 = (_e3575 - (_e3578 * _e3600));
                                    let _e3606 = (_e3576 - (_e3579 * _e3600));
                                    let _e3617 = ((((_e3455 * _e3476) + (_e3456 * _e3477)) + (_e3457 * _e3478)) / (((_e3476 * _e3476) + (_e3477 * _e3477)) + (_e3478 * _e3478)));
                                    if (_e3617 > f64(0f)) {
                                        if (_e3617 < f64(1f)) {
                                            phi_2417_ = _e3617;
                                        } else {
                                            phi_2417_ = f64(1f);
                                        }
                                        let _e3625 = phi_2417_;
                                        phi_2419_ = _e3625;
                                    } else {
                                        phi_2419_ = f64(0f);
                                    }
                                    let _e3627 = phi_2419_;
                                    let _e3644 = ((((_e3455 * _e3497) + (_e3456 * _e3498)) + (_e3457 * _e3499)) / (((_e3497 * _e3497) + (_e3498 * _e3498)) + (_e3499 * _e3499)));
                                    if (_e3644 > f64(0f)) {
                                        if (_e3644 < f64(1f)) {
                                            phi_2449_ = _e3644;
                                        } else {
                                            phi_2449_ = f64(1f);
                                        }
                                        let _e3652 = phi_2449_;
                                        phi_2451_ = _e3652;
                                    } else {
                                        phi_2451_ = f64(0f);
                                    }
                                    let _e3654 = phi_2451_;
                                    local_11[0u] = array<f64, 3>((_e3455 - (_e3476 * _e3627)), (_e3456 - (_e3477 * _e3627)), (_e3457 - (_e3478 * _e3627)));
                                    local_11[1u] = array<f64, 3>((_e3455 - (_e3497 * _e3654)), (_e3456 - (_e3498 * _e3654)), (_e3457 - (_e3499 * _e3654)));
                                    local_11[2u] = array<f64, 3>(_e3604, _e3605, _e3606);
                                    local_11[3u] = array<f64, 3>(_e3604, _e3605, _e3606);
                                    let _e3670 = local_11[0u];
                                    phi_2487_ = type_29(1u, 4u);
                                    phi_2490_ = array<f64, 3>(_e3670[0], _e3670[1], _e3670[2]);
                                    loop {
                                        let _e3676 = phi_2487_;
                                        let _e3678 = phi_2490_;
                                        local_69 = _e3678;
                                        if (_e3676.member < _e3676.member_1) {
                                            phi_2488_ = type_29((_e3676.member + 1u), _e3676.member_1);
                                            phi_2513_ = type_29(1u, _e3676.member);
                                        } else {
                                            phi_2488_ = _e3676;
                                            phi_2513_ = type_29(0u, type_29().member_1);
                                        }
                                        let _e3692 = phi_2488_;
                                        let _e3694 = phi_2513_;
                                        let _e3698 = (bitcast<i32>(_e3694.member) != 0i);
                                        if _e3698 {
                                            if (_e3694.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3701 = local_11[_e3694.member_1];
                                            if (_e3694.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3707 = local_11[_e3694.member_1];
                                            if ((((_e3701[0] * _e3707[0]) + (_e3701[1] * _e3707[1])) + (_e3701[2] * _e3707[2])) < (((_e3678[0] * _e3678[0]) + (_e3678[1] * _e3678[1])) + (_e3678[2] * _e3678[2]))) {
                                                if (_e3694.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3730 = local_11[_e3694.member_1];
                                                phi_2580_ = array<f64, 3>(_e3730[0], _e3730[1], _e3730[2]);
                                            } else {
                                                phi_2580_ = _e3678;
                                            }
                                            let _e3736 = phi_2580_;
                                            phi_2491_ = _e3736;
                                        } else {
                                            phi_2491_ = array<f64, 3>();
                                        }
                                        let _e3738 = phi_2491_;
                                        continue;
                                        continuing {
                                            phi_2487_ = _e3692;
                                            phi_2490_ = _e3738;
                                            break if !(_e3698);
                                        }
                                    }
                                    let _e5420 = local_69;
                                    phi_2581_ = _e5420;
                                } else {
                                    phi_2581_ = _e3571;
                                }
                                let _e3741 = phi_2581_;
                                if (_e3741[0] < 0.0lf) {
                                    phi_2588_ = -(_e3741[0]);
                                } else {
                                    phi_2588_ = _e3741[0];
                                }
                                let _e3746 = phi_2588_;
                                if (_e3741[1] < 0.0lf) {
                                    phi_2595_ = -(_e3741[1]);
                                } else {
                                    phi_2595_ = _e3741[1];
                                }
                                let _e3751 = phi_2595_;
                                if (_e3741[2] < 0.0lf) {
                                    phi_2603_ = -(_e3741[2]);
                                } else {
                                    phi_2603_ = _e3741[2];
                                }
                                let _e3757 = phi_2603_;
                                let _e3758 = ((_e3746 + _e3751) + _e3757);
                                if (_e3758 > f64(0f)) {
                                    if ((bitcast<u64>(_e3758) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e3764 = (f64(1f) / _e3758);
                                        let _e3766 = (_e3741[0] * _e3764);
                                        let _e3768 = (_e3741[1] * _e3764);
                                        let _e3770 = (_e3741[2] * _e3764);
                                        let _e3775 = (((_e3766 * _e3766) + (_e3768 * _e3768)) + (_e3770 * _e3770));
                                        if (_e3775 <= 2.2250738585072014e-308lf) {
                                            if (_e3775 > 0.0lf) {
                                                phi_2641_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2641_ = 0.0lf;
                                            }
                                            let _e3833 = phi_2641_;
                                            phi_2705_ = _e3833;
                                        } else {
                                            phi_2648_ = type_27(0i, 5i);
                                            phi_2651_ = bitcast<f64>(((bitcast<u64>(_e3775) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e3782 = phi_2648_;
                                                let _e3784 = phi_2651_;
                                                local_38 = _e3784;
                                                if (_e3782.member < _e3782.member_1) {
                                                    let _e3792 = (_e3782.member + 1i);
                                                    if ((false == (_e3792 > _e3782.member)) != false) {
                                                        phi_2672_ = true;
                                                    } else {
                                                        phi_2672_ = false;
                                                    }
                                                    let _e3797 = phi_2672_;
                                                    if _e3797 {
                                                        phi_2678_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_2678_ = type_28(1u, _e3792);
                                                    }
                                                    let _e3803 = phi_2678_;
                                                    if (bitcast<i32>(_e3803.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2649_ = type_27(_e3803.member_1, _e3782.member_1);
                                                    phi_2692_ = type_28(1u, _e3782.member);
                                                } else {
                                                    phi_2649_ = _e3782;
                                                    phi_2692_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e3813 = phi_2649_;
                                                let _e3815 = phi_2692_;
                                                let _e3818 = (bitcast<i32>(_e3815.member) != 0i);
                                                if _e3818 {
                                                    phi_2652_ = (0.5lf * (_e3784 + (_e3775 / _e3784)));
                                                } else {
                                                    phi_2652_ = f64();
                                                }
                                                let _e3823 = phi_2652_;
                                                continue;
                                                continuing {
                                                    phi_2648_ = _e3813;
                                                    phi_2651_ = _e3823;
                                                    break if !(_e3818);
                                                }
                                            }
                                            let _e3828 = local_38;
                                            phi_2705_ = (_e3828 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e3835 = phi_2705_;
                                        phi_2718_ = type_29(0u, 4u);
                                        phi_2721_ = f64(2f);
                                        loop {
                                            let _e3847 = phi_2718_;
                                            let _e3849 = phi_2721_;
                                            local_40 = _e3849;
                                            local_41 = _e3849;
                                            local_42 = _e3849;
                                            local_70 = _e3849;
                                            local_71 = _e3849;
                                            if (_e3847.member < _e3847.member_1) {
                                                phi_2719_ = type_29((_e3847.member + 1u), _e3847.member_1);
                                                phi_2744_ = type_29(1u, _e3847.member);
                                            } else {
                                                phi_2719_ = _e3847;
                                                phi_2744_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e3863 = phi_2719_;
                                            let _e3865 = phi_2744_;
                                            if (bitcast<i32>(_e3865.member) != 0i) {
                                                if (_e3865.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3872 = local_12[_e3865.member_1];
                                                let _e3880 = (((_e3766 * _e3872[0]) + (_e3768 * _e3872[1])) + (_e3770 * _e3872[2]));
                                                if (_e3865.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3883 = local_13[_e3865.member_1];
                                                let _e3891 = (((_e3766 * _e3883[0]) + (_e3768 * _e3883[1])) + (_e3770 * _e3883[2]));
                                                if (_e3880 < 0.0lf) {
                                                    phi_2795_ = -(_e3880);
                                                } else {
                                                    phi_2795_ = _e3880;
                                                }
                                                let _e3895 = phi_2795_;
                                                if (_e3891 < 0.0lf) {
                                                    phi_2801_ = -(_e3891);
                                                } else {
                                                    phi_2801_ = _e3891;
                                                }
                                                let _e3899 = phi_2801_;
                                                let _e3904 = (((((((((_e3288 + _e3290) + (_e3342 + _e3344)) + (_e3396 + _e3398)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3406 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e441 * _e3835) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e3895 + _e3899) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e3880 > _e3904) {
                                                    if (_e3891 > _e3904) {
                                                        phi_2815_ = false;
                                                    } else {
                                                        phi_2815_ = true;
                                                    }
                                                    let _e3908 = phi_2815_;
                                                    phi_2816_ = _e3908;
                                                } else {
                                                    phi_2816_ = true;
                                                }
                                                let _e3910 = phi_2816_;
                                                if _e3910 {
                                                    let _e3914 = ((_e3880 + ((_e3891 - _e3880) * _e3417)) > _e3904);
                                                    if _e3914 {
                                                        if (_e3891 < _e3880) {
                                                            let _e3923 = (((_e3880 - _e3904) / (_e3880 - _e3891)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                            if (_e3849 < _e3923) {
                                                                phi_2843_ = _e3849;
                                                            } else {
                                                                phi_2843_ = _e3923;
                                                            }
                                                            let _e3926 = phi_2843_;
                                                            phi_2844_ = _e3926;
                                                        } else {
                                                            phi_2844_ = _e3849;
                                                        }
                                                        let _e3928 = phi_2844_;
                                                        phi_2845_ = _e3928;
                                                    } else {
                                                        phi_2845_ = f64();
                                                    }
                                                    let _e3930 = phi_2845_;
                                                    phi_2846_ = _e3930;
                                                    phi_2847_ = _e3914;
                                                } else {
                                                    phi_2846_ = _e3849;
                                                    phi_2847_ = true;
                                                }
                                                let _e3932 = phi_2846_;
                                                let _e3934 = phi_2847_;
                                                phi_2722_ = _e3932;
                                                phi_2848_ = _e3934;
                                                phi_2849_ = false;
                                            } else {
                                                phi_2722_ = f64();
                                                phi_2848_ = false;
                                                phi_2849_ = true;
                                            }
                                            let _e3936 = phi_2722_;
                                            let _e3938 = phi_2848_;
                                            let _e3940 = phi_2849_;
                                            local_39 = _e3940;
                                            continue;
                                            continuing {
                                                phi_2718_ = _e3863;
                                                phi_2721_ = _e3936;
                                                break if !(_e3938);
                                            }
                                        }
                                        let _e3943 = local_39;
                                        if _e3943 {
                                            let _e3945 = local_40;
                                            let _e3946 = (_e3945 > _e3182);
                                            if _e3946 {
                                                phi_2871_ = false;
                                                phi_2872_ = false;
                                                phi_2873_ = false;
                                            } else {
                                                let _e3948 = local_41;
                                                if (_e3948 > _e3417) {
                                                    let _e3951 = local_42;
                                                    let _e3954 = ((_e3951 - _e3417) < f64(0.00000000023283064f));
                                                    if _e3954 {
                                                        phi_2867_ = false;
                                                    } else {
                                                        phi_2867_ = true;
                                                    }
                                                    let _e3956 = phi_2867_;
                                                    phi_2868_ = _e3956;
                                                    phi_2869_ = _e3954;
                                                    phi_2870_ = false;
                                                } else {
                                                    phi_2868_ = false;
                                                    phi_2869_ = false;
                                                    phi_2870_ = true;
                                                }
                                                let _e3958 = phi_2868_;
                                                let _e3960 = phi_2869_;
                                                let _e3962 = phi_2870_;
                                                phi_2871_ = _e3958;
                                                phi_2872_ = _e3960;
                                                phi_2873_ = _e3962;
                                            }
                                            let _e3964 = phi_2871_;
                                            let _e3966 = phi_2872_;
                                            let _e3968 = phi_2873_;
                                            phi_2874_ = _e3964;
                                            phi_2875_ = _e3946;
                                            phi_2876_ = _e3966;
                                            phi_2877_ = _e3968;
                                            phi_2878_ = false;
                                        } else {
                                            phi_2874_ = false;
                                            phi_2875_ = false;
                                            phi_2876_ = false;
                                            phi_2877_ = false;
                                            phi_2878_ = true;
                                        }
                                        let _e3970 = phi_2874_;
                                        let _e3972 = phi_2875_;
                                        let _e3974 = phi_2876_;
                                        let _e3976 = phi_2877_;
                                        let _e3978 = phi_2878_;
                                        let _e5468 = local_70;
                                        phi_2879_ = _e5468;
                                        let _e5471 = local_71;
                                        phi_2880_ = _e5471;
                                        phi_2881_ = _e3970;
                                        phi_2882_ = _e3972;
                                        phi_2883_ = _e3974;
                                        phi_2884_ = _e3976;
                                        phi_2885_ = _e3978;
                                        phi_2886_ = false;
                                    } else {
                                        phi_2879_ = f64();
                                        phi_2880_ = f64();
                                        phi_2881_ = false;
                                        phi_2882_ = false;
                                        phi_2883_ = false;
                                        phi_2884_ = false;
                                        phi_2885_ = false;
                                        phi_2886_ = true;
                                    }
                                    let _e3980 = phi_2879_;
                                    let _e3982 = phi_2880_;
                                    let _e3984 = phi_2881_;
                                    let _e3986 = phi_2882_;
                                    let _e3988 = phi_2883_;
                                    let _e3990 = phi_2884_;
                                    let _e3992 = phi_2885_;
                                    let _e3994 = phi_2886_;
                                    phi_2887_ = _e3980;
                                    phi_2888_ = _e3982;
                                    phi_2889_ = _e3984;
                                    phi_2890_ = _e3986;
                                    phi_2891_ = _e3988;
                                    phi_2892_ = _e3990;
                                    phi_2893_ = _e3992;
                                    phi_2894_ = _e3994;
                                    phi_2895_ = false;
                                } else {
                                    phi_2887_ = f64();
                                    phi_2888_ = f64();
                                    phi_2889_ = false;
                                    phi_2890_ = false;
                                    phi_2891_ = false;
                                    phi_2892_ = false;
                                    phi_2893_ = false;
                                    phi_2894_ = false;
                                    phi_2895_ = true;
                                }
                                let _e3996 = phi_2887_;
                                let _e3998 = phi_2888_;
                                let _e4000 = phi_2889_;
                                let _e4002 = phi_2890_;
                                let _e4004 = phi_2891_;
                                let _e4006 = phi_2892_;
                                let _e4008 = phi_2893_;
                                let _e4010 = phi_2894_;
                                let _e4012 = phi_2895_;
                                phi_2896_ = _e3996;
                                phi_1968_ = _e3998;
                                phi_2897_ = _e4000;
                                phi_2898_ = _e4002;
                                phi_2899_ = _e4004;
                                phi_2900_ = false;
                                phi_2901_ = _e4006;
                                phi_2902_ = _e4008;
                                phi_2903_ = _e4010;
                                phi_2904_ = _e4012;
                            } else {
                                phi_2896_ = f64();
                                phi_1968_ = f64();
                                phi_2897_ = false;
                                phi_2898_ = false;
                                phi_2899_ = false;
                                phi_2900_ = true;
                                phi_2901_ = false;
                                phi_2902_ = false;
                                phi_2903_ = false;
                                phi_2904_ = false;
                            }
                            let _e4014 = phi_2896_;
                            let _e4016 = phi_1968_;
                            let _e4018 = phi_2897_;
                            let _e4020 = phi_2898_;
                            let _e4022 = phi_2899_;
                            let _e4024 = phi_2900_;
                            let _e4026 = phi_2901_;
                            let _e4028 = phi_2902_;
                            let _e4030 = phi_2903_;
                            let _e4032 = phi_2904_;
                            local_43 = _e4020;
                            local_72 = _e4022;
                            local_73 = _e4024;
                            local_74 = _e4026;
                            local_75 = _e4028;
                            local_76 = _e4030;
                            local_77 = _e4032;
                            local_78 = _e4014;
                            local_80 = _e4020;
                            continue;
                            continuing {
                                phi_1964_ = _e3431;
                                phi_1967_ = _e4016;
                                break if !(_e4018);
                            }
                        }
                        let _e4035 = local_43;
                        if _e4035 {
                            phi_2909_ = type_73(0u, type_73().member_1);
                            phi_2910_ = false;
                            phi_2911_ = false;
                            phi_2912_ = false;
                            phi_2913_ = false;
                            phi_2914_ = false;
                            phi_2915_ = false;
                        } else {
                            phi_2909_ = type_73();
                            let _e5501 = local_72;
                            phi_2910_ = _e5501;
                            let _e5504 = local_73;
                            phi_2911_ = _e5504;
                            let _e5507 = local_74;
                            phi_2912_ = _e5507;
                            let _e5510 = local_75;
                            phi_2913_ = _e5510;
                            let _e5513 = local_76;
                            phi_2914_ = _e5513;
                            let _e5516 = local_77;
                            phi_2915_ = _e5516;
                        }
                        let _e4040 = phi_2909_;
                        let _e4042 = phi_2910_;
                        let _e4044 = phi_2911_;
                        let _e4046 = phi_2912_;
                        let _e4048 = phi_2913_;
                        let _e4050 = phi_2914_;
                        let _e4052 = phi_2915_;
                        if _e4042 {
                            let _e5519 = local_78;
                            phi_2919_ = _e5519;
                            phi_2920_ = true;
                            phi_2921_ = false;
                            phi_2922_ = false;
                            phi_2923_ = false;
                            phi_2924_ = false;
                            phi_2925_ = false;
                        } else {
                            let _e5521 = local_79;
                            phi_2919_ = _e5521;
                            phi_2920_ = _e4044;
                            phi_2921_ = _e4046;
                            phi_2922_ = _e4048;
                            let _e5527 = local_80;
                            phi_2923_ = _e5527;
                            phi_2924_ = _e4050;
                            phi_2925_ = _e4052;
                        }
                        let _e4054 = phi_2919_;
                        let _e4056 = phi_2920_;
                        let _e4058 = phi_2921_;
                        let _e4060 = phi_2922_;
                        let _e4062 = phi_2923_;
                        let _e4064 = phi_2924_;
                        let _e4066 = phi_2925_;
                        if _e4056 {
                            phi_2930_ = type_73(1u, _e4054);
                            phi_2931_ = false;
                            phi_2932_ = false;
                            phi_2933_ = false;
                            phi_2934_ = false;
                            phi_2935_ = false;
                        } else {
                            phi_2930_ = type_73();
                            phi_2931_ = _e4058;
                            phi_2932_ = _e4060;
                            phi_2933_ = _e4062;
                            phi_2934_ = _e4064;
                            phi_2935_ = _e4066;
                        }
                        let _e4069 = phi_2930_;
                        let _e4071 = phi_2931_;
                        let _e4073 = phi_2932_;
                        let _e4075 = phi_2933_;
                        let _e4077 = phi_2934_;
                        let _e4079 = phi_2935_;
                        if _e4071 {
                            let _e4081 = local_44;
                            phi_2940_ = type_73(1u, _e4081);
                            phi_2941_ = false;
                            phi_2942_ = true;
                            phi_2943_ = false;
                            phi_2944_ = false;
                        } else {
                            phi_2940_ = _e4040;
                            phi_2941_ = _e4073;
                            phi_2942_ = _e4075;
                            phi_2943_ = _e4077;
                            phi_2944_ = _e4079;
                        }
                        let _e4084 = phi_2940_;
                        let _e4086 = phi_2941_;
                        let _e4088 = phi_2942_;
                        let _e4090 = phi_2943_;
                        let _e4092 = phi_2944_;
                        if _e4086 {
                            let _e4094 = local_45;
                            phi_2949_ = type_73(1u, _e4094);
                            phi_2950_ = true;
                            phi_2951_ = false;
                            phi_2952_ = false;
                        } else {
                            phi_2949_ = _e4084;
                            phi_2950_ = _e4088;
                            phi_2951_ = _e4090;
                            phi_2952_ = _e4092;
                        }
                        let _e4097 = phi_2949_;
                        let _e4099 = phi_2950_;
                        let _e4101 = phi_2951_;
                        let _e4103 = phi_2952_;
                        if _e4099 {
                            phi_2956_ = false;
                            phi_2957_ = false;
                        } else {
                            phi_2956_ = _e4101;
                            phi_2957_ = _e4103;
                        }
                        let _e4105 = phi_2956_;
                        let _e4107 = phi_2957_;
                        if _e4105 {
                            phi_2961_ = false;
                            phi_2962_ = false;
                        } else {
                            phi_2961_ = _e4107;
                            phi_2962_ = _e4099;
                        }
                        let _e4109 = phi_2961_;
                        let _e4111 = phi_2962_;
                        if _e4109 {
                            phi_2966_ = true;
                            phi_2967_ = false;
                        } else {
                            phi_2966_ = _e4105;
                            phi_2967_ = _e4111;
                        }
                        let _e4113 = phi_2966_;
                        let _e4115 = phi_2967_;
                        if _e4113 {
                            let _e4117 = local_46;
                            phi_2972_ = type_73(1u, _e4117);
                            phi_2973_ = true;
                        } else {
                            phi_2972_ = _e4097;
                            phi_2973_ = _e4115;
                        }
                        let _e4120 = phi_2972_;
                        let _e4122 = phi_2973_;
                        if _e4122 {
                            phi_2977_ = _e4120;
                        } else {
                            phi_2977_ = _e4069;
                        }
                        let _e4124 = phi_2977_;
                        if (_e4124.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_2991_ = type_29(0u, 3u);
                            loop {
                                let _e4137 = phi_2991_;
                                if (_e4137.member < _e4137.member_1) {
                                    phi_2992_ = type_29((_e4137.member + 1u), _e4137.member_1);
                                    phi_3015_ = type_29(1u, _e4137.member);
                                } else {
                                    phi_2992_ = _e4137;
                                    phi_3015_ = type_29(0u, type_29().member_1);
                                }
                                let _e4151 = phi_2992_;
                                let _e4153 = phi_3015_;
                                if (bitcast<i32>(_e4153.member) != 0i) {
                                    if (_e4153.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4160 = local_14[_e4153.member_1];
                                    let _e4162 = (_e4124.member_1 + f64(_e4160));
                                    if (_e4162 < _e3182) {
                                        phi_3036_ = _e4162;
                                    } else {
                                        phi_3036_ = _e3182;
                                    }
                                    let _e4165 = phi_3036_;
                                    let _e4168 = local_20.member[0u];
                                    let _e4174 = local_20.member[1u];
                                    let _e4184 = (_e4168[0] + ((_e4174[0] - _e4168[0]) * _e4165));
                                    let _e4185 = (_e4168[1] + ((_e4174[1] - _e4168[1]) * _e4165));
                                    let _e4186 = (_e4168[2] + ((_e4174[2] - _e4168[2]) * _e4165));
                                    let _e4189 = local_20.member_1[0u];
                                    let _e4195 = local_20.member_1[1u];
                                    let _e4205 = (_e4189[0] + ((_e4195[0] - _e4189[0]) * _e4165));
                                    let _e4206 = (_e4189[1] + ((_e4195[1] - _e4189[1]) * _e4165));
                                    let _e4207 = (_e4189[2] + ((_e4195[2] - _e4189[2]) * _e4165));
                                    let _e4210 = local_20.member_2[0u];
                                    let _e4216 = local_20.member_2[1u];
                                    let _e4226 = (_e4210[0] + ((_e4216[0] - _e4210[0]) * _e4165));
                                    let _e4227 = (_e4210[1] + ((_e4216[1] - _e4210[1]) * _e4165));
                                    let _e4228 = (_e4210[2] + ((_e4216[2] - _e4210[2]) * _e4165));
                                    let _e4233 = (((_e4205 * _e4205) + (_e4206 * _e4206)) + (_e4207 * _e4207));
                                    let _e4238 = (((_e4205 * _e4226) + (_e4206 * _e4227)) + (_e4207 * _e4228));
                                    let _e4243 = (((_e4226 * _e4226) + (_e4227 * _e4227)) + (_e4228 * _e4228));
                                    let _e4248 = (((_e4184 * _e4205) + (_e4185 * _e4206)) + (_e4186 * _e4207));
                                    let _e4253 = (((_e4184 * _e4226) + (_e4185 * _e4227)) + (_e4186 * _e4228));
                                    let _e4256 = ((_e4233 * _e4243) - (_e4238 * _e4238));
                                    let _e4257 = f64(0f);
                                    let _e4262 = (((_e4248 * _e4243) - (_e4253 * _e4238)) / _e4256);
                                    let _e4266 = (((_e4253 * _e4233) - (_e4248 * _e4238)) / _e4256);
                                    if (_e4262 >= _e4257) {
                                        if (_e4266 >= _e4257) {
                                            phi_3206_ = ((_e4262 + _e4266) <= f64(1f));
                                            phi_3207_ = false;
                                        } else {
                                            phi_3206_ = bool();
                                            phi_3207_ = true;
                                        }
                                        let _e4272 = phi_3206_;
                                        let _e4274 = phi_3207_;
                                        phi_3208_ = _e4272;
                                        phi_3209_ = _e4274;
                                    } else {
                                        phi_3208_ = bool();
                                        phi_3209_ = true;
                                    }
                                    let _e4276 = phi_3208_;
                                    let _e4278 = phi_3209_;
                                    if _e4278 {
                                        phi_3213_ = false;
                                    } else {
                                        phi_3213_ = _e4276;
                                    }
                                    let _e4280 = phi_3213_;
                                    if (_e4256 > _e4257) {
                                        if _e4280 {
                                            phi_3235_ = array<f64, 3>((_e4184 - ((_e4205 * _e4262) + (_e4226 * _e4266))), (_e4185 - ((_e4206 * _e4262) + (_e4227 * _e4266))), (_e4186 - ((_e4207 * _e4262) + (_e4228 * _e4266))));
                                            phi_3236_ = false;
                                        } else {
                                            phi_3235_ = array<f64, 3>();
                                            phi_3236_ = true;
                                        }
                                        let _e4296 = phi_3235_;
                                        let _e4298 = phi_3236_;
                                        phi_3237_ = _e4296;
                                        phi_3238_ = _e4298;
                                    } else {
                                        phi_3237_ = array<f64, 3>();
                                        phi_3238_ = true;
                                    }
                                    let _e4300 = phi_3237_;
                                    let _e4302 = phi_3238_;
                                    if _e4302 {
                                        let _e4303 = (_e4184 - _e4205);
                                        let _e4304 = (_e4185 - _e4206);
                                        let _e4305 = (_e4186 - _e4207);
                                        let _e4306 = (_e4226 - _e4205);
                                        let _e4307 = (_e4227 - _e4206);
                                        let _e4308 = (_e4228 - _e4207);
                                        let _e4319 = ((((_e4303 * _e4306) + (_e4304 * _e4307)) + (_e4305 * _e4308)) / (((_e4306 * _e4306) + (_e4307 * _e4307)) + (_e4308 * _e4308)));
                                        if (_e4319 > f64(0f)) {
                                            if (_e4319 < f64(1f)) {
                                                phi_3425_ = _e4319;
                                            } else {
                                                phi_3425_ = f64(1f);
                                            }
                                            let _e4327 = phi_3425_;
                                            phi_3427_ = _e4327;
                                        } else {
                                            phi_3427_ = f64(0f);
                                        }
                                        let _e4329 = phi_3427_;
                                        let _e4333 = (_e4303 - (_e4306 * _e4329));
                                        let _e4334 = (_e4304 - (_e4307 * _e4329));
                                        let _e4335 = (_e4305 - (_e4308 * _e4329));
                                        let _e4346 = ((((_e4184 * _e4205) + (_e4185 * _e4206)) + (_e4186 * _e4207)) / (((_e4205 * _e4205) + (_e4206 * _e4206)) + (_e4207 * _e4207)));
                                        if (_e4346 > f64(0f)) {
                                            if (_e4346 < f64(1f)) {
                                                phi_3457_ = _e4346;
                                            } else {
                                                phi_3457_ = f64(1f);
                                            }
                                            let _e4354 = phi_3457_;
                                            phi_3459_ = _e4354;
                                        } else {
                                            phi_3459_ = f64(0f);
                                        }
                                        let _e4356 = phi_3459_;
                                        let _e4373 = ((((_e4184 * _e4226) + (_e4185 * _e4227)) + (_e4186 * _e4228)) / (((_e4226 * _e4226) + (_e4227 * _e4227)) + (_e4228 * _e4228)));
                                        if (_e4373 > f64(0f)) {
                                            if (_e4373 < f64(1f)) {
                                                phi_3489_ = _e4373;
                                            } else {
                                                phi_3489_ = f64(1f);
                                            }
                                            let _e4381 = phi_3489_;
                                            phi_3491_ = _e4381;
                                        } else {
                                            phi_3491_ = f64(0f);
                                        }
                                        let _e4383 = phi_3491_;
                                        local_10[0u] = array<f64, 3>((_e4184 - (_e4205 * _e4356)), (_e4185 - (_e4206 * _e4356)), (_e4186 - (_e4207 * _e4356)));
                                        local_10[1u] = array<f64, 3>((_e4184 - (_e4226 * _e4383)), (_e4185 - (_e4227 * _e4383)), (_e4186 - (_e4228 * _e4383)));
                                        local_10[2u] = array<f64, 3>(_e4333, _e4334, _e4335);
                                        local_10[3u] = array<f64, 3>(_e4333, _e4334, _e4335);
                                        let _e4399 = local_10[0u];
                                        phi_3527_ = type_29(1u, 4u);
                                        phi_3530_ = array<f64, 3>(_e4399[0], _e4399[1], _e4399[2]);
                                        loop {
                                            let _e4405 = phi_3527_;
                                            let _e4407 = phi_3530_;
                                            local_81 = _e4407;
                                            if (_e4405.member < _e4405.member_1) {
                                                phi_3528_ = type_29((_e4405.member + 1u), _e4405.member_1);
                                                phi_3553_ = type_29(1u, _e4405.member);
                                            } else {
                                                phi_3528_ = _e4405;
                                                phi_3553_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e4421 = phi_3528_;
                                            let _e4423 = phi_3553_;
                                            let _e4427 = (bitcast<i32>(_e4423.member) != 0i);
                                            if _e4427 {
                                                if (_e4423.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4430 = local_10[_e4423.member_1];
                                                if (_e4423.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4436 = local_10[_e4423.member_1];
                                                if ((((_e4430[0] * _e4436[0]) + (_e4430[1] * _e4436[1])) + (_e4430[2] * _e4436[2])) < (((_e4407[0] * _e4407[0]) + (_e4407[1] * _e4407[1])) + (_e4407[2] * _e4407[2]))) {
                                                    if (_e4423.member_1 < 4u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e4459 = local_10[_e4423.member_1];
                                                    phi_3620_ = array<f64, 3>(_e4459[0], _e4459[1], _e4459[2]);
                                                } else {
                                                    phi_3620_ = _e4407;
                                                }
                                                let _e4465 = phi_3620_;
                                                phi_3531_ = _e4465;
                                            } else {
                                                phi_3531_ = array<f64, 3>();
                                            }
                                            let _e4467 = phi_3531_;
                                            continue;
                                            continuing {
                                                phi_3527_ = _e4421;
                                                phi_3530_ = _e4467;
                                                break if !(_e4427);
                                            }
                                        }
                                        let _e5584 = local_81;
                                        phi_3621_ = _e5584;
                                    } else {
                                        phi_3621_ = _e4300;
                                    }
                                    let _e4470 = phi_3621_;
                                    let _e4481 = (((_e4470[0] * _e4470[0]) + (_e4470[1] * _e4470[1])) + (_e4470[2] * _e4470[2]));
                                    if (_e4481 <= 2.2250738585072014e-308lf) {
                                        if (_e4481 > 0.0lf) {
                                            phi_3646_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3646_ = 0.0lf;
                                        }
                                        let _e4539 = phi_3646_;
                                        phi_3710_ = _e4539;
                                    } else {
                                        phi_3653_ = type_27(0i, 5i);
                                        phi_3656_ = bitcast<f64>(((bitcast<u64>(_e4481) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e4488 = phi_3653_;
                                            let _e4490 = phi_3656_;
                                            local_47 = _e4490;
                                            if (_e4488.member < _e4488.member_1) {
                                                let _e4498 = (_e4488.member + 1i);
                                                if ((false == (_e4498 > _e4488.member)) != false) {
                                                    phi_3677_ = true;
                                                } else {
                                                    phi_3677_ = false;
                                                }
                                                let _e4503 = phi_3677_;
                                                if _e4503 {
                                                    phi_3683_ = type_28(0u, type_28().member_1);
                                                } else {
                                                    phi_3683_ = type_28(1u, _e4498);
                                                }
                                                let _e4509 = phi_3683_;
                                                if (bitcast<i32>(_e4509.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3654_ = type_27(_e4509.member_1, _e4488.member_1);
                                                phi_3697_ = type_28(1u, _e4488.member);
                                            } else {
                                                phi_3654_ = _e4488;
                                                phi_3697_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4519 = phi_3654_;
                                            let _e4521 = phi_3697_;
                                            let _e4524 = (bitcast<i32>(_e4521.member) != 0i);
                                            if _e4524 {
                                                phi_3657_ = (0.5lf * (_e4490 + (_e4481 / _e4490)));
                                            } else {
                                                phi_3657_ = f64();
                                            }
                                            let _e4529 = phi_3657_;
                                            continue;
                                            continuing {
                                                phi_3653_ = _e4519;
                                                phi_3656_ = _e4529;
                                                break if !(_e4524);
                                            }
                                        }
                                        let _e4534 = local_47;
                                        phi_3710_ = (_e4534 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e4541 = phi_3710_;
                                    let _e4549 = local_20.member[0u];
                                    if (_e4549[0] < 0.0lf) {
                                        phi_3728_ = -(_e4549[0]);
                                    } else {
                                        phi_3728_ = _e4549[0];
                                    }
                                    let _e4556 = phi_3728_;
                                    if (_e4549[1] < 0.0lf) {
                                        phi_3735_ = -(_e4549[1]);
                                    } else {
                                        phi_3735_ = _e4549[1];
                                    }
                                    let _e4560 = phi_3735_;
                                    if (_e4556 > _e4560) {
                                        phi_3740_ = _e4556;
                                    } else {
                                        phi_3740_ = _e4560;
                                    }
                                    let _e4563 = phi_3740_;
                                    if (_e4549[2] < 0.0lf) {
                                        phi_3747_ = -(_e4549[2]);
                                    } else {
                                        phi_3747_ = _e4549[2];
                                    }
                                    let _e4567 = phi_3747_;
                                    if (_e4563 > _e4567) {
                                        phi_3752_ = _e4563;
                                    } else {
                                        phi_3752_ = _e4567;
                                    }
                                    let _e4570 = phi_3752_;
                                    let _e4573 = local_20.member[1u];
                                    if (_e4573[0] < 0.0lf) {
                                        phi_3765_ = -(_e4573[0]);
                                    } else {
                                        phi_3765_ = _e4573[0];
                                    }
                                    let _e4580 = phi_3765_;
                                    if (_e4573[1] < 0.0lf) {
                                        phi_3772_ = -(_e4573[1]);
                                    } else {
                                        phi_3772_ = _e4573[1];
                                    }
                                    let _e4584 = phi_3772_;
                                    if (_e4580 > _e4584) {
                                        phi_3777_ = _e4580;
                                    } else {
                                        phi_3777_ = _e4584;
                                    }
                                    let _e4587 = phi_3777_;
                                    if (_e4573[2] < 0.0lf) {
                                        phi_3784_ = -(_e4573[2]);
                                    } else {
                                        phi_3784_ = _e4573[2];
                                    }
                                    let _e4591 = phi_3784_;
                                    if (_e4587 > _e4591) {
                                        phi_3789_ = _e4587;
                                    } else {
                                        phi_3789_ = _e4591;
                                    }
                                    let _e4594 = phi_3789_;
                                    if (_e4570 > _e4594) {
                                        phi_3794_ = _e4570;
                                    } else {
                                        phi_3794_ = _e4594;
                                    }
                                    let _e4597 = phi_3794_;
                                    let _e4599 = local_20.member_3;
                                    let _e4603 = local_20.member_1[0u];
                                    if (_e4603[0] < 0.0lf) {
                                        phi_3811_ = -(_e4603[0]);
                                    } else {
                                        phi_3811_ = _e4603[0];
                                    }
                                    let _e4610 = phi_3811_;
                                    if (_e4603[1] < 0.0lf) {
                                        phi_3818_ = -(_e4603[1]);
                                    } else {
                                        phi_3818_ = _e4603[1];
                                    }
                                    let _e4614 = phi_3818_;
                                    if (_e4610 > _e4614) {
                                        phi_3823_ = _e4610;
                                    } else {
                                        phi_3823_ = _e4614;
                                    }
                                    let _e4617 = phi_3823_;
                                    if (_e4603[2] < 0.0lf) {
                                        phi_3830_ = -(_e4603[2]);
                                    } else {
                                        phi_3830_ = _e4603[2];
                                    }
                                    let _e4621 = phi_3830_;
                                    if (_e4617 > _e4621) {
                                        phi_3835_ = _e4617;
                                    } else {
                                        phi_3835_ = _e4621;
                                    }
                                    let _e4624 = phi_3835_;
                                    let _e4627 = local_20.member_1[1u];
                                    if (_e4627[0] < 0.0lf) {
                                        phi_3849_ = -(_e4627[0]);
                                    } else {
                                        phi_3849_ = _e4627[0];
                                    }
                                    let _e4634 = phi_3849_;
                                    if (_e4627[1] < 0.0lf) {
                                        phi_3856_ = -(_e4627[1]);
                                    } else {
                                        phi_3856_ = _e4627[1];
                                    }
                                    let _e4638 = phi_3856_;
                                    if (_e4634 > _e4638) {
                                        phi_3861_ = _e4634;
                                    } else {
                                        phi_3861_ = _e4638;
                                    }
                                    let _e4641 = phi_3861_;
                                    if (_e4627[2] < 0.0lf) {
                                        phi_3868_ = -(_e4627[2]);
                                    } else {
                                        phi_3868_ = _e4627[2];
                                    }
                                    let _e4645 = phi_3868_;
                                    if (_e4641 > _e4645) {
                                        phi_3873_ = _e4641;
                                    } else {
                                        phi_3873_ = _e4645;
                                    }
                                    let _e4648 = phi_3873_;
                                    if (_e4624 > _e4648) {
                                        phi_3878_ = _e4624;
                                    } else {
                                        phi_3878_ = _e4648;
                                    }
                                    let _e4651 = phi_3878_;
                                    let _e4653 = local_20.member_3;
                                    let _e4657 = local_20.member_2[0u];
                                    if (_e4657[0] < 0.0lf) {
                                        phi_3895_ = -(_e4657[0]);
                                    } else {
                                        phi_3895_ = _e4657[0];
                                    }
                                    let _e4664 = phi_3895_;
                                    if (_e4657[1] < 0.0lf) {
                                        phi_3902_ = -(_e4657[1]);
                                    } else {
                                        phi_3902_ = _e4657[1];
                                    }
                                    let _e4668 = phi_3902_;
                                    if (_e4664 > _e4668) {
                                        phi_3907_ = _e4664;
                                    } else {
                                        phi_3907_ = _e4668;
                                    }
                                    let _e4671 = phi_3907_;
                                    if (_e4657[2] < 0.0lf) {
                                        phi_3914_ = -(_e4657[2]);
                                    } else {
                                        phi_3914_ = _e4657[2];
                                    }
                                    let _e4675 = phi_3914_;
                                    if (_e4671 > _e4675) {
                                        phi_3919_ = _e4671;
                                    } else {
                                        phi_3919_ = _e4675;
                                    }
                                    let _e4678 = phi_3919_;
                                    let _e4681 = local_20.member_2[1u];
                                    if (_e4681[0] < 0.0lf) {
                                        phi_3933_ = -(_e4681[0]);
                                    } else {
                                        phi_3933_ = _e4681[0];
                                    }
                                    let _e4688 = phi_3933_;
                                    if (_e4681[1] < 0.0lf) {
                                        phi_3940_ = -(_e4681[1]);
                                    } else {
                                        phi_3940_ = _e4681[1];
                                    }
                                    let _e4692 = phi_3940_;
                                    if (_e4688 > _e4692) {
                                        phi_3945_ = _e4688;
                                    } else {
                                        phi_3945_ = _e4692;
                                    }
                                    let _e4695 = phi_3945_;
                                    if (_e4681[2] < 0.0lf) {
                                        phi_3952_ = -(_e4681[2]);
                                    } else {
                                        phi_3952_ = _e4681[2];
                                    }
                                    let _e4699 = phi_3952_;
                                    if (_e4695 > _e4699) {
                                        phi_3957_ = _e4695;
                                    } else {
                                        phi_3957_ = _e4699;
                                    }
                                    let _e4702 = phi_3957_;
                                    if (_e4678 > _e4702) {
                                        phi_3962_ = _e4678;
                                    } else {
                                        phi_3962_ = _e4702;
                                    }
                                    let _e4705 = phi_3962_;
                                    let _e4707 = local_20.member_3;
                                    let _e4715 = local_20.member_3;
                                    let _e4725 = (((_e4541 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e4597 + _e4599) + (_e4651 + _e4653)) + (_e4705 + _e4707)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4715 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e441);
                                    if _e4725 {
                                        phi_3986_ = false;
                                    } else {
                                        phi_3986_ = true;
                                    }
                                    let _e4727 = phi_3986_;
                                    phi_3987_ = _e4727;
                                    phi_3988_ = _e4725;
                                } else {
                                    phi_3987_ = false;
                                    phi_3988_ = false;
                                }
                                let _e4729 = phi_3987_;
                                let _e4731 = phi_3988_;
                                local_48 = _e4731;
                                continue;
                                continuing {
                                    phi_2991_ = _e4151;
                                    break if !(_e4729);
                                }
                            }
                            let _e4734 = local_48;
                            if _e4734 {
                                phi_3993_ = type_73(1u, _e4124.member_1);
                                phi_3994_ = false;
                            } else {
                                phi_3993_ = type_73();
                                phi_3994_ = true;
                            }
                            let _e4737 = phi_3993_;
                            let _e4739 = phi_3994_;
                            if _e4739 {
                                phi_3999_ = type_73(2u, _e4124.member_1);
                                phi_4000_ = false;
                            } else {
                                phi_3999_ = type_73();
                                phi_4000_ = true;
                            }
                            let _e4742 = phi_3999_;
                            let _e4744 = phi_4000_;
                            phi_4002_ = _e4742;
                            phi_4003_ = _e4737;
                            phi_4004_ = _e4744;
                        } else {
                            phi_4002_ = type_73();
                            phi_4003_ = type_73(0u, type_73().member_1);
                            phi_4004_ = true;
                        }
                        let _e4746 = phi_4002_;
                        let _e4748 = phi_4003_;
                        let _e4750 = phi_4004_;
                        if _e4750 {
                            phi_4008_ = _e4748;
                        } else {
                            phi_4008_ = _e4746;
                        }
                        let _e4752 = phi_4008_;
                        phi_7310_ = _e4752;
                    } else {
                        if (_e540 < 0.0lf) {
                            phi_4019_ = -(_e540);
                        } else {
                            phi_4019_ = _e540;
                        }
                        let _e895 = phi_4019_;
                        if (_e563 < 0.0lf) {
                            phi_4025_ = -(_e563);
                        } else {
                            phi_4025_ = _e563;
                        }
                        let _e899 = phi_4025_;
                        if (_e895 > _e899) {
                            phi_4030_ = _e895;
                        } else {
                            phi_4030_ = _e899;
                        }
                        let _e902 = phi_4030_;
                        if (_e586 < 0.0lf) {
                            phi_4036_ = -(_e586);
                        } else {
                            phi_4036_ = _e586;
                        }
                        let _e906 = phi_4036_;
                        if (_e597 < 0.0lf) {
                            phi_4042_ = -(_e597);
                        } else {
                            phi_4042_ = _e597;
                        }
                        let _e910 = phi_4042_;
                        if (_e906 > _e910) {
                            phi_4047_ = _e906;
                        } else {
                            phi_4047_ = _e910;
                        }
                        let _e913 = phi_4047_;
                        if (_e902 > _e913) {
                            phi_4052_ = _e902;
                        } else {
                            phi_4052_ = _e913;
                        }
                        let _e916 = phi_4052_;
                        let _e920 = ((_e856 * f64(0.34f)) + (_e916 * (1.1102230246251565e-16lf * f64(256f))));
                        let _e921 = f64(0f);
                        let _e922 = f64(1f);
                        let _e923 = f64(3f);
                        let _e925 = (_e563 - (_e923 * _e540));
                        let _e926 = (_e586 - _e563);
                        let _e928 = ((_e923 * _e597) - _e586);
                        local_7[0u] = _e921;
                        local_7[1u] = _e922;
                        local_7[2u] = _e922;
                        local_7[3u] = _e922;
                        let _e935 = ((_e926 * _e926) - (_e925 * _e928));
                        if (_e935 > _e921) {
                            if (_e935 <= 2.2250738585072014e-308lf) {
                                if (_e935 > 0.0lf) {
                                    phi_4089_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4089_ = 0.0lf;
                                }
                                let _e994 = phi_4089_;
                                phi_4153_ = _e994;
                            } else {
                                phi_4096_ = type_27(0i, 5i);
                                phi_4099_ = bitcast<f64>(((bitcast<u64>(_e935) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e943 = phi_4096_;
                                    let _e945 = phi_4099_;
                                    local_21 = _e945;
                                    if (_e943.member < _e943.member_1) {
                                        let _e953 = (_e943.member + 1i);
                                        if ((false == (_e953 > _e943.member)) != false) {
                                            phi_4120_ = true;
                                        } else {
                                            phi_4120_ = false;
                                        }
                                        let _e958 = phi_4120_;
                                        if _e958 {
                                            phi_4126_ = type_28(0u, type_28().member_1);
                                        } else {
                                            phi_4126_ = type_28(1u, _e953);
                                        }
                                        let _e964 = phi_4126_;
                                        if (bitcast<i32>(_e964.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_4097_ = type_27(_e964.member_1, _e943.member_1);
                                        phi_4140_ = type_28(1u, _e943.member);
                                    } else {
                                        phi_4097_ = _e943;
                                        phi_4140_ = type_28(0u, type_28().member_1);
                                    }
                                    let _e974 = phi_4097_;
                                    let _e976 = phi_4140_;
                                    let _e979 = (bitcast<i32>(_e976.member) != 0i);
                                    if _e979 {
                                        phi_4100_ = (0.5lf * (_e945 + (_e935 / _e945)));
                                    } else {
                                        phi_4100_ = f64();
                                    }
                                    let _e984 = phi_4100_;
                                    continue;
                                    continuing {
                                        phi_4096_ = _e974;
                                        phi_4099_ = _e984;
                                        break if !(_e979);
                                    }
                                }
                                let _e989 = local_21;
                                phi_4153_ = (_e989 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e996 = phi_4153_;
                            if (_e926 < _e921) {
                                phi_4159_ = -(_e996);
                            } else {
                                phi_4159_ = _e996;
                            }
                            let _e1000 = phi_4159_;
                            let _e1002 = -((_e926 + _e1000));
                            local_8[0u] = (_e1002 / (_e1002 + _e928));
                            local_8[1u] = (_e925 / (_e925 + _e1002));
                            let _e1011 = local_8[1u];
                            let _e1012 = local_8[0u];
                            if (_e1011 < _e1012) {
                                let _e1015 = local_8[1u];
                                let _e1017 = local_8[0u];
                                local_8[0u] = _e1015;
                                local_8[1u] = _e1017;
                            }
                            phi_4184_ = type_29(0u, 2u);
                            phi_4187_ = 1u;
                            loop {
                                let _e1021 = phi_4184_;
                                let _e1023 = phi_4187_;
                                local_49 = _e1023;
                                if (_e1021.member < _e1021.member_1) {
                                    phi_4185_ = type_29((_e1021.member + 1u), _e1021.member_1);
                                    phi_4210_ = type_29(1u, _e1021.member);
                                } else {
                                    phi_4185_ = _e1021;
                                    phi_4210_ = type_29(0u, type_29().member_1);
                                }
                                let _e1037 = phi_4185_;
                                let _e1039 = phi_4210_;
                                let _e1043 = (bitcast<i32>(_e1039.member) != 0i);
                                if _e1043 {
                                    if (_e1039.member_1 < 2u) {
                                    } else {
                                        return;
                                    }
                                    let _e1046 = local_8[_e1039.member_1];
                                    if (_e1046 > _e921) {
                                        if (_e1039.member_1 < 2u) {
                                        } else {
                                            return;
                                        }
                                        let _e1050 = local_8[_e1039.member_1];
                                        if (_e1050 < _e922) {
                                            if (_e1039.member_1 < 2u) {
                                            } else {
                                                return;
                                            }
                                            let _e1054 = local_8[_e1039.member_1];
                                            if (_e1023 < 4u) {
                                            } else {
                                                return;
                                            }
                                            local_7[_e1023] = _e1054;
                                            phi_4254_ = (_e1023 + 1u);
                                        } else {
                                            phi_4254_ = _e1023;
                                        }
                                        let _e1059 = phi_4254_;
                                        phi_4255_ = _e1059;
                                    } else {
                                        phi_4255_ = _e1023;
                                    }
                                    let _e1061 = phi_4255_;
                                    phi_4188_ = _e1061;
                                } else {
                                    phi_4188_ = u32();
                                }
                                let _e1063 = phi_4188_;
                                continue;
                                continuing {
                                    phi_4184_ = _e1037;
                                    phi_4187_ = _e1063;
                                    break if !(_e1043);
                                }
                            }
                            let _e4944 = local_49;
                            phi_4256_ = _e4944;
                        } else {
                            phi_4256_ = 1u;
                        }
                        let _e1066 = phi_4256_;
                        if (_e1066 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e1066] = _e922;
                        let _e1069 = local_7;
                        local_9 = _e1069;
                        phi_4276_ = type_29(0u, _e1066);
                        loop {
                            let _e1072 = phi_4276_;
                            if (_e1072.member < _e1072.member_1) {
                                phi_4277_ = type_29((_e1072.member + 1u), _e1072.member_1);
                                phi_4300_ = type_29(1u, _e1072.member);
                            } else {
                                phi_4277_ = _e1072;
                                phi_4300_ = type_29(0u, type_29().member_1);
                            }
                            let _e1086 = phi_4277_;
                            let _e1088 = phi_4300_;
                            if (bitcast<i32>(_e1088.member) != 0i) {
                                if (_e1088.member_1 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1095 = local_9[_e1088.member_1];
                                let _e1096 = (_e1088.member_1 + 1u);
                                if (_e1096 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1099 = local_9[_e1096];
                                let _e1101 = (f64(1f) - _e1095);
                                let _e1112 = ((((_e540 * _e1101) + (_e563 * _e1095)) * (_e1101 * _e1101)) + (((_e586 * _e1101) + (_e597 * _e1095)) * (_e1095 * _e1095)));
                                let _e1114 = (f64(1f) - _e1099);
                                let _e1125 = ((((_e540 * _e1114) + (_e563 * _e1099)) * (_e1114 * _e1114)) + (((_e586 * _e1114) + (_e597 * _e1099)) * (_e1099 * _e1099)));
                                if (_e1112 < 0.0lf) {
                                    phi_4354_ = -(_e1112);
                                } else {
                                    phi_4354_ = _e1112;
                                }
                                let _e1129 = phi_4354_;
                                let _e1130 = (_e1129 > _e920);
                                if (_e1125 < 0.0lf) {
                                    phi_4361_ = -(_e1125);
                                } else {
                                    phi_4361_ = _e1125;
                                }
                                let _e1134 = phi_4361_;
                                let _e1135 = (_e1134 > _e920);
                                let _e1136 = f64(0f);
                                if _e1130 {
                                    if _e1135 {
                                        phi_4373_ = ((_e1112 > _e1136) != (_e1125 > _e1136));
                                        phi_4374_ = false;
                                    } else {
                                        phi_4373_ = bool();
                                        phi_4374_ = true;
                                    }
                                    let _e1141 = phi_4373_;
                                    let _e1143 = phi_4374_;
                                    phi_4375_ = _e1141;
                                    phi_4376_ = _e1143;
                                } else {
                                    phi_4375_ = bool();
                                    phi_4376_ = true;
                                }
                                let _e1145 = phi_4375_;
                                let _e1147 = phi_4376_;
                                if _e1147 {
                                    phi_4380_ = false;
                                } else {
                                    phi_4380_ = _e1145;
                                }
                                let _e1149 = phi_4380_;
                                if _e1130 {
                                    if _e1135 {
                                        if _e1149 {
                                            phi_4392_ = type_74();
                                        } else {
                                            phi_4392_ = type_74(f64(1f), _e1136, _e1149);
                                        }
                                        let _e1153 = phi_4392_;
                                        phi_4393_ = _e1153;
                                        phi_4394_ = _e1149;
                                    } else {
                                        phi_4393_ = type_74();
                                        phi_4394_ = true;
                                    }
                                    let _e1155 = phi_4393_;
                                    let _e1157 = phi_4394_;
                                    phi_4395_ = _e1155;
                                    phi_4396_ = _e1157;
                                } else {
                                    phi_4395_ = type_74();
                                    phi_4396_ = true;
                                }
                                let _e1159 = phi_4395_;
                                let _e1161 = phi_4396_;
                                if _e1161 {
                                    if _e1130 {
                                        if (_e1112 < _e1136) {
                                            phi_4409_ = f64(-1f);
                                        } else {
                                            phi_4409_ = f64(1f);
                                        }
                                        let _e1166 = phi_4409_;
                                        let _e1167 = f64(0.00000000000022737368f);
                                        let _e1168 = f64(0.5f);
                                        let _e1169 = f64(3f);
                                        let _e1172 = (_e586 - _e563);
                                        phi_4422_ = type_29(0u, 64u);
                                        phi_4425_ = _e1099;
                                        phi_4427_ = _e1095;
                                        phi_4429_ = (_e1168 * (_e1095 + _e1099));
                                        loop {
                                            let _e1178 = phi_4422_;
                                            let _e1180 = phi_4425_;
                                            let _e1182 = phi_4427_;
                                            let _e1184 = phi_4429_;
                                            local_51 = _e1182;
                                            if (_e1178.member < _e1178.member_1) {
                                                phi_4423_ = type_29((_e1178.member + 1u), _e1178.member_1);
                                                phi_4452_ = type_29(1u, _e1178.member);
                                            } else {
                                                phi_4423_ = _e1178;
                                                phi_4452_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1198 = phi_4423_;
                                            let _e1200 = phi_4452_;
                                            if (bitcast<i32>(_e1200.member) != 0i) {
                                                let _e1205 = (f64(1f) - _e1184);
                                                let _e1218 = ((_e1166 * ((((_e540 * _e1205) + (_e563 * _e1184)) * (_e1205 * _e1205)) + (((_e586 * _e1205) + (_e597 * _e1184)) * (_e1184 * _e1184)))) - _e920);
                                                if (_e1218 > f64(0f)) {
                                                    phi_4479_ = _e1180;
                                                    phi_4480_ = _e1184;
                                                } else {
                                                    phi_4479_ = _e1184;
                                                    phi_4480_ = _e1182;
                                                }
                                                let _e1222 = phi_4479_;
                                                let _e1224 = phi_4480_;
                                                let _e1226 = ((_e1222 - _e1224) > _e1167);
                                                if _e1226 {
                                                    let _e1228 = (f64(1f) - _e1184);
                                                    let _e1240 = (-(_e1218) / (_e1166 * (((((_e563 - (_e1169 * _e540)) * _e1228) + (_e1172 * _e1184)) * _e1228) + (((_e1172 * _e1228) + (((_e1169 * _e597) - _e586) * _e1184)) * _e1184))));
                                                    if (_e1218 > f64(0f)) {
                                                        phi_4508_ = (_e1168 * _e1167);
                                                    } else {
                                                        phi_4508_ = -((_e1168 * _e1167));
                                                    }
                                                    let _e1247 = phi_4508_;
                                                    let _e1249 = ((_e1184 + _e1240) + _e1247);
                                                    if (_e1249 > _e1224) {
                                                        if (_e1249 < _e1222) {
                                                            if (_e1240 < 0.0lf) {
                                                                phi_4524_ = -(_e1240);
                                                            } else {
                                                                phi_4524_ = _e1240;
                                                            }
                                                            let _e1255 = phi_4524_;
                                                            if (_e1255 < (_e1168 * (_e1222 - _e1224))) {
                                                                phi_4531_ = false;
                                                            } else {
                                                                phi_4531_ = true;
                                                            }
                                                            let _e1260 = phi_4531_;
                                                            phi_4532_ = _e1260;
                                                        } else {
                                                            phi_4532_ = true;
                                                        }
                                                        let _e1262 = phi_4532_;
                                                        phi_4533_ = _e1262;
                                                    } else {
                                                        phi_4533_ = true;
                                                    }
                                                    let _e1264 = phi_4533_;
                                                    if _e1264 {
                                                        phi_4539_ = (_e1168 * (_e1224 + _e1222));
                                                    } else {
                                                        phi_4539_ = _e1249;
                                                    }
                                                    let _e1268 = phi_4539_;
                                                    phi_4540_ = _e1268;
                                                    phi_4541_ = false;
                                                } else {
                                                    phi_4540_ = f64();
                                                    phi_4541_ = true;
                                                }
                                                let _e1270 = phi_4540_;
                                                let _e1272 = phi_4541_;
                                                phi_4426_ = _e1222;
                                                phi_4428_ = _e1224;
                                                phi_4430_ = _e1270;
                                                phi_4542_ = _e1224;
                                                phi_4543_ = _e1226;
                                                phi_4544_ = _e1272;
                                            } else {
                                                phi_4426_ = f64();
                                                phi_4428_ = f64();
                                                phi_4430_ = f64();
                                                phi_4542_ = f64();
                                                phi_4543_ = false;
                                                phi_4544_ = false;
                                            }
                                            let _e1274 = phi_4426_;
                                            let _e1276 = phi_4428_;
                                            let _e1278 = phi_4430_;
                                            let _e1280 = phi_4542_;
                                            let _e1282 = phi_4543_;
                                            let _e1284 = phi_4544_;
                                            local_22 = _e1284;
                                            local_50 = _e1280;
                                            continue;
                                            continuing {
                                                phi_4422_ = _e1198;
                                                phi_4425_ = _e1274;
                                                phi_4427_ = _e1276;
                                                phi_4429_ = _e1278;
                                                break if !(_e1282);
                                            }
                                        }
                                        let _e1287 = local_22;
                                        if _e1287 {
                                            let _e4986 = local_50;
                                            phi_4548_ = _e4986;
                                        } else {
                                            let _e4988 = local_51;
                                            phi_4548_ = _e4988;
                                        }
                                        let _e1289 = phi_4548_;
                                        phi_4549_ = _e1289;
                                    } else {
                                        phi_4549_ = _e1095;
                                    }
                                    let _e1291 = phi_4549_;
                                    if _e1135 {
                                        phi_4557_ = type_29(0u, 64u);
                                        phi_4560_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1295 = phi_4557_;
                                            let _e1297 = phi_4560_;
                                            if (_e1295.member < _e1295.member_1) {
                                                phi_4558_ = type_29((_e1295.member + 1u), _e1295.member_1);
                                                phi_4583_ = type_29(1u, _e1295.member);
                                            } else {
                                                phi_4558_ = _e1295;
                                                phi_4583_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1311 = phi_4558_;
                                            let _e1313 = phi_4583_;
                                            if (bitcast<i32>(_e1313.member) != 0i) {
                                                let _e1317 = (_e1291 + _e1297);
                                                if (_e1317 < _e1099) {
                                                    let _e1320 = (f64(1f) - _e1317);
                                                    let _e1331 = ((((_e540 * _e1320) + (_e563 * _e1317)) * (_e1320 * _e1320)) + (((_e586 * _e1320) + (_e597 * _e1317)) * (_e1317 * _e1317)));
                                                    let _e1333 = (f64(1f) - _e1291);
                                                    let _e1344 = ((((_e540 * _e1333) + (_e563 * _e1291)) * (_e1333 * _e1333)) + (((_e586 * _e1333) + (_e597 * _e1291)) * (_e1291 * _e1291)));
                                                    if (_e1331 < 0.0lf) {
                                                        phi_4626_ = -(_e1331);
                                                    } else {
                                                        phi_4626_ = _e1331;
                                                    }
                                                    let _e1348 = phi_4626_;
                                                    if (_e1348 > _e920) {
                                                        if (_e1344 < 0.0lf) {
                                                            phi_4636_ = -(_e1344);
                                                        } else {
                                                            phi_4636_ = _e1344;
                                                        }
                                                        let _e1353 = phi_4636_;
                                                        if (_e1353 > _e920) {
                                                            phi_4646_ = ((_e1331 > f64(0f)) == (_e1344 > f64(0f)));
                                                        } else {
                                                            phi_4646_ = false;
                                                        }
                                                        let _e1361 = phi_4646_;
                                                        phi_4648_ = !(_e1361);
                                                    } else {
                                                        phi_4648_ = false;
                                                    }
                                                    let _e1364 = phi_4648_;
                                                    if _e1364 {
                                                        phi_4653_ = f64();
                                                        phi_4654_ = false;
                                                    } else {
                                                        phi_4653_ = (_e1297 + _e1297);
                                                        phi_4654_ = true;
                                                    }
                                                    let _e1367 = phi_4653_;
                                                    let _e1369 = phi_4654_;
                                                    phi_4655_ = _e1367;
                                                    phi_4656_ = _e1369;
                                                    phi_4657_ = _e1364;
                                                    phi_4658_ = false;
                                                } else {
                                                    phi_4655_ = f64();
                                                    phi_4656_ = false;
                                                    phi_4657_ = false;
                                                    phi_4658_ = true;
                                                }
                                                let _e1371 = phi_4655_;
                                                let _e1373 = phi_4656_;
                                                let _e1375 = phi_4657_;
                                                let _e1377 = phi_4658_;
                                                phi_4659_ = _e1317;
                                                phi_4561_ = _e1371;
                                                phi_4660_ = _e1373;
                                                phi_4661_ = _e1375;
                                                phi_4662_ = _e1377;
                                                phi_4663_ = false;
                                            } else {
                                                phi_4659_ = f64();
                                                phi_4561_ = f64();
                                                phi_4660_ = false;
                                                phi_4661_ = false;
                                                phi_4662_ = false;
                                                phi_4663_ = true;
                                            }
                                            let _e1379 = phi_4659_;
                                            let _e1381 = phi_4561_;
                                            let _e1383 = phi_4660_;
                                            let _e1385 = phi_4661_;
                                            let _e1387 = phi_4662_;
                                            let _e1389 = phi_4663_;
                                            local_23 = _e1385;
                                            local_52 = _e1387;
                                            local_53 = _e1389;
                                            local_54 = _e1379;
                                            continue;
                                            continuing {
                                                phi_4557_ = _e1311;
                                                phi_4560_ = _e1381;
                                                break if !(_e1383);
                                            }
                                        }
                                        let _e1392 = local_23;
                                        if _e1392 {
                                            phi_4667_ = false;
                                            phi_4668_ = false;
                                        } else {
                                            let _e5013 = local_52;
                                            phi_4667_ = _e5013;
                                            let _e5016 = local_53;
                                            phi_4668_ = _e5016;
                                        }
                                        let _e1394 = phi_4667_;
                                        let _e1396 = phi_4668_;
                                        if _e1394 {
                                            phi_4672_ = true;
                                        } else {
                                            phi_4672_ = _e1396;
                                        }
                                        let _e1398 = phi_4672_;
                                        if _e1398 {
                                            phi_4676_ = _e1099;
                                        } else {
                                            let _e5020 = local_54;
                                            phi_4676_ = _e5020;
                                        }
                                        let _e1400 = phi_4676_;
                                        phi_4677_ = _e1400;
                                    } else {
                                        phi_4677_ = _e1099;
                                    }
                                    let _e1402 = phi_4677_;
                                    phi_4679_ = type_74(_e1291, _e1402, _e1149);
                                } else {
                                    phi_4679_ = _e1159;
                                }
                                let _e1405 = phi_4679_;
                                if (_e1405.member > _e1405.member_1) {
                                    phi_7266_ = f64();
                                    phi_7267_ = true;
                                    phi_7268_ = false;
                                    phi_7269_ = false;
                                    phi_7270_ = false;
                                } else {
                                    let _e1413 = ((_e1405.member_1 - _e1405.member) * f64(0.5f));
                                    let _e1414 = (_e1405.member + _e1413);
                                    let _e1417 = (_e1413 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1419 = local_20.member_3;
                                    let _e1422 = local_20.member[0u];
                                    if (_e1422[0] < 0.0lf) {
                                        phi_4710_ = -(_e1422[0]);
                                    } else {
                                        phi_4710_ = _e1422[0];
                                    }
                                    let _e1429 = phi_4710_;
                                    if (_e1422[1] < 0.0lf) {
                                        phi_4717_ = -(_e1422[1]);
                                    } else {
                                        phi_4717_ = _e1422[1];
                                    }
                                    let _e1433 = phi_4717_;
                                    if (_e1429 > _e1433) {
                                        phi_4722_ = _e1429;
                                    } else {
                                        phi_4722_ = _e1433;
                                    }
                                    let _e1436 = phi_4722_;
                                    if (_e1422[2] < 0.0lf) {
                                        phi_4729_ = -(_e1422[2]);
                                    } else {
                                        phi_4729_ = _e1422[2];
                                    }
                                    let _e1440 = phi_4729_;
                                    if (_e1436 > _e1440) {
                                        phi_4734_ = _e1436;
                                    } else {
                                        phi_4734_ = _e1440;
                                    }
                                    let _e1443 = phi_4734_;
                                    let _e1445 = local_20.member[1u];
                                    if (_e1445[0] < 0.0lf) {
                                        phi_4747_ = -(_e1445[0]);
                                    } else {
                                        phi_4747_ = _e1445[0];
                                    }
                                    let _e1452 = phi_4747_;
                                    if (_e1445[1] < 0.0lf) {
                                        phi_4754_ = -(_e1445[1]);
                                    } else {
                                        phi_4754_ = _e1445[1];
                                    }
                                    let _e1456 = phi_4754_;
                                    if (_e1452 > _e1456) {
                                        phi_4759_ = _e1452;
                                    } else {
                                        phi_4759_ = _e1456;
                                    }
                                    let _e1459 = phi_4759_;
                                    if (_e1445[2] < 0.0lf) {
                                        phi_4766_ = -(_e1445[2]);
                                    } else {
                                        phi_4766_ = _e1445[2];
                                    }
                                    let _e1463 = phi_4766_;
                                    if (_e1459 > _e1463) {
                                        phi_4771_ = _e1459;
                                    } else {
                                        phi_4771_ = _e1463;
                                    }
                                    let _e1466 = phi_4771_;
                                    if (_e1443 > _e1466) {
                                        phi_4776_ = _e1443;
                                    } else {
                                        phi_4776_ = _e1466;
                                    }
                                    let _e1469 = phi_4776_;
                                    let _e1472 = local_20.member[0u];
                                    let _e1477 = local_20.member[1u];
                                    let _e1487 = (_e1472[0] + ((_e1477[0] - _e1472[0]) * _e1414));
                                    let _e1488 = (_e1472[1] + ((_e1477[1] - _e1472[1]) * _e1414));
                                    let _e1489 = (_e1472[2] + ((_e1477[2] - _e1472[2]) * _e1414));
                                    let _e1491 = local_20.member[1u];
                                    let _e1496 = local_20.member[0u];
                                    let _e1500 = (_e1491[0] - _e1496[0]);
                                    let _e1501 = (_e1491[1] - _e1496[1]);
                                    let _e1502 = (_e1491[2] - _e1496[2]);
                                    if (_e1500 < 0.0lf) {
                                        phi_4835_ = -(_e1500);
                                    } else {
                                        phi_4835_ = _e1500;
                                    }
                                    let _e1506 = phi_4835_;
                                    if (_e1501 < 0.0lf) {
                                        phi_4841_ = -(_e1501);
                                    } else {
                                        phi_4841_ = _e1501;
                                    }
                                    let _e1510 = phi_4841_;
                                    if (_e1506 > _e1510) {
                                        phi_4846_ = _e1506;
                                    } else {
                                        phi_4846_ = _e1510;
                                    }
                                    let _e1513 = phi_4846_;
                                    if (_e1502 < 0.0lf) {
                                        phi_4852_ = -(_e1502);
                                    } else {
                                        phi_4852_ = _e1502;
                                    }
                                    let _e1517 = phi_4852_;
                                    if (_e1513 > _e1517) {
                                        phi_4857_ = _e1513;
                                    } else {
                                        phi_4857_ = _e1517;
                                    }
                                    let _e1520 = phi_4857_;
                                    let _e1528 = ((((_e1417 * _e1520) * f64(1.01f)) + ((_e1469 + _e1419) * (1.1102230246251565e-16lf * f64(8f)))) + _e1419);
                                    if (_e1487 < 0.0lf) {
                                        phi_4871_ = -(_e1487);
                                    } else {
                                        phi_4871_ = _e1487;
                                    }
                                    let _e1532 = phi_4871_;
                                    if (_e1488 < 0.0lf) {
                                        phi_4877_ = -(_e1488);
                                    } else {
                                        phi_4877_ = _e1488;
                                    }
                                    let _e1536 = phi_4877_;
                                    if (_e1532 > _e1536) {
                                        phi_4882_ = _e1532;
                                    } else {
                                        phi_4882_ = _e1536;
                                    }
                                    let _e1539 = phi_4882_;
                                    if (_e1489 < 0.0lf) {
                                        phi_4888_ = -(_e1489);
                                    } else {
                                        phi_4888_ = _e1489;
                                    }
                                    let _e1543 = phi_4888_;
                                    if (_e1539 > _e1543) {
                                        phi_4893_ = _e1539;
                                    } else {
                                        phi_4893_ = _e1543;
                                    }
                                    let _e1546 = phi_4893_;
                                    local_3 = type_52(array<f64, 3>(_e1487, _e1488, _e1489), _e1528, (_e1546 + _e1528));
                                    let _e1552 = local_20.member_3;
                                    let _e1554 = local_20.member_1[0u];
                                    if (_e1554[0] < 0.0lf) {
                                        phi_4919_ = -(_e1554[0]);
                                    } else {
                                        phi_4919_ = _e1554[0];
                                    }
                                    let _e1561 = phi_4919_;
                                    if (_e1554[1] < 0.0lf) {
                                        phi_4926_ = -(_e1554[1]);
                                    } else {
                                        phi_4926_ = _e1554[1];
                                    }
                                    let _e1565 = phi_4926_;
                                    if (_e1561 > _e1565) {
                                        phi_4931_ = _e1561;
                                    } else {
                                        phi_4931_ = _e1565;
                                    }
                                    let _e1568 = phi_4931_;
                                    if (_e1554[2] < 0.0lf) {
                                        phi_4938_ = -(_e1554[2]);
                                    } else {
                                        phi_4938_ = _e1554[2];
                                    }
                                    let _e1572 = phi_4938_;
                                    if (_e1568 > _e1572) {
                                        phi_4943_ = _e1568;
                                    } else {
                                        phi_4943_ = _e1572;
                                    }
                                    let _e1575 = phi_4943_;
                                    let _e1577 = local_20.member_1[1u];
                                    if (_e1577[0] < 0.0lf) {
                                        phi_4956_ = -(_e1577[0]);
                                    } else {
                                        phi_4956_ = _e1577[0];
                                    }
                                    let _e1584 = phi_4956_;
                                    if (_e1577[1] < 0.0lf) {
                                        phi_4963_ = -(_e1577[1]);
                                    } else {
                                        phi_4963_ = _e1577[1];
                                    }
                                    let _e1588 = phi_4963_;
                                    if (_e1584 > _e1588) {
                                        phi_4968_ = _e1584;
                                    } else {
                                        phi_4968_ = _e1588;
                                    }
                                    let _e1591 = phi_4968_;
                                    if (_e1577[2] < 0.0lf) {
                                        phi_4975_ = -(_e1577[2]);
                                    } else {
                                        phi_4975_ = _e1577[2];
                                    }
                                    let _e1595 = phi_4975_;
                                    if (_e1591 > _e1595) {
                                        phi_4980_ = _e1591;
                                    } else {
                                        phi_4980_ = _e1595;
                                    }
                                    let _e1598 = phi_4980_;
                                    if (_e1575 > _e1598) {
                                        phi_4985_ = _e1575;
                                    } else {
                                        phi_4985_ = _e1598;
                                    }
                                    let _e1601 = phi_4985_;
                                    let _e1604 = local_20.member_1[0u];
                                    let _e1609 = local_20.member_1[1u];
                                    let _e1619 = (_e1604[0] + ((_e1609[0] - _e1604[0]) * _e1414));
                                    let _e1620 = (_e1604[1] + ((_e1609[1] - _e1604[1]) * _e1414));
                                    let _e1621 = (_e1604[2] + ((_e1609[2] - _e1604[2]) * _e1414));
                                    let _e1623 = local_20.member_1[1u];
                                    let _e1628 = local_20.member_1[0u];
                                    let _e1632 = (_e1623[0] - _e1628[0]);
                                    let _e1633 = (_e1623[1] - _e1628[1]);
                                    let _e1634 = (_e1623[2] - _e1628[2]);
                                    if (_e1632 < 0.0lf) {
                                        phi_5044_ = -(_e1632);
                                    } else {
                                        phi_5044_ = _e1632;
                                    }
                                    let _e1638 = phi_5044_;
                                    if (_e1633 < 0.0lf) {
                                        phi_5050_ = -(_e1633);
                                    } else {
                                        phi_5050_ = _e1633;
                                    }
                                    let _e1642 = phi_5050_;
                                    if (_e1638 > _e1642) {
                                        phi_5055_ = _e1638;
                                    } else {
                                        phi_5055_ = _e1642;
                                    }
                                    let _e1645 = phi_5055_;
                                    if (_e1634 < 0.0lf) {
                                        phi_5061_ = -(_e1634);
                                    } else {
                                        phi_5061_ = _e1634;
                                    }
                                    let _e1649 = phi_5061_;
                                    if (_e1645 > _e1649) {
                                        phi_5066_ = _e1645;
                                    } else {
                                        phi_5066_ = _e1649;
                                    }
                                    let _e1652 = phi_5066_;
                                    let _e1660 = ((((_e1417 * _e1652) * f64(1.01f)) + ((_e1601 + _e1552) * (1.1102230246251565e-16lf * f64(8f)))) + _e1552);
                                    if (_e1619 < 0.0lf) {
                                        phi_5080_ = -(_e1619);
                                    } else {
                                        phi_5080_ = _e1619;
                                    }
                                    let _e1664 = phi_5080_;
                                    if (_e1620 < 0.0lf) {
                                        phi_5086_ = -(_e1620);
                                    } else {
                                        phi_5086_ = _e1620;
                                    }
                                    let _e1668 = phi_5086_;
                                    if (_e1664 > _e1668) {
                                        phi_5091_ = _e1664;
                                    } else {
                                        phi_5091_ = _e1668;
                                    }
                                    let _e1671 = phi_5091_;
                                    if (_e1621 < 0.0lf) {
                                        phi_5097_ = -(_e1621);
                                    } else {
                                        phi_5097_ = _e1621;
                                    }
                                    let _e1675 = phi_5097_;
                                    if (_e1671 > _e1675) {
                                        phi_5102_ = _e1671;
                                    } else {
                                        phi_5102_ = _e1675;
                                    }
                                    let _e1678 = phi_5102_;
                                    local_4 = type_52(array<f64, 3>(_e1619, _e1620, _e1621), _e1660, (_e1678 + _e1660));
                                    let _e1684 = local_20.member_3;
                                    let _e1686 = local_20.member_2[0u];
                                    if (_e1686[0] < 0.0lf) {
                                        phi_5128_ = -(_e1686[0]);
                                    } else {
                                        phi_5128_ = _e1686[0];
                                    }
                                    let _e1693 = phi_5128_;
                                    if (_e1686[1] < 0.0lf) {
                                        phi_5135_ = -(_e1686[1]);
                                    } else {
                                        phi_5135_ = _e1686[1];
                                    }
                                    let _e1697 = phi_5135_;
                                    if (_e1693 > _e1697) {
                                        phi_5140_ = _e1693;
                                    } else {
                                        phi_5140_ = _e1697;
                                    }
                                    let _e1700 = phi_5140_;
                                    if (_e1686[2] < 0.0lf) {
                                        phi_5147_ = -(_e1686[2]);
                                    } else {
                                        phi_5147_ = _e1686[2];
                                    }
                                    let _e1704 = phi_5147_;
                                    if (_e1700 > _e1704) {
                                        phi_5152_ = _e1700;
                                    } else {
                                        phi_5152_ = _e1704;
                                    }
                                    let _e1707 = phi_5152_;
                                    let _e1709 = local_20.member_2[1u];
                                    if (_e1709[0] < 0.0lf) {
                                        phi_5165_ = -(_e1709[0]);
                                    } else {
                                        phi_5165_ = _e1709[0];
                                    }
                                    let _e1716 = phi_5165_;
                                    if (_e1709[1] < 0.0lf) {
                                        phi_5172_ = -(_e1709[1]);
                                    } else {
                                        phi_5172_ = _e1709[1];
                                    }
                                    let _e1720 = phi_5172_;
                                    if (_e1716 > _e1720) {
                                        phi_5177_ = _e1716;
                                    } else {
                                        phi_5177_ = _e1720;
                                    }
                                    let _e1723 = phi_5177_;
                                    if (_e1709[2] < 0.0lf) {
                                        phi_5184_ = -(_e1709[2]);
                                    } else {
                                        phi_5184_ = _e1709[2];
                                    }
                                    let _e1727 = phi_5184_;
                                    if (_e1723 > _e1727) {
                                        phi_5189_ = _e1723;
                                    } else {
                                        phi_5189_ = _e1727;
                                    }
                                    let _e1730 = phi_5189_;
                                    if (_e1707 > _e1730) {
                                        phi_5194_ = _e1707;
                                    } else {
                                        phi_5194_ = _e1730;
                                    }
                                    let _e1733 = phi_5194_;
                                    let _e1736 = local_20.member_2[0u];
                                    let _e1741 = local_20.member_2[1u];
                                    let _e1751 = (_e1736[0] + ((_e1741[0] - _e1736[0]) * _e1414));
                                    let _e1752 = (_e1736[1] + ((_e1741[1] - _e1736[1]) * _e1414));
                                    let _e1753 = (_e1736[2] + ((_e1741[2] - _e1736[2]) * _e1414));
                                    let _e1755 = local_20.member_2[1u];
                                    let _e1760 = local_20.member_2[0u];
                                    let _e1764 = (_e1755[0] - _e1760[0]);
                                    let _e1765 = (_e1755[1] - _e1760[1]);
                                    let _e1766 = (_e1755[2] - _e1760[2]);
                                    if (_e1764 < 0.0lf) {
                                        phi_5253_ = -(_e1764);
                                    } else {
                                        phi_5253_ = _e1764;
                                    }
                                    let _e1770 = phi_5253_;
                                    if (_e1765 < 0.0lf) {
                                        phi_5259_ = -(_e1765);
                                    } else {
                                        phi_5259_ = _e1765;
                                    }
                                    let _e1774 = phi_5259_;
                                    if (_e1770 > _e1774) {
                                        phi_5264_ = _e1770;
                                    } else {
                                        phi_5264_ = _e1774;
                                    }
                                    let _e1777 = phi_5264_;
                                    if (_e1766 < 0.0lf) {
                                        phi_5270_ = -(_e1766);
                                    } else {
                                        phi_5270_ = _e1766;
                                    }
                                    let _e1781 = phi_5270_;
                                    if (_e1777 > _e1781) {
                                        phi_5275_ = _e1777;
                                    } else {
                                        phi_5275_ = _e1781;
                                    }
                                    let _e1784 = phi_5275_;
                                    let _e1792 = ((((_e1417 * _e1784) * f64(1.01f)) + ((_e1733 + _e1684) * (1.1102230246251565e-16lf * f64(8f)))) + _e1684);
                                    if (_e1751 < 0.0lf) {
                                        phi_5289_ = -(_e1751);
                                    } else {
                                        phi_5289_ = _e1751;
                                    }
                                    let _e1796 = phi_5289_;
                                    if (_e1752 < 0.0lf) {
                                        phi_5295_ = -(_e1752);
                                    } else {
                                        phi_5295_ = _e1752;
                                    }
                                    let _e1800 = phi_5295_;
                                    if (_e1796 > _e1800) {
                                        phi_5300_ = _e1796;
                                    } else {
                                        phi_5300_ = _e1800;
                                    }
                                    let _e1803 = phi_5300_;
                                    if (_e1753 < 0.0lf) {
                                        phi_5306_ = -(_e1753);
                                    } else {
                                        phi_5306_ = _e1753;
                                    }
                                    let _e1807 = phi_5306_;
                                    if (_e1803 > _e1807) {
                                        phi_5311_ = _e1803;
                                    } else {
                                        phi_5311_ = _e1807;
                                    }
                                    let _e1810 = phi_5311_;
                                    local_5 = type_52(array<f64, 3>(_e1751, _e1752, _e1753), _e1792, (_e1810 + _e1792));
                                    let _e1815 = local_4.member;
                                    let _e1820 = local_5.member;
                                    let _e1826 = ((_e1815[1] * _e1820[2]) - (_e1815[2] * _e1820[1]));
                                    let _e1829 = ((_e1815[2] * _e1820[0]) - (_e1815[0] * _e1820[2]));
                                    let _e1832 = ((_e1815[0] * _e1820[1]) - (_e1815[1] * _e1820[0]));
                                    if (_e1826 < 0.0lf) {
                                        phi_5360_ = -(_e1826);
                                    } else {
                                        phi_5360_ = _e1826;
                                    }
                                    let _e1836 = phi_5360_;
                                    if (_e1829 < 0.0lf) {
                                        phi_5366_ = -(_e1829);
                                    } else {
                                        phi_5366_ = _e1829;
                                    }
                                    let _e1840 = phi_5366_;
                                    if (_e1836 > _e1840) {
                                        if (_e1826 < 0.0lf) {
                                            phi_5376_ = -(_e1826);
                                        } else {
                                            phi_5376_ = _e1826;
                                        }
                                        let _e1858 = phi_5376_;
                                        if (_e1832 < 0.0lf) {
                                            phi_5382_ = -(_e1832);
                                        } else {
                                            phi_5382_ = _e1832;
                                        }
                                        let _e1862 = phi_5382_;
                                        if (_e1858 > _e1862) {
                                            phi_5387_ = 2u;
                                            phi_5388_ = 1u;
                                        } else {
                                            phi_5387_ = 1u;
                                            phi_5388_ = 0u;
                                        }
                                        let _e1865 = phi_5387_;
                                        let _e1867 = phi_5388_;
                                        phi_5407_ = _e1865;
                                        phi_5408_ = _e1867;
                                    } else {
                                        if (_e1829 < 0.0lf) {
                                            phi_5394_ = -(_e1829);
                                        } else {
                                            phi_5394_ = _e1829;
                                        }
                                        let _e1845 = phi_5394_;
                                        if (_e1832 < 0.0lf) {
                                            phi_5400_ = -(_e1832);
                                        } else {
                                            phi_5400_ = _e1832;
                                        }
                                        let _e1849 = phi_5400_;
                                        if (_e1845 > _e1849) {
                                            phi_5405_ = 0u;
                                            phi_5406_ = 2u;
                                        } else {
                                            phi_5405_ = 1u;
                                            phi_5406_ = 0u;
                                        }
                                        let _e1852 = phi_5405_;
                                        let _e1854 = phi_5406_;
                                        phi_5407_ = _e1852;
                                        phi_5408_ = _e1854;
                                    }
                                    let _e1869 = phi_5407_;
                                    let _e1871 = phi_5408_;
                                    if (_e1871 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1875 = local_4.member[_e1871];
                                    if (_e1869 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1879 = local_5.member[_e1869];
                                    if (_e1869 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1884 = local_4.member[_e1869];
                                    if (_e1871 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1888 = local_5.member[_e1871];
                                    let _e1890 = ((_e1875 * _e1879) - (_e1884 * _e1888));
                                    let _e1891 = f64(1f);
                                    let _e1893 = local_4.member_1;
                                    let _e1895 = local_5.member_2;
                                    let _e1898 = local_4.member_2;
                                    let _e1900 = local_5.member_1;
                                    let _e1906 = local_4.member_2;
                                    let _e1908 = local_5.member_2;
                                    let _e1917 = local_4.member_2;
                                    let _e1920 = local_5.member_2;
                                    let _e1924 = (((((_e1893 * _e1895) + (_e1898 * _e1900)) * f64(2.01f)) + ((_e1906 * _e1908) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1891 + _e1917) * (_e1891 + _e1920))));
                                    if (_e1890 < 0.0lf) {
                                        phi_5479_ = -(_e1890);
                                    } else {
                                        phi_5479_ = _e1890;
                                    }
                                    let _e1928 = phi_5479_;
                                    if (_e1928 > _e1924) {
                                        if (_e1890 < f64(0f)) {
                                            phi_5491_ = f64(-1f);
                                        } else {
                                            phi_5491_ = f64(1f);
                                        }
                                        let _e1935 = phi_5491_;
                                        if (_e1871 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1939 = local_3.member[_e1871];
                                        if (_e1869 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1943 = local_5.member[_e1869];
                                        if (_e1869 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1948 = local_3.member[_e1869];
                                        if (_e1871 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1952 = local_5.member[_e1871];
                                        let _e1955 = f64(1f);
                                        let _e1957 = local_3.member_1;
                                        let _e1959 = local_5.member_2;
                                        let _e1962 = local_3.member_2;
                                        let _e1964 = local_5.member_1;
                                        let _e1970 = local_3.member_2;
                                        let _e1972 = local_5.member_2;
                                        let _e1981 = local_3.member_2;
                                        let _e1984 = local_5.member_2;
                                        let _e1988 = (((((_e1957 * _e1959) + (_e1962 * _e1964)) * f64(2.01f)) + ((_e1970 * _e1972) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1955 + _e1981) * (_e1955 + _e1984))));
                                        if (_e1871 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1992 = local_4.member[_e1871];
                                        if (_e1869 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1996 = local_3.member[_e1869];
                                        if (_e1869 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2001 = local_4.member[_e1869];
                                        if (_e1871 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2005 = local_3.member[_e1871];
                                        let _e2008 = f64(1f);
                                        let _e2010 = local_4.member_1;
                                        let _e2012 = local_3.member_2;
                                        let _e2015 = local_4.member_2;
                                        let _e2017 = local_3.member_1;
                                        let _e2023 = local_4.member_2;
                                        let _e2025 = local_3.member_2;
                                        let _e2034 = local_4.member_2;
                                        let _e2037 = local_3.member_2;
                                        let _e2041 = (((((_e2010 * _e2012) + (_e2015 * _e2017)) * f64(2.01f)) + ((_e2023 * _e2025) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2008 + _e2034) * (_e2008 + _e2037))));
                                        let _e2042 = (_e1890 * _e1935);
                                        let _e2043 = (((_e1939 * _e1943) - (_e1948 * _e1952)) * _e1935);
                                        let _e2044 = (((_e1992 * _e1996) - (_e2001 * _e2005)) * _e1935);
                                        if (_e2042 < 0.0lf) {
                                            phi_5630_ = -(_e2042);
                                        } else {
                                            phi_5630_ = _e2042;
                                        }
                                        let _e2048 = phi_5630_;
                                        if (_e2043 < 0.0lf) {
                                            phi_5636_ = -(_e2043);
                                        } else {
                                            phi_5636_ = _e2043;
                                        }
                                        let _e2052 = phi_5636_;
                                        if (_e2044 < 0.0lf) {
                                            phi_5643_ = -(_e2044);
                                        } else {
                                            phi_5643_ = _e2044;
                                        }
                                        let _e2057 = phi_5643_;
                                        let _e2063 = ((_e2042 - _e2043) - _e2044);
                                        let _e2066 = (((_e1924 + _e1988) + _e2041) + (((_e2048 + _e2052) + _e2057) * (1.1102230246251565e-16lf * f64(4f))));
                                        local_6[0u].member = _e2043;
                                        local_6[0u].member_1 = _e1988;
                                        local_6[1u].member = _e2044;
                                        local_6[1u].member_1 = _e2041;
                                        local_6[2u].member = _e2063;
                                        local_6[2u].member_1 = _e2066;
                                        local_6[3u].member = _e2063;
                                        local_6[3u].member_1 = _e2066;
                                        phi_5687_ = type_29(0u, 4u);
                                        phi_5690_ = true;
                                        loop {
                                            let _e2081 = phi_5687_;
                                            let _e2083 = phi_5690_;
                                            local_25 = _e2083;
                                            if (_e2081.member < _e2081.member_1) {
                                                phi_5688_ = type_29((_e2081.member + 1u), _e2081.member_1);
                                                phi_5713_ = type_29(1u, _e2081.member);
                                            } else {
                                                phi_5688_ = _e2081;
                                                phi_5713_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e2097 = phi_5688_;
                                            let _e2099 = phi_5713_;
                                            if (bitcast<i32>(_e2099.member) != 0i) {
                                                if (_e2099.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e2107 = local_6[_e2099.member_1].member;
                                                let _e2110 = local_6[_e2099.member_1].member_1;
                                                let _e2112 = (_e2107 < -(_e2110));
                                                if _e2112 {
                                                    phi_5740_ = bool();
                                                    phi_5741_ = false;
                                                } else {
                                                    phi_5740_ = (_e2083 && (_e2107 > _e2110));
                                                    phi_5741_ = true;
                                                }
                                                let _e2116 = phi_5740_;
                                                let _e2118 = phi_5741_;
                                                phi_5691_ = _e2116;
                                                phi_5742_ = _e2118;
                                                phi_5743_ = _e2112;
                                            } else {
                                                phi_5691_ = bool();
                                                phi_5742_ = false;
                                                phi_5743_ = false;
                                            }
                                            let _e2120 = phi_5691_;
                                            let _e2122 = phi_5742_;
                                            let _e2124 = phi_5743_;
                                            local_24 = _e2124;
                                            continue;
                                            continuing {
                                                phi_5687_ = _e2097;
                                                phi_5690_ = _e2120;
                                                break if !(_e2122);
                                            }
                                        }
                                        let _e2127 = local_24;
                                        if _e2127 {
                                            phi_5747_ = false;
                                        } else {
                                            phi_5747_ = true;
                                        }
                                        let _e2129 = phi_5747_;
                                        if _e2129 {
                                            let _e2131 = local_25;
                                            if _e2131 {
                                                phi_5754_ = 1u;
                                            } else {
                                                phi_5754_ = 2u;
                                            }
                                            let _e2133 = phi_5754_;
                                            phi_5755_ = _e2133;
                                            phi_5756_ = false;
                                        } else {
                                            phi_5755_ = u32();
                                            phi_5756_ = true;
                                        }
                                        let _e2135 = phi_5755_;
                                        let _e2137 = phi_5756_;
                                        phi_5757_ = _e2135;
                                        phi_5758_ = 0u;
                                        phi_5759_ = _e2137;
                                    } else {
                                        phi_5757_ = u32();
                                        phi_5758_ = 2u;
                                        phi_5759_ = true;
                                    }
                                    let _e2139 = phi_5757_;
                                    let _e2141 = phi_5758_;
                                    let _e2143 = phi_5759_;
                                    if _e2143 {
                                        phi_5763_ = _e2141;
                                    } else {
                                        phi_5763_ = _e2139;
                                    }
                                    let _e2145 = phi_5763_;
                                    let _e2146 = (_e2145 == 0u);
                                    if _e2146 {
                                        phi_7262_ = f64();
                                        phi_7263_ = false;
                                        phi_7264_ = false;
                                        phi_7265_ = false;
                                    } else {
                                        if (_e2145 == 1u) {
                                            if _e1405.member_2 {
                                                if ((_e1405.member_1 - _e1405.member) <= f64(0.0000005f)) {
                                                    phi_5784_ = false;
                                                } else {
                                                    phi_5784_ = true;
                                                }
                                                let _e2155 = phi_5784_;
                                                phi_5785_ = _e2155;
                                            } else {
                                                phi_5785_ = true;
                                            }
                                            let _e2157 = phi_5785_;
                                            phi_5786_ = _e2157;
                                        } else {
                                            phi_5786_ = true;
                                        }
                                        let _e2159 = phi_5786_;
                                        if _e2159 {
                                            let _e2165 = local_20.member[0u];
                                            let _e2171 = local_20.member_1[0u];
                                            let _e2177 = local_20.member_2[0u];
                                            local_1 = array<array<f64, 3>, 4>(_e2165, array<f64, 3>((_e2165[0] - _e2171[0]), (_e2165[1] - _e2171[1]), (_e2165[2] - _e2171[2])), array<f64, 3>((_e2165[0] - _e2177[0]), (_e2165[1] - _e2177[1]), (_e2165[2] - _e2177[2])), _e2165);
                                            let _e2192 = local_20.member[1u];
                                            let _e2198 = local_20.member_1[1u];
                                            let _e2204 = local_20.member_2[1u];
                                            local_2 = array<array<f64, 3>, 4>(_e2192, array<f64, 3>((_e2192[0] - _e2198[0]), (_e2192[1] - _e2198[1]), (_e2192[2] - _e2198[2])), array<f64, 3>((_e2192[0] - _e2204[0]), (_e2192[1] - _e2204[1]), (_e2192[2] - _e2204[2])), _e2192);
                                            let _e2219 = local_20.member[0u];
                                            if (_e2219[0] < 0.0lf) {
                                                phi_5983_ = -(_e2219[0]);
                                            } else {
                                                phi_5983_ = _e2219[0];
                                            }
                                            let _e2226 = phi_5983_;
                                            if (_e2219[1] < 0.0lf) {
                                                phi_5990_ = -(_e2219[1]);
                                            } else {
                                                phi_5990_ = _e2219[1];
                                            }
                                            let _e2230 = phi_5990_;
                                            if (_e2226 > _e2230) {
                                                phi_5995_ = _e2226;
                                            } else {
                                                phi_5995_ = _e2230;
                                            }
                                            let _e2233 = phi_5995_;
                                            if (_e2219[2] < 0.0lf) {
                                                phi_6002_ = -(_e2219[2]);
                                            } else {
                                                phi_6002_ = _e2219[2];
                                            }
                                            let _e2237 = phi_6002_;
                                            if (_e2233 > _e2237) {
                                                phi_6007_ = _e2233;
                                            } else {
                                                phi_6007_ = _e2237;
                                            }
                                            let _e2240 = phi_6007_;
                                            let _e2243 = local_20.member[1u];
                                            if (_e2243[0] < 0.0lf) {
                                                phi_6020_ = -(_e2243[0]);
                                            } else {
                                                phi_6020_ = _e2243[0];
                                            }
                                            let _e2250 = phi_6020_;
                                            if (_e2243[1] < 0.0lf) {
                                                phi_6027_ = -(_e2243[1]);
                                            } else {
                                                phi_6027_ = _e2243[1];
                                            }
                                            let _e2254 = phi_6027_;
                                            if (_e2250 > _e2254) {
                                                phi_6032_ = _e2250;
                                            } else {
                                                phi_6032_ = _e2254;
                                            }
                                            let _e2257 = phi_6032_;
                                            if (_e2243[2] < 0.0lf) {
                                                phi_6039_ = -(_e2243[2]);
                                            } else {
                                                phi_6039_ = _e2243[2];
                                            }
                                            let _e2261 = phi_6039_;
                                            if (_e2257 > _e2261) {
                                                phi_6044_ = _e2257;
                                            } else {
                                                phi_6044_ = _e2261;
                                            }
                                            let _e2264 = phi_6044_;
                                            if (_e2240 > _e2264) {
                                                phi_6049_ = _e2240;
                                            } else {
                                                phi_6049_ = _e2264;
                                            }
                                            let _e2267 = phi_6049_;
                                            let _e2269 = local_20.member_3;
                                            let _e2273 = local_20.member_1[0u];
                                            if (_e2273[0] < 0.0lf) {
                                                phi_6066_ = -(_e2273[0]);
                                            } else {
                                                phi_6066_ = _e2273[0];
                                            }
                                            let _e2280 = phi_6066_;
                                            if (_e2273[1] < 0.0lf) {
                                                phi_6073_ = -(_e2273[1]);
                                            } else {
                                                phi_6073_ = _e2273[1];
                                            }
                                            let _e2284 = phi_6073_;
                                            if (_e2280 > _e2284) {
                                                phi_6078_ = _e2280;
                                            } else {
                                                phi_6078_ = _e2284;
                                            }
                                            let _e2287 = phi_6078_;
                                            if (_e2273[2] < 0.0lf) {
                                                phi_6085_ = -(_e2273[2]);
                                            } else {
                                                phi_6085_ = _e2273[2];
                                            }
                                            let _e2291 = phi_6085_;
                                            if (_e2287 > _e2291) {
                                                phi_6090_ = _e2287;
                                            } else {
                                                phi_6090_ = _e2291;
                                            }
                                            let _e2294 = phi_6090_;
                                            let _e2297 = local_20.member_1[1u];
                                            if (_e2297[0] < 0.0lf) {
                                                phi_6104_ = -(_e2297[0]);
                                            } else {
                                                phi_6104_ = _e2297[0];
                                            }
                                            let _e2304 = phi_6104_;
                                            if (_e2297[1] < 0.0lf) {
                                                phi_6111_ = -(_e2297[1]);
                                            } else {
                                                phi_6111_ = _e2297[1];
                                            }
                                            let _e2308 = phi_6111_;
                                            if (_e2304 > _e2308) {
                                                phi_6116_ = _e2304;
                                            } else {
                                                phi_6116_ = _e2308;
                                            }
                                            let _e2311 = phi_6116_;
                                            if (_e2297[2] < 0.0lf) {
                                                phi_6123_ = -(_e2297[2]);
                                            } else {
                                                phi_6123_ = _e2297[2];
                                            }
                                            let _e2315 = phi_6123_;
                                            if (_e2311 > _e2315) {
                                                phi_6128_ = _e2311;
                                            } else {
                                                phi_6128_ = _e2315;
                                            }
                                            let _e2318 = phi_6128_;
                                            if (_e2294 > _e2318) {
                                                phi_6133_ = _e2294;
                                            } else {
                                                phi_6133_ = _e2318;
                                            }
                                            let _e2321 = phi_6133_;
                                            let _e2323 = local_20.member_3;
                                            let _e2327 = local_20.member_2[0u];
                                            if (_e2327[0] < 0.0lf) {
                                                phi_6150_ = -(_e2327[0]);
                                            } else {
                                                phi_6150_ = _e2327[0];
                                            }
                                            let _e2334 = phi_6150_;
                                            if (_e2327[1] < 0.0lf) {
                                                phi_6157_ = -(_e2327[1]);
                                            } else {
                                                phi_6157_ = _e2327[1];
                                            }
                                            let _e2338 = phi_6157_;
                                            if (_e2334 > _e2338) {
                                                phi_6162_ = _e2334;
                                            } else {
                                                phi_6162_ = _e2338;
                                            }
                                            let _e2341 = phi_6162_;
                                            if (_e2327[2] < 0.0lf) {
                                                phi_6169_ = -(_e2327[2]);
                                            } else {
                                                phi_6169_ = _e2327[2];
                                            }
                                            let _e2345 = phi_6169_;
                                            if (_e2341 > _e2345) {
                                                phi_6174_ = _e2341;
                                            } else {
                                                phi_6174_ = _e2345;
                                            }
                                            let _e2348 = phi_6174_;
                                            let _e2351 = local_20.member_2[1u];
                                            if (_e2351[0] < 0.0lf) {
                                                phi_6188_ = -(_e2351[0]);
                                            } else {
                                                phi_6188_ = _e2351[0];
                                            }
                                            let _e2358 = phi_6188_;
                                            if (_e2351[1] < 0.0lf) {
                                                phi_6195_ = -(_e2351[1]);
                                            } else {
                                                phi_6195_ = _e2351[1];
                                            }
                                            let _e2362 = phi_6195_;
                                            if (_e2358 > _e2362) {
                                                phi_6200_ = _e2358;
                                            } else {
                                                phi_6200_ = _e2362;
                                            }
                                            let _e2365 = phi_6200_;
                                            if (_e2351[2] < 0.0lf) {
                                                phi_6207_ = -(_e2351[2]);
                                            } else {
                                                phi_6207_ = _e2351[2];
                                            }
                                            let _e2369 = phi_6207_;
                                            if (_e2365 > _e2369) {
                                                phi_6212_ = _e2365;
                                            } else {
                                                phi_6212_ = _e2369;
                                            }
                                            let _e2372 = phi_6212_;
                                            if (_e2348 > _e2372) {
                                                phi_6217_ = _e2348;
                                            } else {
                                                phi_6217_ = _e2372;
                                            }
                                            let _e2375 = phi_6217_;
                                            let _e2377 = local_20.member_3;
                                            let _e2385 = local_20.member_3;
                                            phi_6237_ = type_29(0u, 48u);
                                            phi_6240_ = _e1405.member;
                                            loop {
                                                let _e2394 = phi_6237_;
                                                let _e2396 = phi_6240_;
                                                local_65 = _e2396;
                                                local_32 = _e2396;
                                                local_33 = _e2396;
                                                local_34 = _e2396;
                                                if (_e2394.member < _e2394.member_1) {
                                                    phi_6238_ = type_29((_e2394.member + 1u), _e2394.member_1);
                                                    phi_6263_ = type_29(1u, _e2394.member);
                                                } else {
                                                    phi_6238_ = _e2394;
                                                    phi_6263_ = type_29(0u, type_29().member_1);
                                                }
                                                let _e2410 = phi_6238_;
                                                let _e2412 = phi_6263_;
                                                if (bitcast<i32>(_e2412.member) != 0i) {
                                                    let _e2418 = local_20.member[0u];
                                                    let _e2424 = local_20.member[1u];
                                                    let _e2434 = (_e2418[0] + ((_e2424[0] - _e2418[0]) * _e2396));
                                                    let _e2435 = (_e2418[1] + ((_e2424[1] - _e2418[1]) * _e2396));
                                                    let _e2436 = (_e2418[2] + ((_e2424[2] - _e2418[2]) * _e2396));
                                                    let _e2439 = local_20.member_1[0u];
                                                    let _e2445 = local_20.member_1[1u];
                                                    let _e2455 = (_e2439[0] + ((_e2445[0] - _e2439[0]) * _e2396));
                                                    let _e2456 = (_e2439[1] + ((_e2445[1] - _e2439[1]) * _e2396));
                                                    let _e2457 = (_e2439[2] + ((_e2445[2] - _e2439[2]) * _e2396));
                                                    let _e2460 = local_20.member_2[0u];
                                                    let _e2466 = local_20.member_2[1u];
                                                    let _e2476 = (_e2460[0] + ((_e2466[0] - _e2460[0]) * _e2396));
                                                    let _e2477 = (_e2460[1] + ((_e2466[1] - _e2460[1]) * _e2396));
                                                    let _e2478 = (_e2460[2] + ((_e2466[2] - _e2460[2]) * _e2396));
                                                    let _e2483 = (((_e2455 * _e2455) + (_e2456 * _e2456)) + (_e2457 * _e2457));
                                                    let _e2488 = (((_e2455 * _e2476) + (_e2456 * _e2477)) + (_e2457 * _e2478));
                                                    let _e2493 = (((_e2476 * _e2476) + (_e2477 * _e2477)) + (_e2478 * _e2478));
                                                    let _e2498 = (((_e2434 * _e2455) + (_e2435 * _e2456)) + (_e2436 * _e2457));
                                                    let _e2503 = (((_e2434 * _e2476) + (_e2435 * _e2477)) + (_e2436 * _e2478));
                                                    let _e2506 = ((_e2483 * _e2493) - (_e2488 * _e2488));
                                                    let _e2507 = f64(0f);
                                                    let _e2512 = (((_e2498 * _e2493) - (_e2503 * _e2488)) / _e2506);
                                                    let _e2516 = (((_e2503 * _e2483) - (_e2498 * _e2488)) / _e2506);
                                                    if (_e2512 >= _e2507) {
                                                        if (_e2516 >= _e2507) {
                                                            phi_6439_ = ((_e2512 + _e2516) <= f64(1f));
                                                            phi_6440_ = false;
                                                        } else {
                                                            phi_6439_ = bool();
                                                            phi_6440_ = true;
                                                        }
                                                        let _e2522 = phi_6439_;
                                                        let _e2524 = phi_6440_;
                                                        phi_6441_ = _e2522;
                                                        phi_6442_ = _e2524;
                                                    } else {
                                                        phi_6441_ = bool();
                                                        phi_6442_ = true;
                                                    }
                                                    let _e2526 = phi_6441_;
                                                    let _e2528 = phi_6442_;
                                                    if _e2528 {
                                                        phi_6446_ = false;
                                                    } else {
                                                        phi_6446_ = _e2526;
                                                    }
                                                    let _e2530 = phi_6446_;
                                                    if (_e2506 > _e2507) {
                                                        if _e2530 {
                                                            phi_6468_ = array<f64, 3>((_e2434 - ((_e2455 * _e2512) + (_e2476 * _e2516))), (_e2435 - ((_e2456 * _e2512) + (_e2477 * _e2516))), (_e2436 - ((_e2457 * _e2512) + (_e2478 * _e2516))));
                                                            phi_6469_ = false;
                                                        } else {
                                                            phi_6468_ = array<f64, 3>();
                                                            phi_6469_ = true;
                                                        }
                                                        let _e2546 = phi_6468_;
                                                        let _e2548 = phi_6469_;
                                                        phi_6470_ = _e2546;
                                                        phi_6471_ = _e2548;
                                                    } else {
                                                        phi_6470_ = array<f64, 3>();
                                                        phi_6471_ = true;
                                                    }
                                                    let _e2550 = phi_6470_;
                                                    let _e2552 = phi_6471_;
                                                    if _e2552 {
                                                        let _e2553 = (_e2434 - _e2455);
                                                        let _e2554 = (_e2435 - _e2456);
                                                        let _e2555 = (_e2436 - _e2457);
                                                        let _e2556 = (_e2476 - _e2455);
                                                        let _e2557 = (_e2477 - _e2456);
                                                        let _e2558 = (_e2478 - _e2457);
                                                        let _e2569 = ((((_e2553 * _e2556) + (_e2554 * _e2557)) + (_e2555 * _e2558)) / (((_e2556 * _e2556) + (_e2557 * _e2557)) + (_e2558 * _e2558)));
                                                        if (_e2569 > f64(0f)) {
                                                            if (_e2569 < f64(1f)) {
                                                                phi_6658_ = _e2569;
                                                            } else {
                                                                phi_6658_ = f64(1f);
                                                            }
                                                            let _e2577 = phi_6658_;
                                                            phi_6660_ = _e2577;
                                                        } else {
                                                            phi_6660_ = f64(0f);
                                                        }
                                                        let _e2579 = phi_6660_;
                                                        let _e2583 = (_e2553 - (_e2556 * _e2579));
                                                        let _e2584 = (_e2554 - (_e2557 * _e2579));
                                                        let _e2585 = (_e2555 - (_e2558 * _e2579));
                                                        let _e2596 = ((((_e2434 * _e2455) + (_e2435 * _e2456)) + (_e2436 * _e2457)) / (((_e2455 * _e2455) + (_e2456 * _e2456)) + (_e2457 * _e2457)));
                                                        if (_e2596 > f64(0f)) {
                                                            if (_e2596 < f64(1f)) {
                                                                phi_6690_ = _e2596;
                                                            } else {
                                                                phi_6690_ = f64(1f);
                                                            }
                                                            let _e2604 = phi_6690_;
                                                            phi_6692_ = _e2604;
                                                        } else {
                                                            phi_6692_ = f64(0f);
                                                        }
                                                        let _e2606 = phi_6692_;
                                                        let _e2623 = ((((_e2434 * _e2476) + (_e2435 * _e2477)) + (_e2436 * _e2478)) / (((_e2476 * _e2476) + (_e2477 * _e2477)) + (_e2478 * _e2478)));
                                                        if (_e2623 > f64(0f)) {
                                                            if (_e2623 < f64(1f)) {
                                                                phi_6722_ = _e2623;
                                                            } else {
                                                                phi_6722_ = f64(1f);
                                                            }
                                                            let _e2631 = phi_6722_;
                                                            phi_6724_ = _e2631;
                                                        } else {
                                                            phi_6724_ = f64(0f);
                                                        }
                                                        let _e2633 = phi_6724_;
                                                        local[0u] = array<f64, 3>((_e2434 - (_e2455 * _e2606)), (_e2435 - (_e2456 * _e2606)), (_e2436 - (_e2457 * _e2606)));
                                                        local[1u] = array<f64, 3>((_e2434 - (_e2476 * _e2633)), (_e2435 - (_e2477 * _e2633)), (_e2436 - (_e2478 * _e2633)));
                                                        local[2u] = array<f64, 3>(_e2583, _e2584, _e2585);
                                                        local[3u] = array<f64, 3>(_e2583, _e2584, _e2585);
                                                        let _e2649 = local[0u];
                                                        phi_6760_ = type_29(1u, 4u);
                                                        phi_6763_ = array<f64, 3>(_e2649[0], _e2649[1], _e2649[2]);
                                                        loop {
                                                            let _e2655 = phi_6760_;
                                                            let _e2657 = phi_6763_;
                                                            local_55 = _e2657;
                                                            if (_e2655.member < _e2655.member_1) {
                                                                phi_6761_ = type_29((_e2655.member + 1u), _e2655.member_1);
                                                                phi_6786_ = type_29(1u, _e2655.member);
                                                            } else {
                                                                phi_6761_ = _e2655;
                                                                phi_6786_ = type_29(0u, type_29().member_1);
                                                            }
                                                            let _e2671 = phi_6761_;
                                                            let _e2673 = phi_6786_;
                                                            let _e2677 = (bitcast<i32>(_e2673.member) != 0i);
                                                            if _e2677 {
                                                                if (_e2673.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2680 = local[_e2673.member_1];
                                                                if (_e2673.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2686 = local[_e2673.member_1];
                                                                if ((((_e2680[0] * _e2686[0]) + (_e2680[1] * _e2686[1])) + (_e2680[2] * _e2686[2])) < (((_e2657[0] * _e2657[0]) + (_e2657[1] * _e2657[1])) + (_e2657[2] * _e2657[2]))) {
                                                                    if (_e2673.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2709 = local[_e2673.member_1];
                                                                    phi_6853_ = array<f64, 3>(_e2709[0], _e2709[1], _e2709[2]);
                                                                } else {
                                                                    phi_6853_ = _e2657;
                                                                }
                                                                let _e2715 = phi_6853_;
                                                                phi_6764_ = _e2715;
                                                            } else {
                                                                phi_6764_ = array<f64, 3>();
                                                            }
                                                            let _e2717 = phi_6764_;
                                                            continue;
                                                            continuing {
                                                                phi_6760_ = _e2671;
                                                                phi_6763_ = _e2717;
                                                                break if !(_e2677);
                                                            }
                                                        }
                                                        let _e5185 = local_55;
                                                        phi_6854_ = _e5185;
                                                    } else {
                                                        phi_6854_ = _e2550;
                                                    }
                                                    let _e2720 = phi_6854_;
                                                    if (_e2720[0] < 0.0lf) {
                                                        phi_6861_ = -(_e2720[0]);
                                                    } else {
                                                        phi_6861_ = _e2720[0];
                                                    }
                                                    let _e2725 = phi_6861_;
                                                    if (_e2720[1] < 0.0lf) {
                                                        phi_6868_ = -(_e2720[1]);
                                                    } else {
                                                        phi_6868_ = _e2720[1];
                                                    }
                                                    let _e2730 = phi_6868_;
                                                    if (_e2720[2] < 0.0lf) {
                                                        phi_6876_ = -(_e2720[2]);
                                                    } else {
                                                        phi_6876_ = _e2720[2];
                                                    }
                                                    let _e2736 = phi_6876_;
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
                                                                    phi_6914_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_6914_ = 0.0lf;
                                                                }
                                                                let _e2812 = phi_6914_;
                                                                phi_6978_ = _e2812;
                                                            } else {
                                                                phi_6921_ = type_27(0i, 5i);
                                                                phi_6924_ = bitcast<f64>(((bitcast<u64>(_e2754) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2761 = phi_6921_;
                                                                    let _e2763 = phi_6924_;
                                                                    local_26 = _e2763;
                                                                    if (_e2761.member < _e2761.member_1) {
                                                                        let _e2771 = (_e2761.member + 1i);
                                                                        if ((false == (_e2771 > _e2761.member)) != false) {
                                                                            phi_6945_ = true;
                                                                        } else {
                                                                            phi_6945_ = false;
                                                                        }
                                                                        let _e2776 = phi_6945_;
                                                                        if _e2776 {
                                                                            phi_6951_ = type_28(0u, type_28().member_1);
                                                                        } else {
                                                                            phi_6951_ = type_28(1u, _e2771);
                                                                        }
                                                                        let _e2782 = phi_6951_;
                                                                        if (bitcast<i32>(_e2782.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_6922_ = type_27(_e2782.member_1, _e2761.member_1);
                                                                        phi_6965_ = type_28(1u, _e2761.member);
                                                                    } else {
                                                                        phi_6922_ = _e2761;
                                                                        phi_6965_ = type_28(0u, type_28().member_1);
                                                                    }
                                                                    let _e2792 = phi_6922_;
                                                                    let _e2794 = phi_6965_;
                                                                    let _e2797 = (bitcast<i32>(_e2794.member) != 0i);
                                                                    if _e2797 {
                                                                        phi_6925_ = (0.5lf * (_e2763 + (_e2754 / _e2763)));
                                                                    } else {
                                                                        phi_6925_ = f64();
                                                                    }
                                                                    let _e2802 = phi_6925_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6921_ = _e2792;
                                                                        phi_6924_ = _e2802;
                                                                        break if !(_e2797);
                                                                    }
                                                                }
                                                                let _e2807 = local_26;
                                                                phi_6978_ = (_e2807 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2814 = phi_6978_;
                                                            phi_6991_ = type_29(0u, 4u);
                                                            phi_6994_ = f64(2f);
                                                            loop {
                                                                let _e2826 = phi_6991_;
                                                                let _e2828 = phi_6994_;
                                                                local_28 = _e2828;
                                                                local_29 = _e2828;
                                                                local_30 = _e2828;
                                                                local_56 = _e2828;
                                                                local_57 = _e2828;
                                                                if (_e2826.member < _e2826.member_1) {
                                                                    phi_6992_ = type_29((_e2826.member + 1u), _e2826.member_1);
                                                                    phi_7017_ = type_29(1u, _e2826.member);
                                                                } else {
                                                                    phi_6992_ = _e2826;
                                                                    phi_7017_ = type_29(0u, type_29().member_1);
                                                                }
                                                                let _e2842 = phi_6992_;
                                                                let _e2844 = phi_7017_;
                                                                if (bitcast<i32>(_e2844.member) != 0i) {
                                                                    if (_e2844.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2851 = local_1[_e2844.member_1];
                                                                    let _e2859 = (((_e2745 * _e2851[0]) + (_e2747 * _e2851[1])) + (_e2749 * _e2851[2]));
                                                                    if (_e2844.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2862 = local_2[_e2844.member_1];
                                                                    let _e2870 = (((_e2745 * _e2862[0]) + (_e2747 * _e2862[1])) + (_e2749 * _e2862[2]));
                                                                    if (_e2859 < 0.0lf) {
                                                                        phi_7068_ = -(_e2859);
                                                                    } else {
                                                                        phi_7068_ = _e2859;
                                                                    }
                                                                    let _e2874 = phi_7068_;
                                                                    if (_e2870 < 0.0lf) {
                                                                        phi_7074_ = -(_e2870);
                                                                    } else {
                                                                        phi_7074_ = _e2870;
                                                                    }
                                                                    let _e2878 = phi_7074_;
                                                                    let _e2883 = (((((((((_e2267 + _e2269) + (_e2321 + _e2323)) + (_e2375 + _e2377)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2385 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2814) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2874 + _e2878) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2859 > _e2883) {
                                                                        if (_e2870 > _e2883) {
                                                                            phi_7088_ = false;
                                                                        } else {
                                                                            phi_7088_ = true;
                                                                        }
                                                                        let _e2887 = phi_7088_;
                                                                        phi_7089_ = _e2887;
                                                                    } else {
                                                                        phi_7089_ = true;
                                                                    }
                                                                    let _e2889 = phi_7089_;
                                                                    if _e2889 {
                                                                        let _e2893 = ((_e2859 + ((_e2870 - _e2859) * _e2396)) > _e2883);
                                                                        if _e2893 {
                                                                            if (_e2870 < _e2859) {
                                                                                let _e2902 = (((_e2859 - _e2883) / (_e2859 - _e2870)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                if (_e2828 < _e2902) {
                                                                                    phi_7116_ = _e2828;
                                                                                } else {
                                                                                    phi_7116_ = _e2902;
                                                                                }
                                                                                let _e2905 = phi_7116_;
                                                                                phi_7117_ = _e2905;
                                                                            } else {
                                                                                phi_7117_ = _e2828;
                                                                            }
                                                                            let _e2907 = phi_7117_;
                                                                            phi_7118_ = _e2907;
                                                                        } else {
                                                                            phi_7118_ = f64();
                                                                        }
                                                                        let _e2909 = phi_7118_;
                                                                        phi_7119_ = _e2909;
                                                                        phi_7120_ = _e2893;
                                                                    } else {
                                                                        phi_7119_ = _e2828;
                                                                        phi_7120_ = true;
                                                                    }
                                                                    let _e2911 = phi_7119_;
                                                                    let _e2913 = phi_7120_;
                                                                    phi_6995_ = _e2911;
                                                                    phi_7121_ = _e2913;
                                                                    phi_7122_ = false;
                                                                } else {
                                                                    phi_6995_ = f64();
                                                                    phi_7121_ = false;
                                                                    phi_7122_ = true;
                                                                }
                                                                let _e2915 = phi_6995_;
                                                                let _e2917 = phi_7121_;
                                                                let _e2919 = phi_7122_;
                                                                local_27 = _e2919;
                                                                continue;
                                                                continuing {
                                                                    phi_6991_ = _e2842;
                                                                    phi_6994_ = _e2915;
                                                                    break if !(_e2917);
                                                                }
                                                            }
                                                            let _e2922 = local_27;
                                                            if _e2922 {
                                                                let _e2924 = local_28;
                                                                let _e2925 = (_e2924 > _e1405.member_1);
                                                                if _e2925 {
                                                                    phi_7144_ = false;
                                                                    phi_7145_ = false;
                                                                    phi_7146_ = false;
                                                                } else {
                                                                    let _e2927 = local_29;
                                                                    if (_e2927 > _e2396) {
                                                                        let _e2930 = local_30;
                                                                        let _e2933 = ((_e2930 - _e2396) < f64(0.00000000023283064f));
                                                                        if _e2933 {
                                                                            phi_7140_ = false;
                                                                        } else {
                                                                            phi_7140_ = true;
                                                                        }
                                                                        let _e2935 = phi_7140_;
                                                                        phi_7141_ = _e2935;
                                                                        phi_7142_ = _e2933;
                                                                        phi_7143_ = false;
                                                                    } else {
                                                                        phi_7141_ = false;
                                                                        phi_7142_ = false;
                                                                        phi_7143_ = true;
                                                                    }
                                                                    let _e2937 = phi_7141_;
                                                                    let _e2939 = phi_7142_;
                                                                    let _e2941 = phi_7143_;
                                                                    phi_7144_ = _e2937;
                                                                    phi_7145_ = _e2939;
                                                                    phi_7146_ = _e2941;
                                                                }
                                                                let _e2943 = phi_7144_;
                                                                let _e2945 = phi_7145_;
                                                                let _e2947 = phi_7146_;
                                                                phi_7147_ = _e2943;
                                                                phi_7148_ = _e2925;
                                                                phi_7149_ = _e2945;
                                                                phi_7150_ = _e2947;
                                                                phi_7151_ = false;
                                                            } else {
                                                                phi_7147_ = false;
                                                                phi_7148_ = false;
                                                                phi_7149_ = false;
                                                                phi_7150_ = false;
                                                                phi_7151_ = true;
                                                            }
                                                            let _e2949 = phi_7147_;
                                                            let _e2951 = phi_7148_;
                                                            let _e2953 = phi_7149_;
                                                            let _e2955 = phi_7150_;
                                                            let _e2957 = phi_7151_;
                                                            let _e5233 = local_56;
                                                            phi_7152_ = _e5233;
                                                            let _e5236 = local_57;
                                                            phi_7153_ = _e5236;
                                                            phi_7154_ = _e2949;
                                                            phi_7155_ = _e2951;
                                                            phi_7156_ = _e2953;
                                                            phi_7157_ = _e2955;
                                                            phi_7158_ = _e2957;
                                                            phi_7159_ = false;
                                                        } else {
                                                            phi_7152_ = f64();
                                                            phi_7153_ = f64();
                                                            phi_7154_ = false;
                                                            phi_7155_ = false;
                                                            phi_7156_ = false;
                                                            phi_7157_ = false;
                                                            phi_7158_ = false;
                                                            phi_7159_ = true;
                                                        }
                                                        let _e2959 = phi_7152_;
                                                        let _e2961 = phi_7153_;
                                                        let _e2963 = phi_7154_;
                                                        let _e2965 = phi_7155_;
                                                        let _e2967 = phi_7156_;
                                                        let _e2969 = phi_7157_;
                                                        let _e2971 = phi_7158_;
                                                        let _e2973 = phi_7159_;
                                                        phi_7160_ = _e2959;
                                                        phi_7161_ = _e2961;
                                                        phi_7162_ = _e2963;
                                                        phi_7163_ = _e2965;
                                                        phi_7164_ = _e2967;
                                                        phi_7165_ = _e2969;
                                                        phi_7166_ = _e2971;
                                                        phi_7167_ = _e2973;
                                                        phi_7168_ = false;
                                                    } else {
                                                        phi_7160_ = f64();
                                                        phi_7161_ = f64();
                                                        phi_7162_ = false;
                                                        phi_7163_ = false;
                                                        phi_7164_ = false;
                                                        phi_7165_ = false;
                                                        phi_7166_ = false;
                                                        phi_7167_ = false;
                                                        phi_7168_ = true;
                                                    }
                                                    let _e2975 = phi_7160_;
                                                    let _e2977 = phi_7161_;
                                                    let _e2979 = phi_7162_;
                                                    let _e2981 = phi_7163_;
                                                    let _e2983 = phi_7164_;
                                                    let _e2985 = phi_7165_;
                                                    let _e2987 = phi_7166_;
                                                    let _e2989 = phi_7167_;
                                                    let _e2991 = phi_7168_;
                                                    phi_7169_ = _e2975;
                                                    phi_6241_ = _e2977;
                                                    phi_7170_ = _e2979;
                                                    phi_7171_ = _e2981;
                                                    phi_7172_ = _e2983;
                                                    phi_7173_ = false;
                                                    phi_7174_ = _e2985;
                                                    phi_7175_ = _e2987;
                                                    phi_7176_ = _e2989;
                                                    phi_7177_ = _e2991;
                                                } else {
                                                    phi_7169_ = f64();
                                                    phi_6241_ = f64();
                                                    phi_7170_ = false;
                                                    phi_7171_ = false;
                                                    phi_7172_ = false;
                                                    phi_7173_ = true;
                                                    phi_7174_ = false;
                                                    phi_7175_ = false;
                                                    phi_7176_ = false;
                                                    phi_7177_ = false;
                                                }
                                                let _e2993 = phi_7169_;
                                                let _e2995 = phi_6241_;
                                                let _e2997 = phi_7170_;
                                                let _e2999 = phi_7171_;
                                                let _e3001 = phi_7172_;
                                                let _e3003 = phi_7173_;
                                                let _e3005 = phi_7174_;
                                                let _e3007 = phi_7175_;
                                                let _e3009 = phi_7176_;
                                                let _e3011 = phi_7177_;
                                                local_31 = _e2999;
                                                local_58 = _e3001;
                                                local_59 = _e3003;
                                                local_60 = _e3005;
                                                local_61 = _e3007;
                                                local_62 = _e3009;
                                                local_63 = _e3011;
                                                local_64 = _e2993;
                                                local_66 = _e2999;
                                                continue;
                                                continuing {
                                                    phi_6237_ = _e2410;
                                                    phi_6240_ = _e2995;
                                                    break if !(_e2997);
                                                }
                                            }
                                            let _e3014 = local_31;
                                            if _e3014 {
                                                phi_7182_ = type_73(0u, type_73().member_1);
                                                phi_7183_ = false;
                                                phi_7184_ = false;
                                                phi_7185_ = false;
                                                phi_7186_ = false;
                                                phi_7187_ = false;
                                                phi_7188_ = false;
                                            } else {
                                                phi_7182_ = type_73();
                                                let _e5266 = local_58;
                                                phi_7183_ = _e5266;
                                                let _e5269 = local_59;
                                                phi_7184_ = _e5269;
                                                let _e5272 = local_60;
                                                phi_7185_ = _e5272;
                                                let _e5275 = local_61;
                                                phi_7186_ = _e5275;
                                                let _e5278 = local_62;
                                                phi_7187_ = _e5278;
                                                let _e5281 = local_63;
                                                phi_7188_ = _e5281;
                                            }
                                            let _e3019 = phi_7182_;
                                            let _e3021 = phi_7183_;
                                            let _e3023 = phi_7184_;
                                            let _e3025 = phi_7185_;
                                            let _e3027 = phi_7186_;
                                            let _e3029 = phi_7187_;
                                            let _e3031 = phi_7188_;
                                            if _e3021 {
                                                let _e5284 = local_64;
                                                phi_7192_ = _e5284;
                                                phi_7193_ = true;
                                                phi_7194_ = false;
                                                phi_7195_ = false;
                                                phi_7196_ = false;
                                                phi_7197_ = false;
                                                phi_7198_ = false;
                                            } else {
                                                let _e5286 = local_65;
                                                phi_7192_ = _e5286;
                                                phi_7193_ = _e3023;
                                                phi_7194_ = _e3025;
                                                phi_7195_ = _e3027;
                                                let _e5292 = local_66;
                                                phi_7196_ = _e5292;
                                                phi_7197_ = _e3029;
                                                phi_7198_ = _e3031;
                                            }
                                            let _e3033 = phi_7192_;
                                            let _e3035 = phi_7193_;
                                            let _e3037 = phi_7194_;
                                            let _e3039 = phi_7195_;
                                            let _e3041 = phi_7196_;
                                            let _e3043 = phi_7197_;
                                            let _e3045 = phi_7198_;
                                            if _e3035 {
                                                phi_7203_ = type_73(1u, _e3033);
                                                phi_7204_ = false;
                                                phi_7205_ = false;
                                                phi_7206_ = false;
                                                phi_7207_ = false;
                                                phi_7208_ = false;
                                            } else {
                                                phi_7203_ = type_73();
                                                phi_7204_ = _e3037;
                                                phi_7205_ = _e3039;
                                                phi_7206_ = _e3041;
                                                phi_7207_ = _e3043;
                                                phi_7208_ = _e3045;
                                            }
                                            let _e3048 = phi_7203_;
                                            let _e3050 = phi_7204_;
                                            let _e3052 = phi_7205_;
                                            let _e3054 = phi_7206_;
                                            let _e3056 = phi_7207_;
                                            let _e3058 = phi_7208_;
                                            if _e3050 {
                                                let _e3060 = local_32;
                                                phi_7213_ = type_73(1u, _e3060);
                                                phi_7214_ = false;
                                                phi_7215_ = true;
                                                phi_7216_ = false;
                                                phi_7217_ = false;
                                            } else {
                                                phi_7213_ = _e3019;
                                                phi_7214_ = _e3052;
                                                phi_7215_ = _e3054;
                                                phi_7216_ = _e3056;
                                                phi_7217_ = _e3058;
                                            }
                                            let _e3063 = phi_7213_;
                                            let _e3065 = phi_7214_;
                                            let _e3067 = phi_7215_;
                                            let _e3069 = phi_7216_;
                                            let _e3071 = phi_7217_;
                                            if _e3065 {
                                                let _e3073 = local_33;
                                                phi_7222_ = type_73(1u, _e3073);
                                                phi_7223_ = true;
                                                phi_7224_ = false;
                                                phi_7225_ = false;
                                            } else {
                                                phi_7222_ = _e3063;
                                                phi_7223_ = _e3067;
                                                phi_7224_ = _e3069;
                                                phi_7225_ = _e3071;
                                            }
                                            let _e3076 = phi_7222_;
                                            let _e3078 = phi_7223_;
                                            let _e3080 = phi_7224_;
                                            let _e3082 = phi_7225_;
                                            if _e3078 {
                                                phi_7229_ = false;
                                                phi_7230_ = false;
                                            } else {
                                                phi_7229_ = _e3080;
                                                phi_7230_ = _e3082;
                                            }
                                            let _e3084 = phi_7229_;
                                            let _e3086 = phi_7230_;
                                            if _e3084 {
                                                phi_7234_ = false;
                                                phi_7235_ = false;
                                            } else {
                                                phi_7234_ = _e3086;
                                                phi_7235_ = _e3078;
                                            }
                                            let _e3088 = phi_7234_;
                                            let _e3090 = phi_7235_;
                                            if _e3088 {
                                                phi_7239_ = true;
                                                phi_7240_ = false;
                                            } else {
                                                phi_7239_ = _e3084;
                                                phi_7240_ = _e3090;
                                            }
                                            let _e3092 = phi_7239_;
                                            let _e3094 = phi_7240_;
                                            if _e3092 {
                                                let _e3096 = local_34;
                                                phi_7245_ = type_73(1u, _e3096);
                                                phi_7246_ = true;
                                            } else {
                                                phi_7245_ = _e3076;
                                                phi_7246_ = _e3094;
                                            }
                                            let _e3099 = phi_7245_;
                                            let _e3101 = phi_7246_;
                                            if _e3101 {
                                                phi_7250_ = _e3099;
                                            } else {
                                                phi_7250_ = _e3048;
                                            }
                                            let _e3103 = phi_7250_;
                                            let _e3106 = (_e3103.member != 0u);
                                            if _e3106 {
                                                phi_7257_ = false;
                                            } else {
                                                phi_7257_ = true;
                                            }
                                            let _e3108 = phi_7257_;
                                            phi_7258_ = _e3103.member_1;
                                            phi_7259_ = _e3108;
                                            phi_7260_ = _e3106;
                                            phi_7261_ = false;
                                        } else {
                                            phi_7258_ = f64();
                                            phi_7259_ = false;
                                            phi_7260_ = false;
                                            phi_7261_ = true;
                                        }
                                        let _e3110 = phi_7258_;
                                        let _e3112 = phi_7259_;
                                        let _e3114 = phi_7260_;
                                        let _e3116 = phi_7261_;
                                        phi_7262_ = _e3110;
                                        phi_7263_ = _e3112;
                                        phi_7264_ = _e3114;
                                        phi_7265_ = _e3116;
                                    }
                                    let _e3118 = phi_7262_;
                                    let _e3120 = phi_7263_;
                                    let _e3122 = phi_7264_;
                                    let _e3124 = phi_7265_;
                                    phi_7266_ = _e3118;
                                    phi_7267_ = _e2146;
                                    phi_7268_ = _e3120;
                                    phi_7269_ = _e3122;
                                    phi_7270_ = _e3124;
                                }
                                let _e3126 = phi_7266_;
                                let _e3128 = phi_7267_;
                                let _e3130 = phi_7268_;
                                let _e3132 = phi_7269_;
                                let _e3134 = phi_7270_;
                                if _e3128 {
                                    phi_7274_ = true;
                                    phi_7275_ = false;
                                    phi_7276_ = false;
                                } else {
                                    phi_7274_ = _e3130;
                                    phi_7275_ = _e3132;
                                    phi_7276_ = _e3134;
                                }
                                let _e3136 = phi_7274_;
                                let _e3138 = phi_7275_;
                                let _e3140 = phi_7276_;
                                phi_7277_ = _e3126;
                                phi_7278_ = _e1405;
                                phi_7279_ = _e3136;
                                phi_7280_ = false;
                                phi_7281_ = _e3138;
                                phi_7282_ = _e3140;
                            } else {
                                phi_7277_ = f64();
                                phi_7278_ = type_74();
                                phi_7279_ = false;
                                phi_7280_ = true;
                                phi_7281_ = false;
                                phi_7282_ = false;
                            }
                            let _e3142 = phi_7277_;
                            let _e3144 = phi_7278_;
                            let _e3146 = phi_7279_;
                            let _e3148 = phi_7280_;
                            let _e3150 = phi_7281_;
                            let _e3152 = phi_7282_;
                            local_35 = _e3148;
                            local_67 = _e3150;
                            local_68 = _e3152;
                            local_36 = _e3142;
                            local_37 = _e3144;
                            continue;
                            continuing {
                                phi_4276_ = _e1086;
                                break if !(_e3146);
                            }
                        }
                        let _e3155 = local_35;
                        if _e3155 {
                            phi_7287_ = type_73(0u, type_73().member_1);
                            phi_7288_ = false;
                            phi_7289_ = false;
                        } else {
                            phi_7287_ = type_73();
                            let _e5349 = local_67;
                            phi_7288_ = _e5349;
                            let _e5352 = local_68;
                            phi_7289_ = _e5352;
                        }
                        let _e3160 = phi_7287_;
                        let _e3162 = phi_7288_;
                        let _e3164 = phi_7289_;
                        if _e3162 {
                            let _e3166 = local_36;
                            phi_7294_ = type_73(2u, _e3166);
                            phi_7295_ = false;
                        } else {
                            phi_7294_ = type_73();
                            phi_7295_ = _e3164;
                        }
                        let _e3169 = phi_7294_;
                        let _e3171 = phi_7295_;
                        if _e3171 {
                            let _e3173 = local_37;
                            phi_7301_ = type_73(1u, _e3173.member);
                            phi_7302_ = true;
                        } else {
                            phi_7301_ = _e3169;
                            phi_7302_ = _e3162;
                        }
                        let _e3177 = phi_7301_;
                        let _e3179 = phi_7302_;
                        if _e3179 {
                            phi_7306_ = _e3177;
                        } else {
                            phi_7306_ = _e3160;
                        }
                        let _e3181 = phi_7306_;
                        phi_7310_ = _e3181;
                    }
                    let _e4754 = phi_7310_;
                    phi_7311_ = _e4754;
                }
                let _e4759 = phi_7311_;
                switch bitcast<i32>(_e4759.member) {
                    case 0: {
                        phi_7332_ = type_47(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4769 = bitcast<u64>(_e4759.member_1);
                        phi_7332_ = type_47(0u, array<u32, 2>(u32(_e4769), u32((_e4769 / 4294967296lu))), true);
                        break;
                    }
                    case 2: {
                        let _e4763 = bitcast<u64>(_e4759.member_1);
                        phi_7332_ = type_47(1u, array<u32, 2>(u32(_e4763), u32((_e4763 / 4294967296lu))), true);
                        break;
                    }
                    default: {
                        phi_7332_ = type_47();
                        break;
                    }
                }
                let _e4776 = phi_7332_;
                if _e4776.member_2 {
                    let _e4783 = (_e4776.member_1[1] >> bitcast<u32>(20i));
                    if (_e4783 <= 896u) {
                        phi_7355_ = 0u;
                    } else {
                        phi_7355_ = ((((_e4783 - 896u) << bitcast<u32>(23i)) | ((_e4776.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4776.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4798 = phi_7355_;
                    let _e4800 = atomicMin((&earliest.member[0u]), _e4798);
                }
                phi_7359_ = type_46(_e184, _e4776.member, _e190, _e193, _e4776.member_1);
                phi_7360_ = _e4776.member_2;
            } else {
                phi_7359_ = type_46(_e184, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_7360_ = false;
            }
            let _e4802 = phi_7359_;
            let _e4804 = phi_7360_;
            let _e4806 = params.member.member_1;
            if ((_e4806 & 16u) != 0u) {
                if (_e115 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4804 {
                    let _e4812 = atomicAdd((&counters[0u]), 1u);
                    phi_7378_ = _e4812;
                } else {
                    phi_7378_ = 0u;
                }
                let _e4814 = phi_7378_;
                workgroupBarrier();
                if (_e115 == 0u) {
                    let _e4817 = atomicLoad((&counters[0u]));
                    if (_e4817 > 0u) {
                        let _e4820 = atomicAdd((&contacts.member[0u]), _e4817);
                        atomicStore((&counters[1u]), _e4820);
                    }
                }
                workgroupBarrier();
                let _e4823 = atomicLoad((&counters[1u]));
                let _e4824 = (_e4823 + _e4814);
                if _e4804 {
                    let _e4826 = params.member.member_16;
                    if (_e4824 < _e4826) {
                        let _e4828 = (6u * _e4824);
                        atomicStore((&contacts.member[(4u + _e4828)]), _e4802.member);
                        atomicStore((&contacts.member[(_e4828 + 5u)]), _e4802.member_1);
                        atomicStore((&contacts.member[(_e4828 + 6u)]), _e4802.member_2);
                        atomicStore((&contacts.member[(_e4828 + 7u)]), _e4802.member_3);
                        atomicStore((&contacts.member[(_e4828 + 8u)]), _e4802.member_4[0]);
                        atomicStore((&contacts.member[(_e4828 + 9u)]), _e4802.member_4[1]);
                    }
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
