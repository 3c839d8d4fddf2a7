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
    var phi_231_: u32;
    var phi_247_: u32;
    var phi_268_: u32;
    var phi_269_: u32;
    var phi_272_: type_29;
    var phi_273_: type_29;
    var phi_296_: type_29;
    var phi_628_: type_29;
    var phi_629_: type_29;
    var phi_652_: type_29;
    var phi_508_: type_29;
    var phi_509_: type_29;
    var phi_532_: type_29;
    var phi_542_: type_29;
    var phi_543_: type_29;
    var phi_566_: type_29;
    var phi_1109_: f64;
    var phi_1116_: f64;
    var phi_1121_: f64;
    var phi_1128_: f64;
    var phi_1133_: f64;
    var phi_1146_: f64;
    var phi_1153_: f64;
    var phi_1158_: f64;
    var phi_1165_: f64;
    var phi_1170_: f64;
    var phi_1175_: f64;
    var phi_1192_: f64;
    var phi_1199_: f64;
    var phi_1204_: f64;
    var phi_1211_: f64;
    var phi_1216_: f64;
    var phi_1230_: f64;
    var phi_1237_: f64;
    var phi_1242_: f64;
    var phi_1249_: f64;
    var phi_1254_: f64;
    var phi_1259_: f64;
    var phi_1276_: f64;
    var phi_1283_: f64;
    var phi_1288_: f64;
    var phi_1295_: f64;
    var phi_1300_: f64;
    var phi_1314_: f64;
    var phi_1321_: f64;
    var phi_1326_: f64;
    var phi_1333_: f64;
    var phi_1338_: f64;
    var phi_1343_: f64;
    var phi_1380_: f64;
    var phi_1386_: f64;
    var phi_1393_: f64;
    var phi_1400_: f64;
    var phi_1406_: f64;
    var phi_1413_: f64;
    var phi_1419_: f64;
    var phi_1425_: f64;
    var phi_1431_: f64;
    var phi_1438_: f64;
    var phi_1445_: f64;
    var phi_1473_: f64;
    var phi_1478_: f64;
    var phi_1483_: f64;
    var phi_1488_: f64;
    var phi_1493_: f64;
    var phi_1498_: f64;
    var phi_1509_: f64;
    var phi_4066_: f64;
    var phi_4072_: f64;
    var phi_4077_: f64;
    var phi_4083_: f64;
    var phi_4089_: f64;
    var phi_4094_: f64;
    var phi_4099_: f64;
    var phi_4109_: bool;
    var phi_4116_: f64;
    var phi_4124_: f64;
    var phi_4167_: type_27;
    var phi_4170_: f64;
    var phi_4191_: bool;
    var phi_4197_: type_28;
    var phi_4168_: type_27;
    var phi_4211_: type_28;
    var phi_4171_: f64;
    var local_21: f64;
    var phi_4160_: f64;
    var phi_4224_: f64;
    var phi_4230_: f64;
    var phi_4255_: type_29;
    var phi_4258_: u32;
    var phi_4256_: type_29;
    var phi_4281_: type_29;
    var phi_4325_: u32;
    var phi_4326_: u32;
    var phi_4259_: u32;
    var phi_4327_: u32;
    var phi_4347_: type_29;
    var phi_4348_: type_29;
    var phi_4371_: type_29;
    var phi_4425_: f64;
    var phi_4432_: f64;
    var phi_4444_: bool;
    var phi_4445_: bool;
    var phi_4446_: bool;
    var phi_4447_: bool;
    var phi_4451_: bool;
    var phi_4463_: type_74;
    var phi_4464_: type_74;
    var phi_4465_: bool;
    var phi_4466_: type_74;
    var phi_4467_: bool;
    var phi_4480_: f64;
    var phi_4493_: type_29;
    var phi_4496_: f64;
    var phi_4498_: f64;
    var phi_4500_: f64;
    var phi_4494_: type_29;
    var phi_4523_: type_29;
    var phi_4550_: f64;
    var phi_4551_: f64;
    var phi_4579_: f64;
    var phi_4595_: f64;
    var phi_4602_: bool;
    var phi_4603_: bool;
    var phi_4604_: bool;
    var phi_4610_: f64;
    var phi_4611_: f64;
    var phi_4612_: bool;
    var phi_4497_: f64;
    var phi_4499_: f64;
    var phi_4501_: f64;
    var phi_4613_: f64;
    var phi_4614_: bool;
    var phi_4615_: bool;
    var local_22: bool;
    var phi_4619_: f64;
    var phi_4620_: f64;
    var phi_4628_: type_29;
    var phi_4631_: f64;
    var phi_4629_: type_29;
    var phi_4654_: type_29;
    var phi_4697_: f64;
    var phi_4707_: f64;
    var phi_4717_: bool;
    var phi_4719_: bool;
    var phi_4724_: f64;
    var phi_4725_: bool;
    var phi_4726_: f64;
    var phi_4727_: bool;
    var phi_4728_: bool;
    var phi_4729_: bool;
    var phi_4730_: f64;
    var phi_4632_: f64;
    var phi_4731_: bool;
    var phi_4732_: bool;
    var phi_4733_: bool;
    var phi_4734_: bool;
    var local_23: bool;
    var phi_4738_: bool;
    var phi_4739_: bool;
    var phi_4743_: bool;
    var phi_4747_: f64;
    var phi_4748_: f64;
    var phi_4750_: type_74;
    var phi_4781_: f64;
    var phi_4788_: f64;
    var phi_4793_: f64;
    var phi_4800_: f64;
    var phi_4805_: f64;
    var phi_4818_: f64;
    var phi_4825_: f64;
    var phi_4830_: f64;
    var phi_4837_: f64;
    var phi_4842_: f64;
    var phi_4847_: f64;
    var phi_4906_: f64;
    var phi_4912_: f64;
    var phi_4917_: f64;
    var phi_4923_: f64;
    var phi_4928_: f64;
    var phi_4942_: f64;
    var phi_4948_: f64;
    var phi_4953_: f64;
    var phi_4959_: f64;
    var phi_4964_: f64;
    var phi_4990_: f64;
    var phi_4997_: f64;
    var phi_5002_: f64;
    var phi_5009_: f64;
    var phi_5014_: f64;
    var phi_5027_: f64;
    var phi_5034_: f64;
    var phi_5039_: f64;
    var phi_5046_: f64;
    var phi_5051_: f64;
    var phi_5056_: f64;
    var phi_5115_: f64;
    var phi_5121_: f64;
    var phi_5126_: f64;
    var phi_5132_: f64;
    var phi_5137_: f64;
    var phi_5151_: f64;
    var phi_5157_: f64;
    var phi_5162_: f64;
    var phi_5168_: f64;
    var phi_5173_: f64;
    var phi_5199_: f64;
    var phi_5206_: f64;
    var phi_5211_: f64;
    var phi_5218_: f64;
    var phi_5223_: f64;
    var phi_5236_: f64;
    var phi_5243_: f64;
    var phi_5248_: f64;
    var phi_5255_: f64;
    var phi_5260_: f64;
    var phi_5265_: f64;
    var phi_5324_: f64;
    var phi_5330_: f64;
    var phi_5335_: f64;
    var phi_5341_: f64;
    var phi_5346_: f64;
    var phi_5360_: f64;
    var phi_5366_: f64;
    var phi_5371_: f64;
    var phi_5377_: f64;
    var phi_5382_: f64;
    var phi_5431_: f64;
    var phi_5437_: f64;
    var phi_5465_: f64;
    var phi_5471_: f64;
    var phi_5476_: u32;
    var phi_5477_: u32;
    var phi_5447_: f64;
    var phi_5453_: f64;
    var phi_5458_: u32;
    var phi_5459_: u32;
    var phi_5478_: u32;
    var phi_5479_: u32;
    var phi_5550_: f64;
    var phi_5562_: f64;
    var phi_5701_: f64;
    var phi_5707_: f64;
    var phi_5714_: f64;
    var phi_5758_: type_29;
    var phi_5761_: bool;
    var phi_5759_: type_29;
    var phi_5784_: type_29;
    var phi_5811_: bool;
    var phi_5812_: bool;
    var phi_5762_: bool;
    var phi_5813_: bool;
    var phi_5814_: bool;
    var local_24: bool;
    var phi_5818_: bool;
    var local_25: bool;
    var phi_5825_: u32;
    var phi_5826_: u32;
    var phi_5827_: bool;
    var phi_5828_: u32;
    var phi_5829_: u32;
    var phi_5830_: bool;
    var phi_5834_: u32;
    var phi_5855_: bool;
    var phi_5856_: bool;
    var phi_5857_: bool;
    var phi_6054_: f64;
    var phi_6061_: f64;
    var phi_6066_: f64;
    var phi_6073_: f64;
    var phi_6078_: f64;
    var phi_6091_: f64;
    var phi_6098_: f64;
    var phi_6103_: f64;
    var phi_6110_: f64;
    var phi_6115_: f64;
    var phi_6120_: f64;
    var phi_6137_: f64;
    var phi_6144_: f64;
    var phi_6149_: f64;
    var phi_6156_: f64;
    var phi_6161_: f64;
    var phi_6175_: f64;
    var phi_6182_: f64;
    var phi_6187_: f64;
    var phi_6194_: f64;
    var phi_6199_: f64;
    var phi_6204_: f64;
    var phi_6221_: f64;
    var phi_6228_: f64;
    var phi_6233_: f64;
    var phi_6240_: f64;
    var phi_6245_: f64;
    var phi_6259_: f64;
    var phi_6266_: f64;
    var phi_6271_: f64;
    var phi_6278_: f64;
    var phi_6283_: f64;
    var phi_6288_: f64;
    var phi_6308_: type_29;
    var phi_6311_: f64;
    var phi_6309_: type_29;
    var phi_6334_: type_29;
    var phi_6510_: bool;
    var phi_6511_: bool;
    var phi_6512_: bool;
    var phi_6513_: bool;
    var phi_6517_: bool;
    var phi_6539_: array<f64, 3>;
    var phi_6540_: bool;
    var phi_6541_: array<f64, 3>;
    var phi_6542_: bool;
    var phi_6729_: f64;
    var phi_6731_: f64;
    var phi_6761_: f64;
    var phi_6763_: f64;
    var phi_6793_: f64;
    var phi_6795_: f64;
    var phi_6831_: type_29;
    var phi_6834_: array<f64, 3>;
    var phi_6832_: type_29;
    var phi_6857_: type_29;
    var phi_6924_: array<f64, 3>;
    var phi_6835_: array<f64, 3>;
    var phi_6925_: array<f64, 3>;
    var phi_6932_: f64;
    var phi_6939_: f64;
    var phi_6947_: f64;
    var phi_6992_: type_27;
    var phi_6995_: f64;
    var phi_7016_: bool;
    var phi_7022_: type_28;
    var phi_6993_: type_27;
    var phi_7036_: type_28;
    var phi_6996_: f64;
    var local_26: f64;
    var phi_6985_: f64;
    var phi_7049_: f64;
    var phi_7062_: type_29;
    var phi_7065_: f64;
    var phi_7063_: type_29;
    var phi_7088_: type_29;
    var phi_7139_: f64;
    var phi_7145_: f64;
    var phi_7159_: bool;
    var phi_7160_: bool;
    var phi_7194_: f64;
    var phi_7195_: f64;
    var phi_7196_: f64;
    var phi_7197_: bool;
    var phi_7201_: bool;
    var phi_7202_: f64;
    var phi_7203_: bool;
    var phi_7204_: bool;
    var phi_7205_: bool;
    var phi_7206_: f64;
    var phi_7207_: bool;
    var phi_7208_: bool;
    var phi_7209_: bool;
    var phi_7066_: f64;
    var phi_7210_: bool;
    var phi_7211_: bool;
    var phi_7212_: bool;
    var phi_7213_: bool;
    var local_27: bool;
    var local_28: f64;
    var local_29: f64;
    var local_30: f64;
    var phi_7231_: bool;
    var phi_7232_: bool;
    var phi_7233_: bool;
    var phi_7234_: bool;
    var phi_7235_: bool;
    var phi_7236_: bool;
    var phi_7237_: bool;
    var phi_7238_: bool;
    var phi_7239_: bool;
    var phi_7240_: bool;
    var phi_7241_: bool;
    var phi_7242_: bool;
    var phi_7243_: bool;
    var phi_7244_: f64;
    var phi_7245_: f64;
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
    var phi_7262_: bool;
    var phi_7263_: f64;
    var phi_6312_: f64;
    var phi_7264_: bool;
    var phi_7265_: bool;
    var phi_7266_: bool;
    var phi_7267_: bool;
    var phi_7268_: bool;
    var phi_7269_: bool;
    var phi_7270_: bool;
    var phi_7271_: bool;
    var phi_7272_: bool;
    var local_31: bool;
    var phi_7277_: type_73;
    var phi_7278_: bool;
    var phi_7279_: bool;
    var phi_7280_: bool;
    var phi_7281_: bool;
    var phi_7282_: bool;
    var phi_7283_: bool;
    var phi_7284_: bool;
    var phi_7288_: f64;
    var phi_7289_: bool;
    var phi_7290_: bool;
    var phi_7291_: bool;
    var phi_7292_: bool;
    var phi_7293_: bool;
    var phi_7294_: bool;
    var phi_7295_: bool;
    var phi_7300_: type_73;
    var phi_7301_: bool;
    var phi_7302_: bool;
    var phi_7303_: bool;
    var phi_7304_: bool;
    var phi_7305_: bool;
    var phi_7306_: bool;
    var local_32: f64;
    var phi_7311_: type_73;
    var phi_7312_: bool;
    var phi_7313_: bool;
    var phi_7314_: bool;
    var phi_7315_: bool;
    var phi_7316_: bool;
    var local_33: f64;
    var phi_7321_: type_73;
    var phi_7322_: bool;
    var phi_7323_: bool;
    var phi_7324_: bool;
    var phi_7325_: bool;
    var local_34: f64;
    var phi_7330_: type_73;
    var phi_7331_: bool;
    var phi_7332_: bool;
    var phi_7333_: bool;
    var phi_7334_: bool;
    var phi_7338_: type_73;
    var phi_7339_: bool;
    var phi_7340_: bool;
    var phi_7341_: bool;
    var phi_7345_: bool;
    var phi_7346_: bool;
    var phi_7350_: bool;
    var phi_7351_: bool;
    var phi_7355_: bool;
    var phi_7356_: bool;
    var local_35: f64;
    var phi_7361_: type_73;
    var phi_7362_: bool;
    var phi_7366_: type_73;
    var phi_7373_: bool;
    var phi_7374_: f64;
    var phi_7375_: bool;
    var phi_7376_: bool;
    var phi_7377_: bool;
    var phi_7378_: f64;
    var phi_7379_: bool;
    var phi_7380_: bool;
    var phi_7381_: bool;
    var phi_7382_: f64;
    var phi_7383_: bool;
    var phi_7384_: bool;
    var phi_7385_: bool;
    var phi_7386_: bool;
    var phi_7390_: bool;
    var phi_7391_: bool;
    var phi_7392_: bool;
    var phi_7393_: f64;
    var phi_7394_: type_74;
    var phi_7395_: bool;
    var phi_7396_: bool;
    var phi_7397_: bool;
    var phi_7398_: bool;
    var local_36: bool;
    var phi_7403_: type_73;
    var phi_7404_: bool;
    var phi_7405_: bool;
    var local_37: f64;
    var phi_7410_: type_73;
    var phi_7411_: bool;
    var local_38: type_74;
    var phi_7417_: type_73;
    var phi_7418_: bool;
    var phi_7422_: type_73;
    var phi_1712_: f64;
    var phi_1719_: f64;
    var phi_1724_: f64;
    var phi_1731_: f64;
    var phi_1736_: f64;
    var phi_1749_: f64;
    var phi_1756_: f64;
    var phi_1761_: f64;
    var phi_1768_: f64;
    var phi_1773_: f64;
    var phi_1778_: f64;
    var phi_1795_: f64;
    var phi_1802_: f64;
    var phi_1807_: f64;
    var phi_1814_: f64;
    var phi_1819_: f64;
    var phi_1833_: f64;
    var phi_1840_: f64;
    var phi_1845_: f64;
    var phi_1852_: f64;
    var phi_1857_: f64;
    var phi_1862_: f64;
    var phi_1879_: f64;
    var phi_1886_: f64;
    var phi_1891_: f64;
    var phi_1898_: f64;
    var phi_1903_: f64;
    var phi_1917_: f64;
    var phi_1924_: f64;
    var phi_1929_: f64;
    var phi_1936_: f64;
    var phi_1941_: f64;
    var phi_1946_: f64;
    var phi_1966_: type_29;
    var phi_1969_: f64;
    var phi_1967_: type_29;
    var phi_1992_: type_29;
    var phi_2168_: bool;
    var phi_2169_: bool;
    var phi_2170_: bool;
    var phi_2171_: bool;
    var phi_2175_: bool;
    var phi_2197_: array<f64, 3>;
    var phi_2198_: bool;
    var phi_2199_: array<f64, 3>;
    var phi_2200_: bool;
    var phi_2387_: f64;
    var phi_2389_: f64;
    var phi_2419_: f64;
    var phi_2421_: f64;
    var phi_2451_: f64;
    var phi_2453_: f64;
    var phi_2489_: type_29;
    var phi_2492_: array<f64, 3>;
    var phi_2490_: type_29;
    var phi_2515_: type_29;
    var phi_2582_: array<f64, 3>;
    var phi_2493_: array<f64, 3>;
    var phi_2583_: array<f64, 3>;
    var phi_2590_: f64;
    var phi_2597_: f64;
    var phi_2605_: f64;
    var phi_2650_: type_27;
    var phi_2653_: f64;
    var phi_2674_: bool;
    var phi_2680_: type_28;
    var phi_2651_: type_27;
    var phi_2694_: type_28;
    var phi_2654_: f64;
    var local_39: f64;
    var phi_2643_: f64;
    var phi_2707_: f64;
    var phi_2720_: type_29;
    var phi_2723_: f64;
    var phi_2721_: type_29;
    var phi_2746_: type_29;
    var phi_2797_: f64;
    var phi_2803_: f64;
    var phi_2817_: bool;
    var phi_2818_: bool;
    var phi_2852_: f64;
    var phi_2853_: f64;
    var phi_2854_: f64;
    var phi_2855_: bool;
    var phi_2859_: bool;
    var phi_2860_: f64;
    var phi_2861_: bool;
    var phi_2862_: bool;
    var phi_2863_: bool;
    var phi_2864_: f64;
    var phi_2865_: bool;
    var phi_2866_: bool;
    var phi_2867_: bool;
    var phi_2724_: f64;
    var phi_2868_: bool;
    var phi_2869_: bool;
    var phi_2870_: bool;
    var phi_2871_: bool;
    var local_40: bool;
    var local_41: f64;
    var local_42: f64;
    var local_43: f64;
    var phi_2889_: bool;
    var phi_2890_: bool;
    var phi_2891_: bool;
    var phi_2892_: bool;
    var phi_2893_: bool;
    var phi_2894_: bool;
    var phi_2895_: bool;
    var phi_2896_: bool;
    var phi_2897_: bool;
    var phi_2898_: bool;
    var phi_2899_: bool;
    var phi_2900_: bool;
    var phi_2901_: bool;
    var phi_2902_: f64;
    var phi_2903_: f64;
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
    var phi_2920_: bool;
    var phi_2921_: f64;
    var phi_1970_: f64;
    var phi_2922_: bool;
    var phi_2923_: bool;
    var phi_2924_: bool;
    var phi_2925_: bool;
    var phi_2926_: bool;
    var phi_2927_: bool;
    var phi_2928_: bool;
    var phi_2929_: bool;
    var phi_2930_: bool;
    var local_44: bool;
    var phi_2935_: type_73;
    var phi_2936_: bool;
    var phi_2937_: bool;
    var phi_2938_: bool;
    var phi_2939_: bool;
    var phi_2940_: bool;
    var phi_2941_: bool;
    var phi_2942_: bool;
    var phi_2946_: f64;
    var phi_2947_: bool;
    var phi_2948_: bool;
    var phi_2949_: bool;
    var phi_2950_: bool;
    var phi_2951_: bool;
    var phi_2952_: bool;
    var phi_2953_: bool;
    var phi_2958_: type_73;
    var phi_2959_: bool;
    var phi_2960_: bool;
    var phi_2961_: bool;
    var phi_2962_: bool;
    var phi_2963_: bool;
    var phi_2964_: bool;
    var local_45: f64;
    var phi_2969_: type_73;
    var phi_2970_: bool;
    var phi_2971_: bool;
    var phi_2972_: bool;
    var phi_2973_: bool;
    var phi_2974_: bool;
    var local_46: f64;
    var phi_2979_: type_73;
    var phi_2980_: bool;
    var phi_2981_: bool;
    var phi_2982_: bool;
    var phi_2983_: bool;
    var local_47: f64;
    var phi_2988_: type_73;
    var phi_2989_: bool;
    var phi_2990_: bool;
    var phi_2991_: bool;
    var phi_2992_: bool;
    var phi_2996_: type_73;
    var phi_2997_: bool;
    var phi_2998_: bool;
    var phi_2999_: bool;
    var phi_3003_: bool;
    var phi_3004_: bool;
    var phi_3008_: bool;
    var phi_3009_: bool;
    var phi_3013_: bool;
    var phi_3014_: bool;
    var local_48: f64;
    var phi_3019_: type_73;
    var phi_3020_: bool;
    var phi_3024_: type_73;
    var phi_3038_: type_29;
    var phi_3039_: type_29;
    var phi_3062_: type_29;
    var phi_3083_: f64;
    var phi_3253_: bool;
    var phi_3254_: bool;
    var phi_3255_: bool;
    var phi_3256_: bool;
    var phi_3260_: bool;
    var phi_3282_: array<f64, 3>;
    var phi_3283_: bool;
    var phi_3284_: array<f64, 3>;
    var phi_3285_: bool;
    var phi_3472_: f64;
    var phi_3474_: f64;
    var phi_3504_: f64;
    var phi_3506_: f64;
    var phi_3536_: f64;
    var phi_3538_: f64;
    var phi_3574_: type_29;
    var phi_3577_: array<f64, 3>;
    var phi_3575_: type_29;
    var phi_3600_: type_29;
    var phi_3667_: array<f64, 3>;
    var phi_3578_: array<f64, 3>;
    var phi_3668_: array<f64, 3>;
    var phi_3700_: type_27;
    var phi_3703_: f64;
    var phi_3724_: bool;
    var phi_3730_: type_28;
    var phi_3701_: type_27;
    var phi_3744_: type_28;
    var phi_3704_: f64;
    var local_49: f64;
    var phi_3693_: f64;
    var phi_3757_: f64;
    var phi_3775_: f64;
    var phi_3782_: f64;
    var phi_3787_: f64;
    var phi_3794_: f64;
    var phi_3799_: f64;
    var phi_3812_: f64;
    var phi_3819_: f64;
    var phi_3824_: f64;
    var phi_3831_: f64;
    var phi_3836_: f64;
    var phi_3841_: f64;
    var phi_3858_: f64;
    var phi_3865_: f64;
    var phi_3870_: f64;
    var phi_3877_: f64;
    var phi_3882_: f64;
    var phi_3896_: f64;
    var phi_3903_: f64;
    var phi_3908_: f64;
    var phi_3915_: f64;
    var phi_3920_: f64;
    var phi_3925_: f64;
    var phi_3942_: f64;
    var phi_3949_: f64;
    var phi_3954_: f64;
    var phi_3961_: f64;
    var phi_3966_: f64;
    var phi_3980_: f64;
    var phi_3987_: f64;
    var phi_3992_: f64;
    var phi_3999_: f64;
    var phi_4004_: f64;
    var phi_4009_: f64;
    var phi_4033_: bool;
    var phi_4034_: bool;
    var phi_4035_: bool;
    var local_50: bool;
    var phi_4040_: type_73;
    var phi_4041_: bool;
    var phi_4046_: type_73;
    var phi_4047_: bool;
    var phi_4049_: type_73;
    var phi_4050_: type_73;
    var phi_4051_: bool;
    var phi_4055_: type_73;
    var phi_7426_: type_73;
    var phi_7427_: type_73;
    var phi_7448_: type_47;
    var phi_7471_: u32;
    var phi_7475_: type_46;
    var phi_7476_: bool;
    var phi_7494_: u32;
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
        phi_231_ = _e134;
    } else {
        phi_231_ = _e136;
    }
    let _e139 = phi_231_;
    let _e140 = (_e139 / 64u);
    if ((_e139 % 64u) > 0u) {
        phi_247_ = (_e140 + 1u);
    } else {
        phi_247_ = _e140;
    }
    let _e145 = phi_247_;
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
            phi_268_ = (_e149 + 1u);
        } else {
            phi_268_ = _e149;
        }
        let _e155 = phi_268_;
        phi_269_ = _e155;
    } else {
        phi_269_ = 0u;
    }
    let _e157 = phi_269_;
    phi_272_ = type_29(0u, _e157);
    loop {
        let _e160 = phi_272_;
        if (_e160.member < _e160.member_1) {
            phi_273_ = type_29((_e160.member + 1u), _e160.member_1);
            phi_296_ = type_29(1u, _e160.member);
        } else {
            phi_273_ = _e160;
            phi_296_ = type_29(0u, type_29().member_1);
        }
        let _e174 = phi_273_;
        let _e176 = phi_296_;
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
                    phi_508_ = type_29(0u, 4u);
                    loop {
                        let _e307 = phi_508_;
                        if (_e307.member < _e307.member_1) {
                            phi_509_ = type_29((_e307.member + 1u), _e307.member_1);
                            phi_532_ = type_29(1u, _e307.member);
                        } else {
                            phi_509_ = _e307;
                            phi_532_ = type_29(0u, type_29().member_1);
                        }
                        let _e321 = phi_509_;
                        let _e323 = phi_532_;
                        let _e327 = (bitcast<i32>(_e323.member) != 0i);
                        if _e327 {
                            phi_542_ = type_29(0u, 3u);
                            loop {
                                let _e329 = phi_542_;
                                if (_e329.member < _e329.member_1) {
                                    phi_543_ = type_29((_e329.member + 1u), _e329.member_1);
                                    phi_566_ = type_29(1u, _e329.member);
                                } else {
                                    phi_543_ = _e329;
                                    phi_566_ = type_29(0u, type_29().member_1);
                                }
                                let _e343 = phi_543_;
                                let _e345 = phi_566_;
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
                                    phi_542_ = _e343;
                                    break if !(_e349);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_508_ = _e321;
                            break if !(_e327);
                        }
                    }
                } else {
                    phi_628_ = type_29(0u, 4u);
                    loop {
                        let _e215 = phi_628_;
                        if (_e215.member < _e215.member_1) {
                            phi_629_ = type_29((_e215.member + 1u), _e215.member_1);
                            phi_652_ = type_29(1u, _e215.member);
                        } else {
                            phi_629_ = _e215;
                            phi_652_ = type_29(0u, type_29().member_1);
                        }
                        let _e229 = phi_629_;
                        let _e231 = phi_652_;
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
                            phi_628_ = _e229;
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
                    phi_1109_ = -(_e602[0]);
                } else {
                    phi_1109_ = _e602[0];
                }
                let _e609 = phi_1109_;
                if (_e602[1] < 0.0lf) {
                    phi_1116_ = -(_e602[1]);
                } else {
                    phi_1116_ = _e602[1];
                }
                let _e613 = phi_1116_;
                if (_e609 > _e613) {
                    phi_1121_ = _e609;
                } else {
                    phi_1121_ = _e613;
                }
                let _e616 = phi_1121_;
                if (_e602[2] < 0.0lf) {
                    phi_1128_ = -(_e602[2]);
                } else {
                    phi_1128_ = _e602[2];
                }
                let _e620 = phi_1128_;
                if (_e616 > _e620) {
                    phi_1133_ = _e616;
                } else {
                    phi_1133_ = _e620;
                }
                let _e623 = phi_1133_;
                let _e626 = local_20.member[1u];
                if (_e626[0] < 0.0lf) {
                    phi_1146_ = -(_e626[0]);
                } else {
                    phi_1146_ = _e626[0];
                }
                let _e633 = phi_1146_;
                if (_e626[1] < 0.0lf) {
                    phi_1153_ = -(_e626[1]);
                } else {
                    phi_1153_ = _e626[1];
                }
                let _e637 = phi_1153_;
                if (_e633 > _e637) {
                    phi_1158_ = _e633;
                } else {
                    phi_1158_ = _e637;
                }
                let _e640 = phi_1158_;
                if (_e626[2] < 0.0lf) {
                    phi_1165_ = -(_e626[2]);
                } else {
                    phi_1165_ = _e626[2];
                }
                let _e644 = phi_1165_;
                if (_e640 > _e644) {
                    phi_1170_ = _e640;
                } else {
                    phi_1170_ = _e644;
                }
                let _e647 = phi_1170_;
                if (_e623 > _e647) {
                    phi_1175_ = _e623;
                } else {
                    phi_1175_ = _e647;
                }
                let _e650 = phi_1175_;
                let _e652 = local_20.member_3;
                let _e653 = (_e650 + _e652);
                let _e656 = local_20.member_1[0u];
                if (_e656[0] < 0.0lf) {
                    phi_1192_ = -(_e656[0]);
                } else {
                    phi_1192_ = _e656[0];
                }
                let _e663 = phi_1192_;
                if (_e656[1] < 0.0lf) {
                    phi_1199_ = -(_e656[1]);
                } else {
                    phi_1199_ = _e656[1];
                }
                let _e667 = phi_1199_;
                if (_e663 > _e667) {
                    phi_1204_ = _e663;
                } else {
                    phi_1204_ = _e667;
                }
                let _e670 = phi_1204_;
                if (_e656[2] < 0.0lf) {
                    phi_1211_ = -(_e656[2]);
                } else {
                    phi_1211_ = _e656[2];
                }
                let _e674 = phi_1211_;
                if (_e670 > _e674) {
                    phi_1216_ = _e670;
                } else {
                    phi_1216_ = _e674;
                }
                let _e677 = phi_1216_;
                let _e680 = local_20.member_1[1u];
                if (_e680[0] < 0.0lf) {
                    phi_1230_ = -(_e680[0]);
                } else {
                    phi_1230_ = _e680[0];
                }
                let _e687 = phi_1230_;
                if (_e680[1] < 0.0lf) {
                    phi_1237_ = -(_e680[1]);
                } else {
                    phi_1237_ = _e680[1];
                }
                let _e691 = phi_1237_;
                if (_e687 > _e691) {
                    phi_1242_ = _e687;
                } else {
                    phi_1242_ = _e691;
                }
                let _e694 = phi_1242_;
                if (_e680[2] < 0.0lf) {
                    phi_1249_ = -(_e680[2]);
                } else {
                    phi_1249_ = _e680[2];
                }
                let _e698 = phi_1249_;
                if (_e694 > _e698) {
                    phi_1254_ = _e694;
                } else {
                    phi_1254_ = _e698;
                }
                let _e701 = phi_1254_;
                if (_e677 > _e701) {
                    phi_1259_ = _e677;
                } else {
                    phi_1259_ = _e701;
                }
                let _e704 = phi_1259_;
                let _e706 = local_20.member_3;
                let _e707 = (_e704 + _e706);
                let _e710 = local_20.member_2[0u];
                if (_e710[0] < 0.0lf) {
                    phi_1276_ = -(_e710[0]);
                } else {
                    phi_1276_ = _e710[0];
                }
                let _e717 = phi_1276_;
                if (_e710[1] < 0.0lf) {
                    phi_1283_ = -(_e710[1]);
                } else {
                    phi_1283_ = _e710[1];
                }
                let _e721 = phi_1283_;
                if (_e717 > _e721) {
                    phi_1288_ = _e717;
                } else {
                    phi_1288_ = _e721;
                }
                let _e724 = phi_1288_;
                if (_e710[2] < 0.0lf) {
                    phi_1295_ = -(_e710[2]);
                } else {
                    phi_1295_ = _e710[2];
                }
                let _e728 = phi_1295_;
                if (_e724 > _e728) {
                    phi_1300_ = _e724;
                } else {
                    phi_1300_ = _e728;
                }
                let _e731 = phi_1300_;
                let _e734 = local_20.member_2[1u];
                if (_e734[0] < 0.0lf) {
                    phi_1314_ = -(_e734[0]);
                } else {
                    phi_1314_ = _e734[0];
                }
                let _e741 = phi_1314_;
                if (_e734[1] < 0.0lf) {
                    phi_1321_ = -(_e734[1]);
                } else {
                    phi_1321_ = _e734[1];
                }
                let _e745 = phi_1321_;
                if (_e741 > _e745) {
                    phi_1326_ = _e741;
                } else {
                    phi_1326_ = _e745;
                }
                let _e748 = phi_1326_;
                if (_e734[2] < 0.0lf) {
                    phi_1333_ = -(_e734[2]);
                } else {
                    phi_1333_ = _e734[2];
                }
                let _e752 = phi_1333_;
                if (_e748 > _e752) {
                    phi_1338_ = _e748;
                } else {
                    phi_1338_ = _e752;
                }
                let _e755 = phi_1338_;
                if (_e731 > _e755) {
                    phi_1343_ = _e731;
                } else {
                    phi_1343_ = _e755;
                }
                let _e758 = phi_1343_;
                let _e760 = local_20.member_3;
                let _e761 = (_e758 + _e760);
                let _e762 = f64(1f);
                let _e763 = f64(8f);
                let _e765 = ((_e707 * _e763) * _e761);
                let _e773 = local_20.member_3;
                if (_e459 < 0.0lf) {
                    phi_1380_ = -(_e459);
                } else {
                    phi_1380_ = _e459;
                }
                let _e793 = phi_1380_;
                if (_e462 < 0.0lf) {
                    phi_1386_ = -(_e462);
                } else {
                    phi_1386_ = _e462;
                }
                let _e797 = phi_1386_;
                if (_e465 < 0.0lf) {
                    phi_1393_ = -(_e465);
                } else {
                    phi_1393_ = _e465;
                }
                let _e802 = phi_1393_;
                let _e803 = ((_e793 + _e797) + _e802);
                if (_e480 < 0.0lf) {
                    phi_1400_ = -(_e480);
                } else {
                    phi_1400_ = _e480;
                }
                let _e807 = phi_1400_;
                if (_e483 < 0.0lf) {
                    phi_1406_ = -(_e483);
                } else {
                    phi_1406_ = _e483;
                }
                let _e811 = phi_1406_;
                if (_e486 < 0.0lf) {
                    phi_1413_ = -(_e486);
                } else {
                    phi_1413_ = _e486;
                }
                let _e816 = phi_1413_;
                let _e817 = ((_e807 + _e811) + _e816);
                if (_e803 > _e817) {
                    phi_1419_ = _e803;
                } else {
                    phi_1419_ = _e817;
                }
                let _e820 = phi_1419_;
                if (_e529 < 0.0lf) {
                    phi_1425_ = -(_e529);
                } else {
                    phi_1425_ = _e529;
                }
                let _e824 = phi_1425_;
                if (_e530 < 0.0lf) {
                    phi_1431_ = -(_e530);
                } else {
                    phi_1431_ = _e530;
                }
                let _e828 = phi_1431_;
                if (_e531 < 0.0lf) {
                    phi_1438_ = -(_e531);
                } else {
                    phi_1438_ = _e531;
                }
                let _e833 = phi_1438_;
                let _e835 = (((_e824 + _e828) + _e833) * f64(0.5f));
                if (_e820 > _e835) {
                    phi_1445_ = _e820;
                } else {
                    phi_1445_ = _e835;
                }
                let _e838 = phi_1445_;
                let _e844 = local_20.member_3;
                let _e858 = (((((_e653 * _e763) * _e765) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e773 * f64(19f)) * ((_e653 * (_e707 + _e761)) + (_e707 * _e761)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e762 + _e653) * ((_e762 + _e707) * (_e762 + _e761)))));
                let _e859 = f64(3f);
                let _e860 = (_e542 * _e859);
                let _e861 = (_e599 * _e859);
                if (_e860 < _e861) {
                    phi_1473_ = _e860;
                } else {
                    phi_1473_ = _e861;
                }
                let _e864 = phi_1473_;
                if (_e565 < _e588) {
                    phi_1478_ = _e565;
                } else {
                    phi_1478_ = _e588;
                }
                let _e867 = phi_1478_;
                if (_e864 < _e867) {
                    phi_1483_ = _e864;
                } else {
                    phi_1483_ = _e867;
                }
                let _e870 = phi_1483_;
                if (_e860 > _e861) {
                    phi_1488_ = _e860;
                } else {
                    phi_1488_ = _e861;
                }
                let _e873 = phi_1488_;
                if (_e565 > _e588) {
                    phi_1493_ = _e565;
                } else {
                    phi_1493_ = _e588;
                }
                let _e876 = phi_1493_;
                if (_e873 > _e876) {
                    phi_1498_ = _e873;
                } else {
                    phi_1498_ = _e876;
                }
                let _e879 = phi_1498_;
                let _e885 = -(_e879);
                if (_e870 > _e885) {
                    phi_1509_ = _e870;
                } else {
                    phi_1509_ = _e885;
                }
                let _e888 = phi_1509_;
                if ((_e888 - (_e858 + ((_e443 * (((_e838 + (_e765 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e844 * f64(6f)) * (_e707 + _e761))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e762 + _e707) * (_e762 + _e761))))) * f64((3f * 1.0001f))))) > _e444) {
                    phi_7427_ = type_73(0u, type_73().member_1);
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
                            phi_1712_ = -(_e3323[0]);
                        } else {
                            phi_1712_ = _e3323[0];
                        }
                        let _e3330 = phi_1712_;
                        if (_e3323[1] < 0.0lf) {
                            phi_1719_ = -(_e3323[1]);
                        } else {
                            phi_1719_ = _e3323[1];
                        }
                        let _e3334 = phi_1719_;
                        if (_e3330 > _e3334) {
                            phi_1724_ = _e3330;
                        } else {
                            phi_1724_ = _e3334;
                        }
                        let _e3337 = phi_1724_;
                        if (_e3323[2] < 0.0lf) {
                            phi_1731_ = -(_e3323[2]);
                        } else {
                            phi_1731_ = _e3323[2];
                        }
                        let _e3341 = phi_1731_;
                        if (_e3337 > _e3341) {
                            phi_1736_ = _e3337;
                        } else {
                            phi_1736_ = _e3341;
                        }
                        let _e3344 = phi_1736_;
                        let _e3347 = local_20.member[1u];
                        if (_e3347[0] < 0.0lf) {
                            phi_1749_ = -(_e3347[0]);
                        } else {
                            phi_1749_ = _e3347[0];
                        }
                        let _e3354 = phi_1749_;
                        if (_e3347[1] < 0.0lf) {
                            phi_1756_ = -(_e3347[1]);
                        } else {
                            phi_1756_ = _e3347[1];
                        }
                        let _e3358 = phi_1756_;
                        if (_e3354 > _e3358) {
                            phi_1761_ = _e3354;
                        } else {
                            phi_1761_ = _e3358;
                        }
                        let _e3361 = phi_1761_;
                        if (_e3347[2] < 0.0lf) {
                            phi_1768_ = -(_e3347[2]);
                        } else {
                            phi_1768_ = _e3347[2];
                        }
                        let _e3365 = phi_1768_;
                        if (_e3361 > _e3365) {
                            phi_1773_ = _e3361;
                        } else {
                            phi_1773_ = _e3365;
                        }
                        let _e3368 = phi_1773_;
                        if (_e3344 > _e3368) {
                            phi_1778_ = _e3344;
                        } else {
                            phi_1778_ = _e3368;
                        }
                        let _e3371 = phi_1778_;
                        let _e3373 = local_20.member_3;
                        let _e3377 = local_20.member_1[0u];
                        if (_e3377[0] < 0.0lf) {
                            phi_1795_ = -(_e3377[0]);
                        } else {
                            phi_1795_ = _e3377[0];
                        }
                        let _e3384 = phi_1795_;
                        if (_e3377[1] < 0.0lf) {
                            phi_1802_ = -(_e3377[1]);
                        } else {
                            phi_1802_ = _e3377[1];
                        }
                        let _e3388 = phi_1802_;
                        if (_e3384 > _e3388) {
                            phi_1807_ = _e3384;
                        } else {
                            phi_1807_ = _e3388;
                        }
                        let _e3391 = phi_1807_;
                        if (_e3377[2] < 0.0lf) {
                            phi_1814_ = -(_e3377[2]);
                        } else {
                            phi_1814_ = _e3377[2];
                        }
                        let _e3395 = phi_1814_;
                        if (_e3391 > _e3395) {
                            phi_1819_ = _e3391;
                        } else {
                            phi_1819_ = _e3395;
                        }
                        let _e3398 = phi_1819_;
                        let _e3401 = local_20.member_1[1u];
                        if (_e3401[0] < 0.0lf) {
                            phi_1833_ = -(_e3401[0]);
                        } else {
                            phi_1833_ = _e3401[0];
                        }
                        let _e3408 = phi_1833_;
                        if (_e3401[1] < 0.0lf) {
                            phi_1840_ = -(_e3401[1]);
                        } else {
                            phi_1840_ = _e3401[1];
                        }
                        let _e3412 = phi_1840_;
                        if (_e3408 > _e3412) {
                            phi_1845_ = _e3408;
                        } else {
                            phi_1845_ = _e3412;
                        }
                        let _e3415 = phi_1845_;
                        if (_e3401[2] < 0.0lf) {
                            phi_1852_ = -(_e3401[2]);
                        } else {
                            phi_1852_ = _e3401[2];
                        }
                        let _e3419 = phi_1852_;
                        if (_e3415 > _e3419) {
                            phi_1857_ = _e3415;
                        } else {
                            phi_1857_ = _e3419;
                        }
                        let _e3422 = phi_1857_;
                        if (_e3398 > _e3422) {
                            phi_1862_ = _e3398;
                        } else {
                            phi_1862_ = _e3422;
                        }
                        let _e3425 = phi_1862_;
                        let _e3427 = local_20.member_3;
                        let _e3431 = local_20.member_2[0u];
                        if (_e3431[0] < 0.0lf) {
                            phi_1879_ = -(_e3431[0]);
                        } else {
                            phi_1879_ = _e3431[0];
                        }
                        let _e3438 = phi_1879_;
                        if (_e3431[1] < 0.0lf) {
                            phi_1886_ = -(_e3431[1]);
                        } else {
                            phi_1886_ = _e3431[1];
                        }
                        let _e3442 = phi_1886_;
                        if (_e3438 > _e3442) {
                            phi_1891_ = _e3438;
                        } else {
                            phi_1891_ = _e3442;
                        }
                        let _e3445 = phi_1891_;
                        if (_e3431[2] < 0.0lf) {
                            phi_1898_ = -(_e3431[2]);
                        } else {
                            phi_1898_ = _e3431[2];
                        }
                        let _e3449 = phi_1898_;
                        if (_e3445 > _e3449) {
                            phi_1903_ = _e3445;
                        } else {
                            phi_1903_ = _e3449;
                        }
                        let _e3452 = phi_1903_;
                        let _e3455 = local_20.member_2[1u];
                        if (_e3455[0] < 0.0lf) {
                            phi_1917_ = -(_e3455[0]);
                        } else {
                            phi_1917_ = _e3455[0];
                        }
                        let _e3462 = phi_1917_;
                        if (_e3455[1] < 0.0lf) {
                            phi_1924_ = -(_e3455[1]);
                        } else {
                            phi_1924_ = _e3455[1];
                        }
                        let _e3466 = phi_1924_;
                        if (_e3462 > _e3466) {
                            phi_1929_ = _e3462;
                        } else {
                            phi_1929_ = _e3466;
                        }
                        let _e3469 = phi_1929_;
                        if (_e3455[2] < 0.0lf) {
                            phi_1936_ = -(_e3455[2]);
                        } else {
                            phi_1936_ = _e3455[2];
                        }
                        let _e3473 = phi_1936_;
                        if (_e3469 > _e3473) {
                            phi_1941_ = _e3469;
                        } else {
                            phi_1941_ = _e3473;
                        }
                        let _e3476 = phi_1941_;
                        if (_e3452 > _e3476) {
                            phi_1946_ = _e3452;
                        } else {
                            phi_1946_ = _e3476;
                        }
                        let _e3479 = phi_1946_;
                        let _e3481 = local_20.member_3;
                        let _e3489 = local_20.member_3;
                        phi_1966_ = type_29(0u, 48u);
                        phi_1969_ = f64(0f);
                        loop {
                            let _e3498 = phi_1966_;
                            let _e3500 = phi_1969_;
                            local_87 = _e3500;
                            local_45 = _e3500;
                            local_46 = _e3500;
                            local_47 = _e3500;
                            local_48 = _e3500;
                            if (_e3498.member < _e3498.member_1) {
                                phi_1967_ = type_29((_e3498.member + 1u), _e3498.member_1);
                                phi_1992_ = type_29(1u, _e3498.member);
                            } else {
                                phi_1967_ = _e3498;
                                phi_1992_ = type_29(0u, type_29().member_1);
                            }
                            let _e3514 = phi_1967_;
                            let _e3516 = phi_1992_;
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
                                        phi_2168_ = ((_e3616 + _e3620) <= f64(1f));
                                        phi_2169_ = false;
                                    } else {
                                        phi_2168_ = bool();
                                        phi_2169_ = true;
                                    }
                                    let _e3626 = phi_2168_;
                                    let _e3628 = phi_2169_;
                                    phi_2170_ = _e3626;
                                    phi_2171_ = _e3628;
                                } else {
                                    phi_2170_ = bool();
                                    phi_2171_ = true;
                                }
                                let _e3630 = phi_2170_;
                                let _e3632 = phi_2171_;
                                if _e3632 {
                                    phi_2175_ = false;
                                } else {
                                    phi_2175_ = _e3630;
                                }
                                let _e3634 = phi_2175_;
                                if (_e3610 > _e3611) {
                                    if _e3634 {
                                        phi_2197_ = array<f64, 3>((_e3538 - ((_e3559 * _e3616) + (_e3580 * _e3620))), (_e3539 - ((_e3560 * _e3616) + (_e3581 * _e3620))), (_e3540 - ((_e3561 * _e3616) + (_e3582 * _e3620))));
                                        phi_2198_ = false;
                                    } else {
                                        phi_2197_ = array<f64, 3>();
                                        phi_2198_ = true;
                                    }
                                    let _e3650 = phi_2197_;
                                    let _e3652 = phi_2198_;
                                    phi_2199_ = _e3650;
                                    phi_2200_ = _e3652;
                                } else {
                                    phi_2199_ = array<f64, 3>();
                                    phi_2200_ = true;
                                }
                                let _e3654 = phi_2199_;
                                let _e3656 = phi_2200_;
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
                                            phi_2387_ = _e3673;
                                        } else {
                                            phi_2387_ = f64(1f);
                                        }
                                        let _e3681 = phi_2387_;
                                        phi_2389_ = _e3681;
                                    } else {
                                        phi_2389_ = f64(0f);
                                    }
                                    let _e3683 = phi_2389_;
                                    let _e3687 = (_e3657 - (_e3660 * _e3683));
                                    let _e3688 = (_e3658 - (_e3661 * _e3683));
                                    let _e3689 = (_e3659 - (_e3662 * _e3683));
                                    let _e3700 = ((((_e3538 * _e3559) + (_e3539 * _e3560)) + (_e3540 * _e3561)) / (((_e3559 * _e3559) + (_e3560 * _e3560)) + (_e3561 * _e3561)));
                                    if (_e3700 > f64(0f)) {
                                        if (_e3700 < f64(1f)) {
                                            phi_2419_ = _e3700;
                                        } else {
                                            phi_2419_ = f64(1f);
                                        }
                                        let _e3708 = phi_2419_;
                                        phi_2421_ = _e3708;
                                    } else {
                                        phi_2421_ = f64(0f);
                                    }
                                    let _e3710 = phi_2421_;
                                    let _e3727 = ((((_e3538 * _e3580) + (_e3539 * _e3581)) + (_e3540 * _e3582)) / (((_e3580 * _e3580) + (_e3581 * _e3581)) + (_e3582 * _e3582)));
                                    if (_e3727 > f64(0f)) {
                                        if (_e3727 < f64(1f)) {
                                            phi_2451_ = _e3727;
                                        } else {
                                            phi_2451_ = f64(1f);
                                        }
                                        let _e3735 = phi_2451_;
                                        phi_2453_ = _e3735;
                                    } else {
                                        phi_2453_ = f64(0f);
                                    }
                                    let _e3737 = phi_2453_;
                                    local_11[0u] = array<f64, 3>((_e3538 - (_e3559 * _e3710)), (_e3539 - (_e3560 * _e3710)), (_e3540 - (_e3561 * _e3710)));
                                    local_11[1u] = array<f64, 3>((_e3538 - (_e3580 * _e3737)), (_e3539 - (_e3581 * _e3737)), (_e3540 - (_e3582 * _e3737)));
                                    local_11[2u] = array<f64, 3>(_e3687, _e3688, _e3689);
                                    local_11[3u] = array<f64, 3>(_e3687, _e3688, _e3689);
                                    let _e3753 = local_11[0u];
                                    phi_2489_ = type_29(1u, 4u);
                                    phi_2492_ = array<f64, 3>(_e3753[0], _e3753[1], _e3753[2]);
                                    loop {
                                        let _e3759 = phi_2489_;
                                        let _e3761 = phi_2492_;
                                        local_74 = _e3761;
                                        if (_e3759.member < _e3759.member_1) {
                                            phi_2490_ = type_29((_e3759.member + 1u), _e3759.member_1);
                                            phi_2515_ = type_29(1u, _e3759.member);
                                        } else {
                                            phi_2490_ = _e3759;
                                            phi_2515_ = type_29(0u, type_29().member_1);
                                        }
                                        let _e3775 = phi_2490_;
                                        let _e3777 = phi_2515_;
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
                                                phi_2582_ = array<f64, 3>(_e3813[0], _e3813[1], _e3813[2]);
                                            } else {
                                                phi_2582_ = _e3761;
                                            }
                                            let _e3819 = phi_2582_;
                                            phi_2493_ = _e3819;
                                        } else {
                                            phi_2493_ = array<f64, 3>();
                                        }
                                        let _e3821 = phi_2493_;
                                        continue;
                                        continuing {
                                            phi_2489_ = _e3775;
                                            phi_2492_ = _e3821;
                                            break if !(_e3781);
                                        }
                                    }
                                    let _e5604 = local_74;
                                    phi_2583_ = _e5604;
                                } else {
                                    phi_2583_ = _e3654;
                                }
                                let _e3824 = phi_2583_;
                                if (_e3824[0] < 0.0lf) {
                                    phi_2590_ = -(_e3824[0]);
                                } else {
                                    phi_2590_ = _e3824[0];
                                }
                                let _e3829 = phi_2590_;
                                if (_e3824[1] < 0.0lf) {
                                    phi_2597_ = -(_e3824[1]);
                                } else {
                                    phi_2597_ = _e3824[1];
                                }
                                let _e3834 = phi_2597_;
                                if (_e3824[2] < 0.0lf) {
                                    phi_2605_ = -(_e3824[2]);
                                } else {
                                    phi_2605_ = _e3824[2];
                                }
                                let _e3840 = phi_2605_;
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
                                                phi_2643_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2643_ = 0.0lf;
                                            }
                                            let _e3916 = phi_2643_;
                                            phi_2707_ = _e3916;
                                        } else {
                                            phi_2650_ = type_27(0i, 5i);
                                            phi_2653_ = bitcast<f64>(((bitcast<u64>(_e3858) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e3865 = phi_2650_;
                                                let _e3867 = phi_2653_;
                                                local_39 = _e3867;
                                                if (_e3865.member < _e3865.member_1) {
                                                    let _e3875 = (_e3865.member + 1i);
                                                    if ((false == (_e3875 > _e3865.member)) != false) {
                                                        phi_2674_ = true;
                                                    } else {
                                                        phi_2674_ = false;
                                                    }
                                                    let _e3880 = phi_2674_;
                                                    if _e3880 {
                                                        phi_2680_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_2680_ = type_28(1u, _e3875);
                                                    }
                                                    let _e3886 = phi_2680_;
                                                    if (bitcast<i32>(_e3886.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2651_ = type_27(_e3886.member_1, _e3865.member_1);
                                                    phi_2694_ = type_28(1u, _e3865.member);
                                                } else {
                                                    phi_2651_ = _e3865;
                                                    phi_2694_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e3896 = phi_2651_;
                                                let _e3898 = phi_2694_;
                                                let _e3901 = (bitcast<i32>(_e3898.member) != 0i);
                                                if _e3901 {
                                                    phi_2654_ = (0.5lf * (_e3867 + (_e3858 / _e3867)));
                                                } else {
                                                    phi_2654_ = f64();
                                                }
                                                let _e3906 = phi_2654_;
                                                continue;
                                                continuing {
                                                    phi_2650_ = _e3896;
                                                    phi_2653_ = _e3906;
                                                    break if !(_e3901);
                                                }
                                            }
                                            let _e3911 = local_39;
                                            phi_2707_ = (_e3911 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e3918 = phi_2707_;
                                        phi_2720_ = type_29(0u, 4u);
                                        phi_2723_ = f64(2f);
                                        loop {
                                            let _e3930 = phi_2720_;
                                            let _e3932 = phi_2723_;
                                            local_41 = _e3932;
                                            local_42 = _e3932;
                                            local_43 = _e3932;
                                            local_77 = _e3932;
                                            local_78 = _e3932;
                                            if (_e3930.member < _e3930.member_1) {
                                                phi_2721_ = type_29((_e3930.member + 1u), _e3930.member_1);
                                                phi_2746_ = type_29(1u, _e3930.member);
                                            } else {
                                                phi_2721_ = _e3930;
                                                phi_2746_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e3946 = phi_2721_;
                                            let _e3948 = phi_2746_;
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
                                                    phi_2797_ = -(_e3963);
                                                } else {
                                                    phi_2797_ = _e3963;
                                                }
                                                let _e3978 = phi_2797_;
                                                if (_e3974 < 0.0lf) {
                                                    phi_2803_ = -(_e3974);
                                                } else {
                                                    phi_2803_ = _e3974;
                                                }
                                                let _e3982 = phi_2803_;
                                                let _e3987 = (((((((((_e3371 + _e3373) + (_e3425 + _e3427)) + (_e3479 + _e3481)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3489 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e443 * _e3918) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e3978 + _e3982) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e3963 > _e3987) {
                                                    if (_e3974 > _e3987) {
                                                        phi_2817_ = false;
                                                    } else {
                                                        phi_2817_ = true;
                                                    }
                                                    let _e3991 = phi_2817_;
                                                    phi_2818_ = _e3991;
                                                } else {
                                                    phi_2818_ = true;
                                                }
                                                let _e3993 = phi_2818_;
                                                if _e3993 {
                                                    if ((_e3963 + ((_e3974 - _e3963) * _e3500)) > _e3987) {
                                                        if (_e3974 < _e3963) {
                                                            let _e4002 = ((_e3963 - _e3974) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                            if _e4002 {
                                                                let _e4010 = (((_e3963 - _e3987) / (_e3963 - _e3974)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                if (_e3932 < _e4010) {
                                                                    phi_2852_ = _e3932;
                                                                } else {
                                                                    phi_2852_ = _e4010;
                                                                }
                                                                let _e4013 = phi_2852_;
                                                                phi_2853_ = _e4013;
                                                            } else {
                                                                phi_2853_ = f64();
                                                            }
                                                            let _e4015 = phi_2853_;
                                                            phi_2854_ = _e4015;
                                                            phi_2855_ = _e4002;
                                                        } else {
                                                            phi_2854_ = _e3932;
                                                            phi_2855_ = true;
                                                        }
                                                        let _e4017 = phi_2854_;
                                                        let _e4019 = phi_2855_;
                                                        if _e4019 {
                                                            phi_2859_ = false;
                                                        } else {
                                                            phi_2859_ = true;
                                                        }
                                                        let _e4021 = phi_2859_;
                                                        phi_2860_ = _e4017;
                                                        phi_2861_ = _e4019;
                                                        phi_2862_ = _e4021;
                                                        phi_2863_ = false;
                                                    } else {
                                                        phi_2860_ = f64();
                                                        phi_2861_ = false;
                                                        phi_2862_ = false;
                                                        phi_2863_ = true;
                                                    }
                                                    let _e4023 = phi_2860_;
                                                    let _e4025 = phi_2861_;
                                                    let _e4027 = phi_2862_;
                                                    let _e4029 = phi_2863_;
                                                    phi_2864_ = _e4023;
                                                    phi_2865_ = _e4025;
                                                    phi_2866_ = _e4027;
                                                    phi_2867_ = _e4029;
                                                } else {
                                                    phi_2864_ = _e3932;
                                                    phi_2865_ = true;
                                                    phi_2866_ = false;
                                                    phi_2867_ = false;
                                                }
                                                let _e4031 = phi_2864_;
                                                let _e4033 = phi_2865_;
                                                let _e4035 = phi_2866_;
                                                let _e4037 = phi_2867_;
                                                phi_2724_ = _e4031;
                                                phi_2868_ = _e4033;
                                                phi_2869_ = false;
                                                phi_2870_ = _e4035;
                                                phi_2871_ = _e4037;
                                            } else {
                                                phi_2724_ = f64();
                                                phi_2868_ = false;
                                                phi_2869_ = true;
                                                phi_2870_ = false;
                                                phi_2871_ = false;
                                            }
                                            let _e4039 = phi_2724_;
                                            let _e4041 = phi_2868_;
                                            let _e4043 = phi_2869_;
                                            let _e4045 = phi_2870_;
                                            let _e4047 = phi_2871_;
                                            local_40 = _e4043;
                                            local_75 = _e4045;
                                            local_76 = _e4047;
                                            continue;
                                            continuing {
                                                phi_2720_ = _e3946;
                                                phi_2723_ = _e4039;
                                                break if !(_e4041);
                                            }
                                        }
                                        let _e4050 = local_40;
                                        if _e4050 {
                                            let _e4052 = local_41;
                                            let _e4053 = (_e4052 > _e3265);
                                            if _e4053 {
                                                phi_2893_ = false;
                                                phi_2894_ = false;
                                                phi_2895_ = false;
                                            } else {
                                                let _e4055 = local_42;
                                                if (_e4055 > _e3500) {
                                                    let _e4058 = local_43;
                                                    let _e4061 = ((_e4058 - _e3500) < f64(0.00000000023283064f));
                                                    if _e4061 {
                                                        phi_2889_ = false;
                                                    } else {
                                                        phi_2889_ = true;
                                                    }
                                                    let _e4063 = phi_2889_;
                                                    phi_2890_ = _e4063;
                                                    phi_2891_ = _e4061;
                                                    phi_2892_ = false;
                                                } else {
                                                    phi_2890_ = false;
                                                    phi_2891_ = false;
                                                    phi_2892_ = true;
                                                }
                                                let _e4065 = phi_2890_;
                                                let _e4067 = phi_2891_;
                                                let _e4069 = phi_2892_;
                                                phi_2893_ = _e4065;
                                                phi_2894_ = _e4067;
                                                phi_2895_ = _e4069;
                                            }
                                            let _e4071 = phi_2893_;
                                            let _e4073 = phi_2894_;
                                            let _e4075 = phi_2895_;
                                            phi_2896_ = _e4071;
                                            phi_2897_ = _e4053;
                                            phi_2898_ = _e4073;
                                            phi_2899_ = _e4075;
                                            phi_2900_ = false;
                                            phi_2901_ = false;
                                        } else {
                                            phi_2896_ = false;
                                            phi_2897_ = false;
                                            phi_2898_ = false;
                                            phi_2899_ = false;
                                            let _e5661 = local_75;
                                            phi_2900_ = _e5661;
                                            let _e5664 = local_76;
                                            phi_2901_ = _e5664;
                                        }
                                        let _e4077 = phi_2896_;
                                        let _e4079 = phi_2897_;
                                        let _e4081 = phi_2898_;
                                        let _e4083 = phi_2899_;
                                        let _e4085 = phi_2900_;
                                        let _e4087 = phi_2901_;
                                        let _e5667 = local_77;
                                        phi_2902_ = _e5667;
                                        let _e5670 = local_78;
                                        phi_2903_ = _e5670;
                                        phi_2904_ = _e4077;
                                        phi_2905_ = _e4079;
                                        phi_2906_ = _e4081;
                                        phi_2907_ = _e4083;
                                        phi_2908_ = _e4085;
                                        phi_2909_ = _e4087;
                                        phi_2910_ = false;
                                    } else {
                                        phi_2902_ = f64();
                                        phi_2903_ = f64();
                                        phi_2904_ = false;
                                        phi_2905_ = false;
                                        phi_2906_ = false;
                                        phi_2907_ = false;
                                        phi_2908_ = false;
                                        phi_2909_ = false;
                                        phi_2910_ = true;
                                    }
                                    let _e4089 = phi_2902_;
                                    let _e4091 = phi_2903_;
                                    let _e4093 = phi_2904_;
                                    let _e4095 = phi_2905_;
                                    let _e4097 = phi_2906_;
                                    let _e4099 = phi_2907_;
                                    let _e4101 = phi_2908_;
                                    let _e4103 = phi_2909_;
                                    let _e4105 = phi_2910_;
                                    phi_2911_ = _e4089;
                                    phi_2912_ = _e4091;
                                    phi_2913_ = _e4093;
                                    phi_2914_ = _e4095;
                                    phi_2915_ = _e4097;
                                    phi_2916_ = _e4099;
                                    phi_2917_ = _e4101;
                                    phi_2918_ = _e4103;
                                    phi_2919_ = _e4105;
                                    phi_2920_ = false;
                                } else {
                                    phi_2911_ = f64();
                                    phi_2912_ = f64();
                                    phi_2913_ = false;
                                    phi_2914_ = false;
                                    phi_2915_ = false;
                                    phi_2916_ = false;
                                    phi_2917_ = false;
                                    phi_2918_ = false;
                                    phi_2919_ = false;
                                    phi_2920_ = true;
                                }
                                let _e4107 = phi_2911_;
                                let _e4109 = phi_2912_;
                                let _e4111 = phi_2913_;
                                let _e4113 = phi_2914_;
                                let _e4115 = phi_2915_;
                                let _e4117 = phi_2916_;
                                let _e4119 = phi_2917_;
                                let _e4121 = phi_2918_;
                                let _e4123 = phi_2919_;
                                let _e4125 = phi_2920_;
                                phi_2921_ = _e4107;
                                phi_1970_ = _e4109;
                                phi_2922_ = _e4111;
                                phi_2923_ = _e4113;
                                phi_2924_ = _e4115;
                                phi_2925_ = false;
                                phi_2926_ = _e4117;
                                phi_2927_ = _e4119;
                                phi_2928_ = _e4121;
                                phi_2929_ = _e4123;
                                phi_2930_ = _e4125;
                            } else {
                                phi_2921_ = f64();
                                phi_1970_ = f64();
                                phi_2922_ = false;
                                phi_2923_ = false;
                                phi_2924_ = false;
                                phi_2925_ = true;
                                phi_2926_ = false;
                                phi_2927_ = false;
                                phi_2928_ = false;
                                phi_2929_ = false;
                                phi_2930_ = false;
                            }
                            let _e4127 = phi_2921_;
                            let _e4129 = phi_1970_;
                            let _e4131 = phi_2922_;
                            let _e4133 = phi_2923_;
                            let _e4135 = phi_2924_;
                            let _e4137 = phi_2925_;
                            let _e4139 = phi_2926_;
                            let _e4141 = phi_2927_;
                            let _e4143 = phi_2928_;
                            let _e4145 = phi_2929_;
                            let _e4147 = phi_2930_;
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
                                phi_1966_ = _e3514;
                                phi_1969_ = _e4129;
                                break if !(_e4131);
                            }
                        }
                        let _e4150 = local_44;
                        if _e4150 {
                            phi_2935_ = type_73(0u, type_73().member_1);
                            phi_2936_ = false;
                            phi_2937_ = false;
                            phi_2938_ = false;
                            phi_2939_ = false;
                            phi_2940_ = false;
                            phi_2941_ = false;
                            phi_2942_ = false;
                        } else {
                            phi_2935_ = type_73();
                            let _e5703 = local_79;
                            phi_2936_ = _e5703;
                            let _e5706 = local_80;
                            phi_2937_ = _e5706;
                            let _e5709 = local_81;
                            phi_2938_ = _e5709;
                            let _e5712 = local_82;
                            phi_2939_ = _e5712;
                            let _e5715 = local_83;
                            phi_2940_ = _e5715;
                            let _e5718 = local_84;
                            phi_2941_ = _e5718;
                            let _e5721 = local_85;
                            phi_2942_ = _e5721;
                        }
                        let _e4155 = phi_2935_;
                        let _e4157 = phi_2936_;
                        let _e4159 = phi_2937_;
                        let _e4161 = phi_2938_;
                        let _e4163 = phi_2939_;
                        let _e4165 = phi_2940_;
                        let _e4167 = phi_2941_;
                        let _e4169 = phi_2942_;
                        if _e4157 {
                            let _e5724 = local_86;
                            phi_2946_ = _e5724;
                            phi_2947_ = true;
                            phi_2948_ = false;
                            phi_2949_ = false;
                            phi_2950_ = false;
                            phi_2951_ = false;
                            phi_2952_ = false;
                            phi_2953_ = false;
                        } else {
                            let _e5726 = local_87;
                            phi_2946_ = _e5726;
                            phi_2947_ = _e4159;
                            phi_2948_ = _e4161;
                            phi_2949_ = _e4163;
                            phi_2950_ = _e4165;
                            let _e5733 = local_88;
                            phi_2951_ = _e5733;
                            phi_2952_ = _e4167;
                            phi_2953_ = _e4169;
                        }
                        let _e4171 = phi_2946_;
                        let _e4173 = phi_2947_;
                        let _e4175 = phi_2948_;
                        let _e4177 = phi_2949_;
                        let _e4179 = phi_2950_;
                        let _e4181 = phi_2951_;
                        let _e4183 = phi_2952_;
                        let _e4185 = phi_2953_;
                        if _e4173 {
                            phi_2958_ = type_73(1u, _e4171);
                            phi_2959_ = false;
                            phi_2960_ = false;
                            phi_2961_ = false;
                            phi_2962_ = false;
                            phi_2963_ = false;
                            phi_2964_ = false;
                        } else {
                            phi_2958_ = type_73();
                            phi_2959_ = _e4175;
                            phi_2960_ = _e4177;
                            phi_2961_ = _e4179;
                            phi_2962_ = _e4181;
                            phi_2963_ = _e4183;
                            phi_2964_ = _e4185;
                        }
                        let _e4188 = phi_2958_;
                        let _e4190 = phi_2959_;
                        let _e4192 = phi_2960_;
                        let _e4194 = phi_2961_;
                        let _e4196 = phi_2962_;
                        let _e4198 = phi_2963_;
                        let _e4200 = phi_2964_;
                        if _e4190 {
                            let _e4202 = local_45;
                            phi_2969_ = type_73(1u, _e4202);
                            phi_2970_ = false;
                            phi_2971_ = false;
                            phi_2972_ = true;
                            phi_2973_ = false;
                            phi_2974_ = false;
                        } else {
                            phi_2969_ = _e4155;
                            phi_2970_ = _e4192;
                            phi_2971_ = _e4194;
                            phi_2972_ = _e4196;
                            phi_2973_ = _e4198;
                            phi_2974_ = _e4200;
                        }
                        let _e4205 = phi_2969_;
                        let _e4207 = phi_2970_;
                        let _e4209 = phi_2971_;
                        let _e4211 = phi_2972_;
                        let _e4213 = phi_2973_;
                        let _e4215 = phi_2974_;
                        if _e4207 {
                            let _e4217 = local_46;
                            phi_2979_ = type_73(1u, _e4217);
                            phi_2980_ = false;
                            phi_2981_ = false;
                            phi_2982_ = false;
                            phi_2983_ = false;
                        } else {
                            phi_2979_ = type_73();
                            phi_2980_ = _e4209;
                            phi_2981_ = _e4211;
                            phi_2982_ = _e4213;
                            phi_2983_ = _e4215;
                        }
                        let _e4220 = phi_2979_;
                        let _e4222 = phi_2980_;
                        let _e4224 = phi_2981_;
                        let _e4226 = phi_2982_;
                        let _e4228 = phi_2983_;
                        if _e4222 {
                            let _e4230 = local_47;
                            phi_2988_ = type_73(1u, _e4230);
                            phi_2989_ = true;
                            phi_2990_ = false;
                            phi_2991_ = false;
                            phi_2992_ = false;
                        } else {
                            phi_2988_ = _e4220;
                            phi_2989_ = _e4207;
                            phi_2990_ = _e4224;
                            phi_2991_ = _e4226;
                            phi_2992_ = _e4228;
                        }
                        let _e4233 = phi_2988_;
                        let _e4235 = phi_2989_;
                        let _e4237 = phi_2990_;
                        let _e4239 = phi_2991_;
                        let _e4241 = phi_2992_;
                        if _e4235 {
                            phi_2996_ = _e4233;
                            phi_2997_ = true;
                            phi_2998_ = false;
                            phi_2999_ = false;
                        } else {
                            phi_2996_ = _e4205;
                            phi_2997_ = _e4237;
                            phi_2998_ = _e4239;
                            phi_2999_ = _e4241;
                        }
                        let _e4243 = phi_2996_;
                        let _e4245 = phi_2997_;
                        let _e4247 = phi_2998_;
                        let _e4249 = phi_2999_;
                        if _e4245 {
                            phi_3003_ = false;
                            phi_3004_ = false;
                        } else {
                            phi_3003_ = _e4247;
                            phi_3004_ = _e4249;
                        }
                        let _e4251 = phi_3003_;
                        let _e4253 = phi_3004_;
                        if _e4251 {
                            phi_3008_ = false;
                            phi_3009_ = false;
                        } else {
                            phi_3008_ = _e4253;
                            phi_3009_ = _e4245;
                        }
                        let _e4255 = phi_3008_;
                        let _e4257 = phi_3009_;
                        if _e4255 {
                            phi_3013_ = true;
                            phi_3014_ = false;
                        } else {
                            phi_3013_ = _e4251;
                            phi_3014_ = _e4257;
                        }
                        let _e4259 = phi_3013_;
                        let _e4261 = phi_3014_;
                        if _e4259 {
                            let _e4263 = local_48;
                            phi_3019_ = type_73(1u, _e4263);
                            phi_3020_ = true;
                        } else {
                            phi_3019_ = _e4243;
                            phi_3020_ = _e4261;
                        }
                        let _e4266 = phi_3019_;
                        let _e4268 = phi_3020_;
                        if _e4268 {
                            phi_3024_ = _e4266;
                        } else {
                            phi_3024_ = _e4188;
                        }
                        let _e4270 = phi_3024_;
                        if (_e4270.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_3038_ = type_29(0u, 3u);
                            loop {
                                let _e4283 = phi_3038_;
                                if (_e4283.member < _e4283.member_1) {
                                    phi_3039_ = type_29((_e4283.member + 1u), _e4283.member_1);
                                    phi_3062_ = type_29(1u, _e4283.member);
                                } else {
                                    phi_3039_ = _e4283;
                                    phi_3062_ = type_29(0u, type_29().member_1);
                                }
                                let _e4297 = phi_3039_;
                                let _e4299 = phi_3062_;
                                if (bitcast<i32>(_e4299.member) != 0i) {
                                    if (_e4299.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4306 = local_14[_e4299.member_1];
                                    let _e4308 = (_e4270.member_1 + f64(_e4306));
                                    if (_e4308 < _e3265) {
                                        phi_3083_ = _e4308;
                                    } else {
                                        phi_3083_ = _e3265;
                                    }
                                    let _e4311 = phi_3083_;
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
                                            phi_3253_ = ((_e4408 + _e4412) <= f64(1f));
                                            phi_3254_ = false;
                                        } else {
                                            phi_3253_ = bool();
                                            phi_3254_ = true;
                                        }
                                        let _e4418 = phi_3253_;
                                        let _e4420 = phi_3254_;
                                        phi_3255_ = _e4418;
                                        phi_3256_ = _e4420;
                                    } else {
                                        phi_3255_ = bool();
                                        phi_3256_ = true;
                                    }
                                    let _e4422 = phi_3255_;
                                    let _e4424 = phi_3256_;
                                    if _e4424 {
                                        phi_3260_ = false;
                                    } else {
                                        phi_3260_ = _e4422;
                                    }
                                    let _e4426 = phi_3260_;
                                    if (_e4402 > _e4403) {
                                        if _e4426 {
                                            phi_3282_ = array<f64, 3>((_e4330 - ((_e4351 * _e4408) + (_e4372 * _e4412))), (_e4331 - ((_e4352 * _e4408) + (_e4373 * _e4412))), (_e4332 - ((_e4353 * _e4408) + (_e4374 * _e4412))));
                                            phi_3283_ = false;
                                        } else {
                                            phi_3282_ = array<f64, 3>();
                                            phi_3283_ = true;
                                        }
                                        let _e4442 = phi_3282_;
                                        let _e4444 = phi_3283_;
                                        phi_3284_ = _e4442;
                                        phi_3285_ = _e4444;
                                    } else {
                                        phi_3284_ = array<f64, 3>();
                                        phi_3285_ = true;
                                    }
                                    let _e4446 = phi_3284_;
                                    let _e4448 = phi_3285_;
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
                                                phi_3472_ = _e4465;
                                            } else {
                                                phi_3472_ = f64(1f);
                                            }
                                            let _e4473 = phi_3472_;
                                            phi_3474_ = _e4473;
                                        } else {
                                            phi_3474_ = f64(0f);
                                        }
                                        let _e4475 = phi_3474_;
                                        let _e4479 = (_e4449 - (_e4452 * _e4475));
                                        let _e4480 = (_e4450 - (_e4453 * _e4475));
                                        let _e4481 = (_e4451 - (_e4454 * _e4475));
                                        let _e4492 = ((((_e4330 * _e4351) + (_e4331 * _e4352)) + (_e4332 * _e4353)) / (((_e4351 * _e4351) + (_e4352 * _e4352)) + (_e4353 * _e4353)));
                                        if (_e4492 > f64(0f)) {
                                            if (_e4492 < f64(1f)) {
                                                phi_3504_ = _e4492;
                                            } else {
                                                phi_3504_ = f64(1f);
                                            }
                                            let _e4500 = phi_3504_;
                                            phi_3506_ = _e4500;
                                        } else {
                                            phi_3506_ = f64(0f);
                                        }
                                        let _e4502 = phi_3506_;
                                        let _e4519 = ((((_e4330 * _e4372) + (_e4331 * _e4373)) + (_e4332 * _e4374)) / (((_e4372 * _e4372) + (_e4373 * _e4373)) + (_e4374 * _e4374)));
                                        if (_e4519 > f64(0f)) {
                                            if (_e4519 < f64(1f)) {
                                                phi_3536_ = _e4519;
                                            } else {
                                                phi_3536_ = f64(1f);
                                            }
                                            let _e4527 = phi_3536_;
                                            phi_3538_ = _e4527;
                                        } else {
                                            phi_3538_ = f64(0f);
                                        }
                                        let _e4529 = phi_3538_;
                                        local_10[0u] = array<f64, 3>((_e4330 - (_e4351 * _e4502)), (_e4331 - (_e4352 * _e4502)), (_e4332 - (_e4353 * _e4502)));
                                        local_10[1u] = array<f64, 3>((_e4330 - (_e4372 * _e4529)), (_e4331 - (_e4373 * _e4529)), (_e4332 - (_e4374 * _e4529)));
                                        local_10[2u] = array<f64, 3>(_e4479, _e4480, _e4481);
                                        local_10[3u] = array<f64, 3>(_e4479, _e4480, _e4481);
                                        let _e4545 = local_10[0u];
                                        phi_3574_ = type_29(1u, 4u);
                                        phi_3577_ = array<f64, 3>(_e4545[0], _e4545[1], _e4545[2]);
                                        loop {
                                            let _e4551 = phi_3574_;
                                            let _e4553 = phi_3577_;
                                            local_89 = _e4553;
                                            if (_e4551.member < _e4551.member_1) {
                                                phi_3575_ = type_29((_e4551.member + 1u), _e4551.member_1);
                                                phi_3600_ = type_29(1u, _e4551.member);
                                            } else {
                                                phi_3575_ = _e4551;
                                                phi_3600_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e4567 = phi_3575_;
                                            let _e4569 = phi_3600_;
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
                                                    phi_3667_ = array<f64, 3>(_e4605[0], _e4605[1], _e4605[2]);
                                                } else {
                                                    phi_3667_ = _e4553;
                                                }
                                                let _e4611 = phi_3667_;
                                                phi_3578_ = _e4611;
                                            } else {
                                                phi_3578_ = array<f64, 3>();
                                            }
                                            let _e4613 = phi_3578_;
                                            continue;
                                            continuing {
                                                phi_3574_ = _e4567;
                                                phi_3577_ = _e4613;
                                                break if !(_e4573);
                                            }
                                        }
                                        let _e5803 = local_89;
                                        phi_3668_ = _e5803;
                                    } else {
                                        phi_3668_ = _e4446;
                                    }
                                    let _e4616 = phi_3668_;
                                    let _e4627 = (((_e4616[0] * _e4616[0]) + (_e4616[1] * _e4616[1])) + (_e4616[2] * _e4616[2]));
                                    if (_e4627 <= 2.2250738585072014e-308lf) {
                                        if (_e4627 > 0.0lf) {
                                            phi_3693_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3693_ = 0.0lf;
                                        }
                                        let _e4685 = phi_3693_;
                                        phi_3757_ = _e4685;
                                    } else {
                                        phi_3700_ = type_27(0i, 5i);
                                        phi_3703_ = bitcast<f64>(((bitcast<u64>(_e4627) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e4634 = phi_3700_;
                                            let _e4636 = phi_3703_;
                                            local_49 = _e4636;
                                            if (_e4634.member < _e4634.member_1) {
                                                let _e4644 = (_e4634.member + 1i);
                                                if ((false == (_e4644 > _e4634.member)) != false) {
                                                    phi_3724_ = true;
                                                } else {
                                                    phi_3724_ = false;
                                                }
                                                let _e4649 = phi_3724_;
                                                if _e4649 {
                                                    phi_3730_ = type_28(0u, type_28().member_1);
                                                } else {
                                                    phi_3730_ = type_28(1u, _e4644);
                                                }
                                                let _e4655 = phi_3730_;
                                                if (bitcast<i32>(_e4655.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3701_ = type_27(_e4655.member_1, _e4634.member_1);
                                                phi_3744_ = type_28(1u, _e4634.member);
                                            } else {
                                                phi_3701_ = _e4634;
                                                phi_3744_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4665 = phi_3701_;
                                            let _e4667 = phi_3744_;
                                            let _e4670 = (bitcast<i32>(_e4667.member) != 0i);
                                            if _e4670 {
                                                phi_3704_ = (0.5lf * (_e4636 + (_e4627 / _e4636)));
                                            } else {
                                                phi_3704_ = f64();
                                            }
                                            let _e4675 = phi_3704_;
                                            continue;
                                            continuing {
                                                phi_3700_ = _e4665;
                                                phi_3703_ = _e4675;
                                                break if !(_e4670);
                                            }
                                        }
                                        let _e4680 = local_49;
                                        phi_3757_ = (_e4680 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e4687 = phi_3757_;
                                    let _e4695 = local_20.member[0u];
                                    if (_e4695[0] < 0.0lf) {
                                        phi_3775_ = -(_e4695[0]);
                                    } else {
                                        phi_3775_ = _e4695[0];
                                    }
                                    let _e4702 = phi_3775_;
                                    if (_e4695[1] < 0.0lf) {
                                        phi_3782_ = -(_e4695[1]);
                                    } else {
                                        phi_3782_ = _e4695[1];
                                    }
                                    let _e4706 = phi_3782_;
                                    if (_e4702 > _e4706) {
                                        phi_3787_ = _e4702;
                                    } else {
                                        phi_3787_ = _e4706;
                                    }
                                    let _e4709 = phi_3787_;
                                    if (_e4695[2] < 0.0lf) {
                                        phi_3794_ = -(_e4695[2]);
                                    } else {
                                        phi_3794_ = _e4695[2];
                                    }
                                    let _e4713 = phi_3794_;
                                    if (_e4709 > _e4713) {
                                        phi_3799_ = _e4709;
                                    } else {
                                        phi_3799_ = _e4713;
                                    }
                                    let _e4716 = phi_3799_;
                                    let _e4719 = local_20.member[1u];
                                    if (_e4719[0] < 0.0lf) {
                                        phi_3812_ = -(_e4719[0]);
                                    } else {
                                        phi_3812_ = _e4719[0];
                                    }
                                    let _e4726 = phi_3812_;
                                    if (_e4719[1] < 0.0lf) {
                                        phi_3819_ = -(_e4719[1]);
                                    } else {
                                        phi_3819_ = _e4719[1];
                                    }
                                    let _e4730 = phi_3819_;
                                    if (_e4726 > _e4730) {
                                        phi_3824_ = _e4726;
                                    } else {
                                        phi_3824_ = _e4730;
                                    }
                                    let _e4733 = phi_3824_;
                                    if (_e4719[2] < 0.0lf) {
                                        phi_3831_ = -(_e4719[2]);
                                    } else {
                                        phi_3831_ = _e4719[2];
                                    }
                                    let _e4737 = phi_3831_;
                                    if (_e4733 > _e4737) {
                                        phi_3836_ = _e4733;
                                    } else {
                                        phi_3836_ = _e4737;
                                    }
                                    let _e4740 = phi_3836_;
                                    if (_e4716 > _e4740) {
                                        phi_3841_ = _e4716;
                                    } else {
                                        phi_3841_ = _e4740;
                                    }
                                    let _e4743 = phi_3841_;
                                    let _e4745 = local_20.member_3;
                                    let _e4749 = local_20.member_1[0u];
                                    if (_e4749[0] < 0.0lf) {
                                        phi_3858_ = -(_e4749[0]);
                                    } else {
                                        phi_3858_ = _e4749[0];
                                    }
                                    let _e4756 = phi_3858_;
                                    if (_e4749[1] < 0.0lf) {
                                        phi_3865_ = -(_e4749[1]);
                                    } else {
                                        phi_3865_ = _e4749[1];
                                    }
                                    let _e4760 = phi_3865_;
                                    if (_e4756 > _e4760) {
                                        phi_3870_ = _e4756;
                                    } else {
                                        phi_3870_ = _e4760;
                                    }
                                    let _e4763 = phi_3870_;
                                    if (_e4749[2] < 0.0lf) {
                                        phi_3877_ = -(_e4749[2]);
                                    } else {
                                        phi_3877_ = _e4749[2];
                                    }
                                    let _e4767 = phi_3877_;
                                    if (_e4763 > _e4767) {
                                        phi_3882_ = _e4763;
                                    } else {
                                        phi_3882_ = _e4767;
                                    }
                                    let _e4770 = phi_3882_;
                                    let _e4773 = local_20.member_1[1u];
                                    if (_e4773[0] < 0.0lf) {
                                        phi_3896_ = -(_e4773[0]);
                                    } else {
                                        phi_3896_ = _e4773[0];
                                    }
                                    let _e4780 = phi_3896_;
                                    if (_e4773[1] < 0.0lf) {
                                        phi_3903_ = -(_e4773[1]);
                                    } else {
                                        phi_3903_ = _e4773[1];
                                    }
                                    let _e4784 = phi_3903_;
                                    if (_e4780 > _e4784) {
                                        phi_3908_ = _e4780;
                                    } else {
                                        phi_3908_ = _e4784;
                                    }
                                    let _e4787 = phi_3908_;
                                    if (_e4773[2] < 0.0lf) {
                                        phi_3915_ = -(_e4773[2]);
                                    } else {
                                        phi_3915_ = _e4773[2];
                                    }
                                    let _e4791 = phi_3915_;
                                    if (_e4787 > _e4791) {
                                        phi_3920_ = _e4787;
                                    } else {
                                        phi_3920_ = _e4791;
                                    }
                                    let _e4794 = phi_3920_;
                                    if (_e4770 > _e4794) {
                                        phi_3925_ = _e4770;
                                    } else {
                                        phi_3925_ = _e4794;
                                    }
                                    let _e4797 = phi_3925_;
                                    let _e4799 = local_20.member_3;
                                    let _e4803 = local_20.member_2[0u];
                                    if (_e4803[0] < 0.0lf) {
                                        phi_3942_ = -(_e4803[0]);
                                    } else {
                                        phi_3942_ = _e4803[0];
                                    }
                                    let _e4810 = phi_3942_;
                                    if (_e4803[1] < 0.0lf) {
                                        phi_3949_ = -(_e4803[1]);
                                    } else {
                                        phi_3949_ = _e4803[1];
                                    }
                                    let _e4814 = phi_3949_;
                                    if (_e4810 > _e4814) {
                                        phi_3954_ = _e4810;
                                    } else {
                                        phi_3954_ = _e4814;
                                    }
                                    let _e4817 = phi_3954_;
                                    if (_e4803[2] < 0.0lf) {
                                        phi_3961_ = -(_e4803[2]);
                                    } else {
                                        phi_3961_ = _e4803[2];
                                    }
                                    let _e4821 = phi_3961_;
                                    if (_e4817 > _e4821) {
                                        phi_3966_ = _e4817;
                                    } else {
                                        phi_3966_ = _e4821;
                                    }
                                    let _e4824 = phi_3966_;
                                    let _e4827 = local_20.member_2[1u];
                                    if (_e4827[0] < 0.0lf) {
                                        phi_3980_ = -(_e4827[0]);
                                    } else {
                                        phi_3980_ = _e4827[0];
                                    }
                                    let _e4834 = phi_3980_;
                                    if (_e4827[1] < 0.0lf) {
                                        phi_3987_ = -(_e4827[1]);
                                    } else {
                                        phi_3987_ = _e4827[1];
                                    }
                                    let _e4838 = phi_3987_;
                                    if (_e4834 > _e4838) {
                                        phi_3992_ = _e4834;
                                    } else {
                                        phi_3992_ = _e4838;
                                    }
                                    let _e4841 = phi_3992_;
                                    if (_e4827[2] < 0.0lf) {
                                        phi_3999_ = -(_e4827[2]);
                                    } else {
                                        phi_3999_ = _e4827[2];
                                    }
                                    let _e4845 = phi_3999_;
                                    if (_e4841 > _e4845) {
                                        phi_4004_ = _e4841;
                                    } else {
                                        phi_4004_ = _e4845;
                                    }
                                    let _e4848 = phi_4004_;
                                    if (_e4824 > _e4848) {
                                        phi_4009_ = _e4824;
                                    } else {
                                        phi_4009_ = _e4848;
                                    }
                                    let _e4851 = phi_4009_;
                                    let _e4853 = local_20.member_3;
                                    let _e4861 = local_20.member_3;
                                    let _e4871 = (((_e4687 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e4743 + _e4745) + (_e4797 + _e4799)) + (_e4851 + _e4853)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4861 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e443);
                                    if _e4871 {
                                        phi_4033_ = false;
                                    } else {
                                        phi_4033_ = true;
                                    }
                                    let _e4873 = phi_4033_;
                                    phi_4034_ = _e4873;
                                    phi_4035_ = _e4871;
                                } else {
                                    phi_4034_ = false;
                                    phi_4035_ = false;
                                }
                                let _e4875 = phi_4034_;
                                let _e4877 = phi_4035_;
                                local_50 = _e4877;
                                continue;
                                continuing {
                                    phi_3038_ = _e4297;
                                    break if !(_e4875);
                                }
                            }
                            let _e4880 = local_50;
                            if _e4880 {
                                phi_4040_ = type_73(1u, _e4270.member_1);
                                phi_4041_ = false;
                            } else {
                                phi_4040_ = type_73();
                                phi_4041_ = true;
                            }
                            let _e4883 = phi_4040_;
                            let _e4885 = phi_4041_;
                            if _e4885 {
                                phi_4046_ = type_73(2u, _e4270.member_1);
                                phi_4047_ = false;
                            } else {
                                phi_4046_ = type_73();
                                phi_4047_ = true;
                            }
                            let _e4888 = phi_4046_;
                            let _e4890 = phi_4047_;
                            phi_4049_ = _e4888;
                            phi_4050_ = _e4883;
                            phi_4051_ = _e4890;
                        } else {
                            phi_4049_ = type_73();
                            phi_4050_ = type_73(0u, type_73().member_1);
                            phi_4051_ = true;
                        }
                        let _e4892 = phi_4049_;
                        let _e4894 = phi_4050_;
                        let _e4896 = phi_4051_;
                        if _e4896 {
                            phi_4055_ = _e4894;
                        } else {
                            phi_4055_ = _e4892;
                        }
                        let _e4898 = phi_4055_;
                        phi_7426_ = _e4898;
                    } else {
                        if (_e542 < 0.0lf) {
                            phi_4066_ = -(_e542);
                        } else {
                            phi_4066_ = _e542;
                        }
                        let _e897 = phi_4066_;
                        if (_e565 < 0.0lf) {
                            phi_4072_ = -(_e565);
                        } else {
                            phi_4072_ = _e565;
                        }
                        let _e901 = phi_4072_;
                        if (_e897 > _e901) {
                            phi_4077_ = _e897;
                        } else {
                            phi_4077_ = _e901;
                        }
                        let _e904 = phi_4077_;
                        if (_e588 < 0.0lf) {
                            phi_4083_ = -(_e588);
                        } else {
                            phi_4083_ = _e588;
                        }
                        let _e908 = phi_4083_;
                        if (_e599 < 0.0lf) {
                            phi_4089_ = -(_e599);
                        } else {
                            phi_4089_ = _e599;
                        }
                        let _e912 = phi_4089_;
                        if (_e908 > _e912) {
                            phi_4094_ = _e908;
                        } else {
                            phi_4094_ = _e912;
                        }
                        let _e915 = phi_4094_;
                        if (_e904 > _e915) {
                            phi_4099_ = _e904;
                        } else {
                            phi_4099_ = _e915;
                        }
                        let _e918 = phi_4099_;
                        let _e920 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e921 = f64(1f);
                        if (_e918 >= _e920) {
                            phi_4109_ = (_e918 <= (_e921 / _e920));
                        } else {
                            phi_4109_ = false;
                        }
                        let _e926 = phi_4109_;
                        if _e926 {
                            phi_4116_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_4116_ = f64(2f);
                        }
                        let _e931 = phi_4116_;
                        let _e933 = ((_e858 * f64(0.34f)) + (_e918 * _e931));
                        if _e926 {
                            phi_4124_ = (_e921 / _e918);
                        } else {
                            phi_4124_ = f64(0f);
                        }
                        let _e937 = phi_4124_;
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
                                    phi_4160_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4160_ = 0.0lf;
                                }
                                let _e1014 = phi_4160_;
                                phi_4224_ = _e1014;
                            } else {
                                phi_4167_ = type_27(0i, 5i);
                                phi_4170_ = bitcast<f64>(((bitcast<u64>(_e955) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e963 = phi_4167_;
                                    let _e965 = phi_4170_;
                                    local_21 = _e965;
                                    if (_e963.member < _e963.member_1) {
                                        let _e973 = (_e963.member + 1i);
                                        if ((false == (_e973 > _e963.member)) != false) {
                                            phi_4191_ = true;
                                        } else {
                                            phi_4191_ = false;
                                        }
                                        let _e978 = phi_4191_;
                                        if _e978 {
                                            phi_4197_ = type_28(0u, type_28().member_1);
                                        } else {
                                            phi_4197_ = type_28(1u, _e973);
                                        }
                                        let _e984 = phi_4197_;
                                        if (bitcast<i32>(_e984.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_4168_ = type_27(_e984.member_1, _e963.member_1);
                                        phi_4211_ = type_28(1u, _e963.member);
                                    } else {
                                        phi_4168_ = _e963;
                                        phi_4211_ = type_28(0u, type_28().member_1);
                                    }
                                    let _e994 = phi_4168_;
                                    let _e996 = phi_4211_;
                                    let _e999 = (bitcast<i32>(_e996.member) != 0i);
                                    if _e999 {
                                        phi_4171_ = (0.5lf * (_e965 + (_e955 / _e965)));
                                    } else {
                                        phi_4171_ = f64();
                                    }
                                    let _e1004 = phi_4171_;
                                    continue;
                                    continuing {
                                        phi_4167_ = _e994;
                                        phi_4170_ = _e1004;
                                        break if !(_e999);
                                    }
                                }
                                let _e1009 = local_21;
                                phi_4224_ = (_e1009 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1016 = phi_4224_;
                            if (_e947 < _e938) {
                                phi_4230_ = -(_e1016);
                            } else {
                                phi_4230_ = _e1016;
                            }
                            let _e1020 = phi_4230_;
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
                            phi_4255_ = type_29(0u, 2u);
                            phi_4258_ = 1u;
                            loop {
                                let _e1041 = phi_4255_;
                                let _e1043 = phi_4258_;
                                local_51 = _e1043;
                                if (_e1041.member < _e1041.member_1) {
                                    phi_4256_ = type_29((_e1041.member + 1u), _e1041.member_1);
                                    phi_4281_ = type_29(1u, _e1041.member);
                                } else {
                                    phi_4256_ = _e1041;
                                    phi_4281_ = type_29(0u, type_29().member_1);
                                }
                                let _e1057 = phi_4256_;
                                let _e1059 = phi_4281_;
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
                                            phi_4325_ = (_e1043 + 1u);
                                        } else {
                                            phi_4325_ = _e1043;
                                        }
                                        let _e1079 = phi_4325_;
                                        phi_4326_ = _e1079;
                                    } else {
                                        phi_4326_ = _e1043;
                                    }
                                    let _e1081 = phi_4326_;
                                    phi_4259_ = _e1081;
                                } else {
                                    phi_4259_ = u32();
                                }
                                let _e1083 = phi_4259_;
                                continue;
                                continuing {
                                    phi_4255_ = _e1057;
                                    phi_4258_ = _e1083;
                                    break if !(_e1063);
                                }
                            }
                            let _e5093 = local_51;
                            phi_4327_ = _e5093;
                        } else {
                            phi_4327_ = 1u;
                        }
                        let _e1086 = phi_4327_;
                        if (_e1086 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e1086] = _e939;
                        let _e1089 = local_7;
                        local_9 = _e1089;
                        phi_4347_ = type_29(0u, _e1086);
                        loop {
                            let _e1092 = phi_4347_;
                            if (_e1092.member < _e1092.member_1) {
                                phi_4348_ = type_29((_e1092.member + 1u), _e1092.member_1);
                                phi_4371_ = type_29(1u, _e1092.member);
                            } else {
                                phi_4348_ = _e1092;
                                phi_4371_ = type_29(0u, type_29().member_1);
                            }
                            let _e1106 = phi_4348_;
                            let _e1108 = phi_4371_;
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
                                    phi_4425_ = -(_e1132);
                                } else {
                                    phi_4425_ = _e1132;
                                }
                                let _e1149 = phi_4425_;
                                let _e1150 = (_e1149 > _e933);
                                if (_e1145 < 0.0lf) {
                                    phi_4432_ = -(_e1145);
                                } else {
                                    phi_4432_ = _e1145;
                                }
                                let _e1154 = phi_4432_;
                                let _e1155 = (_e1154 > _e933);
                                let _e1156 = f64(0f);
                                if _e1150 {
                                    if _e1155 {
                                        phi_4444_ = ((_e1132 > _e1156) != (_e1145 > _e1156));
                                        phi_4445_ = false;
                                    } else {
                                        phi_4444_ = bool();
                                        phi_4445_ = true;
                                    }
                                    let _e1161 = phi_4444_;
                                    let _e1163 = phi_4445_;
                                    phi_4446_ = _e1161;
                                    phi_4447_ = _e1163;
                                } else {
                                    phi_4446_ = bool();
                                    phi_4447_ = true;
                                }
                                let _e1165 = phi_4446_;
                                let _e1167 = phi_4447_;
                                if _e1167 {
                                    phi_4451_ = false;
                                } else {
                                    phi_4451_ = _e1165;
                                }
                                let _e1169 = phi_4451_;
                                if _e1150 {
                                    if _e1155 {
                                        if _e1169 {
                                            phi_4463_ = type_74();
                                        } else {
                                            phi_4463_ = type_74(f64(1f), _e1156, _e1169);
                                        }
                                        let _e1173 = phi_4463_;
                                        phi_4464_ = _e1173;
                                        phi_4465_ = _e1169;
                                    } else {
                                        phi_4464_ = type_74();
                                        phi_4465_ = true;
                                    }
                                    let _e1175 = phi_4464_;
                                    let _e1177 = phi_4465_;
                                    phi_4466_ = _e1175;
                                    phi_4467_ = _e1177;
                                } else {
                                    phi_4466_ = type_74();
                                    phi_4467_ = true;
                                }
                                let _e1179 = phi_4466_;
                                let _e1181 = phi_4467_;
                                if _e1181 {
                                    if _e1150 {
                                        if (_e1132 < _e1156) {
                                            phi_4480_ = f64(-1f);
                                        } else {
                                            phi_4480_ = f64(1f);
                                        }
                                        let _e1186 = phi_4480_;
                                        let _e1187 = f64(0.00000000000022737368f);
                                        let _e1188 = f64(0.5f);
                                        let _e1189 = f64(3f);
                                        let _e1192 = (_e588 - _e565);
                                        phi_4493_ = type_29(0u, 64u);
                                        phi_4496_ = _e1119;
                                        phi_4498_ = _e1115;
                                        phi_4500_ = (_e1188 * (_e1115 + _e1119));
                                        loop {
                                            let _e1198 = phi_4493_;
                                            let _e1200 = phi_4496_;
                                            let _e1202 = phi_4498_;
                                            let _e1204 = phi_4500_;
                                            local_53 = _e1202;
                                            if (_e1198.member < _e1198.member_1) {
                                                phi_4494_ = type_29((_e1198.member + 1u), _e1198.member_1);
                                                phi_4523_ = type_29(1u, _e1198.member);
                                            } else {
                                                phi_4494_ = _e1198;
                                                phi_4523_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1218 = phi_4494_;
                                            let _e1220 = phi_4523_;
                                            if (bitcast<i32>(_e1220.member) != 0i) {
                                                let _e1225 = (f64(1f) - _e1204);
                                                let _e1238 = ((_e1186 * ((((_e542 * _e1225) + (_e565 * _e1204)) * (_e1225 * _e1225)) + (((_e588 * _e1225) + (_e599 * _e1204)) * (_e1204 * _e1204)))) - _e933);
                                                if (_e1238 > f64(0f)) {
                                                    phi_4550_ = _e1200;
                                                    phi_4551_ = _e1204;
                                                } else {
                                                    phi_4550_ = _e1204;
                                                    phi_4551_ = _e1202;
                                                }
                                                let _e1242 = phi_4550_;
                                                let _e1244 = phi_4551_;
                                                let _e1246 = ((_e1242 - _e1244) > _e1187);
                                                if _e1246 {
                                                    let _e1248 = (f64(1f) - _e1204);
                                                    let _e1260 = (-(_e1238) / (_e1186 * (((((_e565 - (_e1189 * _e542)) * _e1248) + (_e1192 * _e1204)) * _e1248) + (((_e1192 * _e1248) + (((_e1189 * _e599) - _e588) * _e1204)) * _e1204))));
                                                    if (_e1238 > f64(0f)) {
                                                        phi_4579_ = (_e1188 * _e1187);
                                                    } else {
                                                        phi_4579_ = -((_e1188 * _e1187));
                                                    }
                                                    let _e1267 = phi_4579_;
                                                    let _e1269 = ((_e1204 + _e1260) + _e1267);
                                                    if (_e1269 > _e1244) {
                                                        if (_e1269 < _e1242) {
                                                            if (_e1260 < 0.0lf) {
                                                                phi_4595_ = -(_e1260);
                                                            } else {
                                                                phi_4595_ = _e1260;
                                                            }
                                                            let _e1275 = phi_4595_;
                                                            if (_e1275 < (_e1188 * (_e1242 - _e1244))) {
                                                                phi_4602_ = false;
                                                            } else {
                                                                phi_4602_ = true;
                                                            }
                                                            let _e1280 = phi_4602_;
                                                            phi_4603_ = _e1280;
                                                        } else {
                                                            phi_4603_ = true;
                                                        }
                                                        let _e1282 = phi_4603_;
                                                        phi_4604_ = _e1282;
                                                    } else {
                                                        phi_4604_ = true;
                                                    }
                                                    let _e1284 = phi_4604_;
                                                    if _e1284 {
                                                        phi_4610_ = (_e1188 * (_e1244 + _e1242));
                                                    } else {
                                                        phi_4610_ = _e1269;
                                                    }
                                                    let _e1288 = phi_4610_;
                                                    phi_4611_ = _e1288;
                                                    phi_4612_ = false;
                                                } else {
                                                    phi_4611_ = f64();
                                                    phi_4612_ = true;
                                                }
                                                let _e1290 = phi_4611_;
                                                let _e1292 = phi_4612_;
                                                phi_4497_ = _e1242;
                                                phi_4499_ = _e1244;
                                                phi_4501_ = _e1290;
                                                phi_4613_ = _e1244;
                                                phi_4614_ = _e1246;
                                                phi_4615_ = _e1292;
                                            } else {
                                                phi_4497_ = f64();
                                                phi_4499_ = f64();
                                                phi_4501_ = f64();
                                                phi_4613_ = f64();
                                                phi_4614_ = false;
                                                phi_4615_ = false;
                                            }
                                            let _e1294 = phi_4497_;
                                            let _e1296 = phi_4499_;
                                            let _e1298 = phi_4501_;
                                            let _e1300 = phi_4613_;
                                            let _e1302 = phi_4614_;
                                            let _e1304 = phi_4615_;
                                            local_22 = _e1304;
                                            local_52 = _e1300;
                                            continue;
                                            continuing {
                                                phi_4493_ = _e1218;
                                                phi_4496_ = _e1294;
                                                phi_4498_ = _e1296;
                                                phi_4500_ = _e1298;
                                                break if !(_e1302);
                                            }
                                        }
                                        let _e1307 = local_22;
                                        if _e1307 {
                                            let _e5135 = local_52;
                                            phi_4619_ = _e5135;
                                        } else {
                                            let _e5137 = local_53;
                                            phi_4619_ = _e5137;
                                        }
                                        let _e1309 = phi_4619_;
                                        phi_4620_ = _e1309;
                                    } else {
                                        phi_4620_ = _e1115;
                                    }
                                    let _e1311 = phi_4620_;
                                    if _e1155 {
                                        phi_4628_ = type_29(0u, 64u);
                                        phi_4631_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1315 = phi_4628_;
                                            let _e1317 = phi_4631_;
                                            if (_e1315.member < _e1315.member_1) {
                                                phi_4629_ = type_29((_e1315.member + 1u), _e1315.member_1);
                                                phi_4654_ = type_29(1u, _e1315.member);
                                            } else {
                                                phi_4629_ = _e1315;
                                                phi_4654_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1331 = phi_4629_;
                                            let _e1333 = phi_4654_;
                                            if (bitcast<i32>(_e1333.member) != 0i) {
                                                let _e1337 = (_e1311 + _e1317);
                                                if (_e1337 < _e1119) {
                                                    let _e1340 = (f64(1f) - _e1337);
                                                    let _e1351 = ((((_e542 * _e1340) + (_e565 * _e1337)) * (_e1340 * _e1340)) + (((_e588 * _e1340) + (_e599 * _e1337)) * (_e1337 * _e1337)));
                                                    let _e1353 = (f64(1f) - _e1311);
                                                    let _e1364 = ((((_e542 * _e1353) + (_e565 * _e1311)) * (_e1353 * _e1353)) + (((_e588 * _e1353) + (_e599 * _e1311)) * (_e1311 * _e1311)));
                                                    if (_e1351 < 0.0lf) {
                                                        phi_4697_ = -(_e1351);
                                                    } else {
                                                        phi_4697_ = _e1351;
                                                    }
                                                    let _e1368 = phi_4697_;
                                                    if (_e1368 > _e933) {
                                                        if (_e1364 < 0.0lf) {
                                                            phi_4707_ = -(_e1364);
                                                        } else {
                                                            phi_4707_ = _e1364;
                                                        }
                                                        let _e1373 = phi_4707_;
                                                        if (_e1373 > _e933) {
                                                            phi_4717_ = ((_e1351 > f64(0f)) == (_e1364 > f64(0f)));
                                                        } else {
                                                            phi_4717_ = false;
                                                        }
                                                        let _e1381 = phi_4717_;
                                                        phi_4719_ = !(_e1381);
                                                    } else {
                                                        phi_4719_ = false;
                                                    }
                                                    let _e1384 = phi_4719_;
                                                    if _e1384 {
                                                        phi_4724_ = f64();
                                                        phi_4725_ = false;
                                                    } else {
                                                        phi_4724_ = (_e1317 + _e1317);
                                                        phi_4725_ = true;
                                                    }
                                                    let _e1387 = phi_4724_;
                                                    let _e1389 = phi_4725_;
                                                    phi_4726_ = _e1387;
                                                    phi_4727_ = _e1389;
                                                    phi_4728_ = _e1384;
                                                    phi_4729_ = false;
                                                } else {
                                                    phi_4726_ = f64();
                                                    phi_4727_ = false;
                                                    phi_4728_ = false;
                                                    phi_4729_ = true;
                                                }
                                                let _e1391 = phi_4726_;
                                                let _e1393 = phi_4727_;
                                                let _e1395 = phi_4728_;
                                                let _e1397 = phi_4729_;
                                                phi_4730_ = _e1337;
                                                phi_4632_ = _e1391;
                                                phi_4731_ = _e1393;
                                                phi_4732_ = _e1395;
                                                phi_4733_ = _e1397;
                                                phi_4734_ = false;
                                            } else {
                                                phi_4730_ = f64();
                                                phi_4632_ = f64();
                                                phi_4731_ = false;
                                                phi_4732_ = false;
                                                phi_4733_ = false;
                                                phi_4734_ = true;
                                            }
                                            let _e1399 = phi_4730_;
                                            let _e1401 = phi_4632_;
                                            let _e1403 = phi_4731_;
                                            let _e1405 = phi_4732_;
                                            let _e1407 = phi_4733_;
                                            let _e1409 = phi_4734_;
                                            local_23 = _e1405;
                                            local_54 = _e1407;
                                            local_55 = _e1409;
                                            local_56 = _e1399;
                                            continue;
                                            continuing {
                                                phi_4628_ = _e1331;
                                                phi_4631_ = _e1401;
                                                break if !(_e1403);
                                            }
                                        }
                                        let _e1412 = local_23;
                                        if _e1412 {
                                            phi_4738_ = false;
                                            phi_4739_ = false;
                                        } else {
                                            let _e5162 = local_54;
                                            phi_4738_ = _e5162;
                                            let _e5165 = local_55;
                                            phi_4739_ = _e5165;
                                        }
                                        let _e1414 = phi_4738_;
                                        let _e1416 = phi_4739_;
                                        if _e1414 {
                                            phi_4743_ = true;
                                        } else {
                                            phi_4743_ = _e1416;
                                        }
                                        let _e1418 = phi_4743_;
                                        if _e1418 {
                                            phi_4747_ = _e1119;
                                        } else {
                                            let _e5169 = local_56;
                                            phi_4747_ = _e5169;
                                        }
                                        let _e1420 = phi_4747_;
                                        phi_4748_ = _e1420;
                                    } else {
                                        phi_4748_ = _e1119;
                                    }
                                    let _e1422 = phi_4748_;
                                    phi_4750_ = type_74(_e1311, _e1422, _e1169);
                                } else {
                                    phi_4750_ = _e1179;
                                }
                                let _e1425 = phi_4750_;
                                if (_e1425.member > _e1425.member_1) {
                                    phi_7382_ = f64();
                                    phi_7383_ = true;
                                    phi_7384_ = false;
                                    phi_7385_ = false;
                                    phi_7386_ = false;
                                } else {
                                    let _e1433 = ((_e1425.member_1 - _e1425.member) * f64(0.5f));
                                    let _e1434 = (_e1425.member + _e1433);
                                    let _e1437 = (_e1433 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1439 = local_20.member_3;
                                    let _e1442 = local_20.member[0u];
                                    if (_e1442[0] < 0.0lf) {
                                        phi_4781_ = -(_e1442[0]);
                                    } else {
                                        phi_4781_ = _e1442[0];
                                    }
                                    let _e1449 = phi_4781_;
                                    if (_e1442[1] < 0.0lf) {
                                        phi_4788_ = -(_e1442[1]);
                                    } else {
                                        phi_4788_ = _e1442[1];
                                    }
                                    let _e1453 = phi_4788_;
                                    if (_e1449 > _e1453) {
                                        phi_4793_ = _e1449;
                                    } else {
                                        phi_4793_ = _e1453;
                                    }
                                    let _e1456 = phi_4793_;
                                    if (_e1442[2] < 0.0lf) {
                                        phi_4800_ = -(_e1442[2]);
                                    } else {
                                        phi_4800_ = _e1442[2];
                                    }
                                    let _e1460 = phi_4800_;
                                    if (_e1456 > _e1460) {
                                        phi_4805_ = _e1456;
                                    } else {
                                        phi_4805_ = _e1460;
                                    }
                                    let _e1463 = phi_4805_;
                                    let _e1465 = local_20.member[1u];
                                    if (_e1465[0] < 0.0lf) {
                                        phi_4818_ = -(_e1465[0]);
                                    } else {
                                        phi_4818_ = _e1465[0];
                                    }
                                    let _e1472 = phi_4818_;
                                    if (_e1465[1] < 0.0lf) {
                                        phi_4825_ = -(_e1465[1]);
                                    } else {
                                        phi_4825_ = _e1465[1];
                                    }
                                    let _e1476 = phi_4825_;
                                    if (_e1472 > _e1476) {
                                        phi_4830_ = _e1472;
                                    } else {
                                        phi_4830_ = _e1476;
                                    }
                                    let _e1479 = phi_4830_;
                                    if (_e1465[2] < 0.0lf) {
                                        phi_4837_ = -(_e1465[2]);
                                    } else {
                                        phi_4837_ = _e1465[2];
                                    }
                                    let _e1483 = phi_4837_;
                                    if (_e1479 > _e1483) {
                                        phi_4842_ = _e1479;
                                    } else {
                                        phi_4842_ = _e1483;
                                    }
                                    let _e1486 = phi_4842_;
                                    if (_e1463 > _e1486) {
                                        phi_4847_ = _e1463;
                                    } else {
                                        phi_4847_ = _e1486;
                                    }
                                    let _e1489 = phi_4847_;
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
                                        phi_4906_ = -(_e1520);
                                    } else {
                                        phi_4906_ = _e1520;
                                    }
                                    let _e1526 = phi_4906_;
                                    if (_e1521 < 0.0lf) {
                                        phi_4912_ = -(_e1521);
                                    } else {
                                        phi_4912_ = _e1521;
                                    }
                                    let _e1530 = phi_4912_;
                                    if (_e1526 > _e1530) {
                                        phi_4917_ = _e1526;
                                    } else {
                                        phi_4917_ = _e1530;
                                    }
                                    let _e1533 = phi_4917_;
                                    if (_e1522 < 0.0lf) {
                                        phi_4923_ = -(_e1522);
                                    } else {
                                        phi_4923_ = _e1522;
                                    }
                                    let _e1537 = phi_4923_;
                                    if (_e1533 > _e1537) {
                                        phi_4928_ = _e1533;
                                    } else {
                                        phi_4928_ = _e1537;
                                    }
                                    let _e1540 = phi_4928_;
                                    let _e1548 = ((((_e1437 * _e1540) * f64(1.01f)) + ((_e1489 + _e1439) * (1.1102230246251565e-16lf * f64(8f)))) + _e1439);
                                    if (_e1507 < 0.0lf) {
                                        phi_4942_ = -(_e1507);
                                    } else {
                                        phi_4942_ = _e1507;
                                    }
                                    let _e1552 = phi_4942_;
                                    if (_e1508 < 0.0lf) {
                                        phi_4948_ = -(_e1508);
                                    } else {
                                        phi_4948_ = _e1508;
                                    }
                                    let _e1556 = phi_4948_;
                                    if (_e1552 > _e1556) {
                                        phi_4953_ = _e1552;
                                    } else {
                                        phi_4953_ = _e1556;
                                    }
                                    let _e1559 = phi_4953_;
                                    if (_e1509 < 0.0lf) {
                                        phi_4959_ = -(_e1509);
                                    } else {
                                        phi_4959_ = _e1509;
                                    }
                                    let _e1563 = phi_4959_;
                                    if (_e1559 > _e1563) {
                                        phi_4964_ = _e1559;
                                    } else {
                                        phi_4964_ = _e1563;
                                    }
                                    let _e1566 = phi_4964_;
                                    local_3 = type_52(array<f64, 3>(_e1507, _e1508, _e1509), _e1548, (_e1566 + _e1548));
                                    let _e1572 = local_20.member_3;
                                    let _e1574 = local_20.member_1[0u];
                                    if (_e1574[0] < 0.0lf) {
                                        phi_4990_ = -(_e1574[0]);
                                    } else {
                                        phi_4990_ = _e1574[0];
                                    }
                                    let _e1581 = phi_4990_;
                                    if (_e1574[1] < 0.0lf) {
                                        phi_4997_ = -(_e1574[1]);
                                    } else {
                                        phi_4997_ = _e1574[1];
                                    }
                                    let _e1585 = phi_4997_;
                                    if (_e1581 > _e1585) {
                                        phi_5002_ = _e1581;
                                    } else {
                                        phi_5002_ = _e1585;
                                    }
                                    let _e1588 = phi_5002_;
                                    if (_e1574[2] < 0.0lf) {
                                        phi_5009_ = -(_e1574[2]);
                                    } else {
                                        phi_5009_ = _e1574[2];
                                    }
                                    let _e1592 = phi_5009_;
                                    if (_e1588 > _e1592) {
                                        phi_5014_ = _e1588;
                                    } else {
                                        phi_5014_ = _e1592;
                                    }
                                    let _e1595 = phi_5014_;
                                    let _e1597 = local_20.member_1[1u];
                                    if (_e1597[0] < 0.0lf) {
                                        phi_5027_ = -(_e1597[0]);
                                    } else {
                                        phi_5027_ = _e1597[0];
                                    }
                                    let _e1604 = phi_5027_;
                                    if (_e1597[1] < 0.0lf) {
                                        phi_5034_ = -(_e1597[1]);
                                    } else {
                                        phi_5034_ = _e1597[1];
                                    }
                                    let _e1608 = phi_5034_;
                                    if (_e1604 > _e1608) {
                                        phi_5039_ = _e1604;
                                    } else {
                                        phi_5039_ = _e1608;
                                    }
                                    let _e1611 = phi_5039_;
                                    if (_e1597[2] < 0.0lf) {
                                        phi_5046_ = -(_e1597[2]);
                                    } else {
                                        phi_5046_ = _e1597[2];
                                    }
                                    let _e1615 = phi_5046_;
                                    if (_e1611 > _e1615) {
                                        phi_5051_ = _e1611;
                                    } else {
                                        phi_5051_ = _e1615;
                                    }
                                    let _e1618 = phi_5051_;
                                    if (_e1595 > _e1618) {
                                        phi_5056_ = _e1595;
                                    } else {
                                        phi_5056_ = _e1618;
                                    }
                                    let _e1621 = phi_5056_;
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
                                        phi_5115_ = -(_e1652);
                                    } else {
                                        phi_5115_ = _e1652;
                                    }
                                    let _e1658 = phi_5115_;
                                    if (_e1653 < 0.0lf) {
                                        phi_5121_ = -(_e1653);
                                    } else {
                                        phi_5121_ = _e1653;
                                    }
                                    let _e1662 = phi_5121_;
                                    if (_e1658 > _e1662) {
                                        phi_5126_ = _e1658;
                                    } else {
                                        phi_5126_ = _e1662;
                                    }
                                    let _e1665 = phi_5126_;
                                    if (_e1654 < 0.0lf) {
                                        phi_5132_ = -(_e1654);
                                    } else {
                                        phi_5132_ = _e1654;
                                    }
                                    let _e1669 = phi_5132_;
                                    if (_e1665 > _e1669) {
                                        phi_5137_ = _e1665;
                                    } else {
                                        phi_5137_ = _e1669;
                                    }
                                    let _e1672 = phi_5137_;
                                    let _e1680 = ((((_e1437 * _e1672) * f64(1.01f)) + ((_e1621 + _e1572) * (1.1102230246251565e-16lf * f64(8f)))) + _e1572);
                                    if (_e1639 < 0.0lf) {
                                        phi_5151_ = -(_e1639);
                                    } else {
                                        phi_5151_ = _e1639;
                                    }
                                    let _e1684 = phi_5151_;
                                    if (_e1640 < 0.0lf) {
                                        phi_5157_ = -(_e1640);
                                    } else {
                                        phi_5157_ = _e1640;
                                    }
                                    let _e1688 = phi_5157_;
                                    if (_e1684 > _e1688) {
                                        phi_5162_ = _e1684;
                                    } else {
                                        phi_5162_ = _e1688;
                                    }
                                    let _e1691 = phi_5162_;
                                    if (_e1641 < 0.0lf) {
                                        phi_5168_ = -(_e1641);
                                    } else {
                                        phi_5168_ = _e1641;
                                    }
                                    let _e1695 = phi_5168_;
                                    if (_e1691 > _e1695) {
                                        phi_5173_ = _e1691;
                                    } else {
                                        phi_5173_ = _e1695;
                                    }
                                    let _e1698 = phi_5173_;
                                    local_4 = type_52(array<f64, 3>(_e1639, _e1640, _e1641), _e1680, (_e1698 + _e1680));
                                    let _e1704 = local_20.member_3;
                                    let _e1706 = local_20.member_2[0u];
                                    if (_e1706[0] < 0.0lf) {
                                        phi_5199_ = -(_e1706[0]);
                                    } else {
                                        phi_5199_ = _e1706[0];
                                    }
                                    let _e1713 = phi_5199_;
                                    if (_e1706[1] < 0.0lf) {
                                        phi_5206_ = -(_e1706[1]);
                                    } else {
                                        phi_5206_ = _e1706[1];
                                    }
                                    let _e1717 = phi_5206_;
                                    if (_e1713 > _e1717) {
                                        phi_5211_ = _e1713;
                                    } else {
                                        phi_5211_ = _e1717;
                                    }
                                    let _e1720 = phi_5211_;
                                    if (_e1706[2] < 0.0lf) {
                                        phi_5218_ = -(_e1706[2]);
                                    } else {
                                        phi_5218_ = _e1706[2];
                                    }
                                    let _e1724 = phi_5218_;
                                    if (_e1720 > _e1724) {
                                        phi_5223_ = _e1720;
                                    } else {
                                        phi_5223_ = _e1724;
                                    }
                                    let _e1727 = phi_5223_;
                                    let _e1729 = local_20.member_2[1u];
                                    if (_e1729[0] < 0.0lf) {
                                        phi_5236_ = -(_e1729[0]);
                                    } else {
                                        phi_5236_ = _e1729[0];
                                    }
                                    let _e1736 = phi_5236_;
                                    if (_e1729[1] < 0.0lf) {
                                        phi_5243_ = -(_e1729[1]);
                                    } else {
                                        phi_5243_ = _e1729[1];
                                    }
                                    let _e1740 = phi_5243_;
                                    if (_e1736 > _e1740) {
                                        phi_5248_ = _e1736;
                                    } else {
                                        phi_5248_ = _e1740;
                                    }
                                    let _e1743 = phi_5248_;
                                    if (_e1729[2] < 0.0lf) {
                                        phi_5255_ = -(_e1729[2]);
                                    } else {
                                        phi_5255_ = _e1729[2];
                                    }
                                    let _e1747 = phi_5255_;
                                    if (_e1743 > _e1747) {
                                        phi_5260_ = _e1743;
                                    } else {
                                        phi_5260_ = _e1747;
                                    }
                                    let _e1750 = phi_5260_;
                                    if (_e1727 > _e1750) {
                                        phi_5265_ = _e1727;
                                    } else {
                                        phi_5265_ = _e1750;
                                    }
                                    let _e1753 = phi_5265_;
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
                                        phi_5324_ = -(_e1784);
                                    } else {
                                        phi_5324_ = _e1784;
                                    }
                                    let _e1790 = phi_5324_;
                                    if (_e1785 < 0.0lf) {
                                        phi_5330_ = -(_e1785);
                                    } else {
                                        phi_5330_ = _e1785;
                                    }
                                    let _e1794 = phi_5330_;
                                    if (_e1790 > _e1794) {
                                        phi_5335_ = _e1790;
                                    } else {
                                        phi_5335_ = _e1794;
                                    }
                                    let _e1797 = phi_5335_;
                                    if (_e1786 < 0.0lf) {
                                        phi_5341_ = -(_e1786);
                                    } else {
                                        phi_5341_ = _e1786;
                                    }
                                    let _e1801 = phi_5341_;
                                    if (_e1797 > _e1801) {
                                        phi_5346_ = _e1797;
                                    } else {
                                        phi_5346_ = _e1801;
                                    }
                                    let _e1804 = phi_5346_;
                                    let _e1812 = ((((_e1437 * _e1804) * f64(1.01f)) + ((_e1753 + _e1704) * (1.1102230246251565e-16lf * f64(8f)))) + _e1704);
                                    if (_e1771 < 0.0lf) {
                                        phi_5360_ = -(_e1771);
                                    } else {
                                        phi_5360_ = _e1771;
                                    }
                                    let _e1816 = phi_5360_;
                                    if (_e1772 < 0.0lf) {
                                        phi_5366_ = -(_e1772);
                                    } else {
                                        phi_5366_ = _e1772;
                                    }
                                    let _e1820 = phi_5366_;
                                    if (_e1816 > _e1820) {
                                        phi_5371_ = _e1816;
                                    } else {
                                        phi_5371_ = _e1820;
                                    }
                                    let _e1823 = phi_5371_;
                                    if (_e1773 < 0.0lf) {
                                        phi_5377_ = -(_e1773);
                                    } else {
                                        phi_5377_ = _e1773;
                                    }
                                    let _e1827 = phi_5377_;
                                    if (_e1823 > _e1827) {
                                        phi_5382_ = _e1823;
                                    } else {
                                        phi_5382_ = _e1827;
                                    }
                                    let _e1830 = phi_5382_;
                                    local_5 = type_52(array<f64, 3>(_e1771, _e1772, _e1773), _e1812, (_e1830 + _e1812));
                                    let _e1835 = local_4.member;
                                    let _e1840 = local_5.member;
                                    let _e1846 = ((_e1835[1] * _e1840[2]) - (_e1835[2] * _e1840[1]));
                                    let _e1849 = ((_e1835[2] * _e1840[0]) - (_e1835[0] * _e1840[2]));
                                    let _e1852 = ((_e1835[0] * _e1840[1]) - (_e1835[1] * _e1840[0]));
                                    if (_e1846 < 0.0lf) {
                                        phi_5431_ = -(_e1846);
                                    } else {
                                        phi_5431_ = _e1846;
                                    }
                                    let _e1856 = phi_5431_;
                                    if (_e1849 < 0.0lf) {
                                        phi_5437_ = -(_e1849);
                                    } else {
                                        phi_5437_ = _e1849;
                                    }
                                    let _e1860 = phi_5437_;
                                    if (_e1856 > _e1860) {
                                        if (_e1846 < 0.0lf) {
                                            phi_5447_ = -(_e1846);
                                        } else {
                                            phi_5447_ = _e1846;
                                        }
                                        let _e1878 = phi_5447_;
                                        if (_e1852 < 0.0lf) {
                                            phi_5453_ = -(_e1852);
                                        } else {
                                            phi_5453_ = _e1852;
                                        }
                                        let _e1882 = phi_5453_;
                                        if (_e1878 > _e1882) {
                                            phi_5458_ = 2u;
                                            phi_5459_ = 1u;
                                        } else {
                                            phi_5458_ = 1u;
                                            phi_5459_ = 0u;
                                        }
                                        let _e1885 = phi_5458_;
                                        let _e1887 = phi_5459_;
                                        phi_5478_ = _e1885;
                                        phi_5479_ = _e1887;
                                    } else {
                                        if (_e1849 < 0.0lf) {
                                            phi_5465_ = -(_e1849);
                                        } else {
                                            phi_5465_ = _e1849;
                                        }
                                        let _e1865 = phi_5465_;
                                        if (_e1852 < 0.0lf) {
                                            phi_5471_ = -(_e1852);
                                        } else {
                                            phi_5471_ = _e1852;
                                        }
                                        let _e1869 = phi_5471_;
                                        if (_e1865 > _e1869) {
                                            phi_5476_ = 0u;
                                            phi_5477_ = 2u;
                                        } else {
                                            phi_5476_ = 1u;
                                            phi_5477_ = 0u;
                                        }
                                        let _e1872 = phi_5476_;
                                        let _e1874 = phi_5477_;
                                        phi_5478_ = _e1872;
                                        phi_5479_ = _e1874;
                                    }
                                    let _e1889 = phi_5478_;
                                    let _e1891 = phi_5479_;
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
                                        phi_5550_ = -(_e1910);
                                    } else {
                                        phi_5550_ = _e1910;
                                    }
                                    let _e1948 = phi_5550_;
                                    if (_e1948 > _e1944) {
                                        if (_e1910 < f64(0f)) {
                                            phi_5562_ = f64(-1f);
                                        } else {
                                            phi_5562_ = f64(1f);
                                        }
                                        let _e1955 = phi_5562_;
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
                                            phi_5701_ = -(_e2062);
                                        } else {
                                            phi_5701_ = _e2062;
                                        }
                                        let _e2068 = phi_5701_;
                                        if (_e2063 < 0.0lf) {
                                            phi_5707_ = -(_e2063);
                                        } else {
                                            phi_5707_ = _e2063;
                                        }
                                        let _e2072 = phi_5707_;
                                        if (_e2064 < 0.0lf) {
                                            phi_5714_ = -(_e2064);
                                        } else {
                                            phi_5714_ = _e2064;
                                        }
                                        let _e2077 = phi_5714_;
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
                                        phi_5758_ = type_29(0u, 4u);
                                        phi_5761_ = true;
                                        loop {
                                            let _e2101 = phi_5758_;
                                            let _e2103 = phi_5761_;
                                            local_25 = _e2103;
                                            if (_e2101.member < _e2101.member_1) {
                                                phi_5759_ = type_29((_e2101.member + 1u), _e2101.member_1);
                                                phi_5784_ = type_29(1u, _e2101.member);
                                            } else {
                                                phi_5759_ = _e2101;
                                                phi_5784_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e2117 = phi_5759_;
                                            let _e2119 = phi_5784_;
                                            if (bitcast<i32>(_e2119.member) != 0i) {
                                                if (_e2119.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e2127 = local_6[_e2119.member_1].member;
                                                let _e2130 = local_6[_e2119.member_1].member_1;
                                                let _e2132 = (_e2127 < -(_e2130));
                                                if _e2132 {
                                                    phi_5811_ = bool();
                                                    phi_5812_ = false;
                                                } else {
                                                    phi_5811_ = (_e2103 && (_e2127 > _e2130));
                                                    phi_5812_ = true;
                                                }
                                                let _e2136 = phi_5811_;
                                                let _e2138 = phi_5812_;
                                                phi_5762_ = _e2136;
                                                phi_5813_ = _e2138;
                                                phi_5814_ = _e2132;
                                            } else {
                                                phi_5762_ = bool();
                                                phi_5813_ = false;
                                                phi_5814_ = false;
                                            }
                                            let _e2140 = phi_5762_;
                                            let _e2142 = phi_5813_;
                                            let _e2144 = phi_5814_;
                                            local_24 = _e2144;
                                            continue;
                                            continuing {
                                                phi_5758_ = _e2117;
                                                phi_5761_ = _e2140;
                                                break if !(_e2142);
                                            }
                                        }
                                        let _e2147 = local_24;
                                        if _e2147 {
                                            phi_5818_ = false;
                                        } else {
                                            phi_5818_ = true;
                                        }
                                        let _e2149 = phi_5818_;
                                        if _e2149 {
                                            let _e2151 = local_25;
                                            if _e2151 {
                                                phi_5825_ = 1u;
                                            } else {
                                                phi_5825_ = 2u;
                                            }
                                            let _e2153 = phi_5825_;
                                            phi_5826_ = _e2153;
                                            phi_5827_ = false;
                                        } else {
                                            phi_5826_ = u32();
                                            phi_5827_ = true;
                                        }
                                        let _e2155 = phi_5826_;
                                        let _e2157 = phi_5827_;
                                        phi_5828_ = _e2155;
                                        phi_5829_ = 0u;
                                        phi_5830_ = _e2157;
                                    } else {
                                        phi_5828_ = u32();
                                        phi_5829_ = 2u;
                                        phi_5830_ = true;
                                    }
                                    let _e2159 = phi_5828_;
                                    let _e2161 = phi_5829_;
                                    let _e2163 = phi_5830_;
                                    if _e2163 {
                                        phi_5834_ = _e2161;
                                    } else {
                                        phi_5834_ = _e2159;
                                    }
                                    let _e2165 = phi_5834_;
                                    let _e2166 = (_e2165 == 0u);
                                    if _e2166 {
                                        phi_7378_ = f64();
                                        phi_7379_ = false;
                                        phi_7380_ = false;
                                        phi_7381_ = false;
                                    } else {
                                        if (_e2165 == 1u) {
                                            if _e1425.member_2 {
                                                if ((_e1425.member_1 - _e1425.member) <= f64(0.0000005f)) {
                                                    phi_5855_ = false;
                                                } else {
                                                    phi_5855_ = true;
                                                }
                                                let _e2175 = phi_5855_;
                                                phi_5856_ = _e2175;
                                            } else {
                                                phi_5856_ = true;
                                            }
                                            let _e2177 = phi_5856_;
                                            phi_5857_ = _e2177;
                                        } else {
                                            phi_5857_ = true;
                                        }
                                        let _e2179 = phi_5857_;
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
                                                phi_6054_ = -(_e2239[0]);
                                            } else {
                                                phi_6054_ = _e2239[0];
                                            }
                                            let _e2246 = phi_6054_;
                                            if (_e2239[1] < 0.0lf) {
                                                phi_6061_ = -(_e2239[1]);
                                            } else {
                                                phi_6061_ = _e2239[1];
                                            }
                                            let _e2250 = phi_6061_;
                                            if (_e2246 > _e2250) {
                                                phi_6066_ = _e2246;
                                            } else {
                                                phi_6066_ = _e2250;
                                            }
                                            let _e2253 = phi_6066_;
                                            if (_e2239[2] < 0.0lf) {
                                                phi_6073_ = -(_e2239[2]);
                                            } else {
                                                phi_6073_ = _e2239[2];
                                            }
                                            let _e2257 = phi_6073_;
                                            if (_e2253 > _e2257) {
                                                phi_6078_ = _e2253;
                                            } else {
                                                phi_6078_ = _e2257;
                                            }
                                            let _e2260 = phi_6078_;
                                            let _e2263 = local_20.member[1u];
                                            if (_e2263[0] < 0.0lf) {
                                                phi_6091_ = -(_e2263[0]);
                                            } else {
                                                phi_6091_ = _e2263[0];
                                            }
                                            let _e2270 = phi_6091_;
                                            if (_e2263[1] < 0.0lf) {
                                                phi_6098_ = -(_e2263[1]);
                                            } else {
                                                phi_6098_ = _e2263[1];
                                            }
                                            let _e2274 = phi_6098_;
                                            if (_e2270 > _e2274) {
                                                phi_6103_ = _e2270;
                                            } else {
                                                phi_6103_ = _e2274;
                                            }
                                            let _e2277 = phi_6103_;
                                            if (_e2263[2] < 0.0lf) {
                                                phi_6110_ = -(_e2263[2]);
                                            } else {
                                                phi_6110_ = _e2263[2];
                                            }
                                            let _e2281 = phi_6110_;
                                            if (_e2277 > _e2281) {
                                                phi_6115_ = _e2277;
                                            } else {
                                                phi_6115_ = _e2281;
                                            }
                                            let _e2284 = phi_6115_;
                                            if (_e2260 > _e2284) {
                                                phi_6120_ = _e2260;
                                            } else {
                                                phi_6120_ = _e2284;
                                            }
                                            let _e2287 = phi_6120_;
                                            let _e2289 = local_20.member_3;
                                            let _e2293 = local_20.member_1[0u];
                                            if (_e2293[0] < 0.0lf) {
                                                phi_6137_ = -(_e2293[0]);
                                            } else {
                                                phi_6137_ = _e2293[0];
                                            }
                                            let _e2300 = phi_6137_;
                                            if (_e2293[1] < 0.0lf) {
                                                phi_6144_ = -(_e2293[1]);
                                            } else {
                                                phi_6144_ = _e2293[1];
                                            }
                                            let _e2304 = phi_6144_;
                                            if (_e2300 > _e2304) {
                                                phi_6149_ = _e2300;
                                            } else {
                                                phi_6149_ = _e2304;
                                            }
                                            let _e2307 = phi_6149_;
                                            if (_e2293[2] < 0.0lf) {
                                                phi_6156_ = -(_e2293[2]);
                                            } else {
                                                phi_6156_ = _e2293[2];
                                            }
                                            let _e2311 = phi_6156_;
                                            if (_e2307 > _e2311) {
                                                phi_6161_ = _e2307;
                                            } else {
                                                phi_6161_ = _e2311;
                                            }
                                            let _e2314 = phi_6161_;
                                            let _e2317 = local_20.member_1[1u];
                                            if (_e2317[0] < 0.0lf) {
                                                phi_6175_ = -(_e2317[0]);
                                            } else {
                                                phi_6175_ = _e2317[0];
                                            }
                                            let _e2324 = phi_6175_;
                                            if (_e2317[1] < 0.0lf) {
                                                phi_6182_ = -(_e2317[1]);
                                            } else {
                                                phi_6182_ = _e2317[1];
                                            }
                                            let _e2328 = phi_6182_;
                                            if (_e2324 > _e2328) {
                                                phi_6187_ = _e2324;
                                            } else {
                                                phi_6187_ = _e2328;
                                            }
                                            let _e2331 = phi_6187_;
                                            if (_e2317[2] < 0.0lf) {
                                                phi_6194_ = -(_e2317[2]);
                                            } else {
                                                phi_6194_ = _e2317[2];
                                            }
                                            let _e2335 = phi_6194_;
                                            if (_e2331 > _e2335) {
                                                phi_6199_ = _e2331;
                                            } else {
                                                phi_6199_ = _e2335;
                                            }
                                            let _e2338 = phi_6199_;
                                            if (_e2314 > _e2338) {
                                                phi_6204_ = _e2314;
                                            } else {
                                                phi_6204_ = _e2338;
                                            }
                                            let _e2341 = phi_6204_;
                                            let _e2343 = local_20.member_3;
                                            let _e2347 = local_20.member_2[0u];
                                            if (_e2347[0] < 0.0lf) {
                                                phi_6221_ = -(_e2347[0]);
                                            } else {
                                                phi_6221_ = _e2347[0];
                                            }
                                            let _e2354 = phi_6221_;
                                            if (_e2347[1] < 0.0lf) {
                                                phi_6228_ = -(_e2347[1]);
                                            } else {
                                                phi_6228_ = _e2347[1];
                                            }
                                            let _e2358 = phi_6228_;
                                            if (_e2354 > _e2358) {
                                                phi_6233_ = _e2354;
                                            } else {
                                                phi_6233_ = _e2358;
                                            }
                                            let _e2361 = phi_6233_;
                                            if (_e2347[2] < 0.0lf) {
                                                phi_6240_ = -(_e2347[2]);
                                            } else {
                                                phi_6240_ = _e2347[2];
                                            }
                                            let _e2365 = phi_6240_;
                                            if (_e2361 > _e2365) {
                                                phi_6245_ = _e2361;
                                            } else {
                                                phi_6245_ = _e2365;
                                            }
                                            let _e2368 = phi_6245_;
                                            let _e2371 = local_20.member_2[1u];
                                            if (_e2371[0] < 0.0lf) {
                                                phi_6259_ = -(_e2371[0]);
                                            } else {
                                                phi_6259_ = _e2371[0];
                                            }
                                            let _e2378 = phi_6259_;
                                            if (_e2371[1] < 0.0lf) {
                                                phi_6266_ = -(_e2371[1]);
                                            } else {
                                                phi_6266_ = _e2371[1];
                                            }
                                            let _e2382 = phi_6266_;
                                            if (_e2378 > _e2382) {
                                                phi_6271_ = _e2378;
                                            } else {
                                                phi_6271_ = _e2382;
                                            }
                                            let _e2385 = phi_6271_;
                                            if (_e2371[2] < 0.0lf) {
                                                phi_6278_ = -(_e2371[2]);
                                            } else {
                                                phi_6278_ = _e2371[2];
                                            }
                                            let _e2389 = phi_6278_;
                                            if (_e2385 > _e2389) {
                                                phi_6283_ = _e2385;
                                            } else {
                                                phi_6283_ = _e2389;
                                            }
                                            let _e2392 = phi_6283_;
                                            if (_e2368 > _e2392) {
                                                phi_6288_ = _e2368;
                                            } else {
                                                phi_6288_ = _e2392;
                                            }
                                            let _e2395 = phi_6288_;
                                            let _e2397 = local_20.member_3;
                                            let _e2405 = local_20.member_3;
                                            phi_6308_ = type_29(0u, 48u);
                                            phi_6311_ = _e1425.member;
                                            loop {
                                                let _e2414 = phi_6308_;
                                                let _e2416 = phi_6311_;
                                                local_70 = _e2416;
                                                local_32 = _e2416;
                                                local_33 = _e2416;
                                                local_34 = _e2416;
                                                local_35 = _e2416;
                                                if (_e2414.member < _e2414.member_1) {
                                                    phi_6309_ = type_29((_e2414.member + 1u), _e2414.member_1);
                                                    phi_6334_ = type_29(1u, _e2414.member);
                                                } else {
                                                    phi_6309_ = _e2414;
                                                    phi_6334_ = type_29(0u, type_29().member_1);
                                                }
                                                let _e2430 = phi_6309_;
                                                let _e2432 = phi_6334_;
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
                                                            phi_6510_ = ((_e2532 + _e2536) <= f64(1f));
                                                            phi_6511_ = false;
                                                        } else {
                                                            phi_6510_ = bool();
                                                            phi_6511_ = true;
                                                        }
                                                        let _e2542 = phi_6510_;
                                                        let _e2544 = phi_6511_;
                                                        phi_6512_ = _e2542;
                                                        phi_6513_ = _e2544;
                                                    } else {
                                                        phi_6512_ = bool();
                                                        phi_6513_ = true;
                                                    }
                                                    let _e2546 = phi_6512_;
                                                    let _e2548 = phi_6513_;
                                                    if _e2548 {
                                                        phi_6517_ = false;
                                                    } else {
                                                        phi_6517_ = _e2546;
                                                    }
                                                    let _e2550 = phi_6517_;
                                                    if (_e2526 > _e2527) {
                                                        if _e2550 {
                                                            phi_6539_ = array<f64, 3>((_e2454 - ((_e2475 * _e2532) + (_e2496 * _e2536))), (_e2455 - ((_e2476 * _e2532) + (_e2497 * _e2536))), (_e2456 - ((_e2477 * _e2532) + (_e2498 * _e2536))));
                                                            phi_6540_ = false;
                                                        } else {
                                                            phi_6539_ = array<f64, 3>();
                                                            phi_6540_ = true;
                                                        }
                                                        let _e2566 = phi_6539_;
                                                        let _e2568 = phi_6540_;
                                                        phi_6541_ = _e2566;
                                                        phi_6542_ = _e2568;
                                                    } else {
                                                        phi_6541_ = array<f64, 3>();
                                                        phi_6542_ = true;
                                                    }
                                                    let _e2570 = phi_6541_;
                                                    let _e2572 = phi_6542_;
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
                                                                phi_6729_ = _e2589;
                                                            } else {
                                                                phi_6729_ = f64(1f);
                                                            }
                                                            let _e2597 = phi_6729_;
                                                            phi_6731_ = _e2597;
                                                        } else {
                                                            phi_6731_ = f64(0f);
                                                        }
                                                        let _e2599 = phi_6731_;
                                                        let _e2603 = (_e2573 - (_e2576 * _e2599));
                                                        let _e2604 = (_e2574 - (_e2577 * _e2599));
                                                        let _e2605 = (_e2575 - (_e2578 * _e2599));
                                                        let _e2616 = ((((_e2454 * _e2475) + (_e2455 * _e2476)) + (_e2456 * _e2477)) / (((_e2475 * _e2475) + (_e2476 * _e2476)) + (_e2477 * _e2477)));
                                                        if (_e2616 > f64(0f)) {
                                                            if (_e2616 < f64(1f)) {
                                                                phi_6761_ = _e2616;
                                                            } else {
                                                                phi_6761_ = f64(1f);
                                                            }
                                                            let _e2624 = phi_6761_;
                                                            phi_6763_ = _e2624;
                                                        } else {
                                                            phi_6763_ = f64(0f);
                                                        }
                                                        let _e2626 = phi_6763_;
                                                        let _e2643 = ((((_e2454 * _e2496) + (_e2455 * _e2497)) + (_e2456 * _e2498)) / (((_e2496 * _e2496) + (_e2497 * _e2497)) + (_e2498 * _e2498)));
                                                        if (_e2643 > f64(0f)) {
                                                            if (_e2643 < f64(1f)) {
                                                                phi_6793_ = _e2643;
                                                            } else {
                                                                phi_6793_ = f64(1f);
                                                            }
                                                            let _e2651 = phi_6793_;
                                                            phi_6795_ = _e2651;
                                                        } else {
                                                            phi_6795_ = f64(0f);
                                                        }
                                                        let _e2653 = phi_6795_;
                                                        local[0u] = array<f64, 3>((_e2454 - (_e2475 * _e2626)), (_e2455 - (_e2476 * _e2626)), (_e2456 - (_e2477 * _e2626)));
                                                        local[1u] = array<f64, 3>((_e2454 - (_e2496 * _e2653)), (_e2455 - (_e2497 * _e2653)), (_e2456 - (_e2498 * _e2653)));
                                                        local[2u] = array<f64, 3>(_e2603, _e2604, _e2605);
                                                        local[3u] = array<f64, 3>(_e2603, _e2604, _e2605);
                                                        let _e2669 = local[0u];
                                                        phi_6831_ = type_29(1u, 4u);
                                                        phi_6834_ = array<f64, 3>(_e2669[0], _e2669[1], _e2669[2]);
                                                        loop {
                                                            let _e2675 = phi_6831_;
                                                            let _e2677 = phi_6834_;
                                                            local_57 = _e2677;
                                                            if (_e2675.member < _e2675.member_1) {
                                                                phi_6832_ = type_29((_e2675.member + 1u), _e2675.member_1);
                                                                phi_6857_ = type_29(1u, _e2675.member);
                                                            } else {
                                                                phi_6832_ = _e2675;
                                                                phi_6857_ = type_29(0u, type_29().member_1);
                                                            }
                                                            let _e2691 = phi_6832_;
                                                            let _e2693 = phi_6857_;
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
                                                                    phi_6924_ = array<f64, 3>(_e2729[0], _e2729[1], _e2729[2]);
                                                                } else {
                                                                    phi_6924_ = _e2677;
                                                                }
                                                                let _e2735 = phi_6924_;
                                                                phi_6835_ = _e2735;
                                                            } else {
                                                                phi_6835_ = array<f64, 3>();
                                                            }
                                                            let _e2737 = phi_6835_;
                                                            continue;
                                                            continuing {
                                                                phi_6831_ = _e2691;
                                                                phi_6834_ = _e2737;
                                                                break if !(_e2697);
                                                            }
                                                        }
                                                        let _e5334 = local_57;
                                                        phi_6925_ = _e5334;
                                                    } else {
                                                        phi_6925_ = _e2570;
                                                    }
                                                    let _e2740 = phi_6925_;
                                                    if (_e2740[0] < 0.0lf) {
                                                        phi_6932_ = -(_e2740[0]);
                                                    } else {
                                                        phi_6932_ = _e2740[0];
                                                    }
                                                    let _e2745 = phi_6932_;
                                                    if (_e2740[1] < 0.0lf) {
                                                        phi_6939_ = -(_e2740[1]);
                                                    } else {
                                                        phi_6939_ = _e2740[1];
                                                    }
                                                    let _e2750 = phi_6939_;
                                                    if (_e2740[2] < 0.0lf) {
                                                        phi_6947_ = -(_e2740[2]);
                                                    } else {
                                                        phi_6947_ = _e2740[2];
                                                    }
                                                    let _e2756 = phi_6947_;
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
                                                                    phi_6985_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_6985_ = 0.0lf;
                                                                }
                                                                let _e2832 = phi_6985_;
                                                                phi_7049_ = _e2832;
                                                            } else {
                                                                phi_6992_ = type_27(0i, 5i);
                                                                phi_6995_ = bitcast<f64>(((bitcast<u64>(_e2774) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2781 = phi_6992_;
                                                                    let _e2783 = phi_6995_;
                                                                    local_26 = _e2783;
                                                                    if (_e2781.member < _e2781.member_1) {
                                                                        let _e2791 = (_e2781.member + 1i);
                                                                        if ((false == (_e2791 > _e2781.member)) != false) {
                                                                            phi_7016_ = true;
                                                                        } else {
                                                                            phi_7016_ = false;
                                                                        }
                                                                        let _e2796 = phi_7016_;
                                                                        if _e2796 {
                                                                            phi_7022_ = type_28(0u, type_28().member_1);
                                                                        } else {
                                                                            phi_7022_ = type_28(1u, _e2791);
                                                                        }
                                                                        let _e2802 = phi_7022_;
                                                                        if (bitcast<i32>(_e2802.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_6993_ = type_27(_e2802.member_1, _e2781.member_1);
                                                                        phi_7036_ = type_28(1u, _e2781.member);
                                                                    } else {
                                                                        phi_6993_ = _e2781;
                                                                        phi_7036_ = type_28(0u, type_28().member_1);
                                                                    }
                                                                    let _e2812 = phi_6993_;
                                                                    let _e2814 = phi_7036_;
                                                                    let _e2817 = (bitcast<i32>(_e2814.member) != 0i);
                                                                    if _e2817 {
                                                                        phi_6996_ = (0.5lf * (_e2783 + (_e2774 / _e2783)));
                                                                    } else {
                                                                        phi_6996_ = f64();
                                                                    }
                                                                    let _e2822 = phi_6996_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6992_ = _e2812;
                                                                        phi_6995_ = _e2822;
                                                                        break if !(_e2817);
                                                                    }
                                                                }
                                                                let _e2827 = local_26;
                                                                phi_7049_ = (_e2827 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2834 = phi_7049_;
                                                            phi_7062_ = type_29(0u, 4u);
                                                            phi_7065_ = f64(2f);
                                                            loop {
                                                                let _e2846 = phi_7062_;
                                                                let _e2848 = phi_7065_;
                                                                local_28 = _e2848;
                                                                local_29 = _e2848;
                                                                local_30 = _e2848;
                                                                local_60 = _e2848;
                                                                local_61 = _e2848;
                                                                if (_e2846.member < _e2846.member_1) {
                                                                    phi_7063_ = type_29((_e2846.member + 1u), _e2846.member_1);
                                                                    phi_7088_ = type_29(1u, _e2846.member);
                                                                } else {
                                                                    phi_7063_ = _e2846;
                                                                    phi_7088_ = type_29(0u, type_29().member_1);
                                                                }
                                                                let _e2862 = phi_7063_;
                                                                let _e2864 = phi_7088_;
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
                                                                        phi_7139_ = -(_e2879);
                                                                    } else {
                                                                        phi_7139_ = _e2879;
                                                                    }
                                                                    let _e2894 = phi_7139_;
                                                                    if (_e2890 < 0.0lf) {
                                                                        phi_7145_ = -(_e2890);
                                                                    } else {
                                                                        phi_7145_ = _e2890;
                                                                    }
                                                                    let _e2898 = phi_7145_;
                                                                    let _e2903 = (((((((((_e2287 + _e2289) + (_e2341 + _e2343)) + (_e2395 + _e2397)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2405 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2834) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2894 + _e2898) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2879 > _e2903) {
                                                                        if (_e2890 > _e2903) {
                                                                            phi_7159_ = false;
                                                                        } else {
                                                                            phi_7159_ = true;
                                                                        }
                                                                        let _e2907 = phi_7159_;
                                                                        phi_7160_ = _e2907;
                                                                    } else {
                                                                        phi_7160_ = true;
                                                                    }
                                                                    let _e2909 = phi_7160_;
                                                                    if _e2909 {
                                                                        if ((_e2879 + ((_e2890 - _e2879) * _e2416)) > _e2903) {
                                                                            if (_e2890 < _e2879) {
                                                                                let _e2918 = ((_e2879 - _e2890) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                                                if _e2918 {
                                                                                    let _e2926 = (((_e2879 - _e2903) / (_e2879 - _e2890)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    if (_e2848 < _e2926) {
                                                                                        phi_7194_ = _e2848;
                                                                                    } else {
                                                                                        phi_7194_ = _e2926;
                                                                                    }
                                                                                    let _e2929 = phi_7194_;
                                                                                    phi_7195_ = _e2929;
                                                                                } else {
                                                                                    phi_7195_ = f64();
                                                                                }
                                                                                let _e2931 = phi_7195_;
                                                                                phi_7196_ = _e2931;
                                                                                phi_7197_ = _e2918;
                                                                            } else {
                                                                                phi_7196_ = _e2848;
                                                                                phi_7197_ = true;
                                                                            }
                                                                            let _e2933 = phi_7196_;
                                                                            let _e2935 = phi_7197_;
                                                                            if _e2935 {
                                                                                phi_7201_ = false;
                                                                            } else {
                                                                                phi_7201_ = true;
                                                                            }
                                                                            let _e2937 = phi_7201_;
                                                                            phi_7202_ = _e2933;
                                                                            phi_7203_ = _e2935;
                                                                            phi_7204_ = _e2937;
                                                                            phi_7205_ = false;
                                                                        } else {
                                                                            phi_7202_ = f64();
                                                                            phi_7203_ = false;
                                                                            phi_7204_ = false;
                                                                            phi_7205_ = true;
                                                                        }
                                                                        let _e2939 = phi_7202_;
                                                                        let _e2941 = phi_7203_;
                                                                        let _e2943 = phi_7204_;
                                                                        let _e2945 = phi_7205_;
                                                                        phi_7206_ = _e2939;
                                                                        phi_7207_ = _e2941;
                                                                        phi_7208_ = _e2943;
                                                                        phi_7209_ = _e2945;
                                                                    } else {
                                                                        phi_7206_ = _e2848;
                                                                        phi_7207_ = true;
                                                                        phi_7208_ = false;
                                                                        phi_7209_ = false;
                                                                    }
                                                                    let _e2947 = phi_7206_;
                                                                    let _e2949 = phi_7207_;
                                                                    let _e2951 = phi_7208_;
                                                                    let _e2953 = phi_7209_;
                                                                    phi_7066_ = _e2947;
                                                                    phi_7210_ = _e2949;
                                                                    phi_7211_ = false;
                                                                    phi_7212_ = _e2951;
                                                                    phi_7213_ = _e2953;
                                                                } else {
                                                                    phi_7066_ = f64();
                                                                    phi_7210_ = false;
                                                                    phi_7211_ = true;
                                                                    phi_7212_ = false;
                                                                    phi_7213_ = false;
                                                                }
                                                                let _e2955 = phi_7066_;
                                                                let _e2957 = phi_7210_;
                                                                let _e2959 = phi_7211_;
                                                                let _e2961 = phi_7212_;
                                                                let _e2963 = phi_7213_;
                                                                local_27 = _e2959;
                                                                local_58 = _e2961;
                                                                local_59 = _e2963;
                                                                continue;
                                                                continuing {
                                                                    phi_7062_ = _e2862;
                                                                    phi_7065_ = _e2955;
                                                                    break if !(_e2957);
                                                                }
                                                            }
                                                            let _e2966 = local_27;
                                                            if _e2966 {
                                                                let _e2968 = local_28;
                                                                let _e2969 = (_e2968 > _e1425.member_1);
                                                                if _e2969 {
                                                                    phi_7235_ = false;
                                                                    phi_7236_ = false;
                                                                    phi_7237_ = false;
                                                                } else {
                                                                    let _e2971 = local_29;
                                                                    if (_e2971 > _e2416) {
                                                                        let _e2974 = local_30;
                                                                        let _e2977 = ((_e2974 - _e2416) < f64(0.00000000023283064f));
                                                                        if _e2977 {
                                                                            phi_7231_ = false;
                                                                        } else {
                                                                            phi_7231_ = true;
                                                                        }
                                                                        let _e2979 = phi_7231_;
                                                                        phi_7232_ = _e2979;
                                                                        phi_7233_ = _e2977;
                                                                        phi_7234_ = false;
                                                                    } else {
                                                                        phi_7232_ = false;
                                                                        phi_7233_ = false;
                                                                        phi_7234_ = true;
                                                                    }
                                                                    let _e2981 = phi_7232_;
                                                                    let _e2983 = phi_7233_;
                                                                    let _e2985 = phi_7234_;
                                                                    phi_7235_ = _e2981;
                                                                    phi_7236_ = _e2983;
                                                                    phi_7237_ = _e2985;
                                                                }
                                                                let _e2987 = phi_7235_;
                                                                let _e2989 = phi_7236_;
                                                                let _e2991 = phi_7237_;
                                                                phi_7238_ = _e2987;
                                                                phi_7239_ = _e2969;
                                                                phi_7240_ = _e2989;
                                                                phi_7241_ = _e2991;
                                                                phi_7242_ = false;
                                                                phi_7243_ = false;
                                                            } else {
                                                                phi_7238_ = false;
                                                                phi_7239_ = false;
                                                                phi_7240_ = false;
                                                                phi_7241_ = false;
                                                                let _e5391 = local_58;
                                                                phi_7242_ = _e5391;
                                                                let _e5394 = local_59;
                                                                phi_7243_ = _e5394;
                                                            }
                                                            let _e2993 = phi_7238_;
                                                            let _e2995 = phi_7239_;
                                                            let _e2997 = phi_7240_;
                                                            let _e2999 = phi_7241_;
                                                            let _e3001 = phi_7242_;
                                                            let _e3003 = phi_7243_;
                                                            let _e5397 = local_60;
                                                            phi_7244_ = _e5397;
                                                            let _e5400 = local_61;
                                                            phi_7245_ = _e5400;
                                                            phi_7246_ = _e2993;
                                                            phi_7247_ = _e2995;
                                                            phi_7248_ = _e2997;
                                                            phi_7249_ = _e2999;
                                                            phi_7250_ = _e3001;
                                                            phi_7251_ = _e3003;
                                                            phi_7252_ = false;
                                                        } else {
                                                            phi_7244_ = f64();
                                                            phi_7245_ = f64();
                                                            phi_7246_ = false;
                                                            phi_7247_ = false;
                                                            phi_7248_ = false;
                                                            phi_7249_ = false;
                                                            phi_7250_ = false;
                                                            phi_7251_ = false;
                                                            phi_7252_ = true;
                                                        }
                                                        let _e3005 = phi_7244_;
                                                        let _e3007 = phi_7245_;
                                                        let _e3009 = phi_7246_;
                                                        let _e3011 = phi_7247_;
                                                        let _e3013 = phi_7248_;
                                                        let _e3015 = phi_7249_;
                                                        let _e3017 = phi_7250_;
                                                        let _e3019 = phi_7251_;
                                                        let _e3021 = phi_7252_;
                                                        phi_7253_ = _e3005;
                                                        phi_7254_ = _e3007;
                                                        phi_7255_ = _e3009;
                                                        phi_7256_ = _e3011;
                                                        phi_7257_ = _e3013;
                                                        phi_7258_ = _e3015;
                                                        phi_7259_ = _e3017;
                                                        phi_7260_ = _e3019;
                                                        phi_7261_ = _e3021;
                                                        phi_7262_ = false;
                                                    } else {
                                                        phi_7253_ = f64();
                                                        phi_7254_ = f64();
                                                        phi_7255_ = false;
                                                        phi_7256_ = false;
                                                        phi_7257_ = false;
                                                        phi_7258_ = false;
                                                        phi_7259_ = false;
                                                        phi_7260_ = false;
                                                        phi_7261_ = false;
                                                        phi_7262_ = true;
                                                    }
                                                    let _e3023 = phi_7253_;
                                                    let _e3025 = phi_7254_;
                                                    let _e3027 = phi_7255_;
                                                    let _e3029 = phi_7256_;
                                                    let _e3031 = phi_7257_;
                                                    let _e3033 = phi_7258_;
                                                    let _e3035 = phi_7259_;
                                                    let _e3037 = phi_7260_;
                                                    let _e3039 = phi_7261_;
                                                    let _e3041 = phi_7262_;
                                                    phi_7263_ = _e3023;
                                                    phi_6312_ = _e3025;
                                                    phi_7264_ = _e3027;
                                                    phi_7265_ = _e3029;
                                                    phi_7266_ = _e3031;
                                                    phi_7267_ = false;
                                                    phi_7268_ = _e3033;
                                                    phi_7269_ = _e3035;
                                                    phi_7270_ = _e3037;
                                                    phi_7271_ = _e3039;
                                                    phi_7272_ = _e3041;
                                                } else {
                                                    phi_7263_ = f64();
                                                    phi_6312_ = f64();
                                                    phi_7264_ = false;
                                                    phi_7265_ = false;
                                                    phi_7266_ = false;
                                                    phi_7267_ = true;
                                                    phi_7268_ = false;
                                                    phi_7269_ = false;
                                                    phi_7270_ = false;
                                                    phi_7271_ = false;
                                                    phi_7272_ = false;
                                                }
                                                let _e3043 = phi_7263_;
                                                let _e3045 = phi_6312_;
                                                let _e3047 = phi_7264_;
                                                let _e3049 = phi_7265_;
                                                let _e3051 = phi_7266_;
                                                let _e3053 = phi_7267_;
                                                let _e3055 = phi_7268_;
                                                let _e3057 = phi_7269_;
                                                let _e3059 = phi_7270_;
                                                let _e3061 = phi_7271_;
                                                let _e3063 = phi_7272_;
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
                                                    phi_6308_ = _e2430;
                                                    phi_6311_ = _e3045;
                                                    break if !(_e3047);
                                                }
                                            }
                                            let _e3066 = local_31;
                                            if _e3066 {
                                                phi_7277_ = type_73(0u, type_73().member_1);
                                                phi_7278_ = false;
                                                phi_7279_ = false;
                                                phi_7280_ = false;
                                                phi_7281_ = false;
                                                phi_7282_ = false;
                                                phi_7283_ = false;
                                                phi_7284_ = false;
                                            } else {
                                                phi_7277_ = type_73();
                                                let _e5433 = local_62;
                                                phi_7278_ = _e5433;
                                                let _e5436 = local_63;
                                                phi_7279_ = _e5436;
                                                let _e5439 = local_64;
                                                phi_7280_ = _e5439;
                                                let _e5442 = local_65;
                                                phi_7281_ = _e5442;
                                                let _e5445 = local_66;
                                                phi_7282_ = _e5445;
                                                let _e5448 = local_67;
                                                phi_7283_ = _e5448;
                                                let _e5451 = local_68;
                                                phi_7284_ = _e5451;
                                            }
                                            let _e3071 = phi_7277_;
                                            let _e3073 = phi_7278_;
                                            let _e3075 = phi_7279_;
                                            let _e3077 = phi_7280_;
                                            let _e3079 = phi_7281_;
                                            let _e3081 = phi_7282_;
                                            let _e3083 = phi_7283_;
                                            let _e3085 = phi_7284_;
                                            if _e3073 {
                                                let _e5454 = local_69;
                                                phi_7288_ = _e5454;
                                                phi_7289_ = true;
                                                phi_7290_ = false;
                                                phi_7291_ = false;
                                                phi_7292_ = false;
                                                phi_7293_ = false;
                                                phi_7294_ = false;
                                                phi_7295_ = false;
                                            } else {
                                                let _e5456 = local_70;
                                                phi_7288_ = _e5456;
                                                phi_7289_ = _e3075;
                                                phi_7290_ = _e3077;
                                                phi_7291_ = _e3079;
                                                phi_7292_ = _e3081;
                                                let _e5463 = local_71;
                                                phi_7293_ = _e5463;
                                                phi_7294_ = _e3083;
                                                phi_7295_ = _e3085;
                                            }
                                            let _e3087 = phi_7288_;
                                            let _e3089 = phi_7289_;
                                            let _e3091 = phi_7290_;
                                            let _e3093 = phi_7291_;
                                            let _e3095 = phi_7292_;
                                            let _e3097 = phi_7293_;
                                            let _e3099 = phi_7294_;
                                            let _e3101 = phi_7295_;
                                            if _e3089 {
                                                phi_7300_ = type_73(1u, _e3087);
                                                phi_7301_ = false;
                                                phi_7302_ = false;
                                                phi_7303_ = false;
                                                phi_7304_ = false;
                                                phi_7305_ = false;
                                                phi_7306_ = false;
                                            } else {
                                                phi_7300_ = type_73();
                                                phi_7301_ = _e3091;
                                                phi_7302_ = _e3093;
                                                phi_7303_ = _e3095;
                                                phi_7304_ = _e3097;
                                                phi_7305_ = _e3099;
                                                phi_7306_ = _e3101;
                                            }
                                            let _e3104 = phi_7300_;
                                            let _e3106 = phi_7301_;
                                            let _e3108 = phi_7302_;
                                            let _e3110 = phi_7303_;
                                            let _e3112 = phi_7304_;
                                            let _e3114 = phi_7305_;
                                            let _e3116 = phi_7306_;
                                            if _e3106 {
                                                let _e3118 = local_32;
                                                phi_7311_ = type_73(1u, _e3118);
                                                phi_7312_ = false;
                                                phi_7313_ = false;
                                                phi_7314_ = true;
                                                phi_7315_ = false;
                                                phi_7316_ = false;
                                            } else {
                                                phi_7311_ = _e3071;
                                                phi_7312_ = _e3108;
                                                phi_7313_ = _e3110;
                                                phi_7314_ = _e3112;
                                                phi_7315_ = _e3114;
                                                phi_7316_ = _e3116;
                                            }
                                            let _e3121 = phi_7311_;
                                            let _e3123 = phi_7312_;
                                            let _e3125 = phi_7313_;
                                            let _e3127 = phi_7314_;
                                            let _e3129 = phi_7315_;
                                            let _e3131 = phi_7316_;
                                            if _e3123 {
                                                let _e3133 = local_33;
                                                phi_7321_ = type_73(1u, _e3133);
                                                phi_7322_ = false;
                                                phi_7323_ = false;
                                                phi_7324_ = false;
                                                phi_7325_ = false;
                                            } else {
                                                phi_7321_ = type_73();
                                                phi_7322_ = _e3125;
                                                phi_7323_ = _e3127;
                                                phi_7324_ = _e3129;
                                                phi_7325_ = _e3131;
                                            }
                                            let _e3136 = phi_7321_;
                                            let _e3138 = phi_7322_;
                                            let _e3140 = phi_7323_;
                                            let _e3142 = phi_7324_;
                                            let _e3144 = phi_7325_;
                                            if _e3138 {
                                                let _e3146 = local_34;
                                                phi_7330_ = type_73(1u, _e3146);
                                                phi_7331_ = true;
                                                phi_7332_ = false;
                                                phi_7333_ = false;
                                                phi_7334_ = false;
                                            } else {
                                                phi_7330_ = _e3136;
                                                phi_7331_ = _e3123;
                                                phi_7332_ = _e3140;
                                                phi_7333_ = _e3142;
                                                phi_7334_ = _e3144;
                                            }
                                            let _e3149 = phi_7330_;
                                            let _e3151 = phi_7331_;
                                            let _e3153 = phi_7332_;
                                            let _e3155 = phi_7333_;
                                            let _e3157 = phi_7334_;
                                            if _e3151 {
                                                phi_7338_ = _e3149;
                                                phi_7339_ = true;
                                                phi_7340_ = false;
                                                phi_7341_ = false;
                                            } else {
                                                phi_7338_ = _e3121;
                                                phi_7339_ = _e3153;
                                                phi_7340_ = _e3155;
                                                phi_7341_ = _e3157;
                                            }
                                            let _e3159 = phi_7338_;
                                            let _e3161 = phi_7339_;
                                            let _e3163 = phi_7340_;
                                            let _e3165 = phi_7341_;
                                            if _e3161 {
                                                phi_7345_ = false;
                                                phi_7346_ = false;
                                            } else {
                                                phi_7345_ = _e3163;
                                                phi_7346_ = _e3165;
                                            }
                                            let _e3167 = phi_7345_;
                                            let _e3169 = phi_7346_;
                                            if _e3167 {
                                                phi_7350_ = false;
                                                phi_7351_ = false;
                                            } else {
                                                phi_7350_ = _e3169;
                                                phi_7351_ = _e3161;
                                            }
                                            let _e3171 = phi_7350_;
                                            let _e3173 = phi_7351_;
                                            if _e3171 {
                                                phi_7355_ = true;
                                                phi_7356_ = false;
                                            } else {
                                                phi_7355_ = _e3167;
                                                phi_7356_ = _e3173;
                                            }
                                            let _e3175 = phi_7355_;
                                            let _e3177 = phi_7356_;
                                            if _e3175 {
                                                let _e3179 = local_35;
                                                phi_7361_ = type_73(1u, _e3179);
                                                phi_7362_ = true;
                                            } else {
                                                phi_7361_ = _e3159;
                                                phi_7362_ = _e3177;
                                            }
                                            let _e3182 = phi_7361_;
                                            let _e3184 = phi_7362_;
                                            if _e3184 {
                                                phi_7366_ = _e3182;
                                            } else {
                                                phi_7366_ = _e3104;
                                            }
                                            let _e3186 = phi_7366_;
                                            let _e3189 = (_e3186.member != 0u);
                                            if _e3189 {
                                                phi_7373_ = false;
                                            } else {
                                                phi_7373_ = true;
                                            }
                                            let _e3191 = phi_7373_;
                                            phi_7374_ = _e3186.member_1;
                                            phi_7375_ = _e3191;
                                            phi_7376_ = _e3189;
                                            phi_7377_ = false;
                                        } else {
                                            phi_7374_ = f64();
                                            phi_7375_ = false;
                                            phi_7376_ = false;
                                            phi_7377_ = true;
                                        }
                                        let _e3193 = phi_7374_;
                                        let _e3195 = phi_7375_;
                                        let _e3197 = phi_7376_;
                                        let _e3199 = phi_7377_;
                                        phi_7378_ = _e3193;
                                        phi_7379_ = _e3195;
                                        phi_7380_ = _e3197;
                                        phi_7381_ = _e3199;
                                    }
                                    let _e3201 = phi_7378_;
                                    let _e3203 = phi_7379_;
                                    let _e3205 = phi_7380_;
                                    let _e3207 = phi_7381_;
                                    phi_7382_ = _e3201;
                                    phi_7383_ = _e2166;
                                    phi_7384_ = _e3203;
                                    phi_7385_ = _e3205;
                                    phi_7386_ = _e3207;
                                }
                                let _e3209 = phi_7382_;
                                let _e3211 = phi_7383_;
                                let _e3213 = phi_7384_;
                                let _e3215 = phi_7385_;
                                let _e3217 = phi_7386_;
                                if _e3211 {
                                    phi_7390_ = true;
                                    phi_7391_ = false;
                                    phi_7392_ = false;
                                } else {
                                    phi_7390_ = _e3213;
                                    phi_7391_ = _e3215;
                                    phi_7392_ = _e3217;
                                }
                                let _e3219 = phi_7390_;
                                let _e3221 = phi_7391_;
                                let _e3223 = phi_7392_;
                                phi_7393_ = _e3209;
                                phi_7394_ = _e1425;
                                phi_7395_ = _e3219;
                                phi_7396_ = false;
                                phi_7397_ = _e3221;
                                phi_7398_ = _e3223;
                            } else {
                                phi_7393_ = f64();
                                phi_7394_ = type_74();
                                phi_7395_ = false;
                                phi_7396_ = true;
                                phi_7397_ = false;
                                phi_7398_ = false;
                            }
                            let _e3225 = phi_7393_;
                            let _e3227 = phi_7394_;
                            let _e3229 = phi_7395_;
                            let _e3231 = phi_7396_;
                            let _e3233 = phi_7397_;
                            let _e3235 = phi_7398_;
                            local_36 = _e3231;
                            local_72 = _e3233;
                            local_73 = _e3235;
                            local_37 = _e3225;
                            local_38 = _e3227;
                            continue;
                            continuing {
                                phi_4347_ = _e1106;
                                break if !(_e3229);
                            }
                        }
                        let _e3238 = local_36;
                        if _e3238 {
                            phi_7403_ = type_73(0u, type_73().member_1);
                            phi_7404_ = false;
                            phi_7405_ = false;
                        } else {
                            phi_7403_ = type_73();
                            let _e5533 = local_72;
                            phi_7404_ = _e5533;
                            let _e5536 = local_73;
                            phi_7405_ = _e5536;
                        }
                        let _e3243 = phi_7403_;
                        let _e3245 = phi_7404_;
                        let _e3247 = phi_7405_;
                        if _e3245 {
                            let _e3249 = local_37;
                            phi_7410_ = type_73(2u, _e3249);
                            phi_7411_ = false;
                        } else {
                            phi_7410_ = type_73();
                            phi_7411_ = _e3247;
                        }
                        let _e3252 = phi_7410_;
                        let _e3254 = phi_7411_;
                        if _e3254 {
                            let _e3256 = local_38;
                            phi_7417_ = type_73(1u, _e3256.member);
                            phi_7418_ = true;
                        } else {
                            phi_7417_ = _e3252;
                            phi_7418_ = _e3245;
                        }
                        let _e3260 = phi_7417_;
                        let _e3262 = phi_7418_;
                        if _e3262 {
                            phi_7422_ = _e3260;
                        } else {
                            phi_7422_ = _e3243;
                        }
                        let _e3264 = phi_7422_;
                        phi_7426_ = _e3264;
                    }
                    let _e4900 = phi_7426_;
                    phi_7427_ = _e4900;
                }
                let _e4905 = phi_7427_;
                switch bitcast<i32>(_e4905.member) {
                    case 0: {
                        phi_7448_ = type_47(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4915 = bitcast<u64>(_e4905.member_1);
                        phi_7448_ = type_47(0u, array<u32, 2>(u32(_e4915), u32((_e4915 / 4294967296lu))), true);
                        break;
                    }
                    case 2: {
                        let _e4909 = bitcast<u64>(_e4905.member_1);
                        phi_7448_ = type_47(1u, array<u32, 2>(u32(_e4909), u32((_e4909 / 4294967296lu))), true);
                        break;
                    }
                    default: {
                        phi_7448_ = type_47();
                        break;
                    }
                }
                let _e4922 = phi_7448_;
                if _e4922.member_2 {
                    let _e4929 = (_e4922.member_1[1] >> bitcast<u32>(20i));
                    if (_e4929 <= 896u) {
                        phi_7471_ = 0u;
                    } else {
                        phi_7471_ = ((((_e4929 - 896u) << bitcast<u32>(23i)) | ((_e4922.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4922.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4944 = phi_7471_;
                    let _e4946 = atomicMin((&earliest.member[0u]), _e4944);
                }
                phi_7475_ = type_46(_e186, _e4922.member, _e192, _e195, _e4922.member_1);
                phi_7476_ = _e4922.member_2;
            } else {
                phi_7475_ = type_46(_e186, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_7476_ = false;
            }
            let _e4948 = phi_7475_;
            let _e4950 = phi_7476_;
            let _e4952 = params.member.member_1;
            if ((_e4952 & 16u) != 0u) {
                if (_e117 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4950 {
                    let _e4958 = atomicAdd((&counters[0u]), 1u);
                    phi_7494_ = _e4958;
                } else {
                    phi_7494_ = 0u;
                }
                let _e4960 = phi_7494_;
                workgroupBarrier();
                if (_e117 == 0u) {
                    let _e4963 = atomicLoad((&counters[0u]));
                    if (_e4963 > 0u) {
                        let _e4966 = atomicAdd((&contacts.member[0u]), _e4963);
                        atomicStore((&counters[1u]), _e4966);
                    }
                }
                workgroupBarrier();
                let _e4969 = atomicLoad((&counters[1u]));
                let _e4970 = (_e4969 + _e4960);
                if _e4950 {
                    let _e4972 = params.member.member_16;
                    if (_e4970 < _e4972) {
                        let _e4974 = (6u * _e4970);
                        atomicStore((&contacts.member[(4u + _e4974)]), _e4948.member);
                        atomicStore((&contacts.member[(_e4974 + 5u)]), _e4948.member_1);
                        atomicStore((&contacts.member[(_e4974 + 6u)]), _e4948.member_2);
                        atomicStore((&contacts.member[(_e4974 + 7u)]), _e4948.member_3);
                        atomicStore((&contacts.member[(_e4974 + 8u)]), _e4948.member_4[0]);
                        atomicStore((&contacts.member[(_e4974 + 9u)]), _e4948.member_4[1]);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_272_ = _e174;
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
    function_();
}
