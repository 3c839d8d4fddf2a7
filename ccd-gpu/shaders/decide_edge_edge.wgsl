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

struct type_33 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_36 {
    member: array<type_33>,
}

struct type_40 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

struct type_45 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_48 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_50 {
    member: f32,
    member_1: f32,
}

struct type_55 {
    member: u32,
    member_1: f32,
}

struct type_56 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_58 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_62 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_12;
@group(0) @binding(1) 
var<storage> paths: type_36;
@group(0) @binding(2) 
var<storage> elements: type_20;
@group(0) @binding(3) 
var<storage> input: type_16;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_62;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_62;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_62;
var<workgroup> counters: array<atomic<u32>, 4>;

fn function_() {
    var local: array<array<f32, 3>, 4>;
    var local_1: array<array<f32, 3>, 4>;
    var local_2: array<array<f32, 3>, 4>;
    var local_3: type_40;
    var local_4: type_40;
    var local_5: type_40;
    var local_6: array<type_50, 4>;
    var local_7: array<f32, 4>;
    var local_8: array<f32, 2>;
    var local_9: array<f32, 4>;
    var local_10: array<array<f32, 3>, 4>;
    var local_11: array<array<f32, 3>, 4>;
    var local_12: array<array<f32, 3>, 4>;
    var local_13: array<array<f32, 3>, 4>;
    var local_14: array<f32, 3>;
    var local_15: type_45;
    var phi_201_: u32;
    var phi_217_: u32;
    var phi_238_: u32;
    var phi_239_: u32;
    var phi_242_: type_28;
    var phi_243_: type_28;
    var phi_266_: type_28;
    var phi_716_: f32;
    var phi_723_: f32;
    var phi_728_: f32;
    var phi_735_: f32;
    var phi_740_: f32;
    var phi_753_: f32;
    var phi_760_: f32;
    var phi_765_: f32;
    var phi_772_: f32;
    var phi_777_: f32;
    var phi_782_: f32;
    var phi_799_: f32;
    var phi_806_: f32;
    var phi_811_: f32;
    var phi_818_: f32;
    var phi_823_: f32;
    var phi_837_: f32;
    var phi_844_: f32;
    var phi_849_: f32;
    var phi_856_: f32;
    var phi_861_: f32;
    var phi_866_: f32;
    var phi_883_: f32;
    var phi_890_: f32;
    var phi_895_: f32;
    var phi_902_: f32;
    var phi_907_: f32;
    var phi_921_: f32;
    var phi_928_: f32;
    var phi_933_: f32;
    var phi_940_: f32;
    var phi_945_: f32;
    var phi_950_: f32;
    var phi_981_: f32;
    var phi_987_: f32;
    var phi_994_: f32;
    var phi_1001_: f32;
    var phi_1007_: f32;
    var phi_1014_: f32;
    var phi_1020_: f32;
    var phi_1026_: f32;
    var phi_1032_: f32;
    var phi_1039_: f32;
    var phi_1046_: f32;
    var phi_1070_: f32;
    var phi_1075_: f32;
    var phi_1080_: f32;
    var phi_1085_: f32;
    var phi_1090_: f32;
    var phi_1095_: f32;
    var phi_1105_: f32;
    var phi_3576_: f32;
    var phi_3582_: f32;
    var phi_3587_: f32;
    var phi_3593_: f32;
    var phi_3599_: f32;
    var phi_3604_: f32;
    var phi_3609_: f32;
    var phi_3649_: type_26;
    var phi_3652_: f32;
    var phi_3673_: bool;
    var phi_3679_: type_27;
    var phi_3650_: type_26;
    var phi_3693_: type_27;
    var phi_3653_: f32;
    var local_16: f32;
    var phi_3642_: f32;
    var phi_3706_: f32;
    var phi_3712_: f32;
    var phi_3737_: type_28;
    var phi_3740_: u32;
    var phi_3738_: type_28;
    var phi_3763_: type_28;
    var phi_3807_: u32;
    var phi_3808_: u32;
    var phi_3741_: u32;
    var phi_3809_: u32;
    var phi_3829_: type_28;
    var phi_3830_: type_28;
    var phi_3853_: type_28;
    var phi_3905_: f32;
    var phi_3912_: f32;
    var phi_3932_: bool;
    var phi_3933_: bool;
    var phi_3934_: bool;
    var phi_3935_: bool;
    var phi_3936_: bool;
    var phi_3937_: bool;
    var phi_3938_: bool;
    var phi_3939_: bool;
    var phi_3940_: bool;
    var phi_3941_: bool;
    var phi_3942_: bool;
    var phi_3952_: bool;
    var phi_3953_: bool;
    var phi_3954_: bool;
    var phi_3955_: bool;
    var phi_3960_: type_56;
    var phi_3961_: bool;
    var phi_3972_: f32;
    var phi_3982_: type_28;
    var phi_3985_: f32;
    var phi_3987_: f32;
    var phi_3989_: f32;
    var phi_3983_: type_28;
    var phi_4012_: type_28;
    var phi_4037_: f32;
    var phi_4038_: f32;
    var phi_4064_: f32;
    var phi_4080_: f32;
    var phi_4087_: bool;
    var phi_4088_: bool;
    var phi_4089_: bool;
    var phi_4095_: f32;
    var phi_4096_: f32;
    var phi_4097_: bool;
    var phi_3986_: f32;
    var phi_3988_: f32;
    var phi_3990_: f32;
    var phi_4098_: f32;
    var phi_4099_: bool;
    var phi_4100_: bool;
    var local_17: bool;
    var phi_4104_: f32;
    var phi_4105_: f32;
    var phi_4112_: type_28;
    var phi_4115_: f32;
    var phi_4113_: type_28;
    var phi_4138_: type_28;
    var phi_4179_: f32;
    var phi_4189_: f32;
    var phi_4197_: bool;
    var phi_4199_: bool;
    var phi_4204_: f32;
    var phi_4205_: bool;
    var phi_4206_: f32;
    var phi_4207_: bool;
    var phi_4208_: bool;
    var phi_4209_: bool;
    var phi_4210_: f32;
    var phi_4116_: f32;
    var phi_4211_: bool;
    var phi_4212_: bool;
    var phi_4213_: bool;
    var phi_4214_: bool;
    var local_18: bool;
    var phi_4218_: bool;
    var phi_4219_: bool;
    var phi_4223_: bool;
    var phi_4227_: f32;
    var phi_4228_: f32;
    var phi_4230_: type_56;
    var phi_4259_: f32;
    var phi_4266_: f32;
    var phi_4271_: f32;
    var phi_4278_: f32;
    var phi_4283_: f32;
    var phi_4296_: f32;
    var phi_4303_: f32;
    var phi_4308_: f32;
    var phi_4315_: f32;
    var phi_4320_: f32;
    var phi_4325_: f32;
    var phi_4384_: f32;
    var phi_4390_: f32;
    var phi_4395_: f32;
    var phi_4401_: f32;
    var phi_4406_: f32;
    var phi_4418_: f32;
    var phi_4424_: f32;
    var phi_4429_: f32;
    var phi_4435_: f32;
    var phi_4440_: f32;
    var phi_4466_: f32;
    var phi_4473_: f32;
    var phi_4478_: f32;
    var phi_4485_: f32;
    var phi_4490_: f32;
    var phi_4503_: f32;
    var phi_4510_: f32;
    var phi_4515_: f32;
    var phi_4522_: f32;
    var phi_4527_: f32;
    var phi_4532_: f32;
    var phi_4591_: f32;
    var phi_4597_: f32;
    var phi_4602_: f32;
    var phi_4608_: f32;
    var phi_4613_: f32;
    var phi_4625_: f32;
    var phi_4631_: f32;
    var phi_4636_: f32;
    var phi_4642_: f32;
    var phi_4647_: f32;
    var phi_4673_: f32;
    var phi_4680_: f32;
    var phi_4685_: f32;
    var phi_4692_: f32;
    var phi_4697_: f32;
    var phi_4710_: f32;
    var phi_4717_: f32;
    var phi_4722_: f32;
    var phi_4729_: f32;
    var phi_4734_: f32;
    var phi_4739_: f32;
    var phi_4798_: f32;
    var phi_4804_: f32;
    var phi_4809_: f32;
    var phi_4815_: f32;
    var phi_4820_: f32;
    var phi_4832_: f32;
    var phi_4838_: f32;
    var phi_4843_: f32;
    var phi_4849_: f32;
    var phi_4854_: f32;
    var phi_4903_: f32;
    var phi_4909_: f32;
    var phi_4937_: f32;
    var phi_4943_: f32;
    var phi_4948_: u32;
    var phi_4949_: u32;
    var phi_4919_: f32;
    var phi_4925_: f32;
    var phi_4930_: u32;
    var phi_4931_: u32;
    var phi_4950_: u32;
    var phi_4951_: u32;
    var phi_5018_: f32;
    var phi_5027_: f32;
    var phi_5158_: f32;
    var phi_5164_: f32;
    var phi_5171_: f32;
    var phi_5214_: type_28;
    var phi_5217_: bool;
    var phi_5215_: type_28;
    var phi_5240_: type_28;
    var phi_5267_: bool;
    var phi_5268_: bool;
    var phi_5218_: bool;
    var phi_5269_: bool;
    var phi_5270_: bool;
    var local_19: bool;
    var phi_5274_: bool;
    var local_20: bool;
    var phi_5281_: u32;
    var phi_5282_: u32;
    var phi_5283_: bool;
    var phi_5284_: u32;
    var phi_5285_: u32;
    var phi_5286_: bool;
    var phi_5290_: u32;
    var phi_5310_: bool;
    var phi_5311_: bool;
    var phi_5312_: bool;
    var phi_5508_: f32;
    var phi_5515_: f32;
    var phi_5520_: f32;
    var phi_5527_: f32;
    var phi_5532_: f32;
    var phi_5545_: f32;
    var phi_5552_: f32;
    var phi_5557_: f32;
    var phi_5564_: f32;
    var phi_5569_: f32;
    var phi_5574_: f32;
    var phi_5591_: f32;
    var phi_5598_: f32;
    var phi_5603_: f32;
    var phi_5610_: f32;
    var phi_5615_: f32;
    var phi_5629_: f32;
    var phi_5636_: f32;
    var phi_5641_: f32;
    var phi_5648_: f32;
    var phi_5653_: f32;
    var phi_5658_: f32;
    var phi_5675_: f32;
    var phi_5682_: f32;
    var phi_5687_: f32;
    var phi_5694_: f32;
    var phi_5699_: f32;
    var phi_5713_: f32;
    var phi_5720_: f32;
    var phi_5725_: f32;
    var phi_5732_: f32;
    var phi_5737_: f32;
    var phi_5742_: f32;
    var phi_5758_: type_28;
    var phi_5761_: f32;
    var phi_5759_: type_28;
    var phi_5784_: type_28;
    var phi_5938_: bool;
    var phi_5939_: bool;
    var phi_5940_: bool;
    var phi_5941_: bool;
    var phi_5942_: bool;
    var phi_5943_: bool;
    var phi_5973_: bool;
    var phi_5974_: bool;
    var phi_5975_: bool;
    var phi_5976_: bool;
    var phi_6000_: array<f32, 3>;
    var phi_6001_: bool;
    var phi_6002_: array<f32, 3>;
    var phi_6003_: bool;
    var phi_6004_: bool;
    var phi_6005_: array<f32, 3>;
    var phi_6006_: bool;
    var phi_6007_: bool;
    var phi_6011_: bool;
    var phi_6041_: f32;
    var phi_6042_: f32;
    var phi_6069_: f32;
    var phi_6070_: f32;
    var phi_6097_: f32;
    var phi_6098_: f32;
    var phi_6128_: f32;
    var phi_6129_: f32;
    var phi_6272_: type_28;
    var phi_6275_: array<f32, 3>;
    var phi_6273_: type_28;
    var phi_6298_: type_28;
    var phi_6365_: array<f32, 3>;
    var phi_6276_: array<f32, 3>;
    var phi_6366_: array<f32, 3>;
    var phi_6373_: f32;
    var phi_6380_: f32;
    var phi_6388_: f32;
    var phi_6432_: type_26;
    var phi_6435_: f32;
    var phi_6456_: bool;
    var phi_6462_: type_27;
    var phi_6433_: type_26;
    var phi_6476_: type_27;
    var phi_6436_: f32;
    var local_21: f32;
    var phi_6425_: f32;
    var phi_6489_: f32;
    var phi_6498_: type_28;
    var phi_6501_: f32;
    var phi_6499_: type_28;
    var phi_6524_: type_28;
    var phi_6575_: f32;
    var phi_6581_: f32;
    var phi_6594_: bool;
    var phi_6595_: bool;
    var phi_6620_: f32;
    var phi_6621_: f32;
    var phi_6622_: f32;
    var phi_6623_: f32;
    var phi_6624_: bool;
    var phi_6502_: f32;
    var phi_6625_: bool;
    var phi_6626_: bool;
    var local_22: bool;
    var local_23: f32;
    var local_24: f32;
    var local_25: f32;
    var phi_6643_: bool;
    var phi_6644_: bool;
    var phi_6645_: bool;
    var phi_6646_: bool;
    var phi_6647_: bool;
    var phi_6648_: bool;
    var phi_6649_: bool;
    var phi_6650_: bool;
    var phi_6651_: bool;
    var phi_6652_: bool;
    var phi_6653_: bool;
    var phi_6654_: bool;
    var phi_6655_: f32;
    var phi_6656_: f32;
    var phi_6657_: bool;
    var phi_6658_: bool;
    var phi_6659_: bool;
    var phi_6660_: bool;
    var phi_6661_: bool;
    var phi_6662_: bool;
    var phi_6663_: f32;
    var phi_6664_: f32;
    var phi_6665_: bool;
    var phi_6666_: bool;
    var phi_6667_: bool;
    var phi_6668_: bool;
    var phi_6669_: bool;
    var phi_6670_: bool;
    var phi_6671_: bool;
    var phi_6672_: f32;
    var phi_5762_: f32;
    var phi_6673_: bool;
    var phi_6674_: bool;
    var phi_6675_: bool;
    var phi_6676_: bool;
    var phi_6677_: bool;
    var phi_6678_: bool;
    var phi_6679_: bool;
    var phi_6680_: bool;
    var local_26: bool;
    var phi_6685_: type_55;
    var phi_6686_: bool;
    var phi_6687_: bool;
    var phi_6688_: bool;
    var phi_6689_: bool;
    var phi_6690_: bool;
    var phi_6691_: bool;
    var phi_6695_: f32;
    var phi_6696_: bool;
    var phi_6697_: bool;
    var phi_6698_: bool;
    var phi_6699_: bool;
    var phi_6700_: bool;
    var phi_6701_: bool;
    var phi_6706_: type_55;
    var phi_6707_: bool;
    var phi_6708_: bool;
    var phi_6709_: bool;
    var phi_6710_: bool;
    var phi_6711_: bool;
    var local_27: f32;
    var phi_6716_: type_55;
    var phi_6717_: bool;
    var phi_6718_: bool;
    var phi_6719_: bool;
    var phi_6720_: bool;
    var local_28: f32;
    var phi_6725_: type_55;
    var phi_6726_: bool;
    var phi_6727_: bool;
    var phi_6728_: bool;
    var phi_6732_: bool;
    var phi_6733_: bool;
    var phi_6737_: bool;
    var phi_6738_: bool;
    var phi_6742_: bool;
    var phi_6743_: bool;
    var local_29: f32;
    var phi_6748_: type_55;
    var phi_6749_: bool;
    var phi_6753_: type_55;
    var phi_6760_: bool;
    var phi_6761_: f32;
    var phi_6762_: bool;
    var phi_6763_: bool;
    var phi_6764_: bool;
    var phi_6765_: f32;
    var phi_6766_: bool;
    var phi_6767_: bool;
    var phi_6768_: bool;
    var phi_6769_: f32;
    var phi_6770_: bool;
    var phi_6771_: bool;
    var phi_6772_: bool;
    var phi_6773_: bool;
    var phi_6777_: bool;
    var phi_6778_: bool;
    var phi_6779_: bool;
    var phi_6780_: f32;
    var phi_6781_: type_56;
    var phi_6782_: bool;
    var phi_6783_: bool;
    var phi_6784_: bool;
    var phi_6785_: bool;
    var local_30: bool;
    var phi_6790_: type_55;
    var phi_6791_: bool;
    var phi_6792_: bool;
    var local_31: f32;
    var phi_6797_: type_55;
    var phi_6798_: bool;
    var local_32: type_56;
    var phi_6804_: type_55;
    var phi_6805_: bool;
    var phi_6809_: type_55;
    var phi_1306_: f32;
    var phi_1313_: f32;
    var phi_1318_: f32;
    var phi_1325_: f32;
    var phi_1330_: f32;
    var phi_1343_: f32;
    var phi_1350_: f32;
    var phi_1355_: f32;
    var phi_1362_: f32;
    var phi_1367_: f32;
    var phi_1372_: f32;
    var phi_1389_: f32;
    var phi_1396_: f32;
    var phi_1401_: f32;
    var phi_1408_: f32;
    var phi_1413_: f32;
    var phi_1427_: f32;
    var phi_1434_: f32;
    var phi_1439_: f32;
    var phi_1446_: f32;
    var phi_1451_: f32;
    var phi_1456_: f32;
    var phi_1473_: f32;
    var phi_1480_: f32;
    var phi_1485_: f32;
    var phi_1492_: f32;
    var phi_1497_: f32;
    var phi_1511_: f32;
    var phi_1518_: f32;
    var phi_1523_: f32;
    var phi_1530_: f32;
    var phi_1535_: f32;
    var phi_1540_: f32;
    var phi_1556_: type_28;
    var phi_1559_: f32;
    var phi_1557_: type_28;
    var phi_1582_: type_28;
    var phi_1736_: bool;
    var phi_1737_: bool;
    var phi_1738_: bool;
    var phi_1739_: bool;
    var phi_1740_: bool;
    var phi_1741_: bool;
    var phi_1771_: bool;
    var phi_1772_: bool;
    var phi_1773_: bool;
    var phi_1774_: bool;
    var phi_1798_: array<f32, 3>;
    var phi_1799_: bool;
    var phi_1800_: array<f32, 3>;
    var phi_1801_: bool;
    var phi_1802_: bool;
    var phi_1803_: array<f32, 3>;
    var phi_1804_: bool;
    var phi_1805_: bool;
    var phi_1809_: bool;
    var phi_1839_: f32;
    var phi_1840_: f32;
    var phi_1867_: f32;
    var phi_1868_: f32;
    var phi_1895_: f32;
    var phi_1896_: f32;
    var phi_1926_: f32;
    var phi_1927_: f32;
    var phi_2070_: type_28;
    var phi_2073_: array<f32, 3>;
    var phi_2071_: type_28;
    var phi_2096_: type_28;
    var phi_2163_: array<f32, 3>;
    var phi_2074_: array<f32, 3>;
    var phi_2164_: array<f32, 3>;
    var phi_2171_: f32;
    var phi_2178_: f32;
    var phi_2186_: f32;
    var phi_2230_: type_26;
    var phi_2233_: f32;
    var phi_2254_: bool;
    var phi_2260_: type_27;
    var phi_2231_: type_26;
    var phi_2274_: type_27;
    var phi_2234_: f32;
    var local_33: f32;
    var phi_2223_: f32;
    var phi_2287_: f32;
    var phi_2296_: type_28;
    var phi_2299_: f32;
    var phi_2297_: type_28;
    var phi_2322_: type_28;
    var phi_2373_: f32;
    var phi_2379_: f32;
    var phi_2392_: bool;
    var phi_2393_: bool;
    var phi_2418_: f32;
    var phi_2419_: f32;
    var phi_2420_: f32;
    var phi_2421_: f32;
    var phi_2422_: bool;
    var phi_2300_: f32;
    var phi_2423_: bool;
    var phi_2424_: bool;
    var local_34: bool;
    var local_35: f32;
    var local_36: f32;
    var local_37: f32;
    var phi_2441_: bool;
    var phi_2442_: bool;
    var phi_2443_: bool;
    var phi_2444_: bool;
    var phi_2445_: bool;
    var phi_2446_: bool;
    var phi_2447_: bool;
    var phi_2448_: bool;
    var phi_2449_: bool;
    var phi_2450_: bool;
    var phi_2451_: bool;
    var phi_2452_: bool;
    var phi_2453_: f32;
    var phi_2454_: f32;
    var phi_2455_: bool;
    var phi_2456_: bool;
    var phi_2457_: bool;
    var phi_2458_: bool;
    var phi_2459_: bool;
    var phi_2460_: bool;
    var phi_2461_: f32;
    var phi_2462_: f32;
    var phi_2463_: bool;
    var phi_2464_: bool;
    var phi_2465_: bool;
    var phi_2466_: bool;
    var phi_2467_: bool;
    var phi_2468_: bool;
    var phi_2469_: bool;
    var phi_2470_: f32;
    var phi_1560_: f32;
    var phi_2471_: bool;
    var phi_2472_: bool;
    var phi_2473_: bool;
    var phi_2474_: bool;
    var phi_2475_: bool;
    var phi_2476_: bool;
    var phi_2477_: bool;
    var phi_2478_: bool;
    var local_38: bool;
    var phi_2483_: type_55;
    var phi_2484_: bool;
    var phi_2485_: bool;
    var phi_2486_: bool;
    var phi_2487_: bool;
    var phi_2488_: bool;
    var phi_2489_: bool;
    var phi_2493_: f32;
    var phi_2494_: bool;
    var phi_2495_: bool;
    var phi_2496_: bool;
    var phi_2497_: bool;
    var phi_2498_: bool;
    var phi_2499_: bool;
    var phi_2504_: type_55;
    var phi_2505_: bool;
    var phi_2506_: bool;
    var phi_2507_: bool;
    var phi_2508_: bool;
    var phi_2509_: bool;
    var local_39: f32;
    var phi_2514_: type_55;
    var phi_2515_: bool;
    var phi_2516_: bool;
    var phi_2517_: bool;
    var phi_2518_: bool;
    var local_40: f32;
    var phi_2523_: type_55;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var phi_2526_: bool;
    var phi_2530_: bool;
    var phi_2531_: bool;
    var phi_2535_: bool;
    var phi_2536_: bool;
    var phi_2540_: bool;
    var phi_2541_: bool;
    var local_41: f32;
    var phi_2546_: type_55;
    var phi_2547_: bool;
    var phi_2551_: type_55;
    var phi_2565_: type_28;
    var phi_2566_: type_28;
    var phi_2589_: type_28;
    var phi_2609_: f32;
    var phi_2757_: bool;
    var phi_2758_: bool;
    var phi_2759_: bool;
    var phi_2760_: bool;
    var phi_2761_: bool;
    var phi_2762_: bool;
    var phi_2792_: bool;
    var phi_2793_: bool;
    var phi_2794_: bool;
    var phi_2795_: bool;
    var phi_2819_: array<f32, 3>;
    var phi_2820_: bool;
    var phi_2821_: array<f32, 3>;
    var phi_2822_: bool;
    var phi_2823_: bool;
    var phi_2824_: array<f32, 3>;
    var phi_2825_: bool;
    var phi_2826_: bool;
    var phi_2830_: bool;
    var phi_2860_: f32;
    var phi_2861_: f32;
    var phi_2888_: f32;
    var phi_2889_: f32;
    var phi_2916_: f32;
    var phi_2917_: f32;
    var phi_2947_: f32;
    var phi_2948_: f32;
    var phi_3091_: type_28;
    var phi_3094_: array<f32, 3>;
    var phi_3092_: type_28;
    var phi_3117_: type_28;
    var phi_3184_: array<f32, 3>;
    var phi_3095_: array<f32, 3>;
    var phi_3185_: array<f32, 3>;
    var phi_3217_: type_26;
    var phi_3220_: f32;
    var phi_3241_: bool;
    var phi_3247_: type_27;
    var phi_3218_: type_26;
    var phi_3261_: type_27;
    var phi_3221_: f32;
    var local_42: f32;
    var phi_3210_: f32;
    var phi_3274_: f32;
    var phi_3290_: f32;
    var phi_3297_: f32;
    var phi_3302_: f32;
    var phi_3309_: f32;
    var phi_3314_: f32;
    var phi_3327_: f32;
    var phi_3334_: f32;
    var phi_3339_: f32;
    var phi_3346_: f32;
    var phi_3351_: f32;
    var phi_3356_: f32;
    var phi_3373_: f32;
    var phi_3380_: f32;
    var phi_3385_: f32;
    var phi_3392_: f32;
    var phi_3397_: f32;
    var phi_3411_: f32;
    var phi_3418_: f32;
    var phi_3423_: f32;
    var phi_3430_: f32;
    var phi_3435_: f32;
    var phi_3440_: f32;
    var phi_3457_: f32;
    var phi_3464_: f32;
    var phi_3469_: f32;
    var phi_3476_: f32;
    var phi_3481_: f32;
    var phi_3495_: f32;
    var phi_3502_: f32;
    var phi_3507_: f32;
    var phi_3514_: f32;
    var phi_3519_: f32;
    var phi_3524_: f32;
    var phi_3544_: bool;
    var phi_3545_: bool;
    var phi_3546_: bool;
    var local_43: bool;
    var phi_3551_: type_55;
    var phi_3552_: bool;
    var phi_3557_: type_55;
    var phi_3558_: bool;
    var phi_3560_: type_55;
    var phi_3561_: type_55;
    var phi_3562_: bool;
    var phi_3566_: type_55;
    var phi_6813_: type_55;
    var phi_6814_: type_55;
    var phi_6867_: array<u32, 2>;
    var phi_6868_: array<u32, 2>;
    var phi_6869_: bool;
    var phi_6873_: array<u32, 2>;
    var phi_6841_: array<u32, 2>;
    var phi_6842_: array<u32, 2>;
    var phi_6843_: bool;
    var phi_6847_: array<u32, 2>;
    var phi_6875_: type_58;
    var phi_6882_: bool;
    var phi_6906_: u32;
    var phi_6927_: u32;
    var phi_7008_: type_48;
    var phi_7009_: bool;
    var phi_7010_: type_48;
    var phi_7011_: bool;
    var phi_7012_: bool;
    var phi_7016_: bool;
    var phi_7020_: type_48;
    var phi_7021_: bool;
    var phi_7032_: u32;
    var local_44: u32;
    var local_45: f32;
    var local_46: f32;
    var local_47: bool;
    var local_48: bool;
    var local_49: f32;
    var local_50: array<f32, 3>;
    var local_51: f32;
    var local_52: f32;
    var local_53: bool;
    var local_54: bool;
    var local_55: bool;
    var local_56: bool;
    var local_57: bool;
    var local_58: bool;
    var local_59: f32;
    var local_60: f32;
    var local_61: bool;
    var local_62: bool;
    var local_63: bool;
    var local_64: array<f32, 3>;
    var local_65: f32;
    var local_66: f32;
    var local_67: bool;
    var local_68: bool;
    var local_69: bool;
    var local_70: bool;
    var local_71: bool;
    var local_72: bool;
    var local_73: f32;
    var local_74: f32;
    var local_75: bool;
    var local_76: array<f32, 3>;

    let _e104 = id_1;
    let _e105 = n_1;
    let _e106 = lane_1;
    let _e118 = ((_e104.y * _e105.x) + _e104.x);
    let _e121 = (_e105.x * _e105.y);
    let _e123 = params.member.member_15;
    let _e125 = input.member[0u];
    if (_e123 < _e125) {
        phi_201_ = _e123;
    } else {
        phi_201_ = _e125;
    }
    let _e128 = phi_201_;
    let _e129 = (_e128 / 64u);
    if ((_e128 % 64u) > 0u) {
        phi_217_ = (_e129 + 1u);
    } else {
        phi_217_ = _e129;
    }
    let _e134 = phi_217_;
    if (_e134 > _e118) {
        let _e136 = (_e134 - _e118);
        if (_e121 == 0u) {
            return;
        }
        let _e138 = (_e136 / _e121);
        if (_e121 == 0u) {
            return;
        }
        if ((_e136 % _e121) > 0u) {
            phi_238_ = (_e138 + 1u);
        } else {
            phi_238_ = _e138;
        }
        let _e144 = phi_238_;
        phi_239_ = _e144;
    } else {
        phi_239_ = 0u;
    }
    let _e146 = phi_239_;
    phi_242_ = type_28(0u, _e146);
    loop {
        let _e149 = phi_242_;
        if (_e149.member < _e149.member_1) {
            phi_243_ = type_28((_e149.member + 1u), _e149.member_1);
            phi_266_ = type_28(1u, _e149.member);
        } else {
            phi_243_ = _e149;
            phi_266_ = type_28(0u, type_28().member_1);
        }
        let _e163 = phi_243_;
        let _e165 = phi_266_;
        let _e169 = (bitcast<i32>(_e165.member) != 0i);
        if _e169 {
            let _e173 = (((_e118 + (_e165.member_1 * _e121)) * 64u) + _e106);
            let _e175 = params.member.member_8;
            let _e176 = type_48(_e175, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
            if (_e173 < _e128) {
                let _e191 = (2u * _e173);
                let _e194 = input.member[(4u + _e191)];
                let _e197 = input.member[(_e191 + 5u)];
                let _e199 = elements.member[_e194];
                let _e201 = elements.member[_e197];
                let _e207 = paths.member[_e199[0]];
                let _e209 = paths.member[_e199[1]];
                let _e215 = paths.member[_e201[0]];
                let _e217 = paths.member[_e201[1]];
                let _e247 = params.member.member_4;
                local_15 = type_45(array<array<f32, 3>, 2>(array<f32, 3>((_e215.member[0] - _e207.member[0]), (_e215.member[1] - _e207.member[1]), (_e215.member[2] - _e207.member[2])), array<f32, 3>((_e215.member_1[0] - _e207.member_1[0]), (_e215.member_1[1] - _e207.member_1[1]), (_e215.member_1[2] - _e207.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e209.member[0] - _e207.member[0]), (_e209.member[1] - _e207.member[1]), (_e209.member[2] - _e207.member[2])), array<f32, 3>((_e209.member_1[0] - _e207.member_1[0]), (_e209.member_1[1] - _e207.member_1[1]), (_e209.member_1[2] - _e207.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e215.member[0] - _e217.member[0]), (_e215.member[1] - _e217.member[1]), (_e215.member[2] - _e217.member[2])), array<f32, 3>((_e215.member_1[0] - _e217.member_1[0]), (_e215.member_1[1] - _e217.member_1[1]), (_e215.member_1[2] - _e217.member_1[2]))), (_e247 + _e247));
                let _e278 = params.member.member_5;
                let _e281 = local_15.member_1[0u];
                let _e287 = local_15.member_2[0u];
                let _e293 = ((_e281[1] * _e287[2]) - (_e281[2] * _e287[1]));
                let _e296 = ((_e281[2] * _e287[0]) - (_e281[0] * _e287[2]));
                let _e299 = ((_e281[0] * _e287[1]) - (_e281[1] * _e287[0]));
                let _e302 = local_15.member_1[1u];
                let _e308 = local_15.member_2[1u];
                let _e314 = ((_e302[1] * _e308[2]) - (_e302[2] * _e308[1]));
                let _e317 = ((_e302[2] * _e308[0]) - (_e302[0] * _e308[2]));
                let _e320 = ((_e302[0] * _e308[1]) - (_e302[1] * _e308[0]));
                let _e323 = local_15.member_1[0u];
                let _e329 = local_15.member_2[1u];
                let _e344 = local_15.member_1[1u];
                let _e350 = local_15.member_2[0u];
                let _e363 = (((_e323[1] * _e329[2]) - (_e323[2] * _e329[1])) + ((_e344[1] * _e350[2]) - (_e344[2] * _e350[1])));
                let _e364 = (((_e323[2] * _e329[0]) - (_e323[0] * _e329[2])) + ((_e344[2] * _e350[0]) - (_e344[0] * _e350[2])));
                let _e365 = (((_e323[0] * _e329[1]) - (_e323[1] * _e329[0])) + ((_e344[0] * _e350[1]) - (_e344[1] * _e350[0])));
                let _e368 = local_15.member[0u];
                let _e376 = (((_e368[0] * _e293) + (_e368[1] * _e296)) + (_e368[2] * _e299));
                let _e379 = local_15.member[1u];
                let _e390 = local_15.member[0u];
                let _e399 = ((((_e379[0] * _e293) + (_e379[1] * _e296)) + (_e379[2] * _e299)) + (((_e390[0] * _e363) + (_e390[1] * _e364)) + (_e390[2] * _e365)));
                let _e402 = local_15.member[0u];
                let _e413 = local_15.member[1u];
                let _e422 = ((((_e402[0] * _e314) + (_e402[1] * _e317)) + (_e402[2] * _e320)) + (((_e413[0] * _e363) + (_e413[1] * _e364)) + (_e413[2] * _e365)));
                let _e425 = local_15.member[1u];
                let _e433 = (((_e425[0] * _e314) + (_e425[1] * _e317)) + (_e425[2] * _e320));
                let _e436 = local_15.member[0u];
                if (_e436[0] < 0f) {
                    phi_716_ = -(_e436[0]);
                } else {
                    phi_716_ = _e436[0];
                }
                let _e443 = phi_716_;
                if (_e436[1] < 0f) {
                    phi_723_ = -(_e436[1]);
                } else {
                    phi_723_ = _e436[1];
                }
                let _e447 = phi_723_;
                if (_e443 > _e447) {
                    phi_728_ = _e443;
                } else {
                    phi_728_ = _e447;
                }
                let _e450 = phi_728_;
                if (_e436[2] < 0f) {
                    phi_735_ = -(_e436[2]);
                } else {
                    phi_735_ = _e436[2];
                }
                let _e454 = phi_735_;
                if (_e450 > _e454) {
                    phi_740_ = _e450;
                } else {
                    phi_740_ = _e454;
                }
                let _e457 = phi_740_;
                let _e460 = local_15.member[1u];
                if (_e460[0] < 0f) {
                    phi_753_ = -(_e460[0]);
                } else {
                    phi_753_ = _e460[0];
                }
                let _e467 = phi_753_;
                if (_e460[1] < 0f) {
                    phi_760_ = -(_e460[1]);
                } else {
                    phi_760_ = _e460[1];
                }
                let _e471 = phi_760_;
                if (_e467 > _e471) {
                    phi_765_ = _e467;
                } else {
                    phi_765_ = _e471;
                }
                let _e474 = phi_765_;
                if (_e460[2] < 0f) {
                    phi_772_ = -(_e460[2]);
                } else {
                    phi_772_ = _e460[2];
                }
                let _e478 = phi_772_;
                if (_e474 > _e478) {
                    phi_777_ = _e474;
                } else {
                    phi_777_ = _e478;
                }
                let _e481 = phi_777_;
                if (_e457 > _e481) {
                    phi_782_ = _e457;
                } else {
                    phi_782_ = _e481;
                }
                let _e484 = phi_782_;
                let _e486 = local_15.member_3;
                let _e487 = (_e484 + _e486);
                let _e490 = local_15.member_1[0u];
                if (_e490[0] < 0f) {
                    phi_799_ = -(_e490[0]);
                } else {
                    phi_799_ = _e490[0];
                }
                let _e497 = phi_799_;
                if (_e490[1] < 0f) {
                    phi_806_ = -(_e490[1]);
                } else {
                    phi_806_ = _e490[1];
                }
                let _e501 = phi_806_;
                if (_e497 > _e501) {
                    phi_811_ = _e497;
                } else {
                    phi_811_ = _e501;
                }
                let _e504 = phi_811_;
                if (_e490[2] < 0f) {
                    phi_818_ = -(_e490[2]);
                } else {
                    phi_818_ = _e490[2];
                }
                let _e508 = phi_818_;
                if (_e504 > _e508) {
                    phi_823_ = _e504;
                } else {
                    phi_823_ = _e508;
                }
                let _e511 = phi_823_;
                let _e514 = local_15.member_1[1u];
                if (_e514[0] < 0f) {
                    phi_837_ = -(_e514[0]);
                } else {
                    phi_837_ = _e514[0];
                }
                let _e521 = phi_837_;
                if (_e514[1] < 0f) {
                    phi_844_ = -(_e514[1]);
                } else {
                    phi_844_ = _e514[1];
                }
                let _e525 = phi_844_;
                if (_e521 > _e525) {
                    phi_849_ = _e521;
                } else {
                    phi_849_ = _e525;
                }
                let _e528 = phi_849_;
                if (_e514[2] < 0f) {
                    phi_856_ = -(_e514[2]);
                } else {
                    phi_856_ = _e514[2];
                }
                let _e532 = phi_856_;
                if (_e528 > _e532) {
                    phi_861_ = _e528;
                } else {
                    phi_861_ = _e532;
                }
                let _e535 = phi_861_;
                if (_e511 > _e535) {
                    phi_866_ = _e511;
                } else {
                    phi_866_ = _e535;
                }
                let _e538 = phi_866_;
                let _e540 = local_15.member_3;
                let _e541 = (_e538 + _e540);
                let _e544 = local_15.member_2[0u];
                if (_e544[0] < 0f) {
                    phi_883_ = -(_e544[0]);
                } else {
                    phi_883_ = _e544[0];
                }
                let _e551 = phi_883_;
                if (_e544[1] < 0f) {
                    phi_890_ = -(_e544[1]);
                } else {
                    phi_890_ = _e544[1];
                }
                let _e555 = phi_890_;
                if (_e551 > _e555) {
                    phi_895_ = _e551;
                } else {
                    phi_895_ = _e555;
                }
                let _e558 = phi_895_;
                if (_e544[2] < 0f) {
                    phi_902_ = -(_e544[2]);
                } else {
                    phi_902_ = _e544[2];
                }
                let _e562 = phi_902_;
                if (_e558 > _e562) {
                    phi_907_ = _e558;
                } else {
                    phi_907_ = _e562;
                }
                let _e565 = phi_907_;
                let _e568 = local_15.member_2[1u];
                if (_e568[0] < 0f) {
                    phi_921_ = -(_e568[0]);
                } else {
                    phi_921_ = _e568[0];
                }
                let _e575 = phi_921_;
                if (_e568[1] < 0f) {
                    phi_928_ = -(_e568[1]);
                } else {
                    phi_928_ = _e568[1];
                }
                let _e579 = phi_928_;
                if (_e575 > _e579) {
                    phi_933_ = _e575;
                } else {
                    phi_933_ = _e579;
                }
                let _e582 = phi_933_;
                if (_e568[2] < 0f) {
                    phi_940_ = -(_e568[2]);
                } else {
                    phi_940_ = _e568[2];
                }
                let _e586 = phi_940_;
                if (_e582 > _e586) {
                    phi_945_ = _e582;
                } else {
                    phi_945_ = _e586;
                }
                let _e589 = phi_945_;
                if (_e565 > _e589) {
                    phi_950_ = _e565;
                } else {
                    phi_950_ = _e589;
                }
                let _e592 = phi_950_;
                let _e594 = local_15.member_3;
                let _e595 = (_e592 + _e594);
                let _e597 = ((_e541 * 8f) * _e595);
                let _e604 = local_15.member_3;
                if (_e293 < 0f) {
                    phi_981_ = -(_e293);
                } else {
                    phi_981_ = _e293;
                }
                let _e621 = phi_981_;
                if (_e296 < 0f) {
                    phi_987_ = -(_e296);
                } else {
                    phi_987_ = _e296;
                }
                let _e625 = phi_987_;
                if (_e299 < 0f) {
                    phi_994_ = -(_e299);
                } else {
                    phi_994_ = _e299;
                }
                let _e630 = phi_994_;
                let _e631 = ((_e621 + _e625) + _e630);
                if (_e314 < 0f) {
                    phi_1001_ = -(_e314);
                } else {
                    phi_1001_ = _e314;
                }
                let _e635 = phi_1001_;
                if (_e317 < 0f) {
                    phi_1007_ = -(_e317);
                } else {
                    phi_1007_ = _e317;
                }
                let _e639 = phi_1007_;
                if (_e320 < 0f) {
                    phi_1014_ = -(_e320);
                } else {
                    phi_1014_ = _e320;
                }
                let _e644 = phi_1014_;
                let _e645 = ((_e635 + _e639) + _e644);
                if (_e631 > _e645) {
                    phi_1020_ = _e631;
                } else {
                    phi_1020_ = _e645;
                }
                let _e648 = phi_1020_;
                if (_e363 < 0f) {
                    phi_1026_ = -(_e363);
                } else {
                    phi_1026_ = _e363;
                }
                let _e652 = phi_1026_;
                if (_e364 < 0f) {
                    phi_1032_ = -(_e364);
                } else {
                    phi_1032_ = _e364;
                }
                let _e656 = phi_1032_;
                if (_e365 < 0f) {
                    phi_1039_ = -(_e365);
                } else {
                    phi_1039_ = _e365;
                }
                let _e661 = phi_1039_;
                let _e663 = (((_e652 + _e656) + _e661) * 0.5f);
                if (_e648 > _e663) {
                    phi_1046_ = _e648;
                } else {
                    phi_1046_ = _e663;
                }
                let _e666 = phi_1046_;
                let _e671 = local_15.member_3;
                let _e683 = (((((_e487 * 8f) * _e597) * (0.000000059604645f * (490f / 64f))) + ((_e604 * 19f) * ((_e487 * (_e541 + _e595)) + (_e541 * _e595)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e487) * ((1f + _e541) * (1f + _e595)))));
                let _e684 = (_e376 * 3f);
                let _e685 = (_e433 * 3f);
                if (_e684 < _e685) {
                    phi_1070_ = _e684;
                } else {
                    phi_1070_ = _e685;
                }
                let _e688 = phi_1070_;
                if (_e399 < _e422) {
                    phi_1075_ = _e399;
                } else {
                    phi_1075_ = _e422;
                }
                let _e691 = phi_1075_;
                if (_e688 < _e691) {
                    phi_1080_ = _e688;
                } else {
                    phi_1080_ = _e691;
                }
                let _e694 = phi_1080_;
                if (_e684 > _e685) {
                    phi_1085_ = _e684;
                } else {
                    phi_1085_ = _e685;
                }
                let _e697 = phi_1085_;
                if (_e399 > _e422) {
                    phi_1090_ = _e399;
                } else {
                    phi_1090_ = _e422;
                }
                let _e700 = phi_1090_;
                if (_e697 > _e700) {
                    phi_1095_ = _e697;
                } else {
                    phi_1095_ = _e700;
                }
                let _e703 = phi_1095_;
                let _e708 = -(_e703);
                if (_e694 > _e708) {
                    phi_1105_ = _e694;
                } else {
                    phi_1105_ = _e708;
                }
                let _e711 = phi_1105_;
                if ((_e711 - (_e683 + ((_e278 * (((_e666 + (_e597 * (0.000000059604645f * 4f))) + ((_e671 * 6f) * (_e541 + _e595))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e541) * (1f + _e595))))) * (3f * 1.0001f)))) > 0f) {
                    phi_6814_ = type_55(0u, type_55().member_1);
                } else {
                    if (_e278 > 0f) {
                        let _e3002 = local_15.member[0u];
                        let _e3008 = local_15.member_1[0u];
                        let _e3014 = local_15.member_2[0u];
                        let _e3018 = (_e3002[0] - _e3008[0]);
                        let _e3019 = (_e3002[1] - _e3008[1]);
                        let _e3020 = (_e3002[2] - _e3008[2]);
                        local_12 = array<array<f32, 3>, 4>(_e3002, array<f32, 3>(_e3018, _e3019, _e3020), array<f32, 3>((_e3002[0] - _e3014[0]), (_e3002[1] - _e3014[1]), (_e3002[2] - _e3014[2])), array<f32, 3>((_e3018 - _e3014[0]), (_e3019 - _e3014[1]), (_e3020 - _e3014[2])));
                        let _e3033 = local_15.member[1u];
                        let _e3039 = local_15.member_1[1u];
                        let _e3045 = local_15.member_2[1u];
                        let _e3049 = (_e3033[0] - _e3039[0]);
                        let _e3050 = (_e3033[1] - _e3039[1]);
                        let _e3051 = (_e3033[2] - _e3039[2]);
                        local_13 = array<array<f32, 3>, 4>(_e3033, array<f32, 3>(_e3049, _e3050, _e3051), array<f32, 3>((_e3033[0] - _e3045[0]), (_e3033[1] - _e3045[1]), (_e3033[2] - _e3045[2])), array<f32, 3>((_e3049 - _e3045[0]), (_e3050 - _e3045[1]), (_e3051 - _e3045[2])));
                        let _e3064 = local_15.member[0u];
                        if (_e3064[0] < 0f) {
                            phi_1306_ = -(_e3064[0]);
                        } else {
                            phi_1306_ = _e3064[0];
                        }
                        let _e3071 = phi_1306_;
                        if (_e3064[1] < 0f) {
                            phi_1313_ = -(_e3064[1]);
                        } else {
                            phi_1313_ = _e3064[1];
                        }
                        let _e3075 = phi_1313_;
                        if (_e3071 > _e3075) {
                            phi_1318_ = _e3071;
                        } else {
                            phi_1318_ = _e3075;
                        }
                        let _e3078 = phi_1318_;
                        if (_e3064[2] < 0f) {
                            phi_1325_ = -(_e3064[2]);
                        } else {
                            phi_1325_ = _e3064[2];
                        }
                        let _e3082 = phi_1325_;
                        if (_e3078 > _e3082) {
                            phi_1330_ = _e3078;
                        } else {
                            phi_1330_ = _e3082;
                        }
                        let _e3085 = phi_1330_;
                        let _e3088 = local_15.member[1u];
                        if (_e3088[0] < 0f) {
                            phi_1343_ = -(_e3088[0]);
                        } else {
                            phi_1343_ = _e3088[0];
                        }
                        let _e3095 = phi_1343_;
                        if (_e3088[1] < 0f) {
                            phi_1350_ = -(_e3088[1]);
                        } else {
                            phi_1350_ = _e3088[1];
                        }
                        let _e3099 = phi_1350_;
                        if (_e3095 > _e3099) {
                            phi_1355_ = _e3095;
                        } else {
                            phi_1355_ = _e3099;
                        }
                        let _e3102 = phi_1355_;
                        if (_e3088[2] < 0f) {
                            phi_1362_ = -(_e3088[2]);
                        } else {
                            phi_1362_ = _e3088[2];
                        }
                        let _e3106 = phi_1362_;
                        if (_e3102 > _e3106) {
                            phi_1367_ = _e3102;
                        } else {
                            phi_1367_ = _e3106;
                        }
                        let _e3109 = phi_1367_;
                        if (_e3085 > _e3109) {
                            phi_1372_ = _e3085;
                        } else {
                            phi_1372_ = _e3109;
                        }
                        let _e3112 = phi_1372_;
                        let _e3114 = local_15.member_3;
                        let _e3118 = local_15.member_1[0u];
                        if (_e3118[0] < 0f) {
                            phi_1389_ = -(_e3118[0]);
                        } else {
                            phi_1389_ = _e3118[0];
                        }
                        let _e3125 = phi_1389_;
                        if (_e3118[1] < 0f) {
                            phi_1396_ = -(_e3118[1]);
                        } else {
                            phi_1396_ = _e3118[1];
                        }
                        let _e3129 = phi_1396_;
                        if (_e3125 > _e3129) {
                            phi_1401_ = _e3125;
                        } else {
                            phi_1401_ = _e3129;
                        }
                        let _e3132 = phi_1401_;
                        if (_e3118[2] < 0f) {
                            phi_1408_ = -(_e3118[2]);
                        } else {
                            phi_1408_ = _e3118[2];
                        }
                        let _e3136 = phi_1408_;
                        if (_e3132 > _e3136) {
                            phi_1413_ = _e3132;
                        } else {
                            phi_1413_ = _e3136;
                        }
                        let _e3139 = phi_1413_;
                        let _e3142 = local_15.member_1[1u];
                        if (_e3142[0] < 0f) {
                            phi_1427_ = -(_e3142[0]);
                        } else {
                            phi_1427_ = _e3142[0];
                        }
                        let _e3149 = phi_1427_;
                        if (_e3142[1] < 0f) {
                            phi_1434_ = -(_e3142[1]);
                        } else {
                            phi_1434_ = _e3142[1];
                        }
                        let _e3153 = phi_1434_;
                        if (_e3149 > _e3153) {
                            phi_1439_ = _e3149;
                        } else {
                            phi_1439_ = _e3153;
                        }
                        let _e3156 = phi_1439_;
                        if (_e3142[2] < 0f) {
                            phi_1446_ = -(_e3142[2]);
                        } else {
                            phi_1446_ = _e3142[2];
                        }
                        let _e3160 = phi_1446_;
                        if (_e3156 > _e3160) {
                            phi_1451_ = _e3156;
                        } else {
                            phi_1451_ = _e3160;
                        }
                        let _e3163 = phi_1451_;
                        if (_e3139 > _e3163) {
                            phi_1456_ = _e3139;
                        } else {
                            phi_1456_ = _e3163;
                        }
                        let _e3166 = phi_1456_;
                        let _e3168 = local_15.member_3;
                        let _e3172 = local_15.member_2[0u];
                        if (_e3172[0] < 0f) {
                            phi_1473_ = -(_e3172[0]);
                        } else {
                            phi_1473_ = _e3172[0];
                        }
                        let _e3179 = phi_1473_;
                        if (_e3172[1] < 0f) {
                            phi_1480_ = -(_e3172[1]);
                        } else {
                            phi_1480_ = _e3172[1];
                        }
                        let _e3183 = phi_1480_;
                        if (_e3179 > _e3183) {
                            phi_1485_ = _e3179;
                        } else {
                            phi_1485_ = _e3183;
                        }
                        let _e3186 = phi_1485_;
                        if (_e3172[2] < 0f) {
                            phi_1492_ = -(_e3172[2]);
                        } else {
                            phi_1492_ = _e3172[2];
                        }
                        let _e3190 = phi_1492_;
                        if (_e3186 > _e3190) {
                            phi_1497_ = _e3186;
                        } else {
                            phi_1497_ = _e3190;
                        }
                        let _e3193 = phi_1497_;
                        let _e3196 = local_15.member_2[1u];
                        if (_e3196[0] < 0f) {
                            phi_1511_ = -(_e3196[0]);
                        } else {
                            phi_1511_ = _e3196[0];
                        }
                        let _e3203 = phi_1511_;
                        if (_e3196[1] < 0f) {
                            phi_1518_ = -(_e3196[1]);
                        } else {
                            phi_1518_ = _e3196[1];
                        }
                        let _e3207 = phi_1518_;
                        if (_e3203 > _e3207) {
                            phi_1523_ = _e3203;
                        } else {
                            phi_1523_ = _e3207;
                        }
                        let _e3210 = phi_1523_;
                        if (_e3196[2] < 0f) {
                            phi_1530_ = -(_e3196[2]);
                        } else {
                            phi_1530_ = _e3196[2];
                        }
                        let _e3214 = phi_1530_;
                        if (_e3210 > _e3214) {
                            phi_1535_ = _e3210;
                        } else {
                            phi_1535_ = _e3214;
                        }
                        let _e3217 = phi_1535_;
                        if (_e3193 > _e3217) {
                            phi_1540_ = _e3193;
                        } else {
                            phi_1540_ = _e3217;
                        }
                        let _e3220 = phi_1540_;
                        let _e3222 = local_15.member_3;
                        let _e3229 = local_15.member_3;
                        phi_1556_ = type_28(0u, 48u);
                        phi_1559_ = 0f;
                        loop {
                            let _e3235 = phi_1556_;
                            let _e3237 = phi_1559_;
                            local_74 = _e3237;
                            local_39 = _e3237;
                            local_40 = _e3237;
                            local_41 = _e3237;
                            if (_e3235.member < _e3235.member_1) {
                                phi_1557_ = type_28((_e3235.member + 1u), _e3235.member_1);
                                phi_1582_ = type_28(1u, _e3235.member);
                            } else {
                                phi_1557_ = _e3235;
                                phi_1582_ = type_28(0u, type_28().member_1);
                            }
                            let _e3251 = phi_1557_;
                            let _e3253 = phi_1582_;
                            if (bitcast<i32>(_e3253.member) != 0i) {
                                let _e3259 = local_15.member[0u];
                                let _e3265 = local_15.member[1u];
                                let _e3275 = (_e3259[0] + ((_e3265[0] - _e3259[0]) * _e3237));
                                let _e3276 = (_e3259[1] + ((_e3265[1] - _e3259[1]) * _e3237));
                                let _e3277 = (_e3259[2] + ((_e3265[2] - _e3259[2]) * _e3237));
                                let _e3280 = local_15.member_1[0u];
                                let _e3286 = local_15.member_1[1u];
                                let _e3296 = (_e3280[0] + ((_e3286[0] - _e3280[0]) * _e3237));
                                let _e3297 = (_e3280[1] + ((_e3286[1] - _e3280[1]) * _e3237));
                                let _e3298 = (_e3280[2] + ((_e3286[2] - _e3280[2]) * _e3237));
                                let _e3301 = local_15.member_2[0u];
                                let _e3307 = local_15.member_2[1u];
                                let _e3317 = (_e3301[0] + ((_e3307[0] - _e3301[0]) * _e3237));
                                let _e3318 = (_e3301[1] + ((_e3307[1] - _e3301[1]) * _e3237));
                                let _e3319 = (_e3301[2] + ((_e3307[2] - _e3301[2]) * _e3237));
                                let _e3324 = (((_e3296 * _e3296) + (_e3297 * _e3297)) + (_e3298 * _e3298));
                                let _e3329 = (((_e3296 * _e3317) + (_e3297 * _e3318)) + (_e3298 * _e3319));
                                let _e3334 = (((_e3317 * _e3317) + (_e3318 * _e3318)) + (_e3319 * _e3319));
                                let _e3339 = (((_e3275 * _e3296) + (_e3276 * _e3297)) + (_e3277 * _e3298));
                                let _e3344 = (((_e3275 * _e3317) + (_e3276 * _e3318)) + (_e3277 * _e3319));
                                let _e3347 = ((_e3324 * _e3334) - (_e3329 * _e3329));
                                let _e3351 = (((_e3339 * _e3334) - (_e3344 * _e3329)) / _e3347);
                                let _e3355 = (((_e3344 * _e3324) - (_e3339 * _e3329)) / _e3347);
                                if (_e3351 >= 0f) {
                                    if (_e3355 >= 0f) {
                                        if (_e3351 <= 1f) {
                                            phi_1736_ = (_e3355 <= 1f);
                                            phi_1737_ = false;
                                        } else {
                                            phi_1736_ = bool();
                                            phi_1737_ = true;
                                        }
                                        let _e3361 = phi_1736_;
                                        let _e3363 = phi_1737_;
                                        phi_1738_ = _e3361;
                                        phi_1739_ = _e3363;
                                    } else {
                                        phi_1738_ = bool();
                                        phi_1739_ = true;
                                    }
                                    let _e3365 = phi_1738_;
                                    let _e3367 = phi_1739_;
                                    phi_1740_ = _e3365;
                                    phi_1741_ = _e3367;
                                } else {
                                    phi_1740_ = bool();
                                    phi_1741_ = true;
                                }
                                let _e3369 = phi_1740_;
                                let _e3371 = phi_1741_;
                                if _e3371 {
                                    let _e3372 = (_e3347 > 0f);
                                    if _e3372 {
                                        phi_1771_ = false;
                                    } else {
                                        phi_1771_ = true;
                                    }
                                    let _e3374 = phi_1771_;
                                    phi_1772_ = false;
                                    phi_1773_ = _e3374;
                                    phi_1774_ = _e3372;
                                } else {
                                    phi_1772_ = true;
                                    phi_1773_ = false;
                                    phi_1774_ = false;
                                }
                                let _e3376 = phi_1772_;
                                let _e3378 = phi_1773_;
                                let _e3380 = phi_1774_;
                                if _e3376 {
                                    if (_e3347 > 0f) {
                                        if _e3369 {
                                            phi_1798_ = array<f32, 3>((_e3275 - ((_e3296 * _e3351) + (_e3317 * _e3355))), (_e3276 - ((_e3297 * _e3351) + (_e3318 * _e3355))), (_e3277 - ((_e3298 * _e3351) + (_e3319 * _e3355))));
                                            phi_1799_ = false;
                                        } else {
                                            phi_1798_ = array<f32, 3>();
                                            phi_1799_ = true;
                                        }
                                        let _e3396 = phi_1798_;
                                        let _e3398 = phi_1799_;
                                        phi_1800_ = _e3396;
                                        phi_1801_ = false;
                                        phi_1802_ = _e3398;
                                    } else {
                                        phi_1800_ = array<f32, 3>();
                                        phi_1801_ = true;
                                        phi_1802_ = false;
                                    }
                                    let _e3400 = phi_1800_;
                                    let _e3402 = phi_1801_;
                                    let _e3404 = phi_1802_;
                                    phi_1803_ = _e3400;
                                    phi_1804_ = _e3402;
                                    phi_1805_ = _e3404;
                                } else {
                                    phi_1803_ = array<f32, 3>();
                                    phi_1804_ = _e3378;
                                    phi_1805_ = _e3380;
                                }
                                let _e3406 = phi_1803_;
                                let _e3408 = phi_1804_;
                                let _e3410 = phi_1805_;
                                if _e3408 {
                                    phi_1809_ = true;
                                } else {
                                    phi_1809_ = _e3410;
                                }
                                let _e3412 = phi_1809_;
                                if _e3412 {
                                    let _e3413 = (_e3275 - _e3296);
                                    let _e3414 = (_e3276 - _e3297);
                                    let _e3415 = (_e3277 - _e3298);
                                    let _e3426 = ((((_e3275 * _e3296) + (_e3276 * _e3297)) + (_e3277 * _e3298)) / (((_e3296 * _e3296) + (_e3297 * _e3297)) + (_e3298 * _e3298)));
                                    if (_e3426 > 0f) {
                                        if (_e3426 < 1f) {
                                            phi_1839_ = _e3426;
                                        } else {
                                            phi_1839_ = 1f;
                                        }
                                        let _e3430 = phi_1839_;
                                        phi_1840_ = _e3430;
                                    } else {
                                        phi_1840_ = 0f;
                                    }
                                    let _e3432 = phi_1840_;
                                    let _e3449 = ((((_e3275 * _e3317) + (_e3276 * _e3318)) + (_e3277 * _e3319)) / (((_e3317 * _e3317) + (_e3318 * _e3318)) + (_e3319 * _e3319)));
                                    if (_e3449 > 0f) {
                                        if (_e3449 < 1f) {
                                            phi_1867_ = _e3449;
                                        } else {
                                            phi_1867_ = 1f;
                                        }
                                        let _e3453 = phi_1867_;
                                        phi_1868_ = _e3453;
                                    } else {
                                        phi_1868_ = 0f;
                                    }
                                    let _e3455 = phi_1868_;
                                    let _e3472 = ((((_e3413 * _e3317) + (_e3414 * _e3318)) + (_e3415 * _e3319)) / (((_e3317 * _e3317) + (_e3318 * _e3318)) + (_e3319 * _e3319)));
                                    if (_e3472 > 0f) {
                                        if (_e3472 < 1f) {
                                            phi_1895_ = _e3472;
                                        } else {
                                            phi_1895_ = 1f;
                                        }
                                        let _e3476 = phi_1895_;
                                        phi_1896_ = _e3476;
                                    } else {
                                        phi_1896_ = 0f;
                                    }
                                    let _e3478 = phi_1896_;
                                    let _e3485 = (_e3275 - _e3317);
                                    let _e3486 = (_e3276 - _e3318);
                                    let _e3487 = (_e3277 - _e3319);
                                    let _e3498 = ((((_e3485 * _e3296) + (_e3486 * _e3297)) + (_e3487 * _e3298)) / (((_e3296 * _e3296) + (_e3297 * _e3297)) + (_e3298 * _e3298)));
                                    if (_e3498 > 0f) {
                                        if (_e3498 < 1f) {
                                            phi_1926_ = _e3498;
                                        } else {
                                            phi_1926_ = 1f;
                                        }
                                        let _e3502 = phi_1926_;
                                        phi_1927_ = _e3502;
                                    } else {
                                        phi_1927_ = 0f;
                                    }
                                    let _e3504 = phi_1927_;
                                    local_11[0u] = array<f32, 3>((_e3275 - (_e3296 * _e3432)), (_e3276 - (_e3297 * _e3432)), (_e3277 - (_e3298 * _e3432)));
                                    local_11[1u] = array<f32, 3>((_e3275 - (_e3317 * _e3455)), (_e3276 - (_e3318 * _e3455)), (_e3277 - (_e3319 * _e3455)));
                                    local_11[2u] = array<f32, 3>((_e3413 - (_e3317 * _e3478)), (_e3414 - (_e3318 * _e3478)), (_e3415 - (_e3319 * _e3478)));
                                    local_11[3u] = array<f32, 3>((_e3485 - (_e3296 * _e3504)), (_e3486 - (_e3297 * _e3504)), (_e3487 - (_e3298 * _e3504)));
                                    let _e3520 = local_11[0u];
                                    phi_2070_ = type_28(1u, 4u);
                                    phi_2073_ = array<f32, 3>(_e3520[0], _e3520[1], _e3520[2]);
                                    loop {
                                        let _e3526 = phi_2070_;
                                        let _e3528 = phi_2073_;
                                        local_64 = _e3528;
                                        if (_e3526.member < _e3526.member_1) {
                                            phi_2071_ = type_28((_e3526.member + 1u), _e3526.member_1);
                                            phi_2096_ = type_28(1u, _e3526.member);
                                        } else {
                                            phi_2071_ = _e3526;
                                            phi_2096_ = type_28(0u, type_28().member_1);
                                        }
                                        let _e3542 = phi_2071_;
                                        let _e3544 = phi_2096_;
                                        let _e3548 = (bitcast<i32>(_e3544.member) != 0i);
                                        if _e3548 {
                                            if (_e3544.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3551 = local_11[_e3544.member_1];
                                            if (_e3544.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3557 = local_11[_e3544.member_1];
                                            if ((((_e3551[0] * _e3557[0]) + (_e3551[1] * _e3557[1])) + (_e3551[2] * _e3557[2])) < (((_e3528[0] * _e3528[0]) + (_e3528[1] * _e3528[1])) + (_e3528[2] * _e3528[2]))) {
                                                if (_e3544.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3580 = local_11[_e3544.member_1];
                                                phi_2163_ = array<f32, 3>(_e3580[0], _e3580[1], _e3580[2]);
                                            } else {
                                                phi_2163_ = _e3528;
                                            }
                                            let _e3586 = phi_2163_;
                                            phi_2074_ = _e3586;
                                        } else {
                                            phi_2074_ = array<f32, 3>();
                                        }
                                        let _e3588 = phi_2074_;
                                        continue;
                                        continuing {
                                            phi_2070_ = _e3542;
                                            phi_2073_ = _e3588;
                                            break if !(_e3548);
                                        }
                                    }
                                    let _e5384 = local_64;
                                    phi_2164_ = _e5384;
                                } else {
                                    phi_2164_ = _e3406;
                                }
                                let _e3591 = phi_2164_;
                                if (_e3591[0] < 0f) {
                                    phi_2171_ = -(_e3591[0]);
                                } else {
                                    phi_2171_ = _e3591[0];
                                }
                                let _e3596 = phi_2171_;
                                if (_e3591[1] < 0f) {
                                    phi_2178_ = -(_e3591[1]);
                                } else {
                                    phi_2178_ = _e3591[1];
                                }
                                let _e3601 = phi_2178_;
                                if (_e3591[2] < 0f) {
                                    phi_2186_ = -(_e3591[2]);
                                } else {
                                    phi_2186_ = _e3591[2];
                                }
                                let _e3607 = phi_2186_;
                                let _e3608 = ((_e3596 + _e3601) + _e3607);
                                if (_e3608 > 0f) {
                                    if ((bitcast<u32>(_e3608) & 2139095040u) != 2139095040u) {
                                        let _e3613 = (1f / _e3608);
                                        let _e3615 = (_e3591[0] * _e3613);
                                        let _e3617 = (_e3591[1] * _e3613);
                                        let _e3619 = (_e3591[2] * _e3613);
                                        let _e3624 = (((_e3615 * _e3615) + (_e3617 * _e3617)) + (_e3619 * _e3619));
                                        if (_e3624 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3624 > 0f) {
                                                phi_2223_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2223_ = 0f;
                                            }
                                            let _e3683 = phi_2223_;
                                            phi_2287_ = _e3683;
                                        } else {
                                            phi_2230_ = type_26(0i, 5i);
                                            phi_2233_ = bitcast<f32>(((bitcast<u32>(_e3624) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3632 = phi_2230_;
                                                let _e3634 = phi_2233_;
                                                local_33 = _e3634;
                                                if (_e3632.member < _e3632.member_1) {
                                                    let _e3642 = (_e3632.member + 1i);
                                                    if ((false == (_e3642 > _e3632.member)) != false) {
                                                        phi_2254_ = true;
                                                    } else {
                                                        phi_2254_ = false;
                                                    }
                                                    let _e3647 = phi_2254_;
                                                    if _e3647 {
                                                        phi_2260_ = type_27(0u, type_27().member_1);
                                                    } else {
                                                        phi_2260_ = type_27(1u, _e3642);
                                                    }
                                                    let _e3653 = phi_2260_;
                                                    if (bitcast<i32>(_e3653.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2231_ = type_26(_e3653.member_1, _e3632.member_1);
                                                    phi_2274_ = type_27(1u, _e3632.member);
                                                } else {
                                                    phi_2231_ = _e3632;
                                                    phi_2274_ = type_27(0u, type_27().member_1);
                                                }
                                                let _e3663 = phi_2231_;
                                                let _e3665 = phi_2274_;
                                                let _e3668 = (bitcast<i32>(_e3665.member) != 0i);
                                                if _e3668 {
                                                    phi_2234_ = (0.5f * (_e3634 + (_e3624 / _e3634)));
                                                } else {
                                                    phi_2234_ = f32();
                                                }
                                                let _e3673 = phi_2234_;
                                                continue;
                                                continuing {
                                                    phi_2230_ = _e3663;
                                                    phi_2233_ = _e3673;
                                                    break if !(_e3668);
                                                }
                                            }
                                            let _e3678 = local_33;
                                            phi_2287_ = (_e3678 * (1f + (4f * 0.000000059604645f)));
                                        }
                                        let _e3685 = phi_2287_;
                                        phi_2296_ = type_28(0u, 4u);
                                        phi_2299_ = 2f;
                                        loop {
                                            let _e3693 = phi_2296_;
                                            let _e3695 = phi_2299_;
                                            local_35 = _e3695;
                                            local_36 = _e3695;
                                            local_37 = _e3695;
                                            local_65 = _e3695;
                                            local_66 = _e3695;
                                            if (_e3693.member < _e3693.member_1) {
                                                phi_2297_ = type_28((_e3693.member + 1u), _e3693.member_1);
                                                phi_2322_ = type_28(1u, _e3693.member);
                                            } else {
                                                phi_2297_ = _e3693;
                                                phi_2322_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e3709 = phi_2297_;
                                            let _e3711 = phi_2322_;
                                            if (bitcast<i32>(_e3711.member) != 0i) {
                                                if (_e3711.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3718 = local_12[_e3711.member_1];
                                                let _e3726 = (((_e3615 * _e3718[0]) + (_e3617 * _e3718[1])) + (_e3619 * _e3718[2]));
                                                if (_e3711.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3729 = local_13[_e3711.member_1];
                                                let _e3737 = (((_e3615 * _e3729[0]) + (_e3617 * _e3729[1])) + (_e3619 * _e3729[2]));
                                                if (_e3726 < 0f) {
                                                    phi_2373_ = -(_e3726);
                                                } else {
                                                    phi_2373_ = _e3726;
                                                }
                                                let _e3741 = phi_2373_;
                                                if (_e3737 < 0f) {
                                                    phi_2379_ = -(_e3737);
                                                } else {
                                                    phi_2379_ = _e3737;
                                                }
                                                let _e3745 = phi_2379_;
                                                let _e3749 = (((((((((_e3112 + _e3114) + (_e3166 + _e3168)) + (_e3220 + _e3222)) * (0.000000059604645f * 16f)) + (_e3229 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e278 * _e3685) * (1f + (0.000000059604645f * 8f)))) + ((_e3741 + _e3745) * (0.000000059604645f * 8f)));
                                                if (_e3726 > _e3749) {
                                                    if (_e3737 > _e3749) {
                                                        phi_2392_ = false;
                                                    } else {
                                                        phi_2392_ = true;
                                                    }
                                                    let _e3753 = phi_2392_;
                                                    phi_2393_ = _e3753;
                                                } else {
                                                    phi_2393_ = true;
                                                }
                                                let _e3755 = phi_2393_;
                                                if _e3755 {
                                                    let _e3759 = ((_e3726 + ((_e3737 - _e3726) * _e3237)) > _e3749);
                                                    if _e3759 {
                                                        if (_e3737 < _e3726) {
                                                            let _e3766 = (((_e3726 - _e3749) / (_e3726 - _e3737)) * (1f - (0.000000059604645f * 16f)));
                                                            if (_e3695 < _e3766) {
                                                                phi_2418_ = _e3695;
                                                            } else {
                                                                phi_2418_ = _e3766;
                                                            }
                                                            let _e3769 = phi_2418_;
                                                            phi_2419_ = _e3769;
                                                        } else {
                                                            phi_2419_ = _e3695;
                                                        }
                                                        let _e3771 = phi_2419_;
                                                        phi_2420_ = _e3771;
                                                    } else {
                                                        phi_2420_ = f32();
                                                    }
                                                    let _e3773 = phi_2420_;
                                                    phi_2421_ = _e3773;
                                                    phi_2422_ = _e3759;
                                                } else {
                                                    phi_2421_ = _e3695;
                                                    phi_2422_ = true;
                                                }
                                                let _e3775 = phi_2421_;
                                                let _e3777 = phi_2422_;
                                                phi_2300_ = _e3775;
                                                phi_2423_ = _e3777;
                                                phi_2424_ = false;
                                            } else {
                                                phi_2300_ = f32();
                                                phi_2423_ = false;
                                                phi_2424_ = true;
                                            }
                                            let _e3779 = phi_2300_;
                                            let _e3781 = phi_2423_;
                                            let _e3783 = phi_2424_;
                                            local_34 = _e3783;
                                            continue;
                                            continuing {
                                                phi_2296_ = _e3709;
                                                phi_2299_ = _e3779;
                                                break if !(_e3781);
                                            }
                                        }
                                        let _e3786 = local_34;
                                        if _e3786 {
                                            let _e3788 = local_35;
                                            let _e3789 = (_e3788 > 1f);
                                            if _e3789 {
                                                phi_2445_ = false;
                                                phi_2446_ = false;
                                                phi_2447_ = false;
                                            } else {
                                                let _e3791 = local_36;
                                                if (_e3791 > _e3237) {
                                                    let _e3794 = local_37;
                                                    let _e3796 = ((_e3794 - _e3237) < 0.00000000023283064f);
                                                    if _e3796 {
                                                        phi_2441_ = false;
                                                    } else {
                                                        phi_2441_ = true;
                                                    }
                                                    let _e3798 = phi_2441_;
                                                    phi_2442_ = _e3798;
                                                    phi_2443_ = _e3796;
                                                    phi_2444_ = false;
                                                } else {
                                                    phi_2442_ = false;
                                                    phi_2443_ = false;
                                                    phi_2444_ = true;
                                                }
                                                let _e3800 = phi_2442_;
                                                let _e3802 = phi_2443_;
                                                let _e3804 = phi_2444_;
                                                phi_2445_ = _e3800;
                                                phi_2446_ = _e3802;
                                                phi_2447_ = _e3804;
                                            }
                                            let _e3806 = phi_2445_;
                                            let _e3808 = phi_2446_;
                                            let _e3810 = phi_2447_;
                                            phi_2448_ = _e3806;
                                            phi_2449_ = _e3789;
                                            phi_2450_ = _e3808;
                                            phi_2451_ = _e3810;
                                            phi_2452_ = false;
                                        } else {
                                            phi_2448_ = false;
                                            phi_2449_ = false;
                                            phi_2450_ = false;
                                            phi_2451_ = false;
                                            phi_2452_ = true;
                                        }
                                        let _e3812 = phi_2448_;
                                        let _e3814 = phi_2449_;
                                        let _e3816 = phi_2450_;
                                        let _e3818 = phi_2451_;
                                        let _e3820 = phi_2452_;
                                        let _e5432 = local_65;
                                        phi_2453_ = _e5432;
                                        let _e5435 = local_66;
                                        phi_2454_ = _e5435;
                                        phi_2455_ = _e3812;
                                        phi_2456_ = _e3814;
                                        phi_2457_ = _e3816;
                                        phi_2458_ = _e3818;
                                        phi_2459_ = _e3820;
                                        phi_2460_ = false;
                                    } else {
                                        phi_2453_ = f32();
                                        phi_2454_ = f32();
                                        phi_2455_ = false;
                                        phi_2456_ = false;
                                        phi_2457_ = false;
                                        phi_2458_ = false;
                                        phi_2459_ = false;
                                        phi_2460_ = true;
                                    }
                                    let _e3822 = phi_2453_;
                                    let _e3824 = phi_2454_;
                                    let _e3826 = phi_2455_;
                                    let _e3828 = phi_2456_;
                                    let _e3830 = phi_2457_;
                                    let _e3832 = phi_2458_;
                                    let _e3834 = phi_2459_;
                                    let _e3836 = phi_2460_;
                                    phi_2461_ = _e3822;
                                    phi_2462_ = _e3824;
                                    phi_2463_ = _e3826;
                                    phi_2464_ = _e3828;
                                    phi_2465_ = _e3830;
                                    phi_2466_ = _e3832;
                                    phi_2467_ = _e3834;
                                    phi_2468_ = _e3836;
                                    phi_2469_ = false;
                                } else {
                                    phi_2461_ = f32();
                                    phi_2462_ = f32();
                                    phi_2463_ = false;
                                    phi_2464_ = false;
                                    phi_2465_ = false;
                                    phi_2466_ = false;
                                    phi_2467_ = false;
                                    phi_2468_ = false;
                                    phi_2469_ = true;
                                }
                                let _e3838 = phi_2461_;
                                let _e3840 = phi_2462_;
                                let _e3842 = phi_2463_;
                                let _e3844 = phi_2464_;
                                let _e3846 = phi_2465_;
                                let _e3848 = phi_2466_;
                                let _e3850 = phi_2467_;
                                let _e3852 = phi_2468_;
                                let _e3854 = phi_2469_;
                                phi_2470_ = _e3838;
                                phi_1560_ = _e3840;
                                phi_2471_ = _e3842;
                                phi_2472_ = _e3844;
                                phi_2473_ = _e3846;
                                phi_2474_ = false;
                                phi_2475_ = _e3848;
                                phi_2476_ = _e3850;
                                phi_2477_ = _e3852;
                                phi_2478_ = _e3854;
                            } else {
                                phi_2470_ = f32();
                                phi_1560_ = f32();
                                phi_2471_ = false;
                                phi_2472_ = false;
                                phi_2473_ = false;
                                phi_2474_ = true;
                                phi_2475_ = false;
                                phi_2476_ = false;
                                phi_2477_ = false;
                                phi_2478_ = false;
                            }
                            let _e3856 = phi_2470_;
                            let _e3858 = phi_1560_;
                            let _e3860 = phi_2471_;
                            let _e3862 = phi_2472_;
                            let _e3864 = phi_2473_;
                            let _e3866 = phi_2474_;
                            let _e3868 = phi_2475_;
                            let _e3870 = phi_2476_;
                            let _e3872 = phi_2477_;
                            let _e3874 = phi_2478_;
                            local_38 = _e3862;
                            local_67 = _e3864;
                            local_68 = _e3866;
                            local_69 = _e3868;
                            local_70 = _e3870;
                            local_71 = _e3872;
                            local_72 = _e3874;
                            local_73 = _e3856;
                            local_75 = _e3862;
                            continue;
                            continuing {
                                phi_1556_ = _e3251;
                                phi_1559_ = _e3858;
                                break if !(_e3860);
                            }
                        }
                        let _e3877 = local_38;
                        if _e3877 {
                            phi_2483_ = type_55(0u, type_55().member_1);
                            phi_2484_ = false;
                            phi_2485_ = false;
                            phi_2486_ = false;
                            phi_2487_ = false;
                            phi_2488_ = false;
                            phi_2489_ = false;
                        } else {
                            phi_2483_ = type_55();
                            let _e5465 = local_67;
                            phi_2484_ = _e5465;
                            let _e5468 = local_68;
                            phi_2485_ = _e5468;
                            let _e5471 = local_69;
                            phi_2486_ = _e5471;
                            let _e5474 = local_70;
                            phi_2487_ = _e5474;
                            let _e5477 = local_71;
                            phi_2488_ = _e5477;
                            let _e5480 = local_72;
                            phi_2489_ = _e5480;
                        }
                        let _e3882 = phi_2483_;
                        let _e3884 = phi_2484_;
                        let _e3886 = phi_2485_;
                        let _e3888 = phi_2486_;
                        let _e3890 = phi_2487_;
                        let _e3892 = phi_2488_;
                        let _e3894 = phi_2489_;
                        if _e3884 {
                            let _e5483 = local_73;
                            phi_2493_ = _e5483;
                            phi_2494_ = true;
                            phi_2495_ = false;
                            phi_2496_ = false;
                            phi_2497_ = false;
                            phi_2498_ = false;
                            phi_2499_ = false;
                        } else {
                            let _e5485 = local_74;
                            phi_2493_ = _e5485;
                            phi_2494_ = _e3886;
                            phi_2495_ = _e3888;
                            phi_2496_ = _e3890;
                            let _e5491 = local_75;
                            phi_2497_ = _e5491;
                            phi_2498_ = _e3892;
                            phi_2499_ = _e3894;
                        }
                        let _e3896 = phi_2493_;
                        let _e3898 = phi_2494_;
                        let _e3900 = phi_2495_;
                        let _e3902 = phi_2496_;
                        let _e3904 = phi_2497_;
                        let _e3906 = phi_2498_;
                        let _e3908 = phi_2499_;
                        if _e3898 {
                            phi_2504_ = type_55(1u, _e3896);
                            phi_2505_ = false;
                            phi_2506_ = false;
                            phi_2507_ = false;
                            phi_2508_ = false;
                            phi_2509_ = false;
                        } else {
                            phi_2504_ = type_55();
                            phi_2505_ = _e3900;
                            phi_2506_ = _e3902;
                            phi_2507_ = _e3904;
                            phi_2508_ = _e3906;
                            phi_2509_ = _e3908;
                        }
                        let _e3911 = phi_2504_;
                        let _e3913 = phi_2505_;
                        let _e3915 = phi_2506_;
                        let _e3917 = phi_2507_;
                        let _e3919 = phi_2508_;
                        let _e3921 = phi_2509_;
                        if _e3913 {
                            let _e3923 = local_39;
                            phi_2514_ = type_55(1u, _e3923);
                            phi_2515_ = false;
                            phi_2516_ = true;
                            phi_2517_ = false;
                            phi_2518_ = false;
                        } else {
                            phi_2514_ = _e3882;
                            phi_2515_ = _e3915;
                            phi_2516_ = _e3917;
                            phi_2517_ = _e3919;
                            phi_2518_ = _e3921;
                        }
                        let _e3926 = phi_2514_;
                        let _e3928 = phi_2515_;
                        let _e3930 = phi_2516_;
                        let _e3932 = phi_2517_;
                        let _e3934 = phi_2518_;
                        if _e3928 {
                            let _e3936 = local_40;
                            phi_2523_ = type_55(1u, _e3936);
                            phi_2524_ = true;
                            phi_2525_ = false;
                            phi_2526_ = false;
                        } else {
                            phi_2523_ = _e3926;
                            phi_2524_ = _e3930;
                            phi_2525_ = _e3932;
                            phi_2526_ = _e3934;
                        }
                        let _e3939 = phi_2523_;
                        let _e3941 = phi_2524_;
                        let _e3943 = phi_2525_;
                        let _e3945 = phi_2526_;
                        if _e3941 {
                            phi_2530_ = false;
                            phi_2531_ = false;
                        } else {
                            phi_2530_ = _e3943;
                            phi_2531_ = _e3945;
                        }
                        let _e3947 = phi_2530_;
                        let _e3949 = phi_2531_;
                        if _e3947 {
                            phi_2535_ = false;
                            phi_2536_ = false;
                        } else {
                            phi_2535_ = _e3949;
                            phi_2536_ = _e3941;
                        }
                        let _e3951 = phi_2535_;
                        let _e3953 = phi_2536_;
                        if _e3951 {
                            phi_2540_ = true;
                            phi_2541_ = false;
                        } else {
                            phi_2540_ = _e3947;
                            phi_2541_ = _e3953;
                        }
                        let _e3955 = phi_2540_;
                        let _e3957 = phi_2541_;
                        if _e3955 {
                            let _e3959 = local_41;
                            phi_2546_ = type_55(1u, _e3959);
                            phi_2547_ = true;
                        } else {
                            phi_2546_ = _e3939;
                            phi_2547_ = _e3957;
                        }
                        let _e3962 = phi_2546_;
                        let _e3964 = phi_2547_;
                        if _e3964 {
                            phi_2551_ = _e3962;
                        } else {
                            phi_2551_ = _e3911;
                        }
                        let _e3966 = phi_2551_;
                        if (_e3966.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_2565_ = type_28(0u, 3u);
                            loop {
                                let _e3979 = phi_2565_;
                                if (_e3979.member < _e3979.member_1) {
                                    phi_2566_ = type_28((_e3979.member + 1u), _e3979.member_1);
                                    phi_2589_ = type_28(1u, _e3979.member);
                                } else {
                                    phi_2566_ = _e3979;
                                    phi_2589_ = type_28(0u, type_28().member_1);
                                }
                                let _e3993 = phi_2566_;
                                let _e3995 = phi_2589_;
                                if (bitcast<i32>(_e3995.member) != 0i) {
                                    if (_e3995.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4002 = local_14[_e3995.member_1];
                                    let _e4003 = (_e3966.member_1 + _e4002);
                                    if (_e4003 < 1f) {
                                        phi_2609_ = _e4003;
                                    } else {
                                        phi_2609_ = 1f;
                                    }
                                    let _e4006 = phi_2609_;
                                    let _e4009 = local_15.member[0u];
                                    let _e4015 = local_15.member[1u];
                                    let _e4025 = (_e4009[0] + ((_e4015[0] - _e4009[0]) * _e4006));
                                    let _e4026 = (_e4009[1] + ((_e4015[1] - _e4009[1]) * _e4006));
                                    let _e4027 = (_e4009[2] + ((_e4015[2] - _e4009[2]) * _e4006));
                                    let _e4030 = local_15.member_1[0u];
                                    let _e4036 = local_15.member_1[1u];
                                    let _e4046 = (_e4030[0] + ((_e4036[0] - _e4030[0]) * _e4006));
                                    let _e4047 = (_e4030[1] + ((_e4036[1] - _e4030[1]) * _e4006));
                                    let _e4048 = (_e4030[2] + ((_e4036[2] - _e4030[2]) * _e4006));
                                    let _e4051 = local_15.member_2[0u];
                                    let _e4057 = local_15.member_2[1u];
                                    let _e4067 = (_e4051[0] + ((_e4057[0] - _e4051[0]) * _e4006));
                                    let _e4068 = (_e4051[1] + ((_e4057[1] - _e4051[1]) * _e4006));
                                    let _e4069 = (_e4051[2] + ((_e4057[2] - _e4051[2]) * _e4006));
                                    let _e4074 = (((_e4046 * _e4046) + (_e4047 * _e4047)) + (_e4048 * _e4048));
                                    let _e4079 = (((_e4046 * _e4067) + (_e4047 * _e4068)) + (_e4048 * _e4069));
                                    let _e4084 = (((_e4067 * _e4067) + (_e4068 * _e4068)) + (_e4069 * _e4069));
                                    let _e4089 = (((_e4025 * _e4046) + (_e4026 * _e4047)) + (_e4027 * _e4048));
                                    let _e4094 = (((_e4025 * _e4067) + (_e4026 * _e4068)) + (_e4027 * _e4069));
                                    let _e4097 = ((_e4074 * _e4084) - (_e4079 * _e4079));
                                    let _e4101 = (((_e4089 * _e4084) - (_e4094 * _e4079)) / _e4097);
                                    let _e4105 = (((_e4094 * _e4074) - (_e4089 * _e4079)) / _e4097);
                                    if (_e4101 >= 0f) {
                                        if (_e4105 >= 0f) {
                                            if (_e4101 <= 1f) {
                                                phi_2757_ = (_e4105 <= 1f);
                                                phi_2758_ = false;
                                            } else {
                                                phi_2757_ = bool();
                                                phi_2758_ = true;
                                            }
                                            let _e4111 = phi_2757_;
                                            let _e4113 = phi_2758_;
                                            phi_2759_ = _e4111;
                                            phi_2760_ = _e4113;
                                        } else {
                                            phi_2759_ = bool();
                                            phi_2760_ = true;
                                        }
                                        let _e4115 = phi_2759_;
                                        let _e4117 = phi_2760_;
                                        phi_2761_ = _e4115;
                                        phi_2762_ = _e4117;
                                    } else {
                                        phi_2761_ = bool();
                                        phi_2762_ = true;
                                    }
                                    let _e4119 = phi_2761_;
                                    let _e4121 = phi_2762_;
                                    if _e4121 {
                                        let _e4122 = (_e4097 > 0f);
                                        if _e4122 {
                                            phi_2792_ = false;
                                        } else {
                                            phi_2792_ = true;
                                        }
                                        let _e4124 = phi_2792_;
                                        phi_2793_ = false;
                                        phi_2794_ = _e4124;
                                        phi_2795_ = _e4122;
                                    } else {
                                        phi_2793_ = true;
                                        phi_2794_ = false;
                                        phi_2795_ = false;
                                    }
                                    let _e4126 = phi_2793_;
                                    let _e4128 = phi_2794_;
                                    let _e4130 = phi_2795_;
                                    if _e4126 {
                                        if (_e4097 > 0f) {
                                            if _e4119 {
                                                phi_2819_ = array<f32, 3>((_e4025 - ((_e4046 * _e4101) + (_e4067 * _e4105))), (_e4026 - ((_e4047 * _e4101) + (_e4068 * _e4105))), (_e4027 - ((_e4048 * _e4101) + (_e4069 * _e4105))));
                                                phi_2820_ = false;
                                            } else {
                                                phi_2819_ = array<f32, 3>();
                                                phi_2820_ = true;
                                            }
                                            let _e4146 = phi_2819_;
                                            let _e4148 = phi_2820_;
                                            phi_2821_ = _e4146;
                                            phi_2822_ = false;
                                            phi_2823_ = _e4148;
                                        } else {
                                            phi_2821_ = array<f32, 3>();
                                            phi_2822_ = true;
                                            phi_2823_ = false;
                                        }
                                        let _e4150 = phi_2821_;
                                        let _e4152 = phi_2822_;
                                        let _e4154 = phi_2823_;
                                        phi_2824_ = _e4150;
                                        phi_2825_ = _e4152;
                                        phi_2826_ = _e4154;
                                    } else {
                                        phi_2824_ = array<f32, 3>();
                                        phi_2825_ = _e4128;
                                        phi_2826_ = _e4130;
                                    }
                                    let _e4156 = phi_2824_;
                                    let _e4158 = phi_2825_;
                                    let _e4160 = phi_2826_;
                                    if _e4158 {
                                        phi_2830_ = true;
                                    } else {
                                        phi_2830_ = _e4160;
                                    }
                                    let _e4162 = phi_2830_;
                                    if _e4162 {
                                        let _e4163 = (_e4025 - _e4046);
                                        let _e4164 = (_e4026 - _e4047);
                                        let _e4165 = (_e4027 - _e4048);
                                        let _e4176 = ((((_e4025 * _e4046) + (_e4026 * _e4047)) + (_e4027 * _e4048)) / (((_e4046 * _e4046) + (_e4047 * _e4047)) + (_e4048 * _e4048)));
                                        if (_e4176 > 0f) {
                                            if (_e4176 < 1f) {
                                                phi_2860_ = _e4176;
                                            } else {
                                                phi_2860_ = 1f;
                                            }
                                            let _e4180 = phi_2860_;
                                            phi_2861_ = _e4180;
                                        } else {
                                            phi_2861_ = 0f;
                                        }
                                        let _e4182 = phi_2861_;
                                        let _e4199 = ((((_e4025 * _e4067) + (_e4026 * _e4068)) + (_e4027 * _e4069)) / (((_e4067 * _e4067) + (_e4068 * _e4068)) + (_e4069 * _e4069)));
                                        if (_e4199 > 0f) {
                                            if (_e4199 < 1f) {
                                                phi_2888_ = _e4199;
                                            } else {
                                                phi_2888_ = 1f;
                                            }
                                            let _e4203 = phi_2888_;
                                            phi_2889_ = _e4203;
                                        } else {
                                            phi_2889_ = 0f;
                                        }
                                        let _e4205 = phi_2889_;
                                        let _e4222 = ((((_e4163 * _e4067) + (_e4164 * _e4068)) + (_e4165 * _e4069)) / (((_e4067 * _e4067) + (_e4068 * _e4068)) + (_e4069 * _e4069)));
                                        if (_e4222 > 0f) {
                                            if (_e4222 < 1f) {
                                                phi_2916_ = _e4222;
                                            } else {
                                                phi_2916_ = 1f;
                                            }
                                            let _e4226 = phi_2916_;
                                            phi_2917_ = _e4226;
                                        } else {
                                            phi_2917_ = 0f;
                                        }
                                        let _e4228 = phi_2917_;
                                        let _e4235 = (_e4025 - _e4067);
                                        let _e4236 = (_e4026 - _e4068);
                                        let _e4237 = (_e4027 - _e4069);
                                        let _e4248 = ((((_e4235 * _e4046) + (_e4236 * _e4047)) + (_e4237 * _e4048)) / (((_e4046 * _e4046) + (_e4047 * _e4047)) + (_e4048 * _e4048)));
                                        if (_e4248 > 0f) {
                                            if (_e4248 < 1f) {
                                                phi_2947_ = _e4248;
                                            } else {
                                                phi_2947_ = 1f;
                                            }
                                            let _e4252 = phi_2947_;
                                            phi_2948_ = _e4252;
                                        } else {
                                            phi_2948_ = 0f;
                                        }
                                        let _e4254 = phi_2948_;
                                        local_10[0u] = array<f32, 3>((_e4025 - (_e4046 * _e4182)), (_e4026 - (_e4047 * _e4182)), (_e4027 - (_e4048 * _e4182)));
                                        local_10[1u] = array<f32, 3>((_e4025 - (_e4067 * _e4205)), (_e4026 - (_e4068 * _e4205)), (_e4027 - (_e4069 * _e4205)));
                                        local_10[2u] = array<f32, 3>((_e4163 - (_e4067 * _e4228)), (_e4164 - (_e4068 * _e4228)), (_e4165 - (_e4069 * _e4228)));
                                        local_10[3u] = array<f32, 3>((_e4235 - (_e4046 * _e4254)), (_e4236 - (_e4047 * _e4254)), (_e4237 - (_e4048 * _e4254)));
                                        let _e4270 = local_10[0u];
                                        phi_3091_ = type_28(1u, 4u);
                                        phi_3094_ = array<f32, 3>(_e4270[0], _e4270[1], _e4270[2]);
                                        loop {
                                            let _e4276 = phi_3091_;
                                            let _e4278 = phi_3094_;
                                            local_76 = _e4278;
                                            if (_e4276.member < _e4276.member_1) {
                                                phi_3092_ = type_28((_e4276.member + 1u), _e4276.member_1);
                                                phi_3117_ = type_28(1u, _e4276.member);
                                            } else {
                                                phi_3092_ = _e4276;
                                                phi_3117_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4292 = phi_3092_;
                                            let _e4294 = phi_3117_;
                                            let _e4298 = (bitcast<i32>(_e4294.member) != 0i);
                                            if _e4298 {
                                                if (_e4294.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4301 = local_10[_e4294.member_1];
                                                if (_e4294.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4307 = local_10[_e4294.member_1];
                                                if ((((_e4301[0] * _e4307[0]) + (_e4301[1] * _e4307[1])) + (_e4301[2] * _e4307[2])) < (((_e4278[0] * _e4278[0]) + (_e4278[1] * _e4278[1])) + (_e4278[2] * _e4278[2]))) {
                                                    if (_e4294.member_1 < 4u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e4330 = local_10[_e4294.member_1];
                                                    phi_3184_ = array<f32, 3>(_e4330[0], _e4330[1], _e4330[2]);
                                                } else {
                                                    phi_3184_ = _e4278;
                                                }
                                                let _e4336 = phi_3184_;
                                                phi_3095_ = _e4336;
                                            } else {
                                                phi_3095_ = array<f32, 3>();
                                            }
                                            let _e4338 = phi_3095_;
                                            continue;
                                            continuing {
                                                phi_3091_ = _e4292;
                                                phi_3094_ = _e4338;
                                                break if !(_e4298);
                                            }
                                        }
                                        let _e5560 = local_76;
                                        phi_3185_ = _e5560;
                                    } else {
                                        phi_3185_ = _e4156;
                                    }
                                    let _e4341 = phi_3185_;
                                    let _e4352 = (((_e4341[0] * _e4341[0]) + (_e4341[1] * _e4341[1])) + (_e4341[2] * _e4341[2]));
                                    if (_e4352 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4352 > 0f) {
                                            phi_3210_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3210_ = 0f;
                                        }
                                        let _e4411 = phi_3210_;
                                        phi_3274_ = _e4411;
                                    } else {
                                        phi_3217_ = type_26(0i, 5i);
                                        phi_3220_ = bitcast<f32>(((bitcast<u32>(_e4352) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4360 = phi_3217_;
                                            let _e4362 = phi_3220_;
                                            local_42 = _e4362;
                                            if (_e4360.member < _e4360.member_1) {
                                                let _e4370 = (_e4360.member + 1i);
                                                if ((false == (_e4370 > _e4360.member)) != false) {
                                                    phi_3241_ = true;
                                                } else {
                                                    phi_3241_ = false;
                                                }
                                                let _e4375 = phi_3241_;
                                                if _e4375 {
                                                    phi_3247_ = type_27(0u, type_27().member_1);
                                                } else {
                                                    phi_3247_ = type_27(1u, _e4370);
                                                }
                                                let _e4381 = phi_3247_;
                                                if (bitcast<i32>(_e4381.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3218_ = type_26(_e4381.member_1, _e4360.member_1);
                                                phi_3261_ = type_27(1u, _e4360.member);
                                            } else {
                                                phi_3218_ = _e4360;
                                                phi_3261_ = type_27(0u, type_27().member_1);
                                            }
                                            let _e4391 = phi_3218_;
                                            let _e4393 = phi_3261_;
                                            let _e4396 = (bitcast<i32>(_e4393.member) != 0i);
                                            if _e4396 {
                                                phi_3221_ = (0.5f * (_e4362 + (_e4352 / _e4362)));
                                            } else {
                                                phi_3221_ = f32();
                                            }
                                            let _e4401 = phi_3221_;
                                            continue;
                                            continuing {
                                                phi_3217_ = _e4391;
                                                phi_3220_ = _e4401;
                                                break if !(_e4396);
                                            }
                                        }
                                        let _e4406 = local_42;
                                        phi_3274_ = (_e4406 * (1f + (4f * 0.000000059604645f)));
                                    }
                                    let _e4413 = phi_3274_;
                                    let _e4419 = local_15.member[0u];
                                    if (_e4419[0] < 0f) {
                                        phi_3290_ = -(_e4419[0]);
                                    } else {
                                        phi_3290_ = _e4419[0];
                                    }
                                    let _e4426 = phi_3290_;
                                    if (_e4419[1] < 0f) {
                                        phi_3297_ = -(_e4419[1]);
                                    } else {
                                        phi_3297_ = _e4419[1];
                                    }
                                    let _e4430 = phi_3297_;
                                    if (_e4426 > _e4430) {
                                        phi_3302_ = _e4426;
                                    } else {
                                        phi_3302_ = _e4430;
                                    }
                                    let _e4433 = phi_3302_;
                                    if (_e4419[2] < 0f) {
                                        phi_3309_ = -(_e4419[2]);
                                    } else {
                                        phi_3309_ = _e4419[2];
                                    }
                                    let _e4437 = phi_3309_;
                                    if (_e4433 > _e4437) {
                                        phi_3314_ = _e4433;
                                    } else {
                                        phi_3314_ = _e4437;
                                    }
                                    let _e4440 = phi_3314_;
                                    let _e4443 = local_15.member[1u];
                                    if (_e4443[0] < 0f) {
                                        phi_3327_ = -(_e4443[0]);
                                    } else {
                                        phi_3327_ = _e4443[0];
                                    }
                                    let _e4450 = phi_3327_;
                                    if (_e4443[1] < 0f) {
                                        phi_3334_ = -(_e4443[1]);
                                    } else {
                                        phi_3334_ = _e4443[1];
                                    }
                                    let _e4454 = phi_3334_;
                                    if (_e4450 > _e4454) {
                                        phi_3339_ = _e4450;
                                    } else {
                                        phi_3339_ = _e4454;
                                    }
                                    let _e4457 = phi_3339_;
                                    if (_e4443[2] < 0f) {
                                        phi_3346_ = -(_e4443[2]);
                                    } else {
                                        phi_3346_ = _e4443[2];
                                    }
                                    let _e4461 = phi_3346_;
                                    if (_e4457 > _e4461) {
                                        phi_3351_ = _e4457;
                                    } else {
                                        phi_3351_ = _e4461;
                                    }
                                    let _e4464 = phi_3351_;
                                    if (_e4440 > _e4464) {
                                        phi_3356_ = _e4440;
                                    } else {
                                        phi_3356_ = _e4464;
                                    }
                                    let _e4467 = phi_3356_;
                                    let _e4469 = local_15.member_3;
                                    let _e4473 = local_15.member_1[0u];
                                    if (_e4473[0] < 0f) {
                                        phi_3373_ = -(_e4473[0]);
                                    } else {
                                        phi_3373_ = _e4473[0];
                                    }
                                    let _e4480 = phi_3373_;
                                    if (_e4473[1] < 0f) {
                                        phi_3380_ = -(_e4473[1]);
                                    } else {
                                        phi_3380_ = _e4473[1];
                                    }
                                    let _e4484 = phi_3380_;
                                    if (_e4480 > _e4484) {
                                        phi_3385_ = _e4480;
                                    } else {
                                        phi_3385_ = _e4484;
                                    }
                                    let _e4487 = phi_3385_;
                                    if (_e4473[2] < 0f) {
                                        phi_3392_ = -(_e4473[2]);
                                    } else {
                                        phi_3392_ = _e4473[2];
                                    }
                                    let _e4491 = phi_3392_;
                                    if (_e4487 > _e4491) {
                                        phi_3397_ = _e4487;
                                    } else {
                                        phi_3397_ = _e4491;
                                    }
                                    let _e4494 = phi_3397_;
                                    let _e4497 = local_15.member_1[1u];
                                    if (_e4497[0] < 0f) {
                                        phi_3411_ = -(_e4497[0]);
                                    } else {
                                        phi_3411_ = _e4497[0];
                                    }
                                    let _e4504 = phi_3411_;
                                    if (_e4497[1] < 0f) {
                                        phi_3418_ = -(_e4497[1]);
                                    } else {
                                        phi_3418_ = _e4497[1];
                                    }
                                    let _e4508 = phi_3418_;
                                    if (_e4504 > _e4508) {
                                        phi_3423_ = _e4504;
                                    } else {
                                        phi_3423_ = _e4508;
                                    }
                                    let _e4511 = phi_3423_;
                                    if (_e4497[2] < 0f) {
                                        phi_3430_ = -(_e4497[2]);
                                    } else {
                                        phi_3430_ = _e4497[2];
                                    }
                                    let _e4515 = phi_3430_;
                                    if (_e4511 > _e4515) {
                                        phi_3435_ = _e4511;
                                    } else {
                                        phi_3435_ = _e4515;
                                    }
                                    let _e4518 = phi_3435_;
                                    if (_e4494 > _e4518) {
                                        phi_3440_ = _e4494;
                                    } else {
                                        phi_3440_ = _e4518;
                                    }
                                    let _e4521 = phi_3440_;
                                    let _e4523 = local_15.member_3;
                                    let _e4527 = local_15.member_2[0u];
                                    if (_e4527[0] < 0f) {
                                        phi_3457_ = -(_e4527[0]);
                                    } else {
                                        phi_3457_ = _e4527[0];
                                    }
                                    let _e4534 = phi_3457_;
                                    if (_e4527[1] < 0f) {
                                        phi_3464_ = -(_e4527[1]);
                                    } else {
                                        phi_3464_ = _e4527[1];
                                    }
                                    let _e4538 = phi_3464_;
                                    if (_e4534 > _e4538) {
                                        phi_3469_ = _e4534;
                                    } else {
                                        phi_3469_ = _e4538;
                                    }
                                    let _e4541 = phi_3469_;
                                    if (_e4527[2] < 0f) {
                                        phi_3476_ = -(_e4527[2]);
                                    } else {
                                        phi_3476_ = _e4527[2];
                                    }
                                    let _e4545 = phi_3476_;
                                    if (_e4541 > _e4545) {
                                        phi_3481_ = _e4541;
                                    } else {
                                        phi_3481_ = _e4545;
                                    }
                                    let _e4548 = phi_3481_;
                                    let _e4551 = local_15.member_2[1u];
                                    if (_e4551[0] < 0f) {
                                        phi_3495_ = -(_e4551[0]);
                                    } else {
                                        phi_3495_ = _e4551[0];
                                    }
                                    let _e4558 = phi_3495_;
                                    if (_e4551[1] < 0f) {
                                        phi_3502_ = -(_e4551[1]);
                                    } else {
                                        phi_3502_ = _e4551[1];
                                    }
                                    let _e4562 = phi_3502_;
                                    if (_e4558 > _e4562) {
                                        phi_3507_ = _e4558;
                                    } else {
                                        phi_3507_ = _e4562;
                                    }
                                    let _e4565 = phi_3507_;
                                    if (_e4551[2] < 0f) {
                                        phi_3514_ = -(_e4551[2]);
                                    } else {
                                        phi_3514_ = _e4551[2];
                                    }
                                    let _e4569 = phi_3514_;
                                    if (_e4565 > _e4569) {
                                        phi_3519_ = _e4565;
                                    } else {
                                        phi_3519_ = _e4569;
                                    }
                                    let _e4572 = phi_3519_;
                                    if (_e4548 > _e4572) {
                                        phi_3524_ = _e4548;
                                    } else {
                                        phi_3524_ = _e4572;
                                    }
                                    let _e4575 = phi_3524_;
                                    let _e4577 = local_15.member_3;
                                    let _e4584 = local_15.member_3;
                                    let _e4591 = (((_e4413 * (1f + (0.000000059604645f * 8f))) + (((((((_e4467 + _e4469) + (_e4521 + _e4523)) + (_e4575 + _e4577)) * (0.000000059604645f * 16f)) + (_e4584 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e278);
                                    if _e4591 {
                                        phi_3544_ = false;
                                    } else {
                                        phi_3544_ = true;
                                    }
                                    let _e4593 = phi_3544_;
                                    phi_3545_ = _e4593;
                                    phi_3546_ = _e4591;
                                } else {
                                    phi_3545_ = false;
                                    phi_3546_ = false;
                                }
                                let _e4595 = phi_3545_;
                                let _e4597 = phi_3546_;
                                local_43 = _e4597;
                                continue;
                                continuing {
                                    phi_2565_ = _e3993;
                                    break if !(_e4595);
                                }
                            }
                            let _e4600 = local_43;
                            if _e4600 {
                                phi_3551_ = type_55(1u, _e3966.member_1);
                                phi_3552_ = false;
                            } else {
                                phi_3551_ = type_55();
                                phi_3552_ = true;
                            }
                            let _e4603 = phi_3551_;
                            let _e4605 = phi_3552_;
                            if _e4605 {
                                phi_3557_ = type_55(2u, _e3966.member_1);
                                phi_3558_ = false;
                            } else {
                                phi_3557_ = type_55();
                                phi_3558_ = true;
                            }
                            let _e4608 = phi_3557_;
                            let _e4610 = phi_3558_;
                            phi_3560_ = _e4608;
                            phi_3561_ = _e4603;
                            phi_3562_ = _e4610;
                        } else {
                            phi_3560_ = type_55();
                            phi_3561_ = type_55(0u, type_55().member_1);
                            phi_3562_ = true;
                        }
                        let _e4612 = phi_3560_;
                        let _e4614 = phi_3561_;
                        let _e4616 = phi_3562_;
                        if _e4616 {
                            phi_3566_ = _e4614;
                        } else {
                            phi_3566_ = _e4612;
                        }
                        let _e4618 = phi_3566_;
                        phi_6813_ = _e4618;
                    } else {
                        if (_e376 < 0f) {
                            phi_3576_ = -(_e376);
                        } else {
                            phi_3576_ = _e376;
                        }
                        let _e719 = phi_3576_;
                        if (_e399 < 0f) {
                            phi_3582_ = -(_e399);
                        } else {
                            phi_3582_ = _e399;
                        }
                        let _e723 = phi_3582_;
                        if (_e719 > _e723) {
                            phi_3587_ = _e719;
                        } else {
                            phi_3587_ = _e723;
                        }
                        let _e726 = phi_3587_;
                        if (_e422 < 0f) {
                            phi_3593_ = -(_e422);
                        } else {
                            phi_3593_ = _e422;
                        }
                        let _e730 = phi_3593_;
                        if (_e433 < 0f) {
                            phi_3599_ = -(_e433);
                        } else {
                            phi_3599_ = _e433;
                        }
                        let _e734 = phi_3599_;
                        if (_e730 > _e734) {
                            phi_3604_ = _e730;
                        } else {
                            phi_3604_ = _e734;
                        }
                        let _e737 = phi_3604_;
                        if (_e726 > _e737) {
                            phi_3609_ = _e726;
                        } else {
                            phi_3609_ = _e737;
                        }
                        let _e740 = phi_3609_;
                        let _e743 = ((_e683 * 0.34f) + (_e740 * (0.000000059604645f * 256f)));
                        let _e745 = (_e399 - (3f * _e376));
                        let _e746 = (_e422 - _e399);
                        let _e748 = ((3f * _e433) - _e422);
                        local_7[0u] = 0f;
                        local_7[1u] = 1f;
                        local_7[2u] = 1f;
                        local_7[3u] = 1f;
                        let _e755 = ((_e746 * _e746) - (_e745 * _e748));
                        if (_e755 > 0f) {
                            if (_e755 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e755 > 0f) {
                                    phi_3642_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_3642_ = 0f;
                                }
                                let _e815 = phi_3642_;
                                phi_3706_ = _e815;
                            } else {
                                phi_3649_ = type_26(0i, 5i);
                                phi_3652_ = bitcast<f32>(((bitcast<u32>(_e755) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e764 = phi_3649_;
                                    let _e766 = phi_3652_;
                                    local_16 = _e766;
                                    if (_e764.member < _e764.member_1) {
                                        let _e774 = (_e764.member + 1i);
                                        if ((false == (_e774 > _e764.member)) != false) {
                                            phi_3673_ = true;
                                        } else {
                                            phi_3673_ = false;
                                        }
                                        let _e779 = phi_3673_;
                                        if _e779 {
                                            phi_3679_ = type_27(0u, type_27().member_1);
                                        } else {
                                            phi_3679_ = type_27(1u, _e774);
                                        }
                                        let _e785 = phi_3679_;
                                        if (bitcast<i32>(_e785.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_3650_ = type_26(_e785.member_1, _e764.member_1);
                                        phi_3693_ = type_27(1u, _e764.member);
                                    } else {
                                        phi_3650_ = _e764;
                                        phi_3693_ = type_27(0u, type_27().member_1);
                                    }
                                    let _e795 = phi_3650_;
                                    let _e797 = phi_3693_;
                                    let _e800 = (bitcast<i32>(_e797.member) != 0i);
                                    if _e800 {
                                        phi_3653_ = (0.5f * (_e766 + (_e755 / _e766)));
                                    } else {
                                        phi_3653_ = f32();
                                    }
                                    let _e805 = phi_3653_;
                                    continue;
                                    continuing {
                                        phi_3649_ = _e795;
                                        phi_3652_ = _e805;
                                        break if !(_e800);
                                    }
                                }
                                let _e810 = local_16;
                                phi_3706_ = (_e810 * (1f + (4f * 0.000000059604645f)));
                            }
                            let _e817 = phi_3706_;
                            if (_e746 < 0f) {
                                phi_3712_ = -(_e817);
                            } else {
                                phi_3712_ = _e817;
                            }
                            let _e821 = phi_3712_;
                            let _e823 = -((_e746 + _e821));
                            local_8[0u] = (_e823 / (_e823 + _e748));
                            local_8[1u] = (_e745 / (_e745 + _e823));
                            let _e832 = local_8[1u];
                            let _e833 = local_8[0u];
                            if (_e832 < _e833) {
                                let _e836 = local_8[1u];
                                let _e838 = local_8[0u];
                                local_8[0u] = _e836;
                                local_8[1u] = _e838;
                            }
                            phi_3737_ = type_28(0u, 2u);
                            phi_3740_ = 1u;
                            loop {
                                let _e842 = phi_3737_;
                                let _e844 = phi_3740_;
                                local_44 = _e844;
                                if (_e842.member < _e842.member_1) {
                                    phi_3738_ = type_28((_e842.member + 1u), _e842.member_1);
                                    phi_3763_ = type_28(1u, _e842.member);
                                } else {
                                    phi_3738_ = _e842;
                                    phi_3763_ = type_28(0u, type_28().member_1);
                                }
                                let _e858 = phi_3738_;
                                let _e860 = phi_3763_;
                                let _e864 = (bitcast<i32>(_e860.member) != 0i);
                                if _e864 {
                                    if (_e860.member_1 < 2u) {
                                    } else {
                                        return;
                                    }
                                    let _e867 = local_8[_e860.member_1];
                                    if (_e867 > 0f) {
                                        if (_e860.member_1 < 2u) {
                                        } else {
                                            return;
                                        }
                                        let _e871 = local_8[_e860.member_1];
                                        if (_e871 < 1f) {
                                            if (_e860.member_1 < 2u) {
                                            } else {
                                                return;
                                            }
                                            let _e875 = local_8[_e860.member_1];
                                            if (_e844 < 4u) {
                                            } else {
                                                return;
                                            }
                                            local_7[_e844] = _e875;
                                            phi_3807_ = (_e844 + 1u);
                                        } else {
                                            phi_3807_ = _e844;
                                        }
                                        let _e880 = phi_3807_;
                                        phi_3808_ = _e880;
                                    } else {
                                        phi_3808_ = _e844;
                                    }
                                    let _e882 = phi_3808_;
                                    phi_3741_ = _e882;
                                } else {
                                    phi_3741_ = u32();
                                }
                                let _e884 = phi_3741_;
                                continue;
                                continuing {
                                    phi_3737_ = _e858;
                                    phi_3740_ = _e884;
                                    break if !(_e864);
                                }
                            }
                            let _e4877 = local_44;
                            phi_3809_ = _e4877;
                        } else {
                            phi_3809_ = 1u;
                        }
                        let _e887 = phi_3809_;
                        if (_e887 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e887] = 1f;
                        let _e890 = local_7;
                        local_9 = _e890;
                        phi_3829_ = type_28(0u, _e887);
                        loop {
                            let _e893 = phi_3829_;
                            if (_e893.member < _e893.member_1) {
                                phi_3830_ = type_28((_e893.member + 1u), _e893.member_1);
                                phi_3853_ = type_28(1u, _e893.member);
                            } else {
                                phi_3830_ = _e893;
                                phi_3853_ = type_28(0u, type_28().member_1);
                            }
                            let _e907 = phi_3830_;
                            let _e909 = phi_3853_;
                            if (bitcast<i32>(_e909.member) != 0i) {
                                if (_e909.member_1 < 4u) {
                                } else {
                                    return;
                                }
                                let _e916 = local_9[_e909.member_1];
                                let _e917 = (_e909.member_1 + 1u);
                                if (_e917 < 4u) {
                                } else {
                                    return;
                                }
                                let _e920 = local_9[_e917];
                                let _e921 = (1f - _e916);
                                let _e932 = ((((_e376 * _e921) + (_e399 * _e916)) * (_e921 * _e921)) + (((_e422 * _e921) + (_e433 * _e916)) * (_e916 * _e916)));
                                let _e933 = (1f - _e920);
                                let _e944 = ((((_e376 * _e933) + (_e399 * _e920)) * (_e933 * _e933)) + (((_e422 * _e933) + (_e433 * _e920)) * (_e920 * _e920)));
                                if (_e932 < 0f) {
                                    phi_3905_ = -(_e932);
                                } else {
                                    phi_3905_ = _e932;
                                }
                                let _e948 = phi_3905_;
                                let _e949 = (_e948 > _e743);
                                if (_e944 < 0f) {
                                    phi_3912_ = -(_e944);
                                } else {
                                    phi_3912_ = _e944;
                                }
                                let _e953 = phi_3912_;
                                let _e954 = (_e953 > _e743);
                                if _e949 {
                                    if _e954 {
                                        let _e957 = ((_e932 > 0f) != (_e944 > 0f));
                                        if _e949 {
                                            if _e954 {
                                                if _e957 {
                                                    phi_3932_ = false;
                                                } else {
                                                    phi_3932_ = true;
                                                }
                                                let _e959 = phi_3932_;
                                                phi_3933_ = _e959;
                                            } else {
                                                phi_3933_ = false;
                                            }
                                            let _e961 = phi_3933_;
                                            phi_3934_ = _e961;
                                        } else {
                                            phi_3934_ = false;
                                        }
                                        let _e963 = phi_3934_;
                                        phi_3935_ = _e957;
                                        phi_3936_ = _e957;
                                        phi_3937_ = false;
                                        phi_3938_ = _e963;
                                    } else {
                                        phi_3935_ = bool();
                                        phi_3936_ = bool();
                                        phi_3937_ = true;
                                        phi_3938_ = false;
                                    }
                                    let _e965 = phi_3935_;
                                    let _e967 = phi_3936_;
                                    let _e969 = phi_3937_;
                                    let _e971 = phi_3938_;
                                    phi_3939_ = _e965;
                                    phi_3940_ = _e967;
                                    phi_3941_ = _e969;
                                    phi_3942_ = _e971;
                                } else {
                                    phi_3939_ = bool();
                                    phi_3940_ = bool();
                                    phi_3941_ = true;
                                    phi_3942_ = false;
                                }
                                let _e973 = phi_3939_;
                                let _e975 = phi_3940_;
                                let _e977 = phi_3941_;
                                let _e979 = phi_3942_;
                                if _e977 {
                                    if _e949 {
                                        phi_3952_ = _e954;
                                    } else {
                                        phi_3952_ = false;
                                    }
                                    let _e981 = phi_3952_;
                                    phi_3953_ = false;
                                    phi_3954_ = false;
                                    phi_3955_ = _e981;
                                } else {
                                    phi_3953_ = _e975;
                                    phi_3954_ = _e973;
                                    phi_3955_ = _e979;
                                }
                                let _e983 = phi_3953_;
                                let _e985 = phi_3954_;
                                let _e987 = phi_3955_;
                                if _e987 {
                                    phi_3960_ = type_56(1f, 0f, _e983);
                                    phi_3961_ = false;
                                } else {
                                    phi_3960_ = type_56();
                                    phi_3961_ = true;
                                }
                                let _e990 = phi_3960_;
                                let _e992 = phi_3961_;
                                if _e992 {
                                    if _e949 {
                                        if (_e932 < 0f) {
                                            phi_3972_ = -1f;
                                        } else {
                                            phi_3972_ = 1f;
                                        }
                                        let _e995 = phi_3972_;
                                        let _e998 = (_e422 - _e399);
                                        phi_3982_ = type_28(0u, 64u);
                                        phi_3985_ = _e920;
                                        phi_3987_ = _e916;
                                        phi_3989_ = (0.5f * (_e916 + _e920));
                                        loop {
                                            let _e1004 = phi_3982_;
                                            let _e1006 = phi_3985_;
                                            let _e1008 = phi_3987_;
                                            let _e1010 = phi_3989_;
                                            local_46 = _e1008;
                                            if (_e1004.member < _e1004.member_1) {
                                                phi_3983_ = type_28((_e1004.member + 1u), _e1004.member_1);
                                                phi_4012_ = type_28(1u, _e1004.member);
                                            } else {
                                                phi_3983_ = _e1004;
                                                phi_4012_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1024 = phi_3983_;
                                            let _e1026 = phi_4012_;
                                            if (bitcast<i32>(_e1026.member) != 0i) {
                                                let _e1030 = (1f - _e1010);
                                                let _e1043 = ((_e995 * ((((_e376 * _e1030) + (_e399 * _e1010)) * (_e1030 * _e1030)) + (((_e422 * _e1030) + (_e433 * _e1010)) * (_e1010 * _e1010)))) - _e743);
                                                if (_e1043 > 0f) {
                                                    phi_4037_ = _e1006;
                                                    phi_4038_ = _e1010;
                                                } else {
                                                    phi_4037_ = _e1010;
                                                    phi_4038_ = _e1008;
                                                }
                                                let _e1046 = phi_4037_;
                                                let _e1048 = phi_4038_;
                                                let _e1050 = ((_e1046 - _e1048) > 0.00000000000022737368f);
                                                if _e1050 {
                                                    let _e1051 = (1f - _e1010);
                                                    let _e1063 = (-(_e1043) / (_e995 * (((((_e399 - (3f * _e376)) * _e1051) + (_e998 * _e1010)) * _e1051) + (((_e998 * _e1051) + (((3f * _e433) - _e422) * _e1010)) * _e1010))));
                                                    if (_e1043 > 0f) {
                                                        phi_4064_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_4064_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1069 = phi_4064_;
                                                    let _e1071 = ((_e1010 + _e1063) + _e1069);
                                                    if (_e1071 > _e1048) {
                                                        if (_e1071 < _e1046) {
                                                            if (_e1063 < 0f) {
                                                                phi_4080_ = -(_e1063);
                                                            } else {
                                                                phi_4080_ = _e1063;
                                                            }
                                                            let _e1077 = phi_4080_;
                                                            if (_e1077 < (0.5f * (_e1046 - _e1048))) {
                                                                phi_4087_ = false;
                                                            } else {
                                                                phi_4087_ = true;
                                                            }
                                                            let _e1082 = phi_4087_;
                                                            phi_4088_ = _e1082;
                                                        } else {
                                                            phi_4088_ = true;
                                                        }
                                                        let _e1084 = phi_4088_;
                                                        phi_4089_ = _e1084;
                                                    } else {
                                                        phi_4089_ = true;
                                                    }
                                                    let _e1086 = phi_4089_;
                                                    if _e1086 {
                                                        phi_4095_ = (0.5f * (_e1048 + _e1046));
                                                    } else {
                                                        phi_4095_ = _e1071;
                                                    }
                                                    let _e1090 = phi_4095_;
                                                    phi_4096_ = _e1090;
                                                    phi_4097_ = false;
                                                } else {
                                                    phi_4096_ = f32();
                                                    phi_4097_ = true;
                                                }
                                                let _e1092 = phi_4096_;
                                                let _e1094 = phi_4097_;
                                                phi_3986_ = _e1046;
                                                phi_3988_ = _e1048;
                                                phi_3990_ = _e1092;
                                                phi_4098_ = _e1048;
                                                phi_4099_ = _e1050;
                                                phi_4100_ = _e1094;
                                            } else {
                                                phi_3986_ = f32();
                                                phi_3988_ = f32();
                                                phi_3990_ = f32();
                                                phi_4098_ = f32();
                                                phi_4099_ = false;
                                                phi_4100_ = false;
                                            }
                                            let _e1096 = phi_3986_;
                                            let _e1098 = phi_3988_;
                                            let _e1100 = phi_3990_;
                                            let _e1102 = phi_4098_;
                                            let _e1104 = phi_4099_;
                                            let _e1106 = phi_4100_;
                                            local_17 = _e1106;
                                            local_45 = _e1102;
                                            continue;
                                            continuing {
                                                phi_3982_ = _e1024;
                                                phi_3985_ = _e1096;
                                                phi_3987_ = _e1098;
                                                phi_3989_ = _e1100;
                                                break if !(_e1104);
                                            }
                                        }
                                        let _e1109 = local_17;
                                        if _e1109 {
                                            let _e4926 = local_45;
                                            phi_4104_ = _e4926;
                                        } else {
                                            let _e4928 = local_46;
                                            phi_4104_ = _e4928;
                                        }
                                        let _e1111 = phi_4104_;
                                        phi_4105_ = _e1111;
                                    } else {
                                        phi_4105_ = _e916;
                                    }
                                    let _e1113 = phi_4105_;
                                    if _e954 {
                                        phi_4112_ = type_28(0u, 64u);
                                        phi_4115_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1116 = phi_4112_;
                                            let _e1118 = phi_4115_;
                                            if (_e1116.member < _e1116.member_1) {
                                                phi_4113_ = type_28((_e1116.member + 1u), _e1116.member_1);
                                                phi_4138_ = type_28(1u, _e1116.member);
                                            } else {
                                                phi_4113_ = _e1116;
                                                phi_4138_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1132 = phi_4113_;
                                            let _e1134 = phi_4138_;
                                            if (bitcast<i32>(_e1134.member) != 0i) {
                                                let _e1138 = (_e1113 + _e1118);
                                                if (_e1138 < _e920) {
                                                    let _e1140 = (1f - _e1138);
                                                    let _e1151 = ((((_e376 * _e1140) + (_e399 * _e1138)) * (_e1140 * _e1140)) + (((_e422 * _e1140) + (_e433 * _e1138)) * (_e1138 * _e1138)));
                                                    let _e1152 = (1f - _e1113);
                                                    let _e1163 = ((((_e376 * _e1152) + (_e399 * _e1113)) * (_e1152 * _e1152)) + (((_e422 * _e1152) + (_e433 * _e1113)) * (_e1113 * _e1113)));
                                                    if (_e1151 < 0f) {
                                                        phi_4179_ = -(_e1151);
                                                    } else {
                                                        phi_4179_ = _e1151;
                                                    }
                                                    let _e1167 = phi_4179_;
                                                    if (_e1167 > _e743) {
                                                        if (_e1163 < 0f) {
                                                            phi_4189_ = -(_e1163);
                                                        } else {
                                                            phi_4189_ = _e1163;
                                                        }
                                                        let _e1172 = phi_4189_;
                                                        if (_e1172 > _e743) {
                                                            phi_4197_ = ((_e1151 > 0f) == (_e1163 > 0f));
                                                        } else {
                                                            phi_4197_ = false;
                                                        }
                                                        let _e1178 = phi_4197_;
                                                        phi_4199_ = !(_e1178);
                                                    } else {
                                                        phi_4199_ = false;
                                                    }
                                                    let _e1181 = phi_4199_;
                                                    if _e1181 {
                                                        phi_4204_ = f32();
                                                        phi_4205_ = false;
                                                    } else {
                                                        phi_4204_ = (_e1118 + _e1118);
                                                        phi_4205_ = true;
                                                    }
                                                    let _e1184 = phi_4204_;
                                                    let _e1186 = phi_4205_;
                                                    phi_4206_ = _e1184;
                                                    phi_4207_ = _e1186;
                                                    phi_4208_ = _e1181;
                                                    phi_4209_ = false;
                                                } else {
                                                    phi_4206_ = f32();
                                                    phi_4207_ = false;
                                                    phi_4208_ = false;
                                                    phi_4209_ = true;
                                                }
                                                let _e1188 = phi_4206_;
                                                let _e1190 = phi_4207_;
                                                let _e1192 = phi_4208_;
                                                let _e1194 = phi_4209_;
                                                phi_4210_ = _e1138;
                                                phi_4116_ = _e1188;
                                                phi_4211_ = _e1190;
                                                phi_4212_ = _e1192;
                                                phi_4213_ = _e1194;
                                                phi_4214_ = false;
                                            } else {
                                                phi_4210_ = f32();
                                                phi_4116_ = f32();
                                                phi_4211_ = false;
                                                phi_4212_ = false;
                                                phi_4213_ = false;
                                                phi_4214_ = true;
                                            }
                                            let _e1196 = phi_4210_;
                                            let _e1198 = phi_4116_;
                                            let _e1200 = phi_4211_;
                                            let _e1202 = phi_4212_;
                                            let _e1204 = phi_4213_;
                                            let _e1206 = phi_4214_;
                                            local_18 = _e1202;
                                            local_47 = _e1204;
                                            local_48 = _e1206;
                                            local_49 = _e1196;
                                            continue;
                                            continuing {
                                                phi_4112_ = _e1132;
                                                phi_4115_ = _e1198;
                                                break if !(_e1200);
                                            }
                                        }
                                        let _e1209 = local_18;
                                        if _e1209 {
                                            phi_4218_ = false;
                                            phi_4219_ = false;
                                        } else {
                                            let _e4953 = local_47;
                                            phi_4218_ = _e4953;
                                            let _e4956 = local_48;
                                            phi_4219_ = _e4956;
                                        }
                                        let _e1211 = phi_4218_;
                                        let _e1213 = phi_4219_;
                                        if _e1211 {
                                            phi_4223_ = true;
                                        } else {
                                            phi_4223_ = _e1213;
                                        }
                                        let _e1215 = phi_4223_;
                                        if _e1215 {
                                            phi_4227_ = _e920;
                                        } else {
                                            let _e4960 = local_49;
                                            phi_4227_ = _e4960;
                                        }
                                        let _e1217 = phi_4227_;
                                        phi_4228_ = _e1217;
                                    } else {
                                        phi_4228_ = _e920;
                                    }
                                    let _e1219 = phi_4228_;
                                    phi_4230_ = type_56(_e1113, _e1219, _e985);
                                } else {
                                    phi_4230_ = _e990;
                                }
                                let _e1222 = phi_4230_;
                                if (_e1222.member > _e1222.member_1) {
                                    phi_6769_ = f32();
                                    phi_6770_ = true;
                                    phi_6771_ = false;
                                    phi_6772_ = false;
                                    phi_6773_ = false;
                                } else {
                                    let _e1229 = ((_e1222.member_1 - _e1222.member) * 0.5f);
                                    let _e1230 = (_e1222.member + _e1229);
                                    let _e1232 = (_e1229 + (0.000000059604645f * 4f));
                                    let _e1234 = local_15.member_3;
                                    let _e1237 = local_15.member[0u];
                                    if (_e1237[0] < 0f) {
                                        phi_4259_ = -(_e1237[0]);
                                    } else {
                                        phi_4259_ = _e1237[0];
                                    }
                                    let _e1244 = phi_4259_;
                                    if (_e1237[1] < 0f) {
                                        phi_4266_ = -(_e1237[1]);
                                    } else {
                                        phi_4266_ = _e1237[1];
                                    }
                                    let _e1248 = phi_4266_;
                                    if (_e1244 > _e1248) {
                                        phi_4271_ = _e1244;
                                    } else {
                                        phi_4271_ = _e1248;
                                    }
                                    let _e1251 = phi_4271_;
                                    if (_e1237[2] < 0f) {
                                        phi_4278_ = -(_e1237[2]);
                                    } else {
                                        phi_4278_ = _e1237[2];
                                    }
                                    let _e1255 = phi_4278_;
                                    if (_e1251 > _e1255) {
                                        phi_4283_ = _e1251;
                                    } else {
                                        phi_4283_ = _e1255;
                                    }
                                    let _e1258 = phi_4283_;
                                    let _e1260 = local_15.member[1u];
                                    if (_e1260[0] < 0f) {
                                        phi_4296_ = -(_e1260[0]);
                                    } else {
                                        phi_4296_ = _e1260[0];
                                    }
                                    let _e1267 = phi_4296_;
                                    if (_e1260[1] < 0f) {
                                        phi_4303_ = -(_e1260[1]);
                                    } else {
                                        phi_4303_ = _e1260[1];
                                    }
                                    let _e1271 = phi_4303_;
                                    if (_e1267 > _e1271) {
                                        phi_4308_ = _e1267;
                                    } else {
                                        phi_4308_ = _e1271;
                                    }
                                    let _e1274 = phi_4308_;
                                    if (_e1260[2] < 0f) {
                                        phi_4315_ = -(_e1260[2]);
                                    } else {
                                        phi_4315_ = _e1260[2];
                                    }
                                    let _e1278 = phi_4315_;
                                    if (_e1274 > _e1278) {
                                        phi_4320_ = _e1274;
                                    } else {
                                        phi_4320_ = _e1278;
                                    }
                                    let _e1281 = phi_4320_;
                                    if (_e1258 > _e1281) {
                                        phi_4325_ = _e1258;
                                    } else {
                                        phi_4325_ = _e1281;
                                    }
                                    let _e1284 = phi_4325_;
                                    let _e1287 = local_15.member[0u];
                                    let _e1292 = local_15.member[1u];
                                    let _e1302 = (_e1287[0] + ((_e1292[0] - _e1287[0]) * _e1230));
                                    let _e1303 = (_e1287[1] + ((_e1292[1] - _e1287[1]) * _e1230));
                                    let _e1304 = (_e1287[2] + ((_e1292[2] - _e1287[2]) * _e1230));
                                    let _e1306 = local_15.member[1u];
                                    let _e1311 = local_15.member[0u];
                                    let _e1315 = (_e1306[0] - _e1311[0]);
                                    let _e1316 = (_e1306[1] - _e1311[1]);
                                    let _e1317 = (_e1306[2] - _e1311[2]);
                                    if (_e1315 < 0f) {
                                        phi_4384_ = -(_e1315);
                                    } else {
                                        phi_4384_ = _e1315;
                                    }
                                    let _e1321 = phi_4384_;
                                    if (_e1316 < 0f) {
                                        phi_4390_ = -(_e1316);
                                    } else {
                                        phi_4390_ = _e1316;
                                    }
                                    let _e1325 = phi_4390_;
                                    if (_e1321 > _e1325) {
                                        phi_4395_ = _e1321;
                                    } else {
                                        phi_4395_ = _e1325;
                                    }
                                    let _e1328 = phi_4395_;
                                    if (_e1317 < 0f) {
                                        phi_4401_ = -(_e1317);
                                    } else {
                                        phi_4401_ = _e1317;
                                    }
                                    let _e1332 = phi_4401_;
                                    if (_e1328 > _e1332) {
                                        phi_4406_ = _e1328;
                                    } else {
                                        phi_4406_ = _e1332;
                                    }
                                    let _e1335 = phi_4406_;
                                    let _e1341 = ((((_e1232 * _e1335) * 1.01f) + ((_e1284 + _e1234) * (0.000000059604645f * 8f))) + _e1234);
                                    if (_e1302 < 0f) {
                                        phi_4418_ = -(_e1302);
                                    } else {
                                        phi_4418_ = _e1302;
                                    }
                                    let _e1345 = phi_4418_;
                                    if (_e1303 < 0f) {
                                        phi_4424_ = -(_e1303);
                                    } else {
                                        phi_4424_ = _e1303;
                                    }
                                    let _e1349 = phi_4424_;
                                    if (_e1345 > _e1349) {
                                        phi_4429_ = _e1345;
                                    } else {
                                        phi_4429_ = _e1349;
                                    }
                                    let _e1352 = phi_4429_;
                                    if (_e1304 < 0f) {
                                        phi_4435_ = -(_e1304);
                                    } else {
                                        phi_4435_ = _e1304;
                                    }
                                    let _e1356 = phi_4435_;
                                    if (_e1352 > _e1356) {
                                        phi_4440_ = _e1352;
                                    } else {
                                        phi_4440_ = _e1356;
                                    }
                                    let _e1359 = phi_4440_;
                                    local_3 = type_40(array<f32, 3>(_e1302, _e1303, _e1304), _e1341, (_e1359 + _e1341));
                                    let _e1365 = local_15.member_3;
                                    let _e1367 = local_15.member_1[0u];
                                    if (_e1367[0] < 0f) {
                                        phi_4466_ = -(_e1367[0]);
                                    } else {
                                        phi_4466_ = _e1367[0];
                                    }
                                    let _e1374 = phi_4466_;
                                    if (_e1367[1] < 0f) {
                                        phi_4473_ = -(_e1367[1]);
                                    } else {
                                        phi_4473_ = _e1367[1];
                                    }
                                    let _e1378 = phi_4473_;
                                    if (_e1374 > _e1378) {
                                        phi_4478_ = _e1374;
                                    } else {
                                        phi_4478_ = _e1378;
                                    }
                                    let _e1381 = phi_4478_;
                                    if (_e1367[2] < 0f) {
                                        phi_4485_ = -(_e1367[2]);
                                    } else {
                                        phi_4485_ = _e1367[2];
                                    }
                                    let _e1385 = phi_4485_;
                                    if (_e1381 > _e1385) {
                                        phi_4490_ = _e1381;
                                    } else {
                                        phi_4490_ = _e1385;
                                    }
                                    let _e1388 = phi_4490_;
                                    let _e1390 = local_15.member_1[1u];
                                    if (_e1390[0] < 0f) {
                                        phi_4503_ = -(_e1390[0]);
                                    } else {
                                        phi_4503_ = _e1390[0];
                                    }
                                    let _e1397 = phi_4503_;
                                    if (_e1390[1] < 0f) {
                                        phi_4510_ = -(_e1390[1]);
                                    } else {
                                        phi_4510_ = _e1390[1];
                                    }
                                    let _e1401 = phi_4510_;
                                    if (_e1397 > _e1401) {
                                        phi_4515_ = _e1397;
                                    } else {
                                        phi_4515_ = _e1401;
                                    }
                                    let _e1404 = phi_4515_;
                                    if (_e1390[2] < 0f) {
                                        phi_4522_ = -(_e1390[2]);
                                    } else {
                                        phi_4522_ = _e1390[2];
                                    }
                                    let _e1408 = phi_4522_;
                                    if (_e1404 > _e1408) {
                                        phi_4527_ = _e1404;
                                    } else {
                                        phi_4527_ = _e1408;
                                    }
                                    let _e1411 = phi_4527_;
                                    if (_e1388 > _e1411) {
                                        phi_4532_ = _e1388;
                                    } else {
                                        phi_4532_ = _e1411;
                                    }
                                    let _e1414 = phi_4532_;
                                    let _e1417 = local_15.member_1[0u];
                                    let _e1422 = local_15.member_1[1u];
                                    let _e1432 = (_e1417[0] + ((_e1422[0] - _e1417[0]) * _e1230));
                                    let _e1433 = (_e1417[1] + ((_e1422[1] - _e1417[1]) * _e1230));
                                    let _e1434 = (_e1417[2] + ((_e1422[2] - _e1417[2]) * _e1230));
                                    let _e1436 = local_15.member_1[1u];
                                    let _e1441 = local_15.member_1[0u];
                                    let _e1445 = (_e1436[0] - _e1441[0]);
                                    let _e1446 = (_e1436[1] - _e1441[1]);
                                    let _e1447 = (_e1436[2] - _e1441[2]);
                                    if (_e1445 < 0f) {
                                        phi_4591_ = -(_e1445);
                                    } else {
                                        phi_4591_ = _e1445;
                                    }
                                    let _e1451 = phi_4591_;
                                    if (_e1446 < 0f) {
                                        phi_4597_ = -(_e1446);
                                    } else {
                                        phi_4597_ = _e1446;
                                    }
                                    let _e1455 = phi_4597_;
                                    if (_e1451 > _e1455) {
                                        phi_4602_ = _e1451;
                                    } else {
                                        phi_4602_ = _e1455;
                                    }
                                    let _e1458 = phi_4602_;
                                    if (_e1447 < 0f) {
                                        phi_4608_ = -(_e1447);
                                    } else {
                                        phi_4608_ = _e1447;
                                    }
                                    let _e1462 = phi_4608_;
                                    if (_e1458 > _e1462) {
                                        phi_4613_ = _e1458;
                                    } else {
                                        phi_4613_ = _e1462;
                                    }
                                    let _e1465 = phi_4613_;
                                    let _e1471 = ((((_e1232 * _e1465) * 1.01f) + ((_e1414 + _e1365) * (0.000000059604645f * 8f))) + _e1365);
                                    if (_e1432 < 0f) {
                                        phi_4625_ = -(_e1432);
                                    } else {
                                        phi_4625_ = _e1432;
                                    }
                                    let _e1475 = phi_4625_;
                                    if (_e1433 < 0f) {
                                        phi_4631_ = -(_e1433);
                                    } else {
                                        phi_4631_ = _e1433;
                                    }
                                    let _e1479 = phi_4631_;
                                    if (_e1475 > _e1479) {
                                        phi_4636_ = _e1475;
                                    } else {
                                        phi_4636_ = _e1479;
                                    }
                                    let _e1482 = phi_4636_;
                                    if (_e1434 < 0f) {
                                        phi_4642_ = -(_e1434);
                                    } else {
                                        phi_4642_ = _e1434;
                                    }
                                    let _e1486 = phi_4642_;
                                    if (_e1482 > _e1486) {
                                        phi_4647_ = _e1482;
                                    } else {
                                        phi_4647_ = _e1486;
                                    }
                                    let _e1489 = phi_4647_;
                                    local_4 = type_40(array<f32, 3>(_e1432, _e1433, _e1434), _e1471, (_e1489 + _e1471));
                                    let _e1495 = local_15.member_3;
                                    let _e1497 = local_15.member_2[0u];
                                    if (_e1497[0] < 0f) {
                                        phi_4673_ = -(_e1497[0]);
                                    } else {
                                        phi_4673_ = _e1497[0];
                                    }
                                    let _e1504 = phi_4673_;
                                    if (_e1497[1] < 0f) {
                                        phi_4680_ = -(_e1497[1]);
                                    } else {
                                        phi_4680_ = _e1497[1];
                                    }
                                    let _e1508 = phi_4680_;
                                    if (_e1504 > _e1508) {
                                        phi_4685_ = _e1504;
                                    } else {
                                        phi_4685_ = _e1508;
                                    }
                                    let _e1511 = phi_4685_;
                                    if (_e1497[2] < 0f) {
                                        phi_4692_ = -(_e1497[2]);
                                    } else {
                                        phi_4692_ = _e1497[2];
                                    }
                                    let _e1515 = phi_4692_;
                                    if (_e1511 > _e1515) {
                                        phi_4697_ = _e1511;
                                    } else {
                                        phi_4697_ = _e1515;
                                    }
                                    let _e1518 = phi_4697_;
                                    let _e1520 = local_15.member_2[1u];
                                    if (_e1520[0] < 0f) {
                                        phi_4710_ = -(_e1520[0]);
                                    } else {
                                        phi_4710_ = _e1520[0];
                                    }
                                    let _e1527 = phi_4710_;
                                    if (_e1520[1] < 0f) {
                                        phi_4717_ = -(_e1520[1]);
                                    } else {
                                        phi_4717_ = _e1520[1];
                                    }
                                    let _e1531 = phi_4717_;
                                    if (_e1527 > _e1531) {
                                        phi_4722_ = _e1527;
                                    } else {
                                        phi_4722_ = _e1531;
                                    }
                                    let _e1534 = phi_4722_;
                                    if (_e1520[2] < 0f) {
                                        phi_4729_ = -(_e1520[2]);
                                    } else {
                                        phi_4729_ = _e1520[2];
                                    }
                                    let _e1538 = phi_4729_;
                                    if (_e1534 > _e1538) {
                                        phi_4734_ = _e1534;
                                    } else {
                                        phi_4734_ = _e1538;
                                    }
                                    let _e1541 = phi_4734_;
                                    if (_e1518 > _e1541) {
                                        phi_4739_ = _e1518;
                                    } else {
                                        phi_4739_ = _e1541;
                                    }
                                    let _e1544 = phi_4739_;
                                    let _e1547 = local_15.member_2[0u];
                                    let _e1552 = local_15.member_2[1u];
                                    let _e1562 = (_e1547[0] + ((_e1552[0] - _e1547[0]) * _e1230));
                                    let _e1563 = (_e1547[1] + ((_e1552[1] - _e1547[1]) * _e1230));
                                    let _e1564 = (_e1547[2] + ((_e1552[2] - _e1547[2]) * _e1230));
                                    let _e1566 = local_15.member_2[1u];
                                    let _e1571 = local_15.member_2[0u];
                                    let _e1575 = (_e1566[0] - _e1571[0]);
                                    let _e1576 = (_e1566[1] - _e1571[1]);
                                    let _e1577 = (_e1566[2] - _e1571[2]);
                                    if (_e1575 < 0f) {
                                        phi_4798_ = -(_e1575);
                                    } else {
                                        phi_4798_ = _e1575;
                                    }
                                    let _e1581 = phi_4798_;
                                    if (_e1576 < 0f) {
                                        phi_4804_ = -(_e1576);
                                    } else {
                                        phi_4804_ = _e1576;
                                    }
                                    let _e1585 = phi_4804_;
                                    if (_e1581 > _e1585) {
                                        phi_4809_ = _e1581;
                                    } else {
                                        phi_4809_ = _e1585;
                                    }
                                    let _e1588 = phi_4809_;
                                    if (_e1577 < 0f) {
                                        phi_4815_ = -(_e1577);
                                    } else {
                                        phi_4815_ = _e1577;
                                    }
                                    let _e1592 = phi_4815_;
                                    if (_e1588 > _e1592) {
                                        phi_4820_ = _e1588;
                                    } else {
                                        phi_4820_ = _e1592;
                                    }
                                    let _e1595 = phi_4820_;
                                    let _e1601 = ((((_e1232 * _e1595) * 1.01f) + ((_e1544 + _e1495) * (0.000000059604645f * 8f))) + _e1495);
                                    if (_e1562 < 0f) {
                                        phi_4832_ = -(_e1562);
                                    } else {
                                        phi_4832_ = _e1562;
                                    }
                                    let _e1605 = phi_4832_;
                                    if (_e1563 < 0f) {
                                        phi_4838_ = -(_e1563);
                                    } else {
                                        phi_4838_ = _e1563;
                                    }
                                    let _e1609 = phi_4838_;
                                    if (_e1605 > _e1609) {
                                        phi_4843_ = _e1605;
                                    } else {
                                        phi_4843_ = _e1609;
                                    }
                                    let _e1612 = phi_4843_;
                                    if (_e1564 < 0f) {
                                        phi_4849_ = -(_e1564);
                                    } else {
                                        phi_4849_ = _e1564;
                                    }
                                    let _e1616 = phi_4849_;
                                    if (_e1612 > _e1616) {
                                        phi_4854_ = _e1612;
                                    } else {
                                        phi_4854_ = _e1616;
                                    }
                                    let _e1619 = phi_4854_;
                                    local_5 = type_40(array<f32, 3>(_e1562, _e1563, _e1564), _e1601, (_e1619 + _e1601));
                                    let _e1624 = local_4.member;
                                    let _e1629 = local_5.member;
                                    let _e1635 = ((_e1624[1] * _e1629[2]) - (_e1624[2] * _e1629[1]));
                                    let _e1638 = ((_e1624[2] * _e1629[0]) - (_e1624[0] * _e1629[2]));
                                    let _e1641 = ((_e1624[0] * _e1629[1]) - (_e1624[1] * _e1629[0]));
                                    if (_e1635 < 0f) {
                                        phi_4903_ = -(_e1635);
                                    } else {
                                        phi_4903_ = _e1635;
                                    }
                                    let _e1645 = phi_4903_;
                                    if (_e1638 < 0f) {
                                        phi_4909_ = -(_e1638);
                                    } else {
                                        phi_4909_ = _e1638;
                                    }
                                    let _e1649 = phi_4909_;
                                    if (_e1645 > _e1649) {
                                        if (_e1635 < 0f) {
                                            phi_4919_ = -(_e1635);
                                        } else {
                                            phi_4919_ = _e1635;
                                        }
                                        let _e1667 = phi_4919_;
                                        if (_e1641 < 0f) {
                                            phi_4925_ = -(_e1641);
                                        } else {
                                            phi_4925_ = _e1641;
                                        }
                                        let _e1671 = phi_4925_;
                                        if (_e1667 > _e1671) {
                                            phi_4930_ = 2u;
                                            phi_4931_ = 1u;
                                        } else {
                                            phi_4930_ = 1u;
                                            phi_4931_ = 0u;
                                        }
                                        let _e1674 = phi_4930_;
                                        let _e1676 = phi_4931_;
                                        phi_4950_ = _e1674;
                                        phi_4951_ = _e1676;
                                    } else {
                                        if (_e1638 < 0f) {
                                            phi_4937_ = -(_e1638);
                                        } else {
                                            phi_4937_ = _e1638;
                                        }
                                        let _e1654 = phi_4937_;
                                        if (_e1641 < 0f) {
                                            phi_4943_ = -(_e1641);
                                        } else {
                                            phi_4943_ = _e1641;
                                        }
                                        let _e1658 = phi_4943_;
                                        if (_e1654 > _e1658) {
                                            phi_4948_ = 0u;
                                            phi_4949_ = 2u;
                                        } else {
                                            phi_4948_ = 1u;
                                            phi_4949_ = 0u;
                                        }
                                        let _e1661 = phi_4948_;
                                        let _e1663 = phi_4949_;
                                        phi_4950_ = _e1661;
                                        phi_4951_ = _e1663;
                                    }
                                    let _e1678 = phi_4950_;
                                    let _e1680 = phi_4951_;
                                    if (_e1680 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1684 = local_4.member[_e1680];
                                    if (_e1678 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1688 = local_5.member[_e1678];
                                    if (_e1678 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1693 = local_4.member[_e1678];
                                    if (_e1680 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1697 = local_5.member[_e1680];
                                    let _e1699 = ((_e1684 * _e1688) - (_e1693 * _e1697));
                                    let _e1701 = local_4.member_1;
                                    let _e1703 = local_5.member_2;
                                    let _e1706 = local_4.member_2;
                                    let _e1708 = local_5.member_1;
                                    let _e1713 = local_4.member_2;
                                    let _e1715 = local_5.member_2;
                                    let _e1722 = local_4.member_2;
                                    let _e1725 = local_5.member_2;
                                    let _e1729 = (((((_e1701 * _e1703) + (_e1706 * _e1708)) * 2.01f) + ((_e1713 * _e1715) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1722) * (1f + _e1725))));
                                    if (_e1699 < 0f) {
                                        phi_5018_ = -(_e1699);
                                    } else {
                                        phi_5018_ = _e1699;
                                    }
                                    let _e1733 = phi_5018_;
                                    if (_e1733 > _e1729) {
                                        if (_e1699 < 0f) {
                                            phi_5027_ = -1f;
                                        } else {
                                            phi_5027_ = 1f;
                                        }
                                        let _e1737 = phi_5027_;
                                        if (_e1680 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1741 = local_3.member[_e1680];
                                        if (_e1678 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1745 = local_5.member[_e1678];
                                        if (_e1678 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1750 = local_3.member[_e1678];
                                        if (_e1680 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1754 = local_5.member[_e1680];
                                        let _e1758 = local_3.member_1;
                                        let _e1760 = local_5.member_2;
                                        let _e1763 = local_3.member_2;
                                        let _e1765 = local_5.member_1;
                                        let _e1770 = local_3.member_2;
                                        let _e1772 = local_5.member_2;
                                        let _e1779 = local_3.member_2;
                                        let _e1782 = local_5.member_2;
                                        let _e1786 = (((((_e1758 * _e1760) + (_e1763 * _e1765)) * 2.01f) + ((_e1770 * _e1772) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1779) * (1f + _e1782))));
                                        if (_e1680 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1790 = local_4.member[_e1680];
                                        if (_e1678 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1794 = local_3.member[_e1678];
                                        if (_e1678 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1799 = local_4.member[_e1678];
                                        if (_e1680 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1803 = local_3.member[_e1680];
                                        let _e1807 = local_4.member_1;
                                        let _e1809 = local_3.member_2;
                                        let _e1812 = local_4.member_2;
                                        let _e1814 = local_3.member_1;
                                        let _e1819 = local_4.member_2;
                                        let _e1821 = local_3.member_2;
                                        let _e1828 = local_4.member_2;
                                        let _e1831 = local_3.member_2;
                                        let _e1835 = (((((_e1807 * _e1809) + (_e1812 * _e1814)) * 2.01f) + ((_e1819 * _e1821) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1828) * (1f + _e1831))));
                                        let _e1836 = (_e1699 * _e1737);
                                        let _e1837 = (((_e1741 * _e1745) - (_e1750 * _e1754)) * _e1737);
                                        let _e1838 = (((_e1790 * _e1794) - (_e1799 * _e1803)) * _e1737);
                                        if (_e1836 < 0f) {
                                            phi_5158_ = -(_e1836);
                                        } else {
                                            phi_5158_ = _e1836;
                                        }
                                        let _e1842 = phi_5158_;
                                        if (_e1837 < 0f) {
                                            phi_5164_ = -(_e1837);
                                        } else {
                                            phi_5164_ = _e1837;
                                        }
                                        let _e1846 = phi_5164_;
                                        if (_e1838 < 0f) {
                                            phi_5171_ = -(_e1838);
                                        } else {
                                            phi_5171_ = _e1838;
                                        }
                                        let _e1851 = phi_5171_;
                                        let _e1854 = (((_e1842 + _e1846) + _e1851) * (0.000000059604645f * 4f));
                                        local_6[0u].member = _e1837;
                                        local_6[0u].member_1 = _e1786;
                                        local_6[1u].member = _e1838;
                                        local_6[1u].member_1 = _e1835;
                                        local_6[2u].member = (_e1836 - _e1837);
                                        local_6[2u].member_1 = ((_e1729 + _e1786) + _e1854);
                                        local_6[3u].member = (_e1836 - _e1838);
                                        local_6[3u].member_1 = ((_e1729 + _e1835) + _e1854);
                                        phi_5214_ = type_28(0u, 4u);
                                        phi_5217_ = true;
                                        loop {
                                            let _e1875 = phi_5214_;
                                            let _e1877 = phi_5217_;
                                            local_20 = _e1877;
                                            if (_e1875.member < _e1875.member_1) {
                                                phi_5215_ = type_28((_e1875.member + 1u), _e1875.member_1);
                                                phi_5240_ = type_28(1u, _e1875.member);
                                            } else {
                                                phi_5215_ = _e1875;
                                                phi_5240_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1891 = phi_5215_;
                                            let _e1893 = phi_5240_;
                                            if (bitcast<i32>(_e1893.member) != 0i) {
                                                if (_e1893.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1901 = local_6[_e1893.member_1].member;
                                                let _e1904 = local_6[_e1893.member_1].member_1;
                                                let _e1906 = (_e1901 < -(_e1904));
                                                if _e1906 {
                                                    phi_5267_ = bool();
                                                    phi_5268_ = false;
                                                } else {
                                                    phi_5267_ = (_e1877 && (_e1901 > _e1904));
                                                    phi_5268_ = true;
                                                }
                                                let _e1910 = phi_5267_;
                                                let _e1912 = phi_5268_;
                                                phi_5218_ = _e1910;
                                                phi_5269_ = _e1912;
                                                phi_5270_ = _e1906;
                                            } else {
                                                phi_5218_ = bool();
                                                phi_5269_ = false;
                                                phi_5270_ = false;
                                            }
                                            let _e1914 = phi_5218_;
                                            let _e1916 = phi_5269_;
                                            let _e1918 = phi_5270_;
                                            local_19 = _e1918;
                                            continue;
                                            continuing {
                                                phi_5214_ = _e1891;
                                                phi_5217_ = _e1914;
                                                break if !(_e1916);
                                            }
                                        }
                                        let _e1921 = local_19;
                                        if _e1921 {
                                            phi_5274_ = false;
                                        } else {
                                            phi_5274_ = true;
                                        }
                                        let _e1923 = phi_5274_;
                                        if _e1923 {
                                            let _e1925 = local_20;
                                            if _e1925 {
                                                phi_5281_ = 1u;
                                            } else {
                                                phi_5281_ = 2u;
                                            }
                                            let _e1927 = phi_5281_;
                                            phi_5282_ = _e1927;
                                            phi_5283_ = false;
                                        } else {
                                            phi_5282_ = u32();
                                            phi_5283_ = true;
                                        }
                                        let _e1929 = phi_5282_;
                                        let _e1931 = phi_5283_;
                                        phi_5284_ = _e1929;
                                        phi_5285_ = 0u;
                                        phi_5286_ = _e1931;
                                    } else {
                                        phi_5284_ = u32();
                                        phi_5285_ = 2u;
                                        phi_5286_ = true;
                                    }
                                    let _e1933 = phi_5284_;
                                    let _e1935 = phi_5285_;
                                    let _e1937 = phi_5286_;
                                    if _e1937 {
                                        phi_5290_ = _e1935;
                                    } else {
                                        phi_5290_ = _e1933;
                                    }
                                    let _e1939 = phi_5290_;
                                    let _e1940 = (_e1939 == 0u);
                                    if _e1940 {
                                        phi_6765_ = f32();
                                        phi_6766_ = false;
                                        phi_6767_ = false;
                                        phi_6768_ = false;
                                    } else {
                                        if (_e1939 == 1u) {
                                            if _e1222.member_2 {
                                                if ((_e1222.member_1 - _e1222.member) <= 0.0000005f) {
                                                    phi_5310_ = false;
                                                } else {
                                                    phi_5310_ = true;
                                                }
                                                let _e1948 = phi_5310_;
                                                phi_5311_ = _e1948;
                                            } else {
                                                phi_5311_ = true;
                                            }
                                            let _e1950 = phi_5311_;
                                            phi_5312_ = _e1950;
                                        } else {
                                            phi_5312_ = true;
                                        }
                                        let _e1952 = phi_5312_;
                                        if _e1952 {
                                            let _e1957 = local_15.member[0u];
                                            let _e1963 = local_15.member_1[0u];
                                            let _e1969 = local_15.member_2[0u];
                                            let _e1973 = (_e1957[0] - _e1963[0]);
                                            let _e1974 = (_e1957[1] - _e1963[1]);
                                            let _e1975 = (_e1957[2] - _e1963[2]);
                                            local_1 = array<array<f32, 3>, 4>(_e1957, array<f32, 3>(_e1973, _e1974, _e1975), array<f32, 3>((_e1957[0] - _e1969[0]), (_e1957[1] - _e1969[1]), (_e1957[2] - _e1969[2])), array<f32, 3>((_e1973 - _e1969[0]), (_e1974 - _e1969[1]), (_e1975 - _e1969[2])));
                                            let _e1988 = local_15.member[1u];
                                            let _e1994 = local_15.member_1[1u];
                                            let _e2000 = local_15.member_2[1u];
                                            let _e2004 = (_e1988[0] - _e1994[0]);
                                            let _e2005 = (_e1988[1] - _e1994[1]);
                                            let _e2006 = (_e1988[2] - _e1994[2]);
                                            local_2 = array<array<f32, 3>, 4>(_e1988, array<f32, 3>(_e2004, _e2005, _e2006), array<f32, 3>((_e1988[0] - _e2000[0]), (_e1988[1] - _e2000[1]), (_e1988[2] - _e2000[2])), array<f32, 3>((_e2004 - _e2000[0]), (_e2005 - _e2000[1]), (_e2006 - _e2000[2])));
                                            let _e2019 = local_15.member[0u];
                                            if (_e2019[0] < 0f) {
                                                phi_5508_ = -(_e2019[0]);
                                            } else {
                                                phi_5508_ = _e2019[0];
                                            }
                                            let _e2026 = phi_5508_;
                                            if (_e2019[1] < 0f) {
                                                phi_5515_ = -(_e2019[1]);
                                            } else {
                                                phi_5515_ = _e2019[1];
                                            }
                                            let _e2030 = phi_5515_;
                                            if (_e2026 > _e2030) {
                                                phi_5520_ = _e2026;
                                            } else {
                                                phi_5520_ = _e2030;
                                            }
                                            let _e2033 = phi_5520_;
                                            if (_e2019[2] < 0f) {
                                                phi_5527_ = -(_e2019[2]);
                                            } else {
                                                phi_5527_ = _e2019[2];
                                            }
                                            let _e2037 = phi_5527_;
                                            if (_e2033 > _e2037) {
                                                phi_5532_ = _e2033;
                                            } else {
                                                phi_5532_ = _e2037;
                                            }
                                            let _e2040 = phi_5532_;
                                            let _e2043 = local_15.member[1u];
                                            if (_e2043[0] < 0f) {
                                                phi_5545_ = -(_e2043[0]);
                                            } else {
                                                phi_5545_ = _e2043[0];
                                            }
                                            let _e2050 = phi_5545_;
                                            if (_e2043[1] < 0f) {
                                                phi_5552_ = -(_e2043[1]);
                                            } else {
                                                phi_5552_ = _e2043[1];
                                            }
                                            let _e2054 = phi_5552_;
                                            if (_e2050 > _e2054) {
                                                phi_5557_ = _e2050;
                                            } else {
                                                phi_5557_ = _e2054;
                                            }
                                            let _e2057 = phi_5557_;
                                            if (_e2043[2] < 0f) {
                                                phi_5564_ = -(_e2043[2]);
                                            } else {
                                                phi_5564_ = _e2043[2];
                                            }
                                            let _e2061 = phi_5564_;
                                            if (_e2057 > _e2061) {
                                                phi_5569_ = _e2057;
                                            } else {
                                                phi_5569_ = _e2061;
                                            }
                                            let _e2064 = phi_5569_;
                                            if (_e2040 > _e2064) {
                                                phi_5574_ = _e2040;
                                            } else {
                                                phi_5574_ = _e2064;
                                            }
                                            let _e2067 = phi_5574_;
                                            let _e2069 = local_15.member_3;
                                            let _e2073 = local_15.member_1[0u];
                                            if (_e2073[0] < 0f) {
                                                phi_5591_ = -(_e2073[0]);
                                            } else {
                                                phi_5591_ = _e2073[0];
                                            }
                                            let _e2080 = phi_5591_;
                                            if (_e2073[1] < 0f) {
                                                phi_5598_ = -(_e2073[1]);
                                            } else {
                                                phi_5598_ = _e2073[1];
                                            }
                                            let _e2084 = phi_5598_;
                                            if (_e2080 > _e2084) {
                                                phi_5603_ = _e2080;
                                            } else {
                                                phi_5603_ = _e2084;
                                            }
                                            let _e2087 = phi_5603_;
                                            if (_e2073[2] < 0f) {
                                                phi_5610_ = -(_e2073[2]);
                                            } else {
                                                phi_5610_ = _e2073[2];
                                            }
                                            let _e2091 = phi_5610_;
                                            if (_e2087 > _e2091) {
                                                phi_5615_ = _e2087;
                                            } else {
                                                phi_5615_ = _e2091;
                                            }
                                            let _e2094 = phi_5615_;
                                            let _e2097 = local_15.member_1[1u];
                                            if (_e2097[0] < 0f) {
                                                phi_5629_ = -(_e2097[0]);
                                            } else {
                                                phi_5629_ = _e2097[0];
                                            }
                                            let _e2104 = phi_5629_;
                                            if (_e2097[1] < 0f) {
                                                phi_5636_ = -(_e2097[1]);
                                            } else {
                                                phi_5636_ = _e2097[1];
                                            }
                                            let _e2108 = phi_5636_;
                                            if (_e2104 > _e2108) {
                                                phi_5641_ = _e2104;
                                            } else {
                                                phi_5641_ = _e2108;
                                            }
                                            let _e2111 = phi_5641_;
                                            if (_e2097[2] < 0f) {
                                                phi_5648_ = -(_e2097[2]);
                                            } else {
                                                phi_5648_ = _e2097[2];
                                            }
                                            let _e2115 = phi_5648_;
                                            if (_e2111 > _e2115) {
                                                phi_5653_ = _e2111;
                                            } else {
                                                phi_5653_ = _e2115;
                                            }
                                            let _e2118 = phi_5653_;
                                            if (_e2094 > _e2118) {
                                                phi_5658_ = _e2094;
                                            } else {
                                                phi_5658_ = _e2118;
                                            }
                                            let _e2121 = phi_5658_;
                                            let _e2123 = local_15.member_3;
                                            let _e2127 = local_15.member_2[0u];
                                            if (_e2127[0] < 0f) {
                                                phi_5675_ = -(_e2127[0]);
                                            } else {
                                                phi_5675_ = _e2127[0];
                                            }
                                            let _e2134 = phi_5675_;
                                            if (_e2127[1] < 0f) {
                                                phi_5682_ = -(_e2127[1]);
                                            } else {
                                                phi_5682_ = _e2127[1];
                                            }
                                            let _e2138 = phi_5682_;
                                            if (_e2134 > _e2138) {
                                                phi_5687_ = _e2134;
                                            } else {
                                                phi_5687_ = _e2138;
                                            }
                                            let _e2141 = phi_5687_;
                                            if (_e2127[2] < 0f) {
                                                phi_5694_ = -(_e2127[2]);
                                            } else {
                                                phi_5694_ = _e2127[2];
                                            }
                                            let _e2145 = phi_5694_;
                                            if (_e2141 > _e2145) {
                                                phi_5699_ = _e2141;
                                            } else {
                                                phi_5699_ = _e2145;
                                            }
                                            let _e2148 = phi_5699_;
                                            let _e2151 = local_15.member_2[1u];
                                            if (_e2151[0] < 0f) {
                                                phi_5713_ = -(_e2151[0]);
                                            } else {
                                                phi_5713_ = _e2151[0];
                                            }
                                            let _e2158 = phi_5713_;
                                            if (_e2151[1] < 0f) {
                                                phi_5720_ = -(_e2151[1]);
                                            } else {
                                                phi_5720_ = _e2151[1];
                                            }
                                            let _e2162 = phi_5720_;
                                            if (_e2158 > _e2162) {
                                                phi_5725_ = _e2158;
                                            } else {
                                                phi_5725_ = _e2162;
                                            }
                                            let _e2165 = phi_5725_;
                                            if (_e2151[2] < 0f) {
                                                phi_5732_ = -(_e2151[2]);
                                            } else {
                                                phi_5732_ = _e2151[2];
                                            }
                                            let _e2169 = phi_5732_;
                                            if (_e2165 > _e2169) {
                                                phi_5737_ = _e2165;
                                            } else {
                                                phi_5737_ = _e2169;
                                            }
                                            let _e2172 = phi_5737_;
                                            if (_e2148 > _e2172) {
                                                phi_5742_ = _e2148;
                                            } else {
                                                phi_5742_ = _e2172;
                                            }
                                            let _e2175 = phi_5742_;
                                            let _e2177 = local_15.member_3;
                                            let _e2184 = local_15.member_3;
                                            phi_5758_ = type_28(0u, 48u);
                                            phi_5761_ = _e1222.member;
                                            loop {
                                                let _e2190 = phi_5758_;
                                                let _e2192 = phi_5761_;
                                                local_60 = _e2192;
                                                local_27 = _e2192;
                                                local_28 = _e2192;
                                                local_29 = _e2192;
                                                if (_e2190.member < _e2190.member_1) {
                                                    phi_5759_ = type_28((_e2190.member + 1u), _e2190.member_1);
                                                    phi_5784_ = type_28(1u, _e2190.member);
                                                } else {
                                                    phi_5759_ = _e2190;
                                                    phi_5784_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e2206 = phi_5759_;
                                                let _e2208 = phi_5784_;
                                                if (bitcast<i32>(_e2208.member) != 0i) {
                                                    let _e2214 = local_15.member[0u];
                                                    let _e2220 = local_15.member[1u];
                                                    let _e2230 = (_e2214[0] + ((_e2220[0] - _e2214[0]) * _e2192));
                                                    let _e2231 = (_e2214[1] + ((_e2220[1] - _e2214[1]) * _e2192));
                                                    let _e2232 = (_e2214[2] + ((_e2220[2] - _e2214[2]) * _e2192));
                                                    let _e2235 = local_15.member_1[0u];
                                                    let _e2241 = local_15.member_1[1u];
                                                    let _e2251 = (_e2235[0] + ((_e2241[0] - _e2235[0]) * _e2192));
                                                    let _e2252 = (_e2235[1] + ((_e2241[1] - _e2235[1]) * _e2192));
                                                    let _e2253 = (_e2235[2] + ((_e2241[2] - _e2235[2]) * _e2192));
                                                    let _e2256 = local_15.member_2[0u];
                                                    let _e2262 = local_15.member_2[1u];
                                                    let _e2272 = (_e2256[0] + ((_e2262[0] - _e2256[0]) * _e2192));
                                                    let _e2273 = (_e2256[1] + ((_e2262[1] - _e2256[1]) * _e2192));
                                                    let _e2274 = (_e2256[2] + ((_e2262[2] - _e2256[2]) * _e2192));
                                                    let _e2279 = (((_e2251 * _e2251) + (_e2252 * _e2252)) + (_e2253 * _e2253));
                                                    let _e2284 = (((_e2251 * _e2272) + (_e2252 * _e2273)) + (_e2253 * _e2274));
                                                    let _e2289 = (((_e2272 * _e2272) + (_e2273 * _e2273)) + (_e2274 * _e2274));
                                                    let _e2294 = (((_e2230 * _e2251) + (_e2231 * _e2252)) + (_e2232 * _e2253));
                                                    let _e2299 = (((_e2230 * _e2272) + (_e2231 * _e2273)) + (_e2232 * _e2274));
                                                    let _e2302 = ((_e2279 * _e2289) - (_e2284 * _e2284));
                                                    let _e2306 = (((_e2294 * _e2289) - (_e2299 * _e2284)) / _e2302);
                                                    let _e2310 = (((_e2299 * _e2279) - (_e2294 * _e2284)) / _e2302);
                                                    if (_e2306 >= 0f) {
                                                        if (_e2310 >= 0f) {
                                                            if (_e2306 <= 1f) {
                                                                phi_5938_ = (_e2310 <= 1f);
                                                                phi_5939_ = false;
                                                            } else {
                                                                phi_5938_ = bool();
                                                                phi_5939_ = true;
                                                            }
                                                            let _e2316 = phi_5938_;
                                                            let _e2318 = phi_5939_;
                                                            phi_5940_ = _e2316;
                                                            phi_5941_ = _e2318;
                                                        } else {
                                                            phi_5940_ = bool();
                                                            phi_5941_ = true;
                                                        }
                                                        let _e2320 = phi_5940_;
                                                        let _e2322 = phi_5941_;
                                                        phi_5942_ = _e2320;
                                                        phi_5943_ = _e2322;
                                                    } else {
                                                        phi_5942_ = bool();
                                                        phi_5943_ = true;
                                                    }
                                                    let _e2324 = phi_5942_;
                                                    let _e2326 = phi_5943_;
                                                    if _e2326 {
                                                        let _e2327 = (_e2302 > 0f);
                                                        if _e2327 {
                                                            phi_5973_ = false;
                                                        } else {
                                                            phi_5973_ = true;
                                                        }
                                                        let _e2329 = phi_5973_;
                                                        phi_5974_ = false;
                                                        phi_5975_ = _e2329;
                                                        phi_5976_ = _e2327;
                                                    } else {
                                                        phi_5974_ = true;
                                                        phi_5975_ = false;
                                                        phi_5976_ = false;
                                                    }
                                                    let _e2331 = phi_5974_;
                                                    let _e2333 = phi_5975_;
                                                    let _e2335 = phi_5976_;
                                                    if _e2331 {
                                                        if (_e2302 > 0f) {
                                                            if _e2324 {
                                                                phi_6000_ = array<f32, 3>((_e2230 - ((_e2251 * _e2306) + (_e2272 * _e2310))), (_e2231 - ((_e2252 * _e2306) + (_e2273 * _e2310))), (_e2232 - ((_e2253 * _e2306) + (_e2274 * _e2310))));
                                                                phi_6001_ = false;
                                                            } else {
                                                                phi_6000_ = array<f32, 3>();
                                                                phi_6001_ = true;
                                                            }
                                                            let _e2351 = phi_6000_;
                                                            let _e2353 = phi_6001_;
                                                            phi_6002_ = _e2351;
                                                            phi_6003_ = false;
                                                            phi_6004_ = _e2353;
                                                        } else {
                                                            phi_6002_ = array<f32, 3>();
                                                            phi_6003_ = true;
                                                            phi_6004_ = false;
                                                        }
                                                        let _e2355 = phi_6002_;
                                                        let _e2357 = phi_6003_;
                                                        let _e2359 = phi_6004_;
                                                        phi_6005_ = _e2355;
                                                        phi_6006_ = _e2357;
                                                        phi_6007_ = _e2359;
                                                    } else {
                                                        phi_6005_ = array<f32, 3>();
                                                        phi_6006_ = _e2333;
                                                        phi_6007_ = _e2335;
                                                    }
                                                    let _e2361 = phi_6005_;
                                                    let _e2363 = phi_6006_;
                                                    let _e2365 = phi_6007_;
                                                    if _e2363 {
                                                        phi_6011_ = true;
                                                    } else {
                                                        phi_6011_ = _e2365;
                                                    }
                                                    let _e2367 = phi_6011_;
                                                    if _e2367 {
                                                        let _e2368 = (_e2230 - _e2251);
                                                        let _e2369 = (_e2231 - _e2252);
                                                        let _e2370 = (_e2232 - _e2253);
                                                        let _e2381 = ((((_e2230 * _e2251) + (_e2231 * _e2252)) + (_e2232 * _e2253)) / (((_e2251 * _e2251) + (_e2252 * _e2252)) + (_e2253 * _e2253)));
                                                        if (_e2381 > 0f) {
                                                            if (_e2381 < 1f) {
                                                                phi_6041_ = _e2381;
                                                            } else {
                                                                phi_6041_ = 1f;
                                                            }
                                                            let _e2385 = phi_6041_;
                                                            phi_6042_ = _e2385;
                                                        } else {
                                                            phi_6042_ = 0f;
                                                        }
                                                        let _e2387 = phi_6042_;
                                                        let _e2404 = ((((_e2230 * _e2272) + (_e2231 * _e2273)) + (_e2232 * _e2274)) / (((_e2272 * _e2272) + (_e2273 * _e2273)) + (_e2274 * _e2274)));
                                                        if (_e2404 > 0f) {
                                                            if (_e2404 < 1f) {
                                                                phi_6069_ = _e2404;
                                                            } else {
                                                                phi_6069_ = 1f;
                                                            }
                                                            let _e2408 = phi_6069_;
                                                            phi_6070_ = _e2408;
                                                        } else {
                                                            phi_6070_ = 0f;
                                                        }
                                                        let _e2410 = phi_6070_;
                                                        let _e2427 = ((((_e2368 * _e2272) + (_e2369 * _e2273)) + (_e2370 * _e2274)) / (((_e2272 * _e2272) + (_e2273 * _e2273)) + (_e2274 * _e2274)));
                                                        if (_e2427 > 0f) {
                                                            if (_e2427 < 1f) {
                                                                phi_6097_ = _e2427;
                                                            } else {
                                                                phi_6097_ = 1f;
                                                            }
                                                            let _e2431 = phi_6097_;
                                                            phi_6098_ = _e2431;
                                                        } else {
                                                            phi_6098_ = 0f;
                                                        }
                                                        let _e2433 = phi_6098_;
                                                        let _e2440 = (_e2230 - _e2272);
                                                        let _e2441 = (_e2231 - _e2273);
                                                        let _e2442 = (_e2232 - _e2274);
                                                        let _e2453 = ((((_e2440 * _e2251) + (_e2441 * _e2252)) + (_e2442 * _e2253)) / (((_e2251 * _e2251) + (_e2252 * _e2252)) + (_e2253 * _e2253)));
                                                        if (_e2453 > 0f) {
                                                            if (_e2453 < 1f) {
                                                                phi_6128_ = _e2453;
                                                            } else {
                                                                phi_6128_ = 1f;
                                                            }
                                                            let _e2457 = phi_6128_;
                                                            phi_6129_ = _e2457;
                                                        } else {
                                                            phi_6129_ = 0f;
                                                        }
                                                        let _e2459 = phi_6129_;
                                                        local[0u] = array<f32, 3>((_e2230 - (_e2251 * _e2387)), (_e2231 - (_e2252 * _e2387)), (_e2232 - (_e2253 * _e2387)));
                                                        local[1u] = array<f32, 3>((_e2230 - (_e2272 * _e2410)), (_e2231 - (_e2273 * _e2410)), (_e2232 - (_e2274 * _e2410)));
                                                        local[2u] = array<f32, 3>((_e2368 - (_e2272 * _e2433)), (_e2369 - (_e2273 * _e2433)), (_e2370 - (_e2274 * _e2433)));
                                                        local[3u] = array<f32, 3>((_e2440 - (_e2251 * _e2459)), (_e2441 - (_e2252 * _e2459)), (_e2442 - (_e2253 * _e2459)));
                                                        let _e2475 = local[0u];
                                                        phi_6272_ = type_28(1u, 4u);
                                                        phi_6275_ = array<f32, 3>(_e2475[0], _e2475[1], _e2475[2]);
                                                        loop {
                                                            let _e2481 = phi_6272_;
                                                            let _e2483 = phi_6275_;
                                                            local_50 = _e2483;
                                                            if (_e2481.member < _e2481.member_1) {
                                                                phi_6273_ = type_28((_e2481.member + 1u), _e2481.member_1);
                                                                phi_6298_ = type_28(1u, _e2481.member);
                                                            } else {
                                                                phi_6273_ = _e2481;
                                                                phi_6298_ = type_28(0u, type_28().member_1);
                                                            }
                                                            let _e2497 = phi_6273_;
                                                            let _e2499 = phi_6298_;
                                                            let _e2503 = (bitcast<i32>(_e2499.member) != 0i);
                                                            if _e2503 {
                                                                if (_e2499.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2506 = local[_e2499.member_1];
                                                                if (_e2499.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2512 = local[_e2499.member_1];
                                                                if ((((_e2506[0] * _e2512[0]) + (_e2506[1] * _e2512[1])) + (_e2506[2] * _e2512[2])) < (((_e2483[0] * _e2483[0]) + (_e2483[1] * _e2483[1])) + (_e2483[2] * _e2483[2]))) {
                                                                    if (_e2499.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2535 = local[_e2499.member_1];
                                                                    phi_6365_ = array<f32, 3>(_e2535[0], _e2535[1], _e2535[2]);
                                                                } else {
                                                                    phi_6365_ = _e2483;
                                                                }
                                                                let _e2541 = phi_6365_;
                                                                phi_6276_ = _e2541;
                                                            } else {
                                                                phi_6276_ = array<f32, 3>();
                                                            }
                                                            let _e2543 = phi_6276_;
                                                            continue;
                                                            continuing {
                                                                phi_6272_ = _e2497;
                                                                phi_6275_ = _e2543;
                                                                break if !(_e2503);
                                                            }
                                                        }
                                                        let _e5137 = local_50;
                                                        phi_6366_ = _e5137;
                                                    } else {
                                                        phi_6366_ = _e2361;
                                                    }
                                                    let _e2546 = phi_6366_;
                                                    if (_e2546[0] < 0f) {
                                                        phi_6373_ = -(_e2546[0]);
                                                    } else {
                                                        phi_6373_ = _e2546[0];
                                                    }
                                                    let _e2551 = phi_6373_;
                                                    if (_e2546[1] < 0f) {
                                                        phi_6380_ = -(_e2546[1]);
                                                    } else {
                                                        phi_6380_ = _e2546[1];
                                                    }
                                                    let _e2556 = phi_6380_;
                                                    if (_e2546[2] < 0f) {
                                                        phi_6388_ = -(_e2546[2]);
                                                    } else {
                                                        phi_6388_ = _e2546[2];
                                                    }
                                                    let _e2562 = phi_6388_;
                                                    let _e2563 = ((_e2551 + _e2556) + _e2562);
                                                    if (_e2563 > 0f) {
                                                        if ((bitcast<u32>(_e2563) & 2139095040u) != 2139095040u) {
                                                            let _e2568 = (1f / _e2563);
                                                            let _e2570 = (_e2546[0] * _e2568);
                                                            let _e2572 = (_e2546[1] * _e2568);
                                                            let _e2574 = (_e2546[2] * _e2568);
                                                            let _e2579 = (((_e2570 * _e2570) + (_e2572 * _e2572)) + (_e2574 * _e2574));
                                                            if (_e2579 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2579 > 0f) {
                                                                    phi_6425_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6425_ = 0f;
                                                                }
                                                                let _e2638 = phi_6425_;
                                                                phi_6489_ = _e2638;
                                                            } else {
                                                                phi_6432_ = type_26(0i, 5i);
                                                                phi_6435_ = bitcast<f32>(((bitcast<u32>(_e2579) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2587 = phi_6432_;
                                                                    let _e2589 = phi_6435_;
                                                                    local_21 = _e2589;
                                                                    if (_e2587.member < _e2587.member_1) {
                                                                        let _e2597 = (_e2587.member + 1i);
                                                                        if ((false == (_e2597 > _e2587.member)) != false) {
                                                                            phi_6456_ = true;
                                                                        } else {
                                                                            phi_6456_ = false;
                                                                        }
                                                                        let _e2602 = phi_6456_;
                                                                        if _e2602 {
                                                                            phi_6462_ = type_27(0u, type_27().member_1);
                                                                        } else {
                                                                            phi_6462_ = type_27(1u, _e2597);
                                                                        }
                                                                        let _e2608 = phi_6462_;
                                                                        if (bitcast<i32>(_e2608.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_6433_ = type_26(_e2608.member_1, _e2587.member_1);
                                                                        phi_6476_ = type_27(1u, _e2587.member);
                                                                    } else {
                                                                        phi_6433_ = _e2587;
                                                                        phi_6476_ = type_27(0u, type_27().member_1);
                                                                    }
                                                                    let _e2618 = phi_6433_;
                                                                    let _e2620 = phi_6476_;
                                                                    let _e2623 = (bitcast<i32>(_e2620.member) != 0i);
                                                                    if _e2623 {
                                                                        phi_6436_ = (0.5f * (_e2589 + (_e2579 / _e2589)));
                                                                    } else {
                                                                        phi_6436_ = f32();
                                                                    }
                                                                    let _e2628 = phi_6436_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6432_ = _e2618;
                                                                        phi_6435_ = _e2628;
                                                                        break if !(_e2623);
                                                                    }
                                                                }
                                                                let _e2633 = local_21;
                                                                phi_6489_ = (_e2633 * (1f + (4f * 0.000000059604645f)));
                                                            }
                                                            let _e2640 = phi_6489_;
                                                            phi_6498_ = type_28(0u, 4u);
                                                            phi_6501_ = 2f;
                                                            loop {
                                                                let _e2648 = phi_6498_;
                                                                let _e2650 = phi_6501_;
                                                                local_23 = _e2650;
                                                                local_24 = _e2650;
                                                                local_25 = _e2650;
                                                                local_51 = _e2650;
                                                                local_52 = _e2650;
                                                                if (_e2648.member < _e2648.member_1) {
                                                                    phi_6499_ = type_28((_e2648.member + 1u), _e2648.member_1);
                                                                    phi_6524_ = type_28(1u, _e2648.member);
                                                                } else {
                                                                    phi_6499_ = _e2648;
                                                                    phi_6524_ = type_28(0u, type_28().member_1);
                                                                }
                                                                let _e2664 = phi_6499_;
                                                                let _e2666 = phi_6524_;
                                                                if (bitcast<i32>(_e2666.member) != 0i) {
                                                                    if (_e2666.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2673 = local_1[_e2666.member_1];
                                                                    let _e2681 = (((_e2570 * _e2673[0]) + (_e2572 * _e2673[1])) + (_e2574 * _e2673[2]));
                                                                    if (_e2666.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2684 = local_2[_e2666.member_1];
                                                                    let _e2692 = (((_e2570 * _e2684[0]) + (_e2572 * _e2684[1])) + (_e2574 * _e2684[2]));
                                                                    if (_e2681 < 0f) {
                                                                        phi_6575_ = -(_e2681);
                                                                    } else {
                                                                        phi_6575_ = _e2681;
                                                                    }
                                                                    let _e2696 = phi_6575_;
                                                                    if (_e2692 < 0f) {
                                                                        phi_6581_ = -(_e2692);
                                                                    } else {
                                                                        phi_6581_ = _e2692;
                                                                    }
                                                                    let _e2700 = phi_6581_;
                                                                    let _e2704 = (((((((((_e2067 + _e2069) + (_e2121 + _e2123)) + (_e2175 + _e2177)) * (0.000000059604645f * 16f)) + (_e2184 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2640) * (1f + (0.000000059604645f * 8f)))) + ((_e2696 + _e2700) * (0.000000059604645f * 8f)));
                                                                    if (_e2681 > _e2704) {
                                                                        if (_e2692 > _e2704) {
                                                                            phi_6594_ = false;
                                                                        } else {
                                                                            phi_6594_ = true;
                                                                        }
                                                                        let _e2708 = phi_6594_;
                                                                        phi_6595_ = _e2708;
                                                                    } else {
                                                                        phi_6595_ = true;
                                                                    }
                                                                    let _e2710 = phi_6595_;
                                                                    if _e2710 {
                                                                        let _e2714 = ((_e2681 + ((_e2692 - _e2681) * _e2192)) > _e2704);
                                                                        if _e2714 {
                                                                            if (_e2692 < _e2681) {
                                                                                let _e2721 = (((_e2681 - _e2704) / (_e2681 - _e2692)) * (1f - (0.000000059604645f * 16f)));
                                                                                if (_e2650 < _e2721) {
                                                                                    phi_6620_ = _e2650;
                                                                                } else {
                                                                                    phi_6620_ = _e2721;
                                                                                }
                                                                                let _e2724 = phi_6620_;
                                                                                phi_6621_ = _e2724;
                                                                            } else {
                                                                                phi_6621_ = _e2650;
                                                                            }
                                                                            let _e2726 = phi_6621_;
                                                                            phi_6622_ = _e2726;
                                                                        } else {
                                                                            phi_6622_ = f32();
                                                                        }
                                                                        let _e2728 = phi_6622_;
                                                                        phi_6623_ = _e2728;
                                                                        phi_6624_ = _e2714;
                                                                    } else {
                                                                        phi_6623_ = _e2650;
                                                                        phi_6624_ = true;
                                                                    }
                                                                    let _e2730 = phi_6623_;
                                                                    let _e2732 = phi_6624_;
                                                                    phi_6502_ = _e2730;
                                                                    phi_6625_ = _e2732;
                                                                    phi_6626_ = false;
                                                                } else {
                                                                    phi_6502_ = f32();
                                                                    phi_6625_ = false;
                                                                    phi_6626_ = true;
                                                                }
                                                                let _e2734 = phi_6502_;
                                                                let _e2736 = phi_6625_;
                                                                let _e2738 = phi_6626_;
                                                                local_22 = _e2738;
                                                                continue;
                                                                continuing {
                                                                    phi_6498_ = _e2664;
                                                                    phi_6501_ = _e2734;
                                                                    break if !(_e2736);
                                                                }
                                                            }
                                                            let _e2741 = local_22;
                                                            if _e2741 {
                                                                let _e2743 = local_23;
                                                                let _e2744 = (_e2743 > _e1222.member_1);
                                                                if _e2744 {
                                                                    phi_6647_ = false;
                                                                    phi_6648_ = false;
                                                                    phi_6649_ = false;
                                                                } else {
                                                                    let _e2746 = local_24;
                                                                    if (_e2746 > _e2192) {
                                                                        let _e2749 = local_25;
                                                                        let _e2751 = ((_e2749 - _e2192) < 0.00000000023283064f);
                                                                        if _e2751 {
                                                                            phi_6643_ = false;
                                                                        } else {
                                                                            phi_6643_ = true;
                                                                        }
                                                                        let _e2753 = phi_6643_;
                                                                        phi_6644_ = _e2753;
                                                                        phi_6645_ = _e2751;
                                                                        phi_6646_ = false;
                                                                    } else {
                                                                        phi_6644_ = false;
                                                                        phi_6645_ = false;
                                                                        phi_6646_ = true;
                                                                    }
                                                                    let _e2755 = phi_6644_;
                                                                    let _e2757 = phi_6645_;
                                                                    let _e2759 = phi_6646_;
                                                                    phi_6647_ = _e2755;
                                                                    phi_6648_ = _e2757;
                                                                    phi_6649_ = _e2759;
                                                                }
                                                                let _e2761 = phi_6647_;
                                                                let _e2763 = phi_6648_;
                                                                let _e2765 = phi_6649_;
                                                                phi_6650_ = _e2761;
                                                                phi_6651_ = _e2744;
                                                                phi_6652_ = _e2763;
                                                                phi_6653_ = _e2765;
                                                                phi_6654_ = false;
                                                            } else {
                                                                phi_6650_ = false;
                                                                phi_6651_ = false;
                                                                phi_6652_ = false;
                                                                phi_6653_ = false;
                                                                phi_6654_ = true;
                                                            }
                                                            let _e2767 = phi_6650_;
                                                            let _e2769 = phi_6651_;
                                                            let _e2771 = phi_6652_;
                                                            let _e2773 = phi_6653_;
                                                            let _e2775 = phi_6654_;
                                                            let _e5185 = local_51;
                                                            phi_6655_ = _e5185;
                                                            let _e5188 = local_52;
                                                            phi_6656_ = _e5188;
                                                            phi_6657_ = _e2767;
                                                            phi_6658_ = _e2769;
                                                            phi_6659_ = _e2771;
                                                            phi_6660_ = _e2773;
                                                            phi_6661_ = _e2775;
                                                            phi_6662_ = false;
                                                        } else {
                                                            phi_6655_ = f32();
                                                            phi_6656_ = f32();
                                                            phi_6657_ = false;
                                                            phi_6658_ = false;
                                                            phi_6659_ = false;
                                                            phi_6660_ = false;
                                                            phi_6661_ = false;
                                                            phi_6662_ = true;
                                                        }
                                                        let _e2777 = phi_6655_;
                                                        let _e2779 = phi_6656_;
                                                        let _e2781 = phi_6657_;
                                                        let _e2783 = phi_6658_;
                                                        let _e2785 = phi_6659_;
                                                        let _e2787 = phi_6660_;
                                                        let _e2789 = phi_6661_;
                                                        let _e2791 = phi_6662_;
                                                        phi_6663_ = _e2777;
                                                        phi_6664_ = _e2779;
                                                        phi_6665_ = _e2781;
                                                        phi_6666_ = _e2783;
                                                        phi_6667_ = _e2785;
                                                        phi_6668_ = _e2787;
                                                        phi_6669_ = _e2789;
                                                        phi_6670_ = _e2791;
                                                        phi_6671_ = false;
                                                    } else {
                                                        phi_6663_ = f32();
                                                        phi_6664_ = f32();
                                                        phi_6665_ = false;
                                                        phi_6666_ = false;
                                                        phi_6667_ = false;
                                                        phi_6668_ = false;
                                                        phi_6669_ = false;
                                                        phi_6670_ = false;
                                                        phi_6671_ = true;
                                                    }
                                                    let _e2793 = phi_6663_;
                                                    let _e2795 = phi_6664_;
                                                    let _e2797 = phi_6665_;
                                                    let _e2799 = phi_6666_;
                                                    let _e2801 = phi_6667_;
                                                    let _e2803 = phi_6668_;
                                                    let _e2805 = phi_6669_;
                                                    let _e2807 = phi_6670_;
                                                    let _e2809 = phi_6671_;
                                                    phi_6672_ = _e2793;
                                                    phi_5762_ = _e2795;
                                                    phi_6673_ = _e2797;
                                                    phi_6674_ = _e2799;
                                                    phi_6675_ = _e2801;
                                                    phi_6676_ = false;
                                                    phi_6677_ = _e2803;
                                                    phi_6678_ = _e2805;
                                                    phi_6679_ = _e2807;
                                                    phi_6680_ = _e2809;
                                                } else {
                                                    phi_6672_ = f32();
                                                    phi_5762_ = f32();
                                                    phi_6673_ = false;
                                                    phi_6674_ = false;
                                                    phi_6675_ = false;
                                                    phi_6676_ = true;
                                                    phi_6677_ = false;
                                                    phi_6678_ = false;
                                                    phi_6679_ = false;
                                                    phi_6680_ = false;
                                                }
                                                let _e2811 = phi_6672_;
                                                let _e2813 = phi_5762_;
                                                let _e2815 = phi_6673_;
                                                let _e2817 = phi_6674_;
                                                let _e2819 = phi_6675_;
                                                let _e2821 = phi_6676_;
                                                let _e2823 = phi_6677_;
                                                let _e2825 = phi_6678_;
                                                let _e2827 = phi_6679_;
                                                let _e2829 = phi_6680_;
                                                local_26 = _e2817;
                                                local_53 = _e2819;
                                                local_54 = _e2821;
                                                local_55 = _e2823;
                                                local_56 = _e2825;
                                                local_57 = _e2827;
                                                local_58 = _e2829;
                                                local_59 = _e2811;
                                                local_61 = _e2817;
                                                continue;
                                                continuing {
                                                    phi_5758_ = _e2206;
                                                    phi_5761_ = _e2813;
                                                    break if !(_e2815);
                                                }
                                            }
                                            let _e2832 = local_26;
                                            if _e2832 {
                                                phi_6685_ = type_55(0u, type_55().member_1);
                                                phi_6686_ = false;
                                                phi_6687_ = false;
                                                phi_6688_ = false;
                                                phi_6689_ = false;
                                                phi_6690_ = false;
                                                phi_6691_ = false;
                                            } else {
                                                phi_6685_ = type_55();
                                                let _e5218 = local_53;
                                                phi_6686_ = _e5218;
                                                let _e5221 = local_54;
                                                phi_6687_ = _e5221;
                                                let _e5224 = local_55;
                                                phi_6688_ = _e5224;
                                                let _e5227 = local_56;
                                                phi_6689_ = _e5227;
                                                let _e5230 = local_57;
                                                phi_6690_ = _e5230;
                                                let _e5233 = local_58;
                                                phi_6691_ = _e5233;
                                            }
                                            let _e2837 = phi_6685_;
                                            let _e2839 = phi_6686_;
                                            let _e2841 = phi_6687_;
                                            let _e2843 = phi_6688_;
                                            let _e2845 = phi_6689_;
                                            let _e2847 = phi_6690_;
                                            let _e2849 = phi_6691_;
                                            if _e2839 {
                                                let _e5236 = local_59;
                                                phi_6695_ = _e5236;
                                                phi_6696_ = true;
                                                phi_6697_ = false;
                                                phi_6698_ = false;
                                                phi_6699_ = false;
                                                phi_6700_ = false;
                                                phi_6701_ = false;
                                            } else {
                                                let _e5238 = local_60;
                                                phi_6695_ = _e5238;
                                                phi_6696_ = _e2841;
                                                phi_6697_ = _e2843;
                                                phi_6698_ = _e2845;
                                                let _e5244 = local_61;
                                                phi_6699_ = _e5244;
                                                phi_6700_ = _e2847;
                                                phi_6701_ = _e2849;
                                            }
                                            let _e2851 = phi_6695_;
                                            let _e2853 = phi_6696_;
                                            let _e2855 = phi_6697_;
                                            let _e2857 = phi_6698_;
                                            let _e2859 = phi_6699_;
                                            let _e2861 = phi_6700_;
                                            let _e2863 = phi_6701_;
                                            if _e2853 {
                                                phi_6706_ = type_55(1u, _e2851);
                                                phi_6707_ = false;
                                                phi_6708_ = false;
                                                phi_6709_ = false;
                                                phi_6710_ = false;
                                                phi_6711_ = false;
                                            } else {
                                                phi_6706_ = type_55();
                                                phi_6707_ = _e2855;
                                                phi_6708_ = _e2857;
                                                phi_6709_ = _e2859;
                                                phi_6710_ = _e2861;
                                                phi_6711_ = _e2863;
                                            }
                                            let _e2866 = phi_6706_;
                                            let _e2868 = phi_6707_;
                                            let _e2870 = phi_6708_;
                                            let _e2872 = phi_6709_;
                                            let _e2874 = phi_6710_;
                                            let _e2876 = phi_6711_;
                                            if _e2868 {
                                                let _e2878 = local_27;
                                                phi_6716_ = type_55(1u, _e2878);
                                                phi_6717_ = false;
                                                phi_6718_ = true;
                                                phi_6719_ = false;
                                                phi_6720_ = false;
                                            } else {
                                                phi_6716_ = _e2837;
                                                phi_6717_ = _e2870;
                                                phi_6718_ = _e2872;
                                                phi_6719_ = _e2874;
                                                phi_6720_ = _e2876;
                                            }
                                            let _e2881 = phi_6716_;
                                            let _e2883 = phi_6717_;
                                            let _e2885 = phi_6718_;
                                            let _e2887 = phi_6719_;
                                            let _e2889 = phi_6720_;
                                            if _e2883 {
                                                let _e2891 = local_28;
                                                phi_6725_ = type_55(1u, _e2891);
                                                phi_6726_ = true;
                                                phi_6727_ = false;
                                                phi_6728_ = false;
                                            } else {
                                                phi_6725_ = _e2881;
                                                phi_6726_ = _e2885;
                                                phi_6727_ = _e2887;
                                                phi_6728_ = _e2889;
                                            }
                                            let _e2894 = phi_6725_;
                                            let _e2896 = phi_6726_;
                                            let _e2898 = phi_6727_;
                                            let _e2900 = phi_6728_;
                                            if _e2896 {
                                                phi_6732_ = false;
                                                phi_6733_ = false;
                                            } else {
                                                phi_6732_ = _e2898;
                                                phi_6733_ = _e2900;
                                            }
                                            let _e2902 = phi_6732_;
                                            let _e2904 = phi_6733_;
                                            if _e2902 {
                                                phi_6737_ = false;
                                                phi_6738_ = false;
                                            } else {
                                                phi_6737_ = _e2904;
                                                phi_6738_ = _e2896;
                                            }
                                            let _e2906 = phi_6737_;
                                            let _e2908 = phi_6738_;
                                            if _e2906 {
                                                phi_6742_ = true;
                                                phi_6743_ = false;
                                            } else {
                                                phi_6742_ = _e2902;
                                                phi_6743_ = _e2908;
                                            }
                                            let _e2910 = phi_6742_;
                                            let _e2912 = phi_6743_;
                                            if _e2910 {
                                                let _e2914 = local_29;
                                                phi_6748_ = type_55(1u, _e2914);
                                                phi_6749_ = true;
                                            } else {
                                                phi_6748_ = _e2894;
                                                phi_6749_ = _e2912;
                                            }
                                            let _e2917 = phi_6748_;
                                            let _e2919 = phi_6749_;
                                            if _e2919 {
                                                phi_6753_ = _e2917;
                                            } else {
                                                phi_6753_ = _e2866;
                                            }
                                            let _e2921 = phi_6753_;
                                            let _e2924 = (_e2921.member != 0u);
                                            if _e2924 {
                                                phi_6760_ = false;
                                            } else {
                                                phi_6760_ = true;
                                            }
                                            let _e2926 = phi_6760_;
                                            phi_6761_ = _e2921.member_1;
                                            phi_6762_ = _e2926;
                                            phi_6763_ = _e2924;
                                            phi_6764_ = false;
                                        } else {
                                            phi_6761_ = f32();
                                            phi_6762_ = false;
                                            phi_6763_ = false;
                                            phi_6764_ = true;
                                        }
                                        let _e2928 = phi_6761_;
                                        let _e2930 = phi_6762_;
                                        let _e2932 = phi_6763_;
                                        let _e2934 = phi_6764_;
                                        phi_6765_ = _e2928;
                                        phi_6766_ = _e2930;
                                        phi_6767_ = _e2932;
                                        phi_6768_ = _e2934;
                                    }
                                    let _e2936 = phi_6765_;
                                    let _e2938 = phi_6766_;
                                    let _e2940 = phi_6767_;
                                    let _e2942 = phi_6768_;
                                    phi_6769_ = _e2936;
                                    phi_6770_ = _e1940;
                                    phi_6771_ = _e2938;
                                    phi_6772_ = _e2940;
                                    phi_6773_ = _e2942;
                                }
                                let _e2944 = phi_6769_;
                                let _e2946 = phi_6770_;
                                let _e2948 = phi_6771_;
                                let _e2950 = phi_6772_;
                                let _e2952 = phi_6773_;
                                if _e2946 {
                                    phi_6777_ = true;
                                    phi_6778_ = false;
                                    phi_6779_ = false;
                                } else {
                                    phi_6777_ = _e2948;
                                    phi_6778_ = _e2950;
                                    phi_6779_ = _e2952;
                                }
                                let _e2954 = phi_6777_;
                                let _e2956 = phi_6778_;
                                let _e2958 = phi_6779_;
                                phi_6780_ = _e2944;
                                phi_6781_ = _e1222;
                                phi_6782_ = _e2954;
                                phi_6783_ = false;
                                phi_6784_ = _e2956;
                                phi_6785_ = _e2958;
                            } else {
                                phi_6780_ = f32();
                                phi_6781_ = type_56();
                                phi_6782_ = false;
                                phi_6783_ = true;
                                phi_6784_ = false;
                                phi_6785_ = false;
                            }
                            let _e2960 = phi_6780_;
                            let _e2962 = phi_6781_;
                            let _e2964 = phi_6782_;
                            let _e2966 = phi_6783_;
                            let _e2968 = phi_6784_;
                            let _e2970 = phi_6785_;
                            local_30 = _e2966;
                            local_62 = _e2968;
                            local_63 = _e2970;
                            local_31 = _e2960;
                            local_32 = _e2962;
                            continue;
                            continuing {
                                phi_3829_ = _e907;
                                break if !(_e2964);
                            }
                        }
                        let _e2973 = local_30;
                        if _e2973 {
                            phi_6790_ = type_55(0u, type_55().member_1);
                            phi_6791_ = false;
                            phi_6792_ = false;
                        } else {
                            phi_6790_ = type_55();
                            let _e5301 = local_62;
                            phi_6791_ = _e5301;
                            let _e5304 = local_63;
                            phi_6792_ = _e5304;
                        }
                        let _e2978 = phi_6790_;
                        let _e2980 = phi_6791_;
                        let _e2982 = phi_6792_;
                        if _e2980 {
                            let _e2984 = local_31;
                            phi_6797_ = type_55(2u, _e2984);
                            phi_6798_ = false;
                        } else {
                            phi_6797_ = type_55();
                            phi_6798_ = _e2982;
                        }
                        let _e2987 = phi_6797_;
                        let _e2989 = phi_6798_;
                        if _e2989 {
                            let _e2991 = local_32;
                            phi_6804_ = type_55(1u, _e2991.member);
                            phi_6805_ = true;
                        } else {
                            phi_6804_ = _e2987;
                            phi_6805_ = _e2980;
                        }
                        let _e2995 = phi_6804_;
                        let _e2997 = phi_6805_;
                        if _e2997 {
                            phi_6809_ = _e2995;
                        } else {
                            phi_6809_ = _e2978;
                        }
                        let _e2999 = phi_6809_;
                        phi_6813_ = _e2999;
                    }
                    let _e4620 = phi_6813_;
                    phi_6814_ = _e4620;
                }
                let _e4625 = phi_6814_;
                switch bitcast<i32>(_e4625.member) {
                    case 0: {
                        phi_6875_ = type_58(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4655 = bitcast<u32>(_e4625.member_1);
                        if (_e4655 < 8388608u) {
                            phi_6842_ = array<u32, 2>();
                            phi_6843_ = true;
                        } else {
                            let _e4659 = ((_e4655 >> bitcast<u32>(31i)) == 1u);
                            if _e4659 {
                                phi_6841_ = array<u32, 2>();
                            } else {
                                phi_6841_ = array<u32, 2>((_e4655 << bitcast<u32>(29i)), ((((_e4655 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e4655 & 8388607u) >> bitcast<u32>(3i))));
                            }
                            let _e4673 = phi_6841_;
                            phi_6842_ = _e4673;
                            phi_6843_ = _e4659;
                        }
                        let _e4675 = phi_6842_;
                        let _e4677 = phi_6843_;
                        if _e4677 {
                            phi_6847_ = array<u32, 2>(0u, 0u);
                        } else {
                            phi_6847_ = _e4675;
                        }
                        let _e4679 = phi_6847_;
                        phi_6875_ = type_58(0u, _e4679, true);
                        break;
                    }
                    case 2: {
                        let _e4629 = bitcast<u32>(_e4625.member_1);
                        if (_e4629 < 8388608u) {
                            phi_6868_ = array<u32, 2>();
                            phi_6869_ = true;
                        } else {
                            let _e4633 = ((_e4629 >> bitcast<u32>(31i)) == 1u);
                            if _e4633 {
                                phi_6867_ = array<u32, 2>();
                            } else {
                                phi_6867_ = array<u32, 2>((_e4629 << bitcast<u32>(29i)), ((((_e4629 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e4629 & 8388607u) >> bitcast<u32>(3i))));
                            }
                            let _e4647 = phi_6867_;
                            phi_6868_ = _e4647;
                            phi_6869_ = _e4633;
                        }
                        let _e4649 = phi_6868_;
                        let _e4651 = phi_6869_;
                        if _e4651 {
                            phi_6873_ = array<u32, 2>(0u, 0u);
                        } else {
                            phi_6873_ = _e4649;
                        }
                        let _e4653 = phi_6873_;
                        phi_6875_ = type_58(1u, _e4653, true);
                        break;
                    }
                    default: {
                        phi_6875_ = type_58();
                        break;
                    }
                }
                let _e4682 = phi_6875_;
                if _e4682.member_2 {
                    phi_6882_ = (_e4682.member == 0u);
                } else {
                    phi_6882_ = false;
                }
                let _e4687 = phi_6882_;
                let _e4689 = (_e4682.member != 0u);
                let _e4691 = type_48(_e175, 0u, _e194, _e197, _e4682.member_1);
                if _e4687 {
                    let _e4695 = (_e4682.member_1[1] >> bitcast<u32>(20i));
                    if (_e4695 <= 896u) {
                        phi_6906_ = 0u;
                    } else {
                        phi_6906_ = ((((_e4695 - 896u) << bitcast<u32>(23i)) | ((_e4682.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4682.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4710 = phi_6906_;
                    let _e4712 = atomicMin((&earliest.member[0u]), _e4710);
                }
                let _e4714 = params.member.member_1;
                let _e4716 = ((_e4714 & 16u) != 0u);
                if _e4716 {
                    if (_e106 == 0u) {
                        atomicStore((&counters[0u]), 0u);
                    }
                    workgroupBarrier();
                    if _e4687 {
                        let _e4720 = atomicAdd((&counters[0u]), 1u);
                        phi_6927_ = _e4720;
                    } else {
                        phi_6927_ = 0u;
                    }
                    let _e4722 = phi_6927_;
                    workgroupBarrier();
                    if (_e106 == 0u) {
                        let _e4725 = atomicLoad((&counters[0u]));
                        if (_e4725 > 0u) {
                            let _e4728 = atomicAdd((&contacts.member[0u]), _e4725);
                            atomicStore((&counters[1u]), _e4728);
                        }
                    }
                    workgroupBarrier();
                    let _e4731 = atomicLoad((&counters[1u]));
                    let _e4732 = (_e4731 + _e4722);
                    if _e4687 {
                        let _e4734 = params.member.member_16;
                        if (_e4732 < _e4734) {
                            let _e4736 = (6u * _e4732);
                            atomicStore((&contacts.member[(4u + _e4736)]), _e175);
                            atomicStore((&contacts.member[(_e4736 + 5u)]), 0u);
                            atomicStore((&contacts.member[(_e4736 + 6u)]), _e194);
                            atomicStore((&contacts.member[(_e4736 + 7u)]), _e197);
                            atomicStore((&contacts.member[(_e4736 + 8u)]), _e4682.member_1[0]);
                            atomicStore((&contacts.member[(_e4736 + 9u)]), _e4682.member_1[1]);
                        }
                    }
                }
                phi_7008_ = _e4691;
                phi_7009_ = _e4689;
                phi_7010_ = _e4691;
                phi_7011_ = _e4689;
                phi_7012_ = _e4716;
            } else {
                let _e179 = params.member.member_1;
                let _e181 = ((_e179 & 16u) != 0u);
                if _e181 {
                    if (_e106 == 0u) {
                        atomicStore((&counters[0u]), 0u);
                    }
                    workgroupBarrier();
                    workgroupBarrier();
                    if (_e106 == 0u) {
                        let _e186 = atomicLoad((&counters[0u]));
                        if (_e186 > 0u) {
                            let _e189 = atomicAdd((&contacts.member[0u]), _e186);
                            atomicStore((&counters[1u]), _e189);
                        }
                    }
                    workgroupBarrier();
                }
                phi_7008_ = _e176;
                phi_7009_ = false;
                phi_7010_ = _e176;
                phi_7011_ = false;
                phi_7012_ = _e181;
            }
            let _e4752 = phi_7008_;
            let _e4754 = phi_7009_;
            let _e4756 = phi_7010_;
            let _e4758 = phi_7011_;
            let _e4760 = phi_7012_;
            if _e4760 {
                phi_7016_ = false;
            } else {
                phi_7016_ = true;
            }
            let _e4762 = phi_7016_;
            if _e4762 {
                phi_7020_ = _e4756;
                phi_7021_ = _e4758;
            } else {
                phi_7020_ = _e4752;
                phi_7021_ = _e4754;
            }
            let _e4764 = phi_7020_;
            let _e4766 = phi_7021_;
            workgroupBarrier();
            if (_e106 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4766 {
                let _e4770 = atomicAdd((&counters[0u]), 1u);
                phi_7032_ = _e4770;
            } else {
                phi_7032_ = 0u;
            }
            let _e4772 = phi_7032_;
            workgroupBarrier();
            if (_e106 == 0u) {
                let _e4775 = atomicLoad((&counters[0u]));
                if (_e4775 > 0u) {
                    let _e4778 = atomicAdd((&undecided.member[0u]), _e4775);
                    atomicStore((&counters[1u]), _e4778);
                }
            }
            workgroupBarrier();
            let _e4781 = atomicLoad((&counters[1u]));
            let _e4782 = (_e4781 + _e4772);
            if _e4766 {
                atomicStore((&undecided.member[(4u + (2u * _e4782))]), _e4764.member_2);
                atomicStore((&undecided.member[((2u * _e4782) + 5u)]), _e4764.member_3);
            }
        }
        continue;
        continuing {
            phi_242_ = _e163;
            break if !(_e169);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
