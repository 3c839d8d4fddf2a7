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
    var phi_228_: u32;
    var phi_244_: u32;
    var phi_265_: u32;
    var phi_266_: u32;
    var phi_269_: type_28;
    var phi_270_: type_28;
    var phi_293_: type_28;
    var phi_636_: type_28;
    var phi_637_: type_28;
    var phi_660_: type_28;
    var phi_516_: type_28;
    var phi_517_: type_28;
    var phi_540_: type_28;
    var phi_550_: type_28;
    var phi_551_: type_28;
    var phi_574_: type_28;
    var phi_1117_: f64;
    var phi_1124_: f64;
    var phi_1129_: f64;
    var phi_1136_: f64;
    var phi_1141_: f64;
    var phi_1154_: f64;
    var phi_1161_: f64;
    var phi_1166_: f64;
    var phi_1173_: f64;
    var phi_1178_: f64;
    var phi_1183_: f64;
    var phi_1200_: f64;
    var phi_1207_: f64;
    var phi_1212_: f64;
    var phi_1219_: f64;
    var phi_1224_: f64;
    var phi_1238_: f64;
    var phi_1245_: f64;
    var phi_1250_: f64;
    var phi_1257_: f64;
    var phi_1262_: f64;
    var phi_1267_: f64;
    var phi_1284_: f64;
    var phi_1291_: f64;
    var phi_1296_: f64;
    var phi_1303_: f64;
    var phi_1308_: f64;
    var phi_1322_: f64;
    var phi_1329_: f64;
    var phi_1334_: f64;
    var phi_1341_: f64;
    var phi_1346_: f64;
    var phi_1351_: f64;
    var phi_1388_: f64;
    var phi_1394_: f64;
    var phi_1401_: f64;
    var phi_1408_: f64;
    var phi_1414_: f64;
    var phi_1421_: f64;
    var phi_1427_: f64;
    var phi_1433_: f64;
    var phi_1439_: f64;
    var phi_1446_: f64;
    var phi_1453_: f64;
    var phi_1481_: f64;
    var phi_1486_: f64;
    var phi_1491_: f64;
    var phi_1496_: f64;
    var phi_1501_: f64;
    var phi_1506_: f64;
    var phi_1517_: f64;
    var phi_4029_: f64;
    var phi_4035_: f64;
    var phi_4040_: f64;
    var phi_4046_: f64;
    var phi_4052_: f64;
    var phi_4057_: f64;
    var phi_4062_: f64;
    var phi_4106_: type_26;
    var phi_4109_: f64;
    var phi_4130_: bool;
    var phi_4136_: type_27;
    var phi_4107_: type_26;
    var phi_4150_: type_27;
    var phi_4110_: f64;
    var local_21: f64;
    var phi_4099_: f64;
    var phi_4163_: f64;
    var phi_4169_: f64;
    var phi_4194_: type_28;
    var phi_4197_: u32;
    var phi_4195_: type_28;
    var phi_4220_: type_28;
    var phi_4264_: u32;
    var phi_4265_: u32;
    var phi_4198_: u32;
    var phi_4266_: u32;
    var phi_4286_: type_28;
    var phi_4287_: type_28;
    var phi_4310_: type_28;
    var phi_4364_: f64;
    var phi_4371_: f64;
    var phi_4383_: bool;
    var phi_4384_: bool;
    var phi_4385_: bool;
    var phi_4386_: bool;
    var phi_4390_: bool;
    var phi_4402_: type_73;
    var phi_4403_: type_73;
    var phi_4404_: bool;
    var phi_4405_: type_73;
    var phi_4406_: bool;
    var phi_4419_: f64;
    var phi_4432_: type_28;
    var phi_4435_: f64;
    var phi_4437_: f64;
    var phi_4439_: f64;
    var phi_4433_: type_28;
    var phi_4462_: type_28;
    var phi_4489_: f64;
    var phi_4490_: f64;
    var phi_4518_: f64;
    var phi_4534_: f64;
    var phi_4541_: bool;
    var phi_4542_: bool;
    var phi_4543_: bool;
    var phi_4549_: f64;
    var phi_4550_: f64;
    var phi_4551_: bool;
    var phi_4436_: f64;
    var phi_4438_: f64;
    var phi_4440_: f64;
    var phi_4552_: f64;
    var phi_4553_: bool;
    var phi_4554_: bool;
    var local_22: bool;
    var phi_4558_: f64;
    var phi_4559_: f64;
    var phi_4567_: type_28;
    var phi_4570_: f64;
    var phi_4568_: type_28;
    var phi_4593_: type_28;
    var phi_4636_: f64;
    var phi_4646_: f64;
    var phi_4656_: bool;
    var phi_4658_: bool;
    var phi_4663_: f64;
    var phi_4664_: bool;
    var phi_4665_: f64;
    var phi_4666_: bool;
    var phi_4667_: bool;
    var phi_4668_: bool;
    var phi_4669_: f64;
    var phi_4571_: f64;
    var phi_4670_: bool;
    var phi_4671_: bool;
    var phi_4672_: bool;
    var phi_4673_: bool;
    var local_23: bool;
    var phi_4677_: bool;
    var phi_4678_: bool;
    var phi_4682_: bool;
    var phi_4686_: f64;
    var phi_4687_: f64;
    var phi_4689_: type_73;
    var phi_4720_: f64;
    var phi_4727_: f64;
    var phi_4732_: f64;
    var phi_4739_: f64;
    var phi_4744_: f64;
    var phi_4757_: f64;
    var phi_4764_: f64;
    var phi_4769_: f64;
    var phi_4776_: f64;
    var phi_4781_: f64;
    var phi_4786_: f64;
    var phi_4845_: f64;
    var phi_4851_: f64;
    var phi_4856_: f64;
    var phi_4862_: f64;
    var phi_4867_: f64;
    var phi_4881_: f64;
    var phi_4887_: f64;
    var phi_4892_: f64;
    var phi_4898_: f64;
    var phi_4903_: f64;
    var phi_4929_: f64;
    var phi_4936_: f64;
    var phi_4941_: f64;
    var phi_4948_: f64;
    var phi_4953_: f64;
    var phi_4966_: f64;
    var phi_4973_: f64;
    var phi_4978_: f64;
    var phi_4985_: f64;
    var phi_4990_: f64;
    var phi_4995_: f64;
    var phi_5054_: f64;
    var phi_5060_: f64;
    var phi_5065_: f64;
    var phi_5071_: f64;
    var phi_5076_: f64;
    var phi_5090_: f64;
    var phi_5096_: f64;
    var phi_5101_: f64;
    var phi_5107_: f64;
    var phi_5112_: f64;
    var phi_5138_: f64;
    var phi_5145_: f64;
    var phi_5150_: f64;
    var phi_5157_: f64;
    var phi_5162_: f64;
    var phi_5175_: f64;
    var phi_5182_: f64;
    var phi_5187_: f64;
    var phi_5194_: f64;
    var phi_5199_: f64;
    var phi_5204_: f64;
    var phi_5263_: f64;
    var phi_5269_: f64;
    var phi_5274_: f64;
    var phi_5280_: f64;
    var phi_5285_: f64;
    var phi_5299_: f64;
    var phi_5305_: f64;
    var phi_5310_: f64;
    var phi_5316_: f64;
    var phi_5321_: f64;
    var phi_5370_: f64;
    var phi_5376_: f64;
    var phi_5404_: f64;
    var phi_5410_: f64;
    var phi_5415_: u32;
    var phi_5416_: u32;
    var phi_5386_: f64;
    var phi_5392_: f64;
    var phi_5397_: u32;
    var phi_5398_: u32;
    var phi_5417_: u32;
    var phi_5418_: u32;
    var phi_5489_: f64;
    var phi_5501_: f64;
    var phi_5640_: f64;
    var phi_5646_: f64;
    var phi_5653_: f64;
    var phi_5697_: type_28;
    var phi_5700_: bool;
    var phi_5698_: type_28;
    var phi_5723_: type_28;
    var phi_5750_: bool;
    var phi_5751_: bool;
    var phi_5701_: bool;
    var phi_5752_: bool;
    var phi_5753_: bool;
    var local_24: bool;
    var phi_5757_: bool;
    var local_25: bool;
    var phi_5764_: u32;
    var phi_5765_: u32;
    var phi_5766_: bool;
    var phi_5767_: u32;
    var phi_5768_: u32;
    var phi_5769_: bool;
    var phi_5773_: u32;
    var phi_5794_: bool;
    var phi_5795_: bool;
    var phi_5796_: bool;
    var phi_5993_: f64;
    var phi_6000_: f64;
    var phi_6005_: f64;
    var phi_6012_: f64;
    var phi_6017_: f64;
    var phi_6030_: f64;
    var phi_6037_: f64;
    var phi_6042_: f64;
    var phi_6049_: f64;
    var phi_6054_: f64;
    var phi_6059_: f64;
    var phi_6076_: f64;
    var phi_6083_: f64;
    var phi_6088_: f64;
    var phi_6095_: f64;
    var phi_6100_: f64;
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
    var phi_6247_: type_28;
    var phi_6250_: f64;
    var phi_6248_: type_28;
    var phi_6273_: type_28;
    var phi_6429_: bool;
    var phi_6430_: bool;
    var phi_6431_: bool;
    var phi_6432_: bool;
    var phi_6433_: bool;
    var phi_6434_: bool;
    var phi_6438_: bool;
    var phi_6478_: array<f64, 3>;
    var phi_6479_: bool;
    var phi_6480_: array<f64, 3>;
    var phi_6481_: bool;
    var phi_6514_: f64;
    var phi_6516_: f64;
    var phi_6546_: f64;
    var phi_6548_: f64;
    var phi_6578_: f64;
    var phi_6580_: f64;
    var phi_6613_: f64;
    var phi_6615_: f64;
    var phi_6770_: type_28;
    var phi_6773_: array<f64, 3>;
    var phi_6771_: type_28;
    var phi_6796_: type_28;
    var phi_6863_: array<f64, 3>;
    var phi_6774_: array<f64, 3>;
    var phi_6864_: array<f64, 3>;
    var phi_6871_: f64;
    var phi_6878_: f64;
    var phi_6886_: f64;
    var phi_6931_: type_26;
    var phi_6934_: f64;
    var phi_6955_: bool;
    var phi_6961_: type_27;
    var phi_6932_: type_26;
    var phi_6975_: type_27;
    var phi_6935_: f64;
    var local_26: f64;
    var phi_6924_: f64;
    var phi_6988_: f64;
    var phi_7001_: type_28;
    var phi_7004_: f64;
    var phi_7002_: type_28;
    var phi_7027_: type_28;
    var phi_7078_: f64;
    var phi_7084_: f64;
    var phi_7098_: bool;
    var phi_7099_: bool;
    var phi_7126_: f64;
    var phi_7127_: f64;
    var phi_7128_: f64;
    var phi_7129_: f64;
    var phi_7130_: bool;
    var phi_7005_: f64;
    var phi_7131_: bool;
    var phi_7132_: bool;
    var local_27: bool;
    var local_28: f64;
    var local_29: f64;
    var local_30: f64;
    var phi_7150_: bool;
    var phi_7151_: bool;
    var phi_7152_: bool;
    var phi_7153_: bool;
    var phi_7154_: bool;
    var phi_7155_: bool;
    var phi_7156_: bool;
    var phi_7157_: bool;
    var phi_7158_: bool;
    var phi_7159_: bool;
    var phi_7160_: bool;
    var phi_7161_: bool;
    var phi_7162_: f64;
    var phi_7163_: f64;
    var phi_7164_: bool;
    var phi_7165_: bool;
    var phi_7166_: bool;
    var phi_7167_: bool;
    var phi_7168_: bool;
    var phi_7169_: bool;
    var phi_7170_: f64;
    var phi_7171_: f64;
    var phi_7172_: bool;
    var phi_7173_: bool;
    var phi_7174_: bool;
    var phi_7175_: bool;
    var phi_7176_: bool;
    var phi_7177_: bool;
    var phi_7178_: bool;
    var phi_7179_: f64;
    var phi_6251_: f64;
    var phi_7180_: bool;
    var phi_7181_: bool;
    var phi_7182_: bool;
    var phi_7183_: bool;
    var phi_7184_: bool;
    var phi_7185_: bool;
    var phi_7186_: bool;
    var phi_7187_: bool;
    var local_31: bool;
    var phi_7192_: type_72;
    var phi_7193_: bool;
    var phi_7194_: bool;
    var phi_7195_: bool;
    var phi_7196_: bool;
    var phi_7197_: bool;
    var phi_7198_: bool;
    var phi_7202_: f64;
    var phi_7203_: bool;
    var phi_7204_: bool;
    var phi_7205_: bool;
    var phi_7206_: bool;
    var phi_7207_: bool;
    var phi_7208_: bool;
    var phi_7213_: type_72;
    var phi_7214_: bool;
    var phi_7215_: bool;
    var phi_7216_: bool;
    var phi_7217_: bool;
    var phi_7218_: bool;
    var local_32: f64;
    var phi_7223_: type_72;
    var phi_7224_: bool;
    var phi_7225_: bool;
    var phi_7226_: bool;
    var phi_7227_: bool;
    var local_33: f64;
    var phi_7232_: type_72;
    var phi_7233_: bool;
    var phi_7234_: bool;
    var phi_7235_: bool;
    var phi_7239_: bool;
    var phi_7240_: bool;
    var phi_7244_: bool;
    var phi_7245_: bool;
    var phi_7249_: bool;
    var phi_7250_: bool;
    var local_34: f64;
    var phi_7255_: type_72;
    var phi_7256_: bool;
    var phi_7260_: type_72;
    var phi_7267_: bool;
    var phi_7268_: f64;
    var phi_7269_: bool;
    var phi_7270_: bool;
    var phi_7271_: bool;
    var phi_7272_: f64;
    var phi_7273_: bool;
    var phi_7274_: bool;
    var phi_7275_: bool;
    var phi_7276_: f64;
    var phi_7277_: bool;
    var phi_7278_: bool;
    var phi_7279_: bool;
    var phi_7280_: bool;
    var phi_7284_: bool;
    var phi_7285_: bool;
    var phi_7286_: bool;
    var phi_7287_: f64;
    var phi_7288_: type_73;
    var phi_7289_: bool;
    var phi_7290_: bool;
    var phi_7291_: bool;
    var phi_7292_: bool;
    var local_35: bool;
    var phi_7297_: type_72;
    var phi_7298_: bool;
    var phi_7299_: bool;
    var local_36: f64;
    var phi_7304_: type_72;
    var phi_7305_: bool;
    var local_37: type_73;
    var phi_7311_: type_72;
    var phi_7312_: bool;
    var phi_7316_: type_72;
    var phi_1720_: f64;
    var phi_1727_: f64;
    var phi_1732_: f64;
    var phi_1739_: f64;
    var phi_1744_: f64;
    var phi_1757_: f64;
    var phi_1764_: f64;
    var phi_1769_: f64;
    var phi_1776_: f64;
    var phi_1781_: f64;
    var phi_1786_: f64;
    var phi_1803_: f64;
    var phi_1810_: f64;
    var phi_1815_: f64;
    var phi_1822_: f64;
    var phi_1827_: f64;
    var phi_1841_: f64;
    var phi_1848_: f64;
    var phi_1853_: f64;
    var phi_1860_: f64;
    var phi_1865_: f64;
    var phi_1870_: f64;
    var phi_1887_: f64;
    var phi_1894_: f64;
    var phi_1899_: f64;
    var phi_1906_: f64;
    var phi_1911_: f64;
    var phi_1925_: f64;
    var phi_1932_: f64;
    var phi_1937_: f64;
    var phi_1944_: f64;
    var phi_1949_: f64;
    var phi_1954_: f64;
    var phi_1974_: type_28;
    var phi_1977_: f64;
    var phi_1975_: type_28;
    var phi_2000_: type_28;
    var phi_2156_: bool;
    var phi_2157_: bool;
    var phi_2158_: bool;
    var phi_2159_: bool;
    var phi_2160_: bool;
    var phi_2161_: bool;
    var phi_2165_: bool;
    var phi_2205_: array<f64, 3>;
    var phi_2206_: bool;
    var phi_2207_: array<f64, 3>;
    var phi_2208_: bool;
    var phi_2241_: f64;
    var phi_2243_: f64;
    var phi_2273_: f64;
    var phi_2275_: f64;
    var phi_2305_: f64;
    var phi_2307_: f64;
    var phi_2340_: f64;
    var phi_2342_: f64;
    var phi_2497_: type_28;
    var phi_2500_: array<f64, 3>;
    var phi_2498_: type_28;
    var phi_2523_: type_28;
    var phi_2590_: array<f64, 3>;
    var phi_2501_: array<f64, 3>;
    var phi_2591_: array<f64, 3>;
    var phi_2598_: f64;
    var phi_2605_: f64;
    var phi_2613_: f64;
    var phi_2658_: type_26;
    var phi_2661_: f64;
    var phi_2682_: bool;
    var phi_2688_: type_27;
    var phi_2659_: type_26;
    var phi_2702_: type_27;
    var phi_2662_: f64;
    var local_38: f64;
    var phi_2651_: f64;
    var phi_2715_: f64;
    var phi_2728_: type_28;
    var phi_2731_: f64;
    var phi_2729_: type_28;
    var phi_2754_: type_28;
    var phi_2805_: f64;
    var phi_2811_: f64;
    var phi_2825_: bool;
    var phi_2826_: bool;
    var phi_2853_: f64;
    var phi_2854_: f64;
    var phi_2855_: f64;
    var phi_2856_: f64;
    var phi_2857_: bool;
    var phi_2732_: f64;
    var phi_2858_: bool;
    var phi_2859_: bool;
    var local_39: bool;
    var local_40: f64;
    var local_41: f64;
    var local_42: f64;
    var phi_2877_: bool;
    var phi_2878_: bool;
    var phi_2879_: bool;
    var phi_2880_: bool;
    var phi_2881_: bool;
    var phi_2882_: bool;
    var phi_2883_: bool;
    var phi_2884_: bool;
    var phi_2885_: bool;
    var phi_2886_: bool;
    var phi_2887_: bool;
    var phi_2888_: bool;
    var phi_2889_: f64;
    var phi_2890_: f64;
    var phi_2891_: bool;
    var phi_2892_: bool;
    var phi_2893_: bool;
    var phi_2894_: bool;
    var phi_2895_: bool;
    var phi_2896_: bool;
    var phi_2897_: f64;
    var phi_2898_: f64;
    var phi_2899_: bool;
    var phi_2900_: bool;
    var phi_2901_: bool;
    var phi_2902_: bool;
    var phi_2903_: bool;
    var phi_2904_: bool;
    var phi_2905_: bool;
    var phi_2906_: f64;
    var phi_1978_: f64;
    var phi_2907_: bool;
    var phi_2908_: bool;
    var phi_2909_: bool;
    var phi_2910_: bool;
    var phi_2911_: bool;
    var phi_2912_: bool;
    var phi_2913_: bool;
    var phi_2914_: bool;
    var local_43: bool;
    var phi_2919_: type_72;
    var phi_2920_: bool;
    var phi_2921_: bool;
    var phi_2922_: bool;
    var phi_2923_: bool;
    var phi_2924_: bool;
    var phi_2925_: bool;
    var phi_2929_: f64;
    var phi_2930_: bool;
    var phi_2931_: bool;
    var phi_2932_: bool;
    var phi_2933_: bool;
    var phi_2934_: bool;
    var phi_2935_: bool;
    var phi_2940_: type_72;
    var phi_2941_: bool;
    var phi_2942_: bool;
    var phi_2943_: bool;
    var phi_2944_: bool;
    var phi_2945_: bool;
    var local_44: f64;
    var phi_2950_: type_72;
    var phi_2951_: bool;
    var phi_2952_: bool;
    var phi_2953_: bool;
    var phi_2954_: bool;
    var local_45: f64;
    var phi_2959_: type_72;
    var phi_2960_: bool;
    var phi_2961_: bool;
    var phi_2962_: bool;
    var phi_2966_: bool;
    var phi_2967_: bool;
    var phi_2971_: bool;
    var phi_2972_: bool;
    var phi_2976_: bool;
    var phi_2977_: bool;
    var local_46: f64;
    var phi_2982_: type_72;
    var phi_2983_: bool;
    var phi_2987_: type_72;
    var phi_3001_: type_28;
    var phi_3002_: type_28;
    var phi_3025_: type_28;
    var phi_3046_: f64;
    var phi_3196_: bool;
    var phi_3197_: bool;
    var phi_3198_: bool;
    var phi_3199_: bool;
    var phi_3200_: bool;
    var phi_3201_: bool;
    var phi_3205_: bool;
    var phi_3245_: array<f64, 3>;
    var phi_3246_: bool;
    var phi_3247_: array<f64, 3>;
    var phi_3248_: bool;
    var phi_3281_: f64;
    var phi_3283_: f64;
    var phi_3313_: f64;
    var phi_3315_: f64;
    var phi_3345_: f64;
    var phi_3347_: f64;
    var phi_3380_: f64;
    var phi_3382_: f64;
    var phi_3537_: type_28;
    var phi_3540_: array<f64, 3>;
    var phi_3538_: type_28;
    var phi_3563_: type_28;
    var phi_3630_: array<f64, 3>;
    var phi_3541_: array<f64, 3>;
    var phi_3631_: array<f64, 3>;
    var phi_3663_: type_26;
    var phi_3666_: f64;
    var phi_3687_: bool;
    var phi_3693_: type_27;
    var phi_3664_: type_26;
    var phi_3707_: type_27;
    var phi_3667_: f64;
    var local_47: f64;
    var phi_3656_: f64;
    var phi_3720_: f64;
    var phi_3738_: f64;
    var phi_3745_: f64;
    var phi_3750_: f64;
    var phi_3757_: f64;
    var phi_3762_: f64;
    var phi_3775_: f64;
    var phi_3782_: f64;
    var phi_3787_: f64;
    var phi_3794_: f64;
    var phi_3799_: f64;
    var phi_3804_: f64;
    var phi_3821_: f64;
    var phi_3828_: f64;
    var phi_3833_: f64;
    var phi_3840_: f64;
    var phi_3845_: f64;
    var phi_3859_: f64;
    var phi_3866_: f64;
    var phi_3871_: f64;
    var phi_3878_: f64;
    var phi_3883_: f64;
    var phi_3888_: f64;
    var phi_3905_: f64;
    var phi_3912_: f64;
    var phi_3917_: f64;
    var phi_3924_: f64;
    var phi_3929_: f64;
    var phi_3943_: f64;
    var phi_3950_: f64;
    var phi_3955_: f64;
    var phi_3962_: f64;
    var phi_3967_: f64;
    var phi_3972_: f64;
    var phi_3996_: bool;
    var phi_3997_: bool;
    var phi_3998_: bool;
    var local_48: bool;
    var phi_4003_: type_72;
    var phi_4004_: bool;
    var phi_4009_: type_72;
    var phi_4010_: bool;
    var phi_4012_: type_72;
    var phi_4013_: type_72;
    var phi_4014_: bool;
    var phi_4018_: type_72;
    var phi_7320_: type_72;
    var phi_7321_: type_72;
    var phi_7342_: type_46;
    var phi_7365_: u32;
    var phi_7369_: type_45;
    var phi_7370_: bool;
    var phi_7388_: u32;
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
                let _e187 = (2u * _e182);
                let _e190 = input.member[(4u + _e187)];
                let _e193 = input.member[(_e187 + 5u)];
                let _e195 = elements.member[_e190];
                let _e197 = elements.member[_e193];
                local_15 = array<u32, 4>(_e195[0], _e195[1], _e197[0], _e197[1]);
                local_16[0u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[1u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[2u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_16[3u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[0u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[1u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[2u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                local_17[3u] = array<f64, 3>(0.0lf, 0.0lf, 0.0lf);
                let _e212 = params.member.member_1;
                if ((_e212 & 8u) != 0u) {
                    let _e258 = paths.member[_e195[0]];
                    let _e260 = paths.member[_e195[1]];
                    let _e266 = paths.member[_e197[0]];
                    let _e268 = paths.member[_e197[1]];
                    local_18 = array<array<f32, 3>, 4>(array<f32, 3>(_e258.member[0], _e258.member[1], _e258.member[2]), array<f32, 3>(_e260.member[0], _e260.member[1], _e260.member[2]), array<f32, 3>(_e266.member[0], _e266.member[1], _e266.member[2]), array<f32, 3>(_e268.member[0], _e268.member[1], _e268.member[2]));
                    local_19 = array<array<f32, 3>, 4>(array<f32, 3>(_e258.member_1[0], _e258.member_1[1], _e258.member_1[2]), array<f32, 3>(_e260.member_1[0], _e260.member_1[1], _e260.member_1[2]), array<f32, 3>(_e266.member_1[0], _e266.member_1[1], _e266.member_1[2]), array<f32, 3>(_e268.member_1[0], _e268.member_1[1], _e268.member_1[2]));
                    phi_516_ = type_28(0u, 4u);
                    loop {
                        let _e308 = phi_516_;
                        if (_e308.member < _e308.member_1) {
                            phi_517_ = type_28((_e308.member + 1u), _e308.member_1);
                            phi_540_ = type_28(1u, _e308.member);
                        } else {
                            phi_517_ = _e308;
                            phi_540_ = type_28(0u, type_28().member_1);
                        }
                        let _e322 = phi_517_;
                        let _e324 = phi_540_;
                        let _e328 = (bitcast<i32>(_e324.member) != 0i);
                        if _e328 {
                            phi_550_ = type_28(0u, 3u);
                            loop {
                                let _e330 = phi_550_;
                                if (_e330.member < _e330.member_1) {
                                    phi_551_ = type_28((_e330.member + 1u), _e330.member_1);
                                    phi_574_ = type_28(1u, _e330.member);
                                } else {
                                    phi_551_ = _e330;
                                    phi_574_ = type_28(0u, type_28().member_1);
                                }
                                let _e344 = phi_551_;
                                let _e346 = phi_574_;
                                let _e350 = (bitcast<i32>(_e346.member) != 0i);
                                if _e350 {
                                    if (_e324.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e346.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e355 = local_18[_e324.member_1][_e346.member_1];
                                    if (_e324.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e346.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    local_16[_e324.member_1][_e346.member_1] = f64(_e355);
                                    if (_e324.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e346.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e365 = local_19[_e324.member_1][_e346.member_1];
                                    if (_e324.member_1 < 4u) {
                                    } else {
                                        return;
                                    }
                                    if (_e346.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    local_17[_e324.member_1][_e346.member_1] = f64(_e365);
                                }
                                continue;
                                continuing {
                                    phi_550_ = _e344;
                                    break if !(_e350);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_516_ = _e322;
                            break if !(_e328);
                        }
                    }
                } else {
                    phi_636_ = type_28(0u, 4u);
                    loop {
                        let _e216 = phi_636_;
                        if (_e216.member < _e216.member_1) {
                            phi_637_ = type_28((_e216.member + 1u), _e216.member_1);
                            phi_660_ = type_28(1u, _e216.member);
                        } else {
                            phi_637_ = _e216;
                            phi_660_ = type_28(0u, type_28().member_1);
                        }
                        let _e230 = phi_637_;
                        let _e232 = phi_660_;
                        let _e236 = (bitcast<i32>(_e232.member) != 0i);
                        if _e236 {
                            if (_e232.member_1 < 4u) {
                            } else {
                                return;
                            }
                            let _e239 = local_15[_e232.member_1];
                            let _e241 = wide.member[_e239];
                            if (_e232.member_1 < 4u) {
                            } else {
                                return;
                            }
                            local_16[_e232.member_1] = array<f64, 3>(_e241.member[0], _e241.member[1], _e241.member[2]);
                            if (_e232.member_1 < 4u) {
                            } else {
                                return;
                            }
                            local_17[_e232.member_1] = array<f64, 3>(_e241.member_1[0], _e241.member_1[1], _e241.member_1[2]);
                        }
                        continue;
                        continuing {
                            phi_636_ = _e230;
                            break if !(_e236);
                        }
                    }
                }
                let _e373 = local_16;
                let _e390 = local_17;
                local_20 = type_61(array<array<f64, 3>, 2>(array<f64, 3>((_e373[2][0] - _e373[0][0]), (_e373[2][1] - _e373[0][1]), (_e373[2][2] - _e373[0][2])), array<f64, 3>((_e390[2][0] - _e390[0][0]), (_e390[2][1] - _e390[0][1]), (_e390[2][2] - _e390[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e373[1][0] - _e373[0][0]), (_e373[1][1] - _e373[0][1]), (_e373[1][2] - _e373[0][2])), array<f64, 3>((_e390[1][0] - _e390[0][0]), (_e390[1][1] - _e390[0][1]), (_e390[1][2] - _e390[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e373[2][0] - _e373[3][0]), (_e373[2][1] - _e373[3][1]), (_e373[2][2] - _e373[3][2])), array<f64, 3>((_e390[2][0] - _e390[3][0]), (_e390[2][1] - _e390[3][1]), (_e390[2][2] - _e390[3][2]))), (0.0lf + 0.0lf));
                let _e437 = params.member.member_7;
                let _e444 = bitcast<f64>(((u64(_e437[1]) * 4294967296lu) + u64(_e437[0])));
                let _e445 = f64(0f);
                let _e448 = local_20.member_1[0u];
                let _e454 = local_20.member_2[0u];
                let _e460 = ((_e448[1] * _e454[2]) - (_e448[2] * _e454[1]));
                let _e463 = ((_e448[2] * _e454[0]) - (_e448[0] * _e454[2]));
                let _e466 = ((_e448[0] * _e454[1]) - (_e448[1] * _e454[0]));
                let _e469 = local_20.member_1[1u];
                let _e475 = local_20.member_2[1u];
                let _e481 = ((_e469[1] * _e475[2]) - (_e469[2] * _e475[1]));
                let _e484 = ((_e469[2] * _e475[0]) - (_e469[0] * _e475[2]));
                let _e487 = ((_e469[0] * _e475[1]) - (_e469[1] * _e475[0]));
                let _e490 = local_20.member_1[0u];
                let _e496 = local_20.member_2[1u];
                let _e511 = local_20.member_1[1u];
                let _e517 = local_20.member_2[0u];
                let _e530 = (((_e490[1] * _e496[2]) - (_e490[2] * _e496[1])) + ((_e511[1] * _e517[2]) - (_e511[2] * _e517[1])));
                let _e531 = (((_e490[2] * _e496[0]) - (_e490[0] * _e496[2])) + ((_e511[2] * _e517[0]) - (_e511[0] * _e517[2])));
                let _e532 = (((_e490[0] * _e496[1]) - (_e490[1] * _e496[0])) + ((_e511[0] * _e517[1]) - (_e511[1] * _e517[0])));
                let _e535 = local_20.member[0u];
                let _e543 = (((_e535[0] * _e460) + (_e535[1] * _e463)) + (_e535[2] * _e466));
                let _e546 = local_20.member[1u];
                let _e557 = local_20.member[0u];
                let _e566 = ((((_e546[0] * _e460) + (_e546[1] * _e463)) + (_e546[2] * _e466)) + (((_e557[0] * _e530) + (_e557[1] * _e531)) + (_e557[2] * _e532)));
                let _e569 = local_20.member[0u];
                let _e580 = local_20.member[1u];
                let _e589 = ((((_e569[0] * _e481) + (_e569[1] * _e484)) + (_e569[2] * _e487)) + (((_e580[0] * _e530) + (_e580[1] * _e531)) + (_e580[2] * _e532)));
                let _e592 = local_20.member[1u];
                let _e600 = (((_e592[0] * _e481) + (_e592[1] * _e484)) + (_e592[2] * _e487));
                let _e603 = local_20.member[0u];
                if (_e603[0] < 0.0lf) {
                    phi_1117_ = -(_e603[0]);
                } else {
                    phi_1117_ = _e603[0];
                }
                let _e610 = phi_1117_;
                if (_e603[1] < 0.0lf) {
                    phi_1124_ = -(_e603[1]);
                } else {
                    phi_1124_ = _e603[1];
                }
                let _e614 = phi_1124_;
                if (_e610 > _e614) {
                    phi_1129_ = _e610;
                } else {
                    phi_1129_ = _e614;
                }
                let _e617 = phi_1129_;
                if (_e603[2] < 0.0lf) {
                    phi_1136_ = -(_e603[2]);
                } else {
                    phi_1136_ = _e603[2];
                }
                let _e621 = phi_1136_;
                if (_e617 > _e621) {
                    phi_1141_ = _e617;
                } else {
                    phi_1141_ = _e621;
                }
                let _e624 = phi_1141_;
                let _e627 = local_20.member[1u];
                if (_e627[0] < 0.0lf) {
                    phi_1154_ = -(_e627[0]);
                } else {
                    phi_1154_ = _e627[0];
                }
                let _e634 = phi_1154_;
                if (_e627[1] < 0.0lf) {
                    phi_1161_ = -(_e627[1]);
                } else {
                    phi_1161_ = _e627[1];
                }
                let _e638 = phi_1161_;
                if (_e634 > _e638) {
                    phi_1166_ = _e634;
                } else {
                    phi_1166_ = _e638;
                }
                let _e641 = phi_1166_;
                if (_e627[2] < 0.0lf) {
                    phi_1173_ = -(_e627[2]);
                } else {
                    phi_1173_ = _e627[2];
                }
                let _e645 = phi_1173_;
                if (_e641 > _e645) {
                    phi_1178_ = _e641;
                } else {
                    phi_1178_ = _e645;
                }
                let _e648 = phi_1178_;
                if (_e624 > _e648) {
                    phi_1183_ = _e624;
                } else {
                    phi_1183_ = _e648;
                }
                let _e651 = phi_1183_;
                let _e653 = local_20.member_3;
                let _e654 = (_e651 + _e653);
                let _e657 = local_20.member_1[0u];
                if (_e657[0] < 0.0lf) {
                    phi_1200_ = -(_e657[0]);
                } else {
                    phi_1200_ = _e657[0];
                }
                let _e664 = phi_1200_;
                if (_e657[1] < 0.0lf) {
                    phi_1207_ = -(_e657[1]);
                } else {
                    phi_1207_ = _e657[1];
                }
                let _e668 = phi_1207_;
                if (_e664 > _e668) {
                    phi_1212_ = _e664;
                } else {
                    phi_1212_ = _e668;
                }
                let _e671 = phi_1212_;
                if (_e657[2] < 0.0lf) {
                    phi_1219_ = -(_e657[2]);
                } else {
                    phi_1219_ = _e657[2];
                }
                let _e675 = phi_1219_;
                if (_e671 > _e675) {
                    phi_1224_ = _e671;
                } else {
                    phi_1224_ = _e675;
                }
                let _e678 = phi_1224_;
                let _e681 = local_20.member_1[1u];
                if (_e681[0] < 0.0lf) {
                    phi_1238_ = -(_e681[0]);
                } else {
                    phi_1238_ = _e681[0];
                }
                let _e688 = phi_1238_;
                if (_e681[1] < 0.0lf) {
                    phi_1245_ = -(_e681[1]);
                } else {
                    phi_1245_ = _e681[1];
                }
                let _e692 = phi_1245_;
                if (_e688 > _e692) {
                    phi_1250_ = _e688;
                } else {
                    phi_1250_ = _e692;
                }
                let _e695 = phi_1250_;
                if (_e681[2] < 0.0lf) {
                    phi_1257_ = -(_e681[2]);
                } else {
                    phi_1257_ = _e681[2];
                }
                let _e699 = phi_1257_;
                if (_e695 > _e699) {
                    phi_1262_ = _e695;
                } else {
                    phi_1262_ = _e699;
                }
                let _e702 = phi_1262_;
                if (_e678 > _e702) {
                    phi_1267_ = _e678;
                } else {
                    phi_1267_ = _e702;
                }
                let _e705 = phi_1267_;
                let _e707 = local_20.member_3;
                let _e708 = (_e705 + _e707);
                let _e711 = local_20.member_2[0u];
                if (_e711[0] < 0.0lf) {
                    phi_1284_ = -(_e711[0]);
                } else {
                    phi_1284_ = _e711[0];
                }
                let _e718 = phi_1284_;
                if (_e711[1] < 0.0lf) {
                    phi_1291_ = -(_e711[1]);
                } else {
                    phi_1291_ = _e711[1];
                }
                let _e722 = phi_1291_;
                if (_e718 > _e722) {
                    phi_1296_ = _e718;
                } else {
                    phi_1296_ = _e722;
                }
                let _e725 = phi_1296_;
                if (_e711[2] < 0.0lf) {
                    phi_1303_ = -(_e711[2]);
                } else {
                    phi_1303_ = _e711[2];
                }
                let _e729 = phi_1303_;
                if (_e725 > _e729) {
                    phi_1308_ = _e725;
                } else {
                    phi_1308_ = _e729;
                }
                let _e732 = phi_1308_;
                let _e735 = local_20.member_2[1u];
                if (_e735[0] < 0.0lf) {
                    phi_1322_ = -(_e735[0]);
                } else {
                    phi_1322_ = _e735[0];
                }
                let _e742 = phi_1322_;
                if (_e735[1] < 0.0lf) {
                    phi_1329_ = -(_e735[1]);
                } else {
                    phi_1329_ = _e735[1];
                }
                let _e746 = phi_1329_;
                if (_e742 > _e746) {
                    phi_1334_ = _e742;
                } else {
                    phi_1334_ = _e746;
                }
                let _e749 = phi_1334_;
                if (_e735[2] < 0.0lf) {
                    phi_1341_ = -(_e735[2]);
                } else {
                    phi_1341_ = _e735[2];
                }
                let _e753 = phi_1341_;
                if (_e749 > _e753) {
                    phi_1346_ = _e749;
                } else {
                    phi_1346_ = _e753;
                }
                let _e756 = phi_1346_;
                if (_e732 > _e756) {
                    phi_1351_ = _e732;
                } else {
                    phi_1351_ = _e756;
                }
                let _e759 = phi_1351_;
                let _e761 = local_20.member_3;
                let _e762 = (_e759 + _e761);
                let _e763 = f64(1f);
                let _e764 = f64(8f);
                let _e766 = ((_e708 * _e764) * _e762);
                let _e774 = local_20.member_3;
                if (_e460 < 0.0lf) {
                    phi_1388_ = -(_e460);
                } else {
                    phi_1388_ = _e460;
                }
                let _e794 = phi_1388_;
                if (_e463 < 0.0lf) {
                    phi_1394_ = -(_e463);
                } else {
                    phi_1394_ = _e463;
                }
                let _e798 = phi_1394_;
                if (_e466 < 0.0lf) {
                    phi_1401_ = -(_e466);
                } else {
                    phi_1401_ = _e466;
                }
                let _e803 = phi_1401_;
                let _e804 = ((_e794 + _e798) + _e803);
                if (_e481 < 0.0lf) {
                    phi_1408_ = -(_e481);
                } else {
                    phi_1408_ = _e481;
                }
                let _e808 = phi_1408_;
                if (_e484 < 0.0lf) {
                    phi_1414_ = -(_e484);
                } else {
                    phi_1414_ = _e484;
                }
                let _e812 = phi_1414_;
                if (_e487 < 0.0lf) {
                    phi_1421_ = -(_e487);
                } else {
                    phi_1421_ = _e487;
                }
                let _e817 = phi_1421_;
                let _e818 = ((_e808 + _e812) + _e817);
                if (_e804 > _e818) {
                    phi_1427_ = _e804;
                } else {
                    phi_1427_ = _e818;
                }
                let _e821 = phi_1427_;
                if (_e530 < 0.0lf) {
                    phi_1433_ = -(_e530);
                } else {
                    phi_1433_ = _e530;
                }
                let _e825 = phi_1433_;
                if (_e531 < 0.0lf) {
                    phi_1439_ = -(_e531);
                } else {
                    phi_1439_ = _e531;
                }
                let _e829 = phi_1439_;
                if (_e532 < 0.0lf) {
                    phi_1446_ = -(_e532);
                } else {
                    phi_1446_ = _e532;
                }
                let _e834 = phi_1446_;
                let _e836 = (((_e825 + _e829) + _e834) * f64(0.5f));
                if (_e821 > _e836) {
                    phi_1453_ = _e821;
                } else {
                    phi_1453_ = _e836;
                }
                let _e839 = phi_1453_;
                let _e845 = local_20.member_3;
                let _e859 = (((((_e654 * _e764) * _e766) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e774 * f64(19f)) * ((_e654 * (_e708 + _e762)) + (_e708 * _e762)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e763 + _e654) * ((_e763 + _e708) * (_e763 + _e762)))));
                let _e860 = f64(3f);
                let _e861 = (_e543 * _e860);
                let _e862 = (_e600 * _e860);
                if (_e861 < _e862) {
                    phi_1481_ = _e861;
                } else {
                    phi_1481_ = _e862;
                }
                let _e865 = phi_1481_;
                if (_e566 < _e589) {
                    phi_1486_ = _e566;
                } else {
                    phi_1486_ = _e589;
                }
                let _e868 = phi_1486_;
                if (_e865 < _e868) {
                    phi_1491_ = _e865;
                } else {
                    phi_1491_ = _e868;
                }
                let _e871 = phi_1491_;
                if (_e861 > _e862) {
                    phi_1496_ = _e861;
                } else {
                    phi_1496_ = _e862;
                }
                let _e874 = phi_1496_;
                if (_e566 > _e589) {
                    phi_1501_ = _e566;
                } else {
                    phi_1501_ = _e589;
                }
                let _e877 = phi_1501_;
                if (_e874 > _e877) {
                    phi_1506_ = _e874;
                } else {
                    phi_1506_ = _e877;
                }
                let _e880 = phi_1506_;
                let _e886 = -(_e880);
                if (_e871 > _e886) {
                    phi_1517_ = _e871;
                } else {
                    phi_1517_ = _e886;
                }
                let _e889 = phi_1517_;
                if ((_e889 - (_e859 + ((_e444 * (((_e839 + (_e766 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e845 * f64(6f)) * (_e708 + _e762))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e763 + _e708) * (_e763 + _e762))))) * f64((3f * 1.0001f))))) > _e445) {
                    phi_7321_ = type_72(0u, type_72().member_1);
                } else {
                    if (_e444 > _e445) {
                        let _e3225 = f64(1f);
                        let _e3229 = local_20.member[0u];
                        let _e3235 = local_20.member_1[0u];
                        let _e3241 = local_20.member_2[0u];
                        let _e3245 = (_e3229[0] - _e3235[0]);
                        let _e3246 = (_e3229[1] - _e3235[1]);
                        let _e3247 = (_e3229[2] - _e3235[2]);
                        local_12 = array<array<f64, 3>, 4>(_e3229, array<f64, 3>(_e3245, _e3246, _e3247), array<f64, 3>((_e3229[0] - _e3241[0]), (_e3229[1] - _e3241[1]), (_e3229[2] - _e3241[2])), array<f64, 3>((_e3245 - _e3241[0]), (_e3246 - _e3241[1]), (_e3247 - _e3241[2])));
                        let _e3260 = local_20.member[1u];
                        let _e3266 = local_20.member_1[1u];
                        let _e3272 = local_20.member_2[1u];
                        let _e3276 = (_e3260[0] - _e3266[0]);
                        let _e3277 = (_e3260[1] - _e3266[1]);
                        let _e3278 = (_e3260[2] - _e3266[2]);
                        local_13 = array<array<f64, 3>, 4>(_e3260, array<f64, 3>(_e3276, _e3277, _e3278), array<f64, 3>((_e3260[0] - _e3272[0]), (_e3260[1] - _e3272[1]), (_e3260[2] - _e3272[2])), array<f64, 3>((_e3276 - _e3272[0]), (_e3277 - _e3272[1]), (_e3278 - _e3272[2])));
                        let _e3291 = local_20.member[0u];
                        if (_e3291[0] < 0.0lf) {
                            phi_1720_ = -(_e3291[0]);
                        } else {
                            phi_1720_ = _e3291[0];
                        }
                        let _e3298 = phi_1720_;
                        if (_e3291[1] < 0.0lf) {
                            phi_1727_ = -(_e3291[1]);
                        } else {
                            phi_1727_ = _e3291[1];
                        }
                        let _e3302 = phi_1727_;
                        if (_e3298 > _e3302) {
                            phi_1732_ = _e3298;
                        } else {
                            phi_1732_ = _e3302;
                        }
                        let _e3305 = phi_1732_;
                        if (_e3291[2] < 0.0lf) {
                            phi_1739_ = -(_e3291[2]);
                        } else {
                            phi_1739_ = _e3291[2];
                        }
                        let _e3309 = phi_1739_;
                        if (_e3305 > _e3309) {
                            phi_1744_ = _e3305;
                        } else {
                            phi_1744_ = _e3309;
                        }
                        let _e3312 = phi_1744_;
                        let _e3315 = local_20.member[1u];
                        if (_e3315[0] < 0.0lf) {
                            phi_1757_ = -(_e3315[0]);
                        } else {
                            phi_1757_ = _e3315[0];
                        }
                        let _e3322 = phi_1757_;
                        if (_e3315[1] < 0.0lf) {
                            phi_1764_ = -(_e3315[1]);
                        } else {
                            phi_1764_ = _e3315[1];
                        }
                        let _e3326 = phi_1764_;
                        if (_e3322 > _e3326) {
                            phi_1769_ = _e3322;
                        } else {
                            phi_1769_ = _e3326;
                        }
                        let _e3329 = phi_1769_;
                        if (_e3315[2] < 0.0lf) {
                            phi_1776_ = -(_e3315[2]);
                        } else {
                            phi_1776_ = _e3315[2];
                        }
                        let _e3333 = phi_1776_;
                        if (_e3329 > _e3333) {
                            phi_1781_ = _e3329;
                        } else {
                            phi_1781_ = _e3333;
                        }
                        let _e3336 = phi_1781_;
                        if (_e3312 > _e3336) {
                            phi_1786_ = _e3312;
                        } else {
                            phi_1786_ = _e3336;
                        }
                        let _e3339 = phi_1786_;
                        let _e3341 = local_20.member_3;
                        let _e3345 = local_20.member_1[0u];
                        if (_e3345[0] < 0.0lf) {
                            phi_1803_ = -(_e3345[0]);
                        } else {
                            phi_1803_ = _e3345[0];
                        }
                        let _e3352 = phi_1803_;
                        if (_e3345[1] < 0.0lf) {
                            phi_1810_ = -(_e3345[1]);
                        } else {
                            phi_1810_ = _e3345[1];
                        }
                        let _e3356 = phi_1810_;
                        if (_e3352 > _e3356) {
                            phi_1815_ = _e3352;
                        } else {
                            phi_1815_ = _e3356;
                        }
                        let _e3359 = phi_1815_;
                        if (_e3345[2] < 0.0lf) {
                            phi_1822_ = -(_e3345[2]);
                        } else {
                            phi_1822_ = _e3345[2];
                        }
                        let _e3363 = phi_1822_;
                        if (_e3359 > _e3363) {
                            phi_1827_ = _e3359;
                        } else {
                            phi_1827_ = _e3363;
                        }
                        let _e3366 = phi_1827_;
                        let _e3369 = local_20.member_1[1u];
                        if (_e3369[0] < 0.0lf) {
                            phi_1841_ = -(_e3369[0]);
                        } else {
                            phi_1841_ = _e3369[0];
                        }
                        let _e3376 = phi_1841_;
                        if (_e3369[1] < 0.0lf) {
                            phi_1848_ = -(_e3369[1]);
                        } else {
                            phi_1848_ = _e3369[1];
                        }
                        let _e3380 = phi_1848_;
                        if (_e3376 > _e3380) {
                            phi_1853_ = _e3376;
                        } else {
                            phi_1853_ = _e3380;
                        }
                        let _e3383 = phi_1853_;
                        if (_e3369[2] < 0.0lf) {
                            phi_1860_ = -(_e3369[2]);
                        } else {
                            phi_1860_ = _e3369[2];
                        }
                        let _e3387 = phi_1860_;
                        if (_e3383 > _e3387) {
                            phi_1865_ = _e3383;
                        } else {
                            phi_1865_ = _e3387;
                        }
                        let _e3390 = phi_1865_;
                        if (_e3366 > _e3390) {
                            phi_1870_ = _e3366;
                        } else {
                            phi_1870_ = _e3390;
                        }
                        let _e3393 = phi_1870_;
                        let _e3395 = local_20.member_3;
                        let _e3399 = local_20.member_2[0u];
                        if (_e3399[0] < 0.0lf) {
                            phi_1887_ = -(_e3399[0]);
                        } else {
                            phi_1887_ = _e3399[0];
                        }
                        let _e3406 = phi_1887_;
                        if (_e3399[1] < 0.0lf) {
                            phi_1894_ = -(_e3399[1]);
                        } else {
                            phi_1894_ = _e3399[1];
                        }
                        let _e3410 = phi_1894_;
                        if (_e3406 > _e3410) {
                            phi_1899_ = _e3406;
                        } else {
                            phi_1899_ = _e3410;
                        }
                        let _e3413 = phi_1899_;
                        if (_e3399[2] < 0.0lf) {
                            phi_1906_ = -(_e3399[2]);
                        } else {
                            phi_1906_ = _e3399[2];
                        }
                        let _e3417 = phi_1906_;
                        if (_e3413 > _e3417) {
                            phi_1911_ = _e3413;
                        } else {
                            phi_1911_ = _e3417;
                        }
                        let _e3420 = phi_1911_;
                        let _e3423 = local_20.member_2[1u];
                        if (_e3423[0] < 0.0lf) {
                            phi_1925_ = -(_e3423[0]);
                        } else {
                            phi_1925_ = _e3423[0];
                        }
                        let _e3430 = phi_1925_;
                        if (_e3423[1] < 0.0lf) {
                            phi_1932_ = -(_e3423[1]);
                        } else {
                            phi_1932_ = _e3423[1];
                        }
                        let _e3434 = phi_1932_;
                        if (_e3430 > _e3434) {
                            phi_1937_ = _e3430;
                        } else {
                            phi_1937_ = _e3434;
                        }
                        let _e3437 = phi_1937_;
                        if (_e3423[2] < 0.0lf) {
                            phi_1944_ = -(_e3423[2]);
                        } else {
                            phi_1944_ = _e3423[2];
                        }
                        let _e3441 = phi_1944_;
                        if (_e3437 > _e3441) {
                            phi_1949_ = _e3437;
                        } else {
                            phi_1949_ = _e3441;
                        }
                        let _e3444 = phi_1949_;
                        if (_e3420 > _e3444) {
                            phi_1954_ = _e3420;
                        } else {
                            phi_1954_ = _e3444;
                        }
                        let _e3447 = phi_1954_;
                        let _e3449 = local_20.member_3;
                        let _e3457 = local_20.member_3;
                        phi_1974_ = type_28(0u, 48u);
                        phi_1977_ = f64(0f);
                        loop {
                            let _e3466 = phi_1974_;
                            let _e3468 = phi_1977_;
                            local_79 = _e3468;
                            local_44 = _e3468;
                            local_45 = _e3468;
                            local_46 = _e3468;
                            if (_e3466.member < _e3466.member_1) {
                                phi_1975_ = type_28((_e3466.member + 1u), _e3466.member_1);
                                phi_2000_ = type_28(1u, _e3466.member);
                            } else {
                                phi_1975_ = _e3466;
                                phi_2000_ = type_28(0u, type_28().member_1);
                            }
                            let _e3482 = phi_1975_;
                            let _e3484 = phi_2000_;
                            if (bitcast<i32>(_e3484.member) != 0i) {
                                let _e3490 = local_20.member[0u];
                                let _e3496 = local_20.member[1u];
                                let _e3506 = (_e3490[0] + ((_e3496[0] - _e3490[0]) * _e3468));
                                let _e3507 = (_e3490[1] + ((_e3496[1] - _e3490[1]) * _e3468));
                                let _e3508 = (_e3490[2] + ((_e3496[2] - _e3490[2]) * _e3468));
                                let _e3511 = local_20.member_1[0u];
                                let _e3517 = local_20.member_1[1u];
                                let _e3527 = (_e3511[0] + ((_e3517[0] - _e3511[0]) * _e3468));
                                let _e3528 = (_e3511[1] + ((_e3517[1] - _e3511[1]) * _e3468));
                                let _e3529 = (_e3511[2] + ((_e3517[2] - _e3511[2]) * _e3468));
                                let _e3532 = local_20.member_2[0u];
                                let _e3538 = local_20.member_2[1u];
                                let _e3548 = (_e3532[0] + ((_e3538[0] - _e3532[0]) * _e3468));
                                let _e3549 = (_e3532[1] + ((_e3538[1] - _e3532[1]) * _e3468));
                                let _e3550 = (_e3532[2] + ((_e3538[2] - _e3532[2]) * _e3468));
                                let _e3555 = (((_e3527 * _e3527) + (_e3528 * _e3528)) + (_e3529 * _e3529));
                                let _e3560 = (((_e3527 * _e3548) + (_e3528 * _e3549)) + (_e3529 * _e3550));
                                let _e3565 = (((_e3548 * _e3548) + (_e3549 * _e3549)) + (_e3550 * _e3550));
                                let _e3570 = (((_e3506 * _e3527) + (_e3507 * _e3528)) + (_e3508 * _e3529));
                                let _e3575 = (((_e3506 * _e3548) + (_e3507 * _e3549)) + (_e3508 * _e3550));
                                let _e3578 = ((_e3555 * _e3565) - (_e3560 * _e3560));
                                let _e3579 = f64(0f);
                                let _e3580 = f64(1f);
                                let _e3584 = (((_e3570 * _e3565) - (_e3575 * _e3560)) / _e3578);
                                let _e3588 = (((_e3575 * _e3555) - (_e3570 * _e3560)) / _e3578);
                                if (_e3584 >= _e3579) {
                                    if (_e3588 >= _e3579) {
                                        if (_e3584 <= _e3580) {
                                            phi_2156_ = (_e3588 <= _e3580);
                                            phi_2157_ = false;
                                        } else {
                                            phi_2156_ = bool();
                                            phi_2157_ = true;
                                        }
                                        let _e3594 = phi_2156_;
                                        let _e3596 = phi_2157_;
                                        phi_2158_ = _e3594;
                                        phi_2159_ = _e3596;
                                    } else {
                                        phi_2158_ = bool();
                                        phi_2159_ = true;
                                    }
                                    let _e3598 = phi_2158_;
                                    let _e3600 = phi_2159_;
                                    phi_2160_ = _e3598;
                                    phi_2161_ = _e3600;
                                } else {
                                    phi_2160_ = bool();
                                    phi_2161_ = true;
                                }
                                let _e3602 = phi_2160_;
                                let _e3604 = phi_2161_;
                                if _e3604 {
                                    phi_2165_ = false;
                                } else {
                                    phi_2165_ = _e3602;
                                }
                                let _e3606 = phi_2165_;
                                if (_e3578 > _e3579) {
                                    if _e3606 {
                                        phi_2205_ = array<f64, 3>((_e3506 - ((_e3527 * _e3584) + (_e3548 * _e3588))), (_e3507 - ((_e3528 * _e3584) + (_e3549 * _e3588))), (_e3508 - ((_e3529 * _e3584) + (_e3550 * _e3588))));
                                        phi_2206_ = false;
                                    } else {
                                        phi_2205_ = array<f64, 3>();
                                        phi_2206_ = true;
                                    }
                                    let _e3622 = phi_2205_;
                                    let _e3624 = phi_2206_;
                                    phi_2207_ = _e3622;
                                    phi_2208_ = _e3624;
                                } else {
                                    phi_2207_ = array<f64, 3>();
                                    phi_2208_ = true;
                                }
                                let _e3626 = phi_2207_;
                                let _e3628 = phi_2208_;
                                if _e3628 {
                                    let _e3629 = (_e3506 - _e3527);
                                    let _e3630 = (_e3507 - _e3528);
                                    let _e3631 = (_e3508 - _e3529);
                                    let _e3642 = ((((_e3506 * _e3527) + (_e3507 * _e3528)) + (_e3508 * _e3529)) / (((_e3527 * _e3527) + (_e3528 * _e3528)) + (_e3529 * _e3529)));
                                    if (_e3642 > f64(0f)) {
                                        if (_e3642 < f64(1f)) {
                                            phi_2241_ = _e3642;
                                        } else {
                                            phi_2241_ = f64(1f);
                                        }
                                        let _e3650 = phi_2241_;
                                        phi_2243_ = _e3650;
                                    } else {
                                        phi_2243_ = f64(0f);
                                    }
                                    let _e3652 = phi_2243_;
                                    let _e3669 = ((((_e3506 * _e3548) + (_e3507 * _e3549)) + (_e3508 * _e3550)) / (((_e3548 * _e3548) + (_e3549 * _e3549)) + (_e3550 * _e3550)));
                                    if (_e3669 > f64(0f)) {
                                        if (_e3669 < f64(1f)) {
                                            phi_2273_ = _e3669;
                                        } else {
                                            phi_2273_ = f64(1f);
                                        }
                                        let _e3677 = phi_2273_;
                                        phi_2275_ = _e3677;
                                    } else {
                                        phi_2275_ = f64(0f);
                                    }
                                    let _e3679 = phi_2275_;
                                    let _e3696 = ((((_e3629 * _e3548) + (_e3630 * _e3549)) + (_e3631 * _e3550)) / (((_e3548 * _e3548) + (_e3549 * _e3549)) + (_e3550 * _e3550)));
                                    if (_e3696 > f64(0f)) {
                                        if (_e3696 < f64(1f)) {
                                            phi_2305_ = _e3696;
                                        } else {
                                            phi_2305_ = f64(1f);
                                        }
                                        let _e3704 = phi_2305_;
                                        phi_2307_ = _e3704;
                                    } else {
                                        phi_2307_ = f64(0f);
                                    }
                                    let _e3706 = phi_2307_;
                                    let _e3713 = (_e3506 - _e3548);
                                    let _e3714 = (_e3507 - _e3549);
                                    let _e3715 = (_e3508 - _e3550);
                                    let _e3726 = ((((_e3713 * _e3527) + (_e3714 * _e3528)) + (_e3715 * _e3529)) / (((_e3527 * _e3527) + (_e3528 * _e3528)) + (_e3529 * _e3529)));
                                    if (_e3726 > f64(0f)) {
                                        if (_e3726 < f64(1f)) {
                                            phi_2340_ = _e3726;
                                        } else {
                                            phi_2340_ = f64(1f);
                                        }
                                        let _e3734 = phi_2340_;
                                        phi_2342_ = _e3734;
                                    } else {
                                        phi_2342_ = f64(0f);
                                    }
                                    let _e3736 = phi_2342_;
                                    local_11[0u] = array<f64, 3>((_e3506 - (_e3527 * _e3652)), (_e3507 - (_e3528 * _e3652)), (_e3508 - (_e3529 * _e3652)));
                                    local_11[1u] = array<f64, 3>((_e3506 - (_e3548 * _e3679)), (_e3507 - (_e3549 * _e3679)), (_e3508 - (_e3550 * _e3679)));
                                    local_11[2u] = array<f64, 3>((_e3629 - (_e3548 * _e3706)), (_e3630 - (_e3549 * _e3706)), (_e3631 - (_e3550 * _e3706)));
                                    local_11[3u] = array<f64, 3>((_e3713 - (_e3527 * _e3736)), (_e3714 - (_e3528 * _e3736)), (_e3715 - (_e3529 * _e3736)));
                                    let _e3752 = local_11[0u];
                                    phi_2497_ = type_28(1u, 4u);
                                    phi_2500_ = array<f64, 3>(_e3752[0], _e3752[1], _e3752[2]);
                                    loop {
                                        let _e3758 = phi_2497_;
                                        let _e3760 = phi_2500_;
                                        local_69 = _e3760;
                                        if (_e3758.member < _e3758.member_1) {
                                            phi_2498_ = type_28((_e3758.member + 1u), _e3758.member_1);
                                            phi_2523_ = type_28(1u, _e3758.member);
                                        } else {
                                            phi_2498_ = _e3758;
                                            phi_2523_ = type_28(0u, type_28().member_1);
                                        }
                                        let _e3774 = phi_2498_;
                                        let _e3776 = phi_2523_;
                                        let _e3780 = (bitcast<i32>(_e3776.member) != 0i);
                                        if _e3780 {
                                            if (_e3776.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3783 = local_11[_e3776.member_1];
                                            if (_e3776.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3789 = local_11[_e3776.member_1];
                                            if ((((_e3783[0] * _e3789[0]) + (_e3783[1] * _e3789[1])) + (_e3783[2] * _e3789[2])) < (((_e3760[0] * _e3760[0]) + (_e3760[1] * _e3760[1])) + (_e3760[2] * _e3760[2]))) {
                                                if (_e3776.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3812 = local_11[_e3776.member_1];
                                                phi_2590_ = array<f64, 3>(_e3812[0], _e3812[1], _e3812[2]);
                                            } else {
                                                phi_2590_ = _e3760;
                                            }
                                            let _e3818 = phi_2590_;
                                            phi_2501_ = _e3818;
                                        } else {
                                            phi_2501_ = array<f64, 3>();
                                        }
                                        let _e3820 = phi_2501_;
                                        continue;
                                        continuing {
                                            phi_2497_ = _e3774;
                                            phi_2500_ = _e3820;
                                            break if !(_e3780);
                                        }
                                    }
                                    let _e5541 = local_69;
                                    phi_2591_ = _e5541;
                                } else {
                                    phi_2591_ = _e3626;
                                }
                                let _e3823 = phi_2591_;
                                if (_e3823[0] < 0.0lf) {
                                    phi_2598_ = -(_e3823[0]);
                                } else {
                                    phi_2598_ = _e3823[0];
                                }
                                let _e3828 = phi_2598_;
                                if (_e3823[1] < 0.0lf) {
                                    phi_2605_ = -(_e3823[1]);
                                } else {
                                    phi_2605_ = _e3823[1];
                                }
                                let _e3833 = phi_2605_;
                                if (_e3823[2] < 0.0lf) {
                                    phi_2613_ = -(_e3823[2]);
                                } else {
                                    phi_2613_ = _e3823[2];
                                }
                                let _e3839 = phi_2613_;
                                let _e3840 = ((_e3828 + _e3833) + _e3839);
                                if (_e3840 > f64(0f)) {
                                    if ((bitcast<u64>(_e3840) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e3846 = (f64(1f) / _e3840);
                                        let _e3848 = (_e3823[0] * _e3846);
                                        let _e3850 = (_e3823[1] * _e3846);
                                        let _e3852 = (_e3823[2] * _e3846);
                                        let _e3857 = (((_e3848 * _e3848) + (_e3850 * _e3850)) + (_e3852 * _e3852));
                                        if (_e3857 <= 2.2250738585072014e-308lf) {
                                            if (_e3857 > 0.0lf) {
                                                phi_2651_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2651_ = 0.0lf;
                                            }
                                            let _e3915 = phi_2651_;
                                            phi_2715_ = _e3915;
                                        } else {
                                            phi_2658_ = type_26(0i, 5i);
                                            phi_2661_ = bitcast<f64>(((bitcast<u64>(_e3857) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e3864 = phi_2658_;
                                                let _e3866 = phi_2661_;
                                                local_38 = _e3866;
                                                if (_e3864.member < _e3864.member_1) {
                                                    let _e3874 = (_e3864.member + 1i);
                                                    if ((false == (_e3874 > _e3864.member)) != false) {
                                                        phi_2682_ = true;
                                                    } else {
                                                        phi_2682_ = false;
                                                    }
                                                    let _e3879 = phi_2682_;
                                                    if _e3879 {
                                                        phi_2688_ = type_27(0u, type_27().member_1);
                                                    } else {
                                                        phi_2688_ = type_27(1u, _e3874);
                                                    }
                                                    let _e3885 = phi_2688_;
                                                    if (bitcast<i32>(_e3885.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2659_ = type_26(_e3885.member_1, _e3864.member_1);
                                                    phi_2702_ = type_27(1u, _e3864.member);
                                                } else {
                                                    phi_2659_ = _e3864;
                                                    phi_2702_ = type_27(0u, type_27().member_1);
                                                }
                                                let _e3895 = phi_2659_;
                                                let _e3897 = phi_2702_;
                                                let _e3900 = (bitcast<i32>(_e3897.member) != 0i);
                                                if _e3900 {
                                                    phi_2662_ = (0.5lf * (_e3866 + (_e3857 / _e3866)));
                                                } else {
                                                    phi_2662_ = f64();
                                                }
                                                let _e3905 = phi_2662_;
                                                continue;
                                                continuing {
                                                    phi_2658_ = _e3895;
                                                    phi_2661_ = _e3905;
                                                    break if !(_e3900);
                                                }
                                            }
                                            let _e3910 = local_38;
                                            phi_2715_ = (_e3910 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e3917 = phi_2715_;
                                        phi_2728_ = type_28(0u, 4u);
                                        phi_2731_ = f64(2f);
                                        loop {
                                            let _e3929 = phi_2728_;
                                            let _e3931 = phi_2731_;
                                            local_40 = _e3931;
                                            local_41 = _e3931;
                                            local_42 = _e3931;
                                            local_70 = _e3931;
                                            local_71 = _e3931;
                                            if (_e3929.member < _e3929.member_1) {
                                                phi_2729_ = type_28((_e3929.member + 1u), _e3929.member_1);
                                                phi_2754_ = type_28(1u, _e3929.member);
                                            } else {
                                                phi_2729_ = _e3929;
                                                phi_2754_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e3945 = phi_2729_;
                                            let _e3947 = phi_2754_;
                                            if (bitcast<i32>(_e3947.member) != 0i) {
                                                if (_e3947.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3954 = local_12[_e3947.member_1];
                                                let _e3962 = (((_e3848 * _e3954[0]) + (_e3850 * _e3954[1])) + (_e3852 * _e3954[2]));
                                                if (_e3947.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3965 = local_13[_e3947.member_1];
                                                let _e3973 = (((_e3848 * _e3965[0]) + (_e3850 * _e3965[1])) + (_e3852 * _e3965[2]));
                                                if (_e3962 < 0.0lf) {
                                                    phi_2805_ = -(_e3962);
                                                } else {
                                                    phi_2805_ = _e3962;
                                                }
                                                let _e3977 = phi_2805_;
                                                if (_e3973 < 0.0lf) {
                                                    phi_2811_ = -(_e3973);
                                                } else {
                                                    phi_2811_ = _e3973;
                                                }
                                                let _e3981 = phi_2811_;
                                                let _e3986 = (((((((((_e3339 + _e3341) + (_e3393 + _e3395)) + (_e3447 + _e3449)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3457 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e444 * _e3917) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e3977 + _e3981) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e3962 > _e3986) {
                                                    if (_e3973 > _e3986) {
                                                        phi_2825_ = false;
                                                    } else {
                                                        phi_2825_ = true;
                                                    }
                                                    let _e3990 = phi_2825_;
                                                    phi_2826_ = _e3990;
                                                } else {
                                                    phi_2826_ = true;
                                                }
                                                let _e3992 = phi_2826_;
                                                if _e3992 {
                                                    let _e3996 = ((_e3962 + ((_e3973 - _e3962) * _e3468)) > _e3986);
                                                    if _e3996 {
                                                        if (_e3973 < _e3962) {
                                                            let _e4005 = (((_e3962 - _e3986) / (_e3962 - _e3973)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                            if (_e3931 < _e4005) {
                                                                phi_2853_ = _e3931;
                                                            } else {
                                                                phi_2853_ = _e4005;
                                                            }
                                                            let _e4008 = phi_2853_;
                                                            phi_2854_ = _e4008;
                                                        } else {
                                                            phi_2854_ = _e3931;
                                                        }
                                                        let _e4010 = phi_2854_;
                                                        phi_2855_ = _e4010;
                                                    } else {
                                                        phi_2855_ = f64();
                                                    }
                                                    let _e4012 = phi_2855_;
                                                    phi_2856_ = _e4012;
                                                    phi_2857_ = _e3996;
                                                } else {
                                                    phi_2856_ = _e3931;
                                                    phi_2857_ = true;
                                                }
                                                let _e4014 = phi_2856_;
                                                let _e4016 = phi_2857_;
                                                phi_2732_ = _e4014;
                                                phi_2858_ = _e4016;
                                                phi_2859_ = false;
                                            } else {
                                                phi_2732_ = f64();
                                                phi_2858_ = false;
                                                phi_2859_ = true;
                                            }
                                            let _e4018 = phi_2732_;
                                            let _e4020 = phi_2858_;
                                            let _e4022 = phi_2859_;
                                            local_39 = _e4022;
                                            continue;
                                            continuing {
                                                phi_2728_ = _e3945;
                                                phi_2731_ = _e4018;
                                                break if !(_e4020);
                                            }
                                        }
                                        let _e4025 = local_39;
                                        if _e4025 {
                                            let _e4027 = local_40;
                                            let _e4028 = (_e4027 > _e3225);
                                            if _e4028 {
                                                phi_2881_ = false;
                                                phi_2882_ = false;
                                                phi_2883_ = false;
                                            } else {
                                                let _e4030 = local_41;
                                                if (_e4030 > _e3468) {
                                                    let _e4033 = local_42;
                                                    let _e4036 = ((_e4033 - _e3468) < f64(0.00000000023283064f));
                                                    if _e4036 {
                                                        phi_2877_ = false;
                                                    } else {
                                                        phi_2877_ = true;
                                                    }
                                                    let _e4038 = phi_2877_;
                                                    phi_2878_ = _e4038;
                                                    phi_2879_ = _e4036;
                                                    phi_2880_ = false;
                                                } else {
                                                    phi_2878_ = false;
                                                    phi_2879_ = false;
                                                    phi_2880_ = true;
                                                }
                                                let _e4040 = phi_2878_;
                                                let _e4042 = phi_2879_;
                                                let _e4044 = phi_2880_;
                                                phi_2881_ = _e4040;
                                                phi_2882_ = _e4042;
                                                phi_2883_ = _e4044;
                                            }
                                            let _e4046 = phi_2881_;
                                            let _e4048 = phi_2882_;
                                            let _e4050 = phi_2883_;
                                            phi_2884_ = _e4046;
                                            phi_2885_ = _e4028;
                                            phi_2886_ = _e4048;
                                            phi_2887_ = _e4050;
                                            phi_2888_ = false;
                                        } else {
                                            phi_2884_ = false;
                                            phi_2885_ = false;
                                            phi_2886_ = false;
                                            phi_2887_ = false;
                                            phi_2888_ = true;
                                        }
                                        let _e4052 = phi_2884_;
                                        let _e4054 = phi_2885_;
                                        let _e4056 = phi_2886_;
                                        let _e4058 = phi_2887_;
                                        let _e4060 = phi_2888_;
                                        let _e5589 = local_70;
                                        phi_2889_ = _e5589;
                                        let _e5592 = local_71;
                                        phi_2890_ = _e5592;
                                        phi_2891_ = _e4052;
                                        phi_2892_ = _e4054;
                                        phi_2893_ = _e4056;
                                        phi_2894_ = _e4058;
                                        phi_2895_ = _e4060;
                                        phi_2896_ = false;
                                    } else {
                                        phi_2889_ = f64();
                                        phi_2890_ = f64();
                                        phi_2891_ = false;
                                        phi_2892_ = false;
                                        phi_2893_ = false;
                                        phi_2894_ = false;
                                        phi_2895_ = false;
                                        phi_2896_ = true;
                                    }
                                    let _e4062 = phi_2889_;
                                    let _e4064 = phi_2890_;
                                    let _e4066 = phi_2891_;
                                    let _e4068 = phi_2892_;
                                    let _e4070 = phi_2893_;
                                    let _e4072 = phi_2894_;
                                    let _e4074 = phi_2895_;
                                    let _e4076 = phi_2896_;
                                    phi_2897_ = _e4062;
                                    phi_2898_ = _e4064;
                                    phi_2899_ = _e4066;
                                    phi_2900_ = _e4068;
                                    phi_2901_ = _e4070;
                                    phi_2902_ = _e4072;
                                    phi_2903_ = _e4074;
                                    phi_2904_ = _e4076;
                                    phi_2905_ = false;
                                } else {
                                    phi_2897_ = f64();
                                    phi_2898_ = f64();
                                    phi_2899_ = false;
                                    phi_2900_ = false;
                                    phi_2901_ = false;
                                    phi_2902_ = false;
                                    phi_2903_ = false;
                                    phi_2904_ = false;
                                    phi_2905_ = true;
                                }
                                let _e4078 = phi_2897_;
                                let _e4080 = phi_2898_;
                                let _e4082 = phi_2899_;
                                let _e4084 = phi_2900_;
                                let _e4086 = phi_2901_;
                                let _e4088 = phi_2902_;
                                let _e4090 = phi_2903_;
                                let _e4092 = phi_2904_;
                                let _e4094 = phi_2905_;
                                phi_2906_ = _e4078;
                                phi_1978_ = _e4080;
                                phi_2907_ = _e4082;
                                phi_2908_ = _e4084;
                                phi_2909_ = _e4086;
                                phi_2910_ = false;
                                phi_2911_ = _e4088;
                                phi_2912_ = _e4090;
                                phi_2913_ = _e4092;
                                phi_2914_ = _e4094;
                            } else {
                                phi_2906_ = f64();
                                phi_1978_ = f64();
                                phi_2907_ = false;
                                phi_2908_ = false;
                                phi_2909_ = false;
                                phi_2910_ = true;
                                phi_2911_ = false;
                                phi_2912_ = false;
                                phi_2913_ = false;
                                phi_2914_ = false;
                            }
                            let _e4096 = phi_2906_;
                            let _e4098 = phi_1978_;
                            let _e4100 = phi_2907_;
                            let _e4102 = phi_2908_;
                            let _e4104 = phi_2909_;
                            let _e4106 = phi_2910_;
                            let _e4108 = phi_2911_;
                            let _e4110 = phi_2912_;
                            let _e4112 = phi_2913_;
                            let _e4114 = phi_2914_;
                            local_43 = _e4102;
                            local_72 = _e4104;
                            local_73 = _e4106;
                            local_74 = _e4108;
                            local_75 = _e4110;
                            local_76 = _e4112;
                            local_77 = _e4114;
                            local_78 = _e4096;
                            local_80 = _e4102;
                            continue;
                            continuing {
                                phi_1974_ = _e3482;
                                phi_1977_ = _e4098;
                                break if !(_e4100);
                            }
                        }
                        let _e4117 = local_43;
                        if _e4117 {
                            phi_2919_ = type_72(0u, type_72().member_1);
                            phi_2920_ = false;
                            phi_2921_ = false;
                            phi_2922_ = false;
                            phi_2923_ = false;
                            phi_2924_ = false;
                            phi_2925_ = false;
                        } else {
                            phi_2919_ = type_72();
                            let _e5622 = local_72;
                            phi_2920_ = _e5622;
                            let _e5625 = local_73;
                            phi_2921_ = _e5625;
                            let _e5628 = local_74;
                            phi_2922_ = _e5628;
                            let _e5631 = local_75;
                            phi_2923_ = _e5631;
                            let _e5634 = local_76;
                            phi_2924_ = _e5634;
                            let _e5637 = local_77;
                            phi_2925_ = _e5637;
                        }
                        let _e4122 = phi_2919_;
                        let _e4124 = phi_2920_;
                        let _e4126 = phi_2921_;
                        let _e4128 = phi_2922_;
                        let _e4130 = phi_2923_;
                        let _e4132 = phi_2924_;
                        let _e4134 = phi_2925_;
                        if _e4124 {
                            let _e5640 = local_78;
                            phi_2929_ = _e5640;
                            phi_2930_ = true;
                            phi_2931_ = false;
                            phi_2932_ = false;
                            phi_2933_ = false;
                            phi_2934_ = false;
                            phi_2935_ = false;
                        } else {
                            let _e5642 = local_79;
                            phi_2929_ = _e5642;
                            phi_2930_ = _e4126;
                            phi_2931_ = _e4128;
                            phi_2932_ = _e4130;
                            let _e5648 = local_80;
                            phi_2933_ = _e5648;
                            phi_2934_ = _e4132;
                            phi_2935_ = _e4134;
                        }
                        let _e4136 = phi_2929_;
                        let _e4138 = phi_2930_;
                        let _e4140 = phi_2931_;
                        let _e4142 = phi_2932_;
                        let _e4144 = phi_2933_;
                        let _e4146 = phi_2934_;
                        let _e4148 = phi_2935_;
                        if _e4138 {
                            phi_2940_ = type_72(1u, _e4136);
                            phi_2941_ = false;
                            phi_2942_ = false;
                            phi_2943_ = false;
                            phi_2944_ = false;
                            phi_2945_ = false;
                        } else {
                            phi_2940_ = type_72();
                            phi_2941_ = _e4140;
                            phi_2942_ = _e4142;
                            phi_2943_ = _e4144;
                            phi_2944_ = _e4146;
                            phi_2945_ = _e4148;
                        }
                        let _e4151 = phi_2940_;
                        let _e4153 = phi_2941_;
                        let _e4155 = phi_2942_;
                        let _e4157 = phi_2943_;
                        let _e4159 = phi_2944_;
                        let _e4161 = phi_2945_;
                        if _e4153 {
                            let _e4163 = local_44;
                            phi_2950_ = type_72(1u, _e4163);
                            phi_2951_ = false;
                            phi_2952_ = true;
                            phi_2953_ = false;
                            phi_2954_ = false;
                        } else {
                            phi_2950_ = _e4122;
                            phi_2951_ = _e4155;
                            phi_2952_ = _e4157;
                            phi_2953_ = _e4159;
                            phi_2954_ = _e4161;
                        }
                        let _e4166 = phi_2950_;
                        let _e4168 = phi_2951_;
                        let _e4170 = phi_2952_;
                        let _e4172 = phi_2953_;
                        let _e4174 = phi_2954_;
                        if _e4168 {
                            let _e4176 = local_45;
                            phi_2959_ = type_72(1u, _e4176);
                            phi_2960_ = true;
                            phi_2961_ = false;
                            phi_2962_ = false;
                        } else {
                            phi_2959_ = _e4166;
                            phi_2960_ = _e4170;
                            phi_2961_ = _e4172;
                            phi_2962_ = _e4174;
                        }
                        let _e4179 = phi_2959_;
                        let _e4181 = phi_2960_;
                        let _e4183 = phi_2961_;
                        let _e4185 = phi_2962_;
                        if _e4181 {
                            phi_2966_ = false;
                            phi_2967_ = false;
                        } else {
                            phi_2966_ = _e4183;
                            phi_2967_ = _e4185;
                        }
                        let _e4187 = phi_2966_;
                        let _e4189 = phi_2967_;
                        if _e4187 {
                            phi_2971_ = false;
                            phi_2972_ = false;
                        } else {
                            phi_2971_ = _e4189;
                            phi_2972_ = _e4181;
                        }
                        let _e4191 = phi_2971_;
                        let _e4193 = phi_2972_;
                        if _e4191 {
                            phi_2976_ = true;
                            phi_2977_ = false;
                        } else {
                            phi_2976_ = _e4187;
                            phi_2977_ = _e4193;
                        }
                        let _e4195 = phi_2976_;
                        let _e4197 = phi_2977_;
                        if _e4195 {
                            let _e4199 = local_46;
                            phi_2982_ = type_72(1u, _e4199);
                            phi_2983_ = true;
                        } else {
                            phi_2982_ = _e4179;
                            phi_2983_ = _e4197;
                        }
                        let _e4202 = phi_2982_;
                        let _e4204 = phi_2983_;
                        if _e4204 {
                            phi_2987_ = _e4202;
                        } else {
                            phi_2987_ = _e4151;
                        }
                        let _e4206 = phi_2987_;
                        if (_e4206.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_3001_ = type_28(0u, 3u);
                            loop {
                                let _e4219 = phi_3001_;
                                if (_e4219.member < _e4219.member_1) {
                                    phi_3002_ = type_28((_e4219.member + 1u), _e4219.member_1);
                                    phi_3025_ = type_28(1u, _e4219.member);
                                } else {
                                    phi_3002_ = _e4219;
                                    phi_3025_ = type_28(0u, type_28().member_1);
                                }
                                let _e4233 = phi_3002_;
                                let _e4235 = phi_3025_;
                                if (bitcast<i32>(_e4235.member) != 0i) {
                                    if (_e4235.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4242 = local_14[_e4235.member_1];
                                    let _e4244 = (_e4206.member_1 + f64(_e4242));
                                    if (_e4244 < _e3225) {
                                        phi_3046_ = _e4244;
                                    } else {
                                        phi_3046_ = _e3225;
                                    }
                                    let _e4247 = phi_3046_;
                                    let _e4250 = local_20.member[0u];
                                    let _e4256 = local_20.member[1u];
                                    let _e4266 = (_e4250[0] + ((_e4256[0] - _e4250[0]) * _e4247));
                                    let _e4267 = (_e4250[1] + ((_e4256[1] - _e4250[1]) * _e4247));
                                    let _e4268 = (_e4250[2] + ((_e4256[2] - _e4250[2]) * _e4247));
                                    let _e4271 = local_20.member_1[0u];
                                    let _e4277 = local_20.member_1[1u];
                                    let _e4287 = (_e4271[0] + ((_e4277[0] - _e4271[0]) * _e4247));
                                    let _e4288 = (_e4271[1] + ((_e4277[1] - _e4271[1]) * _e4247));
                                    let _e4289 = (_e4271[2] + ((_e4277[2] - _e4271[2]) * _e4247));
                                    let _e4292 = local_20.member_2[0u];
                                    let _e4298 = local_20.member_2[1u];
                                    let _e4308 = (_e4292[0] + ((_e4298[0] - _e4292[0]) * _e4247));
                                    let _e4309 = (_e4292[1] + ((_e4298[1] - _e4292[1]) * _e4247));
                                    let _e4310 = (_e4292[2] + ((_e4298[2] - _e4292[2]) * _e4247));
                                    let _e4315 = (((_e4287 * _e4287) + (_e4288 * _e4288)) + (_e4289 * _e4289));
                                    let _e4320 = (((_e4287 * _e4308) + (_e4288 * _e4309)) + (_e4289 * _e4310));
                                    let _e4325 = (((_e4308 * _e4308) + (_e4309 * _e4309)) + (_e4310 * _e4310));
                                    let _e4330 = (((_e4266 * _e4287) + (_e4267 * _e4288)) + (_e4268 * _e4289));
                                    let _e4335 = (((_e4266 * _e4308) + (_e4267 * _e4309)) + (_e4268 * _e4310));
                                    let _e4338 = ((_e4315 * _e4325) - (_e4320 * _e4320));
                                    let _e4339 = f64(0f);
                                    let _e4340 = f64(1f);
                                    let _e4344 = (((_e4330 * _e4325) - (_e4335 * _e4320)) / _e4338);
                                    let _e4348 = (((_e4335 * _e4315) - (_e4330 * _e4320)) / _e4338);
                                    if (_e4344 >= _e4339) {
                                        if (_e4348 >= _e4339) {
                                            if (_e4344 <= _e4340) {
                                                phi_3196_ = (_e4348 <= _e4340);
                                                phi_3197_ = false;
                                            } else {
                                                phi_3196_ = bool();
                                                phi_3197_ = true;
                                            }
                                            let _e4354 = phi_3196_;
                                            let _e4356 = phi_3197_;
                                            phi_3198_ = _e4354;
                                            phi_3199_ = _e4356;
                                        } else {
                                            phi_3198_ = bool();
                                            phi_3199_ = true;
                                        }
                                        let _e4358 = phi_3198_;
                                        let _e4360 = phi_3199_;
                                        phi_3200_ = _e4358;
                                        phi_3201_ = _e4360;
                                    } else {
                                        phi_3200_ = bool();
                                        phi_3201_ = true;
                                    }
                                    let _e4362 = phi_3200_;
                                    let _e4364 = phi_3201_;
                                    if _e4364 {
                                        phi_3205_ = false;
                                    } else {
                                        phi_3205_ = _e4362;
                                    }
                                    let _e4366 = phi_3205_;
                                    if (_e4338 > _e4339) {
                                        if _e4366 {
                                            phi_3245_ = array<f64, 3>((_e4266 - ((_e4287 * _e4344) + (_e4308 * _e4348))), (_e4267 - ((_e4288 * _e4344) + (_e4309 * _e4348))), (_e4268 - ((_e4289 * _e4344) + (_e4310 * _e4348))));
                                            phi_3246_ = false;
                                        } else {
                                            phi_3245_ = array<f64, 3>();
                                            phi_3246_ = true;
                                        }
                                        let _e4382 = phi_3245_;
                                        let _e4384 = phi_3246_;
                                        phi_3247_ = _e4382;
                                        phi_3248_ = _e4384;
                                    } else {
                                        phi_3247_ = array<f64, 3>();
                                        phi_3248_ = true;
                                    }
                                    let _e4386 = phi_3247_;
                                    let _e4388 = phi_3248_;
                                    if _e4388 {
                                        let _e4389 = (_e4266 - _e4287);
                                        let _e4390 = (_e4267 - _e4288);
                                        let _e4391 = (_e4268 - _e4289);
                                        let _e4402 = ((((_e4266 * _e4287) + (_e4267 * _e4288)) + (_e4268 * _e4289)) / (((_e4287 * _e4287) + (_e4288 * _e4288)) + (_e4289 * _e4289)));
                                        if (_e4402 > f64(0f)) {
                                            if (_e4402 < f64(1f)) {
                                                phi_3281_ = _e4402;
                                            } else {
                                                phi_3281_ = f64(1f);
                                            }
                                            let _e4410 = phi_3281_;
                                            phi_3283_ = _e4410;
                                        } else {
                                            phi_3283_ = f64(0f);
                                        }
                                        let _e4412 = phi_3283_;
                                        let _e4429 = ((((_e4266 * _e4308) + (_e4267 * _e4309)) + (_e4268 * _e4310)) / (((_e4308 * _e4308) + (_e4309 * _e4309)) + (_e4310 * _e4310)));
                                        if (_e4429 > f64(0f)) {
                                            if (_e4429 < f64(1f)) {
                                                phi_3313_ = _e4429;
                                            } else {
                                                phi_3313_ = f64(1f);
                                            }
                                            let _e4437 = phi_3313_;
                                            phi_3315_ = _e4437;
                                        } else {
                                            phi_3315_ = f64(0f);
                                        }
                                        let _e4439 = phi_3315_;
                                        let _e4456 = ((((_e4389 * _e4308) + (_e4390 * _e4309)) + (_e4391 * _e4310)) / (((_e4308 * _e4308) + (_e4309 * _e4309)) + (_e4310 * _e4310)));
                                        if (_e4456 > f64(0f)) {
                                            if (_e4456 < f64(1f)) {
                                                phi_3345_ = _e4456;
                                            } else {
                                                phi_3345_ = f64(1f);
                                            }
                                            let _e4464 = phi_3345_;
                                            phi_3347_ = _e4464;
                                        } else {
                                            phi_3347_ = f64(0f);
                                        }
                                        let _e4466 = phi_3347_;
                                        let _e4473 = (_e4266 - _e4308);
                                        let _e4474 = (_e4267 - _e4309);
                                        let _e4475 = (_e4268 - _e4310);
                                        let _e4486 = ((((_e4473 * _e4287) + (_e4474 * _e4288)) + (_e4475 * _e4289)) / (((_e4287 * _e4287) + (_e4288 * _e4288)) + (_e4289 * _e4289)));
                                        if (_e4486 > f64(0f)) {
                                            if (_e4486 < f64(1f)) {
                                                phi_3380_ = _e4486;
                                            } else {
                                                phi_3380_ = f64(1f);
                                            }
                                            let _e4494 = phi_3380_;
                                            phi_3382_ = _e4494;
                                        } else {
                                            phi_3382_ = f64(0f);
                                        }
                                        let _e4496 = phi_3382_;
                                        local_10[0u] = array<f64, 3>((_e4266 - (_e4287 * _e4412)), (_e4267 - (_e4288 * _e4412)), (_e4268 - (_e4289 * _e4412)));
                                        local_10[1u] = array<f64, 3>((_e4266 - (_e4308 * _e4439)), (_e4267 - (_e4309 * _e4439)), (_e4268 - (_e4310 * _e4439)));
                                        local_10[2u] = array<f64, 3>((_e4389 - (_e4308 * _e4466)), (_e4390 - (_e4309 * _e4466)), (_e4391 - (_e4310 * _e4466)));
                                        local_10[3u] = array<f64, 3>((_e4473 - (_e4287 * _e4496)), (_e4474 - (_e4288 * _e4496)), (_e4475 - (_e4289 * _e4496)));
                                        let _e4512 = local_10[0u];
                                        phi_3537_ = type_28(1u, 4u);
                                        phi_3540_ = array<f64, 3>(_e4512[0], _e4512[1], _e4512[2]);
                                        loop {
                                            let _e4518 = phi_3537_;
                                            let _e4520 = phi_3540_;
                                            local_81 = _e4520;
                                            if (_e4518.member < _e4518.member_1) {
                                                phi_3538_ = type_28((_e4518.member + 1u), _e4518.member_1);
                                                phi_3563_ = type_28(1u, _e4518.member);
                                            } else {
                                                phi_3538_ = _e4518;
                                                phi_3563_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4534 = phi_3538_;
                                            let _e4536 = phi_3563_;
                                            let _e4540 = (bitcast<i32>(_e4536.member) != 0i);
                                            if _e4540 {
                                                if (_e4536.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4543 = local_10[_e4536.member_1];
                                                if (_e4536.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4549 = local_10[_e4536.member_1];
                                                if ((((_e4543[0] * _e4549[0]) + (_e4543[1] * _e4549[1])) + (_e4543[2] * _e4549[2])) < (((_e4520[0] * _e4520[0]) + (_e4520[1] * _e4520[1])) + (_e4520[2] * _e4520[2]))) {
                                                    if (_e4536.member_1 < 4u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e4572 = local_10[_e4536.member_1];
                                                    phi_3630_ = array<f64, 3>(_e4572[0], _e4572[1], _e4572[2]);
                                                } else {
                                                    phi_3630_ = _e4520;
                                                }
                                                let _e4578 = phi_3630_;
                                                phi_3541_ = _e4578;
                                            } else {
                                                phi_3541_ = array<f64, 3>();
                                            }
                                            let _e4580 = phi_3541_;
                                            continue;
                                            continuing {
                                                phi_3537_ = _e4534;
                                                phi_3540_ = _e4580;
                                                break if !(_e4540);
                                            }
                                        }
                                        let _e5709 = local_81;
                                        phi_3631_ = _e5709;
                                    } else {
                                        phi_3631_ = _e4386;
                                    }
                                    let _e4583 = phi_3631_;
                                    let _e4594 = (((_e4583[0] * _e4583[0]) + (_e4583[1] * _e4583[1])) + (_e4583[2] * _e4583[2]));
                                    if (_e4594 <= 2.2250738585072014e-308lf) {
                                        if (_e4594 > 0.0lf) {
                                            phi_3656_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3656_ = 0.0lf;
                                        }
                                        let _e4652 = phi_3656_;
                                        phi_3720_ = _e4652;
                                    } else {
                                        phi_3663_ = type_26(0i, 5i);
                                        phi_3666_ = bitcast<f64>(((bitcast<u64>(_e4594) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e4601 = phi_3663_;
                                            let _e4603 = phi_3666_;
                                            local_47 = _e4603;
                                            if (_e4601.member < _e4601.member_1) {
                                                let _e4611 = (_e4601.member + 1i);
                                                if ((false == (_e4611 > _e4601.member)) != false) {
                                                    phi_3687_ = true;
                                                } else {
                                                    phi_3687_ = false;
                                                }
                                                let _e4616 = phi_3687_;
                                                if _e4616 {
                                                    phi_3693_ = type_27(0u, type_27().member_1);
                                                } else {
                                                    phi_3693_ = type_27(1u, _e4611);
                                                }
                                                let _e4622 = phi_3693_;
                                                if (bitcast<i32>(_e4622.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3664_ = type_26(_e4622.member_1, _e4601.member_1);
                                                phi_3707_ = type_27(1u, _e4601.member);
                                            } else {
                                                phi_3664_ = _e4601;
                                                phi_3707_ = type_27(0u, type_27().member_1);
                                            }
                                            let _e4632 = phi_3664_;
                                            let _e4634 = phi_3707_;
                                            let _e4637 = (bitcast<i32>(_e4634.member) != 0i);
                                            if _e4637 {
                                                phi_3667_ = (0.5lf * (_e4603 + (_e4594 / _e4603)));
                                            } else {
                                                phi_3667_ = f64();
                                            }
                                            let _e4642 = phi_3667_;
                                            continue;
                                            continuing {
                                                phi_3663_ = _e4632;
                                                phi_3666_ = _e4642;
                                                break if !(_e4637);
                                            }
                                        }
                                        let _e4647 = local_47;
                                        phi_3720_ = (_e4647 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e4654 = phi_3720_;
                                    let _e4662 = local_20.member[0u];
                                    if (_e4662[0] < 0.0lf) {
                                        phi_3738_ = -(_e4662[0]);
                                    } else {
                                        phi_3738_ = _e4662[0];
                                    }
                                    let _e4669 = phi_3738_;
                                    if (_e4662[1] < 0.0lf) {
                                        phi_3745_ = -(_e4662[1]);
                                    } else {
                                        phi_3745_ = _e4662[1];
                                    }
                                    let _e4673 = phi_3745_;
                                    if (_e4669 > _e4673) {
                                        phi_3750_ = _e4669;
                                    } else {
                                        phi_3750_ = _e4673;
                                    }
                                    let _e4676 = phi_3750_;
                                    if (_e4662[2] < 0.0lf) {
                                        phi_3757_ = -(_e4662[2]);
                                    } else {
                                        phi_3757_ = _e4662[2];
                                    }
                                    let _e4680 = phi_3757_;
                                    if (_e4676 > _e4680) {
                                        phi_3762_ = _e4676;
                                    } else {
                                        phi_3762_ = _e4680;
                                    }
                                    let _e4683 = phi_3762_;
                                    let _e4686 = local_20.member[1u];
                                    if (_e4686[0] < 0.0lf) {
                                        phi_3775_ = -(_e4686[0]);
                                    } else {
                                        phi_3775_ = _e4686[0];
                                    }
                                    let _e4693 = phi_3775_;
                                    if (_e4686[1] < 0.0lf) {
                                        phi_3782_ = -(_e4686[1]);
                                    } else {
                                        phi_3782_ = _e4686[1];
                                    }
                                    let _e4697 = phi_3782_;
                                    if (_e4693 > _e4697) {
                                        phi_3787_ = _e4693;
                                    } else {
                                        phi_3787_ = _e4697;
                                    }
                                    let _e4700 = phi_3787_;
                                    if (_e4686[2] < 0.0lf) {
                                        phi_3794_ = -(_e4686[2]);
                                    } else {
                                        phi_3794_ = _e4686[2];
                                    }
                                    let _e4704 = phi_3794_;
                                    if (_e4700 > _e4704) {
                                        phi_3799_ = _e4700;
                                    } else {
                                        phi_3799_ = _e4704;
                                    }
                                    let _e4707 = phi_3799_;
                                    if (_e4683 > _e4707) {
                                        phi_3804_ = _e4683;
                                    } else {
                                        phi_3804_ = _e4707;
                                    }
                                    let _e4710 = phi_3804_;
                                    let _e4712 = local_20.member_3;
                                    let _e4716 = local_20.member_1[0u];
                                    if (_e4716[0] < 0.0lf) {
                                        phi_3821_ = -(_e4716[0]);
                                    } else {
                                        phi_3821_ = _e4716[0];
                                    }
                                    let _e4723 = phi_3821_;
                                    if (_e4716[1] < 0.0lf) {
                                        phi_3828_ = -(_e4716[1]);
                                    } else {
                                        phi_3828_ = _e4716[1];
                                    }
                                    let _e4727 = phi_3828_;
                                    if (_e4723 > _e4727) {
                                        phi_3833_ = _e4723;
                                    } else {
                                        phi_3833_ = _e4727;
                                    }
                                    let _e4730 = phi_3833_;
                                    if (_e4716[2] < 0.0lf) {
                                        phi_3840_ = -(_e4716[2]);
                                    } else {
                                        phi_3840_ = _e4716[2];
                                    }
                                    let _e4734 = phi_3840_;
                                    if (_e4730 > _e4734) {
                                        phi_3845_ = _e4730;
                                    } else {
                                        phi_3845_ = _e4734;
                                    }
                                    let _e4737 = phi_3845_;
                                    let _e4740 = local_20.member_1[1u];
                                    if (_e4740[0] < 0.0lf) {
                                        phi_3859_ = -(_e4740[0]);
                                    } else {
                                        phi_3859_ = _e4740[0];
                                    }
                                    let _e4747 = phi_3859_;
                                    if (_e4740[1] < 0.0lf) {
                                        phi_3866_ = -(_e4740[1]);
                                    } else {
                                        phi_3866_ = _e4740[1];
                                    }
                                    let _e4751 = phi_3866_;
                                    if (_e4747 > _e4751) {
                                        phi_3871_ = _e4747;
                                    } else {
                                        phi_3871_ = _e4751;
                                    }
                                    let _e4754 = phi_3871_;
                                    if (_e4740[2] < 0.0lf) {
                                        phi_3878_ = -(_e4740[2]);
                                    } else {
                                        phi_3878_ = _e4740[2];
                                    }
                                    let _e4758 = phi_3878_;
                                    if (_e4754 > _e4758) {
                                        phi_3883_ = _e4754;
                                    } else {
                                        phi_3883_ = _e4758;
                                    }
                                    let _e4761 = phi_3883_;
                                    if (_e4737 > _e4761) {
                                        phi_3888_ = _e4737;
                                    } else {
                                        phi_3888_ = _e4761;
                                    }
                                    let _e4764 = phi_3888_;
                                    let _e4766 = local_20.member_3;
                                    let _e4770 = local_20.member_2[0u];
                                    if (_e4770[0] < 0.0lf) {
                                        phi_3905_ = -(_e4770[0]);
                                    } else {
                                        phi_3905_ = _e4770[0];
                                    }
                                    let _e4777 = phi_3905_;
                                    if (_e4770[1] < 0.0lf) {
                                        phi_3912_ = -(_e4770[1]);
                                    } else {
                                        phi_3912_ = _e4770[1];
                                    }
                                    let _e4781 = phi_3912_;
                                    if (_e4777 > _e4781) {
                                        phi_3917_ = _e4777;
                                    } else {
                                        phi_3917_ = _e4781;
                                    }
                                    let _e4784 = phi_3917_;
                                    if (_e4770[2] < 0.0lf) {
                                        phi_3924_ = -(_e4770[2]);
                                    } else {
                                        phi_3924_ = _e4770[2];
                                    }
                                    let _e4788 = phi_3924_;
                                    if (_e4784 > _e4788) {
                                        phi_3929_ = _e4784;
                                    } else {
                                        phi_3929_ = _e4788;
                                    }
                                    let _e4791 = phi_3929_;
                                    let _e4794 = local_20.member_2[1u];
                                    if (_e4794[0] < 0.0lf) {
                                        phi_3943_ = -(_e4794[0]);
                                    } else {
                                        phi_3943_ = _e4794[0];
                                    }
                                    let _e4801 = phi_3943_;
                                    if (_e4794[1] < 0.0lf) {
                                        phi_3950_ = -(_e4794[1]);
                                    } else {
                                        phi_3950_ = _e4794[1];
                                    }
                                    let _e4805 = phi_3950_;
                                    if (_e4801 > _e4805) {
                                        phi_3955_ = _e4801;
                                    } else {
                                        phi_3955_ = _e4805;
                                    }
                                    let _e4808 = phi_3955_;
                                    if (_e4794[2] < 0.0lf) {
                                        phi_3962_ = -(_e4794[2]);
                                    } else {
                                        phi_3962_ = _e4794[2];
                                    }
                                    let _e4812 = phi_3962_;
                                    if (_e4808 > _e4812) {
                                        phi_3967_ = _e4808;
                                    } else {
                                        phi_3967_ = _e4812;
                                    }
                                    let _e4815 = phi_3967_;
                                    if (_e4791 > _e4815) {
                                        phi_3972_ = _e4791;
                                    } else {
                                        phi_3972_ = _e4815;
                                    }
                                    let _e4818 = phi_3972_;
                                    let _e4820 = local_20.member_3;
                                    let _e4828 = local_20.member_3;
                                    let _e4838 = (((_e4654 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e4710 + _e4712) + (_e4764 + _e4766)) + (_e4818 + _e4820)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4828 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e444);
                                    if _e4838 {
                                        phi_3996_ = false;
                                    } else {
                                        phi_3996_ = true;
                                    }
                                    let _e4840 = phi_3996_;
                                    phi_3997_ = _e4840;
                                    phi_3998_ = _e4838;
                                } else {
                                    phi_3997_ = false;
                                    phi_3998_ = false;
                                }
                                let _e4842 = phi_3997_;
                                let _e4844 = phi_3998_;
                                local_48 = _e4844;
                                continue;
                                continuing {
                                    phi_3001_ = _e4233;
                                    break if !(_e4842);
                                }
                            }
                            let _e4847 = local_48;
                            if _e4847 {
                                phi_4003_ = type_72(1u, _e4206.member_1);
                                phi_4004_ = false;
                            } else {
                                phi_4003_ = type_72();
                                phi_4004_ = true;
                            }
                            let _e4850 = phi_4003_;
                            let _e4852 = phi_4004_;
                            if _e4852 {
                                phi_4009_ = type_72(2u, _e4206.member_1);
                                phi_4010_ = false;
                            } else {
                                phi_4009_ = type_72();
                                phi_4010_ = true;
                            }
                            let _e4855 = phi_4009_;
                            let _e4857 = phi_4010_;
                            phi_4012_ = _e4855;
                            phi_4013_ = _e4850;
                            phi_4014_ = _e4857;
                        } else {
                            phi_4012_ = type_72();
                            phi_4013_ = type_72(0u, type_72().member_1);
                            phi_4014_ = true;
                        }
                        let _e4859 = phi_4012_;
                        let _e4861 = phi_4013_;
                        let _e4863 = phi_4014_;
                        if _e4863 {
                            phi_4018_ = _e4861;
                        } else {
                            phi_4018_ = _e4859;
                        }
                        let _e4865 = phi_4018_;
                        phi_7320_ = _e4865;
                    } else {
                        if (_e543 < 0.0lf) {
                            phi_4029_ = -(_e543);
                        } else {
                            phi_4029_ = _e543;
                        }
                        let _e898 = phi_4029_;
                        if (_e566 < 0.0lf) {
                            phi_4035_ = -(_e566);
                        } else {
                            phi_4035_ = _e566;
                        }
                        let _e902 = phi_4035_;
                        if (_e898 > _e902) {
                            phi_4040_ = _e898;
                        } else {
                            phi_4040_ = _e902;
                        }
                        let _e905 = phi_4040_;
                        if (_e589 < 0.0lf) {
                            phi_4046_ = -(_e589);
                        } else {
                            phi_4046_ = _e589;
                        }
                        let _e909 = phi_4046_;
                        if (_e600 < 0.0lf) {
                            phi_4052_ = -(_e600);
                        } else {
                            phi_4052_ = _e600;
                        }
                        let _e913 = phi_4052_;
                        if (_e909 > _e913) {
                            phi_4057_ = _e909;
                        } else {
                            phi_4057_ = _e913;
                        }
                        let _e916 = phi_4057_;
                        if (_e905 > _e916) {
                            phi_4062_ = _e905;
                        } else {
                            phi_4062_ = _e916;
                        }
                        let _e919 = phi_4062_;
                        let _e923 = ((_e859 * f64(0.34f)) + (_e919 * (1.1102230246251565e-16lf * f64(256f))));
                        let _e924 = f64(0f);
                        let _e925 = f64(1f);
                        let _e926 = f64(3f);
                        let _e928 = (_e566 - (_e926 * _e543));
                        let _e929 = (_e589 - _e566);
                        let _e931 = ((_e926 * _e600) - _e589);
                        local_7[0u] = _e924;
                        local_7[1u] = _e925;
                        local_7[2u] = _e925;
                        local_7[3u] = _e925;
                        let _e938 = ((_e929 * _e929) - (_e928 * _e931));
                        if (_e938 > _e924) {
                            if (_e938 <= 2.2250738585072014e-308lf) {
                                if (_e938 > 0.0lf) {
                                    phi_4099_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4099_ = 0.0lf;
                                }
                                let _e997 = phi_4099_;
                                phi_4163_ = _e997;
                            } else {
                                phi_4106_ = type_26(0i, 5i);
                                phi_4109_ = bitcast<f64>(((bitcast<u64>(_e938) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e946 = phi_4106_;
                                    let _e948 = phi_4109_;
                                    local_21 = _e948;
                                    if (_e946.member < _e946.member_1) {
                                        let _e956 = (_e946.member + 1i);
                                        if ((false == (_e956 > _e946.member)) != false) {
                                            phi_4130_ = true;
                                        } else {
                                            phi_4130_ = false;
                                        }
                                        let _e961 = phi_4130_;
                                        if _e961 {
                                            phi_4136_ = type_27(0u, type_27().member_1);
                                        } else {
                                            phi_4136_ = type_27(1u, _e956);
                                        }
                                        let _e967 = phi_4136_;
                                        if (bitcast<i32>(_e967.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_4107_ = type_26(_e967.member_1, _e946.member_1);
                                        phi_4150_ = type_27(1u, _e946.member);
                                    } else {
                                        phi_4107_ = _e946;
                                        phi_4150_ = type_27(0u, type_27().member_1);
                                    }
                                    let _e977 = phi_4107_;
                                    let _e979 = phi_4150_;
                                    let _e982 = (bitcast<i32>(_e979.member) != 0i);
                                    if _e982 {
                                        phi_4110_ = (0.5lf * (_e948 + (_e938 / _e948)));
                                    } else {
                                        phi_4110_ = f64();
                                    }
                                    let _e987 = phi_4110_;
                                    continue;
                                    continuing {
                                        phi_4106_ = _e977;
                                        phi_4109_ = _e987;
                                        break if !(_e982);
                                    }
                                }
                                let _e992 = local_21;
                                phi_4163_ = (_e992 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e999 = phi_4163_;
                            if (_e929 < _e924) {
                                phi_4169_ = -(_e999);
                            } else {
                                phi_4169_ = _e999;
                            }
                            let _e1003 = phi_4169_;
                            let _e1005 = -((_e929 + _e1003));
                            local_8[0u] = (_e1005 / (_e1005 + _e931));
                            local_8[1u] = (_e928 / (_e928 + _e1005));
                            let _e1014 = local_8[1u];
                            let _e1015 = local_8[0u];
                            if (_e1014 < _e1015) {
                                let _e1018 = local_8[1u];
                                let _e1020 = local_8[0u];
                                local_8[0u] = _e1018;
                                local_8[1u] = _e1020;
                            }
                            phi_4194_ = type_28(0u, 2u);
                            phi_4197_ = 1u;
                            loop {
                                let _e1024 = phi_4194_;
                                let _e1026 = phi_4197_;
                                local_49 = _e1026;
                                if (_e1024.member < _e1024.member_1) {
                                    phi_4195_ = type_28((_e1024.member + 1u), _e1024.member_1);
                                    phi_4220_ = type_28(1u, _e1024.member);
                                } else {
                                    phi_4195_ = _e1024;
                                    phi_4220_ = type_28(0u, type_28().member_1);
                                }
                                let _e1040 = phi_4195_;
                                let _e1042 = phi_4220_;
                                let _e1046 = (bitcast<i32>(_e1042.member) != 0i);
                                if _e1046 {
                                    if (_e1042.member_1 < 2u) {
                                    } else {
                                        return;
                                    }
                                    let _e1049 = local_8[_e1042.member_1];
                                    if (_e1049 > _e924) {
                                        if (_e1042.member_1 < 2u) {
                                        } else {
                                            return;
                                        }
                                        let _e1053 = local_8[_e1042.member_1];
                                        if (_e1053 < _e925) {
                                            if (_e1042.member_1 < 2u) {
                                            } else {
                                                return;
                                            }
                                            let _e1057 = local_8[_e1042.member_1];
                                            if (_e1026 < 4u) {
                                            } else {
                                                return;
                                            }
                                            local_7[_e1026] = _e1057;
                                            phi_4264_ = (_e1026 + 1u);
                                        } else {
                                            phi_4264_ = _e1026;
                                        }
                                        let _e1062 = phi_4264_;
                                        phi_4265_ = _e1062;
                                    } else {
                                        phi_4265_ = _e1026;
                                    }
                                    let _e1064 = phi_4265_;
                                    phi_4198_ = _e1064;
                                } else {
                                    phi_4198_ = u32();
                                }
                                let _e1066 = phi_4198_;
                                continue;
                                continuing {
                                    phi_4194_ = _e1040;
                                    phi_4197_ = _e1066;
                                    break if !(_e1046);
                                }
                            }
                            let _e5057 = local_49;
                            phi_4266_ = _e5057;
                        } else {
                            phi_4266_ = 1u;
                        }
                        let _e1069 = phi_4266_;
                        if (_e1069 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e1069] = _e925;
                        let _e1072 = local_7;
                        local_9 = _e1072;
                        phi_4286_ = type_28(0u, _e1069);
                        loop {
                            let _e1075 = phi_4286_;
                            if (_e1075.member < _e1075.member_1) {
                                phi_4287_ = type_28((_e1075.member + 1u), _e1075.member_1);
                                phi_4310_ = type_28(1u, _e1075.member);
                            } else {
                                phi_4287_ = _e1075;
                                phi_4310_ = type_28(0u, type_28().member_1);
                            }
                            let _e1089 = phi_4287_;
                            let _e1091 = phi_4310_;
                            if (bitcast<i32>(_e1091.member) != 0i) {
                                if (_e1091.member_1 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1098 = local_9[_e1091.member_1];
                                let _e1099 = (_e1091.member_1 + 1u);
                                if (_e1099 < 4u) {
                                } else {
                                    return;
                                }
                                let _e1102 = local_9[_e1099];
                                let _e1104 = (f64(1f) - _e1098);
                                let _e1115 = ((((_e543 * _e1104) + (_e566 * _e1098)) * (_e1104 * _e1104)) + (((_e589 * _e1104) + (_e600 * _e1098)) * (_e1098 * _e1098)));
                                let _e1117 = (f64(1f) - _e1102);
                                let _e1128 = ((((_e543 * _e1117) + (_e566 * _e1102)) * (_e1117 * _e1117)) + (((_e589 * _e1117) + (_e600 * _e1102)) * (_e1102 * _e1102)));
                                if (_e1115 < 0.0lf) {
                                    phi_4364_ = -(_e1115);
                                } else {
                                    phi_4364_ = _e1115;
                                }
                                let _e1132 = phi_4364_;
                                let _e1133 = (_e1132 > _e923);
                                if (_e1128 < 0.0lf) {
                                    phi_4371_ = -(_e1128);
                                } else {
                                    phi_4371_ = _e1128;
                                }
                                let _e1137 = phi_4371_;
                                let _e1138 = (_e1137 > _e923);
                                let _e1139 = f64(0f);
                                if _e1133 {
                                    if _e1138 {
                                        phi_4383_ = ((_e1115 > _e1139) != (_e1128 > _e1139));
                                        phi_4384_ = false;
                                    } else {
                                        phi_4383_ = bool();
                                        phi_4384_ = true;
                                    }
                                    let _e1144 = phi_4383_;
                                    let _e1146 = phi_4384_;
                                    phi_4385_ = _e1144;
                                    phi_4386_ = _e1146;
                                } else {
                                    phi_4385_ = bool();
                                    phi_4386_ = true;
                                }
                                let _e1148 = phi_4385_;
                                let _e1150 = phi_4386_;
                                if _e1150 {
                                    phi_4390_ = false;
                                } else {
                                    phi_4390_ = _e1148;
                                }
                                let _e1152 = phi_4390_;
                                if _e1133 {
                                    if _e1138 {
                                        if _e1152 {
                                            phi_4402_ = type_73();
                                        } else {
                                            phi_4402_ = type_73(f64(1f), _e1139, _e1152);
                                        }
                                        let _e1156 = phi_4402_;
                                        phi_4403_ = _e1156;
                                        phi_4404_ = _e1152;
                                    } else {
                                        phi_4403_ = type_73();
                                        phi_4404_ = true;
                                    }
                                    let _e1158 = phi_4403_;
                                    let _e1160 = phi_4404_;
                                    phi_4405_ = _e1158;
                                    phi_4406_ = _e1160;
                                } else {
                                    phi_4405_ = type_73();
                                    phi_4406_ = true;
                                }
                                let _e1162 = phi_4405_;
                                let _e1164 = phi_4406_;
                                if _e1164 {
                                    if _e1133 {
                                        if (_e1115 < _e1139) {
                                            phi_4419_ = f64(-1f);
                                        } else {
                                            phi_4419_ = f64(1f);
                                        }
                                        let _e1169 = phi_4419_;
                                        let _e1170 = f64(0.00000000000022737368f);
                                        let _e1171 = f64(0.5f);
                                        let _e1172 = f64(3f);
                                        let _e1175 = (_e589 - _e566);
                                        phi_4432_ = type_28(0u, 64u);
                                        phi_4435_ = _e1102;
                                        phi_4437_ = _e1098;
                                        phi_4439_ = (_e1171 * (_e1098 + _e1102));
                                        loop {
                                            let _e1181 = phi_4432_;
                                            let _e1183 = phi_4435_;
                                            let _e1185 = phi_4437_;
                                            let _e1187 = phi_4439_;
                                            local_51 = _e1185;
                                            if (_e1181.member < _e1181.member_1) {
                                                phi_4433_ = type_28((_e1181.member + 1u), _e1181.member_1);
                                                phi_4462_ = type_28(1u, _e1181.member);
                                            } else {
                                                phi_4433_ = _e1181;
                                                phi_4462_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1201 = phi_4433_;
                                            let _e1203 = phi_4462_;
                                            if (bitcast<i32>(_e1203.member) != 0i) {
                                                let _e1208 = (f64(1f) - _e1187);
                                                let _e1221 = ((_e1169 * ((((_e543 * _e1208) + (_e566 * _e1187)) * (_e1208 * _e1208)) + (((_e589 * _e1208) + (_e600 * _e1187)) * (_e1187 * _e1187)))) - _e923);
                                                if (_e1221 > f64(0f)) {
                                                    phi_4489_ = _e1183;
                                                    phi_4490_ = _e1187;
                                                } else {
                                                    phi_4489_ = _e1187;
                                                    phi_4490_ = _e1185;
                                                }
                                                let _e1225 = phi_4489_;
                                                let _e1227 = phi_4490_;
                                                let _e1229 = ((_e1225 - _e1227) > _e1170);
                                                if _e1229 {
                                                    let _e1231 = (f64(1f) - _e1187);
                                                    let _e1243 = (-(_e1221) / (_e1169 * (((((_e566 - (_e1172 * _e543)) * _e1231) + (_e1175 * _e1187)) * _e1231) + (((_e1175 * _e1231) + (((_e1172 * _e600) - _e589) * _e1187)) * _e1187))));
                                                    if (_e1221 > f64(0f)) {
                                                        phi_4518_ = (_e1171 * _e1170);
                                                    } else {
                                                        phi_4518_ = -((_e1171 * _e1170));
                                                    }
                                                    let _e1250 = phi_4518_;
                                                    let _e1252 = ((_e1187 + _e1243) + _e1250);
                                                    if (_e1252 > _e1227) {
                                                        if (_e1252 < _e1225) {
                                                            if (_e1243 < 0.0lf) {
                                                                phi_4534_ = -(_e1243);
                                                            } else {
                                                                phi_4534_ = _e1243;
                                                            }
                                                            let _e1258 = phi_4534_;
                                                            if (_e1258 < (_e1171 * (_e1225 - _e1227))) {
                                                                phi_4541_ = false;
                                                            } else {
                                                                phi_4541_ = true;
                                                            }
                                                            let _e1263 = phi_4541_;
                                                            phi_4542_ = _e1263;
                                                        } else {
                                                            phi_4542_ = true;
                                                        }
                                                        let _e1265 = phi_4542_;
                                                        phi_4543_ = _e1265;
                                                    } else {
                                                        phi_4543_ = true;
                                                    }
                                                    let _e1267 = phi_4543_;
                                                    if _e1267 {
                                                        phi_4549_ = (_e1171 * (_e1227 + _e1225));
                                                    } else {
                                                        phi_4549_ = _e1252;
                                                    }
                                                    let _e1271 = phi_4549_;
                                                    phi_4550_ = _e1271;
                                                    phi_4551_ = false;
                                                } else {
                                                    phi_4550_ = f64();
                                                    phi_4551_ = true;
                                                }
                                                let _e1273 = phi_4550_;
                                                let _e1275 = phi_4551_;
                                                phi_4436_ = _e1225;
                                                phi_4438_ = _e1227;
                                                phi_4440_ = _e1273;
                                                phi_4552_ = _e1227;
                                                phi_4553_ = _e1229;
                                                phi_4554_ = _e1275;
                                            } else {
                                                phi_4436_ = f64();
                                                phi_4438_ = f64();
                                                phi_4440_ = f64();
                                                phi_4552_ = f64();
                                                phi_4553_ = false;
                                                phi_4554_ = false;
                                            }
                                            let _e1277 = phi_4436_;
                                            let _e1279 = phi_4438_;
                                            let _e1281 = phi_4440_;
                                            let _e1283 = phi_4552_;
                                            let _e1285 = phi_4553_;
                                            let _e1287 = phi_4554_;
                                            local_22 = _e1287;
                                            local_50 = _e1283;
                                            continue;
                                            continuing {
                                                phi_4432_ = _e1201;
                                                phi_4435_ = _e1277;
                                                phi_4437_ = _e1279;
                                                phi_4439_ = _e1281;
                                                break if !(_e1285);
                                            }
                                        }
                                        let _e1290 = local_22;
                                        if _e1290 {
                                            let _e5099 = local_50;
                                            phi_4558_ = _e5099;
                                        } else {
                                            let _e5101 = local_51;
                                            phi_4558_ = _e5101;
                                        }
                                        let _e1292 = phi_4558_;
                                        phi_4559_ = _e1292;
                                    } else {
                                        phi_4559_ = _e1098;
                                    }
                                    let _e1294 = phi_4559_;
                                    if _e1138 {
                                        phi_4567_ = type_28(0u, 64u);
                                        phi_4570_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1298 = phi_4567_;
                                            let _e1300 = phi_4570_;
                                            if (_e1298.member < _e1298.member_1) {
                                                phi_4568_ = type_28((_e1298.member + 1u), _e1298.member_1);
                                                phi_4593_ = type_28(1u, _e1298.member);
                                            } else {
                                                phi_4568_ = _e1298;
                                                phi_4593_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1314 = phi_4568_;
                                            let _e1316 = phi_4593_;
                                            if (bitcast<i32>(_e1316.member) != 0i) {
                                                let _e1320 = (_e1294 + _e1300);
                                                if (_e1320 < _e1102) {
                                                    let _e1323 = (f64(1f) - _e1320);
                                                    let _e1334 = ((((_e543 * _e1323) + (_e566 * _e1320)) * (_e1323 * _e1323)) + (((_e589 * _e1323) + (_e600 * _e1320)) * (_e1320 * _e1320)));
                                                    let _e1336 = (f64(1f) - _e1294);
                                                    let _e1347 = ((((_e543 * _e1336) + (_e566 * _e1294)) * (_e1336 * _e1336)) + (((_e589 * _e1336) + (_e600 * _e1294)) * (_e1294 * _e1294)));
                                                    if (_e1334 < 0.0lf) {
                                                        phi_4636_ = -(_e1334);
                                                    } else {
                                                        phi_4636_ = _e1334;
                                                    }
                                                    let _e1351 = phi_4636_;
                                                    if (_e1351 > _e923) {
                                                        if (_e1347 < 0.0lf) {
                                                            phi_4646_ = -(_e1347);
                                                        } else {
                                                            phi_4646_ = _e1347;
                                                        }
                                                        let _e1356 = phi_4646_;
                                                        if (_e1356 > _e923) {
                                                            phi_4656_ = ((_e1334 > f64(0f)) == (_e1347 > f64(0f)));
                                                        } else {
                                                            phi_4656_ = false;
                                                        }
                                                        let _e1364 = phi_4656_;
                                                        phi_4658_ = !(_e1364);
                                                    } else {
                                                        phi_4658_ = false;
                                                    }
                                                    let _e1367 = phi_4658_;
                                                    if _e1367 {
                                                        phi_4663_ = f64();
                                                        phi_4664_ = false;
                                                    } else {
                                                        phi_4663_ = (_e1300 + _e1300);
                                                        phi_4664_ = true;
                                                    }
                                                    let _e1370 = phi_4663_;
                                                    let _e1372 = phi_4664_;
                                                    phi_4665_ = _e1370;
                                                    phi_4666_ = _e1372;
                                                    phi_4667_ = _e1367;
                                                    phi_4668_ = false;
                                                } else {
                                                    phi_4665_ = f64();
                                                    phi_4666_ = false;
                                                    phi_4667_ = false;
                                                    phi_4668_ = true;
                                                }
                                                let _e1374 = phi_4665_;
                                                let _e1376 = phi_4666_;
                                                let _e1378 = phi_4667_;
                                                let _e1380 = phi_4668_;
                                                phi_4669_ = _e1320;
                                                phi_4571_ = _e1374;
                                                phi_4670_ = _e1376;
                                                phi_4671_ = _e1378;
                                                phi_4672_ = _e1380;
                                                phi_4673_ = false;
                                            } else {
                                                phi_4669_ = f64();
                                                phi_4571_ = f64();
                                                phi_4670_ = false;
                                                phi_4671_ = false;
                                                phi_4672_ = false;
                                                phi_4673_ = true;
                                            }
                                            let _e1382 = phi_4669_;
                                            let _e1384 = phi_4571_;
                                            let _e1386 = phi_4670_;
                                            let _e1388 = phi_4671_;
                                            let _e1390 = phi_4672_;
                                            let _e1392 = phi_4673_;
                                            local_23 = _e1388;
                                            local_52 = _e1390;
                                            local_53 = _e1392;
                                            local_54 = _e1382;
                                            continue;
                                            continuing {
                                                phi_4567_ = _e1314;
                                                phi_4570_ = _e1384;
                                                break if !(_e1386);
                                            }
                                        }
                                        let _e1395 = local_23;
                                        if _e1395 {
                                            phi_4677_ = false;
                                            phi_4678_ = false;
                                        } else {
                                            let _e5126 = local_52;
                                            phi_4677_ = _e5126;
                                            let _e5129 = local_53;
                                            phi_4678_ = _e5129;
                                        }
                                        let _e1397 = phi_4677_;
                                        let _e1399 = phi_4678_;
                                        if _e1397 {
                                            phi_4682_ = true;
                                        } else {
                                            phi_4682_ = _e1399;
                                        }
                                        let _e1401 = phi_4682_;
                                        if _e1401 {
                                            phi_4686_ = _e1102;
                                        } else {
                                            let _e5133 = local_54;
                                            phi_4686_ = _e5133;
                                        }
                                        let _e1403 = phi_4686_;
                                        phi_4687_ = _e1403;
                                    } else {
                                        phi_4687_ = _e1102;
                                    }
                                    let _e1405 = phi_4687_;
                                    phi_4689_ = type_73(_e1294, _e1405, _e1152);
                                } else {
                                    phi_4689_ = _e1162;
                                }
                                let _e1408 = phi_4689_;
                                if (_e1408.member > _e1408.member_1) {
                                    phi_7276_ = f64();
                                    phi_7277_ = true;
                                    phi_7278_ = false;
                                    phi_7279_ = false;
                                    phi_7280_ = false;
                                } else {
                                    let _e1416 = ((_e1408.member_1 - _e1408.member) * f64(0.5f));
                                    let _e1417 = (_e1408.member + _e1416);
                                    let _e1420 = (_e1416 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1422 = local_20.member_3;
                                    let _e1425 = local_20.member[0u];
                                    if (_e1425[0] < 0.0lf) {
                                        phi_4720_ = -(_e1425[0]);
                                    } else {
                                        phi_4720_ = _e1425[0];
                                    }
                                    let _e1432 = phi_4720_;
                                    if (_e1425[1] < 0.0lf) {
                                        phi_4727_ = -(_e1425[1]);
                                    } else {
                                        phi_4727_ = _e1425[1];
                                    }
                                    let _e1436 = phi_4727_;
                                    if (_e1432 > _e1436) {
                                        phi_4732_ = _e1432;
                                    } else {
                                        phi_4732_ = _e1436;
                                    }
                                    let _e1439 = phi_4732_;
                                    if (_e1425[2] < 0.0lf) {
                                        phi_4739_ = -(_e1425[2]);
                                    } else {
                                        phi_4739_ = _e1425[2];
                                    }
                                    let _e1443 = phi_4739_;
                                    if (_e1439 > _e1443) {
                                        phi_4744_ = _e1439;
                                    } else {
                                        phi_4744_ = _e1443;
                                    }
                                    let _e1446 = phi_4744_;
                                    let _e1448 = local_20.member[1u];
                                    if (_e1448[0] < 0.0lf) {
                                        phi_4757_ = -(_e1448[0]);
                                    } else {
                                        phi_4757_ = _e1448[0];
                                    }
                                    let _e1455 = phi_4757_;
                                    if (_e1448[1] < 0.0lf) {
                                        phi_4764_ = -(_e1448[1]);
                                    } else {
                                        phi_4764_ = _e1448[1];
                                    }
                                    let _e1459 = phi_4764_;
                                    if (_e1455 > _e1459) {
                                        phi_4769_ = _e1455;
                                    } else {
                                        phi_4769_ = _e1459;
                                    }
                                    let _e1462 = phi_4769_;
                                    if (_e1448[2] < 0.0lf) {
                                        phi_4776_ = -(_e1448[2]);
                                    } else {
                                        phi_4776_ = _e1448[2];
                                    }
                                    let _e1466 = phi_4776_;
                                    if (_e1462 > _e1466) {
                                        phi_4781_ = _e1462;
                                    } else {
                                        phi_4781_ = _e1466;
                                    }
                                    let _e1469 = phi_4781_;
                                    if (_e1446 > _e1469) {
                                        phi_4786_ = _e1446;
                                    } else {
                                        phi_4786_ = _e1469;
                                    }
                                    let _e1472 = phi_4786_;
                                    let _e1475 = local_20.member[0u];
                                    let _e1480 = local_20.member[1u];
                                    let _e1490 = (_e1475[0] + ((_e1480[0] - _e1475[0]) * _e1417));
                                    let _e1491 = (_e1475[1] + ((_e1480[1] - _e1475[1]) * _e1417));
                                    let _e1492 = (_e1475[2] + ((_e1480[2] - _e1475[2]) * _e1417));
                                    let _e1494 = local_20.member[1u];
                                    let _e1499 = local_20.member[0u];
                                    let _e1503 = (_e1494[0] - _e1499[0]);
                                    let _e1504 = (_e1494[1] - _e1499[1]);
                                    let _e1505 = (_e1494[2] - _e1499[2]);
                                    if (_e1503 < 0.0lf) {
                                        phi_4845_ = -(_e1503);
                                    } else {
                                        phi_4845_ = _e1503;
                                    }
                                    let _e1509 = phi_4845_;
                                    if (_e1504 < 0.0lf) {
                                        phi_4851_ = -(_e1504);
                                    } else {
                                        phi_4851_ = _e1504;
                                    }
                                    let _e1513 = phi_4851_;
                                    if (_e1509 > _e1513) {
                                        phi_4856_ = _e1509;
                                    } else {
                                        phi_4856_ = _e1513;
                                    }
                                    let _e1516 = phi_4856_;
                                    if (_e1505 < 0.0lf) {
                                        phi_4862_ = -(_e1505);
                                    } else {
                                        phi_4862_ = _e1505;
                                    }
                                    let _e1520 = phi_4862_;
                                    if (_e1516 > _e1520) {
                                        phi_4867_ = _e1516;
                                    } else {
                                        phi_4867_ = _e1520;
                                    }
                                    let _e1523 = phi_4867_;
                                    let _e1531 = ((((_e1420 * _e1523) * f64(1.01f)) + ((_e1472 + _e1422) * (1.1102230246251565e-16lf * f64(8f)))) + _e1422);
                                    if (_e1490 < 0.0lf) {
                                        phi_4881_ = -(_e1490);
                                    } else {
                                        phi_4881_ = _e1490;
                                    }
                                    let _e1535 = phi_4881_;
                                    if (_e1491 < 0.0lf) {
                                        phi_4887_ = -(_e1491);
                                    } else {
                                        phi_4887_ = _e1491;
                                    }
                                    let _e1539 = phi_4887_;
                                    if (_e1535 > _e1539) {
                                        phi_4892_ = _e1535;
                                    } else {
                                        phi_4892_ = _e1539;
                                    }
                                    let _e1542 = phi_4892_;
                                    if (_e1492 < 0.0lf) {
                                        phi_4898_ = -(_e1492);
                                    } else {
                                        phi_4898_ = _e1492;
                                    }
                                    let _e1546 = phi_4898_;
                                    if (_e1542 > _e1546) {
                                        phi_4903_ = _e1542;
                                    } else {
                                        phi_4903_ = _e1546;
                                    }
                                    let _e1549 = phi_4903_;
                                    local_3 = type_51(array<f64, 3>(_e1490, _e1491, _e1492), _e1531, (_e1549 + _e1531));
                                    let _e1555 = local_20.member_3;
                                    let _e1557 = local_20.member_1[0u];
                                    if (_e1557[0] < 0.0lf) {
                                        phi_4929_ = -(_e1557[0]);
                                    } else {
                                        phi_4929_ = _e1557[0];
                                    }
                                    let _e1564 = phi_4929_;
                                    if (_e1557[1] < 0.0lf) {
                                        phi_4936_ = -(_e1557[1]);
                                    } else {
                                        phi_4936_ = _e1557[1];
                                    }
                                    let _e1568 = phi_4936_;
                                    if (_e1564 > _e1568) {
                                        phi_4941_ = _e1564;
                                    } else {
                                        phi_4941_ = _e1568;
                                    }
                                    let _e1571 = phi_4941_;
                                    if (_e1557[2] < 0.0lf) {
                                        phi_4948_ = -(_e1557[2]);
                                    } else {
                                        phi_4948_ = _e1557[2];
                                    }
                                    let _e1575 = phi_4948_;
                                    if (_e1571 > _e1575) {
                                        phi_4953_ = _e1571;
                                    } else {
                                        phi_4953_ = _e1575;
                                    }
                                    let _e1578 = phi_4953_;
                                    let _e1580 = local_20.member_1[1u];
                                    if (_e1580[0] < 0.0lf) {
                                        phi_4966_ = -(_e1580[0]);
                                    } else {
                                        phi_4966_ = _e1580[0];
                                    }
                                    let _e1587 = phi_4966_;
                                    if (_e1580[1] < 0.0lf) {
                                        phi_4973_ = -(_e1580[1]);
                                    } else {
                                        phi_4973_ = _e1580[1];
                                    }
                                    let _e1591 = phi_4973_;
                                    if (_e1587 > _e1591) {
                                        phi_4978_ = _e1587;
                                    } else {
                                        phi_4978_ = _e1591;
                                    }
                                    let _e1594 = phi_4978_;
                                    if (_e1580[2] < 0.0lf) {
                                        phi_4985_ = -(_e1580[2]);
                                    } else {
                                        phi_4985_ = _e1580[2];
                                    }
                                    let _e1598 = phi_4985_;
                                    if (_e1594 > _e1598) {
                                        phi_4990_ = _e1594;
                                    } else {
                                        phi_4990_ = _e1598;
                                    }
                                    let _e1601 = phi_4990_;
                                    if (_e1578 > _e1601) {
                                        phi_4995_ = _e1578;
                                    } else {
                                        phi_4995_ = _e1601;
                                    }
                                    let _e1604 = phi_4995_;
                                    let _e1607 = local_20.member_1[0u];
                                    let _e1612 = local_20.member_1[1u];
                                    let _e1622 = (_e1607[0] + ((_e1612[0] - _e1607[0]) * _e1417));
                                    let _e1623 = (_e1607[1] + ((_e1612[1] - _e1607[1]) * _e1417));
                                    let _e1624 = (_e1607[2] + ((_e1612[2] - _e1607[2]) * _e1417));
                                    let _e1626 = local_20.member_1[1u];
                                    let _e1631 = local_20.member_1[0u];
                                    let _e1635 = (_e1626[0] - _e1631[0]);
                                    let _e1636 = (_e1626[1] - _e1631[1]);
                                    let _e1637 = (_e1626[2] - _e1631[2]);
                                    if (_e1635 < 0.0lf) {
                                        phi_5054_ = -(_e1635);
                                    } else {
                                        phi_5054_ = _e1635;
                                    }
                                    let _e1641 = phi_5054_;
                                    if (_e1636 < 0.0lf) {
                                        phi_5060_ = -(_e1636);
                                    } else {
                                        phi_5060_ = _e1636;
                                    }
                                    let _e1645 = phi_5060_;
                                    if (_e1641 > _e1645) {
                                        phi_5065_ = _e1641;
                                    } else {
                                        phi_5065_ = _e1645;
                                    }
                                    let _e1648 = phi_5065_;
                                    if (_e1637 < 0.0lf) {
                                        phi_5071_ = -(_e1637);
                                    } else {
                                        phi_5071_ = _e1637;
                                    }
                                    let _e1652 = phi_5071_;
                                    if (_e1648 > _e1652) {
                                        phi_5076_ = _e1648;
                                    } else {
                                        phi_5076_ = _e1652;
                                    }
                                    let _e1655 = phi_5076_;
                                    let _e1663 = ((((_e1420 * _e1655) * f64(1.01f)) + ((_e1604 + _e1555) * (1.1102230246251565e-16lf * f64(8f)))) + _e1555);
                                    if (_e1622 < 0.0lf) {
                                        phi_5090_ = -(_e1622);
                                    } else {
                                        phi_5090_ = _e1622;
                                    }
                                    let _e1667 = phi_5090_;
                                    if (_e1623 < 0.0lf) {
                                        phi_5096_ = -(_e1623);
                                    } else {
                                        phi_5096_ = _e1623;
                                    }
                                    let _e1671 = phi_5096_;
                                    if (_e1667 > _e1671) {
                                        phi_5101_ = _e1667;
                                    } else {
                                        phi_5101_ = _e1671;
                                    }
                                    let _e1674 = phi_5101_;
                                    if (_e1624 < 0.0lf) {
                                        phi_5107_ = -(_e1624);
                                    } else {
                                        phi_5107_ = _e1624;
                                    }
                                    let _e1678 = phi_5107_;
                                    if (_e1674 > _e1678) {
                                        phi_5112_ = _e1674;
                                    } else {
                                        phi_5112_ = _e1678;
                                    }
                                    let _e1681 = phi_5112_;
                                    local_4 = type_51(array<f64, 3>(_e1622, _e1623, _e1624), _e1663, (_e1681 + _e1663));
                                    let _e1687 = local_20.member_3;
                                    let _e1689 = local_20.member_2[0u];
                                    if (_e1689[0] < 0.0lf) {
                                        phi_5138_ = -(_e1689[0]);
                                    } else {
                                        phi_5138_ = _e1689[0];
                                    }
                                    let _e1696 = phi_5138_;
                                    if (_e1689[1] < 0.0lf) {
                                        phi_5145_ = -(_e1689[1]);
                                    } else {
                                        phi_5145_ = _e1689[1];
                                    }
                                    let _e1700 = phi_5145_;
                                    if (_e1696 > _e1700) {
                                        phi_5150_ = _e1696;
                                    } else {
                                        phi_5150_ = _e1700;
                                    }
                                    let _e1703 = phi_5150_;
                                    if (_e1689[2] < 0.0lf) {
                                        phi_5157_ = -(_e1689[2]);
                                    } else {
                                        phi_5157_ = _e1689[2];
                                    }
                                    let _e1707 = phi_5157_;
                                    if (_e1703 > _e1707) {
                                        phi_5162_ = _e1703;
                                    } else {
                                        phi_5162_ = _e1707;
                                    }
                                    let _e1710 = phi_5162_;
                                    let _e1712 = local_20.member_2[1u];
                                    if (_e1712[0] < 0.0lf) {
                                        phi_5175_ = -(_e1712[0]);
                                    } else {
                                        phi_5175_ = _e1712[0];
                                    }
                                    let _e1719 = phi_5175_;
                                    if (_e1712[1] < 0.0lf) {
                                        phi_5182_ = -(_e1712[1]);
                                    } else {
                                        phi_5182_ = _e1712[1];
                                    }
                                    let _e1723 = phi_5182_;
                                    if (_e1719 > _e1723) {
                                        phi_5187_ = _e1719;
                                    } else {
                                        phi_5187_ = _e1723;
                                    }
                                    let _e1726 = phi_5187_;
                                    if (_e1712[2] < 0.0lf) {
                                        phi_5194_ = -(_e1712[2]);
                                    } else {
                                        phi_5194_ = _e1712[2];
                                    }
                                    let _e1730 = phi_5194_;
                                    if (_e1726 > _e1730) {
                                        phi_5199_ = _e1726;
                                    } else {
                                        phi_5199_ = _e1730;
                                    }
                                    let _e1733 = phi_5199_;
                                    if (_e1710 > _e1733) {
                                        phi_5204_ = _e1710;
                                    } else {
                                        phi_5204_ = _e1733;
                                    }
                                    let _e1736 = phi_5204_;
                                    let _e1739 = local_20.member_2[0u];
                                    let _e1744 = local_20.member_2[1u];
                                    let _e1754 = (_e1739[0] + ((_e1744[0] - _e1739[0]) * _e1417));
                                    let _e1755 = (_e1739[1] + ((_e1744[1] - _e1739[1]) * _e1417));
                                    let _e1756 = (_e1739[2] + ((_e1744[2] - _e1739[2]) * _e1417));
                                    let _e1758 = local_20.member_2[1u];
                                    let _e1763 = local_20.member_2[0u];
                                    let _e1767 = (_e1758[0] - _e1763[0]);
                                    let _e1768 = (_e1758[1] - _e1763[1]);
                                    let _e1769 = (_e1758[2] - _e1763[2]);
                                    if (_e1767 < 0.0lf) {
                                        phi_5263_ = -(_e1767);
                                    } else {
                                        phi_5263_ = _e1767;
                                    }
                                    let _e1773 = phi_5263_;
                                    if (_e1768 < 0.0lf) {
                                        phi_5269_ = -(_e1768);
                                    } else {
                                        phi_5269_ = _e1768;
                                    }
                                    let _e1777 = phi_5269_;
                                    if (_e1773 > _e1777) {
                                        phi_5274_ = _e1773;
                                    } else {
                                        phi_5274_ = _e1777;
                                    }
                                    let _e1780 = phi_5274_;
                                    if (_e1769 < 0.0lf) {
                                        phi_5280_ = -(_e1769);
                                    } else {
                                        phi_5280_ = _e1769;
                                    }
                                    let _e1784 = phi_5280_;
                                    if (_e1780 > _e1784) {
                                        phi_5285_ = _e1780;
                                    } else {
                                        phi_5285_ = _e1784;
                                    }
                                    let _e1787 = phi_5285_;
                                    let _e1795 = ((((_e1420 * _e1787) * f64(1.01f)) + ((_e1736 + _e1687) * (1.1102230246251565e-16lf * f64(8f)))) + _e1687);
                                    if (_e1754 < 0.0lf) {
                                        phi_5299_ = -(_e1754);
                                    } else {
                                        phi_5299_ = _e1754;
                                    }
                                    let _e1799 = phi_5299_;
                                    if (_e1755 < 0.0lf) {
                                        phi_5305_ = -(_e1755);
                                    } else {
                                        phi_5305_ = _e1755;
                                    }
                                    let _e1803 = phi_5305_;
                                    if (_e1799 > _e1803) {
                                        phi_5310_ = _e1799;
                                    } else {
                                        phi_5310_ = _e1803;
                                    }
                                    let _e1806 = phi_5310_;
                                    if (_e1756 < 0.0lf) {
                                        phi_5316_ = -(_e1756);
                                    } else {
                                        phi_5316_ = _e1756;
                                    }
                                    let _e1810 = phi_5316_;
                                    if (_e1806 > _e1810) {
                                        phi_5321_ = _e1806;
                                    } else {
                                        phi_5321_ = _e1810;
                                    }
                                    let _e1813 = phi_5321_;
                                    local_5 = type_51(array<f64, 3>(_e1754, _e1755, _e1756), _e1795, (_e1813 + _e1795));
                                    let _e1818 = local_4.member;
                                    let _e1823 = local_5.member;
                                    let _e1829 = ((_e1818[1] * _e1823[2]) - (_e1818[2] * _e1823[1]));
                                    let _e1832 = ((_e1818[2] * _e1823[0]) - (_e1818[0] * _e1823[2]));
                                    let _e1835 = ((_e1818[0] * _e1823[1]) - (_e1818[1] * _e1823[0]));
                                    if (_e1829 < 0.0lf) {
                                        phi_5370_ = -(_e1829);
                                    } else {
                                        phi_5370_ = _e1829;
                                    }
                                    let _e1839 = phi_5370_;
                                    if (_e1832 < 0.0lf) {
                                        phi_5376_ = -(_e1832);
                                    } else {
                                        phi_5376_ = _e1832;
                                    }
                                    let _e1843 = phi_5376_;
                                    if (_e1839 > _e1843) {
                                        if (_e1829 < 0.0lf) {
                                            phi_5386_ = -(_e1829);
                                        } else {
                                            phi_5386_ = _e1829;
                                        }
                                        let _e1861 = phi_5386_;
                                        if (_e1835 < 0.0lf) {
                                            phi_5392_ = -(_e1835);
                                        } else {
                                            phi_5392_ = _e1835;
                                        }
                                        let _e1865 = phi_5392_;
                                        if (_e1861 > _e1865) {
                                            phi_5397_ = 2u;
                                            phi_5398_ = 1u;
                                        } else {
                                            phi_5397_ = 1u;
                                            phi_5398_ = 0u;
                                        }
                                        let _e1868 = phi_5397_;
                                        let _e1870 = phi_5398_;
                                        phi_5417_ = _e1868;
                                        phi_5418_ = _e1870;
                                    } else {
                                        if (_e1832 < 0.0lf) {
                                            phi_5404_ = -(_e1832);
                                        } else {
                                            phi_5404_ = _e1832;
                                        }
                                        let _e1848 = phi_5404_;
                                        if (_e1835 < 0.0lf) {
                                            phi_5410_ = -(_e1835);
                                        } else {
                                            phi_5410_ = _e1835;
                                        }
                                        let _e1852 = phi_5410_;
                                        if (_e1848 > _e1852) {
                                            phi_5415_ = 0u;
                                            phi_5416_ = 2u;
                                        } else {
                                            phi_5415_ = 1u;
                                            phi_5416_ = 0u;
                                        }
                                        let _e1855 = phi_5415_;
                                        let _e1857 = phi_5416_;
                                        phi_5417_ = _e1855;
                                        phi_5418_ = _e1857;
                                    }
                                    let _e1872 = phi_5417_;
                                    let _e1874 = phi_5418_;
                                    if (_e1874 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1878 = local_4.member[_e1874];
                                    if (_e1872 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1882 = local_5.member[_e1872];
                                    if (_e1872 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1887 = local_4.member[_e1872];
                                    if (_e1874 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1891 = local_5.member[_e1874];
                                    let _e1893 = ((_e1878 * _e1882) - (_e1887 * _e1891));
                                    let _e1894 = f64(1f);
                                    let _e1896 = local_4.member_1;
                                    let _e1898 = local_5.member_2;
                                    let _e1901 = local_4.member_2;
                                    let _e1903 = local_5.member_1;
                                    let _e1909 = local_4.member_2;
                                    let _e1911 = local_5.member_2;
                                    let _e1920 = local_4.member_2;
                                    let _e1923 = local_5.member_2;
                                    let _e1927 = (((((_e1896 * _e1898) + (_e1901 * _e1903)) * f64(2.01f)) + ((_e1909 * _e1911) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1894 + _e1920) * (_e1894 + _e1923))));
                                    if (_e1893 < 0.0lf) {
                                        phi_5489_ = -(_e1893);
                                    } else {
                                        phi_5489_ = _e1893;
                                    }
                                    let _e1931 = phi_5489_;
                                    if (_e1931 > _e1927) {
                                        if (_e1893 < f64(0f)) {
                                            phi_5501_ = f64(-1f);
                                        } else {
                                            phi_5501_ = f64(1f);
                                        }
                                        let _e1938 = phi_5501_;
                                        if (_e1874 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1942 = local_3.member[_e1874];
                                        if (_e1872 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1946 = local_5.member[_e1872];
                                        if (_e1872 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1951 = local_3.member[_e1872];
                                        if (_e1874 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1955 = local_5.member[_e1874];
                                        let _e1958 = f64(1f);
                                        let _e1960 = local_3.member_1;
                                        let _e1962 = local_5.member_2;
                                        let _e1965 = local_3.member_2;
                                        let _e1967 = local_5.member_1;
                                        let _e1973 = local_3.member_2;
                                        let _e1975 = local_5.member_2;
                                        let _e1984 = local_3.member_2;
                                        let _e1987 = local_5.member_2;
                                        let _e1991 = (((((_e1960 * _e1962) + (_e1965 * _e1967)) * f64(2.01f)) + ((_e1973 * _e1975) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1958 + _e1984) * (_e1958 + _e1987))));
                                        if (_e1874 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1995 = local_4.member[_e1874];
                                        if (_e1872 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1999 = local_3.member[_e1872];
                                        if (_e1872 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2004 = local_4.member[_e1872];
                                        if (_e1874 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e2008 = local_3.member[_e1874];
                                        let _e2011 = f64(1f);
                                        let _e2013 = local_4.member_1;
                                        let _e2015 = local_3.member_2;
                                        let _e2018 = local_4.member_2;
                                        let _e2020 = local_3.member_1;
                                        let _e2026 = local_4.member_2;
                                        let _e2028 = local_3.member_2;
                                        let _e2037 = local_4.member_2;
                                        let _e2040 = local_3.member_2;
                                        let _e2044 = (((((_e2013 * _e2015) + (_e2018 * _e2020)) * f64(2.01f)) + ((_e2026 * _e2028) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2011 + _e2037) * (_e2011 + _e2040))));
                                        let _e2045 = (_e1893 * _e1938);
                                        let _e2046 = (((_e1942 * _e1946) - (_e1951 * _e1955)) * _e1938);
                                        let _e2047 = (((_e1995 * _e1999) - (_e2004 * _e2008)) * _e1938);
                                        if (_e2045 < 0.0lf) {
                                            phi_5640_ = -(_e2045);
                                        } else {
                                            phi_5640_ = _e2045;
                                        }
                                        let _e2051 = phi_5640_;
                                        if (_e2046 < 0.0lf) {
                                            phi_5646_ = -(_e2046);
                                        } else {
                                            phi_5646_ = _e2046;
                                        }
                                        let _e2055 = phi_5646_;
                                        if (_e2047 < 0.0lf) {
                                            phi_5653_ = -(_e2047);
                                        } else {
                                            phi_5653_ = _e2047;
                                        }
                                        let _e2060 = phi_5653_;
                                        let _e2064 = (((_e2051 + _e2055) + _e2060) * (1.1102230246251565e-16lf * f64(4f)));
                                        local_6[0u].member = _e2046;
                                        local_6[0u].member_1 = _e1991;
                                        local_6[1u].member = _e2047;
                                        local_6[1u].member_1 = _e2044;
                                        local_6[2u].member = (_e2045 - _e2046);
                                        local_6[2u].member_1 = ((_e1927 + _e1991) + _e2064);
                                        local_6[3u].member = (_e2045 - _e2047);
                                        local_6[3u].member_1 = ((_e1927 + _e2044) + _e2064);
                                        phi_5697_ = type_28(0u, 4u);
                                        phi_5700_ = true;
                                        loop {
                                            let _e2085 = phi_5697_;
                                            let _e2087 = phi_5700_;
                                            local_25 = _e2087;
                                            if (_e2085.member < _e2085.member_1) {
                                                phi_5698_ = type_28((_e2085.member + 1u), _e2085.member_1);
                                                phi_5723_ = type_28(1u, _e2085.member);
                                            } else {
                                                phi_5698_ = _e2085;
                                                phi_5723_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e2101 = phi_5698_;
                                            let _e2103 = phi_5723_;
                                            if (bitcast<i32>(_e2103.member) != 0i) {
                                                if (_e2103.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e2111 = local_6[_e2103.member_1].member;
                                                let _e2114 = local_6[_e2103.member_1].member_1;
                                                let _e2116 = (_e2111 < -(_e2114));
                                                if _e2116 {
                                                    phi_5750_ = bool();
                                                    phi_5751_ = false;
                                                } else {
                                                    phi_5750_ = (_e2087 && (_e2111 > _e2114));
                                                    phi_5751_ = true;
                                                }
                                                let _e2120 = phi_5750_;
                                                let _e2122 = phi_5751_;
                                                phi_5701_ = _e2120;
                                                phi_5752_ = _e2122;
                                                phi_5753_ = _e2116;
                                            } else {
                                                phi_5701_ = bool();
                                                phi_5752_ = false;
                                                phi_5753_ = false;
                                            }
                                            let _e2124 = phi_5701_;
                                            let _e2126 = phi_5752_;
                                            let _e2128 = phi_5753_;
                                            local_24 = _e2128;
                                            continue;
                                            continuing {
                                                phi_5697_ = _e2101;
                                                phi_5700_ = _e2124;
                                                break if !(_e2126);
                                            }
                                        }
                                        let _e2131 = local_24;
                                        if _e2131 {
                                            phi_5757_ = false;
                                        } else {
                                            phi_5757_ = true;
                                        }
                                        let _e2133 = phi_5757_;
                                        if _e2133 {
                                            let _e2135 = local_25;
                                            if _e2135 {
                                                phi_5764_ = 1u;
                                            } else {
                                                phi_5764_ = 2u;
                                            }
                                            let _e2137 = phi_5764_;
                                            phi_5765_ = _e2137;
                                            phi_5766_ = false;
                                        } else {
                                            phi_5765_ = u32();
                                            phi_5766_ = true;
                                        }
                                        let _e2139 = phi_5765_;
                                        let _e2141 = phi_5766_;
                                        phi_5767_ = _e2139;
                                        phi_5768_ = 0u;
                                        phi_5769_ = _e2141;
                                    } else {
                                        phi_5767_ = u32();
                                        phi_5768_ = 2u;
                                        phi_5769_ = true;
                                    }
                                    let _e2143 = phi_5767_;
                                    let _e2145 = phi_5768_;
                                    let _e2147 = phi_5769_;
                                    if _e2147 {
                                        phi_5773_ = _e2145;
                                    } else {
                                        phi_5773_ = _e2143;
                                    }
                                    let _e2149 = phi_5773_;
                                    let _e2150 = (_e2149 == 0u);
                                    if _e2150 {
                                        phi_7272_ = f64();
                                        phi_7273_ = false;
                                        phi_7274_ = false;
                                        phi_7275_ = false;
                                    } else {
                                        if (_e2149 == 1u) {
                                            if _e1408.member_2 {
                                                if ((_e1408.member_1 - _e1408.member) <= f64(0.0000005f)) {
                                                    phi_5794_ = false;
                                                } else {
                                                    phi_5794_ = true;
                                                }
                                                let _e2159 = phi_5794_;
                                                phi_5795_ = _e2159;
                                            } else {
                                                phi_5795_ = true;
                                            }
                                            let _e2161 = phi_5795_;
                                            phi_5796_ = _e2161;
                                        } else {
                                            phi_5796_ = true;
                                        }
                                        let _e2163 = phi_5796_;
                                        if _e2163 {
                                            let _e2169 = local_20.member[0u];
                                            let _e2175 = local_20.member_1[0u];
                                            let _e2181 = local_20.member_2[0u];
                                            let _e2185 = (_e2169[0] - _e2175[0]);
                                            let _e2186 = (_e2169[1] - _e2175[1]);
                                            let _e2187 = (_e2169[2] - _e2175[2]);
                                            local_1 = array<array<f64, 3>, 4>(_e2169, array<f64, 3>(_e2185, _e2186, _e2187), array<f64, 3>((_e2169[0] - _e2181[0]), (_e2169[1] - _e2181[1]), (_e2169[2] - _e2181[2])), array<f64, 3>((_e2185 - _e2181[0]), (_e2186 - _e2181[1]), (_e2187 - _e2181[2])));
                                            let _e2200 = local_20.member[1u];
                                            let _e2206 = local_20.member_1[1u];
                                            let _e2212 = local_20.member_2[1u];
                                            let _e2216 = (_e2200[0] - _e2206[0]);
                                            let _e2217 = (_e2200[1] - _e2206[1]);
                                            let _e2218 = (_e2200[2] - _e2206[2]);
                                            local_2 = array<array<f64, 3>, 4>(_e2200, array<f64, 3>(_e2216, _e2217, _e2218), array<f64, 3>((_e2200[0] - _e2212[0]), (_e2200[1] - _e2212[1]), (_e2200[2] - _e2212[2])), array<f64, 3>((_e2216 - _e2212[0]), (_e2217 - _e2212[1]), (_e2218 - _e2212[2])));
                                            let _e2231 = local_20.member[0u];
                                            if (_e2231[0] < 0.0lf) {
                                                phi_5993_ = -(_e2231[0]);
                                            } else {
                                                phi_5993_ = _e2231[0];
                                            }
                                            let _e2238 = phi_5993_;
                                            if (_e2231[1] < 0.0lf) {
                                                phi_6000_ = -(_e2231[1]);
                                            } else {
                                                phi_6000_ = _e2231[1];
                                            }
                                            let _e2242 = phi_6000_;
                                            if (_e2238 > _e2242) {
                                                phi_6005_ = _e2238;
                                            } else {
                                                phi_6005_ = _e2242;
                                            }
                                            let _e2245 = phi_6005_;
                                            if (_e2231[2] < 0.0lf) {
                                                phi_6012_ = -(_e2231[2]);
                                            } else {
                                                phi_6012_ = _e2231[2];
                                            }
                                            let _e2249 = phi_6012_;
                                            if (_e2245 > _e2249) {
                                                phi_6017_ = _e2245;
                                            } else {
                                                phi_6017_ = _e2249;
                                            }
                                            let _e2252 = phi_6017_;
                                            let _e2255 = local_20.member[1u];
                                            if (_e2255[0] < 0.0lf) {
                                                phi_6030_ = -(_e2255[0]);
                                            } else {
                                                phi_6030_ = _e2255[0];
                                            }
                                            let _e2262 = phi_6030_;
                                            if (_e2255[1] < 0.0lf) {
                                                phi_6037_ = -(_e2255[1]);
                                            } else {
                                                phi_6037_ = _e2255[1];
                                            }
                                            let _e2266 = phi_6037_;
                                            if (_e2262 > _e2266) {
                                                phi_6042_ = _e2262;
                                            } else {
                                                phi_6042_ = _e2266;
                                            }
                                            let _e2269 = phi_6042_;
                                            if (_e2255[2] < 0.0lf) {
                                                phi_6049_ = -(_e2255[2]);
                                            } else {
                                                phi_6049_ = _e2255[2];
                                            }
                                            let _e2273 = phi_6049_;
                                            if (_e2269 > _e2273) {
                                                phi_6054_ = _e2269;
                                            } else {
                                                phi_6054_ = _e2273;
                                            }
                                            let _e2276 = phi_6054_;
                                            if (_e2252 > _e2276) {
                                                phi_6059_ = _e2252;
                                            } else {
                                                phi_6059_ = _e2276;
                                            }
                                            let _e2279 = phi_6059_;
                                            let _e2281 = local_20.member_3;
                                            let _e2285 = local_20.member_1[0u];
                                            if (_e2285[0] < 0.0lf) {
                                                phi_6076_ = -(_e2285[0]);
                                            } else {
                                                phi_6076_ = _e2285[0];
                                            }
                                            let _e2292 = phi_6076_;
                                            if (_e2285[1] < 0.0lf) {
                                                phi_6083_ = -(_e2285[1]);
                                            } else {
                                                phi_6083_ = _e2285[1];
                                            }
                                            let _e2296 = phi_6083_;
                                            if (_e2292 > _e2296) {
                                                phi_6088_ = _e2292;
                                            } else {
                                                phi_6088_ = _e2296;
                                            }
                                            let _e2299 = phi_6088_;
                                            if (_e2285[2] < 0.0lf) {
                                                phi_6095_ = -(_e2285[2]);
                                            } else {
                                                phi_6095_ = _e2285[2];
                                            }
                                            let _e2303 = phi_6095_;
                                            if (_e2299 > _e2303) {
                                                phi_6100_ = _e2299;
                                            } else {
                                                phi_6100_ = _e2303;
                                            }
                                            let _e2306 = phi_6100_;
                                            let _e2309 = local_20.member_1[1u];
                                            if (_e2309[0] < 0.0lf) {
                                                phi_6114_ = -(_e2309[0]);
                                            } else {
                                                phi_6114_ = _e2309[0];
                                            }
                                            let _e2316 = phi_6114_;
                                            if (_e2309[1] < 0.0lf) {
                                                phi_6121_ = -(_e2309[1]);
                                            } else {
                                                phi_6121_ = _e2309[1];
                                            }
                                            let _e2320 = phi_6121_;
                                            if (_e2316 > _e2320) {
                                                phi_6126_ = _e2316;
                                            } else {
                                                phi_6126_ = _e2320;
                                            }
                                            let _e2323 = phi_6126_;
                                            if (_e2309[2] < 0.0lf) {
                                                phi_6133_ = -(_e2309[2]);
                                            } else {
                                                phi_6133_ = _e2309[2];
                                            }
                                            let _e2327 = phi_6133_;
                                            if (_e2323 > _e2327) {
                                                phi_6138_ = _e2323;
                                            } else {
                                                phi_6138_ = _e2327;
                                            }
                                            let _e2330 = phi_6138_;
                                            if (_e2306 > _e2330) {
                                                phi_6143_ = _e2306;
                                            } else {
                                                phi_6143_ = _e2330;
                                            }
                                            let _e2333 = phi_6143_;
                                            let _e2335 = local_20.member_3;
                                            let _e2339 = local_20.member_2[0u];
                                            if (_e2339[0] < 0.0lf) {
                                                phi_6160_ = -(_e2339[0]);
                                            } else {
                                                phi_6160_ = _e2339[0];
                                            }
                                            let _e2346 = phi_6160_;
                                            if (_e2339[1] < 0.0lf) {
                                                phi_6167_ = -(_e2339[1]);
                                            } else {
                                                phi_6167_ = _e2339[1];
                                            }
                                            let _e2350 = phi_6167_;
                                            if (_e2346 > _e2350) {
                                                phi_6172_ = _e2346;
                                            } else {
                                                phi_6172_ = _e2350;
                                            }
                                            let _e2353 = phi_6172_;
                                            if (_e2339[2] < 0.0lf) {
                                                phi_6179_ = -(_e2339[2]);
                                            } else {
                                                phi_6179_ = _e2339[2];
                                            }
                                            let _e2357 = phi_6179_;
                                            if (_e2353 > _e2357) {
                                                phi_6184_ = _e2353;
                                            } else {
                                                phi_6184_ = _e2357;
                                            }
                                            let _e2360 = phi_6184_;
                                            let _e2363 = local_20.member_2[1u];
                                            if (_e2363[0] < 0.0lf) {
                                                phi_6198_ = -(_e2363[0]);
                                            } else {
                                                phi_6198_ = _e2363[0];
                                            }
                                            let _e2370 = phi_6198_;
                                            if (_e2363[1] < 0.0lf) {
                                                phi_6205_ = -(_e2363[1]);
                                            } else {
                                                phi_6205_ = _e2363[1];
                                            }
                                            let _e2374 = phi_6205_;
                                            if (_e2370 > _e2374) {
                                                phi_6210_ = _e2370;
                                            } else {
                                                phi_6210_ = _e2374;
                                            }
                                            let _e2377 = phi_6210_;
                                            if (_e2363[2] < 0.0lf) {
                                                phi_6217_ = -(_e2363[2]);
                                            } else {
                                                phi_6217_ = _e2363[2];
                                            }
                                            let _e2381 = phi_6217_;
                                            if (_e2377 > _e2381) {
                                                phi_6222_ = _e2377;
                                            } else {
                                                phi_6222_ = _e2381;
                                            }
                                            let _e2384 = phi_6222_;
                                            if (_e2360 > _e2384) {
                                                phi_6227_ = _e2360;
                                            } else {
                                                phi_6227_ = _e2384;
                                            }
                                            let _e2387 = phi_6227_;
                                            let _e2389 = local_20.member_3;
                                            let _e2397 = local_20.member_3;
                                            phi_6247_ = type_28(0u, 48u);
                                            phi_6250_ = _e1408.member;
                                            loop {
                                                let _e2406 = phi_6247_;
                                                let _e2408 = phi_6250_;
                                                local_65 = _e2408;
                                                local_32 = _e2408;
                                                local_33 = _e2408;
                                                local_34 = _e2408;
                                                if (_e2406.member < _e2406.member_1) {
                                                    phi_6248_ = type_28((_e2406.member + 1u), _e2406.member_1);
                                                    phi_6273_ = type_28(1u, _e2406.member);
                                                } else {
                                                    phi_6248_ = _e2406;
                                                    phi_6273_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e2422 = phi_6248_;
                                                let _e2424 = phi_6273_;
                                                if (bitcast<i32>(_e2424.member) != 0i) {
                                                    let _e2430 = local_20.member[0u];
                                                    let _e2436 = local_20.member[1u];
                                                    let _e2446 = (_e2430[0] + ((_e2436[0] - _e2430[0]) * _e2408));
                                                    let _e2447 = (_e2430[1] + ((_e2436[1] - _e2430[1]) * _e2408));
                                                    let _e2448 = (_e2430[2] + ((_e2436[2] - _e2430[2]) * _e2408));
                                                    let _e2451 = local_20.member_1[0u];
                                                    let _e2457 = local_20.member_1[1u];
                                                    let _e2467 = (_e2451[0] + ((_e2457[0] - _e2451[0]) * _e2408));
                                                    let _e2468 = (_e2451[1] + ((_e2457[1] - _e2451[1]) * _e2408));
                                                    let _e2469 = (_e2451[2] + ((_e2457[2] - _e2451[2]) * _e2408));
                                                    let _e2472 = local_20.member_2[0u];
                                                    let _e2478 = local_20.member_2[1u];
                                                    let _e2488 = (_e2472[0] + ((_e2478[0] - _e2472[0]) * _e2408));
                                                    let _e2489 = (_e2472[1] + ((_e2478[1] - _e2472[1]) * _e2408));
                                                    let _e2490 = (_e2472[2] + ((_e2478[2] - _e2472[2]) * _e2408));
                                                    let _e2495 = (((_e2467 * _e2467) + (_e2468 * _e2468)) + (_e2469 * _e2469));
                                                    let _e2500 = (((_e2467 * _e2488) + (_e2468 * _e2489)) + (_e2469 * _e2490));
                                                    let _e2505 = (((_e2488 * _e2488) + (_e2489 * _e2489)) + (_e2490 * _e2490));
                                                    let _e2510 = (((_e2446 * _e2467) + (_e2447 * _e2468)) + (_e2448 * _e2469));
                                                    let _e2515 = (((_e2446 * _e2488) + (_e2447 * _e2489)) + (_e2448 * _e2490));
                                                    let _e2518 = ((_e2495 * _e2505) - (_e2500 * _e2500));
                                                    let _e2519 = f64(0f);
                                                    let _e2520 = f64(1f);
                                                    let _e2524 = (((_e2510 * _e2505) - (_e2515 * _e2500)) / _e2518);
                                                    let _e2528 = (((_e2515 * _e2495) - (_e2510 * _e2500)) / _e2518);
                                                    if (_e2524 >= _e2519) {
                                                        if (_e2528 >= _e2519) {
                                                            if (_e2524 <= _e2520) {
                                                                phi_6429_ = (_e2528 <= _e2520);
                                                                phi_6430_ = false;
                                                            } else {
                                                                phi_6429_ = bool();
                                                                phi_6430_ = true;
                                                            }
                                                            let _e2534 = phi_6429_;
                                                            let _e2536 = phi_6430_;
                                                            phi_6431_ = _e2534;
                                                            phi_6432_ = _e2536;
                                                        } else {
                                                            phi_6431_ = bool();
                                                            phi_6432_ = true;
                                                        }
                                                        let _e2538 = phi_6431_;
                                                        let _e2540 = phi_6432_;
                                                        phi_6433_ = _e2538;
                                                        phi_6434_ = _e2540;
                                                    } else {
                                                        phi_6433_ = bool();
                                                        phi_6434_ = true;
                                                    }
                                                    let _e2542 = phi_6433_;
                                                    let _e2544 = phi_6434_;
                                                    if _e2544 {
                                                        phi_6438_ = false;
                                                    } else {
                                                        phi_6438_ = _e2542;
                                                    }
                                                    let _e2546 = phi_6438_;
                                                    if (_e2518 > _e2519) {
                                                        if _e2546 {
                                                            phi_6478_ = array<f64, 3>((_e2446 - ((_e2467 * _e2524) + (_e2488 * _e2528))), (_e2447 - ((_e2468 * _e2524) + (_e2489 * _e2528))), (_e2448 - ((_e2469 * _e2524) + (_e2490 * _e2528))));
                                                            phi_6479_ = false;
                                                        } else {
                                                            phi_6478_ = array<f64, 3>();
                                                            phi_6479_ = true;
                                                        }
                                                        let _e2562 = phi_6478_;
                                                        let _e2564 = phi_6479_;
                                                        phi_6480_ = _e2562;
                                                        phi_6481_ = _e2564;
                                                    } else {
                                                        phi_6480_ = array<f64, 3>();
                                                        phi_6481_ = true;
                                                    }
                                                    let _e2566 = phi_6480_;
                                                    let _e2568 = phi_6481_;
                                                    if _e2568 {
                                                        let _e2569 = (_e2446 - _e2467);
                                                        let _e2570 = (_e2447 - _e2468);
                                                        let _e2571 = (_e2448 - _e2469);
                                                        let _e2582 = ((((_e2446 * _e2467) + (_e2447 * _e2468)) + (_e2448 * _e2469)) / (((_e2467 * _e2467) + (_e2468 * _e2468)) + (_e2469 * _e2469)));
                                                        if (_e2582 > f64(0f)) {
                                                            if (_e2582 < f64(1f)) {
                                                                phi_6514_ = _e2582;
                                                            } else {
                                                                phi_6514_ = f64(1f);
                                                            }
                                                            let _e2590 = phi_6514_;
                                                            phi_6516_ = _e2590;
                                                        } else {
                                                            phi_6516_ = f64(0f);
                                                        }
                                                        let _e2592 = phi_6516_;
                                                        let _e2609 = ((((_e2446 * _e2488) + (_e2447 * _e2489)) + (_e2448 * _e2490)) / (((_e2488 * _e2488) + (_e2489 * _e2489)) + (_e2490 * _e2490)));
                                                        if (_e2609 > f64(0f)) {
                                                            if (_e2609 < f64(1f)) {
                                                                phi_6546_ = _e2609;
                                                            } else {
                                                                phi_6546_ = f64(1f);
                                                            }
                                                            let _e2617 = phi_6546_;
                                                            phi_6548_ = _e2617;
                                                        } else {
                                                            phi_6548_ = f64(0f);
                                                        }
                                                        let _e2619 = phi_6548_;
                                                        let _e2636 = ((((_e2569 * _e2488) + (_e2570 * _e2489)) + (_e2571 * _e2490)) / (((_e2488 * _e2488) + (_e2489 * _e2489)) + (_e2490 * _e2490)));
                                                        if (_e2636 > f64(0f)) {
                                                            if (_e2636 < f64(1f)) {
                                                                phi_6578_ = _e2636;
                                                            } else {
                                                                phi_6578_ = f64(1f);
                                                            }
                                                            let _e2644 = phi_6578_;
                                                            phi_6580_ = _e2644;
                                                        } else {
                                                            phi_6580_ = f64(0f);
                                                        }
                                                        let _e2646 = phi_6580_;
                                                        let _e2653 = (_e2446 - _e2488);
                                                        let _e2654 = (_e2447 - _e2489);
                                                        let _e2655 = (_e2448 - _e2490);
                                                        let _e2666 = ((((_e2653 * _e2467) + (_e2654 * _e2468)) + (_e2655 * _e2469)) / (((_e2467 * _e2467) + (_e2468 * _e2468)) + (_e2469 * _e2469)));
                                                        if (_e2666 > f64(0f)) {
                                                            if (_e2666 < f64(1f)) {
                                                                phi_6613_ = _e2666;
                                                            } else {
                                                                phi_6613_ = f64(1f);
                                                            }
                                                            let _e2674 = phi_6613_;
                                                            phi_6615_ = _e2674;
                                                        } else {
                                                            phi_6615_ = f64(0f);
                                                        }
                                                        let _e2676 = phi_6615_;
                                                        local[0u] = array<f64, 3>((_e2446 - (_e2467 * _e2592)), (_e2447 - (_e2468 * _e2592)), (_e2448 - (_e2469 * _e2592)));
                                                        local[1u] = array<f64, 3>((_e2446 - (_e2488 * _e2619)), (_e2447 - (_e2489 * _e2619)), (_e2448 - (_e2490 * _e2619)));
                                                        local[2u] = array<f64, 3>((_e2569 - (_e2488 * _e2646)), (_e2570 - (_e2489 * _e2646)), (_e2571 - (_e2490 * _e2646)));
                                                        local[3u] = array<f64, 3>((_e2653 - (_e2467 * _e2676)), (_e2654 - (_e2468 * _e2676)), (_e2655 - (_e2469 * _e2676)));
                                                        let _e2692 = local[0u];
                                                        phi_6770_ = type_28(1u, 4u);
                                                        phi_6773_ = array<f64, 3>(_e2692[0], _e2692[1], _e2692[2]);
                                                        loop {
                                                            let _e2698 = phi_6770_;
                                                            let _e2700 = phi_6773_;
                                                            local_55 = _e2700;
                                                            if (_e2698.member < _e2698.member_1) {
                                                                phi_6771_ = type_28((_e2698.member + 1u), _e2698.member_1);
                                                                phi_6796_ = type_28(1u, _e2698.member);
                                                            } else {
                                                                phi_6771_ = _e2698;
                                                                phi_6796_ = type_28(0u, type_28().member_1);
                                                            }
                                                            let _e2714 = phi_6771_;
                                                            let _e2716 = phi_6796_;
                                                            let _e2720 = (bitcast<i32>(_e2716.member) != 0i);
                                                            if _e2720 {
                                                                if (_e2716.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2723 = local[_e2716.member_1];
                                                                if (_e2716.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2729 = local[_e2716.member_1];
                                                                if ((((_e2723[0] * _e2729[0]) + (_e2723[1] * _e2729[1])) + (_e2723[2] * _e2729[2])) < (((_e2700[0] * _e2700[0]) + (_e2700[1] * _e2700[1])) + (_e2700[2] * _e2700[2]))) {
                                                                    if (_e2716.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2752 = local[_e2716.member_1];
                                                                    phi_6863_ = array<f64, 3>(_e2752[0], _e2752[1], _e2752[2]);
                                                                } else {
                                                                    phi_6863_ = _e2700;
                                                                }
                                                                let _e2758 = phi_6863_;
                                                                phi_6774_ = _e2758;
                                                            } else {
                                                                phi_6774_ = array<f64, 3>();
                                                            }
                                                            let _e2760 = phi_6774_;
                                                            continue;
                                                            continuing {
                                                                phi_6770_ = _e2714;
                                                                phi_6773_ = _e2760;
                                                                break if !(_e2720);
                                                            }
                                                        }
                                                        let _e5302 = local_55;
                                                        phi_6864_ = _e5302;
                                                    } else {
                                                        phi_6864_ = _e2566;
                                                    }
                                                    let _e2763 = phi_6864_;
                                                    if (_e2763[0] < 0.0lf) {
                                                        phi_6871_ = -(_e2763[0]);
                                                    } else {
                                                        phi_6871_ = _e2763[0];
                                                    }
                                                    let _e2768 = phi_6871_;
                                                    if (_e2763[1] < 0.0lf) {
                                                        phi_6878_ = -(_e2763[1]);
                                                    } else {
                                                        phi_6878_ = _e2763[1];
                                                    }
                                                    let _e2773 = phi_6878_;
                                                    if (_e2763[2] < 0.0lf) {
                                                        phi_6886_ = -(_e2763[2]);
                                                    } else {
                                                        phi_6886_ = _e2763[2];
                                                    }
                                                    let _e2779 = phi_6886_;
                                                    let _e2780 = ((_e2768 + _e2773) + _e2779);
                                                    if (_e2780 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2780) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2786 = (f64(1f) / _e2780);
                                                            let _e2788 = (_e2763[0] * _e2786);
                                                            let _e2790 = (_e2763[1] * _e2786);
                                                            let _e2792 = (_e2763[2] * _e2786);
                                                            let _e2797 = (((_e2788 * _e2788) + (_e2790 * _e2790)) + (_e2792 * _e2792));
                                                            if (_e2797 <= 2.2250738585072014e-308lf) {
                                                                if (_e2797 > 0.0lf) {
                                                                    phi_6924_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_6924_ = 0.0lf;
                                                                }
                                                                let _e2855 = phi_6924_;
                                                                phi_6988_ = _e2855;
                                                            } else {
                                                                phi_6931_ = type_26(0i, 5i);
                                                                phi_6934_ = bitcast<f64>(((bitcast<u64>(_e2797) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2804 = phi_6931_;
                                                                    let _e2806 = phi_6934_;
                                                                    local_26 = _e2806;
                                                                    if (_e2804.member < _e2804.member_1) {
                                                                        let _e2814 = (_e2804.member + 1i);
                                                                        if ((false == (_e2814 > _e2804.member)) != false) {
                                                                            phi_6955_ = true;
                                                                        } else {
                                                                            phi_6955_ = false;
                                                                        }
                                                                        let _e2819 = phi_6955_;
                                                                        if _e2819 {
                                                                            phi_6961_ = type_27(0u, type_27().member_1);
                                                                        } else {
                                                                            phi_6961_ = type_27(1u, _e2814);
                                                                        }
                                                                        let _e2825 = phi_6961_;
                                                                        if (bitcast<i32>(_e2825.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_6932_ = type_26(_e2825.member_1, _e2804.member_1);
                                                                        phi_6975_ = type_27(1u, _e2804.member);
                                                                    } else {
                                                                        phi_6932_ = _e2804;
                                                                        phi_6975_ = type_27(0u, type_27().member_1);
                                                                    }
                                                                    let _e2835 = phi_6932_;
                                                                    let _e2837 = phi_6975_;
                                                                    let _e2840 = (bitcast<i32>(_e2837.member) != 0i);
                                                                    if _e2840 {
                                                                        phi_6935_ = (0.5lf * (_e2806 + (_e2797 / _e2806)));
                                                                    } else {
                                                                        phi_6935_ = f64();
                                                                    }
                                                                    let _e2845 = phi_6935_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6931_ = _e2835;
                                                                        phi_6934_ = _e2845;
                                                                        break if !(_e2840);
                                                                    }
                                                                }
                                                                let _e2850 = local_26;
                                                                phi_6988_ = (_e2850 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2857 = phi_6988_;
                                                            phi_7001_ = type_28(0u, 4u);
                                                            phi_7004_ = f64(2f);
                                                            loop {
                                                                let _e2869 = phi_7001_;
                                                                let _e2871 = phi_7004_;
                                                                local_28 = _e2871;
                                                                local_29 = _e2871;
                                                                local_30 = _e2871;
                                                                local_56 = _e2871;
                                                                local_57 = _e2871;
                                                                if (_e2869.member < _e2869.member_1) {
                                                                    phi_7002_ = type_28((_e2869.member + 1u), _e2869.member_1);
                                                                    phi_7027_ = type_28(1u, _e2869.member);
                                                                } else {
                                                                    phi_7002_ = _e2869;
                                                                    phi_7027_ = type_28(0u, type_28().member_1);
                                                                }
                                                                let _e2885 = phi_7002_;
                                                                let _e2887 = phi_7027_;
                                                                if (bitcast<i32>(_e2887.member) != 0i) {
                                                                    if (_e2887.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2894 = local_1[_e2887.member_1];
                                                                    let _e2902 = (((_e2788 * _e2894[0]) + (_e2790 * _e2894[1])) + (_e2792 * _e2894[2]));
                                                                    if (_e2887.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2905 = local_2[_e2887.member_1];
                                                                    let _e2913 = (((_e2788 * _e2905[0]) + (_e2790 * _e2905[1])) + (_e2792 * _e2905[2]));
                                                                    if (_e2902 < 0.0lf) {
                                                                        phi_7078_ = -(_e2902);
                                                                    } else {
                                                                        phi_7078_ = _e2902;
                                                                    }
                                                                    let _e2917 = phi_7078_;
                                                                    if (_e2913 < 0.0lf) {
                                                                        phi_7084_ = -(_e2913);
                                                                    } else {
                                                                        phi_7084_ = _e2913;
                                                                    }
                                                                    let _e2921 = phi_7084_;
                                                                    let _e2926 = (((((((((_e2279 + _e2281) + (_e2333 + _e2335)) + (_e2387 + _e2389)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2397 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2857) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2917 + _e2921) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2902 > _e2926) {
                                                                        if (_e2913 > _e2926) {
                                                                            phi_7098_ = false;
                                                                        } else {
                                                                            phi_7098_ = true;
                                                                        }
                                                                        let _e2930 = phi_7098_;
                                                                        phi_7099_ = _e2930;
                                                                    } else {
                                                                        phi_7099_ = true;
                                                                    }
                                                                    let _e2932 = phi_7099_;
                                                                    if _e2932 {
                                                                        let _e2936 = ((_e2902 + ((_e2913 - _e2902) * _e2408)) > _e2926);
                                                                        if _e2936 {
                                                                            if (_e2913 < _e2902) {
                                                                                let _e2945 = (((_e2902 - _e2926) / (_e2902 - _e2913)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                if (_e2871 < _e2945) {
                                                                                    phi_7126_ = _e2871;
                                                                                } else {
                                                                                    phi_7126_ = _e2945;
                                                                                }
                                                                                let _e2948 = phi_7126_;
                                                                                phi_7127_ = _e2948;
                                                                            } else {
                                                                                phi_7127_ = _e2871;
                                                                            }
                                                                            let _e2950 = phi_7127_;
                                                                            phi_7128_ = _e2950;
                                                                        } else {
                                                                            phi_7128_ = f64();
                                                                        }
                                                                        let _e2952 = phi_7128_;
                                                                        phi_7129_ = _e2952;
                                                                        phi_7130_ = _e2936;
                                                                    } else {
                                                                        phi_7129_ = _e2871;
                                                                        phi_7130_ = true;
                                                                    }
                                                                    let _e2954 = phi_7129_;
                                                                    let _e2956 = phi_7130_;
                                                                    phi_7005_ = _e2954;
                                                                    phi_7131_ = _e2956;
                                                                    phi_7132_ = false;
                                                                } else {
                                                                    phi_7005_ = f64();
                                                                    phi_7131_ = false;
                                                                    phi_7132_ = true;
                                                                }
                                                                let _e2958 = phi_7005_;
                                                                let _e2960 = phi_7131_;
                                                                let _e2962 = phi_7132_;
                                                                local_27 = _e2962;
                                                                continue;
                                                                continuing {
                                                                    phi_7001_ = _e2885;
                                                                    phi_7004_ = _e2958;
                                                                    break if !(_e2960);
                                                                }
                                                            }
                                                            let _e2965 = local_27;
                                                            if _e2965 {
                                                                let _e2967 = local_28;
                                                                let _e2968 = (_e2967 > _e1408.member_1);
                                                                if _e2968 {
                                                                    phi_7154_ = false;
                                                                    phi_7155_ = false;
                                                                    phi_7156_ = false;
                                                                } else {
                                                                    let _e2970 = local_29;
                                                                    if (_e2970 > _e2408) {
                                                                        let _e2973 = local_30;
                                                                        let _e2976 = ((_e2973 - _e2408) < f64(0.00000000023283064f));
                                                                        if _e2976 {
                                                                            phi_7150_ = false;
                                                                        } else {
                                                                            phi_7150_ = true;
                                                                        }
                                                                        let _e2978 = phi_7150_;
                                                                        phi_7151_ = _e2978;
                                                                        phi_7152_ = _e2976;
                                                                        phi_7153_ = false;
                                                                    } else {
                                                                        phi_7151_ = false;
                                                                        phi_7152_ = false;
                                                                        phi_7153_ = true;
                                                                    }
                                                                    let _e2980 = phi_7151_;
                                                                    let _e2982 = phi_7152_;
                                                                    let _e2984 = phi_7153_;
                                                                    phi_7154_ = _e2980;
                                                                    phi_7155_ = _e2982;
                                                                    phi_7156_ = _e2984;
                                                                }
                                                                let _e2986 = phi_7154_;
                                                                let _e2988 = phi_7155_;
                                                                let _e2990 = phi_7156_;
                                                                phi_7157_ = _e2986;
                                                                phi_7158_ = _e2968;
                                                                phi_7159_ = _e2988;
                                                                phi_7160_ = _e2990;
                                                                phi_7161_ = false;
                                                            } else {
                                                                phi_7157_ = false;
                                                                phi_7158_ = false;
                                                                phi_7159_ = false;
                                                                phi_7160_ = false;
                                                                phi_7161_ = true;
                                                            }
                                                            let _e2992 = phi_7157_;
                                                            let _e2994 = phi_7158_;
                                                            let _e2996 = phi_7159_;
                                                            let _e2998 = phi_7160_;
                                                            let _e3000 = phi_7161_;
                                                            let _e5350 = local_56;
                                                            phi_7162_ = _e5350;
                                                            let _e5353 = local_57;
                                                            phi_7163_ = _e5353;
                                                            phi_7164_ = _e2992;
                                                            phi_7165_ = _e2994;
                                                            phi_7166_ = _e2996;
                                                            phi_7167_ = _e2998;
                                                            phi_7168_ = _e3000;
                                                            phi_7169_ = false;
                                                        } else {
                                                            phi_7162_ = f64();
                                                            phi_7163_ = f64();
                                                            phi_7164_ = false;
                                                            phi_7165_ = false;
                                                            phi_7166_ = false;
                                                            phi_7167_ = false;
                                                            phi_7168_ = false;
                                                            phi_7169_ = true;
                                                        }
                                                        let _e3002 = phi_7162_;
                                                        let _e3004 = phi_7163_;
                                                        let _e3006 = phi_7164_;
                                                        let _e3008 = phi_7165_;
                                                        let _e3010 = phi_7166_;
                                                        let _e3012 = phi_7167_;
                                                        let _e3014 = phi_7168_;
                                                        let _e3016 = phi_7169_;
                                                        phi_7170_ = _e3002;
                                                        phi_7171_ = _e3004;
                                                        phi_7172_ = _e3006;
                                                        phi_7173_ = _e3008;
                                                        phi_7174_ = _e3010;
                                                        phi_7175_ = _e3012;
                                                        phi_7176_ = _e3014;
                                                        phi_7177_ = _e3016;
                                                        phi_7178_ = false;
                                                    } else {
                                                        phi_7170_ = f64();
                                                        phi_7171_ = f64();
                                                        phi_7172_ = false;
                                                        phi_7173_ = false;
                                                        phi_7174_ = false;
                                                        phi_7175_ = false;
                                                        phi_7176_ = false;
                                                        phi_7177_ = false;
                                                        phi_7178_ = true;
                                                    }
                                                    let _e3018 = phi_7170_;
                                                    let _e3020 = phi_7171_;
                                                    let _e3022 = phi_7172_;
                                                    let _e3024 = phi_7173_;
                                                    let _e3026 = phi_7174_;
                                                    let _e3028 = phi_7175_;
                                                    let _e3030 = phi_7176_;
                                                    let _e3032 = phi_7177_;
                                                    let _e3034 = phi_7178_;
                                                    phi_7179_ = _e3018;
                                                    phi_6251_ = _e3020;
                                                    phi_7180_ = _e3022;
                                                    phi_7181_ = _e3024;
                                                    phi_7182_ = _e3026;
                                                    phi_7183_ = false;
                                                    phi_7184_ = _e3028;
                                                    phi_7185_ = _e3030;
                                                    phi_7186_ = _e3032;
                                                    phi_7187_ = _e3034;
                                                } else {
                                                    phi_7179_ = f64();
                                                    phi_6251_ = f64();
                                                    phi_7180_ = false;
                                                    phi_7181_ = false;
                                                    phi_7182_ = false;
                                                    phi_7183_ = true;
                                                    phi_7184_ = false;
                                                    phi_7185_ = false;
                                                    phi_7186_ = false;
                                                    phi_7187_ = false;
                                                }
                                                let _e3036 = phi_7179_;
                                                let _e3038 = phi_6251_;
                                                let _e3040 = phi_7180_;
                                                let _e3042 = phi_7181_;
                                                let _e3044 = phi_7182_;
                                                let _e3046 = phi_7183_;
                                                let _e3048 = phi_7184_;
                                                let _e3050 = phi_7185_;
                                                let _e3052 = phi_7186_;
                                                let _e3054 = phi_7187_;
                                                local_31 = _e3042;
                                                local_58 = _e3044;
                                                local_59 = _e3046;
                                                local_60 = _e3048;
                                                local_61 = _e3050;
                                                local_62 = _e3052;
                                                local_63 = _e3054;
                                                local_64 = _e3036;
                                                local_66 = _e3042;
                                                continue;
                                                continuing {
                                                    phi_6247_ = _e2422;
                                                    phi_6250_ = _e3038;
                                                    break if !(_e3040);
                                                }
                                            }
                                            let _e3057 = local_31;
                                            if _e3057 {
                                                phi_7192_ = type_72(0u, type_72().member_1);
                                                phi_7193_ = false;
                                                phi_7194_ = false;
                                                phi_7195_ = false;
                                                phi_7196_ = false;
                                                phi_7197_ = false;
                                                phi_7198_ = false;
                                            } else {
                                                phi_7192_ = type_72();
                                                let _e5383 = local_58;
                                                phi_7193_ = _e5383;
                                                let _e5386 = local_59;
                                                phi_7194_ = _e5386;
                                                let _e5389 = local_60;
                                                phi_7195_ = _e5389;
                                                let _e5392 = local_61;
                                                phi_7196_ = _e5392;
                                                let _e5395 = local_62;
                                                phi_7197_ = _e5395;
                                                let _e5398 = local_63;
                                                phi_7198_ = _e5398;
                                            }
                                            let _e3062 = phi_7192_;
                                            let _e3064 = phi_7193_;
                                            let _e3066 = phi_7194_;
                                            let _e3068 = phi_7195_;
                                            let _e3070 = phi_7196_;
                                            let _e3072 = phi_7197_;
                                            let _e3074 = phi_7198_;
                                            if _e3064 {
                                                let _e5401 = local_64;
                                                phi_7202_ = _e5401;
                                                phi_7203_ = true;
                                                phi_7204_ = false;
                                                phi_7205_ = false;
                                                phi_7206_ = false;
                                                phi_7207_ = false;
                                                phi_7208_ = false;
                                            } else {
                                                let _e5403 = local_65;
                                                phi_7202_ = _e5403;
                                                phi_7203_ = _e3066;
                                                phi_7204_ = _e3068;
                                                phi_7205_ = _e3070;
                                                let _e5409 = local_66;
                                                phi_7206_ = _e5409;
                                                phi_7207_ = _e3072;
                                                phi_7208_ = _e3074;
                                            }
                                            let _e3076 = phi_7202_;
                                            let _e3078 = phi_7203_;
                                            let _e3080 = phi_7204_;
                                            let _e3082 = phi_7205_;
                                            let _e3084 = phi_7206_;
                                            let _e3086 = phi_7207_;
                                            let _e3088 = phi_7208_;
                                            if _e3078 {
                                                phi_7213_ = type_72(1u, _e3076);
                                                phi_7214_ = false;
                                                phi_7215_ = false;
                                                phi_7216_ = false;
                                                phi_7217_ = false;
                                                phi_7218_ = false;
                                            } else {
                                                phi_7213_ = type_72();
                                                phi_7214_ = _e3080;
                                                phi_7215_ = _e3082;
                                                phi_7216_ = _e3084;
                                                phi_7217_ = _e3086;
                                                phi_7218_ = _e3088;
                                            }
                                            let _e3091 = phi_7213_;
                                            let _e3093 = phi_7214_;
                                            let _e3095 = phi_7215_;
                                            let _e3097 = phi_7216_;
                                            let _e3099 = phi_7217_;
                                            let _e3101 = phi_7218_;
                                            if _e3093 {
                                                let _e3103 = local_32;
                                                phi_7223_ = type_72(1u, _e3103);
                                                phi_7224_ = false;
                                                phi_7225_ = true;
                                                phi_7226_ = false;
                                                phi_7227_ = false;
                                            } else {
                                                phi_7223_ = _e3062;
                                                phi_7224_ = _e3095;
                                                phi_7225_ = _e3097;
                                                phi_7226_ = _e3099;
                                                phi_7227_ = _e3101;
                                            }
                                            let _e3106 = phi_7223_;
                                            let _e3108 = phi_7224_;
                                            let _e3110 = phi_7225_;
                                            let _e3112 = phi_7226_;
                                            let _e3114 = phi_7227_;
                                            if _e3108 {
                                                let _e3116 = local_33;
                                                phi_7232_ = type_72(1u, _e3116);
                                                phi_7233_ = true;
                                                phi_7234_ = false;
                                                phi_7235_ = false;
                                            } else {
                                                phi_7232_ = _e3106;
                                                phi_7233_ = _e3110;
                                                phi_7234_ = _e3112;
                                                phi_7235_ = _e3114;
                                            }
                                            let _e3119 = phi_7232_;
                                            let _e3121 = phi_7233_;
                                            let _e3123 = phi_7234_;
                                            let _e3125 = phi_7235_;
                                            if _e3121 {
                                                phi_7239_ = false;
                                                phi_7240_ = false;
                                            } else {
                                                phi_7239_ = _e3123;
                                                phi_7240_ = _e3125;
                                            }
                                            let _e3127 = phi_7239_;
                                            let _e3129 = phi_7240_;
                                            if _e3127 {
                                                phi_7244_ = false;
                                                phi_7245_ = false;
                                            } else {
                                                phi_7244_ = _e3129;
                                                phi_7245_ = _e3121;
                                            }
                                            let _e3131 = phi_7244_;
                                            let _e3133 = phi_7245_;
                                            if _e3131 {
                                                phi_7249_ = true;
                                                phi_7250_ = false;
                                            } else {
                                                phi_7249_ = _e3127;
                                                phi_7250_ = _e3133;
                                            }
                                            let _e3135 = phi_7249_;
                                            let _e3137 = phi_7250_;
                                            if _e3135 {
                                                let _e3139 = local_34;
                                                phi_7255_ = type_72(1u, _e3139);
                                                phi_7256_ = true;
                                            } else {
                                                phi_7255_ = _e3119;
                                                phi_7256_ = _e3137;
                                            }
                                            let _e3142 = phi_7255_;
                                            let _e3144 = phi_7256_;
                                            if _e3144 {
                                                phi_7260_ = _e3142;
                                            } else {
                                                phi_7260_ = _e3091;
                                            }
                                            let _e3146 = phi_7260_;
                                            let _e3149 = (_e3146.member != 0u);
                                            if _e3149 {
                                                phi_7267_ = false;
                                            } else {
                                                phi_7267_ = true;
                                            }
                                            let _e3151 = phi_7267_;
                                            phi_7268_ = _e3146.member_1;
                                            phi_7269_ = _e3151;
                                            phi_7270_ = _e3149;
                                            phi_7271_ = false;
                                        } else {
                                            phi_7268_ = f64();
                                            phi_7269_ = false;
                                            phi_7270_ = false;
                                            phi_7271_ = true;
                                        }
                                        let _e3153 = phi_7268_;
                                        let _e3155 = phi_7269_;
                                        let _e3157 = phi_7270_;
                                        let _e3159 = phi_7271_;
                                        phi_7272_ = _e3153;
                                        phi_7273_ = _e3155;
                                        phi_7274_ = _e3157;
                                        phi_7275_ = _e3159;
                                    }
                                    let _e3161 = phi_7272_;
                                    let _e3163 = phi_7273_;
                                    let _e3165 = phi_7274_;
                                    let _e3167 = phi_7275_;
                                    phi_7276_ = _e3161;
                                    phi_7277_ = _e2150;
                                    phi_7278_ = _e3163;
                                    phi_7279_ = _e3165;
                                    phi_7280_ = _e3167;
                                }
                                let _e3169 = phi_7276_;
                                let _e3171 = phi_7277_;
                                let _e3173 = phi_7278_;
                                let _e3175 = phi_7279_;
                                let _e3177 = phi_7280_;
                                if _e3171 {
                                    phi_7284_ = true;
                                    phi_7285_ = false;
                                    phi_7286_ = false;
                                } else {
                                    phi_7284_ = _e3173;
                                    phi_7285_ = _e3175;
                                    phi_7286_ = _e3177;
                                }
                                let _e3179 = phi_7284_;
                                let _e3181 = phi_7285_;
                                let _e3183 = phi_7286_;
                                phi_7287_ = _e3169;
                                phi_7288_ = _e1408;
                                phi_7289_ = _e3179;
                                phi_7290_ = false;
                                phi_7291_ = _e3181;
                                phi_7292_ = _e3183;
                            } else {
                                phi_7287_ = f64();
                                phi_7288_ = type_73();
                                phi_7289_ = false;
                                phi_7290_ = true;
                                phi_7291_ = false;
                                phi_7292_ = false;
                            }
                            let _e3185 = phi_7287_;
                            let _e3187 = phi_7288_;
                            let _e3189 = phi_7289_;
                            let _e3191 = phi_7290_;
                            let _e3193 = phi_7291_;
                            let _e3195 = phi_7292_;
                            local_35 = _e3191;
                            local_67 = _e3193;
                            local_68 = _e3195;
                            local_36 = _e3185;
                            local_37 = _e3187;
                            continue;
                            continuing {
                                phi_4286_ = _e1089;
                                break if !(_e3189);
                            }
                        }
                        let _e3198 = local_35;
                        if _e3198 {
                            phi_7297_ = type_72(0u, type_72().member_1);
                            phi_7298_ = false;
                            phi_7299_ = false;
                        } else {
                            phi_7297_ = type_72();
                            let _e5466 = local_67;
                            phi_7298_ = _e5466;
                            let _e5469 = local_68;
                            phi_7299_ = _e5469;
                        }
                        let _e3203 = phi_7297_;
                        let _e3205 = phi_7298_;
                        let _e3207 = phi_7299_;
                        if _e3205 {
                            let _e3209 = local_36;
                            phi_7304_ = type_72(2u, _e3209);
                            phi_7305_ = false;
                        } else {
                            phi_7304_ = type_72();
                            phi_7305_ = _e3207;
                        }
                        let _e3212 = phi_7304_;
                        let _e3214 = phi_7305_;
                        if _e3214 {
                            let _e3216 = local_37;
                            phi_7311_ = type_72(1u, _e3216.member);
                            phi_7312_ = true;
                        } else {
                            phi_7311_ = _e3212;
                            phi_7312_ = _e3205;
                        }
                        let _e3220 = phi_7311_;
                        let _e3222 = phi_7312_;
                        if _e3222 {
                            phi_7316_ = _e3220;
                        } else {
                            phi_7316_ = _e3203;
                        }
                        let _e3224 = phi_7316_;
                        phi_7320_ = _e3224;
                    }
                    let _e4867 = phi_7320_;
                    phi_7321_ = _e4867;
                }
                let _e4872 = phi_7321_;
                switch bitcast<i32>(_e4872.member) {
                    case 0: {
                        phi_7342_ = type_46(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4882 = bitcast<u64>(_e4872.member_1);
                        phi_7342_ = type_46(0u, array<u32, 2>(u32(_e4882), u32((_e4882 / 4294967296lu))), true);
                        break;
                    }
                    case 2: {
                        let _e4876 = bitcast<u64>(_e4872.member_1);
                        phi_7342_ = type_46(1u, array<u32, 2>(u32(_e4876), u32((_e4876 / 4294967296lu))), true);
                        break;
                    }
                    default: {
                        phi_7342_ = type_46();
                        break;
                    }
                }
                let _e4889 = phi_7342_;
                if _e4889.member_2 {
                    let _e4896 = (_e4889.member_1[1] >> bitcast<u32>(20i));
                    if (_e4896 <= 896u) {
                        phi_7365_ = 0u;
                    } else {
                        phi_7365_ = ((((_e4896 - 896u) << bitcast<u32>(23i)) | ((_e4889.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4889.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4911 = phi_7365_;
                    let _e4913 = atomicMin((&earliest.member[0u]), _e4911);
                }
                phi_7369_ = type_45(_e184, _e4889.member, _e190, _e193, _e4889.member_1);
                phi_7370_ = _e4889.member_2;
            } else {
                phi_7369_ = type_45(_e184, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_7370_ = false;
            }
            let _e4915 = phi_7369_;
            let _e4917 = phi_7370_;
            let _e4919 = params.member.member_1;
            if ((_e4919 & 16u) != 0u) {
                if (_e115 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4917 {
                    let _e4925 = atomicAdd((&counters[0u]), 1u);
                    phi_7388_ = _e4925;
                } else {
                    phi_7388_ = 0u;
                }
                let _e4927 = phi_7388_;
                workgroupBarrier();
                if (_e115 == 0u) {
                    let _e4930 = atomicLoad((&counters[0u]));
                    if (_e4930 > 0u) {
                        let _e4933 = atomicAdd((&contacts.member[0u]), _e4930);
                        atomicStore((&counters[1u]), _e4933);
                    }
                }
                workgroupBarrier();
                let _e4936 = atomicLoad((&counters[1u]));
                let _e4937 = (_e4936 + _e4927);
                if _e4917 {
                    let _e4939 = params.member.member_16;
                    if (_e4937 < _e4939) {
                        let _e4941 = (6u * _e4937);
                        atomicStore((&contacts.member[(4u + _e4941)]), _e4915.member);
                        atomicStore((&contacts.member[(_e4941 + 5u)]), _e4915.member_1);
                        atomicStore((&contacts.member[(_e4941 + 6u)]), _e4915.member_2);
                        atomicStore((&contacts.member[(_e4941 + 7u)]), _e4915.member_3);
                        atomicStore((&contacts.member[(_e4941 + 8u)]), _e4915.member_4[0]);
                        atomicStore((&contacts.member[(_e4941 + 9u)]), _e4915.member_4[1]);
                    }
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
